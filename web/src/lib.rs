//! The explorer: what its page asks of the library.
//!
//! The page's scripts hold no mechanics and no state. They hand over what a person does (a slider moved, a place in the
//! diagram pressed) and show what comes back: drawings of `standfast-figures`, readings of `standfast`.
//!
//! | question | module |
//! |---|---|
//! | What is shown, and how is it shared as a link? | `state`, `fragment` |
//! | What does a person type, in which unit? | `field`, `number`, `unit` |
//! | What loads are there, and when does the body first leave rest? | `loads` |
//! | What does the body do under all of them? | `answer` |
//! | What does the page say? | `reading`, `verdict`, `text` |
//!
//! Everything but this file runs, and is tested, without wasm.

#![forbid(unsafe_code)]

mod answer;
mod field;
mod fragment;
mod loads;
mod number;
mod reading;
mod state;
mod text;
mod unit;
mod verdict;

use standfast_figures as figures;
use wasm_bindgen::prelude::wasm_bindgen;

pub use field::Field;
pub use loads::Waters;
pub use state::State;

/// The explorer behind the page. Methods that draw return SVG; `reading` returns JSON.
#[wasm_bindgen]
#[derive(Debug, Default)]
pub struct Explorer {
    state: State,
    map: Option<figures::Picture>,
    cases: Option<figures::Picture>,
}

#[wasm_bindgen]
impl Explorer {
    /// An explorer in the state that a link's fragment describes; what the fragment lacks is as at first.
    #[wasm_bindgen(constructor)]
    pub fn new(fragment: &str) -> Explorer {
        Explorer { state: fragment::parse(fragment), ..Explorer::default() }
    }

    /// The state as a link's fragment.
    pub fn fragment(&self) -> String {
        fragment::write(&self.state)
    }

    /// The k–μ diagram, `width` by `height` units; a sketch of the report if one is chosen. Empty where the loads are no
    /// point of the plane.
    pub fn map(&mut self, width: f64, height: f64) -> String {
        if let Some(sketch) = self.state.figure.and_then(figures::sketch_on_screen) {
            self.map = None;
            return sketch.svg().to_owned();
        }
        self.map = self.with_map((width, height), |map| map.on_screen());
        self.map.as_ref().map_or(String::new(), |picture| picture.figure.svg().to_owned())
    }

    /// Picture in fixed colours with the design point, for a file.
    pub fn map_on_paper(&self, width: f64, height: f64) -> String {
        if let Some(id) = self.state.figure.filter(|id| id.body().is_none()) {
            return figures::report_figure(id).svg().to_owned();
        }
        // Outside every view where the loads have no place in a figure of the report.
        let (k, mu, mirrored) = self
            .state
            .design_point()
            .map_or((-1.0, -1.0, false), |reduced| (reduced.point.k(), reduced.point.mu(), reduced.mirrored));
        // The axis has the words of a force alone.
        let label = if self.state.waters.are_none() { "" } else { "all loads, effective k" }.to_owned();
        let point = figures::DesignPoint { k, mu, label, mirrored };
        self.with_map((width, height), |map| map.on_paper(&point).svg().to_owned()).unwrap_or_default()
    }

    /// The curves and named points of the diagram as CSV.
    pub fn curves_csv(&self) -> String {
        self.with_map((600.0, 450.0), text::curves_csv).unwrap_or_default()
    }

    /// Place of the design point in the diagram last drawn, as [x, y, 1 if in the plot]; empty without one.
    pub fn point_in_map(&self) -> Vec<f64> {
        let shown = self.map.as_ref().zip(self.state.design_point());
        shown.map_or(Vec::new(), |(map, reduced)| {
            let place = map.place(reduced.point.k(), reduced.point.mu());
            let (x, y) = (place.0.clamp(map.plot.x0, map.plot.x1), place.1.clamp(map.plot.y0, map.plot.y1));
            vec![x, y, f64::from(u8::from(place == (x, y)))]
        })
    }

