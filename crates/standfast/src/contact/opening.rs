//! A base that opens under steady heads of water, in the units of the [contact problem](super).
//!
//! Water stands under the base, pressing with p_l at O and p_r at O'. Where the base opens, it fills what opens: the pressure of the higher
//! head stands there, and from its end on the pressure falls in a straight line to the other head. With p_r the higher, Δ = p_r − p_l, B
//! the width of the base, W the net force downwards of all but that water and M₀ its moment about O that holds the body down,
//!
//! ```text
//! N = W − p_r B        T = M₀ − ½p_r B²                                as if p_r stood under the whole base
//! closed    if 3T ≥ BN
//! open      c = 3T/N pressed from O,   U = p_r B − ½Δc,   M_U = ½p_r B² − Δc²/6
//! through   if T ≤ 0, or N ≤ 0 once it opens: no contact
//! ```
//!
//! No tension and a straight pressure over c ask for c P = 3(T + Δc²/6) with P = N + ½Δc, where the terms in Δc² cancel: nothing is
//! iterated. A drain at x_d from O that takes the share E of the straight line's pressure above p_l there adds ½EΔx_d to P and
//! ½EΔx_d(c + x_d)/3 to the moment: c = (3T + ½EΔx_d²)/N, as long as that is no less than x_d; else the drain is lost.
//!
//! The water of a mode is that of its own contact, and so every boundary joins:
//!
//! * rest has the state above;
//! * a slide to the left, C at d above the base, c = 3[T + d(|X| − μ_k N)]/(N + 1.5 μ_k dΔ);
//! * about the end of the lower head, and in flight, the whole base has opened; about the other end the straight line stands: only the end
//!   of the higher head is followed, as at the other an opening would take uplift away.
//!
//! Rotation about the end of the lower head is looked at only if the closed base would open, at rest if that is held by friction, else in
//! the slide; rest and slide come first, as the states reached from a closed base.
//!
//! Fast loads, as waves, meet the diagram that the steady ones leave: the water then is that of rest under these alone.

use super::conditions::conditions;
use super::path;
use super::{Block, check, numbers, solve};
use crate::departure::Departure;
use crate::error::{InputError, LARGEST};
use crate::mode::{Corner, Mode, Modes, Slip};
use crate::motion::Motion;
use crate::neighbour::Neighbour;
use crate::polynomial::quadratic_roots;
use crate::stage::Stage;
use crate::verdict::Verdict;
use crate::wrench::Wrench;

/// Water under a base, as force per length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BaseWater {
    /// Pressure at O.
    pub left: f64,
    /// Pressure at O'.
    pub right: f64,
    /// A line of drains under the base.
    pub drain: Option<Drain>,
}

/// A line of drains under a base.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drain {
    /// Its distance from O.
    pub distance: f64,
    /// E: the share that it takes of the straight line's pressure above that of the lower head.
    pub efficiency: f64,
}

/// How far a base has opened.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum OpeningState {
    /// It is pressed all over.
    Closed,
    /// It is pressed from the end of the lower head on.
    Open {
        /// c, the length that is pressed.
        contact: f64,
        /// True if the drain works.
        drained: bool,
    },
    /// It has opened from end to end.
    Through,
}

impl OpeningState {
    /// The length that is pressed, of a base so wide.
    pub fn contact(self, width: f64) -> f64 {
        match self {
            OpeningState::Closed => width,
            OpeningState::Open { contact, .. } => contact,
            OpeningState::Through => 0.0,
        }
    }

    /// True if a drain under the base would work.
    pub fn is_drained(self) -> bool {
        matches!(self, OpeningState::Closed | OpeningState::Open { drained: true, .. })
    }
}

/// Loads on a block whose water opens its base: all but the water under it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OpeningLoads {
    /// Loads that are there all the time.
    pub permanent: Wrench,
    /// Variable loads that water has time to follow.
    pub steady: Wrench,
    /// Variable loads too fast for it.
    pub fast: Wrench,
}

