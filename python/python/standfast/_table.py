"""Tables of cases and sweeps: a case answered for many values of some of its numbers."""

# A dict of DataArrays is a dict of objects, too: the first overload that fits is meant.
# mypy: disable-error-code="overload-overlap"

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, overload

import numpy as np
from numpy.typing import NDArray

from . import _standfast
from ._advice import Advice, is_of
from ._advice import shown as said
from ._assess import case_text
from ._arrow import ArrowTable
from ._frames import Arrow, Form, Missing
from ._inputs import broadcast, check_indexes, listed
from ._measured import array_of, column_of_cases
from ._mode_arrays import ModeNames
from ._modes import are_modes
from ._named import Broadcast, is_named, variables_of
from ._progress import shown
from ._run import run
from ._standfast import StandfastError
from ._tables import Frame, column_names, frame_of
from ._types import Arrow as ArrowObject
from ._types import OnError, PandasFrame, PolarsFrame, Progress, PyarrowTable, XarrayArray
from ._warnings import warn

if TYPE_CHECKING:
    import pandas as pd  # type: ignore[import-untyped,unused-ignore]
    import polars as pl
    import pyarrow as pa  # type: ignore[import-untyped,unused-ignore]
    import xarray as xr

_Case = str | os.PathLike[str] | Mapping[str, object]

_ADVICE = Advice("assess_table")

#: A column of results as the native module gives it: name, values, and of truth where it is missing, of words the words.
_Result = tuple[str, NDArray[Any], "NDArray[np.bool_] | list[str] | None"]


class ResultColumn(NamedTuple):
    """What is said of a column of results."""

    #: The SI unit of its numbers; ``None`` for what has none.
    unit: str | None
    #: What it is.
    words: str


class Varied(NamedTuple):
    """What a table varies of a case, and what comes out: :func:`varied`'s answer."""

    #: The keys that vary, by the names of the columns.
    keys: dict[str, str]
    #: What goes with them, in sentences: ``["Goes with what varies: wave.crest_height."]``.
    notes: list[str]
    #: The results, in the order of their columns.
    results: dict[str, ResultColumn]


