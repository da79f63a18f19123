//! The plane of load factor and friction of any block, with the path of a rising load.
//!
//! Nothing is known of the boundaries but the strips of the regions: they are drawn where neighbours differ in verdict. So
//! there are no formulas here, and the axes have numbers. On a base that gives way the strips are those between points of its curves, and
//! the boundaries on rigid ground lie behind in grey.

mod ground;

use standfast::ground::load_plane::LoadEdge;
use standfast::region::{Curve, Region, Strip};
use standfast::{Stage, Verdict};

use crate::axes::{Axes, COLUMN, FRAME, LEFT, NUMBER};
use crate::below::{Words, verbatim};
use crate::canvas::Canvas;
use crate::caption::{SIZE, SMALL, also};
use crate::labels::Lines;
use crate::margins::{self, Tab};
use crate::number::{digits, distinct_digits};
use crate::outlines::Polyline;
use crate::palette::{BEHIND, INK, MARK, PAPER, verdict_symbol};
use crate::pinned::{self, PINNED, PinnedLoad, arcs_beside, verticals_beside, widened};
use crate::plot::{Arc, Fall, Piece, View, clip_strips, hatch, level};
use crate::scene::{Pen, Rect, Scene};
use crate::text::Text;
use crate::{Figure, LoadPlane, Picture, caption};

const HEIGHT: f64 = 310.0;
/// Above the plot: the name of the friction.
const TOP: f64 = 30.0;
/// Room right of the plot for the friction of the path.
const ROOM: f64 = 72.0;
const BOUNDARY: Pen = Pen::solid(INK, 1.3);
/// What counts as one load factor, as a share of the window: far below a pixel.
const SAME: f64 = 1e-6;

/// Lines of the plane on rigid ground, behind.
const RIGID: Pen = Pen { colour: BEHIND, width: 1.3, dashes: "1.5 3" };
/// The name of these lines in the picture.
const ON_RIGID: &str = "on rigid ground";
/// What is uncertain of the ground.
const UNCERTAIN: Pen = Pen::solid(MARK, 0.6);

/// What is drawn.
pub(crate) struct Plan<'a> {
    pub regions: Vec<Shaded>,
    /// The μ of corners of regions.
    pub corners: Vec<f64>,
    /// The regions on rigid ground, to be drawn behind.
    rigid: Vec<Shaded>,
    /// Where a body rests on ground somewhat weaker, or stronger, and not on the other.
    uncertain: Vec<Strip>,
    up_to: f64,
    pub friction: f64,
    stages: &'a [Stage],
    title: &'a str,
    /// The boundaries of another case, in dashes, in shares of this one's load; and its full load.
    pinned: Option<(Vec<Shaded>, PinnedLoad<'a>)>,
}

/// Where a verdict holds.
pub(crate) struct Shaded {
    pub verdict: Verdict,
    pub strips: Vec<Strip>,
}

/// A region as the window shows it.
struct Area {
    verdict: Verdict,
    pieces: Vec<Piece>,
}

/// Regions of modes.
fn shaded(regions: &[Region]) -> Vec<Shaded> {
    let begins = |region: &Region| Verdict::Begins(region.mode);
    regions.iter().map(|region| Shaded { verdict: begins(region), strips: region.strips.clone() }).collect()
}

impl<'a> Plan<'a> {
    pub(crate) fn of(given: &LoadPlane<'a>, pinned: Option<PinnedLoad<'a>>) -> Plan<'a> {
        let rigid = shaded(given.regions);
        let behind = given.regions.iter().flat_map(|region| corners(&region.strips, end(given.up_to)));
        let behind: Vec<f64> = behind.collect();
        let (regions, rigid, corners) = match given.base {
            None => (rigid, Vec::new(), behind),
            Some(base) => {
                let tops = ground::tops(base).into_iter();
                (ground::regions(base, given.friction), rigid, tops.chain(behind).collect())
            }
        };
        let LoadPlane { up_to, friction, stages, title, .. } = *given;
        let uncertain =
            given.base.zip(given.uncertain).map_or_else(Vec::new, |(base, ends)| ground::between(base, ends));
        let pinned = pinned.filter(|pinned| pinned.share.is_finite() && pinned.share > 0.0).map(|pinned| {
            let regions = pinned
                .plane
                .regions
                .iter()
                .map(|(verdict, strips)| Shaded { verdict: *verdict, strips: widened(strips, pinned.share) });
            (regions.collect(), pinned)
        });
        Plan { regions, corners, rigid, uncertain, up_to, friction, stages, title, pinned }
    }
}

