//! A verdict explained: each mode's inequalities in the order they are tried, with the report's equation numbers.

use std::cmp::Ordering;

use super::Point;
use crate::mode::{Mode, Modes};
use crate::sign::Need;

/// The modes tried in turn, up to the one that holds.
///
/// ```
/// use standfast::Point;
///
/// let trace = Point::new(1.0, 0.4, 0.5, 0.6)?.explain();
/// assert_eq!(trace.steps.len(), 1); // rest is tried first, and holds
/// assert_eq!(trace.deciding()[0].to_string(), "(3.4) μ ≥ k: 0.6 ≥ 0.5, holds by 0.1");
/// # Ok::<(), standfast::InputError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Trace {
    /// One step a mode; the last one holds.
    pub steps: Vec<Step>,
    /// Other consistent modes, where the answer is not unique.
    pub others: Modes,
}

impl Trace {
    /// The inequalities of the mode that holds.
    pub fn deciding(&self) -> &[Relation] {
        self.steps.last().map_or(&[], |step| &step.relations)
    }
}

/// A mode and the inequalities it needs.
#[derive(Debug, Clone, PartialEq)]
pub struct Step {
    /// The mode that is tried.
    pub mode: Mode,
    /// Its inequalities; all have to hold.
    pub relations: Vec<Relation>,
    /// Whether they do.
    pub holds: bool,
}

/// An inequality between a coordinate of the point and a bound.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Relation {
    /// The report's equation number, or where the bound comes from.
    pub equation: &'static str,
    /// The inequality in symbols, e.g. `μ ≥ k`.
    pub statement: &'static str,
    /// The value left of the sign: μ or k.
    pub left: f64,
    /// The sign between them: `<`, `≤`, `≥` or `>`.
    pub sign: &'static str,
    /// The bound right of it.
    pub right: f64,
    /// Whether it holds, decided exactly.
    pub holds: bool,
}

impl Relation {
    /// How far `left` is on the right side of `right`: negative where the inequality does not hold.
    pub fn margin(&self) -> f64 {
        if self.sign.starts_with(['<', '≤']) { self.right - self.left } else { self.left - self.right }
    }
}

impl std::fmt::Display for Relation {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Relation { equation, statement, left, sign, right, holds } = *self;
        let verb = if holds { "holds" } else { "fails" };
        let (left, right, margin) = (digits(left), digits(right), digits(self.margin().abs()));
        write!(f, "({equation}) {statement}: {left} {sign} {right}, {verb} by {margin}")
    }
}

/// Six significant digits, without trailing zeros.
fn digits(x: f64) -> String {
    if x == 0.0 || !x.is_finite() {
        return x.to_string();
    }
    let rounded: f64 = format!("{x:.5e}").parse().unwrap_or(x);
    if (1e-4..1e7).contains(&rounded.abs()) { rounded.to_string() } else { format!("{rounded:e}") }
}

/// The equation numbers of one chapter.
struct Chapter {
    rest_friction: &'static str,
    rest_overturning: &'static str,
    slide_friction: &'static str,
    slide_turning: &'static str,
    rock_overturning: &'static str,
    rock_friction: &'static str,
    slide_rock_turning: &'static str,
    slide_rock_slip: &'static str,
}

const CHAPTER_III: Chapter = Chapter {
    rest_friction: "3.4",
    rest_overturning: "3.5",
    slide_friction: "3.6",
    slide_turning: "3.8",
    rock_overturning: "3.17",
    rock_friction: "3.24",
    slide_rock_turning: "3.35",
    slide_rock_slip: "3.40",
};

const CHAPTER_IV: Chapter = Chapter {
    rest_friction: "4.7",
    rest_overturning: "4.10",
    slide_friction: "4.23",
    slide_turning: "4.19",
    rock_overturning: "4.37",
    rock_friction: "4.40",
    slide_rock_turning: "4.67",
    slide_rock_slip: "4.77",
};

/// k' < −1: the report's equations seen from the corner O'.
const BELOW_BASE: Chapter = Chapter {
    rest_friction: "4.7",
    rest_overturning: "4.10 about O'",
    slide_friction: "4.23",
    slide_turning: "4.18",
    rock_overturning: "4.57",
    rock_friction: "4.96 about O'",
    slide_rock_turning: "4.92",
    slide_rock_slip: "4.96",
};

impl Trace {
    pub(super) fn of(point: &Point) -> Trace {
        let mode = point.mode();
        let mut steps = Vec::new();
        for &candidate in candidates(point) {
            let relations = relations(point, candidate);
            let holds = candidate == mode;
            debug_assert_eq!(holds, relations.iter().all(|relation| relation.holds), "{point:?} {candidate}");
            steps.push(Step { mode: candidate, relations, holds });
            if holds {
                break;
            }
        }
        Trace { steps, others: point.others() }
    }
}

