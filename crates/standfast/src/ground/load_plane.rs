//! The plane of load factor λ and friction μ of any body on a base that gives way: what begins where.
//!
//! On rigid ground every boundary of this plane is a line or a hyperbola ([`contact::plane`]). Here it is still a
//! function μ(λ), or a vertical, but one that takes the root of a cubic, or that of the law of the ground:
//!
//! | boundary | [`LoadEdge`] | μ at λ |
//! |---|---|---|
//! | rest, slide | [`Friction`](LoadEdge::Friction) | \|X\|/P |
//! | slide, turn | [`Reaction`](LoadEdge::Reaction) | s(M ∓ b P ± P²/2q)/(dP), where the reaction reaches what an edge bears |
//! | rock, slide-rock | [`Turn`](LoadEdge::Turn) | \|X + m_x dθ̈\|/N at the rotation of rocking, a cubic's root |
//! | slide, BF | [`Bearing`](LoadEdge::Bearing) | R = P of the body that slides |
//!
//! Those of slip are divided by μ_k/μ_s, as μ is the friction to stick. At a λ the verdict is decided exactly between any two neighbouring
//! ones of these. Columns are parted where the row of verdicts and boundaries changes, to neighbouring numbers; a change and its
//! contrary within 1/500 of the range may be missed, or within 1/50 if no boundary begins, ends or crosses another with it, and boundaries nearer to each other than 1e-9 of their μ are taken as one. This is a
//! picture's precision, not that of a verdict.

use super::bearing::{FailingEdges, Ground};
use super::strength::CrushEdges;
use crate::contact::{self, Block};
use crate::error::InputError;
use crate::loads::Pose;
use crate::mode::{Corner, Mode, Slip};
use crate::quantity::Quantity;
use crate::situation::Situation;
use crate::verdict::Verdict;
use crate::wrench::Wrench;

/// A boundary of the plane, as a function μ(λ); see the [module](self).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LoadEdge {
    /// The friction that just holds a body that does not turn, to stick or (`slips`) to slip.
    Friction {
        /// True if it is that to slip.
        slips: bool,
    },
    /// The reaction of a body that slides is as near to a corner as the base bears it.
    Reaction {
        /// Direction in which it slides.
        slip: Slip,
        /// The corner.
        corner: Corner,
    },
    /// The friction that just holds a body that rocks, to stick or (`slips`) to slip.
    Turn {
        /// The corner.
        corner: Corner,
        /// True if it is that to slip.
        slips: bool,
    },
    /// The least or the largest friction with which a body that slides is borne by the ground.
    Bearing {
        /// Direction in which it slides.
        slip: Slip,
        /// True if it is the largest.
        largest: bool,
    },
}

/// A verdict between two neighbouring boundaries of a [`LoadBand`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadCell {
    /// Verdict of the problem; see [`CrushSolution::verdict`](super::strength::CrushSolution::verdict).
    pub verdict: Option<Verdict>,
    /// The boundary below; `None` for the axis, μ = 0.
    pub lower: Option<LoadEdge>,
    /// The boundary above; `None` if there is none.
    pub upper: Option<LoadEdge>,
}

/// A stretch of load factors over which the same verdicts lie between the same boundaries.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadBand {
    /// The least load factor.
    pub from: f64,
    /// The largest.
    pub to: f64,
    /// From the axis upwards.
    pub cells: Vec<LoadCell>,
}

/// Base that gives way, by crushing or by failure of the ground.
#[derive(Debug, Clone, Copy)]
enum Base {
    Crushing(CrushEdges),
    Failing(FailingEdges),
}

/// The plane of load factor and friction to stick of a situation on a base that gives way. The ratio of its frictions is kept.
#[derive(Debug, Clone)]
pub struct GroundLoadPlane {
    base: Base,
    bands: Vec<LoadBand>,
}

/// A body under loads that rise, in the situation's reduced units.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rising {
    pub(super) block: Block,
    pub(super) permanent: Wrench,
    pub(super) variable: Wrench,
    /// μ_k/μ_s.
    pub(super) ratio: f64,
}

impl Rising {
    pub(super) fn of(situation: &Situation) -> Rising {
        let at = |factor: f64| situation.reduced_wrench(&situation.wrench_at(factor, Pose::UPRIGHT));
        let block = situation.reduced_block().0;
        let permanent = at(0.0);
        let ratio = contact::with_friction(&block, 1.0).mu_k;
        Rising { block, permanent, variable: at(1.0) + permanent * -1.0, ratio }
    }

