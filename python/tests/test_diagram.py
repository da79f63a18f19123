"""Diagrams as arrays, as SVG and as matplotlib drawings."""

from __future__ import annotations

import copy
import itertools
import pickle
import re
import unicodedata
from collections.abc import Callable
from typing import Any

import duckdb
import matplotlib
import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import polars as pl
import pyarrow as pa
import pytest
import standfast
from matplotlib.font_manager import FontProperties
from matplotlib.path import Path
from matplotlib.textpath import TextPath
from matplotlib.transforms import Bbox
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


def window_of(svg: str) -> tuple[float, float]:
    """The window that the description of an SVG states, to three digits."""
    found = re.search(r"from 0 to (\S+), over the force k, to the right from 0 to (\S+)\. ", svg)
    assert found
    return float(found[2]), float(found[1])


@pytest.mark.parametrize("window", [None, (0.8, 0.5), (7.0, 9.0)])
@pytest.mark.parametrize("points", [{}, {"far": (2.5, 1.75)}, {"near": (0.1, 0.2)}, [(0.4, 3.0), (0.1, 0.1)]])
@pytest.mark.filterwarnings("ignore:.* points lie outside")
def test_the_window_is_one_decision(window: Any, points: Any) -> None:
    diagram = Diagram(2, 0.3, window=window)
    ax = diagram.plot(points=points)
    shown = (ax.get_xlim()[1], ax.get_ylim()[1])
    assert window_of(diagram.svg(points)) == pytest.approx(shown, rel=5e-3)
    assert window_of(diagram._repr_svg_()) == pytest.approx(diagram.window, rel=5e-3)
    if window:
        assert shown == window == diagram.window
    else:
        places = np.array(list(points.values()) if isinstance(points, dict) else points).reshape(-1, 2)
        assert (places < shown).all()
    plt.close("all")


def labels_of(ax: Any) -> dict[str, Any]:
    """All that is written in and around axes, with its box in pixels."""
    texts = [*ax.texts, *ax.get_xticklabels(), *ax.get_yticklabels()]
    return {text.get_text(): text.get_window_extent() for text in texts if text.get_text()}


def assert_tidy(ax: Any, names: Any = ()) -> None:
    """No label touches another; names of points are clear of markers and of lines other than leaders."""
    boxes = labels_of(ax)
    for (one, box), (other, beside) in itertools.combinations(boxes.items(), 2):
        assert not box.overlaps(beside), (one, other)
    for line in ax.lines:
        pixels = line.get_transform().transform(line.get_xydata())
        is_marker = line.get_linestyle() == "None"
        for name in names:
            box = boxes.get(name)
            if box is None:
                continue
            if is_marker:
                half = line.get_markersize() / 2 * ax.figure.dpi / 72
                assert not any(box.overlaps(Bbox([at - half, at + half])) for at in pixels), name
            elif len(pixels) > 1:
                assert not Path(pixels).intersects_bbox(box, filled=False), name


@pytest.mark.parametrize(("gamma", "k_prime"), BODIES)
@pytest.mark.parametrize("width", [3.35, 6.4])
def test_plots_show_everything_and_no_label_over_another(gamma: float, k_prime: float, width: float) -> None:
    diagram = Diagram(gamma, k_prime)
    _, ax = plt.subplots(figsize=(width, 0.75 * width), layout="constrained")
    assert diagram.plot(ax, points={"design": (0.5 * diagram.window[0], 0.6 * diagram.window[1])}) is ax
    shown = labels_of(ax)
    # A region that shows at this size is named.
    window = (ax.get_xlim()[1], ax.get_ylim()[1])
    area = window[0] * window[1]
    for region in Diagram(gamma, k_prime, window=window).regions:
        share = sum(abs(_area(polygon)) for polygon in region.polygons) / area
        assert region.symbol in shown or share < 0.01, (region.mode, share)
    assert "design" in shown
    assert_tidy(ax, ["design"])
    plt.close("all")


