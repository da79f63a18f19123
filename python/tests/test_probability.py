"""Probabilities and draws: what the program answers, typed; frequencies of draws against integrals."""

from __future__ import annotations

import importlib.util
import json
import math
import pickle
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import polars as pl
import pyarrow.ipc
import pyarrow.parquet
import pytest
import standfast
from test_schema import EVERY_RANDOM, errors
from test_workbook import cells

ROOT = Path(__file__).parents[2]
GODA = ROOT / "examples/goda-2000-random.toml"
PLANE = {
    "point": {"gamma": 0.8, "k_prime": 0.9167},
    "random": {"k": {"gumbel": {"mean": 0.45, "sd": 0.1}}, "mu": {"normal": {"mean": 0.6, "sd": 0.1}, "lower": 0.0}},
}


def printed(program: list[str], *arguments: str | Path) -> str:
    found = subprocess.run([*program, "probability", *arguments, "--no-figures"], capture_output=True, encoding="utf-8", check=True)
    return found.stdout


@pytest.mark.parametrize("path", EVERY_RANDOM, ids=lambda path: path.stem)
def test_it_is_what_the_program_prints(program: list[str], path: Path) -> None:
    found = standfast.probability(path)
    assert found.to_json() == printed(program, path, "--format", "json")
    assert str(found) == printed(program, path)
    assert not errors(json.loads(found.to_json()), "probability.schema.json")


def test_options_are_those_of_the_program(program: list[str]) -> None:
    asked = {"method": "monte-carlo", "seed": 3, "precision": 0.3, "floor": 1e-3, "samples": 200_000}
    found = standfast.probability(GODA, **asked, threads=1)  # type: ignore[arg-type]
    options = [f"--{name}={value}" for name, value in asked.items()]
    assert found.to_json() == printed(program, GODA, *options, "--format", "json")
    assert found.method == "monte-carlo" and found.seed == 3
    assert standfast.probability(GODA, **asked, threads=2).to_json() == found.to_json()  # type: ignore[arg-type]


def test_answers_are_typed() -> None:
    found = standfast.probability(PLANE)
    assert found.method == "integrate" and found.precise and found.others == [] and found.life is None
    assert found.modes["SL"].probability == found.modes[standfast.Mode.SLIDE_LEFT].probability
    assert math.isclose(sum(chance.probability for chance in found.modes.values()), 1, abs_tol=1e-9)
    assert found.not_rest.low <= found.not_rest.probability <= found.not_rest.high
    assert math.isclose(1 - found.not_rest.probability, found.modes["RE"].probability, rel_tol=1e-9)
    with pytest.raises(KeyError, match="there is no 'SLIDE'; there are RE, SL"):
        found.modes["SLIDE"]
    assert [one.name for one in found.importance] == ["k", "mu"] and found.design_point is not None
    assert found.design_point.keys() == {"k", "mu"} and found.beta is not None and found.beta > 0
    assert math.isclose(sum(one.alpha2 or 0 for one in found.importance), 1, rel_tol=1e-6)
    assert repr(found).startswith("<Probability the case: RE 0.") and pickle.loads(pickle.dumps(found)).to_dict() == found.to_dict()


def test_form_adds_the_nearest_point_of_every_mode(program: list[str], tmp_path: Path) -> None:
    """Rocking begins at the corner A of the plane, where k and μ are 1/(γ(1 + k'))."""
    found = standfast.probability(PLANE, method="form")
    points = found.design_points
    assert found.method == "integrate" and points is not None and standfast.probability(PLANE).design_points is None
    corner = 1 / (0.8 * 1.9167)
    rocks = points["RO"]
    assert rocks.point == pytest.approx({"k": corner, "mu": corner}, abs=1e-9)
    assert points[standfast.Mode.ROCK_O].beta == rocks.beta == pytest.approx(math.hypot(*(rocks.beta * a for a in rocks.alpha.values())))
    assert rocks.first_order == pytest.approx(0.5 * math.erfc(rocks.beta / math.sqrt(2)), rel=1e-9)
    path = tmp_path / "plane.toml"
    path.write_text(
        "[point]\ngamma = 0.8\nk_prime = 0.9167\n[random]\nk = { gumbel = { mean = 0.45, sd = 0.1 } }\n"
        "mu = { normal = { mean = 0.6, sd = 0.1 }, lower = 0 }\n"
    )
    document = json.loads(printed(program, path, "--method", "form", "--format", "json"))
    assert document["design_points"] == json.loads(found.to_json())["design_points"]
    assert not errors(document, "probability.schema.json")


