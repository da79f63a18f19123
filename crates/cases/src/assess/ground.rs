//! The ground for reading.

use standfast::ground::elastic::ContactState;
use standfast::ground::impact::{EventFound, ImpactEvent};
use standfast_answers::assess::ground::{BaseResponse, Elastic};

use super::Assessed;
use crate::case::{Case, ChangeBy, Combination, InputChange, Limit};
use crate::key::Table;
use crate::layout::{self, columns, digits, paragraph, percent, row};
use crate::units::Dimension;

/// That no partial factor is applied to what the ground bears.
const NO_FACTOR: &str =
    "No partial factor is applied to the ground: neither to its strength or friction angle, nor to R.";

const CRUSHING: &str = "The base bears a pressure up to q_u and no tension; it is rigid until then. This is the first instant: once its edge is crushed, the body \
    stands on another base.";

/// What the formulas of soil hold for, and what they leave out.
macro_rules! of_soil {
    ($holds:literal) => {
        concat!(
            $holds,
            " Left out: the shoulder of a berm, slopes, layers, pore pressure and its growth under cycles of load, seepage from uplift, punching. \
             The friction angle of a mound is uncertain: read the load factor with those at 2° less and more. Where the body would turn, the \
             ground under its edge fails first."
        )
    };
}

const SOIL: &str = of_soil!("The formulas hold for level, homogeneous, drained ground under a long strip.");

const SHORT: &str = of_soil!(
    "The formulas hold for level, homogeneous, drained ground; the base of the given length has shape factors."
);

const CLAY: &str = "Below a B'c_u/|X| of 1 the body slides within the clay, and R is 0; SF_sliding is that of friction on the base alone. The formula holds for level, homogeneous clay that does not drain. Left out: depth of the base, layers, loss of strength under cycles of load, \
    and what the clay becomes as it drains: ask for that with its angle of friction.";

const ENVELOPE: &str = "The resistance of the whole base is given by the user. Butterfield and Gottardi's envelope tells how much of it is left under a force that is inclined \
    and eccentric. Left out: pore pressure and its growth under cycles of load, and all that the resistance given does not contain.";

const ELASTIC: &str = "k_n and k_t are not constants of a soil: they depend on the size of the base and of the load. The mode under the full load is that of a base without \
    springs.";

const IN_TIME: &str = "In time the base is linear and without damping up to its first event; loads of which no history is given are there all the time. One period alone \
    would not be on the safe side, and its factor is not given.";

const OFF_MIDDLE: &str = "The centre of mass is off the middle of the base: sway, rocking and heave are one motion, and no periods are given.";

/// Notes on the effects of the ground that the answer leaves out, in sentences.
pub fn left_out(case: &Case) -> Vec<&'static str> {
    let Some(foundation) = &case.ground else { return Vec::new() };
    let mut notes = Vec::new();
    let divides = |combination: &Combination| {
        let by_material = |change: &InputChange| {
            matches!(change.by, ChangeBy::Material(_)) && change.id.table == Table::Ground
        };
        combination.bearing != 1.0 || combination.changes.iter().any(by_material)
    };
    if foundation.limit.is_some() && !case.combinations.iter().any(divides) {
        notes.push(NO_FACTOR);
    }
    match foundation.limit {
        Some(Limit::Strength(_)) => notes.push(CRUSHING),
        Some(Limit::Ground(ground)) if ground.undrained_strength().is_some() => notes.push(CLAY),
        Some(Limit::Ground(ground)) if ground.length().is_some() => notes.push(SHORT),
        Some(Limit::Ground(ground)) if ground.friction_angle_deg().is_some() => notes.push(SOIL),
        Some(Limit::Ground(_)) => notes.push(ENVELOPE),
        None => {}
    }
    if foundation.stiffness.is_some() {
        notes.push(ELASTIC);
    }
    let centred = case.body.heel_distance() == case.body.toe_distance();
    if foundation.tangential_stiffness.is_some() && !centred {
        notes.push(OFF_MIDDLE);
    }
    let timed = case.forces.iter().any(|force| force.history.is_some());
    if timed || case.wave.as_ref().is_some_and(|wave| wave.history.is_some()) {
        notes.push(IN_TIME);
    }
    notes
}

