//! Adhesion and forces with a limit: worked numbers, scans of the forces and of the load factor, the plain problem where nothing holds.

use standfast::contact::holding::{Adhesion, AdhesionArea, Hold, Holding};
use standfast::contact::{Block, solve};
use standfast::loads::{Action, BodyPoint, Load, LoadKind, LoadSource};
use standfast::{Body, Departure, Mode, Situation, Verdict, Wrench};

/// Equal to six digits.
fn six(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 5e-6 * expected.abs(), "{found}, expected {expected}");
}

struct Random(u64);

impl Random {
    fn next(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        low + (high - low) * ((self.0 >> 11) as f64 / (1u64 << 53) as f64)
    }

    fn block(&mut self) -> Block {
        let [b1, b2, d] = [self.next(0.5, 2.0), self.next(0.5, 2.0), self.next(0.3, 3.0)];
        let μ = self.next(0.1, 0.9);
        Block { b1, b2, d, rho2: (d * d + 1.0) * self.next(0.3, 0.6), m_x: 1.0, m_y: 1.0, mu_s: μ, mu_k: μ }
    }

    fn wrench(&mut self) -> Wrench {
        Wrench { x: self.next(-1.5, 1.5), p: self.next(0.2, 1.5), m: self.next(-2.0, 2.0) }
    }

    fn hold(&mut self, block: &Block) -> Hold {
        let (x, y) = (self.next(-block.b1, block.b2), self.next(-block.d, block.d));
        let limit = self.next(0.05, 1.0);
        match self.next(0.0, 3.0) as u8 {
            0 => Hold { at: [0.0, y], direction: [1.0, 0.0], limit },
            1 => Hold { at: [0.0, y], direction: [-1.0, 0.0], limit },
            _ => Hold { at: [x, 0.0], direction: [0.0, -1.0], limit },
        }
    }
}

/// 1200 kN/m, 6 m wide, pushed with 620 at 7 m.
fn pushed(width: f64, weight: f64, force: f64, elevation: f64, μ: f64) -> Situation {
    let body = Body::new(width, 8.0, weight / 9.81).unwrap();
    let push = Load::variable(LoadSource::Force, LoadKind::Horizontal, Action::horizontal(-force, elevation));
    Situation::new(body, μ, 9.81).unwrap().with_weight().with(push)
}

fn tie(elevation: f64, limit: f64) -> Hold {
    Hold { at: [0.0, elevation - 4.0], direction: [1.0, 0.0], limit }
}

#[test]
fn a_tie_has_the_numbers_of_the_specification() {
    let free = pushed(6.0, 1200e3, 620e3, 7.0, 0.5);
    assert_ne!(free.outcome().unwrap().full.mode(), Some(Mode::Rest));
    let held = free.with_holding(Holding::default().with(tie(9.0, 150e3)));
    let outcome = held.outcome().unwrap();
    assert_eq!(outcome.full.mode(), Some(Mode::Rest));
    six(outcome.held.unwrap().needed.unwrap()[0], 82.2222e3);
    let Departure::At { factor, verdict } = outcome.departure else { panic!() };
    six(factor, 1.14055);
    assert_eq!(verdict, Some(Verdict::Begins(Mode::RockO)));
    // The needed tie counts in full: (1200 · 3 + 150 · 9)/(620 · 7), and 600 + 150 over 620.
    six(outcome.stability.overturning_about_heel, 4950.0 / 4340.0);
    six(outcome.gross.about_heel, 4950.0 / 4340.0);
    six(outcome.stability.sliding, 750.0 / 620.0);
    six(outcome.stability.resultant_arm.unwrap(), 610.0 / 1200.0);
}

