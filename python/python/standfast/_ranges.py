"""Ranges: many values of one quantity, as a text with the first, the last and how many, or one by one. Everywhere alike:
``"0.2..0.6:41"``, and behind the name of a number of a case ``"width=12 m..20 m:9"``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence, Set
from typing import Any, TypeAlias

import numpy as np

from . import _standfast
from ._advice import Advice
from ._advice import shown as said
from ._columns import column_of
from ._named import heading_of, values_along
from ._standfast import StandfastError
from ._types import Array, Arrow, PandasSeries, PolarsSeries, PyarrowArray, XarrayArray

#: ``"from..to:how many"``, or the values.
Range: TypeAlias = "str | Array | PandasSeries | PolarsSeries | PyarrowArray | XarrayArray | Arrow"
#: The number of a case and its values: ``"width=12 m..20 m:9"``, or ``{"width": values}``.
Over: TypeAlias = "str | Mapping[str, Range] | Mapping[str, str] | Mapping[str, Sequence[str]] | Mapping[str, Sequence[float]]"


def values_of(given: object, name: str, expected: str, advice: Advice) -> str | list[float]:
    """A text as it is, or the values of a list, a tuple, an array or a column, which are numbers, and none of them missing.

    Raises:
        TypeError: for what is neither, with what is expected, and for three values in a tuple that may be a range.
        StandfastError: for missing values, and more than one axis.
    """
    if isinstance(given, str):
        return given
    # From, to and how many, or three values? Where both can be meant, neither is taken.
    if isinstance(given, tuple) and len(given) == 3 and isinstance(given[2], int):
        first, last, count = given
        raise TypeError(
            f"{name} is {given!r}, which may be three values or the ends and how many; expected the list [{first}, {last}, {count}], "
            f"or the text '{first}..{last}:{count}'"
        )
    none = given is None or isinstance(given, (bool, bytes, Mapping, Set))
    column = None if none else column_of(values_along(given, name), name, advice)
    if column is None or column.kind == "point":
        raise TypeError(f"{name} is {said(given)}; expected {expected}, or a list of values")
    found = column.read(name)
    if found.missing() is not None or found.values.ndim != 1:
        what = "missing values" if found.missing() is not None else f"the shape {found.values.shape}"
        raise StandfastError(f"{name} has {what}; expected numbers along one axis, none missing")
    numbers: list[float] = np.asarray(found.values, np.float64).tolist()
    return numbers


def over_of(given: object, expected: str, advice: Advice) -> str:
    """A number of a case and its values as the program has them; numbers are in SI units, or in the unit in brackets behind the name.

    Raises:
        TypeError: for what is neither a text nor a dict of one name.
        StandfastError: for peaks of a shaking without their unit, for values of which some have a unit, and as :func:`values_of`.
    """
    if isinstance(given, str):
        return given
    if not isinstance(given, Mapping) or len(given) != 1 or not isinstance(key := next(iter(given)), str):
        raise TypeError(f"over is {said(given)}; expected a text such as {expected!r}, or a dict of one name with its values")
    values: Any = given[key]
    name, unit = _standfast.heading(heading_of(key, values))
    if (texts := _texts(values, f"over[{key!r}]", name)) is not None:
        return f"{name}={','.join(texts)}"
    found = values_of(values, f"over[{key!r}]", "a text such as '12 m..20 m:9'", advice)
    # The peak of a shaking says its unit, as under [earthquake].
    if name == "pga" and unit is None and not isinstance(found, str):
        raise StandfastError('over["pga"] has no unit; expected {"pga [g]": values} or {"pga [m/s2]": values}')
    behind = "" if unit is None else f" {unit}"
    return f"{name}={found if isinstance(found, str) else ','.join(f'{value!r}{behind}' for value in found)}"


def _texts(values: Any, called: str, name: str) -> list[str] | None:
    """Values that are texts with units, one by one; ``None`` of numbers."""
    if isinstance(values, np.ndarray) and values.dtype.kind in "UT" and values.ndim == 1:
        values = values.tolist()
    if not isinstance(values, (list, tuple)) or not any(isinstance(value, str) for value in values):
        return None
    bare = [value for value in values if not isinstance(value, str)]
    if bare:
        united = next(value for value in values if isinstance(value, str))
        unit = united.strip().lstrip("+-.0123456789eE").strip() or "m"
        raise StandfastError(
            f"{called} has {united!r} beside {bare[0]!r}, which has no unit; expected every value as a text with its unit, or numbers with "
            f"the unit behind the name, as {{'{name} [{unit}]': [...]}}"
        )
    return list(values)


def ends_of(given: str, name: str, lower: str | None, upper: str | None) -> tuple[str, tuple[str | None, str | None]]:
    """A quantity and where it is looked for: ``"width=10 m..20 m"``, or its name beside the ends.

    Raises:
        StandfastError: for what is no range, or one beside ends.
    """
    quantity, has_range, range_ = given.partition("=")
    if not has_range:
        return given, (lower, upper)
    quantity, ends = quantity.strip(), [end.strip() for end in range_.split("..")]
    if len(ends) != 2 or not all(ends) or ":" in range_:
        raise StandfastError(f"{name} is {given!r}; expected the quantity and its range, as '{quantity}=FROM..TO'; how many values is not asked")
    if lower is not None or upper is not None:
        prefix = "and_" if name == "and_" else ""
        raise StandfastError(f"{name} is {given!r} beside {prefix}lower or {prefix}upper; expected the range once")
    return quantity, (ends[0], ends[1])
