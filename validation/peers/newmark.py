"""Newmark's sliding block: `standfast spectrum --kind newmark` against pyslammer, on the record of examples/records.

    pip install pyslammer==0.2.2
    python newmark.py PATH/TO/standfast

Both integrate the same record, with lines between its samples, at the same yield accelerations, one way and the other. The times are of one
run: pyslammer's in Python, for one slide; the program's from its start to its end, for all slides, and half as many two-way ones.
"""

import csv
import io
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np
import pyslammer

ROOT = pathlib.Path(__file__).parents[2]
RECORD = ROOT / "examples/records/np01002p_4225c_a.smc"
COUNT = 40
G = 9.80665


def values(path):
    """The accelerations of an SMC file, cm/s2: eight to a line of 80 columns after 11 lines of text, 6 of integers, 10 of reals and comments."""
    lines = path.read_text(errors="replace").splitlines()
    integers = [int(line[i : i + 10]) for line in lines[11:17] for i in range(0, 80, 10)]
    comments, count = integers[15], integers[16]
    body = lines[27 + comments :]
    cells = [line[i : i + 10].strip() for line in body for i in range(0, 80, 10)]
    return np.array([float(cell) for cell in cells if cell][:count])


def main(program):
    acceleration = values(RECORD) / 100.0
    peak = np.abs(acceleration).max()
    case = f"""
[block]
b1 = 1
b2 = 1
d = 1
mu_s = 0.5
gravity = {G}
[motion.base]
horizontal = {{ shape = "file", file = "{RECORD}", factor = 0.01 }}
"""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "case.toml"
        path.write_text(case)
        command = [program, "spectrum", str(path), "--kind", "newmark", "--ratio", f"0.05,0.9,{COUNT}", "--csv", "-", "--threads", "1"]
        start = time.perf_counter()
        text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
        ours = time.perf_counter() - start
    differences, theirs, longest = [], [], 0.0
    for row in csv.DictReader(io.StringIO(text)):
        share = float(row["ratio"])
        for column, sign in (("left", 1.0), ("right", -1.0)):
            motion = pyslammer.GroundMotion(sign * acceleration / G, 0.005)
            start = time.perf_counter()
            slide = pyslammer.RigidAnalysis(share * peak / G, motion).max_sliding_disp
            theirs.append(time.perf_counter() - start)
            mine = float(row[column])
            if mine > 1e-6:
                differences.append(abs(slide / mine - 1))
                longest = max(longest, mine)
    differences.sort()
    print(f"{len(differences)} slides up to {longest:.3f} m: pyslammer {pyslammer.__version__} differs by "
          f"{statistics.median(differences):.2%} in the median, {differences[int(0.9 * len(differences))]:.2%} at 90 %, {differences[-1]:.2%} at most")
    print(f"{statistics.median(theirs) * 1e3:.2f} ms a slide in pyslammer; {ours * 1e3:.0f} ms the whole program for {3 * COUNT} motions, start and reading included")


main(sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "target/release/standfast"))
