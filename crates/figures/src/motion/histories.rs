//! Load, slide and rotation over the time, one above the other, with the states behind.

use super::{MotionPicture, band, finished, time_axis, with_unit};
use crate::Figure;
use crate::axes::{Axes, Axis, Look, NUMBER, Tick, widest};
use crate::palette::{FAINT, INK, MARK};
use crate::scene::{Path, Pen, Rect, Scene};
use crate::text::Text;

const WIDTH: f64 = 560.0;
const HEIGHT: f64 = 104.0;
const STRIP: f64 = 17.0;
const GAP: f64 = 30.0;
const TOP: f64 = 14.0;
const LINES: [Pen; 2] = [Pen::solid(INK, 1.2), Pen { colour: INK, width: 1.1, dashes: "4 2.6" }];

/// One quantity over the time.
struct Panel<'a> {
    name: String,
    lines: Vec<&'a [(f64, f64)]>,
    /// Values that are marked across the panel, where they come near.
    levels: Vec<(f64, &'static str)>,
    /// The least range that is shown.
    least: f64,
}

impl Panel<'_> {
    fn axis(&self) -> Axis {
        let values = self.lines.iter().flat_map(|line| line.iter().map(|point| point.1));
        let (mut low, mut high) = values
            .filter(|value| value.is_finite())
            .fold((0.0_f64, 0.0_f64), |(low, high), value| (low.min(value), high.max(value)));
        for (level, _) in &self.levels {
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

/// Histories of the loads, the slide and the rotation, with the band of states.
pub fn motion_histories(picture: &MotionPicture<'_>) -> Figure {
    let size = picture.outline.b1.max(picture.outline.b2);
    let names: Vec<&str> = picture.loads.iter().map(|load| load.name).collect();
    let panels = [
        Panel {
            name: names.join(", dashed "),
            lines: picture.loads.iter().map(|load| load.points).collect(),
            levels: Vec::new(),
            least: 1e-3,
        },
        Panel {
            name: with_unit("slide, to the right", picture.length_unit),
            lines: vec![picture.slide],
            levels: Vec::new(),
            least: 1e-3 * size,
        },
        Panel {
            name: "rotation $θ$ (rad)".to_owned(),
            lines: vec![picture.theta],
            levels: picture.balance.map(|level| (level, "balance")).to_vec(),
            least: 1e-3,
        },
    ];
    let panels = &panels[usize::from(names.is_empty())..];
    let axes: Vec<(Axis, Vec<Tick>)> = panels
        .iter()
        .map(|panel| {
            let up = panel.axis();
            (up, up.numbers(6.0))
        })
        .collect();
    let left = axes.iter().fold(24.0, |most, (_, ticks)| widest(ticks, most)) + 18.0;
    let mut scene = Scene::default();
    let strip = Rect { x0: left, y0: TOP, x1: left + WIDTH, y1: TOP + STRIP };
    band(&mut scene, picture, strip, true);
    let mut top = TOP + STRIP;
    for (panel, (up, ticks)) in panels.iter().zip(&axes) {
        top += GAP;
        let area = Rect { x0: left, y0: top, x1: left + WIDTH, y1: top + HEIGHT };
        let axes = Axes { area, across: Axis::linear(0.0, picture.end), up: *up };
        draw(&mut scene, picture, panel, &axes, ticks);
        top += HEIGHT;
    }
    let below = time_axis(&mut scene, picture, Rect { x0: left, y0: TOP, x1: left + WIDTH, y1: top });
    let edges = (16.0, left + WIDTH);
    let quantities: Vec<String> =
        panels.iter().map(|panel| Text::inline(&panel.name, NUMBER).plain).collect();
    let description = format!("Over the time, from above: the states; {}.", quantities.join("; "));
    finished(scene, picture, "histories", edges, below + 12.0, 22.0, &description)
}

fn draw(scene: &mut Scene, picture: &MotionPicture<'_>, panel: &Panel<'_>, axes: &Axes, ticks: &[Tick]) {
    let area = axes.area;
    band(scene, picture, area, false);
    scene.text(&Text::inline(&panel.name, NUMBER), area.x0, area.y0 - 6.0, INK);
    axes.beside(scene, ticks, Look::PLAIN);
    let across = |scene: &mut Scene, y: f64, pen: Pen| scene.line((area.x0, y), (area.x1, y), pen);
    across(scene, axes.y(0.0), Pen::solid(FAINT, 0.6));
    let Axis { from, to, .. } = axes.up;
    for &(level, name) in panel.levels.iter().filter(|(level, _)| from < *level && *level < to) {
        let y = axes.y(level);
        across(scene, y, Pen { colour: MARK, width: 0.9, dashes: "5 3.4" });
        let text = Text::verbatim(name, 11.0);
        let place = if level > 0.0 { y + 11.0 } else { y - 4.0 };
        scene.text(&text, area.x1 - text.width - 5.0, place, MARK);
    }
    for (i, line) in panel.lines.iter().enumerate() {
        let places = line.iter().filter(|(t, value)| *t <= picture.end && value.is_finite());
        let places: Vec<(f64, f64)> = places.map(|&(t, value)| axes.at(t, value)).collect();
        scene.stroke(&thinned(&places), LINES[i.min(1)]);
    }
    axes.border(scene, Pen::solid(FAINT, 0.8));
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
