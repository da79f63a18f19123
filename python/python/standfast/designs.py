"""The parts of a design: classes with a property for each key of the JSON documents that ``docs/design.schema.json`` and
``docs/boundary.schema.json`` describe.

Units are SI; forces and masses are per metre run or, of a single object, of the whole. ``None`` says that there is no such thing;
a number without bound is ``math.inf``.
"""

# Made by python/make_designs.py; changes go into the schemas.
# mypy: disable-error-code="no-any-return"

from __future__ import annotations

from typing import Literal

from ._answer import Answer, mode, part, parts
from ._modes import Mode

__all__ = [
    "BoundaryDocument",
    "Column",
    "DesignDocument",
    "End",
    "Found",
    "Present",
    "Quantity",
    "Sensitivity",
    "Stretch",
]


class Present(Answer):
    """The present value and what it comes to: of each result, that of the situation in which it is worst."""

    @property
    def value(self) -> float:
        """The value, in ``unit``."""
        return self._document["value"]

    @property
    def SF_sliding(self) -> float | None:
        """Safety factor against sliding, μ(W' − U)/P."""
        return self._document["SF_sliding"]

    @property
    def SF_overturning(self) -> float | None:
        """Safety factor against overturning, the lesser of both corners."""
        return self._document["SF_overturning"]

    @property
    def bearing_max(self) -> float | None:
        """The larger of both, Pa."""
        return self._document["bearing_max"]

    @property
    def contact_share(self) -> float | None:
        """The share of the base's area that is pressed."""
        return self._document["contact_share"]

    @property
    def eccentricity(self) -> float | None:
        """Distance of the resultant from the middle of the base, where it meets the base, m."""
        return self._document["eccentricity"]

    @property
    def mode(self) -> Mode | None:
        """The mode under the full load, applied at once; BF where the ground fails."""
        return None if self._document["mode"] is None else mode(self._document["mode"])

    @property
    def departure(self) -> Literal["never", "at-once", "at"]:
        """Whether the body leaves rest as the variable loads rise: for no load factor above zero, at once, or at
        ``load_factor``."""
        return self._document["departure"]

    @property
    def load_factor(self) -> float | None:
        """Where it leaves rest, as a multiple of the variable loads; only where ``departure`` is ``at``."""
        return self._document["load_factor"]

    @property
    def departure_mode(self) -> Mode | None:
        """The mode in which it leaves rest; BF where the ground fails."""
        return None if self._document["departure_mode"] is None else mode(self._document["departure_mode"])

    @property
    def slide(self) -> float | None:
        """The displacement along the base at the end, to either side, m; None where the target does not ask for the motion, or
        the body overturns."""
        return self._document["slide"]

    @property
    def max_theta(self) -> float | None:
        """The largest angle to either side, rad; None as there."""
        return self._document["max_theta"]

    @property
    def overturned(self) -> bool | None:
        """Whether the body overturns; None where the target does not ask for the motion."""
        return self._document["overturned"]


