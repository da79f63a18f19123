//! A verdict on a base that crushes explained: the inequalities in the order they are tried, and where the mode changes.

use super::{CrushChart, CrushPoint};
use crate::exact::{Exact, Real};
use crate::initiation::{Crossing, Step, Trace};
use crate::mode::{Corner, Mode, Slip};
use crate::region::Curve;
use crate::relation::{Relation, Sign};

use std::cmp::Ordering;

/// All changes of mode when one of k and μ varies and everything else stays as it is; see
/// [`PointMargins`](crate::initiation::PointMargins), whose those of a rigid base are.
#[derive(Debug, Clone, PartialEq)]
pub struct CrushMargins {
    /// Changes as k grows from zero, in order.
    pub along_k: Vec<Crossing>,
    /// Changes as μ grows from zero, in order.
    pub along_mu: Vec<Crossing>,
}

impl CrushMargins {
    /// Crossing at which the body leaves rest as k grows; `None` if no force moves it.
    pub fn leaves_rest(&self) -> Option<Crossing> {
        self.along_k.iter().copied().find(|crossing| crossing.from == Mode::Rest)
    }
}

impl CrushPoint {
    /// The modes tried in turn, up to the one that holds; `None` for BF, where ω ≥ 1 is the one inequality.
    ///
    /// ```
    /// use standfast::ground::strength::CrushPoint;
    ///
    /// let trace = CrushPoint::new(0.8, 0.9167, 0.61, 0.6, 0.08)?.explain().unwrap();
    /// assert_eq!(trace.steps.last().unwrap().mode.symbol(), "RO");
    /// let friction = trace.deciding()[1];
    /// assert_eq!(friction.statement(), "μ ≥ |k − γα|/N");
    /// assert!(friction.holds && (friction.right - 0.5994).abs() < 1e-4);
    /// # Ok::<(), standfast::InputError>(())
    /// ```
    pub fn explain(&self) -> Option<Trace> {
        let mode = self.verdict().mode()?;
        let terms = Terms::of(self);
        let mut steps = Vec::new();
        for &candidate in terms.candidates() {
            let holds = candidate == mode;
            steps.push(Step { mode: candidate, relations: terms.relations(candidate, mode), holds });
            if holds {
                break;
            }
        }
        Some(Trace { steps, others: self.others() })
    }

    /// Crossings at which the mode changes as the force or the friction varies; none if ω ≥ 1 and all is BF.
    pub fn margins(&self) -> CrushMargins {
        let (k, mu) = (self.point.k(), self.point.mu());
        let Ok(chart) = CrushChart::new(self.point.gamma(), self.point.k_prime(), self.omega) else {
            return CrushMargins { along_k: Vec::new(), along_mu: Vec::new() };
        };
        let (upper, lower) = (chart.upper_line(), chart.lower_line());
        let across = chart.rock_crossings(Curve::Line { slope: 0.0, intercept: mu });
        let mut forces = vec![mu, chart.k_a()];
        forces.extend([upper, lower].into_iter().filter_map(|line| line.k_at(mu)));
        forces.extend(across.into_iter().map(|point| point.k));
        let mut frictions = vec![k, upper.at(k), lower.at(k)];
        frictions.extend(chart.mu_star(k));
        let at = |k: f64, mu: f64| CrushPoint::new(chart.gamma(), chart.k_prime(), k, mu, self.omega);
        let mode = |k: f64, mu: f64| at(k, mu).ok().and_then(|point| point.verdict().mode());
        CrushMargins {
            along_k: changes(forces, |k| mode(k, mu)),
            along_mu: changes(frictions, |mu| mode(k, mu)),
        }
    }

    /// μ/k; infinite at k = 0.
    pub fn safety_against_sliding(&self) -> f64 {
        self.point.safety_against_sliding()
    }

    /// (1−ω)/(k γ |1+k'|), by the arm that is left of B; infinite where the force has no moment about the edge, and zero where ω ≥ 1.
    pub fn safety_against_overturning(&self) -> f64 {
        if self.omega >= 1.0 { 0.0 } else { (1.0 - self.omega) * self.point.safety_against_overturning() }
    }
}

/// The changes among some values at which there may be any: decided between them, and at zero.
fn changes(mut values: Vec<f64>, mode: impl Fn(f64) -> Option<Mode>) -> Vec<Crossing> {
    values.retain(|value| *value > 0.0 && *value < 1e50);
    values.sort_by(f64::total_cmp);
    // Values that differ by rounding are one.
    values.dedup_by(|later, earlier| *later - *earlier <= 1e-12 * *later);
    let beyond = values.last().map_or(1.0, |last| 2.0 * last);
    values.push(beyond);
    let mut found = Vec::new();
    let (mut at, mut before) = (0.0, mode(0.0));
    for next in values {
        let now = mode(at + (next - at) / 2.0);
        if let (Some(from), Some(to)) = (before, now)
            && from != to
        {
            found.push(Crossing { at, from, to });
        }
        (at, before) = (next, now);
    }
    found
}

/// Terms of which the inequalities of a point are made.
struct Terms {
    point: CrushPoint,
    chart: CrushChart,
    /// α of a body that rocks, and N.
    alpha: f64,
    normal: f64,
    /// The signs of μ − k, k − k_A, and of μ less the lines above and below.
    slides: Ordering,
    tips: Ordering,
    above: Ordering,
    below: Ordering,
}

