//! Bodies on joints, from the text of a case to its answer.

mod common;

use common::{assess, file, number, refused, six};
use standfast::contact::stack::{Joint, Shaking, Stack, StackBody};
use standfast::{Departure, Mode, Wrench};
use standfast_cases::assess::{Assessed, Assessment};
use standfast_cases::results::ResultName;

const G: f64 = 9.81;

/// A generator of its own.
struct Random(u64);

impl Random {
    fn number(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let share = (self.0 >> 40) as f64 / (1u64 << 24) as f64;
        // As decimals are written.
        ((low + (high - low) * share) * 1000.0).round() / 1000.0
    }

    fn chance(&mut self, share: f64) -> bool {
        self.number(0.0, 1.0) < share
    }
}

/// A block of a wall.
#[derive(Debug, Clone, Copy)]
struct Block {
    left: f64,
    right: f64,
    bottom: f64,
    top: f64,
    density: f64,
}

impl Block {
    fn weight(&self) -> f64 {
        self.density * G * (self.right - self.left) * (self.top - self.bottom)
    }

    fn text(&self, name: usize) -> String {
        let Block { left, right, bottom, top, density } = self;
        format!(
            "[[part]]\nname = \"block {name}\"\nleft = {left}\nwidth = {}\nbottom = {bottom}\nheight = {}\ndensity = {density}\n",
            right - left,
            top - bottom
        )
    }
}

/// Blocks on each other, with ledges and overhangs.
fn blocks(random: &mut Random, count: usize) -> Vec<Block> {
    let mut blocks: Vec<Block> = Vec::new();
    let (mut left, mut right, mut bottom) = (0.0, random.number(3.0, 5.0), 0.0);
    for _ in 0..count {
        let top = bottom + random.number(0.8, 1.6);
        blocks.push(Block { left, right, bottom, top, density: random.number(2200.0, 2600.0) });
        left += random.number(-0.3, 0.5);
        right += random.number(-0.5, 0.3);
        bottom = top;
    }
    blocks
}

/// What acts on bodies, summed up: to the right, upwards and counter-clockwise about the origin.
#[derive(Debug, Clone, Copy, Default)]
struct Sum([f64; 3]);

impl Sum {
    fn add(&mut self, [x, y]: [f64; 2], right: f64, up: f64) {
        self.0[0] += right;
        self.0[1] += up;
        self.0[2] += x * up - y * right;
    }
}

/// The same of what is above a joint, as the answer has it.
fn found(on: &Assessed, left: f64, level: f64) -> [f64; 3] {
    let (wrench, body) = (on.outcome.full.wrench, on.situation.body());
    let [x, y] = [left + body.heel_distance(), level + body.centroid_height()];
    [wrench.x, -wrench.p, wrench.m - x * wrench.p - y * wrench.x]
}

fn near(one: [f64; 3], two: [f64; 3]) -> bool {
    let size = two.iter().fold(1.0, |most: f64, part| most.max(part.abs()));
    one.iter().zip(two).all(|(a, b)| (a - b).abs() <= 1e-9 * size)
}

