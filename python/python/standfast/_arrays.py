"""Modes and motions of points, one or millions: scalars, numpy arrays, columns and tables."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal, Protocol, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _standfast
from ._arrow import ArrowArray, ArrowTable
from ._frames import SYMBOLS, Arrays, Arrow, Fields, Point
from ._inputs import Map, Operands, read
from ._modes import Mode, Modes
from ._run import Progress, run

_NAMES = ("gamma", "k_prime", "k", "mu")


class _ArrowColumn(Protocol):
    """An Arrow array; chunked ones have ``__arrow_c_stream__`` in its place."""

    def __arrow_c_array__(self, requested_schema: object | None = None) -> tuple[object, object]: ...


class _ArrowStream(Protocol):
    """An Arrow table, chunked array, or reader of record batches."""

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object: ...


_Arrow = _ArrowColumn | _ArrowStream


class Onset(Fields[Any]):
    """How a motion begins: :func:`onset`'s answer for four plain numbers.

    Lengths are in B (half the width), accelerations in g, the angular acceleration in g/B, forces in m g. Right and up
    are positive, and counter-clockwise.
    """

    #: The mode.
    mode: Mode
    #: Whether no other mode satisfies every law.
    unique: bool
    #: The other modes that satisfy every law; none where ``unique``.
    others: Modes
    #: ẍ of the centre of mass.
    x_ddot: float
    #: ÿ of the centre of mass.
    y_ddot: float
    #: θ̈.
    theta_ddot: float
    #: Horizontal reaction on the body.
    f_x: float
    #: Vertical reaction on the body.
    f_y: float
    #: ξ, where f_y acts, right of the centre of mass.
    xi: float
    #: ẍ of the base along the ground.
    slip: float
    #: ÿ of the left corner O.
    lift_o: float
    #: ÿ of the right corner O'.
    lift_o_prime: float


class OnsetArrays(Fields[NDArray[Any]]):
    """How motions begin: :func:`onset`'s answer for arrays, with those of the fields of :class:`Onset` that were asked for.

    Arrays have the shape of the operands broadcast together, and units and signs as in :class:`Onset`.
    """

    #: The mode, as codes of :class:`Mode`.
    mode: NDArray[np.uint8]
    #: Whether no other mode satisfies every law.
    unique: NDArray[np.bool_]
    #: The other modes that satisfy every law, as bits of :class:`Modes`; zero where ``unique``.
    others: NDArray[np.uint16]
    #: ẍ of the centre of mass.
    x_ddot: NDArray[np.float64]
    #: ÿ of the centre of mass.
    y_ddot: NDArray[np.float64]
    #: θ̈.
    theta_ddot: NDArray[np.float64]
    #: Horizontal reaction on the body.
    f_x: NDArray[np.float64]
    #: Vertical reaction on the body.
    f_y: NDArray[np.float64]
    #: ξ, where f_y acts, right of the centre of mass.
    xi: NDArray[np.float64]
    #: ẍ of the base along the ground.
    slip: NDArray[np.float64]
    #: ÿ of the left corner O.
    lift_o: NDArray[np.float64]
    #: ÿ of the right corner O'.
    lift_o_prime: NDArray[np.float64]


@overload
def classify(  # type: ignore[overload-overlap]
    gamma: float, k_prime: float, k: float, mu: float, *, threads: int | None = 1, names: Literal[False] = False
) -> Mode: ...
@overload
def classify(  # type: ignore[overload-overlap]
    gamma: float, k_prime: float, k: float, mu: float, *, threads: int | None = 1, names: Literal[True]
) -> str: ...
@overload
def classify(
    gamma: ArrayLike,
    k_prime: ArrayLike,
    k: ArrayLike,
    mu: ArrayLike,
    *,
    out: NDArray[np.uint8] | None = None,
    threads: int | None = 1,
    names: Literal[False] = False,
) -> NDArray[np.uint8]: ...
@overload
def classify(
    gamma: ArrayLike,
    k_prime: ArrayLike,
    k: ArrayLike,
    mu: ArrayLike,
    *,
    threads: int | None = 1,
    names: Literal[True],
) -> NDArray[np.str_]: ...
@overload
def classify(
    gamma: _Arrow | float,
    k_prime: _Arrow | float,
    k: _Arrow | float,
    mu: _Arrow | float,
    *,
    threads: int | None = 1,
    names: bool = False,
) -> ArrowArray: ...
@overload
def classify(
    gamma: _Arrow, *, map: Map | None = None, threads: int | None = 1, names: bool = False
) -> ArrowArray: ...
def classify(
    gamma: Any,
    k_prime: Any = None,
    k: Any = None,
    mu: Any = None,
    *,
    map: Map | None = None,
    out: Any = None,
    threads: int | None = 1,
    names: bool = False,
    on_error: Literal["raise", "null"] = "raise",
    progress: Progress | None = None,
) -> Any:
    """The mode that begins: does the body rest, slide, rock, or slide and rock?

    A uniform block, 2B wide and 2H high, stands on a rough base; from rest, a force ``k`` (in units of its weight m g)
    that points left acts ``k_prime`` H above the centre of mass. Of the modes that satisfy the equations of motion,
    Coulomb's law and non-penetration it is the report's, as its maps resolve it (Figs. 3.9-3.11 and 4.7; equations
    3.1-3.45 and 4.1-4.97). The decision is exact for the float64 numbers given: no tolerance.

    Args:
        gamma: slenderness H/B, above zero.
        k_prime: height of the force above the centre of mass in H; below it, negative.
        k: force over weight, F/(m g), not negative.
        mu: Coulomb friction between body and base, not negative.
        columns: for a table, which column holds what, as ``{"mu": "friction"}``, or a number that holds for all
            rows, as ``{"k_prime": 0.4}``. What is not named here is in the column of its own name.
        out: array of ``uint8`` for the answer, of the shape of the operands broadcast together.
        threads: how many threads to use; ``None`` for as many as there are processors. The answer is the same.
        names: give the report's symbols (``"SL"``) in place of codes.

    The four operands are

    * scalars: the answer is a :class:`Mode`, or a ``str`` with ``names``;
    * arrays of any real dtype, shape and strides that broadcast together, mixed with scalars: the answer is an array
      of ``uint8`` codes (or of strings) in the memory order of the operands. Float64 columns are read where they lie,
      all else block by block; only long double, byte-swapped and object arrays are converted first. A pandas Series
      is an array;
    * Arrow columns (pyarrow, polars, DuckDB, ...; chunked or not), mixed with scalars: the answer is an
      :class:`ArrowArray`, null where an operand is null, dictionary-encoded strings with ``names``. Only columns with
      nulls are copied.

    In place of the four, one table (pyarrow, polars, pandas, DuckDB relation, a reader of record batches) with the
    columns ``gamma``, ``k_prime``, ``k``, ``mu`` is read batch by batch; the answer is an :class:`ArrowArray`.

    The GIL is released.

    Returns:
        As above; ``out`` if that is given. After an error ``out`` holds some of the answers.

    Raises:
        ValueError: for the first value, in the order of C, that no body, force or friction can have (not finite,
            beyond 1e50, negative, a slenderness of zero), with its index; for shapes that do not broadcast.
        TypeError: for operands that are no real numbers.
        KeyError: if a table lacks a column.

    >>> classify(1, 0.4, 0.5, 0.6)
    <Mode.REST: 0>
    >>> classify(3, 0.8, [0.1, 0.5, 3], [[0.3], [0.05]])
    array([[0, 2, 2],
           [1, 3, 4]], dtype=uint8)
    >>> classify(3, 0.8, [0.1, 0.5, 3], 0.1, names=True)
    array(['RE', 'SRO-', 'SRO+'], dtype='<U5')
    >>> classify(1, 0.4, [0.5, 0.7], [0.6, -0.5])
    Traceback (most recent call last):
    ...
    ValueError: friction μ is -0.5 at index 1; expected a number from 0 to 1e50
    """
    how = run(threads, on_error, progress)
    operands = read("classify", _NAMES, (gamma, k_prime, k, mu), map)
    form = operands.form.with_errors(how.null_errors)
    if out is not None:
        _check_out(out, names, operands)
    if operands.table is not None or operands.columns is not None:
        if operands.table is not None:
            found = _standfast.classify_table(*operands.table, names, how)
        else:
            assert operands.columns is not None
            found = _standfast.classify_columns(operands.columns, names, how)
        assert isinstance(form, Arrow)
        return form.adopt(found)
    arrays, missing = operands.arrays()
    codes, missing = _standfast.classify(arrays, missing, out, how)
    return out if out is not None else form.column("mode", codes, missing, symbols=names)


@overload
def onset(
    gamma: ArrayLike, k_prime: ArrayLike, k: ArrayLike, mu: ArrayLike, *, threads: int | None = 1
) -> Onset: ...
@overload
def onset(
    gamma: _Arrow | float,
    k_prime: _Arrow | float,
    k: _Arrow | float,
    mu: _Arrow | float,
    *,
    threads: int | None = 1,
) -> ArrowTable: ...
@overload
def onset(gamma: _Arrow, *, map: Map | None = None, threads: int | None = 1) -> ArrowTable: ...
def onset(
    gamma: Any,
    k_prime: Any = None,
    k: Any = None,
    mu: Any = None,
    *,
    map: Map | None = None,
    columns: Sequence[str] | None = None,
    threads: int | None = 1,
    on_error: Literal["raise", "null"] = "raise",
    progress: Progress | None = None,
) -> Any:
    """The mode that begins, with its motion and reactions, and whether it is the only one.

    Args are those of :func:`classify`, and the operands may be the same: scalars, arrays, Arrow columns, a table.

    Returns:
        An :class:`Onset`: of scalars for scalars, of arrays for arrays. For Arrow columns and tables an
        :class:`ArrowTable` with the fields of :class:`Onset` as columns, null where an operand is null.

    The motion is that of the report's equations (3.3-3.8, 3.14-3.16, 3.30, 3.37, 3.43, 3.45; 4.36-4.39, 4.64, 4.76,
    4.89, 4.95). Where several modes satisfy every law (force below the centre of mass, friction above 4/3: Painlevé's
    indeterminacy) the report's choice is the mode, and ``others`` holds the rest.

    Raises:
        ValueError, TypeError, KeyError: as :func:`classify`.

    >>> rocks = onset(1, 1, 2, 5)
    >>> rocks.mode, rocks.unique, rocks.theta_ddot, rocks.f_y
    (<Mode.ROCK_O: 2>, True, 1.125, 2.125)
    >>> unsure = onset(1, -0.5, 4, [0.3, 3])
    >>> unsure.unique
    array([ True, False])
    >>> Modes(int(unsure.others[1])).modes
    (<Mode.ROCK_O: 2>,)
    """
    how = run(threads, on_error, progress)
    operands = read("onset", _NAMES, (gamma, k_prime, k, mu), map)
    form = operands.form.with_errors(how.null_errors)
    if operands.table is not None or operands.columns is not None:
        if operands.table is not None:
            found = _standfast.onset_table(*operands.table, columns, how)
        else:
            assert operands.columns is not None
            found = _standfast.onset_columns(operands.columns, columns, how)
        assert isinstance(form, Arrow)
        return form.adopt_table(found)
    arrays, missing = operands.arrays()
    values, missing = _standfast.onset(arrays, missing, columns, how)
    named = dict(zip(OnsetArrays._fields if columns is None else columns, values))
    return form.table(named, missing, point=Onset, arrays=OnsetArrays)


def _check_out(out: object, names: bool, operands: Operands) -> None:
    if names:
        raise TypeError("out holds codes; it cannot be given together with names")
    if not isinstance(operands.form, (Point, Arrays)) or operands.form.masked:
        raise TypeError("out is for plain arrays; the answer for columns and tables is of their kind")
    if not isinstance(out, np.ndarray) or out.dtype != np.uint8:
        found = f"an array of {out.dtype}" if isinstance(out, np.ndarray) else f"a {type(out).__name__}"
        raise TypeError(f"out is {found}; expected a numpy array of uint8")
    if not out.flags.writeable:
        raise ValueError("out is read-only; expected an array that can be written to")


def symbols(codes: Any) -> Any:
    """The report's symbols for mode codes: an array of strings of the same shape, or a ``str`` for one code.

    A pandas or polars Series or an Arrow array gives one of its kind, with categories; what is missing stays missing.

    Raises:
        ValueError: if a code is not that of a mode.

    >>> symbols([0, 5])
    array(['RE', "SRO'-"], dtype='<U5')
    >>> symbols(Mode.SLIDE_LEFT)
    'SL'
    """
    operands = read("symbols", ("codes",), (codes,))
    (values,), missing = operands.arrays()
    right = (values >= 0) & (values < len(SYMBOLS)) & (values == np.floor(values))
    if not np.all(right):
        raise ValueError(f"{values[~right].flat[0]:g} is not the code of a mode; expected 0 to {len(SYMBOLS) - 1}")
    return operands.form.column("mode", values.astype(np.uint8), missing, symbols=True)
