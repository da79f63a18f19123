//! A body on springs under short loads, against an integrator of its equations, and against closed forms of one mode.

mod common;

use common::Random;
use standfast::ground::impact::{ElasticBody, ImpactEvent, ImpactResponse};
use standfast::{Expected, History, Wrench};

/// A body, its loads, and all numbers of its equations again.
struct Case {
    b: f64,
    d: f64,
    m: f64,
    i: f64,
    k_n: f64,
    k_t: f64,
    added: f64,
}

impl Case {
    /// Goda's caisson on 50 and 25 MN/m³, with water moved along on both sides: 0.54275·1030·7.1² kg each.
    const GODA: Case = Case {
        b: 7.5,
        d: 5.25,
        m: 346.05e3,
        i: 346.05e3 * (225.0 + 110.25) / 12.0,
        k_n: 50e6,
        k_t: 25e6,
        added: 2.0 * 0.54275 * 1030.0 * 7.1 * 7.1,
    };

    fn body(&self) -> ElasticBody {
        let body = ElasticBody::new(self.b, self.d, self.m, self.i, self.k_n, self.k_t).unwrap();
        body.with_added_mass(self.added).unwrap()
    }

    /// Runge–Kutta of the fourth order from the equations about C, until `until`: calls with t, S, N, M_O. Every moment of the histories
    /// begins a step.
    fn integrate(
        &self,
        permanent: &Wrench,
        loads: &[(Wrench, History)],
        breaks: &[f64],
        until: f64,
        mut see: impl FnMut(f64, [f64; 3]),
    ) {
        let (k_x, k_y, k_r) =
            (2.0 * self.b * self.k_t, 2.0 * self.b * self.k_n, 2.0 / 3.0 * self.k_n * self.b.powi(3));
        let m_x = self.m + self.added;
        // u, turn, y and their rates; from the static position of the permanent loads.
        let mut y = [
            permanent.x / k_x,
            (permanent.m - permanent.x * self.d) / k_r,
            -permanent.p / k_y,
            0.0,
            0.0,
            0.0,
        ];
        let total = |t: f64| loads.iter().fold(*permanent, |sum, (w, h)| sum + *w * h.at(t));
        let rate = |w: Wrench, y: [f64; 6]| {
            let [u, turn, v, du, d_turn, dv] = y;
            let spin = (w.m - self.d * k_x * u - k_r * turn) / self.i;
            let sway = (w.x - k_x * u) / m_x + self.d * spin;
            [du, d_turn, dv, sway, spin, (-w.p - k_y * v) / self.m]
        };
        let mut ends: Vec<f64> =
            breaks.iter().copied().filter(|t| *t > 0.0 && *t < until).chain([until]).collect();
        ends.sort_by(f64::total_cmp);
        let mut t = 0.0;
        see(0.0, [k_x * y[0], -k_y * y[2], k_r * y[1]]);
        for end in ends {
            let n = ((end - t) / 5e-5).ceil();
            let (start, h) = (t, (end - t) / n);
            for i in 0..n as usize {
                let now = start + h * i as f64;
                // The end of a stretch belongs to it: just before a step.
                let at = |s: f64| total(now + s * h * (1.0 - 1e-9) + 1e-12 * h);
                let ahead = |k: [f64; 6], s: f64| std::array::from_fn(|j| y[j] + s * h * k[j]);
                let k1 = rate(at(0.0), y);
                let k2 = rate(at(0.5), ahead(k1, 0.5));
                let k3 = rate(at(0.5), ahead(k2, 0.5));
                let k4 = rate(at(1.0), ahead(k3, 1.0));
                for j in 0..6 {
                    y[j] += h / 6.0 * (k1[j] + 2.0 * k2[j] + 2.0 * k3[j] + k4[j]);
                }
                see(now + h, [k_x * y[0], -k_y * y[2], k_r * y[1]]);
            }
            t = end;
        }
    }
}

fn push(x: f64, elevation: f64, d: f64) -> Wrench {
    Wrench { x: -x, p: 0.0, m: x * (elevation - d) }
}

/// Goda's caisson under a thrust of 0.1 s: the specification's numbers.
#[test]
fn goda_s_caisson_under_a_breaking_wave() {
    let case = Case::GODA;
    let load = (push(940.68e3, 4849.6 / 940.68, 5.25), History::triangle(1.0, 0.05, 0.1).unwrap());
    let rest = Wrench { x: 0.0, p: 2318.64e3, m: 0.0 };
    let answer = case.body().response(&rest, &[load], 0.6, Some(600e3)).unwrap();
    let ImpactResponse { periods: [long, short], .. } = answer;
    assert!((long - 0.296).abs() < 5e-4 && (short - 0.115).abs() < 5e-4, "{long} {short}");
    assert!((answer.d_shear.unwrap() - 1.05).abs() < 5e-3, "{answer:?}");
    assert!((answer.d_moment.unwrap() - 1.39).abs() < 5e-3, "{answer:?}");
    let [k, k_prime] = answer.moved(0.5, 0.2).unwrap();
    assert!((k / 0.5 - answer.d_shear.unwrap()).abs() < 1e-12);
    assert!(((1.0 + k_prime) / 1.2 * answer.d_shear.unwrap() - answer.d_moment.unwrap()).abs() < 1e-12);
}

