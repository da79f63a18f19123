"""Tables of pandas, polars and DuckDB, whole: the answers are columns beside theirs, without a copy of these."""

import duckdb
import numpy as np
import pandas as pd
import polars as pl
import pyarrow as pa
import standfast

storms = {
    "year": np.arange(2001, 2011),
    "force": [0.41, 0.55, 0.72, 0.38, 0.81, 0.66, 0.59, 0.47, 1.10, 0.63],
    "elevation": [0.90, 0.85, 0.92, 0.70, 0.95, 0.88, 0.60, 0.75, 0.97, 0.80],
    "friction": [0.60, 0.62, 0.60, 0.58, 0.65, 0.70, 0.55, 0.60, 0.62, 0.61],
}

mapping = {"gamma": 0.8, "k_prime": "elevation", "k": "force", "mu": "friction"}

# pandas: a Series with the index of the table, or a DataFrame of the motion.
frame = pd.DataFrame(storms).set_index("year")
frame["mode"] = standfast.classify(frame, map=mapping, names=True)
print(frame[["force", "mode"]])
print(frame.groupby("mode", observed=True).force.agg(["count", "max"]))

# polars: the same, with the answer as columns of the frame.
storm_table = pl.DataFrame(storms)
onset = standfast.onset(storm_table, map=mapping, columns=["mode", "theta_ddot"])
moving = storm_table.hstack(onset).filter(pl.col("mode") != standfast.Mode.REST)
print(moving.select("year", "theta_ddot"))

# DuckDB: a query in, its answer in the next query. Record batches are read as they come.
modes = pa.table({"mode": pa.array(standfast.classify(duckdb.sql("from storm_table"), map=mapping, names=True))})
print(duckdb.sql("select mode, count(*) as storms from modes group by mode order by storms desc, mode"))

assert frame["mode"].tolist() == modes["mode"].to_pylist() == standfast.symbols(onset["mode"]).to_list()
