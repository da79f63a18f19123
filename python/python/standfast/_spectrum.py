"""Spectra: what many bodies do under one shaking, or one body under many."""

from __future__ import annotations

import functools
import os
from collections.abc import Mapping
from typing import Any, Literal, NamedTuple

import numpy as np

from . import _standfast
from ._advice import Advice
from ._arrow import ArrowTable
from ._assess import case_text
from ._drawn import Drawn
from ._named import units_of
from ._progress import shown
from ._ranges import Range, values_of
from ._records import check_unit, records_of
from ._run import Told, run
from ._simulate import folder_of
from ._standfast import StandfastError
from ._types import Array, Progress
from ._warnings import mind
from .simulations import SpectrumDocument

_ADVICE = Advice("spectrum")
#: What each kind goes over.
_OVER = {"rocking": ("size", "slenderness"), "newmark": ("ratio",), "overturning": ("scale",)}
_UNITS = {"size": "m", "left": "m", "right": "m", "max_slide": "m", "slide": "m", "max_theta": "rad"}


class Spectrum(SpectrumDocument, Drawn):
    """What many bodies do under one shaking: :func:`spectrum`'s answer.

    ``print`` shows the text of ``standfast spectrum``; the keys of its JSON document, which ``docs/spectrum.schema.json`` describes, are
    attributes, but for :attr:`points`, which is a table. A notebook shows the figure; ``figures[0].save("spectrum.png")`` writes it.
    """

    _what = "this spectrum"
    _si: bool

    def __init__(self, text: str, document: str, csv: str, drawn: list[tuple[str, str, str, _standfast._Kept]], si: bool) -> None:
        super().__init__(text, document, csv, drawn)
        vars(self).update(_si=si)

    @functools.cached_property
    def points(self) -> ArrowTable:
        """Every motion, a row each: of a rocking spectrum its block by ``size`` (half of the diagonal) and ``slenderness``, of Newmark's the
        ``ratio`` of yield acceleration to peak, of an overturning curve the ``scale`` of the shaking; and what becomes of it."""
        points = self._document["points"]
        columns = []
        for name in points[0]:
            values = [point[name] for point in points]
            metadata = {"unit": _UNITS[name]} if self._si and name in _UNITS else {}
            given = values if isinstance(values[0], str) else np.array(values)
            columns.append(_standfast.make_array(name, given, None, None, metadata))
        return ArrowTable(_standfast.make_table(columns))

    def __repr__(self) -> str:
        return f"<Spectrum {self.kind} of {self.title or 'a case'}: {len(self._document['points'])} motions>"

    def __reduce__(self) -> tuple[Any, ...]:
        return Spectrum, (self._text, self._json, self._csv, self._drawn, self._si)


class _Asked(NamedTuple):
    """What the native module is asked beside the case."""

    kind: str
    size: str | list[float] | None
    slenderness: str | list[float] | None
    ratio: str | list[float] | None
    scale: str | list[float] | None
    threads: int | None
    progress: Told | None


def spectrum(
    case: str | os.PathLike[str] | Mapping[str, object],
    kind: Literal["rocking", "newmark", "overturning"] = "rocking",
    *,
    size: Range | None = None,
    slenderness: Range | None = None,
    ratio: Range | None = None,
    scale: Range | None = None,
    base: Array | Mapping[Literal["horizontal", "vertical"], Array] | None = None,
    dt: float | Array | None = None,
    unit: Literal["m/s2", "g", "cm/s2"] | None = None,
    threads: int | None = None,
    progress: Progress = None,
) -> Spectrum:
    """What many bodies do under one shaking, or the body of a case under many.

    Args:
        case: as for :func:`simulate`, with a base that moves.
        kind: ``"rocking"``, uniform blocks over size and slenderness; ``"newmark"``, a block that can only slide, over its yield
            acceleration; ``"overturning"``, the body of the case over the strength of the shaking, which need not be monotone.
        size, slenderness: of a rocking spectrum half diagonals (m), at equal factors, and heights over widths: ``"1..8:41"``, from, to, and
            how many, or ``"1..8"``; or the values one by one, rising: a list, a tuple, an array, a Series, a DataArray of one dimension.
        ratio: of Newmark's yield accelerations over the peak of the shaking.
        scale: of an overturning curve factors on the shaking.
        base, dt, unit: as for :func:`simulate`.
        threads: how many threads to use; ``None`` for as many as there are processors. The answer is the same.
        progress: ``True`` for a bar (with ``standfast[progress]``), or a function of the parts done and all parts, thousandths of the work.

    Raises:
        StandfastError, TypeError, OSError: as :func:`simulate`; and for a range that is none, or does not belong to the kind.

    >>> block = {"block": {"b1": 1, "b2": 1, "d": 3, "mu_s": 50, "gravity": 1}}
    >>> found = spectrum(block, "overturning", scale="0.5..2:4", base=[0.5, 0.5], dt=4)
    >>> found.points.scale.to_pylist(), found.points.overturned.to_pylist()
    ([0.5, 1.0, 1.5, 2.0], [False, True, True, True])
    """
    if kind not in _OVER:
        raise StandfastError(f"kind is {kind!r}; expected one of {', '.join(map(repr, _OVER))}")
    ranges = {"size": size, "slenderness": slenderness, "ratio": ratio, "scale": scale}
    for name, given in ranges.items():
        if given is not None and name not in _OVER[kind]:
            raise TypeError(f"{name} does not belong to a spectrum of kind {kind!r}, which goes over {' and '.join(_OVER[kind])}")
    texts = {name: _range(given, name) for name, given in ranges.items()}
    records = records_of(base, dt, unit)
    with shown(progress, None) as told:
        asked = _Asked(kind, **texts, threads=run(threads).threads, progress=told)
        found = _standfast.spectrum((*case_text(case), folder_of(case), {}), records, asked)
    check_unit(records, unit, found[-1])
    answer = Spectrum(*found)
    mind((warning.name, warning.message) for warning in answer.warnings)
    return answer


def _range(given: Range | None, name: str) -> str | list[float] | None:
    unit = units_of(given)
    if unit is not None and unit not in (_UNITS.get(name), "1", "-", ""):
        raise StandfastError(f"{name} is in {unit!r} by its attribute units; expected {_UNITS.get(name, 'numbers without unit')}")
    return None if given is None else values_of(given, name, "a text as '0.5..2:41', from, to, and how many", _ADVICE)
