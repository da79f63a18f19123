//! A body over all horizontal directions: where it rests, seen from above, in horizontal over vertical force.

use standfast::{Mode, Verdict};

use crate::Figure;
use crate::axes::{Axes, COLUMN, LEFT, NUMBER, Plot};
use crate::below::{Key, Words};
use crate::caption::SMALL;
use crate::labels::Board;
use crate::motion::SpectrumAxis;
use crate::palette::{BEHIND, FAINT, INK, MARK, PAPER, tint};
use crate::scene::{Path, Pen, Rect, Scene};
use crate::text::Text;

const TOP: f64 = 44.0;
/// White right of the plot, in which half of the last number stands.
const RIGHT: f64 = 22.0;
/// Width of the band outside the boundary that says what ends rest there.
const BAND: f64 = 9.0;
const BOUNDARY: Pen = Pen::solid(INK, 1.6);
const TIPPING: Pen = Pen { colour: INK, width: 1.1, dashes: "0.8 2.6" };
const SLIDING: Pen = Pen { colour: INK, width: 0.9, dashes: "4.5 3" };
const ORBIT: Pen = Pen::solid(BEHIND, 0.6);
const RAY: Pen = Pen { colour: FAINT, width: 0.5, dashes: "1.5 2.5" };

/// A place of a force: horizontal over vertical force to the right, and away from the viewer of the section.
type Place = (f64, f64);

/// A body over all horizontal directions.
#[derive(Debug, Clone, PartialEq)]
pub struct DirectionsChart<'a> {
    /// Title, in a line; not markup.
    pub title: &'a str,
    /// Caption, in sentences; not markup.
    pub caption: &'a str,
    /// Corners of the area of rest, in their order around it, each with what ends rest from it to the next.
    pub rest: &'a [(Place, Mode)],
    /// Corners of the area in which the body does not tip; none where it does not.
    pub tipping: &'a [Place],
    /// Friction of the base: the radius of the circle of sliding.
    pub friction: f64,
    /// Force of the permanent loads alone, from which the others rise.
    pub permanent: Place,
    /// Full load.
    pub full: Place,
    /// Place at which the load in the worst direction ends rest; `None` where all are alike.
    pub worst: Option<Place>,
    /// Way of a record.
    pub orbit: &'a [Place],
    /// End of rest along it.
    pub exit: Option<Place>,
}

/// Draws a body over all horizontal directions.
pub fn directions(chart: &DirectionsChart<'_>) -> Figure {
    let (scene, below) = drawn(Scene::default(), chart, (LEFT, COLUMN - RIGHT), f64::INFINITY);
    let words = Words::verbatim(chart.title, chart.caption);
    words.figure(scene, (LEFT, COLUMN - LEFT), below + 8.0, LEFT, DESCRIPTION)
}

/// The same for a screen, as large as there is room: in colours of the page and without the words below it.
pub fn directions_on_screen(chart: &DirectionsChart<'_>, size: (f64, f64)) -> Figure {
    /// What the names of the axes and the key take of the height.
    const AROUND: f64 = 140.0;
    let right = (size.0 - RIGHT).max(LEFT + 160.0);
    let (scene, below) = drawn(Scene::themed(), chart, (LEFT, right), (size.1 - AROUND).max(100.0));
    let size = ((right + RIGHT).ceil(), (below + 8.0).ceil());
    let (svg, labels) = scene.finish(size.0, size.1, chart.title, DESCRIPTION);
    Figure { svg, title: chart.title.to_owned(), caption: chart.caption.to_owned(), labels, size }
}

/// For readers who do not see it.
const DESCRIPTION: &str = "Horizontal over vertical force seen from above: the area in which the body rests, and what ends rest at its edge.";

