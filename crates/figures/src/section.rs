//! Section of the case to scale, with all that presses on it, for a checker who holds it against the drawing.
//!
//! ```text
//!   levels │ height │ pressures, forces │ ┌────────┐ │ forces, pressures │ levels
//!          │        │        left       │ │   C    │ │       right       │
//!   ───────┴────────┴───────────────────┴─O────────O'┴───────────────────┴───────
//!                                  pressures under the base
//!                                         widths
//!                                         legend
//! ```
//!
//! Lengths are to one scale, pressures to another, arrows of forces to a third. Every column and every row has
//! a strip of the page of its own, as wide as what stands in it, and within a strip labels are spread: so none lies on another,
//! whatever the numbers.

mod columns;
mod paint;
mod rows;

use standfast::loads::Face;

use crate::Figure;
use crate::axes::{COLUMN, NUMBER, PAGE};
use crate::scene::{Rect, Scene};
use paint::Painter;

/// A part of the body: a polygon, in metres from mid-width to the right and from the base upwards.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    /// Its corners, in order.
    pub vertices: Vec<(f64, f64)>,
    /// Material of the part.
    pub material: Material,
    /// Name of the part; may be empty.
    pub label: String,
}

/// Material of a part of the body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Material {
    /// Solid that holds itself.
    Solid,
    /// Fill that is held, or takes up water: sand, stone.
    Fill,
    /// Nothing: an empty space.
    Cavity,
}

/// A side of the body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// That of the corner O.
    Left,
    /// That of the corner O′.
    Right,
}

/// A level beside the body.
#[derive(Debug, Clone, PartialEq)]
pub struct Level {
    /// On which side it is told.
    pub side: Side,
    /// Above the base, m.
    pub elevation: f64,
    /// Name and value.
    pub label: String,
    /// True if water stands up to it on that side.
    pub is_water: bool,
}

/// A pressure along a face, linear from point to point and nothing outside.
#[derive(Debug, Clone, PartialEq)]
pub struct Pressed {
    /// Face; positions on the sides are heights above the base, on base and top distances to the right of O.
    pub face: Face,
    /// Position (m), pressure (Pa, above zero where it pushes), and how the pressure is written.
    pub points: Vec<(f64, f64, String)>,
    /// Name and amount, for the legend.
    pub words: String,
}

/// A force.
#[derive(Debug, Clone, PartialEq)]
pub struct Arrow {
    /// Point of application, m from mid-width and above the base.
    pub at: (f64, f64),
    /// Direction: a unit vector along an axis, to the right and upwards.
    pub towards: (f64, f64),
    /// True if it acts on the mass and is drawn within the body, rather than on a face.
    pub is_inside: bool,
    /// Its size, above zero, N or N/m.
    pub size: f64,
    /// Its size as it is written.
    pub label: String,
    /// Name and amount, for the legend.
    pub words: String,
}

/// A distance that is written out.
#[derive(Debug, Clone, PartialEq)]
pub struct Measure {
    /// Its ends, m: from mid-width along the base, or above the base.
    pub ends: (f64, f64),
    /// Name and value.
    pub label: String,
}

/// The mound under a caisson and the sea at its right, in metres above the base.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mound {
    /// The bed of the sea; below the base.
    pub bed: f64,
    /// The top of the berm's armour.
    pub berm: f64,
    /// Width of the berm from the wall, m.
    pub berm_width: f64,
}

/// The reaction of the base, and what of the base bears it; m from mid-width.
#[derive(Debug, Clone, PartialEq)]
pub struct BaseReaction {
    /// Point of application.
    pub at: f64,
    /// Its size, above zero, N or N/m.
    pub size: f64,
    /// The ends of what bears it; the same twice where that is an edge.
    pub pressed: (f64, f64),
    /// The point about which the body turns, if it does.
    pub neutral: Option<f64>,
    /// Its size as it is written.
    pub label: String,
}

/// Content of a section.
#[derive(Debug, Clone, PartialEq)]
pub struct Section<'a> {
    /// Title, in a line; not markup.
    pub title: &'a str,
    /// The body.
    pub parts: &'a [Outline],
    /// The corners O and O′ on the base, m from mid-width.
    pub base: (f64, f64),
    /// The centre of mass, m from mid-width and above the base.
    pub centroid: (f64, f64),
    /// Levels beside the body.
    pub levels: Vec<Level>,
    /// Pressures, in the order of the legend.
    pub pressures: Vec<Pressed>,
    /// Forces, in the order of the legend, behind the pressures.
    pub arrows: Vec<Arrow>,
    /// Distances along the base, row by row.
    pub widths: Vec<Vec<Measure>>,
    /// Heights, column by column.
    pub heights: Vec<Vec<Measure>>,
    /// Mound that the body stands on; a floor if none.
    pub mound: Option<Mound>,
    /// Crest of the wave at the right wall, m above the base; its surface falls from there to the water at the right.
    pub wave_crest: Option<f64>,
    /// Reaction of the base.
    pub reaction: Option<BaseReaction>,
    /// Sentences below the legend; not markup.
    pub notes: Vec<String>,
}

