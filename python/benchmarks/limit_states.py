"""limit_states on ten million points against numpy's single expressions and against onset; ratios of medians, taken in one run.

    python python/benchmarks/limit_states.py          (build standfast by release)

Every work makes its answer anew, as a user's call does. All take turns, ROUNDS times; the second of two calls counts. They are timed by the
CPU time of their thread, so that other processes on the machine take nothing from them but memory bandwidth. What the loop alone takes
beside the memory limit is told by `cargo bench -p standfast --bench memory_limit`.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from statistics import median
from typing import Any

import numpy as np
import standfast

ROUNDS = 9


def works(points: int) -> dict[str, Callable[[], Any]]:
    random = np.random.default_rng(1)
    low, high = (0.3, -1.0, 0.0, 0.0), (4.0, 1.0, 3.0, 2.0)
    g, h, k, m = columns = [random.uniform(a, b, points) for a, b in zip(low, high)]

    def one(name: str) -> Callable[[], Any]:
        return lambda: standfast.limit_states(*columns, columns=[name])

    return {
        "slide": one("slide"),
        "slide by numpy": lambda: m - k,
        "rock_O": one("rock_O"),
        "rock_O by numpy": lambda: 1 - g * k * (1 + h),
        "slip_O_left": one("slip_O_left"),
        "slip_O_left by numpy": lambda: m - k + 0.75 * (g * k * (1 + h) - 1) * (m + g) / (1 + g * g),
        "four columns added by numpy": lambda: g + h + k + m,
        "all limit states": lambda: standfast.limit_states(*columns),
        "onset, all columns": lambda: standfast.onset(*columns),
    }


def timed(works: dict[str, Callable[[], Any]], points: int) -> dict[str, float]:
    """Medians of the times of works that take turns, in ns a point."""
    times: dict[str, list[float]] = {name: [] for name in works}
    for _ in range(ROUNDS):
        for name, work in works.items():
            # Memory that another work has given back is not to be this one's loss.
            work()
            start = time.thread_time()
            work()
            times[name].append((time.thread_time() - start) * 1e9 / points)
    return {name: median(taken) for name, taken in times.items()}


def main() -> None:
    for points in (1_000_000, 10_000_000):
        todo = works(points)
        whole = {name: todo.pop(name) for name in ("all limit states", "onset, all columns")}
        medians = timed(todo, points) | timed(whole, points)
        print(f"{points} points, one thread, medians of {ROUNDS} rounds, ns of processor time a point")
        for name, taken in medians.items():
            print(f"{name:<30}{taken:8.2f}")
        for name in ("slide", "rock_O", "slip_O_left"):
            print(f"{name} / numpy's {medians[name] / medians[f'{name} by numpy']:.2f}")
        print(f"all limit states / onset {medians['all limit states'] / medians['onset, all columns']:.2f}\n")


if __name__ == "__main__":
    main()
