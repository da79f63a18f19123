"""The parts of an answer in probabilities: classes with a property for each key of the JSON document that
``docs/probability.schema.json`` describes. ``None`` says that there is no such thing.
"""

# Made by python/make_designs.py; changes go into the schemas.
# mypy: disable-error-code="no-any-return"

from __future__ import annotations

from typing import Literal

from ._answer import Answer, ByMode, by_mode, part, parts

__all__ = [
    "Along",
    "AtPeak",
    "Chance",
    "ChanceCriterion",
    "Chances",
    "DesignPoint",
    "Exceeded",
    "FirstDeparture",
    "Fit",
    "Followed",
    "Fragility",
    "Importance",
    "Interval",
    "Joined",
    "Life",
    "Overturning",
    "ProbabilityDocument",
    "Quantile",
    "Random",
    "Rotating",
    "Sliding",
]


class Random(Answer):
    """a random number."""

    @property
    def name(self) -> str:
        """Its name, as in the case."""
        return self._document["name"]

    @property
    def cut(self) -> float:
        """The share of its law that is cut away because no body has such values."""
        return self._document["cut"]


class Interval(Answer):
    """a probability with its interval."""

    @property
    def probability(self) -> float:
        """The probability."""
        return self._document["probability"]

    @property
    def low(self) -> float:
        """The lower end of its interval: 95 %, or of an integration its error."""
        return self._document["low"]

    @property
    def high(self) -> float:
        """The upper end."""
        return self._document["high"]


class Chance(Answer):
    """How likely a mode is."""

    @property
    def mode(self) -> str:
        """a mode by its symbol; "BF" where the ground fails, of a base that gives way alone; "no mode" where none satisfies every
        law; "not a body" where the numbers drawn do not go together."""
        return self._document["mode"]

    @property
    def probability(self) -> float:
        """The probability."""
        return self._document["probability"]

    @property
    def low(self) -> float:
        """The lower end of its interval: 95 %, or of an integration its error."""
        return self._document["low"]

    @property
    def high(self) -> float:
        """The upper end."""
        return self._document["high"]


class Importance(Answer):
    """How much a random number matters."""

    @property
    def name(self) -> str:
        """Its name, as in the case."""
        return self._document["name"]

    @property
    def alpha(self) -> float | None:
        """The direction cosine of the design point; None where there is none."""
        return self._document["alpha"]

    @property
    def alpha2(self) -> float | None:
        """Its square."""
        return self._document["alpha2"]

    @property
    def omission(self) -> float | None:
        """By what β grows if the number is held at its median, 1/√(1 − α²); None where α² is 1 or there is no design point."""
        return self._document["omission"]

    @property
    def probability_if_known(self) -> float | None:
        """The probability that the body does not rest if the number is known to have its median; None where it is the only random
        one."""
        return self._document["probability_if_known"]

    @property
    def if_known_low(self) -> float | None:
        """The lower end of its interval."""
        return self._document["if_known_low"]

    @property
    def if_known_high(self) -> float | None:
        """The upper end; a bound where nothing was met."""
        return self._document["if_known_high"]


class DesignPoint(Answer):
    """Where a mode is nearest to the medians of all random numbers, by FORM."""

    @property
    def mode(self) -> str:
        """a mode by its symbol; "BF", "no mode" or "not a body"."""
        return self._document["mode"]

    @property
    def beta(self) -> float:
        """The distance in standard normals; 0 where the medians themselves have the mode."""
        return self._document["beta"]

    @property
    def first_order(self) -> float:
        """Φ(−β), which is no probability of the mode."""
        return self._document["first_order"]

    @property
    def point(self) -> dict[str, float]:
        """The random numbers there, by name."""
        return dict(self._document["point"])

    @property
    def alpha(self) -> dict[str, float]:
        """The direction cosines, by name."""
        return dict(self._document["alpha"])

    @property
    def at_change_of_formula(self) -> bool:
        """Whether it lies where a formula or a mode changes."""
        return self._document["at_change_of_formula"]

    @property
    def agreeing(self) -> int:
        """How many starts led there."""
        return self._document["agreeing"]

    @property
    def starts(self) -> int:
        """How many there were."""
        return self._document["starts"]


