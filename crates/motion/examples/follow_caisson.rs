//! Follows a caisson in time under a breaking wave that slides it: how far, and what is left of the wave's work.
//!
//! `cargo run -p standfast-motion --example follow_caisson`

use std::error::Error;

use standfast::loads::{Action, Load, LoadKind, LoadSource};
use standfast::{Body, History, Situation};
use standfast_motion::{BaseMotion, Impact, Keep, MotionOutcome, MotionProblem, simulate};

const WIDTH: f64 = 15.0;
const HEIGHT: f64 = 12.0;
const MASS: f64 = 378_000.0;
const FRICTION: f64 = 0.6;
const THRUST: f64 = 2.7e6;
const DURATION: f64 = 0.3;

fn slid() -> Result<MotionOutcome, Box<dyn Error>> {
    let body = Body::new(WIDTH, HEIGHT, MASS)?;
    // 2700 kN/m at 4 m above the base, which rise to their peak in half of the duration and fall again.
    let pulse = History::triangle(1.0, 0.5 * DURATION, DURATION)?;
    let wave = Action::horizontal(-THRUST, 4.0);
    let wave = Load::variable(LoadSource::Force, LoadKind::Horizontal, wave).over_time(pulse);
    let situation = Situation::new(body, FRICTION, 9.81)?.with_weight().with(wave);
    let problem = MotionProblem::of(&situation, BaseMotion::default(), Impact::Inelastic)?;
    Ok(simulate(&problem, Keep::default())?)
}

fn main() -> Result<(), Box<dyn Error>> {
    let outcome = slid()?;
    println!("slide        {:.2} mm", 1e3 * outcome.slide);
    println!("largest θ    {:.4} rad", outcome.max_theta);
    println!("stands still {}", if outcome.at_rest() { "yes" } else { "no" });
    Ok(())
}

/// A triangle of thrust slides a body by (¼ + √2/6)(s − 1)³/s² · R τ²/m, with s = F/R up to 1 + 1/√2.
#[test]
fn the_slide_is_that_of_the_closed_form() {
    let resistance = FRICTION * MASS * 9.81;
    let s = THRUST / resistance;
    let reduced = (0.25 + 2f64.sqrt() / 6.0) * (s - 1.0).powi(3) / (s * s);
    let expected = reduced * resistance * DURATION * DURATION / MASS;
    let outcome = slid().unwrap();
    assert!((outcome.slide + expected).abs() < 1e-12, "{} {expected}", outcome.slide);
    assert_eq!(outcome.max_theta, 0.0);
}
