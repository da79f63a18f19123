"""Random points, their modes by standfast, and how far they are from a boundary."""

import csv
import os
import random
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
NAMES = ["gamma", "k_prime", "k", "mu"]
# A point whose mode changes when k or mu changes by this part of itself is near a boundary.
NEAR = 0.05


def program():
    """The program: STANDFAST, or the one cargo builds."""
    found = os.environ.get("STANDFAST")
    if found:
        return [found]
    target = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
    built = target / "release" / "standfast"
    if not built.exists():
        subprocess.run(["cargo", "build", "--release", "--quiet", "-p", "standfast-cli"], cwd=ROOT, check=True)
    return [str(built)]


def answers(points):
    """Rows of mode, unique and also for rows of gamma, k_prime, k and mu."""
    with tempfile.TemporaryDirectory() as folder:
        table, answer = Path(folder, "points.csv"), Path(folder, "answer.csv")
        with open(table, "w", newline="") as file:
            csv.writer(file).writerows([NAMES, *points])
        command = ["batch", str(table), "-o", str(answer), "--columns", "mode,unique,also"]
        subprocess.run(program() + command, check=True)
        with open(answer, newline="") as file:
            return list(csv.DictReader(file))


def draw(number, seed):
    """`number` points, 85 % anywhere in the report's range and 15 % where several modes are consistent."""
    generator = random.Random(seed)

    def some(largest_k, largest_mu, lowest, highest):
        gamma = 4 ** generator.uniform(-1, 1)
        k_prime = generator.uniform(lowest, highest)
        return [gamma, k_prime, generator.uniform(0.05, largest_k), generator.uniform(0.02, largest_mu)]

    ambiguous = round(0.15 * number)
    points = [some(3, 1.5, -1, 1) for _ in range(number - ambiguous)]
    many = [some(8, 6, -1, 0) for _ in range(400 * ambiguous)]
    kept = [point for point, answer in zip(many, answers(many)) if answer["unique"] == "false"]
    points += kept[:ambiguous]
    assert len(points) == number
    return points


def load(number, seed):
    """Points with mode, other modes and whether they are near a boundary."""
    points = draw(number, seed)
    shifts = [(1 + NEAR, 1), (1 - NEAR, 1), (1, 1 + NEAR), (1, 1 - NEAR)]
    moved = [[g, kp, k * a, mu * b] for g, kp, k, mu in points for a, b in shifts]
    modes = answers(points)
    around = answers(moved)
    table = []
    for i, (point, answer) in enumerate(zip(points, modes)):
        close = any(other["mode"] != answer["mode"] for other in around[4 * i : 4 * i + 4])
        table.append({
            "point": point,
            "mode": answer["mode"],
            "also": answer["also"].split(),
            "near": close,
        })
    return table
