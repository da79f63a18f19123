"""Text, JSON and Python, cases and tables of them, give the same numbers and words: of every example, and of 500 random cases."""

from __future__ import annotations

import json
import math
import random
import re
import subprocess
from concurrent.futures import ThreadPoolExecutor
from decimal import ROUND_HALF_EVEN, Context
from pathlib import Path
from typing import Any

import pytest
import standfast

ROOT = Path(__file__).parents[2]
EXAMPLES = sorted((ROOT / "examples").glob("*.toml"))
RULE = "─" * 88


def random_case(seed: int) -> str:
    """A case file with the parts that such files have, in SI units or others."""
    n = random.Random(seed)
    width, height = n.uniform(2, 20), n.uniform(2, 20)
    friction = 0 if n.random() < 0.05 else n.uniform(0.02, 1.2)
    lines = ["[body]", f"width = {width}", f'height = "{height * 100} cm"', f"friction = {friction}"]
    lines += [f"density = {n.uniform(1500, 2700)}" if n.random() < 0.5 else f'mass = "{n.uniform(2, 3) * width * height} t/m"']
    if n.random() < 0.3:
        lines += [f"kinetic_friction = {friction * n.choice([1, 1, n.uniform(0.5, 1)])}"]
    if n.random() < 0.2:
        lines += [f"centroid_offset = {n.uniform(-0.3, 0.3) * width}", f"centroid_height = {n.uniform(0.2, 0.8) * height}"]
    has_wave, has_water = n.random() < 0.2, n.random() < 0.4
    if has_wave:
        depth = n.uniform(0.5, 0.8) * height
        lines += ["[wave]", f"deep_water_height = {n.uniform(0.5, 0.6) * depth}", f"period = {n.uniform(6, 14)}"]
        lines += ["sea_bottom_slope = 0.01", f"water_depth = {1.4 * depth}", f"depth_above_berm = {0.8 * depth}"]
        lines += [f"base_depth = {depth}", f"crest_height = {height - depth}", f"berm_width = {n.uniform(2, 10)}"]
        lines += [f"angle_deg = {n.uniform(0, 60)}", "water_density = 1030", "[water]", f"level = {depth}"]
    elif has_water:
        lines += ["[water]", "density = 1025"]
        if n.random() < 0.5:
            lines += [f"level = {n.uniform(0.1, 0.9) * height}"]
        else:
            lines += [f"left = {n.uniform(0, 0.9) * height}", f"right = {n.uniform(0, 0.9) * height}"]
    if n.random() < 0.2:
        lines += ["[uplift]", f'right = "{n.uniform(1, 80)} kPa"', f"left = 0", f"grows = {n.choice(['true', 'false'])}"]
    if n.random() < 0.2:
        lines += ["[earthquake]", f'horizontal = "{n.uniform(-0.4, 0.4)} g"', f'vertical = "{n.uniform(-0.2, 0.2)} g"']
        lines += ["[added_mass]", f"sides = {n.choice([1, 2])}"] if has_wave or has_water else []
    factors = []
    for i in range(n.choice([0, 0, 0, 1, 2])):
        face, along, end = n.choice(
            [("left", "elevation", height), ("right", "elevation", height), ("base", "distance", width), ("top", "distance", width)]
        )
        places = sorted(n.uniform(0, end) for _ in range(n.choice([2, 3])))
        lines += ["[[pressure]]", f'name = "p{i}"', f'face = "{face}"', f"{along} = {places}"]
        lines += [f"pressure = {[n.uniform(-2e4, 6e4) for _ in places]}", f"permanent = {n.choice(['true', 'false'])}"]
        factors += [f"p{i} = {n.uniform(0, 2)}"]
    for i in range(0 if has_wave and n.random() < 0.5 else n.choice([1, 1, 2, 3])):
        force = 10 ** n.uniform(-2, 1) * width * height * 2e4
        lines += ["[[load]]", f'force = "{force / 1e3} kN/m"', f"elevation = {n.uniform(0, 1) * height}"]
        if n.random() < 0.5:
            lines += [f'name = "number {i}"']
            factors += [f'"number {i}" = {n.uniform(0, 2)}']
        lines += n.choice([[], [], ['direction = "right"'], ['direction = "down"', f"distance = {n.uniform(0, width)}"]])
        lines += n.choice([[], [], [], ["together = true"], ["permanent = true"]])
    if n.random() < 0.25:
        factors += [f"weight = {n.uniform(0.8, 1.1)}"] + ([f"wave = {n.uniform(0.5, 1.5)}"] if has_wave else [])
        for _ in range(n.choice([1, 2, 3])):
            lines += ["[[combination]]", f"factors = {{ {', '.join(n.sample(factors, n.randint(0, len(factors))))} }}"]
    if n.random() < 0.4:
        criteria = ["SF_sliding = 1.2", "SF_overturning_net = 1.5", 'bearing_max = "400 kPa"', "contact_share = 0.667", "load_factor = 1.1"]
        criteria += [f"eccentricity = {width / 6}", 'modes_not = ["RO", "SRO-"]']
        lines += ["[criteria]", *n.sample(criteria, n.randint(1, len(criteria)))]
    text = on_ground("\n".join(lines) + "\n", width, height, random.Random(-10_000 - seed))
    text = of_a_kind(text, width, height, random.Random(-1 - seed))
    return beside_and_held(text, width, height, random.Random(-20_000 - seed))


