"""The parts of an answer: classes with a property for each key of the JSON document that ``docs/answer.schema.json`` describes.

Units are SI; forces, masses and moments are per metre run or, of an object of a given length or a cylinder, of the whole: see
:attr:`Document.extent`. ``None`` says that there is no such thing; a number without bound is ``math.inf``.
"""

# Made by python/make_answers.py; changes go into docs/answer.schema.json.
# mypy: disable-error-code="no-any-return"

from __future__ import annotations

from typing import Literal

from ._answer import Answer, mode, modes, modes_or, part, parts
from ._modes import Mode, Modes

__all__ = [
    "Body",
    "CaseWarning",
    "Change",
    "Combination",
    "Component",
    "Criterion",
    "Document",
    "Earthquake",
    "Event",
    "Ground",
    "Load",
    "Motion",
    "OtherEarthquake",
    "Part",
    "Point",
    "Relation",
    "Report",
    "Situation",
    "Stage",
    "Step",
    "Water",
    "Wave",
    "Wrench",
]


class Relation(Answer):
    """An inequality with its numbers."""

    @property
    def equation(self) -> str:
        """The report's equation number, or the condition of the contact problem."""
        return self._document["equation"]

    @property
    def statement(self) -> str:
        """The inequality in symbols."""
        return self._document["statement"]

    @property
    def left(self) -> float:
        """The value of its left side."""
        return self._document["left"]

    @property
    def sign(self) -> Literal["<", "≤", "≥", ">"]:
        """The sign between both sides."""
        return self._document["sign"]

    @property
    def right(self) -> float:
        """The value of its right side."""
        return self._document["right"]

    @property
    def holds(self) -> bool:
        """Whether it holds, decided exactly."""
        return self._document["holds"]

    @property
    def margin(self) -> float:
        """How far the left side is on the right side of the sign: negative where the inequality does not hold."""
        return self._document["margin"]


class Change(Answer):
    """a change of mode as k or μ grows."""

    @property
    def at(self) -> float:
        """The critical value of k or μ."""
        return self._document["at"]

    @property
    def from_(self) -> Mode:
        """The mode just below it."""
        return mode(self._document["from"])

    @property
    def to(self) -> Mode:
        """The mode just above it."""
        return mode(self._document["to"])


class Motion(Answer):
    """Accelerations and reactions at the moment a mode begins."""

    @property
    def x_ddot(self) -> float:
        """ẍ of the centre of mass, to the right."""
        return self._document["x_ddot"]

    @property
    def y_ddot(self) -> float:
        """ÿ of the centre of mass, upwards."""
        return self._document["y_ddot"]

    @property
    def theta_ddot(self) -> float:
        """θ̈, counter-clockwise."""
        return self._document["theta_ddot"]

    @property
    def f_x(self) -> float:
        """The horizontal reaction on the body, to the right."""
        return self._document["f_x"]

    @property
    def f_y(self) -> float:
        """The vertical reaction on the body, upwards."""
        return self._document["f_y"]

    @property
    def xi(self) -> float:
        """ξ, the distance of f_y to the right of the centre of mass; zero where there is no reaction."""
        return self._document["xi"]

    @property
    def slip(self) -> float:
        """ẍ of both corners, along the base to the right."""
        return self._document["slip"]

    @property
    def lift_o(self) -> float:
        """ÿ of O, upwards."""
        return self._document["lift_o"]

    @property
    def lift_o_prime(self) -> float:
        """ÿ of O', upwards."""
        return self._document["lift_o_prime"]


class Wrench(Answer):
    """a load at the centre of mass; see ``extent``."""

    @property
    def x(self) -> float:
        """Horizontal force, to the right, N/m."""
        return self._document["x"]

    @property
    def p(self) -> float:
        """Net vertical force, downwards, N/m."""
        return self._document["p"]

    @property
    def m(self) -> float:
        """Moment about the centre of mass, counter-clockwise, N m/m."""
        return self._document["m"]


class Body(Answer):
    """The body and its base; see ``extent``."""

    @property
    def shape(self) -> Literal["block", "cylinder"]:
        """a block, or an upright cylinder whose diameter is the width."""
        return self._document["shape"]

    @property
    def width(self) -> float:
        """2B, m."""
        return self._document["width"]

    @property
    def height(self) -> float:
        """2H, m."""
        return self._document["height"]

    @property
    def length(self) -> float | None:
        """Out of the plane, m; None of a body per metre run, and of a cylinder."""
        return self._document["length"]

    @property
    def mass(self) -> float:
        """Kg/m."""
        return self._document["mass"]

    @property
    def weight(self) -> float:
        """m g, N/m."""
        return self._document["weight"]

    @property
    def slenderness(self) -> float:
        """γ = H/B."""
        return self._document["slenderness"]

    @property
    def friction(self) -> float:
        """μ to stick."""
        return self._document["friction"]

    @property
    def kinetic_friction(self) -> float:
        """μ to slip."""
        return self._document["kinetic_friction"]

    @property
    def added_mass(self) -> float:
        """Water that moves with the body horizontally, kg/m."""
        return self._document["added_mass"]

    @property
    def centroid_height(self) -> float:
        """Height of the centre of mass above the base, m."""
        return self._document["centroid_height"]

    @property
    def heel_distance(self) -> float:
        """From O to the centre of mass, m."""
        return self._document["heel_distance"]

    @property
    def toe_distance(self) -> float:
        """From the centre of mass to O', m."""
        return self._document["toe_distance"]

    @property
    def moment_of_inertia(self) -> float:
        """About the centre of mass, kg m²/m."""
        return self._document["moment_of_inertia"]

    @property
    def parts(self) -> list[Part]:
        """What it is made of; empty where it is of one piece."""
        return parts(Part, self._document["parts"])


