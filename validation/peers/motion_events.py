"""A second program for the motion in time, apart from the crate: general integrators and root finders of scipy instead of power series.

It follows a block from event to event as docs/theory/motion.md describes, with an eighth-order Runge-Kutta method (DOP853, 3e-14) whose
dense output is searched for the conditions of the present state, and compares with `standfast simulate`:

    pip install numpy scipy
    python motion_events.py PROGRAM 0 200         # 200 random blocks under loads and base motions
    python motion_events.py PROGRAM 0 40 --noise  # blocks on a base that shakes like an earthquake

What it leaves out: it tells what an equality turns into by following each candidate for a moment, not by derivatives; it gives up after
`MOST` events; it does not follow a corner whose inertia in slip vanishes.
"""

from __future__ import annotations

import json
import math
import random
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any, Callable

import numpy as np
from scipy.integrate import DOP853
from scipy.optimize import brentq

LEFT, RIGHT = 0, 1  # the corners O and O'
BOTH = {LEFT, RIGHT}
MOST = 3000

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
        self.law, self.ratio = case["law"], case.get("ratio", 1.0)
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
        middle = c - self.arm(low)
        self.feet = [middle + self.arm(k) for k in (LEFT, RIGHT)]
        self.state: tuple = REST
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
        self.max_theta = max(self.max_theta, abs(self.q[2]))
        self.events.append((float(self.t), why, symbol(state)))

    def go_on(self, why: str, closed: set[int], slip: int | None, failed: tuple | None = None) -> None:
        state = self.decided(closed, slip, failed)
        if state is not None:
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
        found = []
        for slip in (None, -1, 1):
            for k in sorted(touching):
                after = self.one(k, q, slip) if self.up(k, q) < 0 else None
                if after and (touching != BOTH or self.up(1 - k, after) > 0):
                    found.append((0 if slip is None else 2, after, {k}, slip))
            after = self.flat(q, slip) if touching == BOTH else None
            if after:
                found.append((1 if slip is None else 3, after, BOTH, slip))
        if not found:
            raise NoState
        # Stick before slip, one corner before both.
        return min(found, key=lambda one: one[0])[1:]

    def measured(self, q: list[float], k: int) -> tuple[list[float], set[int], int | None]:
        c, h = self.lever(k, q[2])
        omega = self.ratio * q[5]
        normal, sticking = self.my * (-c * omega - q[4]), self.mx * (-h * omega - q[3])
        most = self.mu_i * max(normal, 0)
        sticks = abs(sticking) <= most
        after = [*q[:3], -h * omega if sticks else q[3] + math.copysign(most, sticking) / self.mx, -c * omega, omega]
        if normal < 0 or (not sticks and self.kinetic(after) > self.kinetic(q)):
            raise NoState
        return after, {k}, None if sticks else (1 if self.along(k, after) > 0 else -1)

    def one(self, k: int, q: list[float], slip: int | None) -> list[float] | None:
        if slip is None:
            after = self.stuck(k, q)
            normal, friction = self.my * (after[4] - q[4]), self.mx * (after[3] - q[3])
            return after if normal >= 0 and abs(friction) <= self.mu_i * normal else None
        c, h = self.lever(k, q[2])
        normal = -self.up(k, q) / (1 / self.my + c * (c - slip * self.mu_i * h) / self.rho2)
        friction = -slip * self.mu_i * normal
        after = [*q[:3], q[3] + friction / self.mx, q[4] + normal / self.my, q[5] + (c * normal + h * friction) / self.rho2]
        return after if normal >= 0 and slip * self.along(k, after) > 0 else None

    def flat(self, q: list[float], slip: int | None) -> list[float] | None:
        normal = -self.my * q[4]
        friction = -self.mx * q[3] if slip is None else -slip * self.mu_i * normal
        vx = 0.0 if slip is None else q[3] + friction / self.mx
        holds = abs(friction) <= self.mu_i * normal if slip is None else slip * vx > 0
        moment = -self.rho2 * q[5] - self.d * friction
        within = normal >= 0 and -self.b[0] * normal <= moment <= self.b[1] * normal
        return [*q[:3], vx, 0.0, 0.0] if holds and within else None

    def settle(self) -> None:
        """Ends a sequence of impacts ever faster, if its end is near; else a motion whose energy the supports take a hundred times over."""
        if self.state[0] not in ("RO", "SRO") or self.q[2] != 0:
            return
        rest_of = self.remaining()
        if rest_of is None:
            x, p, m = self.wrench(self.t, 0.0)
            spare = min(self.mu_k * p - abs(x), *((self.b[k] * p + s * (x * self.d - m)) / self.size for k, s in ((LEFT, 1), (RIGHT, -1))))
            if spare > 0 and self.kinetic(self.q) < 1e-10 * spare * self.size:
                self.take(REST, "settle")
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
                else:
                    self.move()
        except NoState:
            self.events.append((float(self.t), "no-continuation", symbol(self.state)))

    def begin(self) -> None:
        touching = {k for k in BOTH if self.gap(k, self.q) <= 1e-12 * self.size}
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
                self.max_theta = max(self.max_theta, abs(self.q[2]))
                self.happened(found[1])
                return
            first = False
            if solver.status == "finished":
                self.t, self.q = to, list(solver.y)
                self.max_theta = max(self.max_theta, abs(self.q[2]))
                return

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
                touching = {k for k in BOTH if self.gap(k, self.q) <= 1e-13 * self.size} | {LEFT if name == "gap O" else RIGHT}
            else:
                self.q[1:3] = [self.d, 0.0]
            self.q, closed, slip = self.struck(self.q, touching, landing)
            self.go_on("impact", closed, slip)
            self.settle()
        else:
            self.go_on({"cone -": "cone", "tip O": "tip", "tip O'": "tip"}.get(name, name), closed, slip, self.state)

    def slide(self) -> float:
        k = self.state[1] if self.state[0] in ("RO", "SRO") else LEFT
        return self.q[0] + self.lever(k, self.q[2])[0] - self.feet[k]


