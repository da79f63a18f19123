"""Answers in Arrow for libraries that have no kind of their own here, which behave as arrays do."""

from __future__ import annotations

import enum
import html
import operator
from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any, overload

import numpy as np
from numpy.typing import DTypeLike, NDArray

from . import _standfast
from ._like_array import LikeArray
from ._mode_arrays import ModeArray, ModeNames
from ._modes import Mode, Modes, are_modes, codes_of, words_of
from ._standfast import StandfastError

if TYPE_CHECKING:
    import pandas as pd  # type: ignore[import-untyped,unused-ignore]

#: A value of an answer: a mode, a set of modes, a flag, a number or a word; None where there is none.
Value = Mode | Modes | bool | int | float | str | None


class _Left(enum.Enum):
    """No value was given for what is missing, which may be None."""

    OUT = enum.auto()


#: Items shown at either end.
_SHOWN = 5


class ArrowArray(LikeArray):
    """A column of answers, for any library that speaks the Arrow PyCapsule interface.

    polars, pyarrow, DuckDB and others take it over without a copy: ``pl.Series(column)``, ``pa.array(column)``. It also
    is what is expected of an array: it has a length, items, slices, and may be indexed by an array of places or flags; it
    compares item by item and is computed with, which gives arrays of numpy; numpy and pandas make arrays and columns of it; it can
    be pickled.

    An item is a :class:`Mode` in a column of modes, :class:`Modes` in one of sets of modes, otherwise a ``bool``, a number
    or a ``str``; ``None`` where the answer is null.

    >>> import duckdb, standfast
    >>> points = "select 1 gamma, 1 k_prime, 2 k, unnest([5, 0.1, null]) mu"
    >>> modes = standfast.classify(duckdb.sql(points))
    >>> modes
    <standfast.ArrowArray mode: 3 × uint8, 1 null: [2, 3, null]>
    >>> modes[0], modes == "RO", modes.to_numpy(missing=255)
    (<Mode.ROCK_O: 2>, array([ True, False, False]), ModeArray([  2,   3, 255], dtype=uint8))
    """

    __slots__ = ("_native",)
    _native: _standfast.ArrowArray

    #: Its items are compared, so it has no hash.
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, native: _standfast.ArrowArray) -> None:
        self._native = native

    @property
    def name(self) -> str:
        """What the column is called in a table."""
        return self._native.name

    @property
    def type(self) -> str:
        """Arrow's name of its type: ``uint8`` for modes, ``uint16`` for sets of modes, ``float64``, ``bool``, ``string``."""
        return self._native.type

    @property
    def metadata(self) -> dict[str, str]:
        """What is said of the column: of results of cases their ``description`` and, if they have one, their ``unit``."""
        return self._native.metadata

    @property
    def null_count(self) -> int:
        """How many items are null."""
        return self._native.null_count

    def is_null(self) -> NDArray[np.bool_]:
        """Which items are null."""
        missing = self._native.parts()[1]
        return np.zeros(len(self), dtype=np.bool_) if missing is None else missing

    def to_numpy(self, missing: float | str | np.generic | _Left = _Left.OUT) -> NDArray[Any]:
        """The values as a numpy array, which is a copy; of modes a :class:`ModeArray`, of their words :class:`ModeNames`.

        Args:
            missing: what stands for a null, as 255 for a code. If it is left out, nulls are shown as by pyarrow and
                pandas: NaN among numbers, for which codes and sets of modes become float64; ``None`` among flags and
                words, in an array of objects.

        Raises:
            StandfastError: if the type of the values cannot hold ``missing``.
        """
        values, mask, words = self._native.parts()
        found = self._filled(values if words is None else _texts(values, mask, words), mask, missing)
        if self.type == "uint8":
            return found.view(ModeArray)
        return found.view(ModeNames) if are_modes(words) else found

    def _filled(self, values: NDArray[Any], mask: NDArray[np.bool_] | None, missing: Any) -> NDArray[Any]:
        """The values with what stands for a null."""
        if mask is None:
            return values
        if missing is _Left.OUT:
            if values.dtype.kind == "f":
                return np.where(mask, np.nan, values)
            if values.dtype.kind in "iu":
                return np.where(mask, np.nan, values.astype(np.float64))
            objects: NDArray[Any] = values.astype(object)
            objects[mask] = None
            return objects
        filler = np.asarray(missing)
        wide = values.dtype if values.dtype.kind != "U" else np.result_type(values.dtype, filler.dtype)
        held = filler.ndim == 0 and (filler.dtype.kind == "U") == (values.dtype.kind == "U")
        with np.errstate(invalid="ignore"):
            held = held and filler.dtype.kind in "biufU" and np.array_equal(filler.astype(wide), filler, equal_nan=wide.kind == "f")
        if not held:
            expected = "a word" if values.dtype.kind == "U" else f"a value that {values.dtype} can hold"
            raise StandfastError(f"missing is {missing!r}; expected {expected}")
        return np.where(mask, filler.astype(wide), values)

    def to_pylist(self) -> list[Value]:
        """The items as a list."""
        return list(self)

    tolist = to_pylist

    def to_pandas(self) -> pd.Series[Any]:
        """The column as a Series of pandas: words as categories, what is null as missing."""
        import pandas as pd

        from ._frames import Pandas
        from ._pandas import categories

        values, missing, words = self._native.parts()
        if words is None:
            return pd.Series(Pandas.array(values, missing), name=self.name, copy=False)
        places = values.astype(np.int64) if missing is None else np.where(missing, -1, values.astype(np.int64))
        if self.type == "string":
            return pd.Series(np.array([*words, None], dtype=object)[places], name=self.name)
        return pd.Series(categories(places, words), name=self.name)

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> NDArray[Any]:
        """What :meth:`to_numpy` gives; a null that ``dtype`` cannot show is an error."""
        if copy is False:
            raise StandfastError("an ArrowArray is copied to be an array of numpy; expected copy=None or copy=True")
        values = self.to_numpy()
        if dtype is None or np.dtype(dtype) == values.dtype:
            return values
        kind = np.dtype(dtype)
        if self.null_count and kind.kind in "iub":
            raise StandfastError(
                f"{self.null_count} of {len(self)} values are null, for which {kind} has no value; say one by to_numpy(missing=…)"
            )
        return values.astype(kind)

    def __len__(self) -> int:
        return len(self._native)

    @overload
    def __getitem__(self, index: int | np.integer[Any]) -> Value: ...
    @overload
    def __getitem__(self, index: slice | NDArray[Any] | Sequence[int] | Sequence[bool]) -> ArrowArray: ...
    def __getitem__(self, index: Any) -> Any:
        if isinstance(index, slice):
            start, stop, step = index.indices(len(self))
            if step == 1:
                return ArrowArray(self._native.slice(start, max(stop - start, 0)))
            index = np.arange(len(self))[index]
        try:
            place = operator.index(index)
        except TypeError:
            return self._taken(index)
        if not -len(self) <= place < len(self):
            raise IndexError(f"index {place} of an ArrowArray of {len(self)} items")
        return next(iter(ArrowArray(self._native.slice(place % len(self), 1))))

    def _taken(self, index: Any) -> ArrowArray:
        """The items at an array of places, or those where an array of flags is true."""
        places = np.asarray(index)
        if places.size == 0 and places.dtype.kind == "f":
            places = places.astype(np.intp)
        if places.ndim != 1 or places.dtype.kind not in "iub":
            raise TypeError(f"an ArrowArray is indexed by {index!r}; expected a place, a slice, or an array of places or flags")
        values, missing, words = self._native.parts()
        taken = None if missing is None else missing[places]
        return _array(self.name, self.type, values[places], taken, words, self.metadata)

    def __iter__(self) -> Iterator[Value]:
        values, missing, words = self._native.parts()
        convert = self._convert(words)
        for place, value in enumerate(values.tolist()):
            yield None if missing is not None and missing[place] else convert(value)

    def _convert(self, words: list[str] | None) -> Callable[[Any], Value]:
        """What makes an item of a value."""
        if words is not None:
            return words.__getitem__
        if self.type == "uint8":
            return Mode
        if self.type == "uint16":
            return Modes
        return lambda value: value

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Any:
        """What is computed with it is an array of numpy."""
        if ufunc in (np.equal, np.not_equal) and method == "__call__" and not options:
            other = inputs[1] if inputs[0] is self else inputs[0]
            return self == other if ufunc is np.equal else self != other
        plain = [one.to_numpy() if isinstance(one, ArrowArray) else one for one in inputs]
        return getattr(ufunc, method)(*plain, **options)

    def __eq__(self, other: object) -> NDArray[np.bool_]:  # type: ignore[override]
        """Item by item, as numpy compares; a null is equal to nothing. Modes equal their code and their symbol."""
        return self._compared(other, operator.eq, False)

    def __ne__(self, other: object) -> NDArray[np.bool_]:  # type: ignore[override]
        return self._compared(other, operator.ne, True)

    def __lt__(self, other: object) -> NDArray[np.bool_]:
        return self._compared(other, operator.lt, False)

    def __le__(self, other: object) -> NDArray[np.bool_]:
        return self._compared(other, operator.le, False)

    def __gt__(self, other: object) -> NDArray[np.bool_]:
        return self._compared(other, operator.gt, False)

    def __ge__(self, other: object) -> NDArray[np.bool_]:
        return self._compared(other, operator.ge, False)

    def _compared(self, other: object, compare: Callable[[Any, Any], Any], if_null: bool) -> NDArray[np.bool_]:
        values, missing, words = self._native.parts()
        if words is not None:
            values = _texts(values, missing, words)
        missing = np.zeros(len(self), dtype=np.bool_) if missing is None else missing
        if isinstance(other, ArrowArray):
            missing = missing | other.is_null()
            other = other.to_numpy(missing=_blank(other))
        if are_modes(words):
            # In an array an empty word is of no mode, and equal to none.
            other = words_of(other, blank=not isinstance(other, str))
        elif words is None and self.type == "uint8":
            other = codes_of(other)
        found = np.asarray(compare(values, np.asarray(other)))
        return np.where(missing, if_null, np.broadcast_to(found, np.broadcast_shapes(found.shape, missing.shape)))

    def __reduce__(self) -> tuple[Any, ...]:
        return _array, (self.name, self.type, *self._native.parts(), self.metadata)

    def __copy__(self) -> ArrowArray:
        return self

    def __deepcopy__(self, memo: object) -> ArrowArray:
        return self

    def __repr__(self) -> str:
        nulls = f", {self.null_count} null" if self.null_count else ""
        return f"<standfast.ArrowArray {self.name}: {len(self)} × {self.type}{nulls}: [{', '.join(self._shown())}]>"

    def _shown(self) -> list[str]:
        """The first and the last items as text, codes as numbers."""
        if len(self) > 2 * _SHOWN + 1:
            return [*self[:_SHOWN]._shown(), "…", *self[-_SHOWN:]._shown()]
        return ["null" if item is None else _text(item) for item in self]

    def __arrow_c_schema__(self) -> object:
        return self._native.__arrow_c_schema__()

    def __arrow_c_array__(self, requested_schema: object | None = None) -> tuple[object, object]:
        return self._native.__arrow_c_array__(requested_schema)

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object:
        return self._native.__arrow_c_stream__(requested_schema)


