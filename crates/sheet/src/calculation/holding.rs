//! What holds a body beside friction: adhesion, resistances, and their part in the checks.

use standfast::contact::holding::AdhesionArea;
use standfast::{Corner, Held, Wrench};
use standfast_cases::assess::holding::{place, told};
use standfast_cases::case::{Direction, Resistance};
use standfast_cases::layout::digits;
use standfast_cases::{Assessed, Case};

use crate::measured::{KILONEWTON, KILOPASCAL, METRE, MOMENT};
use crate::steps::SheetSteps;

/// Terms that what holds a body adds to the formulas of the checks; empty where it adds none.
#[derive(Debug, Clone, Default)]
pub(super) struct HeldTerms {
    /// To μ (W' − U): adhesion, and what acts against the push.
    pub(super) sliding: String,
    /// To the moments that hold the body about heel and toe.
    pub(super) heel: &'static str,
    pub(super) toe: &'static str,
    /// To the moment of the resultant about the heel, and to what presses.
    pub(super) resultant: &'static str,
    pub(super) pressing: &'static str,
    /// To X, V and M in the motion.
    pub(super) motion: [&'static str; 3],
}

/// A resistance in a situation, with its symbol.
struct Named<'a> {
    resistance: &'a Resistance,
    symbol: String,
    pressing: f64,
    used: f64,
}

impl Named<'_> {
    fn direction(&self) -> f64 {
        match self.resistance.direction {
            Direction::Sideways(side) => side.sign(),
            _ => 0.0,
        }
    }

    /// The moment about a corner of the base by which a force of one holds the body, m.
    fn lever(&self, corner: Corner, base: f64) -> f64 {
        let Resistance { elevation, distance, .. } = self.resistance;
        match (distance.filter(|_| self.direction() == 0.0), corner) {
            (Some(distance), Corner::O) => distance,
            (Some(distance), Corner::OPrime) => base - distance,
            (None, Corner::O) => self.direction() * elevation,
            (None, Corner::OPrime) => -self.direction() * elevation,
        }
    }
}

/// Shows what holds the body of a situation, before the checks.
pub(super) fn steps(steps: &mut SheetSteps, case: &Case, assessed: &Assessed) -> HeldTerms {
    let mut terms = HeldTerms::default();
    let Some((resistances, held)) = told(case, assessed) else { return terms };
    let under = case.under(assessed.acting);
    let body = assessed.situation.body();
    let base = body.base_width();
    steps.heading("Held beside friction");
    let named: Vec<Named> = resistances
        .iter()
        .enumerate()
        .map(|(index, resistance)| Named {
            resistance,
            symbol: format!("R_{}", index + 1),
            pressing: held.pressing[index],
            used: held.used[index],
        })
        .collect();
    for (one, needed) in named.iter().zip(0..) {
        limit(steps, assessed, one, held.needed.map(|all| all[needed]));
    }
    let heel = assessed.outcome.actions.heel;
    let toe = if heel == Corner::O { Corner::OPrime } else { Corner::O };
    let about = |corner: Corner| {
        named
            .iter()
            .map(move |one| (one, one.lever(corner, base)))
            .filter(|(one, lever)| *lever > 0.0 && one.resistance.counted() > 0.0)
    };
    for (corner, word, name) in [(heel, "heel", "M_R"), (toe, "toe", "M_Rt")] {
        let held: Vec<_> = about(corner).collect();
        if held.is_empty() {
            continue;
        }
        let sum = held.iter().map(|(one, lever)| one.resistance.counted() * lever).sum();
        let of: Vec<String> = held
            .iter()
            .map(|(one, lever)| {
                let arm =
                    format!("l_{}{}", one.symbol.replace('_', ""), if word == "heel" { "h" } else { "t" });
                steps.know(&arm, *lever, METRE);
                format!("{} {arm}", one.symbol)
            })
            .collect();
        let about = format!("Moment about the {word} of the resistances that hold the body there, in full");
        steps.add(&about, "", [name, &of.join(" + ")], sum, MOMENT, "");
        match word {
            "heel" => terms.heel = " + M_R",
            _ => terms.toe = " + M_Rt",
        }
    }
    press(steps, &named, heel, base, &mut terms);
    let x = assessed.outcome.full.wrench.x;
    let against: Vec<&Named> = named.iter().filter(|one| one.direction() * x < 0.0).collect();
    if !against.is_empty() && held.against > 0.0 {
        let of: Vec<&str> = against.iter().map(|one| one.symbol.as_str()).collect();
        steps.add("What acts against the push", "", ["R_a", &of.join(" + ")], held.against, KILONEWTON, "");
        terms.sliding += " + R_a";
    }
    if let Some(adhesion) = under.adhesion {
        adhering(steps, assessed, &held, adhesion.strength, adhesion.on, &terms);
        terms.sliding = format!(" + C_a{}", terms.sliding);
    }
    terms.motion = in_motion(steps, assessed, &named);
    terms
}

