"""What an operand may be, and which kind of answer it asks for.

A function of named operands hands what it was given to :func:`read`::

    operands = read("limit_states", NAMES, (gamma, k_prime, k, mu), map)
    arrays, missing = operands.arrays()                        # numpy arrays of real numbers, ready to broadcast
    values = _standfast.limit_states(arrays, ...)              # {"slide": array of operands.shape, ...}
    return operands.form.table(values, missing, point=LimitState, arrays=LimitStates)

and gets back what the table in docs/python.md says: a scalar for scalars, a Series for Series, and so on. Nothing else in
the package looks at what libraries the operands are of. pandas, polars and pyarrow are found in ``sys.modules`` and never
imported: who has such an object has imported its library.
"""

from __future__ import annotations

import numbers
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence, Set
from decimal import Decimal
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import _standfast
from ._advice import Advice, called, is_of, short, shown
from ._arrow import ArrowArray
from ._frames import Arrays, Arrow, Form, Missing, Pandas, Point, Polars, Pyarrow, plain_label
from ._types import Map


_FLOAT = np.dtype(np.float64)


class Numbers(NamedTuple):
    """An operand's numbers."""

    values: NDArray[Any]
    #: Which are missing; ``None`` if none is, or if ``nan`` tells.
    mask: Missing = None
    #: Whether NaN says that a value is missing, as in pandas.
    nan: bool = False

    def missing(self) -> Missing:
        """Which are missing; ``None`` if none is."""
        mask = self.mask
        if self.nan:
            # The sum is NaN if a value is, and costs a fraction of a mask.
            with np.errstate(invalid="ignore", over="ignore"):
                if np.isnan(self.values.sum()):
                    mask = np.isnan(self.values) if mask is None else mask | np.isnan(self.values)
        return mask if mask is not None and mask.any() else None


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

    def native(self) -> tuple[list[NDArray[Any]], Missing, bool]:
        """As :meth:`arrays`, without a copy, for a function that takes a mask and may read NaN as missing.

        What is missing may be any number. The last is whether NaN is to be read as missing.
        """
        if not any(numbers.nan or numbers.mask is not None for numbers in self._loaded()):
            return [numbers.values for numbers in self.numbers], None, False
        nan = any(numbers.nan for numbers in self.numbers)
        if nan and all(n.nan or n.values.dtype.kind != "f" or not n.values.ndim and n.values == n.values for n in self.numbers):
            masks = [numbers.mask for numbers in self.numbers]
        else:
            nan, masks = False, [numbers.missing() for numbers in self.numbers]
        return [numbers.values for numbers in self.numbers], self._joined(masks), nan

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
                Numbers(*next(read)) if isinstance(place, str) else _number(place, name)
                for place, name in zip(places, self.names)
            ]
        elif self.columns is not None:
            self.numbers = [
                _number(column, name) if isinstance(column, float) else Numbers(*_standfast.read_column(column, name))
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
        TypeError: for what is no real number, or comes from a library whose objects have to be unwrapped by the caller;
            the error says how.
        ValueError: for lengths or indexes that differ, and for a wrong ``map``.
        KeyError: if a table lacks a column.
    """
    if optional is not None and (optional[1] is not None or any(value is None for value in given)):
        names, given, map = _with(names, given, map, Advice(function, result), *optional)
    if map is None and are_plain(given):
        operands = Operands(names, Point())
        operands.numbers = [_number(value, name) for value, name in zip(given, names)]
        return operands
    # What is looked at again and again in loops: columns of float64, read as they are.
    if map is None and all(type(value) is np.ndarray and value.dtype == _FLOAT and value.ndim for value in given):
        operands = Operands(names, Arrays())
        operands.numbers = [Numbers(value) for value in given]  # type: ignore[arg-type]
        return operands
    advice = Advice(function, result)
    first, *others = given
    if others and all(value is None for value in others) and (kind := table_kind(first, advice)) is not None:
        return _table(names, first, kind, map)
    if map is not None:
        raise TypeError(f"map is for a table, given in place of {', '.join(names)}")
    missing = [name for name, value in zip(names, given) if value is None]
    if missing:
        said = f"; unpack a dict: standfast.{function}(**columns)" if isinstance(first, Mapping) else ""
        raise TypeError(f"{', '.join(missing)} missing; expected {', '.join(names)}, or one table with these columns{said}")
    return _columns(names, given, advice)


def _with(
    names: Sequence[str], given: Sequence[object], map: Map | None, advice: Advice, name: str, value: object
) -> tuple[Sequence[str], Sequence[object], Map | None]:
    """Operands with one more, if it is given, by itself, by ``map`` or by a table's column of its name."""
    first, *others = given
    if not all(other is None for other in others) or (kind := table_kind(first, advice)) is None:
        return (names, given, map) if value is None else ([*names, name], [*given, value], map)
    if value is None and not (isinstance(map, Mapping) and name in map) and name not in _columns_of(first, kind):
        return names, given, map
    if value is not None:
        if isinstance(value, (bool, np.bool_)) or not isinstance(value, (numbers.Real, Decimal)):
            raise TypeError(f"{name} is {shown(value)} beside a table; expected a number, or a column of it by map={{'{name}': …}}")
        if isinstance(map, Mapping) and name in map:
            raise TypeError(f"{name} is given twice, by itself and by map")
        map = {**(map or {}), name: value}  # type: ignore[dict-item]
    return [*names, name], [*given, None], map


def _columns_of(table: Any, kind: str) -> Sequence[object]:
    """The names of a table's columns, where it tells them without being read."""
    if kind in ("pandas", "polars"):
        return list(table.columns)
    schema = getattr(table, "schema", None)
    return list(getattr(schema, "names", None) or getattr(table, "columns", None) or ())


def are_plain(given: Iterable[object]) -> bool:
    """Whether operands are Python's own numbers."""
    for value in given:
        if type(value) is not float and type(value) is not int:
            return False
    return True


def chosen(columns: Sequence[str] | None, known: Sequence[str]) -> list[str]:
    """The columns to compute, in the order asked for; all that are known if none are.

    Raises:
        TypeError, ValueError: for what is no list of known names, each once.
    """
    if columns is None:
        return list(known)
    names = listed(columns, f"of {', '.join(known)}")
    for i, name in enumerate(names):
        if name not in known:
            near = _standfast.closest(str(name), list(known))
            meant = f"did you mean {near!r}? There are" if near else "expected"
            raise ValueError(f"columns has {name!r}; {meant} {', '.join(known)}")
        if name in names[:i]:
            raise ValueError(f"columns has {name!r} twice; expected it once")
    if not names:
        raise ValueError(f"columns is empty; expected some of {', '.join(known)}")
    return names


def listed(columns: object, known: str) -> list[Any]:
    """The items of ``columns``, in their order.

    Args:
        known: what there is to compute, in words of the error.

    Raises:
        TypeError: for what has no order or is no list.
    """
    if isinstance(columns, (str, Mapping, Set)) or not isinstance(columns, Iterable):
        said = "; which column of a table holds what is said by map={...}" if isinstance(columns, Mapping) else ""
        raise TypeError(f"columns is {shown(columns)}; expected a list of what to compute, {known}{said}")
    return list(columns)


# Tables


def table_kind(value: object, advice: Advice) -> str | None:
    """Which library a table is of; ``None`` if the value is none."""
    if isinstance(value, (np.ndarray, int, float)):
        return None
    advice.refuse_lazy(value, "the table")
    for library, kinds in _TABLES.items():
        if is_of(value, library, *kinds):
            return library
    if is_of(value, "polars", "Series") or is_of(value, "pyarrow", "Array", "ChunkedArray"):
        return None
    if isinstance(value, ArrowArray) or hasattr(value, "iloc"):
        return None
    return "arrow" if _speaks_arrow(value) else None


def _speaks_arrow(value: object) -> bool:
    return hasattr(value, "__arrow_c_array__") or hasattr(value, "__arrow_c_stream__")


_TABLES = {"pandas": ("DataFrame",), "polars": ("DataFrame",), "pyarrow": ("Table", "RecordBatch", "RecordBatchReader")}
FORMS: dict[str, Callable[[], Form]] = {"polars": Polars, "pyarrow": Pyarrow, "arrow": Arrow}


def _table(names: Sequence[str], table: Any, kind: str, map: Map | None) -> Operands:
    places = _places(names, map, table.columns if kind == "pandas" else None)
    if all(type(place) is float for place in places):
        raise ValueError("map names no column of the table, only numbers")
    if kind == "pandas":
        operands = Operands(names, Pandas(table.index))
        operands.numbers = [
            series_of(pick(table, place.value, name, names), name) if isinstance(place, _Label) else _number(place, name)
            for place, name in zip(places, names)
        ]
        return operands
    operands = Operands(names, FORMS[kind]())
    operands.table = exported(table) if kind == "polars" else table, places
    # A relation of DuckDB would count by running its query.
    operands.rows = len(table) if kind in ("polars", "pyarrow") and hasattr(table, "__len__") else None
    return operands


class _Label(NamedTuple):
    """The label of a column of a DataFrame, which may be a number."""

    value: Any


def _places(names: Sequence[str], map: Map | None, labels: Any) -> list[Any]:
    """Where a table has each operand: the name of a column, or a float that holds for all rows.

    Of pandas, which labels columns by what it likes, it is a :class:`_Label` of ``labels`` or a float.
    """
    if map is not None and not isinstance(map, Mapping):
        raise TypeError(f"map is a {type(map).__name__}; expected a dict of columns, as {{'{names[-1]}': 'friction'}}")
    named: dict[str, Any] = {} if map is None else dict(map)
    unknown = [name for name in named if name not in names]
    if unknown:
        raise ValueError(f"map has the key {unknown[0]!r}; expected {', '.join(names)}")
    places = [named.get(name, name) for name in names]
    for i, (place, name) in enumerate(zip(places, names)):
        if labels is not None and (isinstance(place, (str, tuple)) or _is_label(place, labels)):
            places[i] = _Label(place)
        elif isinstance(place, (numbers.Real, Decimal)) and not isinstance(place, (bool, np.bool_)):
            places[i] = float(_number(place, name).values)
        elif not isinstance(place, str):
            raise TypeError(f"map gives {place!r} for {name}; expected the name of a column, or a number")
    return places


def _is_label(place: Any, labels: Any) -> bool:
    """Whether a DataFrame has a column of this label. A label 2 is not the number 2.0, which can so be said beside it."""
    if isinstance(place, (bool, np.bool_)) or place is None:
        return False
    whole = isinstance(place, numbers.Integral)
    return any(_same(label, place) and isinstance(label, numbers.Integral) == whole for label in labels)


def pick(frame: Any, label: Any, name: str, names: Sequence[str] = ()) -> Any:
    """The column of a DataFrame that holds an operand; ``names`` are those of all operands, none of which is meant by another."""
    columns = frame.columns
    if label not in columns:
        _standfast.refuse_column(name, str(label), [str(column) for column in columns], names)
    column = frame[label]
    if column.ndim != 1:
        raise ValueError(f"the table has {column.shape[1]} columns {label!r}; expected one for {name}")
    return column


def exported(frame: Any) -> Any:
    """A polars DataFrame whose columns of type Null hold nulls of Float64.

    polars gives the former a buffer that Arrow's interface has no place for (polars 2.1), so that not even the other columns
    could be read.
    """
    pl = sys.modules["polars"]
    return frame.cast({pl.Null: pl.Float64}) if pl.Null in frame.dtypes else frame


# Columns


class _Column(NamedTuple):
    """An operand: numbers, or an Arrow object."""

    kind: str
    numbers: Numbers | None = None
    arrow: Any = None
    index: Any = None


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
                column.numbers or Numbers(*_standfast.read_column(column.arrow, name)) for column, name in zip(columns, names)
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


def _listed(names: Sequence[str], columns: Sequence[_Column]) -> str:
    said = {"pandas": "a pandas Series", "polars": "a polars Series", "pyarrow": "a pyarrow array", "arrow": "an Arrow array"}
    return ", ".join(f"{name} is {said[column.kind]}" for name, column in zip(names, columns) if column.kind in said)


def _common_index(names: Sequence[str], columns: Sequence[_Column]) -> Any:
    (first, index), *others = [(name, c.index) for name, c in zip(names, columns) if c.index is not None]
    for name, other in others:
        if other is index or other.equals(index):
            continue
        if len(other) != len(index):
            raise ValueError(f"{first} has {len(index)} rows and {name} {len(other)}; expected Series of one index")
        at = next((i for i, (ours, theirs) in enumerate(zip(index, other)) if not _same(ours, theirs)), None)
        if at is None:
            continue
        raise ValueError(
            f"the indexes of {first} and {name} differ: at row {at}, {_label(index[at])} and {_label(other[at])}; expected Series of "
            f"one index. {first}.align({name}) matches the labels, .to_numpy() pairs rows by their place"
        )
    return index


def _label(label: object) -> str:
    return repr(plain_label(label))


def _same(one: object, other: object) -> bool:
    """Whether two labels are equal, as what is missing is to itself; pandas' NA answers no comparison."""
    if isinstance(one, tuple) and isinstance(other, tuple):
        return len(one) == len(other) and all(map(_same, one, other))
    isna = sys.modules["pandas"].isna
    if isna(one) is True or isna(other) is True:
        return isna(one) is isna(other)
    return bool(one == other)


def _check_lengths(names: Sequence[str], columns: Sequence[Numbers], rows: int) -> None:
    """Beside columns of rows, arrays have as many; they are not broadcast."""
    for name, (values, *_) in zip(names, columns):
        if values.ndim > 0 and values.shape != (rows,):
            raise ValueError(f"{name} has the shape {values.shape} beside columns of {rows} rows; expected ({rows},)")


def column_of(value: Any, name: str, advice: Advice) -> _Column:
    """One operand, told apart."""
    if isinstance(value, np.ndarray):
        return _array(value, name)
    if type(value) is float or type(value) is int or isinstance(value, (np.integer, np.floating)):
        return _Column("point", _number(value, name))
    if is_of(value, "pint", "Quantity"):
        return column_of(_magnitude(value, name), name, advice)
    advice.refuse_lazy(value, name)
    if is_of(value, "pandas", "Series"):
        return _Column("pandas", series_of(value, name), index=value.index)
    pd = sys.modules.get("pandas")
    if pd is not None and isinstance(value, (pd.Index, pd.api.extensions.ExtensionArray)):
        values, mask, nan = series_of(pd.Series(value), name)
        read = Numbers(values, Numbers(values, mask, nan).missing())
        return _Column("array" if read.mask is None else "masked", read)
    if is_of(value, "polars", "Series"):
        return _Column("polars", arrow=exported(value.to_frame()).to_series())
    if is_of(value, "pyarrow", "Array", "ChunkedArray"):
        return _Column("pyarrow", arrow=value)
    if any(is_of(value, library, *kinds) for library, kinds in _TABLES.items()):
        advice.refuse_table(value, name)
    if _speaks_arrow(value):
        return _Column("arrow", arrow=value)
    if hasattr(value, "iloc"):
        raise TypeError(f"{name} is a {called(value)}, whose rows have labels; expected a pandas Series or an array")
    if isinstance(value, (list, tuple)):
        _check_leaves(value, name, ())
        try:
            array = np.asarray(value)
        except ValueError:
            raise ValueError(f"{name} is a ragged list; expected rows of one length") from None
        return _array(array, name)
    if isinstance(value, (Mapping, str, bytes, Iterator, set, frozenset)):
        raise TypeError(f"{name} is {shown(value)}; expected a number, an array or a column")
    return _array(np.asarray(value), name)


def _number(value: Any, name: str) -> Numbers:
    try:
        return Numbers(np.asarray(value, dtype=np.float64))
    except OverflowError:
        raise ValueError(f"{name} is {short(str(value))}; expected a number within float64") from None


_REAL = "fiu"


def _array(array: NDArray[Any], name: str) -> _Column:
    """A numpy array; copied only if its type is none that the native module reads."""
    mask = None
    kind = "point" if array.ndim == 0 else "array"
    if isinstance(array, np.ma.MaskedArray):
        kind = "masked"
        mask = None if array.mask is np.ma.nomask else np.asarray(array.mask)
        array = array.data
    elif type(array) is not np.ndarray:
        unit = getattr(array, "unit", None) or getattr(array, "units", None)
        if unit is not None:
            raise TypeError(f"{name} is a {called(array)} in {unit}; expected a ratio, which has no unit")
        array = np.asarray(array)
    return _Column(kind, Numbers(_real(array, mask, name), mask))


def _real(array: NDArray[Any], mask: Missing, name: str) -> NDArray[Any]:
    dtype = array.dtype
    if dtype.kind == "O":
        return _from_objects(array, mask, name)
    if dtype.kind not in _REAL:
        raise TypeError(f"{name} has dtype {dtype}; expected real numbers, as float64")
    if dtype.itemsize > 8 or not dtype.isnative:
        return array.astype(np.float64)
    return array


def _from_objects(array: NDArray[Any], mask: Missing, name: str) -> NDArray[np.float64]:
    """Python's numbers, as Decimal and Fraction."""
    if mask is not None:
        array = np.where(mask, 1.0, array)
    for index in np.ndindex(array.shape):
        check_leaf(array[index], name, index)
    try:
        return array.astype(np.float64)
    except (TypeError, ValueError, OverflowError) as error:
        raise ValueError(f"{name} holds what is no number within float64: {error}") from None


def _check_leaves(items: Sequence[Any], name: str, index: tuple[int, ...]) -> None:
    for i, item in enumerate(items):
        kind = type(item)
        if kind is float or kind is int:
            continue
        if isinstance(item, (list, tuple)):
            _check_leaves(item, name, (*index, i))
        elif isinstance(item, np.ndarray):
            if _array(item, name + _at((*index, i))).kind == "masked":
                raise TypeError(f"{name}{_at((*index, i))} is a masked array in a list; expected one masked array, numpy.ma.stack(...)")
        else:
            check_leaf(item, name, (*index, i))


def check_leaf(item: Any, name: str, index: tuple[int, ...]) -> None:
    """Refuses an item of a list or of an array of objects that is no real number."""
    if is_of(item, "pint", "Quantity"):
        raise TypeError(f"{name} is {shown(item)}{_at(index)}; expected real numbers, or one quantity, Quantity.from_list(...)")
    real = isinstance(item, (numbers.Real, Decimal)) or hasattr(item, "__float__")
    if real and not isinstance(item, (bool, np.bool_, np.complexfloating)) and not getattr(item, "ndim", 0):
        return
    advice = "; what is missing is masked in a masked array, or null in pandas and polars" if item is None else ""
    raise TypeError(f"{name} is {shown(item)}{_at(index)}; expected real numbers{advice}")


def _at(index: tuple[int, ...]) -> str:
    return "" if not index else f" at index {index[0] if len(index) == 1 else index}"


def series_of(series: Any, name: str) -> Numbers:
    """The numbers of a pandas Series, and what it calls missing: NaN, NA and None alike."""
    pd = sys.modules["pandas"]
    dtype = series.dtype
    if isinstance(dtype, pd.CategoricalDtype):
        kind = dtype.categories.dtype
        # Whole numbers have none that says missing.
        return series_of(series.astype(np.float64 if kind.kind in "iu" and series.hasnans else kind), name)
    if isinstance(dtype, pd.ArrowDtype):
        return Numbers(*_standfast.read_column(series.array.__arrow_array__(), name), nan=True)
    if isinstance(dtype, np.dtype) and dtype.kind in _REAL:
        return Numbers(_real(series.to_numpy(), None, name), nan=dtype.kind == "f")
    if dtype == object:
        missing = series.isna().to_numpy()
        return Numbers(_from_objects(series.to_numpy(), missing, name), missing)
    if pd.api.types.is_numeric_dtype(dtype) and not pd.api.types.is_bool_dtype(dtype) and dtype.kind != "c":
        return Numbers(series.to_numpy(dtype=np.float64, na_value=np.nan), nan=True)
    raise TypeError(f"{name} is a pandas Series of dtype {dtype}; expected real numbers, as float64")


def _magnitude(quantity: Any, name: str) -> Any:
    """The number of a pint quantity without dimension, as 1 in the unit it is a ratio of."""
    if quantity.dimensionality:
        raise TypeError(f"{name} is a quantity in {quantity.units}; expected a ratio, which has no unit")
    return quantity.to_base_units().magnitude


def broadcast(names: Sequence[str], arrays: Sequence[NDArray[Any]]) -> tuple[int, ...]:
    """The common shape by numpy's rules."""
    try:
        return np.broadcast_shapes(*(array.shape for array in arrays))
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in zip(names, arrays))
        raise ValueError(
            f"these shapes do not broadcast together: {shapes}; expected each axis to have one length, or 1"
        ) from None
