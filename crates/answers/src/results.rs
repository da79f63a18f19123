//! The one list of results: a key of the JSON, a column of a table, a target and a criterion are the same thing under the same
//! name in the same unit.
//!
//! Numbers are SI. A result that does not exist (a safety factor of a lifted body, the load factor of a departure that never
//! comes) is [`Nothing`](ResultValue::Nothing), and nothing else is; a number without bound is infinite.

use serde::{Serialize, Serializer};
use standfast::ground::bearing::{LoadFactors, Reaction};
use standfast::ground::impact::{ImpactEvent, ImpactResponse};
use standfast::wave::Goda;
use standfast::{Bearing, Departure, Margins, Modes, Response, Verdict};

use crate::assess::Assessed;
use crate::assess::ground::{BaseResponse, Elastic};
use crate::directions::{DirectionAnswer, SituationDirections};
use crate::units::Dimension;
use standfast_inputs::listed;
use standfast_model::{Criterion, Key};

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
pub fn number_or_word<S: Serializer>(number: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    match *number {
        f64::INFINITY => serializer.serialize_str("infinite"),
        number => serializer.serialize_f64(number),
    }
}

/// Kind of the values of a result.
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
    /// Names with blanks between them.
    Names,
}

/// Everything that is said of a result.
#[derive(Clone, Copy)]
pub struct ResultInfo {
    /// Its name.
    pub name: &'static str,
    /// Kind of its values.
    pub kind: ResultKind,
    /// Its meaning, in words.
    pub words: &'static str,
    of: fn(&Assessed) -> ResultValue,
}

