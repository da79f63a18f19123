"""Which cases of the benchmark does a contact engine get right, and which does it fail, and why?

    python score.py answers.csv [more.csv ...]     # of onset problems or of motions; each file tells which by its columns
    python score.py answers.csv --failed           # with a list of what failed
    python score.py answers.csv --json             # for programs
    python score.py results/*.csv --brief          # one line a file

Answers to onset problems have the columns `id` and `mode`, or `id`, `slip_left`, `lift_left`, `slip_right` and `lift_right`:
accelerations in g of the bottom corners soon after the force, along the floor to the right and upwards. Answers to motions have
`id`, `t`, `x`, `y` and `theta`. Python 3.9 and its standard library do.
"""

import argparse
import contextlib
import csv
import io
import json
import math
from collections import Counter
from pathlib import Path

HERE = Path(__file__).resolve().parent
#: In g: less than this is taken for none.
THRESHOLD = 0.01
MODES = ["RE", "SL", "RO", "SRO-", "SRO+", "SRO'-"]
SHARES = [0.01, 0.05, 0.2]
WORDS = {
    "RE": "rests", "SL": "slides to the left", "SL+": "slides to the right", "RO": "rocks about the left corner",
    "RO'": "rocks about the right corner", "SRO-": "slides to the left and rocks about the left corner",
    "SRO+": "slides to the right and rocks about the left corner", "SRO'-": "slides to the left and rocks about the right corner",
    "SRO'+": "slides to the right and rocks about the right corner", "FL": "leaves the floor", "?": "no number",
}


def infer(slip_left, lift_left, slip_right, lift_right, threshold=THRESHOLD):
    """The mode from accelerations in g of the left corner O and the right one O', to the right and upwards."""
    if not all(map(math.isfinite, (slip_left, lift_left, slip_right, lift_right))):
        return "?"
    left, right = lift_left > threshold, lift_right > threshold
    if left and right:
        return "FL"
    slip = slip_right if left else slip_left
    slides = "-" if slip < -threshold else "+" if slip > threshold else ""
    if left or right:
        corner = "O'" if left else "O"
        return f"SR{corner}{slides}" if slides else f"R{corner}"
    return {"": "RE", "-": "SL", "+": "SL+"}[slides]


def number(text):
    try:
        return float(text)
    except (TypeError, ValueError):
        return math.nan


def percent(part, whole):
    return f"{100 * part / whole:.1f} %" if whole else "-"


def table(rows):
    widths = [max(len(str(row[i])) for row in rows) for i in range(len(rows[0]))]
    for j, row in enumerate(rows):
        print("| " + " | ".join(str(cell).ljust(width) for cell, width in zip(row, widths)) + " |")
        if j == 0:
            print("|" + "|".join("-" * (width + 2) for width in widths) + "|")


def change(problem):
    """What would change the mode: the nearest boundary in words."""
    b = problem["boundary"]
    name = {"k": "k", "mu": "μ"}[b["by"]]
    return f"{b['percent']:+.2f} % of {name}, to {b['at']:.6g}, gives {' or '.join(b['modes'])}"


