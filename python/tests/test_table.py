"""Tables of cases and sweeps against the program's, and against assessments of the cases written out."""

from __future__ import annotations

import copy
import csv
import io
import math
import random
import signal
import subprocess
import sys
import time
import warnings
from decimal import Decimal
from pathlib import Path
from typing import Any

import dask.dataframe
import duckdb
import numpy as np
import pandas as pd
import pint
import polars as pl
import pyarrow as pa
import pytest
import standfast
import xarray as xr
from standfast import StandfastWarning, assess, assess_table, varied

ROOT = Path(__file__).parents[2]
GODA = ROOT / "examples/goda-2000.toml"
QUAY = ROOT / "examples/quay.toml"
SHAKEN = ROOT / "examples/seismic-block.toml"
BLOCK: dict[str, Any] = {
    "body": {"width": 1, "height": 2, "mass": 4800, "friction": 0.7},
    "load": [{"name": "push", "force": "20 kN/m", "elevation": "1.5 m"}],
}

#: What varies in each case, between which values.
VARIED: dict[Path, dict[str, tuple[float, float]]] = {
    GODA: {"wave.H13": (2, 7), "body.friction": (0.3, 0.8), "width": (9, 20), "wave.period": (6, 16)},
    QUAY: {"friction": (0.3, 0.8), "load[1].force": (0, 6e5), "criteria.SF_sliding": (1, 2)},
    SHAKEN: {"earthquake.horizontal [g]": (-0.5, 0.5), "earthquake.vertical [g]": (-0.3, 0.3), "friction": (0.1, 1)},
}


def goda() -> dict[str, Any]:
    tomllib = pytest.importorskip("tomllib")
    case: dict[str, Any] = tomllib.loads(GODA.read_text(encoding="utf-8"))
    del case["wave"]["deep_water_height"]
    case["wave"] |= {"H13": 5.8, "Hmax": 8.05}
    return case


def case_of(path: Path) -> Any:
    return goda() if path == GODA else path


def drawn(path: Path, rows: int, seed: int = 1) -> dict[str, np.ndarray[Any, Any]]:
    generator = np.random.default_rng(seed)
    return {name: generator.uniform(*ends, rows) for name, ends in VARIED[path].items()}


def as_text(value: Any) -> str:
    """A result as it stands in a CSV file of the program's."""
    if value is None or value is pd.NA or (isinstance(value, float) and math.isnan(value)):
        return ""
    if isinstance(value, (bool, np.bool_)):
        return str(bool(value)).lower()
    return str(value)


#: Sizes of the units that stand in the headings of the program's CSV.
UNITS = {"kN": 1e3, "kN/m": 1e3, "kN m": 1e3, "kN m/m": 1e3, "kPa": 1e3, "mrad": 1e-3, "m": 1.0, "s": 1.0, "m/s²": 1.0}


def in_si(row: dict[str, str], given: int) -> dict[str, str]:
    """A row of the program's with results under their names, in SI units; the first columns are those of the table."""
    found: dict[str, str] = {}
    for place, (heading, text) in enumerate(row.items()):
        name, _, unit = heading.partition(" [")
        if place < given or not unit:
            found[heading] = text
        else:
            found[name] = repr(float(text) * UNITS[unit.removesuffix("]")]) if text else text
    return found


def same(ours: Any, theirs: str) -> bool:
    text = as_text(ours)
    try:
        # A number in kN went through a division and a multiplication.
        return float(text) == float(theirs) or math.isclose(float(text), float(theirs), rel_tol=1e-15)
    except ValueError:
        return text == theirs


