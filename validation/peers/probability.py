"""Probabilities a second way: everything of `standfast probability` worked out again, from formulas alone.

    pip install numpy==2.4.6 scipy==1.17.1
    python probability.py PATH/TO/standfast                 # plane, caisson, life, slide
    python probability.py PATH/TO/standfast plane caisson
    python probability.py PATH/TO/standfast coverage 20     # shares of answers inside their intervals, 20 seeds

Nothing is taken from the program: the laws, the correlation, Goda's pressures, the decision between the modes, the pulses. Up to
three random numbers are integrated by Gauss's rule of 16 points in panels that are halved until they settle, to about 1e-13 over one, 1e-9 over two; more are
integrated by scrambled Sobol' points of scipy, 32 scramblings, with their standard error. One number is integrated in closed form, as in the
program, but where possible another one: the force rather than the friction.
"""

import json
import math
import pathlib
import subprocess
import sys
import tempfile
import time

import numpy as np
from scipy.optimize import brentq
from scipy.special import ndtr, ndtri
from scipy.stats import qmc

ROOT = pathlib.Path(__file__).parents[2]
MODES = ["RE", "SL", "RO", "SRO-", "SRO+", "SRO'-", "RO'"]
REACH = 12.0
EULER = 0.57721566490153286


# Laws: (F, 1 - F, quantile of p, quantile of 1 - q), and how they are written in a case file.


class Law:
    def __init__(self, kind, lower=-math.inf, upper=math.inf, every=None, of=None, **p):
        self.kind, self.p, self.every, self.of = kind, p, every, of
        self.written = dict(p)
        self.lower, self.upper = lower, upper
        if kind in ("normal", "lognormal", "gumbel") and "cov" in p:
            self.p = {"mean": p["mean"], "sd": p["cov"] * p["mean"]}
        if kind == "gumbel" and "mean" in self.p:
            scale = self.p["sd"] * math.sqrt(6.0) / math.pi
            self.p = {"mode": self.p["mean"] - EULER * scale, "scale": scale}
        if kind == "gumbel" and "returns" in p:
            (t1, x1), (t2, x2) = p["returns"]
            y1, y2 = (-math.log(-math.log1p(-1.0 / t)) for t in (t1, t2))
            scale = (x2 - x1) / (y2 - y1)
            self.p = {"mode": x1 - scale * y1, "scale": scale}
        self.f_low, self.s_low = (self.F(lower), self.S(lower)) if lower > -math.inf else (0.0, 1.0)
        self.f_up, self.s_up = (self.F(upper), self.S(upper)) if upper < math.inf else (1.0, 0.0)

    def _z(self, x):
        p = self.p
        if self.kind == "normal":
            return (x - p["mean"]) / p["sd"]
        zeta = math.sqrt(math.log1p((p["sd"] / p["mean"]) ** 2))
        with np.errstate(divide="ignore", invalid="ignore"):
            return (np.log(np.maximum(x, 0.0)) - math.log(p["mean"]) + zeta**2 / 2) / zeta

    def F(self, x):
        p, x = self.p, np.asarray(x, float)
        with np.errstate(all="ignore"):
            match self.kind:
                case "normal" | "lognormal":
                    return ndtr(self._z(x))
                case "gumbel":
                    return np.exp(-np.exp(-(x - p["mode"]) / p["scale"]))
                case "weibull":
                    z = np.maximum((x - p.get("location", 0.0)) / p["scale"], 0.0)
                    return -np.expm1(-(z ** p["shape"]))
                case "gev":
                    t = np.maximum(1 + p["shape"] * (x - p["location"]) / p["scale"], 0.0)
                    return np.exp(-(t ** (-1 / p["shape"])))
                case "uniform":
                    return np.clip((x - p["from"]) / (p["to"] - p["from"]), 0.0, 1.0)
                case "triangular":
                    a, c, b = p["from"], p["mode"], p["to"]
                    y = np.clip(x, a, b)
                    return np.where(y < c, (y - a) ** 2 / ((b - a) * max(c - a, 1e-300)), 1 - (b - y) ** 2 / ((b - a) * max(b - c, 1e-300)))
                case "max_of":
                    return self.of.cdf(x) ** p["count"]

    def S(self, x):
        p, x = self.p, np.asarray(x, float)
        with np.errstate(all="ignore"):
            match self.kind:
                case "normal" | "lognormal":
                    return ndtr(-self._z(x))
                case "gumbel":
                    return -np.expm1(-np.exp(-(x - p["mode"]) / p["scale"]))
                case "weibull":
                    z = np.maximum((x - p.get("location", 0.0)) / p["scale"], 0.0)
                    return np.exp(-(z ** p["shape"]))
                case "gev":
                    t = np.maximum(1 + p["shape"] * (x - p["location"]) / p["scale"], 0.0)
                    return -np.expm1(-(t ** (-1 / p["shape"])))
                case "uniform":
                    return np.clip((p["to"] - x) / (p["to"] - p["from"]), 0.0, 1.0)
                case "triangular":
                    a, c, b = p["from"], p["mode"], p["to"]
                    y = np.clip(x, a, b)
                    return np.where(y < c, 1 - (y - a) ** 2 / ((b - a) * max(c - a, 1e-300)), (b - y) ** 2 / ((b - a) * max(b - c, 1e-300)))
                case "max_of":
                    return -np.expm1(p["count"] * np.log1p(-self.of.sf(x)))

    def _quantile(self, p_, q_):
        """The value with p_ below it and q_ = 1 - p_ above it."""
        p = self.p
        low = p_ <= 0.5
        with np.errstate(all="ignore"):
            match self.kind:
                case "normal" | "lognormal":
                    z = np.where(low, ndtri(p_), -ndtri(q_))
                    if self.kind == "normal":
                        return p["mean"] + p["sd"] * z
                    zeta = math.sqrt(math.log1p((p["sd"] / p["mean"]) ** 2))
                    return p["mean"] * np.exp(zeta * z - zeta**2 / 2)
                case "gumbel":
                    return p["mode"] - p["scale"] * np.where(low, np.log(-np.log(p_)), np.log(-np.log1p(-q_)))
                case "weibull":
                    return p.get("location", 0.0) + p["scale"] * np.where(low, -np.log1p(-p_), -np.log(q_)) ** (1 / p["shape"])
                case "gev":
                    t = np.where(low, -np.log(p_), -np.log1p(-q_))
                    return p["location"] + p["scale"] * (t ** -p["shape"] - 1) / p["shape"]
                case "uniform":
                    return np.where(low, p["from"] + p_ * (p["to"] - p["from"]), p["to"] - q_ * (p["to"] - p["from"]))
                case "triangular":
                    a, c, b = p["from"], p["mode"], p["to"]
                    below = p_ * (b - a) < (c - a)
                    return np.where(below, a + np.sqrt(p_ * (b - a) * (c - a)), b - np.sqrt(q_ * (b - a) * (b - c)))
                case "max_of":
                    one = np.where(low, -np.expm1(np.log(p_) / p["count"]), -np.expm1(np.log1p(-q_) / p["count"]))
                    return self.of.quantile(-np.expm1(np.log1p(-one)), one)

    # Of the law as it is cut.
    def cdf(self, x):
        return np.clip((self.F(x) - self.f_low) / (self.f_up - self.f_low), 0.0, 1.0)

    def sf(self, x):
        return np.clip((self.S(x) - self.s_up) / (self.s_low - self.s_up), 0.0, 1.0)

    def quantile(self, p_, q_):
        mass = self.f_up - self.f_low if self.f_up < 0.5 else self.s_low - self.s_up
        return self._quantile(self.f_low + p_ * mass, self.s_up + q_ * mass)

    def x(self, u):
        return self.quantile(ndtr(u), ndtr(-u))

    def u(self, x):
        f, s = self.cdf(x), self.sf(x)
        with np.errstate(divide="ignore"):
            return np.where(f < 0.5, ndtri(f), -ndtri(s))

    def toml(self, unit="", scale=1.0):
        def value(name, v):
            if name in ("cov", "shape", "count") or not unit:
                return repr(v) if name != "count" else str(v)
            return f'"{v / scale!r} {unit}"'

        if self.kind == "max_of":
            inner = self.of.toml(unit, scale)[2:-2]
            law = f"max_of = {{ count = {self.p['count']}, {inner} }}"
        elif "returns" in self.written:
            law = "gumbel = { " + ", ".join(f'"{t} years" = {value("", x)}' for t, x in self.written["returns"]) + " }"
        else:
            law = f"{self.kind} = {{ " + ", ".join(f"{k} = {value(k, v)}" for k, v in self.written.items()) + " }"
        if self.lower > -math.inf:
            law += f", lower = {value('', self.lower)}"
        if self.upper < math.inf:
            law += f", upper = {value('', self.upper)}"
        if self.every:
            law += f', every = "{self.every}"'
        return "{ " + law + " }"


