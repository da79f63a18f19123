//! Where in memory are the four numbers of a point? Arrays of any real type, shape and strides that broadcast to one
//! shape, read block by block into the columns that [`standfast::batch`] works on.
//!
//! An operand that already is a column of f64 is used where it lies; a scalar is written out once per thread; anything
//! else is gathered, a block at a time. No operand is ever copied as a whole.

use std::num::NonZero;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

use half::f16;
use standfast::batch::{self, Columns, OnsetColumns};
use standfast::{InputError, Point};

/// The type of the numbers of an operand.
#[derive(Debug, Clone, Copy, PartialEq)]
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
}

/// An array in memory.
#[derive(Debug, Clone)]
pub(crate) struct Operand {
    pub(crate) pointer: *const u8,
    pub(crate) kind: Kind,
    pub(crate) shape: Vec<usize>,
    /// In bytes.
    pub(crate) strides: Vec<isize>,
}

/// Four operands of one shape.
#[derive(Debug, Clone)]
pub(crate) struct Grid {
    pub(crate) shape: Vec<usize>,
    operands: [Operand; 4],
}

// SAFETY: an operand is only ever read, and whoever makes one keeps its memory alive; see `Grid::new`.
#[expect(unsafe_code, reason = "threads read the arrays of their caller")]
unsafe impl Send for Operand {}
// SAFETY: as above.
#[expect(unsafe_code, reason = "threads read the arrays of their caller")]
unsafe impl Sync for Operand {}

/// Points that are gathered at a time: four columns of them stay in the second-level cache.
const BLOCK: usize = 4096;
/// Points that a thread takes at a time.
const PIECE: usize = 16 * BLOCK;

/// The operands have no common shape.
#[derive(Debug)]
pub(crate) struct ShapeMismatch;

impl Grid {
    /// Operands broadcast to their common shape by numpy's rules.
    ///
    /// # Safety
    /// For as long as the grid or a copy of it is read, every index within an operand's shape has to lead, by its
    /// strides, to a readable number of its kind.
    #[expect(unsafe_code, reason = "the grid trusts pointers and strides")]
    pub(crate) unsafe fn new(operands: [Operand; 4]) -> Result<Grid, ShapeMismatch> {
        let dimensions = operands.iter().map(|operand| operand.shape.len()).max().unwrap_or(0);
        let mut shape = vec![1; dimensions];
        for operand in &operands {
            let missing = dimensions - operand.shape.len();
            for (length, &own) in shape[missing..].iter_mut().zip(&operand.shape) {
                match (*length, own) {
                    (_, 1) => {}
                    (1, own) => *length = own,
                    (length, own) if length == own => {}
                    _ => return Err(ShapeMismatch),
                }
            }
        }
        let operands = operands.map(|operand| {
            let missing = dimensions - operand.shape.len();
            let own = |axis: usize| {
                let own = axis.checked_sub(missing)?;
                (operand.shape[own] == shape[axis] && shape[axis] != 1).then(|| operand.strides[own])
            };
            let strides = (0..dimensions).map(|axis| own(axis).unwrap_or(0)).collect();
            Operand { strides, shape: shape.clone(), ..operand }
        });
        Ok(Grid { shape, operands })
    }

    pub(crate) fn len(&self) -> usize {
        self.shape.iter().product()
    }

    /// The axes from the one with the longest strides to that with the shortest, so that reading in this order runs
    /// along the memory.
    pub(crate) fn axes(&self) -> Vec<usize> {
        let mut axes: Vec<usize> = (0..self.shape.len()).collect();
        let reach = |axis: usize| -> usize {
            self.operands.iter().map(|operand| operand.strides[axis].unsigned_abs()).sum()
        };
        // Stable: axes that nothing distinguishes keep the order of C.
        axes.sort_by_key(|&axis| std::cmp::Reverse(reach(axis)));
        axes
    }

