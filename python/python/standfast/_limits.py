"""Limit states of points: how far each inequality is from failing, for reliability methods."""

# A number is also what can be read as an array; the first overload that fits is meant.
# mypy: disable-error-code="overload-overlap"

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Literal, overload

import numpy as np
from numpy.typing import NDArray

from . import _standfast
from ._arrow import ArrowTable
from ._frames import Fields
from ._inputs import called, chosen, read
from ._types import Array, Map, Number, Options, OnError, PandasFrame, PandasSeries, PolarsFrame, PolarsSeries, Progress
from ._types import Arrow as ArrowLike
from ._types import PyarrowArray, PyarrowTable
from ._types import Side

if TYPE_CHECKING:
    import pandas as pd  # type: ignore[import-untyped,unused-ignore]
    import polars as pl
    import pyarrow as pa  # type: ignore[import-untyped,unused-ignore]
    from typing_extensions import Unpack

_NAMES = ("gamma", "k_prime", "k", "mu")


class LimitStates(Fields[float]):
    """How far a point is from each inequality that decides its mode: :func:`limit_states`' answer for four plain numbers.

    Each is negative where what it is named for happens. Lengths are in B (half the width), forces in m g. O is the bottom left
    corner, O' the bottom right one. Numbers in parentheses are the report's equations.

    Attributes:
        slide: the body slides: μ - k, in m g (3.4, 4.7).
        rock_O: at rest it overturns about O: 1 - γk(1+k'), the distance of the reaction from O in B (3.5, 4.10).
        rock_O_prime: it overturns about O': 1 + γk(1+k'), the distance of the reaction from O' in B (4.10 about O').
        turn_O: sliding, it turns about O: 1 - γ(μ + kk'), the distance of the reaction from O in B (after 3.8, 4.19).
        turn_O_prime: sliding, it turns about O': 1 + γ(μ + kk'), the distance of the reaction from O' in B (4.18, 4.92).
        slip_O_left: rocking about O, O slips to the left: μf_y - f_x, in m g (3.24, 3.40; 4.40, 4.77).
        slip_O_right: rocking about O, O slips to the right: μf_y + f_x, in m g (3.24, 3.45).
        slip_O_prime_left: rocking about O', O' slips to the left: μf_y - f_x, in m g (4.96).
        slip_O_prime_right: rocking about O', O' slips to the right: μf_y + f_x, in m g; decides under a force to the right only.
        load_factor: the multiple of the force at which the body leaves rest: the lesser of both factors; ``inf`` at k = 0.
        SF_sliding: safety factor against sliding, μ/k; ``inf`` at k = 0.
        SF_overturning: safety factor against overturning, 1/(γk|1+k'|); ``inf`` where the force has no moment about the corner.
    """

    slide: float
    rock_O: float
    rock_O_prime: float
    turn_O: float
    turn_O_prime: float
    slip_O_left: float
    slip_O_right: float
    slip_O_prime_left: float
    slip_O_prime_right: float
    load_factor: float
    SF_sliding: float
    SF_overturning: float


class LimitStatesArrays(Fields[NDArray[np.float64]], fields_of=LimitStates):
    """:func:`limit_states`' answer for arrays: those of the fields that were asked for, in the shape of the operands broadcast
    together. ``pandas.DataFrame(answer.to_dict())`` has them as columns.
    """

    slide: NDArray[np.float64]
    rock_O: NDArray[np.float64]
    rock_O_prime: NDArray[np.float64]
    turn_O: NDArray[np.float64]
    turn_O_prime: NDArray[np.float64]
    slip_O_left: NDArray[np.float64]
    slip_O_right: NDArray[np.float64]
    slip_O_prime_left: NDArray[np.float64]
    slip_O_prime_right: NDArray[np.float64]
    load_factor: NDArray[np.float64]
    SF_sliding: NDArray[np.float64]
    SF_overturning: NDArray[np.float64]


