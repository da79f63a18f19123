//! Grid of points: the four numbers of each in memory. Arrays of any real type, shape and strides that broadcast to one
//! shape, read block by block into the columns that [`standfast::batch`] works on.
//!
//! An operand that already is a column of f64 is used where it lies, if its numbers are read but once; a scalar is written out
//! once per thread; anything else is gathered, a block at a time. No operand is ever copied as a whole.
//!
//! A point may have no answer: where a value is missing, and where that is asked for, where one is impossible. Blocks without
//! such points pay nothing for those that have some.

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use standfast::InputError;
use standfast::batch::{self, LimitColumn, OnsetColumns};

use crate::operand::Operand;
use crate::reader::{BLOCK, Gaps, Reader};

/// The operands of points, of one shape, and a mask of it if there is one.
#[derive(Debug, Clone)]
pub(crate) struct Grid {
    pub(crate) shape: Vec<usize>,
    /// γ, k', k and μ; ω where bases crush; then, where there is one, the mask, which is not zero where a point has no answer.
    pub(crate) operands: Vec<Operand>,
    /// Number of operands that are numbers of points: four, or five with ω.
    pub(crate) numbers: usize,
}

/// Reason why work was not finished.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Halt {
    /// At a point that has no mode; see [`Grid::first_invalid`].
    Invalid,
    /// [`Watch`] said so.
    Stopped,
}

/// Is told on the caller's thread, every few thousand points, how many are done; answers whether to go on.
pub(crate) type Watch<'a> = dyn FnMut(usize) -> bool + Send + 'a;

/// Terms of the work.
pub(crate) struct Labour<'a, 'w> {
    pub(crate) threads: usize,
    pub(crate) gaps: Gaps,
    /// True if the force points right.
    pub(crate) right: bool,
    pub(crate) watch: &'a mut Watch<'w>,
}

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

    /// Flags for points without answer: one for each point, none yet; empty if all have one.
    pub(crate) fn gaps(&self, allowed: Gaps) -> Vec<bool> {
        let some = self.has_gaps() || allowed.nan || allowed.errors;
        // Zeros that nobody writes to take no memory.
        vec![false; if some { self.len() } else { 0 }]
    }

    /// True if values may be missing, NaN apart.
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

    /// As [`classify`](Grid::classify), for limit states, each into its column.
    pub(crate) fn limit_states(
        &self,
        out: Vec<LimitColumn<'_>>,
        missing: &mut [bool],
        labour: Labour<'_, '_>,
    ) -> Result<(), Halt> {
        let pieces = pieces(out, missing, self.len(), BLOCK, |out, length| {
            out.into_iter().map(|column| column.split_at(length)).unzip()
        });
        let gaps = labour.gaps;
        let last = self.len();
        self.share(
            pieces,
            labour,
            // The kernel copies what it has checked.
            || Reader::new(self, false),
            |reader, start, (mut out, missing): (Vec<LimitColumn<'_>>, &mut [bool]), pace| {
                let length = BLOCK.min(last - start);
                reader.answer(start, length, missing, gaps, |points| points.limit_states(&mut out))
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

/// Progress of all threads, as one of them sees it.
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
