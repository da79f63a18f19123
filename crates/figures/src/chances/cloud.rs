//! Draws as dots in the colours of their modes.

use standfast::{Mode, Verdict};

use super::finished;
use crate::Figure;
use crate::axes::{Axes, COLUMN, LEFT, PAGE, Plot};
use crate::below::{Key, modes_key};
use crate::caption::SMALL;
use crate::motion::SpectrumAxis;
use crate::palette::{FAINT, INK, symbol, texture, tint};
use crate::scene::{Path, Pen, Scene};
use crate::text::Text;
use crate::texture::Texture;

const TOP: f64 = 30.0;
const DOWN: f64 = 280.0;
/// White right of a plot, in which half of the last number stands.
const RIGHT: f64 = 22.0;

/// One view of the draws.
#[derive(Debug, Clone, PartialEq)]
pub struct CloudPanel<'a> {
    /// The quantity to the right.
    pub across: SpectrumAxis<'a>,
    /// The quantity upwards.
    pub up: SpectrumAxis<'a>,
    /// Areas of the modes, behind the draws: polygons in the quantities of the axes.
    pub areas: Vec<(Mode, Vec<(f64, f64)>)>,
    /// Each draw's place, in the order of the modes.
    pub points: Vec<(f64, f64)>,
}

/// Draws in one view or more.
#[derive(Debug, Clone, PartialEq)]
pub struct ChanceCloud<'a> {
    /// Title, in a line; not markup.
    pub title: &'a str,
    /// Caption, in sentences; not markup.
    pub caption: &'a str,
    /// The views, side by side.
    pub panels: &'a [CloudPanel<'a>],
    /// The mode of each draw; none of what is not a mode, which is drawn as a hollow dot.
    pub modes: &'a [Option<Mode>],
}

/// Draws a cloud of draws; the rarest mode lies on top.
pub fn chance_cloud(chart: &ChanceCloud<'_>) -> Figure {
    let mut scene = Scene::default();
    let mut order: Vec<(usize, Option<Mode>)> = Vec::new();
    for mode in Mode::ALL.into_iter().map(Some).chain([None]) {
        let count = chart.modes.iter().filter(|other| **other == mode).count();
        if count > 0 {
            order.push((count, mode));
        }
    }
    order.sort_by_key(|(count, _)| std::cmp::Reverse(*count));
    let right = if chart.panels.len() > 1 { PAGE } else { COLUMN };
    let each = (right - LEFT) / chart.panels.len().max(1) as f64;
    let mut bottom = TOP;
    let mut names = Vec::new();
    for (i, panel) in chart.panels.iter().enumerate() {
        let left = LEFT + each * i as f64;
        let plot = Plot::new([&panel.across, &panel.up], (left, left + each - RIGHT), TOP, DOWN);
        let axes = plot.axes;
        paint(&mut scene, &axes, &panel.areas);
        axes.grid(&mut scene, &plot.ticks);
        for (_, mode) in &order {
            let of_mode = panel.points.iter().zip(chart.modes).filter(|(_, other)| *other == mode);
            let shown = of_mode.filter(|((x, y), _)| axes.across.shows(*x) && axes.up.shows(*y));
            let mut dots = Path::default();
            for ((x, y), _) in shown {
                let (x, y) = axes.at(*x, *y);
                dots.move_to(x, y);
                dots.line_to(x + 0.1, y);
            }
            // A tint on paper is seen by its rim.
            scene.stroke(&dots, Pen { colour: FAINT, width: 5.0, dashes: "0 9" });
            let inner = mode.map_or(crate::palette::PAPER, tint);
            scene.stroke(&dots, Pen { colour: inner, width: 3.4, dashes: "0 9" });
            if mode.is_some_and(|mode| texture(mode) != Texture::Plain) {
                scene.stroke(&dots, RING);
            }
        }
        bottom = plot.draw(&mut scene, 0.0);
        let [across, up] = plot.names();
        names.push(format!("{up} over {across}"));
    }
    let has_area =
        |mode: &Mode| chart.panels.iter().any(|panel| panel.areas.iter().any(|(other, _)| other == mode));
    let modes: Vec<Mode> =
        Mode::ALL.into_iter().filter(|m| order.iter().any(|(_, o)| *o == Some(*m)) || has_area(m)).collect();
    let below = modes_key(&mut scene, &modes, (LEFT, right - LEFT), bottom + 12.0);
    let below = rings_key(&mut scene, &order, (LEFT, right - LEFT), below);
    let description = format!("Draws as dots: {}.", names.join("; "));
    finished(scene, (chart.title, chart.caption), (right, below + 8.0), &description)
}

/// Heart of the dots of a mode that shares its tint with its mirror image.
const RING: Pen = Pen { colour: INK, width: 1.3, dashes: "0 9" };

/// What rings are, if there are any; returns the y below.
fn rings_key(scene: &mut Scene, order: &[(usize, Option<Mode>)], edges: (f64, f64), top: f64) -> f64 {
    let ringed = order.iter().filter_map(|(_, mode)| *mode).filter(|mode| texture(*mode) != Texture::Plain);
    let symbols: Vec<&str> = ringed.map(symbol).collect();
    if symbols.is_empty() {
        return top;
    }
    let text = Text::inline(&format!("dots with a heart: {}", symbols.join(", ")), SMALL);
    let mut key = Key::new(edges, top);
    let (x, y) = key.entry(text.width, 0.0);
    scene.text(&text, x, y + 10.5, INK);
    key.below()
}

/// Areas in the colours of their modes, and thin lines where they meet.
fn paint(scene: &mut Scene, axes: &Axes, areas: &[(Mode, Vec<(f64, f64)>)]) {
    for mode in Mode::ALL {
        for (_, corners) in areas.iter().filter(|(other, _)| *other == mode) {
            let places: Vec<_> = corners.iter().map(|(x, y)| axes.held(*x, *y)).collect();
            let mut path = Path::through(&places);
            path.close();
            // Neighbours of one colour show no seam.
            scene.stroke(&path, Pen::solid(tint(mode), 0.6));
            scene.area(&places, Verdict::Begins(mode));
        }
    }
}
