"""What to call in place of what is refused."""

from __future__ import annotations

import sys
from typing import Any, NamedTuple, NoReturn


def is_of(value: object, library: str, *kinds: str) -> bool:
    """Whether the value is of a class of a library, which is not imported for the question."""
    module = sys.modules.get(library)
    if module is None:
        return False
    return any(isinstance(value, found) for kind in kinds if isinstance(found := getattr(module, kind, None), type))


def called(value: object) -> str:
    return f"{type(value).__module__.split('.')[0]} {type(value).__name__}"


def short(text: str) -> str:
    text = " ".join(text.split())
    return text if len(text) <= 40 else text[:37] + "..."


def shown(value: object) -> str:
    return "None" if value is None else f"{short(repr(value))}, a {type(value).__name__}"


class Advice(NamedTuple):
    """What to call in place of a call that is refused."""

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
        return "np.uint8" if self.function == "classify" else "float"

    def refuse_lazy(self, value: Any, name: str) -> None:
        """Refuses what would be loaded whole or lose its labels."""
        if is_of(value, "xarray", "DataArray", "Dataset", "Variable", "DataTree"):
            lazy = ""
            if hasattr(value, "__dask_graph__") and value.__dask_graph__() is not None:
                lazy = f", dask='parallelized', output_dtypes=[{self.dtype}]"
            kind = "an xarray Dataset; its variables go in one by one" if is_of(value, "xarray", "Dataset") else "an xarray object"
            raise TypeError(
                f"{name} is {kind}, and dimensions that have names are matched by xarray. "
                f"Call xarray.apply_ufunc({self.call}, ...{lazy})"
            )
        if hasattr(value, "__dask_graph__"):
            if is_of(value, "dask.array", "Array"):
                how = f"dask.array.map_blocks({self.call}, ..., dtype={self.dtype})"
            elif is_of(value, "dask.dataframe", "DataFrame"):
                how = f"frame.map_partitions(standfast.{self.function}), with map={{...}} where its columns have other names"
            elif is_of(value, "dask.dataframe", "Series"):
                how = f"dask.dataframe.map_partitions(standfast.{self.function}, ...), or map_partitions of the frame"
            else:
                how = ".compute() first"
            raise TypeError(f"{name} is a {called(value)}, which is lazy and would be loaded whole. Call {how}")
        if is_of(value, "polars", "LazyFrame"):
            raise TypeError(f"{name} is a polars LazyFrame, which holds no values yet. Call .collect()")
        if is_of(value, "polars", "Expr"):
            raise TypeError(
                f"{name} is a polars expression, which holds no values. Call "
                f"frame.with_columns(mode=standfast.classify(frame)), or give columns of the DataFrame"
            )
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

    def refuse_table(self, value: object, name: str) -> NoReturn:
        """Refuses a table in place of a column."""
        raise TypeError(
            f"{name} is a {called(value)}, a whole table; expected a column of it. standfast.{self.function} takes a table alone, "
            "with map={...} where its columns have other names"
        )
