"""What an operand may be: what is refused says what to do, and doing that works."""

from __future__ import annotations

import array
import re
import subprocess
import sys
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from typing import Any

import dask
import dask.array as da
import dask.dataframe as dd
import duckdb
import numpy as np
import pandas as pd
import pint
import polars as pl
import pyarrow as pa
import pyarrow.dataset
import pytest
import standfast
import xarray as xr
from standfast import Mode, _inputs
from standfast._run import Run

NAMES = ("gamma", "k_prime", "k", "mu")
POINTS = {"gamma": [1.0, 3.0, 1.0, 3.0], "k_prime": [0.4, 0.8, 1.0, 0.8], "k": [0.5, 0.1, 2.0, 0.5], "mu": [0.6, 0.05, 5.0, 0.05]}
MODES = [Mode.REST, Mode.SLIDE_LEFT, Mode.ROCK_O, Mode.SLIDE_ROCK_O_LEFT]
#: θ̈ of the third point, from the report's worked example.
THETA_DDOT = 1.125


def refused(words: str, *operands: Any, function: Callable[..., Any] = standfast.classify, **options: Any) -> str:
    """The error for operands, which holds these words."""
    with pytest.raises((TypeError, ValueError, KeyError)) as raised:
        function(*operands, **options)
    message = str(raised.value)
    assert words in message, message
    return message


def advised(message: str, dots: str) -> str:
    """What a message says to call, with something in the place of its dots."""
    call = re.search(r"Call (.*\))", message)
    assert call is not None, message
    return call.group(1).replace("...", dots)


# Named dimensions, lazy collections


def test_xarray_in_memory() -> None:
    force = xr.DataArray(POINTS["k"], dims="storm", coords={"storm": list("abcd")})
    friction = xr.DataArray([0.3, 0.6], dims="bed")
    message = refused("k is an xarray object", 3, 0.8, force, friction)
    assert "lazy" not in message and "ask" not in message
    found = eval(advised(message, "3, 0.8, force, friction"), {"xarray": xr, "standfast": standfast, **locals()})
    assert found.dims == ("storm", "bed") and found.storm.values.tolist() == list("abcd")
    assert np.array_equal(found, standfast.classify(3, 0.8, np.array(POINTS["k"])[:, None], [0.3, 0.6]))
    message = refused("k is an xarray object", 1, 1, force, 5, function=standfast.onset)
    motion = eval(advised(message, "1, 1, force, 5"), {"xarray": xr, "standfast": standfast, **locals()})
    assert motion.dims == ("storm",) and motion.sel(storm="c") == THETA_DDOT
    refused("k is an xarray object", 3, 0.8, force.variable, 1)
    points = xr.Dataset({name: ("storm", column) for name, column in POINTS.items()})
    message = refused("the table is an xarray Dataset; its variables go in one by one", points)
    dots = "*(points[name] for name in ('gamma', 'k_prime', 'k', 'mu'))"
    found = eval(advised(message, dots), {"xarray": xr, "standfast": standfast, "points": points})
    assert found.values.tolist() == MODES


def test_xarray_of_dask() -> None:
    force = xr.DataArray(da.from_array(np.array(POINTS["k"]), chunks=2), dims="storm")
    message = refused("dask='parallelized'", 1, 1, force, 5)
    names: dict[str, Any] = {"xarray": xr, "standfast": standfast, "np": np, "force": force}
    found = eval(advised(message, "1, 1, force, 5"), names)
    assert found.chunks is not None and found.dtype == np.uint8
    assert found.values.tolist() == standfast.classify(1, 1, POINTS["k"], 5).tolist()
    message = refused("dask='parallelized'", 1, 1, force, 5, function=standfast.onset)
    assert eval(advised(message, "1, 1, force, 5"), names).values[2] == THETA_DDOT


