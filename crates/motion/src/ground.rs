//! Where the ground is as it shakes: its acceleration integrated twice, piece by piece.

use standfast::history::{History, Piece};

/// Displacements of ground that stands still at time 0 and is accelerated, at moments that rise.
///
/// ```
/// use standfast_motion::{History, ground};
/// // 2 m/s² for 3 s: at/2, and on at 6 m/s.
/// let push = History::rect(2.0, 3.0)?;
/// assert_eq!(ground::displacements(&push, &[1.0, 3.0, 4.0]), [1.0, 9.0, 15.0]);
/// # Ok::<(), standfast_motion::HistoryError>(())
/// ```
pub fn displacements(acceleration: &History, moments: &[f64]) -> Vec<f64> {
    let (mut t, mut v, mut x) = (0.0, 0.0, 0.0);
    let mut found = Vec::with_capacity(moments.len());
    let mut moments = moments.iter().copied().peekable();
    let pieces = acceleration.times().windows(2).zip(acceleration.pieces());
    for (ends, piece) in pieces {
        let [from, to] = [ends[0], ends[1]];
        while let Some(moment) = moments.next_if(|moment| *moment < from) {
            found.push(x + v * (moment - t));
        }
        (t, x) = (from, x + v * (from - t));
        while let Some(moment) = moments.next_if(|moment| *moment < to) {
            found.push(x + after(piece, v, moment - from)[1]);
        }
        if to.is_finite() {
            let [faster, farther] = after(piece, v, to - from);
            (t, v, x) = (to, faster, x + farther);
        }
    }
    found.extend(moments.map(|moment| x + v * (moment - t)));
    found
}

/// Velocity and way of something of velocity `v` after a time τ under a piece.
fn after(piece: &Piece, v: f64, τ: f64) -> [f64; 2] {
    match *piece {
        Piece::Line { value, slope } => {
            [v + τ * (value + slope * τ / 2.0), τ * (v + τ * (value / 2.0 + slope * τ / 6.0))]
        }
        Piece::Sine { peak, angular_frequency: ω, phase } => {
            let [begin, end] = [phase, phase + ω * τ];
            let gained = v + peak / ω * (begin.cos() - end.cos());
            [gained, τ * (v + peak / ω * begin.cos()) - peak / (ω * ω) * (end.sin() - begin.sin())]
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A half-sine of one second and peak π leaves the ground at 2 m/s, 1 m from where it was; a later start shifts all.
    #[test]
    fn a_half_sine_is_integrated_twice() {
        let pulse = History::half_sine(std::f64::consts::PI, 1.0).unwrap();
        let close = |found: Vec<f64>, expected: &[f64]| {
            assert!(found.iter().zip(expected).all(|(one, other)| (one - other).abs() < 1e-12), "{found:?}");
            assert_eq!(found.len(), expected.len());
        };
        // x = τ − sin(πτ)/π.
        close(
            displacements(&pulse, &[0.0, 0.5, 1.0, 3.0]),
            &[0.0, 0.5 - 1.0 / std::f64::consts::PI, 1.0, 5.0],
        );
        close(displacements(&pulse.starting(2.0).unwrap(), &[1.0, 2.0, 3.0, 5.0]), &[0.0, 0.0, 1.0, 5.0]);
    }

    /// A record ends where the drift of the record says, which sums it by another way.
    #[test]
    fn a_record_ends_where_its_drift_is() {
        let text = "t,a\n0,0\n0.1,1\n0.3,-2\n0.35,4\n0.7,-1\n1,0\n";
        let record = crate::record::Record::parse("x.csv", text, None, None).unwrap();
        let found = displacements(&record.history(1.0).unwrap(), &[1.0]);
        assert!((found[0] - record.drift()[1]).abs() < 1e-12, "{found:?} {:?}", record.drift());
    }
}