/// The plot between two edges, no higher than this, and its key; the y below.
fn drawn(mut scene: Scene, chart: &DirectionsChart<'_>, edges: (f64, f64), highest: f64) -> (Scene, f64) {
    let reach = 1.16 * reach(chart);
    let axis = |name| SpectrumAxis { name, from: -reach, to: reach, logarithmic: false };
    let [across, up] = [
        axis("horizontal over vertical force, to the right $X_x/P$"),
        axis("away from the viewer of the section $X_z/P$"),
    ];
    // As high as it is wide.
    let widest = Plot::new([&across, &up], edges, TOP, 300.0).axes.area;
    let side = (widest.x1 - widest.x0).min(highest);
    let plot = Plot::new([&across, &up], (edges.0, edges.1 - (widest.x1 - widest.x0 - side)), TOP, side);
    let axes = plot.axes;
    let corners: Vec<Place> = chart.rest.iter().map(|((x, z), _)| axes.at(*x, *z)).collect();
    band(&mut scene, chart, &corners);
    scene.area(&corners, Verdict::REST);
    axes.grid(&mut scene, &plot.ticks);
    let compass = compass(&mut scene, &axes, reach);
    scene.stroke(&ring(&axes, chart.friction), SLIDING);
    closed(&mut scene, &chart.tipping.iter().map(|(x, z)| axes.held(*x, *z)).collect::<Vec<_>>(), TIPPING);
    let orbit: Vec<Place> = chart.orbit.iter().map(|(x, z)| axes.held(*x, *z)).collect();
    if !orbit.is_empty() {
        scene.stroke(&Path::through(&orbit), ORBIT);
    }
    closed(&mut scene, &corners, BOUNDARY);
    points(&mut scene, &axes, chart, compass);
    let below = plot.draw(&mut scene, 0.0);
    let below = key(&mut scene, chart, edges, below + 12.0);
    (scene, below)
}

/// Farthest of what is to be seen from the middle: all of the area of rest, the full load, and most of the rest.
fn reach(chart: &DirectionsChart<'_>) -> f64 {
    let far = |places: &mut dyn Iterator<Item = Place>| {
        places.map(|(x, z)| x.abs().max(z.abs())).filter(|far| far.is_finite()).fold(0.0, f64::max)
    };
    let rest = far(&mut chart.rest.iter().map(|(place, _)| *place));
    let full = far(&mut [chart.full].into_iter());
    let others = far(&mut chart.tipping.iter().chain(chart.orbit).copied()).max(chart.friction);
    let reach = rest.max(full.min(6.0 * rest)).max(others.min(2.0 * rest));
    if reach > 0.0 { reach } else { 1.0 }
}

fn closed(scene: &mut Scene, corners: &[Place], pen: Pen) {
    if corners.is_empty() {
        return;
    }
    let mut path = Path::through(corners);
    path.close();
    scene.stroke(&path, pen);
}

/// The circle of sliding, as far as the plot shows it.
fn ring(axes: &Axes, radius: f64) -> Path {
    let mut path = Path::default();
    let mut is_drawn = false;
    for step in 0..=720 {
        let (sin, cos) = (f64::from(step) * std::f64::consts::TAU / 720.0).sin_cos();
        let (x, z) = (radius * cos, radius * sin);
        let (at_x, at_y) = axes.at(x, z);
        match (axes.shows(x, z), is_drawn) {
            (true, true) => path.line_to(at_x, at_y),
            (true, false) => path.move_to(at_x, at_y),
            (false, _) => {}
        }
        is_drawn = axes.shows(x, z);
    }
    path
}

/// A band outside the area of rest in the tint of what ends rest there.
fn band(scene: &mut Scene, chart: &DirectionsChart<'_>, corners: &[Place]) {
    let count = corners.len();
    // A closed curve that runs clockwise on the page has its outside at the left.
    let area: f64 = (0..count)
        .map(|at| {
            let [(x0, y0), (x1, y1)] = [corners[at], corners[(at + 1) % count]];
            x0 * y1 - x1 * y0
        })
        .sum();
    for (at, (_, mode)) in chart.rest.iter().enumerate() {
        let [(x0, y0), (x1, y1)] = [corners[at], corners[(at + 1) % count]];
        let length = (x1 - x0).hypot(y1 - y0);
        // Across a corner, where one becomes the other, there is neither.
        let is_of_one = chart.rest[(at + 1) % count].1 == *mode;
        if length > 0.0 && is_of_one {
            let out = BAND * area.signum() / length;
            let (x, y) = (out * (y1 - y0), -out * (x1 - x0));
            let mut path = Path::through(&[(x0, y0), (x1, y1), (x1 + x, y1 + y), (x0 + x, y0 + y)]);
            path.close();
            scene.fill(&path, tint(*mode));
            // Neighbours on a bend show no gap.
            scene.stroke(
                &Path::through(&[(x0 + x / 2.0, y0 + y / 2.0), (x1 + x / 2.0, y1 + y / 2.0)]),
                Pen::solid(tint(*mode), BAND),
            );
        }
    }
}