@pytest.mark.parametrize("path", VARIED, ids=lambda path: path.stem)
def test_every_row_is_that_of_the_program(program: list[str], path: Path, tmp_path: Path) -> None:
    frame = pd.DataFrame(drawn(path, 60))
    if path == GODA:
        file = tmp_path / "goda.toml"
        text = GODA.read_text(encoding="utf-8")
        file.write_text(text.replace('deep_water_height = "6.3 m"', "H13 = 5.8\nHmax = 8.05"), encoding="utf-8")
        frame.loc[7, "wave.H13"] = 12.0  # beyond Hmax
    else:
        file = path
    frame.loc[[3, 30], "friction" if "friction" in frame else "body.friction"] = [-0.5, np.nan]
    frame.to_csv(tmp_path / "rows.csv", index=False)
    command = [*program, "batch", str(tmp_path / "rows.csv"), "--case", str(file), "--on-error", "null", "--columns", "all", "-o", "-"]
    done = subprocess.run(command, capture_output=True, encoding="utf-8")
    assert done.returncode == 0, done.stderr
    theirs = [in_si(row, len(frame.columns)) for row in csv.DictReader(io.StringIO(done.stdout))]
    found = assess_table(file, frame, on_error="null")
    assert list(found.columns) == list(theirs[0])[len(frame.columns):] and len(found) == len(theirs)
    wrong = {3, 7, 30} if path == GODA else {3, 30}
    for row, (ours, expected) in enumerate(zip(found.to_dict("records"), theirs)):
        for name, value in ours.items():
            if name == "problem":
                assert (as_text(value) != "") == (expected[name] != "") == (row in wrong), (row, value)
                # A number is shown as the table of each has it.
                assert row == 30 or as_text(value).split(";")[-1] == expected[name].split(";")[-1]
            else:
                assert same(value, expected[name]), (row, name, value, expected[name])


def keys(case: dict[str, Any], name: str) -> tuple[dict[str, Any], str]:
    """The table of a case and the key in it that a name means."""
    table, key = name.rsplit(".", 1)
    place = case[table.split("[")[0]]
    return (place[int(table.split("[")[1][:-1]) - 1] if "[" in table else place), key


def same_value(ours: Any, theirs: Any) -> bool:
    if theirs is None:
        return (isinstance(ours, str) and ours == "") or (isinstance(ours, float) and math.isnan(ours))
    if isinstance(theirs, list):
        return bool(ours == " ".join(theirs))
    return bool(ours == theirs)


def test_every_point_is_the_assessment_of_its_case() -> None:
    generator = random.Random(5)
    quay = pytest.importorskip("tomllib").loads(QUAY.read_text(encoding="utf-8"))
    cases = [
        (goda(), {"wave.H13": (2, 7), "body.friction": (0.3, 0.8), "wave.period": (6, 16), "wave.angle_deg": (0, 60)}),
        (quay, {"load[1].force": (0, 6e5), "load[1].elevation": (0.5, 9), "criteria.SF_sliding": (1, 2)}),
        (BLOCK, {"load[1].force": (1e3, 5e4), "body.friction": (0, 1)}),
    ]
    for case, ends in cases:
        sample = {name: np.array([generator.uniform(*between) for _ in range(25)]) for name, between in ends.items()}
        found = assess_table(case, sample)
        for row in range(25):
            written = copy.deepcopy(case)
            for name, values in sample.items():
                place, key = keys(written, "load[1].force" if name == "load[1].force" else name)
                place[key] = float(values[row])
            answer = assess(written)
            for name, values in found.items():
                if name in answer.governing:
                    assert same_value(values[row].item(), answer.governing[name]), (row, name)
            if answer.met is not None:
                assert found["met"][row] == answer.met and found["criterion"][row] == answer.criteria[0].name
                assert same_value(found["utilisation"][row].item(), answer.criteria[0]["utilisation"])


