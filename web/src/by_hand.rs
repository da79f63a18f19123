//! Histories drawn by hand: the points of one are dragged, added and taken away, and written into the text of the case.

use serde::Serialize;
use standfast::history::History;
use standfast_cases::{CaseFile, Key};
use standfast_figures::{Course, Picture, course_on_screen};
use standfast_inputs::Value;
use standfast_inputs::key::{Id, Table};

use crate::drag::rounded;
use crate::histories;
use crate::page::Page;

/// A course as the page takes it.
#[derive(Serialize)]
struct CourseShown<'a> {
    svg: &'a str,
    corners: Vec<CornerShown>,
}

/// A point that can be dragged.
#[derive(Serialize)]
struct CornerShown {
    x: f64,
    y: f64,
    words: String,
}

/// More points than this are no drawing by hand.
const MOST: usize = 60;

/// The points of a history drawn by hand; `None` of another, and of one that has too many.
pub fn corners(file: &CaseFile, (table, index): (Table, usize)) -> Option<Vec<[f64; 2]>> {
    let list = |key| file.inputs().list(Id::of(table, index, key));
    let (times, values) = (list(Key::Times)?, list(Key::Values)?);
    let points: Vec<_> = times.iter().zip(values).map(|(t, value)| [*t, *value]).collect();
    (points.len() <= MOST).then_some(points)
}

/// The text with other points of a history drawn by hand; the other keys of it stay.
pub fn written(file: &CaseFile, of: (Table, usize), points: &[[f64; 2]]) -> Option<String> {
    let lists = histories::lists(points);
    let mut parts = vec!["shape = \"points\"".to_owned()];
    let [times, values] = [Key::Times, Key::Values].map(Key::name);
    parts.push(format!("{times} = {}", lists[0]));
    parts.push(format!("{values} = {}", lists[1]));
    for key in [Key::HistoryPeak, Key::HistoryStart] {
        parts.extend(histories::written(file, of, key).map(|said| format!("{} = {said}", key.name())));
    }
    file.with_history(of.0, of.1, &format!("{{ {} }}", parts.join(", ")))
}

impl Page {
    fn history_named(&self, key: &str) -> Option<(Table, usize)> {
        histories::all(self.settled()).into_iter().find(|(table, index)| table.path(*index) == key)
    }

    /// The course of a history, of a size, as JSON; empty of a record and of what does not go with time.
    pub fn course(&mut self, key: &str, size: (f64, f64)) -> String {
        let Some(of) = self.history_named(key) else { return String::new() };
        let file = self.file();
        let by_hand = corners(file, of);
        let Some(points) = by_hand.clone().or_else(|| histories::points(file, of)) else {
            return String::new();
        };
        let line: Vec<_> = points.iter().map(|[t, value]| (*t, *value)).collect();
        let time_unit = if file.inputs().has(Table::Block) { "" } else { "s" };
        let is_held = self.held.as_ref().is_some_and(|held| held.by_hand == Some(of));
        let before = self.drawn.courses.iter().find(|(other, _)| *other == of).map(|(_, picture)| picture);
        let axes = before.filter(|_| is_held).map(|picture| (picture.across, picture.up));
        let both_ways = of.0 == Table::BaseHorizontal;
        let course = Course { title: &of.0.path(of.1), points: &line, time_unit, both_ways, axes };
        let picture = course_on_screen(&course, size);
        let unit = if time_unit.is_empty() { "" } else { " s" };
        let corner = |(i, [t, value]): (usize, &[f64; 2])| {
            let (x, y) = picture.place(*t, *value);
            let words =
                format!("Point {} of {}: {} at {}{unit}", i + 1, points.len(), said(*value), said(*t));
            CornerShown { x, y, words }
        };
        let corners = by_hand.iter().flatten().enumerate().map(corner).collect();
        let json = serde_json::to_string(&CourseShown { svg: picture.figure.svg(), corners });
        self.drawn.courses.retain(|(other, _)| *other != of);
        self.drawn.courses.push((of, picture));
        json.unwrap_or_default()
    }

    /// A history by its name, with its drawing.
    fn course_drawn(&self, key: &str) -> Option<((Table, usize), Picture)> {
        let of = self.history_named(key)?;
        self.drawn.courses.iter().find(|(other, _)| *other == of).cloned()
    }

