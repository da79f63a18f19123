//! Load, slide and rotation over the time, one above the other, with the states behind.

use standfast::Mode;

use super::{Lengths, MotionPicture, band, finished, time_axis};
use crate::axes::{Axes, Axis, FRAME, LEFT, NUMBER, PAGE, Tick, named, widest};
use crate::below::modes_key_within;
use crate::caption::READABLE;
use crate::palette::{FAINT, INK, MARK, PUSH};
use crate::pinned::{PINNED_HISTORY, PinnedMotion};
use crate::scene::{Path, Pen, Rect, Scene};
use crate::text::Text;
use crate::{Figure, Picture};

/// White right of the plots, in which half of the last number stands.
const RIGHT: f64 = 22.0;
const HEIGHT: f64 = 104.0;
const STRIP: f64 = 17.0;
const GAP: f64 = 30.0;
const TOP: f64 = 14.0;
const LINES: [Pen; 2] = [Pen::solid(INK, 1.2), Pen { colour: PUSH, width: 1.2, dashes: "4 2.6" }];

/// One quantity over the time.
struct Panel<'a> {
    name: String,
    lines: Vec<&'a [(f64, f64)]>,
    /// The same of another motion, in dashes behind.
    pinned: Option<&'a [(f64, f64)]>,
    /// Values that are marked across the panel, where they come near.
    levels: Vec<f64>,
    /// The least range that is shown.
    least: f64,
    /// Words in its place, if it is zero throughout.
    flat: Option<&'static str>,
}

/// What is smaller is nothing, as a share of the body, and in radians.
const NOTHING: f64 = 1e-9;
/// Height of the line of a quantity that is zero.
const FLAT: f64 = 24.0;

impl Panel<'_> {
    fn axis(&self) -> Axis {
        let lines = self.lines.iter().chain(self.pinned.iter());
        let values = lines.flat_map(|line| line.iter().map(|point| point.1));
        let (mut low, mut high) = values
            .filter(|value| value.is_finite())
            .fold((0.0_f64, 0.0_f64), |(low, high), value| (low.min(value), high.max(value)));
        for level in &self.levels {
            if *level > 0.0 && high > 0.4 * level {
                high = high.max(*level);
            }
            if *level < 0.0 && low < 0.4 * level {
                low = low.min(*level);
            }
        }
        let short = (self.least - (high - low)).max(0.0) / 2.0;
        let (low, high) = (low - short, high + short);
        let margin = 0.06 * (high - low);
        Axis::linear(low - margin, high + margin)
    }
}

/// Where histories are drawn: the right edge of the plots and their height each.
struct Layout {
    right: f64,
    height: f64,
}

/// Histories of the loads, the slide and the rotation, under the band of states. What is zero throughout is a line of words.
pub fn motion_histories(picture: &MotionPicture<'_>) -> Figure {
    motion_histories_beside(picture, None)
}

/// The same with the histories of another motion in dashes behind, up to the end of this one, where its lengths are in the same unit.
pub fn motion_histories_beside(picture: &MotionPicture<'_>, pinned: Option<&PinnedMotion>) -> Figure {
    let pinned = pinned.filter(|pinned| pinned.is_like(picture));
    let caption = pinned.map(|pinned| format!("{} {}.", picture.caption, pinned.words()));
    let picture =
        &MotionPicture { caption: caption.as_deref().unwrap_or(picture.caption), ..picture.clone() };
    let mut scene = Scene::default();
    let layout = |_: usize, _: f64| Layout { right: PAGE - RIGHT, height: HEIGHT };
    let Laid { below, edges, description, .. } = laid(&mut scene, picture, pinned, layout);
    finished(scene, picture, "histories", edges, below + 12.0, RIGHT, &description)
}

/// The same for a screen, about as large as `size`: without words below the key of the states. Its plot is that of all histories, with the
/// time to the right.
pub fn motion_histories_on_screen(picture: &MotionPicture<'_>, size: (f64, f64)) -> Picture {
    motion_histories_on_screen_beside(picture, None, size)
}

/// The same with the histories of another motion in dashes behind, up to the end of this one, where its lengths are in the same unit.
pub fn motion_histories_on_screen_beside(
    picture: &MotionPicture<'_>,
    pinned: Option<&PinnedMotion>,
    (width, height): (f64, f64),
) -> Picture {
    /// The least height of a plot, and what the axis of the time and the key of the states take.
    const LEAST: f64 = 40.0;
    const UNDER: f64 = 84.0;
    let pinned = pinned.filter(|pinned| pinned.is_like(picture));
    let mut scene = Scene::themed();
    let layout = |plots: usize, taken: f64| Layout {
        right: width - RIGHT,
        height: ((height - taken - UNDER) / plots.max(1) as f64).max(LEAST),
    };
    let Laid { area, below, edges, mut description } = laid(&mut scene, picture, pinned, layout);
    description += &pinned.map_or(String::new(), |pinned| format!(" {}.", pinned.words()));
    let occurs = |mode: &Mode| picture.states.iter().any(|(_, state)| state == mode);
    let modes: Vec<Mode> = Mode::ALL.into_iter().filter(occurs).collect();
    let below = modes_key_within(&mut scene, &modes, edges, below + 8.0);
    let title = format!("{}: histories", picture.title);
    let size = (width, below + 8.0);
    let (svg, labels) = scene.finish(size.0, size.1, &title, &format!("{description} {}", picture.caption));
    let figure = Figure { svg, title, caption: String::new(), labels, size };
    let across = Axis::linear(picture.begin, picture.end);
    Picture { figure, plot: area, across, up: Axis::linear(0.0, 1.0) }
}

