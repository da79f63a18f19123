//! Which of the consistent combinations of a stack count, and which one is reported.

use super::{Combination, Decider, LoadPoint};
use crate::mode::Mode;

impl Combination {
    /// True if it is the same motion as one that differs where this one flies and the other touches without pressing.
    pub(super) fn is_flight_of(&self, touches: &Combination) -> bool {
        self.modes.iter().zip(&touches.modes).enumerate().all(|(place, (own, other))| {
            own == other || (*own == Mode::Flight && touches.unpressed >> place & 1 == 1)
        })
    }

    /// Place in the order of reports.
    fn rank(&self) -> (bool, Vec<u8>) {
        (!self.regular, self.modes.iter().map(|mode| rank(*mode)).collect())
    }
}

/// Place of a mode among those of a joint: rest, slide, slide-rock, rock, flight.
fn rank(mode: Mode) -> u8 {
    let class = match (mode.corner(), mode.slip()) {
        _ if mode == Mode::Flight => 4,
        (None, None) => 0,
        (None, Some(_)) => 1,
        (Some(_), Some(_)) => 2,
        (Some(_), None) => 3,
    };
    class * 10 + mode.code()
}

/// True if a joint that slips in one mode sticks in another at the same contact.
fn sticks_instead(slips: Mode, sticks: Mode) -> bool {
    let holds = sticks.slip().is_none() && sticks != Mode::Flight;
    slips.slip().is_some()
        && holds
        && match (slips.corner(), sticks.corner()) {
            (None, _) | (_, None) => true,
            (Some(one), Some(other)) => one == other,
        }
}

impl Decider<'_> {
    /// True if a joint has more friction to stick than to slip.
    fn holds_better(&self, place: usize) -> bool {
        let joint = &self.approx.joints[place];
        joint.mu_s.value() > joint.mu_k.value()
    }

    /// True if `other` has slip in fewer joints than `one`, where a joint that friction may hold better at rest sticks.
    fn is_beaten(&self, one: &Combination, other: &Combination) -> bool {
        let pairs = || one.modes.iter().zip(&other.modes);
        pairs().all(|(own, other)| match (own.slip(), other.slip()) {
            (Some(_), Some(_)) => own == other,
            (None, Some(_)) => false,
            (_, None) => true,
        }) && pairs()
            .enumerate()
            .any(|(place, (own, other))| self.holds_better(place) && sticks_instead(*own, *other))
    }

    /// Those that count: stick is tried before slip; the one reported first.
    pub(super) fn chosen(&self, all: Vec<Combination>, at: &LoadPoint) -> Vec<Combination> {
        let mut left = all;
        if (0..self.approx.joints.len()).any(|place| self.holds_better(place)) {
            let beaten: Vec<bool> =
                left.iter().map(|one| left.iter().any(|other| self.is_beaten(one, other))).collect();
            left = left.into_iter().zip(beaten).filter(|(_, beaten)| !beaten).map(|(one, _)| one).collect();
            if left.len() > 1 {
                let would_stick = |one: &Combination| {
                    one.modes.iter().enumerate().any(|(place, mode)| {
                        let slides = mode.corner().is_none() && mode.slip().is_some();
                        slides && self.holds_better(place) && {
                            let mut modes = one.modes.clone();
                            modes[place] = Mode::Rest;
                            self.would_hold(&modes, place, at)
                        }
                    })
                };
                let slipping: Vec<bool> = left.iter().map(would_stick).collect();
                if slipping.contains(&false) {
                    let kept = left.into_iter().zip(slipping).filter(|(_, slips)| !slips);
                    left = kept.map(|(one, _)| one).collect();
                }
            }
        }
        left.sort_by_key(Combination::rank);
        left
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slip_is_held_at_its_own_contact() {
        use Mode::{Flight, Rest, RockO, RockOPrime, SlideLeft, SlideRockOLeft, SlideRockOPrimeRight};
        for held in [Rest, RockO, RockOPrime] {
            assert!(sticks_instead(SlideLeft, held));
        }
        assert!(sticks_instead(SlideRockOLeft, Rest) && sticks_instead(SlideRockOLeft, RockO));
        assert!(
            !sticks_instead(SlideRockOLeft, RockOPrime) && sticks_instead(SlideRockOPrimeRight, RockOPrime)
        );
        assert!(
            !sticks_instead(SlideLeft, Flight) && !sticks_instead(Rest, Rest) && !sticks_instead(RockO, Rest)
        );
    }

    #[test]
    fn modes_are_reported_in_the_order_of_one_body() {
        let mut modes = Mode::ALL.to_vec();
        modes.sort_by_key(|mode| rank(*mode));
        let symbols: Vec<_> = modes.iter().map(|mode| mode.symbol()).collect();
        assert_eq!(symbols, ["RE", "SL", "SL+", "SRO-", "SRO+", "SRO'-", "SRO'+", "RO", "RO'", "FL"]);
    }
}
