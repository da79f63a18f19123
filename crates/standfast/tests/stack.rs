//! Stacks of bodies: against one body, against closed forms of two, against a complementarity solver, against the laws they stand for.

mod common;

use common::{Random, tries};
use standfast::contact::stack::{Joint, MOST, RestLimit, Shaking, Stack, StackAnswer, StackBody, StackError};
use standfast::contact::{Block, solve};
use standfast::{Corner, Mode, Slip, Wrench};

fn symbols(modes: &[Mode]) -> String {
    modes.iter().map(|mode| mode.symbol()).collect::<Vec<_>>().join("/")
}

fn reported(answer: &StackAnswer) -> String {
    symbols(answer.modes())
}

/// A block of a width and a height whose left end is at `left`.
#[derive(Debug, Clone, Copy)]
struct Brick {
    left: f64,
    width: f64,
    height: f64,
    density: f64,
}

impl Brick {
    fn mass(self) -> f64 {
        self.density * self.width * self.height
    }
}

/// Bricks on each other, with one friction a joint; their weight at g = 1.
fn tower(bricks: &[Brick], friction: &[[f64; 2]], shaking: Shaking) -> Stack {
    let mut stack = Stack { shaking, ..Stack::default() };
    let mut h = 0.0;
    let mut ground = [f64::NEG_INFINITY, f64::INFINITY];
    for (brick, [mu_s, mu_k]) in bricks.iter().zip(friction) {
        let own = [brick.left, brick.left + brick.width];
        let [l, r] = [ground[0].max(own[0]), ground[1].min(own[1])];
        stack.joints.push(Joint { h, l, r, mu_s: *mu_s, mu_k: *mu_k });
        let mass = brick.mass();
        let inertia = mass * (brick.width * brick.width + brick.height * brick.height) / 12.0;
        let (x, y) = (brick.left + brick.width / 2.0, h + brick.height / 2.0);
        stack.bodies.push(StackBody { x, y, ..StackBody::of(mass, inertia) });
        h += brick.height;
        ground = own;
    }
    stack
}

fn still() -> Shaking {
    Shaking { gravity: 1.0, ..Shaking::default() }
}

fn shaken(k: f64) -> Shaking {
    Shaking { horizontal: k, ..still() }
}

/// Any bodies with any loads, in eighths where edges shall be met.
fn random_stack(random: &mut Random, count: usize, ratio: f64) -> Stack {
    let coarse = random.coin();
    let mut number = |low: f64, high: f64| {
        let value = random.uniform(low, high);
        if coarse { (value * 8.0).round() / 8.0 } else { value }
    };
    let (mut bodies, mut joints) = (Vec::new(), Vec::new());
    let mut h = 0.0;
    for _ in 0..count {
        let (half, height) = (number(0.25, 1.5).max(0.25), number(0.25, 2.0).max(0.25));
        let middle = number(-0.5, 0.5);
        let mu_s = number(0.0, 1.2);
        joints.push(Joint { h, l: middle - half, r: middle + half, mu_s, mu_k: mu_s * ratio });
        let mut wrench =
            |down: f64| Wrench { x: number(-1.0, 1.0), p: down + number(-1.0, 1.0), m: number(-1.0, 1.0) };
        let (permanent, variable) = (wrench(1.5), wrench(0.0));
        bodies.push(StackBody {
            m_x: number(0.5, 2.0).max(0.25),
            m_y: number(0.5, 2.0).max(0.25),
            inertia: number(0.25, 1.0).max(0.125),
            x: middle + number(-0.25, 0.25),
            y: h + number(0.25, 0.75) * height,
            permanent,
            variable,
        });
        h += height;
    }
    Stack { bodies, joints, shaking: Shaking::default() }
}

/// The block and the wrench of a stack of one body under a load factor.
fn one_body(stack: &Stack, factor: f64) -> (Block, Wrench) {
    let (body, joint) = (stack.bodies[0], stack.joints[0]);
    let block = Block {
        b1: body.x - joint.l,
        b2: joint.r - body.x,
        d: body.y - joint.h,
        rho2: body.inertia,
        m_x: body.m_x,
        m_y: body.m_y,
        mu_s: joint.mu_s,
        mu_k: joint.mu_k,
    };
    (block, body.permanent + body.variable * factor)
}

#[test]
fn a_stack_of_one_body_is_the_contact_problem() {
    for ratio in [1.0, 0.75, 0.5] {
        let mut random = Random(11);
        for _ in 0..tries(20_000) {
            let mut stack = random_stack(&mut random, 1, ratio);
            // The contact problem has C between its corners.
            stack.bodies[0].x =
                stack.joints[0].l + random.uniform(0.2, 0.8) * (stack.joints[0].r - stack.joints[0].l);
            stack.bodies[0].x = (stack.bodies[0].x * 16.0).round() / 16.0;
            let (block, wrench) = one_body(&stack, 1.0);
            let Ok(expected) = solve(&block, &wrench) else { continue };
            let found = stack.answer(1.0).unwrap();
            let mut modes: Vec<Mode> = found.combinations().iter().map(|one| one.modes[0]).collect();
            modes.sort_by_key(|mode| mode.code());
            let all: Vec<Mode> = expected.modes.iter().collect();
            assert_eq!(modes, all, "{stack:?}");
            assert_eq!(found.modes().first().copied(), expected.mode(), "{stack:?}");
            let Some(mode) = expected.mode() else { continue };
            let (one, other) = (found.motion().unwrap(), expected.motion(mode).unwrap());
            let near = |a: f64, b: f64| assert!((a - b).abs() <= 1e-9 * (1.0 + b.abs()), "{a} {b} {stack:?}");
            near(one.bodies[0].x_ddot, other.x_ddot);
            near(one.bodies[0].y_ddot, other.y_ddot);
            near(one.bodies[0].theta_ddot, other.theta_ddot);
            near(one.joints[0].f, other.f_x);
            near(one.joints[0].n, other.f_y);
            if other.f_y > 1e-6 {
                near(one.joints[0].xi - stack.bodies[0].x, other.xi);
            }
        }
    }
}