class Part(Answer):
    """a part of the section."""

    @property
    def name(self) -> str | None:
        """As the case says."""
        return self._document["name"]

    @property
    def density(self) -> float:
        """Kg/m³; 0 of a cavity."""
        return self._document["density"]

    @property
    def density_below_water(self) -> float:
        """Under still water, kg/m³."""
        return self._document["density_below_water"]

    @property
    def outline(self) -> list[list[float]]:
        """Its corners, counter-clockwise: to the right of the origin of the section and above the base, m."""
        return list(self._document["outline"])


class Water(Answer):
    """Still water."""

    @property
    def left(self) -> float:
        """Its level above the base at the left, m."""
        return self._document["left"]

    @property
    def right(self) -> float:
        """The same at the right, m."""
        return self._document["right"]

    @property
    def density(self) -> float:
        """Kg/m³."""
        return self._document["density"]


class Wave(Answer):
    """Waves by Goda's formulas."""

    @property
    def H13(self) -> float:
        """Significant wave height, m."""
        return self._document["H13"]

    @property
    def Hmax(self) -> float:
        """Design wave height, m."""
        return self._document["Hmax"]

    @property
    def deep_water_wavelength(self) -> float:
        """L₀, m."""
        return self._document["deep_water_wavelength"]

    @property
    def wavelength(self) -> float:
        """L, m."""
        return self._document["wavelength"]

    @property
    def h_b(self) -> float:
        """Depth at five significant wave heights seaward, m."""
        return self._document["h_b"]

    @property
    def angle_deg(self) -> float:
        """β after the turn towards the normal, degrees."""
        return self._document["angle_deg"]

    @property
    def turn_deg(self) -> float:
        """By how much waves are turned towards the normal at most, degrees."""
        return self._document["turn_deg"]

    @property
    def impulsive(self) -> bool:
        """Whether the impulsive coefficient takes part."""
        return self._document["impulsive"]

    @property
    def lambda_(self) -> list[float]:
        """λ₁, λ₂, λ₃."""
        return list(self._document["lambda"])

    @property
    def eta_star(self) -> float:
        """η*, how far above still water the pressure would reach, m."""
        return self._document["eta_star"]

    @property
    def h_c_star(self) -> float:
        """h_c*, how far above still water the pressure reaches on the wall, m."""
        return self._document["h_c_star"]

    @property
    def alpha_1(self) -> float:
        """α₁."""
        return self._document["alpha_1"]

    @property
    def alpha_2(self) -> float:
        """α₂."""
        return self._document["alpha_2"]

    @property
    def alpha_3(self) -> float:
        """α₃."""
        return self._document["alpha_3"]

    @property
    def alpha_4(self) -> float:
        """α₄."""
        return self._document["alpha_4"]

    @property
    def alpha_I(self) -> float:
        """α_I, the impulsive coefficient, whether used or not."""
        return self._document["alpha_I"]

    @property
    def alpha_star(self) -> float:
        """α*, the larger of α₂ and α_I, or α₂."""
        return self._document["alpha_star"]

    @property
    def p1(self) -> float:
        """Pressure at still water, Pa."""
        return self._document["p1"]

    @property
    def p3(self) -> float:
        """Pressure at the base, Pa."""
        return self._document["p3"]

    @property
    def p4(self) -> float:
        """Pressure at the top of the loaded wall, Pa."""
        return self._document["p4"]

    @property
    def pu(self) -> float:
        """Uplift pressure at the seaward toe, Pa; zero at the heel."""
        return self._document["pu"]


class CaseWarning(Answer):
    """What is possible, but so unusual that it may be a slip."""

    @property
    def name(
        self,
    ) -> Literal[
        "base-beyond-body", "weight-beside-base", "mean-density", "part-density", "water-density", "high-friction",
        "unusual-gravity", "buoyant-above-weight", "buoyant-beside-displacement", "buoyant-beside-parts",
        "load-in-no-combination", "load-beside-body", "small-bearing", "unusual-ground", "strong-earthquake",
        "earthquake-without-added-mass", "wave-height-ratio", "uplift-beside-wave", "impulsive-breaking",
        "deep-water", "higher-than-breaking", "no-pressure-at-base", "base-below-bed", "berm-below-base",
        "long-period", "steep-bed"
    ]:
        """Its name."""
        return self._document["name"]

    @property
    def message(self) -> str:
        """What it says, with the value that triggered it."""
        return self._document["message"]