# Random cases.


def history(n: random.Random, peak: float, unit: float) -> dict[str, Any]:
    shape = n.choice(["triangle", "triangle", "half-sine", "rect", "decay", "sine", "points", "church-roof"])
    duration = unit * 10 ** n.uniform(-0.5, 1.2)
    h: dict[str, Any] = {"shape": shape, "peak": peak, "start": n.choice([0.0, 0.0, n.uniform(0, 2) * unit])}
    if shape == "points":
        times, values = [0.0], [n.choice([0.0, 0.0, n.uniform(-0.5, 0.5)])]
        for _ in range(n.randint(2, 12)):
            times.append(times[-1] + duration * n.uniform(0.05, 0.5))
            values.append(n.uniform(-1, 1))
        return h | {"times": times, "values": values}
    h["duration"] = duration
    if shape == "triangle":
        h["rise"] = duration * n.uniform(0.05, 0.9)
    if shape == "sine":
        h |= {"period": duration, "phase": n.choice([0.0, n.uniform(0, 6)]), "duration": duration * n.choice([0.5, 1, 1.5, 2.3])}
    if shape == "church-roof":
        h |= {"peak": abs(peak), "rise": 0.1 * duration, "impact_duration": 0.3 * duration, "tail": abs(peak) * n.uniform(0.1, 0.6)}
    return h


def random_case(seed: int) -> dict[str, Any]:
    n = random.Random(seed)
    g, d = n.choice([1.0, 9.81]), 10 ** n.uniform(-0.4, 0.7)
    unit = g**-0.5
    mu = n.choice([n.uniform(0.05, 0.9 / max(d, 1)), n.uniform(1, 2) / d + 0.3, n.uniform(0.1, 1.5), n.uniform(0.1, 1.5)])
    case: dict[str, Any] = {"b1": 1.0, "b2": 1.0, "d": d, "rho2": (1 + d * d) / 3, "gravity": g, "mu_s": mu}
    if n.random() < 0.35:
        case["mu_k"] = mu * n.uniform(0.5, 1)
    if n.random() < 0.15:
        case["mu_impact"] = mu * n.uniform(0.5, 1)
    if n.random() < 0.3:
        case |= {"b1": n.uniform(0.6, 1), "b2": n.uniform(0.6, 1.3), "rho2": n.uniform(0.5, 1.3) * (1 + d * d) / 3}
    if n.random() < 0.3:
        case |= {"m_x": n.uniform(1, 1.6), "m_y": n.choice([1.0, n.uniform(1, 1.2)])}
    case["law"] = n.choice(["inelastic", "inelastic", "housner", "ratio"])
    if case["law"] == "ratio":
        about = [case["rho2"] + case.get("m_y", 1) * case[b] ** 2 + case.get("m_x", 1) * d * d for b in ("b1", "b2")]
        case["ratio"] = n.uniform(0.3, 0.95) * math.sqrt(min(about) / max(about))
    case["loads"] = []
    for _ in range(n.choice([0, 1, 1, 2])):
        direction = n.choice([[-1.0, 0.0], [-1.0, 0.0], [n.choice([-1, 1]) * 0.9, n.uniform(-0.4, 0.3)]])
        load = {"at": [n.choice([0.0, case["b2"]]), n.uniform(-1, 1) * d], "direction": direction, "follows": n.random() < 0.2}
        case["loads"].append(load | {"history": history(n, n.uniform(0.5, 2.5) * min(mu, 1.2 / d) * g, unit)})
    if not case["loads"] or n.random() < 0.35:
        case["base_h"] = history(n, n.choice([-1, 1]) * n.uniform(0.5, 2.5) * min(mu, 1 / d) * g, unit)
        if n.random() < 0.3:
            case["base_v"] = history(n, n.uniform(-0.4, 0.4) * g, unit)
    first = n.random()
    if first < 0.12:
        case["initial"] = {"theta": n.choice([-1, 1]) * n.uniform(0.01, 0.5) / d, "omega": n.choice([0.0, n.uniform(-0.2, 0.2) / unit])}
    elif first < 0.18:
        case["initial"] = {"vx": n.uniform(-0.5, 0.5) / unit}
    elif first < 0.23:
        case["initial"] = {"gap": n.uniform(0.01, 0.2), "vx": n.uniform(-0.2, 0.2) / unit}
    return case | {"t_max": 60 * unit}


