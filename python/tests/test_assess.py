"""Cases from files and dicts, against the program's transcripts."""

from __future__ import annotations

import copy
import json
import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import standfast
from standfast import Mode

ROOT = Path(__file__).parents[2]
EXAMPLES = sorted((ROOT / "examples").glob("*.toml"))

CASE: dict[str, Any] = {
    "title": 'A "quoted" title\nin two lines, with γ',
    "body": {"width": "15 m", "height": np.float64(12), "density": "2.1 t/m3", "friction": 0.6},
    "load": [{"name": "wave", "force": "2700 kN/m", "elevation": "11.5 m", "direction": "left"}],
}


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_every_example(path: Path) -> None:
    found = standfast.assess(path)
    document = found.to_dict()
    assert json.loads(json.dumps(document)) == document
    assert document["title"] in str(found) and document["title"] in repr(found)
    assert found.figures and all(figure.svg.startswith("<svg") for figure in found.figures)
    assert found._repr_svg_() == found.figures[0].svg
    assert pickle.loads(pickle.dumps(found)).to_dict() == document
    assert str(copy.copy(found)) == str(found)


@pytest.mark.parametrize("name", ["caisson-in-air", "goda-2000"])
def test_the_text_is_the_programs(name: str) -> None:
    kept = {"caisson-in-air": "assess-caisson", "goda-2000": "assess-goda-2000"}[name]
    transcript = (ROOT / f"crates/cli/tests/cmd/{kept}.stdout").read_text(encoding="utf-8")
    text = str(standfast.assess(ROOT / f"examples/{name}.toml"))
    assert transcript.startswith(text)


def test_a_dict_is_the_same_case_as_its_file() -> None:
    tomllib = pytest.importorskip("tomllib")
    for path in EXAMPLES:
        with path.open("rb") as file:
            case = tomllib.load(file)
        assert standfast.assess(case).to_dict() == standfast.assess(path).to_dict()


def test_answers_as_attributes() -> None:
    found = standfast.assess(CASE)
    assert found.title == CASE["title"]
    assert found.mode is Mode.SLIDE_ROCK_O_LEFT and found["loads"][0]["mode"] == "SRO-"
    assert found.loads[0].motion.xi == -1 and found.body.width == 15
    assert found.margins.along_mu[0]["to"] == "SRO-"
    assert "mode" in dir(found.loads[0])
    with pytest.raises(AttributeError, match="this assessment has no 'colour'; it has title, note, gravity"):
        found.colour  # noqa: B018

    goda = standfast.assess(ROOT / "examples/goda-2000.toml", up_to=1.5)
    assert (goda.mode, goda.first_mode) == (Mode.REST, Mode.SLIDE_LEFT)
    assert goda.first_load_factor == pytest.approx(1.1252, abs=1e-4) and goda.path[-1]["to"] == 1.5
    assert "k_prime_eff" in goda and goda.k_eff == goda["k_eff"]

    several = standfast.assess(ROOT / "examples/block-two-loads.toml")
    assert [load.mode for load in several.loads][:2] == [Mode.ROCK_O, Mode.ROCK_O_PRIME]
    with pytest.raises(AttributeError, match=r"3 alternative loads; see loads\[0\].mode"):
        several.mode  # noqa: B018


def test_wrong_cases_show_where() -> None:
    def error(change: Any) -> str:
        case = copy.deepcopy(CASE)
        change(case)
        with pytest.raises(ValueError) as raised:
            standfast.assess(case)
        return str(raised.value)

    shown = error(lambda case: case["body"].update(friction=-0.6))
    assert "friction" in shown and "-0.6" in shown and "expected" in shown
    assert "friktion" in error(lambda case: case["body"].update(friktion=0.6))
    assert "`force`" in error(lambda case: case["load"][0].pop("force"))
    shown = error(lambda case: case["body"].update(width=object()))
    assert shown.startswith("body.width is <object") and "expected a number, a text with a unit" in shown
    assert "load.force is None" in error(lambda case: case["load"][0].update(force=None))
    assert "nan" in error(lambda case: case["body"].update(width=float("nan"))).lower()
    assert error(lambda case: case.clear())
    with pytest.raises(OSError, match="nowhere"):
        standfast.assess("nowhere.toml")
    with pytest.raises(ValueError, match="up_to is -1.0; expected a load factor above zero"):
        standfast.assess(CASE, up_to=-1)


def test_a_file_that_is_not_text(tmp_path: Path) -> None:
    path = tmp_path / "case.toml"
    path.write_bytes(b"title = 'x'\nnote = '\xff'\n")
    with pytest.raises(ValueError, match="is not UTF-8 text: line 2"):
        standfast.assess(path)
