//! A block under a sudden force in Rapier: the accelerations of its bottom corners soon after.
//!
//! Reads lines of γ, k', k and μ on standard input; writes the slip and lift of O and of O' in g, and the seconds the
//! simulation took. Arguments are settings, `name=value`; see [`Settings`].

use std::io::{BufRead, Write};
use std::time::Instant;

use rapier2d_f64::prelude::*;

const G: f64 = 9.81;

struct Settings {
    /// Length of a step in s.
    dt: f64,
    /// Solver iterations, and sweeps of projected Gauss-Seidel in each.
    iterations: usize,
    sweeps: usize,
    stabilization: usize,
    /// Frequency in Hz, as a part of 1/dt, and damping ratio of the contact.
    frequency: f64,
    damping: f64,
    /// Distances in m.
    prediction: f64,
    allowed_error: f64,
    /// Whether friction acts while penetration is pushed out.
    bias_friction: bool,
    warmstart: f64,
    /// Steps before the force, from the force to the first look, and to the second.
    settle: usize,
    start: usize,
    steps: usize,
}

impl Settings {
    fn read() -> Settings {
        let mut settings = Settings {
            dt: 1e-4,
            iterations: 20,
            sweeps: 4,
            stabilization: 1,
            frequency: 0.1,
            damping: 1.0,
            prediction: 0.02,
            allowed_error: 1e-6,
            bias_friction: false,
            warmstart: 1.0,
            settle: 200,
            start: 100,
            steps: 200,
        };
        for argument in std::env::args().skip(1) {
            let (name, value) = argument.split_once('=').expect("name=value");
            let number: f64 = value.parse().expect("a number");
            match name {
                "dt" => settings.dt = number,
                "iterations" => settings.iterations = number as usize,
                "sweeps" => settings.sweeps = number as usize,
                "stabilization" => settings.stabilization = number as usize,
                "frequency" => settings.frequency = number,
                "damping" => settings.damping = number,
                "prediction" => settings.prediction = number,
                "allowed_error" => settings.allowed_error = number,
                "bias_friction" => settings.bias_friction = number != 0.0,
                "warmstart" => settings.warmstart = number,
                "settle" => settings.settle = number as usize,
                "start" => settings.start = number as usize,
                "steps" => settings.steps = number as usize,
                _ => panic!("unknown setting {name}"),
            }
        }
        settings
    }

    fn parameters(&self) -> IntegrationParameters {
        let softness = SpringCoefficients::new(self.frequency / self.dt, self.damping);
        IntegrationParameters {
            dt: self.dt,
            num_solver_iterations: self.iterations,
            num_internal_pgs_iterations: self.sweeps,
            num_internal_stabilization_iterations: self.stabilization,
            contact_softness: softness,
            static_contact_softness: softness,
            normalized_prediction_distance: self.prediction,
            normalized_allowed_linear_error: self.allowed_error,
            friction_in_bias_pass: self.bias_friction,
            warmstart_coefficient: self.warmstart,
            max_ccd_substeps: 0,
            contact_recycling: false,
            ..IntegrationParameters::default()
        }
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

/// B = 1 m, m = 1 kg.
fn simulate([gamma, k_prime, k, mu]: [f64; 4], settings: &Settings) -> [f64; 4] {
    let mut world = PhysicsWorld::default();
    world.gravity = Vector::new(0.0, -G);
    world.integration_parameters = settings.parameters();
    let inertia = (1.0 + gamma * gamma) / 3.0;
    let body = RigidBodyBuilder::dynamic()
        .translation(Vector::new(0.0, gamma))
        .additional_mass_properties(MassProperties::new(Vector::ZERO, 1.0, inertia))
        .can_sleep(false);
    let body = world.bodies.insert(body);
    let block = ColliderBuilder::cuboid(1.0, gamma).density(0.0).friction(mu);
    world.colliders.insert_with_parent(block, body, &mut world.bodies);
    let base = ColliderBuilder::cuboid(50.0, 1.0).translation(Vector::new(0.0, -1.0)).friction(mu);
    world.colliders.insert(base);

    (0..settings.settle).for_each(|_| world.step());
    let force = k * G;
    let loaded = &mut world.bodies[body];
    loaded.add_force(Vector::new(-force, 0.0), true);
    loaded.add_torque(force * k_prime * gamma, true);
    (0..settings.start).for_each(|_| world.step());
    let before = corners(&world.bodies[body], gamma);
    (settings.start..settings.steps).for_each(|_| world.step());
    let after = corners(&world.bodies[body], gamma);
    let span = (settings.steps - settings.start) as f64 * settings.dt;
    std::array::from_fn(|i| (after[i] - before[i]) / span / G)
}

fn main() {
    let settings = Settings::read();
    let mut output = std::io::stdout().lock();
    for line in std::io::stdin().lock().lines().map_while(Result::ok) {
        let numbers: Vec<f64> = line.split(',').map(|field| field.parse().expect("a number")).collect();
        let point = numbers.try_into().expect("four numbers");
        let start = Instant::now();
        let [a, b, c, d] = simulate(point, &settings);
        let seconds = start.elapsed().as_secs_f64();
        writeln!(output, "{a},{b},{c},{d},{seconds}").expect("written");
    }
}
