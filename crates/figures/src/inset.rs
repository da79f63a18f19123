//! The lens between A and B′, too thin to be seen at true scale: its height above AB, magnified.

use standfast::Diagram;
use standfast::Mode;

use crate::axes::{Axes, Axis};
use crate::labels::Board;
use crate::palette::{FAINT, INK, PAPER, symbol, tint};
use crate::plot::{clip_strips, hermite};
use crate::scene::{Path, Pen, Rect, Scene};
use crate::sheet::k_markup;
use crate::text::Text;
use standfast::initiation::PointName;

/// Height in pixels from which the lens needs no inset.
const THICK: f64 = 14.0;

/// Draws the inset where there is room: in the rock region, else in the sector of slide-rock about O′.
pub(crate) fn draw(scene: &mut Scene, board: &mut Board, diagram: &Diagram) {
    let chart = diagram.chart();
    let (mu_star, ab) = (chart.mu_star(), chart.upper_line());
    let (from, to) = (chart.k_a(), chart.k_b_prime());
    if from >= to {
        return;
    }
    let height = |k: f64| mu_star.at(k) - ab.at(k);
    let summit = (1..40).map(|i| height(from + (to - from) * f64::from(i) / 40.0)).fold(0.0, f64::max);
    let axes = board.axes;
    let in_main = axes.y(0.0) - axes.y(summit);
    if in_main >= THICK || to > axes.across.to {
        return;
    }
    let rooms = [Mode::RockO, Mode::SlideRockOPrimeLeft].map(|mode| {
        diagram.region(mode).map_or(Vec::new(), |region| clip_strips(&region.strips, &axes.view()))
    });
    let sizes = [(168.0, 112.0), (150.0, 96.0)].into_iter();
    let place = |size: (f64, f64)| rooms.iter().find_map(|pieces| board.inside(pieces, size.0, size.1));
    let Some(rect) = sizes.into_iter().find_map(place) else { return };
    board.reserve(rect);
    let Rect { x0, y0, x1, y1 } = rect;
    let mut border = Path::through(&[(x0, y0), (x1, y0), (x1, y1), (x0, y1)]);
    border.close();
    scene.fill(&border, PAPER);
    scene.stroke(&border, Pen::solid(FAINT, 0.7));

    let inner = Rect { x0: x0 + 16.0, y0: y0 + 34.0, x1: x1 - 16.0, y1: y1 - 21.0 };
    let tall = 0.86 * (inner.y1 - inner.y0);
    let area = Rect { x0: inner.x0 + 6.0, x1: inner.x1 - 8.0, y0: inner.y1 - tall, y1: inner.y1 };
    let magnified = Axes { area, across: Axis::linear(from, to), up: Axis::linear(0.0, summit) };
    let (x, y) = (|k: f64| magnified.x(k), |mu: f64| magnified.y(mu));
    let graph = |k: f64| (x(k), y(height(k)), magnified.tilt(mu_star.slope(k) - ab.slope(k)));
    let mut lens = Path::default();
    lens.move_to(x(from), inner.y1);
    hermite(&mut lens, &graph, from, to, 10);
    scene.stroke(&lens, Pen::solid(INK, 1.4));
    lens.close();
    scene.fill(&lens, tint(Mode::SlideRockOLeft));
    scene.stroke(&lens, Pen::solid(INK, 1.4));

    let axis = Pen::solid(INK, 0.8);
    scene.line((inner.x0, inner.y1), (inner.x1 + 4.0, inner.y1), axis);
    scene.arrowhead((inner.x1 + 8.0, inner.y1), (1.0, 0.0), INK);
    scene.line((inner.x0, inner.y1), (inner.x0, inner.y0 - 3.0), axis);
    scene.arrowhead((inner.x0, inner.y0 - 7.0), (0.0, -1.0), INK);

    let quantity = Text::new(r"$μ − (\frac{1}{γ} + k|k′|)$", 11.5);
    let factor = magnification(tall / in_main);
    let wide = Text::new(&format!("height × ${factor}$"), 11.5);
    let fits = quantity.width + wide.width + 26.0 < x1 - x0;
    let factor = if fits { wide } else { Text::new(&format!("× ${factor}$"), 11.5) };
    let line = y0 + 5.0 + quantity.ascent;
    scene.text(&quantity, x0 + 8.0, line, INK);
    scene.text(&factor, x1 - 8.0 - factor.width, line, INK);
    for (name, letter, k) in [(PointName::A, "$A$", from), (PointName::BPrime, "$B′$", to)] {
        scene.dot((x(k), inner.y1), 2.2, INK, None);
        let label = Text::new(&format!("{letter}, ${}$", k_markup(name, chart).0), 11.5);
        let left = (x(k) - label.width / 2.0).clamp(x0 + 5.0, x1 - 5.0 - label.width);
        scene.text(&label, left, inner.y1 + 5.0 + label.ascent, INK);
    }
    let curve = Text::new("$μ*$", 11.5);
    let knee = from + 0.78 * (to - from);
    scene.text(&curve, x(knee) + 5.0, y(height(knee)) - 1.0, INK);
    let name = Text::new(symbol(Mode::SlideRockOLeft), 12.5);
    scene.text_in(&name, &Rect::around(x((from + to) / 2.0), inner.y1 - 0.4 * tall, 0.0, 0.0), INK);
}

/// A factor in words of at most two figures.
fn magnification(factor: f64) -> String {
    let step = if factor < 10.0 { 1.0 } else { 10f64.powf(factor.log10().floor() - 1.0) };
    crate::number::digits((factor / step).round() * step)
}