    /// Drags a point of a history drawn by hand to a place in its drawing.
    pub fn drag_corner(&mut self, key: &str, corner: usize, (x, y): (f64, f64)) {
        let Some((of, picture)) = self.course_drawn(key) else { return };
        let Some(mut points) = self.held.as_ref().and_then(|held| corners(&held.file, of)) else { return };
        if corner >= points.len() || !(x.is_finite() && y.is_finite()) {
            return;
        }
        let before = corner.checked_sub(1).map_or(0.0, |i| points[i][0]);
        let after = points.get(corner + 1).map_or(f64::INFINITY, |point| point[0]);
        let [t, value] = at(&picture, (x, y));
        points[corner] = [t.clamp(before, after), value];
        self.put_points(of, &points);
    }

    /// Adds a point at a place in the drawing of a history, as one step.
    pub fn add_corner(&mut self, key: &str, place: (f64, f64)) {
        self.change_points(key, |points, picture| {
            let point = at(picture, place);
            let i = points.iter().position(|other| other[0] > point[0]).unwrap_or(points.len());
            if points.len() < MOST && point.iter().all(|number| number.is_finite()) {
                points.insert(i, point);
            }
        });
    }

    /// Takes a point away, as one step.
    pub fn remove_corner(&mut self, key: &str, corner: usize) {
        self.change_points(key, |points, _| {
            if corner < points.len() {
                points.remove(corner);
            }
        });
    }

    /// Moves a point by shares of the drawing's width and height, as one step.
    pub fn nudge_corner(&mut self, key: &str, corner: usize, (right, up): (f64, f64)) {
        let Some((of, picture)) = self.course_drawn(key) else { return };
        let Some([t, value]) = corners(self.settled(), of).and_then(|all| all.get(corner).copied()) else {
            return;
        };
        let ((x, y), plot) = (picture.place(t, value), picture.plot);
        self.grab();
        self.drag_corner(key, corner, (x + right * (plot.x1 - plot.x0), y - up * (plot.y1 - plot.y0)));
        self.release();
    }

    fn change_points(&mut self, key: &str, change: impl FnOnce(&mut Vec<[f64; 2]>, &Picture)) {
        let Some((of, picture)) = self.course_drawn(key) else { return };
        self.grab();
        if let Some(mut points) = self.held.as_ref().and_then(|held| corners(&held.file, of)) {
            change(&mut points, &picture);
            self.put_points(of, &points);
        }
        self.release();
    }

    /// Varies the points of a history; what is no history leaves all as it was.
    fn put_points(&mut self, of: (Table, usize), points: &[[f64; 2]]) {
        if History::stepped(points).is_err() {
            return;
        }
        if let Some(held) = &mut self.held {
            held.by_hand = Some(of);
        }
        let list = |which: usize| Value::Numbers(points.iter().map(|point| point[which]).collect());
        self.vary(|inputs| {
            inputs.put(Id::of(of.0, of.1, Key::Times), list(0));
            inputs.put(Id::of(of.0, of.1, Key::Values), list(1));
        });
    }
}

/// Moment and share at a place in a drawing, to what a hand can place; not before zero, and on zero, the peak and its opposite where near.
fn at(picture: &Picture, (x, y): (f64, f64)) -> [f64; 2] {
    /// So near a hand means it, pixels.
    const NEAR: f64 = 5.0;
    let plot = picture.plot;
    let (t, value) = picture.values(x.clamp(plot.x0, plot.x1), y.clamp(plot.y0, plot.y1));
    let [each_t, each_value] = [
        (picture.across.to - picture.across.from) / (plot.x1 - plot.x0),
        (picture.up.to - picture.up.from) / (plot.y1 - plot.y0),
    ];
    let meant = [0.0, 1.0, -1.0].into_iter().find(|meant| (value - meant).abs() < NEAR * each_value);
    let t = if t.abs() < NEAR * each_t { 0.0 } else { rounded(t, each_t).max(0.0) };
    [t, meant.unwrap_or_else(|| rounded(value, each_value))]
}

