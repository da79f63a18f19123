"""The base of random cases, worked out apart from this repository's code, against `standfast assess`.

    pip install numpy==2.4.6 scipy==1.17.1
    python base.py [NUMBER [PROGRAM]]      # 300 cases; the program is `standfast` unless it is said

A base that crushes: every mode tried, its rotation found by scanning. Ground that fails: the formulas of EN 1997-1 Annex D, API RP 2GEO and
the envelope, the load factor by scanning. An elastic base: 4001 springs that bear no tension and yield, and two modes of vibration
followed by numerical integration. Each number is compared with the answer's; what differs is printed, and the exit code is 1.
"""

import itertools
import json
import math
import random
import subprocess
import sys

import numpy as np
from scipy.integrate import solve_ivp
from scipy.linalg import eigh
from scipy.optimize import brentq, minimize_scalar

GRAVITY = 9.81


class Case:
    """A body on a base, pushed, with another load up or down; forces in N/m, x to the right, moments counter-clockwise about C."""

    def __init__(self, seed):
        pick = random.Random(seed)
        self.width = pick.uniform(2, 20)
        self.height = self.width * pick.uniform(0.4, 2.5)
        self.mass = self.width * self.height * pick.uniform(1200, 2600)
        self.friction = pick.uniform(0.2, 0.9)
        self.left = pick.random() < 0.7
        weight = self.mass * GRAVITY
        self.push = weight * pick.uniform(0.05, 0.9)
        self.elevation = self.height * pick.uniform(0.05, 0.99)
        self.lift = weight * pick.uniform(-0.4, 0.4) if pick.random() < 0.6 else 0.0
        self.distance = self.width * pick.uniform(0.2, 0.8)
        self.kind = ("strength", "ec7", "hansen", "envelope", "elastic", "elastic and strength")[seed % 6]
        pressure = weight / self.width
        self.strength = pressure / pick.choice([pick.uniform(0.01, 0.5), pick.uniform(0.5, 1.2)])
        self.angle, self.unit_weight = pick.uniform(22, 48), pick.uniform(8e3, 2e4)
        self.surcharge = pick.choice([0.0, pick.uniform(0, 4e4)])
        self.centric = weight / pick.uniform(0.05, 0.9)
        self.stiffness = pressure / self.width * 10 ** pick.uniform(1.5, 4)
        self.tangential = self.stiffness * pick.uniform(0.2, 1)
        self.duration = 10 ** pick.uniform(-1.5, 0.5)
        self.rise = self.duration * pick.uniform(0.1, 0.9)
        if self.kind.startswith("elastic"):
            self.push *= 0.4
            self.strength = pressure / pick.uniform(0.02, 0.45)

    def toml(self):
        lines = [f"gravity = {GRAVITY}", "[body]", f"width = {self.width}", f"height = {self.height}", f"mass = {self.mass}"]
        lines += [f"friction = {self.friction}", "[ground]"]
        if "strength" in self.kind:
            lines.append(f"strength = {self.strength}")
        if self.kind in ("ec7", "hansen"):
            lines += [f'law = "{self.kind}"', f"friction_angle_deg = {self.angle}", f"unit_weight = {self.unit_weight}"]
            lines.append(f"surcharge = {self.surcharge}")
        if self.kind == "envelope":
            lines += ['law = "envelope"', f"centric_resistance = {self.centric}"]
        if self.kind.startswith("elastic"):
            lines += [f"stiffness = {self.stiffness}", f"tangential_stiffness = {self.tangential}"]
        lines += ["[[load]]", 'name = "push"', f"force = {self.push}", f"elevation = {self.elevation}"]
        lines.append(f'direction = "{"left" if self.left else "right"}"')
        if self.kind.startswith("elastic"):
            lines.append(f'history = {{ shape = "triangle", rise = {self.rise}, duration = {self.duration} }}')
        if self.lift:
            lines += ["[[load]]", 'name = "other"', f"force = {abs(self.lift)}", f"distance = {self.distance}"]
            lines.append(f'direction = "{"up" if self.lift > 0 else "down"}"')
            lines += ["[[combination]]", "factors = { push = 1, other = 1 }"]
        return "\n".join(lines) + "\n"

    def wrench(self, factor):
        """X, P and M about C; the weight does not grow."""
        d = self.height / 2
        x = factor * self.push * (-1 if self.left else 1)
        turn = -x * (self.elevation - d)
        lift = factor * self.lift
        return x, self.mass * GRAVITY - lift, turn + lift * (self.distance - self.width / 2)


