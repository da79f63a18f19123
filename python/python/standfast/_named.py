"""Sweeps over the named dimensions of xarray, which is never imported: who has such an object has imported it."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ._advice import called, is_of


def is_named(table: object) -> bool:
    """Whether a table is a Dataset, or a dict that has a DataArray."""
    if is_of(table, "xarray", "Dataset"):
        return True
    return isinstance(table, Mapping) and any(is_of(value, "xarray", "DataArray") for value in table.values())


def variables_of(table: Any) -> dict[str, Any]:
    """What may vary: the entries of a dict, or the variables and coordinates of a Dataset, under names with their units."""
    given = {name: table[name] for name in table.variables} if is_of(table, "xarray", "Dataset") else dict(table)
    return {_heading(str(name), value): value for name, value in given.items()}


def _heading(name: str, value: Any) -> str:
    unit = value.attrs.get("units") if is_of(value, "xarray", "DataArray") else None
    return name if unit is None or name.endswith("]") and " [" in name else f"{name} [{unit}]"


class Broadcast(NamedTuple):
    """Arrays broadcast by the names of their dimensions."""

    arrays: dict[str, NDArray[Any]]
    #: One of them, with dimensions and coordinates.
    template: Any

    @classmethod
    def of(cls, given: Mapping[str, Any]) -> Broadcast:
        """
        Raises:
            TypeError: for what has no values yet, and for arrays whose dimensions have no names.
            ValueError: for coordinates that differ.
        """
        xr = sys.modules["xarray"]
        for name, value in given.items():
            if not is_of(value, "xarray", "DataArray"):
                if not isinstance(value, str) and np.ndim(value) > 0:
                    raise TypeError(f"{name} is a {called(value)} beside arrays of xarray; expected a DataArray, or one value")
            elif value.chunks is not None:
                raise TypeError(f"{name} is an xarray object, which is lazy and would be loaded whole. Call .compute() first")
        labelled = {name: value for name, value in given.items() if is_of(value, "xarray", "DataArray")}
        try:
            spread = xr.broadcast(*xr.align(*labelled.values(), join="exact", copy=False))
        except ValueError as error:
            raise ValueError(f"the coordinates of {', '.join(labelled)} differ: {error}") from None
        return cls({**given, **{name: _masked(one.values) for name, one in zip(labelled, spread)}}, spread[0])

    def dataset(self, results: Mapping[str, NDArray[Any]], said: Mapping[str, tuple[str | None, str]]) -> Any:
        """Results as a Dataset, with their units and words."""
        variables = {}
        for name, values in results.items():
            unit, words = said[name]
            attributes = {"long_name": words} | ({} if unit is None else {"units": unit})
            variables[name] = (self.template.dims, _filled(values), attributes)
        return sys.modules["xarray"].Dataset(variables, coords=self.template.coords)


def _masked(values: NDArray[Any]) -> NDArray[Any]:
    """NaN is what is missing, to xarray."""
    missing = np.isnan(values) if values.dtype.kind == "f" else np.False_
    return np.ma.MaskedArray(values, missing) if missing.any() else values


def _filled(values: NDArray[Any]) -> NDArray[Any]:
    """Without mask: NaN, an empty word or ``None`` where there is no result."""
    if not isinstance(values, np.ma.MaskedArray):
        return values
    if values.dtype.kind in "fU":
        filled: NDArray[Any] = values.filled(np.nan if values.dtype.kind == "f" else "")
        return filled
    objects: NDArray[Any] = values.data.astype(object)
    objects[np.ma.getmaskarray(values)] = None
    return objects
