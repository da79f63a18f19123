"""Warnings of answers: in ``warnings``, and told once from each line, by one category."""

from __future__ import annotations

import pickle
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import standfast
from standfast import StandfastWarning

EXAMPLES = Path(__file__).parents[2] / "examples"
GODA, RANDOM = EXAMPLES / "goda-2000.toml", EXAMPLES / "goda-2000-random.toml"
BLOCK: dict[str, Any] = {"body": {"width": 1, "height": 2, "mass": 4800, "friction": 0.7}, "load": [{"force": 20e3, "elevation": 1.5}]}
STATUE = {"body": {"width": "0.6 m", "height": "2 m", "density": "2.6 t/m3", "friction": 0.5}}

#: What is asked, and the names of the warnings, as the answer has them.
ASKED: dict[str, tuple[Callable[[], Any], Callable[[Any], list[str]]]] = {
    "assess": (lambda: standfast.assess(GODA), lambda answer: [one.name for one in answer.warnings]),
    "simulate": (
        lambda: standfast.simulate(STATUE, base=[1.0, 1.0], dt=0.5, unit="m/s2", strength=False),
        lambda answer: [one.name for one in answer.warnings],
    ),
    "spectrum": (
        lambda: standfast.spectrum(STATUE, "overturning", scale="0.5..1:2", base=[1.0, 1.0], dt=0.5, unit="m/s2"),
        lambda answer: [one.name for one in answer.warnings],
    ),
    "probability": (lambda: standfast.probability(RANDOM, samples=1 << 10), lambda answer: answer.summary.warnings),
    "design": (lambda: standfast.design(GODA, vary="width", target="factor=1.2"), lambda answer: answer.summary.warnings),
}


def told(ask: Callable[[], Any]) -> tuple[Any, list[warnings.WarningMessage]]:
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        answer = ask()
    return answer, caught


@pytest.mark.parametrize("name", ASKED)
def test_each_warning_of_an_answer_is_told(name: str) -> None:
    ask, of = ASKED[name]
    answer, caught = told(ask)
    assert of(answer) and [one.message.name for one in caught] == of(answer)  # type: ignore[union-attr]
    for one in caught:
        assert isinstance(one.message, StandfastWarning) and one.filename == __file__ and f"({one.message.name})" in str(one.message)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(StandfastWarning):
            ask()


def test_what_is_in_order_is_not_warned_of() -> None:
    answer, caught = told(lambda: standfast.assess(BLOCK))
    assert answer.warnings == [] and not caught
    # Neither is an answer that is loaded.
    assert not told(lambda: pickle.loads(pickle.dumps(told(lambda: standfast.assess(GODA))[0])))[1]


def test_a_search_from_one_line_is_warned_once() -> None:
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("default")
        for friction in (1.1, 1.2, 1.3):
            standfast.assess({**BLOCK, "body": {**BLOCK["body"], "friction": friction}})
    assert [one.message.name for one in caught] == ["high-friction"] and "1.1" in str(caught[0].message)  # type: ignore[union-attr]
