//! Figures of a motion: histories under the band of its states, its positions side by side, and the motion itself as a
//! picture that moves.
//!
//! Motions are given by numbers, at as many moments as the caller finds fit; the figures leave out what is not seen.

mod animation;
mod course;
mod histories;
mod positions;
mod spectra;
mod stage;
mod strength;

use standfast::{Mode, Verdict};

use crate::Figure;
use crate::axes::{Axes, Axis, NUMBER};
use crate::below::{Words, modes_key};
use crate::caption::{LEAST, READABLE, SMALL};
use crate::palette::{INK, symbol, tint};
use crate::pinned::PinnedMotion;
use crate::scene::{Path, Rect, Scene};
use crate::text::Text;

pub use animation::motion_animation;
pub use course::{Course, course_on_screen};
pub use histories::{
    motion_histories, motion_histories_beside, motion_histories_on_screen, motion_histories_on_screen_beside,
};
pub use positions::motion_positions;
pub use spectra::{SpectrumAxis, SpectrumLines, SpectrumMap, spectrum_lines, spectrum_map};
pub use stage::{MotionStage, StageLines, motion_stage};
pub use strength::strength_strip;

/// A motion to be drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionPicture<'a> {
    /// Title, the moving body, in a line; not markup.
    pub title: &'a str,
    /// Caption, its response, in sentences; not markup.
    pub caption: &'a str,
    /// The body.
    pub outline: MotionOutline,
    /// The first moment that is shown.
    pub begin: f64,
    /// The last moment that is shown; after the first.
    pub end: f64,
    /// The unit of times: `s`, or nothing.
    pub time_unit: &'a str,
    /// The unit of lengths: `m`, or nothing.
    pub length_unit: &'a str,
    /// Beginning of each state, in order.
    pub states: &'a [(f64, Mode)],
    /// Loads, each over the time.
    pub loads: &'a [MotionLoad<'a>],
    /// Slide over the time.
    pub slide: &'a [(f64, f64)],
    /// θ over the time.
    pub theta: &'a [(f64, f64)],
    /// Acceleration of the base to the right over the time, in gravities; empty where it stands still.
    pub ground: &'a [(f64, f64)],
    /// θ of balance about O, and about O' (below zero).
    pub balance: [f64; 2],
}

/// A load over the time.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionLoad<'a> {
    /// Name of the load, in markup.
    pub name: &'a str,
    /// Its values; two at one moment where it jumps.
    pub points: &'a [(f64, f64)],
}

/// The rectangle that moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MotionOutline {
    /// From O to the centre of mass.
    pub b1: f64,
    /// From the centre of mass to O'.
    pub b2: f64,
    /// The centre of mass above the base.
    pub d: f64,
    /// The crest above the base.
    pub height: f64,
}

/// Pose of the body at a moment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MotionPose {
    /// The moment.
    pub t: f64,
    /// x of the centre of mass.
    pub x: f64,
    /// y of the centre of mass above the base.
    pub y: f64,
    /// θ, counter-clockwise.
    pub theta: f64,
    /// Displacement along the base of the corner that touches.
    pub slide: f64,
    /// The state.
    pub mode: Mode,
}

impl MotionOutline {
    /// The corners from O counter-clockwise at a pose.
    fn corners(&self, pose: &MotionPose) -> [(f64, f64); 4] {
        let (sin, cos) = pose.theta.sin_cos();
        let MotionOutline { b1, b2, d, height } = *self;
        [(-b1, -d), (b2, -d), (b2, height - d), (-b1, height - d)]
            .map(|(x, y)| (pose.x + x * cos - y * sin, pose.y + x * sin + y * cos))
    }

    /// Pose of the body standing where nothing has happened to it.
    fn standing(&self) -> MotionPose {
        MotionPose { t: 0.0, x: 0.0, y: self.d, theta: 0.0, slide: 0.0, mode: Mode::Rest }
    }
}

/// The least and the greatest x and y of bodies at poses.
fn extent<'a>(outline: &MotionOutline, poses: impl Iterator<Item = &'a MotionPose>) -> Rect {
    let mut all = Rect { x0: f64::INFINITY, y0: f64::INFINITY, x1: f64::NEG_INFINITY, y1: f64::NEG_INFINITY };
    for (x, y) in poses.flat_map(|pose| outline.corners(pose)) {
        (all.x0, all.x1) = (all.x0.min(x), all.x1.max(x));
        (all.y0, all.y1) = (all.y0.min(y), all.y1.max(y));
    }
    all
}

/// So many times as large are moves drawn, in a number and a word, if else they would not be seen.
fn enlargement(outline: &MotionOutline, poses: &[MotionPose]) -> Option<(f64, &'static str)> {
    const UNSEEN: f64 = 0.03;
    const FACTORS: [(f64, &str); 3] = [(10.0, "ten"), (100.0, "a hundred"), (1000.0, "a thousand")];
    let moved = |pose: &MotionPose| pose.slide.abs().max(pose.theta.abs() * outline.height);
    let most = poses.iter().map(moved).fold(0.0, f64::max) / (outline.b1 + outline.b2);
    let flies = poses.iter().any(|pose| pose.mode == Mode::Flight);
    let enough = FACTORS.into_iter().find(|(factor, _)| factor * most > UNSEEN);
    enough.filter(|_| !flies && most <= UNSEEN)
}

