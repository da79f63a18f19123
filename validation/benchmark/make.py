"""Writes the data of the benchmark, the same bytes each time: onset.csv, onset.json, motions.csv, motions.json.

    python make.py PATH/TO/standfast

Everything is checked on the way, and the first thing that is not as it should be ends it:

- the modes of each onset problem by standfast, and by all ten contact modes in exact arithmetic (contact.py);
- the motion of the mode that standfast reports, to 1e-12;
- the nearest boundary along k, where the reported mode changes there, against `standfast classify`;
- the mode of the exact accelerations by score.py's own inference;
- the motions, by the time stepping of engines/moreau.py, within 2 % at every checkpoint.
"""

import csv
import io
import json
import math
import random
import subprocess
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent / "engines"))
import common  # noqa: E402
import contact  # noqa: E402
import moreau  # noqa: E402
import score  # noqa: E402

HERE = Path(__file__).resolve().parent
SEED = 20261129
ONSET_MODES = ["RE", "SL", "RO", "SRO-", "SRO+", "SRO'-"]
NEAR = 0.05
#: Nearer to a boundary no problem is: an engine's rounding is not what is asked for.
NEAREST = 0.005
#: A motion that hangs more on its numbers is left out: an engine has errors of its own.
DIVERGENCE = 100
MOTION = ["x_ddot", "y_ddot", "theta_ddot", "slip_left", "lift_left", "slip_right", "lift_right", "N_left", "N_right", "T"]
G, HALF = 9.81, 1.0
POINTS = 20


def run(program, *arguments):
    done = subprocess.run([program, *arguments], capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"{arguments}: {done.stderr}")
    return done.stdout


def table(rows):
    """CSV with a line feed at the end of each line on every system."""
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    return text.getvalue()