    /// Moves the design point to a place in the diagram last drawn, by another force and friction.
    pub fn move_point(&mut self, x: f64, y: f64) {
        if let Some(map) = &self.map {
            let Some(inside) = inside(map, x, y) else { return };
            let (k, mu) = map.values(inside.0, inside.1);
            let step = |axis: figures::Axis, length: f64| (axis.to - axis.from) / length;
            let plot = map.plot;
            let steps = (step(map.across, plot.x1 - plot.x0), step(map.up, plot.y1 - plot.y0));
            self.state.place((k, mu), steps);
        }
    }

    /// Moves the design point by shares of the diagram's width and height.
    pub fn nudge_point(&mut self, right: f64, up: f64) {
        let Some(((_, view), reduced)) = self.shown().zip(self.state.design_point()) else { return };
        let (across, along) = (view.k_max - view.k_min, view.mu_max - view.mu_min);
        let k = (reduced.point.k() + right * across).max(0.0);
        let mu = (self.state.friction + up * along).max(0.0);
        self.state.place((k, mu), (across / 500.0, along / 500.0));
    }

    /// Zooms the diagram about a place in it, or about the middle of the plot without one.
    pub fn zoom(&mut self, factor: f64, x: Option<f64>, y: Option<f64>) {
        if let (Some(map), Some((_, view))) = (&self.map, self.shown()) {
            let middle = ((map.plot.x0 + map.plot.x1) / 2.0, (map.plot.y0 + map.plot.y1) / 2.0);
            let (k, mu) = map.values(x.unwrap_or(middle.0), y.unwrap_or(middle.1));
            self.state.view = Some(view.zoomed(factor, k, mu));
        }
    }

    /// Moves the view by units of the diagram, to the right and downwards.
    pub fn pan(&mut self, right: f64, down: f64) {
        if let (Some(map), Some((_, view))) = (&self.map, self.shown()) {
            let (width, height) = (map.plot.x1 - map.plot.x0, map.plot.y1 - map.plot.y0);
            self.state.view = Some(view.moved(-right / width, down / height));
        }
    }

    /// Keeps the view as it is while the design point is dragged. Says whether it was free to change.
    pub fn hold_view(&mut self) -> bool {
        let free = self.state.view.is_none();
        self.state.view = self.shown().map(|(_, view)| view);
        free
    }

    /// Shows all again.
    pub fn reset_view(&mut self) {
        self.state.view = None;
    }

    /// The γ–k' map of cases.
    pub fn cases(&mut self, width: f64, height: f64) -> String {
        let diagram = standfast::Diagram::of(self.state.point().chart());
        let picture = figures::cases_on_screen(diagram.chart(), (width, height));
        let svg = picture.figure.svg().to_owned();
        self.cases = Some(picture);
        svg
    }

    /// Place of the body in the map of cases last drawn, as [x, y].
    pub fn point_in_cases(&self) -> Vec<f64> {
        self.cases.as_ref().map_or(Vec::new(), |map| {
            let (x, y) = map.place(self.state.slenderness, self.state.elevation);
            vec![x.clamp(map.plot.x0, map.plot.x1), y.clamp(map.plot.y0, map.plot.y1)]
        })
    }

    /// Takes the body at a place in the map of cases last drawn.
    pub fn pick_case(&mut self, x: f64, y: f64) {
        if let Some(map) = &self.cases {
            let Some(inside) = inside(map, x, y) else { return };
            let (gamma, k_prime) = map.values(inside.0, inside.1);
            self.state.set_body(state::round_digits(gamma, 3), (k_prime * 100.0).round() / 100.0 + 0.0);
        }
    }

    /// The body with its forces and accelerations; empty where the loads are not one horizontal force.
    pub fn free_body(&self, width: f64, height: f64) -> String {
        self.body((width, height)).map_or(String::new(), |(figure, _)| figure.svg().to_owned())
    }

    /// Pose to which its motion leads, exaggerated: pivot x, y, shift and turn in degrees; empty without a drawing.
    pub fn pose(&self, width: f64, height: f64) -> Vec<f64> {
        self.body((width, height))
            .map_or(Vec::new(), |(_, pose)| vec![pose.pivot.0, pose.pivot.1, pose.shift, pose.turn])
    }

    /// Everything the panel says, as JSON.
    pub fn reading(&self) -> String {
        serde_json::to_string(&reading::Reading::of(&self.state)).unwrap_or_default()
    }

