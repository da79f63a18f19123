//! The classical checks of a caisson: safety factors and bearing pressure at both edges of the base.
//!
//! ```text
//! SF_sliding = μ(W' − U)/P        SF_overturning_net = (W' t − M_U)/M_p, about the heel
//!                                 (W'(B_c − t) − U B_c + M_U)/(−M_p), about the toe, where the force turns that way
//! W_e = W' − U                    t_e = (W' t − M_U − M_p)/W_e
//!
//! B_c/3 ≤ t_e ≤ 2B_c/3:   p_heel = (W_e/B_c)(4 − 6t_e/B_c)      p_toe = (W_e/B_c)(6t_e/B_c − 2)      contact over B_c
//! t_e < B_c/3:            p_heel = 2W_e/(3t_e)                  p_toe = 0                            contact over 3t_e
//! t_e > 2B_c/3:           p_toe = 2W_e/(3(B_c − t_e))           p_heel = 0                           over 3(B_c − t_e)
//! t_e ≤ 0, t_e ≥ B_c:     the base cannot carry the resultant at rest
//! ```
//!
//! Goda takes buoyancy and uplift off the weight, which makes its moment less. By gross moments water under the base is a load that
//! turns the body, and the weight resists in full. With U_s, M_s the uplift of still water, buoyancy, and its moment about the heel:
//!
//! ```text
//! SF_gross = (W' t + M_s)/(M_s + M_U + M_p), about the heel
//!            ((W' + U_s) B_c − W' t − M_s)/((U_s + U) B_c − M_s − M_U − M_p), about the toe
//! ```
//!
//! It is 1 where the resultant of all loads passes the corner, as Goda's is; elsewhere it is nearer to 1. P and M_p are those of all
//! horizontal loads together, water on both sides among them.
//!
//! The margin of each inequality of rest is a number on both sides of it, not negative while it holds; all three together are rest:
//!
//! ```text
//! margin_sliding = μ(W' − U) − P                         ≥ 0
//! margin_overturning = W' t − M_U − M_p                  ≥ 0, about the heel
//!                      W'(B_c − t) − U B_c + M_U + M_p   ≥ 0, about the toe
//! ```
//!
//! They say whether the body stays at rest. Which mode begins when it does not, they cannot say.

use std::cmp::Ordering;

use crate::body::Body;
use crate::mode::Corner;
use crate::plan::{CirclePressure, Plan, circle_pressure};
use crate::wrench::Wrench;

/// Vertical and horizontal actions on a caisson as a designer adds them up; N and N·m per metre run, about the heel.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ClassicalActions {
    /// The corner they are taken about: O, or O' if the horizontal force points right (without one, if the moment turns the
    /// body that way).
    pub heel: Corner,
    /// W', N/m: weight less buoyancy.
    pub buoyant_weight: f64,
    /// t, m: its arm to the heel.
    pub weight_arm: f64,
    /// U, N/m.
    pub uplift: f64,
    /// M_U, N·m/m: its moment about the heel.
    pub uplift_moment: f64,
    /// P, N/m: towards the heel.
    pub force: f64,
    /// M_p, N·m/m: its moment about the base.
    pub force_moment: f64,
}

/// State of the pressure on the base.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Bearing {
    /// Linear over the contact.
    Pressed {
        /// At the heel, Pa; zero where it is unloaded.
        heel: f64,
        /// At the toe, Pa; zero where it is unloaded.
        toe: f64,
        /// The length of the contact, m.
        contact: f64,
        /// The share of the base's area that is in contact.
        share: f64,
    },
    /// The resultant of all loads misses the base: the base cannot carry it at rest.
    OutsideBase,
    /// Nothing presses the body on its base: W' ≤ U.
    Lifted,
    /// The base is one seen from above, of which no pressure is told.
    OnPlan,
}

impl Bearing {
    /// The larger of both pressures, Pa.
    pub fn largest(&self) -> Option<f64> {
        match *self {
            Bearing::Pressed { heel, toe, .. } => Some(heel.max(toe)),
            Bearing::OutsideBase | Bearing::Lifted | Bearing::OnPlan => None,
        }
    }
}

