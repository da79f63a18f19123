"""Both usual factors, and what the mode, a joint, the ground and the motion in time say of the structures of structures.csv.

    python survey.py PATH/TO/standfast [SITUATIONS.csv]

Asks the program of each structure at each stated level of its load, prints the table of README.md, and writes a row for each situation to
survey.csv, or where it is told. Factors of simple cases are computed here again by elementary statics, and asserted to agree. Python's standard library only;
Python 3.10 or later.
"""

import csv
import io
import json
import math
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

HERE = Path(__file__).resolve().parent
RECORDS = HERE.parents[2] / "examples" / "records"
SIDEWAYS = ("np01002p_4225a_a.smc", "np01002p_4225c_a.smc")  # two horizontal components, each a record of its own
UPWARDS = "np01002p_4225b_a.smc"
G = 9.81
STILL, TURNED = 0.030, 0.20  # m, and share of the angle of balance: less than both is hardly a motion
SHAKINGS = (0.1, 0.2, 0.3, 0.4)  # g, of objects
FRICTIONS = (0.35, 0.6)  # of objects
WALL_SHAKING, QUAY_SHAKINGS = 0.10, (0.10, 0.15, 0.20)
REQUIRED = {  # against sliding, against overturning
    "wave": (1.2, 1.2),
    "quay": (1.2, 1.2),
    "quay shaken": (1.0, 1.1),
    "wall": (1.5, 1.5),
    "wall shaken": (1.1, 1.1),
    "object": (1.0, 1.0),
}
RUBBLES = (40, 35, 45)  # angles of friction of the bed, degrees: the first is that of the classes
TRIMMED = "just passing"  # a caisson or quay of the width at which the factors are just what is required
CLASSES = (
    "agree: passes both, stands",
    "agree: a factor below 1, moves as told",
    "at rest, though a factor is short of what is required",
    "passes both, a joint does not",
    "passes both, the ground gives way",
    "passes both, and moves in time",
    "a factor below 1, and in time it hardly moves",
    "overturning below 1, and nothing turns",
    "sliding the lesser, and it turns",
    "mode not unique",
)
COLUMNS = (
    "id name group status level friction width_m SF_sliding SF_overturning required_sliding required_overturning mode unique first_at first_mode "
    "mode_at_1.2 mode_at_1.5 joint_SF joint_SF_if_open ground_factor ground_factor_35 ground_factor_45 slide_mm turned_share overturned class"
).split()

program = ""
agreed = Counter()


# --- the program ---------------------------------------------------------------------------------------------------------------------------


def run(arguments: list[str], text: str) -> str:
    try:
        said = subprocess.run([program, *arguments], input=text, capture_output=True, text=True, check=False, encoding="utf-8")
    except OSError as error:
        sys.exit(f"{program} cannot be run: {error.strerror}")
    if said.returncode != 0:
        sys.exit(f"{' '.join(arguments)}\n{said.stderr}\n{text}")
    return said.stdout


def assess(text: str) -> dict:
    """The situation of a case that has one."""
    situations = json.loads(run(["assess", "-", "--format", "json", "--no-figures"], text))["situations"]
    assert len(situations) == 1, text
    return situations[0]


