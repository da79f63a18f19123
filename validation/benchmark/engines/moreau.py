"""An engine in a hundred lines, of the standard library alone: Moreau's and Jean's time stepping of the block on two corners.

It shows what an adapter has to do, and that a plain time stepper can meet the benchmark. It shares nothing with standfast.
The impulses of a step are found by trying what each corner may do, in the order stick, slip, open.
"""

import math

import common


class Moreau:
    def __init__(self, dt=1e-3):
        self.dt = dt

    def place(self, gamma, mu, gravity, inertia, x, y, theta, vx, vy, omega):
        self.gamma, self.mu, self.g, self.inertia = gamma, mu, gravity, inertia
        self.q, self.v, self.load = [x, y, theta], [vx, vy, omega], (0.0, 0.0, 0.0)

    def push(self, fx, fy, torque):
        self.load = fx, fy, torque

    def state(self):
        return (*self.q, *self.v)

    def arms(self, theta):
        cos, sin = math.cos(theta), math.sin(theta)
        return [(cos * side + sin * self.gamma, sin * side - cos * self.gamma) for side in (-1.0, 1.0)]

    def step(self):
        dt = self.dt
        middle = [q + dt / 2 * v for q, v in zip(self.q, self.v)]
        fx, fy, torque = self.load
        self.load = 0.0, 0.0, 0.0
        free = [self.v[0] + dt * fx, self.v[1] + dt * (fy - self.g), self.v[2] + dt * torque / self.inertia]
        arms = self.arms(middle[2])
        closed = [arm for arm in arms if middle[1] + arm[1] <= 1e-9]
        self.v = self.impulses(free, closed) if closed else free
        self.q = [q + dt / 2 * v for q, v in zip(middle, self.v)]

    def impulses(self, free, arms):
        """Velocities after impulses at the corners, with m = 1."""
        if len(arms) == 2:
            for slip in (0, -1, 1):
                found = self.both(free, arms, slip)
                if found:
                    return found
        options = []
        for arm in arms:
            other = [a for a in arms if a is not arm]
            for slip in (0, -1, 1):
                found = self.one(free, arm, slip)
                if found and all(found[1] + a[0] * found[2] >= -1e-12 for a in other):
                    options.append(found)
        if options:
            return options[0]
        if all(free[1] + a[0] * free[2] >= -1e-12 for a in arms):
            return free
        return self.gripped(free, arms)

    def both(self, free, arms, slip):
        """Both corners stay on the floor: the body does not turn but for the pose's own error."""
        (lx, ly), (rx, ry) = arms
        # Normal velocities of both are zero: vy + rx ω = 0 at both, so ω = 0 and vy = 0.
        normal = -free[1]
        h = -(ly + ry) / 2
        vx, along = (0.0, -free[0]) if slip == 0 else (free[0] - slip * self.mu * normal, -slip * self.mu * normal)
        moment = -self.inertia * free[2] - h * along  # of the normal impulses about the centre of mass
        right = (moment - lx * normal) / (rx - lx)
        left = normal - right
        if left < 0 or right < 0 or (slip == 0 and abs(along) > self.mu * normal) or slip * vx < 0:
            return None
        return [vx, 0.0, 0.0]

    def one(self, free, arm, slip):
        rx, ry = arm
        i = self.inertia
        ux, uy = free[0] - ry * free[2], free[1] + rx * free[2]
        gtt, gnt, gnn = 1 + ry * ry / i, -rx * ry / i, 1 + rx * rx / i
        if slip == 0:
            det = gtt * gnn - gnt * gnt
            t, n = (-ux * gnn + uy * gnt) / det, (-uy * gtt + ux * gnt) / det
            if abs(t) > self.mu * n:
                return None
        else:
            bottom = gnn - slip * self.mu * gnt
            if bottom == 0:
                return None
            n = -uy / bottom
            t = -slip * self.mu * n
            if slip * (ux + gtt * t + gnt * n) < 0:
                return None
        if n < 0:
            return None
        return [free[0] + t, free[1] + n, free[2] + (rx * n - ry * t) / i]

    def gripped(self, free, arms):
        """Both corners have impulses, and one slips while the other does not: both have one velocity along the floor, so only rounding comes here."""
        return [0.0, 0.0, 0.0]


WINDOW = dict(settle=3, start=2, steps=12)
some = lambda pick: (dict(dt=pick([1e-3, 1e-4, 1e-5])), WINDOW)

if __name__ == "__main__":
    common.main("moreau", Moreau, {"1ms": (dict(dt=1e-3), WINDOW), "0.1ms": (dict(dt=1e-4), WINDOW)}, {"1ms": dict(dt=1e-3), "0.1ms": dict(dt=1e-4)}, some,
                [dict(dt=1e-3), dict(dt=2e-4)])