class Load(Answer):
    """The force that acts alone of those that do."""

    @property
    def name(self) -> str | None:
        """As the case calls it."""
        return self._document["name"]

    @property
    def force(self) -> float:
        """N/m."""
        return self._document["force"]

    @property
    def elevation(self) -> float:
        """Above the base, m."""
        return self._document["elevation"]

    @property
    def distance(self) -> float | None:
        """To the right of O, m; None at mid-width."""
        return self._document["distance"]

    @property
    def direction(self) -> Literal["left", "right", "down", "up"]:
        """Where it points."""
        return self._document["direction"]


class Combination(Answer):
    """Loads that act together, each times a factor."""

    @property
    def name(self) -> str | None:
        """As the case calls it."""
        return self._document["name"]

    @property
    def factors(self) -> dict[str, float]:
        """By the names of loads, or weight, water, uplift, wave, earthquake."""
        return dict(self._document["factors"])


class Earthquake(Answer):
    """An acceleration of the base."""

    @property
    def horizontal(self) -> float:
        """To the right, m/s²."""
        return self._document["horizontal"]

    @property
    def vertical(self) -> float:
        """Upwards, m/s²."""
        return self._document["vertical"]


class OtherEarthquake(Answer):
    """An acceleration of the base that was tried, and what becomes of the body."""

    @property
    def horizontal(self) -> float:
        """To the right, m/s²."""
        return self._document["horizontal"]

    @property
    def vertical(self) -> float:
        """Upwards, m/s²."""
        return self._document["vertical"]

    @property
    def mode(self) -> Mode | None:
        """The mode under the full load, applied at once; BF where the ground fails."""
        return None if self._document["mode"] is None else mode(self._document["mode"])

    @property
    def departure(self) -> Literal["never", "at-once", "at"]:
        """As in a situation."""
        return self._document["departure"]

    @property
    def load_factor(self) -> float | None:
        """As in a situation."""
        return self._document["load_factor"]

    @property
    def departure_mode(self) -> Mode | None:
        """The mode in which it leaves rest; BF where the ground fails."""
        return None if self._document["departure_mode"] is None else mode(self._document["departure_mode"])

    @property
    def SF_sliding(self) -> float | None:
        """As in a situation."""
        return self._document["SF_sliding"]

    @property
    def SF_overturning(self) -> float | None:
        """As in a situation."""
        return self._document["SF_overturning"]


class Criterion(Answer):
    """What is asked of a result, and how far it is met."""

    @property
    def name(
        self,
    ) -> Literal[
        "SF_sliding", "SF_overturning", "bearing_max", "contact_share", "eccentricity", "load_factor",
        "ground_factor", "effective_pressure_max", "rotation_max", "p_not_rest", "modes_not", "slide", "max_theta",
        "overturned"
    ]:
        """That of the result; slide, max_theta and overturned are of the motion of a case in time; ground_factor,
        effective_pressure_max and rotation_max ask for factor, effective_pressure and rotation of the ground, p_not_rest for the
        upper end of the interval of the probability that the body does not stay at rest, modes_not for the modes under the full
        load."""
        return self._document["name"]

    @property
    def required(self) -> float | Modes | Literal[False]:
        """At least for factors and contact, at most for pressure and eccentricity, in SI units; the modes that are not allowed;
        false: the body may not overturn."""
        return modes_or(self._document["required"])

    @property
    def value(self) -> float | Modes | bool | None:
        """The value; of the load factor 0 where the body leaves rest at once and infinite where it never does; all consistent
        modes; None where there is no such thing."""
        return modes_or(self._document["value"])

    @property
    def utilisation(self) -> float | None:
        """Required/value, or value/required: up to 1 where it is met; infinite where no value could meet it; None for modes."""
        return self._document["utilisation"]

    @property
    def met(self) -> bool:
        """Whether it is met."""
        return self._document["met"]

    @property
    def situation(self) -> int:
        """The place of the situation, from zero."""
        return self._document["situation"]

    @property
    def earthquake(self) -> Earthquake | None:
        """The acceleration of the base under which it is met worst, of those that were tried; None where none acts."""
        return None if self._document["earthquake"] is None else part(Earthquake, self._document["earthquake"])


class Component(Answer):
    """a load of a situation, at the centre of mass."""

    @property
    def name(self) -> str:
        """What it is called."""
        return self._document["name"]

    @property
    def source(
        self,
    ) -> Literal[
        "weight", "buoyant-weight", "buoyancy", "still-water", "water-on-left", "water-on-right", "uplift",
        "horizontal-inertia", "shaken-water", "vertical-inertia", "wave-pressure", "wave-uplift", "force", "pressure",
        "other"
    ]:
        """Where it comes from."""
        return self._document["source"]

    @property
    def counts_as(self) -> Literal["weight", "uplift", "horizontal"]:
        """How it counts among the classical actions."""
        return self._document["counts_as"]

    @property
    def permanent(self) -> bool:
        """Whether it is there all the time, or grows with the load factor."""
        return self._document["permanent"]

    @property
    def factor(self) -> float:
        """The factor of the combination that it is multiplied by."""
        return self._document["factor"]

    @property
    def x(self) -> float:
        """Horizontal force, to the right, N/m."""
        return self._document["x"]

    @property
    def p(self) -> float:
        """Net vertical force, downwards, N/m."""
        return self._document["p"]

    @property
    def m(self) -> float:
        """Moment about the centre of mass, counter-clockwise, N m/m."""
        return self._document["m"]