# The plane of the report, with wrench (X, K = M/H, N), k = X/N, k' = K/X. Everything on a boundary is linear in it, and in the friction.


def decide(X, K, N, mu, gamma):
    """Index of the mode, and whether it is the only one; X > 0, N > 0."""
    k, kk = X / N, K / N
    d, a_k, ck = 1 + 4 * gamma**2, (4 + gamma**2) * k - 3 * gamma**2 * kk, 3 * gamma * (k + kk)
    a_kb, low = a_k + 3 * gamma, k + kk < 0
    rest = (mu >= k) & (gamma * np.abs(k + kk) <= 1)
    line = gamma * (mu + kk)
    upper = np.select(
        [rest, line < -1, (mu < k) & (line <= 1), mu * (ck + d) >= np.abs(a_kb), a_kb > 0], [0, 5, 1, 2, 3], 4
    )
    lower = np.select([rest, (mu < k) & (line >= -1), mu * (d - ck) >= a_k - 3 * gamma], [0, 1, 6], 5)
    several = (
        (kk < 0) & ~low & (gamma * (k + kk) > 1) & (-3 * gamma * kk >= 1 + gamma**2) & (mu * (ck + d) >= a_kb) & (line <= 1)
    )
    return np.where(low, lower, upper), several


def conditions(gamma):
    """Linear conditions as (coefficients of X, K, N; the same times μ)."""
    g2, d = gamma**2, 1 + 4 * gamma**2
    o, g = 0 * gamma, gamma
    one = o + 1
    return [
        ((one, o, o), (o, o, -one)),
        ((g, g, -one), (o, o, o)),
        ((g, g, one), (o, o, o)),
        ((o, g, -one), (o, o, g)),
        ((o, g, one), (o, o, g)),
        ((-(4 + g2), 3 * g2, -3 * g), (3 * g, 3 * g, d)),
        ((4 + g2, -3 * g2, 3 * g), (3 * g, 3 * g, d)),
        ((-(4 + g2), 3 * g2, 3 * g), (-3 * g, -3 * g, d)),
        ((4 + g2, -3 * g2, -3 * g), (-3 * g, -3 * g, d)),
        ((one, one, o), (o, o, o)),
        ((4 + g2, -3 * g2, 3 * g), (o, o, o)),
        ((o, o, one), (o, o, o)),
        ((o, -3 * g, -(1 + g2)), (o, o, o)),
        ((o, one, o), (o, o, o)),
    ]


def roots(w0, w1, mu, gamma):
    """Where each condition is met along t; wrench w0 + t w1, or along the friction if w1 is None."""
    out = []
    for plain, times in conditions(gamma):
        if w1 is None:
            zero = sum(c * w for c, w in zip(plain, w0))
            slope = sum(c * w for c, w in zip(times, w0))
        else:
            both = [c + mu * e for c, e in zip(plain, times)]
            zero = sum(c * w for c, w in zip(both, w0))
            slope = sum(c * w for c, w in zip(both, w1))
        with np.errstate(all="ignore"):
            out.append(-zero / slope)
    return np.stack(np.broadcast_arrays(*out), axis=-1)


class Plane:
    """A point of the report's plane; names gamma, k_prime, k, mu."""

    names = {"gamma": "", "k_prime": "", "k": "", "mu": ""}
    section = "point"

    def __init__(self, **fixed):
        self.fixed = fixed

    def text(self, random):
        return "[point]\n" + "".join(f"{n} = {v!r}\n" for n, v in self.fixed.items())

    def wrench(self, v, along):
        one = 1.0 + 0 * sum(np.asarray(x) for x in v.values())
        zero = 0 * one
        if along == "mu":
            return (v["k"] * one, v["k"] * v["k_prime"] * one, one), None
        if along == "k":
            return (zero, zero, one), (one, v["k_prime"] * one, zero)
        if along == "k_prime":
            return (v["k"] * one, zero, one), (zero, v["k"] * one, zero)
        raise ValueError(along)

    def gamma(self, v):
        return v["gamma"]


