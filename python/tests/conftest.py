"""Settings of the tests."""

import os
from pathlib import Path

import matplotlib
import pytest

matplotlib.use("Agg")

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="session")
def program() -> list[str]:
    """The command that starts the program: that of the environment variable STANDFAST, or built from this checkout."""
    if "STANDFAST" in os.environ:
        return [os.environ["STANDFAST"]]
    return ["cargo", "run", "--quiet", "--manifest-path", str(ROOT / "Cargo.toml"), "--package", "standfast-cli", "--"]
