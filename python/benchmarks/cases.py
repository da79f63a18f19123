"""What cases cost from Python: an assessment with and without what is asked of it, and tables of cases against the program's.

    python python/benchmarks/cases.py [standfast] [rows]

`standfast` is the program, built with the same profile as the package. Times are of one thread's processor, medians of rounds in
which all take turns; those of the program are its own, less that of a table of one row.
"""

import gc
import os
import pickle
import resource
import statistics
import subprocess
import sys
import tempfile
import time
import warnings
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


#: What is asked of an assessment.
ASKED = {
    "text, document and figures": lambda found: (str(found), found.to_dict(), found.figures),
    "one factor": lambda found: found.SF_sliding,
    "nothing": lambda found: None,
}


def held(asked):
    """What a result holds of which this has been asked, in bytes; for a process of its own."""
    kept = [standfast.assess(GODA) for _ in range(5)]
    for found in kept:
        ASKED[asked](found)
    before = resident()
    for _ in range(1000):
        found = standfast.assess(GODA)
        ASKED[asked](found)
        kept.append(found)
    return (resident() - before) / 1000


def assessments():
    count = 300
    times, ratios = rounds({
        name: lambda ask=ask: [ask(standfast.assess(GODA)) for _ in range(count)] for name, ask in ASKED.items()
    })
    print("assess of Goda's caisson, and what is asked of it")
    for name in ASKED:
        own = subprocess.run([sys.executable, __file__, "held", name], capture_output=True, encoding="utf-8", check=True)
        print(f"  {name:28} {times[name] / count * 1e6:7.0f} µs  {ratios[name]:.3f}  {float(own.stdout) / 1e3:6.1f} kB held")
    print(f"  pickled: {len(pickle.dumps(standfast.assess(GODA)))} bytes")


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
        "one result": lambda: standfast.assess_table(case, sample, columns=["SF_sliding"], threads=1),
        "and warnings": lambda: standfast.assess_table(case, sample, columns=["SF_sliding", "warnings"], threads=1),
    }
    warnings.simplefilter("ignore", standfast.StandfastWarning)
    times, ratios = rounds(work)
    named = standfast.assess_table(case, sample, columns=["warnings"])["warnings"]
    print(f"{np.mean([len(names.split()) for names in named]):.1f} warnings a row")
    print(f"{rows} rows of Goda's caisson, all results, one thread")
    start = time.perf_counter()
    standfast.assess_table(case, polars, threads=None)
    both = time.perf_counter() - start
    for name, taken in times.items():
        print(f"  {name:20} {taken / rows * 1e6:7.2f} µs a row  {ratios[name]:.3f}")
    print(f"  polars, {os.cpu_count()} threads: {both:.2f} s by the clock")


if __name__ == "__main__":
    if sys.argv[1:2] == ["held"]:
        print(held(sys.argv[2]))
        sys.exit()
    assessments()
    if len(sys.argv) > 1:
        tables(sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 20_000)
