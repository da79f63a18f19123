//! Where in memory are the four numbers of a point? Arrays of any real type, shape and strides that broadcast to one
//! shape, read block by block into the columns that [`standfast::batch`] works on.
//!
//! An operand that already is a column of f64 is used where it lies, if its numbers are read but once; a scalar is written out
//! once per thread; anything else is gathered, a block at a time. No operand is ever copied as a whole.
//!
//! A point may have no answer: where a value is missing, and where that is asked for, where one is impossible. Blocks without
//! such points pay nothing for those that have some.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use arrow_array::cast::AsArray;
use arrow_array::types::Float64Type;
use arrow_array::{Array, ArrayRef};
use arrow_buffer::NullBuffer;
use arrow_cast::cast;
use arrow_schema::DataType;
use half::f16;
use standfast::InputError;
use standfast::batch::{self, Columns, OnsetColumns};
use standfast::ground::strength::CrushPoint;

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
    /// What Arrow converts: decimals, dictionaries, nulls. Of one axis; it has no pointer.
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
    /// Which values are there, of a column of Arrow that says so.
    pub(crate) nulls: Option<NullBuffer>,
}

/// The operands of points, of one shape, and a mask of it if there is one.
#[derive(Debug, Clone)]
pub(crate) struct Grid {
    pub(crate) shape: Vec<usize>,
    /// γ, k', k and μ; ω where bases crush; then, where there is one, the mask, which is not zero where a point has no answer.
    operands: Vec<Operand>,
    /// How many of them are numbers of points: four, or five with ω.
    numbers: usize,
}

/// Points, on bases that crush if there is an ω.
#[derive(Clone, Copy)]
struct Points<'a> {
    columns: Columns<'a>,
    omega: Option<&'a [f64]>,
}

impl<'a> Points<'a> {
    fn of(columns: &'a [Vec<f64>; 5], crushes: bool) -> Points<'a> {
        let [gamma, k_prime, k, mu, omega] = columns.each_ref().map(Vec::as_slice);
        Points { columns: Columns { gamma, k_prime, k, mu }, omega: crushes.then_some(omega) }
    }

    /// That the point at `index` can be.
    fn check(&self, index: usize) -> Result<(), InputError> {
        let point = self.columns.point(index)?;
        self.omega.map_or(Ok(()), |omega| CrushPoint::of(point, omega[index]).map(drop))
    }

    fn has_nan(&self, index: usize) -> bool {
        let Columns { gamma, k_prime, k, mu } = self.columns;
        [gamma, k_prime, k, mu].into_iter().chain(self.omega).any(|column| column[index].is_nan())
    }

    /// Writes the codes; false at a value that no point can have.
    fn classify(&self, codes: &mut [u8]) -> bool {
        match self.omega {
            None => batch::classify(self.columns, codes),
            Some(omega) => batch::classify_on_base(self.columns, omega, codes),
        }
        .is_ok()
    }

    fn onset(&self, out: OnsetColumns<'_>) -> bool {
        match self.omega {
            None => batch::onset(self.columns, out),
            Some(omega) => batch::onset_on_base(self.columns, omega, out),
        }
        .is_ok()
    }
}

/// What is no error, and leaves a point without answer.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Gaps {
    /// NaN, which says that a value is missing.
    pub(crate) nan: bool,
    /// Any value that no point can have.
    pub(crate) errors: bool,
}

/// Why work was not finished.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Halt {
    /// At a point that has no mode; see [`Grid::first_invalid`].
    Invalid,
    /// [`Watch`] said so.
    Stopped,
}

/// Is told on the caller's thread, every few thousand points, how many are done; answers whether to go on.
pub(crate) type Watch<'a> = dyn FnMut(usize) -> bool + Send + 'a;

/// How work is to be done.
pub(crate) struct Labour<'a, 'w> {
    pub(crate) threads: usize,
    pub(crate) gaps: Gaps,
    /// Whether the force points right.
    pub(crate) right: bool,
    pub(crate) watch: &'a mut Watch<'w>,
}

// SAFETY: an operand is only ever read, and whoever makes one keeps its memory alive; see `Grid::new`.
#[expect(unsafe_code, reason = "threads read the arrays of their caller")]
unsafe impl Send for Operand {}
// SAFETY: as above.
#[expect(unsafe_code, reason = "threads read the arrays of their caller")]
unsafe impl Sync for Operand {}

/// Points that are gathered at a time: four columns of them stay in the second-level cache.
const BLOCK: usize = 4096;
/// Points that lie as columns are read in longer stretches: as many as are decided in a few milliseconds, should each of them
/// need exact arithmetic.
const STRETCH: usize = 4 * BLOCK;
/// Points that a thread takes at a time.
const PIECE: usize = 16 * BLOCK;

