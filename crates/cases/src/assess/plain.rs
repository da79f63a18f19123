//! A uniform body in air: each force is the report's problem.

mod json;
mod text;

use standfast::{Diagram, InputError};
use standfast_figures::{DesignPoint, diagram};

use super::{CaseFigure, load_name};
use crate::case::Case;
use crate::layout::digits;

/// A case whose forces are alternatives, grouped for their diagrams.
pub(super) struct Plain<'a> {
    case: &'a Case,
    planes: Vec<Plane>,
}

/// The loads of one elevation, which share a k–μ plane.
struct Plane {
    k_prime: f64,
    points: Vec<DesignPoint>,
}

impl<'a> Plain<'a> {
    pub(super) fn of(case: &'a Case) -> Plain<'a> {
        let mut planes: Vec<Plane> = Vec::new();
        for (i, load) in case.loads.iter().enumerate() {
            let point = &load.reduced.point;
            let design = DesignPoint {
                k: point.k(),
                mu: point.mu(),
                label: load_name(case, i),
                mirrored: load.reduced.mirrored,
            };
            match planes.iter_mut().find(|plane| plane.k_prime == point.k_prime()) {
                Some(plane) => plane.points.push(design),
                None => planes.push(Plane { k_prime: point.k_prime(), points: vec![design] }),
            }
        }
        Plain { case, planes }
    }

    pub(super) fn text(&self) -> String {
        text::render(self.case)
    }

    pub(super) fn json(&self, files: &[String]) -> String {
        json::render(self, files)
    }

    pub(super) fn figures(&self) -> Result<Vec<CaseFigure>, InputError> {
        let several = self.planes.len() > 1;
        let figures = self.planes.iter().enumerate().map(|(i, Plane { k_prime, points })| {
            let plane = Diagram::new(self.case.body.slenderness(), *k_prime)?;
            let (suffix, words) = match several {
                true => (format!("-{}", i + 1), format!("Diagram for k' = {}", digits(*k_prime))),
                false => (String::new(), "Diagram".to_owned()),
            };
            Ok(CaseFigure { suffix, words, figure: diagram(&plane, points) })
        });
        figures.collect()
    }

    /// Which of the figures shows the forces at this elevation.
    fn plane_of(&self, k_prime: f64) -> Option<usize> {
        self.planes.iter().position(|plane| plane.k_prime == k_prime)
    }
}
