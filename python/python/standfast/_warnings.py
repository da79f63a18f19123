"""What may be a slip, told as a warning of Python, of the line that called this package."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Iterable
from typing import Any, ClassVar


class StandfastWarning(UserWarning):
    """Something possible that may be a slip.

    Attributes:
        name: its name, by which programs tell it apart: ``"column-like-key"``, or that of one of the ``warnings`` of an answer.
    """

    def __init__(self, name: str, words: str) -> None:
        super().__init__(name, words)
        self.name = name

    def __str__(self) -> str:
        return f"{self.args[1]} ({self.name})"


# As a traceback and a filter of the command line name it.
StandfastWarning.__module__ = "standfast"


class _OncePerPlace(StandfastWarning):
    """A warning that a search, which calls again and again with other numbers, shows once: Python knows those it has shown from a
    place by their category and text, and this one has for text what does not change."""

    #: Names and words, by what Python knows a warning by.
    said: ClassVar[dict[str, tuple[str, str]]] = {}

    def __init__(self, name: str, words: str | None = None) -> None:
        super().__init__(*(_OncePerPlace.said[name] if words is None else (name, words)))

    def __reduce__(self) -> tuple[Any, ...]:
        return StandfastWarning, self.args


_OncePerPlace.__name__ = _OncePerPlace.__qualname__ = "StandfastWarning"
_OncePerPlace.__module__ = "standfast"


def warn(name: str, known: str, words: str) -> None:
    """A warning of the line that called this package; from there once of what is ``known`` by these words."""
    _OncePerPlace.said[known] = name, words
    frame, level = sys._getframe(1), 2
    while frame.f_back is not None and frame.f_globals.get("__package__") == __package__:
        frame, level = frame.f_back, level + 1
    warnings.warn(known, _OncePerPlace, stacklevel=level)


def mind(slips: Iterable[tuple[str, str]]) -> None:
    """The warnings of an answer, by their names and words."""
    for name, words in slips:
        warn(name, f"{name}, of a case", words)