const SYMBOLS: [&str; 11] = ["RE", "SL", "RO", "SRO-", "SRO+", "SRO'-", "RO'", "SL+", "SRO'+", "FL", "BF"];

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

    Mode = word("mode", &SYMBOLS, "the mode under the full load, applied at once; BF where the ground fails", |a| verdict(a.verdict().filter(|_| a.joints.is_none() && a.outcome.plan.is_none())));
    Unique = ResultInfo {
        name: "unique",
        kind: ResultKind::Truth,
        words: "whether no other mode, or combination of the modes of joints, is consistent under the full load",
        of: |a| a.is_unique().map_or(ResultValue::Nothing, ResultValue::Truth),
    };
    Also = ResultInfo {
        name: "also",
        kind: ResultKind::Modes,
        words: "the other consistent modes",
        of: |a| ResultValue::Modes(if a.joints.is_some() { Modes::default() } else { a.outcome.full.others() }),
    };
    Lifted = ResultInfo {
        name: "lifted",
        kind: ResultKind::Truth,
        words: "whether nothing presses the body on its base under the full load; safety factors then mean nothing",
        of: |a| ResultValue::Truth(a.outcome.full.is_lifted()),
    };
    Departure = word("departure", &["never", "at-once", "at"],
        "whether the body leaves rest as the variable loads rise: for no load factor above zero, at once, or at `load_factor`",
        |a| ResultName::departure_of(&a.departure()));
    LoadFactor = number("load_factor", None, "where it leaves rest, as a multiple of the variable loads; only where `departure` is `at`",
        |a| ResultName::load_factor_of(&a.departure()));
    DepartureMode = word("departure_mode", &SYMBOLS, "the mode in which it leaves rest; BF where the ground fails", |a| verdict(a.departure().verdict()));
    DepartureBy = word("departure_by", &["permanent-loads", "any-share"],
        "what moves a body that departs at once: its permanent loads alone, or any share of the variable ones, however small",
        |a| ResultName::departure_by_of(&a.departure()));

    SfSliding = number("SF_sliding", None, "safety factor against sliding, μ(W' − U)/P", |a| factor(&a.outcome.full, a.outcome.stability.sliding));
    SfOverturningNet = number("SF_overturning_net", None, "net safety factor against overturning, water under the base taken off the weight; the lesser of both corners",
        |a| factor(&a.outcome.full, a.outcome.stability.overturning()));
    SfOverturningHeel = number("SF_overturning_heel", None, "the same about the heel, (W' t − M_U)/M_p",
        |a| in_plane(a, factor(&a.outcome.full, a.outcome.stability.overturning_about_heel)));
    SfOverturningToe = number("SF_overturning_toe", None, "the same about the toe, (W'(B_c − t) − U B_c + M_U)/(−M_p)",
        |a| in_plane(a, factor(&a.outcome.full, a.outcome.stability.overturning_about_toe)));
    SfOverturningGross = number("SF_overturning_gross", None,
        "safety factor against overturning by gross moments, (W' t + M_s)/(M_s + M_U + M_p) about the heel, the lesser of both corners: the whole weight against all water under the base and P",
        |a| in_plane(a, factor(&a.outcome.full, a.outcome.gross.overturning())));

    SfUplift = number("SF_uplift", None,
        "safety factor against uplift: all that acts down over all that acts up; told where a criterion asks for it, else absent, and not of a `buoyant_weight`",
        |a| perhaps(a.balance().map(|balance| balance.uplift())));
    Tipping = number("tipping", None,
        "moments that tip the body over those that hold it, load by load, a load's push and its vertical part apart; the larger of both corners; told where a criterion asks for it, else absent, and not of a `buoyant_weight`",
        |a| perhaps(a.balance().map(|balance| balance.tipping())));

    MarginSliding = number("margin_sliding", Some(Dimension::Force),
        "what friction leaves of the horizontal force, μ(W' − U) − P: negative where the body cannot rest for want of friction, and where it is lifted",
        |a| ResultValue::Number(margins(a).sliding));
    MarginOverturning = number("margin_overturning", Some(Dimension::Moment),
        "the lesser of both corners' moments that press the body on its base: negative where the resultant misses the base, and where the body is lifted; with `margin_sliding` not negative, the body can rest on a rigid base; `ground_margin` is that of another",
        |a| ResultValue::Number(margins(a).overturning()));
    MarginOverturningHeel = number("margin_overturning_heel", Some(Dimension::Moment), "the same about the heel, W' t − M_U − M_p",
        |a| in_plane(a, ResultValue::Number(margins(a).overturning_about_heel)));
    MarginOverturningToe = number("margin_overturning_toe", Some(Dimension::Moment),
        "the same about the toe, W'(B_c − t) − U B_c + M_U + M_p",
        |a| in_plane(a, ResultValue::Number(margins(a).overturning_about_toe)));

    Bearing = word("bearing", &["pressed", "outside-base", "lifted", "plan"],
        "whether the base can carry the resultant: it does, the resultant misses the base, or nothing presses; `plan` of a base seen from above, of which no pressure is told",
        |a| ResultValue::Word(match a.outcome.stability.bearing {
            Bearing::Pressed { .. } => "pressed",
            Bearing::Lifted => "lifted",
            Bearing::OnPlan => "plan",
            _ => "outside-base",
        }));
    HeelPressure = number("heel_pressure", Some(Dimension::Pressure), "bearing pressure at the heel", |a| pressed(a, |heel, _, _| heel));
    ToePressure = number("toe_pressure", Some(Dimension::Pressure), "bearing pressure at the toe", |a| pressed(a, |_, toe, _| toe));
    BearingMax = number("bearing_max", Some(Dimension::Pressure), "the larger of the bearing pressures at heel and toe", |a| pressed(a, |heel, toe, _| heel.max(toe)));
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
        |a| in_plane(a, ResultValue::Word(a.outcome.actions.heel.letter())));
    P = number("P", Some(Dimension::Force), "horizontal force, towards the heel", |a| ResultValue::Number(a.outcome.plan.as_ref().map_or(a.outcome.actions.force, |plan| plan.full.horizontal())));
    Mp = number("M_p", Some(Dimension::Moment), "its moment about the base", |a| in_plane(a, ResultValue::Number(a.outcome.actions.force_moment)));
    U = number("U", Some(Dimension::Force), "uplift", |a| in_plane(a, ResultValue::Number(a.outcome.actions.uplift)));
    Mu = number("M_U", Some(Dimension::Moment), "its moment about the heel", |a| in_plane(a, ResultValue::Number(a.outcome.actions.uplift_moment)));
    BuoyantWeight = number("buoyant_weight", Some(Dimension::Force), "W', weight less buoyancy",
        |a| ResultValue::Number(a.outcome.actions.buoyant_weight));
    WeightArm = number("weight_arm", Some(Dimension::Length), "t, its arm to the heel", |a| in_plane(a, ResultValue::Number(a.outcome.actions.weight_arm)));

    Omega = number("omega", None, "ω, the share of the base that crushes under V alone, V/(2B q_u); from 1 on it cannot carry V",
        |a| ground(a, |g| g.omega));
    Pivot = number("pivot", Some(Dimension::Length),
        "of a base that crushes, how far inside its edge the reaction of a body acts that turns, or is about to",
        |a| ground(a, BaseResponse::pivot));
    Neutral = number("neutral", Some(Dimension::Length),
        "of a base that crushes, how far inside its edge the neutral point is about which the body turns",
        |a| ground(a, BaseResponse::neutral));
    EffectiveWidth = number("effective_width", Some(Dimension::Length),
        "B' = 2(B − |e|), the width that the resultant has in its middle; 0 where it misses the base",
        |a| on_base(a, Reaction::effective_width));
    EffectivePressure = number("effective_pressure", Some(Dimension::Pressure), "pressure on the effective width, V/B'",
        |a| on_base(a, Reaction::effective_pressure));
    GroundResistance = number("ground_resistance", Some(Dimension::Force),
        "R, resistance of the ground at the eccentricity and inclination of the resultant, no partial factor applied", |a| ground(a, |g| g.resistance));
    GroundFactor = number("ground_factor", None, "R/V, resistance of the ground over the force on it", |a| ground(a, |g| g.factor));
    GroundMargin = number("ground_margin", Some(Dimension::Force),
        "R − V, what the ground leaves: negative where it does not bear a body at rest; with `margin_sliding` not negative either, the body can rest on this base",
        |a| ground(a, |g| g.margin));
    LoadFactorGround = number("load_factor_ground", None,
        "where R/V falls to 1 under a body that friction holds, as a multiple of the variable loads; 0 under the permanent loads alone",
        |a| failing(a, |f| Some(f.given)));
    LoadFactorGroundLess = number("load_factor_ground_less", None, "the same at an angle of friction 2° less", |a| failing(a, |f| f.less));
    LoadFactorGroundMore = number("load_factor_ground_more", None, "the same at an angle of friction 2° more", |a| failing(a, |f| f.more));
    KBf = number("k_BF", None,
        "horizontal by vertical force at which R/V is 1, if force and moment grow as they stand to each other under the full load",
        |a| ground(a, |g| g.k_bf));
    Rotation = number("rotation", Some(Dimension::Angle), "rotation on the elastic base under the full load, raised slowly",
        |a| elastic(a, |e| e.rotation));
    KOverturn = number("k_overturn", None,
        "horizontal by vertical force at which the body overturns on the elastic base if the load is raised slowly, as `k_BF`",
        |a| elastic(a, |e| e.k_overturn));
    Period1 = number("period_1", Some(Dimension::Time), "the longer natural period of sway and rocking on the elastic base",
        |a| elastic(a, |e| e.periods.map(|periods| periods[0])));
    Period2 = number("period_2", Some(Dimension::Time), "the shorter one", |a| elastic(a, |e| e.periods.map(|periods| periods[1])));
    DShear = number("D_shear", None, "the largest shear of the base over that of the loads in time", |a| impact(a, |i| i.d_shear));
    DMoment = number("D_moment", None, "the largest moment about the middle of the base over that of the loads in time",
        |a| impact(a, |i| i.d_moment));
    KMoved = number("k_moved", None,
        "where the loads in time take k of the full load in the k–μ plane, D_shear k; if they alone push and turn the body",
        |a| elastic(a, |e| e.moved.map(|[k, _]| k)));
    KPrimeMoved = number("k_prime_moved", None, "the same of k', (1 + k') D_moment/D_shear − 1",
        |a| elastic(a, |e| e.moved.map(|[_, k_prime]| k_prime)));
    FirstEvent = word("first_event", &["slip", "lift", "yield"], "what first ends the linear response of the elastic base: the base slips, an edge lifts, or it yields",
        |a| first_event(a).map_or(ResultValue::Nothing, |(event, _)| ResultValue::Word(event)));
    FirstEventTime = number("first_event_time", Some(Dimension::Time), "when that is", |a| perhaps(first_event(a).map(|(_, time)| time)));

    WorstDirection = number("worst_direction_deg", None,
        "the direction in which the variable loads would first end rest, were they turned: of their force on the body, seen from above, 0 to the left, 90 away from the viewer; the first of several",
        |a| worst(a, |worst| worst.degrees));
    LoadFactorWorst = number("load_factor_worst", None,
        "where the body leaves rest in that direction, as a multiple of the variable loads",
        |a| worst(a, DirectionAnswer::load_factor));

    KEff = number("k_eff", None, "k of the load in the report's diagram, where it has a point there",
        |a| a.outcome.full.effective.map_or(ResultValue::Nothing, |reduced| ResultValue::Number(reduced.point.k())));
    KPrimeEff = number("k_prime_eff", None, "k' of the load in the report's diagram",
        |a| a.outcome.full.effective.map_or(ResultValue::Nothing, |reduced| ResultValue::Number(reduced.point.k_prime())));
}