#[test]
fn adhesion_has_the_numbers_of_the_specification() {
    for (on, adhering, sliding) in
        [(AdhesionArea::Pressed, 7.2, 1.8), (AdhesionArea::Effective, 4.8, 1.47273)]
    {
        // t_e = 5 − 1100 e/1500 = 2.4.
        let situation = pushed(10.0, 1500e3, 1100e3, 2.6 * 1500.0 / 1100.0, 0.6);
        let held = situation.with_holding(Holding::new(Some(Adhesion { strength: 150e3, on })));
        let outcome = held.outcome().unwrap();
        six(outcome.held.unwrap().adhering, adhering);
        six(outcome.stability.sliding, sliding);
        assert_eq!(outcome.full.mode(), Some(Mode::Rest));
        assert!(outcome.full.modes.contains(Mode::SlideLeft), "{}", outcome.full.modes);
        // On the way: |X|P = μP² + c_a reach T, a quadratic of the load factor; here, where it tips first, T = 0.
        let Departure::At { factor, verdict } = outcome.departure else { panic!() };
        let (p, e) = (1500.0, 2.6 * 1500.0 / 1100.0);
        let reach = if on == AdhesionArea::Pressed { 3.0 } else { 2.0 };
        let slides = |λ: f64| {
            let t = p * 5.0 - 1100.0 * λ * e;
            1100.0 * λ * p > 0.6 * p * p + 150.0 * (reach * t).min(10.0 * p) || t < 0.0
        };
        let scanned = (1..400_000).map(|i| f64::from(i) * 1e-5).find(|λ| slides(*λ)).unwrap();
        assert!((factor - scanned).abs() < 2e-5, "{factor}, {scanned}");
        assert!(verdict.is_some());
    }
}

/// Without adhesion and with forces of nothing, all is as in the plain problem.
#[test]
fn nothing_holds_nothing() {
    let mut random = Random(1);
    for _ in 0..3000 {
        let (block, wrench) = (random.block(), random.wrench());
        let plain = solve(&block, &wrench).unwrap();
        let nothing = Hold { limit: 0.0, ..random.hold(&block) };
        for holding in [
            Holding::default(),
            Holding::new(Some(Adhesion { strength: 0.0, on: AdhesionArea::Pressed })),
            Holding::default().with(nothing),
        ] {
            let held = holding.solve(&block, &wrench).unwrap();
            assert_eq!((held.modes, held.mode), (plain.modes, plain.mode()));
        }
    }
}

/// The least force under which the body rests is that of a scan of the force; of two, of a scan of both.
#[test]
fn what_is_needed_is_what_a_scan_finds() {
    let mut random = Random(2);
    let (mut one, mut two) = (0, 0);
    for _ in 0..4000 {
        let (block, wrench) = (random.block(), random.wrench());
        let holds = [random.hold(&block), random.hold(&block)];
        let adhesion = (random.next(0.0, 1.0) < 0.5)
            .then(|| Adhesion { strength: random.next(0.0, 0.5), on: AdhesionArea::Pressed });
        let rests = |wrench: &Wrench, adhesion: Option<Adhesion>| {
            Holding::new(adhesion).needed(&block, wrench).unwrap().is_some()
        };
        let steps = 400;
        let found = Holding::new(adhesion).with(holds[0]).needed(&block, &wrench).unwrap();
        let force = |i: i32| holds[0].limit * f64::from(i) / f64::from(steps);
        let scanned = (0..=steps).find(|i| rests(&(wrench + holds[0].unit() * force(*i)), adhesion));
        match (found, scanned) {
            (Some(found), Some(i)) => {
                assert!(
                    found[0] <= force(i) + 1e-9 && found[0] >= force(i - 1) - 1e-9,
                    "{} {}",
                    found[0],
                    force(i)
                );
                one += usize::from(found[0] > 0.0);
            }
            (None, Some(i)) => panic!("the scan rests at {}", force(i)),
            _ => {}
        }
        let found = Holding::default().with(holds[0]).with(holds[1]).needed(&block, &wrench).unwrap();
        let grid = 30;
        let at = |i: i32, j: i32| {
            let share = |n: i32| f64::from(n) / f64::from(grid);
            wrench
                + holds[0].unit() * (holds[0].limit * share(i))
                + holds[1].unit() * (holds[1].limit * share(j))
        };
        let scanned = (0..=grid).any(|i| (0..=grid).any(|j| rests(&at(i, j), None)));
        match found {
            Some(forces) => {
                let held = Holding::default().with(holds[0]).with(holds[1]).held(&wrench, &forces);
                // On an edge of rest, rounding aside.
                let inside = Wrench { p: held.p * (1.0 + 1e-9), ..held };
                assert!(
                    rests(&held, None) || rests(&inside, None) || forces.iter().any(|force| *force > 0.0)
                );
                two += usize::from(forces.iter().any(|force| *force > 0.0));
            }
            None => assert!(!scanned),
        }
    }
    assert!(one > 300 && two > 300, "{one} {two}");
}

