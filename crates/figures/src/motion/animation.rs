//! The motion as a picture that moves, at the pace of the body: one second for each unit of time. It is an SVG with animations of its own, for
//! browsers; elsewhere it shows the body at the end.

use std::fmt::Write;

use standfast::{Mode, Verdict};

use super::{
    MotionPicture, MotionPose, band, enlarged, extent, finished, polygon, positions::ground, time_axis,
};
use crate::Figure;
use crate::axes::PAGE;
use crate::caption::{SIZE, SMALL};
use crate::number::significant;
use crate::palette::{FAINT, INK, MARK};
use crate::scene::{Path, Pen, Rect, Scene};
use crate::text::Text;

const LEFT: f64 = 24.0;
const WIDTH: f64 = PAGE - 2.0 * LEFT;
const TALLEST: f64 = 300.0;
/// Above the body: the clock.
const TOP: f64 = 34.0;
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
    let base = TOP + scale * up;
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
    let clock = Clock { begin: picture.begin, end: picture.end };
    moving(&mut scene, picture, &poses, scale, &place, &clock);
    digits(&mut scene, picture, &clock);
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
    begin: f64,
    end: f64,
}

impl Clock {
    fn duration(&self) -> f64 {
        self.end - self.begin + PAUSE
    }

    fn share(&self, t: f64) -> f64 {
        (t.min(self.end) - self.begin) / self.duration()
    }

    /// Moments as key times, which begin at 0, rise, and end at 1 with the last value once more.
    fn key_times(&self, moments: impl Iterator<Item = f64>) -> String {
        let mut text = String::new();
        let mut last = 0.0;
        for (i, t) in moments.enumerate() {
            let share = if i == 0 { 0.0 } else { self.share(t).max(last) };
            let _ = write!(text, "{share:.6};");
            last = share;
        }
        text + "1"
    }

    fn attributes(&self) -> String {
        format!("dur=\"{:.3}s\" repeatCount=\"indefinite\"", self.duration())
    }

    /// Step in which it is read: a tenth, or so many times as much that there are not too many.
    fn step(&self) -> f64 {
        const MOST: f64 = 400.0;
        let steps = [0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0];
        steps.into_iter().find(|step| (self.end - self.begin) / step <= MOST).unwrap_or(self.end - self.begin)
    }
}

/// The time in digits, above the body: each digit one of a column of ten, of which one is seen at a time.
fn digits(scene: &mut Scene, picture: &MotionPicture<'_>, clock: &Clock) {
    let step = clock.step();
    let decimals = usize::from(step < 1.0);
    let read = |t: f64| format!("{t:.decimals$}");
    // Every reading, the last one that of the end.
    let first = (clock.begin / step).ceil() as i64;
    let last = (clock.end / step + 1e-9).floor() as i64;
    let mut readings: Vec<(f64, String)> = vec![(clock.begin, read((clock.begin / step).floor() * step))];
    readings.extend((first..=last).map(|i| i as f64 * step).map(|t| (t, read(t))));
    readings.push((clock.end, read(clock.end)));
    let longest = readings.iter().map(|(_, text)| text.len()).max().unwrap_or(1);
    let unit = if picture.time_unit.is_empty() { String::new() } else { format!(" {}", picture.time_unit) };
    let (name, unit) = (Text::inline("$t =$ ", SIZE), Text::verbatim(unit.trim(), SIZE));
    let wide = (0..10).map(|i| Text::verbatim(&i.to_string(), SIZE).width).fold(0.0, f64::max) + 0.6;
    let point = Text::verbatim(".", SIZE);
    let y = 22.0;
    let (mut x, from) = (LEFT + name.width + 5.0, LEFT);
    scene.text(&name, from, y, INK);
    for place in 0..longest {
        let at = |text: &str| {
            // From the right, so that units stand below units.
            let letter = (text.len() + place).checked_sub(longest).and_then(|i| text.chars().nth(i));
            letter.unwrap_or(' ')
        };
        if readings.iter().all(|(_, text)| at(text) == '.') {
            scene.letters(&point, x, y, INK);
            x += point.width + 1.2;
            continue;
        }
        let end = readings.last().map_or(' ', |(_, text)| at(text));
        for digit in '0'..='9' {
            let seen = |letter: char| if letter == digit { "1" } else { "0" };
            if readings.iter().all(|(_, text)| at(text) != digit) {
                continue;
            }
            let text = Text::verbatim(&digit.to_string(), SIZE);
            scene.open(&format!("class=\"sf-moving\" opacity=\"{}\"", seen(end)));
            let shown = readings.iter().map(|(t, text)| (*t, seen(at(text))));
            // Where it does not change nothing is said.
            let mut kept: Vec<(f64, &str)> = Vec::new();
            for (t, value) in shown {
                if kept.last().is_none_or(|last| last.1 != value) {
                    kept.push((t, value));
                }
            }
            if kept.len() > 1 {
                scene.put(&format!(
                    "<animate attributeName=\"opacity\" calcMode=\"discrete\" values=\"{}\" keyTimes=\"{}\" {}/>\n",
                    values(kept.iter().map(|(_, value)| (*value).to_owned())),
                    clock.key_times(kept.iter().map(|(t, _)| *t)),
                    clock.attributes()
                ));
            }
            scene.letters(&text, x + (wide - text.width) / 2.0, y, INK);
            scene.close();
            if digit == end {
                scene.open("class=\"sf-still\" display=\"none\"");
                scene.letters(&text, x + (wide - text.width) / 2.0, y, INK);
                scene.close();
            }
        }
        x += wide;
    }
    scene.text(&unit, x + 4.0, y, INK);
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

/// The states that are shown, the first from the beginning on.
fn shown(states: &[(f64, Mode)], clock: &Clock) -> Vec<(f64, Mode)> {
    let before = states.iter().rposition(|(t, _)| *t <= clock.begin).unwrap_or(0);
    let later = states.iter().skip(before).filter(|(t, _)| *t <= clock.end);
    later.map(|(t, mode)| (t.max(clock.begin), *mode)).collect()
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
    for (t, mode) in shown(picture.states, clock) {
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
    let key_times = format!("0;{:.6};1", clock.share(clock.end));
    scene.put(&animated("translate", &ways, &key_times, clock));
    scene.line((strip.x0, strip.y0 - 4.0), (strip.x0, strip.y1 + 4.0), Pen::solid(MARK, 2.0));
    scene.close();
    below
}
