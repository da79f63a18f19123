"""Modes and motions of points, one or millions: scalars, numpy arrays, Arrow columns and tables."""

from __future__ import annotations

import operator
from collections.abc import Mapping
from typing import Any, Literal, NamedTuple, Protocol, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _standfast
from ._modes import Mode, Modes, symbols
from ._standfast import ArrowArray, ArrowTable

_NAMES = ("gamma", "k_prime", "k", "mu")
_REAL = "fiu"


class _ArrowColumn(Protocol):
    """An Arrow array; chunked ones have ``__arrow_c_stream__`` in its place."""

    def __arrow_c_array__(self, requested_schema: object | None = None) -> tuple[object, object]: ...


class _ArrowStream(Protocol):
    """An Arrow table, chunked array, or reader of record batches."""

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object: ...


_Columns = Mapping[str, "str | float"]
_Arrow = _ArrowColumn | _ArrowStream


class Onset(NamedTuple):
    """How a motion begins: :func:`onset`'s answer.

    Arrays have the shape of the operands broadcast together; for four scalars each field is one. Lengths are in B
    (half the width), accelerations in g, the angular acceleration in g/B, forces in m g. Right and up are positive,
    and counter-clockwise.
    """

    #: The mode, as ``uint8`` codes of :class:`Mode`.
    mode: Any
    #: Whether no other mode satisfies every law.
    unique: Any
    #: The other modes that satisfy every law, as ``uint16`` bits of :class:`Modes`; zero where ``unique``.
    others: Any
    #: ẍ of the centre of mass.
    x_ddot: Any
    #: ÿ of the centre of mass.
    y_ddot: Any
    #: θ̈.
    theta_ddot: Any
    #: Horizontal reaction on the body.
    f_x: Any
    #: Vertical reaction on the body.
    f_y: Any
    #: ξ, where f_y acts, right of the centre of mass.
    xi: Any
    #: ẍ of the base along the ground.
    slip: Any
    #: ÿ of the left corner O.
    lift_o: Any
    #: ÿ of the right corner O'.
    lift_o_prime: Any


def _is_arrow(value: Any) -> bool:
    """Whether a value comes by the Arrow PyCapsule interface.

    A pandas Series counts as the numpy array it is, and xarray objects are for :func:`_operand` to refuse.
    """
    if isinstance(value, np.ndarray) or hasattr(value, "iloc") or _is_xarray(value):
        return False
    return hasattr(value, "__arrow_c_array__") or hasattr(value, "__arrow_c_stream__")


def _is_xarray(value: Any) -> bool:
    return hasattr(value, "dims") and hasattr(value, "coords")


def _is_table(value: Any) -> bool:
    """Whether a single argument is meant as a table; a pandas DataFrame is one."""
    return _is_arrow(value) or (hasattr(value, "iloc") and hasattr(value, "__arrow_c_stream__"))


def _operand(value: Any, name: str) -> NDArray[Any]:
    """The value as an array that the native module reads; copied only if its type is none the module knows."""
    if not isinstance(value, np.ndarray):
        if hasattr(value, "__dask_graph__"):
            raise TypeError(
                f"{name} is a lazy Dask collection, which would be loaded into this process whole; expected an array. "
                "Call dask.array.map_blocks(standfast.classify, ...), or xarray.apply_ufunc with dask='parallelized'"
            )
        if _is_xarray(value):
            raise TypeError(
                f"{name} is an xarray object, whose dimensions have names; expected an array. "
                "Call xarray.apply_ufunc(standfast.classify, ...), which matches the names"
            )
        value = np.asarray(value)
    array: NDArray[Any] = value
    if isinstance(array, np.ma.MaskedArray):
        raise TypeError(f"{name} is a masked array, whose mask would be lost; expected a plain array")
    dtype = array.dtype
    if dtype.kind == "O":
        try:
            return array.astype(np.float64)
        except (TypeError, ValueError) as error:
            raise TypeError(f"{name} holds objects that are no real numbers: {error}") from None
    if dtype.kind not in _REAL:
        raise TypeError(f"{name} has dtype {dtype}; expected real numbers, as float64")
    if dtype.itemsize > 8 or not dtype.isnative:
        return array.astype(np.float64)
    return array


def _threads(threads: int | None) -> int | None:
    if threads is None:
        return None
    try:
        number = operator.index(threads)
    except TypeError:
        number = 0
    if number < 1 or isinstance(threads, bool):
        raise ValueError(f"threads is {threads!r}; expected a whole number above zero, or None for all processors")
    return number