def onset(rows, threshold, failed):
    problems = json.loads((HERE / "onset.json").read_text(encoding="utf-8"))["problems"]
    known = {problem["id"] for problem in problems}
    answers = {}
    for row in rows:
        mode = (row.get("mode") or "").strip().replace("₋", "-").replace("₊", "+").replace("−", "-").replace("’", "'")
        if not mode:
            mode = infer(*(number(row.get(name)) for name in ("slip_left", "lift_left", "slip_right", "lift_right")), threshold)
        answers[row["id"].strip()] = mode
    answered = [problem for problem in problems if problem["id"] in answers]
    result = dict(answered=len(answered), missing=len(problems) - len(answered), unknown=len(set(answers) - known), groups={})
    lines = [["group", "mode", "answered", "right", "share", "taken for instead"]]
    for group in ("unique", "near"):
        for mode in ["all", *MODES]:
            picked = [p for p in answered if p["group"] == group and mode in ("all", p["mode"])]
            wrong = Counter(answers[p["id"]] for p in picked if answers[p["id"]] != p["mode"])
            right = len(picked) - sum(wrong.values())
            result["groups"][f"{group} {mode}"] = dict(answered=len(picked), right=right)
            lines.append([group, mode, len(picked), right, percent(right, len(picked)), ", ".join(f"{m} {n}" for m, n in sorted(wrong.items(), key=lambda i: (-i[1], i[0])))])
    picked = [p for p in answered if p["group"] == "indeterminate"]
    good = Counter(answers[p["id"]] for p in picked if answers[p["id"]] in p["modes"])
    bad = Counter(answers[p["id"]] for p in picked if answers[p["id"]] not in p["modes"])
    first = sum(answers[p["id"]] == p["mode"] for p in picked)
    result["groups"]["indeterminate"] = dict(answered=len(picked), consistent=sum(good.values()), reported_by_standfast=first, chosen=dict(sorted(good.items())))
    lines.append(["indeterminate", "any of them", len(picked), sum(good.values()), percent(sum(good.values()), len(picked)),
                  ", ".join(f"{m} {n}" for m, n in sorted(bad.items(), key=lambda i: (-i[1], i[0])))])
    print(f"Onset: {len(answered)} of {len(problems)} problems answered, {len(problems) - len(answered)} missing" + (f"; {result['unknown']} ids are unknown" if result["unknown"] else ""))
    print()
    table(lines)
    if picked:
        print("\nOf the consistent modes of indeterminate problems it chose " + (", ".join(f"{m} {n}" for m, n in sorted(good.items(), key=lambda i: (-i[1], i[0]))) or "none")
              + f"; {first} times the one that standfast reports.")
    if failed:
        wrong = [p for p in answered if answers[p["id"]] not in p["modes"]]
        beyond = sum(answers[p["id"]] in p["boundary"]["modes"] for p in wrong)
        print(f"\nFailed: {len(wrong)}, of which {beyond} have the mode beyond the nearest boundary. γ, k', k, μ; expected; found; the nearest boundary:")
        for p in answered:
            mode = answers[p["id"]]
            if mode not in p["modes"]:
                print(f"{p['id']} ({p['gamma']}, {p['k_prime']}, {p['k']}, {p['mu']}): expected {' or '.join(p['modes'])}, found {mode} ({WORDS.get(mode, 'not a mode')}); {change(p)}{why(p, mode)}")
    return result


def why(problem, mode):
    """What of the motion tells the expected mode from the one found."""
    if mode in problem["boundary"]["modes"]:
        return "; it is the mode beyond that boundary"
    a = problem["motions"][problem["mode"]]
    small = [f"{name} {a[name]:+.3f} g" for name in ("slip_left", "lift_left", "slip_right", "lift_right") if 0 < abs(a[name]) < 0.1]
    return "; slow: " + ", ".join(small) if small else ""


def motions(rows, failed):
    items = json.loads((HERE / "motions.json").read_text(encoding="utf-8"))["motions"]
    answers = {}
    for row in rows:
        answers.setdefault(row["id"].strip(), []).append([number(row.get(name)) for name in ("t", "x", "y", "theta")])
    scored, gaps = [], 0
    for item in items:
        if item["id"] not in answers:
            continue
        worst, at, part, final = 0.0, None, "", None
        for t, x, y, theta in item["checkpoints"]:
            near = [row for row in answers[item["id"]] if abs(row[0] - t) <= 1e-6 * max(1, t)]
            if not near:
                gaps += 1
                worst, at, part = math.inf, t, "no answer"
                continue
            size = item["half_width"]
            errors = {"x": (near[0][1] - x) / size, "y": (near[0][2] - y) / size, "theta": near[0][3] - theta}
            for name, error in errors.items():
                error = abs(error) if math.isfinite(error) else math.inf
                if error > worst:
                    worst, at, part = error, t, name
            final = abs(errors["x"]) if math.isfinite(errors["x"]) else math.inf
        scored.append((item, worst, at, part, final))
    kinds = ["all"] + list(dict.fromkeys(item["kind"] for item in items))
    result = dict(answered=len(scored), missing=len(items) - len(scored), checkpoints_missing=gaps, unknown=len(set(answers) - {i["id"] for i in items}), groups={})
    lines = [["kind", "answered", *(f"within {100 * s:.0f} %" for s in SHARES), "median of the worst error", "median of the final slide's error"]]
    for kind in kinds:
        picked = [entry for entry in scored if kind in ("all", entry[0]["kind"])]
        counts = [sum(entry[1] <= s for entry in picked) for s in SHARES]
        middle = median([entry[1] for entry in picked])
        final = median([entry[4] for entry in picked if entry[0]["at_rest"] and entry[4] is not None])
        result["groups"][kind] = dict(answered=len(picked), within={str(s): c for s, c in zip(SHARES, counts)}, median_error=finite(middle), median_final_slide_error=finite(final))
        show = lambda value: "-" if value is None else f"{100 * value:.3g} %"
        lines.append([kind, len(picked), *(percent(c, len(picked)) for c in counts), show(middle), show(final)])
    print(f"Motions: {len(scored)} of {len(items)} answered, {len(items) - len(scored)} missing" + (f"; {gaps} checkpoints of these are missing" if gaps else "") + (f"; {result['unknown']} ids are unknown" if result["unknown"] else ""))
    print("The error of a motion is its worst at any checkpoint, of x or y in half widths B, or of θ in rad; the final slide is that of bodies that rest.\n")
    table(lines)
    if failed:
        print(f"\nFailed, by more than {100 * SHARES[1]:.0f} %:")
        for item, worst, at, part, _ in scored:
            if worst > SHARES[1]:
                before = [event for event in item["events"] if event["t"] <= (at or 0)]
                state = f"; expected state {before[-1]['state']} since {before[-1]['why']} at t = {before[-1]['t']:.6g}" if before else ""
                print(f"{item['id']} ({item['kind']}, {item['response']}, γ {item['half_height']}, μ {item['friction']}): {100 * worst:.3g} % in {part} at t = {at:.6g} of {item['t_end']}{state}; divergence {item['divergence']:g}")
    return result