/// The consistent modes of a block on such a base.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OpeningSolution {
    /// Every consistent mode.
    pub modes: Modes,
    /// The mode reported.
    pub mode: Option<Mode>,
    /// State of the base at rest.
    pub state: OpeningState,
    /// Motion of the mode reported.
    pub motion: Option<Motion>,
    /// The wrench under which the mode reported begins, its own water with it.
    pub wrench: Wrench,
    /// True if an opening is followed; else the straight line under a closed base decides.
    pub follows: bool,
}

impl OpeningSolution {
    /// Every mode of `block` under a wrench with the water of a state.
    fn of(
        block: &Block,
        wrench: Wrench,
        state: OpeningState,
        follows: bool,
    ) -> Result<OpeningSolution, InputError> {
        let found = solve(block, &wrench)?;
        let motion = found.mode().and_then(|mode| found.motion(mode));
        Ok(OpeningSolution { modes: found.modes, mode: found.mode(), state, motion, wrench, follows })
    }
}

impl BaseWater {
    /// True if one head is higher, so that an opening changes the water.
    pub fn has_head(&self) -> bool {
        self.left != self.right
    }

    /// The state at rest under loads, the water under the base not among them.
    pub fn state(&self, block: &Block, loads: &Wrench) -> OpeningState {
        let given = Given::of(self, block);
        let Net { n, t, .. } = given.net(loads);
        given.rest(n, t)
    }

    /// The wrench of the water in a state.
    pub fn wrench(&self, block: &Block, state: OpeningState) -> Wrench {
        Given::of(self, block).water(state)
    }

    /// The wrench of the water where nothing opens.
    pub fn closed(&self, block: &Block) -> Wrench {
        self.wrench(block, OpeningState::Closed)
    }

    /// Distances to the right of O and pressures there, in a state.
    pub fn diagram(&self, block: &Block, state: OpeningState) -> Vec<(f64, f64)> {
        Given::of(self, block).diagram(state)
    }

    /// Every mode under loads that water follows, the water under the base not among them.
    ///
    /// # Errors
    /// As [`solve`].
    pub fn solve(&self, block: &Block, loads: &Wrench) -> Result<OpeningSolution, InputError> {
        check(block, loads)?;
        Given::of(self, block).solve(block, loads)
    }

    /// Every mode under the loads times a load factor, fast ones on the diagram that the others leave.
    ///
    /// # Errors
    /// As [`solve`].
    pub fn solve_at(
        &self,
        block: &Block,
        loads: &OpeningLoads,
        factor: f64,
    ) -> Result<OpeningSolution, InputError> {
        let steady = loads.permanent + loads.steady * factor;
        if loads.fast == Wrench::ZERO {
            return self.solve(block, &steady);
        }
        check(block, &steady)?;
        let state = self.state(block, &steady);
        let wrench = steady + self.wrench(block, state) + loads.fast * factor;
        OpeningSolution::of(block, wrench, state, state != OpeningState::Closed)
    }

    /// The stages of variable loads that rise from nothing without end.
    ///
    /// # Errors
    /// As [`solve`].
    pub fn stages(&self, block: &Block, loads: &OpeningLoads) -> Result<Vec<Stage>, InputError> {
        let given = Given::of(self, block);
        if loads.steady == Wrench::ZERO && loads.fast != Wrench::ZERO {
            // The diagram is held all the way.
            let state = self.state(block, &loads.permanent);
            let permanent = loads.permanent + self.wrench(block, state);
            return path::stages(block, &permanent, &loads.fast);
        }
        let mut ends = given.events(block, loads);
        if loads.fast != Wrench::ZERO {
            ends.extend(self.crossings(block, loads, &ends));
        }
        ends.retain(|end| end.is_finite() && *end > 0.0 && *end < LARGEST / 4.0);
        ends.sort_by(f64::total_cmp);
        ends.dedup_by(|later, earlier| *later - *earlier <= 16.0 * f64::EPSILON * *later);
        ends.push(f64::INFINITY);
        let mut stages = Vec::new();
        let mut from = 0.0;
        for to in ends {
            let inside = match to {
                f64::INFINITY if from == 0.0 => 1.0,
                f64::INFINITY => 2.0 * from,
                to => from + (to - from) / 2.0,
            };
            let found = self.solve_at(block, loads, inside)?;
            let verdict = found.mode.map(Verdict::Begins);
            Stage { from, to, verdict, modes: found.modes }.join(&mut stages);
            from = to;
        }
        Ok(stages)
    }

