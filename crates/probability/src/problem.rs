//! Problems: [random inputs](RandomVector), and outcomes that are known along one of them.
//!
//! For given values of all inputs but one, each outcome holds on intervals of that one, its *line*. Then no sample of the line
//! is needed, and no indicator is averaged: given the others, an outcome's probability is that of its intervals, a continuous
//! function. It is smooth but where its [`Pieces`] change their pattern, which their signature tells.

pub use crate::inputs::{GivenLaw, RandomVector};
use crate::law::Distribution;
use crate::normal;

/// An interval of the line on which an outcome holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OutcomePiece {
    /// Its lower end; −∞ if it has none.
    pub from: f64,
    /// Its upper end; ∞ if it has none.
    pub to: f64,
    /// The outcome's number.
    pub outcome: usize,
}

/// The intervals of a line, and the pattern they make.
#[derive(Debug, Clone, Default)]
pub struct Pieces {
    pieces: Vec<OutcomePiece>,
    signature: u64,
}

impl Pieces {
    pub(crate) fn clear(&mut self) {
        self.pieces.clear();
        self.signature = 0;
    }

    /// Adds an interval; one that is empty is left out. Intervals of outcomes that exclude each other do not overlap.
    pub fn push(&mut self, from: f64, to: f64, outcome: usize) {
        if from < to {
            self.pieces.push(OutcomePiece { from, to, outcome });
            self.branch(outcome as u64);
        }
    }

    /// Notes which of several formulas applied: where the number changes, the intervals' ends have a kink.
    pub fn branch(&mut self, which: u64) {
        self.signature = mixed(self.signature, which);
    }

    /// A number for the pattern they make, which those have that are built on these.
    pub fn signature(&self) -> u64 {
        self.signature
    }

    /// The intervals.
    pub fn iter(&self) -> impl Iterator<Item = &OutcomePiece> {
        self.pieces.iter()
    }

    /// Finds the intervals of a line by its law: a scan, and where the outcomes change from one value to the next, bisection
    /// to the last bit. For lines whose boundaries have no closed form. `marks` are values that are looked at beside those of the scan, in any
    /// order: those on both sides of outcomes that hold on less than its step. `at` gives the outcomes that hold, a bit for each.
    pub fn scan(&mut self, law: &Distribution, marks: &[f64], at: impl Fn(f64) -> u64) {
        let mut values = scanned(law, marks).into_iter();
        let Some(first) = values.next() else { return };
        let mut from = f64::NEG_INFINITY;
        let (mut x, mut holds) = (first, at(first));
        for end in values {
            let then = at(end);
            while holds != then {
                // The first change: what follows it may change again before the end.
                let (mut low, mut high, mut beyond) = (x, end, then);
                loop {
                    let middle = 0.5 * (low + high);
                    if middle <= low || middle >= high {
                        break;
                    }
                    let here = at(middle);
                    if here == holds { low = middle } else { (high, beyond) = (middle, here) }
                }
                self.push_all(from, high, holds);
                (from, x, holds) = (high, high, beyond);
            }
            x = end;
        }
        self.push_all(from, f64::INFINITY, holds);
    }

    /// Moves each end that lies at one of these values, rising, to the side on which it leaves the value, as the outcomes at the value say.
    fn settle(&mut self, atoms: &[f64], mut at: impl FnMut(f64) -> u64) {
        /// Relative to a value, how far off a boundary may be found that lies at it.
        const NEAR: f64 = 1e-12;
        let near = |end: f64| {
            let next = atoms.partition_point(|atom| *atom < end);
            let beside = [next.checked_sub(1), Some(next)];
            let atoms = beside.into_iter().flatten().filter_map(|place| atoms.get(place).copied());
            atoms
                .min_by(|a, b| (a - end).abs().total_cmp(&(b - end).abs()))
                .filter(|atom| (atom - end).abs() <= NEAR * atom.abs())
        };
        let ends = self.pieces.iter().flat_map(|piece| [piece.from, piece.to]);
        let mut met: Vec<(f64, u64)> = ends.filter_map(near).map(|atom| (atom, 0)).collect();
        met.sort_by(|a, b| a.0.total_cmp(&b.0));
        met.dedup_by_key(|(atom, _)| *atom);
        met.iter_mut().for_each(|(atom, outcomes)| *outcomes = at(*atom));
        let outcomes_at =
            |atom: f64| met.iter().find(|(known, _)| *known == atom).map_or(0, |(_, outcomes)| *outcomes);
        for piece in &mut self.pieces {
            let holds = |atom: f64| outcomes_at(atom) >> piece.outcome & 1 == 1;
            let [from, to] = [near(piece.from), near(piece.to)];
            if let Some(atom) = from {
                piece.from = if holds(atom) { atom } else { atom.next_up() };
            }
            if let Some(atom) = to {
                piece.to = if holds(atom) { atom.next_up() } else { atom };
            }
        }
        self.pieces.retain(|piece| piece.from < piece.to);
        // What holds at the value alone.
        for (atom, outcomes) in met {
            let has = |outcome: usize| {
                self.pieces.iter().any(|p| p.outcome == outcome && p.from <= atom && atom < p.to)
            };
            let alone: Vec<usize> =
                (0..64).filter(|outcome| outcomes >> outcome & 1 == 1 && !has(*outcome)).collect();
            alone.into_iter().for_each(|outcome| self.push(atom, atom.next_up(), outcome));
        }
    }