def test_a_sweep_broadcasts() -> None:
    found = assess_table(BLOCK, {"friction": [0.2, 0.5, 0.9], "load[1].force": np.array([[5e3], [30e3]])})
    assert {values.shape for values in found.values()} == {(2, 3)}
    assert found["mode"].dtype.kind == "U" and found["unique"].dtype == bool and found["P"].dtype == np.float64
    for i, force in enumerate([5e3, 30e3]):
        for j, friction in enumerate([0.2, 0.5, 0.9]):
            one = assess_table(BLOCK, {"friction": friction, "load[1].force": force})
            for name, values in found.items():
                assert one[name].shape == () and np.array_equal(values[i, j], one[name], equal_nan=values.dtype.kind == "f")
    # What never comes is NaN, what has no bound infinite, what there is no word for empty.
    rests = assess_table(BLOCK, {"load[1].force": 0.0}, columns=["SF_sliding", "load_factor", "departure_mode", "also"])
    assert list(rests) == ["SF_sliding", "load_factor", "departure_mode", "also"]
    assert rests["SF_sliding"] == math.inf and np.isnan(rests["load_factor"])
    assert rests["departure_mode"] == rests["also"] == ""
    assert assess_table(BLOCK, {"friction": []})["mode"].shape == (0,)
    with pytest.raises(ValueError, match=r"do not broadcast together: friction \(2,\), load\[1\].force \(3,\)"):
        assess_table(BLOCK, {"friction": [1, 2], "load[1].force": [1, 2, 3]})


def test_units() -> None:
    plain = assess_table(BLOCK, {"load[1].force": [12e3, 34e3], "width": 1.2}, columns=["SF_sliding", "toe_pressure"])
    for given in (
        {"load[1].force [kN/m]": [12, 34], "width": 1.2},
        {"load[1].force": ["12 kN/m", "34000 N/m"], "width": "120 cm"},
        {"load[1].force": np.array(["12 kN/m", "34 kN/m"]), "width [cm]": 120},
        {"load[1].force": np.array(["12 kN/m", 34e3], dtype=object), "width": "1.2 m"},
    ):
        found = assess_table(BLOCK, given, columns=["SF_sliding", "toe_pressure"])
        for name, values in plain.items():
            assert found[name] == pytest.approx(values, rel=1e-14, nan_ok=True), given
    columns = ["earthquake_horizontal"]
    counted = assess_table(SHAKEN, {"earthquake.horizontal": ["0.1 g", "0.981 m/s2"]}, columns=columns)[columns[0]]
    assert abs(counted) == pytest.approx([0.981] * 2)
    named = assess_table(SHAKEN, {"earthquake.horizontal [g]": np.array([0.1])}, columns=columns)[columns[0]]
    assert named[0] == counted[0]
    with pytest.raises(ValueError, match=r"it has no unit; expected .* `earthquake.horizontal \[g\]`"):
        assess_table(SHAKEN, {"earthquake.horizontal": np.array([0.1])})
    for share in ("2 m/s2", "1.9 m/s²", "0.3 g"):
        block = {"body": BLOCK["body"], "earthquake": {"horizontal": "0.7 g"}}
        written = standfast.assess({**block, "earthquake": {"horizontal": share}})
        cell = assess_table(block, {"earthquake.horizontal": share}, columns=["SF_sliding", *columns])
        assert cell["SF_sliding"] == pytest.approx(written.SF_sliding, rel=1e-15)
    # Which gravity would it be?
    with pytest.raises(ValueError, match="the unit `m/s2` does not fit; expected .*, as gravity varies as well"):
        assess_table(SHAKEN, {"earthquake.horizontal": ["2 m/s2"], "gravity": 9.8})
    with pytest.raises(ValueError, match="the unit does not fit"):
        assess_table(BLOCK, {"width [kN]": 3})


