"""Columns of cases: numbers, or texts with units."""

from __future__ import annotations

import sys
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _standfast
from ._advice import Advice, is_of, is_plain
from ._columns import check_leaf, column_of, series_of
from ._frames import Form, Missing, Pandas

_ADVICE = Advice("assess_table")


def array_of(value: Any, name: str, null: bool) -> tuple[NDArray[Any], Missing]:
    """The numbers of one entry of a dict as float64, or its texts as objects; with ``null``, what is not a value is no error here."""
    if isinstance(value, str):
        return np.array(_text(value, name, (), null), dtype=object), None
    if isinstance(value, (list, tuple)) and any(isinstance(part, str) for part in value):
        value = np.array(value, dtype=object)
    if isinstance(value, np.ndarray) and (value.dtype.kind in "UT" or value.dtype.kind == "O" and _has_text(value)):
        texts = [_text(part, name, index, null) for index, part in zip(np.ndindex(value.shape), value.ravel().tolist())]
        return np.array(texts, dtype=object).reshape(value.shape), None
    if is_of(value, "pandas", "Series"):
        given = column_of_cases(value, name, Pandas(value.index), null)
        return (np.array(given, dtype=object), None) if isinstance(given, list) else given
    numbers = column_of(value, name, _ADVICE).read(name)
    return np.asarray(numbers.values, dtype=np.float64), numbers.missing()


def _has_text(values: NDArray[Any]) -> bool:
    return any(isinstance(part, str) for part in values.flat)


def _text(value: Any, name: str, index: tuple[int, ...], null: bool, form: Form | None = None) -> str | None:
    """A text as it is, a number as a marked text; ``None`` for what is missing."""
    if isinstance(value, str):
        if is_plain(value) and not null:
            at = "" if not index else f" at {form.place(index[0])}" if form is not None else f" at index {index[0] if len(index) == 1 else index}"
            raise TypeError(f"{name} is {value!r}{at}, a text without a unit; expected a number, or a text with its unit")
        return value
    if value is None:
        return None
    check_leaf(value, name, index)
    return _standfast.NUMBER + repr(float(value))


def column_of_cases(column: Any, name: str, form: Form, null: bool) -> tuple[NDArray[Any], Missing] | list[str | None]:
    """The numbers or texts of a column of a DataFrame."""
    pd = sys.modules["pandas"]
    dtype = column.dtype
    if isinstance(dtype, pd.CategoricalDtype):
        dtype = dtype.categories.dtype
    if pd.api.types.is_string_dtype(dtype) or dtype == object:
        values = column.astype(object).to_numpy()
        if dtype != object or _has_text(values):
            missing = column.isna().to_numpy()
            return [None if missing[row] else _text(part, name, (row,), null, form) for row, part in enumerate(values)]
    numbers = series_of(column, name)
    return np.require(numbers.values, np.float64, ["C", "A"]), numbers.missing()
