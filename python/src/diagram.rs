//! The k–μ diagram as tuples and lists, which the Python class turns into arrays.

use numpy::{PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use standfast::diagram::Window;
use standfast::{Diagram, InputError, Point};
use standfast_figures::outlines::{Polyline, Tick};
use standfast_figures::{DesignPoint, DiagramContent, axis_numbers, diagram_with, outlines};

use crate::invalid;

/// Value, markup, and the point whose coordinate it is.
type Ticks = Vec<(f64, String, Option<(f64, f64)>)>;

fn error(error: InputError) -> PyErr {
    invalid(error, &[])
}

/// A body with its points: rows of (k, μ), of which the first have names and the others are a cloud.
struct Marked {
    diagram: Diagram,
    window: Option<Window>,
    named: Vec<DesignPoint>,
    cloud: Vec<(f64, f64)>,
}

impl Marked {
    /// Refuses a body, or a point, that there cannot be.
    fn new(
        gamma: f64,
        k_prime: f64,
        window: Option<(f64, f64)>,
        places: &PyReadonlyArray2<f64>,
        names: Vec<String>,
    ) -> PyResult<Marked> {
        let diagram = Diagram::new(gamma, k_prime).map_err(error)?;
        let count = names.len();
        if places.shape()[1] != 2 || places.shape()[0] < count {
            return Err(PyValueError::new_err("expected rows of (k, μ), at least one for each name"));
        }
        let mut rows: Vec<(f64, f64)> = Vec::with_capacity(places.shape()[0]);
        for (i, row) in places.as_array().rows().into_iter().enumerate() {
            let (k, mu) = (row[0], row[1]);
            Point::new(gamma, k_prime, k, mu).map_err(|error| match names.get(i) {
                Some(name) => PyValueError::new_err(format!("point {name:?}: {error}")),
                None => invalid(error, &[i - count]),
            })?;
            rows.push((k, mu));
        }
        let cloud = rows.split_off(count);
        let named = names.into_iter().zip(rows);
        let named = named.map(|(label, (k, mu))| DesignPoint { k, mu, label, mirrored: false }).collect();
        Ok(Marked { diagram, window: window.map(|(k, mu)| Window { k, mu }), named, cloud })
    }

    fn content(&self) -> DiagramContent<'_> {
        DiagramContent { window: self.window, points: &self.named, cloud: &self.cloud }
    }
}

/// Everything a diagram shows, by name; see `standfast_figures::outlines`.
#[pyfunction]
pub(crate) fn diagram_outlines<'py>(
    py: Python<'py>,
    gamma: f64,
    k_prime: f64,
    window: Option<(f64, f64)>,
    places: PyReadonlyArray2<'py, f64>,
    names: Vec<String>,
) -> PyResult<Bound<'py, PyDict>> {
    let marked = Marked::new(gamma, k_prime, window, &places, names)?;
    let shown = outlines(&marked.diagram, &marked.content());
    let areas: Vec<(u8, &str, &str, Vec<Polyline>)> = shown
        .areas
        .into_iter()
        .map(|area| (area.verdict.code(), area.symbol, area.tint, area.polygons))
        .collect();
    let unresolved: Vec<(&str, u8, u16, Vec<Polyline>)> = shown
        .unresolved
        .into_iter()
        .map(|part| (part.name, part.resolved_as.code(), part.modes.bits(), part.polygons))
        .collect();
    let lines: Vec<(&str, &str, &str, bool, Vec<Polyline>)> = shown
        .lines
        .into_iter()
        .map(|line| (line.name, line.formula, line.short, line.dashed, line.parts))
        .collect();
    let points: Vec<(&str, String, f64, f64)> =
        shown.points.into_iter().map(|point| (point.letter, point.markup, point.k, point.mu)).collect();
    let ticks = |ticks: Vec<Tick>| -> Ticks {
        ticks.into_iter().map(|tick| (tick.at, tick.markup, tick.of)).collect()
    };
    let found = PyDict::new(py);
    found.set_item("window", (shown.window.k, shown.window.mu))?;
    found.set_item("areas", areas)?;
    found.set_item("unresolved", unresolved)?;
    found.set_item("lines", lines)?;
    found.set_item("points", points)?;
    found.set_item("k_marks", ticks(shown.k_marks))?;
    found.set_item("mu_marks", ticks(shown.mu_marks))?;
    Ok(found)
}

/// The diagram as an SVG document; rows of (k, μ) are its points, of which the first have names.
#[pyfunction]
pub(crate) fn diagram_svg(
    gamma: f64,
    k_prime: f64,
    window: Option<(f64, f64)>,
    places: PyReadonlyArray2<f64>,
    names: Vec<String>,
) -> PyResult<String> {
    let marked = Marked::new(gamma, k_prime, window, &places, names)?;
    Ok(diagram_with(&marked.diagram, &marked.content()).svg().to_owned())
}

/// The round numbers along an axis with their markup, and the places of smaller ticks; see `standfast_figures::axis_numbers`.
#[pyfunction]
pub(crate) fn diagram_numbers(
    from_: f64,
    to: f64,
    length: f64,
    upright: bool,
) -> (Vec<(f64, String)>, Vec<f64>) {
    let axis = axis_numbers(from_, to, length, upright);
    (axis.numbers, axis.between)
}
