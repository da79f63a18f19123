//! Figures of a case with another one, A, in dashes behind: what they need of A, made once, and the figures for paper.

use standfast::InputError;
use standfast::loads::LoadSource;
use standfast_figures::{
    DesignPoint, DiagramContent, Figure, PinnedBody, PinnedDiagram, PinnedLoad, PinnedPlane, diagram_beside,
    load_plane_beside, section_beside,
};

use super::figures::{title, with_load_plane};
use super::screen::has_load_plane;
use super::section::{Pressures, with_section};
use super::{Assessed, Assessment};

/// The body of a case, to be drawn in dashes in the section of another.
///
/// # Errors
/// If a number is out of range.
pub fn pinned_body(assessment: &Assessment) -> Result<PinnedBody, InputError> {
    with_section(assessment, Pressures::Along, |section, _| PinnedBody::of(section))
}

/// The boundaries of the plane of a situation's rising loads, up to a load factor; `None` where no load rises.
///
/// # Errors
/// If a number is out of range.
pub fn pinned_plane(
    assessment: &Assessment,
    assessed: &Assessed,
    up_to: f64,
) -> Result<Option<PinnedPlane>, InputError> {
    let title = title(assessment, assessed);
    has_load_plane(assessed).then(|| with_load_plane(assessed, &title, up_to, PinnedPlane::of)).transpose()
}

/// The report's plane of a situation with its design point; `None` where all loads together have no point in it, or the base gives way.
pub fn pinned_diagram(assessment: &Assessment, assessed: &Assessed) -> Option<PinnedDiagram> {
    let reduced = assessed.outcome.full.effective.filter(|_| !assessed.is_on_ground())?;
    let point = &reduced.point;
    Some(PinnedDiagram {
        title: title(assessment, assessed),
        diagram: standfast::Diagram::of(point.chart()),
        k: point.k(),
        mu: point.mu(),
    })
}

/// The full load of a situation where it is one force to the side, the only load that varies; below zero to the left.
pub fn lone_force(assessed: &Assessed) -> Option<f64> {
    let mut varied = assessed.situation.loads().iter().filter(|load| !load.permanent);
    let (load, None) = (varied.next()?, varied.next()) else { return None };
    let wrench = assessed.situation.wrench_of(load);
    (load.source == LoadSource::Force && wrench.p == 0.0 && wrench.x != 0.0).then_some(wrench.x)
}

/// The full load of A as a share of that of another situation, where each is one force and both point the same way; 1 where each is followed
/// in shares of its own.
pub fn share_of(pinned: &Assessed, other: &Assessed) -> f64 {
    let forces = lone_force(pinned).zip(lone_force(other));
    forces.map(|(own, other)| own / other).filter(|share| *share > 0.0).unwrap_or(1.0)
}

/// The load factor up to which a plane is followed that shows the full load of A as well.
pub(super) fn with_room(up_to: f64, pinned: Option<PinnedLoad<'_>>) -> f64 {
    /// Farther off it would leave the plane itself no room.
    const FARTHEST: f64 = 5.0;
    let share = pinned.map_or(0.0, |pinned| pinned.share);
    if share > FARTHEST { up_to } else { up_to.max(1.12 * share) }
}

/// The section of a case on paper, with the body of A in dashes.
///
/// # Errors
/// If a number is out of range.
pub fn section_on_paper(assessment: &Assessment, pinned: &PinnedBody) -> Result<Figure, InputError> {
    with_section(assessment, Pressures::Along, |section, _| section_beside(section, Some(pinned)))
}

/// The plane of the rising loads of a situation on paper, with the boundaries of A in dashes; `None` where no load rises.
///
/// # Errors
/// If a number is out of range.
pub fn load_plane_on_paper(
    assessment: &Assessment,
    assessed: &Assessed,
    up_to: f64,
    pinned: PinnedLoad<'_>,
) -> Result<Option<Figure>, InputError> {
    let title = title(assessment, assessed);
    let draw = || {
        let up_to = with_room(up_to, Some(pinned));
        with_load_plane(assessed, &title, up_to, |plane| load_plane_beside(plane, Some(pinned)))
    };
    has_load_plane(assessed).then(draw).transpose()
}

/// The report's plane of a situation on paper, with that of A in dashes; `None` where the situation has none.
pub fn diagram_on_paper(
    assessment: &Assessment,
    assessed: &Assessed,
    pinned: &PinnedDiagram,
) -> Option<Figure> {
    let PinnedDiagram { title, diagram, k, mu, .. } = pinned_diagram(assessment, assessed)?;
    let mirrored = assessed.outcome.full.effective?.mirrored;
    let points = [DesignPoint { k, mu, label: title, mirrored }];
    let content = DiagramContent { points: &points, ..DiagramContent::default() };
    Some(diagram_beside(&diagram, &content, pinned))
}
