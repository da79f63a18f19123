"""The native module; what users call stands beside it."""

from collections.abc import Callable, Sequence
from typing import Any, Protocol, TypedDict, final

import numpy as np
from numpy.typing import NDArray

__all__ = [
    "ArrowArray",
    "ArrowTable",
    "CaseAnswer",
    "CaseError",
    "ChanceAnswer",
    "MotionAnswer",
    "NUMBER",
    "NoSolution",
    "StandfastError",
    "Sweep",
    "__commit__",
    "__version__",
    "assess",
    "beginnings",
    "boundary",
    "classify",
    "classify_columns",
    "classify_point",
    "classify_table",
    "closest",
    "contact_conditions",
    "contact_names",
    "contact_rows",
    "design",
    "directions",
    "draws",
    "diagram_numbers",
    "diagram_outlines",
    "diagram_svg",
    "failing_modes",
    "examples",
    "explain",
    "heading",
    "limit_states",
    "make_array",
    "make_table",
    "minimum",
    "modes",
    "motions",
    "onset",
    "onset_columns",
    "onset_table",
    "plain_effort",
    "picture",
    "probability",
    "read_column",
    "read_table",
    "refuse_column",
    "reliability",
    "sheet",
    "simulate",
    "spectrum",
    "stack",
    "title_block",
]

__version__: str
__commit__: str | None
class StandfastError(ValueError): ...
class CaseError(StandfastError): ...
class NoSolution(StandfastError): ...

#: Stands before what was a number in a column of texts and numbers.
NUMBER: str

_Mask = NDArray[np.bool_] | None
_Values = NDArray[Any] | list[str]
_Read = tuple[NDArray[np.float64], _Mask]

@final
class ArrowArray:
    """An array of Arrow."""

    @property
    def name(self) -> str:
        """What the array is called in a table."""

    @property
    def metadata(self) -> dict[str, str]:
        """What is said of the values."""

    @property
    def type(self) -> str:
        """Arrow's name of the type of the values; that of the texts, for texts encoded by a dictionary."""

    @property
    def null_count(self) -> int:
        """How many values are null."""

    def parts(self) -> tuple[NDArray[Any], _Mask, list[str] | None]: ...
    def slice(self, start: int, length: int) -> ArrowArray: ...
    def __len__(self) -> int: ...
    def __arrow_c_schema__(self) -> object: ...
    def __arrow_c_array__(self, requested_schema: object | None = None) -> tuple[object, object]: ...
    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object: ...

@final
class ArrowTable:
    """A table of Arrow, in batches."""

    @property
    def column_names(self) -> list[str]:
        """The names of the columns."""

    def column(self, name: str) -> ArrowArray: ...
    def slice(self, start: int, length: int) -> ArrowTable: ...
    def __len__(self) -> int: ...
    def __arrow_c_schema__(self) -> object: ...
    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object: ...

class _Run(Protocol):
    """`_run.Run`."""

    @property
    def threads(self) -> int | None: ...
    @property
    def null_errors(self) -> bool: ...
    @property
    def nan_is_missing(self) -> bool: ...
    @property
    def right(self) -> bool: ...
    @property
    def progress(self) -> Callable[[int, int | None], object] | None: ...
    @property
    def total(self) -> int | None: ...

def make_array(
    name: str, values: _Values, missing: _Mask, words: list[str] | None, metadata: dict[str, str] | None = None
) -> ArrowArray: ...
def make_table(columns: Sequence[ArrowArray]) -> ArrowTable: ...
def closest(word: str, known: Sequence[str]) -> str | None: ...
#: Title, size, and labels, each with its box and its type size.
_Kept = tuple[str, tuple[float, float], list[tuple[str, list[float]]]]
def picture(svg: str, kept: _Kept, scale: float | None) -> bytes: ...
def heading(column: str) -> tuple[str, str | None]: ...
def read_column(column: Any, name: str) -> _Read: ...
def read_table(table: Any, columns: Sequence[tuple[str, str]], names: Sequence[str]) -> list[_Read]: ...
def refuse_column(name: str, column: str, found: Sequence[str], names: Sequence[str]) -> None: ...