    fn push_all(&mut self, from: f64, to: f64, outcomes: u64) {
        let mut rest = outcomes;
        while rest != 0 {
            self.push(from, to, rest.trailing_zeros() as usize);
            rest &= rest - 1;
        }
    }
}

/// Into how many steps a range is cut in search of changes.
const SCAN: u32 = 192;

/// The values of a law at which a line is looked at, rising: even in its normal, where the law is not smooth, and at these marks between the ends.
pub(crate) fn scanned(law: &Distribution, marks: &[f64]) -> Vec<f64> {
    let value = |i: u32| law.value(crate::REACH * (2.0 * f64::from(i) / f64::from(SCAN) - 1.0));
    let (first, last) = (value(0), value(SCAN));
    let breaks = law.breaks();
    let marks = marks.iter().chain(&breaks).copied().filter(|mark| first < *mark && *mark < last);
    let mut values: Vec<f64> = (0..=SCAN).map(value).chain(marks).collect();
    values.sort_by(f64::total_cmp);
    values
}

/// Two numbers made one, so that another pair makes another.
pub(crate) fn mixed(a: u64, b: u64) -> u64 {
    (a.rotate_left(5) ^ b.wrapping_add(1)).wrapping_mul(0x9e37_79b9_7f4a_7c15)
}

/// Outcomes of random inputs, known along one of them.
pub trait Outcomes: Sync {
    /// Number of outcomes, at most 64.
    fn count(&self) -> usize;

    /// The number of the input along which the outcomes' boundaries are known.
    fn line(&self) -> usize;

    /// The intervals of the line for these values of the inputs; that of the line itself is not to be read.
    fn along(&self, values: &[f64], pieces: &mut Pieces);

    /// Number of lines that are best asked for at once, where that is quicker than one after the other.
    fn at_once(&self) -> usize {
        1
    }

    /// The intervals of several lines, as [`along`](Outcomes::along) adds them.
    fn along_each(&self, values: &[Vec<f64>], pieces: &mut [Pieces]) {
        values.iter().zip(pieces).for_each(|(values, pieces)| self.along(values, pieces));
    }

    /// True if the outcomes are quicker to find again for another value of this input alone.
    fn is_quick(&self, input: usize) -> bool {
        let _ = input;
        false
    }

    /// The outcomes that hold for these values of all inputs, a bit for each.
    fn at(&self, values: &[f64]) -> u64;

    /// The outcomes that hold at several points: of each input a column of its values, all of one length. Asked for where more is best done
    /// [at once](Outcomes::at_once).
    fn at_each(&self, columns: &[Vec<f64>], found: &mut [u64]) {
        let mut values = vec![0.0; columns.len()];
        for (row, found) in found.iter_mut().enumerate() {
            values.iter_mut().zip(columns).for_each(|(value, column)| *value = column[row]);
            *found = self.at(&values);
        }
    }
}

/// An end of a piece: its value, the line's independent normal there, and the probability beyond it in the nearer tail.
#[derive(Clone, Copy)]
struct End {
    x: f64,
    u: f64,
    tail: f64,
}

impl End {
    /// The probability from here to another end, as a difference in the nearer tail; 0 if that is not above.
    fn until(&self, to: &End) -> f64 {
        if to.u <= self.u {
            0.0
        } else if self.u > 0.0 {
            self.tail - to.tail
        } else if to.u > 0.0 {
            1.0 - to.tail - self.tail
        } else {
            to.tail - self.tail
        }
    }
}