class Goda:
    """The caisson of examples/goda-2000.toml."""

    names = {
        "mu": "", "bias.P": "", "bias.U": "", "bias.M_p": "", "bias.M_U": "", "wave.deep_water_height": "m",
        "body.buoyant_weight": "kN/m", "wave.period": "s", "water_level": "m", "wave.angle_deg": "",
    }  # fmt: skip
    section = "body"
    g, rho, tan, B, H = 9.81, 1030.0, 0.01, 15.0, 10.5

    def __init__(self, **fixed):
        base = {
            "mu": 0.6, "bias.P": 1.0, "bias.U": 1.0, "wave.deep_water_height": 6.3, "body.buoyant_weight": 2318640.0,
            "wave.period": 11.4, "water_level": 7.1, "wave.angle_deg": 15.0,
        }  # fmt: skip
        self.changed = fixed
        self.fixed = base | fixed

    def text(self, random):
        text = (ROOT / "examples/goda-2000.toml").read_text()
        # A value equal to none of the case file's own is put into its line.
        lines = {"mu": "friction = {!r}", "body.buoyant_weight": 'buoyant_weight = "{!r} N/m"', "wave.deep_water_height": 'deep_water_height = "{!r} m"'}
        for name, value in self.changed.items():
            key = lines[name].split(" =")[0]
            text = "\n".join(lines[name].format(value) if line.startswith(key + " ") else line for line in text.splitlines()) + "\n"
        return text

    def waves(self, v):
        """P, U, M_p, M_U per metre."""
        H0, T, rise = np.asarray(v["wave.deep_water_height"]), v["wave.period"], v["water_level"] - 7.1
        h, d, base, hc = 10.1 + rise, 5.6 + rise, 7.1 + rise, 3.4 - rise
        BM, beta = 8.0, np.radians(v["wave.angle_deg"])
        L0 = self.g * T**2 / (2 * math.pi)
        y = 2 * math.pi * h / L0
        x = np.sqrt(y) * (1 + y / 6)
        for _ in range(30):
            x = x - (x * np.tanh(x) - y) / (np.tanh(x) + x / np.cosh(x) ** 2)
        L = 2 * math.pi * h / x
        n = 0.5 * (1 + 2 * x / np.sinh(2 * x))
        Ks = 1 / np.sqrt(2 * n * np.tanh(x))
        s, t = H0 / L0, self.tan

        def breaking(depth, b0, b1, floor, factor, shoaled):
            low = b0 * s**-0.38 * math.exp(20 * t**1.5) * H0 + b1 * depth
            top = np.maximum(floor, factor * s**-0.29 * math.exp(2.4 * t)) * H0
            return np.where(h / L0 < 0.2, np.minimum(np.minimum(low, top), shoaled), shoaled)

        H13 = breaking(h, 0.028, 0.52 * math.exp(4.2 * t), 0.92, 0.32, Ks * H0)
        hb = h + 5 * H13 * t
        Hm = breaking(hb, 0.052, 0.63 * math.exp(3.8 * t), 1.65, 0.53, 1.8 * Ks * H0)
        cos = np.cos(beta)
        eta = 0.75 * (1 + cos) * Hm
        a1 = 0.6 + 0.5 * (2 * x / np.sinh(2 * x)) ** 2
        a2 = np.minimum((hb - d) / (3 * hb) * (Hm / d) ** 2, 2 * d / Hm)
        a3 = 1 - base / h * (1 - 1 / np.cosh(x))
        hs = np.minimum(eta, hc)
        a4 = 1 - hs / eta
        one, two = BM / L - 0.12, (h - d) / h - 0.6
        d11, d22 = 0.93 * one + 0.36 * two, -0.36 * one + 0.93 * two
        d1 = np.where(d11 <= 0, 20 * d11, 15 * d11)
        d2 = np.where(d22 <= 0, 4.9 * d22, 3 * d22)
        aI1 = np.where(d2 <= 0, np.cos(d2) / np.cosh(d1), 1 / (np.cosh(d1) * np.sqrt(np.cosh(d2))))
        a_star = np.maximum(a2, np.minimum(Hm / d, 2) * aI1)
        p1 = 0.5 * (1 + cos) * (a1 + a_star * cos**2) * self.rho * self.g * Hm
        p3, p4 = a3 * p1, a4 * p1
        pu = 0.5 * (1 + cos) * a1 * a3 * self.rho * self.g * Hm
        P = 0.5 * (p1 + p3) * base + 0.5 * (p1 + p4) * hs
        Mp = (2 * p1 + p3) * base**2 / 6 + (p1 + p4) * base * hs / 2 + (p1 + 2 * p4) * hs**2 / 6
        U = 0.5 * pu * self.B
        return P, U, Mp, 2 / 3 * U * self.B

    def parts(self, v):
        P, U, Mp, MU = self.waves(v)
        weight = v["body.buoyant_weight"] - self.rho * self.g * self.B * (v["water_level"] - 7.1)
        return P, U, Mp, MU, weight

    def wrench(self, v, along):
        P, U, Mp, MU, weight = self.parts(v)
        one = 1.0 + 0 * P
        bP, bU = v["bias.P"], v["bias.U"]
        bMp, bMU = v.get("bias.M_p", bP), v.get("bias.M_U", bU)
        h, b = self.H / 2, self.B / 2
        X, N = bP * P * one, weight - bU * U
        K = ((bMp * Mp - bP * P * h) + (bMU * MU - bU * U * b)) / h
        if along == "mu":
            return (X, K, N), None
        if along == "bias.P" and "bias.M_p" not in v:
            return (0 * one, (bMU * MU - bU * U * b) / h, N), (P * one, (Mp - P * h) / h, 0 * one)
        if along == "bias.U" and "bias.M_U" not in v:
            return (X, (bMp * Mp - bP * P * h) / h, weight * one), (0 * one, (MU - U * b) / h, -U * one)
        if along == "body.buoyant_weight":
            return (X, K, N - v["body.buoyant_weight"]), (0 * one, 0 * one, one)
        raise ValueError(along)

    def gamma(self, v):
        return self.H / self.B

    def departs_by_sliding(self, v):
        """μ below which a load that grows slides it before it turns; biases of moments left out."""
        P, U, Mp, MU, weight = self.parts(v)
        bP, bU = v["bias.P"], v["bias.U"]
        turn = weight * self.B / 2 / (bP * Mp + bU * MU)
        return turn * bP * P / (weight - turn * bU * U)


# Integration.

NODES, WEIGHTS = np.polynomial.legendre.leggauss(16)


