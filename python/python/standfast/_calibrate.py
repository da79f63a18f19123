"""Calibration: the factor of a code with which several cases come nearest to a reliability index."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from statistics import NormalDist
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from ._assess import case_text
from ._design import Case, design
from ._probability import probability
from ._progress import shown
from ._standfast import StandfastError
from ._types import Progress

#: Indices beyond it are taken as this: what next to never, or always, happens must not outweigh all others.
_MOST = 8.0
#: Steps of the search between two factors.
_FINE = 200


@dataclass(frozen=True)
class Calibration:
    """The factor with which cases come nearest to an index: :func:`calibrate`'s answer.

    Attributes:
        criterion: what the cases are designed by.
        beta: the index asked for.
        factor: the factor with the least weighted mean of (β − beta)².
        spread: the root of that mean.
        factors: those tried, rising; shape (n,).
        names: of the cases.
        values: the value of ``vary`` by which each case has each factor, as texts with units; shape (cases, n).
        betas: the index of each case with each factor, from −8 to 8; shape (cases, n). Of a life that of the upper end of the interval of its probability.
        needed: the factor with which each case has the index; NaN where it lies beyond those tried; shape (cases,).
        weights: of the cases, which add up to 1; shape (cases,).
    """

    criterion: str
    beta: float
    factor: float
    spread: float
    factors: NDArray[np.float64]
    names: list[str]
    values: list[list[str]]
    betas: NDArray[np.float64]
    needed: NDArray[np.float64]
    weights: NDArray[np.float64]

    def __str__(self) -> str:
        lines = [
            f"With {self.criterion} = {self.factor:.3f} the {len(self.names)} cases come nearest to β = {self.beta:g}; they miss it by {self.spread:.2f} on average.",
            "",
        ]
        width = max(len(name) for name in self.names)
        lines.append(f"{'case':{width}}  β with it  {self.criterion} for β")
        for name, betas, needed in zip(self.names, self.betas, self.needed, strict=True):
            of_case = f"{needed:.3f}" if np.isfinite(needed) else "not among those tried"
            lines.append(f"{name:{width}}  {np.interp(self.factor, self.factors, betas):9.2f}  {of_case}")
        return "\n".join(lines)


def calibrate(
    cases: Sequence[Case] | Mapping[str, Case],
    *,
    beta: float,
    criterion: str = "SF_sliding",
    factors: Sequence[float] | NDArray[np.float64] = (1.0, 1.2, 1.4, 1.6, 1.8, 2.0),
    vary: str = "width",
    of: Literal["event", "life"] = "event",
    weights: Sequence[float] | None = None,
    progress: Progress = None,
) -> Calibration:
    """Which factor of a code gives several cases a reliability index?

    Each case is designed by the criterion alone, once with each factor, as :func:`design` does: the least value of ``vary`` that has it. With that value its index is
    found, −Φ⁻¹ of the probability that the body does not rest. The factor chosen makes the weighted mean of (β − ``beta``)² over the cases least; between
    those tried β is taken as straight.

    Args:
        cases: paths or dicts of cases with a table ``[random]``; or a dict of them by their names.
        beta: the index asked for.
        criterion: what is at least the factor: ``"SF_sliding"``, ``"SF_overturning_net"``, ``"ground_factor"``, ``"load_factor"``.
        factors: those tried, rising, two or more.
        vary: the number by which a case is made safer, as :func:`design` calls it.
        of: ``"event"``, one event or year, or ``"life"``, over the ``years`` of the case.
        weights: of the cases, how often they are built; all alike, if it is left out.
        progress: ``True`` for a bar (with ``standfast[progress]``), or a function of the parts done and all parts.

    Raises:
        CaseError, StandfastError: as :func:`design` and :func:`probability`, with a note on the case.
        StandfastError: for factors, weights or cases that are too few, or not numbers.

    A block that slides where F > μ W, with a normal force, has β = (factor − 1)/cov, so that with covs of 0.1 and 0.2 the factor is 1 + 0.12 β:

    >>> def block(cov):
    ...     return {
    ...         "body": {"width": 8, "height": 2, "density": 2400, "friction": 0.5},
    ...         "load": [{"name": "push", "force": 150e3, "elevation": 0.5}],
    ...         "random": {"load.push.force": {"normal": {"mean": 150e3, "cov": cov}}},
    ...     }
    >>> found = calibrate({"steady": block(0.1), "wild": block(0.2)}, beta=3, factors=[1.2, 1.4, 1.6])
    >>> round(found.factor, 2)
    1.36
    """
    names, all_cases = _named(cases)
    tried = _rising(factors)
    shares = _shares(weights, len(names))
    if of not in ("event", "life"):
        raise StandfastError(f'of is {of!r}; expected "event" or "life"')
    values: list[list[str]] = []
    betas = np.empty((len(names), len(tried)))
    with shown(progress, "cases") as told:
        for place, (name, case) in enumerate(zip(names, all_cases, strict=True)):
            try:
                designed = [_designed(case, vary, criterion, float(factor)) for factor in tried]
                betas[place] = _betas(case, vary, designed, beta, of)
            except Exception as error:
                if sys.version_info >= (3, 11):
                    error.add_note(f"case {name!r} of the calibration")
                raise
            values.append(designed)
            if told is not None:
                told(place + 1, len(names))
    fine = np.concatenate([np.linspace(low, high, _FINE, endpoint=False) for low, high in zip(tried[:-1], tried[1:], strict=True)] + [tried[-1:]])
    curves = np.array([np.interp(fine, tried, curve) for curve in betas])
    misses = shares @ (curves - beta) ** 2
    best = int(np.argmin(misses))
    needed = np.array([_where(tried, curve, beta) for curve in betas])
    return Calibration(
        criterion=criterion,
        beta=beta,
        factor=float(fine[best]),
        spread=float(np.sqrt(misses[best])),
        factors=tried,
        names=names,
        values=values,
        betas=betas,
        needed=needed,
        weights=shares,
    )


def _named(cases: Sequence[Case] | Mapping[str, Case]) -> tuple[list[str], list[Case]]:
    is_one = isinstance(cases, (str, os.PathLike)) or isinstance(cases, Mapping) and "random" in cases
    if isinstance(cases, Mapping) and cases and not is_one:
        return list(cases), list(cases.values())
    if is_one:
        raise StandfastError("cases is one case; expected several in a list, or in a dict by their names")
    names = [os.fspath(case) if isinstance(case, (str, os.PathLike)) else f"case {place + 1}" for place, case in enumerate(cases)]
    if not names:
        raise StandfastError("cases is empty; expected one or more")
    return names, list(cases)


def _rising(factors: Sequence[float] | NDArray[np.float64]) -> NDArray[np.float64]:
    tried = np.asarray(factors, dtype=np.float64)
    if tried.ndim != 1 or len(tried) < 2 or not np.all(np.isfinite(tried)) or not np.all(np.diff(tried) > 0):
        raise StandfastError(f"factors is {factors!r}; expected two or more numbers, rising")
    return tried


def _shares(weights: Sequence[float] | None, count: int) -> NDArray[np.float64]:
    shares = np.ones(count) if weights is None else np.asarray(weights, dtype=np.float64)
    if shares.shape != (count,) or not np.all(np.isfinite(shares)) or np.any(shares < 0) or shares.sum() == 0:
        raise StandfastError(f"weights is {weights!r}; expected {count} numbers, one for each case, not below zero")
    of_all: NDArray[np.float64] = shares / shares.sum()
    return of_all


def _designed(case: Case, vary: str, criterion: str, factor: float) -> str:
    """The least value that has a factor, not rounded, with its unit."""
    found = design(case, vary=vary, target=f"{criterion}={factor!r}")
    value = found.found.boundary
    return f"{value!r} {found.unit}" if found.unit else f"{value!r}"


def _betas(case: Case, vary: str, values: list[str], beta: float, of: str) -> list[float]:
    if of == "life":
        whole = _read(case)
        case = {**whole, "criteria": {**whole.get("criteria", {}), "beta_life": beta}}
    found = probability(case, over={vary: values})
    assert found.fragility is not None, "it was asked for along a number"
    points = found.fragility.points
    if of == "event":
        return [_index(point.not_rest.probability) for point in points]
    asked = ([check for check in point.criteria or [] if check.name == "beta_life"][0] for point in points)
    return [_number(check.value) for check in asked]


def _read(case: Case) -> dict[str, Any]:
    """The keys of a case."""
    if isinstance(case, Mapping):
        return dict(case)
    if sys.version_info < (3, 11):
        raise StandfastError(f"{os.fspath(case)} is a file, of whose life Python 3.10 cannot ask; expected a dict of its keys")
    import tomllib

    return tomllib.loads(case_text(case)[1])


def _number(value: float | str | None) -> float:
    """An index within what is told; that of what always moves is not there."""
    return -_MOST if value is None else _MOST if isinstance(value, str) else min(max(value, -_MOST), _MOST)


def _index(chance: float) -> float:
    """−Φ⁻¹, within what is told."""
    return -NormalDist().inv_cdf(min(max(chance, NormalDist().cdf(-_MOST)), 1 - 1e-16))


def _where(tried: NDArray[np.float64], curve: NDArray[np.float64], beta: float) -> float:
    """The first factor at which a curve reaches the index."""
    if curve[0] > beta:
        return float("nan")
    for place in np.flatnonzero(curve[1:] >= beta)[:1]:
        low, high = curve[place], curve[place + 1]
        share = (beta - low) / (high - low) if high > low else 0.0
        return float(tried[place] + share * (tried[place + 1] - tried[place]))
    return float("nan")
