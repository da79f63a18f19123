"""A second program for the motion in time, apart from the crate (event_machine.py), compares with `standfast simulate`:

    pip install numpy scipy
    python motion_events.py PROGRAM 0 200         # 200 random blocks under loads and base motions
    python motion_events.py PROGRAM 0 40 --noise  # blocks on a base that shakes like an earthquake
    python motion_events.py PROGRAM 0 300 --rebound              # blocks that fall, are thrown or shaken, and bounce
    python motion_events.py PROGRAM 0 300 --rebound --off 0.001  # the same with e more by this here: it has to be noticed
"""

from __future__ import annotations

import json
import math
import random
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path
from typing import Any, Iterable

from event_machine import MOST, REST, Motion

# Random cases.


def history(n: random.Random, peak: float, unit: float) -> dict[str, Any]:
    shape = n.choice(["triangle", "triangle", "half-sine", "rect", "decay", "sine", "points", "church-roof"])
    duration = unit * 10 ** n.uniform(-0.5, 1.2)
    h: dict[str, Any] = {"shape": shape, "peak": peak, "start": n.choice([0.0, 0.0, n.uniform(0, 2) * unit])}
    if shape == "points":
        times, values = [0.0], [n.choice([0.0, 0.0, n.uniform(-0.5, 0.5)])]
        for _ in range(n.randint(2, 12)):
            times.append(times[-1] + duration * n.uniform(0.05, 0.5))
            values.append(n.uniform(-1, 1))
        return h | {"times": times, "values": values}
    h["duration"] = duration
    if shape == "triangle":
        h["rise"] = duration * n.uniform(0.05, 0.9)
    if shape == "sine":
        h |= {"period": duration, "phase": n.choice([0.0, n.uniform(0, 6)]), "duration": duration * n.choice([0.5, 1, 1.5, 2.3])}
    if shape == "church-roof":
        h |= {"peak": abs(peak), "rise": 0.1 * duration, "impact_duration": 0.3 * duration, "tail": abs(peak) * n.uniform(0.1, 0.6)}
    return h


def random_case(seed: int) -> dict[str, Any]:
    n = random.Random(seed)
    g, d = n.choice([1.0, 9.81]), 10 ** n.uniform(-0.4, 0.7)
    unit = g**-0.5
    mu = n.choice([n.uniform(0.05, 0.9 / max(d, 1)), n.uniform(1, 2) / d + 0.3, n.uniform(0.1, 1.5), n.uniform(0.1, 1.5)])
    case: dict[str, Any] = {"b1": 1.0, "b2": 1.0, "d": d, "rho2": (1 + d * d) / 3, "gravity": g, "mu_s": mu}
    if n.random() < 0.35:
        case["mu_k"] = mu * n.uniform(0.5, 1)
    if n.random() < 0.15:
        case["mu_impact"] = mu * n.uniform(0.5, 1)
    if n.random() < 0.3:
        case |= {"b1": n.uniform(0.6, 1), "b2": n.uniform(0.6, 1.3), "rho2": n.uniform(0.5, 1.3) * (1 + d * d) / 3}
    if n.random() < 0.3:
        case |= {"m_x": n.uniform(1, 1.6), "m_y": n.choice([1.0, n.uniform(1, 1.2)])}
    case["law"] = n.choice(["inelastic", "inelastic", "housner", "ratio"])
    if case["law"] == "ratio":
        about = [case["rho2"] + case.get("m_y", 1) * case[b] ** 2 + case.get("m_x", 1) * d * d for b in ("b1", "b2")]
        case["ratio"] = n.uniform(0.3, 0.95) * math.sqrt(min(about) / max(about))
    case["loads"] = []
    for _ in range(n.choice([0, 1, 1, 2])):
        direction = n.choice([[-1.0, 0.0], [-1.0, 0.0], [n.choice([-1, 1]) * 0.9, n.uniform(-0.4, 0.3)]])
        load = {"at": [n.choice([0.0, case["b2"]]), n.uniform(-1, 1) * d], "direction": direction, "follows": n.random() < 0.2}
        case["loads"].append(load | {"history": history(n, n.uniform(0.5, 2.5) * min(mu, 1.2 / d) * g, unit)})
    if not case["loads"] or n.random() < 0.35:
        case["base_h"] = history(n, n.choice([-1, 1]) * n.uniform(0.5, 2.5) * min(mu, 1 / d) * g, unit)
        if n.random() < 0.3:
            case["base_v"] = history(n, n.uniform(-0.4, 0.4) * g, unit)
    first = n.random()
    if first < 0.12:
        case["initial"] = {"theta": n.choice([-1, 1]) * n.uniform(0.01, 0.5) / d, "omega": n.choice([0.0, n.uniform(-0.2, 0.2) / unit])}
    elif first < 0.18:
        case["initial"] = {"vx": n.uniform(-0.5, 0.5) / unit}
    elif first < 0.23:
        case["initial"] = {"gap": n.uniform(0.01, 0.2), "vx": n.uniform(-0.2, 0.2) / unit}
    return case | {"t_max": 60 * unit}


