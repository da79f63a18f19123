"""The k-μ diagram of a body as arrays, as SVG, and drawn by matplotlib."""

# A number is also what can be read as an array; the first overload that fits is meant.
# mypy: disable-error-code="overload-overlap"

from __future__ import annotations

import copy
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, NamedTuple, overload

import numpy as np
from numpy.typing import NDArray

from . import _standfast
from ._advice import shown
from ._arrays import classify
from ._arrow import ArrowArray
from ._inputs import read
from ._mode_arrays import ModeArray
from ._modes import Mode, Modes
from ._points import Marks, Points, marks
from ._rows import point
from ._standfast import StandfastError
from ._types import Array, Number, PandasSeries, PolarsSeries, PyarrowArray
from ._types import Arrow as ArrowLike

if TYPE_CHECKING:
    import pandas as pd  # type: ignore[import-untyped,unused-ignore]
    import polars as pl
    import pyarrow as pa  # type: ignore[import-untyped,unused-ignore]
    from matplotlib.axes import Axes

    from ._standfast import _Base, _Outlines, _Polyline

Polyline = NDArray[np.float64]

_INK = "#16202b"
_FAINT = "#5d6873"
_BEHIND = "#7d8791"
_MARK = "#a3123f"


class Region(NamedTuple):
    """The part of the plane where a mode begins."""

    #: The mode.
    mode: Mode
    #: Its outlines in the window, each an array of shape (n, 2) of (k, μ), not closed.
    polygons: list[Polyline]
    #: The report's symbol in mathtext.
    symbol: str
    #: The colour of the mode in every figure.
    color: str


class Indeterminate(NamedTuple):
    """A part of the plane where several modes satisfy every law, and the report's section IV.7 picks one."""

    #: The report's name for it.
    name: str
    #: The mode that the report picks, which is that of the :class:`Region` it lies in.
    resolved_as: Mode
    #: All modes consistent inside.
    modes: Modes
    #: Its outlines, as in :class:`Region`.
    polygons: list[Polyline]


class Curve(NamedTuple):
    """A line of the diagram."""

    #: ``OA``, ``CD``, ``AB``, ``DC``, ``mu*``, ``mu**``, ``vertical at A`` or ``asymptote``.
    name: str
    #: Its equation in mathtext; empty for the vertical.
    formula: str
    #: Whether it bounds no region.
    dashed: bool
    #: Its parts in the window, each an array of shape (n, 2) of (k, μ).
    parts: list[Polyline]
    #: A shorter name in mathtext, for where the equation does not fit; may be empty.
    short: str = ""


class NamedPoint(NamedTuple):
    """A point of the diagram that has a letter in the report."""

    #: The letter, e.g. ``B'``.
    name: str
    k: float
    mu: float


def _mathtext(markup: str) -> str:
    """The figures' markup as matplotlib's mathtext."""
    # The bar of matplotlib's fonts ends on the base line and reads as an l; that of "divides" (U+2223) goes below it.
    markup = markup.replace(r"\up{", r"\mathrm{").replace(r"\frac", r"\dfrac").replace("|", "∣")
    return markup.replace("μ**", "μ^{**}").replace("μ*", "μ^{*}").replace("−", "-").replace("_-", "_{-}").replace("_+", "_{+}")


def _polylines(parts: Iterable[_Polyline]) -> list[Polyline]:
    return [np.array(part, dtype=np.float64) for part in parts]


def _window(window: Any) -> tuple[float, float]:
    expected = "expected the largest k and the largest μ to show, as (2, 1)"
    if isinstance(window, (str, bytes, Mapping)) or not isinstance(window, Iterable) or len(pair := list(window)) != 2:
        raise TypeError(f"window is {shown(window)}; {expected}")
    k, mu = point("Diagram", ("the largest k of window", "the largest μ of window"), pair)
    if not (0 < k <= 1e50 and 0 < mu <= 1e50):
        raise StandfastError(f"window is {(k, mu)}; {expected}, above zero and 1e50 at most")
    return k, mu


