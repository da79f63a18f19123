//! One thread's view of a grid: its points in blocks, as columns.

use standfast::InputError;
use standfast::batch::{self, Columns, LimitColumn, OnsetColumns};
use standfast::ground::strength::CrushPoint;

use crate::grid::Grid;
use crate::operand::{Operand, VALID};

/// Points that are gathered at a time: four columns of them stay in the second-level cache.
pub(crate) const BLOCK: usize = 4096;
/// Points that lie as columns are read in longer stretches: as many as are decided in a few milliseconds, should each of them
/// need exact arithmetic.
const STRETCH: usize = 4 * BLOCK;
/// Points, on bases that crush if there is an ω.
#[derive(Clone, Copy)]
pub(crate) struct Points<'a> {
    columns: Columns<'a>,
    omega: Option<&'a [f64]>,
}

impl<'a> Points<'a> {
    fn of(columns: &'a [Vec<f64>; 5], crushes: bool) -> Points<'a> {
        let [gamma, k_prime, k, mu, omega] = columns.each_ref().map(Vec::as_slice);
        Points { columns: Columns { gamma, k_prime, k, mu }, omega: crushes.then_some(omega) }
    }

    /// That the point at `index` can be.
    pub(crate) fn check(&self, index: usize) -> Result<(), InputError> {
        let point = self.columns.point(index)?;
        self.omega.map_or(Ok(()), |omega| CrushPoint::of(point, omega[index]).map(drop))
    }

    pub(crate) fn has_nan(&self, index: usize) -> bool {
        let Columns { gamma, k_prime, k, mu } = self.columns;
        [gamma, k_prime, k, mu].into_iter().chain(self.omega).any(|column| column[index].is_nan())
    }

    /// Writes the codes; false at a value that no point can have.
    pub(crate) fn classify(&self, codes: &mut [u8]) -> bool {
        match self.omega {
            None => batch::classify(self.columns, codes),
            Some(omega) => batch::classify_on_base(self.columns, omega, codes),
        }
        .is_ok()
    }

    pub(crate) fn onset(&self, out: OnsetColumns<'_>) -> bool {
        match self.omega {
            None => batch::onset(self.columns, out),
            Some(omega) => batch::onset_on_base(self.columns, omega, out),
        }
        .is_ok()
    }

    /// Writes limit states, of which a base that crushes has none other; false at a value that no point can have.
    pub(crate) fn limit_states(&self, out: &mut [LimitColumn<'_>]) -> bool {
        batch::limit_states(self.columns, out).is_ok()
    }
}

/// Values that are no error, and leave a point without answer.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Gaps {
    /// NaN, which says that a value is missing.
    pub(crate) nan: bool,
    /// Any value that no point can have.
    pub(crate) errors: bool,
}

/// Source of one of a thread's columns.
enum Source {
    /// The operand is one.
    Lying,
    /// Every value is the same, and is written in the buffer.
    Same,
    /// Blocks are gathered in the buffer.
    Gathered,
}

/// One thread's view of a grid.
pub(crate) struct Reader<'a> {
    grid: &'a Grid,
    sources: Vec<(Source, Vec<f64>)>,
}

impl<'a> Reader<'a> {
    /// With `copies`, every block is copied, whatever else is done to the arrays meanwhile: for work that reads its columns more
    /// than once, and trusts what it has checked.
    pub(crate) fn new(grid: &'a Grid, copies: bool) -> Reader<'a> {
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
    pub(crate) fn reach(&self) -> usize {
        let lie = self.sources.iter().all(|(source, _)| matches!(source, Source::Lying));
        if lie { STRETCH } else { BLOCK }
    }

    /// The points from `start`. Those with a value that is missing are marked; in its place is some number that points can have.
    pub(crate) fn read(&mut self, start: usize, length: usize, missing: &mut [bool]) -> Points<'_> {
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
    pub(crate) fn answer(
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
