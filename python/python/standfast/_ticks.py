"""The numbers of an axis, for the limits and the length that it has when it is drawn."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axis import Axis
from matplotlib.figure import Figure
from matplotlib.ticker import Formatter, Locator

from . import _standfast
from ._diagram import _mathtext


def number(axis: Axis, size: float, upright: bool) -> None:
    """Gives an axis round numbers in type of this size."""
    numbers = _Numbers(size, upright)
    axis.set_major_locator(_Major(numbers))
    axis.set_major_formatter(_Markup(numbers))
    axis.set_minor_locator(_Minor(numbers))


class _Numbers:
    """The round numbers of an axis, for the limits and the length that it has when it is drawn."""

    def __init__(self, size: float, upright: bool) -> None:
        self.size = size
        self.upright = upright

    def along(self, axis: Any) -> tuple[list[tuple[float, str]], list[float]]:
        low, high = sorted(axis.get_view_interval())
        extent = axis.axes.get_window_extent()
        pixels = (extent.height if self.upright else extent.width) / root_of(axis.axes).dpi * 72
        if not (np.isfinite([low, high]).all() and low < high and pixels > 0):
            return [], []
        numbers, between = _standfast.diagram_numbers(low, high, pixels / self.size, self.upright)
        # The origin has one zero for both axes; a number at the very top would run into the name of the axis.
        top = high - (0.9 * self.size / pixels * (high - low) if self.upright else 0)
        return [(at, text) for at, text in numbers if at <= top and not at == low == 0], between


class _Major(Locator):
    def __init__(self, numbers: _Numbers) -> None:
        self.numbers = numbers

    def __call__(self) -> list[float]:
        return [at for at, _ in self.numbers.along(self.axis)[0]]


class _Minor(_Major):
    def __call__(self) -> list[float]:
        return self.numbers.along(self.axis)[1]


class _Markup(Formatter):
    def __init__(self, numbers: _Numbers) -> None:
        self.numbers = numbers

    def __call__(self, value: float, pos: int | None = None) -> str:
        # The pointer of a window asks for values that carry no number.
        numbers = dict(self.numbers.along(self.axis)[0])
        return _mathtext(numbers[value]) if value in numbers else f"{value:.4g}"


def root_of(ax: Any) -> Figure:
    """The figure that axes are in, not a part of it."""
    try:
        figure = ax.get_figure(root=True)
    except TypeError:  # matplotlib before 3.10
        figure = ax.figure.figure
    assert isinstance(figure, Figure)
    return figure
