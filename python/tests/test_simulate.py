"""Motions in time: what the program answers, typed; records as arrays; series against closed forms."""

from __future__ import annotations

import base64
import json
import math
import pickle
import shutil
import subprocess
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pandas as pd
import polars as pl
import pyarrow as pa
import pyarrow.parquet
import pytest
import standfast
from test_schema import EVERY_MOTION, errors
from test_workbook import cells

ROOT = Path(__file__).parents[2]
MOTION = ROOT / "examples/motion"
#: Lengths in half widths, accelerations in g; too low to rock.
LOW = {"block": {"b1": 1, "b2": 1, "d": 0.3, "mu_s": 0.4, "gravity": 1}}
#: A statue of metres, which a record in m/s2 or in g shakes.
STATUE = {"body": {"width": "0.6 m", "height": "2 m", "density": "2.6 t/m3", "friction": 0.5}}


def printed(program: list[str], *arguments: str | Path) -> str:
    found = subprocess.run([*program, "simulate", "--no-figures", *arguments], capture_output=True, encoding="utf-8", check=True)
    return found.stdout


def framed(path: Path) -> pd.DataFrame:
    """The first sheet of a workbook."""
    head, *rows = cells(path)
    return pd.DataFrame(rows, columns=head)


@pytest.mark.parametrize("path", EVERY_MOTION, ids=lambda path: path.stem)
def test_it_is_what_the_program_prints(program: list[str], path: Path) -> None:
    found = standfast.simulate(path)
    assert found.to_json() == printed(program, path, "--format", "json")
    assert str(found) == printed(program, path).replace("--all shows them", "all=True shows them")
    assert not errors(json.loads(found.to_json()), "simulate.schema.json")
    more = standfast.simulate(path, all=True, strength=False)
    assert str(more) == printed(program, path, "--all", "--no-strength")
    assert more.strength is None and more.divergence is not None and more.sensitivity == more.divergence.value
    assert found.strength is not None and len(found.strength.tried) == 46
    with pytest.warns(DeprecationWarning, match="sensitivity changes nothing"):
        assert standfast.simulate(path, strength=False, sensitivity=True).slide == found.slide


def test_figures_are_those_of_the_program(program: list[str], tmp_path: Path) -> None:
    path = MOTION / "caisson-breaking-wave.toml"
    found = standfast.simulate(path)
    subprocess.run([*program, "simulate", path, "-o", tmp_path], capture_output=True, check=True)
    drawn = {file.read_text(encoding="utf-8") for file in tmp_path.iterdir()}
    assert {figure.svg for figure in found.figures} == drawn and len(drawn) == len(found.figures) >= 3
    assert found["figures"] == [] and found._repr_svg_() == found.figures[0].svg
    assert [figure.title for figure in found.figures] == ["Histories", "Positions", "Animation"] and "<animate" in found.figures[2].svg


def test_a_notebook_shows_histories_and_the_motion_itself() -> None:
    found = standfast.simulate(MOTION / "caisson-breaking-wave.toml")
    page = ElementTree.fromstring(found._repr_html_())
    pictures = [image.attrib["src"].removeprefix("data:image/svg+xml;base64,") for image in page.iter("img")]
    assert [base64.b64decode(picture).decode() for picture in pictures] == [found.figures[0].svg, found.figures[2].svg]
    said = "".join(page.itertext())
    assert "comes to rest; slide -0.08467 m" in said


