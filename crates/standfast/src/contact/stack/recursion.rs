//! All combinations of a stack in floating point with tracked rounding, from the top down.
//!
//! What stands above a body acts on it by a law that is linear in its motion, the same for all combinations below. Twists and wrenches are taken
//! at the origin: of (t, v, ω) at the height h that is (t + hω, v, ω), of (f, N, G) it is (f, N, G − hf). With 𝓘, W the inertia of a body and the
//! loads on it there, B and N the motions and rows of its joint,
//!
//! ```text
//! U = 𝓘ᴬ B    D = Nᵀ U    𝓘ᴬ below = 𝓘 + 𝓘ᴬ − U D⁻¹ Nᵀ𝓘ᴬ    Wᴬ below = W + Wᴬ − U D⁻¹ Nᵀ Wᴬ
//! e = Wᴬ − 𝓘ᴬ a below    z = D⁻¹ Nᵀ e    R = U z − e    a = a below + B z    D of all = ∏ det D
//! ```

use std::cmp::Ordering::{Equal, Greater, Less};

use super::laws::Freedom;
use super::{BodyMotion, Combination, Decider, JointMotion, LoadPoint, StackMotion};
use crate::approx::{Approx, Signed, sign};
use crate::exact::Real;
use crate::mode::Mode;

type Vector = [Approx; 3];
type Matrix = [Vector; 3];

const ZERO: Approx = Approx::ZERO;

