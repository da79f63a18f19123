"""Bearing resistance of a strip, and of a base of some length, by groundhog (API RP 2GEO, drained), written to bearing.csv.

    pip install groundhog==0.15.0
    python bearing.py

The test `groundhog_bears_the_same` of the library holds its law `hansen` against the file. groundhog has a base of some
length at some depth: a length of 1e12 m and a depth of 1e-9 m make it a strip on the surface, with its surcharge. What it bears is told per metre of
the length.
"""

import csv
import itertools
import math
from pathlib import Path

from groundhog.shallowfoundations.capacity import verticalcapacity_drained_api

LENGTHS = (1e12, 15.0)

with (Path(__file__).parent / "bearing.csv").open("w", newline="") as file:
    rows = csv.writer(file, lineterminator="\n")
    rows.writerow(["friction_angle_deg", "unit_weight_kn_m3", "surcharge_kpa", "effective_width_m", "inclination", "resistance_kn_m", "length_m"])
    cases = itertools.product(LENGTHS, (20, 25, 30, 35, 40, 45, 50), (8.0, 11.5), (0.0, 20.0), (2.0, 12.5), (0.0, 0.2, 0.5))
    for length, angle, weight, surcharge, width, inclination in cases:
        capacity = verticalcapacity_drained_api(
            vertical_effective_stress=surcharge,
            effective_friction_angle=angle,
            effective_unit_weight=weight,
            effective_length=length,
            effective_width=width,
            base_depth=1e-9,
            skirted=False,
            load_inclination=math.degrees(math.atan(inclination)),
        )["vertical_capacity [kN]"]
        rows.writerow([angle, weight, surcharge, width, inclination, repr(float(capacity) / length), length])
