"""The native module; what users call stands beside it."""

from collections.abc import Sequence
from typing import Any, final

import numpy as np
from numpy.typing import NDArray

__all__ = [
    "ArrowArray",
    "ArrowTable",
    "__version__",
    "assess",
    "classify",
    "classify_columns",
    "classify_table",
    "diagram_outlines",
    "diagram_svg",
    "make_array",
    "make_table",
    "modes",
    "onset",
    "onset_columns",
    "onset_table",
    "read_column",
    "read_table",
    "refuse_column",
]

__version__: str

@final
class ArrowArray:
    """An Arrow array for any library that speaks the PyCapsule interface."""

    def __len__(self) -> int: ...
    def __arrow_c_schema__(self) -> object: ...
    def __arrow_c_array__(self, requested_schema: object | None = None) -> tuple[object, object]: ...
    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object: ...

@final
class ArrowTable:
    """An Arrow table for any library that speaks the PyCapsule interface."""

    @property
    def column_names(self) -> list[str]:
        """The names of the columns."""

    def __len__(self) -> int: ...
    def __arrow_c_schema__(self) -> object: ...
    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object: ...

_Read = tuple[NDArray[np.float64], NDArray[np.bool_] | None]
_Values = NDArray[Any] | list[str]

def make_array(name: str, values: _Values, missing: NDArray[np.bool_] | None, symbols: bool) -> ArrowArray: ...
def make_table(columns: Sequence[tuple[str, _Values, NDArray[np.bool_] | None]]) -> ArrowTable: ...
def read_column(column: Any, name: str) -> _Read: ...
def read_table(table: Any, columns: Sequence[tuple[str, str]]) -> list[_Read]: ...
def refuse_column(name: str, column: str, found: Sequence[str]) -> None: ...

_Polyline = list[tuple[float, float]]

def modes() -> list[tuple[str, str, str]]: ...
def classify(
    arrays: Sequence[NDArray[Any]],
    out: NDArray[np.uint8] | None,
    threads: int | None,
) -> NDArray[np.uint8]: ...
def onset(
    arrays: Sequence[NDArray[Any]], threads: int | None
) -> tuple[NDArray[np.uint8], NDArray[np.uint16], list[NDArray[np.float64]]]: ...
def classify_columns(columns: Sequence[Any], threads: int | None, names: bool) -> ArrowArray: ...
def classify_table(table: Any, places: Sequence[str | float], threads: int | None, names: bool) -> ArrowArray: ...
def onset_columns(columns: Sequence[Any], threads: int | None) -> ArrowTable: ...
def onset_table(table: Any, places: Sequence[str | float], threads: int | None) -> ArrowTable: ...
def diagram_outlines(
    gamma: float, k_prime: float, window: tuple[float, float] | None
) -> dict[str, Any]: ...
def diagram_svg(
    gamma: float, k_prime: float, points: list[tuple[float, float, str]]
) -> tuple[str, str, str]: ...
def assess(name: str, text: str, up_to: float, all: bool) -> tuple[str, str, list[tuple[str, str, str]]]: ...
