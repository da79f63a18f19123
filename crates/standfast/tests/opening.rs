//! A base that opens under steady heads: held against the codes' iteration, thin strips, scans of the load factor and worked numbers.

use standfast::contact::opening::{BaseWater, Drain, OpeningLoads, OpeningState};
use standfast::contact::{Block, solve};
use standfast::{Departure, Mode, Wrench};

fn near(found: f64, expected: f64, by: f64) {
    assert!((found - expected).abs() <= by * expected.abs(), "{found}, expected {expected}");
}

/// To six digits.
fn six(found: f64, expected: f64) {
    near(found, expected, 5e-6);
}

struct Random(u64);

impl Random {
    fn next(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        low + (high - low) * ((self.0 >> 11) as f64 / (1u64 << 53) as f64)
    }
}

/// A wall b × h of unit weight `γ_b` in kN and m, its mass as 1 and g as 1 nowhere used: forces are in kN.
fn wall(b: f64, h: f64, μ: f64) -> Block {
    let rho2 = (b * b + h * h) / 12.0;
    Block { b1: b / 2.0, b2: b / 2.0, d: h / 2.0, rho2, m_x: 1.0, m_y: 1.0, mu_s: μ, mu_k: μ }
}

/// A push to the left at an elevation.
fn push(block: &Block, force: f64, elevation: f64) -> Wrench {
    Wrench { x: -force, p: 0.0, m: force * (elevation - block.d) }
}

/// A force down at a distance from O.
fn down(block: &Block, force: f64, distance: f64) -> Wrench {
    Wrench { x: 0.0, p: force, m: -force * (distance - block.b1) }
}

fn water_on_right(block: &Block, level: f64) -> Wrench {
    let γ = 9.81;
    push(block, γ * level * level / 2.0, level / 3.0)
}

fn water_on_left(block: &Block, level: f64) -> Wrench {
    -water_on_right(block, level)
}

const HEADS: BaseWater = BaseWater { left: 0.0, right: 8.0 * 9.81, drain: None };

fn weight(b: f64, h: f64) -> f64 {
    2.4 * 9.81 * b * h
}

/// P at rest, and half of it over the contact: the edge's pressure.
fn pressed(block: &Block, water: &BaseWater, loads: &Wrench) -> (f64, f64, f64) {
    let OpeningState::Open { contact, .. } = water.state(block, loads) else { panic!() };
    let p = (*loads + water.wrench(block, water.state(block, loads))).p;
    (contact, p, 2.0 * p / contact)
}