/// Walls of blocks in water with ledges, overhangs, forces and pressures, open, tight and given joints: each joint carries the sum of all
/// that is above it, added up block by block.
#[test]
fn every_joint_carries_the_sum_of_what_is_above_it() {
    let mut random = Random(7);
    let mut tried = [0; 3];
    for _ in 0..150 {
        let count = 2 + usize::from(random.chance(0.6)) + usize::from(random.chance(0.4));
        let blocks = blocks(&mut random, count);
        let crest = blocks[count - 1].top;
        let levels = [random.number(0.2, crest), random.number(0.2, crest)];
        let unit = 1025.0 * G;
        let mut text = String::from("[body]\nfriction = 0.9\n");
        for (place, block) in blocks.iter().enumerate() {
            text += &block.text(place + 1);
        }
        text += &format!(
            "[water]\nleft = {}\nright = {}\ndensity = 1025\nopening = \"closed\"\n",
            levels[0], levels[1]
        );
        let mut kinds = Vec::new();
        for (place, block) in blocks.iter().enumerate().skip(1) {
            let kind = (random.number(0.0, 2.999)) as usize;
            tried[kind] += 1;
            kinds.push(kind);
            let water = match kind {
                0 => "uplift = \"open\"",
                1 => "uplift = \"tight\"",
                _ => "uplift_left = \"7 kPa\"\nuplift_right = \"12 kPa\"",
            };
            text += &format!(
                "[[joint]]\nelevation = {}\nfriction = 0.9\n{water}\nname = \"j{place}\"\n",
                block.bottom
            );
        }
        let push = [random.number(0.0, crest), random.number(-9e3, 9e3)];
        let (towards, size) = if push[1] > 0.0 { ("right", push[1]) } else { ("left", -push[1]) };
        text += &format!(
            "[[load]]\nforce = {size}\nelevation = {}\ndirection = \"{towards}\"\ntogether = true\n",
            push[0]
        );
        // On the top of the lowest block beside the second where there is a ledge, on top of all elsewhere.
        let at = random.number(blocks[0].left, blocks[0].right);
        let top = blocks
            .iter()
            .rev()
            .find(|block| block.left - 1e-3 <= at && at <= block.right + 1e-3)
            .unwrap()
            .top;
        text += &format!(
            "[[load]]\nforce = 4000\ndistance = {}\ndirection = \"down\"\ntogether = true\n",
            at - blocks[0].left
        );
        let [low, high] = [0.3 * crest, 0.8 * crest].map(|y| (y * 1000.0).round() / 1000.0);
        text += &format!(
            "[[pressure]]\nface = \"right\"\nelevation = [{low}, {high}]\npressure = [9000, 2000]\npermanent = true\n"
        );
        let assessment = match file(&text).case() {
            Ok(case) => Assessment::of(&case).unwrap(),
            // What is above a joint may fall beside it.
            Err(error) => {
                assert!(error.to_string().contains("centre of mass"), "{error}\n{text}");
                continue;
            }
        };
        let one = assessment.governing();
        for (joint, on) in one.on_joints().enumerate() {
            let level = blocks[joint].bottom;
            let mut sum = Sum::default();
            for (place, block) in blocks.iter().enumerate().skip(joint) {
                let Block { left, right, bottom, top, .. } = *block;
                sum.add([(left + right) / 2.0, (bottom + top) / 2.0], 0.0, -block.weight());
                for (side, level) in levels.into_iter().enumerate() {
                    let (x, inwards) = if side == 0 { (left, 1.0) } else { (right, -1.0) };
                    let wet = top.min(level);
                    if wet > bottom {
                        let (p, q) = (unit * (level - bottom), unit * (level - wet));
                        let height = wet - bottom;
                        let y = bottom + height * (p + 2.0 * q) / (3.0 * (p + q));
                        sum.add([x, y], inwards * (p + q) / 2.0 * height, 0.0);
                    }
                    // Beside the block above it, where it draws back; under this one, where it overhangs.
                    if let Some(above) = blocks.get(place + 1) {
                        let other = if side == 0 { above.left } else { above.right };
                        let ledge = inwards * (other - x);
                        if ledge > 0.0 {
                            sum.add([(x + other) / 2.0, top], 0.0, -unit * (level - top).max(0.0) * ledge);
                        }
                    }
                    if let Some(below) = place.checked_sub(1).map(|below| blocks[below]) {
                        let other = if side == 0 { below.left } else { below.right };
                        let overhang = inwards * (other - x);
                        if overhang > 0.0 {
                            sum.add(
                                [(x + other) / 2.0, bottom],
                                0.0,
                                unit * (level - bottom).max(0.0) * overhang,
                            );
                        }
                    }
                }
            }
            let ends = match joint.checked_sub(1).map(|below| blocks[below]) {
                None => [blocks[0].left, blocks[0].right],
                Some(below) => [below.left.max(blocks[joint].left), below.right.min(blocks[joint].right)],
            };
            let kind = if joint == 0 { 0 } else { kinds[joint - 1] };
            let water = match kind {
                0 => levels.map(|water| unit * (water - level).max(0.0)),
                1 => [0.0; 2],
                _ => [7e3, 12e3],
            };
            let width = ends[1] - ends[0];
            sum.add([ends[0] + width / 3.0, level], 0.0, water[0] * width / 2.0);
            sum.add([ends[0] + 2.0 * width / 3.0, level], 0.0, water[1] * width / 2.0);
            if push[0] >= level {
                sum.add([0.0, push[0]], push[1], 0.0);
            }
            if top > level {
                sum.add([at, top], 0.0, -4000.0);
            }
            let from = low.max(level);
            if from < high {
                let pressure = |y: f64| 9000.0 - 7000.0 * (y - low) / (high - low);
                let (p, q, height) = (pressure(from), pressure(high), high - from);
                let y = from + height * (p + 2.0 * q) / (3.0 * (p + q));
                sum.add([0.0, y], -(p + q) / 2.0 * height, 0.0);
            }
            assert!(
                near(found(on, ends[0], level), sum.0),
                "joint {joint}: {:?} {:?}\n{text}",
                found(on, ends[0], level),
                sum.0
            );
        }
    }
    assert!(tried.iter().all(|count| *count > 40), "{tried:?}");
}

