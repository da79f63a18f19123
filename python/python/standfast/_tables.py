"""A table of another library: what its columns are called, how many rows it has, and what kind of answer it asks for."""

from __future__ import annotations

import numbers
from collections.abc import Callable, Hashable, Mapping, Sequence
from decimal import Decimal
from typing import Any, NamedTuple

import numpy as np

from . import _standfast
from ._advice import Advice, is_of, short
from ._arrow import ArrowArray
from ._columns import TABLES, exported, number_of, same, speaks_arrow
from ._frames import Arrow, Form, Pandas, Polars, Pyarrow
from ._standfast import StandfastError
from ._types import Map

#: What makes the answers to Arrow objects.
FORMS: dict[str, Callable[[], Arrow]] = {"polars": Polars, "pyarrow": Pyarrow, "arrow": Arrow}


class Frame(NamedTuple):
    """A table, with what library it is of: pandas, polars, pyarrow, or any that speaks Arrow."""

    value: Any
    kind: str

    @property
    def form(self) -> Form:
        """What makes the answer."""
        return Pandas(self.value.index) if self.kind == "pandas" else FORMS[self.kind]()

    @property
    def names(self) -> list[str]:
        """The names of the columns, where it tells them without being read."""
        if self.kind in ("pandas", "polars"):
            return [str(name) for name in self.value.columns]
        return [str(name) for name in column_names(self.value) or ()]

    @property
    def rows(self) -> int | None:
        """How many rows it has; ``None`` where it does not tell. A relation of DuckDB would count by running its query."""
        return len(self.value) if self.kind in ("pandas", *TABLES) and hasattr(self.value, "__len__") else None

    @property
    def native(self) -> Any:
        """What the native module reads, of all but pandas."""
        return exported(self.value) if self.kind == "polars" else self.value


def frame_of(value: object, advice: Advice) -> Frame | None:
    """A table, if the value is one."""
    if isinstance(value, (np.ndarray, int, float)):
        return None
    advice.refuse_lazy(value, "the table")
    for library, kinds in TABLES.items():
        if is_of(value, library, *kinds):
            return Frame(value, library)
    if is_of(value, "polars", "Series") or is_of(value, "pyarrow", "Array", "ChunkedArray"):
        return None
    if isinstance(value, ArrowArray) or hasattr(value, "iloc"):
        return None
    return Frame(value, "arrow") if speaks_arrow(value) else None


def column_names(table: Any) -> Sequence[object] | None:
    """The names of the columns of a table; ``None`` where it does not tell them without being read."""
    # pyarrow's tables; pandas', polars' and DuckDB's; pyarrow's readers, which iterating would empty.
    schema = getattr(table, "schema", None)
    for names in (getattr(table, "column_names", None), getattr(table, "columns", None), getattr(schema, "names", None)):
        if names is not None and not callable(names):
            return list(names)
    return None


class Label(NamedTuple):
    """The label of a column of a DataFrame, which may be a number."""

    value: Any


def places_of(names: Sequence[str], map: Map | None, labels: Any) -> list[Any]:
    """Where a table has each operand: the name of a column, or a float that holds for all rows.

    Of pandas, which labels columns by what it likes, it is a :class:`Label` of ``labels`` or a float.
    """
    if map is not None and not isinstance(map, Mapping):
        raise TypeError(f"map is a {type(map).__name__}; expected a dict of columns, as {{'{names[-1]}': 'friction'}}")
    named: dict[str, Any] = {} if map is None else dict(map)
    unknown = [name for name in named if name not in names]
    if unknown:
        raise StandfastError(f"map has the key {unknown[0]!r}; expected {', '.join(names)}")
    places = [named.get(name, name) for name in names]
    for i, (place, name) in enumerate(zip(places, names)):
        if labels is not None and (isinstance(place, (str, tuple)) or _is_label(place, labels)):
            places[i] = Label(place)
        elif isinstance(place, (numbers.Real, Decimal)) and not isinstance(place, (bool, np.bool_)):
            places[i] = float(number_of(place, name).values)
        elif not isinstance(place, str):
            raise TypeError(f"map gives {short(repr(place))} for {name}; expected the name of a column, or a number")
    return places


def _is_label(place: Any, labels: Any) -> bool:
    """Whether a DataFrame has a column of this label. A label 2 is not the number 2.0, which can so be said beside it."""
    if isinstance(place, (bool, np.bool_)) or place is None or not isinstance(place, Hashable):
        return False
    whole = isinstance(place, numbers.Integral)
    return any(same(label, place) and isinstance(label, numbers.Integral) == whole for label in labels)


def pick(frame: Any, label: Any, name: str, names: Sequence[str] = ()) -> Any:
    """The column of a DataFrame that holds an operand; ``names`` are those of all operands, none of which is meant by another."""
    columns = frame.columns
    if label not in columns:
        _standfast.refuse_column(name, str(label), [str(column) for column in columns], names)
    column = frame[label]
    if column.ndim != 1:
        raise StandfastError(f"the table has {column.shape[1]} columns {label!r}; expected one for {name}")
    return column
