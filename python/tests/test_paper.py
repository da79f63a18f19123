"""The paper: it builds, every number in it has its place, and nothing unread is cited."""

import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

tomllib = pytest.importorskip("tomllib", reason="Python 3.11 has it")
pytest.importorskip("pypandoc", reason="the paper is built by pandoc: pip install pypandoc_binary")

ROOT = Path(__file__).resolve().parents[2]
PAPER = ROOT / "docs" / "paper"
TEXT = (PAPER / "paper.md").read_text(encoding="utf-8").split("---\n", 2)[2]
NUMBERS = tomllib.loads((PAPER / "numbers.toml").read_text(encoding="utf-8"))["number"]
#: Entries of paper.bib: their key, and all fields.
ENTRIES = dict(re.findall(r"@\w+\{(\w+),(.*?)\n\}", (PAPER / "paper.bib").read_text(encoding="utf-8"), re.DOTALL))


def test_every_number_has_its_place(program: list[str]) -> None:
    rest = re.sub(r"@\w+", "", TEXT)
    for number in NUMBERS:
        assert number["told"] in TEXT, f"the paper says no longer: {number['told']}"
        rest = rest.replace(number["told"], "")
        if number["kept"]:
            kept = (ROOT / number["kept"]).read_text(encoding="utf-8")
        else:
            _, *words = shlex.split(number["command"])
            kept = subprocess.run([*program, *words], cwd=ROOT, capture_output=True, encoding="utf-8", check=True).stdout
        for printed in number["printed"]:
            assert printed in kept, f"{number['kept'] or number['command']} says no longer: {printed}"
    # Names may have numbers.
    for name in ("Box2D", "Apache licence 2.0"):
        rest = rest.replace(name, "")
    left = [line for line in rest.splitlines() if re.search(r"\d", line)]
    assert not left, left


def test_nothing_unread_is_cited() -> None:
    cited = set(re.findall(r"@(\w+)", TEXT))
    assert cited == set(ENTRIES)
    references = (ROOT / "docs" / "trust" / "references.md").read_text(encoding="utf-8")
    for key, fields in ENTRIES.items():
        assert "note" in fields and ("Read:" in fields or "Run, not read" in fields), key
        if "Read:" in fields:
            title = re.search(r"title\s*=\s*\{(.*)\},", fields)
            assert title is not None
            words = re.sub(r"[{}\\']", "", title[1]).replace("Painleve", "Painlevé")
            line = next((line for line in references.splitlines() if words in line), "")
            assert "ead.*" in line.replace("read*", "read.*") and "Not read" not in line, f"{key}: {words}"


def test_it_builds_on_four_pages(tmp_path: Path) -> None:
    build = [sys.executable, PAPER / "build.py", "-o"]
    page = tmp_path / "paper.html"
    subprocess.run([*build, page], check=True)
    html = page.read_text(encoding="utf-8")
    assert html.count('class="csl-entry"') == len(ENTRIES) and "<math" in html and html.count("<table") == 3
    sheets = tmp_path / "paper.pdf"
    ran = subprocess.run([*build, sheets], capture_output=True, encoding="utf-8")
    if "no browser" in ran.stderr and "CI" not in os.environ:
        pytest.skip(ran.stderr)
    assert ran.returncode == 0, ran.stderr
    assert len(re.findall(rb"/Type\s*/Page\b", sheets.read_bytes())) == 4