def test_a_text_has_its_unit() -> None:
    """As in a case: a number in quotes is as likely to lack its unit as to be a number."""
    frame = pd.DataFrame({"width": ["1 m", "9"]}, index=["Ada", "Ben"])
    with pytest.raises(TypeError, match="^width is '9' at row 1, labelled 'Ben', a text without a unit"):
        assess_table(BLOCK, frame)
    for given in ({"width": ["1 m", "9"]}, {"width": np.array([["1 m"], ["9"]])}, {"friction": "0.5"}):
        with pytest.raises(TypeError, match="a text without a unit; expected a number, or a text with its unit"):
            assess_table(BLOCK, given)
    for table in (pl.DataFrame({"width": ["9"]}), pa.table({"friction": ["0.5"]})):
        with pytest.raises(ValueError, match="at index 0, column (width|friction): .* a text without a unit; expected a number"):
            assess_table(BLOCK, table)
    with pytest.raises(TypeError, match="^upper is '9', a text without a unit"):
        standfast.design(BLOCK, vary="width", target="rest", upper="9")


def test_tables_come_back_as_what_they_were() -> None:
    values = drawn(QUAY, 40)
    columns = ["mode", "met", "SF_sliding", "load_factor", "situation", "also"]
    frame = pd.DataFrame(values, index=[f"row {i % 39}" for i in range(40)])
    frame["name"] = "carried by nobody"
    found = assess_table(QUAY, frame, columns=columns)
    assert found.index.equals(frame.index) and list(found.columns) == columns
    assert isinstance(found["mode"].dtype, pd.CategoricalDtype) and found["met"].dtype == "boolean"
    assert found["SF_sliding"].dtype == np.float64
    joined = pd.concat([frame, found], axis=1)
    assert len(joined) == 40 and joined.loc["row 1", "mode"] == found.loc["row 1", "mode"]

    plain = assess_table(QUAY, values, columns=columns)
    polars = assess_table(QUAY, pl.DataFrame(values), columns=columns)
    assert isinstance(polars, pl.DataFrame) and polars.columns == columns and polars["met"].dtype == pl.Boolean
    pyarrow = assess_table(QUAY, pa.table(values), columns=columns)
    assert isinstance(pyarrow, pa.Table) and pyarrow.schema.field("SF_sliding").metadata[b"description"]
    relation = duckdb.sql("select * from values (0.5, 1e5), (0.7, 2e5) as t(friction, \"load[1].force\")")
    other = assess_table(QUAY, relation, columns=columns)
    assert isinstance(other, standfast.ArrowTable) and pa.table(other).num_rows == 2
    reader = pa.table(values).to_reader(max_chunksize=7)
    streamed = pa.table(assess_table(QUAY, reader, columns=columns))
    assert pa.table(streamed).to_pylist() == pyarrow.to_pylist() == polars.to_dicts()
    for name, expected in plain.items():
        ours = [x if x is not None else (math.nan if expected.dtype.kind == "f" else "") for x in pyarrow[name].to_pylist()]
        assert np.array_equal(np.array(ours), expected, equal_nan=expected.dtype.kind == "f")
        assert [as_text(x) for x in found[name]] == [as_text(x) for x in pyarrow[name].to_pylist()]
    for empty in (frame[:0], pl.DataFrame(values)[:0], pa.table(values)[:0]):
        assert len(assess_table(QUAY, empty, columns=columns)) == 0


def test_columns_of_any_kind_of_number() -> None:
    table = pa.table({
        "width": pa.array(["10 m", "1200 cm"]).dictionary_encode(),
        "load[1].force": pa.array([1, 2], pa.decimal128(9, 2)),
        "height": pa.array([11, 12], pa.int16()),
    })
    expected = assess_table(QUAY, {"width": [10, 12], "load[1].force": [1, 2], "height": [11, 12]}, columns=["SF_sliding"])
    assert assess_table(QUAY, table, columns=["SF_sliding"])["SF_sliding"].to_pylist() == expected["SF_sliding"].tolist()
    frame = pd.DataFrame({
        "width": pd.Categorical(["10 m", "1200 cm"]),
        "load[1].force": pd.array([1, 2], dtype="Int8"),
        "height": ["11 m", 12],
    })
    assert assess_table(QUAY, frame, columns=["SF_sliding"])["SF_sliding"].tolist() == expected["SF_sliding"].tolist()
    with pytest.raises(TypeError, match="column friction: holds true and false; expected numbers"):
        assess_table(QUAY, pa.table({"friction": [True]}))
    with pytest.raises(TypeError, match="friction is a pandas Series of dtype bool"):
        assess_table(QUAY, pd.DataFrame({"friction": [True]}))


