"""A force to the right: the mirror image, in every kind of operands."""

from __future__ import annotations

import numpy as np
import pandas as pd
import polars as pl
import pyarrow as pa
import pytest
import standfast
from reference import points
from standfast import Mode, Modes

IMAGES = {
    "RE": "RE", "SL": "SL+", "RO": "RO'", "SRO-": "SRO'+", "SRO+": "SRO'-", "SRO'-": "SRO+", "RO'": "RO", "SL+": "SL",
    "SRO'+": "SRO-", "FL": "FL",
}  # fmt: skip
POINTS = np.array([*points(2000, 7), (1, -0.5, 4, 3)]).T


def test_modes_are_mirror_images() -> None:
    left, right = (standfast.classify(*POINTS, names=True, to=to) for to in ("left", "right"))
    assert [IMAGES[symbol] for symbol in left] == right.tolist() and len(set(right)) == 7
    codes = standfast.classify(*POINTS, to="right")
    assert standfast.symbols(codes).tolist() == right.tolist()
    assert standfast.classify(1, 0.4, 0.7, 0.6, to="right") is Mode.SLIDE_RIGHT
    out = np.empty(POINTS.shape[1], dtype=np.uint8)
    standfast.classify(*POINTS, out=out, to="right", threads=2)
    assert np.array_equal(out, codes)


def test_motions_are_mirror_images() -> None:
    left, right = (standfast.onset(*POINTS, to=to) for to in ("left", "right"))
    for name in ("x_ddot", "theta_ddot", "f_x", "xi", "slip"):
        assert np.array_equal(getattr(right, name), -getattr(left, name)), name
    for name in ("y_ddot", "f_y", "unique"):
        assert np.array_equal(getattr(right, name), getattr(left, name)), name
    assert np.array_equal(right.lift_o, left.lift_o_prime) and np.array_equal(right.lift_o_prime, left.lift_o)
    assert np.array_equal(right.mode, standfast.classify(*POINTS, to="right"))
    assert not right.unique[-1] and Modes(right.others[-1]) == Modes.ROCK_O_PRIME
    assert np.array_equal(standfast.onset(*POINTS, columns=["lift_o"], to="right").lift_o, left.lift_o_prime)


def test_the_laws_of_motion_hold_to_the_right() -> None:
    gamma, k_prime, k, _ = POINTS
    found = standfast.onset(*POINTS, to="right")
    scale = 1 + k + gamma + abs(found.f_x) + abs(found.f_y)
    assert (abs(found.f_x + k - found.x_ddot) < 1e-12 * scale).all()
    moment = gamma * found.f_x + found.xi * found.f_y - gamma * k * k_prime
    assert (abs(moment - (1 + gamma**2) / 3 * found.theta_ddot) < 1e-10 * scale**2).all()


def test_in_every_kind_of_column() -> None:
    frame = {"k": [0.7, 0.1, None], "mu": [0.6, 0.6, 0.6], "gamma": [1.0] * 3, "k_prime": [0.4] * 3}
    expected = ["SL+", "RE", None]
    polars = pl.DataFrame(frame)
    assert standfast.classify(polars, names=True, to="right").to_list() == expected
    assert standfast.classify(pa.table(frame), names=True, to="right").to_pylist() == expected
    found = standfast.classify(pd.DataFrame(frame, index=[3, 4, 5]), names=True, to="right")
    assert found[:2].tolist() == expected[:2] and found.isna().tolist() == [False, False, True]
    assert standfast.onset(polars, columns=["mode", "slip"], to="right")["slip"].round(9).to_list() == [0.1, 0.0, None]


def test_left_or_right_only() -> None:
    with pytest.raises(ValueError, match="to is 'both'; expected 'left' or 'right'"):
        standfast.onset(1, 1, 1, 1, to="both")  # type: ignore[arg-type]
