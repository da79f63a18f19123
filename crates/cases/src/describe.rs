//! The answer to one point in words and aligned columns.

use standfast::initiation::{Crossing, Relation};
use standfast::{Body, Mode, Motion, Reduced};

use crate::layout::{apart, columns, digits, paragraph, row};

/// What the non-dimensional numbers of a point are measured in: m, m g, g, B and g/B of the real body.
#[derive(Debug, Clone, Copy)]
pub struct Scale {
    /// g, m/s².
    pub acceleration: f64,
    /// B, m.
    pub length: f64,
    /// m g, N per metre run.
    pub weight: f64,
}

impl Scale {
    /// The scale of a body under gravity (m/s²).
    pub fn of(body: &Body, gravity: f64) -> Scale {
        Scale { acceleration: gravity, length: body.width() / 2.0, weight: body.mass() * gravity }
    }

    /// A motion in SI units: m/s², rad/s², N per metre run and m.
    pub fn si(&self, motion: &Motion) -> Motion {
        motion.scaled(self.acceleration, self.length, self.weight)
    }
}

/// A force in kN per metre run.
pub fn kilonewtons(force: f64) -> String {
    format!("{} kN/m", digits(force / 1e3))
}

/// The mode as a sentence, with the report's symbol.
pub fn verdict(reduced: &Reduced) -> String {
    let mode = reduced.mode();
    format!("The body {} ({mode}).", mode.words())
}

/// Whether the answer is unique, in sentences.
pub fn uniqueness(reduced: &Reduced) -> String {
    let others = reduced.others();
    if others.is_empty() {
        return "The answer is unique.".to_owned();
    }
    let list: Vec<_> = others.iter().map(|mode| format!("{mode} (the body {})", mode.words())).collect();
    let verb = if list.len() == 1 { "satisfies" } else { "satisfy" };
    // The library's only other modes are the rock and the slide-rock about the corner the force tips the body over.
    let rock = reduced.orient(Mode::RockO);
    format!(
        "The answer is not unique: {} {verb} the equations of motion, Coulomb's law and the contact conditions as \
         well. This is Painlevé's indeterminacy; rigid-body mechanics cannot choose. {} is the report's choice \
         (section IV.7), and a suddenly applied force favours it; under a slowly raised force the body has \
         already begun to rock, and stays in {rock}.",
        list.join(" and "),
        reduced.mode(),
    )
}

/// Inequalities, one a line.
pub fn relations(relations: &[Relation], indent: usize) -> String {
    let rows: Vec<_> = relations
        .iter()
        .map(|relation| {
            let Relation { equation, left, sign, right, holds, .. } = *relation;
            let verb = if holds { "holds" } else { "fails" };
            row![
                format!("({equation})"),
                relation.statement(),
                format!("{} {sign} {}", digits(left), digits(right)),
                format!("{verb} by {}", digits(relation.margin().abs())),
            ]
        })
        .collect();
    columns(&rows, indent, &[])
}

/// Both safety factors.
pub fn safety_factors(reduced: &Reduced) -> String {
    let point = &reduced.point;
    let rows = [
        row!["sliding", "μ/k", digits(point.safety_against_sliding())],
        row!["overturning", "1/(k γ |1+k'|)", digits(point.safety_against_overturning())],
    ];
    columns(&rows, 2, &[])
}

/// A quantity of a motion, and how it is printed.
#[derive(Debug, Clone, Copy)]
pub struct Quantity {
    /// Its symbol in plain characters.
    pub symbol: &'static str,
    /// What it is of, and in which direction.
    pub words: &'static str,
    /// Its value.
    pub of: fn(&Motion) -> f64,
    /// What it is measured in where it is non-dimensional.
    pub unit: &'static str,
    /// The unit of a real body's.
    pub si_unit: &'static str,
    /// How many SI units make one `si_unit`.
    pub si_units: f64,
}