    /// The departure from rest as the variable loads rise.
    ///
    /// # Errors
    /// As [`solve`].
    pub fn departure(&self, block: &Block, loads: &OpeningLoads) -> Result<Departure, InputError> {
        let begin = self.solve_at(block, loads, 0.0)?.mode.map(Verdict::Begins);
        Departure::along(begin, self.stages(block, loads)?.into_iter().map(Ok))
    }

    /// Load factors at which the base begins to open, and at which it would have opened from end to end, where no load is too fast for
    /// the water; the first above zero.
    pub fn opens_at(&self, block: &Block, loads: &OpeningLoads) -> [Option<f64>; 2] {
        let given = Given::of(self, block);
        let [start, slope] = [loads.permanent, loads.steady].map(|loads| given.net_of(&loads));
        let water = given.net(&Wrench::ZERO);
        let line = |of: fn(&Net) -> f64| [of(&start) + of(&water), of(&slope)];
        let (n, t) = (line(|net| net.n), line(|net| net.t));
        let [_, squared] = given.drained();
        let opens = sum(&[(3.0, t), (-given.b, n)], squared);
        let root = |[constant, slope]: [f64; 2]| {
            let root = -constant / slope;
            // From held to not.
            (constant > 0.0 && slope < 0.0).then_some(root)
        };
        [root(opens), root(t)]
    }

    /// Load factors at which a condition changes its sign, found by bisection between `ends`, where fast loads meet a diagram that steady
    /// ones change: there no condition is linear.
    fn crossings(&self, block: &Block, loads: &OpeningLoads, ends: &[f64]) -> Vec<f64> {
        const STEPS: u32 = 128;
        let at = |factor: f64| {
            let steady = loads.permanent + loads.steady * factor;
            let water = self.wrench(block, self.state(block, &steady));
            conditions(&numbers(block, &(steady + water + loads.fast * factor)))
        };
        let mut bounds: Vec<f64> = ends.iter().copied().filter(|end| end.is_finite() && *end > 0.0).collect();
        bounds.sort_by(f64::total_cmp);
        let last = bounds.last().copied().unwrap_or(0.0);
        let mut grid = vec![0.0];
        for &to in &bounds {
            let from = *grid.last().unwrap_or(&0.0);
            grid.extend((1..=STEPS).map(|i| from + (to - from) * f64::from(i) / f64::from(STEPS)));
        }
        // Beyond, ever farther apart.
        let step = if last > 0.0 { last } else { 1.0 };
        grid.extend((1..4 * STEPS).map(|i| {
            let share = f64::from(i) / f64::from(4 * STEPS);
            last + step * share / (1.0 - share)
        }));
        let values: Vec<_> = grid.iter().map(|factor| at(*factor)).collect();
        let mut found = Vec::new();
        for (place, pair) in values.windows(2).enumerate() {
            for (which, (before, after)) in pair[0].iter().zip(pair[1]).enumerate() {
                if before * after >= 0.0 {
                    continue;
                }
                let (mut low, mut high) = (grid[place], grid[place + 1]);
                let rises = after > 0.0;
                for _ in 0..80 {
                    let middle = low + (high - low) / 2.0;
                    if (at(middle)[which] > 0.0) == rises { high = middle } else { low = middle }
                }
                found.push(high);
            }
        }
        found
    }
}

