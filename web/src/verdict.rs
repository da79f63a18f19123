//! Panel of the answer: verdict, inequalities, factors, motion, changes of mode.

use serde::Serialize;
use standfast::initiation::Crossing;
use standfast::relation::Relation;
use standfast::{InputError, Mode, Modes, Motion, Stage};

use crate::answer::PageAnswer;
use crate::loads::{UP_TO, departure_words};
use crate::state::State;
use crate::text::{mathematics, symbol};
use crate::unit::{FORCES, LENGTHS, shown};

/// The verdict under all loads, with its reasons. Strings are HTML unless named `plain`.
#[derive(Debug, Serialize, Default)]
pub struct PageVerdict {
    /// The mode's symbol in plain characters; empty without an answer.
    pub mode: &'static str,
    symbol: String,
    /// Loads that the verdict is of, if there are others than the force.
    scope: String,
    /// "The body slides to the left"
    sentence: String,
    /// The mode's colour as CSS.
    tint: String,
    unique: bool,
    uniqueness: String,
    /// The verdict for a screen reader.
    plain: String,
    relations: Vec<Row>,
    failed: Vec<Failed>,
    factors: Vec<Factor>,
    departure: String,
    along_k: Changes,
    along_mu: Changes,
    motion: Vec<Quantity>,
}

/// Changes of mode while one thing grows.
#[derive(Debug, Serialize, Default)]
struct Changes {
    heading: &'static str,
    rows: Vec<Change>,
    /// Words where there are none.
    none: &'static str,
}

#[derive(Debug, Serialize)]
struct Change {
    at: String,
    force: Option<String>,
    from: String,
    to: String,
}

#[derive(Debug, Serialize)]
struct Row {
    equation: String,
    statement: String,
    values: String,
    margin: String,
}

#[derive(Debug, Serialize)]
struct Failed {
    symbol: String,
    rows: Vec<Row>,
}

#[derive(Debug, Serialize)]
struct Factor {
    name: &'static str,
    formula: String,
    value: String,
    holds: bool,
}

#[derive(Debug, Serialize)]
struct Quantity {
    symbol: &'static str,
    words: &'static str,
    value: String,
    unit: &'static str,
    real: String,
}

impl PageVerdict {
    /// The verdict of a state, of which `answer` is the answer.
    pub fn of(state: &State, answer: &Result<PageAnswer, String>) -> PageVerdict {
        let found = answer.as_ref().map_err(String::clone);
        found
            .and_then(|answer| PageVerdict::found(state, answer).map_err(|error| error.to_string()))
            .unwrap_or_else(|fault| PageVerdict {
                symbol: "—".to_owned(),
                scope: scope(state, None),
                sentence: format!("No answer. {fault}"),
                tint: "none".to_owned(),
                unique: true,
                plain: format!("No answer. {fault}"),
                ..PageVerdict::default()
            })
    }

    fn found(state: &State, answer: &PageAnswer) -> Result<PageVerdict, InputError> {
        let PageAnswer { mode, others, motion, factors, .. } = *answer;
        let scope = scope(state, Some(answer));
        let lifted = answer.full.as_ref().is_some_and(|(_, outcome)| outcome.full.is_lifted());
        let lift = if lifted { "All loads together no longer press downwards. " } else { "" };
        let words = mode.words().replace('\'', "′");
        let factors = match factors.map(|factors| factors.map(plain)) {
            Some([sliding, overturning]) => {
                format!("Factors of safety: sliding {sliding}, overturning {overturning}.")
            }
            None => "There are no factors of safety.".to_owned(),
        };
        // A body at rest is never said to rest without the lesser of its factors.
        let lesser =
            answer.factors.filter(|_| mode == Mode::Rest && !lifted).map_or(String::new(), |factors| {
                let [sliding, overturning] = factors;
                let (factor, against) =
                    if overturning < sliding { (overturning, "overturning") } else { (sliding, "sliding") };
                match factor.is_finite() {
                    true => format!(", with a safety factor of {} against {against}", plain(factor)),
                    false => String::new(),
                }
            });
        let orient = |mode| answer.point.map_or(mode, |reduced| reduced.orient(mode));
        let failed = |step: &standfast::initiation::Step| Failed {
            symbol: symbol(orient(step.mode)),
            rows: step.relations.iter().filter(|relation| !relation.holds).map(Row::of).collect(),
        };
        Ok(PageVerdict {
            mode: mode.symbol(),
            symbol: symbol(mode),
            sentence: format!("{lift}The body {words}{lesser}."),
            tint: standfast_figures::tint_on_screen(mode),
            unique: others.is_empty(),
            uniqueness: uniqueness(answer, orient(Mode::RockO)),
            plain: format!(
                "{}{}: {lift}the body {words}{lesser}. {} {factors}",
                if state.waters.are_none() { "" } else { "Under all loads, water and uplift included. " },
                mode.symbol().replace('\'', "′").replace('-', "−"),
                if others.is_empty() { "The answer is unique." } else { "The answer is not unique." },
            ),
            scope,
            relations: answer.relations.iter().map(Row::of).collect(),
            failed: answer.tried.iter().map(failed).collect(),
            factors: factor_rows(answer),
            departure: leaves_rest(state, answer)?,
            along_k: along_k(state, answer)?,
            along_mu: along_mu(answer),
            motion: quantities(state, &motion, answer.real.as_ref()),
        })
    }
}

