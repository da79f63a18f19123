"""The general contact problem: any planar wrench on any block, with added mass and two frictions."""

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
from ._mode_arrays import ModeArray
from ._modes import Mode, Modes
from ._rows import CONTACT_INPUTS, MOTION, Columns, Fault, Wrong, answer, numbers, point
from ._types import Array, Map, Number, OnError, PandasFrame, PandasSeries, PolarsFrame, PolarsSeries, Progress
from ._types import Arrow as ArrowLike
from ._types import PyarrowArray, PyarrowTable
from ._types import Work
from .answers import Relation

if TYPE_CHECKING:
    import pandas as pd  # type: ignore[import-untyped,unused-ignore]
    import polars as pl
    import pyarrow as pa  # type: ignore[import-untyped,unused-ignore]
    from typing_extensions import Unpack

#: The code of a row in which no mode is consistent.
_NO_MODE = 255

_KINDS: dict[str, type[np.generic]] = {"mode": np.uint8, "modes": np.uint16}


class Contact(Fields["Mode | Modes | float | None"]):
    """How a block begins to move under a wrench: :func:`contact`'s answer for plain numbers.

    Units are those of the operands: lengths in the length chosen, accelerations in g, angular ones in g over that length, forces
    in m g. Right and up are positive, and counter-clockwise. Where no mode is consistent, mode and motion are ``None``.

    Attributes:
        mode: the mode reported.
        modes: all modes that satisfy every law, the one reported among them.
        x_ddot: ẍ of the centre of mass, in g.
        y_ddot: ÿ of the centre of mass, in g.
        theta_ddot: θ̈, in g over the length; 0 where the body does not turn.
        f_x: horizontal reaction of the ground on the body, in m g.
        f_y: vertical reaction on the body, in m g.
        xi: ξ, how far right of the centre of mass f_y acts, in the length; 0 where there is no reaction.
        slip: ẍ of both corners, along the ground, in g; 0 where the base does not slip.
        lift_o: ÿ of the left corner O, in g; 0 while it stays on the ground.
        lift_o_prime: ÿ of the right corner O', in g; 0 while it stays on the ground.
    """

    mode: Mode | None
    modes: Modes
    x_ddot: float | None
    y_ddot: float | None
    theta_ddot: float | None
    f_x: float | None
    f_y: float | None
    xi: float | None
    slip: float | None
    lift_o: float | None
    lift_o_prime: float | None