def test_dask_arrays() -> None:
    force = da.from_array(np.array(POINTS["k"]), chunks=2)
    names: dict[str, Any] = {"dask": dask, "standfast": standfast, "np": np, "force": force}
    message = refused("k is a dask Array, which is lazy", 1, 1, force, 5)
    found = eval(advised(message, "1, 1, force, 5"), names)
    assert found.dtype == np.uint8 and found.compute().tolist() == standfast.classify(1, 1, POINTS["k"], 5).tolist()
    message = refused("k is a dask Array, which is lazy", 1, 1, force, 5, function=standfast.onset)
    assert eval(advised(message, "1, 1, force, 5"), names).compute()[2] == THETA_DDOT
    later = dask.delayed(0.5)
    refused("which is lazy and would be loaded whole. Call .compute() first", 1, 0.4, later, 0.6)
    assert standfast.classify(1, 0.4, later.compute(), 0.6) is Mode.REST


def test_dask_frames() -> None:
    frame = pd.DataFrame(POINTS, index=list("abcd")).rename(columns={"mu": "friction"})
    frame = dd.from_pandas(frame, npartitions=2)
    for function in (standfast.classify, standfast.onset):
        message = refused("the table is a dask DataFrame, which is lazy", frame, function=function)
        call = advised(message.replace("{...}", "{'mu': 'friction'}"), "").split("(")[0]
        assert "map={'mu': 'friction'}" in message.replace("{...}", "{'mu': 'friction'}")
        found = eval(call, {"frame": frame})(function, map={"mu": "friction"}).compute()
        assert found.index.tolist() == list("abcd")
        assert (found if function is standfast.classify else found["mode"]).tolist() == MODES
    columns = [frame.gamma, frame.k_prime, frame.k, frame.friction]
    message = refused("gamma is a dask Series, which is lazy", *columns)
    assert "dask.dataframe.map_partitions(standfast.classify, ...)" in message
    modes = dd.map_partitions(standfast.classify, *columns)
    assert modes.name == "mode" and modes.compute().tolist() == MODES
    # A column of the frame, computed where the frame lies.
    frame["mode"] = modes
    assert frame[frame["mode"] == Mode.ROCK_O].compute().index.tolist() == ["c"]


def test_frames_of_polars_that_hold_no_values() -> None:
    storms = pl.DataFrame(POINTS)
    assert refused("the table is a polars LazyFrame", storms.lazy()).endswith("Call .collect()")
    assert standfast.classify(storms.lazy().collect()).to_list() == MODES
    refused("k is a polars LazyFrame", 1, 0.4, storms.lazy(), 0.6)
    message = refused("k is a polars expression, which holds no values", 1, 0.4, pl.col("k"), 0.6)
    found = eval(advised(message, ""), {"frame": storms, "standfast": standfast})
    assert found["mode"].to_list() == MODES


def test_data_sets_of_pyarrow() -> None:
    data = pyarrow.dataset.dataset(pa.table(POINTS))
    message = refused("the table is a pyarrow Dataset", data)
    assert ".to_table()" in message and ".scanner().to_reader()" in message
    message = refused("the table is a pyarrow Scanner", data.scanner())
    assert ".to_table()" in message and ".to_reader()" in message
    for given in (data.to_table(), data.scanner().to_reader(), data.scanner().to_table()):
        assert standfast.classify(given).to_pylist() == MODES
    refused("k is a pyarrow Dataset", 1, 0.4, data, 0.6)


def test_relations_of_duckdb() -> None:
    relation = duckdb.from_arrow(pa.table(POINTS))
    assert standfast.classify(relation).to_pylist() == MODES
    assert standfast.classify(relation.project("gamma as g, k_prime, k, mu"), map={"gamma": "g"}).to_pylist() == MODES


# Units