def test_along_a_number_each_point_is_its_own_case(program: list[str]) -> None:
    found = standfast.probability(PLANE, over="gamma=0.7..0.9:3")
    assert found.fragility is not None and found.fragility.name == "gamma"
    # A lognormal curve is one along a strength, as k is, and the slenderness is none.
    assert found.fragility.fit is None
    along_k = {**PLANE, "random": {name: law for name, law in PLANE["random"].items() if name != "k"}, "point": {**PLANE["point"], "k": 0.5}}
    pushed = standfast.probability(along_k, over="k=0.3..0.9:4").fragility
    assert pushed is not None and pushed.fit is not None
    assert [point.value for point in found.fragility.points] == pytest.approx([0.7, 0.8, 0.9])
    for point in found.fragility.points:
        alone = standfast.probability({**PLANE, "point": {**PLANE["point"], "gamma": point.value}})
        assert math.isclose(point.not_rest.probability, alone.not_rest.probability, rel_tol=1e-9)
    assert standfast.probability(PLANE).fragility is None


def test_the_probability_of_one_uniform_number_is_a_length() -> None:
    """Under k = 0.5, k' = 0.4, γ = 0.8 the body slides below μ = 0.5, and rests above."""
    case = {"point": {"gamma": 0.8, "k_prime": 0.4, "k": 0.5}, "random": {"mu": {"uniform": {"from": 0.4, "to": 0.8}}}}
    found = standfast.probability(case)
    assert found.modes["SL"].probability == pytest.approx(0.25, rel=1e-12) and found.modes["RE"].probability == pytest.approx(0.75, rel=1e-12)


def test_draws_are_as_frequent_as_they_are_probable() -> None:
    n = 40_000
    found, drawn = standfast.probability(PLANE), standfast.draws(PLANE, n, seed=5)
    assert drawn.column_names == ["k", "mu", "k_eff", "k_prime_eff", "mode"] and len(drawn) == n
    for name, chance in found.modes.items():
        if chance.probability > 1e-3:
            error = math.sqrt(chance.probability * (1 - chance.probability) / n)
            assert abs(np.mean(drawn.mode == name) - chance.probability) < 4 * error, name
    # Each is the point that it says, and has its mode.
    columns = drawn.to_dict()
    np.testing.assert_array_equal(columns["mode"], standfast.classify(0.8, 0.9167, columns["k"], columns["mu"]))
    np.testing.assert_array_equal(columns["k_eff"], columns["k"])
    np.testing.assert_allclose(columns["k_prime_eff"], 0.9167, rtol=1e-13)


def test_draws_of_a_case_are_what_assess_table_answers() -> None:
    drawn = standfast.draws(GODA, 200, seed=2)
    assert drawn["wave.deep_water_height"].metadata == {"unit": "m"} and drawn["bias.P"].metadata == {}
    columns = drawn.to_dict()
    varied = {name: columns[name] for name in ("friction", "wave.deep_water_height")}
    case = ROOT / "examples/goda-2000.toml"
    found = standfast.assess_table(case, varied, columns=["P", "U", "buoyant_weight"])
    thrust, uplift = found["P"] * columns["bias.P"], found["U"] * columns["bias.U"]
    np.testing.assert_allclose(columns["k_eff"], thrust / (found["buoyant_weight"] - uplift), rtol=1e-9)
    slides = thrust > columns["friction"] * (found["buoyant_weight"] - uplift)
    assert 0 < slides.sum() and ((drawn.mode == "SL") == slides).all()


