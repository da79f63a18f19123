"""classify on ten million points against numpy and against the memory limit; ratios of medians, taken in one run.

    python python/benchmarks/classify.py          (needs gcc or another C compiler as cc; build standfast by release)

Rivals on the same four float64 columns, each into a preallocated uint8 array:

* numpy as it is written: the report's decision in closed form, whole-array expressions and one `np.select`, every product
  that is used twice taken once.
* numpy in place: the same, every step into a preallocated array, on whole arrays; and in blocks that stay in the cache (the
  best block size found: 8192 points).
* memory limit: `a + b + c + d > 3`, compiled for this processor by the C compiler, one loop.

All take turns, ROUNDS times. One-thread work is timed by the CPU time of its thread, so that other processes on the
machine take nothing from it but memory bandwidth; several threads by the clock.
"""

from __future__ import annotations

import ctypes
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np
import standfast
from numpy.typing import NDArray

POINTS, ROUNDS, BLOCK = 10_000_000, 15, 8192

LIMIT = """
void limit(const double *restrict a, const double *restrict b, const double *restrict c, const double *restrict d,
           unsigned char *restrict out, long n) {
    for (long i = 0; i < n; i++) out[i] = a[i] + b[i] + c[i] + d[i] > 3.0;
}
"""


def expressions(columns: list[NDArray[np.float64]], out: NDArray[np.uint8]) -> None:
    """The decision for k' >= -1, as one writes it."""
    g, h, k, m = columns
    kh, gg = k * h, g * g
    u = g * (k + kh)
    s = g * (m + kh)
    a = (4 + gg) * k + 3 * (g - gg * kh)
    c = (3 * u + 1 + 4 * gg) * m
    slips = m < k
    conditions = [(u <= 1) & ~slips, s < -1, slips & (s <= 1), c < -a, c < a]
    out[:] = np.select(conditions, [np.uint8(code) for code in (0, 5, 1, 4, 3)], np.uint8(2))


def closed_form(columns: list[NDArray[np.float64]], out: NDArray[np.uint8], size: int) -> None:
    """The decision for k' >= -1, block by block."""
    work = np.empty((6, size))
    masks = np.empty((2, size), dtype=bool)
    for start in range(0, len(out), size):
        g, h, k, m, codes = (column[start : start + size] for column in (*columns, out))
        n = len(codes)
        u, s, a, c, t, one = work[:, :n]
        p, q = masks[:, :n]
        np.multiply(k, h, out=s)
        np.add(s, k, out=u)
        np.multiply(u, g, out=u)  # k gamma (1 + k')
        np.multiply(g, g, out=t)
        # |a k + b| = |(4 + g^2) k - 3 g^2 k k' + 3 g| and c k + d = 3 u + 1 + 4 g^2
        np.add(t, 4, out=a)
        np.multiply(a, k, out=a)
        np.multiply(t, s, out=one)
        np.subtract(g, one, out=one)
        np.multiply(one, 3, out=one)
        np.add(a, one, out=a)
        np.multiply(t, 4, out=t)
        np.add(t, 1, out=t)
        np.multiply(u, 3, out=c)
        np.add(c, t, out=c)
        np.multiply(c, m, out=c)
        np.add(s, m, out=s)
        np.multiply(s, g, out=s)  # gamma (mu + k k')
        # Later lines override earlier ones.
        codes.fill(2)
        np.less(c, a, out=p)
        np.copyto(codes, 3, where=p)
        np.negative(a, out=a)
        np.less(c, a, out=p)
        np.copyto(codes, 4, where=p)
        np.less(m, k, out=p)
        np.less_equal(s, 1, out=q)
        np.logical_and(p, q, out=q)
        np.copyto(codes, 1, where=q)
        np.less(s, -1, out=q)
        np.copyto(codes, 5, where=q)
        np.less_equal(u, 1, out=q)
        np.greater(q, p, out=q)
        np.copyto(codes, 0, where=q)


