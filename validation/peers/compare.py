"""Modes of random points by standfast, MuJoCo and Rapier: the tables of docs/trust/peers.md.

    pip install -r requirements.txt
    python compare.py            # the 1,000 points of the tables; some minutes
    python compare.py tune       # the search for settings, on other points
"""

import os
import random
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path

import mujoco_peer
import points

HERE = Path(__file__).resolve().parent
# The benchmark stands alone, so this asks it how a mode is told from accelerations, and not the other way round.
sys.path.append(str(HERE.parent / "benchmark"))
from score import THRESHOLD, infer  # noqa: E402

THRESHOLDS = [0.003, 0.01, 0.03]

# The best found, and the engines as they come.
MUJOCO = dict(timestep=1e-5, cone="elliptic", ratio=2, impratio=100, friction_timeconst=0.2, d0=0.9, dwidth=0.999,
              width=1e-3, damping=1, noslip=0, start=300, steps=900)
MUJOCO_PLAIN = dict(timestep=2e-3, cone="pyramidal", impratio=1, ratio=10, friction_timeconst=0.02, d0=0.9,
                    dwidth=0.95, width=1e-3, settle=400, start=15, steps=30)
# The settings in rapier/src/main.rs.
RAPIER = {}
RAPIER_PLAIN = dict(plain=1, settle=60, start=0, steps=2)


def mujoco(table, settings):
    """Accelerations and seconds for every point."""
    return [mujoco_peer.simulate(row["point"], settings) for row in table]


def rapier(table, settings):
    """The same by the program in rapier/."""
    target = HERE / "rapier" / "target"
    build = ["cargo", "build", "--release", "--quiet"]
    subprocess.run(build, cwd=HERE / "rapier", check=True, env={**os.environ, "CARGO_TARGET_DIR": str(target)})
    command = [str(target / "release" / "rapier-peer"), *(f"{name}={value}" for name, value in settings.items())]
    lines = "".join(",".join(map(str, row["point"])) + "\n" for row in table)
    output = subprocess.run(command, input=lines, capture_output=True, text=True, check=True).stdout
    numbers = [list(map(float, line.split(","))) for line in output.splitlines()]
    return [(line[:4], line[4]) for line in numbers]


def groups(table):
    """What the table of results has as rows: name, and which points."""
    yield "all points with one consistent mode", lambda row: not row["also"]
    yield "more than 5 % from a boundary", lambda row: not row["also"] and not row["near"]
    yield "within 5 % of a boundary", lambda row: not row["also"] and row["near"]
    for mode in ["RE", "SL", "RO", "SRO-", "SRO+", "SRO'-"]:
        yield f"{mode}, away from boundaries", lambda row, mode=mode: (
            not row["also"] and not row["near"] and row["mode"] == mode)
    yield "several consistent modes: the one standfast reports", lambda row: bool(row["also"])


def share(table, modes, chosen):
    picked = [(row, mode) for row, mode in zip(table, modes) if chosen(row)]
    right = sum(row["mode"] == mode for row, mode in picked)
    return f"{100 * right / len(picked):.1f} %" if picked else "–"


def engine_modes(results, threshold=THRESHOLD):
    return [infer(*accelerations, threshold) for accelerations, _ in results]


def compare():
    table = points.load(1000, seed=1)
    engines = {
        "MuJoCo, plain": mujoco(table, MUJOCO_PLAIN),
        "MuJoCo, tuned": mujoco(table, MUJOCO),
        "Rapier, plain": rapier(table, RAPIER_PLAIN),
        "Rapier, tuned": rapier(table, RAPIER),
    }
    modes = {name: engine_modes(results) for name, results in engines.items()}
    print("| points | number | " + " | ".join(engines) + " |")
    print("|---|---|" + "---|" * len(engines))
    for name, chosen in groups(table):
        number = sum(map(chosen, table))
        print(f"| {name} | {number} | " + " | ".join(share(table, m, chosen) for m in modes.values()) + " |")
    several = [i for i, row in enumerate(table) if row["also"]]
    row = []
    for found in modes.values():
        row.append(f"{100 * sum(found[i] in table[i]['also'] for i in several) / len(several):.1f} %")
    print(f"| several consistent modes: another of them | {len(several)} | " + " | ".join(row) + " |")
    seconds = [sorted(s for _, s in results)[len(results) // 2] for results in engines.values()]
    print("| time a point (median) | | " + " | ".join(f"{1e3 * s:.2g} ms" for s in seconds) + " |")

    print("\n| threshold in g | " + " | ".join(engines) + " |")
    print("|---|" + "---|" * len(engines))
    away = lambda row: not row["also"] and not row["near"]
    for threshold in THRESHOLDS:
        row = [share(table, engine_modes(results, threshold), away) for results in engines.values()]
        print(f"| {threshold} | " + " | ".join(row) + " |")
    for name, found in modes.items():
        wrong = Counter((row["mode"], mode) for row, mode in zip(table, found) if away(row) and mode != row["mode"])
        print(f"\n{name}, away from boundaries: " + (", ".join(
            f"{expected} taken for {mode} {number}×" for (expected, mode), number in wrong.most_common(6)) or "no error"))
        several = Counter(mode for row, mode in zip(table, found) if row["also"])
        print(f"{name}, several consistent modes: " + ", ".join(f"{m} {n}×" for m, n in several.most_common()))


def tune(seconds=300):
    """A random search; prints what is better than everything before."""
    table = points.load(120, seed=7)
    generator = random.Random(3)
    pick = generator.choice

    def some_mujoco():
        start = pick([100, 300])
        return dict(timestep=pick([1e-5, 2e-5, 1e-4]), ratio=pick([2, 3, 5, 10]), impratio=pick([1, 10, 100, 1000]),
                    friction_timeconst=pick([0.02, 0.2, 1.0, 10.0]), d0=pick([0.9, 0.99]),
                    dwidth=pick([0.99, 0.999, 0.9999]), width=pick([1e-6, 1e-5, 1e-3]), damping=pick([0.7, 1, 2]),
                    noslip=pick([0, 0, 20]), cone=pick(["elliptic", "elliptic", "pyramidal"]), start=start,
                    steps=3 * start)

    def some_rapier():
        start = pick([20, 50, 100])
        return dict(dt=pick([1e-5, 1e-4, 1e-3]), iterations=pick([1, 4, 20]), sweeps=pick([1, 4, 20, 100]),
                    stabilization=pick([0, 1, 4]), frequency=pick([0.01, 0.05, 0.2, 1.0]), damping=pick([1, 5, 20]),
                    prediction=pick([0.002, 0.02]), allowed_error=pick([1e-9, 1e-6, 1e-3]),
                    bias_friction=pick([0, 1]), warmstart=pick([0, 1]), start=start, steps=2 * start)

    for name, engine, some in [("MuJoCo", mujoco, some_mujoco), ("Rapier", rapier, some_rapier)]:
        best, end, tried = -1, time.time() + seconds, 0
        while time.time() < end:
            settings = some()
            found = engine_modes(engine(table, settings))
            right = [row["mode"] == mode for row, mode in zip(table, found) if not row["also"]]
            tried += 1
            if sum(right) > best:
                best = sum(right)
                print(f"{name}, try {tried}: {best} of {len(right)} with {settings}", flush=True)


if __name__ == "__main__":
    tune(*map(float, sys.argv[2:])) if sys.argv[1:2] == ["tune"] else compare()
