//! The joints of a situation, for reading and for programs: what is above each, which moves first, and all at once.

use serde::Serialize;
use standfast::contact::stack::{BodyMotion, JointMotion, StackAnswer, StackStage};
use standfast::{Corner, Departure, Mode, Stability, Verdict};
use standfast_figures::JointLine;
use standfast_inputs::digits::{digits, percent};

use super::{Assessed, Assessment, AssessmentView, JointPlace, Joints, Together, predicate, verdict};
use crate::case::Case;
use crate::json::number_or_word;
use crate::layout::{columns, paragraph, row};
use crate::results::{ResultName, ResultValue};
use crate::summary::{capital, listed, quoted};
use crate::units::Dimension;
use standfast_answers::assess::joint_words;

/// Sentences on the full load, applied at once.
pub(super) fn full_load(assessed: &Assessed, joints: &Joints) -> Vec<String> {
    let factor = verdict::factor_at_rest(assessed).map_or(String::new(), |factor| format!(", {factor}"));
    let mut sentences =
        vec![format!("Under the full load, applied suddenly, {}{factor}.", joints.at_once(assessed))];
    match &joints.together {
        Together::Answered(answer) => sentences.push(uniqueness(&answer.full)),
        Together::Not(why) => sentences.push(format!("{}.", capital(why))),
    }
    sentences.push(glued(assessed, joints));
    sentences
}

/// The combination from the base up, and whether others are as consistent.
fn uniqueness(answer: &StackAnswer) -> String {
    let head = format!("From the base up: {}", joint_words::slashed(answer.modes()));
    let others: Vec<String> = answer.others().map(joint_words::slashed).collect();
    match others.as_slice() {
        [] => format!("{head}; the answer is unique."),
        others => format!(
            "{head}; the answer is not unique: {} {} as consistent.",
            listed(others),
            if others.len() == 1 { "is" } else { "are" }
        ),
    }
}

/// What the whole would do as one body.
fn glued(assessed: &Assessed, joints: &Joints) -> String {
    let leaves = match assessed.outcome.departure {
        Departure::Never => "and no multiple of the variable loads would move it".to_owned(),
        Departure::AtOnce { .. } => "and would leave rest at once".to_owned(),
        Departure::At { factor, .. } => format!("and would leave rest at {}", percent(factor)),
    };
    let mode = assessed.outcome.full.verdict.map_or("no mode", Verdict::symbol);
    // Where they leave rest together, the base is one of those that the answer names.
    let first = joints.leaves.joints();
    let warns = match first.is_empty() || first.contains(&0) {
        true => "",
        false => ": the base alone is not the answer",
    };
    format!("As one body on its base all would be {mode} {leaves}{warns}.")
}

/// Sentence on where the first joint leaves rest as the variable loads rise.
pub(super) fn leaving(assessed: &Assessed, joints: &Joints, loads: &str) -> String {
    let clause = joints.departs(assessed);
    match assessed.departure() {
        Departure::Never => format!("No multiple of {loads} moves a joint."),
        Departure::AtOnce { permanent: true, .. } => {
            format!("The permanent loads alone move a joint: {clause}.")
        }
        Departure::AtOnce { permanent: false, .. } => {
            format!("Any share of {loads}, however small, moves a joint: {clause}.")
        }
        Departure::At { factor, .. } => {
            let rises =
                if loads.contains(" and ") || loads.ends_with("loads") { "rise together" } else { "rises" };
            format!("As {loads} {rises}, {clause} from {} on.", percent(factor))
        }
    }
}

/// Sentence on the difference between the full load at once and a rising one; nothing to say of one that never moves a joint.
pub(super) fn difference(assessed: &Assessed, joints: &Joints) -> Option<String> {
    let rests = assessed.verdict() == Some(Verdict::REST);
    Some(match assessed.departure() {
        Departure::AtOnce { permanent: true, .. } => {
            "The joints are not at rest before the variable loads rise.".to_owned()
        }
        Departure::At { factor, .. } if factor < 1.0 && rests => format!(
            "Applied suddenly, the full load leaves every joint at rest; rising slowly, it moves one before, at {}.",
            percent(factor)
        ),
        _ if rests => "Every joint rests under the full load, applied suddenly or slowly.".to_owned(),
        _ => {
            let full = joints.modes().filter(|modes| *modes != joints.departing());
            let full = full.filter(|modes| !modes.is_empty())?;
            format!("Applied suddenly, the full load starts another motion: {}.", joints.all_go(full))
        }
    })
}

