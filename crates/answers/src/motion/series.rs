//! The motion at even steps of time, as a table.

use std::borrow::Cow;
use std::fmt::Write;

use standfast_model::BlockCase;
use standfast_motion::{Moment, MotionOutcome};

use super::points::{PointAnswer, PointMotion, ground};

/// A column of a series: its name, the SI unit of its values, what it is, and its value at a moment.
#[derive(Debug, Clone)]
pub struct SeriesColumn {
    /// Its name.
    pub name: Cow<'static, str>,
    /// The unit of a body in SI units; empty of an angle's sine or a word.
    pub unit: &'static str,
    /// Its meaning in a few words.
    pub words: &'static str,
    value: ColumnValue,
}

/// Where the value of a column comes from.
#[derive(Debug, Clone, Copy)]
enum ColumnValue {
    /// The row.
    Row(fn(&SeriesRow) -> Option<f64>),
    /// One of the numbers of a point of the body.
    Point { at: [f64; 2], which: usize },
}

impl SeriesColumn {
    /// The value in a row; `None` where there is none.
    pub fn value(&self, row: &SeriesRow) -> Option<f64> {
        match self.value {
            ColumnValue::Row(value) => value(row),
            ColumnValue::Point { at, which } => {
                Some(PointMotion::of(at, &row.moment, row.ground, row.gravity).numbers()[which])
            }
        }
    }
}

/// Rows asked for of a series.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeriesAsked {
    /// The step of time.
    pub dt: f64,
    /// True for two rows more at each event, just before and just after it, and a column that tells them.
    pub events: bool,
}

impl SeriesAsked {
    /// The columns but the state, which stands before that at [`STATE_AT`]: of every body, then of each of the case's points.
    pub fn columns(self, case: &BlockCase) -> Vec<SeriesColumn> {
        let mut columns = SERIES[..SERIES.len() - usize::from(!self.events)].to_vec();
        for point in &case.points {
            let words = [
                "absolute acceleration of the point to the right",
                "absolute acceleration of the point upwards",
                "what an instrument at the point feels along the base of the body, with gravity",
                "what an instrument at the point feels along the side of the body, with gravity",
            ];
            let named = PointAnswer::NAMES.into_iter().zip(words).enumerate();
            columns.extend(named.map(|(which, (name, words))| SeriesColumn {
                name: Cow::Owned(format!("{name}.{}", point.name)),
                unit: "m/s2",
                words,
                value: ColumnValue::Point { at: point.at, which },
            }));
        }
        columns
    }

    /// The rows of a motion, until it ends.
    pub fn rows<'a>(
        self,
        case: &'a BlockCase,
        outcome: &'a MotionOutcome,
    ) -> impl Iterator<Item = SeriesRow> + 'a {
        // Of a motion that goes on from a moment: that moment, and then the multiples of the step.
        let begin = case.problem.initial.time;
        // Of a body that has overturned nothing more is known.
        let last =
            outcome.events.last().filter(|_| outcome.overturned()).map_or(outcome.t_final, |event| event.t);
        let [first, last] = [begin, last].map(|t| (t / self.dt + 1e-9).floor() as u64);
        let after = (first + 1..=last).map(move |i| i as f64 * self.dt);
        let mut even = std::iter::once(begin).chain(after).peekable();
        let mut events = outcome.events.iter().map(|event| event.t).filter(move |_| self.events).peekable();
        let mut after = None;
        let times = std::iter::from_fn(move || {
            if let Some(t) = after.take() {
                return Some((t, Some(Side::After)));
            }
            let Some(&t) = events.peek().filter(|t| even.peek().is_none_or(|even| *t <= even)) else {
                return even.next().map(|t| (t, None));
            };
            // Several events of a moment are one, and take the place of the even step that it may be.
            while events.next_if_eq(&t).is_some() {}
            even.next_if_eq(&t);
            if t <= begin {
                return Some((t, Some(Side::After)));
            }
            after = Some(t);
            Some((t, Some(Side::Before)))
        });
        times.map_while(move |(t, side)| row(case, outcome, t, side))
    }

    /// The rows of a motion as CSV.
    pub fn csv(self, case: &BlockCase, outcome: &MotionOutcome) -> String {
        let columns = self.columns(case);
        let mut names: Vec<Cow<'_, str>> = columns.iter().map(|column| quoted(&column.name)).collect();
        names.insert(STATE_AT, "state".into());
        let mut text = names.join(",") + "\n";
        for row in self.rows(case, outcome) {
            for (place, column) in columns.iter().enumerate() {
                if place == STATE_AT {
                    let _ = write!(text, ",{}", row.moment.state.symbol());
                }
                let comma = if place == 0 { "" } else { "," };
                let _ = match column.value(&row) {
                    Some(value) => write!(text, "{comma}{value}"),
                    None => write!(text, "{comma}"),
                };
            }
            text.push('\n');
        }
        text
    }
}

/// The side of an event on which a row is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Side {
    Before,
    After,
}