/// The classical results.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stability {
    /// SF_sliding; infinite without a horizontal force.
    pub sliding: f64,
    /// The factor against overturning about the heel; infinite where no force turns the body that way, and zero where it turns
    /// without one, by uplift or eccentric weight alone.
    pub overturning_about_heel: f64,
    /// The factor about the other corner, the toe: a force far below the centre of mass turns the body about it.
    pub overturning_about_toe: f64,
    /// t_e, m: distance of the resultant from the heel; `None` if nothing presses.
    pub resultant_arm: Option<f64>,
    /// The pressure on the base.
    pub bearing: Bearing,
}

impl Stability {
    /// e = |B_c/2 − t_e|, m: how far from the middle of a base `base_width` wide the resultant acts; `None` if nothing presses.
    pub fn eccentricity(&self, base_width: f64) -> Option<f64> {
        // What rounding leaves of an arm that is half the base is no eccentricity.
        let rounding = 8.0 * f64::EPSILON * base_width;
        let eccentricity = self.resultant_arm.map(|arm| (base_width / 2.0 - arm).abs());
        eccentricity.map(|eccentricity| if eccentricity <= rounding { 0.0 } else { eccentricity })
    }

    /// SF_overturning_net: the lesser of the factors about both corners.
    pub fn overturning(&self) -> f64 {
        self.overturning_about_heel.min(self.overturning_about_toe)
    }

    /// Puts the resultant W_e = `pressing` at t_e = `arm` from the heel.
    pub(crate) fn bear(&mut self, body: &Body, pressing: f64, arm: f64) {
        self.resultant_arm = Some(arm);
        self.bearing = bearing(pressing, arm, body.base_width(), body.plan());
    }
}

/// Margins of the inequalities of rest: none is negative of a body that can rest, and one is of a body that cannot. Unlike safety factors
/// they change steadily where a force vanishes, changes its direction or lifts the body.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Margins {
    /// μ(W' − U) − P, N per metre run.
    pub sliding: f64,
    /// W' t − M_U − M_p, N·m per metre run: the moment about the heel that presses the body on its base. Both moments together are
    /// (W' − U) B_c, so that of a body that is lifted one is negative.
    pub overturning_about_heel: f64,
    /// W'(B_c − t) − U B_c + M_U + M_p, N·m per metre run: the same about the toe.
    pub overturning_about_toe: f64,
}

impl Margins {
    /// The lesser of the moments about both corners.
    pub fn overturning(&self) -> f64 {
        self.overturning_about_heel.min(self.overturning_about_toe)
    }
}

/// Overturning by gross moments: the whole weight against all pressures of water under the base and the horizontal force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GrossOverturning {
    /// U_s, N/m: buoyancy that is among the loads; zero where there is none.
    pub buoyancy: f64,
    /// M_s, N·m/m: its moment about the heel.
    pub buoyancy_moment: f64,
    /// The factor about the heel; infinite where nothing turns the body that way.
    pub about_heel: f64,
    /// The factor about the toe.
    pub about_toe: f64,
}

impl GrossOverturning {
    /// The factors of `actions` on `body`, whose W' is what `buoyancy` leaves of the weight.
    pub fn of(body: &Body, actions: &ClassicalActions, buoyancy: &Wrench) -> GrossOverturning {
        let buoyancy_moment = 0.0 - resisting(actions.heel, body, buoyancy);
        let none = GrossOverturning {
            buoyancy: 0.0 - buoyancy.p,
            buoyancy_moment,
            about_heel: f64::INFINITY,
            about_toe: f64::INFINITY,
        };
        none.held_by(body, actions, [0.0; 2])
    }

    /// The factors with more moments that hold the body about the heel and about the toe.
    pub(crate) fn held_by(
        self,
        body: &Body,
        actions: &ClassicalActions,
        [heel, toe]: [f64; 2],
    ) -> GrossOverturning {
        let ClassicalActions { buoyant_weight, weight_arm, uplift, uplift_moment, force_moment, .. } =
            *actions;
        let GrossOverturning { buoyancy, buoyancy_moment, .. } = self;
        let base = body.base_width();
        // What is sucked down holds the body as its weight does.
        let (up, down) = match uplift < 0.0 {
            false => ([uplift, uplift_moment], [0.0; 2]),
            true => ([0.0; 2], [-uplift, -uplift_moment]),
        };
        let resisting = buoyant_weight * weight_arm + buoyancy_moment + down[1];
        let turning = buoyancy_moment + up[1] + force_moment;
        let about_toe =
            [(buoyant_weight + buoyancy + down[0]) * base - resisting, (buoyancy + up[0]) * base - turning];
        GrossOverturning {
            buoyancy,
            buoyancy_moment,
            about_heel: ratio(resisting + heel, turning),
            about_toe: ratio(about_toe[0] + toe, about_toe[1]),
        }
    }

