//! The plane of load factor and friction where the base gives way: its bands as strips between points of its boundaries.

use standfast::Verdict;
use standfast::ground::load_plane::{GroundLoadPlane, LoadBand, LoadEdge};
use standfast::region::{Curve, Strip};

use super::Shaded;
use crate::ground::shape::{through, traced};
use crate::outlines::Polyline;
use crate::plot::View;

/// The regions of a base that gives way.
pub(super) fn regions(plane: &GroundLoadPlane, friction: f64) -> Vec<Shaded> {
    let view = view(plane, friction);
    let mut regions: Vec<Shaded> = Vec::new();
    for band in plane.bands() {
        let stops = stops(plane, band, &view);
        for cell in &band.cells {
            let Some(verdict) = cell.verdict else { continue };
            let [lower, upper] =
                [cell.lower, cell.upper].map(|edge| Some(along(plane, edge?, &stops, &view)));
            let strips = (1..stops.len()).map(|i| {
                let line = |points: &Polyline| through(points[i - 1], points[i]);
                let lower = lower.as_ref().map_or(Curve::AXIS, line);
                Strip { from: stops[i - 1], to: stops[i], lower, upper: upper.as_ref().map(line) }
            });
            attach(&mut regions, verdict, strips.collect(), &view);
        }
    }
    regions
}

/// The boundaries between different verdicts, through points of their curves.
pub(super) fn lines(plane: &GroundLoadPlane, friction: f64) -> Vec<(LoadEdge, Polyline)> {
    let view = view(plane, friction);
    let mut lines = Vec::new();
    for band in plane.bands() {
        let stops = stops(plane, band, &view);
        let edges = band.cells.iter().filter_map(|cell| cell.upper);
        lines.extend(edges.map(|edge| (edge, along(plane, edge, &stops, &view))));
    }
    lines
}

/// Where friction holds a body between two load factors.
pub(super) fn between(plane: &GroundLoadPlane, [from, to]: [f64; 2]) -> Vec<Strip> {
    const PARTS: u32 = 16;
    let end = plane.bands().last().map_or(0.0, |band| band.to);
    let to = to.min(end);
    if from >= to {
        return Vec::new();
    }
    let held = LoadEdge::Friction { slips: false };
    let stop = |i: u32| from + (to - from) * f64::from(i) / f64::from(PARTS);
    let points: Polyline = (0..=PARTS).filter_map(|i| Some((stop(i), plane.at(held, stop(i))?))).collect();
    let strip = |pair: &[(f64, f64)]| Strip {
        from: pair[0].0,
        to: pair[1].0,
        lower: through(pair[0], pair[1]),
        upper: None,
    };
    points.windows(2).map(strip).collect()
}

/// How close the curves are to be followed: as this part of the plane asks for.
fn view(plane: &GroundLoadPlane, friction: f64) -> View {
    let end = plane.bands().last().map_or(1.0, |band| band.to);
    View::from_origin(end, (2.5 * friction).max(1.2))
}

/// Where the boundaries of a band have points: all of them at the same load factors, so that neighbours share their lines.
fn stops(plane: &GroundLoadPlane, band: &LoadBand, view: &View) -> Vec<f64> {
    let mut stops = vec![band.from, band.to];
    for edge in band.cells.iter().filter_map(|cell| cell.upper) {
        let at = |factor: f64| (factor, value(plane, edge, band, factor, view));
        stops.extend(traced(&[band.from, band.to], at, |point| *point, view).iter().map(|point| point.0));
    }
    stops.sort_by(f64::total_cmp);
    stops.dedup();
    stops
}

/// μ of a boundary within its band; of one that ends or rises out of sight next to the band's end, a value out of sight.
fn value(plane: &GroundLoadPlane, edge: LoadEdge, band: &LoadBand, factor: f64, view: &View) -> f64 {
    let far = 8.0 * view.mu_max;
    // At an end of the band a boundary may just not be, by rounding.
    let inside = |share: f64| factor + share * ((band.from + band.to) / 2.0 - factor);
    let found = [0.0, 1e-15, 1e-12, 1e-9].into_iter().find_map(|share| plane.at(edge, inside(share)));
    found.unwrap_or(far).min(far)
}

fn along(plane: &GroundLoadPlane, edge: LoadEdge, stops: &[f64], view: &View) -> Polyline {
    let band = LoadBand { from: stops[0], to: stops[stops.len() - 1], cells: Vec::new() };
    stops.iter().map(|factor| (*factor, value(plane, edge, &band, *factor, view))).collect()
}

/// Adds strips to the region of a verdict that ends where they begin and touches them there, or begins a region.
fn attach(regions: &mut Vec<Shaded>, verdict: Verdict, strips: Vec<Strip>, view: &View) {
    let Some(first) = strips.first().copied() else { return };
    let span = |strip: &Strip| {
        let upper = strip.upper.map_or(f64::INFINITY, |upper| upper.at(first.from));
        (strip.lower.at(first.from), upper)
    };
    let near = 1e-9 * view.mu_max;
    let touches = |last: &Strip| {
        let ((low, high), (next_low, next_high)) = (span(last), span(&first));
        last.to == first.from && low < next_high - near && next_low < high - near
    };
    let before = regions
        .iter_mut()
        .find(|region| region.verdict == verdict && region.strips.last().is_some_and(touches));
    match before {
        Some(region) => region.strips.extend(strips),
        None => regions.push(Shaded { verdict, strips }),
    }
}

/// The μ at which a boundary begins or ends inside of the plane.
pub(super) fn tops(plane: &GroundLoadPlane) -> Vec<f64> {
    let edges = |band: &LoadBand| band.cells.iter().filter_map(|cell| cell.upper).collect::<Vec<_>>();
    let mut found = Vec::new();
    for pair in plane.bands().windows(2) {
        let [left, right] = [edges(&pair[0]), edges(&pair[1])];
        let ends = left.iter().filter(|edge| !right.contains(edge));
        let begins = right.iter().filter(|edge| !left.contains(edge));
        found.extend(ends.chain(begins).filter_map(|edge| plane.at(*edge, pair[0].to)));
    }
    found
}