/// Draws a section.
///
/// ```
/// use standfast_figures::{Material, Outline, Section, section};
///
/// let block = Outline {
///     vertices: vec![(-0.5, 0.0), (0.5, 0.0), (0.5, 2.0), (-0.5, 2.0)],
///     material: Material::Solid,
///     label: String::new(),
/// };
/// let figure = section(&Section {
///     title: "Block",
///     parts: &[block],
///     base: (-0.5, 0.5),
///     centroid: (0.0, 1.0),
///     levels: Vec::new(),
///     pressures: Vec::new(),
///     arrows: Vec::new(),
///     widths: Vec::new(),
///     heights: Vec::new(),
///     mound: None,
///     wave_crest: None,
///     reaction: None,
///     notes: vec!["1 m by 2 m".to_owned()],
/// });
/// assert_eq!(figure.title(), "Section: Block");
/// ```
pub fn section(given: &Section<'_>) -> Figure {
    // Items that reach across the page are drawn when it is known how large the page is.
    let (scale, measured) = fitted(given);
    let natural = measured.extent.grown(MARGIN);
    let wide = [COLUMN, PAGE].into_iter().find(|wide| natural.x1 - natural.x0 <= *wide);
    let aside = wide.map_or(0.0, |wide| (wide - (natural.x1 - natural.x0)) / 2.0);
    let page = Rect { x0: natural.x0 - aside, x1: natural.x1 + aside, ..natural };
    let size = ((page.x1 - page.x0 - 1e-6).ceil(), (page.y1 - page.y0).ceil());
    let room = (measured.names.0 - page.x0, measured.names.1 - page.x0);
    let drawn = Painter::new(given, scale, (-page.x0, -page.y0), Some(room)).paint();
    let title = match given.title {
        "" => "Section".to_owned(),
        title => format!("Section: {title}"),
    };
    let (svg, labels) = drawn.scene.finish(size.0, size.1, &title, &description(given));
    Figure { svg, title, caption: legend(given).join(". "), labels, size }
}

/// How large the body is drawn, so that all has room in a column or a page, and the drawing measured.
fn fitted(given: &Section<'_>) -> (f64, Painting) {
    let drawn = |size: f64| Painter::new(given, size, (0.0, 0.0), None).paint();
    let width = |painting: &Painting| painting.extent.x1 - painting.extent.x0 + 2.0 * MARGIN;
    let whole = drawn(1.0);
    let body = Painter::new(given, 1.0, (0.0, 0.0), None).width();
    // A little smaller for a column; as small as it takes for a page. What stands beside the body keeps its width.
    for (wide, least) in [(COLUMN, 0.8), (PAGE, 0.4)] {
        let over = width(&whole) - wide;
        if over <= 0.0 {
            return (1.0, whole);
        }
        let size = (1.0 - over / body) * 0.98;
        if size >= least {
            let smaller = drawn(size);
            if width(&smaller) <= wide {
                return (size, smaller);
            }
        }
    }
    (1.0, whole)
}

/// White around the drawing.
const MARGIN: f64 = 10.0;

/// Type size of labels.
const LABEL: f64 = NUMBER;

/// The letter of a load in the drawing.
fn tag(index: usize) -> String {
    let letter = char::from(b'a' + (index % 26) as u8);
    letter.to_string().repeat(index / 26 + 1)
}

/// The loads with their letters, in words.
fn legend(given: &Section<'_>) -> Vec<String> {
    let loads = given.pressures.iter().map(|pressed| &pressed.words);
    let loads = loads.chain(given.arrows.iter().map(|arrow| &arrow.words));
    loads.enumerate().map(|(index, words)| format!("{} {words}", tag(index))).collect()
}

/// For readers who do not see it.
fn description(given: &Section<'_>) -> String {
    let levels = given.levels.iter().map(|level| &level.label);
    let measures = given.widths.iter().chain(&given.heights).flatten().map(|measure| &measure.label);
    let said: Vec<_> = measures.chain(levels).cloned().collect();
    format!("The body to scale: {}. Loads: {}.", said.join("; "), legend(given).join("; "))
}

/// The drawing under way: the scene, how far it reaches, and where the names of levels begin at the left and the right.
struct Painting {
    scene: Scene,
    extent: Rect,
    names: (f64, f64),
}
