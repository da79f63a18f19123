"""The base of random bodies: `standfast probability` against plain Monte Carlo over the formulas of base.py, which share nothing with it.

    pip install numpy==2.4.6 scipy==1.17.1
    python base_chances.py [NUMBER [PROGRAM [DRAWS [ARGUMENT ...]]]]      # 30 cases, `standfast`, 4000 draws

Friction, push and what the base bears are random. Each mode's share of the draws is compared with its probability; a difference of more than
four and a half standard errors is printed, and the exit code is 1. An elastic base is one that bears everything.
"""

import collections
import copy
import json
import math
import subprocess
import sys

import numpy as np
from base import Case, borne, crushing


def random_table(case):
    """The `[random]` table of a case, and its draws in numpy."""
    lines = ["[random]", "friction = { normal = { cov = 0.1 } }", '"load.push.force" = { normal = { cov = 0.15 } }']
    if case.kind == "strength":
        lines.append("ground.strength = { lognormal = { cov = 0.25 } }")
    elif case.kind == "envelope":
        lines.append("ground.centric_resistance = { lognormal = { cov = 0.25 } }")
    elif case.kind in ("ec7", "hansen"):
        lines.append("ground.friction_angle_deg = { normal = { sd = 1.5 }, lower = 21, upper = 49 }")
    return "\n".join(lines) + "\n"


def lognormal(pick, mean, cov):
    spread = math.sqrt(math.log1p(cov * cov))
    return mean * math.exp(spread * pick.standard_normal() - spread * spread / 2)


def drawn(case, pick):
    """The case with drawn numbers."""
    case = copy.copy(case)
    case.friction *= 1 + 0.1 * pick.standard_normal()
    case.push *= 1 + 0.15 * pick.standard_normal()
    case.strength = lognormal(pick, case.strength, 0.25)
    case.centric = lognormal(pick, case.centric, 0.25)
    angle = math.inf
    while not 21 < angle < 49:
        angle = case.angle + 1.5 * pick.standard_normal()
    case.angle = angle
    return case


def mode(case):
    """What begins under the full load."""
    x, p, m = case.wrench(1)
    if case.kind in ("ec7", "hansen", "envelope"):
        holds = abs(x) <= case.friction * p
        pushed = x if holds else math.copysign(case.friction * p, x)
        rests = "RE" if holds else "SL" if x < 0 else "SL+"
        return rests if borne(case, pushed, p, m, case.angle) >= p else "BF"
    if case.kind == "elastic":
        case = copy.copy(case)
        case.strength = 1e7 * p / case.width
    found = crushing(case, x, p, m)
    return found.pop() if len(found) == 1 else "several"


def main():
    number = int(sys.argv[1]) if len(sys.argv) > 1 else 30
    program = sys.argv[2] if len(sys.argv) > 2 else "standfast"
    count = int(sys.argv[3]) if len(sys.argv) > 3 else 4000
    failed = checked = 0
    for seed in range(number):
        case = Case(seed)
        if case.kind == "elastic and strength":
            continue
        # Somewhere between rest and motion.
        case.push *= 0.6
        case.angle = min(max(case.angle, 26), 44)
        text = "\n".join(line for line in case.toml().splitlines() if not line.startswith("history")) + "\n" + random_table(case)
        command = [program, "probability", "-", "--no-figures", "--format", "json", *sys.argv[4:]]
        run = subprocess.run(command, input=text, capture_output=True, text=True, check=False)
        if run.returncode:
            print(seed, case.kind, run.stderr)
            failed += 1
            continue
        said = {at["mode"]: at["probability"] for at in json.loads(run.stdout)["modes"]}
        pick = np.random.default_rng(seed)
        met = collections.Counter(mode(drawn(case, pick)) for _ in range(count))
        several = met.pop("several", 0)
        wrong = []
        for name, p in said.items():
            share = met[name] / count
            checked += 1
            if abs(share - p) > 4.5 * math.sqrt(max(p * (1 - p), 1 / count) / count) + several / count:
                wrong.append((name, p, share))
        for name, p, share in wrong:
            print(f"{seed} ({case.kind}): {name} {p}, drawn {share}")
        failed += bool(wrong)
        likely = ", ".join(f"{name} {p:.3g}" for name, p in said.items() if p > 0.001)
        print(f"{seed} {case.kind}: {likely}", file=sys.stderr)
    print(f"{number} cases, {checked} probabilities, {failed} cases differ")
    return failed > 0


if __name__ == "__main__":
    sys.exit(main())
