//! Lives and sums over many events, against integrals written out here and against events drawn one by one.

mod common;

use common::{Fails, mean};
use standfast_probability::copula::{Copula, Correlation, CorrelationMeasure};
use standfast_probability::integrate::{Within, integrate_life};
use standfast_probability::law::Law;
use standfast_probability::life::{Life, lives};
use standfast_probability::normal::below;
use standfast_probability::points::Stream;
use standfast_probability::problem::RandomVector;
use standfast_probability::sample::Effort;
use standfast_probability::sums::{EventMeans, Lives, Sums, expected, lives as sums_of_lives};

const YEARS: f64 = 20.0;

/// A resistance N(3.8, 0.5) for life and yearly loads N(1, 0.4) and N(1.2, 0.3), whose sum is N(2.2, 0.5).
fn inputs(correlation: f64) -> RandomVector {
    let law = |mean, sd| Law::normal(mean, sd).unwrap().into();
    let laws = vec![law(3.8, 0.5), law(1.0, 0.4), law(1.2, 0.3)];
    let correlations =
        [Correlation { first: 0, second: 1, measure: CorrelationMeasure::Normal(correlation) }];
    let copula = Copula::new(&laws, &correlations).unwrap();
    RandomVector::new(laws, copula)
}

fn effort(points: u64) -> Effort {
    Effort { precision: 0.01, points, threads: 2, ..Effort::default() }
}

/// Line in a life, be it the resistance, whose intervals are united over the years, or a load, of which years are
/// multiplied: it is E[1 − Φ((R − 2.2)/0.5)ⁿ].
#[test]
fn a_life_is_as_weak_as_its_worst_year() {
    let life = Life { years: YEARS, yearly: vec![false, true, true], events: None, clock: None };
    let by_hand = mean(|z| 1.0 - below((3.8 + 0.5 * z - 2.2) / 0.5).powf(YEARS));
    let integrated = integrate_life(&inputs(0.0), &Fails { line: 1 }, &[1], &life, Within::ALL_DIGITS)
        .unwrap()
        .probabilities[0];
    assert!((integrated / by_hand - 1.0).abs() < 1e-8, "{integrated} {by_hand}");
    for line in [0, 1] {
        let found = lives(&inputs(0.0), &Fails { line }, &[1], &life, &effort(1 << 22));
        let e = found.estimates[0];
        assert!(found.precise && e.high - e.low < 0.03 * by_hand);
        assert!((e.value - by_hand).abs() < e.high - e.low, "line {line}: {e:?} {by_hand}");
    }
}

/// Events by Poisson's law: E[1 − exp(−λn Φ(…))], integrated and drawn, of any length of life.
#[test]
fn events_come_by_poissons_law() {
    let (rate, years) = (4.5, 7.3);
    let life = Life { years, yearly: vec![false, true, true], events: Some(rate), clock: None };
    let by_hand = mean(|z| -(-rate * years * (1.0 - below((3.8 + 0.5 * z - 2.2) / 0.5))).exp_m1());
    let integrated = integrate_life(&inputs(0.0), &Fails { line: 1 }, &[1], &life, Within::ALL_DIGITS)
        .unwrap()
        .probabilities[0];
    assert!((integrated / by_hand - 1.0).abs() < 1e-8, "{integrated} {by_hand}");
    for line in [0, 1] {
        let e = lives(&inputs(0.0), &Fails { line }, &[1], &life, &effort(1 << 22)).estimates[0];
        assert!((e.value - by_hand).abs() < e.high - e.low, "line {line}: {e:?} {by_hand}");
    }
    // Sums: as many events on average, each with 30 of its own; the variance of a sum has the variance of their number.
    let found = expected(&inputs(0.0), &Exceeds, 30.0, &Effort { precision: 1e-3, ..effort(1 << 22) });
    let drawn = sums_of_lives(&inputs(0.0), &Exceeds, 30, &life, &effort(1 << 19), |_| false);
    let m = drawn.mean(|life| life.sum);
    assert!((m.value - life.times() * found.estimates[0].value).abs() < m.high - m.low, "{m:?} {found:?}");
}