/// Inside each stage its modes are consistent, beyond its end they are not; the first ends where the stack leaves rest.
#[test]
fn a_path_keeps_modes_until_they_fail() {
    let mut random = Random(23);
    let mut stages = 0;
    for round in 0..tries(1_500) {
        let count = 1 + (random.bits() % 3) as usize;
        let stack = random_stack(&mut random, count, if round % 2 == 0 { 1.0 } else { 0.8 });
        let path = stack.path().unwrap();
        assert_eq!(path[0].from, 0.0);
        assert_eq!(path.last().unwrap().to, f64::INFINITY, "{stack:?} {path:?}");
        let departure = stack.departure().unwrap();
        if !departure.at_once && departure.load_factor > 0.0 {
            assert!(path[0].modes.iter().all(|mode| *mode == Mode::Rest));
            assert_eq!(path[0].to, departure.load_factor, "{stack:?}");
            if path.len() > 1 {
                assert_eq!(path[1].modes, departure.answer.modes(), "{stack:?}");
            }
        }
        for (stage, next) in path.iter().zip(path.iter().skip(1).map(Some).chain([None])) {
            stages += 1;
            assert!(stage.from < stage.to && next.is_none_or(|next| next.from == stage.to), "{path:?}");
            let holds = |factor: f64| {
                stack.every_combination(factor).unwrap().iter().any(|one| one.modes == stage.modes)
            };
            let inside =
                if stage.to.is_finite() { (stage.from + stage.to) / 2.0 } else { 2.0 * stage.from + 1.0 };
            // Two stages an ulp apart have nothing between them.
            if inside - stage.from > 1e-9 * inside {
                assert!(holds(inside), "{stack:?} {stage:?}");
            }
            if stage.to.is_finite() {
                assert!(!holds(stage.to * (1.0 + 1e-7)), "{stack:?} {stage:?}");
            }
        }
    }
    assert!(stages > tries(1_500), "{stages}");
}

/// X, P and the moment about (0, h) of all above a joint under a load factor.
fn carried(stack: &Stack, joint: usize, factor: f64) -> [f64; 3] {
    let h = stack.joints[joint].h;
    let mut sums = [0.0; 3];
    for body in &stack.bodies[joint..] {
        let Wrench { x, p, m } = body.permanent + body.variable * factor;
        sums[0] += x;
        sums[1] += p;
        sums[2] += m - x * (body.y - h) - p * body.x;
    }
    sums
}

/// How far each limit of a joint is, by hand.
fn reserves(stack: &Stack, joint: usize, factor: f64) -> [f64; 4] {
    let [x, p, g] = carried(stack, joint, factor);
    let Joint { l, r, mu_s, .. } = stack.joints[joint];
    // The reaction acts at −G/P, which has to lie between the corners.
    [mu_s * p + x, mu_s * p - x, -g - l * p, r * p + g]
}

#[test]
fn a_stack_rests_as_each_joint_does_by_itself() {
    let mut random = Random(12);
    let mut seen = [0; 4];
    for _ in 0..tries(8_000) {
        let count = 1 + (random.bits() % 4) as usize;
        let stack = random_stack(&mut random, count, 1.0);
        let departure = stack.departure().unwrap();
        let lowest = |factor: f64| {
            (0..count).flat_map(|joint| reserves(&stack, joint, factor)).fold(f64::INFINITY, f64::min)
        };
        if lowest(0.0) < -1e-9 {
            seen[0] += 1;
            assert!(departure.at_once && departure.load_factor == 0.0, "{stack:?}");
        } else if departure.load_factor == f64::INFINITY {
            seen[1] += 1;
            assert!(lowest(1e6) >= -1e-6 && departure.joints().is_empty(), "{stack:?}");
        } else if departure.load_factor > 0.0 {
            seen[2] += 1;
            let λ = departure.load_factor;
            assert!(lowest(λ * (1.0 - 1e-9)) >= -1e-12 && lowest(λ * (1.0 + 1e-9)) < 1e-12, "{stack:?}");
            for (joint, limit) in &departure.limits {
                let form = RestLimit::ALL.iter().position(|one| one == limit).unwrap();
                assert!(reserves(&stack, *joint, λ)[form].abs() < 1e-9, "{stack:?}");
            }
            if count <= 3 {
                let rests = stack.answer(λ * (1.0 - 1e-12)).unwrap();
                assert!(rests.modes().iter().all(|mode| *mode == Mode::Rest), "{stack:?}");
                let beyond = stack.answer(λ * (1.0 + 1e-9)).unwrap();
                let of = |answer: &StackAnswer| -> Vec<String> {
                    answer.combinations().iter().map(|one| symbols(&one.modes)).collect()
                };
                assert!(
                    of(&beyond).contains(&reported(&departure.answer)),
                    "{stack:?} {:?}",
                    departure.answer
                );
            }
        } else {
            seen[3] += 1;
        }
    }
    assert!(seen.iter().all(|count| *count > 0), "{seen:?}");
}

/// The bodies above a joint as one, at their common centre, and what acts on them under a load factor.
fn glued(stack: &Stack, joint: usize, factor: f64) -> (Block, Wrench) {
    let above = &stack.bodies[joint..];
    let mass: f64 = above.iter().map(|body| body.m_x).sum();
    let mean = |of: fn(&StackBody) -> f64| above.iter().map(|body| body.m_x * of(body)).sum::<f64>() / mass;
    let (x, y) = (mean(|body| body.x), mean(|body| body.y));
    let inertia = |body: &StackBody| body.inertia + body.m_x * ((body.x - x).powi(2) + (body.y - y).powi(2));
    let joint_ = stack.joints[joint];
    let block = Block {
        b1: x - joint_.l,
        b2: joint_.r - x,
        d: y - joint_.h,
        rho2: above.iter().map(inertia).sum::<f64>() / mass,
        m_x: 1.0,
        m_y: 1.0,
        mu_s: joint_.mu_s,
        mu_k: joint_.mu_k,
    };
    let [force, down, about] = carried(stack, joint, factor);
    let moment = about + force * (y - joint_.h) + down * x;
    (block, Wrench { x: force / mass, p: down / mass, m: moment / mass })
}

/// A body of one mass in all directions, as the glued one has a centre then.
fn plain(mut stack: Stack) -> Stack {
    for body in &mut stack.bodies {
        body.m_y = body.m_x;
    }
    stack
}

/// With one friction and one governing joint that goes into the one-body mode of all above it, and the others rest.
#[test]
fn the_joint_that_departs_moves_as_what_is_above_it_does_in_one() {
    let mut random = Random(13);
    let mut tried = 0;
    for _ in 0..tries(10_000) {
        let count = 2 + (random.bits() % 2) as usize;
        let stack = plain(random_stack(&mut random, count, 1.0));
        let departure = stack.departure().unwrap();
        let λ = departure.load_factor;
        if departure.at_once || λ == 0.0 || λ == f64::INFINITY || departure.limits.len() != 1 {
            continue;
        }
        let governs = departure.joints()[0];
        let (block, wrench) = glued(&stack, governs, λ * (1.0 + 1e-7));
        let Ok(expected) = solve(&block, &wrench) else { continue };
        // The others need a margin: without friction a joint that nothing pushes has none.
        let others = (0..count).filter(|joint| *joint != governs);
        let margin = others.flat_map(|joint| reserves(&stack, joint, λ)).fold(f64::INFINITY, f64::min);
        if expected.modes.len() != 1 || !departure.answer.is_unique() || margin < 1e-9 {
            continue;
        }
        tried += 1;
        let modes: Vec<Mode> = (0..count)
            .map(|joint| if joint == governs { expected.mode().unwrap() } else { Mode::Rest })
            .collect();
        assert_eq!(departure.answer.modes(), modes, "{stack:?}");
    }
    assert!(tried > tries(10_000) / 4, "{tried}");
}

