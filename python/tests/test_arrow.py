"""Arrow in and out: pyarrow, polars, pandas, DuckDB."""

from __future__ import annotations

from typing import Any

import duckdb
import numpy as np
import pandas as pd
import polars as pl
import pyarrow as pa
import pytest
import standfast

ROWS = 10_000


@pytest.fixture(scope="module")
def values() -> dict[str, Any]:
    random = np.random.default_rng(8)
    low, high = (0.3, -1.5, 0.0, 0.0), (4, 1.5, 3, 2)
    names = ("gamma", "k_prime", "k", "mu")
    return {name: random.uniform(a, b, ROWS) for name, a, b in zip(names, low, high)}


@pytest.fixture(scope="module")
def codes(values: dict[str, Any]) -> list[int]:
    found: list[int] = standfast.classify(**values).tolist()
    return found


def tables(values: dict[str, Any]) -> dict[str, Any]:
    whole = pa.table(values)
    chunked = pa.concat_tables([whole[:3], whole[3:3], whole[3:7000], whole[7000:]])
    return {
        "pyarrow": whole,
        "pyarrow in chunks": chunked,
        "record batch": whole.to_batches()[0],
        "reader": chunked.to_reader(),
        "polars": pl.DataFrame(values),
        "pandas": pd.DataFrame(values),
        "duckdb": duckdb.sql("select * from whole"),
    }


@pytest.mark.parametrize("kind", tables({"a": [1.0]}))
def test_tables(kind: str, values: dict[str, Any], codes: list[int]) -> None:
    found = standfast.classify(tables(values)[kind], threads=2)
    assert pa.array(found).to_pylist() == codes and pl.Series(found).dtype == pl.UInt8
    assert len(found) == ROWS
    onset = pa.table(standfast.onset(tables(values)[kind]))
    expected = standfast.onset(**values)
    assert onset.column_names == list(expected._fields)
    for name, column in zip(expected._fields, expected):
        assert np.array_equal(onset[name].to_numpy(), column), name


def test_columns_of_a_table(values: dict[str, Any], codes: list[int]) -> None:
    renamed = pa.table({"γ": values["gamma"], "k": values["k"], "friction": values["mu"]})
    found = standfast.classify(renamed, map={"gamma": "γ", "mu": "friction", "k_prime": 0.4})
    expected = standfast.classify(values["gamma"], 0.4, values["k"], values["mu"])
    assert pa.array(found).to_pylist() == expected.tolist()
    with pytest.raises(KeyError, match=r"the table has no column k_prime for k_prime; it has γ, k, friction."):
        standfast.classify(renamed, map={"gamma": "γ", "mu": "friction"})
    with pytest.raises(ValueError, match="map has the key 'slenderness'; expected gamma, k_prime, k, mu"):
        standfast.classify(renamed, map={"slenderness": "γ"})
    with pytest.raises(TypeError, match="map is for a table"):
        standfast.classify(1, 0.4, 0.5, 0.6, map={})
    with pytest.raises(TypeError, match=r"map gives \['k'\] for k; expected the name of a column, or a number"):
        standfast.classify(renamed, map={"k": ["k"]})  # type: ignore[dict-item]


def columns(values: dict[str, Any]) -> dict[str, list[Any]]:
    whole = pa.table(values)
    cut = pa.concat_tables([whole[:5], whole[5:4000], whole[4000:]])
    other = pa.concat_tables([whole[:3000], whole[3000:]])
    return {
        "pyarrow": [whole[name].chunk(0) for name in values],
        "chunks": [cut["gamma"], other["k_prime"], whole["k"].chunk(0), cut["mu"]],
        "sliced": [pa.concat_arrays([pa.array([9.0]), whole[name].chunk(0)])[1:] for name in values],
        "polars": list(pl.DataFrame(values)),
        "own": [whole["gamma"], pl.Series(values["k_prime"]), whole["k"], pl.Series(values["mu"])],
    }


@pytest.mark.parametrize("kind", columns({name: [1.0] * 5000 for name in ("gamma", "k_prime", "k", "mu")}))
def test_columns(kind: str, values: dict[str, Any], codes: list[int]) -> None:
    given = columns(values)[kind]
    assert pa.array(standfast.classify(*given)).to_pylist() == codes
    assert pl.Series(standfast.classify(*given, threads=None)).to_list() == codes
    onset = pl.DataFrame(standfast.onset(*given))
    assert np.array_equal(onset["theta_ddot"].to_numpy(), standfast.onset(**values).theta_ddot)


def test_columns_of_one_row() -> None:
    one = [pl.Series([value]) for value in (1.0, 1.0, 2.0, 5.0)]
    assert pl.Series(standfast.classify(*one)).to_list() == [2]
    assert pl.Series(standfast.classify(*(pa.array([value]) for value in (1.0, 1.0, 2.0, 5.0)))).to_list() == [2]