/// Everything that is said of a result of the sea.
#[derive(Clone, Copy)]
pub struct SeaInfo {
    /// Its name.
    pub name: &'static str,
    /// Its dimension; `None` of a number without unit.
    pub dimension: Option<Dimension>,
    /// Its meaning, in words.
    pub words: &'static str,
    of: fn(&Goda) -> f64,
}

const fn sea(
    name: &'static str,
    dimension: Option<Dimension>,
    words: &'static str,
    of: fn(&Goda) -> f64,
) -> SeaInfo {
    SeaInfo { name, dimension, words, of }
}

listed! {
    /// A result of the waves by Goda's formulas, on the way to what they press with.
    SeaResult: SeaInfo;

    H13 = sea("H13", Some(Dimension::Length), "significant wave height at the wall", |goda| goda.h_13);
    Hmax = sea("Hmax", Some(Dimension::Length), "design wave height", |goda| goda.h_max);
    DeepWaterWavelength = sea("deep_water_wavelength", Some(Dimension::Length), "L₀", |goda| goda.deep_water_wavelength);
    Wavelength = sea("wavelength", Some(Dimension::Length), "L at the wall", |goda| goda.wavelength);
    Hb = sea("h_b", Some(Dimension::Length), "depth at five significant wave heights seaward", |goda| goda.h_b);
    Angle = sea("angle_deg", None, "β after the turn towards the normal, degrees", |goda| goda.angle_deg);
    EtaStar = sea("eta_star", Some(Dimension::Length), "η*, how far above still water the pressure would reach", |goda| goda.eta_star);
    HcStar = sea("h_c_star", Some(Dimension::Length), "h_c*, how far above still water the pressure reaches on the wall", |goda| goda.h_c_star);
    Alpha1 = sea("alpha_1", None, "α₁", |goda| goda.alpha_1);
    Alpha2 = sea("alpha_2", None, "α₂", |goda| goda.alpha_2);
    Alpha3 = sea("alpha_3", None, "α₃", |goda| goda.alpha_3);
    Alpha4 = sea("alpha_4", None, "α₄", |goda| goda.alpha_4);
    AlphaI = sea("alpha_I", None, "α_I, the impulsive coefficient, whether used or not", |goda| goda.alpha_impulsive);
    AlphaStar = sea("alpha_star", None, "α*, the larger of α₂ and α_I, or α₂", |goda| goda.alpha_star);
    P1 = sea("p1", Some(Dimension::Pressure), "pressure at still water", |goda| goda.p1);
    P3 = sea("p3", Some(Dimension::Pressure), "pressure at the base", |goda| goda.p3);
    P4 = sea("p4", Some(Dimension::Pressure), "pressure at the top of the loaded wall", |goda| goda.p4);
    Pu = sea("pu", Some(Dimension::Pressure), "uplift pressure at the seaward toe; zero at the heel", |goda| goda.pu);
}

