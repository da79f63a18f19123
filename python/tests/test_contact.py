"""The general contact problem against the program's tables, the report's problem, and the laws of motion."""

from __future__ import annotations

import csv
import subprocess
from pathlib import Path
from random import Random

import numpy as np
import pandas as pd
import polars as pl
import pytest
import standfast
from reference import points
from standfast import Mode, Modes, _contact

NAMES = ("b1", "b2", "d", "rho2", "m_x", "m_y", "x", "p", "m", "mu_s", "mu_k")
BLOCK = dict(b1=1, b2=1, d=1, rho2=2 / 3, m_x=1, m_y=1, x=-0.5, p=1, m=0.2, mu_s=0.6, mu_k=0.6)


def problems(count: int) -> dict[str, np.ndarray]:
    """Random problems, a third of eighths, which meet boundaries."""
    random = Random(8)
    rows = []
    for i in range(count):
        step = 8.0 if i % 3 == 0 else 0
        number = lambda low, high: round(random.uniform(low, high) * step) / step if step else random.uniform(low, high)  # noqa: E731
        mu_k = number(0, 2)
        row = [number(0.2, 2) + 0.125 for _ in range(6)] + [number(-2, 2), number(-0.3, 2), number(-2, 2)]
        rows.append([*row, mu_k + random.choice([0, 0, number(0, 1)]), mu_k])
    return dict(zip(NAMES, np.array(rows).T))


def test_the_program_answers_the_same(program: list[str], tmp_path: Path) -> None:
    given = problems(3000)
    table = tmp_path / "problems.csv"
    pd.DataFrame(given).to_csv(table, index=False)
    arguments = ["batch", table, "--problem", "wrench", "-o", tmp_path / "answers.csv"]
    subprocess.run([*program, *arguments], check=True, capture_output=True)
    with (tmp_path / "answers.csv").open(encoding="utf-8") as file:
        answers = list(csv.DictReader(file))
    found = standfast.contact(**given)
    assert isinstance(found, standfast.ContactArrays) and len(answers) == 3000
    assert standfast.symbols(found.mode).tolist() == [answer["mode"] for answer in answers]
    assert len(np.unique(found.mode)) == 10
    modes = [" ".join(mode.symbol for mode in Modes(bits).modes) for bits in found.modes]
    assert modes == [answer["modes"] for answer in answers]
    for name in ("x_ddot", "y_ddot", "theta_ddot", "f_x", "f_y", "xi"):
        assert getattr(found, name).tolist() == [float(answer[name]) for answer in answers], name


def test_the_laws_of_motion() -> None:
    given = problems(3000)
    found = standfast.contact(**given)
    b1, b2, d, rho2, m_x, m_y, x, p, m = (given[name] for name in NAMES[:9])
    scale = 1e-9 * (1 + abs(found.f_x) + abs(found.f_y) + abs(found.theta_ddot)) * (1 + given["mu_k"])
    assert (abs(m_x * found.x_ddot - x - found.f_x) < scale).all()
    assert (abs(m_y * found.y_ddot - found.f_y + p) < scale).all()
    assert (abs(rho2 * found.theta_ddot - m - found.f_x * d - found.f_y * found.xi) < scale).all()
    assert (abs(found.slip - found.x_ddot - d * found.theta_ddot) < scale).all()
    assert (abs(found.lift_o - found.y_ddot + b1 * found.theta_ddot) < scale).all()
    assert (abs(found.lift_o_prime - found.y_ddot - b2 * found.theta_ddot) < scale).all()
    assert (found.f_y > -scale).all() and (found.lift_o > -scale).all() and (found.lift_o_prime > -scale).all()


def test_the_reports_problem_is_one_of_these() -> None:
    gamma, k_prime, k, mu = np.array(points(3000, 9)).T
    regular = (k_prime < -1.001) | (k_prime > 0.001)
    gamma, k_prime, k, mu = (column[regular] for column in (gamma, k_prime, k, mu))
    # All inertia trebled, so that ρ² = 1 + γ² where m is 3, which modes do not see.
    modes = standfast.contact(1, 1, gamma, 1 + gamma**2, 3, 3, -k, 1, k * k_prime * gamma, mu, mu, columns=["mode"]).mode
    expected = standfast.classify(gamma, k_prime, k, mu)
    # Products are rounded here, so that a point on a boundary may fall to either side.
    states = standfast.limit_states(gamma, k_prime, k, mu)
    clear = np.min(np.abs(np.stack(states[:8])), axis=0) > 1e-9
    assert clear.sum() > 1500 and np.array_equal(modes[clear], expected[clear])