/// With one friction the number of combinations is odd, and those of D > 0 are one more than those of D < 0; with less to slip there is one.
#[test]
fn there_is_always_a_combination_and_the_signed_count_is_one() {
    let mut random = Random(14);
    let mut several = 0;
    for _ in 0..tries(40_000) {
        let count = 1 + (random.bits() % 3) as usize;
        // Numbers of all digits: in eighths several coincide on boundaries.
        let mut stack = random_stack(&mut random, count, 1.0);
        for body in &mut stack.bodies {
            body.permanent.x += random.uniform(-1e-3, 1e-3);
            body.permanent.m += random.uniform(-1e-3, 1e-3);
            body.permanent.p += random.uniform(-1e-3, 1e-3);
        }
        for joint in &mut stack.joints {
            joint.mu_s *= 2.0;
            joint.mu_k = joint.mu_s;
        }
        let all = stack.every_combination(1.0).unwrap();
        let signed: i32 = all.iter().map(|one| if one.regular { 1 } else { -1 }).sum();
        assert_eq!(signed, 1, "{stack:?} {all:?}");
        several += u32::from(all.len() > 1);
        for joint in &mut stack.joints {
            joint.mu_k *= 0.7;
        }
        assert!(!stack.answer(1.0).unwrap().modes().is_empty(), "{stack:?}");
    }
    assert!(several > 0);
}

/// What is reported obeys the equations of motion of each body, and Coulomb's law in each joint.
#[test]
fn motions_obey_the_equations_of_each_body() {
    let mut random = Random(15);
    for round in 0..tries(10_000) {
        let count = 1 + (random.bits() % 4) as usize;
        let stack = random_stack(&mut random, count, if round % 2 == 0 { 1.0 } else { 0.7 });
        let answer = stack.answer(1.0).unwrap();
        let motion = answer.motion().unwrap();
        for (place, body) in stack.bodies.iter().enumerate() {
            let mut sum = {
                let Wrench { x, p, m } = body.permanent + body.variable;
                [x, -p, m]
            };
            for (joint, sign) in [(place, 1.0), (place + 1, -1.0)] {
                let (Some(reaction), Some(at)) = (motion.joints.get(joint), stack.joints.get(joint)) else {
                    continue;
                };
                sum[0] += sign * reaction.f;
                sum[1] += sign * reaction.n;
                sum[2] += sign * (reaction.n * (reaction.xi - body.x) - reaction.f * (at.h - body.y));
            }
            let of = motion.bodies[place];
            let inertia = [body.m_x * of.x_ddot, body.m_y * of.y_ddot, body.inertia * of.theta_ddot];
            for (sum, inertia) in sum.into_iter().zip(inertia) {
                assert!((sum - inertia).abs() < 1e-9 * (1.0 + inertia.abs()), "{stack:?} {sum} {inertia}");
            }
        }
        for ((place, joint), mode) in stack.joints.iter().enumerate().zip(answer.modes()) {
            let own = motion.joints[place];
            let below = place.checked_sub(1).map(|below| motion.bodies[below]);
            // The points of both bodies at O, from their centres.
            let gap = |x: f64| {
                let of = |body: &StackBody, motion: standfast::contact::stack::BodyMotion| {
                    [
                        motion.x_ddot - motion.theta_ddot * (joint.h - body.y),
                        motion.y_ddot + motion.theta_ddot * (x - body.x),
                    ]
                };
                let upper = of(&stack.bodies[place], motion.bodies[place]);
                let lower = below.map_or([0.0; 2], |below| of(&stack.bodies[place - 1], below));
                [upper[0] - lower[0], upper[1] - lower[1]]
            };
            let ([t, at_o], [_, at_o_prime]) = (gap(joint.l), gap(joint.r));
            assert!((t - own.t).abs() < 1e-9 && at_o > -1e-9 && at_o_prime > -1e-9, "{stack:?}");
            assert!(own.n > -1e-9 && own.f.abs() <= joint.mu_s * own.n + 1e-9, "{stack:?}");
            if own.n > 1e-6 {
                assert!((joint.l - 1e-6..=joint.r + 1e-6).contains(&own.xi), "{stack:?}");
                if t.abs() > 1e-6 {
                    assert!((own.f + t.signum() * joint.mu_k * own.n).abs() < 1e-9, "{stack:?} {mode}");
                }
            }
        }
    }
}

#[test]
fn mirrored_stacks_have_mirrored_modes() {
    let mut random = Random(16);
    for _ in 0..tries(4_000) {
        let count = 1 + (random.bits() % 3) as usize;
        let stack = random_stack(&mut random, count, 0.8);
        let turned = |wrench: Wrench| Wrench { x: -wrench.x, p: wrench.p, m: -wrench.m };
        let mirror = Stack {
            bodies: stack
                .bodies
                .iter()
                .map(|body| StackBody {
                    x: -body.x,
                    permanent: turned(body.permanent),
                    variable: turned(body.variable),
                    ..*body
                })
                .collect(),
            joints: stack.joints.iter().map(|joint| Joint { l: -joint.r, r: -joint.l, ..*joint }).collect(),
            ..stack.clone()
        };
        let sorted = |answer: &StackAnswer, mirrored: bool| {
            let modes = answer.combinations().iter().map(|one| {
                one.modes
                    .iter()
                    .map(|mode| if mirrored { mode.mirrored() } else { *mode })
                    .collect::<Vec<_>>()
            });
            let mut all: Vec<_> = modes.collect();
            all.sort();
            all
        };
        assert_eq!(sorted(&stack.answer(1.0).unwrap(), true), sorted(&mirror.answer(1.0).unwrap(), false));
        let [one, other] = [&stack, &mirror].map(|stack| stack.departure().unwrap());
        assert_eq!((one.joints(), one.load_factor), (other.joints(), other.load_factor));
    }
}

/// A joint that rests adds nothing: the motion is that of the two bodies as one, where one centre will do.
#[test]
fn a_joint_that_rests_is_glue() {
    let mut random = Random(17);
    let mut tried = 0;
    for _ in 0..tries(10_000) {
        let mut stack = plain(random_stack(&mut random, 2, 1.0));
        // Off all edges: the numbers of the body in one are rounded.
        stack.bodies[0].permanent.x += random.uniform(-1e-3, 1e-3);
        stack.bodies[1].permanent.m += random.uniform(-1e-3, 1e-3);
        let answer = stack.answer(1.0).unwrap();
        if answer.modes().get(1) != Some(&Mode::Rest) || !answer.is_unique() {
            continue;
        }
        let (block, wrench) = glued(&stack, 0, 1.0);
        let Ok(expected) = solve(&block, &wrench) else { continue };
        tried += 1;
        assert!(expected.modes.contains(answer.modes()[0]), "{stack:?}");
        let (one, motion) = (answer.motion().unwrap(), expected.motion(answer.modes()[0]).unwrap());
        for body in &one.bodies {
            assert!((body.theta_ddot - motion.theta_ddot).abs() < 1e-9 * (1.0 + motion.theta_ddot.abs()));
        }
    }
    assert!(tried > 50, "{tried}");
}