def test_what_is_missing_and_what_is_wrong() -> None:
    friction = np.ma.masked_array([0.5, 9.9, 0.7], mask=[False, True, False])
    found = assess_table(BLOCK, {"friction": friction}, columns=["mode", "SF_sliding"])
    assert found["mode"].tolist() == ["RO", None, "RO"] and found["SF_sliding"].mask.tolist() == [False, True, False]
    columns = ["mode", "lifted", "SF_sliding"]
    frame = pd.DataFrame({"friction": [0.5, None, 0.7]})
    pandas = assess_table(BLOCK, frame, columns=columns)
    assert pandas.isna().to_numpy().tolist() == [[False] * 3, [True] * 3, [False] * 3]
    polars = assess_table(BLOCK, pl.DataFrame({"friction": [0.5, None, 0.7]}), columns=columns)
    assert polars.row(1) == (None, None, None) and None not in polars.row(0) + polars.row(2)
    nothing = assess_table(BLOCK, pl.DataFrame({"friction": [None, None]}), columns=columns)
    assert nothing.rows() == [(None, None, None)] * 2

    with pytest.raises(ValueError, match='^at index 2, column friction: "-0.5": `friction` is -0.5; expected a finite number, zero or more$'):
        assess_table(BLOCK, pl.DataFrame({"friction": [0.5, None, -0.5, -1]}))
    with pytest.raises(ValueError, match='^at index 1, column friction: "NaN"'):
        assess_table(BLOCK, {"friction": [0.5, math.nan]})
    with pytest.raises(ValueError, match=r'^at index \(1, 0\), column load\[1\].force: "inf"'):
        assess_table(BLOCK, {"friction": [0.5, 0.6], "load[1].force": [[1], [math.inf]]})
    with pytest.raises(ValueError, match='^at index 0, column width: "3 kN"'):
        assess_table(BLOCK, {"width": "3 kN"})

    wrong = pl.DataFrame({"friction": [0.5, -0.5, None]})
    found = assess_table(BLOCK, wrong, columns=columns, on_error="null")
    assert found.columns == [*columns, "problem"] and found["problem"][0] is None and found.row(1)[:3] == (None,) * 3
    assert '"-0.5"' in found["problem"][1] and "null" in found["problem"][2]
    arrays = assess_table(BLOCK, {"friction": [0.5, -0.5]}, columns=columns, on_error="null")
    assert arrays["mode"].tolist() == ["RO", None] and arrays["lifted"].mask.tolist() == [False, True]
    assert not np.ma.isMaskedArray(arrays["problem"])
    assert arrays["problem"][0] == "" and '"-0.5"' in arrays["problem"][1]
    pandas = assess_table(BLOCK, wrong.to_pandas(), columns=columns, on_error="null")
    assert pandas["problem"].isna().tolist() == [True, False, False] and pandas["mode"].isna().tolist() == [False, True, True]


