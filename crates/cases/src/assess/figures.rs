//! The figures of a case.

use standfast::contact::stack::plane::StackPlane;
use standfast::ground::bearing::BearingPlane;
use standfast::ground::load_plane::GroundLoadPlane;
use standfast::ground::strength::CrushMap;
use standfast::{Diagram, InputError};
use standfast_figures::{
    DesignPoint, DiagramContent, KMuPlane, LoadPlane, RotationCurve, StackMap, diagram_with, load_plane,
    rotation_curve, stack_map,
};

use super::{Assessed, Assessment, AssessmentView, section};
use crate::case::Limit;
use crate::directions;
use crate::document::AnswerFigure;
use crate::layout::digits;

/// A k–μ diagram and the loads in it.
struct Plane {
    gamma: f64,
    k_prime: f64,
    in_air: bool,
    /// The base, where it does not bear everything.
    base: Option<Base>,
    /// The place of the first load.
    first: usize,
    points: Vec<DesignPoint>,
}

/// A base that does not bear everything, in the plane of a load.
#[derive(Clone, Copy, PartialEq)]
enum Base {
    /// It crushes, with ω.
    Crushing(f64),
    /// The ground fails.
    Failing(BearingPlane),
}

impl Base {
    /// The base of a situation at a point of the report's plane; `Err` where it carries nothing, and there is no plane.
    fn of(assessed: &Assessed, gamma: f64, k_prime: f64) -> Result<Option<Base>, InputError> {
        let Some(ground) = &assessed.ground else { return Ok(None) };
        Ok(match (ground.limit, ground.omega, &ground.reaction) {
            (Some(Limit::Strength(_)), Some(omega), _) => Some(Base::Crushing(omega)),
            (Some(Limit::Ground(soil)), _, Some(reaction)) => {
                let plane = BearingPlane::new(soil, gamma, k_prime, reaction.half_width(), reaction.p())?;
                Some(Base::Failing(plane))
            }
            _ => None,
        })
    }
}

/// The figures of the situations shown, and the section of the case.
pub(super) fn all(assessment: &Assessment, view: &AssessmentView) -> Result<Vec<AnswerFigure>, InputError> {
    of(assessment, super::shown(assessment, view), view.up_to)
}

/// The figures of some situations, loads followed up to a multiple of the full load, and the section of the case.
pub(super) fn of(
    assessment: &Assessment,
    mut shown: Vec<&Assessed>,
    up_to: f64,
) -> Result<Vec<AnswerFigure>, InputError> {
    // In the order of the case, as the files are named.
    shown.sort_by_key(|assessed| assessed.index);
    let planes = planes(assessment, &shown)?;
    let several = assessment.all.len() > 1;
    let mut figures = Vec::new();
    for (i, assessed) in shown.iter().enumerate() {
        let suffix = if several { format!("-{}", assessed.index + 1) } else { String::new() };
        if let Some(plane) = planes.iter().find(|plane| plane.first == i) {
            figures.extend(plane.draw(&suffix)?);
        }
        // In air the load factor is k, and the k–μ diagram shows the path.
        // Where water follows an opening, it is another for every load factor.
        // Nor does the plane know what holds a body beside friction.
        // Both are of one body.
        let bends = assessed.situation.opens_up_to(up_to)
            || assessed.outcome.held.is_some()
            || assessed.joints.is_some()
            || assessed.outcome.plan.is_some();
        if assessed.rises() && assessed.situation.in_air().is_none() && !bends {
            figures.push(path(assessment, assessed, &suffix, up_to)?);
        }
        figures.extend(rotation(assessment, assessed, &suffix)?);
        figures.extend(of_joints(assessment, assessed, &suffix, up_to));
        figures.extend(directions::of_assessed(assessment, assessed, &suffix));
    }
    figures.push(AnswerFigure {
        suffix: "-section".to_owned(),
        words: "Section".to_owned(),
        figure: section::figure(assessment)?,
    });
    Ok(figures)
}

/// The diagrams, each with the loads of one k'.
fn planes(assessment: &Assessment, shown: &[&Assessed]) -> Result<Vec<Plane>, InputError> {
    let mut planes: Vec<Plane> = Vec::new();
    for (i, assessed) in shown.iter().enumerate() {
        let one_body = assessed.joints.is_none();
        let Some(reduced) = assessed.outcome.full.effective.as_ref().filter(|_| one_body) else { continue };
        let point = &reduced.point;
        let in_air = assessed.situation.in_air().is_some();
        let label = assessment.name(assessed).unwrap_or_else(|| "full load".to_owned());
        let design = DesignPoint { k: point.k(), mu: point.mu(), label, mirrored: reduced.mirrored };
        let base = Base::of(assessed, point.gamma(), point.k_prime())?;
        let is_it = |plane: &&mut Plane| {
            (plane.gamma, plane.k_prime, plane.in_air, plane.base)
                == (point.gamma(), point.k_prime(), in_air, base)
        };
        match planes.iter_mut().find(is_it) {
            Some(plane) => plane.points.push(design),
            None => {
                let (gamma, k_prime) = (point.gamma(), point.k_prime());
                planes.push(Plane { gamma, k_prime, in_air, base, first: i, points: vec![design] });
            }
        }
    }
    Ok(planes)
}

