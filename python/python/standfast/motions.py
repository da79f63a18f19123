"""The parts of a motion in time: classes with a property for each key of the JSON document that ``docs/simulate.schema.json``
describes, and of that of ``docs/spectrum.schema.json``.

Units are SI; those of a case with a ``[block]`` are its own. ``None`` says that there is no such thing.
"""

# Made by python/make_designs.py; changes go into the schemas.
# mypy: disable-error-code="no-any-return"

from __future__ import annotations

from typing import Literal

from ._answer import Answer, mode, modes, parts
from ._modes import Mode, Modes

__all__ = [
    "Moment",
    "MotionDocument",
    "Note",
    "Requirement",
    "SpectrumDocument",
]


class Requirement(Answer):
    """What is asked of a motion, and how far it is met."""

    @property
    def name(self) -> Literal["slide", "max_theta", "overturned"]:
        """That of the result; of the slide its size counts, to either side."""
        return self._document["name"]

    @property
    def required(self) -> float | Literal[False]:
        """At most this; false: the body may not overturn."""
        return self._document["required"]

    @property
    def value(self) -> float | bool | None:
        """The value; None where the body overturns, or is not followed to the end of its motion."""
        return self._document["value"]

    @property
    def utilisation(self) -> float | None:
        """Value/required: up to 1 where it is met; infinite where there is no value; None where nothing is measured."""
        return self._document["utilisation"]

    @property
    def met(self) -> bool:
        """Whether it is met."""
        return self._document["met"]


class Moment(Answer):
    """a moment at which the state of motion changes, or the motion ends."""

    @property
    def t(self) -> float:
        """When, s."""
        return self._document["t"]

    @property
    def why(
        self,
    ) -> Literal[
        "start", "load", "jump", "cone", "stop", "unload", "tip", "impact", "settle", "grip", "overturned", "rest",
        "end", "no-continuation"
    ]:
        """Why: the motion begins; a load moves the body, a load jumps, friction at a corner that stuck is exhausted, slip ends, a
        corner is no longer pressed, the reaction of a base that slides reaches a corner, a corner meets the base, ever faster
        impacts have ended the rotation, a corner that could not go on slipping grips, a quarter turn, rest for good, the time is
        up, no state satisfies all conditions."""
        return self._document["why"]

    @property
    def state(self) -> Mode:
        """The state that goes on."""
        return mode(self._document["state"])

    @property
    def also(self) -> Modes:
        """The other states that satisfied all conditions; where there are some, the answer is not unique."""
        return modes(self._document["also"])


class Note(Answer):
    """What may be a slip, or leaves the range of the model."""

    @property
    def name(self) -> str:
        """Its name."""
        return self._document["name"]

    @property
    def message(self) -> str:
        """What is so, with its number."""
        return self._document["message"]


