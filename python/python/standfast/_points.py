"""Points of the k-μ plane as users have them: named, or a cloud."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

#: ``{name: (k, μ)}``; or a cloud without names: rows of (k, μ), or a table with the columns ``k`` and ``mu``, which may have
#: names in a column ``name``.
Points: TypeAlias = "Mapping[str, tuple[float, float]] | ArrayLike | Any"

_EXPECTED = "expected {name: (k, μ)}, an array with rows of (k, μ), or a table with the columns k and mu"


class Marks(NamedTuple):
    """Points to be marked."""

    #: Rows of (k, μ): first those with names.
    places: NDArray[np.float64]
    names: list[str]

    @property
    def cloud(self) -> NDArray[np.float64]:
        """The points without names."""
        return self.places[len(self.names) :]


def marks(points: Points | None) -> Marks:
    """Points in the one form that is drawn."""
    if points is None:
        return Marks(np.empty((0, 2)), [])
    if isinstance(points, Mapping):
        pairs = [_pair(f"point {name!r}", at) for name, at in points.items()]
        return Marks(np.array(pairs, dtype=np.float64).reshape(-1, 2), [str(name) for name in points])
    if any(hasattr(points, way) for way in ("collect", "compute")):
        raise TypeError(f"points is a {type(points).__name__}, which has no values yet; collect or compute it first")
    if hasattr(points, "columns") or hasattr(points, "column_names"):
        return _table(points)
    places = _numbers("points", points)
    if places.ndim != 2 or places.shape[1] != 2:
        hint = "; np.column_stack([k, mu]) makes one of two columns" if len(places) == 2 else ""
        raise ValueError(f"points is an array of shape {places.shape}; {_EXPECTED}{hint}")
    return Marks(places, [])


def _pair(what: str, at: Any) -> NDArray[np.float64]:
    pair = _numbers(what, at)
    if pair.shape != (2,):
        hint = f" (many points without names: {_EXPECTED.split(', ', 1)[1]})" if pair.ndim else ""
        raise ValueError(f"{what} is {at!r}; expected (k, μ){hint}")
    return pair


def _table(table: Any) -> Marks:
    found = list(getattr(table, "column_names", None) or table.columns)
    for column in ("k", "mu"):
        if found.count(column) != 1:
            what = "no column" if column not in found else f"{found.count(column)} columns"
            raise ValueError(f"points is a table with {what} {column!r} (it has {', '.join(map(str, found))}); {_EXPECTED}")
    columns = [_numbers(f"column {name!r} of points", table[name]) for name in ("k", "mu")]
    names = [str(name) for name in np.asarray(table["name"])] if "name" in found else []
    return Marks(np.ascontiguousarray(np.column_stack(columns)), names)


def _numbers(what: str, values: Any) -> NDArray[np.float64]:
    array = np.asarray(values)
    if array.dtype.kind not in "iuf" and not (array.dtype.kind == "O" and all(map(_is_number, array.flat))):
        raise TypeError(f"{what} holds {array.dtype} such as {array.ravel().tolist()[0]!r}; expected numbers")
    return np.ascontiguousarray(array, dtype=np.float64)


def _is_number(value: object) -> bool:
    return not isinstance(value, (str, bytes, bool)) and (hasattr(value, "__float__") or hasattr(value, "__index__"))
