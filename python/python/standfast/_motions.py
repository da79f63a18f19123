"""Many motions at once: arrays of records and of numbers in, a table out."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import _standfast
from ._arrow import ArrowTable
from ._assess import case_text
from ._progress import shown
from ._records import own_times, positive
from ._run import Told, run
from ._simulate import copies_of, folder_of
from ._standfast import StandfastError
from ._types import Array, Progress
from ._warnings import mind

_UNITS = ("m/s2", "g", "cm/s2")


def motions(
    case: str | os.PathLike[str] | Mapping[str, object],
    *,
    base: Array | Sequence[Array],
    dt: float | Sequence[float],
    unit: Literal["m/s2", "g", "cm/s2"] | None = None,
    vertical: Array | Sequence[Array] | None = None,
    vary: Mapping[str, Any] | None = None,
    cross: bool = False,
    divergence: bool = False,
    strength: bool = False,
    copies: int | None = None,
    spread: float | Mapping[str, float] | None = None,
    seed: int | None = None,
    threads: int | None = None,
    progress: Progress = None,
) -> ArrowTable:
    """Follows many motions of one case: bodies with other numbers, each under one of many records.

    What :func:`simulate` answers for one body under one record, to the last digit, as rows of numbers; a call takes little more than the
    motions themselves.

    Args:
        case: as for :func:`simulate`.
        base: accelerations of the base to the right: an array of shape (records, points), or a list of arrays, one for each record. One
            array of one axis is one record. Arrays of float64 are read where they are.
        dt: the step of time between their values, in seconds; one for all, or one for each record.
        unit: that of the values in ``base`` and ``vertical``; of a ``[block]``, which has none, it is left out.
        vertical: accelerations upwards, as many as in ``base``.
        vary: numbers of the body by their names, as tables and ``design`` have them, ``{"height": [1.8, 2.0], "friction": 0.4}``: arrays
            of one length go together, a body for each of their values; a number is that of all bodies. In SI units, or as the name
            says, ``"height [cm]"``.
        cross: true for every body under every record. Else bodies and records go together, one by one, where there are as many of both,
            and one of either stands for all of the others.
        divergence: whether each motion is followed once more to see how much small errors grow: column ``divergence``.
        strength: whether each is followed under stronger and weaker shakings, some fifty motions: columns ``onset``, ``stronger`` and
            ``weaker``.
        copies: so many copies of each motion are followed, ``spread`` and ``seed`` as for :func:`simulate`: columns
            ``overturned_share`` and its interval, ``overturned_share_low`` and ``overturned_share_high``.
        threads: the number of threads; the table does not depend on it. As many as there are cores if left out.
        progress: ``True`` for a bar (with ``standfast[progress]``), or a function of the parts done and all parts, thousandths of the work.

    Ctrl-C ends the call.

    Returns:
        A table with a row for each motion, record by record: ``record`` and ``body``, their places; what varies, under its names;
        ``slide``, ``max_slide``, ``max_theta``, ``max_theta_of_balance``, ``t_rest`` (none of what does not come to rest), ``friction_loss``
        and ``impact_loss``; ``impacts``; ``overturned``, ``at_rest``, and ``met`` of a case with criteria on the motion; ``end``, a word. Of a case
        whose loads are alternatives, of the worst. ``pandas.DataFrame(table.to_dict())``, ``polars.DataFrame(table)``.

    Raises:
        StandfastError: for a case that is not understood, a record with a value that is not finite, a name that varies nothing, and
            lengths that do not go together; the message has the record or the body.
        TypeError: for what is no array of numbers.

    Warns:
        StandfastWarning: for each kind of warning, once, with how many motions have it.

    >>> statue = {"body": {"width": 0.6, "length": 0.6, "height": 2, "density": 2600, "friction": 0.7}}
    >>> t = np.arange(0, 2, 0.01)
    >>> pulses = [[a * 9.81 * np.sin(2 * np.pi * t)] for a in (0.2, 0.4)]
    >>> table = motions(statue, base=np.concatenate(pulses), dt=0.01, unit="m/s2", vary={"height": [1.5, 2.0, 2.5]}, cross=True)
    >>> table.record.to_pylist(), table.height.to_pylist()
    ([0, 0, 0, 1, 1, 1], [1.5, 2.0, 2.5, 1.5, 2.0, 2.5])
    >>> table.max_theta_of_balance.to_numpy().round(3)
    array([0.   , 0.   , 0.   , 0.   , 0.829, 6.669])
    """
    if unit is not None and unit not in _UNITS:
        raise StandfastError(f"unit is {unit!r}; expected one of {', '.join(map(repr, _UNITS))}")
    text = case_text(case)
    horizontal = _records(base, "base")
    steps = _steps(dt, len(horizontal))
    _same_times(base, steps)
    upwards = None if vertical is None else _records(vertical, "vertical")
    if upwards is not None and [len(one) for one in upwards] != [len(one) for one in horizontal]:
        raise StandfastError("vertical has other records than base; expected as many, with as many values each")
    names, bodies, count = _bodies(vary)
    for name, flag in (("cross", cross), ("divergence", divergence), ("strength", strength)):
        if not isinstance(flag, (bool, np.bool_)):
            raise TypeError(f"{name} is {flag!r}; expected True or False")
    with shown(progress, None) as told:
        asked = _Asked(
            horizontal, upwards, steps, unit, names, bodies, count, bool(cross), bool(divergence), bool(strength),
            copies_of(copies, spread, seed), run(threads).threads, told,
        )  # fmt: skip
        numbers, counts, flags, ends, warned, is_si = _standfast.motions((*text, folder_of(case), {}), asked)
    mind((name, words if number == 1 else f"of {number} motions, the first: {words}") for name, words, number in warned)
    places = {name: values for name, _, values in counts}["body"]
    made = [_standfast.make_array(name, values, None, None, {"description": words}) for name, words, values in counts[:2]]
    for name, of_bodies in zip(names, bodies):
        bare = _standfast.heading(name)[0]
        made.append(_standfast.make_array(name, np.asarray(of_bodies)[places], None, None, {"description": f"{bare} of its body"}))
    for name, unit_of, words, values in numbers:
        metadata = {"description": words} | ({"unit": unit_of} if is_si and unit_of else {})
        missing = np.isnan(values)
        made.append(_standfast.make_array(name, values, missing if missing.any() else None, None, metadata))
    made += [_standfast.make_array(name, values, None, None, {"description": words}) for name, words, values in counts[2:]]
    made += [_standfast.make_array(name, values, None, None, {"description": words}) for name, words, values in flags]
    made.append(_standfast.make_array("end", ends, None, None, {"description": "how the motion ends"}))
    return ArrowTable(_standfast.make_table(made))


class _Asked(NamedTuple):
    """What the native module is asked."""

    horizontal: list[NDArray[np.float64]]
    vertical: list[NDArray[np.float64]] | None
    steps: list[float]
    unit: str | None
    names: list[str]
    bodies: list[list[float]]
    #: How many bodies there are.
    number: int
    cross: bool
    divergence: bool
    strength: bool
    copies: tuple[int | None, float | list[tuple[str, float]] | None, int | None]
    threads: int | None
    progress: Told | None


def _records(given: Any, name: str) -> list[NDArray[np.float64]]:
    """Each record as an array of float64 whose values follow each other, not copied where it is one."""
    if isinstance(given, (str, bytes, Mapping)) or not hasattr(given, "__len__"):
        raise TypeError(f"{name} is a {type(given).__name__}; expected an array of shape (records, points), or a list of arrays")
    if isinstance(given, (list, tuple)) and given and np.ndim(given[0]) > 0:
        records = [_record(one, f"{name}[{place}]") for place, one in enumerate(given)]
    else:
        whole = _numbers(given, name)
        if whole.ndim not in (1, 2):
            raise StandfastError(f"{name} has {whole.ndim} axes; expected (records, points)")
        records = [np.ascontiguousarray(one) for one in (whole if whole.ndim == 2 else whole[np.newaxis])]
    if not records:
        raise StandfastError(f"{name} has no record")
    return records


def _record(given: Any, name: str) -> NDArray[np.float64]:
    values = _numbers(given, name)
    if values.ndim == 2 and values.shape[0] == 1:
        values = values[0]
    if values.ndim != 1:
        raise StandfastError(f"{name} has {values.ndim} axes; expected one")
    return np.ascontiguousarray(values)


def _numbers(given: Any, name: str) -> NDArray[np.float64]:
    if hasattr(given, "columns") and not isinstance(given, np.ndarray):
        raise TypeError(f"{name} is a table with columns, which may be records or points; expected an array, as frame.to_numpy().T")
    if np.ma.isMaskedArray(given) and np.ma.getmaskarray(given).any():
        raise StandfastError(f"{name} has masked values; expected all of them")
    try:
        found = np.asarray(given)
        if found.dtype.kind not in "fiu":
            raise TypeError(f"{name} is an array of {found.dtype}; expected numbers")
        return found.astype(np.float64, copy=False)
    except ValueError as error:
        raise TypeError(f"{name} is no array of numbers: {error}") from None


def _steps(dt: Any, count: int) -> list[float]:
    if np.ndim(dt) == 0:
        return [positive(dt, "dt")] * count
    steps = [positive(one, f"dt[{place}]") for place, one in enumerate(dt)]
    if len(steps) != count:
        raise StandfastError(f"dt has {len(steps)} steps, and there are {count} records; expected one, or as many")
    return steps


def _same_times(base: Any, steps: list[float]) -> None:
    """Refuses a Series or a DataArray whose own times are others than those by ``dt``."""
    for place, one in enumerate(base if isinstance(base, (list, tuple)) else [base]):
        times = own_times(one) if np.ndim(one) == 1 else None
        if times is not None and len(times) > 1 and np.abs(times - times[0] - np.arange(len(times)) * steps[place]).max() > 1e-6 * (times[-1] - times[0]):
            raise StandfastError(f"record {place} has times of its own, {times[1] - times[0]:.6g} apart at first, and dt is {steps[place]:.6g}")


def _bodies(vary: Mapping[str, Any] | None) -> tuple[list[str], list[list[float]], int]:
    """Names, the values of each for every body, and how many bodies there are."""
    if vary is None:
        return [], [], 1
    if not isinstance(vary, Mapping):
        raise TypeError(f"vary is a {type(vary).__name__}; expected names with numbers or arrays, as {{'height': [1.8, 2.0]}}")
    values = {str(name): _numbers(given, f"vary[{name!r}]") for name, given in vary.items()}
    for name, array in values.items():
        if array.ndim > 1:
            raise StandfastError(f"vary[{name!r}] has {array.ndim} axes; expected one number, or an array of one axis")
    lengths = {name: len(array) for name, array in values.items() if array.ndim == 1}
    if len(set(lengths.values())) > 1:
        told = ", ".join(f"{name} {length}" for name, length in lengths.items())
        raise StandfastError(f"the arrays of vary have different lengths: {told}; expected one length, or cross them beforehand")
    count = next(iter(lengths.values()), 1)
    if count == 0:
        raise StandfastError("vary has arrays without values")
    return list(values), [np.broadcast_to(array, (count,)).tolist() for array in values.values()], count