class Stage(Answer):
    """a stretch of load factors with the same modes."""

    @property
    def from_(self) -> float:
        """The load factor at which it begins."""
        return self._document["from"]

    @property
    def to(self) -> float:
        """The load factor at which it ends, or to which the path was followed."""
        return self._document["to"]

    @property
    def mode(self) -> Mode | None:
        """The mode; None where none is consistent."""
        return None if self._document["mode"] is None else mode(self._document["mode"])

    @property
    def also(self) -> Modes:
        """The other consistent modes."""
        return modes(self._document["also"])


class Step(Answer):
    """a mode, and what it needs."""

    @property
    def mode(self) -> Mode:
        """The mode."""
        return mode(self._document["mode"])

    @property
    def holds(self) -> bool:
        """Whether it begins."""
        return self._document["holds"]

    @property
    def relations(self) -> list[Relation]:
        """The inequalities that it needs."""
        return parts(Relation, self._document["relations"])


class Situation(Answer):
    """The answer to the case under loads that act together."""

    @property
    def load(self) -> Load | None:
        """The force that acts alone; None where none does."""
        return None if self._document["load"] is None else part(Load, self._document["load"])

    @property
    def combination(self) -> Combination | None:
        """The combination whose loads act; None where the case has none."""
        return None if self._document["combination"] is None else part(Combination, self._document["combination"])

    @property
    def earthquake(self) -> Earthquake | None:
        """The acceleration of the base, the worst of those that were tried, before the factor of a combination; None where no
        earthquake acts."""
        return None if self._document["earthquake"] is None else part(Earthquake, self._document["earthquake"])

    @property
    def other_earthquakes(self) -> list[OtherEarthquake]:
        """The others that were tried, none of them worse as a whole; a criterion may be met worse under one of them."""
        return parts(OtherEarthquake, self._document["other_earthquakes"])

    @property
    def criteria(self) -> list[Criterion]:
        """The criteria, the governing one first."""
        return parts(Criterion, self._document["criteria"])

    @property
    def mode(self) -> Mode | None:
        """The mode under the full load, applied at once; BF where the ground fails."""
        return None if self._document["mode"] is None else mode(self._document["mode"])

    @property
    def unique(self) -> bool:
        """Whether no other mode is consistent under the full load."""
        return self._document["unique"]

    @property
    def also(self) -> Modes:
        """The other consistent modes."""
        return modes(self._document["also"])

    @property
    def lifted(self) -> bool:
        """Whether nothing presses the body on its base under the full load; safety factors then mean nothing."""
        return self._document["lifted"]

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
    def departure_by(self) -> Literal["permanent-loads", "any-share"] | None:
        """What moves a body that departs at once: its permanent loads alone, or any share of the variable ones, however small."""
        return self._document["departure_by"]

    @property
    def SF_sliding(self) -> float | None:
        """Safety factor against sliding, μ(W' − U)/P."""
        return self._document["SF_sliding"]

    @property
    def SF_overturning(self) -> float | None:
        """Safety factor against overturning, the lesser of both corners."""
        return self._document["SF_overturning"]

    @property
    def SF_overturning_heel(self) -> float | None:
        """The same about the heel, (W' t − M_U)/M_p."""
        return self._document["SF_overturning_heel"]

    @property
    def SF_overturning_toe(self) -> float | None:
        """The same about the toe, (W'(B_c − t) − U B_c + M_U)/(−M_p)."""
        return self._document["SF_overturning_toe"]

    @property
    def SF_overturning_gross(self) -> float | None:
        """Safety factor against overturning by gross moments, (W' t + M_s)/(M_s + M_U + M_p) about the heel, the lesser of both
        corners: the whole weight against all water under the base and P."""
        return self._document["SF_overturning_gross"]

    @property
    def margin_sliding(self) -> float:
        """What friction leaves of the horizontal force, μ(W' − U) − P: negative where the body cannot rest for want of friction,
        and where it is lifted, N/m."""
        return self._document["margin_sliding"]

    @property
    def margin_overturning(self) -> float:
        """The lesser of both corners' moments that press the body on its base: negative where the resultant misses the base, and
        where the body is lifted; with ``margin_sliding`` not negative, the body can rest on a rigid base; ``ground_margin`` is
        that of another, N m/m."""
        return self._document["margin_overturning"]

    @property
    def margin_overturning_heel(self) -> float:
        """The same about the heel, W' t − M_U − M_p, N m/m."""
        return self._document["margin_overturning_heel"]

    @property
    def margin_overturning_toe(self) -> float:
        """The same about the toe, W'(B_c − t) − U B_c + M_U + M_p, N m/m."""
        return self._document["margin_overturning_toe"]

    @property
    def bearing(self) -> Literal["pressed", "outside-base", "lifted"]:
        """Whether the base can carry the resultant: it does, the resultant misses the base, or nothing presses."""
        return self._document["bearing"]

    @property
    def heel_pressure(self) -> float | None:
        """Bearing pressure at the heel, Pa."""
        return self._document["heel_pressure"]

    @property
    def toe_pressure(self) -> float | None:
        """Bearing pressure at the toe, Pa."""
        return self._document["toe_pressure"]

    @property
    def bearing_max(self) -> float | None:
        """The larger of both, Pa."""
        return self._document["bearing_max"]

    @property
    def contact_length(self) -> float | None:
        """The length of the base that is pressed, m."""
        return self._document["contact_length"]

    @property
    def contact_share(self) -> float | None:
        """The share of the base's area that is pressed."""
        return self._document["contact_share"]

    @property
    def resultant_arm(self) -> float | None:
        """t_e, distance of the resultant from the heel, m."""
        return self._document["resultant_arm"]

    @property
    def eccentricity(self) -> float | None:
        """Distance of the resultant from the middle of the base, where it meets the base, m."""
        return self._document["eccentricity"]

    @property
    def heel(self) -> Literal["O", "O'"]:
        """The corner that the classical checks call the heel."""
        return self._document["heel"]

    @property
    def P(self) -> float:
        """Horizontal force, towards the heel, N/m."""
        return self._document["P"]

    @property
    def M_p(self) -> float:
        """Its moment about the base, N m/m."""
        return self._document["M_p"]

    @property
    def U(self) -> float:
        """Uplift, N/m."""
        return self._document["U"]

    @property
    def M_U(self) -> float:
        """Its moment about the heel, N m/m."""
        return self._document["M_U"]

    @property
    def buoyant_weight(self) -> float:
        """W', weight less buoyancy, N/m."""
        return self._document["buoyant_weight"]

    @property
    def weight_arm(self) -> float:
        """t, its arm to the heel, m."""
        return self._document["weight_arm"]

    @property
    def k_eff(self) -> float | None:
        """k of the load in the report's diagram, where it has a point there."""
        return self._document["k_eff"]

    @property
    def k_prime_eff(self) -> float | None:
        """k' of the load in the report's diagram."""
        return self._document["k_prime_eff"]

    @property
    def ground(self) -> Ground | None:
        """What the base bears; None where the case has no [ground], and it bears everything. On one that crushes or fails, mode,
        motion, departure and path are those of it."""
        return None if self._document["ground"] is None else part(Ground, self._document["ground"])

    @property
    def mode_words(self) -> str | None:
        """The mode as a predicate of the body."""
        return self._document["mode_words"]

    @property
    def because(self) -> list[Relation]:
        """The inequalities that decide the mode: the report's where the load has a point in its diagram, otherwise the conditions
        of the contact problem."""
        return parts(Relation, self._document["because"])

    @property
    def motion(self) -> Motion | None:
        """The motion in that mode, in m/s², rad/s², N/m and m; in an earthquake the accelerations are relative to the base."""
        return None if self._document["motion"] is None else part(Motion, self._document["motion"])

    @property
    def wrench(self) -> Wrench:
        """All loads."""
        return part(Wrench, self._document["wrench"])

    @property
    def components(self) -> list[Component]:
        """The loads one by one."""
        return parts(Component, self._document["components"])

    @property
    def path(self) -> list[Stage]:
        """The modes as the variable loads rise from zero; empty where all are permanent."""
        return parts(Stage, self._document["path"])

    @property
    def report(self) -> Report | None:
        """The load in the report's diagram, which is that of a rigid base; None where ``no_report`` says why."""
        return None if self._document["report"] is None else part(Report, self._document["report"])

    @property
    def no_report(self) -> Literal["no-point", "base-gives-way"] | None:
        """Why there is no ``report``: the load has no point in the report's diagram, or the base crushes or the ground fails;
        None where there is one."""
        return self._document["no_report"]