def beside_and_held(text: str, width: float, height: float, n: random.Random) -> str:
    """Some cases with soil beside them, a couple, adhesion or resistances, standing waves, or levels of a chart."""
    kind = n.choice(["soil", "couple", "ties", "adhesion", "passive", "levels", *["plain"] * 6])
    weight = 2.2e4 * width * height
    soil = f"friction_angle_deg = {n.uniform(20, 45)}\nunit_weight = {n.uniform(16e3, 20e3)}\nunit_weight_saturated = {n.uniform(19e3, 22e3)}\n"
    side = n.choice(["left", "right"])
    if kind == "levels":
        base = round(n.uniform(-20, 5), 2)
        level = re.compile(r"^(level|left|right|elevation) = ([0-9.]+)$", re.MULTILINE)
        in_water = text.split("[water]")[-1].split("[")[0] if "[water]" in text else ""
        leveled = level.sub(lambda found: f'{found[1]} = "{float(found[2]) + base} mCD"', in_water)
        text = text.replace(in_water, leveled) if in_water else text
        return f'datum = {{ base = {base}, name = "CD" }}\n{text}'
    if kind == "plain" or "cylinder" in text or "history" in text:
        return text
    if kind == "soil" and "[added_mass]" not in text:
        surcharge = n.choice(["", f"surcharge = {n.uniform(5e3, 3e4)}\n"])
        more = n.choice(["", f"wall_friction_deg = {n.uniform(0, 13)}\n", 'state = "rest"\n', f"cohesion = {n.uniform(0, 9e3)}\n"])
        return f'{text}[[backfill]]\nname = "sand"\nface = "{side}"\ntop = {n.uniform(0.3, 1) * height}\n{soil}{more}{surcharge}'
    if kind == "couple":
        lines = f'[[moment]]\nname = "gate"\nmoment = {n.uniform(0, 0.3) * weight * width}\ndirection = "{side}"\n'
        return text + lines + n.choice(["together = true\n", "permanent = true\n", ""])
    if kind == "adhesion" and "strength" not in text:
        on = n.choice(["", 'adhesion_on = "effective"\n'])
        return text.replace("[body]\n", f"[body]\nadhesion = {10 ** n.uniform(3, 5.3)}\n{on}", 1)
    if kind == "ties" and "[ground]" not in text:
        for i in range(n.choice([1, 1, 2])):
            place = n.choice(
                [f'direction = "{side}"\nelevation = {n.uniform(0, 1) * height}\n', f'direction = "down"\ndistance = {n.uniform(0, width)}\n']
            )
            text += f'[[resistance]]\nname = "tie {i}"\nlimit = {10 ** n.uniform(-2, 0) * weight}\nshare = {n.uniform(0.3, 1)}\n{place}'
        return text
    if kind == "passive" and "[ground]" not in text and "[added_mass]" not in text:
        toe = f'[[backfill]]\nname = "toe"\nface = "{side}"\ntop = {n.uniform(0.1, 0.3) * height}\nstate = "passive"\n'
        return f"{text}{toe}share = {n.uniform(0.2, 1)}\n{soil}"
    return text


