//! The equations of a stack in full, by elimination: first in floating point that tracks its rounding, where a pivot of the recursion may be
//! zero and that of the whole is not; then in numbers without rounding, what floating point cannot tell.

use std::cmp::Ordering::{self, Equal, Greater, Less};
use std::ops::Div;

use super::laws::{Freedom, is_unpressed};
use super::rest::Line;
use super::{BodyMotion, Combination, Decider, JointMotion, LoadPoint, StackMotion, StackNumbers};
use crate::approx::{Approx, Signed, sign};
use crate::ball::{Ball, Scalar};
use crate::exact::Real;
use crate::mode::Mode;

/// Arithmetic in which the equations are solved.
pub(super) trait Solvable: Signed + Div<Output = Self> {
    /// The number of a load factor's fraction.
    fn of_ball(number: &Ball) -> Self;

    /// How well it does as a pivot; zero if it may be zero.
    fn size(&self) -> f64;
}

impl Solvable for Ball {
    fn of_ball(number: &Ball) -> Ball {
        number.clone()
    }

    fn size(&self) -> f64 {
        if sign(self) == Equal { 0.0 } else { 1.0 }
    }
}

impl Solvable for Approx {
    fn of_ball(number: &Ball) -> Approx {
        number.tracked()
    }

    fn size(&self) -> f64 {
        if self.is_told() { self.value().abs() } else { 0.0 }
    }
}

/// A number under a load factor, and how it grows with that.
type Grown<T> = [T; 2];

/// Motion and reaction of every joint times `scale`, each a number and its slope.
struct Course<T> {
    motions: Vec<[Grown<T>; 3]>,
    reactions: Vec<[Grown<T>; 3]>,
    /// Above zero.
    scale: T,
    /// The sign of D.
    orientation: Ordering,
}

fn zero<T: Real>() -> T {
    T::of(0.0)
}

/// 𝓜 in the coordinates of the joints: 3n rows of as many.
fn mass_matrix<T: Real>(numbers: &StackNumbers<T>) -> Vec<Vec<T>> {
    let count = numbers.bodies.len();
    let mut all = vec![vec![zero(); 3 * count]; 3 * count];
    for (j, body) in numbers.bodies.iter().enumerate() {
        // Rows of T: acceleration of the centre to the right, upwards, and the rotation.
        let rows = |i: usize| -> [[T; 3]; 3] {
            let up = numbers.joints[i].h.clone() - body.y.clone();
            [[T::of(1.0), zero(), up], [zero(), T::of(1.0), body.x.clone()], [zero(), zero(), T::of(1.0)]]
        };
        let inertias = [&body.m_x, &body.m_y, &body.inertia];
        for i in 0..=j {
            for k in 0..=j {
                let (of_i, of_k) = (rows(i), rows(k));
                for a in 0..3 {
                    for b in 0..3 {
                        let terms = (0..3)
                            .map(|row| of_i[row][a].clone() * inertias[row].clone() * of_k[row][b].clone());
                        let sum = terms.fold(zero::<T>(), |sum, term| sum + term);
                        let cell: &mut T = &mut all[3 * i + a][3 * k + b];
                        *cell = cell.clone() + sum;
                    }
                }
            }
        }
    }
    all
}

/// Q in the coordinates of the joints: permanent and variable loads.
fn loads<T: Real>(numbers: &StackNumbers<T>) -> Vec<Grown<T>> {
    let mut all = vec![[zero(), zero()]; 3 * numbers.bodies.len()];
    for (i, joint) in numbers.joints.iter().enumerate() {
        for body in &numbers.bodies[i..] {
            for (part, wrench) in [&body.permanent, &body.variable].into_iter().cloned().enumerate() {
                let arm = body.y.clone() - joint.h.clone();
                let moment = wrench.m - wrench.x.clone() * arm - wrench.p.clone() * body.x.clone();
                for (row, value) in [wrench.x, -wrench.p, moment].into_iter().enumerate() {
                    let cell: &mut T = &mut all[3 * i + row][part];
                    *cell = cell.clone() + value;
                }
            }
        }
    }
    all
}

