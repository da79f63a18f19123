"""What comes out for what went in: scalars, arrays, pandas, polars, pyarrow, other Arrow objects."""

from __future__ import annotations

import copy
import pickle
from collections.abc import Callable
from typing import Any

import duckdb
import numpy as np
import pandas as pd
import polars as pl
import pyarrow as pa
import pytest
import reference
import standfast
from standfast import Mode, Modes, Onset, OnsetArrays

NAMES = ("gamma", "k_prime", "k", "mu")
#: Points whose modes the report's equations give in closed form: at rest, sliding, rocking, sliding and rocking.
POINTS = {"gamma": [1.0, 3.0, 1.0, 3.0], "k_prime": [0.4, 0.8, 1.0, 0.8], "k": [0.5, 0.1, 2.0, 0.5], "mu": [0.6, 0.05, 5.0, 0.05]}
MODES = [Mode.REST, Mode.SLIDE_LEFT, Mode.ROCK_O, Mode.SLIDE_ROCK_O_LEFT]
SYMBOLS = ["RE", "SL", "RO", "SRO-"]
#: The third point has no friction.
GAPS = {**POINTS, "mu": [0.6, 0.05, None, 0.05]}
LEFT = ["RE", "SL", None, "SRO-"]


def frame(**options: Any) -> pd.DataFrame:
    return pd.DataFrame(POINTS, **options)


def values(column: Any) -> list[Any]:
    """A column as a list with None for what is missing."""
    listed = column.to_pylist() if hasattr(column, "to_pylist") else column.tolist() if hasattr(column, "tolist") else list(column)
    return [None if value is None or value is pd.NA or value != value else value for value in listed]


# pandas


@pytest.mark.parametrize(
    "index",
    [
        pd.RangeIndex(4),
        pd.Index(list("abcd"), name="storm"),
        pd.Index([7, 7, 3, 7]),
        pd.date_range("2001-01-01", periods=4, freq="D", tz="UTC"),
        pd.MultiIndex.from_product([["Sines", "Leixoes"], [1, 2]], names=["site", "storm"]),
        pd.Index([1.0, np.nan, 2.0, np.nan]),
    ],
    ids=["range", "words", "duplicates", "dates", "levels", "NaN"],
)
def test_pandas_keeps_its_index(index: pd.Index) -> None:
    table = frame(index=index)
    columns = [table[name] for name in NAMES]
    for found in (standfast.classify(table), standfast.classify(*columns), standfast.classify(table.gamma, *columns[1:])):
        assert type(found) is pd.Series and found.name == "mode" and found.dtype == pd.UInt8Dtype()
        assert found.index.equals(index) and found.index.names == index.names and found.tolist() == MODES
    for motion in (standfast.onset(table), standfast.onset(*columns)):
        assert type(motion) is pd.DataFrame and motion.index.equals(index) and list(motion.columns) == list(Onset._fields)
        assert motion["mode"].tolist() == MODES and motion.theta_ddot.iloc[2] == 1.125
        assert motion.dtypes[["mode", "unique", "others", "xi"]].tolist() == [
            pd.UInt8Dtype(), pd.BooleanDtype(), pd.UInt16Dtype(), np.dtype(float)
        ]


def test_pandas_columns_beside_numbers_and_arrays() -> None:
    table = frame(index=list("abcd"))
    expected = standfast.classify(POINTS["gamma"], 0.4, POINTS["k"], 0.3).tolist()
    for gamma in (POINTS["gamma"], np.array(POINTS["gamma"]), pd.Index(POINTS["gamma"]), tuple(POINTS["gamma"])):
        found = standfast.classify(gamma, 0.4, table.k, np.float32(0.3) * 0 + 0.3)
        assert found.index.tolist() == list("abcd") and found.tolist() == expected
    # A subclass of pandas' own is pandas.
    assert isinstance(standfast.classify(type("Storms", (pd.DataFrame,), {})(POINTS)), pd.Series)
    # Rows by the labels of the columns, in whatever order they stand.
    assert standfast.classify(table[["mu", "k", "gamma", "k_prime"]].assign(other="x")).tolist() == MODES
    assert standfast.classify(table.iloc[::-1]).tolist() == MODES[::-1]
    assert standfast.classify(table.iloc[:0]).tolist() == [] and len(standfast.onset(table.iloc[:0])) == 0