def _places(columns: _Columns | None) -> list[str | float]:
    """Where a table has each operand."""
    columns = {} if columns is None else dict(columns)
    unknown = [name for name in columns if name not in _NAMES]
    if unknown:
        raise ValueError(f"columns has the key {unknown[0]!r}; expected {', '.join(_NAMES)}")
    places = [columns.get(name, name) for name in _NAMES]
    for place, name in zip(places, _NAMES):
        if not isinstance(place, (str, int, float, np.integer, np.floating)) or isinstance(place, bool):
            raise TypeError(f"columns gives {place!r} for {name}; expected the name of a column, or a number")
    return places


def _points(gamma: Any, k_prime: Any, k: Any, mu: Any) -> tuple[Any, Any, Any, Any]:
    given = (gamma, k_prime, k, mu)
    missing = [name for name, value in zip(_NAMES, given) if value is None]
    if missing:
        raise TypeError(f"{', '.join(missing)} missing; expected gamma, k_prime, k and mu, or one Arrow table")
    return given


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
    gamma: _Arrow, *, columns: _Columns | None = None, threads: int | None = 1, names: bool = False
) -> ArrowArray: ...
def classify(
    gamma: Any,
    k_prime: Any = None,
    k: Any = None,
    mu: Any = None,
    *,
    columns: _Columns | None = None,
    out: Any = None,
    threads: int | None = 1,
    names: bool = False,
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
    threads = _threads(threads)
    if k_prime is None and k is None and mu is None and _is_table(gamma):
        if out is not None:
            raise TypeError("out is for arrays; the answer for a table is an Arrow array")
        return _standfast.classify_table(gamma, _places(columns), threads, names)
    if columns is not None:
        raise TypeError("columns is for a table, given in place of gamma, k_prime, k and mu")
    given = _points(gamma, k_prime, k, mu)
    if any(map(_is_arrow, given)):
        if out is not None:
            raise TypeError("out is for arrays; the answer for Arrow columns is an Arrow array")
        return _standfast.classify_columns(_arrow_operands(given), threads, names)
    if out is not None:
        if names:
            raise TypeError("out holds codes; it cannot be given together with names")
        if not isinstance(out, np.ndarray) or out.dtype != np.uint8:
            found = f"an array of {out.dtype}" if isinstance(out, np.ndarray) else f"a {type(out).__name__}"
            raise TypeError(f"out is {found}; expected a numpy array of uint8")
        if not out.flags.writeable:
            raise ValueError("out is read-only; expected an array that can be written to")
    codes = _standfast.classify(list(map(_operand, given, _NAMES)), out, threads)
    if out is not None:
        return out
    if codes.ndim == 0:
        mode = Mode(int(codes))
        return mode.symbol if names else mode
    return symbols(codes) if names else codes


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
def onset(gamma: _Arrow, *, columns: _Columns | None = None, threads: int | None = 1) -> ArrowTable: ...
def onset(
    gamma: Any,
    k_prime: Any = None,
    k: Any = None,
    mu: Any = None,
    *,
    columns: _Columns | None = None,
    threads: int | None = 1,
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
    threads = _threads(threads)
    if k_prime is None and k is None and mu is None and _is_table(gamma):
        return _standfast.onset_table(gamma, _places(columns), threads)
    if columns is not None:
        raise TypeError("columns is for a table, given in place of gamma, k_prime, k and mu")
    given = _points(gamma, k_prime, k, mu)
    if any(map(_is_arrow, given)):
        return _standfast.onset_columns(_arrow_operands(given), threads)
    mode, others, motion = _standfast.onset(list(map(_operand, given, _NAMES)), threads)
    if mode.ndim == 0:
        bits = Modes(int(others))
        return Onset(Mode(int(mode)), not bits, bits, *map(float, motion))
    return Onset(mode, others == 0, others, *motion)


def _arrow_operands(given: tuple[Any, ...]) -> list[Any]:
    """Arrow columns as they are, all else as a float."""
    operands = []
    for value, name in zip(given, _NAMES):
        if not _is_arrow(value):
            array = _operand(value, name)
            if array.ndim > 0:
                raise TypeError(f"{name} is a numpy array beside Arrow columns; expected an Arrow column or a number")
            value = float(array)
        operands.append(value)
    return operands
