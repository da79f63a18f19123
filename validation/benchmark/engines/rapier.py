"""Rapier, by the program of validation/peers/rapier: onset problems only.

    cargo build --release --manifest-path ../../peers/rapier/Cargo.toml
    python rapier.py PATH/TO/rapier-peer
"""

import subprocess
import sys

import common

SETTINGS = {
    "default": dict(dt=1 / 60, iterations=4, sweeps=1, frequency=1, damping=5, allowed_error=0.005, settle=60, start=3, steps=5),
    # Those of validation/peers/compare.py, a first choice by hand.
    "best": {},
}


def ask(program, settings, problems):
    """Accelerations and seconds of every problem."""
    lines = "".join(",".join(str(p[name]) for name in ("gamma", "k_prime", "k", "mu")) + "\n" for p in problems)
    command = [program, *(f"{name}={value}" for name, value in settings.items())]
    done = subprocess.run(command, input=lines, capture_output=True, text=True, check=True)
    return [list(map(float, line.split(","))) for line in done.stdout.splitlines()]


def window(program, number=120):
    """When plain Rapier is best looked at, on other problems."""
    problems, results = common.sample(number), []
    for start in (0, 1, 2, 3, 5, 10):
        for steps in sorted({start + 1, start + 2, 2 * start + 2}):
            found = ask(program, dict(SETTINGS["default"], start=start, steps=steps), problems)
            results.append((sum(common.score.infer(*line[:4]) == p["mode"] for p, line in zip(problems, found)), start, steps))
    for right, start, steps in sorted(results, reverse=True)[:5]:
        print(f"{right} of {number} from step {start} to {steps}")


if __name__ == "__main__":
    if sys.argv[2:] == ["window"]:
        window(sys.argv[1])
    else:
        problems = common.onset_problems()
        for setting, values in SETTINGS.items():
            found = ask(sys.argv[1], values, problems)
            rows = [[p["id"], *map(common.digits, line[:4])] for p, line in zip(problems, found)]
            path = common.write(f"rapier-{setting}-onset.csv", [["id", "slip_left", "lift_left", "slip_right", "lift_right"], *rows])
            print(f"{path.name}: {1e3 * sorted(line[4] for line in found)[len(found) // 2]:.3g} ms by the clock a problem (median)")