def shaken_case(seed: int) -> dict[str, Any]:
    """A block on a base that shakes like an earthquake, 5 s in steps of 0.02 s."""
    n, count, dt, g = random.Random(seed), 250, 0.02, 9.81
    slender, b = n.uniform(1.5, 6), 0.3
    mu = n.choice([n.uniform(0.1, 0.3), n.uniform(0.3, 1.2)])
    strength = lambda i: min(1, i / 40) * math.exp(-max(0, i - 120) / 50)
    values, memory = [0.0], 0.0
    for i in range(1, count):
        memory = 0.75 * memory + n.gauss(0, 1)
        values.append(memory * strength(i))
    largest, times = max(map(abs, values)), [i * dt for i in range(count)]
    case: dict[str, Any] = {"b1": b, "b2": b, "d": slender * b, "rho2": b * b * (1 + slender**2) / 3, "gravity": g, "mu_s": mu}
    case |= {"law": n.choice(["inelastic", "housner", "ratio"]), "ratio": n.uniform(0.5, 0.95), "loads": [], "t_max": 20.0}
    peak = g * n.uniform(0.8, 2.5) * min(1 / slender, mu)
    case["base_h"] = {"shape": "points", "peak": peak, "times": times, "values": [v / largest for v in values[:-1]] + [0.0]}
    if n.random() < 0.5:
        noise = [0.0] + [n.gauss(0, 0.5) * strength(i) for i in range(1, count - 1)] + [0.0]
        case["base_v"] = {"shape": "points", "peak": g * n.uniform(0.05, 0.3), "times": times, "values": noise}
    return case


def rebound_case(seed: int) -> dict[str, Any]:
    """A block that bounces: it falls flat or tilted, is thrown, or is moved by loads and the base."""
    n = random.Random(f"rebound {seed}")
    case = random_case(n.randrange(10**9))
    case |= {"law": n.choice(["poisson", "poisson", "poisson", "energetic", "energetic", "housner", "ratio"]), "e": n.uniform(0.05, 0.8)}
    if case["law"] == "ratio" and "ratio" not in case:
        case |= {"ratio": n.uniform(0.3, 0.8), "b1": 1.0, "b2": 1.0}
    if n.random() < 0.2:
        case["mu_impact"] = case["mu_s"] * n.uniform(0.3, 1)
    case.pop("initial", None)
    sign, speed, d = lambda: n.choice([-1, 1]), math.sqrt(case["gravity"]), case["d"]
    begins = n.choice(["flat", "tilted", "thrown", "thrown", "loads"])
    if begins == "flat":
        case["initial"] = {"gap": n.uniform(0.01, 0.3), "vx": n.choice([0.0, n.uniform(-0.4, 0.4) * speed])}
    elif begins == "tilted":
        first = {"gap": n.choice([0.0, n.uniform(0.01, 0.3)]), "theta": sign() * n.uniform(0.01, 0.6) / d}
        case["initial"] = first | ({"vx": 0.0, "vy": 0.0, "omega": n.uniform(-0.3, 0.3) * speed} if first["gap"] else {})
    elif begins == "thrown":
        rates = {"vx": n.uniform(-0.5, 0.5) * speed, "vy": n.uniform(-0.3, 0.3) * speed, "omega": n.uniform(-0.3, 0.3) * speed}
        case["initial"] = {"gap": n.uniform(0.01, 0.3), "theta": sign() * n.uniform(0.01, 0.3) / d} | rates
    if begins != "loads" and n.random() < 0.6:
        case["loads"] = []
        case.pop("base_h", None)
        case.pop("base_v", None)
    return case