@pytest.mark.parametrize("method", ["integrate", "sobol", "monte-carlo"])
@pytest.mark.parametrize("ending", ["csv", "parquet", "arrow", "arrows", "xlsx"])
def test_files_of_draws_are_read_back_as_what_they_are(program: list[str], tmp_path: Path, ending: str, method: str) -> None:
    """By polars, pyarrow and the standard library: each number to its last digit is that of `draws`."""
    case, file = tmp_path / "plane.toml", tmp_path / f"draws.{ending}"
    case.write_text(
        "[point]\ngamma = 0.8\nk_prime = 0.9167\n[random]\nk = { gumbel = { mean = 0.45, sd = 0.1 } }\n"
        "mu = { normal = { mean = 0.6, sd = 0.1 }, lower = 0.0 }\n"
    )
    asked = ["--draws", str(file), "--method", method, "--samples", "3000", "--seed", "5", "--floor", "0.9"]
    assert f"Draws written to {file}" in printed(program, case, *asked)
    columns: dict[str, list[Any]]
    if ending == "xlsx":
        header, *rows = cells(file)
        columns = dict(zip(map(str, header), map(list, zip(*rows))))
    elif ending == "csv":
        columns = pl.read_csv(file).to_dict(as_series=False)
    elif ending == "parquet":
        columns = pyarrow.parquet.read_table(file).to_pydict()
    else:
        opened = pyarrow.ipc.open_file if ending == "arrow" else pyarrow.ipc.open_stream
        columns = opened(file.read_bytes()).read_all().to_pydict()
    n = len(columns["k"])
    # Plain Monte Carlo counts whole blocks.
    assert n == (16_384 if method == "monte-carlo" else 3000)
    drawn = standfast.draws(PLANE, n, seed=5).to_dict()
    assert list(columns) == ["k", "mu", "weight", "mode"]
    np.testing.assert_array_equal(np.array(columns["k"]), drawn["k"])
    np.testing.assert_array_equal(np.array(columns["mu"]), drawn["mu"])
    assert columns["mode"] == [standfast.Mode(code).symbol for code in drawn["mode"]]
    assert set(columns["weight"]) == {1 / n}


def test_figures_are_those_of_the_program(program: list[str], tmp_path: Path) -> None:
    case = tmp_path / "plane.toml"
    case.write_text(
        "[point]\ngamma = 0.8\nk_prime = 0.9167\n[random]\nk = { gumbel = { mean = 0.45, sd = 0.1 } }\n"
        "mu = { normal = { mean = 0.6, sd = 0.1 }, lower = 0.0 }\n"
    )
    over = "gamma=0.7..0.9:3"
    found = standfast.probability(case, over=over)
    subprocess.run([*program, "probability", case, "--over", over, "-o", tmp_path / "out"], capture_output=True, check=True)
    suffixes = {"Draws": "draws", "Probabilities": "modes", "What matters": "matters", "Fragility": "fragility"}
    assert [figure.title for figure in found.figures] == list(suffixes)
    for figure in found.figures:
        assert isinstance(figure, standfast.Figure) and figure._repr_svg_() == figure.svg
        assert figure.svg == (tmp_path / f"out/plane-{suffixes[figure.title]}.svg").read_text(encoding="utf-8")
    # A notebook shows the probabilities; a pickle has all of them.
    assert found._repr_svg_() == found.figures[1].svg
    assert pickle.loads(pickle.dumps(found)).figures == found.figures
    assert found["figures"] == [] and len(repr(found.figures)) < 300


