"""Case files: a body, its friction and its loads in engineers' units, and the answer."""

from __future__ import annotations

import functools
import json
import math
import os
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _standfast
from ._advice import short, unit_of
from ._answer import Lazy, copied, parts, with_infinity
from ._figure import Figure, figures_of
from ._schema import attribute
from ._scipy_laws import is_distribution, law_of
from ._standfast import CaseError
from ._warnings import mind
from .answers import Document, OnlySituation, Situation

#: How many modes a representation lists.
_SHOWN = 8


class Assessment(Lazy, Document, OnlySituation):
    """The answer to a case: the program's, as text, figures and numbers.

    ``print`` shows the text. The keys of the JSON document, which ``docs/answer.schema.json`` describes, are attributes. The
    answer to each combination of a case, or to each of its forces that act alone, is one of :attr:`situations`; where there is
    only one, its keys are attributes of the assessment as well: ``mode``, ``departure``, ``load_factor``, ``SF_sliding``,
    ``k_eff``, ... ``met`` says whether all ``criteria`` of the case are met; it is ``None`` where the case has none.

    Text, figures and the document are made when they are first asked for. A pickle holds the case, which is answered anew where it
    is loaded.
    """

    _what = "this assessment"
    _case: tuple[str, str, float, bool]
    _answer: _standfast.CaseAnswer

    def __init__(self, name: str, text: str, up_to: float, all: bool) -> None:
        vars(self).update(_case=(name, text, up_to, all), _answer=_standfast.assess(name, text, up_to, all))

    @functools.cached_property
    def _own(self) -> dict[str, Any]:
        """The document."""
        document: dict[str, Any] = json.loads(self._answer.json(), object_hook=with_infinity)
        return document

    @functools.cached_property
    def _document(self) -> dict[str, Any]:  # type: ignore[override]
        """What there is under keys: the document and, of the only situation, its keys."""
        situations = self._own["situations"]
        return self._own if len(situations) > 1 else {**self._own, **{key: situations[0][key] for key in situations[0] if key not in self._own}}

    def to_dict(self) -> dict[str, Any]:
        """The document, as plain dicts, lists, strings and numbers."""
        document: dict[str, Any] = copied(self._own)
        return document

    @functools.cached_property
    def figures(self) -> list[Figure]:
        """The figures of the case. The item ``"figures"`` names the files of the program's, and is empty here."""
        return figures_of(self._answer)

    @functools.cached_property
    def situations(self) -> list[Situation]:
        """The answers to the combinations of the case, or to its forces that act alone; else one, to all loads."""
        return parts(Situation, self._document["situations"])

    @property
    def governing(self) -> Situation:
        """The worst situation; the item ``"governing"`` is its place among :attr:`situations`."""
        place: int = self._document["governing"]
        return self.situations[place]

    def _only(self) -> Situation:
        if len(self.situations) > 1:
            raise AttributeError
        return self.situations[0]

    def __getitem__(self, key: str) -> Any:
        if key not in self._document and (several := self._several(attribute(str(key)))):
            raise KeyError(several)
        return super().__getitem__(key)

    def _several(self, name: str) -> str | None:
        """What to say of a key of the only situation where there are several; ``None`` of all others."""
        if name.startswith("_") or not hasattr(OnlySituation, name):
            return None
        return (
            f"the case has {len(self.situations)} situations; see situations[0].{name} and so on, or governing.{name}, that of the "
            "worst one"
        )

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            # What a property of the only situation could not give comes here too.
            if several := self._several(name):
                raise AttributeError(several, name=name, obj=self)
            return super().__getattr__(name)

    def __dir__(self) -> list[str]:
        own = set(super().__dir__())
        return sorted(own if len(self.situations) == 1 else own - vars(OnlySituation).keys())

    def __repr__(self) -> str:
        modes = [situation["mode"] or "none" for situation in self._own["situations"]]
        shown = ", ".join(modes) if len(modes) <= _SHOWN else f"{len(modes)} situations"
        not_met = [criterion["name"] for criterion in self._own["criteria"] if not criterion["met"]]
        criteria = f"; not met: {', '.join(not_met)}" if not_met else "; criteria met" if self._own["met"] else ""
        # The same may be said of several numbers.
        slips = dict.fromkeys(warning["name"] for warning in self._own["warnings"])
        minded = f"; warnings: {', '.join(slips)}" if slips else ""
        return f"<Assessment {self._own['title'] or 'of a case'}: {shown}{criteria}{minded}>"

    def _repr_svg_(self) -> str | None:
        return self.figures[0].svg if self.figures else None

    def __reduce__(self) -> tuple[type[Assessment], tuple[str, str, float, bool]]:
        return Assessment, self._case


