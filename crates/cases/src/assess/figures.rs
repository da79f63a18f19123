//! The figures of a case.

use standfast::{Diagram, InputError};
use standfast_figures::{DesignPoint, Figure, LoadPlane, diagram, load_plane};

use super::{Assessed, Assessment, View, section};
use crate::layout::digits;

/// A figure of a case.
#[derive(Debug, Clone)]
pub struct CaseFigure {
    /// What tells it from the others of the case, to be appended to a file's name; may be empty.
    pub suffix: String,
    /// What it is.
    pub words: String,
    /// What it shows.
    pub drawn: Drawn,
    /// The figure.
    pub figure: Figure,
}

/// What a figure of a case shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Drawn {
    /// The k–μ diagram, with the design points of the loads that share it.
    Diagram,
    /// The path of the rising loads in the plane of load factor and friction.
    LoadPath,
    /// The body to scale, with what stands beside it and presses on it.
    Section,
}

/// A k–μ diagram and the loads in it.
struct Plane {
    k_prime: f64,
    in_air: bool,
    /// The place of the first load.
    first: usize,
    points: Vec<DesignPoint>,
}

/// The figures of the situations shown, and the section of the case.
pub(super) fn all(assessment: &Assessment, view: &View) -> Result<Vec<CaseFigure>, InputError> {
    // In the order of the case, as the files are named.
    let mut shown = assessment.shown(view);
    shown.sort_by_key(|assessed| assessed.index);
    let planes = planes(assessment, &shown);
    let several = assessment.all.len() > 1;
    let mut figures = Vec::new();
    for (i, assessed) in shown.iter().enumerate() {
        let suffix = if several { format!("-{}", assessed.index + 1) } else { String::new() };
        if let Some(plane) = planes.iter().find(|plane| plane.first == i) {
            figures.push(plane.draw(assessment, &suffix)?);
        }
        // In air the load factor is k, and the k–μ diagram shows the path.
        if assessed.rises() && assessed.situation.in_air().is_none() {
            figures.push(path(assessment, assessed, &suffix, view.up_to)?);
        }
    }
    figures.push(CaseFigure {
        suffix: "-section".to_owned(),
        words: "Section".to_owned(),
        drawn: Drawn::Section,
        figure: section::figure(&assessment.case)?,
    });
    Ok(figures)
}

/// The diagrams, each with the loads of one k'.
fn planes(assessment: &Assessment, shown: &[&Assessed]) -> Vec<Plane> {
    let mut planes: Vec<Plane> = Vec::new();
    for (i, assessed) in shown.iter().enumerate() {
        let Some(reduced) = &assessed.outcome.full.effective else { continue };
        let point = &reduced.point;
        let in_air = assessed.situation.in_air().is_some();
        let label = assessment.name(assessed).unwrap_or_else(|| "full load".to_owned());
        let design = DesignPoint { k: point.k(), mu: point.mu(), label, mirrored: reduced.mirrored };
        match planes.iter_mut().find(|plane| plane.k_prime == point.k_prime() && plane.in_air == in_air) {
            Some(plane) => plane.points.push(design),
            None => planes.push(Plane { k_prime: point.k_prime(), in_air, first: i, points: vec![design] }),
        }
    }
    planes
}

impl Plane {
    fn draw(&self, assessment: &Assessment, suffix: &str) -> Result<CaseFigure, InputError> {
        let plane = Diagram::new(assessment.case.body.slenderness(), self.k_prime)?;
        let words = match (self.in_air, suffix.is_empty()) {
            (false, true) => "k–μ diagram in effective coordinates".to_owned(),
            (false, false) => {
                let names: Vec<_> = self.points.iter().map(|point| point.label.as_str()).collect();
                format!("k–μ diagram in effective coordinates ({})", names.join("; "))
            }
            (true, true) => "Diagram".to_owned(),
            (true, false) => format!("Diagram for k' = {}", digits(self.k_prime)),
        };
        let figure = diagram(&plane, &self.points);
        Ok(CaseFigure { suffix: suffix.to_owned(), words, drawn: Drawn::Diagram, figure })
    }
}

fn path(
    assessment: &Assessment,
    assessed: &Assessed,
    suffix: &str,
    up_to: f64,
) -> Result<CaseFigure, InputError> {
    let title: Vec<_> = assessment.case.title.iter().cloned().chain(assessment.name(assessed)).collect();
    let figure = load_plane(&LoadPlane {
        regions: &assessed.situation.plane(up_to)?,
        up_to,
        friction: assessed.situation.static_friction(),
        stages: &assessed.outcome.path,
        title: &title.join(", "),
    });
    let words = match (suffix.is_empty(), assessment.name(assessed)) {
        (false, Some(name)) => format!("Load path ({name})"),
        _ => "Load path".to_owned(),
    };
    let suffix = format!("{suffix}-path");
    Ok(CaseFigure { suffix, words, drawn: Drawn::LoadPath, figure })
}