impl SeaResult {
    /// Its name.
    pub fn name(self) -> &'static str {
        self.info().name
    }

    /// Its value, SI.
    pub fn of(self, goda: &Goda) -> f64 {
        (self.info().of)(goda)
    }
}

impl ResultName {
    /// Its name.
    pub fn name(self) -> &'static str {
        self.info().name
    }

    /// What it is of, in one or two words, where a line has no room for more: of those that criteria ask for.
    pub fn in_short(self) -> &'static str {
        match self {
            ResultName::SfSliding => "sliding",
            ResultName::SfOverturningNet => "overturning",
            ResultName::SfOverturningGross => "overturning, gross",
            ResultName::SfUplift => "uplift",
            ResultName::BearingMax => "bearing pressure",
            ResultName::ContactShare => "contact",
            ResultName::GroundFactor => "ground",
            ResultName::EffectivePressure => "effective pressure",
            ResultName::LoadFactor => "load factor",
            other => other.name(),
        }
    }

    /// Its value for a situation.
    pub fn of(self, assessed: &Assessed) -> ResultValue {
        (self.info().of)(assessed)
    }

    /// The criterion that has to ask for it, for it to be told; `None` of a result that always is.
    pub fn asked_by(self) -> Option<Key> {
        match self {
            ResultName::SfUplift => Some(Key::LeastUplift),
            ResultName::Tipping => Some(Key::GreatestTipping),
            _ => None,
        }
    }

    /// True if it is told of a case with these criteria, where it is none of the ground.
    pub fn is_told(self, criteria: &[Criterion]) -> bool {
        let asked = |key| criteria.iter().any(|criterion| criterion.key == key);
        self.asked_by().is_none_or(asked)
    }

    /// True if only a case with a `[ground]` has it.
    pub fn is_of_ground(self) -> bool {
        (ResultName::Omega..=ResultName::FirstEventTime).contains(&self)
    }

    /// True if only a case with a base seen from above has it; it stands under `plan` in the JSON.
    pub fn is_of_plan(self) -> bool {
        matches!(self, ResultName::WorstDirection | ResultName::LoadFactorWorst)
    }

    /// Its name under `ground` in the JSON; `None` if it stands with the others. Both periods are one list.
    pub fn in_ground(self) -> Option<&'static str> {
        match self {
            ResultName::GroundResistance => Some("resistance"),
            ResultName::GroundFactor => Some("factor"),
            ResultName::GroundMargin => Some("margin"),
            ResultName::Period1 | ResultName::Period2 => Some("periods"),
            result => Some(result.name()).filter(|_| result.is_of_ground()),
        }
    }

    /// The value of `departure`.
    pub fn departure_of(departure: &Departure) -> ResultValue {
        ResultValue::Word(match departure {
            Departure::Never => "never",
            Departure::AtOnce { .. } => "at-once",
            Departure::At { .. } => "at",
        })
    }

    /// The value of `load_factor`.
    pub fn load_factor_of(departure: &Departure) -> ResultValue {
        match *departure {
            Departure::At { factor, .. } => ResultValue::Number(factor),
            Departure::Never | Departure::AtOnce { .. } => ResultValue::Nothing,
        }
    }

    /// The value of `departure_by`.
    pub fn departure_by_of(departure: &Departure) -> ResultValue {
        match departure {
            Departure::AtOnce { permanent: true, .. } => ResultValue::Word("permanent-loads"),
            Departure::AtOnce { permanent: false, .. } => ResultValue::Word("any-share"),
            Departure::Never | Departure::At { .. } => ResultValue::Nothing,
        }
    }

    /// The result of a name.
    pub fn find(name: &str) -> Option<ResultName> {
        ResultName::ALL.iter().copied().find(|result| result.name() == name)
    }
}

