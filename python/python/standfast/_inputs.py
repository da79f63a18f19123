"""What an operand may be, and which kind of answer it asks for.

A function of named operands hands what it was given to :func:`read`::

    operands = read("limit_states", NAMES, (gamma, k_prime, k, mu), map)
    with called(operands, threads, on_error, progress) as (how, form):
        arrays, missing = operands.arrays()                    # numpy arrays of real numbers, ready to broadcast
        values = _standfast.limit_states(arrays, ..., how)     # {"slide": array of operands.shape, ...}
    return form.table(values, missing, point=LimitState, arrays=LimitStates)

and gets back what the table in docs/how-to/python.md says: a scalar for scalars, a Series for Series, and so on. What one operand may be
stands in :mod:`standfast._columns`, what a table in :mod:`standfast._tables`.
"""

from __future__ import annotations

import numbers
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence, Set
from contextlib import contextmanager
from decimal import Decimal
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from . import _standfast
from ._advice import Advice, is_of, shown
from ._columns import Column, Numbers, column_of, number_of, same, series_of
from ._frames import Arrays, Form, Missing, Pandas, Point, plain_label
from ._tables import FORMS, Frame, Label, frame_of, pick, places_of
from ._progress import shown as told
from ._run import Run, run
from ._standfast import StandfastError
from ._types import Map, OnError, Progress, Side

_T = TypeVar("_T")
_FLOAT = np.dtype(np.float64)


@contextmanager
def called(
    operands: Operands, threads: int | None, on_error: OnError, progress: Progress, to: Side = "left", unit: str = "points"
) -> Iterator[tuple[Run, Form]]:
    """How a call over many points is run, and what makes its answer: a bar is shown meanwhile, and an error says where the operands
    have the point that it is about."""
    with told(progress, unit) as shown_to:
        how = run(threads, on_error, shown_to, to)
        try:
            yield how, operands.form.with_errors(how.null_errors)
        except ValueError as error:
            raise operands.form.placed(error) from None


