//! A body that only rests and slides under constant loads on a base whose acceleration is made of lines: pieces of x are cubic, and a piece at
//! rest is a comparison. It is the same motion as that of the general machine, found some hundred times faster; whatever is not plain here,
//! ties and jumps among it, is left to that.

use standfast::{Mode, Modes, Slip};

use crate::outcome::{End, Event, MotionOutcome, Why};
use crate::problem::{Going, Initial, MotionProblem};
use standfast::history::Piece;

/// A share of what is compared below which nothing is decided here.
const TIE: f64 = 1e-9;

/// Loads and margins that do not change, per mass.
struct Constant {
    x: f64,
    p: f64,
    /// The least and the greatest X at which a body that rests has its reaction well inside the base.
    within: [f64; 2],
    /// Friction to stick and to slip.
    sticks: f64,
    slips: f64,
    m_x: f64,
}

impl Constant {
    fn of(problem: &MotionProblem) -> Option<Constant> {
        let block = &problem.block;
        let (mut x, mut p, mut m) = (0.0, problem.gravity, 0.0);
        for load in &problem.loads {
            let (&[start, f64::INFINITY], &[Piece::Line { value, slope: 0.0 }]) =
                (load.history.times(), load.history.pieces())
            else {
                return None;
            };
            if start > 0.0 {
                return None;
            }
            let ([px, py], [ux, uy]) = (load.at, load.direction);
            x += value * ux;
            p -= value * uy;
            m += value * (px * uy - py * ux);
        }
        let (sticks, slips) = (block.mu_s * p, block.mu_k * p);
        // The reaction lies on the base if −b₁P ≤ Xd − M ≤ b₂P; sliding, with the friction in place of X.
        let slack = TIE * p * (block.b1 + block.b2);
        let inside = |along: f64| {
            let moment = along * block.d - m;
            -block.b1 * p + slack < moment && moment < block.b2 * p - slack
        };
        if !(p > 0.0 && inside(slips) && inside(-slips)) {
            return None;
        }
        let at = |moment: f64| (moment + m) / block.d;
        let within = [at(-block.b1 * p + slack), at(block.b2 * p - slack)];
        Some(Constant { x, p, within, sticks, slips, m_x: block.m_x })
    }

    fn tips(&self, x: f64) -> bool {
        !(self.within[0] < x && x < self.within[1])
    }

    /// True if two sizes are too near to each other to be told apart here.
    fn tie(&self, one: f64, two: f64) -> bool {
        (one - two).abs() <= TIE * (self.p + one.abs() + two.abs())
    }
}

/// Events and sums of a motion as far as it is followed.
struct Course {
    events: Vec<Event>,
    x: f64,
    v: f64,
    slip: Option<Slip>,
    work: f64,
    way: f64,
    max_slide: [f64; 2],
}

impl Course {
    fn say(&mut self, t: f64, why: Why) {
        let state = self.slip.map_or(Mode::Rest, Mode::slide);
        if self.x.abs() > self.max_slide[0] {
            self.max_slide = [self.x.abs(), t];
        }
        self.events.push(Event { t, why, state, consistent: [state].into_iter().collect() });
    }

    /// X = `a` + `b` τ over a stretch of sliding.
    fn slide(&mut self, constant: &Constant, [a, b]: [f64; 2], τ: f64, s: f64) {
        let (over, rise) = ((a - s * constant.slips) / constant.m_x, b / constant.m_x);
        let v = self.v;
        let (two, three) = (over / 2.0, rise / 6.0);
        let way = τ * (v + τ * (two + τ * three));
        // ∫ X v dt
        let c = [a * v, a * over + b * v, a * rise / 2.0 + b * over, b * rise / 2.0];
        self.work += τ * (c[0] + τ * (c[1] / 2.0 + τ * (c[2] / 3.0 + τ * c[3] / 4.0)));
        self.x += way;
        self.way += s * way;
        self.v = v + τ * (over + τ * rise / 2.0);
    }
}