/// The mass matrix of a stack and its loads, which no combination changes.
pub(super) struct System<T> {
    mass: Vec<Vec<T>>,
    loads: Vec<Grown<T>>,
}

impl<T: Real> System<T> {
    pub(super) fn of(numbers: &StackNumbers<T>) -> System<T> {
        System { mass: mass_matrix(numbers), loads: loads(numbers) }
    }
}

/// The solution of linear equations times their determinant, and that; `None` where it is zero, or may be. Numbers grow no more than determinants do:
/// every division, by the pivot before, leaves no rest.
fn solved<T: Solvable>(mut matrix: Vec<Vec<T>>, mut right: Vec<Grown<T>>) -> Option<(Vec<Grown<T>>, T)> {
    let count = matrix.len();
    let mut before = T::of(1.0);
    for column in 0..count {
        let size = |row: &usize| matrix[*row][column].size();
        let pivot = (column..count).max_by(|one, two| size(one).total_cmp(&size(two)))?;
        if size(&pivot) == 0.0 {
            return None;
        }
        if pivot != column {
            matrix.swap(pivot, column);
            right.swap(pivot, column);
            // An exchange of rows changes the sign of the determinant.
            matrix[column].iter_mut().for_each(|value| *value = -value.clone());
            right[column].iter_mut().for_each(|value| *value = -value.clone());
        }
        let (own, own_right) = (matrix[column].clone(), right[column].clone());
        let pivot = &own[column];
        for row in (0..count).filter(|row| *row != column) {
            let by = matrix[row][column].clone();
            let without = |value: &T, own: &T| {
                (value.clone() * pivot.clone() - own.clone() * by.clone()) / before.clone()
            };
            matrix[row] = matrix[row].iter().zip(&own).map(|(value, own)| without(value, own)).collect();
            right[row] = std::array::from_fn(|part| without(&right[row][part], &own_right[part]));
        }
        before = pivot.clone();
    }
    Some((right, before))
}

impl<T: Solvable> System<T> {
    /// The course of a combination; `None` where D is zero, or may be: it has no motion of its own.
    fn course(&self, numbers: &StackNumbers<T>, modes: &[Mode], at: &LoadPoint) -> Option<Course<T>> {
        let System { mass, loads } = self;
        let [above, below] = [&at.above, &at.below].map(T::of_ball);
        let loads: Vec<Grown<T>> = loads
            .iter()
            .map(|[steady, growing]| {
                let value = steady.clone() * below.clone() + growing.clone() * above.clone();
                // A slope that nothing asks for costs nothing as a zero.
                [value, if at.beyond { growing.clone() * below.clone() } else { zero() }]
            })
            .collect();
        let freedoms: Vec<Freedom<T>> =
            numbers.joints.iter().zip(modes).map(|(joint, mode)| Freedom::of(joint, *mode)).collect();
        let columns: Vec<(usize, &[T; 3])> = freedoms
            .iter()
            .enumerate()
            .flat_map(|(joint, freedom)| freedom.motions.iter().map(move |motion| (joint, motion)))
            .collect();
        let rows: Vec<(usize, &[T; 3])> = freedoms
            .iter()
            .enumerate()
            .flat_map(|(joint, freedom)| freedom.rows.iter().map(move |row| (joint, row)))
            .collect();
        let sum = |terms: &mut dyn Iterator<Item = T>| terms.fold(zero::<T>(), |sum, term| sum + term);
        let matrix = rows
            .iter()
            .map(|(i, row)| {
                columns
                    .iter()
                    .map(|(k, motion)| {
                        sum(&mut (0..9).map(|place| {
                            let (a, b) = (place / 3, place % 3);
                            row[a].clone() * mass[3 * i + a][3 * k + b].clone() * motion[b].clone()
                        }))
                    })
                    .collect()
            })
            .collect();
        let right = rows
            .iter()
            .map(|(i, row)| {
                std::array::from_fn(|part| {
                    sum(&mut (0..3).map(|a| row[a].clone() * loads[3 * i + a][part].clone()))
                })
            })
            .collect();
        let (mut shares, mut determinant) = solved(matrix, right)?;
        let orientation = sign(&determinant);
        if orientation == Less {
            determinant = -determinant;
            shares = shares.into_iter().map(|share| share.map(|part| -part)).collect();
        }
        let mut motions = vec![std::array::from_fn::<Grown<T>, 3, _>(|_| [zero(), zero()]); modes.len()];
        for ((joint, motion), share) in columns.iter().zip(&shares) {
            for (row, direction) in motion.iter().enumerate() {
                for part in 0..2 {
                    let cell = &mut motions[*joint][row][part];
                    *cell = cell.clone() + direction.clone() * share[part].clone();
                }
            }
        }
        let reactions = (0..modes.len())
            .map(|i| {
                std::array::from_fn(|row| {
                    std::array::from_fn(|part| {
                        let inertia = sum(&mut motions.iter().enumerate().flat_map(|(k, motion)| {
                            let mass = &mass[3 * i + row];
                            (0..3).map(move |b| mass[3 * k + b].clone() * motion[b][part].clone())
                        }));
                        inertia - loads[3 * i + row][part].clone() * determinant.clone()
                    })
                })
            })
            .collect();
        Some(Course { motions, reactions, scale: determinant * below, orientation })
    }
}

