"""Pure rocking under a record: `standfast simulate` against Housner's equation, compiled by numba.

    pip install numba==0.68.1 numpy==2.4.6
    python rocking.py PATH/TO/standfast [NUMBER] [--off SHARE]     # 400 blocks; a ratio that is wrong by a share

Uniform blocks under the records of examples/records, as they are and scaled, with friction of 50, so that none slips before it is past its
balance. With φ = |θ|, s its sign, a and g the accelerations of the base and of gravity, linear between samples, a block obeys

    φ'' = −3/(4R) (g sin(α − φ) − s a cos(α − φ)) while it rocks,      φ' → r φ' at φ = 0,      |a| > g tan α from rest.

Cooper's and Verner's method of eighth order takes N equal steps between two samples, N = 1, 2, 4, … until the answer no longer changes; φ = 0,
φ' = 0 and a quarter turn are found to rounding by steps of other lengths. Impacts are followed one by one until less than 1e-9 √(b/g) is left
of their sequence. The program closes such a sequence earlier, by its sum: the impacts in between are followed here alone.

Compared are the verdict, each event and its time, the largest |θ|, its time, and the moment of rest. A difference of angles, over α, may
be 1e-10, or 1e-12 S where the program's divergence S, by which it says that errors grow, makes that more; of times, in seconds, a hundred
times that, for late in a sequence of impacts small errors of a rate are larger ones of the time; of the moment of rest a tenth of what is
closed more. A block that overturns has no largest angle: of it the moment is compared at which N has fallen so far that even a friction
of 50 is exhausted, and where it never does, that of the quarter turn.
"""

import argparse
import collections
import csv
import json
import math
import pathlib
import random
import resource
import subprocess
import sys
import tempfile
import time

import numba
import numpy as np

ROOT = pathlib.Path(__file__).parents[2]
RECORDS = ROOT / "examples/records"
ACROSS, UP = ("np01002p_4225a_a.smc", "np01002p_4225c_a.smc"), "np01002p_4225b_a.smc"
DT, GRAVITY, FRICTION, T_MAX = 0.005, 9.81, 50.0, 120.0
UPLIFT, IMPACT, REST, CONE, OVER = range(5)
NAMES = ("uplift", "impact", "rest", "friction exhausted", "overturned")
MOST = 200_000


def tableau():
    """Cooper's and Verner's eleven stages of eighth order (1972)."""
    s = math.sqrt(21)
    rows = [
        {},
        {0: 1 / 2},
        {0: 1 / 4, 1: 1 / 4},
        {0: 1 / 7, 1: (-7 - 3 * s) / 98, 2: (21 + 5 * s) / 49},
        {0: (11 + s) / 84, 2: (18 + 4 * s) / 63, 3: (21 - s) / 252},
        {0: (5 + s) / 48, 2: (9 + s) / 36, 3: (-231 + 14 * s) / 360, 4: (63 - 7 * s) / 80},
        {0: (10 - s) / 42, 2: (-432 + 92 * s) / 315, 3: (633 - 145 * s) / 90, 4: (-504 + 115 * s) / 70, 5: (63 - 13 * s) / 35},
        {0: 1 / 14, 4: (14 - 3 * s) / 126, 5: (13 - 3 * s) / 63, 6: 1 / 9},
        {0: 1 / 32, 4: (91 - 21 * s) / 576, 5: 11 / 72, 6: (-385 - 75 * s) / 1152, 7: (63 + 13 * s) / 128},
        {0: 1 / 14, 4: 1 / 9, 5: (-733 - 147 * s) / 2205, 6: (515 + 111 * s) / 504, 7: (-51 - 11 * s) / 56, 8: (132 + 28 * s) / 245},
        {4: (-42 + 7 * s) / 18, 5: (-18 + 28 * s) / 45, 6: (-273 - 53 * s) / 72, 7: (301 + 53 * s) / 72, 8: (28 - 28 * s) / 45, 9: (49 - 7 * s) / 18},
    ]
    a = np.zeros((11, 11))
    for i, row in enumerate(rows):
        for j, value in row.items():
            a[i, j] = value
    b = np.zeros(11)
    b[[0, 7, 8, 9, 10]] = 1 / 20, 49 / 180, 16 / 45, 49 / 180, 1 / 20
    return a, b, a.sum(axis=1)


