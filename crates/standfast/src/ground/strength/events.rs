//! Load factors at which a mode that turns may begin or end, along a load that rises.
//!
//! A turn's equation F(a) and the sign W(a) that decides whether it slips are polynomials in the rotation a, with coefficients that are
//! polynomials in the load factor λ. The modes change where a root of F appears at a = 0 (a quadratic in λ, among the path's conditions), where
//! two roots of F meet, or where W vanishes at a root: at the zeros in λ of two resultants,
//!
//! ```text
//! Res(F, F')(λ) = 0        Res(F, W)(λ) = 0
//! ```
//!
//! so that all such load factors are known without sampling. The zeros are those of f64: of two so near to each other that rounding hides the sign
//! between them, some 10⁻⁷ of their size, both would be missed. Between them the resultant has a zero of its slope, which is known to round-off: where the
//! resultant is as good as zero there, the load factor itself is decided too. Of a polynomial whose coefficients are exact, what may be missed is narrower than some 10⁻¹³; by how much
//! the rounding of the determinant widens that is not known. What holds between load factors is decided exactly, elsewhere.

use std::array::from_fn;
use std::ops::{Add, Mul, Neg, Sub};

use super::Numbers;
use super::conditions::{CORNERS, SLIPS};
use super::turning::Turn;
use crate::contact::Block;
use crate::exact::Real;
use crate::ground::roots::real_roots;
use crate::polynomial::value;
use crate::wrench::Wrench;

/// A polynomial in the load factor, its constant first; none of zero.
#[derive(Debug, Clone, PartialEq)]
struct Polynomial(Vec<f64>);

impl Polynomial {
    fn is_zero(&self) -> bool {
        self.0.iter().all(|coefficient| *coefficient == 0.0)
    }

    fn times(&self, factor: f64) -> Polynomial {
        Polynomial(self.0.iter().map(|coefficient| coefficient * factor).collect())
    }

    /// With its largest coefficient 1 in size.
    fn normal(self) -> Polynomial {
        let most = self.0.iter().fold(0.0, |most: f64, coefficient| most.max(coefficient.abs()));
        if most > 0.0 && most.is_finite() { self.times(1.0 / most) } else { self }
    }

    /// Its zeros above zero: those up to 1, and those of the polynomial of 1/λ. Around a zero of the slope at which it is zero but for
    /// rounding, two numbers that have it in their middle.
    fn zeros(self) -> Vec<f64> {
        let mut up = self.normal().0;
        while up.last() == Some(&0.0) {
            up.pop();
        }
        let down: Vec<f64> = up.iter().rev().copied().collect();
        let both = |f: &[f64]| real_roots(f, 0.0, 1.0).into_iter().chain(touched(f)).collect::<Vec<_>>();
        let far = both(&down).into_iter().filter(|inverse| *inverse > 0.0);
        both(&up).into_iter().chain(far.map(f64::recip)).collect()
    }
}

/// Rounding beside the sum of a polynomial's terms, determinants and all, as a share of it.
const ROUNDING: f64 = 1e-10;
/// Half the distance of two numbers that are told apart, relatively.
const APART: f64 = 32.0 * f64::EPSILON;

/// Pairs of numbers between 0 and 1, each about a place where a polynomial may touch zero, or be zero twice.
fn touched(f: &[f64]) -> Vec<f64> {
    let slope: Vec<f64> = f.iter().enumerate().skip(1).map(|(i, c)| c * i as f64).collect();
    let size = |x: f64| f.iter().rev().fold(0.0, |sum, c| sum * x + c.abs());
    let touches = |x: &f64| value(f, x).abs() <= ROUNDING * size(*x);
    let places = real_roots(&slope, 0.0, 1.0).into_iter().filter(touches);
    places.flat_map(|x| [x * (1.0 - APART), x * (1.0 + APART)]).collect()
}

impl Real for Polynomial {
    fn of(x: f64) -> Polynomial {
        Polynomial(if x == 0.0 { Vec::new() } else { vec![x] })
    }
}

impl Add for Polynomial {
    type Output = Polynomial;
    fn add(self, other: Polynomial) -> Polynomial {
        let (mut long, short) =
            if self.0.len() >= other.0.len() { (self.0, other.0) } else { (other.0, self.0) };
        long.iter_mut().zip(short).for_each(|(one, two)| *one += two);
        Polynomial(long)
    }
}

impl Neg for Polynomial {
    type Output = Polynomial;
    fn neg(self) -> Polynomial {
        self.times(-1.0)
    }
}

