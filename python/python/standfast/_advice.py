"""What to call in place of what is refused."""

from __future__ import annotations

import sys
from typing import Any, NamedTuple, NoReturn

import numpy as np


def is_of(value: object, library: str, *kinds: str) -> bool:
    """Whether the value is of a class of a library, which is not imported for the question."""
    module = sys.modules.get(library)
    if module is None:
        return False
    return any(isinstance(value, found) for kind in kinds if isinstance(found := getattr(module, kind, None), type))


class Unit(NamedTuple):
    """The unit of a quantity, as its library has it."""

    library: str
    words: str
    #: What a quantity calls its number.
    number: str
    #: Of a plain number, a percentage or the like, as 1 in the unit it is a ratio of; ``None`` of what has a dimension.
    ratio: Any

    def __str__(self) -> str:
        return f"a quantity of {self.library}, in {self.words}"


def unit_of(value: Any) -> Unit | None:
    """The unit of a quantity of pint or astropy, or of another array that has one; ``None`` of all else."""
    if is_of(value, "pint", "Quantity"):
        # To pint an angle has no dimension either.
        is_ratio = not value.dimensionality and value.to_base_units().unitless
        return Unit("pint", str(value.units), "magnitude", value.to_base_units().magnitude if is_ratio else None)
    if is_of(value, "astropy.units", "Quantity"):
        is_ratio = value.unit.is_equivalent("")
        return Unit("astropy", str(value.unit), "value", value.to_value("") if is_ratio else None)
    # What has dimensions or labels has a unit as one of its attributes.
    if not isinstance(value, np.ndarray) and (not hasattr(value, "__array__") or hasattr(value, "dims") or hasattr(value, "iloc")):
        return None
    unit = getattr(value, "unit", None) or getattr(value, "units", None)
    if unit is None or callable(unit):
        return None
    return Unit(type(value).__module__.split(".")[0], str(unit), "value", None)


def called(value: object) -> str:
    return f"{type(value).__module__.split('.')[0]} {type(value).__name__}"


def short(text: str) -> str:
    text = " ".join(text.split())
    return text if len(text) <= 40 else text[:37] + "..."


def shown(value: object) -> str:
    kind = type(value).__name__
    return "None" if value is None else f"{short(repr(value))}, {'an' if kind[0] in 'aeiouAEIOU' else 'a'} {kind}"


def is_plain(text: str) -> bool:
    """Whether a text is a number without unit, which a case does not take for a number."""
    try:
        float(text)
    except ValueError:
        return False
    return True


#: Functions of one point.
OF_ONE = ("explain", "contact_conditions", "Diagram")
#: Functions of a case and a table.
_OF_CASES = ("assess_table", "varied")
#: Functions of arrays that are not answers for each of their values.
_OF_WHOLE = ("simulate", "spectrum", "probability")