def lines(head, name, items):
    """JSON with one item a line."""
    dump = lambda value: json.dumps(value, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    top = "".join(f"{dump(key)}: {dump(value)},\n" for key, value in head.items())
    return "{\n" + top + dump(name) + ": [\n" + ",\n".join(map(dump, items)) + "\n]\n}\n"


# Onset.


def batch(program, folder, points):
    source, target = Path(folder, "points.csv"), Path(folder, "answer.csv")
    source.write_text(table([["gamma", "k_prime", "k", "mu"], *points]))
    run(program, "batch", str(source), "-o", str(target))
    with open(target, newline="") as file:
        return list(csv.DictReader(file))


def draw(generator, number, largest_k, largest_mu, highest):
    points = []
    for _ in range(number):
        gamma, k_prime = 4 ** generator.uniform(-1, 1), generator.uniform(-1, highest)
        k, mu = generator.uniform(0.1, largest_k), generator.uniform(0.05, largest_mu)
        points.append([round(value, 4) for value in (gamma, k_prime, k, mu)])
    return points


def told(modes, primary):
    """Whether exact accelerations tell the mode, with a margin for the threshold of the inference."""
    a = modes[primary]
    four = [float(a[name]) for name in ("slip_left", "lift_left", "slip_right", "lift_right")]
    return all(score.infer(*four, threshold=score.THRESHOLD * f) == primary for f in (0.5, 1, 1.5))


def onset(program, folder):
    """Draws until each group has its number of each mode, in the order of the draws."""
    generator = random.Random(SEED)
    want = {("unique", mode): 100 for mode in ONSET_MODES}
    want.update({("near", mode): 33 + (mode in ("RE", "SL")) for mode in ONSET_MODES})
    want.update({("indeterminate", "SL"): 140, ("indeterminate", "SRO'-"): 60})
    found = {key: [] for key in want}
    while any(len(found[key]) < want[key] for key in want):
        points = draw(generator, 4000, 3, 1.5, 1) + draw(generator, 4000, 8, 6, 0)
        answers = batch(program, folder, points)
        for i, (point, answer) in enumerate(zip(points, answers)):
            several = answer["unique"] == "false"
            if several == (i < 4000):
                continue  # the first 4000 are for the groups with one mode, the others for the third
            groups = ["indeterminate"] if several else ["unique", "near"]
            open_groups = [g for g in groups if len(found[g, answer["mode"]]) < want[g, answer["mode"]]]
            if not open_groups:
                continue
            nearest = contact.boundary(*point)
            group = "indeterminate" if several else "unique" if abs(nearest[1] - 1) > NEAR else "near"
            if group not in open_groups or abs(nearest[1] - 1) < NEAREST:
                continue
            modes = contact.exact(*point)
            if not all(told(modes, mode) for mode in modes):
                continue
            found[group, answer["mode"]].append(problem(group, point, answer, modes, nearest))
    chosen = [item for items in found.values() for item in items]
    for group in ("unique", "near", "indeterminate"):
        for i, item in enumerate([item for item in chosen if item["group"] == group], 1):
            item["id"] = f"{group[0]}{i:03d}"
    witnessed(program, chosen)
    return chosen


def problem(group, point, answer, modes, nearest):
    names = [answer["mode"], *answer["also"].split()]
    assert set(names) == set(modes), (point, names, list(modes))
    assert (len(modes) == 1) == (group != "indeterminate"), (point, group)
    motion = modes[answer["mode"]]
    ours = [motion["x_ddot"], motion["y_ddot"], motion["theta_ddot"], motion["T"], motion["N_left"] + motion["N_right"]]
    theirs = [float(answer[name]) for name in ("x_ddot", "y_ddot", "theta_ddot", "f_x", "f_y")]
    for a, b in zip(ours, theirs):
        worst[0] = max(worst[0], abs(float(a) - b) / max(1, abs(b)))
    assert worst[0] < 1e-12, (point, ours, theirs)
    xi = (motion["N_right"] - motion["N_left"]) / (motion["N_left"] + motion["N_right"])
    assert abs(float(xi) - float(answer["xi"])) < 1e-12, (point, xi, answer["xi"])
    name, factor, beyond = nearest
    return dict(
        id="", group=group, gamma=point[0], k_prime=point[1], k=point[2], mu=point[3], mode=answer["mode"], modes=names,
        boundary=dict(by=name, at=point[2 if name == "k" else 3] * factor, percent=100 * (factor - 1), modes=beyond),
        motions={mode: {key: float(modes[mode][key]) for key in MOTION} for mode in names},
    )


worst = [0.0]


def witnessed(program, chosen):
    """The nearest boundary against `classify`, where the mode that is reported changes there."""
    compared = 0
    for item in chosen:
        if item["boundary"]["modes"] and item["mode"] not in item["boundary"]["modes"]:
            numbers = [f"--{name.replace('_', '-')}={item[name]}" for name in ("gamma", "k_prime", "k", "mu")]
            answer = json.loads(run(program, "classify", *numbers, "--format", "json"))
            by, at = item["boundary"]["by"], item["boundary"]["at"]
            places = [change["at"] for change in answer["along_" + by]]
            assert any(abs(place - at) < 1e-9 * max(1, at) for place in places), (item, places)
            compared += 1
    print(f"onset: accelerations within {worst[0]:.1e} of standfast's; {compared} nearest boundaries found by classify, too")


def rounded(value):
    return float(f"{value:.9g}")


def write_onset(items, version):
    for item in items:
        item["boundary"]["at"], item["boundary"]["percent"] = rounded(item["boundary"]["at"]), rounded(item["boundary"]["percent"])
        item["motions"] = {m: {key: rounded(v) + 0.0 for key, v in a.items()} for m, a in item["motions"].items()}
    head = dict(
        benchmark="onset", version=1, made_with=version,
        question="A uniform rigid block, 2B wide and 2γB high, stands at rest on a rigid floor. A force k m g to the left acts at once, k'γB above its centre of mass. Which mode begins?",
        units="lengths B, accelerations g, angular accelerations g/B, forces m g; x to the right, y upwards, angles counter-clockwise",
        threshold=score.THRESHOLD,
    )
    (HERE / "onset.json").write_text(lines(head, "problems", items), encoding="utf-8", newline="\n")
    rows = [["id", "group", "gamma", "k_prime", "k", "mu", "mode", "modes", "boundary_by", "boundary_at", "boundary_percent", "boundary_modes", *MOTION]]
    for item in items:
        b = item["boundary"]
        rows.append([item["id"], item["group"], item["gamma"], item["k_prime"], item["k"], item["mu"], item["mode"], " ".join(item["modes"]),
                     b["by"], b["at"], b["percent"], " ".join(b["modes"]), *(item["motions"][item["mode"]][name] for name in MOTION)])
    (HERE / "onset.csv").write_text(table(rows), encoding="utf-8", newline="\n")


# Motions.


def history(generator, peak, shape=None):
    """A history and its formula; the peak in N or m/s²."""
    shape = shape or generator.choice(["half-sine", "half-sine", "triangle", "rect"])
    start, duration = 0.1, round(generator.uniform(0.1, 1.0), 3)
    if shape == "sine":
        period, cycles = round(generator.uniform(0.3, 1.8), 3), generator.randint(1, 4)
        duration = round(period * cycles, 6)
        return dict(shape=shape, start=start, peak=peak, period=period, duration=duration)
    found = dict(shape=shape, start=start, peak=peak, duration=duration)
    if shape == "triangle":
        found["rise"] = round(duration * generator.uniform(0.2, 0.8), 4)
    return found


def formula(h):
    t = f"(t - {h['start']})"
    where = f"for {h['start']} <= t < {round(h['start'] + h['duration'], 9)}, else 0"
    if h["shape"] == "half-sine":
        return f"{h['peak']} * sin(pi * {t} / {h['duration']}) {where}"
    if h["shape"] == "sine":
        return f"{h['peak']} * sin(2 * pi * {t} / {h['period']}) {where}"
    if h["shape"] == "rect":
        return f"{h['peak']} {where}"
    return f"{h['peak']} * min({t} / {h['rise']}, ({h['duration']} - {t}) / ({h['duration']} - {h['rise']})) {where}"


def slid(g):
    gamma, mu = round(4 ** g.uniform(-1, 0.5), 3), round(g.uniform(0.1, 0.8), 3)
    return dict(gamma=gamma, mu=mu, initial=dict(vx=round(g.choice([-1, 1]) * g.uniform(0.5, 4), 3)))


def rocked(g):
    gamma = round(g.uniform(0.9, 5), 3)
    angle = round(g.choice([-1, 1]) * g.uniform(0.2, 0.85) * math.atan(1 / gamma), 4)
    return dict(gamma=gamma, mu=round(g.uniform(0.2, 1.0), 3), initial=dict(theta=angle))


def pulsed(g):
    gamma, mu = round(4 ** g.uniform(-0.6, 0.9), 3), round(g.uniform(0.15, 0.9), 3)
    height = round(g.uniform(-0.6, 1) * gamma, 3)
    return dict(gamma=gamma, mu=mu, force=dict(at=[0.0, height], direction=[-1, 0], **history(g, round(g.uniform(0.2, 1.5) * G, 3))))


def shaken(g):
    gamma, mu = round(4 ** g.uniform(-0.6, 0.9), 3), round(g.uniform(0.15, 0.9), 3)
    return dict(gamma=gamma, mu=mu, base=history(g, round(g.uniform(0.15, 1.2) * G, 3), g.choice(["half-sine", "sine", "sine"])))


def tossed(g):
    gamma, mu = round(4 ** g.uniform(-0.7, 0.6), 3), round(g.uniform(0.1, 0.9), 3)
    start = dict(gap=round(g.uniform(0.02, 0.8), 3), vx=round(g.uniform(-2, 2), 3), vy=round(g.uniform(-1, 1), 3))
    if g.random() < 0.85:
        start.update(theta=round(g.uniform(-0.5, 0.5), 4), omega=round(g.uniform(-1.5, 1.5), 3))
    return dict(gamma=gamma, mu=mu, initial=start)


#: kind: how it is drawn, and how many of each response.
KINDS = {
    "slide": (slid, {"slides": 30}),
    "rock": (rocked, {"rocks": 25, "slides and rocks": 10}),
    "pulse": (pulsed, {"slides": 15, "rocks": 15, "slides and rocks": 15}),
    "shake": (shaken, {"slides": 16, "rocks": 17, "slides and rocks": 17}),
    "toss": (tossed, {"lands": 40}),
}


def case(drawn, end):
    text = ["[block]", "b1 = 1", "b2 = 1", f"d = {drawn['gamma']}", f"mu_s = {drawn['mu']}", f"gravity = {G}"]
    toml = lambda h: "\n".join(f"{key} = {json.dumps(value)}" for key, value in h.items())
    if "force" in drawn:
        place = {key: drawn["force"][key] for key in ("at", "direction")}
        text += ["[[block.load]]", toml(place), "[block.load.history]", toml({k: v for k, v in drawn["force"].items() if k not in place})]
    text += ["[motion]", f"t_max = {end}", "[motion.impact]", 'law = "inelastic"']
    if "initial" in drawn:
        text += ["[motion.initial]", toml(drawn["initial"])]
    if "base" in drawn:
        text += ["[motion.base.horizontal]", toml(drawn["base"])]
    return "\n".join(text) + "\n"


def simulate(program, folder, drawn, end):
    path = Path(folder, "case.toml")
    path.write_text(case(drawn, end))
    return json.loads(run(program, "simulate", str(path), "--format", "json", "--no-figures", "--no-strength", "--all"))


def response(kind, answer):
    if kind == "toss":
        return "lands"
    states = {event["state"].rstrip("'+-").replace("'", "") for event in answer["events"]}
    rocks, slides = bool(states & {"RO", "SRO", "FL"}), bool(states & {"SL", "SRO"})
    small = answer["max_theta"] < 0.01 and answer["max_slide"] < 0.01
    return None if small else {(0, 1): "slides", (1, 0): "rocks", (1, 1): "slides and rocks"}.get((rocks, slides))


def series(program, folder, *more):
    out = Path(folder, "series.csv")
    run(program, "simulate", str(Path(folder, "case.toml")), "--series", str(out), "--no-figures", "--no-strength", *more)
    with open(out, newline="") as file:
        return list(csv.DictReader(file))


STATE = ["x", "y", "theta", "vx", "vy", "omega"]


def number(text, digits=8):
    return round(float(text), digits) + 0.0


def motions(program, folder):
    chosen, seen = [], {}
    for kind, (how, quotas) in KINDS.items():
        generator = random.Random(f"{SEED} {kind}")
        left = dict(quotas)
        while any(left.values()):
            drawn = how(generator)
            first = simulate(program, folder, drawn, 30.0)
            seen[kind] = seen.get(kind, 0) + 1
            what = response(kind, first)
            if first["overturned"] or not left.get(what):
                continue
            loads = [drawn[key] for key in ("force", "base") if key in drawn]
            last = first["t_rest"] if first["t_rest"] is not None else 30.0
            end = round(min(8.0, max([1.1 * last + 0.05, *(h["start"] + h["duration"] + 0.3 for h in loads)])), 2)
            answer = simulate(program, folder, drawn, end)
            if not answer["unique"] or answer["divergence"]["value"] >= DIVERGENCE or answer["overturned"]:
                continue
            if answer["end"] not in ("rest", "t_max", "time") or any(event["also"] for event in answer["events"]):
                continue
            item = dict(id="", kind=kind, response=what, **setup(drawn), t_end=end, **truth(program, folder, answer, end))
            left[what] -= 1
            chosen.append(item)
    for i, item in enumerate(chosen, 1):
        item["id"] = f"m{i:03d}"
    print("motions: drawn", seen, "kept", len(chosen), "divergence largest", max(item["divergence"] for item in chosen))
    for step in (1e-3, 2e-4):
        errors = sorted((common.worst(common.motion(moreau.Moreau(step), item), item), item["id"]) for item in chosen)
        print(f"motions: by time stepping with {step:g} s within {errors[100][0]:.2g} in the median, {errors[189][0]:.2g} in 95 %, {errors[-1][0]:.2g} of B or rad at most, in {errors[-1][1]}")
    assert errors[-1][0] < 0.02
    return chosen


def setup(drawn):
    """All that the problem is, in m, kg, s and N."""
    gamma, start = drawn["gamma"], drawn.get("initial", {})
    theta, omega = start.get("theta", 0.0), start.get("omega", 0.0)
    low = -1 if theta > 0 or (theta == 0 and omega > 0) else 1
    c, h = low * math.cos(theta) + gamma * math.sin(theta), gamma * math.cos(theta) - low * math.sin(theta)
    y = h + start.get("gap", 0.0)
    answer = dict(
        half_width=HALF, half_height=gamma, mass=1.0, inertia=(1 + gamma**2) / 3, friction=drawn["mu"], gravity=G,
        initial=dict(x=0.0, y=y, theta=theta, vx=start.get("vx", -h * omega) + 0.0, vy=start.get("vy", -c * omega) + 0.0, omega=omega),
        force=None, base_acceleration=None,
    )
    if "force" in drawn:
        answer["force"] = {**drawn["force"], "formula": formula(drawn["force"])}
    if "base" in drawn:
        answer["base_acceleration"] = {**drawn["base"], "formula": formula(drawn["base"])}
    return answer


def truth(program, folder, answer, end):
    rows = series(program, folder, "--dt", repr(end / POINTS))
    both = series(program, folder, "--dt", repr(end), "--events")
    last = both[-1]  # the series by steps ends before the rest
    points = []
    for i in range(1, POINTS + 1):
        t = i * end / POINTS
        row = min(rows, key=lambda r: abs(float(r["t"]) - t))
        if abs(float(row["t"]) - t) > 1e-9:  # it rests before
            assert answer["at_rest"] and t > answer["t_final"], (t, row["t"])
            row = last
        points.append([number(t), *(number(row[name]) for name in ("x", "y", "theta"))])
    if answer["at_rest"]:
        assert last["state"] == "RE" and float(last["t"]) <= answer["t_final"] + 1e-9, (last, answer["t_final"])
    events = []
    for event in answer["events"]:
        after = [row for row in both if float(row["t"]) == event["t"] and row["side"] != "-1"]
        # Of several rows at one time the last one is just after.
        row = after[-1] if after else min(both, key=lambda r: abs(float(r["t"]) - event["t"]))
        events.append(dict(t=number(event["t"]), why=event["why"], state=event["state"], **{name: number(row[name]) for name in STATE}))
    return dict(
        at_rest=answer["at_rest"], t_rest=None if answer["t_rest"] is None else number(answer["t_rest"]), final_slide=number(answer["slide"]),
        max_theta=number(answer["max_theta"]), impacts=answer["impacts"], divergence=float(f"{answer['divergence']['value']:.3g}"),
        events=events if len(events) <= 20 else [*events[:19], events[-1]], events_in_all=len(events), checkpoints=points,
    )


def write_motions(items, version):
    head = dict(
        benchmark="motions", version=1, made_with=version,
        question="How does the block go on? Where is it at the checkpoints?",
        units="m, kg, s, N, rad; x to the right, y upwards, angles counter-clockwise; x and y of the centre of mass, relative to a base that moves",
        block="uniform rigid rectangle, half_width and half_height; inertia about the centre of mass; the floor is y = 0",
        friction="Coulomb, one coefficient to stick and to slip, and in impacts",
        force="acts at `at` from the centre of mass, fixed in the body, in `direction`, fixed in space, with the value of `formula`",
        base_acceleration="of the floor to the right, with the value of `formula`; in coordinates that move with it a force -m a acts at the centre of mass",
        impact="no rebound: at each corner that touches, the normal impulse is not below zero, nor is the normal velocity after it, and one of them is zero; the impulse along the floor is within friction times the normal one, and equal to it against a slip that goes on after",
        checkpoints="t, x, y, theta", events="the state just after each event; at most 20, the last one among them",
    )
    (HERE / "motions.json").write_text(lines(head, "motions", items), encoding="utf-8", newline="\n")
    rows = [["id", "t", "x", "y", "theta"]]
    rows += [[item["id"], *point] for item in items for point in item["checkpoints"]]
    (HERE / "motions.csv").write_text(table(rows), encoding="utf-8", newline="\n")


def main():
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    program = sys.argv[1]
    try:
        version = run(program, "--version").split("(")[0].strip()
    except OSError as error:
        raise SystemExit(f"{program} cannot be run: {error.strerror}") from None
    if not version.startswith("standfast "):
        raise SystemExit(f"{program} is not standfast: it says {version!r} of itself")
    with tempfile.TemporaryDirectory() as folder:
        write_onset(onset(program, folder), version)
        write_motions(motions(program, folder), version)


if __name__ == "__main__":
    main()
