"""The parts of the answer to a stack: classes with a property for each key of the JSON document that ``docs/stack.schema.json`` describes.

Units are those of the stack's numbers. ``None`` says that there is no such thing; a number without bound is ``math.inf``.
"""

from ._answer import make_classes
from .answers import BodyMotion as BodyMotion
from .answers import JointMotion as JointMotion

__all__ = make_classes("stacks", globals())