def named(ax: Any) -> set[str]:
    """The names that stand at points or in the list that explains numbers."""
    lines = [line for label in labels_of(ax) for line in label.split("\n")]
    listed = (re.fullmatch(r"\d+  (.*)  \(\S+, \S+\)", line) for line in lines)
    return {*lines, *(found[1] for found in listed if found)}


@pytest.mark.parametrize("layout", [None, "constrained"])
@pytest.mark.parametrize("apart", [0.04, 0.012, 0.0])
def test_twelve_close_points_are_all_seen_and_named(apart: float, layout: Any) -> None:
    random = np.random.default_rng(3)
    points = {f"storm {i}": (0.5 + apart * random.normal(), 0.4 + apart * random.normal()) for i in range(12)}
    _, ax = plt.subplots(layout=layout)
    Diagram(1, 0.4).plot(ax, points=points)
    assert set(points) <= named(ax)
    assert_tidy(ax, points)
    marked = [line for line in ax.lines if line.get_linestyle() == "None" and line.get_marker() == "D"]
    seen = {tuple(at) for line in marked for at in line.get_xydata()}
    assert {(float(k), float(mu)) for k, mu in points.values()} <= seen
    page = ax.figure.bbox
    for text, box in labels_of(ax).items():
        assert page.x0 <= box.x0 and box.x1 <= page.x1 and page.y0 <= box.y0, text
    plt.close("all")


def test_diagrams_of_the_same_are_equal() -> None:
    diagram = Diagram(1, 0.4, omega=0.1)
    same = [copy.copy(diagram), copy.deepcopy(diagram), pickle.loads(pickle.dumps(diagram)), Diagram(np.float64(1), 0.4, omega=0.1)]
    others = [Diagram(1, 0.4), Diagram(1, 0.5, omega=0.1), Diagram(1, 0.4, omega=0.1, window=(1, 1)), Diagram(1, 0.4, law="ec7", share=0.1), 1]
    assert all(diagram == one and hash(diagram) == hash(one) for one in same)
    assert all(diagram != other for other in others)


@pytest.mark.parametrize("moved", ["tight_layout", "subplots_adjust", "set_size_inches"])
def test_what_stands_beside_the_axes_stays_on_the_page_where_they_are_moved(moved: str) -> None:
    """Laid out after it is drawn, a diagram keeps the room that its values and lists take: none is cut off, none covers its neighbour."""
    points = {f"storm number {i}": (0.5 + 0.001 * i, 0.4) for i in range(12)}
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.5))
    Diagram(0.8, 0.9).plot(left, points=[(0.2, 0.4), (0.9, 0.3)])
    Diagram(1, 0.4).plot(right, points=points)
    moves: dict[str, Callable[[], object]] = {
        "tight_layout": figure.tight_layout,
        "subplots_adjust": lambda: figure.subplots_adjust(left=0.06, right=0.9, wspace=0.3),
        "set_size_inches": lambda: figure.set_size_inches(14, 6),
    }
    moves[moved]()
    figure.draw_without_rendering()
    page = figure.bbox
    boxes = [{**labels_of(ax), **{f"{ax.get_title()} axes": ax.get_window_extent()}} for ax in (left, right)]
    for of_one in boxes:
        for text, box in of_one.items():
            assert page.x0 - 1 <= box.x0 and box.x1 <= page.x1 + 1 and page.y0 - 1 <= box.y0 and box.y1 <= page.y1 + 1, text
    assert max(box.x1 for box in boxes[0].values()) <= min(box.x0 for box in boxes[1].values()) + 1
    plt.close("all")


