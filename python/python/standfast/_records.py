"""Records of a shaking: accelerations of the base with their times, as arrays, Series and DataArrays have them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._advice import Advice, is_of
from ._advice import shown as said
from ._columns import column_of
from ._named import index_of, units_of, values_along
from ._standfast import StandfastError

_ADVICE = Advice("simulate")

#: Units of a record; g counts the gravity of the case.
_UNITS = ("m/s2", "g", "cm/s2")
_DIRECTIONS = ("horizontal", "vertical")
#: Times that differ by this share of a record's length are the same.
_SAME = 1e-6
#: How arrays of xarray say the units.
_SPELLED = {
    **{unit: unit for unit in _UNITS},
    **{spelled: "m/s2" for spelled in ("m s-2", "m s**-2", "m/s**2", "m/s^2", "m/s²")},
    **{spelled: "cm/s2" for spelled in ("cm s-2", "cm s**-2", "cm/s**2", "cm/s^2", "cm/s²", "gal", "Gal")},
}

#: Times and values of a record, and their unit.
_Record = tuple[NDArray[np.float64], NDArray[np.float64], str | None]
#: Those to the right and upwards, where they are given.
Records = tuple[_Record | None, _Record | None]


def check_unit(base: Records, unit: str | None, is_si: bool) -> None:
    """Accelerations of a body have their unit said, those of a block have none."""
    if base == (None, None) or is_si == (unit is not None):
        return
    if unit is None:
        raise StandfastError(f"unit is missing; expected that of the accelerations in base: {', '.join(map(repr, _UNITS))}")
    raise StandfastError(f"unit is {unit!r}, and the case has a [block], whose accelerations have no unit; leave it out")


def records_of(base: Any, dt: Any, unit: str | None, called: str = "base") -> Records:
    """Horizontal and vertical record; ``called`` is what errors call them.

    Raises:
        StandfastError: for what is no record, times that do not rise, and two directions that differ in their times.
        TypeError: for what is no array of numbers, and without times.
    """
    if unit is not None and unit not in _UNITS:
        raise StandfastError(f"unit is {unit!r}; expected one of {', '.join(map(repr, _UNITS))}")
    if base is None:
        if dt is not None or unit is not None:
            raise TypeError(f"{'dt' if dt is not None else 'unit'} is that of base, which is not given")
        return None, None
    if isinstance(base, Mapping):
        for direction in base:
            if direction not in _DIRECTIONS:
                raise StandfastError(f"{called} has {direction!r}; expected 'horizontal' and 'vertical'")
        named = {direction: (f"{called}[{direction!r}]", values) for direction, values in base.items()}
        if not named:
            raise StandfastError(f"{called} is empty; expected an array, or arrays under 'horizontal' and 'vertical'")
    else:
        named = {"horizontal": (called, base)}
    for name, values in named.values():
        _check_own_unit(values, name, unit)
    found = {direction: _record(name, values, dt, unit) for direction, (name, values) in named.items()}
    lengths = {direction: len(values) for direction, (_, values, _) in found.items()}
    if len(set(lengths.values())) > 1:
        counted = " and ".join(f"{count} values {direction}" for direction, count in lengths.items())
        raise StandfastError(f"{called} has {counted}; expected as many")
    if len(found) > 1:
        _check_times({name: found[direction][0] for direction, (name, _) in named.items()})
    return found.get("horizontal"), found.get("vertical")


def _check_times(times: Mapping[str, NDArray[np.float64]]) -> None:
    """Refuses two directions of one shaking whose times differ."""
    (one, first), (other, second) = times.items()
    differ = np.abs(first - second) > _SAME * max(first[-1] - first[0], second[-1] - second[0])
    if differ.any():
        at = int(np.argmax(differ))
        raise StandfastError(
            f"at row {at} {one} has the time {first[at]:.6g} s, and {other} {second[at]:.6g} s; expected the same times in both directions. "
            "numpy.interp(times, ...) brings one to the times of the other"
        )


def _check_own_unit(values: Any, name: str, unit: str | None) -> None:
    """Refuses an array that says another unit than the call."""
    own = units_of(values)
    if own is not None and _SPELLED.get(own, own) != unit:
        asked = f"unit={_SPELLED[own]!r}" if own in _SPELLED else f"one in {', '.join(_UNITS)}"
        raise StandfastError(f"{name} is in {own!r} by its attribute units, and unit is {unit!r}; expected {asked}")


def _record(name: str, given: Any, dt: Any, unit: str | None) -> _Record:
    values = _values(given, name)
    own = own_times(given)
    if dt is None:
        if own is None:
            raise TypeError(f"dt is missing; expected the step of time between the values of {name}, or their times")
        return _rising(own, f"the index of {name}"), values, unit
    if np.ndim(dt) == 0 and not hasattr(dt, "__len__"):
        times = np.arange(len(values), dtype=np.float64) * positive(dt, "dt")
    else:
        times = _rising(_values(dt, "dt"), "dt")
    if times.shape != values.shape:
        raise StandfastError(f"dt has {len(times)} times and {name} {len(values)} values; expected as many")
    if own is not None:
        apart = np.abs(own - times) > _SAME * max(own[-1] - own[0], times[-1] - times[0])
        if apart.any():
            at = int(np.argmax(apart))
            raise StandfastError(
                f"{name} has the time {own[at]:.6g} in its index at row {at}, and {times[at]:.6g} by dt; leave dt out, or give {name}.to_numpy()"
            )
    return times, values, unit


def own_times(given: Any) -> NDArray[np.float64] | None:
    """The times in the index of a Series of pandas, or along the dimension of a DataArray; ``None`` of numbers and labels of rows."""
    if is_of(given, "pandas", "Series"):
        index = given.index
    elif (index := index_of(given)) is None:
        return None
    if index.dtype.kind == "M":
        index = index - index[0]
    if index.dtype.kind == "m":
        return np.asarray(index.total_seconds(), dtype=np.float64)
    return np.asarray(index, dtype=np.float64) if index.dtype.kind == "f" else None


def _rising(times: NDArray[np.float64], name: str) -> NDArray[np.float64]:
    """Times that rise."""
    back = np.flatnonzero(~(np.diff(times) > 0))
    if len(back):
        raise StandfastError(f"{name} is {times[back[0] + 1]:g} at index {back[0] + 1}, after {times[back[0]]:g}; expected times that rise")
    return times


def _values(given: Any, name: str) -> NDArray[np.float64]:
    """Finite numbers of one axis."""
    column = column_of(values_along(given, name), name, _ADVICE)
    found = column.read(name)
    if found.missing() is not None or found.values.ndim != 1 or len(found.values) < 2:
        what = "missing values" if found.missing() is not None else f"the shape {found.values.shape}"
        raise StandfastError(f"{name} has {what}; expected two numbers or more, along one axis, none missing")
    values = np.require(found.values, np.float64, ["C", "A"])
    wrong = np.flatnonzero(~(np.abs(values) < 1e50))
    if len(wrong):
        raise StandfastError(f"{name} is {values[wrong[0]]:g} at index {wrong[0]}; expected a finite number")
    return values


def positive(value: Any, name: str) -> float:
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, float, np.integer, np.floating)):
        raise TypeError(f"{name} is {said(value)}; expected a number above zero")
    if not 0 < value < float("inf"):
        raise StandfastError(f"{name} is {value}; expected a number above zero")
    return float(value)
