//! numpy arrays in and out.

use numpy::{
    PyArray1, PyArrayDescrMethods, PyArrayDyn, PyArrayMethods, PyUntypedArray, PyUntypedArrayMethods,
};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use standfast::Point;

use crate::errors::StandfastError;
use crate::grid::{Grid, Halt};
use crate::onset::{Choice, Column, NO_MODE, Onset};
use crate::operand::{Kind, Operand};
use crate::run::Run;
use crate::watch::Monitor;
use crate::{Codes, NAMES, expect_numbers, invalid};

/// γ, k', k and μ; with ω of bases that crush.
pub(crate) type Arrays<'py> = Vec<Bound<'py, PyUntypedArray>>;
pub(crate) type Mask<'py> = Bound<'py, PyArrayDyn<bool>>;

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
        (b'u', 1, _) | (b'b', 1, _) => Some(Kind::U8),
        _ => None,
    };
    let kind = kind.ok_or_else(|| PyTypeError::new_err(format!("dtype {dtype} is not read natively")))?;
    // SAFETY: the pointer to a live array object can be followed.
    #[expect(unsafe_code, reason = "numpy's interface has no other way to the memory of any type")]
    let pointer = unsafe { (*array.as_array_ptr()).fields.data.cast::<u8>().cast_const() };
    let (shape, strides) = (array.shape().to_vec(), array.strides().to_vec());
    Ok(Operand { pointer, kind, shape, strides, nulls: None })
}

/// The arrays broadcast to each other, and to the mask if there is one; to be used only while they are alive.
pub(crate) fn broadcast(arrays: &[Bound<'_, PyUntypedArray>], mask: Option<&Mask<'_>>) -> PyResult<Grid> {
    let mask = mask.map(|mask| mask.as_untyped());
    expect_numbers(arrays.len())?;
    let operands = arrays.iter().chain(mask).map(operand).collect::<PyResult<_>>()?;
    // SAFETY: numpy vouches for pointer, type, shape and strides for as long as the array is alive.
    #[expect(unsafe_code, reason = "the grid trusts pointers and strides")]
    let grid = unsafe { Grid::new(operands, arrays.len()) };
    grid.map_err(|_| {
        let names = NAMES.into_iter().take(arrays.len()).chain(["mask"]);
        let shapes = arrays.iter().chain(mask).zip(names).map(|(array, name)| {
            let shape = PyTuple::new(array.py(), array.shape())?;
            Ok(format!("{name} {}", shape.repr()?))
        });
        match shapes.collect::<PyResult<Vec<_>>>() {
            Ok(shapes) => StandfastError::new_err(format!(
                "these shapes do not broadcast together: {}; expected each axis to have one length, or 1",
                shapes.join(", ")
            )),
            Err(error) => error,
        }
    })
}

/// Error for work on the grid that came to an end.
pub(crate) fn halted(py: Python<'_>, halt: Halt, grid: &Grid, run: &Run, mut monitor: Monitor<'_>) -> PyErr {
    let in_order: Vec<usize> = (0..grid.shape.len()).collect();
    let found = match halt {
        Halt::Stopped => None,
        // The first in the order of C.
        Halt::Invalid => {
            let grid = grid.along(&in_order);
            py.detach(|| grid.first_invalid(run.gaps(), &mut |_| monitor.wait()))
        }
    };
    match (monitor.raised(), found) {
        (Some(error), _) => error,
        (None, Some((index, source))) => invalid(source, &grid.unravel(index)),
        (None, None) => StandfastError::new_err("the arrays changed while they were read"),
    }
}

/// A new array of the grid's shape that lies in the memory along `axes`, from a flat one.
pub(crate) fn shaped<'py, T: numpy::Element>(
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

/// Mask of the points that have no answer, if there are such; as an array that lies in the memory along `axes`.
pub(crate) fn mask_of<'py>(
    py: Python<'py>,
    missing: Vec<bool>,
    grid: &Grid,
    axes: &[usize],
) -> PyResult<Option<Mask<'py>>> {
    let some = missing.contains(&true);
    some.then(|| shaped(PyArray1::from_vec(py, missing), grid, axes)).transpose()
}

/// The mode code of one point; `right` says where the force points.
#[pyfunction]
pub(crate) fn classify_point(gamma: f64, k_prime: f64, k: f64, mu: f64, right: bool) -> PyResult<u8> {
    let point = Point::new(gamma, k_prime, k, mu).map_err(|error| invalid(error, &[]))?;
    let mode = point.mode();
    Ok(if right { mode.mirrored() } else { mode }.code())
}