/// A problem seen in independent standard normals: those of all inputs but the line's, in an order of choice.
pub(crate) struct Frame<'a, O> {
    pub(crate) inputs: &'a RandomVector,
    pub(crate) outcomes: &'a O,
    /// The places of the inputs: the one that is held, if any, the others, and the line last (or first, if it is held).
    order: Vec<usize>,
    factor: Vec<Vec<f64>>,
    /// The places in the order of all inputs but the line, each after those that its law depends on.
    sequence: Vec<usize>,
    held: Held,
    /// Of the input at each place of the order, the normals between which it is smooth, or has one value, rising.
    breaks: Vec<Vec<f64>>,
    /// The line's values with a probability of their own.
    atoms: Vec<f64>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Held {
    Nothing,
    Other,
    Line,
}

/// Working memory of an evaluation.
pub(crate) struct Scratch {
    u: Vec<f64>,
    values: Vec<f64>,
    pieces: Pieces,
    /// The probability of each outcome at the point.
    shares: Vec<f64>,
}

impl Scratch {
    /// The probability of a set of outcomes, a bit for each, at the point.
    pub(crate) fn of_set(&self, set: u64) -> f64 {
        self.shares
            .iter()
            .enumerate()
            .filter(|(outcome, _)| set >> outcome & 1 == 1)
            .map(|(_, share)| share)
            .sum()
    }
}

