//! The ten modes of a joint: what it may do, what its reaction may be, and the conditions of each.

use std::cmp::Ordering::{self, Equal};

use super::Joint;
use crate::exact::Real;
use crate::mode::{Corner, Mode, Slip};

/// Motions and rows of a mode in the coordinates (t, v, ω) and (f, N, G) of its joint.
pub(super) struct Freedom<T> {
    pub(super) motions: Vec<[T; 3]>,
    pub(super) rows: Vec<[T; 3]>,
}

impl<T: Real> Freedom<T> {
    pub(super) fn of(joint: &Joint<T>, mode: Mode) -> Freedom<T> {
        let of = T::of;
        let unit = |place: usize| std::array::from_fn(|i| of(if i == place { 1.0 } else { 0.0 }));
        if mode == Mode::Flight {
            let all: Vec<[T; 3]> = (0..3).map(unit).collect();
            return Freedom { motions: all.clone(), rows: all };
        }
        let (mut motions, mut rows) = (Vec::new(), Vec::new());
        if let Some(slip) = mode.slip() {
            motions.push(unit(0));
            rows.push([of(1.0), of(slip.sign()) * joint.mu_k.clone(), of(0.0)]);
        }
        if let Some(corner) = mode.corner() {
            let about = [of(0.0), -joint.end(corner), of(1.0)];
            motions.push(about.clone());
            rows.push(about);
        }
        Freedom { motions, rows }
    }
}

impl<T: Real> Joint<T> {
    /// Position of a corner.
    fn end(&self, corner: Corner) -> T {
        match corner {
            Corner::O => self.l.clone(),
            Corner::OPrime => self.r.clone(),
        }
    }

    /// The conditions of a mode, with the relative acceleration (t, v, ω) and the reaction (f, N, G) of the joint.
    pub(super) fn conditions(
        &self,
        mode: Mode,
        motion: &[T; 3],
        reaction: &[T; 3],
    ) -> ([Condition<T>; 4], usize) {
        let ([t, v, ω], [f, n, g]) = (motion, reaction);
        let mul = |a: &T, b: &T| a.clone() * b.clone();
        let not_below = |value: T| Condition { value, strict: false };
        let above = |value: T| Condition { value, strict: true };
        let on_joint = || [not_below(g.clone() - mul(&self.l, n)), not_below(mul(&self.r, n) - g.clone())];
        let holds = || {
            let grip = mul(&self.mu_s, n);
            [not_below(grip.clone() - f.clone()), not_below(grip + f.clone())]
        };
        let slips = |slip: Slip| {
            above(match slip {
                Slip::Left => -t.clone(),
                Slip::Right => t.clone(),
            })
        };
        let none = || not_below(T::of(0.0));
        match (mode.corner(), mode.slip()) {
            _ if mode == Mode::Flight => {
                let gap = |end: &T| not_below(v.clone() + mul(end, ω));
                ([gap(&self.l), gap(&self.r), none(), none()], 2)
            }
            (None, None) => {
                let ([one, two], [three, four]) = (on_joint(), holds());
                ([one, two, three, four], 4)
            }
            (None, Some(slip)) => {
                let [one, two] = on_joint();
                ([slips(slip), one, two, none()], 3)
            }
            (Some(corner), slip) => {
                let turns = above(if corner == Corner::O { ω.clone() } else { -ω.clone() });
                let presses = not_below(n.clone());
                match slip {
                    Some(slip) => ([turns, presses, slips(slip), none()], 3),
                    None => {
                        let [three, four] = holds();
                        ([turns, presses, three, four], 4)
                    }
                }
            }
        }
    }
}

/// A quantity that must not be below zero, or has to be above it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Condition<T> {
    pub(super) value: T,
    pub(super) strict: bool,
}

/// True if a mode that touches presses nothing: by the signs of its conditions, in their order.
pub(super) fn is_unpressed(mode: Mode, signs: &[Ordering]) -> bool {
    match (mode.corner(), mode.slip()) {
        _ if mode == Mode::Flight => false,
        (None, None) => signs[..2] == [Equal; 2],
        (None, Some(_)) => signs[1..3] == [Equal; 2],
        (Some(_), _) => signs[1] == Equal,
    }
}