    /// True if the factor about the heel is the lesser.
    pub fn is_about_heel(&self) -> bool {
        self.about_heel <= self.about_toe
    }

    /// SF_overturning_gross: the lesser of the factors about both corners.
    pub fn overturning(&self) -> f64 {
        self.about_heel.min(self.about_toe)
    }
}

/// A safety factor: zero where the body is moved without any action, else infinite where nothing acts.
pub(crate) fn ratio(resistance: f64, action: f64) -> f64 {
    match () {
        () if resistance < 0.0 => 0.0,
        () if action > 0.0 => resistance / action,
        () => f64::INFINITY,
    }
}

/// A factor on the side of 1 that the sign of what it leaves says.
pub(crate) fn beside_one(factor: f64, left: Ordering) -> f64 {
    match left {
        Ordering::Equal => 1.0,
        Ordering::Less => factor.min(1.0 - f64::EPSILON / 2.0),
        Ordering::Greater => factor.max(1.0),
    }
}

impl ClassicalActions {
    /// The actions on `body` of vertical, uplift and horizontal loads.
    pub fn of(body: &Body, vertical: &Wrench, uplift: &Wrench, horizontal: &Wrench) -> ClassicalActions {
        let right = horizontal.x > 0.0 || horizontal.x == 0.0 && vertical.m + uplift.m + horizontal.m < 0.0;
        let heel = if right { Corner::OPrime } else { Corner::O };
        let (σ, _) = about(heel, body);
        let resisting = |wrench: &Wrench| resisting(heel, body, wrench);
        ClassicalActions {
            heel,
            buoyant_weight: vertical.p,
            weight_arm: if vertical.p == 0.0 { 0.0 } else { resisting(vertical) / vertical.p },
            uplift: 0.0 - uplift.p,
            uplift_moment: 0.0 - resisting(uplift),
            force: horizontal.x.abs(),
            force_moment: σ * (horizontal.m - horizontal.x * body.centroid_height()),
        }
    }

    /// Resistance: W' − U, and the moments of weight and uplift about the heel and about the toe.
    fn resistance(&self, body: &Body) -> [f64; 3] {
        let ClassicalActions { buoyant_weight, weight_arm, uplift, uplift_moment, .. } = *self;
        let pressing = buoyant_weight - uplift;
        let about_heel = buoyant_weight * weight_arm - uplift_moment;
        [pressing, about_heel, pressing * body.base_width() - about_heel]
    }

    /// Margins of the inequalities of rest, with friction μ.
    pub fn margins(&self, friction: f64, body: &Body) -> Margins {
        let [pressing, about_heel, about_toe] = self.resistance(body);
        Margins {
            sliding: friction * pressing - self.force,
            overturning_about_heel: about_heel - self.force_moment,
            overturning_about_toe: about_toe + self.force_moment,
        }
    }

    /// The factors against overturning about heel and toe, net, with more moments that hold the body there.
    pub(crate) fn overturning(&self, body: &Body, [heel, toe]: [f64; 2]) -> (f64, f64) {
        let [_, about_heel, about_toe] = self.resistance(body);
        (ratio(about_heel + heel, self.force_moment), ratio(about_toe + toe, -self.force_moment))
    }

    /// Safety factors with friction μ, and the pressure on the base of `body`.
    pub fn stability(&self, friction: f64, body: &Body) -> Stability {
        let base_width = body.base_width();
        let ClassicalActions { force, force_moment, .. } = *self;
        let [pressing, about_heel, _] = self.resistance(body);
        let resultant_arm = (pressing > 0.0).then(|| (about_heel - force_moment) / pressing);
        let (overturning_about_heel, overturning_about_toe) = self.overturning(body, [0.0; 2]);
        Stability {
            sliding: ratio(friction * pressing, force),
            overturning_about_heel,
            overturning_about_toe,
            resultant_arm,
            bearing: resultant_arm
                .map_or(Bearing::Lifted, |arm| bearing(pressing, arm, base_width, body.plan())),
        }
    }
}

