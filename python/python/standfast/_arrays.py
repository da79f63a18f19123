"""Modes and motions of points, one or millions: scalars, arrays, columns and tables."""

# Every pair of overloads has a case that fits both (an empty list, a class made to fit): the first that fits is meant.
# mypy: disable-error-code="overload-overlap"

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Literal, overload

import numpy as np
from numpy.typing import NDArray

from . import _standfast
from ._arrow import ArrowArray, ArrowTable
from ._frames import Arrays, Arrow, Fields, Point
from ._inputs import Operands, are_plain, called, chosen, read
from ._mode_arrays import ModeArray, ModeNames
from ._modes import SYMBOLS, Mode, Modes
from ._run import Run, run
from ._standfast import StandfastError
from ._types import Array, Map, Number, OnError, Options, PandasFrame, PandasSeries, PolarsFrame, PolarsSeries, Progress
from ._types import Arrow as ArrowLike
from ._types import PyarrowArray, PyarrowTable, Side

if TYPE_CHECKING:
    import pandas as pd  # type: ignore[import-untyped,unused-ignore]
    import polars as pl
    import pyarrow as pa  # type: ignore[import-untyped,unused-ignore]
    from typing_extensions import Unpack

_NAMES = ("gamma", "k_prime", "k", "mu")
#: By their codes.
_MODES = tuple(Mode)


class Onset(Fields["Mode | Modes | bool | float"]):
    """How a motion begins: :func:`onset`'s answer for four plain numbers.

    Lengths are in B (half the width), accelerations in g, the angular acceleration in g/B, forces in m g. Right and up
    are positive, and counter-clockwise. Numbers in parentheses are the report's equations.

    Attributes:
        mode: the mode.
        unique: whether no other mode satisfies every law.
        others: the other modes that satisfy every law; none where ``unique``.
        x_ddot: ẍ of the centre of mass, in g (3.6, 3.9, 3.12; 4.23).
        y_ddot: ÿ of the centre of mass, in g (3.10, 3.13).
        theta_ddot: θ̈, in g/B (3.14, 3.30, 3.43; 4.36, 4.64, 4.89); 0 where the body does not turn.
        f_x: horizontal reaction of the ground on the body, in m g (3.9, 3.15).
        f_y: vertical reaction on the body, in m g (3.10, 3.16).
        xi: ξ, how far right of the centre of mass f_y acts, in B, from -1 under O to 1 under O' (3.11; at rest 4.8, sliding 4.17).
        slip: ẍ of both corners, along the ground, in g (3.37, 3.45; 4.76, 4.95); 0 where the base does not slip.
        lift_o: ÿ of the left corner O, in g (3.12, 3.13); 0 while it stays on the ground.
        lift_o_prime: ÿ of the right corner O', in g (3.12, 3.13); 0 while it stays on the ground.
    """

    mode: Mode
    unique: bool
    others: Modes
    x_ddot: float
    y_ddot: float
    theta_ddot: float
    f_x: float
    f_y: float
    xi: float
    slip: float
    lift_o: float
    lift_o_prime: float


class OnsetArrays(Fields[NDArray[Any]], fields_of=Onset):
    """How motions begin: :func:`onset`'s answer for arrays, with those of the fields that were asked for.

    Arrays have the shape of the operands broadcast together, and units and signs as in :class:`Onset`; ``mode`` has codes of
    :class:`Mode`, ``others`` bits of :class:`Modes`. ``pandas.DataFrame(answer.to_dict())`` has the fields as columns; of the answer
    itself, a tuple, pandas would make rows.
    """

    mode: ModeArray
    unique: NDArray[np.bool_]
    others: NDArray[np.uint16]
    x_ddot: NDArray[np.float64]
    y_ddot: NDArray[np.float64]
    theta_ddot: NDArray[np.float64]
    f_x: NDArray[np.float64]
    f_y: NDArray[np.float64]
    xi: NDArray[np.float64]
    slip: NDArray[np.float64]
    lift_o: NDArray[np.float64]
    lift_o_prime: NDArray[np.float64]