def test_habits_of_pandas() -> None:
    table = frame(index=list("abcd"))
    table["mode"] = standfast.classify(table)
    assert table["mode"].tolist() == MODES
    assert (table["mode"] == Mode.ROCK_O).tolist() == [False, False, True, False]
    assert np.unique(table["mode"]).tolist() == [0, 1, 2, 3]
    assert table["mode"].value_counts().to_dict() == {0: 1, 1: 1, 2: 1, 3: 1}
    assert table.assign(symbol=standfast.classify(table, names=True)).loc["b", "symbol"] == "SL"
    assert table.assign(again=standfast.classify)["again"].tolist() == table.pipe(standfast.classify).tolist() == MODES
    sites = table.assign(site=["S", "L", "S", "L"])
    assert sites.groupby("site").apply(standfast.classify).loc["S"].tolist() == [Mode.REST, Mode.ROCK_O]
    assert table[list(NAMES)].apply(lambda row: standfast.classify(**row), axis=1).tolist() == MODES
    joined = table.join(standfast.onset(table, columns=["theta_ddot", "unique"]))
    assert joined.loc["c", "theta_ddot"] == 1.125 and joined["unique"].all()
    # Rows of other labels are aligned by pandas, as with any Series.
    table["late"] = standfast.classify(table.loc[["d", "a"]])
    assert values(table.late) == [0, None, None, 3]


def test_names_in_pandas_are_categories() -> None:
    found = standfast.classify(frame(index=list("abcd")), names=True)
    assert found.dtype == pd.CategoricalDtype([mode.symbol for mode in Mode]) and found.tolist() == SYMBOLS
    assert found.index.tolist() == list("abcd") and found.name == "mode"
    gaps = standfast.classify(pd.DataFrame(GAPS), names=True)
    assert values(gaps) == LEFT and gaps.isna().tolist() == [False, False, True, False]


DTYPES: dict[str, Callable[[list[Any]], pd.Series[Any]]] = {
    "float64": lambda items: pd.Series(items, dtype=float),
    "float32": lambda items: pd.Series(items, dtype="float32"),
    "Float64": lambda items: pd.Series(items, dtype="Float64"),
    "Float64 with NaN": lambda items: pd.Series(items, dtype="Float64") + pd.Series([0, 0, np.nan, 0]),
    "Float32": lambda items: pd.Series(items, dtype="Float32"),
    "pyarrow": lambda items: pd.Series(items, dtype="double[pyarrow]"),
    "decimal": lambda items: pd.Series(pd.arrays.ArrowExtensionArray(pa.array(items).cast(pa.decimal128(5, 3)))),
    "objects and None": lambda items: pd.Series(items, dtype=object),
    "objects and NA": lambda items: pd.Series([pd.NA if item is None else item for item in items], dtype=object),
    "objects and NaN": lambda items: pd.Series([np.nan if item is None else item for item in items], dtype=object),
    "category": lambda items: pd.Series(items, dtype="category"),
    "sparse": lambda items: pd.Series(items, dtype="Sparse[float]"),
    "dictionary": lambda items: pd.Series(pd.arrays.ArrowExtensionArray(pa.array(items).dictionary_encode())),
}


@pytest.mark.parametrize("kind", DTYPES)
def test_what_pandas_calls_missing(kind: str) -> None:
    """NaN, NA and None are the same word in a Series and in a DataFrame."""
    friction = DTYPES[kind](GAPS["mu"])
    assert friction.isna().tolist() == [False, False, True, False] or kind == "Float64 with NaN"
    table = pd.DataFrame(POINTS).assign(mu=friction)
    for found in (standfast.classify(table), standfast.classify(table.gamma, table.k_prime, table.k, friction)):
        assert values(found) == [0, 1, None, 3]
    for motion in (standfast.onset(table), standfast.onset(table.gamma, table.k_prime, table.k, friction)):
        assert motion.isna().sum(axis=1).tolist() == [0, 0, len(motion.columns), 0]