    /// The grid with its axes in another order, neighbours joined where the memory allows it.
    pub(crate) fn along(&self, axes: &[usize]) -> Grid {
        let mut shape: Vec<usize> = Vec::new();
        let mut strides: [Vec<isize>; 4] = Default::default();
        for &axis in axes.iter().filter(|&&axis| self.shape[axis] != 1) {
            let length = self.shape[axis];
            let own = |i: usize| self.operands[i].strides[axis];
            let joins = !shape.is_empty()
                && (0..4).all(|i| strides[i].last().is_some_and(|&outer| outer == own(i) * length as isize));
            if joins {
                *shape.last_mut().expect("there is an outer axis") *= length;
                (0..4).for_each(|i| *strides[i].last_mut().expect("there is an outer axis") = own(i));
            } else {
                shape.push(length);
                (0..4).for_each(|i| strides[i].push(own(i)));
            }
        }
        let mut strides = strides.into_iter();
        let operands = self.operands.clone().map(|operand| {
            let strides = strides.next().expect("four operands");
            Operand { shape: shape.clone(), strides, ..operand }
        });
        Grid { shape, operands }
    }

    /// Writes the mode codes in the order of the grid; false if a point has no mode, see
    /// [`first_invalid`](Grid::first_invalid).
    pub(crate) fn classify(&self, codes: &mut [u8], threads: usize) -> bool {
        let pieces = codes.chunks_mut(PIECE).enumerate().map(|(i, codes)| (i * PIECE, codes));
        self.share(pieces, threads, |columns, start, codes: &mut [u8]| {
            let reach = columns.reach();
            codes.chunks_mut(reach).enumerate().all(|(i, codes)| {
                batch::classify(columns.read(start + i * reach, codes.len()), codes).is_ok()
            })
        })
    }

    /// As [`classify`](Grid::classify), for everything about the onset.
    pub(crate) fn onset(&self, out: OnsetColumns<'_>, threads: usize) -> bool {
        let (mut rest, mut start) = (Some(out), 0);
        let pieces = std::iter::from_fn(|| {
            let out = rest.take().filter(|out| !out.mode.is_empty())?;
            let length = out.mode.len().min(BLOCK);
            let (head, tail) = out.split_at(length);
            rest = Some(tail);
            start += length;
            Some((start - length, head))
        });
        self.share(pieces, threads, |columns, start, out: OnsetColumns<'_>| {
            let length = out.mode.len();
            batch::onset(columns.read(start, length), out).is_ok()
        })
    }

    /// Lets threads take pieces of the output until none is left or one fails. The threads live as long as the call:
    /// no pool outlives it, which a `fork` of the process would break.
    fn share<P: Send>(
        &self,
        pieces: impl Iterator<Item = (usize, P)> + Send,
        threads: usize,
        work: impl Fn(&mut Reader<'_>, usize, P) -> bool + Sync,
    ) -> bool {
        let pieces = Mutex::new(pieces);
        let failed = AtomicBool::new(false);
        let take = || pieces.lock().expect("taking a piece does not panic").next();
        let labour = || {
            let mut columns = Reader::new(self);
            while let Some((start, piece)) = take().filter(|_| !failed.load(Ordering::Relaxed)) {
                if !work(&mut columns, start, piece) {
                    failed.store(true, Ordering::Relaxed);
                }
            }
        };
        let threads = threads.min(self.len().div_ceil(BLOCK)).max(1);
        std::thread::scope(|scope| {
            for _ in 1..threads {
                // If the system has no more threads to give, those there are do the work.
                if std::thread::Builder::new().spawn_scoped(scope, labour).is_err() {
                    break;
                }
            }
            labour();
        });
        !failed.into_inner()
    }

    /// The first point that has no mode, by its index in the order of the grid.
    pub(crate) fn first_invalid(&self) -> Option<(usize, InputError)> {
        let mut columns = Reader::new(self);
        (0..self.len()).step_by(BLOCK).find_map(|start| {
            let length = BLOCK.min(self.len() - start);
            let block = columns.read(start, length);
            (0..length).find_map(|i| {
                let [gamma, k_prime, k, mu] = [block.gamma[i], block.k_prime[i], block.k[i], block.mu[i]];
                Point::new(gamma, k_prime, k, mu).err().map(|error| (start + i, error))
            })
        })
    }

    /// An index in the order of the grid as one along every axis.
    pub(crate) fn unravel(&self, mut index: usize) -> Vec<usize> {
        let mut indices: Vec<usize> = self
            .shape
            .iter()
            .rev()
            .map(|&length| {
                let own = index % length;
                index /= length;
                own
            })
            .collect();
        indices.reverse();
        indices
    }
}

