//! One point explained, and the conditions of a contact mode.

use pyo3::prelude::*;
use standfast::loads::Reduced;
use standfast::relation::Relation;
use standfast::{Mode, Point, contact};
use standfast_cases::point::{self, PlacedPoint};

use crate::errors::StandfastError;
use crate::invalid;

/// Text of `standfast classify --explain`, and its JSON document; `right` says where the force points, and ω is 0 on a
/// rigid base.
#[pyfunction]
pub(crate) fn explain(
    py: Python<'_>,
    gamma: f64,
    k_prime: f64,
    k: f64,
    mu: f64,
    omega: f64,
    right: bool,
) -> PyResult<(String, String)> {
    let point = Point::new(gamma, k_prime, k, mu).map_err(|error| invalid(error, &[]))?;
    let placed = PlacedPoint::new(Reduced { point, mirrored: right }, omega);
    let placed = placed.map_err(|error| invalid(error, &[]))?;
    py.detach(|| Ok((point::text(&placed, true), point::json(&placed))))
}

/// Equation, statement, left, sign, right, holds and margin of an inequality.
type Row = (&'static str, String, f64, String, f64, bool, f64);

/// The conditions of a mode of the contact problem; of the one reported if none is named.
#[pyfunction]
pub(crate) fn contact_conditions(row: [f64; contact::INPUTS.len()], code: Option<u8>) -> PyResult<Vec<Row>> {
    let solution = contact::solve_row(row).map_err(|error| invalid(error, &[]))?;
    let Some(mode) = code.map_or(solution.mode(), Mode::from_code) else { return Ok(Vec::new()) };
    if !solution.modes.contains(mode) {
        let consistent = solution.modes;
        return Err(StandfastError::new_err(format!(
            "mode is {mode}, which is not consistent here; expected one of {consistent}"
        )));
    }
    let row = |relation: Relation| {
        let (statement, margin) = (relation.statement(), relation.margin());
        let Relation { equation, left, sign, right, holds, .. } = relation;
        (equation, statement, left, sign.to_string(), right, holds, margin)
    };
    Ok(solution.explain(mode).into_iter().map(row).collect())
}
