//! Points, inequalities and motions in words and aligned columns.

use standfast::initiation::Crossing;
use standfast::loads::Reduced;
use standfast::relation::Relation;
use standfast::{Mode, Motion};

use crate::case::Case;
use crate::layout::{apart, columns, digits, paragraph, row};
use crate::units::Dimension;
use standfast_inputs::OutputUnits;

/// Units of the non-dimensional numbers of a point: m, m g, g, B and g/B of the real body.
#[derive(Debug, Clone, Copy)]
pub struct Scale {
    /// g, m/s².
    pub acceleration: f64,
    /// B, m.
    pub length: f64,
    /// m g, N per metre run or of the whole object.
    pub weight: f64,
    /// Units in which they are written.
    pub output: OutputUnits,
}

impl Scale {
    /// The scale of the body of a case.
    pub fn of(Case { body, gravity, output, .. }: &Case) -> Scale {
        let weight = body.mass() * gravity;
        Scale { acceleration: *gravity, length: body.width() / 2.0, weight, output: *output }
    }
}

/// Sentences on the uniqueness of the answer.
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

/// A quantity of a motion, and how it is printed.
#[derive(Debug, Clone, Copy)]
pub struct MotionPart {
    /// Its name in the JSON and in tables.
    pub key: &'static str,
    /// Its symbol in plain characters.
    pub symbol: &'static str,
    /// Quantity and direction, in words.
    pub words: &'static str,
    /// Its value.
    pub of: fn(&Motion) -> f64,
    /// Unit of the non-dimensional value.
    pub unit: &'static str,
    /// Dimension of the value of a real body; `None` for a rotation.
    pub dimension: Option<Dimension>,
}

impl MotionPart {
    /// A real body's value in SI units as it is written, and its unit.
    pub fn on_paper(&self, output: OutputUnits, si: f64) -> [String; 2] {
        match self.dimension {
            Some(dimension) => [output.value(dimension, si), output.symbol(dimension)],
            None => [output.number(si), "rad/s²".to_owned()],
        }
    }
}

/// The quantities of a motion in the order they are printed.
pub const MOTION: [MotionPart; 9] = {
    const fn part(
        key: &'static str,
        symbol: &'static str,
        words: &'static str,
        of: fn(&Motion) -> f64,
        unit: &'static str,
        dimension: Option<Dimension>,
    ) -> MotionPart {
        MotionPart { key, symbol, words, of, unit, dimension }
    }
    const LINEAR: Option<Dimension> = Some(Dimension::Acceleration);
    const ANGULAR: Option<Dimension> = None;
    const FORCE: Option<Dimension> = Some(Dimension::Force);
    const LENGTH: Option<Dimension> = Some(Dimension::Length);
    [
        part("x_ddot", "ẍ", "of the centre of mass, to the right", |m| m.x_ddot, "g", LINEAR),
        part("y_ddot", "ÿ", "of the centre of mass, upwards", |m| m.y_ddot, "g", LINEAR),
        part("theta_ddot", "θ̈", "counter-clockwise", |m| m.theta_ddot, "g/B", ANGULAR),
        part("f_x", "f_x", "reaction on the body, to the right", |m| m.f_x, "m g", FORCE),
        part("f_y", "f_y", "reaction on the body, upwards", |m| m.f_y, "m g", FORCE),
        part("xi", "ξ", "where f_y acts, right of the centre of mass", |m| m.xi, "B", LENGTH),
        part("slip", "ẍ_O", "of both corners, along the base to the right", |m| m.slip, "g", LINEAR),
        part("lift_o", "ÿ_O", "of the left corner, upwards", |m| m.lift_o, "g", LINEAR),
        part("lift_o_prime", "ÿ_O'", "of the right corner, upwards", |m| m.lift_o_prime, "g", LINEAR),
    ]
};