/// A level that rises over the years: 1 − E Π (1 − p_t), p_t that of each year with its own level, integrated and drawn; of a row of bodies too. By hand the years
/// are multiplied one by one.
#[test]
fn what_goes_with_the_time_has_another_value_each_year() {
    use standfast_probability::row::{Row, rows};
    let rise = 0.6;
    let law = |mean, sd| Law::normal(mean, sd).unwrap().into();
    let laws = vec![law(3.8, 0.5), Law::uniform(0.0, rise).unwrap().into(), law(2.2, 0.4)];
    let inputs = RandomVector::independent(laws);
    let life = Life { years: YEARS, yearly: vec![false, true, true], events: None, clock: Some(1) };
    let never = |z: f64, power: i32| {
        let of_year = |year: i32| {
            let level = 2.2 + rise * (f64::from(year) + 0.5) / YEARS;
            below((3.8 + 0.5 * z - level) / 0.4)
        };
        (0..YEARS as i32).map(of_year).product::<f64>().powi(power)
    };
    let by_hand = mean(|z| 1.0 - never(z, 1));
    let integrated = integrate_life(&inputs, &Fails { line: 2 }, &[1], &life, Within::ALL_DIGITS)
        .unwrap()
        .probabilities[0];
    // Years are midpoints of what is integrated: the logarithm of what a moment leaves, over the life.
    assert!((integrated / by_hand - 1.0).abs() < 1e-3, "{integrated} {by_hand}");
    let continuous = mean(|z| {
        let log = |i: i32| below((3.8 + 0.5 * z - 2.2 - rise * (f64::from(i) + 0.5) / 1000.0) / 0.4).ln();
        -((0..1000).map(log).sum::<f64>() * YEARS / 1000.0).exp_m1()
    });
    assert!((integrated / continuous - 1.0).abs() < 1e-6, "{integrated} {continuous}");
    for line in [0, 2] {
        let e = lives(&inputs, &Fails { line }, &[1], &life, &effort(1 << 21)).estimates[0];
        assert!((e.value - by_hand).abs() < e.high - e.low, "line {line}: {e:?} {by_hand}");
        assert!(e.high - e.low < 0.1 * by_hand);
    }
    // With a level that does not rise, all years are alike, and the average year is one of them.
    let plain = Life { clock: None, ..life.clone() };
    let drawn = lives(&inputs, &Fails { line: 2 }, &[1], &plain, &effort(1 << 21)).estimates[0];
    assert!(drawn.value > 0.5 * by_hand);
    // Of a row with a resistance of each body: the largest of all the years counts.
    let row = Row { bodies: 6, own: vec![true, false, false] };
    let e = rows(&inputs, &Fails { line: 0 }, &[1], &row, &life, &effort(1 << 21)).estimates[0];
    let mut stream = Stream::new(3, 5);
    let mut normal = || {
        let (a, b) = (stream.draw(), stream.draw());
        (-2.0 * a.ln()).sqrt() * (2.0 * std::f64::consts::PI * b).cos()
    };
    const LIVES: u32 = 20_000;
    let failed = (0..LIVES).filter(|_| {
        let years = 0..YEARS as i32;
        let most = years.map(|year| 2.2 + rise * (f64::from(year) + 0.5) / YEARS + 0.4 * normal());
        let most = most.fold(f64::NEG_INFINITY, f64::max);
        (0..6).any(|_| 3.8 + 0.5 * normal() < most)
    });
    let expected = failed.count() as f64 / f64::from(LIVES);
    let deviation = (expected * (1.0 - expected) / f64::from(LIVES)).sqrt();
    assert!((e.value - expected).abs() < 3.5 * deviation + (e.high - e.low), "{e:?} {expected}");
    // Sums: the mean of a life is that of its years.
    let drawn = sums_of_lives(&inputs, &Exceeds, 30, &life, &effort(1 << 19), |_| false);
    let found = expected_mean(&inputs);
    let m = drawn.mean(|life| life.sum);
    assert!((m.value - YEARS * found).abs() < m.high - m.low, "{m:?} {found}");
}

