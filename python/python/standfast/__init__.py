"""A freestanding body stands on a rough base; a force comes. Does it stay at rest, slide, rock, or slide and rock?

========================================================  ==================================
which mode begins, at one point or at ten million?        :func:`classify`
with what motion, and is it the only one?                 :func:`onset`
why, and when would it be another?                        :func:`explain`
how far is each inequality from failing?                  :func:`limit_states`
any body under any wrench: added mass, two frictions      :func:`contact`
bodies on bodies: which joint moves first, and all modes  :func:`stack`
what does the whole k-μ plane look like?                  :class:`Diagram`
a case to begin from: caisson, statue, rack, wall         :func:`new`
a body with its loads: water, waves, earthquakes          :func:`assess`
many of them: tables, sweeps, samples                     :func:`assess_table`
the least width, the greatest force that is enough        :func:`design`
which direction of the loads is the worst?                :func:`directions`
what becomes of it in time: slide, rock, overturn         :func:`simulate`, :func:`spectrum`
the same of many bodies under many records                :func:`motions`
how likely is each mode, if numbers are random            :func:`probability`, :func:`draws`
how likely is a limit state of my own below zero?         :func:`reliability`
which factor gives several cases a reliability index?     :func:`calibrate`
the calculation, to be filed and signed                   :func:`sheet`
========================================================  ==================================

The symbols are those of the report this library implements, on vertical caisson breakwaters: γ = H/B (``gamma``),
k = F/(m g) (``k``), k' the height of the force above the centre of mass in H (``k_prime``), μ Coulomb friction
(``mu``). Numbers in parentheses are the report's equations.
"""

from ._answer import Answer
from ._arrays import Onset, OnsetArrays, classify, onset, symbols
from ._arrow import ArrowArray, ArrowTable
from ._assess import Assessment, assess
from ._calibrate import Calibration, calibrate
from ._contact import Contact, ContactArrays, contact, contact_conditions
from ._design import Boundary, Design, Minimum, design
from ._diagram import Curve, Diagram, Indeterminate, NamedPoint, Region
from ._directions import Directions, directions
from ._explain import Explanation, explain
from ._figure import Figure
from ._limits import LimitStates, LimitStatesArrays, limit_states
from ._mode_arrays import ModeArray, ModeNames
from ._modes import Mode, Modes
from ._motions import motions
from ._new import examples, new
from ._probability import Probability, draws, probability
from ._reliability import DesignPoint, Reliability, reliability
from ._sheet import sheet
from ._simulate import Simulation, simulate
from ._spectrum import Spectrum, spectrum
from ._stack import Stack, stack
from ._standfast import CaseError, NoSolution, StandfastError, __version__
from ._table import ResultColumn, Varied, assess_table, varied
from ._warnings import StandfastWarning
from .answers import Criterion, Situation

__all__ = [
    "Answer",
    "ArrowArray",
    "ArrowTable",
    "Assessment",
    "Boundary",
    "Calibration",
    "CaseError",
    "Contact",
    "ContactArrays",
    "Criterion",
    "Curve",
    "Design",
    "DesignPoint",
    "Diagram",
    "Directions",
    "Explanation",
    "Figure",
    "Indeterminate",
    "LimitStates",
    "LimitStatesArrays",
    "Minimum",
    "Mode",
    "ModeArray",
    "ModeNames",
    "Modes",
    "NamedPoint",
    "NoSolution",
    "Onset",
    "OnsetArrays",
    "Probability",
    "Region",
    "Reliability",
    "ResultColumn",
    "Simulation",
    "Situation",
    "Spectrum",
    "Stack",
    "StandfastError",
    "StandfastWarning",
    "Varied",
    "__version__",
    "assess",
    "assess_table",
    "calibrate",
    "classify",
    "contact",
    "contact_conditions",
    "design",
    "directions",
    "draws",
    "examples",
    "explain",
    "limit_states",
    "motions",
    "new",
    "onset",
    "probability",
    "reliability",
    "sheet",
    "simulate",
    "spectrum",
    "stack",
    "symbols",
    "varied",
]
