"""Limit states: signs that decide the mode, values that are reactions, in every kind of column."""

from __future__ import annotations

import math
import os
import pickle
import signal
import threading
import time
from fractions import Fraction
from typing import Any

import numpy as np
import pandas as pd
import polars as pl
import pyarrow as pa
import pytest
import standfast
from reference import motion, points
from standfast import Mode, _inputs, _rows, _run

#: A square block in air.
CONTACT = (1, 1, 1, 2 / 3, 1, 1)

NAMES = (
    "slide", "rock_O", "rock_O_prime", "turn_O", "turn_O_prime", "slip_O_left", "slip_O_right", "slip_O_prime_left",
    "slip_O_prime_right", "load_factor", "SF_sliding", "SF_overturning",
)  # fmt: skip


def by_signs(s: standfast.LimitStatesArrays) -> np.ndarray:
    """The table of the docstring."""
    lines = [
        ((s.slide >= 0) & (s.rock_O >= 0) & (s.rock_O_prime >= 0), Mode.REST),
        ((s.slide < 0) & (s.turn_O >= 0) & (s.turn_O_prime >= 0), Mode.SLIDE_LEFT),
        ((s.rock_O_prime < 0) & (s.slip_O_prime_left >= 0), Mode.ROCK_O_PRIME),
        (s.turn_O_prime < 0, Mode.SLIDE_ROCK_O_PRIME_LEFT),
        (s.slip_O_left < 0, Mode.SLIDE_ROCK_O_LEFT),
        (s.slip_O_right < 0, Mode.SLIDE_ROCK_O_RIGHT),
    ]
    return np.select([holds for holds, _ in lines], [mode for _, mode in lines], Mode.ROCK_O)


def test_signs_decide_the_mode() -> None:
    columns = np.array(points(150_000, 5)).T
    modes = standfast.classify(*columns)
    assert set(np.unique(modes)) == {0, 1, 2, 3, 4, 5, 6}
    assert np.array_equal(by_signs(standfast.limit_states(*columns)), modes)


def test_values_are_places_of_reactions_and_reserves_of_friction() -> None:
    for point in points(600, 6):
        states = standfast.limit_states(*point)
        mu, k = Fraction(point[3]), Fraction(point[2])
        rest, slide, rock, beyond = (motion(symbol, *point) for symbol in ("RE", "SL", "RO", "RO'"))
        expected = {
            "slide": mu - k,
            "rock_O": 1 + rest["xi"],
            "rock_O_prime": 1 - rest["xi"],
            "turn_O": 1 + slide["xi"],
            "turn_O_prime": 1 - slide["xi"],
            "slip_O_left": mu * rock["f_y"] - rock["f_x"],
            "slip_O_right": mu * rock["f_y"] + rock["f_x"],
            "slip_O_prime_left": mu * beyond["f_y"] - beyond["f_x"],
            "slip_O_prime_right": mu * beyond["f_y"] + beyond["f_x"],
        }
        for name, value in expected.items():
            found = getattr(states, name)
            scale = 1 + sum(abs(x) for x in point) ** 3
            assert abs(found - value) <= 1e-13 * scale, (point, name)
            assert (found > 0) - (found < 0) == (value > 0) - (value < 0), (point, name)
        factors = [states.SF_sliding, states.SF_overturning]
        assert states.load_factor == min(factors)
        if point[2] > 0:
            assert factors[0] == pytest.approx(point[3] / point[2], rel=1e-14)
            leaves = standfast.explain(*point).leaves_rest
            assert leaves is None or states.load_factor * point[2] == pytest.approx(leaves.at, rel=1e-12, abs=1e-300)


def test_to_the_right_corners_are_exchanged() -> None:
    left, right = (standfast.limit_states(1.3, -0.4, 1.7, 0.9, to=to) for to in ("left", "right"))
    swapped = {
        "rock_O": "rock_O_prime", "turn_O": "turn_O_prime", "slip_O_left": "slip_O_prime_right", "slip_O_right": "slip_O_prime_left",
    }  # fmt: skip
    swapped |= {other: name for name, other in swapped.items()}
    for name in NAMES:
        assert getattr(right, name) == getattr(left, swapped.get(name, name))