/// c_u of clay that does not drain, Pa.
fn clay(ground: &BaseResponse) -> Option<f64> {
    match ground.limit {
        Some(Limit::Ground(soil)) => soil.undrained_strength(),
        _ => None,
    }
}

/// Contact state of an elastic base, in words.
pub fn state(state: ContactState) -> &'static str {
    match state {
        ContactState::Full => "all of the base is pressed, elastically",
        ContactState::Uplift => "part of the base lifts",
        ContactState::Yield => "all of the base is pressed, and its edge yields",
        ContactState::UpliftAndYield => "part of the base lifts, and its edge yields",
    }
}

pub(in super::super) fn render(case: &Case, assessed: &Assessed) -> String {
    let (Some(foundation), Some(ground)) = (&case.ground, &assessed.ground) else { return String::new() };
    let mut rows = Vec::new();
    match foundation.limit {
        Some(Limit::Strength(strength)) => {
            rows.push(row!["strength", "q_u", case.output.pressure(strength)]);
            if let Some(omega) = ground.omega {
                rows.push(row!["share that V crushes", "ω = V/(2B q_u)", digits(omega)]);
            }
        }
        Some(Limit::Ground(soil)) => {
            let told = match (soil.friction_angle_deg().zip(soil.factors()), soil.undrained_strength()) {
                (_, Some(strength)) => {
                    format!("clay that does not drain, c_u = {}", case.output.pressure(strength))
                }
                (Some((angle, factors)), None) => {
                    format!(
                        "φ = {}°: N_q = {}, N_γ = {}",
                        digits(angle),
                        digits(factors.n_q),
                        digits(factors.n_gamma)
                    )
                }
                _ => "the envelope of Butterfield and Gottardi".to_owned(),
            };
            rows.push(row!["ground", "", told]);
            let whole = soil.centric_resistance(case.body.base_width() / 2.0);
            let length = case.body.plan().side(case.body.width());
            rows.push(row!["bears upright", "V_0", assessed.output.force(whole * length)]);
        }
        None => {}
    }
    rows.extend(reaction(assessed, ground));
    if let Some(elastic) = &ground.elastic {
        rows.extend(of_springs(elastic));
    }
    let mut text = format!("\nGround\n{}", columns(&rows, 2, &[]));
    if ground.reaction.is_none() {
        text += &paragraph("Nothing presses on the base: there is no resistance and no factor.", 2);
    }
    if let Some(elastic) = ground.elastic.as_ref().filter(|elastic| elastic.rotation.is_none()) {
        let words = format!(
            "No rotation bears the moment of the full load: the most is {} about the middle of the base.",
            assessed.output.moment(elastic.largest.moment * case.body.plan().side(case.body.width()))
        );
        text += &paragraph(&words, 2);
    }
    for note in left_out(case) {
        text += &paragraph(note, 2);
    }
    text
}

/// Rows of the reaction and of the resistance to it.
fn reaction(assessed: &Assessed, ground: &BaseResponse) -> Vec<Vec<String>> {
    let output = assessed.output;
    let mut rows = Vec::new();
    if let Some(pivot) = ground.pivot().filter(|_| ground.omega.is_some_and(|omega| omega < 1.0)) {
        let acts = if ground.neutral().is_some() { "acts" } else { "acts as a turn begins" };
        rows.push(row![
            "pivot",
            "from the edge",
            format!("{}, where the reaction {acts}", output.length(pivot))
        ]);
    }
    if let Some(neutral) = ground.neutral() {
        rows.push(row![
            "neutral point",
            "from the edge",
            format!("{}, about which it turns", output.length(neutral))
        ]);
    }
    if let Some(reaction) = &ground.reaction {
        rows.push(row!["effective width", "B' = 2(B − |e|)", output.length(reaction.effective_width())]);
        let pressure = reaction.effective_pressure();
        let pressure = if pressure.is_finite() { output.pressure(pressure) } else { "none".to_owned() };
        rows.push(row!["pressure on it", "V/B'", pressure]);
    }
    if let (Some(strength), Some(reaction)) = (clay(ground), &ground.reaction) {
        let factor = reaction.effective_width() * strength / reaction.x().abs();
        let factor = if factor.is_finite() { output.factor(factor) } else { "no push".to_owned() };
        rows.push(row!["sliding in the clay", "B'c_u/|X|", factor]);
    }
    if let Some(resistance) = ground.resistance {
        rows.push(row!["resistance", "R", assessed.output.force(resistance)]);
    }
    if let Some(factor) = ground.factor {
        rows.push(row!["ground factor", "R/V", output.factor(factor)]);
    }
    if let Some(factors) = ground.load_factors.filter(|_| assessed.rises()) {
        let word = |factor: f64| match factor {
            0.0 => "at once".to_owned(),
            factor if factor.is_finite() => layout::factor(factor),
            _ => "never".to_owned(),
        };
        let others = factors.less.zip(factors.more);
        let others = others.map_or(String::new(), |(less, more)| {
            format!("; {} at φ − 2°, {} at φ + 2°", word(less), word(more))
        });
        rows.push(row!["ground fails at", "λ of R/V = 1", word(factors.given) + &others]);
    }
    if let Some(k_bf) = ground.k_bf.filter(|k| k.is_finite()) {
        rows.push(row!["", "k_BF", digits(k_bf)]);
    }
    rows
}