def test_criteria_are_typed_and_checked(program: list[str], tmp_path: Path) -> None:
    case = (MOTION / "caisson-breaking-wave.toml").read_text(encoding="utf-8")
    path = tmp_path / "case.toml"
    path.write_text(case + '\n[criteria]\nslide = "8 cm"\noverturned = false\nSF_sliding = 0.5\n', encoding="utf-8")
    found = standfast.simulate(path)
    assert found.met is False and [(c.name, c.met) for c in found.criteria] == [("slide", False), ("overturned", True)]
    slide = found.criteria[0]
    assert slide.required == 0.08 and slide.value == abs(found.slide) and slide.utilisation == pytest.approx(abs(found.slide) / 0.08)
    assert not errors(json.loads(found.to_json()), "simulate.schema.json")
    assert str(found) == printed(program, path).replace("--all shows them", "all=True shows them")
    checked = subprocess.run([*program, "simulate", "--no-figures", "--check", path], capture_output=True, check=False)
    assert checked.returncode == 3
    instant = standfast.assess(path)
    text = subprocess.run([*program, "assess", "--no-figures", path], capture_output=True, encoding="utf-8", check=True).stdout
    assert str(instant) == text and [c.name for c in instant.criteria] == ["slide", "SF_sliding", "overturned"]
    assert not errors(json.loads(instant.to_json()), "answer.schema.json")
    assert instant.in_time is not None and "simulate" in instant.in_time and instant.criteria[2].required is False
    less = standfast.design(path, vary="mass", target="slide=8cm")
    assert less.found.slide is not None and 0.0797 < less.found.slide <= 0.08 and less.present.slide == abs(found.slide)
    assert not errors(json.loads(less.to_json()), "design.schema.json")
    assert "5 Motion in time" in standfast.sheet(path)


@pytest.mark.parametrize("format", ["parquet", "arrow", "arrows", "xlsx", "csv"])
def test_a_series_is_written_in_every_format(program: list[str], tmp_path: Path, format: str) -> None:
    file = tmp_path / f"motion.{format}"
    path = MOTION / "statue-earthquake.toml"
    subprocess.run([*program, "simulate", path, "--no-figures", "--series", file, "--dt", "0.05"], capture_output=True, check=True)
    read = {
        "parquet": lambda: pyarrow.parquet.read_table(file).to_pandas(),
        "arrow": lambda: pa.ipc.open_file(file).read_all().to_pandas(),
        "arrows": lambda: pa.ipc.open_stream(file).read_all().to_pandas(),
        "xlsx": lambda: framed(file),
        "csv": lambda: pd.read_csv(file),
    }
    table = read[format]()
    series = standfast.simulate(path).series(0.05)
    assert list(table.columns) == series.column_names and len(table) > 100
    assert series.column_names[:9] == ["t", "slide", "x", "y", "theta", "omega", "state", "vx", "vy"] and len(series.column_names) == 31
    for name in set(table.columns) - {"state"}:
        np.testing.assert_allclose(table[name], series[name].to_numpy(), rtol=1e-15 if format == "xlsx" else 0)
    assert [standfast.Mode(code).symbol for code in series.state.to_pylist()] == list(table.state)


def test_a_motion_goes_on_and_points_are_told() -> None:
    case: dict[str, Any] = {
        "block": {"b1": 1, "b2": 1, "d": 3, "mu_s": 0.5, "gravity": 1},
        "motion": {
            "impact": {"law": "ratio", "ratio": 0.8},
            "base": {"horizontal": {"shape": "half-sine", "peak": 0.5, "duration": 3}},
            "points": {"shelf": [0.2, 2.5]},
        },
    }
    whole = standfast.simulate(case)
    series = whole.series(0.25)
    assert series.column_names[-4:] == ["a_x.shelf", "a_y.shelf", "f_along.shelf", "f_up.shelf"]
    felt = series["f_up.shelf"].to_numpy()
    assert whole.points[0].name == "shelf" and whole.points[0].f_up.least <= felt.min() and felt.max() <= whole.points[0].f_up.largest
    jumps = [jump for event in whole.events for jump in event.jumps]
    assert len(jumps) > 3 and {jump.point for jump in jumps} == {"shelf"} and all(event.why != "start" or not event.jumps for event in whole.events)
    row = {name: series[name].to_pylist()[12] for name in ("t", "x", "theta", "omega", "slide_O", "slide_O'")}
    assert series.state.to_pylist()[12] == standfast.Mode.ROCK_O
    case["motion"]["initial"] = {
        "time": row["t"], "x": row["x"], "theta": row["theta"], "omega": row["omega"],
        "touching": "O", "slip": "none", "slide": [row["slide_O"], row["slide_O'"]],
    }  # fmt: skip
    rest = standfast.simulate(case)
    assert rest.events[0].t == row["t"] and rest.t_rest == pytest.approx(whole.t_rest, abs=1e-9)
    assert rest.slide == pytest.approx(whole.slide, abs=1e-12)
    case["motion"]["initial"]["touching"] = "O'"
    with pytest.raises(standfast.StandfastError, match="touching names O'"):
        standfast.simulate(case)