impl Plane {
    /// The diagram; none of a base that cannot carry the weight.
    fn draw(&self, suffix: &str) -> Result<Option<AnswerFigure>, InputError> {
        let gamma = self.gamma;
        let content = DiagramContent { points: &self.points, ..DiagramContent::default() };
        let plane = match self.base {
            None => KMuPlane::Rigid(Diagram::new(gamma, self.k_prime)?),
            Some(Base::Crushing(omega)) if omega >= 1.0 => return Ok(None),
            Some(Base::Crushing(omega)) => KMuPlane::Crushing(CrushMap::new(gamma, self.k_prime, omega)?),
            Some(Base::Failing(plane)) => KMuPlane::Failing(plane),
        };
        let figure = diagram_with(&plane, &content);
        let words = match (self.in_air, suffix.is_empty()) {
            (false, true) => "k–μ diagram in effective coordinates".to_owned(),
            (false, false) => {
                let names: Vec<_> = self.points.iter().map(|point| point.label.as_str()).collect();
                format!("k–μ diagram in effective coordinates ({})", names.join("; "))
            }
            (true, true) => "Diagram".to_owned(),
            (true, false) => format!("Diagram for k' = {}", digits(self.k_prime)),
        };
        let words = match self.base {
            None => words,
            Some(Base::Crushing(_)) => words + ", of a base that crushes",
            Some(Base::Failing(_)) => words + ", of ground that fails",
        };
        Ok(Some(AnswerFigure { suffix: suffix.to_owned(), words, figure }))
    }
}

/// The name of the case and of a situation.
pub(super) fn title(assessment: &Assessment, assessed: &Assessed) -> String {
    let parts: Vec<_> = assessment.case.title.iter().cloned().chain(assessment.name(assessed)).collect();
    parts.join(", ")
}

/// Words with the situation's name behind them, where there are several.
fn named(words: &str, assessment: &Assessment, assessed: &Assessed, suffix: &str) -> String {
    match (suffix.is_empty(), assessment.name(assessed)) {
        (false, Some(name)) => format!("{words} ({name})"),
        _ => words.to_owned(),
    }
}

/// Moment and rotation of an elastic base; none of a base that cannot carry the weight.
fn rotation(
    assessment: &Assessment,
    assessed: &Assessed,
    suffix: &str,
) -> Result<Option<AnswerFigure>, InputError> {
    let Some(elastic) = assessed.ground.as_ref().and_then(|ground| ground.elastic.as_ref()) else {
        return Ok(None);
    };
    let figure = rotation_curve(&RotationCurve {
        base: elastic.base,
        height: assessed.situation.body().centroid_height(),
        moment: elastic.moment,
        title: &title(assessment, assessed),
    })?;
    Ok(figure.map(|figure| AnswerFigure {
        suffix: format!("{suffix}-rotation"),
        words: named("Moment and rotation", assessment, assessed, suffix),
        figure,
    }))
}

/// Which joint leaves rest first, and what all of them begin with at once, over load factor and friction; none on a base with more to it than
/// friction.
fn of_joints(assessment: &Assessment, assessed: &Assessed, suffix: &str, up_to: f64) -> Vec<AnswerFigure> {
    let Some(joints) = assessed.joints.as_ref().filter(|_| assessed.rises()) else { return Vec::new() };
    let friction = assessed.situation.static_friction();
    let window = [up_to, 1.5 * friction];
    let title = title(assessment, assessed);
    let drawn = |plane: StackPlane, words: Option<Vec<String>>, (file, name, regions): (&str, &str, &str)| {
        let map = StackMap {
            plane: &plane,
            window,
            across: "load factor $λ$",
            up: "friction $μ$ of the base, that of the other joints in proportion",
            curves: &[],
            point: Some(DesignPoint { k: 1.0, mu: friction, label: "full load".to_owned(), mirrored: false }),
            regions: Some(regions),
            words: words.as_deref(),
            title: &title,
        };
        AnswerFigure {
            suffix: format!("{suffix}-{file}"),
            words: named(name, assessment, assessed, suffix),
            figure: stack_map(&map),
        }
    };
    let first = joints.departures(window).map(|plane| {
        let regions = "The joint that leaves rest first as the load rises, and how: modes from the base up.";
        let words = plane.regions.iter().map(|region| joints.moving(&region.modes)).collect();
        drawn(plane, Some(words), ("joints", "Joint that leaves rest first", regions))
    });
    let at_once = joints.all_at_once(window).map(|plane| {
        let regions = "What all joints begin with if the load is applied at once: modes from the base up, in the colour of the lowest joint that moves.";
        drawn(plane, None, ("at-once", "Joints at once", regions))
    });
    first.into_iter().chain(at_once).collect()
}

fn path(
    assessment: &Assessment,
    assessed: &Assessed,
    suffix: &str,
    up_to: f64,
) -> Result<AnswerFigure, InputError> {
    let title = title(assessment, assessed);
    let figure = with_load_plane(assessed, &title, up_to, load_plane)?;
    let words = named("Load path", assessment, assessed, suffix);
    let suffix = format!("{suffix}-path");
    Ok(AnswerFigure { suffix, words, figure })
}

/// Draws the plane of the rising loads of a situation.
pub(super) fn with_load_plane<T>(
    assessed: &Assessed,
    title: &str,
    up_to: f64,
    draw: impl FnOnce(&LoadPlane<'_>) -> T,
) -> Result<T, InputError> {
    let situation = &assessed.situation;
    let (regions, friction) = (situation.plane(up_to)?, situation.static_friction());
    let plane = match assessed.ground.as_ref().and_then(|ground| ground.limit) {
        Some(Limit::Strength(strength)) => Some(GroundLoadPlane::crushing(situation, strength, up_to)?),
        Some(Limit::Ground(soil)) => Some(GroundLoadPlane::failing(situation, soil, up_to)?),
        None => None,
    };
    Ok(draw(&LoadPlane {
        regions: &regions,
        base: plane.as_ref(),
        uncertain: assessed.ground.as_ref().and_then(|ground| {
            let factors = ground.load_factors?;
            Some([factors.less?, factors.more?])
        }),
        up_to,
        friction,
        stages: &assessed.outcome.path,
        title,
    }))
}