class ArrowTable:
    """A table of answers, for any library that speaks the Arrow PyCapsule interface.

    polars, pyarrow, DuckDB and others take it over without a copy: ``pl.DataFrame(table)``, ``pa.table(table)``. Its
    columns are :class:`ArrowArray`, by their names (``table["mode"]``, or ``table.mode``); its rows are dicts, by their numbers and by iteration; a slice is a
    table. It can be pickled.
    """

    __slots__ = ("_native",)
    _native: _standfast.ArrowTable

    def __init__(self, native: _standfast.ArrowTable) -> None:
        self._native = native

    @property
    def column_names(self) -> list[str]:
        """The names of the columns."""
        return self._native.column_names

    @property
    def shape(self) -> tuple[int, int]:
        """How many rows and columns."""
        return len(self), len(self.column_names)

    def __getattr__(self, name: str) -> ArrowArray:
        if name.startswith("_") or name not in self.column_names:
            raise AttributeError(f"an ArrowTable has no {name!r}; its columns are {', '.join(self.column_names)}", name=name, obj=self)
        return self[name]

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *filter(str.isidentifier, self.column_names)})

    def to_dict(self) -> dict[str, NDArray[Any]]:
        """The columns as numpy arrays by their names, with nulls as in :meth:`ArrowArray.to_numpy`."""
        return {name: self[name].to_numpy() for name in self.column_names}

    def to_pylist(self) -> list[dict[str, Value]]:
        """The rows as a list of dicts."""
        return list(self)

    def to_pandas(self) -> pd.DataFrame:
        """The table as a DataFrame of pandas; see :meth:`ArrowArray.to_pandas`."""
        import pandas as pd

        return pd.DataFrame({name: self[name].to_pandas() for name in self.column_names}, copy=False)

    def _ipython_key_completions_(self) -> list[str]:
        return self.column_names

    def __len__(self) -> int:
        return len(self._native)

    @overload
    def __getitem__(self, key: str) -> ArrowArray: ...
    @overload
    def __getitem__(self, key: slice | list[str]) -> ArrowTable: ...
    @overload
    def __getitem__(self, key: int | np.integer[Any]) -> dict[str, Value]: ...
    def __getitem__(self, key: Any) -> Any:
        if isinstance(key, str):
            return ArrowArray(self._native.column(key))
        if isinstance(key, list) and all(isinstance(name, str) for name in key):
            return ArrowTable(_standfast.make_table([self._native.column(name) for name in key]))
        if isinstance(key, slice):
            start, stop, step = key.indices(len(self))
            if step != 1:
                raise StandfastError(f"an ArrowTable is sliced in steps of {step}; expected steps of 1")
            return ArrowTable(self._native.slice(start, max(stop - start, 0)))
        try:
            place = operator.index(key)
        except TypeError:
            raise TypeError(
                f"an ArrowTable is indexed by {key!r}; expected the name of a column, a list of names, a row or a slice"
            ) from None
        if not -len(self) <= place < len(self):
            raise IndexError(f"row {place} of an ArrowTable of {len(self)} rows")
        return next(iter(ArrowTable(self._native.slice(place % len(self), 1))))

    def __iter__(self) -> Iterator[dict[str, Value]]:
        names = self.column_names
        return (dict(zip(names, row)) for row in zip(*(self[name] for name in names)))

    def __contains__(self, name: object) -> bool:
        return name in self.column_names

    def __reduce__(self) -> tuple[Any, ...]:
        return _table, ([self[name] for name in self.column_names],)

    def __copy__(self) -> ArrowTable:
        return self

    def __deepcopy__(self, memo: object) -> ArrowTable:
        return self

    def _lines(self) -> tuple[list[list[str]], int]:
        """The header and the first and last rows as text; and after how many lines rows are left out, or 0."""
        names = self.column_names
        cut = len(self) > 2 * _SHOWN
        parts = [self[:_SHOWN], self[-_SHOWN:]] if cut else [self]
        numbers = [*range(_SHOWN), *range(len(self) - _SHOWN, len(self))] if cut else range(len(self))
        rows = [["null" if value is None else _text(value) for value in row.values()] for part in parts for row in part]
        return [["", *names], *([str(number), *row] for number, row in zip(numbers, rows))], _SHOWN + 1 if cut else 0

    def __repr__(self) -> str:
        lines, cut = self._lines()
        widths = [max(map(len, column)) for column in zip(*lines)]
        text = ["  ".join(cell.rjust(width) for cell, width in zip(line, widths)).rstrip() for line in lines]
        if cut:
            text.insert(cut, "…".rjust(widths[0]))
        return "\n".join([f"<standfast.ArrowTable: {len(self)} rows × {len(self.column_names)} columns>", *text])

    def _repr_html_(self) -> str:
        lines, cut = self._lines()
        head, *rows = [[html.escape(cell) for cell in line] for line in lines]
        body = [f"<tr><th>{row[0]}</th>{''.join(f'<td>{cell}</td>' for cell in row[1:])}</tr>" for row in rows]
        if cut:
            body.insert(cut - 1, f"<tr><th>…</th>{'<td>…</td>' * (len(head) - 1)}</tr>")
        header = "".join(f"<th>{cell}</th>" for cell in head)
        return (
            f"<table><thead><tr>{header}</tr></thead><tbody>{''.join(body)}</tbody></table>"
            f"<p>{len(self)} rows × {len(self.column_names)} columns</p>"
        )

    def __arrow_c_schema__(self) -> object:
        return self._native.__arrow_c_schema__()

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object:
        return self._native.__arrow_c_stream__(requested_schema)


