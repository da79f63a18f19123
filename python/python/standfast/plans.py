"""The parts of the answer to `directions`: classes with a property for each key of the JSON document that ``docs/directions.schema.json``
describes.

Units are SI. ``None`` says that there is no such thing; a number without bound is ``math.inf``.
"""

from ._answer import make_classes
from .answers import Summary as Summary

__all__ = make_classes("plans", globals())
