"""Modes in arrays of numpy, as codes and as words: whatever is selected, joined and compared, a word that names no mode is an error.

numpy itself answers ``codes == "slides"`` by a row of ``False``, and knows nothing of modes where arrays are joined. So both kinds are
arrays of their own, and the functions below are told what of their arguments are modes.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from ._modes import BY_SYMBOL, SYMBOLS, Mode, Modes, codes_of, words_of
from ._standfast import StandfastError

if TYPE_CHECKING:
    import pandas as pd  # type: ignore[import-untyped,unused-ignore]

#: Functions that compare modes or join them: their arguments in order, ``None`` where one holds no modes.
_HOLD: dict[Any, tuple[str | None, ...]] = {
    np.isin: ("element", "test_elements"),
    np.setdiff1d: ("ar1", "ar2"),
    np.intersect1d: ("ar1", "ar2"),
    np.union1d: ("ar1", "ar2"),
    np.array_equal: ("a1", "a2"),
    np.array_equiv: ("a1", "a2"),
    np.searchsorted: ("a", "v"),
    np.concatenate: ("arrays",),
    np.stack: ("arrays",),
    np.hstack: ("tup",),
    np.vstack: ("tup",),
    np.dstack: ("tup",),
    np.column_stack: ("tup",),
    np.block: ("arrays",),
    np.append: ("arr", "values"),
    np.insert: ("arr", None, "values"),
    np.where: (None, "x", "y"),
    np.select: (None, "choicelist", "default"),
    np.choose: (None, "choices"),
    np.full_like: ("a", "fill_value"),
    np.place: (None, None, "vals"),
    np.putmask: (None, None, "values"),
    np.copyto: (None, "src"),
}
#: Those of them that hold several arrays in one argument.
_LISTS = ("arrays", "tup", "choicelist", "choices")
#: Those of them whose answer is not of modes.
_ASKS = (np.isin, np.array_equal, np.array_equiv, np.searchsorted)
#: What of computing gives one of the modes that it is given.
_KEEPS = (np.maximum, np.minimum, np.fmax, np.fmin)


class _OfModes(np.ndarray[Any, Any]):
    """What arrays of codes and arrays of words have in common."""

    #: The kinds of numpy's types that it may be of.
    _kinds: ClassVar[str]

    @staticmethod
    def _own(other: Any) -> Any:
        """What is compared or joined with it, in its own form."""
        raise NotImplementedError

    def __contains__(self, mode: object) -> bool:
        return bool(np.any(self == mode))

    def __setitem__(self, index: Any, modes: Any) -> None:
        super().__setitem__(index, _plain(type(self)._own(modes)))

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Any:
        """What is computed with modes is plain, but for the greatest and the least of them."""
        own = type(self)._own
        if any(isinstance(one, Modes) for one in inputs):
            raise TypeError("an array of modes beside a set of modes; expected a mode, a code or a word")
        takes = ufunc in (np.equal, np.not_equal) or ufunc in _KEEPS
        plain = [_plain(one if isinstance(one, type(self)) or not takes else own(one)) for one in inputs]
        if (out := options.get("out")) is not None:
            options["out"] = tuple(_plain(one) for one in out)
        found = getattr(ufunc, method)(*plain, **options)
        return self._made(found) if ufunc in _KEEPS else found

    def __array_function__(self, function: Any, types: Any, args: Any, options: Any) -> Any:
        names = _HOLD.get(function)
        # With nothing to choose from, `where` finds places.
        if names is None or function is np.where and len(args) == 1:
            return super().__array_function__(function, types, args, options)
        own = type(self)._own
        held = [name and name in _LISTS for name in names]
        given = [
            one if place >= len(names) or names[place] is None else _each(own, one) if held[place] else own(one)
            for place, one in enumerate(args)
        ]
        named = {name: (_each(own, one) if name in _LISTS else own(one)) if name in names else one for name, one in options.items()}
        found = super().__array_function__(function, types, _bare(tuple(given)), _bare(named))
        return found if function in _ASKS else self._made(found)

    def _made(self, found: Any) -> Any:
        """What was found, as modes."""
        if isinstance(found, tuple):
            return tuple(self._made(one) if place == 0 else one for place, one in enumerate(found))
        if not isinstance(found, (np.ndarray, np.generic)) or found.dtype.kind not in type(self)._kinds:
            return found
        return self._item(found) if isinstance(found, np.generic) else found.view(type(self))

    def _item(self, found: Any) -> Any:
        """One of them alone."""
        return found

    def __getitem__(self, index: Any) -> Any:
        return self._item(super().__getitem__(index))

    def take(self, *args: Any, **options: Any) -> Any:
        return self._item(super().take(*args, **options))


class ModeArray(_OfModes):
    """Codes of modes in an array of ``uint8``, which may be compared with modes, codes and words.

    What is computed with it is plain; what is selected from it, joined with it (:func:`numpy.concatenate`, :func:`numpy.where`, ...) and
    the greatest of it is of modes again. An item is a :class:`Mode`. It is made of codes, of modes or of words, as those of a column
    ``mode``.

    >>> modes = ModeArray(["RE", "SL", "RO"])
    >>> modes
    ModeArray([0, 1, 2], dtype=uint8)
    >>> modes == "SL", "RO" in modes, modes[1]
    (array([False,  True, False]), True, <Mode.SLIDE_LEFT: 1>)
    >>> np.concatenate([modes, ["FL"]]) == "FL"
    array([False, False, False,  True])
    >>> modes.names, modes.code
    (ModeNames(['RE', 'SL', 'RO'], dtype='<U5'), array([0, 1, 2], dtype=uint8))
    """

    # Joined with other numbers, as with NaN for what is missing, it is of their type.
    _kinds = "iufO"

    @staticmethod
    def _own(other: Any) -> Any:
        return codes_of(other)

    def __new__(cls, modes: Any) -> ModeArray:
        codes = np.asarray(codes_of(modes))
        known = codes.size == 0 or codes.dtype.kind in "iuO"
        if not known or not np.isin(codes.astype(np.float64), np.arange(len(Mode))).all():
            raise StandfastError(f"codes of modes are 0 to {len(Mode) - 1}, or words: {', '.join(BY_SYMBOL)}")
        return codes.astype(np.uint8).view(cls)

    @property
    def code(self) -> NDArray[np.uint8]:
        """The codes as a plain array."""
        return self.view(np.ndarray)

    @property
    def names(self) -> ModeNames:
        """The report's symbols, an array of words."""
        codes = self.code
        if codes.dtype != np.uint8 or codes.size and codes.max() >= len(Mode):
            codes = ModeArray(codes).code
        return np.asarray(SYMBOLS[codes]).view(ModeNames)

    def astype(self, dtype: Any, *args: Any, **options: Any) -> Any:
        """As numpy's; words are those of :attr:`names`."""
        if np.dtype(dtype).kind in "UT":
            return self.names.astype(dtype, *args, **options)
        return super().astype(dtype, *args, **options)

    def to_pandas(self) -> pd.Series[Any]:
        """The codes as a Series of pandas that is compared as they are; pandas would make a plain one of them."""
        import pandas as pd

        from ._pandas import ModeColumn

        codes = ModeArray(self).code
        return pd.Series(ModeColumn(codes, np.zeros(codes.shape, dtype=np.bool_)), name="mode", copy=False)

    def _made(self, found: Any) -> Any:
        """Whole numbers that are codes are so in the type of codes, as joined with a list."""
        made = super()._made(found)
        if isinstance(made, ModeArray) and made.dtype != np.uint8 and made.dtype.kind in "iu" and made.size:
            codes = made.code
            return codes.astype(np.uint8).view(ModeArray) if 0 <= codes.min() and codes.max() < len(Mode) else made
        return made

    def _item(self, found: Any) -> Any:
        return Mode(int(found)) if isinstance(found, np.uint8) and found < len(Mode) else found


