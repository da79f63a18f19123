//! The path and the plane of a rising load where boundaries come close to one another: what is real is kept, what is one
//! crossing computed twice is not shown as two.

mod common;

use common::{Random, tries};
use standfast::contact::path::stages;
use standfast::contact::plane::regions;
use standfast::contact::{Block, solve};
use standfast::initiation::Chart;
use standfast::region::Region;
use standfast::{Diagram, Mode, Stage, Verdict, Wrench};

const WEIGHT: Wrench = Wrench { x: 0.0, p: 1.0, m: 0.0 };

/// The report's force at λ = 1: k = 1 at k'.
fn unit_force(gamma: f64, k_prime: f64) -> Wrench {
    Wrench { x: -1.0, p: 0.0, m: k_prime * gamma }
}

fn modes(stages: &[Stage]) -> Vec<Mode> {
    stages.iter().map(|stage| stage.mode().unwrap()).collect()
}

/// A little below A, μ = (1 − δ)/(γ(1+k')), the body slides between k = μ and the line CD, k = (1/γ − μ)/k', before it begins to
/// turn: a stage δ(1 + 1/k') wide beside 1, which is there however narrow.
#[test]
fn a_narrow_stage_is_a_stage() {
    let (gamma, k_prime) = (1.0, 0.5);
    let k_a = 1.0 / (gamma * (1.0 + k_prime));
    for δ in [1e-3, 1e-6, 1e-9, 1e-12, 1e-13, 2e-14] {
        let mu = k_a * (1.0 - δ);
        let block = Block::uniform(gamma, mu);
        // Whatever the load is measured in.
        for size in [1.0, 1e-8, 1e8] {
            let load = unit_force(gamma, k_prime) * size;
            let path = stages(&block, &WEIGHT, &load).unwrap();
            assert_eq!(modes(&path)[..3], [Mode::Rest, Mode::SlideLeft, Mode::SlideRockOLeft], "{δ}");
            let (Stage { from, to, .. }, mode) = (path[1], path[1].mode());
            let [first, last] = [mu, (1.0 / gamma - mu) / k_prime].map(|k| k / size);
            let near = |one: f64, two: f64| (one - two).abs() <= 6.0 * f64::EPSILON * two;
            assert!(near(from, first) && near(to, last), "{δ}: {from} {to}");
            let between = solve(&block, &(WEIGHT + load * ((first + last) / 2.0))).unwrap();
            assert_eq!(between.mode(), mode, "{δ}");
        }
    }
}

/// Through A, where four boundaries meet, the body goes from rest to what lies right of A at μ = k_A: RO where μ* falls from A
/// (cases 1b and 2), SRO- where it rises (case 1a). Nothing is in between, though the crossings differ in their last digits.
#[test]
fn crossings_that_coincide_are_one() {
    let mut random = Random(51);
    let mut seen = [0, 0];
    while seen.iter().sum::<u32>() < tries(5_000) {
        let (gamma, k_prime) = (random.uniform(0.3, 3.0), random.uniform(0.3, 1.0));
        let chart = Chart::new(gamma, k_prime).unwrap();
        let slope = chart.mu_star().slope(chart.k_a());
        // Where a curve is nearly level the last digit of μ moves its crossing far.
        if slope.abs() < 0.2 {
            continue;
        }
        let mu = 1.0 / (gamma * (1.0 + k_prime));
        let size = random.pick(&[1.0, 1e-8, 1e8]);
        let load = unit_force(gamma, k_prime) * size;
        let path = stages(&Block::uniform(gamma, mu), &WEIGHT, &load).unwrap();
        let falls = slope < 0.0;
        let expected = if falls { Mode::RockO } else { Mode::SlideRockOLeft };
        assert_eq!(modes(&path)[..2], [Mode::Rest, expected], "γ = {gamma}, k' = {k_prime}: {path:?}");
        assert!((path[0].to * size - mu).abs() <= 1e-14 * mu);
        seen[usize::from(falls)] += 1;
    }
    assert!(seen.iter().all(|&count| 50 * count > tries(5_000)), "{seen:?}");
}

/// A random block and wrench.
fn random_case(random: &mut Random) -> (Block, Wrench) {
    let mut block = Block::uniform(random.uniform(0.3, 4.0), random.log(0.1, 4.0));
    block.b1 *= random.uniform(0.5, 1.5);
    block.m_x += random.uniform(0.0, 1.0);
    block.mu_k *= random.uniform(0.3, 1.0);
    (block, Wrench { x: random.uniform(-1.0, 1.0), p: 1.0, m: random.uniform(-1.0, 1.0) })
}

