"""Calculation sheets: those of the program, and files that are whole or not there."""

from __future__ import annotations

import datetime
import os
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest
import standfast
from standfast import _standfast

ROOT = Path(__file__).parents[2]
QUAY = ROOT / "examples/quay.toml"
BLOCK = {"title": "A <b>lock", "body": {"width": 1, "height": 2, "mass": 4800, "friction": 0.7}, "load": [{"force": 2e3, "elevation": 1}]}


def test_the_program_writes_the_same(program: list[str], tmp_path: Path) -> None:
    told = {"author": "N. N.", "revision": "B", "project": "Quay \"4\""}
    theirs = tmp_path / "theirs.html"
    options = [argument for key, text in told.items() for argument in (f"--{key}", text)]
    subprocess.run([*program, "sheet", QUAY, "-o", theirs, "--date", "2026-11-21", *options], check=True, capture_output=True)
    ours = tmp_path / "ours.HTML"
    html = standfast.sheet(QUAY, ours, date=datetime.date(2026, 11, 21), **told)  # type: ignore[arg-type]
    assert ours.read_text(encoding="utf-8") == html == theirs.read_text(encoding="utf-8")
    assert sorted(os.listdir(tmp_path)) == ["ours.HTML", "theirs.html"]
    assert standfast.sheet(str(QUAY), date="2026-11-21", **told) == html  # type: ignore[arg-type]


def test_the_short_sheet_is_that_of_the_program(program: list[str], tmp_path: Path) -> None:
    theirs = tmp_path / "theirs.html"
    subprocess.run([*program, "sheet", QUAY, "--short", "-o", theirs], check=True, capture_output=True)
    html = standfast.sheet(QUAY, short=True)
    assert html == theirs.read_text(encoding="utf-8") != standfast.sheet(QUAY)
    assert "Inputs that decide" in html and "3 Calculation" not in html


def test_every_key_of_the_title_block_is_an_argument() -> None:
    keys = _standfast.title_block()
    html = standfast.sheet(BLOCK, date=datetime.datetime(2026, 11, 21, 12), **{key: f"this {key} of ours" for key in keys})
    assert all(f"this {key} of ours" in html for key in keys)
    assert "A &lt;b&gt;lock" in html and "2026-11-21" in html


def test_the_native_module_drops_nothing() -> None:
    case = ("the case", '[body]\nwidth = 1\nheight = 2\nmass = 4800\nfriction = 0.7\n')
    with pytest.raises(TypeError, match="a title block has no autor"):
        _standfast.sheet(case, None, 2.0, [("autor", "N. N.")], ("a4", False), None)
    with pytest.raises(ValueError, match='paper is "a5"; expected a4 or letter'):
        _standfast.sheet(case, None, 2.0, [], ("a5", True), None)


def test_what_is_replaced_is_whole(tmp_path: Path) -> None:
    path = tmp_path / "sheet.html"
    path.write_text("before", encoding="utf-8")
    path.chmod(0o640)
    link = tmp_path / "link.html"
    link.symlink_to(path)
    standfast.sheet(BLOCK, link)
    assert link.is_symlink() and path.read_text(encoding="utf-8").endswith("</html>") and path.stat().st_mode & 0o777 == 0o640
    before = path.read_bytes()
    with pytest.raises(ValueError, match="friktion"):
        standfast.sheet({"body": {"friktion": 1}}, path)
    assert path.read_bytes() == before and sorted(os.listdir(tmp_path)) == ["link.html", "sheet.html"]


@pytest.mark.parametrize(
    ("path", "given", "error", "words"),
    [
        ("sheet.docx", {}, ValueError, "unknown extension '.docx'; the extension has to be .html or .pdf"),
        ("sheet", {}, ValueError, "no extension"),
        ("none/sheet.html", {}, FileNotFoundError, "there is no folder"),
        (None, {"date": "2026-02-29"}, ValueError, "date is \"2026-02-29\"; there is no such day"),
        (None, {"date": "21.11.2026"}, ValueError, "expected a date like 2026-11-21"),
        (None, {"date": 20261121}, TypeError, "date is 20261121"),
        (None, {"paper": "a5"}, ValueError, 'paper is "a5"; expected a4 or letter'),
        (None, {"up_to": 0.5}, ValueError, "up_to is 0.5; expected a load factor from 1 to 1000000, as 2"),
        (None, {"up_to": "2"}, TypeError, "up_to is '2'; expected a load factor from 1 to 1000000, as 2"),
        (None, {"author": 7}, TypeError, "author is 7"),
    ],
)
def test_wrong_arguments(path: str | None, given: dict[str, Any], error: type[Exception], words: str, tmp_path: Path) -> None:
    with pytest.raises(error, match=words):
        standfast.sheet(BLOCK, None if path is None else tmp_path / path, **given)
    assert os.listdir(tmp_path) == []


def test_the_case_file_is_not_written_over(tmp_path: Path) -> None:
    case = tmp_path / "case.html"
    shutil.copy(QUAY, case)
    with pytest.raises(ValueError, match="written over the case file"):
        standfast.sheet(case, case)
    assert case.read_bytes() == QUAY.read_bytes()


def test_pdf(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("STANDFAST_BROWSER", "/no/such/browser")
    path = tmp_path / "sheet.pdf"
    with pytest.raises(RuntimeError, match="STANDFAST_BROWSER is /no/such/browser, which is not a program"):
        standfast.sheet(BLOCK, path)
    assert not path.exists()
    monkeypatch.delenv("STANDFAST_BROWSER")
    if not any(map(shutil.which, ("chromium", "chromium-browser", "google-chrome", "chrome"))):
        pytest.skip("no browser of the Chromium family")
    html = standfast.sheet(BLOCK, path, date="2026-11-21", paper="letter")
    pdf = path.read_bytes()
    assert pdf.startswith(b"%PDF") and b"/CreationDate (D:20261121" in pdf and b"612 792" in pdf and html.startswith("<!DOCTYPE")