class ModeNames(_OfModes):
    """Symbols of modes in an array of words, which may be compared with modes, codes and words; an empty word is of no mode.

    Where it is selected from and joined it is of modes again. An item is a text. Its :attr:`code` are the codes.

    >>> words = ModeArray([0, 1]).names
    >>> words == "SL", Mode.SLIDE_LEFT in words
    (array([False,  True]), True)
    >>> words == "slides"
    Traceback (most recent call last):
    ...
    standfast.StandfastError: 'slides' is not a mode; expected RE, SL, RO, SRO-, SRO+, SRO'-, RO', SL+, SRO'+, FL or BF
    """

    _kinds = "UTO"

    @staticmethod
    def _own(other: Any) -> Any:
        return words_of(other, blank=True)

    def __new__(cls, modes: Any) -> ModeNames:
        return ModeArray(modes).names

    @property
    def code(self) -> NDArray[np.uint8]:
        """The codes as a plain array; an empty word has none."""
        return ModeArray(self).code

    @property
    def names(self) -> ModeNames:
        """These words, as :attr:`ModeArray.names`."""
        return self

    def to_pandas(self) -> pd.Series[Any]:
        """The words as categories of pandas, which are compared as they are; pandas would make plain words of them."""
        import pandas as pd

        from ._pandas import categories

        places = np.array([-1 if word in ("", None) else BY_SYMBOL[word] for word in self.tolist()], dtype=np.int8)
        return pd.Series(categories(places, SYMBOLS.tolist()), name="mode", copy=False)


def _plain(array: Any) -> Any:
    return array.view(np.ndarray) if isinstance(array, _OfModes) else array


def _each(own: Callable[[Any], Any], held: Any) -> Any:
    """What is joined, each in the one form: the items of a list or tuple, else it as a whole."""
    if not isinstance(held, (list, tuple)):
        return own(held)
    return [_each(own, one) if isinstance(one, (list, tuple)) and any(isinstance(part, np.ndarray) for part in one) else own(one) for one in held]


def _bare(given: Any) -> Any:
    """Plain arrays in place of those of modes, for functions that keep only what they are given."""
    if isinstance(given, dict):
        return {name: _bare(one) for name, one in given.items()}
    if isinstance(given, (list, tuple)):
        return type(given)(_bare(one) for one in given)
    return _plain(given)
