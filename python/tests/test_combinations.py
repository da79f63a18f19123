"""Combinations as checks of a code: typed attributes, None where a combination says nothing."""

from __future__ import annotations

import pytest
import standfast

CASE = {
    "body": {"width": "4 m", "height": "6 m", "density": "2.4 t/m3", "friction": 0.6},
    "pressure": [{"name": "sand", "face": "right", "elevation": [0, 6], "pressure": ["30 kPa", 0], "permanent": True}],
    "load": [{"name": "bollard", "force": "20 kN/m", "elevation": "6 m"}],
    "combination": [
        {"name": "plain", "factors": {"bollard": 1}},
        {
            "name": "DA1",
            "set": {"load.bollard.force": "25 kN/m"},
            "scale": {"body.width": 0.9},
            "materials": {"body.friction": 1.25},
            "resist": {"sliding": 1.1},
            "factors": {"weight": [1.35, 1], "sand": 1.35, "bollard": 1.5},
            "criteria": {"SF_sliding": 1.0},
        },
    ],
    "criteria": {"SF_sliding": 1.5},
}


def test_what_a_combination_says_has_types() -> None:
    plain, check = (situation.combination for situation in standfast.assess(CASE).situations)
    assert plain is not None and check is not None
    assert (plain.set, plain.scale, plain.materials, plain.resist, plain.tried, plain.wave) == (None,) * 6
    assert check.set == {"load.bollard.force": "25 kN/m"} and check.scale == {"body.width": 0.9}
    assert check.materials == {"body.friction": 1.25} and check.resist == {"sliding": 1.1}
    assert check.factors["weight"] == [1.35, 1.0] and check.factors_used == {"weight": 1.0}
    assert check.tried is not None and [way.factors for way in check.tried] == [{"weight": 1.35}]
    assert check.numbers == pytest.approx({"body.width": 3.6, "body.friction": 0.6 / 1.25 / 1.1, "load[1].force": 25e3})


def test_a_check_is_that_by_hand() -> None:
    check = standfast.assess(CASE).situations[1]
    weight, push = 3.6 * 6 * 2400 * 9.81, 1.35 * 90e3 + 1.5 * 25e3
    assert check.SF_sliding == pytest.approx(0.6 / 1.25 / 1.1 * weight / push)
    assert [criterion.required for criterion in check.criteria] == [1.0]


@pytest.mark.filterwarnings("ignore")
def test_probability_refuses_partial_factors() -> None:
    with pytest.raises(standfast.CaseError, match="a factor is a pair, of which a probability tries none"):
        standfast.probability({**CASE, "random": {"friction": {"normal": {"mean": 0.6, "sd": 0.1}}}})
