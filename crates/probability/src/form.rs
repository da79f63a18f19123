//! The first-order reliability method, without gradients.
//!
//! Of all points at which one of some outcomes holds, the one nearest to the origin of independent standard normals u: the
//! design point; its distance is β, its direction α. On the line the nearest value is known, so that over the other inputs v
//!
//! ```text
//! u_line(v)² + |v|² → least
//! ```
//!
//! is all that is left. The function has kinks where formulas change, and none is smooth at a corner of a mode's region: so
//! Nelder and Mead's simplex, begun again about what it has found until two rounds agree, from several starts.
//!
//! Φ(−β) is not a probability: it is that of a half-space. It ranks; [`integrate`](crate::integrate) and
//! [`sample`](crate::sample) answer.

use crate::normal;
use crate::points::Sobol;
use crate::problem::{Frame, Outcomes, RandomVector, Scratch};
use crate::simplex::simplex;

/// The point of some outcomes that is nearest to the medians, in standard normals.
#[derive(Debug, Clone, PartialEq)]
pub struct FormPoint {
    /// The reliability index: its distance from the origin, 0 if the origin itself is such a point; negative of a point
    /// [turned](FormPoint::turned).
    pub beta: f64,
    /// The point in independent standard normals, in the order of the inputs (Cholesky's factor in that order).
    pub u: Vec<f64>,
    /// The values of the inputs there.
    pub values: Vec<f64>,
    /// u/β: by how much each input's normal contributes, signed. Zeros if β is 0.
    pub alpha: Vec<f64>,
    /// True if a formula changes at the point: no one formula's gradient is α there.
    pub at_change: bool,
    /// Number of starts that led here.
    pub agreeing: usize,
    /// Number of starts.
    pub starts: usize,
}

impl FormPoint {
    /// As the point of the outcomes on the other side, where the origin is among them: β is negative then, and α = u/β still.
    pub fn turned(self) -> FormPoint {
        let alpha = self.alpha.iter().map(|cosine| -cosine).collect();
        FormPoint { beta: -self.beta, alpha, ..self }
    }

    /// By what β grows if the input with this number is held at its median: 1/√(1 − α²).
    pub fn omission(&self, input: usize) -> f64 {
        (1.0 - self.alpha[input].powi(2)).max(0.0).sqrt().recip()
    }

    /// Φ(−β): a first-order figure, no probability of the outcomes.
    pub fn first_order(&self) -> f64 {
        normal::above(self.beta)
    }
}

/// β of a probability: −Φ⁻¹(P).
pub fn generalized(probability: f64) -> f64 {
    normal::quantile_above(probability)
}

/// Largest number of starts, and their distance from the origin.
const STARTS: usize = 8;
const FAR: f64 = 8.0;
/// Of so many points on each axis, and so many in all at most, the best are taken to start from.
const SCREENED_EACH: u64 = 32;
const SCREENED: u64 = 2048;
/// By how much two rounds may differ that agree, relative to β².
const AGREED: f64 = 1e-13;

/// By how much, relative to β², two starts may differ that have led to one point.
const MET: f64 = 1e-9;
/// And by how much such points may lie apart, relative to 1 + β.
const BESIDE: f64 = 1e-4;

/// The design point of the outcomes in `which` (a bit for each); none if nowhere within reach any of them holds.
pub fn design_point<O: Outcomes>(inputs: &RandomVector, outcomes: &O, which: u64) -> Option<FormPoint> {
    local_design_points(inputs, outcomes, which).into_iter().next()
}

/// Distance up to which two points are as good as one to draw about, in deviations.
const APART: f64 = 0.1;

/// The points in standard normals, each once: those that lie apart from each other, in their order.
pub fn apart(points: impl IntoIterator<Item = FormPoint>) -> Vec<Vec<f64>> {
    let mut found: Vec<Vec<f64>> = Vec::new();
    for FormPoint { u, .. } in points {
        if found.iter().all(|other| distance(other, &u) > APART) {
            found.push(u);
        }
    }
    found
}

/// The nearest points of the outcomes in `which`; where one of these holds at the medians those of the outcomes in `otherwise`,
/// [turned](FormPoint::turned).
pub fn boundary_points<O: Outcomes>(
    inputs: &RandomVector,
    outcomes: &O,
    which: u64,
    otherwise: u64,
) -> Vec<FormPoint> {
    let points = local_design_points(inputs, outcomes, which);
    if points.first().is_some_and(|point| point.beta == 0.0) {
        let other = local_design_points(inputs, outcomes, otherwise);
        return other.into_iter().map(FormPoint::turned).collect();
    }
    points
}

