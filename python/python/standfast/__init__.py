"""A freestanding body stands on a rough base; a force comes. Does it stay at rest, slide, rock, or slide and rock?

========================================================  ==================================
which mode begins, at one point or at ten million?        :func:`classify`
with what motion, and is it the only one?                 :func:`onset`
what does the whole k-μ plane look like?                  :class:`Diagram`
a body with its loads: water, waves, earthquakes          :func:`assess`
many of them: tables, sweeps, samples                     :func:`assess_table`
========================================================  ==================================

The symbols are those of the report this library implements, on vertical caisson breakwaters: γ = H/B (``gamma``),
k = F/(m g) (``k``), k' the height of the force above the centre of mass in H (``k_prime``), μ Coulomb friction
(``mu``). Numbers in parentheses are the report's equations.
"""

from ._answer import Answer
from ._arrays import Onset, OnsetArrays, classify, onset, symbols
from ._arrow import ArrowArray, ArrowTable
from ._assess import Assessment, Figure, assess
from ._diagram import Curve, Diagram, Indeterminate, NamedPoint, Region
from ._modes import Mode, Modes
from ._standfast import __version__
from ._table import ResultColumn, StandfastWarning, Varied, assess_table, varied
from .answers import Criterion, Situation

__all__ = [
    "Answer",
    "ArrowArray",
    "ArrowTable",
    "Assessment",
    "Criterion",
    "Curve",
    "Diagram",
    "Figure",
    "Indeterminate",
    "Mode",
    "Modes",
    "NamedPoint",
    "Onset",
    "OnsetArrays",
    "Region",
    "ResultColumn",
    "Situation",
    "StandfastWarning",
    "Varied",
    "__version__",
    "assess",
    "assess_table",
    "classify",
    "onset",
    "symbols",
    "varied",
]