/// The wall of the specification, as an engineer's own iteration gave it.
#[test]
fn worked_numbers() {
    let block = wall(5.0, 9.0, 0.7);
    let dead = down(&block, weight(5.0, 9.0), 2.5) + water_on_right(&block, 8.0);
    let loads = dead + push(&block, 20.0, 8.0);
    let (contact, p, edge) = pressed(&block, &HEADS, &loads);
    six(contact, 3.01574);
    six(p, 785.418);
    six(0.7 * p / loads.x.abs(), 1.64648);
    six(edge, 520.879);
    let tail = BaseWater { left: 2.0 * 9.81, ..HEADS };
    let (contact, p, _) = pressed(&block, &tail, &(loads + water_on_left(&block, 2.0)));
    six(contact, 3.07456);
    six(p, 757.564);
    six(0.7 * p / (loads + water_on_left(&block, 2.0)).x.abs(), 1.68723);
    let drained = |from_heel: f64| BaseWater {
        drain: Some(Drain { distance: 5.0 - from_heel, efficiency: 0.5 }),
        ..HEADS
    };
    let (contact, p, _) = pressed(&block, &drained(2.5), &loads);
    six(contact, 3.19956);
    six(p, 841.681);
    six(0.7 * p / loads.x.abs(), 1.76442);
    assert!(matches!(drained(0.6).state(&block, &loads), OpeningState::Open { drained: false, .. }));
    assert_eq!(HEADS.state(&block, &(dead + push(&block, 110.0, 8.0))), OpeningState::Through);
    // Where it opens, slides and would tip as the ice grows.
    let block = wall(6.5, 9.0, 0.45);
    let dead = down(&block, weight(6.5, 9.0), 3.25) + water_on_right(&block, 8.0);
    let crane = down(&block, 60.0, 1.5);
    for (more, opens, slides, tips) in
        [(Wrench::ZERO, 0.213231, 2.20945, 4.12769), (crane, 0.196829, 3.33591, 5.08024)]
    {
        let steady = push(&block, 60.0, 8.0) + more;
        let loads = OpeningLoads { permanent: dead, steady, fast: Wrench::ZERO };
        let [first, last] = HEADS.opens_at(&block, &loads);
        six(first.unwrap(), opens);
        six(last.unwrap(), tips);
        let Departure::At { factor, verdict } = HEADS.departure(&block, &loads).unwrap() else { panic!() };
        six(factor, slides);
        assert_eq!(verdict.and_then(standfast::Verdict::mode), Some(Mode::SlideLeft));
        if more == Wrench::ZERO {
            let (contact, ..) = pressed(&block, &HEADS, &(dead + steady * factor));
            six(contact, 3.18526);
        }
    }
    // A dam as a textbook has it: closed, its heel would be pulled; it opens.
    let block = Block { b1: 28.0, b2: 28.0, ..wall(56.0, 80.0, 0.7) };
    let γ = 9.81;
    let dam = BaseWater {
        left: 6.0 * γ,
        right: 80.0 * γ,
        drain: Some(Drain { distance: 48.0, efficiency: 11.0 / 18.0 }),
    };
    let loads = Wrench { x: 0.0, p: 56_024.2, m: 56_024.2 * 28.0 - 1_259_872.0 };
    six(-dam.closed(&block).p, 12_975.4);
    let (contact, _, edge) = pressed(&block, &dam, &loads);
    six(contact, 49.6032);
    near(edge, 1642.11, 5e-5);
}

/// Contact by the codes' iteration: open what is pulled, let the full head in, and look again.
fn iterated(block: &Block, water: &BaseWater, loads: &Wrench) -> Option<f64> {
    let b = block.b1 + block.b2;
    let mut contact = b;
    for _ in 0..100_000 {
        let (low, high) = (water.left, water.right);
        let up = high * (b - contact) + (low + high) / 2.0 * contact;
        let moment = high * (b * b - contact * contact) / 2.0
            + low * contact * contact / 2.0
            + (high - low) * contact * contact / 3.0;
        let p = loads.p - up;
        let about_o = loads.p * block.b1 - loads.m + loads.x * block.d - moment;
        if p <= 0.0 || about_o <= 0.0 {
            return None;
        }
        let next = (3.0 * about_o / p).min(b);
        if (next - contact).abs() <= 1e-15 * b {
            return Some(next);
        }
        contact = next;
    }
    Some(contact)
}

/// A wrench on a base with heads, the higher at the right.
fn any(random: &mut Random) -> (Block, BaseWater, Wrench) {
    let block = Block {
        b1: random.next(0.5, 4.0),
        b2: random.next(0.5, 4.0),
        d: random.next(0.3, 6.0),
        rho2: random.next(0.3, 8.0),
        m_x: random.next(1.0, 1.4),
        m_y: 1.0,
        mu_s: random.next(0.05, 0.9),
        mu_k: 0.0,
    };
    let block = Block { mu_k: block.mu_s, ..block };
    let b = block.b1 + block.b2;
    let low = random.next(0.0, 0.5);
    let water = BaseWater { left: low, right: low + random.next(0.01, 1.0), drain: None };
    let p = water.right * b + random.next(0.01, 3.0);
    let x = random.next(-1.5, 1.5) * p;
    // Resultants about the whole base, and a little beside it.
    let m = x * block.d + p * block.b1 - random.next(-0.2, 1.1) * b * p;
    (block, water, Wrench { x, p, m })
}