impl Row {
    fn of(relation: &Relation) -> Row {
        let Relation { equation, left, sign, right, .. } = *relation;
        let sign = mathematics(&sign.to_string());
        Row {
            equation: equation.to_owned(),
            statement: mathematics(&relation.statement()),
            values: format!("{} {sign} {}", shown(left), shown(right)),
            margin: shown(relation.margin().abs()),
        }
    }
}

/// Loads that the verdict is of; empty for the force alone.
fn scope(state: &State, answer: Option<&PageAnswer>) -> String {
    let waters = &state.waters;
    if waters.are_none() {
        return String::new();
    }
    let parts = [
        Some("the force"),
        (waters.sea != 0.0 || waters.lee != 0.0).then_some("still water"),
        (waters.uplift != 0.0).then_some("uplift"),
    ];
    let parts: Vec<_> = parts.into_iter().flatten().collect();
    let (last, others) = parts.split_last().unwrap_or((&"", &[]));
    let effect = match answer.map(|answer| answer.point) {
        None => String::new(),
        Some(Some(reduced)) => format!(
            " Together they are <i>k</i><sub>eff</sub> = {} at <i>k</i>′<sub>eff</sub> = {}; below, <i>k</i> and <i>k</i>′ \
             are these.",
            shown(reduced.point.k()),
            shown(reduced.point.k_prime())
        ),
        Some(None) => " Together they are no point of the diagram.".to_owned(),
    };
    format!("Under all loads: {} and {last}.{effect}", others.join(", "))
}

fn factor_rows(answer: &PageAnswer) -> Vec<Factor> {
    let formulas = match answer.full {
        None => [mathematics("μ/k"), mathematics("1/(k γ |1+k'|)")],
        Some(_) => [mathematics("μ P/|X|"), "resisting by turning moment, lesser corner".to_owned()],
    };
    let rows = ["sliding", "overturning"].into_iter().zip(formulas).zip(answer.factors.into_iter().flatten());
    rows.map(|((name, formula), value)| Factor { name, formula, value: shown(value), holds: value >= 1.0 })
        .collect()
}

fn leaves_rest(state: &State, answer: &PageAnswer) -> Result<String, InputError> {
    if let Some((_, outcome)) = &answer.full {
        return Ok(departure_words(&outcome.departure));
    }
    let first = answer.margins().and_then(|margins| margins.leaves_rest());
    let Some(crossing) = first else {
        return Ok("No force at this elevation moves the body against this friction.".to_owned());
    };
    let mode = answer.point.map_or(crossing.to, |reduced| reduced.orient(crossing.to));
    if crossing.at == 0.0 {
        return Ok(format!(
            "Any force at this elevation moves the body, however small, into {}.",
            symbol(mode)
        ));
    }
    let real = force(state, crossing.at).map_or(String::new(), |force| format!(", {force}"));
    let words = mode.words().replace('\'', "′");
    Ok(format!("<i>k</i> = {}{real}: beyond, the body {words} ({}).", shown(crossing.at), symbol(mode)))
}

/// In air as k grows; with water as the force and its uplift grow together.
fn along_k(state: &State, answer: &PageAnswer) -> Result<Changes, InputError> {
    let Some((situation, outcome)) = &answer.full else {
        let at =
            |crossing: &Crossing| (format!("<i>k</i> = {}", shown(crossing.at)), force(state, crossing.at));
        return Ok(Changes {
            heading: "As the force grows",
            rows: answer.margins().map_or(Vec::new(), |margins| rows(answer, &margins.along_k, at)),
            none: "It does not.",
        });
    };
    let mut before = situation.at(0.0)?.mode();
    let mut rows = Vec::new();
    let name = |mode: Option<Mode>| mode.map_or(String::new(), symbol);
    for stage in Stage::up_to(&outcome.path, UP_TO) {
        let mode = stage.mode();
        if mode != before {
            let at = format!("<i>λ</i> = {}", shown(stage.from));
            rows.push(Change {
                at,
                force: force(state, stage.from * state.force),
                from: name(before),
                to: name(mode),
            });
        }
        before = mode;
    }
    let heading = "As the force and its uplift grow, to twice the load";
    Ok(Changes { heading, rows, none: "It does not, up to twice the load." })
}