def test_quantities_of_astropy() -> None:
    """Ratios are read as those of pint, and what has a unit is refused with what to give."""
    u = pytest.importorskip("astropy.units")
    ratios = [1, 400 * u.mm / u.m, 500 * u.kN / (1000 * u.kN), [0.6, 600] * u.Unit("1") * [1, 1e-3]]
    assert standfast.classify(*ratios).tolist() == [0, 0]
    refused("mu is a quantity of astropy, in m; expected a ratio, which has no unit", 1, 0.4, 0.5, [0.6] * u.m)
    block = {"body": {"width": 1, "height": 2, "mass": 4800, "friction": 0.7}, "load": [{"force": 20e3, "elevation": 1.5}]}
    with pytest.raises(TypeError, match=r'width is a quantity of astropy, in m; expected numbers, with the unit behind the name: "width \[m\]" and value\.value'):
        standfast.assess_table(block, {"width": [1, 2] * u.m})
    with pytest.raises(ValueError, match=r'body.width is a quantity of astropy, in m; expected a text with its unit, as "15 m"'):
        standfast.assess({"body": {"width": 15 * u.m}})
    for base, dt, words in (([0, 1] * u.m / u.s**2, 1, r"base is .*; expected its \.value, and unit='m/s2'"), ([0, 1], 0.01 * u.s, "dt is .*; expected its .value, in seconds")):
        with pytest.raises(TypeError, match=words):
            standfast.simulate({"body": block["body"]}, base=base, dt=dt, unit="m/s2")


def test_quantities_of_pint() -> None:
    unit = pint.UnitRegistry()
    point = [1, unit.Quantity(400, "mm/m"), unit.Quantity(50, "percent"), unit.Quantity(0.6)]
    assert standfast.classify(*point) is standfast.classify(1, 0.4, 0.5, 0.6)
    # 250 mm in a metre would rest as 250, and slide as 0.25.
    friction = unit.Quantity([250.0, 2500.0], "mm/m")
    assert standfast.classify(1, 0.4, 0.5, friction).tolist() == standfast.classify(1, 0.4, 0.5, [0.25, 2.5]).tolist() == [1, 0]
    refused("mu is a quantity of pint, in meter; expected a ratio, which has no unit", 1, 0.4, 0.5, unit.Quantity([0.6], "m"))
    refused("gamma is a quantity of pint, in kilonewton", unit.Quantity(1, "kN"), 0.4, 0.5, 0.6)
    # A friction angle is no coefficient of friction, though pint finds no dimension in it.
    refused("mu is a quantity of pint, in degree; expected a ratio", 1, 0.4, 0.5, unit.Quantity(31, "degree"))
    message = refused("mu is <Quantity(250.0, 'millimeter / meter')>, a Quantity at index 0", 1, 0.4, 0.5, list(friction))
    assert "Quantity.from_list" in message
    assert standfast.classify(1, 0.4, 0.5, unit.Quantity.from_list(list(friction))).tolist() == [1, 0]


def test_other_arrays_with_units() -> None:
    """An array of a class of its own with a unit, as astropy's and unyt's, is not read without it."""

    class Quantity(np.ndarray):
        unit = "m"

    refused("in m; expected a ratio, which has no unit", 1, 0.4, 0.5, np.ones(3).view(Quantity))


# Tables in the wrong place, wrong columns


def test_tables_beside_other_operands() -> None:
    tables = {"pandas": pd.DataFrame(POINTS), "polars": pl.DataFrame(POINTS), "pyarrow": pa.table(POINTS)}
    for library, table in tables.items():
        message = refused(f"gamma is a {library} ", table, 0.4, 0.5, 0.6)
        assert "a whole table; expected a column of it. standfast.classify takes a table alone, with map={...}" in message
        refused(f"k is a {library} ", 1, 0.4, table, 0.6, function=standfast.onset)
        alone = standfast.classify(table, map={"k_prime": 0.4, "k": 0.5, "mu": 0.6})
        assert pl.Series(alone).to_list() == standfast.classify(POINTS["gamma"], 0.4, 0.5, 0.6).tolist()
    refused("gamma is a pandas DataFrame", tables["pandas"][["gamma"]], 0.4, 0.5, 0.6)


def test_columns_of_two_libraries() -> None:
    frame, storms = pd.DataFrame(POINTS), pl.DataFrame(POINTS)
    message = refused("gamma is a pandas Series, mu is a polars Series; expected columns of one library", frame.gamma, 1, 1, storms["mu"])
    assert "to_pandas()" in message and "polars.from_pandas" in message
    there, here = storms["mu"].to_pandas(), pl.from_pandas(frame.gamma)
    assert standfast.classify(frame.gamma, 1, 1, there).tolist() == standfast.classify(here, 1, 1, storms["mu"]).to_list()


