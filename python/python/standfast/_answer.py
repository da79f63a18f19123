"""What all parts of an answer have in common: a JSON object, read as a mapping or by typed attributes."""

from __future__ import annotations

import functools
import json
import math
from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Any, TypeVar

from . import _schema, _standfast
from ._modes import BY_SYMBOL, Mode, Modes
from ._schema import Key, attribute

#: The keys of what a user wrote, which may be any word.
_WRITTEN = ("title", "note", "name")
#: How many characters a representation takes.
_LINE = 100


def with_infinity(part: dict[str, Any]) -> dict[str, Any]:
    """A JSON object with numbers without bound as such."""
    return {key: math.inf if value == "infinite" and key not in _WRITTEN else value for key, value in part.items()}


class Answer(Mapping[str, Any]):
    """A part of an answer: its JSON object, with the keys as attributes too. It cannot be changed.

    Items are as in the JSON document, but for numbers without bound, which are ``math.inf``; ``None`` says that there is
    no such thing. Attributes are the same, with modes as :class:`~standfast.Mode`, sets of modes as :class:`~standfast.Modes`, and
    objects as classes of :mod:`standfast.answers`. Where a key is a word of Python's, the attribute ends in an underscore:
    ``lambda_``, ``from_``. Lists and dicts are given as copies.
    """

    _what = "this answer"
    _document: dict[str, Any]

    def __init__(self, document: dict[str, Any]) -> None:
        vars(self)["_document"] = document

    def __getitem__(self, key: str) -> Any:
        try:
            return copied(self._document[key])
        except KeyError:
            near = _standfast.closest(str(key), list(self))
            meant = f"did you mean {near!r}? Its keys are" if near is not None else "its keys are"
            raise KeyError(f"{self._what} has no {key!r}; {meant} {', '.join(self)}") from None

    def __contains__(self, key: object) -> bool:
        return key in self._document

    def __iter__(self) -> Iterator[str]:
        return iter(self._document)

    def __len__(self) -> int:
        return len(self._document)

    def _ipython_key_completions_(self) -> list[str]:
        return list(self)

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"{self._what} cannot be changed; to_dict() is a copy that can", name=name, obj=self)

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"{self._what} cannot be changed; to_dict() is a copy that can", name=name, obj=self)

    if not TYPE_CHECKING:  # A type checker is to know the attributes there are, and no others.

        def __getattr__(self, name: str) -> Any:
            if name.startswith("_"):
                raise AttributeError(name)
            names = [attribute(key) for key in self]
            near = _standfast.closest(name, names)
            meant = f"did you mean {near!r}? It" if near is not None else "it"
            raise AttributeError(f"{self._what} has no {name!r}; {meant} has {', '.join(names)}", name=name, obj=self)

    def to_dict(self) -> dict[str, Any]:
        """The answer as plain dicts, lists, strings and numbers."""
        document: dict[str, Any] = copied(self._document)
        return document

    def __repr__(self) -> str:
        """All of a short one; of a long one what is plain, up to a line."""
        said = [(attribute(key), value) for key, value in self._document.items()]
        plain = [f"{name}={value!r}" for name, value in said if not isinstance(value, (dict, list))]
        shown, length = 0, len(type(self).__name__)
        while shown < len(plain) and length + len(plain[shown]) < _LINE:
            length += len(plain[shown]) + 2
            shown += 1
        more = len(said) - shown
        return f"{type(self).__name__}({', '.join(plain[:shown] + ([f'… {more} more'] if more else []))})"


class Rendered(Answer):
    """An answer that the program writes as text and as JSON: ``print`` shows the text."""

    _text: str
    _json: str

    def __init__(self, text: str, document: str) -> None:
        super().__init__(json.loads(document, object_hook=with_infinity))
        vars(self).update(_text=text, _json=document)

    def to_json(self) -> str:
        """The JSON document as the program writes it, where a number without bound is the word ``infinite``."""
        return self._json

    def __str__(self) -> str:
        return self._text

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self._text, self._json)


class Lazy(Answer):
    """An answer of the native module that is rendered when it is asked for."""

    _answer: Any

    def to_json(self) -> str:
        """The JSON document as the program writes it, where a number without bound is the word ``infinite``."""
        text: str = self._answer.json()
        return text

    @functools.cached_property
    def _text(self) -> str:
        text: str = self._answer.text()
        return text

    def __str__(self) -> str:
        return self._text


def copied(value: Any) -> Any:
    """Plain JSON that a caller may change."""
    if isinstance(value, dict):
        return {key: copied(part) for key, part in value.items()}
    return [copied(part) for part in value] if isinstance(value, list) else value


_A = TypeVar("_A", bound=Answer)


def part(kind: type[_A], document: Any) -> _A:
    """An object as a class."""
    return kind(document)


def parts(kind: type[_A], documents: Any) -> list[_A]:
    """A list of objects as a class."""
    return [kind(document) for document in documents]


class ByMode(dict[str, _A]):
    """Parts of an answer under the symbols of their modes; a :class:`~standfast.Mode` stands for its symbol."""

    if TYPE_CHECKING:

        def __getitem__(self, key: str | Mode) -> _A: ...

    def __missing__(self, key: object) -> _A:
        if isinstance(key, Mode) and key.symbol in self:
            return self[key.symbol]
        raise KeyError(f"there is no {key!r}; there are {', '.join(self)}")


def mode(symbol: str) -> Mode:
    """A mode by its symbol."""
    return BY_SYMBOL[symbol]


def modes(symbols: list[str]) -> Modes:
    """A set of modes by their symbols."""
    return Modes.of(*map(mode, symbols))


def value_of(key: Key, given: Any, kind: Any) -> Any:
    """The attribute of a key that is `given` in the document; `kind` is the class of the parts in it."""
    if isinstance(given, list):
        if "Modes" in key.type.split(" | "):
            return modes(given)
        if key.type.startswith(("list[Mode]", "list[list[Mode]]")):
            return [mode(one) if isinstance(one, str) else list(map(mode, one)) for one in given]
        if key.type.startswith("ByMode["):
            return ByMode((part["mode"], kind(part)) for part in given)
        return copied(given) if kind is None else parts(kind, given)
    if isinstance(given, str) and key.type.startswith("Mode"):
        return mode(given)
    return copied(given) if kind is None or given is None else part(kind, given)


def make_classes(module: str, namespace: dict[str, Any]) -> list[str]:
    """Puts the classes of a module into its namespace: a property for each key. Gives their names."""
    for name, base, words, keys in _schema.classes(module):

        def reader(key: Key) -> Callable[[Answer], Any]:
            return lambda answer: value_of(key, answer._document.get(key.key), namespace.get(key.part))

        made = {key.name: _property(key, reader(key)) for key in keys}
        bases = (namespace.get(base, Answer),)
        namespace[name] = type(name, bases, {"__module__": namespace["__name__"], "__doc__": words, **made})
    return sorted(name for name, *_ in _schema.classes(module))


def make_only_situation() -> type:
    """The class of an answer that has the properties of its only situation: those of what its `_only` gives."""

    def reader(key: Key) -> Callable[[Any], Any]:
        return lambda answer: getattr(answer._only(), key.name)

    made = {key.name: _property(key, reader(key)) for key in _schema.only_situation()}
    words = "What a case with one situation says of it: the properties of that :class:`Situation`."
    return type("OnlySituation", (), {"__module__": "standfast.answers", "__doc__": words, **made})


def _property(key: Key, read: Callable[[Any], Any]) -> property:
    read.__name__, read.__annotations__ = key.name, {"return": key.type}
    return property(read, doc=key.words)