/// Histories that were drawn: all of their plots, the y below the axis of the time, their edges, and what they show, in words.
struct Laid {
    area: Rect,
    below: f64,
    edges: (f64, f64),
    description: String,
}

fn laid(
    scene: &mut Scene,
    picture: &MotionPicture<'_>,
    pinned: Option<&PinnedMotion>,
    layout: impl Fn(usize, f64) -> Layout,
) -> Laid {
    let size = picture.outline.b1.max(picture.outline.b2);
    let names: Vec<&str> = picture.loads.iter().map(|load| load.name).collect();
    let lengths = Lengths::of(picture, pinned);
    let scaled = |values: &[(f64, f64)], factor: f64| -> Vec<(f64, f64)> {
        values.iter().map(|(t, value)| (*t, value * factor)).collect()
    };
    let slide = scaled(picture.slide, lengths.factor);
    let theta = scaled(picture.theta, 1f64.to_degrees());
    let pinned_slide = pinned.map(|pinned| scaled(until(&pinned.slide, picture.end), lengths.factor));
    let pinned_theta = pinned.map(|pinned| scaled(until(&pinned.theta, picture.end), 1f64.to_degrees()));
    let is_flat = |values: &[(f64, f64)], least: f64| values.iter().all(|(_, value)| value.abs() <= least);
    let are_flat = |own: &[(f64, f64)], other: Option<&[(f64, f64)]>, least: f64| {
        is_flat(own, least) && other.is_none_or(|other| is_flat(other, least))
    };
    let panels = [
        Panel {
            name: names.join(", dashed "),
            lines: picture.loads.iter().map(|load| load.points).collect(),
            pinned: pinned.map(|pinned| until(&pinned.load, picture.end)),
            levels: Vec::new(),
            least: 1e-3,
            flat: None,
        },
        Panel {
            name: lengths.named("slide, to the right"),
            lines: vec![&slide],
            pinned: pinned_slide.as_deref(),
            levels: Vec::new(),
            least: 1e-6 * size * lengths.factor,
            flat: are_flat(&slide, pinned_slide.as_deref(), NOTHING * size * lengths.factor)
                .then_some("It does not slide."),
        },
        Panel {
            name: "rotation $θ$, counter-clockwise (°)".to_owned(),
            lines: vec![&theta],
            pinned: pinned_theta.as_deref(),
            levels: picture.balance.map(f64::to_degrees).to_vec(),
            least: 1e-4,
            flat: are_flat(&theta, pinned_theta.as_deref(), NOTHING.to_degrees())
                .then_some("It does not turn."),
        },
    ];
    let panels = &panels[usize::from(names.is_empty())..];
    let flat = panels.iter().filter(|panel| panel.flat.is_some()).count();
    let plots = panels.len() - flat;
    let Layout { right, height } =
        layout(plots, TOP + STRIP + GAP * plots as f64 + (FLAT + STRIP) * flat as f64);
    let axes: Vec<(Axis, Vec<Tick>)> = panels
        .iter()
        .map(|panel| {
            let up = panel.axis();
            (up, if panel.flat.is_some() { Vec::new() } else { up.ticks(height, true) })
        })
        .collect();
    let left = axes.iter().fold(20.0, |most, (_, ticks)| widest(ticks, most)) + LEFT + 9.0;
    let strip = Rect { x0: left, y0: TOP, x1: right, y1: TOP + STRIP };
    band(scene, picture, strip);
    ticks_of_events(scene, picture, strip);
    let mut top = TOP + STRIP;
    for (panel, (up, ticks)) in panels.iter().zip(&axes) {
        if let Some(words) = panel.flat {
            top += FLAT;
            scene.text(&Text::verbatim(words, NUMBER), left, top, INK);
            continue;
        }
        top += GAP;
        let area = Rect { x0: left, y0: top, x1: right, y1: top + height };
        let axes = Axes { area, across: Axis::linear(picture.begin, picture.end), up: *up };
        draw(scene, picture, panel, &axes, ticks);
        top += height;
    }
    // Ticks of the time stand on the last line: below words, or the strip alone, they need room.
    if panels.iter().all(|panel| panel.flat.is_some()) {
        top += STRIP;
    } else if panels.last().is_some_and(|panel| panel.flat.is_some()) {
        top += FLAT / 2.0;
    }
    let area = Rect { x0: left, y0: TOP, x1: right, y1: top };
    let below = time_axis(scene, picture, area);
    let edges = (LEFT, right);
    let quantities: Vec<String> = panels
        .iter()
        .map(|panel| {
            let words = panel.flat.map(|words| words.trim_end_matches('.').to_owned());
            words.unwrap_or_else(|| Text::inline(&panel.name, NUMBER).plain)
        })
        .collect();
    let description = format!(
        "Over the time, from above: the states, with a tick at each change; {}.",
        quantities.join("; ")
    );
    Laid { area, below, edges, description }
}

