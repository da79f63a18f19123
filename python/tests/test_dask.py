"""More than one machine: Dask arrays, xarray, and a cluster of separate worker processes."""

from __future__ import annotations

import os
import signal
import threading
import time
from collections.abc import Iterator
from typing import Any

import dask.array as da
import dask.dataframe as dd
import numpy as np
import pandas as pd
import pytest
import standfast
import xarray as xr
from distributed import Client, LocalCluster
from numpy.typing import NDArray

#: Rows in all, rows a chunk: a chunk of four columns is 16 MB, the data set 0.83 GB.
ROWS, CHUNK = 26_000_000, 500_000
LIMIT = 400_000_000


def block(offset: int, rows: int) -> NDArray[np.float64]:
    """Four columns of points that depend on their place only, as if read from a file."""
    random = np.random.default_rng(offset)
    return random.uniform([[0.3], [-1.5], [0.0], [0.0]], [[4.0], [1.5], [3.0], [2.0]], (4, rows))


def data_set() -> Any:
    def chunk(block_info: Any) -> NDArray[np.float64]:
        first, last = block_info[None]["array-location"][1]
        return block(first, last - first)

    whole = ((4,), (CHUNK,) * (ROWS // CHUNK))
    return da.map_blocks(chunk, chunks=whole, dtype=np.float64, meta=np.empty((0, 0)))


def modes(points: NDArray[np.float64]) -> NDArray[np.uint8]:
    if points.shape[1]:
        # Slow enough for a worker to be killed in the midst of its work.
        time.sleep(0.05)
    found: NDArray[np.uint8] = standfast.classify(*points)
    return found


@pytest.fixture(scope="module")
def client() -> Iterator[Client]:
    with (
        LocalCluster(
            n_workers=2, threads_per_worker=1, processes=True, memory_limit=LIMIT, dashboard_address=None
        ) as cluster,
        Client(cluster) as client,
    ):
        yield client


def test_a_data_set_larger_than_a_worker_survives_the_death_of_one(client: Client) -> None:
    points = data_set()
    assert points.nbytes > 2 * LIMIT
    workers = client.run(os.getpid)
    assert len(set(workers.values()) | {os.getpid()}) == 3

    codes = da.map_blocks(modes, points, drop_axis=0, dtype=np.uint8)
    killed: list[int] = []

    def kill() -> None:
        # Half-way, as seen by the counts of finished tasks.
        deadline = time.monotonic() + 120
        while time.monotonic() < deadline:
            done = sum(sum(1 for _ in who) > 0 for who in client.who_has().values())
            if done >= 10:
                pid = workers[sorted(workers)[0]]
                os.kill(pid, signal.SIGKILL)
                killed.append(pid)
                return
            time.sleep(0.02)

    futures = codes.persist()
    killer = threading.Thread(target=kill)
    killer.start()
    found = futures.compute()
    killer.join()
    assert killed and killed[0] not in client.run(os.getpid).values()

    assert found.shape == (ROWS,) and found.dtype == np.uint8
    for first in range(0, ROWS, CHUNK):
        alone = standfast.classify(*block(first, CHUNK))
        assert np.array_equal(found[first : first + CHUNK], alone), first


def test_arrays_broadcast_on_the_cluster(client: Client) -> None:
    k = da.linspace(0, 3, 3000, chunks=700)
    mu = da.linspace(0, 2, 200, chunks=90)[:, None]
    codes = da.map_blocks(standfast.classify, 3.0, 0.8, k, mu, dtype=np.uint8)
    assert codes.shape == (200, 3000)
    alone = standfast.classify(3.0, 0.8, k.compute(), mu.compute())
    assert np.array_equal(codes.compute(), alone)
    assert codes.compute().flags.c_contiguous


def test_data_frames_on_the_cluster(client: Client) -> None:
    columns = dict(zip(("gamma", "k_prime", "k", "friction"), block(0, 20_000)))
    whole = pd.DataFrame(columns, index=np.arange(20_000)[::-1])
    frame = dd.from_pandas(whole, npartitions=7, sort=False)
    modes = frame.map_partitions(standfast.classify, map={"mu": "friction"})
    alone = standfast.classify(whole, map={"mu": "friction"})
    assert modes.name == "mode" and modes.dtype == alone.dtype
    found = modes.compute()
    assert found.index.equals(whole.index) and found.tolist() == alone.tolist()
    motion = frame.map_partitions(standfast.onset, map={"mu": "friction"}, columns=["mode", "theta_ddot"])
    counts = motion[motion.theta_ddot != 0]["mode"].value_counts().compute()
    turning = ~alone.isin([standfast.Mode.REST, standfast.Mode.SLIDE_LEFT, standfast.Mode.SLIDE_RIGHT])
    assert counts.sum() == turning.sum()


def test_modes_travel(client: Client) -> None:
    assert client.submit(standfast.classify, 1, 0.4, 0.5, 0.6).result() is standfast.Mode.REST
    onset = client.submit(standfast.onset, 1, 1, 2, 5).result()
    assert onset == standfast.onset(1, 1, 2, 5)
    assert client.submit(standfast.assess, {"body": BODY, "load": [LOAD]}).result().mode is standfast.Mode.ROCK_O


BODY = {"width": 1.0, "height": 2.0, "mass": 4800.0, "friction": 0.7}
LOAD = {"force": 20_000.0, "elevation": 1.5}


def test_xarray_lazily_on_the_cluster(client: Client) -> None:
    friction = xr.DataArray(da.linspace(0.2, 1.2, 500, chunks=100), dims="friction")
    force = xr.DataArray(np.linspace(0, 2, 300), dims="force", coords={"force": np.linspace(0, 2, 300)})
    codes = xr.apply_ufunc(
        standfast.classify, 2.0, 0.3, force, friction, dask="parallelized", output_dtypes=[np.uint8]
    )
    assert set(codes.dims) == {"force", "friction"} and codes.chunks is not None
    alone = standfast.classify(2.0, 0.3, force.values[:, None], friction.values)
    assert np.array_equal(codes.transpose("force", "friction").values, alone)
