"""What comes out for what came in: computed columns as scalars, arrays, pandas, polars, pyarrow or Arrow objects.

:func:`standfast._inputs.read` picks the :class:`Form` by what was passed. Computed columns are numpy arrays of the
operands' common shape; what they mean is told by their type, everywhere alike:

=======  =============================  =========  ===========  =============
numpy    meaning                        one point  pandas       Arrow, polars
=======  =============================  =========  ===========  =============
uint8    code of :class:`.Mode`         ``Mode``   ``UInt8``    uint8
uint16   bits of :class:`.Modes`        ``Modes``  ``UInt16``   uint16
bool     yes or no                      ``bool``   ``boolean``  boolean
float64  a number                       ``float``  ``float64``  float64
str      a word                         ``str``    a string     string
=======  =============================  =========  ===========  =============

What is missing is told by masks, never by a value: that of a row by ``missing``, that of a single value by a masked
array in place of a plain one. It comes out as ``None`` for a point, as masked in a masked array, as ``<NA>`` (``NaN`` for
float64) in pandas, and as null in Arrow and polars.
"""

from __future__ import annotations

import inspect
import sys
from abc import ABC, abstractmethod
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, NoReturn, TypeVar

import numpy as np
from numpy.typing import NDArray

from . import _standfast
from ._arrow import ArrowArray, ArrowTable
from ._mode_arrays import ModeArray, ModeNames
from ._modes import SYMBOLS, Mode, Modes
from ._standfast import StandfastError

if TYPE_CHECKING:
    from typing_extensions import Self

_T = TypeVar("_T")

#: What is missing, in the shape of the answer; ``None`` if nothing is.
Missing = NDArray[np.bool_] | None


class Fields(tuple[_T, ...]):
    """A tuple whose items have names: those that were asked for, in that order.

    A class of answers names its fields, with their types, by annotations, and says in its docstring what they are; an instance
    has all or some of them. As with a ``NamedTuple`` there are ``_fields`` and ``_asdict()``.
    """

    _fields: tuple[str, ...] = ()

    def __init_subclass__(cls, fields_of: type[Fields[Any]] | None = None) -> None:
        """``fields_of`` names a class of which the docstring says what the fields are."""
        cls._fields = tuple(cls.__annotations__)
        if fields_of is not None and cls.__doc__ and fields_of.__doc__:
            heading = "Attributes:"
            # Python 3.13 takes the indentation away where a class is made, and others do not.
            own, said = inspect.cleandoc(cls.__doc__), inspect.cleandoc(fields_of.__doc__)
            cls.__doc__ = f"{own}\n\n{heading}{said.partition(heading)[2]}"

    def __new__(cls, values: Mapping[str, _T]) -> Self:
        self = super().__new__(cls, values.values())
        self.__dict__.update(values, _fields=tuple(values))
        return self

    if not TYPE_CHECKING:  # A checker is to refuse names that are not fields.

        def __getattr__(self, name: str) -> NoReturn:
            if name in type(self)._fields:
                raise AttributeError(f"{name} was not asked for; columns named {', '.join(self._fields)} only")
            raise AttributeError(f"{type(self).__name__} has no field {name!r}; it has {', '.join(self._fields)}")

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"{type(self).__name__} cannot be changed")

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self._asdict(),)

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{name}={value!r}' for name, value in self._asdict().items())})"

    def to_dict(self) -> dict[str, _T]:
        """The fields by their names: ``pandas.DataFrame(answer.to_dict())`` has them as columns, where of the answer itself, a
        tuple, pandas would make rows."""
        return dict(zip(self._fields, self))

    _asdict = to_dict

    def __dir__(self) -> list[str]:
        hidden = set(type(self)._fields) - set(self._fields)
        return sorted(set(super().__dir__()) - hidden)


