"""ArrowArray and ArrowTable as notebooks use arrays and tables."""

from __future__ import annotations

import copy
import multiprocessing
import pickle
from typing import Any

import duckdb
import numpy as np
import pandas as pd
import polars as pl
import pyarrow as pa
import pytest
import standfast
from standfast import ArrowArray, ArrowTable, Mode, Modes, _standfast

POINTS = "select 1 gamma, -0.5 k_prime, unnest([0.1, 4, 0.6, null, 0.5]) k, unnest([0.3, 3, 0.3, 1, 0.2]) mu"
CODES = [0, 1, 1, None, 1]


@pytest.fixture
def modes() -> ArrowArray:
    found: ArrowArray = standfast.classify(duckdb.sql(POINTS))
    assert found.to_pylist() == CODES
    return found


@pytest.fixture
def names() -> ArrowArray:
    found: ArrowArray = standfast.classify(duckdb.sql(POINTS), names=True)
    return found


@pytest.fixture
def table() -> ArrowTable:
    found: ArrowTable = standfast.onset(duckdb.sql(POINTS))
    return found


def test_items(modes: ArrowArray, names: ArrowArray, table: ArrowTable) -> None:
    assert len(modes) == 5 and modes.null_count == 1 and modes.type == "uint8" and modes.name == "mode"
    assert modes[1] is Mode.SLIDE_LEFT and modes[np.int64(-1)] is Mode.SLIDE_LEFT and modes[3] is None
    assert list(names) == ["RE", "SL", "SL", None, "SL"] and names[-2] is None
    assert table["others"][1] == Modes.ROCK_O and isinstance(table["others"][1], Modes)
    assert table["unique"].to_pylist() == [True, False, True, None, True] and table["unique"][0] is True
    assert isinstance(table["x_ddot"][2], float) and table["x_ddot"].type == "float64"
    for wrong in (5, -6):
        with pytest.raises(IndexError, match=f"index {wrong} of an ArrowArray of 5 items"):
            modes[wrong]
    for strange in ("mode", 1.5, None, [[0]], np.array([0.5])):
        with pytest.raises(TypeError, match="expected a place, a slice, or an array of places or flags"):
            modes[strange]  # type: ignore[call-overload]
    with pytest.raises(TypeError, match="unhashable"):
        hash(modes)


@pytest.mark.parametrize(
    "index", [slice(1, 3), slice(None, None, -1), slice(4, 100), slice(3, 1), [3, 0], np.array([True, False, True, True, False]), []]
)
def test_parts(modes: ArrowArray, names: ArrowArray, table: ArrowTable, index: Any) -> None:
    for array in (modes, names, table["unique"], table["others"], table["theta_ddot"]):
        places = np.array(index, dtype=int) if isinstance(index, list) else index
        expected = np.array(array.to_pylist(), dtype=object)[places].tolist()
        part = array[index]
        assert isinstance(part, ArrowArray) and part.to_pylist() == expected
        assert (part.type, part.name) == (array.type, array.name)
        assert pa.array(part).to_pylist() == [None if x is None else x for x in expected]


def test_everyday_habits_of_numpy(modes: ArrowArray, names: ArrowArray) -> None:
    # As pyarrow and pandas do, codes with nulls are floats with NaN: no code is made up, and none is lost.
    assert np.array_equal(np.asarray(modes), [0, 1, 1, np.nan, 1], equal_nan=True)
    assert np.unique(modes[:3]).tolist() == [0, 1] and np.asarray(modes[:3]).dtype == np.uint8
    assert np.unique(modes, return_counts=True)[1].tolist() == [1, 3, 1]
    assert modes.to_numpy(missing=255).tolist() == [0, 1, 1, 255, 1] and modes.to_numpy(missing=255).dtype == np.uint8
    assert names.to_numpy(missing="none").tolist() == ["RE", "SL", "SL", "none", "SL"]
    assert names.to_numpy().tolist() == ["RE", "SL", "SL", None, "SL"] and names[:3].to_numpy().dtype.kind == "U"
    assert modes.is_null().tolist() == [False, False, False, True, False]
    assert np.asarray(modes[:2], dtype=np.int64).dtype == np.int64 and np.array(modes[:2], copy=True).tolist() == [0, 1]
    with pytest.raises(ValueError, match=r"1 of 5 values are null, for which uint8 has no value; say one by to_numpy\(missing=…\)"):
        np.asarray(modes, dtype=np.uint8)
    for wrong in (256, -1, 0.5, np.nan, "x", None):
        with pytest.raises(ValueError, match="missing is .*; expected a value that uint8 can hold"):
            modes.to_numpy(missing=wrong)
    with pytest.raises(ValueError, match="missing is 3; expected a word"):
        names.to_numpy(missing=3)


