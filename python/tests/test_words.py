"""What Python says never names an option of the program."""

import re
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import standfast

EXAMPLES = Path(__file__).parents[2] / "examples"
CASES = sorted(path for path in EXAMPLES.glob("*.toml"))
MOTIONS = sorted(path for path in EXAMPLES.glob("motion/*.toml"))
CHANCES = [path for path in [*CASES, *EXAMPLES.glob("probability/*.toml")] if "\n[random]" in path.read_text(encoding="utf-8")]
OPTION = re.compile(r"(?:^|[\s(`\"'])(--[a-z][a-z-]*)")
STORM, GODA, STATUE = EXAMPLES / "goda-2000-storm.toml", EXAMPLES / "goda-2000.toml", EXAMPLES / "motion/statue-earthquake.toml"
SHAKEN = {"base": np.sin(np.arange(2000) / 7), "dt": 0.01, "unit": "g"}


def said(answer: Any) -> Iterator[str]:
    yield from (str(answer), repr(answer), answer.to_json())


@pytest.mark.parametrize("path", [*CASES, *MOTIONS, *CHANCES], ids=lambda path: path.stem)
def test_no_answer_names_an_option(path: Path) -> None:
    def answers() -> Iterator[Any]:
        if path in CASES and path not in CHANCES:
            yield standfast.assess(path)
        if path in CHANCES:
            yield standfast.probability(path, samples=1 << 10, precision=1e-6)
        if path in MOTIONS:
            yield standfast.simulate(path, strength=False)

    for answer in answers():
        assert not [OPTION.findall(text) for text in said(answer) if OPTION.search(text)]


def test_what_is_left_out_is_asked_for_as_here() -> None:
    """Of many events and of draws that are too few the text says how to have more."""
    impact = {"law": "ratio", "ratio": 0.9}
    block = {"block": {"b1": 1, "b2": 1, "d": 3, "mu_s": 0.8, "gravity": 1}, "motion": {"impact": impact}}
    motion = str(standfast.simulate(block, base=[0, 0.5, 0.5, 0], dt=0.67, strength=False))
    assert "more; all=True shows them" in " ".join(motion.split()), motion
    chance = str(standfast.probability(STORM, samples=1 << 10, precision=1e-6))
    assert "more samples make it so" in " ".join(chance.split())


def simulated() -> None:
    standfast.simulate(STATUE, base=[[0, 1]], dt=0.1)


#: What is wrong, and is said to be.
WRONG: dict[str, Callable[[], object]] = {
    "a target": lambda: standfast.design(GODA, vary="width", target="factr"),
    "an end": lambda: standfast.design(GODA, vary="width", target="rest", lower=5, upper=1),
    "no solution": lambda: standfast.design(GODA, vary="width", target="factor=1.2", lower=1, upper=2),
    "met everywhere": lambda: standfast.design(GODA, vary="width", target="factor=1.2", lower=30, upper=40),
    "twice": lambda: standfast.design(GODA, vary="width", target="rest", and_="width"),
    "nowhere": lambda: standfast.design(GODA, vary="width", target="factor=9", and_="friction", lower=5, upper=8),
    "no criteria": lambda: standfast.design(GODA, vary="width", target="criteria"),
    "a chance": lambda: standfast.design(GODA, vary="width", target="p_not_rest=0.1"),
    "a motion": lambda: standfast.design(GODA, vary="width", target="slide=0.1"),
    "a range": lambda: standfast.probability(EXAMPLES / "goda-2000-random.toml", over="width"),
    "a name": lambda: standfast.probability(EXAMPLES / "goda-2000-random.toml", over={"wdith": [1, 2]}),
    "a peak": lambda: standfast.probability(EXAMPLES / "goda-2000-random.toml", over="pga=0.1 g..1 g:3"),
    "nothing random": lambda: standfast.probability(GODA),
    "a number of motion": lambda: standfast.probability(
        {"body": {"width": 1, "height": 3, "density": 2400, "friction": 0.5}, "load": [{"force": 1e3, "elevation": 1}],
         "random": {"motion.impact.ratio": {"normal": {"mean": 0.9, "sd": 0.01}}}}),
    "a moment's bias": lambda: standfast.probability(biased(), rotations="simulate"),
    "a case in time in rows": lambda: standfast.assess_table(STATUE, {"friction": [0.5, 0.6]}),
    "a column": lambda: standfast.assess_table(GODA, {"frction": [0.5, 0.6]}),
    "a result": lambda: standfast.assess_table(GODA, {"friction": [0.5, 0.6]}, columns=["mood"]),
    "a row": lambda: standfast.assess_table(GODA, {"friction": [0.5, -0.6]}),
    "a map": lambda: standfast.assess_table(GODA, {"mu": [0.5, 0.6]}, map={"friction": "nu"}),
    "a kind of spectrum": lambda: standfast.spectrum(STATUE, "newmark", size="1..2"),
    "loads of a spectrum": lambda: standfast.spectrum(EXAMPLES / "motion/caisson-breaking-wave.toml"),
    "no base": lambda: standfast.spectrum(GODA),
    "a record": simulated,
    "points": lambda: standfast.classify({"gama": [1], "k_prime": [1], "k": [1], "mu": [1]}),
    "a value": lambda: standfast.classify(1, 0, 1, -1),
    "a draw": lambda: standfast.draws(GODA, 10),
    "a sheet": lambda: standfast.sheet(GODA, date="soon"),
}  # fmt: skip


def biased() -> dict[str, Any]:
    """The case of storms, with a law of a moment."""
    try:
        import tomllib
    except ImportError:
        tomllib = pytest.importorskip("tomli")
    case: dict[str, Any] = tomllib.loads(STORM.read_text(encoding="utf-8"))
    case["random"]["bias.M_p"] = {"normal": {"mean": 1.0, "sd": 0.1}}
    return case


@pytest.mark.parametrize("name", WRONG)
def test_no_error_names_an_option(name: str) -> None:
    with warnings.catch_warnings(record=True) as minded, pytest.raises((ValueError, TypeError, KeyError)) as error:
        warnings.simplefilter("always")
        WRONG[name]()
    for text in (str(error.value), *(str(warning.message) for warning in minded)):
        assert not OPTION.search(text), text