/// The table of joints, from the top, and the motion and the load path where they are known.
pub(super) fn render(assessed: &Assessed) -> String {
    let Some(joints) = &assessed.joints else { return String::new() };
    let output = assessed.output;
    let force = output.symbol(Dimension::Force);
    let [length, pressure] = [Dimension::Length, Dimension::Pressure].map(|of| output.symbol(of));
    let mut rows = vec![
        row![
            "", "", "at", "contact", "X", "P", "e", "SF", "SF about", "SF about", "pressed", "p max",
            "leaves", ""
        ],
        row![
            "",
            "",
            length.clone(),
            length.clone(),
            force.clone(),
            force,
            length,
            "slide",
            "O",
            "O'",
            "",
            pressure,
            "rest at",
            ""
        ],
    ];
    let first = joints.leaves.joints();
    let places: Vec<(&JointPlace, &Assessed)> = joints.places.iter().zip(assessed.on_joints()).collect();
    for (joint, (place, on)) in places.into_iter().enumerate().rev() {
        let full = &on.outcome.full;
        let lifted = full.is_lifted();
        let factor = |factor: f64| if lifted { "none".to_owned() } else { output.factor(factor) };
        let [about_o, about_o_prime] = about_ends(on);
        let bearing = &on.outcome.stability;
        let word = |result: ResultName, dimension: Option<Dimension>| match (result.of(on), dimension) {
            (ResultValue::Number(number), Some(dimension)) => output.value(dimension, number),
            (ResultValue::Number(share), None) => percent(share),
            _ => "–".to_owned(),
        };
        let [from, to] = place.ends.map(|x| output.value(Dimension::Length, x));
        let e = bearing.eccentricity(on.situation.body().base_width());
        rows.push(row![
            (joint + 1).to_string(),
            place.name.as_deref().unwrap_or_default(),
            output.value(Dimension::Length, place.elevation),
            format!("{from} to {to}"),
            output.value(Dimension::Force, 0.0 - full.wrench.x),
            output.value(Dimension::Force, full.wrench.p),
            e.map_or_else(|| "–".to_owned(), |e| output.value(Dimension::Length, e)),
            factor(bearing.sliding),
            factor(about_o),
            factor(about_o_prime),
            word(ResultName::ContactShare, None),
            word(ResultName::BearingMax, Some(Dimension::Pressure)),
            leaves_at(joints, joint, on),
            if first.contains(&joint) { "governs" } else { "" },
        ]);
    }
    let mut text = "\nJoints, from the top: each with all that is above it, under the full load\n".to_owned();
    text += &columns(&rows, 2, &[0, 2, 4, 5, 6, 7, 8, 9, 10, 11, 12]);
    text += &paragraph(
        "X to the left, P downwards; e from the middle of the contact, whose ends O and O' are. A joint carries all that is above it, \
         whatever the others do. Joint 1 is the base, of which the sections above tell.",
        2,
    );
    text
}

/// The share of a joint that is pressed; `None` where the resultant misses it.
pub fn pressed(on: &Assessed) -> Option<f64> {
    match ResultName::ContactShare.of(on) {
        ResultValue::Number(share) => Some(share),
        _ => None,
    }
}

/// Where a joint leaves rest by itself.
pub fn leaves_at(joints: &Joints, joint: usize, on: &Assessed) -> String {
    // What is found for all together is nearer to what is written.
    let governs = joints.leaves.joints().contains(&joint);
    let own = if governs { joints.departure() } else { on.outcome.departure };
    verdict::departure_word(&own)
}

/// Safety factors against overturning about O and about O'.
pub fn about_ends(on: &Assessed) -> [f64; 2] {
    let Stability { overturning_about_heel: heel, overturning_about_toe: toe, .. } = on.outcome.stability;
    if on.outcome.actions.heel == Corner::O { [heel, toe] } else { [toe, heel] }
}

/// The motion of all joints, where one moves: the names of the columns, their units, and the joints from the top.
pub fn motion_rows(assessed: &Assessed) -> Option<Vec<Vec<String>>> {
    let joints = assessed.joints.as_ref()?;
    let moves = assessed.verdict() != Some(Verdict::REST);
    let (motion, modes) = joints.motion().zip(joints.modes()).filter(|_| moves)?;
    let output = assessed.output;
    let (force, length) = (output.symbol(Dimension::Force), output.symbol(Dimension::Length));
    let mut rows = vec![
        row!["", "mode", "t", "ω̇", "f", "N", "ξ", "ẍ", "ÿ", "θ̈"],
        row!["", "", "m/s²", "rad/s²", force.clone(), force, length, "m/s²", "m/s²", "rad/s²"],
    ];
    let all = modes.iter().zip(&motion.joints).zip(&motion.bodies).enumerate();
    for (place, ((mode, joint), body)) in all.collect::<Vec<_>>().into_iter().rev() {
        let BodyMotion { x_ddot, y_ddot, theta_ddot } = *body;
        rows.push(row![
            (place + 1).to_string(),
            mode.symbol(),
            digits(joint.t),
            digits(joint.omega),
            output.value(Dimension::Force, joint.f),
            output.value(Dimension::Force, joint.n),
            output.value(Dimension::Length, joint.xi),
            digits(x_ddot),
            digits(y_ddot),
            digits(theta_ddot),
        ]);
    }
    Some(rows)
}