/// Dry blocks under a shaking and a push: departure, modes and motion are those of the same stack in pure numbers.
#[test]
fn joints_of_a_case_are_the_stack_in_pure_numbers() {
    let mut random = Random(11);
    let (mut moved, mut slips) = (0, 0);
    for _ in 0..120 {
        let count = 2 + usize::from(random.chance(0.5));
        let blocks = blocks(&mut random, count);
        let frictions: Vec<f64> = (0..count).map(|_| random.number(0.2, 0.8)).collect();
        let kinetic: Vec<f64> =
            frictions.iter().map(|μ| if random.chance(0.5) { *μ } else { 0.8 * μ }).collect();
        let k = random.number(0.1, 1.2);
        let push = [random.number(0.0, blocks[count - 1].top), random.number(0.0, 4e4)];
        let mut text = format!("[body]\nfriction = {}\nkinetic_friction = {}\n", frictions[0], kinetic[0]);
        for (place, block) in blocks.iter().enumerate() {
            text += &block.text(place + 1);
            if place > 0 {
                text += &format!(
                    "[[joint]]\nelevation = {}\nfriction = {}\nkinetic_friction = {}\n",
                    block.bottom, frictions[place], kinetic[place]
                );
            }
        }
        text += &format!("[earthquake]\nhorizontal = \"{k} g\"\nhorizontal_fixed = true\n");
        text += &format!("[[load]]\nforce = {}\nelevation = {}\ntogether = true\n", push[1], push[0]);
        let Ok(case) = file(&text).case() else { continue };
        let assessment = Assessment::of(&case).unwrap();
        let joints = assessment.governing().joints.as_ref().unwrap();
        let bodies = blocks.iter().map(|block| {
            let Block { left, right, bottom, top, density } = *block;
            let (w, h) = (right - left, top - bottom);
            let (mass, y) = (density * w * h, (bottom + top) / 2.0);
            let acts = bottom <= push[0] && (push[0] < top || top == blocks[count - 1].top);
            let force = if acts { push[1] } else { 0.0 };
            let variable = Wrench { x: -force, p: 0.0, m: force * (push[0] - y) };
            StackBody {
                x: (left + right) / 2.0,
                y,
                variable,
                ..StackBody::of(mass, mass * (w * w + h * h) / 12.0)
            }
        });
        let ends = |joint: usize| match joint {
            0 => [blocks[0].left, blocks[0].right],
            _ => [
                blocks[joint - 1].left.max(blocks[joint].left),
                blocks[joint - 1].right.min(blocks[joint].right),
            ],
        };
        let stack = Stack {
            bodies: bodies.collect(),
            joints: (0..count)
                .map(|joint| {
                    let [l, r] = ends(joint);
                    Joint { h: blocks[joint].bottom, l, r, mu_s: frictions[joint], mu_k: kinetic[joint] }
                })
                .collect(),
            shaking: Shaking { gravity: G, horizontal: k, ..Shaking::default() },
        };
        let departure = stack.departure().unwrap();
        assert_eq!(joints.leaves.joints(), departure.joints(), "{text}");
        assert_eq!(joints.leaves.at_once, departure.at_once, "{text}");
        assert!(
            (joints.leaves.load_factor / departure.load_factor - 1.0).abs() < 1e-9
                || departure.load_factor == 0.0
        );
        assert_eq!(joints.departing(), departure.answer.modes(), "{text}");
        let answer = stack.answer(1.0).unwrap();
        assert_eq!(joints.modes().unwrap(), answer.modes(), "{text}");
        let others: Vec<&[Mode]> = joints.also().collect();
        assert_eq!(others, answer.others().collect::<Vec<_>>());
        let (found, expected) = (joints.motion().unwrap(), answer.motion().unwrap());
        for (one, other) in found.bodies.iter().zip(&expected.bodies) {
            for (a, b) in
                [(one.x_ddot, other.x_ddot), (one.y_ddot, other.y_ddot), (one.theta_ddot, other.theta_ddot)]
            {
                assert!((a - b).abs() < 1e-7 * (1.0 + b.abs()), "{a} {b}\n{text}");
            }
        }
        for (one, other) in found.joints.iter().zip(&expected.joints) {
            for (a, b) in [
                (one.t, other.t),
                (one.v, other.v),
                (one.omega, other.omega),
                (one.f, other.f),
                (one.n, other.n),
                (one.xi, other.xi),
            ] {
                assert!((a - b).abs() < 1e-7 * (1.0 + b.abs()), "{one:?} {other:?}\n{text}");
            }
        }
        moved += usize::from(answer.modes().iter().any(|mode| *mode != Mode::Rest));
        slips += usize::from(answer.modes().iter().any(|mode| mode.slip().is_some()));
    }
    assert!(moved > 60 && slips > 30, "{moved} {slips}");
}

/// Up to where they leave rest all joints rest, just beyond it one moves: with the load itself so much larger.
#[test]
fn joints_rest_up_to_their_load_factor() {
    let mut random = Random(3);
    for _ in 0..40 {
        let blocks = blocks(&mut random, 3);
        let case = |force: f64| {
            let mut text = String::from("[body]\nfriction = 0.5\n");
            for (place, block) in blocks.iter().enumerate() {
                text += &block.text(place + 1);
                if place > 0 {
                    text += &format!(
                        "[[joint]]\nelevation = {}\nfriction = 0.55\nuplift = \"open\"\n",
                        block.bottom
                    );
                }
            }
            text += "[water]\nlevel = 1.5\ndensity = 1025\n";
            text + &format!("[[load]]\nforce = {force}\nelevation = 2.2\ntogether = true\n")
        };
        let Ok(read) = file(&case(1e4)).case() else { continue };
        let whole = Assessment::of(&read).unwrap();
        let Departure::At { factor, .. } = whole.governing().departure() else { continue };
        let rests = |share: f64| assess(&case(1e4 * factor * share)).governing().mode() == Some(Mode::Rest);
        assert!(rests(1.0 - 1e-9) && !rests(1.0 + 1e-9), "{factor}");
        let least = whole.governing().on_joints().map(|on| on.outcome.departure.load_factor());
        let least = least.fold(f64::INFINITY, f64::min);
        assert!((least / factor - 1.0).abs() < 1e-12, "{least} {factor}");
    }
}

/// Three blocks of decimals that no f64 has, of one friction, shaken: every joint is at its limit at once, and the lowest slides.
#[test]
fn equal_friction_under_a_shaking_is_a_tie() {
    let text = |k: &str| {
        let mut text = String::from("[body]\nfriction = 0.3\n");
        for i in 0..3 {
            let block = Block {
                left: 0.1,
                right: 1.4,
                bottom: 0.7 * f64::from(i),
                top: 0.7 * f64::from(i + 1),
                density: 2345.6,
            };
            text += &format!(
                "[[part]]\nleft = 0.1\nwidth = 1.3\nbottom = \"{:.1} m\"\nheight = 0.7\ndensity = {}\n",
                block.bottom, block.density
            );
        }
        for level in ["0.7", "1.4"] {
            text += &format!("[[joint]]\nelevation = {level}\nfriction = 0.3\n");
        }
        text + &format!("[earthquake]\nhorizontal = \"{k} g\"\nhorizontal_fixed = true\n")
    };
    let assessment = assess(&text("0.4"));
    let one = assessment.governing();
    let joints = one.joints.as_ref().unwrap();
    assert_eq!(joints.leaves.joints(), [0, 1, 2]);
    six(joints.leaves.load_factor, 0.75);
    assert_eq!(joints.departing(), [Mode::SlideLeft, Mode::Rest, Mode::Rest]);
    assert_eq!(joints.modes().unwrap(), [Mode::SlideLeft, Mode::Rest, Mode::Rest]);
    assert_eq!(joints.is_unique(), Some(true));
    six(joints.motion().unwrap().bodies[2].x_ddot, -0.1 * G);
    // Exactly at the limit they rest, and λ is 1.
    let edge = assess(&text("0.3"));
    assert_eq!(edge.governing().mode(), Some(Mode::Rest));
    assert_eq!(edge.governing().joints.as_ref().unwrap().leaves.load_factor, 1.0);
}

