"""The modes of response: how a body that was at rest begins to move."""

from __future__ import annotations

import enum
import operator
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _standfast

_NATIVE = _standfast.modes()


class Mode(enum.IntEnum):
    """A mode of response at the moment a body at rest is loaded by a force that points left.

    O is the bottom left corner, O' the bottom right one. The value is the code in arrays.

    >>> Mode(2), Mode("SRO-")
    (<Mode.ROCK_O: 2>, <Mode.SLIDE_ROCK_O_LEFT: 3>)
    >>> Mode.ROCK_O.symbol, Mode.ROCK_O == "RO", Mode.ROCK_O == 2
    ('RO', True, True)
    >>> print(Mode.ROCK_O, f"{Mode.REST:>4}")
    RO   RE
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
    #: BF: the ground fails. No mode of a rigid body: it has no motion, and is in no set of :class:`Modes`.
    BEARING_FAILURE = 10

    if TYPE_CHECKING:

        def __new__(cls, value: int | np.integer[Any] | str) -> Mode: ...

    @classmethod
    def _missing_(cls, value: object) -> Mode | None:
        """The mode of a symbol."""
        for mode in cls:
            if value == mode.symbol:
                return mode
        expected = ", ".join(f"{mode.symbol} or {mode.value}" for mode in cls)
        raise ValueError(f"{value!r} is not a mode; expected {expected}")

    def __eq__(self, other: object) -> bool:
        """Whether it is the same mode, its code or its symbol."""
        if isinstance(other, str):
            return other == self.symbol
        return int.__eq__(self, other) if isinstance(other, int) else NotImplemented

    def __ne__(self, other: object) -> bool:
        found = self.__eq__(other)
        return found if found is NotImplemented else not found

    # As of its code, which it stands for among the keys of dicts.
    __hash__ = int.__hash__

    # The sum of two codes would be the code of another mode.
    def __or__(self, other: int) -> Modes:
        return Modes(self) | other

    def __and__(self, other: int) -> Modes:
        return Modes(self) & other

    # Of an IntEnum Python 3.10 prints the name and later ones the number.
    def __str__(self) -> str:
        return self.symbol

    def __format__(self, spec: str) -> str:
        return format(self.symbol, spec)

    @property
    def symbol(self) -> str:
        """The report's symbol in plain characters, e.g. ``SRO'-``."""
        return _NATIVE[self][1]

    @property
    def words(self) -> str:
        """The mode in words, as a predicate of "the body"."""
        return _NATIVE[self][2]


BY_SYMBOL = {mode.symbol: mode for mode in Mode}

#: Above all sets of modes.
_BITS = 1 << Mode.BEARING_FAILURE


class _SetType(enum.EnumMeta):
    """What makes sets: the code of a mode is not taken for the bits of a set."""

    def __call__(cls, value: Any, *args: Any, **options: Any) -> Any:
        if value is Mode.BEARING_FAILURE:
            raise ValueError("bearing failure is in no set of modes; compare with the mode itself")
        bits = 1 << value if isinstance(value, Mode) else value
        return super().__call__(bits, *args, **options)


class Modes(enum.IntFlag, metaclass=_SetType):
    """A set of modes. The bits are those of the arrays in :attr:`OnsetArrays.others`.

    Made of bits, of a mode, of several by :meth:`of`, or of symbols in one string, as ``Modes("SL RO")``. Arrays of bits are asked
    by sets, not by the codes of modes: ``onset.others & Modes.ROCK_O != 0``.

    >>> Modes(Mode.SLIDE_LEFT) | Mode.ROCK_O
    <Modes.SLIDE_LEFT|ROCK_O: 6>
    >>> Modes.ROCK_O in Modes(6), Mode.ROCK_O in Modes("SL RE")
    (True, False)
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

    if TYPE_CHECKING:

        def __new__(cls, value: int | np.integer[Any] | str | Mode) -> Modes: ...

    def __or__(self, other: int) -> Modes:
        return super().__or__(_bits(other))

    def __and__(self, other: int) -> Modes:
        return super().__and__(_bits(other))

    def __xor__(self, other: int) -> Modes:
        return super().__xor__(_bits(other))

    __ror__, __rand__, __rxor__ = __or__, __and__, __xor__

    # Python 3.10 names the members from the last to the first.
    def __repr__(self) -> str:
        names = "|".join(mode.name for mode in self.modes)
        return f"<Modes{'.' if names else ''}{names}: {int(self)}>"

    def __str__(self) -> str:
        return " ".join(mode.symbol for mode in self.modes)

    def __format__(self, spec: str) -> str:
        return format(str(self), spec)

    @classmethod
    def _missing_(cls, value: object) -> Modes:
        """The set of symbols in a string; of bits that are of another integer type, or that are none."""
        if isinstance(value, str):
            return cls.of(*(Mode(symbol) for symbol in value.split()))
        if type(value) is not int:
            try:
                return cls(operator.index(value))  # type: ignore[arg-type]
            except TypeError:
                pass
        elif -_BITS <= value < _BITS:
            found = super()._missing_(value)
            assert isinstance(found, cls)
            return found
        raise ValueError(f"{value!r} is not a set of modes; expected bits from 0 to {_BITS - 1}, or symbols in a string")

    def __contains__(self, other: object) -> bool:
        """Whether a mode, or each of a set of modes, is in the set."""
        bits = int(Modes(other))  # type: ignore[arg-type]
        return int(self) & bits == bits

    @classmethod
    def of(cls, *modes: Mode) -> Modes:
        """The set of these modes."""
        bits = cls(0)
        for mode in modes:
            bits |= cls(Mode(mode))
        return bits

    @property
    def modes(self) -> tuple[Mode, ...]:
        """The modes in the set, in the order of their codes.

        >>> Modes(6).modes
        (<Mode.SLIDE_LEFT: 1>, <Mode.ROCK_O: 2>)
        """
        return tuple(mode for mode in Mode if int(self) & 1 << mode)


def _bits(other: int) -> int:
    """The bits of a mode or of a set."""
    return Modes(other) if isinstance(other, Mode) else other
