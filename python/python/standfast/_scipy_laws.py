"""Distributions of scipy.stats as laws of a table ``[random]``."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from ._standfast import StandfastError

#: Standard normals at which a law that has no name here is tabulated: a cubic between them is off by some 1e-8 of a deviation.
_NORMALS = np.arange(-9 * 64, 9 * 64 + 1) / 64
#: The most values of a discrete law.
_MOST_VALUES = 10_000


def is_distribution(value: object) -> bool:
    """Whether this is a frozen distribution of ``scipy.stats``, or one of its newer kind with ``icdf``."""
    is_frozen = hasattr(value, "dist") and hasattr(value, "ppf") and hasattr(value, "isf")
    return is_frozen or hasattr(value, "icdf") and hasattr(value, "iccdf")


def law_of(value: Any, where: str) -> dict[str, Any]:
    """The law of a distribution: by its parameters where a law here has them, or by its quantiles."""
    dist = getattr(value, "dist", None)
    if dist is None:
        return _tabulated(value.icdf, value.iccdf, where)
    if hasattr(value, "pmf"):
        return _discrete(value, where)
    shapes, location, scale = dist._parse_args(*value.args, **value.kwds)
    numbers = [_number(number, where) for number in (*shapes, location, scale)]
    made = _BY_NAME.get(getattr(dist, "name", ""))
    law = made(*numbers) if made is not None else None
    return _tabulated(value.ppf, value.isf, where) if law is None else law


def _number(value: Any, where: str) -> float:
    if np.size(value) != 1:
        raise StandfastError(f"{where} is a distribution with an array of parameters; expected one with numbers")
    return float(np.asarray(value).item())


def _lognormal(shape: float, location: float, scale: float) -> dict[str, Any] | None:
    if location != 0:
        return None
    mean = scale * math.exp(0.5 * shape * shape)
    return {"lognormal": {"mean": mean, "cov": math.sqrt(math.expm1(shape * shape))}}


def _truncated(a: float, b: float, location: float, scale: float) -> dict[str, Any]:
    law: dict[str, Any] = {"normal": {"mean": location, "sd": scale}}
    for name, end in (("lower", a), ("upper", b)):
        if math.isfinite(end):
            law[name] = location + end * scale
    return law


#: Of each name what makes the law of its shapes, location and scale.
_BY_NAME: dict[str, Callable[..., dict[str, Any] | None]] = {
    "norm": lambda m, s: {"normal": {"mean": m, "sd": s}},
    "lognorm": _lognormal,
    "truncnorm": _truncated,
    "gumbel_r": lambda m, s: {"gumbel": {"mode": m, "scale": s}},
    "weibull_min": lambda c, m, s: {"weibull": {"scale": s, "shape": c, "location": m}},
    "genextreme": lambda c, m, s: {"gev": {"location": m, "scale": s, "shape": -c}},
    "uniform": lambda m, s: {"uniform": {"from": m, "to": m + s}},
    "triang": lambda c, m, s: {"triangular": {"from": m, "mode": m + c * s, "to": m + s}},
    "beta": lambda a, b, m, s: {"beta": {"alpha": a, "beta": b, "from": m, "to": m + s}},
    "gamma": lambda a, m, s: {"gamma": {"shape": a, "scale": s, "location": m}},
    "expon": lambda m, s: {"exponential": {"scale": s, "location": m}},
    "genpareto": lambda c, m, s: {"gpd": {"location": m, "scale": s, "shape": c}},
}


def _tabulated(below: Callable[[Any], Any], above: Callable[[Any], Any], where: str) -> dict[str, Any]:
    shares = np.array([0.5 * math.erfc(abs(z) / math.sqrt(2)) for z in _NORMALS])
    with np.errstate(all="ignore"):
        values = np.where(_NORMALS < 0, below(shares), above(shares)).astype(float)
    normals, values = _NORMALS[np.isfinite(values)], values[np.isfinite(values)]
    # Towards an end of the law numbers are no longer told apart.
    rises = np.concatenate([[True], values[1:] > np.maximum.accumulate(values)[:-1]]) if len(values) else np.zeros(0, bool)
    if rises.sum() < 2:
        raise StandfastError(f"{where} is a distribution without quantiles that rise; expected one that is continuous")
    return {"quantiles": {"normals": normals[rises].tolist(), "values": values[rises].tolist()}}


def _discrete(value: Any, where: str) -> dict[str, Any]:
    first, last = value.support()
    middle = float(value.median())
    # What lies beyond is less likely than rounding.
    first = first if math.isfinite(first) else _beyond(middle, -1, value.cdf)
    last = last if math.isfinite(last) else _beyond(middle, 1, value.sf)
    if last - first > _MOST_VALUES:
        raise StandfastError(f"{where} is a distribution of {last - first + 1:.0f} values; expected {_MOST_VALUES} at most")
    values = np.arange(first, last + 1)
    shares = value.pmf(values)
    kept = shares > 0
    return {"discrete": {"values": values[kept].tolist(), "probabilities": (shares[kept] / shares[kept].sum()).tolist()}}


def _beyond(middle: float, sign: int, tail: Callable[[float], Any]) -> float:
    """A value of a discrete distribution beyond which there is next to nothing."""
    reach = 1.0
    while reach < 2 * _MOST_VALUES and tail(middle + sign * reach) > 1e-17:
        reach *= 2
    return float(middle + sign * reach)
