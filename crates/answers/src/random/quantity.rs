//! Random numbers: those of a case, of the report's plane, of a storm, and factors on loads.

use super::storm::StormField;
use crate::couple::Variable;
use crate::key::{Id, Key, Range};
use standfast_inputs::random::Rate;
pub use standfast_model::case::Bias;
use standfast_probability::fit::Fit;

/// Quantity that a random number is.
#[derive(Debug, Clone, PartialEq)]
pub enum Quantity {
    /// A number of the case file, with what goes with it.
    Key(Variable),
    /// Factor that loads are multiplied by.
    Bias(Bias),
    /// One of the four numbers of the report's problem.
    Point(Coordinate),
    /// A number of a pure problem of sliding.
    Storm(StormField),
    /// Rise of the water since a life began, by the level that it is of.
    Rise(Variable),
    /// A number of a limit state that is the user's own, by its name.
    Own(String),
    /// A parameter of a law that was fitted to values of another quantity.
    Fitted {
        /// The other quantity.
        of: Box<Quantity>,
        /// Its name.
        parameter: &'static str,
        /// True if it has the dimension of that quantity.
        has_dimension: bool,
    },
}

/// A number of the report's problem.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Coordinate {
    /// γ, the slenderness.
    Gamma,
    /// k', the elevation of the force.
    KPrime,
    /// k, the force.
    K,
    /// μ, the friction.
    Mu,
}

impl Coordinate {
    /// All of them.
    pub const ALL: [Coordinate; 4] = [Coordinate::Gamma, Coordinate::KPrime, Coordinate::K, Coordinate::Mu];

    /// The key of `[point]` that it stands under.
    pub fn key(self) -> Key {
        match self {
            Coordinate::Gamma => Key::Gamma,
            Coordinate::KPrime => Key::KPrime,
            Coordinate::K => Key::K,
            Coordinate::Mu => Key::Mu,
        }
    }

    /// Its name in a case file.
    pub fn name(self) -> &'static str {
        self.key().name()
    }

    /// Range of its values.
    pub fn range(self) -> Range {
        self.key().info().range().unwrap_or(Range::Finite)
    }
}

/// Place of a friction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum FrictionOf {
    /// Under the body.
    Base,
    /// In the joint with this place among the tables of joints.
    Joint(usize),
}

/// A number that is random.
#[derive(Debug, Clone, PartialEq)]
pub struct RandomInput {
    /// Its name, as in the file.
    pub name: String,
    /// Quantity that is random.
    pub quantity: Quantity,
    /// Rate at which it is drawn.
    pub every: Rate,
    /// True if each body of a row draws it for itself.
    pub own: bool,
    /// Share of its law that was cut because no body has such values.
    pub cut: f64,
    /// Law that was fitted to values of it.
    pub fit: Option<Fit>,
}

impl RandomInput {
    pub(super) fn variable(&self) -> Option<&Variable> {
        match &self.quantity {
            Quantity::Key(variable) => Some(variable),
            Quantity::Bias(_)
            | Quantity::Point(_)
            | Quantity::Storm(_)
            | Quantity::Rise(_)
            | Quantity::Own(_)
            | Quantity::Fitted { .. } => None,
        }
    }

    /// The level that it is the rise of; `None` of any other number.
    pub(super) fn rise_of(&self) -> Option<&Variable> {
        match &self.quantity {
            Quantity::Rise(level) => Some(level),
            _ => None,
        }
    }

    /// Its meaning in a few words, for people; of a table that a case may have several times, with the place of that.
    pub fn words(&self) -> String {
        RandomInput::words_of(&self.quantity)
    }

    fn words_of(quantity: &Quantity) -> String {
        match quantity {
            // The mass's where it varies by the density.
            Quantity::Key(variable) => Id { key: variable.key(), ..variable.id() }.words(),
            Quantity::Bias(bias) => bias.words().to_owned(),
            Quantity::Point(coordinate) => Id::from(coordinate.key()).words(),
            Quantity::Storm(field) => Id::from(field.key()).words(),
            Quantity::Rise(_) => "rise of the water since the life began".to_owned(),
            Quantity::Own(name) => name.clone(),
            Quantity::Fitted { of, parameter, .. } => {
                let name = parameter.replace('_', " ");
                format!("{name} of the law fitted to the {}", RandomInput::words_of(of))
            }
        }
    }

    /// True if it is this number of the case.
    pub(super) fn is_of(&self, variable: &Variable) -> bool {
        self.variable().is_some_and(|own| own.id() == variable.id())
    }

    /// True if it is the number with this key, of which the case has one.
    pub(super) fn is_key(&self, key: Key) -> bool {
        self.variable().is_some_and(|variable| variable.id() == Id::from(key))
    }

    /// Where it is the friction to stick; `None` of any other number.
    pub(super) fn friction_of(&self) -> Option<FrictionOf> {
        match &self.quantity {
            Quantity::Key(variable) => match variable.id() {
                id if id == Id::from(Key::Friction) => Some(FrictionOf::Base),
                Id { key: Key::JointFriction, index, .. } => Some(FrictionOf::Joint(index)),
                _ => None,
            },
            Quantity::Point(Coordinate::Mu) => Some(FrictionOf::Base),
            _ => None,
        }
    }

    /// True if it says where a joint is.
    pub(super) fn is_joint_elevation(&self) -> bool {
        self.variable().is_some_and(|variable| variable.id().key == Key::JointElevation)
    }

    /// True if it is friction to slip, with a law of its own.
    pub(super) fn is_kinetic_friction(&self) -> bool {
        self.is_key(Key::KineticFriction)
    }

    /// True if it is a direction seen from above.
    pub(super) fn is_direction(&self) -> bool {
        let of_key = |key| matches!(key, Key::LoadDirectionDeg | Key::EarthquakeDirection);
        self.variable().is_some_and(|variable| of_key(variable.id().key))
    }

    /// True if it is beside the keys of the case and changes it, so that its formulas are worked out again: a factor, or a rise of the water.
    pub(super) fn is_beside_keys(&self) -> bool {
        match &self.quantity {
            Quantity::Bias(bias) => bias.is_of_case(),
            quantity => matches!(quantity, Quantity::Rise(_)),
        }
    }

    /// True if it is a bias of some loads.
    pub(super) fn is_bias(&self) -> bool {
        matches!(self.quantity, Quantity::Bias(_))
    }

    /// True if the wrench is linear in it.
    pub(super) fn is_linear(&self) -> bool {
        match &self.quantity {
            Quantity::Bias(bias) => !bias.is_of_case(),
            Quantity::Point(Coordinate::K) => true,
            Quantity::Point(_)
            | Quantity::Storm(_)
            | Quantity::Rise(_)
            | Quantity::Own(_)
            | Quantity::Fitted { .. } => false,
            Quantity::Key(variable) => variable.id().key == Key::Force,
        }
    }
}
