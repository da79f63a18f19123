//! A case whose loads act together: its state under the full load, and the way there.

mod json;
mod loads;
mod sea;
mod text;
mod verdict;

use std::path::{Path, PathBuf};

use standfast::contact::path::Stage;
use standfast::{Actions, Diagram, InputError, Mode, Stability, State, first_departure};
use standfast_figures::{DesignPoint, LoadPlane};

use super::{Answered, AssessError, Place, load_name};
use crate::args::Format;
use crate::case::{Case, LoadedBody};
use crate::draw;

/// A situation with everything that is said about it.
pub(crate) struct Assessed {
    pub(crate) loaded: LoadedBody,
    /// Under the full load, applied at once.
    pub(crate) full: State,
    /// The stages of the rising variable load; none without one.
    pub(crate) path: Vec<Stage>,
    pub(crate) actions: Actions,
    pub(crate) stability: Stability,
    /// How far the path goes.
    pub(crate) up_to: f64,
    diagrams: Vec<DrawnDiagram>,
}

/// A diagram and what it shows.
struct DrawnDiagram {
    words: &'static str,
    path: PathBuf,
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
        Ok(Assessed { full, path, actions, stability, up_to, loaded, diagrams: Vec::new() })
    }

    /// Where the body first leaves rest as the variable load rises.
    pub(crate) fn departure(&self) -> Option<&Stage> {
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

    fn draw(&mut self, case: &Case, place: &Place, number: &str) -> Result<(), AssessError> {
        let name = self.loaded.load.map(|load| load_name(case, load));
        if let Some(reduced) = &self.full.effective {
            let point = &reduced.point;
            let label = name.clone().unwrap_or_else(|| "full load".to_owned());
            let design =
                DesignPoint { k: point.force(), mu: point.friction(), label, mirrored: reduced.mirrored };
            let file = place.file(number)?;
            let diagram = Diagram::new(point.slenderness(), point.elevation())?;
            draw::draw_case(&diagram, &[design], &file)?;
            self.diagrams.push(DrawnDiagram { words: "k–μ diagram in effective coordinates", path: file });
        }
        if !self.path.is_empty() {
            let file = place.file(&format!("{number}-path"))?;
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
            draw::draw_path(&plane, &file)?;
            self.diagrams.push(DrawnDiagram { words: "Load path", path: file });
        }
        Ok(())
    }
}

/// Assesses a case whose loads act together.
pub(super) fn assess(
    case: &Case,
    path: &Path,
    directory: Option<&Path>,
    up_to: f64,
    format: Format,
) -> Result<Answered, AssessError> {
    let situations = case.situations();
    let mut all =
        situations.into_iter().map(|loaded| Assessed::of(loaded, up_to)).collect::<Result<Vec<_>, _>>()?;
    let undrawn = draw_all(case, &mut all, path, directory).err();
    let answer = match format {
        Format::Text => text::render(case, &all),
        Format::Json => json::render(case, &all),
    };
    Ok(Answered { answer, undrawn })
}

fn draw_all(
    case: &Case,
    all: &mut [Assessed],
    path: &Path,
    directory: Option<&Path>,
) -> Result<(), AssessError> {
    let place = Place::new(path, directory)?;
    let several = all.len() > 1;
    for (i, assessed) in all.iter_mut().enumerate() {
        let number = if several { format!("-{}", i + 1) } else { String::new() };
        assessed.draw(case, &place, &number)?;
    }
    Ok(())
}