/// The sense in which a body turns about its heel, 1 counter-clockwise, and the heel's distance from the centre of mass, m.
fn about(heel: Corner, body: &Body) -> (f64, f64) {
    match heel {
        Corner::O => (1.0, body.heel_distance()),
        Corner::OPrime => (-1.0, body.toe_distance()),
    }
}

/// The moment of a load about the heel that holds the body down: clockwise about O, or counter-clockwise about O'.
fn resisting(heel: Corner, body: &Body, wrench: &Wrench) -> f64 {
    let (σ, arm) = about(heel, body);
    wrench.p * arm - σ * wrench.m
}

/// The pressure of W_e = `pressing` at t_e = `arm` from the heel, on a base of this plan.
fn bearing(pressing: f64, arm: f64, base_width: f64, plan: Plan) -> Bearing {
    let share = arm / base_width;
    if !(share > 0.0 && share < 1.0) {
        return Bearing::OutsideBase;
    }
    match plan {
        Plan::Rectangle { length } => bearing_of_rectangle(pressing / length, arm, base_width),
        Plan::Circle => {
            let r = base_width / 2.0;
            let CirclePressure { most, least, contact, share } =
                circle_pressure(pressing, (arm - r).abs(), r);
            let [heel, toe] = if arm < r { [most, least] } else { [least, most] };
            Bearing::Pressed { heel, toe, contact, share }
        }
    }
}

/// The pressure of W_e, per metre of length.
fn bearing_of_rectangle(pressing: f64, arm: f64, base_width: f64) -> Bearing {
    let share = arm / base_width;
    let mean = pressing / base_width;
    let [heel, toe, contact] = if share < 1.0 / 3.0 {
        [2.0 * pressing / (3.0 * arm), 0.0, 3.0 * arm]
    } else if share > 2.0 / 3.0 {
        let from_toe = base_width - arm;
        [0.0, 2.0 * pressing / (3.0 * from_toe), 3.0 * from_toe]
    } else {
        [(mean * (4.0 - 6.0 * share)).max(0.0), (mean * (6.0 * share - 2.0)).max(0.0), base_width]
    };
    Bearing::Pressed { heel, toe, contact, share: contact / base_width }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The published check: W_e = 2196 kN/m at 8.618 m of 15 m gives 80.9 kPa at the heel and 211.9 kPa at the toe.
    #[test]
    fn both_edges_of_a_caisson() {
        let Bearing::Pressed { heel, toe, contact, .. } = bearing(2196e3, 8.618, 15.0, Plan::PER_METRE)
        else {
            panic!()
        };
        assert!((heel / 1e3 - 80.9).abs() < 0.05 && (toe / 1e3 - 211.9).abs() < 0.05, "{heel} {toe}");
        assert_eq!(contact, 15.0);
    }

    /// Whatever the arm: the pressures add up to the resultant, act where it does, and never pull.
    #[test]
    fn bearing_is_in_equilibrium() {
        let (pressing, base) = (3e5, 12.0);
        for i in 1..1200 {
            let arm = f64::from(i) * 0.01;
            let Bearing::Pressed { heel, toe, contact, .. } = bearing(pressing, arm, base, Plan::PER_METRE)
            else {
                panic!("{arm}")
            };
            assert!(heel >= 0.0 && toe >= 0.0 && contact <= base);
            // From the heel the contact begins at 0, or at base − contact where the heel is unloaded.
            let start = if heel == 0.0 { base - contact } else { 0.0 };
            let sum = (heel + toe) / 2.0 * contact;
            let moment = sum * start + (heel + 2.0 * toe) / 6.0 * contact * contact;
            assert!((sum / pressing - 1.0).abs() < 1e-12, "{arm}");
            assert!((moment / (pressing * arm) - 1.0).abs() < 1e-12, "{arm}");
        }
        for arm in [0.0, -1.0, 12.0, 13.0, f64::NAN] {
            assert_eq!(bearing(pressing, arm, base, Plan::PER_METRE), Bearing::OutsideBase);
        }
    }
}
