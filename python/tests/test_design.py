"""Designs and boundaries: what the program answers, typed, with errors in Python's words."""

from __future__ import annotations

import csv
import io
import json
import math
import pickle
import signal
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import standfast
from test_schema import BOUNDARIES, DESIGNS, errors

ROOT = Path(__file__).parents[2]
GODA = ROOT / "examples/goda-2000.toml"
BLOCK = {
    "body": {"width": "1 m", "height": "2 m", "density": "2.4 t/m3", "friction": 0.7},
    "load": [{"force": "20 kN/m", "elevation": "1.5 m"}],
}


def printed(program: list[str], *arguments: str | Path) -> str:
    found = subprocess.run([*program, "design", *arguments], capture_output=True, encoding="utf-8", check=True)
    return found.stdout


def asked(wanted: tuple[str, ...]) -> dict[str, Any]:
    """Arguments of the program as those of Python."""
    _, vary, target, *options = wanted
    named = dict(option.removeprefix("--").split("=", 1) for option in options if "=" in option)
    return {"vary": vary, "target": target, "greatest": "--greatest" in options} | ({"and_": named["and"]} if named else {})


@pytest.mark.parametrize("wanted", DESIGNS, ids=" ".join)
def test_the_program_says_the_same(program: list[str], wanted: tuple[str, ...]) -> None:
    name, vary, target, *options = wanted
    file = ROOT / f"examples/{name}.toml"
    found = standfast.design(file, **asked(wanted))
    arguments = [file, "--vary", vary, "--target", target, *options]
    assert str(found) == printed(program, *arguments)
    document = json.loads(printed(program, *arguments, "--format=json"))
    assert json.loads(found.to_json()) == document and not errors(document, "design.schema.json")
    assert found.value == document["found"]["value"] and found.met[0].from_.value == document["met"][0]["from"]["value"]
    assert (found.found.mode is None) == (document["found"]["mode"] is None)


@pytest.mark.parametrize("wanted", BOUNDARIES, ids=" ".join)
def test_boundaries(program: list[str], wanted: tuple[str, ...], tmp_path: Path) -> None:
    name, vary, target, *options = wanted
    file = ROOT / f"examples/{name}.toml"
    found = standfast.design(file, **asked(wanted))
    files = [tmp_path / "set.csv", tmp_path / "set.svg"]
    outputs = [argument for path in files for argument in ("-o", path)]
    arguments = [file, "--vary", vary, "--target", target, *options]
    assert printed(program, *arguments, *outputs).startswith(str(found))
    assert json.loads(found.to_json()) == json.loads(printed(program, *arguments, "--format=json"))
    assert [found.csv, found.svg] == [path.read_text(encoding="utf-8") for path in files]
    rows = list(csv.reader(io.StringIO(found.csv)))[1:]
    first = {float(at): float(value) if value else math.nan for at, value, *_ in reversed(rows)}
    assert np.array_equal(list(first)[::-1], found.at)
    assert np.array_equal(list(first.values())[::-1], found.value, equal_nan=True)
    assert found._repr_svg_() == found.svg and str(pickle.loads(pickle.dumps(found))) == str(found)


def test_attributes() -> None:
    found = standfast.design(BLOCK, vary="load[1].force", target="rest", greatest=True, lower="1 kN/m", upper=60e3)
    # About O at the height of 1.5 m: 1.5 F ≤ 0.5 m g, and F ≤ 0.7 m g.
    weight = 2400 * 2 * 9.81
    assert math.isclose(found.found.boundary, weight / 3, rel_tol=1e-9) and weight / 3 * 0.9995 < found.value == found.found.value <= weight / 3
    assert (found.unit, found.wanted, found.bracket) == ("N/m", "greatest", [1000, 60000])
    assert found.present.mode is standfast.Mode.ROCK_O and found.found.mode is standfast.Mode.REST
    assert [row.input for row in found.sensitivity_per_percent][:2] == ["body.width", "body.height"]
    assert found.met[-1].to.binds == "rocking" and found.warnings == []
    assert repr(found).startswith("<Design greatest load[1].force for rest: 1")
    assert str(pickle.loads(pickle.dumps(found))) == str(found)


@pytest.mark.parametrize(
    ("given", "words"),
    [
        (dict(vary="widht"), ["the case has no `widht` to vary", "did you mean `width`"]),
        (dict(target="fctor=1.2"), ["target is \"fctor=1.2\"; did you mean factor? expected rest, no-rock"]),
        (dict(lower="3 kg"), ["lower is \"3 kg\""]),
        (dict(lower=5, upper=2), ["the range from 5 m to 2 m is empty; give its ends with lower and upper"]),
        (dict(upper="1 m"), ["no width from", "lower and upper widen the range"]),
        (dict(target="rest", greatest=True), ["there is no greatest width", "greatest=False gives the boundary on the other", "upper looks farther up"]),
        (dict(and_="body.width"), ["vary and and_ name the same number", "vary=\"width\", and_=\"friction\""]),
        (dict(and_="friction", and_lower=0.9, and_upper=0.8), ["give its ends with and_lower and and_upper"]),
        (dict(target="utilisation=0.9"), ["asks for the criteria of the case, which has none"]),
    ],
    ids=str,
)  # fmt: skip
def test_errors_name_the_arguments_of_python(given: dict[str, Any], words: list[str]) -> None:
    with pytest.raises(ValueError) as raised:
        standfast.design(BLOCK, **({"vary": "width", "target": "factor=1.2"} | given))
    said = " ".join(str(raised.value).split())
    assert all(word in said for word in words), said
    assert "--" not in said


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="no timers")
def test_an_interrupt_ends_the_call() -> None:
    def interrupt(number: int, frame: object) -> None:
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, interrupt)
    signal.setitimer(signal.ITIMER_REAL, 0.05)
    try:
        with pytest.raises(KeyboardInterrupt):
            while True:
                standfast.design(ROOT / "examples/quay.toml", vary="width", target="criteria", and_="friction")
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def test_without_a_target_it_is_that_of_the_case() -> None:
    assert standfast.design(BLOCK, vary="width").value == standfast.design(BLOCK, vary="width", target="rest").value
    quay = standfast.design(ROOT / "examples/quay.toml", vary="load[1].force", greatest=True)
    assert quay.value == standfast.design(ROOT / "examples/quay.toml", vary="load[1].force", greatest=True, target="criteria").value


def test_wrong_types() -> None:
    for given in (dict(vary=1), dict(target=1), dict(lower=True), dict(upper=[1]), dict(and_upper=2)):
        with pytest.raises(TypeError):
            standfast.design(BLOCK, **({"vary": "width", "target": "rest"} | given))
