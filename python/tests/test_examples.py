"""The examples: programs, the notebook, and those of the book."""

from __future__ import annotations

import doctest
import os
import subprocess
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import nbformat
import pytest
from nbclient import NotebookClient

ROOT = Path(__file__).parents[2]
EXAMPLES = ROOT / "python" / "examples"


@pytest.mark.parametrize("path", sorted(EXAMPLES.glob("*.py")), ids=lambda path: path.stem)
def test_programs(path: Path, tmp_path: Path) -> None:
    environment = os.environ | {"PYTHONIOENCODING": "utf-8"}
    found = subprocess.run(
        [sys.executable, path], cwd=tmp_path, env=environment, capture_output=True, encoding="utf-8", timeout=300
    )
    assert found.returncode == 0, found.stderr
    assert "SL" in found.stdout or "at rest" in found.stdout


@pytest.mark.parametrize("path", sorted(EXAMPLES.glob("*.ipynb")), ids=lambda path: path.stem)
def test_notebooks(path: Path) -> None:
    notebook = nbformat.read(path, as_version=4)
    assert not any(cell.get("outputs") for cell in notebook.cells), "strip the outputs of a notebook before it is kept"
    NotebookClient(notebook, timeout=120, resources={"metadata": {"path": str(ROOT)}}).execute()
    shown = {kind for cell in notebook.cells for output in cell.get("outputs", []) for kind in output.get("data", {})}
    assert {"image/svg+xml", "image/png"} <= shown


PAGES = [page for page in sorted((ROOT / "docs").rglob("*.md")) if "```python\n" in page.read_text(encoding="utf-8") and page.name != "get.md"]


@pytest.mark.parametrize("page", PAGES, ids=[page.stem for page in PAGES])
def test_the_book(monkeypatch: pytest.MonkeyPatch, page: Path) -> None:
    monkeypatch.chdir(ROOT)
    text = page.read_text(encoding="utf-8")
    blocks = [block.split("```")[0] for block in text.split("```python\n")[1:]]
    assert len(blocks) > 10
    names: dict[str, object] = {}
    runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE)
    for number, block in enumerate(blocks):
        if ">>>" not in block:
            exec(block, names)
            continue
        test = doctest.DocTestParser().get_doctest(block, names, f"{page.name}, example {number}", None, None)
        runner.run(test, clear_globs=False)
        names = test.globs
    plt.close("all")
    assert runner.summarize().failed == 0


def test_the_lines_for_someone_who_has_the_wheel(capsys, monkeypatch, tmp_path):
    text = (ROOT / "docs" / "get.md").read_text(encoding="utf-8")
    (block,) = (part.split("```")[0] for part in text.split("```python\n")[1:])
    monkeypatch.chdir(tmp_path)
    exec(block, {})
    plt.close("all")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["own.png", "plane.png"]
    said = next(line for line in block.splitlines() if line.startswith("print(")).split("# ")[1]
    assert capsys.readouterr().out.strip() == said
