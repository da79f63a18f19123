"""A map of modes over force and elevation for several frictions: xarray matches dimensions by name."""

import numpy as np
import standfast
import xarray as xr

force = xr.DataArray(np.linspace(0, 2, 201), dims="force", name="force")
elevation = xr.DataArray(np.linspace(-1, 1, 101), dims="elevation")
friction = xr.DataArray([0.4, 0.6, 0.8], dims="friction")
points = xr.Dataset(coords={"force": force, "elevation": elevation, "friction": friction})

modes = xr.apply_ufunc(standfast.classify, 0.8, points.elevation, points.force, points.friction)
modes = modes.rename("mode").assign_attrs(flag_values=list(standfast.Mode), flag_meanings=[m.symbol for m in standfast.Mode])

assert modes.dims == ("elevation", "force", "friction") and modes.dtype == np.uint8
resting = (modes == standfast.Mode.REST).mean(["force", "elevation"])
for mu in friction.values:
    print(f"μ = {mu}: at rest in {float(resting.sel(friction=mu)):.1%} of the map")