_Rows = list[tuple[int, NDArray[np.float64]]]
_Wrong = tuple[int, str, str] | None
_Ends = tuple[str | None, str | None]
_Progress = Callable[[int, int | None], object] | None
_Relation = tuple[str, str, float, str, float, bool, float]

def limit_states(
    arrays: Sequence[NDArray[Any]], mask: _Mask, columns: Sequence[str], run: _Run
) -> tuple[list[NDArray[np.float64]], _Mask]: ...
def contact_names() -> tuple[list[str], list[str]]: ...
def contact_rows(
    arrays: Sequence[NDArray[np.float64]],
    sets: tuple[NDArray[np.uint8] | None, NDArray[np.uint16] | None],
    numbers: _Rows,
    wrong: NDArray[np.bool_] | None,
    run: _Run,
) -> _Wrong: ...
def contact_conditions(row: Sequence[float], code: int | None) -> list[_Relation]: ...
def explain(gamma: float, k_prime: float, k: float, mu: float, omega: float, right: bool) -> tuple[str, str]: ...
def design(
    file: tuple[str, str], vary: str, wanted: tuple[str | None, bool], ends: _Ends, progress: _Progress
) -> tuple[str, str, list[tuple[str, str]]]: ...
def boundary(
    file: tuple[str, str],
    vary: str,
    wanted: tuple[str | None, bool],
    ends: _Ends,
    and_: tuple[str, _Ends],
    progress: _Progress,
) -> tuple[str, str, str, str | None]: ...
def minimum(
    file: tuple[str, str], vary: Sequence[tuple[str, str, str]], target: str | None, cost: str, progress: _Progress
) -> tuple[str, str, list[tuple[str, str]]]: ...
def title_block() -> list[str]: ...
def sheet(
    file: tuple[str, str],
    date: str | None,
    up_to: float,
    told: Sequence[tuple[str, str]],
    print: tuple[str, bool, bool],
    progress: _Progress,
) -> tuple[str, bytes | None]: ...

_RecordOf = tuple[NDArray[np.float64], NDArray[np.float64], str | None] | None
_Numbered = NDArray[np.float64]

@final
class MotionAnswer:
    """The motion of a case in each of its situations, the worst first."""

    def text(self) -> str:
        """For reading."""

    def json(self) -> str:
        """As one JSON document."""

    def warnings(self) -> list[tuple[str, str]]:
        """Name and words of each warning of the worst situation."""

    def is_si(self) -> bool:
        """Whether quantities are in SI units; those of a block are in the units of its case."""

    def files(self) -> dict[str, str]:
        """The contents of the files that the case names."""

    def figures(self) -> list[tuple[str, str, str, _Kept]]:
        """Words, suffix and SVG of each figure of the worst situation, and what else a picture is made of."""

    def series(
        self, place: int, dt: float, events: bool
    ) -> tuple[list[tuple[str, str, str, _Numbered]], int, NDArray[np.uint8]]:
        """The motion in one of the situations, every `dt` until it ends, and on both sides of events if they are asked for."""

_MotionCase = tuple[str, str, str, dict[str, str]]

def simulate(
    case: _MotionCase,
    base: tuple[_RecordOf, _RecordOf],
    options: tuple[bool | None, bool],
    copies: tuple[int | None, float | list[tuple[str, float]] | None, int | None],
    progress: _Progress,
) -> MotionAnswer: ...

class _Motions(Protocol):
    """`_motions._Asked`."""

    @property
    def horizontal(self) -> list[NDArray[np.float64]]: ...
    @property
    def vertical(self) -> list[NDArray[np.float64]] | None: ...
    @property
    def steps(self) -> list[float]: ...
    @property
    def unit(self) -> str | None: ...
    @property
    def names(self) -> list[str]: ...
    @property
    def bodies(self) -> list[list[float]]: ...
    @property
    def number(self) -> int: ...
    @property
    def cross(self) -> bool: ...
    @property
    def divergence(self) -> bool: ...
    @property
    def strength(self) -> bool: ...
    @property
    def copies(self) -> tuple[int | None, float | list[tuple[str, float]] | None, int | None]: ...
    @property
    def threads(self) -> int | None: ...
    @property
    def progress(self) -> _Progress: ...