/// A tick below the strip at each moment at which the state changes; those that lie nearer than half a unit are one.
fn ticks_of_events(scene: &mut Scene, picture: &MotionPicture<'_>, strip: Rect) {
    const TICK: f64 = 5.0;
    let share = |t: f64| (t - picture.begin) / (picture.end - picture.begin);
    let shares = picture.states.iter().map(|(t, _)| share(*t)).filter(|share| *share > 0.0 && *share <= 1.0);
    let mut ticks = Path::default();
    let mut last = f64::NEG_INFINITY;
    for x in shares.map(|share| strip.x0 + share * (strip.x1 - strip.x0)) {
        if x >= last + 0.5 {
            ticks.move_to(x, strip.y1);
            ticks.line_to(x, strip.y1 + TICK);
            last = x;
        }
    }
    if !ticks.is_empty() {
        scene.stroke(&ticks, Pen::solid(INK, 1.0));
    }
}

/// The part of a history up to a moment.
fn until(points: &[(f64, f64)], end: f64) -> &[(f64, f64)] {
    &points[..points.partition_point(|(t, _)| *t <= end)]
}

fn draw(scene: &mut Scene, picture: &MotionPicture<'_>, panel: &Panel<'_>, axes: &Axes, ticks: &[Tick]) {
    let area = axes.area;
    axes.name_above(scene, &Text::inline(&named(&panel.name), NUMBER), LEFT, -5.0);
    axes.beside(scene, ticks);
    let across = |scene: &mut Scene, y: f64, pen: Pen| scene.line((area.x0, y), (area.x1, y), pen);
    across(scene, axes.y(0.0), Pen::solid(FAINT, 0.6));
    let Axis { from, to, .. } = axes.up;
    let shown: Vec<f64> = panel.levels.iter().copied().filter(|level| from < *level && *level < to).collect();
    for (i, level) in shown.into_iter().enumerate() {
        let y = axes.y(level);
        across(scene, y, Pen { colour: MARK, width: 0.9, dashes: "5 3.4" });
        // Both are one angle: the first is named.
        if i == 0 {
            let text = Text::verbatim("balance", READABLE);
            let place = if level > 0.0 { y + 11.0 } else { y - 4.0 };
            scene.text(&text, area.x1 - text.width - 5.0, place, MARK);
        }
    }
    let pens = panel.lines.iter().enumerate().map(|(i, line)| (*line, LINES[i.min(1)]));
    for (line, pen) in panel.pinned.map(|line| (line, PINNED_HISTORY)).into_iter().chain(pens) {
        let places = line.iter().filter(|(t, value)| *t <= picture.end && value.is_finite());
        let places: Vec<(f64, f64)> = places.map(|&(t, value)| axes.at(t, value)).collect();
        scene.stroke(&thinned(&places), pen);
    }
    axes.border(scene, FRAME);
}

/// A line through places from left to right, of which the page shows no more: in each half of a unit the first, the lowest, the highest
/// and the last.
fn thinned(places: &[(f64, f64)]) -> Path {
    let mut kept: Vec<(f64, f64)> = Vec::new();
    for column in places.chunk_by(|one, two| (2.0 * one.0).floor() == (2.0 * two.0).floor()) {
        if column.len() <= 4 {
            kept.extend(column);
            continue;
        }
        let index = |better: fn(f64, f64) -> bool| {
            (1..column.len()).fold(0, |best, i| if better(column[i].1, column[best].1) { i } else { best })
        };
        let mut at = [0, index(|one, two| one < two), index(|one, two| one > two), column.len() - 1];
        at.sort_unstable();
        for (i, &place) in at.iter().enumerate() {
            if i == 0 || at[i - 1] != place {
                kept.push(column[place]);
            }
        }
    }
    Path::through(&kept)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A thousand points in a unit leave the outermost of each half.
    #[test]
    fn the_extremes_of_a_crowd_stay() {
        let places: Vec<(f64, f64)> = (0..1000)
            .map(|i| {
                (
                    f64::from(i) / 1000.0,
                    if i == 321 {
                        -7.0
                    } else if i == 322 {
                        9.0
                    } else {
                        0.0
                    },
                )
            })
            .collect();
        let path = format!("{:?}", thinned(&places));
        assert!(path.contains("0.32 -7") && path.contains("0.32 9"), "{path}");
        assert!(path.matches('L').count() < 8, "{path}");
    }
}
