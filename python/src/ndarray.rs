//! numpy arrays in and out.

use std::num::NonZero;

use numpy::{
    PyArray1, PyArrayDescrMethods, PyArrayDyn, PyArrayMethods, PyUntypedArray, PyUntypedArrayMethods,
};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use standfast::batch::OnsetColumns;

use crate::grid::{self, Grid, Kind, Operand};
use crate::{Codes, invalid};

type Arrays<'py> = [Bound<'py, PyUntypedArray>; 4];
type Floats<'py> = Bound<'py, PyArrayDyn<f64>>;

/// The memory of an array.
fn operand(array: &Bound<'_, PyUntypedArray>) -> PyResult<Operand> {
    let dtype = array.dtype();
    let kind = match (dtype.kind(), dtype.itemsize(), dtype.is_native_byteorder()) {
        (_, _, Some(false)) => None,
        (b'f', 8, _) => Some(Kind::F64),
        (b'f', 4, _) => Some(Kind::F32),
        (b'f', 2, _) => Some(Kind::F16),
        (b'i', 8, _) => Some(Kind::I64),
        (b'i', 4, _) => Some(Kind::I32),
        (b'i', 2, _) => Some(Kind::I16),
        (b'i', 1, _) => Some(Kind::I8),
        (b'u', 8, _) => Some(Kind::U64),
        (b'u', 4, _) => Some(Kind::U32),
        (b'u', 2, _) => Some(Kind::U16),
        (b'u', 1, _) => Some(Kind::U8),
        _ => None,
    };
    let kind = kind.ok_or_else(|| PyTypeError::new_err(format!("dtype {dtype} is not read natively")))?;
    // SAFETY: the pointer to a live array object can be followed.
    #[expect(unsafe_code, reason = "numpy's interface has no other way to the memory of any type")]
    let pointer = unsafe { (*array.as_array_ptr()).fields.data.cast::<u8>().cast_const() };
    Ok(Operand { pointer, kind, shape: array.shape().to_vec(), strides: array.strides().to_vec() })
}

/// The arrays broadcast to each other; to be used only while they are alive.
fn broadcast(arrays: &Arrays<'_>) -> PyResult<Grid> {
    let [gamma, k_prime, k, mu] = arrays.each_ref().map(operand);
    // SAFETY: numpy vouches for pointer, type, shape and strides for as long as the array is alive.
    #[expect(unsafe_code, reason = "the grid trusts pointers and strides")]
    let grid = unsafe { Grid::new([gamma?, k_prime?, k?, mu?]) };
    grid.map_err(|_| {
        let shapes = arrays.iter().zip(["gamma", "k_prime", "k", "mu"]).map(|(array, name)| {
            let shape = PyTuple::new(array.py(), array.shape())?;
            Ok(format!("{name} {}", shape.repr()?))
        });
        match shapes.collect::<PyResult<Vec<_>>>() {
            Ok(shapes) => PyValueError::new_err(format!(
                "these shapes do not broadcast together: {}; expected each axis to have one length, or 1",
                shapes.join(", ")
            )),
            Err(error) => error,
        }
    })
}

/// The exception for the first point, in the order of C, that is not valid.
fn error(grid: &Grid) -> PyErr {
    let in_order: Vec<usize> = (0..grid.shape.len()).collect();
    match grid.along(&in_order).first_invalid() {
        Some((index, source)) => invalid(source, &grid.unravel(index)),
        None => PyValueError::new_err("the arrays changed while they were read"),
    }
}

/// A new array of the grid's shape that lies in the memory along `axes`, from a flat one.
fn shaped<'py, T: numpy::Element>(
    flat: Bound<'py, PyArray1<T>>,
    grid: &Grid,
    axes: &[usize],
) -> PyResult<Bound<'py, PyArrayDyn<T>>> {
    let lying: Vec<usize> = axes.iter().map(|&axis| grid.shape[axis]).collect();
    let mut back = vec![0; axes.len()];
    axes.iter().enumerate().for_each(|(place, &axis)| back[axis] = place);
    let array = flat.reshape(lying)?;
    let array = if back.is_sorted() { array } else { array.permute(Some(back))? };
    Ok(array)
}