/// Stewart and Trinkle's problem at the corners, 0 ≤ z ⊥ Mz + q ≥ 0, by Lemke's pivots; `None` where it ends on a ray.
fn lemke(matrix: &[Vec<f64>], q: &[f64]) -> Option<Vec<f64>> {
    let n = q.len();
    // No two rows come to zero together.
    let covering = |i: usize| 1.0 + 0.37 * ((i as f64 * 1.618_033_988_749_895) % 1.0);
    // Columns: w (n), z (n), z₀, right side.
    let mut rows: Vec<Vec<f64>> = (0..n)
        .map(|i| {
            let mut row = vec![0.0; 2 * n + 2];
            row[i] = 1.0;
            for j in 0..n {
                row[n + j] = -matrix[i][j];
            }
            row[2 * n] = -covering(i);
            row[2 * n + 1] = q[i];
            row
        })
        .collect();
    let mut basis: Vec<usize> = (0..n).collect();
    let least = (0..n).min_by(|a, b| (q[*a] / covering(*a)).total_cmp(&(q[*b] / covering(*b))))?;
    if q[least] >= 0.0 {
        return Some(vec![0.0; n]);
    }
    let pivot = |rows: &mut Vec<Vec<f64>>, row: usize, column: usize| {
        let by = rows[row][column];
        rows[row].iter_mut().for_each(|value| *value /= by);
        let own = rows[row].clone();
        for (other, values) in rows.iter_mut().enumerate() {
            if other != row {
                let by = values[column];
                values.iter_mut().zip(&own).for_each(|(value, own)| *value -= by * own);
            }
        }
    };
    pivot(&mut rows, least, 2 * n);
    let mut entering = n + least;
    basis[least] = 2 * n;
    for _ in 0..500 {
        let candidates = (0..n).filter(|row| rows[*row][entering] > 1e-11);
        let row = candidates.min_by(|a, b| {
            let ratio = |row: usize| rows[row][2 * n + 1] / rows[row][entering];
            // The artificial variable leaves first where it may.
            ratio(*a).total_cmp(&ratio(*b)).then((basis[*b] == 2 * n).cmp(&(basis[*a] == 2 * n)))
        })?;
        pivot(&mut rows, row, entering);
        let leaving = std::mem::replace(&mut basis[row], entering);
        if leaving == 2 * n {
            let mut z = vec![0.0; n];
            for (row, variable) in basis.iter().enumerate() {
                if (n..2 * n).contains(variable) {
                    z[variable - n] = rows[row][2 * n + 1];
                }
            }
            return Some(z);
        }
        entering = if leaving < n { leaving + n } else { leaving - n };
    }
    None
}

/// The accelerations of the bodies by complementarity: normal reactions at the corners, one friction a joint.
fn by_complementarity(stack: &Stack, factor: f64) -> Option<Vec<[f64; 3]>> {
    let n = stack.bodies.len();
    // The acceleration of a gap at x, and of the slip, by those of the bodies.
    let row = |place: usize, x: Option<f64>| {
        let mut row = vec![0.0; 3 * n];
        for (body, sign) in [(Some(place), 1.0), (place.checked_sub(1), -1.0)] {
            let Some(body) = body else { continue };
            let of = stack.bodies[body];
            match x {
                Some(x) => {
                    row[3 * body + 1] += sign;
                    row[3 * body + 2] += sign * (x - of.x);
                }
                None => {
                    row[3 * body] += sign;
                    row[3 * body + 2] -= sign * (stack.joints[place].h - of.y);
                }
            }
        }
        row
    };
    let gaps = stack
        .joints
        .iter()
        .enumerate()
        .flat_map(|(place, joint)| [joint.l, joint.r].map(|x| row(place, Some(x))));
    let slips: Vec<Vec<f64>> = (0..n).map(|place| row(place, None)).collect();
    let back = slips.iter().map(|row| row.iter().map(|value| -value).collect());
    let directions: Vec<Vec<f64>> = gaps.chain(slips.iter().cloned()).chain(back).collect();
    let masses: Vec<f64> = stack.bodies.iter().flat_map(|body| [body.m_x, body.m_y, body.inertia]).collect();
    let loads: Vec<f64> = stack
        .bodies
        .iter()
        .flat_map(|body| {
            let Wrench { x, p, m } = body.permanent + body.variable * factor;
            [x, -p, m]
        })
        .collect();
    // z: two normals a joint (2n), friction to the right (n), to the left (n), slack (n).
    let mut matrix = vec![vec![0.0; 5 * n]; 5 * n];
    let mut q = vec![0.0; 5 * n];
    for (i, own) in directions.iter().enumerate() {
        q[i] = (0..3 * n).map(|k| own[k] * loads[k] / masses[k]).sum();
        for (j, other) in directions.iter().enumerate() {
            matrix[i][j] = (0..3 * n).map(|k| own[k] * other[k] / masses[k]).sum();
        }
        if i >= 2 * n {
            matrix[i][4 * n + i % n] = 1.0;
        }
    }
    for (i, joint) in stack.joints.iter().enumerate() {
        let cone = &mut matrix[4 * n + i];
        cone[2 * i] = joint.mu_k;
        cone[2 * i + 1] = joint.mu_k;
        cone[2 * n + i] = -1.0;
        cone[3 * n + i] = -1.0;
    }
    let z = lemke(&matrix, &q)?;
    let accelerations = (0..3 * n).map(|k| {
        let reaction: f64 = directions.iter().zip(&z).map(|(direction, z)| direction[k] * z).sum();
        (loads[k] + reaction) / masses[k]
    });
    let all: Vec<f64> = accelerations.collect();
    Some(all.chunks(3).map(|three| [three[0], three[1], three[2]]).collect())
}

#[test]
fn a_complementarity_solver_finds_one_of_the_motions() {
    let mut random = Random(18);
    let (mut agree, mut given_up) = (0, 0);
    for _ in 0..tries(6_000) {
        let count = 1 + (random.bits() % 3) as usize;
        let mut stack = random_stack(&mut random, count, 1.0);
        // Numbers of all digits: ties stop the pivots.
        for body in &mut stack.bodies {
            body.permanent.x += random.uniform(-1e-2, 1e-2);
            body.permanent.m += random.uniform(-1e-2, 1e-2);
        }
        let answer = stack.answer(1.0).unwrap();
        if !answer.is_unique() {
            continue;
        }
        let Some(found) = by_complementarity(&stack, 1.0) else {
            given_up += 1;
            continue;
        };
        let bodies = &answer.motion().unwrap().bodies;
        let near = bodies.iter().zip(&found).all(|(one, [x, y, θ])| {
            let near = |a: f64, b: &f64| (a - b).abs() < 1e-7 * (1.0 + b.abs());
            near(one.x_ddot, x) && near(one.y_ddot, y) && near(one.theta_ddot, θ)
        });
        assert!(near, "{stack:?}\n{:?}\n{bodies:?}\n{found:?}", answer.modes());
        agree += 1;
    }
    assert!(agree > 20 * given_up, "{agree} agree, {given_up} given up");
}