/// From nothing a load does not change as it grows: one stage, with the modes of any share of it. At nothing itself no load tells
/// the modes, neither of one that lifts nor of one that presses.
#[test]
fn a_load_without_another_has_one_stage() {
    let mut random = Random(55);
    for _ in 0..tries(1_000).max(50) {
        let (block, mut wrench) = random_case(&mut random);
        wrench.p = random.uniform(-1.0, 1.0);
        let path = stages(&block, &Wrench::ZERO, &wrench).unwrap();
        let answer = solve(&block, &wrench).unwrap();
        let stage = Stage {
            from: 0.0,
            to: f64::INFINITY,
            verdict: answer.mode().map(Verdict::Begins),
            modes: answer.modes,
        };
        assert_eq!(path, [stage], "{block:?} {wrench:?}");
    }
}

/// A path is the same whatever its load is measured in, up to the last stage, which begins at 10²⁰ or 10⁻²⁰.
#[test]
fn a_path_is_free_of_scale() {
    let mut random = Random(56);
    for _ in 0..tries(1_000).max(50) {
        let (block, variable) = random_case(&mut random);
        let path = stages(&block, &WEIGHT, &variable).unwrap();
        for size in [2f64.powi(-70), 2f64.powi(70)] {
            let scaled = stages(&block, &WEIGHT, &(variable * size)).unwrap();
            let back = |stage: Stage| Stage { from: stage.from * size, to: stage.to * size, ..stage };
            assert_eq!(scaled.into_iter().map(back).collect::<Vec<_>>(), path, "{block:?} {variable:?}");
        }
    }
}

/// However much it takes to move the body, its path can be told: a load that would leave the range of numbers before it moves
/// the body never does.
#[test]
fn a_load_out_of_range_is_never_reached() {
    let weight = WEIGHT * 1e45;
    for load in [1e-10, 1.0, 1e10, 1e30] {
        for i in 0..60 {
            // Through the base, so that it turns nothing: it slides at μ P, from 10⁴⁸ to 10⁵¹.
            let mu = 10f64.powf(3.0 + f64::from(i) / 20.0);
            let path = stages(&Block::uniform(1.0, mu), &weight, &Wrench { x: -load, p: 0.0, m: -load });
            let path = path.unwrap_or_else(|error| panic!("{mu} {load}: {error}"));
            assert_eq!(path[0].mode(), Some(Mode::Rest));
            let moves = path.get(1).map(|stage| stage.from * load);
            match mu * 1e45 {
                // Twice the load that moves it is within the range still.
                force if force < 2.4e49 => {
                    assert!((moves.unwrap() / force - 1.0).abs() < 1e-12, "{mu} {load}")
                }
                force if force > 1e50 => assert_eq!(moves, None, "{mu} {load}"),
                _ => {}
            }
        }
    }
}

fn holders(regions: &[Region], λ: f64, μ: f64) -> Vec<Mode> {
    regions.iter().filter(|region| region.contains(λ, μ)).map(|region| region.mode).collect()
}

/// Rest ends at k_A. Where that is a little more than 1e-9 of the range, the region of rest is there; a little less, and it
/// is joined to its neighbour. So is the last strip, and the plane still reaches its end.
#[test]
fn a_strip_is_joined_below_a_billionth_of_the_range() {
    let (gamma, k_prime) = (1.0, 0.5);
    let k_a = 1.0 / (gamma * (1.0 + k_prime));
    let plane = |up_to| regions(&Block::uniform(gamma, 1.0), &WEIGHT, &unit_force(gamma, k_prime), up_to);
    let at = |up_to: f64, λ: f64, μ: f64| holders(&plane(up_to).unwrap(), λ, μ);
    let (less, more) = (0.9e-9, 1.1e-9);
    // At the left end, far above every curve: RE, then RO.
    assert_eq!(at(k_a / more, k_a / 2.0, 1e12), [Mode::Rest]);
    assert_eq!(at(k_a / less, k_a / 2.0, 1e12), [Mode::RockO]);
    // At the right end.
    let (narrow, wide) = (k_a / (1.0 - less), k_a / (1.0 - more));
    assert_eq!(at(wide, (k_a + wide) / 2.0, 5.0), [Mode::RockO]);
    assert_eq!(at(wide, wide, 5.0), [Mode::RockO]);
    assert_eq!(at(narrow, narrow, 5.0), [Mode::Rest]);
    assert_eq!(at(narrow, narrow, 0.1), [Mode::SlideLeft]);
}