/// A vertical boundary: load factor, and the μ it runs between.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Side {
    at: f64,
    low: f64,
    high: f64,
}

/// Draws it.
pub(crate) fn figure(given: &LoadPlane, pinned: Option<PinnedLoad<'_>>) -> Figure {
    drawn(&Plan::of(given, pinned), None, Scene::default()).figure
}

/// Lines of the plane of a base that gives way.
pub(crate) fn lines(given: &LoadPlane) -> Vec<(LoadEdge, Polyline)> {
    given.base.map_or_else(Vec::new, |base| ground::lines(base, given.friction))
}

/// Draws it for a screen, with a plot of some width and height.
pub(crate) fn figure_on_screen(
    given: &LoadPlane,
    pinned: Option<PinnedLoad<'_>>,
    plot: (f64, f64),
) -> Picture {
    drawn(&Plan::of(given, pinned), Some(plot), Scene::themed())
}

fn drawn(given: &Plan, plot: Option<(f64, f64)>, scene: Scene) -> Picture {
    let window = window(given);
    let (k, mu) = window.axes();
    let height = plot.map_or(HEIGHT, |(_, height)| height);
    let mut axes = Axes::beside_numbers([k, mu], (LEFT, COLUMN - ROOM), TOP, height);
    if let Some((across, _)) = plot {
        axes.area.x1 = axes.area.x0 + across;
    }
    let areas = areas(&given.regions, &window);
    let mut canvas = Canvas::new(axes);
    canvas.scene = scene;

    for area in &areas {
        canvas.region(&area.pieces, area.verdict);
    }
    let uncertain = clip_strips(&given.uncertain, &window);
    canvas.scene.stroke(&hatch(&axes, &uncertain, 5.0, Fall::Rising), UNCERTAIN);
    let behind = self::areas(&given.rigid, &window);
    boundaries(&mut canvas, &given.rigid, &behind, RIGID);
    boundaries(&mut canvas, &given.regions, &areas, BOUNDARY);
    if let Some((regions, _)) = &given.pinned {
        let areas = self::areas(regions, &window);
        pinned_boundaries(&mut canvas, regions, &areas);
    }
    axes.border(&mut canvas.scene, FRAME);
    let path = LoadPath::of(given, window.k_max);
    // The path and its numbers leave the design point of the other case free.
    let point = given.pinned.as_ref().map(|(_, PinnedLoad { plane, share })| (*share, plane.friction));
    point.into_iter().for_each(|point| pinned::reserve(&mut canvas, point));
    path.draw(&mut canvas);
    point.into_iter().for_each(|point| pinned::design_point(&mut canvas, point));
    let mut named = Vec::new();
    for area in &areas {
        if canvas.name(&area.pieces, verdict_symbol(area.verdict), 15.5, None) {
            named.push(area.verdict);
        }
    }
    path.names(&mut canvas, &named);
    name_band(&mut canvas, &uncertain);
    name_rigid(&mut canvas, given, &behind, &window);

    let [name, up] = ["Share of the load, $λ$", "Friction, $μ$"].map(|words| Text::inline(words, NUMBER));
    axes.framed(&mut canvas.scene, &axes.ticks());
    axes.name_above(&mut canvas.scene, &up, LEFT, 0.0);
    let below = axes.name_below(&mut canvas.scene, &name);
    let right = path.friction.map(|mu| {
        let text = Text::new(&format!("$μ = {}$", digits(mu)), NUMBER);
        Tab { at: axes.y(mu), text }
    });
    let right = margins::right_of(&mut canvas.scene, &axes, right.into_iter().collect());

    let width = (right.unwrap_or(axes.area.x1) + 12.0).max(axes.area.x1 + ROOM);
    let edges = (16.0, width - 16.0);
    let heading = if given.title.trim().is_empty() { "Load factor and friction" } else { given.title };
    let behind = if given.rigid.is_empty() { "" } else { " Dotted: on rigid ground." };
    let band = if uncertain.is_empty() { "" } else { " Hatched: where the ground fails at $φ ± 2°$." };
    let mut details = margins::words(&(path.caption() + behind + band), SMALL);
    if let Some((_, pinned)) = &given.pinned {
        details.extend(verbatim(&(pinned.plane.words() + "."), SMALL));
    }
    let words = Words::new(verbatim(heading, SIZE), details);
    let description = description(&window, &areas, &words.caption);
    let figure = words.figure(canvas.scene, edges, below + 14.0, 16.0, &description);
    Picture { figure, plot: axes.area, across: axes.across, up: axes.up }
}

