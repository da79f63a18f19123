"""The decision and the motions of the report in rational arithmetic, written from its equations.

Independent of the Rust code: no polynomial is shared with it. Numbers are exact; nothing is rounded until the end.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from random import Random


@dataclass(frozen=True)
class Coefficients:
    """a, b, c, d of mu*(k) = (a k + b)/(c k + d), (3.18-3.21, 4.42-4.45)."""

    a: Fraction
    b: Fraction
    c: Fraction
    d: Fraction


def coefficients(gamma: Fraction, k_prime: Fraction) -> Coefficients:
    return Coefficients(
        a=4 + gamma**2 - 3 * gamma**2 * k_prime, b=3 * gamma, c=3 * gamma * (1 + k_prime), d=1 + 4 * gamma**2
    )


def mode(gamma: float, k_prime: float, k: float, mu: float) -> str:
    """The symbol of the mode, as the report's maps resolve it."""
    g, h, k_, m = map(Fraction, (gamma, k_prime, k, mu))
    p = coefficients(g, h)
    line = g * (m + k_ * h)
    if h < -1:
        if m >= k_ and -k_ * g * (1 + h) <= 1:
            return "RE"
        if m < k_ and line >= -1:
            return "SL"
        return "RO'" if m * (p.d - p.c * k_) >= p.a * k_ - p.b else "SRO'-"
    if m >= k_ and k_ * g * (1 + h) <= 1:
        return "RE"
    if line < -1:
        return "SRO'-"
    if m < k_ and line <= 1:
        return "SL"
    if m * (p.c * k_ + p.d) >= abs(p.a * k_ + p.b):
        return "RO"
    return "SRO-" if p.a * k_ + p.b > 0 else "SRO+"


def others(gamma: float, k_prime: float, k: float, mu: float) -> set[str]:
    """The modes that satisfy every law beside :func:`mode`: Painleve's indeterminate set."""
    g, h, k_, m = map(Fraction, (gamma, k_prime, k, mu))
    if not -1 < h < 0:
        return set()
    p, q = coefficients(g, h), -h
    k_a = 1 / (g * (1 - q))
    k_b = (1 + g**2) / (3 * g * q)
    mu_star = (p.a * k_ + p.b) / (p.c * k_ + p.d)
    upper = 1 / g + k_ * q
    if not (k_ > k_a and k_ >= k_b and mu_star <= m <= upper):
        return set()
    inside = mu_star < m < upper
    return ({"RO", "SRO-"} if inside else {"RO"}) - {mode(gamma, k_prime, k, mu)}


def motion(symbol: str, gamma: float, k_prime: float, k: float, mu: float) -> dict[str, Fraction]:
    """Accelerations (in g, g/B), reactions (in m g) and xi (in B) of a mode, from its equations."""
    g, h, k_, m = map(Fraction, (gamma, k_prime, k, mu))
    p = coefficients(g, h)
    inertia = 4 * (1 + g**2)
    if symbol == "RE":
        x = y = t = Fraction(0)
        f_x, f_y, xi = k_, Fraction(1), -k_ * (1 + h) * g
    elif symbol == "SL":
        x, y, t = m - k_, Fraction(0), Fraction(0)
        f_x, f_y, xi = m, Fraction(1), -(m + k_ * h) * g
    elif symbol == "RO":
        t = 3 * (k_ * g * (1 + h) - 1) / inertia
        x, y, xi = -g * t, t, Fraction(-1)
        f_x, f_y = (p.a * k_ + p.b) / inertia, (p.c * k_ + p.d) / inertia
    elif symbol == "RO'":
        t = 3 * (1 + k_ * g * (1 + h)) / inertia
        x, y, xi = -g * t, -t, Fraction(1)
        f_x, f_y = (p.a * k_ - p.b) / inertia, (p.d - p.c * k_) / inertia
    elif symbol == "SRO-":
        t = 3 * (m * g - 1 + k_ * h * g) / (4 + g**2 - 3 * m * g)
        y, f_y, xi = t, 1 + t, Fraction(-1)
        f_x = m * f_y
        x = f_x - k_
    elif symbol == "SRO+":
        t = 3 * (k_ * h * g - m * g - 1) / (4 + g**2 + 3 * m * g)
        y, f_y, xi = t, 1 + t, Fraction(-1)
        f_x = -m * f_y
        x = f_x - k_
    else:
        assert symbol == "SRO'-", symbol
        t = 3 * (m * g + 1 + k_ * h * g) / (4 + g**2 + 3 * m * g)
        y, f_y, xi = -t, 1 - t, Fraction(1)
        f_x = m * f_y
        x = f_x - k_
    return {
        "x_ddot": x,
        "y_ddot": y,
        "theta_ddot": t,
        "f_x": f_x,
        "f_y": f_y,
        "xi": xi,
        "slip": x + g * t,
        "lift_o": y - t,
        "lift_o_prime": y + t,
    }


def points(count: int, seed: int) -> list[tuple[float, float, float, float]]:
    """Random points of every chapter; a third are small fractions, which meet boundaries exactly."""
    random = Random(seed)
    found = []
    for i in range(count):
        if i % 3 == 0:
            eighths = [random.randint(1, 32), random.randint(-16, 24), random.randint(0, 40), random.randint(0, 40)]
            point = [number / 8 for number in eighths]
        else:
            point = [
                random.uniform(0.05, 5),
                random.choice([random.uniform(-1, 1), random.uniform(-4, 4)]),
                random.choice([random.uniform(0, 3), random.uniform(0, 50)]),
                random.choice([random.uniform(0, 2), random.uniform(0, 30)]),
            ]
        found.append(tuple(point))
    return found