    pub(super) fn wrench(&self, factor: f64) -> Wrench {
        self.permanent + self.variable * factor
    }

    pub(super) fn block(&self, friction: f64) -> Block {
        contact::with_friction(&self.block, friction)
    }

    /// |X|/P, where the body presses.
    pub(super) fn inclination(&self, factor: f64) -> Option<f64> {
        let Wrench { x, p, .. } = self.wrench(factor);
        (p > 0.0).then(|| x.abs() / p)
    }

    /// A friction as one to stick.
    pub(super) fn sticking(&self, friction: f64, slips: bool) -> f64 {
        if slips { friction / self.ratio } else { friction }
    }
}

/// Distance of two boundaries, relatively, up to which they count as one.
const SAME: f64 = 1e-9;
/// Number of columns looked at.
const COLUMNS: usize = 500;
/// Of so many columns in a row whose boundaries stand in the same order one has its verdicts looked at.
const ALIKE: usize = 10;

impl GroundLoadPlane {
    /// On a base that crushes at `strength` q_u (Pa), from λ = 0 to `up_to`.
    ///
    /// # Errors
    /// As [`strength::outcome`](super::strength::outcome); or if `up_to` is not a number above zero.
    pub fn crushing(situation: &Situation, strength: f64, up_to: f64) -> Result<GroundLoadPlane, InputError> {
        GroundLoadPlane::of(Base::Crushing(CrushEdges::new(situation, strength)?), up_to)
    }

    /// On ground that fails.
    ///
    /// # Errors
    /// As [`bearing::outcome`](super::bearing::outcome); or if `up_to` is not a number above zero.
    pub fn failing(situation: &Situation, ground: Ground, up_to: f64) -> Result<GroundLoadPlane, InputError> {
        GroundLoadPlane::of(Base::Failing(FailingEdges::new(situation, ground)?), up_to)
    }

    fn of(base: Base, up_to: f64) -> Result<GroundLoadPlane, InputError> {
        let up_to = InputError::positive(Quantity::LoadFactor, up_to)?;
        let mut plane = GroundLoadPlane { base, bands: Vec::new() };
        plane.verdict(up_to, 1.0)?;
        plane.bands = plane.parted(up_to);
        Ok(plane)
    }

    /// The bands from λ = 0 on, each beginning where the last ended.
    pub fn bands(&self) -> &[LoadBand] {
        &self.bands
    }

    /// Verdict at (λ, μ), decided as everywhere.
    ///
    /// # Errors
    /// If a number is out of range.
    pub fn verdict(&self, factor: f64, friction: f64) -> Result<Option<Verdict>, InputError> {
        match &self.base {
            Base::Crushing(edges) => edges.verdict(factor, friction),
            Base::Failing(edges) => edges.verdict(factor, friction),
        }
    }

    /// μ of a boundary at λ; `None` where there is none.
    pub fn at(&self, edge: LoadEdge, factor: f64) -> Option<f64> {
        let friction = match &self.base {
            Base::Crushing(edges) => edges.at(edge, factor),
            Base::Failing(edges) => edges.at(edge, factor),
        };
        friction.filter(|friction| *friction >= 0.0 && friction.is_finite())
    }

    /// All boundaries that there are at λ, with their μ.
    fn all_at(&self, edges: &[LoadEdge], factor: f64) -> Vec<(f64, LoadEdge)> {
        match &self.base {
            Base::Crushing(own) => {
                edges.iter().filter_map(|edge| Some((own.at(*edge, factor)?, *edge))).collect()
            }
            Base::Failing(own) => own.all_at(edges, factor),
        }
    }

    /// All boundaries that there may be.
    fn edges(&self) -> Vec<LoadEdge> {
        let ratio = match &self.base {
            Base::Crushing(edges) => edges.rising().ratio,
            Base::Failing(edges) => edges.rising().ratio,
        };
        let (slips, corners) = ([Slip::Left, Slip::Right], [Corner::O, Corner::OPrime]);
        let frictions = if ratio < 1.0 && ratio > 0.0 { vec![false, true] } else { vec![false] };
        let mut all: Vec<_> = frictions.iter().map(|slips| LoadEdge::Friction { slips: *slips }).collect();
        match &self.base {
            Base::Crushing(_) => {
                for corner in corners {
                    all.extend(slips.map(|slip| LoadEdge::Reaction { slip, corner }));
                    all.extend(frictions.iter().map(|slips| LoadEdge::Turn { corner, slips: *slips }));
                }
            }
            Base::Failing(_) => {
                for slip in slips {
                    all.extend([false, true].map(|largest| LoadEdge::Bearing { slip, largest }));
                }
            }
        }
        all
    }

