"""What Tab completes in a notebook: attributes by jedi, as IPython asks it, and keys by what answers say themselves."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import jedi
import pytest
import standfast
from IPython.core.completer import provisionalcompleter
from IPython.core.interactiveshell import InteractiveShell

EXAMPLES = Path(__file__).parents[2] / "examples"
GODA = EXAMPLES / "goda-2000.toml"
BLOCK = {"block": {"b1": 1, "b2": 1, "d": 3, "mu_s": 50, "gravity": 1}}
PLANE = {"point": {"gamma": 0.8, "k_prime": 0.9, "k": 0.5}, "random": {"mu": {"uniform": {"from": 0.4, "to": 0.6}}}}
WIDTH: Any = {"vary": "width", "target": "factor=1.2"}

ANSWERS = {
    "Assessment": (lambda: standfast.assess(GODA), ["SF_sliding", "bearing", "figures", "governing"]),
    "Situation": (lambda: standfast.assess(GODA).situations[0], ["SF_sliding", "bearing", "departure_by"]),
    "Design": (lambda: standfast.design(GODA, **WIDTH), ["found", "value", "wanted"]),
    "Boundary": (lambda: standfast.design(GODA, **WIDTH, and_="friction", and_lower=0.5, and_upper=0.7), ["and_", "at", "svg"]),
    "Simulation": (lambda: standfast.simulate(BLOCK, base=[0.5, 0.5], dt=1), ["end", "series", "max_theta"]),
    "Spectrum": (lambda: standfast.spectrum(BLOCK, "overturning", scale="0.5..2:3", base=[0.5, 0.5], dt=1), ["points", "kind"]),
    "Probability": (lambda: standfast.probability(PLANE), ["modes", "method", "beta"]),
    "Explanation": (lambda: standfast.explain(1, 0.4, 0.5, 0.6), ["mode", "along_k"]),
    "ArrowTable": (lambda: standfast.draws(PLANE, 3), ["mu", "to_pandas"]),
}


@pytest.mark.parametrize("name", ANSWERS)
def test_attributes_are_completed(name: str) -> None:
    make, expected = ANSWERS[name]
    answer = make()
    assert type(answer).__name__ == name
    found = {one.name for one in jedi.Interpreter("answer.", [{"answer": answer}]).complete()}
    assert found >= set(expected)
    start = expected[0][:2]
    assert expected[0] in {one.name for one in jedi.Interpreter(f"answer.{start}", [{"answer": answer}]).complete()}


def test_keys_are_completed() -> None:
    shell = InteractiveShell.instance()
    shell.user_ns.update(answer=standfast.assess(GODA), table=standfast.draws(PLANE, 3), chances=standfast.probability(PLANE).modes)
    for text, expected in (('answer["SF_sl', "SF_sliding"), ('table["k_e', "k_eff"), ('chances["S', "SL")):
        with provisionalcompleter():
            found = {one.text.strip("\"'") for one in shell.Completer.completions(text, len(text))}
        assert expected in found, (text, found)


@pytest.mark.parametrize("function", ["probability", "design", "simulate", "spectrum", "sheet", "assess_table", "classify", "limit_states", "contact"])
def test_how_far_work_is_is_completed(function: str) -> None:
    """Everything that may take long has ``progress``, under that name."""
    found = {one.name for one in jedi.Interpreter(f"standfast.{function}(prog", [{"standfast": standfast}]).complete()}
    assert "progress=" in found, found