def test_a_case_in_time_has_figures_of_overturning() -> None:
    case = {
        "body": {"width": "0.6 m", "height": "2 m", "density": "2.6 t/m3", "friction": 0.6},
        "motion": {"t_max": "10 s", "base": {"horizontal": {"shape": "sine", "peak": "4 m/s2", "period": "0.8 s", "duration": "1.6 s"}}},
        "random": {"width": {"uniform": {"from": "0.5 m", "to": "0.7 m"}}},
    }
    found = standfast.probability(case, over="pga=0.3 g..0.9 g:3", samples=3 * 20 * 1024)
    assert found.overturning is not None and found.overturning.bodies == 20 and len(found.overturning.points) == 3
    assert "Overturning" in [figure.title for figure in found.figures]


def test_draws_are_the_same_for_a_seed_and_begin_with_the_same() -> None:
    ten, twenty, other = standfast.draws(PLANE, 10, 4), standfast.draws(PLANE, 20, seed=4), standfast.draws(PLANE, 10, 5)
    assert ten.k.to_pylist() == twenty.k.to_pylist()[:10] != other.k.to_pylist()
    assert pl.DataFrame(ten).shape == (10, 5) and pickle.loads(pickle.dumps(ten))["mode"].to_pylist() == ten["mode"].to_pylist()


def test_draws_of_several_situations_ask_which() -> None:
    case = {
        "body": {"width": 1, "height": 2, "mass": 4800, "friction": 0.5},
        "load": [{"name": "push", "force": "20 kN/m", "elevation": 1}, {"name": "pull", "force": "30 kN/m", "elevation": 1, "direction": "right"}],
        "random": {"friction": {"uniform": {"from": 0.3, "to": 0.7}}},
    }
    with pytest.raises(ValueError, match="several sets of loads act one by one; the case has"):
        standfast.draws(case, 5)
    answers = standfast.probability(case)
    names = [answers.situation, *(other.situation for other in answers.others)]
    assert len(names) == 2
    for name in names:
        assert len(standfast.draws(case, 5, situation=name)) == 5
    with pytest.raises(ValueError, match='no situation is called "tug"'):
        standfast.draws(case, 5, situation="tug")


@pytest.mark.parametrize(
    ("options", "error", "said"),
    [
        ({"method": "form2"}, ValueError, "no method is called `form2`; expected one of integrate, sobol, importance, monte-carlo, form"),
        ({"method": 1}, TypeError, "method is 1; expected the name of a method"),
        ({"precision": 0}, ValueError, "precision is 0; expected a share, above zero and below 1"),
        ({"floor": 1}, ValueError, "floor is 1; expected a share"),
        ({"seed": -1}, ValueError, "seed is -1; expected a whole number from 0"),
        ({"seed": 1.5}, ValueError, "seed is 1.5; expected a whole number from 0"),
        ({"samples": 0}, ValueError, "samples is 0; expected a whole number from 1"),
        ({"over": "width"}, ValueError, "over is \"width\": expected NAME=FROM..TO:COUNT"),
        ({"over": ("mu", 0, 1)}, TypeError, "over is .*; expected a text such as"),
        ({"over": "mu=0.5..0.4:3"}, ValueError, "`mu`: it is random itself"),
        ({"over": "gamma=2..1:3"}, ValueError, "it does not rise from 2 to 1"),
        ({"rotations": "follow"}, ValueError, "rotations is 'follow'; expected 'count' or 'simulate'"),
        ({"years": -3}, ValueError, "years is -3; expected a number above zero"),
        ({"threads": 0}, ValueError, "threads is 0"),
    ],
)
def test_wrong_options_are_refused(options: dict[str, Any], error: type[Exception], said: str) -> None:
    with pytest.raises(error, match=said):
        standfast.probability(PLANE, **options)


def test_wrong_cases_are_refused() -> None:
    with pytest.raises(ValueError, match=r"has no \[random\] table"):
        standfast.probability(ROOT / "examples/goda-2000.toml")
    with pytest.raises(ValueError, match="of `mu` lacks"):
        standfast.draws({"point": {**PLANE["point"], "k": 0.4}, "random": {"mu": {"normal": {"mean": 0.4}}}}, 5)
    with pytest.raises(ValueError, match="n is 0; expected a whole number from 1"):
        standfast.draws(PLANE, 0)
    with pytest.raises(TypeError, match="situation is 3"):
        standfast.draws(PLANE, 5, situation=3)  # type: ignore[arg-type]


