"""Where does a label go? On free paper, near what it names, never on another label.

A :class:`Board` knows what is drawn in a plot, in pixels with y upwards: lines, markers and labels with their leaders. It tries
places near what is to be named, the best first, all at once.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

#: Numbers in rows: of points (x, y), of boxes (left, bottom, right, top), or of straight lines (x, y, x, y).
Rows = NDArray[np.float64]

_NOTHING: Rows = np.empty((0, 4))
# From a point to its label: beside it above first; then between these.
_WAYS = ((1, 1), (-1, 1), (1, -1), (-1, -1), (0, 1), (1, 0), (-1, 0), (0, -1))
_SLANTS = ((1, 0.4), (-1, 0.4), (1, -0.4), (-1, -0.4), (0.4, 1), (-0.4, 1), (0.4, -1), (-0.4, -1))


#: What a leader costs at most that is easily followed.
_FAR = 14.0


class Place(NamedTuple):
    """Where a label goes."""

    box: Rows
    #: The ends of a line that joins it to what it names, as (x, y, x, y).
    leader: Rows | None = None

    @property
    def centre(self) -> tuple[float, float]:
        """The middle of the label."""
        left, bottom, right, top = self.box
        return float(left + right) / 2, float(bottom + top) / 2


class Board:
    """What labels have to keep clear of.

    Args:
        area: the plot, as a box.
        unit: pixels a point, of those at 72 to an inch; all distances below are in these points.
    """

    def __init__(self, area: ArrayLike, unit: float) -> None:
        self.area = np.asarray(area, dtype=np.float64)
        self.unit = unit
        self._markers = _NOTHING
        self._labels = _NOTHING
        self._leaders = _NOTHING
        self._lines = _NOTHING

    def mark(self, at: ArrayLike, size: float) -> None:
        """Keeps labels off a marker."""
        pixel, half = np.asarray(at, dtype=np.float64), size * self.unit / 2
        self._markers = np.vstack([self._markers, np.concatenate([pixel - half, pixel + half])])

    def draw(self, line: Rows) -> None:
        """Keeps labels off a line through points."""
        self._lines = np.vstack([self._lines, np.hstack([line[:-1], line[1:]])])

    def take(self, place: Place) -> None:
        """Keeps later labels off one that is set, and off its leader."""
        self._labels = np.vstack([self._labels, place.box])
        if place.leader is not None:
            self._leaders = np.vstack([self._leaders, place.leader])

    def beside(self, at: ArrayLike, size: ArrayLike, gap: float) -> Place | None:
        """A place next to a point."""
        half = np.asarray(size) / 2
        for ways, gaps in ((_WAYS, (0, 3, 6)), (_SLANTS, (0, 3, 6, 11, 15))):
            way = np.array(ways, dtype=np.float64)
            # In a corner of the point, nearer along both axes.
            shrink = np.where((way != 0).all(axis=1), 0.75, 1.0)[:, None]
            steps = [way * (shrink * (gap + more) * self.unit + half) for more in gaps]
            found = self._first(_boxes(np.asarray(at) + np.vstack(steps), half), 1.2)
            if found is not None:
                return Place(found)
        return None

    def near(
        self, at: ArrayLike, size: ArrayLike, reach: float, *, rings: int = 10, away: ArrayLike = (1, 1), clear: bool = False
    ) -> Place | None:
        """Free paper near a point, joined to it by a leader that ends ``reach`` before it: the nearest, and the one that lies
        most in the direction ``away``. The leader runs over no label, and over other leaders, markers and lines only if it would
        be long otherwise. With ``clear``, one that is long or crosses much, or that ends under another marker, is none."""
        point, half, angles = np.asarray(at, dtype=np.float64), np.asarray(size) / 2, 24
        off = np.pi * np.arange(angles) * (-1) ** np.arange(angles) / angles
        turns = np.arctan2(*np.asarray(away, dtype=np.float64)[::-1]) + off
        radii = (reach + 10 * np.arange(1, rings + 1)) * self.unit
        steps = [(radius + half) * np.column_stack([np.cos(turns), np.sin(turns)]) for radius in radii]
        boxes = _boxes(point + np.vstack(steps), half)
        free = self._off_boxes(boxes, 4.0) & self._off_lines(boxes, 2.0)
        boxes, off = boxes[free], np.tile(off, rings)[free]
        feet = np.clip(point, boxes[:, :2] - 2 * self.unit, boxes[:, 2:] + 2 * self.unit)
        long = np.maximum(np.hypot(*(feet - point).T), 1e-9)[:, None]
        leaders = np.hstack([feet, point + (feet - point) / long * reach * self.unit])
        # Markers that cover the point cannot be gone around.
        others = self._markers[((point < self._markers[:, :2]) | (point > self._markers[:, 2:])).any(axis=1)]
        # One that ends under the marker of another would name that.
        hidden = _hold(others, leaders[:, 2:]).any(axis=0)
        cost = (
            long[:, 0] / (10 * self.unit)
            + np.abs(off)
            + 2.5 * _meet(others, leaders).sum(axis=0)
            + 4 * _cross(leaders, self._lines)
            + 12 * _cross(leaders, self._leaders)
            + 4 * hidden
        )
        cost[_meet(self._labels, leaders).any(axis=0)] = np.inf
        if clear:
            cost[hidden | (cost > _FAR)] = np.inf
        if not np.isfinite(cost).any():
            return None
        best = int(np.argmin(cost))
        return Place(boxes[best], leaders[best])

    def inside(self, polygon: Rows, inner: NDArray[np.bool_], grid: Rows, size: ArrayLike) -> Place | None:
        """A place inside a polygon, of whose ``grid`` of points those marked ``inner`` lie in it: near its middle, with room
        around it if that can be had. The polygon's outline has to be drawn."""
        if not inner.any():
            return None
        half = np.asarray(size) / 2
        middle, span = grid[inner].mean(axis=0), np.ptp(polygon, axis=0)
        centres = grid[inner][np.argsort((((grid[inner] - middle) / np.maximum(span, 1e-9)) ** 2).sum(axis=1))]
        boxes = _boxes(centres, half)
        for room in (12.0, 8.0, 5.0, 3.0, 1.5):
            found = self._first(boxes, room)
            if found is not None:
                return Place(found)
        return None

    def along(self, line: Rows, size: ArrayLike) -> Place | None:
        """A place beside a line, nothing between the two."""
        half = np.asarray(size) / 2
        lengths = np.concatenate([[0], np.cumsum(np.hypot(*np.diff(line, axis=0).T))])
        shares = np.array([0.6, 0.7, 0.5, 0.8, 0.4, 0.65, 0.55, 0.75, 0.3, 0.88, 0.45, 0.2, 0.1])
        foot, ahead = (
            np.column_stack([np.interp((shares + step) * lengths[-1], lengths, line[:, axis]) for axis in (0, 1)]) for step in (0, 1e-2)
        )
        along = ahead - foot
        along /= np.maximum(np.hypot(*along.T), 1e-9)[:, None]
        for gap, lines, others in ((5.0, 3.5, 9.0), (4.0, 2.0, 5.0), (9.0, 2.0, 2.0)):
            for side in (1, -1):
                normal = side * np.column_stack([-along[:, 1], along[:, 0]])
                tip = foot + normal * gap * self.unit
                # Its corner, or the middle of its edge, touches the tip.
                for lean in (np.zeros(len(tip)), np.sign(normal[:, 0])):
                    boxes = _boxes(tip + np.column_stack([lean, np.sign(normal[:, 1])]) * half, half)
                    between = np.hstack([foot + 0.2 * (tip - foot), tip])
                    free = self._off_boxes(boxes, others) & self._off_lines(boxes, lines) & (_cross(between, self._lines) == 0)
                    if free.any():
                        return Place(boxes[int(np.argmax(free))])
        return None

    def _first(self, boxes: Rows, margin: float) -> Rows | None:
        free = self._off_boxes(boxes, margin) & self._off_lines(boxes, margin)
        return boxes[int(np.argmax(free))] if free.any() else None

    def _off_boxes(self, boxes: Rows, margin: float) -> NDArray[np.bool_]:
        """Which boxes lie in the plot, clear of others."""
        pad = self.unit * np.array([-1, -1, 1, 1])
        left, bottom, right, top = (boxes + margin * pad).T[:, :, None]
        taken = np.vstack([self._labels, self._markers])
        hit = (left < taken[:, 2]) & (right > taken[:, 0]) & (bottom < taken[:, 3]) & (top > taken[:, 1])
        low, high = self.area[:2] + 2 * self.unit, self.area[2:] - 2 * self.unit
        within = (boxes[:, :2] > low).all(axis=1) & (boxes[:, 2:] < high).all(axis=1)
        return np.asarray(within & ~hit.any(axis=1))

    def _off_lines(self, boxes: Rows, margin: float) -> NDArray[np.bool_]:
        """Which boxes are clear of lines."""
        grown = boxes + margin * self.unit * np.array([-1, -1, 1, 1])
        return np.asarray(~_meet(grown, np.vstack([self._lines, self._leaders])).any(axis=1))


