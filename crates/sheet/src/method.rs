//! Assumptions and method, in words.

use maud::{Markup, html};
use standfast::Plan;
use standfast_cases::case::{CrownWall, JointWater, WaveFormula, Waves};
use standfast_cases::{Assessment, Case};

use crate::limits::Setting;
use crate::references;

pub fn words(assessment: &Assessment) -> Markup {
    let case = &assessment.case;
    html! {
        ul {
            li { (base(case)) " Friction is dry (Coulomb)."
                @if case.plan.is_none() { " Forces act in the plane of the cross-section." }
                @else { " Forces come from any horizontal direction; the base is rigid and its pressure free, within its outline seen from above." }
            }
            @if case.plan.is_some() {
                li {
                    "It is answered whether the body rests, and where it leaves rest as the variable loads rise: by sliding, or by tipping about an \
                     edge. How it then moves is not computed."
                }
            } @else {
            li {
                "Sections 2 to 4 answer for the first instant after the load is applied to a body at rest: which mode begins, with which \
                 accelerations and reactions."
                @if assessment.in_time.as_ref().is_some_and(|in_time| !in_time.motions.is_empty()) {
                    " Section 5 follows the motion in time."
                } @else { " The motion after that is not computed." }
            }
            }
            li {
                "Signs: x to the right, y upwards, rotation counter-clockwise. O is the bottom left corner of the base, O′ the \
                 bottom right one."
                @if case.wave.is_some() { " The sea is at the right; waves push to the left, and O is the heel." }
            }
            @if Setting::of(case).water { li { "Weight: " (case.weight_words()) "." } }
            li {
                "Permanent and variable loads act together. Variable ones" (variable(case)) " are applied at once for the mode of \
                 response, and raised in proportion for the load path."
                @if case.forces.iter().filter(|force| force.acts_alone()).count() > 1 && case.combinations.is_empty() {
                    " Of the forces that act alone, each is an alternative to the others."
                }
                @if !case.combinations.is_empty() {
                    " Loads act in the combinations of the case file, each times its factor there."
                    @if case.combinations.iter().all(|combination| combination.changes.is_empty()) {
                        " The body’s mass, its inertia and the friction carry no factor."
                    } @else {
                        " A factor on a load changes no mass, no inertia and no friction. What a combination changes besides stands at its head."
                    }
                }
            }
            @if let Some(words) = other_waves(case) { li { (words) } }
            @if let Some(wave) = case.goda() {
                li {
                    "Wave pressures after Goda"
                    @if wave.choices.impulsive { " with Takahashi’s coefficient for impulsive breaking" }
                    @else { " without the coefficient for impulsive breaking" }
                    @if wave.choices.uplift { "; the uplift is a triangle from the seaward toe to the heel." }
                    @else { "; by the case file, the waves do not press under the base." }
                    @if wave.choices.turn_deg == 0.0 { " The angle of the waves is used as given, not turned towards the normal." }
                }
            }
            @if case.water.is_some() {
                li {
                    "Still water presses on the sides and under the whole base, linearly from one edge of the base to the other."
                    @if case.section.is_some() {
                        " What stands on steps and slopes of the sides presses down, and lifts where the body overhangs."
                    }
                }
            }
            @if !case.joints.is_empty() {
                li {
                    "Each joint, the base among them, carries all that is above it, whatever the others do; so rest and departure are those of one body \
                     on each. Joints are level and rigid, without cohesion, tension or dowels."
                    @if case.joints.iter().any(|joint| joint.water == JointWater::Open) {
                        " Water in an open joint is straight from the pressure beside it at one end to that at the other."
                    }
                    @if case.joints.iter().any(|joint| joint.water == JointWater::Tight) { " In a tight joint there is none." }
                }
            }
            @if case.section.is_some() && case.wave.is_some() {
                li { "The waves press on the upright plane through the seaward edge; their pressure on steps and slopes is left out." }
            }
            @if case.body.plan() == Plan::Circle {
                li {
                    "The base bears as a circle that cannot pull, linearly where it is pressed. Pressures on a side act on the diameter, \
                     those under and above the body on its circle."
                }
            }
            @if !case.pressures.is_empty() {
                li { "Pressures given in the case file are linear from point to point, and zero outside." }
            }
            @if case.added_mass.mass() > 0.0 {
                li { "Water that moves with the body adds to its inertia against horizontal acceleration." }
            }
            @if case.earthquake.is_some() {
                li { "An acceleration of the base acts as a force of inertia; the motion is relative to the base." }
            }
            li {
                "Classical factors are taken about " (if case.plan.is_some() { "every edge" } else { "both edges" }) " of the base; " span.sym { "W′" } ", t, U, "
                span.sym { "M" sub { "U" } } ", P, " span.sym { "M" sub { "p" } } " are a designer’s symbols."
            }
        }
        (references::list(case))
    }
}

