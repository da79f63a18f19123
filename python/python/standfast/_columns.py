"""One operand: a number, an array or a column of any library, as numpy's numbers or as it lies in Arrow.

Nothing else in the package looks at what libraries the operands are of. pandas, polars and pyarrow are found in ``sys.modules`` and
never imported: who has such an object has imported its library.
"""

from __future__ import annotations

import numbers
import sys
from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import _standfast
from ._advice import Advice, called, is_of, short, shown, unit_of
from ._frames import Missing
from ._standfast import StandfastError


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


class Column(NamedTuple):
    """An operand: numbers, or an Arrow object."""

    kind: str
    numbers: Numbers | None = None
    arrow: Any = None
    index: Any = None

    def read(self, name: str) -> Numbers:
        """Its numbers, read from Arrow if it lies there."""
        return self.numbers or Numbers(*_standfast.read_column(self.arrow, name))


#: The tables of libraries.
TABLES = {"pandas": ("DataFrame",), "polars": ("DataFrame",), "pyarrow": ("Table", "RecordBatch", "RecordBatchReader")}


def speaks_arrow(value: object) -> bool:
    return hasattr(value, "__arrow_c_array__") or hasattr(value, "__arrow_c_stream__")


def exported(frame: Any) -> Any:
    """A polars DataFrame whose columns of type Null hold nulls of Float64.

    polars gives the former a buffer that Arrow's interface has no place for (polars 2.1), so that not even the other columns
    could be read.
    """
    pl = sys.modules["polars"]
    return frame.cast({pl.Null: pl.Float64}) if pl.Null in frame.dtypes else frame


def column_of(value: Any, name: str, advice: Advice) -> Column:
    """One operand, told apart."""
    if type(value) is np.ndarray:
        return _array(value, name)
    if type(value) is float or type(value) is int or isinstance(value, (np.integer, np.floating)):
        return Column("point", number_of(value, name))
    if (unit := unit_of(value)) is not None:
        if unit.ratio is None:
            raise TypeError(f"{name} is {unit}; expected {advice.instead(name, unit)}")
        return column_of(unit.ratio, name, advice)
    if isinstance(value, np.ndarray):
        return _array(value, name)
    advice.refuse_lazy(value, name)
    if is_of(value, "pandas", "Series"):
        return Column("pandas", series_of(value, name), index=value.index)
    pd = sys.modules.get("pandas")
    if pd is not None and isinstance(value, (pd.Index, pd.api.extensions.ExtensionArray)):
        values, mask, nan = series_of(pd.Series(value), name)
        read = Numbers(values, Numbers(values, mask, nan).missing())
        return Column("array" if read.mask is None else "masked", read)
    if is_of(value, "polars", "Series"):
        return Column("polars", arrow=exported(value.to_frame()).to_series())
    if is_of(value, "pyarrow", "Array", "ChunkedArray"):
        return Column("pyarrow", arrow=value)
    if any(is_of(value, library, *kinds) for library, kinds in TABLES.items()):
        advice.refuse_table(value, name)
    if speaks_arrow(value):
        return Column("arrow", arrow=value)
    if hasattr(value, "iloc"):
        raise TypeError(f"{name} is a {called(value)}, whose rows have labels; expected a pandas Series or an array")
    if isinstance(value, (list, tuple)):
        _check_leaves(value, name, ())
        try:
            array = np.asarray(value)
        except ValueError:
            raise StandfastError(f"{name} is a ragged list; expected rows of one length") from None
        return _array(array, name)
    if isinstance(value, (Mapping, str, bytes, Iterator, set, frozenset)):
        raise TypeError(f"{name} is {shown(value)}; expected a number, an array or a column")
    return _array(np.asarray(value), name)


def number_of(value: Any, name: str) -> Numbers:
    try:
        return Numbers(np.asarray(value, dtype=np.float64))
    except OverflowError:
        raise StandfastError(f"{name} is {short(str(value))}; expected a number within float64") from None


_REAL = "fiu"


def _array(array: NDArray[Any], name: str) -> Column:
    """A numpy array; copied only if its type is none that the native module reads."""
    mask = None
    kind = "point" if array.ndim == 0 else "array"
    if isinstance(array, np.ma.MaskedArray):
        kind = "masked"
        mask = None if array.mask is np.ma.nomask else np.asarray(array.mask)
        array = array.data
    elif type(array) is not np.ndarray:
        array = np.asarray(array)
    return Column(kind, Numbers(_real(array, mask, name), mask))


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
        raise StandfastError(f"{name} holds what is not a number within float64: {error}") from None


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
    """Refuses an item of a list or of an array of objects that is not a real number."""
    if unit_of(item) is not None:
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


def same(one: object, other: object) -> bool:
    """Whether two labels are equal, as what is missing is to itself; pandas' NA answers no comparison."""
    if isinstance(one, tuple) and isinstance(other, tuple):
        return len(one) == len(other) and all(map(same, one, other))
    isna = sys.modules["pandas"].isna
    if isna(one) is True or isna(other) is True:
        return isna(one) is isna(other)
    return bool(one == other)
