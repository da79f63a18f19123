//! Bearing of the base: its effective width, resistance and stiffness, step by step.

mod factors;
mod soil;
mod springs;
mod time;

use standfast::ground::bearing::Reaction;
use standfast_cases::assess::BaseResponse;
use standfast_cases::assess::Component;
use standfast_cases::assess::ground::left_out;
use standfast_cases::case::{Foundation, Limit};
use standfast_cases::layout::plain;
use standfast_cases::units::Extent;
use standfast_cases::{Assessed, Case, Inputs, Key};

use self::soil::NamedReaction;
use super::classical::effects_of;
use crate::measured::{KILONEWTON, KILOPASCAL, METRE, NONE};
use crate::steps::SheetSteps;

/// In the place of a root of ground on which nothing presses.
const LOST: &str = "the least λ at which the base does not bear the resultant";

pub(super) fn steps(
    steps: &mut SheetSteps,
    case: &Case,
    inputs: &Inputs,
    assessed: &Assessed,
    components: &[Component],
) {
    let (Some(foundation), Some(ground)) = (&case.ground, &assessed.ground) else {
        // A criterion of any base.
        let asked =
            case.criteria_of(assessed.acting).iter().any(|criterion| criterion.key == Key::GreatestEffective);
        let reaction = Reaction::of(&assessed.situation, 1.0).ok().flatten();
        if let Some(reaction) = reaction.filter(|_| asked) {
            steps.heading("Pressure on the effective width");
            width(steps, &reaction, case.extent, ["", ""]);
        }
        return;
    };
    steps.heading("Ground");
    for note in left_out(case) {
        steps.note(&note.replace("k_n and k_t", "`k_n` and `k_t`").replace("q_u", "`q_u`"));
    }
    let Some(reaction) = &ground.reaction else {
        steps.note("Nothing presses on the base: there is no resistance and no factor.");
        return factors::of_lifted(steps, ground);
    };
    let whole = case.extent == Extent::Whole;
    let long = if whole { " L_b" } else { "" };
    let sheet = Sheet { inputs, assessed, components, foundation, ground, reaction, long };
    width(steps, reaction, case.extent, ["effective_width", "effective_pressure"]);
    match foundation.limit {
        Some(Limit::Strength(strength)) => sheet.crushing(steps, strength),
        Some(Limit::Ground(_)) => {
            sheet.of_ground(steps);
            sheet.bears(
                steps,
                &NamedReaction {
                    reaction: *reaction,
                    vertical: "V",
                    push: "|X|",
                    width: "B'",
                    share: "2 |e_b|/B_c",
                    of: "",
                    key: "ground_resistance",
                },
            );
        }
        None => {}
    }
    if let Some(effects) = assessed.situation.effects() {
        effects_of(steps, case, assessed, components, "V_d", 1, effects.p);
    }
    sheet.factors(steps);
    if let Some(elastic) = &ground.elastic {
        sheet.elastic(steps, elastic);
    }
}

/// The conditions of what begins.
pub(super) fn decision(steps: &mut SheetSteps, assessed: &Assessed) {
    steps.heading("Mode of response: the conditions of this base");
    steps.note(
        "The report’s inequalities hold for a rigid base, and do not decide here. The mode that begins satisfies the equations of motion below, \
         Coulomb’s law, and what the base bears.",
    );
    for relation in assessed.because() {
        if let Some(motion) = assessed.motion() {
            steps.know("f_y", motion.f_y, KILONEWTON);
        }
        steps.relation(&relation);
    }
}

struct Sheet<'a> {
    inputs: &'a Inputs,
    assessed: &'a Assessed,
    components: &'a [Component],
    foundation: &'a Foundation,
    ground: &'a BaseResponse,
    reaction: &'a Reaction,
    /// The length, where forces are of the whole object.
    long: &'static str,
}

impl Sheet<'_> {
    /// A number of the library per metre run, of the whole where forces are.
    fn whole(&self, per_metre: f64) -> f64 {
        let body = self.assessed.situation.body();
        per_metre * body.plan().side(body.width())
    }

    fn crushing(&self, steps: &mut SheetSteps, strength: f64) {
        match self.inputs.number(Key::Strength).filter(|given| *given != strength) {
            Some(given) => {
                let words = format!("{}/{}", self.assessed.output.pressure(given), plain(given / strength));
                steps.told("Strength of the base, divided", "q_u", strength, KILOPASCAL, &words, "");
            }
            None => steps.know("q_u", strength, KILOPASCAL),
        }
        let long = self.long;
        let omega = self.ground.omega.unwrap_or_default();
        let formula = format!("V/(B_c q_u{long})");
        steps.add(
            "Share of the base that the vertical load crushes",
            "",
            ["ω", &formula],
            omega,
            NONE,
            "omega",
        );
        let motion = self.assessed.motion().filter(|_| self.ground.neutral().is_some());
        if let (Some(neutral), Some(motion)) = (self.ground.neutral(), motion) {
            steps.know("f_y", motion.f_y, KILONEWTON);
            let about = "Neutral point, inside the edge that goes down: the width that is crushed, of the reaction at onset below";
            let formula = format!("f_y/(q_u{long})");
            steps.add(about, "", ["c_n", &formula], neutral, METRE, "neutral");
            let about = "Place of the reaction, inside that edge";
            steps.add(about, "", ["c_p", "c_n/2"], neutral / 2.0, METRE, "pivot");
        } else if let Some(pivot) = self.ground.pivot() {
            let about = "Place of the reaction inside its edge, of a body about to turn";
            let formula = format!("V/(2 q_u{long})");
            steps.add(about, "", ["c_p", &formula], pivot, METRE, "pivot");
        }
        let resistance = self.ground.resistance.unwrap_or_default();
        let formula = format!("B' q_u{long}");
        let about = "What the base bears at this eccentricity";
        steps.add(about, "", ["R", &formula], resistance, KILONEWTON, "ground_resistance");
    }
}

/// The effective width and the pressure on it, under the names of the JSON.
fn width(steps: &mut SheetSteps, reaction: &Reaction, extent: Extent, keys: [&str; 2]) {
    let about = "Resultant of all loads, right of the middle of the base";
    steps.add(about, "", ["e_b", "(X y_C − M)/V − (b_2 − b_1)/2"], reaction.e(), METRE, "");
    let (width, pressure) = (reaction.effective_width(), reaction.effective_pressure());
    let about = "Effective width, which has the resultant in its middle";
    if width > 0.0 {
        steps.add(about, "Meyerhof", ["B'", "B_c − 2 |e_b|"], width, METRE, keys[0]);
        let formula = if extent == Extent::Whole { "V/(B' L_b)" } else { "V/B'" };
        steps.add("Pressure on it", "", ["p_b", formula], pressure, KILOPASCAL, keys[1]);
    } else {
        let words = "the resultant misses the base";
        steps.told(about, "B'", width, METRE, words, keys[0]);
        steps.told("Pressure on it", "p_b", pressure, KILOPASCAL, words, keys[1]);
    }
}