impl Decider<'_> {
    fn course(&self, modes: &[Mode], at: &LoadPoint) -> Option<Course<Ball>> {
        self.system.get_or_init(|| System::of(self.exact())).course(self.exact(), modes, at)
    }

    /// The combination, if it is consistent; of what is surely not, floating point says so.
    pub(super) fn settled(&self, modes: &[Mode], at: &LoadPoint) -> Option<Combination> {
        if self.surely_fails(modes, at) {
            return None;
        }
        let course = self.course(modes, at)?;
        let mut unpressed = 0;
        for (place, mode) in modes.iter().enumerate() {
            let signs = self.signs(&course, place, *mode, at);
            if signs.iter().any(|(sign, strict)| *sign == Less || (*strict && *sign == Equal)) {
                return None;
            }
            let signs: Vec<Ordering> = signs.into_iter().map(|(sign, _)| sign).collect();
            unpressed |= u8::from(is_unpressed(*mode, &signs)) << place;
        }
        Some(Combination { modes: modes.to_vec(), regular: course.orientation == Greater, unpressed })
    }

    /// True if floating point can tell that a condition fails.
    fn surely_fails(&self, modes: &[Mode], at: &LoadPoint) -> bool {
        let system = self.tracked.get_or_init(|| System::of(&self.approx));
        let Some(course) = system.course(&self.approx, modes, at) else { return false };
        let each = self.approx.joints.iter().zip(modes).zip(course.motions.iter().zip(&course.reactions));
        each.into_iter().any(|((joint, mode), (motion, reaction))| {
            let of = |numbers: &[Grown<Approx>; 3]| numbers.map(|[value, _]| value);
            let (conditions, count) = joint.conditions(*mode, &of(motion), &of(reaction));
            conditions[..count].iter().any(|condition| condition.value.sign() == Some(Less))
        })
    }

    /// The conditions of a joint from a load factor on, times the scale of the course, and whether each is strict.
    fn lines(&self, course: &Course<Ball>, place: usize, mode: Mode) -> Vec<(Line<Ball>, bool)> {
        let joint = &self.exact().joints[place];
        let part = |part: usize| {
            let of = |numbers: &[Grown<Ball>; 3]| std::array::from_fn(|row| numbers[row][part].clone());
            joint.conditions(mode, &of(&course.motions[place]), &of(&course.reactions[place]))
        };
        let ((values, count), (slopes, _)) = (part(0), part(1));
        let lines = values.into_iter().zip(slopes).take(count);
        lines.map(|(value, slope)| (Line { start: value.value, slope: slope.value }, value.strict)).collect()
    }

    /// The signs of the conditions of a joint, and whether each is strict.
    fn signs(
        &self,
        course: &Course<Ball>,
        place: usize,
        mode: Mode,
        at: &LoadPoint,
    ) -> Vec<(Ordering, bool)> {
        let signs = self.lines(course, place, mode).into_iter().map(|(Line { start, slope }, strict)| {
            let sign = match sign(&start) {
                Equal if at.beyond => sign(&slope),
                sign => sign,
            };
            (sign, strict)
        });
        signs.collect()
    }

    /// Just beyond which load factor a combination that holds just beyond another first fails; `None` if it never does.
    pub(super) fn fails(&self, modes: &[Mode], at: &LoadPoint) -> Option<LoadPoint> {
        let course = self.course(modes, at)?;
        let mut first: Option<[Ball; 2]> = None;
        for (place, mode) in modes.iter().enumerate() {
            for (Line { start, slope }, _) in self.lines(&course, place, *mode) {
                // How far it is from here as a fraction; nothing that does not fall, nor what is and stays at zero.
                let ahead = [start, -slope];
                let is_falling = sign(&ahead[1]) == Greater;
                let is_nearer = first.as_ref().is_none_or(|[above, below]| {
                    let apart = ahead[0].clone() * below.clone() - above.clone() * ahead[1].clone();
                    sign(&apart) == Less
                });
                if is_falling && is_nearer {
                    first = Some(ahead);
                }
            }
        }
        let [above, below] = first?;
        let [above, below] = (at.factor() + above / below).parts();
        Some(LoadPoint { above, below, beyond: true })
    }

    /// True if friction would hold a joint that rests in a combination: |f| ≤ μ_sN, whatever its other conditions.
    pub(super) fn would_hold(&self, modes: &[Mode], place: usize, at: &LoadPoint) -> bool {
        let course = self.course(modes, at);
        course.is_some_and(|course| {
            let signs = self.signs(&course, place, Mode::Rest, at);
            signs[2..].iter().all(|(sign, _)| *sign != Less)
        })
    }

    /// The motion of a combination, in numbers that are rounded once; `None` where it has none of its own.
    pub(super) fn exact_motion(&self, modes: &[Mode], at: &LoadPoint) -> Option<StackMotion> {
        let course = self.course(modes, at)?;
        let scale = course.scale.clone();
        let numbers = self.exact();
        let value = |numbers: &[Grown<Ball>; 3]| -> [Ball; 3] {
            std::array::from_fn(|row| numbers[row][0].clone() / scale.clone())
        };
        let joints = course.motions.iter().zip(&course.reactions).map(|(motion, reaction)| {
            let ([t, v, ω], [f, n, g]) = (value(motion), value(reaction));
            let xi = if sign(&n) == Equal { 0.0 } else { (g / n.clone()).value() };
            let [t, v, omega, f, n] = [t, v, ω, f, n].map(told);
            JointMotion { t, v, omega, f, n, xi }
        });
        let joints: Vec<_> = joints.collect();
        // Of the point of body i at the origin: right, up, and the rotation.
        let mut at_origin: [Ball; 3] = [zero(), zero(), zero()];
        let bodies =
            numbers.bodies.iter().zip(&numbers.joints).zip(&course.motions).map(|((body, joint), motion)| {
                let [t, v, ω] = value(motion);
                let [right, up, turn] = at_origin.clone();
                at_origin = [right + t + ω.clone() * joint.h.clone(), up + v, turn + ω];
                let [right, up, turn] = at_origin.clone();
                BodyMotion {
                    x_ddot: told(right - turn.clone() * body.y.clone()),
                    y_ddot: told(up + turn.clone() * body.x.clone()),
                    theta_ddot: told(turn),
                }
            });
        Some(StackMotion { bodies: bodies.collect(), joints })
    }
}

