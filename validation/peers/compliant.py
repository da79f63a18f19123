"""Which mode emerges where several are consistent, if the corners are springs and dampers?

A block with two compliant corners is loaded at points of the set N of docs/theory/report.md, above and below the line DC. The
normal law of a corner is a spring and a damper that cannot pull. The tangential law is a bristle (a spring and a damper, whose
stretch is cut where Coulomb's friction is reached) or regularised Coulomb friction (a slope over a small velocity, then constant).
The force comes at once or rises in a line. Units: half width B, mass m, gravity g.

    python compliant.py             # the counts of docs/theory/report.md, ten minutes; needs numpy
    python compliant.py --points 8  # fewer points
"""

import argparse
from collections import Counter

import numpy as np

STEPS = {"bristle": 200, "viscous": 800}  # a contact period; the slope of the regularised friction is stiff
MODES = ["RO", "SRO-", "SL", "SRO'-", "other"]


def inside_n(number, below, seed):
    """Points (gamma, q, k, mu) inside N, on one side of the line DC; k' = -q."""
    rng = np.random.default_rng(seed)
    points = []
    while len(points) < number:
        gamma = 2.0 ** rng.uniform(-1, 2)
        q = rng.uniform(0.1, 0.9)
        k_a = 1 / (gamma * (1 - q))
        k_b = (1 + gamma**2) / (3 * gamma * q)
        k = max(k_a, k_b) * rng.uniform(1.05, 4)
        a, b = 4 + gamma**2 + 3 * gamma**2 * q, 3 * gamma
        c, d = 3 * gamma * (1 - q), 1 + 4 * gamma**2
        rock, ab, dc = (a * k + b) / (c * k + d), 1 / gamma + k * q, -1 / gamma + k * q
        low, high = (rock, min(ab, dc)) if below else (max(rock, dc), ab)
        if high - low > 0.02 * high:
            points.append((gamma, q, k, low + rng.uniform(0.1, 0.9) * (high - low)))
    return np.array(points).T


def emerging(points, stiffness, damping, ramp, law):
    """The mode of each point, seen from 30 to 60 contact periods after the force has all come."""
    gamma, q, k, mu = points
    inertia = (1 + gamma**2) / 3
    # A corner bears half of the weight: the contact period is that of the body that moves up and down on both.
    omega = np.sqrt(2 * stiffness)
    period = 2 * np.pi / omega
    step = period / STEPS[law]
    damper = damping * omega
    speed = 1e-4  # of the regularised friction
    r = np.array([[-1.0], [1.0]])  # corners O and O'
    x = np.zeros_like(k)
    y = x - 0.5 / stiffness
    theta, vx, vy, spin = (np.zeros_like(k) for _ in range(4))
    stretch = np.zeros((2, k.size))
    begin, end = ramp + 30 * period, ramp + 60 * period
    pressed, slip = np.zeros((2, k.size)), np.zeros((2, k.size))
    for number in range(int(np.ceil(end / step))):
        time = (number + 1) * step
        force = k * (1.0 if ramp == 0 else min(1.0, time / ramp))
        cos, sin = np.cos(theta), np.sin(theta)
        arm_x, arm_y = r * cos + gamma * sin, r * sin - gamma * cos
        depth = -(y + gamma + arm_y)
        u_x, u_y = vx - spin * arm_y, vy + spin * arm_x
        normal = np.where(depth > 0, np.maximum(0, stiffness * depth - damper * u_y), 0)
        limit = mu * normal
        if law == "bristle":
            stretch = np.where(normal > 0, stretch + u_x * step, 0)
            trial = -stiffness * stretch - damper * u_x
            tangential = np.clip(trial, -limit, limit)
            stretch = np.where(trial == tangential, stretch, -(tangential + damper * u_x) / stiffness)
        else:
            tangential = -limit * np.clip(u_x / speed, -1, 1)
        moment = (arm_x * normal - arm_y * tangential).sum(0)
        vx = vx + step * (tangential.sum(0) - force)
        vy = vy + step * (normal.sum(0) - 1)
        # The force acts at k' H above the centre, a point of the body.
        spin = spin + step * (moment - force * q * gamma * cos) / inertia
        x, y, theta = x + step * vx, y + step * vy, theta + step * spin
        if time >= begin:
            pressed += normal * step
            slip += u_x * step
    share = pressed[0] / np.maximum(pressed.sum(0), 1e-300)
    mean_slip = slip / (end - begin)
    # What counts as stuck: a thousandth of the velocity that the force alone would give, and what the regularised friction creeps.
    creep = np.maximum(10 * speed if law == "viscous" else 0, 1e-3 * k * 45 * period)
    modes = []
    for i in range(k.size):
        borne = pressed[:, i].sum() / (end - begin)
        if borne < 0.05:
            modes.append("other")
        elif share[i] > 0.98:
            modes.append("RO" if abs(mean_slip[0, i]) < creep[i] else "SRO-" if mean_slip[0, i] < 0 else "other")
        elif share[i] < 0.02:
            modes.append("SRO'-" if mean_slip[1, i] < -creep[i] else "other")
        else:
            modes.append("SL" if mean_slip[:, i].max() < -creep[i] else "other")
    return modes


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--points", type=int, default=40, help="on each side of DC")
    given = parser.parse_args()
    sets = {"above DC": inside_n(given.points, False, 1), "below DC": inside_n(given.points, True, 2)}
    for name, points in sets.items():
        (gamma, q, k, mu) = (f"{values.min():.2f} to {values.max():.2f}" for values in points)
        print(f"{name}: {given.points} points, gamma {gamma}, -k' {q}, k {k}, mu {mu}")
    head = f"{'law':8} {'stiffness':>9} {'damping':>7} {'ramp':>12}  {'points':8}" + "".join(f"{mode:>7}" for mode in MODES)
    print("stiffness of a corner in m g/B, damping ratio of the body on both, ramp in contact periods T or in sqrt(B/g)")
    print(head)
    sums = {}
    for law in ["bristle", "viscous"]:
        for stiffness in [1e7, 1e9]:
            period = 2 * np.pi / np.sqrt(2 * stiffness)
            ramps = [("0", 0.0), ("1 T", period), ("10 T", 10 * period), ("100 T", 100 * period)]
            if law == "bristle" and stiffness == 1e7:  # a ramp as long as the motion itself
                ramps.append(("1 sqrt(B/g)", 1.0))
            for damping in [0.02, 0.1, 0.5, 1.5]:
                for label, ramp in ramps:
                    for name, points in sets.items():
                        seen = Counter(emerging(points, stiffness, damping, ramp, law))
                        counts = "".join(f"{seen[mode]:7}" for mode in MODES)
                        print(f"{law:8} {stiffness:9.0e} {damping:7} {label:>12}  {name:8}{counts}", flush=True)
                        sums.setdefault((law, label, name), Counter()).update(seen)
    print("sums over stiffness and damping")
    for (law, label, name), seen in sums.items():
        print(f"{law:8} {'':9} {'':7} {label:>12}  {name:8}" + "".join(f"{seen[mode]:7}" for mode in MODES))


if __name__ == "__main__":
    main()
