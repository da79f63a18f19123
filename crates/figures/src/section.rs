//! Section of the case to scale, with all that presses on it, for a checker who holds it against the drawing.
//!
//! ```text
//!   levels │ height │ pressures, forces │ ┌────────┐ │ forces, pressures │ levels
//!          │        │        left       │ │   C    │ │       right       │
//!   ───────┴────────┴───────────────────┴─O────────O'┴───────────────────┴───────
//!                                  pressures under the base
//!                                         widths
//!                                     seen from above
//!                                         legend
//! ```
//!
//! Lengths are to one scale, pressures to another, arrows of forces to a third. Every column and every row has
//! a strip of the page of its own, as wide as what stands in it, and within a strip labels are spread: so none lies on another,
//! whatever the numbers.

mod columns;
mod paint;
mod plan;
mod rows;
mod surroundings;
mod under;

use standfast::loads::Face;

use crate::Figure;
use crate::axes::{COLUMN, NUMBER, PAGE};
use crate::pinned::PinnedBody;
use crate::scene::{Rect, Scene};
use paint::Painter;
pub use plan::{PlanPlace, PlanView};
use surroundings::Room;

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

/// Fill beside the body, from the base up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Backfill {
    /// On which side it lies.
    pub side: Side,
    /// Its surface at the body, m above the base.
    pub top: f64,
    /// Rise of the surface away from the body, as a share of the distance.
    pub slope: f64,
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
    /// Its size as it is written, and what of it is borne, in lines.
    pub labels: Vec<String>,
    /// The width that bears it, with its name; none of an edge.
    pub width: Option<String>,
    /// The way in which the ground under it fails, where that is drawn.
    pub failure: Option<FailureSketch>,
}

/// The way in which ground fails; m from mid-width and above the base.
#[derive(Debug, Clone, PartialEq)]
pub struct FailureSketch {
    /// Lines; the surface on which the ground slips first, from the edge inside the base to where it comes out.
    pub lines: Vec<Vec<(f64, f64)>>,
    /// The edge of what bears on the side where the ground comes out.
    pub near: f64,
    /// That side: −1 to the left, 1 to the right.
    pub out: f64,
    /// Its name.
    pub label: String,
}

/// A number that is written where it acts.
#[derive(Debug, Clone, PartialEq)]
pub struct Stated {
    /// Name with its symbol, in markup.
    pub name: String,
    /// The symbol alone, in markup.
    pub symbol: String,
    /// The number as it is written.
    pub value: String,
    /// Its unit behind it, with the space before it; may be empty.
    pub unit: String,
}

/// A joint between what is above and below it, m from mid-width and above the base.
#[derive(Debug, Clone, PartialEq)]
pub struct JointLine {
    /// Its left and its right end.
    pub ends: (f64, f64),
    /// Its level.
    pub elevation: f64,
    /// Its number, from the base, which is 1.
    pub number: usize,
    /// True if it leaves rest first.
    pub governs: bool,
    /// Where the resultant of all that is above it passes its level; `None` where nothing presses.
    pub resultant: Option<f64>,
}

