//! How a load, or the base, goes with time: a line that a hand can change.

use crate::axes::{Axes, Axis, LEFT, NUMBER};
use crate::palette::{BEHIND, PUSH};
use crate::scene::{Path, Pen, Scene};
use crate::text::Text;
use crate::{Figure, Picture};

const TOP: f64 = 30.0;
const RIGHT: f64 = 20.0;
/// What stands below the plot: numbers and the name of the axis.
const BELOW: f64 = 46.0;
const LINE: Pen = Pen::solid(PUSH, 1.8);

/// The course of a history.
#[derive(Debug, Clone, PartialEq)]
pub struct Course<'a> {
    /// Title, of what it is, in a line; not markup.
    pub title: &'a str,
    /// The line, point by point: moment, and share of the peak.
    pub points: &'a [(f64, f64)],
    /// The unit of times: `s`, or nothing.
    pub time_unit: &'a str,
    /// True if it goes to both sides, as the shaking of a base does.
    pub both_ways: bool,
    /// The axes that it has while it is held; without them those that show all, with room to draw in.
    pub axes: Option<(Axis, Axis)>,
}

/// Draws a course for a screen, so wide and so high.
///
/// ```
/// use standfast_figures::{Course, course_on_screen};
///
/// let points = [(0.0, 0.0), (0.1, 1.0), (0.4, 0.0)];
/// let course = Course { title: "wave", points: &points, time_unit: "s", both_ways: false, axes: None };
/// let picture = course_on_screen(&course, (400.0, 160.0));
/// let (x, y) = picture.place(0.1, 1.0);
/// assert!(picture.plot.x0 < x && x < picture.plot.x1 && picture.plot.y0 < y);
/// ```
pub fn course_on_screen(course: &Course<'_>, (width, height): (f64, f64)) -> Picture {
    let (across, up) = course.axes.unwrap_or_else(|| course.room());
    let axes =
        Axes::beside_numbers([across, up], (LEFT, width - RIGHT), TOP, (height - TOP - BELOW).max(40.0));
    let mut scene = Scene::themed();
    let ticks = axes.ticks();
    axes.grid(&mut scene, &ticks);
    let (from, to) = (axes.at(across.from, 0.0), axes.at(across.to, 0.0));
    scene.line(from, to, Pen::solid(BEHIND, 1.0));
    let mut path = Path::default();
    for (i, &(t, value)) in course.points.iter().enumerate() {
        let (x, y) = axes.held(t, value);
        if i == 0 { path.move_to(x, y) } else { path.line_to(x, y) }
    }
    scene.stroke(&path, LINE);
    axes.framed(&mut scene, &ticks);
    axes.name_above(&mut scene, &Text::new("share of the peak", NUMBER), LEFT, 0.0);
    let unit = if course.time_unit.is_empty() { String::new() } else { format!(" ({})", course.time_unit) };
    let below = axes.name_below(&mut scene, &Text::new(&format!("time $t${unit}"), NUMBER));
    let size = (width, (below + 4.0).ceil());
    let description = format!("Share of the peak, upwards, over the time, to the right: {}.", course.title);
    let (svg, labels) = scene.finish(size.0, size.1, course.title, &description);
    let figure = Figure { svg, title: course.title.to_owned(), caption: String::new(), labels, size };
    Picture { figure, plot: axes.area, across, up }
}

impl Course<'_> {
    /// Axes that show all points, the peak and zero, with room around.
    fn room(&self) -> (Axis, Axis) {
        let last = self.points.iter().fold(0.0, |last: f64, point| last.max(point.0));
        let least = if self.both_ways { -1.0 } else { 0.0 };
        let (low, high) = self
            .points
            .iter()
            .filter(|point| point.1.is_finite())
            .fold((least, 1.0), |(low, high): (f64, f64), point| (low.min(point.1), high.max(point.1)));
        let margin = 0.15 * (high - low);
        let across = Axis::linear(0.0, if last > 0.0 { 1.25 * last } else { 1.0 });
        (across, Axis::linear(low - margin, high + margin))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn course<'a>(points: &'a [(f64, f64)], axes: Option<(Axis, Axis)>) -> Course<'a> {
        Course { title: "shaking of the base", points, time_unit: "s", both_ways: true, axes }
    }

    /// The line goes through its points, at the places that the picture says they have.
    #[test]
    fn the_line_goes_through_its_points() {
        let points = [(0.0, 0.0), (0.5, -1.5), (2.0, 0.25)];
        let picture = course_on_screen(&course(&points, None), (480.0, 200.0));
        for (t, value) in points {
            let (x, y) = picture.place(t, value);
            assert!(picture.plot.x0 <= x && x <= picture.plot.x1, "{t}");
            assert!(picture.plot.y0 < y && y < picture.plot.y1, "{value}");
            let (back, share) = picture.values(x, y);
            assert!((back - t).abs() < 1e-12 && (share - value).abs() < 1e-12);
            assert!(
                picture
                    .figure
                    .svg()
                    .contains(&format!("{x:.2}").trim_end_matches('0').trim_end_matches('.').to_owned())
            );
        }
        let held = (picture.across, picture.up);
        let wider = [(0.0, 0.0), (9.0, 4.0)];
        let again = course_on_screen(&course(&wider, Some(held)), (480.0, 200.0));
        assert_eq!((again.across, again.up), held);
    }
}
