"""Diagrams as arrays, as SVG and as matplotlib drawings."""

from __future__ import annotations

import itertools
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
import pytest
import standfast
from matplotlib.path import Path
from standfast import Diagram, Mode, Modes

BODIES = [(1, 0.4), (2, 0.55), (3, 0.8), (4, -0.55), (1, -0.6), (1, -1.0), (1, 0.0), (0.8, -2.0), (10, -0.05)]


@pytest.mark.parametrize(("gamma", "k_prime"), BODIES)
def test_regions_are_where_their_mode_begins(gamma: float, k_prime: float) -> None:
    diagram = Diagram(gamma, k_prime)
    points = np.random.default_rng(9).uniform(0, diagram.window, (20_000, 2))
    codes = diagram.mode_at(*points.T)
    inside = np.zeros(len(points), dtype=int)
    for region in diagram.regions:
        for polygon in region.polygons:
            assert polygon.shape[1] == 2 and (polygon >= 0).all() and (polygon <= diagram.window).all()
            held = Path(polygon).contains_points(points)
            inside += held
            # A point may lie between a curve and its polyline.
            assert (codes[held] == region.mode).mean() > 0.998
    assert (inside == 1).mean() > 0.998


def test_the_indeterminate_set() -> None:
    assert Diagram(1, 0.4).indeterminate == []
    diagram = Diagram(1, -0.6, window=(20, 15))
    points = np.random.default_rng(9).uniform(0, diagram.window, (20_000, 2))
    onset = standfast.onset(1, -0.6, *points.T)
    hit = 0
    for part in diagram.indeterminate:
        held = np.any([Path(polygon).contains_points(points) for polygon in part.polygons], axis=0)
        hit += held.sum()
        bits = onset.others[held] | np.left_shift(1, onset.mode[held]).astype(np.uint16)
        assert (bits == part.modes).mean() > 0.99
        assert (onset.mode[held] == part.resolved_as).mean() > 0.99 and Modes.ROCK_O in part.modes
    assert hit == pytest.approx((~onset.unique).sum(), abs=20)


def test_curves_part_different_modes() -> None:
    for gamma, k_prime in BODIES:
        diagram = Diagram(gamma, k_prime)
        k_unit, mu_unit = diagram.window
        for curve in diagram.curves:
            for part in curve.parts if not curve.dashed else []:
                ends = itertools.pairwise(part)
                for start, end in ends:
                    k, mu = (start + end) / 2
                    step = 2e-3
                    sides: list[Any] = [
                        diagram.mode_at(k + dk * step * k_unit, max(0, mu + dm * step * mu_unit))
                        for dk, dm in ((1, -1), (-1, 1))
                    ]
                    if step < k / k_unit < 1 - step and step < mu / mu_unit < 1 - step and np.ptp(part[:, 0]) > 0.1 * k_unit:
                        if curve.name in ("OA", "CD", "mu*", "mu**") and k_prime >= 0:
                            assert sides[0] != sides[1], (gamma, k_prime, curve.name, k, mu)


def test_named_points_have_the_published_coordinates() -> None:
    points = Diagram(3, 0.8).points
    assert {name: (round(p.k, 4), round(p.mu, 4)) for name, p in points.items()} == {
        "A": (0.1852, 0.1852),
        "C": (0, 0.3333),
        "D": (0.4167, 0),
        "E": (1.0465, 0),
    }
    assert Diagram(4, -0.55).points["B'"].mu == pytest.approx(5 / 3)


def test_svg() -> None:
    diagram = Diagram(2, 0.3)
    assert diagram._repr_svg_() == diagram.svg()
    with_point = diagram.svg({"storm": (0.31, 0.6)})
    assert with_point.startswith("<svg") and "storm" in with_point
    assert repr(diagram) == "Diagram(gamma=2, k_prime=0.3)"


@pytest.mark.parametrize(("gamma", "k_prime"), BODIES)
def test_plots_show_everything_and_no_label_over_another(gamma: float, k_prime: float) -> None:
    diagram = Diagram(gamma, k_prime)
    _, ax = plt.subplots(figsize=(6.4, 4.8), layout="constrained")
    assert diagram.plot(ax, points={"design": (0.5 * diagram.window[0], 0.6 * diagram.window[1])}) is ax
    assert (ax.get_xlim(), ax.get_ylim()) == ((0, diagram.window[0]), (0, diagram.window[1]))
    labels = [text for text in ax.texts if text.get_text()]
    shown = {text.get_text() for text in labels}
    # A region that shows at this size is named.
    area = np.prod(diagram.window)
    for region in diagram.regions:
        share = sum(abs(_area(polygon)) for polygon in region.polygons) / area
        assert region.symbol in shown or share < 0.01, (region.mode, share)
    assert "design" in shown
    boxes = [text.get_window_extent() for text in labels]
    for one, other in itertools.combinations(boxes, 2):
        assert not one.overlaps(other)
    plt.close("all")


def _area(polygon: Any) -> float:
    k, mu = polygon.T
    return float(np.dot(k, np.roll(mu, -1)) - np.dot(mu, np.roll(k, -1))) / 2


def test_plots_leave_matplotlibs_settings_alone() -> None:
    before = dict(plt.rcParams)
    Diagram(1, 0.4).plot()
    assert dict(plt.rcParams) == before
    plt.close("all")


def test_wrong_diagrams() -> None:
    with pytest.raises(ValueError, match="^slenderness γ is -1; expected a number above zero"):
        Diagram(-1, 0.4)
    with pytest.raises(ValueError, match="^elevation k' is NaN"):
        Diagram(1, float("nan"))
    with pytest.raises(ValueError, match=r"window is \(0.0, 1.0\); expected the largest k"):
        Diagram(1, 0.4, window=(0, 1))
    assert Diagram(1, 0.4).mode_at(0.5, 0.6) is Mode.REST
