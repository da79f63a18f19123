//! Load, slide and rotation over the time, one above the other, with the states behind.

use super::{MotionPicture, band, key, with_unit, words_below};
use crate::Figure;
use crate::margins::{self, NUMBER};
use crate::palette::{FAINT, INK, MARK};
use crate::scale::Scale;
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
    fn range(&self) -> (f64, f64) {
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
        (low - margin, high + margin)
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
    let scales: Vec<Scale> = panels
        .iter()
        .map(|panel| {
            let (low, high) = panel.range();
            Scale::new(low, high, 6.0)
        })
        .collect();
    let numbers =
        scales.iter().flat_map(|scale| scale.numbers().into_iter().map(|n| margins::number(scale, n).width));
    let left = numbers.fold(24.0, f64::max) + 18.0;
    let mut scene = Scene::default();
    let strip = Rect { x0: left, y0: TOP, x1: left + WIDTH, y1: TOP + STRIP };
    band(&mut scene, picture, strip, true);
    let mut top = TOP + STRIP;
    for (panel, scale) in panels.iter().zip(&scales) {
        top += GAP;
        let area = Rect { x0: left, y0: top, x1: left + WIDTH, y1: top + HEIGHT };
        draw(&mut scene, picture, panel, scale, area);
        top += HEIGHT;
    }
    let below = time_axis(&mut scene, picture, Rect { x0: left, y0: TOP, x1: left + WIDTH, y1: top });
    let edges = (16.0, left + WIDTH);
    let below = key(&mut scene, picture, edges, below + 12.0);
    let below = words_below(&mut scene, picture, edges, below + 8.0);
    let (width, height) = (left + WIDTH + 22.0, below + 10.0);
    let quantities: Vec<String> =
        panels.iter().map(|panel| Text::inline(&panel.name, NUMBER).plain).collect();
    let description =
        format!("Over the time, from above: the states; {}. {}", quantities.join("; "), picture.caption);
    let title = format!("{}: histories", picture.title);
    let (svg, labels) = scene.finish(width, height, &title, &description);
    let size = (width.ceil(), height.ceil());
    Figure { svg, title, caption: picture.caption.to_owned(), labels, size }
}

fn draw(scene: &mut Scene, picture: &MotionPicture<'_>, panel: &Panel<'_>, scale: &Scale, area: Rect) {
    let (low, high) = panel.range();
    let x = |t: f64| area.x0 + t / picture.end * (area.x1 - area.x0);
    let y = |value: f64| area.y1 - (value - low) / (high - low) * (area.y1 - area.y0);
    band(scene, picture, area, false);
    scene.text(&Text::inline(&panel.name, NUMBER), area.x0, area.y0 - 6.0, INK);
    for value in scale.numbers() {
        let (number, y) = (margins::number(scale, value), y(value));
        scene.line((area.x0 - 4.0, y), (area.x0, y), Pen::solid(INK, 0.9));
        scene.text(&number, area.x0 - 7.0 - number.width, y + 4.0, INK);
    }
    scene.line((area.x0, y(0.0)), (area.x1, y(0.0)), Pen::solid(FAINT, 0.6));
    for &(level, name) in panel.levels.iter().filter(|(level, _)| low < *level && *level < high) {
        scene.line(
            (area.x0, y(level)),
            (area.x1, y(level)),
            Pen { colour: MARK, width: 0.9, dashes: "5 3.4" },
        );
        let text = Text::verbatim(name, 11.0);
        let place = if level > 0.0 { y(level) + 11.0 } else { y(level) - 4.0 };
        scene.text(&text, area.x1 - text.width - 5.0, place, MARK);
    }
    for (i, line) in panel.lines.iter().enumerate() {
        let places = line.iter().filter(|(t, value)| *t <= picture.end && value.is_finite());
        let places: Vec<(f64, f64)> = places.map(|&(t, value)| (x(t), y(value))).collect();
        scene.stroke(&thinned(&places), LINES[i.min(1)]);
    }
    scene.stroke(&Path::rectangle(&area), Pen::solid(FAINT, 0.8));
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

/// Numbers under the lowest panel, ticks under all; returns the y below.
fn time_axis(scene: &mut Scene, picture: &MotionPicture<'_>, area: Rect) -> f64 {
    let x = |t: f64| area.x0 + t / picture.end * (area.x1 - area.x0);
    let scale = Scale::new(0.0, picture.end, 8.0);
    for t in scale.numbers() {
        let number = margins::number(&scale, t);
        scene.line((x(t), area.y1), (x(t), area.y1 + 4.0), Pen::solid(INK, 0.9));
        scene.text(&number, x(t) - number.width / 2.0, area.y1 + 17.0, INK);
    }
    let name = Text::new(&with_unit("time $t$", picture.time_unit), NUMBER);
    scene.text(&name, (area.x0 + area.x1 - name.width) / 2.0, area.y1 + 34.0, INK);
    area.y1 + 40.0
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