# Comparison.


def toml(value: Any) -> str:
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {toml(of)}" for key, of in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml, value)) + "]"
    return json.dumps(value) if isinstance(value, (str, bool)) else repr(float(value))


def case_file(case: dict[str, Any]) -> str:
    table = lambda entries: [f"{key} = {toml(value)}" for key, value in entries.items()]
    numbers = ("b1", "b2", "d", "rho2", "m_x", "m_y", "mu_s", "mu_k", "mu_impact", "gravity")
    lines = ["[block]", *table({key: case[key] for key in numbers if key in case})]
    for load in case["loads"]:
        lines += ["[[block.load]]", *table(load)]
    impact = {"law": case["law"]} | ({"ratio": case["ratio"]} if case["law"] == "ratio" else {}) | ({"e": case["e"]} if "e" in case else {})
    lines += ["[motion]", *table({"impact": impact, "t_max": case["t_max"]})]
    if "initial" in case:
        lines += ["[motion.initial]", *table(case["initial"])]
    base = {name: case[key] for name, key in (("horizontal", "base_h"), ("vertical", "base_v")) if key in case}
    return "\n".join([*lines, *(["[motion.base]", *table(base)] if base else [])]) + "\n"


Event = tuple[float, str, str]


def asked(program: str, case: dict[str, Any]) -> tuple[dict[str, Any], list[Event]]:
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "case.toml"
        file.write_text(case_file(case), encoding="utf-8")
        command = [program, "simulate", str(file), "--no-figures", "--no-strength", "--format", "json"]
        ran = subprocess.run(command, capture_output=True, encoding="utf-8", check=True)
    theirs = json.loads(ran.stdout)
    return theirs, moving((event["t"], event["why"], event["state"]) for event in theirs["events"])


def moving(events: Iterable[Event]) -> list[Event]:
    """When it is over is no event of the motion."""
    return [event for event in events if event[1] not in ("rest", "end")]


def compared(program: str, case: dict[str, Any]) -> str:
    theirs, events = asked(program, case)
    motion = Motion(case)
    motion.run()
    ours = moving(motion.events)
    late = 1e-5 * motion.unit
    same = lambda a, b: a[1:] == b[1:] and abs(a[0] - b[0]) <= 1e-7 * (1 + a[0])
    alike = lambda a, b: same(a, b) or ("tail" in (a[1], b[1]) and a[2] == b[2] and abs(a[0] - b[0]) <= late)
    how, a, b = "the same", ours, events
    if not (len(a) == len(b) and all(map(same, a, b))):
        how, a, b = "the same but for tails", gathered(ours, late), gathered(events, late)
    i = next((i for i, pair in enumerate(zip(a, b)) if not alike(*pair)), min(len(a), len(b)))
    if not i == len(a) == len(b):
        return f"differs at event {i}: {a[i : i + 1]} here, {b[i : i + 1]} there, of {len(a)} and {len(b)}"
    errors = abs(motion.slide() - theirs["slide"]), abs(motion.max_theta - theirs["max_theta"])
    return f"{how}, {len(ours)} events, slide {errors[0]:.1e}, max_theta {errors[1]:.1e}" + (" LARGE" if max(errors) > 1e-8 else "")