def test_every_kind_of_column() -> None:
    k = [0.5, 0.75, math.nan]
    expected = standfast.limit_states(1, 0.4, k[:2], 0.6)
    frame = pd.DataFrame({"k": k, "friction": 0.6}, index=["a", "b", "c"])
    found = standfast.limit_states(frame, map={"gamma": 1, "k_prime": 0.4, "mu": "friction"}, columns=["rock_O", "slide"])
    assert list(found.columns) == ["rock_O", "slide"] and list(found.index) == ["a", "b", "c"]
    assert np.array_equal(found["rock_O"][:2], expected.rock_O) and found.loc["c"].isna().all()
    null = pl.DataFrame({"k": [0.5, 0.75, None], "mu": 0.6})
    found = standfast.limit_states(null, map={"gamma": 1, "k_prime": 0.4})
    assert isinstance(found, pl.DataFrame) and found.columns == list(NAMES)
    assert found["slide"].to_list() == [*expected.slide, None]
    table = standfast.limit_states(1, 0.4, pa.array([0.5, 0.75]), 0.6, columns=["load_factor"])
    assert isinstance(table, pa.Table) and table["load_factor"].to_pylist() == expected.load_factor.tolist()
    masked = standfast.limit_states(1, 0.4, np.ma.MaskedArray([0.5, -1], [False, True]), 0.6)
    assert masked.slide.tolist() == [expected.slide[0], None]
    point = standfast.limit_states(1, 0.4, np.float32(0.5), 0.6, columns=["slide"])
    assert point == (0.6 - 0.5,) and type(point.slide) is float
    assert pickle.loads(pickle.dumps(expected)).slide.tolist() == expected.slide.tolist()
    assert standfast.limit_states(1, 0.4, np.empty((0, 3)), 0.6).slide.shape == (0, 3)


def test_blocks_and_threads_make_no_difference() -> None:
    k = np.linspace(0, 3, 200_003)
    friction = np.array([[0.3], [0.7]])
    one, many = (standfast.limit_states(2, -0.3, k[::-1], friction, threads=threads) for threads in (1, 3))
    for name in NAMES:
        assert np.array_equal(getattr(one, name), getattr(many, name))
    assert one.slide.shape == (2, 200_003) and np.array_equal(one.slide, friction - k[::-1])


def test_progress_is_told() -> None:
    told: list[tuple[int, int | None]] = []
    standfast.limit_states(1, 0.3, np.full(300_000, 0.7), 0.6, progress=lambda done, total: told.append((done, total)))
    assert told[-1] == (300_000, 300_000)


@pytest.mark.parametrize("threads", [1, 2])
@pytest.mark.parametrize("function", [standfast.limit_states, standfast.contact])
def test_ctrl_c_stops_a_call(function: Any, threads: int) -> None:
    """The calls take seconds, each point of them on a boundary and exact; the signal comes from beside when progress has said that they
    are under way."""
    k = np.broadcast_to(0.5, 50_000_000)
    points = (1, 1, k, 0.6), ["rock_O"]
    operands, columns = points if function is standfast.limit_states else ((*CONTACT, k, 1, 0.1, 0.6, 0.6), ["mode"])
    seen: list[int] = []

    def interrupt() -> None:
        while not seen:
            time.sleep(0.01)
        os.kill(os.getpid(), signal.SIGINT)

    other = threading.Thread(target=interrupt)
    other.start()
    with pytest.raises(KeyboardInterrupt):
        function(*operands, columns=columns, threads=threads, progress=lambda done, total: seen.append(done))
    other.join()
    assert 0 < seen[-1] < len(k)


@pytest.mark.parametrize(
    ("given", "error", "words"),
    [
        (dict(mu=-0.1), ValueError, "friction μ is -0.1; expected a number from 0 to 1e50"),
        (dict(mu=[[0.1, 0.2], [0.3, -0.1]]), ValueError, r"friction μ is -0.1 at index \(1, 1\); expected"),
        (dict(k=[*[0.1] * 100_000, math.inf]), ValueError, "force k is inf at index 100000; expected"),
        (dict(columns=["slip"]), ValueError, "columns has 'slip'.* slide, rock_O"),
        (dict(columns={"mu": "friction"}), TypeError, "map="),
        (dict(to="up"), ValueError, "to is 'up'; expected 'left' or 'right'"),
        (dict(k=pd.Series([1.0]), mu=pd.Series([1.0], index=[3])), ValueError, "index"),
    ],
)
def test_wrong_input(given: dict[str, object], error: type[Exception], words: str) -> None:
    with pytest.raises(error, match=words):
        standfast.limit_states(**({"gamma": 1, "k_prime": 0.4, "k": 0.5, "mu": 0.6} | given))


