//! The path of a rising load in its plane: a line along the body's friction, with ticks at the load factors of changes.

use standfast::{Stage, Verdict};

use super::{Plan, drawable};
use crate::axes::{Axes, NUMBER};
use crate::canvas::Canvas;
use crate::caption::also;
use crate::labels::Lines;
use crate::number::distinct_digits;
use crate::palette::{MARK, PAPER, verdict_symbol};
use crate::scene::{Pen, Rect};
use crate::text::Text;

/// The way of a rising load: a line along the body's friction.
pub(super) struct LoadPath {
    stages: Vec<Stage>,
    up_to: f64,
    pub(super) friction: Option<f64>,
}

impl LoadPath {
    pub(super) fn of(given: &Plan<'_>, up_to: f64) -> LoadPath {
        let stages = Stage::up_to(given.stages, given.up_to);
        LoadPath { stages, up_to, friction: drawable(given.friction) }
    }

    /// The load factors at which stages change.
    fn changes(&self) -> impl Iterator<Item = (f64, &[Stage])> {
        self.stages.windows(2).map(|pair| (pair[0].to, pair))
    }

    /// A load factor among the ends of stages, in markup.
    fn number(&self, factor: f64) -> String {
        let ends = self.stages.iter().flat_map(|stage| [stage.from, stage.to]);
        let at = |other: &f64| (other - factor).abs();
        let mut others: Vec<f64> = ends.chain([1.0]).filter(|other| *other != factor).collect();
        standfast::order::by_number(&mut others, at);
        format!("${}$", distinct_digits(factor, &others[..others.len().min(4)]))
    }

    /// The line with ticks, the diamond, load factors and the names of stages.
    pub(super) fn draw(&self, canvas: &mut Canvas) {
        let Some(mu) = self.friction else { return };
        let axes = canvas.board.axes;
        let y = axes.y(mu);
        let x = |factor: f64| axes.x(factor.clamp(0.0, axes.across.to));
        let Rect { x0, x1, .. } = axes.area;
        canvas.scene.line((x0, y), (x1, y), Pen::solid(PAPER, 4.0));
        for stage in &self.stages {
            let dashes = if stage.modes.len() > 1 { "6 3" } else { "" };
            let pen = Pen { colour: MARK, width: 1.8, dashes };
            canvas.scene.line((x(stage.from), y), (x(stage.to), y), pen);
        }
        canvas.board.reserve(Rect { x0, y0: y - 2.0, x1, y1: y + 2.0 });
        for (at, pair) in self.changes() {
            let (at, reach) = (x(at), reach(&axes, at, pair));
            canvas.scene.line((at, y - reach), (at, y + reach), Pen::solid(PAPER, 3.6));
            canvas.scene.line((at, y - reach), (at, y + reach), Pen::solid(MARK, 1.6));
            canvas.board.reserve(Rect::around(at, y, 3.0, 2.0 * reach + 1.0));
        }
        if axes.shows(1.0, mu) {
            canvas.diamond(axes.at(1.0, mu));
        }
        self.numbers(canvas, y);
    }

    /// Load factors at the ticks: those of changes of mode first.
    fn numbers(&self, canvas: &mut Canvas, y: f64) {
        let axes = canvas.board.axes;
        let (lesser, greater): (Vec<_>, Vec<_>) =
            self.changes().partition(|(_, pair)| pair[0].verdict == pair[1].verdict);
        for (at, pair) in greater.into_iter().chain(lesser) {
            let tip = reach(&axes, at, pair) + 3.0;
            let text = Text::new(&self.number(at), NUMBER);
            let (x, size) = (axes.x(at), (text.width, text.height()));
            let ways = [0.0, 1.0, -1.0].into_iter().flat_map(|across| [-1.0, 1.0].map(|down| (across, down)));
            let places = ways.map(|(across, down)| {
                let centre = y + down * (tip + text.height() / 2.0);
                Rect::around(x + across * (4.0 + text.width / 2.0), centre, size.0, size.1)
            });
            let clear = places.clone().find(|rect| canvas.board.clear(rect, 1.8));
            if canvas.place(&text, clear, MARK) {
                continue;
            }
            // From either end of the tick.
            let tips = [-1.0, 1.0].map(|down| (x, y + down * tip));
            let joined = tips.into_iter().find_map(|tip| canvas.board.near(tip, 0.0, size, 8, Lines::Cross));
            if let Some((rect, leader)) = joined {
                canvas.leader(&leader);
                canvas.place(&text, Some(rect), MARK);
            }
        }
    }

    /// Symbols of modes along their stages, where there is room and no region is `named` by them.
    pub(super) fn names(&self, canvas: &mut Canvas, named: &[Verdict]) {
        let axes = canvas.board.axes;
        let Some(y) = self.friction.map(|mu| axes.y(mu)) else { return };
        for stage in &self.stages {
            let Some(verdict) = stage.verdict.filter(|verdict| !named.contains(verdict)) else { continue };
            let text = Text::new(verdict_symbol(verdict), NUMBER);
            let (from, to) = (axes.x(stage.from), axes.x(stage.to.min(axes.across.to)));
            let shares = [0.5, 0.4, 0.6, 0.3, 0.7].into_iter();
            let mut places =
                shares.flat_map(|share| [-1.0, 1.0].map(|down| (share, down))).map(|(share, down)| {
                    let centre = y + down * (7.0 + text.height() / 2.0);
                    Rect::around(from + share * (to - from), centre, text.width, text.height())
                });
            let fits =
                |rect: &Rect| rect.x0 > from + 3.0 && rect.x1 < to - 3.0 && canvas.board.clear(rect, 2.0);
            let place = places.find(fits);
            canvas.place(&text, place, MARK);
        }
    }

    /// The stages in words, and the mode under the full load.
    pub(super) fn caption(&self) -> String {
        let mode = |stage: &Stage| {
            format!("{}{}", stage.verdict.map_or("none", verdict_symbol), also(stage.others()))
        };
        let stages = self
            .stages
            .iter()
            .map(|stage| format!("{}–{} {}", self.number(stage.from), self.number(stage.to), mode(stage)));
        let mut caption = format!("Rising load: {}.", stages.collect::<Vec<_>>().join(", "));
        let full =
            self.stages.iter().filter(|stage| stage.from <= 1.0 && 1.0 <= stage.to).collect::<Vec<_>>();
        match full[..] {
            [stage] => caption.push_str(&format!(" Full load ($λ = 1$, diamond): {}.", mode(stage))),
            [before, after, ..] => caption.push_str(&format!(
                " Full load ($λ = 1$, diamond): on the boundary of {} and {}.",
                mode(before),
                mode(after)
            )),
            [] => caption.push_str(&format!(" Full load, $λ = 1$, lies beyond {}.", self.number(self.up_to))),
        }
        if self.stages.iter().any(|stage| stage.modes.len() > 1) {
            caption.push_str(" Dashed: several modes are consistent.");
        }
        caption
    }
}

/// How far a tick reaches to either side of the path. A change of the modes beside the one reported is a smaller event;
/// the diamond of the full load must not hide a tick.
fn reach(axes: &Axes, at: f64, pair: &[Stage]) -> f64 {
    const DIAMOND: f64 = 5.2;
    let reach = if pair[0].verdict == pair[1].verdict { 3.5 } else { 6.5 };
    let is_under = axes.across.to >= 1.0 && (axes.x(at) - axes.x(1.0)).abs() < DIAMOND + 2.0;
    if is_under { reach + DIAMOND } else { reach }
}