Result = dict[str, Any]
#: How a motion compares. Set aside: rounding decides, several outcomes are consistent, the program stopped, which corner touches last.
KINDS = ("same", "tails", "chatter", "open", "stopped", "corner", "DIFFERS")


def rebounds(program: str, case: dict[str, Any], off: float) -> Result:
    """Compares a motion with rebound."""
    theirs, events = asked(program, case)
    mine = case | {"e": case["e"] + off}
    motion = Motion(mine)
    motion.run()
    ours = moving(motion.events)
    if len(ours) >= MOST:
        raise TimeoutError(f"more than {MOST} events")
    if ours[-1][1] == "no-continuation" and theirs["end"] != "no-continuation":
        raise RuntimeError(f"no state is found here at {ours[-1][0]}")
    divergence = theirs["divergence"]["value"] if theirs["divergence"] else 0.0
    errors = {
        "slide": abs(motion.slide() - theirs["slide"]) / motion.size,
        "max_slide": abs(motion.max_slide - theirs["max_slide"]) / motion.size,
        "max_theta": abs(motion.max_theta - theirs["max_theta"]),
    }
    allowed = max(1e-8, 1e-12 * divergence)
    rest = abs(ours[-1][0] - theirs["t_rest"]) / motion.unit if theirs["at_rest"] and motion.state == REST else 0.0
    late = 1e-3 if theirs["t_rest_is_bound"] else 1e-4
    times = max(1e-7, 1e-11 * divergence) * motion.unit
    same = lambda a, b: a[1:] == b[1:] and abs(a[0] - b[0]) <= times * (1 + a[0] / motion.unit)
    alike = lambda a, b: a[2] == b[2] and abs(a[0] - b[0]) <= late * motion.unit if "tail" in (a[1], b[1]) else same(a, b)
    ends = theirs["at_rest"] == (motion.state == REST) and theirs["overturned"] == motion.overturned and rest <= late
    how, where, first = "same" if len(ours) == len(events) and all(map(same, ours, events)) else "tails", "", math.inf
    if how == "tails":
        tries = [[gathered(of, width * motion.unit) for of in (ours, events)] for width in (1e-5, 2e-5, 5e-6, 5e-5)]
        if not any(len(a) == len(b) and all(map(alike, a, b)) for a, b in tries):
            a, b = tries[0]
            first = next((i for i, pair in enumerate(zip(a, b)) if not alike(*pair)), min(len(a), len(b)))
            where = f"at event {first} of {len(a)} and {len(b)}: {a[first : first + 2]} here, {b[first : first + 2]} there"
    if max(errors.values()) > allowed or where or not ends:
        how = "DIFFERS"
        # Whether O' counts that touches for a moment is a matter of rounding; it may have come down elsewhere.
        beside = min(abs(max(slides) - theirs["max_slide"]) for slides in (motion.slides, [motion.max_slide], motion.slides[:1])) / motion.size
        if theirs["end"] in ("no-continuation", "too-many-events"):
            how = "stopped"
        elif not theirs["unique"]:
            how = "open"
        elif not where and ends and max(errors["slide"], errors["max_theta"], beside) <= allowed:
            how = "corner"
        elif off == 0 and rounded(motion, mine, errors, allowed, first, times):
            how = "chatter"
    counts = {"events": len(ours), "bounces": motion.bounces, "more": motion.bounces - theirs["bounces"], "doubts": motion.doubts}
    return {"how": how, "law": case["law"], "e": case["e"], **counts, **errors, "rest": rest, "S": divergence, "end": theirs["end"], "where": where}


