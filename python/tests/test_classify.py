"""classify and onset on scalars and numpy arrays."""

from __future__ import annotations

import inspect
import itertools
import pickle
import threading
import time
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import reference
import standfast
from numpy.typing import NDArray
from standfast import Mode, Modes, Onset, _standfast

BY_SYMBOL = {mode.symbol: mode for mode in Mode}
POINTS = reference.points(6000, seed=1)


@pytest.fixture(scope="module")
def columns() -> list[NDArray[np.float64]]:
    return list(np.array(POINTS).T.copy())


@pytest.fixture(scope="module")
def codes() -> NDArray[np.uint8]:
    return np.array([BY_SYMBOL[reference.mode(*point)] for point in POINTS], dtype=np.uint8)


def test_modes_are_those_of_the_library() -> None:
    native = _standfast.modes()
    snake = ["".join("_" + c if c.isupper() else c for c in name).upper().lstrip("_") for name, _, _ in native]
    assert [mode.name for mode in Mode] == snake
    assert [int(mode) for mode in Mode] == list(range(len(native)))
    assert [(mode.symbol, mode.words) for mode in Mode] == [(symbol, words) for _, symbol, words in native]
    assert [(m.name, int(m)) for m in Modes] == [(mode.name, 1 << mode) for mode in Mode if mode != "BF"]
    assert Modes.of(*list(Mode)[:-1]).modes == tuple(Mode)[:-1] and list(Mode)[-1] == "BF"


def test_modes_pickle() -> None:
    for value in [Mode.ROCK_O, Modes.ROCK_O | Modes.SLIDE_LEFT, standfast.onset(1, 1, 2, 5)]:
        assert pickle.loads(pickle.dumps(value)) == value


def test_every_mode_agrees_with_the_reference(columns: list[Any], codes: NDArray[np.uint8]) -> None:
    assert len(set(codes.tolist())) == 7
    assert np.array_equal(standfast.classify(*columns), codes)
    assert [standfast.classify(*point) for point in POINTS[:500]] == [Mode(code) for code in codes[:500]]


def test_onset_agrees_with_the_reference(columns: list[Any], codes: NDArray[np.uint8]) -> None:
    found = standfast.onset(*columns)
    assert np.array_equal(found.mode, codes)
    several = 0
    for i, point in enumerate(POINTS):
        others = Modes.of(*(BY_SYMBOL[symbol] for symbol in reference.others(*point)))
        several += bool(others)
        assert (Modes(int(found.others[i])), found.unique[i]) == (others, not others), point
        for name, value in reference.motion(Mode(codes[i]).symbol, *point).items():
            # What cancels is known to 40 bits of the terms it is the difference of.
            size = 1 + point[2] + point[3] + abs(value)
            assert abs(Fraction(float(getattr(found, name)[i])) - value) <= size * Fraction(1, 2**36), (name, point)
    assert several > 20


def test_onset_of_a_point() -> None:
    found = standfast.onset(1.0, -0.5, 4.0, 3.0)
    assert found[:3] == (Mode.SLIDE_LEFT, False, Modes.ROCK_O)
    assert isinstance(found, Onset) and isinstance(found.f_y, float)
    # The report's worked point, in closed form.
    assert standfast.onset(1, 1, 2, 5)[3:8] == (-1.125, 1.125, 1.125, 0.875, 2.125)


@pytest.mark.parametrize(
    "shapes",
    [
        [(), (), (), ()],
        [(1,), (), (7,), (1,)],
        [(3, 1, 5), (4, 1), (), (5,)],
        [(2, 3, 1, 2), (3, 4, 1), (4, 2), (2, 1, 1, 1)],
        [(0,), (1,), (), (0,)],
        [(3, 0, 2), (1, 2), (3, 1, 1), ()],
        [(1, 1), (1,), (), (1, 1, 1)],
        [(90, 1, 3), (70, 1), (), (90, 70, 3)],
    ],
)
def test_broadcasting_is_numpys(shapes: list[tuple[int, ...]]) -> None:
    random = np.random.default_rng(3)
    low, high = (0.3, -1.5, 0.0, 0.0), (4, 1.5, 3, 2)
    operands = [np.asarray(random.uniform(a, b, shape)) for a, b, shape in zip(low, high, shapes)]
    whole = np.broadcast_arrays(*operands)
    flat = [np.ravel(operand).copy() for operand in whole]
    expected = standfast.classify(*flat).reshape(whole[0].shape)
    found = standfast.classify(*operands)
    assert np.shape(found) == whole[0].shape and np.array_equal(found, expected)
    motion = standfast.onset(*operands)
    for column, expected in zip(motion, standfast.onset(*flat)):
        assert np.array_equal(column, np.reshape(expected, whole[0].shape))