def crushing(case, x, p, m):
    """All modes on a base that crushes, and ω."""
    b, d, q, mu = case.width / 2, case.height / 2, case.strength, case.friction
    if p >= 2 * b * q:
        return {"BF"}
    modes, room = set(), b * p - p * p / (2 * q)
    if abs(x) <= mu * p and abs(x * d - m) <= room:
        modes.add("RE")
    s = math.copysign(1, x)
    if abs(x) > mu * p and abs(s * mu * d * p - m) <= room:
        modes.add("SL" if s < 0 else "SL+")
    square = (case.width**2 + case.height**2) / 12
    reach = 10 * (abs(m) + abs(x) * d + mu * d * p + b * p) / (case.mass * square)
    grid = np.concatenate([[0], np.geomspace(1e-7, 1, 4000) * reach])
    for sigma, corner in ((1, "O"), (-1, "O'")):

        def pressed(a):
            return q * (p + case.mass * b * a) / (q + case.mass * a)

        def reaction(a):
            return pressed(a) * (b - pressed(a) / (2 * q))

        def roots(f):
            at = f(grid)
            places = np.nonzero((at[:-1] < 0) != (at[1:] < 0))[0]
            return [brentq(f, grid[i], grid[i + 1], xtol=1e-300, rtol=1e-14) for i in places]

        for a in roots(lambda a: case.mass * (square + d * d) * a + reaction(a) - sigma * (m - x * d)):
            if abs(x + case.mass * d * sigma * a) <= mu * pressed(a):
                modes.add("R" + corner)
        for s, sign in ((-1, "-"), (1, "+")):
            for a in roots(lambda a: case.mass * square * a + reaction(a) - sigma * (m - s * mu * d * pressed(a))):
                if s * ((x - s * mu * pressed(a)) / case.mass + d * sigma * a) > 0:
                    modes.add("SR" + corner + sign)
    return modes


def borne(case, x, p, m, angle):
    """R of the ground."""
    b = case.width / 2
    e = (x * case.height / 2 - m) / p
    width = 2 * (b - abs(e))
    eta = abs(x) / p
    if width <= 0:
        return 0.0
    if case.kind == "envelope":
        h, t = eta / 0.52, math.copysign(1, x * e) * abs(e) / b / (2 * 0.35)
        return case.centric * max(0.0, 1 - math.sqrt(max(0.0, h * h + t * t - 2 * 0.22 * h * t)))
    tan = math.tan(math.radians(angle))
    n_q = math.exp(math.pi * tan) * math.tan(math.radians(45 + angle / 2)) ** 2
    if case.kind == "ec7":
        i_q, i_g, n_g = max(0, 1 - eta) ** 2, max(0, 1 - eta) ** 3, 2 * (n_q - 1) * tan
    else:
        i_q, i_g, n_g = max(0, 1 - 0.5 * eta) ** 5, max(0, 1 - 0.7 * eta) ** 5, 1.5 * (n_q - 1) * tan
    return width * (case.surcharge * n_q * i_q + case.unit_weight * width / 2 * n_g * i_g)


def first(f, most=40.0):
    """The least λ > 0 at which f falls below zero."""
    grid = np.concatenate([np.linspace(0, 4, 8001), np.geomspace(4.001, most, 4000)])
    if f(0.0) < 0:
        return 0.0
    for low, high in itertools.pairwise(grid):
        if f(high) < 0:
            return brentq(f, low, high, xtol=1e-14)
    return math.inf