def test_names() -> None:
    frame = pd.DataFrame({"mu": [0.5], "F": [20e3]})
    found = assess_table(BLOCK, frame, map={"friction": "mu", "load[1].force": "F"}, columns=["SF_sliding"])
    assert found["SF_sliding"][0] == assess_table(BLOCK, {"friction": 0.5})["SF_sliding"]
    for call, words in [
        (
            lambda: assess_table(BLOCK, frame),
            'has no column that varies the case; its columns are mu, F; did you mean `body.friction`[?] then say map={"body.friction": "mu"}',
        ),
        (
            lambda: assess_table(BLOCK, frame.rename(columns={"mu": "q"})),
            'has no column that varies the case; its columns are q, F.*say map={"KEY": "COLUMN"}',
        ),
        (lambda: assess_table(BLOCK, {"friction": 1}, columns=["SF_slidin"]), "columns SF_slidin: there is no such result here; did you mean"),
        (lambda: assess_table(BLOCK, {"friction": 1}, columns=["met"]), "columns met: there is no such result here"),
        (lambda: assess_table(BLOCK, {"friction": 1}, columns=["mode", "mode"]), "columns names mode twice"),
        (lambda: assess_table(BLOCK, {"friction": 1}, columns=[]), "columns is empty"),
        (lambda: assess_table(BLOCK, {"load[1].elevatio": 1, "friction": 1}), r"column load\[1\].elevatio: the case has no number"),
        (lambda: assess_table(BLOCK, {"mass": 1, "body.mass": 2}), "the columns mass and body.mass both vary body.mass"),
        (lambda: assess_table(BLOCK, {"friction": 1, "foo": 2}), "'foo' is not a number of the case"),
        (lambda: assess_table(BLOCK, {"friction": 1}, on_error="stop"), "on_error is 'stop'; expected 'raise' or 'null'"),
        (lambda: assess_table({}, {"friction": 1}), "the case"),
    ]:
        with pytest.raises(ValueError, match=words):
            call()
    with pytest.raises(KeyError, match="has no column G; its columns are mu, F"):
        assess_table(BLOCK, frame, map={"load[1].force": "G"})
    for call, words in [
        (lambda: assess_table(BLOCK, frame, columns={"friction": "mu"}), "said by map="),
        (lambda: assess_table(BLOCK, frame, columns="mode"), r"columns is 'mode', a str; expected a list of what to compute, as \['mode'\]"),
        (lambda: assess_table(BLOCK, frame, columns=5), "columns is 5, an int; expected a list"),
        (lambda: assess_table(BLOCK, frame, columns={"mode"}), "a set; expected a list"),
        (lambda: assess_table(BLOCK, frame, map=[("friction", "mu")]), "expected a dict of keys and columns"),
        (lambda: assess_table(BLOCK, frame, map={"friction": 0.5}), "map gives 0.5 for 'friction'"),
        (lambda: assess_table(BLOCK, 3), "expected a DataFrame, an Arrow table, or a dict of arrays"),
        (lambda: assess_table(BLOCK, pl.LazyFrame({"friction": [1]})), r"Call .collect\(\)"),
        (lambda: assess_table(BLOCK, dask.dataframe.from_pandas(frame)), "lazy.*map_partitions.*assess_table"),
        (lambda: assess_table(BLOCK, {"friction": [True]}), "expected real numbers"),
        (lambda: assess_table(3, {"friction": 1}), "expected the path of a case file"),
        (lambda: varied(BLOCK, "friction"), "a list of the names"),
    ]:
        with pytest.raises(TypeError, match=words):
            call()


def test_a_column_that_is_almost_a_key_is_a_warning() -> None:
    frame = pd.DataFrame({"friction": [0.5], "forces": [1.0], "name": ["a"]})
    with pytest.warns(StandfastWarning, match=r'column forces varies nothing.*say map={"load\[1\].force": "forces"} \(column-like-key\)') as caught:
        assess_table(BLOCK, frame)
    assert [warning.message.name for warning in caught] == ["column-like-key"]
    assert caught[0].filename == __file__
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assess_table(BLOCK, frame.drop(columns="forces"))