/// Rays at each eighth of a turn with their angles; their boxes.
fn compass(scene: &mut Scene, axes: &Axes, reach: f64) -> Vec<Rect> {
    let mut boxes = Vec::new();
    for eighth in 0..8 {
        let degrees = 45 * eighth;
        // From the left over away from the viewer to the right.
        let [x, z] = standfast::footprint::towards(f64::from(degrees));
        let end = if eighth % 2 == 0 { reach } else { reach * std::f64::consts::SQRT_2 };
        let (from, to) = (axes.at(0.0, 0.0), axes.at(end * x, end * z));
        scene.line(from, to, RAY);
        let text = Text::new(&format!("${degrees}$°"), 11.0);
        let (width, height) = (text.width, text.height());
        let inset = |value: f64, half: f64| -value * (half + 5.0);
        let middle = (to.0 + inset(x, width / 2.0), to.1 - inset(z, height / 2.0));
        let rect = Rect::around(middle.0, middle.1, width, height);
        scene.fill(&Path::rectangle(&rect.grown(1.5)), PAPER);
        scene.text_in(&text, &rect, FAINT);
        boxes.push(rect);
    }
    boxes
}

/// The full load, where the worst direction ends rest, and where a record does, each with its name.
fn points(scene: &mut Scene, axes: &Axes, chart: &DirectionsChart<'_>, taken: Vec<Rect>) {
    let mut board = Board::new(*axes);
    taken.into_iter().for_each(|rect| board.reserve(rect));
    let permanent = axes.held(chart.permanent.0, chart.permanent.1);
    let mut named = Vec::new();
    if let Some(worst) = chart.worst {
        let at = axes.held(worst.0, worst.1);
        scene.line(permanent, at, Pen::solid(MARK, 0.9));
        named.push((at, "worst direction", PAPER));
    }
    named.push((axes.held(chart.full.0, chart.full.1), "full load", MARK));
    named.extend(chart.exit.map(|(x, z)| (axes.held(x, z), "first exit", INK)));
    for (at, ..) in &named {
        board.reserve(Rect::around(at.0, at.1, 9.0, 9.0));
    }
    for (at, name, fill) in named {
        let colour = if fill == INK { INK } else { MARK };
        scene.dot(at, 3.4, fill, Some(Pen::solid(colour, 1.3)));
        let text = Text::verbatim(name, NUMBER);
        if let Some(rect) = board.beside(at, &text, 7.0).or_else(|| board.over(at, &text, 7.0)) {
            scene.fill(&Path::rectangle(&rect.grown(1.5)), PAPER);
            scene.text_in(&text, &rect, colour);
            board.reserve(rect);
        }
    }
}

fn key(scene: &mut Scene, chart: &DirectionsChart<'_>, edges: (f64, f64), top: f64) -> f64 {
    let mut key = Key::new(edges, top);
    let has = |mode: Mode| chart.rest.iter().any(|(_, other)| *other == mode);
    let words = |text: &str| [Text::inline(text, SMALL)];
    key.patch(scene, |scene, patch| scene.area(&patch.corners(), Verdict::REST), &words("rests (RE)"));
    for (mode, text) in [(Mode::SlideLeft, "slides first (SL)"), (Mode::RockO, "tips first (RO)")] {
        if has(mode) {
            key.patch(
                scene,
                |scene, patch| scene.area(&patch.corners(), Verdict::Begins(mode)),
                &words(text),
            );
        }
    }
    let line = |pen: Pen| {
        move |scene: &mut Scene, patch: &Rect| {
            let y = (patch.y0 + patch.y1) / 2.0;
            scene.line((patch.x0 + 1.0, y), (patch.x1 - 1.0, y), pen);
        }
    };
    key.patch(scene, line(SLIDING), &words("circle of sliding, $μ$"));
    if !chart.tipping.is_empty() {
        key.patch(scene, line(TIPPING), &words("tipping"));
    }
    if !chart.orbit.is_empty() {
        key.patch(scene, line(ORBIT), &words("orbit of the record"));
    }
    key.below()
}