class Springs:
    """Springs under a rigid base, without tension, that yield at a pressure."""

    def __init__(self, case, p):
        self.p, self.k = p, case.stiffness
        self.most = case.strength if "strength" in case.kind else math.inf
        self.x = (np.arange(4001) - 2000) / 4001 * case.width
        self.each = case.width / 4001

    def moment(self, rotation):
        def pressure(sunk):
            return np.clip(self.k * (sunk + rotation * self.x), 0, self.most)

        far = self.x[-1] * rotation + 10 * self.p / (self.k * self.each * 4001)
        far += self.most / self.k if math.isfinite(self.most) else 0
        sunk = brentq(lambda s: pressure(s).sum() * self.each - self.p, -far, far, xtol=1e-16, rtol=1e-14)
        return float((pressure(sunk) * self.x).sum() * self.each)


def elastic(case):
    """Rotation, largest moment over that of the full load, periods, amplifications, events."""
    x, p, m = case.wrench(1)
    b, d = case.width / 2, case.height / 2
    full = abs(x * d - m)
    springs = Springs(case, p)
    stiff = case.stiffness * case.width**3 / 12
    scale = p * b / stiff
    found = {}
    far = scale * 1e3
    found["rotation"] = brentq(lambda r: springs.moment(r) - full, 0, far, rtol=1e-12) if springs.moment(far) > full else None
    lost = [(springs.moment(r) - p * d * r, r) for r in np.geomspace(1e-3, 1e3, 400) * scale]
    best = max(lost)[1]
    top = minimize_scalar(lambda r: p * d * r - springs.moment(r), bounds=(best / 1.05, best * 1.05), method="bounded", options={"xatol": 1e-9 * best})
    found["k_overturn"] = max(0.0, -top.fun) / full * abs(x) / p
    inertia = case.mass * (case.width**2 + case.height**2) / 12
    mass = np.array([[case.mass, -case.mass * d], [-case.mass * d, inertia + case.mass * d * d]])
    k = np.diag([case.width * case.tangential, stiff])
    found["periods"] = sorted((2 * math.pi / np.sqrt(eigh(k, mass, eigvals_only=True))).tolist(), reverse=True)

    # The push in time; all else stands there.
    turn = -x * (case.elevation - d) - x * d
    still = m - x * d - turn
    inverse = np.linalg.inv(mass)

    def course(t):
        share = t / case.rise if t < case.rise else max(0.0, (case.duration - t) / (case.duration - case.rise))
        return share * np.array([x, turn])

    end = case.duration + 2 * found["periods"][0]
    times, shear, moment, state = [], [], [], np.zeros(4)
    for low, high in ((0, case.rise), (case.rise, case.duration), (case.duration, end)):
        count = 200 + int(3000 * (high - low) / min(found["periods"][1], end))
        grid = np.linspace(low, high, count)
        run = solve_ivp(lambda t, y: np.concatenate([y[2:], inverse @ (course(t) - k @ y[:2])]), (low, high), state, "DOP853", grid, rtol=1e-11, atol=1e-14)
        state = run.y[:, -1]
        times.append(run.t)
        shear.append(k[0, 0] * run.y[0])
        moment.append(k[1, 1] * run.y[1])
    times, shear, moment = map(np.concatenate, (times, shear, moment))
    found["D_shear"], found["D_moment"] = np.abs(shear).max() / abs(x), np.abs(moment).max() / abs(turn)
    # N of the loads that stand.
    events = {"slip": case.friction * p - np.abs(shear), "lift": p * b / 3 - np.abs(moment + still)}
    if "strength" in case.kind:
        events["yield"] = case.strength - p / case.width - 1.5 * np.abs(moment + still) / (2 * b * b)
    first_at = {}
    for name, left in events.items():
        under = np.nonzero(left <= 0)[0]
        if len(under):
            i = under[0]
            share = left[i - 1] / (left[i - 1] - left[i]) if i else 0
            first_at[name] = times[i - 1] + share * (times[i] - times[i - 1]) if i else 0.0
    found["first_event"] = min(first_at, key=first_at.get) if first_at else None
    found["first_event_time"] = min(first_at.values()) if first_at else None
    return found