class Form(ABC):
    """A kind of answer."""

    #: Whether the answer tells by a mask what is missing, even if nothing is.
    masked = False

    def with_errors(self, null: bool) -> Form:
        """The kind of answer of operands of this kind where, if ``null``, impossible values have none."""
        return self

    def place(self, row: int) -> str:
        """Where a row stands, as the operands have it."""
        return f"index {row}"

    def placed(self, error: ValueError) -> ValueError:
        """An error of the native module about a point, which tells its ``index``, with its place as the operands have it."""
        index: tuple[int, ...] | None = getattr(error, "index", None)
        if index is None or len(index) != 1 or (place := self.place(index[0])) == f"index {index[0]}":
            return error
        told = type(error)(str(error).replace(f"at index {index[0]}", f"at {place}", 1))
        vars(told)["index"] = index
        return told

    @abstractmethod
    def column(self, name: str, values: NDArray[Any], missing: Missing = None, *, symbols: bool = False) -> Any:
        """One column; with ``symbols`` the values are codes of modes, to be shown as the report's symbols."""

    @abstractmethod
    def table(
        self,
        columns: Mapping[str, NDArray[Any]],
        missing: Missing = None,
        *,
        point: type[Fields[Any]],
        arrays: type[Fields[Any]],
    ) -> Any:
        """Several columns: a data frame or table, or the fields of ``point`` or ``arrays`` where there is no such thing."""


class Point(Form):
    """Four plain numbers, and a plain answer."""

    def column(self, name: str, values: NDArray[Any], missing: Missing = None, *, symbols: bool = False) -> Any:
        values, missing = _parted(values, missing)
        if missing is not None and missing.any():
            return None
        if symbols:
            return str(SYMBOLS[values])
        value = values.item()
        kind = values.dtype
        return Mode(value) if kind == np.uint8 else Modes(value) if kind == np.uint16 else value

    def table(
        self,
        columns: Mapping[str, NDArray[Any]],
        missing: Missing = None,
        *,
        point: type[Fields[Any]],
        arrays: type[Fields[Any]],
    ) -> Any:
        if missing is not None and missing.any():
            return None
        return point({name: self.column(name, values, missing) for name, values in columns.items()})


class Arrays(Form):
    """numpy arrays; masked ones where something is missing or masked arrays came in."""

    def __init__(self, masked: bool = False) -> None:
        self.masked = masked

    def with_errors(self, null: bool) -> Form:
        return Arrays(masked=True) if null else self

    def column(self, name: str, values: NDArray[Any], missing: Missing = None, *, symbols: bool = False) -> Any:
        values, missing = _parted(values, missing)
        # What is missing may be the code of no mode.
        shown = SYMBOLS[values if missing is None else np.where(missing, 0, values)] if symbols else values
        if symbols or shown.dtype == np.uint8:
            shown = np.asarray(shown).view(ModeNames if symbols else ModeArray)
        if not self.masked and missing is None:
            return shown
        # What `filled` puts there is no answer: the code of no mode, bits of no set of modes.
        blanks: dict[str, float | str] = {"B": np.iinfo(np.uint8).max, "H": np.iinfo(np.uint16).max, "d": np.nan, "U": ""}
        blank = blanks.get(shown.dtype.char, False)
        answer = np.ma.MaskedArray(shown, np.ma.nomask if missing is None else missing, fill_value=blank)
        if answer.ndim == 0 and missing is None:
            return Point().column(name, values, symbols=symbols)
        return answer[()]

    def table(
        self,
        columns: Mapping[str, NDArray[Any]],
        missing: Missing = None,
        *,
        point: type[Fields[Any]],
        arrays: type[Fields[Any]],
    ) -> Any:
        return arrays({name: self.column(name, values, missing) for name, values in columns.items()})


