//! Outcomes on a base seen from above: whether the body rests, and if not, what ends rest as the variable loads rise.

use standfast::footprint::{BaseWrench, Footprint, PlanDeparture, PlanLimit, towards};
use standfast_probability::problem::Pieces;

use super::departure::{AT_ONCE, NEVER};
use super::lines::Line;
use super::outcome::{FLIGHT, LIFTED, NOT_A_BODY, PLAN_SLIDES, PLAN_TIPS, REST, nothing};
use super::problem::ChanceProblem;
use super::stack::{Asked, between};

/// A body on its base: where it bears, its friction, and its permanent and variable loads.
#[derive(Debug, Clone)]
struct OnPlan {
    footprint: Footprint,
    friction: f64,
    permanent: BaseWrench,
    variable: BaseWrench,
}

impl OnPlan {
    fn departure(&self, friction: f64) -> Option<PlanDeparture> {
        self.footprint.departure(friction, &self.permanent, &self.variable).ok()
    }

    fn at(&self, factor: f64) -> BaseWrench {
        self.permanent.plus(self.variable.times(factor))
    }

    /// The outcomes with a friction, a bit for each.
    fn outcomes(&self, friction: f64, asked: Asked) -> u64 {
        let Some(departure) = self.departure(friction) else { return 1 << NOT_A_BODY };
        let ended = departure.limits.first().map(|limit| match limit {
            PlanLimit::Slides | PlanLimit::Turns => PLAN_SLIDES,
            PlanLimit::Tips { .. } => PLAN_TIPS,
            PlanLimit::Lifts => FLIGHT,
        });
        match asked {
            Asked::Full => {
                let ended = if departure.rests { REST } else { ended.unwrap_or(PLAN_TIPS) };
                1 << ended | u64::from(self.at(1.0).p <= 0.0) << LIFTED
            }
            Asked::Departure if departure.at_once || departure.load_factor == 0.0 => 1 << AT_ONCE,
            Asked::Departure => 1 << ended.filter(|_| departure.load_factor.is_finite()).unwrap_or(NEVER),
        }
    }

    /// The outcomes along friction: what it takes to hold the body rises or falls with λ but has no greatest value between, so that it counts
    /// under no and under all variable loads, under endless ones, and where the body tips or is lifted.
    fn along_friction(&self, asked: Asked, pieces: &mut Pieces) {
        let held = self.footprint.departure_held(&self.permanent, &self.variable);
        let Ok(held) = held else { return nothing(pieces) };
        let needed = |wrench: &BaseWrench| self.footprint.on_friction(wrench) / wrench.p;
        let factors = [0.0, 1.0, held.load_factor];
        let at = factors.map(|factor| needed(&self.at(factor))).into_iter().chain([needed(&self.variable)]);
        between(at.collect(), pieces, |friction| self.outcomes(friction.max(0.0), asked));
    }
}

/// The distance in standard normals to which a law is looked at.
const REACH: f64 = 12.0;

fn less(one: BaseWrench, other: BaseWrench) -> BaseWrench {
    one.plus(other.times(-1.0))
}

/// Loads of which some turn: what stays, and what is added in proportion to the cosine and the sine of their direction.
struct Turning {
    stays: BaseWrench,
    cosine: BaseWrench,
    sine: BaseWrench,
}

impl Turning {
    /// The loads that are these in three directions: 0°, 90°, 180°.
    fn through([left, away, right]: [BaseWrench; 3]) -> Turning {
        let stays = left.plus(right).times(0.5);
        Turning { stays, cosine: less(left, stays), sine: less(away, stays) }
    }

    fn at(&self, degrees: f64) -> BaseWrench {
        // Whole at quarters of a turn.
        let [x, z] = towards(degrees);
        self.stays.plus(self.cosine.times(-x)).plus(self.sine.times(z))
    }

    fn plus(&self, other: &Turning) -> Turning {
        Turning {
            stays: self.stays.plus(other.stays),
            cosine: self.cosine.plus(other.cosine),
            sine: self.sine.plus(other.sine),
        }
    }
}

