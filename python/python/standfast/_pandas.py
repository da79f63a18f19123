"""Modes in columns of pandas: codes, numbers like all others, and symbols, categories like all others, which compare with each other and with modes.

Imported only where a program has pandas.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np
import pandas as pd  # type: ignore[import-untyped,unused-ignore]

from ._modes import SYMBOLS, Mode, Modes, are_modes, codes_of, words_of


class ModeDtype(pd.UInt8Dtype):  # type: ignore[misc,unused-ignore]
    """The type of a column of codes of modes: ``UInt8``, by name and by whatever is computed with it."""

    @classmethod
    def construct_array_type(cls) -> type[ModeColumn]:
        return ModeColumn

    def __eq__(self, other: object) -> bool:
        return isinstance(other, pd.UInt8Dtype) or super().__eq__(other)

    def __hash__(self) -> int:
        return hash(pd.UInt8Dtype())


class ModeColumn(pd.arrays.IntegerArray):  # type: ignore[misc,unused-ignore]
    """Codes of modes as integers that may be missing. Where they are compared, modes and symbols stand for their codes."""

    #: Above that of columns of words, which so leave it to this class to compare them with codes.
    __pandas_priority__ = 1500

    @property
    def dtype(self) -> ModeDtype:
        return ModeDtype()

    def _cmp_method(self, other: Any, op: Any) -> Any:
        return super()._cmp_method(_codes(other) if op.__name__ in ("eq", "ne") else other, op)

    def __getitem__(self, item: Any) -> Any:
        """An item is a mode, which is compared as it is in the column."""
        found = super().__getitem__(item)
        return _mode(found) if isinstance(found, np.integer) else found

    def __iter__(self) -> Iterator[Any]:
        return map(_mode, super().__iter__())

    def _reduce(self, name: str, **options: Any) -> Any:
        """The least and the greatest are modes."""
        found = super()._reduce(name, **options)
        return _mode(found) if name in ("min", "max") else found

    def astype(self, dtype: Any, copy: bool = True) -> Any:
        """As pandas'; as categories and as texts they are words."""
        is_category = isinstance(dtype, pd.CategoricalDtype) and dtype.categories is None or isinstance(dtype, str) and dtype == "category"
        is_text = pd.api.types.is_string_dtype(dtype) and dtype not in (object, "object", "O")
        if not is_category and not is_text:
            return super().astype(dtype, copy=copy)
        codes = np.where(self._mask | (self._data >= len(SYMBOLS)), -1, self._data.astype(np.int8))
        words = categories(codes, SYMBOLS.tolist())
        return words if is_category else words.astype(dtype)

    def isin(self, values: Any) -> Any:
        return super().isin(np.array([_codes(value) for value in values], dtype=object))

    def map(self, mapper: Any, na_action: Any = None) -> Any:
        """What a dict says of symbols it says of their codes; a function is called with modes."""
        if callable(mapper) and not isinstance(mapper, (Mapping, pd.Series)):
            return super().map(lambda item: mapper(_mode(item)), na_action)
        if isinstance(mapper, pd.Series):
            mapper = mapper.to_dict()
        if isinstance(mapper, Mapping) and any(isinstance(key, str) for key in mapper):
            mapper = {_codes(key): value for key, value in mapper.items()}
        return super().map(mapper, na_action)


class ModeWords(pd.Categorical):  # type: ignore[misc,unused-ignore]
    """Symbols of modes as categories, which may be missing. Where they are compared and looked for, modes and codes stand for their symbols."""

    def __eq__(self, other: object) -> Any:
        return super().__eq__(_words(other))

    def __ne__(self, other: object) -> Any:
        return super().__ne__(_words(other))

    __hash__ = None  # type: ignore[assignment]

    @classmethod
    def _concat_same_type(cls, to_concat: Any, *axis: Any, **options: Any) -> Any:
        # pandas itself would make plain categories of them.
        joined = super()._concat_same_type(to_concat, *axis, **options)
        return cls.from_codes(joined.codes, dtype=joined.dtype) if joined.ndim == 1 else joined

    def __contains__(self, mode: object) -> bool:
        return bool(super().__contains__(_words(mode)))

    def isin(self, values: Any) -> Any:
        return super().isin([_words(value) for value in values])

    def map(self, mapper: Any, na_action: Any = None) -> Any:
        """What a dict says of modes and codes it says of their symbols."""
        if isinstance(mapper, Mapping):
            mapper = {_words(key): value for key, value in mapper.items()}
        return super().map(mapper, na_action)


def _mode(code: Any) -> Any:
    """The mode of a code; what is missing, or of no mode, as it is."""
    return Mode(int(code)) if isinstance(code, (int, np.integer)) and 0 <= code < len(SYMBOLS) else code


def categories(places: Any, words: Sequence[str]) -> Any:
    """A column of words, of which each row has the place; those that are modes know it."""
    kind = ModeWords if are_modes(words) else pd.Categorical
    return kind.from_codes(places, categories=words)


def _words(other: Any) -> Any:
    """A mode's symbol for it or its code, alone or in what holds many; columns of pandas as they are."""
    return other if isinstance(other, (pd.Series, pd.Index, pd.api.extensions.ExtensionArray)) else words_of(other)


def _codes(other: Any) -> Any:
    """A mode's code for its symbol, alone or in what holds many."""
    if isinstance(other, pd.api.extensions.ExtensionArray) and not isinstance(other, pd.arrays.IntegerArray):
        other = np.asarray(other, dtype=object)
    if isinstance(other, (list, tuple, np.ndarray)):
        items = np.asarray(other, dtype=object)
        if any(isinstance(one, str) for one in items.flat):
            return pd.array([pd.NA if pd.isna(one) else codes_of(one) for one in items.flat], dtype="UInt8")
        return other
    return codes_of(other) if isinstance(other, (str, Mode, Modes)) else other