const TWO: &str = "[body]\nfriction = 0.6\n\
    [[part]]\nname = \"lower\"\nleft = 2\nwidth = 4\nbottom = 0\nheight = 2\ndensity = 2000\n\
    [[part]]\nname = \"upper\"\ngroup = \"top\"\nleft = 3\nwidth = 2\nbottom = 2\nheight = 3\ndensity = 2500\n";
const PUSH: &str = "[[load]]\nname = \"push\"\nforce = \"20 kN/m\"\nelevation = 4\n";

fn joint(more: &str) -> String {
    format!("[[joint]]\nname = \"bed\"\nelevation = 2\nfriction = 0.5\n{more}")
}

fn on(assessment: &Assessment, joint: usize) -> &Assessed {
    assessment.governing().on_joints().nth(joint).unwrap()
}

/// Numbers by hand: weight of the upper 2500·6·9.81 N, pushed at 2 m above the joint.
#[test]
fn a_joint_by_hand() {
    let assessment = assess(&format!("{TWO}{}{PUSH}", joint("")));
    let upper = on(&assessment, 1);
    let weight = 2500.0 * 6.0 * G;
    six(upper.outcome.full.wrench.p, weight);
    six(number(upper, ResultName::SfSliding), 0.5 * weight / 20e3);
    six(number(upper, ResultName::SfOverturningNet), weight / (20e3 * 2.0));
    six(number(upper, ResultName::Eccentricity), 40e3 / weight);
    let joints = assessment.governing().joints.as_ref().unwrap();
    assert_eq!(joints.leaves.joints(), [1]);
    six(joints.leaves.load_factor, 0.5 * weight / 20e3);
    assert_eq!(joints.called(1), "joint 2 (bed)");
    assert_eq!(joints.places[1].ends, [3.0, 5.0]);
    // Keyed to the left half: the middle of what is above is at its right end.
    let narrow = assess(&format!("{TWO}{}{PUSH}", joint("left = 3\nright = 4.5\n")));
    let narrow = on(&narrow, 1);
    six(number(narrow, ResultName::SfSliding), 0.5 * weight / 20e3);
    six(number(narrow, ResultName::Eccentricity), (40e3 - 0.25 * weight).abs() / weight);
}

/// Water in a joint: tight, nothing; open, from side to side; given, as given and growing if it is said.
#[test]
fn water_in_a_joint_lifts_what_is_above() {
    let wet = "[water]\nleft = 3\nright = 4\ndensity = 1000\nopening = \"closed\"\n";
    let p = |water: &str| on(&assess(&format!("{TWO}{wet}{}{PUSH}", joint(water))), 1).outcome.full.wrench.p;
    let weight = 2500.0 * 6.0 * G;
    six(p("uplift = \"tight\"\n"), weight);
    six(p("uplift = \"open\"\n"), weight - 1000.0 * G * (1.0 + 2.0) / 2.0 * 2.0);
    six(p("uplift_left = \"5 kPa\"\nuplift_right = 9000\n"), weight - 7e3 * 2.0);
    let grows =
        assess(&format!("{TWO}{wet}{}{PUSH}", joint("uplift_left = 0\nuplift_right = 9000\ngrows = true\n")));
    let uplift = on(&grows, 1)
        .situation
        .loads()
        .iter()
        .find(|load| load.source == standfast::loads::LoadSource::Uplift);
    assert!(!uplift.unwrap().permanent);
    // The whole does not feel it.
    let base = |water: &str| on(&assess(&format!("{TWO}{wet}{}{PUSH}", joint(water))), 0).outcome.full.wrench;
    assert_eq!(base("uplift = \"tight\"\n"), base("uplift = \"open\"\n"));
}

/// Where a joint is narrower than the bodies meet, water beside it stands in the gap, tight joint or not: by hand, of forces and of moments.
#[test]
fn water_stands_in_the_gap_beside_a_joint() {
    let wet = "[water]\nleft = 3\nright = 4\ndensity = 1000\nopening = \"closed\"\n";
    let above = |more: &str| {
        let assessment =
            assess(&format!("{TWO}{wet}{}{PUSH}", joint(&format!("left = 3.5\nright = 4.75\n{more}"))));
        on(&assessment, 1).outcome.full.wrench
    };
    // 2 m of the upper block from x = 3, of which 0.5 m at the left and 0.25 m at the right do not bear.
    let weight = 2500.0 * 6.0 * G;
    let [left, right] = [1000.0 * G * 1.0 * 0.5, 1000.0 * G * 2.0 * 0.25];
    let tight = above("uplift = \"tight\"\n");
    six(tight.p, weight - left - right);
    let open = above("uplift = \"open\"\n");
    six(open.p, weight - left - right - 1000.0 * G * 1.5 * 1.25);
    let given = above("uplift_left = 0\nuplift_right = \"8 kPa\"\n");
    six(given.p, weight - left - right - 4e3 * 1.25);
    // The wide joint has the whole underside: at the same pressures from side to side another diagram, and none at all if it is tight.
    let wide =
        on(&assess(&format!("{TWO}{wet}{}{PUSH}", joint("uplift = \"tight\"\n"))), 1).outcome.full.wrench;
    six(wide.p, weight);
    // About the centre at x = 4: the gaps are pressed up at 3.25 and at 4.875.
    six(tight.m - wide.m, right * 0.875 - left * 0.75);
    // Archimedes: of equal levels an open joint and its gaps are pressed as the whole underside is.
    let level = |more: &str| {
        let text =
            format!("{TWO}[water]\nlevel = 4\ndensity = 1000\nopening = \"closed\"\n{}{PUSH}", joint(more));
        on(&assess(&text), 1).outcome.full.wrench.p
    };
    six(level("left = 3.5\nuplift = \"open\"\n"), level("uplift = \"open\"\n"));
    // A wave of the pressure p beside the joint, 15 m wide: a gap of 1 m is pressed by p, an open joint by p/2 from end to end.
    let crown = include_str!("../../../examples/joints/crown-wall-on-caisson.toml");
    let p = |water: &str, more: &str| {
        let text = crown.replace("uplift = \"open\"", &format!("uplift = \"{water}\"\n{more}"));
        on(&assess(&text), 1).outcome.full.wrench.p
    };
    let gap = "right = \"23 m\"";
    let [tight, open] = ["tight", "open"].map(|water| p(water, "") - p(water, gap));
    assert!(tight > 10e3, "{tight}");
    six(open, tight / 2.0);
    six(p("tight", "") - p("open", ""), tight * 7.5);
}