class Ground(Answer):
    """What the base bears under the full load; lengths in m, no partial factor applied. None where nothing presses, or the case
    does not say."""

    @property
    def omega(self) -> float | None:
        """ω, the share of the base that crushes under P alone, P/(2B q_u); from 1 on it cannot carry P."""
        return self._document["omega"]

    @property
    def pivot(self) -> float | None:
        """Of a base that crushes, how far inside its edge the reaction of a body acts that turns, or is about to, m."""
        return self._document["pivot"]

    @property
    def neutral(self) -> float | None:
        """Of a base that crushes, how far inside its edge the neutral point is about which the body turns, m."""
        return self._document["neutral"]

    @property
    def effective_width(self) -> float | None:
        """B' = 2(B − |e|), the width that the resultant has in its middle; 0 where it misses the base, m."""
        return self._document["effective_width"]

    @property
    def effective_pressure(self) -> float | None:
        """Pressure on the effective width, P/B', Pa."""
        return self._document["effective_pressure"]

    @property
    def resistance(self) -> float | None:
        """R, what the ground bears at the eccentricity and inclination of the resultant, no partial factor applied, N/m."""
        return self._document["resistance"]

    @property
    def factor(self) -> float | None:
        """R/P, what the ground bears over what presses on it."""
        return self._document["factor"]

    @property
    def margin(self) -> float | None:
        """R − P, what the ground leaves: negative where it does not bear a body at rest; with ``margin_sliding`` not negative
        either, the body can rest on this base, N/m."""
        return self._document["margin"]

    @property
    def load_factor_ground(self) -> float | None:
        """Where R/P falls to 1 under a body that friction holds, as a multiple of the variable loads; 0 under the permanent loads
        alone."""
        return self._document["load_factor_ground"]

    @property
    def load_factor_ground_less(self) -> float | None:
        """The same at an angle of friction 2° less."""
        return self._document["load_factor_ground_less"]

    @property
    def load_factor_ground_more(self) -> float | None:
        """The same at an angle of friction 2° more."""
        return self._document["load_factor_ground_more"]

    @property
    def k_BF(self) -> float | None:
        """Horizontal by vertical force at which R/P is 1, if force and moment grow as they stand to each other under the full
        load."""
        return self._document["k_BF"]

    @property
    def rotation(self) -> float | None:
        """Rotation on the elastic base under the full load, raised slowly, rad."""
        return self._document["rotation"]

    @property
    def k_overturn(self) -> float | None:
        """Horizontal by vertical force at which the body overturns on the elastic base if the load is raised slowly, as
        ``k_BF``."""
        return self._document["k_overturn"]

    @property
    def periods(self) -> list[float] | None:
        """Natural periods of sway and rocking on the elastic base, s, the longer first."""
        return None if self._document["periods"] is None else list(self._document["periods"])

    @property
    def D_shear(self) -> float | None:
        """The largest shear of the base over that of the loads in time."""
        return self._document["D_shear"]

    @property
    def D_moment(self) -> float | None:
        """The largest moment about the middle of the base over that of the loads in time."""
        return self._document["D_moment"]

    @property
    def k_moved(self) -> float | None:
        """Where the loads in time take k of the full load in the k–μ plane, D_shear k; if they alone push and turn the body."""
        return self._document["k_moved"]

    @property
    def k_prime_moved(self) -> float | None:
        """The same of k', (1 + k') D_moment/D_shear − 1."""
        return self._document["k_prime_moved"]

    @property
    def first_event(self) -> Literal["slip", "lift", "yield"] | None:
        """What first ends the linear response of the elastic base: the base slips, an edge lifts, or it yields."""
        return self._document["first_event"]

    @property
    def first_event_time(self) -> float | None:
        """When that is, s."""
        return self._document["first_event_time"]

    @property
    def events(self) -> list[Event]:
        """Each event, of loads in time; empty where no load has a history."""
        return parts(Event, self._document["events"])


