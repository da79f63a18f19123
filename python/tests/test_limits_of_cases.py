"""The margins of rest of a case: by hand, from the sum of all loads, and by their signs against the decision."""

from __future__ import annotations

import importlib
import math
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import standfast
from standfast import Mode, Situation
from test_agreement import random_case

ROOT = Path(__file__).parents[2]
EXAMPLES = sorted((ROOT / "examples").glob("*.toml"))


def test_a_block_by_hand() -> None:
    # 1 m by 2 m and 4800 kg/m, g = 10: 48 kN/m at 0.5 m from both corners, against 20 kN/m at 1.5 m to the left.
    block: dict[str, Any] = {
        "gravity": 10,
        "body": {"width": 1, "height": 2, "mass": 4800, "friction": 0.5},
        "load": [{"force": 20e3, "elevation": 1.5}],
    }
    found = standfast.assess(block)
    assert found.margin_sliding == pytest.approx(0.5 * 48e3 - 20e3, rel=1e-14)
    assert found.margin_overturning_heel == pytest.approx(48e3 * 0.5 - 20e3 * 1.5, rel=1e-14)
    assert found.margin_overturning_toe == pytest.approx(48e3 * 0.5 + 20e3 * 1.5, rel=1e-14)
    assert found.margin_overturning == found.margin_overturning_heel < 0 and found.mode is Mode.ROCK_O
    # To the right, the other corner is the heel.
    block["load"][0]["direction"] = "right"
    assert standfast.assess(block).margin_overturning == found.margin_overturning
    # 60 kN/m of uplift: nothing presses, and the margins say how far it is from pressing.
    block["uplift"] = {"left": 60e3, "right": 60e3}
    lifted = standfast.assess(block)
    assert lifted.lifted and lifted.SF_sliding is None
    assert lifted.margin_sliding == pytest.approx(0.5 * (48e3 - 60e3) - 20e3, rel=1e-14)
    heel, toe = lifted.margin_overturning_heel, lifted.margin_overturning_toe
    assert [heel, toe] == pytest.approx([-12e3 * 0.5 - 30e3, -12e3 * 0.5 + 30e3], rel=1e-13)
    # Of an object of a length, in N and N m.
    rack = standfast.assess(ROOT / "examples/server-rack.toml")
    assert rack.extent == "whole" and rack.margin_sliding == pytest.approx(
        rack.body.friction * rack.governing.wrench.p - abs(rack.governing.wrench.x), rel=1e-12
    )


def is_held(situation: Situation) -> bool:
    """Whether something holds it beside friction, which is in no sum of loads."""
    said = situation.to_dict()
    return bool(said.get("resistances") or said.get("adhesion"))


def check(body: standfast.answers.Body, situation: Situation) -> bool | None:
    """Whether the margins say rest, after comparing them with the sum of all loads; ``None`` at a limit, as without friction and
    horizontal force."""
    wrench = situation.wrench
    # A combination may divide the friction.
    others = (situation.to_dict().get("combination") or {}).get("numbers", {})
    friction = others.get("body.friction", body.friction)
    turning = wrench.m - wrench.x * body.centroid_height
    about = {"O": wrench.p * body.heel_distance - turning, "O'": wrench.p * body.toe_distance + turning}
    other = "O" if situation.heel == "O'" else "O'"
    force = body.weight + abs(wrench.x) + abs(wrench.p) + situation.buoyant_weight + abs(situation.U)
    moment = force * (body.width + body.height) + abs(situation.M_U) + abs(situation.M_p)
    assert abs(situation.margin_sliding - (friction * wrench.p - abs(wrench.x))) <= 1e-12 * force
    assert abs(situation.margin_overturning_heel - about[situation.heel]) <= 1e-12 * moment
    assert abs(situation.margin_overturning_toe - about[other]) <= 1e-12 * moment
    assert situation.margin_overturning == min(situation.margin_overturning_heel, situation.margin_overturning_toe)
    sizes = (situation.margin_sliding / force, situation.margin_overturning / moment)
    if min(map(abs, sizes)) <= 1e-12:
        return None
    return min(sizes) > 0


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_every_example(path: Path) -> None:
    found = standfast.assess(path)
    for situation in found.situations:
        if situation.mode == "BF" or is_held(situation):
            continue  # What the ground bears is not what the base asks of it.
        rests = check(found.body, situation)
        assert rests is None or rests == (situation.mode is Mode.REST or Mode.REST in situation.also.modes)