class Operands:
    """What a function was given, told apart.

    Attributes:
        names: of the operands.
        form: what makes the answer, see :mod:`standfast._frames`.
        table: an Arrow table and the places of the operands in it, for a function that reads it natively; or ``None``.
        rows: how many the table has; ``None`` if it does not tell before it is read.
        columns: Arrow columns and floats, likewise.
    """

    def __init__(self, names: Sequence[str], form: Form) -> None:
        self.names = tuple(names)
        self.form = form
        self.table: tuple[Any, list[str | float]] | None = None
        self.rows: int | None = None
        self.columns: list[Any] | None = None
        self.numbers: list[Numbers] = []

    def arrays(self, *, together: bool = False) -> tuple[list[NDArray[Any]], Missing]:
        """The operands as numpy arrays of real numbers that the native module reads, and which points are missing.

        A missing value reads as 1; with ``together`` all operands of its point do, which copies them, for functions whose
        operands bound each other. The arrays are not broadcast: scalars have no axes. ``missing`` has the broadcast shape.
        """
        masks = [numbers.missing() for numbers in self._loaded()]
        missing = self._joined(masks)
        if missing is None:
            return [numbers.values for numbers in self.numbers], None
        if not together:
            return [
                numbers.values if mask is None else np.where(mask, 1.0, numbers.values)
                for numbers, mask in zip(self.numbers, masks)
            ], missing
        return [np.where(missing, 1.0, numbers.values) for numbers in self.numbers], missing

    def native(self, how: Run) -> tuple[list[NDArray[Any]], Missing, Run]:
        """As :meth:`arrays`, without a copy, for a function that takes a mask and may be told to read NaN as missing.

        What is missing may be any number.
        """
        if not any(numbers.nan or numbers.mask is not None for numbers in self._loaded()):
            return [numbers.values for numbers in self.numbers], None, how
        nan = any(numbers.nan for numbers in self.numbers)
        if nan and all(n.nan or n.values.dtype.kind != "f" or not n.values.ndim and n.values == n.values for n in self.numbers):
            masks = [numbers.mask for numbers in self.numbers]
        else:
            nan, masks = False, [numbers.missing() for numbers in self.numbers]
        return [numbers.values for numbers in self.numbers], self._joined(masks), how._replace(nan_is_missing=nan)

    def streamed(
        self, of_table: Callable[[Any, Any, Any, Any], _T], of_columns: Callable[[Any, Any, Any], _T], asked: object, how: Run
    ) -> _T | None:
        """The answer of a function that reads tables and columns of Arrow natively; ``None`` if the operands are none."""
        if self.table is not None:
            return of_table(*self.table, asked, how._replace(total=self.rows))
        return None if self.columns is None else of_columns(self.columns, asked, how)

    @property
    def shape(self) -> tuple[int, ...]:
        """That of the answer."""
        return broadcast(self.names, [numbers.values for numbers in self._loaded()])

    def _joined(self, masks: Sequence[Missing]) -> Missing:
        known = [mask for mask in masks if mask is not None and mask.any()]
        if not known:
            return None
        missing = np.zeros(self.shape, dtype=np.bool_)
        for mask in known:
            missing |= mask
        return missing

    def _loaded(self) -> list[Numbers]:
        """The operands' numbers, read from Arrow if they have not been."""
        if self.numbers:
            return self.numbers
        if self.table is not None:
            table, places = self.table
            named = [(place, name) for place, name in zip(places, self.names) if isinstance(place, str)]
            read = iter(_standfast.read_table(table, named, self.names))
            self.numbers = [
                Numbers(*next(read)) if isinstance(place, str) else number_of(place, name)
                for place, name in zip(places, self.names)
            ]
        elif self.columns is not None:
            self.numbers = [
                number_of(column, name) if isinstance(column, float) else Numbers(*_standfast.read_column(column, name))
                for column, name in zip(self.columns, self.names)
            ]
            _check_lengths(self.names, self.numbers, max(len(n.values) for n in self.numbers if n.values.ndim))
        return self.numbers


def read(
    function: str,
    names: Sequence[str],
    given: Sequence[object],
    map: Map | None = None,
    *,
    result: str | None = None,
    optional: tuple[str, object] | None = None,
) -> Operands:
    """Tells apart what a function was given.

    Args:
        function: its name in ``standfast``, for advice.
        names: of its operands.
        given: as many operands, or a table and ``None`` for the others.
        map: which column of the table holds what.
        result: one of the columns of its answer, if that has several, for advice.
        optional: an operand more, which may be ``None``: its name and what was given. A table may have it in a column of its name.

    Raises:
        TypeError: for what is not a real number, or comes from a library whose objects have to be unwrapped by the caller;
            the error says how.
        StandfastError: for lengths or indexes that differ, and for a wrong ``map``.
        KeyError: if a table lacks a column.
    """
    if optional is not None and (optional[1] is not None or any(value is None for value in given)):
        names, given, map = _with(names, given, map, Advice(function, result), *optional)
    if map is None and are_plain(given):
        operands = Operands(names, Point())
        operands.numbers = [number_of(value, name) for value, name in zip(given, names)]
        return operands
    # What is looked at again and again in loops: columns of float64, read as they are.
    if map is None and all(type(value) is np.ndarray and value.dtype == _FLOAT and value.ndim for value in given):
        operands = Operands(names, Arrays())
        operands.numbers = [Numbers(value) for value in given]  # type: ignore[arg-type]
        return operands
    advice = Advice(function, result)
    first, *others = given
    if others and all(value is None for value in others) and (frame := frame_of(first, advice)) is not None:
        return _table(names, frame, map)
    if map is not None:
        raise TypeError(f"map is for a table, given in place of {', '.join(names)}")
    missing = [name for name, value in zip(names, given) if value is None]
    if missing:
        said = _unpacked(first, function, len(names))
        raise TypeError(f"{', '.join(missing)} missing; expected {', '.join(names)}, or one table with these columns{said}")
    return _columns(names, given, advice)


