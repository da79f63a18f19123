"""Types of operands, for type checkers: which overload of a function a call means.

pandas and pyarrow come without types, and none of the libraries need be there. Operands are therefore told apart by what
they can do; a checker that knows nothing of a library sees ``Any``, and with pandas-stubs or pyarrow-stubs it knows.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from typing import Any, Literal, Protocol, TypeAlias, TypedDict

import numpy as np
from numpy.typing import NDArray

#: A plain number.
Number: TypeAlias = "float | np.floating[Any] | np.integer[Any] | Decimal | Fraction"
#: Lists of lists of numbers.
Nested: TypeAlias = "Sequence[Number | NDArray[Any] | Nested]"
#: What is read as a numpy array.
Array: TypeAlias = "Number | NDArray[Any] | Nested"
#: Which column of a table holds what, or the number that holds for all rows.
Map: TypeAlias = "Mapping[str, str | Number] | Mapping[str, str] | Mapping[str, Number]"
#: Told how many points, rows or thousandths of the work are done and how many there are, ``None`` if that is not known; ``True`` for a bar.
Progress: TypeAlias = "bool | Callable[[int, int | None], object] | None"

#: Where a force points.
Side: TypeAlias = Literal["left", "right"]


class Work(TypedDict, total=False):
    """What functions of many rows have in common."""

    threads: int | None
    progress: Progress


class Options(Work, total=False):
    """What functions of many points have in common."""

    to: Side


# The members are those that nobody else has, with their types: a relation of DuckDB has every name, as a column of its own.


class PandasSeries(Protocol):
    """A pandas Series."""

    @property
    def iloc(self) -> Any: ...
    @property
    def size(self) -> int: ...
    def to_frame(self) -> Any: ...


class PandasFrame(Protocol):
    """A pandas DataFrame."""

    @property
    def iloc(self) -> Any: ...
    @property
    def size(self) -> int: ...
    def iterrows(self) -> Any: ...


class XarrayArray(Protocol):
    """A DataArray of xarray."""

    @property
    def dims(self) -> Any: ...
    def to_dataset(self) -> Any: ...


class PolarsSeries(Protocol):
    """A polars Series."""

    def arg_true(self) -> Any: ...
    def to_physical(self) -> Any: ...


class PolarsFrame(Protocol):
    """A polars DataFrame."""

    def with_row_index(self) -> Any: ...
    def to_dicts(self) -> Any: ...


class PyarrowArray(Protocol):
    """A pyarrow Array or ChunkedArray."""

    def dictionary_encode(self) -> Any: ...
    def drop_null(self) -> Any: ...


class _PyarrowTable(Protocol):
    """A pyarrow Table or RecordBatch."""

    def replace_schema_metadata(self) -> Any: ...
    def to_pydict(self) -> Any: ...


class _PyarrowReader(Protocol):
    """A pyarrow RecordBatchReader."""

    def read_next_batch(self) -> Any: ...


PyarrowTable: TypeAlias = "_PyarrowTable | _PyarrowReader"


class _Array(Protocol):
    """An array by the Arrow PyCapsule interface."""

    def __arrow_c_array__(self, requested_schema: object | None = None) -> tuple[object, object]: ...


class _Stream(Protocol):
    """A chunked array, a table or a reader of record batches by the Arrow PyCapsule interface."""

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object: ...


#: A column or a table of any library that speaks the Arrow PyCapsule interface, as DuckDB's relations.
Arrow: TypeAlias = "_Array | _Stream"

OnError: TypeAlias = Literal["raise", "null"]