/// Sentence on the idealization of body and base.
fn base(case: &Case) -> &'static str {
    match case.ground {
        None => "Body and base are rigid.",
        Some(ground) if ground.strength().is_some() => {
            "The body is rigid. The base bears a pressure up to its strength, where it crushes, and no tension."
        }
        Some(ground) if ground.limit.is_some() => {
            "The body is rigid, and so is the ground until its bearing resistance is reached. Before a body turns, the ground under its edge \
             fails."
        }
        Some(_) => {
            "The body is rigid, and so is the base for the mode that begins; its stiffness gives the rotation and the periods."
        }
    }
}

/// True unless the case file says that the waves do not press under the base.
fn presses_under_base(wave: &Waves) -> bool {
    match &wave.formula {
        WaveFormula::Goda(wave) => wave.choices.uplift,
        WaveFormula::Sainflou(wave) => wave.wall.uplift,
        WaveFormula::Crown(_) => true,
    }
}

/// What waves by another formula than Goda's are taken for.
fn other_waves(case: &Case) -> Option<&'static str> {
    match &case.wave.as_ref()?.formula {
        WaveFormula::Goda(_) => None,
        WaveFormula::Sainflou(wave) if wave.wall.uplift => Some(
            "Waves stand before the wall and do not break: pressures after Sainflou with straight lines, beside those of still water. The              uplift falls from that at the base to nothing at the heel, which is recalled, not read.",
        ),
        WaveFormula::Sainflou(_) => Some(
            "Waves stand before the wall and do not break: pressures after Sainflou with straight lines, beside those of still water. By the              case file, they do not press under the base.",
        ),
        WaveFormula::Crown(wave) => Some(match wave.wall {
            CrownWall::Pedersen(_) => {
                "Forces on the crown wall after Pedersen, which 0.1 % of the waves exceed; the uplift is a triangle from the seaward edge to the heel."
            }
            CrownWall::VanGent(_) => {
                "Forces on the crown wall after Van Gent, which 2 % of the waves exceed. The formula gives no height of the force: half that of the                  wall is taken, and a triangle of uplift from the seaward edge."
            }
        }),
    }
}

/// Loads of the case that vary, in parentheses; nothing where none does.
fn variable(case: &Case) -> String {
    let forces = case.forces.iter().any(|force| !force.permanent);
    let pressures = case.pressures.iter().any(|pressure| !pressure.permanent);
    let kinds = [
        (case.wave.as_ref().is_some_and(presses_under_base), "waves with their uplift"),
        (case.wave.as_ref().is_some_and(|wave| !presses_under_base(wave)), "waves"),
        (case.uplift.as_ref().is_some_and(|uplift| uplift.grows()), "uplift"),
        (case.earthquake.is_some(), "the earthquake"),
        (pressures, "pressures"),
        (forces, "forces"),
    ];
    let kinds: Vec<_> = kinds.into_iter().filter(|(varies, _)| *varies).map(|(_, words)| words).collect();
    if kinds.is_empty() { String::new() } else { format!(" ({})", kinds.join(", ")) }
}
