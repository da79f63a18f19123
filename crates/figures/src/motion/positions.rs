//! The body at some moments, side by side and to scale.

use standfast::Verdict;

use super::{Lengths, MotionOutline, MotionPicture, MotionPose, enlarged, extent, finished, polygon};
use crate::Figure;
use crate::axes::{LEFT, NUMBER, PAGE};
use crate::number::significant;
use crate::palette::{FAINT, INK, symbol};
use crate::scene::{Pen, Rect, Scene};
use crate::text::Text;

const WIDTH: f64 = PAGE - 2.0 * LEFT;
const TALLEST: f64 = 170.0;
const GHOST: Pen = Pen { colour: FAINT, width: 0.8, dashes: "3.2 2.6" };
/// A cell is no narrower: its words are below it.
const NARROW: f64 = 118.0;

/// The body at some moments in its colour, where it stood before dashed.
pub fn motion_positions(picture: &MotionPicture<'_>, poses: &[MotionPose]) -> Figure {
    let outline = &picture.outline;
    let (drawn, told) = enlarged(picture, poses);
    let picture = &MotionPicture { caption: &told, ..picture.clone() };
    let standing = outline.standing();
    let mut all = extent(outline, drawn.iter().chain([&standing]));
    // A body that came far is drawn where it is, and how far it came stands in words.
    let far = all.x1 - all.x0 > 5.0 * (outline.b1 + outline.b2 + outline.height);
    let centred = |pose: &MotionPose| MotionPose { x: 0.0, ..*pose };
    let shown: Vec<MotionPose> = drawn.iter().map(|pose| if far { centred(pose) } else { *pose }).collect();
    if far {
        all = extent(outline, shown.iter().chain([&standing]));
    }
    let across = all.x1 - all.x0;
    let up = all.y1.max(outline.height);
    // As many in a row as have room, each as large as that allows.
    let count = poses.len().clamp(1, 5);
    let cell = (WIDTH / count as f64).max(NARROW);
    let scale = ((cell - 22.0) / across).min(TALLEST / up);
    let per_row = ((WIDTH / cell).floor() as usize).max(1);
    let row_height = scale * up + 62.0;
    let mut scene = Scene::default();
    for (i, (pose, at)) in poses.iter().zip(&shown).enumerate() {
        let (column, row) = (i % per_row, i / per_row);
        let left = LEFT + cell * column as f64;
        let base = 14.0 + row_height * row as f64 + scale * up;
        let area = Rect { x0: left, y0: base - scale * up, x1: left + cell, y1: base };
        let middle = (area.x0 + area.x1) / 2.0 - scale * (all.x0 + all.x1) / 2.0;
        let place = |(x, y): (f64, f64)| (middle + scale * x, base - scale * y);
        body(&mut scene, outline, at, if far { None } else { Some(&standing) }, &place);
        ground(&mut scene, (area.x0 + 4.0, area.x1 - 4.0), base);
        for (line, words) in words_of(picture, pose).into_iter().enumerate() {
            let width = words.width;
            scene.text(&words, (area.x0 + area.x1 - width) / 2.0, base + 17.0 + 15.0 * line as f64, INK);
        }
    }
    let rows = poses.len().div_ceil(per_row);
    let below = 14.0 + row_height * rows as f64;
    let edges = (LEFT, LEFT + WIDTH);
    let description = format!(
        "The body to scale at {} moments, from left to right; dashed, where it stood before.",
        poses.len()
    );
    finished(scene, picture, "positions", edges, below + 4.0, LEFT, &description)
}

fn body(
    scene: &mut Scene,
    outline: &MotionOutline,
    pose: &MotionPose,
    standing: Option<&MotionPose>,
    place: &dyn Fn((f64, f64)) -> (f64, f64),
) {
    let of = |pose: &MotionPose| polygon(&outline.corners(pose).map(place));
    scene.area(&outline.corners(pose).map(place), Verdict::Begins(pose.mode));
    if let Some(standing) = standing {
        scene.stroke(&of(standing), GHOST);
    }
    scene.stroke(&of(pose), Pen::solid(INK, 1.3));
    scene.dot(place((pose.x, pose.y)), 2.2, INK, None);
}

/// The base, a line with strokes under it.
pub(super) fn ground(scene: &mut Scene, (from, to): (f64, f64), y: f64) {
    scene.line((from, y), (to, y), Pen::solid(INK, 1.1));
    let mut x = from + 5.0;
    while x < to {
        scene.line((x, y), (x - 4.5, y + 4.5), Pen::solid(FAINT, 0.7));
        x += 7.0;
    }
}

/// Words below a position: time, state; slide and rotation.
fn words_of(picture: &MotionPicture<'_>, pose: &MotionPose) -> Vec<Text> {
    let of = |unit: &str| if unit.is_empty() { String::new() } else { format!(" {unit}") };
    let number = |value: f64| significant(value, 3);
    // A slide of rounding errors is none.
    let size = picture.outline.b1.max(picture.outline.b2);
    let slide = if pose.slide.abs() > 1e-9 * size { pose.slide } else { 0.0 };
    let lengths = Lengths::of(picture, None);
    let unit = if picture.length_unit.is_empty() { String::new() } else { of(lengths.unit) };
    vec![
        Text::inline(
            &format!("$t = {}${}, {}", number(pose.t), of(picture.time_unit), symbol(pose.mode)),
            NUMBER,
        ),
        Text::inline(&format!("slide ${}${unit}", number(slide * lengths.factor)), 11.0),
        Text::inline(&format!("$θ = {}$°", number(pose.theta.to_degrees())), 11.0),
    ]
}
