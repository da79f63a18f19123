"""How far long work is: what is told of it, what that changes, and how it ends before its end."""

import signal
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import standfast

EXAMPLES = Path(__file__).parents[2] / "examples"
STORM, RANDOM = EXAMPLES / "goda-2000-storm.toml", EXAMPLES / "goda-2000-random.toml"
PULSE, CAISSON = EXAMPLES / "motion/block-base-pulse.toml", EXAMPLES / "goda-2000.toml"
COLUMN = EXAMPLES / "probability/column-records.toml"
SHAKEN = {"unit": "g", "dt": 0.01, "records": [np.sin(np.arange(200) / 9), np.cos(np.arange(200) / 7)]}

Long = Callable[..., Any]

#: Each with what is compared of its answer.
LONG: dict[str, Long] = {
    "a storm": lambda **told: standfast.probability(STORM, samples=1 << 14, **told).to_json(),
    "draws of modes": lambda **told: standfast.probability(RANDOM, method="monte-carlo", samples=1 << 16, **told).to_json(),
    "a fragility": lambda **told: standfast.probability(RANDOM, over="width=18 m..22 m:3", samples=1 << 12, **told).to_json(),
    "records": lambda **told: standfast.probability(COLUMN, over="pga=0.2 g..0.4 g:2", samples=1 << 12, **SHAKEN, **told).to_json(),
    "a width": lambda **told: standfast.design(CAISSON, vary="width", target="factor=1.2", **told).to_json(),
    "a curve": lambda **told: standfast.design(CAISSON, vary="width", target="factor=1.2", and_="friction", **told).to_json(),
    "a motion": lambda **told: standfast.simulate(PULSE, strength=True, **told).to_json(),
    "rocking": lambda **told: standfast.spectrum(PULSE, "rocking", size="1..4:9", **told).to_json(),
    "sliding": lambda **told: standfast.spectrum(PULSE, "newmark", **told).to_json(),
    "overturning": lambda **told: standfast.spectrum(PULSE, "overturning", **told).to_json(),
    "a sheet": lambda **told: standfast.sheet(RANDOM, **told),
}


@pytest.mark.parametrize("name", LONG)
def test_shares_rise_to_the_whole_and_change_nothing(name: str) -> None:
    told: list[tuple[int, int | None]] = []
    answer = LONG[name](progress=lambda done, total: told.append((done, total)))
    assert told[-1] == (1000, 1000) and {total for _, total in told} == {1000}
    assert told == sorted(told)
    assert answer == LONG[name]()


@pytest.mark.parametrize("name", LONG)
def test_an_exception_ends_the_work(name: str) -> None:
    def fail(done: int, total: int | None) -> None:
        raise KeyError("enough")

    with pytest.raises(KeyError, match="enough"):
        LONG[name](progress=fail)
    with pytest.raises(TypeError, match="progress is 3; expected True"):
        LONG[name](progress=3)


def storm(**told: Any) -> standfast.Probability:
    """Storms that take far longer than a test."""
    return standfast.probability(STORM, samples=1 << 26, **told)


def test_a_storm_is_told_while_it_lasts() -> None:
    """Of seconds of work more is told than its end, and who has heard enough waits no longer."""
    told: list[int] = []

    def until(done: int, total: int | None) -> None:
        told.append(done)
        if done >= 20:
            raise StopIteration

    began = time.monotonic()
    threads = threading.active_count()
    with pytest.raises(StopIteration):
        storm(progress=until)
    assert told[-1] < 100 and told == sorted(told) and len(told) > 1
    assert time.monotonic() - began < 60 and threading.active_count() == threads
    # What had begun ends too, and then takes no processor any more: a busy machine may need longer for it.
    until_idle = time.monotonic() + 60
    while True:
        spent = time.process_time()
        time.sleep(0.5)
        if time.process_time() - spent < 0.25:
            break
        assert time.monotonic() < until_idle


@pytest.mark.skipif(sys.platform == "win32", reason="a signal to oneself ends the process there")
@pytest.mark.parametrize("told", [{}, {"progress": lambda done, total: None}])
def test_a_key_interrupts_it(told: dict[str, Any]) -> None:
    timer = threading.Timer(0.5, lambda: signal.raise_signal(signal.SIGINT))
    timer.start()
    began = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        storm(**told)
    assert time.monotonic() - began < 10


def test_a_bar(capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("tqdm")
    standfast.design(CAISSON, vary="width", target="factor=1.2", progress=True)
    shown = capsys.readouterr().err
    assert "100%" in shown and "1000" not in shown and "it/s" not in shown
