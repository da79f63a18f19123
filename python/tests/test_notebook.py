"""Habits of notebooks: what is silent, flooded or loses its label elsewhere."""

from __future__ import annotations

import copy
import inspect
import pickle
import re
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import polars as pl
import pyarrow as pa
import pytest
import standfast
from standfast import Mode, StandfastWarning, assess_table

ROOT = Path(__file__).parents[2]
GODA = ROOT / "examples/goda-2000.toml"
TWO = ROOT / "examples/block-two-loads.toml"
BLOCK: dict[str, Any] = {
    "body": {"width": 1, "height": 2, "mass": 4800, "friction": 0.7},
    "load": [{"name": "push", "force": "20 kN/m", "elevation": "1.5 m"}],
}
#: The same with more friction than bases have.
ROUGH = {**BLOCK, "body": {**BLOCK["body"], "friction": 1.5}}
POINTS = {"gamma": [1.0, 1.0, 3.0], "k_prime": [0.4, 0.4, 0.8], "k": [0.5, 0.7, 0.1], "mu": [0.6, 0.6, 0.05]}


def warned(work: Any) -> tuple[Any, list[StandfastWarning]]:
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        found = work()
    assert all(Path(one.filename).name == Path(__file__).name for one in caught), "the line of the caller"
    return found, [one.message for one in caught if isinstance(one.message, StandfastWarning)]


def test_warnings_show() -> None:
    rough = standfast.assess(ROUGH)
    assert [warning.name for warning in rough.warnings] == ["high-friction"] and repr(rough).endswith("; warnings: high-friction>")
    assert "warnings" not in repr(standfast.assess(BLOCK))
    friction = [0.7, 1.5, 0.6, 1.1]
    for table, place in (
        ({"friction": friction}, "index 1"),
        (pd.DataFrame({"friction": friction}, index=list("abcd")), "row 1, labelled 'b'"),
        (pd.DataFrame({"friction": friction}), "index 1"),
        (pl.DataFrame({"friction": friction}), "index 1"),
        (pa.table({"friction": friction}), "index 1"),
    ):
        found, told = warned(lambda table=table: assess_table(BLOCK, table, columns=["mode", "warnings"]))
        assert [warning.name for warning in told] == ["high-friction"]
        assert re.match(f"in 2 rows, the first at {place}: .*1.5", str(told[0])), told
        column = found["warnings"]
        names = column.to_pylist() if isinstance(column, pa.ChunkedArray) else list(column)
        # What pandas calls missing is not equal to itself, and words of arrays are empty.
        assert [name if isinstance(name, str) and name else None for name in names] == [None, "high-friction"] * 2
        # They are no less told where the column is not asked for.
        assert len(warned(lambda table=table: assess_table(BLOCK, table, columns=["mode"]))[1]) == 1
    sweep = {"friction": [[0.7], [1.5]], "width": [1.0, 2.0]}
    assert str(warned(lambda: assess_table(BLOCK, sweep))[1][0]).startswith("in 2 rows, the first at index (1, 0): ")
    assert not warned(lambda: assess_table(BLOCK, {"friction": [0.5, 0.7]}))[1]


def test_one_mapping() -> None:
    goda = standfast.assess(GODA)
    assert "load_factor" in goda and goda["load_factor"] == goda.load_factor == goda.get("load_factor") == dict(goda)["load_factor"]
    assert len(list(goda)) == len(goda) == len(set(goda)) and "situations" in goda and "foo" not in goda
    assert goda["mode"] == "RE" and goda.to_dict().keys() < set(goda) and "load_factor" not in goda.to_dict()
    with pytest.raises(KeyError, match="this assessment has no 'load_factr'; did you mean 'load_factor'"):
        goda["load_factr"]
    with pytest.raises(AttributeError, match="did you mean 'load_factor'"):
        goda.load_factr  # type: ignore[attr-defined]
    blows = standfast.assess(TWO)
    assert "load_factor" not in blows and not hasattr(blows, "load_factor")
    with pytest.raises(KeyError, match="the case has 3 situations; see .*governing.load_factor"):
        blows["load_factor"]


