//! What can be wrong with a case file, shown in the file's own text.

use miette::{Diagnostic, LabeledSpan, NamedSource, SourceCode};
use standfast::InputError;
use thiserror::Error;

use super::Span;
use crate::units::{Quantity, UnitError};

/// What is wrong.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum Problem {
    /// There is nothing in the file.
    #[error("{name} is empty")]
    Empty {
        /// The file.
        name: String,
    },
    /// The text is not TOML.
    #[error("this is not valid TOML: {0}")]
    Syntax(String),
    /// A key that no case file has.
    #[error("{table} has no key `{key}`")]
    UnknownKey {
        /// The key.
        key: String,
        /// The table it is in.
        table: &'static str,
        /// The allowed key it resembles.
        suggestion: Option<&'static str>,
        /// The keys the table may have.
        allowed: &'static [&'static str],
    },
    /// A key that has to be there.
    #[error("{table} lacks `{key}`")]
    MissingKey {
        /// The key.
        key: &'static str,
        /// The table it should be in.
        table: &'static str,
    },
    /// A value of another type.
    #[error("`{key}` is {found}; expected {expected}")]
    WrongType {
        /// The key.
        key: &'static str,
        /// The type found.
        found: &'static str,
        /// The type expected.
        expected: &'static str,
    },
    /// A text that is no quantity of the kind needed.
    #[error("`{key}` is {written}, and {error}; expected {}", quantity.words())]
    Unit {
        /// The key.
        key: &'static str,
        /// The value as it stands in the file.
        written: String,
        /// What the value should measure.
        quantity: Quantity,
        /// What is wrong with it.
        error: UnitError,
    },
    /// A value that the quantity cannot have.
    #[error("`{key}` is {written}; expected {expected}")]
    OutOfRange {
        /// The key.
        key: &'static str,
        /// The value as it stands in the file.
        written: String,
        /// What it has to be.
        expected: &'static str,
    },
    /// The force does not hit the body.
    #[error("`elevation` is above the crest of the body, which is {height} m high")]
    AboveCrest {
        /// Height of the body, m.
        height: f64,
    },
    /// Both are given.
    #[error("[body] has both `mass` and `density`")]
    MassAndDensity,
    /// None is given.
    #[error("[body] has neither `mass` nor `density`")]
    NoMass,
    /// `load = []`.
    #[error("the case file has no load")]
    NoLoad,
    /// Slip with more friction than stick.
    #[error("`kinetic_friction` is {kinetic}; expected no more than `friction`, which is {friction}")]
    KineticFriction {
        /// To slip.
        kinetic: f64,
        /// To stick.
        friction: f64,
    },
    /// `weight_arm` alone.
    #[error("[body] has `weight_arm` but no `buoyant_weight`")]
    ArmWithoutWeight,
    /// A water table beside a weight from which buoyancy is taken off.
    #[error("the case has both [water] and `buoyant_weight`, so buoyancy would be taken off twice")]
    WaterTwice,
    /// Waves without still water.
    #[error("[wave] needs [water], for the buoyancy, or `buoyant_weight` in [body]")]
    NoWater,
    /// No level.
    #[error("[water] has no level")]
    NoLevel,
    /// The level of one side.
    #[error("[water] lacks `{missing}`; water on one side only has level 0 on the other")]
    OneLevel {
        /// The key.
        missing: &'static str,
    },
    /// Both are given.
    #[error("[water] has `level`, for both sides, and one for a side")]
    LevelAndSides,
    /// Neither here nor with the waves.
    #[error("[water] lacks `density`, and there is no `water_density` in [wave] to take")]
    NoWaterDensity,
    /// Two densities of one water.
    #[error("`density` is {density} kg/m3, but `water_density` in [wave] is {of_wave} kg/m3")]
    Densities {
        /// Of the still water.
        density: f64,
        /// Of the waves.
        of_wave: f64,
    },
    /// Two levels of one sea.
    #[error(
        "`{key}` is {level} m above the base, but the sea at the right is {base_depth} m, by `base_depth` in [wave]"
    )]
    LevelOfWave {
        /// The key of the level.
        key: &'static str,
        /// Of the still water, m.
        level: f64,
        /// Of the waves, m.
        base_depth: f64,
    },
    /// Water whose mass is to be added, but there is none.
    #[error("`sides` counts sides with water, but there is neither [water] nor [wave]")]
    SidesWithoutWater,
    /// None is given.
    #[error("[added_mass] has neither `mass` nor `sides`")]
    NoAddedMass,
    /// Both are given.
    #[error("[added_mass] has both `mass` and `sides`")]
    MassAndSides,
    /// Both are given.
    #[error("[wave] has `deep_water_height` and a height at the wall")]
    DeepAndLocal,
    /// None is given.
    #[error("[wave] has no wave height")]
    NoWaveHeight,
    /// One of the heights at the wall.
    #[error("[wave] lacks `{missing}`; at the wall, both `H13` and `Hmax` are needed")]
    OneWaveHeight {
        /// The key.
        missing: &'static str,
    },
    /// Two widths of one caisson.
    #[error("`caisson_width` is {width} m, but the base of the body is {base} m wide")]
    CaissonWidth {
        /// Of the waves, m.
        width: f64,
        /// From O to O', m.
        base: f64,
    },
    /// Two heights of one caisson.
    #[error(
        "`base_depth` and `crest_height` make {base_depth} m + {crest_height} m, but the body is {height} m high"
    )]
    Height {
        /// Below still water, m.
        base_depth: f64,
        /// Above still water, m.
        crest_height: f64,
        /// Of the body, m.
        height: f64,
    },
    /// A value that does not go with the others.
    #[error("`{key}` is {}; expected {}", .error.value, .error.expected)]
    Impossible {
        /// The key.
        key: &'static str,
        /// What the library says.
        error: InputError,
    },
    /// Numbers beyond what can be computed, by themselves or together.
    #[error("these numbers are too large or too small to be computed with: {} is {:e}; expected {}", .0.quantity, .0.value, .0.expected)]
    Mechanics(InputError),
}

