"""Sweeps of cases over columns, draws and named dimensions; factors on loads, and what the waves come to."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import polars as pl
import pyarrow as pa
import pytest
import standfast
import xarray as xr
from standfast import StandfastWarning, assess_table, varied

EXAMPLES = Path(__file__).parents[2] / "examples"
GODA = EXAMPLES / "goda-2000.toml"
RANDOM = EXAMPLES / "goda-2000-random.toml"
BLOCK: dict[str, Any] = {
    "body": {"width": 1, "height": 2, "mass": 4800, "friction": 0.7},
    "load": [{"name": "push", "force": "20 kN/m", "elevation": "1.5 m"}],
}
FRICTION, FORCE = [0.3, 0.5, 0.7], [10e3, 20e3, 30e3]


@pytest.fixture(autouse=True)
def quiet() -> Any:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", StandfastWarning)
        yield


def test_columns_vary_a_case_as_arrays_do() -> None:
    arrays = assess_table(BLOCK, {"friction": np.array(FRICTION), "load[1].force": np.array(FORCE)}, columns=["mode", "SF_sliding"])
    frame = pd.DataFrame({"friction": FRICTION, "force": FORCE}, index=list("abc"))
    drawn = standfast.draws({"point": {"gamma": 1, "k_prime": 0, "k": 0.5}, "random": {"mu": {"uniform": {"from": 0.3, "to": 0.7}}}}, 3)
    for friction, force in (
        (frame["friction"], frame["force"]), (pl.Series(FRICTION), FORCE), (pa.array(FRICTION), pl.Series(FORCE)),
        (pa.chunked_array([FRICTION]), frame["force"]), (frame["friction"].astype("Float64"), ["10 kN/m", "20 kN/m", "30 kN/m"]),
        (frame["friction"], pd.Series(["10 kN/m", "20 kN/m", "30 kN/m"], index=frame.index)),
    ):  # fmt: skip
        found = assess_table(BLOCK, {"friction": friction, "load[1].force": force}, columns=["mode", "SF_sliding"])
        assert found["mode"].tolist() == arrays["mode"].tolist() and found["SF_sliding"].tolist() == arrays["SF_sliding"].tolist()
    of_draws = assess_table(BLOCK, {"friction": drawn.mu}, columns=["SF_sliding"])["SF_sliding"]
    assert of_draws.tolist() == assess_table(BLOCK, {"friction": drawn.mu.to_numpy()}, columns=["SF_sliding"])["SF_sliding"].tolist()
    missing = assess_table(BLOCK, {"friction": pd.Series([0.5, None])}, columns=["mode"])["mode"]
    assert np.ma.getmaskarray(missing).tolist() == [False, True]
    with pytest.raises(ValueError, match="indexes of friction and load.1..force differ: at row 0, 'a' and 'c'"):
        assess_table(BLOCK, {"friction": frame["friction"], "load[1].force": frame["force"][::-1]})


def test_named_dimensions_come_back_as_a_dataset() -> None:
    friction = xr.DataArray(FRICTION, dims="mu", coords={"mu": FRICTION})
    force = xr.DataArray(FORCE, dims="storm", coords={"storm": ["a", "b", "c"]})
    found = assess_table(BLOCK, {"friction": friction, "load[1].force": force, "width": 1.0}, columns=["mode", "margin_sliding", "unique"])
    expected = assess_table(BLOCK, {"friction": np.array(FRICTION)[:, None], "load[1].force": FORCE}, columns=["mode", "margin_sliding"])
    assert isinstance(found, xr.Dataset) and found["mode"].dims == ("mu", "storm")
    assert found["mode"].values.tolist() == expected["mode"].tolist()
    assert found.margin_sliding.sel(mu=0.5, storm="b") == expected["margin_sliding"][1, 1]
    assert found.margin_sliding.attrs["units"] == "N/m" and "friction leaves" in found.margin_sliding.attrs["long_name"]
    # Of a Dataset, coordinates vary the case as variables do, and what varies nothing is left alone.
    kilo = xr.Dataset({"load[1].force": ("storm", [10.0, 20.0, 30.0], {"units": "kN/m"}), "names": ("storm", list("abc"))}, {"friction": FRICTION})
    of_all = assess_table(BLOCK, kilo, columns=["mode"])
    assert of_all["mode"].transpose("friction", "storm").values.tolist() == expected["mode"].tolist() and "friction" in of_all.coords
    assert varied(BLOCK, kilo).keys == {"load[1].force [kN/m]": "load[1].force", "friction": "body.friction"}
    holes = assess_table(BLOCK, {"friction": friction.where(friction > 0.4)}, columns=["SF_sliding", "mode"])
    assert holes.SF_sliding.isnull().values.tolist() == [True, False, False] and holes["mode"].values[0] == ""
    for given, words in [
        ({"friction": friction, "width": xr.DataArray([1.0, 2.0], dims="mu", coords={"mu": [0.3, 0.4]})}, "coordinates of friction, width differ"),
        ({"friction": friction, "foo": friction}, "'foo' is not a number of the case"),
        ({"width": friction.assign_attrs(units="kN")}, "`width` in `kN`: the unit does not fit"),
    ]:
        with pytest.raises(ValueError, match=words):
            assess_table(BLOCK, given)
    with pytest.raises(TypeError, match="width is a builtins list beside arrays of xarray; expected a DataArray"):
        assess_table(BLOCK, {"friction": friction, "width": [1.0, 2.0, 3.0]})
    with pytest.raises(TypeError, match=r"friction is an xarray object, which is lazy.*\.compute\(\)"):
        assess_table(BLOCK, {"friction": friction.chunk()})


def test_draws_go_into_a_table_with_all_their_numbers() -> None:
    """The mode of each row is that of its draw, with the factors on thrust and uplift that were drawn."""
    drawn = standfast.draws(RANDOM, 2000, seed=7)
    assert {"bias.P", "bias.U"} < set(drawn.column_names)
    inputs = [name for name in drawn.column_names if name not in ("mode", "k_eff", "k_prime_eff")]
    frame = pl.DataFrame(drawn)
    for table in (frame.select(inputs), drawn[inputs], frame.select(inputs).to_pandas()):
        found = assess_table(RANDOM, table, columns=["mode", "P", "margin_sliding"])
        assert list(found["mode"]) == drawn.mode.to_pylist()
    plain = assess_table(RANDOM, {name: drawn[name] for name in inputs if not name.startswith("bias.")}, columns=["P", "U", "buoyant_weight"])
    thrust = plain["P"] * drawn["bias.P"]
    margin = drawn.friction * (plain["buoyant_weight"] - plain["U"] * drawn["bias.U"]) - thrust
    np.testing.assert_allclose(found["P"], thrust, rtol=1e-12)
    np.testing.assert_allclose(found["margin_sliding"], margin, rtol=1e-9, atol=1e-9 * abs(thrust).max())
    for table, words in [
        ({"bias.X": [1.0]}, "the case has no number `bias.X`"),
        ({"bias.force": [1.0]}, r"the case has no \[\[load\]\] for `bias.force`"),
        ({"bias.P": [1.0, -0.5]}, r"at index 1, .*`bias.P` is -0.5; expected a number from 0"),
    ]:
        with pytest.raises(ValueError, match=words):
            assess_table(RANDOM, table)


def test_the_sea_is_among_the_results_that_are_named() -> None:
    heights = [5.0, 6.3]
    names = ["Hmax", "H13", "wavelength", "p1", "p3", "pu", "alpha_star"]
    found = assess_table(GODA, {"wave.deep_water_height": heights}, columns=names)
    wave = standfast.assess(GODA).wave
    assert wave is not None and all(found[name][1] == getattr(wave, name) for name in names)
    assert found["Hmax"][0] < found["Hmax"][1] and "Hmax" not in assess_table(GODA, {"wave.deep_water_height": heights})
    said = varied(GODA, ["wave.deep_water_height"], columns=["p1", "Hmax", "alpha_star"]).results
    assert [one.unit for one in said.values()] == ["Pa", "m", None]
    with pytest.raises(ValueError, match="columns p1: there is no such result here"):
        assess_table(BLOCK, {"friction": [0.5]}, columns=["p1"])


@pytest.mark.parametrize("made", [lambda f: {"friction": f}, lambda f: pd.DataFrame({"friction": f}), lambda f: pl.DataFrame({"friction": f})])
def test_the_problem_of_a_row_may_be_asked_for_by_its_name(made: Any) -> None:
    block = {"body": {"width": 1, "height": 2, "mass": 4800, "friction": 0.7}, "load": [{"force": 20e3, "elevation": 1.5}]}
    with pytest.raises(standfast.StandfastError, match="columns has 'problem' alone; expected a result beside it, as 'mode'"):
        assess_table(block, made([0.5]), columns=["problem"], on_error="null")
    for columns in (["mode", "problem"], ["problem", "mode"]):
        found = assess_table(block, made([0.5, -0.5]), columns=columns, on_error="null")
        assert list(found)[-1] == "problem" if isinstance(found, dict) else list(found.columns)[-1] == "problem"
        assert sorted(found if isinstance(found, dict) else found.columns) == sorted(columns)
        assert (found["problem"][0] is None or pd.isna(found["problem"][0]) or found["problem"][0] == "") and "friction" in found["problem"][1]
        with pytest.raises(standfast.StandfastError, match="columns has 'problem', which says why a row has no results; expected on_error='null'"):
            assess_table(block, made([0.5]), columns=columns)