def rounded(motion: Motion, case: dict[str, Any], errors: dict[str, float], allowed: float, first: float, times: float) -> bool:
    """Whether rounding alone makes as much of a difference: the script beside itself, of a body higher by 1e-15 or 1e-14."""
    own, apart, events = dict.fromkeys(errors, 0.0), math.inf, gathered(moving(motion.events), 1e-5 * motion.unit)
    for by in (1e-15, -1e-15, 1e-14, -1e-14):
        twin = Motion(case | {"d": case["d"] * (1 + by)})
        twin.run()
        pairs = {"slide": twin.slide() - motion.slide(), "max_slide": twin.max_slide - motion.max_slide}
        for name, by in (pairs | {"max_theta": twin.max_theta - motion.max_theta}).items():
            own[name] = max(own[name], abs(by))
        pairs = enumerate(zip(events, gathered(moving(twin.events), 1e-5 * motion.unit)))
        apart = min(apart, next((i for i, (a, b) in pairs if a[2] != b[2] or abs(a[0] - b[0]) > 0.01 * times), math.inf))
    return apart <= first and all(error <= max(allowed, 10 * own[name]) for name, error in errors.items())


def gathered(events: list[Event], width: float) -> list[Event]:
    """Events that follow each other within a time as one, `tail`, with the state after the last."""
    found: list[Event] = []
    for event in events:
        if found and found[-1][1] != "start" and event[0] - found[-1][0] < width:
            found[-1] = (event[0], "tail", event[2])
        else:
            found.append(event)
    return found


def told(result: Result) -> str:
    numbers = ", ".join(f"{name} {result[name]:.1e}" for name in ("slide", "max_slide", "max_theta", "rest", "S"))
    counts = f"{result['events']} events, {result['bounces']} bounces ({result['more']:+d} than there)"
    return f"{result['how']}, {result['law']}, e {result['e']:.2f}, {counts}, {numbers}, {result['end']} {result['where']}".rstrip()


def summed(results: list[Result]) -> str:
    bouncing = [one for one in results if one["bounces"]]
    compared = [one for one in bouncing if one["how"] in ("same", "tails")]
    count = lambda of, key, value: f"{value} {sum(one[key] == value for one in of)}"
    lines = [f"{len(results)} motions, {len(bouncing)} with bounces: " + ", ".join(count(bouncing, "how", how) for how in KINDS)]
    for key in ("law", "end"):
        lines.append("compared: " + ", ".join(count(compared, key, value) for value in sorted({one[key] for one in compared})))
    for name in ("slide", "max_slide", "max_theta", "rest"):
        values = sorted(one[name] for one in compared) or [math.nan]
        share = lambda q: values[min(int(q * len(values)), len(values) - 1)]
        lines.append(f"{name}: median {share(0.5):.1e}, 95 % {share(0.95):.1e}, largest {values[-1]:.1e}")
    equal = sum(one["more"] == 0 for one in compared)
    lines.append(f"{sum(one['bounces'] for one in compared)} bounces, in {equal} motions as many; S above 10,000 in {sum(one['S'] > 1e4 for one in compared)}")
    lines.append(f"energetic where compression presses both corners: in {sum(one['doubts'] > 0 for one in compared)}")
    return "\n".join(lines)


def main() -> None:
    program, begin, end, *options = sys.argv[1:]
    make = shaken_case if "--noise" in options else rebound_case if "--rebound" in options else random_case
    off = float(options[options.index("--off") + 1]) if "--off" in options else 0.0

    def too_long(*_: Any) -> None:
        raise TimeoutError("it takes too long here")

    signal.signal(signal.SIGALRM, too_long)
    results: list[Result] = []
    heads: Counter[str] = Counter()
    for seed in range(int(begin), int(end)):
        began = time.time()
        signal.alarm(300)
        try:
            if "--rebound" in options:
                results.append(rebounds(program, make(seed), off))
                said = told(results[-1])
            else:
                said = compared(program, make(seed))
        except (TimeoutError, RuntimeError) as error:
            said = f"not compared: {error}"
        signal.alarm(0)
        heads[said.split(",")[0].split(" at ")[0].split(":")[0]] += 1
        print(f"{seed}: {said} ({time.time() - began:.1f} s)", flush=True)
    print(summed(results) if results else "; ".join(f"{head}: {count}" for head, count in heads.items()))


if __name__ == "__main__":
    main()