def motions(
    case: _MotionCase, asked: _Motions
) -> tuple[
    list[tuple[str, str, str, NDArray[np.float64]]],
    list[tuple[str, str, NDArray[np.int64]]],
    list[tuple[str, str, NDArray[np.bool_]]],
    list[str],
    list[tuple[str, str, int]],
    bool,
]: ...

class _Spectrum(Protocol):
    """`_spectrum._Asked`."""

    @property
    def kind(self) -> str: ...
    @property
    def size(self) -> str | list[float] | None: ...
    @property
    def slenderness(self) -> str | list[float] | None: ...
    @property
    def ratio(self) -> str | list[float] | None: ...
    @property
    def scale(self) -> str | list[float] | None: ...
    @property
    def threads(self) -> int | None: ...
    @property
    def progress(self) -> Callable[[int, int | None], object] | None: ...

def spectrum(
    case: _MotionCase, base: tuple[_RecordOf, _RecordOf], asked: _Spectrum
) -> tuple[str, str, str, list[tuple[str, str, str, _Kept]], bool]: ...
def reliability(
    limit_state: Callable[..., object], laws: tuple[str, str], line: str | None, asked: _Asked
) -> tuple[
    list[str],
    tuple[float, float, float],
    float,
    tuple[str, bool],
    tuple[int, bool],
    int,
    list[tuple[float, list[float], list[float], list[float]]],
    list[float],
]: ...
def stack(
    bodies: Sequence[Sequence[float]], joints: Sequence[Sequence[float]], shaking: tuple[Sequence[float], bool]
) -> tuple[str, str]: ...

class _Asked(Protocol):
    """`_probability._Asked`."""

    @property
    def method(self) -> str | None: ...
    @property
    def seed(self) -> int: ...
    @property
    def precision(self) -> float: ...
    @property
    def floor(self) -> float: ...
    @property
    def samples(self) -> int: ...
    @property
    def years(self) -> float | None: ...
    @property
    def threads(self) -> int | None: ...
    @property
    def progress(self) -> _Progress: ...

@final
class ChanceAnswer:
    """The answer to a case with random numbers."""

    def text(self) -> str:
        """For reading."""

    def json(self) -> str:
        """As one JSON document."""

    def warnings(self) -> list[tuple[str, str]]:
        """Name and words of each of its warnings."""

    def figures(self) -> list[tuple[str, str, str, _Kept]]:
        """Words, suffix and SVG of each figure, and what else a picture is made of."""

def probability(
    file: tuple[str, str], asked: _Asked, records: Sequence[tuple[_RecordOf, _RecordOf]]
) -> ChanceAnswer: ...
def plain_effort() -> tuple[int, float, float, int]: ...
def draws(
    file: tuple[str, str], situation: str | None, count: int, seed: int
) -> tuple[list[tuple[str, str | None, _Numbered]], list[_Numbered], NDArray[np.uint8], list[str] | None]: ...

_Polyline = list[tuple[float, float]]

def beginnings() -> list[tuple[str, str, str]]: ...
def examples() -> list[tuple[str, bytes]]: ...
def modes() -> list[tuple[str, str, str]]: ...
def classify(
    arrays: Sequence[NDArray[Any]], mask: _Mask, out: NDArray[np.uint8] | None, run: _Run
) -> tuple[NDArray[np.uint8], _Mask]: ...
def classify_point(gamma: float, k_prime: float, k: float, mu: float, right: bool) -> int: ...
def onset(
    arrays: Sequence[NDArray[Any]], mask: _Mask, columns: Sequence[str], run: _Run
) -> tuple[list[NDArray[Any]], _Mask]: ...
def classify_columns(columns: Sequence[Any], names: bool, run: _Run) -> ArrowArray: ...
def classify_table(table: Any, places: Sequence[str | float], names: bool, run: _Run) -> ArrowArray: ...
def onset_columns(columns: Sequence[Any], choice: Sequence[str], run: _Run) -> ArrowTable: ...
def onset_table(
    table: Any, places: Sequence[str | float], choice: Sequence[str], run: _Run
) -> ArrowTable: ...

