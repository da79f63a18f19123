//! The motion at even steps of time, as a table.

use std::fmt::Write;

use standfast_motion::{MotionOutcome, Position};

/// The columns of a series: time, position of the touching corner along the base, x and y of the centre of mass, θ, θ̇ and the state.
pub const SERIES: [&str; 7] = ["t", "slide", "x", "y", "theta", "omega", "state"];

/// The motion every `dt` until it ends: the moment asked for, and where the body is.
pub fn series(outcome: &MotionOutcome, dt: f64) -> impl Iterator<Item = (f64, Position)> {
    let count = (outcome.t_final / dt + 1e-9).floor() as u64;
    (0..=count).map(move |i| i as f64 * dt).map_while(|t| Some((t, outcome.at(t)?)))
}

/// The motion every `dt` as CSV.
pub fn series_csv(outcome: &MotionOutcome, dt: f64) -> String {
    let mut text = SERIES.join(",") + "\n";
    for (t, at) in series(outcome, dt) {
        let (slide, x, y, theta, omega) = (at.slide, at.x, at.y, at.theta, at.omega);
        let _ = writeln!(text, "{t},{slide},{x},{y},{theta},{omega},{}", at.state.symbol());
    }
    text
}