class Pandas(Form):
    """A Series or a DataFrame with the index of the one that came in."""

    def __init__(self, index: Any) -> None:
        self.index = index

    def place(self, row: int) -> str:
        label = plain_label(self.index[row])
        # Where rows are labelled by their numbers there is nothing to tell apart.
        return super().place(row) if type(label) is int and label == row else f"row {row}, labelled {label!r}"

    def column(self, name: str, values: NDArray[Any], missing: Missing = None, *, symbols: bool = False) -> Any:
        pd = sys.modules["pandas"]
        return pd.Series(self.array(values, missing, symbols), index=self.index, name=name, copy=False)

    def table(
        self,
        columns: Mapping[str, NDArray[Any]],
        missing: Missing = None,
        *,
        point: type[Fields[Any]],
        arrays: type[Fields[Any]],
    ) -> Any:
        pd = sys.modules["pandas"]
        made = {name: self.array(values, missing) for name, values in columns.items()}
        return pd.DataFrame(made, index=self.index, columns=list(columns), copy=False)

    @staticmethod
    def array(values: NDArray[Any], missing: Missing, symbols: bool = False) -> Any:
        """A column of pandas."""
        pd = sys.modules["pandas"]
        values, missing = _parted(values, missing)
        if symbols:
            from ._pandas import categories

            codes = values.astype(np.int8) if missing is None else np.where(missing, -1, values.astype(np.int8))
            return categories(codes, SYMBOLS.tolist())
        if values.dtype.kind in "ub":
            mask = np.zeros(values.shape, dtype=np.bool_) if missing is None else missing
            made = pd.arrays.BooleanArray if values.dtype.kind == "b" else pd.arrays.IntegerArray
            if values.dtype == np.uint8:
                from ._pandas import ModeColumn as made  # pandas is there, but may not be imported before
            return made(np.ascontiguousarray(values), np.array(mask))
        if missing is None:
            return values
        if values.dtype.kind == "f":
            return np.where(missing, np.nan, values)
        words = values.astype(object)
        words[missing] = None
        return pd.array(words)


class Arrow(Form):
    """An object of the library that the operands are of, or :class:`.ArrowArray` and :class:`.ArrowTable`."""

    def column(self, name: str, values: NDArray[Any], missing: Missing = None, *, symbols: bool = False) -> Any:
        values, missing = _parted(values, missing)
        words = SYMBOLS.tolist() if symbols else None
        return self.adopt(_standfast.make_array(name, _native(values), missing, words), name)

    def table(
        self,
        columns: Mapping[str, NDArray[Any]],
        missing: Missing = None,
        *,
        point: type[Fields[Any]],
        arrays: type[Fields[Any]],
    ) -> Any:
        parted = [(name, *_parted(values, missing)) for name, values in columns.items()]
        made = [_standfast.make_array(name, _native(values), mask, None) for name, values, mask in parted]
        return self.adopt_table(_standfast.make_table(made))

    def adopt(self, array: _standfast.ArrowArray, name: str = "mode") -> Any:
        """One column, without a copy."""
        return ArrowArray(array)

    def adopt_table(self, table: _standfast.ArrowTable) -> Any:
        """A table, without a copy."""
        return ArrowTable(table)


class Polars(Arrow):
    """A Series or a DataFrame; symbols as an Enum."""

    def adopt(self, array: _standfast.ArrowArray, name: str = "mode") -> Any:
        pl = sys.modules["polars"]
        series = pl.Series(name, array)
        return series.cast(pl.Enum(SYMBOLS.tolist())) if series.dtype == pl.Categorical else series

    def adopt_table(self, table: _standfast.ArrowTable) -> Any:
        pl = sys.modules["polars"]
        frame = pl.DataFrame(table)
        # One type for words, whichever function they come from.
        kinds = {name: pl.Enum(list(dict.fromkeys(table.column(name).parts()[2] or ()))) for name, kind in frame.schema.items() if kind == pl.Categorical}
        return frame.cast(kinds) if kinds else frame


class Pyarrow(Arrow):
    """An Array or a Table."""

    def adopt(self, array: _standfast.ArrowArray, name: str = "mode") -> Any:
        return sys.modules["pyarrow"].array(array)

    def adopt_table(self, table: _standfast.ArrowTable) -> Any:
        return sys.modules["pyarrow"].table(table)


def plain_label(label: Any) -> Any:
    """A label of pandas as one writes it: 2, not np.int64(2)."""
    if isinstance(label, tuple):
        return tuple(map(plain_label, label))
    return label.item() if isinstance(label, np.generic) else label


def _parted(values: NDArray[Any], missing: Missing) -> tuple[NDArray[Any], Missing]:
    """Values without mask, and what is missing in all."""
    if isinstance(values, np.ma.MaskedArray):
        if values.mask is not np.ma.nomask:
            own = np.asarray(values.mask, dtype=np.bool_)
            missing = own if missing is None else missing | own
        values = values.data
    return values, missing


def _native(values: NDArray[Any]) -> NDArray[Any] | list[str]:
    """What the native module takes for a column."""
    if values.dtype.kind == "U":
        words: list[str] = values.tolist()
        return words
    return np.ascontiguousarray(values)