/// No strip is narrower than that, whatever coincides; strips follow one another from 0 to the end of the range.
#[test]
fn no_sliver_is_left() {
    let mut random = Random(52);
    for _ in 0..tries(400).max(5) {
        let mut block = Block::uniform(random.uniform(0.3, 4.0), 1.0);
        if random.coin() {
            block.b1 *= random.uniform(0.5, 1.5);
            block.m_x += random.uniform(0.0, 1.0);
            block.mu_k = random.uniform(0.3, 1.0);
        }
        let k_prime = random.uniform(-1.0, 1.0);
        let up_to = random.log(0.1, 100.0);
        let regions = regions(&block, &WEIGHT, &unit_force(block.d, k_prime), up_to).unwrap();
        let mut ends = [0.0, 0.0];
        for region in &regions {
            for strip in &region.strips {
                assert!(strip.to - strip.from > 0.999e-9 * up_to, "{block:?} {k_prime} {strip:?}");
                ends[1] = strip.to.max(ends[1]);
            }
            for pair in region.strips.windows(2) {
                assert_eq!(pair[0].to, pair[1].from);
            }
        }
        assert_eq!(ends, [0.0, up_to], "{block:?} {k_prime}");
    }
}

/// Without friction a block has the plane that it has with any: μ runs over it.
#[test]
fn the_plane_of_a_block_without_friction() {
    let load = unit_force(1.5, 0.4);
    let [without, with] =
        [0.0, 1.0].map(|mu| regions(&Block::uniform(1.5, mu), &WEIGHT, &load, 4.0).unwrap());
    assert_eq!(without, with);
}

/// Above the last boundary too the mode is right: of a tall block with its mass about the middle that is Painlevé's bound on the
/// friction, (ρ² + b²)/(b d), far below 1.
#[test]
fn above_every_boundary() {
    let mut random = Random(58);
    for _ in 0..tries(60).max(6) {
        let (block, variable) = random_case(&mut random);
        let block =
            Block { b1: 0.5, b2: 0.5, d: random.uniform(4.0, 8.0), rho2: random.uniform(0.05, 0.2), ..block };
        let regions = regions(&block, &WEIGHT, &variable, 2.0).unwrap();
        for _ in 0..100 {
            let (λ, μ) = (random.uniform(0.0, 2.0), random.log(0.1, 100.0));
            let at = Block { mu_s: μ, mu_k: μ * (block.mu_k / block.mu_s), ..block };
            let mode = solve(&at, &(WEIGHT + variable * λ)).unwrap().mode();
            assert_eq!(holders(&regions, λ, μ), Vec::from_iter(mode), "{block:?} {variable:?} {λ} {μ}");
        }
    }
}

/// Modes depend on the ratio of two loads: the plane of one that rises beside another, at λ, is that of the other beside the
/// one, at 1/λ. So it is where the weight is what rises, and no boundary but those of friction has a part that stays.
#[test]
fn two_loads_change_places() {
    let mut random = Random(57);
    let mut checked = 0;
    for case in 0..tries(60).max(6) {
        let (block, one) = random_case(&mut random);
        let two = match case % 3 {
            0 => Wrench { x: random.uniform(-1.0, 1.0), p: 0.0, m: random.uniform(-1.0, 1.0) },
            1 => Wrench { x: random.uniform(-1.0, 1.0), p: -0.3, m: 0.0 },
            _ => Wrench { x: 0.0, p: 0.0, m: random.uniform(-1.0, 1.0) },
        };
        let one = if random.coin() { WEIGHT } else { one };
        let [here, there] =
            [(one, two), (two, one)].map(|(one, two)| regions(&block, &one, &two, 5.0).unwrap());
        for _ in 0..200 {
            let (λ, μ) = (random.log(0.2, 5.0), random.uniform(0.0, 4.0));
            assert_eq!(
                holders(&here, λ, μ),
                holders(&there, 1.0 / λ, μ),
                "{block:?} {one:?} {two:?} {λ} {μ}"
            );
            checked += holders(&here, λ, μ).len();
        }
    }
    assert!(checked > tries(10_000) as usize, "{checked}");
}