fn verdict(verdict: Option<Verdict>) -> ResultValue {
    verdict.map_or(ResultValue::Nothing, |verdict| ResultValue::Word(verdict.symbol()))
}

/// A number that may not exist.
fn perhaps(number: Option<f64>) -> ResultValue {
    number.map_or(ResultValue::Nothing, ResultValue::Number)
}

/// A number of what presses on the base, of any case with a rectangular one.
fn on_base(assessed: &Assessed, of: fn(&Reaction) -> f64) -> ResultValue {
    let reaction = match &assessed.ground {
        Some(ground) => ground.reaction,
        None if assessed.outcome.plan.is_some() => None,
        None => Reaction::of(&assessed.situation, 1.0).ok().flatten(),
    };
    perhaps(reaction.map(|reaction| of(&reaction)))
}

/// A number of what the base bears.
fn ground(assessed: &Assessed, of: fn(&BaseResponse) -> Option<f64>) -> ResultValue {
    perhaps(assessed.ground.as_ref().and_then(of))
}

/// A load factor of the ground.
fn failing(assessed: &Assessed, of: fn(&LoadFactors) -> Option<f64>) -> ResultValue {
    perhaps(assessed.ground.as_ref().and_then(|ground| of(ground.load_factors.as_ref()?)))
}