class Event(Answer):
    """An event of the response of an elastic base to loads in time."""

    @property
    def event(self) -> Literal["slip", "lift", "yield"]:
        """The base slips, an edge lifts, or an edge yields."""
        return self._document["event"]

    @property
    def time(self) -> float | None:
        """When it happens first, s; None if it does not."""
        return self._document["time"]

    @property
    def load_factor(self) -> float:
        """The multiple of the loads in time at which it happens at all; 0 where the others do it, infinite where none does."""
        return self._document["load_factor"]


class Point(Answer):
    """a point of the report's diagram and all that is known of it: lengths in B, accelerations in g, θ̈ in g/B, forces in m g;
    modes and motion are those of the body itself, also where it is mirrored."""

    @property
    def gamma(self) -> float:
        """γ = H/B."""
        return self._document["gamma"]

    @property
    def k_prime(self) -> float:
        """k', the height of the force above the centre of mass in H."""
        return self._document["k_prime"]

    @property
    def k(self) -> float:
        """k = F/(m g)."""
        return self._document["k"]

    @property
    def mu(self) -> float:
        """μ."""
        return self._document["mu"]

    @property
    def mirrored(self) -> bool:
        """Whether the force points right, and the diagram shows the mirror image."""
        return self._document["mirrored"]

    @property
    def mode(self) -> Mode:
        """The mode."""
        return mode(self._document["mode"])

    @property
    def mode_words(self) -> str:
        """The mode as a predicate of the body."""
        return self._document["mode_words"]

    @property
    def unique(self) -> bool:
        """Whether no other mode is consistent."""
        return self._document["unique"]

    @property
    def also(self) -> Modes:
        """The other consistent modes."""
        return modes(self._document["also"])

    @property
    def case(self) -> str:
        """The report's case, by the elevation of the force."""
        return self._document["case"]

    @property
    def motion(self) -> Motion:
        """The motion in that mode, in g, g/B, m g and B; in an earthquake the accelerations are relative to the base."""
        return part(Motion, self._document["motion"])

    @property
    def trace(self) -> list[Step]:
        """The decision step by step; the last step's mode begins."""
        return parts(Step, self._document["trace"])

    @property
    def leaves_rest(self) -> Change | None:
        """Where the body leaves rest as k grows; None if no force moves it."""
        return None if self._document["leaves_rest"] is None else part(Change, self._document["leaves_rest"])

    @property
    def along_k(self) -> list[Change]:
        """All changes of mode as k grows from zero."""
        return parts(Change, self._document["along_k"])

    @property
    def along_mu(self) -> list[Change]:
        """All changes of mode as μ grows from zero."""
        return parts(Change, self._document["along_mu"])


