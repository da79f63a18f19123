//! A block on a floor in Rapier.
//!
//! `rapier-peer [name=value ...]` reads lines of γ, k', k and μ on standard input: a block under a sudden force. It writes the
//! slip and lift of O and of O' in g soon after, and the seconds the simulation took.
//!
//! `rapier-peer motions [name=value ...]` reads motions, one a line; see [`Motion`]. It writes the seconds and then x, y and θ
//! at every time asked for. The names are those of [`Settings::read`].

use std::io::{BufRead, Write};
use std::time::Instant;

use rapier2d_f64::prelude::*;

const G: f64 = 9.81;

struct Settings {
    parameters: IntegrationParameters,
    /// Steps before the force, from the force to the first look, and to the second.
    settle: usize,
    start: usize,
    steps: usize,
}

impl Settings {
    /// `plain=1` begins with Rapier as it comes; else with short steps and stiff contacts.
    fn read(arguments: &[String]) -> Settings {
        let pairs: Vec<(&str, f64)> = arguments
            .iter()
            .map(|argument| {
                let (name, value) = argument.split_once('=').expect("name=value");
                (name, value.parse().expect("a number"))
            })
            .collect();
        let plain = pairs.iter().any(|&(name, value)| name == "plain" && value != 0.0);
        let mut p = IntegrationParameters::default();
        // Frequency in Hz, as a part of 1/dt, and damping ratio of the contact.
        let (mut frequency, mut damping) = (None, None);
        let (mut settle, mut start, mut steps) = (200, 100, 200);
        if !plain {
            p.dt = 1e-4;
            p.num_solver_iterations = 20;
            p.num_internal_pgs_iterations = 4;
            p.normalized_allowed_linear_error = 1e-6;
            p.max_ccd_substeps = 0;
            p.contact_recycling = false;
            (frequency, damping) = (Some(0.1), Some(1.0));
        }
        for (name, number) in pairs {
            match name {
                "plain" => {}
                "dt" => p.dt = number,
                // Solver iterations, and sweeps of projected Gauss-Seidel in each.
                "iterations" => p.num_solver_iterations = number as usize,
                "sweeps" => p.num_internal_pgs_iterations = number as usize,
                "stabilization" => p.num_internal_stabilization_iterations = number as usize,
                "frequency" => frequency = Some(number),
                "damping" => damping = Some(number),
                // Distances in m, and the speed in m/s that pushes penetration out.
                "prediction" => p.normalized_prediction_distance = number,
                "allowed_error" => p.normalized_allowed_linear_error = number,
                "corrective" => p.normalized_max_corrective_velocity = number,
                // Units of length in a metre.
                "length_unit" => p.length_unit = number,
                // Whether friction acts while penetration is pushed out.
                "bias_friction" => p.friction_in_bias_pass = number != 0.0,
                "warmstart" => p.warmstart_coefficient = number,
                "recycling" => p.contact_recycling = number != 0.0,
                "ccd" => p.max_ccd_substeps = number as usize,
                "settle" => settle = number as usize,
                "start" => start = number as usize,
                "steps" => steps = number as usize,
                _ => panic!("unknown setting {name}"),
            }
        }
        for softness in [&mut p.contact_softness, &mut p.static_contact_softness] {
            if let Some(frequency) = frequency {
                softness.natural_frequency = frequency / p.dt;
            }
            if let Some(damping) = damping {
                softness.damping_ratio = damping;
            }
        }
        Settings { parameters: p, settle, start, steps }
    }
}

/// Velocities of O and O': to the right and upwards each.
fn corners(body: &RigidBody, gamma: f64) -> [f64; 4] {
    let (sin, cos) = body.rotation().angle().sin_cos();
    let (velocity, spin) = (body.linvel(), body.angvel());
    let corner = |side: f64| {
        let (x, y) = (cos * side + sin * gamma, sin * side - cos * gamma);
        [velocity.x - spin * y, velocity.y + spin * x]
    };
    let ([a, b], [c, d]) = (corner(-1.0), corner(1.0));
    [a, b, c, d]
}

/// The state of a body.
struct State {
    x: f64,
    y: f64,
    theta: f64,
    vx: f64,
    vy: f64,
    omega: f64,
}

/// A block of B = 1 m and m = 1 kg on the floor y = 0.
fn place(
    settings: &Settings,
    gamma: f64,
    mu: f64,
    gravity: f64,
    inertia: f64,
    state: &State,
) -> (PhysicsWorld, RigidBodyHandle) {
    let mut world = PhysicsWorld {
        gravity: Vector::new(0.0, -gravity),
        integration_parameters: settings.parameters,
        ..PhysicsWorld::default()
    };
    let body = RigidBodyBuilder::dynamic()
        .translation(Vector::new(state.x, state.y))
        .rotation(state.theta)
        .linvel(Vector::new(state.vx, state.vy))
        .angvel(state.omega)
        .additional_mass_properties(MassProperties::new(Vector::ZERO, 1.0, inertia))
        .can_sleep(false);
    let body = world.bodies.insert(body);
    let block = ColliderBuilder::cuboid(1.0, gamma).density(0.0).friction(mu).restitution(0.0);
    world.colliders.insert_with_parent(block, body, &mut world.bodies);
    let base =
        ColliderBuilder::cuboid(50.0, 1.0).translation(Vector::new(0.0, -1.0)).friction(mu).restitution(0.0);
    world.colliders.insert(base);
    (world, body)
}