/// The name of the band, beside it and as far up as there is room.
fn name_band(canvas: &mut Canvas, band: &[Piece]) {
    let (Some(first), Some(last)) = (band.first(), band.last()) else { return };
    let axes = canvas.board.axes;
    let text = Text::new("$φ ± 2°$", NUMBER);
    let (left, right) = (axes.x(first.from), axes.x(last.to));
    let places = (0..8).flat_map(|row| {
        let y = axes.area.y0 + text.height() * (0.9 + 1.2 * f64::from(row));
        [left - 4.0 - text.width / 2.0, right + 4.0 + text.width / 2.0]
            .map(|x| Rect::around(x, y, text.width, text.height()))
    });
    let place = places.clone().find(|rect| canvas.board.clear(rect, 1.8));
    canvas.place(&text, place, MARK);
}

/// The name of the boundaries on rigid ground, where the ground fails that is there.
fn name_rigid(canvas: &mut Canvas, given: &Plan<'_>, behind: &[Area], window: &View) {
    let fails = given.regions.iter().filter(|region| region.verdict == Verdict::BearingFailure);
    let Some(from) = fails.flat_map(|region| &region.strips).map(|strip| strip.from).reduce(f64::min) else {
        return;
    };
    let arcs = edges(behind, window).into_iter().filter(|arc| arc.to > from);
    let mut arcs: Vec<Arc> = arcs.map(|arc| Arc { from: arc.from.max(from), ..arc }).collect();
    arcs.sort_by(|one, other| (other.to - other.from).total_cmp(&(one.to - one.from)));
    canvas.beside_line(&arcs, &Text::inline(ON_RIGID, NUMBER));
}

/// The part of the plane to be shown: all load factors, and twice the body's friction or the highest corner of a region
/// that is not much farther up.
fn window(given: &Plan) -> View {
    let pinned = given.pinned.as_ref().map(|(_, pinned)| pinned);
    let k = end(given.up_to);
    let both = [Some(given.friction), pinned.map(|pinned| pinned.plane.friction)].into_iter().flatten();
    let friction = both.filter_map(drawable).fold(0.0, f64::max);
    let limit = (2.5 * friction).max(1.2);
    let corners = given.corners.iter().chain(pinned.into_iter().flat_map(|pinned| &pinned.plane.corners));
    let seen = corners.map(|mu| 1.15 * mu).filter(|mu| *mu > 0.0 && *mu <= limit);
    View::from_origin(k, seen.fold((2.0 * friction).max(0.4 * limit), f64::max))
}

/// The largest load factor, if it is one.
fn end(up_to: f64) -> f64 {
    if up_to.is_finite() && up_to > 0.0 { up_to } else { 1.0 }
}

/// A friction that can be shown.
fn drawable(friction: f64) -> Option<f64> {
    (0.0..f64::INFINITY).contains(&friction).then_some(friction)
}

/// The μ at which the edges of a region begin, end, or change from one curve to another, within the plane.
fn corners(strips: &[Strip], up_to: f64) -> Vec<f64> {
    let mut found = Vec::new();
    let edges = |strip: &Strip| [Some(strip.lower), strip.upper];
    let inner = |at: &f64| 0.0 < *at && *at < up_to;
    for (i, strip) in strips.iter().enumerate() {
        for (which, curve) in edges(strip).into_iter().enumerate() {
            let Some(curve) = curve else { continue };
            let follows =
                |other: Option<&Strip>| other.is_some_and(|other| edges(other)[which] == Some(curve));
            let before = i.checked_sub(1).and_then(|before| strips.get(before));
            let ends = [(strip.from, follows(before)), (strip.to, follows(strips.get(i + 1)))];
            let ends = ends.into_iter().filter(|(at, follows)| inner(at) && !follows);
            found.extend(ends.map(|(at, _)| curve.at(at)));
        }
    }
    found
}