TABLES: dict[str, Callable[[dict[str, Any]], Any]] = {
    "pandas": pd.DataFrame,
    "polars": pl.DataFrame,
    "pyarrow": pa.table,
    "duckdb": lambda columns: duckdb.from_arrow(pa.table(columns)),
}


@pytest.mark.parametrize("library", TABLES)
def test_no_operand_is_taken_for_another(library: str) -> None:
    """What a table lacks is not in the column of another operand, whichever function is called."""
    inputs = ("b1", "b2", "d", "rho2", "m_x", "m_y", "x", "p", "m", "mu_s", "mu_k")
    for lacking, another in [("mu_k", "mu_s"), ("m_x", "m_y")]:
        table = TABLES[library]({name: [0.5] for name in inputs if name != lacking})
        message = refused(f"the table has no column {lacking} for {lacking}", table, function=standfast.contact)
        assert "did you mean" not in message and f'map={{"{lacking}": …}}' in message and another in message
    table = TABLES[library]({"MU_k" if name == "mu_k" else name: [0.5] for name in inputs})
    assert 'did you mean MU_k? Then say map={"mu_k": "MU_k"}' in refused("no column mu_k", table, function=standfast.contact)


def test_the_advice_is_of_the_function_that_was_called() -> None:
    frame = pl.DataFrame(POINTS)
    for function in (standfast.onset, standfast.limit_states):
        message = refused("gamma is a polars expression", pl.col("gamma"), 0.4, 0.5, 0.6, function=function)
        found = eval(advised(message, "").split(", or")[0], {"standfast": standfast, "frame": frame})
        assert found.columns == frame.columns + function(frame).columns
    message = refused("codes is a polars expression", pl.col("codes"), function=standfast.symbols)
    codes = pl.DataFrame({"mode": [0, 1]})
    found = eval(advised(message, "").split(", or")[0], {"standfast": standfast, "frame": codes})
    assert found["symbol"].to_list() == ["RE", "SL"]

    lazy = da.from_array(np.array([0, 5]), chunks=1)
    message = refused("codes is a dask Array", lazy, function=standfast.symbols)
    found = eval(advised(message, "lazy"), {"dask": dask, "standfast": standfast, "np": np, "lazy": lazy})
    assert found.dtype == "<U5" and found.compute().tolist() == ["RE", "SRO'-"]
    row = (1.0, 1.0, 0.5, 1.0, 1.0, 1.0, 0.0, 1.0, 0.0, 0.5, da.from_array(np.array([0.4, 0.5]), chunks=1))
    message = refused("mu_k is a dask Array", *row, function=standfast.contact)
    found = eval(advised(message, "*row"), {"dask": dask, "standfast": standfast, "np": np, "row": row})
    assert found.dtype == np.uint8 and found.compute().tolist() == standfast.contact(*row[:-1], [0.4, 0.5]).mode.tolist()
    for table in (frame, pd.DataFrame(POINTS), pa.table(POINTS)):
        assert "map" not in refused("a whole table; expected", 1, 0.4, table, 0.5, function=standfast.explain)
    for value in (xr.DataArray([0.5]), lazy, pl.col("k")):
        assert "apply_ufunc" not in refused("k is a", 1, 0.4, value, 0.5, function=standfast.explain)
    assert "map" not in refused("a whole table; expected a column of it", codes.lazy().collect(), function=standfast.symbols)