def assess(case: str | os.PathLike[str] | Mapping[str, object], *, up_to: float = 2.0, all: bool = False) -> Assessment:
    """Assesses a body and its loads: water, uplift, waves, earthquakes, forces.

    Args:
        case: the path of a case file, or a dict with the same keys: ``{"body": {"width": "15 m", ...}, ...}``.
            Numbers with units are texts, as in the file.
        up_to: how far the path of a rising load is followed, in multiples of the load, from 1 to a million.
        all: whether text and figures show every situation one by one; otherwise, of more than eight, the worst. The
            numbers are always those of all.

    Raises:
        CaseError: for a case that is not understood; the message shows where, and what is expected.
        OSError: if the file cannot be read.

    Warns:
        StandfastWarning: for each of the answer's ``warnings``, once from one line.

    >>> block = {
    ...     "title": "Block",
    ...     "body": {"width": "1 m", "height": "2 m", "density": "2.4 t/m3", "friction": 0.7},
    ...     "load": [{"force": "20 kN/m", "elevation": "1.5 m"}],
    ... }
    >>> found = assess(block)
    >>> found
    <Assessment Block: RO>
    >>> found.mode, round(found.SF_overturning_net, 4), found.departure, round(found.load_factor, 4)
    (<Mode.ROCK_O: 2>, 0.7848, 'at', 0.7848)
    >>> found["situations"][0]["mode"], str(found).splitlines()[0]
    ('RO', 'Block')
    """
    if not isinstance(all, (bool, np.bool_)):
        raise TypeError(f"all is {all!r}; expected True or False")
    found = Assessment(*case_text(case), up_to, bool(all))
    mind(found._answer.warnings())
    return found


def case_text(case: str | os.PathLike[str] | Mapping[str, object]) -> tuple[str, str]:
    """What errors call a case, and the text of its file."""
    if isinstance(case, Mapping):
        return "the case", _toml(case)
    if not isinstance(case, (str, os.PathLike)):
        raise TypeError(f"case is {case!r}, a {type(case).__name__}; expected the path of a case file, or a dict with the same keys")
    name = os.fspath(case)
    if isinstance(case, str) and "\n" in case:
        raise CaseError(f"case is {short(case)!r}, a text; expected the path of a case file, or a dict with the same keys: tomllib.loads(text)")
    try:
        with open(name, "rb") as file:
            content = file.read()
    except FileNotFoundError as error:
        if sys.version_info >= (3, 11) and Path(name).parts[:1] == ("examples",):
            error.add_note("standfast.examples() writes the examples into the folder examples")
        raise
    try:
        return name, content.decode("utf-8")
    except UnicodeDecodeError as error:
        line = 1 + content[: error.start].count(b"\n")
        raise CaseError(f"{name} is not UTF-8 text: line {line} has a byte that is not a character") from None


def _toml(case: Mapping[str, Any]) -> str:
    """A case given as a dict, as the text of a case file, which the errors about it then show."""
    lines: list[str] = []

    def table(path: str, content: Mapping[str, Any]) -> None:
        inner: list[tuple[str, Any]] = []
        for key, value in content.items():
            if not isinstance(key, str):
                raise CaseError(f"{path or 'the case'} has the key {key!r}; expected a text")
            if is_distribution(value):
                value = law_of(value, f"{path}.{key}" if path else key)
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
    if (unit := unit_of(value)) is not None:
        raise CaseError(f"{where} is {unit}; expected a text with its unit, as \"15 {unit.words}\"")
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value.item()
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
    raise CaseError(
        f"{where} is {value!r}, a {type(value).__name__}; expected a number, a text with a unit, true or false, "
        "a list or a dict"
    )
