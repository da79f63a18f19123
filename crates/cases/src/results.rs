//! The one list of results: a key of the JSON, a column of a table, a target and a criterion are the same thing under the same
//! name in the same unit.
//!
//! Numbers are SI. A result that does not exist (a safety factor of a lifted body, the load factor of a departure that never
//! comes) is [`Nothing`](ResultValue::Nothing), and nothing else is; a number without bound is infinite.

use serde::{Serialize, Serializer};
use standfast::{Bearing, Departure, Margins, Mode, Modes, Response};

use crate::assess::{Assessed, checks};
use crate::list::listed;
use crate::units::Dimension;

/// The value of a result.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum ResultValue {
    /// In SI units, or without unit; it may be infinite.
    Number(f64),
    /// One of a few words.
    Word(&'static str),
    /// true or false.
    Truth(bool),
    /// A set of modes.
    Modes(Modes),
    /// There is no such thing.
    Nothing,
}

impl Serialize for ResultValue {
    /// An infinite number, which JSON lacks, as the word `infinite`.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            ResultValue::Number(number) => number_or_word(number, serializer),
            ResultValue::Word(word) => serializer.serialize_str(word),
            ResultValue::Truth(truth) => serializer.serialize_bool(*truth),
            ResultValue::Modes(modes) => modes.serialize(serializer),
            ResultValue::Nothing => serializer.serialize_none(),
        }
    }
}

/// A number, or the word `infinite`.
pub(crate) fn number_or_word<S: Serializer>(number: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    match *number {
        f64::INFINITY => serializer.serialize_str("infinite"),
        number => serializer.serialize_f64(number),
    }
}

/// What a result's values are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ResultKind {
    /// Numbers; `None` for those without unit.
    Number(Option<Dimension>),
    /// One of these words.
    Word(&'static [&'static str]),
    /// true or false.
    Truth,
    /// A set of modes.
    Modes,
}

/// Everything that is said of a result.
#[derive(Clone, Copy)]
pub struct ResultInfo {
    /// Its name.
    pub name: &'static str,
    /// What its values are.
    pub kind: ResultKind,
    /// What it is, in words.
    pub words: &'static str,
    of: fn(&Assessed) -> ResultValue,
}

const SYMBOLS: [&str; 10] = ["RE", "SL", "RO", "SRO-", "SRO+", "SRO'-", "RO'", "SL+", "SRO'+", "FL"];

const fn number(
    name: &'static str,
    dimension: Option<Dimension>,
    words: &'static str,
    of: fn(&Assessed) -> ResultValue,
) -> ResultInfo {
    ResultInfo { name, kind: ResultKind::Number(dimension), words, of }
}

const fn word(
    name: &'static str,
    choices: &'static [&'static str],
    words: &'static str,
    of: fn(&Assessed) -> ResultValue,
) -> ResultInfo {
    ResultInfo { name, kind: ResultKind::Word(choices), words, of }
}

