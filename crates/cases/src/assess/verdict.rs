//! Sentences on the body under the full load at once, and while it rises: those of every face.

use standfast::loads::{Load, LoadSource};
use standfast::{Boundary, Departure, Mode, Outcome, Response, Verdict};

use super::{Assessed, AssessmentView, BaseResponse, joints, predicate};
use crate::case::{Made, soil_of};
use crate::layout::{columns, digits, percent, row};
use crate::summary::{listed, quoted};
use standfast_inputs::OutputUnits;

/// Note on ground that fails.
const NO_MOTION: &str = "The ground cannot bear the reaction. How the body then moves is not computed.";

/// The state under the full load, applied at once.
pub fn full_load(assessed: &Assessed) -> Vec<String> {
    if let Some(joints) = &assessed.joints {
        return joints::full_load(assessed, joints);
    }
    let full = &assessed.outcome.full;
    let mut sentences = Vec::new();
    if full.is_lifted() {
        sentences.push(lifted(full, assessed.output));
    }
    let factor = factor_at_rest(assessed).map_or(String::new(), |factor| format!(", {factor}"));
    sentences.push(format!(
        "Under the full load, applied suddenly, the body {}{factor}.",
        predicate(assessed.verdict())
    ));
    if let Some(neutral) = assessed.ground.as_ref().and_then(BaseResponse::neutral) {
        sentences.push(format!(
            "The base crushes under that corner: the body turns about a point {} inside it.",
            assessed.output.length(neutral)
        ));
    }
    sentences.push(uniqueness(assessed));
    sentences
}

/// The least safety factor of a body at rest, which is never said to rest without it; `None` for one that moves, or that no
/// load pushes.
pub fn factor_at_rest(assessed: &Assessed) -> Option<String> {
    let (factor, against) = least_factor(assessed).filter(|_| assessed.mode() == Some(Mode::Rest))?;
    Some(format!("with a safety factor of {} against {against}", assessed.output.factor(factor)))
}

/// The least of the safety factors: against sliding, and against overturning, net and by gross moments; what it is against. `None` of a body
/// that no load pushes, or that is lifted; and on a base that gives way, whose one margin is the share of the load at which the body leaves
/// rest: factors there are those of a rigid base, or of the ground under one load alone.
pub fn least_factor(assessed: &Assessed) -> Option<(f64, String)> {
    // A joint that has none is nearer to moving than one that has.
    if assessed.on_joints().any(has_no_factor) {
        return None;
    }
    let least = assessed.on_joints().enumerate().filter_map(|(joint, on)| {
        let (factor, against) = least_on_one(on)?;
        Some((factor, against, joint))
    });
    // Of joints that leave rest together, whose factors rounding alone tells apart, the lowest is named.
    const ROUNDING: f64 = 1e-9;
    let least = least.reduce(|least, next| if next.0 < least.0 * (1.0 - ROUNDING) { next } else { least });
    least.map(|(factor, against, joint)| match &assessed.joints {
        Some(joints) => (factor, format!("{against} on {}", joints.called(joint))),
        None => (factor, against.to_owned()),
    })
}

/// The same of one body.
fn least_on_one(assessed: &Assessed) -> Option<(f64, &'static str)> {
    let Outcome { stability, gross, .. } = &assessed.outcome;
    let turning = if is_object(assessed) { "the onset of rocking" } else { "overturning" };
    let factors = [
        (stability.sliding, "sliding"),
        (stability.overturning(), turning),
        (gross.overturning(), "overturning by gross moments"),
    ];
    let least = factors.into_iter().reduce(|least, next| if next.0 < least.0 { next } else { least });
    least.filter(|(factor, _)| factor.is_finite())
}

/// True of what is lifted, or stands on a base that gives way.
fn has_no_factor(assessed: &Assessed) -> bool {
    let gives_way = assessed.ground.as_ref().is_some_and(|ground| ground.limit.is_some());
    assessed.outcome.full.is_lifted() || gives_way
}

/// True of an object on a floor that is shaken: it begins to rock where its factor against overturning is 1, and need not overturn.
pub fn is_object(assessed: &Assessed) -> bool {
    assessed.earthquake.is_some()
        && assessed.situation.loads().iter().all(|load| {
            matches!(
                load.source,
                LoadSource::Weight
                    | LoadSource::HorizontalInertia
                    | LoadSource::VerticalInertia
                    | LoadSource::Force
            )
        })
}

/// A multiple of the variable loads as a share of them, and as what it amounts to where that is one force, or a base shaken sideways.
pub fn share_of_loads(assessed: &Assessed, factor: f64) -> String {
    let share = format!("{} of {}", percent(factor), risen_loads(assessed));
    match risen(assessed, factor) {
        Some(amount) => format!("{share} ({amount})"),
        None => share,
    }
}