@overload
def classify(
    gamma: Number, k_prime: Number, k: Number, mu: Number, *, omega: Number | None = None, on_error: Literal["raise"] = "raise", names: Literal[False] = False, **options: Unpack[Options]
) -> Mode: ...
@overload
def classify(
    gamma: Number, k_prime: Number, k: Number, mu: Number, *, omega: Number | None = None, on_error: Literal["raise"] = "raise", names: Literal[True], **options: Unpack[Options]
) -> str: ...
@overload
def classify(
    gamma: Number, k_prime: Number, k: Number, mu: Number, *, omega: Number | None = None, on_error: Literal["null"], names: Literal[False] = False, **options: Unpack[Options]
) -> Mode | None: ...
@overload
def classify(
    gamma: Number, k_prime: Number, k: Number, mu: Number, *, omega: Number | None = None, on_error: Literal["null"], names: Literal[True], **options: Unpack[Options]
) -> str | None: ...
@overload
def classify(
    gamma: Array, k_prime: Array, k: Array, mu: Array, *, omega: Array | None = None, on_error: Literal["raise"] = "raise", names: Literal[False] = False, out: NDArray[np.uint8] | None = None, **options: Unpack[Options]
) -> ModeArray: ...
@overload
def classify(
    gamma: Array, k_prime: Array, k: Array, mu: Array, *, omega: Array | None = None, on_error: Literal["raise"] = "raise", names: Literal[True], **options: Unpack[Options]
) -> ModeNames: ...
@overload
def classify(
    gamma: Array, k_prime: Array, k: Array, mu: Array, *, omega: Array | None = None, on_error: Literal["null"], names: Literal[False] = False, **options: Unpack[Options]
) -> np.ma.MaskedArray[tuple[Any, ...], np.dtype[np.uint8]]: ...
@overload
def classify(
    gamma: Array, k_prime: Array, k: Array, mu: Array, *, omega: Array | None = None, on_error: Literal["null"], names: Literal[True], **options: Unpack[Options]
) -> np.ma.MaskedArray[tuple[Any, ...], np.dtype[np.str_]]: ...
@overload
def classify(
    gamma: PandasSeries | Array, k_prime: PandasSeries | Array, k: PandasSeries | Array, mu: PandasSeries | Array, *, omega: PandasSeries | Array | None = None, on_error: OnError = "raise", names: bool = False, **options: Unpack[Options]
) -> pd.Series[Any]: ...
@overload
def classify(
    gamma: PolarsSeries | Array, k_prime: PolarsSeries | Array, k: PolarsSeries | Array, mu: PolarsSeries | Array, *, omega: PolarsSeries | Array | None = None, on_error: OnError = "raise", names: bool = False, **options: Unpack[Options]
) -> pl.Series: ...
@overload
def classify(
    gamma: PyarrowArray | Array, k_prime: PyarrowArray | Array, k: PyarrowArray | Array, mu: PyarrowArray | Array, *, omega: PyarrowArray | Array | None = None, on_error: OnError = "raise", names: bool = False, **options: Unpack[Options]
) -> pa.Array: ...
@overload
def classify(
    gamma: ArrowLike | Array, k_prime: ArrowLike | Array, k: ArrowLike | Array, mu: ArrowLike | Array, *, omega: ArrowLike | Array | None = None, on_error: OnError = "raise", names: bool = False, **options: Unpack[Options]
) -> ArrowArray: ...
@overload
def classify(gamma: PandasFrame, *, omega: Number | None = None, map: Map | None = None, on_error: OnError = "raise", names: bool = False, **options: Unpack[Options]) -> pd.Series[Any]: ...
@overload
def classify(gamma: PolarsFrame, *, omega: Number | None = None, map: Map | None = None, on_error: OnError = "raise", names: bool = False, **options: Unpack[Options]) -> pl.Series: ...
@overload
def classify(gamma: PyarrowTable, *, omega: Number | None = None, map: Map | None = None, on_error: OnError = "raise", names: bool = False, **options: Unpack[Options]) -> pa.Array: ...
@overload
def classify(gamma: ArrowLike, *, omega: Number | None = None, map: Map | None = None, on_error: OnError = "raise", names: bool = False, **options: Unpack[Options]) -> ArrowArray: ...
def classify(
    gamma: Any,
    k_prime: Any = None,
    k: Any = None,
    mu: Any = None,
    *,
    omega: Any = None,
    map: Map | None = None,
    out: NDArray[np.uint8] | None = None,
    names: bool = False,
    on_error: OnError = "raise",
    threads: int | None = 1,
    progress: Progress = None,
    to: Side = "left",
    columns: None = None,
) -> Any:
    """The mode that begins: does the body rest, slide, rock, or slide and rock?

    A uniform block, 2B wide and 2H high, stands on a rough base; from rest, a force ``k`` (in units of its weight m g)
    that points left acts ``k_prime`` H above the centre of mass. Of the modes that satisfy the equations of motion,
    Coulomb's law and non-penetration it is the report's, as its maps resolve it (Figs. 3.9-3.11 and 4.7; equations
    3.1-3.45 and 4.1-4.97). The decision is exact for the float64 numbers given: no tolerance.

    Args:
        gamma: slenderness H/B, above zero. Or, in place of all four, a table with columns of these names.
        k_prime: height of the force above the centre of mass in H; below it, negative.
        k: force over weight, F/(m g), not negative.
        mu: Coulomb friction between body and base, not negative.
        omega: share ω = V/(2B q_u) of a base that crushes at the pressure q_u, which the weight alone needs of it; 0, a rigid base,
            if it is left out. From 1 on the ground fails, ``BF``. Beside a table a number, or a column of it: the one ``map``
            names, or one that is called ``omega``.
        map: for a table, which column holds what, as ``{"mu": "friction"}``, or a number that holds for all rows, as
            ``{"k_prime": 0.4}``. What is not named here is in the column of its own name. Where pandas labels columns by
            numbers, ``{"k": 2}`` is the column 2 and ``{"k": 2.0}`` the number.
        out: array of ``uint8`` for the answer to arrays, of their shape broadcast together; not with ``names`` or ``"null"``. Until
            the call returns it is not to be written or read elsewhere; another call into it is refused.
        names: give the report's symbols (``"SL"``) in place of codes.
        on_error: ``"null"`` leaves the answer out where a value is one that no body can have; ``"raise"`` names the first.
        threads: how many threads to use, one if it is left out; ``None`` for as many as there are processors. The answer is the same.
        progress: ``True`` for a bar (needs tqdm), or a function that is told how many points are done and how many there
            are, ``None`` if that is not known.
        to: where the force points. Modes and motions under a force to the right are mirror images, as one sees them.
        columns: of :func:`onset`, not here.

    Returns:
        The answer is of the kind of the operands:

        ========================================  ==================================  =================================
        operands                                  the answer                          with ``names``
        ========================================  ==================================  =================================
        numbers                                   :class:`Mode`                       ``str``
        arrays, lists; numbers beside them        :class:`ModeArray`, of codes        :class:`ModeNames`, of words
        masked arrays                             masked array                        masked array
        pandas Series, arrays beside them         Series of ``UInt8`` with the index  Series of dtype ``category``
        pandas DataFrame                          the same                            the same
        polars Series or DataFrame                Series of ``UInt8``                 Series of dtype ``Enum``
        pyarrow arrays, table, reader             Array of ``uint8``                  dictionary of strings
        other Arrow objects, as DuckDB relations  :class:`ArrowArray`                 dictionary of strings
        ========================================  ==================================  =================================

        Arrays broadcast; columns have one length, and Series of pandas one index. Where a value is missing (NaN, NA or None
        in pandas; null in polars and Arrow; masked), so is the answer. NaN elsewhere is an impossible value. ``out`` is
        returned if it is given; after an error it holds some of the answers. The GIL is released, and Ctrl-C obeyed.

    Raises:
        StandfastError: for the first value, in the order of C, that no body, force or friction can have (not finite,
            beyond 1e50, negative, a slenderness of zero), with its index; for shapes that do not broadcast, and for
            lengths and indexes that differ.
        TypeError: for operands that are not real numbers, or that are to be unwrapped first; the error says how.
        KeyError: if a table lacks a column.

    >>> classify(1, 0.4, 0.5, 0.6)
    <Mode.REST: 0>
    >>> classify(3, 0.8, [0.1, 0.5, 3], [[0.3], [0.05]])
    ModeArray([[0, 2, 2],
               [1, 3, 4]], dtype=uint8)
    >>> classify(3, 0.8, [0.1, 0.5, 3], 0.1, names=True)
    ModeNames(['RE', 'SRO-', 'SRO+'], dtype='<U5')
    >>> classify(0.8, 0.9167, 0.61, 0.6, omega=[0, 0.08, 1], names=True)
    ModeNames(['SL', 'RO', 'BF'], dtype='<U5')
    >>> classify(1, 0.4, [0.5, 0.7], [0.6, -0.5])
    Traceback (most recent call last):
    ...
    standfast.StandfastError: friction μ is -0.5 at index 1; expected a number from 0 to 1e50
    """
    if columns is not None:
        raise TypeError("columns is what onset computes; which column of a table holds what is said by map={...}")
    plain = omega is None and threads == 1 and progress is None and map is None and out is None
    if plain and are_plain(point := (gamma, k_prime, k, mu)):
        return _classify_point(point, run(threads, on_error, None, to), names)
    operands = read("classify", _NAMES, (gamma, k_prime, k, mu), map, optional=("omega", omega))
    with called(operands, threads, on_error, progress, to) as (how, form):
        if out is not None:
            _check_out(out, names, operands, how.null_errors)
        if isinstance(form, Arrow):
            found = operands.streamed(_standfast.classify_table, _standfast.classify_columns, names, how)
            if found is not None:
                return form.adopt(found)
        arrays, missing, how = operands.native(how)
        codes, missing = _standfast.classify(arrays, missing, out, how)
    return out if out is not None else form.column("mode", codes, missing, symbols=names)