impl Problem {
    fn help(&self) -> Option<String> {
        const SKELETON: &str = "a case file has a body and one or more loads, for example:\n\n\
            [body]\nwidth = \"15 m\"\nheight = \"12 m\"\ndensity = \"2.1 t/m3\"\nfriction = 0.6\n\n\
            [[load]]\nforce = \"450 kN/m\"\nelevation = \"8 m\"";
        let help = match self {
            Problem::Empty { .. } | Problem::NoLoad => SKELETON.to_owned(),
            Problem::UnknownKey { suggestion, allowed, .. } => {
                let known = format!("the keys understood here: {}", allowed.join(", "));
                match suggestion {
                    Some(suggestion) => format!("did you mean `{suggestion}`? {known}"),
                    None => known,
                }
            }
            Problem::MissingKey { key, .. } => {
                return example(key).map(|line| format!("add for example\n{line}"));
            }
            Problem::Unit { quantity, error, .. } => {
                let units = format!("the units understood here: {}", quantity.understood());
                match error {
                    UnitError::Missing => format!("{units}; a number without quotes is in {}", quantity.si()),
                    _ => units,
                }
            }
            Problem::WrongType { key, .. } | Problem::OutOfRange { key, .. } => {
                return example(key).map(|line| format!("for example\n{line}"));
            }
            Problem::AboveCrest { .. } => {
                "the elevation is measured from the base, in m if it has no unit".into()
            }
            Problem::MassAndDensity => "keep one of them; the other follows from width and height".into(),
            Problem::NoMass => "add one of them, for example density = \"2.1 t/m3\"".into(),
            Problem::Syntax(message) if message.contains("missing value") || message.contains("quot") => {
                "texts and numbers with a unit stand in quotes, e.g. width = \"15 m\"".into()
            }
            Problem::WaterTwice => "keep [water] to work with the total weight and explicit pressures, or \
                 `buoyant_weight` to work with W'"
                .into(),
            Problem::NoWater => "add for example\n[water]\nlevel = \"7.1 m\"".into(),
            Problem::NoLevel => "add level = \"7.1 m\" for both sides, or left and right".into(),
            Problem::NoWaterDensity => "add for example density = \"1030 kg/m3\"".into(),
            Problem::NoAddedMass => "add sides = 1 or 2, or for example mass = \"50 t/m\"".into(),
            Problem::DeepAndLocal | Problem::NoWaveHeight => {
                "give either deep_water_height, or H13 and Hmax at the wall".into()
            }
            Problem::LevelAndSides | Problem::MassAndSides => "keep one of them".into(),
            Problem::ArmWithoutWeight => "the arm is that of W'; add buoyant_weight, or remove it".into(),
            Problem::Height { base_depth, crest_height, .. } => {
                format!("with them the height is {} m", base_depth + crest_height)
            }
            Problem::Syntax(_)
            | Problem::Mechanics(_)
            | Problem::KineticFriction { .. }
            | Problem::OneLevel { .. }
            | Problem::Densities { .. }
            | Problem::LevelOfWave { .. }
            | Problem::SidesWithoutWater
            | Problem::OneWaveHeight { .. }
            | Problem::CaissonWidth { .. }
            | Problem::Impossible { .. } => return None,
        };
        Some(help)
    }
}