class MotionDocument(Answer):
    """What ``simulate`` answers in one situation of a case."""

    @property
    def schema(self) -> Literal[1]:
        """The version of the document."""
        return self._document["schema"]

    @property
    def title(self) -> str | None:
        """As the case says."""
        return self._document["title"]

    @property
    def situation(self) -> str | None:
        """Which of the alternative loads or combinations acts; None where the case has no choice."""
        return self._document["situation"]

    @property
    def end(self) -> Literal["rest", "overturned", "time", "no-continuation", "too-many-events"]:
        """How the motion ends: at rest for good; with a quarter turn; because the time is up, as it still moves or may move
        again; where no state satisfies all conditions; after so many events that no end is in sight."""
        return self._document["end"]

    @property
    def slide(self) -> float:
        """Displacement along the base, to the right, of the corner that touches it at the end, or of O if none does, m; of a body
        that overturns, until then."""
        return self._document["slide"]

    @property
    def max_slide(self) -> float:
        """The largest displacement on the way to either side, of the corner that touches, in flight of O, m."""
        return self._document["max_slide"]

    @property
    def t_max_slide(self) -> float:
        """When, s."""
        return self._document["t_max_slide"]

    @property
    def max_theta(self) -> float:
        """The largest angle to either side, rad."""
        return self._document["max_theta"]

    @property
    def t_max_theta(self) -> float:
        """When, s."""
        return self._document["t_max_theta"]

    @property
    def max_theta_of_balance(self) -> float:
        """The largest angle as a share of that at which the centre of mass stands over the corner, of the nearer corner."""
        return self._document["max_theta_of_balance"]

    @property
    def theta(self) -> float:
        """The angle at the end, rad, counter-clockwise."""
        return self._document["theta"]

    @property
    def overturned(self) -> bool:
        """Whether it turns by a quarter."""
        return self._document["overturned"]

    @property
    def past_balance(self) -> bool:
        """Whether the centre of mass ever is beyond the corner about which the body turns, whatever becomes of it."""
        return self._document["past_balance"]

    @property
    def at_rest(self) -> bool:
        """Whether it rests at the end."""
        return self._document["at_rest"]

    @property
    def impacts(self) -> int:
        """How often a corner meets the base; of an infinite sequence of impacts those that are followed one by one."""
        return self._document["impacts"]

    @property
    def t_rest(self) -> float | None:
        """Since when it rests for good, s; None if it does not."""
        return self._document["t_rest"]

    @property
    def t_rest_is_bound(self) -> bool:
        """Whether ``t_rest`` is a lower bound: the last motion, too small to matter, is not followed."""
        return self._document["t_rest_is_bound"]

    @property
    def t_final(self) -> float:
        """When the last event is, or the loads end if that is later, s."""
        return self._document["t_final"]

    @property
    def work(self) -> float:
        """Work of the loads but for the weight, J/kg."""
        return self._document["work"]

    @property
    def friction_loss(self) -> float:
        """What friction takes, J/kg."""
        return self._document["friction_loss"]

    @property
    def impact_loss(self) -> float:
        """What impacts take, J/kg."""
        return self._document["impact_loss"]

    @property
    def kinetic(self) -> float:
        """What is gained as motion at the end, J/kg."""
        return self._document["kinetic"]

    @property
    def potential(self) -> float:
        """What is gained as height at the end, J/kg."""
        return self._document["potential"]

    @property
    def energy_residual(self) -> float:
        """What the balance of these lacks: gains and losses less work, J/kg; rounding."""
        return self._document["energy_residual"]

    @property
    def unique(self) -> bool:
        """Whether at every event one state only satisfies all conditions, and one impact."""
        return self._document["unique"]

    @property
    def sensitivity(self) -> float | None:
        """So many times a relative change of friction and height is that of slide, in B, and of the largest angle; None where it
        is not asked for."""
        return self._document["sensitivity"]

    @property
    def met(self) -> bool | None:
        """Whether all criteria of the motion are met; None where the case has none; of the worst situation, which comes first,
        and so of all."""
        return self._document["met"]

    @property
    def criteria(self) -> list[Requirement]:
        """What the case asks of the motion, the governing one first."""
        return parts(Requirement, self._document["criteria"])

    @property
    def events(self) -> list[Moment]:
        """What happens, in its order, from t = 0."""
        return parts(Moment, self._document["events"])

    @property
    def warnings(self) -> list[Note]:
        """What may be a slip, or leaves the range of the model."""
        return parts(Note, self._document["warnings"])

    @property
    def others(self) -> list[MotionDocument]:
        """The other situations of the case, of which this one is the worst: by what is used of the criteria, overturned, past
        balance, by the largest slide."""
        return parts(MotionDocument, self._document["others"])


class SpectrumDocument(Answer):
    """What ``spectrum`` answers."""

    @property
    def schema(self) -> Literal[1]:
        """The version of the document."""
        return self._document["schema"]

    @property
    def kind(self) -> Literal["rocking", "newmark", "overturning"]:
        """Uniform blocks over size and slenderness; a block that can only slide, over its yield acceleration; the body of the
        case over the strength of the shaking."""
        return self._document["kind"]

    @property
    def title(self) -> str | None:
        """As the case says."""
        return self._document["title"]

    @property
    def gravity(self) -> float:
        """The acceleration of gravity, m/s2."""
        return self._document["gravity"]

    @property
    def peak(self) -> float:
        """The largest acceleration of the base along it, m/s2."""
        return self._document["peak"]

    @property
    def stretches(self) -> list[list[float]] | None:
        """Of an overturning curve the stretches of factors at which the body overturns, from and to; narrower ones may lie
        between the factors that were tried; None of the other kinds."""
        return None if self._document["stretches"] is None else list(self._document["stretches"])

    @property
    def warnings(self) -> list[Note]:
        """What may be a slip, or leaves the range of the model."""
        return parts(Note, self._document["warnings"])