def on_ground(text: str, width: float, height: float, n: random.Random) -> str:
    """Some cases on a base that crushes, on ground that fails, or on springs, of some loads in time."""
    kind = n.choice(["strength", "soil", "envelope", "springs", *["rigid"] * 6])
    if kind == "rigid":
        return text
    pressure = height * 2.2e4
    lines = {
        "strength": [f'strength = "{pressure * 10 ** n.uniform(-0.1, 1.5) / 1e3} kPa"'],
        "soil": [
            f"friction_angle_deg = {n.uniform(20, 50)}",
            f'unit_weight = "{n.uniform(7, 20)} kN/m3"',
            *n.sample(["surcharge = 2e4", "cohesion = 8e3", 'law = "hansen"'], n.randint(0, 3)),
        ],
        "envelope": ['law = "envelope"', f'centric_resistance = "{pressure * width * 10 ** n.uniform(-0.1, 1) / 1e3} kN/m"'],
        "springs": [],
    }[kind]
    if kind == "springs" or n.random() < 0.3:
        lines += [f'stiffness = "{10 ** n.uniform(0.5, 2.5)} MN/m3"', f'tangential_stiffness = "{10 ** n.uniform(0, 2)} MN/m3"']
        blocks = text.split("[[load]]\n")
        for i, block in enumerate(blocks[1:], 1):
            if "permanent" not in block.split("\n[")[0] and n.random() < 0.5:
                blocks[i] = f'history = {{ shape = "triangle", rise = 0.05, duration = {n.uniform(0.1, 1)} }}\n{block}'
        text = "[[load]]\n".join(blocks)
    criteria = ["effective_pressure_max = 3e5"] + (["ground_factor = 1.4"] if kind != "springs" else [])
    criteria += ["rotation_max = 2e-3"] if any("stiffness" in line for line in lines) else []
    if "[criteria]\n" in text:
        text = text.replace("[criteria]\n", "[criteria]\n" + "\n".join(n.sample(criteria, n.randint(1, len(criteria)))) + "\n")
    head, rest = text.split("\n[", 1) if "\n[" in text else (text, "")
    return f"{head}\n[ground]\n" + "\n".join(lines) + f"\n[{rest}"


def of_a_kind(text: str, width: float, height: float, n: random.Random) -> str:
    """Of some cases of a metre of a wall one of an object of a length, of a cylinder, or of parts."""
    kind = n.choice(["length", "cylinder", "parts", *["metre"] * 6])
    if kind == "parts":
        said = re.compile(r"^(width|height|density|mass|centroid_offset|centroid_height) = .*\n", re.MULTILINE)
        body, rest = text.split("[", 2)[1], text.split("[", 2)[2:]
        top = n.uniform(0.3, 1) * width
        parts = f"[[part]]\nname = \"foot\"\nleft = 3\nwidth = {width}\nbottom = 0\nheight = {0.3 * height}\ndensity = 2400\n"
        parts += f"[[part]]\nleft = 3\nwidth = {width}\nbottom = {0.3 * height}\nheight = {0.7 * height}\n"
        parts += f"top_left = {3 + n.uniform(0, 1) * (width - top)}\ntop_width = {top}\ndensity = 1900\ndensity_below_water = 2100\n"
        return "[" + said.sub("", body) + parts + "".join(f"[{more}" for more in rest)
    walls = "[wave]" in text or "sides" in text or re.search(r"\[water\]\n.*\nleft", text)
    if "[ground]" in text and kind == "cylinder":
        return text
    if kind == "metre" or (walls if kind == "cylinder" else "[wave]" in text):
        return text
    whole = f"length = {n.uniform(0.3, 9)}" if kind == "length" else 'shape = "cylinder"'
    return text.replace("[body]", f"[body]\n{whole}").replace('t/m"', 't"').replace('kN/m"', 'kN"')


def factor(number: float | str | None) -> str:
    """Four significant digits of a factor, whose last zeros are kept."""
    if not isinstance(number, float) or not 1e-4 <= number < 1e4:
        return digits(number)
    return f"{number:#.4g}".rstrip(".")


