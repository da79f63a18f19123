"""Directions: a body on a plan under loads that are turned."""

from __future__ import annotations

import functools
import os
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _standfast
from ._arrow import ArrowTable
from ._assess import case_text
from ._drawn import Drawn
from ._warnings import mind
from .plans import DirectionsDocument, SituationDirections


class Directions(DirectionsDocument, Drawn):
    """A case over all horizontal directions: :func:`directions`' answer.

    ``print`` shows the text of ``standfast directions``; the keys of its JSON document, which ``docs/directions.schema.json`` describes, are
    attributes. Of the only situation its keys are attributes as well: ``worst_direction_deg``, ``load_factor``, ``record``, ... A notebook
    shows the figure; ``figures[0].save("directions.png")`` writes it.
    """

    _what = "this answer over directions"

    @property
    def situations(self) -> list[SituationDirections]:
        """The situations, each a set of loads that act together."""
        return [SituationDirections(situation) for situation in self._document["situations"]]

    @functools.cached_property
    def table(self) -> ArrowTable:
        """Every direction, a row each: ``deg``, ``load_factor`` where the body leaves rest, ``mode`` in which it does, the horizontal over the
        vertical force there, ``x`` to the right and ``z`` away from the viewer, and ``tipping_load_factor``; with ``situation`` where there
        are several."""
        several = len(self._document["situations"]) > 1
        rows = [(of["name"], row) for of in self._document["situations"] for row in of["directions"]]
        at = [row["at"] or [np.nan, np.nan] for _, row in rows]
        columns: dict[str, list[str] | NDArray[np.float64]] = {
            **({"situation": [name or "" for name, _ in rows]} if several else {}),
            "deg": np.array([row["deg"] for _, row in rows], float),
            "load_factor": np.array([row["load_factor"] for _, row in rows], float),
            "mode": [" ".join(row["mode"]) for _, row in rows],
            "x": np.array([x for x, _ in at], float),
            "z": np.array([z for _, z in at], float),
            "tipping_load_factor": np.array([row["tipping_load_factor"] for _, row in rows], float),
        }
        made = [_standfast.make_array(name, values, None, None, {}) for name, values in columns.items()]
        return ArrowTable(_standfast.make_table(made))

    def __getattr__(self, name: str) -> Any:
        situations = self._document["situations"] if not name.startswith("_") else []
        if len(situations) == 1 and name in situations[0]:
            return getattr(SituationDirections(situations[0]), name)
        raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")

    def __repr__(self) -> str:
        return f"<Directions of {self.title or 'a case'}: {self.summary.answer}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return Directions, (self._text, self._json, self._csv, self._drawn)


def directions(case: str | os.PathLike[str] | Mapping[str, object], *, step: float = 5.0) -> Directions:
    """Turn the loads of a case through all horizontal directions.

    The case has a base seen from above: ``[base]``, or a load or an earthquake of any direction. All variable loads turn together about the
    vertical through the centre of mass. Directions are those of the force on the body in degrees: 0 to the left, 90 away from the viewer of
    the section, 180 to the right.

    Args:
        case: the path of a case file, or what it holds as a dict, as for :func:`assess`.
        step: step between the directions, degrees; it divides 360.

    Raises:
        CaseError, StandfastError, OSError: as :func:`assess`; and if the case lies in the plane of its section, or nothing turns.

    >>> body = {"width": 2, "length": 2, "height": 6, "mass": 1e4, "friction": 0.7}
    >>> found = directions({"body": body, "load": [{"force": 98100, "elevation": 3, "direction_deg": 45}]}, step=45)
    >>> [round(row.load_factor, 6) for row in found.situations[0].directions[:2]]
    [0.333333, 0.471405]
    """
    text, document, table, drawn, warnings = _standfast.directions(*case_text(case), step)
    mind(warnings)
    return Directions(text, document, table, drawn)