def test_comparisons(modes: ArrowArray, names: ArrowArray) -> None:
    slides = [False, True, True, False, True]
    for other in (1, Mode.SLIDE_LEFT, "SL", np.uint8(1), [1, 1, 1, 1, 1], np.ones(5), pd.Series([1] * 5)):
        found = modes == other
        assert isinstance(found, np.ndarray) and found.dtype == np.bool_ and found.tolist() == slides
    assert (modes != "SL").tolist() == [True, False, False, True, False]
    assert (names == "SL").tolist() == slides and (names == Mode.SLIDE_LEFT).tolist() == slides
    assert (names != "SL").tolist() == [True, False, False, True, False]
    assert (modes == modes).tolist() == [True, True, True, False, True] and (names != names).tolist() == [False] * 3 + [True, False]
    assert modes[modes == "SL"].to_pylist() == [1, 1, 1]
    with pytest.raises(ValueError, match="'slide' is not a mode; expected RE, SL, RO"):
        modes == "slide"  # noqa: B015
    with pytest.raises(ValueError, match="broadcast|shape"):
        modes == [1, 2, 3]  # noqa: B015


def test_everyday_habits_of_frames(modes: ArrowArray, names: ArrowArray, table: ArrowTable) -> None:
    frame = pd.DataFrame({"storm": list("abcde")})
    frame["mode"] = modes
    assert frame["mode"].isna().tolist() == [False, False, False, True, False] and frame.loc[2, "mode"] == 1
    frame["name"] = names
    assert frame.groupby("name").size().to_dict() == {"RE": 1, "SL": 3}
    assert pd.Series(modes[:3]).tolist() == [0, 1, 1] and pd.Series(names).tolist()[:2] == ["RE", "SL"]
    assert frame.assign(u=table["unique"][:5])["u"].tolist()[:3] == [True, False, True]
    made = pd.DataFrame(table)
    assert list(made.columns) == table.column_names and made.loc[1, "theta_ddot"] == table["theta_ddot"][1]
    assert pd.DataFrame(table.to_dict())["mode"].isna().sum() == 1
    assert pl.Series(modes).to_list() == CODES and pl.Series(modes).dtype == pl.UInt8
    assert pl.DataFrame({"a": modes})["a"].to_list() == CODES
    assert pl.DataFrame(table).columns == table.column_names and pl.DataFrame(table)["mode"].to_list() == CODES
    assert pa.array(modes).type == pa.uint8() and pa.array(names).type == pa.dictionary(pa.uint8(), pa.string())
    assert pa.table(table).column_names == table.column_names


def test_what_goes_back_in(modes: ArrowArray, table: ArrowTable) -> None:
    assert standfast.symbols(modes).to_pylist() == ["RE", "SL", "SL", None, "SL"]
    answer = table[["mode", "xi"]]
    assert duckdb.sql("select mode, count(*) from answer group by mode order by mode").fetchall() == [(0, 1), (1, 3), (None, 1)]
    assert len(answer) == 5