impl<'a, O: Outcomes> Frame<'a, O> {
    /// The problem with the inputs in the order given, the line last.
    pub(crate) fn new(inputs: &'a RandomVector, outcomes: &'a O) -> Frame<'a, O> {
        Frame::ordered(inputs, outcomes, None, |_| ())
    }

    /// Orders the inputs by a rank, the line last.
    pub(crate) fn ranked<R: Ord>(
        inputs: &'a RandomVector,
        outcomes: &'a O,
        rank: impl Fn(usize) -> R,
    ) -> Frame<'a, O> {
        Frame::ordered(inputs, outcomes, None, rank)
    }

    /// Holds one input at its median.
    pub(crate) fn holding(inputs: &'a RandomVector, outcomes: &'a O, held: usize) -> Frame<'a, O> {
        Frame::ordered(inputs, outcomes, Some(held), |_| ())
    }

    fn ordered<R: Ord>(
        inputs: &'a RandomVector,
        outcomes: &'a O,
        held: Option<usize>,
        rank: impl Fn(usize) -> R,
    ) -> Frame<'a, O> {
        let line = outcomes.line();
        let mut others: Vec<usize> =
            (0..inputs.laws().len()).filter(|i| *i != line && Some(*i) != held).collect();
        // What has a few values is summed over, the outermost, so that between them nothing has to be sought.
        others.sort_by_key(|i| (rank(*i), !inputs.laws()[*i].is_discrete(), outcomes.is_quick(*i)));
        let order: Vec<usize> = match held {
            Some(held) if held == line => std::iter::once(line).chain(others).collect(),
            held => held.into_iter().chain(others).chain([line]).collect(),
        };
        let factor = inputs.copula().factor(&order).expect("a copula is positive definite in any order");
        let held = match held {
            None => Held::Nothing,
            Some(held) if held == line => Held::Line,
            Some(_) => Held::Other,
        };
        let breaks = order.iter().map(|input| inputs.laws()[*input].breaks_of_normal()).collect();
        let atoms = inputs.laws()[line].atoms();
        assert!(!inputs.is_parent(line), "no law depends on the line");
        let mut sequence: Vec<usize> = (0..order.len()).filter(|place| order[*place] != line).collect();
        if inputs.has_given() {
            sequence.sort_by_key(|place| inputs.rank(order[*place]));
        }
        Frame { inputs, outcomes, order, factor, sequence, held, breaks, atoms }
    }

    /// The intervals of the line for these values of the other inputs. What holds at a value with a probability of its own is decided there: on which
    /// side of a boundary it lies, an interval's end can't say.
    fn along(&self, values: &mut [f64], pieces: &mut Pieces) {
        pieces.clear();
        self.outcomes.along(values, pieces);
        self.settle(values, pieces);
    }

    /// Decides what holds at the line's values with probabilities of their own.
    fn settle(&self, values: &mut [f64], pieces: &mut Pieces) {
        if !self.atoms.is_empty() {
            let line = self.outcomes.line();
            pieces.settle(&self.atoms, |atom| {
                values[line] = atom;
                self.outcomes.at(values)
            });
        }
    }

    /// Values of the normal with number `depth` between which its input is smooth, or has one value, given the normals before it; rising.
    pub(crate) fn breaks(&self, depth: usize, point: &[f64]) -> impl Iterator<Item = f64> {
        let place = self.place_of(depth);
        let row = &self.factor[place];
        let mean: f64 = row[place - depth..place].iter().zip(point).map(|(a, b)| a * b).sum();
        let deviation = row[place];
        self.breaks[place].iter().map(move |z| (z - mean) / deviation)
    }

    /// The place in the order of the input that the normal with number `depth` moves.
    fn place_of(&self, depth: usize) -> usize {
        depth + usize::from(self.held != Held::Nothing)
    }

    /// True if between two of its breaks nothing depends on the normal with number `depth`: its input has values with probabilities of their own
    /// alone, and no input after it is correlated with it.
    pub(crate) fn is_stepped(&self, depth: usize) -> bool {
        let place = self.place_of(depth);
        self.inputs.laws()[self.order[place]].is_discrete()
            && self.factor[place + 1..].iter().all(|row| row[place] == 0.0)
    }

    /// The number of independent standard normals a point has.
    pub(crate) fn dimensions(&self) -> usize {
        self.inputs.laws().len() - 1 - usize::from(self.held == Held::Other)
    }

    pub(crate) fn scratch(&self) -> Scratch {
        let n = self.inputs.laws().len();
        let shares = vec![0.0; self.outcomes.count()];
        Scratch { u: vec![0.0; n], values: vec![0.0; n], pieces: Pieces::default(), shares }
    }

    /// Puts the values of all inputs but the line's at a point, and gives mean and deviation of the line's normal there.
    fn place(&self, point: &[f64], scratch: &mut Scratch) -> (f64, f64) {
        let Scratch { u, values, .. } = scratch;
        u.fill(0.0);
        let at = usize::from(self.held != Held::Nothing);
        u[at..at + point.len()].copy_from_slice(point);
        let mean = |i: usize| self.factor[i][..i].iter().zip(u.iter()).map(|(a, b)| a * b).sum::<f64>();
        for &i in &self.sequence {
            let (input, z) = (self.order[i], mean(i) + self.factor[i][i] * u[i]);
            values[input] = self.inputs.value(input, z, values);
        }
        let last = self.order.len() - 1;
        if self.held == Held::Line { (0.0, 0.0) } else { (mean(last), self.factor[last][last]) }
    }

    /// The outcomes' probabilities given a point, in `scratch.shares`, and the signature of the pattern there.
    pub(crate) fn evaluate(&self, point: &[f64], scratch: &mut Scratch) -> u64 {
        let line = self.place(point, scratch);
        self.along(&mut scratch.values, &mut scratch.pieces);
        self.share(line, scratch)
    }

    /// As [`evaluate`](Self::evaluate), of several points at once; a scratch for each.
    pub(crate) fn evaluate_each(&self, points: &[Vec<f64>], scratches: &mut [Scratch]) {
        let scratches = &mut scratches[..points.len()];
        let lines: Vec<(f64, f64)> =
            points.iter().zip(&mut *scratches).map(|(point, scratch)| self.place(point, scratch)).collect();
        let mut values: Vec<Vec<f64>> =
            scratches.iter_mut().map(|one| std::mem::take(&mut one.values)).collect();
        let mut pieces: Vec<Pieces> =
            scratches.iter_mut().map(|one| std::mem::take(&mut one.pieces)).collect();
        pieces.iter_mut().for_each(Pieces::clear);
        self.outcomes.along_each(&values, &mut pieces);
        values.iter_mut().zip(&mut pieces).for_each(|(values, pieces)| self.settle(values, pieces));
        for (((scratch, line), values), pieces) in scratches.iter_mut().zip(lines).zip(values).zip(pieces) {
            (scratch.values, scratch.pieces) = (values, pieces);
            self.share(line, scratch);
        }
    }

    /// The outcomes' probabilities of the intervals that were found, given mean and deviation of the line's normal, and the signature.
    fn share(&self, (mean, deviation): (f64, f64), scratch: &mut Scratch) -> u64 {
        let Scratch { values, pieces, shares, .. } = scratch;
        let law = self.inputs.law_at(self.outcomes.line(), values);
        let corners = &self.breaks[self.order.len() - 1];
        shares.fill(0.0);
        let mut signature = pieces.signature;
        if deviation == 0.0 {
            let median = law.median();
            for piece in &pieces.pieces {
                let inside = piece.from <= median && median < piece.to;
                shares[piece.outcome] += f64::from(u8::from(inside));
                signature = mixed(signature, u64::from(inside));
            }
            return signature;
        }
        // One piece mostly begins where another ends.
        let mut last: Option<End> = None;
        for piece in &pieces.pieces {
            let mut end = |x: f64| match last {
                Some(end) if end.x == x => end,
                _ => {
                    let u = (law.z(x) - mean) / deviation;
                    let end = End { x, u, tail: normal::above(u.abs()) };
                    last = Some(end);
                    end
                }
            };
            let (from, to) = (end(piece.from), end(piece.to));
            shares[piece.outcome] += from.until(&to);
            // Where an end leaves what the law has values for, or passes a corner of it, the probability has a kink.
            let corner =
                |end: &End| corners.partition_point(|corner| (corner - mean) / deviation < end.u) as u64;
            let ends = u64::from(from.u.is_finite()) | u64::from(to.u.is_finite()) << 1;
            signature = mixed(signature, ends | corner(&from) << 2 | corner(&to) << 32);
        }
        signature
    }

    /// The intervals of the line's normal, in independent units, on which each outcome holds at a point.
    pub(crate) fn intervals(&self, point: &[f64], scratch: &mut Scratch, mut each: impl FnMut(OutcomePiece)) {
        let (mean, deviation) = self.place(point, scratch);
        let Scratch { values, pieces, .. } = scratch;
        self.along(values, pieces);
        let law = self.inputs.law_at(self.outcomes.line(), values);
        let reach = |x: f64| (law.z(x) - mean) / deviation;
        for piece in pieces.iter() {
            each(OutcomePiece { from: reach(piece.from), to: reach(piece.to), ..*piece });
        }
    }

    /// The places of the inputs in the order of the frame's normals, the line last.
    pub(crate) fn order(&self) -> &[usize] {
        &self.order
    }

    /// By how much the line's normal depends on that of the input at each place of the order.
    pub(crate) fn line_on(&self) -> &[f64] {
        &self.factor[self.factor.len() - 1]
    }

    /// The value of the line's normal nearest to 0 at which one of these outcomes holds (a bit for each), in independent units;
    /// none if none does.
    pub(crate) fn nearest(&self, point: &[f64], which: u64, scratch: &mut Scratch) -> Option<f64> {
        let (mean, deviation) = self.place(point, scratch);
        let Scratch { values, pieces, .. } = scratch;
        self.along(values, pieces);
        let law = self.inputs.law_at(self.outcomes.line(), values);
        let reach = |x: f64| (law.z(x) - mean) / deviation;
        pieces
            .iter()
            .filter(|piece| which >> piece.outcome & 1 == 1)
            .filter_map(|piece| {
                let (from, to) = (reach(piece.from), reach(piece.to));
                // Not where the law has no values.
                (from < to).then(|| 0f64.clamp(from, to))
            })
            .min_by(|a, b| a.abs().total_cmp(&b.abs()))
    }

    /// A point and the line's normal there, as independent normals in the order in which the inputs are given.
    pub(crate) fn in_given_order(&self, point: &[f64], line: f64) -> Vec<f64> {
        let u: Vec<f64> = point.iter().copied().chain([line]).collect();
        let mut z = vec![0.0; u.len()];
        for (i, &input) in self.order.iter().enumerate() {
            z[input] = self.factor[i].iter().zip(&u).map(|(a, b)| a * b).sum();
        }
        self.inputs.copula().independent_of(&z)
    }

    /// The independent normals that a point has, from those of all inputs in the order in which they are given: without the line's, and
    /// without that of an input that is held.
    pub(crate) fn others_of(&self, u: &[f64]) -> Vec<f64> {
        let z = self.inputs.copula().correlated(u);
        let mut point: Vec<f64> = Vec::with_capacity(z.len());
        for (row, &input) in self.factor.iter().zip(&self.order) {
            let known: f64 = row.iter().zip(&point).map(|(a, b)| a * b).sum();
            point.push((z[input] - known) / row[point.len()]);
        }
        let first = usize::from(self.held != Held::Nothing);
        point[first..first + self.dimensions()].to_vec()
    }
}
