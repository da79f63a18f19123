"""One point explained: the program's words and document, typed."""

from __future__ import annotations

import json
import math
import pickle
import subprocess

import pytest
import standfast
from standfast import Mode, Modes
from test_schema import POINTS, classified, errors


@pytest.mark.parametrize("point", POINTS, ids=str)
def test_the_program_says_the_same(program: list[str], point: tuple[float, ...]) -> None:
    why = standfast.explain(*point)
    options = [f"--{name}={value}" for name, value in zip(("gamma", "k-prime", "k", "mu"), point)]
    printed = subprocess.run([*program, "classify", *options, "--explain"], capture_output=True, encoding="utf-8", check=True)
    assert str(why) == printed.stdout
    document = classified(program, point)
    assert json.loads(why.to_json()) == document and not errors(document, "point.schema.json")
    assert why.mode is standfast.classify(*point) and why.trace[-1].mode is why.mode and why.trace[-1].holds
    assert set(why) <= set(dir(why))
    states = standfast.limit_states(*point)
    assert (why.SF_sliding, why.SF_overturning) == (states.SF_sliding, states.SF_overturning)


def test_attributes() -> None:
    why = standfast.explain(1, -0.5, 4, 3)
    assert why.also == Modes.ROCK_O and not why.unique and not why.mirrored
    assert why.motion.x_ddot == -1 and why.along_k[0].to is not Mode.REST
    relation = why.trace[0].relations[0]
    assert (relation.equation, relation.statement, relation.left, relation.right) == ("4.7", "μ ≥ k", 3, 4)
    assert relation.margin == -1 and not relation.holds
    assert standfast.explain(1, 1, 0, 1).SF_sliding == math.inf and standfast.explain(1, -1, 2, 5).leaves_rest is not None
    assert str(pickle.loads(pickle.dumps(why))) == str(why) and why.to_dict()["mode"] == "SL"


def test_to_the_right() -> None:
    left, right = (standfast.explain(0.8, 0.9167, 0.7281, 0.6, to=to) for to in ("left", "right"))
    assert (left.mode.symbol, right.mode.symbol, right.mirrored) == ("SRO-", "SRO'+", True)
    assert [step.mode.symbol for step in right.trace] == ["RE", "SL+", "RO'", "SRO'+"]
    assert [change.to.symbol for change in right.along_mu] == ["SRO'+", "RO'"]
    assert right.motion.x_ddot == -left.motion.x_ddot
    assert "mirror image" in str(right) and "SRO'+ holds" in str(right) and "SRO-" not in str(right)
    assert not errors(json.loads(right.to_json()), "point.schema.json")
    with pytest.raises(ValueError, match="friction μ is -1; expected"):
        standfast.explain(1, 1, 1, -1)


@pytest.mark.parametrize("k", ["0.5", True, [0.5], None, 1j], ids=repr)
def test_plain_numbers_only(k: object) -> None:
    with pytest.raises(TypeError):
        standfast.explain(1, 1, k, 1)  # type: ignore[arg-type]
