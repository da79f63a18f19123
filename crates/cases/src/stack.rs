//! The answer to a stack of bodies in pure numbers: as text, and as a JSON document.

use serde::Serialize;
use standfast::Mode;
use standfast::contact::stack::{
    BodyMotion, JointMotion, Stack, StackAnswer, StackDeparture, StackError, StackMotion,
};

use standfast_answers::assess::joint_words::together;

use crate::json::{SCHEMA, number_or_word, written};
use crate::layout::{columns, digits, paragraph, row};

/// A stack with its answers.
#[derive(Debug, Clone, PartialEq)]
pub struct AnsweredStack {
    departure: StackDeparture,
    /// What begins under the full load; the reason where that is not known.
    at_once: Result<StackAnswer, StackError>,
}

impl AnsweredStack {
    /// The answers to a stack.
    ///
    /// # Errors
    /// If it is no stack.
    pub fn of(stack: &Stack) -> Result<AnsweredStack, StackError> {
        let departure = stack.departure()?;
        Ok(AnsweredStack { departure, at_once: stack.answer(1.0) })
    }

    /// The JSON document, which `docs/stack.schema.json` describes.
    pub fn json(&self) -> String {
        let StackDeparture { load_factor, answer, .. } = &self.departure;
        let full = self.at_once.as_ref().ok();
        let motion = full.and_then(StackAnswer::motion);
        written(&StackDocument {
            schema: SCHEMA,
            departure: match *load_factor {
                0.0 => "at-once",
                f64::INFINITY => "never",
                _ => "at",
            },
            load_factor: *load_factor,
            departure_joints: self.departure.joints().iter().map(|place| place + 1).collect(),
            departure_modes: reported(answer),
            departure_also_modes: answer.others().collect(),
            modes: full.and_then(reported),
            also_modes: full.map(|full| full.others().collect()).unwrap_or_default(),
            unique: full.map(StackAnswer::is_unique),
            no_modes: self.at_once.as_ref().err().map(ToString::to_string),
            joints: motion.map(|motion| &*motion.joints),
            bodies: motion.map(|motion| &*motion.bodies),
        })
    }

    /// The answers in words and tables.
    pub fn text(&self) -> String {
        let mut text = paragraph(&self.leaves(), 0) + &also("As consistent then", &self.departure.answer);
        match &self.at_once {
            Err(error) => text += &paragraph(&format!("At once, the full load: not known, {error}."), 0),
            Ok(answer) => {
                let alone =
                    if answer.is_unique() { "no other combination is consistent" } else { "not unique" };
                text += &paragraph(
                    &format!(
                        "At once, the full load: {} from the ground up; {alone}.",
                        slashed(answer.modes())
                    ),
                    0,
                );
                text += &also("As consistent", answer);
                if let Some(motion) = answer.motion() {
                    text += &table(answer.modes(), motion);
                }
            }
        }
        text
    }

    /// Where it leaves rest, in a sentence or two.
    fn leaves(&self) -> String {
        let StackDeparture { load_factor, at_once, answer, .. } = &self.departure;
        let joints = self.departure.joints();
        let reach = match joints.as_slice() {
            [] => return "The stack never leaves rest under the variable loads.".to_owned(),
            [_] => "reaches its limit",
            _ => "reach their limits",
        };
        let which = together(&joints);
        let ends = match *load_factor {
            _ if *at_once => format!("Under the permanent loads alone {which} cannot rest"),
            0.0 => format!("Under any variable load {which} cannot rest"),
            factor => format!("At {} times the variable loads {which} {reach}", digits(factor)),
        };
        match answer.modes() {
            [] => format!("{ends}."),
            modes => format!("{ends}: {} from the ground up.", slashed(modes)),
        }
    }
}

fn reported(answer: &StackAnswer) -> Option<&[Mode]> {
    Some(answer.modes()).filter(|modes| !modes.is_empty())
}

/// The other combinations of an answer, behind words; nothing where there are none.
fn also(words: &str, answer: &StackAnswer) -> String {
    let others: Vec<String> = answer.others().map(slashed).collect();
    if others.is_empty() { String::new() } else { paragraph(&format!("{words}: {}.", others.join(", ")), 0) }
}

/// Modes as in RE/SL.
fn slashed(modes: &[Mode]) -> String {
    modes.iter().map(|mode| mode.symbol()).collect::<Vec<_>>().join("/")
}

/// Joints and bodies from the top, with their modes and motion.
fn table(modes: &[Mode], motion: &StackMotion) -> String {
    let mut rows = vec![row!["joint", "mode", "t", "ω", "f", "N", "ξ", "ẍ", "ÿ", "θ̈"]];
    let all = modes.iter().zip(&motion.joints).zip(&motion.bodies).enumerate();
    for (place, ((mode, joint), body)) in all.rev() {
        let JointMotion { t, omega, f, n, xi, .. } = *joint;
        let BodyMotion { x_ddot, y_ddot, theta_ddot } = *body;
        let numbers = [t, omega, f, n, xi, x_ddot, y_ddot, theta_ddot].map(digits);
        rows.push([vec![(place + 1).to_string(), mode.symbol().to_owned()], numbers.to_vec()].concat());
    }
    let key = "t, ω: acceleration along the joint and angular acceleration, relative to the body below; f, N: friction and normal \
               reaction on the body above, N at ξ; ẍ, ÿ, θ̈: its centre, on a shaken base relative to that. To the right, upwards, \
               counter-clockwise.";
    let table = columns(&rows, 2, &[2, 3, 4, 5, 6, 7, 8, 9]);
    format!("\nJoints, from the top, each with the body on it\n{table}{}", paragraph(key, 2))
}

#[derive(Debug, Serialize)]
struct StackDocument<'a> {
    schema: u32,
    departure: &'static str,
    #[serde(serialize_with = "number_or_word")]
    load_factor: f64,
    departure_joints: Vec<usize>,
    departure_modes: Option<&'a [Mode]>,
    departure_also_modes: Vec<&'a [Mode]>,
    modes: Option<&'a [Mode]>,
    also_modes: Vec<&'a [Mode]>,
    unique: Option<bool>,
    no_modes: Option<String>,
    joints: Option<&'a [JointMotion]>,
    bodies: Option<&'a [BodyMotion]>,
}
