//! The plane of load factor and friction of any block, with the path of a rising load.
//!
//! Nothing is known of the boundaries but the strips of the regions: they are drawn where neighbours differ in verdict. So
//! there are no formulas here, and the axes have numbers. On a base that gives way the strips are those between points of its curves, and
//! the boundaries on rigid ground lie behind, dotted.

mod boundaries;
mod ground;
mod path;

use standfast::ground::load_plane::LoadEdge;
use standfast::region::{Region, Strip};
use standfast::{Stage, Verdict};

use self::boundaries::{boundaries, corners, edges, pinned_boundaries};
use self::path::LoadPath;
use crate::axes::{Axes, COLUMN, FRAME, LEFT, NUMBER};
use crate::below::{Words, verbatim};
use crate::canvas::Canvas;
use crate::caption::{SIZE, SMALL};
use crate::ground::{DOTTED, ON_RIGID, RIGID};
use crate::margins::{self, Tab};
use crate::number::digits;
use crate::outlines::Polyline;
use crate::palette::{INK, MARK, verdict_symbol};
use crate::pinned::{self, PinnedLoad, widened};
use crate::plot::{Arc, Fall, Piece, View, clip_strips, hatch};
use crate::scene::{Pen, Rect, Scene};
use crate::text::Text;
use crate::{Figure, LoadPlane, Picture, caption};

const HEIGHT: f64 = 310.0;
/// Above the plot: the name of the friction.
const TOP: f64 = 30.0;
/// Room right of the plot for the friction of the path.
const ROOM: f64 = 72.0;
const BOUNDARY: Pen = Pen::solid(INK, 1.3);
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
    let behind = if given.rigid.is_empty() { "" } else { DOTTED };
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
    standfast::order::by_number(&mut arcs, |one| -(one.to - one.from));
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

fn areas(regions: &[Shaded], window: &View) -> Vec<Area> {
    let area = regions.iter().map(|region| {
        let pieces = clip_strips(&region.strips, window);
        Area { verdict: region.verdict, pieces }
    });
    area.filter(|area| !area.pieces.is_empty()).collect()
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