fn onset([gamma, k_prime, k, mu]: [f64; 4], settings: &Settings) -> [f64; 4] {
    let rest = State { x: 0.0, y: gamma, theta: 0.0, vx: 0.0, vy: 0.0, omega: 0.0 };
    let (mut world, body) = place(settings, gamma, mu, G, (1.0 + gamma * gamma) / 3.0, &rest);
    (0..settings.settle).for_each(|_| world.step());
    let force = k * G;
    let loaded = &mut world.bodies[body];
    loaded.add_force(Vector::new(-force, 0.0), true);
    loaded.add_torque(force * k_prime * gamma, true);
    (0..settings.start).for_each(|_| world.step());
    let before = corners(&world.bodies[body], gamma);
    (settings.start..settings.steps).for_each(|_| world.step());
    let after = corners(&world.bodies[body], gamma);
    let span = (settings.steps - settings.start) as f64 * settings.parameters.dt;
    std::array::from_fn(|i| (after[i] - before[i]) / span / G)
}

/// A history of force or acceleration.
struct History {
    shape: String,
    start: f64,
    duration: f64,
    peak: f64,
    /// The time to the peak of a triangle, or the period of a sine.
    time: f64,
}

impl History {
    /// `shape,start,duration,peak,time`
    fn read(fields: &[&str]) -> History {
        let [start, duration, peak, time] = numbers(&fields[1..5]).try_into().expect("four numbers");
        History { shape: fields[0].to_owned(), start, duration, peak, time }
    }

    fn value(&self, t: f64) -> f64 {
        let t = t - self.start;
        if !(0.0..self.duration).contains(&t) {
            return 0.0;
        }
        let pi = std::f64::consts::PI;
        self.peak
            * match self.shape.as_str() {
                "half-sine" => (pi * t / self.duration).sin(),
                "sine" => (2.0 * pi * t / self.time).sin(),
                "rect" => 1.0,
                "triangle" => (t / self.time).min((self.duration - t) / (self.duration - self.time)),
                other => panic!("unknown shape {other}"),
            }
    }
}

/// One motion: four parts with `;` between, of fields with `,` between.
///
/// 1. γ, μ, gravity, inertia, x, y, θ, and the three velocities
/// 2. the force, or nothing: a [`History`], the point in the body and the direction in space
/// 3. the acceleration of the base, or nothing: a [`History`]
/// 4. the times asked for, in order
struct Motion {
    block: [f64; 10],
    force: Option<(History, [f64; 4])>,
    base: Option<History>,
    times: Vec<f64>,
}

impl Motion {
    fn read(line: &str) -> Motion {
        let parts: Vec<Vec<&str>> = line.split(';').map(|part| part.split(',').collect()).collect();
        let [block, force, base, times] = parts.as_slice() else { panic!("four parts") };
        let given = |part: &[&str]| part != [""];
        Motion {
            block: numbers(block).try_into().expect("ten numbers"),
            force: given(force).then(|| {
                (History::read(force), numbers(&force[5..]).try_into().expect("point and direction"))
            }),
            base: given(base).then(|| History::read(base)),
            times: numbers(times),
        }
    }

    /// x, y and θ at the times, linear between steps. The base's acceleration acts as a force of inertia.
    fn follow(&self, settings: &Settings) -> Vec<[f64; 3]> {
        let [gamma, mu, gravity, inertia, x, y, theta, vx, vy, omega] = self.block;
        let (mut world, handle) =
            place(settings, gamma, mu, gravity, inertia, &State { x, y, theta, vx, vy, omega });
        let dt = settings.parameters.dt;
        let mut found = Vec::new();
        let (mut t, mut old) = (0.0, [x, y, theta]);
        let mut step = 0;
        while found.len() < self.times.len() {
            let middle = t + dt / 2.0;
            let body = &mut world.bodies[handle];
            body.reset_forces(false);
            body.reset_torques(false);
            if let Some((history, [ax, ay, ux, uy])) = &self.force {
                let (value, (sin, cos)) = (history.value(middle), old[2].sin_cos());
                let (rx, ry) = (cos * ax - sin * ay, sin * ax + cos * ay);
                body.add_force(Vector::new(value * ux, value * uy), true);
                body.add_torque(value * (rx * uy - ry * ux), true);
            }
            if let Some(history) = &self.base {
                body.add_force(Vector::new(-history.value(middle), 0.0), true);
            }
            world.step();
            step += 1;
            let now = step as f64 * dt;
            let body = &world.bodies[handle];
            let new = [body.translation().x, body.translation().y, body.rotation().angle()];
            while let Some(&wanted) = self.times.get(found.len()).filter(|&&wanted| wanted <= now + 1e-9) {
                let part = (wanted - t) / (now - t);
                found.push(std::array::from_fn(|i| old[i] + part * (new[i] - old[i])));
            }
            (t, old) = (now, new);
        }
        found
    }
}

fn numbers(fields: &[&str]) -> Vec<f64> {
    fields.iter().map(|field| field.parse().expect("a number")).collect()
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let motions = arguments.first().is_some_and(|first| first == "motions");
    let settings = Settings::read(&arguments[usize::from(motions)..]);
    let mut output = std::io::stdout().lock();
    for line in std::io::stdin().lock().lines().map_while(Result::ok) {
        if motions {
            let motion = Motion::read(&line);
            let start = Instant::now();
            let found = motion.follow(&settings);
            write!(output, "{}", start.elapsed().as_secs_f64()).expect("written");
            for [x, y, theta] in found {
                write!(output, ",{x},{y},{theta}").expect("written");
            }
            writeln!(output).expect("written");
        } else {
            let point = numbers(&line.split(',').collect::<Vec<_>>()).try_into().expect("four numbers");
            let start = Instant::now();
            let [a, b, c, d] = onset(point, &settings);
            let seconds = start.elapsed().as_secs_f64();
            writeln!(output, "{a},{b},{c},{d},{seconds}").expect("written");
        }
    }
}
