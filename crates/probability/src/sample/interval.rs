//! Intervals of estimates, at 95 %.

use super::SCRAMBLES;
use crate::beta::beta_reg;

/// A probability with the interval in which it lies with a confidence of 95 %.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The estimate.
    pub value: f64,
    /// The interval's lower end.
    pub low: f64,
    /// Its upper end. Where nothing was met it is the bound that a probability this confident cannot exceed.
    pub high: f64,
}

/// Student's t for 31 degrees of freedom, two-sided 95 %.
const STUDENT: f64 = 2.039_513_446_396_408;

impl Estimate {
    /// The mean of the means of all scrambles, with Student's interval; where all are zero, the bound of as many plain points.
    pub(crate) fn of_means(means: &[f64], points: u64) -> Estimate {
        debug_assert_eq!(means.len(), SCRAMBLES);
        let n = means.len() as f64;
        let value = means.iter().sum::<f64>() / n;
        if value == 0.0 {
            return Estimate::of_hits(0, points);
        }
        let variance = means.iter().map(|mean| (mean - value).powi(2)).sum::<f64>() / (n - 1.0);
        let half = STUDENT * (variance / n).sqrt();
        Estimate { value, low: (value - half).max(0.0), high: value + half }
    }

    /// A value with Student's interval of the spread of the groups' own.
    pub(crate) fn about(value: f64, groups: &[f64]) -> Estimate {
        let n = groups.len() as f64;
        let mean = groups.iter().sum::<f64>() / n;
        let variance = groups.iter().map(|group| (group - mean).powi(2)).sum::<f64>() / (n - 1.0);
        let half = STUDENT * (variance / n).sqrt();
        Estimate { value, low: (value - half).max(0.0), high: value + half }
    }

    /// The share of hits, with Clopper and Pearson's interval; one-sided where no point was a hit, or all were.
    pub fn of_hits(hits: u64, points: u64) -> Estimate {
        Estimate::clopper_pearson(hits, points, 0.05)
    }

    /// The share of so many hits with the interval of Clopper and Pearson, 2.5 % on each side also where there are none, or nothing else.
    pub fn two_sided(hits: u64, points: u64) -> Estimate {
        Estimate::clopper_pearson(hits, points, 0.025)
    }

    /// The interval, with so much beyond it where no point was a hit, or all were.
    fn clopper_pearson(hits: u64, points: u64, beyond: f64) -> Estimate {
        let n = points as f64;
        // What is beyond is (1 − p)ⁿ; with 1 − p of all others.
        let alone = -libm::expm1(beyond.ln() / n);
        match hits {
            0 => Estimate { value: 0.0, low: 0.0, high: alone },
            _ if hits == points => Estimate { value: 1.0, low: 1.0 - alone, high: 1.0 },
            _ => Estimate::of_share(hits as f64, n),
        }
    }

    /// The share of hits, some but not all; neither they nor the points need be a whole number.
    pub(super) fn of_share(k: f64, n: f64) -> Estimate {
        // P(at least k hits) = I_p(k, n−k+1).
        let low = where_reached(|p| beta_reg(k, n - k + 1.0, p), 0.025);
        let high = where_reached(|p| beta_reg(k + 1.0, n - k, p), 0.975);
        Estimate { value: k / n, low, high }
    }

    /// True if the probability is not above a floor, or its interval is so narrow on either side, relative to it.
    pub fn is_precise(&self, precision: f64, floor: f64) -> bool {
        self.value <= floor || 0.5 * (self.high - self.low) <= precision * self.value
    }
}

/// Places, from one, of the values among so many in their order that enclose the quantile at a share with 95 %: each has 2.5 % beyond it at most.
/// `None` where there are too few.
pub fn around_quantile(share: f64, count: u64) -> Option<[u64; 2]> {
    // Of a binomial count of values below the quantile, P(count ≤ k) = 1 − I_p(k+1, n−k).
    let at_most = |k: u64| {
        if k >= count { 1.0 } else { 1.0 - beta_reg(k as f64 + 1.0, (count - k) as f64, share) }
    };
    let first = |is_beyond: &dyn Fn(f64) -> bool| {
        let (mut low, mut high) = (0, count);
        while low < high {
            let middle = low + (high - low) / 2;
            if is_beyond(at_most(middle)) { high = middle } else { low = middle + 1 }
        }
        low
    };
    let [low, high] = [first(&|chance| chance > 0.025), first(&|chance| chance >= 0.975) + 1];
    (low >= 1 && high <= count).then_some([low, high])
}

