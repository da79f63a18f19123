//! The plane of slenderness and elevation: which case of the report a body belongs to.

use std::ops::Range;

use standfast::initiation::{Chart, ChartCase};

use crate::Figure;
use crate::axes::{Axis, NUMBER};
use crate::number;
use crate::palette::{FAINT, INK, tint};
use crate::scene::{Path, Pen, Rect, Scene};
use crate::screen::Picture;
use crate::text::Text;

/// The slenderness shown, γ from squat to slender, and the elevation, k' from base to crest.
const ACROSS: Axis = Axis { from: 0.1, to: 10.0, logarithmic: true };
const UP: Axis = Axis::linear(-1.0, 1.0);
const NAME: f64 = 14.0;
const SMALL: f64 = 12.0;

/// The γ–k' plane for a screen, the case of `chart` tinted; `size` is that of the whole picture.
pub fn cases_on_screen(chart: &Chart, (width, height): (f64, f64)) -> Picture {
    let plot = Rect { x0: 38.0, y0: 12.0, x1: (width - 12.0).max(98.0), y1: (height - 36.0).max(72.0) };
    let title = "Cases of the report in the plane of slenderness γ and elevation k′".to_owned();
    let mut picture = Picture {
        figure: Figure {
            svg: String::new(),
            title,
            caption: String::new(),
            labels: Vec::new(),
            size: (width, height),
        },
        plot,
        across: ACROSS,
        up: UP,
    };
    let mut scene = Scene::themed();
    let shown = ChartCase::ALL.map(|case| (case, Band::of(case)));
    for (_, band) in shown.iter().filter(|(case, _)| *case == chart.case()) {
        scene.fill(&band.outline(&picture), tint(standfast::Mode::RockO));
    }
    for (_, band) in &shown {
        scene.stroke(&band.upper_edge(&picture), Pen::solid(INK, 1.2));
    }
    axes(&mut scene, &picture);
    for (case, band) in &shown {
        band.name(&mut scene, &picture, *case);
    }
    let description = format!(
        "Slenderness from 0.1 to 10 to the right, logarithmic; elevation of the force from −1, the base, to 1, the crest, \
         upwards. From the top: cases 2 and 3, 1b and 1a for a force above the centre of mass, Δ > 0 and Δ ≤ 0 below. \
         Shaded: {}, with {}.",
        chart.case().words().replace('\'', "′"),
        Text::inline(&number::body(chart), SMALL).plain
    );
    let (svg, labels) = scene.finish(width, height, &picture.figure.title, &description);
    picture.figure.svg = svg;
    picture.figure.labels = labels;
    picture
}

/// A case as the plot shows it: (γ, least k', greatest k') from left to right.
struct Band(Vec<(f64, f64, f64)>);

impl Band {
    fn of(case: ChartCase) -> Band {
        const STEPS: u32 = 120;
        let slice = |i: u32| {
            let gamma = ACROSS.value(f64::from(i) / f64::from(STEPS));
            let Range { start: least, end: greatest } = case.k_primes(gamma).ok()?;
            Some((gamma, least.clamp(UP.from, UP.to), greatest.clamp(UP.from, UP.to)))
        };
        Band((0..=STEPS).filter_map(slice).collect())
    }

    fn outline(&self, picture: &Picture) -> Path {
        let lower = self.0.iter().map(|&(gamma, least, _)| picture.place(gamma, least));
        let upper = self.0.iter().rev().map(|&(gamma, _, greatest)| picture.place(gamma, greatest));
        let mut path = Path::through(&lower.chain(upper).collect::<Vec<_>>());
        path.close();
        path
    }

    /// The edge to the next case, where it is in the plot.
    fn upper_edge(&self, picture: &Picture) -> Path {
        let inside = self.0.iter().filter(|(_, _, greatest)| UP.from < *greatest && *greatest < UP.to);
        Path::through(&inside.map(|&(gamma, _, greatest)| picture.place(gamma, greatest)).collect::<Vec<_>>())
    }

    /// Writes the name in the middle of the part that is nearly as thick as the thickest.
    fn name(&self, scene: &mut Scene, picture: &Picture, case: ChartCase) {
        let thick = |slice: &(f64, f64, f64)| slice.2 - slice.1;
        let most = self.0.iter().map(thick).fold(0.0, f64::max);
        let wide: Vec<_> = self.0.iter().filter(|slice| most > 0.0 && thick(slice) > 0.85 * most).collect();
        let Some((gamma, least, greatest)) = wide.get(wide.len() / 2) else { return };
        let (x, y) = picture.place(*gamma, (least + greatest) / 2.0);
        let name = case.name();
        // Numbers and their letters are names; the rest is mathematics.
        let is_name = name.starts_with(|first: char| first.is_ascii_digit());
        let text = if is_name { Text::verbatim(name, NAME) } else { Text::new(&format!("${name}$"), NAME) };
        let (from, to) = (picture.plot.x0 + text.width, picture.plot.x1 - text.width);
        if from <= to && greatest - least > 0.12 {
            let x = x.clamp(from, to);
            scene.text_in(&text, &Rect::around(x, y, text.width, text.height()), INK);
        }
    }
}

fn axes(scene: &mut Scene, picture: &Picture) {
    let (Rect { x0, x1, y1, .. }, axes) = (picture.plot, picture.axes());
    axes.border(scene, Pen::solid(FAINT, 0.8));
    for (gamma, shown) in [(0.1, "0.1"), (0.3, "0.3"), (1.0, "1"), (3.0, "3"), (10.0, "10")] {
        let x = axes.x(gamma);
        scene.line((x, y1), (x, y1 + 4.0), Pen::solid(INK, 0.9));
        let text = Text::new(shown, SMALL);
        scene.text(&text, (x - text.width / 2.0).min(x1 + 6.0 - text.width), y1 + 16.0, INK);
    }
    let number = |k_prime: f64| Text::new(&format!("${}$", number::digits(k_prime)), NUMBER);
    let ticks = [-1.0, -0.5, 0.0, 0.5, 1.0].map(|k_prime| (k_prime, Some(number(k_prime))));
    axes.beside(scene, &ticks);
    let name = Text::new("$γ$", 14.0);
    scene.text(&name, (axes.x(3.0) + axes.x(10.0)) / 2.0, y1 + 17.0, INK);
    let name = Text::new("$k′$", 14.0);
    scene.text(&name, x0 - 30.0, axes.y(0.75) + 4.0, INK);
}