/// Loads as if the higher head stood under the whole base, that head at the right.
struct Net {
    n: f64,
    t: f64,
    x: f64,
}

impl Net {
    /// The way in which it is pushed.
    fn slip(&self) -> Slip {
        if self.x < 0.0 { Slip::Left } else { Slip::Right }
    }
}

/// A base with the higher head at the right: that of the problem, or its mirror image.
struct Given {
    /// The width of the base, and the distance of its left end from C.
    b: f64,
    b1: f64,
    d: f64,
    mu_s: f64,
    mu_k: f64,
    /// The higher pressure, and how much it is above the other.
    high: f64,
    delta: f64,
    drain: Option<Drain>,
    mirrored: bool,
}

impl Given {
    fn of(water: &BaseWater, block: &Block) -> Given {
        let Block { b1, b2, d, mu_s, mu_k, .. } = *block;
        let b = b1 + b2;
        let mirrored = water.left > water.right;
        let (high, low) = if mirrored { (water.left, water.right) } else { (water.right, water.left) };
        let drain = water.drain.map(|drain| match mirrored {
            true => Drain { distance: b - drain.distance, ..drain },
            false => drain,
        });
        let b1 = if mirrored { b2 } else { b1 };
        Given { b, b1, d, mu_s, mu_k, high, delta: high - low, drain, mirrored }
    }

    fn turned(&self, Wrench { x, p, m }: Wrench) -> Wrench {
        if self.mirrored { Wrench { x: 0.0 - x, p, m: 0.0 - m } } else { Wrench { x, p, m } }
    }

    /// W, M₀ and X of loads alone.
    fn net_of(&self, loads: &Wrench) -> Net {
        let Wrench { x, p, m } = self.turned(*loads);
        Net { n: p, t: p * self.b1 - m + x * self.d, x }
    }

    fn net(&self, loads: &Wrench) -> Net {
        let Net { n, t, x } = self.net_of(loads);
        Net { n: n - self.high * self.b, t: t - self.high * self.b * self.b / 2.0, x }
    }

    /// ½EΔx_d and ½EΔx_d² of a drain.
    fn drained(&self) -> [f64; 2] {
        self.drain.map_or([0.0; 2], |Drain { distance, efficiency }| {
            let force = efficiency * self.delta * distance / 2.0;
            [force, force * distance]
        })
    }

    fn rest(&self, n: f64, t: f64) -> OpeningState {
        let [_, squared] = self.drained();
        self.opened(n, 3.0 * t, squared)
    }

    /// The state of a base pressed over c = `above`/`below`, or with `drained` above as well while the drain works; closed where that is no
    /// less than the base.
    fn opened(&self, below: f64, above: f64, drained: f64) -> OpeningState {
        if above + drained >= self.b * below {
            return OpeningState::Closed;
        }
        if below <= 0.0 {
            return OpeningState::Through;
        }
        if let Some(drain) = self.drain {
            let contact = (above + drained) / below;
            if contact >= drain.distance && contact > 0.0 {
                return OpeningState::Open { contact, drained: true };
            }
        }
        match above / below {
            contact if contact > 0.0 => OpeningState::Open { contact, drained: false },
            _ => OpeningState::Through,
        }
    }

    /// Friction to slip of a slide, above zero to the left, and what of 3T + … the drain adds to it.
    fn slip(&self, slip: Slip) -> [f64; 2] {
        let μ = if slip == Slip::Left { self.mu_k } else { -self.mu_k };
        let [force, squared] = self.drained();
        [μ, squared - 3.0 * μ * self.d * force]
    }

    fn slide(&self, Net { n, t, x }: &Net, slip: Slip) -> OpeningState {
        let [μ, drained] = self.slip(slip);
        let above = 3.0 * (t + self.d * (-x - μ * n));
        self.opened(n + 1.5 * μ * self.d * self.delta, above, drained)
    }

