"""Stacks of bodies: against one body, against the laws of motion, against closed forms of two; and what is refused."""

from __future__ import annotations

import math
from random import Random

import pytest
import standfast
from standfast import Mode

CUBE = {"m_x": 1, "I": 1 / 6}


def joint(h: float, mu: float, **more: float) -> dict[str, float]:
    return {"h": h, "l": -0.5, "r": 0.5, "mu_s": mu, **more}


def two(mu: tuple[float, float], **more: float) -> standfast.Stack:
    """Two cubes of side 1."""
    return standfast.stack([CUBE | {"y": 0.5}, CUBE | {"y": 1.5}], [joint(0, mu[0]), joint(1, mu[1])], gravity=1, **more)


def test_one_body_is_the_contact_problem() -> None:
    random = Random(31)
    for _ in range(300):
        b1, b2, d, inertia, m_x, m_y = (random.uniform(0.2, 2) for _ in range(6))
        x, p, m = (random.uniform(-1, 1) for _ in range(3))
        mu_k = random.uniform(0, 1)
        mu_s = mu_k * random.choice([1, 1.3])
        body = {"m_x": m_x, "m_y": m_y, "I": inertia, "x": 0.25, "y": d, "dX": x, "dP": p, "dM": m}
        found = standfast.stack([body], [{"h": 0, "l": 0.25 - b1, "r": 0.25 + b2, "mu_s": mu_s, "mu_k": mu_k}])
        one = standfast.contact(b1, b2, d, inertia, m_x, m_y, x, p, m, mu_s, mu_k)
        assert found.modes == [one.mode] and {*found.modes, *(also[0] for also in found.also_modes)} == set(one.modes.modes)
        motion, moves = found.bodies, found.joints
        assert motion is not None and moves is not None
        for value, expected in [
            (motion[0].x_ddot, one.x_ddot), (motion[0].y_ddot, one.y_ddot), (motion[0].theta_ddot, one.theta_ddot),
            (moves[0].f, one.f_x), (moves[0].N, one.f_y), (moves[0].t, one.slip),
        ]:  # fmt: skip
            assert value == pytest.approx(expected, abs=1e-12, rel=1e-9)


def test_two_cubes_on_a_shaken_base() -> None:
    # A slipping base protects what stands on it: at any acceleration.
    answer = two((0.3, 0.3), horizontal=2)
    assert (answer.modes, answer.unique, answer.departure_joints) == (["SL", "RE"], True, [1, 2])
    assert answer["modes"] == ["SL", "RE"] and answer.modes == [Mode.SLIDE_LEFT, Mode.REST]
    assert answer.load_factor == pytest.approx(0.15, rel=1e-15)
    bodies = answer.bodies
    assert bodies is not None and [body.x_ddot for body in bodies] == pytest.approx([-1.7 + 0, -1.7]), bodies
    # The upper alone: k > μ₂ and k m₁ + μ₂ m₂ ≤ μ₁ m.
    answer = two((0.45, 0.2), horizontal=0.6)
    assert answer.modes == ["RE", "SL"] and answer.departure == "at"
    assert answer.load_factor == pytest.approx(1 / 3)
    assert "joint 2 reaches its limit: RE/SL" in str(answer)


def test_the_permanent_acceleration_is_there_at_once() -> None:
    answer = two((0.3, 0.5), horizontal=0.4, permanent=True)
    assert (answer.departure, answer.load_factor, answer.departure_joints) == ("at-once", 0, [1])
    assert answer.departure_modes == answer.modes == ["SL", "RE"]
    still = two((0.3, 0.5))
    assert (still.departure, still.load_factor, still.departure_joints, still.departure_modes) == ("never", math.inf, [], None)
    assert still.modes == ["RE", "RE"] and '"load_factor": "infinite"' in still.to_json()


def test_three_answers_are_all_listed() -> None:
    # Of the specification: pushes near sliding at the foot of the lower of two cubes, friction 1.
    pushed = [CUBE | {"y": 0.5, "X": -1.02, "M": -1.0025}, CUBE | {"y": 1.5, "X": -1.04}]
    answer = standfast.stack(pushed, [joint(0, 1), joint(1, 1)], gravity=1)
    assert answer.modes == ["SL", "SL"] and answer.unique is False
    assert sorted("/".join(mode.symbol for mode in modes) for modes in answer.also_modes) == ["RO/RE", "SRO-/SL"]
    assert "not unique" in str(answer) and "As consistent: " in str(answer)


def test_more_bodies_than_are_enumerated_have_a_departure() -> None:
    bodies = [CUBE | {"y": i + 0.5} for i in range(7)]
    answer = standfast.stack(bodies, [joint(i, 0.5) for i in range(7)], gravity=9.81, horizontal=0.3)
    assert answer.modes is None and answer.joints is None and answer.unique is None
    assert answer.no_modes is not None and "7 bodies" in answer.no_modes
    assert answer.load_factor == pytest.approx(1 / 7 / 0.3) and answer.departure_joints == [1]


@pytest.mark.parametrize(
    ("bodies", "joints", "words"),
    [
        ([CUBE], [joint(0, 1)], "body 1 has no y; expected m_x, I, y at least"),
        ([CUBE | {"y": 1, "Y": 2}], [joint(0, 1)], "body 1 has no 'Y'; did you mean 'y'"),
        ([CUBE | {"y": 1}], [], "bodies: 1, joints: 0"),
        ([CUBE | {"y": 1, "m_x": -1}], [joint(0, 1)], "body 1: inertia m_x is -1"),
        ([CUBE | {"y": 1}], [joint(0, 1, mu_k=2)], "joint 1: static friction mu_s is 1; expected no less than the kinetic"),
        ([CUBE | {"y": 1}], [joint(0, 1, r=-1)], "joint 1: right end r of the joint is -1; expected one beyond the left end"),
        ([CUBE | {"y": math.nan}], [joint(0, 1)], "body 1: height of the centre of mass is NaN"),
    ],
)
def test_what_is_no_stack_is_refused(bodies: list[dict[str, float]], joints: list[dict[str, float]], words: str) -> None:
    with pytest.raises(standfast.StandfastError, match=words.replace("'", ".")):
        standfast.stack(bodies, joints)


def test_what_is_no_number_is_a_type_error() -> None:
    with pytest.raises(TypeError, match="y of body 1 is '1 m', a str; expected a number"):
        standfast.stack([CUBE | {"y": "1 m"}], [joint(0, 1)])  # type: ignore[dict-item]
    with pytest.raises(TypeError, match="body 1 is 3, an int; expected a dict with m_x"):
        standfast.stack([3], [joint(0, 1)])  # type: ignore[list-item]
    with pytest.raises(TypeError, match="permanent is 'no', a str; expected True or False"):
        standfast.stack([CUBE | {"y": 1}], [joint(0, 1)], permanent="no")  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="bodies is None"):
        standfast.stack(None, [joint(0, 1)])  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="m_x of body 1 is 1000.*, an int; expected a number"):
        standfast.stack([CUBE | {"y": 1, "m_x": 10**400}], [joint(0, 1)])
    with pytest.raises(TypeError, match="gravity is True, a bool"):
        standfast.stack([CUBE | {"y": 1}], [joint(0, 1)], gravity=True)
