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

use crate::approx::{Approx, Signed};
use crate::ball::{Ball, Scalar};
use crate::body::Body;
use crate::contact::path::{between, merged};
use crate::contact::{self, Choice, Numbers, REST, conditions};
use crate::error::{InputError, LARGEST};
use crate::exact::{Exact, Real};
use crate::mode::{Corner, Mode, Modes};
use crate::relation::Relation;
use crate::stability::{GrossOverturning, Margins, Stability};
use crate::stage::Stage;
use crate::wrench::Wrench;

use super::Situation;

/// Distance from a boundary, as a share of the terms of its condition, at which rounding in f64 is feared: thousands of roundings.
const NEAR: f64 = 1e-12;

/// Place of a body on the boundary of rest.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Boundary {
    /// By the numbers as they are written: the body rests, and does not with the least more load.
    Exact,
    /// To the digits that its numbers are known to; the answer is not unique.
    ToTheDigits,
}

/// The numbers of the contact problem as they are written, in metres and newtons.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Written {
    /// b₁, b₂, d, ρ², m_x, m_y, μ_s, μ_k.
    block: [Ball; 8],
    permanent: Wrench<Ball>,
    variable: Wrench<Ball>,
}

/// Choice of a mode by the numbers as they are written.
pub(super) struct WrittenChoice {
    pub(super) choice: Choice,
    pub(super) boundary: Option<Boundary>,
}

impl Written {
    /// The numbers of a situation.
    pub(super) fn of(situation: &Situation<Ball>) -> Written {
        let (body, sums) = (&situation.body, situation.sums());
        let block = [
            body.heel_distance(),
            body.toe_distance(),
            body.centroid_height(),
            body.moment_of_inertia() / body.mass(),
            Ball::of(1.0) + situation.added_mass() / body.mass(),
            Ball::of(1.0),
            situation.static_friction(),
            situation.kinetic_friction(),
        ];
        Written { block, permanent: sums.permanent, variable: sums.variable }
    }

    fn under(&self, Wrench { x, p, m }: Wrench<Ball>) -> Numbers<Ball> {
        let [b1, b2, d, rho2, m_x, m_y, mu_s, mu_k] = self.block.clone();
        [b1, b2, d, rho2, m_x, m_y, mu_s, mu_k, x, p, m]
    }

    fn wrench(&self, factor: &Ball) -> Wrench<Ball> {
        self.permanent.clone() + self.variable.clone() * factor.clone()
    }

    /// Choice of a mode under a load factor.
    pub(super) fn choice(&self, factor: &Ball) -> WrittenChoice {
        let wrench = self.wrench(factor);
        let conditions = conditions(&self.under(wrench.clone()));
        let signs = conditions.each_ref().map(Ball::sign);
        // What is not known is on its boundary.
        let mut choice = Choice::of_signs(&signs.map(|sign| sign.unwrap_or(Ordering::Equal)));
        if signs.iter().any(Option::is_none) {
            let beside = self.beside(&wrench).flat_map(|modes| modes.iter().collect::<Vec<_>>());
            choice.modes = choice.modes.iter().chain(beside).collect();
            let boundary = (choice.modes.len() > 1).then_some(Boundary::ToTheDigits);
            return WrittenChoice { choice, boundary };
        }
        let at_an_edge = signs[..REST].contains(&Some(Ordering::Equal)) && choice.mode == Some(Mode::Rest);
        WrittenChoice { choice, boundary: at_an_edge.then_some(Boundary::Exact) }
    }

    /// The modes of a push and a moment a little less and a little more, in f64: far enough away for it to tell.
    fn beside(&self, wrench: &Wrench<Ball>) -> impl Iterator<Item = Modes> {
        let numbers = self.under(wrench.clone()).map(|number| number.value());
        let sides = [1.0 - 4.0 * NEAR, 1.0 + 4.0 * NEAR];
        sides.into_iter().flat_map(move |push| sides.map(|turn| (push, turn))).map(move |(push, turn)| {
            let [.., x, _, m] = numbers;
            let mut numbers = numbers;
            (numbers[8], numbers[10]) = (x * push, m * turn);
            contact::decide(|| numbers.map(Approx::of), || numbers.map(Exact::of)).modes
        })
    }