@pytest.mark.parametrize("kind", ["Int64", "int64", "uint8", "int32[pyarrow]", "UInt16", "bool"])
def test_whole_numbers_of_pandas(kind: str) -> None:
    friction = pd.Series([0, 1, 1, 0]).astype(kind)
    if kind == "bool":
        with pytest.raises(TypeError, match="mu is a pandas Series of dtype bool; expected real numbers"):
            standfast.classify(1, 0.4, 0.5, friction)
        return
    assert standfast.classify(1, 0.4, 0.5, friction).tolist() == standfast.classify(1, 0.4, 0.5, [0, 1, 1, 0]).tolist()


@pytest.mark.parametrize("kind", ["string", "complex", "datetime64[ns]", "timedelta64[ns]", "boolean", "bool[pyarrow]", "period[D]"])
def test_columns_of_pandas_that_are_no_numbers(kind: str) -> None:
    column = pd.Series(pd.period_range("2001", periods=4, freq="D")) if "period" in kind else pd.Series([0, 1, 1, 0]).astype(kind)
    for given in ((frame().assign(mu=column),), (1, 0.4, 0.5, column)):
        with pytest.raises(TypeError, match="mu (is a pandas Series of dtype|has the Arrow type) .*; expected .*real numbers, as [Ff]loat64"):
            standfast.classify(*given)  # type: ignore[call-overload]


def test_unequal_indexes_are_refused() -> None:
    """Rows are never paired by their place where their labels differ."""
    force = pd.Series([0.1, 0.5], index=["calm", "storm"])
    friction = pd.Series([0.6, 0.05], index=["storm", "calm"])
    for function in (standfast.classify, standfast.onset):
        with pytest.raises(ValueError, match=r"the indexes of k and mu differ: at row 0, 'calm' and 'storm'; .*k.align\(mu\)"):
            function(3, 0.8, force, friction)
    # Doing what the error says: of a calm sea and a storm, each with its own friction.
    aligned = standfast.classify(3, 0.8, *force.align(friction), names=True)
    assert aligned.to_dict() == {label: reference.mode(3, 0.8, force[label], friction[label]) for label in force.index}
    paired = standfast.classify(3, 0.8, force, friction.to_numpy())
    assert standfast.symbols(paired).tolist() == [reference.mode(3, 0.8, 0.1, 0.6), reference.mode(3, 0.8, 0.5, 0.05)]
    assert paired.tolist() != standfast.classify(3, 0.8, *force.align(friction)).tolist()
    with pytest.raises(ValueError, match="k has 2 rows and mu 3; expected Series of one index"):
        standfast.classify(3, 0.8, force, pd.Series([1.0, 2.0, 3.0]))
    with pytest.raises(ValueError, match=r"mu has the shape \(3,\) beside columns of 2 rows; expected \(2,\)"):
        standfast.classify(3, 0.8, force, [1, 2, 3])
    with pytest.raises(ValueError, match=r"mu has the shape \(1,\) beside columns of 2 rows"):
        standfast.classify(3, 0.8, force, [1])
    with pytest.raises(ValueError, match=r"mu has the shape \(2, 1\) beside columns of 2 rows"):
        standfast.classify(3, 0.8, force, [[1], [2]])
    # Equal ones are equal, whatever their type.
    assert standfast.classify(3, 0.8, pd.Series([0.1]), pd.Series([0.05], index=pd.Index([0]))).tolist() == [Mode.SLIDE_LEFT]


# polars, pyarrow, DuckDB


