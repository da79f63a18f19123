"""Which cases of the benchmark does a contact engine get right, and which does it fail, and why?

    python score.py answers.csv [more.csv ...]     # of onset problems or of motions; each file tells which by its columns
    python score.py answers.csv --failed           # with a list of what failed
    python score.py answers.csv --json             # for programs
    python score.py results/*.csv --brief          # one line a file
    python score.py answers.csv --again OTHER      # whether other answers, a file or a folder, give the same counts

Answers to onset problems have the columns `id` and `mode`, or `id`, `slip_left`, `lift_left`, `slip_right` and `lift_right`:
accelerations in g of the bottom corners soon after the force, along the floor to the right and upwards. Answers to motions have
`id`, `t`, `x`, `y` and `theta`. Where an engine gave no number or mode, write nan. Python 3.9 and its standard library do.
"""

import argparse
import contextlib
import csv
import io
import json
import math
import os
import sys
from collections import Counter
from pathlib import Path

HERE = Path(__file__).resolve().parent
#: In g: less than this is taken for none.
THRESHOLD = 0.01
MODES = ["RE", "SL", "RO", "SRO-", "SRO+", "SRO'-"]
SHARES = [0.01, 0.05, 0.2]
CORNERS = ("slip_left", "lift_left", "slip_right", "lift_right")
POINT = ("t", "x", "y", "theta")
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


class Wrong(Exception):
    """What is wrong with a file, in words."""


def load(name):
    return json.loads((HERE / f"{name}.json").read_text(encoding="utf-8"))[{"onset": "problems"}.get(name, name)]


def number(row, name, line):
    text = (row.get(name) or "").strip()
    try:
        return float(text)
    except ValueError:
        raise Wrong(f"line {line}: {name} is " + (f"`{text[:40]}`, which is not a number" if text else "empty; where there is no number, write nan")) from None


def read(path):
    """Of a file of answers: "onset" or "motions", and the answers by id. What is wrong with it is raised as Wrong."""
    try:
        return parse(path)
    except Wrong as error:
        raise Wrong(f"{path}: {error}") from None


def parse(path):
    try:
        with open(path, newline="", encoding="utf-8-sig") as file:
            reader = csv.DictReader(file, strict=True)
            columns = [name.strip() for name in reader.fieldnames or []]
            reader.fieldnames = columns
            rows = [(reader.line_num, row) for row in reader]
    except OSError as error:
        raise Wrong(f"it cannot be read: {error.strerror or error}") from None
    except UnicodeDecodeError:
        raise Wrong("it is not text in UTF-8") from None
    except csv.Error as error:
        raise Wrong(f"it is not CSV: {error}") from None
    if not columns:
        raise Wrong("it is empty")
    kind = "motions" if "mode" not in columns and not set(CORNERS) & set(columns) else "onset"
    needed = ["id", *POINT] if kind == "motions" else ["id"] if "mode" in columns else ["id", *CORNERS]
    missing = [name for name in needed if name not in columns]
    if missing:
        alone = kind == "motions" and not set(POINT) & set(columns)
        hint = "; separate them by commas" if len(columns) == 1 and set(";\t") & set(columns[0]) else "; names are in lower case" if "id" not in columns and "id" in map(str.lower, columns) else ""
        want = "`mode`, or `slip_left` and so on, or `t`, `x`, `y` and `theta`" if alone else ", ".join(f"`{name}`" for name in missing)
        raise Wrong(f"columns are missing: {'`id` and ' if alone and 'id' in missing else ''}{want}; the columns are {', '.join(columns)[:200]}{hint}")
    if len(set(columns)) < len(columns):
        raise Wrong("two columns have the same name")
    if not rows:
        raise Wrong("it has columns, but no answers")
    known, found = {item["id"] for item in load(kind)}, {}
    for line, row in rows:
        if None in row:
            raise Wrong(f"line {line}: there are more fields than columns")
        name = (row["id"] or "").strip()
        if name not in known:
            raise Wrong(f"line {line}: " + (f"`{name[:40]}` is the id of none of the {'onset problems' if kind == 'onset' else 'motions'}" if name else "the id is empty"))
        if kind == "motions":
            point = [number(row, part, line) for part in POINT]
            if not math.isfinite(point[0]):
                raise Wrong(f"line {line}: t is {point[0]}")
            found.setdefault(name, []).append(point)
            continue
        if name in found:
            raise Wrong(f"line {line}: {name} has an answer above")
        mode = (row.get("mode") or "").strip().replace("₋", "-").replace("₊", "+").replace("−", "-").replace("’", "'")
        mode = "?" if mode.lower() == "nan" else mode
        if not mode and "mode" in columns and not set(CORNERS) <= set(columns):
            raise Wrong(f"line {line}: mode is empty; where there is none, write nan")
        if mode and mode not in WORDS:
            raise Wrong(f"line {line}: the mode `{mode[:40]}` is unknown; it is one of {', '.join(WORDS)}")
        corners = None if mode and not set(CORNERS) <= set(columns) else [number(row, part, line) for part in CORNERS]
        found[name] = mode, corners
    return kind, found