/// Where a joint is said to end where the bodies' contact does, rounding leaves no gap for water: 0.1 + 0.2 is more than 0.3.
#[test]
fn rounding_leaves_no_gap_beside_a_joint() {
    let blocks = "[body]\nfriction = 0.5\n[[part]]\nleft = 0\nwidth = 1\nbottom = 0\nheight = 2\ndensity = 2500\n\
                  [[part]]\nleft = 0.1\nwidth = 0.2\nbottom = 2\nheight = 2\ndensity = 2500\n\
                  [water]\nlevel = 3\ndensity = 1000\nopening = \"closed\"\n";
    let loads = |right: &str| {
        let assessment = assess(&format!("{blocks}{}{PUSH}", joint(&format!("uplift = \"tight\"\n{right}"))));
        on(&assessment, 1).situation.loads().len()
    };
    assert_eq!(loads("right = 0.3\n"), loads(""));
    assert_eq!(loads("right = 0.25\n"), loads("") + 1);
}

/// Where water reaches above a joint, the file has to say what is in it.
#[test]
fn water_above_a_joint_has_to_be_told() {
    let lower = "[water]\nlevel = 2\ndensity = 1000\n";
    let higher = "[water]\nlevel = 2.5\ndensity = 1000\n";
    assess(&format!("{TWO}{lower}{}{PUSH}", joint("")));
    let error = refused(&format!("{TWO}{higher}{}{PUSH}", joint("")));
    assert!(error.contains("water reaches above the joint at 2 m"), "{error}");
    let pressed = "[[pressure]]\nface = \"left\"\nelevation = [0, 3]\npressure = [9000, 0]\n";
    let error = refused(&format!("{TWO}{pressed}{}{PUSH}", joint("")));
    assert!(error.contains("a [[pressure]], which may be of water, reaches above"), "{error}");
    let error = refused(&format!("{TWO}{pressed}{}{PUSH}", joint("uplift = \"open\"\n")));
    assert!(error.contains("neither [water] nor [wave]"), "{error}");
}

/// What has no place beside joints, or is no joint, is refused by name.
#[test]
fn what_is_no_joint_is_said() {
    for (text, expected) in [
        (
            format!("{TWO}{PUSH}[[joint]]\nelevation = 5\nfriction = 0.5\n"),
            "the joint is 5 m above the base; expected a level below the crest",
        ),
        (format!("{TWO}{PUSH}[[joint]]\nelevation = 0\nfriction = 0.5\n"), "`elevation` is 0"),
        (format!("{TWO}{PUSH}[[joint]]\nelevation = 2\n"), "`friction`"),
        (format!("{TWO}{PUSH}{}{}", joint(""), joint("")), "two joints are at one level, 2 m"),
        (
            format!("{TWO}{PUSH}{}[[joint]]\nname = \"bed\"\nelevation = 1\nfriction = 0.5\n", joint("")),
            "two joints are called \"bed\"",
        ),
        (format!("{TWO}{PUSH}{}", joint("").replace("bed", "base")), "two joints are called \"base\""),
        (format!("{TWO}{PUSH}{}", joint("kinetic_friction = 0.6\n")), "`kinetic_friction` is 0.6"),
        (
            format!("{TWO}{PUSH}{}", joint("left = 2.5\n")),
            "`left` of the joint is 2.5 m; what is below and above it touches from 3 m to 5 m",
        ),
        (format!("{TWO}{PUSH}{}", joint("left = 4\nright = 4\n")), "the joint reaches from 4 m to 4 m"),
        (format!("{TWO}{PUSH}{}", joint("left = 4.5\n")), "has its centre of mass beside it"),
        (format!("{TWO}{PUSH}{}", joint("uplift = \"open\"\nuplift_left = 3\nuplift_right = 4\n")), "uplift"),
        (format!("{TWO}{PUSH}{}", joint("uplift_left = 3\n")), "`uplift_right`"),
        (format!("{TWO}{PUSH}{}", joint("grows = true\n")), "`uplift_left`"),
        (
            format!(
                "{TWO}{PUSH}{}[[resistance]]\nlimit = 1\ndirection = \"right\"\nelevation = 1\n",
                joint("")
            ),
            "[[joint]] is not for a force with a limit",
        ),
        (
            format!(
                "{TWO}{PUSH}{}[motion.base]\nhorizontal = {{ shape = \"half-sine\", peak = \"4 m/s2\", duration = 0.5 }}\n",
                joint("")
            ),
            "[[joint]] is not for the motion in time",
        ),
        (format!("{TWO}{}[[moment]]\nmoment = 10\n", joint("")), "`elevation`"),
        (
            format!(
                "{}buoyant_weight = 2e5\n{PUSH}{}",
                TWO.replace("friction = 0.6\n", "friction = 0.6\nbuoyant_weight = 1e5\n"),
                joint("")
            )
            .replace("buoyant_weight = 2e5\n", ""),
            "[[joint]] is not for a buoyant weight",
        ),
        (
            format!(
                "{}{PUSH}{}",
                TWO.replace("friction = 0.6\n", "friction = 0.6\nfloor_deg = 2\n"),
                joint("")
            ),
            "[[joint]] is not for a tilted floor",
        ),
        (
            format!(
                "[body]\nwidth = 2\nheight = 6\nmass = 3e4\nfriction = 0.6\ncentroid_height = 2.5\n{PUSH}{}",
                joint("")
            ),
            "[[joint]] cuts a uniform block, or parts; `centroid_height` says more of the whole",
        ),
        (
            format!(
                "[body]\nshape = \"cylinder\"\nwidth = 2\nheight = 6\nmass = 3e4\nfriction = 0.6\n{PUSH}{}",
                joint("left = 0.5\n")
            )
            .replace("20 kN/m", "20 kN"),
            "a cylinder has no `joint[2].left`",
        ),
    ] {
        let error = refused(&text);
        assert!(error.contains(expected), "{expected}\n{error}\n{text}");
    }
}