def spread(wanted: Sequence[float], lengths: Sequence[float], low: float, high: float, gap: float) -> list[float] | None:
    """Middles of labels along an edge, as near as possible to the ``wanted`` ones, which rise; ``None`` if they do not fit."""
    if sum(lengths) + gap * (len(lengths) - 1) > high - low:
        return None
    # Labels that touch form groups, each at the mean of what its members want: [wishes for its start, members, length].
    groups: list[tuple[float, int, float]] = []

    def start(group: tuple[float, int, float]) -> float:
        wishes, count, length = group
        return min(max(wishes / count, low), high - length)

    for middle, length in zip(wanted, lengths):
        group = (middle - length / 2, 1, length)
        while groups and start(groups[-1]) + groups[-1][2] + gap > start(group):
            wishes, count, before = groups.pop()
            group = (wishes + group[0] - group[1] * (before + gap), count + group[1], before + gap + group[2])
        groups.append(group)
    middles: list[float] = []
    for group in groups:
        at = start(group)
        for length in lengths[len(middles) : len(middles) + group[1]]:
            middles.append(at + length / 2)
            at += length + gap
    return middles


def _boxes(centres: Rows, half: Rows) -> Rows:
    return np.hstack([centres - half, centres + half])


def _meet(boxes: Rows, lines: Rows) -> NDArray[np.bool_]:
    """Which boxes meet which straight lines, as an array of (boxes, lines)."""
    left, bottom, right, top = boxes.T[:, :, None]
    x0, y0, x1, y1 = lines.T
    # Apart by an edge of the box, or by the line: all corners on one side of it.
    apart = (np.maximum(x0, x1) < left) | (np.minimum(x0, x1) > right) | (np.maximum(y0, y1) < bottom) | (np.minimum(y0, y1) > top)
    sides = [(x1 - x0) * (y - y0) - (y1 - y0) * (x - x0) for x in (left, right) for y in (bottom, top)]
    apart |= np.min(sides, axis=0) > 0
    apart |= np.max(sides, axis=0) < 0
    return np.asarray(~apart)