fn along_mu(answer: &PageAnswer) -> Changes {
    let at = |crossing: &Crossing| (format!("<i>μ</i> = {}", shown(crossing.at)), None);
    let (rows, none) = match answer.margins() {
        Some(margins) => (rows(answer, &margins.along_mu, at), "It does not."),
        None => (Vec::new(), "Not known: these loads are no point of the diagram."),
    };
    Changes { heading: "As the friction grows", rows, none }
}

fn rows(
    answer: &PageAnswer,
    crossings: &[Crossing],
    at: impl Fn(&Crossing) -> (String, Option<String>),
) -> Vec<Change> {
    let name = |mode| symbol(answer.point.map_or(mode, |reduced| reduced.orient(mode)));
    let row = |crossing: &Crossing| {
        let (at, force) = at(crossing);
        Change { at, force, from: name(crossing.from), to: name(crossing.to) }
    };
    crossings.iter().map(row).collect()
}

/// A number for a screen reader.
fn plain(value: f64) -> String {
    if value.is_infinite() { "infinite".to_owned() } else { standfast_figures::significant(value, 3) }
}

/// A force of k in the unit chosen.
fn force(state: &State, k: f64) -> Option<String> {
    let (name, scale) = FORCES[state.units.force];
    let at = State { force: k, ..state.clone() };
    at.real().map(|(_, force)| format!("<i>F</i> = {} {name}", shown(force.magnitude() / scale)))
}

fn uniqueness(answer: &PageAnswer, rock: Mode) -> String {
    let PageAnswer { mode, others, .. } = *answer;
    if others.is_empty() {
        return "The answer is unique.".to_owned();
    }
    let list = |modes: Modes| modes.iter().map(symbol).collect::<Vec<_>>().join(" and ");
    let slowly = match answer.full {
        // The load's path may have come another way.
        Some(_) => String::new(),
        None => format!(
            "; under a slowly raised force the body has already begun to rock, and stays in {}",
            symbol(rock)
        ),
    };
    format!(
        "Not unique: {} also {} every law. This is Painlevé’s indeterminacy; rigid-body mechanics cannot choose. {} is \
         the report’s choice (section IV.7), which a sudden force favours{slowly}.",
        list(others),
        if others.len() == 1 { "satisfies" } else { "satisfy" },
        symbol(mode),
    )
}

fn quantities(state: &State, motion: &Motion, real: Option<&Motion>) -> Vec<Quantity> {
    let (force_name, force_scale) = FORCES[state.units.force];
    let (length_name, length_scale) = LENGTHS[state.units.length];
    let quantity = |symbol, words, of: fn(&Motion) -> f64, unit, scale: f64, real_unit: &str| Quantity {
        symbol,
        words,
        value: shown(of(motion)),
        unit,
        real: real.map_or(String::new(), |real| format!("{} {real_unit}", shown(of(real) / scale))),
    };
    let (linear, angular) = (("<i>g</i>", "m/s²"), ("<i>g</i>/<i>B</i>", "rad/s²"));
    vec![
        quantity("<i class=dd>x</i>", "centre, to the right", |m| m.x_ddot, linear.0, 1.0, linear.1),
        quantity("<i class=dd>y</i>", "centre, upwards", |m| m.y_ddot, linear.0, 1.0, linear.1),
        quantity("<i class=dd>θ</i>", "counter-clockwise", |m| m.theta_ddot, angular.0, 1.0, angular.1),
        quantity(
            "<i>f<sub>x</sub></i>",
            "reaction, to the right",
            |m| m.f_x,
            "<i>m g</i>",
            force_scale,
            force_name,
        ),
        quantity(
            "<i>f<sub>y</sub></i>",
            "reaction, upwards",
            |m| m.f_y,
            "<i>m g</i>",
            force_scale,
            force_name,
        ),
        quantity(
            "<i>ξ</i>",
            "of <i>f<sub>y</sub></i>, right of <i>C</i>",
            |m| m.xi,
            "<i>B</i>",
            length_scale,
            length_name,
        ),
        quantity(
            "<i class=dd>x</i><i><sub>O</sub></i>",
            "both corners, along the base",
            |m| m.slip,
            linear.0,
            1.0,
            linear.1,
        ),
        quantity(
            "<i class=dd>y</i><i><sub>O</sub></i>",
            "left corner, upwards",
            |m| m.lift_o,
            linear.0,
            1.0,
            linear.1,
        ),
        quantity(
            "<i class=dd>y</i><i><sub>O′</sub></i>",
            "right corner, upwards",
            |m| m.lift_o_prime,
            linear.0,
            1.0,
            linear.1,
        ),
    ]
}