@pytest.mark.parametrize("library", TABLES)
def test_wrong_columns(library: str) -> None:
    def table(**names: str) -> Any:
        return TABLES[library]({names.get(name, name): column for name, column in POINTS.items()})

    message = refused("the table has no column mu for mu; it has gamma, k_prime, k, friction", table(mu="friction"))
    assert 'map={"mu": "friction"}' in message
    assert pl.Series(standfast.classify(table(mu="friction"), map={"mu": "friction"})).to_list() == MODES
    assert 'map={"gamma": "gama"}' in refused("no column gamma", table(gamma="gama"))
    assert 'map={"k": "Force"}' in refused("no column k for k", table(k="Force"))
    message = refused("no column frction for mu", table(mu="friction"), map={"mu": "frction"})
    assert "did you mean friction?" in message and 'map={"mu": "friction"}' in message
    assert 'map={"mu": …}' in refused("no column mu", table(mu="zzz"))
    refused("map has the key 'friction'; expected gamma, k_prime, k, mu", table(), map={"friction": "mu"})
    refused("map gives True for mu; expected the name of a column, or a number", table(), map={"mu": True})
    refused("map gives ['mu'] for mu", table(), map={"mu": ["mu"]})
    refused("map is a set; expected a dict of columns, as {'mu': 'friction'}", table(), map={"mu"})
    refused("map names no column of the table, only numbers", table(), map={name: 1 for name in NAMES})
    refused("slenderness γ is -1", table(), map={"gamma": -1})
    refused("map is for a table", 1, 0.4, 0.5, 0.6, map={})
    refused("out is for plain arrays", table(), out=np.zeros(4, dtype=np.uint8))


def test_columns_of_one_name() -> None:
    twice = pd.concat([pd.DataFrame(POINTS), pd.DataFrame({"mu": [9.0] * 4})], axis=1)
    assert refused("the table has 2 columns", twice).endswith("expected one for mu")
    assert standfast.classify(twice, map={"mu": 0.6}).tolist() == standfast.classify(**{**POINTS, "mu": 0.6}).tolist()
    table = pa.table(POINTS).append_column("mu", pa.array([9.0] * 4))
    for given in (table, table.to_reader()):
        refused("columns mu", given)
    # One that is not asked for may be there twice.
    other = pd.concat([pd.DataFrame(POINTS), pd.DataFrame([["x", "y"]] * 4, columns=["note", "note"])], axis=1)
    assert standfast.classify(other).tolist() == MODES


def test_columns_of_levels() -> None:
    levels = pd.concat({"storm": pd.DataFrame(POINTS)}, axis=1)
    assert standfast.classify(levels, map={name: ("storm", name) for name in NAMES}).tolist() == MODES
    refused("no column mu", levels["storm"].drop(columns="mu"))


def test_missing_operands() -> None:
    expected = "expected gamma, k_prime, k, mu, or one table with these columns"
    assert expected in refused("k, mu missing", 1, 0.4)
    for one in (pd.Series([1.0]), pl.Series([1.0]), pa.array([1.0]), np.ones(3), 1.0, [1.0]):
        assert expected in refused("k_prime, k, mu missing", one)
    assert "unpack a dict: standfast.classify(**columns)" in refused("missing", POINTS)
    assert standfast.classify(**POINTS).tolist() == MODES