/// Two boundaries an angle of 4.5·10⁻⁷ apart: a light load that pulls to the left before λ = ½ and to the right after. Sliding
/// either way has its own region, as `solve` says.
#[test]
fn boundaries_close_to_each_other_are_two() {
    let ε = 1e-7;
    let block = Block::uniform(1.0, 1.0);
    let (permanent, variable) = (Wrench { x: -ε, p: 1.0, m: 0.0 }, Wrench { x: 2.0 * ε, p: 0.0, m: 0.0 });
    let regions = regions(&block, &permanent, &variable, 1.0).unwrap();
    for (λ, slides) in [(0.1, Mode::SlideLeft), (0.9, Mode::SlideRight)] {
        for (μ, mode) in [(0.4 * ε, slides), (1.2 * ε, Mode::Rest)] {
            let at = Block { mu_s: μ, mu_k: μ, ..block };
            assert_eq!(solve(&at, &(permanent + variable * λ)).unwrap().mode(), Some(mode));
            assert_eq!(holders(&regions, λ, μ), [mode], "{λ} {μ}");
        }
    }
}

/// In air the plane has the report's regions strip by strip: a boundary found twice, by two conditions that differ in their
/// last digits, would cut them into more.
#[test]
fn the_plane_has_as_many_strips_as_the_report_s_diagram() {
    let mut random = Random(53);
    for _ in 0..tries(400).max(5) {
        let (gamma, k_prime) = (random.uniform(0.3, 4.0), random.uniform(0.05, 1.0));
        let diagram = Diagram::of(Chart::new(gamma, k_prime).unwrap());
        let up_to = 2.0 * diagram.window().k;
        let regions =
            regions(&Block::uniform(gamma, 1.0), &WEIGHT, &unit_force(gamma, k_prime), up_to).unwrap();
        let strips = |regions: &[Region]| {
            let mut all: Vec<_> = regions.iter().map(|region| (region.mode, region.strips.len())).collect();
            all.sort();
            all
        };
        assert_eq!(strips(&regions), strips(diagram.regions()), "γ = {gamma}, k' = {k_prime}");
    }
}

/// A region holds its mode up to the ends of each of its strips, next to its curves and between them: where two curves cross
/// unnoticed within a strip, they would have changed places at one of its ends.
#[test]
fn a_strip_holds_its_mode_up_to_its_ends() {
    let mut random = Random(54);
    let mut checked = 0;
    for _ in 0..tries(300).max(10) {
        let mut block = Block::uniform(random.uniform(0.3, 4.0), 1.0);
        block.b1 *= random.uniform(0.5, 1.5);
        block.m_x += random.uniform(0.0, 1.0);
        // With one friction nothing but a curve's own zero says where it meets the axis.
        block.mu_k = if random.coin() { 1.0 } else { random.uniform(0.3, 1.0) };
        let mut wrench = |p: f64| Wrench { x: random.uniform(-1.0, 1.0), p, m: random.uniform(-1.0, 1.0) };
        let (permanent, variable) = (wrench(1.0), wrench(-0.3));
        let up_to = random.log(0.3, 10.0);
        for region in regions(&block, &permanent, &variable, up_to).unwrap() {
            for strip in &region.strips {
                for share in [1e-3, 0.5, 0.999] {
                    let λ = strip.from + (strip.to - strip.from) * share;
                    let lower = strip.lower.at(λ);
                    let upper = strip.upper.map_or(2.0 * lower + 1.0, |upper| upper.at(λ));
                    let rounding = 1e-9 * (1.0 + upper.abs());
                    assert!(lower >= -rounding && upper >= lower - rounding, "{block:?} {strip:?} {λ}");
                    if upper - lower < 1e3 * rounding {
                        continue;
                    }
                    for height in [0.01, 0.5, 0.99] {
                        let μ = lower + (upper - lower) * height;
                        let at = Block { mu_s: μ, mu_k: μ * block.mu_k, ..block };
                        let mode = solve(&at, &(permanent + variable * λ)).unwrap().mode();
                        assert_eq!(mode, Some(region.mode), "{block:?} {strip:?} {λ} {μ}");
                        checked += 1;
                    }
                }
            }
        }
    }
    assert!(checked > tries(10_000), "{checked}");
}