def test_polars() -> None:
    storms = pl.DataFrame(POINTS)
    for found in (standfast.classify(storms), standfast.classify(*storms)):
        assert isinstance(found, pl.Series) and found.dtype == pl.UInt8 and found.name == "mode" and found.to_list() == MODES
    for motion in (standfast.onset(storms), standfast.onset(*storms)):
        assert isinstance(motion, pl.DataFrame) and motion.columns == list(Onset._fields)
        assert motion["theta_ddot"][2] == 1.125 and motion.schema["unique"] == pl.Boolean
    named = storms.with_columns(mode=standfast.classify(storms), symbol=standfast.classify(storms, names=True))
    assert named.filter(pl.col("symbol") == "SL")["mode"].to_list() == [Mode.SLIDE_LEFT]
    assert named.schema["symbol"] == pl.Enum([mode.symbol for mode in Mode])
    assert named.group_by("symbol").len().sort("symbol")["symbol"].to_list() == SYMBOLS
    both = storms.hstack(standfast.onset(storms, columns=["others", "slip"]))
    assert both.columns == [*NAMES, "others", "slip"] and both.schema["others"] == pl.UInt16
    # Arrays beside columns have as many rows.
    assert standfast.classify(np.array(POINTS["gamma"]), storms["k_prime"], POINTS["k"], storms["mu"]).to_list() == MODES
    gaps = pl.DataFrame(GAPS)
    assert standfast.classify(gaps, names=True).to_list() == LEFT
    assert standfast.classify(POINTS["gamma"], gaps["k_prime"], gaps["k"], gaps["mu"], names=True).to_list() == LEFT
    assert standfast.onset(gaps)["theta_ddot"].null_count() == 1
    with pytest.raises(ValueError, match="friction μ is NaN at index 2"):
        standfast.classify(gaps.fill_null(float("nan")))
    assert standfast.classify(gaps.with_columns(mu=None)).to_list() == [None] * 4


def test_pyarrow() -> None:
    table = pa.table(POINTS)
    reader = pa.RecordBatchReader.from_batches(table.schema, table.to_batches())
    for found in (standfast.classify(table), standfast.classify(reader), standfast.classify(*table.columns)):
        assert isinstance(found, pa.Array) and found.type == pa.uint8() and found.to_pylist() == MODES
    assert table.append_column("mode", standfast.classify(table)).column_names == [*NAMES, "mode"]
    symbols = standfast.classify(table.to_batches()[0], names=True)
    assert symbols.type == pa.dictionary(pa.uint8(), pa.string()) and symbols.to_pylist() == SYMBOLS
    motion = standfast.onset(table, columns=["mode", "theta_ddot"])
    assert isinstance(motion, pa.Table) and motion.column_names == ["mode", "theta_ddot"]
    assert motion["theta_ddot"].to_pylist()[2] == 1.125
    assert standfast.classify(POINTS["gamma"], *table.columns[1:]).to_pylist() == MODES
    assert values(standfast.classify(pa.table(GAPS), names=True)) == LEFT


def test_other_arrow_objects() -> None:
    relation = duckdb.from_arrow(pa.table(GAPS))
    for found in (standfast.classify(relation), standfast.classify(pa.array(GAPS["gamma"]), 0.4, pl.Series(GAPS["k"]), 1)):
        assert type(found) is standfast.ArrowArray
    modes = standfast.classify(relation)
    assert values(modes) == [0, 1, None, 3] and pickle.loads(pickle.dumps(modes)).to_pylist() == modes.to_pylist()
    assert standfast.symbols(modes).to_pylist() == standfast.classify(relation, names=True).to_pylist() == LEFT
    assert type(standfast.onset(relation)) is standfast.ArrowTable
    # Shared between rows, by an array beside it.
    found = standfast.classify(pa.array(POINTS["gamma"]), np.array(POINTS["k_prime"]), pl.Series(POINTS["k"]), POINTS["mu"])
    assert type(found) is standfast.ArrowArray and found.to_pylist() == MODES


def test_decimals_and_dictionaries_of_duckdb() -> None:
    point = "select 1.0 gamma, 0.4 k_prime, 0.5::decimal(30, 20) k, 0.6::decimal(4, 1) mu"
    assert standfast.classify(duckdb.sql(point)).to_pylist() == [Mode.REST]


# numpy