class Report(Point):
    """The load in the report's diagram, which is that of a rigid base; None where ``no_report`` says why."""

    @property
    def SF_overturning_effective(self) -> float:
        """Safety factor against overturning of the point, 1/(k_eff γ |1+k'_eff|), which counts uplift and eccentric weight as a
        load."""
        return self._document["SF_overturning_effective"]


class Document(Answer):
    """The answer to a case."""

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
    def gravity(self) -> float:
        """g, m/s²."""
        return self._document["gravity"]

    @property
    def extent(self) -> Literal["per-metre", "whole"]:
        """What all forces, masses and moments are of."""
        return self._document["extent"]

    @property
    def body(self) -> Body:
        """The body."""
        return part(Body, self._document["body"])

    @property
    def weight_counted_as(self) -> str:
        """How water takes part in the weight."""
        return self._document["weight_counted_as"]

    @property
    def water(self) -> Water | None:
        """Still water."""
        return None if self._document["water"] is None else part(Water, self._document["water"])

    @property
    def wave(self) -> Wave | None:
        """The waves."""
        return None if self._document["wave"] is None else part(Wave, self._document["wave"])

    @property
    def warnings(self) -> list[CaseWarning]:
        """What is unusual."""
        return parts(CaseWarning, self._document["warnings"])

    @property
    def met(self) -> bool | None:
        """Whether all criteria are met, in all situations; None where the case has none."""
        return self._document["met"]

    @property
    def criteria(self) -> list[Criterion]:
        """Each criterion in the situation that meets it worst, the governing one first."""
        return parts(Criterion, self._document["criteria"])

    @property
    def in_time(self) -> str | None:
        """Of a case that says how its loads go with time, what is answered of its first instant; None of another."""
        return self._document["in_time"]


