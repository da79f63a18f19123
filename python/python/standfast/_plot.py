"""Draws a diagram with matplotlib.

What is drawn, in which window and with which numbers is decided by the library; here it is given matplotlib's lines and type,
and labels find their places.
"""

from __future__ import annotations

import textwrap
import warnings
from collections.abc import Iterable
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from matplotlib import colors, patheffects
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.path import Path
from matplotlib.transforms import Bbox, IdentityTransform, TransformedBbox

from ._diagram import _BEHIND, _FAINT, _INK, _MARK, Curve, Diagram, _mathtext
from ._labels import Board, Place, Rows, area_of, grid_of, length_of, outwards, point_along, spread
from ._modes import Mode
from ._points import Marks
from ._ticks import number, root_of

# Of modes in the order of their codes.
_SHAPES = "os^v<D>PX*"
#: How wide a list of points may become.
_COLUMNS = 3


def plot(diagram: Diagram, ax: Axes | None, marked: Marks, formulas: bool, by_mode: bool) -> Axes:
    """Draws a diagram; see :meth:`Diagram.plot`."""
    style: Any = {"mathtext.fontset": "stix", "font.family": "STIXGeneral", "text.usetex": False}
    with plt.rc_context(style):
        if ax is None:
            # The size of the report's figures.
            _, ax = plt.subplots(figsize=(6.4, 4.8), layout="constrained")
        _Drawing(diagram, ax, marked, by_mode).draw(formulas)
    return ax