# Values


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        (["0.5", 1], "mu is '0.5', a str at index 0; expected real numbers"),
        ([["0.5"], [1]], "mu is '0.5', a str at index (0, 0)"),
        (np.array([1, "0.5"], dtype=object), "mu is '0.5', a str at index 1"),
        (pd.Series([1, "0.5"], dtype=object), "mu is '0.5', a str at index 1"),
        (np.array(["0.5"]), "mu has dtype <U3; expected real numbers"),
        ("0.6", "mu is '0.6', a str; expected a number, an array or a column"),
        (True, "mu has dtype bool"),
        (np.True_, "mu has dtype bool"),
        (np.array([True]), "mu has dtype bool"),
        ([True, 0.5], "mu is True, a bool at index 0"),
        ([np.True_, 0.5], " at index 0; expected real numbers"),
        (np.array([True, 0.5], dtype=object), "mu is True, a bool at index 0"),
        (pd.Series([0.5, True], dtype=object), "mu is True, a bool at index 1"),
        (pl.Series([True]), "mu has the Arrow type Boolean"),
        (pl.Series(["0.5"]), "mu has the Arrow type Utf8"),
        (pa.array(["0.5"]).dictionary_encode(), "mu has the Arrow type Dictionary"),
        (pd.Series(["0.5"], dtype="category"), "; expected real numbers"),
        (1j, "mu has dtype complex128"),
        ([1j, 1], "mu is 1j, a complex at index 0"),
        (np.array([1j], dtype=object), "mu is 1j, a complex at index 0"),
        (np.datetime64("2020-01-01"), "mu has dtype datetime64"),
        (np.array(["2020"], dtype="M8[D]"), "mu has dtype datetime64[D]"),
        (np.array([1], dtype="m8[s]"), "mu has dtype timedelta64[s]"),
        (np.zeros(2, dtype=[("a", "f8"), ("b", "f8")]), "mu has dtype [('a'"),
        ([0.5, None], "mu is None at index 1; expected real numbers; what is missing is masked in a masked array, or null"),
        (np.array([0.5, None]), "mu is None at index 1"),
        ([[1.0, 2.0], [3.0]], "mu is a ragged list; expected rows of one length"),
        ([1.0, [2.0]], "mu is a ragged list"),
        ([pd.Series([1.0])], "a Series at index 0"),
        ([np.ma.MaskedArray([1.0, 2.0], [True, False])], "mu at index 0 is a masked array in a list; expected one masked array"),
        ([0.5, np.ma.masked], "mu at index 1 is a masked array in a list"),
        ([np.array([True]), np.array([0.5])], "mu at index 0 has dtype bool"),
        ({"a": 1}, "mu is {'a': 1}, a dict"),
        ({1.0}, "mu is {1.0}, a set"),
        (iter([1.0]), "a list_iterator; expected a number"),
        (b"1", "mu is b'1', a bytes"),
        (pd.NA, "mu is <NA>, a NAType"),
        (object(), "an object; expected real numbers"),
        ([10**400], "mu holds what is not a number within float64"),
        (10**400, "expected a number within float64"),
        (np.nan, "friction μ is NaN; expected"),
        ([0.5, np.nan], "friction μ is NaN at index 1"),
        (pd.Series([0.5, np.inf]), "friction μ is inf at index 1"),
        (duckdb.sql("select 0.6 as mu"), "mu has the Arrow type Struct"),
    ],
    ids=repr,
)
def test_what_is_no_real_number(wrong: Any, words: str) -> None:
    for function in (standfast.classify, standfast.onset):
        given = iter([1.0]) if hasattr(wrong, "__next__") else wrong
        refused(words, 1, 0.4, 0.5, given, function=function)


def test_a_constant_that_is_nan_is_an_error_beside_pandas() -> None:
    """NaN is missing in pandas' own columns only."""
    force = pd.Series([0.5, np.nan])
    refused("friction μ is NaN", 1, 0.4, force, np.nan)
    refused("friction μ is NaN at index 1", 1, 0.4, force.fillna(0.5), np.array([0.5, np.nan]))
    refused("friction μ is NaN", pd.DataFrame(POINTS), map={"mu": np.nan})


def test_what_is_a_real_number() -> None:
    expected = standfast.classify(1, 0.4, 0.5, [0.5, 1.0, 2.0]).tolist()
    numbers: list[Any] = [
        [Decimal("0.5"), Fraction(1), 2],
        (0.5, np.float32(1), np.int8(2)),
        np.array([Decimal("0.5"), 1, 2.0], dtype=object),
        array.array("d", [0.5, 1, 2]),
        memoryview(np.array([0.5, 1, 2])),
        np.array([0.5, 1, 2]).astype(">f8"),
        [np.array(0.5), np.array(1.0), 2],
    ]
    for given in numbers:
        assert standfast.classify(1, 0.4, 0.5, given).tolist() == expected, given
    assert standfast.classify(1, 0.4, 0.5, range(1, 3)).tolist() == expected[1:]
    assert standfast.classify(1, 0.4, 0.5, [np.array([0.5, 1]), [1.0, 2]]).tolist() == [expected[:2], expected[1:]]
    assert standfast.classify(1, 0.4, 0.5, [10**30]).tolist() == [Mode.REST]


def test_libraries_are_not_imported() -> None:
    """Who does not use pandas, polars or pyarrow does not wait for them."""
    program = """
import sys, numpy, standfast
standfast.classify([1, 2], 0.4, numpy.ma.masked_array([0.5, 1], [0, 1]), 0.6, names=True)
standfast.onset(1, 0.4, [0.5], 0.6)
try: standfast.classify("no", 1, 1, 1)
except TypeError: pass
wrong = {"pandas", "polars", "pyarrow", "xarray", "dask", "pint", "matplotlib", "tqdm"} & set(sys.modules)
assert not wrong, wrong
"""
    subprocess.run([sys.executable, "-c", program], check=True)