def test_what_varies_and_what_goes_with_it() -> None:
    found = varied(GODA, pd.DataFrame({"water_level": [7.1], "id": [3]}))
    assert found.keys == {"water_level": "wave.base_depth"}
    assert len(found.notes) == 1 and "wave.water_depth" in found.notes[0] and "wave.crest_height" in found.notes[0]
    assert found.results["P"] == ("N/m", "horizontal force, towards the heel") and found.results["mode"].unit is None
    assert list(found.results) == list(assess_table(GODA, {"friction": 0.5}))
    assert varied(GODA, ["wave.period"], columns=["mode"]).notes == []
    assert varied(GODA, {"width": 3}) == varied(GODA, pa.table({"width": [3]})) == varied(GODA, pl.DataFrame({"width": [3]}))
    whole = varied(ROOT / "examples/server-rack.toml", ["friction"])
    assert whole.results["P"].unit == "N" and whole.results["margin_overturning"].unit == "N m"


def test_any_number_of_threads_gives_the_same() -> None:
    frame = pl.DataFrame(drawn(QUAY, 3000))
    one = assess_table(QUAY, frame, threads=1)
    for threads in (2, 5, None):
        assert assess_table(QUAY, frame, threads=threads).equals(one)
    wrong = frame.with_columns(pl.when(pl.int_range(3000) % 1000 == 500).then(-1.0).otherwise("friction").alias("friction"))
    for threads in (1, 4):
        with pytest.raises(ValueError, match="^at index 500, column friction"):
            assess_table(QUAY, wrong, threads=threads)


def test_two_keys_for_one_column() -> None:
    words = "friction and body.width are both mapped to column mu of the table; expected a column for each"
    for table in ({"mu": [0.5]}, pd.DataFrame({"mu": [0.5]}), pl.DataFrame({"mu": [0.5]})):
        with pytest.raises(ValueError, match=words):
            assess_table(QUAY, table, map={"friction": "mu", "body.width": "mu"})


def test_progress(monkeypatch: pytest.MonkeyPatch) -> None:
    told: list[tuple[int, int | None]] = []
    sample = drawn(GODA, 20_000)
    assess_table(goda(), sample, columns=["mode"], progress=lambda done, total: told.append((done, total)))
    assert told == sorted(told) and told[-1] == (20_000, 20_000)
    streamed: list[tuple[int, int | None]] = []
    assess_table(goda(), pa.table(sample), columns=["mode"], progress=lambda done, total: streamed.append((done, total)))
    assert streamed[-1] == (20_000, 20_000) and {total for _, total in streamed} == {20_000}
    told = []
    assess_table(goda(), pl.DataFrame(sample), columns=["mode"], progress=lambda done, total: told.append((done, total)))
    assert {total for _, total in told} == {20_000}
    reader = pa.table(sample).to_reader()
    told = []
    assess_table(goda(), reader, columns=["mode"], progress=lambda done, total: told.append((done, total)))
    assert told[-1] == (20_000, None)

    def enough(done: int, total: int | None) -> None:
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        assess_table(goda(), sample, progress=enough)
    bars: list[Any] = []
    import tqdm.auto

    class Bar(tqdm.auto.tqdm):  # type: ignore[type-arg]
        def close(self) -> None:
            bars.append((self.n, self.total))
            super().close()

    monkeypatch.setattr(tqdm.auto, "tqdm", Bar)
    assess_table(BLOCK, {"friction": [0.5, 0.6]}, progress=True)
    assert (2, 2) in bars
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)
    with pytest.raises(ImportError, match=r'pip install "standfast\[progress\]"'):
        assess_table(BLOCK, {"friction": 0.5}, progress=True)
    with pytest.raises(TypeError, match="progress is 3; expected True"):
        assess_table(BLOCK, {"friction": 0.5}, progress=3)  # type: ignore[call-overload]


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="needs a timer of the system")
def test_an_interrupt_is_obeyed_at_once() -> None:
    def interrupt(*_: object) -> None:
        fired.append(time.perf_counter())
        raise KeyboardInterrupt

    fired: list[float] = []
    before = signal.signal(signal.SIGALRM, interrupt)
    # Half a minute of work on two cores.
    friction = np.broadcast_to(np.linspace(0.3, 0.8, 2_000_000), (2_000_000,))
    try:
        for table in ({"friction": friction}, pl.DataFrame({"friction": friction})):
            signal.setitimer(signal.ITIMER_REAL, 1.0)
            with pytest.raises(KeyboardInterrupt):
                assess_table(GODA, table, columns=["mode"])
            # In an instant, where nothing else keeps the machine busy.
            assert time.perf_counter() - fired[-1] < 2
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def test_texts_are_beside_numbers_and_nothing_else() -> None:
    for wrong in (True, np.bool_(True), 1j):
        mixed = np.array(["1 m", wrong], object)
        for given in ({"width": mixed}, {"width": mixed.tolist()}, pd.DataFrame({"width": mixed})):
            with pytest.raises(TypeError, match="width is .* at index 1; expected real numbers"):
                assess_table(BLOCK, given)
    with pytest.raises(TypeError, match=r"width is True, a bool at index \(1, 0\)"):
        assess_table(BLOCK, {"width": np.array([["1 m"], [True]], object)})
    found = assess_table(BLOCK, {"width": np.array(["1.5 m", np.float32(1.5), Decimal("1.5"), None], object)}, columns=["SF_sliding"])
    assert found["SF_sliding"].tolist() == [assess_table(BLOCK, {"width": 1.5})["SF_sliding"].item()] * 3 + [None]
    masked = np.ma.masked_array(["1.5 m", "9 m"], [False, True])
    assert assess_table(BLOCK, {"width": masked}, columns=["SF_sliding"])["SF_sliding"].tolist() == found["SF_sliding"].tolist()[::3]