/// The operands have no common shape.
#[derive(Debug)]
pub(crate) struct ShapeMismatch;

impl Grid {
    /// Operands broadcast to their common shape by numpy's rules: the `numbers` of points, four or with ω five, and a mask if there
    /// is one.
    ///
    /// # Safety
    /// For as long as the grid or a copy of it is read, every index within an operand's shape has to lead, by its
    /// strides, to a readable number of its kind.
    #[expect(unsafe_code, reason = "the grid trusts pointers and strides")]
    pub(crate) unsafe fn new(operands: Vec<Operand>, numbers: usize) -> Result<Grid, ShapeMismatch> {
        debug_assert!(matches!(numbers, 4 | 5) && operands.len() >= numbers);
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
        let broadcast = |operand: Operand| {
            let missing = dimensions - operand.shape.len();
            let own = |axis: usize| {
                let own = axis.checked_sub(missing)?;
                (operand.shape[own] == shape[axis] && shape[axis] != 1).then(|| operand.strides[own])
            };
            let strides = (0..dimensions).map(|axis| own(axis).unwrap_or(0)).collect();
            Operand { strides, shape: shape.clone(), ..operand }
        };
        let operands = operands.into_iter().map(broadcast).collect();
        Ok(Grid { shape, operands, numbers })
    }

    pub(crate) fn len(&self) -> usize {
        self.shape.iter().product()
    }

    /// Where points without answer are to be marked: a flag for each point, none yet; empty if all have one.
    pub(crate) fn gaps(&self, allowed: Gaps) -> Vec<bool> {
        let some = self.has_gaps() || allowed.nan || allowed.errors;
        // Zeros that nobody writes to take no memory.
        vec![false; if some { self.len() } else { 0 }]
    }

    /// Whether values may be missing, NaN apart.
    fn has_gaps(&self) -> bool {
        self.operands.len() > self.numbers || self.operands.iter().any(Operand::has_nulls)
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
        let mut strides = vec![Vec::<isize>::new(); self.operands.len()];
        for &axis in axes.iter().filter(|&&axis| self.shape[axis] != 1) {
            let length = self.shape[axis];
            let own = || self.operands.iter().map(|operand| operand.strides[axis]);
            let joins = !shape.is_empty()
                && strides
                    .iter()
                    .zip(own())
                    .all(|(strides, own)| strides.last() == Some(&(own * length as isize)));
            if joins {
                *shape.last_mut().expect("there is an outer axis") *= length;
                strides.iter_mut().for_each(|strides| strides.truncate(shape.len() - 1));
            } else {
                shape.push(length);
            }
            strides.iter_mut().zip(own()).for_each(|(strides, own)| strides.push(own));
        }
        let along = |(operand, strides): (&Operand, Vec<isize>)| Operand {
            shape: shape.clone(),
            strides,
            ..operand.clone()
        };
        let operands = self.operands.iter().zip(strides).map(along).collect();
        Grid { shape, operands, numbers: self.numbers }
    }

    /// Writes the mode codes in the order of the grid, and marks the points without answer in what [`gaps`](Grid::gaps) gave.
    pub(crate) fn classify(
        &self,
        codes: &mut [u8],
        missing: &mut [bool],
        labour: Labour<'_, '_>,
    ) -> Result<(), Halt> {
        let pieces = pieces(codes, missing, self.len(), PIECE, |codes, length| codes.split_at_mut(length));
        let (gaps, right) = (labour.gaps, labour.right);
        // A mode is decided of each value as it was last read, and no value is trusted.
        let reader = || Reader::new(self, false);
        self.share(
            pieces,
            labour,
            reader,
            |reader, start, (codes, missing): (&mut [u8], &mut [bool]), pace| {
                let reach = reader.reach();
                let mut missing = missing.chunks_mut(reach);
                codes.chunks_mut(reach).enumerate().all(|(i, codes)| {
                    let missing = missing.next().unwrap_or_default();
                    let length = codes.len();
                    reader.answer(start + i * reach, length, missing, gaps, |points| {
                        let done = points.classify(codes);
                        if done && right {
                            batch::mirror(codes);
                        }
                        done
                    }) && pace.step(length)
                })
            },
        )
    }

    /// As [`classify`](Grid::classify), for what `out` asks of the onset.
    pub(crate) fn onset(
        &self,
        out: OnsetColumns<'_>,
        missing: &mut [bool],
        labour: Labour<'_, '_>,
    ) -> Result<(), Halt> {
        let out = OnsetColumns { mirrored: labour.right, ..out };
        let pieces = pieces(out, missing, self.len(), BLOCK, OnsetColumns::split_at);
        let gaps = labour.gaps;
        let last = self.len();
        self.share(
            pieces,
            labour,
            || Reader::new(self, true),
            |reader, start, (mut out, missing): (OnsetColumns<'_>, &mut [bool]), pace| {
                let length = BLOCK.min(last - start);
                reader.answer(start, length, missing, gaps, |points| points.onset(out.reborrow()))
                    && pace.step(length)
            },
        )
    }

