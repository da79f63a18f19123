"""The parts of a design: classes with a property for each key of the JSON documents that ``docs/design.schema.json``,
``docs/boundary.schema.json`` and ``docs/minimum.schema.json`` describe.

Units are SI; forces and masses are per metre run or, of a single object, of the whole. ``None`` says that there is no such thing;
a number without bound is ``math.inf``.
"""

from ._answer import make_classes
from .answers import Summary as Summary

__all__ = make_classes("designs", globals())