fn dot(a: &Vector, b: &Vector) -> Approx {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn times(matrix: &Matrix, vector: &Vector) -> Vector {
    [dot(&matrix[0], vector), dot(&matrix[1], vector), dot(&matrix[2], vector)]
}

fn sum(a: &Vector, b: &Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

fn minus(a: &Vector, b: &Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn scaled(vector: &Vector, by: Approx) -> Vector {
    [vector[0] * by, vector[1] * by, vector[2] * by]
}

/// Row of a matrix seen as a sum of rows: nᵀ 𝓘.
fn row_times(row: &Vector, matrix: &Matrix) -> Vector {
    sum(&sum(&scaled(&matrix[0], row[0]), &scaled(&matrix[1], row[1])), &scaled(&matrix[2], row[2]))
}

/// The motions and rows of a mode at the origin: two at most, but of flight, which has all.
#[derive(Debug, Clone, Copy)]
struct AtOrigin {
    mode: Mode,
    count: usize,
    motions: [Vector; 2],
    rows: [Vector; 2],
}

/// What a joint carries: inertia of the body on it, as it is felt with all above, and the loads there.
#[derive(Debug, Clone, Copy)]
struct Carried {
    inertia: Matrix,
    load: Vector,
}

/// A joint in a mode, with all that it carries.
#[derive(Debug, Clone, Copy)]
struct Node<'a> {
    freedom: &'a AtOrigin,
    carried: &'a Carried,
    /// U, a column for each motion.
    columns: [Vector; 2],
    /// D⁻¹, of as many rows as motions; of flight the adjugate of 𝓘ᴬ over its determinant.
    inverse: Matrix,
    /// The determinant of D.
    determinant: Approx,
}

/// A node and those above it.
#[derive(Debug, Clone, Copy)]
struct Chain<'a> {
    node: Node<'a>,
    above: Option<&'a Chain<'a>>,
}

impl<'a> Chain<'a> {
    /// The nodes from the ground up.
    fn nodes(&'a self) -> impl Iterator<Item = &'a Node<'a>> {
        std::iter::successors(Some(self), |chain| chain.above).map(|chain| &chain.node)
    }
}

impl<'a> Node<'a> {
    fn of(freedom: &'a AtOrigin, carried: &'a Carried) -> Node<'a> {
        let inertia = &carried.inertia;
        let mut node = Node {
            freedom,
            carried,
            columns: [[ZERO; 3]; 2],
            inverse: [[ZERO; 3]; 3],
            determinant: Approx::of(1.0),
        };
        match (freedom.mode, freedom.count) {
            (Mode::Flight, _) => {
                let [a, b, c] = inertia;
                let cross = |p: &Vector, q: &Vector| {
                    [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
                };
                let columns = [cross(b, c), cross(c, a), cross(a, b)];
                node.determinant = dot(a, &columns[0]);
                let share = Approx::of(1.0) / node.determinant;
                node.inverse =
                    std::array::from_fn(|row| std::array::from_fn(|column| columns[column][row] * share));
            }
            (_, 0) => {}
            (_, 1) => {
                node.columns[0] = times(inertia, &freedom.motions[0]);
                node.determinant = dot(&freedom.rows[0], &node.columns[0]);
                node.inverse[0][0] = Approx::of(1.0) / node.determinant;
            }
            _ => {
                node.columns = freedom.motions.map(|motion| times(inertia, &motion));
                let [[a, b], [c, d]] =
                    freedom.rows.map(|row| [dot(&row, &node.columns[0]), dot(&row, &node.columns[1])]);
                node.determinant = a * d - b * c;
                let share = Approx::of(1.0) / node.determinant;
                node.inverse[0] = [d * share, -b * share, ZERO];
                node.inverse[1] = [-c * share, a * share, ZERO];
            }
        }
        node
    }

    /// D⁻¹ of numbers, one for each row.
    fn solved(&self, right: &[Approx; 2]) -> [Approx; 2] {
        let [a, b] = [&self.inverse[0], &self.inverse[1]];
        match self.freedom.count {
            1 => [a[0] * right[0], ZERO],
            _ => [a[0] * right[0] + a[1] * right[1], b[0] * right[0] + b[1] * right[1]],
        }
    }

    /// D⁻¹ Nᵀ of a wrench.
    fn shares(&self, wrench: &Vector) -> [Approx; 2] {
        let mut right = [ZERO; 2];
        for (place, row) in self.freedom.rows.iter().enumerate().take(self.freedom.count) {
            right[place] = dot(row, wrench);
        }
        self.solved(&right)
    }

    /// What it adds to the inertia and the loads of the body below.
    fn passed_on(&self) -> Carried {
        match (self.freedom.mode, self.freedom.count) {
            (Mode::Flight, _) => Carried { inertia: [[ZERO; 3]; 3], load: [ZERO; 3] },
            (_, 0) => *self.carried,
            (_, count) => {
                let Carried { mut inertia, mut load } = *self.carried;
                let mut rows = [[ZERO; 3]; 2];
                for (place, row) in self.freedom.rows.iter().enumerate().take(count) {
                    rows[place] = row_times(row, &self.carried.inertia);
                }
                for place in 0..3 {
                    let right = [rows[0][place], rows[1][place]];
                    let shares = self.solved(&right);
                    for (column, share) in self.columns.iter().zip(shares).take(count) {
                        for row in 0..3 {
                            inertia[row][place] = inertia[row][place] - column[row] * share;
                        }
                    }
                }
                let shares = self.shares(&self.carried.load);
                for (column, share) in self.columns.iter().zip(shares).take(count) {
                    load = minus(&load, &scaled(column, share));
                }
                Carried { inertia, load }
            }
        }
    }

    /// The motion relative to the body below, which has the acceleration `below`, the ground none, and the reaction, both at the origin.
    fn course(&self, below: Option<&Vector>) -> (Vector, Vector) {
        let Carried { inertia, load } = self.carried;
        let rest = below.map_or(*load, |below| minus(load, &times(inertia, below)));
        match (self.freedom.mode, self.freedom.count) {
            (Mode::Flight, _) => (times(&self.inverse, &rest), [ZERO; 3]),
            (_, 0) => ([ZERO; 3], rest.map(|part| -part)),
            (_, count) => {
                let shares = self.shares(&rest);
                let (mut motion, mut reaction) = ([ZERO; 3], rest.map(|part| -part));
                for (place, share) in shares.into_iter().enumerate().take(count) {
                    motion = sum(&motion, &scaled(&self.freedom.motions[place], share));
                    reaction = sum(&reaction, &scaled(&self.columns[place], share));
                }
                (motion, reaction)
            }
        }
    }
}

/// A stack in floating point under a load.
struct Recursion {
    /// The bodies by themselves.
    bodies: Vec<Carried>,
    freedoms: Vec<[AtOrigin; Mode::ALL.len()]>,
}

impl Carried {
    fn with(&self, passed: &Carried) -> Carried {
        let inertia = std::array::from_fn(|row| sum(&self.inertia[row], &passed.inertia[row]));
        Carried { inertia, load: sum(&self.load, &passed.load) }
    }
}

impl Recursion {
    /// The nodes of a combination, from the ground up.
    fn nodes<'a>(&'a self, modes: &'a [Mode], carried: &'a [Carried]) -> impl Iterator<Item = Node<'a>> {
        let freedoms = self.freedoms.iter().zip(modes).map(|(all, mode)| &all[usize::from(mode.code())]);
        freedoms.zip(carried).map(|(freedom, carried)| Node::of(freedom, carried))
    }
}