/// Mode codes of points, into `out` if it is given, and which points have none, if there are such.
#[pyfunction]
pub(crate) fn classify<'py>(
    py: Python<'py>,
    arrays: Arrays<'py>,
    mask: Option<Mask<'py>>,
    out: Option<Codes<'py>>,
    run: Run,
) -> PyResult<(Codes<'py>, Option<Mask<'py>>)> {
    let grid = broadcast(&arrays, mask.as_ref())?;
    let Some(out) = out else { return new_codes(py, &grid, &run) };
    if out.shape() != grid.shape {
        let shapes = [PyTuple::new(py, out.shape())?.repr()?, PyTuple::new(py, &grid.shape)?.repr()?];
        let [found, expected] = shapes;
        return Err(StandfastError::new_err(format!(
            "out has shape {found}; expected {expected}, that of the operands broadcast together"
        )));
    }
    let numpy = py.import("numpy")?;
    let mut shared = false;
    for array in arrays.iter().chain(mask.as_ref().map(|mask| mask.as_untyped())) {
        shared |= numpy.call_method1("may_share_memory", (&out, array))?.extract::<bool>()?;
    }
    let missing = match lying(&out).filter(|_| !shared) {
        Some(axes) => {
            // Until it is written, no other call may write it, be it one that `progress` makes.
            let _claimed = out.try_readwrite().map_err(|_| {
                StandfastError::new_err(
                    "out is an array that another call is writing to; expected one for each",
                )
            })?;
            // SAFETY: it was allocated by numpy, shares no memory with the operands, lies without gaps, and no other call of this
            // module has it. Python itself can still write or read it meanwhile; the documentation of `classify` forbids that, and
            // nothing here relies on what was written.
            #[expect(unsafe_code, reason = "writes the caller's array, whatever the order of its axes")]
            let codes = unsafe { std::slice::from_raw_parts_mut(out.data(), grid.len()) };
            fill(py, &grid, &axes, codes, &run)?
        }
        None => {
            let (codes, missing) = new_codes(py, &grid, &run)?;
            numpy.call_method1("copyto", (&out, codes))?;
            missing
        }
    };
    Ok((out, missing))
}

fn new_codes<'py>(py: Python<'py>, grid: &Grid, run: &Run) -> PyResult<(Codes<'py>, Option<Mask<'py>>)> {
    let axes = grid.axes();
    let flat = PyArray1::<u8>::zeros(py, [grid.len()], false);
    let missing = fill(py, grid, &axes, flat.readwrite().as_slice_mut()?, run)?;
    Ok((shaped(flat, grid, &axes)?, missing))
}

fn fill<'py>(
    py: Python<'py>,
    grid: &Grid,
    axes: &[usize],
    codes: &mut [u8],
    run: &Run,
) -> PyResult<Option<Mask<'py>>> {
    let along = grid.along(axes);
    let mut missing = along.gaps(run.gaps());
    let mut monitor = run.monitor(Some(grid.len()));
    let done = py.detach(|| along.classify(codes, &mut missing, run.labour(&mut |done| monitor.step(done))));
    if let Err(halt) = done {
        return Err(halted(py, halt, grid, run, monitor));
    }
    codes.iter_mut().zip(&missing).filter(|(_, missing)| **missing).for_each(|(code, _)| *code = NO_MODE);
    monitor.advance(grid.len());
    monitor.finish(py)?;
    mask_of(py, missing, grid, axes)
}

/// The columns asked for of the onset, and which points have none, if there are such.
#[pyfunction]
pub(crate) fn onset<'py>(
    py: Python<'py>,
    arrays: Arrays<'py>,
    mask: Option<Mask<'py>>,
    columns: Choice,
    run: Run,
) -> PyResult<(Vec<Bound<'py, PyAny>>, Option<Mask<'py>>)> {
    let grid = broadcast(&arrays, mask.as_ref())?;
    let axes = grid.axes();
    let along = grid.along(&axes);
    let mut found = Onset::new(&columns, grid.len());
    let mut missing = along.gaps(run.gaps());
    let mut monitor = run.monitor(Some(grid.len()));
    let done =
        py.detach(|| along.onset(found.columns(), &mut missing, run.labour(&mut |done| monitor.step(done))));
    if let Err(halt) = done {
        return Err(halted(py, halt, &grid, &run, monitor));
    }
    if missing.contains(&true) {
        found.blank(&missing);
    }
    monitor.advance(grid.len());
    monitor.finish(py)?;
    let array = |column| {
        Ok(match column {
            Column::Mode(codes) => shaped(PyArray1::from_vec(py, codes), &grid, &axes)?.into_any(),
            Column::Unique(unique) => shaped(PyArray1::from_vec(py, unique), &grid, &axes)?.into_any(),
            Column::Others(others) => shaped(PyArray1::from_vec(py, others), &grid, &axes)?.into_any(),
            Column::Motion(numbers) => shaped(PyArray1::from_vec(py, numbers), &grid, &axes)?.into_any(),
        })
    };
    let arrays = found.in_order(&columns).map(array).collect::<PyResult<_>>()?;
    Ok((arrays, mask_of(py, missing, &grid, &axes)?))
}