@pytest.mark.parametrize("again", [lambda x: pickle.loads(pickle.dumps(x)), copy.copy, copy.deepcopy], ids=["pickle", "copy", "deepcopy"])
def test_copies(modes: ArrowArray, names: ArrowArray, table: ArrowTable, again: Any) -> None:
    for array in (modes, names, modes[:0], names[1:2], *(table[name] for name in table.column_names)):
        same = again(array)
        assert isinstance(same, ArrowArray) and same.to_pylist() == array.to_pylist()
        assert pa.array(same).type == pa.array(array).type and same.name == array.name
    same = again(table)
    assert isinstance(same, ArrowTable) and pa.table(same).equals(pa.table(table))


def _counted(array: ArrowArray) -> int:
    return int((array == "SL").sum())


def test_they_travel_to_other_processes(modes: ArrowArray) -> None:
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        assert pool.apply(_counted, (modes,)) == 3


def test_rows_of_tables(table: ArrowTable) -> None:
    assert len(table) == 5 and table.shape == (5, 12)
    assert table[1]["others"] == Modes.ROCK_O and table[-1]["mode"] is Mode.SLIDE_LEFT
    assert [row["mode"] for row in table] == CODES and table.to_pylist()[3]["xi"] is None
    assert table[1:3].to_pylist() == table.to_pylist()[1:3] and len(table[4:2]) == 0 and "xi" in table and "mu" not in table
    assert table[["xi", "mode"]].column_names == ["xi", "mode"]
    with pytest.raises(KeyError, match="the table has no column force; it has mode, unique, others"):
        table["force"]
    with pytest.raises(IndexError, match="row 5 of an ArrowTable of 5 rows"):
        table[5]
    with pytest.raises(ValueError, match="steps of 2; expected steps of 1"):
        table[::2]
    with pytest.raises(TypeError, match="expected the name of a column, a list of names, a row or a slice"):
        table[1.5]  # type: ignore[call-overload]


def test_batches_are_one_table() -> None:
    """A table that was read in several batches."""
    relation = duckdb.sql("select 1.0 gamma, 0.4 k_prime, i / 1e6 k, 0.5 mu from range(300000) t(i)")
    table = standfast.onset(relation, columns=["mode", "x_ddot"])
    whole = standfast.onset(1.0, 0.4, np.arange(300_000) / 1e6, 0.5)
    assert isinstance(table, ArrowTable) and np.array_equal(table["x_ddot"].to_numpy(), whole.x_ddot)
    for start, stop in [(0, 5), (122_870, 122_890), (299_990, 300_000)]:
        assert np.array_equal(table[start:stop]["x_ddot"].to_numpy(), whole.x_ddot[start:stop])
    assert table[250_000]["x_ddot"] == whole.x_ddot[250_000]


def test_what_is_shown(modes: ArrowArray, names: ArrowArray, table: ArrowTable) -> None:
    assert repr(modes) == "<standfast.ArrowArray mode: 5 × uint8, 1 null: [0, 1, 1, null, 1]>"
    assert repr(names) == "<standfast.ArrowArray mode: 5 × dictionary of strings, 1 null: [RE, SL, SL, null, SL]>"
    long = standfast.classify(duckdb.sql("select 1 gamma, 0.4 k_prime, i / 10 k, 0.5 mu from range(40) t(i)"))
    assert repr(long) == "<standfast.ArrowArray mode: 40 × uint8: [0, 0, 0, 0, 0, …, 3, 3, 3, 3, 3]>"
    first, header, *rows = repr(table).splitlines()
    assert first == "<standfast.ArrowTable: 5 rows × 12 columns>" and header.split() == table.column_names
    assert rows[3].split() == ["3"] + ["null"] * 12 and rows[1].split()[:4] == ["1", "1", "False", "4"]
    shown = standfast.onset(duckdb.sql("select 1 gamma, 0.4 k_prime, i / 10 k, 0.5 mu from range(40) t(i)"))
    lines = repr(shown).splitlines()
    assert len(lines) == 13 and lines[7].strip() == "…" and [line.split()[0] for line in lines[8:]] == ["35", "36", "37", "38", "39"]
    page = shown._repr_html_()
    assert page.count("<tr>") == 12 and "<p>40 rows × 12 columns</p>" in page and page.count("<th>") == 13 + 11


