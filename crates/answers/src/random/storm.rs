//! Sliding of the body over a life of storms: the `[storm]` table.
//!
//! ```toml
//! [storm]
//! waves = 1000                      # or duration, and the waves' period
//! heights = "rayleigh"              # P(H > h) = exp(−(1.416 h/H_1/3)²), cut at H_max of the sea
//! tau0 = "1.5 s"                    # or "shimosako-takahashi"
//! ```
//!
//! One storm a year. Each wave gives a thrust P and an uplift U, which slide the body by a pulse of duration τ₀ ([`pulse`]) if its
//! mode is sliding. A wave that begins a rotation is none for this formula: it is counted apart, with its probability.
//!
//! The mean over lives is integrated; their law is found from lives of which only the waves are drawn that move the body
//! ([`standfast_probability::sums`]).

mod answer;
mod pulse;
mod pure;
mod read;
mod rotation;
mod sea;

use standfast_probability::legendre::panel;
use standfast_probability::sums::{EventMeans, OtherEvent, Sums};

pub use answer::{Exceedance, FollowedWaves, Quantile, RotatingWaves, Sliding, SlidingError};
pub use pulse::Pulse;
pub use pure::StormField;
pub(super) use pure::{PureStorm, of_file};
pub(super) use read::storm;
pub(super) use sea::of_case;

/// A storm as it is written.
#[derive(Debug, Clone, PartialEq)]
pub struct Storm {
    /// Number of waves.
    pub waves: u64,
    /// Duration of a wave's push.
    pub(super) tau0: Tau0,
    /// Method by which the slide is found.
    pub pulse: Pulse,
    /// True if heights are cut at H_max of the sea.
    pub(super) is_cut: bool,
    /// Its equal parts.
    pub parts: Vec<StormPart>,
    /// The name of the combination under which its waves come.
    pub combination: Option<String>,
}

/// A part of a storm: what its sea is over that of the peak, and by how much the water stands higher than in the case, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StormPart {
    /// Factor on wave heights in deep water, or on those at the wall where these are given.
    pub height: f64,
    /// Rise of the water level, m.
    pub rise: f64,
}

impl StormPart {
    /// The peak.
    pub const PEAK: StormPart = StormPart { height: 1.0, rise: 0.0 };
}

impl Storm {
    /// True if the duration of a pulse is Shimosako and Takahashi's.
    pub fn has_formula(&self) -> bool {
        self.tau0 == Tau0::Formula
    }
}

/// The duration of a pulse.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Tau0 {
    /// In seconds.
    Given(f64),
    /// By Shimosako and Takahashi, from the wave's height and period.
    Formula,
}

/// The factor of Rayleigh's law: H_1/3 = 1.416 √(mean square of heights).
const RAYLEIGH: f64 = 1.416;

/// The level t = (1.416 h/H_1/3)² of a height: heights exceed it with exp(−t).
fn level(height: f64, significant: f64) -> f64 {
    (RAYLEIGH * height / significant).powi(2)
}

/// The height at a level.
fn height(level: f64, significant: f64) -> f64 {
    level.sqrt() * significant / RAYLEIGH
}

/// One year's storm: its equal parts, but those in which nothing moves the body.
pub(super) struct Year<W> {
    parts: Vec<Part<W>>,
    /// The share of all waves that come in one of them.
    share: f64,
}

/// Part of a storm, or a whole one: on which levels of height waves slide the body, on which they begin a rotation, and how far they slide it.
pub(super) struct Part<W> {
    slides: Vec<(f64, f64)>,
    turns: Vec<(f64, f64)>,
    /// The level at which heights are cut; infinite if they are not.
    cut: f64,
    wave: W,
}

/// Slide of the body by a wave, m.
pub(super) trait Slide {
    fn slide(&self, level: f64) -> f64;

    /// True if waves that begin a rotation are followed in time.
    fn follows(&self) -> bool {
        false
    }

    /// Outcome of a wave that begins a rotation.
    fn turned(&self, level: f64) -> OtherEvent {
        let _ = level;
        OtherEvent::default()
    }
}

impl<W: Slide> Part<W> {
    /// The chance of a level in an interval.
    fn chance(&self, &(from, to): &(f64, f64)) -> f64 {
        let all = -(-self.cut).exp_m1();
        // exp(−from) − exp(−to), without cancellation.
        (-from).exp() * -(from - to).exp_m1() / all
    }

    fn chances(&self) -> [f64; 2] {
        [&self.slides, &self.turns].map(|levels| levels.iter().map(|interval| self.chance(interval)).sum())
    }

