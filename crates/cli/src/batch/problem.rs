//! What a table asks: the report's problem, or the general contact problem.

use clap::ValueEnum;
use csv::ByteRecord;
use standfast::contact::{self, Block, Wrench};
use standfast::{InputError, Mode, Modes, Motion, Point};

/// Which problem the rows are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum Problem {
    /// The report's: gamma, k_prime, k and mu
    #[default]
    Force,
    /// Any wrench on any block: b1, b2, d, rho2, m_x, m_y, x, p, m, mu_s and mu_k
    Wrench,
}

/// A column that a table has to have.
pub(super) struct Column {
    pub(super) name: &'static str,
    /// What the library calls it.
    quantity: &'static str,
    /// What people call it otherwise, in small letters.
    pub(super) other_names: &'static [&'static str],
}

const fn column(name: &'static str, quantity: &'static str, other_names: &'static [&'static str]) -> Column {
    Column { name, quantity, other_names }
}

const FORCE: [Column; 4] = [
    column("gamma", "slenderness γ", &["gamma", "γ", "slenderness", "h/b"]),
    column("k_prime", "elevation k'", &["k_prime", "k'", "kprime", "kp", "elevation", "height"]),
    column("k", "force k", &["k", "force", "f", "load"]),
    column("mu", "friction μ", &["mu", "μ", "friction", "friction coefficient"]),
];

const WRENCH: [Column; 11] = [
    column("b1", "distance b1 of O", &["b1", "b_1", "b₁"]),
    column("b2", "distance b2 of O'", &["b2", "b_2", "b₂"]),
    column("d", "depth d of the base", &["d", "depth"]),
    column("rho2", "square rho2 of the radius of gyration", &["rho2", "rho^2", "ρ²"]),
    column("m_x", "inertia m_x", &["m_x", "mx"]),
    column("m_y", "inertia m_y", &["m_y", "my"]),
    column("x", "horizontal force x", &["x", "f_x", "horizontal"]),
    column("p", "vertical force p", &["p", "vertical"]),
    column("m", "moment m", &["m", "moment"]),
    column("mu_s", "static friction mu_s", &["mu_s", "μ_s", "mus", "static friction"]),
    column("mu_k", "kinetic friction mu_k", &["mu_k", "μ_k", "muk", "kinetic friction"]),
];

/// The most columns a problem has.
pub(super) const MOST: usize = WRENCH.len();

const FORCE_RESULTS: [&str; 9] =
    ["mode", "unique", "also", "x_ddot", "y_ddot", "theta_ddot", "f_x", "f_y", "xi"];

const WRENCH_RESULTS: [&str; 8] = ["modes", "mode", "x_ddot", "y_ddot", "theta_ddot", "f_x", "f_y", "xi"];

/// The answer to a row.
pub(super) enum Answer {
    Force(Point),
    Wrench(contact::Answer),
}

impl Problem {
    /// The columns needed.
    pub(super) fn columns(self) -> &'static [Column] {
        match self {
            Problem::Force => &FORCE,
            Problem::Wrench => &WRENCH,
        }
    }

    /// The columns appended.
    pub fn results(self) -> &'static [&'static str] {
        match self {
            Problem::Force => &FORCE_RESULTS,
            Problem::Wrench => &WRENCH_RESULTS,
        }
    }

    /// The names of the columns needed, in words.
    pub(super) fn needed(self) -> String {
        let names: Vec<_> = self.columns().iter().map(|column| column.name).collect();
        let (last, rest) = names.split_last().expect("there are columns");
        format!("{} and {last}", rest.join(", "))
    }

    /// The answer to the values of the columns; those that the problem does not have are ignored.
    pub(super) fn solve(self, values: [f64; MOST]) -> Result<Answer, InputError> {
        match self {
            Problem::Force => {
                let [gamma, k_prime, k, mu, ..] = values;
                Point::new(gamma, k_prime, k, mu).map(Answer::Force)
            }
            Problem::Wrench => {
                let [b1, b2, d, rho2, m_x, m_y, x, p, m, mu_s, mu_k] = values;
                let block = Block { b1, b2, d, rho2, m_x, m_y, mu_s, mu_k };
                contact::solve(&block, &Wrench { x, p, m }).map(Answer::Wrench)
            }
        }
    }

    /// The place among the columns of the one at fault.
    pub(super) fn blame(self, error: &InputError) -> usize {
        let culprit = self.columns().iter().position(|column| column.quantity == error.quantity);
        culprit.unwrap_or_default()
    }
}

impl Answer {
    /// Appends the results to a row.
    pub(super) fn append(&self, record: &mut ByteRecord) {
        match self {
            Answer::Force(point) => {
                let others = point.others();
                record.push_field(point.mode().symbol().as_bytes());
                record.push_field(if others.is_empty() { b"true" } else { b"false" });
                push_modes(record, others);
                push_motion(record, Some(point.motion()));
            }
            Answer::Wrench(answer) => {
                push_modes(record, answer.modes);
                record.push_field(answer.mode().map_or("", Mode::symbol).as_bytes());
                push_motion(record, answer.mode().and_then(|mode| answer.motion(mode)));
            }
        }
    }
}

fn push_modes(record: &mut ByteRecord, modes: Modes) {
    record.push_field(modes.to_string().as_bytes());
}

fn push_motion(record: &mut ByteRecord, motion: Option<Motion>) {
    let Some(Motion { x_ddot, y_ddot, theta_ddot, f_x, f_y, xi, .. }) = motion else {
        return (0..6).for_each(|_| record.push_field(b""));
    };
    let mut buffer = ryu::Buffer::new();
    for value in [x_ddot, y_ddot, theta_ddot, f_x, f_y, xi] {
        record.push_field(buffer.format(value).as_bytes());
    }
}
