"""Many motions at once: each is that of `simulate`, whatever the threads; what does not go together is refused by its place."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest

import standfast

STATUE: dict[str, Any] = {"body": {"width": 0.6, "length": 0.6, "height": 2.0, "density": 2600, "friction": 0.4}}
CAISSON: dict[str, Any] = {
    "body": {"width": 4, "height": 6, "mass": 120e3, "friction": 0.3},
    "added_mass": {"mass": 20e3, "elevation": 2},
    "water": {"level": 4, "density": 1000},
}


def shaking(seed: int, points: int = 600, dt: float = 0.02) -> np.ndarray[Any, np.dtype[np.float64]]:
    random = np.random.default_rng(seed)
    t = np.arange(points) * dt
    return sum((a * np.sin(w * t + p) for a, w, p in random.uniform((0.2, 2, 0), (1, 20, 6), (12, 3))), np.zeros(points))


def test_each_is_the_motion_of_simulate() -> None:
    base = np.stack([0.9 * shaking(seed) for seed in range(3)])
    vertical = np.stack([0.4 * shaking(seed + 50) for seed in range(3)])
    heights, frictions = [1.6, 2.0, 2.4, 2.8], [0.3, 0.35, 0.5, 0.9]
    for case, vary in ((STATUE, {"height": heights, "friction": frictions}), (CAISSON, {"friction": frictions})):
        table = standfast.motions(
            case, base=base, vertical=vertical, dt=0.02, unit="m/s2", vary=vary, cross=True, divergence=True, threads=2
        )
        assert table.record.to_pylist() == [0] * 4 + [1] * 4 + [2] * 4 and table.body.to_pylist() == [0, 1, 2, 3] * 3
        moved = 0
        for row in range(12):
            record, body = divmod(row, 4)
            own = {**case, "body": {**case["body"], **{name: values[body] for name, values in vary.items()}}}
            one = standfast.simulate(own, base={"horizontal": base[record], "vertical": vertical[record]}, dt=0.02, unit="m/s2", strength=False)
            for name in ("slide", "max_slide", "max_theta", "max_theta_of_balance", "friction_loss", "impact_loss", "impacts", "overturned", "at_rest", "end"):
                assert table[name].to_pylist()[row] == getattr(one, name), (row, name)
            assert table.t_rest.to_pylist()[row] == one.t_rest and table.divergence.to_pylist()[row] == one.divergence.value
            assert all(table[name].to_pylist()[row] == values[body] for name, values in vary.items())
            moved += one.max_slide + one.max_theta > 0
        assert moved > 6


def test_the_table_hangs_on_no_number_of_threads() -> None:
    base = [shaking(seed, points) for seed, points in ((1, 300), (2, 450), (3, 600))]
    asked: dict[str, Any] = dict(base=base, dt=[0.02, 0.01, 0.02], unit="m/s2", copies=5, spread={"friction": 0.1}, strength=True)
    found = [standfast.motions(STATUE, **asked, threads=threads) for threads in (1, 2, 7)]
    tables = [{name: table[name].to_pylist() for name in table.column_names} for table in found]
    assert tables[0] == tables[1] == tables[2]
    assert {"onset", "stronger", "weaker", "overturned_share", "overturned_share_high"} <= set(tables[0])
    for record in range(3):
        one = standfast.simulate(STATUE, base=base[record], dt=asked["dt"][record], unit="m/s2", copies=5, spread={"friction": 0.1}, strength=True)
        assert one.copies is not None and one.strength is not None
        assert tables[0]["overturned_share_high"][record] == one.copies.share.high and tables[0]["onset"][record] == one.strength.onset


def test_records_and_bodies_go_together_one_by_one() -> None:
    base = np.stack([shaking(seed) for seed in range(3)])
    both = standfast.motions(STATUE, base=base, dt=0.02, unit="m/s2", vary={"height": [1.5, 2.0, 2.5]})
    assert both.record.to_pylist() == both.body.to_pylist() == [0, 1, 2]
    crossed = standfast.motions(STATUE, base=base, dt=0.02, unit="m/s2", vary={"height": [1.5, 2.0, 2.5]}, cross=True)
    assert [crossed.max_theta.to_pylist()[4 * i] for i in range(3)] == both.max_theta.to_pylist()
    single = standfast.motions(STATUE, base=base[1], dt=0.02, unit="m/s2", vary={"height": [1.5, 2.0], "friction": 0.4})
    assert single.max_theta.to_pylist() == crossed.max_theta.to_pylist()[3:5] and single.friction.to_pylist() == [0.4, 0.4]
    centimetres = standfast.motions(STATUE, base=100 * base[1], dt=0.02, unit="cm/s2", vary={"height [cm]": [200]})
    assert centimetres.max_theta.to_pylist()[0] == pytest.approx(single.max_theta.to_pylist()[1], rel=1e-9)
    block = {"block": {"b1": 1, "b2": 1, "d": 3, "mu_s": 0.6, "gravity": 1}, "criteria": {"slide": 0.5}}
    pure = standfast.motions(block, base=0.1 * shaking(4), dt=0.1, vary={"block.mu_s": [0.2, 0.6]})
    assert len(pure) == 2 and pure.met.to_pylist() == [True, True] and pure.slide.metadata.get("unit") is None


def test_what_does_not_go_together_is_refused() -> None:
    good = np.stack([shaking(seed) for seed in range(3)])
    bad = good.copy()
    bad[2, 17] = np.nan
    asked: dict[str, Any] = dict(dt=0.02, unit="m/s2")
    for given, words in (
        (dict(base=bad), "record 2: value 17 is nan"),
        (dict(base=good, vary={"height": [1.0, 2.0]}), "3 records and 2 bodies"),
        (dict(base=good, vary={"height": [1.0, 2.0], "friction": [0.1, 0.2, 0.3]}), "different lengths: height 2, friction 3"),
        (dict(base=good, vary={"height": [1.0, -2.0]}, cross=True), "body 1: .*height"),
        (dict(base=good, vary={"heigth": 1.0}), "heigth"),
        (dict(base=good, vertical=good[:2]), "vertical"),
        (dict(base=good, dt=[0.02, 0.02]), "2 steps, and there are 3 records"),
        (dict(base=good, dt=0), "dt"),
        (dict(base=good, unit="ft/s2"), "unit"),
        (dict(base=[[0.1]]), "record 0"),
        (dict(base=good, seed=3), "seed is of copies"),
        (dict(base=good, threads=0), "threads"),
        (dict(base=good[None]), "3 axes"),
        (dict(base=good, vary={"motion.base.horizontal.factor": 2.0}), "motion.base.horizontal.factor"),
        (dict(base=np.ma.masked_greater(good, 1.0)), "masked"),
        (dict(base=pd.Series(good[0], index=np.arange(good.shape[1]) * 0.01)), "record 0 has times of its own"),
    ):
        with pytest.raises(standfast.StandfastError, match=words):
            standfast.motions(STATUE, **{**asked, **given})
    for given in (dict(base=pd.DataFrame(good)), dict(base="a.csv"), dict(base=3.0), dict(base=[["a", "b"]]), dict(base=good, cross=1)):
        with pytest.raises(TypeError):
            standfast.motions(STATUE, **{**asked, **given})
    block = {"block": {"b1": 1, "b2": 1, "d": 3, "mu_s": 0.6, "gravity": 1}}
    with pytest.raises(standfast.StandfastError, match="unit"):
        standfast.motions(block, base=good, dt=0.1, unit="g")
    with pytest.raises(standfast.StandfastError, match="unit is missing"):
        standfast.motions(STATUE, base=good, dt=0.1)


def test_a_call_can_be_watched_and_interrupted() -> None:
    base = np.stack([shaking(seed, 3000) for seed in range(64)])
    seen: list[int] = []

    def tell(done: int, total: int | None) -> None:
        assert total == 1000
        seen.append(done)

    standfast.motions(STATUE, base=base, dt=0.02, unit="m/s2", vary={"height": np.linspace(1, 3, 64)}, progress=tell)
    assert seen and seen[-1] == 1000

    def stop(done: int, total: int | None) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        standfast.motions(STATUE, base=base, dt=0.02, unit="m/s2", vary={"height": np.linspace(1, 3, 200)}, cross=True, progress=stop)


def test_a_case_of_a_file_needs_no_record_of_its_own(tmp_path: Path) -> None:
    (tmp_path / "case.toml").write_text(
        '[body]\nwidth = 0.6\nheight = 2\ndensity = 2600\nfriction = 0.4\n[motion.base]\nhorizontal = { shape = "file", file = "missing.csv" }\n'
        "[criteria]\noverturned = false\n",
        encoding="utf-8",
    )
    table = standfast.motions(tmp_path / "case.toml", base=[shaking(1), shaking(2)], dt=0.02, unit="m/s2")
    assert table.column_names[-1] == "end" and "met" in table.column_names


def test_a_table_at_rest_says_what_follows_motions(tmp_path: Path) -> None:
    record = tmp_path / "record.csv"
    record.write_text("t_s,a_g\n0,0\n0.1,0.4\n0.2,0\n")
    case = tmp_path / "case.toml"
    case.write_text('[body]\nwidth = 0.6\nheight = 2\nlength = 0.6\ndensity = 2600\nfriction = 0.4\n[motion.base]\nhorizontal = { file = "record.csv" }\n')
    with pytest.raises(standfast.StandfastError, match="the case is one in time") as raised:
        standfast.assess_table(case, {"friction": [0.3, 0.4]})
    assert "standfast.motions" in str(raised.value)