def test_points_beyond_limits_that_are_set_later_are_not_drawn() -> None:
    """As with the shared axes of another diagram: a point on an axis beyond them would float in white, and one within them is whole."""
    figure, ax = plt.subplots()
    Diagram(1, 0.4).plot(ax)
    # C, at μ = 1, is beyond them, and D lies on the axis.
    ax.set_ylim(0, 0.95)
    figure.canvas.draw()
    dots = {tuple(np.round(line.get_xydata()[0], 3)): line for line in ax.lines if line.get_marker() == "o"}
    dark = np.asarray(figure.canvas.buffer_rgba())[::-1, :, :3].astype(int).sum(axis=2) < 300
    k, mu = ax.transData.transform(dots[0.0, 1.0].get_xydata()[0]).astype(int)
    assert mu < len(dark) - 4 and not dark[mu - 3 : mu + 4, k - 3 : k + 4].any()
    k, mu = ax.transData.transform(dots[2.5, 0.0].get_xydata()[0]).astype(int)
    # Outwards of the axis, whose line is thin.
    assert dark[mu - 3 : mu - 1, k - 1 : k + 2].any()
    plt.close("all")


def test_sixty_points_in_a_row_are_named_by_number_and_list() -> None:
    points = {f"case number {i}": (0.3 + 0.002 * i, 0.4) for i in range(60)}
    assert set(points) <= named(Diagram(2, 0.3).plot(points=points))
    plt.close("all")


def test_points_outside_of_a_window_that_was_asked_for_are_pointed_at() -> None:
    diagram = Diagram(2, 0.3, window=(1, 0.8))
    points = {"right": (1.4, 0.3), "up": (0.5, 2.0), "both": (3, 4), "inside": (0.4, 0.5)}
    ax = diagram.plot(points=points)
    assert set(points) <= named(ax)
    assert_tidy(ax, points)
    arrows = {line.get_marker()[2]: line.get_xydata()[0] for line in ax.lines if isinstance(line.get_marker(), tuple)}
    # Turned from upwards: to the right, upwards, and between.
    assert sorted(round(angle) for angle in arrows)[0] == -90 and round(max(arrows)) == 0 and len(arrows) == 3
    assert all(0.9 < at[0] / 1 or 0.9 < at[1] / 0.8 for at in arrows.values())
    svg = diagram.svg(points)
    for words in ("right (1.4, 0.3), outside the window", "inside (0.4, 0.5):"):
        assert words in svg
    with pytest.warns(UserWarning, match="1 of 2 points lie outside of the window, k up to 1 and μ up to 0.8"):
        diagram.plot(points=[(0.5, 0.5), (2, 2)])
    plt.close("all")


@pytest.mark.parametrize(("gamma", "k_prime"), BODIES)
def test_axes_have_numbers_where_they_belong_and_the_named_values(gamma: float, k_prime: float) -> None:
    diagram = Diagram(gamma, k_prime)
    ax = diagram.plot()
    for axis, limit in ((ax.xaxis, diagram.window[0]), (ax.yaxis, diagram.window[1])):
        ticks = [(tick.get_loc(), tick.label1.get_text().strip("$")) for tick in axis.get_major_ticks()]
        assert len(ticks) >= 3 and all(tick.label1.get_visible() for tick in axis.get_major_ticks())
        assert all(float(text) == pytest.approx(at, rel=1e-9) and 0 < at <= limit for at, text in ticks)
    texts = {text.get_text().split(" = ")[0].strip("$"): text for text in ax.texts}
    for name in ("A", "D"):
        if name in diagram.points:
            mark = texts[f"k_{name}"]
            middle = mark.get_window_extent().get_points().mean(axis=0)
            at = ax.transData.transform((diagram.points[name].k, 0))
            assert abs(middle[0] - at[0]) < 40 and middle[1] < at[1]
    plt.close("all")


def test_numbers_follow_a_change_of_the_limits() -> None:
    ax = Diagram(1, 0.4).plot()
    ax.set_xlim(0.51, 0.514)
    ax.figure.draw_without_rendering()
    assert [label.get_text() for label in ax.get_xticklabels()][:2] == ["$0.5100$", "$0.5105$"]
    plt.close("all")