def test_masked_arrays() -> None:
    friction = np.ma.MaskedArray([0.6, 0.05, -7, 0.05], [False, False, True, False])
    found = standfast.classify(POINTS["gamma"], POINTS["k_prime"], POINTS["k"], friction)
    assert type(found) is np.ma.MaskedArray and found.dtype == np.uint8 and found.tolist() == [0, 1, None, 3]
    named = standfast.classify(POINTS["gamma"], POINTS["k_prime"], POINTS["k"], friction, names=True)
    assert type(named) is np.ma.MaskedArray and named.tolist() == LEFT
    motion = standfast.onset(POINTS["gamma"], POINTS["k_prime"], POINTS["k"], friction)
    assert all(column.mask.tolist() == [False, False, True, False] for column in motion)
    filled = [column.filled()[2] for column in motion]
    assert filled[:3] == [255, False, 65535] and np.isnan(filled[3:]).all() and named.filled()[2] == ""
    # The mask broadcasts as the numbers do, and answers of masked arrays are masked arrays.
    wide = standfast.classify(1, 0.4, [[0.5], [0.7]], friction)
    assert wide.mask.tolist() == [[False, False, True, False]] * 2
    plain = standfast.classify(1, 0.4, np.ma.MaskedArray([0.5, 0.7]), 0.6)
    assert type(plain) is np.ma.MaskedArray and plain.tolist() == standfast.classify(1, 0.4, [0.5, 0.7], 0.6).tolist()
    assert standfast.classify(1, 0.4, np.ma.masked, 0.6) is np.ma.masked
    assert standfast.classify(1, 0.4, np.ma.array(0.5), 0.6) is Mode.REST
    with pytest.raises(ValueError, match="friction μ is NaN at index 1"):
        standfast.classify(1, 0.4, 0.5, np.ma.MaskedArray([0.5, np.nan], [False, False]))
    with pytest.raises(TypeError, match="out is for plain arrays"):
        standfast.classify(1, 0.4, 0.5, friction, out=np.zeros(4, dtype=np.uint8))


def test_numbers_of_any_kind_are_a_point() -> None:
    for number in (0.5, np.float32(0.5), np.float64(0.5), np.array(0.5), np.float16(0.5)):
        assert standfast.classify(1, 0.4, number, 0.6) is Mode.REST
        point = standfast.onset(1, 0.4, number, 0.6)
        assert type(point) is Onset and point.others == Modes(0) and type(point.unique) is bool and type(point.f_x) is float
    assert standfast.classify(1, 0.4, 0.5, 0.6, names=True) == "RE"
    assert type(standfast.onset(1, 0.4, [0.5], 0.6)) is OnsetArrays


def test_impossible_values_without_answer() -> None:
    """on_error="null": a missing answer in the kind of each, where "raise" names the value."""
    wrong = {**POINTS, "mu": [0.6, 0.05, -1.0, 0.05]}
    given: dict[str, Any] = {
        "arrays": list(wrong.values()),
        "pandas": [pd.DataFrame(wrong)],
        "columns of pandas": list(dict(pd.DataFrame(wrong).items()).values()),
        "polars": [pl.DataFrame(wrong)],
        "columns of polars": list(pl.DataFrame(wrong)),
        "pyarrow": [pa.table(wrong)],
        "arrow": [duckdb.from_arrow(pa.table(wrong))],
    }
    for kind, operands in given.items():
        with pytest.raises(ValueError, match="friction μ is -1 at index 2; expected a number from 0 to 1e50"):
            standfast.classify(*operands)
        assert values(standfast.classify(*operands, on_error="null")) == [0, 1, None, 3], kind
        assert values(standfast.classify(*operands, on_error="null", names=True)) == LEFT, kind
        motion = standfast.onset(*operands, on_error="null", columns=["mode", "xi"])
        mode = motion.mode if kind == "arrays" else motion["mode"]
        assert values(mode) == [0, 1, None, 3], kind
    assert type(standfast.classify(*given["arrays"], on_error="null")) is np.ma.MaskedArray
    assert type(standfast.classify(1, 0.4, [0.5], 0.6, on_error="null")) is np.ma.MaskedArray
    # What is missing and what is impossible come to the same.
    both = pd.DataFrame({**wrong, "k": [0.5, None, 2.0, 0.5]})
    assert values(standfast.classify(both, on_error="null")) == [0, None, None, 3]
    assert standfast.classify(1, 0.4, 0.5, -1, on_error="null") is None
    assert standfast.classify(1, 0.4, 0.5, -1, on_error="null", names=True) is None
    assert standfast.onset(1, 0.4, 0.5, -1, on_error="null") is None
    assert standfast.classify(1, 0.4, 0.5, 0.6, on_error="null") is Mode.REST
    with pytest.raises(ValueError, match="on_error is 'stop'; expected 'raise' or 'null'"):
        standfast.classify(1, 0.4, 0.5, 0.6, on_error="stop")  # type: ignore[call-overload]