/// Accelerations and reactions of a real body: in units of g, B and m g, and in SI units.
pub fn real_motion(motion: &Motion, scale: &Scale) -> String {
    let reduced = motion.scaled(1.0 / scale.acceleration, 1.0 / scale.length, 1.0 / scale.weight);
    let rows = MOTION.map(|part @ MotionPart { symbol, words, of, unit, .. }| {
        let [real, real_unit] = part.on_paper(scale.output, of(motion));
        row![symbol, words, digits(of(&reduced)), unit, real, real_unit]
    });
    columns(&rows, 2, &[2, 4])
}

/// Accelerations and reactions at a point of the report's plane.
pub fn motion(motion: &Motion) -> String {
    let rows = MOTION
        .map(|MotionPart { symbol, words, of, unit, .. }| row![symbol, words, digits(of(motion)), unit]);
    columns(&rows, 2, &[2])
}

/// Changes of the mode along both axes of the plane.
pub struct Changes {
    /// Change at which the body leaves rest as the force grows.
    pub leaves_rest: Option<Crossing>,
    /// All changes as the force grows.
    pub along_k: Vec<Crossing>,
    /// All changes as the friction grows.
    pub along_mu: Vec<Crossing>,
    /// The point's force.
    pub k: f64,
    /// The point's friction.
    pub mu: f64,
    /// True if the force points right, so that modes are to be mirrored.
    pub mirrored: bool,
}

/// Changes of the mode as the friction grows, in words.
pub fn along_mu(reduced: &Reduced, indent: usize) -> String {
    Changes::of(reduced).as_mu_grows(indent)
}

impl Changes {
    /// The changes of a point on a rigid base.
    pub fn of(reduced: &Reduced) -> Changes {
        let margins = reduced.point.margins();
        Changes {
            leaves_rest: margins.leaves_rest(),
            along_k: margins.along_k,
            along_mu: margins.along_mu,
            k: reduced.point.k(),
            mu: reduced.point.mu(),
            mirrored: reduced.mirrored,
        }
    }

    fn orient(&self, mode: Mode) -> Mode {
        if self.mirrored { mode.mirrored() } else { mode }
    }

    /// As the force grows, and where the body leaves rest.
    pub fn as_k_grows(&self) -> String {
        let leaves_rest = match self.leaves_rest {
            Some(crossing) => {
                let to = self.orient(crossing.to);
                format!(
                    "The body leaves rest at k = {}: beyond, it {} ({to}).",
                    digits(crossing.at),
                    to.words()
                )
            }
            None => "No force up to k = 1e50 moves the body.".to_owned(),
        };
        let mut text = paragraph(&leaves_rest, 2);
        if !self.along_k.is_empty() {
            text += &format!("  as the force grows, at μ = {}:\n", digits(self.mu));
            text += &self.crossings("k", &self.along_k, 4);
        }
        text
    }

    /// As the friction grows.
    pub fn as_mu_grows(&self, indent: usize) -> String {
        if self.along_mu.is_empty() {
            return paragraph("The mode is the same for every friction.", indent);
        }
        let mut text = self.crossings("μ", &self.along_mu, indent);
        if self.along_mu.last().is_none_or(|crossing| crossing.to != Mode::Rest) {
            text +=
                &paragraph("Whatever the friction, the body does not stay at rest under this load.", indent);
        }
        text
    }

    fn crossings(&self, symbol: &str, crossings: &[Crossing], indent: usize) -> String {
        let values: Vec<f64> = crossings.iter().map(|crossing| crossing.at).collect();
        let rows: Vec<_> = apart(&values)
            .into_iter()
            .zip(crossings)
            .map(|(value, crossing)| {
                let change = format!("{} → {}", self.orient(crossing.from), self.orient(crossing.to));
                row![format!("{symbol} = {value}"), change]
            })
            .collect();
        columns(&rows, indent, &[])
    }
}

/// Note on the accelerations at onset of a body whose base is shaken.
pub const RELATIVE: &str = "Accelerations are relative to the base, which the earthquake itself accelerates.";

/// Note on the mirrored modes in the answer to a force that points right.
pub const MIRRORED: &str = "The force points to the right, the mirror image of the report's problem: k, k' and the \
     inequalities are those of the same force to the left; the modes and motions below are of the real body, with \
     left and right, O and O' exchanged. O is the bottom left corner, O' the bottom right.";
