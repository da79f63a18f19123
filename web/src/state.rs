//! What the explorer shows: a point of the report's problem, the size of the real body, a view, a figure.

use standfast::{Body, Diagram, HorizontalForce, Point, Reduced};
use standfast_figures::{FigureId, View};

use crate::loads::Waters;
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
    /// Whether the force points right.
    pub mirrored: bool,
    /// 2B, m.
    pub width: f64,
    /// m, kg per metre run.
    pub mass: f64,
    /// The part of the plane shown; without one, what shows all.
    pub view: Option<View>,
    /// The figure of the report shown in place of the map of all modes.
    pub figure: Option<FigureId>,
    /// Water and uplift of the load path.
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

    /// The diagram of the body.
    pub fn diagram(&self) -> Diagram {
        Diagram::of(self.point().chart())
    }

    /// The point with its direction.
    pub fn reduced(&self) -> Reduced {
        Reduced { point: self.point(), mirrored: self.mirrored }
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
            let view = view.unwrap_or_else(|| View::of(diagram, self.force, self.friction));
            if view.is_drawable() { view } else { View { k_min: 0.0, k_max: 1.0, mu_min: 0.0, mu_max: 1.0 } }
        })
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
