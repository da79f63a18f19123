//! A situation whose numbers are those that were written, where f64 cannot tell on which side of a boundary it stands.
//!
//! Every condition of the [contact problem](crate::contact) is a polynomial in the numbers of a block and its wrench, and these are
//! fractions of what a person wrote: 3 m, 2.4 t/m³, 264.870 kN/m. So each sign is that of a fraction of whole numbers. Where a
//! number is not rational, as under Goda's wave, its bound is carried on, and a sign within it is *on the boundary, to the digits
//! given*: then what begins with a little less or a little more counts as consistent, too. The margins of rest are
//!
//! ```text
//! μP − |X|        b₁P + Xd − M        b₂P − Xd + M        in N and N·m
//! ```

use std::cmp::Ordering;

use crate::approx::{Approx, Signed, sign};
use crate::ball::{Ball, COMPUTED, Scalar};
use crate::body::Body;
use crate::contact::{self, Choice, Numbers, REST, conditions, rest, rests_alone};
use crate::error::LARGEST;
use crate::exact::{Exact, Real};
use crate::footprint::Problem;
use crate::loads::LoadKind;
use crate::mode::{Corner, Mode, Modes};
use crate::motion::Motion;
use crate::neighbour::Neighbour;
use crate::relation::Relation;
use crate::stability::{GrossOverturning, Margins, Stability, beside_one};
use crate::stage::Stage;
use crate::verdict::Verdict;
use crate::wrench::Wrench;

use super::Situation;

/// Distance to a boundary, as a share of the terms of its condition, within which rounding in f64 is feared: thousands of roundings.
const NEAR: f64 = 1e-12;

/// Boundary of rest that a body stands on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Boundary {
    /// By the numbers as they are written: the body rests, on the edge of it.
    Exact,
    /// To the digits that its numbers are known to; the answer is not unique.
    ToTheDigits,
}

/// The numbers of the contact problem as they are written, with lengths in half-widths and forces in m g.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Written {
    /// b₁, b₂, d, ρ², m_x, m_y, μ_s, μ_k.
    block: [Ball; 8],
    permanent: Wrench<Ball>,
    variable: Wrench<Ball>,
    /// Moment of the horizontal forces about the base under the full load, counter-clockwise.
    turning: Ball,
    /// m g, N per metre run.
    weight: Ball,
    /// B, m.
    half_width: Ball,
    /// Its base seen from above, with all loads on it.
    pub(super) plan: Option<Problem<Ball>>,
}

/// Modes that begin under written numbers.
pub(super) struct WrittenChoice {
    pub(super) choice: Choice,
    pub(super) boundary: Option<Boundary>,
}

impl Written {
    /// The numbers of a situation.
    pub(super) fn of(situation: &Situation<Ball>) -> Written {
        let (body, sums) = (&situation.body, situation.sums());
        let half_width = body.width() / Ball::of(2.0);
        let weight = body.mass() * situation.gravity();
        let in_half_widths = |length: Ball| length / half_width.clone();
        let reduced = |wrench: &Wrench<Ball>| Wrench {
            x: wrench.x.clone() / weight.clone(),
            p: wrench.p.clone() / weight.clone(),
            m: in_half_widths(wrench.m.clone() / weight.clone()),
        };
        let block = [
            in_half_widths(body.heel_distance()),
            in_half_widths(body.toe_distance()),
            in_half_widths(body.centroid_height()),
            in_half_widths(in_half_widths(body.moment_of_inertia() / body.mass())),
            Ball::of(1.0) + situation.added_mass() / body.mass(),
            Ball::of(1.0),
            situation.static_friction(),
            situation.kinetic_friction(),
        ];
        let push = reduced(&(sums.permanent.clone() + sums.variable.clone())).x;
        let turning = reduced(&sums.by_kind[LoadKind::Horizontal as usize]).m - push * block[2].clone();
        let (permanent, variable) = (reduced(&sums.permanent), reduced(&sums.variable));
        let plan = situation.problem_on_plan();
        Written { block, permanent, variable, turning, weight, half_width, plan }
    }

    fn under(&self, Wrench { x, p, m }: Wrench<Ball>) -> Numbers<Ball> {
        let [b1, b2, d, rho2, m_x, m_y, mu_s, mu_k] = self.block.clone();
        [b1, b2, d, rho2, m_x, m_y, mu_s, mu_k, x, p, m]
    }

    fn at(&self, factor: &Ball) -> Numbers<Ball> {
        self.under(self.permanent.clone() + self.variable.clone() * factor.clone())
    }