/// Two bricks, the upper in the middle of the lower.
fn pair(random: &mut Random) -> [Brick; 2] {
    let brick = |width: f64, height: f64, density: f64| Brick { left: -width / 2.0, width, height, density };
    let width = random.uniform(0.5, 3.0);
    [
        brick(width, random.uniform(0.3, 2.0), random.uniform(0.5, 2.0)),
        brick(width * random.uniform(0.2, 1.0), random.uniform(0.3, 3.0), random.uniform(0.5, 2.0)),
    ]
}

fn both(μ1: f64, μ2: f64) -> [[f64; 2]; 2] {
    [[μ1; 2], [μ2; 2]]
}

/// The closed forms of two bodies under a base acceleration.
#[test]
fn two_bodies_on_a_shaken_base() {
    let mut random = Random(19);
    let mut seen = std::collections::BTreeSet::new();
    for _ in 0..tries(3_000) {
        let bricks = pair(&mut random);
        let (μ1, μ2, k) = (random.uniform(0.05, 1.0), random.uniform(0.05, 1.0), random.uniform(0.05, 2.0));
        let stack = tower(&bricks, &both(μ1, μ2), shaken(k));
        let [m1, m2] = bricks.map(Brick::mass);
        let m = m1 + m2;
        let (b, d) = (bricks[1].width / 2.0, bricks[1].height / 2.0);
        let common = (m1 * bricks[0].height / 2.0 + m2 * (bricks[0].height + d)) / m;
        let below = bricks[0].width / 2.0 / common;
        let answer = stack.answer(1.0).unwrap();
        if !answer.is_unique() {
            continue;
        }
        let found = reported(&answer);
        let rests = k <= [μ1, μ2, b / d, below].into_iter().fold(f64::INFINITY, f64::min);
        let carried = μ1 < k && μ1 <= [μ2, b / d, below].into_iter().fold(f64::INFINITY, f64::min);
        // The push of the inertia is to the left.
        assert_eq!(found == "RE/RE", rests, "{stack:?} {found}");
        assert_eq!(found == "SL/RE", carried && !rests, "{stack:?} {found}");
        if found == "RE/SL" {
            assert!(k > μ2 && k * m1 + μ2 * m2 <= μ1 * m + 1e-12, "{stack:?}");
        }
        // The upper rocks on a sliding lower.
        let inertia = m2 * (bricks[1].width.powi(2) + bricks[1].height.powi(2)) / 12.0;
        let j2 = inertia + m2 * (b * b + d * d);
        let reduced = m * j2 - m2 * m2 * d * (d + μ1 * b);
        let α = m2 * m * (μ1 * d - b) / reduced;
        let k_c = μ1 + m2 * (d + μ1 * b) * α / m;
        if found == "SL/RO" {
            assert!(μ1 * d > b && k > k_c, "{stack:?}");
            let θ = answer.motion().unwrap().bodies[1].theta_ddot;
            assert!((θ - α).abs() < 1e-9 * α.abs().max(1.0), "{stack:?}: {θ} {α}");
        }
        if found == "RE/RO" {
            assert!(k > b / d && k <= k_c.max(b / d) + 1e-9 || μ1 * d <= b, "{stack:?}");
        }
        seen.insert(found);
    }
    for known in ["RE/RE", "SL/RE", "RE/SL", "SL/SL", "RE/RO", "SL/RO"] {
        assert!(seen.contains(known), "{known}: {seen:?}");
    }
}

/// The closed forms of a force on the lower and on the upper of two bodies, which does not turn them.
#[test]
fn two_bodies_under_a_force() {
    let mut random = Random(20);
    for _ in 0..tries(2_000) {
        let bricks = pair(&mut random);
        let (μ1, μ2) = (random.uniform(0.02, 0.3), random.uniform(0.02, 0.3));
        let [m1, m2] = bricks.map(Brick::mass);
        let m = m1 + m2;
        let mut stack = tower(&bricks, &both(μ1, μ2), still());
        // So flat that nothing turns.
        for (place, body) in stack.bodies.iter_mut().enumerate() {
            body.y = stack.joints[place].h + 1e-3;
        }
        stack.joints[1].h = 2e-3;
        stack.bodies[1].y = 3e-3;
        let with = |place: usize, force: f64| {
            let mut stack = stack.clone();
            stack.bodies[place].variable.x = force;
            reported(&stack.answer(1.0).unwrap())
        };
        let lower = |force: f64| with(0, force);
        assert_eq!(lower(μ1 * m * 0.999), "RE/RE");
        assert_eq!(lower(μ1 * m * 1.001), "SL+/RE");
        assert_eq!(lower((μ1 + μ2) * m * 0.999), "SL+/RE");
        // The lower is pulled from under the upper, which slides to the left on it.
        assert_eq!(lower((μ1 + μ2) * m * 1.001), "SL+/SL");
        let upper = |force: f64| with(1, -force);
        if μ2 * m2 <= μ1 * m {
            assert_eq!(upper(μ2 * m2 * 0.999), "RE/RE");
            assert_eq!(upper(μ2 * m2 * 1.001), "RE/SL");
        } else {
            let both = (μ2 - μ1) * m * m2 / m1;
            assert_eq!(upper(μ1 * m * 0.999), "RE/RE");
            if both > μ1 * m * 1.01 {
                assert_eq!(upper(μ1 * m * 1.001), "SL/RE");
                assert_eq!(upper(both * 0.999), "SL/RE");
            }
            assert_eq!(upper(both.max(μ1 * m) * 1.001), "SL/SL");
        }
    }
}

/// Equal friction under an earthquake ties all joints at every load: the lowest slides, and carries all above.
#[test]
fn equal_friction_is_a_tie_that_no_rounding_breaks() {
    let mut random = Random(21);
    for _ in 0..tries(500) {
        let count = 2 + (random.bits() % 2) as usize;
        let μ = random.uniform(0.1, 0.4);
        let mut width = random.uniform(2.0, 4.0);
        let bricks: Vec<Brick> = (0..count)
            .map(|_| {
                width *= random.uniform(0.7, 1.0);
                Brick { left: -width / 2.0, width, height: random.uniform(0.2, 0.6), density: 1.0 }
            })
            .collect();
        let shaking = Shaking {
            gravity: 9.81,
            vertical: random.uniform(-0.3, 0.3),
            ..shaken(random.uniform(0.6, 1.5))
        };
        let stack = tower(&bricks, &vec![[μ; 2]; count], shaking);
        let expected = vec!["RE"; count - 1].join("/");
        let departure = stack.departure().unwrap();
        assert_eq!(departure.joints(), (0..count).collect::<Vec<_>>(), "{stack:?}");
        assert_eq!(reported(&departure.answer), format!("SL/{expected}"), "{stack:?}");
        let answer = stack.answer(1.0).unwrap();
        assert!(answer.is_unique(), "{stack:?} {answer:?}");
        assert_eq!(reported(&answer), format!("SL/{expected}"), "{stack:?}");
    }
}