impl Sub for Polynomial {
    type Output = Polynomial;
    fn sub(self, other: Polynomial) -> Polynomial {
        self + -other
    }
}

impl Mul for Polynomial {
    type Output = Polynomial;
    fn mul(self, other: Polynomial) -> Polynomial {
        let mut product = vec![0.0; (self.0.len() + other.0.len()).saturating_sub(1)];
        if self.0.is_empty() || other.0.is_empty() {
            return Polynomial(Vec::new());
        }
        for (i, one) in self.0.iter().enumerate() {
            for (j, two) in other.0.iter().enumerate() {
                product[i + j] += one * two;
            }
        }
        Polynomial(product)
    }
}

/// The resultant in a of two polynomials in a, by Sylvester's determinant.
fn resultant(f: &[Polynomial], g: &[Polynomial]) -> Polynomial {
    let (n, m) = (f.len() - 1, g.len() - 1);
    let row = |of: &[Polynomial], shift: usize| -> Vec<Polynomial> {
        (0..n + m)
            .map(|column| match column.checked_sub(shift).filter(|place| *place < of.len()) {
                Some(place) => of[of.len() - 1 - place].clone(),
                None => Polynomial(Vec::new()),
            })
            .collect()
    };
    let rows: Vec<_> = (0..m).map(|shift| row(f, shift)).chain((0..n).map(|shift| row(g, shift))).collect();
    determinant(&rows, &mut (0..n + m).collect())
}

/// The determinant of the last rows in some columns, by its first row.
fn determinant(rows: &[Vec<Polynomial>], columns: &mut Vec<usize>) -> Polynomial {
    let Some(first) = rows.len().checked_sub(columns.len()).and_then(|row| rows.get(row)) else {
        return Polynomial::of(1.0);
    };
    let mut sum = Polynomial(Vec::new());
    for i in 0..columns.len() {
        let entry = &first[columns[i]];
        if entry.is_zero() {
            continue;
        }
        let column = columns.remove(i);
        let term = entry.clone() * determinant(rows, columns);
        columns.insert(i, column);
        sum = if i % 2 == 0 { sum + term } else { sum - term };
    }
    sum
}

/// Without leading coefficients that are zero for every load factor.
fn trimmed(mut f: Vec<Polynomial>) -> Vec<Polynomial> {
    while f.last().is_some_and(Polynomial::is_zero) {
        f.pop();
    }
    f
}

