//! Arrays of any real type and layout as the numbers of points.

use arrow_array::cast::AsArray;
use arrow_array::types::Float64Type;
use arrow_array::{Array, ArrayRef};
use arrow_buffer::NullBuffer;
use arrow_cast::cast;
use arrow_schema::DataType;
use half::f16;

/// The type of the numbers of an operand.
#[derive(Debug, Clone)]
pub(crate) enum Kind {
    F64,
    F32,
    F16,
    I64,
    I32,
    I16,
    I8,
    U64,
    U32,
    U16,
    U8,
    /// Array that Arrow converts: decimals, dictionaries, nulls. Of one axis; it has no pointer.
    Arrow(ArrayRef),
}

/// An array in memory.
#[derive(Debug, Clone)]
pub(crate) struct Operand {
    pub(crate) pointer: *const u8,
    pub(crate) kind: Kind,
    pub(crate) shape: Vec<usize>,
    /// In bytes.
    pub(crate) strides: Vec<isize>,
    /// Validity of the values, of a column of Arrow that says so.
    pub(crate) nulls: Option<NullBuffer>,
}

// SAFETY: an operand is only ever read, and whoever makes one keeps its memory alive; see `Grid::new`.
#[expect(unsafe_code, reason = "threads read the arrays of their caller")]
unsafe impl Send for Operand {}
// SAFETY: as above.
#[expect(unsafe_code, reason = "threads read the arrays of their caller")]
unsafe impl Sync for Operand {}

/// A slenderness, elevation, force, friction and ω that a point can have.
pub(crate) const VALID: f64 = 1.0;

impl Operand {
    /// True if the values lie as f64 one after another, in the order of the grid.
    pub(crate) fn is_column(&self) -> bool {
        let mut step = size_of::<f64>() as isize;
        let lies = self.shape.iter().zip(&self.strides).rev().all(|(&length, &stride)| {
            let as_expected = stride == step;
            step *= length as isize;
            as_expected
        });
        let plain = matches!(self.kind, Kind::F64) && !self.has_nulls() && !self.shape.is_empty();
        plain && lies && self.pointer.cast::<f64>().is_aligned()
    }

    /// True if the points share one value.
    pub(crate) fn is_same(&self) -> bool {
        !self.has_nulls() && self.strides.iter().all(|&stride| stride == 0)
    }

    /// True if values may be missing.
    pub(crate) fn has_nulls(&self) -> bool {
        self.nulls.is_some() || matches!(self.kind, Kind::Arrow(_))
    }

    /// Values of a column that lies as such.
    pub(crate) fn column(&self, start: usize, length: usize) -> &[f64] {
        debug_assert!(self.is_column() && start + length <= self.shape.iter().product());
        // SAFETY: by `is_column` the values lie one after another and aligned, and by the contract of `Grid::new`
        // they can be read.
        #[expect(unsafe_code, reason = "reads memory that numpy or Arrow owns")]
        unsafe {
            std::slice::from_raw_parts(self.pointer.cast::<f64>().add(start), length)
        }
    }

    /// As [`gather`](Operand::gather); marks what is missing, in place of which a valid number is written.
    pub(crate) fn gather_marked(&self, start: usize, out: &mut [f64], missing: &mut [bool]) {
        let nulls = match &self.kind {
            Kind::Arrow(array) => {
                let values = floats(&array.slice(start, out.len()));
                out.copy_from_slice(values.as_primitive::<Float64Type>().values());
                values.nulls().cloned()
            }
            _ => {
                self.gather(start, out);
                self.nulls.as_ref().map(|nulls| nulls.slice(start, out.len()))
            }
        };
        for (i, valid) in nulls.iter().flatten().enumerate() {
            if !valid {
                (out[i], missing[i]) = (VALID, true);
            }
        }
    }

    /// Copies the values from `start`, in the order of the grid, as f64.
    pub(crate) fn gather(&self, start: usize, out: &mut [f64]) {
        match &self.kind {
            Kind::Arrow(_) => unreachable!("values that may be missing are gathered with marks"),
            Kind::F64 => self.gather_as(start, out, |value: f64| value),
            Kind::F32 => self.gather_as(start, out, |value: f32| value.into()),
            Kind::F16 => self.gather_as(start, out, |value: f16| value.into()),
            Kind::I64 => self.gather_as(start, out, |value: i64| value as f64),
            Kind::I32 => self.gather_as(start, out, |value: i32| value.into()),
            Kind::I16 => self.gather_as(start, out, |value: i16| value.into()),
            Kind::I8 => self.gather_as(start, out, |value: i8| value.into()),
            Kind::U64 => self.gather_as(start, out, |value: u64| value as f64),
            Kind::U32 => self.gather_as(start, out, |value: u32| value.into()),
            Kind::U16 => self.gather_as(start, out, |value: u16| value.into()),
            Kind::U8 => self.gather_as(start, out, |value: u8| value.into()),
        }
    }

    fn gather_as<T: Copy>(&self, start: usize, out: &mut [f64], convert: impl Fn(T) -> f64) {
        let axes = self.shape.len();
        let Some(&row) = self.shape.last() else {
            // A grid of one point.
            return out.fill(convert(self.value(0)));
        };
        let mut index = vec![0; axes];
        let mut rest = start;
        for axis in (0..axes).rev() {
            index[axis] = rest % self.shape[axis];
            rest /= self.shape[axis];
        }
        let stride = self.strides[axes - 1];
        let mut filled = 0;
        while filled < out.len() {
            let length = (row - index[axes - 1]).min(out.len() - filled);
            let offset: isize =
                index.iter().zip(&self.strides).map(|(&index, &stride)| index as isize * stride).sum();
            for (i, value) in out[filled..filled + length].iter_mut().enumerate() {
                *value = convert(self.value(offset + i as isize * stride));
            }
            filled += length;
            index[axes - 1] = 0;
            for axis in (0..axes - 1).rev() {
                index[axis] += 1;
                if index[axis] < self.shape[axis] {
                    break;
                }
                index[axis] = 0;
            }
        }
    }

    /// A column of Arrow that has to be converted to be read.
    pub(crate) fn converted(array: ArrayRef) -> Operand {
        let (shape, strides) = (vec![array.len()], vec![1]);
        Operand { pointer: std::ptr::null(), kind: Kind::Arrow(array), shape, strides, nulls: None }
    }

    /// The value at an offset in bytes.
    fn value<T: Copy>(&self, offset: isize) -> T {
        // SAFETY: `gather` picks T by the kind, and the offset comes from an index within the shape, so that by the
        // contract of `Grid::new` the value can be read. It need not be aligned.
        #[expect(unsafe_code, reason = "reads memory that numpy or Arrow owns")]
        unsafe {
            self.pointer.offset(offset).cast::<T>().read_unaligned()
        }
    }
}

/// Numbers of any kind that [`is_number`] as Arrow converts them, which is how `standfast batch` reads them.
pub(crate) fn floats(array: &ArrayRef) -> ArrayRef {
    cast(array, &DataType::Float64).unwrap_or_else(|_| unreachable!("every number can be a Float64"))
}

/// True if a column of this type holds real numbers, or nothing at all.
pub(crate) fn is_number(kind: &DataType) -> bool {
    match kind {
        DataType::Dictionary(_, values) => is_number(values),
        DataType::Null => true,
        other => other.is_numeric(),
    }
}