/// What the resistances add to what presses on the base, and to its moment about the heel.
fn press(steps: &mut SheetSteps, named: &[Named<'_>], heel: Corner, base: f64, terms: &mut HeldTerms) {
    let all: Vec<(&Named, String, f64)> = named
        .iter()
        .filter(|one| one.pressing > 0.0)
        .map(|one| (one, one.symbol.replace("R_", "q_"), one.lever(heel, base)))
        .collect();
    if all.is_empty() {
        return;
    }
    for (one, symbol, lever) in &all {
        let about = format!("Of {}, as the base is pressed", one.resistance.name);
        let words =
            "of all with which the body rests, what brings the resultant nearest to the middle of the base";
        steps.told(&about, symbol, one.pressing, KILONEWTON, words, "");
        steps.know(&format!("l_{}", symbol.replace('_', "")), *lever, METRE);
    }
    let sum = all.iter().map(|(one, _, lever)| one.pressing * lever).sum();
    let of: Vec<_> =
        all.iter().map(|(_, symbol, _)| format!("{symbol} l_{}", symbol.replace('_', ""))).collect();
    steps.add("Their moment about the heel", "", ["M_q", &of.join(" + ")], sum, MOMENT, "");
    terms.resultant = " + M_q";
    let down: Vec<_> = all.iter().filter(|(one, ..)| one.direction() == 0.0).collect();
    if !down.is_empty() {
        let sum = down.iter().map(|(one, ..)| one.pressing).sum();
        let of: Vec<&str> = down.iter().map(|(_, symbol, _)| symbol.as_str()).collect();
        steps.add("What presses the body down", "", ["R_v", &of.join(" + ")], sum, KILONEWTON, "");
        terms.pressing = " + R_v";
    }
}

/// The limit of a resistance, and what rest needs of it.
fn limit(steps: &mut SheetSteps, assessed: &Assessed, one: &Named<'_>, needed: Option<f64>) {
    let Resistance { name, limit, share, divisor, .. } = one.resistance;
    let mut words = assessed.output.force(*limit);
    if *share != 1.0 {
        words += &format!(" × {}", digits(*share));
    }
    if *divisor != 1.0 {
        words += &format!("/{}", digits(*divisor));
    }
    let about = format!("The most that {name} holds, {}", place(one.resistance, assessed.output));
    steps.told(&about, &one.symbol, one.resistance.counted(), KILONEWTON, &words, "");
    let needs = format!("r_{}", one.symbol.trim_start_matches("R_"));
    match needed {
        Some(0.0) => steps.told("Rest needs", &needs, 0.0, KILONEWTON, "nothing of it", ""),
        Some(needed) => {
            let words = "the least with which all conditions of rest are met";
            steps.told("Rest needs", &needs, needed, KILONEWTON, words, "");
        }
        None => steps.note(&format!("The body does not rest with all of {name}.")),
    }
}

/// A' and what adheres.
fn adhering(
    steps: &mut SheetSteps,
    assessed: &Assessed,
    held: &Held,
    strength: f64,
    on: AdhesionArea,
    terms: &HeldTerms,
) {
    steps.know("c_a", strength, KILOPASCAL);
    let formula = format!("(W' t − M_U − M_p{})/(W' − U{})", terms.resultant, terms.pressing);
    match assessed.outcome.stability.resultant_arm {
        None => steps.told("Length of the base that adheres", "A_c", 0.0, METRE, "nothing presses", ""),
        Some(arm) => {
            let about = "Distance of the resultant from the heel, for what adheres";
            steps.add(about, "", ["t_a", &formula], arm, METRE, "");
            let (about, formula) = match on {
                AdhesionArea::Pressed => (
                    "Length of the base that adheres, what is pressed",
                    "max(min(B_c, 3 min(t_a, B_c − t_a)), 0)",
                ),
                AdhesionArea::Effective => (
                    "Length of the base that adheres, the effective width",
                    "max(min(B_c, 2 min(t_a, B_c − t_a)), 0)",
                ),
            };
            steps.add(about, "", ["A_c", formula], held.adhering, METRE, "");
        }
    }
    let long = match assessed.extent {
        standfast_cases::units::Extent::Whole => " L_b",
        standfast_cases::units::Extent::PerMetre => "",
    };
    let formula = format!("c_a A_c{long}");
    steps.add("What it adheres with", "", ["C_a", &formula], held.adhesion, KILONEWTON, "");
}

/// The sums of the resistances in the mode reported, as they stand beside X, V and M.
fn in_motion(steps: &mut SheetSteps, assessed: &Assessed, named: &[Named<'_>]) -> [&'static str; 3] {
    let used: Vec<&Named> = named.iter().filter(|one| one.used > 0.0).collect();
    if used.is_empty() {
        return [""; 3];
    }
    let holds = assessed.situation.holding().into_iter().flat_map(|holding| holding.holds());
    let sum = holds.zip(named).fold(Wrench::ZERO, |sum, (hold, one)| sum + hold.unit() * one.used);
    let words = "the resistances in this mode";
    let mut terms = [""; 3];
    let parts = [
        ("X_R", sum.x, " + X_R", KILONEWTON),
        ("V_R", sum.p, " + V_R", KILONEWTON),
        ("M_RC", sum.m, " + M_RC", MOMENT),
    ];
    for ((name, value, term, unit), to) in parts.into_iter().zip(&mut terms) {
        if value != 0.0 {
            let about = match name {
                "X_R" => "Their sum to the right",
                "V_R" => "Their sum downwards",
                _ => "Their moment about the centre of mass",
            };
            steps.told(about, name, value, unit, words, "");
            *to = term;
        }
    }
    terms
}