/// All nearest points that the starts have found, the nearest first: those that lie apart from each other.
pub fn local_design_points<O: Outcomes>(inputs: &RandomVector, outcomes: &O, which: u64) -> Vec<FormPoint> {
    let frame = Frame::new(inputs, outcomes);
    let mut search = Search { frame: &frame, which, scratch: frame.scratch() };
    let n = frame.dimensions();
    let mut found: Vec<Candidate> = Vec::new();
    let starts = if n == 0 { vec![Vec::new()] } else { search.starts(n) };
    for start in &starts {
        let Some((square, v)) = search.descend(start, &found) else { continue };
        match found.iter_mut().find(|(_, other, _)| distance(other, &v) < 1e-2 * (1.0 + square.sqrt())) {
            Some(same) => {
                if square < same.0 {
                    (same.0, same.1) = (square, v);
                }
                same.2 += 1;
            }
            None => found.push((square, v, 1)),
        }
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    found
        .into_iter()
        .filter_map(|(_, v, agreeing)| {
            let line = search.frame.nearest(&v, which, &mut search.scratch)?;
            let u = search.frame.in_given_order(&v, line);
            let beta = u.iter().map(|u| u * u).sum::<f64>().sqrt();
            let z = inputs.copula().correlated(&u);
            Some(FormPoint {
                beta,
                alpha: u.iter().map(|u| if beta > 0.0 { u / beta } else { 0.0 }).collect(),
                values: inputs.values_of(&z),
                u,
                at_change: search.at_change(&v),
                agreeing,
                starts: starts.len(),
            })
        })
        .collect()
}

/// The square of a point's distance, the point, and how many starts led there.
type Candidate = (f64, Vec<f64>, usize);

struct Search<'f, 'a, O> {
    frame: &'f Frame<'a, O>,
    which: u64,
    scratch: Scratch,
}

impl<O: Outcomes> Search<'_, '_, O> {
    /// The square of the distance of the nearest point with these other inputs; without bound where there is none.
    fn square(&mut self, v: &[f64]) -> f64 {
        let others: f64 = v.iter().map(|v| v * v).sum();
        self.frame
            .nearest(v, self.which, &mut self.scratch)
            .map_or(f64::INFINITY, |line| line * line + others)
    }

    /// Points to start from: of many, the best, and then the best that lie apart from those chosen.
    fn starts(&mut self, n: usize) -> Vec<Vec<f64>> {
        let sobol = Sobol::new(n, 1, 0);
        let count = SCREENED_EACH.saturating_pow(n as u32).clamp(2 * SCREENED_EACH, SCREENED);
        let mut screened: Vec<(f64, Vec<f64>)> = (0..count)
            .map(|i| {
                let v: Vec<f64> = if i == 0 {
                    vec![0.0; n]
                } else {
                    sobol.point(i).map(|p| FAR * (2.0 * p - 1.0)).collect()
                };
                (self.square(&v), v)
            })
            .filter(|(square, _)| square.is_finite())
            .collect();
        screened.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut starts: Vec<Vec<f64>> = Vec::new();
        let mut apart = 2.0;
        while starts.len() < STARTS.min(screened.len()) && apart > 1e-3 {
            for (_, v) in &screened {
                if starts.len() < STARTS && starts.iter().all(|other| distance(other, v) > apart) {
                    starts.push(v.clone());
                }
            }
            apart *= 0.5;
        }
        starts
    }

    /// The least square that is found from a start, and where; no farther than to where another start has led.
    fn descend(&mut self, start: &[f64], found: &[Candidate]) -> Option<(f64, Vec<f64>)> {
        let mut best = (self.square(start), start.to_vec());
        let (mut size, mut agreed): (f64, usize) = (0.5, 0);
        for round in 0..60 {
            let signed: f64 = if round % 2 == 0 { size } else { -size };
            let next = simplex(&mut |v| self.square(v), &best.1, signed);
            let gain = best.0 - next.0;
            let little = gain <= AGREED * best.0.max(1e-300);
            if next.0 < best.0 {
                best = next;
            }
            agreed = if little { agreed + 1 } else { 0 };
            let met = |(square, v, _): &Candidate| {
                (best.0 - square).abs() <= MET * square
                    && distance(v, &best.1) <= BESIDE * (1.0 + square.sqrt())
            };
            if found.iter().any(met) {
                break;
            }
            if agreed == 2 * start.len().min(2) {
                break;
            }
            // A round that found nothing looks nearer; one that did, as far again.
            size = if little { size * 0.05 } else { size.max(1e-3) };
        }
        best.0.is_finite().then_some(best)
    }

    /// True if the pattern of the pieces changes at a point.
    fn at_change(&mut self, v: &[f64]) -> bool {
        let here = self.frame.evaluate(v, &mut self.scratch);
        (0..v.len()).any(|i| {
            [-1e-5, 1e-5].into_iter().any(|step| {
                let mut beside = v.to_vec();
                beside[i] += step;
                self.frame.evaluate(&beside, &mut self.scratch) != here
            })
        })
    }
}

/// Distance of two points in standard normals.
pub fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}