def test_the_signs_of_random_cases_decide_rest(tmp_path: Path) -> None:
    seen = {True: 0, False: 0, None: 0}
    for seed in range(600):
        file = tmp_path / "case.toml"
        file.write_text(random_case(seed), encoding="utf-8")
        try:
            found = standfast.assess(file)
        except ValueError:
            continue
        for situation in (one for one in found.situations if not is_held(one)):
            rests = check(found.body, situation)
            seen[rests] += 1
            ground = situation.ground
            if ground is not None and (ground.omega is not None or ground.resistance is not None):
                # A base that gives way bears less than the inequalities of a rigid one leave.
                assert rests is not False or situation.mode != "RE", seed
            elif rests is not None:
                assert rests == (situation.mode is Mode.REST or Mode.REST in situation.also.modes), seed
                if not situation.lifted:
                    assert (situation.margin_sliding > 0) == (situation.SF_sliding is not None and situation.SF_sliding > 1)
    assert min(seen[True], seen[False]) > 100 and seen[None] < 30, seen


def test_margins_go_on_where_factors_end() -> None:
    """From a push to the left to one to the right through none: factors are infinite there, margins are straight lines."""
    block = {"body": {"width": 1, "height": 2, "mass": 4800, "friction": 0.5}, "load": [{"force": 1, "elevation": 1}]}
    share = np.linspace(0, 0.2, 21)
    found = standfast.assess_table(block, {"load[1].force": share * 4800 * 9.81})
    assert math.isinf(found["SF_sliding"][0])
    steps = np.diff(found["margin_sliding"])
    assert steps == pytest.approx(steps[0], rel=1e-9) and found["margin_sliding"][0] == pytest.approx(0.5 * 4800 * 9.81)


def test_the_example_of_reliability() -> None:
    """Its FORM and Monte Carlo against a plain one in numpy, which knows of the caisson two curves of the wave height alone."""
    pytest.importorskip("openturns")
    sys.path.insert(0, str(ROOT / "python/examples"))
    try:
        limit_state = importlib.import_module("limit_state")
    finally:
        sys.path.pop(0)
    form, simulated = limit_state.main()

    heights = np.linspace(1, 12, 500)
    case = pytest.importorskip("tomllib").loads(limit_state.CASE.read_text(encoding="utf-8"))
    loads = []
    for height in heights:
        case["wave"]["deep_water_height"] = float(height)
        answer = standfast.assess(case)
        loads.append([answer.P, answer.U])
    weight = answer.buoyant_weight
    generator = np.random.default_rng(7)
    draws = 2_000_000
    spread = math.sqrt(math.log(1 + 0.1**2))
    friction = generator.lognormal(math.log(0.6) - spread**2 / 2, spread, draws)
    scale = 0.4 * math.sqrt(6) / math.pi
    height = generator.gumbel(3.2 - np.euler_gamma * scale, scale, draws)
    factor = generator.normal(0.95, 0.2, draws)
    assert heights[0] < height.min() and height.max() < heights[-1]
    force, uplift = (factor * np.interp(height, heights, curve) for curve in np.transpose(loads))
    expected = np.mean(friction * (weight - uplift) < force)

    assert 1e-3 < expected < 1e-1
    error = math.sqrt(expected / draws) + simulated.getStandardDeviation()
    assert abs(simulated.getProbabilityEstimate() - expected) < 4 * error
    # The limit is nearly a plane between the storms that are likely.
    assert form.getEventProbability() == pytest.approx(expected, rel=0.1)
    design = form.getPhysicalSpaceDesignPoint()
    assert abs(limit_state.margin([design])[0, 0]) < 1e-3