/// What a multiple of the variable loads amounts to, where they are one force, or the base shaken to a side.
fn risen(assessed: &Assessed, factor: f64) -> Option<String> {
    let variable: Vec<_> = assessed.situation.loads().iter().filter(|load| !load.permanent).collect();
    match variable[..] {
        [force] if force.source == LoadSource::Force => {
            let wrench = assessed.situation.wrench_of(force);
            let away = force.across.as_ref().map_or(0.0, |across| across.away * force.factor);
            Some(assessed.output.force(factor * wrench.x.hypot(wrench.p).hypot(away)))
        }
        [first, ..] if variable.iter().all(|load| is_shaken_sideways(load)) => {
            let earthquake = assessed.earthquake?;
            let acceleration = first.factor * earthquake.horizontal().hypot(earthquake.away());
            Some(format!("{} g", digits(factor * acceleration / assessed.situation.gravity())))
        }
        _ => None,
    }
}

fn is_shaken_sideways(load: &Load) -> bool {
    matches!(load.source, LoadSource::HorizontalInertia | LoadSource::ShakenWater)
}

/// A variable load of a soil, as it stands in a sentence.
fn soil_words(load: &Load) -> Option<String> {
    Some(match soil_of(load)? {
        (_, Some(Made::Earthquake)) => "the earthquake".to_owned(),
        (soil, Some(Made::Surcharge)) => format!("the surcharge on the {soil}"),
        (soil, None) => format!("the {soil}"),
    })
}

/// The variable loads in a row, as they stand in a sentence.
pub fn risen_loads(assessed: &Assessed) -> String {
    let mut names: Vec<String> = Vec::new();
    for component in assessed.components().into_iter().filter(|component| !component.load.permanent) {
        let name = match component.load.source {
            LoadSource::EarthPressure | LoadSource::EarthDrag => {
                soil_words(&component.load).unwrap_or_default()
            }
            LoadSource::PoreWater => "the earthquake".to_owned(),
            LoadSource::WavePressure | LoadSource::WaveUplift => "the wave".to_owned(),
            LoadSource::HorizontalInertia | LoadSource::VerticalInertia | LoadSource::ShakenWater => {
                "the earthquake".to_owned()
            }
            // A name of its own as it is, if it does not read as a common noun.
            _ if component.name.starts_with(|c: char| c.is_uppercase() || c.is_numeric()) => component.name,
            _ => format!("the {}", component.name),
        };
        let name = if name.contains(',') || name.contains(" and ") { quoted(&name) } else { name };
        if !names.contains(&name) {
            names.push(name);
        }
    }
    if names.len() > 3 { "the variable loads".to_owned() } else { listed(&names) }
}

fn lifted(full: &Response, output: OutputUnits) -> String {
    let lift = output.force(0.0 - full.wrench.p);
    if full.wrench.p == 0.0 {
        "The loads carry the whole weight: nothing presses the body on its base, and safety factors mean nothing.".to_owned()
    } else if full.mode() == Some(Mode::Flight) {
        format!("The loads lift the body with {lift} more than its weight: safety factors mean nothing.")
    } else {
        format!(
            "The loads lift the body with {lift} more than its weight, but press one corner down by their moment; \
             safety factors mean nothing."
        )
    }
}

/// That the answer is the only one, and where it is on the boundary to another, which.
fn unique(assessed: &Assessed) -> String {
    if assessed.outcome.full.boundary != Some(Boundary::Exact) {
        return "The answer is unique.".to_owned();
    }
    match assessed.outcome.departure {
        Departure::At { factor: 1.0, verdict } => format!(
            "The answer is unique, and exactly on the boundary: with the least more load the body {}.",
            predicate(verdict)
        ),
        _ => "The answer is unique, and exactly on the boundary of rest.".to_owned(),
    }
}

/// Sentences on the uniqueness of the answer, and on the other modes if it is not unique.
pub fn uniqueness(assessed: &Assessed) -> String {
    let mode = match assessed.verdict() {
        None => {
            return "That happens only where friction to stick is larger than friction to slip.".to_owned();
        }
        Some(Verdict::BearingFailure) => return NO_MOTION.to_owned(),
        Some(_) if assessed.outcome.full.is_unique() => return unique(assessed),
        Some(Verdict::Begins(mode)) => mode,
    };
    if assessed.outcome.full.boundary == Some(Boundary::ToTheDigits) {
        let others: Vec<_> =
            assessed.outcome.full.others().iter().map(|mode| format!("{} ({mode})", mode.words())).collect();
        return format!(
            "To the digits given it is on a boundary: that it {} cannot be told from that.",
            others.join(" or ")
        );
    }
    let list: Vec<_> =
        assessed.outcome.full.others().iter().map(|mode| predicate(Some(Verdict::Begins(mode)))).collect();
    let verb = if list.len() == 1 { "satisfies" } else { "satisfy" };
    let mut text = format!(
        "The answer is not unique: that it {} {verb} the equations of motion, Coulomb's law and the contact \
         conditions as well. Rigid-body mechanics cannot choose; a suddenly applied load favours {mode}.",
        list.join(" and that it "),
    );
    let risen = assessed.outcome.risen().filter(|risen| *risen != mode && *risen != Mode::Rest);
    if let Some(risen) = risen {
        text += &format!(" Under a rising load the body comes there in {risen} and stays in it.");
    }
    text
}