/// Random bodies and loads: largest values and first events against the integrator, to 1e-7.
#[test]
fn two_modes_are_those_of_the_integrator() {
    let mut random = Random(861);
    let mut seen = [0; 3];
    for _ in 0..8 {
        let (b, d) = (random.uniform(3.0, 9.0), random.uniform(2.0, 9.0));
        let m = random.uniform(1e5, 5e5);
        let k_n = random.log(2e7, 2e8);
        let case = Case {
            b,
            d,
            m,
            i: m * (b * b + d * d) / 3.0 * random.uniform(0.7, 1.3),
            k_n,
            k_t: k_n * random.uniform(0.3, 0.9),
            added: m * random.uniform(0.0, 0.4),
        };
        let rest = Wrench {
            x: random.uniform(-0.05, 0.05) * m * 9.81,
            p: 0.7 * m * 9.81,
            m: random.uniform(-0.05, 0.05) * m * 9.81,
        };
        let t = [random.uniform(0.01, 0.1), random.uniform(0.1, 0.2), random.uniform(0.2, 0.3)];
        // A rise, a peak, a step down, a slope.
        let thrust =
            History::stepped(&[[0.0, 0.0], [t[0], 1.0], [t[0], 0.6], [t[1], 0.3], [t[2], 0.0]]).unwrap();
        let uplift = History::stepped(&[[t[0], 0.5], [t[2], 0.0]]).unwrap();
        let force = m * 9.81 * random.uniform(0.2, 1.2);
        let loads = [
            (push(force, random.uniform(0.5, 1.7) * d, d), thrust),
            (Wrench { x: 0.0, p: -0.2 * m * 9.81, m: 0.1 * m * 9.81 * b }, uplift),
        ];
        let (mu, q) = (0.6, 3.0 * rest.p / (2.0 * b));
        let answer = case.body().response(&rest, &loads, mu, Some(q)).unwrap();

        let about = |w: &Wrench| w.m - w.x * d;
        let mut tail = [[0.0f64; 2]; 2];
        let (mut most, mut first) = ([0.0f64; 2], [None; 3]);
        let mut last: Option<(f64, [f64; 3])> = None;
        case.integrate(&rest, &loads, &t, answer.until, |t, [s, n, m_o]| {
            // The summit of the parabola through three neighbours.
            for (i, value) in [(s - rest.x).abs(), (m_o - about(&rest)).abs()].into_iter().enumerate() {
                let [a, b] = tail[i];
                tail[i] = [b, value];
                if b >= a && b >= value && 2.0 * b > a + value {
                    most[i] = most[i].max(b + (value - a).powi(2) / (8.0 * (2.0 * b - a - value)));
                }
                most[i] = most[i].max(value);
            }
            let left =
                [mu * n - s.abs(), n * b / 3.0 - m_o.abs(), q - n / (2.0 * b) - 1.5 * m_o.abs() / (b * b)];
            if let Some((before, was)) = last {
                for i in 0..3 {
                    if first[i].is_none() && left[i] <= 0.0 {
                        first[i] = Some(before + (t - before) * was[i] / (was[i] - left[i]));
                    }
                }
            }
            last = Some((t, left));
        });
        let x = force.max((loads[0].0 * 0.6).x.abs());
        let close = |ours: f64, theirs: f64| assert!((ours / theirs - 1.0).abs() < 1e-7, "{ours} {theirs}");
        close(answer.d_shear.unwrap() * x, most[0]);
        for (i, event) in answer.events.iter().enumerate() {
            match (event.time, first[i]) {
                (Some(ours), Some(theirs)) => {
                    assert!((ours - theirs).abs() < 1e-7, "{event:?} {theirs}");
                    assert!(event.load_factor <= 1.0, "{event:?}");
                    seen[i] += 1;
                }
                (None, None) => assert!(event.load_factor > 1.0, "{event:?}"),
                other => panic!("{event:?} {other:?}"),
            }
        }
        assert_eq!(
            answer.first_event().and_then(|event| event.time),
            answer.events.iter().filter_map(|event| event.time).reduce(f64::min)
        );
        // At its own load factor an event just happens.
        for event in answer.events.iter().filter(|event| event.load_factor.is_finite()) {
            let scaled = |by: f64| {
                let loads = loads.clone().map(|(w, h)| (w * (event.load_factor * by), h));
                let again = case.body().response(&rest, &loads, mu, Some(q)).unwrap();
                again.events.iter().find(|other| other.event == event.event).unwrap().time
            };
            assert!(scaled(1.0 - 1e-6).is_none() && scaled(1.0 + 1e-6).is_some(), "{event:?}");
        }
    }
    assert!(seen.iter().all(|n| *n > 0), "{seen:?}");
}