class FirstDeparture(Answer):
    """Into which mode the body first leaves rest; the parts add up to one."""

    @property
    def modes(self) -> ByMode[Chance]:
        """The modes, "no mode" and "not a body"."""
        return by_mode(Chance, self._document["modes"])

    @property
    def never(self) -> Interval:
        """That it rests under any multiple of the variable loads."""
        return part(Interval, self._document["never"])

    @property
    def at_once(self) -> Interval:
        """That the permanent loads alone, or any share of the others, move it."""
        return part(Interval, self._document["at_once"])

    @property
    def precise(self) -> bool:
        """Whether every probability above the floor is as precise as asked."""
        return self._document["precise"]


class Life(Answer):
    """What happens at least once in the years of a life."""

    @property
    def years(self) -> float:
        """The years."""
        return self._document["years"]

    @property
    def method(self) -> Literal["integrate", "sobol"]:
        """Whether years are integrated, or drawn."""
        return self._document["method"]

    @property
    def precise(self) -> bool:
        """Whether every probability above the floor is as precise as asked."""
        return self._document["precise"]

    @property
    def not_rest(self) -> Interval:
        """That the body ever leaves rest."""
        return part(Interval, self._document["not_rest"])

    @property
    def modes(self) -> ByMode[Chance]:
        """Each mode, at least once."""
        return by_mode(Chance, self._document["modes"])


class Quantile(Answer):
    """a slide that a share of all lives stays below."""

    @property
    def share(self) -> float:
        """The share."""
        return self._document["share"]

    @property
    def slide(self) -> float:
        """The slide."""
        return self._document["slide"]

    @property
    def low(self) -> float:
        """The lower end of its interval, 95 %."""
        return self._document["low"]

    @property
    def high(self) -> float:
        """The upper end."""
        return self._document["high"]


class Exceeded(Answer):
    """How likely a life slides the body by more than a value."""

    @property
    def slide(self) -> float:
        """The value."""
        return self._document["slide"]

    @property
    def probability(self) -> float:
        """The probability."""
        return self._document["probability"]

    @property
    def low(self) -> float:
        """The lower end of its interval, 95 %."""
        return self._document["low"]

    @property
    def high(self) -> float:
        """The upper end."""
        return self._document["high"]


class AtPeak(Answer):
    """What becomes of the bodies at one peak; intervals are those of a further record and body, of one record those of a further
    body."""

    @property
    def peak(self) -> float:
        """The largest acceleration of the base to the sides, in m/s²."""
        return self._document["peak"]

    @property
    def moved(self) -> Interval:
        """That the body slips or turns at all."""
        return part(Interval, self._document["moved"])

    @property
    def rocked(self) -> Interval:
        """That it turns."""
        return part(Interval, self._document["rocked"])

    @property
    def overturned(self) -> Interval:
        """That it overturns."""
        return part(Interval, self._document["overturned"])


class Followed(Answer):
    """Waves that begin a rotation, followed in time in the lives that are drawn; chances and shares of slides count them, the
    mean does not."""

    @property
    def slide(self) -> float:
        """The mean slide that they add to a life, in m."""
        return self._document["slide"]

    @property
    def slide_low(self) -> float:
        """The lower end of its interval, 95 %."""
        return self._document["slide_low"]

    @property
    def slide_high(self) -> float:
        """The upper end."""
        return self._document["slide_high"]

    @property
    def overturned(self) -> Interval:
        """That a life ends by overturning."""
        return part(Interval, self._document["overturned"])


class Rotating(Answer):
    """Waves that begin a rotation."""

    @property
    def wave(self) -> Interval:
        """That a wave of any storm is one."""
        return part(Interval, self._document["wave"])

    @property
    def life(self) -> Interval:
        """That a life has one."""
        return part(Interval, self._document["life"])


