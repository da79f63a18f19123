"""Figures as files: SVG, PNG and PDF, of every answer that has figures, and from a pickle."""

from __future__ import annotations

import pickle
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import standfast
from matplotlib import image
from standfast import Figure, StandfastError

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def section() -> Figure:
    return standfast.assess(EXAMPLES / "goda-2000.toml").figures[0]


def test_a_figure_is_its_title_and_its_svg(section: Figure) -> None:
    title, svg = section
    assert (title, svg) == (section.title, section.svg) and section._repr_svg_() == svg
    again = pickle.loads(pickle.dumps(section))
    assert type(again) is Figure and again == section


@pytest.mark.parametrize("scale", [1, 2, np.float64(1.5)])
def test_a_png_has_the_size_that_is_asked_for_and_ink_on_it(section: Figure, tmp_path: Path, scale: Any) -> None:
    path = tmp_path / "section.PNG"
    section.save(path, scale=scale)
    pixels = image.imread(path, format="png")
    wide, high = section.svg.split('width="', 1)[1].split('"', 1)[0], section.svg.split('height="', 1)[1].split('"', 1)[0]
    assert pixels.shape[:2] == (int(np.ceil(float(high) * scale)), int(np.ceil(float(wide) * scale)))
    dark = (pixels[..., :3].sum(axis=-1) < 1) & (pixels[..., 3] > 0.5)
    assert 0.001 < dark.mean() < 0.5


def test_a_pdf_is_the_same_from_a_pickle(section: Figure, tmp_path: Path) -> None:
    for name, figure in {"made.pdf": section, "loaded.pdf": pickle.loads(pickle.dumps(section))}.items():
        figure.save(tmp_path / name)
    made, loaded = [(tmp_path / name).read_bytes() for name in ("made.pdf", "loaded.pdf")]
    assert made == loaded and b"/Title" in made and b"/ToUnicode" in made


@pytest.mark.skipif(shutil.which("pdftotext") is None, reason="no pdftotext")
def test_a_pdf_can_be_searched(section: Figure, tmp_path: Path) -> None:
    path = tmp_path / "made.pdf"
    section.save(path)
    words = subprocess.run(["pdftotext", path, "-"], capture_output=True, encoding="utf-8", check=True).stdout
    assert "μ" in words and len(words.split()) > 10


def test_every_answer_has_figures_that_are_written(tmp_path: Path) -> None:
    plane = {"point": {"gamma": 0.8, "k_prime": 0.9, "k": 0.5}, "random": {"mu": {"uniform": {"from": 0.4, "to": 0.6}}}}
    chances = standfast.probability(plane)
    motion = standfast.simulate(EXAMPLES / "motion/caisson-breaking-wave.toml", strength=False)
    for place, figure in enumerate([*chances.figures, *pickle.loads(pickle.dumps(chances)).figures, *motion.figures]):
        for kind, start in ((".svg", b"<svg"), (".png", b"\x89PNG"), (".pdf", b"%PDF")):
            path = tmp_path / f"{place}{kind}"
            figure.save(str(path))
            assert path.read_bytes().startswith(start), figure.title


def test_what_cannot_be_written_is_said(section: Figure, tmp_path: Path) -> None:
    for name in ("figure.bmp", "figure"):
        with pytest.raises(StandfastError, match="expected a name that ends in .svg, .png or .pdf"):
            section.save(tmp_path / name)
    for scale in (0, -1, 1e9, float("nan")):
        with pytest.raises(StandfastError, match="expected a number above zero that keeps the picture below 20 000 pixels a side"):
            section.save(tmp_path / "figure.png", scale=scale)
    with pytest.raises(TypeError, match="scale is 'large'; expected a number of pixels"):
        section.save(tmp_path / "figure.png", scale="large")  # type: ignore[arg-type]
    assert not list(tmp_path.iterdir())
