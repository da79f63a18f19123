"""The classes of the parts of an answer, as the JSON schemas beside this file describe them: their names, keys, types and words.

It takes nothing from the package: the build reads it to write stubs, before there is a native module.
"""

from __future__ import annotations

import functools
import json
import keyword
from collections.abc import Iterator, Set
from pathlib import Path
from typing import Any, NamedTuple

#: Of each module, its schemas: the class of the whole document, and what is said of it.
MODULES = {
    "answers": {"answer": ("Document", "the answer to a case")},
    "designs": {
        "design": ("DesignDocument", "what `design` answers with one quantity"),
        "boundary": ("BoundaryDocument", "what `design` answers with two quantities"),
        "minimum": ("MinimumDocument", "what `design` answers with `minimise`"),
    },
    "simulations": {
        "simulate": ("MotionDocument", "what `simulate` answers in one situation of a case"),
        "spectrum": ("SpectrumDocument", "what `spectrum` answers"),
    },
    "chances": {"probability": ("ProbabilityDocument", "what `probability` answers")},
    "plans": {"directions": ("DirectionsDocument", "what `directions` answers")},
    "stacks": {"stack": ("StackDocument", "what `stack` answers")},
}
#: Keys of documents for which the package has something of its own.
_OWN = {"Document": ("governing", "situations", "figures"), "SpectrumDocument": ("figures", "points"), "DirectionsDocument": ("figures", "situations")}
#: Definitions that are not classes.
_PLAIN = {"number-or-infinite": "float", "mode": "Mode", "modes": "Modes"}
#: Classes that are not called after their definitions.
_NAMES = {"warning": "CaseWarning", "departure": "FirstDeparture"}
#: Classes of which lists are given under their modes.
_KEYED = ("Chance", "DesignPoint")
_TYPES = {"number": "float", "integer": "int", "string": "str", "boolean": "bool", "null": "None"}

_Schema = dict[str, Any]


class Key(NamedTuple):
    """A key of a document."""

    #: Its key in JSON, and that of the class that the value is or has.
    key: str
    part: str
    #: Its type, as Python writes it, and its words.
    type: str
    words: str

    @property
    def name(self) -> str:
        """The attribute: the key itself, or with an underscore where it is a word of Python's."""
        return attribute(self.key)


class Class(NamedTuple):
    """A class of a part of an answer."""

    name: str
    base: str
    words: str
    keys: list[Key]


def attribute(key: str) -> str:
    """The attribute for a key: the key itself, or with an underscore where it is a word of Python's."""
    return f"{key}_" if keyword.iskeyword(key) else key


def classes(module: str) -> Iterator[Class]:
    """The classes of a module."""
    for file, (document, words) in MODULES[module].items():
        schema = _file(file)
        for name, part in schema["$defs"].items() if file != "spectrum" else ():
            if "properties" in part:
                absent = part["properties"].keys() - set(part["required"])
                yield _class(file, _class_name(name), "Answer", part["description"], part["properties"], absent)
        if module == "answers":
            report = schema["$defs"]["situation"]["properties"]["report"]
            yield _class(file, "Report", "Point", report["description"], report["anyOf"][0]["properties"])
        own = _OWN.get(document, ("figures",))
        yield _class(file, document, "Answer", words, {key: part for key, part in schema["properties"].items() if key not in own})


def only_situation() -> list[Key]:
    """The keys of a situation that an answer has of its only one."""
    situation = next(found for found in classes("answers") if found.name == "Situation")
    return [key for key in situation.keys if key.key not in _file("answer")["properties"]]


@functools.cache
def _file(name: str) -> _Schema:
    schema: _Schema = json.loads(Path(__file__).with_name(f"{name}.schema.json").read_text(encoding="utf-8"))
    return schema


def _class(file: str, name: str, base: str, words: str, properties: dict[str, _Schema], absent: Set[str] = frozenset()) -> Class:
    """A class; the keys that may be absent are None then."""
    keys = [_key(file, key, schema) for key, schema in properties.items()]
    perhaps = [key.key in absent and not key.type.endswith("| None") for key in keys]
    keys = [key._replace(type=f"{key.type} | None") if add else key for key, add in zip(keys, perhaps, strict=True)]
    return Class(name, base, _sentence(words), keys)


def _class_name(definition: str) -> str:
    return _NAMES.get(definition, definition.title().replace("-", ""))


def _key(file: str, key: str, schema: _Schema) -> Key:
    kind, part = _type(file, schema)
    while "description" not in schema:
        file, schema = _referred(file, schema["$ref"])
    return Key(key, part, kind, _sentence(schema["description"]))


def _referred(file: str, reference: str) -> tuple[str, _Schema]:
    """The file and the schema that a reference is to."""
    other, _, pointer = reference.partition("#")
    file = other.removesuffix(".schema.json") or file
    schema = _file(file)
    for key in pointer.split("/")[1:]:
        schema = schema[key]
    return file, schema


def _type(file: str, schema: _Schema) -> tuple[str, str]:
    """The type of a value, and the class that is in it, if one is."""
    if "$ref" in schema:
        name = schema["$ref"].partition("#")[2].removeprefix("/$defs/")
        if name in _PLAIN:
            return _PLAIN[name], ""
        if "properties" in schema:
            return "Report", "Report"
        other, found = _referred(file, schema["$ref"])
        if "properties" not in found:
            return _type(other, found)
        of = _class_name(name) if name else next(module[other][0] for module in MODULES.values() if other in module)
        return of, of
    if "anyOf" in schema:
        options = [_type(file, option) for option in schema["anyOf"]]
        return " | ".join(kind for kind, _ in options), "".join(part for _, part in options)
    if "const" in schema:
        return f"Literal[{schema['const']!r}]", ""
    if "enum" in schema:
        words = ", ".join(json.dumps(word, ensure_ascii=False) for word in schema["enum"] if word is not None)
        return f"Literal[{words}]" + (" | None" if None in schema["enum"] else ""), ""
    types = schema["type"] if isinstance(schema["type"], list) else [schema["type"]]
    if types == ["array"]:
        kind, part = _type(file, schema.get("items") or schema["prefixItems"][0])
        return f"ByMode[{kind}]" if kind in _KEYED else f"list[{kind}]", part
    if types == ["object"]:
        return f"dict[str, {_type(file, schema['additionalProperties'])[0]}]", ""
    return " | ".join(_TYPES[name] for name in types), ""


def _sentence(words: str) -> str:
    """Words of the schema as those of Python."""
    words = words.replace("`", "``")
    first = words.split(" ")[0]
    if first == "a" or (len(first) > 1 and first.rstrip(",;:").isalpha() and first.islower()):
        words = words[0].upper() + words[1:]
    words = " ".join("None" if word == "null" else word for word in words.split(" "))
    return words if words.endswith(".") else words + "."
