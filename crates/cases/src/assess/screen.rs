//! Drawings of a case for a screen, and where in them the numbers of the case lie: for a page on which they are fields and handles.

use standfast::InputError;
use standfast_figures::{
    Picture, PinnedBody, PinnedLoad, Rect, Section, SectionArrow, SectionFit, SectionNumber, SectionPicture,
    Side,
};

use super::figures::with_load_plane;
use super::pinned::with_room;
pub use super::section::Pressures;
use super::section::with_section;
use super::{Assessed, Assessment};
use crate::case::said_by;
use crate::key::Table;
use crate::{Id, Key, Place};

/// The section of a case on a screen.
#[derive(Debug, Clone, PartialEq)]
pub struct SectionOnScreen {
    /// The drawing.
    pub picture: SectionPicture,
    /// Keys of a case file whose numbers it shows, and where; a file need not have all of them.
    pub numbers: Vec<(Id, Rect)>,
    /// Width and height of the body, and where their lines end.
    pub sides: Vec<(Id, (f64, f64))>,
    /// The forces of the case on faces of the body, each under the key of its size.
    pub forces: Vec<(Id, SectionArrow)>,
    /// The loads by their letters, and sentences on the drawing.
    pub words: Vec<String>,
    /// How its pressures are drawn; `None` without any.
    pub pressures: Option<Pressures>,
}

/// A body narrower than this is hard to see and to hold, units.
const SMALL: f64 = 100.0;

/// What of a section is drawn, and how.
#[derive(Debug, Clone, Copy, Default)]
pub struct SectionView<'a> {
    /// Another body, in dashes.
    pub pinned: Option<&'a PinnedBody>,
    /// How pressures are drawn; if nobody says, along their faces, or summed where else the body is small and so is larger.
    pub pressures: Option<Pressures>,
}

/// The section of a case under all of its loads, about as large as `size`.
///
/// # Errors
/// If a number is out of range.
pub fn section_on_screen(
    assessment: &Assessment,
    view: SectionView<'_>,
    size: (f64, f64),
) -> Result<SectionOnScreen, InputError> {
    let drawn = |pressures| {
        placed(assessment, pressures, |section| {
            standfast_figures::section_on_screen_beside(section, view.pinned, size)
        })
    };
    let first = drawn(view.pressures.unwrap_or_default())?;
    let width = |section: &SectionOnScreen| section.picture.body.x1 - section.picture.body.x0;
    if view.pressures.is_some() || first.pressures.is_none() || width(&first) >= SMALL {
        return Ok(first);
    }
    let summed = drawn(Pressures::Summed)?;
    Ok(if width(&summed) > width(&first) { summed } else { first })
}

/// The section of a case whose body has changed, at the scale and in the look that it had.
///
/// # Errors
/// If a number is out of range.
pub fn section_as_fitted(
    assessment: &Assessment,
    view: SectionView<'_>,
    fit: SectionFit,
) -> Result<SectionOnScreen, InputError> {
    placed(assessment, view.pressures.unwrap_or_default(), |section| {
        standfast_figures::section_as_fitted(section, view.pinned, fit)
    })
}

fn placed(
    assessment: &Assessment,
    drawn: Pressures,
    draw: impl Fn(&Section<'_>) -> SectionPicture,
) -> Result<SectionOnScreen, InputError> {
    with_section(assessment, drawn, |section, arrows| {
        let picture = draw(section);
        let force = |index: usize| match said_by(*arrows.loads.get(index)?) {
            Place::Table(Table::Load, index) => Some(Id::new(Key::Force, index)),
            _ => None,
        };
        // The width and the height of the body are the outermost.
        let side = |of: &SectionNumber| match of {
            SectionNumber::Width(row, _) if row + 1 == section.widths.len() => Some(Key::Width),
            SectionNumber::Height(column, _) if column + 1 == section.heights.len() => Some(Key::Height),
            _ => None,
        };
        let sides = picture.ends.iter().filter_map(|(of, end)| Some((side(of)?.into(), *end))).collect();
        let mut numbers = Vec::new();
        for (of, rect) in &picture.numbers {
            let ids: Vec<Id> = match of {
                SectionNumber::Width(..) | SectionNumber::Height(..) => {
                    side(of).into_iter().map(Id::from).collect()
                }
                SectionNumber::Level(place) if assessment.case.wave.is_none() => {
                    match (section.levels[*place].is_water, section.levels[*place].side) {
                        (false, _) => Vec::new(),
                        (true, Side::Left) => vec![Key::WaterLeft.into()],
                        (true, Side::Right) => vec![Key::WaterRight.into(), Key::Level.into()],
                    }
                }
                SectionNumber::Arrow(index) => force(*index).into_iter().collect(),
                SectionNumber::Friction => vec![Key::Friction.into()],
                SectionNumber::Ground => vec![Key::GroundAngle.into(), Key::Strength.into()],
                _ => Vec::new(),
            };
            numbers.extend(ids.into_iter().map(|id| (id, *rect)));
        }
        let forces = picture.arrows.iter().filter_map(|arrow| Some((force(arrow.index)?, *arrow))).collect();
        let legend = picture.figure.caption().split(". ").map(str::to_owned);
        let words = legend.chain(section.notes.iter().cloned()).filter(|words| !words.is_empty()).collect();
        let pressures = (arrows.has_sums || !section.pressures.is_empty()).then_some(drawn);
        SectionOnScreen { numbers, sides, forces, words, pressures, picture }
    })
}

/// True if the plane of the rising loads is that of a situation: loads rise on one body.
pub(super) fn has_load_plane(assessed: &Assessed) -> bool {
    assessed.rises() && assessed.joints.is_none()
}

/// The plane of the rising loads of a situation and of its friction, up to a load factor, with a plot of some width and height; `None`
/// where no load rises, and of bodies on joints.
///
/// # Errors
/// If a number is out of range.
pub fn load_plane_on_screen(
    assessed: &Assessed,
    title: &str,
    up_to: f64,
    plot: (f64, f64),
) -> Result<Option<Picture>, InputError> {
    load_plane_on_screen_beside(assessed, title, None, up_to, plot)
}

/// The same with the boundaries of another situation in dashes; it goes as far as the full load of that.
///
/// # Errors
/// If a number is out of range.
pub fn load_plane_on_screen_beside(
    assessed: &Assessed,
    title: &str,
    pinned: Option<PinnedLoad<'_>>,
    up_to: f64,
    plot: (f64, f64),
) -> Result<Option<Picture>, InputError> {
    has_load_plane(assessed)
        .then(|| {
            with_load_plane(assessed, title, with_room(up_to, pinned), |plane| {
                standfast_figures::load_plane_on_screen_beside(plane, pinned, plot)
            })
        })
        .transpose()
}
