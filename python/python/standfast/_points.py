"""Points of the k-μ plane as users have them: named, or a cloud."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._advice import Advice, called
from ._arrow import ArrowTable
from ._inputs import read
from ._standfast import StandfastError
from ._tables import frame_of
from ._types import Arrow, PandasFrame, PolarsFrame, PyarrowTable

#: ``{name: (k, μ)}``; or a cloud without names: rows of (k, μ), or a table with the columns ``k`` and ``mu``, which may have
#: names in a column ``name``.
Points: TypeAlias = "Mapping[str, tuple[float, float]] | ArrayLike | PandasFrame | PolarsFrame | PyarrowTable | Arrow"

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
        if any(map(_is_missing, points)):
            raise StandfastError(f"points has a point of the name {next(filter(_is_missing, points))!r}; expected a text")
        pairs = [_pair(f"point {name!r}", at) for name, at in points.items()]
        return Marks(np.array(pairs, dtype=np.float64).reshape(-1, 2), [str(name) for name in points])
    if any(hasattr(points, way) for way in ("collect", "compute")):
        raise TypeError(f"points is a {type(points).__name__}, which has no values yet; collect or compute it first")
    if (frame := frame_of(points, Advice("Diagram.plot"))) is not None:
        return _table(points, frame.kind)
    places = _numbers("points", points)
    if places.ndim != 2 or places.shape[1] != 2:
        hint = "; np.column_stack([k, mu]) makes one of two columns" if len(places) == 2 else ""
        raise StandfastError(f"points is an array of shape {places.shape}; {_EXPECTED}{hint}")
    return Marks(places, [])


def _pair(what: str, at: Any) -> NDArray[np.float64]:
    pair = _numbers(what, at)
    if pair.shape != (2,):
        hint = "; many points without names are an array with rows of (k, μ)" if pair.ndim else ""
        raise StandfastError(f"{what} is {at!r}; expected (k, μ){hint}")
    return pair


def _table(table: Any, kind: str) -> Marks:
    if hasattr(table, "read_all"):  # a reader of pyarrow can be read once
        table = table.read_all()
    # A relation of DuckDB has every name, as a column of its own: what it is called by others is asked of them only.
    found: list[Any] | None
    if kind == "pyarrow":
        found = list(table.schema.names)
    elif isinstance(table, ArrowTable):
        found = table.column_names
    else:
        found = list(table.columns) if hasattr(table, "columns") else None
    for column in ("k", "mu"):
        if found is not None and found.count(column) != 1:
            what = "no column" if column not in found else f"{found.count(column)} columns"
            raise StandfastError(f"points is a table with {what} {column!r} (it has {', '.join(map(str, found))}); {_EXPECTED}")
    columns, missing = read("Diagram.plot", ("k", "mu"), (table, None)).arrays()
    if missing is not None:
        raise StandfastError(f"points has no k or no mu in row {int(np.argmax(missing))}; expected numbers, without what is missing")
    names = _names(table, kind) if found is not None and "name" in found else []
    for row, name in enumerate(names):
        if _is_missing(name):
            raise StandfastError(f"points has no name in row {row}; expected one for each, or no column 'name'")
    return Marks(np.ascontiguousarray(np.column_stack(columns), dtype=np.float64), [str(name) for name in names])


def _names(table: Any, kind: str) -> list[Any]:
    """The column of names."""
    column = table["name"] if kind != "arrow" or isinstance(table, ArrowTable) else None
    if column is None:
        raise TypeError(f"points is a {called(table)} with names; expected a DataFrame of pandas or polars, or a pyarrow Table")
    if kind == "pandas":
        if column.ndim != 1:
            raise StandfastError("points is a table with several columns 'name'; expected one")
        return [None if missing else name for name, missing in zip(column, column.isna())]
    return list(column.to_list() if kind == "polars" else column.to_pylist())


def _is_missing(name: object) -> bool:
    return name is None or isinstance(name, float) and name != name


def _numbers(what: str, values: Any) -> NDArray[np.float64]:
    if np.ma.is_masked(values):
        raise StandfastError(f"{what} is masked in part; expected numbers, without what is missing: np.ma.compress_rows(...)")
    array = np.asarray(values)
    if array.dtype.kind not in "iuf" and not (array.dtype.kind == "O" and all(map(_is_number, array.flat))):
        raise TypeError(f"{what} holds {array.dtype} such as {array.ravel().tolist()[0]!r}; expected numbers")
    return np.ascontiguousarray(array, dtype=np.float64)


def _is_number(value: object) -> bool:
    return not isinstance(value, (str, bytes, bool)) and (hasattr(value, "__float__") or hasattr(value, "__index__"))