def panels(f, tags, tol, floor, width, start=12):
    """∫ f(tag, u) φ(u) du over ±12 for every tag at once; panels are halved until both halves add up to the whole."""
    edges = np.linspace(-REACH, REACH, start + 1)
    tag = np.repeat(np.arange(tags), start)
    a, b = np.tile(edges[:-1], tags), np.tile(edges[1:], tags)

    def rule(tag, a, b):
        half = (b - a) / 2
        u = (a + half)[:, None] + half[:, None] * NODES
        y = f(np.repeat(tag, 16), u.ravel()).reshape(len(a), 16, width)
        w = half[:, None] * WEIGHTS * np.exp(-u * u / 2) / math.sqrt(2 * math.pi)
        return np.einsum("ij,ijk->ik", w, y)

    total = np.zeros((tags, width))
    whole = rule(tag, a, b)
    rough = np.zeros((tags, width))
    np.add.at(rough, tag, whole)
    for level in range(60):
        middle = (a + b) / 2
        left, right = rule(tag, a, middle), rule(tag, middle, b)
        both = left + right
        # After a few levels the first estimate of the total is good enough to measure by.
        np.add.at(rough, tag, both - whole)
        bad = (np.abs(both - whole) > tol * np.abs(rough[tag]) + floor).any(axis=1) & (b - a > 1e-12)
        np.add.at(total, tag[~bad], both[~bad])
        if not bad.any():
            break
        tag, a, b, middle, left, right = tag[bad], a[bad], b[bad], middle[bad], left[bad], right[bad]
        tag, a, b, whole = np.concatenate([tag, tag]), np.concatenate([a, middle]), np.concatenate([middle, b]), np.concatenate([left, right])
    return total


class Problem:
    def __init__(self, name, model, random, along=None, correlation=(), years=None):
        self.name, self.model, self.random, self.years = name, model, random, years
        self.correlation = correlation  # (name, name, measure, value, correlation of the normals behind)
        prefer = ["k", "bias.P", "k_prime", "mu", "bias.U", "body.buoyant_weight"]
        if years:
            prefer = [n for n in prefer if n in random and random[n].every == "year"]
        self.along = along or next(n for n in prefer if n in random)
        rest = [n for n in random if n != self.along]
        rest.sort(key=lambda n: random[n].every == "year")
        self.order = rest + [self.along]
        size = len(self.order)
        R = np.eye(size)
        for one, other, _, _, value in correlation:
            i, j = self.order.index(one), self.order.index(other)
            R[i, j] = R[j, i] = value
        self.L = np.linalg.cholesky(R)

    def case(self):
        names = self.model.names
        written = lambda n: "friction" if (n == "mu" and self.model.section == "body") else n
        text = self.model.text(self.random) + "\n[random]\n"
        if self.years:
            text += f"years = {self.years}\n"
        for n, law in self.random.items():
            text += f"{written(n)} = {law.toml(names[n], 1000.0 if names[n] == 'kN/m' else 1.0)}\n"
        for one, other, measure, value, _ in self.correlation:
            text += f'\n[[random.correlation]]\nbetween = ["{written(one)}", "{written(other)}"]\n{measure} = {value}\n'
        return text

    def given(self, v):
        """Probabilities of the modes, of several, and of lifting, given independent normals v of all but the last."""
        n = len(self.order) - 1
        z = v @ self.L[:n, :n].T if n else np.zeros((len(v), 0))
        mean, sd = v @ self.L[n, :n], self.L[n, n]
        values = dict(self.model.fixed)
        for i, name in enumerate(self.order[:-1]):
            values[name] = self.random[name].x(z[:, i])
        along, law = self.along, self.random[self.along]
        values[along] = np.ones(len(v))
        values = {k: np.broadcast_to(np.asarray(x, float), (len(v),)) for k, x in values.items()}
        w0, w1 = self.model.wrench(values, along)
        gamma = self.model.gamma(values) + np.zeros(len(v))
        edges = roots(w0, w1, values.get("mu"), gamma)
        positive = along != "k_prime"
        if positive:
            edges = np.where(np.isfinite(edges) & (edges > 0), edges, 0.0)
            edges = np.concatenate([np.zeros((len(v), 1)), edges], axis=1)
        else:
            edges = np.where(np.isfinite(edges), edges, 0.0)
        edges = np.sort(edges, axis=1)
        lowest = edges[:, :1] - (0.0 if positive else 1.0)
        points = np.concatenate([lowest, edges, 2 * np.abs(edges[:, -1:]) + 1], axis=1)
        mid = (points[:, 1:] + points[:, :-1]) / 2
        column = lambda x: x[:, None]
        if w1 is None:
            X, K, N = (column(w) for w in w0)
            mu = mid
        else:
            X, K, N = (column(a) + mid * column(b) for a, b in zip(w0, w1))
            mu = column(values["mu"])
        lifted = N + 0 * mid <= 0
        mode, several = decide(X + 0 * mid, K + 0 * mid, np.where(lifted, 1.0, N), mu, column(gamma))
        u = (law.u(edges) - mean[:, None]) / sd
        ends = np.concatenate([np.full((len(v), 1), -np.inf), u, np.full((len(v), 1), np.inf)], axis=1)
        lo, hi = ends[:, :-1], ends[:, 1:]
        share = np.where(lo > 0, ndtr(-lo) - ndtr(-hi), ndtr(hi) - ndtr(lo))
        out = [np.where((mode == m) & ~lifted, share, 0.0).sum(axis=1) for m in range(len(MODES))]
        out.append(np.where(several & ~lifted, share, 0.0).sum(axis=1))
        out.append(np.where(lifted, share, 0.0).sum(axis=1))
        return np.stack(out, axis=1)

    def at_least_once(self, p):
        """From the probabilities of a year: those of moving and of each mode at least once."""
        p = np.clip(p, 0.0, 1.0)
        # The modes' sum is nearer to what moves than 1 less rest.
        moves = np.clip(p[:, 1:7].sum(axis=1) + p[:, 8], 0.0, 1.0)
        with np.errstate(divide="ignore"):
            once = -np.expm1(self.years * np.log1p(-p))
            once[:, 0] = -np.expm1(self.years * np.log1p(-moves))
        return once

    def integrate(self, tol=None, floor=None):
        width = len(MODES) + 2
        # Both halves may agree with the whole by chance where a kink stands well; over one number digits cost little.
        tol = tol or (1e-13 if len(self.order) <= 2 else 1e-11)
        floor = floor or (1e-22 if len(self.order) <= 2 else 1e-16)
        outer = self.order[:-1]
        yearly = [n for n in outer if self.random[n].every == "year"]

        def level(fixed, left):
            """Integral over `left` more numbers for rows of fixed normals."""
            def f(rows):
                if left == 0:
                    y = self.given(rows)
                else:
                    y = panels(
                        lambda tag, u: level_of(np.column_stack([rows[tag], u]), left - 1), len(rows), tol, floor, width, 12
                    )
                return y
            y = f(fixed)
            if self.years and left == len(yearly):
                y = self.at_least_once(y)
            return y

        def level_of(rows, left):
            if left == 0 or len(rows) <= 1024:
                return level(rows, left)
            return np.concatenate([level(rows[i : i + 1024], left) for i in range(0, len(rows), 1024)])

        return level(np.zeros((1, 0)), len(outer))[0], None

    def sobol(self, log2=16, replicates=32):
        """Mean and standard error by scrambled Sobol' points."""
        n = len(self.order) - 1
        means = []
        for seed in range(replicates):
            total = np.zeros(len(MODES) + 2)
            engine = qmc.Sobol(n, seed=1000 + seed)
            for _ in range(max(1, 1 << max(0, log2 - 14))):
                points = np.clip(engine.random(1 << min(log2, 14)), 1e-17, 1 - 1e-16)
                total += self.given(ndtri(points)).sum(axis=0)
            means.append(total / (1 << log2))
        means = np.array(means)
        return means.mean(axis=0), means.std(axis=0, ddof=1) / math.sqrt(replicates)