class ContactArrays(Fields[NDArray[Any]], fields_of=Contact):
    """:func:`contact`'s answer for arrays: those of the fields that were asked for.

    ``mode`` has codes of :class:`Mode`, ``modes`` bits of :class:`Modes`. Where no mode is consistent, ``mode`` and motion are masked
    arrays, masked there. ``pandas.DataFrame(answer.to_dict())`` has the fields as columns.
    """

    mode: ModeArray
    modes: NDArray[np.uint16]
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
def contact(
    b1: Number, b2: Number, d: Number, rho2: Number, m_x: Number, m_y: Number, x: Number, p: Number, m: Number, mu_s: Number,
    mu_k: Number,
    *, columns: Sequence[str] | None = None, on_error: Literal["raise"] = "raise", **options: Unpack[Work],
) -> Contact: ...
@overload
def contact(
    b1: Number, b2: Number, d: Number, rho2: Number, m_x: Number, m_y: Number, x: Number, p: Number, m: Number, mu_s: Number,
    mu_k: Number,
    *, columns: Sequence[str] | None = None, on_error: Literal["null"], **options: Unpack[Work],
) -> Contact | None: ...
@overload
def contact(
    b1: Array, b2: Array, d: Array, rho2: Array, m_x: Array, m_y: Array, x: Array, p: Array, m: Array, mu_s: Array, mu_k:
    Array,
    *, columns: Sequence[str] | None = None, on_error: OnError = "raise", **options: Unpack[Work],
) -> ContactArrays: ...
@overload
def contact(
    b1: PandasFrame,
    *, columns: Sequence[str] | None = None, map: Map | None = None, on_error: OnError = "raise", **options: Unpack[Work],
) -> pd.DataFrame: ...
@overload
def contact(
    b1: PolarsFrame,
    *, columns: Sequence[str] | None = None, map: Map | None = None, on_error: OnError = "raise", **options: Unpack[Work],
) -> pl.DataFrame: ...
@overload
def contact(
    b1: PyarrowTable,
    *, columns: Sequence[str] | None = None, map: Map | None = None, on_error: OnError = "raise", **options: Unpack[Work],
) -> pa.Table: ...
@overload
def contact(
    b1: ArrowLike,
    *, columns: Sequence[str] | None = None, map: Map | None = None, on_error: OnError = "raise", **options: Unpack[Work],
) -> ArrowTable: ...
@overload
def contact(
    b1: PandasSeries | Array, b2: PandasSeries | Array, d: PandasSeries | Array, rho2: PandasSeries | Array, m_x: PandasSeries
    | Array, m_y: PandasSeries | Array, x: PandasSeries | Array, p: PandasSeries | Array, m: PandasSeries | Array, mu_s:
    PandasSeries | Array, mu_k: PandasSeries | Array,
    *, columns: Sequence[str] | None = None, on_error: OnError = "raise", **options: Unpack[Work],
) -> pd.DataFrame: ...
@overload
def contact(
    b1: PolarsSeries | Array, b2: PolarsSeries | Array, d: PolarsSeries | Array, rho2: PolarsSeries | Array, m_x: PolarsSeries
    | Array, m_y: PolarsSeries | Array, x: PolarsSeries | Array, p: PolarsSeries | Array, m: PolarsSeries | Array, mu_s:
    PolarsSeries | Array, mu_k: PolarsSeries | Array,
    *, columns: Sequence[str] | None = None, on_error: OnError = "raise", **options: Unpack[Work],
) -> pl.DataFrame: ...
@overload
def contact(
    b1: PyarrowArray | Array, b2: PyarrowArray | Array, d: PyarrowArray | Array, rho2: PyarrowArray | Array, m_x: PyarrowArray
    | Array, m_y: PyarrowArray | Array, x: PyarrowArray | Array, p: PyarrowArray | Array, m: PyarrowArray | Array, mu_s:
    PyarrowArray | Array, mu_k: PyarrowArray | Array,
    *, columns: Sequence[str] | None = None, on_error: OnError = "raise", **options: Unpack[Work],
) -> pa.Table: ...
@overload
def contact(
    b1: ArrowLike | Array, b2: ArrowLike | Array, d: ArrowLike | Array, rho2: ArrowLike | Array, m_x: ArrowLike | Array, m_y:
    ArrowLike | Array, x: ArrowLike | Array, p: ArrowLike | Array, m: ArrowLike | Array, mu_s: ArrowLike | Array, mu_k:
    ArrowLike | Array,
    *, columns: Sequence[str] | None = None, on_error: OnError = "raise", **options: Unpack[Work],
) -> ArrowTable: ...
def contact(
    b1: Any,
    b2: Any = None,
    d: Any = None,
    rho2: Any = None,
    m_x: Any = None,
    m_y: Any = None,
    x: Any = None,
    p: Any = None,
    m: Any = None,
    mu_s: Any = None,
    mu_k: Any = None,
    *,
    columns: Sequence[str] | None = None,
    map: Map | None = None,
    on_error: OnError = "raise",
    threads: int | None = 1,
    progress: Progress = None,
) -> Any:
    """Every mode that a block at rest can begin with under any planar wrench.

    ::

                 ▲ y
                 │     M ⟲
           ┌─────┼────┐
        d  │     C────┼──► x      X to the right
           │     │    │           P downwards, weight included
           O─────▼────O'
            b₁     b₂

    A mode is consistent if its motion satisfies the equations of motion, Coulomb's law and non-penetration at both corners;
    the decision is exact for the float64 numbers given. Numbers are non-dimensional by the mass, g and one length of your choice.

    Args:
        b1, b2: distances of O to the left and of O' to the right of the centre of mass C, above zero.
        d: depth of the base below C, above zero.
        rho2: square of the radius of gyration about C, above zero.
        m_x, m_y: inertia against ẍ and ÿ in units of the mass: 1 in air, more with added mass.
        x, p, m: the wrench at C: force to the right, force downwards with the weight, moment counter-clockwise.
        mu_s, mu_k: friction to stick and to slip, μ_s ≥ μ_k ≥ 0.
        map, threads, on_error, progress: as in :func:`classify`; the operands may be numbers, arrays, columns, or one table
            with columns of these names.
        columns: which of the fields of :class:`Contact` to compute, in this order; all if not given.

    Returns:
        :class:`Contact` for numbers, :class:`ContactArrays` for arrays, a table of the same kind for columns and tables: what
        ``standfast batch --problem wrench`` answers, and the motion of the corners. Where several modes are consistent,
        ``mode`` is the first of rest, slide, slide-rock below Painlevé's bound, rock, slide-rock beyond it, flight. For
        μ_s = μ_k some mode is always consistent; for μ_s > μ_k that is not proven, and ``mode`` and the motion would be missing.

    Raises:
        StandfastError, TypeError, KeyError: as :func:`classify`.

    The report's block with γ = 1, k' = -1/2, k = 4, μ = 3 has X = -k and M = k k' γ; the answer is not unique:

    >>> found = contact(1, 1, 1, 2 / 3, 1, 1, -4, 1, -2, 3, 3)
    >>> found.mode, found.modes
    (<Mode.SLIDE_LEFT: 1>, <Modes.SLIDE_LEFT|ROCK_O: 6>)
    >>> contact(1, 1, 1, 2 / 3, 1, 1, [-0.2, -2], 1, 0, 0.5, 0.4, columns=["mode", "x_ddot"])
    ContactArrays(mode=ModeArray([0, 1], dtype=uint8), x_ddot=array([ 0. , -1.6]))
    """
    asked = chosen(columns, Contact._fields)
    operands = read("contact", CONTACT_INPUTS, (b1, b2, d, rho2, m_x, m_y, x, p, m, mu_s, mu_k), map, result="mode")
    with called(operands, threads, on_error, progress, unit="problems") as (how, form):

        def solve(block: list[NDArray[np.float64]], out: Columns, wrong: Wrong) -> Fault:
            return _standfast.contact_rows(block, (out.get("mode"), out.get("modes")), numbers(out, MOTION), wrong, how)

        kinds = {name: _KINDS.get(name, np.float64) for name in asked}
        found, missing = answer(operands, kinds, solve, how, together=True)
    return form.table(_without_mode(found), missing, point=Contact, arrays=ContactArrays)