def test_copies_scatter_by_name_and_may_be_judged() -> None:
    case: dict[str, Any] = {
        "block": {"b1": 1, "b2": 1, "d": 4, "mu_s": 2, "gravity": 1},
        "motion": {"base": {"horizontal": {"shape": "half-sine", "peak": 0.3, "duration": 3}}},
    }
    few = standfast.simulate(case, copies=30, spread={"base": 0.1, "height": 0.02}, strength=False)
    assert few.copies is not None and few.copies.names == ["height", "base"] and few.copies.spreads == [0.02, 0.1] and few.copies.spread is None
    case["motion"]["copies"] = {"number": 30, "spread": {"base": 0.1, "height": 0.02}}
    case["criteria"] = {"overturned_share": few.copies.share.high * 1.01}
    judged = standfast.simulate(case, strength=False)
    assert judged.copies is not None and judged.copies.share == few.copies.share and judged.met is True
    assert len(judged.series(0.5)) > 10
    more = standfast.simulate(case, copies=40, strength=False)
    assert more.copies is not None and more.copies.number == 40
    for wrong in ({"spread": {"bas": 0.1}}, {"spread": 2.0}, {"spread": {"base": -1}}, {"copies": 0}, {"seed": -1}):
        with pytest.raises(standfast.StandfastError):
            standfast.simulate(case, **wrong)  # type: ignore[arg-type]
    del case["motion"]["copies"], case["criteria"]
    with pytest.raises(standfast.StandfastError, match="spread is of copies"):
        standfast.simulate(case, spread=0.01)


def test_tables_of_motions_are_written_in_every_format(program: list[str], tmp_path: Path) -> None:
    rows = tmp_path / "rows.csv"
    rows.write_text("id,motion.base.horizontal.target_peak\na,0.1 g\nb,0.5 g\n", encoding="utf-8")
    case = MOTION / "statue-earthquake.toml"
    tables = {}
    for format in ("csv", "parquet", "arrow", "xlsx"):
        out = tmp_path / f"out.{format}"
        subprocess.run([*program, "batch", rows, "--case", case, "-o", out], capture_output=True, check=True)
        tables[format] = out
    plain = pd.read_csv(tables["csv"])
    columns = pyarrow.parquet.read_table(tables["parquet"])
    assert columns.equals(pa.ipc.open_file(tables["arrow"]).read_all())
    assert str(columns.schema.field("slide").type) == "double" and str(columns.schema.field("overturned").type) == "bool"
    assert str(columns.schema.field("impacts").type) == "int64"
    for table in (columns.to_pandas(), framed(tables["xlsx"])):
        for name in ("slide", "max_slide", "max_theta", "t_final", "impacts", "overturned"):
            np.testing.assert_allclose(table[name].astype(float), plain[name].astype(float), rtol=1e-15)


def test_answers_are_typed() -> None:
    found = standfast.simulate(MOTION / "caisson-breaking-wave.toml")
    assert found.situation == "wave times 1.5" and found.others == [] and found.end == "rest"
    assert [(event.why, event.state) for event in found.events] == [("start", "RE"), ("load", "SL"), ("stop", "RE"), ("rest", "RE")]
    assert isinstance(found.events[1].state, standfast.Mode) and found.events[1].also == standfast.Modes(0)
    assert found["slide"] == found.slide == found.to_dict()["slide"] and "slide" in found
    with pytest.raises(AttributeError, match="did you mean 'max_slide'"):
        found.max_slid  # type: ignore[attr-defined]
    assert repr(found).startswith("<Simulation Goda's caisson under a breaking wave") and "comes to rest; slide -0.08467 m" in repr(found)
    with pytest.raises(AttributeError, match="cannot be changed"):
        found.slide = 0  # type: ignore[misc]


