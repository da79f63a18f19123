"""What the wheel promises with numpy alone; run by the gate under the oldest and the newest Python it finds, too."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import standfast

ROOT = Path(__file__).parents[2]


def test_points_and_arrays() -> None:
    assert standfast.classify(gamma=0.8, k_prime=0.9167, k=0.7281, mu=0.6) is standfast.Mode.SLIDE_ROCK_O_LEFT
    k = np.array([0.1, 0.5, 3])
    codes = standfast.classify(3, 0.8, k, [[0.3], [0.05]])
    assert codes.dtype == np.uint8 and codes.tolist() == [[0, 2, 2], [1, 3, 4]]
    assert standfast.symbols(codes[1]).tolist() == ["SL", "SRO-", "SRO+"]
    onset = standfast.onset(3, 0.8, k, 0.05)
    # Sliding, only friction and the force act: ẍ = -k + μ for a body that does not turn.
    assert onset.x_ddot[0] == pytest.approx(-0.1 + 0.05)
    with pytest.raises(ValueError, match="friction μ is -0.5 at index 1"):
        standfast.classify(1, 0.4, [0.5, 0.7], [0.6, -0.5])


def test_a_case() -> None:
    goda = standfast.assess(ROOT / "examples" / "goda-2000.toml")
    assert goda.mode is standfast.Mode.REST and "Goda" in str(goda)
    assert goda.to_dict()["schema"] == 1


def test_a_diagram_is_drawn_without_matplotlib_as_svg_only() -> None:
    diagram = standfast.Diagram(3, 0.8)
    assert diagram.svg({"storm": (0.6, 0.15)}).startswith("<svg")
    if "matplotlib" not in sys.modules:
        try:
            import matplotlib  # noqa: F401
        except ImportError:
            with pytest.raises(ImportError, match=r'pip install "standfast\[plot\]"'):
                diagram.plot()


def test_nothing_but_numpy_is_imported() -> None:
    script = "import sys, standfast; print(*{name.split('.')[0] for name in sys.modules})"
    found = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True).stdout.split()
    assert "numpy" in found
    assert not {"dask", "duckdb", "matplotlib", "pandas", "pint", "polars", "pyarrow", "tqdm", "xarray"} & {*found}