listed! {
    /// A result of a situation.
    ResultName: ResultInfo;

    Mode = word("mode", &SYMBOLS, "the mode under the full load, applied at once", |a| mode(a.outcome.full.mode));
    Unique = ResultInfo {
        name: "unique",
        kind: ResultKind::Truth,
        words: "whether no other mode is consistent under the full load",
        of: |a| ResultValue::Truth(a.outcome.full.is_unique()),
    };
    Also = ResultInfo {
        name: "also",
        kind: ResultKind::Modes,
        words: "the other consistent modes",
        of: |a| ResultValue::Modes(a.outcome.full.others()),
    };
    Lifted = ResultInfo {
        name: "lifted",
        kind: ResultKind::Truth,
        words: "whether nothing presses the body on its base under the full load; safety factors then mean nothing",
        of: |a| ResultValue::Truth(a.outcome.full.is_lifted()),
    };
    Departure = word("departure", &["never", "at-once", "at"],
        "whether the body leaves rest as the variable loads rise: for no load factor above zero, at once, or at `load_factor`",
        |a| ResultValue::Word(departure(&a.outcome.departure)));
    LoadFactor = number("load_factor", None, "where it leaves rest, as a multiple of the variable loads; only where `departure` is `at`",
        |a| match a.outcome.departure {
            Departure::At { factor, .. } => ResultValue::Number(factor),
            Departure::Never | Departure::AtOnce { .. } => ResultValue::Nothing,
        });
    DepartureMode = word("departure_mode", &SYMBOLS, "the mode in which it leaves rest", |a| mode(a.outcome.departure.mode()));
    DepartureBy = word("departure_by", &["permanent-loads", "any-share"],
        "what moves a body that departs at once: its permanent loads alone, or any share of the variable ones, however small",
        |a| match a.outcome.departure {
            Departure::AtOnce { permanent: true, .. } => ResultValue::Word("permanent-loads"),
            Departure::AtOnce { permanent: false, .. } => ResultValue::Word("any-share"),
            Departure::Never | Departure::At { .. } => ResultValue::Nothing,
        });

    SfSliding = number("SF_sliding", None, "safety factor against sliding, μ(W' − U)/P", |a| factor(&a.outcome.full, a.outcome.stability.sliding));
    SfOverturning = number("SF_overturning", None, "safety factor against overturning, the lesser of both corners",
        |a| factor(&a.outcome.full, a.outcome.stability.overturning()));
    SfOverturningHeel = number("SF_overturning_heel", None, "the same about the heel, (W' t − M_U)/M_p",
        |a| factor(&a.outcome.full, a.outcome.stability.overturning_about_heel));
    SfOverturningToe = number("SF_overturning_toe", None, "the same about the toe, (W'(B_c − t) − U B_c + M_U)/(−M_p)",
        |a| factor(&a.outcome.full, a.outcome.stability.overturning_about_toe));
    SfOverturningGross = number("SF_overturning_gross", None,
        "safety factor against overturning by gross moments, (W' t + M_s)/(M_s + M_U + M_p) about the heel, the lesser of both corners: the whole weight against all water under the base and P",
        |a| factor(&a.outcome.full, a.outcome.gross.overturning()));

    MarginSliding = number("margin_sliding", Some(Dimension::Force),
        "what friction leaves of the horizontal force, μ(W' − U) − P: negative where the body cannot rest for want of friction, and where it is lifted",
        |a| ResultValue::Number(margins(a).sliding));
    MarginOverturning = number("margin_overturning", Some(Dimension::Moment),
        "the lesser of both corners' moments that press the body on its base: negative where the resultant misses the base, and where the body is lifted; with `margin_sliding` not negative, the body can rest",
        |a| ResultValue::Number(margins(a).overturning()));
    MarginOverturningHeel = number("margin_overturning_heel", Some(Dimension::Moment), "the same about the heel, W' t − M_U − M_p",
        |a| ResultValue::Number(margins(a).overturning_about_heel));
    MarginOverturningToe = number("margin_overturning_toe", Some(Dimension::Moment),
        "the same about the toe, W'(B_c − t) − U B_c + M_U + M_p",
        |a| ResultValue::Number(margins(a).overturning_about_toe));

    Bearing = word("bearing", &["pressed", "outside-base", "lifted"],
        "whether the base can carry the resultant: it does, the resultant misses the base, or nothing presses",
        |a| ResultValue::Word(match a.outcome.stability.bearing {
            Bearing::Pressed { .. } => "pressed",
            Bearing::Lifted => "lifted",
            _ => "outside-base",
        }));
    HeelPressure = number("heel_pressure", Some(Dimension::Pressure), "bearing pressure at the heel", |a| pressed(a, |heel, _, _| heel));
    ToePressure = number("toe_pressure", Some(Dimension::Pressure), "bearing pressure at the toe", |a| pressed(a, |_, toe, _| toe));
    BearingMax = number("bearing_max", Some(Dimension::Pressure), "the larger of both", |a| pressed(a, |heel, toe, _| heel.max(toe)));
    ContactLength = number("contact_length", Some(Dimension::Length), "the length of the base that is pressed",
        |a| pressed(a, |_, _, contact| contact));
    ContactShare = number("contact_share", None, "the share of the base's area that is pressed", |a| {
        match a.outcome.stability.bearing {
            Bearing::Pressed { share, .. } => ResultValue::Number(share),
            _ => ResultValue::Nothing,
        }
    });
    ResultantArm = number("resultant_arm", Some(Dimension::Length), "t_e, distance of the resultant from the heel",
        |a| a.outcome.stability.resultant_arm.map_or(ResultValue::Nothing, ResultValue::Number));

    Eccentricity = number("eccentricity", Some(Dimension::Length), "distance of the resultant from the middle of the base, where it meets the base",
        |a| pressed(a, |_, _, _| a.outcome.stability.eccentricity(a.situation.body().base_width()).unwrap_or_default()));

    Heel = word("heel", &["O", "O'"], "the corner that the classical checks call the heel",
        |a| ResultValue::Word(checks::corner(a.outcome.actions.heel)));
    P = number("P", Some(Dimension::Force), "horizontal force, towards the heel", |a| ResultValue::Number(a.outcome.actions.force));
    Mp = number("M_p", Some(Dimension::Moment), "its moment about the base", |a| ResultValue::Number(a.outcome.actions.force_moment));
    U = number("U", Some(Dimension::Force), "uplift", |a| ResultValue::Number(a.outcome.actions.uplift));
    Mu = number("M_U", Some(Dimension::Moment), "its moment about the heel", |a| ResultValue::Number(a.outcome.actions.uplift_moment));
    BuoyantWeight = number("buoyant_weight", Some(Dimension::Force), "W', weight less buoyancy",
        |a| ResultValue::Number(a.outcome.actions.buoyant_weight));
    WeightArm = number("weight_arm", Some(Dimension::Length), "t, its arm to the heel", |a| ResultValue::Number(a.outcome.actions.weight_arm));

    KEff = number("k_eff", None, "k of the load in the report's diagram, where it has a point there",
        |a| a.outcome.full.effective.map_or(ResultValue::Nothing, |reduced| ResultValue::Number(reduced.point.k())));
    KPrimeEff = number("k_prime_eff", None, "k' of the load in the report's diagram",
        |a| a.outcome.full.effective.map_or(ResultValue::Nothing, |reduced| ResultValue::Number(reduced.point.k_prime())));
}