def test_series_have_both_sides_of_events(program: list[str]) -> None:
    path = MOTION / "block-base-pulse.toml"
    found = standfast.simulate(path)
    series = found.series(0.25, events=True)
    lines = [line.split(",") for line in printed(program, path, "--series", "-", "--dt", "0.25", "--events").split()]
    assert lines[0] == series.column_names and [float(line[0]) for line in lines[1:]] == series.t.to_numpy().tolist()
    t, omega, theta = (series[name].to_numpy() for name in ("t", "omega", "theta"))
    side, states = series["side"].to_pylist(), [standfast.Mode(code) for code in series.state.to_numpy()]
    times = sorted({event.t for event in found.events})
    assert [t[i] for i, one in enumerate(side) if one == 1] == times and [t[i] for i, one in enumerate(side) if one == -1] == times[1:]
    even = 0.25 * np.arange(int(found.t_final / 0.25) + 1)
    assert set(even) <= set(t) and len(t) == len(set(even) | set(times)) + len(times) - 1 and (np.diff(t) >= 0).all()
    after = {event.t: event.state for event in found.events}
    impacts = 0
    for i, one in enumerate(side):
        if one == -1:
            assert side[i + 1] == 1 and t[i + 1] == t[i] and theta[i + 1] == pytest.approx(theta[i], abs=1e-12)
            assert states[i] == after[max(earlier for earlier in times if earlier < t[i])] and states[i + 1] == after[t[i]]
            impacts += abs(omega[i + 1] - omega[i]) > 1e-9
    assert impacts == found.impacts > 0
    with pytest.raises(TypeError, match="events is 1; expected True or False"):
        found.series(0.25, events=1)  # type: ignore[arg-type]


def test_series_are_those_of_the_program(program: list[str]) -> None:
    path = MOTION / "block-base-pulse.toml"
    series = standfast.simulate(path).series(0.25)
    assert isinstance(series, standfast.ArrowTable)
    lines = [line.split(",") for line in printed(program, path, "--series", "-", "--dt", "0.25").split()]
    assert lines[0] == series.column_names
    assert [float(line[4]) for line in lines[1:]] == series.theta.to_numpy().tolist()
    assert [line[6] for line in lines[1:]] == series.state.to_pylist()
    # Friction that both corners share is that of neither.
    shared = [line[13] == "" for line in lines[1:]]
    assert shared == [value is None for value in series["T_O"].to_pylist()] and any(shared)
    # Newton's law along the base, with the reaction of both corners.
    columns = {name: series[name].to_numpy() for name in ("T", "X", "ax", "N_O", "N_O'", "P", "ay")}
    np.testing.assert_allclose(columns["T"] + columns["X"], columns["ax"], atol=1e-9)
    np.testing.assert_allclose(columns["N_O"] + columns["N_O'"] - columns["P"], columns["ay"], atol=1e-9)
    assert series.state[-1] == standfast.Mode.SLIDE_ROCK_O_PRIME_RIGHT or (series.state == "RO").any()
    # The units of a block are its own; those of a body SI.
    assert "unit" not in series.theta.metadata
    wave = standfast.simulate(MOTION / "caisson-breaking-wave.toml").series(0.1)
    assert {name: wave[name].metadata.get("unit") for name in wave.column_names[:10]} == {
        "t": "s", "slide": "m", "x": "m", "y": "m", "theta": "rad", "omega": "rad/s", "state": None, "vx": "m/s", "vy": "m/s", "ax": "m/s2",
    }  # fmt: skip
    assert pl.DataFrame(wave)["slide"].to_list() == pd.DataFrame(wave.to_dict())["slide"].tolist() == pa.table(wave)["slide"].to_pylist()


def test_a_series_is_the_closed_form() -> None:
    """A steady k₀ over T slides by k₀ − μ forwards while it lasts, and by μ backwards: a parabola, and another."""
    series = standfast.simulate(LOW, base=np.full(11, 0.6), dt=0.1).series(0.05)
    t = series.t.to_numpy()
    during, after = t <= 1, t > 1
    expected = np.where(during, -0.2 * t**2 / 2, -0.1 - 0.2 * (t - 1) + 0.4 * (t - 1) ** 2 / 2)
    stop = t >= 1.5
    np.testing.assert_allclose(series.slide.to_numpy()[~stop], expected[~stop], rtol=0, atol=1e-13)
    np.testing.assert_allclose(series.slide.to_numpy()[stop], -0.15, rtol=1e-12)
    assert (series.state == "SL")[(t > 0) & (t < 1.49)].all() and during.any() and after.any()


