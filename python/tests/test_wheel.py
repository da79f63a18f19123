"""What is installed: licences, metadata, and nothing that belongs to the machine it was built on."""

from __future__ import annotations

import re
import subprocess
import sys
import tarfile
from importlib import metadata
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
LICENSES = {
    "LICENSE-MIT": ROOT / "LICENSE-MIT",
    "LICENSE-APACHE": ROOT / "LICENSE-APACHE",
    # Of the letters in figures and sheets.
    "LICENSE-OFL-STIX": ROOT / "crates" / "figures" / "fonts" / "OFL.txt",
}


def test_licences_are_in_the_wheel() -> None:
    found = metadata.distribution("standfast")
    files = {file.name: file for file in found.files or [] if "licenses" in file.parts}
    assert files.keys() == LICENSES.keys() == set(found.metadata.get_all("License-File") or [])
    for name, original in LICENSES.items():
        assert files[name].read_text(encoding="utf-8") == original.read_text(encoding="utf-8"), name
    assert found.metadata["License-Expression"] == "(MIT OR Apache-2.0) AND OFL-1.1"
    # The fonts of the calculation sheet are of the same family under the same licence.
    assert (ROOT / "crates" / "sheet" / "fonts" / "OFL.txt").read_bytes() == LICENSES["LICENSE-OFL-STIX"].read_bytes()


def test_metadata() -> None:
    found = metadata.metadata("standfast")
    assert found["Name"] == "standfast" and found["Summary"].endswith("?")
    assert found["Version"] == metadata.version("standfast") == __import__("standfast").__version__
    classifiers = found.get_all("Classifier") or []
    versions = [int(one.rpartition(".")[2]) for one in classifiers if re.fullmatch(r"Programming Language :: Python :: 3\.\d+", one)]
    assert found["Requires-Python"] == f">=3.{min(versions)}" and sys.version_info[1] in versions
    assert not any(one.startswith("License ::") for one in classifiers), "PEP 639 puts the licence in License-Expression"
    assert set(found.get_all("Provides-Extra") or []) >= {"plot"}
    text = found.as_string()
    # What a registry shows leads nowhere that only this checkout has.
    assert not re.search(r"/home/|/root/|/tmp/|file:|\]\((?!https?://)", text)


def test_the_native_module_is_of_the_stable_interface_and_no_source_is_beside_it() -> None:
    files = metadata.files("standfast") or []
    wheel = next(file for file in files if file.name == "WHEEL").read_text()
    assert "Tag: cp310-abi3-" in wheel
    assert not any(file.parts[0] == "standfast" and file.name.endswith((".rs", ".toml", ".lock")) for file in files)


def test_a_source_distribution_has_all_that_a_build_needs(tmp_path: Path) -> None:
    pytest.importorskip("maturin")
    made = subprocess.run(
        [sys.executable, "-m", "maturin", "sdist", "--out", tmp_path, "--manifest-path", ROOT / "python" / "Cargo.toml"],
        capture_output=True, text=True,
    )  # fmt: skip
    assert made.returncode == 0, made.stderr
    with tarfile.open(next(tmp_path.glob("*.tar.gz"))) as archive:
        names = {name.partition("/")[2] for name in archive.getnames()}
        archive.extractall(tmp_path / "source", **({"filter": "data"} if sys.version_info >= (3, 12) else {}))
    made_by_the_build = {"build_backend.py", "python/standfast/answer.schema.json", "python/standfast/answers.pyi"}
    assert {*LICENSES, "README.md", "pyproject.toml", "Cargo.lock", "python/standfast/py.typed", *made_by_the_build} <= names
    source = next((tmp_path / "source").iterdir())
    # Cargo finds every crate of the package in it.
    tree = subprocess.run(
        ["cargo", "metadata", "--offline", "--format-version", "1", "--manifest-path", source / "python" / "Cargo.toml"],
        capture_output=True, text=True,
    )  # fmt: skip
    assert tree.returncode == 0, tree.stderr
