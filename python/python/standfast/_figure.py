"""Figures of answers, which a notebook shows and which are written as SVG, PNG and PDF."""

from __future__ import annotations

import os
from typing import Any, NamedTuple

import numpy as np

from . import _standfast
from ._standfast import StandfastError

_KINDS = (".svg", ".png", ".pdf")


class _Shown(NamedTuple):
    #: What it shows.
    title: str
    #: The SVG document.
    svg: str


class Figure(_Shown):
    """A figure of a case: its ``title`` and its ``svg``, the SVG document. A notebook shows it."""

    #: What a PDF has beside the drawing: the title in it, its size, and its labels with their boxes.
    _kept: _standfast._Kept

    def __new__(cls, title: str, svg: str, kept: _standfast._Kept) -> Figure:
        self = super().__new__(cls, title, svg)
        self._kept = kept
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        return Figure, (self.title, self.svg, self._kept)

    def __repr__(self) -> str:
        return f"<Figure {self.title!r}: {len(self.svg) / 1e3:.0f} kB of SVG>"

    def _repr_svg_(self) -> str:
        return self.svg

    def save(self, path: str | os.PathLike[str], *, scale: float = 2.0) -> None:
        """Writes the figure to a file: SVG, PNG or PDF, by the end of its name. A PDF can be searched; it has the size of the SVG.

        Args:
            path: a name that ends in ``.svg``, ``.png`` or ``.pdf``. A file that is there is replaced.
            scale: of a PNG, how many pixels a unit of the SVG has; 1 gives 96 dots per inch, 2 suits a screen, 4 print.

        Raises:
            StandfastError: for another end of the name, and a scale that makes no sense.
            OSError: if the file cannot be written.
        """
        name = os.fspath(path)
        kind = os.path.splitext(name)[1].lower()
        if kind not in _KINDS:
            raise StandfastError(f"path is {name!r}; expected a name that ends in {', '.join(_KINDS[:-1])} or {_KINDS[-1]}")
        if isinstance(scale, (bool, np.bool_)) or not isinstance(scale, (int, float, np.integer, np.floating)):
            raise TypeError(f"scale is {scale!r}; expected a number of pixels for a unit of the SVG, as 2")
        if kind == ".svg":
            content = self.svg.encode("utf-8")
        else:
            content = _standfast.picture(self.svg, self._kept, float(scale) if kind == ".png" else None)
        with open(path, "wb") as file:
            file.write(content)


def figures_of(answer: Any) -> list[Figure]:
    """The figures of an answer of the native module."""
    return [Figure(words, svg, kept) for words, _, svg, kept in answer.figures()]