/// Each year has its own time, the middle of a twentieth of the life: a level above 0.96 of its rise is that of the last year alone, in every life.
#[test]
fn each_year_has_its_own_time() {
    use standfast_probability::row::{Row, rows};
    let law = |mean| Law::normal(mean, 1e-9).unwrap().into();
    let laws = vec![law(3.96), Law::uniform(0.0, 1.0).unwrap().into(), law(3.0)];
    let inputs = RandomVector::independent(laws);
    let life = Life { years: YEARS, yearly: vec![false, true, true], events: None, clock: Some(1) };
    let row = Row { bodies: 3, own: vec![true, false, false] };
    for line in [0, 2] {
        let of_one = lives(&inputs, &Fails { line }, &[1], &life, &effort(1 << 14)).estimates[0];
        let of_row = rows(&inputs, &Fails { line }, &[1], &row, &life, &effort(1 << 14)).estimates[0];
        assert_eq!((of_one.value, of_row.value), (1.0, 1.0), "line {line}");
        // Events come at any time: 20 on average, each with 0.04.
        let events = Life { events: Some(1.0), ..life.clone() };
        let any = lives(&inputs, &Fails { line }, &[1], &events, &effort(1 << 18)).estimates[0];
        let by_hand = -(-YEARS * 0.04).exp_m1();
        assert!((any.value - by_hand).abs() < any.high - any.low, "line {line}: {any:?} {by_hand}");
    }
    let sums = sums_of_lives(&inputs, &Late, 7, &life, &effort(1 << 14), |_| false);
    let m = sums.mean(|life| life.sum);
    assert_eq!((m.value, m.low, m.high), (7.0, 7.0, 7.0));
}

/// Every event adds 1 in a year whose level is above 0.96.
struct Late;

impl Sums for Late {
    type Year = ();
    fn year(&self, values: &[f64]) -> Option<()> {
        (values[1] > 0.96).then_some(())
    }
    fn of_event(&self, _: &()) -> EventMeans {
        EventMeans { mean: 1.0, adds: 1.0, other: 0.0 }
    }
    fn amount(&self, _: &(), _: f64) -> f64 {
        1.0
    }
}

fn expected_mean(inputs: &RandomVector) -> f64 {
    let effort = Effort { precision: 1e-3, ..effort(1 << 22) };
    expected(inputs, &Exceeds, 30.0, &effort).estimates[0].value
}

/// A load that depends on the resistance: R is drawn before the years are, which no line can be then.
#[test]
fn what_a_year_depends_on_is_drawn_before_it() {
    let rho = 0.6f64;
    let life = Life { years: YEARS, yearly: vec![false, true, true], events: None, clock: None };
    // Given z of R, a load is N(1 + 0.4ρz, 0.4√(1 − ρ²)).
    let deviation = (0.4f64.powi(2) * (1.0 - rho * rho) + 0.3f64.powi(2)).sqrt();
    let by_hand = mean(|z| 1.0 - below((3.8 + 0.5 * z - 2.2 - 0.4 * rho * z) / deviation).powf(YEARS));
    for line in [0, 1] {
        let e = lives(&inputs(rho), &Fails { line }, &[1], &life, &effort(1 << 22)).estimates[0];
        assert!((e.value - by_hand).abs() < e.high - e.low, "line {line}: {e:?} {by_hand}");
    }
}

/// More threads, the same bytes.
#[test]
fn threads_do_not_matter() {
    let life = Life { years: YEARS, yearly: vec![false, true, true], events: None, clock: None };
    let of = |threads| {
        let effort = Effort { threads, ..effort(1 << 18) };
        lives(&inputs(0.0), &Fails { line: 0 }, &[1], &life, &effort)
    };
    assert_eq!(of(1), of(3));
    let sums = |threads| {
        let effort = Effort { threads, ..effort(1 << 14) };
        let of_life = Life { years: 4.0, yearly: vec![false, true, true], events: None, clock: None };
        sums_of_lives(&inputs(0.0), &Exceeds, 30, &of_life, &effort, |_| false)
    };
    assert_eq!(sums(1), sums(3));
}