/// A number of an elastic base.
fn elastic(assessed: &Assessed, of: fn(&Elastic) -> Option<f64>) -> ResultValue {
    perhaps(assessed.ground.as_ref().and_then(|ground| of(ground.elastic.as_ref()?)))
}

/// A number of the response to loads in time.
fn impact(assessed: &Assessed, of: fn(&ImpactResponse) -> Option<f64>) -> ResultValue {
    let response = assessed.ground.as_ref().and_then(|ground| ground.elastic.as_ref()?.impact.as_ref());
    perhaps(response.and_then(of))
}

/// First event that ends the linear response of an elastic base, and its time.
fn first_event(assessed: &Assessed) -> Option<(&'static str, f64)> {
    let elastic = assessed.ground.as_ref()?.elastic.as_ref()?;
    let found = elastic.impact.as_ref()?.first_event()?;
    Some((event(found.event), found.time?))
}

/// An event in a word.
pub fn event(event: ImpactEvent) -> &'static str {
    match event {
        ImpactEvent::Slip => "slip",
        ImpactEvent::Lift => "lift",
        ImpactEvent::Yield => "yield",
    }
}

/// The least of a safety factor over all joints; one of what is lifted means nothing.
pub fn least_of_joints(assessed: &Assessed, of: fn(&Assessed) -> f64) -> ResultValue {
    if assessed.is_lifted() { ResultValue::Nothing } else { ResultValue::Number(of(assessed)) }
}

/// A safety factor; one of a lifted body means nothing.
fn factor(full: &Response, factor: f64) -> ResultValue {
    if full.is_lifted() { ResultValue::Nothing } else { ResultValue::Number(factor) }
}

/// A number of the plane of the section; none on a base seen from above.
fn in_plane(assessed: &Assessed, value: ResultValue) -> ResultValue {
    if assessed.outcome.plan.is_some() { ResultValue::Nothing } else { value }
}

/// A number of the direction that bears least.
fn worst(assessed: &Assessed, of: fn(&DirectionAnswer) -> f64) -> ResultValue {
    let directions =
        assessed.outcome.plan.as_ref().and_then(|_| SituationDirections::of(assessed, 90.0).ok());
    perhaps(directions.and_then(|directions| directions.worst.as_ref().map(of)))
}

/// Margins of the inequalities of rest under the full load.
fn margins(assessed: &Assessed) -> Margins {
    assessed.outcome.margins
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
        let verdicts = (0..=Verdict::BEARING_FAILURE_CODE).filter_map(Verdict::from_code);
        assert_eq!(SYMBOLS.to_vec(), verdicts.map(Verdict::symbol).collect::<Vec<_>>());
    }
}