/// As many threads as the caller asks for, or as there are processors.
pub(crate) fn threads(asked: Option<NonZero<usize>>) -> usize {
    asked.or_else(|| std::thread::available_parallelism().ok()).map_or(1, NonZero::get)
}

/// Where a thread gets one of its columns from.
enum Source {
    /// The operand is one.
    Lying,
    /// Every value is the same, and is written in the buffer.
    Same,
    /// Blocks are gathered in the buffer.
    Gathered,
}

/// One thread's view of a grid.
struct Reader<'a> {
    grid: &'a Grid,
    sources: [(Source, Vec<f64>); 4],
}

impl<'a> Reader<'a> {
    fn new(grid: &'a Grid) -> Reader<'a> {
        let sources = grid.operands.each_ref().map(|operand| {
            let mut buffer = Vec::new();
            let source = if operand.is_column() {
                Source::Lying
            } else if operand.strides.iter().all(|&stride| stride == 0) {
                let mut value = [0.0];
                if grid.len() > 0 {
                    operand.gather(0, &mut value);
                }
                buffer.resize(BLOCK.min(grid.len()), value[0]);
                Source::Same
            } else {
                buffer.resize(BLOCK.min(grid.len()), 0.0);
                Source::Gathered
            };
            (source, buffer)
        });
        Reader { grid, sources }
    }

    /// The longest block that [`read`](Reader::read) can return.
    fn reach(&self) -> usize {
        let lie = self.sources.iter().all(|(source, _)| matches!(source, Source::Lying));
        if lie { PIECE } else { BLOCK }
    }

    /// The points from `start`.
    fn read(&mut self, start: usize, length: usize) -> Columns<'_> {
        let mut operands = self.grid.operands.iter();
        let [gamma, k_prime, k, mu] = self.sources.each_mut().map(|(source, buffer)| {
            let operand = operands.next().expect("four operands");
            match source {
                Source::Lying => operand.column(start, length),
                Source::Same => &buffer[..length],
                Source::Gathered => {
                    operand.gather(start, &mut buffer[..length]);
                    &buffer[..length]
                }
            }
        });
        Columns { gamma, k_prime, k, mu }
    }
}

impl Operand {
    /// Whether the values lie as f64 one after another, in the order of the grid.
    fn is_column(&self) -> bool {
        let mut step = size_of::<f64>() as isize;
        let lies = self.shape.iter().zip(&self.strides).rev().all(|(&length, &stride)| {
            let as_expected = stride == step;
            step *= length as isize;
            as_expected
        });
        self.kind == Kind::F64 && lies && self.pointer.cast::<f64>().is_aligned() && !self.shape.is_empty()
    }

    /// Values of a column that lies as such.
    fn column(&self, start: usize, length: usize) -> &[f64] {
        debug_assert!(self.is_column() && start + length <= self.shape.iter().product());
        // SAFETY: by `is_column` the values lie one after another and aligned, and by the contract of `Grid::new`
        // they can be read.
        #[expect(unsafe_code, reason = "reads memory that numpy or Arrow owns")]
        unsafe {
            std::slice::from_raw_parts(self.pointer.cast::<f64>().add(start), length)
        }
    }

    /// Copies the values from `start`, in the order of the grid, as f64.
    pub(crate) fn gather(&self, start: usize, out: &mut [f64]) {
        match self.kind {
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
