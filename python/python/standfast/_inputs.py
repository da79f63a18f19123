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
from collections.abc import Callable, Iterator, Mapping, Sequence
from decimal import Decimal
from typing import Any, NoReturn

import numpy as np
from numpy.typing import NDArray

from . import _standfast
from ._frames import Arrays, Arrow, Form, Missing, Pandas, Point, Polars, Pyarrow

#: Where a table has the operands: a column's name, or a number that holds for all rows.
Map = Mapping[str, "str | float"]


class Operands:
    """What a function was given, told apart.

    Attributes:
        form: what makes the answer, see :mod:`standfast._frames`.
        shape: that of the answer; ``None`` for a stream whose length shows when it is read.
        table: an Arrow table and the places of the operands in it, for a function that reads it natively.
        columns: Arrow columns and floats, likewise.
    """

    def __init__(self, names: Sequence[str], form: Form) -> None:
        self.names = tuple(names)
        self.form = form
        self.table: tuple[Any, list[str | float]] | None = None
        self.columns: list[Any] | None = None
        self._read: list[tuple[NDArray[Any], Missing]] | None = None

    def arrays(self, *, together: bool = False) -> tuple[list[NDArray[Any]], Missing]:
        """The operands as numpy arrays of real numbers that the native module reads, and which points are missing.

        A missing value reads as 1; with ``together`` all operands of its point do, which copies them, for functions whose
        operands bound each other. The arrays are not broadcast: scalars have no axes. ``missing`` has the broadcast shape.
        """
        if self._read is None:
            self._read = self._from_arrow()
        arrays = [values for values, _ in self._read]
        masks = [mask for _, mask in self._read if mask is not None and mask.any()]
        if not masks:
            return arrays, None
        shape = broadcast(self.names, arrays)
        missing = np.zeros(shape, dtype=np.bool_)
        for mask in masks:
            missing |= mask
        if together:
            return [np.where(missing, 1.0, values) for values in arrays], missing
        filled = [values if mask is None else np.where(mask, 1.0, values) for values, mask in self._read]
        return filled, missing

    @property
    def shape(self) -> tuple[int, ...]:
        """That of the answer."""
        if self._read is None:
            self._read = self._from_arrow()
        return broadcast(self.names, [values for values, _ in self._read])

    def _from_arrow(self) -> list[tuple[NDArray[Any], Missing]]:
        if self.table is not None:
            table, places = self.table
            named = [(place, name) for place, name in zip(places, self.names) if isinstance(place, str)]
            read = iter(_standfast.read_table(table, named))
            return [next(read) if isinstance(place, str) else (np.asarray(place), None) for place in places]
        assert self.columns is not None
        return [
            (np.asarray(column), None) if isinstance(column, float) else _standfast.read_column(column, name)
            for column, name in zip(self.columns, self.names)
        ]


def read(
    function: str, names: Sequence[str], given: Sequence[object], map: Map | None = None, **wrong: object
) -> Operands:
    """Tells apart what a function was given.

    Args:
        function: its name in ``standfast``, for advice.
        names: of its operands.
        given: as many operands, or a table and ``None`` for the others.
        map: which column of the table holds what.

    Raises:
        TypeError: for what is no real number, or comes from a library whose objects have to be unwrapped by the caller;
            the error says how.
        ValueError: for lengths or indexes that differ, and for a wrong ``map``.
        KeyError: if a table lacks a column.
    """
    first, *others = given
    if others and all(value is None for value in others) and (kind := _table_kind(first, function)) is not None:
        return _table(function, names, first, kind, map)
    if map is not None:
        raise TypeError(f"map is for a table, given in place of {', '.join(names)}")
    missing = [name for name, value in zip(names, given) if value is None]
    if missing:
        raise TypeError(f"{', '.join(missing)} missing; expected {', '.join(names)}, or one table with these columns")
    if all(type(value) is float or type(value) is int for value in given):
        operands = Operands(names, Point())
        operands._read = [(_number(value, name), None) for value, name in zip(given, names)]
        return operands
    return _columns(function, names, given)


# Tables


def _table_kind(value: object, function: str) -> str | None:
    """Which library a table is of; ``None`` if the value is none."""
    if isinstance(value, (np.ndarray, int, float)):
        return None
    _refuse_lazy(value, "the table", function)
    for library, kinds in _TABLES.items():
        if _is(value, library, *kinds):
            return library
    if _is(value, "pandas", "Series") or _is(value, "polars", "Series") or _is(value, "pyarrow", "Array", "ChunkedArray"):
        return None
    if isinstance(value, _standfast.ArrowArray) or hasattr(value, "iloc"):
        return None
    return "arrow" if hasattr(value, "__arrow_c_stream__") or hasattr(value, "__arrow_c_array__") else None


