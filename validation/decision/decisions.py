"""Where the map of modes changes a decision, and where it does not.

    python3 decisions.py PATH/TO/standfast [ROWS]        # 40000 rows of each kind if not given

Draws bodies from the ranges below with a fixed seed, asks the program for both safety factors and for the mode of response, and counts how
often the mode is the one that the lesser factor suggests: sliding the lesser, it slides; overturning the lesser, it rocks. The ranges span
what is built and what is too light to stay, because only a body that moves has a mode. They are not a survey: shares are those of
these ranges, and say where a surprise is possible and where it is not, not how often one is met. Python's standard library only; Python 3.10 or later.
"""

import csv
import io
import math
import random
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
G = 9.81
COLUMNS = "mode,unique,also,departure,load_factor,departure_mode,SF_sliding,SF_overturning_net"


def caissons(rows: int) -> list[dict[str, float]]:
    """Vertical caissons on a rubble mound, under the design wave of one sea by Goda's formulas, head on to 30 degrees."""
    draw = random.Random(2000)
    found = []
    while len(found) < rows:
        height_of_sea = draw.uniform(2.5, 8.0)  # H0', m: sheltered to severe
        steepness = draw.uniform(0.012, 0.045)  # H0'/L0: swell to wind sea
        period = math.sqrt(2 * math.pi * height_of_sea / steepness / G)
        depth = draw.uniform(7.0, 20.0)  # h, m
        base_depth = depth * draw.uniform(0.5, 0.9)  # h': low to high mounds
        above_berm = base_depth - draw.uniform(0.8, 2.0)  # d: armour and foot protection
        crest = height_of_sea * draw.uniform(0.5, 1.0)  # h_c: 0.6 H13 is usual
        height = base_depth + crest
        width = height * draw.uniform(0.6, 1.6)  # slenderness 0.63 to 1.67
        above, below = draw.uniform(2200, 2400), draw.uniform(1950, 2250)  # kg/m3: crown and concrete; cells with sand
        friction = draw.uniform(0.5, 0.7)  # concrete on rubble
        slope, berm, angle = draw.uniform(0.005, 0.04), draw.uniform(5, 15), draw.uniform(0, 30)
        # A sea that cannot be, or that Goda's pressures are not meant for, is drawn again.
        if not (6 <= period <= 18 and depth >= 1.2 * height_of_sea and above_berm >= 0.3 * depth):
            continue
        found.append({
            "body.width": width,
            "body.mass": width * (above * crest + below * base_depth),
            "body.friction": friction,
            "wave.caisson_width": width,
            "wave.deep_water_height": height_of_sea,
            "wave.period": period,
            "wave.sea_bottom_slope": slope,
            "wave.water_depth": depth,
            "wave.depth_above_berm": above_berm,
            "wave.base_depth": base_depth,
            "wave.crest_height": crest,
            "wave.berm_width": berm,
            "wave.angle_deg": angle,
        })  # fmt: skip
    return found


def height(row: dict[str, float]) -> float:
    """Height of a caisson, which follows from its depth and crest, as the level of still water does from its depth."""
    return row["wave.base_depth"] + row["wave.crest_height"]


def objects(rows: int) -> list[dict[str, float | str]]:
    """Statues, racks, columns and cabinets, 1 m out of the plane, under the peak of a horizontal earthquake, to either side."""
    draw = random.Random(1996)
    found: list[dict[str, float | str]] = []
    for _ in range(rows):
        width = draw.uniform(0.3, 1.2)
        height = width * draw.uniform(1.2, 5.0)
        mass = width * height * draw.uniform(200, 2700)  # kg: a rack to marble
        foot = width * draw.uniform(0.7, 1.0)
        offset = width * draw.uniform(-0.06, 0.06)
        friction = draw.uniform(0.2, 0.8)
        found.append({
            "body.width": width,
            "body.height": height,
            "body.mass": mass,
            "body.base_left": foot / 2,
            "body.base_right": foot / 2,
            "body.centroid_offset": offset,
            "body.centroid_height": height * draw.uniform(0.38, 0.55),
            "body.moment_of_inertia": mass * (width**2 + height**2) / 12 * draw.uniform(0.8, 1.2),
            "body.friction": friction,
            "body.kinetic_friction": friction * draw.uniform(0.8, 1.0),
            "earthquake.horizontal": f"{draw.uniform(0.05, 0.9)!r} g",
        })  # fmt: skip
    return found


