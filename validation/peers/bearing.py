"""Bearing resistance of a strip by groundhog (API RP 2GEO, drained), written to bearing.csv.

    pip install groundhog==0.15.0
    python bearing.py

The test `groundhog_bears_the_same` of the library holds its law `hansen` against the file. groundhog has a base of some
length at some depth: a length of 1e12 m and a depth of 1e-9 m make it a strip on the surface, with its surcharge.
"""

import csv
import math
from pathlib import Path

from groundhog.shallowfoundations.capacity import verticalcapacity_drained_api

LENGTH = 1e12

with (Path(__file__).parent / "bearing.csv").open("w", newline="") as file:
    rows = csv.writer(file, lineterminator="\n")
    rows.writerow(["friction_angle_deg", "unit_weight_kn_m3", "surcharge_kpa", "effective_width_m", "inclination", "resistance_kn_m"])
    for angle in (20, 25, 30, 35, 40, 45, 50):
        for weight in (8.0, 11.5):
            for surcharge in (0.0, 20.0):
                for width in (2.0, 12.5):
                    for inclination in (0.0, 0.2, 0.5):
                        capacity = verticalcapacity_drained_api(
                            vertical_effective_stress=surcharge,
                            effective_friction_angle=angle,
                            effective_unit_weight=weight,
                            effective_length=LENGTH,
                            effective_width=width,
                            base_depth=1e-9,
                            skirted=False,
                            load_inclination=math.degrees(math.atan(inclination)),
                        )["vertical_capacity [kN]"]
                        rows.writerow([angle, weight, surcharge, width, inclination, repr(float(capacity) / LENGTH)])