# The interface for the functions of this package


def test_arrays_and_what_is_missing() -> None:
    frame = pd.DataFrame({"a": [1.0, np.nan, 3.0], "b": [4, 5, 6]}, index=list("xyz"))
    operands = _inputs.read("f", ("a", "b"), (frame, None))
    (a, b), missing = operands.arrays()
    assert a.tolist() == [1, 1, 3] and b is not None and b.dtype.kind == "i" and missing is not None
    assert missing.tolist() == [False, True, False] and operands.shape == (3,)
    (a, b), _ = operands.arrays(together=True)
    assert a.tolist() == [1, 1, 3] and b.tolist() == [4, 1, 6]
    (a, b), missing, how = operands.native(Run(1))
    assert np.shares_memory(a, frame.a.to_numpy()) and missing is None and how.nan_is_missing
    # Beside a plain array NaN says nothing, so that it has to be told apart before.
    (a, b), missing, how = _inputs.read("f", ("a", "b"), (frame.a, np.ones(3))).native(Run(1))
    assert not how.nan_is_missing and missing is not None and missing.tolist() == [False, True, False]
    for table in (pl.DataFrame({"a": [1, None, 3], "b": [4, 5, 6]}), pa.table({"a": [1, None, 3], "b": [4, 5, 6]})):
        operands = _inputs.read("f", ("a", "b"), (table, None), {"b": 7})
        (a, b), missing = operands.arrays()
        assert a.tolist() == [1, 1, 3] and b.tolist() == 7 and missing is not None and missing.tolist() == [False, True, False]
    # Several columns, some of whose values are missing on their own.
    answer = _inputs.read("f", ("a", "b"), (frame, None)).form.table(
        {"mode": np.ma.MaskedArray(np.array([0, 1, 2], dtype=np.uint8), [True, False, False]), "word": np.array(["p", "q", "r"]), "xi": np.ones(3)},
        np.array([False, True, False]),
        point=standfast.Onset,
        arrays=standfast.OnsetArrays,
    )
    assert answer.xi.dtype == np.float64 and answer.xi.isna().tolist() == [False, True, False]
    assert answer.index.tolist() == list("xyz") and answer["mode"].isna().tolist() == [True, True, False]
    assert answer.word.isna().tolist() == [False, True, False] and answer.word["x"] == "p"
    for table in (pl.DataFrame(frame.to_dict("list")), pa.table(frame)):
        made = _inputs.read("f", ("a", "b"), (table, None)).form.table(
            {"word": np.array(["p", "q", "r"]), "flag": np.array([True, False, True])},
            np.array([False, True, False]),
            point=standfast.Onset,
            arrays=standfast.OnsetArrays,
        )
        assert list(made["word"].to_pylist() if hasattr(made["word"], "to_pylist") else made["word"]) == ["p", None, "r"]


# Labels and categories of pandas


def test_labels_may_be_numbers() -> None:
    frame = pd.DataFrame(dict(enumerate(POINTS.values())))
    assert standfast.classify(frame, map=dict(zip(NAMES, range(4)))).tolist() == MODES
    assert standfast.classify(frame, map={"gamma": 0, "k_prime": 1, "k": np.int64(2), "mu": 9}).tolist() == (
        standfast.classify(*list(POINTS.values())[:3], 9).tolist()
    )
    # Beside a label 2 the number is 2.0.
    assert standfast.classify(frame, map={"gamma": 0, "k_prime": 1, "k": 2.0, "mu": 3}).tolist() == (
        standfast.classify(POINTS["gamma"], POINTS["k_prime"], 2, POINTS["mu"]).tolist()
    )
    refused("map gives True for k", frame, map={"gamma": 0, "k_prime": 1, "k": True, "mu": 3})
    day = pd.Timestamp("2026-11-21")
    dated = frame.rename(columns={3: day})
    assert standfast.classify(dated, map={"gamma": 0, "k_prime": 1, "k": 2, "mu": day}).tolist() == MODES