/// Content of a section.
#[derive(Debug, Clone, PartialEq)]
pub struct Section<'a> {
    /// Title, in a line; not markup.
    pub title: &'a str,
    /// The body.
    pub parts: &'a [Outline],
    /// The joints from the base, which is the first; none of a body of one piece.
    pub joints: Vec<JointLine>,
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
    /// True if what the body stands on is soil, which is drawn with grains.
    pub is_on_soil: bool,
    /// Fill beside the body.
    pub backfills: Vec<Backfill>,
    /// Crest of the wave at the right wall, m above the base; its surface falls from there to the water at the right.
    pub wave_crest: Option<f64>,
    /// Reaction of the base.
    pub reaction: Option<BaseReaction>,
    /// Friction of the base.
    pub friction: Option<Stated>,
    /// What the ground under it is known by.
    pub ground: Option<Stated>,
    /// The base seen from above, where loads come from any direction.
    pub plan: Option<PlanView>,
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
///     joints: Vec::new(),
///     base: (-0.5, 0.5),
///     centroid: (0.0, 1.0),
///     levels: Vec::new(),
///     pressures: Vec::new(),
///     arrows: Vec::new(),
///     widths: Vec::new(),
///     heights: Vec::new(),
///     mound: None,
///     is_on_soil: false,
///     backfills: Vec::new(),
///     wave_crest: None,
///     reaction: None,
///     friction: None,
///     ground: None,
///     plan: None,
///     notes: vec!["1 m by 2 m".to_owned()],
/// });
/// assert_eq!(figure.title(), "Section: Block");
/// ```
pub fn section(given: &Section<'_>) -> Figure {
    section_beside(given, None)
}

/// The same with a body in dashes behind it, its corner O in the same place.
pub fn section_beside(given: &Section<'_>, pinned: Option<&PinnedBody>) -> Figure {
    drawn(given, on_paper(given, pinned)).figure
}

/// The body is about as large as this on paper.
const BODY: (f64, f64) = (230.0, 230.0);

/// The largest pressure is drawn as long as this, and the largest force at most.
const LONGEST: f64 = 56.0;

/// A section for a screen, about as large as `size`: in colours of the page and without the words below it, which are its caption. It is no
/// wider than asked where that can be, so that its letters keep their size.
pub fn section_on_screen(given: &Section<'_>, size: (f64, f64)) -> SectionPicture {
    section_on_screen_beside(given, None, size)
}

/// The same with a body in dashes behind it, its corner O in the same place; both have room.
pub fn section_on_screen_beside(
    given: &Section<'_>,
    pinned: Option<&PinnedBody>,
    size: (f64, f64),
) -> SectionPicture {
    /// From some width on there is room for the names of levels.
    const NARROW: f64 = 450.0;
    let longest = (0.1 * size.0).clamp(32.0, 72.0);
    let names = size.0 >= NARROW;
    let roomy = SectionLook { body: size, longest, names, numbers: true, on_screen: true, pinned };
    // Much that stands beside a body leaves it little room: then without names, with short arrows, and at last without the numbers of
    // pressures.
    let looks = [
        (roomy, 60.0),
        (SectionLook { longest: 32.0, names: false, ..roomy }, 60.0),
        (SectionLook { longest: 16.0, names: false, numbers: false, ..roomy }, 36.0),
    ];
    let mut pictures = looks.into_iter().map(|(look, least)| fitted(given, look, size, least));
    let mut picture = pictures.next();
    while picture.as_ref().is_some_and(|picture| picture.figure.size.0 > size.0) {
        let Some(next) = pictures.next() else { break };
        picture = Some(next);
    }
    picture.unwrap_or_else(|| drawn(given, roomy))
}

/// A section whose body is as large as leaves room for what stands beside it, and no narrower than `least`.
fn fitted(given: &Section<'_>, look: SectionLook<'_>, size: (f64, f64), least: f64) -> SectionPicture {
    const ROUNDS: u32 = 4;
    /// The least height of a body, in the width of all.
    const FLATTEST: f64 = 0.15;
    let mut body = (size.0 / 2.0, size.1 / 2.0);
    // What stands beside the body takes about the same room whatever its size.
    for _ in 0..ROUNDS {
        let painter = Painter::new(given, SectionLook { body, ..look }, (0.0, 0.0), None);
        let is = (painter.scale * (painter.bounds.x1 - painter.bounds.x0), painter.scale * painter.bounds.y1);
        let Rect { x0, y0, x1, y1 } = painter.paint().extent.grown(MARGIN);
        let room = |room: f64, taken: f64, body: f64, least: f64| (room - (taken - body)).max(least);
        body = (room(size.0, x1 - x0 + 1.0, is.0, least), room(size.1, y1 - y0, is.1, FLATTEST * size.0));
    }
    let mut picture = drawn(given, SectionLook { body, ..look });
    // Labels that move aside where they crowd may take more at the end.
    while picture.figure.size.0 > size.0 && body.0 > least {
        body.0 = (0.94 * body.0.min(picture.body.x1 - picture.body.x0)).max(least);
        picture = drawn(given, SectionLook { body, ..look });
    }
    picture
}

