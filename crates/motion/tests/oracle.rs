//! One phase of rocking or slide-rock against another integrator: extrapolated midpoint steps of the equations as the theory writes
//! them, and the end of the phase by halving the time.

mod common;

use common::Random;
use standfast::Corner;
use standfast::contact::Block;
use standfast_motion::{History, Impact, Keep, LoadInTime, MotionProblem, Why, simulate};

/// x, θ, ẋ, θ̇ of a body that touches with a corner; y follows.
type State = [f64; 4];

struct Phase<'a> {
    problem: &'a MotionProblem,
    r: f64,
    /// Slip ±1; 0: stick.
    slip: f64,
}

/// θ̈, N, T and ẍ.
struct Now {
    α: f64,
    normal: f64,
    tangential: f64,
    x: f64,
}

impl Phase<'_> {
    fn wrench(&self, t: f64, θ: f64) -> [f64; 3] {
        let mut total = [0.0, self.problem.gravity, 0.0];
        for load in &self.problem.loads {
            let f = load.history.at(t);
            let (sin, cos) = θ.sin_cos();
            let turned = |v: [f64; 2]| [v[0] * cos - v[1] * sin, v[0] * sin + v[1] * cos];
            let r = turned(load.at);
            let u = if load.follows { turned(load.direction) } else { load.direction };
            total[0] += f * u[0];
            total[1] -= f * u[1];
            total[2] += f * (r[0] * u[1] - r[1] * u[0]);
        }
        if let Some(base) = &self.problem.base.horizontal {
            total[0] -= base.at(t);
        }
        if let Some(base) = &self.problem.base.vertical {
            total[1] += base.at(t);
        }
        total
    }

    fn now(&self, t: f64, [_, θ, _, ω]: State) -> Now {
        let Block { d, rho2, m_x, m_y, mu_k, .. } = self.problem.block;
        let (sin, cos) = θ.sin_cos();
        let (c, h) = (self.r * cos + d * sin, d * cos - self.r * sin);
        let [x, p, m] = self.wrench(t, θ);
        let (xx, pp) = (x - m_x * c * ω * ω, p - m_y * h * ω * ω);
        if self.slip == 0.0 {
            let α = (pp * c - xx * h + m) / (rho2 + m_x * h * h + m_y * c * c);
            let (normal, tangential) = (pp - m_y * c * α, -xx - m_x * h * α);
            Now { α, normal, tangential, x: (x + tangential) / m_x }
        } else {
            let hat = c - self.slip * mu_k * h;
            let α = (pp * hat + m) / (rho2 + m_y * c * hat);
            let normal = pp - m_y * c * α;
            let tangential = -self.slip * mu_k * normal;
            Now { α, normal, tangential, x: (x + tangential) / m_x }
        }
    }

    fn rate(&self, t: f64, state: State) -> State {
        let now = self.now(t, state);
        [state[2], state[3], now.x, now.α]
    }

    /// A step by Gragg's midpoint rule, extrapolated in the square of the substep.
    fn step(&self, t: f64, state: State, h: f64) -> State {
        let counts = [2u32, 4, 6, 8, 10, 12, 14];
        let mut table: Vec<State> = Vec::new();
        for (k, count) in counts.iter().enumerate() {
            let n = f64::from(*count);
            let s = h / n;
            let plus = |a: State, b: State, f: f64| std::array::from_fn::<f64, 4, _>(|i| a[i] + f * b[i]);
            let (mut before, mut at) = (state, plus(state, self.rate(t, state), s));
            for i in 1..*count {
                let next = plus(before, self.rate(t + f64::from(i) * s, at), 2.0 * s);
                (before, at) = (at, next);
            }
            let last = self.rate(t + h, at);
            table.push(std::array::from_fn(|i| 0.5 * (before[i] + at[i] + s * last[i])));
            for j in (0..k).rev() {
                let ratio = n / f64::from(counts[j]);
                let factor = ratio * ratio - 1.0;
                table[j] =
                    std::array::from_fn(|i| table[j + 1][i] + (table[j + 1][i] - table[j][i]) / factor);
            }
        }
        table[0]
    }

    /// By how much each condition of the phase holds, in the order of their names.
    fn margins(&self, t: f64, state: State) -> [(Why, f64); 4] {
        let Block { mu_s, d, .. } = self.problem.block;
        let now = self.now(t, state);
        let side = -self.r.signum();
        let h = d * state[1].cos() - self.r * state[1].sin();
        let slip = if self.slip == 0.0 { 1.0 } else { self.slip * (state[2] + h * state[3]) };
        let cone = if self.slip == 0.0 { mu_s * now.normal - now.tangential.abs() } else { 1.0 };
        [(Why::Impact, side * state[1]), (Why::Unload, now.normal), (Why::Cone, cone), (Why::Stop, slip)]
    }

    /// Follows the phase to its end.
    fn end(&self, t: f64, state: State, breaks: &[f64], limit: f64) -> Option<(f64, Why, State)> {
        let (mut t, mut state) = (t, state);
        const H: f64 = 0.02;
        let mut first = true;
        while t < limit {
            let stop = breaks.iter().copied().find(|b| *b > t + 1e-12).unwrap_or(f64::INFINITY);
            let h = H.min(stop - t);
            let next = self.step(t, state, h);
            // Margins that begin at zero are none in the first step.
            let failed = |t: f64, state: State| {
                self.margins(t, state).into_iter().find(|(_, margin)| *margin < 0.0).map(|(why, _)| why)
            };
            if failed(t + h, next).is_some() && !(first && h < H / 100.0) {
                let (mut low, mut high) = (if first { h * 1e-3 } else { 0.0 }, h);
                for _ in 0..60 {
                    let middle = 0.5 * (low + high);
                    if failed(t + middle, self.step(t, state, middle)).is_some() {
                        high = middle
                    } else {
                        low = middle
                    }
                }
                let last = self.step(t, state, high);
                return failed(t + high, last).map(|why| (t + high, why, last));
            }
            (t, state, first) = (t + h, next, false);
        }
        None
    }
}

