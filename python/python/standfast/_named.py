"""Sweeps over the named dimensions of xarray, which is never imported: who has such an object has imported it."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import _standfast
from ._advice import called, is_of
from ._standfast import StandfastError


def is_named(table: object) -> bool:
    """Whether a table is a Dataset, or a dict that has a DataArray."""
    if is_of(table, "xarray", "Dataset"):
        return True
    return isinstance(table, Mapping) and any(is_of(value, "xarray", "DataArray") for value in table.values())


def variables_of(table: Any) -> dict[str, Any]:
    """What may vary: the entries of a dict, or the variables and coordinates of a Dataset, under names with their units."""
    given = {name: table[name] for name in table.variables} if is_of(table, "xarray", "Dataset") else dict(table)
    return {heading_of(str(name), value): value for name, value in given.items()}


def heading_of(name: str, value: Any) -> str:
    """A name with its unit: that behind it, or else that of a DataArray."""
    unit = units_of(value)
    return name if unit is None or _standfast.heading(name)[1] is not None else f"{name} [{unit}]"


def units_of(value: Any) -> str | None:
    """What a DataArray says of its unit."""
    unit = value.attrs.get("units") if is_of(value, "xarray", "DataArray") else None
    return None if unit is None else str(unit)


def values_along(value: Any, name: str) -> Any:
    """The values of a DataArray along its only dimension, where missing ones are masked; anything else as it is.

    Raises:
        StandfastError: for another number of dimensions.
        TypeError: for what would be loaded whole.
    """
    if not is_of(value, "xarray", "DataArray"):
        return value
    _refuse_lazy(name, value)
    if value.ndim != 1:
        dims = f"the dimensions {', '.join(map(str, value.dims))}" if value.ndim else "no dimension"
        raise StandfastError(f"{name} has {dims}; expected one, as {name}.isel({value.dims[0] if value.ndim else 'time'}=0) leaves of two")
    return _masked(value.values)


def index_of(value: Any) -> Any:
    """The index of a DataArray along its only dimension; ``None`` where it has none, and of anything else."""
    if not is_of(value, "xarray", "DataArray") or value.ndim != 1:
        return None
    return value.indexes.get(value.dims[0])


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
            StandfastError: for coordinates that differ.
        """
        xr = sys.modules["xarray"]
        for name, value in given.items():
            if not is_of(value, "xarray", "DataArray"):
                if not isinstance(value, str) and np.ndim(value) > 0:
                    raise TypeError(f"{name} is a {called(value)} beside arrays of xarray; expected a DataArray, or one value")
            else:
                _refuse_lazy(name, value)
        labelled = {name: value for name, value in given.items() if is_of(value, "xarray", "DataArray")}
        try:
            spread = xr.broadcast(*xr.align(*labelled.values(), join="exact", copy=False))
        except ValueError as error:
            raise StandfastError(f"the coordinates of {', '.join(labelled)} differ: {error}") from None
        return cls({**given, **{name: _masked(one.values) for name, one in zip(labelled, spread)}}, spread[0])

    def dataset(self, results: Mapping[str, NDArray[Any]], said: Mapping[str, tuple[str | None, str]]) -> Any:
        """Results as a Dataset, with their units and words."""
        variables = {}
        for name, values in results.items():
            unit, words = said[name]
            attributes = {"long_name": words} | ({} if unit is None else {"units": unit})
            variables[name] = (self.template.dims, _filled(values), attributes)
        return sys.modules["xarray"].Dataset(variables, coords=self.template.coords)


def _refuse_lazy(name: str, value: Any) -> None:
    if value.chunks is not None:
        raise TypeError(f"{name} is an xarray object, which is lazy and would be loaded whole. Call .compute() first")


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
