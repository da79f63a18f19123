"""What cases cost from Python: an assessment with and without what is asked of it, and tables of cases against the program's.

    python python/benchmarks/cases.py [standfast] [rows]

`standfast` is the program, built with the same profile as the package. Times are of one thread's processor, medians of rounds in
which all take turns; those of the program are its own, less that of a table of one row.
"""

import gc
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
import pandas as pd
import polars as pl
import standfast

ROOT = Path(__file__).parents[2]
GODA = ROOT / "examples/goda-2000.toml"
ROUNDS = 9


def processor(work):
    """Seconds of processor time, of this process and those that it waited for."""
    def used():
        own, others = resource.getrusage(resource.RUSAGE_SELF), resource.getrusage(resource.RUSAGE_CHILDREN)
        return own.ru_utime + own.ru_stime + others.ru_utime + others.ru_stime

    before = used()
    work()
    return used() - before


def rounds(work):
    """The median times of works that take turns, and the median of their ratios to the first."""
    times = {name: [] for name in work}
    names = list(work)
    for turn in range(ROUNDS):
        for name in names[turn % len(names):] + names[: turn % len(names)]:
            times[name].append(processor(work[name]))
    first = times[names[0]]
    ratios = {name: statistics.median(one / of for one, of in zip(times[name], first)) for name in names}
    return {name: statistics.median(taken) for name, taken in times.items()}, ratios


def resident():
    gc.collect()
    return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGESIZE")


def assessments():
    text = GODA.read_text(encoding="utf-8")
    folder = tempfile.mkdtemp()
    path = Path(folder) / "case.toml"
    path.write_text(text, encoding="utf-8")

    def all_of(found):
        return str(found), found.to_dict(), found.figures

    kinds = {
        "with text, document and figures": all_of,
        "with one factor": lambda found: found.SF_sliding,
        "alone": lambda found: None,
    }
    count = 300
    work = {name: lambda ask=ask: [ask(standfast.assess(path)) for _ in range(count)] for name, ask in kinds.items()}
    times, ratios = rounds(work)
    print("assess of Goda's caisson")
    for name, ask in kinds.items():
        kept = [standfast.assess(path) for _ in range(100)]
        before = resident()
        kept += [standfast.assess(path) for _ in range(1000)]
        for found in kept[100:]:
            ask(found)
        held = (resident() - before) / 1000
        print(f"  {name:32} {times[name] / count * 1e6:7.0f} µs  {ratios[name]:.2f}  {held / 1e3:6.1f} kB held")
    pickled = len(__import__("pickle").dumps(standfast.assess(path)))
    print(f"  pickled: {pickled} bytes")


def tables(program, rows):
    generator = np.random.default_rng(2026)
    height = generator.uniform(2, 7, rows)
    sample = {
        "wave.H13": height,
        "wave.Hmax": height * generator.uniform(1.4, 1.8, rows),
        "wave.period": generator.uniform(6, 16, rows),
        "body.friction": generator.uniform(0.4, 0.8, rows),
    }
    folder = Path(tempfile.mkdtemp())
    case = folder / "case.toml"
    case.write_text(GODA.read_text(encoding="utf-8").replace('deep_water_height = "6.3 m"', "H13 = 5.8\nHmax = 8.05"), encoding="utf-8")
    frame = pd.DataFrame(sample)
    frame.to_csv(folder / "rows.csv", index=False)
    frame[:1].to_csv(folder / "one.csv", index=False)
    polars = pl.DataFrame(sample)

    def batch(name):
        command = [program, "batch", folder / name, "--case", case, "-o", folder / "out.csv", "--threads", "1"]
        subprocess.run(command, check=True, stderr=subprocess.DEVNULL)

    work = {
        "program, CSV to CSV": lambda: batch("rows.csv"),
        "program, one row": lambda: batch("one.csv"),
        "arrays": lambda: standfast.assess_table(case, sample, threads=1),
        "pandas": lambda: standfast.assess_table(case, frame, threads=1),
        "polars": lambda: standfast.assess_table(case, polars, threads=1),
    }
    times, ratios = rounds(work)
    print(f"{rows} rows of Goda's caisson, all results, one thread")
    start = time.perf_counter()
    standfast.assess_table(case, polars, threads=None)
    both = time.perf_counter() - start
    for name, taken in times.items():
        print(f"  {name:20} {taken / rows * 1e6:7.2f} µs a row  {ratios[name]:.3f}")
    print(f"  polars, {os.cpu_count()} threads: {both:.2f} s by the clock")


if __name__ == "__main__":
    assessments()
    if len(sys.argv) > 1:
        tables(sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 20_000)
