"""The parts of an answer: classes with a property for each key of the JSON document that ``docs/answer.schema.json`` describes.

Units are SI; forces, masses and moments are per metre run or, of an object of a given length or a cylinder, of the whole: see
:attr:`Document.extent`. ``None`` says that there is no such thing; a number without bound is ``math.inf``.
"""

from ._answer import make_classes, make_only_situation

__all__ = make_classes("answers", globals())
OnlySituation = make_only_situation()