def nataf_linear(one, other, linear):
    """Correlation of the normals behind for a linear one of the values, by 64 × 64 Gauss–Hermite points and bisection."""
    x, w = np.polynomial.hermite_e.hermegauss(96)
    w = w / w.sum()

    def moments(law):
        y = law.x(x)
        m = (w * y).sum()
        return m, math.sqrt((w * (y - m) ** 2).sum())

    (m1, s1), (m2, s2) = moments(one), moments(other)

    def got(r):
        z = r * x[:, None] + math.sqrt(1 - r * r) * x[None, :]
        return (w[:, None] * w[None, :] * (one.x(x)[:, None] - m1) * (other.x(z) - m2)).sum() / (s1 * s2)

    return brentq(lambda r: got(r) - linear, -0.999, 0.999, xtol=1e-15)


def rank(value):
    return 2 * math.sin(math.pi * value / 6)


def plane_problems():
    N = lambda mean, sd=None, **k: Law("normal", mean=mean, **({"sd": sd} if sd else {}), **k)
    LN = lambda mean, cov, **k: Law("lognormal", mean=mean, cov=cov, **k)
    report = Plane(gamma=0.8, k_prime=0.9167)
    yield Problem("two normals", report, {"mu": N(0.6, 0.1, lower=0.0), "k": N(0.45, 0.12, lower=0.0)})
    yield Problem("small, lognormal", report, {"mu": LN(0.62, 0.08), "k": LN(0.35, 0.15)})
    yield Problem("very small, lognormal", report, {"mu": LN(0.62, 0.06), "k": LN(0.33, 0.10)})
    yield Problem("Gumbel", report, {"mu": LN(0.6, 0.15), "k": Law("gumbel", mean=0.4, sd=0.12, lower=0.0)})
    yield Problem("Gumbel by return values", report, {"mu": N(0.6, 0.1, lower=0.1, upper=0.9), "k": Law("gumbel", returns=[(10, 0.41), (100, 0.62)], lower=0.0)})
    yield Problem("Weibull", Plane(gamma=1.5, k_prime=0.5), {"mu": Law("uniform", **{"from": 0.3, "to": 0.8}), "k": Law("weibull", scale=0.4, shape=2.2)})
    yield Problem("Weibull with a location", Plane(gamma=2.5, k_prime=1.0), {"mu": Law("triangular", **{"from": 0.1, "mode": 0.3, "to": 0.9}), "k": Law("weibull", scale=0.4, shape=1.4, location=0.05)})
    yield Problem("GEV, heavy", Plane(gamma=2.0, k_prime=0.6), {"mu": LN(0.5, 0.2), "k": Law("gev", location=0.3, scale=0.06, shape=0.15, lower=0.0)})
    yield Problem("largest of fifty", Plane(gamma=1.2, k_prime=0.3), {"mu": N(0.6, 0.08, lower=0.0), "k": Law("max_of", count=50, of=Law("gumbel", mean=0.25, sd=0.05, lower=0.0))})
    yield Problem("case 2, SRO+", Plane(gamma=3.0, k_prime=1.0), {"mu": LN(0.3, 0.5), "k": LN(0.6, 0.6)})
    yield Problem("case 3 far out", Plane(gamma=2.5, k_prime=1.6), {"mu": LN(0.25, 0.4), "k": Law("gumbel", mean=1.0, sd=0.5, lower=0.0)})
    yield Problem("below C", Plane(gamma=1.5, k_prime=-0.6), {"mu": LN(0.5, 0.2), "k": Law("gumbel", mean=1.0, sd=0.4, lower=0.0)})
    yield Problem("several modes hold", Plane(gamma=1.0, k_prime=-0.5), {"mu": LN(2.5, 0.3), "k": LN(3.0, 0.4)})
    yield Problem("several, small", Plane(gamma=1.3, k_prime=-0.3), {"mu": LN(0.8, 0.2), "k": LN(1.5, 0.4)})
    yield Problem("k' below -1", Plane(gamma=1.2, k_prime=-2.5), {"mu": LN(0.6, 0.3), "k": LN(0.6, 0.3)})
    yield Problem("k' of -1", Plane(gamma=1.2, k_prime=-1.0), {"mu": LN(0.6, 0.3), "k": LN(0.6, 0.5)})
    yield Problem("k' of 0", Plane(gamma=1.2, k_prime=0.0), {"mu": LN(0.6, 0.3), "k": LN(0.6, 0.5)})
    yield Problem("correlated by rank", report, {"mu": LN(0.6, 0.15), "k": N(0.45, 0.12, lower=0.0)}, correlation=[("mu", "k", "rank", 0.6, rank(0.6))])
    yield Problem("correlated, normals behind", report, {"mu": LN(0.6, 0.15), "k": N(0.45, 0.12, lower=0.0)}, correlation=[("mu", "k", "normal", -0.7, -0.7)])
    mu, k = LN(0.6, 0.25), LN(0.45, 0.3)
    z1, z2 = (math.sqrt(math.log1p(c * c)) for c in (0.25, 0.3))
    closed = math.log1p(0.5 * 0.25 * 0.3) / (z1 * z2)
    yield Problem("correlated linearly, lognormals", report, {"mu": mu, "k": k}, correlation=[("mu", "k", "linear", 0.5, closed)])
    mu, k = N(0.6, 0.1, lower=0.0), Law("gumbel", mean=0.4, sd=0.1, lower=0.0)
    yield Problem("correlated linearly, normal and Gumbel", report, {"mu": mu, "k": k}, correlation=[("mu", "k", "linear", 0.4, nataf_linear(mu, k, 0.4))])
    yield Problem("only friction", Plane(gamma=2.0, k_prime=0.9167, k=0.5), {"mu": LN(0.4, 0.3)}, along="mu")
    yield Problem("only the force", Plane(gamma=1.5, k_prime=0.4, mu=0.45), {"k": Law("gumbel", mean=0.35, sd=0.12, lower=0.0)})
    yield Problem("force and its height", Plane(gamma=1.5, mu=0.45), {"k": Law("gumbel", mean=0.35, sd=0.12, lower=0.0), "k_prime": N(0.4, 0.3)})
    yield Problem("slenderness", Plane(k_prime=0.5, mu=0.6), {"gamma": LN(1.6, 0.15), "k": N(0.4, 0.1, lower=0.0)})
    yield Problem("slenderness, friction, force", Plane(k_prime=0.5), {"gamma": N(1.6, 0.2, lower=0.5), "mu": LN(0.5, 0.2), "k": N(0.4, 0.1, lower=0.0)})
    yield Problem("height, friction, force", Plane(gamma=1.5), {"k_prime": N(0.3, 0.4), "mu": LN(0.5, 0.2), "k": LN(0.45, 0.3)})
    yield Problem("height over -1, friction, force", Plane(gamma=1.1), {"k_prime": N(-0.9, 0.3), "mu": LN(0.9, 0.4), "k": LN(1.2, 0.5)})
    r = rank(0.5)
    yield Problem("three, correlated", Plane(gamma=1.4), {"k_prime": N(0.4, 0.2), "mu": LN(0.5, 0.2), "k": LN(0.45, 0.3)}, correlation=[("k_prime", "k", "rank", 0.5, r), ("mu", "k", "normal", -0.3, -0.3)])
    yield Problem("all four", Plane(), {"gamma": LN(1.3, 0.1), "k_prime": N(0.3, 0.3), "mu": LN(0.5, 0.2), "k": LN(0.45, 0.3)})
    yield Problem("all four, small", Plane(), {"gamma": LN(0.9, 0.05), "k_prime": N(0.4, 0.1), "mu": LN(0.62, 0.08), "k": LN(0.35, 0.12)})
    yield Problem("all four, correlated", Plane(), {"gamma": LN(1.3, 0.1), "k_prime": N(0.3, 0.3), "mu": LN(0.5, 0.2), "k": Law("gumbel", mean=0.4, sd=0.1, lower=0.0)}, correlation=[("k_prime", "k", "rank", 0.4, rank(0.4)), ("gamma", "mu", "normal", 0.3, 0.3)])


