//! The plane of ground that fails: a corner of rest, a tongue of sliding, and bearing failure.

use standfast::ground::bearing::BearingPlane;
use standfast::region::{Curve, Strip};
use standfast::{Mode, Verdict};

use super::crush::straight;
use super::shape::{Shape, chained, rest_of, shown, strips_of, traced};
use crate::outlines::{Mark, OutlinedLine, Polyline, Tick};
use crate::plot::View;

pub(super) fn shape(plane: &BearingPlane, view: &View) -> Shape {
    let k_bf = plane.k_bf();
    let rest = Strip { from: 0.0, to: k_bf, lower: Curve::DIAGONAL, upper: None };
    let rest: Vec<Strip> = Some(rest).filter(|_| k_bf > 0.0).into_iter().collect();
    let (left, mut right) = edges(plane, view);
    // A tongue without end is open above where its edges do not meet.
    if let (Some(&(from, top)), Some(&(to, _))) = (left.last(), right.last())
        && from < view.k_max
        && to > view.k_max
    {
        right.extend([(view.k_max, top), (from, top)]);
    }
    let mut polygon: Polyline = right.clone();
    polygon.extend(left.iter().rev());
    polygon.dedup();
    let slide = chained(strips_of(&polygon, view), view);
    let fails = chained(rest_of(&[&rest, &slide]), view);
    let areas = [
        (Verdict::Begins(Mode::Rest), rest),
        (Verdict::Begins(Mode::SlideLeft), slide),
        (Verdict::BearingFailure, fails),
    ];

    let mut lines = Vec::new();
    let mut add = |name, formula, parts: Vec<Polyline>| {
        if !parts.is_empty() {
            lines.push(OutlinedLine { name, formula, short: "", dashed: false, parts });
        }
    };
    let beyond: Polyline = left.into_iter().filter(|(k, mu)| k > mu || *mu >= k_bf).collect();
    let bearing = [right, beyond].iter().flat_map(|edge| shown(edge, view)).collect();
    add("R = V", "$R = V$", bearing);
    add("OA", "$μ = k$", straight(Curve::DIAGONAL, 0.0, k_bf, view));
    if k_bf > 0.0 && view.shows(k_bf, k_bf) {
        add("vertical at k_BF", "", vec![vec![(k_bf, k_bf), (k_bf, view.mu_max)]]);
    }
    let name = r"$k_{\up{BF}}$";
    let corner = Mark { letter: "k_BF", markup: name.to_owned(), k: k_bf, mu: k_bf };
    let tick = Tick { at: k_bf, markup: name.to_owned(), of: Some((k_bf, k_bf)) };
    let is_shown = k_bf > 0.0 && view.shows(k_bf, k_bf);
    Shape {
        areas: areas.into_iter().filter(|(_, strips)| !strips.is_empty()).collect(),
        lines,
        points: Some(corner).filter(|_| is_shown).into_iter().collect(),
        k_marks: Some(tick).filter(|_| is_shown).into_iter().collect(),
        mu_marks: Vec::new(),
    }
}

/// The edges of the tongue in which a body that slides is borne, from the axis upwards: where it begins to slide or to be borne, and
/// where it is borne no more.
fn edges(plane: &BearingPlane, view: &View) -> (Polyline, Polyline) {
    let [tip, top] = plane.slide_top();
    if top <= 0.0 {
        return (Vec::new(), Vec::new());
    }
    // The tongue has no end for k' = 0.
    let farthest = 4.0 * view.k_max;
    let range = |mu: f64| match plane.slide_range(mu) {
        Some([from, to]) => (mu, from.max(mu), to.min(farthest)),
        // Next to the top rounding decides.
        None if plane.k_prime() == 0.0 => (mu, mu, farthest),
        None => (mu, tip, tip),
    };
    let mut stops = vec![0.0, plane.k_bf().min(top), view.mu_max.min(top), top];
    // Where the edges leave the window.
    let steps: Vec<_> = (0..=400).map(|i| range(top * f64::from(i) / 400.0)).collect();
    for pair in steps.windows(2) {
        for side in [|at: (f64, f64, f64)| at.1, |at: (f64, f64, f64)| at.2] {
            let is_out = |at: (f64, f64, f64)| side(at) > view.k_max;
            let begins = is_out(pair[0]);
            if begins != is_out(pair[1]) {
                let (mut one, mut other) = (pair[0].0, pair[1].0);
                for _ in 0..60 {
                    let middle = (one + other) / 2.0;
                    if is_out(range(middle)) == begins { one = middle } else { other = middle }
                }
                stops.push(other);
            }
        }
    }
    stops.sort_by(f64::total_cmp);
    stops.dedup_by(|later, earlier| *later - *earlier <= 1e-12 * top);
    let trace = |side: fn(&(f64, f64, f64)) -> (f64, f64)| {
        traced(&stops, range, side, view).iter().map(side).collect::<Polyline>()
    };
    (trace(|at| (at.1, at.0)), trace(|at| (at.2, at.0)))
}
