"""Which bodies does which shaking overturn? Motions in time, bodies × records, on several processes or machines: Dask.

Each task is one `standfast.simulate`; bodies are dicts, records arrays, and only the few numbers of an answer come back. A cluster of
machines is started as Dask's documentation says; `Client("tcp://scheduler:8786")` then takes the place of `LocalCluster`.
"""

from typing import Any

import dask
import numpy as np
import standfast
from distributed import Client, LocalCluster
from numpy.typing import NDArray

STEP = 0.01


def record(seed: int) -> NDArray[np.float64]:
    """Noise under an envelope, in m/s², in place of an accelerogram: 8 s, its largest value 4 m/s²."""
    random = np.random.default_rng(seed)
    time = np.arange(0, 8, STEP)
    noise = np.convolve(random.normal(size=len(time)), np.hanning(15), "same") * np.minimum(time, 1) * np.exp(-time / 4)
    return 4 * noise / np.abs(noise).max()


def body(width: float) -> dict[str, Any]:
    return {"body": {"width": width, "height": "2 m", "density": "2.6 t/m3", "friction": 0.5}}


@dask.delayed  # type: ignore[untyped-decorator]
def motion(width: float, seed: int) -> tuple[float, int, bool, float, float]:
    found = standfast.simulate(body(width), base=record(seed), dt=STEP, unit="m/s2")
    return width, seed, found.overturned, abs(found.slide), found.max_theta


def main(widths: int = 6, records: int = 8) -> None:
    tasks = [motion(width, seed) for width in np.linspace(0.2, 1.2, widths) for seed in range(records)]
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster):
        rows = np.array(dask.compute(*tasks)).reshape(widths, records, 5)
    for of_width in rows:
        overturned, slide, theta = of_width[:, 2], of_width[:, 3], of_width[:, 4]
        still = int(np.sum((slide == 0) & (theta == 0)))
        print(f"{of_width[0, 0]:.1f} m wide: {overturned.sum():.0f} of {records} overturn, {still} stay at rest, slide up to {slide.max():.3f} m")


if __name__ == "__main__":
    main()