class Sliding(Answer):
    """Slides over a life of storms, in m."""

    @property
    def years(self) -> float:
        """The years, each with a storm."""
        return self._document["years"]

    @property
    def waves(self) -> int:
        """The waves of a storm."""
        return self._document["waves"]

    @property
    def pulse(self) -> Literal["triangle", "shimosako"]:
        """How the slide of a wave is found: exactly for a triangular pulse, or by the published formula."""
        return self._document["pulse"]

    @property
    def lives(self) -> int:
        """How many lives are drawn."""
        return self._document["lives"]

    @property
    def mean(self) -> float:
        """The mean over lives, integrated."""
        return self._document["mean"]

    @property
    def mean_low(self) -> float:
        """The lower end of its interval, 95 %."""
        return self._document["mean_low"]

    @property
    def mean_high(self) -> float:
        """The upper end."""
        return self._document["mean_high"]

    @property
    def precise(self) -> bool:
        """Whether the mean is as precise as it is asked to be."""
        return self._document["precise"]

    @property
    def sliding_waves(self) -> float:
        """How many waves of a life slide the body on average."""
        return self._document["sliding_waves"]

    @property
    def ever(self) -> Interval:
        """That any wave of a life slides it."""
        return part(Interval, self._document["ever"])

    @property
    def quantiles(self) -> list[Quantile]:
        """The slides that shares of all lives stay below."""
        return parts(Quantile, self._document["quantiles"])

    @property
    def exceedance(self) -> list[Exceeded]:
        """How likely a life slides it by more than a value."""
        return parts(Exceeded, self._document["exceedance"])

    @property
    def of_worst_twentieth(self) -> float:
        """The share of the mean that comes of the worst 5 % of all lives."""
        return self._document["of_worst_twentieth"]

    @property
    def rotating(self) -> Rotating:
        """Waves that begin a rotation, which the slides leave out unless they are followed in time."""
        return part(Rotating, self._document["rotating"])

    @property
    def followed(self) -> Followed | None:
        """What comes of them, where they are followed in time; None where they are counted."""
        return None if self._document["followed"] is None else part(Followed, self._document["followed"])


class Joined(Answer):
    """Several sets of loads, or accelerations of the base, joined."""

    @property
    def count(self) -> int:
        """How many there are."""
        return self._document["count"]

    @property
    def method(self) -> Literal["integrate", "sobol", "importance", "monte-carlo"]:
        """How it is found."""
        return self._document["method"]

    @property
    def not_rest(self) -> Interval:
        """That the body does not stay at rest under one of them at least."""
        return part(Interval, self._document["not_rest"])


class ChanceCriterion(Answer):
    """What is asked of the probability that the body does not stay at rest: under the worst set of loads, the accelerations of
    the base joined."""

    @property
    def name(self) -> Literal['p_not_rest']:
        """Its name."""
        return self._document["name"]

    @property
    def required(self) -> float:
        """The greatest that is allowed."""
        return self._document["required"]

    @property
    def value(self) -> float:
        """The upper end of the interval."""
        return self._document["value"]

    @property
    def met(self) -> bool:
        """Whether it is met."""
        return self._document["met"]


class Along(Answer):
    """The probabilities at one value."""

    @property
    def value(self) -> float:
        """The value, in SI units."""
        return self._document["value"]

    @property
    def not_rest(self) -> Interval:
        """That the body does not stay at rest."""
        return part(Interval, self._document["not_rest"])

    @property
    def modes(self) -> ByMode[Chance]:
        """The modes, "no mode" and "not a body", which add up to one."""
        return by_mode(Chance, self._document["modes"])


class Fit(Answer):
    """a lognormal curve Φ(ln(value/median)/dispersion), the likeliest."""

    @property
    def median(self) -> float:
        """Its median, in SI units."""
        return self._document["median"]

    @property
    def dispersion(self) -> float:
        """Its logarithmic standard deviation."""
        return self._document["dispersion"]

    @property
    def misfit(self) -> float:
        """The largest difference from the probabilities."""
        return self._document["misfit"]


class Overturning(Answer):
    """Random bodies followed in time under records scaled to each peak."""

    @property
    def records(self) -> list[str]:
        """The records, each of every body."""
        return list(self._document["records"])

    @property
    def bodies(self) -> int:
        """How many bodies are drawn, each followed under every record."""
        return self._document["bodies"]

    @property
    def not_a_body(self) -> int:
        """Draws whose numbers do not go together, counted as standing."""
        return self._document["not_a_body"]

    @property
    def points(self) -> list[AtPeak]:
        """The peaks, rising."""
        return parts(AtPeak, self._document["points"])

    @property
    def fit(self) -> Fit | None:
        """a lognormal curve through the chances of overturning; None where they do not rise or there are too few."""
        return None if self._document["fit"] is None else part(Fit, self._document["fit"])


