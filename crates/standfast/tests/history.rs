//! Histories: what is found in one pass is what is found moment by moment.

use standfast::{History, HistoryTimes};

fn shapes() -> Vec<History> {
    let even: Vec<f64> =
        (0..300).map(|i| (f64::from(i) * 0.7).sin() * (f64::from(i) * 0.013).cos()).collect();
    let sine = History::sine(0.7, 3.0, 0.4, 5.0).unwrap();
    [
        History::constant(2.0),
        History::rect(-1.5, 3.0),
        History::triangle(1.0, 0.4, 2.0),
        History::decay(-2.0, 1.0),
        History::half_sine(0.8, 2.0),
        Ok(sine.clone()),
        sine.starting(0.3),
        History::church_roof(3.0, 0.1, 0.4, 1.0, 2.0),
        History::samples(0.02, &even),
        History::stepped(&[[0.0, 0.0], [1.0, 2.0], [1.0, -1.0], [2.0, 0.5], [3.0, 0.5], [3.0, 0.0]]),
        History::points(&[0.5, 1.0, 4.0], &[0.2, -0.3, 0.9]),
    ]
    .map(Result::unwrap)
    .to_vec()
}

#[test]
fn jumps_are_where_it_jumps() {
    for history in shapes() {
        for history in [history.clone(), history.clone().times_factor(-2.5)] {
            let expected: Vec<f64> =
                history.times().iter().copied().filter(|t| history.jumps_at(*t)).collect();
            assert_eq!(history.jumps().collect::<Vec<_>>(), expected, "{history:?}");
        }
    }
    let jumps: Vec<f64> = shapes()[9].jumps().collect();
    assert_eq!(jumps, [1.0, 3.0]);
}

#[test]
fn the_peak_is_the_largest_of_all_moments() {
    for history in shapes() {
        for (history, factor) in [(history.clone(), 1.0), (history.clone().times_factor(-2.5), 2.5)] {
            let end = if history.end().is_finite() { history.end() } else { 1.0 };
            let ends = history.times().iter().flat_map(|t| [history.at(*t), history.before(*t)]);
            let between = (0..200_000).map(|i| history.at(end * f64::from(i) / 2e5));
            let largest = ends.chain(between).fold(0.0, |most: f64, value| most.max(value.abs()));
            let peak = history.peak();
            assert!(
                (peak - largest).abs() < 1e-8 * factor && peak >= largest * (1.0 - 1e-15),
                "{peak} {largest}"
            );
        }
    }
}

/// Values at times that many have are those of points times the factor, to the last digit, whatever comes first.
#[test]
fn times_in_common_change_nothing() {
    let values: Vec<f64> = (0..500).map(|i| (f64::from(i) * 0.37).sin()).collect();
    let times = HistoryTimes::even(0.005, values.len()).unwrap();
    for factor in [1.0, 9.81, -0.01] {
        let one = History::at_times(&times, &values, factor).unwrap();
        let other = History::points(times.times(), &values).unwrap().times_factor(factor);
        assert_eq!(one, other);
        assert!(!one.is_same(&other) && one.is_same(&one.clone()));
    }
    assert!((times.longest() - 0.005).abs() < 1e-15);
    let mut broken = values.clone();
    broken[17] = f64::NAN;
    let error = History::at_times(&times, &broken, 1.0).unwrap_err().to_string();
    assert!(error.contains("point 18"), "{error}");
    assert!(History::at_times(&times, &values[1..], 1.0).is_err());
    assert!(HistoryTimes::new(vec![0.0, 1.0, 1.0]).is_err() && HistoryTimes::even(0.0, 5).is_err());
}