def test_records_go_in_as_arrays_of_every_kind() -> None:
    values = [0.0, 3.0, -4.0, 5.0, -2.0, 0.0]
    found = standfast.simulate(STATUE, base=values, dt=0.2, unit="m/s2")
    assert found.max_theta > 0
    ways: list[dict[str, Any]] = [
        {"base": np.array(values), "dt": np.float64(0.2), "unit": "m/s2"},
        {"base": np.array(values, dtype=np.float32)[::1], "dt": 0.2, "unit": "m/s2"},
        {"base": np.repeat(values, 2)[::2], "dt": 0.2, "unit": "m/s2"},
        {"base": pd.Series(values, index=list("abcdef")), "dt": 0.2, "unit": "m/s2"},
        {"base": pl.Series(values), "dt": 0.2, "unit": "m/s2"},
        {"base": pa.array(values), "dt": 0.2, "unit": "m/s2"},
        {"base": pa.chunked_array([values[:2], values[2:]]), "dt": 0.2, "unit": "m/s2"},
        {"base": {"horizontal": values}, "dt": 0.2, "unit": "m/s2"},
        {"base": values, "dt": np.arange(6) * 0.2, "unit": "m/s2"},
        {"base": 100 * np.array(values), "dt": 0.2, "unit": "cm/s2"},
        {"base": np.array(values) / 9.81, "dt": 0.2, "unit": "g"},
    ]
    for way in ways:
        again = standfast.simulate(STATUE, **way)
        assert math.isclose(again.max_theta, found.max_theta, rel_tol=1e-9), way
        assert [event.why for event in again.events] == [event.why for event in found.events]
    # Upwards it lightens the body.
    both = standfast.simulate(STATUE, base={"horizontal": values, "vertical": [-2.0] * 6}, dt=0.2, unit="m/s2")
    assert both.max_theta != found.max_theta


def test_a_record_takes_the_place_of_the_file(tmp_path: Path) -> None:
    path = shutil.copy(MOTION / "statue-earthquake.toml", tmp_path)
    with pytest.raises(ValueError, match=r"cannot read \.\./records/np01002p_4225c_a\.smc"):
        standfast.simulate(path)
    still = {"horizontal": [0.0, 0.0], "vertical": [0.0, 0.0]}
    found = standfast.simulate(path, base=still, dt=1, unit="g")
    assert found.max_theta == found.slide == 0 and "stays at rest" in repr(found)


def test_a_pickle_needs_no_files(tmp_path: Path) -> None:
    shutil.copytree(MOTION, tmp_path / "motion")
    shutil.copytree(ROOT / "examples/records", tmp_path / "records")
    found = standfast.simulate(tmp_path / "motion/statue-earthquake.toml")
    pickled = pickle.dumps(found)
    shutil.rmtree(tmp_path)
    again = pickle.loads(pickled)
    assert again.to_json() == found.to_json() and str(again) == str(found)
    assert again.series(1).theta.to_pylist() == found.series(1).theta.to_pylist()
    shaken = standfast.simulate(STATUE, base=[0, 4, 0], dt=0.3, unit="m/s2")
    assert pickle.loads(pickle.dumps(shaken)).to_json() == shaken.to_json()


def test_other_situations_are_the_same_kind_of_answer() -> None:
    history = {"shape": "rect", "duration": 0.5}
    pushes = [
        {"name": name, "force": force, "direction": name, "elevation": 0.5, "history": history}
        for name, force in (("left", "30 kN/m"), ("right", "60 kN/m"))
    ]
    case = {"body": {"width": 4, "height": 1, "density": 2400, "friction": 0.2}, "load": pushes}
    found = standfast.simulate(case)
    assert len(found.others) == 1 and "1 other situation" in repr(found)
    assert found.max_slide >= found.others[0].max_slide > 0
    worst, other = found.series(found.t_final / 10), found.series(found.others[0].t_final / 10, situation=1)
    assert worst.slide[-1] == pytest.approx(found.slide) and other.slide[-1] == pytest.approx(found.others[0].slide)
    with pytest.raises(IndexError, match="situation is 2; expected 0 to 1"):
        found.series(0.1, situation=2)


