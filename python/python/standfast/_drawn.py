"""Answers that are a table and figures beside their text: of a spectrum, and over directions."""

from __future__ import annotations

import functools

from . import _standfast
from ._answer import Rendered
from ._figure import Figure


class Drawn(Rendered):
    """An answer with a table and figures. A notebook shows the first figure."""

    _csv: str
    _drawn: list[tuple[str, str, str, _standfast._Kept]]

    def __init__(self, text: str, document: str, csv: str, drawn: list[tuple[str, str, str, _standfast._Kept]]) -> None:
        super().__init__(text, document)
        vars(self).update(_csv=csv, _drawn=drawn)

    @property
    def csv(self) -> str:
        """The table of the answer in CSV, as the program writes it with ``--csv``."""
        return self._csv

    @functools.cached_property
    def figures(self) -> list[Figure]:
        """The figures of the answer."""
        return [Figure(words, svg, kept) for words, _, svg, kept in self._drawn]

    @property
    def svg(self) -> str:
        """The first figure as an SVG document."""
        return self.figures[0].svg

    def _repr_svg_(self) -> str:
        return self.svg