def test_impossible_values_may_be_left_out() -> None:
    found = standfast.limit_states(1, 0.4, [0.5, -1, math.nan], 0.6, on_error="null")
    assert found.slide.tolist() == [0.6 - 0.5, None, None]
    found = standfast.limit_states(pl.DataFrame({"k": [0.5, -1.0], "mu": 0.6, "gamma": 1, "k_prime": 0}), on_error="null")
    assert found["load_factor"].to_list() == [1.2, None]


def unaligned(values: list[float]) -> np.ndarray:
    """An array one byte off the places where float64 lies."""
    memory = bytearray(8 * len(values) + 1)
    array = np.ndarray(len(values), buffer=memory, offset=1)
    array[:] = values
    assert not array.flags.aligned
    return array


def test_operands_may_lie_anywhere() -> None:
    k = [0.5, 0.75, 3.0]
    found, expected = (standfast.limit_states(1, 0.4, forces, 0.6) for forces in (unaligned(k), k))
    assert found.slide.tolist() == expected.slide.tolist() and found.rock_O.tolist() == expected.rock_O.tolist()
    found, expected = (standfast.contact(*CONTACT, forces, 1, 0.2, 0.6, 0.6) for forces in (unaligned(k), k))
    assert found.mode.tolist() == expected.mode.tolist() and found.x_ddot.tolist() == expected.x_ddot.tolist()


def test_all_processors_have_work(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("os.cpu_count", lambda: 3)
    k = np.linspace(0, 3, 200_003)
    sizes: list[int] = []
    one, all_ = (
        standfast.limit_states(2, -0.3, k, 0.7, threads=threads, columns=["slide", "rock_O"]) for threads in (1, None)
    )
    assert np.array_equal(one.slide, all_.slide) and np.array_equal(one.rock_O, all_.rock_O)
    operands = _inputs.read("limit_states", ("k", "mu"), (k, 0.7))
    for threads in (1, None, 1000):
        sizes.clear()

        def solve(block: list[np.ndarray], out: object, wrong: object) -> None:
            sizes.append(block[0].size)

        _rows.answer(operands, {}, solve, _run.run(threads))
        assert sum(sizes) == k.size
        assert sizes[0] == {1: _rows._BLOCK, None: 3 * _rows._BLOCK, 1000: k.size}[threads]


def test_no_points_are_told_too() -> None:
    for function, operands in (
        (standfast.classify, (1, 0.4, [], 0.6)),
        (standfast.onset, (1, 0.4, [], 0.6)),
        (standfast.limit_states, (1, 0.4, [], 0.6)),
        (standfast.contact, (*CONTACT, [], 1, 0.2, 0.6, 0.6)),
    ):
        told: list[tuple[int, int | None]] = []
        function(*operands, progress=lambda done, total: told.append((done, total)))
        assert told == [(0, 0)], function


def test_one_alone_is_that_of_all() -> None:
    """Each limit state, asked for by itself, is that among all of them, near boundaries and on them, for a force to either side."""
    rng = np.random.default_rng(5)
    gamma, k_prime, k, mu = rng.uniform([[0.3], [-1.5], [0.0], [0.0]], [[4], [1], [3], [1.5]], (4, 2000))
    k[:500], mu[500:700] = np.round(k[:500], 1), np.round(mu[500:700], 1)
    gamma[:300], mu[:300] = 1.0, np.round(mu[:300], 1)
    for to in ("left", "right"):
        together = standfast.limit_states(gamma, k_prime, k, mu, to=to)
        for name in NAMES:
            alone = standfast.limit_states(gamma, k_prime, k, mu, columns=[name], to=to)
            assert np.array_equal(getattr(alone, name), getattr(together, name)), name