@overload
def limit_states(
    gamma: Number, k_prime: Number, k: Number, mu: Number,
    *, columns: Sequence[str] | None = None, on_error: Literal["raise"] = "raise", **options: Unpack[Options],
) -> LimitStates: ...
@overload
def limit_states(
    gamma: Number, k_prime: Number, k: Number, mu: Number,
    *, columns: Sequence[str] | None = None, on_error: Literal["null"], **options: Unpack[Options],
) -> LimitStates | None: ...
@overload
def limit_states(
    gamma: Array, k_prime: Array, k: Array, mu: Array,
    *, columns: Sequence[str] | None = None, on_error: OnError = "raise", **options: Unpack[Options],
) -> LimitStatesArrays: ...
@overload
def limit_states(
    gamma: PandasFrame,
    *, columns: Sequence[str] | None = None, map: Map | None = None, on_error: OnError = "raise", **options: Unpack[Options],
) -> pd.DataFrame: ...
@overload
def limit_states(
    gamma: PolarsFrame,
    *, columns: Sequence[str] | None = None, map: Map | None = None, on_error: OnError = "raise", **options: Unpack[Options],
) -> pl.DataFrame: ...
@overload
def limit_states(
    gamma: PyarrowTable,
    *, columns: Sequence[str] | None = None, map: Map | None = None, on_error: OnError = "raise", **options: Unpack[Options],
) -> pa.Table: ...
@overload
def limit_states(
    gamma: ArrowLike,
    *, columns: Sequence[str] | None = None, map: Map | None = None, on_error: OnError = "raise", **options: Unpack[Options],
) -> ArrowTable: ...
@overload
def limit_states(
    gamma: PandasSeries | Array, k_prime: PandasSeries | Array, k: PandasSeries | Array, mu: PandasSeries | Array,
    *, columns: Sequence[str] | None = None, on_error: OnError = "raise", **options: Unpack[Options],
) -> pd.DataFrame: ...
@overload
def limit_states(
    gamma: PolarsSeries | Array, k_prime: PolarsSeries | Array, k: PolarsSeries | Array, mu: PolarsSeries | Array,
    *, columns: Sequence[str] | None = None, on_error: OnError = "raise", **options: Unpack[Options],
) -> pl.DataFrame: ...
@overload
def limit_states(
    gamma: PyarrowArray | Array, k_prime: PyarrowArray | Array, k: PyarrowArray | Array, mu: PyarrowArray | Array,
    *, columns: Sequence[str] | None = None, on_error: OnError = "raise", **options: Unpack[Options],
) -> pa.Table: ...
@overload
def limit_states(
    gamma: ArrowLike | Array, k_prime: ArrowLike | Array, k: ArrowLike | Array, mu: ArrowLike | Array,
    *, columns: Sequence[str] | None = None, on_error: OnError = "raise", **options: Unpack[Options],
) -> ArrowTable: ...
def limit_states(
    gamma: Any,
    k_prime: Any = None,
    k: Any = None,
    mu: Any = None,
    *,
    columns: Sequence[str] | None = None,
    map: Map | None = None,
    on_error: OnError = "raise",
    threads: int | None = 1,
    progress: Progress = None,
    to: Side = "left",
) -> Any:
    """How far is each inequality that decides the mode from failing, as a limit state: negative where it fails?

    Each is one expression in γ, k', k and μ, without cases, and its sign is that of exact arithmetic. Together they decide the
    mode; the first line that holds does:

    ========  ====================================================
    mode      if
    ========  ====================================================
    RE        slide >= 0 and rock_O >= 0 and rock_O_prime >= 0
    SL        slide < 0 and turn_O >= 0 and turn_O_prime >= 0
    RO'       rock_O_prime < 0 and slip_O_prime_left >= 0
    SRO'-     turn_O_prime < 0
    SRO-      slip_O_left < 0
    SRO+      slip_O_right < 0
    RO        else
    ========  ====================================================

    With ``to="right"`` the same holds with left and right, O and O' exchanged.

    Args:
        gamma, k_prime, k, mu, map, on_error, threads, progress, to: as in :func:`classify`; the operands may be the same.
        columns: which of the fields of :class:`LimitStates` to compute, in this order; all if not given.

    Returns:
        :class:`LimitStates` for four numbers, :class:`LimitStatesArrays` for arrays, a table of the same kind for columns and
        tables.

    Raises:
        StandfastError, TypeError, KeyError: as :func:`classify`.

    >>> states = limit_states(1, 0.4, 0.5, 0.6)
    >>> round(states.slide, 9), round(states.rock_O, 9), states.load_factor
    (0.1, 0.3, 1.2)
    >>> limit_states(1, 0.4, [0.5, 0.75], 0.6, columns=["rock_O"]).rock_O.round(9)
    array([ 0.3 , -0.05])
    """
    asked = chosen(columns, LimitStates._fields)
    operands = read("limit_states", _NAMES, (gamma, k_prime, k, mu), map, result="slide")
    with called(operands, threads, on_error, progress, to) as (how, form):
        arrays, missing, how = operands.native(how)
        values, missing = _standfast.limit_states(arrays, missing, asked, how)
    return form.table(dict(zip(asked, values)), missing, point=LimitStates, arrays=LimitStatesArrays)
