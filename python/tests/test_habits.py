"""Everyday habits of notebooks: each works, or says what to do; none is wrong without a word."""

from __future__ import annotations

import copy
import pickle
import re
import subprocess
import sys
import warnings
from pathlib import Path
from typing import Any

import dask.dataframe as dd
import duckdb
import numpy as np
import pandas as pd
import pint
import polars as pl
import pytest
import standfast
import xarray as xr
from standfast import Mode, StandfastWarning

ROOT = Path(__file__).parents[2]
GODA = ROOT / "examples/goda-2000.toml"
#: Impulsive breaking is possible in every storm of that case.
POINTS = pd.DataFrame({"gamma": [1.0, 1, 3], "k_prime": [0.4, 0.4, 0.8], "k": [0.5, 0.7, 0.5], "mu": [0.6, 0.6, 0.05]}, index=list("abc"))
SYMBOLS = ["RE", "SL", "SRO-"]


def quiet(call: Any, *given: Any, **options: Any) -> Any:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", StandfastWarning)
        return call(*given, **options)


def test_codes_compare_with_words_of_every_kind() -> None:
    codes = POINTS.assign(mode=standfast.classify)["mode"]
    words = pd.Series(SYMBOLS, index=POINTS.index)
    for other in (SYMBOLS, tuple(SYMBOLS), np.array(SYMBOLS), words, words.astype(object), words.astype("category"), standfast.classify(POINTS, names=True)):
        assert (codes == other).tolist() == [True] * 3 and (codes != other).tolist() == [False] * 3, type(other)
    for other in (words, words.astype(object), words.astype("category")):
        assert (other == codes).tolist() == [True] * 3 and (other != codes).tolist() == [False] * 3, other.dtype
    assert (codes == words.where(words != "SL")).isna().tolist() == [False, True, False]
    assert (codes == [0, 1, 2]).tolist() == [True, True, False]
    with pytest.raises(ValueError, match="'XX' is not a mode"):
        _ = codes == ["RE", "XX", "SL"]
    # Numbers are numbers as before.
    assert (pd.Series([1.5, 2, None], index=POINTS.index, dtype="Float64") + codes).tolist()[:2] == [1.5, 3.0]


def test_codes_are_mapped_by_symbols() -> None:
    codes = standfast.classify(POINTS)
    for said in ({"RE": "rest", "SL": "slides"}, {0: "rest", 1: "slides"}, {Mode.REST: "rest", Mode.SLIDE_LEFT: "slides"}):
        for mapper in (said, pd.Series(list(said.values()), index=list(said))):
            assert codes.map(mapper).tolist()[:2] == ["rest", "slides"] and pd.isna(codes.map(mapper).iloc[2])
    with pytest.raises(ValueError, match="'SLIDES' is not a mode"):
        codes.map({"SLIDES": 1})


@pytest.mark.parametrize(
    ("first", "said"),
    [
        (POINTS.iloc[0], r"unpack a row: standfast\.classify\(\*\*row\)"),
        (POINTS.iloc[0].to_dict(), r"unpack a dict: standfast\.classify\(\*\*columns\)"),
        (POINTS.to_numpy(), r"unpack the columns of an array: standfast\.classify\(\*points\.T\)"),
        (POINTS.to_dict("records"), r"make a table of records: standfast\.classify\(pandas\.DataFrame\(records\)\)"),
        (POINTS.to_records(index=False), r"unpack the fields: standfast\.classify\(\*\*\{name: points\[name\] for name in points\.dtype\.names\}\)"),
    ],
    ids=["row", "dict", "array", "records", "fields"],
)
def test_points_that_come_as_a_whole_are_unpacked_as_is_said(first: Any, said: str) -> None:
    with pytest.raises(TypeError, match=said) as refused:
        standfast.classify(first)
    advice = str(refused.value).split(": ", 1)[1]
    found = eval(advice, {"standfast": standfast, "pandas": pd, "row": first, "columns": first, "points": first, "records": first})
    assert standfast.symbols(found) == "RE" if np.ndim(found) == 0 else standfast.symbols(found).tolist() == SYMBOLS


def test_a_column_is_named_not_given() -> None:
    with pytest.raises(TypeError, match=r"map gives .* for mu; expected the name of a column, or a number"):
        standfast.classify(POINTS, map={"mu": POINTS.mu})  # type: ignore[dict-item]


