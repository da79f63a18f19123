"""The modes of response: how a body that was at rest begins to move."""

from __future__ import annotations

import enum

from . import _standfast

_NATIVE = _standfast.modes()


class Mode(enum.IntEnum):
    """A mode of response at the moment a body at rest is loaded by a force that points left.

    O is the bottom left corner, O' the bottom right one. The value is the code in arrays.

    >>> Mode(2)
    <Mode.ROCK_O: 2>
    >>> Mode.ROCK_O.symbol
    'RO'
    >>> print("The body", Mode.ROCK_O.words)
    The body rocks about O, the bottom left corner
    """

    REST = 0
    SLIDE_LEFT = 1
    ROCK_O = 2
    SLIDE_ROCK_O_LEFT = 3
    SLIDE_ROCK_O_RIGHT = 4
    SLIDE_ROCK_O_PRIME_LEFT = 5
    ROCK_O_PRIME = 6
    SLIDE_RIGHT = 7
    SLIDE_ROCK_O_PRIME_RIGHT = 8
    FLIGHT = 9

    @property
    def symbol(self) -> str:
        """The report's symbol in plain characters, e.g. ``SRO'-``."""
        return _NATIVE[self][1]

    @property
    def words(self) -> str:
        """The mode in words, as a predicate of "the body"."""
        return _NATIVE[self][2]


class Modes(enum.IntFlag):
    """A set of modes. The bits are those of the arrays in :attr:`Onset.others`.

    >>> Modes.of(Mode.SLIDE_LEFT) | Modes.ROCK_O
    <Modes.SLIDE_LEFT|ROCK_O: 6>
    >>> Modes.ROCK_O in Modes(6)
    True
    """

    REST = 1 << Mode.REST
    SLIDE_LEFT = 1 << Mode.SLIDE_LEFT
    ROCK_O = 1 << Mode.ROCK_O
    SLIDE_ROCK_O_LEFT = 1 << Mode.SLIDE_ROCK_O_LEFT
    SLIDE_ROCK_O_RIGHT = 1 << Mode.SLIDE_ROCK_O_RIGHT
    SLIDE_ROCK_O_PRIME_LEFT = 1 << Mode.SLIDE_ROCK_O_PRIME_LEFT
    ROCK_O_PRIME = 1 << Mode.ROCK_O_PRIME
    SLIDE_RIGHT = 1 << Mode.SLIDE_RIGHT
    SLIDE_ROCK_O_PRIME_RIGHT = 1 << Mode.SLIDE_ROCK_O_PRIME_RIGHT
    FLIGHT = 1 << Mode.FLIGHT

    @classmethod
    def of(cls, *modes: Mode) -> Modes:
        """The set of these modes."""
        bits = cls(0)
        for mode in modes:
            bits |= cls(1 << mode)
        return bits

    @property
    def modes(self) -> tuple[Mode, ...]:
        """The modes in the set, in the order of their codes.

        >>> Modes(6).modes
        (<Mode.SLIDE_LEFT: 1>, <Mode.ROCK_O: 2>)
        """
        return tuple(mode for mode in Mode if self & (1 << mode))