/// Directions at which a + b cos φ + c sin φ is zero, degrees.
fn zeros([a, b, c]: [f64; 3]) -> impl Iterator<Item = f64> {
    let (most, middle) = (b.hypot(c), c.atan2(b));
    let off = (a.abs() <= most && most > 0.0).then(|| (-a / most).acos());
    off.into_iter().flat_map(move |off| [middle - off, middle + off]).map(f64::to_degrees)
}

/// Directions from 0 to below 360 degrees, and those amid each two of them.
fn with_middles(all: &[f64]) -> Vec<f64> {
    let turn = |degrees: f64| degrees.rem_euclid(360.0);
    let mut marks: Vec<f64> = all.iter().copied().filter(|mark| mark.is_finite()).map(turn).collect();
    marks.sort_by(f64::total_cmp);
    let next = marks.iter().skip(1).copied().chain(marks.first().map(|first| first + 360.0));
    let middles: Vec<f64> = marks.iter().zip(next).map(|(one, two)| turn(0.5 * (one + two))).collect();
    marks.extend(middles);
    marks
}

impl OnPlan {
    /// Directions at which a condition of rest under the full load changes, or where what ends rest may, and one amid each two: edges, the
    /// circle of sliding, corners. In closed form of loads through the vertical of the centre of mass; elsewhere near enough to be looked at.
    fn marks_of_turning(&self, permanent: &Turning, variable: &Turning) -> Vec<f64> {
        let Turning { stays, cosine, sine } = permanent.plus(variable);
        let dot = |[a, b]: [f64; 2], [c, d]: [f64; 2]| a * c + b * d;
        let moment = |of: &BaseWrench| [of.q_x, of.q_z];
        let force = |of: &BaseWrench| [of.x, of.z];
        // |v| = r of a vector that turns about one that stays.
        let circle = |of: &dyn Fn(&BaseWrench) -> [f64; 2], radius: f64| {
            let [a, b, c] = [of(&stays), of(&cosine), of(&sine)];
            zeros([dot(a, a) + dot(b, b) - radius * radius, 2.0 * dot(a, b), 2.0 * dot(a, c)])
        };
        let mut marks: Vec<f64> = circle(&force, self.friction * stays.p).collect();
        if let Some(([x, z], radius)) = self.footprint.disc() {
            marks.extend(circle(&|of| [of.q_x - of.p * x, of.q_z - of.p * z], radius * stays.p));
        }
        for (normal, distance) in self.footprint.normals().into_iter().zip(self.footprint.distances()) {
            let [along_cosine, along_sine] = [dot(normal, moment(&cosine)), dot(normal, moment(&sine))];
            let edge = |all: f64| zeros([all, along_cosine, along_sine]);
            marks.extend(edge(dot(normal, moment(&stays)) - distance * stays.p));
            // Where an edge and the circle end rest at the same λ.
            marks.extend(edge(-distance * cosine.x.hypot(cosine.z) / self.friction));
            marks.push(along_sine.atan2(along_cosine).to_degrees());
        }
        let start = permanent.stays.centre_of_pressure().unwrap_or_default();
        marks.extend(self.footprint.vertices().iter().map(|[x, z]| {
            let to = [x - start[0], z - start[1]];
            dot(to, moment(&sine)).atan2(dot(to, moment(&cosine))).to_degrees()
        }));
        with_middles(&marks)
    }

    /// Values at which a condition of rest changes under loads that grow in proportion to a number, and one amid each two.
    fn marks_of_growing(&self, start: BaseWrench, slope: BaseWrench) -> Vec<f64> {
        let quadratic = |[a, b, c]: [f64; 3]| {
            let root = (b * b - 4.0 * a * c).sqrt();
            [(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)]
        };
        // |v| = r p.
        let circle = |[a, b]: [[f64; 2]; 2], radius: f64| {
            let dot = |[a, b]: [f64; 2], [c, d]: [f64; 2]| a * c + b * d;
            let square = radius * radius;
            quadratic([
                dot(b, b) - square * slope.p * slope.p,
                2.0 * (dot(a, b) - square * start.p * slope.p),
                dot(a, a) - square * start.p * start.p,
            ])
        };
        let mut marks: Vec<f64> = circle([&start, &slope].map(|of| [of.x, of.z]), self.friction).to_vec();
        if let Some(([x, z], radius)) = self.footprint.disc() {
            marks.extend(circle([&start, &slope].map(|of| [of.q_x - of.p * x, of.q_z - of.p * z]), radius));
        }
        for ([x, z], distance) in self.footprint.normals().into_iter().zip(self.footprint.distances()) {
            let beyond = |of: &BaseWrench| x * of.q_x + z * of.q_z - distance * of.p;
            marks.push(-beyond(&start) / beyond(&slope));
        }
        marks.retain(|mark| mark.is_finite());
        marks.sort_by(f64::total_cmp);
        let middles: Vec<f64> = marks.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).collect();
        marks.extend(middles);
        marks
    }
}