fn areas(regions: &[Shaded], window: &View) -> Vec<Area> {
    let area = regions.iter().map(|region| {
        let pieces = clip_strips(&region.strips, window);
        Area { verdict: region.verdict, pieces }
    });
    area.filter(|area| !area.pieces.is_empty()).collect()
}

/// Draws lines between different verdicts, and keeps labels off them.
fn boundaries(canvas: &mut Canvas, regions: &[Shaded], areas: &[Area], pen: Pen) {
    let window = canvas.board.axes.view();
    canvas.arcs(edges(areas, &window), pen);
    let sides = sides(regions, areas, &window).into_iter();
    canvas.verticals(sides.map(|side| (side.at, side.low, side.high)), pen);
}

/// Draws those of another case, where they do not lie on lines that are drawn.
fn pinned_boundaries(canvas: &mut Canvas, regions: &[Shaded], areas: &[Area]) {
    let window = canvas.board.axes.view();
    let arcs = arcs_beside(&canvas.board, edges(areas, &window));
    let sides = sides(regions, areas, &window).into_iter().map(|side| (side.at, side.low, side.high));
    let sides = verticals_beside(&canvas.board, sides.collect());
    canvas.arcs(arcs, PINNED);
    canvas.verticals(sides.into_iter(), PINNED);
}

/// The lower and upper edges of all areas, each once, as long as they run on.
fn edges(areas: &[Area], window: &View) -> Vec<Arc> {
    let mut arcs: Vec<Arc> = Vec::new();
    let bare = |curve: &Curve| *curve == Curve::AXIS || *curve == level(window.mu_max);
    for edge in [|piece: &Piece| piece.lower, |piece: &Piece| piece.upper] {
        // What has been drawn from below need not be drawn from above.
        let drawn = arcs.clone();
        for piece in areas.iter().flat_map(|area| &area.pieces) {
            let (curve, middle) = (edge(piece), (piece.from + piece.to) / 2.0);
            let is_drawn = |arc: &Arc| arc.curve == curve && (arc.from..=arc.to).contains(&middle);
            if bare(&curve) || drawn.iter().any(is_drawn) {
                continue;
            }
            match arcs.iter_mut().find(|arc| arc.curve == curve && arc.to == piece.from) {
                Some(arc) => arc.to = piece.to,
                None => arcs.push(Arc { curve, from: piece.from, to: piece.to }),
            }
        }
    }
    arcs
}

/// The vertical stretches with different modes on their sides.
fn sides(regions: &[Shaded], areas: &[Area], window: &View) -> Vec<Side> {
    // Half a pixel.
    const SHORT: f64 = 0.5 / HEIGHT;
    let near = SAME * window.k_max;
    let mut places: Vec<f64> = regions.iter().flat_map(|region| &region.strips).map(|s| s.from).collect();
    places.retain(|at| near < *at && *at < window.k_max - near);
    places.sort_by(f64::total_cmp);
    places.dedup_by(|later, earlier| *later - *earlier <= near);

    let spans = |is_there: &dyn Fn(&Piece) -> bool, end: fn(&Piece) -> f64| -> Vec<(f64, f64, Verdict)> {
        let pieces = areas.iter().flat_map(|area| area.pieces.iter().map(|piece| (piece, area.verdict)));
        let there = pieces.filter(|(piece, _)| is_there(piece));
        there
            .map(|(piece, verdict)| (piece.lower.at(end(piece)), piece.upper.at(end(piece)), verdict))
            .collect()
    };
    let mut sides: Vec<Side> = Vec::new();
    for at in places {
        let left = spans(&|p| (p.to - at).abs() <= near && p.from < at - near, |p| p.to);
        let right = spans(&|p| (p.from - at).abs() <= near && p.to > at + near, |p| p.from);
        let verdict = |spans: &[(f64, f64, Verdict)], mu: f64| {
            spans.iter().find(|(low, high, _)| (*low..=*high).contains(&mu)).map(|(.., verdict)| *verdict)
        };
        let mut cuts: Vec<f64> = left.iter().chain(&right).flat_map(|(low, high, _)| [*low, *high]).collect();
        cuts.iter_mut().for_each(|mu| *mu = mu.clamp(0.0, window.mu_max));
        cuts.sort_by(f64::total_cmp);
        for pair in cuts.windows(2) {
            let (low, high) = (pair[0], pair[1]);
            let [before, after] = [&left, &right].map(|spans| verdict(spans, (low + high) / 2.0));
            if before.is_none() || after.is_none() || before == after || low == high {
                continue;
            }
            match sides.last_mut() {
                Some(last) if (last.at, last.high) == (at, low) => last.high = high,
                _ => sides.push(Side { at, low, high }),
            }
        }
    }
    sides.retain(|side| side.high - side.low > SHORT * window.mu_max);
    sides
}

