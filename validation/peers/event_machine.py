"""The motion of a block from event to event by general integrators and root finders of scipy: the second program of motion_events.py.

It follows a block as docs/theory/motion.md describes, with an eighth-order Runge-Kutta method (DOP853, 3e-14) whose dense output is searched
for the conditions of the present state. Flight is followed as what loads add to a uniform motion, so that a bounce keeps its digits however
small it is.

What it leaves out: it tells what an equality turns into by following each candidate for a moment, not by derivatives; it gives up after
`MOST` events; it does not follow a corner whose inertia in slip vanishes.
"""

from __future__ import annotations

import math
from typing import Any, Callable

import numpy as np
from scipy.integrate import DOP853
from scipy.optimize import brentq, minimize_scalar

LEFT, RIGHT = 0, 1  # the corners O and O'
BOTH = {LEFT, RIGHT}
FINE = [1e-20, 1e-20, 1e-20, 1e-17, 1e-17, 1e-17]
MOST = 30000

REST: tuple = ("RE",)
FLIGHT: tuple = ("FL",)
#: A state: its kind, the corner if one only touches, the direction of slip if there is any.
STATES = [REST, ("SL", 1), ("SL", -1), *(("RO", k) for k in (LEFT, RIGHT)), *(("SRO", k, s) for k in (LEFT, RIGHT) for s in (1, -1)), FLIGHT]


class NoState(Exception):
    """No state satisfies all conditions."""


def symbol(state: tuple) -> str:
    kind, corner = state[0], state[1] if state[0] in ("RO", "SRO") else LEFT
    sign = "" if kind not in ("SL", "SRO") else ("-" if state[-1] < 0 else "+")
    return kind + "'" * corner + (sign if (kind, sign) != ("SL", "-") else "")


# Histories: pieces (from, to, function), zero elsewhere.
Piece = tuple[float, float, Callable[[float], float]]


def line(t0: float, v0: float, t1: float, v1: float) -> Piece:
    return t0, t1, lambda t: v0 + (v1 - v0) * (t - t0) / (t1 - t0)


def pieces(h: dict[str, Any]) -> list[Piece]:
    shape, start, peak = h["shape"], h.get("start", 0.0), h.get("peak", 1.0)
    if shape == "points":
        ends = list(zip(h["times"], h["values"]))
        return [line(start + a, peak * u, start + b, peak * v) for (a, u), (b, v) in zip(ends, ends[1:])]
    last = start + h["duration"]
    if shape == "rect":
        return [(start, last, lambda t: peak)]
    if shape == "triangle":
        top = start + h["rise"]
        return [line(start, 0, top, peak), line(top, peak, last, 0)]
    if shape == "decay":
        return [line(start, peak, last, 0)]
    if shape == "half-sine":
        return [(start, last, lambda t: peak * math.sin(math.pi * (t - start) / h["duration"]))]
    if shape == "sine":
        return [(start, last, lambda t: peak * math.sin(2 * math.pi / h["period"] * (t - start) + h["phase"]))]
    assert shape == "church-roof", shape
    rise, impact, tail = h["rise"], h["impact_duration"], h["tail"]
    up, down = start + rise * tail / peak, start + impact - (impact - rise) * tail / peak
    return [line(start, tail, up, tail), line(up, tail, start + rise, peak), line(start + rise, peak, down, tail), line(down, tail, last, tail)]