/// A line of a case file that has `key` right.
fn example(key: &str) -> Option<&'static str> {
    Some(match key {
        "title" => "title = \"Caisson in air\"",
        "note" => "note = \"numbers from the preliminary design\"",
        "gravity" => "gravity = \"9.81 m/s2\"",
        "body" => "[body]\nwidth = \"15 m\"\nheight = \"12 m\"\ndensity = \"2.1 t/m3\"\nfriction = 0.6",
        "width" => "width = \"15 m\"",
        "height" => "height = \"12 m\"",
        "mass" => "mass = \"370 t/m\"",
        "density" => "density = \"2.1 t/m3\"",
        "friction" => "friction = 0.6",
        "load" => "[[load]]\nforce = \"450 kN/m\"\nelevation = \"8 m\"",
        "name" => "name = \"breaking wave\"",
        "force" => "force = \"450 kN/m\"",
        "elevation" => "elevation = \"8 m\"",
        "direction" => "direction = \"left\"",
        "kinetic_friction" => "kinetic_friction = 0.5",
        "centroid_offset" => "centroid_offset = \"0.4 m\"",
        "centroid_height" => "centroid_height = \"5 m\"",
        "moment_of_inertia" => "moment_of_inertia = \"9500 t m2/m\"",
        "base_left" => "base_left = \"7 m\"",
        "base_right" => "base_right = \"7 m\"",
        "buoyant_weight" => "buoyant_weight = \"2300 kN/m\"",
        "weight_arm" => "weight_arm = \"7.5 m\"",
        "level" => "level = \"7.1 m\"",
        "grows" => "grows = true",
        "horizontal" => "horizontal = 0.2    # of g, or \"2 m/s2\"",
        "vertical" => "vertical = -0.1    # of g, or \"-1 m/s2\"",
        "sides" => "sides = 1",
        "deep_water_height" => "deep_water_height = \"6.3 m\"",
        "H13" => "H13 = \"5.8 m\"",
        "Hmax" => "Hmax = \"8.05 m\"",
        "period" => "period = \"11.4 s\"",
        "sea_bottom_slope" => "sea_bottom_slope = 0.01",
        "water_depth" => "water_depth = \"10.1 m\"",
        "depth_above_berm" => "depth_above_berm = \"5.6 m\"",
        "base_depth" => "base_depth = \"7.1 m\"",
        "crest_height" => "crest_height = \"3.4 m\"",
        "berm_width" => "berm_width = \"8 m\"",
        "caisson_width" => "caisson_width = \"15 m\"",
        "angle_deg" => "angle_deg = 15",
        "turn_deg" => "turn_deg = 15",
        "water_density" => "water_density = \"1030 kg/m3\"",
        "impulsive" => "impulsive = true",
        "lambda" => "lambda = [1, 1, 1]",
        _ => return None,
    })
}

/// A problem, the file it is in, and where.
#[derive(Debug, Error)]
#[error("{problem}")]
pub struct CaseError {
    problem: Problem,
    source_code: Box<NamedSource<String>>,
    span: Span,
}

impl CaseError {
    pub(super) fn new(name: &str, text: &str, problem: Problem, span: Span) -> CaseError {
        let span = first_line(text, span);
        let source_code = Box::new(NamedSource::new(name, text.to_owned()));
        CaseError { problem, source_code, span }
    }

    /// What is wrong.
    pub fn problem(&self) -> &Problem {
        &self.problem
    }
}

/// The part of a span on its first line, so that a table is shown by its header and not as a whole.
fn first_line(text: &str, span: Span) -> Span {
    let line = text.get(span.clone()).and_then(|shown| shown.lines().next()).unwrap_or_default();
    span.start..span.start + line.len()
}

impl Diagnostic for CaseError {
    fn source_code(&self) -> Option<&dyn SourceCode> {
        let empty = matches!(self.problem, Problem::Empty { .. });
        (!empty).then_some(&*self.source_code as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let label = LabeledSpan::underline(self.span.clone());
        Some(Box::new(std::iter::once(label)))
    }

    fn help(&self) -> Option<Box<dyn std::fmt::Display + '_>> {
        Some(Box::new(self.problem.help()?))
    }
}