/// A row of a series: a moment, with what is not per mass and what the base does.
#[derive(Debug, Clone, Copy)]
pub struct SeriesRow {
    /// Everything at the moment, per mass.
    pub moment: Moment,
    /// Mass by which forces are multiplied, kg or kg per metre run; 1 of a body in pure numbers.
    mass: f64,
    /// Accelerations of the base, to the right and upwards.
    ground: [f64; 2],
    gravity: f64,
    /// Of a row at an event.
    side: Option<Side>,
}

const fn column(
    name: &'static str,
    unit: &'static str,
    words: &'static str,
    value: fn(&SeriesRow) -> Option<f64>,
) -> SeriesColumn {
    SeriesColumn { name: Cow::Borrowed(name), unit, words, value: ColumnValue::Row(value) }
}

/// A name as a cell of CSV.
fn quoted(name: &str) -> Cow<'_, str> {
    if name.contains([',', '"']) { format!("\"{}\"", name.replace('"', "\"\"")).into() } else { name.into() }
}

static SERIES: [SeriesColumn; 31] = [
    column("t", "s", "time", |row| Some(row.moment.t)),
    column("slide", "m", "displacement along the base of the corner that touches, or of O", |row| {
        Some(row.moment.slide)
    }),
    column("x", "m", "x of the centre of mass, from where it was at the beginning", |row| Some(row.moment.x)),
    column("y", "m", "y of the centre of mass above the base", |row| Some(row.moment.y)),
    column("theta", "rad", "angle, counter-clockwise", |row| Some(row.moment.theta)),
    column("omega", "rad/s", "rate of rotation", |row| Some(row.moment.omega)),
    column("vx", "m/s", "velocity of the centre of mass to the right", |row| Some(row.moment.velocity[0])),
    column("vy", "m/s", "velocity of the centre of mass upwards", |row| Some(row.moment.velocity[1])),
    column("ax", "m/s2", "acceleration of the centre of mass to the right, relative to the base", |row| {
        Some(row.moment.acceleration[0])
    }),
    column("ay", "m/s2", "acceleration of the centre of mass upwards, relative to the base", |row| {
        Some(row.moment.acceleration[1])
    }),
    column("alpha", "rad/s2", "acceleration of the rotation", |row| Some(row.moment.alpha)),
    column("N_O", "N", "reaction upwards at O", |row| Some(row.mass * row.moment.normal[0])),
    column("T_O", "N", "reaction to the right at O; none where both corners touch", |row| {
        Some(row.mass * row.moment.tangential?[0])
    }),
    column("N_O'", "N", "reaction upwards at O'", |row| Some(row.mass * row.moment.normal[1])),
    column("T_O'", "N", "reaction to the right at O'; none where both corners touch", |row| {
        Some(row.mass * row.moment.tangential?[1])
    }),
    column("T", "N", "reaction to the right of both corners", |row| Some(row.mass * row.moment.friction)),
    column("slide_O", "m", "displacement along the base of O", |row| Some(row.moment.slides[0])),
    column("slide_O'", "m", "displacement along the base of O'", |row| Some(row.moment.slides[1])),
    column("gap_O", "m", "height of O above the base", |row| Some(row.moment.gaps[0])),
    column("gap_O'", "m", "height of O' above the base", |row| Some(row.moment.gaps[1])),
    column("X", "N", "loads to the right, with the base's acceleration", |row| {
        Some(row.mass * row.moment.loads[0])
    }),
    column("P", "N", "loads downwards, with the weight and the base's acceleration", |row| {
        Some(row.mass * row.moment.loads[1])
    }),
    column("M", "N m", "moment of the loads about the centre of mass, counter-clockwise", |row| {
        Some(row.mass * row.moment.loads[2])
    }),
    column("a_h", "m/s2", "acceleration of the base to the right", |row| Some(row.ground[0])),
    column("a_v", "m/s2", "acceleration of the base upwards", |row| Some(row.ground[1])),
    column("K", "J/kg", "kinetic energy per mass", |row| Some(row.moment.kinetic)),
    column("potential", "J/kg", "potential energy per mass, from the beginning on", |row| {
        Some(row.moment.potential)
    }),
    column("work", "J/kg", "work of the loads so far per mass, the weight left out", |row| {
        Some(row.moment.work)
    }),
    column("friction_loss", "J/kg", "what friction has taken so far per mass", |row| {
        Some(row.moment.friction_loss)
    }),
    column("impact_loss", "J/kg", "what impacts have taken so far per mass", |row| {
        Some(row.moment.impact_loss)
    }),
    column("side", "", "of an event: -1 just before it, 1 just after; none between events", |row| {
        row.side.map(|side| if side == Side::Before { -1.0 } else { 1.0 })
    }),
];

/// The place of the state among the columns.
pub const STATE_AT: usize = 6;

/// The row of a moment: at an event just before something changes there, or after.
fn row(case: &BlockCase, outcome: &MotionOutcome, t: f64, side: Option<Side>) -> Option<SeriesRow> {
    let before = side == Some(Side::Before);
    let moment = outcome.moment(t, before)?;
    let (ground, gravity) = (ground(case, t, before), case.problem.gravity);
    Some(SeriesRow { moment, mass: case.mass, ground, gravity, side })
}
