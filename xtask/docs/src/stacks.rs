//! Figures of stacks: k–μ planes of two bodies, with their boundaries in closed form.

use std::io;

use standfast::Wrench;
use standfast::contact::stack::plane::plane;
use standfast::contact::stack::{Joint, Shaking, Stack, StackBody};
use standfast_figures::{Figure, StackMap, stack_map};

/// A brick of density 1 on the middle of what is below: width and height.
type Brick = [f64; 2];

/// Bricks on each other with one friction, at g = 1.
fn tower(bricks: &[Brick], friction: f64, horizontal: f64) -> Stack {
    let mut stack =
        Stack { shaking: Shaking { gravity: 1.0, horizontal, ..Shaking::default() }, ..Stack::default() };
    let (mut h, mut below) = (0.0, f64::INFINITY);
    for [width, height] in bricks {
        let half = below.min(width / 2.0);
        stack.joints.push(Joint { h, l: -half, r: half, mu_s: friction, mu_k: friction });
        let mass = width * height;
        let inertia = mass * (width * width + height * height) / 12.0;
        stack.bodies.push(StackBody { y: h + height / 2.0, ..StackBody::of(mass, inertia) });
        (h, below) = (h + height, width / 2.0);
    }
    stack
}

/// A force of so many weights of all to the left, at the centre of a body.
fn pushed(bricks: &[Brick], friction: f64, body: usize, force: f64) -> Stack {
    let mut stack = tower(bricks, friction, 0.0);
    let weight: f64 = bricks.iter().map(|[width, height]| width * height).sum();
    stack.bodies[body].variable = Wrench { x: -force * weight, p: 0.0, m: 0.0 };
    stack
}

/// A curve through its values at even steps.
fn curve(from: f64, to: f64, mu: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
    (0..=100).map(|step| from + (to - from) * f64::from(step) / 100.0).map(|k| (k, mu(k))).collect()
}

/// A plane, its boundaries in closed form, and its words: title, name across, name upwards.
struct Plane {
    file: &'static str,
    words: [&'static str; 3],
    window: [f64; 2],
    curves: Vec<Vec<(f64, f64)>>,
    stack: Box<dyn Fn(f64, f64) -> Stack>,
}

/// The figures of the page on joints, with their files.
pub fn figures() -> io::Result<Vec<(&'static str, Figure)>> {
    let drawn =
        planes().into_iter().map(|Plane { file, words: [title, across, up], window, curves, stack }| {
            let plane = plane(stack, window).map_err(io::Error::other)?;
            Ok((
                file,
                stack_map(&StackMap {
                    plane: &plane,
                    window,
                    across,
                    up,
                    curves: &curves,
                    point: None,
                    regions: None,
                    words: None,
                    title,
                }),
            ))
        });
    drawn.collect()
}

/// The planes of two bodies.
fn planes() -> [Plane; 4] {
    let friction = "Friction of both joints, $μ$";
    let force = "Force in weights of both, $F/(m g)$";
    let acceleration = "Acceleration of the base to the right, $k$, in g";
    let cubes = [[1.0, 1.0]; 2];
    let glued = [curve(0.0, 0.5, |k| k), vec![(0.5, 0.5), (0.5, 1.4)]];
    let slender = [[1.0, 0.5], [0.3, 0.9]];
    // The upper rocks on a lower that slides from k_c on.
    let (m1, m2, b, d) = (0.5, 0.27, 0.15, 0.45);
    let (m, j2) = (m1 + m2, m2 * (0.3 * 0.3 + 0.9 * 0.9) / 12.0 + m2 * (b * b + d * d));
    let k_c = |mu: f64| {
        mu + m2 * (d + mu * b) * (m2 * m * (mu * d - b) / (m * j2 - m2 * m2 * d * (d + mu * b))) / m
    };
    let sliding: Vec<(f64, f64)> =
        curve(1.0 / 3.0, 1.0, |mu| mu).into_iter().map(|(mu, _)| (k_c(mu), mu)).collect();
    let protected = [
        curve(0.0, 1.0 / 3.0, |k| k),
        vec![(1.0 / 3.0, 1.0 / 3.0), (1.0 / 3.0, 1.0)],
        vec![(1.0 / 3.0, 1.0 / 3.0), (1.6, 1.0 / 3.0)],
        sliding,
    ];
    let flat = [[2.0, 0.5], [1.0, 0.25]];
    let lower = "A force on the lower of two flat blocks, 2 × 0.5 under 1 × 0.25";
    let upper = "A force on the upper of two flat blocks, 2 × 0.25 under 1 × 0.5, with a friction of 0.6 between them";
    let on_upper = |k: f64, mu: f64| {
        let mut stack = pushed(&[[2.0, 0.25], [1.0, 0.5]], mu, 1, k);
        (stack.joints[1].mu_s, stack.joints[1].mu_k) = (0.6, 0.6);
        stack
    };
    [
        Plane {
            file: "gallery/stack-cubes.svg",
            words: ["Two cubes on a shaken base", acceleration, friction],
            window: [1.6, 1.4],
            curves: glued.into(),
            stack: Box::new(move |k, mu| tower(&cubes, mu, k)),
        },
        Plane {
            file: "gallery/stack-slender.svg",
            words: ["A block of 0.3 × 0.9 on one of 1 × 0.5, on a shaken base", acceleration, friction],
            window: [1.6, 1.0],
            curves: protected.into(),
            stack: Box::new(move |k, mu| tower(&slender, mu, k)),
        },
        Plane {
            file: "gallery/stack-lower.svg",
            words: [lower, force, friction],
            window: [1.2, 0.8],
            curves: vec![curve(0.0, 0.8, |k| k), curve(0.0, 1.2, |k| k / 2.0)],
            stack: Box::new(move |k, mu| pushed(&flat, mu, 0, k)),
        },
        Plane {
            file: "gallery/stack-upper.svg",
            words: [upper, force, "Friction of the lower joint, $μ_1$"],
            window: [0.8, 0.6],
            curves: vec![curve(0.0, 0.3, |k| k), vec![(0.3, 0.3), (0.3, 0.6)], curve(0.3, 0.6, |k| 0.6 - k)],
            stack: Box::new(on_upper),
        },
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// On both sides of a boundary in closed form other modes begin.
    #[test]
    fn curves_are_boundaries() {
        for Plane { file, window, curves, stack, .. } in planes() {
            let modes = |k: f64, mu: f64| stack(k, mu).answer(1.0).unwrap().modes().to_vec();
            for curve in curves {
                let [first, last] = [curve[0], curve[curve.len() - 1]];
                let straight = (1..20).map(|step| {
                    let share = f64::from(step) / 20.0;
                    (first.0 + share * (last.0 - first.0), first.1 + share * (last.1 - first.1))
                });
                let through: Vec<(f64, f64)> =
                    if curve.len() == 2 { straight.collect() } else { curve[1..100].to_vec() };
                for (k, mu) in through.into_iter().filter(|(k, mu)| *k < window[0] && *mu < window[1]) {
                    // Across the curve: upright ones by k, all others by μ.
                    let off = 1e-6;
                    let (one, other) = match first.0 == last.0 {
                        true => (modes(k - off, mu), modes(k + off, mu)),
                        false => (modes(k, mu - off), modes(k, mu + off)),
                    };
                    assert_ne!(one, other, "{file} at {k}, {mu}");
                }
            }
        }
    }
}