class Advice(NamedTuple):
    """What to call in place of a call that is refused.

    Attributes:
        function: that was called, of ``standfast``.
        result: one of the columns of its answer, if that has several.
    """

    function: str
    result: str | None = None

    @property
    def call(self) -> str:
        """A function of arrays whose answer is one array."""
        name = f"standfast.{self.function}"
        return name if self.result is None else f"lambda *columns: {name}(*columns).{self.result}"

    @property
    def dtype(self) -> str:
        """That of its answer."""
        if self.function == "symbols":
            return "'<U5'"
        return "np.uint8" if self.result == "mode" or self.function == "classify" else "float"

    @property
    def _in_frame(self) -> str:
        """The answer beside the columns of a polars DataFrame."""
        if self.function == "symbols":
            return 'frame.with_columns(symbol=standfast.symbols(frame["mode"]))'
        if self.result is None:
            return f"frame.with_columns(mode=standfast.{self.function}(frame))"
        return f"frame.hstack(standfast.{self.function}(frame))"

    def instead(self, name: str, unit: Unit) -> str:
        """What is expected in place of a quantity with a unit."""
        if self.function in _OF_CASES:
            # Which unit a number is in is said once, by the name.
            return f'numbers, with the unit behind the name: "{name} [{unit.words}]" and value.{unit.number}'
        if self.function in _OF_WHOLE:
            return f"its .{unit.number}" + (", and unit='m/s2'" if name.startswith("base") else ", in seconds" if name == "dt" else ", in SI units")
        return "a ratio, which has no unit"

    def refuse_lazy(self, value: Any, name: str) -> None:
        """Refuses what would be loaded whole or lose its labels."""
        if is_of(value, "xarray", "DataArray", "Dataset", "Variable", "DataTree"):
            self._refuse_xarray(value, name)
        if hasattr(value, "__dask_graph__"):
            raise TypeError(f"{name} is a {called(value)}, which is lazy and would be loaded whole. Call {self._in_parts(value)}")
        if is_of(value, "polars", "LazyFrame"):
            raise TypeError(f"{name} is a polars LazyFrame, which holds no values yet. Call .collect()")
        if is_of(value, "polars", "Expr"):
            how = f"Call {self._in_frame}, or give" if self.function not in (*OF_ONE, *_OF_CASES, *_OF_WHOLE) else "Give"
            raise TypeError(f"{name} is a polars expression, which holds no values. {how} columns of the DataFrame")
        if is_of(value, "pyarrow.dataset", "Dataset"):
            raise TypeError(
                f"{name} is a pyarrow Dataset, which holds no values yet. Call .to_table(), or .scanner().to_reader(), which is "
                "read batch by batch"
            )
        if is_of(value, "pyarrow.dataset", "Scanner"):
            raise TypeError(
                f"{name} is a pyarrow Scanner, which holds no values yet. Call .to_table(), or .to_reader(), which is read batch "
                "by batch"
            )

    def _refuse_xarray(self, value: Any, name: str) -> NoReturn:
        kind = "an xarray Dataset; its variables go in one by one" if is_of(value, "xarray", "Dataset") else "an xarray object"
        if self.function in OF_ONE:
            raise TypeError(f"{name} is {kind}; standfast.{self.function} takes one number for each, as float(...) of a value")
        lazy = ""
        if hasattr(value, "__dask_graph__") and value.__dask_graph__() is not None:
            lazy = f", dask='parallelized', output_dtypes=[{self.dtype}]"
        how = f"xarray.apply_ufunc({self.call}, ...{lazy})"
        if self.function in _OF_WHOLE:
            raise TypeError(f"{name} is {kind}; standfast.{self.function} takes arrays, as its .values")
        if self.function in _OF_CASES:
            kind = "an xarray object"
            how = "xarray.broadcast(...) and give the .values of each, or Dataset.to_dataframe()"
        raise TypeError(f"{name} is {kind}, and dimensions that have names are matched by xarray. Call {how}")

    def _in_parts(self, value: Any) -> str:
        """What to call on a lazy collection of dask."""
        if self.function == "varied" and is_of(value, "dask.dataframe", "DataFrame"):
            return "standfast.varied(case, frame.columns)"
        if self.function == "assess_table" and is_of(value, "dask.dataframe", "DataFrame"):
            # Without meta Dask would try it on numbers of its own, which no case may have.
            of_no_rows = "standfast.assess_table(case, frame.head(0))"
            return f"frame.map_partitions(lambda part: standfast.assess_table(case, part), meta={of_no_rows})"
        if self.function in (*OF_ONE, *_OF_CASES, *_OF_WHOLE):
            return ".compute() first"
        if is_of(value, "dask.array", "Array"):
            return f"dask.array.map_blocks({self.call}, ..., dtype={self.dtype})"
        if is_of(value, "dask.dataframe", "DataFrame") and self.function != "symbols":
            return f"frame.map_partitions(standfast.{self.function}), with map={{...}} where its columns have other names"
        if is_of(value, "dask.dataframe", "Series"):
            return f"dask.dataframe.map_partitions(standfast.{self.function}, ...), or map_partitions of the frame"
        return ".compute() first"

    def refuse_table(self, value: object, name: str) -> NoReturn:
        """Refuses a table in place of a column."""
        also = "" if self.function in (*OF_ONE, *_OF_CASES, *_OF_WHOLE, "symbols") else (
            f". standfast.{self.function} takes a table alone, with map={{...}} where its columns have other names"
        )
        raise TypeError(f"{name} is a {called(value)}, a whole table; expected a column of it{also}")
