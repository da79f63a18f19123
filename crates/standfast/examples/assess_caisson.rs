//! Assesses Goda's caisson (Random Seas, 2nd ed., p. 140) under its design wave: both safety factors, the mode, and where the rising
//! wave moves it.
//!
//! `cargo run -p standfast --example assess_caisson`

use standfast::loads::{Action, Load, LoadKind, LoadSource};
use standfast::wave::{CaissonSection, Choices, Heights, Sea, goda};
use standfast::{Body, Departure, InputError, Outcome, Situation};

fn outcome() -> Result<Outcome, InputError> {
    let body = Body::new(15.0, 10.5, 346_050.0)?;
    let sea = Sea {
        water_depth: 10.1,
        sea_bottom_slope: 0.01,
        period: 11.4,
        angle_deg: 15.0,
        water_density: 1030.0,
        gravity: 9.81,
    };
    let section = CaissonSection {
        base_depth: 7.1,
        depth_above_berm: 5.6,
        crest_height: 3.4,
        berm_width: 8.0,
        caisson_width: 15.0,
    };
    let wave = goda(&sea, &Heights::DeepWater(6.3), &section, &Choices::default())?;
    // The water displaced, at mid-width.
    let buoyancy = Action::vertical(&body, -1_076_110.5, 7.5);
    let situation = Situation::new(body, 0.6, 9.81)?
        .with_weight()
        .with(Load::permanent(LoadSource::Buoyancy, LoadKind::Weight, buoyancy))
        .with_all(wave.loads(&body, section.base_depth));
    situation.outcome()
}

fn main() -> Result<(), InputError> {
    let outcome = outcome()?;
    println!("sliding      {:.3}", outcome.stability.sliding);
    println!("overturning  {:.3}", outcome.stability.overturning());
    println!("mode         {}", outcome.full.verdict.map_or("none", |verdict| verdict.words()));
    if let Departure::At { factor, verdict } = outcome.departure {
        let into = verdict.map_or("none", |verdict| verdict.words());
        println!("leaves rest at {:.1} % of the wave; then it {into}", 100.0 * factor);
    }
    Ok(())
}

/// Goda's own factors are 1.16 and 2.57.
#[test]
fn the_factors_are_goda_s() {
    let outcome = outcome().unwrap();
    assert!((outcome.stability.sliding - 1.16).abs() < 0.01, "{}", outcome.stability.sliding);
    assert!((outcome.stability.overturning() - 2.57).abs() < 0.01, "{}", outcome.stability.overturning());
}
