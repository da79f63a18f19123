"""Writes python/python/standfast/designs.py, the classes of the parts of designs, from docs/design.schema.json and
docs/boundary.schema.json.

    python python/make_designs.py

python/tests/test_design.py holds that the file is what this gives.
"""

from __future__ import annotations

import json
from typing import Any

from make_answers import ROOT, answer_class

FILE = ROOT / "python/python/standfast/designs.py"
SCHEMAS = {name: json.loads((ROOT / "docs" / name).read_text(encoding="utf-8")) for name in (
    "answer.schema.json", "design.schema.json", "boundary.schema.json"
)}
#: The classes, with where their schemas are, and what is said of them.
CLASSES = [
    ("Present", "design.schema.json", "#/$defs/present", None),
    ("Found", "design.schema.json", "#/$defs/found", None),
    ("End", "design.schema.json", "#/$defs/end", None),
    ("Stretch", "design.schema.json", "#/$defs/stretch", None),
    ("Sensitivity", "design.schema.json", "#/$defs/sensitivity", None),
    ("DesignDocument", "design.schema.json", "#", "what ``design`` answers with one quantity"),
    ("Quantity", "boundary.schema.json", "#/$defs/quantity", None),
    ("Column", "boundary.schema.json", "#/$defs/column", None),
    ("BoundaryDocument", "boundary.schema.json", "#", "what ``design`` answers with two quantities"),
]
HEADER = '''\
"""The parts of a design: classes with a property for each key of the JSON documents that ``docs/design.schema.json`` and
``docs/boundary.schema.json`` describe.

Units are SI; forces and masses are per metre run or, of a single object, of the whole. ``None`` says that there is no such thing;
a number without bound is ``math.inf``.
"""

# Made by python/make_designs.py; changes go into the schemas.
# mypy: disable-error-code="no-any-return"

from __future__ import annotations

from typing import Literal

from ._answer import Answer, mode, part, parts
from ._modes import Mode
'''


def found(file: str, pointer: str) -> Any:
    """What stands at a place of a schema."""
    part = SCHEMAS[file]
    for key in pointer.removeprefix("#").strip("/").split("/") if pointer != "#" else []:
        part = part[key]
    return part


def resolved(file: str, schema: dict[str, Any]) -> dict[str, Any]:
    """A schema in which only classes of ours and definitions of answers are referred to."""
    schema = dict(schema)
    for key in ("items", "anyOf", "prefixItems"):
        if isinstance(schema.get(key), list):
            schema[key] = [resolved(file, part) for part in schema[key]]
        elif isinstance(schema.get(key), dict):
            schema[key] = resolved(file, schema[key])
    if "$ref" not in schema:
        return schema
    other, pointer = schema["$ref"].split("#")
    other, pointer = other or file, f"#{pointer}"
    own = next((name for name, of, at, _ in CLASSES if (of, at) == (other, pointer)), None)
    if own is not None:
        return {**schema, "$ref": f"#/$defs/{own.lower()}"}
    if other == "answer.schema.json" and pointer.startswith("#/$defs/") and pointer.count("/") == 2:
        return {**schema, "$ref": pointer}
    return resolved(other, {**found(other, pointer), **{key: said for key, said in schema.items() if key != "$ref"}})


def made() -> str:
    """The file."""
    lines = []
    for name, file, pointer, words in CLASSES:
        schema = found(file, pointer)
        said = {key: resolved(file, part) for key, part in schema["properties"].items()}
        lines += answer_class(name, "Answer", words or schema["description"], said)
    names = sorted(name for name, *_ in CLASSES)
    return HEADER + "\n".join(["", "__all__ = [", *(f'    "{name}",' for name in names), "]", *lines]) + "\n"


if __name__ == "__main__":
    FILE.write_text(made(), encoding="utf-8")