def test_answers_are_frozen() -> None:
    goda = standfast.assess(GODA)
    design = standfast.design(BLOCK, vary="width", target="rest")
    for answer in (goda, goda.situations[0], goda.wave, standfast.explain(1, 0.4, 0.5, 0.6), design):
        assert answer is not None
        for change in (lambda a: setattr(a, "foo", 3), lambda a: setattr(a, next(iter(a)), 3), lambda a: delattr(a, "_document")):
            with pytest.raises(AttributeError, match="cannot be changed"):
                change(answer)
        for again in (pickle.loads(pickle.dumps(answer)), copy.copy(answer), copy.deepcopy(answer)):
            assert again == answer and type(again) is type(answer)
    goda["situations"][0]["mode"] = "XX"
    goda["wave"]["lambda"][0] = 9
    assert goda.wave is not None
    goda.wave.lambda_[0] = 9
    assert goda["situations"][0]["mode"] == "RE" and goda.wave["lambda"] == goda.wave.lambda_ != [9, 9, 9] and goda.wave.lambda_[0] != 9


def test_notebooks_are_not_flooded() -> None:
    goda = standfast.assess(GODA)
    assert re.fullmatch(r"\[(<Figure '[^']+': \d+ kB of SVG>(, )?)+\]", repr(goda.figures))
    assert len(repr(goda.situations)) < 200 and "mode='RE'" in repr(goda.situations) and len(repr(goda.wave)) < 200
    relation = standfast.explain(0.8, 0.9167, 0.7281, 0.6).trace[0].relations[0]
    assert repr(relation).startswith("Relation(equation='3.4', statement='μ ≥ k', ")


@pytest.mark.parametrize("kind", [standfast.Onset, standfast.OnsetArrays, standfast.Contact, standfast.ContactArrays,
                                  standfast.LimitStates, standfast.LimitStatesArrays])  # fmt: skip
def test_help_says_what_each_field_is(kind: Any) -> None:
    said = re.findall(r"^    (\w+): .", inspect.getdoc(kind) or "", re.MULTILINE)
    assert tuple(said) == kind._fields


def test_words_of_limit_states_are_those_of_the_library() -> None:
    """One text in two languages: the equations and the formulas of each limit state are the same."""
    source = (ROOT / "crates/standfast/src/initiation/limits.rs").read_text(encoding="utf-8")
    rust = dict((name, words) for words, name in re.findall(r"    /// (.*)\n    pub (\w+): f64,", source))
    python = dict(re.findall(r"^    (\w+): (.*)$", inspect.getdoc(standfast.LimitStates) or "", re.MULTILINE))
    page = (ROOT / "docs/how-to/python.md").read_text(encoding="utf-8")
    assert [name.lower() for name in python] == [name.lower() for name in rust]
    for name, words in python.items():
        ours = rust[name.lower()]
        assert re.findall(r"\d\.\d+", words) == re.findall(r"\d\.\d+", ours), name
        row = next(line for line in page.splitlines() if line.startswith(f"| `{name}`"))
        assert re.findall(r"(?<![\d.])\d\.\d+(?!\d)", row.rsplit("|", 2)[1]) == re.findall(r"\d\.\d+", ours), name


def test_errors_say_the_label() -> None:
    frame = pd.DataFrame({**POINTS, "mu": [0.6, -0.5, 0.05]}, index=[2003, 2011, 2018])
    functions = (standfast.classify, standfast.onset, standfast.limit_states)
    for function in functions:
        with pytest.raises(ValueError, match="^friction μ is -0.5 at row 1, labelled 2011; expected a number from 0 to 1e50$"):
            function(frame)
        with pytest.raises(ValueError, match="^friction μ is -0.5 at row 1, labelled 2011; "):
            function(1, 0.4, frame.k, frame.mu)
        for plain in (frame.reset_index(drop=True), pl.DataFrame({**POINTS, "mu": frame.mu.to_numpy()})):
            with pytest.raises(ValueError, match="^friction μ is -0.5 at index 1; "):
                function(plain)
    storms = pd.DataFrame({"width": [1.0, -1.0]}, index=pd.MultiIndex.from_tuples([("a", 1), ("b", 2)]))
    with pytest.raises(ValueError, match=r"^at row 1, labelled \('b', 2\), column width"):
        assess_table(BLOCK, storms)