/// The axes in whose order an array fills a stretch of memory without gaps, if there are such.
fn lying(array: &Codes<'_>) -> Option<Vec<usize>> {
    let mut axes: Vec<usize> = (0..array.ndim()).collect();
    axes.sort_by_key(|&axis| std::cmp::Reverse(array.strides()[axis]));
    let mut step = 1;
    let gapless = axes.iter().rev().filter(|&&axis| array.shape()[axis] != 1).all(|&axis| {
        let as_expected = array.strides()[axis] == step;
        step *= array.shape()[axis] as isize;
        as_expected
    });
    gapless.then_some(axes)
}

/// Mode codes of points, into `out` if it is given.
#[pyfunction]
#[pyo3(signature = (arrays, out, threads))]
pub(crate) fn classify<'py>(
    py: Python<'py>,
    arrays: Arrays<'py>,
    out: Option<Codes<'py>>,
    threads: Option<NonZero<usize>>,
) -> PyResult<Codes<'py>> {
    let grid = broadcast(&arrays)?;
    let Some(out) = out else { return new_codes(py, &grid, threads) };
    if out.shape() != grid.shape {
        let shapes = [PyTuple::new(py, out.shape())?.repr()?, PyTuple::new(py, &grid.shape)?.repr()?];
        let [found, expected] = shapes;
        return Err(PyValueError::new_err(format!(
            "out has shape {found}; expected {expected}, that of the operands broadcast together"
        )));
    }
    let numpy = py.import("numpy")?;
    let mut shared = false;
    for array in &arrays {
        shared |= numpy.call_method1("may_share_memory", (&out, array))?.extract::<bool>()?;
    }
    match lying(&out).filter(|_| !shared) {
        Some(axes) => {
            // SAFETY: it was allocated by numpy, shares no memory with the operands, and lies without gaps.
            #[expect(unsafe_code, reason = "writes the caller's array, whatever the order of its axes")]
            let codes = unsafe { std::slice::from_raw_parts_mut(out.data(), grid.len()) };
            fill(py, &grid, &axes, codes, threads)?;
        }
        None => {
            let codes = new_codes(py, &grid, threads)?;
            numpy.call_method1("copyto", (&out, codes))?;
        }
    }
    Ok(out)
}

fn new_codes<'py>(py: Python<'py>, grid: &Grid, threads: Option<NonZero<usize>>) -> PyResult<Codes<'py>> {
    let axes = grid.axes();
    let flat = PyArray1::<u8>::zeros(py, [grid.len()], false);
    fill(py, grid, &axes, flat.readwrite().as_slice_mut()?, threads)?;
    shaped(flat, grid, &axes)
}

fn fill(
    py: Python<'_>,
    grid: &Grid,
    axes: &[usize],
    codes: &mut [u8],
    asked: Option<NonZero<usize>>,
) -> PyResult<()> {
    let along = grid.along(axes);
    if py.detach(|| along.classify(codes, grid::threads(asked))) { Ok(()) } else { Err(error(grid)) }
}

/// Mode codes, bits of the other modes, and the nine columns of the motion.
#[pyfunction]
pub(crate) fn onset<'py>(
    py: Python<'py>,
    arrays: Arrays<'py>,
    threads: Option<NonZero<usize>>,
) -> PyResult<(Codes<'py>, Bound<'py, PyArrayDyn<u16>>, Vec<Floats<'py>>)> {
    let grid = broadcast(&arrays)?;
    let axes = grid.axes();
    let length = [grid.len()];
    let modes = PyArray1::<u8>::zeros(py, length, false);
    let others = PyArray1::<u16>::zeros(py, length, false);
    let motion = [(); 9].map(|()| PyArray1::<f64>::zeros(py, length, false));
    {
        let (mut modes, mut others) = (modes.readwrite(), others.readwrite());
        let mut motion = motion.each_ref().map(|column| column.readwrite());
        let mut columns: [&mut [f64]; 9] = Default::default();
        for (column, array) in columns.iter_mut().zip(&mut motion) {
            *column = array.as_slice_mut()?;
        }
        let out =
            OnsetColumns { mode: modes.as_slice_mut()?, others: others.as_slice_mut()?, motion: columns };
        let along = grid.along(&axes);
        if !py.detach(|| along.onset(out, grid::threads(threads))) {
            return Err(error(&grid));
        }
    }
    let motion = motion.into_iter().map(|column| shaped(column, &grid, &axes)).collect::<PyResult<_>>()?;
    Ok((shaped(modes, &grid, &axes)?, shaped(others, &grid, &axes)?, motion))
}
