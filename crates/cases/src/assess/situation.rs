//! A case whose loads act together: its state under the full load, and the way there.

mod json;
mod loads;
mod sea;
mod text;
mod verdict;

pub use loads::heel_pressure;
pub use text::added_mass_notes;

use standfast::contact::path::Stage;
use standfast::{Actions, Diagram, InputError, Mode, Stability, State, first_departure};
use standfast_figures::{DesignPoint, LoadPlane, diagram, load_plane};

use super::{CaseFigure, load_name};
use crate::case::{Case, LoadedBody};
pub(super) use json::render as json;
pub(super) use text::render as text;

/// A situation with everything that is said about it.
pub struct Assessed {
    /// The body under its loads.
    pub loaded: LoadedBody,
    /// Under the full load, applied at once.
    pub full: State,
    /// The stages of the rising variable load; none without one.
    pub path: Vec<Stage>,
    /// The classical actions under the full load.
    pub actions: Actions,
    /// Safety factors and heel pressure under the full load. They mean nothing for a body that is
    /// [lifted](State::is_lifted).
    pub stability: Stability,
    /// How far the path goes, as a multiple of the full load.
    pub up_to: f64,
}

impl Assessed {
    /// The situation under its full load and on the way to `up_to` times that.
    pub(crate) fn of(loaded: LoadedBody, up_to: f64) -> Result<Assessed, InputError> {
        let situation = &loaded.situation;
        let full = situation.at(1.0)?;
        let varies = situation.loads.iter().any(|load| !load.permanent);
        let path = if varies { situation.path(up_to)? } else { Vec::new() };
        let actions = situation.actions(1.0);
        let stability = actions.stability(situation.static_friction, situation.body.base_width());
        Ok(Assessed { full, path, actions, stability, up_to, loaded })
    }

    /// Where the body first leaves rest as the variable load rises.
    pub fn departure(&self) -> Option<&Stage> {
        first_departure(&self.path)
    }

    /// The mode in which a body that left rest under the rising load comes to the full load: one that it began with it
    /// keeps for as long as it is consistent.
    fn risen(&self) -> Option<Mode> {
        let stages = self.path.iter().filter(|stage| stage.from < 1.0);
        stages.fold(None, |mode: Option<Mode>, stage| match mode {
            Some(mode) if mode != Mode::Rest && stage.modes.contains(mode) => Some(mode),
            _ => stage.mode,
        })
    }

    /// The load factor at which the body first leaves rest; infinite if it does not.
    fn first_load_factor(&self) -> f64 {
        self.departure().map_or(f64::INFINITY, |stage| stage.from)
    }

    /// The state under the full load applied at once, in sentences.
    pub fn full_load_words(&self) -> Vec<String> {
        verdict::full_load(self)
    }

    /// What happens while the variable loads rise, in sentences: where the body leaves rest, and how that differs from the
    /// full load at once.
    pub fn path_words(&self) -> Vec<String> {
        if self.path.is_empty() {
            return vec!["All loads are permanent; none rises.".to_owned()];
        }
        vec![verdict::departure(self), verdict::difference(self)]
    }

    /// Adds the figures; `suffix` tells the situation from the others of the case.
    fn draw(&self, case: &Case, suffix: &str, figures: &mut Vec<CaseFigure>) -> Result<(), InputError> {
        let name = self.loaded.load.map(|load| load_name(case, load));
        if let Some(reduced) = &self.full.effective {
            let point = &reduced.point;
            let label = name.clone().unwrap_or_else(|| "full load".to_owned());
            let design = DesignPoint { k: point.k(), mu: point.mu(), label, mirrored: reduced.mirrored };
            let plane = Diagram::new(point.gamma(), point.k_prime())?;
            figures.push(CaseFigure {
                suffix: suffix.to_owned(),
                words: "k–μ diagram in effective coordinates".to_owned(),
                figure: diagram(&plane, &[design]),
            });
        }
        if !self.path.is_empty() {
            let title: Vec<_> = case.title.iter().cloned().chain(name).collect();
            let situation = &self.loaded.situation;
            let regions = situation.plane(self.up_to)?;
            let plane = LoadPlane {
                regions: &regions,
                up_to: self.up_to,
                friction: situation.static_friction,
                stages: &self.path,
                title: &title.join(", "),
            };
            figures.push(CaseFigure {
                suffix: format!("{suffix}-path"),
                words: "Load path".to_owned(),
                figure: load_plane(&plane),
            });
        }
        Ok(())
    }
}

/// The figures of all situations of a case.
pub(super) fn figures(case: &Case, all: &[Assessed]) -> Result<Vec<CaseFigure>, InputError> {
    let several = all.len() > 1;
    let mut figures = Vec::new();
    for (i, assessed) in all.iter().enumerate() {
        let suffix = if several { format!("-{}", i + 1) } else { String::new() };
        assessed.draw(case, &suffix, &mut figures)?;
    }
    Ok(figures)
}