/// A sine pulls; every phase of rock or slide-rock that the program finds ends for the other integrator at the same moment, for the same
/// reason, at the same pose.
#[test]
fn phases_end_as_another_integrator_has_it() {
    let mut checked = [0; 4];
    for seed in 0..300 {
        let mut random = Random::new(seed);
        let block = common::block(&mut random);
        let mut problem = MotionProblem::new(block, 1.0);
        let reach = block.mu_s.min(1.0 / block.d);
        let history =
            History::sine(reach * random.between(1.2, 4.0), random.between(1.0, 5.0), 0.0, 8.0).unwrap();
        let follows = random.of(2) == 0;
        let at = [random.between(-1.0, 1.0), block.d * random.between(-0.8, 0.9)];
        problem.loads.push(LoadInTime { at, direction: [0.98, random.between(-0.3, 0.3)], follows, history });
        problem.impact = Impact::Inelastic;
        problem.t_max = Some(8.0);
        let outcome = simulate(&problem, Keep { steps: true }).unwrap();
        for pair in outcome.events.windows(2).take(8) {
            let (Some(corner), begin, end) = (pair[0].state.corner(), pair[0].t, pair[1].t) else { continue };
            if end - begin < 0.05 || matches!(pair[1].why, Why::Overturned | Why::End | Why::Grip) {
                continue;
            }
            let r = if corner == Corner::O { -block.b1 } else { block.b2 };
            let slip = pair[0].state.slip().map_or(0.0, |slip| slip.sign());
            let phase = Phase { problem: &problem, r, slip };
            let before = outcome.at(begin).unwrap();
            let (sin, cos) = before.theta.sin_cos();
            let h = block.d * cos - r * sin;
            // The velocity of C: of a corner that sticks it follows; else from the positions just after, which the test needs to begin.
            let vx = if slip == 0.0 {
                -h * before.omega
            } else {
                outcome.moment(begin, false).unwrap().velocity[0]
            };
            let state = [before.x, before.theta, vx, before.omega];
            let Some((t, why, last)) = phase.end(begin, state, &[8.0], 8.5) else {
                panic!("{seed}: {pair:?}")
            };
            assert_eq!(why, pair[1].why, "{seed} {pair:?} {t}");
            assert!((t - end).abs() < 1e-9, "{seed} {why:?}: {t} {end}");
            let there = outcome.at(end.next_down()).unwrap();
            assert!(
                (last[1] - there.theta).abs() < 1e-9 && (last[0] - there.x).abs() < 1e-9,
                "{seed} {why:?}"
            );
            let kind =
                [Why::Impact, Why::Unload, Why::Cone, Why::Stop].iter().position(|w| *w == why).unwrap();
            checked[kind] += 1;
        }
    }
    // Enough of each, or the test says little.
    assert!(checked.iter().all(|count| *count >= 3) && checked.iter().sum::<i32>() > 300, "{checked:?}");
}
