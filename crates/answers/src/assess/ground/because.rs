//! The conditions that decide what begins on a base that crushes or on ground that fails.

use standfast::ground::bearing::GroundPath;
use standfast::relation::{Relation, Sign};
use standfast::{Corner, Mode, Motion, Slip, Verdict};

use super::super::Assessed;
use crate::case::Limit;
use crate::units::Extent;

const fn holds(
    equation: &'static str,
    (quantity, left): (&'static str, f64),
    sign: Sign,
    (bound, right): (&'static str, f64),
) -> Relation {
    Relation { equation, quantity, left, sign, bound, right, holds: true }
}

const ZERO: (&str, f64) = ("0", 0.0);

impl Assessed {
    /// The conditions of what begins, with their numbers; of ground that fails, the one that does not hold among them.
    pub(in super::super) fn because_of_ground(&self) -> Vec<Relation> {
        let (Some(ground), Some(verdict)) = (&self.ground, self.verdict()) else { return Vec::new() };
        match ground.limit {
            Some(Limit::Strength(strength)) => self.crushing(strength, verdict),
            Some(Limit::Ground(soil)) => {
                let path = GroundPath::new(soil, &self.situation);
                path.map_or_else(|_| Vec::new(), |path| self.failing(&path, verdict))
            }
            None => Vec::new(),
        }
    }

    /// On a base of `strength` q_u.
    fn crushing(&self, strength: f64, verdict: Verdict) -> Vec<Relation> {
        use Sign::{Greater, GreaterOrEqual, Less, LessOrEqual};
        let body = self.situation.body();
        let omega = self.ground.as_ref().and_then(|ground| ground.omega).unwrap_or(0.0);
        let Verdict::Begins(mode) = verdict else {
            return vec![Relation { holds: false, ..holds("bearing", ("ω", omega), Less, ("1", 1.0)) }];
        };
        let Some(motion) = self.motion() else { return Vec::new() };
        let Motion { f_y, xi, .. } = *motion;
        let half = f_y / (2.0 * strength * body.plan().side(body.width()));
        let bounds = match self.extent {
            Extent::PerMetre => ["−b_1 + f_y/(2 q_u)", "b_2 − f_y/(2 q_u)"],
            Extent::Whole => ["−b_1 + f_y/(2 q_u L_b)", "b_2 − f_y/(2 q_u L_b)"],
        };
        let on_base = [
            holds("crushing", ("ξ", xi), GreaterOrEqual, (bounds[0], half - body.heel_distance())),
            holds("crushing", ("ξ", xi), LessOrEqual, (bounds[1], body.toe_distance() - half)),
        ];
        match (mode, mode.corner(), mode.slip()) {
            (Mode::Flight, ..) => vec![
                holds("separation", ("ÿ_O", motion.lift_o), GreaterOrEqual, ZERO),
                holds("separation", ("ÿ_O'", motion.lift_o_prime), GreaterOrEqual, ZERO),
            ],
            (_, None, None) => self.friction(motion).into_iter().chain(on_base).collect(),
            (_, None, Some(slip)) => [slipping(motion, slip)].into_iter().chain(on_base).collect(),
            (_, Some(corner), slip) => {
                let sign = if corner == Corner::O { Greater } else { Less };
                let turns = holds("rotation", ("θ̈", motion.theta_ddot), sign, ZERO);
                let friction = match slip {
                    None => self.friction(motion),
                    Some(slip) => Some(slipping(motion, slip)),
                };
                [turns].into_iter().chain(friction).collect()
            }
        }
    }

    /// That friction holds the body; nothing of a base that is not pressed.
    fn friction(&self, motion: &Motion) -> Option<Relation> {
        let share = ("|f_x|/f_y", motion.f_x.abs() / motion.f_y);
        let friction = ("μ", self.situation.static_friction());
        (motion.f_y > 0.0).then(|| holds("friction", share, Sign::LessOrEqual, friction))
    }

    /// On ground that can fail: R ≥ V of the body that rests or slides.
    fn failing(&self, path: &GroundPath, verdict: Verdict) -> Vec<Relation> {
        let full = &self.outcome.full;
        let (x, p) = (full.wrench.x, full.wrench.p);
        if verdict == Verdict::Begins(Mode::Flight) {
            return full
                .motion
                .iter()
                .map(|motion| holds("separation", ("f_y", motion.f_y), Sign::LessOrEqual, ZERO))
                .collect();
        }
        let friction = self.situation.static_friction();
        let slides = x.abs() > friction * p;
        let sign = if slides { Sign::Greater } else { Sign::LessOrEqual };
        let equation = if slides { "slip" } else { "friction" };
        let mut all: Vec<_> = (p > 0.0)
            .then(|| holds(equation, ("|X|/V", x.abs() / p), sign, ("μ", friction)))
            .into_iter()
            .collect();
        let towards = if x < 0.0 { Slip::Left } else { Slip::Right };
        let reaction = match slides {
            true => path.sliding_reaction(1.0, towards, self.situation.kinetic_friction()),
            false => path.reaction(1.0),
        };
        let factor = reaction.map_or(0.0, |reaction| path.ground().factor(&reaction));
        let bears = holds(
            "bearing",
            (if slides { "R_s/V" } else { "R/V" }, factor),
            Sign::GreaterOrEqual,
            ("1", 1.0),
        );
        all.push(Relation { holds: verdict != Verdict::BearingFailure, ..bears });
        all
    }
}

fn slipping(motion: &Motion, slip: Slip) -> Relation {
    let sign = if slip == Slip::Left { Sign::Less } else { Sign::Greater };
    holds("slip", ("ẍ_O", motion.slip), sign, ZERO)
}