def test_a_map_takes_every_number() -> None:
    table = {"k": [0.5, 0.75], "mu": [0.6, 0.9]}
    for frame in (pd.DataFrame(table), pl.DataFrame(table), pa.table(table)):
        found = standfast.classify(frame, map={"gamma": Fraction(1), "k_prime": Decimal("0.4")})
        assert list(np.asarray(found)) == standfast.classify(1, 0.4, table["k"], table["mu"]).tolist()
        refused("gamma is 1000000000", frame, map={"gamma": 10**400, "k_prime": 0.4})


def test_categories_of_whole_numbers_may_be_missing() -> None:
    expected = standfast.classify(1, 0.4, [1, 2], 0.6).tolist()
    for categories in (pd.Categorical([1, 2, None]), pd.Categorical(pd.array([1, 2, None], dtype="Int64"))):
        found = standfast.classify(1, 0.4, pd.Series(categories), 0.6)
        assert found[:2].tolist() == expected and found[2] is pd.NA
    found = standfast.classify(1, 0.4, pd.Categorical([1, 2, None]), 0.6)
    assert found.tolist() == [*expected, None]


def test_indexes_with_na() -> None:
    index = pd.Index(["a", pd.NA, "c"], dtype=object)
    force = pd.Series([0.5, 0.5, 0.5], index=index)
    refused("differ: at row 2, 'c' and 'd'", 1, 0.4, force, pd.Series(0.6, index=pd.Index(["a", pd.NA, "d"], dtype=object)))
    refused("differ: at row 1, <NA> and 'b'", 1, 0.4, force, pd.Series(0.6, index=pd.Index(["a", "b", "c"], dtype=object)))
    pairs = [pd.MultiIndex.from_tuples([("a", 1), ("b", last)]) for last in (pd.NA, 2)]
    refused("differ: at row 1", 1, 0.4, pd.Series(0.5, index=pairs[0]), pd.Series(0.6, index=pairs[1]))


# Advice for whoever asked


def test_advice_is_that_of_the_function() -> None:
    frame = pl.DataFrame(POINTS)
    names: dict[str, Any] = {"standfast": standfast, "frame": frame, "dask": dask, "np": np, "xarray": xr}
    mode = pl.col("mode")
    for function, given in (
        (standfast.classify, (mode,) * 4), (standfast.onset, (mode,) * 4), (standfast.limit_states, (mode,) * 4),
        (standfast.symbols, (mode,)),
    ):  # fmt: skip
        message = refused("is a polars expression", *given, function=function)
        call = re.search("Call (.*), or give", message)
        assert call is not None and f"standfast.{function.__name__}(" in call[1]
        names["frame"] = frame.with_columns(mode=standfast.classify(frame)) if function is standfast.symbols else frame
        assert eval(call[1], names).height == 4
    codes = da.from_array(np.array([0, 1], dtype=np.uint8), chunks=1)
    found = eval(advised(refused("lazy", codes, function=standfast.symbols), "codes"), names | {"codes": codes})
    assert found.compute().tolist() == ["RE", "SL"] and found.dtype == found.compute().dtype
    force = da.from_array(np.array([-0.2, -2.0]), chunks=1)
    given = (1, 1, 1, 2 / 3, 1, 1, force, 1, 0, 0.5, 0.4)
    found = eval(advised(refused("lazy", *given, function=standfast.contact), "*given"), names | {"given": given})
    assert found.compute().tolist() == [0, 1] and found.dtype == np.uint8
    for column in (xr.DataArray([0.5]), da.ones(3), mode):
        message = refused("", 1, 0.4, column, 0.6, function=standfast.explain)
        assert "apply_ufunc" not in message and "map_blocks" not in message and "(frame)" not in message
    assert "map=" not in refused("a whole table", frame, function=standfast.symbols)
    case = {"body": {"width": 1, "height": 2, "mass": 4800, "friction": 0.7}, "load": [{"force": 2e3, "elevation": 1}]}
    for column in (da.ones(3), mode):
        message = refused("friction is a", case, {"friction": column}, function=standfast.assess_table)
        assert "map_blocks" not in message and "(frame)" not in message
