//! The motion as a picture that moves, at the pace of the body: one second for each unit of time. It is an SVG with animations of its own, for
//! browsers; elsewhere it shows the body at the end.

use std::fmt::Write;

use standfast::{Mode, Verdict};

use super::{
    MotionPicture, MotionPose, band, enlarged, extent, finished, polygon, positions::ground, time_axis,
};
use crate::Figure;
use crate::caption::SMALL;
use crate::number::significant;
use crate::palette::{FAINT, INK, MARK};
use crate::scene::{Path, Pen, Rect, Scene};
use crate::text::Text;

const WIDTH: f64 = 560.0;
const LEFT: f64 = 24.0;
const TALLEST: f64 = 300.0;
/// Time for which the end is shown before it begins again, s.
const PAUSE: f64 = 1.5;

/// The body as it moves, by its poses at moments that rise from 0; between them it is drawn on straight ways. A reader who wants no
/// motion sees it at the end.
pub fn motion_animation(picture: &MotionPicture<'_>, poses: &[MotionPose]) -> Figure {
    let outline = &picture.outline;
    let (poses, told) = enlarged(picture, poses);
    let picture = &MotionPicture { caption: &told, ..picture.clone() };
    let standing = outline.standing();
    let all = extent(outline, poses.iter().chain([&standing]));
    let (across, up) = (all.x1 - all.x0, all.y1.max(outline.height));
    let scale = (WIDTH / (1.06 * across)).min(TALLEST / up);
    let base = 14.0 + scale * up;
    let middle = LEFT + WIDTH / 2.0 - scale * (all.x0 + all.x1) / 2.0;
    let place = |(x, y): (f64, f64)| (middle + scale * x, base - scale * y);
    let mut scene = Scene::default();
    scene.rule(
        "@media (prefers-reduced-motion:reduce){svg.standfast .sf-moving{display:none}\
         svg.standfast .sf-still{display:inline}}",
    );
    scene.stroke(
        &polygon(&outline.corners(&standing).map(place)),
        Pen { colour: FAINT, width: 0.8, dashes: "3.2 2.6" },
    );
    ground(&mut scene, (LEFT, LEFT + WIDTH), base);
    let clock = Clock::new(picture.end);
    moving(&mut scene, picture, &poses, scale, &place, &clock);
    let below =
        base + if picture.ground.is_empty() { 22.0 } else { shaking(&mut scene, picture, base, &clock) };
    let strip = Rect { x0: LEFT, y0: below, x1: LEFT + WIDTH, y1: below + 17.0 };
    let below = time(&mut scene, picture, strip, &clock);
    let edges = (LEFT, LEFT + WIDTH);
    let description = "The motion, one second for each unit of time, relative to the base.";
    finished(scene, picture, "the motion", edges, below + 10.0, LEFT, description)
}

/// The acceleration of the ground as an arrow under it, and its words; returns how much room they take.
fn shaking(scene: &mut Scene, picture: &MotionPicture<'_>, base: f64, clock: &Clock) -> f64 {
    const LONGEST: f64 = 60.0;
    let most = picture.ground.iter().map(|(_, a)| a.abs()).fold(0.0, f64::max);
    let (middle, level) = (LEFT + WIDTH / 2.0, base + 17.0);
    // Its share of the largest; an arrow of no length has no way.
    let share = |a: f64| if most > 0.0 && a != 0.0 { a / most } else { 1e-3 };
    scene.open("class=\"sf-moving\"");
    scene.open(&format!("transform=\"translate({middle:.2} {level:.2})\""));
    scene.open("transform=\"scale(0.001 1)\"");
    let ways = values(picture.ground.iter().map(|(_, a)| format!("{:.3} 1", share(*a))));
    let key_times = clock.key_times(picture.ground.iter().map(|(t, _)| *t));
    scene.put(&animated("scale", &ways, &key_times, clock));
    scene.arrow((0.0, 0.0), (LONGEST, 0.0), Pen::solid(MARK, 2.0));
    scene.close();
    scene.close();
    scene.close();
    let words = format!(
        "Seen from the base, which shakes: the arrow is its acceleration, ${}$ $g$ at most.",
        significant(most, 4)
    );
    scene.text(&Text::inline(&words, SMALL), LEFT, level + 20.0, INK);
    48.0
}

/// Clock that turns moments into shares of the time from one beginning to the next.
struct Clock {
    end: f64,
    duration: f64,
}

impl Clock {
    fn new(end: f64) -> Clock {
        Clock { end, duration: end + PAUSE }
    }

    /// Moments as key times, which begin at 0, rise, and end at 1 with the last value once more.
    fn key_times(&self, moments: impl Iterator<Item = f64>) -> String {
        let mut text = String::new();
        let mut last = 0.0;
        for (i, t) in moments.enumerate() {
            let share = if i == 0 { 0.0 } else { (t.min(self.end) / self.duration).max(last) };
            let _ = write!(text, "{share:.6};");
            last = share;
        }
        text + "1"
    }