/// Load factors above zero between which no mode that turns begins or ends but where a condition of rest or slide is crossed; others may
/// be among them.
pub(super) fn events(block: &Block, permanent: &Wrench, variable: &Wrench, strength: f64) -> Vec<f64> {
    let size = |w: &Wrench| w.x.abs().max(w.p.abs()).max(w.m.abs());
    let (standing, rising) = (size(permanent), size(variable));
    if rising == 0.0 {
        return Vec::new();
    }
    // λ in units in which both loads are alike, and forces in those of the permanent ones.
    let unit = if standing > 0.0 { standing / rising } else { 1.0 };
    let scale = if standing > 0.0 { standing } else { rising };
    let part = |of: fn(&Wrench) -> f64| Polynomial(vec![of(permanent) / scale, unit * of(variable) / scale]);
    let Block { b1, b2, d, rho2, m_x, m_y, mu_s, mu_k } = *block;
    let [d, rho2, m_x, m_y, mu_s, mu_k] = [d, rho2, m_x, m_y, mu_s, mu_k].map(Polynomial::of);
    let q = if strength == f64::INFINITY { [1.0, 0.0] } else { [strength / scale, 1.0] };
    let n = Numbers {
        b: [b1, b2].map(Polynomial::of),
        d,
        rho2,
        m_x,
        m_y,
        mu_s,
        mu_k,
        x: part(|w| w.x),
        p: part(|w| w.p),
        m: part(|w| w.m),
        q: q.map(Polynomial::of),
    };
    let mut found = Vec::new();
    for corner in CORNERS {
        for turns in [None, Some(SLIPS[0]), Some(SLIPS[1])] {
            let turn = Turn::about(&n, corner, turns);
            let slips = turns.map_or(SLIPS.to_vec(), |slip| vec![slip]);
            let mu = if turns.is_none() { &n.mu_s } else { &n.mu_k };
            // Of a body that is lifted a begins where its edge begins to be pressed.
            let pressed = Turn::from_pressed(turn.equation.clone(), &n, corner, true);
            found.extend(pressed[0].clone().zeros());
            let frictions: Vec<_> =
                slips.iter().map(|slip| trimmed(turn.slipping(&n, corner, *slip, mu))).collect();
            let equation = trimmed(turn.equation);
            for friction in frictions.iter().filter(|friction| !friction.is_empty() && !equation.is_empty()) {
                found.extend(resultant(&equation, friction).zeros());
            }
            if turns.is_some() && equation.len() > 2 {
                let slope =
                    equation.iter().enumerate().skip(1).map(|(i, c)| c.times(i as f64)).collect::<Vec<_>>();
                found.extend(resultant(&equation, &slope).zeros());
            }
        }
    }
    // Friction to slip, and the edges of a body that flies.
    let grip = n.mu_k.clone() * n.p.clone();
    let (fall, spin) = (n.p.clone() * n.rho2.clone(), n.m_y.clone() * n.m.clone());
    let lines: [Polynomial; 4] = from_fn(|i| match i {
        0 => grip.clone() - n.x.clone(),
        1 => grip.clone() + n.x.clone(),
        2 => fall.clone() + n.b[0].clone() * spin.clone(),
        _ => fall.clone() - n.b[1].clone() * spin.clone(),
    });
    found.extend(lines.into_iter().flat_map(Polynomial::zeros));
    found.into_iter().map(|λ| λ * unit).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polynomial(coefficients: &[f64]) -> Polynomial {
        Polynomial(coefficients.to_vec())
    }

    /// Res of (a − λ)(a − 2)(a + 1) and (a − 3)(a − λ²) is the product of the differences of their roots.
    #[test]
    fn a_resultant_is_the_product_of_differences() {
        // (a² − a − 2)(a − λ) and a² − (3 + λ²) a + 3λ²
        let f = [
            polynomial(&[0.0, 2.0]),
            polynomial(&[-2.0, 1.0]),
            polynomial(&[-1.0, -1.0]),
            polynomial(&[1.0]),
        ];
        let g = [polynomial(&[0.0, 0.0, 3.0]), polynomial(&[-3.0, 0.0, -1.0]), polynomial(&[1.0])];
        let found = resultant(&f, &g);
        for λ in [0.3, 1.0, 1.7, 2.5, 4.0] {
            let (ours, theirs) = ([λ, 2.0, -1.0], [3.0, λ * λ]);
            let expected: f64 = ours.iter().flat_map(|one| theirs.map(|two| one - two)).product();
            let at = value(&found.0, &λ);
            assert!((at - expected).abs() < 1e-9 * (1.0 + expected.abs()), "{λ}: {at} {expected}");
        }
        // Zero at λ = 3, λ² = λ, λ² = 2; at λ² = −1 not.
        let zeros = found.zeros();
        for expected in [1.0, 2f64.sqrt(), 3.0] {
            assert!(zeros.iter().any(|zero| (zero - expected).abs() < 1e-9), "{expected}: {zeros:?}");
        }
    }

    #[test]
    fn zeros_near_and_far_are_found() {
        // (λ − 1/4)(λ − 50)(λ + 1)
        let zeros = (polynomial(&[-0.25, 1.0]) * polynomial(&[-50.0, 1.0]) * polynomial(&[1.0, 1.0])).zeros();
        assert_eq!(zeros.len(), 2);
        assert!((zeros[0] - 0.25).abs() < 1e-15 && (zeros[1] - 50.0).abs() < 1e-12, "{zeros:?}");
    }

    /// Two zeros as near to each other as one likes: one of them is found, or a number between both is the middle of two that are.
    #[test]
    fn two_zeros_are_not_missed_together() {
        for (at, other) in [(0.3, 0.7), (0.9, 5.0), (7.0, 0.2), (60.0, 0.01)] {
            for gap in (3..=13).map(|digits| 10f64.powi(-digits)) {
                let (low, high) = (at * (1.0 - gap), at * (1.0 + gap));
                let pair = polynomial(&[-low, 1.0]) * polynomial(&[-high, 1.0]);
                let mut zeros = (pair * polynomial(&[-other, 1.0]) * polynomial(&[2.0, 1.0])).zeros();
                zeros.sort_by(f64::total_cmp);
                let middles = zeros.windows(2).map(|two| two[0] + (two[1] - two[0]) / 2.0);
                let between = middles.filter(|middle| *middle > low && *middle < high).count();
                assert!(between > 0, "{at} ± {gap}: {zeros:?}");
            }
        }
        // A polynomial that is far from zero where its slope is zero is left alone.
        assert_eq!((polynomial(&[-0.25, 1.0]) * polynomial(&[-0.75, 1.0])).zeros().len(), 2);
    }
}