class Found(Answer):
    """The value found and what the printed one comes to: of each result, that of the situation in which it is worst."""

    @property
    def value(self) -> float:
        """The value that is printed, in ``unit``: on the safe side of the boundary, and assessed so; the results beside it are
        its own."""
        return self._document["value"]

    @property
    def boundary(self) -> float:
        """The outermost value that meets the target, in ``unit``, to twelve digits."""
        return self._document["boundary"]

    @property
    def printed(self) -> str:
        """How it is printed, with its unit."""
        return self._document["printed"]

    @property
    def SF_sliding(self) -> float | None:
        """Safety factor against sliding, μ(W' − U)/P."""
        return self._document["SF_sliding"]

    @property
    def SF_overturning(self) -> float | None:
        """Safety factor against overturning, the lesser of both corners."""
        return self._document["SF_overturning"]

    @property
    def bearing_max(self) -> float | None:
        """The larger of both, Pa."""
        return self._document["bearing_max"]

    @property
    def contact_share(self) -> float | None:
        """The share of the base's area that is pressed."""
        return self._document["contact_share"]

    @property
    def eccentricity(self) -> float | None:
        """Distance of the resultant from the middle of the base, where it meets the base, m."""
        return self._document["eccentricity"]

    @property
    def mode(self) -> Mode | None:
        """The mode under the full load, applied at once; BF where the ground fails."""
        return None if self._document["mode"] is None else mode(self._document["mode"])

    @property
    def departure(self) -> Literal["never", "at-once", "at"]:
        """Whether the body leaves rest as the variable loads rise: for no load factor above zero, at once, or at
        ``load_factor``."""
        return self._document["departure"]

    @property
    def load_factor(self) -> float | None:
        """Where it leaves rest, as a multiple of the variable loads; only where ``departure`` is ``at``."""
        return self._document["load_factor"]

    @property
    def departure_mode(self) -> Mode | None:
        """The mode in which it leaves rest; BF where the ground fails."""
        return None if self._document["departure_mode"] is None else mode(self._document["departure_mode"])

    @property
    def slide(self) -> float | None:
        """The displacement along the base at the end, to either side, m; None where the target does not ask for the motion, or
        the body overturns."""
        return self._document["slide"]

    @property
    def max_theta(self) -> float | None:
        """The largest angle to either side, rad; None as there."""
        return self._document["max_theta"]

    @property
    def overturned(self) -> bool | None:
        """Whether the body overturns; None where the target does not ask for the motion."""
        return self._document["overturned"]


class End(Answer):
    """An end of a stretch."""

    @property
    def value(self) -> float:
        """The outermost value that meets the target, rounded into the stretch and assessed so."""
        return self._document["value"]

    @property
    def boundary(self) -> float:
        """The same before it is rounded, to twelve digits."""
        return self._document["boundary"]

    @property
    def binds(self) -> str | None:
        """What fails beyond it, in a word; None where the bracket ends."""
        return self._document["binds"]

    @property
    def binding(self) -> str | None:
        """The same in a sentence."""
        return self._document["binding"]


class Stretch(Answer):
    """Neighbouring values that meet the target."""

    @property
    def from_(self) -> End:
        """The least."""
        return part(End, self._document["from"])

    @property
    def to(self) -> End:
        """The greatest."""
        return part(End, self._document["to"])


class Sensitivity(Answer):
    """By how much results change in the case with a number 1 % larger; None where a result is infinite or missing, at present or
    then, or that number makes no case."""

    @property
    def input(self) -> str:
        """The number."""
        return self._document["input"]

    @property
    def value(self) -> float:
        """Its present value, in ``unit``."""
        return self._document["value"]

    @property
    def unit(
        self,
    ) -> Literal[
        "m", "kg/m", "kg/m3", "N/m", "m/s2", "kg m2/m", "Pa", "s", "N m/m", "kg", "N", "kg m2", "N m"
    ] | None:
        """Its unit; None for a plain number."""
        return self._document["unit"]

    @property
    def SF_sliding(self) -> float | None:
        """Change of the least SF_sliding."""
        return self._document["SF_sliding"]

    @property
    def SF_overturning(self) -> float | None:
        """Change of the least SF_overturning."""
        return self._document["SF_overturning"]

    @property
    def load_factor(self) -> float | None:
        """Change of the least load factor."""
        return self._document["load_factor"]

    @property
    def slide(self) -> float | None:
        """Change of the displacement at the end, m, where the target asks for the motion."""
        return self._document["slide"]

    @property
    def max_theta(self) -> float | None:
        """Change of the largest angle, rad, where the target asks for the motion."""
        return self._document["max_theta"]