def test_columns_beside_numbers(values: dict[str, Any]) -> None:
    friction = pl.Series(values["mu"])
    found = standfast.classify(1, np.float32(0.5), 0.75, friction)
    assert pl.Series(found).to_list() == standfast.classify(1, 0.5, 0.75, values["mu"]).tolist()
    beside = standfast.classify(1, 0.4, values["k"], friction)
    assert beside.to_list() == standfast.classify(1, 0.4, values["k"], values["mu"]).tolist()
    with pytest.raises(ValueError, match=r"k has the shape \(9999,\) beside columns of 10000 rows"):
        standfast.classify(1, 0.4, values["k"][1:], friction)
    with pytest.raises(ValueError, match="different lengths: k 10000, mu 9999"):
        standfast.classify(1, 0.4, friction, friction[1:])


def test_nulls_stay_nulls() -> None:
    table = pa.table(
        {
            "gamma": pa.array([1.0, None, 1.0, 1.0, 1.0]),
            "k_prime": [1.0] * 5,
            "k": [2.0] * 5,
            "mu": pa.array([5.0, 5.0, None, 0.1, 5.0]),
        }
    )
    in_chunks = pa.concat_tables([table[:1], table[1:3], table[3:]])
    for given in (table, in_chunks, pl.DataFrame(table), table.to_batches()[0]):
        assert pa.array(standfast.classify(given)).to_pylist() == [2, None, None, 3, 2]
        onset = pa.table(standfast.onset(given))
        assert onset["theta_ddot"].to_pylist()[:3] == [1.125, None, None]
        assert onset["unique"].to_pylist() == [True, None, None, True, True]
    names = pl.Series(standfast.classify(table, names=True))
    assert names.to_list() == ["RO", None, None, "SRO-", "RO"]
    assert standfast.classify(table, names=True).type == pa.dictionary(pa.uint8(), pa.string())


@pytest.mark.parametrize("kind", [pa.float16(), pa.float32(), pa.int8(), pa.int64(), pa.uint16()])
def test_types_of_numbers(kind: Any) -> None:
    numbers = np.array([1, 2, 3, 1, 4])
    column = pa.array(numbers).cast(pa.float32()).cast(kind)
    assert pa.array(standfast.classify(1, 0.4, column, 2)).to_pylist() == standfast.classify(1, 0.4, numbers, 2).tolist()


def test_wrong_values_and_types() -> None:
    mu = pa.chunked_array([[0.5, 0.6], [0.7, -1.0]])
    with pytest.raises(ValueError, match="^friction μ is -1 at index 3; expected a number from 0 to 1e50$"):
        standfast.classify(1, 0.4, 0.5, mu)
    with pytest.raises(ValueError, match="at index 3"):
        standfast.onset(pa.table({"gamma": [1.0] * 4, "k_prime": [1.0] * 4, "k": [1.0] * 4, "mu": mu}))
    with pytest.raises(TypeError, match="mu has the Arrow type Utf8"):
        standfast.classify(1, 0.4, 0.5, pa.array(["a"]))
    with pytest.raises(TypeError, match="out is for plain arrays"):
        standfast.classify(1, 0.4, 0.5, mu, out=np.zeros(4, dtype=np.uint8))


def test_empty_tables() -> None:
    empty = pa.table({name: pa.array([], pa.float64()) for name in ("gamma", "k_prime", "k", "mu")})
    assert pa.array(standfast.classify(empty)).to_pylist() == []
    assert pa.table(standfast.onset(empty)).num_rows == 0
    assert pa.array(standfast.classify(1, 1, 1, pa.array([], pa.float64()))).to_pylist() == []


def test_a_column_is_read_where_it_lies() -> None:
    """No copy of the columns: the memory taken is that of the answer."""
    rows = 4_000_000
    k = pa.array(np.full(rows, 0.5))
    before = pa.total_allocated_bytes()
    import resource

    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    ballast = np.ones(rows)  # As large as one column: a copy would not fit into what is freed below.
    del ballast
    peak = max(peak, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
    answer = standfast.classify(1, 0.4, k, k)
    assert pa.total_allocated_bytes() == before
    grown = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - peak
    assert len(answer) == rows and grown < 24 * 1024, f"{grown} KiB"


def test_pandas_columns_are_arrays(values: dict[str, Any], codes: list[int]) -> None:
    frame = pd.DataFrame(values)
    frame["mode"] = standfast.classify(frame.gamma, frame.k_prime, frame.k, frame.mu)
    assert frame["mode"].tolist() == codes and frame["mode"].dtype == pd.UInt8Dtype()


def test_duckdb_reads_the_answer(values: dict[str, Any]) -> None:
    onset = standfast.onset(pa.table(values))
    rows = duckdb.sql("select count(*) from onset where mode = 2").fetchall()
    assert rows[0] == (int((standfast.classify(**values) == 2).sum()),)
