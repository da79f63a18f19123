//! What the panel says about the design point.

use serde::Serialize;
use standfast::initiation::{Crossing, Relation};
use standfast::region::Strip;
use standfast::{Mode, Modes, Motion};

use crate::field::Field;
use crate::state::{GRAVITY, State};
use crate::text::{letter, mathematics, symbol};
use crate::unit::{FORCES, LENGTHS, MASSES, PRESSURES, Unit, shown};

/// Everything the panel says. Strings are HTML unless named `plain`.
#[derive(Debug, Serialize)]
pub struct Reading {
    /// The mode's symbol in plain characters.
    pub mode: &'static str,
    symbol: String,
    /// "The body slides to the left".
    sentence: String,
    /// The mode's colour as CSS.
    tint: &'static str,
    unique: bool,
    uniqueness: String,
    /// The verdict for a screen reader.
    plain: String,
    relations: Vec<Row>,
    /// The modes tried before, and why they fail.
    failed: Vec<Failed>,
    factors: Vec<Factor>,
    departure: String,
    along_k: Vec<Change>,
    along_mu: Vec<Change>,
    motion: Vec<Quantity>,
    case: String,
    points: Vec<[String; 3]>,
    /// Every field's text.
    fields: Vec<(&'static str, String)>,
    /// Every slider's place.
    sliders: Vec<(&'static str, f64)>,
    /// The units to choose from, and the one chosen, by kind.
    units: Vec<(&'static str, Vec<&'static str>, &'static str)>,
    mirrored: bool,
    figure: Option<&'static str>,
    /// Whether a chart of the plane is shown, not a sketch.
    is_map: bool,
    /// The numbers of [`standfast::Point`], for tests and scripts.
    pub numbers: Numbers,
}

/// The answer in numbers, non-dimensional; infinite ones are null.
#[derive(Debug, Serialize)]
pub struct Numbers {
    /// γ, k', k, μ.
    pub given: [f64; 4],
    /// ẍ, ÿ, θ̈, f_x, f_y, ξ, ẍ_O, ÿ_O, ÿ_O'.
    pub motion: [f64; 9],
    /// Against sliding and overturning.
    pub factors: [f64; 2],
    /// The other consistent modes.
    pub others: Vec<&'static str>,
}

#[derive(Debug, Serialize)]
struct Row {
    equation: String,
    statement: String,
    values: String,
    margin: String,
    holds: bool,
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
struct Change {
    at: String,
    force: Option<String>,
    from: String,
    to: String,
}

#[derive(Debug, Serialize)]
struct Quantity {
    symbol: &'static str,
    words: &'static str,
    value: String,
    unit: &'static str,
    real: String,
}

impl Reading {
    /// The reading of a state.
    pub fn of(state: &State) -> Reading {
        let reduced = state.reduced();
        let point = reduced.point;
        let (mode, others, motion) = (reduced.mode(), reduced.others(), reduced.motion());
        let trace = point.explain();
        let margins = point.margins();
        let factors = [point.safety_against_sliding(), point.safety_against_overturning()];
        let (tried, _) = trace.steps.split_at(trace.steps.len() - 1);
        let change = |crossing: &Crossing, of_force: bool| Change {
            at: shown(crossing.at),
            force: of_force.then(|| force(state, crossing.at)).flatten(),
            from: symbol(reduced.orient(crossing.from)),
            to: symbol(reduced.orient(crossing.to)),
        };
        let words = mode.words().replace('\'', "′");
        let unit = |units: &[Unit], chosen: usize| {
            (units.iter().map(|unit| unit.0).collect::<Vec<_>>(), units[chosen].0)
        };
        let units = &state.units;
        let units = [
            ("length", unit(&LENGTHS, units.length)),
            ("mass", unit(&MASSES, units.mass)),
            ("force", unit(&FORCES, units.force)),
            ("pressure", unit(&PRESSURES, units.pressure)),
        ];
        Reading {
            mode: mode.symbol(),
            symbol: symbol(mode),
            sentence: format!("The body {words}."),
            tint: standfast_figures::tint_on_screen(mode),
            unique: others.is_empty(),
            uniqueness: uniqueness(mode, others, reduced.orient(Mode::RockO)),
            plain: format!(
                "{}: the body {words}. {} Factors of safety: sliding {}, overturning {}.",
                mode.symbol().replace('\'', "′").replace('-', "−"),
                if others.is_empty() { "The answer is unique." } else { "The answer is not unique." },
                plain(factors[0]),
                plain(factors[1]),
            ),
            relations: trace.deciding().iter().map(Row::of).collect(),
            failed: tried
                .iter()
                .map(|step| Failed {
                    symbol: symbol(reduced.orient(step.mode)),
                    rows: step.relations.iter().filter(|relation| !relation.holds).map(Row::of).collect(),
                })
                .collect(),
            factors: vec![
                Factor {
                    name: "sliding",
                    formula: mathematics("μ/k"),
                    value: shown(factors[0]),
                    holds: factors[0] >= 1.0,
                },
                Factor {
                    name: "overturning",
                    formula: mathematics("1/(k γ |1+k'|)"),
                    value: shown(factors[1]),
                    holds: factors[1] >= 1.0,
                },
            ],
            departure: match margins.leaves_rest() {
                Some(crossing) => {
                    let real = force(state, crossing.at).map_or(String::new(), |force| format!(", {force}"));
                    format!(
                        "<i>k</i> = {}{real}: beyond, the body {} ({}).",
                        shown(crossing.at),
                        reduced.orient(crossing.to).words().replace('\'', "′"),
                        symbol(reduced.orient(crossing.to))
                    )
                }
                None => "No force at this elevation moves the body against this friction.".to_owned(),
            },
            along_k: margins.along_k.iter().map(|crossing| change(crossing, true)).collect(),
            along_mu: margins.along_mu.iter().map(|crossing| change(crossing, false)).collect(),
            motion: quantities(state, &motion),
            case: {
                let diagram = state.diagram();
                let view = state.view(&diagram);
                let seen =
                    |strip: &Strip| strip.from < view.k_max && strip.lower.at(strip.from) < view.mu_max;
                let parts = diagram.unresolved();
                let hatched = state.figure.is_none() && parts.iter().any(|part| part.strips.iter().any(seen));
                let remark = if hatched { " Hatched: the answer is not unique." } else { "" };
                let mirror = if state.mirrored {
                    " The force points right: the diagram is that of the mirror image."
                } else {
                    ""
                };
                format!("This body: {}.{remark}{mirror}", mathematics(point.chart().case().words()))
            },
            points: (point.chart().points().iter())
                .map(|point| [letter(point.name), shown(point.k), shown(point.mu)])
                .collect(),
            fields: Field::ALL.map(|(name, field)| (name, field.text(state))).into(),
            sliders: Field::ALL
                .iter()
                .filter_map(|(name, field)| Some((*name, field.share(state)?)))
                .collect(),
            units: units.map(|(kind, (names, chosen))| (kind, names, chosen)).into(),
            mirrored: state.mirrored,
            figure: state.figure.map(|id| id.number()),
            is_map: state.figure.is_none_or(|id| id.body().is_some()),
            numbers: Numbers {
                given: [point.gamma(), point.k_prime(), point.k(), point.mu()],
                motion: [
                    motion.x_ddot,
                    motion.y_ddot,
                    motion.theta_ddot,
                    motion.f_x,
                    motion.f_y,
                    motion.xi,
                    motion.slip,
                    motion.lift_o,
                    motion.lift_o_prime,
                ],
                factors,
                others: others.iter().map(Mode::symbol).collect(),
            },
        }
    }
}

impl Row {
    fn of(relation: &Relation) -> Row {
        let Relation { equation, left, sign, right, holds, .. } = *relation;
        let sign = mathematics(&sign.to_string());
        Row {
            equation: equation.to_owned(),
            statement: mathematics(&relation.statement()),
            values: format!("{} {sign} {}", shown(left), shown(right)),
            margin: shown(relation.margin().abs()),
            holds,
        }
    }
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

fn uniqueness(mode: Mode, others: Modes, rock: Mode) -> String {
    if others.is_empty() {
        return "The answer is unique.".to_owned();
    }
    let list: Vec<_> = others.iter().map(symbol).collect();
    format!(
        "Not unique: {} also {} every law. This is Painlevé’s indeterminacy; rigid-body mechanics cannot choose. {} is \
         the report’s choice (section IV.7), which a sudden force favours; under a slowly raised force the body has \
         already begun to rock, and stays in {}.",
        list.join(" and "),
        if list.len() == 1 { "satisfies" } else { "satisfy" },
        symbol(mode),
        symbol(rock)
    )
}

fn quantities(state: &State, motion: &Motion) -> Vec<Quantity> {
    let (force_name, force_scale) = FORCES[state.units.force];
    let (length_name, length_scale) = LENGTHS[state.units.length];
    let real =
        state.real().map(|(body, _)| motion.scaled(GRAVITY, body.width() / 2.0, body.weight(GRAVITY).p));
    let quantity = |symbol, words, of: fn(&Motion) -> f64, unit, scale: f64, real_unit: &str| Quantity {
        symbol,
        words,
        value: shown(of(motion)),
        unit,
        real: real.as_ref().map_or(String::new(), |real| format!("{} {real_unit}", shown(of(real) / scale))),
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