def percent(part, whole):
    return f"{100 * part / whole:.1f} %" if whole else "-"


def share(value, digits):
    """In %, with so many digits and no exponent."""
    if value is None or not math.isfinite(value):
        return "-"
    words = f"{100 * value:.{digits}g}"
    return (f"{float(words):.15f}".rstrip("0") if "e-" in words else f"{float(words):.0f}" if "e" in words else words) + " %"


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


def onset(found, threshold, failed):
    problems = load("onset")
    answers = {name: mode or infer(*corners, threshold) for name, (mode, corners) in found.items()}
    answered = [problem for problem in problems if problem["id"] in answers]
    result = dict(answered=len(answered), missing=len(problems) - len(answered), groups={})
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
    print(f"Onset: {len(answered)} of {len(problems)} problems answered, {len(problems) - len(answered)} missing")
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
                print(f"{p['id']} ({p['gamma']}, {p['k_prime']}, {p['k']}, {p['mu']}): expected {' or '.join(p['modes'])}, found {mode} ({WORDS[mode]}); {change(p)}{why(p, mode, found[p['id']][1], threshold)}")
    return result


def why(problem, mode, corners, threshold):
    """What tells the expected mode from the one found: the boundary, what is slow in the motion, and where the corners' accelerations differ."""
    a, words = problem["motions"][problem["mode"]], ""
    if mode in problem["boundary"]["modes"]:
        words += "; it is the mode beyond that boundary"
    small = [f"{name} {a[name]:+.3f} g" for name in CORNERS if 0 < abs(a[name]) < 0.1]
    if small:
        words += "; slow: " + ", ".join(small)
    if corners and mode != "?" and len(problem["modes"]) == 1:
        differ = [f"{name} {value:+.3f} g for {a[name]:+.3f}" for name, value in zip(CORNERS, corners) if not abs(value - a[name]) <= threshold]
        words += "; it found " + ", ".join(differ) if differ else ""
    return words


def state_at(item, t):
    """The state at a moment, in words, as far as events are listed."""
    before = [event for event in item["events"] if event["t"] <= t]
    if not before:
        return ""
    listed, last = item["events"], before[-1]
    if item["events_in_all"] > len(listed) and len(listed) > 1 and listed[-2]["t"] <= t < listed[-1]["t"]:
        return f"; events between t = {listed[-2]['t']:.6g} and {listed[-1]['t']:.6g} are not listed"
    return f"; expected state {last['state']} since {last['why']} at t = {last['t']:.6g}"


def motions(answers, failed, within=SHARES[1]):
    items = load("motions")
    scored, gaps, others = [], 0, 0
    for item in items:
        if item["id"] not in answers:
            continue
        worst, at, part, final, pair = 0.0, None, "", None, ""
        taken = set()
        for t, x, y, theta in item["checkpoints"]:
            near = [i for i, row in enumerate(answers[item["id"]]) if abs(row[0] - t) <= 1e-6 * max(1, t)]
            if not near:
                gaps += 1
                if worst < math.inf:
                    worst, at, part, pair = math.inf, t, "", "no answer"
                final = math.inf
                continue
            taken.update(near)
            near = answers[item["id"]][near[0]]
            size = item["half_width"]
            errors = {"x": (near[1] - x) / size, "y": (near[2] - y) / size, "theta": near[3] - theta}
            for name, value, truth in zip(errors, near[1:], (x, y, theta)):
                error = abs(errors[name]) if math.isfinite(errors[name]) else math.inf
                if error > worst:
                    worst, at, part, pair = error, t, name, f"{value:.5g} for {truth:.5g}"
            final = abs(errors["x"]) if math.isfinite(errors["x"]) else math.inf
        others += len(answers[item["id"]]) - len(taken)
        scored.append((item, worst, at, f"{part} {pair}".strip(), final))
    kinds = ["all"] + list(dict.fromkeys(item["kind"] for item in items))
    result = dict(answered=len(scored), missing=len(items) - len(scored), checkpoints_missing=gaps, other_times=others, groups={})
    lines = [["kind", "answered", *(f"within {100 * s:.0f} %" for s in SHARES), "median of the worst error", "median of the final slide's error"]]
    for kind in kinds:
        picked = [entry for entry in scored if kind in ("all", entry[0]["kind"])]
        counts = [sum(entry[1] <= s for entry in picked) for s in SHARES]
        middle = median([entry[1] for entry in picked])
        final = median([entry[4] for entry in picked if entry[0]["at_rest"] and entry[4] is not None])
        result["groups"][kind] = dict(answered=len(picked), within={str(s): c for s, c in zip(SHARES, counts)}, median_error=finite(middle), median_final_slide_error=finite(final))
        lines.append([kind, len(picked), *(percent(c, len(picked)) for c in counts), share(middle, 3), share(final, 3)])
    print(f"Motions: {len(scored)} of {len(items)} answered, {len(items) - len(scored)} missing" + (f"; {gaps} checkpoints of these are missing" if gaps else "") + (f"; {others} rows are at other times or twice" if others else ""))
    print("The error of a motion is its worst at any checkpoint, of x or y in half widths B, or of θ in rad; the final slide is that of bodies that rest.\n")
    table(lines)
    if failed:
        print(f"\nFailed, by more than {100 * within:g} %: {sum(entry[1] > within for entry in scored)}")
        for item, worst, at, part, _ in scored:
            if worst > within:
                error = f"{100 * worst:.3g} %, " if worst < math.inf else ""
                print(f"{item['id']} ({item['kind']}, {item['response']}, γ {item['half_height']}, μ {item['friction']}): {error}{part}, at t = {at:.6g} of {item['t_end']}{state_at(item, at or 0)}; divergence {item['divergence']:g}")
    return result