/// The section of a body that has changed, with another in dashes, at the scale and in the look that it had: for a screen, while a side of it is
/// held.
pub fn section_as_fitted(
    given: &Section<'_>,
    pinned: Option<&PinnedBody>,
    fit: SectionFit,
) -> SectionPicture {
    let SectionFit { scale, longest, names, numbers } = fit;
    let look = SectionLook { body: BODY, longest, names, numbers, on_screen: true, pinned };
    let bounds = Painter::new(given, look, (0.0, 0.0), None).bounds;
    drawn(given, SectionLook { body: (scale * (bounds.x1 - bounds.x0), scale * bounds.y1), ..look })
}

/// Scale and look of a section that was drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SectionFit {
    scale: f64,
    longest: f64,
    names: bool,
    numbers: bool,
}

/// Look of a section.
#[derive(Debug, Clone, Copy)]
struct SectionLook<'a> {
    /// The largest width and height of the body on the page.
    body: (f64, f64),
    longest: f64,
    /// True if there is room for the names of levels.
    names: bool,
    /// True if there is room for the numbers of pressures beside the body.
    numbers: bool,
    on_screen: bool,
    /// Another body, in dashes.
    pinned: Option<&'a PinnedBody>,
}

impl<'a> SectionLook<'a> {
    /// A body `size` times as large as bodies are, at most, with loads this long.
    fn on_paper(size: f64, longest: f64, pinned: Option<&'a PinnedBody>) -> SectionLook<'a> {
        SectionLook {
            body: (size * BODY.0, size * BODY.1),
            longest,
            names: true,
            numbers: true,
            on_screen: false,
            pinned,
        }
    }
}

/// A number that a section shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SectionNumber {
    /// A width, by its row and its place there.
    Width(usize, usize),
    /// A height, by its column and its place there.
    Height(usize, usize),
    /// A level, by its place.
    Level(usize),
    /// The size of a force, by its place.
    Arrow(usize),
    /// Friction of the base.
    Friction,
    /// What the ground is known by.
    Ground,
}

/// A force as it is drawn on a face.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SectionArrow {
    /// The place of the force.
    pub index: usize,
    /// Where the arrow begins.
    pub tail: (f64, f64),
    /// Where it ends, on the face.
    pub tip: (f64, f64),
}

/// A section and where things lie in it, in units of the drawing.
#[derive(Debug, Clone, PartialEq)]
pub struct SectionPicture {
    /// The drawing.
    pub figure: Figure,
    /// The labels of numbers.
    pub numbers: Vec<(SectionNumber, Rect)>,
    /// Where the lines of widths and heights end: at the right, and above.
    pub ends: Vec<(SectionNumber, (f64, f64))>,
    /// The forces on faces.
    pub arrows: Vec<SectionArrow>,
    /// The body.
    pub body: Rect,
    /// Units for a metre.
    pub scale: f64,
    /// Scale and look, to draw it again.
    pub fit: SectionFit,
}