/// A pose so many times as far from where the body stood.
fn farther(outline: &MotionOutline, times: f64, pose: &MotionPose) -> MotionPose {
    if times == 1.0 {
        return *pose;
    }
    let MotionOutline { b1, b2, d, .. } = *outline;
    let (slide, theta) = (times * pose.slide, times * pose.theta);
    // About O it turns counter-clockwise, about O′ clockwise.
    let corner = if theta >= 0.0 { -b1 } else { b2 };
    let (sin, cos) = theta.sin_cos();
    let x = corner + slide - corner * cos - d * sin;
    MotionPose { x, y: d * cos - corner * sin, theta, ..*pose }
}

/// Poses as they are drawn: ten, a hundred or a thousand times farther from where the body stood, if else its moves would not be seen, which the caption then
/// says.
fn enlarged(picture: &MotionPicture<'_>, poses: &[MotionPose]) -> (Vec<MotionPose>, String) {
    let Some((times, words)) = enlargement(&picture.outline, poses) else {
        return (poses.to_vec(), picture.caption.to_owned());
    };
    (
        poses.iter().map(|pose| farther(&picture.outline, times, pose)).collect(),
        format!("{} Moves are drawn {words} times as large.", picture.caption),
    )
}

/// State that takes most of each of `count` equal parts of a time, as stretches (first part, part after last, state).
fn bands(states: &[(f64, Mode)], (begin, end): (f64, f64), count: usize) -> Vec<(usize, usize, Mode)> {
    let mut found: Vec<(usize, usize, Mode)> = Vec::new();
    let mut first = 0;
    for part in 0..count {
        let [from, to] = [part, part + 1].map(|i| begin + (end - begin) * i as f64 / count as f64);
        while states.get(first + 1).is_some_and(|next| next.0 <= from) {
            first += 1;
        }
        let mut shares: Vec<(Mode, f64)> = Vec::new();
        for (i, &(start, mode)) in states.iter().enumerate().skip(first) {
            if start >= to {
                break;
            }
            let stop = states.get(i + 1).map_or(f64::INFINITY, |next| next.0);
            let share = stop.min(to) - start.max(from);
            match shares.iter_mut().find(|(known, _)| *known == mode) {
                Some((_, sum)) => *sum += share,
                None => shares.push((mode, share)),
            }
        }
        let Some((mode, _)) = shares.into_iter().reduce(|one, two| if two.1 > one.1 { two } else { one })
        else {
            continue;
        };
        match found.last_mut() {
            Some((_, to, last)) if *last == mode && *to == part => *to = part + 1,
            _ => found.push((part, part + 1, mode)),
        }
    }
    found
}

/// The band of states between two heights, each in its colour and with its symbol where there is room.
fn band(scene: &mut Scene, picture: &MotionPicture<'_>, area: Rect) {
    let count = (2.0 * (area.x1 - area.x0)) as usize;
    let x = |part: usize| area.x0 + (area.x1 - area.x0) * part as f64 / count as f64;
    for (from, to, mode) in bands(picture.states, (picture.begin, picture.end), count) {
        let stretch = Rect { x0: x(from), x1: x(to), ..area };
        scene.area(&stretch.corners(), Verdict::Begins(mode));
        let room = stretch.x1 - stretch.x0 - 3.0;
        let sizes = if scene.is_themed() { [NUMBER, READABLE] } else { [SMALL, LEAST] };
        let texts = sizes.map(|size| Text::new(symbol(mode), size));
        if let Some(text) = texts.iter().find(|text| text.width <= room) {
            let behind =
                Rect::around(stretch.centre().0, stretch.centre().1, text.width + 2.0, text.height() + 1.0);
            scene.fill(&Path::rectangle(&behind), tint(mode));
            scene.text_in(text, &stretch, INK);
        }
    }
}

/// Through places on the page.
fn polygon(places: &[(f64, f64)]) -> Path {
    let mut path = Path::through(places);
    path.close();
    path
}

/// The time below: numbers and its name; returns the y below.
fn time_axis(scene: &mut Scene, picture: &MotionPicture<'_>, area: Rect) -> f64 {
    let axes = Axes::over(area, Axis::linear(picture.begin, picture.end));
    let [ticks, _] = axes.ticks();
    axes.below(scene, &ticks);
    axes.name_below(scene, &Text::new(&with_unit("Time, $t$", picture.time_unit), NUMBER)) + 4.0
}

