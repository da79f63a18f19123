//! The conditions that decide what begins on a base that crushes or on ground that fails.

use standfast::ground::GroundVerdict;
use standfast::ground::bearing::GroundPath;
use standfast::relation::{Relation, Sign};
use standfast::{Mode, Wrench};

use super::super::Assessed;
use crate::case::Limit;

impl Assessed {
    /// The conditions of what begins, with their numbers; of ground that fails, the one that does not hold.
    pub(in super::super) fn because_of_ground(&self) -> Vec<Relation> {
        let (Some(ground), Some(verdict)) = (&self.ground, self.verdict()) else { return Vec::new() };
        match (ground.limit, verdict) {
            (Some(Limit::Strength(strength)), _) => self.crushing(strength, verdict),
            (Some(Limit::Ground(soil)), _) => GroundPath::new(soil, &self.situation)
                .map_or_else(|_| Vec::new(), |path| self.failing(&path, verdict)),
            (None, _) => Vec::new(),
        }
    }

    /// On a base of `strength` q_u.
    fn crushing(&self, strength: f64, verdict: GroundVerdict) -> Vec<Relation> {
        use Sign::{Greater, GreaterOrEqual, Less, LessOrEqual};
        let body = self.situation.body();
        let Wrench { x, p, m } = self.outcome.full.wrench;
        let long = body.plan().side(body.width());
        let q = strength * long;
        let relation = |equation, quantity, left, sign, bound, right| Relation {
            equation,
            quantity,
            left,
            sign,
            bound,
            right,
            holds: true,
        };
        let carried = |sign, holds| Relation {
            holds,
            ..relation("bearing", "P", p, sign, "2B q_u", q * body.base_width())
        };
        let GroundVerdict::Begins(mode) = verdict else { return vec![carried(Less, false)] };
        let (mu_s, mu_k) = (self.situation.static_friction(), self.situation.kinetic_friction());
        let crushed = p * p / (2.0 * q);
        let [o, toe] = [crushed - body.heel_distance() * p, body.toe_distance() * p - crushed];
        let borne = |quantity, moment| {
            [
                relation("crushing", quantity, moment, GreaterOrEqual, "−b_1 P + P^2/(2 q)", o),
                relation("crushing", quantity, moment, LessOrEqual, "b_2 P − P^2/(2 q)", toe),
            ]
        };
        let d = body.centroid_height();
        let zero = |equation, quantity, left, sign| relation(equation, quantity, left, sign, "0", 0.0);
        let motion = self.motion();
        let Some(motion) = motion else { return Vec::new() };
        match (mode, mode.corner(), mode.slip()) {
            (Mode::Flight, ..) => vec![
                zero("separation", "ÿ_O", motion.lift_o, GreaterOrEqual),
                zero("separation", "ÿ_O'", motion.lift_o_prime, GreaterOrEqual),
            ],
            (_, None, None) => {
                let mut all = vec![relation("friction", "|X|", x.abs(), LessOrEqual, "μ_s P", mu_s * p)];
                all.extend(borne("X d − M", x * d - m));
                all
            }
            (_, None, Some(slip)) => {
                let mut all = vec![relation("slip", "|X|", x.abs(), Greater, "μ_s P", mu_s * p)];
                // Slipping with μ_k it may be that μ_s would hold the body upright, were it not to tip.
                if x.abs() <= mu_s * p {
                    all = vec![relation("slip", "|X|", x.abs(), Greater, "μ_k P", mu_k * p)];
                }
                let (name, sign) =
                    if slip.sign() < 0.0 { ("−μ_k d P − M", -1.0) } else { ("μ_k d P − M", 1.0) };
                all.extend(borne(name, sign * mu_k * d * p - m));
                all
            }
            (_, Some(_), slip) => {
                let α = motion.theta_ddot;
                let mut all = vec![zero("rotation", "θ̈", α, if α > 0.0 { Greater } else { Less })];
                all.push(match slip {
                    None => relation(
                        "friction",
                        "|f_x|",
                        motion.f_x.abs(),
                        LessOrEqual,
                        "μ_s f_y",
                        mu_s * motion.f_y,
                    ),
                    Some(slip) => {
                        zero("slip", "ẍ_O", motion.slip, if slip.sign() < 0.0 { Less } else { Greater })
                    }
                });
                all
            }
        }
    }

    /// On ground that can fail: R ≥ P of the body that rests or slides.
    fn failing(&self, path: &GroundPath, verdict: GroundVerdict) -> Vec<Relation> {
        use Sign::{Greater, GreaterOrEqual, LessOrEqual};
        let body = self.situation.body();
        let Wrench { x, p, .. } = self.outcome.full.wrench;
        let (mu_s, mu_k) = (self.situation.static_friction(), self.situation.kinetic_friction());
        let long = body.plan().side(body.width());
        let holds = verdict != GroundVerdict::BearingFailure;
        let rigid = self.outcome.full.mode;
        let slip = rigid.and_then(|mode| mode.slip());
        let slides = x.abs() > mu_s * p;
        let friction = match slides {
            false => Relation {
                equation: "friction",
                quantity: "|X|",
                left: x.abs(),
                sign: LessOrEqual,
                bound: "μ_s P",
                right: mu_s * p,
                holds: true,
            },
            true => Relation {
                equation: "slip",
                quantity: "|X|",
                left: x.abs(),
                sign: Greater,
                bound: "μ_s P",
                right: mu_s * p,
                holds: true,
            },
        };
        let towards = slip.unwrap_or(if x < 0.0 { standfast::Slip::Left } else { standfast::Slip::Right });
        let reaction = if slides { path.sliding_reaction(1.0, towards, mu_k) } else { path.reaction(1.0) };
        let Some(reaction) = reaction else { return Vec::new() };
        let resistance = path.ground().resistance(&reaction) * long;
        vec![
            friction,
            Relation {
                equation: "bearing",
                quantity: "R",
                left: resistance,
                sign: GreaterOrEqual,
                bound: "P",
                right: p,
                holds,
            },
        ]
    }
}