/// Six cubes, of which some upper parts have an orientation of zero: what is below them is solved in full.
#[test]
fn an_upper_part_of_orientation_zero_hides_nothing() {
    let cube = Brick { left: -1.0, width: 2.0, height: 2.0, density: 0.25 };
    let stack = tower(&[cube; 6], &[[0.5; 2]; 6], shaken(0.05));
    let answer = stack.answer(1.0).unwrap();
    assert_eq!((reported(&answer).as_str(), answer.is_unique()), ("RE/RE/RE/RE/RE/RE", true));
    let departure = stack.departure().unwrap();
    assert_eq!(departure.limits, [(0, RestLimit::Turns(Corner::O))]);
    assert_eq!(reported(&departure.answer), "RO/RE/RE/RE/RE/RE");
    assert!((departure.load_factor - 1.0 / 6.0 / 0.05).abs() < 1e-12);
}

/// Where μ_k < μ_s a joint above or below may begin together with the one that slips; the two cases of the theory.
#[test]
fn a_slip_that_is_let_go_starts_others() {
    let brick = |width: f64, height: f64| Brick { left: -width / 2.0, width, height, density: 1.0 };
    let mut stack = tower(&[brick(2.0, 0.5), brick(0.2, 1.0)], &[[0.6, 0.2], [0.6, 0.6]], still());
    stack.bodies[0].variable.x = 1.0;
    let departure = stack.departure().unwrap();
    assert_eq!(departure.joints(), [0]);
    assert!((departure.load_factor - 0.72).abs() < 1e-12, "{}", departure.load_factor);
    // The base slips to the right, and the upper rocks back: about its left corner.
    assert_eq!(reported(&departure.answer), "SL+/RO");
    let mut stack = tower(&[brick(2.0, 0.5), brick(1.0, 0.5)], &[[0.4, 0.38], [0.7, 0.2]], still());
    stack.bodies[0].variable.x = 0.9;
    stack.bodies[1].variable.x = -0.4;
    let answer = stack.departure().unwrap().answer;
    assert_eq!(reported(&answer), "SL+/SL");
}

/// Where friction would hold every slide that is left, none is struck for that: there would be no answer.
#[test]
fn a_race_of_two_slides_keeps_its_answer() {
    let wrench = |x: f64, p: f64, m: f64| Wrench { x, p, m };
    let body = |mass: f64, inertia: f64, [x, y]: [f64; 2], permanent: Wrench, variable: Wrench| StackBody {
        x,
        y,
        permanent,
        variable,
        ..StackBody::of(mass, inertia)
    };
    let lower = body(
        3.872721370543261,
        2.826128611409891,
        [-0.09865636130607708, 0.7913507726449593],
        wrench(0.0, -0.1466953672307793, 0.0),
        wrench(-3.5928656570086765, -0.1447365822690095, -1.4910758983153087),
    );
    let upper = body(
        2.6735430419225614,
        1.767270302353964,
        [-0.049067010999841676, 2.6344998346662845],
        wrench(0.09098352882277157, 0.0800797874292857, -0.1334546539078979),
        wrench(3.901558586993857, 0.3051547173355469, 0.4404583739105519),
    );
    let stack = Stack {
        bodies: vec![lower, upper],
        joints: vec![
            Joint {
                h: 0.0,
                l: -0.768203092559291,
                r: 1.1034219537420116,
                mu_s: 0.40143222749280083,
                mu_k: 0.3587958443244125,
            },
            Joint {
                h: 1.8727542592732733,
                l: -1.2132726943754868,
                r: 0.9967804014143281,
                mu_s: 0.967522482017145,
                mu_k: 0.2027885349174418,
            },
        ],
        shaking: Shaking { gravity: 0.9848745993710752, ..Shaking::default() },
    };
    assert_eq!(reported(&stack.answer(1.0).unwrap()), "SL/SL+");
}

/// Ties of other kinds are decided as they come: two cubes whose joints both turn at one load.
#[test]
fn two_joints_that_turn_at_one_load() {
    let cube = Brick { left: -0.5, width: 1.0, height: 1.0, density: 1.0 };
    let mut stack = tower(&[cube, cube], &both(2.0, 2.0), still());
    // A force F at the crest turns the upper at F = 1/2, and both, of weight 2 and height 2, at F = 1/2.
    stack.bodies[1].variable = Wrench { x: -1.0, p: 0.0, m: 0.5 };
    let departure = stack.departure().unwrap();
    assert_eq!((departure.load_factor, departure.joints().as_slice()), (0.5, [0, 1].as_slice()));
    assert_eq!(departure.limits, [(0, RestLimit::Turns(Corner::O)), (1, RestLimit::Turns(Corner::O))]);
    assert_eq!(reported(&departure.answer), "RO/RO");
}

/// Above Painlevé's bound, three answers: the case of the theory.
#[test]
fn pushes_at_the_foot_of_two_cubes_have_three_answers() {
    let cube = Brick { left: -0.5, width: 1.0, height: 1.0, density: 1.0 };
    let mut stack = tower(&[cube, cube], &both(1.0, 1.0), still());
    stack.bodies[0].permanent = Wrench { x: -1.02, p: 0.0, m: -1.0025 };
    stack.bodies[1].permanent = Wrench { x: -1.04, p: 0.0, m: 0.0 };
    let all = stack.every_combination(1.0).unwrap();
    let mut found: Vec<_> = all.iter().map(|one| (symbols(&one.modes), one.regular)).collect();
    found.sort();
    let expected = [("RO/RE", true), ("SL/SL", true), ("SRO-/SL", false)];
    assert_eq!(found, expected.map(|(modes, regular)| (modes.to_owned(), regular)));
    assert_eq!(reported(&stack.answer(1.0).unwrap()), "SL/SL");
}

/// The bound falls with the number of equal blocks: (ρ² + b²)/(n b d), where slide-rock at the ground with a slide above loses its sign.
#[test]
fn painlevés_bound_falls_with_the_number_of_bodies() {
    for count in [1, 2, 3] {
        for slenderness in [0.5, 1.0, 2.0] {
            let brick = Brick { left: -0.5, width: 1.0, height: slenderness, density: 1.0 };
            let (b, d) = (0.5, slenderness / 2.0);
            let bound = ((b * b + d * d) / 3.0 + b * b) / (f64::from(count) * b * d);
            let orientation = |μ: f64| {
                let friction = vec![[μ; 2]; count as usize];
                let stack = tower(&vec![brick; count as usize], &friction, still());
                let mut modes = vec![Mode::SlideLeft; count as usize];
                modes[0] = Mode::SlideRockOLeft;
                stack.orientation(&modes).unwrap()
            };
            assert!(orientation(bound * (1.0 - 1e-9)) > 0.0 && orientation(bound * (1.0 + 1e-9)) < 0.0);
        }
    }
}

