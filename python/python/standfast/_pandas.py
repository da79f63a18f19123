"""Codes of modes in columns of pandas: numbers like all others, which compare with the symbols of modes as well.

Imported only where a program has pandas.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import pandas as pd  # type: ignore[import-untyped,unused-ignore]

from ._modes import Mode, Modes, codes_of


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

    def isin(self, values: Any) -> Any:
        return super().isin(np.array([_codes(value) for value in values], dtype=object))

    def map(self, mapper: Any, na_action: Any = None) -> Any:
        """What a dict says of symbols it says of their codes."""
        if isinstance(mapper, pd.Series):
            mapper = mapper.to_dict()
        if isinstance(mapper, Mapping) and any(isinstance(key, str) for key in mapper):
            mapper = {_codes(key): value for key, value in mapper.items()}
        return super().map(mapper, na_action)


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