def digits(number: float | str | None, count: int = 4) -> str:
    """Four significant digits, or so many, as a text shows them, worked out in decimal arithmetic."""
    if number == "infinite":
        return "unlimited"
    if number is None:
        return "none"
    rounded = Context(prec=count, rounding=ROUND_HALF_EVEN).create_decimal_from_float(float(number)) if number else 0
    if rounded == 0:
        return "0"
    if not 1e-4 <= abs(rounded) < 1e7:
        mantissa, exponent = f"{rounded:.{count - 1}e}".split("e")
        return f"{mantissa.rstrip('0').rstrip('.')}e{int(exponent)}"
    plain = f"{rounded:f}"
    return plain.rstrip("0").rstrip(".") if "." in plain else plain


def row(text: str, begin: str) -> list[str]:
    """The columns of the line that begins with a text."""
    found = [line for line in text.splitlines() if line.startswith(f"  {begin}  ")]
    assert len(found) == 1, (begin, found)
    return re.split(r"\s{2,}", found[0].strip())[1:]


def unwrapped(text: str) -> str:
    return " ".join(text.split())


def compare_situation(said: dict[str, Any], text: str, per: str) -> None:
    """A part of the text against the JSON; forces are `per` metre, or of the whole."""
    words = unwrapped(text)
    if said["mode"] == "RE":
        # Never said to rest without the least of its factors; an object that is shaken begins to rock where others overturn.
        # On a base that gives way the share of the load is the margin, and no factor is said.
        ground = said["ground"] or {}
        gives_way = any(ground.get(key) is not None for key in ("factor", "omega"))
        all_of = {"sliding": said["SF_sliding"], "overturning": said["SF_overturning_net"]}
        all_of["overturning by gross moments"] = said["SF_overturning_gross"]
        numbers = {against: math.inf if found in ("infinite", None) else found for against, found in all_of.items()}
        against = min(numbers, key=lambda name: numbers[name])
        least = numbers[against]
        factor_words = f", with a safety factor of {factor(least)} against {against}" if least < math.inf and not gives_way else ""
        rocking = re.sub("against overturning$", "against the onset of rocking", factor_words)
        assert any(f"the body stays at rest (RE){said_so}." in words for said_so in (factor_words, rocking if said["earthquake"] else factor_words))
    else:
        assert said["mode_words"] is None or f"the body {said['mode_words']} ({said['mode']})." in words
    assert ("The answer is unique." in words) == (said["unique"] and said["mode"] not in (None, "BF"))
    for symbol in said["also"]:
        assert f"({symbol})" in words.split("is not unique: that it ", 1)[1].split("as well.")[0]
    if said["departure"] == "never":
        assert said["load_factor"] is None and ("No multiple of " in words or "no load rises" in words)
    elif said["departure"] == "at":
        into = f"({said['departure_mode']})" if said["departure_mode"] else "in no consistent mode"
        share = digits(100 * said["load_factor"])
        assert f"{into} from {share} % on." in words
    else:
        begin = {"permanent-loads": "The permanent loads alone", "any-share": "Any share of "}[said["departure_by"]]
        assert begin in words and said["load_factor"] is None
    assert row(text, "sliding")[-1] == factor(said["SF_sliding"])
    about = [said["SF_overturning_heel"], said["SF_overturning_toe"]]
    assert row(text, "overturning")[-1] == factor(about[0])
    toe = re.search(r"\(−M_p\), about the toe +(\S+)$", text, re.MULTILINE)
    assert (toe is not None) == isinstance(about[1], float)
    if toe:
        assert toe[1] == factor(about[1])
    gross = re.search(r"by gross moments, about the (?:heel|toe) +(\S+)$", text, re.MULTILINE)
    if gross:
        assert gross[1] == factor(said["SF_overturning_gross"]) != factor(said["SF_overturning_net"])
    if about[0] is not None:
        assert said["SF_overturning_net"] == min(about, key=lambda found: math.inf if found == "infinite" else found)
    if said["bearing"] == "pressed":
        for begin, edge, other in [("bearing", "heel", "toe"), ("             at the toe", "toe", "heel")]:
            pressure, opposite = said[f"{edge}_pressure"], said[f"{other}_pressure"]
            larger = ", the larger" if pressure > opposite and digits(pressure / 1e3) != digits(opposite / 1e3) else ""
            assert row(text, begin)[-1] == f"{digits(pressure / 1e3)} kPa{larger}"
    else:
        assert row(text, "bearing")[-1] == "none"
    if said["resultant_arm"] is not None:
        assert row(text, "resultant")[-1] == f"{digits(said['resultant_arm'])} m"
    assert (said["eccentricity"] is None) == (said["bearing"] != "pressed")
    if said["eccentricity"] is not None:
        assert row(text, "             eccentricity |B_c/2 − t_e|")[-1] == f"{digits(said['eccentricity'])} m"
    if said["other_earthquakes"]:
        lines = text.split("that were tried, the worst first\n", 1)[1].splitlines()[2:]
        for other, line in zip([said["earthquake"] | said, *said["other_earthquakes"]], lines):
            share = digits(100 * other["load_factor"]) + " %" if other["departure"] == "at" else other["departure"].replace("-", " ")
            gravity = 9.81
            expected = [digits(other["horizontal"] / gravity), digits(other["vertical"] / gravity), other["mode"] or "none"]
            expected += [factor(other["SF_sliding"]), factor(other["SF_overturning_net"]), share]
            assert re.split(r"\s{2,}", line.strip())[: len(expected)] == expected, line
    assert row(text, "P")[0] == f"{digits(said['P'] / 1e3)} kN{per}"
    assert row(text, "P")[1] == f"M_p = {digits(said['M_p'] / 1e3)} kN m{per} about the base"
    assert row(text, "U")[0] == f"{digits(said['U'] / 1e3)} kN{per}"
    compare_ground(said["ground"], text, words, per)
    if said["k_eff"] is not None:
        heading = "In the report's diagram" if said["report"] is not None else "\nCoordinates\n"
        diagram = text.split(heading, 1)[1]
        name = "k" if re.search(r"^  k  ", diagram.split("\nBecause")[0], re.MULTILINE) else "k_eff"
        assert row(diagram.split("\nBecause")[0], name)[-1] == digits(said["k_eff"])
    keys = ["x_ddot", "y_ddot", "theta_ddot", "f_x", "f_y", "xi", "slip", "lift_o", "lift_o_prime"]
    # Of a body at rest it would be a table of zeros.
    assert ("\nAt onset\n" in text) == (said["motion"] is not None and said["mode"] != "RE")
    if "\nAt onset\n" in text:
        lines = text.split("\nAt onset\n", 1)[1].splitlines()[: len(keys)]
        for key, line in zip(keys, lines, strict=True):
            number, unit = re.split(r"\s{2,}", line.strip())[-2:]
            value = said["motion"][key] / (1e3 if unit.startswith("kN") else 1)
            assert number == digits(value), (key, line)
    because = text.split("\nBecause\n", 1)[1].splitlines() if said["because"] else []
    for relation, line in zip(said["because"], because):
        assert relation["statement"] in line
        assert f"{digits(relation['left'])} {relation['sign']} {digits(relation['right'])}" in line or "holds by" in line
    path = text.split("the permanent ones stay\n", 1)[1].splitlines()[1:] if said["path"] else []
    for stage, line in zip(said["path"], path):
        begin, _, mode = line.split()[:3]
        assert (begin, mode) == (digits(stage["from"]), stage["mode"] or "none")