LAYOUTS: dict[str, Any] = {
    "C": np.ascontiguousarray,
    "Fortran": np.asfortranarray,
    "every other": lambda a: np.repeat(a, 2, axis=-1)[..., ::2],
    "reversed": lambda a: a[::-1, :, ::-1].copy()[::-1, :, ::-1],
    "a part": lambda a: np.pad(a, 3)[3:-3, 3:-3, 3:-3],
    "transposed": lambda a: np.ascontiguousarray(a.transpose(1, 2, 0)).transpose(2, 0, 1),
    "unaligned": lambda a: np.frombuffer(b"x" + a.tobytes(), dtype=a.dtype.str, offset=1).reshape(a.shape),
    "byte-swapped": lambda a: a.astype(a.dtype.newbyteorder()),
    "a field": lambda a: np.rec.fromarrays([a, a > 0], names="a,b")["a"],
    "read-only": lambda a: np.broadcast_to(a, a.shape),
}


@pytest.mark.parametrize("layout", LAYOUTS)
def test_memory_layouts(layout: str) -> None:
    random = np.random.default_rng(4)
    shape = (17, 29, 11)
    low, high = (0.3, -1.5, 0.0, 0.0), (4, 1.5, 3, 2)
    operands = [random.uniform(a, b, shape) for a, b in zip(low, high)]
    expected = standfast.classify(*operands)
    assert len(np.unique(expected)) > 4
    laid = [LAYOUTS[layout](operand) for operand in operands]
    assert all(np.array_equal(a, b) for a, b in zip(operands, laid))
    for choice in itertools.product([False, True], repeat=4):
        mixed = [b if chosen else a for a, b, chosen in zip(operands, laid, choice)]
        assert np.array_equal(standfast.classify(*mixed), expected)
    for ours, plain in zip(standfast.onset(*laid), standfast.onset(*operands)):
        assert np.array_equal(ours, plain)


def test_the_answer_lies_in_memory_as_the_operands_do() -> None:
    fortran = np.asfortranarray(np.full((30, 40), 0.5))
    assert standfast.classify(1, 0.4, fortran, fortran).flags.f_contiguous
    middle = np.full((4, 5, 6), 0.5).transpose(1, 2, 0)
    strides = standfast.classify(1, 0.4, middle, 0.6).strides
    assert np.argsort(strides).tolist() == np.argsort(middle.strides).tolist()


@pytest.mark.parametrize("dtype", ["f2", "f4", "f8", "g", "i1", "i2", "i4", "i8", "u1", "u2", "u4", "u8", "O"])
def test_dtypes(dtype: str) -> None:
    whole = np.random.default_rng(5).integers(1, 60, (4, 5000))
    values = whole if np.dtype(dtype).kind in "iu" else whole / 8
    operands = values.astype(dtype)
    expected = standfast.classify(*values.astype(np.float64))
    assert len(np.unique(expected)) > 1
    assert np.array_equal(standfast.classify(*operands), expected)
    assert np.array_equal(standfast.classify(*operands[:, ::3]), expected[::3])


def test_what_counts_as_a_number() -> None:
    point = (1, 0.4, 0.5, 0.6)
    for kind in [np.float32, np.float64, np.array, Fraction, Decimal, lambda x: [x][0]]:
        assert standfast.classify(*map(kind, point)) is Mode.REST
    assert standfast.classify([1], [0.4], [0.5], [0.6]).tolist() == [0]
    for wrong, words in [
        (True, "mu has dtype bool"),
        (1j, "mu has dtype complex128"),
        ("0.6", "mu is '0.6', a str; expected a number"),
        ({}, "mu is {}, a dict; expected a number"),
        (np.datetime64("2020-01-01"), "mu has dtype datetime64"),
    ]:
        with pytest.raises(TypeError, match=words):
            standfast.classify(1, 0.4, 0.5, wrong)