/// The modes in the order of the decision.
fn candidates(point: &Point) -> &'static [Mode] {
    use Mode::{Rest, RockO, RockOPrime, SlideLeft, SlideRockOLeft, SlideRockOPrimeLeft, SlideRockORight};
    if point.k_prime < -1.0 {
        &[Rest, SlideLeft, RockOPrime, SlideRockOPrimeLeft]
    } else if point.k_prime < 0.0 {
        &[Rest, SlideRockOPrimeLeft, SlideLeft, RockO, SlideRockOLeft]
    } else {
        &[Rest, SlideLeft, RockO, SlideRockOLeft, SlideRockORight]
    }
}

/// The inequalities of `mode`, given that the modes before it in the order do not hold.
fn relations(point: &Point, mode: Mode) -> Vec<Relation> {
    let Point { k_prime, k, mu, .. } = *point;
    let chart = point.chart();
    let signs = point.polynomials(Need::Sign, |p| [p.tip, p.turn, p.toe, p.slip_left, p.slip_right]);
    let chapter = match k_prime {
        below if below < -1.0 => BELOW_BASE,
        below if below < 0.0 => CHAPTER_IV,
        _ => CHAPTER_III,
    };
    let beyond = k_prime < -1.0;
    let sign = |value: f64| value.partial_cmp(&0.0).expect("polynomials of a valid point are numbers");
    let relation = |equation, statement: &'static str, left, right, ordering: Ordering| {
        let sign = ["<", "≤", "≥", ">"].into_iter().find(|sign| statement.contains(sign));
        let sign = sign.expect("a statement has a sign");
        let holds = match sign {
            "<" => ordering.is_lt(),
            "≤" => ordering.is_le(),
            "≥" => ordering.is_ge(),
            _ => ordering.is_gt(),
        };
        Relation { equation, statement, left, sign, right, holds }
    };

    // Orderings of the left side against the bound, from the exact signs.
    let friction = mu.total_cmp(&k);
    let overturning = sign(signs.tip);
    // For the corner O μ is compared with the upper line, for O' with the lower one.
    let turning = sign(signs.turn);
    let upper = chart.upper_line().at(k);
    let lower = chart.lower_line().at(k);
    let k_a = chart.k_a();

    match mode {
        Mode::Rest => vec![
            relation(chapter.rest_friction, "μ ≥ k", mu, k, friction),
            relation(chapter.rest_overturning, "k ≤ 1/(γ|1+k'|)", k, k_a, overturning),
        ],
        Mode::SlideLeft if beyond => vec![
            relation(chapter.slide_friction, "μ < k", mu, k, friction),
            relation(chapter.slide_turning, "μ ≥ −1/γ − k k'", mu, lower, turning.reverse()),
        ],
        Mode::SlideLeft => {
            let mut all = vec![
                relation(chapter.slide_friction, "μ < k", mu, k, friction),
                relation(chapter.slide_turning, "μ ≤ 1/γ − k k'", mu, upper, turning),
            ];
            if k_prime < 0.0 {
                all.push(relation("4.18", "μ ≥ −1/γ − k k'", mu, lower, sign(signs.toe)));
            }
            all
        }
        Mode::RockO | Mode::RockOPrime => {
            // Both signs of f_x in one inequality: friction has to stop a slip either way.
            let sticks = sign(signs.slip_left).min(sign(signs.slip_right));
            let (bound, statement) = if beyond {
                (chart.mu_star_star().at(k), "μ ≥ (a k − b)/(d − c k)")
            } else {
                (chart.mu_star().at(k).abs(), "μ ≥ |a k + b|/(c k + d)")
            };
            vec![
                relation(chapter.rock_overturning, "k > 1/(γ|1+k'|)", k, k_a, overturning),
                relation(chapter.rock_friction, statement, mu, bound, sticks),
            ]
        }
        Mode::SlideRockOLeft => vec![
            relation(chapter.slide_rock_turning, "μ > 1/γ − k k'", mu, upper, turning),
            relation(
                chapter.slide_rock_slip,
                "μ < (a k + b)/(c k + d)",
                mu,
                chart.mu_star().at(k),
                sign(signs.slip_left),
            ),
        ],
        Mode::SlideRockORight => vec![
            relation("3.44", "μ ≤ −1/γ + k k'", mu, -upper, sign(point.gamma * (mu - k * k_prime) + 1.0)),
            relation("3.45", "μ < −(a k + b)/(c k + d)", mu, -chart.mu_star().at(k), sign(signs.slip_right)),
        ],
        Mode::SlideRockOPrimeLeft if beyond => vec![
            relation(chapter.slide_rock_turning, "μ < −1/γ − k k'", mu, lower, turning.reverse()),
            relation(
                chapter.slide_rock_slip,
                "μ < (a k − b)/(d − c k)",
                mu,
                chart.mu_star_star().at(k),
                sign(signs.slip_left),
            ),
        ],
        Mode::SlideRockOPrimeLeft => {
            vec![relation("4.92", "μ < −1/γ − k k'", mu, lower, sign(signs.toe))]
        }
        Mode::SlideRight | Mode::SlideRockOPrimeRight | Mode::Flight => Vec::new(),
    }
}
