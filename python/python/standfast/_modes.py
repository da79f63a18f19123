"""The modes of response: how a body that was at rest begins to move."""

from __future__ import annotations

import enum
import operator
import sys
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _standfast
from ._standfast import StandfastError

_NATIVE = _standfast.modes()


#: The last letters of formats of whole numbers.
_NUMBERS = ("b", "d", "o", "x", "X", "n")


class _ModeType(enum.EnumMeta):
    """What makes modes: the bits of a set are not taken for a code."""

    def __call__(cls, value: Any, *args: Any, **options: Any) -> Any:
        if isinstance(value, Modes):
            raise TypeError(f"{value!r} is a set of modes; expected a code or a symbol. Its .modes are those in it")
        return super().__call__(value, *args, **options)


class Mode(enum.IntEnum, metaclass=_ModeType):
    """A mode of response at the moment a body at rest is loaded by a force that points left.

    O is the bottom left corner, O' the bottom right one. The value is the code in arrays.

    >>> Mode(2), Mode("SRO-")
    (<Mode.ROCK_O: 2>, <Mode.SLIDE_ROCK_O_LEFT: 3>)
    >>> Mode.ROCK_O.symbol, Mode.ROCK_O == "RO", Mode.ROCK_O == 2
    ('RO', True, True)
    >>> Mode.ROCK_O == "R0"
    Traceback (most recent call last):
    ...
    standfast.StandfastError: 'R0' is not a mode; expected RE, SL, RO, SRO-, SRO+, SRO'-, RO', SL+, SRO'+, FL or BF
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
        raise StandfastError(f"{value!r} is not a mode; expected {expected}")

    #: Above that of all columns of pandas, which so leave it to this class to be compared.
    __pandas_priority__ = 5000

    def __eq__(self, other: object) -> Any:
        """Whether it is the same mode, its code or its symbol; item by item beside a column.

        Raises:
            StandfastError: for a word that names no mode.
            TypeError: for a set of modes.
        """
        return self._compared(other, operator.eq)

    def __ne__(self, other: object) -> Any:
        return self._compared(other, operator.ne)

    def __lt__(self, other: object) -> Any:
        return self._compared(other, operator.lt)

    def __le__(self, other: object) -> Any:
        return self._compared(other, operator.le)

    def __gt__(self, other: object) -> Any:
        return self._compared(other, operator.gt)

    def __ge__(self, other: object) -> Any:
        return self._compared(other, operator.ge)

    def _compared(self, other: Any, compare: Callable[[Any, Any], Any]) -> Any:
        if isinstance(other, str):
            return compare(int(self), code_of(other))
        if isinstance(other, Modes):
            raise TypeError(f"{other!r} is a set of modes, and {self!r} a mode; `mode in modes` says whether it is in it")
        if isinstance(other, int):
            return compare(int(self), int(other))
        if (kind := _kind(other)) is None:
            return NotImplemented
        if kind == "frame":
            return other.apply(lambda column: compare(self, column))
        if kind == "objects":
            return other.map(lambda item: compare(self, item))
        return compare(self.symbol if kind == "words" else int(self), other)

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Any:
        """Beside an array of words a mode is its symbol, beside all others its code."""
        kinds = [np.asarray(other).dtype for other in inputs if not isinstance(other, Mode)]
        if any(kind == np.uint16 for kind in kinds):
            raise TypeError("an array of uint16 has sets of modes, in bits, which are asked by sets: `others & Modes.ROCK_O != 0`")
        words = any(kind.kind in "UT" for kind in kinds)
        plain = [_alone(one, words, any(kind.kind == "O" for kind in kinds)) if isinstance(one, Mode) else one for one in inputs]
        return getattr(ufunc, method)(*plain, **options)

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
        """Its symbol; its code by a format of numbers, as ``d``."""
        return format(int(self) if spec[-1:] in _NUMBERS else self.symbol, spec)

    @property
    def code(self) -> int:
        """Its code, a plain number."""
        return int(self)

    @property
    def symbol(self) -> str:
        """The report's symbol in plain characters, e.g. ``SRO'-``."""
        return _NATIVE[self][1]

    @property
    def words(self) -> str:
        """The mode in words, as a predicate of "the body"."""
        return _NATIVE[self][2]


BY_SYMBOL = {mode.symbol: mode for mode in Mode}

#: By their codes.
SYMBOLS: NDArray[np.str_] = np.array(list(BY_SYMBOL))


def code_of(word: object) -> int:
    """The code of the mode that a word names.

    Raises:
        StandfastError: if it names none.
    """
    if isinstance(word, str) and (mode := BY_SYMBOL.get(word)) is not None:
        return int(mode)
    *others, last = BY_SYMBOL
    raise StandfastError(f"{word!r} is not a mode; expected {', '.join(others)} or {last}")


def codes_of(other: Any) -> Any:
    """Codes in place of words and modes, alone or in what holds many; anything else as it is.

    Raises:
        StandfastError: for a word that names no mode.
        TypeError: for a set of modes.
    """
    if isinstance(other, (str, bytes)):
        return code_of(other)
    if (mode := _of_mode(other)) is not None:
        return int(mode)
    if isinstance(other, (list, tuple, set, frozenset)):
        # numpy would make words of all of them where one is a word.
        codes = np.array([codes_of(item) for item in other])
        small = codes.size and codes.dtype.kind in "iu" and 0 <= codes.min() and codes.max() <= np.iinfo(np.uint8).max
        return codes.astype(np.uint8) if small else codes
    items = np.asarray(other)
    if items.dtype.kind == "O" and any(isinstance(item, (str, bytes, Mode)) for item in items.flat):
        return np.array([codes_of(item) for item in items.flat], dtype=object).reshape(items.shape)
    if items.dtype.kind not in "SUT":
        return other
    return np.array([code_of(word) for word in items.ravel().tolist()], dtype=np.uint8).reshape(items.shape)


def words_of(other: Any, *, blank: bool = False) -> Any:
    """Symbols in place of modes and codes, alone or in what holds many; anything else as it is.

    Args:
        blank: whether a word may be empty, which is of no mode.

    Raises:
        StandfastError: for a word that names no mode.
        TypeError: for a set of modes.
    """
    if isinstance(other, (str, bytes)):
        return other if blank and other == "" else str(SYMBOLS[code_of(other)])
    if (mode := _of_mode(other)) is not None:
        return mode.symbol
    if isinstance(other, (int, np.integer)) and not isinstance(other, bool):
        return str(SYMBOLS[other]) if 0 <= other < len(SYMBOLS) else other
    if isinstance(other, (list, tuple, set, frozenset)):
        return _worded([words_of(item, blank=blank) for item in other])
    items = np.asarray(other)
    if items.dtype.kind in "SUT":
        unknown = ~np.isin(items, [*BY_SYMBOL, *([""] if blank else [])]) if items.dtype.kind != "S" else np.ones(items.shape, np.bool_)
        if unknown.any():
            code_of(items[unknown].tolist()[0])
        return other
    if items.dtype.kind in "iu" and items.size and 0 <= items.min() and items.max() < len(SYMBOLS):
        return SYMBOLS[items]
    if items.dtype.kind not in "iuO":
        return other
    return _worded([words_of(item, blank=blank) for item in items.flat]).reshape(items.shape)


def _worded(items: list[Any]) -> NDArray[Any]:
    """Words, and what is none beside them."""
    if all(isinstance(item, str) for item in items):
        return np.array(items, dtype=np.str_)
    found = np.empty(len(items), dtype=object)
    found[:] = items
    return found


def are_modes(words: Sequence[str] | None) -> bool:
    """Whether all words are those of modes; where there are none they are not."""
    return bool(words) and all(word in BY_SYMBOL for word in words or ())


def _of_mode(other: object) -> Mode | None:
    """The mode, of what is one, and ``None`` of all else.

    Raises:
        TypeError: for a set of modes.
    """
    if isinstance(other, Modes):
        raise TypeError(f"{other!r} is a set of modes; expected a mode, a code or a word")
    return other if isinstance(other, Mode) else None


def _alone(mode: Mode, words: bool, objects: bool) -> Any:
    """A mode as an operand beside arrays."""
    if not objects:
        return mode.symbol if words else int(mode)
    alone = np.empty((), dtype=object)
    alone[()] = mode
    return alone


def _kind(column: Any) -> str | None:
    """What a column of pandas holds: codes, words or objects; ``None`` if it is not a column of pandas."""
    pd = sys.modules.get("pandas")
    if pd is None or not isinstance(column, (pd.Series, pd.Index, pd.DataFrame, pd.api.extensions.ExtensionArray)):
        return None
    if isinstance(column, pd.DataFrame):
        return "frame"
    dtype = column.dtype.categories.dtype if isinstance(column.dtype, pd.CategoricalDtype) else column.dtype
    if pd.api.types.is_numeric_dtype(dtype):
        return "codes"
    return "objects" if dtype == object and not isinstance(column.dtype, pd.CategoricalDtype) else "words"


#: Above all sets of modes.
_BITS = 1 << Mode.BEARING_FAILURE


class _SetType(enum.EnumMeta):
    """What makes sets: the code of a mode is not taken for the bits of a set."""

    def __call__(cls, value: Any, *args: Any, **options: Any) -> Any:
        if value is Mode.BEARING_FAILURE:
            raise StandfastError("bearing failure is in no set of modes; compare with the mode itself")
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

    def __eq__(self, other: object) -> bool:
        """Whether it is the same set, or has these bits.

        Raises:
            TypeError: for a mode, of which the code would be taken for bits.
        """
        if isinstance(other, Mode):
            raise TypeError(f"{other!r} is a mode, and {self!r} a set of modes; `mode in modes` says whether it is in it")
        return int.__eq__(self, other) if isinstance(other, int) else NotImplemented

    def __ne__(self, other: object) -> bool:
        found = self.__eq__(other)
        return found if found is NotImplemented else not found

    __hash__ = int.__hash__

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
        raise StandfastError(f"{value!r} is not a set of modes; expected bits from 0 to {_BITS - 1}, or symbols in a string")

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
