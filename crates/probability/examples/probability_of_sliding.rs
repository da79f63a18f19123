//! Finds how likely a caisson slides under a wave whose thrust is random, on a base whose friction is: friction is not sampled, because
//! for each thrust the modes are intervals of it.
//!
//! `cargo run -p standfast-probability --example probability_of_sliding`

use std::error::Error;

use standfast::contact::friction;
use standfast::loads::{Action, Load, LoadKind, LoadSource};
use standfast::{Body, Mode, Situation};
use standfast_probability::integrate::{Within, integrate};
use standfast_probability::law::Law;
use standfast_probability::problem::{Outcomes, Pieces, RandomVector};

const WIDTH: f64 = 15.0;
const HEIGHT: f64 = 12.0;
const MASS: f64 = 378_000.0;

/// The modes of the caisson, numbered by their codes; inputs are friction and thrust (N per metre run).
struct Caisson(Body);

impl Caisson {
    fn situation(&self, thrust: f64) -> Situation {
        let wave = Action::horizontal(-thrust, 4.0);
        let wave = Load::variable(LoadSource::Force, LoadKind::Horizontal, wave);
        let situation = Situation::new(self.0, 0.6, 9.81).expect("a caisson");
        situation.with_weight().with(wave)
    }
}

impl Outcomes for Caisson {
    fn count(&self) -> usize {
        Mode::ALL.len()
    }

    fn line(&self) -> usize {
        0
    }

    fn along(&self, values: &[f64], pieces: &mut Pieces) {
        let situation = self.situation(values[1]);
        let wrench = situation.reduced_wrench(&situation.wrench_at(1.0, standfast::loads::Pose::UPRIGHT));
        for span in friction::spans(&situation.reduced_block().0, &wrench).unwrap_or_default() {
            if let Some(mode) = span.mode() {
                pieces.push(span.from, span.to, mode.code().into());
            }
        }
    }

    fn at(&self, values: &[f64]) -> u64 {
        let mut pieces = Pieces::default();
        self.along(values, &mut pieces);
        let holds = pieces.iter().find(|piece| piece.from <= values[0] && values[0] < piece.to);
        holds.map_or(0, |piece| 1 << piece.outcome)
    }
}

fn sliding() -> Result<f64, Box<dyn Error>> {
    let inputs =
        RandomVector::independent(vec![Law::normal(0.6, 0.06)?.into(), Law::normal(1.7e6, 0.2e6)?.into()]);
    let caisson = Caisson(Body::new(WIDTH, HEIGHT, MASS)?);
    let slides = 1 << Mode::SlideLeft.code();
    Ok(integrate(&inputs, &caisson, &[slides], Within::ALL_DIGITS)?.probabilities[0])
}

fn main() -> Result<(), Box<dyn Error>> {
    println!("P(it slides) = {:.4}", sliding()?);
    Ok(())
}

/// It slides where F > μ m g, unless it turns, which this force at 4 m does not make it do: Φ of the distance of both means over
/// the deviation of their difference.
#[test]
fn the_probability_is_that_of_two_normal_laws() {
    let weight = MASS * 9.81;
    let beta = (0.6 * weight - 1.7e6) / (0.06 * weight).hypot(0.2e6);
    let expected = standfast_probability::normal::above(beta);
    let found = sliding().unwrap();
    assert!((found - expected).abs() < 1e-9, "{found} {expected}");
}
