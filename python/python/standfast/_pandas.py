"""Codes of modes in columns of pandas: numbers like all others, which compare with the symbols of modes as well.

Imported only where a program has pandas.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pandas as pd  # type: ignore[import-untyped,unused-ignore]

from ._modes import BY_SYMBOL, Mode


class ModeDtype(pd.UInt8Dtype):  # type: ignore[misc,unused-ignore]
    """The type of a column of codes of modes: ``UInt8``, by name and by whatever is computed with it."""

    @classmethod
    def construct_array_type(cls) -> type[ModeArray]:
        return ModeArray

    def __eq__(self, other: object) -> bool:
        return isinstance(other, pd.UInt8Dtype) or super().__eq__(other)

    def __hash__(self) -> int:
        return hash(pd.UInt8Dtype())


class ModeArray(pd.arrays.IntegerArray):  # type: ignore[misc,unused-ignore]
    """Codes of modes as integers that may be missing. Where they are compared, modes and symbols stand for their codes."""

    @property
    def dtype(self) -> ModeDtype:
        return ModeDtype()

    def _cmp_method(self, other: Any, op: Any) -> Any:
        return super()._cmp_method(_codes(other) if op.__name__ in ("eq", "ne") else other, op)

    def isin(self, values: Any) -> Any:
        return super().isin(np.array([_codes(value) for value in values], dtype=object))


def _codes(other: Any) -> Any:
    """A mode's code for its symbol, alone or in a list."""
    if isinstance(other, Mode):
        return int(other)
    if isinstance(other, str):
        if other not in BY_SYMBOL:
            raise ValueError(f"{other!r} is not the symbol of a mode; expected one of {', '.join(BY_SYMBOL)}")
        return int(BY_SYMBOL[other])
    if isinstance(other, (list, tuple, np.ndarray)) and any(isinstance(one, str) for one in np.asarray(other, dtype=object).flat):
        return pd.array([_codes(one) for one in other], dtype="UInt8")
    return other