def test_all_kinds_agree_on_what_is_missing() -> None:
    """Random points, each operand missing in some: the answer is missing where any is, whoever says so."""
    random = np.random.default_rng(11)
    points = reference.points(600, seed=11)
    gaps = random.random((4, len(points))) < 0.08
    complete = ~gaps.any(axis=0)
    plain = dict(zip(NAMES, np.array(points).T.copy()))
    expected = [reference.mode(*point) if whole else None for point, whole in zip(points, complete)]
    assert 0.6 < complete.mean() < 0.8 and len(set(expected)) > 5
    holes = {name: np.where(gap, np.nan, column) for gap, (name, column) in zip(gaps, plain.items())}
    nulls = {name: [None if hole != hole else hole for hole in column.tolist()] for name, column in holes.items()}
    masked = {name: np.ma.MaskedArray(column, gap) for gap, (name, column) in zip(gaps, plain.items())}
    storms, table, frame = pl.DataFrame(nulls), pa.table(nulls), pd.DataFrame(holes, index=random.permutation(600))
    given: dict[str, tuple[Any, ...]] = {
        "pandas": (frame,),
        "columns of pandas": tuple(frame[name] for name in NAMES),
        "nullable": (frame.convert_dtypes(),),
        "objects": (pd.DataFrame(nulls, dtype=object),),
        "Arrow in pandas": (frame.astype("double[pyarrow]"),),
        "mixed in pandas": (masked["gamma"], frame.k_prime, pd.array(nulls["k"]), frame.mu.astype("Float64")),
        "polars": (storms,),
        "columns of polars": tuple(storms),
        "mixed in polars": (masked["gamma"], storms["k_prime"], masked["k"], storms["mu"]),
        "pyarrow": (table,),
        "chunks": tuple(pa.chunked_array([table[name][:250].combine_chunks(), table[name][250:].combine_chunks()]) for name in NAMES),
        "duckdb": (duckdb.from_arrow(table),),
        "masked": tuple(masked.values()),
        "masked of two axes": (masked["gamma"], masked["k_prime"], masked["k"][None], masked["mu"]),
    }
    motion = standfast.onset(*(plain[name][complete] for name in NAMES), columns=["slip"]).slip
    for kind, operands in given.items():
        found = standfast.classify(*operands, names=True)
        assert values(found.ravel() if kind == "masked of two axes" else found) == expected, kind
        slips = standfast.onset(*operands, columns=["mode", "slip"], threads=2)
        slip = slips.slip.ravel() if "masked" in kind else slips["slip"]
        assert [value for value in values(slip) if value is not None] == motion.tolist(), kind


# Fields


def test_fields_behave_as_named_tuples() -> None:
    point, arrays = standfast.onset(1, 1, 2, 5), standfast.onset(1, 1, [2], 5, columns=["theta_ddot", "mode"])
    assert point._asdict()["mode"] is point.mode is point[0] is Mode.ROCK_O and len(point) == 12
    theta_ddot, mode = arrays
    assert theta_ddot is arrays.theta_ddot and arrays._fields == ("theta_ddot", "mode") and mode.tolist() == [2]
    assert standfast.onset(1, 1, 2, 5, columns=["theta_ddot"]) == (1.125,)
    assert repr(standfast.onset(1, 1, 2, 5, columns=["theta_ddot", "unique"])) == "Onset(theta_ddot=1.125, unique=True)"
    for other in (pickle.loads(pickle.dumps(point)), copy.copy(point), copy.deepcopy(point)):
        assert other == point and type(other) is Onset and other.f_y == 2.125
    assert pickle.loads(pickle.dumps(arrays)).theta_ddot.tolist() == [1.125]
    with pytest.raises(AttributeError, match="xi was not asked for; columns named theta_ddot, mode only"):
        arrays.xi
    with pytest.raises(AttributeError, match="Onset has no field 'phi'; it has mode, unique"):
        point.phi  # type: ignore[attr-defined]
    with pytest.raises(AttributeError, match="Onset cannot be changed"):
        point.mode = Mode.REST


