"""Rapier, by the program of validation/peers/rapier, which follows every motion itself.

    cargo build --release --manifest-path ../../peers/rapier/Cargo.toml
    python rapier.py PATH/TO/rapier-peer [onset|motions|again|tune|tune-window|tune-motions] [SETTING]

Damping of bodies is off and restitution 0, as Rapier comes.
"""

import random
import subprocess
import sys
import time

import common

#: For onset. `plain` is Rapier as it comes; without it the program begins with the choice by hand of validation/peers/compare.py.
SETTINGS = {
    "default": dict(plain=1, settle=60, start=0, steps=2),
    "best": dict(dt=1e-4, iterations=4, sweeps=20, frequency=1.0, prediction=0.002, bias_friction=1, warmstart=0, start=20, steps=40),
}


def some(pick):
    """A setting of the random search: those of validation/peers/compare.py, with shorter and longer windows."""
    start = pick([5, 20, 50, 100])
    return dict(dt=pick([1e-5, 1e-4, 3e-4, 1e-3]), iterations=pick([1, 4, 20]), sweeps=pick([1, 4, 20]), stabilization=pick([0, 1, 4]),
                frequency=pick([0.01, 0.05, 0.1, 0.2, 1.0]), damping=pick([1, 5, 20]), prediction=pick([0.002, 0.02]), allowed_error=pick([1e-9, 1e-6, 1e-3]),
                bias_friction=pick([0, 1]), warmstart=pick([0, 1]), start=start, steps=pick([2, 3]) * start)


FRICTION = dict(bias_friction=1)
SEVERAL = [
    dict(plain=1), dict(plain=1, dt=1e-3), dict(plain=1, dt=1e-4), dict(dt=1e-3), {}, dict(dt=1e-3, frequency=1.0), dict(frequency=1.0), dict(prediction=1e-4), dict(corrective=0.1),
    dict(iterations=1, sweeps=20), dict(iterations=4, frequency=0.5), FRICTION, dict(FRICTION, sweeps=20), dict(FRICTION, frequency=1.0), dict(FRICTION, frequency=0.01),
    dict(FRICTION, damping=5), dict(FRICTION, stabilization=0), dict(FRICTION, iterations=4, sweeps=20, frequency=1.0, prediction=0.002, warmstart=0), dict(FRICTION, dt=2e-5, iterations=4),
    dict(FRICTION, dt=1e-5, iterations=4), dict(FRICTION, dt=2e-5, iterations=4, frequency=0.5),
]
MOTIONS = {"default": dict(plain=1), "best": SEVERAL[-1]}


def ask(program, words, lines):
    """Runs the program; the numbers of each line that it writes."""
    done = subprocess.run([program, *words], input="".join(lines), capture_output=True, text=True, check=True)
    return [list(map(float, line.split(","))) for line in done.stdout.splitlines()]


def words(settings):
    return [f"{name}={value}" for name, value in settings.items()]


def onset(program, settings, problems):
    """Accelerations of the corners and seconds of every problem."""
    return ask(program, words(settings), [",".join(str(p[name]) for name in ("gamma", "k_prime", "k", "mu")) + "\n" for p in problems])


def history(h, *more):
    return [h["shape"], h["start"], h["duration"], h["peak"], h.get("rise", h.get("period", 0)), *more] if h else []


def line(item):
    """A motion as the program reads it."""
    start, force = item["initial"], item["force"]
    block = [item[n] for n in ("half_height", "friction", "gravity", "inertia")] + [start[n] for n in ("x", "y", "theta", "vx", "vy", "omega")]
    parts = [block, history(force, *force["at"], *force["direction"]) if force else [], history(item["base_acceleration"]), [point[0] for point in item["checkpoints"]]]
    return ";".join(",".join(map(str, part)) for part in parts) + "\n"