def test_columns_are_computed_with() -> None:
    block = {"block": {"b1": 1, "b2": 1, "d": 3, "mu_s": 0.4, "gravity": 1}}
    series = standfast.simulate(block, base=[0.6, 0.6], dt=1).series(0.25)
    theta = series.theta.to_numpy()
    for found, expected in (
        (series.theta * 2, theta * 2), (2 * series.theta, theta * 2), (abs(series.theta), abs(theta)), (-series.theta, -theta),
        (series.theta + series.x, theta + series.x.to_numpy()), (series.theta**2, theta**2), (theta - series.theta, 0 * theta),
    ):  # fmt: skip
        assert isinstance(found, np.ndarray) and found.tolist() == expected.tolist()
    assert (series.theta.max(), series.theta.min(), series.theta.sum(), series.theta.mean()) == (theta.max(), theta.min(), theta.sum(), theta.mean())
    frame = series.to_pandas()
    assert frame.columns.tolist() == series.column_names and frame.theta.tolist() == theta.tolist()
    assert frame.state.tolist() == series.state.to_pylist()


def test_pandas_has_what_is_missing(modes: ArrowArray, names: ArrowArray, table: ArrowTable) -> None:
    codes, words, frame = modes.to_pandas(), names.to_pandas(), table.to_pandas()
    assert codes.dtype == "UInt8" and codes.isna().tolist() == words.isna().tolist() == [False] * 3 + [True, False]
    assert (codes == "SL").tolist() == [False, True, True, pd.NA, True] and isinstance(words.dtype, pd.CategoricalDtype)
    assert frame.columns.tolist() == table.column_names and frame.unique.dtype == "boolean" and frame.isna().to_numpy()[3].all()


def test_what_an_analyst_types_is_numpys() -> None:
    """As of the numpy array of the same values, which is its witness."""
    values = np.array([0.25, -1.5, 3.0, 3.0, 0.5])
    column = ArrowArray(_standfast.make_array("x", values, None, None, {}))
    for name in ("min", "max", "sum", "mean", "std", "var", "argmin", "argmax", "any", "all"):
        found, expected = getattr(column, name)(), getattr(values, name)()
        assert found == expected and type(found) is type(expected), name
    assert column.std(ddof=1) == values.std(ddof=1) and column.var(ddof=1) == values.var(ddof=1)
    assert column.tolist() == values.tolist() == column.to_pylist()
    for found, expected in (
        (column.cumsum(), values.cumsum()), (column.round(), values.round()), (column.clip(0, 1), values.clip(0, 1)), (column.copy(), values),
        (column.argsort(), values.argsort(kind="stable")), (column.astype(np.float32), values.astype(np.float32)),
    ):  # fmt: skip
        assert type(found) is np.ndarray and found.dtype == expected.dtype and found.tolist() == expected.tolist()
    assert (column.dtype, column.shape, column.ndim, column.size) == (values.dtype, values.shape, 1, 5)
    assert np.median(column) == 0.5 and np.percentile(column, 50) == 0.5 and np.argmax(column) == 2
    for function in (np.std, np.mean, np.var, np.max, np.round, np.argsort, np.cumsum, np.any, np.diff):
        assert np.array_equal(function(column), function(values)), function
    holed = ArrowArray(_standfast.make_array("x", values, np.array([True, False, False, False, False]), None, {}))
    assert np.isnan(holed.std()) and np.nanstd(holed) == values[1:].std() and holed.dtype == np.float64


def test_codes_of_an_arrow_array_stay_of_modes(modes: ArrowArray) -> None:
    assert modes[:3].max() is Mode.SLIDE_LEFT and modes[:3].min() == "RE" and modes[:3].dtype == np.uint8 and modes.dtype == np.float64
    assert modes.tolist() == [Mode.REST, Mode.SLIDE_LEFT, Mode.SLIDE_LEFT, None, Mode.SLIDE_LEFT]