def test_columns_to_compute() -> None:
    with pytest.raises(ValueError, match="columns has 'theta_dot'; did you mean 'theta_ddot'"):
        standfast.onset(1, 1, [2], 5, columns=["theta_dot"])
    with pytest.raises(ValueError, match="columns has 'mode' twice"):
        standfast.onset(frame(), columns=["mode", "mode"])
    with pytest.raises(ValueError, match="columns is empty; expected some of mode, unique"):
        standfast.onset(frame(), columns=[])
    with pytest.raises(TypeError, match="columns is 'mode', a str; expected a list of what to compute"):
        standfast.onset(frame(), columns="mode")
    # As `columns` once said where the operands are.
    for function in (standfast.classify, standfast.onset):
        with pytest.raises(TypeError, match=r"which column of a table holds what is said by map=\{...\}"):
            function(frame(), columns={"mu": "friction"})  # type: ignore[call-overload]


# Modes


def test_modes_of_symbols() -> None:
    for mode in Mode:
        assert Mode(mode.symbol) is mode is Mode(np.uint8(mode)) and (mode == "BF" or Modes(mode.symbol) == Modes.of(mode))
    assert Mode("SRO'-") is Mode.SLIDE_ROCK_O_PRIME_LEFT
    for wrong in ("slide", "sl", "", 11, None, -1):
        with pytest.raises(ValueError, match=r" is not a mode; expected RE or 0, SL or 1, RO or 2"):
            Mode(wrong)  # type: ignore[arg-type]
    for kind in (np.uint16, np.int64, int):
        assert Modes(kind(12)).modes == (Mode.ROCK_O, Mode.SLIDE_ROCK_O_LEFT) and type(Modes(kind(12))) is Modes
        assert Modes(kind(4)) is Modes.ROCK_O
    assert Modes("SL RO") == Modes.SLIDE_LEFT | Modes.ROCK_O and Modes("") == Modes(0)
    assert Mode.ROCK_O in Modes("SL RO") and Modes.SLIDE_LEFT in Modes("SL RO") and Mode.REST not in Modes("SL RO")
    assert ~Modes("SL RO") & Modes("SL RE") == Modes.REST
    for bits in (5000, -2000, np.int64(5000), 1.5, None):
        with pytest.raises(ValueError, match="is not a set of modes; expected bits from 0 to 1023, or symbols in a string"):
            Modes(bits)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="'slide' is not a mode"):
        Modes("SL slide")


def test_symbols_of_columns() -> None:
    table = frame(index=list("abcd"))
    found = standfast.symbols(standfast.classify(table))
    assert isinstance(found, pd.Series) and found.tolist() == SYMBOLS and found.index.tolist() == list("abcd")
    assert values(standfast.symbols(standfast.classify(pd.DataFrame(GAPS)))) == LEFT
    storms = standfast.symbols(standfast.classify(pl.DataFrame(GAPS)))
    assert isinstance(storms, pl.Series) and storms.to_list() == LEFT
    arrays = standfast.symbols(standfast.classify(pa.table(GAPS)))
    assert isinstance(arrays, pa.Array) and arrays.to_pylist() == LEFT
    masked = standfast.symbols(np.ma.MaskedArray([0, 9], [False, True]))
    assert type(masked) is np.ma.MaskedArray and masked.tolist() == ["RE", None]
    assert standfast.symbols([[0, 1], [2, 3]]).tolist() == [SYMBOLS[:2], SYMBOLS[2:]]
    with pytest.raises(ValueError, match="^0.5 is not the code of a mode; expected 0 to 10"):
        standfast.symbols(pd.Series([0.5]))
    with pytest.raises(TypeError, match="codes is 'SL', a str"):
        standfast.symbols("SL")
