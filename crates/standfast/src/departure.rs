//! Departure of a body from rest as its variable loads rise.

use crate::error::InputError;
use crate::mode::Mode;
use crate::neighbour::Neighbour;
use crate::stage::Stage;
use crate::verdict::Verdict;
use crate::wrench::Wrench;

/// Departure from rest as the variable loads rise from nothing, on any base.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Departure {
    /// For no load factor above zero: the body rests under any multiple of the variable loads.
    Never,
    /// It does not rest to begin with.
    AtOnce {
        /// The verdict it begins with.
        verdict: Option<Verdict>,
        /// True if the permanent loads alone do it; otherwise any share of the variable loads does, however small.
        permanent: bool,
    },
    /// At a load factor.
    At {
        /// λ > 0.
        factor: f64,
        /// The verdict it leaves rest into.
        verdict: Option<Verdict>,
    },
}

impl Departure {
    /// The departure of a body of which `begin` holds under the permanent loads alone, along the stages that follow; they are asked for no
    /// further than needed.
    pub(crate) fn along(
        begin: Option<Verdict>,
        stages: impl IntoIterator<Item = Result<Stage, InputError>>,
    ) -> Result<Departure, InputError> {
        let mut stages = stages.into_iter();
        let moves = |verdict: &Option<Verdict>| *verdict != Some(Verdict::REST);
        if moves(&begin) {
            // As soon as anything is added, it may be another mode.
            let first = stages.next().transpose()?.map(|stage| stage.verdict).filter(moves);
            return Ok(Departure::AtOnce { verdict: first.flatten().or(begin), permanent: true });
        }
        let leaves = stages.find(|stage| stage.as_ref().map_or(true, |stage| moves(&stage.verdict)));
        Ok(leaves
            .transpose()?
            .map_or(Departure::Never, |stage| Departure::from_rest(stage.from, stage.verdict)))
    }

    /// The departure of a body that rests under the permanent loads alone, up to a load factor.
    pub(crate) fn from_rest(factor: f64, verdict: Option<Verdict>) -> Departure {
        match factor {
            f64::INFINITY => Departure::Never,
            0.0 => Departure::AtOnce { verdict, permanent: false },
            factor => Departure::At { factor, verdict },
        }
    }

    /// The verdict that the body leaves rest into.
    pub fn verdict(&self) -> Option<Verdict> {
        match *self {
            Departure::Never => None,
            Departure::AtOnce { verdict, .. } | Departure::At { verdict, .. } => verdict,
        }
    }

    /// The mode that the body leaves rest into; `None` where the ground fails, too.
    pub fn mode(&self) -> Option<Mode> {
        self.verdict().and_then(Verdict::mode)
    }

    /// The load factor up to which the body rests: zero if it moves at once, infinite if it never does.
    pub fn load_factor(&self) -> f64 {
        match *self {
            Departure::Never => f64::INFINITY,
            Departure::AtOnce { .. } => 0.0,
            Departure::At { factor, .. } => factor,
        }
    }
}

/// Values of a number with the same kind of departure.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DepartureSpan {
    /// The value at which it begins.
    pub from: f64,
    /// The value at which it ends; infinite for the last.
    pub to: f64,
    /// The departure at one value inside; load factors differ along the span.
    pub departure: Departure,
}

impl DepartureSpan {
    /// The spans of friction from zero on between those that may part them; see [`between`](DepartureSpan::between).
    pub(crate) fn by_friction(
        mut parting: Vec<f64>,
        up_to: f64,
        decide: impl Fn(f64) -> Result<Departure, InputError>,
    ) -> Result<Vec<DepartureSpan>, InputError> {
        parting.retain(|μ| *μ > 0.0 && *μ < up_to.min(HELD));
        DepartureSpan::between(0.0, parting, up_to, decide)
    }

    /// The spans from `first` on between the values that may part them, each decided at one value inside. Beyond `up_to` none is asked for,
    /// and the last span is as it is there.
    pub(crate) fn between(
        first: f64,
        mut parting: Vec<f64>,
        up_to: f64,
        decide: impl Fn(f64) -> Result<Departure, InputError>,
    ) -> Result<Vec<DepartureSpan>, InputError> {
        parting.sort_by(f64::total_cmp);
        parting.dedup_by(|later, earlier| *later - *earlier <= ONE * later.abs());
        let mut spans = Vec::new();
        let mut from = first;
        for to in parting.into_iter().chain([f64::INFINITY]) {
            let end = to.min(up_to);
            // Beyond the last value, and below the first, any will do.
            let inside = match (from.is_finite(), end.is_finite()) {
                (true, true) => from + (end - from) / 2.0,
                (true, false) => from + from.abs() + 1.0,
                (false, true) => end - end.abs() - 1.0,
                (false, false) => 1.0,
            };
            DepartureSpan { from, to, departure: decide(inside)? }.join(&mut spans);
            from = to;
        }
        Ok(spans)
    }
}

/// The frictions that just hold a body under the permanent loads, and at the load factor at which rest ends whatever the friction.
pub(crate) fn parting(permanent: &Wrench, variable: &Wrench, end: f64) -> [f64; 2] {
    let at_end = if end.is_finite() { *permanent + *variable * end } else { *variable };
    [permanent, &at_end].map(|wrench| wrench.x.abs() / wrench.p)
}

/// Friction that holds everything.
pub(crate) const HELD: f64 = 1e9;
/// Relative distance of two values that are one.
const ONE: f64 = 1e-12;

impl Neighbour for DepartureSpan {
    fn is_like(&self, next: &DepartureSpan) -> bool {
        std::mem::discriminant(&self.departure) == std::mem::discriminant(&next.departure)
            && self.departure.verdict() == next.departure.verdict()
    }

    fn prolong(&mut self, next: &DepartureSpan) {
        self.to = next.to;
    }
}
