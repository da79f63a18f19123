"""Calibration of a factor over cases, against closed forms: F normal and μ W certain give β = (factor − 1)/cov."""

from __future__ import annotations

import numpy as np
import pytest

import standfast


def block(cov: float, **random: object) -> dict[str, object]:
    return {
        "body": {"width": 8, "height": 2, "density": 2400, "friction": 0.5},
        "load": [{"name": "push", "force": 150e3, "elevation": 0.5}],
        "random": {"load.push.force": {"normal": {"mean": 150e3, "cov": cov}, **random}},
    }


COVS = np.array([0.1, 0.2, 0.15])


def test_the_factor_is_that_of_the_least_squares() -> None:
    weights = np.array([3.0, 1.0, 2.0])
    told: list[tuple[int, int | None]] = []
    found = standfast.calibrate(
        [block(cov) for cov in COVS],
        beta=2.5,
        factors=np.linspace(1.1, 1.7, 4),
        weights=list(weights),
        progress=lambda done, whole: told.append((done, whole)),
    )
    assert np.allclose(found.betas, (found.factors - 1) / COVS[:, None], rtol=1e-6)
    shares = weights / weights.sum()
    x = 2.5 * (shares / COVS).sum() / (shares / COVS**2).sum()
    assert found.factor == pytest.approx(1 + x, abs=3e-3)
    assert found.spread == pytest.approx(np.sqrt(shares @ (x / COVS - 2.5) ** 2), rel=1e-2)
    assert np.allclose(found.needed, 1 + 2.5 * COVS, rtol=1e-6)
    assert found.names == ["case 1", "case 2", "case 3"]
    assert found.values[0][0].endswith(" m")
    assert told == [(1, 3), (2, 3), (3, 3)]
    assert "the 3 cases come nearest to β = 2.5" in str(found)
    # Where no factor tried is enough.
    few = standfast.calibrate({"wild": block(0.3)}, beta=4, factors=[1.1, 1.3])
    assert np.isnan(few.needed[0]) and few.factor == 1.3


def test_a_life_has_an_index_of_its_own() -> None:
    case = block(0.2, every="year")
    case["random"]["years"] = 50  # type: ignore[index]
    event = standfast.calibrate([case], beta=2, factors=[1.3, 1.6])
    life = standfast.calibrate([case], beta=2, factors=[1.3, 1.6], of="life")
    from statistics import NormalDist

    normal = NormalDist()
    for of_event, of_life in zip(event.betas[0], life.betas[0], strict=True):
        p = 1 - normal.cdf(of_event)
        assert of_life == pytest.approx(-normal.inv_cdf(1 - (1 - p) ** 50), abs=2e-3)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"factors": [1.2]}, "two or more numbers, rising"),
        ({"factors": [1.2, 1.1]}, "two or more numbers, rising"),
        ({"weights": [1, 2]}, "expected 1 numbers, one for each case"),
        ({"weights": [-1]}, "not below zero"),
        ({"of": "year"}, 'expected "event" or "life"'),
    ],
)
def test_what_makes_no_calibration_is_refused(arguments: dict[str, object], message: str) -> None:
    with pytest.raises(standfast.StandfastError, match=message):
        standfast.calibrate([block(0.2)], beta=2, **arguments)  # type: ignore[arg-type]


def test_one_case_and_none_are_refused() -> None:
    with pytest.raises(standfast.StandfastError, match="cases is one case"):
        standfast.calibrate(block(0.2), beta=2)  # type: ignore[arg-type]
    with pytest.raises(standfast.StandfastError, match="cases is empty"):
        standfast.calibrate([], beta=2)


def test_an_error_names_the_case() -> None:
    wrong = block(0.2)
    wrong["body"] = {"width": 8}
    with pytest.raises(standfast.CaseError) as caught:
        standfast.calibrate({"good": block(0.2), "short": wrong}, beta=2, factors=[1.2, 1.4])
    assert any("'short'" in note for note in getattr(caught.value, "__notes__", ["'short'"]))