/// Joints may stand in any order: they are numbered from the base.
#[test]
fn joints_are_numbered_from_the_base() {
    let block = "[body]\nwidth = 2\nheight = 6\nmass = 3e4\nfriction = 0.6\n";
    let joint = |name: &str, level: f64, friction: f64| {
        format!("[[joint]]\nname = \"{name}\"\nelevation = {level}\nfriction = {friction}\n")
    };
    let (one, two) = (joint("low", 1.0, 0.4), joint("high", 4.0, 0.3));
    let push = PUSH.replace("elevation = 4", "elevation = 5");
    let sorted = format!("{block}{one}{two}{push}");
    let other = format!("{block}{two}{push}{one}");
    let answers = [&sorted, &other].map(|text| assess(text));
    let of = |assessment: &Assessment| {
        let joints = assessment.governing().joints.as_ref().unwrap();
        (joints.places.clone(), joints.leaves.clone())
    };
    assert_eq!(of(&answers[0]), of(&answers[1]));
    for text in [&sorted, &other] {
        let file = file(text);
        let find = |name: &str| standfast_model::couple::Variable::find(name, file.inputs());
        let inputs = file.inputs();
        for (name, friction) in
            [("joint[2].friction", 0.4), ("joint[3].friction", 0.3), ("joint.low.friction", 0.4)]
        {
            let id = find(name).unwrap().id();
            assert_eq!(inputs.number(id), Some(friction), "{name}");
        }
        let unknown = find("joint[1].friction").unwrap_err();
        assert_eq!(unknown.suggestion.as_deref(), Some("body.friction"));
    }
}

/// A block without parts is cut as two blocks that are drawn.
#[test]
fn a_block_is_cut_as_its_pieces_are_drawn() {
    let whole = format!("[body]\nwidth = 2\nheight = 6\nmass = 30000\nfriction = 0.6\n{}{PUSH}", joint(""));
    let parts = "[body]\nfriction = 0.6\n\
        [[part]]\nleft = 0\nwidth = 2\nbottom = 0\nheight = 2\ndensity = 2500\n\
        [[part]]\nleft = 0\nwidth = 2\nbottom = 2\nheight = 4\ndensity = 2500\n";
    let parts = format!("{parts}{}{PUSH}", joint(""));
    let [one, other] = [whole, parts].map(|text| assess(&text));
    let [a, b] = [&one, &other].map(|answer| answer.governing().joints.as_ref().unwrap());
    assert_eq!(a.leaves.joints(), b.leaves.joints());
    six(a.leaves.load_factor, b.leaves.load_factor);
    assert_eq!(a.modes(), b.modes());
    for result in [
        ResultName::SfSliding,
        ResultName::SfOverturningNet,
        ResultName::BearingMax,
        ResultName::ContactShare,
    ] {
        six(number(on(&one, 1), result), number(on(&other, 1), result));
    }
}

/// Factors of a combination, partial factors and changes reach every joint.
#[test]
fn combinations_reach_every_joint() {
    let wet = "[water]\nleft = 3\nright = 4\ndensity = 1000\nopening = \"closed\"\n";
    let with = |more: &str| {
        let text = format!(
            "{TWO}{wet}{}{PUSH}[[combination]]\nname = \"c\"\n{more}",
            joint("uplift = \"open\"\nkinetic_friction = 0.4\n")
        );
        assess(&text)
    };
    let weight = 2500.0 * 6.0 * G;
    let p = |assessment: &Assessment| on(assessment, 1).outcome.full.wrench.p;
    // 1 m at the left, 2 m at the right, each half of the joint's 2 m.
    let ends = [1000.0 * G * 1.0, 1000.0 * G * 2.0];
    six(p(&with("factors = { push = 1 }\n")), weight - ends[0] - ends[1]);
    six(p(&with("factors = { push = 1, water = 0.5 }\n")), weight - 0.5 * (ends[0] + ends[1]));
    six(p(&with("factors = { push = 1, \"water.right\" = 1.2 }\n")), weight - ends[0] - 1.2 * ends[1]);
    six(p(&with("factors = { push = 1, weight = 0.9 }\n")), 0.9 * weight - ends[0] - ends[1]);
    six(p(&with("factors = { push = 1, \"weight.top\" = 0.8 }\n")), 0.8 * weight - ends[0] - ends[1]);
    let friction = |more: &str| {
        let assessment = with(&format!("factors = {{ push = 1 }}\n{more}"));
        let situation = &on(&assessment, 1).situation;
        [situation.static_friction(), situation.kinetic_friction()]
    };
    for divided in ["materials = { friction = 1.25 }\n", "resist = { sliding = 1.25 }\n"] {
        let [sticks, slips] = friction(divided);
        assert_eq!(sticks, 0.4);
        six(slips, 0.32);
    }
    assert_eq!(friction("set = { \"joint.bed.friction\" = 0.45 }\n")[0], 0.45);
    assert_eq!(friction("materials = { \"joint[2].friction\" = 2 }\n")[0], 0.25);
    // On effects: the push counts against the resistance times its factor, at a joint as at the base.
    let effects = with("effects = true\nfactors = { push = 1.5 }\n");
    let upper = on(&effects, 1);
    let [push, at_left, at_right] = [20e3, 1000.0 * G * 0.5, 1000.0 * G * 2.0];
    six(
        number(upper, ResultName::SfSliding),
        0.5 * (weight - ends[0] - ends[1]) / (1.5 * push + at_right - at_left),
    );
}