def test_openturns_finds_the_same() -> None:
    """P(k > μ) of two normal numbers is Φ(−(0.6 − 0.35)/√(2·0.05²))."""
    place = importlib.util.spec_from_file_location("reliability", ROOT / "python/examples/reliability.py")
    assert place and place.loader
    example = importlib.util.module_from_spec(place)
    place.loader.exec_module(example)
    ours, theirs = example.main()
    beta = 0.25 / math.sqrt(2 * 0.05**2)
    exact = math.erfc(beta / math.sqrt(2)) / 2
    assert ours.modes["SL"].probability == pytest.approx(exact, rel=1e-9) and ours.beta == pytest.approx(beta, rel=1e-8)
    # What OpenTURNS searches, it finds to its tolerance.
    assert theirs.getEventProbability() == pytest.approx(exact, rel=1e-4)


STATUE = {
    "body": {"width": "0.6 m", "height": "2 m", "density": "2.6 t/m3", "friction": 0.8},
    "random": {"body.height": {"normal": {"cov": 0.03}}},
}


def pulses() -> list[np.ndarray[Any, Any]]:
    """Two records in g: a sine, and a longer one that dies away."""
    t = np.arange(200) * 0.01
    return [np.sin(2 * np.pi * t[:101]), np.exp(-t) * np.sin(4 * np.pi * t)]


def test_records_that_are_arrays_are_those_of_files(tmp_path: Path) -> None:
    names = []
    for place, pulse in enumerate(pulses()):
        names.append(f"{place}.csv")
        rows = "\n".join(f"{i * 0.01!r},{value!r}" for i, value in enumerate((pulse * 9.81).tolist()))
        (tmp_path / names[-1]).write_text(f"time_s,a_m_s2\n{rows}\n")
    random = "".join(f"{name} = {{ normal = {{ cov = 0.03 }} }}\n" for name in STATUE["random"])
    body = "\n".join(f"{key} = {json.dumps(value)}" for key, value in STATUE["body"].items())
    text = f'[body]\n{body}\n[motion.base.horizontal]\nshape = "file"\nfile = "0.csv"\n[random]\nrecords = {names}\n"body.height" = {{ normal = {{ cov = 0.03 }} }}\n'
    path = tmp_path / "statue.toml"
    path.write_text(text.replace("'", '"'))
    asked: Any = {"over": "pga=0.3 g..0.9 g:4", "samples": 1000}
    expected = standfast.probability(path, **asked).overturning
    found = standfast.probability(STATUE, records=pulses(), dt=0.01, unit="g", **asked).overturning
    assert expected is not None and found is not None and found.records == ["record 1", "record 2"]
    assert found["points"] == expected["points"] and 0 < found.points[-1].overturned.probability
    series = [pd.Series(pulse, index=np.arange(len(pulse)) * 0.01) for pulse in pulses()]
    assert standfast.probability(STATUE, records=series, unit="g", **asked).overturning["points"] == expected["points"]  # type: ignore[index]