/// A number rounded once; one that is not told from zero is zero.
fn told(number: Ball) -> f64 {
    if sign(&number) == Equal { 0.0 } else { number.value() }
}

#[cfg(test)]
mod tests {
    use super::super::{Joint, Shaking, Stack, StackBody};
    use super::*;
    use crate::wrench::Wrench;

    /// Two bodies with numbers from a generator of its own, so heavy on friction that some D are below zero.
    fn stack(seed: u32) -> Stack {
        let mut state = seed.wrapping_mul(2_654_435_761).wrapping_add(12_345);
        let mut number = |low: f64, high: f64| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            low + (high - low) * f64::from(state >> 8) / f64::from(1 << 24)
        };
        let mut stack = Stack { shaking: Shaking::default(), ..Stack::default() };
        for place in 0..2 {
            let h = f64::from(place);
            let μ = number(0.3, 3.0);
            stack.joints.push(Joint { h, l: number(-1.0, -0.3), r: number(0.3, 1.0), mu_s: μ, mu_k: μ });
            let permanent = Wrench { x: number(-2.0, 2.0), p: number(0.2, 2.0), m: number(-1.0, 1.0) };
            stack.bodies.push(StackBody { y: h + 0.5, permanent, ..StackBody::of(1.0, number(0.05, 0.4)) });
        }
        stack
    }

    /// Two cubes pushed at the foot of the lower one, at the limit of friction: of three combinations one has D < 0.
    fn cubes() -> Stack {
        let joint = |h| Joint { h, l: -0.5, r: 0.5, mu_s: 1.0, mu_k: 1.0 };
        let cube =
            |y, x, m| StackBody { y, permanent: Wrench { x, p: 1.0, m }, ..StackBody::of(1.0, 1.0 / 6.0) };
        Stack {
            bodies: vec![cube(0.5, -1.02, -1.0025), cube(1.5, -1.04, 0.0)],
            joints: vec![joint(0.0), joint(1.0)],
            shaking: Shaking::default(),
        }
    }

    /// What elimination says of each of all combinations is what the recursion says, and so is every motion.
    #[test]
    fn elimination_and_recursion_say_the_same() {
        let (mut negative, mut consistent) = (0, 0);
        for stack in (0..60).map(stack).chain([cubes()]) {
            let decider = stack.decider().unwrap();
            let at = LoadPoint::of(1.0);
            let found = decider.consistent(&at);
            let all: Vec<[Mode; 2]> =
                Mode::ALL.into_iter().flat_map(|one| Mode::ALL.map(|other| [one, other])).collect();
            let settled = all.iter().filter_map(|modes| decider.settled(modes, &at)).collect();
            let sorted = |mut all: Vec<Combination>| {
                all.sort_by(|one, other| one.modes.cmp(&other.modes));
                all
            };
            consistent += found.iter().filter(|one| !one.regular).count();
            assert_eq!(sorted(found), sorted(settled), "{stack:?}");
            for modes in &all {
                let Some(course) = decider.course(modes, &at) else { continue };
                assert_eq!(
                    course.orientation == Greater,
                    decider.orientation(modes) > 0.0,
                    "{stack:?} {modes:?}"
                );
                negative += u32::from(course.orientation == Less);
                let [rounded, exact] =
                    [decider.motion(modes, &at), decider.exact_motion(modes, &at)].map(Option::unwrap);
                for (a, b) in rounded.joints.iter().zip(&exact.joints) {
                    let pairs =
                        [(a.t, b.t), (a.v, b.v), (a.omega, b.omega), (a.f, b.f), (a.n, b.n), (a.xi, b.xi)];
                    let near = |(a, b): &(f64, f64)| (a - b).abs() <= 1e-9 * (1.0 + b.abs());
                    assert!(pairs.iter().all(near), "{modes:?} {a:?} {b:?}");
                }
                for (a, b) in rounded.bodies.iter().zip(&exact.bodies) {
                    let pairs = [(a.x_ddot, b.x_ddot), (a.y_ddot, b.y_ddot), (a.theta_ddot, b.theta_ddot)];
                    let near = |(a, b): &(f64, f64)| (a - b).abs() <= 1e-9 * (1.0 + b.abs());
                    assert!(pairs.iter().all(near), "{modes:?} {a:?} {b:?}");
                }
            }
        }
        assert!(negative > 0 && consistent > 0);
    }
}
