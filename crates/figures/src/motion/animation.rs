//! The motion as a picture that moves, at the pace of the body: one second for each unit of time. It is an SVG with animations of its own, for
//! browsers; elsewhere it shows the body at the end.

use std::fmt::Write;

use standfast::Mode;

use super::{MotionPicture, MotionPose, band, extent, finished, polygon, positions::ground, time_axis};
use crate::Figure;
use crate::palette::{FAINT, INK, MARK, tint};
use crate::scene::{Path, Pen, Rect, Scene};

const WIDTH: f64 = 560.0;
const LEFT: f64 = 24.0;
const TALLEST: f64 = 300.0;
/// Time for which the end is shown before it begins again, s.
const PAUSE: f64 = 1.5;

/// The body as it moves, by its poses at moments that rise from 0; between them it is drawn on straight ways.
pub fn motion_animation(picture: &MotionPicture<'_>, poses: &[MotionPose]) -> Figure {
    let outline = &picture.outline;
    let standing = outline.standing();
    let all = extent(outline, poses.iter().chain([&standing]));
    let (across, up) = (all.x1 - all.x0, all.y1.max(outline.height));
    let scale = (WIDTH / (1.06 * across)).min(TALLEST / up);
    let base = 14.0 + scale * up;
    let middle = LEFT + WIDTH / 2.0 - scale * (all.x0 + all.x1) / 2.0;
    let place = |(x, y): (f64, f64)| (middle + scale * x, base - scale * y);
    let mut scene = Scene::default();
    scene.stroke(
        &polygon(&outline.corners(&standing).map(place)),
        Pen { colour: FAINT, width: 0.8, dashes: "3.2 2.6" },
    );
    ground(&mut scene, (LEFT, LEFT + WIDTH), base);
    let clock = Clock::new(picture.end);
    moving(&mut scene, picture, poses, scale, &place, &clock);
    let strip = Rect { x0: LEFT, y0: base + 22.0, x1: LEFT + WIDTH, y1: base + 39.0 };
    let below = time(&mut scene, picture, strip, &clock);
    let edges = (LEFT, LEFT + WIDTH);
    let description = "The motion, one second for each unit of time, relative to the base.";
    finished(scene, picture, "the motion", edges, below + 10.0, LEFT, description)
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
    scene.open(&format!("transform=\"translate({})\"", at(last)));
    scene.put(&animated("translate", &values(poses.iter().map(at)), &key_times, clock));
    scene.open(&format!("transform=\"rotate({})\"", turned(last)));
    scene.put(&animated("rotate", &values(poses.iter().map(turned)), &key_times, clock));
    let outline = &picture.outline;
    let upright = MotionPose { x: 0.0, y: 0.0, ..outline.standing() };
    let corners = outline.corners(&upright).map(|(x, y)| (scale * x, -scale * y));
    let mut states: Vec<(f64, Mode)> = Vec::new();
    for &(t, mode) in picture.states.iter().filter(|(t, _)| *t <= clock.end) {
        // States that are over before they can be seen are left out.
        match states.last_mut() {
            Some(last) if t - last.0 < 0.02 => *last = (last.0, mode),
            Some(last) if last.1 == mode => {}
            _ => states.push((t, mode)),
        }
    }
    let colours = values(states.iter().map(|(_, mode)| tint(*mode).to_owned()));
    let colour = states.last().map_or(tint(Mode::Rest), |(_, mode)| tint(*mode));
    scene.put(&format!("<g fill=\"{colour}\"><path d=\""));
    scene.put(&polygon(&corners).data());
    scene.put(&format!(
        "\"/><animate attributeName=\"fill\" calcMode=\"discrete\" values=\"{colours}\" keyTimes=\"{}\" {}/></g>\n",
        clock.key_times(states.iter().map(|(t, _)| *t)),
        clock.attributes()
    ));
    scene.stroke(&polygon(&corners), Pen::solid(INK, 1.3));
    scene.dot((0.0, 0.0), 2.6, INK, None);
    scene.close();
    scene.close();
}

fn animated(kind: &str, values: &str, key_times: &str, clock: &Clock) -> String {
    format!(
        "<animateTransform attributeName=\"transform\" type=\"{kind}\" values=\"{values}\" keyTimes=\"{key_times}\" {}/>\n",
        clock.attributes()
    )
}

/// The band of states with a mark that goes along it; returns the y below.
fn time(scene: &mut Scene, picture: &MotionPicture<'_>, strip: Rect, clock: &Clock) -> f64 {
    band(scene, picture, strip, true);
    scene.stroke(&Path::rectangle(&strip), Pen::solid(FAINT, 0.8));
    let below = time_axis(scene, picture, strip);
    let width = strip.x1 - strip.x0;
    let ways = format!("0 0;{width:.2} 0;{width:.2} 0");
    scene.open(&format!("transform=\"translate({width:.2} 0)\""));
    let key_times = format!("0;{:.6};1", clock.end / clock.duration);
    scene.put(&animated("translate", &ways, &key_times, clock));
    scene.line((strip.x0, strip.y0 - 4.0), (strip.x0, strip.y1 + 4.0), Pen::solid(MARK, 2.0));
    scene.close();
    below
}