class Motion:
    """The motion of a case, a dict with the keys of a `[block]`; `run` follows it."""

    def __init__(self, case: dict[str, Any]) -> None:
        self.b, self.d, self.g = (case["b1"], case["b2"]), case["d"], case["gravity"]
        self.rho2, self.mx, self.my = case.get("rho2", (1 + self.d**2) / 3), case.get("m_x", 1.0), case.get("m_y", 1.0)
        self.mu_s = case["mu_s"]
        self.mu_k = case.get("mu_k", self.mu_s)
        self.mu_i = case.get("mu_impact", self.mu_k)
        self.law, self.ratio, self.e = case["law"], case.get("ratio", 1.0), case.get("e", 0.0)
        self.loads = [(load["at"], load["direction"], load["follows"], pieces(load["history"])) for load in case["loads"]]
        self.base = [pieces(case[key]) if key in case else [] for key in ("base_h", "base_v")]
        self.size = max(self.b)
        self.unit = math.sqrt(self.size / self.g)
        every = [piece for load in self.loads for piece in load[3]] + self.base[0] + self.base[1]
        self.breaks = sorted({0.0, *(t for piece in every for t in piece[:2])})
        self.end, self.t_max, self.t = self.breaks[-1], case["t_max"], 0.0
        first = case.get("initial", {})
        theta, omega = first.get("theta", 0.0), first.get("omega", 0.0)
        low = LEFT if theta > 0 or (theta == 0 and omega > 0) else RIGHT
        c, h = self.lever(low, theta)
        self.q = [0.0, h + first.get("gap", 0.0), theta, first.get("vx", -h * omega), first.get("vy", -c * omega), omega]
        # The slide of a corner is counted from where it was; beside one that touches, from where it would lie flat.
        middle = c - self.arm(low)
        flat = first.get("gap", 0.0) == 0
        self.feet = [middle + self.arm(k) if flat else self.lever(k, theta)[0] for k in (LEFT, RIGHT)]
        self.state: tuple = REST
        self.gaps, self.lifted = {k: self.gap(k, self.q) for k in BOTH}, set()
        self.max_slide, self.slides, self.bounces, self.doubts = 0.0, [0.0, 0.0], 0, 0
        self.events: list[tuple[float, str, str]] = []
        self.max_theta, self.overturned = abs(theta), False

    # Geometry and loads.

    def arm(self, k: int) -> float:
        return -self.b[0] if k == LEFT else self.b[1]

    def lever(self, k: int, theta: float) -> tuple[float, float]:
        r, cos, sin = self.arm(k), math.cos(theta), math.sin(theta)
        return r * cos + self.d * sin, self.d * cos - r * sin

    def gap(self, k: int, q: list[float]) -> float:
        return q[1] - self.lever(k, q[2])[1]

    def along(self, k: int, q: list[float]) -> float:
        return q[3] + self.lever(k, q[2])[1] * q[5]

    def up(self, k: int, q: list[float]) -> float:
        return q[4] + self.lever(k, q[2])[0] * q[5]

    def value(self, history: list[Piece], t: float) -> float:
        """Of the piece that holds between the breaks about now, also a little outside of it."""
        return next((f(t) for t0, t1, f in history if t0 <= self.middle < t1), 0.0)

    def wrench(self, t: float, theta: float) -> tuple[float, float, float]:
        cos, sin = math.cos(theta), math.sin(theta)
        turned = lambda v: (cos * v[0] - sin * v[1], sin * v[0] + cos * v[1])
        x, p, m = -self.value(self.base[0], t), self.g + self.value(self.base[1], t), 0.0
        for at, direction, follows, history in self.loads:
            f, (rx, ry), (ux, uy) = self.value(history, t), turned(at), turned(direction) if follows else direction
            x, p, m = x + f * ux, p - f * uy, m + f * (rx * uy - ry * ux)
        return x, p, m

    # Laws of motion and conditions.

    def inertia(self, state: tuple, theta: float) -> float:
        c, h = self.lever(state[1], theta)
        return self.rho2 + self.my * c * (c - state[2] * self.mu_k * h)

    def law_of(self, state: tuple, t: float, q: list[float]) -> tuple[float, ...]:
        """ẍ, ÿ, θ̈, N, T."""
        x, p, m = self.wrench(t, q[2])
        if state == REST:
            return 0, 0, 0, p, -x
        if state == FLIGHT:
            return x / self.mx, -p / self.my, m / self.rho2, 0, 0
        if state[0] == "SL":
            friction = -state[1] * self.mu_k * p
            return (x + friction) / self.mx, 0, 0, p, friction
        c, h = self.lever(state[1], q[2])
        xx, pp = x - self.mx * c * q[5] ** 2, p - self.my * h * q[5] ** 2
        if state[0] == "RO":
            alpha = (pp * c - xx * h + m) / (self.rho2 + self.mx * h * h + self.my * c * c)
            normal, friction = pp - self.my * c * alpha, -xx - self.mx * h * alpha
        else:
            alpha = (pp * (c - state[2] * self.mu_k * h) + m) / self.inertia(state, q[2])
            normal = pp - self.my * c * alpha
            friction = -state[2] * self.mu_k * normal
        return (x + friction) / self.mx, (normal - p) / self.my, alpha, normal, friction

    def conditions(self, state: tuple, t: float, q: list[float]) -> dict[str, float]:
        """What stays above zero while a state goes on, by what its end is called."""
        quarter = {"overturned": math.pi / 2 - abs(q[2])}
        if state == FLIGHT:
            return {"gap O": self.gap(LEFT, q), "gap O'": self.gap(RIGHT, q), **quarter}
        x, p, m = self.wrench(t, q[2])
        if state == REST or state[0] == "SL":
            shear = x if state == REST else state[1] * self.mu_k * p
            stand = {"tip O": self.b[0] * p + shear * self.d - m, "tip O'": self.b[1] * p - shear * self.d + m, "unload": p}
            return {"cone": self.mu_s * p - x, "cone -": self.mu_s * p + x, **stand} if state == REST else {"stop": state[1] * q[3], **stand}
        _, _, _, normal, friction = self.law_of(state, t, q)
        about = {"impact": (1 if state[1] == LEFT else -1) * q[2], "unload": normal, **quarter}
        if state[0] == "RO":
            return {"cone": self.mu_s * normal - friction, "cone -": self.mu_s * normal + friction, **about}
        return {"stop": state[2] * self.along(state[1], q), "grip": self.inertia(state, q[2]), **about}

    def followed(self, state: tuple, t: float, q: list[float], to: float) -> list[float]:
        if to <= t or state == REST:
            return list(q)
        solver = DOP853(self.slope(state), t, np.array(q, float), to, rtol=3e-14, atol=1e-16, first_step=min(to - t, 1e-2 * self.unit))
        while solver.status == "running":
            solver.step()
        return list(solver.y)

    def slope(self, state: tuple) -> Callable[[float, Any], list[float]]:
        return lambda t, q: [*q[3:6], *self.law_of(state, t, q)[:3]]

    # Decisions.

    def holds(self, state: tuple, closed: set[int], slip: int | None) -> bool:
        """Whether a state satisfies its conditions just after now."""

        def later(now: Callable[[], float], then: Callable[[float, list[float]], float]) -> float:
            """What is now, if that is not zero; else what becomes of it as the state is followed."""
            value = now()
            if abs(value) > 1e-9 * self.g:
                return value
            for step in (1e-3, 3e-3):
                to = min(self.t + step * self.unit, self.t + 0.5 * (self.next_break - self.t))
                value = then(to, self.followed(state, self.t, self.q, to))
                if abs(value) > 1e-13 * self.g:
                    return value
            return 0.0

        def stays(*names: str) -> bool:
            of = lambda name, t, q: self.conditions(state, t, q)[name]
            return all(later(lambda n=n: of(n, self.t, self.q), lambda t, q, n=n: of(n, t, q)) >= 0 for n in names)

        ax, ay, alpha, _, _ = self.law_of(state, self.t, self.q)
        omega = self.q[5]
        if state == REST:
            return slip is None and closed == BOTH and stays("cone", "cone -", "tip O", "tip O'", "unload")
        if state == FLIGHT:
            lifts = lambda k: ay + self.lever(k, self.q[2])[0] * alpha + self.lever(k, self.q[2])[1] * omega**2
            return all(later(lambda k=k: lifts(k), lambda t, q, k=k: self.gap(k, q)) >= 0 for k in closed)
        if slip not in (None, state[-1] if state[0] != "RO" else None):
            return False
        if state[0] == "SL":
            begins = slip is not None or later(lambda: state[1] * ax, lambda t, q: state[1] * q[3]) > 0
            return closed == BOTH and begins and stays("tip O", "tip O'", "unload")
        k, side = state[1], 1 if state[1] == LEFT else -1
        if k not in closed or (closed == BOTH and later(lambda: side * alpha, lambda t, q: side * q[2]) <= 0) or not stays("unload"):
            return False
        if state[0] == "RO":
            return stays("cone", "cone -")
        c, h = self.lever(k, self.q[2])
        return slip is not None or later(lambda: state[2] * (ax + h * alpha - c * omega**2), lambda t, q: state[2] * self.along(k, q)) > 0

    def decided(self, closed: set[int], slip: int | None, failed: tuple | None) -> tuple | None:
        found = [state for state in STATES if state != failed and self.holds(state, closed, slip)]
        if slip is None and self.mu_s > self.mu_k:
            # Slip counts only where the corner cannot stick.
            stick = set(found)
            sticks = lambda state: REST in stick or ("RO", state[1]) in stick
            found = [state for state in found if state[0] != "SRO" or not sticks(state)]
            if stick & {REST, ("RO", LEFT), ("RO", RIGHT)}:
                found = [state for state in found if state[0] != "SL"]
        regular = lambda state: self.inertia(state, self.q[2]) > 0
        rank = {"RE": 0, "SL": 1, "RO": 3, "FL": 5}
        return min(found, key=lambda state: rank.get(state[0], 2 if state[0] == "SRO" and regular(state) else 4), default=None)

    def contact(self) -> tuple[set[int], int | None]:
        if self.state == FLIGHT:
            return set(), None
        closed = BOTH if self.state[0] in ("RE", "SL") else {self.state[1]}
        return closed, self.state[-1] if self.state[0] in ("SL", "SRO") else None

    def take(self, state: tuple, why: str) -> None:
        self.state = state
        if state[0] in ("RE", "SL"):
            self.q = [self.q[0], self.d, 0.0, self.q[3] if state != REST else 0.0, 0.0, 0.0]
        self.seen()
        self.bounces += state == FLIGHT and why == "impact"
        self.events.append((float(self.t), why, symbol(state)))

    def seen(self) -> None:
        """Notes the largest angle and slide."""
        self.max_theta, self.max_slide = max(self.max_theta, abs(self.q[2])), max(self.max_slide, abs(self.slide()))
        self.slides = [max(self.slides[k], abs(self.slide_of(k))) if k in self.touched() else self.slides[k] for k in (LEFT, RIGHT)]

    def go_on(self, why: str, closed: set[int], slip: int | None, failed: tuple | None = None) -> None:
        state = self.decided(closed, slip, failed)
        if state is not None:
            if state == FLIGHT and self.state != FLIGHT and why != "impact":
                self.gaps = {k: max(self.gap(k, self.q), 0.0) for k in BOTH}
            self.gaps, self.lifted = self.gaps | dict.fromkeys(closed, 0.0), set(closed)
            self.take(state, why)
            return
        for k in sorted(closed) if slip is not None else []:
            after = self.stuck(k, self.q)
            normal, friction = self.my * (after[4] - self.q[4]), self.mx * (after[3] - self.q[3])
            leaves = closed != BOTH or (1 if k == LEFT else -1) * after[5] > 0
            if leaves and normal > 0 and abs(friction) <= self.mu_k * normal * (1 + 1e-6):
                self.q = after
                state = self.decided({k}, None, None)
                if state is not None:
                    if why in ("start", "impact"):
                        self.take(state, why)
                    self.take(state, "grip")
                    return
        raise NoState

    # Impacts.

    def kinetic(self, q: list[float]) -> float:
        return 0.5 * (self.mx * q[3] ** 2 + self.my * q[4] ** 2 + self.rho2 * q[5] ** 2)

    def stuck(self, k: int, q: list[float]) -> list[float]:
        c, h = self.lever(k, q[2])
        omega = (self.rho2 * q[5] - self.my * c * q[4] - self.mx * h * q[3]) / (self.rho2 + self.my * c * c + self.mx * h * h)
        return [*q[:3], -h * omega, -c * omega, omega]

    def struck(self, q: list[float], touching: set[int], landing: bool) -> tuple[list[float], set[int], int | None]:
        """Velocities after an impact, the corners that stay, and the direction of their slip."""
        turning = RIGHT if q[5] < 0 else LEFT
        if self.law == "housner" and not landing:
            after = self.stuck(turning, q)
            return (after, {turning}, None) if after[5] * q[5] > 0 else ([*q[:3], 0.0, 0.0, 0.0], BOTH, None)
        if self.law == "ratio" and not landing:
            return self.measured(q, turning)
        after, pushes, closed, slip = self.phase(q, dict.fromkeys(touching, 0.0))
        if self.e == 0:
            return after, closed, slip
        pushed = [k for k in touching if pushes[k] > 0]
        approaching = [k for k in touching if self.up(k, q) < -1e-14]
        if self.law == "energetic" and len(approaching) == 1:
            # One corner is taken to be that alone which approaches, if the other leaves.
            after_path, along = self.path(q, approaching[0])
            if all(self.up(k, after_path) > 0 for k in touching):
                self.doubts += len(pushed) == 2
                return after_path, set(), along
        after, _, closed, slip = self.phase(after, {k: self.e * push for k, push in pushes.items()})
        return after, closed, slip

    def phase(self, q: list[float], given: dict[int, float]) -> tuple[list[float], dict[int, float], set[int], int | None]:
        """Compression, or expansion with normal impulses that are given: velocities, all normal impulses, the corners that are
        pressed, their slip. Every set of pressed corners is tried with stick and both directions of slip."""
        corners = sorted(given)
        h = self.lever(corners[0], q[2])[1]
        masses = np.array([self.mx, self.my, self.rho2])
        rows = {k: np.array([0.0, 1.0, self.lever(k, q[2])[0]]) for k in corners}
        along, before, found = np.array([1.0, 0.0, h]), np.array(q[3:6]), []
        small = 1e-14 * (sum(map(abs, q[3:6])) + sum(given.values()))
        for slip in (None, -1, 1):
            for pressed in [(), *((k,) for k in corners), *([tuple(corners)] if len(corners) == 2 else [])]:
                # Each unknown is an impulse along its row; slip adds friction to each normal one.
                with_friction = {k: rows[k] - (slip or 0) * self.mu_i * along for k in corners}
                pushed = before + sum(given[k] * with_friction[k] for k in corners) / masses
                ways = [with_friction[k] for k in pressed] + ([along] if slip is None else [])
                stopped = [rows[k] for k in pressed] + ([along] if slip is None else [])
                matrix = np.array([[one @ (way / masses) for way in ways] for one in stopped])
                if ways and abs(np.linalg.det(matrix)) < 1e-13:
                    continue
                sizes = np.linalg.solve(matrix, [-one @ pushed for one in stopped]) if ways else []
                after = pushed + sum(size * way for size, way in zip(sizes, ways)) / masses
                normal = {k: given[k] + (sizes[pressed.index(k)] if k in pressed else 0.0) for k in corners}
                if any(sizes[i] < 0 for i in range(len(pressed))) or any(rows[k] @ after < -small for k in corners if k not in pressed):
                    continue
                total = sum(normal.values())
                if abs(sizes[-1]) <= self.mu_i * total + small if slip is None else slip * (along @ after) > 0:
                    # A corner that neither is pressed nor leaves stays, too.
                    stays = {k for k in corners if abs(rows[k] @ after) < 100 * small}
                    found.append(((slip is not None, len(pressed)), [*q[:3], *map(float, after)], normal, stays, slip))
        if not found:
            raise NoState
        # Stick before slip, few corners before many.
        found.sort(key=lambda one: one[0])
        for k in found[0][3]:
            found[0][1][4] -= self.up(k, found[0][1]) if len(found[0][3]) == 1 else 0.0
        return found[0][1:]

    def path(self, q: list[float], k: int) -> tuple[list[float], int | None]:
        """An impact at one corner whose normal impulse grows until the share e² of the work of compression is given back."""
        c, h = self.lever(k, q[2])
        a, b, d = 1 / self.mx + h * h / self.rho2, 1 / self.my + c * c / self.rho2, c * h / self.rho2
        normal, tangential, work, impulse, friction, gained = self.up(k, q), self.along(k, q), 0.0, 0.0, 0.0, 0.0
        slip: int | None = (1 if tangential > 0 else -1) if abs(tangential) > 1e-14 else None
        expands = False
        while True:
            if slip is None and abs(d) > self.mu_i * a:
                slip = 1 if d > 0 else -1
            share = -d / a if slip is None else -slip * self.mu_i
            normal_rate, tangential_rate = b + d * share, (0.0 if slip is None else d + a * share)
            stops = slip is not None and slip * tangential_rate < 0 and slip * tangential > 0
            to_stop = -tangential / tangential_rate if stops else math.inf
            if expands:
                left = self.e**2 * work - gained
                to_end = 2 * left / (normal + math.sqrt(normal**2 + 2 * normal_rate * left))
            else:
                to_end = -normal / normal_rate if normal_rate > 0 else math.inf
            step = min(to_stop, to_end)
            done = normal * step + 0.5 * normal_rate * step**2
            impulse, friction = impulse + step, friction + share * step
            normal, tangential = normal + normal_rate * step, tangential + tangential_rate * step
            if expands:
                gained += done
            else:
                work -= done
            if to_stop < to_end:
                tangential, slip = 0.0, None
            elif expands:
                break
            else:
                normal, expands = 0.0, True
        after = [q[3] + friction / self.mx, q[4] + impulse / self.my, q[5] + (c * impulse + h * friction) / self.rho2]
        return [*q[:3], *after], slip

    def measured(self, q: list[float], k: int) -> tuple[list[float], set[int], int | None]:
        """The measured share of the rate; where the slip turns around and it would give energy, the largest share that gives none."""
        c, h = self.lever(k, q[2])

        def after(share: float) -> tuple[list[float], bool]:
            omega = share * q[5]
            normal, sticking = self.my * (-c * omega - q[4]), self.mx * (-h * omega - q[3])
            if normal < 0:
                raise NoState
            most = self.mu_i * normal
            sticks = abs(sticking) <= most
            vx = -h * omega if sticks else q[3] + math.copysign(most, sticking) / self.mx
            return [*q[:3], vx, -c * omega, omega], sticks

        gain, share = lambda share: self.kinetic(after(share)[0]) - self.kinetic(q), self.ratio
        if not after(share)[1] and gain(share) > 0:
            if gain(0) > 0:
                raise NoState
            share = brentq(gain, 0, share, xtol=1e-16, rtol=1e-15)
        found, sticks = after(share)
        return found, {k}, None if sticks else (1 if self.along(k, found) > 0 else -1)

    def settle(self) -> None:
        """Ends a sequence of impacts ever faster, if its end is near; else a motion whose energy the supports take a hundred times over."""
        if self.state[0] not in ("RO", "SRO") or self.q[2] != 0:
            return
        rest_of = self.remaining()
        if rest_of is None:
            x, p, m = self.wrench(self.t, 0.0)
            spare = min(self.mu_k * p - abs(x), *((self.b[k] * p + s * (x * self.d - m)) / self.size for k, s in ((LEFT, 1), (RIGHT, -1))))
            slip = self.state[2] if self.state[0] == "SRO" else None
            if spare > 0 and self.kinetic(self.q) < 1e-10 * spare * self.size:
                self.take(REST, "settle")
            elif slip is not None and self.bouncing(p) < 1e-24 * self.g * self.size:
                stands = self.conditions(("SL", slip), self.t, self.q)
                if all(stands[name] > 0 for name in stands if name != "stop"):
                    self.q = [self.q[0], self.d, 0.0, self.q[3], 0.0, 0.0]
                    self.go_on("settle", BOTH, slip)
            return
        if rest_of >= 1e-5 * self.unit or self.t + rest_of > min(self.next_break, self.t_max):
            return
        x, p, _ = self.wrench(self.t, 0.0)
        slip = self.state[2] if self.state[0] == "SRO" else None
        vx = 0.0
        if slip is not None:
            before = self.along(self.state[1], self.q)
            vx = self.q[3] + (x * rest_of - slip * self.mu_k * (p * rest_of - self.my * self.q[4])) / self.mx
            vx = vx if slip * vx > 0 else 0.0
            self.q[0] += 0.5 * (before + vx) * rest_of
        self.t += rest_of
        self.q = [self.q[0], self.d, 0.0, vx, 0.0, 0.0]
        self.go_on("settle", BOTH, slip if vx else None)

    def remaining(self) -> float | None:
        """The time that the sequence of impacts which has begun takes, loads and slip as now; `None` if it is none that ends."""
        slip = self.state[2] if self.state[0] == "SRO" else None
        if slip is not None and self.mu_i != self.mu_k:
            return None
        k, rate, times, rates = self.state[1], self.q[5], [], [self.q[5]]
        speed = 0.0 if slip is None else self.along(k, self.q)
        for _ in range(2):
            state = ("RO", k) if slip is None else ("SRO", k, slip)
            still = [*self.q[:5], 0.0]
            _, _, alpha, normal, friction = self.law_of(state, self.t, still)
            if alpha * rate >= 0 or (slip is None and abs(friction) > self.mu_s * normal):
                return None
            times.append(2 * abs(rate / alpha))
            c, h = self.lever(k, 0.0)
            try:
                after, closed, then = self.struck([*self.q[:3], speed + h * rate, c * rate, -rate], BOTH, False)
            except NoState:
                return None
            if then != slip or closed != {1 - k}:
                return None
            k, rate = 1 - k, after[5]
            rates.append(rate)
        decay = abs(rates[2] / rates[0])
        return sum(times) / (1 - decay) if decay < 1 else None

    def close(self, touching: set[int], slip: int | None) -> None:
        """Ends a sequence of bounces whose rest is known; or puts a body flat whose corners both bounce by next to nothing."""
        x, p, m = self.wrench(self.t, self.q[2])
        mixed = slip is not None and self.mu_i != self.mu_k
        flat = touching == BOTH and abs(self.q[2]) == 0 and abs(self.q[5]) < 1e-15
        energy = self.bouncing(p)
        stands = self.conditions(REST if slip is None else ("SL", slip), self.t, self.q)
        if not flat and energy < (1e-24 if mixed else 1e-15) * self.g * self.size and all(stands[name] > 0 for name in stands if name != "stop"):
            vx = 0.0 if slip is None else self.q[3] + slip * self.mu_k * self.my / self.mx * self.q[4]
            slip = slip if slip is not None and slip * vx > 0 else None
            self.q = [self.q[0], self.d, 0.0, vx if slip else 0.0, 0.0, 0.0]
            self.go_on("settle", BOTH, slip)
            return
        for k in [] if mixed else [LEFT] if flat else sorted(touching):
            bounce = self.bounce(k, flat)
            if bounce is None or bounce[1] >= 1e-6 * self.unit or self.t + bounce[1] > min(self.next_break, self.t_max):
                continue
            fall, left = bounce
            # The sum is right to the second order of the time, which is nothing beside a gap of the other corner that is seen.
            ends = left < 1e-11 * self.unit
            far = 0.0 if ends else 1e-9 * self.size
            away = flat or all(self.ahead(1 - k, share * left) > far for share in (0.5, 1, 2))
            if away and (ends or self.alike(k, flat, fall, left, slip)):
                closes = BOTH if flat else {k}
                self.q = self.hanging(left)
                self.t += left
                self.q[1:3] = [self.d, 0.0] if flat else [self.lever(k, self.q[2])[1], self.q[2]]
                self.q[5] = 0.0 if flat else self.q[5]
                self.q, _, closed, slip = self.phase(self.q, dict.fromkeys(closes, 0.0))
                self.gaps = {k: 0.0 if k in closes else self.gap(k, self.q) for k in BOTH}
                self.go_on("settle", closed, slip)
                return

    def bouncing(self, p: float) -> float:
        return 0.5 * self.my * self.q[4] ** 2 + 0.5 * self.rho2 * self.q[5] ** 2 + p * max(self.q[1] - self.d, 0.0)

    def bounce(self, k: int, flat: bool) -> tuple[float, float] | None:
        """How fast a corner that bounces falls back, and how long it and all later bounces take."""
        _, p, m = self.wrench(self.t, self.q[2])
        c, h = self.lever(k, self.q[2])
        fall = p / self.my - (0.0 if flat else c * m / self.rho2 + h * self.q[5] ** 2)
        rate = self.q[4] if flat else self.up(k, self.q)
        return (fall, 2 * rate / (fall * (1 - self.e))) if fall > 0 and rate > 0 else None

    def hanging(self, time: float) -> list[float]:
        """Flight under the loads of now."""
        x, p, m = self.wrench(self.t, self.q[2])
        rates = [x / self.mx, -p / self.my, m / self.rho2]
        places = [place + rate * time + 0.5 * a * time**2 for place, rate, a in zip(self.q[:3], self.q[3:], rates)]
        return places + [rate + a * time for rate, a in zip(self.q[3:], rates)]

    def ahead(self, k: int, time: float) -> float:
        _, p, m = self.wrench(self.t, self.q[2])
        c, h = self.lever(k, self.q[2])
        return self.gaps[k] + self.up(k, self.q) * time - 0.5 * (p / self.my - c * m / self.rho2 - h * self.q[5] ** 2) * time**2

    def alike(self, k: int, flat: bool, fall: float, left: float, slip: int | None) -> bool:
        """Whether the next two bounces, and one impact without rebound in place of all, slip as the last one or stick."""
        corners = dict.fromkeys(BOTH if flat else {k}, 0.0)
        now, rate = self.hanging(0.0), self.q[4] if flat else self.up(k, self.q)

        def arrives(rates: list[float], time: float, down: float) -> list[float]:
            x, _, m = self.wrench(self.t, self.q[2])
            c, omega = self.lever(k, now[2])[0], 0.0 if flat else rates[2] + m / self.rho2 * time
            # The corner goes sideways also because the body turns.
            return [*now[:3], rates[0] + x / self.mx * time - c * rates[2] ** 2 * time, -down - (0.0 if flat else c * omega), omega]

        try:
            if self.phase(arrives(self.q[3:], left, fall * left - rate), corners)[3] != slip:
                return False
            rates, shares = self.q[3:], []
            for _ in range(2):
                after, closed, then = self.struck(arrives(rates, 2 * rate / fall, rate), set(corners), True)
                if then != slip or closed or self.up(k, after) >= rate:
                    return False
                rates, rate, shares = after[3:], self.up(k, after), [*shares, self.up(k, after) / rate]
        except NoState:
            return False
        return abs(shares[1] - shares[0]) < 1e-2 * shares[0]

    # From event to event.

    def section(self) -> None:
        """The loads between the next two breaks."""
        ahead = [t for t in self.breaks if t > self.t]
        self.next_break = ahead[0] if ahead else self.t + 1e6
        self.middle = 0.5 * (self.t + ahead[0]) if ahead else math.inf

    def run(self) -> None:
        self.section()
        try:
            self.begin()
            while len(self.events) < MOST and not self.overturned and self.t < self.t_max:
                if self.t >= self.next_break:
                    self.enter()
                elif self.state == REST:
                    if self.t >= self.end:
                        return
                    self.rest()
                elif self.state == FLIGHT:
                    self.fly()
                else:
                    self.move()
                self.seen()
        except NoState:
            self.events.append((float(self.t), "no-continuation", symbol(self.state)))

    def begin(self) -> None:
        touching = {k for k in BOTH if self.gap(k, self.q) <= 1e-12 * self.size}
        self.gaps = {k: 0.0 if k in touching else self.gap(k, self.q) for k in BOTH}
        closed, slip = {k for k in touching if self.up(k, self.q) <= 1e-12}, None
        if any(self.up(k, self.q) < -1e-12 for k in touching):
            self.q, closed, slip = self.struck(self.q, touching, True)
        elif closed:
            speed = self.along(min(closed), self.q)
            slip = None if abs(speed) < 1e-12 else (1 if speed > 0 else -1)
        self.go_on("start", closed, slip)

    def enter(self) -> None:
        before = self.wrench(self.t, self.q[2])
        self.section()
        jump = max(abs(a - b) for a, b in zip(before, self.wrench(self.t, self.q[2]))) > 1e-12
        if jump and self.state != FLIGHT:
            closed, slip = self.contact()
            if self.decided(closed, slip, None) != self.state:
                self.go_on("jump", closed, slip)

    def rest(self) -> None:
        to = min(self.next_break, self.t_max)
        moments = np.linspace(self.t, to, 2001)
        values = [self.conditions(REST, t, self.q) for t in moments]
        for (t0, now), (t1, then) in zip(zip(moments, values), zip(moments[1:], values[1:])):
            falls = [name for name in then if then[name] < -1e-15]
            if falls:
                root = lambda n: brentq(lambda t: self.conditions(REST, t, self.q)[n], t0, t1, xtol=1e-15, rtol=1e-15) if now[n] > 0 else t0
                self.t = min(map(root, falls))
                self.go_on("load", BOTH, None, REST)
                return
        self.t = to

    def move(self) -> None:
        """To the next event, or the next break."""
        state, to = self.state, min(self.next_break, self.t_max)
        step = dict(rtol=3e-14, atol=1e-17, max_step=0.05 * self.unit, first_step=min(to - self.t, 1e-4 * self.unit))
        solver, first = DOP853(self.slope(state), self.t, np.array(self.q, float), to, **step), True
        while True:
            solver.step()
            if solver.status == "failed":
                raise RuntimeError("the integrator gives up")
            dense = solver.dense_output()
            at = lambda name, t: self.conditions(state, t, list(dense(t)))[name]
            moments = np.linspace(solver.t_old, solver.t, 13)
            found = self.first_failure(state, moments, at, first)
            ended = found[0] if found else solver.t
            for t0, t1 in zip(moments, moments[1:]):
                if dense(t0)[5] * dense(t1)[5] < 0:
                    turn = brentq(lambda t: dense(t)[5], t0, t1, xtol=1e-15, rtol=1e-14)
                    if turn <= ended:
                        there = self.followed(state, solver.t_old, list(dense(solver.t_old)), turn)
                        self.max_theta = max(self.max_theta, abs(there[2]))
            if found:
                self.t, self.q = self.refined(state, solver.t_old, list(dense(solver.t_old)), *found)
                self.seen()
                self.happened(found[1])
                return
            first = False
            if solver.status == "finished":
                self.t, self.q = to, list(solver.y)
                self.max_theta = max(self.max_theta, abs(self.q[2]))
                return

    def fly(self) -> None:
        """Flight to the next impact, or the next break: as what loads add to a uniform motion, so that a gap keeps its digits however
        small a bounce is."""
        start, (x0, y0, theta0, *rates) = self.t, self.q
        whole, levers = min(self.next_break, self.t_max) - start, [self.lever(k, theta0) for k in (LEFT, RIGHT)]
        opening = [0.0 if k in self.lifted else self.up(k, self.q) for k in (LEFT, RIGHT)]
        loaded = any(t0 <= self.middle < t1 for h in [*(load[3] for load in self.loads), *self.base] for t0, t1, _ in h)

        def slope(s: float, z: Any) -> list[float]:
            return [*z[3:], *self.law_of(FLIGHT, start + s, [0.0, 0.0, theta0 + rates[2] * s + z[2]])[:3]]

        def free(s: Any) -> Any:
            none = 0.0 * s
            return np.array([none, -0.5 * self.g / self.my * s * s, none, none, -self.g / self.my * s, none])

        def gap(k: int, s: Any, z: Any) -> Any:
            (c, h), turned = levers[k], rates[2] * s + z[2]
            beyond = np.where(np.abs(turned) < 0.3, -(turned**3) / 6 * (1 - turned**2 / 20 * (1 - turned**2 / 42 * (1 - turned**2 / 72 * (1 - turned**2 / 110)))), np.sin(turned) - turned)
            return self.gaps[k] + opening[k] * s + z[1] + 2 * h * np.sin(turned / 2) ** 2 + c * (z[2] + beyond)

        def pose(s: float, z: Any) -> list[float]:
            uniform = [x0 + rates[0] * s, y0 + rates[1] * s, theta0 + rates[2] * s, *rates]
            return [float(a + b) for a, b in zip(uniform, z)]

        def reached(s: float, since: float, z: Any) -> Any:
            if not loaded or s <= since:
                return free(s) if not loaded else z
            again = DOP853(slope, since, z, s, rtol=3e-14, atol=FINE, first_step=s - since)
            while again.status == "running":
                again.step()
            return again.y

        # How long the bounces that begin now would take.
        grid = 0.01 * self.unit
        _, ay, alpha, _, _ = self.law_of(FLIGHT, start, self.q)
        for k in (LEFT, RIGHT):
            falls = ay + levers[k][0] * alpha + levers[k][1] * rates[2] ** 2
            if self.gaps[k] == 0 and opening[k] > 0 and falls != 0:
                grid = min(grid, abs(opening[k] / falls) / 8)
        step = dict(rtol=3e-14, atol=FINE, max_step=0.05 * self.unit, first_step=min(whole, 4 * grid))
        solver = DOP853(slope, 0.0, np.zeros(6), whole, **step) if loaded else None
        since, z_since = 0.0, np.zeros(6)
        while True:
            if solver is None:
                to, dense = min(whole, since + 0.5 * self.unit), free
            else:
                solver.step()
                if solver.status == "failed":
                    raise RuntimeError("the integrator gives up")
                to, dense = solver.t, solver.dense_output()
            moments = [since]
            while moments[-1] < to:
                moments.append(min(moments[-1] + grid, to))
                grid = min(1.5 * grid, 0.01 * self.unit)
            s = np.array(moments)
            z = dense(s)
            found = []
            for k in (LEFT, RIGHT):
                begins = self.gaps[k] == 0 and since == 0
                inside = slice(1, None) if begins else slice(None)
                # What opens now is zero at zero: over time it is not.
                values = (gap(k, s, z) / np.where(s > 0, s, 1))[inside] if begins else gap(k, s, z)
                at = lambda t, k=k, over=begins: float(gap(k, t, dense(t))) / (t if over else 1.0)
                places = list(s[inside])
                for i, value in enumerate(values):
                    if value < 0:
                        low = places[i - 1] if i else since + 1e-9 * (places[i] - since)
                        found.append((brentq(at, low, places[i], xtol=1e-30, rtol=1e-15) if at(low) > 0 else low, k))
                        break
                    if 0 < i < len(values) - 1 and value < values[i - 1] and value <= values[i + 1]:
                        least = minimize_scalar(at, bounds=(places[i - 1], places[i + 1]), method="bounded", options={"xatol": 1e-14})
                        if least.fun < 0:
                            found.append((brentq(at, places[i - 1], least.x, xtol=1e-30, rtol=1e-15), k))
                            break
            over = lambda t: math.pi / 2 - abs(theta0 + rates[2] * t + float(dense(t)[2]))
            late = [i for i, t in enumerate(moments) if over(t) < 0]
            if late:
                found.append((brentq(over, moments[late[0] - 1], moments[late[0]], xtol=1e-15, rtol=1e-14), None))
            ended, k = min(found, key=lambda one: one[0], default=(to, -1))
            self.extremes(lambda t: pose(t, dense(t)), moments, ended)
            if k != -1:
                for _ in range(3 if loaded and k is not None else 0):
                    there = reached(ended, since, z_since)
                    closing = opening[k] + there[4] + levers[k][1] * math.sin(rates[2] * ended + there[2]) * (rates[2] + there[5])
                    closing += levers[k][0] * (math.cos(rates[2] * ended + there[2]) * (rates[2] + there[5]) - rates[2])
                    if abs(gap(k, ended, there) / closing) < 1e-3 * ended:
                        ended = max(ended - float(gap(k, ended, there)) / closing, since)
                there = reached(ended, since, z_since)
                self.t, self.q = start + ended, pose(ended, there)
                self.gaps = {k: max(float(gap(k, ended, there)), 0.0) for k in BOTH}
                self.lifted = set()
                self.seen()
                self.happened("overturned" if k is None else ["gap O", "gap O'"][k])
                return
            since, z_since = to, z[:, -1]
            if to >= whole:
                self.t, self.q = start + whole, pose(whole, z_since)
                self.gaps = {k: max(float(gap(k, whole, z_since)), 0.0) for k in BOTH}
                self.lifted = set()
                return

    def extremes(self, pose: Callable[[float], list[float]], moments: list[float], ended: float) -> None:
        """Notes angles and slides between moments of a flight."""
        poses = [pose(t) for t in moments]
        for rate in (lambda q: q[5], lambda q: self.along(LEFT, q)):
            for t0, t1, q0, q1 in zip(moments, moments[1:], poses, poses[1:]):
                if rate(q0) * rate(q1) < 0:
                    turn = brentq(lambda t: rate(pose(t)), t0, t1, xtol=1e-15, rtol=1e-14)
                    if turn <= ended:
                        there = pose(turn)
                        self.max_theta = max(self.max_theta, abs(there[2]))
                        slide = abs(there[0] + self.lever(LEFT, there[2])[0] - self.feet[LEFT])
                        self.max_slide, self.slides[LEFT] = max(self.max_slide, slide), max(self.slides[LEFT], slide)

    def first_failure(self, state: tuple, moments: Any, at: Callable[[str, float], float], first: bool) -> tuple[float, str] | None:
        found = []
        for name in self.conditions(state, self.t, self.q):
            for i, (t0, t1) in enumerate(zip(moments, moments[1:])):
                # A gap that has just opened is zero but for rounding.
                if at(name, t1) >= (-1e-12 if first and name.startswith("gap") else 0):
                    continue
                if first and i == 0 and at(name, t0) <= 1e-12:
                    # It began at zero: look for where it was above.
                    above = [t for t in (t0 + (t1 - t0) * 2.0**-j for j in range(1, 30)) if at(name, t) > 0]
                    t0 = max(above, default=t0)
                found.append((brentq(lambda t: at(name, t), t0, t1, xtol=1e-15, rtol=1e-14) if at(name, t0) > 0 else t0, name))
                break
        return min(found, default=None)

    def refined(self, state: tuple, t0: float, q0: list[float], t: float, name: str) -> tuple[float, list[float]]:
        """The moment of an event by Newton's method on states that are integrated anew."""
        for _ in range(3):
            q, ahead = self.followed(state, t0, q0, t), 1e-6 * self.unit
            value = self.conditions(state, t, q)[name]
            rate = (self.conditions(state, t + ahead, self.followed(state, t, q, t + ahead))[name] - value) / ahead
            if rate == 0 or abs(value / rate) > 1e-6:
                break
            t = max(t - value / rate, t0)
        return t, self.followed(state, t0, q0, t)

    def happened(self, name: str) -> None:
        closed, slip = self.contact()
        if name == "overturned":
            self.overturned = True
            self.events.append((float(self.t), name, symbol(self.state)))
        elif name == "stop":
            self.q[3] = 0.0 if self.state[0] == "SL" else -self.lever(self.state[1], self.q[2])[1] * self.q[5]
            self.go_on("stop", closed, None, self.state)
        elif name in ("impact", "gap O", "gap O'"):
            landing = self.state == FLIGHT
            touching = BOTH
            if landing:
                lands = LEFT if name == "gap O" else RIGHT
                # What rounding makes of a height over this flight.
                flown = self.t - (self.events[-1][0] if self.events else 0.0)
                touching = {k for k in BOTH if self.gaps[k] <= 1e-13 * min(self.size, self.g * flown**2)} | {lands}
                self.q[1] = self.lever(lands, self.q[2])[1]
            else:
                self.q[1:3] = [self.d, 0.0]
            self.gaps = {k: 0.0 if k in touching else self.gaps[k] for k in BOTH}
            self.q, closed, slip = self.struck(self.q, touching, landing)
            self.go_on("impact", closed, slip)
            if self.state == FLIGHT and not closed and self.e < 1:
                self.close(touching, slip)
            else:
                self.settle()
        else:
            self.go_on({"cone -": "cone", "tip O": "tip", "tip O'": "tip"}.get(name, name), closed, slip, self.state)

    def slide(self) -> float:
        return self.slide_of(self.state[1] if self.state[0] in ("RO", "SRO") else LEFT)

    def slide_of(self, k: int) -> float:
        return self.q[0] + self.lever(k, self.q[2])[0] - self.feet[k]

    def touched(self) -> set[int]:
        """The corners that touch, were it for a moment."""
        return {k for k in BOTH if self.gaps[k] == 0} if self.state == FLIGHT else self.contact()[0]