    /// The stages of the variable loads that rise from nothing without end.
    pub(super) fn path(&self) -> Result<Vec<Stage>, InputError> {
        let [start, slope] =
            [&self.permanent, &self.variable].map(|wrench| conditions(&self.under(wrench.clone())));
        let largest = [&self.variable.x, &self.variable.p, &self.variable.m].map(|part| part.value().abs());
        let largest = largest.into_iter().fold(0.0, f64::max) / self.scale();
        let ends = start.into_iter().zip(slope).filter_map(|(start, slope)| {
            let factor = -start / slope;
            let is_one = (factor.clone() - Ball::of(1.0)).sign().is_none_or(Ordering::is_eq);
            let end = if is_one { 1.0 } else { factor.value() };
            (factor.sign() == Some(Ordering::Greater) && end * largest < LARGEST / 4.0).then_some(end)
        });
        let decided = |factor| {
            let Choice { mode, modes } = self.choice(&Ball::of(factor)).choice;
            Ok((mode, modes))
        };
        merged(between(ends.collect(), decided))
    }

    /// The size of its forces.
    fn scale(&self) -> f64 {
        self.permanent.p.value().abs().max(f64::MIN_POSITIVE)
    }

    /// Margins of the conditions of rest under the full load: of sliding, about O and about O'; and P.
    fn margins(&self) -> ([Ball; 3], Ball) {
        let [b1, b2, d, _, _, _, mu_s, _, x, p, m] = self.under(self.wrench(&Ball::of(1.0)));
        let push = if x.value() < 0.0 { -x.clone() } else { x.clone() };
        let moment = x * d - m;
        ([mu_s * p.clone() - push, b1 * p.clone() + moment.clone(), b2 * p.clone() - moment], p)
    }

    /// Puts what the written numbers leave in the place of what f64 left, in margins and factors: they are then on the side of zero
    /// and of 1 on which the mode is.
    pub(super) fn settle(
        &self,
        body: &Body,
        heel: Corner,
        (margins, stability, gross): (&mut Margins, &mut Stability, &mut GrossOverturning),
    ) {
        let ([sliding, about_o, about_o_prime], pressing) = self.margins();
        let [about_heel, about_toe] = match heel {
            Corner::O => [about_o, about_o_prime],
            Corner::OPrime => [about_o_prime, about_o],
        };
        let is_zero = |margin: &Ball| margin.sign().is_none_or(Ordering::is_eq);
        let left = |margin: &Ball| if is_zero(margin) { 0.0 } else { margin.value() };
        *margins = Margins {
            sliding: left(&sliding),
            overturning_about_heel: left(&about_heel),
            overturning_about_toe: left(&about_toe),
        };
        if pressing.sign() == Some(Ordering::Greater) {
            // From the nearer corner, beside which it may stand.
            let arm = |margin: &Ball| {
                if is_zero(margin) { 0.0 } else { (margin.clone() / pressing.clone()).value() }
            };
            let [from_heel, from_toe] = [&about_heel, &about_toe].map(arm);
            let arm = if from_heel <= from_toe { from_heel } else { body.base_width() - from_toe };
            stability.bear(body, pressing.value(), arm);
        }
        settle(&mut stability.sliding, &sliding);
        for (factor, margin) in [
            (&mut stability.overturning_about_heel, &about_heel),
            (&mut stability.overturning_about_toe, &about_toe),
            (&mut gross.about_heel, &about_heel),
            (&mut gross.about_toe, &about_toe),
        ] {
            settle(factor, margin);
        }
    }
}

/// Puts a factor that rounding may have put beside 1 on the side that its margin says.
fn settle(factor: &mut f64, margin: &Ball) {
    if (*factor - 1.0).abs() > 1e-9 {
        return;
    }
    *factor = match margin.sign() {
        None | Some(Ordering::Equal) => 1.0,
        Some(Ordering::Less) => factor.min(1.0 - f64::EPSILON / 2.0),
        Some(Ordering::Greater) => factor.max(1.0),
    };
}

/// Puts both sides of an inequality that rounding parts on one number.
pub(super) fn settle_relation(relation: &mut Relation) {
    let size = relation.left.abs().max(relation.right.abs());
    if (relation.left - relation.right).abs() <= NEAR * size {
        relation.left = relation.right;
    }
}

/// True if a condition under the permanent or under the full load is within rounding of its boundary. Sums may be off by [`NEAR`] of the
/// sizes of the parts; arms are no longer than the body is wide and high.
pub(super) fn is_near(situation: &Situation) -> bool {
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
        let mut numbers = contact::numbers(&block, &situation.reduced_wrench(&wrench)).map(Approx::of);
        let off = situation.reduced_wrench(&size);
        for (number, off) in numbers[WRENCH..].iter_mut().zip([off.x, off.p, off.m]) {
            *number = Approx::around(number.value(), NEAR * off);
        }
        conditions(&numbers).iter().any(|condition| condition.sign().is_none())
    })
}

/// Where X, P and M begin among the numbers.
const WRENCH: usize = 8;
