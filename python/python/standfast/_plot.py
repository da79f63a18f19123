"""Draws a diagram with matplotlib.

What is drawn is decided by the library; here only labels find their places: tried near what they name, one after
another, until one lies clear of lines and of other labels.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.path import Path
from matplotlib.text import Text
from matplotlib.transforms import Bbox
from numpy.typing import NDArray

from ._diagram import _FAINT, _INK, _MARK, _mathtext

if TYPE_CHECKING:
    from ._diagram import Diagram

_Place = tuple[float, float]


def plot(diagram: Diagram, ax: Axes | None, points: Mapping[str, tuple[float, float]], formulas: bool) -> Axes:
    """Draws a diagram; see :meth:`Diagram.plot`."""
    with plt.rc_context({"mathtext.fontset": "stix", "font.family": "STIXGeneral"}):
        if ax is None:
            # The size of the report's figures.
            _, ax = plt.subplots(figsize=(6.4, 4.8), layout="constrained")
        _Drawing(diagram, ax).draw(points, formulas)
    return ax


class _Drawing:
    """A drawing under way: what is on the axes, in pixels, for labels to keep clear of."""

    def __init__(self, diagram: Diagram, ax: Axes) -> None:
        self.diagram = diagram
        self.ax = ax
        self.shown: dict[str, Any] = diagram._shown
        self.curves = diagram.curves
        self.lines: list[NDArray[np.float64]] = []
        self.boxes: list[Bbox] = []

    def draw(self, points: Mapping[str, tuple[float, float]], formulas: bool) -> None:
        self._fills()
        self._axes()
        self._lines()
        # Labels are placed in pixels, which the layout of the figure decides on.
        figure = self.ax.get_figure(root=True)
        assert figure is not None
        figure.draw_without_rendering()
        self._ticks_apart()
        figure.draw_without_rendering()
        self.paths = [Path(self.ax.transData.transform(part)) for part in self.lines if len(part) > 1]
        self._letters()
        self._design_points(points)
        self._symbols()
        if formulas:
            self._formulas()

    def _fills(self) -> None:
        for region in self.diagram.regions:
            for polygon in region.polygons:
                # A rim of its own colour closes the hairline between neighbours.
                self.ax.fill(*polygon.T, facecolor=region.color, edgecolor=region.color, linewidth=0.3, zorder=1)

    def _axes(self) -> None:
        ax = self.ax
        k, mu = self.diagram.window
        ax.set(xlim=(0, k), ylim=(0, mu))
        ax.spines[["top", "right"]].set_visible(False)
        for side in ("left", "bottom"):
            ax.spines[side].set_color(_INK)
        ax.plot(1, 0, ">", color=_INK, ms=5, transform=ax.transAxes, clip_on=False, zorder=5)
        ax.plot(0, 1, "^", color=_INK, ms=5, transform=ax.transAxes, clip_on=False, zorder=5)
        beyond: dict[str, Any] = {"xycoords": "axes fraction", "textcoords": "offset points", "color": _INK, "fontsize": 14}
        ax.annotate("$k$", (1, 0), (8, 0), ha="left", va="center", **beyond)
        ax.annotate("$μ$", (0, 1), (-8, 4), ha="right", va="center", **beyond)
        ax.annotate("$O$", (0, 0), (-5, -5), ha="right", va="top", **beyond)
        for axis, marks in ((ax.xaxis, self.shown["k_marks"]), (ax.yaxis, self.shown["mu_marks"])):
            axis.set_ticks([at for at, _, _ in marks], [_mathtext(markup) for _, markup, _ in marks])
            axis.set_tick_params(colors=_INK, labelsize=11)
        drop: dict[str, Any] = {"color": _FAINT, "lw": 0.7, "dashes": (4, 2.6), "zorder": 2}
        for _, _, of in self.shown["k_marks"]:
            ax.plot([of[0], of[0]], [0, of[1]], **drop)
            self.lines.append(np.array([[of[0], 0], of]))
        for _, _, of in self.shown["mu_marks"]:
            if of is not None:
                ax.plot([0, of[0]], [of[1], of[1]], **drop)
                self.lines.append(np.array([[0, of[1]], of]))

    def _lines(self) -> None:
        for curve in self.curves:
            style: dict[str, Any] = {"lw": 0.9, "dashes": (5, 3.4)} if curve.dashed else {"lw": 1.5}
            for part in curve.parts:
                self.ax.plot(*part.T, color=_INK, zorder=3, solid_capstyle="round", **style)
                self.lines.append(part)

    def _ticks_apart(self) -> None:
        """Shortens the labels of ticks to the name where they run into each other, and drops one of two that still do."""
        for axis, across in ((self.ax.xaxis, 0), (self.ax.yaxis, 1)):
            labels = [tick.label1 for tick in axis.get_major_ticks()]

            def touching(labels: list[Text] = labels, across: int = across) -> Iterator[tuple[Text, Text]]:
                seen = sorted(labels, key=lambda label: label.get_window_extent().p0[across])
                for one, other in zip(seen, seen[1:]):
                    if one.get_window_extent().overlaps(other.get_window_extent().padded(2)):
                        yield one, other

            if any(touching()):
                axis.set_ticklabels([_short(label.get_text()) for label in labels])
            for one, other in list(touching()):
                # The marks stand in the order of their weight.
                max(one, other, key=labels.index).set_text("")
            axis.set_ticklabels([label.get_text() for label in labels])

    def _letters(self) -> None:
        named = [(letter, markup, k, mu) for letter, markup, k, mu in self.shown["points"] if letter in self._drawn()]
        for _, _, k, mu in named:
            self.ax.plot(k, mu, "o", color=_INK, ms=4, zorder=4, clip_on=False)
            self._reserve(k, mu, 4)
        for _, markup, k, mu in named:
            self._place(_mathtext(markup), self._around(k, mu, 11), size=12.5, insist=True)

    def _drawn(self) -> set[str]:
        """Letters of points that lie on a drawn line or at its end."""
        ends = np.concatenate([part[[0, -1]] for part in self.lines])
        k, mu = self.diagram.window
        near = {}
        for letter, _, *at in self.shown["points"]:
            near[letter] = np.abs((ends - at) / (k, mu)).max(axis=1).min()
        return {letter for letter, distance in near.items() if distance < 1e-6}

    def _design_points(self, points: Mapping[str, tuple[float, float]]) -> None:
        for k, mu in points.values():
            self.ax.plot(k, mu, "D", color=_MARK, mec="white", ms=7, zorder=6)
            self._reserve(k, mu, 8)
        for name, (k, mu) in points.items():
            self._place(name.replace("$", r"\$"), self._around(k, mu, 14), size=11, color=_MARK, insist=True)

    def _symbols(self) -> None:
        for region in self.diagram.regions:
            if not region.polygons:
                continue
            polygon = max(region.polygons, key=_area)
            for size in (14.0, 11.0):
                if self._place(region.symbol, self._inside(polygon), size=size, within=polygon):
                    break
            else:
                self._beside_thin(region.symbol, polygon)

    def _beside_thin(self, symbol: str, polygon: NDArray[np.float64]) -> None:
        """Names a region too thin for its symbol, with a line to it."""
        middle = polygon.mean(axis=0)
        inside = min(self._inside(polygon), key=lambda at: float(np.hypot(*(np.array(at) - middle))), default=None)
        if inside is None:
            return
        to = self.ax.transData.transform(inside)
        places = (self._data(to + 26 * reach * _turn(turn)) for reach in (1, 1.6, 2.4) for turn in (-1, 1, -3, 3, -2, 2))
        label = self._place(symbol, places, size=11)
        if label is not None:
            start = label.get_position()
            self.ax.annotate(
                "", inside, start, zorder=4, arrowprops={"arrowstyle": "-", "color": _FAINT, "lw": 0.7, "shrinkA": 9, "shrinkB": 0}
            )

    def _formulas(self) -> None:
        for curve in self.curves:
            if curve.formula and not curve.dashed and curve.parts:
                part = max(curve.parts, key=lambda part: float(np.ptp(part[:, 0])))
                self._place(curve.formula, self._along(part), size=11, beside=part)

    # Places, in data coordinates.

    def _around(self, k: float, mu: float, distance: float) -> Iterator[_Place]:
        at = self.ax.transData.transform((k, mu))
        for reach in (1.0, 1.3, 1.8):
            for turn in (1, 3, -1, -3, 2, 0, 4, -2):
                yield self._data(at + reach * distance * self._scale() * _turn(turn))

    def _inside(self, polygon: NDArray[np.float64]) -> list[_Place]:
        """Places inside a polygon, from its middle outwards."""
        low, high = polygon.min(axis=0), polygon.max(axis=0)
        steps = (np.arange(24) + 0.5) / 24
        grid = np.stack(np.meshgrid(*(low + steps[:, None] * (high - low)).T), axis=-1).reshape(-1, 2)
        grid = grid[Path(polygon).contains_points(grid)]
        if len(grid):
            grid = grid[np.argsort((((grid - grid.mean(axis=0)) / (high - low)) ** 2).sum(axis=1))]
        return [(float(k), float(mu)) for k, mu in grid]

    def _along(self, part: NDArray[np.float64]) -> Iterator[_Place]:
        """Places on both sides of a line."""
        pixels = self.ax.transData.transform(part)
        length = np.concatenate([[0], np.cumsum(np.hypot(*np.diff(pixels, axis=0).T))])
        for distance in (16, 22, 30, 40):
            for share in (0.5, 0.6, 0.4, 0.7, 0.3, 0.8, 0.2):
                at = np.array([np.interp(share * length[-1], length, pixels[:, axis]) for axis in (0, 1)])
                for side in (1, -1):
                    for lean in (0.0, 0.9, -0.9):
                        yield self._data(at + self._scale() * distance * np.array([lean * 3, side]))

    def _nearest(self, box: Bbox) -> NDArray[np.float64]:
        """The line nearest to the middle of a box."""
        middle = np.array([(box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2])

        def distance(line: NDArray[np.float64]) -> float:
            start = self.ax.transData.transform(line)
            start, along = start[:-1], np.diff(start, axis=0)
            share = ((middle - start) * along).sum(axis=1) / np.maximum((along**2).sum(axis=1), 1e-9)
            foot = start + np.clip(share, 0, 1)[:, None] * along
            return float(np.hypot(*(middle - foot).T).min())

        return min((line for line in self.lines if len(line) > 1), key=distance)

    def _scale(self) -> float:
        """Pixels a point, of those at 72 dots an inch."""
        figure = self.ax.get_figure(root=True)
        assert figure is not None
        return figure.dpi / 72

    def _data(self, pixel: NDArray[np.float64]) -> _Place:
        k, mu = self.ax.transData.inverted().transform(pixel)
        return float(k), float(mu)

    def _reserve(self, k: float, mu: float, size: float) -> None:
        at = self.ax.transData.transform((k, mu))
        half = size * self._scale() / 2
        self.boxes.append(Bbox([at - half, at + half]))

    def _place(
        self,
        text: str,
        places: Iterable[_Place],
        *,
        size: float,
        color: str = _INK,
        within: NDArray[np.float64] | None = None,
        beside: NDArray[np.float64] | None = None,
        insist: bool = False,
    ) -> Text | None:
        """Puts a label at the first place that is clear, inside a polygon or nearest to a line if asked; if there is
        none, at the first one off other labels if it insists."""
        label = self.ax.text(0, 0, text, ha="center", va="center", size=size, color=color, zorder=5)
        area = self.ax.get_window_extent()
        room = None if within is None else Path(self.ax.transData.transform(within))
        fallback = None
        for place in places:
            label.set_position(place)
            box = label.get_window_extent().padded(1.5 * self._scale())
            if not (area.x0 < box.x0 and box.x1 < area.x1 and area.y0 < box.y0 and box.y1 < area.y1):
                continue
            if room is not None and not room.contains_points(box.corners()).all():
                continue
            if any(box.overlaps(other) for other in self.boxes):
                continue
            if any(path.intersects_bbox(box, filled=False) for path in self.paths):
                fallback = fallback or place
                continue
            if beside is not None and self._nearest(box) is not beside:
                continue
            self.boxes.append(box)
            return label
        if insist and fallback is not None:
            label.set_position(fallback)
            self.boxes.append(label.get_window_extent())
            return label
        label.remove()
        return None


def _short(label: str) -> str:
    """``$k_A$`` of ``$k_A = ...$``."""
    return label.split(" = ")[0] + "$" if " = " in label else label


def _turn(eighths: int) -> NDArray[np.float64]:
    """A step of length 1 towards so many eighths of a turn."""
    return np.array([np.cos(eighths * np.pi / 4), np.sin(eighths * np.pi / 4)])


def _area(polygon: NDArray[np.float64]) -> float:
    k, mu = polygon.T
    return float(abs(np.dot(k, np.roll(mu, -1)) - np.dot(mu, np.roll(k, -1))) / 2)