def test_numbers_may_lie_anywhere() -> None:
    friction = np.ndarray(2, buffer=bytearray(17), offset=1)
    friction[:] = [0.3, 0.7]
    assert not friction.flags.aligned
    expected = assess_table(BLOCK, {"friction": [0.3, 0.7]}, columns=["SF_sliding"])["SF_sliding"].tolist()
    for given in ({"friction": friction}, pd.DataFrame({"friction": friction}, copy=False)):
        assert assess_table(BLOCK, given, columns=["SF_sliding"])["SF_sliding"].tolist() == expected


def test_one_thread_and_all_answer_alike() -> None:
    sweep = drawn(QUAY, 200)
    one, all_ = (assess_table(QUAY, sweep, threads=threads) for threads in (1, None))
    assert list(one) == list(all_)
    for name, column in one.items():
        np.testing.assert_array_equal(column, all_[name])


def test_what_varies_is_found_without_reading() -> None:
    table = pa.table({"friction": [0.3, 0.7], "storm": [1, 2]})
    reader = table.to_reader()
    for given in (reader, table, table.to_batches()[0], {"friction": 1, "storm": 2}, ["friction", "storm"], ("friction",)):
        assert varied(BLOCK, given).keys == {"friction": "body.friction"}
    assert reader.read_all() == table
    for wrong in ("friction", 5, iter(["friction"]), [pa.array([1])]):
        with pytest.raises(TypeError, match="expected a table, or a list of the names of its columns"):
            varied(BLOCK, wrong)


def test_a_batch_is_answered_by_a_table() -> None:
    batch = pa.record_batch({"friction": [0.3, 0.7]})
    assert type(assess_table(BLOCK, batch)) is pa.Table


def test_quantities_of_pint_are_refused() -> None:
    # 15° would become 0.26 rad, and be read as degrees.
    units = pint.UnitRegistry()
    for quantity, unit in [(units.Quantity([15.0], "degree"), "degree"), (units.Quantity(1500, "cm"), "centimeter")]:
        with pytest.raises(TypeError, match=f"^width is a quantity of pint, in {unit}; expected numbers, with the unit behind the name"):
            assess_table(BLOCK, {"width": quantity})
