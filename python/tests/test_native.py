"""What the native module does with columns of every kind: types, gaps, interrupts, progress, chosen columns, memory."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import textwrap
import threading
import time
from collections.abc import Callable
from decimal import Decimal
from pathlib import Path
from typing import Any

import duckdb
import numpy as np
import polars as pl
import pyarrow as pa
import pytest
import standfast
from numpy.typing import NDArray

NAMES = ("gamma", "k_prime", "k", "mu")
FIELDS = standfast.OnsetArrays._fields


def points(count: int, seed: int) -> dict[str, NDArray[np.float64]]:
    random = np.random.default_rng(seed)
    low, high = (0.3, -1.5, 0.0, 0.0), (4.0, 1.5, 3.0, 2.0)
    return {name: random.uniform(a, b, count) for name, a, b in zip(NAMES, low, high)}


# Types of Arrow


def typed(numbers: list[float | None], kind: pa.DataType) -> pa.Array:
    if pa.types.is_dictionary(kind):
        return typed(numbers, kind.value_type).dictionary_encode().cast(kind)
    if pa.types.is_decimal(kind):
        form = f"%.{min(kind.scale, 12)}f"
        return pa.array([None if x is None else Decimal(form % x) for x in numbers], kind)
    return pa.array(numbers, pa.float64()).cast(kind, safe=False)


KINDS = [
    pa.int8(), pa.int16(), pa.int32(), pa.int64(), pa.uint8(), pa.uint16(), pa.uint32(), pa.uint64(),
    pa.float16(), pa.float32(), pa.float64(),
    pa.decimal32(6, 3), pa.decimal64(12, 4), pa.decimal128(9, 2), pa.decimal128(30, 20), pa.decimal256(50, 30),
    pa.dictionary(pa.int8(), pa.float64()), pa.dictionary(pa.uint16(), pa.int32()),
    pa.dictionary(pa.int32(), pa.decimal128(10, 3)), pa.null(),
]  # fmt: skip


@pytest.mark.parametrize("kind", KINDS, ids=str)
def test_numbers_of_every_type_are_read_as_batch_reads_them(kind: pa.DataType, tmp_path: Path, program: list[str]) -> None:
    numbers: list[float | None] = [1.25, 3.0, None, 0.875, 2.125, 7.0, 0.3, 1.1] * 600
    column = pa.nulls(len(numbers)) if pa.types.is_null(kind) else typed(numbers, kind)
    table = pa.table({"gamma": [1.0] * len(numbers), "k_prime": [0.4] * len(numbers), "k": [0.9] * len(numbers), "mu": column})
    with pa.OSFile(str(tmp_path / "in.arrow"), "wb") as file, pa.ipc.new_file(file, table.schema) as writer:
        writer.write_table(table)
    command = [*program, "batch", "in.arrow", "--output-format", "arrow", "-o", "out.arrow", "--on-error", "null"]
    subprocess.run(command, cwd=tmp_path, check=True, capture_output=True)
    with pa.memory_map(str(tmp_path / "out.arrow")) as file:
        expected = pa.ipc.open_file(file).read_all()

    tables = [table, pa.concat_tables([table[:5], table[5:4099], table[4099:]])]
    if not (pa.types.is_float16(kind) or pa.types.is_decimal256(kind)):  # polars lacks these.
        tables.append(pl.DataFrame(table))
    for given in tables:
        found = pa.table(standfast.onset(given))
        for name in ("unique", "x_ddot", "theta_ddot", "f_x", "f_y", "xi"):
            assert found[name].to_pylist() == expected[name].to_pylist(), name
        named = pa.array(standfast.classify(given, names=True)).cast(pa.string())
        assert named.to_pylist() == expected["mode"].cast(pa.string()).to_pylist()
    codes = pa.array(standfast.classify(1, 0.4, 0.9, column))
    assert codes.to_pylist() == pa.array(standfast.classify(table)).to_pylist()
    assert codes.null_count == (len(numbers) if pa.types.is_null(kind) else 600)


def test_duckdbs_literals_are_decimals() -> None:
    relation = duckdb.sql("select 0.8 gamma, 0.9167 k_prime, 0.7281 k, unnest([0.6, 0.3, null]) mu")
    assert standfast.classify(relation).to_pylist() == [
        standfast.classify(0.8, 0.9167, 0.7281, 0.6), standfast.classify(0.8, 0.9167, 0.7281, 0.3), None
    ]  # fmt: skip


def test_columns_of_polars_that_hold_nothing() -> None:
    table = pl.DataFrame({"gamma": [1.0, 2.0], "k_prime": [0.4, 0.4], "k": [0.9, 0.9], "mu": [0.5, 0.5], "note": [None, None]})
    assert standfast.classify(table).to_list() == standfast.classify(table["gamma"], 0.4, 0.9, 0.5).to_list()
    assert standfast.classify(table.with_columns(mu=None)).to_list() == [None, None]
    assert standfast.classify(1, 0.4, 0.9, table["note"]).to_list() == [None, None]
    assert standfast.onset(table.with_columns(mu=None))["theta_ddot"].to_list() == [None, None]


@pytest.mark.parametrize("kind", [pa.string(), pa.bool_(), pa.date32(), pa.list_(pa.float64()), pa.dictionary(pa.int8(), pa.string())])
def test_what_is_no_number_is_refused_with_its_type(kind: pa.DataType) -> None:
    values = {pa.bool_(): [True], pa.date32(): [1], pa.list_(pa.float64()): [[1.0]]}.get(kind, ["0.5"])
    with pytest.raises(TypeError, match="mu has the Arrow type .*; expected a type of real numbers"):
        standfast.classify(1, 0.4, 0.9, pa.array(values, kind))


# Gaps


def spoiled(count: int, seed: int) -> tuple[dict[str, NDArray[np.float64]], NDArray[np.bool_]]:
    """Points of which some are impossible, in any of their numbers: alone, in runs, and at the ends."""
    values = points(count, seed)
    random = np.random.default_rng(seed)
    wrong = np.zeros(count, dtype=np.bool_)
    places = np.concatenate([random.integers(0, count, count // 50), np.arange(count // 3, count // 3 + 40), [0, count - 1]])
    for place in places:
        name = NAMES[random.integers(4)]
        values[name][place] = random.choice([np.nan, np.inf, -np.inf, 2e50] + ([-1.0] if name != "k_prime" else []))
        wrong[place] = True
    return values, wrong


@pytest.mark.parametrize("threads", [1, 3])
def test_impossible_values_have_no_answer_if_that_is_asked_for(threads: int) -> None:
    values, wrong = spoiled(40_000, 1)
    kept = {name: column[~wrong] for name, column in values.items()}
    codes = standfast.classify(**values, on_error="null", threads=threads)
    assert isinstance(codes, np.ma.MaskedArray) and np.array_equal(np.ma.getmaskarray(codes), wrong)
    assert np.array_equal(codes.compressed(), standfast.classify(**kept))
    # What is under the mask is the code of no mode, not a mode by chance.
    assert set(codes.data[wrong]) == {255}
    names = standfast.classify(**values, on_error="null", names=True)
    assert names.compressed().tolist() == standfast.classify(**kept, names=True).tolist()
    onset = standfast.onset(**values, on_error="null", threads=threads)
    for name, column, expected in zip(FIELDS, onset, standfast.onset(**kept)):
        assert np.array_equal(np.ma.getmaskarray(column), wrong) and np.array_equal(column.compressed(), expected), name
    assert np.isnan(onset.x_ddot.data[wrong]).all()
    table = pa.table(values)
    for given in (table, pa.concat_tables([table[:7], table[7:9000], table[9000:]])):
        found = pa.array(standfast.classify(given, on_error="null", threads=threads))
        assert found.to_pylist() == codes.tolist()
        motions = pa.table(standfast.onset(given, on_error="null", threads=threads))
        for name, column in zip(FIELDS, onset):
            assert motions[name].to_pylist() == column.tolist(), name


def test_where_nothing_is_wrong_the_answer_is_masked_all_the_same() -> None:
    codes = standfast.classify(1, 0.4, 0.5, np.ones(5), on_error="null")
    assert isinstance(codes, np.ma.MaskedArray) and codes.mask is np.ma.nomask
    with pytest.raises(ValueError, match="on_error is 'ignore'; expected 'raise' or 'null'"):
        standfast.classify(1, 0.4, 0.5, 0.5, on_error="ignore")  # type: ignore[call-overload]


def test_nulls_and_errors_together() -> None:
    """A null is no error, an impossible value beside it none either, and the first error after it is named."""
    mu = pa.array([0.5, None, 0.6, -1.0, -2.0])
    k = pa.array([0.5, -7.0, 0.5, 0.5, 0.5])
    with pytest.raises(ValueError, match="friction μ is -1 at index 3"):
        standfast.classify(1, 0.4, k, mu)
    assert standfast.classify(1, 0.4, k, mu, on_error="null").to_pylist() == [0, None, 0, None, None]
    assert pa.array(standfast.classify(1, 0.4, k[:3], mu[:3])).to_pylist() == [0, None, 0]


def test_masks_broadcast_and_lie_in_memory_as_the_answer_does() -> None:
    random = np.random.default_rng(3)
    k = random.uniform(0, 2, (30, 1, 50))
    mask = random.random((40, 50)) < 0.3
    mu = np.ma.MaskedArray(np.where(mask, np.nan, random.uniform(0, 1, (40, 50))), mask)
    for order in ("C", "F"):
        codes = standfast.classify(1, 0.4, np.asarray(k, order=order), mu)
        whole = np.broadcast_to(mask, (30, 40, 50))
        assert np.array_equal(codes.mask, whole)
        assert np.array_equal(codes.filled(0), np.where(whole, 0, standfast.classify(1, 0.4, k, mu.filled(0.5))))


def test_gaps_are_where_they_are_in_any_order_of_memory() -> None:
    k = np.asfortranarray(np.random.default_rng(4).uniform(0, 2, (30, 7, 50)))
    k[3, 2, 40] = k[20, 6, 0] = np.nan
    codes = standfast.classify(1, 0.4, k, 0.5, on_error="null")
    assert codes.flags.f_contiguous and np.array_equal(codes.mask, np.isnan(k))
    assert np.array_equal(standfast.onset(1, 0.4, k, 0.5, on_error="null").xi.mask, np.isnan(k))


def test_a_nan_of_polars_is_an_error_with_its_index() -> None:
    with pytest.raises(ValueError, match="friction μ is NaN at index 2; expected a number from 0 to 1e50"):
        standfast.classify(1, 0.4, 0.5, pl.Series([0.5, None, float("nan")]))


def test_a_column_twice_in_a_table() -> None:
    table = pa.Table.from_arrays([pa.array([1.0])] * 5, [*NAMES, "mu"])
    with pytest.raises(ValueError, match="the table has 2 columns mu; expected one for mu"):
        standfast.classify(table)


# Interrupts and progress

LONG = points(2_000_000, 5)
#: Points on a boundary, which take exact arithmetic: seconds in all.
ONES = np.ones(3_000_000)
#: The same for a good part of a second.
FEW = ONES[:400_000]
CALLS: dict[str, Callable[..., Any]] = {
    "classify": lambda **how: standfast.classify(1, 0.0, ONES, ONES, **how),
    "into a transposed array": lambda **how: standfast.classify(
        1, 0.0, ONES.reshape(1000, 3000), 1, out=np.zeros((3000, 1000), np.uint8).T, **how
    ),
    "onset": lambda **how: standfast.onset(1, 0.0, ONES, ONES, columns=["theta_ddot"], **how),
    "columns of Arrow": lambda **how: standfast.classify(1, 0.0, pa.array(ONES), pl.Series(ONES), **how),
    "a table with nulls": lambda **how: standfast.onset(
        pa.table({"k": pa.array(ONES, mask=np.arange(len(ONES)) % 7 == 0), "mu": ONES}), map={"gamma": 1, "k_prime": 0}, **how
    ),
    "decimals": lambda **how: standfast.classify(
        1, 0, pa.chunked_array([pa.array([Decimal("1.00")] * 50_000)] * 60), pl.Series(ONES), **how
    ),
}


@pytest.mark.parametrize("threads", [1, 2])
@pytest.mark.parametrize("call", CALLS)
def test_ctrl_c_stops_a_call(call: str, threads: int) -> None:
    """The calls take seconds; the signal comes when progress says that they are under way, and not much is done after it."""
    seen: list[tuple[int, int | None]] = []

    def interrupt(done: int, total: int | None) -> None:
        seen.append((done, total))
        if len(seen) == 1:
            os.kill(os.getpid(), signal.SIGINT)

    with pytest.raises(KeyboardInterrupt):
        CALLS[call](progress=interrupt, threads=threads)
    # Not at the end, and at the next look at the latest.
    assert 1 <= len(seen) <= 2 and 0 < seen[-1][0] < len(ONES), seen


def test_ctrl_c_leaves_what_was_done() -> None:
    """Nothing of Python runs during the call but what the signal starts."""
    out = np.full(len(ONES), 77, dtype=np.uint8)

    def interrupt() -> None:
        while out[0] == 77:
            time.sleep(0.01)
        os.kill(os.getpid(), signal.SIGINT)

    other = threading.Thread(target=interrupt)
    other.start()
    with pytest.raises(KeyboardInterrupt):
        standfast.classify(1, 0.0, ONES, ONES, out=out)
    other.join()
    done = int((out != 77).sum())
    assert 0 < done < len(out) and (out[:done] == 0).all() and (out[done:] == 77).all()


@pytest.mark.parametrize("threads", [1, 2])
def test_progress_rises_to_the_total(threads: int) -> None:
    for columns, known in [((1, 0.0, FEW, FEW), True), ((1, 0, pa.array(FEW), 1), True), ((), True), ((), False)]:
        seen: list[tuple[int, int | None]] = []
        table = pa.table({"gamma": FEW, "k": FEW, "mu": FEW})
        given = columns or (table if known else table.to_reader(),)
        start = time.monotonic()
        standfast.classify(
            *given, map=None if columns else {"k_prime": 0.0}, progress=lambda *at: seen.append(at), threads=threads
        )
        taken = time.monotonic() - start
        counts = [done for done, _ in seen]
        assert counts == sorted(counts) and seen[-1] == (len(FEW), len(FEW)) and len(seen) > 1
        assert {total for _, total in seen[:-1]} == {len(FEW) if known else None}
        assert len(seen) <= 20 * taken + 2


def test_a_short_call_reports_its_end_only() -> None:
    seen: list[tuple[int, int | None]] = []
    standfast.classify(1, 0.4, np.ones(6).reshape(2, 3), 0.5, progress=lambda *at: seen.append(at))
    assert seen == [(6, 6)]


def test_an_exception_of_progress_comes_out() -> None:
    def fail(done: int, total: int | None) -> None:
        raise LookupError(f"{done} of {total}")

    with pytest.raises(LookupError, match="5 of 5"):
        standfast.onset(1, 0.4, 0.5, np.ones(5), progress=fail)
    with pytest.raises(LookupError):
        standfast.classify(1, 0.0, ONES, ONES, progress=fail, threads=2)
    with pytest.raises(TypeError, match="progress is 3; expected"):
        standfast.classify(1, 0.4, 0.5, 0.6, progress=3)  # type: ignore[call-overload]


def test_calls_in_other_threads_report_too() -> None:
    seen: list[int] = []
    work = threading.Thread(target=lambda: standfast.classify(1, 0.0, FEW, FEW, progress=lambda done, total: seen.append(done)))
    work.start()
    work.join()
    assert len(seen) > 1 and seen[-1] == len(FEW)


@pytest.mark.parametrize("threads", [2, 5])
def test_any_number_of_threads_gives_the_same_bytes(threads: int) -> None:
    values, _ = spoiled(300_000, 9)
    for name, column, same in zip(
        FIELDS,
        standfast.onset(**values, on_error="null"),
        standfast.onset(**values, on_error="null", threads=threads, progress=lambda *at: None),
    ):
        assert column.data.tobytes() == same.data.tobytes() and np.array_equal(column.mask, same.mask), name
    table = pa.table(LONG).slice(1, 500_001)
    assert pa.array(standfast.classify(table, threads=threads)).equals(pa.array(standfast.classify(table)))


def test_operands_that_change_during_a_call() -> None:
    """What is answered is what was checked: the answer, or an error, whichever numbers are met."""
    count = 200_000
    values = points(count, 13)
    good = values["mu"].copy()
    ended = threading.Event()

    def change() -> None:
        while not ended.is_set():
            values["mu"].fill(np.nan)
            values["mu"][:] = good

    other = threading.Thread(target=change)
    other.start()
    met = 0
    try:
        for _ in range(150):
            try:
                standfast.onset(**values, columns=["theta_ddot", "others"])
            except ValueError as error:
                met += 1
                assert re.search("friction μ is NaN at index|the arrays changed while they were read", str(error))
    finally:
        ended.set()
        other.join()
    assert met > 0


def test_two_calls_into_one_array() -> None:
    out = np.zeros(len(FEW), np.uint8)
    met: list[str] = []

    def again(done: int, total: int | None) -> None:
        for part in (out, out[5:]):
            with pytest.raises(ValueError, match="out is an array that another call is writing to") as raised:
                standfast.classify(1, 0.4, 0.5, np.full(len(part), 0.1), out=part)
            met.append(str(raised.value))

    standfast.classify(1, 0.0, FEW, FEW, out=out, progress=again)
    assert met and not out.any()
    # After a call, and after one that failed, it is free.
    with pytest.raises(ValueError, match="friction"):
        standfast.classify(1, 0.4, 0.5, np.full(len(out), -1.0), out=out)
    assert (standfast.classify(1, 0.4, 0.5, np.full(len(out), 0.1), out=out) == standfast.Mode.SLIDE_LEFT).all()


# Chosen columns of an onset


def test_columns_of_an_onset_are_those_of_the_whole() -> None:
    values = points(20_000, 11)
    whole = standfast.onset(**values)
    for columns in [["theta_ddot"], ["mode", "theta_ddot"], ["others", "unique"], ["unique"], ["lift_o_prime", "mode", "f_x"], list(FIELDS)]:
        found = standfast.onset(**values, columns=columns)
        assert found._fields == tuple(columns)
        for name, column in found._asdict().items():
            assert column.dtype == getattr(whole, name).dtype and np.array_equal(column, getattr(whole, name)), name
        table = pa.table(standfast.onset(pa.table(values), columns=columns))
        assert table.column_names == columns
        assert all(np.array_equal(table[name].to_numpy(), getattr(whole, name)) for name in columns)
    with pytest.raises(AttributeError, match="f_x was not asked for"):
        found.slip, standfast.onset(**values, columns=["mode"]).f_x  # noqa: B018
    point = standfast.onset(1, 1, 2, 5, columns=["theta_ddot", "mode"])
    assert tuple(point) == (1.125, standfast.Mode.ROCK_O)


@pytest.mark.parametrize("given", [(1, 1, 2, 5), (1, 1, 2, [5, 5]), (1, 1, 2, pl.Series([5.0]))], ids=["scalars", "arrays", "Arrow"])
def test_wrong_columns(given: tuple[Any, ...]) -> None:
    with pytest.raises(ValueError, match="columns has 'force'; expected mode, unique, others, x_ddot, y_ddot, theta_ddot"):
        standfast.onset(*given, columns=["mode", "force"])
    with pytest.raises(ValueError, match="columns has 'mode' twice"):
        standfast.onset(*given, columns=["mode", "xi", "mode"])


def peak(call: str) -> float:
    """Bytes a point that a call of four columns needs, beyond those."""
    script = f"""
        from pathlib import Path
        import numpy as np, standfast
        def most():
            return int(Path("/proc/self/status").read_text().split("VmHWM:")[1].split()[0]) * 1024
        count = 2_000_000
        columns = [np.full(count, value) for value in (1.0, 0.4, 0.9, 0.5)]
        standfast.onset(*[column[:10] for column in columns])
        before = most()
        answer = {call}
        print((most() - before) / count)
    """
    found = subprocess.run([sys.executable, "-c", textwrap.dedent(script)], check=True, capture_output=True, text=True)
    return float(found.stdout)


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="the system does not tell the peak of a process")
def test_memory_is_that_of_the_columns_asked_for() -> None:
    whole = peak("standfast.onset(*columns)")
    some = peak("standfast.onset(*columns, columns=['mode', 'theta_ddot'])")
    codes = peak("standfast.classify(*columns)")
    assert some < whole / 3, (some, whole)
    # The answer and next to nothing else: 1 + 1 + 2 + 9·8, 1 + 8 and 1 bytes.
    assert 70 < whole < 80 and some < 12 and codes < 3, (whole, some, codes)