A, B, C = tableau()


@numba.njit(inline="always")
def acceleration(phi, a, g, alpha, k):
    return -k * (g * math.sin(alpha - phi) - a * math.cos(alpha - phi))


@numba.njit
def step(phi, w, h, a0, a1, g0, g1, alpha, k):
    """φ and φ' after h; a0 + a1 t is the base's acceleration against the sense of φ, g0 + g1 t gravity."""
    rates, turns = np.empty(11), np.empty(11)
    for i in range(11):
        p, v = 0.0, 0.0
        for j in range(i):
            p += A[i, j] * rates[j]
            v += A[i, j] * turns[j]
        rates[i] = w + h * v
        turns[i] = acceleration(phi + h * p, a0 + a1 * C[i] * h, g0 + g1 * C[i] * h, alpha, k)
    p, v = 0.0, 0.0
    for i in range(11):
        p += B[i] * rates[i]
        v += B[i] * turns[i]
    return phi + h * p, w + h * v


@numba.njit
def held(phi, w, a, g, alpha, k, radius, friction):
    """μN − |T|, per mass."""
    turn = acceleration(phi, a, g, alpha, k)
    sine, cosine = radius * math.sin(alpha - phi), radius * math.cos(alpha - phi)
    return friction * (g + sine * turn - cosine * w * w) - abs(a - cosine * turn - sine * w * w)


@numba.njit
def moment(what, low, high, phi, w, a0, a1, g0, g1, alpha, k, radius, friction):
    """When, between low and high, what changes its sign: φ (0), φ' (1), φ − π/2 (2), μN − |T| (3)."""
    t, first, width = high, True, high - low
    sign = 1.0
    for n in range(200):
        if n == 1:
            t = 0.5 * (low + high)
        p, v = step(phi, w, t, a0, a1, g0, g1, alpha, k)
        a, g = a0 + a1 * t, g0 + g1 * t
        if what == 0:
            f, slope = p, v
        elif what == 1:
            f, slope = v, acceleration(p, a, g, alpha, k)
        elif what == 2:
            f, slope = p - 0.5 * math.pi, v
        else:
            f, slope = held(p, v, a, g, alpha, k, radius, friction), 0.0
        if first:
            sign, first = (1.0 if f > 0 else -1.0), False
            continue
        if f * sign > 0:
            high = t
        else:
            low = t
        then = t - f / slope if slope != 0 else low
        if not low < then < high:
            then = 0.5 * (low + high)
        if abs(then - t) <= 1e-16 * t or not low < then < high or high - low < 1e-17 * width:
            return then
        t = then
    return t