def _classify_point(point: tuple[float, float, float, float], how: Run, names: bool) -> Mode | str | None:
    """One point, without the arrays and forms that many have."""
    try:
        mode = _MODES[_standfast.classify_point(*point, how.right)]
    except OverflowError:
        # Of integers beyond float64 `read` says which.
        read("classify", _NAMES, point)
        raise
    except ValueError:
        if how.null_errors:
            return None
        raise
    return mode.symbol if names else mode


@overload
def onset(
    gamma: Number, k_prime: Number, k: Number, mu: Number, *, omega: Number | None = None, columns: Sequence[str] | None = None, on_error: Literal["raise"] = "raise", **options: Unpack[Options]
) -> Onset: ...
@overload
def onset(
    gamma: Number, k_prime: Number, k: Number, mu: Number, *, omega: Number | None = None, columns: Sequence[str] | None = None, on_error: Literal["null"], **options: Unpack[Options]
) -> Onset | None: ...
@overload
def onset(
    gamma: Array, k_prime: Array, k: Array, mu: Array, *, omega: Array | None = None, columns: Sequence[str] | None = None, on_error: OnError = "raise", **options: Unpack[Options]
) -> OnsetArrays: ...
@overload
def onset(
    gamma: PandasSeries | Array, k_prime: PandasSeries | Array, k: PandasSeries | Array, mu: PandasSeries | Array, *, omega: PandasSeries | Array | None = None, columns: Sequence[str] | None = None, on_error: OnError = "raise", **options: Unpack[Options]
) -> pd.DataFrame: ...
@overload
def onset(
    gamma: PolarsSeries | Array, k_prime: PolarsSeries | Array, k: PolarsSeries | Array, mu: PolarsSeries | Array, *, omega: PolarsSeries | Array | None = None, columns: Sequence[str] | None = None, on_error: OnError = "raise", **options: Unpack[Options]
) -> pl.DataFrame: ...
@overload
def onset(
    gamma: PyarrowArray | Array, k_prime: PyarrowArray | Array, k: PyarrowArray | Array, mu: PyarrowArray | Array, *, omega: PyarrowArray | Array | None = None, columns: Sequence[str] | None = None, on_error: OnError = "raise", **options: Unpack[Options]
) -> pa.Table: ...
@overload
def onset(
    gamma: ArrowLike | Array, k_prime: ArrowLike | Array, k: ArrowLike | Array, mu: ArrowLike | Array, *, omega: ArrowLike | Array | None = None, columns: Sequence[str] | None = None, on_error: OnError = "raise", **options: Unpack[Options]
) -> ArrowTable: ...
@overload
def onset(gamma: PandasFrame, *, omega: Number | None = None, map: Map | None = None, columns: Sequence[str] | None = None, on_error: OnError = "raise", **options: Unpack[Options]) -> pd.DataFrame: ...
@overload
def onset(gamma: PolarsFrame, *, omega: Number | None = None, map: Map | None = None, columns: Sequence[str] | None = None, on_error: OnError = "raise", **options: Unpack[Options]) -> pl.DataFrame: ...
@overload
def onset(gamma: PyarrowTable, *, omega: Number | None = None, map: Map | None = None, columns: Sequence[str] | None = None, on_error: OnError = "raise", **options: Unpack[Options]) -> pa.Table: ...
@overload
def onset(gamma: ArrowLike, *, omega: Number | None = None, map: Map | None = None, columns: Sequence[str] | None = None, on_error: OnError = "raise", **options: Unpack[Options]) -> ArrowTable: ...
def onset(
    gamma: Any,
    k_prime: Any = None,
    k: Any = None,
    mu: Any = None,
    *,
    omega: Any = None,
    columns: Sequence[str] | None = None,
    map: Map | None = None,
    on_error: OnError = "raise",
    threads: int | None = 1,
    progress: Progress = None,
    to: Side = "left",
) -> Any:
    """The mode that begins, with its motion and reactions, and whether it is the only one.

    The operands, ``omega``, ``map``, ``on_error``, ``threads``, ``progress`` and ``to`` are those of :func:`classify`.

    Args:
        columns: which fields of :class:`Onset` to compute, in this order; all if it is left out.

    Returns:
        For four numbers an :class:`Onset`, for arrays :class:`OnsetArrays`; for columns and tables a DataFrame of pandas
        (with the index) or polars, a Table of pyarrow, or an :class:`ArrowTable`. What is missing is so as for
        :func:`classify`, in every column.

    The motion is that of the report's equations (3.3-3.8, 3.14-3.16, 3.30, 3.37, 3.43, 3.45; 4.36-4.39, 4.64, 4.76,
    4.89, 4.95). Where several modes satisfy every law (force below the centre of mass, friction above 4/3: Painlevé's
    indeterminacy) the report's choice is the mode, and ``others`` holds the rest. Of bearing failure there is no motion: its
    numbers are NaN. On a base that crushes the body turns about a neutral point inside of it, and ``xi`` is where the crushed part
    bears (docs/theory/base.md).

    Raises:
        StandfastError, TypeError, KeyError: as :func:`classify`.

    >>> rocks = onset(1, 1, 2, 5)
    >>> rocks.mode, rocks.unique, rocks.theta_ddot, rocks.f_y
    (<Mode.ROCK_O: 2>, True, 1.125, 2.125)
    >>> unsure = onset(1, -0.5, 4, [0.3, 3], columns=["unique", "others"])
    >>> unsure.unique
    array([ True, False])
    >>> Modes(unsure.others[1]).modes
    (<Mode.ROCK_O: 2>,)
    """
    fields = chosen(columns, Onset._fields)
    operands = read("onset", _NAMES, (gamma, k_prime, k, mu), map, result="theta_ddot", optional=("omega", omega))
    with called(operands, threads, on_error, progress, to) as (how, form):
        if isinstance(form, Arrow):
            found = operands.streamed(_standfast.onset_table, _standfast.onset_columns, fields, how)
            if found is not None:
                return form.adopt_table(found)
        arrays, missing, how = operands.native(how)
        values, missing = _standfast.onset(arrays, missing, fields, how)
    return form.table(dict(zip(fields, values)), missing, point=Onset, arrays=OnsetArrays)