/// The quantities of a motion in the order they are printed.
pub const QUANTITIES: [Quantity; 9] = {
    const fn quantity(
        symbol: &'static str,
        words: &'static str,
        of: fn(&Motion) -> f64,
        unit: &'static str,
        (si_unit, si_units): (&'static str, f64),
    ) -> Quantity {
        Quantity { symbol, words, of, unit, si_unit, si_units }
    }
    const LINEAR: (&str, f64) = ("m/s²", 1.0);
    const ANGULAR: (&str, f64) = ("rad/s²", 1.0);
    const FORCE: (&str, f64) = ("kN/m", 1e3);
    [
        quantity("ẍ", "of the centre of mass, to the right", |m| m.x_ddot, "g", LINEAR),
        quantity("ÿ", "of the centre of mass, upwards", |m| m.y_ddot, "g", LINEAR),
        quantity("θ̈", "counter-clockwise", |m| m.theta_ddot, "g/B", ANGULAR),
        quantity("f_x", "reaction on the body, to the right", |m| m.f_x, "m g", FORCE),
        quantity("f_y", "reaction on the body, upwards", |m| m.f_y, "m g", FORCE),
        quantity("ξ", "where f_y acts, right of the centre of mass", |m| m.xi, "B", ("m", 1.0)),
        quantity("ẍ_O", "of both corners, along the base to the right", |m| m.slip, "g", LINEAR),
        quantity("ÿ_O", "of the left corner, upwards", |m| m.lift_o, "g", LINEAR),
        quantity("ÿ_O'", "of the right corner, upwards", |m| m.lift_o_prime, "g", LINEAR),
    ]
};

/// Accelerations and reactions, non-dimensional and, with a scale, in SI units.
pub fn motion(reduced: &Reduced, scale: Option<&Scale>) -> String {
    let motion = reduced.motion();
    let si = scale.map(|scale| scale.si(&motion));
    let rows: Vec<_> = QUANTITIES
        .iter()
        .map(|Quantity { symbol, words, of, unit, si_unit, si_units }| {
            let mut row = row![*symbol, *words, digits(of(&motion)), *unit];
            if let Some(si) = &si {
                row.extend(row![digits(of(si) / si_units), *si_unit]);
            }
            row
        })
        .collect();
    columns(&rows, 2, &[2, 4])
}

/// Accelerations and reactions of a real body.
pub fn motion_si(motion: &Motion) -> String {
    let rows: Vec<_> = QUANTITIES
        .iter()
        .map(|quantity| {
            let value = digits((quantity.of)(motion) / quantity.si_units);
            row![quantity.symbol, quantity.words, value, quantity.si_unit]
        })
        .collect();
    columns(&rows, 2, &[2])
}

/// Where the mode changes as the force or the friction varies.
pub fn changes(reduced: &Reduced, scale: Option<&Scale>) -> String {
    let point = &reduced.point;
    let margins = point.margins();
    let force = |k: f64| match scale {
        Some(scale) => format!("F = {} (k = {})", kilonewtons(k * scale.weight), digits(k)),
        None => format!("k = {}", digits(k)),
    };
    let leaves_rest = match margins.leaves_rest() {
        Some(crossing) => {
            let to = reduced.orient(crossing.to);
            format!("The body leaves rest at {}: beyond, it {} ({to}).", force(crossing.at), to.words())
        }
        None => "No force up to k = 1e50 moves the body.".to_owned(),
    };

    let arrow = |value: String, crossing: &Crossing| {
        row![value, format!("{} → {}", reduced.orient(crossing.from), reduced.orient(crossing.to))]
    };
    let mut text = paragraph(&leaves_rest, 2);
    let values: Vec<f64> = margins.along_k.iter().map(|crossing| crossing.at).collect();
    let forces: Vec<_> = apart(&values)
        .into_iter()
        .zip(&margins.along_k)
        .map(|(value, crossing)| {
            let k = format!("k = {value}");
            let force = scale.map(|scale| kilonewtons(crossing.at * scale.weight));
            arrow(force.map_or(k.clone(), |force| format!("F = {force} ({k})")), crossing)
        })
        .collect();
    if !forces.is_empty() {
        text += &format!("  as the force grows, at μ = {}:\n", digits(point.mu()));
        text += &columns(&forces, 4, &[]);
    }

    let values: Vec<f64> = margins.along_mu.iter().map(|crossing| crossing.at).collect();
    let frictions: Vec<_> = apart(&values)
        .into_iter()
        .zip(&margins.along_mu)
        .map(|(value, crossing)| arrow(format!("μ = {value}"), crossing))
        .collect();
    if frictions.is_empty() {
        text += &format!("  At {} friction makes no difference.\n", force(point.k()));
    } else {
        text += &format!("  as the friction grows, at {}:\n", force(point.k()));
        text += &columns(&frictions, 4, &[]);
        if margins.along_mu.last().is_none_or(|crossing| crossing.to != Mode::Rest) {
            text += "    No friction keeps the body at rest under this force.\n";
        }
    }
    text
}

/// Why the answer to a force that points right speaks of mirrored modes.
pub const MIRRORED: &str = "The force points to the right, the mirror image of the report's problem: k, k' and the \
     inequalities are those of the same force to the left; the modes and motions below are of the real body, with \
     left and right, O and O' exchanged. O is the bottom left corner, O' the bottom right.";