@pytest.mark.parametrize("threads", [2, 3, 16, None])
def test_the_answer_does_not_depend_on_threads(threads: int | None) -> None:
    random = np.random.default_rng(6)
    low, high = (0.3, -1.5, 0.0, 0.0), (4, 1.5, 3, 2)
    operands: list[Any] = [random.uniform(a, b, (3, 200_003)) for a, b in zip(low, high)]
    operands[1] = operands[1][:, ::-1]
    assert np.array_equal(standfast.classify(*operands), standfast.classify(*operands, threads=threads))
    few = [operand[:, :20_000] for operand in operands]
    for one, many in zip(standfast.onset(*few), standfast.onset(*few, threads=threads)):
        assert np.array_equal(one, many)
    operands[3][1, 150_000:] = np.nan
    operands[2][2, 7] = -1
    with pytest.raises(ValueError, match=r"friction μ is NaN at index \(1, 150000\); expected a number from 0 to 1e50"):
        standfast.classify(*operands, threads=threads)


@pytest.mark.parametrize("threads", [0, -1, 1.5, "2", True])
def test_wrong_numbers_of_threads(threads: Any) -> None:
    with pytest.raises(ValueError, match="expected a whole number above zero, or None"):
        standfast.classify(1, 0.4, 0.5, 0.6, threads=threads)


def test_errors_name_value_and_index() -> None:
    for function in (standfast.classify, standfast.onset):
        with pytest.raises(ValueError, match=r"^friction μ is -0.5; expected a number from 0 to 1e50$"):
            function(1, 0.4, 0.5, -0.5)
        with pytest.raises(ValueError, match=r"^slenderness γ is 0 at index 2; expected a number above zero"):
            function([1, 2, 0], 0.4, 0.5, 0.5)
        with pytest.raises(ValueError, match=r"^elevation k' is -1e300 at index 1; expected a number from -1e50 to 1e50$"):
            function(1, [0.4, -1e300], 0.5, 0.5)
        # The first in the order of C, whatever the order in memory.
        k = np.asfortranarray(np.full((300, 400), 0.5))
        k[7, 300], k[8, 0] = np.inf, -2
        with pytest.raises(ValueError, match=r"^force k is inf at index \(7, 300\); expected a number from 0 to 1e50$"):
            function(1, 0.4, k, 0.5)
        with pytest.raises(ValueError, match=r"gamma \(3,\), k_prime \(\), k \(4,\), mu \(2, 1\)"):
            function(np.ones(3), 0.4, np.ones(4), np.ones((2, 1)))
        with pytest.raises(TypeError, match="k, mu missing"):
            function(1, 0.4)


def test_out() -> None:
    mu = np.linspace(0, 2, 24).reshape(4, 6)
    expected = standfast.classify(1, 0.4, 0.8, mu)
    whole = np.zeros((8, 12), dtype=np.uint8)
    for out in [
        np.zeros((4, 6), dtype=np.uint8),
        np.zeros((4, 6), dtype=np.uint8, order="F"),
        np.zeros((6, 4), dtype=np.uint8).T,
        whole[::2, ::2],
        whole[4:, 6:][::-1],
    ]:
        out[...] = 255
        assert standfast.classify(1, 0.4, 0.8, mu, out=out) is out
        assert np.array_equal(out, expected)
    scalar = np.zeros((), dtype=np.uint8)
    assert standfast.classify(1, 0.4, 0.8, 0.6, out=scalar) is scalar
    assert scalar == standfast.classify(1, 0.4, 0.8, 0.6)


def test_out_may_be_an_operand() -> None:
    friction = np.arange(6, dtype=np.uint8)
    expected = standfast.classify(1, 0.4, 2.5, friction)
    standfast.classify(1, 0.4, 2.5, friction, out=friction)
    assert np.array_equal(friction, expected)
    memory = np.linspace(0, 2, 1000)
    expected = standfast.classify(1, 0.4, 0.8, memory)
    out = memory.view(np.uint8)[:1000]
    assert np.array_equal(standfast.classify(1, 0.4, 0.8, memory, out=out), expected)


