"""The parts of a motion in time: classes with a property for each key of the JSON document that ``docs/simulate.schema.json``
describes, and of that of ``docs/spectrum.schema.json``.

Units are SI; those of a case with a ``[block]`` are its own. ``None`` says that there is no such thing.
"""

from ._answer import make_classes
from .answers import Summary as Summary

__all__ = make_classes("simulations", globals())