@overload
def assess_table(
    case: _Case,
    table: Mapping[str, XarrayArray],
    *,
    columns: Sequence[str] | None = None,
    map: Mapping[str, str] | None = None,
    on_error: OnError = "raise",
    threads: int | None = None,
    progress: Progress = None,
) -> xr.Dataset: ...
@overload
def assess_table(
    case: _Case,
    table: Mapping[str, object],
    *,
    columns: Sequence[str] | None = None,
    map: Mapping[str, str] | None = None,
    on_error: OnError = "raise",
    threads: int | None = None,
    progress: Progress = None,
) -> dict[str, NDArray[Any]]: ...
@overload
def assess_table(
    case: _Case,
    table: PandasFrame,
    *,
    columns: Sequence[str] | None = None,
    map: Mapping[str, str] | None = None,
    on_error: OnError = "raise",
    threads: int | None = None,
    progress: Progress = None,
) -> pd.DataFrame: ...
@overload
def assess_table(
    case: _Case,
    table: PolarsFrame,
    *,
    columns: Sequence[str] | None = None,
    map: Mapping[str, str] | None = None,
    on_error: OnError = "raise",
    threads: int | None = None,
    progress: Progress = None,
) -> pl.DataFrame: ...
@overload
def assess_table(
    case: _Case,
    table: PyarrowTable,
    *,
    columns: Sequence[str] | None = None,
    map: Mapping[str, str] | None = None,
    on_error: OnError = "raise",
    threads: int | None = None,
    progress: Progress = None,
) -> pa.Table: ...
@overload
def assess_table(
    case: _Case,
    table: ArrowObject,
    *,
    columns: Sequence[str] | None = None,
    map: Mapping[str, str] | None = None,
    on_error: OnError = "raise",
    threads: int | None = None,
    progress: Progress = None,
) -> ArrowTable: ...
def assess_table(
    case: _Case,
    table: Any,
    *,
    columns: Sequence[str] | None = None,
    map: Mapping[str, str] | None = None,
    on_error: OnError = "raise",
    threads: int | None = None,
    progress: Progress = None,
) -> Any:
    """Assesses a case for every row of a table, or every point of a sweep: the program's ``standfast batch --case``.

    A column varies the number of the case whose key it is called by: ``wave.Hmax``, ``body.friction``, ``load[1].force``,
    ``water.level``, ``criteria.SF_sliding``, or a short name: ``width``, ``height``, ``mass``, ``friction``, ``water_level``,
    ``crest_height``. What goes with the size of the body or the level of the sea moves along, see :func:`varied`. Each answer
    is :func:`assess`'s for the case written out with the numbers of its row; of a case with several situations it is that of the
    one that governs.

    Args:
        case: the path of a case file, or a dict with the same keys.
        table: a DataFrame (pandas, polars), a pyarrow Table, or anything else that speaks the Arrow PyCapsule interface. Columns
            that vary nothing are left alone. Or a dict of arrays, columns and scalars by the names of what they vary, which broadcast by
            numpy's rules; Series of pandas have one index. Or a Dataset of xarray, or a dict of its DataArrays, which broadcast by the
            names of their dimensions, in the units of their attribute ``units``. Numbers are in SI units; the name ``"wave.Hmax [cm]"`` gives another
            unit, and so does a text in place of a number: ``"8 m"``. An acceleration of the base has to have one, as
            ``"earthquake.horizontal [g]"``.
        columns: the results that are computed, by their names in ``docs/answer.schema.json``; all of a situation if it is left out. Those
            of the waves, as ``"Hmax"`` or ``"p1"``, are given where they are named. ``"problem"`` may be among them beside
            ``on_error="null"``, where it is always there, and last.
        map: which column of the table varies a key, ``{"wave.Hmax": "H"}``, where it has another name.
        on_error: with ``"raise"``, the first row whose values no case can have is an error; with ``"null"``, such rows have no
            results, and the column ``problem`` says why.
        threads: how many threads to use; ``None``, as here if it is left out, for as many as there are processors (functions of points use one, as
            a row takes far longer than a point). The answer is the same.
        progress: ``True`` for a bar (with ``standfast[progress]``), or a function of the rows done and all rows, which are
            ``None`` where they are not known.

    Returns:
        For a table one of the same library with the results as columns, and with the index of a pandas one:
        ``pd.concat([table, answer], axis=1)`` puts both together; for any other Arrow object an :class:`ArrowTable`. For a dict a dict
        of arrays of the broadcast shape, for arrays of xarray a Dataset with units and words: numbers as float64, NaN where there is no such thing; words as text, empty where there is
        none. Units are SI. A number without bound is infinite. A row with a missing value has no results; of arrays it is masked.

    Raises:
        StandfastError: for a case that is not understood, a column that begins like a key and is none, values that the case cannot
            have: the error has the column, the value and the index of the row.
        TypeError: for columns that hold no numbers.
        KeyError: if ``map`` names a column that the table lacks.

    Warns:
        StandfastWarning: ``column-like-key``, for a column that varies nothing and has almost the name of a key; and for each of the
            warnings that cases of rows have, how many they are and what it says of the first. The column ``warnings`` has the
            names of those of each row.

    >>> block = {
    ...     "body": {"width": 1, "height": 2, "mass": 4800, "friction": 0.7},
    ...     "load": [{"force": "20 kN/m", "elevation": "1.5 m"}],
    ... }
    >>> found = assess_table(block, {"friction": [0.3, 0.5], "load[1].force": [[10e3], [30e3]]}, columns=["mode", "SF_sliding"])
    >>> found["mode"]
    ModeNames([['RE', 'RE'],
               ['SRO-', 'RO']], dtype='<U5')
    >>> found["SF_sliding"].round(3)
    array([[1.413, 2.354],
           [0.471, 0.785]])
    """
    how = run(threads, on_error)
    options = _Options(_pairs(map), _names(columns), how.null_errors, how.threads)
    if is_named(table):
        with shown(progress) as report:
            return _swept_by_name(case, table, options, report)
    _ADVICE.refuse_lazy(table, "table")
    frame = None if isinstance(table, Mapping) else frame_of(table, _ADVICE)
    if frame is None and not isinstance(table, Mapping):
        raise TypeError(f"table is a {type(table).__name__}; expected a DataFrame, an Arrow table, or a dict of arrays")
    with shown(progress) as report:
        return _swept(case, table, options, report) if frame is None else _answered(case, frame, options, report)