def test_wrong_outs() -> None:
    mu = np.ones(5)
    with pytest.raises(ValueError, match=r"out has shape \(4,\); expected \(5,\)"):
        standfast.classify(1, 0.4, 0.5, mu, out=np.zeros(4, dtype=np.uint8))
    with pytest.raises(TypeError, match="out is an array of int8; expected a numpy array of uint8"):
        standfast.classify(1, 0.4, 0.5, mu, out=np.zeros(5, dtype=np.int8))
    with pytest.raises(TypeError, match="out is a list"):
        standfast.classify(1, 0.4, 0.5, mu, out=[0] * 5)
    with pytest.raises(TypeError, match="together with names"):
        standfast.classify(1, 0.4, 0.5, mu, out=np.zeros(5, dtype=np.uint8), names=True)
    read_only = np.zeros(5, dtype=np.uint8)
    read_only.flags.writeable = False
    with pytest.raises(ValueError, match="out is read-only"):
        standfast.classify(1, 0.4, 0.5, mu, out=read_only)


def test_names() -> None:
    assert standfast.classify(1, 0.4, 0.5, 0.6, names=True) == "RE"
    found = standfast.classify(3, 0.8, [[0.1, 0.5], [3, 3]], 0.1, names=True)
    assert found.tolist() == [["RE", "SRO-"], ["SRO+", "SRO+"]]
    with pytest.raises(ValueError, match="11 is not the code of a mode; expected 0 to 10"):
        standfast.symbols([3, 11])
    with pytest.raises(ValueError, match="-1 is not"):
        standfast.symbols(-1)


def test_other_threads_run_meanwhile() -> None:
    """The GIL is released: a thread counts on while one call works."""
    mu = np.full(3_000_000, 0.5)
    ticks: list[float] = []
    stop = threading.Event()

    def tick() -> None:
        while not stop.is_set():
            ticks.append(time.monotonic())
            time.sleep(0.001)

    counter = threading.Thread(target=tick)
    counter.start()
    start = time.monotonic()
    standfast.onset(1, 0.4, 0.7, mu)
    end = time.monotonic()
    stop.set()
    counter.join()
    middle = [at for at in ticks if start + 0.2 * (end - start) < at < end - 0.2 * (end - start)]
    assert len(middle) > 5, (len(ticks), end - start)


def test_no_memory_is_kept() -> None:
    import sys

    operands = [np.full(1000, 0.5) for _ in range(4)]
    before = [sys.getrefcount(operand) for operand in operands]
    for _ in range(10):
        standfast.classify(*operands)
        standfast.onset(*operands)
    with pytest.raises(ValueError, match="friction"):
        standfast.classify(*operands[:3], -operands[3])
    assert [sys.getrefcount(operand) for operand in operands] == before


def test_signatures_have_no_positional_options() -> None:
    for function in (standfast.classify, standfast.onset):
        kinds = [p.kind for p in inspect.signature(function).parameters.values()]
        assert all(kind is inspect.Parameter.KEYWORD_ONLY for kind in kinds[4:])


def test_out_holds_every_answer() -> None:
    out = np.zeros(2, dtype=np.uint8)
    with pytest.raises(TypeError, match="out .*cannot be given together with on_error='null'"):
        standfast.classify(1, 0.4, [0.5, -1], 0.6, out=out, on_error="null")
    with pytest.raises(TypeError, match="out is a MaskedArray; expected a numpy array of uint8"):
        standfast.classify(1, 0.4, [0.5, 0.7], 0.6, out=np.ma.masked_array(out, [True, False]))


def test_out_may_be_a_file(tmp_path: Path) -> None:
    out = np.memmap(tmp_path / "modes", dtype=np.uint8, mode="w+", shape=2)
    assert standfast.classify(1, 0.4, [0.5, 3], 0.6, out=out) is out
    assert out.tolist() == standfast.classify(1, 0.4, [0.5, 3], 0.6).tolist()
