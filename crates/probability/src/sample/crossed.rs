//! The share of hits of rows and columns that are all crossed: every body under every record.

use super::interval::{Estimate, where_reached};
use crate::beta::beta_reg;

impl Estimate {
    /// The share of hits where every row is crossed with every column, with an interval for a further row and column: rows are few
    /// and shared by all columns, columns by all rows, so that hits are not independent.
    ///
    /// The means of rows and those of columns spread by s²ᵣ and s²ₖ; the variance of the share is s²ᵣ/rows + s²ₖ/columns (what belongs
    /// to a pair alone is in both: the interval is rather too wide). As many independent hits as have this variance, fewer by Student's
    /// factor for the lesser count, have Clopper and Pearson's interval: that of E. L. Korn and B. I. Graubard for clustered samples
    /// (Confidence intervals for proportions with small expected number of positive counts estimated from survey data, Survey
    /// Methodology 24, 1998, 193–201; recalled, not read in the original). Where all or none are hits there is no spread, and the
    /// lesser count alone tells: the bound is one-sided. Less than one independent hit tells nothing: 0 to 1. Of one row, or one column, it is the interval of its own hits.
    ///
    /// # Panics
    /// If there are no hits, or rows of different length.
    pub fn of_pairs(rows: &[Vec<bool>]) -> Estimate {
        let (count, length) = (rows.len(), rows[0].len());
        assert!(length > 0 && rows.iter().all(|row| row.len() == length), "rows of one length");
        let hits = rows.iter().flatten().filter(|hit| **hit).count() as u64;
        if count == 1 || length == 1 {
            return Estimate::of_hits(hits, (count * length) as u64);
        }
        let pairs = (count * length) as f64;
        let value = hits as f64 / pairs;
        let fewer = count.min(length) as f64;
        if hits == 0 || hits == pairs as u64 {
            let bound = Estimate::of_hits(if hits == 0 { 0 } else { fewer as u64 }, fewer as u64);
            return Estimate { value, ..bound };
        }
        let spread = |means: &mut dyn Iterator<Item = f64>, n: f64| {
            means.map(|mean| (mean - value).powi(2)).sum::<f64>() / ((n - 1.0) * n)
        };
        let of_row = |row: &Vec<bool>| row.iter().filter(|hit| **hit).count() as f64 / length as f64;
        let of_column = |i: usize| rows.iter().filter(|row| row[i]).count() as f64 / count as f64;
        let variance = spread(&mut rows.iter().map(of_row), count as f64)
            + spread(&mut (0..length).map(of_column), length as f64);
        let independent = value * (1.0 - value) / variance;
        let fewer_by = (NORMAL / student(fewer - 1.0)).powi(2);
        let n = independent.min(pairs) * fewer_by;
        if n < 1.0 {
            return Estimate { value, low: 0.0, high: 1.0 };
        }
        let Estimate { low, high, .. } = Estimate::of_share(value * n, n);
        Estimate { value, low, high }
    }
}

/// The standard normal's two-sided 95 %.
const NORMAL: f64 = 1.959_963_984_540_054;

/// Student's two-sided 95 % for so many degrees of freedom: P(|T| > t) = I_x(ν/2, ½), x = ν/(ν + t²).
fn student(freedom: f64) -> f64 {
    let x = where_reached(|x| beta_reg(freedom / 2.0, 0.5, x), 0.05);
    (freedom * (1.0 - x) / x).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::normal;
    use crate::points::Stream;

    /// Of tables: 12.706, 4.303, 2.571, 2.042 for 1, 2, 5 and 30 degrees of freedom.
    #[test]
    fn factors_are_students() {
        for (freedom, factor) in [(1.0, 12.706), (2.0, 4.303), (5.0, 2.571), (30.0, 2.042), (1e6, 1.960)] {
            assert!((student(freedom) - factor).abs() < 6e-4, "{freedom}: {}", student(freedom));
        }
    }

    /// By hand: rows with the means ½, ½, ¾ and ¼, columns with 1, ½, ½ and 0; half of all are hits, and the variance is
    /// (1/16 + 1/16)/(3·4) + (1/4 + 1/4)/(3·4) = 5/96. Student's factor for three degrees of freedom is 3.1824.
    #[test]
    fn the_interval_is_that_of_so_many_independent_hits() {
        let rows = [[1, 1, 0, 0], [1, 0, 1, 0], [1, 1, 1, 0], [1, 0, 0, 0]];
        let rows = rows.map(|row| row.map(|hit| hit == 1).to_vec());
        let found = Estimate::of_pairs(&rows);
        let n = 0.25 / (5.0 / 96.0) * (NORMAL / 3.182_446_305_284_263f64).powi(2);
        assert_eq!(found.value, 0.5);
        // Clopper and Pearson's bounds are where 2.5 % are left.
        let k = 0.5 * n;
        assert!((beta_reg(k, n - k + 1.0, found.low) - 0.025).abs() < 1e-9, "{found:?}");
        assert!((beta_reg(k + 1.0, n - k, found.high) - 0.975).abs() < 1e-9, "{found:?}");
    }

    #[test]
    fn two_rows_that_differ_tell_nothing() {
        let found = Estimate::of_pairs(&[
            vec![true; 9],
            vec![true, false, false, false, false, false, false, false, false],
        ]);
        assert_eq!((found.low, found.high), (0.0, 1.0));
        assert!((found.value - 10.0 / 18.0).abs() < 1e-15);
    }

    /// With as few rows as seven that differ much, or hardly, in more than 94 of 100 repetitions the interval has the share that rows and
    /// columns without end would have; that of independent hits does not.
    #[test]
    fn the_interval_covers_what_further_rows_would_give() {
        const REPETITIONS: u64 = 1500;
        let (count, length) = (7, 60);
        for (at, of_rows, of_columns) in
            [(0.0, 1.0, 0.5), (-1.5, 0.7, 1.0), (-2.5, 1.0, 0.3), (1.0, 0.1, 0.1), (-1.0, 0.0, 2.0)]
        {
            let whole = f64::hypot(of_rows, of_columns).hypot(1.0);
            let truth = normal::below(at / whole);
            let mut covered = [0u64; 2];
            for repetition in 0..REPETITIONS {
                let mut stream = Stream::new(7, repetition);
                let mut normal_draw = || normal::quantile(stream.draw());
                let rows: Vec<f64> = (0..count).map(|_| of_rows * normal_draw()).collect();
                let columns: Vec<f64> = (0..length).map(|_| of_columns * normal_draw()).collect();
                let hits: Vec<Vec<bool>> = rows
                    .iter()
                    .map(|row| columns.iter().map(|column| at + row + column + normal_draw() > 0.0).collect())
                    .collect();
                let all = hits.iter().flatten().filter(|hit| **hit).count() as u64;
                let intervals = [Estimate::of_pairs(&hits), Estimate::of_hits(all, (count * length) as u64)];
                for (covered, e) in covered.iter_mut().zip(intervals) {
                    *covered += u64::from(e.low <= truth && truth <= e.high);
                }
            }
            let [pairs, plain] = covered.map(|covered| covered as f64 / REPETITIONS as f64);
            assert!(pairs > 0.94, "{at}: {pairs}");
            assert!(of_rows.max(of_columns) < 0.5 || plain < 0.8, "{at}: {plain}");
        }
    }
}