class DesignDocument(Answer):
    """What ``design`` answers with one quantity."""

    @property
    def schema(self) -> Literal[1]:
        """The version of the document."""
        return self._document["schema"]

    @property
    def title(self) -> str | None:
        """As the case says."""
        return self._document["title"]

    @property
    def note(self) -> str | None:
        """As the case says."""
        return self._document["note"]

    @property
    def vary(self) -> str:
        """The quantity that is varied."""
        return self._document["vary"]

    @property
    def unit(
        self,
    ) -> Literal[
        "m", "kg/m", "kg/m3", "N/m", "m/s2", "kg m2/m", "Pa", "s", "N m/m", "kg", "N", "kg m2", "N m"
    ] | None:
        """Its unit; None for a plain number."""
        return self._document["unit"]

    @property
    def target(self) -> str:
        """What has to be met."""
        return self._document["target"]

    @property
    def wanted(self) -> Literal["least", "greatest"]:
        """Which of the values that meet the target is found."""
        return self._document["wanted"]

    @property
    def bracket(self) -> list[float]:
        """Where the search began and ended, in ``unit``."""
        return list(self._document["bracket"])

    @property
    def present(self) -> Present:
        """The case as it is."""
        return part(Present, self._document["present"])

    @property
    def found(self) -> Found:
        """The case with the least or greatest value that meets the target."""
        return part(Found, self._document["found"])

    @property
    def binding(self) -> str:
        """What fails just beyond the value found."""
        return self._document["binding"]

    @property
    def warnings(self) -> list[str]:
        """That the body moves though the target is met, that nothing rises where the target asks for a rise, and what is unusual
        with the value found and is not at present."""
        return list(self._document["warnings"])

    @property
    def met(self) -> list[Stretch]:
        """All values of the bracket that meet the target, as stretches that rise."""
        return parts(Stretch, self._document["met"])

    @property
    def notes(self) -> list[str]:
        """What goes with the quantity, and what does not."""
        return list(self._document["notes"])

    @property
    def sensitivity_per_percent(self) -> list[Sensitivity]:
        """What 1 % more of each number of the case does to its safety."""
        return parts(Sensitivity, self._document["sensitivity_per_percent"])


class Quantity(Answer):
    """a quantity and where it is looked at."""

    @property
    def name(self) -> str:
        """What it is called."""
        return self._document["name"]

    @property
    def unit(
        self,
    ) -> Literal[
        "m", "kg/m", "kg/m3", "N/m", "m/s2", "kg m2/m", "Pa", "s", "N m/m", "kg", "N", "kg m2", "N m"
    ] | None:
        """Its unit; None for a plain number."""
        return self._document["unit"]

    @property
    def present(self) -> float:
        """Its present value, in ``unit``."""
        return self._document["present"]

    @property
    def bracket(self) -> list[float]:
        """Where the search began and ended, in ``unit``."""
        return list(self._document["bracket"])


class Column(Answer):
    """a value of ``and`` and the values of ``vary`` that meet the target with it."""

    @property
    def value(self) -> float:
        """The value of ``and``."""
        return self._document["value"]

    @property
    def met(self) -> list[Stretch]:
        """The values of ``vary``, as stretches that rise."""
        return parts(Stretch, self._document["met"])

    @property
    def binds(self) -> str | None:
        """Where there are none, what fails where the target is nearest to be met, in a word; None where there are some, or no
        case is possible."""
        return self._document["binds"]


class BoundaryDocument(Answer):
    """What ``design`` answers with two quantities."""

    @property
    def schema(self) -> Literal[1]:
        """The version of the document."""
        return self._document["schema"]

    @property
    def title(self) -> str | None:
        """As the case says."""
        return self._document["title"]

    @property
    def note(self) -> str | None:
        """As the case says."""
        return self._document["note"]

    @property
    def target(self) -> str:
        """What has to be met."""
        return self._document["target"]

    @property
    def wanted(self) -> Literal["least", "greatest"]:
        """Which of the values that meet the target is found."""
        return self._document["wanted"]

    @property
    def vary(self) -> Quantity:
        """The quantity whose values that meet the target are found."""
        return part(Quantity, self._document["vary"])

    @property
    def and_(self) -> Quantity:
        """The quantity for values of which they are found."""
        return part(Quantity, self._document["and"])

    @property
    def present_meets(self) -> bool:
        """Whether the target is met with the present values of both."""
        return self._document["present_meets"]

    @property
    def columns(self) -> list[Column]:
        """By rising values of ``and``."""
        return parts(Column, self._document["columns"])

    @property
    def notes(self) -> list[str]:
        """What goes with the quantities, and what does not."""
        return list(self._document["notes"])