/// The motion, if it is as plain as that.
pub(super) fn slides_only(problem: &MotionProblem) -> Option<MotionOutcome> {
    let base = problem.base.horizontal.as_ref()?;
    if problem.base.vertical.is_some() || problem.initial != Initial::default() {
        return None;
    }
    let constant = Constant::of(problem)?;
    let (times, pieces) = (base.times(), base.pieces());
    if !(times[0] >= 0.0 && times[times.len() - 1].is_finite()) {
        return None;
    }
    if constant.x.abs() >= constant.sticks * (1.0 - TIE) || constant.tips(constant.x) {
        return None;
    }
    let mut found =
        Course { events: Vec::new(), x: 0.0, v: 0.0, slip: None, work: 0.0, way: 0.0, max_slide: [0.0; 2] };
    let mut before: Option<f64> = None;
    if let (0.0, Piece::Line { value, .. }) = (times[0], *pieces.first()?) {
        // A base that begins with a jump may move the body at once.
        let x = constant.x - value;
        if x.abs() > constant.sticks * (1.0 + TIE) && !constant.tips(x) {
            found.slip = Some(if x > 0.0 { Slip::Right } else { Slip::Left });
            before = Some(x);
        }
    }
    found.say(0.0, Why::Start);
    let quiet = (constant.sticks * (1.0 - TIE)).min(-constant.within[0]).min(constant.within[1]);
    for (piece, pair) in pieces.iter().zip(times.windows(2)) {
        let Piece::Line { value, slope } = *piece else { return None };
        let length = pair[1] - pair[0];
        let x = [constant.x - value, -slope];
        let last = x[0] + x[1] * length;
        if found.slip.is_none() && x[0].abs() < quiet && last.abs() < quiet {
            // It rests, whether the load jumps there or not.
            before = Some(last);
            continue;
        }
        if constant.tips(x[0]) || constant.tips(last) {
            return None;
        }
        match before {
            Some(before) if (before - x[0]).abs() > 1e-12 * (before.abs() + x[0].abs() + constant.p) => {
                return None;
            }
            // It begins with a jump that may move the body, later than at 0 or by a tie.
            None if x[0].abs() >= constant.sticks * (1.0 - TIE) => return None,
            _ => {}
        }
        before = Some(last);
        if found.slip.is_none() && last.abs() < constant.sticks {
            continue;
        }
        over(&constant, &mut found, x, pair[0], length)?;
        if found.events.len() > 1000 + pieces.len() {
            return None;
        }
    }
    let loads_end = times[times.len() - 1];
    let mut end = loads_end;
    if found.slip.is_some() {
        // Friction alone ends it.
        let s = found.slip.map_or(0.0, Slip::sign);
        let slows = constant.slips - s * constant.x;
        if slows <= TIE * constant.p {
            return None;
        }
        let τ = s * found.v * constant.m_x / slows * (1.0 + 1e-6);
        over(&constant, &mut found, [constant.x, 0.0], end, τ)?;
        end = end.max(found.events.last()?.t);
        if found.slip.is_some() {
            return None;
        }
    }
    // The general machine stops at its time, wherever the body is.
    if problem.t_max.is_some_and(|t_max| t_max <= end) {
        return None;
    }
    let since = found.events.last()?.t;
    found.events.push(Event { t: since, why: Why::Rest, state: Mode::Rest, consistent: Modes::NONE });
    let block = problem.block;
    Some(MotionOutcome {
        end: End::AtRest,
        slide: found.x,
        max_slide: found.max_slide[0],
        t_max_slide: found.max_slide[1],
        max_theta: 0.0,
        t_max_theta: 0.0,
        theta: 0.0,
        last: Initial {
            time: since,
            x: found.x,
            vx: Some(0.0),
            vy: Some(0.0),
            touching: Some([true, true]),
            going: Some(Going::Sticks),
            slide: Some([found.x; 2]),
            ..Initial::default()
        },
        past_balance: false,
        impacts: 0,
        t_rest: Some(since),
        t_rest_is_bound: false,
        t_final: end,
        loads_end,
        work: found.work,
        friction_loss: constant.slips * found.way,
        impact_loss: 0.0,
        kinetic: 0.0,
        potential: 0.0,
        unique: true,
        impulse_left_base: false,
        reduced_impacts: 0,
        bounces: 0,
        max_gap: 0.0,
        t_max_gap: 0.0,
        undetermined: 0,
        t_undetermined: 0.0,
        steps: Vec::new(),
        block,
        feet: [[0.0, -block.b1], [0.0, block.b2]],
        gravity: problem.gravity,
        first_y: block.d,
        events: found.events,
    })
}

