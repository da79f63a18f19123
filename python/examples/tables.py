"""Columns of a table: pandas, polars, DuckDB. The answers are joined to the table without a copy of its columns."""

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

# pandas: columns are numpy arrays.
frame = pd.DataFrame(storms)
frame["mode"] = standfast.classify(0.8, frame.elevation, frame.force, frame.friction, names=True)
print(frame[["year", "mode"]].to_string(index=False))

# polars: the whole table at once, under the names of its columns; or column by column.
columns = {"gamma": 0.8, "k_prime": "elevation", "k": "force", "mu": "friction"}
storm_table = pl.DataFrame(storms)
onset = pl.DataFrame(standfast.onset(storm_table, map=columns))
moving = storm_table.hstack(onset.select("mode", "theta_ddot")).filter(pl.col("mode") != standfast.Mode.REST)
print(moving.select("year", "theta_ddot"))

# DuckDB: a query in, its answer in the next query. Record batches are read as they come.
modes = pa.table({"mode": pa.chunked_array(standfast.classify(duckdb.sql("from storm_table"), map=columns, names=True))})
print(duckdb.sql("select mode, count(*) as storms from modes group by mode order by storms desc, mode"))

assert frame["mode"].tolist() == modes["mode"].to_pylist()
assert standfast.symbols(onset["mode"].to_numpy()).tolist() == frame["mode"].tolist()