def _swept(case: _Case, table: Mapping[str, object], options: _Options, report: Any) -> dict[str, NDArray[Any]]:
    """The results of a dict of arrays."""
    sweep = _sweep(case, table, options)
    _refuse_idle(table, sweep)
    arrays, minded = _sweep_of(_varying(table, sweep), sweep, options.null, report)
    _mind(minded, sweep)
    return arrays


def _swept_by_name(case: _Case, table: Any, options: _Options, report: Any) -> Any:
    """The results of arrays of xarray, as a Dataset."""
    variables = variables_of(table)
    # The variables of a Dataset are as the columns of a table: those that vary nothing are left alone.
    is_dataset = is_of(table, "xarray", "Dataset")
    sweep = _sweep(case, list(variables) if is_dataset else variables, options)
    if not is_dataset:
        _refuse_idle(variables, sweep)
    broadcast = Broadcast.of(_varying(variables, sweep))
    arrays, minded = _sweep_of(broadcast.arrays, sweep, options.null, report)
    _mind(minded, sweep)
    said = {name: (unit, words or "") for name, unit, words in sweep.results}
    return broadcast.dataset(arrays, said)


def _varying(table: Mapping[str, object], sweep: _standfast.Sweep) -> dict[str, Any]:
    """What of a dict varies the case, in the order of the sweep."""
    given = list(table.items())
    return {str(given[place][0]): given[place][1] for place in sweep.places}


def _answered(case: _Case, frame: Frame, options: _Options, report: Any) -> Any:
    """The results of a table, as one of its library."""
    table, form = frame.value, frame.form
    if frame.kind == "pandas":
        sweep = _sweep(case, frame.names, options)
        given = [column_of_cases(table.iloc[:, place], frame.names[place], form, options.null) for place in sweep.places]
        try:
            answer, _, minded = sweep.answer(given, [len(table)], report)
        except ValueError as error:
            raise form.placed(error) from None
        _mind(minded, sweep, form)
        return _pandas(answer, table.index)
    assert isinstance(form, Arrow)
    sweep = _sweep(case, frame.native, options)
    found, minded = sweep.answer_table(report, frame.rows)
    _mind(minded, sweep)
    return form.adopt_table(found)


def varied(case: _Case, table: Any, *, columns: Sequence[str] | None = None, map: Mapping[str, str] | None = None) -> Varied:
    """What a table varies of a case and what goes with it, and which results it would have, without computing any.

    Args:
        case, columns, map: as for :func:`assess_table`.
        table: the same, or only the names of its columns.

    Raises:
        StandfastError, KeyError: as :func:`assess_table`.

    >>> found = varied("examples/goda-2000.toml", ["wave.period", "water_level"])
    >>> found.keys
    {'wave.period': 'wave.period', 'water_level': 'wave.base_depth'}
    >>> found.results["margin_sliding"].unit
    'N/m'
    """
    sweep = _sweep(case, _column_names(table), _Options(_pairs(map), _names(columns), False, 1))
    results = {name: ResultColumn(unit, words or "") for name, unit, words in sweep.results}
    return Varied(dict(sweep.varied), sweep.notes, results)


class _Options(NamedTuple):
    """What the native module asks beside the case and the table."""

    map: list[tuple[str, str]]
    results: list[str] | None
    null: bool
    threads: int | None


def _column_names(table: Any) -> list[str]:
    """The names of the columns of a table, or themselves."""
    if is_named(table):
        return list(variables_of(table))
    _ADVICE._replace(function="varied").refuse_lazy(table, "table")
    if isinstance(table, Mapping):
        return [str(name) for name in table]
    if (known := column_names(table)) is not None:
        return [str(name) for name in known]
    if isinstance(table, (str, Iterator)) or not isinstance(table, Iterable):
        raise TypeError(f"table is {said(table)}; expected a table, or a list of the names of its columns")
    names = list(table)
    wrong = [name for name in names if not isinstance(name, str)]
    if wrong:
        raise TypeError(f"table has {said(wrong[0])}; expected a table, or a list of the names of its columns")
    return names