/// A vertical load without elevation stands on the highest part there; a couple acts where it is said to.
#[test]
fn loads_act_on_the_body_that_they_are_on() {
    let down = |distance: f64, more: &str| {
        format!(
            "{TWO}{}[[load]]\nforce = 5000\ndirection = \"down\"\ndistance = {distance}\n{more}",
            joint("")
        )
    };
    let weight = 2500.0 * 6.0 * G;
    // Distances are from O, at 2 m: the ledge reaches to 3 m.
    six(on(&assess(&down(0.5, "")), 1).outcome.full.wrench.p, weight);
    six(on(&assess(&down(1.5, "")), 1).outcome.full.wrench.p, weight + 5000.0);
    six(on(&assess(&down(1.5, "elevation = 1\n")), 1).outcome.full.wrench.p, weight);
    let couple = |elevation: f64| {
        let text = format!("{TWO}{}[[moment]]\nmoment = 3000\nelevation = {elevation}\n", joint(""));
        let assessment = assess(&text);
        [0, 1].map(|joint| on(&assessment, joint).outcome.full.wrench.m)
    };
    assert_eq!(couple(1.0)[1], 0.0);
    six(couple(2.0)[1], 3000.0);
    six(couple(1.0)[0], couple(2.0)[0]);
}

/// Water that moves with what is above a joint: its mass, and its push on a shaken wall, are those of the water above.
#[test]
fn shaken_water_is_that_above_the_joint() {
    let wall = "[body]\nwidth = 4\nheight = 10\nmass = 96000\nfriction = 0.6\n[water]\nlevel = 8\ndensity = 1000\n\
        [added_mass]\nsides = \"right\"\n[earthquake]\nhorizontal = \"1 m/s2\"\nhorizontal_fixed = true\n\
        [[joint]]\nelevation = 3\nfriction = 0.6\nuplift = \"tight\"\n";
    let assessment = assess(wall);
    let upper = on(&assessment, 1);
    // ∫p over the wall above 3 m of the series p = 8ρah/π² Σ s/n² cos(nπy/2h), in strips.
    let h = 8.0;
    let pressure = |y: f64| -> f64 {
        let terms = (0..800).map(|i| {
            let n = 2.0 * f64::from(i) + 1.0;
            (if i % 2 == 0 { 1.0 } else { -1.0 }) / (n * n) * (n * std::f64::consts::PI * y / (2.0 * h)).cos()
        });
        8.0 * 1000.0 * h / std::f64::consts::PI.powi(2) * terms.sum::<f64>()
    };
    let strips = 2000;
    let dy = 5.0 / f64::from(strips);
    let force: f64 = (0..strips).map(|i| pressure(3.0 + (f64::from(i) + 0.5) * dy) * dy).sum();
    assert!(
        (upper.situation.added_mass() / force - 1.0).abs() < 1e-4,
        "{} {force}",
        upper.situation.added_mass()
    );
    let x = upper.outcome.full.wrench.x;
    assert!((-x / (0.7 * 96000.0 + force) - 1.0).abs() < 1e-4, "{x}");
}

/// On ground, and with adhesion, the base is that of the whole: what all begin with together is not answered, and the reason is told.
#[test]
fn a_base_with_more_than_friction_is_that_of_the_whole() {
    let ground = "[ground]\nfriction_angle_deg = 35\nunit_weight = 10000\n";
    let text = format!("{TWO}{}{PUSH}", joint(""));
    let alone = assess(&format!("{TWO}{PUSH}{ground}"));
    let assessment = assess(&format!("{text}{ground}"));
    let joints = assessment.governing().joints.as_ref().unwrap();
    assert!(joints.together.why_not().unwrap().starts_with("on [ground]"));
    let [glued, upper] =
        [alone.governing().departure().load_factor(), on(&assessment, 1).outcome.departure.load_factor()];
    six(joints.leaves.load_factor, glued.min(upper));
    let adhering = assess(&text.replace("friction = 0.6\n", "friction = 0.6\nadhesion = \"100 kPa\"\n"));
    let joints = adhering.governing().joints.as_ref().unwrap();
    assert!(joints.together.why_not().unwrap().starts_with("with adhesion"));
    assert_eq!(joints.modes(), None);
    assert_eq!(joints.leaves.joints(), [1]);
    assert_eq!(adhering.governing().mode(), Some(Mode::Rest));
}