/// What the columns of [`motion_rows`] are.
pub fn motion_key(assessed: &Assessed) -> String {
    let relative = if assessed.earthquake.is_some() { ", relative to the shaken base" } else { "" };
    format!(
        "t, ω̇: acceleration along the joint and angular acceleration, relative to the body below; f, N: friction and normal reaction on the \
         body above, N at ξ; ẍ, ÿ, θ̈: its centre{relative}. To the right, upwards, counter-clockwise."
    )
}

/// The motion of all joints as text, where one moves.
pub(super) fn motion(assessed: &Assessed) -> String {
    motion_rows(assessed).map_or(String::new(), |rows| {
        let table = columns(&rows, 2, &[0, 2, 3, 4, 5, 6, 7, 8, 9]);
        format!(
            "\nAt onset: the joints from the top, each with the body on it\n{table}{}",
            paragraph(&motion_key(assessed), 2)
        )
    })
}

/// The stages of the rising load.
pub(super) fn stages(case: &Case, assessed: &Assessed, joints: &Joints, view: &AssessmentView) -> String {
    let path = joints.path(case, assessed, view.up_to);
    if path.is_empty() {
        return String::new();
    }
    let mut rows = vec![row!["from", "to", "modes from the base up", ""]];
    rows.extend(path.iter().map(|stage| {
        let others: Vec<String> = stage.others.iter().map(|modes| joint_words::slashed(modes)).collect();
        let also =
            if others.is_empty() { String::new() } else { format!("not unique, also {}", listed(&others)) };
        row![digits(stage.from), digits(stage.to), joint_words::slashed(&stage.modes), also]
    }));
    columns(&rows, 2, &[0, 1])
}

/// The line of the glued whole in a summary.
pub(super) fn glued_words(assessed: &Assessed) -> String {
    format!("Under the full load the whole, as one body, {}.", predicate(assessed.outcome.full.verdict))
}

/// What stands in a row of a summary of situations: the joint that moves first.
pub fn first_words(assessed: &Assessed) -> Option<String> {
    let joints = assessed.joints.as_ref()?;
    let first = joints.leaves.joints();
    match first.as_slice() {
        [] => None,
        [one] => Some(joints.called(*one)),
        several => Some(joint_words::together(several)),
    }
}

/// The mode of the lowest joint that moves; rest if none does, `None` where that is not known.
pub fn leading(assessed: &Assessed, joints: &Joints) -> Option<Mode> {
    match joints.modes() {
        Some([]) => None,
        Some(modes) => Some(modes.iter().copied().find(|mode| *mode != Mode::Rest).unwrap_or(Mode::Rest)),
        None => (assessed.verdict() == Some(Verdict::REST)).then_some(Mode::Rest),
    }
}

/// The modes under the full load from the base up, where they are known; else whether all rest.
pub fn symbols(assessed: &Assessed, joints: &Joints) -> String {
    match joints.modes() {
        Some(modes) if !modes.is_empty() => joint_words::slashed(modes),
        _ if assessed.verdict() == Some(Verdict::REST) => Verdict::REST.symbol().to_owned(),
        _ => "not all rest".to_owned(),
    }
}

/// The joints as a section has them, with the resultants of a situation; none of a body of one piece.
pub(super) fn lines(assessed: &Assessed) -> Vec<JointLine> {
    let Some(joints) = &assessed.joints else { return Vec::new() };
    let first = joints.leaves.joints();
    let lines = joints.places.iter().zip(assessed.on_joints()).enumerate().map(|(joint, (place, on))| {
        let [from, to] = place.ends.map(|x| x - joints.middle());
        JointLine {
            ends: (from, to),
            elevation: place.elevation,
            number: joint + 1,
            governs: first.contains(&joint),
            resultant: arm(on).map(|arm| from + arm),
        }
    });
    lines.collect()
}

/// Sentence on the line of thrust and the governing joint, for below a section.
pub(super) fn thrust_words(assessment: &Assessment, assessed: &Assessed, joints: &Joints) -> String {
    let under = assessment.name(assessed).filter(|_| assessment.all.len() > 1);
    let under = under.map_or_else(|| "the full load".to_owned(), |name| quoted(&name));
    let first = first_words(assessed).map_or_else(String::new, |first| {
        let count = joints.leaves.joints().len();
        let leave = if count == 1 { "leaves" } else { "leave" };
        format!(" The heavy line is {first}, which {leave} rest first.")
    });
    format!(
        "Numbers are those of joints, from the base, which is 1. Dots are where the resultant of all that is above a joint passes it, under {under}.{first}"
    )
}