def _sweep(case: _Case, given: Any, options: _Options) -> _standfast.Sweep:
    """A case and the columns that vary it; says which of those that do not are almost called as if they did."""
    name, text = case_text(case)
    names = [str(column) for column in given] if isinstance(given, Mapping) else given
    sweep = _standfast.Sweep(name, text, names, options.map, options.results, options.null, options.threads)
    for slip, words in () if isinstance(given, Mapping) else sweep.warnings:
        warn(slip, words, words)
    return sweep


def _mind(minded: Sequence[_standfast._Minded], sweep: _standfast.Sweep, form: Form | None = None) -> None:
    """Says what is unusual about rows, once of each kind."""
    columns = ", ".join(column for column, _ in sweep.varied)
    for name, rows, index, words in minded:
        place = index[0] if len(index) == 1 else tuple(index)
        at = f"index {place}" if form is None or len(index) != 1 else form.place(index[0])
        of = f"at {at}" if rows == 1 else f"in {rows} rows, the first at {at}"
        warn(name, f"{name}, where {columns} vary", f"{of}: {words}")


def _pairs(map: Mapping[str, str] | None) -> list[tuple[str, str]]:
    if map is not None and not isinstance(map, Mapping):
        raise TypeError(f"map is {map!r}; expected a dict of keys and columns, as {{'wave.Hmax': 'H'}}")
    pairs = list((map or {}).items())
    for key, column in pairs:
        if not isinstance(key, str) or not isinstance(column, str):
            raise TypeError(f"map gives {column!r} for {key!r}; expected the name of a column for a key of the case")
    return pairs


def _names(columns: Sequence[str] | None) -> list[str] | None:
    return None if columns is None else [str(name) for name in listed(columns, "as ['mode']")]


def _refuse_idle(table: Mapping[str, object], sweep: _standfast.Sweep) -> None:
    """Who names an array means it to vary something."""
    for place, name in enumerate(table):
        if place not in sweep.places:
            meant = next((words for _, words in sweep.warnings if words.startswith(f"column {name} ")), None)
            words = f"{name!r} is not a number of the case" if meant is None else meant
            raise StandfastError(f"{words}; the numbers that vary are given by their keys, or by map={{...}}")


def _sweep_of(
    table: Mapping[str, object], sweep: _standfast.Sweep, null: bool, report: Any
) -> tuple[dict[str, NDArray[Any]], list[_standfast._Minded]]:
    """The results of a dict of arrays, and the warnings."""
    check_indexes(table)
    columns = [array_of(value, name, null) for name, value in table.items()]
    shape = broadcast(list(table), [values for values, _ in columns])
    flat: list[_standfast._Numbers | list[str | None]] = []
    for values, missing in columns:
        spread = np.broadcast_to(values, shape).ravel()
        if values.dtype.kind == "f":
            mask = None if missing is None else np.ascontiguousarray(np.broadcast_to(missing, shape).ravel())
            flat.append((np.require(spread, np.float64, ["C", "A"]), mask))
        else:
            flat.append(spread.tolist())
    answer, without, minded = sweep.answer(flat, list(shape), report)
    mask = np.zeros(int(np.prod(shape)), dtype=np.bool_)
    mask[without] = True
    # What is wrong with a row is said where it has no results.
    masks = {column[0]: mask if len(without) and column[0] != "problem" else None for column in answer}
    return {column[0]: _numpy(column, shape, masks[column[0]]) for column in answer}, minded


def _numpy(column: _Result, shape: tuple[int, ...], missing: Missing) -> NDArray[Any]:
    _, values, more = column
    if isinstance(more, list):
        values = np.array([*more, ""])[values]
        values = values.view(ModeNames) if are_modes(more) else values
    values = values.reshape(shape)
    return values if missing is None else np.ma.MaskedArray(values, missing.reshape(shape))


def _pandas(answer: list[_Result], index: Any) -> Any:
    from ._pandas import categories

    pd = sys.modules["pandas"]
    made = {}
    for name, values, more in answer:
        if more is None:
            made[name] = values
        elif isinstance(more, list):
            words = categories(values, more)
            made[name] = words.astype(object) if name == "problem" else words
        else:
            made[name] = pd.arrays.BooleanArray(values, more)
    return pd.DataFrame(made, index=index, copy=False)