@numba.njit
def follow(a_start, a_end, g_start, g_end, dt, gravity, alpha, radius, ratio, friction, t_max, steps, times, kinds):
    """The number of events, whose times and kinds are written, the largest φ, its time, the last θ, φ where friction is exhausted, the number of steps."""
    k = 0.75 / radius
    unit = math.sqrt(radius * math.sin(alpha) / gravity)
    side, phi, w = 0.0, 0.0, 0.0
    largest, at, events, taken, slipped = 0.0, 0.0, 0, 0, -1.0
    for piece in range(int(math.ceil(t_max / dt))):
        begin, length = piece * dt, min(dt, t_max - piece * dt)
        a_0, a_1, g_0, g_1 = 0.0, 0.0, gravity, 0.0
        if piece < len(a_start):
            a_0, a_1 = a_start[piece], (a_end[piece] - a_start[piece]) / dt
            g_0, g_1 = g_start[piece], (g_end[piece] - g_start[piece]) / dt
        x = 0.0
        while length - x > 1e-15:
            if side == 0.0:
                # From rest, to the side away from which the base goes.
                first = length
                for s in (1.0, -1.0):
                    now = s * (a_0 + a_1 * x) * math.cos(alpha) - (g_0 + g_1 * x) * math.sin(alpha)
                    rate = s * a_1 * math.cos(alpha) - g_1 * math.sin(alpha)
                    when = x if now > 0 else (x - now / rate if rate > 0 else length)
                    if when < first:
                        first, side = when, s
                x = first
                if side != 0.0:
                    times[events], kinds[events] = begin + x, UPLIFT
                    events += 1
                    phi, w = 0.0, 0.0
                continue
            a0, a1, g0, g1 = side * (a_0 + a_1 * x), side * a_1, g_0 + g_1 * x, g_1
            h = min(dt / steps, length - x)
            if phi == 0.0 and w > 0:
                turn = acceleration(0.0, a0, g0, alpha, k)
                if turn < 0 and -2.5 * w / turn < h:
                    h = -2.5 * w / turn
            p, v = step(phi, w, h, a0, a1, g0, g1, alpha, k)
            taken += 1
            struck = p < 0
            end = h
            if not struck and w < 0 and v > 0:
                # It may have touched the base in between.
                end = moment(1, 0.0, h, phi, w, a0, a1, g0, g1, alpha, k, radius, friction)
                struck = step(phi, w, end, a0, a1, g0, g1, alpha, k)[0] < 0
                if not struck:
                    end = h
            if struck:
                low = 0.0
                if phi == 0.0:
                    low = end
                    while low > 0 and step(phi, w, low, a0, a1, g0, g1, alpha, k)[0] <= 0:
                        low *= 0.5
                end = moment(0, low, end, phi, w, a0, a1, g0, g1, alpha, k, radius, friction)
                p, v = step(phi, w, end, a0, a1, g0, g1, alpha, k)
            over = not struck and p >= 0.5 * math.pi
            if over:
                end = moment(2, 0.0, h, phi, w, a0, a1, g0, g1, alpha, k, radius, friction)
                p, v = step(phi, w, end, a0, a1, g0, g1, alpha, k)
            if slipped < 0 and held(p, v, a0 + a1 * end, g0 + g1 * end, alpha, k, radius, friction) < 0:
                when = moment(3, 0.0, end, phi, w, a0, a1, g0, g1, alpha, k, radius, friction)
                slipped = step(phi, w, when, a0, a1, g0, g1, alpha, k)[0]
                times[events], kinds[events] = begin + x + when, CONE
                events += 1
            if w > 0 and v < 0:
                top = moment(1, 0.0, end, phi, w, a0, a1, g0, g1, alpha, k, radius, friction)
                high = step(phi, w, top, a0, a1, g0, g1, alpha, k)[0]
                if high > largest:
                    largest, at = high, begin + x + top
            if p > largest:
                largest, at = p, begin + x + end
            x += end
            phi, w = p, v
            if over:
                times[events], kinds[events] = begin + x, OVER
                return events + 1, largest, at, side * phi, slipped, taken
            if struck:
                times[events], kinds[events] = begin + x, IMPACT
                events += 1
                side, phi, w = -side, 0.0, -ratio * w
                # What is left of the sequence, as a geometric series under the load of now.
                a, g = side * (a_0 + a_1 * x), g_0 + g_1 * x
                here, there = acceleration(0.0, a, g, alpha, k), acceleration(0.0, -a, g, alpha, k)
                if here < 0 and there < 0:
                    left = -2 * w * (1 / here + ratio / there) / (1 - ratio * ratio)
                    if left < 1e-9 * unit:
                        side, w = 0.0, 0.0
                        times[events], kinds[events] = begin + x + left, REST
                        events += 1
            if events > MOST - 4:
                return -1, largest, at, side * phi, slipped, taken
    return events, largest, at, side * phi, slipped, taken