impl ChanceProblem {
    /// The body with these values of all numbers; none if they do not go together.
    fn plan_with(&self, values: &[f64]) -> Option<OnPlan> {
        let situation = self.situation_with(values)?;
        let [permanent, variable] = situation.base_wrenches()?;
        let apart = (0..values.len()).find(|place| self.is_apart(*place));
        let friction = apart.map_or(situation.static_friction(), |place| values[place]);
        Some(OnPlan { footprint: situation.plan()?.footprint.clone(), friction, permanent, variable })
    }

    /// The outcomes on a base seen from above with these values, a bit for each.
    pub(super) fn on_plan(&self, values: &[f64], asked: Asked) -> u64 {
        self.plan_with(values).map_or(1 << NOT_A_BODY, |plan| plan.outcomes(plan.friction, asked))
    }

    /// The outcomes on a base seen from above along the line.
    pub(super) fn plan_along(&self, values: &[f64], asked: Asked, pieces: &mut Pieces) {
        let at = |place: usize, value: f64| {
            let mut values = values.to_vec();
            values[place] = value;
            self.plan_with(&values)
        };
        match self.line {
            Line::Friction(place) => match at(place, 1.0) {
                Some(plan) => plan.along_friction(asked, pieces),
                None => nothing(pieces),
            },
            // Loads that are linear in a number are not assembled again for another value of it, nor are those that turn.
            Line::Load(place) => {
                let (Some(zero), Some(one)) = (at(place, 0.0), at(place, 1.0)) else {
                    return nothing(pieces);
                };
                let grows = |zero: BaseWrench, one: BaseWrench| [zero, less(one, zero)];
                let [permanent, variable] =
                    [grows(zero.permanent, one.permanent), grows(zero.variable, one.variable)];
                let grown = |[start, slope]: [BaseWrench; 2], value: f64| start.plus(slope.times(value));
                let [start, slope] = [0, 1].map(|which| permanent[which].plus(variable[which]));
                let marks = zero.marks_of_growing(start, slope);
                pieces.scan(&self.laws().law_at(place, values), &marks, |value| {
                    let (permanent, variable) = (grown(permanent, value), grown(variable, value));
                    OnPlan { permanent, variable, ..zero.clone() }.outcomes(zero.friction, asked)
                });
            }
            // Of a direction the boundaries of rest are known; what else happens is scanned about them.
            Line::Scan(place) if self.random()[place].is_direction() => {
                let quarters = [0.0, 90.0, 180.0].map(|degrees| at(place, degrees));
                let [Some(left), Some(away), Some(right)] = quarters else { return nothing(pieces) };
                let permanent = Turning::through([left.permanent, away.permanent, right.permanent]);
                let variable = Turning::through([left.variable, away.variable, right.variable]);
                let law = self.laws().law_at(place, values);
                let marks = left.marks_of_turning(&permanent, &variable);
                let turns = |of: f64| (of / 360.0).floor() as i32;
                let [from, to] = [-REACH, REACH].map(|u| law.value(u));
                let marks: Vec<f64> = (turns(from)..=turns(to))
                    .flat_map(|turn| marks.iter().map(move |mark| mark + 360.0 * f64::from(turn)))
                    .collect();
                pieces.scan(&law, &marks, |degrees| {
                    let (permanent, variable) = (permanent.at(degrees), variable.at(degrees));
                    OnPlan { permanent, variable, ..left.clone() }.outcomes(left.friction, asked)
                });
            }
            Line::Scan(place) => self.scan(place, values, pieces, |values| self.on_plan(values, asked)),
        }
    }
}