    /// The modes that begin under a load factor.
    pub(super) fn choice(&self, factor: &Ball) -> WrittenChoice {
        let numbers = self.at(factor);
        let signs = conditions(&numbers).each_ref().map(Ball::sign);
        // What is not known is on its boundary.
        let mut choice = Choice::of_signs(&signs.map(|sign| sign.unwrap_or(Ordering::Equal)));
        let (of_rest, rests) = (&signs[..REST], choice.mode == Some(Mode::Rest));
        if of_rest.contains(&None) || (!rests && signs.contains(&None)) {
            let beside = beside(&numbers).flat_map(|modes| modes.iter().collect::<Vec<_>>());
            // Whether the body can rest is known, where the conditions of rest are.
            let rest_is_open = of_rest.contains(&None);
            let beside = beside.filter(|mode| *mode != Mode::Rest || rest_is_open);
            choice.modes = choice.modes.iter().chain(beside).collect();
            let boundary = (choice.modes.len() > 1).then_some(Boundary::ToTheDigits);
            return WrittenChoice { choice, boundary };
        }
        let at_an_edge = rests && of_rest.contains(&Some(Ordering::Equal));
        WrittenChoice { choice, boundary: at_an_edge.then_some(Boundary::Exact) }
    }

    /// The motion of a mode under a load factor, in half-widths and m g.
    pub(super) fn motion(&self, factor: &Ball, mode: Mode) -> Motion {
        contact::motion_in_decimals(&self.at(factor), mode)
    }

    /// The stages of the variable loads that rise from nothing without end.
    pub(super) fn path(&self) -> Vec<Stage> {
        let ends = self.crossings();
        let mut stages = Vec::new();
        for place in 0..=ends.len() {
            let from = place.checked_sub(1).map(|before| &ends[before]);
            let to = ends.get(place);
            // Beyond the last crossing any load factor will do.
            let inside = match (from, to) {
                (None, None) => Ball::of(1.0),
                (Some(from), None) => from.exact.clone() * Ball::of(2.0),
                (from, Some(to)) => {
                    let from = from.map_or(Ball::of(0.0), |from| from.exact.clone());
                    (from + to.exact.clone()) / Ball::of(2.0)
                }
            };
            let Choice { mode, modes } = self.choice(&inside).choice;
            let [from, to] =
                [from.map_or(0.0, |end| end.rounded), to.map_or(f64::INFINITY, |end| end.rounded)];
            Stage { from, to, verdict: mode.map(Verdict::Begins), modes }.join(&mut stages);
        }
        stages
    }

    /// The load factors above zero at which a condition changes its sign, in their order.
    fn crossings(&self) -> Vec<Crossing> {
        let [start, slope] =
            [&self.permanent, &self.variable].map(|wrench| conditions(&self.under(wrench.clone())));
        let largest = [&self.variable.x, &self.variable.p, &self.variable.m].map(|part| part.value().abs());
        let largest = largest.into_iter().fold(0.0, f64::max);
        let mut ends: Vec<Crossing> = start
            .into_iter()
            .zip(slope)
            .filter_map(|(start, slope)| Crossing::of(start, slope))
            .filter(|crossing| crossing.rounded * largest < LARGEST / 4.0)
            .collect();
        let apart = |one: &Crossing, two: &Crossing| (one.exact.clone() - two.exact.clone()).sign();
        ends.sort_by(|one, two| apart(one, two).unwrap_or(Ordering::Equal));
        ends.dedup_by(|later, earlier| apart(later, earlier).is_none_or(Ordering::is_eq));
        ends
    }

    /// Puts what the written numbers leave in the place of what f64 left, in margins and factors: they are then on the side of zero
    /// and of 1 on which the mode is.
    pub(super) fn settle(
        &self,
        body: &Body,
        heel: Corner,
        (margins, stability, gross): (&mut Margins, &mut Stability, &mut GrossOverturning),
    ) {
        let numbers = self.at(&Ball::of(1.0));
        let [pulled_left, pulled_right, about_o, about_o_prime] = rest(&numbers);
        let [.., x, pressing, _] = numbers;
        let (sliding, push) = if x.value() < 0.0 { (-pulled_left, -x) } else { (-pulled_right, x) };
        let ([about_heel, about_toe], turning) = match heel {
            Corner::O => ([about_o, about_o_prime], self.turning.clone()),
            Corner::OPrime => ([about_o_prime, about_o], -self.turning.clone()),
        };
        let moment = self.weight.clone() * self.half_width.clone();
        *margins = Margins {
            sliding: left(&sliding, &self.weight),
            overturning_about_heel: left(&about_heel, &moment),
            overturning_about_toe: left(&about_toe, &moment),
        };
        if pressing.sign() == Some(Ordering::Greater) {
            // From the nearer corner, beside which it may stand.
            let arm = |margin: &Ball| left(&(margin.clone() / pressing.clone()), &self.half_width);
            let [from_heel, from_toe] = [&about_heel, &about_toe].map(arm);
            let arm = if from_heel <= from_toe { from_heel } else { body.base_width() - from_toe };
            stability.bear(body, left(&pressing, &self.weight), arm);
        }
        settle(&mut stability.sliding, &sliding, &push);
        settle(&mut stability.overturning_about_heel, &about_heel, &turning);
        settle(&mut stability.overturning_about_toe, &about_toe, &-turning);
        for (factor, margin) in [(&mut gross.about_heel, &about_heel), (&mut gross.about_toe, &about_toe)] {
            if (*factor - 1.0).abs() <= 1e-9 {
                *factor = beside_one(*factor, sign(margin));
            }
        }
    }
}

