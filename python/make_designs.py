"""Writes the classes of the parts of designs, motions and probabilities, python/python/standfast/designs.py, motions.py and chances.py,
from docs/*.schema.json.

    python python/make_designs.py

python/tests/test_schema.py holds that the files are what this gives.
"""

from __future__ import annotations

import json
import re
from typing import Any, NamedTuple

from make_answers import ROOT, answer_class

PACKAGE = ROOT / "python/python/standfast"
SCHEMAS = {path.name: json.loads(path.read_text(encoding="utf-8")) for path in sorted((ROOT / "docs").glob("*.schema.json"))}


class File(NamedTuple):
    """A file of classes."""

    #: What it says of itself.
    words: str
    #: What it takes from beside it.
    imports: tuple[str, ...]
    #: The classes, with where their schemas are, and what is said of them, if not by the schema.
    classes: tuple[tuple[str, str, str, str | None], ...]


FILES = {
    "designs.py": File(
        """The parts of a design: classes with a property for each key of the JSON documents that ``docs/design.schema.json`` and
``docs/boundary.schema.json`` describe.

Units are SI; forces and masses are per metre run or, of a single object, of the whole. ``None`` says that there is no such thing;
a number without bound is ``math.inf``.
""",
        ("from typing import Literal", "", "from ._answer import Answer, mode, part, parts", "from ._modes import Mode"),
        (
            ("Present", "design.schema.json", "#/$defs/present", None),
            ("Found", "design.schema.json", "#/$defs/found", None),
            ("End", "design.schema.json", "#/$defs/end", None),
            ("Stretch", "design.schema.json", "#/$defs/stretch", None),
            ("Sensitivity", "design.schema.json", "#/$defs/sensitivity", None),
            ("DesignDocument", "design.schema.json", "#", "what `design` answers with one quantity"),
            ("Quantity", "boundary.schema.json", "#/$defs/quantity", None),
            ("Column", "boundary.schema.json", "#/$defs/column", None),
            ("BoundaryDocument", "boundary.schema.json", "#", "what `design` answers with two quantities"),
        ),
    ),
    "motions.py": File(
        """The parts of a motion in time: classes with a property for each key of the JSON document that ``docs/simulate.schema.json``
describes, and of that of ``docs/spectrum.schema.json``.

Units are SI; those of a case with a ``[block]`` are its own. ``None`` says that there is no such thing.
""",
        ("from typing import Literal", "", "from ._answer import Answer, mode, modes, parts", "from ._modes import Mode, Modes"),
        (
            ("Requirement", "simulate.schema.json", "#/$defs/requirement", None),
            ("Moment", "simulate.schema.json", "#/$defs/moment", None),
            ("Note", "simulate.schema.json", "#/$defs/note", None),
            ("MotionDocument", "simulate.schema.json", "#", "what `simulate` answers in one situation of a case"),
            ("SpectrumDocument", "spectrum.schema.json", "#", "what `spectrum` answers"),
        ),
    ),
    "chances.py": File(
        """The parts of an answer in probabilities: classes with a property for each key of the JSON document that
``docs/probability.schema.json`` describes. ``None`` says that there is no such thing.
""",
        ("from typing import Literal", "", "from ._answer import Answer, ByMode, by_mode, part, parts"),
        (
            ("Random", "probability.schema.json", "#/$defs/random", None),
            ("Interval", "probability.schema.json", "#/$defs/interval", None),
            ("Chance", "probability.schema.json", "#/$defs/chance", None),
            ("Importance", "probability.schema.json", "#/$defs/importance", None),
            ("DesignPoint", "probability.schema.json", "#/$defs/design-point", None),
            ("FirstDeparture", "probability.schema.json", "#/$defs/departure", None),
            ("Life", "probability.schema.json", "#/$defs/life", None),
            ("Quantile", "probability.schema.json", "#/$defs/quantile", None),
            ("Exceeded", "probability.schema.json", "#/$defs/exceeded", None),
            ("AtPeak", "probability.schema.json", "#/$defs/at-peak", None),
            ("Followed", "probability.schema.json", "#/$defs/followed", None),
            ("Rotating", "probability.schema.json", "#/$defs/rotating", None),
            ("Sliding", "probability.schema.json", "#/$defs/sliding", None),
            ("Joined", "probability.schema.json", "#/$defs/joined", None),
            ("ChanceCriterion", "probability.schema.json", "#/$defs/chance-criterion", None),
            ("Along", "probability.schema.json", "#/$defs/along", None),
            ("Fit", "probability.schema.json", "#/$defs/fit", None),
            ("Overturning", "probability.schema.json", "#/$defs/overturning", None),
            ("Fragility", "probability.schema.json", "#/$defs/fragility", None),
            ("Chances", "probability.schema.json", "#/$defs/chances", None),
            ("ProbabilityDocument", "probability.schema.json", "#", "what `probability` answers"),
        ),
    ),
}
MADE = '''\
# Made by python/make_designs.py; changes go into the schemas.
# mypy: disable-error-code="no-any-return"

from __future__ import annotations
'''
#: Keys of a document for which there is something else.
OWN = {"MotionDocument": ("figures",), "SpectrumDocument": ("figures", "points"), "ProbabilityDocument": ("figures",)}
#: The classes of all of them.
CLASSES = [place for file in FILES.values() for place in file.classes]


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
        name = re.sub("(?<=.)(?=[A-Z])", "-", own).lower()
        return {**schema, "$ref": f"#/$defs/{name}"}
    if other == "answer.schema.json" and pointer.startswith("#/$defs/") and pointer.count("/") == 2:
        return {**schema, "$ref": pointer}
    return resolved(other, {**found(other, pointer), **{key: said for key, said in schema.items() if key != "$ref"}})


def made(name: str) -> str:
    """A file."""
    file, lines = FILES[name], []
    for of, schema_of, pointer, words in file.classes:
        schema = found(schema_of, pointer)
        said = {key: resolved(schema_of, part) for key, part in schema["properties"].items() if key not in OWN.get(of, ())}
        lines += answer_class(of, "Answer", words or schema["description"], said)
    names = sorted(of for of, *_ in file.classes)
    header = f'"""{file.words}"""\n\n{MADE}\n' + "\n".join(file.imports) + "\n"
    return header + "\n".join(["", "__all__ = [", *(f'    "{of}",' for of in names), "]", *lines]) + "\n"


if __name__ == "__main__":
    for name in FILES:
        (PACKAGE / name).write_text(made(name), encoding="utf-8")
