//! Spectra of motions: a map of classes over two quantities, and lines over one.

use crate::Figure;
use crate::axes::{Axis, Look, NUMBER, Plot, Tick};
use crate::below::{Key, Words};
use crate::caption::SMALL;
use crate::number::significant;
use crate::palette::{FAINT, INK, MARK, OVERTURNS, PUSH, ROCKING};
use crate::scene::{Path, Pen, Rect, Scene};
use crate::text::Text;
use crate::texture;

const PLOT: (f64, f64) = (470.0, 310.0);
const TOP: f64 = 34.0;
const LINES: [Pen; 3] = [
    Pen::solid(INK, 1.4),
    Pen { colour: PUSH, width: 1.3, dashes: "6 3" },
    Pen { colour: MARK, width: 1.3, dashes: "2 2.4" },
];

/// A quantity along an axis of a spectrum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpectrumAxis<'a> {
    /// Name of the quantity, in markup, with its unit.
    pub name: &'a str,
    /// At the axis's beginning.
    pub from: f64,
    /// At its end, greater.
    pub to: f64,
    /// True if equal steps are equal factors; then both are above zero.
    pub logarithmic: bool,
}

impl SpectrumAxis<'_> {
    pub(crate) fn axis(&self) -> Axis {
        let SpectrumAxis { from, to, logarithmic, .. } = *self;
        Axis { from, to, logarithmic }
    }

    /// Numbers, round, all of them written.
    fn numbers(&self, most: f64) -> Vec<Tick> {
        let axis = self.axis();
        if !self.logarithmic || self.to < 3.0 * self.from {
            return axis.numbers(most);
        }
        let is_long = axis.last_decade() - axis.first_decade() > 3;
        let values = axis.decades(if is_long { &[1.0] } else { &[1.0, 2.0, 5.0] });
        let text = |value: f64| Text::new(&format!("${}$", significant(value, 3)), NUMBER);
        values.map(|(.., value)| (value, Some(text(value)))).collect()
    }
}

/// A map of classes over two quantities.
#[derive(Debug, Clone, PartialEq)]
pub struct SpectrumMap<'a> {
    /// Title, in a line; not markup.
    pub title: &'a str,
    /// Caption, in sentences; not markup.
    pub caption: &'a str,
    /// The quantity to the right.
    pub across: SpectrumAxis<'a>,
    /// The quantity upwards.
    pub up: SpectrumAxis<'a>,
    /// Outlines of the areas of each class but the first together with those after it, in the quantities of the axes; an outline in
    /// another is that of a hole.
    pub above: &'a [Vec<Vec<(f64, f64)>>],
    /// True for a class that occurs.
    pub occurs: [bool; 7],
    /// Words of each class, in markup: does not rock, four of rotations up to the angle of balance, beyond it, overturns.
    pub classes: [&'a str; 7],
}

/// The class whose area is striped, and the one whose edge is drawn the strongest.
const BACK: usize = 5;
const OVER: usize = 6;

/// Draws a map of classes.
pub fn spectrum_map(map: &SpectrumMap<'_>) -> Figure {
    let mut scene = Scene::default();
    let plot = plot(&map.across, &map.up);
    let axes = plot.axes;
    scene.fill(&Path::rectangle(&axes.area), ROCKING[0]);
    let areas: Vec<Vec<Vec<(f64, f64)>>> = map
        .above
        .iter()
        .map(|loops| loops.iter().map(|each| each.iter().map(|(x, y)| axes.held(*x, *y)).collect()).collect())
        .collect();
    // Each class lies on those before it, so that no paper is seen between two.
    for (class, loops) in areas.iter().enumerate().map(|(i, loops)| (i + 1, loops)) {
        scene.fill(&outlines(loops), ROCKING[class]);
        if class == BACK {
            texture::stripes(&mut scene, &loops.iter().map(Vec::as_slice).collect::<Vec<_>>());
        }
    }
    for (class, loops) in areas.iter().enumerate().map(|(i, loops)| (i + 1, loops)) {
        let pen = if class == OVER { Pen::solid(INK, 1.2) } else { Pen::solid(FAINT, 0.6) };
        scene.stroke(&within(&axes.area, loops), pen);
    }
    let mut key = key(&mut scene, &plot);
    for (class, words) in map.classes.iter().enumerate().filter(|(class, _)| map.occurs[*class]) {
        let paint = |scene: &mut Scene, patch: &Rect| {
            scene.fill(&Path::rectangle(patch), ROCKING[class]);
            if class == BACK {
                texture::stripes(scene, &[&patch.corners()]);
            }
        };
        key.patch(&mut scene, paint, &[Text::inline(words, SMALL)]);
    }
    finished(scene, &plot, &key, (map.title, map.caption))
}

