"""What all adapters share: the problems, the loads in time, and the files of answers.

An adapter has a class with the settings of the engine as keyword arguments, and four methods:

    place(gamma, mu, gravity, inertia, x, y, theta, vx, vy, omega)    # a block 2 m wide and 2γ m high, 1 kg, on the floor y = 0
    push(fx, fy, torque)                                             # for the next step, at the centre of mass
    step()
    state() -> x, y, theta, vx, vy, omega                            # y upwards, angles counter-clockwise

and a number `dt`. Run an adapter as `python ENGINE.py [onset|motions|again|tune|tune-window|tune-motions] [SETTING]`.
"""

import csv
import json
import math
import random
import sys
import tempfile
import time
from pathlib import Path

sys.dont_write_bytecode = True
HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import score  # noqa: E402

G = 9.81
#: Where files of answers are written.
RESULTS = HERE.parent / "results"


def onset_problems():
    return json.loads((HERE.parent / "onset.json").read_text(encoding="utf-8"))["problems"]


def motion_problems():
    return json.loads((HERE.parent / "motions.json").read_text(encoding="utf-8"))["motions"]


def corners(state, gamma):
    """Velocities of O and O', to the right and upwards each."""
    _, _, theta, vx, vy, omega = state
    cos, sin = math.cos(theta), math.sin(theta)
    found = []
    for side in (-1.0, 1.0):
        rx, ry = cos * side + sin * gamma, sin * side - cos * gamma
        found += [vx - omega * ry, vy + omega * rx]
    return found


def onset(engine, gamma, k_prime, k, mu, settle, start, steps):
    """Mean accelerations in g of both corners, `start` to `steps` steps after the force; it settles before."""
    engine.place(gamma, mu, G, (1 + gamma**2) / 3, 0, gamma, 0, 0, 0, 0)
    for _ in range(settle):
        engine.step()
    before = None
    for i in range(steps):
        if i == start:
            before = corners(engine.state(), gamma)
        engine.push(-k * G, 0, k * G * k_prime * gamma)
        engine.step()
    after = corners(engine.state(), gamma)
    span = (steps - start) * engine.dt
    return [(b - a) / span / G for a, b in zip(before, after)]


def value(h, t):
    """Of a history at a time."""
    t -= h["start"]
    if not 0 <= t < h["duration"]:
        return 0.0
    if h["shape"] == "half-sine":
        return h["peak"] * math.sin(math.pi * t / h["duration"])
    if h["shape"] == "sine":
        return h["peak"] * math.sin(2 * math.pi * t / h["period"])
    if h["shape"] == "rect":
        return h["peak"]
    return h["peak"] * min(t / h["rise"], (h["duration"] - t) / (h["duration"] - h["rise"]))


def motion(engine, item):
    """x, y and theta at the checkpoints, linear between steps; the base's acceleration acts as a force of inertia."""
    start, force, base = item["initial"], item["force"], item["base_acceleration"]
    engine.place(item["half_height"], item["friction"], item["gravity"], item["inertia"], *(start[n] for n in ("x", "y", "theta", "vx", "vy", "omega")))
    rows, t, old = [], 0.0, engine.state()
    wanted = [point[0] for point in item["checkpoints"]]
    steps = 0
    while wanted:
        fx = fy = torque = 0.0
        middle = t + engine.dt / 2
        if force:
            f = value(force, middle)
            (ax, ay), (ux, uy) = force["at"], force["direction"]
            cos, sin = math.cos(old[2]), math.sin(old[2])
            rx, ry = cos * ax - sin * ay, sin * ax + cos * ay
            fx, fy, torque = f * ux, f * uy, f * (rx * uy - ry * ux)
        if base:
            fx -= item["mass"] * value(base, middle)
        if force or base:
            engine.push(fx, fy, torque)
        engine.step()
        steps += 1
        now, new = steps * engine.dt, engine.state()
        while wanted and wanted[0] <= now + 1e-9:
            part = (wanted[0] - t) / (now - t)
            rows.append([wanted[0], *(a + part * (b - a) for a, b in zip(old[:3], new[:3]))])
            wanted.pop(0)
        t, old = now, new
    return rows


def write(name, rows):
    path = RESULTS / name
    with open(path, "w", newline="", encoding="utf-8") as file:
        csv.writer(file, lineterminator="\n").writerows(rows)
    return path


def digits(number):
    """Four significant digits."""
    return f"{number:.4g}" if math.isfinite(number) else "nan"


def places(number):
    """Seven decimals."""
    return f"{round(number, 7) + 0.0:.7f}".rstrip("0").rstrip(".") if math.isfinite(number) else "nan"


def answer_onset(name, make, settings, window, chosen=None):
    """Writes results/NAME-onset.csv and prints the processor's time a problem."""
    rows, times = [["id", "slip_left", "lift_left", "slip_right", "lift_right"]], []
    for p in chosen or onset_problems():
        begin = time.process_time()
        try:
            found = onset(make(**settings), p["gamma"], p["k_prime"], p["k"], p["mu"], **window)
        except RuntimeError as error:  # its solver gives up
            print(p["id"], str(error).splitlines()[0][:100], file=sys.stderr)
            found = [math.nan] * 4
        times.append(time.process_time() - begin)
        rows.append([p["id"], *map(digits, found)])
    path = write(f"{name}-onset.csv", rows)
    print(f"{path.name}: {1e3 * sorted(times)[len(times) // 2]:.3g} ms of processor a problem (median)", flush=True)


