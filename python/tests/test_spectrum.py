"""Spectra: what the program answers, typed; a steady shaking against its closed form."""

from __future__ import annotations

import csv
import io
import json
import pickle
import re
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import polars as pl
import pyarrow as pa
import pytest
import standfast
from test_schema import errors

ROOT = Path(__file__).parents[2]
PULSE = ROOT / "examples/motion/block-base-pulse.toml"
BLOCK = {"block": {"b1": 1, "b2": 1, "d": 3, "mu_s": 50, "gravity": 1}}
KINDS: dict[str, dict[str, Any]] = {
    "rocking": {"size": "1..4:3", "slenderness": "2..4:2"},
    "newmark": {"ratio": "0.2..0.8:4"},
    "overturning": {"scale": "0.5..2:4"},
}


@pytest.mark.parametrize("kind", KINDS)
def test_it_is_what_the_program_prints(program: list[str], kind: Any, tmp_path: Path) -> None:
    told: list[int] = []
    found = standfast.spectrum(PULSE, kind, **KINDS[kind], progress=lambda done, total: told.append(done))
    options = [f"--{name}={','.join(re.split('[.]{2}|:', steps))}" for name, steps in KINDS[kind].items()]
    call = [*program, "spectrum", str(PULSE), f"--kind={kind}", *options, "-o", str(tmp_path)]
    document = json.loads(subprocess.run([*call, "--format=json"], capture_output=True, encoding="utf-8", check=True).stdout)
    assert document | {"figures": []} == json.loads(found.to_json()) and not errors(document, "spectrum.schema.json")
    (figure,) = document["figures"]
    assert Path(figure).read_text(encoding="utf-8") == found.svg == found.figures[0].svg == found._repr_svg_()
    found.figures[0].save(tmp_path / "own.png")
    assert (tmp_path / "own.png").read_bytes().startswith(b"\x89PNG")
    printed = subprocess.run([*call, "--csv=-"], capture_output=True, encoding="utf-8", check=True).stdout
    assert printed == found.csv
    rows = list(csv.reader(io.StringIO(printed)))
    assert rows[0] == found.points.column_names and len(rows) == len(found.points) + 1
    assert [float(row[-2]) for row in rows[1:]] == [float(value) for value in found.points[rows[0][-2]].to_pylist()]  # type: ignore[arg-type]
    assert str(found) and found.kind == kind and pl.DataFrame(found.points).height == len(rows) - 1
    assert pickle.loads(pickle.dumps(found)).points.to_pylist() == found.points.to_pylist() and told[-1] >= len(rows) - 1
    assert standfast.spectrum(PULSE, kind, **KINDS[kind], threads=1).to_json() == found.to_json()


def test_newmarks_block_under_a_steady_shaking() -> None:
    """k₀ over T slides a block of yield acceleration a by (k₀ − a) k₀ T²/(2 a), to the other side."""
    found = standfast.spectrum(BLOCK, "newmark", ratio="0.2..0.8:4", base=np.full(5, 0.6), dt=0.25).points
    ratio = found.ratio.to_numpy()
    expected = (1 - ratio) * 0.6 / (2 * ratio)
    np.testing.assert_allclose(ratio, [0.2, 0.4, 0.6, 0.8], rtol=1e-12)
    np.testing.assert_allclose(found.left.to_numpy(), expected, rtol=1e-12)
    np.testing.assert_allclose(found.slide.to_numpy(), -expected, rtol=1e-12)
    assert not found.right.to_numpy().any() and found.left.metadata == {}


def test_an_overturning_curve_is_made_of_motions() -> None:
    shaking = np.sin(np.linspace(0, 2 * np.pi, 51))
    found = standfast.spectrum(BLOCK, "overturning", scale="0.2..2:10", base=shaking, dt=0.1)
    for point in found.points:
        alone = standfast.simulate(BLOCK, base=point["scale"] * shaking, dt=0.1)  # type: ignore[operator]
        assert alone.overturned == point["overturned"] and alone.impacts == point["impacts"]
        assert point["max_theta"] == pytest.approx(alone.max_theta, rel=1e-9)
    assert found.stretches is not None and found.points.overturned.to_numpy().any()


