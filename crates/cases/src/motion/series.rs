//! The motion at even steps of time, as a table.

use std::fmt::Write;

use standfast_motion::Outcome;

/// The motion every `dt` until it ends, as CSV: time, position of the centre of mass and of the touching corner along the base, θ, θ̇ and
/// the state.
pub fn series_csv(outcome: &Outcome, dt: f64) -> String {
    let mut text = "t,slide,x,y,theta,omega,state\n".to_owned();
    let end = outcome.t_final;
    let count = (end / dt + 1e-9).floor() as u64;
    for i in 0..=count {
        let t = i as f64 * dt;
        let Some(at) = outcome.at(t) else { break };
        let _ = writeln!(
            text,
            "{t},{},{},{},{},{},{}",
            at.slide,
            at.x,
            at.y,
            at.theta,
            at.omega,
            at.state.symbol()
        );
    }
    text
}