/// Outlines as one path.
fn outlines(loops: &[Vec<(f64, f64)>]) -> Path {
    let mut path = Path::default();
    for each in loops {
        for (i, &(x, y)) in each.iter().enumerate() {
            if i == 0 { path.move_to(x, y) } else { path.line_to(x, y) }
        }
        path.close();
    }
    path
}

/// Outlines without what runs along the edges of the plot.
fn within(area: &Rect, loops: &[Vec<(f64, f64)>]) -> Path {
    let mut path = Path::default();
    for each in loops {
        let mut last = None;
        for (one, two) in each.iter().zip(each.iter().cycle().skip(1)) {
            let along = (one.0 == two.0 && (one.0 == area.x0 || one.0 == area.x1))
                || (one.1 == two.1 && (one.1 == area.y0 || one.1 == area.y1));
            if along {
                continue;
            }
            if last != Some(one) {
                path.move_to(one.0, one.1);
            }
            path.line_to(two.0, two.1);
            last = Some(two);
        }
    }
    path
}

/// Lines over a quantity.
#[derive(Debug, Clone, PartialEq)]
pub struct SpectrumLines<'a> {
    /// Title, in a line; not markup.
    pub title: &'a str,
    /// Caption, in sentences; not markup.
    pub caption: &'a str,
    /// The quantity to the right.
    pub across: SpectrumAxis<'a>,
    /// The quantity upwards.
    pub up: SpectrumAxis<'a>,
    /// At most three lines: their words in markup and their points. What is outside of the axes is left out.
    pub lines: &'a [(&'a str, Vec<(f64, f64)>)],
    /// Stretches of the quantity to the right that are shaded, with their words.
    pub shaded: (&'a [[f64; 2]], &'a str),
}

/// Draws lines over a quantity.
pub fn spectrum_lines(chart: &SpectrumLines<'_>) -> Figure {
    let mut scene = Scene::default();
    let plot = plot(&chart.across, &chart.up);
    let (axes, area) = (plot.axes, plot.axes.area);
    for [from, to] in chart.shaded.0 {
        let [x0, x1] = [from, to].map(|value| axes.x(axes.across.held(*value)));
        // A stretch too narrow to be seen is seen all the same.
        let x1 = x1.max(x0 + 0.8);
        scene.fill(&Path::rectangle(&Rect { x0, x1, ..area }), OVERTURNS);
    }
    for ((_, points), pen) in chart.lines.iter().zip(LINES) {
        let mut path = Path::default();
        let mut begun = false;
        for &(x, y) in points {
            let seen = axes.across.shows(x) && axes.up.shows(y);
            let place = axes.at(x, y);
            match (seen, begun) {
                (true, false) => path.move_to(place.0, place.1),
                (true, true) => path.line_to(place.0, place.1),
                (false, _) => {}
            }
            begun = seen;
        }
        scene.stroke(&path, pen);
    }
    let mut key = key(&mut scene, &plot);
    let mut swatch = |scene: &mut Scene, words: &str, draw: &dyn Fn(&mut Scene, f64, f64)| {
        let words = Text::inline(words, SMALL);
        let (x, y) = key.entry(28.0 + words.width, 16.0);
        draw(scene, x, y);
        scene.text(&words, x + 28.0, y + 10.5, INK);
    };
    for ((words, _), pen) in chart.lines.iter().zip(LINES) {
        let line = |scene: &mut Scene, x: f64, y: f64| scene.line((x, y + 6.0), (x + 24.0, y + 6.0), pen);
        swatch(&mut scene, words, &line);
    }
    if !chart.shaded.0.is_empty() {
        let patch = |scene: &mut Scene, x: f64, y: f64| {
            scene.fill(&Path::rectangle(&Rect { x0: x, y0: y, x1: x + 24.0, y1: y + 12.0 }), OVERTURNS);
        };
        swatch(&mut scene, chart.shaded.1, &patch);
    }
    finished(scene, &plot, &key, (chart.title, chart.caption))
}

/// The plot on the page.
fn plot(across: &SpectrumAxis<'_>, up: &SpectrumAxis<'_>) -> Plot {
    Plot::new([across, up], [across.numbers(8.0), up.numbers(7.0)], (24.0, TOP), PLOT)
}

/// Draws the frame; gives the key below it.
fn key(scene: &mut Scene, plot: &Plot) -> Key {
    plot.draw(scene, Look::PLAIN, 35.0, (16.0, TOP - 12.0));
    let Rect { x1, y1, .. } = plot.axes.area;
    Key::new((16.0, x1 + 24.0), y1 + 52.0)
}

/// The figure with its words below the key.
fn finished(scene: Scene, plot: &Plot, key: &Key, (title, caption): (&str, &str)) -> Figure {
    let description = format!("{} {caption}", plot.description());
    Words::verbatim(title, caption).figure(scene, key.edges, key.y + 24.0, 12.0, &description)
}