/// Argument at which a function that rises from 0 to 1 on (0, 1) has a value.
pub(super) fn where_reached(f: impl Fn(f64) -> f64, value: f64) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return high;
        }
        if f(middle) < value { low = middle } else { high = middle }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// At no hits in n the bound is 1 − 0.05^(1/n); at the ends of the interval the chance of the count, summed term by
    /// term, is 2.5 %.
    #[test]
    fn hits_have_the_interval_of_the_binomial_law() {
        for n in [10u64, 1000, 1 << 22] {
            let none = Estimate::of_hits(0, n);
            assert_eq!((none.value, none.low), (0.0, 0.0));
            assert!((libm::log1p(-none.high) * n as f64 - 0.05f64.ln()).abs() < 1e-12, "{n}: {}", none.high);
            let all = Estimate::of_hits(n, n);
            assert_eq!((all.value, all.high), (1.0, 1.0));
            assert!((all.low + none.high - 1.0).abs() < 1e-15);
        }
        let at_most = |k: u64, n: u64, p: f64| {
            let (mut term, mut sum) = ((1.0 - p).powi(n as i32), 0.0);
            for i in 0..=k {
                sum += term;
                term *= (n - i) as f64 / (i + 1) as f64 * p / (1.0 - p);
            }
            sum
        };
        for (k, n) in [(1, 20), (7, 20), (30, 100)] {
            let e = Estimate::of_hits(k, n);
            assert!((at_most(k, n, e.high) - 0.025).abs() < 1e-9);
            assert!((1.0 - at_most(k - 1, n, e.low) - 0.025).abs() < 1e-9);
        }
    }

    /// By sums of whole numbers, exactly.
    #[test]
    fn a_quantile_lies_between_values_in_their_order() {
        for (share, count, places) in [
            (0.05, 71, None),
            (0.05, 72, Some([1, 9])),
            (0.05, 100, Some([1, 11])),
            (0.5, 100, Some([40, 61])),
            (0.95, 100, Some([90, 100])),
            (0.05, 400, Some([12, 30])),
            (0.5, 400, Some([180, 221])),
            (0.95, 400, Some([371, 389])),
            (0.75, 1200, Some([870, 930])),
            (0.95, 1200, Some([1125, 1155])),
        ] {
            assert_eq!(around_quantile(share, count), places, "{share} of {count}");
        }
        // Of a million by the normal law, to a hundredth of the width.
        let [low, high] = around_quantile(0.95, 1_000_000).unwrap().map(|place| place as f64);
        let half = 1.959964 * (1e6f64 * 0.95 * 0.05).sqrt();
        assert!(
            (low - 950_000.0 + half).abs() < 0.01 * half && (high - 950_000.0 - half).abs() < 0.01 * half
        );
    }

    /// By hand: 16 scrambles with 0.4 and 16 with 0.6 spread by √(32 · 0.01/31) about 0.5, and by a √32th of it in the mean. Student's factor
    /// is 2.0395 in tables. Of means that spread by more than they are the lower end is zero.
    #[test]
    fn the_interval_of_means_is_students() {
        let means: Vec<f64> = (0..SCRAMBLES).map(|i| if i % 2 == 0 { 0.4 } else { 0.6 }).collect();
        let half = 2.0395 * 0.1 / 31f64.sqrt();
        let one = Estimate::of_means(&means, 1 << 15);
        let other = Estimate::about(0.3, &means);
        for (estimate, value) in [(one, 0.5), (other, 0.3)] {
            assert!((estimate.value - value).abs() < 1e-15);
            // The table has four decimals.
            assert!((estimate.high - value - half).abs() < 3e-5 * half, "{estimate:?}");
            assert!((value - estimate.low - half).abs() < 3e-5 * half, "{estimate:?}");
        }
        assert_eq!(Estimate::about(0.01, &means).low, 0.0);
        // One scramble of 32 was met: the mean is 1/32, and so is the spread.
        let rare: Vec<f64> = (0..SCRAMBLES).map(|i| if i == 0 { 1.0 } else { 0.0 }).collect();
        let rare = Estimate::of_means(&rare, 1 << 15);
        assert_eq!((rare.value, rare.low), (1.0 / 32.0, 0.0));
        assert!((rare.high - 3.0395 / 32.0).abs() < 1e-5, "{rare:?}");
    }

    /// 95 % of Student's law with 31 degrees of freedom lie within the factor: its density by Simpson's rule, normalised over the
    /// whole line.
    #[test]
    fn the_factor_is_students() {
        let density = |t: f64| (1.0 + t * t / 31.0).powi(-16);
        let simpson = |to: f64| {
            let n = 20_000;
            let h = to / f64::from(n);
            let weight = |i: i32| {
                if i == 0 || i == n {
                    1.0
                } else if i % 2 == 1 {
                    4.0
                } else {
                    2.0
                }
            };
            (0..=n).map(|i| weight(i) * density(f64::from(i) * h)).sum::<f64>() * h / 3.0
        };
        assert!((simpson(STUDENT) / simpson(60.0) - 0.95).abs() < 1e-10);
    }
}