def test_items_of_arrow_are_ordered() -> None:
    drawn = standfast.draws({"point": {"gamma": 1, "k_prime": 0.4, "k": 0.5}, "random": {"mu": {"uniform": {"from": 0.4, "to": 0.6}}}}, 50)
    mu = drawn.mu.to_numpy()
    for found, expected in ((drawn.mu < 0.5, mu < 0.5), (drawn.mu >= 0.5, mu >= 0.5), (drawn.mu > drawn.k_eff, mu > 0.5), (drawn.mu <= mu, mu <= mu)):
        assert (found == expected).all()
    assert ((drawn.mu < 0.5) == (drawn["mode"] == "SL")).all()


def test_tables_of_cases_keep_their_units() -> None:
    table = quiet(standfast.assess_table, GODA, duckdb.sql("select 0.5 friction"), columns=["P", "mode"])
    assert table.P.metadata == {"unit": "N/m", "description": "horizontal force, towards the heel"}
    for again in (pickle.loads(pickle.dumps(table)), copy.deepcopy(table), table[:1], table[["P"]]):
        assert again.P.metadata == table.P.metadata
    assert table.P[np.array([0])].metadata == pickle.loads(pickle.dumps(table.P)).metadata == table.P.metadata
    assert pickle.loads(pickle.dumps(table)).to_pylist() == table.to_pylist()


def test_a_text_without_unit_has_no_results_if_that_is_asked() -> None:
    widths = ["15 m", "15", 16.0, "wide"]
    tables: list[Any] = [pd.DataFrame({"body.width": widths}), {"body.width": widths}, {"body.width": np.array(widths, dtype=object)}]
    for table in tables:
        with pytest.raises(TypeError, match="body.width is '15' at index 1, a text without a unit; expected a number, or a text with its unit"):
            standfast.assess_table(GODA, table, columns=["mode"])
    tables.append(pl.DataFrame({"body.width": ["15 m", "15", "16 m", "wide"]}))
    for table in tables:
        found = quiet(standfast.assess_table, GODA, table, columns=["mode", "P"], on_error="null")
        problems = [None if not isinstance(words, str) or not words else words for words in found["problem"]]
        assert [problem is None for problem in problems] == [True, False, True, False], type(table)
        assert problems[1] == 'column body.width: "15": it is a text without a unit; expected a number, or a length in mm, cm, m, ft or in'
        alone = quiet(standfast.assess_table, GODA, {"body.width": [15, 16]}, columns=["P"])["P"].tolist()
        forces = [force for force, problem in zip(found["P"], problems) if problem is None]
        assert forces == alone
    # Numbers beside texts are in the unit of the name.
    for table in (pd.DataFrame({"body.width [cm]": ["15 m", 1600.0]}), {"body.width [cm]": ["15 m", 1600]}):
        assert quiet(standfast.assess_table, GODA, table, columns=["P"])["P"].tolist() == alone


def test_a_search_is_warned_once() -> None:
    def search() -> None:
        for friction in (0.4, 0.5, 0.6):
            standfast.assess_table(GODA, {"friction": friction}, columns=["SF_sliding"])

    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("default")
        search()
    assert len(told) == 1 and isinstance(told[0].message, StandfastWarning) and told[0].message.name == "impulsive-breaking"
    assert str(told[0].message).startswith("at index 0: impulsive breaking is possible: berm width") and told[0].filename == __file__
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        search()
    assert len(told) == 3
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("default")
        search()
        for friction in (0.4, 0.5):
            standfast.assess_table(GODA, {"friction": friction}, columns=["mode"])
            standfast.assess_table(GODA, {"body.width": 15 + friction}, columns=["mode"])
    # From another line, and of what varies something else.
    assert len(told) == 3
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(StandfastWarning, match="impulsive breaking is possible") as raised:
            search()
    again = pickle.loads(pickle.dumps(raised.value))
    assert isinstance(again, StandfastWarning) and str(again) == str(raised.value) and again.name == "impulsive-breaking"
    assert type(raised.value).__name__ == "StandfastWarning"


def test_the_advice_for_tables_of_dask_works_as_it_stands() -> None:
    # Of numbers that Dask makes up, 1 m of water, no case is made.
    frame = dd.from_pandas(pd.DataFrame({"water_level": [7.0, 7.1, 7.2], "by": ["a", "b", "c"]}), npartitions=2)
    with pytest.raises(TypeError, match=r"meta=") as refused:
        standfast.assess_table(GODA, frame)  # type: ignore[call-overload]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        call = str(refused.value).split("Call ")[1]
        found = eval(call, {"standfast": standfast, "frame": frame, "case": GODA}).compute()
    whole = quiet(standfast.assess_table, GODA, frame.compute())
    assert found.index.tolist() == whole.index.tolist() and found["SF_sliding"].tolist() == whole["SF_sliding"].tolist()
    assert found["mode"].tolist() == whole["mode"].tolist() and found.columns.tolist() == whole.columns.tolist()
    with pytest.raises(TypeError, match=re.escape("Call standfast.varied(case, frame.columns)")):
        standfast.varied(GODA, frame)
    assert standfast.varied(GODA, frame.columns).keys == {"water_level": "wave.base_depth"}