class Fragility(Answer):
    """The probabilities along a number of the case, under the least safe set of loads for each value."""

    @property
    def name(self) -> str:
        """The number's name."""
        return self._document["name"]

    @property
    def points(self) -> list[Along]:
        """Its values, in order."""
        return parts(Along, self._document["points"])

    @property
    def fit(self) -> Fit | None:
        """a lognormal curve through the probabilities that the body does not rest; None where they do not rise or there are too
        few."""
        return None if self._document["fit"] is None else part(Fit, self._document["fit"])


class Chances(Answer):
    """The answer under one set of loads."""

    @property
    def situation(self) -> str | None:
        """Which loads act, and how the base is shaken; None where the case leaves no choice."""
        return self._document["situation"]

    @property
    def method(self) -> Literal["integrate", "sobol", "importance", "monte-carlo"]:
        """How they are found: integrated; by scrambled Sobol' points; by such points about the design points; by plain Monte
        Carlo."""
        return self._document["method"]

    @property
    def points(self) -> int:
        """How many points are drawn; of an integration, how often the modes are asked for."""
        return self._document["points"]

    @property
    def precise(self) -> bool:
        """Whether every probability above the floor is as precise as asked."""
        return self._document["precise"]

    @property
    def modes(self) -> ByMode[Chance]:
        """What the body does: the modes, "no mode" and "not a body", which add up to one."""
        return by_mode(Chance, self._document["modes"])

    @property
    def not_rest(self) -> Interval:
        """That the body does not stay at rest."""
        return part(Interval, self._document["not_rest"])

    @property
    def not_unique(self) -> Interval:
        """That more than one mode satisfies every law."""
        return part(Interval, self._document["not_unique"])

    @property
    def lifted(self) -> Interval:
        """That nothing presses the body on its base; part of the modes."""
        return part(Interval, self._document["lifted"])

    @property
    def first_departure(self) -> FirstDeparture:
        """Into which mode it first leaves rest as the variable loads rise without end."""
        return part(FirstDeparture, self._document["first_departure"])

    @property
    def beta(self) -> float | None:
        """The distance of the nearest point at which the body does not rest, in standard normals; negative where it moves at the
        medians: then minus that of the nearest point at which it rests; None where none is within reach. Not to be turned into a
        probability."""
        return self._document["beta"]

    @property
    def beta_generalized(self) -> float | None:
        """−Φ⁻¹ of the probability that the body does not rest; None where that is 0 or 1."""
        return self._document["beta_generalized"]

    @property
    def design_point(self) -> dict[str, float] | None:
        """The values of the random numbers at the nearest point at which the body does not rest, in SI units, by their names;
        None where none is within reach."""
        return None if self._document["design_point"] is None else dict(self._document["design_point"])

    @property
    def at_change_of_formula(self) -> bool | None:
        """Whether that point lies where one formula takes another's place, so that the limit state has a kink; None where there
        is no such point."""
        return self._document["at_change_of_formula"]

    @property
    def importance(self) -> list[Importance]:
        """Which random number matters, in the order of the case."""
        return parts(Importance, self._document["importance"])

    @property
    def design_points(self) -> ByMode[DesignPoint] | None:
        """The nearest point of every mode within reach, but of rest; None unless asked for by the method form."""
        return None if self._document["design_points"] is None else by_mode(DesignPoint, self._document["design_points"])

    @property
    def life(self) -> Life | None:
        """Over a life; None where no years are given."""
        return None if self._document["life"] is None else part(Life, self._document["life"])