def values(name):
    """The accelerations of an SMC file in m/s2, as newmark.py reads it."""
    lines = (RECORDS / name).read_text(errors="replace").splitlines()
    integers = [int(line[i : i + 10]) for line in lines[11:17] for i in range(0, 80, 10)]
    comments, count = integers[15], integers[16]
    cells = [line[i : i + 10].strip() for line in lines[27 + comments :] for i in range(0, 80, 10)]
    return [float(cell) for cell in cells if cell][:count]


class Case:
    """A block under a record: half of them under the record as it is."""

    def __init__(self, seed):
        pick = random.Random(seed)
        self.seed = seed
        self.d, self.alpha = pick.uniform(0.2, 6), pick.uniform(0.08, 0.4)
        self.b = self.d * math.tan(self.alpha)
        self.file = pick.choice(ACROSS)
        self.factor = 0.01 * (1 if seed % 2 else math.exp(pick.uniform(0, math.log(6))))
        self.vertical = seed % 4 > 1
        self.law = "ratio" if pick.random() < 0.25 else "housner"
        housner = 1 - 1.5 * math.sin(self.alpha) ** 2
        self.ratio = pick.uniform(0.8, 0.99) if self.law == "ratio" else housner

    def toml(self):
        lines = ["[block]", f"b1 = {self.b!r}", f"b2 = {self.b!r}", f"d = {self.d!r}", f"rho2 = {(self.b**2 + self.d**2) / 3!r}"]
        lines += [f"mu_s = {FRICTION}", f"gravity = {GRAVITY}", "[motion]", f"t_max = {T_MAX}"]
        lines.append(f'impact = {{ law = "ratio", ratio = {self.ratio!r} }}' if self.law == "ratio" else 'impact = { law = "housner" }')
        lines += ["[motion.base]", f'horizontal = {{ shape = "file", file = "{RECORDS / self.file}", factor = {self.factor!r} }}']
        if self.vertical:
            lines.append(f'vertical = {{ shape = "file", file = "{RECORDS / UP}", factor = {self.factor!r} }}')
        return "\n".join(lines) + "\n"

    def loads(self, records):
        """The accelerations at both ends of each piece; outside of a record there is none."""
        count = max(len(record) for record in records.values()) - 1
        ends = []
        for name in (self.file, UP if self.vertical else None):
            first, last = np.zeros(count), np.zeros(count)
            if name:
                record = np.array(records[name]) * self.factor
                first[: len(record) - 1], last[: len(record) - 1] = record[:-1], record[1:]
            ends.append((first, last))
        (a_start, a_end), (v_start, v_end) = ends
        return a_start, a_end, GRAVITY + v_start, GRAVITY + v_end


Answer = collections.namedtuple("Answer", "events largest at theta slipped steps n seconds")


def witness(case, loads, off, tolerance):
    """The motion by as many steps between samples as change nothing any more, and how many these are."""
    times, kinds = np.empty(MOST), np.empty(MOST, dtype=np.int64)

    def run(n):
        begin = time.process_time()
        ratio = case.ratio * (1 - off)
        count, *found = follow(*loads, DT, GRAVITY, case.alpha, math.hypot(case.b, case.d), ratio, FRICTION, T_MAX, n, times, kinds)
        seconds = time.process_time() - begin
        assert count >= 0, "too many events"
        return Answer([(float(t), int(kind)) for t, kind in zip(times[:count], kinds[:count])], *found, n, seconds)

    coarse = run(1)
    while coarse.n < 64:
        fine = run(2 * coarse.n)
        one, other = ([event for event in run.events if event[1] != IMPACT] for run in (coarse, fine))
        same = [kind for _, kind in one] == [kind for _, kind in other] and abs(fine.largest - coarse.largest) < 0.1 * tolerance * case.alpha
        if same and max((abs(x[0] - y[0]) for x, y in zip(one, other)), default=0.0) < 100 * tolerance:
            return coarse, fine
        coarse = fine
    return None, coarse