def test_cases_come_as_they_are_written() -> None:
    text = GODA.read_text(encoding="utf-8")
    with pytest.raises(ValueError, match=r"a text; expected the path of a case file, or a dict with the same keys: tomllib\.loads\(text\)"):
        standfast.assess(text)
    if sys.version_info >= (3, 11):
        import tomllib

        assert standfast.assess(tomllib.loads(text)).to_dict() == standfast.assess(GODA).to_dict()
    body = {"width": np.array(1.0), "height": np.float32(2), "density": np.int64(2400), "friction": 0.7}
    assert standfast.assess({"body": body, "load": [{"force": 1, "elevation": 1}]}).mode == "RE"


def test_ratios_of_pint_vary_a_case() -> None:
    percent = pint.UnitRegistry().Quantity([40, 60], "percent")
    assert quiet(standfast.assess_table, GODA, {"friction": percent}, columns=["mode"])["mode"].tolist() == ["SL", "RE"]


@pytest.mark.parametrize(
    ("options", "error", "said"),
    [
        ({"omega": "a"}, TypeError, "omega is 'a', a str; expected a number"),
        ({"omega": [0.1]}, TypeError, "Diagram takes one number for each of omega"),
        ({"omega": -1}, ValueError, "ω of the base is -1; expected a number from 0"),
        ({"law": "ec7", "share": "x"}, TypeError, "share is 'x', a str"),
    ],
    ids=str,
)
def test_diagrams_refuse_what_is_no_base(options: dict[str, Any], error: type[Exception], said: str) -> None:
    with pytest.raises(error, match=said):
        standfast.Diagram(1, 0.4, **options)


def test_what_libraries_compare_by_themselves_is_as_the_guide_says() -> None:
    """Codes and words of numpy are plain, and so are words of pandas: the guide says what to write."""
    codes, words = standfast.classify(1, 0.4, [0.5, 0.7], 0.6), standfast.classify(1, 0.4, [0.5, 0.7], 0.6, names=True)
    assert (codes == Mode.SLIDE_LEFT).tolist() == (words == "SL").tolist() == (words == Mode.SLIDE_LEFT.symbol).tolist() == [False, True]
    assert np.isin(codes, [Mode.SLIDE_LEFT]).tolist() == [False, True]
    column = standfast.classify(POINTS, names=True)
    assert (column == Mode.SLIDE_LEFT.symbol).tolist() == [False, True, False]
    mode = standfast.assess(GODA).mode
    assert mode in ("RE", "SL") and mode in {Mode.REST, Mode.SLIDE_LEFT} and {Mode.REST: 1}[mode] == 1
    array = xr.apply_ufunc(standfast.classify, 1, 0.4, xr.DataArray([0.5, 0.7], dims="x"), 0.6)
    assert (array == Mode.SLIDE_LEFT).values.tolist() == [False, True]


def test_results_go_into_tables() -> None:
    blows = standfast.assess(ROOT / "examples/block-two-loads.toml")
    assert pd.DataFrame(situation.to_dict() for situation in blows.situations)["mode"].tolist() == ["RO", "RO'", "SL+"]
    motion = standfast.simulate(ROOT / "examples/motion/block-base-pulse.toml")
    events = pd.DataFrame(event.to_dict() for event in motion.events)
    assert events["state"].tolist() == [event.state.symbol for event in motion.events]
    chances = pd.DataFrame(chance.to_dict() for chance in standfast.probability(ROOT / "examples/goda-2000-random.toml").modes.values())
    assert chances.set_index("mode").probability.sum() == pytest.approx(1)


def test_answers_travel_to_processes() -> None:
    program = (
        "import multiprocessing, standfast\n"
        "if __name__ == '__main__':\n"
        "    with multiprocessing.get_context('spawn').Pool(2) as pool:\n"
        f"        files = [{str(ROOT / 'examples/motion/block-base-pulse.toml')!r}] * 2\n"
        "        print([answer.end for answer in pool.map(standfast.simulate, files)])\n"
        f"        print([len(answer.modes) for answer in pool.map(standfast.probability, [{str(ROOT / 'examples/goda-2000-random.toml')!r}])])\n"
    )
    found = subprocess.run([sys.executable, "-c", program], capture_output=True, encoding="utf-8", check=True)
    assert found.stdout.startswith("['overturned', 'overturned']")