def _with(
    names: Sequence[str], given: Sequence[object], map: Map | None, advice: Advice, name: str, value: object
) -> tuple[Sequence[str], Sequence[object], Map | None]:
    """Operands with one more, if it is given, by itself, by ``map`` or by a table's column of its name."""
    first, *others = given
    if not all(other is None for other in others) or (frame := frame_of(first, advice)) is None:
        return (names, given, map) if value is None else ([*names, name], [*given, value], map)
    if value is None and not (isinstance(map, Mapping) and name in map) and name not in frame.names:
        return names, given, map
    if value is not None:
        if isinstance(value, (bool, np.bool_)) or not isinstance(value, (numbers.Real, Decimal)):
            raise TypeError(f"{name} is {shown(value)} beside a table; expected a number, or a column of it by map={{'{name}': …}}")
        if isinstance(map, Mapping) and name in map:
            raise TypeError(f"{name} is given twice, by itself and by map")
        map = {**(map or {}), name: value}  # type: ignore[dict-item]
    return [*names, name], [*given, None], map


def _unpacked(first: object, function: str, count: int) -> str:
    """How to give one by one what has come as a whole."""
    if isinstance(first, Mapping):
        return f"; unpack a dict: standfast.{function}(**columns)"
    if is_of(first, "pandas", "Series"):
        return f"; unpack a row: standfast.{function}(**row)"
    if isinstance(first, np.ndarray) and first.dtype.names:
        return f"; unpack the fields: standfast.{function}(**{{name: points[name] for name in points.dtype.names}})"
    if isinstance(first, np.ndarray) and first.ndim == 2 and first.shape[1] == count:
        return f"; unpack the columns of an array: standfast.{function}(*points.T)"
    if isinstance(first, list) and first and isinstance(first[0], Mapping):
        return f"; make a table of records: standfast.{function}(pandas.DataFrame(records))"
    return ""


def are_plain(given: Iterable[object]) -> bool:
    """Whether operands are Python's own numbers."""
    for value in given:
        if type(value) is not float and type(value) is not int:
            return False
    return True


def chosen(columns: Sequence[str] | None, known: Sequence[str]) -> list[str]:
    """The columns to compute, in the order asked for; all that are known if none are.

    Raises:
        TypeError, StandfastError: for what is not a list of known names, each once.
    """
    if columns is None:
        return list(known)
    names = listed(columns, f"of {', '.join(known)}")
    for i, name in enumerate(names):
        if name not in known:
            near = _standfast.closest(str(name), list(known))
            meant = f"did you mean {near!r}? There are" if near else "expected"
            raise StandfastError(f"columns has {name!r}; {meant} {', '.join(known)}")
        if name in names[:i]:
            raise StandfastError(f"columns has {name!r} twice; expected it once")
    if not names:
        raise StandfastError(f"columns is empty; expected some of {', '.join(known)}")
    return names


def listed(columns: object, known: str) -> list[Any]:
    """The items of ``columns``, in their order.

    Args:
        known: what there is to compute, in words of the error.

    Raises:
        TypeError: for what has no order or is not a list.
    """
    if isinstance(columns, (str, Mapping, Set)) or not isinstance(columns, Iterable):
        said = "; which column of a table holds what is said by map={...}" if isinstance(columns, Mapping) else ""
        raise TypeError(f"columns is {shown(columns)}; expected a list of what to compute, {known}{said}")
    return list(columns)


def _table(names: Sequence[str], frame: Frame, map: Map | None) -> Operands:
    table, pandas = frame.value, frame.kind == "pandas"
    places = places_of(names, map, table.columns if pandas else None)
    if all(type(place) is float for place in places):
        raise StandfastError("map names no column of the table, only numbers")
    operands = Operands(names, frame.form)
    if pandas:
        operands.numbers = [
            series_of(pick(table, place.value, name, names), name) if isinstance(place, Label) else number_of(place, name)
            for place, name in zip(places, names)
        ]
    else:
        operands.table, operands.rows = (frame.native, places), frame.rows
    return operands