def caisson_problems():
    N = lambda mean, sd, **k: Law("normal", mean=mean, sd=sd, **k)
    LN = lambda mean, cov, **k: Law("lognormal", mean=mean, cov=cov, **k)
    G = lambda mean, sd, **k: Law("gumbel", mean=mean, sd=sd, lower=1.0, **k)
    mu, P, U, H = LN(0.636, 0.15), LN(0.91, 0.19), LN(0.77, 0.25), G(4.5, 0.9)
    yield Problem("friction, P", Goda(), {"mu": mu, "bias.P": P})
    yield Problem("friction, sea", Goda(), {"mu": mu, "wave.deep_water_height": H}, along="mu")
    yield Problem("friction, P, sea", Goda(), {"mu": mu, "bias.P": P, "wave.deep_water_height": H})
    yield Problem("friction, P, sea, small", Goda(**{"body.buoyant_weight": 2.7e6}), {"mu": LN(0.636, 0.08), "bias.P": LN(0.91, 0.07), "wave.deep_water_height": G(4.5, 0.5)})
    yield Problem("friction, P, U", Goda(), {"mu": mu, "bias.P": P, "bias.U": U})
    yield Problem("P, U, sea; friction certain", Goda(), {"bias.P": P, "bias.U": U, "wave.deep_water_height": H})
    yield Problem("P, sea; friction certain", Goda(mu=0.7), {"bias.P": P, "wave.deep_water_height": H})
    yield Problem("friction, P, tide", Goda(), {"mu": mu, "bias.P": P, "water_level": N(7.1, 0.35, lower=5.9, upper=8.3)})
    yield Problem("friction, P, weight", Goda(), {"mu": mu, "bias.P": P, "body.buoyant_weight": N(2318640.0, 70000.0)})
    yield Problem("friction, P, M_p", Goda(), {"mu": mu, "bias.P": P, "bias.M_p": LN(0.81, 0.3)}, along="mu")
    yield Problem("friction, P, M_U", Goda(mu=0.9), {"mu": LN(0.9, 0.15), "bias.P": LN(0.91, 0.4), "bias.M_U": LN(0.72, 0.37)}, along="mu")
    yield Problem("friction, P, period", Goda(), {"mu": mu, "bias.P": P, "wave.period": N(11.4, 0.8, lower=8.0, upper=14.0)})
    yield Problem("friction, P, angle", Goda(), {"mu": mu, "bias.P": P, "wave.angle_deg": Law("triangular", **{"from": 0.0, "mode": 10.0, "to": 40.0})})
    yield Problem("friction, P, sea, correlated", Goda(), {"mu": mu, "bias.P": P, "wave.deep_water_height": H}, correlation=[("mu", "bias.P", "rank", 0.3, rank(0.3)), ("bias.P", "wave.deep_water_height", "normal", 0.4, 0.4)])
    yield Problem("often lifted", Goda(), {"mu": mu, "bias.P": P, "bias.U": LN(3.0, 0.2)}, along="mu")
    yield Problem("four", Goda(), {"mu": mu, "bias.P": P, "bias.U": U, "wave.deep_water_height": H})
    yield Problem("four, correlated", Goda(), {"mu": mu, "bias.P": P, "bias.U": U, "wave.deep_water_height": H}, correlation=[("bias.P", "bias.U", "rank", 0.6, rank(0.6))])
    yield Problem("four, small", Goda(**{"body.buoyant_weight": 2.7e6}), {"mu": LN(0.636, 0.1), "bias.P": LN(0.91, 0.1), "bias.U": LN(0.77, 0.15), "wave.deep_water_height": G(4.5, 0.5)})
    tide = N(7.1, 0.35, lower=5.9, upper=8.3)
    yield Problem("five, with M_p", Goda(), {"mu": mu, "bias.P": P, "bias.M_p": LN(0.81, 0.3), "bias.U": U, "wave.deep_water_height": H}, along="mu")
    yield Problem("six", Goda(), {"mu": N(0.6, 0.1, lower=0.0), "bias.P": P, "bias.U": U, "wave.deep_water_height": H, "body.buoyant_weight": N(2318640.0, 70000.0, lower=0.0), "water_level": tide})
    yield Problem("six, small", Goda(**{"body.buoyant_weight": 2.7e6}), {"mu": N(0.62, 0.06, lower=0.0), "bias.P": LN(0.91, 0.1), "bias.U": LN(0.77, 0.2), "wave.deep_water_height": G(4.5, 0.6), "body.buoyant_weight": N(2.7e6, 80000.0, lower=0.0), "water_level": N(7.1, 0.3, lower=5.9, upper=8.3)})
    yield Problem("eight", Goda(), {"mu": mu, "bias.P": P, "bias.M_p": LN(0.81, 0.3), "bias.U": U, "wave.deep_water_height": H, "body.buoyant_weight": N(2318640.0, 70000.0), "water_level": tide, "wave.period": N(11.4, 0.8, lower=8.0, upper=14.0)}, along="mu")


