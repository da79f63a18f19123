"""What a type checker says of calls: checked by mypy, never run."""

from typing import Any, Literal, assert_type

import duckdb
import numpy as np
import polars as pl
import standfast
from numpy.typing import NDArray
from standfast import (
    ArrowArray,
    ArrowTable,
    Assessment,
    Criterion,
    Diagram,
    Figure,
    Mode,
    ModeArray,
    ModeNames,
    Modes,
    Onset,
    OnsetArrays,
    Situation,
)

assert_type(standfast.classify(1, 0.4, 0.5, 0.6), Mode)
assert_type(standfast.classify(1, 0.4, 0.5, 0.6, names=True), str)
assert_type(standfast.classify(1, 0.4, np.ones(3), [0.6]), ModeArray)
assert_type(standfast.classify(1, 0.4, np.ones(3), 0.6, names=True), ModeNames)
assert_type(standfast.classify(1, np.float32(0.4), np.int64(1), 0.6), Mode)
assert_type(standfast.classify([[1, 2], [3, 4]], 0.4, 1, 0.6, threads=None, progress=True), ModeArray)
assert_type(standfast.classify(1, 0.4, 0.5, -0.6, on_error="null"), Mode | None)
assert_type(
    standfast.classify(1, 0.4, [0.5], -0.6, on_error="null"), np.ma.MaskedArray[tuple[Any, ...], np.dtype[np.uint8]]
)

storms = pl.DataFrame({"k": [0.5], "friction": [0.6]})
assert_type(standfast.classify(storms, map={"mu": "friction", "gamma": 0.8, "k_prime": 1}), pl.Series)
assert_type(standfast.classify(storms, map={"mu": "friction"}, names=True), pl.Series)
assert_type(standfast.classify(1, [0.4], storms["k"], np.ones(1)), pl.Series)
assert_type(standfast.classify(duckdb.table("storms")), ArrowArray)
modes = standfast.classify(duckdb.table("storms"))
assert_type(modes == Mode.REST, NDArray[np.bool_])

assert_type(standfast.onset(1, 0.4, 0.5, 0.6), Onset)
assert_type(standfast.onset(1, 0.4, 0.5, 0.6).mode, Mode)
assert_type(standfast.onset(1, 0.4, 0.5, 0.6).others, Modes)
assert_type(standfast.onset(1, 0.4, 0.5, 0.6).theta_ddot, float)
assert_type(standfast.onset(1, 0.4, 0.5, 0.6, on_error="null"), Onset | None)
assert_type(standfast.onset(1, 0.4, [0.5], 0.6), OnsetArrays)
assert_type(standfast.onset(1, 0.4, [0.5], 0.6).mode, ModeArray)
assert_type(standfast.onset(1, 0.4, [0.5], 0.6, columns=["unique", "xi"]).xi, NDArray[np.float64])
unique, xi = standfast.onset(1, 0.4, [0.5], 0.6, columns=["unique", "xi"])
assert_type(xi, NDArray[Any])
assert_type(standfast.onset(storms), pl.DataFrame)
assert_type(standfast.onset(1, 0.4, storms["k"], 0.6), pl.DataFrame)
assert_type(standfast.onset(duckdb.table("storms"), columns=["mode"]), ArrowTable)

assert_type(standfast.symbols(Mode.REST), str)
assert_type(standfast.symbols(np.zeros(3, dtype=np.uint8)), ModeNames)
assert_type(standfast.symbols(storms["k"]), pl.Series)
assert_type(standfast.symbols(modes), ArrowArray)
assert_type(Mode("SL"), Mode)
assert_type(Modes(np.uint16(12)).modes, tuple[Mode, ...])
assert_type(Mode.REST in Modes("RE SL"), bool)