class _Base(TypedDict):
    """What a body stands on: a base that crushes or ground that fails; rigid if it is neither."""

    omega: float | None
    law: str | None
    share: float

class _Outlines(TypedDict):
    """What a diagram shows; strings are markup, but for names, letters and colours."""

    window: tuple[float, float]
    #: Code, symbol, colour and outlines.
    areas: list[tuple[int, str, str, list[_Polyline]]]
    #: Name, code of the mode it is resolved to, bits of all modes, and outlines.
    unresolved: list[tuple[str, int, int, list[_Polyline]]]
    #: Name, formula, shorter name, whether it is dashed, and parts.
    lines: list[tuple[str, str, str, bool, list[_Polyline]]]
    #: The boundaries on rigid ground, to be drawn behind.
    rigid: list[_Polyline]
    #: Letter, its markup, k and μ.
    points: list[tuple[str, str, float, float]]
    #: Value, name with formula, and the point whose coordinate it is.
    k_marks: list[tuple[float, str, tuple[float, float]]]
    mu_marks: list[tuple[float, str, tuple[float, float] | None]]

def diagram_numbers(
    from_: float, to: float, length: float, upright: bool
) -> tuple[list[tuple[float, str]], list[float]]: ...
def diagram_outlines(
    gamma: float, k_prime: float, base: _Base, window: tuple[float, float] | None, places: NDArray[np.float64], names: list[str]
) -> _Outlines: ...
def failing_modes(
    gamma: float, k_prime: float, law: str, share: float, places: NDArray[np.float64]
) -> bytes: ...
def diagram_svg(
    gamma: float, k_prime: float, base: _Base, window: tuple[float, float] | None, places: NDArray[np.float64], names: list[str]
) -> str: ...

@final
class CaseAnswer:
    """The answer to a case."""

    def text(self) -> str:
        """For reading."""

    def json(self) -> str:
        """As one JSON document."""

    def warnings(self) -> list[tuple[str, str]]:
        """Name and words of each of its warnings."""

    def figures(self) -> list[tuple[str, str, str, _Kept]]:
        """Words, suffix and SVG of each figure, and what else a picture is made of."""

def assess(name: str, text: str, up_to: float, all: bool) -> CaseAnswer: ...
def directions(
    name: str, text: str, step: float
) -> tuple[str, str, str, list[tuple[str, str, str, _Kept]], list[tuple[str, str]]]: ...

#: Name, how many rows have it, the index of the first, and what is said of that one.
_Minded = tuple[str, int, list[int], str]
_Numbers = tuple[NDArray[np.float64], NDArray[np.bool_] | None]

@final
class Sweep:
    """A case and the columns that vary it."""

    def __new__(
        cls,
        name: str,
        text: str,
        given: Any,
        map: Sequence[tuple[str, str]],
        results: Sequence[str] | None,
        null: bool,
        threads: int | None,
    ) -> Sweep: ...
    @property
    def places(self) -> list[int]:
        """The places of the columns that vary the case."""

    @property
    def varied(self) -> list[tuple[str, str]]:
        """The columns and the keys that they vary."""

    @property
    def notes(self) -> list[str]:
        """What goes with them, in sentences."""

    @property
    def warnings(self) -> list[tuple[str, str]]:
        """Warnings: names and words."""

    @property
    def results(self) -> list[tuple[str, str | None, str | None]]:
        """The results: names, units and words."""

    def answer(
        self, columns: Sequence[_Numbers | list[str | None]], shape: list[int], progress: Any | None
    ) -> tuple[list[tuple[str, NDArray[Any], NDArray[np.bool_] | list[str] | None]], list[int], list[_Minded]]:
        """The results of arrays, the rows that have none, and the warnings."""

    def answer_table(self, progress: Any | None, total: int | None) -> tuple[ArrowTable, list[_Minded]]:
        """The results of the table that was given, and the warnings."""