/// The way of a rising load: a line along the body's friction.
struct LoadPath {
    stages: Vec<Stage>,
    up_to: f64,
    friction: Option<f64>,
}

impl LoadPath {
    fn of(given: &Plan<'_>, up_to: f64) -> LoadPath {
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
        others.sort_by(|one, other| at(one).total_cmp(&at(other)));
        format!("${}$", distinct_digits(factor, &others[..others.len().min(4)]))
    }

    /// The line with ticks, the diamond, load factors and the names of stages.
    fn draw(&self, canvas: &mut Canvas) {
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
    fn names(&self, canvas: &mut Canvas, named: &[Verdict]) {
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
    fn caption(&self) -> String {
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

/// The figure in words.
fn description(window: &View, areas: &[Area], caption: &str) -> String {
    let mut verdicts: Vec<Verdict> = areas.iter().map(|area| area.verdict).collect();
    verdicts.sort_by_key(|verdict| verdict.code());
    verdicts.dedup();
    let shaded = verdicts.iter().map(|verdict| caption::region(verdict_symbol(*verdict), verdict.words()));
    format!(
        "{} The load path is a line at the body's friction with a tick at every change; a diamond marks the full load. \
         {caption}",
        caption::chart("the load factor λ", window, shaded)
    )
}

#[cfg(test)]
mod tests {
    use standfast::Wrench;
    use standfast::contact::{Block, plane};

    use super::*;

    /// The report's γ = 3, k′ = 0.8 as a load plane: λ is k.
    fn in_air() -> Vec<standfast::region::Region> {
        let weight = Wrench { x: 0.0, p: 1.0, m: 0.0 };
        let force = Wrench { x: -1.0, p: 0.0, m: 0.8 * 3.0 };
        plane::regions(&Block::uniform(3.0, 0.3), &weight, &force, 2.0).expect("a valid block")
    }

    fn plane(regions: &[standfast::region::Region]) -> LoadPlane<'_> {
        LoadPlane { regions, base: None, uncertain: None, up_to: 2.0, friction: 0.3, stages: &[], title: "" }
    }

    #[test]
    fn in_air_the_one_vertical_is_the_report_s() {
        let regions = in_air();
        let given = plane(&regions);
        let given = Plan::of(&given, None);
        let window = window(&given);
        let sides = sides(&given.regions, &areas(&given.regions, &window), &window);
        let k_a = 1.0 / (3.0 * 1.8);
        assert_eq!(sides.len(), 1, "{sides:?}");
        assert!((sides[0].at - k_a).abs() < 1e-12 && (sides[0].low - k_a).abs() < 1e-9);
        assert_eq!(sides[0].high, window.mu_max);
    }

    #[test]
    fn lines_part_different_modes() {
        let regions = in_air();
        let given = plane(&regions);
        let given = Plan::of(&given, None);
        let window = window(&given);
        let mode = |k: f64, mu: f64| regions.iter().find(|region| region.contains(k, mu)).map(|r| r.mode);
        for arc in edges(&areas(&given.regions, &window), &window) {
            for share in [0.1, 0.5, 0.9] {
                let k = arc.from + share * (arc.to - arc.from);
                let mu = arc.curve.at(k);
                assert_ne!(mode(k, mu - 1e-6), mode(k, mu + 1e-6), "{arc:?}");
            }
        }
    }
}
