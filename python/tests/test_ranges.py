"""One spelling of a range, over the numbers of a case, spectra and designs; and records whose times are told apart."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
import standfast
import xarray as xr
from standfast import StandfastError

EXAMPLES = Path(__file__).parents[2] / "examples"
GODA, RANDOM = EXAMPLES / "goda-2000.toml", EXAMPLES / "goda-2000-random.toml"
BLOCK = {"block": {"b1": 1, "b2": 1, "d": 3, "mu_s": 50, "gravity": 1}}
STATUE = {"body": {"width": "0.6 m", "height": "2 m", "density": "2.6 t/m3", "friction": 0.5}}
SHAKEN = STATUE | {"random": {"friction": {"normal": {"mean": 0.5, "sd": 0.05}}}}
PULSE = np.sin(np.linspace(0, 2 * np.pi, 101))


def along(over: Any, **options: Any) -> list[float]:
    """The values of a curve along a number of the case."""
    found = standfast.probability(RANDOM, over=over, samples=1 << 10, **options)
    assert found.fragility is not None
    return [round(point.value, 9) for point in found.fragility.points]


def curve(scale: Any) -> list[float]:
    return standfast.spectrum(BLOCK, "overturning", scale=scale, base=[0.5, 0.5], dt=4).points.scale.tolist()


def test_a_range_is_spelled_alike_everywhere() -> None:
    widths = xr.DataArray([1200.0, 1600.0, 2000.0], dims="width", attrs={"units": "cm"})
    for over in ("width=12 m..20 m:3", {"width": "12 m..20 m:3"}, {"width": [12, 16, 20]}, {"width [cm]": widths.values}, {"width": widths},
                 {"width": ["12 m", "16 m", "20 m"]}, {"width": np.array(["12 m", "16 m", "20 m"])}):  # fmt: skip
        assert along(over) == [12, 16, 20], over
    for scale in ("0.5..2:4", [0.5, 1.0, 1.5, 2.0], (0.5, 1.0, 1.5, 2.0), xr.DataArray([0.5, 1.0, 1.5, 2.0], dims="scale")):
        assert curve(scale) == [0.5, 1.0, 1.5, 2.0]
    by_ends = standfast.design(GODA, vary="width", target="factor=1.2", lower="10 m", upper=20, and_="friction", and_lower=0.5, and_upper=0.7)
    by_range = standfast.design(GODA, vary="width=10 m..20 m", target="factor=1.2", and_="friction=0.5..0.7")
    assert by_range.to_json() == by_ends.to_json()
    assert standfast.design(GODA, vary="width = 10 m .. 20 m", target="factor=1.2").value == 15.46


def test_what_is_no_range_says_what_is() -> None:
    for asked in (lambda: curve((1, 2, 3)), lambda: along({"width": (12, 16, 20)})):
        with pytest.raises(TypeError, match=r"may be three values or the ends and how many; expected the list \[1.*, or the text '1.*\.\."):
            asked()
    for over in ({"pga": ["0.2 g", 0.4]}, {"pga": [0.4, "0.2 g"]}):
        with pytest.raises(StandfastError, match=r"over\['pga'\] has '0.2 g' beside 0.4, which has no unit; expected .* as \{'pga \[g\]': "):
            standfast.probability(SHAKEN, over=over, records=[PULSE], dt=0.01, unit="g")
    grid = xr.DataArray([[1.0, 2.0]], dims=["a", "b"])
    with pytest.raises(StandfastError, match="scale has the dimensions a, b; expected one"):
        curve(grid)
    with pytest.raises(StandfastError, match="scale is in 'm' by its attribute units; expected numbers without unit"):
        curve(xr.DataArray([1.0, 2.0], dims="scale", attrs={"units": "m"}))
    for wrong in ("width=10 m", "width=10 m..20 m:9", "width=..20 m"):
        with pytest.raises(StandfastError, match="expected the quantity and its range, as 'width=FROM..TO'"):
            standfast.design(GODA, vary=wrong, target="rest")
    with pytest.raises(StandfastError, match="beside and_lower or and_upper; expected the range once"):
        standfast.design(GODA, vary="width", target="rest", and_="friction=0.5..0.7", and_lower=0.5)


def test_a_bracket_belongs_to_the_name_where_nothing_parts_them() -> None:
    """As in headers of tables, by the one reader of both."""
    with pytest.raises(StandfastError) as caught:
        along({"load[1]": [1, 2]})
    assert "`load[1]`" in str(caught.value), caught.value


def test_records_are_one_at_least() -> None:
    for records in ([], ()):
        with pytest.raises(StandfastError, match="records is empty; expected one record or more"):
            standfast.probability(SHAKEN, over="pga=0.2 g..0.8 g:4", records=records, dt=0.01, unit="g")


def series(step: float, labels: Any = None) -> pd.Series:
    return pd.Series(PULSE, index=np.arange(len(PULSE)) * step if labels is None else labels)


def test_both_directions_of_a_shaking_have_the_same_times() -> None:
    message = r"at row 1 base\['horizontal'\] has the time 0.01 s, and base\['vertical'\] 0.02 s; expected the same times in both directions"
    with pytest.raises(StandfastError, match=message):
        standfast.simulate(STATUE, base={"horizontal": series(0.01), "vertical": series(0.02)}, unit="g", strength=False)
    both = [{"horizontal": series(0.02), "vertical": xr.DataArray(PULSE, dims="t", coords={"t": np.arange(101) * 0.01})}]
    with pytest.raises(StandfastError, match=r"records\[0\]\['horizontal'\] has the time 0.02 s, and records\[0\]\['vertical'\] 0.01 s"):
        standfast.probability(SHAKEN, over="pga=0.2 g..0.8 g:3", records=both, unit="g", samples=10_000)
    # Those of one moment, each in its own way of saying it, go together; and shakings of their own have steps of their own.
    same = {"horizontal": series(0.01), "vertical": series(0.01, pd.to_timedelta(np.arange(101) * 10, unit="ms"))}
    standfast.simulate(STATUE, base=same, unit="g", strength=False)
    standfast.probability(SHAKEN, over="pga=0.2 g..0.8 g:3", records=[series(0.01), series(0.02)], unit="g", samples=10_000)


def test_a_record_may_be_an_array_of_xarray() -> None:
    array = xr.DataArray(0.45 * PULSE, dims="time", coords={"time": np.arange(101) * 0.01}, attrs={"units": "g"})
    expected = standfast.simulate(STATUE, base=0.45 * PULSE, dt=0.01, unit="g", strength=False)
    for base in (array, array.drop_attrs(), array.assign_coords(time=pd.to_timedelta(np.arange(101) * 10, unit="ms")), {"horizontal": array}):
        found = standfast.simulate(STATUE, base=base, unit="g", strength=False)
        # Times in other units differ by their rounding.
        assert found.overturned and expected.overturned and found.max_slide == pytest.approx(expected.max_slide, rel=1e-9)
    spelled = (array * 9.80665).assign_attrs(units="m s-2")
    assert standfast.simulate(STATUE, base=spelled, unit="m/s2", strength=False).overturned
    for base, options, message in (
        (spelled, {"unit": "g"}, "base is in 'm s-2' by its attribute units, and unit is 'g'; expected unit='m/s2'"),
        (array, {}, "base is in 'g' by its attribute units, and unit is None; expected unit='g'"),
        (array.expand_dims("place"), {"unit": "g"}, "base has the dimensions place, time; expected one"),
        (array, {"unit": "g", "dt": 0.02}, "has the time .* in its index at row"),
    ):
        with pytest.raises(StandfastError, match=message):
            standfast.simulate(STATUE, base=base, strength=False, **options)
    with pytest.raises(TypeError, match="dt is missing"):
        standfast.simulate(STATUE, base=array.drop_vars("time"), unit="g", strength=False)
