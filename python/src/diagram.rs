//! The k–μ diagram as tuples and lists, which the Python class turns into arrays.

use numpy::{PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use standfast::diagram::Window;
use standfast::ground::bearing::{BearingPlane, Ground, GroundLaw};
use standfast::ground::strength::CrushMap;
use standfast::{Diagram, InputError, Point};
use standfast_figures::outlines::{Polyline, Tick};
use standfast_figures::{DesignPoint, DiagramContent, KMuPlane, axis_numbers, diagram_with, outlines};

use crate::errors::StandfastError;
use crate::invalid;

/// Value, markup, and the point whose coordinate it is.
type Ticks = Vec<(f64, String, Option<(f64, f64)>)>;

fn error(error: InputError) -> PyErr {
    invalid(error, &[])
}

/// Ground of the body: the share ω of a base that crushes, or the law of ground that fails with its share u. Both none: rigid.
#[derive(FromPyObject)]
pub(crate) struct Base {
    #[pyo3(item)]
    omega: Option<f64>,
    #[pyo3(item)]
    law: Option<String>,
    #[pyo3(item)]
    share: f64,
}

/// The plane of the body on its base.
fn plane(gamma: f64, k_prime: f64, base: &Base) -> PyResult<KMuPlane> {
    if let Some(law) = &base.law {
        return failing(gamma, k_prime, law, base.share).map(KMuPlane::Failing);
    }
    match base.omega {
        Some(omega) if omega != 0.0 => CrushMap::new(gamma, k_prime, omega).map(KMuPlane::Crushing),
        _ => Diagram::new(gamma, k_prime).map(KMuPlane::Rigid),
    }
    .map_err(error)
}

/// The plane of ground that fails by a law of this name.
fn failing(gamma: f64, k_prime: f64, law: &str, share: f64) -> PyResult<BearingPlane> {
    let ground = match law {
        "ec7" => Ground::new(GroundLaw::Ec7, 35.0, 1.0),
        "hansen" => Ground::new(GroundLaw::Hansen, 35.0, 1.0),
        "envelope" => Ground::envelope(1.0),
        _ => {
            return Err(StandfastError::new_err(format!("law is {law:?}; expected ec7, hansen or envelope")));
        }
    };
    BearingPlane::of_share(ground.map_err(error)?, gamma, k_prime, share).map_err(error)
}

/// The codes at rows of (k, μ) on ground that fails.
#[pyfunction]
pub(crate) fn failing_modes(
    gamma: f64,
    k_prime: f64,
    law: &str,
    share: f64,
    places: PyReadonlyArray2<f64>,
) -> PyResult<Vec<u8>> {
    let plane = failing(gamma, k_prime, law, share)?;
    let rows = places.as_array();
    let code = |(i, row): (usize, numpy::ndarray::ArrayView1<'_, f64>)| {
        let point = plane.at(row[0], row[1]).map_err(|error| invalid(error, &[i]))?;
        Ok(point.verdict.code())
    };
    rows.rows().into_iter().enumerate().map(code).collect()
}

/// A body with its points: rows of (k, μ), of which the first have names and the others are a cloud.
struct Marked {
    plane: KMuPlane,
    window: Option<Window>,
    named: Vec<DesignPoint>,
    cloud: Vec<(f64, f64)>,
}

impl Marked {
    /// Refuses a body, or a point, that there cannot be.
    fn new(
        gamma: f64,
        k_prime: f64,
        base: &Base,
        window: Option<(f64, f64)>,
        places: &PyReadonlyArray2<f64>,
        names: Vec<String>,
    ) -> PyResult<Marked> {
        let plane = plane(gamma, k_prime, base)?;
        let count = names.len();
        if places.shape()[1] != 2 || places.shape()[0] < count {
            return Err(StandfastError::new_err("expected rows of (k, μ), at least one for each name"));
        }
        let mut rows: Vec<(f64, f64)> = Vec::with_capacity(places.shape()[0]);
        for (i, row) in places.as_array().rows().into_iter().enumerate() {
            let (k, mu) = (row[0], row[1]);
            Point::new(gamma, k_prime, k, mu).map_err(|error| match names.get(i) {
                Some(name) => StandfastError::new_err(format!("point {name:?}: {error}")),
                None => invalid(error, &[i - count]),
            })?;
            rows.push((k, mu));
        }
        let cloud = rows.split_off(count);
        let named = names.into_iter().zip(rows);
        let named = named.map(|(label, (k, mu))| DesignPoint { k, mu, label, mirrored: false }).collect();
        Ok(Marked { plane, window: window.map(|(k, mu)| Window { k, mu }), named, cloud })
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
    base: Base,
    window: Option<(f64, f64)>,
    places: PyReadonlyArray2<'py, f64>,
    names: Vec<String>,
) -> PyResult<Bound<'py, PyDict>> {
    let marked = Marked::new(gamma, k_prime, &base, window, &places, names)?;
    let shown = outlines(&marked.plane, &marked.content());
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
    found.set_item("rigid", shown.rigid)?;
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
    base: Base,
    window: Option<(f64, f64)>,
    places: PyReadonlyArray2<f64>,
    names: Vec<String>,
) -> PyResult<String> {
    let marked = Marked::new(gamma, k_prime, &base, window, &places, names)?;
    Ok(diagram_with(&marked.plane, &marked.content()).svg().to_owned())
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