    /// True if the closed base would open: at rest if friction holds it, else in the slide.
    fn opens(&self, net: &Net) -> bool {
        let [force, _] = self.drained();
        let pressed = net.n + self.delta * self.b / 2.0 + force;
        if net.x.abs() <= self.mu_s * pressed {
            return self.rest(net.n, net.t) != OpeningState::Closed;
        }
        self.slide(net, net.slip()) != OpeningState::Closed
    }

    /// U, and its moment about the left end.
    fn uplift(&self, state: OpeningState) -> [f64; 2] {
        let Given { b, high, delta, .. } = *self;
        let contact = state.contact(b);
        let mut uplift = high * b - delta * contact / 2.0;
        let mut moment = high * b * b / 2.0 - delta * contact * contact / 6.0;
        if let Some(Drain { distance, .. }) = self.drain.filter(|_| state.is_drained()) {
            let [force, _] = self.drained();
            uplift -= force;
            moment -= force * (contact + distance) / 3.0;
        }
        [uplift, moment]
    }

    fn water(&self, state: OpeningState) -> Wrench {
        let [uplift, moment] = self.uplift(state);
        self.turned(Wrench { x: 0.0, p: 0.0 - uplift, m: moment - uplift * self.b1 })
    }

    fn diagram(&self, state: OpeningState) -> Vec<(f64, f64)> {
        let low = self.high - self.delta;
        let contact = state.contact(self.b);
        let mut points = Vec::new();
        if contact > 0.0 {
            points.push((0.0, low));
            if let Some(Drain { distance, efficiency }) = self.drain.filter(|_| state.is_drained()) {
                points.push((distance, low + (1.0 - efficiency) * self.delta * distance / contact));
            }
        }
        points.push((contact, self.high));
        if contact < self.b {
            points.push((self.b, self.high));
        }
        if self.mirrored {
            points.reverse();
            points.iter_mut().for_each(|point| point.0 = self.b - point.0);
        }
        points
    }

    fn solve(&self, block: &Block, loads: &Wrench) -> Result<OpeningSolution, InputError> {
        let net = self.net(loads);
        let state = self.rest(net.n, net.t);
        let closed = *loads + self.water(OpeningState::Closed);
        if self.delta == 0.0 || !self.opens(&net) {
            return OpeningSolution::of(block, closed, state, false);
        }
        let orient = |mode: Mode| if self.mirrored { mode.mirrored() } else { mode };
        let (mut modes, mut reported) = (Modes::NONE, None);
        // In the order in which they are reported.
        let mut look = |state: OpeningState, which: &dyn Fn(Mode) -> bool| -> Result<(), InputError> {
            let wrench = *loads + self.water(state);
            let found = solve(block, &wrench)?;
            let here: Modes = found.modes.iter().filter(|mode| which(orient(*mode))).collect();
            if here.is_empty() {
                return Ok(());
            }
            here.iter().for_each(|mode| modes.insert(mode));
            if reported.is_none() {
                let first = found.mode().filter(|mode| here.contains(*mode)).or_else(|| here.iter().next());
                reported = first.and_then(|mode| Some((mode, found.motion(mode)?, wrench)));
            }
            Ok(())
        };
        if state != OpeningState::Through {
            look(state, &|mode| mode == Mode::Rest)?;
        }
        // It slides the way it is pushed.
        let slip = net.slip();
        match self.slide(&net, slip) {
            OpeningState::Through => {}
            state => look(state, &|mode| mode == Mode::slide(slip))?,
        }
        look(OpeningState::Through, &|mode| mode.corner() == Some(Corner::O) || mode == Mode::Flight)?;
        look(OpeningState::Closed, &|mode| mode.corner() == Some(Corner::OPrime))?;
        let (mode, motion, wrench) = match reported {
            Some((mode, motion, wrench)) => (Some(mode), Some(motion), wrench),
            None => (None, None, *loads + self.water(state)),
        };
        Ok(OpeningSolution { modes, mode, state, motion, wrench, follows: true })
    }