def luminance(color: Any) -> float:
    channels = np.array(matplotlib.colors.to_rgb(color))
    return float(np.dot(np.where(channels <= 0.04045, channels / 12.92, ((channels + 0.055) / 1.055) ** 2.4), (0.2126, 0.7152, 0.0722)))


def contrast(one: Any, other: Any) -> float:
    dark, light = sorted((luminance(one), luminance(other)))
    return (light + 0.05) / (dark + 0.05)


@pytest.mark.parametrize("style", ["dark_background", "Solarize_Light2", "grayscale", "ggplot", "classic", "seaborn-v0_8-darkgrid", "seaborn-v0_8-dark"])
@pytest.mark.parametrize("page", [None, "#20242a"])
def test_any_style_is_readable(style: str, page: str | None) -> None:
    with plt.style.context(style):
        figure, ax = plt.subplots(layout="constrained", facecolor=page)
        Diagram(3, 0.8).plot(ax, points={"storm": (0.2, 0.1)}, by_mode=True)
        figure.draw_without_rendering()
    area = ax.get_window_extent()
    texts = [*ax.texts, *ax.get_xticklabels(), *ax.get_yticklabels(), *ax.get_legend().get_texts()]
    for text in texts:
        box = text.get_window_extent()
        inside = area.x0 < box.x0 and box.x1 < area.x1 and area.y0 < box.y0
        if text.get_text():
            # Inside it stands on the light colours of the modes, the darkest of which has a luminance of 0.37.
            assert contrast(text.get_color(), "#e986a0" if inside and text.get_text() != "storm" else "white" if inside else figure.get_facecolor()) > 4.5
    for tick in (*ax.xaxis.get_major_ticks(), *ax.yaxis.get_major_ticks()):
        assert tick.tick1line.get_visible() and tick.tick1line.get_markersize() > 2 and not tick.gridline.get_visible()
        assert contrast(tick.tick1line.get_color(), figure.get_facecolor()) > 4.5
    plt.close("all")


def test_bars_do_not_read_as_letters() -> None:
    formulas = [curve.formula for curve in Diagram(1, -0.6).curves if "k′" in curve.formula]
    assert formulas
    for formula in formulas:
        bar = next(sign for sign in formula if unicodedata.category(sign) == "Sm" and sign not in "=+-" or sign == "|")
        # An l stands on the base line; a bar reaches below it.
        with plt.rc_context({"mathtext.fontset": "stix"}):
            path = TextPath((0, 0), f"${bar}$", size=100, prop=FontProperties(family="STIXGeneral"))
        assert path.get_extents().y0 < -10


def test_clouds_of_points() -> None:
    random = np.random.default_rng(1)
    cloud = np.column_stack([random.uniform(0, 2, 1000), random.uniform(0, 1, 1000)])
    diagram = Diagram(1, 0.4)
    frame = pd.DataFrame({"mu": cloud[:, 1], "k": cloud[:, 0]}, index=range(5, 1005))
    svgs = [diagram.svg(form) for form in (cloud, cloud.tolist(), frame, pl.DataFrame(frame), pa.table(frame))]
    assert len(set(svgs)) == 1 and "Dots: 1000 points." in svgs[0]
    ax = diagram.plot(points=frame, by_mode=True)
    codes, counts = np.unique(standfast.classify(1, 0.4, *cloud.T), return_counts=True)
    assert [text.get_text().split()[-1] for text in ax.get_legend().get_texts()] == [str(count) for count in counts]
    drawn = {line.get_marker(): len(line.get_xydata()) for line in ax.lines if line.get_alpha()}
    assert sorted(drawn.values()) == sorted(counts) and len(drawn) == len(codes)
    frame["name"] = [f"s{i}" for i in range(1000)]
    assert {"s0", "s2"} <= named(diagram.plot(points=frame[:3]))
    plt.close("all")


