"""Case files: a body, its friction and its loads in engineers' units, and the answer."""

from __future__ import annotations

import copy
import json
import math
import os
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np

from . import _standfast
from ._modes import Mode

#: The keys whose value is the symbol of a mode.
_MODES_AT = ("mode", "first_mode")
_BY_SYMBOL = {mode.symbol: mode for mode in Mode}


class Figure(NamedTuple):
    """A figure of a case; a notebook shows it."""

    #: What it shows.
    title: str
    #: The SVG document.
    svg: str

    def _repr_svg_(self) -> str:
        return self.svg


class Answer(Mapping[str, Any]):
    """A part of an :class:`Assessment`: its JSON object, with the keys as attributes too.

    ``mode`` and ``first_mode`` are :class:`Mode` as attributes, and symbols as items, as in the JSON document.
    """

    _what = "this answer"

    def __init__(self, document: dict[str, Any]) -> None:
        self._document = document

    def __getitem__(self, key: str) -> Any:
        return self._document[key]

    def __iter__(self) -> Iterator[str]:
        return iter(self._document)

    def __len__(self) -> int:
        return len(self._document)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            value = self[name]
        except KeyError:
            raise AttributeError(f"{self._what} has no {name!r}; it has {', '.join(self)}", name=name, obj=self) from None
        if name in _MODES_AT:
            return _BY_SYMBOL.get(value)
        return Answer(value) if isinstance(value, dict) else value

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *(key for key in self if key.isidentifier())]

    def to_dict(self) -> dict[str, Any]:
        """The answer as plain dicts, lists, strings and numbers."""
        return copy.deepcopy(self._document)

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self._document!r})"


class Assessment(Answer):
    """The answer to a case: the program's, as text, figures and numbers.

    ``print`` shows the text. The keys of the JSON document are attributes: ``mode``, ``first_mode``,
    ``first_load_factor``, ``k_eff``, ``SF_sliding``, ... If the forces of the case are alternatives, each has an
    answer in :attr:`loads`; those of a single one are attributes of the assessment as well.
    """

    _what = "this assessment"

    def __init__(self, document: dict[str, Any], text: str, figures: list[Figure]) -> None:
        super().__init__(document)
        self._text = text
        #: The figures of the case.
        self.figures = figures

    def __getattr__(self, name: str) -> Any:
        loads = self._document.get("loads", []) if "_document" in self.__dict__ else []
        if not name.startswith("_") and name not in self._document and loads and name in loads[0]:
            if len(loads) == 1:
                return getattr(Answer(loads[0]), name)
            raise AttributeError(
                f"the case has {len(loads)} alternative loads; see loads[0].{name} and so on", name=name, obj=self
            )
        return super().__getattr__(name)

    @property
    def loads(self) -> list[Answer]:
        """The answers to the forces of the case, each an alternative to the others."""
        return [Answer(load) for load in self._document.get("loads", [])]

    def __str__(self) -> str:
        return self._text

    def __repr__(self) -> str:
        parts = [self._document] if "mode" in self._document else self._document.get("loads", [])
        modes = ", ".join(str(part.get("mode")) for part in parts)
        return f"<Assessment {self._document.get('title') or 'of a case'}: {modes}>"

    def _repr_svg_(self) -> str | None:
        return self.figures[0].svg if self.figures else None

    def __reduce__(self) -> Any:
        return Assessment, (self._document, self._text, self.figures)


def assess(case: str | os.PathLike[str] | Mapping[str, Any], *, up_to: float = 2.0) -> Assessment:
    """Assesses a body and its loads: water, uplift, waves, earthquakes, forces.

    Args:
        case: the path of a case file, or a dict with the same keys: ``{"body": {"width": "15 m", ...}, ...}``.
            Numbers with units are texts, as in the file.
        up_to: how far the path of a rising load is followed, in multiples of the load.

    Raises:
        ValueError: for a case that is not understood; the message shows where, and what is expected.
        OSError: if the file cannot be read.

    >>> block = {
    ...     "title": "Block",
    ...     "body": {"width": "1 m", "height": "2 m", "density": "2.4 t/m3", "friction": 0.7},
    ...     "load": [{"force": "20 kN/m", "elevation": "1.5 m"}],
    ... }
    >>> found = assess(block)
    >>> found
    <Assessment Block: RO>
    >>> found.mode, round(found.safety_factors.overturning, 4)
    (<Mode.ROCK_O: 2>, 0.7848)
    >>> found["loads"][0]["mode"], str(found).splitlines()[0]
    ('RO', 'Block')
    """
    up_to = float(up_to)
    if not 0 < up_to <= 1e6:
        raise ValueError(f"up_to is {up_to}; expected a load factor above zero, as 2")
    if isinstance(case, Mapping):
        name, text = "the case", _toml(case)
    else:
        name = os.fspath(case)
        with open(name, "rb") as file:
            content = file.read()
        try:
            text = content.decode("utf-8")
        except UnicodeDecodeError as error:
            line = 1 + content[: error.start].count(b"\n")
            raise ValueError(f"{name} is not UTF-8 text: line {line} has a byte that is no character") from None
    answer, document, figures = _standfast.assess(name, text, up_to)
    return Assessment(json.loads(document), answer, [Figure(words, svg) for words, _, svg in figures])


def _toml(case: Mapping[str, Any]) -> str:
    """A case given as a dict, as the text of a case file, which the errors about it then show."""
    lines: list[str] = []

    def table(path: str, content: Mapping[str, Any]) -> None:
        inner: list[tuple[str, Any]] = []
        for key, value in content.items():
            if not isinstance(key, str):
                raise ValueError(f"{path or 'the case'} has the key {key!r}; expected a text")
            is_tables = isinstance(value, (list, tuple)) and value and all(isinstance(part, Mapping) for part in value)
            if isinstance(value, Mapping) or is_tables:
                inner.append((key, value))
            else:
                where = f"{path}.{key}" if path else key
                lines.append(f"{_key(key)} = {_value(value, where)}")
        for key, value in inner:
            where = f"{path}.{_key(key)}" if path else _key(key)
            for part in [value] if isinstance(value, Mapping) else value:
                lines.append(f"[{where}]" if isinstance(value, Mapping) else f"[[{where}]]")
                table(where, part)

    table("", case)
    return "\n".join(lines) + "\n"


def _key(key: str) -> str:
    plain = key and all(letter.isascii() and (letter.isalnum() or letter in "-_") for letter in key)
    return key if plain else json.dumps(key)


def _value(value: Any, where: str) -> str:
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, str):
        # What JSON escapes, TOML escapes alike, but for the control character DEL.
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, (int, np.integer)):
        return str(int(value))
    if isinstance(value, (float, np.floating)):
        number = float(value)
        return repr(number) if math.isfinite(number) else {math.inf: "inf", -math.inf: "-inf"}.get(number, "nan")
    if isinstance(value, (list, tuple, np.ndarray)):
        return "[" + ", ".join(_value(part, f"{where}[{i}]") for i, part in enumerate(value)) + "]"
    raise ValueError(
        f"{where} is {value!r}, a {type(value).__name__}; expected a number, a text with a unit, true or false, "
        "a list or a dict"
    )