/// The stages of the rising load; of a lone force in air with its force and k.
pub(super) fn stages(assessed: &Assessed, view: &AssessmentView) -> String {
    let in_air = assessed.situation.in_air();
    let mut rows = vec![row!["from", "to", "mode", "", ""]];
    rows.extend(assessed.path_up_to(view.up_to).iter().map(|stage| {
        let others = stage.others();
        let also = if others.is_empty() { String::new() } else { format!("not unique, also {others}") };
        let force = in_air.filter(|_| stage.from > 0.0).map(|reduced| {
            let weight = assessed.situation.body().mass() * assessed.situation.gravity();
            let k = stage.from * reduced.point.k();
            format!("from F = {} (k = {}) on", assessed.output.force(k * weight), digits(k))
        });
        let mode = stage.verdict.map_or("none", Verdict::symbol);
        row![digits(stage.from), digits(stage.to), mode, force.unwrap_or_default(), also]
    }));
    columns(&rows, 2, &[0, 1])
}

/// Sentences on the rise of the variable loads: departure from rest, and its difference from the full load at once.
pub fn path(assessed: &Assessed) -> Vec<String> {
    const NONE: &str = "No variable load acts, so no load rises.";
    if let Some(joints) = &assessed.joints {
        let loads = if assessed.rises() { risen_loads(assessed) } else { String::new() };
        let leaving = joints::leaving(assessed, joints, &loads);
        return match (assessed.rises(), assessed.departure()) {
            (false, Departure::Never) => vec![NONE.to_owned()],
            (false, _) => vec![NONE.to_owned(), leaving],
            (true, _) => {
                [Some(leaving), joints::difference(assessed, joints)].into_iter().flatten().collect()
            }
        };
    }
    match assessed.outcome.departure {
        Departure::Never if !assessed.rises() => vec![NONE.to_owned()],
        departure if !assessed.rises() => vec![NONE.to_owned(), leaving(&departure, "")],
        departure => vec![leaving(&departure, &risen_loads(assessed)), difference(assessed)],
    }
}

/// Sentence on the departure from rest as the loads, in words, rise.
fn leaving(departure: &Departure, loads: &str) -> String {
    match *departure {
        Departure::Never => format!("No multiple of {loads} moves the body."),
        Departure::AtOnce { verdict, permanent: true } => {
            format!("The permanent loads alone move the body: it {}.", predicate(verdict))
        }
        Departure::AtOnce { verdict, permanent: false } => {
            format!("Any share of {loads}, however small, moves the body: it {}.", predicate(verdict))
        }
        Departure::At { factor, verdict } => {
            let rises =
                if loads.contains(" and ") || loads.ends_with("loads") { "rise together" } else { "rises" };
            let goes = match verdict {
                Some(Verdict::BearingFailure) => "the ground fails (BF)".to_owned(),
                Some(verdict) => format!("the body {}", predicate(Some(verdict))),
                None => "the body moves, in no consistent mode".to_owned(),
            };
            format!("As {loads} {rises}, {goes} from {} on.", percent(factor))
        }
    }
}

/// The difference between the full load at once and a rising one.
fn difference(assessed: &Assessed) -> String {
    let full = assessed.verdict();
    let rests = assessed.mode() == Some(Mode::Rest);
    let symbol = |verdict: Option<Verdict>| verdict.map_or("no consistent mode", Verdict::symbol);
    match assessed.outcome.departure {
        Departure::AtOnce { permanent: true, .. } => {
            "The body is not at rest before the variable loads rise.".to_owned()
        }
        Departure::AtOnce { .. } if rests => {
            "Applied suddenly, the full load leaves the body at rest; rising slowly, it moves it before."
                .to_owned()
        }
        Departure::AtOnce { verdict, .. } if verdict == full => {
            format!("Applied suddenly or slowly, the load starts the same mode, {}.", symbol(full))
        }
        Departure::AtOnce { verdict, .. } => {
            format!(
                "Applied suddenly, the full load starts {}; rising slowly, it starts {} before.",
                symbol(full),
                symbol(verdict)
            )
        }
        Departure::At { factor, .. } if factor < 1.0 && rests => format!(
            "Applied suddenly, the full load leaves the body at rest; rising slowly, it moves it before, at {}.",
            percent(factor)
        ),
        _ if rests => "The body stays at rest under the full load, applied suddenly or slowly.".to_owned(),
        Departure::At { factor, verdict } if verdict == full => format!(
            "Applied suddenly or slowly, the load starts the same mode, {}. As it rises, the body moves from {} on.",
            symbol(full),
            percent(factor)
        ),
        Departure::At { factor, verdict } => format!(
            "Applied suddenly, the full load starts {}; rising slowly, it starts {} before, at {}.",
            symbol(full),
            symbol(verdict),
            percent(factor)
        ),
        Departure::Never => format!("Applied suddenly, the full load starts {}.", symbol(full)),
    }
}

/// Departure from rest, in a word or as per cent of the load.
pub fn departure_word(departure: &Departure) -> String {
    match *departure {
        Departure::Never => "never".to_owned(),
        Departure::AtOnce { .. } => "at once".to_owned(),
        Departure::At { factor, .. } => percent(factor),
    }
}