class ProbabilityDocument(Answer):
    """What ``probability`` answers."""

    @property
    def schema(self) -> Literal[1]:
        """The version of the document."""
        return self._document["schema"]

    @property
    def case(self) -> str:
        """The name of the case file."""
        return self._document["case"]

    @property
    def seed(self) -> int:
        """The seed of all random numbers."""
        return self._document["seed"]

    @property
    def random(self) -> list[Random]:
        """What is random, in the order of the case."""
        return parts(Random, self._document["random"])

    @property
    def integrated(self) -> str:
        """The random number that is integrated rather than drawn."""
        return self._document["integrated"]

    @property
    def situation(self) -> str | None:
        """Which loads act, and how the base is shaken; None where the case leaves no choice."""
        return self._document["situation"]

    @property
    def method(self) -> Literal["integrate", "sobol", "importance", "monte-carlo"]:
        """How they are found: integrated; by scrambled Sobol' points; by such points about the design points; by plain Monte
        Carlo."""
        return self._document["method"]

    @property
    def points(self) -> int:
        """How many points are drawn; of an integration, how often the modes are asked for."""
        return self._document["points"]

    @property
    def precise(self) -> bool:
        """Whether every probability above the floor is as precise as asked."""
        return self._document["precise"]

    @property
    def modes(self) -> ByMode[Chance]:
        """What the body does: the modes, "no mode" and "not a body", which add up to one."""
        return by_mode(Chance, self._document["modes"])

    @property
    def not_rest(self) -> Interval:
        """That the body does not stay at rest."""
        return part(Interval, self._document["not_rest"])

    @property
    def not_unique(self) -> Interval:
        """That more than one mode satisfies every law."""
        return part(Interval, self._document["not_unique"])

    @property
    def lifted(self) -> Interval:
        """That nothing presses the body on its base; part of the modes."""
        return part(Interval, self._document["lifted"])

    @property
    def first_departure(self) -> FirstDeparture:
        """Into which mode it first leaves rest as the variable loads rise without end."""
        return part(FirstDeparture, self._document["first_departure"])

    @property
    def beta(self) -> float | None:
        """The distance of the nearest point at which the body does not rest, in standard normals; negative where it moves at the
        medians: then minus that of the nearest point at which it rests; None where none is within reach. Not to be turned into a
        probability."""
        return self._document["beta"]

    @property
    def beta_generalized(self) -> float | None:
        """−Φ⁻¹ of the probability that the body does not rest; None where that is 0 or 1."""
        return self._document["beta_generalized"]

    @property
    def design_point(self) -> dict[str, float] | None:
        """The values of the random numbers at the nearest point at which the body does not rest, in SI units, by their names;
        None where none is within reach."""
        return None if self._document["design_point"] is None else dict(self._document["design_point"])

    @property
    def at_change_of_formula(self) -> bool | None:
        """Whether that point lies where one formula takes another's place, so that the limit state has a kink; None where there
        is no such point."""
        return self._document["at_change_of_formula"]

    @property
    def importance(self) -> list[Importance]:
        """Which random number matters, in the order of the case."""
        return parts(Importance, self._document["importance"])

    @property
    def design_points(self) -> ByMode[DesignPoint] | None:
        """The nearest point of every mode within reach, but of rest; None unless asked for by the method form."""
        return None if self._document["design_points"] is None else by_mode(DesignPoint, self._document["design_points"])

    @property
    def life(self) -> Life | None:
        """Over a life; None where no years are given."""
        return None if self._document["life"] is None else part(Life, self._document["life"])

    @property
    def others(self) -> list[Chances]:
        """The answers under the other sets of loads."""
        return parts(Chances, self._document["others"])

    @property
    def joined(self) -> Joined | None:
        """That any of several sets of loads moves the body, all with the same numbers drawn; None where there is only one."""
        return None if self._document["joined"] is None else part(Joined, self._document["joined"])

    @property
    def criterion(self) -> ChanceCriterion | None:
        """What [criteria] asks of the probability; None where it asks for none."""
        return None if self._document["criterion"] is None else part(ChanceCriterion, self._document["criterion"])

    @property
    def sliding(self) -> Sliding | None:
        """How far storms slide the body over a life; None of a case without storms."""
        return None if self._document["sliding"] is None else part(Sliding, self._document["sliding"])

    @property
    def overturning(self) -> Overturning | None:
        """Overturning in time over the peak of a shaking; None where it is not asked for."""
        return None if self._document["overturning"] is None else part(Overturning, self._document["overturning"])

    @property
    def fragility(self) -> Fragility | None:
        """The probabilities along a number of the case; None where none is asked for."""
        return None if self._document["fragility"] is None else part(Fragility, self._document["fragility"])
