"""Cases to begin from: those of the program, answered as they come."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
import standfast

KINDS = ["block", "caisson", "wall", "statue", "rack", "motion", "random"]


@pytest.mark.parametrize("kind", KINDS)
def test_a_beginning_is_that_of_the_program(kind: str, program: list[str], tmp_path: Path) -> None:
    path = tmp_path / "my.toml"
    text = standfast.new(kind, path)
    printed = subprocess.run([*program, "new", kind], check=True, capture_output=True).stdout.decode()
    assert path.read_text(encoding="utf-8") == text == printed
    assert standfast.assess(path).summary.answer.endswith(").")
    with pytest.raises(FileExistsError):
        standfast.new(kind, path)


def test_another_kind_is_refused() -> None:
    with pytest.raises(standfast.StandfastError, match="kind is 'tower'; expected block, caisson"):
        standfast.new("tower")


def test_the_package_says_what_to_type() -> None:
    told = subprocess.run([sys.executable, "-m", "standfast"], check=True, capture_output=True, text=True, encoding="utf-8").stdout
    assert told.startswith(f"standfast {standfast.__version__}, a Python package.")
    assert [kind for kind in KINDS if f'standfast.new("{kind}", "my.toml")' in told] == KINDS


def test_the_examples_come_with_the_package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    with pytest.raises(FileNotFoundError) as missing:
        standfast.assess("examples/goda-2000.toml")
    if sys.version_info >= (3, 11):
        assert missing.value.__notes__ == ["standfast.examples() writes the examples into the folder examples"]
    files = standfast.examples()
    own = Path(__file__).parents[2] / "examples"
    assert {path.relative_to("examples") for path in files} == {path.relative_to(own) for path in own.rglob("*") if path.is_file() and path.suffix != ".svg"}
    assert all(path.read_bytes() == (own / path.relative_to("examples")).read_bytes() for path in files)
    assert standfast.assess("examples/goda-2000.toml").load_factor == pytest.approx(1.1245, abs=1e-3)
    with pytest.raises(FileExistsError):
        standfast.examples()
