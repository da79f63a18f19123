//! The k–μ diagram as tuples and lists, which the Python class turns into arrays.

use pyo3::prelude::*;
use pyo3::types::PyDict;
use standfast::diagram::Window;
use standfast::{Diagram, InputError};
use standfast_figures::outlines::{Polyline, Tick};
use standfast_figures::{DesignPoint, diagram, outlines};

use crate::invalid;

/// Value, markup, and the point whose coordinate it is.
type Ticks = Vec<(f64, String, Option<(f64, f64)>)>;

fn new(gamma: f64, k_prime: f64) -> PyResult<Diagram> {
    Diagram::new(gamma, k_prime).map_err(error)
}

fn error(error: InputError) -> PyErr {
    invalid(error, &[])
}

/// Everything a diagram shows, by name; see `standfast_figures::outlines`.
#[pyfunction]
pub(crate) fn diagram_outlines<'py>(
    py: Python<'py>,
    gamma: f64,
    k_prime: f64,
    window: Option<(f64, f64)>,
) -> PyResult<Bound<'py, PyDict>> {
    let shown = outlines(&new(gamma, k_prime)?, window.map(|(k, mu)| Window { k, mu }));
    let areas: Vec<(u8, &str, &str, Vec<Polyline>)> = shown
        .areas
        .into_iter()
        .map(|area| (area.mode.code(), area.symbol, area.tint, area.polygons))
        .collect();
    let unresolved: Vec<(&str, u8, u16, Vec<Polyline>)> = shown
        .unresolved
        .into_iter()
        .map(|part| (part.name, part.resolved_as.code(), part.modes.bits(), part.polygons))
        .collect();
    let lines: Vec<(&str, &str, bool, Vec<Polyline>)> =
        shown.lines.into_iter().map(|line| (line.name, line.formula, line.dashed, line.parts)).collect();
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

/// The diagram as an SVG document, with design points (k, μ, label); and its title and caption.
#[pyfunction]
pub(crate) fn diagram_svg(
    gamma: f64,
    k_prime: f64,
    points: Vec<(f64, f64, String)>,
) -> PyResult<(String, String, String)> {
    let points: Vec<DesignPoint> =
        points.into_iter().map(|(k, mu, label)| DesignPoint { k, mu, label, mirrored: false }).collect();
    let figure = diagram(&new(gamma, k_prime)?, &points);
    Ok((figure.svg().to_owned(), figure.title().to_owned(), figure.caption().to_owned()))
}
