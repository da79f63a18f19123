//! Limit states that are functions of Python.

use std::sync::Mutex;

use numpy::{AllowTypeChange, PyArray1, PyArrayLike1, PyArrayMethods};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use standfast_cases::CaseText;
use standfast_cases::random::{Effort, Method, OwnNumbers, own_laws};
use standfast_probability::form::{FormPoint, generalized};
use standfast_probability::limit_state::{Asked, LimitFunction, reliability as of_limit_state};

use crate::errors::{StandfastError, of_case};
use crate::probability::Arguments;
use crate::watch::watched;

/// A function of arrays by their names.
struct Limit {
    function: Py<PyAny>,
    /// Of its arguments, the first columns.
    names: Vec<String>,
    /// What it raised first.
    raised: Mutex<Option<PyErr>>,
}

impl Limit {
    fn called(&self, py: Python<'_>, columns: &[Vec<f64>], found: &mut [f64]) -> PyResult<()> {
        let given = PyDict::new(py);
        for (name, column) in self.names.iter().zip(columns) {
            given.set_item(name, PyArray1::from_slice(py, column))?;
        }
        let answer = self.function.bind(py).call((), Some(&given))?;
        if let Ok(one) = answer.extract::<f64>() {
            found.fill(one);
            return Ok(());
        }
        let array = answer.extract::<PyArrayLike1<'_, f64, AllowTypeChange>>().map_err(|_| {
            let kind = answer.get_type().qualname().map_or("?".to_owned(), |name| name.to_string());
            PyTypeError::new_err(format!(
                "limit_state gave a {kind}; expected an array of as many numbers as it is given, {}",
                found.len()
            ))
        })?;
        let array = array.readonly();
        let array = array.as_array();
        if array.len() != found.len() {
            let message = format!(
                "limit_state gave {} numbers; expected as many as it is given, {}",
                array.len(),
                found.len()
            );
            return Err(PyTypeError::new_err(message));
        }
        found.iter_mut().zip(&array).for_each(|(found, value)| *found = *value);
        Ok(())
    }
}

impl LimitFunction for Limit {
    fn each(&self, columns: &[Vec<f64>], found: &mut [f64]) {
        let has_raised = |raised: &Mutex<Option<PyErr>>| raised.lock().is_ok_and(|raised| raised.is_some());
        if has_raised(&self.raised) {
            return found.fill(1.0);
        }
        let called = Python::attach(|py| self.called(py, columns, found));
        if let Err(error) = called {
            found.fill(1.0);
            if let Ok(mut raised) = self.raised.lock() {
                raised.get_or_insert(error);
            }
        }
    }
}

/// A nearest point: β, and of each number its value, its standard normal and α.
type DesignPoint = (f64, Vec<f64>, Vec<f64>, Vec<f64>);
/// The names; probability and the ends of its interval; −Φ⁻¹ of it; the method, and if an integration was given up for it; points, and if they are as
/// precise as asked; the place of the line; nearest points; and the probability if each number were known.
type Answer =
    (Vec<String>, [f64; 3], f64, (&'static str, bool), (u64, bool), usize, Vec<DesignPoint>, Vec<f64>);

/// How likely a function of random numbers is below zero; `laws` is a table `[random]`, as a text with its name.
#[pyfunction]
pub(crate) fn reliability(
    py: Python<'_>,
    limit_state: Py<PyAny>,
    laws: (String, String),
    line: Option<String>,
    asked: Arguments,
) -> PyResult<Answer> {
    let named = asked.method.as_deref().map(|name| {
        Method::find(name).ok_or_else(|| {
            let names = Method::ALL.map(Method::name).join(", ");
            StandfastError::new_err(format!("no method is called `{name}`; expected one of {names}"))
        })
    });
    let method = named.transpose()?;
    let text = CaseText::parse(&laws.0, &laws.1).map_err(|error| of_case(&error))?;
    let OwnNumbers { names, arguments, laws: inputs } = own_laws(&text).map_err(|error| of_case(&error))?;
    let place = |line: &String| {
        names.iter().position(|name| name == line).ok_or_else(|| {
            StandfastError::new_err(format!("line is {line:?}; expected one of {}", names.join(", ")))
        })
    };
    let line = line.as_ref().map(place).transpose()?;
    if let Some(line) = line.filter(|line| inputs.is_parent(*line)) {
        let expected: Vec<&str> = (0..names.len())
            .filter(|place| !inputs.is_parent(*place))
            .map(|place| &names[place][..])
            .collect();
        return Err(StandfastError::new_err(format!(
            "line is {:?}, on which the law of another number depends; expected one of {}",
            names[line],
            expected.join(", ")
        )));
    }
    // One thread: only one at a time can call a function of Python.
    let effort = Effort { threads: 1, ..asked.effort() };
    let named = names[..arguments].to_vec();
    let function = Limit { function: limit_state, names: named, raised: Mutex::new(None) };
    let found = watched(py, asked.progress.as_ref(), move |portion| {
        let found = of_limit_state(&inputs, &function, &Asked { method, effort, line, portion });
        match function.raised.into_inner().ok().flatten() {
            Some(raised) => Err(raised),
            None => found.map_err(|error| StandfastError::new_err(error.to_string())),
        }
    })??;
    let below = found.below_zero;
    let point = |FormPoint { beta, values, u, alpha, .. }: FormPoint| (beta, values, u, alpha);
    Ok((
        names,
        [below.value, below.low, below.high],
        generalized(below.value),
        (found.method.name(), found.given_up),
        (found.points, found.precise),
        found.line,
        found.design_points.into_iter().map(point).collect(),
        found.known.iter().map(|known| known.value).collect(),
    ))
}