def asked(program: str, rows: list, case: str) -> list[dict]:
    """What the program says of each row."""
    table = io.StringIO()
    writer = csv.DictWriter(table, rows[0].keys(), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    command = [program, "batch", "-", "--case", str(ROOT / case), "-o", "-", "--columns", COLUMNS]
    said = subprocess.run(command, input=table.getvalue(), capture_output=True, text=True, check=False, encoding="utf-8")
    if said.returncode != 0:
        sys.exit(said.stderr)
    answers = list(csv.DictReader(io.StringIO(said.stdout)))
    assert len(answers) == len(rows)
    for answer in answers:
        for name in ("SF_sliding", "SF_overturning_net"):
            answer[name] = float(answer[name])
        # The exact statement, without which nothing below means anything: rest is where both factors are 1 or more.
        rests = min(answer["SF_sliding"], answer["SF_overturning_net"]) >= 1
        assert rests == (answer["mode"] == "RE"), answer
    return answers


def kind(mode: str) -> str:
    """The mode without its corner and side."""
    return {"RE": "rests", "SL": "slides", "SL+": "slides", "RO": "rocks", "RO'": "rocks"}.get(mode, "slide-rocks")


def share(part: int, whole: int) -> str:
    return f"{part} of {whole}" + (f", {100 * part / whole:.1f} %" if whole else "")


def told(name: str, answers: list[dict]) -> None:
    """The table of one kind of body."""
    print(f"{name}: {len(answers)}")
    factors = [(answer["SF_sliding"], answer["SF_overturning_net"]) for answer in answers]
    enough = [answer for answer, pair in zip(answers, factors, strict=True) if min(pair) >= 1.2]
    print(f"  both factors 1.2 or more: {len(enough)}, of which rest {sum(a['mode'] == 'RE' for a in enough)}")
    groups = {
        "sliding below 1 alone": lambda s, o: s < 1 <= o,
        "overturning below 1 alone": lambda s, o: o < 1 <= s,
        "both below 1, sliding the lesser": lambda s, o: s <= o < 1,
        "both below 1, overturning the lesser": lambda s, o: o < s < 1,
    }
    print(f"  {'below 1, so that it moves':37s} {'bodies':>6s} {'slides':>7s} {'rocks':>7s} {'slide-rocks':>11s}   as the lesser factor suggests")
    moving = agreeing = 0
    for words, holds in groups.items():
        group = [answer for answer, pair in zip(answers, factors, strict=True) if holds(*pair)]
        kinds = [kind(answer["mode"]) for answer in group]
        suggested = kinds.count("rocks" if "overturning the" in words or words.startswith("over") else "slides")
        counts = [kinds.count(one) for one in ("slides", "rocks", "slide-rocks")]
        assert sum(counts) == len(group)
        moving, agreeing = moving + len(group), agreeing + suggested
        print(f"  {words:37s} {len(group):6d} {counts[0]:7d} {counts[1]:7d} {counts[2]:11d}   {share(suggested, len(group))}")
    print(f"  of all that move the mode is the suggested one in {share(agreeing, moving)}")
    only = [a for a, (_, o) in zip(answers, factors, strict=True) if o < 1 and kind(a["mode"]) == "slides"]
    below = sum(o < 1 for _, o in factors)
    print(f"  overturning below 1, and nothing turns: {share(len(only), below)}")
    turned = [a for a, (_, o) in zip(answers, factors, strict=True) if o >= 1 and kind(a["mode"]) not in ("rests", "slides")]
    print(f"  overturning 1 or more, and yet it turns: {len(turned)} of the {moving} that move")
    print(f"  answer not unique: {sum(answer['unique'] != 'true' for answer in answers)}")
    first = [(a, s, o) for a, (s, o) in zip(answers, factors, strict=True) if a["departure"] == "at"]
    same = sum(kind(a["departure_mode"]) == ("slides" if s <= o else "rocks") for a, s, o in first)
    print(f"  as the load rises from nothing, the first mode is the one of the lesser factor: {share(same, len(first))}")
    changed = [a for a, _, _ in first if a["mode"] != "RE" and kind(a["departure_mode"]) != kind(a["mode"])]
    print(f"  of those that move, another mode at the full load than at the first: {share(len(changed), moving)}")
    near = [float(a["load_factor"]) for a, s, o in first if 1.2 <= min(s, o) < 1.25]
    if near:
        near.sort()
        print(f"  lesser factor 1.20 to 1.25: {len(near)}; they leave rest at {near[0]:.2f} to {near[-1]:.2f} times the load, half below {near[len(near) // 2]:.2f}")
    print()


def main() -> None:
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    program = sys.argv[1]
    rows = int(sys.argv[2]) if len(sys.argv) > 2 else 40000
    drawn = caissons(rows)
    answers = asked(program, drawn, "validation/decision/caisson.toml")
    told("caissons under waves", answers)
    wide = [row["body.width"] >= height(row) for row in drawn]
    told("of these, as wide as high or wider", [answer for answer, is_wide in zip(answers, wide, strict=True) if is_wide])
    told("of these, higher than wide", [answer for answer, is_wide in zip(answers, wide, strict=True) if not is_wide])
    told("statues, racks, columns under an earthquake", asked(program, objects(rows), "examples/monument.toml"))


if __name__ == "__main__":
    main()