#[test]
fn what_is_no_stack_is_refused() {
    let brick = Brick { left: -0.5, width: 1.0, height: 1.0, density: 1.0 };
    let good = tower(&[brick, brick], &both(0.5, 0.5), still());
    let refused = |change: fn(&mut Stack)| {
        let mut stack = good.clone();
        change(&mut stack);
        stack.answer(1.0).unwrap_err().to_string()
    };
    let said = [
        (refused(|stack| stack.joints.truncate(1)), "bodies: 2, joints: 1"),
        (refused(|stack| stack.bodies[1].m_x = 0.0), "body 2: inertia m_x is 0"),
        (
            refused(|stack| stack.joints[1].r = -1.0),
            "joint 2: right end r of the joint is -1; expected one beyond",
        ),
        (refused(|stack| stack.joints[0].mu_k = 0.6), "joint 1: static friction mu_s is 0.5"),
        (
            refused(|stack| stack.bodies[0].variable.x = f64::NAN),
            "body 1, variable load: horizontal force x is NaN",
        ),
        (refused(|stack| stack.shaking.gravity = -1.0), "gravity: gravity is -1"),
        (
            refused(|stack| stack.joints[1].h = 0.0),
            "joint 2 is at 0, and joint 1 below it at 0; expected bodies and joints from the",
        ),
        (refused(|stack| stack.joints[1].mu_s = f64::NAN), "joint 2: static friction mu_s is NaN"),
        (
            refused(|stack| stack.shaking = Shaking { horizontal: 0.3, ..Shaking::default() }),
            "horizontal is 0.3, in g, and gravity is 0",
        ),
    ];
    for (said, expected) in said {
        assert!(said.contains(expected), "{said}");
    }
    assert!(good.answer(f64::INFINITY).is_err());
    assert_eq!(good.orientation(&[Mode::Rest]), Err(StackError::Modes { modes: 1, joints: 2 }));
    assert!(matches!(Stack::default().departure(), Err(StackError::Count { bodies: 0, joints: 0 })));
    let high = tower(&[brick; MOST + 1], &[[0.5; 2]; MOST + 1], shaken(0.3));
    assert_eq!(high.answer(1.0), Err(StackError::TooMany(MOST + 1)));
    // Its departure is known, its modes are not.
    let departure = high.departure().unwrap();
    assert_eq!(departure.limits, [(0, RestLimit::Turns(Corner::O))]);
    assert!((departure.load_factor - 1.0 / 7.0 / 0.3).abs() < 1e-12 && departure.answer.modes().is_empty());
    assert_eq!(RestLimit::ALL[0], RestLimit::Slides(Slip::Left));
}

/// The motion (t, v, ω) and the reaction (f, N, G) of each joint in a combination, and D, by elimination in the 3n equations of the bodies' own
/// coordinates with the reactions as unknowns: no coordinates of joints, no recursion.
struct Full {
    motions: Vec<[f64; 3]>,
    reactions: Vec<[f64; 3]>,
    determinant: f64,
}

fn solved_in_full(stack: &Stack, factor: f64, modes: &[Mode]) -> Option<Full> {
    let n = modes.len();
    // Unknowns: accelerations of the centres (3n), then reactions f, N, G of the joints (3n).
    let mut rows: Vec<Vec<f64>> = Vec::new();
    let mut row = |terms: &[(usize, f64)], right: f64| {
        let mut row = vec![0.0; 6 * n + 1];
        terms.iter().for_each(|(place, value)| row[*place] += value);
        row[6 * n] = right;
        rows.push(row);
    };
    let reaction = |joint: usize, part: usize| 3 * n + 3 * joint + part;
    for (j, body) in stack.bodies.iter().enumerate() {
        let Wrench { x, p, m } = body.permanent + body.variable * factor;
        let mut sums =
            [vec![(3 * j, body.m_x)], vec![(3 * j + 1, body.m_y)], vec![(3 * j + 2, body.inertia)]];
        for (joint, sign) in [(j, -1.0), (j + 1, 1.0)] {
            if joint < n {
                sums[0].push((reaction(joint, 0), sign));
                sums[1].push((reaction(joint, 1), sign));
                // About the centre: G − x N + (y − h) f.
                sums[2].push((reaction(joint, 2), sign));
                sums[2].push((reaction(joint, 1), -sign * body.x));
                sums[2].push((reaction(joint, 0), sign * (body.y - stack.joints[joint].h)));
            }
        }
        for (terms, load) in sums.iter().zip([x, -p, m]) {
            row(terms, load);
        }
    }
    // Of (0, h) on a body: right ẍ − ω (h − y), up ÿ − ω x.
    let relative = |joint: usize, part: usize| -> Vec<(usize, f64)> {
        let mut terms = Vec::new();
        for (body, sign) in [(Some(joint), 1.0), (joint.checked_sub(1), -1.0)] {
            let Some(j) = body else { continue };
            let of = stack.bodies[j];
            match part {
                0 => terms.extend([(3 * j, sign), (3 * j + 2, -sign * (stack.joints[joint].h - of.y))]),
                1 => terms.extend([(3 * j + 1, sign), (3 * j + 2, -sign * of.x)]),
                _ => terms.push((3 * j + 2, sign)),
            }
        }
        terms
    };
    for (place, (mode, joint)) in modes.iter().zip(&stack.joints).enumerate() {
        let [f, normal, g] = [0, 1, 2].map(|part| reaction(place, part));
        let end = |corner: Corner| if corner == Corner::O { joint.l } else { joint.r };
        let slips = |slip: Slip| [(f, 1.0), (normal, slip.sign() * joint.mu_k)];
        // Nothing lifts at the corner: v + cω = 0.
        let closed = |corner: Corner| {
            let turns = relative(place, 2).into_iter().map(|(k, value)| (k, value * end(corner)));
            relative(place, 1).into_iter().chain(turns).collect::<Vec<_>>()
        };
        match (*mode, mode.corner(), mode.slip()) {
            (Mode::Flight, ..) => [f, normal, g].into_iter().for_each(|k| row(&[(k, 1.0)], 0.0)),
            (_, None, slip) => {
                match slip {
                    Some(slip) => row(&slips(slip), 0.0),
                    None => row(&relative(place, 0), 0.0),
                }
                row(&relative(place, 1), 0.0);
                row(&relative(place, 2), 0.0);
            }
            (_, Some(corner), slip) => {
                match slip {
                    Some(slip) => row(&slips(slip), 0.0),
                    None => row(&relative(place, 0), 0.0),
                }
                row(&closed(corner), 0.0);
                row(&[(g, 1.0), (normal, -end(corner))], 0.0);
            }
        }
    }
    let count = 6 * n;
    for column in 0..count {
        let pivot =
            (column..count).max_by(|a, b| rows[*a][column].abs().total_cmp(&rows[*b][column].abs()))?;
        if rows[pivot][column].abs() < 1e-11 {
            return None;
        }
        rows.swap(column, pivot);
        let own = rows[column].clone();
        for (other, values) in rows.iter_mut().enumerate() {
            let by = values[column] / own[column];
            if other != column && by != 0.0 {
                values.iter_mut().zip(&own).for_each(|(value, own)| *value -= by * own);
            }
        }
    }
    let value = |k: usize| rows[k][count] / rows[k][k];
    let sum = |terms: Vec<(usize, f64)>| terms.into_iter().map(|(k, by)| by * value(k)).sum::<f64>();
    Some(Full {
        motions: (0..n).map(|joint| [0, 1, 2].map(|part| sum(relative(joint, part)))).collect(),
        reactions: (0..n).map(|joint| [0, 1, 2].map(|part| value(reaction(joint, part)))).collect(),
        determinant: stack.orientation(modes).unwrap(),
    })
}