def test_one_problem() -> None:
    found = standfast.contact(**BLOCK)
    assert isinstance(found, standfast.Contact)
    assert (found.mode, found.modes) == (Mode.REST, Modes.REST)
    assert found.f_x == 0.5 and type(found.f_x) is float
    conditions = standfast.contact_conditions(**BLOCK)
    assert [condition.equation for condition in conditions] == ["friction", "contact", "contact", "contact"]
    assert conditions[0].statement == "|f_x| ≤ μ_s f_y" and conditions[0].margin == pytest.approx(0.1)
    unsure = BLOCK | dict(x=-4, m=-2, mu_s=3, mu_k=3)
    assert standfast.contact(**unsure).modes == Modes.SLIDE_LEFT | Modes.ROCK_O
    rocks, by_symbol = (standfast.contact_conditions(**unsure, mode=mode) for mode in (Mode.ROCK_O, "RO"))
    assert [dict(one) for one in rocks] == [dict(one) for one in by_symbol] and rocks[0].statement == "θ̈ > 0"
    with pytest.raises(ValueError, match="mode is FL, which is not consistent here; expected one of SL RO"):
        standfast.contact_conditions(**unsure, mode=Mode.FLIGHT)


def test_tables_and_what_is_missing() -> None:
    frame = pd.DataFrame([BLOCK, BLOCK | dict(x=np.nan), BLOCK | dict(x=-2.0)], index=["a", "b", "c"]).drop(columns="mu_k")
    found = standfast.contact(frame, map={"mu_k": 0.5}, columns=["mode", "modes", "x_ddot"])
    assert list(found.index) == ["a", "b", "c"] and list(found.columns) == ["mode", "modes", "x_ddot"]
    assert found["mode"].isna().tolist() == [False, True, False]
    assert found["mode"].dtype == "UInt8" and found["modes"].dtype == "UInt16" and found.loc["c", "x_ddot"] == -1.5
    # What is missing does not make a sound number beside it look wrong: here mu_k above the mu_s put in its place.
    lacking = pl.DataFrame({**{name: [value] for name, value in BLOCK.items()}, "mu_s": [None], "mu_k": [7.0]}, schema_overrides={"mu_s": pl.Float64})
    assert standfast.contact(lacking)["mode"].to_list() == [None]


@pytest.mark.parametrize(
    ("given", "error", "words"),
    [
        (dict(d=0), ValueError, "depth d of the base is 0; expected a number above zero"),
        (dict(mu_s=[0.6, 0.5]), ValueError, "static friction mu_s is 0.5 at index 1; expected no less than the kinetic friction"),
        (dict(columns=["mood"]), ValueError, "columns has 'mood'"),
        (dict(mu_k="0.6"), TypeError, "mu_k is '0.6'"),
    ],
)
def test_wrong_input(given: dict[str, object], error: type[Exception], words: str) -> None:
    with pytest.raises(error, match=words):
        standfast.contact(**(BLOCK | given))


def test_impossible_problems_may_be_left_out() -> None:
    found = standfast.contact(**(BLOCK | dict(d=[1, 0, 1])), on_error="null")
    assert found.mode.tolist() == [0, None, 0] and found.f_x.mask.tolist() == [False, True, False]


def test_a_problem_without_mode_has_neither_mode_nor_motion() -> None:
    # No such problem is known; the columns are those that the native module would give.
    columns = {"mode": np.array([1, 255], np.uint8), "modes": np.array([2, 0], np.uint16), "f_x": np.array([0.5, np.nan])}
    found = _contact._without_mode(columns)
    assert found["mode"].tolist() == [1, None] and found["f_x"].tolist() == [0.5, None] and found["modes"].tolist() == [2, 0]
