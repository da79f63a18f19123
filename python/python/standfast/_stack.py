"""Stacks of bodies in pure numbers: which joint moves first, and what begins."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from . import _standfast
from ._advice import shown
from ._answer import Rendered
from ._standfast import StandfastError
from ._types import Number
from .stacks import StackDocument

#: The numbers of a body in their order, and what is taken where they are not given; ``None`` of those that have to be.
_BODY: dict[str, object] = {"m_x": None, "m_y": "m_x", "I": None, "x": 0.0, "y": None}
_BODY |= dict.fromkeys(("X", "P", "M", "dX", "dP", "dM"), 0.0)
#: Those of a joint.
_JOINT: dict[str, object] = {"h": None, "l": None, "r": None, "mu_s": None, "mu_k": "mu_s"}


class Stack(StackDocument, Rendered):
    """Which joint of a stack moves first, and what begins: :func:`stack`'s answer.

    ``print`` shows it in words; the keys of its JSON document, which ``docs/stack.schema.json`` describes, are attributes.
    """

    _what = "this answer"


def stack(
    bodies: Sequence[Mapping[str, Number]],
    joints: Sequence[Mapping[str, Number]],
    *,
    gravity: Number = 0,
    horizontal: Number = 0,
    vertical: Number = 0,
    permanent: bool = False,
) -> Stack:
    """Which joint of bodies on bodies moves first as loads rise, and into which modes; and what begins under the full load at once?

    Args:
        bodies: from the ground up, each with its inertias ``m_x``, ``m_y`` (``m_x`` if not given) and ``I`` about its centre, the centre ``x``
            (0) and ``y``, and the wrench there: ``X`` to the right, ``P`` downwards with the weight, ``M`` counter-clockwise; and their variable
            parts ``dX``, ``dP``, ``dM``. Loads that are not given are 0. Any units that go together will do.
        joints: the joint below each body: its height ``h``, its ends ``l`` and ``r``, the friction ``mu_s`` to stick and ``mu_k`` to slip
            (``mu_s`` if not given).
        gravity: adds ``m_y gravity (1 + vertical)`` to ``P`` of each body. With added mass in ``m_y`` give ``P`` instead.
        horizontal: acceleration of the ground to the right, in g: adds ``-m_x gravity horizontal`` to ``dX``. Both are kept as products: equal
            friction then ties all joints, which rounded numbers would tell apart.
        vertical: acceleration of the ground upwards, in g; it is there all the time, and the load factor does not multiply it.
        permanent: whether the horizontal acceleration is there all the time: it adds to ``X``.

    Returns:
        :class:`Stack`: ``departure`` (``"never"``, ``"at-once"``, ``"at"``), ``load_factor``, ``departure_joints`` (joint 1 stands on the
        ground), ``departure_modes``; under the full load ``modes``, ``also_modes``, ``unique``, and the motion of ``joints`` and ``bodies``.
        Of more than six bodies the modes are ``None``, and ``no_modes`` says so. Right, up and counter-clockwise are positive; on a shaken base
        accelerations are relative to it.

    Raises:
        StandfastError: for what is no stack.
        TypeError: for what is not a number.

    Two cubes of side 2 on a base that starts with 0.8 g; the friction is 0.7 below and 0.3 between them:

    >>> cube = {"m_x": 1, "I": 2 / 3}
    >>> between = {"l": -1, "r": 1}
    >>> answer = stack(
    ...     [cube | {"y": 1}, cube | {"y": 3}],
    ...     [between | {"h": 0, "mu_s": 0.7}, between | {"h": 2, "mu_s": 0.3}],
    ...     gravity=1, horizontal=0.8,
    ... )
    >>> round(answer.load_factor, 9), answer.departure_joints
    (0.375, [2])
    >>> [mode.symbol for mode in answer.modes], answer.unique
    (['RE', 'SL'], True)
    """
    for name, given in (("bodies", bodies), ("joints", joints)):
        if isinstance(given, (Mapping, str)) or not isinstance(given, Iterable):
            raise TypeError(f"{name} is {shown(given)}; expected a list of dicts, from the ground up")
    if not isinstance(permanent, (bool, np.bool_)):
        raise TypeError(f"permanent is {shown(permanent)}; expected True or False")
    found = [_numbers("body", place, body, _BODY) for place, body in enumerate(bodies, 1)]
    between = [_numbers("joint", place, joint, _JOINT) for place, joint in enumerate(joints, 1)]
    shaking = [_number(name, value) for name, value in (("gravity", gravity), ("horizontal", horizontal), ("vertical", vertical))]
    return Stack(*_standfast.stack(found, between, (shaking, bool(permanent))))


def _numbers(what: str, place: int, given: Mapping[str, Number], names: Mapping[str, object]) -> list[float]:
    """The numbers of a body or a joint in their order."""
    if not isinstance(given, Mapping):
        raise TypeError(f"{what} {place} is {shown(given)}; expected a dict with {', '.join(names)}")
    for name in given:
        if name not in names:
            near = _standfast.closest(str(name), list(names))
            meant = f"did you mean {near!r}? Its numbers are" if near is not None else "its numbers are"
            raise StandfastError(f"{what} {place} has no {name!r}; {meant} {', '.join(names)}")
    found: dict[str, float] = {}
    for name, otherwise in names.items():
        if name in given:
            found[name] = _number(f"{name} of {what} {place}", given[name])
        elif isinstance(otherwise, str):
            found[name] = found[otherwise]
        elif isinstance(otherwise, float):
            found[name] = otherwise
        else:
            raise StandfastError(f"{what} {place} has no {name}; expected {', '.join(key for key in names if names[key] is None)} at least")
    return list(found.values())


def _number(name: str, value: object) -> float:
    if isinstance(value, (str, bytes, bool)) or not hasattr(value, "__float__"):
        raise TypeError(f"{name} is {shown(value)}; expected a number")
    try:
        return float(value)
    except (TypeError, ValueError, OverflowError):
        raise TypeError(f"{name} is {shown(value)}; expected a number") from None