/// A load factor at which a condition changes its sign.
struct Crossing {
    exact: Ball,
    /// In f64, on the side of 1 on which it is.
    rounded: f64,
}

impl Crossing {
    /// The crossing above zero of a condition that is `start` under the permanent loads and grows by `slope`.
    fn of(start: Ball, slope: Ball) -> Option<Crossing> {
        let exact = -start.clone() / slope.clone();
        if exact.sign() != Some(Ordering::Greater) {
            return None;
        }
        let rounded = match (start.clone() + slope).sign() {
            None | Some(Ordering::Equal) => 1.0,
            // It has its sign yet under the full load.
            full if full == start.sign() => exact.value().max(1.0 + f64::EPSILON),
            _ => exact.value().min(1.0 - f64::EPSILON / 2.0),
        };
        Some(Crossing { exact, rounded })
    }
}

/// What is left of a number times its unit: nothing, where its sign is not known.
fn left(number: &Ball, unit: &Ball) -> f64 {
    let is_zero = number.sign().is_none_or(Ordering::is_eq);
    if is_zero { 0.0 } else { (number.clone() * unit.clone()).value() }
}

/// Puts a factor, resistance over `action`, where the written numbers have it; one that is none of the two stays.
fn settle(factor: &mut f64, margin: &Ball, action: &Ball) {
    if action.sign() == Some(Ordering::Greater) && *factor > 0.0 {
        let exact = (margin.clone() + action.clone()) / action.clone();
        *factor = beside_one(exact.value(), sign(margin));
    }
}

/// The modes of a push and a moment a little less and a little more, in f64: far enough away for it to tell.
fn beside(numbers: &Numbers<Ball>) -> impl Iterator<Item = Modes> {
    let numbers = numbers.each_ref().map(Ball::value);
    let sides = [1.0 - 16.0 * COMPUTED, 1.0 + 16.0 * COMPUTED];
    sides.into_iter().flat_map(move |push| sides.map(|turn| (push, turn))).map(move |(push, turn)| {
        let mut beside = numbers;
        beside[WRENCH] *= push;
        beside[WRENCH + 2] *= turn;
        contact::decide(|| beside.map(Approx::of), || beside.map(Exact::of)).modes
    })
}

/// An inequality with both sides on one number, where no more than rounding parts them.
pub(super) fn settled(relation: Relation) -> Relation {
    let size = relation.left.abs().max(relation.right.abs());
    let is_one = (relation.left - relation.right).abs() <= NEAR * size;
    Relation { left: if is_one { relation.right } else { relation.left }, ..relation }
}

/// True if a condition under the permanent or under the full load is within rounding of its boundary. Sums may be off by [`NEAR`] of the
/// sizes of the parts; arms are no longer than the body is wide and high.
pub(super) fn is_near(situation: &Situation) -> bool {
    if let Some(is_near) = situation.is_near_on_plan() {
        return is_near;
    }
    let body = situation.body();
    let reach = body.width() + body.height() + body.base_width();
    // What acts, and the sizes of its parts: the permanent loads, and all.
    let mut sums = [(Wrench::ZERO, Wrench::ZERO); 2];
    for load in situation.loads() {
        let wrench = situation.wrench_of(load);
        let [x, p] = [wrench.x.abs(), wrench.p.abs()];
        // A force whose moment about the centre of mass is small may have come of large parts.
        let size = Wrench { x, p, m: wrench.m.abs() + (x + p) * reach };
        for sum in &mut sums[usize::from(!load.permanent)..] {
            *sum = (sum.0 + wrench, sum.1 + size);
        }
    }
    let block = situation.reduced_block().0;
    sums.into_iter().any(|(wrench, size)| {
        let (wrench, off) = (situation.reduced_wrench(&wrench), situation.reduced_wrench(&size));
        let mut numbers = contact::numbers(&block, &wrench).map(Approx::of);
        for (number, off) in numbers[WRENCH..].iter_mut().zip([off.x, off.p, off.m]) {
            *number = Approx::around(number.value(), NEAR * off);
        }
        // Most bodies rest by far, and fewer numbers tell that.
        !rests_alone(&numbers) && conditions(&numbers).iter().any(|condition| condition.sign().is_none())
    })
}

/// Where X, P and M begin among the numbers.
const WRENCH: usize = 8;