def median(values):
    values = sorted(values)
    middle = len(values) // 2
    return None if not values else values[middle] if len(values) % 2 else (values[middle - 1] + values[middle]) / 2


def finite(value):
    return None if value is None or not math.isfinite(value) else value


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("answers", nargs="+", help="CSV files of answers")
    parser.add_argument("--failed", action="store_true", help="list what failed, and why")
    parser.add_argument("--threshold", type=float, default=THRESHOLD, help="in g: a slower corner is at rest [default: 0.01]")
    parser.add_argument("--json", action="store_true", help="print one line of JSON after each table")
    parser.add_argument("--brief", action="store_true", help="one line a file in place of the tables")
    chosen = parser.parse_args()
    results = {"onset": [], "motions": []}
    for path in chosen.answers:
        with open(path, newline="", encoding="utf-8-sig") as file:
            reader = csv.DictReader(file)
            rows = [row for row in reader if row.get("id")]
            columns = reader.fieldnames or []
        name = Path(path).name
        if {"t", "x", "y", "theta"} <= set(columns):
            kind, ask = "motions", lambda: motions(rows, chosen.failed)
        elif "mode" in columns or "slip_left" in columns:
            kind, ask = "onset", lambda: onset(rows, chosen.threshold, chosen.failed)
        else:
            print(f"{name}: neither `mode`, nor `slip_left` and so on, nor `t`, `x`, `y` and `theta` are among the columns.")
            continue
        if chosen.brief:
            with contextlib.redirect_stdout(io.StringIO()):
                results[kind].append((name, ask()))
            continue
        print(f"{name}\n")
        result = ask()
        if chosen.json:
            print("\n" + json.dumps(result))
        print()
    brief(results)


def brief(results):
    if results["onset"]:
        lines = [["onset problems", "answered", "unique", "near", "indeterminate: one of them", "chosen there"]]
        for name, result in results["onset"]:
            g = result["groups"]
            shares = [percent(g[group]["right"], g[group]["answered"]) for group in ("unique all", "near all")]
            several = g["indeterminate"]
            lines.append([name, result["answered"], *shares, percent(several["consistent"], several["answered"]),
                          ", ".join(f"{m} {n}" for m, n in several["chosen"].items()) or "-"])
        table(lines)
    if results["motions"]:
        if results["onset"]:
            print()
        lines = [["motions", "answered", *(f"within {100 * s:.0f} %" for s in SHARES), "median of the worst error", "median of the final slide's error"]]
        for name, result in results["motions"]:
            g = result["groups"]["all"]
            show = lambda value: "-" if value is None else f"{100 * value:.2g} %"
            lines.append([name, result["answered"], *(percent(c, g["answered"]) for c in g["within"].values()), show(g["median_error"]), show(g["median_final_slide_error"])])
        table(lines)


if __name__ == "__main__":
    main()