/// What floating point says of a combination.
enum Told {
    Consistent { regular: bool },
    Open,
}

impl Decider<'_> {
    fn recursion(&self, at: &LoadPoint) -> Recursion {
        let factor = at.factor().tracked();
        let numbers = &self.approx;
        let bodies = numbers.bodies.iter().map(|body| {
            let (right, up) = (-(body.m_x * body.y), body.m_y * body.x);
            let about = body.inertia + body.m_x * body.y * body.y + body.m_y * body.x * body.x;
            let inertia = [[body.m_x, ZERO, right], [ZERO, body.m_y, up], [right, up, about]];
            let [steady, growing] = [&body.permanent, &body.variable];
            let (x, p, m) =
                (steady.x + growing.x * factor, steady.p + growing.p * factor, steady.m + growing.m * factor);
            Carried { inertia, load: [x, -p, m - x * body.y - p * body.x] }
        });
        let freedoms = numbers.joints.iter().map(|joint| {
            Mode::ALL.map(|mode| {
                let Freedom { motions, rows } = Freedom::of(joint, mode);
                // At the origin.
                let moved = |all: &[Vector]| {
                    let mut two = [[ZERO; 3]; 2];
                    for (place, [t, v, ω]) in all.iter().take(2).enumerate() {
                        two[place] = [*t + joint.h * *ω, *v, *ω];
                    }
                    two
                };
                let count = if mode == Mode::Flight { 3 } else { motions.len() };
                AtOrigin { mode, count, motions: moved(&motions), rows: moved(&rows) }
            })
        });
        Recursion { bodies: bodies.collect(), freedoms: freedoms.collect() }
    }

    /// Every consistent combination, each motion once.
    pub(super) fn consistent(&self, at: &LoadPoint) -> Vec<Combination> {
        let recursion = self.recursion(at);
        let mut found = Vec::new();
        let top = recursion.bodies.len() - 1;
        self.descend(&recursion, top, &recursion.bodies[top], None, at, &mut found);
        // What flies and what touches without pressing is one motion: it counts as the one that touches.
        let is_other = |one: &Combination| {
            !found.iter().any(|touches: &Combination| touches != one && one.is_flight_of(touches))
        };
        let kept: Vec<bool> = found.iter().map(is_other).collect();
        let mut kept = kept.into_iter();
        found.retain(|_| kept.next() == Some(true));
        found
    }

    /// Adds what is consistent with the modes of all joints above one.
    fn descend(
        &self,
        recursion: &Recursion,
        joint: usize,
        carried: &Carried,
        above: Option<&Chain<'_>>,
        at: &LoadPoint,
        found: &mut Vec<Combination>,
    ) {
        for freedom in &recursion.freedoms[joint] {
            let chain = Chain { node: Node::of(freedom, carried), above };
            if let Some(below) = joint.checked_sub(1) {
                let carried = recursion.bodies[below].with(&chain.node.passed_on());
                self.descend(recursion, below, &carried, Some(&chain), at, found);
                continue;
            }
            let modes = || chain.nodes().map(|node| node.freedom.mode).collect::<Vec<_>>();
            match self.told(&chain, at) {
                Some(Told::Consistent { regular }) => {
                    found.push(Combination { modes: modes(), regular, unpressed: 0 });
                }
                Some(Told::Open) => found.extend(self.settled(&modes(), at)),
                None => {}
            }
        }
    }

    /// What is told of a combination; `None` where a condition surely fails.
    fn told(&self, chain: &Chain<'_>, at: &LoadPoint) -> Option<Told> {
        let mut below: Option<Vector> = None;
        let (mut open, mut orientation) = (false, Greater);
        for (joint, node) in self.approx.joints.iter().zip(chain.nodes()) {
            match node.determinant.sign() {
                // Nothing that is divided by it means anything.
                None | Some(Equal) => return Some(Told::Open),
                Some(Less) => orientation = orientation.reverse(),
                Some(Greater) => {}
            }
            let (motion, reaction) = node.course(below.as_ref());
            let local = local(joint.h, &motion, &reaction);
            let (conditions, count) = joint.conditions(node.freedom.mode, &local.0, &local.1);
            for condition in &conditions[..count] {
                match condition.value.sign() {
                    Some(Less) => return None,
                    Some(Equal) if condition.strict && !at.beyond => return None,
                    Some(Greater) => {}
                    Some(Equal) | None => open = true,
                }
            }
            below = Some(below.map_or(motion, |below| sum(&below, &motion)));
        }
        Some(if open { Told::Open } else { Told::Consistent { regular: orientation == Greater } })
    }

    /// What each joint carries in a combination, from the ground up.
    fn carried(recursion: &Recursion, modes: &[Mode]) -> Vec<Carried> {
        let mut all = recursion.bodies.clone();
        for joint in (1..modes.len()).rev() {
            let freedom = &recursion.freedoms[joint][usize::from(modes[joint].code())];
            let passed = Node::of(freedom, &all[joint]).passed_on();
            all[joint - 1] = all[joint - 1].with(&passed);
        }
        all
    }

    /// D of a combination.
    pub(super) fn orientation(&self, modes: &[Mode]) -> f64 {
        let recursion = self.recursion(&LoadPoint::of(0.0));
        let carried = Self::carried(&recursion, modes);
        recursion.nodes(modes, &carried).map(|node| node.determinant.value()).product()
    }

    /// The motion of a consistent combination.
    pub(super) fn motion(&self, modes: &[Mode], at: &LoadPoint) -> Option<StackMotion> {
        let recursion = self.recursion(at);
        let carried = Self::carried(&recursion, modes);
        let mut below = [ZERO; 3];
        let (mut joints, mut bodies) = (Vec::new(), Vec::new());
        // Only what has most of its digits is told; a known zero has all.
        let told = |value: Approx| {
            if sign(&value) == Equal && value.sign().is_some() { Some(0.0) } else { value.precise() }
        };
        let numbers = self.approx.bodies.iter().zip(&self.approx.joints);
        let complete = numbers.zip(recursion.nodes(modes, &carried)).all(|((body, joint), node)| {
            let (motion, reaction) = node.course(Some(&below));
            let ([t, v, ω], [f, n, g]) = local(joint.h, &motion, &reaction);
            below = sum(&below, &motion);
            let [right, up, turn] = below;
            let parts = [t, v, ω, f, n, g, right - turn * body.y, up + turn * body.x, turn];
            let Some([t, v, omega, f, n, g, x_ddot, y_ddot, theta_ddot]) = parts
                .map(told)
                .into_iter()
                .collect::<Option<Vec<f64>>>()
                .and_then(|values| <[f64; 9]>::try_from(values).ok())
            else {
                return false;
            };
            let xi = if n == 0.0 { 0.0 } else { g / n };
            joints.push(JointMotion { t, v, omega, f, n, xi });
            bodies.push(BodyMotion { x_ddot, y_ddot, theta_ddot });
            true
        });
        if complete { Some(StackMotion { joints, bodies }) } else { self.exact_motion(modes, at) }
    }
}

/// The motion (t, v, ω) and the reaction (f, N, G) of a joint at a height, of those at the origin.
fn local(h: Approx, motion: &Vector, reaction: &Vector) -> (Vector, Vector) {
    let ([right, up, turn], [f, n, about_origin]) = (*motion, *reaction);
    ([right - h * turn, up, turn], [f, n, about_origin + h * f])
}
