//! The plane of two numbers of a stack of bodies: which joints move, and how.

use standfast::Mode;
use standfast::contact::stack::plane::StackRegion;
use standfast::region::Curve;

use crate::axes::{Axes, COLUMN, FRAME, LEFT, NUMBER};
use crate::below::{Key, Words, verbatim};
use crate::canvas::Canvas;
use crate::caption::{SIZE, SMALL};
use crate::palette::{INK, MARK, REST, symbol, tint};
use crate::plot::{Arc, Piece, View, clip_strips, level, outline};
use crate::scene::{Path, Pen, Rect, Scene};
use crate::text::Text;
use crate::texture::{self, Texture};
use crate::{Figure, StackMap, caption, margins};

const HEIGHT: f64 = 300.0;
/// Above the plot: the name of μ.
const TOP: f64 = 30.0;
const BOUNDARY: Pen = Pen::solid(INK, 1.3);
const KNOWN: Pen = Pen { colour: MARK, width: 3.0, dashes: "0 7" };
const GAP: f64 = 12.0;

/// Which joints move: the pattern of a region.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Moves {
    Lowest,
    Upper,
    Several,
}

impl Moves {
    fn of(modes: &[Mode]) -> Option<Moves> {
        let moving: Vec<usize> = (0..modes.len()).filter(|joint| modes[*joint] != Mode::Rest).collect();
        match moving.as_slice() {
            [] => None,
            [0] => Some(Moves::Lowest),
            [_] => Some(Moves::Upper),
            _ => Some(Moves::Several),
        }
    }

    fn texture(self) -> Texture {
        match self {
            Moves::Lowest => Texture::Plain,
            Moves::Upper => Texture::Stripes,
            Moves::Several => Texture::Dots,
        }
    }

    fn words(self) -> &'static str {
        match self {
            Moves::Lowest => "no pattern: the joint at the ground moves",
            Moves::Upper => "one above it moves",
            Moves::Several => "several move",
        }
    }
}

/// A region as the window shows it.
struct Area<'a> {
    modes: &'a [Mode],
    pieces: Vec<Piece>,
    /// In words.
    words: Option<&'a str>,
}

impl Area<'_> {
    fn tint(&self) -> &'static str {
        let lowest = self.modes.iter().find(|mode| **mode != Mode::Rest);
        lowest.map_or(REST, |mode| tint(*mode))
    }

    fn texture(&self) -> Texture {
        Moves::of(self.modes).map_or(Texture::Plain, Moves::texture)
    }

    /// Its modes in markup, from the ground up.
    fn name(&self) -> String {
        self.modes.iter().map(|mode| symbol(*mode)).collect::<Vec<_>>().join("/")
    }
}

/// Draws it.
pub(crate) fn figure(given: &StackMap<'_>) -> Figure {
    let [k, mu] = given.window;
    let window = View::from_origin(k, mu);
    let (across, up) = window.axes();
    let axes = Axes::beside_numbers([across, up], (LEFT, COLUMN - LEFT), TOP, HEIGHT);
    let area = |region: &'_ StackRegion| clip_strips(&region.strips, &window);
    let mut areas: Vec<Area<'_>> = given
        .plane
        .regions
        .iter()
        .enumerate()
        .map(|(place, region)| {
            let words = given.words.and_then(|words| words.get(place)).map(String::as_str);
            Area { modes: &region.modes, pieces: area(region), words }
        })
        .collect();
    areas.retain(|area| !area.pieces.is_empty());

    let mut canvas = Canvas::new(axes);
    for area in &areas {
        canvas.scene.fill(&outline(&axes, &area.pieces), area.tint());
        texture::laid_over(&mut canvas.scene, &axes, &area.pieces, area.texture());
        if area.texture() != Texture::Plain {
            canvas.hatched.push((area.pieces.clone(), area.tint()));
        }
    }
    canvas.arcs(boundaries(&areas, &window), BOUNDARY);
    let uprights = given.plane.uprights.iter().map(|[k, low, high]| (*k, *low, *high));
    canvas.verticals(uprights, BOUNDARY);
    for curve in given.curves {
        let shown: Vec<(f64, f64)> =
            curve.iter().filter(|(k, mu)| window.shows(*k, *mu)).map(|(k, mu)| axes.at(*k, *mu)).collect();
        canvas.scene.stroke(&Path::through(&shown), KNOWN);
    }
    axes.border(&mut canvas.scene, FRAME);
    canvas.design_points(given.point.as_slice());
    for area in &areas {
        canvas.name(&area.pieces, &area.name(), 15.5, None);
    }
    axes.framed(&mut canvas.scene, &axes.ticks());
    axes.name_above(&mut canvas.scene, &Text::inline(given.up, NUMBER), LEFT, 0.0);
    let below = axes.name_below(&mut canvas.scene, &Text::inline(given.across, NUMBER));

    let edges = (LEFT, COLUMN - LEFT);
    let mut key = Key::new(edges, below + GAP);
    for area in &areas {
        let Some(words) = area.words else { continue };
        let words = [Text::new(&area.name(), SMALL), Text::verbatim(words, SMALL)];
        key.patch(
            &mut canvas.scene,
            |scene, rect| {
                scene.fill(&Path::rectangle(rect), area.tint());
                lay(scene, rect, area.texture());
            },
            &words,
        );
    }
    for moves in [Moves::Lowest, Moves::Upper, Moves::Several] {
        if given.words.is_none() && areas.iter().any(|area| Moves::of(area.modes) == Some(moves)) {
            let words = [Text::verbatim(moves.words(), SMALL)];
            // On paper: of a tint it would be that of a mode.
            key.patch(&mut canvas.scene, |scene, rect| lay(scene, rect, moves.texture()), &words);
        }
    }
    let known = if given.curves.is_empty() { "" } else { " Dotted: boundaries known in closed form." };
    let regions = given
        .regions
        .unwrap_or("Modes of the joints from the ground up, in the colour of the lowest that moves.");
    let words = format!("{regions}{known}");
    let shaded =
        areas.iter().map(|area| area.modes.iter().map(|mode| mode.symbol()).collect::<Vec<_>>().join("/"));
    let description = caption::chart("k", &window, shaded);
    let words = Words::new(verbatim(given.title, SIZE), margins::words(&words, SMALL));
    words.figure(canvas.scene, edges, key.below() + GAP, LEFT, &description)
}

/// Lays a texture within a patch of the key; the rims of dots keep within it, too.
fn lay(scene: &mut Scene, patch: &Rect, texture: Texture) {
    let inset = if texture == Texture::Dots { 3.0 } else { 0.0 };
    let Rect { x0, y0, x1, y1 } = *patch;
    let within = Rect { x0: x0 + inset, y0, x1: x1 - inset, y1 };
    texture::laid_within(scene, &[&within.corners()], texture);
}

/// The lower edges of all areas, but for the axis.
fn boundaries(areas: &[Area<'_>], window: &View) -> Vec<Arc> {
    let pieces = areas.iter().flat_map(|area| &area.pieces);
    let lower = pieces.filter(|piece| piece.lower != Curve::AXIS && piece.lower != level(window.mu_min));
    lower.map(|piece| Arc { curve: piece.lower, from: piece.from, to: piece.to }).collect()
}