def _array(
    name: str,
    kind: str,
    values: NDArray[Any],
    missing: NDArray[np.bool_] | None,
    words: list[str] | None,
    metadata: dict[str, str] | None = None,
) -> ArrowArray:
    """An array of what a native one is taken apart into."""
    if kind == "string":
        assert words is not None
        return ArrowArray(_standfast.make_array(name, [words[place] for place in values], missing, None, metadata))
    return ArrowArray(_standfast.make_array(name, values, missing, words, metadata))


def _table(columns: list[ArrowArray]) -> ArrowTable:
    return ArrowTable(_standfast.make_table([column._native for column in columns]))


def _texts(places: NDArray[Any], missing: NDArray[np.bool_] | None, words: list[str]) -> NDArray[Any]:
    """The words at the places, and an empty one where there is none: the place of a null may be any."""
    known: NDArray[Any] = np.array([*words, ""])
    return known.take(places if missing is None else np.where(missing, len(words), places.astype(np.int64)))


def _blank(array: ArrowArray) -> Any:
    """A value that the type of an array holds."""
    return {"uint8": 0, "uint16": 0, "int64": 0, "bool": False, "float64": 0.0}.get(array.type, "")


def _text(item: Value) -> str:
    """An item as it is shown: short, and codes as numbers."""
    if isinstance(item, bool) or not isinstance(item, (int, float)):
        return str(item)
    return f"{item:.6g}" if isinstance(item, float) else str(int(item))