def _check_out(out: object, names: bool, operands: Operands, null_errors: bool) -> None:
    if names:
        raise TypeError("out holds codes; it cannot be given together with names")
    if null_errors:
        raise TypeError("out has no code for an answer that is left out; it cannot be given together with on_error='null'")
    if not isinstance(operands.form, (Point, Arrays)) or operands.form.masked:
        raise TypeError("out is for plain arrays; the answer for columns and tables is of their kind")
    # Of other subclasses, as masked arrays, the codes are a part only.
    if not isinstance(out, np.ndarray) or type(out) not in (np.ndarray, np.memmap) or out.dtype != np.uint8:
        found = f"an array of {out.dtype}" if type(out) is np.ndarray else f"a {type(out).__name__}"
        raise TypeError(f"out is {found}; expected a numpy array of uint8")
    if not out.flags.writeable:
        raise StandfastError("out is read-only; expected an array that can be written to")


@overload
def symbols(codes: int | np.integer[Any]) -> str: ...
@overload
def symbols(codes: Array) -> ModeNames: ...
@overload
def symbols(codes: PandasSeries) -> pd.Series[Any]: ...
@overload
def symbols(codes: PolarsSeries) -> pl.Series: ...
@overload
def symbols(codes: PyarrowArray) -> pa.Array: ...
@overload
def symbols(codes: ArrowLike) -> ArrowArray: ...
def symbols(codes: Any) -> Any:
    """The report's symbols for mode codes: an array of strings of the same shape, or a ``str`` for one code.

    A pandas or polars Series or an Arrow array gives one of its kind, with categories; what is missing stays missing.

    Raises:
        StandfastError: if a code is not that of a mode.
        TypeError: for bits of sets of modes.

    >>> symbols([0, 5])
    ModeNames(['RE', "SRO'-"], dtype='<U5')
    >>> symbols(Mode.SLIDE_LEFT)
    'SL'
    """
    if isinstance(codes, Modes) or str(getattr(codes, "dtype", getattr(codes, "type", ""))).lower() == "uint16":
        raise TypeError("codes are sets of modes, in bits; expected codes, of uint8. Modes(bits).modes has the modes of a set")
    operands = read("symbols", ("codes",), (codes,))
    (values,), missing = operands.arrays()
    right = (values >= 0) & (values < len(SYMBOLS)) & (values == np.floor(values))
    if not np.all(right):
        raise StandfastError(f"{values[~right].flat[0]:g} is not the code of a mode; expected 0 to {len(SYMBOLS) - 1}")
    return operands.form.column("mode", values.astype(np.uint8), missing, symbols=True)