/// A joint in the JSON.
#[derive(Debug, Serialize)]
pub(super) struct JointEntry<'a> {
    name: Option<&'a str>,
    elevation: f64,
    left: f64,
    right: f64,
    x: f64,
    p: f64,
    arm: Option<f64>,
    eccentricity: ResultValue,
    #[serde(rename = "SF_sliding")]
    sliding: ResultValue,
    #[serde(rename = "SF_overturning_left")]
    about_o: ResultValue,
    #[serde(rename = "SF_overturning_right")]
    about_o_prime: ResultValue,
    contact_length: ResultValue,
    contact_share: ResultValue,
    bearing_max: ResultValue,
    departure: ResultValue,
    load_factor: ResultValue,
    departure_by: ResultValue,
    motion: Option<JointMotion>,
}

/// All that the JSON says of the joints of a situation.
#[derive(Debug, Serialize)]
pub(super) struct JointEntries<'a> {
    /// From the base.
    joints: Vec<JointEntry<'a>>,
    bodies: Option<Vec<BodyMotion>>,
    modes: Option<&'a [Mode]>,
    also_modes: Vec<&'a [Mode]>,
    /// Reason why there are no modes.
    no_modes: Option<&'static str>,
    /// From the base, which is 1.
    departure_joints: Vec<usize>,
    departure_modes: Option<&'a [Mode]>,
    modes_path: Vec<JointStage>,
}

#[derive(Debug, Serialize)]
struct JointStage {
    from: f64,
    #[serde(serialize_with = "number_or_word")]
    to: f64,
    modes: Vec<Mode>,
    also_modes: Vec<Vec<Mode>>,
}

impl From<StackStage> for JointStage {
    fn from(StackStage { from, to, modes, others }: StackStage) -> JointStage {
        JointStage { from, to, modes, also_modes: others }
    }
}

impl<'a> JointEntries<'a> {
    /// The entries of a situation; `None` without joints.
    pub(super) fn of(case: &Case, assessed: &'a Assessed, view: &AssessmentView) -> Option<JointEntries<'a>> {
        let joints = assessed.joints.as_deref()?;
        let motion = joints.motion();
        let entries = joints.places.iter().zip(assessed.on_joints()).enumerate();
        let entries = entries.map(|(place, (at, on))| {
            let lifted = on.outcome.full.is_lifted();
            let factor = |factor| if lifted { ResultValue::Nothing } else { ResultValue::Number(factor) };
            let [about_o, about_o_prime] = about_ends(on).map(factor);
            // Of the whole the departure in its results is that of all joints.
            let own = on.outcome.departure;
            JointEntry {
                name: at.name.as_deref(),
                elevation: at.elevation,
                left: at.ends[0],
                right: at.ends[1],
                x: on.outcome.full.wrench.x,
                p: on.outcome.full.wrench.p,
                arm: arm(on),
                eccentricity: ResultName::Eccentricity.of(on),
                sliding: ResultName::SfSliding.of(on),
                about_o,
                about_o_prime,
                contact_length: ResultName::ContactLength.of(on),
                contact_share: ResultName::ContactShare.of(on),
                bearing_max: ResultName::BearingMax.of(on),
                departure: ResultName::departure_of(&own),
                load_factor: ResultName::load_factor_of(&own),
                departure_by: ResultName::departure_by_of(&own),
                motion: motion.as_ref().map(|motion| motion.joints[place]),
            }
        });
        Some(JointEntries {
            joints: entries.collect(),
            bodies: motion.map(|motion| motion.bodies),
            modes: joints.modes().filter(|modes| !modes.is_empty()),
            also_modes: joints.also().collect(),
            no_modes: joints.together.why_not(),
            departure_joints: joints.leaves.joints().iter().map(|joint| joint + 1).collect(),
            departure_modes: Some(joints.departing()).filter(|modes| !modes.is_empty()),
            modes_path: joints.path(case, assessed, view.up_to).into_iter().map(JointStage::from).collect(),
        })
    }
}

/// Distance of the resultant from the left end of a joint; `None` where nothing presses.
fn arm(on: &Assessed) -> Option<f64> {
    let from_heel = on.outcome.stability.resultant_arm?;
    Some(match on.outcome.actions.heel {
        Corner::O => from_heel,
        Corner::OPrime => on.situation.body().base_width() - from_heel,
    })
}
