"""What all parts of an answer have in common: a JSON object, read as a mapping or by typed attributes."""

from __future__ import annotations

import copy
import keyword
import math
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, TypeVar

from ._modes import BY_SYMBOL, Mode, Modes

#: The keys of what a user wrote, which may be any word.
_WRITTEN = ("title", "note", "name")



def attribute(key: str) -> str:
    """The attribute for a key: the key itself, or with an underscore where it is a word of Python's."""
    return f"{key}_" if keyword.iskeyword(key) else key


def with_infinity(part: dict[str, Any]) -> dict[str, Any]:
    """A JSON object with numbers without bound as such."""
    return {key: math.inf if value == "infinite" and key not in _WRITTEN else value for key, value in part.items()}


class Answer(Mapping[str, Any]):
    """A part of an answer: its JSON object, with the keys as attributes too.

    Items are as in the JSON document, but for numbers without bound, which are ``math.inf``; ``None`` says that there is
    no such thing. Attributes are the same, with modes as :class:`~standfast.Mode`, sets of modes as :class:`~standfast.Modes`, and
    objects as classes of :mod:`standfast.answers`. Where a key is a word of Python's, the attribute ends in an underscore:
    ``lambda_``, ``from_``.
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

    if not TYPE_CHECKING:  # A type checker is to know the attributes there are, and no others.

        def __getattr__(self, name: str) -> Any:
            if name.startswith("_"):
                raise AttributeError(name)
            names = ", ".join(attribute(key) for key in self)
            raise AttributeError(f"{self._what} has no {name!r}; it has {names}", name=name, obj=self)

    def to_dict(self) -> dict[str, Any]:
        """The answer as plain dicts, lists, strings and numbers."""
        return copy.deepcopy(self._document)

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self._document!r})"


_A = TypeVar("_A", bound=Answer)


def part(kind: type[_A], document: Any) -> _A:
    """An object as a class."""
    return kind(document)


def parts(kind: type[_A], documents: Any) -> list[_A]:
    """A list of objects as a class."""
    return [kind(document) for document in documents]


def mode(symbol: str) -> Mode:
    """A mode by its symbol."""
    return BY_SYMBOL[symbol]


def modes(symbols: list[str]) -> Modes:
    """A set of modes by their symbols."""
    return Modes.of(*map(mode, symbols))


def modes_or(value: Any) -> Any:
    """A set of modes, where it is one."""
    return modes(value) if isinstance(value, list) else value