def test_a_vertical_record_goes_with_its_horizontal_one() -> None:
    """Bodies of next to no scatter overturn under the pair as `simulate` says, both directions scaled by one factor."""
    certain = {**STATUE, "random": {"body.height": {"normal": {"cov": 1e-9}}}}
    sine, other = pulses()
    up = 0.6 * np.cos(np.linspace(0, 9, len(other)))
    records = [{"horizontal": sine, "dt": 0.012}, {"horizontal": other, "vertical": up, "dt": 0.01}]
    peaks = [0.35, 0.55, 0.75, 0.95]
    found = standfast.probability(certain, records=records, unit="g", over="pga=0.35 g..0.95 g:4", samples=1000)
    assert repr(found).startswith("<Probability the case: overturns ") and "g" not in repr(found).split("overturns")[1].split("m/s")[0]
    fell = []
    for peak in peaks:
        alone = [
            standfast.simulate(
                {"body": STATUE["body"]}, base={name: peak / max(abs(record["horizontal"])) * values for name, values in record.items() if name != "dt"},
                dt=record["dt"], unit="g", strength=False,
            ).overturned
            for record in records
        ]  # fmt: skip
        fell.append(np.mean(alone))
    assert found.overturning is not None
    assert [point.overturned.probability for point in found.overturning.points] == pytest.approx(fell)
    assert 0 < sum(fell) < 4


@pytest.mark.parametrize(
    ("options", "error", "said"),
    [
        ({"records": [[0, 1]], "dt": 0.1, "unit": "g"}, TypeError, "records are scaled to peaks; expected over='pga=0.2 g..1 g:9' beside them"),
        ({"dt": 0.1}, TypeError, "dt is that of records, which are not given"),
        ({"records": [0, 1], "over": "pga=0.2 g..1 g:3"}, TypeError, "expected a list of records, each an array or a dict"),
        ({"records": [[0, 1]], "dt": 0.1, "over": "pga=0.2 g..1 g:3"}, ValueError, "unit is missing"),
        ({"records": [{"vertical": [0, 1]}], "dt": 0.1, "unit": "g", "over": "pga=0.2 g..1 g:3"}, ValueError, r"records\[0\] has nothing 'horizontal'"),
        ({"records": [{"horizontal": [0, 1], "vertical": [0]}], "dt": 0.1, "unit": "g", "over": "pga=0.2 g..1 g:3"}, ValueError, r"records\[0\]"),
    ],
)
def test_records_that_are_none_are_refused(options: dict[str, Any], error: type[Exception], said: str) -> None:
    with pytest.raises(error, match=said):
        standfast.probability(STATUE, **options)


def test_values_along_a_number_are_a_text_or_one_by_one() -> None:
    """Whatever holds the values, the answer is that of the text, and each value that of a file with it."""
    how: dict[str, Any] = {"method": "sobol", "samples": 4096}
    text = standfast.probability(GODA, over="width=18 m..22 m:3", **how).fragility
    values = [18.0, 20.0, 22.0]
    arrays: list[Any] = [values, tuple(values), np.array(values), pd.Series(values, index=list("abc")), pl.Series(values), ["18 m", "2000 cm", "22 m"]]
    for given in [*arrays, "18 m..22 m:3"]:
        assert standfast.probability(GODA, over={"width": given}, **how).fragility == text, given
    uneven = standfast.probability(GODA, over="width=18 m, 22 m, 23 m", **how).fragility
    assert uneven is not None and text is not None
    assert [point.value for point in uneven.points] == [18, 22, 23]
    assert uneven.points[1].not_rest.probability == text.points[2].not_rest.probability
    column = ROOT / "examples/probability/column-records.toml"
    with pytest.raises(ValueError, match=r'over\["pga"\] has no unit; expected \{"pga \[g\]": values\}'):
        standfast.probability(column, over={"pga": [2.0, 3.5]}, samples=4096)
    in_gravity = standfast.probability(column, over={"pga [g]": [0.25, 0.5]}, samples=4096).overturning
    assert in_gravity is not None and [point.peak for point in in_gravity.points] == pytest.approx([0.25 * 9.81, 0.5 * 9.81], rel=1e-12)
    peaks = standfast.probability(column, over={"pga [m/s2]": [2.0, 3.5]}, samples=4096).overturning
    assert peaks is not None and [point.peak for point in peaks.points] == [2.0, 3.5]