def test_modes_compare_with_their_symbols() -> None:
    assert Mode.SLIDE_LEFT == "SL" and Mode.SLIDE_LEFT != "RE" and "SL" == Mode.SLIDE_LEFT == 1 and Mode.SLIDE_LEFT != 0
    assert {1: "x"}[Mode.SLIDE_LEFT] == "x" and standfast.assess(GODA).mode == "RE"
    storms = pd.DataFrame(POINTS)
    storms["mode"] = standfast.classify(storms)
    for made in (storms, storms[storms.k > 0], storms.copy(), pd.concat([storms, storms])[:3], pickle.loads(pickle.dumps(storms)), storms.iloc[::-1][::-1]):
        modes = made["mode"]
        assert (modes == "RE").tolist() == (modes == Mode.REST).tolist() == (modes == 0).tolist() == [True, False, False]
        assert (modes != "RE").tolist() == (~modes.isin(["RE"])).tolist() == [False, True, True] and modes.isin([Mode.ROCK_O, "SL"]).tolist() == [False, True, True]
        assert modes.dtype == "UInt8" and modes.dtype == pd.UInt8Dtype() and modes.tolist() == [0, 1, 1]
        with pytest.raises(ValueError, match="'Rest' is not a mode; expected RE, SL, "):
            modes == "Rest"  # noqa: B015
    assert storms.groupby("mode").k.count().index.tolist() == sorted(set(storms["mode"]))
    assert (standfast.onset(storms[list(POINTS)])["mode"] == "SL").tolist() == (storms["mode"] == "SL").tolist()
    missing = standfast.classify(1, 0.4, pd.Series([0.5, None]), 0.6) == "RE"
    assert missing.tolist() == [True, pd.NA]


def test_words_are_of_one_type_in_polars() -> None:
    points = standfast.classify(pl.DataFrame(POINTS), names=True)
    cases = assess_table(BLOCK, pl.DataFrame({"friction": [0.3, 0.7]}), columns=["mode", "departure", "situation"])
    assert all(isinstance(kind, pl.Enum) for kind in (points.dtype, *cases.schema.values()))
    # A case has one word more, where its ground fails.
    assert points.dtype.categories.is_in(cases["mode"].dtype.categories).all()  # type: ignore[attr-defined]


def test_arrays_of_fields_become_columns() -> None:
    onset = standfast.onset(1, 0.4, np.array([0.5, 0.7]), 0.6, columns=["mode", "x_ddot"])
    frame = pd.DataFrame(onset.to_dict())
    assert list(frame) == ["mode", "x_ddot"] and frame.shape == (2, 2)
    assert "mode" in dir(onset) and "theta_ddot" not in dir(onset) and "to_dict" in dir(onset)


def test_arrow_tables_keep_what_is_said_of_their_columns() -> None:
    capsule = pa.table({"friction": [0.5, 0.7]})
    table = assess_table(BLOCK, type("Frame", (), {"__arrow_c_stream__": capsule.__arrow_c_stream__})(), columns=["margin_sliding", "mode"])
    assert table.margin_sliding.metadata["unit"] == "N/m" and (table.mode == table["mode"]).all() and "mode" in dir(table)
    again = pickle.loads(pickle.dumps(table))
    ours, theirs = (pa.table(one) for one in (table, again))
    assert ours.to_pylist() == theirs.to_pylist() and [field.metadata for field in ours.schema] == [field.metadata for field in theirs.schema]
    assert table.margin_sliding[[1]].metadata == table.margin_sliding.metadata
    with pytest.raises(AttributeError, match="an ArrowTable has no 'foo'; its columns are margin_sliding, mode"):
        table.foo


def test_hints() -> None:
    for name, words in {
        "Hmax": "the case file has no wave.Hmax; if it is meant to vary, put it in",
        "h13": "the case file has no wave.H13",
        "width (cm)": r"if it is meant to vary body.width, call it `body.width \[cm\]`",
        "width (kN)": r"if it is meant to vary body.width, say map=",
        " Gravity ": "if it is meant to vary gravity, say map=",
    }.items():
        _, told = warned(lambda name=name: assess_table(GODA, pd.DataFrame({"friction": [0.6], name: [8.0]}), columns=["mode"]))
        slips = [str(one) for one in told if one.name == "column-like-key"]
        assert len(slips) == 1 and re.match(f"column {re.escape(name)} varies nothing.*{words}", slips[0]), (name, slips)
        # Who names an array means it to vary something.
        with pytest.raises(ValueError, match=words):
            assess_table(GODA, {"friction": 0.6, name: [8.0]})
    with pytest.raises(ValueError, match="the case file has no `wave.Hmax`"):
        assess_table(GODA, {"wave.hmax": [8.0]})
    with pytest.raises(ValueError, match=r"did you mean `wave.lambda\[1\]`"):
        assess_table(GODA, {"wave.lambda": [1.0]})
    with pytest.raises(ValueError, match=r"that can vary are .*gravity, .*wave.lambda\[3\]"):
        assess_table(GODA, {"foo": [8.0]})