def _columns(names: Sequence[str], given: Sequence[object], advice: Advice) -> Operands:
    columns = [column_of(value, name, advice) for value, name in zip(given, names)]
    kinds = {column.kind for column in columns}
    arrows = kinds & set(FORMS)
    if arrows:
        if "pandas" in kinds:
            raise TypeError(
                f"{_listed(names, columns)}; expected columns of one library: polars and pyarrow have to_pandas(), "
                "and polars.from_pandas and pyarrow.array go the other way"
            )
        operands = Operands(names, FORMS[arrows.pop() if len(arrows) == 1 else "arrow"]())
        if kinds & {"array", "masked"}:
            operands.numbers = [
                column.read(name) for column, name in zip(columns, names)
            ]
            rows = next(len(n.values) for n, column in zip(operands.numbers, columns) if column.arrow is not None)
            _check_lengths(names, operands.numbers, rows)
        else:
            operands.columns = [float(c.numbers.values) if c.numbers is not None else c.arrow for c in columns]
        return operands
    if "pandas" in kinds:
        operands = Operands(names, Pandas(_common_index(names, columns)))
    else:
        operands = Operands(names, Arrays("masked" in kinds) if kinds & {"array", "masked"} else Point())
    operands.numbers = [column.numbers for column in columns if column.numbers is not None]
    if isinstance(operands.form, Pandas):
        _check_lengths(names, operands.numbers, len(operands.form.index))
    return operands


def _listed(names: Sequence[str], columns: Sequence[Column]) -> str:
    said = {"pandas": "a pandas Series", "polars": "a polars Series", "pyarrow": "a pyarrow array", "arrow": "an Arrow array"}
    return ", ".join(f"{name} is {said[column.kind]}" for name, column in zip(names, columns) if column.kind in said)


def check_indexes(given: Mapping[str, object]) -> None:
    """That Series of pandas, among what a dict has, have one index."""
    series = {name: value for name, value in given.items() if is_of(value, "pandas", "Series")}
    if series:
        _common_index(list(series), [Column("pandas", index=value.index) for value in series.values()])  # type: ignore[attr-defined]


def _common_index(names: Sequence[str], columns: Sequence[Column]) -> Any:
    (first, index), *others = [(name, c.index) for name, c in zip(names, columns) if c.index is not None]
    for name, other in others:
        if other is index or other.equals(index):
            continue
        if len(other) != len(index):
            raise StandfastError(f"{first} has {len(index)} rows and {name} {len(other)}; expected Series of one index")
        at = next((i for i, (ours, theirs) in enumerate(zip(index, other)) if not same(ours, theirs)), None)
        if at is None:
            continue
        raise StandfastError(
            f"the indexes of {first} and {name} differ: at row {at}, {_label(index[at])} and {_label(other[at])}; expected Series of "
            f"one index. {first}.align({name}) matches the labels, .to_numpy() pairs rows by their place"
        )
    return index


def _label(label: object) -> str:
    return repr(plain_label(label))


def _check_lengths(names: Sequence[str], columns: Sequence[Numbers], rows: int) -> None:
    """Beside columns of rows, arrays have as many; they are not broadcast."""
    for name, (values, *_) in zip(names, columns):
        if values.ndim > 0 and values.shape != (rows,):
            raise StandfastError(f"{name} has the shape {values.shape} beside columns of {rows} rows; expected ({rows},)")


def broadcast(names: Sequence[str], arrays: Sequence[NDArray[Any]]) -> tuple[int, ...]:
    """The common shape by numpy's rules."""
    try:
        return np.broadcast_shapes(*(array.shape for array in arrays))
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in zip(names, arrays))
        raise StandfastError(
            f"these shapes do not broadcast together: {shapes}; expected each axis to have one length, or 1"
        ) from None
