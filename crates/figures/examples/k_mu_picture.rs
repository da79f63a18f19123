//! Draws the k–μ plane of a caisson with the point of a wave, as SVG on standard output.
//!
//! `cargo run -p standfast-figures --example k_mu_picture > plane.svg`

use standfast::loads::HorizontalForce;
use standfast::{Body, Diagram, InputError, Slip};
use standfast_figures::{DesignPoint, Figure, diagram};

fn picture() -> Result<Figure, InputError> {
    let body = Body::new(15.0, 12.0, 378_000.0)?;
    let wave = HorizontalForce::new(2.7e6, 11.5, Slip::Left)?.reduce(&body, 0.6, 9.81)?;
    let (k, mu) = (wave.point.k(), wave.point.mu());
    let plane = Diagram::new(wave.point.gamma(), wave.point.k_prime())?;
    Ok(diagram(&plane, &[DesignPoint { k, mu, label: "wave".into(), mirrored: false }]))
}

fn main() -> Result<(), InputError> {
    println!("{}", picture()?.svg());
    Ok(())
}

#[test]
fn the_picture_names_its_plane() {
    let figure = picture().unwrap();
    assert!(figure.svg().starts_with("<svg") && figure.title().contains("γ = 0.8"), "{}", figure.title());
}
