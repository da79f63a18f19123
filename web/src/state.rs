//! State of the explorer: a body, a force, water and uplift beside it, a view, a figure.

use standfast::loads::{HorizontalForce, Reduced};
use standfast::{Body, Diagram, Point};
use standfast_figures::{FigureId, View};

use crate::loads::{self, Waters};
use crate::unit::Units;

/// g, m/s².
pub const GRAVITY: f64 = 9.81;

/// The state of the page; everything a link keeps.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    /// γ.
    pub slenderness: f64,
    /// k'.
    pub elevation: f64,
    /// k.
    pub force: f64,
    /// μ.
    pub friction: f64,
    /// True if the force points right.
    pub mirrored: bool,
    /// 2B, m.
    pub width: f64,
    /// m, kg per metre run.
    pub mass: f64,
    /// The part of the plane shown; without one, what shows all.
    pub view: Option<View>,
    /// The figure of the report shown in place of the map of all modes.
    pub figure: Option<FigureId>,
    /// Water and uplift beside the force.
    pub waters: Waters,
    /// The units of the fields.
    pub units: Units,
}

impl Default for State {
    /// Nearly the caisson of `examples/caisson-in-air.toml`, hit near the crest.
    fn default() -> State {
        State {
            slenderness: 0.8,
            elevation: 0.9,
            force: 0.8,
            friction: 0.6,
            mirrored: false,
            width: 15.0,
            mass: 378e3,
            view: None,
            figure: None,
            waters: Waters::default(),
            units: Units::default(),
        }
    }
}

impl State {
    /// The point of the report's problem. The fields only take what makes one.
    pub fn point(&self) -> Point {
        Point::new(self.slenderness, self.elevation, self.force, self.friction)
            .unwrap_or_else(|_| State::default().point())
    }

    /// The point of the force alone, with its direction.
    pub fn reduced(&self) -> Reduced {
        Reduced { point: self.point(), mirrored: self.mirrored }
    }

    /// The point of all loads: of the force, or in effective coordinates where water or uplift act as well; `None` where
    /// these have no point.
    pub fn all_loads(&self) -> Option<Reduced> {
        if self.waters.are_none() { Some(self.reduced()) } else { loads::effective(self) }
    }

    /// The diagram shown: that of all loads, or of the body of the report's figure chosen.
    pub fn diagram(&self) -> Option<Diagram> {
        let shown = if self.figure.is_some() { Some(self.reduced()) } else { self.all_loads() };
        shown.map(|reduced| Diagram::of(reduced.point.chart()))
    }

    /// The point in the diagram shown. A figure of the report is of a force alone, so with water it has none.
    pub fn design_point(&self) -> Option<Reduced> {
        self.all_loads().filter(|_| self.figure.is_none() || self.waters.are_none())
    }

    /// Changes force and friction so that the point in the diagram shown comes to (k, μ), to the precision of a step of
    /// either; as near as a force that keeps its direction brings it.
    pub fn place(&mut self, (k, mu): (f64, f64), (k_step, mu_step): (f64, f64)) {
        if self.design_point().is_none() {
            return;
        }
        let (k, k_step) = match self.waters.are_none() {
            true => (k, k_step),
            false => loads::force_for(self, k, k_step).unwrap_or((self.force, k_step)),
        };
        self.force = rounded(k, k_step);
        self.friction = rounded(mu, mu_step);
    }

    /// The real body and the force on it, if its dimensions are within range.
    pub fn real(&self) -> Option<(Body, HorizontalForce)> {
        self.reduced().with_size(self.width, self.mass, GRAVITY).ok()
    }

    /// The view in use.
    pub fn view(&self, diagram: &Diagram) -> View {
        self.view.filter(View::is_drawable).unwrap_or_else(|| {
            let of_figure = self.figure.filter(|id| id.body() == Some((self.slenderness, self.elevation)));
            let view = of_figure.and_then(View::of_figure);
            let k = self.design_point().map_or(self.force, |reduced| reduced.point.k());
            drawable(view.unwrap_or_else(|| View::of(diagram, k, self.friction)))
        })
    }

    /// The view that the diagram of the force alone would have.
    pub fn force_view(&self) -> View {
        let diagram = Diagram::of(self.point().chart());
        match self.waters.are_none() {
            true => self.view(&diagram),
            false => drawable(View::of(&diagram, self.force, self.friction)),
        }
    }

    /// Takes another γ and k'. A figure of the report shows its own body only.
    pub fn set_body(&mut self, slenderness: f64, elevation: f64) {
        (self.slenderness, self.elevation) = (slenderness, elevation);
        self.figure = None;
    }

    /// Shows a figure of the report, its body and a point in the middle of its window; or the map of all modes.
    pub fn show_figure(&mut self, figure: Option<FigureId>) {
        self.figure = figure;
        self.view = None;
        let shown = figure.and_then(|id| Some((id.body()?, View::of_figure(id)?)));
        if let Some(((slenderness, elevation), view)) = shown {
            (self.slenderness, self.elevation) = (slenderness, elevation);
            // One that the figure shades, if the middle is.
            self.force = round_digits(0.5 * view.k_max, 2);
            self.friction = round_digits(0.35 * view.mu_max, 2);
        }
    }
}

/// The view, or a plain one in its place.
fn drawable(view: View) -> View {
    if view.is_drawable() { view } else { View { k_min: 0.0, k_max: 1.0, mu_min: 0.0, mu_max: 1.0 } }
}

/// A number rounded to some significant digits.
pub fn round_digits(number: f64, digits: usize) -> f64 {
    format!("{number:.*e}", digits.saturating_sub(1)).parse().unwrap_or(number)
}

/// A value with no more decimals than its step deserves.
pub fn rounded(value: f64, step: f64) -> f64 {
    let decimals = (-step.log10()).ceil().clamp(0.0, 12.0);
    let power = 10f64.powf(decimals);
    ((value * power).round() / power).max(0.0)
}