fn said(number: f64) -> String {
    standfast_cases::layout::significant(number, 4).replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examples;

    const SIZE: (f64, f64) = (480.0, 180.0);

    /// The pulse of an example, made points.
    fn page() -> (Page, &'static str) {
        let mut page = Page::default();
        let example = examples::find("rack").unwrap();
        assert!(page.open(&example.file(), example.text));
        page.add_file("shake.csv", "t,a_m_s2\n0,0\n1,4\n2,0\n");
        page.shake_with("shake.csv").unwrap();
        let key = "motion.base.horizontal";
        page.set_history(key, "half-sine").unwrap();
        (page, key)
    }

    fn drawn(page: &mut Page, key: &str) -> serde_json::Value {
        serde_json::from_str(&page.course(key, SIZE)).unwrap()
    }

    /// Points begin as the shape before them: half a sine at equal steps, and a body that does the same but for the chords.
    #[test]
    fn points_begin_as_the_shape_before_them() {
        let (mut page, key) = page();
        let duration = 0.4;
        assert!(
            drawn(&mut page, key)["corners"].as_array().unwrap().is_empty(),
            "a shape has no points to drag"
        );
        page.set_history(key, "points").unwrap();
        let points = corners(page.settled(), (Table::BaseHorizontal, 0)).unwrap();
        assert_eq!(points.len(), 17, "{}", page.text());
        for (i, [t, value]) in points.iter().enumerate() {
            let angle = std::f64::consts::PI * i as f64 / 16.0;
            assert!(
                (t - duration * i as f64 / 16.0).abs() < 1e-4 && (value - angle.sin()).abs() < 1e-3,
                "{t} {value}"
            );
        }
        assert!(page.text().contains("peak = \"0.3 g\""), "{}", page.text());
        page.undo();
        assert!(page.text().contains("half-sine"));
    }

    /// A point comes where it is dragged, between its neighbours; only the line of the history changes; each is a step.
    #[test]
    fn a_point_is_dragged_added_and_taken_away() {
        let (mut page, key) = page();
        page.set_history(key, "triangle").unwrap();
        page.set_history(key, "points").unwrap();
        let of = (Table::BaseHorizontal, 0);
        let before = page.text().to_owned();
        let first = corners(page.settled(), of).unwrap();
        assert_eq!((first.len(), first[1][1]), (3, 1.0));
        drawn(&mut page, key);
        let picture = page.course_drawn(key).unwrap().1;
        let (x, y) = picture.place(first[1][0] * 0.5, -0.5);
        page.grab();
        page.drag_corner(key, 1, (x, y));
        assert_eq!(page.text(), before, "nothing is written while it is held");
        let axes = (picture.across, picture.up);
        drawn(&mut page, key);
        let held = page.course_drawn(key).unwrap().1;
        assert_eq!((held.across, held.up), axes, "axes stay while a point is held");
        page.release();
        let second = corners(page.settled(), of).unwrap();
        assert!((second[1][0] - first[1][0] * 0.5).abs() < 0.002 && (second[1][1] + 0.5).abs() < 0.01);
        let differ = before.lines().zip(page.text().lines()).filter(|(one, two)| one != two).count();
        assert_eq!(differ, 1, "{}", page.text());
        assert!(page.text().contains("peak = \"0.3 g\""));

        page.grab();
        page.drag_corner(key, 1, (1e9, y));
        page.drag_corner(key, 1, (f64::NAN, y));
        page.release();
        assert!(corners(page.settled(), of).unwrap()[1][0] <= first[2][0], "it does not pass its neighbour");
        page.undo();
        drawn(&mut page, key);
        page.add_corner(key, page.course_drawn(key).unwrap().1.place(first[2][0] * 0.9, 0.25));
        let third = corners(page.settled(), of).unwrap();
        assert_eq!(third.len(), 4);
        assert!((third[2][1] - 0.25).abs() < 0.01);
        page.remove_corner(key, 2);
        assert_eq!(corners(page.settled(), of).unwrap(), second);
        page.nudge_corner(key, 1, (0.0, 0.1));
        assert!(corners(page.settled(), of).unwrap()[1][1] > second[1][1]);
        page.undo();
        page.undo();
        page.undo();
        assert_eq!(corners(page.settled(), of).unwrap(), second);
        page.undo();
        assert_eq!(page.text(), before);
    }

    /// A history of one point is none: the last two stay.
    #[test]
    fn two_points_stay() {
        let (mut page, key) = page();
        page.set_history(key, "points").unwrap();
        for _ in 0..30 {
            drawn(&mut page, key);
            page.remove_corner(key, 0);
        }
        assert_eq!(corners(page.settled(), (Table::BaseHorizontal, 0)).unwrap().len(), 2);
    }
}