    /// The load factors at which anything may change along loads that rise.
    fn events(&self, block: &Block, loads: &OpeningLoads) -> Vec<f64> {
        let water = self.net(&Wrench::ZERO);
        let [start, slope] = [loads.permanent, loads.steady].map(|loads| self.net_of(&loads));
        let line = |of: fn(&Net) -> f64| [of(&start) + of(&water), of(&slope)];
        let (n, t, x) = (line(|net| net.n), line(|net| net.t), [start.x, slope.x]);
        let [force, squared] = self.drained();
        let (b, d, delta) = (self.b, self.d, self.delta);
        let one = |constant: f64| [constant, 0.0];
        let mut events: Vec<f64> = Vec::new();
        let mut zero = |line: [f64; 2]| events.push(-line[0] / line[1]);
        [n, t, x].into_iter().for_each(&mut zero);
        for drained in [0.0, squared] {
            zero(sum(&[(3.0, t), (-b, n)], drained));
            zero(sum(&[(3.0, t)], drained));
        }
        let mut products: Vec<[f64; 3]> = Vec::new();
        // Friction at rest: σ X N = μ(N² + ½Δ(3T + …) + … N).
        for (drained, force) in [(0.0, 0.0), (squared, force)] {
            let pressed = sum(&[(1.5 * delta, t), (force, n)], delta * drained / 2.0);
            let all = added(product(n, n), [pressed[0], pressed[1], 0.0]);
            for σ in [1.0, -1.0] {
                products.push(added(times(product(x, n), σ), times(all, -self.mu_s)));
            }
        }
        for slip in [Slip::Left, Slip::Right] {
            let [μ, of_drain] = self.slip(slip);
            let above = sum(&[(3.0, t), (-3.0 * d, x), (-3.0 * d * μ, n)], 0.0);
            let below = sum(&[(1.0, n)], 1.5 * μ * d * delta);
            zero(below);
            for (of_drain, force) in [(0.0, 0.0), (of_drain, force)] {
                let above = sum(&[(1.0, above)], of_drain);
                zero(above);
                zero(sum(&[(1.0, above), (-b, below)], 0.0));
                if let Some(drain) = self.drain {
                    zero(sum(&[(1.0, above), (-drain.distance, below)], 0.0));
                }
                // σ X below = μ(N below + ½Δ above + … below).
                let pressed = added(
                    added(product(n, below), times(product(above, one(1.0)), delta / 2.0)),
                    times(product(below, one(1.0)), force),
                );
                for μ in [self.mu_s, self.mu_k] {
                    for σ in [1.0, -1.0] {
                        products.push(added(times(product(x, below), σ), times(pressed, -μ)));
                    }
                }
            }
        }
        if let Some(drain) = self.drain {
            zero(sum(&[(3.0, t), (-drain.distance, n)], squared));
            zero(sum(&[(3.0, t), (-drain.distance, n)], 0.0));
        }
        events.extend(products.into_iter().flat_map(quadratic_roots));
        for state in [OpeningState::Closed, OpeningState::Through] {
            let permanent = loads.permanent + self.water(state);
            events.extend(path::crossings(block, &permanent, &loads.steady));
        }
        events
    }
}

/// A sum of lines, each times a number, and a number.
fn sum(lines: &[(f64, [f64; 2])], constant: f64) -> [f64; 2] {
    lines.iter().fold([constant, 0.0], |sum, (by, line)| [sum[0] + by * line[0], sum[1] + by * line[1]])
}

fn product(one: [f64; 2], two: [f64; 2]) -> [f64; 3] {
    [one[0] * two[0], one[0] * two[1] + one[1] * two[0], one[1] * two[1]]
}

fn added(one: [f64; 3], two: [f64; 3]) -> [f64; 3] {
    [one[0] + two[0], one[1] + two[1], one[2] + two[2]]
}

fn times(one: [f64; 3], by: f64) -> [f64; 3] {
    one.map(|number| number * by)
}