    /// The boundaries at a load factor, from the axis upwards.
    fn boundaries(&self, edges: &[LoadEdge], factor: f64) -> Vec<(f64, LoadEdge)> {
        let mut above = self.all_at(edges, factor);
        above.retain(|(mu, _)| *mu > 0.0 && mu.is_finite());
        crate::order::by_number(&mut above, |one| one.0);
        above.dedup_by(|later, earlier| later.0 - earlier.0 <= SAME * later.0);
        above
    }

    /// The row of verdicts at a load factor, between its boundaries.
    fn cells(&self, boundaries: Vec<(f64, LoadEdge)>, factor: f64) -> Vec<LoadCell> {
        let mut cells: Vec<LoadCell> = Vec::new();
        let mut lower: (f64, Option<LoadEdge>) = (0.0, None);
        for next in boundaries.into_iter().map(Some).chain([None]) {
            let inside = next.map_or(2.0 * lower.0 + 1.0, |(mu, _)| lower.0 + (mu - lower.0) / 2.0);
            let upper = next.map(|(_, edge)| edge);
            let verdict = self.verdict(factor, inside).unwrap_or(None);
            match cells.last_mut() {
                Some(last) if last.verdict == verdict => last.upper = upper,
                _ => cells.push(LoadCell { verdict, lower: lower.1, upper }),
            }
            if let Some((mu, edge)) = next {
                lower = (mu, Some(edge));
            }
        }
        cells
    }

    fn parted(&self, up_to: f64) -> Vec<LoadBand> {
        let edges = self.edges();
        let column = |factor: f64| self.cells(self.boundaries(&edges, factor), factor);
        // Off round numbers, at which loads are in balance.
        let place = |i: usize| up_to * (i as f64 + 0.437) / (COLUMNS as f64 + 0.437);
        let mut bands: Vec<LoadBand> = Vec::new();
        let (mut low, mut cells) = (0.0, column(1e-9 * up_to));
        let mut from = 0.0;
        let mut order: Vec<LoadEdge> = Vec::new();
        for (i, high) in (0..=COLUMNS).map(|i| (i, place(i))) {
            let boundaries = self.boundaries(&edges, high);
            let is_as_before = boundaries.iter().map(|(_, edge)| *edge).eq(order.iter().copied());
            // A verdict changes across a boundary, or across a vertical, which is seen a little later.
            if is_as_before && !i.is_multiple_of(ALIKE) {
                continue;
            }
            order = boundaries.iter().map(|(_, edge)| *edge).collect();
            // What lies between two columns that differ, in order.
            let mut waiting = vec![(high, self.cells(boundaries, high))];
            while let Some((high, next)) = waiting.last() {
                if *next == cells {
                    low = *high;
                    waiting.pop();
                    continue;
                }
                let middle = low + (high - low) / 2.0;
                if high - low > 1e-15 * up_to && middle > low && middle < *high {
                    waiting.push((middle, column(middle)));
                    continue;
                }
                bands.push(LoadBand { from, to: *high, cells });
                (from, low) = (*high, *high);
                cells = next.clone();
                waiting.pop();
            }
        }
        bands.push(LoadBand { from, to: up_to, cells });
        // Where boundaries cross they are one for a moment: the next band begins there.
        let narrow = 1e-7 * up_to;
        let mut wide: Vec<LoadBand> = Vec::new();
        let mut from = 0.0;
        for band in bands {
            match wide.last_mut() {
                _ if band.to - from <= narrow && band.to < up_to => {}
                Some(last) if last.cells == band.cells => {
                    last.to = band.to;
                    from = band.to;
                }
                _ => {
                    wide.push(LoadBand { from, ..band });
                    from = wide[wide.len() - 1].to;
                }
            }
        }
        wide
    }
}

/// Mode that begins on rigid ground.
pub(super) fn rigid(rising: &Rising, factor: f64, friction: f64) -> Result<Option<Mode>, InputError> {
    Ok(contact::solve(&rising.block(friction), &rising.wrench(factor))?.mode())
}
