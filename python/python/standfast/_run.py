"""How a call over many points is run, as the native module is told."""

from __future__ import annotations

import operator
from collections.abc import Callable
from typing import Literal, NamedTuple

from ._standfast import StandfastError

#: Called with how many points are done and how many there are, ``None`` if that is not known.
Told = Callable[[int, "int | None"], object]


def is_right(to: str) -> bool:
    """Whether the force points right."""
    if to not in ("left", "right"):
        raise StandfastError(f"to is {to!r}; expected 'left' or 'right', where the force points")
    return to == "right"


class Run(NamedTuple):
    """What the native module is told of a call.

    Attributes:
        threads: how many; ``None`` for as many as there are processors.
        null_errors: a point with an impossible value has no answer, and is no error.
        nan_is_missing: NaN is what is missing, and no impossible value.
        right: the force points right.
        progress: who is told how far the call is, some ten times a second and at its end.
        total: how many points there are, where a stream does not tell.
    """

    threads: int | None
    null_errors: bool = False
    nan_is_missing: bool = False
    right: bool = False
    progress: Told | None = None
    total: int | None = None


def run(
    threads: int | None,
    on_error: Literal["raise", "null"] = "raise",
    progress: Told | None = None,
    to: str = "left",
) -> Run:
    """The options of a call, checked.

    Raises:
        StandfastError: for a number of threads below one, and for another word than ``"raise"`` and ``"null"``, or ``"left"`` and
            ``"right"``.
    """
    if threads is not None:
        try:
            number = operator.index(threads)
        except TypeError:
            number = 0
        if number < 1 or isinstance(threads, bool):
            raise StandfastError(f"threads is {threads!r}; expected a whole number above zero, or None for all processors")
        threads = number
    if on_error not in ("raise", "null"):
        raise StandfastError(f"on_error is {on_error!r}; expected 'raise' or 'null'")
    return Run(threads, on_error == "null", right=is_right(to), progress=progress)