class _Drawing:
    """A drawing under way."""

    def __init__(self, diagram: Diagram, ax: Axes, marked: Marks, by_mode: bool) -> None:
        self.diagram = diagram
        self.ax = ax
        self.marked = marked
        self.by_mode = by_mode
        self.shown = diagram._shown
        self.curves = diagram.curves
        self.figure = root_of(ax)
        self.outside = _readable(self.figure)
        # In a column of a journal, type of its usual size would leave no room for what it names.
        area = ax.get_window_extent()
        shrink = float(np.clip(min(area.width / 290, area.height / 210) / self._unit(), 0.72, 1))
        self.size = plt.rcParams["font.size"] * shrink
        self.line = plt.rcParams["lines.linewidth"] / 1.5 * shrink
        self.dot = self.size / 10
        #: Lines that labels keep clear of, and the labels set so far.
        self.lines: list[Rows] = []
        self.labels: list[Artist] = []
        self.values: list[Artist] = []
        self.pads = (ax.yaxis.labelpad, ax.xaxis.labelpad)
        #: What the axes show, and a strip left of and below it.
        self.beside_axes = TransformedBbox(Bbox.from_extents(-0.05, -0.05, 1, 1), ax.transAxes)
        self.roomy = False

    def draw(self, formulas: bool) -> None:
        self._fills()
        self._axes()
        self._lines()
        self._cloud()
        self._markers()
        # Labels are placed in pixels, which the layout of the figure decides on.
        self.figure.draw_without_rendering()
        self._named_values()
        numbered: set[int] = set()
        while True:
            board = self._board()
            self._letters(board)
            crowded = self._names(board, numbered)
            if not crowded:
                break
            # A list takes room from the axes; what then finds none any more joins it, the third time all the others.
            numbered = numbered | crowded if not numbered else set(range(len(self.marked.names)))
            self._clear()
            self._list(sorted(numbered))
        self._symbols(board)
        if formulas:
            self._formulas(board)

    # What lies where it lies.

    def _fills(self) -> None:
        for region in self.diagram.regions:
            for polygon in region.polygons:
                # A rim of its own colour closes the hairline between neighbours.
                self.ax.fill(*polygon.T, facecolor=region.color, edgecolor=region.color, linewidth=0.3, zorder=1)

    def _axes(self) -> None:
        ax, size = self.ax, self.size
        k, mu = self.diagram.window
        ax.set(xlim=(0, k), ylim=(0, mu), facecolor="white")
        # A style may have a grid, and neither spines nor ticks.
        ax.grid(False, which="both")
        ax.spines[["top", "right"]].set_visible(False)
        ax.spines[["left", "bottom"]].set(visible=True, color=self.outside, linewidth=0.8 * self.line)
        heads: dict[str, Any] = {"color": self.outside, "ms": 0.5 * size, "transform": ax.transAxes, "clip_on": False, "zorder": 5}
        ax.plot(1, 0, ">", mew=0, **heads)
        ax.plot(0, 1, "^", mew=0, **heads)
        beyond: dict[str, Any] = {"xycoords": "axes fraction", "textcoords": "offset points", "color": self.outside}
        ax.annotate("$k$", (1, 0), (0.8 * size, 0), ha="left", va="center", fontsize=1.4 * size, **beyond)
        ax.annotate("$μ$", (0, 1), (-0.8 * size, 0.4 * size), ha="right", va="center", fontsize=1.4 * size, **beyond)
        ax.annotate("$0$", (0, 0), (-0.45 * size, -0.35 * size), ha="right", va="top", fontsize=size, **beyond)
        sides: tuple[tuple[Axis, dict[str, Any], bool], ...] = (
            (ax.xaxis, {"bottom": True, "labelbottom": True, "top": False, "labeltop": False}, False),
            (ax.yaxis, {"left": True, "labelleft": True, "right": False, "labelright": False}, True),
        )
        for axis, shown, upright in sides:
            number(axis, size, upright)
            look: dict[str, Any] = {"direction": "out", "color": self.outside, "width": 0.8 * self.line, **shown}
            axis.set_tick_params(which="major", length=0.35 * size, pad=0.3 * size, labelsize=size, labelcolor=self.outside, **look)
            axis.set_tick_params(which="minor", length=0.2 * size, **{**look, "width": 0.6 * self.line})
            # Ticks of axes that were made before have the type of their style, and later ones are copies of these.
            for tick in axis.get_major_ticks():
                tick.label1.set_fontfamily("STIXGeneral")
                tick.label1.set_math_fontfamily("stix")
        drop: dict[str, Any] = {"color": _FAINT, "lw": 0.7 * self.line, "dashes": (4, 2.6), "zorder": 2}
        for _, _, (k, mu) in self.shown["k_marks"]:
            self._line(np.array([[k, 0], [k, mu]]), **drop)
        for at, _, of in self.shown["mu_marks"]:
            if of is not None:
                self._line(np.array([[0, at], [of[0], at]]), **drop)

    def _lines(self) -> None:
        for outline in self.shown["rigid"]:
            self._line(np.array(outline), color=_BEHIND, zorder=2, lw=1.1 * self.line, ls="-")
        for curve in self.curves:
            style: dict[str, Any] = {"lw": 0.9, "dashes": (5, 3.4)} if curve.dashed else {"lw": 1.5, "ls": "-"}
            style["lw"] *= self.line
            for part in curve.parts:
                self._line(part, color=_INK, zorder=3, solid_capstyle="round", **style)

    def _line(self, line: Rows, **style: Any) -> None:
        self.ax.plot(*line.T, marker="", **style)
        if len(line) > 1 and np.ptp(line, axis=0).any():
            self.lines.append(line)

    def _cloud(self) -> None:
        cloud = self.marked.cloud
        if not len(cloud):
            return
        window = self.diagram.window
        beyond = int((cloud > window).any(axis=1).sum())
        if beyond:
            k, mu = window
            words = f"{beyond} of {len(cloud)} points lie outside of the window, k up to {k:g} and μ up to {mu:g}"
            warnings.warn(words, UserWarning, stacklevel=5)
        # Many points on top of each other show by their density; as lines of a page they would be slow to look at.
        alpha = float(np.clip(150 / len(cloud), 0.15, 0.7))
        look: dict[str, Any] = {"ls": "", "color": _MARK, "mec": "none", "alpha": alpha, "zorder": 2.5, "clip_on": True}
        self._marked(cloud, "o", ms=2.6 * self.dot, rasterized=len(cloud) > 20_000, **look)

    def _markers(self) -> None:
        places = self.marked.places[: len(self.marked.names)]
        within = (places <= self.diagram.window).all(axis=1)
        size = (6 if self.by_mode else 6.5) * self.dot
        # All rims below all markers: of points that lie close none is hidden by the rim of another.
        for color, more, zorder in (("white", 2 * self.dot, 5.9), (_MARK, 0.0, 6.0)):
            look: dict[str, Any] = {"ls": "", "color": color, "mec": color, "mew": more, "zorder": zorder, "clip_on": False}
            self._marked(places[within], "D", ms=size, in_layout=False, **look)
            for k, mu in places[~within]:
                at, angle = self._edge(k, mu)
                self.ax.plot(*at, marker=(3, 0, angle - 90), ms=1.2 * size, **look)
        if self.by_mode and len(self.marked.places):
            self._legend()

    def _marked(self, places: Rows, shape: str, **look: Any) -> None:
        if not self.by_mode or not len(places):
            self.ax.plot(*places.T, marker=shape, **look)
            return
        codes = self.diagram.mode_at(*places.T)
        for code in np.unique(codes):
            self.ax.plot(*places[codes == code].T, marker=_SHAPES[code], **look)

    def _legend(self) -> None:
        codes, counts = np.unique(self.diagram.mode_at(*self.marked.places.T), return_counts=True)
        symbols = {region.mode: region.symbol for region in self.diagram.regions}
        handles = [
            Line2D([], [], ls="", marker=_SHAPES[code], color=_MARK, ms=6 * self.dot, mec=self.outside, mew=0.5, label=f"{symbols[Mode(code)]}  {count}")
            for code, count in zip(codes.tolist(), counts.tolist())
        ]
        legend = self.ax.legend(
            handles=handles, loc="upper left", bbox_to_anchor=(1.01, 1), borderaxespad=0, frameon=False, fontsize=1.1 * self.size,
            labelcolor=self.outside, handletextpad=0.2,
        )  # fmt: skip
        self.figure.draw_without_rendering()
        self._make_room(right=legend.get_window_extent().x1 - self.figure.bbox.x1 + 2)

    def _edge(self, k: float, mu: float) -> tuple[tuple[float, float], float]:
        """Where an arrow to a point outside stands, and its direction in degrees."""
        area, pixel = self.ax.get_window_extent(), self.ax.transData.transform((k, mu))
        inset = 0.6 * self.size * self._unit()
        at = np.clip(pixel, area.min + inset, area.max - inset)
        found = self.ax.transData.inverted().transform(at)
        return (float(found[0]), float(found[1])), float(np.degrees(np.arctan2(*(pixel - at)[::-1])))

    # What finds a place.

    def _named_values(self) -> None:
        """The report's values under the numbers of the k axis and left of those of the μ axis: with their formulas if these fit,
        else by name."""
        # They need room, which changes where they stand; the second time hardly.
        for _ in range(2):
            for value in self.values:
                value.remove()
            self.values.clear()
            self.ax.yaxis.labelpad, self.ax.xaxis.labelpad = self.pads
            self._set_named_values()
            if not self.roomy:
                self.roomy = True
                self._make_room(*((axis.labelpad - pad) * self._unit() for axis, pad in zip((self.ax.yaxis, self.ax.xaxis), self.pads)))
            self.figure.draw_without_rendering()

    def _set_named_values(self) -> None:
        ax, unit = self.ax, self._unit()
        below = ax.xaxis.get_tightbbox()
        left = ax.yaxis.get_tightbbox()
        area = ax.get_window_extent()
        room = 0.5 * self.size * unit
        bottom = (below.y0 if below else area.y0) - 0.25 * self.size * unit
        right = (left.x0 if left else area.x0) - 0.4 * self.size * unit
        for axis, marks in ((0, self.shown["k_marks"]), (1, self.shown["mu_marks"])):
            rows = sorted((float(ax.transData.transform((at, at))[axis]), _mathtext(markup), at) for at, markup, _ in marks)
            for shorten in (False, True):
                texts = [_short(text) if shorten else text for _, text, _ in rows]
                sizes = [self._extent(text, 1.1 * self.size) for text in texts]
                ends = (area.x0 - room, area.x1 + room) if axis == 0 else (area.y0 + room, area.y1 - room)
                middles = spread([at for at, _, _ in rows], [size[axis] for size in sizes], *ends, 2 * room if axis == 0 else room)
                deep = max((size[1 - axis] for size in sizes), default=0.0)
                moved = max((abs(m - at) for m, (at, _, _) in zip(middles or [], rows)), default=0.0)
                if middles is not None and moved < 3 * self.size * unit:
                    break
            if middles is None:
                continue
            for middle, text, size, (pixel, _, at) in zip(middles, texts, sizes, rows):
                if axis == 0:
                    step = ((middle - pixel) / unit, (bottom - area.y0) / unit)
                    where: dict[str, Any] = {"xy": (at, 0), "xytext": step, "ha": "center", "va": "top"}
                else:
                    step = ((right - area.x0) / unit, (middle - pixel) / unit)
                    where = {"xy": (0, at), "xytext": step, "ha": "right", "va": "center"}
                label = ax.annotate(text, textcoords="offset points", fontsize=1.1 * self.size, color=self.outside, **where)
                self.values.append(label)
            if rows:
                # The name that a user gives the axis stands beyond.
                (ax.yaxis if axis else ax.xaxis).labelpad += (deep + room) / unit

    def _board(self) -> Board:
        """An empty plot with its lines and markers."""
        area = self.ax.get_window_extent()
        board = Board(area.extents, self._unit())
        for line in self.lines:
            board.draw(self.ax.transData.transform(line))
        for _, _, k, mu in self.shown["points"]:
            board.mark(self._pixel(k, mu), 5 * self.dot)
        for k, mu in self.marked.places[: len(self.marked.names)]:
            board.mark(self._pixel(k, mu), 9 * self.dot)
        return board

    def _letters(self, board: Board) -> None:
        ends = np.concatenate([line[[0, -1]] for line in self.lines])
        for _, markup, k, mu in self.shown["points"]:
            # Of points that lie at the end of a drawn line.
            if np.abs((ends - (k, mu)) / self.diagram.window).max(axis=1).min() > 1e-6:
                continue
            self.labels += self.ax.plot(k, mu, "o", color=_INK, ms=4 * self.dot, mew=0, zorder=4)
            # A point on an axis is whole, unless the limits leave it out.
            self.labels[-1].set_clip_box(self.beside_axes)
            text, size, at = _mathtext(markup), 1.25 * self.size, self._pixel(k, mu)
            extent = self._extent(text, size)
            place = board.beside(at, extent, 4 * self.dot) or board.near(at, extent, 3 * self.dot)
            if place:
                self._set(board, place, text, size)

    def _names(self, board: Board, numbered: set[int]) -> set[int]:
        """Names the points; gives back those for whose name there is no room."""
        places = np.array([self._pixel(k, mu) for k, mu in self.marked.places[: len(self.marked.names)]]).reshape(-1, 2)
        crowded, size = set(), 1.1 * self.size
        for i, away in outwards(places, 20 * self.dot * self._unit()):
            text = str(i + 1) if i in numbered else self.marked.names[i].strip().replace("$", r"\$")
            if not text:
                continue
            extent = self._extent(text, size)
            place = board.beside(places[i], extent, 5.5 * self.dot) if away is None else None
            # A name that would stand far off is better in the list, to which a number is nearer.
            place = place or board.near(
                places[i], extent, 5 * self.dot, rings=20, away=(1, 1) if away is None else away, clear=i not in numbered
            )
            if place:
                self._set(board, place, text, size, _MARK)
            elif i not in numbered:
                crowded.add(i)
        return crowded

    def _list(self, numbered: list[int]) -> None:
        """Explains numbers right of the axes, below the legend if there is one."""
        lines = []
        for i in numbered:
            k, mu = self.marked.places[i]
            name = textwrap.shorten(self.marked.names[i], 32, placeholder=" …")
            lines.append(f"{i + 1}  {name}  ({k:.3g}, {mu:.3g})".replace("$", r"\$"))
        legend = self.ax.get_legend() if self.by_mode else None
        area = self.ax.get_window_extent()
        top = (legend.get_window_extent().y0 - area.y1) / self._unit() - self.size if legend else 0.0
        # As many columns as it takes for the list not to reach below the figure, and smaller type for more than one.
        deep = (area.y1 - self.figure.bbox.y0) / self._unit() + top
        size = 0.95 * self.size if len(lines) * 1.3 * self.size < deep else 0.75 * self.size
        rows = max(int(deep / (1.45 * size)), 1)
        if len(lines) > _COLUMNS * rows:
            lines[_COLUMNS * rows - 1 :] = [f"and {len(lines) - _COLUMNS * rows + 1} more"]
        left = 0.8 * self.size
        for start in range(0, len(lines), rows):
            text = self.ax.annotate(
                "\n".join(lines[start : start + rows]), (1, 1), (left, top), xycoords="axes fraction", textcoords="offset points",
                ha="left", va="top", fontsize=size, color=self.outside, linespacing=1.2,
            )  # fmt: skip
            self.labels.append(text)
            left += text.get_window_extent().width / self._unit() + self.size
        self.figure.draw_without_rendering()
        self._make_room(right=text.get_window_extent().x1 - self.figure.bbox.x1 + 2)
        self._named_values()

    def _make_room(self, left: float = 0, bottom: float = 0, right: float = 0) -> None:
        """Makes the axes smaller by pixels, if nothing lays out the figure."""
        if self.figure.get_layout_engine() is not None or max(left, bottom, right) <= 0:
            return
        inches = [max(pixels, 0) / self.figure.dpi for pixels in (left, bottom, right)]
        within: Any = self.ax.get_axes_locator()
        if not isinstance(within, _Within):
            within = _Within(self.ax)
            self.ax.set_axes_locator(within)
        within.room = [before + more for before, more in zip(within.room, inches)]
        self.ax.apply_aspect(within(self.ax, None))

    def _symbols(self, board: Board) -> None:
        for region in self.diagram.regions:
            if not region.polygons:
                continue
            polygon = self.ax.transData.transform(max(region.polygons, key=area_of))
            grid = grid_of(polygon)
            inner = Path(polygon).contains_points(grid)
            for size in (1.4 * self.size, 1.1 * self.size):
                place = board.inside(polygon, inner, grid, self._extent(region.symbol, size))
                if place:
                    self._set(board, place, region.symbol, size)
                    break
            else:
                self._beside_thin(board, region.symbol, grid[inner])

    def _beside_thin(self, board: Board, symbol: str, inner: Rows) -> None:
        """Names a region too thin for its symbol, with a line to it."""
        if not len(inner) or np.ptp(inner, axis=0).min() < self._unit():
            return
        heart = inner[np.argmin(np.hypot(*(inner - np.median(inner, axis=0)).T))]
        size = 1.1 * self.size
        place = board.near(heart, self._extent(symbol, size), 0)
        if place:
            self._set(board, place, symbol, size)
            self.labels += self.ax.plot(*self._data(heart), "o", color=_INK, ms=2 * self.dot, mew=0, zorder=4)

    def _formulas(self, board: Board) -> None:
        # Lines with most room first.
        drawn: list[tuple[Curve, list[Rows]]] = []
        for curve in self.curves:
            parts = [self.ax.transData.transform(part) for part in curve.parts if len(part) > 1]
            if curve.formula and not curve.dashed and parts:
                drawn.append((curve, sorted(parts, key=length_of, reverse=True)))
        for curve, parts in sorted(drawn, key=lambda one: length_of(one[1][0]), reverse=True):
            for text in filter(None, (curve.formula, curve.short)):
                place = self._beside_line(board, parts, self._extent(text, 1.1 * self.size))
                if place:
                    self._set(board, place, text, 1.1 * self.size)
                    break

    def _beside_line(self, board: Board, parts: list[Rows], extent: tuple[float, float]) -> Place | None:
        for part in parts:
            place = board.along(part, extent)
            if place:
                return place
        for part in parts[:1]:
            for share in (0.5, 0.7, 0.3):
                place = board.near(point_along(part, share), extent, 0, rings=6)
                if place:
                    return place
        return None

    def _set(self, board: Board, place: Place, text: str, size: float, color: str = _INK) -> None:
        board.take(place)
        label = self.ax.text(*self._data(place.centre), text, ha="center", va="center", size=size, color=color, zorder=7, clip_on=True)
        if len(self.marked.cloud):
            label.set_path_effects([patheffects.withStroke(linewidth=0.25 * size, foreground=(1, 1, 1, 0.75))])
        self.labels.append(label)
        if place.leader is not None:
            ends = np.array([self._data(end) for end in place.leader.reshape(2, 2)])
            self.labels += self.ax.plot(*ends.T, marker="", ls="-", color=color, lw=0.6 * self.line, zorder=5)

    def _clear(self) -> None:
        for label in self.labels:
            label.remove()
        self.labels.clear()

    # Pixels.

    def _unit(self) -> float:
        """Pixels a point, of those at 72 to an inch."""
        return self.figure.dpi / 72

    def _pixel(self, k: float, mu: float) -> Rows:
        """Where a point is marked."""
        window = self.diagram.window
        return np.asarray(self.ax.transData.transform((k, mu) if k <= window[0] and mu <= window[1] else self._edge(k, mu)[0]))

    def _data(self, pixel: Iterable[float]) -> tuple[float, float]:
        k, mu = self.ax.transData.inverted().transform(tuple(pixel))
        return float(k), float(mu)

    def _extent(self, text: str, size: float) -> tuple[float, float]:
        """Width and height of a label."""
        label = self.ax.text(0, 0, text, size=size, transform=IdentityTransform())
        box: Bbox = label.get_window_extent()
        label.remove()
        return box.width, box.height