def life_problems():
    N = lambda mean, sd, **k: Law("normal", mean=mean, sd=sd, **k)
    LN = lambda mean, cov, **k: Law("lognormal", mean=mean, cov=cov, **k)
    report = Plane(gamma=0.8, k_prime=0.9167)
    k = Law("gumbel", mean=0.3, sd=0.06, lower=0.0, every="year")
    yield Problem("life: friction once", report, {"mu": LN(0.6, 0.15), "k": k}, years=50)
    yield Problem("life: friction yearly", report, {"mu": LN(0.6, 0.15, every="year"), "k": k}, years=50)
    yield Problem("life: slender once", Plane(k_prime=0.5), {"gamma": LN(1.5, 0.1), "mu": LN(0.6, 0.1), "k": k}, years=100)
    yield Problem("life: height yearly", Plane(gamma=1.5), {"mu": LN(0.6, 0.1), "k_prime": N(0.4, 0.2, every="year"), "k": k}, years=20)
    yield Problem("life: correlated", report, {"mu": LN(0.6, 0.15, every="year"), "k": k}, years=50, correlation=[("mu", "k", "normal", 0.4, 0.4)])
    G = Law("gumbel", mean=4.5, sd=0.9, lower=1.0, every="year")
    yield Problem("life: caisson, P yearly", Goda(), {"mu": LN(0.636, 0.15), "bias.P": LN(0.91, 0.19, every="year"), "wave.deep_water_height": G}, years=50)
    yield Problem("life: caisson, three yearly", Goda(), {"mu": LN(0.636, 0.15), "bias.P": LN(0.91, 0.19, every="year"), "bias.U": LN(0.77, 0.25, every="year"), "wave.deep_water_height": G}, years=50)


def ask(program, text, *arguments):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "case.toml"
        path.write_text(text)
        command = [program, "probability", str(path), "--format", "json", "--no-figures", "--threads", "1", *arguments]
        start = time.perf_counter()
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode:
            raise RuntimeError(done.stderr)
        return json.loads(done.stdout), time.perf_counter() - start


def answers(document, years):
    """The same list as `Problem.given`'s from the program's answer: (probability, low, high) each."""
    triple = lambda o: (o["probability"], o["low"], o["high"])
    if years:
        life = document["life"]
        once = {m["mode"]: triple(m) for m in life["modes"]}
        return {"moves": triple(life["not_rest"])} | {m: once[m] for m in MODES[1:]}
    modes = {m["mode"]: triple(m) for m in document["modes"]}
    return {m: modes[m] for m in MODES} | {"several": triple(document["not_unique"]), "lifted": triple(document["lifted"]), "not rest": triple(document["not_rest"])}


def reference(problem):
    """Name → (probability, standard error)."""
    few = len(problem.order) <= 3
    p, error = problem.integrate() if few else problem.sobol()
    error = error if error is not None else np.zeros_like(p)
    names = ["moves" if problem.years else "RE", *MODES[1:], "several", "lifted"]
    out = dict(zip(names, zip(p, error)))
    if problem.years:
        del out["several"], out["lifted"]
    else:
        # The modes' sum; lifting moves the body too.
        moved = [1, 2, 3, 4, 5, 6, 8]
        out["not rest"] = (p[moved].sum(), math.sqrt((error[moved] ** 2).sum()))
    return out


def compare(program, problems):
    worst = {}
    for problem in problems:
        start = time.perf_counter()
        expected = reference(problem)
        took = time.perf_counter() - start
        few = len(problem.order) <= 3
        try:
            document, seconds = ask(program, problem.case())
        except RuntimeError as error:
            print(f"{problem.name}: {error}")
            continue
        found = answers(document, problem.years)
        total = sum(m["probability"] for m in document["modes"])
        print(f"{problem.name}: {document['method']}, {document['points']} points, along {document['integrated']}, {seconds:.2f} s; here along {problem.along}, {took:.1f} s; sum 1{total - 1:+.0e}")
        for name, (p, error) in expected.items():
            got, low, high = found[name]
            if p < 1e-13 and got < 1e-13:
                continue
            relative = abs(got / p - 1) if p else math.inf
            # Both by integration: to their digits.
            slack = max(1e-9 * p, 1e-13) if few else 3 * error
            inside = low - slack <= p <= high + slack
            note = "" if inside else "  OUTSIDE"
            if document["method"] == "integrate" and abs(got - p) > 1e-8 * p + 1e-13:
                note += "  DIFFERS"
            print(f"    {name:9s} {p:.12e} ± {error:.0e}   {got:.12e} [{low:.6e}, {high:.6e}]   {relative:.1e}{note}")
        sys.stdout.flush()


SLIDE = """[storm]
waves = 1000
tau0 = "{tau0} s"
force_per_height = "90 kN/m2"
uplift_per_height = "45 kN/m2"
buoyant_weight = "2318.64 kN/m"
mass = "402.45 t/m"
[random]
years = 50
friction = {{ normal = {{ mean = {mean}, sd = 0.1 }}, lower = 0.05 }}
bias.P = {{ lognormal = {{ mean = 0.91, cov = 0.19 }} }}
significant_height = {{ gumbel = {{ mean = "4.5 m", sd = "0.9 m" }}, lower = "1 m", every = "year" }}
"""