def median(values):
    values = sorted(values)
    middle = len(values) // 2
    return None if not values else values[middle] if len(values) % 2 else (values[middle - 1] + values[middle]) / 2


def finite(value):
    return None if value is None or not math.isfinite(value) else value


def ask(kind, found, threshold=THRESHOLD, failed=False, within=SHARES[1]):
    return onset(found, threshold, failed) if kind == "onset" else motions(found, failed, within)


def counts(kind, found, threshold):
    """The numbers of answers that are right, by group."""
    with contextlib.redirect_stdout(io.StringIO()):
        groups = ask(kind, found, threshold)["groups"]
    flat = {}
    for group, values in groups.items():
        for name, value in values.items():
            if isinstance(value, dict):
                flat.update({f"{group}, {name} {key}": v for key, v in value.items()})
            elif isinstance(value, int):
                flat[f"{group}, {name}"] = value
    return flat


def again(path, other, threshold=THRESHOLD):
    """Whether two files of answers have the same counts; prints it in a line."""
    (kind, a), (other_kind, b) = read(path), read(other)
    if kind != other_kind:
        raise Wrong(f"{path} answers {kind}, and {other} {other_kind}")
    one, two = counts(kind, a, threshold), counts(kind, b, threshold)
    differ = [f"{name} {one.get(name, 0)} and {two.get(name, 0)}" for name in sorted({**one, **two}) if one.get(name, 0) != two.get(name, 0)]
    same = sum(repr(a[name]) == repr(b.get(name)) for name in a)
    print(f"{Path(path).name}: {'other counts: ' + '; '.join(differ) if differ else 'the same counts'}; {same} of {len(a)} answers are the same to the digit", flush=True)
    return not differ


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("answers", nargs="+", help="CSV files of answers")
    parser.add_argument("--failed", action="store_true", help="list what failed, and why")
    parser.add_argument("--threshold", type=float, default=THRESHOLD, help="in g: a slower corner is at rest [default: 0.01]")
    parser.add_argument("--within", type=float, default=SHARES[1], help="a motion that is farther off failed, for --failed [default: 0.05]")
    parser.add_argument("--json", action="store_true", help="print one line of JSON after each table")
    parser.add_argument("--brief", action="store_true", help="one line a file in place of the tables")
    parser.add_argument("--again", metavar="OTHER", type=Path, help="compare the counts with those of another file, or of the file of the same name in a folder")
    chosen = parser.parse_args()
    for name in ("threshold", "within"):
        value = getattr(chosen, name)
        if not 0 <= value < math.inf:
            parser.error(f"--{name} is {value}; expected a number that is not below zero")
    if chosen.brief and (chosen.json or chosen.failed):
        parser.error("--brief is one line a file: --json and --failed do not go with it")
    results, good = {"onset": [], "motions": []}, True
    for path in chosen.answers:
        name = Path(path).name
        try:
            if chosen.again:
                good &= again(path, chosen.again / name if chosen.again.is_dir() else chosen.again, chosen.threshold)
                continue
            kind, found = read(path)
        except Wrong as error:
            print(error, file=sys.stderr)
            good = False
            continue
        if chosen.brief:
            with contextlib.redirect_stdout(io.StringIO()):
                results[kind].append((name, ask(kind, found, chosen.threshold)))
            continue
        print(f"{name}\n")
        result = ask(kind, found, chosen.threshold, chosen.failed, chosen.within)
        if chosen.json:
            print("\n" + json.dumps(result))
        print()
    brief(results)
    return 0 if good else 1


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
            lines.append([name, result["answered"], *(percent(c, g["answered"]) for c in g["within"].values()), share(g["median_error"], 2), share(g["median_final_slide_error"], 2)])
        table(lines)
        for name, result in results["motions"]:
            if result["checkpoints_missing"]:
                print(f"{name}: {result['checkpoints_missing']} checkpoints are missing")


if __name__ == "__main__":
    sys.stdout.reconfigure(encoding="utf-8")
    sys.stderr.reconfigure(encoding="utf-8", errors="backslashreplace")
    try:
        code = main()
        sys.stdout.flush()
    except BrokenPipeError:  # of `| head`
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        code = 1
    sys.exit(code)