class OnlySituation:
    """What a case with one situation says of it: the properties of that :class:`Situation`."""

    def _only(self) -> Situation:
        """The situation; an ``AttributeError`` if there are several."""
        raise NotImplementedError

    @property
    def load(self) -> Load | None:
        """The force that acts alone; None where none does."""
        return self._only().load

    @property
    def combination(self) -> Combination | None:
        """The combination whose loads act; None where the case has none."""
        return self._only().combination

    @property
    def earthquake(self) -> Earthquake | None:
        """The acceleration of the base, the worst of those that were tried, before the factor of a combination; None where no
        earthquake acts."""
        return self._only().earthquake

    @property
    def other_earthquakes(self) -> list[OtherEarthquake]:
        """The others that were tried, none of them worse as a whole; a criterion may be met worse under one of them."""
        return self._only().other_earthquakes

    @property
    def mode(self) -> Mode | None:
        """The mode under the full load, applied at once; BF where the ground fails."""
        return self._only().mode

    @property
    def unique(self) -> bool:
        """Whether no other mode is consistent under the full load."""
        return self._only().unique

    @property
    def also(self) -> Modes:
        """The other consistent modes."""
        return self._only().also

    @property
    def lifted(self) -> bool:
        """Whether nothing presses the body on its base under the full load; safety factors then mean nothing."""
        return self._only().lifted

    @property
    def departure(self) -> Literal["never", "at-once", "at"]:
        """Whether the body leaves rest as the variable loads rise: for no load factor above zero, at once, or at
        ``load_factor``."""
        return self._only().departure

    @property
    def load_factor(self) -> float | None:
        """Where it leaves rest, as a multiple of the variable loads; only where ``departure`` is ``at``."""
        return self._only().load_factor

    @property
    def departure_mode(self) -> Mode | None:
        """The mode in which it leaves rest; BF where the ground fails."""
        return self._only().departure_mode

    @property
    def departure_by(self) -> Literal["permanent-loads", "any-share"] | None:
        """What moves a body that departs at once: its permanent loads alone, or any share of the variable ones, however small."""
        return self._only().departure_by

    @property
    def SF_sliding(self) -> float | None:
        """Safety factor against sliding, μ(W' − U)/P."""
        return self._only().SF_sliding

    @property
    def SF_overturning(self) -> float | None:
        """Safety factor against overturning, the lesser of both corners."""
        return self._only().SF_overturning

    @property
    def SF_overturning_heel(self) -> float | None:
        """The same about the heel, (W' t − M_U)/M_p."""
        return self._only().SF_overturning_heel

    @property
    def SF_overturning_toe(self) -> float | None:
        """The same about the toe, (W'(B_c − t) − U B_c + M_U)/(−M_p)."""
        return self._only().SF_overturning_toe

    @property
    def SF_overturning_gross(self) -> float | None:
        """Safety factor against overturning by gross moments, (W' t + M_s)/(M_s + M_U + M_p) about the heel, the lesser of both
        corners: the whole weight against all water under the base and P."""
        return self._only().SF_overturning_gross

    @property
    def margin_sliding(self) -> float:
        """What friction leaves of the horizontal force, μ(W' − U) − P: negative where the body cannot rest for want of friction,
        and where it is lifted, N/m."""
        return self._only().margin_sliding

    @property
    def margin_overturning(self) -> float:
        """The lesser of both corners' moments that press the body on its base: negative where the resultant misses the base, and
        where the body is lifted; with ``margin_sliding`` not negative, the body can rest on a rigid base; ``ground_margin`` is
        that of another, N m/m."""
        return self._only().margin_overturning

    @property
    def margin_overturning_heel(self) -> float:
        """The same about the heel, W' t − M_U − M_p, N m/m."""
        return self._only().margin_overturning_heel

    @property
    def margin_overturning_toe(self) -> float:
        """The same about the toe, W'(B_c − t) − U B_c + M_U + M_p, N m/m."""
        return self._only().margin_overturning_toe

    @property
    def bearing(self) -> Literal["pressed", "outside-base", "lifted"]:
        """Whether the base can carry the resultant: it does, the resultant misses the base, or nothing presses."""
        return self._only().bearing

    @property
    def heel_pressure(self) -> float | None:
        """Bearing pressure at the heel, Pa."""
        return self._only().heel_pressure

    @property
    def toe_pressure(self) -> float | None:
        """Bearing pressure at the toe, Pa."""
        return self._only().toe_pressure

    @property
    def bearing_max(self) -> float | None:
        """The larger of both, Pa."""
        return self._only().bearing_max

    @property
    def contact_length(self) -> float | None:
        """The length of the base that is pressed, m."""
        return self._only().contact_length

    @property
    def contact_share(self) -> float | None:
        """The share of the base's area that is pressed."""
        return self._only().contact_share

    @property
    def resultant_arm(self) -> float | None:
        """t_e, distance of the resultant from the heel, m."""
        return self._only().resultant_arm

    @property
    def eccentricity(self) -> float | None:
        """Distance of the resultant from the middle of the base, where it meets the base, m."""
        return self._only().eccentricity

    @property
    def heel(self) -> Literal["O", "O'"]:
        """The corner that the classical checks call the heel."""
        return self._only().heel

    @property
    def P(self) -> float:
        """Horizontal force, towards the heel, N/m."""
        return self._only().P

    @property
    def M_p(self) -> float:
        """Its moment about the base, N m/m."""
        return self._only().M_p

    @property
    def U(self) -> float:
        """Uplift, N/m."""
        return self._only().U

    @property
    def M_U(self) -> float:
        """Its moment about the heel, N m/m."""
        return self._only().M_U

    @property
    def buoyant_weight(self) -> float:
        """W', weight less buoyancy, N/m."""
        return self._only().buoyant_weight

    @property
    def weight_arm(self) -> float:
        """t, its arm to the heel, m."""
        return self._only().weight_arm

    @property
    def k_eff(self) -> float | None:
        """k of the load in the report's diagram, where it has a point there."""
        return self._only().k_eff

    @property
    def k_prime_eff(self) -> float | None:
        """k' of the load in the report's diagram."""
        return self._only().k_prime_eff

    @property
    def ground(self) -> Ground | None:
        """What the base bears; None where the case has no [ground], and it bears everything. On one that crushes or fails, mode,
        motion, departure and path are those of it."""
        return self._only().ground

    @property
    def mode_words(self) -> str | None:
        """The mode as a predicate of the body."""
        return self._only().mode_words

    @property
    def because(self) -> list[Relation]:
        """The inequalities that decide the mode: the report's where the load has a point in its diagram, otherwise the conditions
        of the contact problem."""
        return self._only().because

    @property
    def motion(self) -> Motion | None:
        """The motion in that mode, in m/s², rad/s², N/m and m; in an earthquake the accelerations are relative to the base."""
        return self._only().motion

    @property
    def wrench(self) -> Wrench:
        """All loads."""
        return self._only().wrench

    @property
    def components(self) -> list[Component]:
        """The loads one by one."""
        return self._only().components

    @property
    def path(self) -> list[Stage]:
        """The modes as the variable loads rise from zero; empty where all are permanent."""
        return self._only().path

    @property
    def report(self) -> Report | None:
        """The load in the report's diagram, which is that of a rigid base; None where ``no_report`` says why."""
        return self._only().report

    @property
    def no_report(self) -> Literal["no-point", "base-gives-way"] | None:
        """Why there is no ``report``: the load has no point in the report's diagram, or the base crushes or the ground fails;
        None where there is one."""
        return self._only().no_report