/// The plane of load factor and friction: at each place the joint that leaves rest first is that of the case with this friction.
#[test]
fn the_plane_names_the_joint_that_leaves_rest_first() {
    let mut random = Random(23);
    let (mut seen, mut upper) = (0, 0);
    for _ in 0..12 {
        let blocks = blocks(&mut random, 3);
        let frictions = [random.number(0.4, 0.7), random.number(0.3, 0.7), random.number(0.3, 0.7)];
        let case = |share: f64| {
            let mut text = format!("[body]\nfriction = {}\n", frictions[0] * share);
            for (place, block) in blocks.iter().enumerate() {
                text += &block.text(place + 1);
                if place > 0 {
                    let friction = frictions[place] * share;
                    text += &format!("[[joint]]\nelevation = {}\nfriction = {friction}\n", block.bottom);
                }
            }
            text + "[[load]]\nforce = 30e3\nelevation = 1.9\ntogether = true\n[[load]]\nforce = 9e3\nelevation = 2.3\npermanent = true\n"
        };
        let Ok(read) = file(&case(1.0)).case() else { continue };
        let whole = Assessment::of(&read).unwrap();
        let window = [3.0, 1.5 * frictions[0]];
        let plane = whole.governing().joints.as_ref().unwrap().departures(window).unwrap();
        for share in [0.21, 0.47, 0.83, 1.0, 1.37] {
            let scaled = assess(&case(share));
            let leaves = scaled.governing().joints.as_ref().unwrap().leaves.clone();
            for factor in [0.13, 0.71, 1.3, 2.2, 2.9] {
                if (factor / leaves.load_factor - 1.0).abs() < 0.01 || leaves.limits.len() != 1 {
                    continue;
                }
                let found = plane.at(factor, frictions[0] * share).unwrap();
                let moving = found.iter().position(|mode| *mode != Mode::Rest);
                let expected = (leaves.at_once || leaves.load_factor < factor).then(|| leaves.joints()[0]);
                assert_eq!(moving, expected, "{factor} {share} {leaves:?}\n{}", case(share));
                seen += 1;
                upper += usize::from(expected.is_some_and(|joint| joint > 0));
            }
        }
    }
    assert!(seen > 150 && upper > 20, "{seen} {upper}");
}

/// The plane of what all joints begin with at once: at each place the answer of the case with these forces and this friction.
#[test]
fn the_plane_at_once_is_the_answer_of_each_case() {
    let mut random = Random(29);
    let (mut seen, mut both) = (0, 0);
    for _ in 0..4 {
        let blocks = blocks(&mut random, 2);
        // The upper joint so rough that it drags the lower one along.
        let frictions = [random.number(0.15, 0.3), random.number(0.6, 0.9)];
        let case = |factor: f64, share: f64| {
            let bed = blocks[1].bottom;
            format!(
                "[body]\nfriction = {}\n{}{}[[joint]]\nelevation = {bed}\nfriction = {}\n\
                 [[load]]\nforce = {}\nelevation = {}\n",
                frictions[0] * share,
                blocks[0].text(1),
                blocks[1].text(2),
                frictions[1] * share,
                150e3 * factor,
                bed + 0.3
            )
        };
        let Ok(read) = file(&case(1.0, 1.0)).case() else { continue };
        let whole = Assessment::of(&read).unwrap();
        let plane =
            whole.governing().joints.as_ref().unwrap().all_at_once([2.0, 1.5 * frictions[0]]).unwrap();
        for share in [0.11, 0.36, 0.71, 0.99, 1.41] {
            for factor in [0.17, 0.52, 0.93, 1.31, 1.77] {
                // Not next to a boundary, from which a straight piece may be off by a thousandth.
                let at =
                    |factor: f64, share: f64| plane.at(factor, frictions[0] * share).map(<[Mode]>::to_vec);
                let here = at(factor, share);
                let around = [(0.99, 1.0), (1.01, 1.0), (1.0, 0.99), (1.0, 1.01)];
                if around.iter().any(|(one, other)| at(factor * one, share * other) != here) {
                    continue;
                }
                let found = assess(&case(factor, share));
                let modes = found.governing().joints.as_ref().unwrap().modes().unwrap().to_vec();
                assert_eq!(here, Some(modes.clone()), "{}", case(factor, share));
                seen += 1;
                both += usize::from(modes.iter().all(|mode| *mode != Mode::Rest));
            }
        }
    }
    assert!(seen > 60 && both > 5, "{seen} {both}");
}

/// Drums of a column: each joint is a circle, shaken.
#[test]
fn drums_stand_on_circles() {
    let column = "[body]\nshape = \"cylinder\"\nwidth = 1.2\nheight = 6\nmass = 17000\nfriction = 0.7\n\
        [earthquake]\nhorizontal = \"0.15 g\"\nhorizontal_fixed = true\n\
        [[joint]]\nelevation = 2\nfriction = 0.7\n[[joint]]\nelevation = 4\nfriction = 0.7\n";
    let assessment = assess(column);
    let joints = assessment.governing().joints.as_ref().unwrap();
    // The whole turns first: b/d is least at the base.
    assert_eq!(joints.leaves.joints(), [0]);
    six(joints.leaves.load_factor, 0.2 / 0.15);
    six(on(&assessment, 1).outcome.departure.load_factor(), 0.6 / 2.0 / 0.15);
    assert!(number(on(&assessment, 2), ResultName::BearingMax) > 0.0);
}

/// Of more than six bodies it is not known which move under the full load, but for what a sliding base protects: no joint is named that may
/// rest.
#[test]
fn beyond_six_bodies_no_joint_is_said_to_move_that_may_rest() {
    let mut text = String::from("[body]\nwidth = 1\nheight = 7\nmass = 1e4\nfriction = 0.1\n");
    for level in 1..7 {
        text += &format!("[[joint]]\nelevation = {level}\nfriction = 0.9\n");
    }
    text += "[earthquake]\nhorizontal = \"0.3 g\"\nhorizontal_fixed = true\n";
    let case = file(&text).case().unwrap();
    let assessment = Assessment::of(&case).unwrap();
    let whole = assessment.governing();
    let moving = whole.on_joints().filter(|on| on.verdict() != Some(standfast::Verdict::REST)).count();
    assert!(moving > 1, "{moving} joints do not rest while all others do");
    assert!(whole.joints.as_ref().unwrap().modes().is_none());
    assert_eq!(whole.at_once(), "not every joint rests: first joint 1 (base) slides to the left (SL)");
}