impl ResultName {
    /// Its name.
    pub fn name(self) -> &'static str {
        self.info().name
    }

    /// Its value for a situation.
    pub fn of(self, assessed: &Assessed) -> ResultValue {
        (self.info().of)(assessed)
    }

    /// The result of a name.
    pub fn find(name: &str) -> Option<ResultName> {
        ResultName::ALL.iter().copied().find(|result| result.name() == name)
    }
}

fn mode(mode: Option<Mode>) -> ResultValue {
    mode.map_or(ResultValue::Nothing, |mode| ResultValue::Word(mode.symbol()))
}

/// Whether a body leaves rest, in a word.
fn departure(departure: &Departure) -> &'static str {
    match departure {
        Departure::Never => "never",
        Departure::AtOnce { .. } => "at-once",
        Departure::At { .. } => "at",
    }
}

/// A safety factor; one of a lifted body means nothing.
fn factor(full: &Response, factor: f64) -> ResultValue {
    if full.is_lifted() { ResultValue::Nothing } else { ResultValue::Number(factor) }
}

/// What the inequalities of rest leave under the full load.
fn margins(assessed: &Assessed) -> Margins {
    let situation = &assessed.situation;
    assessed.outcome.actions.margins(situation.static_friction(), situation.body())
}

fn pressed(assessed: &Assessed, of: impl Fn(f64, f64, f64) -> f64) -> ResultValue {
    match assessed.outcome.stability.bearing {
        Bearing::Pressed { heel, toe, contact, .. } => ResultValue::Number(of(heel, toe, contact)),
        _ => ResultValue::Nothing,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_unique_and_symbols_those_of_the_modes() {
        for &result in ResultName::ALL {
            assert_eq!(ResultName::find(result.name()), Some(result));
        }
        assert_eq!(SYMBOLS, Mode::ALL.map(Mode::symbol));
    }
}