def compare(case, answer):
    """What differs: (name, expected, found)."""
    situation = answer["situations"][0]
    ground = situation["ground"]
    x, p, m = case.wrench(1)
    wrong, checked = [], 0

    def same(name, expected, found, tolerance):
        nonlocal checked
        checked += 1
        if isinstance(expected, float) and isinstance(found, (int, float)):
            if abs(found - expected) > tolerance * max(abs(expected), 1e-12):
                wrong.append((name, expected, found))
        elif expected != found and not (expected == math.inf and found == "infinite"):
            wrong.append((name, expected, found))

    said = {situation["mode"], *situation["also"]}
    b, d = case.width / 2, case.height / 2
    if case.kind == "strength":
        same("modes", crushing(case, x, p, m), said, 0)
        same("omega", p / (2 * b * case.strength), ground["omega"], 1e-12)

        def room(factor):
            x, p, m = case.wrench(factor)
            return b * p - p * p / (2 * case.strength) - abs(x * d - m)

        same("load_factor_ground", first(room), ground["load_factor_ground"], 1e-9)
    elif not case.kind.startswith("elastic"):
        holds = abs(x) <= case.friction * p
        pushed = x if holds else math.copysign(case.friction * p, x)
        rests = "RE" if holds else "SL" if x < 0 else "SL+"
        same("modes", {rests if borne(case, pushed, p, m, case.angle) >= p else "BF"}, said, 0)
        same("resistance", borne(case, x, p, m, case.angle), ground["resistance"], 1e-9)
        same("factor", borne(case, x, p, m, case.angle) / p, ground["factor"], 1e-9)

        def factor(angle):
            def excess(factor):
                x, p, m = case.wrench(factor)
                return borne(case, x, p, m, angle) / p - 1 if p > 0 else 1.0

            return first(excess)

        same("load_factor_ground", factor(case.angle), ground["load_factor_ground"], 1e-8)
        if case.kind != "envelope":
            same("load_factor_ground_less", factor(case.angle - 2), ground["load_factor_ground_less"], 1e-8)
            same("load_factor_ground_more", factor(case.angle + 2), ground["load_factor_ground_more"], 1e-8)

        def ray(k):
            return borne(case, k * p * math.copysign(1, x), p, m / x * k * p * math.copysign(1, x), case.angle) / p - 1

        same("k_BF", first(ray), ground["k_BF"], 1e-8)
    else:
        expected = elastic(case)
        same("rotation", expected["rotation"], ground["rotation"], 2e-5)
        same("k_overturn", expected["k_overturn"], ground["k_overturn"], 2e-5)
        for one, other in zip(expected["periods"], ground["periods"], strict=True):
            same("period", one, other, 1e-9)
        for name in ("D_shear", "D_moment"):
            same(name, float(expected[name]), ground[name], 1e-5)
        same("first_event", expected["first_event"], ground["first_event"], 0)
        same("first_event_time", expected["first_event_time"] and float(expected["first_event_time"]), ground["first_event_time"], 1e-4)
    return wrong, checked


def main():
    number = int(sys.argv[1]) if len(sys.argv) > 1 else 300
    program = sys.argv[2] if len(sys.argv) > 2 else "standfast"
    failed, checked = 0, 0
    for seed in range(number):
        case = Case(seed)
        command = [program, "assess", "-", "--no-figures", "--format", "json"]
        run = subprocess.run(command, input=case.toml(), capture_output=True, text=True, check=False)
        if run.returncode:
            print(seed, case.kind, run.stderr)
            failed += 1
            continue
        wrong, count = compare(case, json.loads(run.stdout))
        checked += count
        for name, expected, found in wrong:
            print(f"{seed} ({case.kind}): {name} {found}, expected {expected}")
        failed += bool(wrong)
    print(f"{number} cases, {checked} numbers, {failed} cases differ")
    return failed > 0


if __name__ == "__main__":
    sys.exit(main())