/// The conditions of a joint: none below zero, and the strict ones above.
fn conditions_of(joint: &Joint, mode: Mode, [t, v, ω]: [f64; 3], [f, n, g]: [f64; 3]) -> Vec<f64> {
    let holds = [joint.mu_s * n - f, joint.mu_s * n + f];
    let on_joint = [g - joint.l * n, joint.r * n - g];
    let lifts = |corner: Corner| if corner == Corner::O { ω } else { -ω };
    match (mode, mode.corner(), mode.slip()) {
        (Mode::Flight, ..) => vec![v + joint.l * ω, v + joint.r * ω],
        (_, None, None) => [holds, on_joint].concat(),
        (_, None, Some(slip)) => vec![slip.sign() * t, on_joint[0], on_joint[1]],
        (_, Some(corner), None) => vec![lifts(corner), n, holds[0], holds[1]],
        (_, Some(corner), Some(slip)) => vec![lifts(corner), n, slip.sign() * t],
    }
}

/// All combinations of so many joints.
fn all_combinations(count: usize) -> Vec<Vec<Mode>> {
    (0..10usize.pow(count as u32))
        .map(|number| (0..count).map(|joint| Mode::ALL[number / 10usize.pow(joint as u32) % 10]).collect())
        .collect()
}

/// Stick before slip, as the module says it, on what is found in full; and whether its second rule struck one.
fn left_over(stack: &Stack, found: &[Vec<Mode>]) -> (Vec<Vec<Mode>>, bool) {
    let better = |joint: usize| stack.joints[joint].mu_s > stack.joints[joint].mu_k;
    let beaten = |one: &[Mode], other: &[Mode]| {
        let joints = 0..one.len();
        let fewer = joints.clone().all(|j| other[j].slip().is_none() || other[j] == one[j]);
        let sticks = |j: usize| match (one[j], other[j]) {
            (slide, Mode::Rest | Mode::RockO | Mode::RockOPrime) if slide.corner().is_none() => {
                slide.slip().is_some()
            }
            (slip, Mode::Rest) => slip.slip().is_some(),
            (slip, Mode::RockO) => slip.slip().is_some() && slip.corner() == Some(Corner::O),
            (slip, Mode::RockOPrime) => slip.slip().is_some() && slip.corner() == Some(Corner::OPrime),
            _ => false,
        };
        fewer && joints.clone().any(|j| better(j) && sticks(j))
    };
    let left: Vec<Vec<Mode>> =
        found.iter().filter(|one| !found.iter().any(|other| beaten(one, other))).cloned().collect();
    let would_stick = |one: &Vec<Mode>| {
        (0..one.len()).any(|j| {
            let slides = matches!(one[j], Mode::SlideLeft | Mode::SlideRight) && better(j);
            let mut held = one.clone();
            held[j] = Mode::Rest;
            slides
                && solved_in_full(stack, 1.0, &held).is_some_and(|full| {
                    let [f, n, _] = full.reactions[j];
                    f.abs() <= stack.joints[j].mu_s * n
                })
        })
    };
    let kept: Vec<Vec<Mode>> = left.iter().filter(|one| !would_stick(one)).cloned().collect();
    let struck = !kept.is_empty() && kept.len() < left.len();
    (if kept.is_empty() { left } else { kept }, struck)
}

/// Every combination that the 6n equations of bodies and reactions make consistent is found, with its motion, and no other; and of these
/// those are kept that stick before slip leaves.
#[test]
fn all_combinations_are_those_of_the_equations_in_full() {
    let mut random = Random(22);
    let (mut several, mut by_the_second_rule) = (0, 0);
    for round in 0..tries(1_500).max(1_200) {
        let count = if round % 10 == 0 { 3 } else { 2 };
        let ratio = random.pick(&[1.0, 0.7, 0.5, 0.3]);
        let mut stack = random_stack(&mut random, count, ratio);
        // Frictions up to 3, off all edges.
        for joint in &mut stack.joints {
            joint.mu_s = joint.mu_s * random.uniform(1.0, 2.5) + 0.01;
            joint.mu_k = joint.mu_s * ratio;
        }
        for body in &mut stack.bodies {
            body.permanent.x += random.uniform(-1e-2, 1e-2);
            body.permanent.m += random.uniform(-1e-2, 1e-2);
        }
        let mut near = false;
        let found: Vec<Vec<Mode>> = all_combinations(count)
            .into_iter()
            .filter(|modes| {
                let Some(full) = solved_in_full(&stack, 1.0, modes) else { return false };
                let joints = stack.joints.iter().zip(modes).zip(full.motions.iter().zip(&full.reactions));
                let least = joints
                    .flat_map(|((joint, mode), (motion, reaction))| {
                        conditions_of(joint, *mode, *motion, *reaction)
                    })
                    .fold(f64::INFINITY, f64::min);
                near |= least.abs() < 1e-9;
                least > 0.0
            })
            .collect();
        if near {
            continue;
        }
        let modes = |all: &[standfast::contact::stack::Combination]| {
            let mut all: Vec<Vec<Mode>> = all.iter().map(|one| one.modes.clone()).collect();
            all.sort();
            all
        };
        let mut expected = found.clone();
        expected.sort();
        let every = stack.every_combination(1.0).unwrap();
        assert_eq!(modes(&every), expected, "{stack:?}");
        for one in &every {
            let full = solved_in_full(&stack, 1.0, &one.modes).unwrap();
            assert_eq!(one.regular, full.determinant > 0.0, "{stack:?}");
        }
        let answer = stack.answer(1.0).unwrap();
        let (mut expected, struck) = left_over(&stack, &found);
        expected.sort();
        assert_eq!(modes(answer.combinations()), expected, "{stack:?}");
        let full = solved_in_full(&stack, 1.0, answer.modes()).unwrap();
        for (joint, (motion, reaction)) in
            answer.motion().unwrap().joints.iter().zip(full.motions.iter().zip(&full.reactions))
        {
            let pairs = [
                (joint.t, motion[0]),
                (joint.v, motion[1]),
                (joint.omega, motion[2]),
                (joint.f, reaction[0]),
                (joint.n, reaction[1]),
            ];
            assert!(pairs.iter().all(|(a, b)| (a - b).abs() < 1e-7 * (1.0 + b.abs())), "{stack:?} {pairs:?}");
        }
        several += u32::from(every.len() > 1);
        by_the_second_rule += u32::from(struck);
    }
    assert!(several > 50 && by_the_second_rule > 5, "{several} {by_the_second_rule}");
}