impl Terms {
    fn of(point: &CrushPoint) -> Terms {
        let rigid = &point.point;
        let chart = CrushChart::new(rigid.gamma(), rigid.k_prime(), point.omega)
            .expect("a verdict that is a mode has ω < 1");
        let [γ, h, k, μ, ω] =
            [rigid.gamma(), rigid.k_prime(), rigid.k(), rigid.mu(), point.omega].map(Exact::of);
        let room = Exact::of(1.0) - ω;
        let sign = |value: Exact| value.sign();
        let turning = γ.clone() * (μ.clone() + k.clone() * h.clone());
        let lever = γ * (Exact::of(1.0) + h);
        let tipping = if rigid.k_prime() < -1.0 { -(lever * k.clone()) } else { lever * k.clone() };
        let alpha = chart.rotation(rigid.k()).unwrap_or(0.0);
        Terms {
            point: *point,
            chart,
            alpha,
            normal: chart.normal(alpha),
            slides: sign(μ - k),
            tips: sign(tipping - room.clone()),
            above: sign(turning.clone() - room.clone()),
            below: sign(turning + room),
        }
    }

    fn is_beyond(&self) -> bool {
        self.point.point.k_prime() < -1.0
    }

    /// The modes in the order of the decision.
    fn candidates(&self) -> &'static [Mode] {
        use Mode::{
            Rest, RockO, RockOPrime, SlideLeft, SlideRockOLeft, SlideRockOPrimeLeft, SlideRockOPrimeRight,
            SlideRockORight,
        };
        match self.point.point.k_prime() {
            h if h < -1.0 => &[Rest, SlideLeft, RockOPrime, SlideRockOPrimeLeft, SlideRockOPrimeRight],
            h if h < 0.0 => &[Rest, SlideRockOPrimeLeft, SlideLeft, RockO, SlideRockOLeft, SlideRockORight],
            _ => &[Rest, SlideLeft, RockO, SlideRockOLeft, SlideRockORight],
        }
    }

    /// The inequalities of `mode`, given that the modes before it do not hold and that `begins` is the one that does.
    fn relations(&self, mode: Mode, begins: Mode) -> Vec<Relation> {
        use Sign::{Greater, GreaterOrEqual, Less, LessOrEqual};
        let (k, mu) = (self.point.point.k(), self.point.point.mu());
        let relation = |equation, (quantity, left), sign: Sign, (bound, right), ordering: Ordering| {
            Relation { equation, quantity, left, sign, bound, right, holds: sign.holds(ordering) }
        };
        let (force, friction) = (("k", k), ("μ", mu));
        let k_a = ("(1−ω)/(γ|1+k'|)", self.chart.k_a());
        let upper = ("(1−ω)/γ − k k'", self.chart.upper_line().at(k));
        let lower = ("−(1−ω)/γ − k k'", self.chart.lower_line().at(k));
        let resting = |sign| relation("edge", force, sign, k_a, self.tips);
        let against_upper = |sign| relation("edge", friction, sign, upper, self.above);
        let against_lower = |sign| relation("edge", friction, sign, lower, self.below);
        // Rock's own reaction, about the neutral point.
        let g = if self.is_beyond() { -self.point.point.gamma() } else { self.point.point.gamma() };
        let pull = (k - g * self.alpha) / self.normal;
        let stick = |sign: Sign, bound: (&'static str, f64), holds: bool| Relation {
            equation: "neutral point",
            quantity: "μ",
            left: mu,
            sign,
            bound: bound.0,
            right: bound.1,
            holds,
        };
        let [both, one, other] = if self.is_beyond() {
            ["|k + γα|/N", "(k + γα)/N", "−(k + γα)/N"]
        } else {
            ["|k − γα|/N", "(k − γα)/N", "−(k − γα)/N"]
        };
        match (mode, mode.corner(), mode.slip()) {
            (Mode::Rest, ..) => {
                vec![relation("friction", friction, GreaterOrEqual, force, self.slides), resting(LessOrEqual)]
            }
            (_, None, _) => {
                let mut all = vec![relation("friction", friction, Less, force, self.slides)];
                if !self.is_beyond() {
                    all.push(against_upper(LessOrEqual));
                }
                if self.point.point.k_prime() < 0.0 {
                    all.push(against_lower(GreaterOrEqual));
                }
                all
            }
            (_, Some(_), None) if self.tips != Ordering::Greater => vec![resting(Greater)],
            (_, Some(_), None) => {
                vec![resting(Greater), stick(GreaterOrEqual, (both, pull.abs()), mode == begins)]
            }
            // A force below the base may turn the body by friction that slips, though it would not tip if it stuck.
            (_, Some(Corner::OPrime), Some(_)) if !self.is_beyond() || self.tips != Ordering::Greater => {
                vec![against_lower(Less)]
            }
            (_, Some(_), Some(Slip::Left)) => {
                vec![resting(Greater), stick(Less, (one, pull), mode == begins)]
            }
            (_, Some(_), Some(Slip::Right)) => {
                vec![resting(Greater), stick(Less, (other, -pull), mode == begins)]
            }
        }
    }
}