def pulse(s, resistance, tau0, mass):
    """The slide of a symmetric triangle of thrust s times the resistance."""
    short = (0.25 + math.sqrt(2) / 6) * (s - 1) ** 3 / s**2
    long = (s - 1) ** 2 / 8 - 1 / (96 * s**2)
    return np.where(s <= 1, 0.0, np.where(s <= 1 + 1 / math.sqrt(2), short, long)) * resistance * tau0**2 / mass


def slides(program):
    """Mean slide of fifty years of storms, by Gauss's rule over friction, bias, storm and waves; the shares of
    lives that slide farther than 0.10 and 0.30 m, by lives of which only waves above the critical height are drawn."""
    W, M, F, U = 2318.64e3, 402.45e3, 90e3, 45e3
    for mean, tau0 in ((0.6, 1.5), (0.7, 1.5), (0.6, 0.6)):
        mu_law, b_law = Law("normal", mean=mean, sd=0.1, lower=0.05), Law("lognormal", mean=0.91, cov=0.19)
        h_law = Law("gumbel", mean=4.5, sd=0.9, lower=1.0)

        def critical(mu, b):
            return mu * W / (b * F + mu * U)

        # Gauss's rule in all three normals; 120 points each and 96 agree to the digits printed.
        x, weight = np.polynomial.legendre.leggauss(120)
        x, weight = 9 * x, 9 * weight * np.exp(-0.5 * (9 * x) ** 2) / math.sqrt(2 * math.pi)
        expected = 0.0
        for v, share in zip(x, weight):
            mu, b = mu_law.x(np.full(1, v)), b_law.x(x)
            a = ((1.416 * critical(mu, b))[:, None] / h_law.x(x)[None, :]) ** 2
            # The pulse's law changes at s = 1 + 1/√2; far above the critical level nothing is left.
            kink = a * (1 + 1 / math.sqrt(2)) ** 2
            total = np.zeros_like(a)
            for lo, hi in ((a, np.minimum(kink, a + 60.0)), (kink, kink + 60.0)):
                t = (lo + hi)[..., None] / 2 + (hi - lo)[..., None] / 2 * NODES
                total += ((hi - lo)[..., None] / 2 * WEIGHTS * np.exp(-t) * pulse(np.sqrt(t / a[..., None]), mu[0] * W, tau0, M)).sum(axis=2)
            expected += share * (weight[:, None] * weight[None, :] * total).sum()
        expected *= 50 * 1000
        random = np.random.default_rng(1)
        lives = 40000
        mu, b = mu_law.x(random.standard_normal(lives)), b_law.x(random.standard_normal(lives))
        slide = np.zeros(lives)
        for _ in range(50):
            a = (1.416 * critical(mu, b) / h_law.x(random.standard_normal(lives))) ** 2
            count = random.binomial(1000, np.exp(-a))
            life = np.repeat(np.arange(lives), count)
            t = a[life] + random.standard_exponential(len(life))
            np.add.at(slide, life, pulse(np.sqrt(t / a[life]), (mu * W)[life], tau0, M))
        document, seconds = ask(program, SLIDE.format(tau0=tau0, mean=mean))
        found = document["sliding"]
        print(f"slide, μ {mean}, τ0 {tau0} s: mean {expected:.6f} m by integration, {slide.mean():.3f} by lives; here {found['mean']}; {seconds:.1f} s")
        for limit in (0.1, 0.3):
            share = np.mean(slide > limit)
            print(f"    P(S > {limit} m) {share:.4f} ± {math.sqrt(share * (1 - share) / lives):.4f};  {[x for x in found['exceedance'] if str(limit) in str(x)]}")
        print(f"    quantiles {[(q, float(np.quantile(slide, q))) for q in (0.5, 0.9, 0.95, 0.99)]};  {found['quantiles']}", flush=True)


COVERED = [
    "two normals", "small, lognormal", "Gumbel", "case 2, SRO+", "below C", "several modes hold", "k' below -1", "correlated by rank",
    "force and its height", "all four", "all four, small", "friction, P", "friction, sea", "four", "four, correlated", "four, small", "six",
]  # fmt: skip


def coverage(program, seeds):
    """How often the answer lies in the interval of 95 %, by method and by what is asked, for probabilities above 1e-6."""
    problems = [p for p in [*plane_problems(), *caisson_problems()] if p.name in COVERED]
    by_method, by_mode, by_problem = {}, {}, {}
    for problem in problems:
        few = len(problem.order) <= 3
        p, error = problem.integrate() if few else problem.sobol(15)
        names = ["RE", *MODES[1:], "several"]
        expected = {n: x for n, x in zip(names, p) if x > 1e-6 and 1 - x > 1e-6}
        expected["not rest"] = p[1:7].sum() + p[8]
        for method in ("sobol", "importance", "monte-carlo"):
            for seed in range(1, seeds + 1):
                try:
                    document, _ = ask(program, problem.case(), "--method", method, "--seed", str(seed), "--samples", "131072")
                except RuntimeError as error:
                    print(problem.name, method, error)
                    break
                found = answers(document, None)
                for name, x in expected.items():
                    got, low, high = found[name]
                    inside = low <= x <= high
                    for table, key in ((by_method, (method, "not rest" if name == "not rest" else "modes")), (by_mode, (method, name)), (by_problem, (problem.name, method))):
                        table.setdefault(key, []).append((inside, (got - x) / max(high - low, 1e-300) * 2, low <= x, x <= high))
        for key, hits in by_problem.items():
            if key[0] == problem.name:
                print(f"{key[0]:32s} {key[1]:12s} {100 * np.mean([h[0] for h in hits]):6.1f} % of {len(hits)}; mean (answer - reference)/half-width {np.mean([h[1] for h in hits]):+.2f}", flush=True)
    for table in (by_method, by_mode):
        for key, hits in sorted(table.items()):
            print(f"{key[0]:12s} {key[1]:10s} {100 * np.mean([h[0] for h in hits]):6.1f} % of {len(hits)}; {sum(not h[2] for h in hits)} below, {sum(not h[3] for h in hits)} above")


if __name__ == "__main__":
    program = sys.argv[1]
    what = sys.argv[2:] or ["plane", "caisson", "life", "slide"]
    if what[0] == "coverage":
        coverage(program, int(what[1]))
        sys.exit()
    if "slide" in what:
        slides(program)
        what = [name for name in what if name != "slide"]
    for name in what:
        compare(program, {"plane": plane_problems, "caisson": caisson_problems, "life": life_problems}[name]())