@pytest.mark.parametrize(
    ("kind", "options", "error", "said"),
    [
        ("rock", {}, ValueError, "kind is 'rock'; expected one of 'rocking', 'newmark', 'overturning'"),
        ("rocking", {"ratio": "0.1..0.5"}, TypeError, "ratio does not belong to a spectrum of kind 'rocking', which goes over size and slenderness"),
        ("newmark", {"ratio": "0.5..0.1"}, ValueError, r"ratio is \"0.5..0.1\"; expected 'from..to'"),
        ("newmark", {"ratio": (0.1, 0.5, 3)}, TypeError, r"ratio is \(0.1, 0.5, 3\), which may be .*; expected the list .*, or the text '0.1..0.5:3'"),
        ("newmark", {"ratio": "0..0.5"}, ValueError, "with 0 < from < to"),
        ("newmark", {"ratio": "0.1..0.5:1"}, ValueError, "with 0 < from < to and two or more"),
        ("newmark", {"unit": "g"}, TypeError, "unit is that of base, which is not given"),
        ("newmark", {"threads": 0}, ValueError, "threads is 0"),
    ],
)
def test_wrong_ranges_are_refused(kind: Any, options: dict[str, Any], error: type[Exception], said: str) -> None:
    with pytest.raises(error, match=said):
        standfast.spectrum(PULSE, kind, **options)


def test_a_case_without_shaking_has_none() -> None:
    with pytest.raises(ValueError, match="shak|base"):
        standfast.spectrum(BLOCK)
    with pytest.raises(ValueError, match="unit is missing"):
        body = {"body": {"width": 1, "height": 3, "density": 2400, "friction": 0.7}}
        standfast.spectrum(body, "newmark", ratio="0.2..0.8:2", base=[0, 1, 0], dt=0.1)


def test_a_range_is_a_text_or_its_values() -> None:
    """Whatever holds the values, the curve is that of the text; what a text refuses is refused of values."""
    text = standfast.spectrum(BLOCK, "overturning", scale="0.5..2:4", base=[0.5, 0.5], dt=4)
    values = [0.5, 1.0, 1.5, 2.0]
    for given in (values, tuple(values), np.array(values), pd.Series(values, index=list("abcd")), pl.Series(values), pa.array(values)):
        found = standfast.spectrum(BLOCK, "overturning", scale=given, base=[0.5, 0.5], dt=4)
        assert found.to_json() == text.to_json() and found.csv == text.csv, type(given)
    uneven = standfast.spectrum(BLOCK, "newmark", ratio=[0.2, 0.3, 0.9], base=[0.5, 0.5], dt=4)
    assert uneven.points.ratio.to_pylist() == [0.2, 0.3, 0.9]
    wide = standfast.spectrum(BLOCK, "rocking", size=[1, 3], slenderness=np.arange(2, 5), base=[0.5, 0.5], dt=4)
    assert wide.points.size.to_pylist() == [1] * 3 + [3] * 3 and wide.points.slenderness.to_pylist() == [2, 3, 4] * 2


@pytest.mark.parametrize(
    ("given", "error", "said"),
    [
        (0.5, TypeError, "ratio is 0.5, a float; expected a text as"),
        ({0.2, 0.4}, TypeError, "ratio is .*; expected a text as"),
        ({"from": 0.2}, TypeError, "ratio is .*; expected a text as"),
        (True, TypeError, "ratio is True, a bool; expected a text as"),
        (["0.2", "0.4"], TypeError, "ratio"),
        ([0.5], ValueError, "ratio has one value; expected two or more"),
        ([], ValueError, "ratio has 0 values; expected two or more"),
        ([0.5, 0.2], ValueError, "ratio has 0.2 at index 1; expected rising values, all above zero"),
        ([0.0, 0.2], ValueError, "ratio has 0 at index 0; expected rising values, all above zero"),
        ([0.1, np.nan], ValueError, "ratio has NaN at index 1"),
        ([[0.1, 0.2]], ValueError, r"ratio has the shape \(1, 2\); expected numbers along one axis"),
        (pd.Series([0.1, None], dtype="Float64"), ValueError, "ratio has missing values"),
    ],
)
def test_values_that_are_no_range_are_refused(given: Any, error: type[Exception], said: str) -> None:
    with pytest.raises(error, match=said):
        standfast.spectrum(BLOCK, "newmark", ratio=given, base=[0.5, 0.5], dt=4)
