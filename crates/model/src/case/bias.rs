//! Factors between what formulas give and what acts: a bias of Goda's thrust, of his uplift, of forces.
//!
//! A force times its bias acts where the force acts. A moment with a bias of its own is that about the heel O, where engineers have M_p
//! and M_U; the force then acts elsewhere.

use standfast::loads::{Action, Load, LoadSource};
use standfast::{Body, Scalar, Wrench};

use crate::key::Table;

/// A factor between what formulas give and what acts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Bias {
    /// On the horizontal wave force, and on its moment unless that has one of its own.
    Thrust,
    /// On the uplift of the wave, and on its moment unless that has one of its own.
    Uplift,
    /// On the moment of the horizontal wave force about the heel.
    ThrustMoment,
    /// On the moment of the uplift about the heel.
    UpliftMoment,
    /// On every force of `[[load]]`.
    Force,
}

impl Bias {
    /// All of them.
    pub const ALL: [Bias; 5] =
        [Bias::Thrust, Bias::Uplift, Bias::ThrustMoment, Bias::UpliftMoment, Bias::Force];

    /// Its name in a case file.
    pub fn name(self) -> &'static str {
        match self {
            Bias::Thrust => "bias.P",
            Bias::Uplift => "bias.U",
            Bias::ThrustMoment => "bias.M_p",
            Bias::UpliftMoment => "bias.M_U",
            Bias::Force => "bias.force",
        }
    }

    /// The same in words.
    pub fn words(self) -> &'static str {
        match self {
            Bias::Thrust => "factor on the thrust of the wave",
            Bias::Uplift => "factor on the uplift",
            Bias::ThrustMoment => "factor on the moment of the thrust",
            Bias::UpliftMoment => "factor on the moment of the uplift",
            Bias::Force => "factor on the forces",
        }
    }

    /// The bias of a name.
    pub fn find(name: &str) -> Option<Bias> {
        Bias::ALL.into_iter().find(|bias| bias.name() == name)
    }

    /// The table of a case without which it is on nothing.
    pub fn table(self) -> Table {
        if self == Bias::Force { Table::Load } else { Table::Wave }
    }

    /// The biases of what is from a source: of its force, and of its moment about the heel.
    fn of(source: LoadSource) -> Option<(Bias, Option<Bias>)> {
        match source {
            LoadSource::WavePressure => Some((Bias::Thrust, Some(Bias::ThrustMoment))),
            LoadSource::WaveUplift => Some((Bias::Uplift, Some(Bias::UpliftMoment))),
            LoadSource::Force => Some((Bias::Force, None)),
            _ => None,
        }
    }
}

/// The biases of a case; none where nothing is said.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Biases([Option<f64>; Bias::ALL.len()]);

impl Biases {
    /// Sets the factor that a bias is.
    pub fn set(&mut self, bias: Bias, factor: f64) {
        self.0[bias as usize] = Some(factor);
    }

    /// The factor that a bias is, if it is set.
    pub fn get(&self, bias: Bias) -> Option<f64> {
        self.0[bias as usize]
    }

    /// A load on a body times its biases.
    pub(super) fn on<T: Scalar>(&self, load: Load<T>, body: &Body<T>, gravity: T) -> Load<T> {
        let Some((force, moment)) = Bias::of(load.source) else { return load };
        let of = |bias| self.get(bias).map(T::written);
        match (of(force), moment.and_then(of)) {
            (None, None) => load,
            (Some(factor), None) => load.times(factor),
            (factor, Some(of_moment)) => {
                let wrench = load.action.upright(body, gravity);
                let centre = [body.heel_distance(), body.centroid_height()];
                let of_force = factor.unwrap_or_else(|| T::of(1.0));
                Load { action: Action::Resultant(biased(wrench, centre, of_force, of_moment)), ..load }
            }
        }
    }
}

/// A wrench at a centre of mass that lies at `[b₁, d]` from the heel O, its force and its moment about O each times a factor.
pub fn biased<T: Scalar>(wrench: Wrench<T>, [b1, d]: [T; 2], of_force: T, of_moment: T) -> Wrench<T> {
    let lever = |x: T, p: T| -(b1.clone() * p) - d.clone() * x;
    let about_heel = (wrench.m + lever(wrench.x.clone(), wrench.p.clone())) * of_moment;
    let (x, p) = (wrench.x * of_force.clone(), wrench.p * of_force);
    Wrench { x: x.clone(), p: p.clone(), m: about_heel - lever(x, p) }
}