_TABLES = {"pandas": ("DataFrame",), "polars": ("DataFrame",), "pyarrow": ("Table", "RecordBatch", "RecordBatchReader")}
_FORMS: dict[str, Callable[[], Form]] = {"polars": Polars, "pyarrow": Pyarrow, "arrow": Arrow}


def _table(function: str, names: Sequence[str], table: Any, kind: str, map: Map | None) -> Operands:
    places = _places(names, map, labels=kind == "pandas")
    if all(not isinstance(place, (str, tuple)) for place in places):
        raise ValueError("map names no column of the table, only numbers")
    if kind == "pandas":
        operands = Operands(names, Pandas(table.index))
        operands._read = [
            _series(pick(table, place, name), name) if isinstance(place, (str, tuple)) else (_number(place, name), None)
            for place, name in zip(places, names)
        ]
        return operands
    operands = Operands(names, _FORMS[kind]())
    operands.table = _exported(table) if kind == "polars" else table, places
    return operands


def _places(names: Sequence[str], map: Map | None, labels: bool) -> list[Any]:
    """Where a table has each operand."""
    if map is not None and not isinstance(map, Mapping):
        raise TypeError(f"map is a {type(map).__name__}; expected a dict of columns, as {{'{names[-1]}': 'friction'}}")
    map = {} if map is None else dict(map)
    unknown = [name for name in map if name not in names]
    if unknown:
        raise ValueError(f"map has the key {unknown[0]!r}; expected {', '.join(names)}")
    places: list[Any] = [map.get(name, name) for name in names]
    for i, (place, name) in enumerate(zip(places, names)):
        if isinstance(place, (int, float, np.integer, np.floating)) and not isinstance(place, bool):
            places[i] = float(place)
        elif not isinstance(place, str) and not (labels and isinstance(place, tuple)):
            raise TypeError(f"map gives {place!r} for {name}; expected the name of a column, or a number")
    return places


def pick(frame: Any, label: Any, name: str) -> Any:
    """The column of a DataFrame that holds an operand."""
    columns = frame.columns
    if label not in columns:
        _standfast.refuse_column(name, str(label), [str(column) for column in columns])
    column = frame[label]
    if column.ndim != 1:
        raise ValueError(f"the table has {column.shape[1]} columns {label!r}; expected one for {name}")
    return column


def _exported(frame: Any) -> Any:
    """A polars DataFrame whose columns of type Null hold nulls of Float64.

    polars gives the former a buffer that Arrow's interface has no place for (polars 2.1), so that not even the other columns
    could be read.
    """
    pl = sys.modules["polars"]
    return frame.cast({pl.Null: pl.Float64}) if pl.Null in frame.dtypes else frame


# Columns


class _Column:
    """An operand: numbers, or an Arrow object."""

    def __init__(
        self, kind: str, values: NDArray[Any] | None = None, mask: Missing = None, *, index: Any = None, arrow: Any = None
    ) -> None:
        self.kind, self.values, self.mask, self.index, self.arrow = kind, values, mask, index, arrow


def _columns(function: str, names: Sequence[str], given: Sequence[object]) -> Operands:
    columns = [_column(value, name, function) for value, name in zip(given, names)]
    kinds = {column.kind for column in columns}
    arrows = kinds & {"polars", "pyarrow", "arrow"}
    if "pandas" in kinds:
        if arrows:
            raise TypeError(
                f"{_listed(names, columns)}; expected columns of one library: polars and pyarrow have to_pandas(), "
                "and polars.from_pandas and pyarrow.array go the other way"
            )
        index = _common_index(names, columns)
        operands = Operands(names, Pandas(index))
        _check_lengths(names, columns, len(index))
    elif arrows:
        operands = Operands(names, _FORMS[arrows.pop() if len(arrows) == 1 else "arrow"]())
        if all(column.arrow is not None or _is_scalar(column) for column in columns):
            operands.columns = [_arrow_or_float(column) for column in columns]
            return operands
        for column, name in zip(columns, names):
            if column.arrow is not None:
                column.values, column.mask = _standfast.read_column(column.arrow, name)
        _check_lengths(names, columns, max(len(c.values) for c in columns if c.arrow is not None and c.values is not None))
    elif "masked" in kinds:
        operands = Operands(names, Arrays(masked=True))
    elif "array" in kinds:
        operands = Operands(names, Arrays())
    else:
        operands = Operands(names, Point())
    operands._read = [(column.values, column.mask) for column in columns if column.values is not None]
    return operands


def _is_scalar(column: _Column) -> bool:
    return column.values is not None and column.values.ndim == 0 and column.kind == "point"


