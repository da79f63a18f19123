//! A verdict explained: each mode's inequalities in the order they are tried, with the report's equation numbers.

use super::polynomials::{Need, Polynomials};
use super::{Chart, Point};
use crate::mode::{Mode, Modes};
use crate::relation::{Relation, Sign};

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
    /// True if all of them do.
    pub holds: bool,
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
    slide_turning: "after 3.8",
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
        let terms = Terms::of(point);
        let mut steps = Vec::new();
        for &candidate in candidates(point) {
            let relations = terms.relations(candidate);
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

/// Terms of which the inequalities of a point are made.
struct Terms {
    point: Point,
    chart: Chart,
    signs: Polynomials<f64>,
    chapter: &'static Chapter,
}

impl Terms {
    fn of(point: &Point) -> Terms {
        let signs = point
            .polynomials(Need::Sign, |p| [p.tip, p.turn, p.toe, p.slip_left, p.slip_right, p.turn_right]);
        let chapter = match point.k_prime {
            below if below < -1.0 => &BELOW_BASE,
            below if below < 0.0 => &CHAPTER_IV,
            _ => &CHAPTER_III,
        };
        Terms { point: *point, chart: point.chart(), signs, chapter }
    }

    /// μ against a bound; `excess` has the exact sign of μ less the bound.
    fn friction(
        &self,
        equation: &'static str,
        sign: Sign,
        bound: (&'static str, f64),
        excess: f64,
    ) -> Relation {
        Terms::relation(equation, ("μ", self.point.mu), sign, bound, excess)
    }

    fn relation(
        equation: &'static str,
        (quantity, left): (&'static str, f64),
        sign: Sign,
        (bound, right): (&'static str, f64),
        excess: f64,
    ) -> Relation {
        let ordering = excess.partial_cmp(&0.0).expect("the polynomials of a valid point are numbers");
        Relation { equation, quantity, left, sign, bound, right, holds: sign.holds(ordering) }
    }

    /// The inequalities of `mode`, given that the modes before it in the order do not hold.
    fn relations(&self, mode: Mode) -> Vec<Relation> {
        use Sign::{Greater, GreaterOrEqual, Less, LessOrEqual};
        let Point { k_prime, k, mu, .. } = self.point;
        let Polynomials { tip, turn, toe, slip_left, slip_right, turn_right, .. } = self.signs;
        let (chart, chapter) = (&self.chart, self.chapter);
        let beyond = k_prime < -1.0;

        let force = ("k", k);
        let k_a = ("1/(γ|1+k'|)", chart.k_a());
        let upper = ("1/γ − k k'", chart.upper_line().at(k));
        let lower = ("−1/γ − k k'", chart.lower_line().at(k));
        let mu_star = ("(a k + b)/(c k + d)", chart.mu_star().at(k));
        let mu_star_star = ("(a k − b)/(d − c k)", chart.mu_star_star().at(k));

        match mode {
            Mode::Rest => vec![
                self.friction(chapter.rest_friction, GreaterOrEqual, force, mu - k),
                Terms::relation(chapter.rest_overturning, force, LessOrEqual, k_a, tip),
            ],
            Mode::SlideLeft => {
                let mut all = vec![self.friction(chapter.slide_friction, Less, force, mu - k)];
                if beyond {
                    all.push(self.friction(chapter.slide_turning, GreaterOrEqual, lower, -turn));
                } else {
                    all.push(self.friction(chapter.slide_turning, LessOrEqual, upper, turn));
                    if k_prime < 0.0 {
                        all.push(self.friction("4.18", GreaterOrEqual, lower, toe));
                    }
                }
                all
            }
            Mode::RockO | Mode::RockOPrime => {
                let bound = if beyond { mu_star_star } else { ("|a k + b|/(c k + d)", mu_star.1.abs()) };
                // Friction has to stop a slip either way.
                let sticks = slip_left.min(slip_right);
                vec![
                    Terms::relation(chapter.rock_overturning, force, Greater, k_a, tip),
                    self.friction(chapter.rock_friction, GreaterOrEqual, bound, sticks),
                ]
            }
            Mode::SlideRockOLeft => vec![
                self.friction(chapter.slide_rock_turning, Greater, upper, turn),
                self.friction(chapter.slide_rock_slip, Less, mu_star, slip_left),
            ],
            Mode::SlideRockORight => vec![
                self.friction("3.44", LessOrEqual, ("−1/γ + k k'", -upper.1), -turn_right),
                self.friction("3.45", Less, ("−(a k + b)/(c k + d)", -mu_star.1), slip_right),
            ],
            Mode::SlideRockOPrimeLeft if beyond => vec![
                self.friction(chapter.slide_rock_turning, Less, lower, -turn),
                self.friction(chapter.slide_rock_slip, Less, mu_star_star, slip_left),
            ],
            Mode::SlideRockOPrimeLeft => vec![self.friction("4.92", Less, lower, toe)],
            Mode::SlideRight | Mode::SlideRockOPrimeRight | Mode::Flight => Vec::new(),
        }
    }
}
