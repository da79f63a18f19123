//! Stacks of bodies in pure numbers.

use pyo3::prelude::*;
use standfast::Wrench;
use standfast::contact::stack::{Joint, Shaking, Stack, StackBody};
use standfast_cases::stack::AnsweredStack;

use crate::errors::StandfastError;

/// Text and JSON document of the answers to a stack: of each body `m_x, m_y, I, x, y, X, P, M, dX, dP, dM`, of each joint `h, l, r, mu_s, mu_k`;
/// gravity, and the acceleration of the base to the right and upwards.
#[pyfunction]
pub(crate) fn stack(
    py: Python<'_>,
    bodies: Vec<[f64; 11]>,
    joints: Vec<[f64; 5]>,
    shaking: ([f64; 3], bool),
) -> PyResult<(String, String)> {
    let body =
        |[m_x, m_y, inertia, x, y, force, down, moment, d_force, d_down, d_moment]: [f64; 11]| StackBody {
            m_x,
            m_y,
            inertia,
            x,
            y,
            permanent: Wrench { x: force, p: down, m: moment },
            variable: Wrench { x: d_force, p: d_down, m: d_moment },
        };
    let joint = |[h, l, r, mu_s, mu_k]: [f64; 5]| Joint { h, l, r, mu_s, mu_k };
    let ([gravity, horizontal, vertical], permanent) = shaking;
    let stack = Stack {
        bodies: bodies.into_iter().map(body).collect(),
        joints: joints.into_iter().map(joint).collect(),
        shaking: Shaking { gravity, horizontal, vertical, permanent },
    };
    let answered = py.detach(|| AnsweredStack::of(&stack));
    let answered = answered.map_err(|error| StandfastError::new_err(error.to_string()))?;
    Ok((answered.text(), answered.json()))
}