def _hold(boxes: Rows, points: Rows) -> NDArray[np.bool_]:
    """Which boxes hold which points, as an array of (boxes, points)."""
    low, high = boxes[:, None, :2], boxes[:, None, 2:]
    return np.asarray(((points > low) & (points < high)).all(axis=2))


def _cross(ones: Rows, others: Rows) -> NDArray[np.intp]:
    """How many of the others each straight line crosses."""
    a, b = ones[:, None, :2], ones[:, None, 2:]
    c, d = others[None, :, :2], others[None, :, 2:]

    def side(p: Rows, q: Rows, r: Rows) -> Rows:
        return (q[..., 0] - p[..., 0]) * (r[..., 1] - p[..., 1]) - (q[..., 1] - p[..., 1]) * (r[..., 0] - p[..., 0])

    hit = (side(a, b, c) * side(a, b, d) < 0) & (side(c, d, a) * side(c, d, b) < 0)
    return np.asarray(hit.sum(axis=1))


def area_of(polygon: Rows) -> float:
    k, mu = polygon.T
    return float(abs(np.dot(k, np.roll(mu, -1)) - np.dot(mu, np.roll(k, -1))) / 2)


def outwards(places: Rows, close: float) -> Iterable[tuple[int, Rows | None]]:
    """Points in the order in which their labels are set, and whereto those go that stand in a crowd: round about it, so that
    their leaders do not cross."""
    apart = np.hypot(*(places[:, None] - places).transpose(2, 0, 1))
    crowds = apart < close
    for _ in places:
        wider = crowds @ crowds
        if (wider == crowds).all():
            break
        crowds = wider
    for i, crowd in enumerate(crowds):
        members = np.flatnonzero(crowd)
        if len(members) < 4:
            yield i, None
        elif i == members[0]:
            off = places[members] - places[members].mean(axis=0)
            turns = np.arctan2(off[:, 1], off[:, 0])
            for member in members[np.argsort(-turns)]:
                away = off[members == member][0]
                yield int(member), away if away.any() else np.ones(2)


def grid_of(polygon: Rows) -> Rows:
    """Places all over the box around a polygon."""
    low, high = polygon.min(axis=0), polygon.max(axis=0)
    steps = (np.arange(30) + 0.5)[:, None] / 30
    return np.stack(np.meshgrid(*(low + steps * (high - low)).T), axis=-1).reshape(-1, 2)


def length_of(line: Rows) -> float:
    return float(np.hypot(*np.diff(line, axis=0).T).sum())


def point_along(line: Rows, share: float) -> Rows:
    lengths = np.concatenate([[0], np.cumsum(np.hypot(*np.diff(line, axis=0).T))])
    return np.array([np.interp(share * lengths[-1], lengths, line[:, axis]) for axis in (0, 1)])