def ask(program, case, folder):
    path = pathlib.Path(folder) / "case.toml"
    path.write_text(case.toml())
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    command = [program, "simulate", str(path), "--no-figures", "--no-strength", "--format", "json"]
    run = subprocess.run(command, capture_output=True, text=True, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return json.loads(run.stdout), after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def events(answer):
    """The program's events in the words of this script; after friction is exhausted only the overturning counts."""
    found, resting = [], True
    for event in answer["events"]:
        t, why, state = event["t"], event["why"], event["state"]
        if why in ("impact", "cone", "overturned"):
            found.append((t, {"impact": IMPACT, "cone": CONE, "overturned": OVER}[why]))
        elif why == "settle":
            found.append((t, REST))
        elif why in ("start", "end", "rest") or (why == "jump" and not resting):
            pass
        elif why not in ("load", "jump", "tip"):
            found.append((t, why))
        if state in ("RO", "RO'") and (resting or why == "settle"):
            found.append((t, UPLIFT))
        resting = state == "RE"
        if why == "cone":
            return found
    return found


def matched(ours, theirs, near):
    """The differences of times, event by event, how many impacts only this script follows, and the first event that has no like."""
    i, apart, closed = 0, [], 0
    for t, kind in theirs:
        if kind == REST:
            while i < len(ours) and ours[i][1] == IMPACT and ours[i][0] > t - near:
                i, closed = i + 1, closed + 1
        if i == len(ours) or ours[i][1] != kind:
            return apart, closed, (t, kind)
        apart.append((kind, abs(ours[i][0] - t)))
        i += 1
        if kind == CONE:
            return apart, closed, None
    return apart, closed, ours[i] if i < len(ours) else None


def spread(name, found, unit=""):
    if found:
        found = np.sort(found)
        print(f"{name:44s} {len(found):6d}   median {np.median(found):.1e}, 95 % {np.quantile(found, 0.95):.1e}, largest {found[-1]:.1e}{unit}")


def batch(program, cases, folder):
    """Seconds of the processor a motion where a table asks for many, and the largest |θ| of each row."""
    table, path = pathlib.Path(folder) / "table.csv", pathlib.Path(folder) / "case.toml"
    path.write_text(cases[0].toml())
    with table.open("w", newline="") as file:
        rows = csv.writer(file)
        rows.writerow(["block.b1", "block.b2", "block.d", "block.rho2", "motion.base.horizontal.factor", "motion.base.horizontal.file"])
        rows.writerows([case.b, case.b, case.d, (case.b**2 + case.d**2) / 3, case.factor, RECORDS / case.file] for case in cases)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    command = [program, "batch", str(table), "--case", str(path), "-o", "-", "--columns", "max_theta", "--threads", "1"]
    run = subprocess.run(command, capture_output=True, text=True, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    found = [float(row["max_theta"]) for row in csv.DictReader(run.stdout.splitlines())]
    return (after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime) / len(cases), found


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("number", nargs="?", type=int, default=400)
    parser.add_argument("--off", type=float, default=0.0, metavar="SHARE", help="make the ratio of this script wrong by so much, which has to be noticed")
    options = parser.parse_args()
    records = {name: values(name) for name in (*ACROSS, UP)}
    compile_first = Case(0)
    witness(compile_first, compile_first.loads(records), 0.0, 1e-10)

    differs, verdicts, steps, angles, at, apart, closed, early = [], collections.Counter(), collections.Counter(), [], [], [], 0, 0
    rests, cones, quarters, kept, theirs_seconds, ours_seconds, table, impacts = [], [], [], [], [], [], [], 0
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(options.number):
            case = Case(seed)
            answer, seconds = ask(options.program, case, folder)
            divergence = (answer["divergence"] or {"value": 0.0})["value"]
            tolerance = max(1e-10, 1e-12 * divergence)
            coarse, fine = witness(case, case.loads(records), options.off, tolerance)
            theirs_seconds.append(seconds)
            stands = "rests throughout" if not answer["max_theta"] else "rocks and rests" if answer["at_rest"] else "still rocks"
            verdicts["overturns" if answer["overturned"] else stands] += 1
            wrong = []
            if coarse is None:
                wrong.append("this script does not converge")
            else:
                steps[coarse.n] += 1
                ours_seconds.append((coarse.seconds, coarse.steps))
            overturned = bool(fine.events) and fine.events[-1][1] == OVER
            if overturned != answer["overturned"]:
                wrong.append(f"the verdict: here {'overturns' if overturned else 'stands'}")
            # What the program closes by its sum: the load stays as it is for so long, which the load does not.
            closes = 1e-5 * math.sqrt(case.b / GRAVITY)
            found, more, first = matched(fine.events, events(answer), closes + 100 * tolerance)
            impacts += answer["impacts"]
            late = max((t - (0.1 * closes if kind == REST else 0) for kind, t in found), default=0.0)
            if late > 100 * tolerance:
                wrong.append(f"events by {late:.1e} s")
            closed += more
            if first:
                wrong.append(f"events from t = {first[0]:.6f} on ({first[1] if isinstance(first[1], str) else NAMES[first[1]]})")
            apart += [t for kind, t in found if kind in (IMPACT, UPLIFT)]
            rests += [t for kind, t in found if kind == REST]
            cones += [t for kind, t in found if kind == CONE]
            quarters += [t for kind, t in found if kind == OVER]
            early += 0 <= fine.slipped < case.alpha
            if answer["max_theta"] and not answer["overturned"]:
                difference = abs(fine.largest - answer["max_theta"]) / case.alpha
                angles.append(difference)
                at.append(abs(fine.at - answer["t_max_theta"]))
                kept.append((difference / tolerance, divergence))
                if difference > tolerance:
                    wrong.append(f"the largest angle by {difference:.1e} of α")
                if not answer["at_rest"] and abs(fine.theta - answer["theta"]) > tolerance * case.alpha:
                    wrong.append(f"the last angle by {abs(fine.theta - answer['theta']) / case.alpha:.1e} of α")
            if case.law == "housner" and not case.vertical:
                table.append((case, answer["max_theta"]))
            if wrong:
                differs.append(seed)
                block = f"d {case.d:.3f} m, α {case.alpha:.4f}, {case.law} {case.ratio:.4f}, factor {100 * case.factor:.3f}"
                print(f"{seed}: {block}, divergence {divergence:.3g}: {'; '.join(wrong)}", flush=True)
        each, told = batch(options.program, [case for case, _ in table], folder)
    said = ", ".join(f"{verdict} {count}" for verdict, count in sorted(verdicts.items()))
    print(f"{options.number} blocks: {said}; {len(differs)} differ; {early} slip before they are past their balance, and are compared up to there")
    print(f"steps between two samples that sufficed: {', '.join(f'{n} in {count}' for n, count in sorted(steps.items()))}")
    spread("largest |θ| over α", angles)
    if kept:
        above = ", ".join(f"above {least:.0e} in {sum(s > least for _, s in kept)}" for least in (1e2, 1e4, 1e6))
        print(f"    of what is allowed {max(share for share, _ in kept):.2g} at most; divergence {above}, largest {max(s for _, s in kept):.2g}")
    spread("its time", at, " s")
    spread("uplift and impacts", apart, " s")
    spread("rest", rests, " s")
    spread("friction exhausted, of what overturns", cones, " s")
    spread("a quarter turn, of what holds so long", quarters, " s")
    print(f"{impacts} impacts there, {closed} more here in the sequences that are closed there")
    print(f"batch and simulate have the same largest |θ| in {sum(x == y for x, (_, y) in zip(told, table))} of {len(table)}")
    if ours_seconds:
        seconds, taken = np.array(ours_seconds).T
        print(f"the processor takes, in the median of motions, {1e3 * np.median(seconds):.2f} ms here ({1e9 * seconds.sum() / taken.sum():.0f} ns a step);")
        print(f"    of the program {1e3 * np.median(theirs_seconds):.1f} ms from its start to its end with divergence, {1e3 * each:.2f} ms a row of a table")
    return len(differs) > 0


if __name__ == "__main__":
    sys.exit(main())