def compiled_limit(folder: Path) -> Callable[[list[NDArray[np.float64]], NDArray[np.uint8]], None]:
    source, library = folder / "limit.c", folder / "limit.so"
    source.write_text(LIMIT)
    subprocess.run(["cc", "-O3", "-march=native", "-mprefer-vector-width=512", "-shared", "-fPIC", "-o", library, source], check=True)
    limit = ctypes.CDLL(str(library)).limit

    def run(columns: list[NDArray[np.float64]], out: NDArray[np.uint8]) -> None:
        pointers = [ctypes.c_void_p(array.ctypes.data) for array in (*columns, out)]
        limit(*pointers, ctypes.c_long(len(out)))

    return run


def in_two(work: Callable[..., None], columns: list[NDArray[np.float64]], out: NDArray[np.uint8]) -> None:
    half = len(out) // 2
    other = threading.Thread(target=work, args=([column[half:] for column in columns], out[half:]))
    other.start()
    work([column[:half] for column in columns], out[:half])
    other.join()


def main() -> None:
    random = np.random.default_rng(1)
    low, high = (0.3, -1.0, 0.0, 0.0), (4.0, 1.0, 3.0, 2.0)
    columns = [random.uniform(a, b, POINTS) for a, b in zip(low, high)]
    out, other = np.zeros(POINTS, dtype=np.uint8), np.zeros(POINTS, dtype=np.uint8)
    with tempfile.TemporaryDirectory() as folder:
        limit = compiled_limit(Path(folder))
    works: dict[str, tuple[Callable[[], float], Callable[[], Any]]] = {
        "classify, one thread": (time.thread_time, lambda: standfast.classify(*columns, out=out)),
        "memory limit, one thread": (time.thread_time, lambda: limit(columns, other)),
        "numpy as it is written": (time.thread_time, lambda: expressions(columns, other)),
        "numpy in blocks": (time.thread_time, lambda: closed_form(columns, other, BLOCK)),
        "numpy in place": (time.thread_time, lambda: closed_form(columns, other, POINTS)),
        "classify, one thread, by the clock": (time.perf_counter, lambda: standfast.classify(*columns, out=out)),
        "classify, two threads": (time.perf_counter, lambda: standfast.classify(*columns, out=out, threads=2)),
        "memory limit, one thread, by the clock": (time.perf_counter, lambda: limit(columns, other)),
        "memory limit, two threads": (time.perf_counter, lambda: in_two(limit, columns, other)),
    }
    times: dict[str, list[float]] = {name: [] for name in works}
    for round_ in range(ROUNDS + 1):
        for name, (clock, work) in works.items():
            start = clock()
            work()
            if round_:  # The first warms up.
                times[name].append((clock() - start) * 1e9 / POINTS)

    expressions(columns, out)
    closed_form(columns, other, BLOCK)
    assert (out == other).all()
    different = int((standfast.classify(*columns) != other).sum())
    print(f"{POINTS} points, {ROUNDS} rounds, ns a point; numpy {np.__version__}, Python {sys.version.split()[0]}")
    print(f"points where numpy's rounding gives another mode: {different}\n")
    for name, found in times.items():
        found.sort()
        print(f"{name:40}{median(found):8.2f}   middle half {found[len(found) // 4]:.2f} to {found[-len(found) // 4]:.2f}")
    middle = {name: median(found) for name, found in times.items()}
    rows = [
        ("numpy as it is written / classify", "numpy as it is written", "classify, one thread"),
        ("numpy in blocks / classify", "numpy in blocks", "classify, one thread"),
        ("numpy in place / classify", "numpy in place", "classify, one thread"),
        ("classify / memory limit", "classify, one thread", "memory limit, one thread"),
        ("classify, one thread / two", "classify, one thread, by the clock", "classify, two threads"),
        ("memory limit, one thread / two", "memory limit, one thread, by the clock", "memory limit, two threads"),
        ("classify / memory limit, two threads", "classify, two threads", "memory limit, two threads"),
    ]
    print()
    for name, above, below in rows:
        print(f"{name:40}{middle[above] / middle[below]:8.2f}")


if __name__ == "__main__":
    main()