    /// The load path with water and uplift, as JSON with its drawing; `across` is the width of the plot.
    pub fn load_path(&self, across: f64) -> String {
        serde_json::to_string(&loads::LoadPath::of(&self.state, across)).unwrap_or_default()
    }

    /// Takes what was typed into a field. Returns what is wrong with it, if anything is.
    pub fn set(&mut self, field: &str, typed: &str) -> Option<String> {
        match Field::named(field) {
            Some(field) => field.set(&mut self.state, typed).err(),
            None => Some(format!("there is no field {field:?}")),
        }
    }

    /// Takes a slider's place, from 0 to 1.
    pub fn slide(&mut self, field: &str, share: f64) {
        if let Some(field) = Field::named(field) {
            field.slide(&mut self.state, share);
        }
    }

    /// Takes a unit for a field's kind of quantity.
    pub fn set_unit(&mut self, quantity: &str, unit: &str) {
        unit::choose(&mut self.state.units, quantity, unit);
    }

    /// Sets the force to point right or left.
    pub fn set_mirrored(&mut self, mirrored: bool) {
        self.state.mirrored = mirrored;
    }

    /// Shows a figure of the report, by its number; the map of all modes if there is none of that number.
    pub fn show_figure(&mut self, number: &str) {
        self.state.show_figure(number.parse().ok());
    }

    /// Numbers and captions of the report's figures, as JSON.
    pub fn figure_list() -> String {
        let list: Vec<_> = figures::FigureId::ALL.map(|id| (id.number(), id.caption())).into();
        serde_json::to_string(&list).unwrap_or_default()
    }

    /// The type that the figures are set in, as a TrueType font.
    pub fn font(italic: bool) -> Vec<u8> {
        if italic { figures::ITALIC_FONT } else { figures::UPRIGHT_FONT }.to_vec()
    }
}

impl Explorer {
    /// The diagram shown, and the part of it that is seen.
    fn shown(&self) -> Option<(standfast::Diagram, figures::View)> {
        let diagram = self.state.diagram()?;
        let view = self.state.view(&diagram);
        Some((diagram, view))
    }

    fn with_map<T>(&self, size: (f64, f64), draw: impl FnOnce(&figures::Map<'_>) -> T) -> Option<T> {
        let (diagram, view) = self.shown()?;
        Some(draw(&figures::Map { diagram: &diagram, figure: self.state.figure, view: &view, size }))
    }

    /// The body under all loads.
    fn body(&self, size: (f64, f64)) -> Option<(figures::Figure, figures::Pose)> {
        let reduced = self.state.all_loads()?;
        let body = figures::FreeBody { point: reduced.point, mirrored: reduced.mirrored, omega: 0.0 };
        Some(figures::free_body(&body, size))
    }
}

/// A place pulled into a plot; `None` if it is not a place.
fn inside(picture: &figures::Picture, x: f64, y: f64) -> Option<(f64, f64)> {
    let plot = picture.plot;
    (x.is_finite() && y.is_finite()).then(|| (x.clamp(plot.x0, plot.x1), y.clamp(plot.y0, plot.y1)))
}

#[cfg(test)]
mod tests {
    /// The page has the colours of the figures in both themes.
    #[test]
    fn the_page_has_the_colours_of_the_figures() {
        let style = include_str!("../page/style.css");
        let (light, dark) = style.split_once(":root[data-theme=\"dark\"]").expect("two themes");
        // Those of its own page, behind the drawings.
        for (property, on_paper, in_dark) in super::figures::colours().filter(|colour| colour.0 != "paper") {
            if light.contains(&format!("--{property}:")) {
                assert!(light.contains(&format!("--{property}: {on_paper};")), "{property}");
                assert!(dark.contains(&format!("--{property}: {in_dark};")), "{property}");
            }
        }
        for mode in standfast::Mode::ALL {
            let tint = super::figures::tint_on_screen(mode);
            let property = tint.trim_start_matches("var(").split(',').next().expect("a property");
            assert!(light.contains(property) && dark.contains(property), "{property}");
        }
    }
}