    /// Lets threads take pieces of the output until none is left or one fails. The threads live as long as the call:
    /// no pool outlives it, which a `fork` of the process would break.
    fn share<'g, P: Send>(
        &'g self,
        pieces: impl Iterator<Item = (usize, P)> + Send,
        Labour { threads, watch, .. }: Labour<'_, '_>,
        reader: impl Fn() -> Reader<'g> + Sync,
        work: impl Fn(&mut Reader<'g>, usize, P, &mut Pace<'_, '_>) -> bool + Sync,
    ) -> Result<(), Halt> {
        let pieces = Mutex::new(pieces);
        let (done, failed, stopped) = (AtomicUsize::new(0), AtomicBool::new(false), AtomicBool::new(false));
        let take = || pieces.lock().expect("taking a piece does not panic").next();
        let labour = |watch: Option<&mut Watch<'_>>| {
            let mut reader = reader();
            let mut pace = Pace { done: &done, failed: &failed, stopped: &stopped, watch };
            while let Some((start, piece)) = take().filter(|_| !failed.load(Ordering::Relaxed)) {
                if !work(&mut reader, start, piece, &mut pace) {
                    failed.store(true, Ordering::Relaxed);
                }
            }
        };
        let threads = threads.min(self.len().div_ceil(BLOCK)).max(1);
        std::thread::scope(|scope| {
            for _ in 1..threads {
                // If the system has no more threads to give, those there are do the work.
                if std::thread::Builder::new().spawn_scoped(scope, || labour(None)).is_err() {
                    break;
                }
            }
            labour(Some(watch));
        });
        match (stopped.into_inner(), failed.into_inner()) {
            (true, _) => Err(Halt::Stopped),
            (false, true) => Err(Halt::Invalid),
            (false, false) => Ok(()),
        }
    }

    /// The first point that has no mode and is not excused, by its index in the order of the grid; `None` also where `watch` does
    /// not want to go on.
    pub(crate) fn first_invalid(&self, gaps: Gaps, watch: &mut Watch<'_>) -> Option<(usize, InputError)> {
        let mut reader = Reader::new(self, false);
        let mut missing = self.gaps(gaps);
        missing.truncate(BLOCK);
        for start in (0..self.len()).step_by(BLOCK) {
            let length = BLOCK.min(self.len() - start);
            missing.fill(false);
            let block = reader.read(start, length, &mut missing);
            let excused = |i: usize| missing.get(i) == Some(&true) || gaps.nan && block.has_nan(i);
            let wrong = (0..length).find_map(|i| Some((i, block.check(i).err().filter(|_| !excused(i))?)));
            match wrong {
                Some((i, error)) => return Some((start + i, error)),
                None if watch(start + length) => {}
                None => return None,
            }
        }
        None
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

/// An output in pieces of so many points, each with where it starts and its part of `missing`, if that is not empty.
fn pieces<T>(
    out: T,
    mut missing: &mut [bool],
    total: usize,
    length: usize,
    cut: impl Fn(T, usize) -> (T, T),
) -> impl Iterator<Item = (usize, (T, &mut [bool]))> {
    let (mut rest, mut start) = (Some(out), 0);
    std::iter::from_fn(move || {
        let length = length.min(total - start);
        let (head, tail) = cut(rest.take().filter(|_| length > 0)?, length);
        rest = Some(tail);
        let cut = length.min(missing.len());
        let (gaps, others) = std::mem::take(&mut missing).split_at_mut(cut);
        missing = others;
        start += length;
        Some((start - length, (head, gaps)))
    })
}

/// How far all threads are, as one of them sees it.
struct Pace<'a, 'w> {
    done: &'a AtomicUsize,
    failed: &'a AtomicBool,
    stopped: &'a AtomicBool,
    /// On the caller's thread.
    watch: Option<&'a mut Watch<'w>>,
}

impl Pace<'_, '_> {
    /// Counts points as done; false if no more is to be done.
    fn step(&mut self, points: usize) -> bool {
        let done = self.done.fetch_add(points, Ordering::Relaxed) + points;
        if self.watch.as_mut().is_some_and(|watch| !watch(done)) {
            self.stopped.store(true, Ordering::Relaxed);
            return false;
        }
        !self.failed.load(Ordering::Relaxed)
    }
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
    sources: Vec<(Source, Vec<f64>)>,
}

impl<'a> Reader<'a> {
    /// With `copies`, every block is copied, whatever else is done to the arrays meanwhile: for work that reads its columns more
    /// than once, and trusts what it has checked.
    fn new(grid: &'a Grid, copies: bool) -> Reader<'a> {
        let block = BLOCK.min(grid.len());
        let source = |operand: &Operand| {
            if operand.is_column() && !copies {
                (Source::Lying, Vec::new())
            } else if operand.is_same() {
                let mut value = [0.0];
                if grid.len() > 0 {
                    operand.gather(0, &mut value);
                }
                (Source::Same, vec![value[0]; block])
            } else {
                (Source::Gathered, vec![0.0; block])
            }
        };
        Reader { grid, sources: grid.operands.iter().map(source).collect() }
    }

    /// The longest block that [`read`](Reader::read) can return.
    fn reach(&self) -> usize {
        let lie = self.sources.iter().all(|(source, _)| matches!(source, Source::Lying));
        if lie { STRETCH } else { BLOCK }
    }

    /// The points from `start`. Those with a value that is missing are marked; in its place is some number that points can have.
    fn read(&mut self, start: usize, length: usize, missing: &mut [bool]) -> Points<'_> {
        let count = self.grid.numbers;
        let mut columns = [&[][..]; 5];
        for (place, ((source, buffer), operand)) in
            self.sources.iter_mut().zip(&self.grid.operands).enumerate()
        {
            let values = match source {
                Source::Lying => operand.column(start, length),
                Source::Same => &buffer[..length],
                Source::Gathered => {
                    operand.gather_marked(start, &mut buffer[..length], missing);
                    &buffer[..length]
                }
            };
            match columns[..count].get_mut(place) {
                Some(column) => *column = values,
                None => {
                    missing.iter_mut().zip(values).for_each(|(missing, &masked)| *missing |= masked != 0.0)
                }
            }
        }
        let [gamma, k_prime, k, mu, omega] = columns;
        Points { columns: Columns { gamma, k_prime, k, mu }, omega: (count == 5).then_some(omega) }
    }

    /// Lets `work`, which fails at values that no point can have, answer the points from `start`. Those without answer are marked
    /// in `missing`, which is as long as the points, or empty if all have one. False at a value that is an error.
    fn answer(
        &mut self,
        start: usize,
        length: usize,
        missing: &mut [bool],
        gaps: Gaps,
        mut work: impl FnMut(Points<'_>) -> bool,
    ) -> bool {
        let points = self.read(start, length, missing);
        if work(points) {
            return true;
        }
        // Only here are points looked at one by one, in copies: what is looked at is what is answered.
        let Columns { gamma, k_prime, k, mu } = points.columns;
        let omega = points.omega;
        let mut valid = [gamma, k_prime, k, mu, omega.unwrap_or_default()].map(<[f64]>::to_vec);
        let crushes = omega.is_some();
        for (i, missing) in missing.iter_mut().enumerate() {
            let points = Points::of(&valid, crushes);
            if *missing || points.check(i).is_err() {
                *missing |= gaps.errors || gaps.nan && points.has_nan(i);
                if !*missing {
                    return false;
                }
                valid.iter_mut().filter(|column| !column.is_empty()).for_each(|column| column[i] = VALID);
            }
        }
        work(Points::of(&valid, crushes))
    }
}

/// A slenderness, elevation, force, friction and ω that a point can have.
const VALID: f64 = 1.0;

impl Operand {
    /// Whether the values lie as f64 one after another, in the order of the grid.
    fn is_column(&self) -> bool {
        let mut step = size_of::<f64>() as isize;
        let lies = self.shape.iter().zip(&self.strides).rev().all(|(&length, &stride)| {
            let as_expected = stride == step;
            step *= length as isize;
            as_expected
        });
        let plain = matches!(self.kind, Kind::F64) && !self.has_nulls() && !self.shape.is_empty();
        plain && lies && self.pointer.cast::<f64>().is_aligned()
    }

    /// Whether the points share one value.
    fn is_same(&self) -> bool {
        !self.has_nulls() && self.strides.iter().all(|&stride| stride == 0)
    }

    /// Whether values may be missing.
    fn has_nulls(&self) -> bool {
        self.nulls.is_some() || matches!(self.kind, Kind::Arrow(_))
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
    fn gather(&self, start: usize, out: &mut [f64]) {
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

/// Whether a column of this type holds real numbers, or nothing at all.
pub(crate) fn is_number(kind: &DataType) -> bool {
    match kind {
        DataType::Dictionary(_, values) => is_number(values),
        DataType::Null => true,
        other => other.is_numeric(),
    }
}
