"""Directions: what the program answers, typed; a square by hand; what is refused."""

from __future__ import annotations

import csv
import io
import json
import math
import pickle
import subprocess
from pathlib import Path

import pytest
import standfast
from test_schema import errors

ROOT = Path(__file__).parents[2]
EXAMPLES = sorted((ROOT / "examples/directions").glob("*.toml"))
BODY = {"width": 2, "length": 2, "height": 6, "mass": 1e4, "friction": 0.7}


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_it_is_what_the_program_prints(program: list[str], path: Path, tmp_path: Path) -> None:
    found = standfast.directions(path)
    call = [*program, "directions", str(path), "-o", str(tmp_path)]
    document = json.loads(subprocess.run([*call, "--format=json"], capture_output=True, encoding="utf-8", check=True).stdout)
    assert document | {"figures": []} == json.loads(found.to_json())
    assert not errors(document, "directions.schema.json")
    assert [(tmp_path / name).read_text(encoding="utf-8") for name in document["figures"]] == [figure.svg for figure in found.figures]
    text = subprocess.run(call, capture_output=True, encoding="utf-8", check=True).stdout
    assert text.startswith(str(found))
    written = subprocess.run([*program, "directions", str(path), "--csv", "-"], capture_output=True, encoding="utf-8", check=True).stdout
    assert written == found.csv
    rows = list(csv.DictReader(io.StringIO(written)))
    assert [float(row["load_factor"]) for row in rows] == found.table.load_factor.to_pylist()
    assert not errors(json.loads(standfast.assess(path).to_json()), "answer.schema.json")


def test_a_square_by_hand() -> None:
    load = {"force": 1e5 * 9.81 / 9.81, "elevation": 3, "direction_deg": 20}
    found = standfast.directions({"gravity": 10, "body": BODY, "load": [load]}, step=1)
    assert len(found.table) == 360
    for degrees, factor in zip(found.table.deg.to_pylist(), found.table.load_factor.to_pylist(), strict=True):
        angle = math.radians(degrees)
        assert math.isclose(factor, min(0.7, 1 / 3 / max(abs(math.cos(angle)), abs(math.sin(angle)))), rel_tol=1e-12)
    assert found.situations[0].load_factor == found.load_factor == pytest.approx(1 / 3, rel=1e-14)
    assert not found.unique_in_direction
    again = pickle.loads(pickle.dumps(found))
    assert str(again) == str(found) and again.csv == found.csv
    assert "<svg" in found.svg and repr(found).startswith("<Directions of a case")


def test_what_has_no_directions_is_refused() -> None:
    plane = {"body": BODY, "load": [{"force": 1e4, "elevation": 3}]}
    with pytest.raises(standfast.StandfastError, match="plane of its section"):
        standfast.directions(plane)
    with pytest.raises(standfast.StandfastError, match="nothing to turn"):
        standfast.directions({"body": BODY, "base": {"circle": 2}, "load": [{"force": 1e4, "elevation": 6, "direction": "down", "distance": 1}]})
    askew = {"body": BODY, "load": [{"force": 1e4, "elevation": 3, "direction_deg": 45, "z": 0.5}]}
    with pytest.raises(standfast.CaseError, match="on a disc alone"):
        standfast.directions(askew)
    turned = {"body": BODY, "load": [{"force": 1e4, "elevation": 3, "direction_deg": 45}]}
    for step in (7, 0, math.nan, 360):
        with pytest.raises(standfast.StandfastError, match="step"):
            standfast.directions(turned, step=step)
    with pytest.raises(AttributeError, match="no_such"):
        _ = standfast.directions(turned).no_such