    fn attributes(&self) -> String {
        format!("dur=\"{:.3}s\" repeatCount=\"indefinite\"", self.duration)
    }
}

fn values(each: impl Iterator<Item = String>) -> String {
    let mut all: Vec<String> = each.collect();
    all.extend(all.last().cloned());
    all.join(";")
}

fn moving(
    scene: &mut Scene,
    picture: &MotionPicture<'_>,
    poses: &[MotionPose],
    scale: f64,
    place: &dyn Fn((f64, f64)) -> (f64, f64),
    clock: &Clock,
) {
    let Some(last) = poses.last() else { return };
    let key_times = clock.key_times(poses.iter().map(|pose| pose.t));
    let at = |pose: &MotionPose| {
        let (x, y) = place((pose.x, pose.y));
        format!("{x:.2} {y:.2}")
    };
    // Counter-clockwise is up on paper, and y is down on the page.
    let turned = |pose: &MotionPose| format!("{:.3}", -pose.theta.to_degrees());
    let upright = MotionPose { x: 0.0, y: 0.0, ..picture.outline.standing() };
    let corners = picture.outline.corners(&upright).map(|(x, y)| (scale * x, -scale * y));
    for moves in [true, false] {
        scene.open(if moves { "class=\"sf-moving\"" } else { "class=\"sf-still\" display=\"none\"" });
        scene.open(&format!("transform=\"translate({})\"", at(last)));
        if moves {
            scene.put(&animated("translate", &values(poses.iter().map(at)), &key_times, clock));
        }
        scene.open(&format!("transform=\"rotate({})\"", turned(last)));
        if moves {
            scene.put(&animated("rotate", &values(poses.iter().map(turned)), &key_times, clock));
        }
        states(scene, picture, &corners, clock, moves);
        scene.stroke(&polygon(&corners), Pen::solid(INK, 1.3));
        scene.dot((0.0, 0.0), 2.6, INK, None);
        (0..3).for_each(|_| scene.close());
    }
}

/// The body in each of its states, one over the other, of which one is seen at a time.
fn states(
    scene: &mut Scene,
    picture: &MotionPicture<'_>,
    corners: &[(f64, f64)],
    clock: &Clock,
    moves: bool,
) {
    let mut states: Vec<(f64, Mode)> = Vec::new();
    for &(t, mode) in picture.states.iter().filter(|(t, _)| *t <= clock.end) {
        // States that are over before they can be seen are left out.
        match states.last_mut() {
            Some(last) if t - last.0 < 0.02 => *last = (last.0, mode),
            Some(last) if last.1 == mode => {}
            _ => states.push((t, mode)),
        }
    }
    let end = states.last().map_or(Mode::Rest, |(_, mode)| *mode);
    let key_times = clock.key_times(states.iter().map(|(t, _)| *t));
    let occurs = |mode: &Mode| *mode == end || (moves && states.iter().any(|(_, state)| state == mode));
    for mode in Mode::ALL.into_iter().filter(occurs) {
        let seen = |state: Mode| if state == mode { "1" } else { "0" };
        scene.open(&format!("opacity=\"{}\"", seen(end)));
        if moves && !states.is_empty() {
            scene.put(&format!(
                "<animate attributeName=\"opacity\" calcMode=\"discrete\" values=\"{}\" keyTimes=\"{key_times}\" {}/>\n",
                values(states.iter().map(|(_, state)| seen(*state).to_owned())),
                clock.attributes()
            ));
        }
        scene.area(corners, Verdict::Begins(mode));
        scene.close();
    }
}

fn animated(kind: &str, values: &str, key_times: &str, clock: &Clock) -> String {
    format!(
        "<animateTransform attributeName=\"transform\" type=\"{kind}\" values=\"{values}\" keyTimes=\"{key_times}\" {}/>\n",
        clock.attributes()
    )
}

/// The band of states with a mark that goes along it; returns the y below.
fn time(scene: &mut Scene, picture: &MotionPicture<'_>, strip: Rect, clock: &Clock) -> f64 {
    band(scene, picture, strip);
    scene.stroke(&Path::rectangle(&strip), Pen::solid(FAINT, 0.8));
    let below = time_axis(scene, picture, strip);
    let width = strip.x1 - strip.x0;
    let ways = format!("0 0;{width:.2} 0;{width:.2} 0");
    scene.open(&format!("class=\"sf-moving\" transform=\"translate({width:.2} 0)\""));
    let key_times = format!("0;{:.6};1", clock.end / clock.duration);
    scene.put(&animated("translate", &ways, &key_times, clock));
    scene.line((strip.x0, strip.y0 - 4.0), (strip.x0, strip.y1 + 4.0), Pen::solid(MARK, 2.0));
    scene.close();
    below
}