def shaken_case(seed: int) -> dict[str, Any]:
    """A block on a base that shakes like an earthquake, 5 s in steps of 0.02 s."""
    n, count, dt, g = random.Random(seed), 250, 0.02, 9.81
    slender, b = n.uniform(1.5, 6), 0.3
    mu = n.choice([n.uniform(0.1, 0.3), n.uniform(0.3, 1.2)])
    strength = lambda i: min(1, i / 40) * math.exp(-max(0, i - 120) / 50)
    values, memory = [0.0], 0.0
    for i in range(1, count):
        memory = 0.75 * memory + n.gauss(0, 1)
        values.append(memory * strength(i))
    largest, times = max(map(abs, values)), [i * dt for i in range(count)]
    case: dict[str, Any] = {"b1": b, "b2": b, "d": slender * b, "rho2": b * b * (1 + slender**2) / 3, "gravity": g, "mu_s": mu}
    case |= {"law": n.choice(["inelastic", "housner", "ratio"]), "ratio": n.uniform(0.5, 0.95), "loads": [], "t_max": 20.0}
    peak = g * n.uniform(0.8, 2.5) * min(1 / slender, mu)
    case["base_h"] = {"shape": "points", "peak": peak, "times": times, "values": [v / largest for v in values[:-1]] + [0.0]}
    if n.random() < 0.5:
        noise = [0.0] + [n.gauss(0, 0.5) * strength(i) for i in range(1, count - 1)] + [0.0]
        case["base_v"] = {"shape": "points", "peak": g * n.uniform(0.05, 0.3), "times": times, "values": noise}
    return case


# Comparison.


def toml(value: Any) -> str:
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {toml(of)}" for key, of in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml, value)) + "]"
    return json.dumps(value) if isinstance(value, (str, bool)) else repr(float(value))


def case_file(case: dict[str, Any]) -> str:
    table = lambda entries: [f"{key} = {toml(value)}" for key, value in entries.items()]
    numbers = ("b1", "b2", "d", "rho2", "m_x", "m_y", "mu_s", "mu_k", "mu_impact", "gravity")
    lines = ["[block]", *table({key: case[key] for key in numbers if key in case})]
    for load in case["loads"]:
        lines += ["[[block.load]]", *table(load)]
    impact = {"law": case["law"]} | ({"ratio": case["ratio"]} if case["law"] == "ratio" else {})
    lines += ["[motion]", *table({"impact": impact, "t_max": case["t_max"]})]
    if "initial" in case:
        lines += ["[motion.initial]", *table(case["initial"])]
    base = {name: case[key] for name, key in (("horizontal", "base_h"), ("vertical", "base_v")) if key in case}
    return "\n".join([*lines, *(["[motion.base]", *table(base)] if base else [])]) + "\n"


def compared(program: str, case: dict[str, Any]) -> str:
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "case.toml"
        file.write_text(case_file(case), encoding="utf-8")
        ran = subprocess.run([program, "simulate", str(file), "--no-figures", "--format", "json"], capture_output=True, encoding="utf-8", check=True)
    theirs = json.loads(ran.stdout)
    motion = Motion(case)
    motion.run()
    # When it is over is no event of the motion.
    kept = lambda events: [event for event in events if event[1] not in ("rest", "end")]
    ours, events = kept(motion.events), kept([(event["t"], event["why"], event["state"]) for event in theirs["events"]])
    same = lambda a, b: a[1:] == b[1:] and abs(a[0] - b[0]) <= 1e-7 * (1 + a[0])
    i = next((i for i, (a, b) in enumerate(zip(ours, events)) if not same(a, b)), min(len(ours), len(events)))
    if not i == len(ours) == len(events):
        return f"differs at event {i}: {ours[i : i + 1]} here, {events[i : i + 1]} there, of {len(ours)} and {len(events)}"
    errors = abs(motion.slide() - theirs["slide"]), abs(motion.max_theta - theirs["max_theta"])
    return f"{len(ours)} events, slide {errors[0]:.1e}, max_theta {errors[1]:.1e}" + (" LARGE" if max(errors) > 1e-8 else "")


def main() -> None:
    program, begin, end, *options = sys.argv[1:]
    make = shaken_case if "--noise" in options else random_case

    def too_long(*_: Any) -> None:
        raise TimeoutError("it takes too long here")

    signal.signal(signal.SIGALRM, too_long)
    for seed in range(int(begin), int(end)):
        began = time.time()
        signal.alarm(300)
        try:
            said = compared(program, make(seed))
        except (TimeoutError, RuntimeError) as error:
            said = f"not compared: {error}"
        signal.alarm(0)
        print(f"{seed}: {said} ({time.time() - began:.1f} s)", flush=True)


if __name__ == "__main__":
    main()