class Diagram:
    """Which mode begins where in the plane of force k and friction μ, for one body and one elevation of the force.

    Args:
        gamma: slenderness H/B, above zero.
        k_prime: height of the force above the centre of mass in H.
        omega: share ω = V/(2B q_u) of a base that crushes, below 1; the map of a rigid base is drawn behind, dotted.
        law: the plane of ground that fails, by ``"ec7"``, ``"hansen"`` or ``"envelope"``, in place of ``omega``; it needs ``share``.
        share: share u = V/V₀ that the weight takes of what the ground bears centric and upright.
        window: largest k and μ to show, by :meth:`plot`, :meth:`svg` and the notebook alike; if it is not given, those that
            show the named points and all points to be marked.

    Raises:
        StandfastError: for a slenderness or elevation that no body or force has, or a window that is empty.

    In a notebook it shows itself as the report's figure.

    >>> diagram = Diagram(3, 0.8)
    >>> [region.mode.symbol for region in diagram.regions]
    ['RE', 'SL', 'RO', 'SRO-', 'SRO+']
    >>> diagram.mode_at(3, 0.1)
    <Mode.SLIDE_ROCK_O_RIGHT: 4>
    >>> round(diagram.points["E"].k, 4)
    1.0465
    >>> Diagram(0.8, 0.9167, omega=0.08).mode_at(0.61, 0.6)
    <Mode.ROCK_O: 2>
    >>> [region.mode.symbol for region in Diagram(0.8, 0.9167, law="ec7", share=0.3).regions]
    ['RE', 'SL', 'BF']
    """

    def __init__(
        self,
        gamma: Number,
        k_prime: Number,
        *,
        omega: Number | None = None,
        law: str | None = None,
        share: Number | None = None,
        window: tuple[Number, Number] | None = None,
    ) -> None:
        self._gamma, self._k_prime = point("Diagram", ("gamma", "k_prime"), (gamma, k_prime))
        if (law is None) != (share is None):
            raise TypeError("law and share say together what the ground is; expected both, or neither")
        if law is not None and omega is not None:
            raise TypeError("omega is of a base that crushes, law of ground that fails; expected one of them")
        if law is not None and not isinstance(law, str):
            raise TypeError(f"law is {shown(law)}; expected a text")
        self._base: _Base = {
            "omega": None if omega is None else point("Diagram", ("omega",), (omega,))[0],
            "law": law,
            "share": 0.0 if share is None else point("Diagram", ("share",), (share,))[0],
        }
        self._asked = None if window is None else _window(window)
        self._shown = self._outlines(marks(None))

    def _outlines(self, marked: Marks) -> _Outlines:
        return _standfast.diagram_outlines(self._gamma, self._k_prime, self._base, self._asked, *marked)

    def _holding(self, marked: Marks) -> Diagram:
        """The same in a window that holds points, unless one was asked for."""
        wide = copy.copy(self)
        wide._shown = self._outlines(marked)
        return wide

    def _given(self) -> tuple[object, ...]:
        return self._gamma, self._k_prime, *self._base.values(), self.window

    def __eq__(self, other: object) -> bool:
        """Whether it is of the same body, force and base, in the same window."""
        return self._given() == other._given() if isinstance(other, Diagram) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._given())

    @property
    def gamma(self) -> float:
        """Slenderness H/B."""
        return self._gamma

    @property
    def k_prime(self) -> float:
        """Height of the force above the centre of mass in H."""
        return self._k_prime

    @property
    def omega(self) -> float:
        """Share of a base that crushes; 0 on a rigid base."""
        return self._base["omega"] or 0.0

    @property
    def window(self) -> tuple[float, float]:
        """Largest k and μ shown."""
        k, mu = self._shown["window"]
        return k, mu

    @property
    def regions(self) -> list[Region]:
        """The regions of the modes; together they fill the window."""
        return [
            Region(Mode(code), _polylines(polygons), _mathtext(symbol), tint)
            for code, symbol, tint, polygons in self._shown["areas"]
        ]

    @property
    def indeterminate(self) -> list[Indeterminate]:
        """Where the answer is not unique; empty unless -1 < k' < 0."""
        return [
            Indeterminate(name, Mode(resolved), Modes(bits), _polylines(polygons))
            for name, resolved, bits, polygons in self._shown["unresolved"]
        ]

    @property
    def curves(self) -> list[Curve]:
        """The lines between the regions, and the dashed ones."""
        return [
            Curve(name, _mathtext(formula), dashed, _polylines(parts), _mathtext(short))
            for name, formula, short, dashed, parts in self._shown["lines"]
        ]

    @property
    def points(self) -> Mapping[str, NamedPoint]:
        """The named points in the window, by letter."""
        return {letter: NamedPoint(letter, k, mu) for letter, _, k, mu in self._shown["points"]}

    @overload
    def mode_at(self, k: Number, mu: Number) -> Mode: ...
    @overload
    def mode_at(self, k: Array, mu: Array) -> ModeArray: ...
    @overload
    def mode_at(self, k: PandasSeries | Array, mu: PandasSeries | Array) -> pd.Series[Any]: ...
    @overload
    def mode_at(self, k: PolarsSeries | Array, mu: PolarsSeries | Array) -> pl.Series: ...
    @overload
    def mode_at(self, k: PyarrowArray | Array, mu: PyarrowArray | Array) -> pa.Array: ...
    @overload
    def mode_at(self, k: ArrowLike | Array, mu: ArrowLike | Array) -> ArrowArray: ...
    def mode_at(self, k: Any, mu: Any) -> Any:
        """The mode at (k, μ), exactly, boundaries included; arrays give arrays, as in :func:`classify`."""
        law = self._base["law"]
        if law is None:
            return classify(self._gamma, self._k_prime, k, mu, omega=self._base["omega"])
        operands = read("classify", ("k", "mu"), (k, mu))
        arrays, missing = operands.arrays()
        places = np.stack([np.ravel(array) for array in np.broadcast_arrays(*arrays)], axis=1).astype(np.float64)
        codes = _standfast.failing_modes(self._gamma, self._k_prime, law, self._base["share"], places)
        return operands.form.column("mode", np.frombuffer(codes, dtype=np.uint8).copy().reshape(operands.shape), missing, symbols=False)

    def svg(self, points: Points | None = None) -> str:
        """The diagram as an SVG document, with points marked as in :meth:`plot`.

        >>> Diagram(1, 0.4).svg({"storm": (0.5, 0.6)})[:4]
        '<svg'
        """
        return _standfast.diagram_svg(self._gamma, self._k_prime, self._base, self._asked, *marks(points))

    def _repr_svg_(self) -> str:
        return self.svg()

    def __repr__(self) -> str:
        of = "".join(f", {name}={value!r}" for name, value in self._base.items() if value)
        return f"Diagram(gamma={self._gamma:g}, k_prime={self._k_prime:g}{of})"

    def plot(
        self,
        ax: Axes | None = None,
        *,
        points: Points | None = None,
        formulas: bool = True,
        by_mode: bool = False,
    ) -> Axes:
        """Draws the diagram with matplotlib, in the look of the report's figures.

        Args:
            ax: axes to draw in; new ones if not given.
            points: load cases to mark, ``{name: (k, μ)}``; or a cloud of points without names: an array with rows of (k, μ),
                or a table with the columns ``k`` and ``mu`` (and ``name``, if they have names). Every point with a name is
                named: beside its marker, or farther away with a line to it, or by a number that a list right of the axes
                explains. Without a ``window`` of its own the diagram is laid around all points and the corner where regions meet;
                with one, an arrow at its edge points at a named point outside.
            formulas: whether the lines carry their equations.
            by_mode: whether points have a marker for each mode, with a legend that counts them.

        Returns:
            The axes. The axes' limits are the window; everything drawn can be changed with matplotlib. Type and lines follow
            matplotlib's settings ``font.size`` and ``lines.linewidth``, and are smaller in small axes.

        Raises:
            ImportError: without matplotlib (``pip install "standfast[plot]"``).
            StandfastError: for a point that there cannot be.

        Warns:
            UserWarning: if points of a cloud lie outside of the window that was asked for.
        """
        try:
            from ._plot import plot
        except ImportError as error:
            raise ImportError('plotting needs matplotlib: pip install "standfast[plot]"') from error
        marked = marks(points)
        return plot(self._holding(marked), ax, marked, formulas, by_mode)