/// Lives are doubled until they are enough, and those that were drawn first stay: fewer are the first of more.
#[test]
fn lives_are_drawn_until_they_are_enough() {
    let life = Life { years: 4.0, yearly: vec![false, true, true], events: None, clock: None };
    let drawn = |most: u64, are_enough: &dyn Fn(&Lives) -> bool| {
        sums_of_lives(&inputs(0.0), &Exceeds, 30, &life, &effort(most), are_enough)
    };
    let first = drawn(1 << 19, &|_| true);
    assert_eq!(first.count(), 32 * 16);
    let more = drawn(1 << 19, &|lives| lives.count() > 10_000);
    assert_eq!(more.count(), 32 * 512);
    let all = drawn(1 << 19, &|_| false);
    assert_eq!(all.count(), (1 << 19) / 4);
    for fewer in [&first, &more] {
        for (some, group) in fewer.groups.iter().zip(&all.groups) {
            assert_eq!(some[..], group[..some.len()]);
        }
    }
    assert_eq!(drawn(1 << 10, &|_| false).count(), 32 * 16);
}

/// Each event is an exponential variable with mean 1, and adds what it has above a level: the first input less the second.
struct Exceeds;

impl Sums for Exceeds {
    type Year = f64;
    fn year(&self, values: &[f64]) -> Option<f64> {
        Some((values[0] - values[1]).max(0.0))
    }
    fn of_event(&self, level: &f64) -> EventMeans {
        // Of a lack of memory the mean is that of all, and one event in ten of the others is of another kind.
        let adds = (-level).exp();
        EventMeans { mean: adds, adds, other: 0.1 * (1.0 - adds) }
    }
    fn amount(&self, _: &f64, share: f64) -> f64 {
        -share.ln()
    }
}

/// The mean is years · events · E[exp(−max(R − S, 0))], and lives have the law of events drawn one by one.
#[test]
fn sums_are_those_of_every_event() {
    let inputs = inputs(0.0);
    let (years, events) = (4.0, 30u64);
    let life = Life { years, yearly: vec![false, true, true], events: None, clock: None };
    // R − S is N(2.8, √(0.5² + 0.4²)).
    let spread = 0.41f64.sqrt();
    let by_hand = years * events as f64 * mean(|z| (-(2.8 + spread * z).max(0.0)).exp());
    let found = expected(&inputs, &Exceeds, events as f64, &Effort { precision: 1e-3, ..effort(1 << 22) });
    let e = found.estimates[0];
    assert!((years * e.value / by_hand - 1.0).abs() < 1e-3, "{e:?} {by_hand}");
    let drawn = sums_of_lives(&inputs, &Exceeds, events, &life, &effort(1 << 19), |_| false);
    let m = drawn.mean(|life| life.sum);
    assert!((m.value - by_hand).abs() < m.high - m.low, "{m:?} {by_hand}");

    // Every event of every life, one by one.
    let mut stream = Stream::new(7, 0);
    let law = |place: usize, p: f64| inputs.laws()[place].value_of_chance(p);
    let (n, more) = (60_000, 4.0);
    let (mut exceeding, mut others) = (0u32, 0u32);
    for _ in 0..n {
        let resistance = law(0, stream.draw());
        let (mut sum, mut other) = (0.0, false);
        for _ in 0..years as usize {
            let level = (resistance - law(1, stream.draw())).max(0.0);
            for _ in 0..events {
                let event = -stream.draw().ln();
                sum += (event - level).max(0.0);
                other |= event <= level && stream.draw() < 0.1;
            }
        }
        exceeding += u32::from(sum > more);
        others += u32::from(other);
    }
    let share = f64::from(exceeding) / f64::from(n);
    let error = (share * (1.0 - share) / f64::from(n)).sqrt();
    let p = drawn.chance(|life| life.sum > more);
    assert!((p.value - share).abs() < 4.0 * error + 0.5 * (p.high - p.low), "{p:?} {share}");
    let q = drawn.quantile(1.0 - share).value;
    assert!((q / more - 1.0).abs() < 0.05, "{q}");
    let with_other = drawn.chance(|life| life.others > 0).value;
    assert!((with_other - f64::from(others) / f64::from(n)).abs() < 0.01, "{with_other}");
    // The worst of all lives have everything.
    assert!((drawn.of_worst(1.0) - 1.0).abs() < 1e-12 && drawn.of_worst(0.05) > 0.05);
}
