"""Builds the package with maturin, after putting beside its modules what docs/*.schema.json are the source of: the schemas, which
give the classes of answers their keys and words when they are imported, and stubs of these classes for editors and type checkers.

A source distribution has both already. `python python/build_backend.py` writes them without a build.
"""

from __future__ import annotations

import importlib.util
import shutil
import sys
import textwrap
from pathlib import Path
from typing import Any

PACKAGE = Path(__file__).parent / "python/standfast"
SCHEMAS = Path(__file__).parents[1] / "docs"

HEADER = """\
from typing import Literal

from ._answer import Answer, ByMode
from ._modes import Mode, Modes
"""


def schema_module() -> Any:
    """The module that reads the schemas, without the package, which cannot be imported before it is built."""
    name = "standfast_schema"
    if name not in sys.modules:
        spec = importlib.util.spec_from_file_location(name, PACKAGE / "_schema.py")
        assert spec and spec.loader
        sys.modules[name] = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(sys.modules[name])
    return sys.modules[name]


def stub(module: str) -> str:
    """The stub of a module."""
    schema = schema_module()
    found = list(schema.classes(module))
    of_answers = {"answers": (), "stacks": ("BodyMotion", "JointMotion")}.get(module, ("Summary",))
    header = HEADER + "".join(f"\nfrom .answers import {name} as {name}" for name in of_answers)
    lines = [header, f"__all__ = {sorted(one.name for one in found)}"]
    for one in found:
        lines += ["", f"class {one.name}({one.base}):", _docstring(one.words, 4), *_properties(one.keys)]
    if module == "answers":
        lines += ["", "class OnlySituation:", "    def _only(self) -> Situation: ...", *_properties(schema.only_situation())]
    return "\n".join(lines) + "\n"


def _properties(keys: list[Any]) -> list[str]:
    lines = []
    for key in keys:
        lines += ["    @property", f"    def {key.name}(self) -> {key.type}:", _docstring(key.words, 8)]
    return lines


def _docstring(words: str, indent: int) -> str:
    wrapped = textwrap.wrap(f'"""{words}"""', 130 - indent, break_long_words=False, break_on_hyphens=False)
    return textwrap.indent("\n".join(wrapped), " " * indent)


def write() -> None:
    """Writes schemas and stubs."""
    for schema in sorted(SCHEMAS.glob("*.schema.json")):
        shutil.copyfile(schema, PACKAGE / schema.name)
    for module in schema_module().MODULES:
        (PACKAGE / f"{module}.pyi").write_text(stub(module), encoding="utf-8")


if __name__ == "__main__":
    write()
else:
    from maturin import *  # noqa: F403
    from maturin import build_editable as _editable
    from maturin import build_sdist as _sdist
    from maturin import build_wheel as _wheel

    def build_wheel(*given: Any, **named: Any) -> Any:
        write()
        return _wheel(*given, **named)

    def build_sdist(*given: Any, **named: Any) -> Any:
        write()
        return _sdist(*given, **named)

    def build_editable(*given: Any, **named: Any) -> Any:
        write()
        return _editable(*given, **named)