def batch(case: str, rows: list[dict], columns: str) -> list[dict]:
    table = io.StringIO()
    writer = csv.DictWriter(table, rows[0].keys(), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "case.toml"
        file.write_text(case, encoding="utf-8")
        arguments = ["batch", "-", "--case", str(file), "-o", "-"] + (["--columns", columns] if columns else [])
        answers = list(csv.DictReader(io.StringIO(run(arguments, table.getvalue()))))
    assert len(answers) == len(rows)
    return answers


def bound(value: object) -> float:
    return math.inf if value in ("infinite", "inf") else float(value)


def kind(mode: str) -> str:
    """The mode without its corner and side."""
    if mode in ("", None):
        return ""
    return {"RE": "rests", "SL": "slides", "SL+": "slides", "RO": "rocks", "RO'": "rocks", "BF": "ground fails"}.get(mode, "slide-rocks")


def peak(name: str) -> float:
    """Largest value of a record, cm/s2: what stands behind the header, of 17 lines of text and numbers and 10 of numbers, and the remarks."""
    lines = (RECORDS / name).read_text(encoding="latin-1").splitlines()[27:]
    values = [float(line[i : i + 10]) for line in lines if not line.startswith("|") for i in range(0, len(line.rstrip()), 10)]
    return max(abs(value) for value in values)


# --- elementary statics, which shares nothing with the program -------------------------------------------------------------------------------


def agree(what: str, ours: float, theirs: float, tolerance: float = 1e-9) -> None:
    assert abs(ours - theirs) <= tolerance * max(abs(ours), abs(theirs)), (what, ours, theirs)
    agreed[what] += 1


def goda(row: dict, width: float, height: float, significant: float, largest: float, period: float) -> dict[str, float]:
    """Goda's pressures with Takahashi's coefficient, per metre; as in Goda (2000)."""
    h, d, base, crest = row["water_depth_m"], row["berm_depth_m"], row["base_depth_m"], height - row["base_depth_m"]
    weight_of_sea = row["water_density_kg_m3"] * G
    k = (2 * math.pi / period) ** 2 / G
    deep = k
    for _ in range(200):  # Newton's, of k tanh kh = k0
        t = math.tanh(k * h)
        k -= (k * t - deep) / (t + k * h * (1 - t * t))
    length = 2 * math.pi / k
    cosine = math.cos(math.radians(row["angle_deg"]))
    at_breaking = h + 5 * significant * row["bottom_slope"]
    a1 = 0.6 + 0.5 * (2 * k * h / math.sinh(2 * k * h)) ** 2
    a2 = min((at_breaking - d) / (3 * at_breaking) * (largest / d) ** 2, 2 * d / largest)
    a3 = 1 - base / h * (1 - 1 / math.cosh(k * h))
    d11 = 0.93 * (row["berm_width_m"] / length - 0.12) + 0.36 * ((h - d) / h - 0.6)
    d22 = -0.36 * (row["berm_width_m"] / length - 0.12) + 0.93 * ((h - d) / h - 0.6)
    d1, d2 = (20 if d11 <= 0 else 15) * d11, (4.9 if d22 <= 0 else 3) * d22
    shape = math.cos(d2) / math.cosh(d1) if d2 <= 0 else 1 / (math.cosh(d1) * math.sqrt(math.cosh(d2)))
    impulsive = min(largest / d, 2) * shape
    run_up = 0.75 * (1 + cosine) * largest
    p1 = 0.5 * (1 + cosine) * (a1 + max(a2, impulsive) * cosine**2) * weight_of_sea * largest
    p3 = a3 * p1
    wet = min(run_up, crest)
    p4 = p1 * (1 - wet / run_up)
    pu = 0.5 * (1 + cosine) * a1 * a3 * weight_of_sea * largest
    thrust = (p1 + p3) / 2 * base + (p1 + p4) / 2 * wet
    moment = (2 * p1 + p3) * base**2 / 6 + (p1 + p4) / 2 * base * wet + (p1 + 2 * p4) * wet**2 / 6
    uplift = pu * width / 2
    return {"P": thrust, "M_p": moment, "U": uplift, "M_U": uplift * width * 2 / 3}


def caisson_weights(row: dict, width: float, height: float) -> tuple[float, float]:
    """Mean densities above and under still water."""
    if row["name"].startswith("Phoenix"):
        shell = row["mass_kg"] / (row["width_m"] * row["height_m"] * row["length_m"])
        return shell, shell + row["water_density_kg_m3"] * (1 - shell / 2400)
    if row["mass_kg"]:
        even = row["mass_kg"] / (row["width_m"] * height * row["length_m"])
        return even, even
    return 2400.0, 2100.0


def caisson_factors(row: dict, width: float, level: tuple[float, float, float]) -> tuple[float, float]:
    height = row["height_m"]
    above, under = caisson_weights(row, width, height)
    base = row["base_depth_m"]
    weight = width * G * (above * (height - base) + (under - row["water_density_kg_m3"]) * base)
    wave = goda(row, width, height, *level)
    return row["friction"] * (weight - wave["U"]) / wave["P"], (weight * width / 2 - wave["M_U"]) / wave["M_p"]


def centred(x: list[float], y: list[float]) -> tuple[float, float, float]:
    """Area and centre of a polygon."""
    area = cx = cy = 0.0
    for i in range(len(x)):
        j = (i + 1) % len(x)
        cross = x[i] * y[j] - x[j] * y[i]
        area, cx, cy = area + cross / 2, cx + (x[i] + x[j]) * cross / 6, cy + (y[i] + y[j]) * cross / 6
    return area, cx / area, cy / area


def wall_factors(row: dict) -> tuple[float, float]:
    """Of weight, water or soil on the right face, and uplift; about the left toe."""
    x, y = row["x"], row["y"]
    area, cx, _ = centred(x, y)
    down = area * row["unit_weight_kN_m3"]
    holding = down * cx
    thrust = turning = 0.0
    if row["model"] == "dam":
        water, unit = row["water_m"], 9.81
        right = 1  # edges of the right face go up from the heel: corners 1, 2, …
        while right + 1 < len(x) and y[right] < min(water, max(y)) and y[right + 1] > y[right]:
            low, high = y[right], min(y[right + 1], water)
            slope = (x[right + 1] - x[right]) / (y[right + 1] - y[right])
            steps = 1 if slope == 0 else 20000
            for i in range(steps):  # exactly where the face is upright, in thin strips where it slopes
                a, b = low + (high - low) * i / steps, low + (high - low) * (i + 1) / steps
                pa, pb = unit * (water - a), unit * (water - b)
                force = (pa + pb) / 2 * (b - a)
                thrust += force
                turning += force * (a + (b - a) * (pa + 2 * pb) / (3 * (pa + pb)) if pa + pb else 0)
                down += -slope * force
                holding += -slope * force * (x[right] + slope * ((a + b) / 2 - y[right]))
            right += 1
        if row["uplift"] == "full":
            lift = unit * water * row["width_m"] / 2
            down -= lift
            holding -= lift * row["width_m"] * 2 / 3
    else:
        active = math.tan(math.radians(45 - row["soil_angle_deg"] / 2)) ** 2
        thrust = active * row["soil_unit_weight_kN_m3"] * row["height_m"] ** 2 / 2
        turning = thrust * row["height_m"] / 3
    return row["friction"] * down / thrust, holding / turning


# --- cases ---------------------------------------------------------------------------------------------------------------------------------


def box(row: dict, width: float, density: float, density_below_water: float) -> str:
    """The body of a caisson or of a quay."""
    return f"""[body]
friction = {row["friction"]!r}
[[part]]
left = 0
width = {width!r}
bottom = 0
height = {row["height_m"]!r}
density = {density!r}
density_below_water = {density_below_water!r}
"""


def caisson_case(row: dict, width: float, level: tuple[float, float, float], times: float = 1, extra: str = "", time: bool = False) -> str:
    height, base = row["height_m"], row["base_depth_m"]
    above, under = caisson_weights(row, width, height)
    history = 'history = { shape = "triangle", duration = "shimosako-takahashi" }\n' if time else ""
    return f"""{box(row, width, above, under)}[water]
level = {base!r}
density = {row["water_density_kg_m3"]!r}
[wave]
H13 = {level[0]!r}
Hmax = {level[1]!r}
period = {level[2]!r}
sea_bottom_slope = {row["bottom_slope"]!r}
water_depth = {row["water_depth_m"]!r}
depth_above_berm = {row["berm_depth_m"]!r}
base_depth = {base!r}
crest_height = {height - base!r}
berm_width = {row["berm_width_m"]!r}
angle_deg = {row["angle_deg"]!r}
{history}[added_mass]
sides = "both"
[[combination]]
name = "all"
factors = {{ wave = {times!r} }}
{extra}"""


def quay_case(row: dict, width: float, shaking: float, extra: str = "") -> str:
    height = row["height_m"]
    still = height - 4
    solid = math.pi / 4 if row["drums"] else 1.0  # of circles side by side water fills the rest
    density = row["unit_weight_kN_m3"] * 1e3 / G * solid
    surcharge = "" if shaking else 'surcharge = "20 kPa"\n'
    earthquake = f'[earthquake]\nhorizontal = "{shaking!r} g"\n[added_mass]\nsides = "left"\n' if shaking else ""
    return f"""{box(row, width, density, density + 1025 * (1 - solid))}[water]
left = {still!r}
right = {still + 0.5!r}
density = 1025
opening = "closed"
[[backfill]]
name = "fill"
face = "right"
friction_angle_deg = 35
wall_friction_deg = 15
unit_weight = "18 kN/m3"
unit_weight_saturated = "20 kN/m3"
{surcharge}{earthquake}{extra}"""


def wall_case(row: dict, shaking: float, extra: str = "") -> str:
    text = f"""[body]
friction = {row["friction"]!r}
[[part]]
x = {row["x"]!r}
y = {row["y"]!r}
unit_weight = {row["unit_weight_kN_m3"] * 1e3!r}
"""
    if row["model"] == "wall":
        text += f"""[[backfill]]
name = "fill"
face = "right"
friction_angle_deg = {row["soil_angle_deg"]!r}
unit_weight = {row["soil_unit_weight_kN_m3"] * 1e3!r}
"""
    elif row["uplift"] == "full":
        text += f'[water]\nleft = 0\nright = {row["water_m"]!r}\ndensity = 1000\nopening = "closed"\n'
    else:
        depth = row["water_m"]
        text += f"""[[pressure]]
name = "water"
face = "right"
elevation = [0, {depth!r}]
pressure = [{depth * 9810!r}, 0]
permanent = true
"""
    if shaking:
        text += f'[earthquake]\nhorizontal = "{shaking!r} g"\n'
        if row["model"] == "dam" and row["uplift"] == "full":
            text += '[added_mass]\nsides = "right"\n'
    return text + extra


def object_case(motion: str = "") -> str:
    earthquake = "" if motion else '[earthquake]\nhorizontal = "0.1 g"\n'
    return f"""[body]
width = 1
height = 2
length = 1
mass = 1000
centroid_height = 1
moment_of_inertia = 400
friction = 0.5
{earthquake}{motion}"""


# --- answers -------------------------------------------------------------------------------------------------------------------------------


def situation(row: dict, level: str, width: float, required: tuple[float, float], answer: dict) -> dict:
    return {
        **{name: "" for name in COLUMNS},
        **{name: row[name] for name in ("id", "name", "group", "status")},
        **({"group": TRIMMED, "status": "realistic"} if width != row["width_m"] else {}),
        "level": level,
        "friction": row["friction"],
        "width_m": width,
        "SF_sliding": bound(answer["SF_sliding"]),
        "SF_overturning": bound(answer["SF_overturning_net"]),
        "required_sliding": required[0],
        "required_overturning": required[1],
        "mode": kind(answer["mode"]),
        "unique": answer["unique"] in (True, "true"),
        "first_at": answer["load_factor"] if answer["departure"] == "at" else "",
        "first_mode": kind(answer["departure_mode"] or "") if answer["departure"] == "at" else "",
    }


def jointed(text: str) -> float:
    """The least factor of the joints above the base, each with all that is above it; 0 where water lifts that."""
    names = ("SF_sliding", "SF_overturning_left", "SF_overturning_right")
    return min(0.0 if joint[name] is None else bound(joint[name]) for joint in assess(text)["joints"][1:] for name in names)


def grounded(angle: float, unit_weight: float, text: str) -> float:
    """Resistance of the ground over the force on it, by EN 1997-1 Annex D, without partial factors."""
    return bound(assess(f"{text}\n[ground]\nfriction_angle_deg = {angle!r}\nunit_weight = {unit_weight!r}\n")["ground"]["factor"])


def bedded(found: dict, text: str) -> None:
    for column, angle in zip(("ground_factor", "ground_factor_35", "ground_factor_45"), RUBBLES, strict=True):
        found[column] = grounded(angle, 10e3, text)


def newmark(acceleration: float, yields_at: float) -> float:
    """Slide to one side of a block that yields at a share of the shaking, m: the worse side of the worse record."""
    worst = 0.0
    if yields_at >= 1:
        return worst
    for record in SIDEWAYS:
        file = (RECORDS / record).as_posix()
        case = f"""[body]
width = 10
height = 2
density = 2000
friction = 0.5
[motion.base]
horizontal = {{ shape = "file", file = "{file}", target_peak = "{acceleration!r} g" }}
"""
        with tempfile.TemporaryDirectory() as folder:
            share = max(yields_at, 0.001)
            arguments = ["spectrum", "-", "--kind", "newmark", "--ratio", f"{share!r},{share * 1.0001!r},2", "--format", "json", "-o", folder]
            point = json.loads(run(arguments, case))["points"][0]
        worst = max(worst, point["left"], point["right"])
    return worst


def caissons(rows: list[dict]) -> list[dict]:
    found = []
    for row in rows:
        levels = list(zip(row["H13"], row["Hmax"], row["T"], strict=True))
        for level in levels:
            widths = [("", row["width_m"])]
            if min(caisson_factors(row, row["width_m"], level)) > 1.2:  # the width at which the lesser factor is what is required
                low, high = 0.1 * row["width_m"], row["width_m"]
                for _ in range(60):
                    middle = (low + high) / 2
                    low, high = (low, middle) if min(caisson_factors(row, middle, level)) >= 1.2 else (middle, high)
                widths.append((", at the width that passes just", math.ceil(high * 1000) / 1000))
            for words, width in widths:
                answer = assess(caisson_case(row, width, level))
                one = situation(row, f"H1/3 {level[0]:g} m, T {level[2]:g} s{words}", width, REQUIRED["wave"], answer)
                sliding, overturning = caisson_factors(row, width, level)
                agree("waves, sliding", sliding, one["SF_sliding"])
                agree("waves, overturning", overturning, one["SF_overturning"])
                for times in (1.2, 1.5):
                    one[f"mode_at_{times}"] = kind(assess(caisson_case(row, width, level, times))["mode"])
                for column, uplift in (("joint_SF", "tight"), ("joint_SF_if_open", "open")):
                    joint = f'[[joint]]\nelevation = {row["base_depth_m"] + 1!r}\nfriction = 0.6\nuplift = "{uplift}"\n'
                    one[column] = jointed(caisson_case(row, width, level, 1, joint))
                bedded(one, caisson_case(row, width, level))
                arguments = ["simulate", "-", "--format", "json", "--no-strength", "--no-figures"]
                motion = json.loads(run(arguments, caisson_case(row, width, level, 1, "", True)))
                one["slide_mm"] = 1000 * abs(motion["max_slide"])
                one["turned_share"] = abs(motion["max_theta_of_balance"])
                one["overturned"] = motion["overturned"]
                found.append(one)
    return found


def shaken(found: dict, shaking: float, answer: dict) -> None:
    """The slide in time of a wall that first slides, by its own yield acceleration, soil and water with it."""
    if shaking and answer["departure"] == "at" and kind(answer["departure_mode"]) == "slides":
        found["slide_mm"], found["turned_share"], found["overturned"] = 1000 * newmark(shaking, answer["load_factor"]), 0.0, False


def quays(rows: list[dict]) -> list[dict]:
    found = []
    for row in rows:
        for shaking in (0.0, *QUAY_SHAKINGS):
            required = REQUIRED["quay shaken" if shaking else "quay"]

            def enough(width: float, row: dict = row, shaking: float = shaking, required: tuple = required) -> bool:
                answer = assess(quay_case(row, width, shaking))
                return bound(answer["SF_sliding"]) >= required[0] and bound(answer["SF_overturning_net"]) >= required[1]

            widths = [("", row["width_m"])]
            if enough(row["width_m"]):
                low, high = 0.05 * row["width_m"], row["width_m"]
                while high - low > 0.005:
                    middle = (low + high) / 2
                    low, high = (low, middle) if enough(middle) else (middle, high)
                widths.append((", at the width that passes just", math.ceil(high * 1000) / 1000))
            for words, width in widths:
                answer = assess(quay_case(row, width, shaking))
                one = situation(row, (f"{shaking:g} g" if shaking else "at rest, surcharge") + words, width, required, answer)
                if shaking:
                    for times in (1.2, 1.5):
                        one[f"mode_at_{times}"] = kind(assess(quay_case(row, width, round(shaking * times, 6)))["mode"])
                shaken(one, shaking, answer)
                if row["drums"]:
                    rings = int(row["drums"])
                    joints = "".join(f'[[joint]]\nelevation = {2.0 * i!r}\nfriction = 0.6\nuplift = "open"\n' for i in range(1, rings + 1))
                    one["joint_SF"] = jointed(quay_case(row, width, shaking, joints))
                bedded(one, quay_case(row, width, shaking))
                found.append(one)
    return found


def walls(rows: list[dict]) -> list[dict]:
    found = []
    for row in rows:
        for shaking in (0.0, WALL_SHAKING):
            answer = assess(wall_case(row, shaking))
            required = REQUIRED["wall shaken" if shaking else "wall"]
            one = situation(row, f"{shaking:g} g" if shaking else "at rest", row["width_m"], required, answer)
            if shaking:
                for times in (1.2, 1.5):
                    one[f"mode_at_{times}"] = kind(assess(wall_case(row, round(shaking * times, 6)))["mode"])
            else:
                sliding, overturning = wall_factors(row)
                agree("walls and dams, sliding", sliding, one["SF_sliding"])
                # The moment of water on a slope is a sum over strips.
                agree("walls and dams, overturning", overturning, one["SF_overturning"], 1e-9)
            shaken(one, shaking, answer)
            water = {"full": 'uplift = "open"\n', "none": 'uplift = "tight"\n', "": ""}[row["uplift"]]
            joint = f"[[joint]]\nelevation = {row['height_m'] / 2!r}\nfriction = {row['friction']!r}\n{water}"
            one["joint_SF"] = jointed(wall_case(row, shaking, joint))
            if row["model"] == "wall":
                one["ground_factor"] = grounded(row["soil_angle_deg"], row["soil_unit_weight_kN_m3"] * 1e3, wall_case(row, shaking))
            found.append(one)
    return found


def stacked(row: dict) -> tuple[float, float, float]:
    """Mass, height of the centre and moment of inertia of two blocks on each other, glued."""
    upper = row["upper_height_m"]
    parts = (
        (row["mass_kg"] - row["upper_mass_kg"], row["width_m"], row["height_m"] - upper, 0.0),
        (row["upper_mass_kg"], row["upper_width_m"], upper, row["height_m"] - upper),
    )
    centre = sum(m * (bottom + h / 2) for m, _, h, bottom in parts) / row["mass_kg"]
    return row["mass_kg"], centre, sum(m * ((w**2 + h**2) / 12 + (bottom + h / 2 - centre) ** 2) for m, w, h, bottom in parts)


def stack_case(row: dict, shaking: float) -> str:
    text, upper = f"[body]\nfriction = {row['friction']!r}\nlength = {row['width_m']!r}\n", row["upper_height_m"]
    for name, mass, width, bottom, height in (
        ("lower", row["mass_kg"] - row["upper_mass_kg"], row["width_m"], 0.0, row["height_m"] - upper),
        ("upper", row["upper_mass_kg"], row["upper_width_m"], row["height_m"] - upper, upper),
    ):
        left, density = (row["width_m"] - width) / 2, mass / (width * height * row["width_m"])
        text += f'[[part]]\nname = "{name}"\nleft = {left!r}\nwidth = {width!r}\nbottom = {bottom!r}\nheight = {height!r}\ndensity = {density!r}\n'
    return text + f'[earthquake]\nhorizontal = "{shaking!r} g"\n[[joint]]\nelevation = {row["height_m"] - upper!r}\nfriction = {row["friction"]!r}\n'


def objects(rows: list[dict]) -> list[dict]:
    asked, still = [], []
    for row in rows:
        for friction in FRICTIONS:
            for shaking in SHAKINGS:
                width, height, mass = row["width_m"], row["height_m"], row["mass_kg"]
                across = 3 * (width / 2) ** 2 if row["model"] == "column" else width**2
                centre, inertia = row["centroid_height_m"] or height / 2, mass * (across + height**2) / 12
                if row["upper_mass_kg"]:
                    mass, centre, inertia = stacked(row)
                asked.append(({**row, "friction": friction}, shaking))
                still.append({
                    "body.width": width,
                    "body.height": height,
                    "body.mass": mass,
                    "body.centroid_height": centre,
                    "body.moment_of_inertia": inertia,
                    "body.friction": friction,
                })  # fmt: skip
    columns = "mode,unique,departure,load_factor,departure_mode,SF_sliding,SF_overturning_net"
    answers = {}
    for times in (1, 1.2, 1.5):
        shakings = [{**body, "earthquake.horizontal": f"{shaking * times!r} g"} for body, (_, shaking) in zip(still, asked, strict=True)]
        answers[times] = batch(object_case(), shakings, columns)
    motions = []
    for record in SIDEWAYS:
        files = [(RECORDS / name).as_posix() for name in (record, UPWARDS)]
        motion = "".join(
            f'{where} = {{ shape = "file", file = "{file}", factor = 1 }}\n' for where, file in zip(("horizontal", "vertical"), files, strict=True)
        )
        largest = peak(record) / 100
        factors = [shaking * G / largest for _, shaking in asked]
        rows_in_time = [
            {**body, "motion.base.horizontal.factor": factor, "motion.base.vertical.factor": factor}
            for body, factor in zip(still, factors, strict=True)
        ]
        case = object_case('[motion]\nt_max = "60 s"\n[motion.base]\n' + motion)
        motions.append(batch(case, rows_in_time, "end,max_slide,max_theta_of_balance,overturned"))
    found = []
    for i, ((row, shaking), body) in enumerate(zip(asked, still, strict=True)):
        one = situation(row, f"{shaking:g} g", row["width_m"], REQUIRED["object"], answers[1][i])
        agree("objects, sliding", row["friction"] / shaking, one["SF_sliding"])
        agree("objects, overturning", row["width_m"] / 2 / body["body.centroid_height"] / shaking, one["SF_overturning"])
        for times in (1.2, 1.5):
            one[f"mode_at_{times}"] = kind(answers[times][i]["mode"])
        ends = [motion[i] for motion in motions]
        assert all(end["end"] in ("rest", "overturned", "time") for end in ends), ends
        one["overturned"] = any(end["overturned"] == "true" for end in ends)
        one["slide_mm"] = max(1000 * abs(float(end["max_slide"])) for end in ends)
        one["turned_share"] = max(abs(float(end["max_theta_of_balance"])) for end in ends)
        if row["upper_mass_kg"]:
            one["joint_SF"] = jointed(stack_case(row, shaking))
        if row["drums"]:
            drums, height = int(row["drums"]), row["height_m"]
            joints = "".join(f"[[joint]]\nelevation = {height * k / drums!r}\nfriction = {row['friction']!r}\n" for k in range(1, drums))
            text = f'[body]\nshape = "cylinder"\nwidth = {row["width_m"]!r}\nheight = {height!r}\nmass = {row["mass_kg"]!r}\n'
            text += f"friction = {row['friction']!r}\n"
            one["joint_SF"] = jointed(text + f'[earthquake]\nhorizontal = "{shaking!r} g"\n' + joints)
        found.append(one)
    return found


# --- what it comes to ----------------------------------------------------------------------------------------------------------------------


def moves(one: dict) -> bool | None:
    """Whether it moves noticeably in time; None where that was not asked."""
    if one["slide_mm"] == "":
        return None
    return one["overturned"] or one["slide_mm"] >= 1000 * STILL or one["turned_share"] >= TURNED


def turns(one: dict) -> bool:
    return one["mode"] in ("rocks", "slide-rocks")


def classed(one: dict) -> str:
    """Of all classes the one that it is in. What the factors say comes first, then the mode, a joint, the ground, time."""
    sliding, overturning = one["SF_sliding"], one["SF_overturning"]
    if not one["unique"]:
        return "mode not unique"
    # The exact statement, without which nothing below means anything: it rests where both factors are 1 or more.
    assert (min(sliding, overturning) >= 1) == (one["mode"] == "rests"), one
    if sliding >= one["required_sliding"] and overturning >= one["required_overturning"]:
        if one["joint_SF"] != "" and one["joint_SF"] < min(one["required_sliding"], one["required_overturning"]) - 1e-12:
            return "passes both, a joint does not"
        if one["ground_factor"] != "" and one["ground_factor"] < 1:
            return "passes both, the ground gives way"
        return "passes both, and moves in time" if moves(one) else "agree: passes both, stands"
    if one["mode"] == "rests":
        return "at rest, though a factor is short of what is required"
    if moves(one) is False:
        return "a factor below 1, and in time it hardly moves"
    if overturning < 1 and not turns(one):
        return "overturning below 1, and nothing turns"
    if sliding <= overturning and turns(one):
        return "sliding the lesser, and it turns"
    return "agree: a factor below 1, moves as told"


def numbers(row: dict) -> dict:
    texts = ("id", "name", "group", "status", "model", "uplift", "source", "read", "from_source", "assumed", "x_m", "y_m", "H13_m", "Hmax_m", "T_s")
    out = {name: value if name in texts else (float(value) if value else "") for name, value in row.items()}
    for name, column in (("x", "x_m"), ("y", "y_m"), ("H13", "H13_m"), ("Hmax", "Hmax_m"), ("T", "T_s")):
        out[name] = [float(part) for part in row[column].split(";")] if row[column] else []
    return out


def told(found: list[dict], structures: list[dict]) -> None:
    groups = ["caisson", "quay", TRIMMED, "wall or dam", "monument", "museum object", "rack or machine"]
    print(f"{len(structures)} structures, {len(found)} situations")
    for status, count in Counter(row["status"] for row in structures).items():
        print(f"  {status}: {count}")
    heads = ("caissons", "quays", "just passing", "walls, dams", "monuments", "museum", "racks")
    short = dict(zip(groups, heads, strict=True))
    print(f"\n{'':55s}" + "".join(f"{short[g]:>14s}" for g in groups) + f"{'all':>8s}")

    def line(words: str, chosen: list[dict]) -> None:
        counts = Counter(one["group"] for one in chosen)
        print(f"{words:55s}" + "".join(f"{counts[g]:14d}" for g in groups) + f"{len(chosen):8d}")

    members = Counter(row["group"] for row in structures)
    print(f"{'structures':55s}" + "".join(f"{members[g]:14d}" for g in groups) + f"{len(structures):8d}")
    line("situations", found)
    print()
    for name in CLASSES:
        line(name, [one for one in found if one["class"] == name])
    assert sum(Counter(one["class"] for one in found)[name] for name in CLASSES) == len(found)

    passing = [one for one in found if one["SF_sliding"] >= one["required_sliding"] and one["SF_overturning"] >= one["required_overturning"]]
    print("\nboth factors pass")
    line("  all", passing)
    line("  a joint, the ground or time says otherwise", [one for one in passing if one["class"].startswith("passes both")])
    line("  of the joints asked", [one for one in passing if one["joint_SF"] != ""])
    line("    a joint is short of what is required", [one for one in passing if one["class"] == "passes both, a joint does not"])
    line("    a joint does not rest", [one for one in passing if one["joint_SF"] != "" and one["joint_SF"] < 1])
    opened = [one for one in passing if one["joint_SF_if_open"] != "" and one["joint_SF_if_open"] < 1]
    line("    a cap's joint does not rest, if the wave enters it", opened)
    line("  of the grounds asked", [one for one in passing if one["ground_factor"] != ""])
    line("    R/V below 1", [one for one in passing if one["ground_factor"] != "" and one["ground_factor"] < 1])
    line("    R/V below 1 on a bed of 35 degrees", [one for one in passing if one["ground_factor_35"] != "" and one["ground_factor_35"] < 1])
    line("    R/V below 1 on a bed of 45 degrees", [one for one in passing if one["ground_factor_45"] != "" and one["ground_factor_45"] < 1])
    line("  at 1.2 times the load it does not rest", [one for one in passing if one["mode_at_1.2"] not in ("", "rests")])
    line("  at 1.5 times the load it does not rest", [one for one in passing if one["mode_at_1.5"] not in ("", "rests")])

    failing = [one for one in found if min(one["SF_sliding"], one["SF_overturning"]) < 1]
    timed = [one for one in failing if one["slide_mm"] != ""]
    print("\na factor below 1")
    line("  all", failing)
    line("  overturning below 1", [one for one in failing if one["SF_overturning"] < 1])
    line("    and nothing turns", [one for one in failing if one["SF_overturning"] < 1 and not turns(one)])
    line("  sliding the lesser, both below 1", [one for one in failing if one["SF_sliding"] <= one["SF_overturning"] < 1])
    line("    and it turns", [one for one in failing if one["SF_sliding"] <= one["SF_overturning"] < 1 and turns(one)])
    line("  overturning the lesser, both below 1", [one for one in failing if one["SF_overturning"] < one["SF_sliding"] < 1])
    line("    and it slides only", [one for one in failing if one["SF_overturning"] < one["SF_sliding"] < 1 and one["mode"] == "slides"])
    line("    and it slide-rocks", [one for one in failing if one["SF_overturning"] < one["SF_sliding"] < 1 and one["mode"] == "slide-rocks"])
    line("  followed in time", timed)
    line("    hardly moves", [one for one in timed if not moves(one)])
    line("    overturning below 1", [one for one in timed if one["SF_overturning"] < 1])
    line("      does not overturn", [one for one in timed if one["SF_overturning"] < 1 and not one["overturned"]])
    line("    overturns", [one for one in timed if one["overturned"]])

    things = [one for one in failing if one["group"] in ("monument", "museum object", "rack or machine")]
    heights = {row["id"]: row["height_m"] for row in structures}
    print("\nobjects whose overturning factor is the lesser and below 1, by height: situations, hardly move in time, overturn")
    turning = [one for one in things if one["SF_overturning"] < min(one["SF_sliding"], 1)]
    bands = ((0.8, 1), (0.6, 0.8), (0.4, 0.6), (0, 0.4))
    print(f"{'':18s}" + "".join(f"{f'{low:g} to {high:g}':>21s}" for low, high in bands))
    for low, high in ((0, 0.6), (0.6, 1.2), (1.2, 2.5), (2.5, 50)):
        line_of = f"  {low:g} to {high:g} m".ljust(18)
        for least, most in bands:
            these = [one for one in turning if low <= heights[one["id"]] < high and least <= one["SF_overturning"] < most]
            line_of += f"{len(these):9d}{sum(not moves(one) for one in these):6d}{sum(one['overturned'] for one in these):6d}"
        print(line_of)
    print("\nobjects whose sliding factor is the lesser and below 1: situations, hardly move in time, largest slide of those that do not overturn, mm")
    for friction in FRICTIONS:
        for shaking in SHAKINGS:
            these = [one for one in things if one["friction"] == friction and one["level"] == f"{shaking:g} g"]
            these = [one for one in these if one["SF_sliding"] <= one["SF_overturning"]]
            if these:
                farthest = max((one["slide_mm"] for one in these if not one["overturned"]), default=0)
                print(f"  friction {friction:g}, {shaking:g} g: {len(these):5d}{sum(not moves(one) for one in these):6d}{farthest:8.0f}")
    print("\nbounds of a motion that hardly is one: situations of those followed in time, which stay below them")
    for slide, share in ((10, 0.1), (30, 0.2), (50, 0.3), (100, 0.5)):
        inside = sum(not one["overturned"] and one["slide_mm"] < slide and one["turned_share"] < share for one in timed)
        print(f"  {slide} mm and {share:g} of the angle of balance: {inside} of {len(timed)}")
    print("\nfactors computed here again, to 1e-9: " + ", ".join(f"{name} {count}" for name, count in agreed.items()))


def main() -> None:
    global program
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    program = sys.argv[1]
    with open(HERE / "structures.csv", newline="", encoding="utf-8") as file:
        structures = [numbers(row) for row in csv.DictReader(file)]
    of = lambda *models: [row for row in structures if row["model"] in models]  # noqa: E731
    found = caissons(of("caisson")) + quays(of("quay")) + walls(of("wall", "dam")) + objects(of("object", "column"))
    for one in found:
        one["class"] = classed(one)
    situations = Path(sys.argv[2]) if len(sys.argv) == 3 else HERE / "survey.csv"
    with open(situations, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        for one in found:
            writer.writerow({name: f"{value:.5g}" if isinstance(value, float) else value for name, value in one.items()})
    told(found, structures)


if __name__ == "__main__":
    main()