/// Rows of the elastic response.
fn of_springs(elastic: &Elastic) -> Vec<Vec<String>> {
    let mut rows = Vec::new();
    if let Some(rotation) = elastic.rotation {
        let pressed = elastic.base.state(rotation).map_or("", state);
        rows.push(row!["rotation", "θ", format!("{}; {pressed}", Dimension::Angle.written(rotation))]);
    }
    if let Some(k) = elastic.k_overturn.filter(|k| k.is_finite()) {
        let turned = Dimension::Angle.written(elastic.largest.rotation);
        rows.push(row!["overturns at", "k_overturn", format!("{}, turned by {turned}", digits(k))]);
    }
    if let Some([one, two, heave]) = elastic.periods {
        let periods = format!("{} s and {} s; heave {} s", digits(one), digits(two), digits(heave));
        rows.push(row!["natural periods", "", periods]);
    }
    let Some(impact) = &elastic.impact else { return rows };
    if let Some(shear) = impact.d_shear {
        rows.push(row!["in time", "D_shear", digits(shear)]);
    }
    if let Some(moment) = impact.d_moment {
        rows.push(row!["", "D_moment", digits(moment)]);
    }
    if let Some([k, k_prime]) = elastic.moved {
        rows.push(row!["the point moves to", "k, k'", format!("{}, {}", digits(k), digits(k_prime))]);
    }
    let words = |found: &EventFound| {
        let factor = match found.load_factor {
            factor if factor.is_finite() => format!("at {} times the loads in time", digits(factor)),
            _ => "at no multiple of the loads in time".to_owned(),
        };
        match found.time {
            Some(time) => format!("after {} s; {factor} at the least", digits(time)),
            None => format!("not; {factor}"),
        }
    };
    for (i, found) in impact.events.iter().enumerate() {
        rows.push(row![if i == 0 { "events" } else { "" }, event_words(found.event), words(found)]);
    }
    rows
}

fn event_words(event: ImpactEvent) -> &'static str {
    match event {
        ImpactEvent::Slip => "the base slips",
        ImpactEvent::Lift => "an edge lifts",
        ImpactEvent::Yield => "an edge yields",
    }
}

/// Event that first ends the rest of a body on springs under loads in time; `None` where none is given.
pub(super) fn first_event(assessed: &Assessed) -> Option<&EventFound> {
    let impact = assessed.ground.as_ref()?.elastic.as_ref()?.impact.as_ref()?;
    impact.events.iter().min_by(|one, two| one.load_factor.total_cmp(&two.load_factor))
}

/// That event in a sentence, without its capital.
pub(super) fn in_time(found: &EventFound) -> String {
    let (words, at) = (event_words(found.event), percent(found.load_factor));
    match found.time {
        Some(time) => {
            format!("in time {words} after {} s, and does from {at} of these loads on.", digits(time))
        }
        None if found.load_factor.is_finite() => format!("in time {words} at {at} of these loads."),
        None => "in time no multiple of these loads moves it.".to_owned(),
    }
}