def compare_ground(ground: dict[str, Any] | None, text: str, words: str, per: str) -> None:
    """What the base bears."""
    assert (ground is not None) == ("\nGround\n" in text)
    if ground is None:
        return
    part = text.split("\nGround\n", 1)[1].split("\nVerdict\n")[0]

    def last(name: str) -> str | None:
        found = re.findall(rf"^  .*\b{re.escape(name)} {{2,}}(.+)$", part, re.MULTILINE)
        return found[0] if found else None

    pressure = ground["effective_pressure"]
    if ground["effective_width"] is None:
        assert last("B' = 2(B − |e|)") is None and "Nothing presses on the base" in words
    else:
        assert last("B' = 2(B − |e|)") == f"{digits(ground['effective_width'])} m"
        assert last("V/B'") == ("none" if pressure == "infinite" else f"{digits(pressure / 1e3)} kPa")
        # P = p B' = R/factor, in the units of each.
        if ground["factor"] and pressure != "infinite" and per:
            assert ground["resistance"] / ground["factor"] == pytest.approx(pressure * ground["effective_width"], rel=1e-12)
    assert last("R/V") == (None if ground["factor"] is None else factor(ground["factor"]))
    assert last("ω = V/(2B q_u)") == (None if ground["omega"] is None else digits(ground["omega"]))
    if ground["neutral"] is not None:
        assert ground["neutral"] == pytest.approx(2 * ground["pivot"], rel=1e-12)
        assert f"the body turns about a point {digits(ground['neutral'])} m inside it." in words
    if ground["rotation"] is not None:
        assert last("θ").startswith(f"{digits(ground['rotation'] * 1e3)} mrad")
    assert last("D_shear") == (None if ground["D_shear"] is None else digits(ground["D_shear"]))
    if ground["periods"] is not None:
        assert f"{digits(ground['periods'][0])} s and {digits(ground['periods'][1])} s" in words
    times = [event["time"] for event in ground["events"] if event["time"] is not None]
    assert ground["first_event_time"] == min(times, default=None)
    assert [event["event"] for event in ground["events"]] in ([], ["slip", "lift"], ["slip", "lift", "yield"])