def _arrow_or_float(column: _Column) -> Any:
    return column.arrow if column.values is None else float(column.values)


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
        at = next(i for i, (ours, theirs) in enumerate(zip(index, other)) if not _same(ours, theirs))
        raise ValueError(
            f"the indexes of {first} and {name} differ: at row {at}, {index[at]!r} and {other[at]!r}; expected Series of one "
            f"index. {first}.align({name}) matches the labels, .to_numpy() pairs rows by their place"
        )
    return index


def _same(one: object, other: object) -> bool:
    return bool(one == other) or (one != one and other != other)


def _check_lengths(names: Sequence[str], columns: Sequence[_Column], rows: int) -> None:
    """Beside columns of rows, arrays have as many; they are not broadcast."""
    for name, column in zip(names, columns):
        if column.values is not None and column.values.ndim > 0 and column.values.shape != (rows,):
            raise ValueError(f"{name} has the shape {column.values.shape} beside columns of {rows} rows; expected ({rows},)")


def _column(value: Any, name: str, function: str) -> _Column:
    """One operand, told apart."""
    if isinstance(value, np.ndarray):
        return _array(value, name)
    if type(value) is float or type(value) is int or isinstance(value, (np.integer, np.floating)):
        return _Column("point", _number(value, name))
    _refuse_lazy(value, name, function)
    if _is(value, "pandas", "Series"):
        return _Column("pandas", *_series(value, name), index=value.index)
    pd = sys.modules.get("pandas")
    if pd is not None and isinstance(value, (pd.Index, pd.api.extensions.ExtensionArray)):
        values, mask = _series(pd.Series(value), name)
        return _Column("array" if mask is None else "masked", values, mask)
    if _is(value, "polars", "Series"):
        return _Column("polars", arrow=_exported(value.to_frame()).to_series())
    if _is(value, "pyarrow", "Array", "ChunkedArray"):
        return _Column("pyarrow", arrow=value)
    for library, kinds in _TABLES.items():
        if _is(value, library, *kinds):
            _refuse_table(value, name, function)
    if hasattr(value, "dimensionality") and hasattr(value, "to_base_units"):
        return _column(_magnitude(value, name), name, function)
    if hasattr(value, "__arrow_c_array__") or hasattr(value, "__arrow_c_stream__"):
        return _Column("arrow", arrow=value)
    if hasattr(value, "iloc"):
        raise TypeError(f"{name} is a {_called(value)}, whose rows have labels; expected a pandas Series or an array")
    if isinstance(value, (list, tuple)):
        _check_leaves(value, name, ())
        try:
            return _array(np.asarray(value), name)
        except ValueError:
            raise ValueError(f"{name} is a ragged list; expected rows of one length") from None
    if isinstance(value, (Mapping, str, bytes, Iterator, set, frozenset)) or value is None:
        raise TypeError(f"{name} is {_shown(value)}; expected a number, an array or a column")
    array = np.asarray(value)
    return _array(array, name)


def _number(value: Any, name: str) -> NDArray[Any]:
    try:
        return np.asarray(value, dtype=np.float64)
    except OverflowError:
        raise ValueError(f"{name} is {value}; expected a number that float64 holds") from None


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
            raise TypeError(f"{name} is a {_called(array)} with the unit {unit}; expected numbers without unit, a ratio")
        array = np.asarray(array)
    return _Column(kind, _real(array, mask, name), mask)


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
        _check_leaf(array[index], name, index)
    try:
        return array.astype(np.float64)
    except (TypeError, ValueError, OverflowError) as error:
        raise TypeError(f"{name} holds objects that are no real numbers: {error}") from None


def _check_leaves(items: Sequence[Any], name: str, index: tuple[int, ...]) -> None:
    for i, item in enumerate(items):
        kind = type(item)
        if kind is float or kind is int:
            continue
        if isinstance(item, (list, tuple)):
            _check_leaves(item, name, (*index, i))
        elif not isinstance(item, np.ndarray):
            _check_leaf(item, name, (*index, i))


def _check_leaf(item: Any, name: str, index: tuple[int, ...]) -> None:
    real = isinstance(item, (numbers.Real, Decimal, np.floating, np.integer)) or hasattr(item, "__float__")
    if real and not isinstance(item, (bool, np.bool_, np.complexfloating)) and not hasattr(item, "dimensionality"):
        return
    at = "" if not index else f" at index {index[0] if len(index) == 1 else index}"
    advice = "; what is missing is masked in a masked array, or null in pandas and polars" if item is None else ""
    raise TypeError(f"{name} is {_shown(item)}{at}; expected real numbers{advice}")