assert_type(standfast.assess({"body": {}}), Assessment)
assert_type(standfast.assess("case.toml", up_to=3, all=True).figures, list[Figure])
assert_type(standfast.assess("case.toml").situations, list[Situation])
assert_type(standfast.assess("case.toml").governing, Situation)
assert_type(standfast.assess("case.toml").to_json(), str)
assert_type(standfast.assess("case.toml").SF_sliding, float | None)
assert_type(standfast.assess("case.toml").mode, Mode | None)
assert_type(standfast.assess("case.toml").situations[0].also, Modes)
assert_type(standfast.assess("case.toml").situations[0].departure, Literal["never", "at-once", "at"])
assert_type(standfast.assess("case.toml").criteria, list[Criterion])
assert_type(standfast.assess("case.toml").governing.combination, standfast.answers.Combination | None)
standfast.assess("case.toml").SF_slidin  # type: ignore[attr-defined]
table = standfast.assess_table("case.toml", pl.DataFrame(), columns=["mode"], map={"friction": "mu"}, progress=True)
assert_type(table, pl.DataFrame)
assert_type(standfast.assess_table("case.toml", duckdb.table("friction")), ArrowTable)
assert_type(standfast.assess_table({"body": {}}, {"friction": [0.5]}), dict[str, NDArray[Any]])
assert_type(standfast.varied("case.toml", ["friction"]).keys, dict[str, str])
assert_type(standfast.probability("case.toml", over={"width": [12, 14]}, progress=True), standfast.Probability)
assert_type(standfast.spectrum("case.toml", size=pl.Series([1.0, 2.0]), ratio="0.1..0.5", progress=print), standfast.Spectrum)
assert_type(standfast.design("case.toml", vary="width", target="rest", progress=lambda done, total: done), standfast.Design)
assert_type(standfast.simulate("case.toml", progress=False), standfast.Simulation)
assert_type(Diagram(1, 0.4).regions[0].mode, Mode)
assert_type(Diagram(1, 0.4).mode_at(0.5, 0.6), Mode)
assert_type(Diagram(1, 0.4).mode_at([0.5], 0.6), ModeArray)
assert_type(Diagram(1, 0.4).mode_at(pl.Series([0.5]), 0.6), pl.Series)
Diagram(1, 0.4).svg({"storm": 0.5})  # type: ignore[dict-item]
Diagram(1, 0.4).svg(pl.DataFrame({"k": [0.5], "mu": [0.6]}))
assert_type(standfast.contact(1, 1, 1, 2 / 3, 1, 1, -0.5, 1, 0.2, 0.6, 0.6).x_ddot, float | None)
assert_type(standfast.contact(1, 1, 1, 2 / 3, 1, 1, -0.5, 1, 0.2, 0.6, 0.6)[0], Mode | Modes | float | None)

assert_type(standfast.limit_states(1, 0.4, 0.5, 0.6), standfast.LimitStates)
assert_type(standfast.limit_states(1, 0.4, 0.5, 0.6).load_factor, float)
assert_type(standfast.limit_states(1, 0.4, [0.5], 0.6, to="right", threads=2).slide, NDArray[np.float64])
assert_type(standfast.limit_states(storms, map={"mu": "friction"}, columns=["slide"]), pl.DataFrame)
assert_type(standfast.limit_states(1, 0.4, 0.5, -1, on_error="null"), standfast.LimitStates | None)
assert_type(standfast.contact(1, 1, 1, 0.7, 1, 1, -0.5, 1, 0.2, 0.6, 0.6), standfast.Contact)
assert_type(standfast.contact(1, 1, 1, 0.7, 1, 1, -0.5, 1, 0.2, 0.6, 0.6).mode, Mode | None)
assert_type(standfast.contact(1, 1, 1, 0.7, 1, 1, np.ones(3), 1, 0.2, 0.6, 0.6).modes, NDArray[np.uint16])
assert_type(standfast.contact(storms, map={"mu_k": 0.5}), pl.DataFrame)
assert_type(standfast.classify(1, 0.4, 0.5, 0.6, to="right"), Mode)
assert_type(standfast.explain(1, 0.4, 0.5, 0.6).trace[0].relations[0].margin, float)
assert_type(standfast.design("case.toml", vary="width", target="rest", upper="9 m"), standfast.Design)
assert_type(standfast.design("case.toml", vary="width", target="rest").met[0].from_.binds, str | None)
assert_type(standfast.design("case.toml", vary="width", target="rest", and_="friction"), standfast.Boundary)
assert_type(standfast.sheet("case.toml", "sheet.html", author="N. N."), str)
assert_type(standfast.simulate("case.toml", base=np.ones(3), dt=0.01, unit="g").slide, float)
assert_type(standfast.simulate("case.toml", base={"vertical": [0.0, 1.0]}, dt=[0.0, 0.1]).events[0].state, Mode)
assert_type(standfast.simulate("case.toml").series(0.01), ArrowTable)
assert_type(standfast.probability("case.toml", method="sobol").modes["SL"].probability, float)
assert_type(standfast.probability("case.toml").life, standfast.chances.Life | None)
assert_type(standfast.probability("case.toml").figures, list[Figure])
assert_type(standfast.draws("case.toml", 10, seed=3).mode, standfast.ArrowArray)
standfast.probability("case.toml", method="simpson")  # type: ignore[arg-type]
assert_type(standfast.spectrum("case.toml", "newmark", ratio="0.1..0.9").points, ArrowTable)
assert_type(standfast.simulate("case.toml").figures, list[Figure])
standfast.spectrum("case.toml", "rock")  # type: ignore[arg-type]
assert_type(standfast.probability("case.toml").modes[Mode.SLIDE_LEFT].probability, float)
assert_type(standfast.assess_table("case.toml", {"friction": np.ones(3)}), dict[str, NDArray[Any]])