/// With one force there always is a mode, and it is unchanged seen in a mirror.
#[test]
fn one_force_leaves_a_mode() {
    let mut random = Random(3);
    let mut kept = 0;
    for _ in 0..20_000 {
        let (block, wrench, hold) = (random.block(), random.wrench(), random.hold(&Random(7).block()));
        let holding = Holding::default().with(hold);
        let found = holding.solve(&block, &wrench).unwrap();
        assert!(found.mode.is_some(), "{block:?} {wrench:?} {hold:?}");
        kept +=
            usize::from(found.mode != Some(Mode::Rest) && found.used[0] > 0.0 && found.used[0] < hold.limit);
        let mirrored_block = Block { b1: block.b2, b2: block.b1, ..block };
        let mirrored = Hold {
            at: [-hold.at[0], hold.at[1]],
            direction: [-hold.direction[0], hold.direction[1]],
            ..hold
        };
        let other = Holding::default().with(mirrored);
        let other = other.solve(&mirrored_block, &Wrench { x: -wrench.x, m: -wrench.m, ..wrench }).unwrap();
        assert_eq!(found.modes.iter().map(Mode::mirrored).collect::<standfast::Modes>(), other.modes);
    }
    assert!(kept > 50, "{kept}");
}

/// The stages of a rising load are what the load factors inside them decide, wherever one looks.
#[test]
fn stages_are_what_every_load_factor_decides() {
    let mut random = Random(4);
    for case in 0..160 {
        let block = random.block();
        let permanent = Wrench { x: 0.0, p: 1.0, m: 0.0 };
        let variable = random.wrench();
        let adhesion = (case % 2 == 0)
            .then(|| Adhesion { strength: random.next(0.0, 0.6), on: AdhesionArea::Effective });
        let mut holding = Holding::new(adhesion).with(random.hold(&block));
        if adhesion.is_none() && case % 4 == 1 {
            holding = holding.with(random.hold(&block));
        }
        let stages = holding.stages(&block, &permanent, &variable).unwrap();
        for i in 1..200 {
            let factor = f64::from(i) * 0.0217;
            let stage = stages.iter().find(|stage| stage.from < factor && factor < stage.to).unwrap();
            let near_end = [stage.from, stage.to].iter().any(|end| (end - factor).abs() < 1e-7 * factor);
            let decided = holding.decide(&block, &(permanent + variable * factor)).unwrap();
            assert!(
                near_end || (stage.verdict, stage.modes) == (decided.verdict, decided.modes),
                "{factor} {stages:?} {decided:?}"
            );
        }
    }
}

/// A force down beside the heel holds a body that would tip; one of nothing does not.
#[test]
fn a_force_down_holds_a_corner() {
    let tipping = pushed(6.0, 1200e3, 400e3, 10.0, 0.8);
    let down = Hold { at: [2.5, 0.0], direction: [0.0, -1.0], limit: 200e3 };
    let outcome = tipping.with_holding(Holding::default().with(down)).outcome().unwrap();
    // 1200 · 3 + r · 5.5 = 400 · 10.
    six(outcome.held.unwrap().needed.unwrap()[0], 400e3 / 5.5);
    six(outcome.stability.overturning_about_heel, (3600.0 + 1100.0) / 4000.0);
    let at = BodyPoint { x: 2.5, y: 0.0 };
    let load =
        Load::permanent(LoadSource::Force, LoadKind::Weight, Action::Force { at, right: 0.0, up: -200e3 });
    let plain = pushed(6.0, 1200e3, 400e3, 10.0, 0.8).with(load).outcome().unwrap();
    six(outcome.stability.resultant_arm.unwrap(), plain.stability.resultant_arm.unwrap());
}