    fn of_event(&self) -> EventMeans {
        let all = -(-self.cut).exp_m1();
        let mean = self.slides.iter().map(|&(from, to)| {
            let ends = PANELS.map(|end| (from + end).min(to));
            let parts = ends.windows(2).filter(|pair| pair[0] < pair[1]);
            parts
                .flat_map(|pair| panel(pair[0], pair[1]))
                .map(|(t, weight)| weight * (-t).exp() * self.wave.slide(t))
                .sum::<f64>()
        });
        let [adds, other] = self.chances();
        EventMeans { mean: mean.sum::<f64>() / all, adds, other }
    }

    /// The slide of a wave that this share of all that slide the body exceeds.
    fn amount(&self, share: f64) -> f64 {
        self.level_of(&self.slides, share).map_or(0.0, |level| self.wave.slide(level))
    }

    /// The level of a wave that this share of all on these intervals exceeds.
    fn level_of(&self, intervals: &[(f64, f64)], share: f64) -> Option<f64> {
        let mut rest = share * intervals.iter().map(|interval| self.chance(interval)).sum::<f64>();
        for (place, interval) in intervals.iter().enumerate() {
            let chance = self.chance(interval);
            if rest <= chance || place + 1 == intervals.len() {
                let (from, to) = *interval;
                let within = (rest / chance).clamp(0.0, 1.0);
                // The level above which `within` of the interval lies.
                let t = from - ((1.0 - within) * (from - to).exp_m1()).ln_1p();
                return Some(t.clamp(from, to));
            }
            rest -= chance;
        }
        None
    }
}

impl<W: Slide> Year<W> {
    /// The storm with these of so many parts; none if nothing moves the body in any.
    fn of(parts: Vec<Part<W>>, count: usize) -> Option<Year<W>> {
        let share = 1.0 / count as f64;
        (!parts.is_empty()).then_some(Year { parts, share })
    }

    fn chances(&self) -> [f64; 2] {
        let mut sums = [0.0; 2];
        for part in &self.parts {
            sums.iter_mut().zip(part.chances()).for_each(|(sum, chance)| *sum += self.share * chance);
        }
        sums
    }

    fn of_event(&self) -> EventMeans {
        let mut sums = EventMeans::default();
        for part in &self.parts {
            let EventMeans { mean, adds, other } = part.of_event();
            sums.mean += self.share * mean;
            sums.adds += self.share * adds;
            sums.other += self.share * other;
        }
        sums
    }

    /// The part that a share of all waves of a kind falls to, by their chances in each, and the share that is left in it.
    fn part_of(&self, share: f64, which: usize) -> (&Part<W>, f64) {
        if let [one] = &self.parts[..] {
            return (one, share);
        }
        let chances: Vec<f64> = self.parts.iter().map(|part| part.chances()[which]).collect();
        let mut rest = share * chances.iter().sum::<f64>();
        for (part, chance) in self.parts.iter().zip(&chances) {
            if rest <= *chance && *chance > 0.0 {
                return (part, rest / chance);
            }
            rest -= chance;
        }
        // Rounding has left a little more than all.
        let last = chances.iter().rposition(|chance| *chance > 0.0).unwrap_or(0);
        (&self.parts[last], 1.0)
    }
}

/// The panels over which levels beyond the least are integrated: e⁻⁴⁰ is nothing.
const PANELS: [f64; 9] = [0.0, 0.25, 0.75, 1.5, 3.0, 6.0, 12.0, 24.0, 40.0];

/// Storms that are sums of waves.
pub(super) trait Storms: Sync {
    type Wave: Slide;
    fn storm(&self, values: &[f64]) -> Option<Year<Self::Wave>>;

    /// True if the base may crush, or the ground fail.
    fn gives_way(&self) -> bool {
        false
    }
}

/// Storms as sums of slides.
pub(super) struct Slides<'a, S>(pub(super) &'a S);

impl<S: Storms> Sums for Slides<'_, S> {
    type Year = Year<S::Wave>;

    fn year(&self, values: &[f64]) -> Option<Year<S::Wave>> {
        self.0.storm(values)
    }

    fn of_event(&self, year: &Year<S::Wave>) -> EventMeans {
        year.of_event()
    }

    fn chances(&self, year: &Year<S::Wave>) -> [f64; 2] {
        year.chances()
    }

    fn amount(&self, year: &Year<S::Wave>, share: f64) -> f64 {
        let (part, share) = year.part_of(share, 0);
        part.amount(share)
    }

    fn other(&self, year: &Year<S::Wave>) -> Option<impl Fn(f64) -> OtherEvent> {
        let turned = |share: f64| {
            let (part, share) = year.part_of(share, 1);
            let level = part.level_of(&part.turns, share);
            level.map_or(OtherEvent::default(), |level| part.wave.turned(level))
        };
        year.parts.iter().any(|part| part.wave.follows()).then_some(turned)
    }
}