def number(part: str) -> tuple[bool, int]:
    """The place of a situation's part of a text in the order of the case: couples stand behind the forces."""
    what, place = re.match(r"\s*(Load|Moment|Combination) (\d+)", part).groups()
    return what == "Moment", int(place)


def compare_criteria(document: dict[str, Any], text: str) -> None:
    """The criteria of the text against the JSON, and these against the situations."""
    assert document["met"] == (all(check["met"] for check in document["criteria"]) if document["criteria"] else None)
    lines = text.split("\nCriteria\n", 1)[1].splitlines()[1:] if document["criteria"] else []
    used = []
    for check, line in zip(document["criteria"], lines):
        columns = re.split(r"\s{2,}", line.strip())
        assert columns[0] == check["name"] and ("not met" in columns) != check["met"]
        situation = document["situations"][check["situation"]]
        if check["name"] == "modes_not":
            if check["earthquake"] == situation["earthquake"]:
                assert set(check["value"]) == ({situation["mode"], *situation["also"]} - {None, "BF"})
            assert check["met"] == (bool(check["value"]) and not set(check["value"]) & set(check["required"]))
            used.append(0 if check["met"] else math.inf)
            continue
        # Under the acceleration of the base that is worst for it, of those that were tried.
        tried = [situation] if check["earthquake"] == situation["earthquake"] else []
        tried += [other for other in situation["other_earthquakes"] if other.items() >= (check["earthquake"] or {"": 0}).items()]
        [under] = tried
        rests = {"never": "infinite", "at-once": 0, "at": under["load_factor"]}[under["departure"]]
        assert check["value"] == (rests if check["name"] == "load_factor" else under.get(check["name"], check["value"]))
        value = math.inf if check["value"] == "infinite" else check["value"]
        least = check["name"] not in ("bearing_max", "eccentricity", "effective_pressure_max", "rotation_max", "tipping")
        if value is None or (least and value <= 0):
            utilisation = math.inf
        else:
            utilisation = check["required"] / value if least else value / check["required"]
            assert check["met"] == (value >= check["required"] if least else value <= check["required"])
        assert check["utilisation"] == ("infinite" if utilisation == math.inf else pytest.approx(utilisation, rel=1e-14))
        shown = columns[3]
        if utilisation == math.inf:
            assert shown == "infinite"
        else:
            assert shown == digits(utilisation) or abs(float(shown) / utilisation - 1) < 5e-4
        scale = {"bearing_max": 1e3, "effective_pressure_max": 1e3, "rotation_max": 1e-3}
        # What is asked for is rounded to six digits, not four.
        required = digits(check["required"] / scale.get(check["name"], 1), 6)
        assert columns[1].split()[:2] == ["≥" if least else "≤", required]
        used.append(utilisation)
    assert used == sorted(used, reverse=True)