/// A piece over which X = x₀ + x₁τ and the body slides, or may begin to.
fn over(constant: &Constant, found: &mut Course, x: [f64; 2], t: f64, length: f64) -> Option<()> {
    let mut at = 0.0;
    for _ in 0..8 {
        let now = x[0] + x[1] * at;
        let left = length - at;
        match found.slip {
            None => {
                let slip = if x[1] > 0.0 { Slip::Right } else { Slip::Left };
                let s = slip.sign();
                let τ = (constant.sticks - s * now) / (s * x[1]);
                if s * (now + x[1] * left) < constant.sticks {
                    return Some(());
                }
                // One that begins with the piece, or that the next one takes back, is for the general machine.
                if !(τ > 0.0 && τ < left) {
                    return None;
                }
                at += τ;
                (found.slip, found.v) = (Some(slip), 0.0);
                found.say(t + at, Why::Load);
            }
            Some(slip) => {
                let s = slip.sign();
                let (over, rise) = (s * (now - s * constant.slips) / constant.m_x, s * x[1] / constant.m_x);
                let speed = s * found.v;
                let begins = speed == 0.0;
                let root = if begins {
                    // Its own beginning divided out; with one friction it begins without acceleration too.
                    match over.abs() <= TIE * constant.p {
                        true if rise <= 0.0 => return None,
                        true => None,
                        false => Some(-2.0 * over / rise).filter(|_| rise < 0.0),
                    }
                } else {
                    // The first zero of speed + over τ + rise τ²/2.
                    let square = over * over - 2.0 * rise * speed;
                    let ways = square.sqrt() - over;
                    (square >= 0.0 && ways > 0.0).then(|| 2.0 * speed / ways)
                };
                let root = root.filter(|τ| *τ <= left);
                let τ = root.unwrap_or(left);
                if root.is_some() && τ <= 0.0 {
                    return None;
                }
                found.slide(constant, [now, x[1]], τ, s);
                if root.is_none() {
                    return Some(());
                }
                at += τ;
                (found.v, found.slip) = (0.0, None);
                let held = x[0] + x[1] * at;
                if constant.tie(held.abs(), constant.sticks) {
                    return None;
                }
                if held.abs() > constant.sticks {
                    found.slip = Some(if held > 0.0 { Slip::Right } else { Slip::Left });
                }
                found.say(t + at, Why::Stop);
                if at >= length {
                    return Some(());
                }
            }
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use standfast::contact::Block;

    use super::*;
    use crate::machine::{Keep, in_general};
    use crate::{History, LoadInTime};

    /// A block under seeded noise, with a side force in some cases, and with friction to stick above that to slip in others.
    fn problem(seed: u64) -> MotionProblem {
        let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
        let mut unit = move || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 11) as f64 / (1u64 << 53) as f64
        };
        let friction = 0.1 + 0.4 * unit();
        let mut block = Block::uniform(0.2, friction);
        if seed.is_multiple_of(3) {
            block.mu_s *= 1.2;
        }
        if seed.is_multiple_of(4) {
            block.m_x = 1.3;
        }
        let mut problem = MotionProblem::new(block, 9.81);
        let values: Vec<f64> = (0..400)
            .map(|i| {
                (1.0 - f64::from(i) / 400.0)
                    * if seed.is_multiple_of(5) { 1.0 } else { (f64::from(i) / 20.0).min(1.0) }
                    * 30.0
                    * friction
                    * (unit() - 0.5)
            })
            .collect();
        problem.base.horizontal = Some(History::samples(0.01 + 0.02 * unit(), &values).unwrap());
        if seed.is_multiple_of(2) {
            let history = History::constant(2.0 * friction).unwrap();
            problem.loads.push(LoadInTime {
                at: [0.1, 0.05],
                direction: [unit() - 0.5, 0.3],
                follows: false,
                history,
            });
        }
        problem
    }

    /// Motions by the quick way are those of the general machine.
    #[test]
    fn the_quick_way_is_the_same_motion() {
        let (mut quick, mut events, mut at_once) = (0, 0, 0);
        for seed in 0..300 {
            let problem = problem(seed);
            let general = in_general(&problem, Keep::default(), true).unwrap();
            let Some(found) = slides_only(&problem) else { continue };
            quick += 1;
            events += found.events.len();
            at_once += usize::from(found.events[0].state != Mode::Rest);
            let told = |outcome: &MotionOutcome| -> Vec<_> {
                outcome.events.iter().map(|event| (event.why, event.state, event.consistent)).collect()
            };
            assert_eq!(told(&found), told(&general), "{seed}");
            let near = |one: f64, two: f64, size: f64| {
                assert!((one - two).abs() <= 1e-11 * size, "{seed}: {one} {two}")
            };
            for (one, two) in found.events.iter().zip(&general.events) {
                near(one.t, two.t, 1.0);
            }
            near(found.slide, general.slide, general.max_slide);
            near(found.max_slide, general.max_slide, general.max_slide);
            near(found.t_max_slide, general.t_max_slide, 1.0);
            near(found.t_final, general.t_final, 1.0);
            near(found.work, general.friction_loss, general.friction_loss);
            near(found.friction_loss, general.friction_loss, general.friction_loss);
            assert_eq!(
                (found.end, found.unique, found.t_rest.is_some()),
                (general.end, general.unique, true)
            );
        }
        assert!(quick > 270 && events > 5000 && at_once > 20, "{quick} {events} {at_once}");
    }
}