@pytest.mark.parametrize(
    ("case", "options", "error", "said"),
    [
        (STATUE, {"base": [0, 1], "dt": 1}, ValueError, "unit is missing; expected that of the accelerations in base: 'm/s2', 'g', 'cm/s2'"),
        (LOW, {"base": [0, 1], "dt": 1, "unit": "g"}, ValueError, r"unit is 'g', and the case has a \[block\]"),
        (STATUE, {"base": [0, 1], "dt": 1, "unit": "gal"}, ValueError, "unit is 'gal'; expected one of 'm/s2', 'g', 'cm/s2'"),
        (STATUE, {"base": [0, 1], "unit": "g"}, TypeError, "dt is missing; expected the step of time"),
        (STATUE, {"dt": 1}, TypeError, "dt is that of base, which is not given"),
        (STATUE, {"unit": "g"}, TypeError, "unit is that of base"),
        (LOW, {"base": [0, math.nan], "dt": 1}, ValueError, "base is nan at index 1; expected a finite number"),
        (LOW, {"base": {"vertical": [0, math.inf]}, "dt": 1}, ValueError, r"base\['vertical'\] is inf at index 1"),
        (LOW, {"base": {"up": [0, 1]}, "dt": 1}, ValueError, "base has 'up'; expected 'horizontal' and 'vertical'"),
        (LOW, {"base": {}, "dt": 1}, ValueError, "base is empty"),
        (LOW, {"base": [1], "dt": 1}, ValueError, r"base has the shape \(1,\); expected two numbers or more"),
        (LOW, {"base": [[0, 1], [1, 0]], "dt": 1}, ValueError, r"base has the shape \(2, 2\)"),
        (LOW, {"base": pd.Series([0, None]), "dt": 1}, ValueError, "base has missing values"),
        (LOW, {"base": ["0", "1"], "dt": 1}, TypeError, "base is '0', a str at index 0; expected real numbers"),
        (LOW, {"base": [0, 1], "dt": 0}, ValueError, "dt is 0; expected a number above zero"),
        (LOW, {"base": [0, 1], "dt": "1 s"}, TypeError, "dt is '1 s', a str; expected a number"),
        (LOW, {"base": [0, 1], "dt": None}, TypeError, "dt is missing"),
        (LOW, {"base": [0, 1], "dt": [0, 0]}, ValueError, "dt is 0 at index 1, after 0; expected times that rise"),
        (LOW, {"base": [0, 1], "dt": [0, 1, 2]}, ValueError, "dt has 3 times and base 2 values"),
        (LOW, {"strength": 1}, TypeError, "strength is 1; expected True, False or None"),
        (STATUE, {"base": {"horizontal": [0, 1]}, "dt": 1, "all": "yes"}, TypeError, "all is 'yes'; expected True or False"),
        ({"body": {}}, {}, ValueError, "width"),
        (3, {}, TypeError, "expected the path of a case file, or a dict"),
    ],
)
def test_errors_say_what_is_wrong(case: Any, options: dict[str, Any], error: type[Exception], said: str) -> None:
    with pytest.raises(error, match=said):
        standfast.simulate(case, **options)


@pytest.mark.parametrize("dt", [0, -1, math.nan, math.inf, 1e-12, True, "1"])
def test_steps_of_a_series_are_above_zero(dt: Any) -> None:
    found = standfast.simulate(LOW, base=[0.6, 0.6], dt=1)
    with pytest.raises((ValueError, TypeError), match="expected a (number above zero|longer dt)"):
        found.series(dt)


def test_quantities_and_lazy_arrays_are_refused_with_what_to_give() -> None:
    dask = pytest.importorskip("dask.array")
    pint = pytest.importorskip("pint")
    with pytest.raises(TypeError, match=r"Call \.compute\(\) first"):
        standfast.simulate(LOW, base=dask.ones(4), dt=1)
    with pytest.raises(TypeError, match=r"base is a quantity of pint, in meter / second ?\*\* ?2; expected its \.magnitude, and unit='m/s2'"):
        standfast.simulate(STATUE, base=pint.UnitRegistry().Quantity([0, 1], "m/s^2"), dt=1, unit="m/s2")