/// The figure of a `kind`: from `top` on the key of the states that occur, title and caption, and so much of the page `beyond` the
/// right edge.
fn finished(
    mut scene: Scene,
    picture: &MotionPicture<'_>,
    kind: &str,
    edges: (f64, f64),
    top: f64,
    beyond: f64,
    description: &str,
) -> Figure {
    let occurs = |mode: &Mode| picture.states.iter().any(|(_, state)| state == mode);
    let modes: Vec<Mode> = Mode::ALL.into_iter().filter(occurs).collect();
    let below = modes_key(&mut scene, &modes, edges, top);
    let title = format!("{}: {kind}", picture.title);
    let description = format!("{description} {}", picture.caption);
    let words = Words { title, ..Words::verbatim(picture.title, picture.caption) };
    words.figure(scene, edges, below + 8.0, beyond, &description)
}

/// Unit in which the slide of a motion is told: millimetres where it is small.
struct Lengths {
    factor: f64,
    unit: &'static str,
}

impl Lengths {
    fn of(picture: &MotionPicture<'_>, pinned: Option<&PinnedMotion>) -> Lengths {
        let slides = picture.slide.iter().chain(pinned.into_iter().flat_map(|pinned| &pinned.slide));
        let farthest = slides.map(|(_, slide)| slide.abs()).filter(|slide| slide.is_finite());
        match picture.length_unit {
            "m" if farthest.fold(0.0, f64::max) < 1.0 => Lengths { factor: 1e3, unit: "mm" },
            "m" => Lengths { factor: 1.0, unit: "m" },
            _ => Lengths { factor: 1.0, unit: "lengths of the block" },
        }
    }

    fn named(&self, name: &str) -> String {
        with_unit(name, self.unit)
    }
}

/// A name with its unit in brackets, in markup.
fn with_unit(name: &str, unit: &str) -> String {
    if unit.is_empty() { name.to_owned() } else { format!("{name} ({unit})") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_of_the_time_has_the_state_that_takes_most_of_it() {
        let states = [(0.0, Mode::Rest), (2.2, Mode::SlideLeft), (2.3, Mode::RockO), (3.0, Mode::Rest)];
        assert_eq!(
            bands(&states, (0.0, 10.0), 10),
            [(0, 2, Mode::Rest), (2, 3, Mode::RockO), (3, 10, Mode::Rest)]
        );
        assert_eq!(bands(&[], (0.0, 1.0), 4), []);
        // From 2.1 on in halves: of the first one rocking takes most.
        assert_eq!(bands(&states, (2.1, 4.1), 4), [(0, 2, Mode::RockO), (2, 4, Mode::Rest)]);
    }

    /// Enlarged about its corner, the body keeps that corner on the base, ten times as far from where it stood.
    #[test]
    fn small_moves_are_enlarged_about_the_corner() {
        let outline = MotionOutline { b1: 1.0, b2: 2.0, d: 3.0, height: 5.0 };
        let picture = MotionPicture {
            title: "",
            caption: "It moves.",
            outline,
            begin: 0.0,
            end: 1.0,
            time_unit: "s",
            length_unit: "m",
            states: &[],
            loads: &[],
            slide: &[],
            theta: &[],
            ground: &[],
            balance: [0.3, -0.6],
        };
        for theta in [2e-3, -2e-3, 0.0] {
            let pose = MotionPose { theta, slide: 0.01, ..outline.standing() };
            let (drawn, caption) = enlarged(&picture, &[pose]);
            assert!(caption.ends_with("ten times as large."), "{caption}");
            let [o, toe, ..] = outline.corners(&drawn[0]);
            let (corner, from) = if theta >= 0.0 { (o, -1.0) } else { (toe, 2.0) };
            assert!((corner.0 - from - 0.1).abs() < 1e-12 && corner.1.abs() < 1e-12, "{corner:?}");
            assert_eq!(drawn[0].theta, 10.0 * theta);
        }
        // What is a hundred times as small is drawn a hundred times as large.
        let small = MotionPose { theta: 0.0, slide: 1e-3, ..outline.standing() };
        let (drawn, caption) = enlarged(&picture, &[small]);
        assert!(
            (drawn[0].x - 0.1).abs() < 1e-12 && caption.ends_with("a hundred times as large."),
            "{caption}"
        );
        let far = MotionPose { slide: 1.0, ..outline.standing() };
        assert_eq!(enlarged(&picture, &[far]), (vec![far], "It moves.".to_owned()));
    }

    #[test]
    fn a_body_that_turns_about_a_corner_keeps_it() {
        let outline = MotionOutline { b1: 1.0, b2: 2.0, d: 3.0, height: 5.0 };
        let angle: f64 = 0.3;
        let (sin, cos) = angle.sin_cos();
        // C about O at (−1, 0), counter-clockwise.
        let pose =
            MotionPose { x: -1.0 + cos - 3.0 * sin, y: sin + 3.0 * cos, theta: angle, ..outline.standing() };
        let [o, toe, ..] = outline.corners(&pose);
        assert!((o.0 + 1.0).abs() < 1e-15 && o.1.abs() < 1e-15, "{o:?}");
        assert!((toe.1 - 3.0 * sin).abs() < 1e-15, "{toe:?}");
    }
}