def compare_table(name: str, document: dict[str, Any]) -> None:
    """The results of a table of one row, which varies nothing, against the JSON."""
    table = standfast.assess_table(name, {"gravity": [document["gravity"]]})
    governing = document["situations"][document["governing"]]
    expected = {key: value for key, value in governing.items() if key not in ("criteria", "earthquake")}
    if ground := governing["ground"]:
        expected |= {{"factor": "ground_factor", "resistance": "ground_resistance", "margin": "ground_margin"}.get(key, key): ground[key] for key in ground}
        expected |= dict(zip(("period_1", "period_2"), ground["periods"] or (None, None)))
    if document["criteria"]:
        first = document["criteria"][0]
        expected |= {"met": document["met"], "criterion": first["name"], "utilisation": first["utilisation"]}
    expected["warnings"] = list(dict.fromkeys(warning["name"] for warning in document["warnings"])) or None
    shaken = governing["earthquake"] or {"horizontal": None, "vertical": None}
    expected |= {f"earthquake_{key}": value for key, value in shaken.items()}
    compared = 0
    for key, [value] in table.items():
        if key == "situation":
            called = governing["load"] or governing["combination"]
            assert called["name"] is None or called["name"] in value
            continue
        # What is in no situation stands among the criteria that ask for it.
        asked = {check["name"]: check["value"] for check in document["criteria"] if check["situation"] == document["governing"]}
        if key == "tipping" and key not in asked:
            continue  # Another combination asks for it.
        said = expected[key] if key in expected else asked[key]
        if isinstance(value, str):
            assert value == ("" if said is None else " ".join(said) if isinstance(said, list) else said), key
        else:
            assert math.isnan(value) if said is None else value == (math.inf if said == "infinite" else said), key
        compared += 1
    assert compared > 30


def compare(program: list[str], name: str, *figures: str) -> bool:
    """Whether the case of a file is understood, after comparing what the three say of it."""

    def answer(*options: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run([*program, "assess", name, *figures, *options], capture_output=True, encoding="utf-8")

    shown = answer()
    try:
        found = standfast.assess(name)
    except ValueError as error:
        assert shown.returncode == 1, name
        assert unwrapped(shown.stderr) == unwrapped(f"error: {error}")
        return False
    assert shown.returncode == 0, shown.stderr
    document = json.loads(answer("--format", "json").stdout)
    # Python writes no files, and the text of the program ends with those it wrote.
    assert json.loads(found.to_json()) == document | {"figures": []}
    assert re.sub(r"\n(Diagram|k–μ diagram|Load path|Moment and rotation|Section)[^\n]* written to [^\n]*", "", shown.stdout).rstrip() == str(found).rstrip()
    per = {"per-metre": "/m", "whole": ""}[document["extent"]]
    if len(document["situations"]) > 1:
        parts = str(found).split(RULE)[1 : len(document["situations"]) + 1]
        # The worst first; the situations of the document in the order of the case.
        assert number(parts[0]) == sorted(map(number, parts))[document["governing"]]
        for said, part in zip(document["situations"], sorted(parts, key=number), strict=True):
            compare_situation(said, part, per)
    else:
        compare_situation(document["situations"][0], str(found), per)
    compare_criteria(document, str(found))
    compare_table(name, document)
    assert found.met == document["met"] and len(found.criteria) == len(document["criteria"])
    for said, part in zip(document["situations"], found.situations, strict=True):
        assert part.mode == said["mode"] or part.mode.symbol == said["mode"]
        assert part.SF_sliding == (math.inf if said["SF_sliding"] == "infinite" else said["SF_sliding"])
        assert part.load_factor == said["load_factor"]
    return True


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_every_example(program: list[str], path: Path, tmp_path: Path) -> None:
    assert compare(program, str(path), "-o", str(tmp_path))


def test_random_cases(program: list[str], tmp_path: Path) -> None:
    def one(seed: int) -> bool:
        file = tmp_path / f"{seed}.toml"
        file.write_text(random_case(seed))
        return compare(program, str(file), "--no-figures")

    with ThreadPoolExecutor(2) as pool:
        understood = list(pool.map(one, range(520)))
    assert sum(understood) >= 500