#[test]
fn the_codes_iteration_comes_to_the_same_contact() {
    let mut random = Random(7);
    let mut opened = 0;
    while opened < 20_000 {
        let (block, water, loads) = any(&mut random);
        match water.state(&block, &loads) {
            OpeningState::Open { contact, .. } => {
                // The iteration converges from a closed base if it converges at all; near its limit it does so slowly.
                let Some(found) = iterated(&block, &water, &loads) else { continue };
                near(contact, found, 1e-10);
                opened += 1;
            }
            OpeningState::Closed => {
                if let Some(found) = iterated(&block, &water, &loads) {
                    near(found, block.b1 + block.b2, 1e-12);
                }
            }
            OpeningState::Through => assert_eq!(iterated(&block, &water, &loads), None),
        }
    }
}

/// The water is the sum over thin strips of its diagram, and the reaction is in equilibrium: straight, without pull, from the low end on.
#[test]
fn strips_add_up_to_the_water_and_the_reaction() {
    let mut random = Random(11);
    for _ in 0..60 {
        let (block, mut water, loads) = any(&mut random);
        let b = block.b1 + block.b2;
        if random.next(0.0, 1.0) < 0.5 {
            let (distance, efficiency) = (random.next(0.1, 0.9) * b, random.next(0.1, 0.9));
            water.drain = Some(Drain { distance, efficiency });
        }
        if random.next(0.0, 1.0) < 0.5 {
            (water.left, water.right) = (water.right, water.left);
        }
        let state = water.state(&block, &loads);
        let points = water.diagram(&block, state);
        let strips = 200_000;
        let dx = b / f64::from(strips);
        let (mut up, mut moment) = (0.0, 0.0);
        for i in 0..strips {
            let x = (f64::from(i) + 0.5) * dx;
            let pair = points.windows(2).find(|pair| pair[0].0 <= x && x < pair[1].0).unwrap();
            let share = (x - pair[0].0) / (pair[1].0 - pair[0].0);
            let p = pair[0].1 + share * (pair[1].1 - pair[0].1);
            up += p * dx;
            moment += p * dx * (x - block.b1);
        }
        let found = water.wrench(&block, state);
        near(-found.p, up, 1e-6);
        assert!((found.m - moment).abs() < 1e-5 * up * b, "{} {moment}", found.m);
        if let OpeningState::Open { contact, .. } = state {
            let total = loads + found;
            // From the end of the lower head.
            let arm = block.b1 - (total.m - total.x * block.d) / total.p;
            let arm = if water.left > water.right { b - arm } else { arm };
            near(arm, contact / 3.0, 1e-9);
        }
    }
}

/// Under every wrench that presses some mode is consistent, and below Painlevé's bound hardly ever another; the mirror image has the mirrored
/// modes; equal heads change nothing.
#[test]
fn there_is_always_a_mode() {
    let mut random = Random(3);
    let (mut none, mut several, mut count) = (0, 0, 0);
    for _ in 0..100_000 {
        let (block, water, loads) = any(&mut random);
        let found = water.solve(&block, &loads).unwrap();
        none += u32::from(found.modes.is_empty());
        let painlevé = (block.rho2 + block.b1.powi(2)) / (block.b1 * block.d);
        let other = (block.rho2 + block.b2.powi(2)) / (block.b2 * block.d);
        let below = block.mu_k < painlevé.min(other);
        if below {
            count += 1;
            if found.modes.len() > 1 {
                // A push towards the higher water: once that is under the whole base it lifts what it cannot open.
                assert!(
                    loads.x > 0.0 && matches!(found.mode, Some(Mode::Rest | Mode::SlideRight)),
                    "{found:?}"
                );
                several += 1;
            }
        }
        let mirror = Block { b1: block.b2, b2: block.b1, ..block };
        let turned = BaseWater { left: water.right, right: water.left, drain: None };
        let image = turned.solve(&mirror, &Wrench { x: -loads.x, m: -loads.m, ..loads }).unwrap();
        assert_eq!(image.mode, found.mode.map(Mode::mirrored));
        let level = BaseWater { right: water.left, ..water };
        let plain = solve(&block, &(loads + level.closed(&block))).unwrap();
        assert_eq!(level.solve(&block, &loads).unwrap().modes, plain.modes);
    }
    assert_eq!(none, 0);
    assert!(count > 50_000 && several < count / 5000, "{several} of {count}");
}

