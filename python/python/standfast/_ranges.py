"""Ranges: many values of one quantity, as a text with the first, the last and how many, or one by one."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence, Set
from typing import Any, TypeAlias

import numpy as np

from ._advice import Advice
from ._advice import shown as said
from ._columns import column_of
from ._types import Array, Arrow, PandasSeries, PolarsSeries, PyarrowArray

#: ``"from..to:how many"``, or the values.
Range: TypeAlias = "str | Array | PandasSeries | PolarsSeries | PyarrowArray | Arrow"
#: The number of a case and its values: ``"width=12 m..20 m:9"``, or ``{"width": values}``.
Over: TypeAlias = "str | Mapping[str, Range] | Mapping[str, str] | Mapping[str, Sequence[str]] | Mapping[str, Sequence[float]]"


def values_of(given: object, name: str, expected: str, advice: Advice) -> str | list[float]:
    """A text as it is, or the values of a list, a tuple, an array or a column, which are numbers, and none of them missing.

    Raises:
        TypeError: for what is neither, with what is expected.
        ValueError: for missing values, and more than one axis.
    """
    if isinstance(given, str):
        return given
    # From, to and how many, or three values? Where both can be meant, neither is taken.
    is_unclear = isinstance(given, tuple) and len(given) == 3 and isinstance(given[2], int)
    none = given is None or is_unclear or isinstance(given, (bool, bytes, Mapping, Set))
    column = None if none else column_of(given, name, advice)
    if column is None or column.kind == "point":
        raise TypeError(f"{name} is {said(given)}; expected {expected}, or a list of values")
    found = column.read(name)
    if found.missing() is not None or found.values.ndim != 1:
        what = "missing values" if found.missing() is not None else f"the shape {found.values.shape}"
        raise ValueError(f"{name} has {what}; expected numbers along one axis, none missing")
    numbers: list[float] = np.asarray(found.values, np.float64).tolist()
    return numbers


def over_of(given: object, expected: str, advice: Advice) -> str:
    """A number of a case and its values as the program has them; numbers are in SI units, or in the unit in brackets behind the name.

    Raises:
        TypeError: for what is neither a text nor a dict of one name.
        ValueError: for peaks of a shaking without their unit, and as :func:`values_of`.
    """
    if isinstance(given, str):
        return given
    if not isinstance(given, Mapping) or len(given) != 1 or not isinstance(name := next(iter(given)), str):
        raise TypeError(f"over is {said(given)}; expected a text such as {expected!r}, or a dict of one name with its values")
    values: Any = given[name]
    heading = re.fullmatch(r"(.*\S)\s*\[(.+)\]", name)
    name, unit = (heading[1], f" {heading[2]}") if heading else (name, "")
    if isinstance(values, (list, tuple)) and values and all(isinstance(value, str) for value in values):
        return f"{name}={','.join(values)}"
    found = values_of(values, f"over[{name!r}]", "a text such as '12 m..20 m:9'", advice)
    # The peak of a shaking says its unit, as under [earthquake].
    if name == "pga" and not unit and not isinstance(found, str):
        raise ValueError('over["pga"] has no unit; expected {"pga [g]": values} or {"pga [m/s2]": values}')
    return f"{name}={found if isinstance(found, str) else ','.join(f'{value!r}{unit}' for value in found)}"