@pytest.mark.parametrize(
    ("over", "error", "said"),
    [
        ({"width": [20, 18]}, ValueError, "`width`: it does not rise from 20.0 to 18.0; expected rising values"),
        ({"width": [18]}, ValueError, "expected NAME=FROM..TO:COUNT or NAME=VALUE,VALUE with two values or more"),
        ({"width": (18, 22, 3)}, TypeError, r"over\['width'\] is \(18, 22, 3\), which may be .*; expected the list \[18, 22, 3\], or the text '18..22:3'"),
        ({"width": 18}, TypeError, r"over\['width'\] is 18, an int; expected a text such as '12 m..20 m:9', or a list of values"),
        ({"width": [18, 22], "mu": [1, 2]}, TypeError, "or a dict of one name with its values"),
        ({"width": [18, np.nan]}, ValueError, "width"),
        ({"wdith": [18, 20]}, ValueError, "did you mean `width`"),
        ({"width": ["18 m", "20 kg"]}, ValueError, "kg"),
    ],
)
def test_values_that_are_no_range_are_refused(over: Any, error: type[Exception], said: str) -> None:
    with pytest.raises(error, match=said):
        standfast.probability(GODA, over=over, samples=4096, method="sobol")


PAIR = {
    "gravity": 10,
    "body": {"friction": 0.6},
    "part": [
        {"name": "lower", "left": 0, "width": 4, "bottom": 0, "height": 1, "density": 2000},
        {"name": "upper", "left": 1, "width": 2, "bottom": 1, "height": 1, "density": 3000},
    ],
    "joint": [{"name": "bed", "elevation": 1, "friction": 0.5}],
    "load": [{"name": "push", "force": "20 kN/m", "elevation": 2}],
    "random": {"joint.bed.friction": {"uniform": {"from": 0.2, "to": 0.6}}},
}


def test_joints_are_told_by_which_leaves_rest_first():
    # The upper block, 60 kN/m, slides under 20 kN/m where its friction is below 1/3; the base never does.
    found = standfast.probability(PAIR)
    assert found.modes["joint 2 slides"].probability == pytest.approx(1 / 3, rel=1e-12)
    assert found.modes["joint 1 slides"].probability == 0
    assert found.not_unique is None
    drawn = standfast.draws(PAIR, 400)
    friction, modes = drawn["joint.bed.friction"].to_numpy(), np.array(drawn["mode"].to_pylist())
    assert set(modes) == {"RE", "joint 2 slides"}
    assert ((friction < 1 / 3) == (modes == "joint 2 slides")).all()


def test_what_has_stood_and_design_values_are_in_the_answer() -> None:
    """Two numbers by hand: friction for a life, a push in each event, four and a half a year."""
    plane = {
        "point": {"gamma": 0.5, "k_prime": 0},
        "random": {
            "years": 20, "survived": 30, "events_per_year": 4.5, "target_beta": 3.8,
            "mu": {"discrete": {"values": [0.4, 0.6], "probabilities": [0.5, 0.5]}},
            "k": {"exponential": {"scale": 0.05, "location": 0.2}, "every": "event"},
        },
    }  # fmt: skip
    found = standfast.probability(plane)

    def survives(years: float) -> float:
        return sum(0.5 * math.exp(-4.5 * years * math.exp(-(mu - 0.2) / 0.05)) for mu in (0.4, 0.6))

    assert found.life is not None and found.life.stood is not None and found.design_values is not None
    assert found.life.events_per_year == 4.5 and found.life.stood.years == 30
    assert found.life.not_rest.probability == pytest.approx(1 - survives(20), rel=1e-9)
    assert found.life.stood.not_rest.probability == pytest.approx(1 - survives(50) / survives(30), rel=1e-9)
    assert found.design_values.beta == 3.8
    assert [number.name for number in found.design_values.numbers] == ["mu", "k"]
    push = found.design_values.numbers[1]
    assert push.fractile == 0.95 and push.characteristic == pytest.approx(0.2 - 0.05 * math.log(0.05), rel=1e-9)
    assert push.factor == pytest.approx(push.value / push.characteristic)