def answer_motions(name, make, settings, chosen=None):
    rows, times = [["id", "t", "x", "y", "theta"]], []
    for item in chosen or motion_problems():
        begin = time.process_time()
        try:
            found = motion(make(**settings), item)
        except RuntimeError as error:
            print(item["id"], str(error).splitlines()[0][:100], file=sys.stderr)
            found = [[point[0], math.nan, math.nan, math.nan] for point in item["checkpoints"]]
        times.append((time.process_time() - begin) / item["t_end"])
        rows += [[item["id"], repr(row[0]), *map(places, row[1:])] for row in found]
    path = write(f"{name}-motions.csv", rows)
    print(f"{path.name}: {1e3 * sorted(times)[len(times) // 2]:.3g} ms of processor for a second of motion (median)", flush=True)


def sample(number):
    """Onset problems that are like those of the benchmark but not among them: k and μ a little off, group `unique` only."""
    import contact

    generator, found = random.Random(7), []
    pool = [p for p in onset_problems() if p["group"] == "unique"]
    while len(found) < number:
        p = generator.choice(pool)
        new = dict(p, gamma=p["gamma"] * generator.uniform(0.8, 1.25), k_prime=max(-1.0, min(1.0, p["k_prime"] + generator.uniform(-0.2, 0.2))),
                   k=p["k"] * generator.uniform(0.8, 1.25), mu=p["mu"] * generator.uniform(0.8, 1.25))
        numbers = [new[n] for n in ("gamma", "k_prime", "k", "mu")]
        modes = contact.consistent(*numbers)
        if len(modes) != 1 or abs(contact.boundary(*numbers)[1] - 1) < 0.05:
            continue
        (new["mode"], a), = modes.items()
        if score.infer(a["slip_left"], a["lift_left"], a["slip_right"], a["lift_right"], 1.5 * score.THRESHOLD) == new["mode"]:
            found.append(new)
    return found


def tune_onset(make, some, seconds, number=60, seed=3, first=()):
    """A random search on other problems; prints what is better than all before. `some(pick)` gives settings and a window."""
    problems, generator = sample(number), random.Random(seed)
    best, tried, end, queue = -1, 0, time.time() + seconds, list(first)
    while time.time() < end:
        settings, window = queue.pop(0) if queue else some(generator.choice)
        right, begin = 0, time.time()
        for p in problems:
            try:
                right += score.infer(*onset(make(**settings), p["gamma"], p["k_prime"], p["k"], p["mu"], **window)) == p["mode"]
            except Exception as error:  # a setting that the engine refuses
                print("refused:", settings, error)
                break
        tried += 1
        if right > best:
            best = right
            print(f"try {tried}: {right} of {len(problems)}, {1e3 * (time.time() - begin) / number:.2g} ms each, {settings} {window}", flush=True)
    print(f"{tried} tried", flush=True)


def tune_window(make, settings, number=120):
    """When the plain engine is best looked at, on other problems: steps after the force."""
    problems, results = sample(number), []
    for start in (0, 1, 2, 3, 5, 10, 20, 40):
        for steps in sorted({start + 1, start + 2, 2 * start + 2, 3 * start + 3}):
            window = dict(settle=200, start=start, steps=steps)
            right = sum(score.infer(*onset(make(**settings), p["gamma"], p["k_prime"], p["k"], p["mu"], **window)) == p["mode"] for p in problems)
            results.append((right, start, steps))
    for right, start, steps in sorted(results, reverse=True)[:5]:
        print(f"{right} of {len(problems)} from step {start} to {steps}", flush=True)


def worst(rows, item):
    size = item["half_width"]
    error = 0.0
    for found, truth in zip(rows, item["checkpoints"]):
        parts = [abs(found[1] - truth[1]) / size, abs(found[2] - truth[2]) / size, abs(found[3] - truth[3])]
        error = max(error, *(part if math.isfinite(part) else math.inf for part in parts))
    return error


def tune_motions(make, several, number=20):
    """Tries settings on every tenth motion: how many are within each share, and the median error."""
    items = motion_problems()[4 :: 200 // number]
    for settings in several:
        begin = time.time()
        errors = sorted(worst(motion(make(**settings), item), item) for item in items)
        counts = [sum(e <= s for e in errors) for s in score.SHARES]
        print(f"{counts} of {len(errors)}, median {errors[len(errors) // 2]:.3g}, {time.time() - begin:.0f} s, {settings}", flush=True)


def again(answer):
    """Asks the engine once more, beside the files of results, and compares the counts. `answer` takes "onset" or "motions"."""
    global RESULTS
    stored = RESULTS
    with tempfile.TemporaryDirectory() as folder:
        RESULTS = Path(folder)
        answer("onset")
        answer("motions")
        same = []
        for path in sorted(RESULTS.iterdir()):
            if (stored / path.name).exists():
                same.append(score.again(path, stored / path.name))
            else:
                print(f"{path.name}: there is no stored file to compare with")
    sys.exit(not all(same))


def main(name, make, settings, motion_settings, some=None, several=None, first=()):
    what = sys.argv[1] if len(sys.argv) > 1 else "onset"
    only = sys.argv[2:]
    if what == "tune":
        tune_onset(make, some, float(only[0]) if only else 120, first=first)
    elif what == "tune-window":
        tune_window(make, settings["default"][0])
    elif what == "tune-motions":
        tune_motions(make, several)
    elif what not in ("onset", "motions", "again"):
        sys.exit(f"unknown: {what}; it is onset, motions, again, tune, tune-window or tune-motions")
    else:
        known = dict.fromkeys([*settings, *motion_settings])
        for setting in only:
            if setting not in known:
                sys.exit(f"unknown setting: {setting}; it is {', '.join(known)}")

        def answer(kind):
            for setting, values in (settings if kind == "onset" else motion_settings).items():
                if not only or setting in only:
                    if kind == "onset":
                        answer_onset(f"{name}-{setting}", make, values[0], values[1])
                    else:
                        answer_motions(f"{name}-{setting}", make, values)

        again(answer) if what == "again" else answer(what)