/// One mode: with a base that hardly turns, shear follows the textbook's triangle and sudden rise.
#[test]
fn one_mode_has_its_closed_forms() {
    // k_n so large beside k_t that the body only sways: T = 2π √(m/K_x).
    let body = ElasticBody::new(5.0, 1.0, 1e5, 1e6, 1e11, 1e6).unwrap();
    let period = body.frequencies()[0].recip() * std::f64::consts::TAU;
    assert!((period / (std::f64::consts::TAU * (1e5f64 / 1e7).sqrt()) - 1.0).abs() < 1e-5);
    let d_shear = |history: History| {
        let load = (Wrench { x: -1.0, p: 0.0, m: 0.0 }, history);
        body.response(&Wrench { x: 0.0, p: 1.0, m: 0.0 }, &[load], 0.6, None).unwrap().d_shear.unwrap()
    };
    let pi = std::f64::consts::PI;
    for r in [0.05, 0.2, 0.353, 0.5] {
        let expected = 4.0 * (pi * r / 2.0).sin().powi(2) / (pi * r);
        let ours = d_shear(History::triangle(1.0, 0.5 * r * period, r * period).unwrap());
        assert!((ours - expected).abs() < 1e-5, "{r}: {ours} {expected}");
    }
    let triangle = |r: f64| d_shear(History::triangle(1.0, 0.5 * r * period, r * period).unwrap());
    assert!((triangle(0.905) - 1.517).abs() < 5e-4 && (triangle(2.16) - 0.954).abs() < 2e-2);
    let sudden = |r: f64| d_shear(History::decay(1.0, r * period).unwrap());
    for r in [0.371, 0.6, 1.0, 3.0] {
        let expected = 2.0 * (1.0 - (2.0 * pi * r).atan() / (2.0 * pi * r));
        assert!((sudden(r) - expected).abs() < 1e-5, "{r}: {} {expected}", sudden(r));
    }
    // Stepped on and left: twice.
    assert!((d_shear(History::constant(1.0).unwrap()) - 2.0).abs() < 1e-5);
}

#[test]
fn wrong_numbers_are_shown() {
    let body = Case::GODA.body();
    let rest = Wrench { x: 0.0, p: 1.0, m: 0.0 };
    assert!(History::triangle(1.0, 0.2, 0.1).is_err() && History::stepped(&[]).is_err());
    assert!(History::stepped(&[[0.0, f64::NAN], [1.0, 0.0]]).is_err());
    assert!(History::stepped(&[[1.0, 0.0], [0.0, 0.0]]).is_err());
    let early = History::decay(1.0, 1.0).and_then(|history| history.starting(-0.5)).unwrap();
    assert_eq!(body.response(&rest, &[(rest, early)], 0.6, None).unwrap_err().value, -0.5);
    let sine = History::half_sine(1.0, 1.0).unwrap();
    let error = body.response(&rest, &[(rest, sine)], 0.6, None).unwrap_err();
    assert_eq!(error.expected, Expected::StraightLines);
    assert!(body.response(&Wrench { p: 0.0, ..rest }, &[], 0.6, None).is_err());
    assert!(body.response(&rest, &[], -0.1, None).is_err());
    let still = body.response(&rest, &[], 0.6, Some(1.0)).unwrap();
    assert_eq!((still.d_shear, still.first_event()), (None, None));
    assert_eq!(still.events[0].event, ImpactEvent::Slip);
}

/// Numbers out of proportion are refused before they are followed, and what is stiff but finite is not.
#[test]
fn what_would_be_followed_without_end_is_refused() {
    use standfast::{Expected, Quantity};
    let answer = |b: f64, d: f64, k_n: f64, duration: f64| {
        let i = 346e3 * (b * b + d * d) / 3.0;
        let body = ElasticBody::new(b, d, 346e3, i, k_n, 25e6).unwrap();
        let push = Wrench { x: -9.4e5, p: 0.0, m: 0.0 };
        let history = History::triangle(1.0, duration / 2.0, duration).unwrap();
        body.response(&Wrench { x: 0.0, p: 2.3e6, m: 0.0 }, &[(push, history)], 0.6, None)
    };
    for k_n in [1e6, 50e6, 1e12, 1e14] {
        assert!(answer(7.5, 5.25, k_n, 0.1).is_ok(), "{k_n}");
    }
    for (b, d, k_n, duration) in
        [(7.5, 5.25e6, 50e6, 0.1), (7.5, 5.25, 1e18, 0.1), (7.5e-6, 5.25, 50e6, 0.1), (7.5, 5.25, 50e6, 1e9)]
    {
        let error = answer(b, d, k_n, duration).unwrap_err();
        assert_eq!((error.quantity, error.expected), (Quantity::PeriodsFollowed, Expected::PeriodsAtMost));
        assert!(error.value > 1e5, "{error}");
    }
}