fn drawn(given: &Section<'_>, look: SectionLook<'_>) -> SectionPicture {
    // Items that reach across the page are drawn when it is known how large the page is.
    let wide = |painting: &Painting| painting.extent.x1 - painting.extent.x0 + 2.0 * MARGIN;
    let measured = Painter::new(given, look, (0.0, 0.0), None).paint();
    let natural = measured.extent.grown(MARGIN);
    let column = [COLUMN, PAGE].into_iter().find(|column| !look.on_screen && wide(&measured) <= *column);
    let aside = column.map_or(0.0, |column| (column - wide(&measured)) / 2.0);
    let page = Rect { x0: natural.x0 - aside, x1: natural.x1 + aside, ..natural };
    let size = ((page.x1 - page.x0 - 1e-6).ceil(), (page.y1 - page.y0).ceil());
    let moved = |rect: &Rect| Rect {
        x0: rect.x0 - page.x0,
        y0: rect.y0 - page.y0,
        x1: rect.x1 - page.x0,
        y1: rect.y1 - page.y0,
    };
    let room = Room {
        ends: (measured.names.0 - page.x0, measured.names.1 - page.x0),
        labels: measured.labels.iter().map(moved).collect(),
    };
    let painter = Painter::new(given, look, (-page.x0, -page.y0), Some(room));
    let scale = painter.scale;
    let own = painter.own;
    let (low, high) = (painter.place(own.x0, own.y0), painter.place(own.x1, own.y1));
    let body = Rect { x0: low.0, y0: high.1, x1: high.0, y1: low.1 };
    let drawn = painter.paint();
    let title = match given.title {
        "" => "Section".to_owned(),
        title => format!("Section: {title}"),
    };
    let (svg, labels) = drawn.scene.finish(size.0, size.1, &title, &description(given));
    let caption = legend(given).into_iter().chain(look.pinned.map(PinnedBody::words));
    let caption = caption.collect::<Vec<_>>().join(". ");
    let figure = Figure { svg, title, caption, labels, size };
    let SectionLook { longest, names, numbers, .. } = look;
    SectionPicture {
        figure,
        numbers: drawn.numbers,
        ends: drawn.ends,
        arrows: drawn.arrows,
        body,
        scale,
        fit: SectionFit { scale, longest, names, numbers },
    }
}

/// How large the body and its loads are drawn on paper, so that all has room in a column or a page.
fn on_paper<'a>(given: &Section<'_>, pinned: Option<&'a PinnedBody>) -> SectionLook<'a> {
    const STEP: f64 = 0.96;
    let look = |size, longest| SectionLook::on_paper(size, longest, pinned);
    let width = |look: SectionLook<'_>| {
        let Rect { x0, x1, .. } = Painter::new(given, look, (0.0, 0.0), None).paint().extent;
        x1 - x0 + 2.0 * MARGIN
    };
    let body = |look: SectionLook<'_>| Painter::new(given, look, (0.0, 0.0), None).width();
    // A little smaller for a column; for a page as small as it takes, then with shorter loads. What stands beside the body keeps its
    // width, but for labels that move aside where they crowd: so sizes are tried.
    let tries = [
        (COLUMN, 0.8, LONGEST),
        (PAGE, 0.55, LONGEST),
        (PAGE, 0.3, 0.75 * LONGEST),
        (PAGE, 0.2, 0.5 * LONGEST),
        (WIDER, 0.3, LONGEST),
        (WIDER, 0.2, 0.5 * LONGEST),
    ];
    for (wide, least, longest) in tries {
        if width(look(least, longest)) > wide {
            continue;
        }
        let over = width(look(1.0, longest)) - wide;
        let mut size: f64 = if over <= 0.0 { 1.0 } else { (1.0 - over / body(look(1.0, longest))) * 0.98 };
        while size >= least {
            if width(look(size, longest)) <= wide {
                return look(size, longest);
            }
            size *= STEP;
        }
    }
    look(1.0, LONGEST)
}

/// A little wider than a page, for loads of many kinds on a side.
const WIDER: f64 = 840.0;

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
    /// Where labels stand, but for the legend.
    ends: Vec<(SectionNumber, (f64, f64))>,
    labels: Vec<Rect>,
    numbers: Vec<(SectionNumber, Rect)>,
    arrows: Vec<SectionArrow>,
}