def test_numbers_of_a_list_that_is_left_out_vary() -> None:
    """λ2 acts on the pressures that break, λ3 on the uplift: less of either helps."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", StandfastWarning)
        found = assess_table(GODA, {"wave.lambda[2]": [1, 0.5, 1], "wave.lambda[3]": [1, 1, 0.5]}, columns=["P", "U", "SF_sliding"])
    usual = standfast.assess(GODA)
    assert [found[name][0] for name in found] == [usual.P, usual.U, usual.SF_sliding]
    assert found["P"][1] < usual.P and found["P"][2] == usual.P and found["U"][1] == usual.U and found["U"][2] == pytest.approx(usual.U / 2)


@pytest.mark.parametrize("arguments, words", [
    ({"target": "factor=-1"}, '^target is "factor=-1"; expected a finite number above zero; for example factor=1.2$'),
    ({"target": "modes_not=SL"}, r'expected .*; for example modes_not=\["SL"\]$'),
    ({"target": "contact_share=2"}, "expected a share, above zero and 1 at most; for example contact_share=0.667$"),
    ({"target": "rest", "lower": float("nan")}, 'lower is "nan": expected a finite number'),
    ({"target": "rest", "lower": "abc"}, 'lower is "abc": it does not begin with a number'),
    ({"target": "rest", "upper": "3 kN"}, 'upper is "3 kN": the unit `kN` does not fit'),
])  # fmt: skip
def test_sentences_of_designs(arguments: dict[str, Any], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        standfast.design(BLOCK, vary="width", **arguments)


def test_sentences_end() -> None:
    for work in (
        lambda: assess_table(GODA, {"wave.period [min]": [1.0]}),
        lambda: assess_table(GODA, {"friction [m]": [1.0]}),
        lambda: assess_table(GODA, pd.DataFrame()),
        lambda: standfast.classify(pd.DataFrame()),
        lambda: standfast.classify(pl.DataFrame()),
    ):
        with pytest.raises((ValueError, KeyError)) as caught:
            work()
        said = str(caught.value.args[0])
        assert not re.search(r"; *$|are ;|has \.", said), said


@pytest.mark.parametrize("wrong", ["3", True, None, [1, 2], 1j, {"a": 1}], ids=repr)
def test_wrong_kinds_are_refused_in_our_words(wrong: Any) -> None:
    for work in (
        lambda: standfast.Diagram(wrong, 0.4),
        lambda: standfast.Diagram(1, wrong),
        lambda: standfast.Diagram(1, 0.4, window=(wrong, 1)),
        lambda: standfast.explain(1, wrong, 0.5, 0.6),
        lambda: standfast.design(BLOCK, vary="width", target="rest", greatest=wrong) if not isinstance(wrong, bool) else standfast.Diagram(wrong, 1),
        lambda: standfast.assess(BLOCK, all=wrong) if not isinstance(wrong, bool) else standfast.Diagram(wrong, 1),
    ):
        with pytest.raises(TypeError, match="expected|takes one number for each of"):
            work()
    for window in ("21", 3, (1,), (1, 2, 3), {1: 2, 3: 4}):
        with pytest.raises(TypeError, match=r"^window is .*; expected the largest k and the largest μ to show, as \(2, 1\)"):
            standfast.Diagram(1, 0.4, window=window)  # type: ignore[arg-type]


def test_the_number_of_a_design_is_one() -> None:
    goda = standfast.design(GODA, vary="width", target="factor=1.2")
    assert goda.value == goda.found.value == goda["met"][0]["from"]["value"] == 15.46 and goda.found.printed == "15.46 m"
    assert 15.45 < goda.found.boundary < 15.46
    # The results beside it are those of a case with this number.
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", StandfastWarning)
        factor = assess_table(GODA, {"width": goda.found.value}, columns=["SF_sliding"])["SF_sliding"]
    assert goda.found.SF_sliding == factor