def test_tables_of_every_library_are_points() -> None:
    diagram = Diagram(1, 0.4)
    rows = {"k": [0.5, 0.7], "mu": [0.6, 0.1]}
    table = pa.table(rows)
    expected = diagram.svg([(0.5, 0.6), (0.7, 0.1)])
    query = "select unnest([0.5, 0.7]) k, unnest([0.6, 0.1]) mu"
    for given in (table, table.to_batches()[0], table.to_reader(), pl.DataFrame(rows), pd.DataFrame(rows, dtype=object), duckdb.sql(query)):
        assert diagram.svg(given) == expected
    rows["name"] = ["calm", "storm"]
    table = pa.table(rows)
    expected = diagram.svg({"calm": (0.5, 0.6), "storm": (0.7, 0.1)})
    for named_rows in (table, table.to_batches()[0], table.to_reader(), pl.DataFrame(rows), pd.DataFrame(rows)):
        assert diagram.svg(named_rows) == expected


@pytest.mark.parametrize(
    ("points", "error", "words"),
    [
        ({"storm": (0.5, -0.1)}, ValueError, r'point "storm": friction μ is -0.1; expected a number from 0'),
        ({"storm": (float("nan"), 0.1)}, ValueError, r'point "storm": force k is NaN; expected'),
        ({"k": [0.1, 0.2, 0.3], "mu": [0.1, 0.2, 0.3]}, ValueError, r"point 'k' is \[0.1, 0.2, 0.3\]; expected \(k, μ\); many"),
        ({"storm": 0.5}, ValueError, r"point 'storm' is 0.5; expected \(k, μ\)"),
        ({"storm": ("0.5", "0.1")}, TypeError, r"point 'storm' holds <U3 such as '0.5'; expected numbers"),
        ([(0.5, 0.1), (0.5, -0.1)], ValueError, "friction μ is -0.1 at index 1; expected"),
        (np.zeros((2, 5)), ValueError, r"shape \(2, 5\).*np.column_stack\(\[k, mu\]\)"),
        (pd.DataFrame({"k": [1.0], "friction": [1.0]}), ValueError, r"no column 'mu' \(it has k, friction\)"),
        (pd.DataFrame([[1.0, 2.0, 3.0]], columns=["k", "k", "mu"]), ValueError, "2 columns 'k'"),
        (np.ma.masked_array([(0.5, 0.1), (0.7, 0.1)], [(False, False), (True, False)]), ValueError, "points is masked in part"),
        ({"storm": np.ma.masked_array([0.5, 0.1], [False, True])}, ValueError, "point 'storm' is masked in part"),
        ({None: (0.5, 0.1)}, ValueError, "point of the name None"),
        (pl.DataFrame({"k": [1.0, None], "mu": [1.0, 1.0]}), ValueError, "no k or no mu in row 1"),
        (pd.DataFrame({"k": [1.0, 1.0], "mu": [1.0, np.nan]}), ValueError, "no k or no mu in row 1"),
        (pd.DataFrame({"k": [1.0, 1.0], "mu": [1.0, 1.0], "name": ["a", None]}), ValueError, "points has no name in row 1"),
        (pl.DataFrame({"k": [1.0], "mu": [1.0], "name": [None]}), ValueError, "points has no name in row 0"),
        (pa.table({"k": [1.0], "mu": [1.0], "name": pa.nulls(1)}), ValueError, "points has no name in row 0"),
        (duckdb.sql("select 1 k, 2 mu, 'a' \"name\""), TypeError, "with names; expected a DataFrame"),
        (duckdb.sql("select 1 k, 2 friction"), ValueError, r"no column 'mu' \(it has k, friction\)"),
        (pl.LazyFrame({"k": [1.0], "mu": [1.0]}), TypeError, "LazyFrame, which has no values yet; collect"),
    ],
)
def test_wrong_points(points: Any, error: type[Exception], words: str) -> None:
    diagram = Diagram(1, 0.4)
    for face in (diagram.svg, lambda points: diagram.plot(points=points)):
        with pytest.raises(error, match=words):
            face(points)
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