class _Within:
    """Where axes stand that leave room for what stands beside them: within their place in the figure, wherever that is moved to."""

    def __init__(self, ax: Axes) -> None:
        self._spec = ax.get_subplotspec()
        self._place = ax.get_position(original=True)
        #: Inches at the left, below, at the right.
        self.room = [0.0, 0.0, 0.0]

    def get_subplotspec(self) -> Any:
        """The place in a grid; ``tight_layout`` asks for it."""
        return self._spec

    def __call__(self, ax: Axes, renderer: Any) -> Bbox:
        figure = root_of(ax)
        box = self._place if self._spec is None else self._spec.get_position(figure)
        wide, high = figure.get_size_inches()
        left, bottom, right = self.room[0] / wide, self.room[1] / high, self.room[2] / wide
        width, height = max(box.width - left - right, 0.3 * box.width), max(box.height - bottom, 0.3 * box.height)
        return Bbox.from_bounds(box.x0 + left, box.y0 + bottom, width, height)


def _readable(figure: Figure) -> str:
    """A colour that is read on the page around the axes: the report's ink, or that of a dark style."""

    def light(color: Any) -> float:
        red, green, blue, _ = colors.to_rgba(color)
        return 0.3 * red + 0.59 * green + 0.11 * blue

    face = figure.get_facecolor()
    style = plt.rcParams["text.color"]
    # A page that is seen through is as light as its style takes it to be.
    page = light(face) if colors.to_rgba(face)[3] > 0.5 else 1 - light(style)
    if page > 0.45:
        return _INK
    return str(style) if light(style) > 0.55 else "white"


def _short(label: str) -> str:
    """``$k_A$`` of ``$k_A = ...$``."""
    return label.split(" = ")[0] + "$" if " = " in label else label