def test_a_series_keeps_its_times() -> None:
    """A Series of pandas whose index is of times is the record at these times, and any other step is refused."""
    accelerations = 0.45 * np.sin(np.linspace(0, 2 * np.pi, 51))
    times = np.arange(51) * 0.02
    expected = standfast.simulate(STATUE, base=accelerations, dt=0.02, unit="g")
    other = standfast.simulate(STATUE, base=accelerations, dt=0.01, unit="g")
    assert expected.max_theta != other.max_theta
    for index in (times, pd.to_timedelta(times, unit="s"), pd.Timestamp("1995-01-17") + pd.to_timedelta(times, unit="s")):
        record = pd.Series(accelerations, index=index)
        for dt in (None, 0.02, times):
            found = standfast.simulate(STATUE, base=record, dt=dt, unit="g")
            assert found.max_theta == pytest.approx(expected.max_theta, rel=1e-9)
        with pytest.raises(ValueError, match="base has the time 0.02 in its index at row 1, and 0.01 by dt; leave dt out"):
            standfast.simulate(STATUE, base=record, dt=0.01, unit="g")
    # Numbers of rows are no times.
    assert standfast.simulate(STATUE, base=pd.Series(accelerations), dt=0.01, unit="g").max_theta == other.max_theta
    with pytest.raises(TypeError, match="dt is missing"):
        standfast.simulate(STATUE, base=pd.Series(accelerations), unit="g")
    with pytest.raises(ValueError, match="the index of base is 0.02 at index 1, after 0.04; expected times that rise"):
        standfast.simulate(STATUE, base=pd.Series(accelerations[:2], index=[0.04, 0.02]), unit="g")


def test_both_directions_are_of_one_length() -> None:
    with pytest.raises(ValueError, match="base has 300 values horizontal and 50 values vertical; expected as many"):
        standfast.simulate(STATUE, base={"horizontal": np.zeros(300), "vertical": np.zeros(50)}, dt=0.01, unit="g")


def test_copies_scatter_as_their_numbers_do() -> None:
    thrown = {"block": {"b1": 1, "b2": 1, "d": 0.2, "mu_s": 0.3, "gravity": 1}, "motion": {"initial": {"vx": 0.4}}}
    few, many = (standfast.simulate(thrown, copies=number, spread=0.01, seed=3).copies for number in (100, 400))
    assert (few.number, few.overturned, few.same_verdict.value) == (100, 0, 1)
    assert few.share.high == pytest.approx(1 - 0.025 ** (1 / 100), rel=1e-12)
    # The slide is v²/(2μg), whose logarithm scatters as friction's.
    below, _, middle, _, above = (quantile.value for quantile in many.slide)
    assert middle == pytest.approx(0.16 / 0.6, rel=3e-3)
    assert math.log(above / below) == pytest.approx(2 * 1.645 * 0.01, rel=0.15)
    assert standfast.simulate(thrown).copies is None
    for wrong, words in [({"copies": 0}, "copies is 0"), ({"copies": 5, "spread": 1.7}, "spread is 1.7"), ({"copies": 5, "seed": -1}, "seed is -1")]:
        with pytest.raises(standfast.StandfastError, match=words):
            standfast.simulate(thrown, **wrong)


def test_a_rebound_by_impulses() -> None:
    block = {"b1": 1, "b2": 1, "d": 2, "mu_s": 0.9, "gravity": 1}
    fallen = standfast.simulate({"block": block, "motion": {"impact": {"law": "poisson", "e": 0.5}, "initial": {"gap": 0.02}}})
    assert fallen.t_rest == pytest.approx(math.sqrt(0.04) * 1.5 / 0.5, abs=1e-9)
    assert (fallen.impact.law, fallen.impact.e, fallen.impact.ratio) == ("poisson", 0.5, None)
    assert fallen.max_gap == pytest.approx(0.02 * 0.25, rel=1e-9) and fallen.bounces > 5
    uneven = standfast.simulate({"block": block, "motion": {"impact": {"law": "ratio", "ratio": {"points": 3}}, "initial": {"theta": 0.1}}})
    # J/(J + b²), J = (1 + d²)/3 + d².
    assert uneven.impact.ratio == pytest.approx((5 / 3 + 4) / (5 / 3 + 5), rel=1e-12)
