//! Areas of a view in which each mode holds: polygons of a function that names a mode at each place.

use standfast::Mode;
use standfast_figures::CloudPanel;

/// So many places along each axis are asked for a mode that is quick to tell.
pub(super) const FINE: usize = 120;
/// And for one that is not.
pub(super) const COARSE: usize = 48;
/// Number of times that the stretch between two places is halved: a boundary then stands to a fraction of a line's width.
const HALVED: usize = 9;

/// A mode with the stretch of a row on which it holds.
type Stretch = (Option<Mode>, f64, f64);
/// A mode with the edges of an area: left and right, from below.
type Strip = (Option<Mode>, Vec<(f64, f64)>, Vec<(f64, f64)>);

/// The areas of all modes in a view, of which so many places along each axis are asked; what is smaller than a step may be missed.
pub(super) fn areas(
    panel: &CloudPanel<'_>,
    steps: usize,
    mode_at: impl Fn(f64, f64) -> Option<Mode>,
) -> Vec<(Mode, Vec<(f64, f64)>)> {
    let along = |from: f64, to: f64, i: usize| from + (to - from) * i as f64 / steps as f64;
    let row = |y: f64| -> Vec<Stretch> {
        let x = |i: usize| along(panel.across.from, panel.across.to, i);
        let mut stretches: Vec<Stretch> = vec![(mode_at(x(0), y), x(0), x(steps))];
        for i in 1..=steps {
            let (mode, right) = (mode_at(x(i), y), x(i));
            // What lies between two places that differ is found from the left, mode by mode.
            while let Some(last) = stretches.last_mut().filter(|last| last.0 != mode) {
                let of_left = last.0;
                let (mut low, mut high) = (last.1.max(x(i - 1)), right);
                for _ in 0..HALVED {
                    let middle = 0.5 * (low + high);
                    if mode_at(middle, y) == of_left { low = middle } else { high = middle }
                }
                last.2 = high;
                let next = if high < right { mode_at(high, y) } else { mode };
                let next = if next == of_left { mode } else { next };
                stretches.push((next, high, x(steps)));
                if high >= right {
                    break;
                }
            }
        }
        stretches
    };
    let modes = |row: &[Stretch]| row.iter().map(|stretch| stretch.0).collect::<Vec<_>>();
    let begin = |y: f64, row: &[Stretch]| -> Vec<Strip> {
        row.iter().map(|(mode, from, to)| (*mode, vec![(*from, y)], vec![(*to, y)])).collect()
    };
    let extend = |open: &mut Vec<Strip>, y: f64, row: &[Stretch]| {
        for ((_, left, right), (_, from, to)) in open.iter_mut().zip(row) {
            left.push((*from, y));
            right.push((*to, y));
        }
    };
    let mut done: Vec<Strip> = Vec::new();
    let mut last_y = panel.up.from;
    let mut last = row(last_y);
    let mut open = begin(last_y, &last);
    for j in 1..=steps {
        let y = along(panel.up.from, panel.up.to, j);
        let next = row(y);
        if modes(&next) != modes(&last) {
            // The row at which other modes stand beside each other.
            let (mut low, mut low_row, mut high, mut high_row) = (last_y, last, y, next.clone());
            for _ in 0..HALVED {
                let middle = 0.5 * (low + high);
                let row = row(middle);
                if modes(&row) == modes(&low_row) {
                    (low, low_row) = (middle, row);
                } else {
                    (high, high_row) = (middle, row);
                }
            }
            extend(&mut open, low, &low_row);
            extend(&mut open, high, &low_row);
            done.append(&mut open);
            open = begin(high, &high_row);
            // What else lies in the step has no room in a picture.
            if modes(&high_row) != modes(&next) {
                extend(&mut open, y, &high_row);
                done.append(&mut open);
                open = begin(y, &next);
            }
        }
        extend(&mut open, y, &next);
        (last_y, last) = (y, next);
    }
    done.append(&mut open);
    let polygons = done.into_iter().filter_map(|(mode, left, right)| {
        let corners: Vec<(f64, f64)> = left.into_iter().chain(right.into_iter().rev()).collect();
        Some((mode?, corners))
    });
    polygons.collect()
}

#[cfg(test)]
mod tests {
    use standfast_figures::SpectrumAxis;

    use super::*;

    /// A diamond on two half-planes, and a corner that is not a mode: areas are those of school, and nothing is painted twice.
    #[test]
    fn areas_are_those_of_the_regions() {
        let axis = |from, to| SpectrumAxis { name: "", from, to, logarithmic: false };
        let panel =
            CloudPanel { across: axis(-2.0, 3.0), up: axis(0.0, 4.0), areas: Vec::new(), points: Vec::new() };
        let mode = |x: f64, y: f64| match (x, y) {
            (x, y) if x.abs() + (y - 2.0).abs() < 1.0 => Some(Mode::RockO),
            (x, y) if x + y > 5.0 => None,
            (x, _) if x < 0.1234 => Some(Mode::Rest),
            _ => Some(Mode::SlideLeft),
        };
        let found = areas(&panel, FINE, mode);
        let area = |corners: &[(f64, f64)]| {
            let next = corners.iter().cycle().skip(1);
            0.5 * corners.iter().zip(next).map(|(a, b)| a.0 * b.1 - a.1 * b.0).sum::<f64>().abs()
        };
        let of = |mode: Mode| {
            found.iter().filter(|(other, _)| *other == mode).map(|(_, corners)| area(corners)).sum::<f64>()
        };
        // Of the diamond, what lies left of x: the half, and beyond it a trapezium.
        let x: f64 = 0.1234;
        let (diamond, left) = (2.0, 1.0 + 2.0 * x - x * x);
        for (name, found, exact) in [
            ("diamond", of(Mode::RockO), diamond),
            ("left", of(Mode::Rest), 2.1234 * 4.0 - left),
            ("right", of(Mode::SlideLeft), (3.0 - x) * 4.0 - (diamond - left) - 2.0),
        ] {
            assert!((found - exact).abs() < 2e-3, "{name}: {found}, not {exact}");
        }
    }
}
