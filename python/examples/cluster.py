"""More points than fit into memory, on several processes or machines: Dask.

The points are made where they are needed, chunk by chunk, as they would be read from files. A cluster of machines is
started as Dask's documentation says; `Client("tcp://scheduler:8786")` then takes the place of `LocalCluster`.
"""

import dask.array as da
import numpy as np
import standfast
from distributed import Client, LocalCluster


def main(points: int = 20_000_000) -> None:
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster):
        random = da.random.default_rng(2025)
        k = random.gumbel(0.55, 0.08, points, chunks=1_000_000).clip(0)
        k_prime = random.normal(0.9, 0.05, points, chunks=1_000_000)
        mu = random.normal(0.6, 0.06, points, chunks=1_000_000).clip(0)

        codes = da.map_blocks(standfast.classify, 0.8, k_prime, k, mu, dtype=np.uint8)
        counts = da.bincount(codes, minlength=len(standfast.Mode)).compute()

    for mode, count in zip(standfast.Mode, counts):
        if count:
            print(f"{mode.symbol:5} {count / points:7.2%}")


if __name__ == "__main__":
    main()
