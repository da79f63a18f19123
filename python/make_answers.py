"""Writes python/python/standfast/answers.py, the classes of the parts of an answer, from docs/answer.schema.json.

    python python/make_answers.py

python/tests/test_schema.py holds that the file is what this gives.
"""

from __future__ import annotations

import json
import keyword
import textwrap
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[1]
SCHEMA = ROOT / "docs/answer.schema.json"
FILE = ROOT / "python/python/standfast/answers.py"

#: What is no class of its own.
PLAIN = {"number-or-infinite": "float", "mode": "Mode", "modes": "Modes"}
#: Classes that would have the name of one of Python's.
NAMES = {"warning": "CaseWarning"}
#: Keys of the document for which `Assessment` has something of its own.
OWN = ("governing", "situations", "figures")
#: Classes of which lists are given under their modes.
KEYED = ("Chance", "DesignPoint")
TYPES = {"number": "float", "integer": "int", "string": "str", "boolean": "bool", "null": "None"}

HEADER = '''\
"""The parts of an answer: classes with a property for each key of the JSON document that ``docs/answer.schema.json`` describes.

Units are SI; forces, masses and moments are per metre run or, of an object of a given length or a cylinder, of the whole: see
:attr:`Document.extent`. ``None`` says that there is no such thing; a number without bound is ``math.inf``.
"""

# Made by python/make_answers.py; changes go into docs/answer.schema.json.
# mypy: disable-error-code="no-any-return"

from __future__ import annotations

from typing import Literal

from ._answer import Answer, mode, modes, modes_or, part, parts
from ._modes import Mode, Modes
'''


def class_name(definition: str) -> str:
    return NAMES.get(definition, definition.title().replace("-", ""))


def kind(schema: dict[str, Any]) -> tuple[str, str]:
    """The type of a value, and what makes it of `{}`, the value in JSON."""
    if "$ref" in schema:
        name = schema["$ref"].rsplit("/", 1)[1]
        if "properties" in schema:
            return "Report", "part(Report, {})"
        if name in PLAIN:
            return PLAIN[name], {"Mode": "mode({})", "Modes": "modes({})"}.get(PLAIN[name], "{}")
        return class_name(name), f"part({class_name(name)}, {{}})"
    if "anyOf" in schema:
        kinds = [kind(option) for option in schema["anyOf"]]
        made = [how for _, how in kinds if how != "{}"]
        names = " | ".join(name for name, _ in kinds)
        if not made:
            return names, "{}"
        if len(kinds) == 2 and kinds[1][0] == "None":
            return names, f"None if {{}} is None else {made[0]}"
        assert made == ["modes({})"], schema
        return names, "modes_or({})"
    if "const" in schema:
        return f"Literal[{schema['const']!r}]", "{}"
    if "enum" in schema:
        words = [word for word in schema["enum"] if word is not None]
        literal = f"Literal[{', '.join(json.dumps(word, ensure_ascii=False) for word in words)}]"
        return literal + (" | None" if None in schema["enum"] else ""), "{}"
    types = schema["type"] if isinstance(schema["type"], list) else [schema["type"]]
    if types == ["array"]:
        items = schema.get("items") or schema["prefixItems"][0]
        name, how = kind(items if items is not False else schema["prefixItems"][0])
        made = how.removeprefix("part(").split(",")[0]
        if name in KEYED:
            return f"ByMode[{name}]", f"by_mode({made}, {{}})"
        # A list is given as a copy.
        return f"list[{name}]", f"parts({made}, {{}})" if how.startswith("part(") else "list({})"
    if types == ["object"]:
        name, _ = kind(schema["additionalProperties"])
        return f"dict[str, {name}]", "dict({})"
    return " | ".join(TYPES[name] for name in types), "{}"


def sentence(words: str) -> str:
    """Words of the schema as those of Python."""
    words = words.replace("`", "``")
    words = words[0].upper() + words[1:] if not words[:2].isupper() and words[1:2].isalpha() else words
    words = " ".join("None" if word == "null" else word for word in words.split(" "))
    return words if words.endswith(".") else words + "."


def docstring(words: str, indent: str) -> list[str]:
    wrapped = textwrap.wrap(f'"""{words}"""', 130 - len(indent), break_long_words=False, break_on_hyphens=False)
    return [indent + line for line in wrapped]


def signature(name: str, of: str) -> list[str]:
    line = f"    def {name}(self) -> {of}:"
    if len(line) <= 130 or not of.startswith("Literal["):
        return [line]
    words, rest = of.removeprefix("Literal[").split("]", 1)
    inner = textwrap.wrap(words, 118, initial_indent=" " * 8, subsequent_indent=" " * 8, break_on_hyphens=False)
    return [f"    def {name}(", "        self,", "    ) -> Literal[", *inner, f"    ]{rest}:"]


def prop(key: str, schema: dict[str, Any], value: str | None = None) -> list[str]:
    name = f"{key}_" if keyword.iskeyword(key) else key
    of, how = kind(schema)
    given = value or how.replace("{}", f"self._document[{json.dumps(key)}]")
    return ["", "    @property", *signature(name, of), *docstring(sentence(schema["description"]), " " * 8), f"        return {given}"]


def answer_class(name: str, base: str, words: str, properties: dict[str, Any]) -> list[str]:
    lines = ["", "", f"class {name}({base}):", *docstring(sentence(words), "    ")]
    for key, schema in properties.items():
        lines += prop(key, schema)
    return lines


def made() -> str:
    """The file."""
    schema = json.loads(SCHEMA.read_text(encoding="utf-8"))
    definitions = schema["$defs"]
    lines = []
    for name, definition in definitions.items():
        if name not in PLAIN:
            lines += answer_class(class_name(name), "Answer", definition["description"], definition["properties"])
    situation = definitions["situation"]["properties"]
    report = situation["report"]
    lines += answer_class("Report", "Point", report["description"], report["anyOf"][0]["properties"])
    own = {key: said for key, said in schema["properties"].items() if key not in OWN}
    lines += answer_class("Document", "Answer", "the answer to a case", own)
    lines += [
        "",
        "",
        "class OnlySituation:",
        *docstring("What a case with one situation says of it: the properties of that :class:`Situation`.", "    "),
        "",
        "    def _only(self) -> Situation:",
        '        """The situation; an ``AttributeError`` if there are several."""',
        "        raise NotImplementedError",
    ]
    for key, said in situation.items():
        if key not in schema["properties"]:
            name = f"{key}_" if keyword.iskeyword(key) else key
            lines += prop(key, said, f"self._only().{name}")
    names = sorted(line.removeprefix("class ").split("(")[0].rstrip(":") for line in lines if line.startswith("class "))
    exported = ["", "__all__ = [", *(f'    "{name}",' for name in names if name != "OnlySituation"), "]"]
    return HEADER + "\n".join([*exported, *lines]) + "\n"


if __name__ == "__main__":
    FILE.write_text(made(), encoding="utf-8")