def motions(program, settings, items):
    """Seconds, and rows of t, x, y and theta, of every motion."""
    for item, (seconds, *found) in zip(items, ask(program, ["motions", *words(settings)], map(line, items))):
        yield item, seconds, [[point[0], *found[3 * i : 3 * i + 3]] for i, point in enumerate(item["checkpoints"])]


def answer_onset(program, setting):
    problems = common.onset_problems()
    found = onset(program, SETTINGS[setting], problems)
    rows = [[p["id"], *map(common.digits, row[:4])] for p, row in zip(problems, found)]
    path = common.write(f"rapier-{setting}-onset.csv", [["id", "slip_left", "lift_left", "slip_right", "lift_right"], *rows])
    print(f"{path.name}: {1e3 * common.score.median([row[4] for row in found]):.3g} ms by the clock a problem (median)", flush=True)


def answer_motions(program, setting):
    rows, times = [["id", "t", "x", "y", "theta"]], []
    for item, seconds, found in motions(program, MOTIONS[setting], common.motion_problems()):
        times.append(seconds / item["t_end"])
        rows += [[item["id"], repr(row[0]), *map(common.places, row[1:])] for row in found]
    path = common.write(f"rapier-{setting}-motions.csv", rows)
    print(f"{path.name}: {1e3 * common.score.median(times):.3g} ms by the clock for a second of motion (median)", flush=True)


def right(program, settings, problems):
    return sum(common.score.infer(*row[:4]) == p["mode"] for p, row in zip(problems, onset(program, settings, problems)))


def tune(program, seconds):
    """A random search as in common.tune_onset, on the same 60 other problems."""
    problems, generator, queue = common.sample(60), random.Random(3), [SETTINGS["default"], {}]
    best, tried, end = -1, 0, time.time() + seconds
    while time.time() < end:
        settings, begin = queue.pop(0) if queue else some(generator.choice), time.time()
        count = right(program, settings, problems)
        tried += 1
        if count > best:
            best = count
            print(f"try {tried}: {count} of {len(problems)}, {1e3 * (time.time() - begin) / len(problems):.2g} ms each, {settings}", flush=True)
    print(f"{tried} tried", flush=True)


def tune_window(program):
    """When plain Rapier is best looked at, on other problems."""
    problems, results = common.sample(120), []
    for settle in (60, 200):
        for start in (0, 1, 2, 3, 5, 10, 20):
            for steps in sorted({start + 1, start + 2, 2 * start + 2}):
                window = dict(settle=settle, start=start, steps=steps)
                results.append((right(program, dict(plain=1, **window), problems), window))
    for count, window in sorted(results, key=lambda result: -result[0])[:5]:
        print(f"{count} of {len(problems)} with {window}", flush=True)


def tune_motions(program):
    """Tries settings on every tenth motion, as common.tune_motions does."""
    for settings in SEVERAL:
        begin = time.time()
        errors = sorted(common.worst(rows, item) for item, _, rows in motions(program, settings, common.motion_problems()[4::10]))
        counts = [sum(e <= s for e in errors) for s in common.score.SHARES]
        print(f"{counts} of {len(errors)}, median {errors[len(errors) // 2]:.3g}, {time.time() - begin:.0f} s, {settings}", flush=True)


def main():
    if len(sys.argv) < 2:
        sys.exit("which program? python rapier.py PATH/TO/rapier-peer onset")
    program, what, only = sys.argv[1], (sys.argv[2:] or ["onset"])[0], sys.argv[3:]
    if what == "tune":
        tune(program, float(only[0]) if only else 75)
    elif what == "tune-window":
        tune_window(program)
    elif what == "tune-motions":
        tune_motions(program)
    elif what not in ("onset", "motions", "again"):
        sys.exit(f"unknown: {what}; it is onset, motions, again, tune, tune-window or tune-motions")
    else:

        def answer(kind):
            for setting in SETTINGS:
                if not only or setting in only:
                    {"onset": answer_onset, "motions": answer_motions}[kind](program, setting)

        common.again(answer) if what == "again" else answer(what)


if __name__ == "__main__":
    main()