def _without_mode(found: Columns) -> Columns:
    """Mode and motion masked where no mode is consistent."""
    masked = dict(found)
    for name, column in found.items():
        if name != "modes":
            none = column == _NO_MODE if name == "mode" else np.isnan(column)
            if none.any():
                masked[name] = np.ma.MaskedArray(column, none)
    return masked


def contact_conditions(
    b1: Number,
    b2: Number,
    d: Number,
    rho2: Number,
    m_x: Number,
    m_y: Number,
    x: Number,
    p: Number,
    m: Number,
    mu_s: Number,
    mu_k: Number,
    *,
    mode: Mode | str | None = None,
) -> list[Relation]:
    """Why is a mode of the contact problem consistent: its conditions with the numbers of its motion.

    Args:
        b1, b2, d, rho2, m_x, m_y, x, p, m, mu_s, mu_k: as in :func:`contact`, numbers.
        mode: the mode; the one that :func:`contact` reports if not given.

    Raises:
        StandfastError: for values that no block or wrench has, and for a mode that is not consistent.

    >>> for condition in contact_conditions(1, 1, 1, 2 / 3, 1, 1, -0.5, 1, 0.2, 0.6, 0.6)[:2]:
    ...     print(condition.statement, round(condition.margin, 9))
    |f_x| ≤ μ_s f_y 0.1
    f_y ≥ 0 1.0
    """
    row = point("contact_conditions", CONTACT_INPUTS, (b1, b2, d, rho2, m_x, m_y, x, p, m, mu_s, mu_k))
    code = None if mode is None else int(Mode(mode))
    keys = ("equation", "statement", "left", "sign", "right", "holds", "margin")
    return [Relation(dict(zip(keys, condition))) for condition in _standfast.contact_conditions(row, code)]
