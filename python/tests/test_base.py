"""A base that crushes and ground that fails: omega beside numbers, arrays, columns and tables; diagrams; explanations."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

import standfast as sf
from test_schema import errors

POINT = (0.8, 0.9167, 0.61, 0.6)


def test_omega_changes_the_mode_and_zero_does_not() -> None:
    assert sf.classify(*POINT) is sf.classify(*POINT, omega=0) is sf.Mode.SLIDE_LEFT
    assert sf.classify(*POINT, omega=0.08) is sf.Mode.ROCK_O
    assert sf.classify(*POINT, omega=0.08, to="right") is sf.Mode.ROCK_O_PRIME
    failed = sf.classify(*POINT, omega=1)
    assert failed is sf.Mode.BEARING_FAILURE and failed.symbol == "BF" and failed == 10 == sf.Mode("BF")
    assert sf.classify(*POINT, omega=[0, 0.08, 1.0], names=True).tolist() == ["SL", "RO", "BF"]
    assert sf.symbols([2, 10]).tolist() == ["RO", "BF"]


def test_onset_turns_about_the_neutral_point() -> None:
    begun = sf.onset(*POINT, omega=0.08)
    # N = (1+α)/(1+2ωα), and the reaction acts in the middle of 2ωN.
    α = begun.theta_ddot
    normal = (1 + α) / (1 + 2 * 0.08 * α)
    assert begun.f_y == pytest.approx(normal, rel=1e-14) and begun.xi == pytest.approx(-(1 - 0.08 * normal), rel=1e-14)
    right = sf.onset(*POINT, omega=0.08, to="right")
    assert (right.theta_ddot, right.xi) == (-begun.theta_ddot, -begun.xi)
    failed = sf.onset(*POINT, omega=[1.0, 0.08])
    assert np.isnan(failed.theta_ddot[0]) and failed.theta_ddot[1] == α and failed.mode.tolist() == [10, 2]


def test_arrays_broadcast_and_agree_with_scalars() -> None:
    rng = np.random.default_rng(5)
    gamma, k_prime, k, mu = rng.uniform(0.3, 4, 300), rng.uniform(-1.8, 1.5, 300), rng.uniform(0, 4, 300), rng.uniform(0, 3, 300)
    omega = rng.uniform(0, 1.1, (2, 1))
    codes = sf.classify(gamma, k_prime, k, mu, omega=omega, threads=2)
    assert codes.shape == (2, 300)
    for i, j in [(0, 3), (1, 7), (0, 299), (1, 150)]:
        assert codes[i, j] == sf.classify(gamma[j], k_prime[j], k[j], mu[j], omega=omega[i, 0])
    assert (sf.onset(gamma, k_prime, k, mu, omega=omega, columns=["mode"]).mode == codes).all()
    assert (sf.classify(gamma, k_prime, k, mu, omega=np.zeros(300)) == sf.classify(gamma, k_prime, k, mu)).all()


def test_tables_have_a_column_of_that_name() -> None:
    pd = pytest.importorskip("pandas")
    pl = pytest.importorskip("polars")
    pa = pytest.importorskip("pyarrow")
    table = {"gamma": [0.8, 0.8], "k_prime": [0.9167, 0.9167], "k": [0.61, 0.61], "mu": [0.6, 0.6], "omega": [0.0, 0.08]}
    for frame in (pd.DataFrame(table), pl.DataFrame(table), pa.table(table)):
        assert list(map(str, sf.classify(frame, names=True).to_numpy(zero_copy_only=False) if isinstance(frame, pa.Table) else sf.classify(frame, names=True))) == ["SL", "RO"]
    rigid = pd.DataFrame(table).drop(columns="omega")
    assert sf.classify(rigid, names=True).tolist() == ["SL", "SL"]
    assert sf.classify(rigid, omega=0.08, names=True).tolist() == ["RO", "RO"]
    named = pd.DataFrame(table).rename(columns={"omega": "share"})
    assert sf.classify(named, map={"omega": "share"}, names=True).tolist() == ["SL", "RO"]
    # A missing ω leaves the answer out.
    gaps = pd.DataFrame(table | {"omega": [np.nan, 0.08]})
    assert sf.classify(gaps, names=True).isna().tolist() == [True, False]
    with pytest.raises(TypeError, match=r"omega is \[0, 1\], a list beside a table; expected a number, or a column of it"):
        sf.classify(rigid, omega=[0, 1])


@pytest.mark.parametrize(("omega", "said"), [(-0.1, "-0.1"), (math.nan, "NaN"), (math.inf, "inf")])
def test_impossible_shares_are_shown(omega: float, said: str) -> None:
    with pytest.raises(ValueError, match=rf"share ω of the base is {said} at index 1; expected a number from 0 to 1e50"):
        sf.classify(*POINT, omega=[0.1, omega])
    assert np.ma.getmaskarray(sf.classify(*POINT, omega=[0.1, omega], on_error="null")).tolist() == [False, True]


def test_bearing_failure_is_in_no_set() -> None:
    with pytest.raises(ValueError, match="bearing failure is in no set of modes"):
        sf.Modes(sf.Mode.BEARING_FAILURE)
    assert sf.Mode.BEARING_FAILURE not in sf.Modes(1023).modes


def test_explain_says_where_the_base_bears() -> None:
    why = sf.explain(*POINT, omega=0.08)
    assert why.mode is sf.Mode.ROCK_O and why.case is None
    begun = sf.onset(*POINT, omega=0.08)
    assert why.ground is not None and why.ground["omega"] == 0.08
    assert [why.ground["pivot"], why.ground["neutral"]] == pytest.approx([0.08 * begun.f_y, 2 * 0.08 * begun.f_y])
    resting = sf.explain(0.8, 0.9167, 0.3, 0.6, omega=0.08).ground
    assert resting is not None and resting["pivot"] == 0.08
    assert not errors(json.loads(why.to_json()), "point.schema.json")
    failed = sf.explain(*POINT, omega=1.2)
    assert failed.mode is sf.Mode.BEARING_FAILURE and failed.motion is None and failed.trace == []
    assert not errors(json.loads(failed.to_json()), "point.schema.json")
    assert sf.explain(*POINT).ground is None and sf.explain(*POINT, omega=0).to_json() == sf.explain(*POINT).to_json()


def test_diagrams_of_a_base_that_gives_way() -> None:
    diagram = sf.Diagram(3, 0.8, omega=0.1)
    assert repr(diagram) == "Diagram(gamma=3, k_prime=0.8, omega=0.1)" and diagram.omega == 0.1
    # A, C and D move inwards by 1 − ω.
    rigid = sf.Diagram(3, 0.8)
    for name in "ACD":
        assert diagram.points[name].k == pytest.approx(0.9 * rigid.points[name].k, abs=1e-15)
    (curve,) = (curve for curve in diagram.curves if curve.name == "mu*")
    k, mu = np.concatenate(curve.parts).T[:, 3:-3]
    assert (diagram.mode_at(k, mu + 1e-9) == sf.Mode.ROCK_O).all()
    k, mu = k[mu > 1e-6], mu[mu > 1e-6]
    assert np.isin(diagram.mode_at(k, mu - 1e-9), [sf.Mode.SLIDE_ROCK_O_LEFT, sf.Mode.SLIDE_ROCK_O_RIGHT]).all()
    soil = sf.Diagram(0.7, 0.4, law="ec7", share=0.3)
    assert [region.mode.symbol for region in soil.regions] == ["RE", "SL", "BF"]
    corner = soil.points["k_BF"].k
    assert soil.mode_at([0.999 * corner, 1.001 * corner], 1.0).tolist() == [0, 10]
    assert "<svg" in soil.svg({"storm": (0.1, 0.5)})
    for wrong in ({"omega": 1.1}, {"omega": -0.1}, {"law": "terzaghi", "share": 0.1}, {"law": "ec7", "share": 0.0}):
        with pytest.raises(ValueError, match="expected"):
            sf.Diagram(1, 0.4, **wrong)
    for both in ({"law": "ec7"}, {"share": 0.2}, {"law": "ec7", "share": 0.2, "omega": 0.1}):
        with pytest.raises(TypeError, match="expected"):
            sf.Diagram(1, 0.4, **both)