/// The water passes steadily from closed to open, and from open to nothing pressed.
#[test]
fn states_join() {
    let mut random = Random(5);
    for _ in 0..2000 {
        let (block, water, loads) = any(&mut random);
        let OpeningState::Open { .. } = water.state(&block, &loads) else { continue };
        let b = block.b1 + block.b2;
        let n = loads.p - water.right * b;
        let t = loads.p * block.b1 - loads.m + loads.x * block.d - water.right * b * b / 2.0;
        for (target, side) in [(b * n / 3.0, OpeningState::Closed), (0.0, OpeningState::Through)] {
            let moved = |t_new: f64| Wrench { m: loads.m - (t_new - t), ..loads };
            let [inside, outside] = match side {
                OpeningState::Closed => [target * (1.0 - 1e-9), target * (1.0 + 1e-9)],
                _ => [1e-9 * n * b, -1e-9 * n * b],
            };
            let one = water.state(&block, &moved(inside));
            let two = water.state(&block, &moved(outside));
            assert!(matches!(one, OpeningState::Open { .. }), "{one:?}");
            assert_eq!(two, side);
            let [one, two] = [one, two].map(|state| water.wrench(&block, state));
            assert!(
                (one.p - two.p).abs() < 1e-7 * water.right * b
                    && (one.m - two.m).abs() < 1e-7 * water.right * b * b
            );
        }
    }
}

/// The stages of rising loads are those of a scan: between two scanned factors with one verdict, and with another, a boundary lies.
#[test]
fn stages_are_those_of_a_scan() {
    let mut random = Random(17);
    let mut met = 0;
    for case in 0..400 {
        let (block, mut water, loads) = any(&mut random);
        let b = block.b1 + block.b2;
        if case % 3 == 0 {
            let (distance, efficiency) = (random.next(0.1, 0.9) * b, random.next(0.1, 0.9));
            water.drain = Some(Drain { distance, efficiency });
        }
        if case % 2 == 0 {
            (water.left, water.right) = (water.right, water.left);
        }
        // All of the weight, and a part of the push that rises from nothing.
        let permanent = Wrench { x: 0.1 * loads.x, p: loads.p, m: 0.0 };
        let steady = Wrench { x: loads.x, p: random.next(-0.3, 0.3), m: loads.m };
        let fast = match case % 4 {
            0 => Wrench { x: random.next(-0.5, 0.5), p: random.next(-0.2, 0.2), m: random.next(-0.5, 0.5) },
            _ => Wrench::ZERO,
        };
        let loads = OpeningLoads { permanent, steady, fast };
        let stages = water.stages(&block, &loads).unwrap();
        assert_eq!((stages[0].from, stages.last().unwrap().to), (0.0, f64::INFINITY));
        for i in 1..2000 {
            let λ = f64::from(i) * 0.0021;
            let found = water.solve_at(&block, &loads, λ).unwrap();
            let stage = stages.iter().find(|stage| stage.from <= λ && λ < stage.to).unwrap();
            let edge = (λ - stage.from).abs().min((stage.to - λ).abs());
            if edge > 1e-9 {
                assert_eq!(stage.modes, found.modes, "case {case} at {λ}: {stages:?}");
                met += 1;
            }
        }
    }
    assert!(met > 700_000, "{met}");
}
