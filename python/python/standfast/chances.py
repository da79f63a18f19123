"""The parts of an answer in probabilities: classes with a property for each key of the JSON document that
``docs/probability.schema.json`` describes. ``None`` says that there is no such thing.
"""

from ._answer import make_classes
from .answers import Summary as Summary

__all__ = make_classes("chances", globals())