def _series(series: Any, name: str) -> tuple[NDArray[Any], Missing]:
    """The numbers of a pandas Series, and what it calls missing: NaN, NA and None alike."""
    pd = sys.modules["pandas"]
    dtype = series.dtype
    if isinstance(dtype, pd.CategoricalDtype):
        return _series(series.astype(dtype.categories.dtype), name)
    values: NDArray[Any]
    if isinstance(dtype, np.dtype) and dtype.kind in _REAL:
        values = _real(series.to_numpy(), None, name)
        if dtype.kind != "f":
            return values, None
    elif dtype == object:
        missing = series.isna().to_numpy()
        values = _from_objects(series.to_numpy(), missing, name)
        return values, missing if missing.any() else None
    elif pd.api.types.is_numeric_dtype(dtype) and not pd.api.types.is_bool_dtype(dtype) and dtype.kind != "c":
        values = series.to_numpy(dtype=np.float64, na_value=np.nan)
    else:
        raise TypeError(f"{name} is a pandas Series of dtype {dtype}; expected real numbers, as float64")
    # The sum is NaN if a value is, and costs a fraction of a mask.
    with np.errstate(invalid="ignore", over="ignore"):
        if not np.isnan(values.sum()):
            return values, None
    missing = np.isnan(values)
    return values, missing if missing.any() else None


# Who has to be unwrapped by the caller


def _is(value: object, library: str, *kinds: str) -> bool:
    """Whether the value is of a class of a library, which is not imported for the question."""
    module = sys.modules.get(library)
    if module is None:
        return False
    return any(isinstance(value, found) for kind in kinds if isinstance(found := getattr(module, kind, None), type))


def _is_xarray(value: Any) -> bool:
    return _is(value, "xarray", "DataArray", "Dataset", "Variable", "DataTree")


def _called(value: object) -> str:
    return f"{type(value).__module__.split('.')[0]} {type(value).__name__}"


def _shown(value: object) -> str:
    if value is None:
        return "None"
    text = repr(value)
    return f"{text if len(text) <= 40 else text[:37] + '...'}, a {type(value).__name__}"


def _refuse_lazy(value: Any, name: str, function: str) -> None:
    """Refuses what would be loaded whole, or lose its labels, and says what to call."""
    call = f"standfast.{function}"
    if _is_xarray(value):
        lazy = value.__dask_graph__() is not None if hasattr(value, "__dask_graph__") else False
        several = "" if function == "classify" else ", output_core_dims=[[]] * number_of_results"
        how = f"xarray.apply_ufunc({call}, ...{several}), which matches the names"
        if lazy:
            how = f"xarray.apply_ufunc({call}, ...{several}, dask='parallelized', output_dtypes=[...]), which stays lazy"
        what = "an xarray Dataset" if _is(value, "xarray", "Dataset") else "an xarray object"
        raise TypeError(f"{name} is {what}, whose dimensions have names; expected an array. Call {how}")
    if hasattr(value, "__dask_graph__"):
        if _is(value, "dask.array", "Array"):
            how = f"dask.array.map_blocks({call}, ..., dtype=...)"
        elif hasattr(value, "map_partitions") and getattr(value, "ndim", 0) == 2:
            how = f"frame.map_partitions({call})"
        elif hasattr(value, "map_partitions"):
            how = f"dask.dataframe.map_partitions({call}, gamma, ...)"
        else:
            how = "its compute()"
        raise TypeError(f"{name} is a lazy {_called(value)}, which would be loaded into this process whole. Call {how}")
    if _is(value, "polars", "LazyFrame"):
        raise TypeError(f"{name} is a polars LazyFrame, which holds no values yet. Call .collect()")
    if _is(value, "polars", "Expr"):
        raise TypeError(
            f"{name} is a polars expression, which holds no values. Call {call}(frame), or give columns of a DataFrame"
        )
    if _is(value, "pyarrow.dataset", "Dataset"):
        raise TypeError(
            f"{name} is a pyarrow Dataset, which holds no values yet. Call .to_table(), or .scanner().to_reader() to read it batch "
            "by batch"
        )
    if _is(value, "pyarrow.dataset", "Scanner"):
        raise TypeError(f"{name} is a pyarrow Scanner, which holds no values yet. Call .to_table(), or .to_reader() to read by batch")


def _refuse_table(value: object, name: str, function: str) -> NoReturn:
    raise TypeError(
        f"{name} is a {_called(value)}, a whole table; expected a column of it. standfast.{function} takes a table alone, with "
        "map={...} where its columns have other names"
    )


def _magnitude(quantity: Any, name: str) -> Any:
    """The number of a pint quantity without dimension, as 1 in the unit it is a ratio of."""
    if quantity.dimensionality:
        raise TypeError(f"{name} is a quantity in {quantity.units}; expected a number without unit, a ratio")
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
