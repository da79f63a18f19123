//! What can be wrong with a case, and how it is said in the file's own text.

use std::ops::Range as Span;

use miette::{Diagnostic, LabeledSpan, SourceCode};
use standfast::number::exact;
use standfast::section::{SectionError, Vertex};
use standfast::{InputError, Quantity};
use thiserror::Error;

use crate::excerpt::Excerpt;
use crate::key::{Id, Key, Kind, Range, Table};
use crate::layout::{digits, plain, shortened};
use crate::motion::MOTION_CRITERIA;
use crate::random::{RANDOM, RandomProblem, STORM};
use crate::suggest::closest;
use crate::units::{Dimension, Extent, UnitError};

/// What is wrong.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum Problem {
    /// There is nothing in the file.
    #[error("{name} is empty")]
    Empty {
        /// The file.
        name: String,
    },
    /// Wrong random numbers.
    #[error(transparent)]
    Random(Box<RandomProblem>),
    /// The text is not TOML.
    #[error("this is not valid TOML: {0}")]
    Syntax(String),
    /// A key that no case file has.
    #[error("{} has no key `{}`", table.header(), shortened(name))]
    UnknownKey {
        /// The table it is in.
        table: Table,
        /// The key.
        name: String,
    },
    /// A criterion of a result that is not computed.
    #[error("the criterion `{name}` asks for {of}, which an assessment of the first instant does not have")]
    Unanswerable {
        /// The criterion.
        name: &'static str,
        /// What it asks for.
        of: &'static str,
    },
    /// A key that has to be there.
    #[error("{} lacks `{}`", key.info().table.header(), key.entry())]
    MissingKey {
        /// The key.
        key: Key,
    },
    /// A table that has to be there.
    #[error("the case file lacks `{}`", table.name())]
    MissingTable {
        /// The table.
        table: Table,
    },
    /// A value of another type.
    #[error("`{}` is {found}; expected {expected}", key.entry())]
    WrongType {
        /// The key.
        key: Key,
        /// The type found.
        found: &'static str,
        /// The type expected.
        expected: &'static str,
    },
    /// Something else where a table should be.
    #[error("`{}` is {found}; expected {expected}", table.name())]
    NoTable {
        /// The table.
        table: Table,
        /// The type found.
        found: &'static str,
        /// The type expected.
        expected: &'static str,
    },
    /// A text that is no quantity of the kind needed.
    #[error("`{}` is {written}, and {error}; expected {}", key.entry(), dimension.map_or("a number", Dimension::words))]
    Unit {
        /// The key.
        key: Key,
        /// What it measures; `None` for a plain number.
        dimension: Option<Dimension>,
        /// The value as it stands in the file.
        written: String,
        /// What is wrong with it.
        error: UnitError,
    },
    /// A value that the key cannot have.
    #[error("`{}` is {written}; expected {expected}", key.entry())]
    OutOfRange {
        /// The key.
        key: Key,
        /// The value as it stands in the file, or the number that was tried.
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
    /// Positions of the wrong kind for the face.
    #[error("`{}` does not go with this face; expected `{}`", found.name(), expected.name())]
    WrongAlong {
        /// The key found.
        found: Key,
        /// The key that goes with the face.
        expected: Key,
    },
    /// Positions without pressures, or the other way round.
    #[error("`{}` and `pressure` have {positions} and {pressures} numbers; expected as many of each, two at least", along.name())]
    Lengths {
        /// The key of the positions.
        along: Key,
        /// How many positions.
        positions: usize,
        /// How many pressures.
        pressures: usize,
    },
    /// A pressure beside the face.
    #[error("`{}` has {}, which is beside the face; expected {} to {} m", along.name(), exact(*position), exact(*from), exact(*to))]
    BesideFace {
        /// The key of the positions.
        along: Key,
        /// The position, m.
        position: f64,
        /// Where the face begins, m.
        from: f64,
        /// Where it ends, m.
        to: f64,
    },
    /// A combination of a load that there is not.
    #[error("the case has no load called \"{name}\"")]
    UnknownLoad {
        /// The name.
        name: String,
        /// The names that there are.
        names: Vec<String>,
    },
    /// A combination of a name that several loads have.
    #[error(
        "several loads are called \"{name}\"; expected a name of its own for each that a combination names"
    )]
    SameName {
        /// The name.
        name: String,
    },
    /// A load with the name of what a table of the case gives.
    #[error(
        "a [[load]] or [[pressure]] is called \"{name}\", and so is what the case itself has of that name"
    )]
    TakenName {
        /// The name.
        name: String,
    },
    /// Two combinations of one name.
    #[error("another combination is called \"{name}\" as well; expected a name of its own for each")]
    SameCombination {
        /// The name.
        name: String,
    },
    /// The weight taken away.
    #[error(
        "the factor of the weight is 0; expected a factor above zero: a body without weight does not stand"
    )]
    NoWeight,
    /// A pressure over nothing.
    #[error("`{}` is {} throughout, where a pressure acts on nothing; expected positions that rise", along.name(), exact(*position))]
    NoExtent {
        /// The key of the positions.
        along: Key,
        /// The only position, m.
        position: f64,
    },
    /// Both are given.
    #[error("{} has both `{}` and `{}`", one.info().table.header(), one.name(), two.name())]
    Both {
        /// A key.
        one: Key,
        /// Another that says the same.
        two: Key,
    },
    /// None is given.
    #[error("{} has neither `{}` nor `{}`", one.info().table.header(), one.name(), two.name())]
    Neither {
        /// A key.
        one: Key,
        /// Another that would do.
        two: Key,
    },
    /// `load = []`.
    #[error("`{}` is an empty list", table.name())]
    NoTables {
        /// The table that may stand several times.
        table: Table,
    },
    /// What the body table says of a body of parts, beside them.
    #[error("[body] has `{}`, which follows from the parts", key.name())]
    FollowsFromParts {
        /// The key.
        key: Key,
    },
    /// A scale of parts that there are not.
    #[error("`width_scale` multiplies the widths of parts, and there is no [[part]]")]
    ScaleWithoutParts,
    /// A part without outline.
    #[error("the part has no outline")]
    NoOutline,
    /// Lists of corners that do not go together.
    #[error("`x` and `y` have {x} and {y} numbers; expected as many of each, three at least")]
    Corners {
        /// How many x.
        x: usize,
        /// How many y.
        y: usize,
    },
    /// An outline that is no part's.
    #[error("part {}: {error}", index + 1)]
    Part {
        /// Its place, from zero.
        index: usize,
        /// What is wrong with it.
        error: SectionError,
    },
    /// Parts that are no section.
    #[error("{}", parts(*.0))]
    Parts(SectionError),
    /// A key that a cylinder does not have.
    #[error("a cylinder has no `{key}`")]
    NotOfCylinder {
        /// The key.
        key: Key,
    },
    /// Parts of a cylinder.
    #[error("[[part]] does not go with `shape = \"cylinder\"`")]
    PartsOfCylinder,
    /// Goda's waves on a single object.
    #[error(
        "[wave] does not go with a single object, of a `length` or a cylinder: Goda's formulas are those of a long wall"
    )]
    WavesOnObject,
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
    #[error("[water] lacks `{}`; water on one side only has level 0 on the other", missing.name())]
    OneLevel {
        /// The key.
        missing: Key,
    },
    /// Both are given.
    #[error("[water] has `level`, for both sides, and one for a side")]
    LevelAndSides,
    /// Neither here nor with the waves.
    #[error("[water] lacks `density`, and there is no `water_density` in [wave] to take")]
    NoWaterDensity,
    /// Two values of one quantity.
    #[error("`{one}` is {one_value}, but `{two}` is {two_value}: they have to agree", one_value = with_unit(*one, *one_value), two_value = with_unit(*two, *two_value))]
    Disagree {
        /// A key.
        one: Key,
        /// Its value.
        one_value: f64,
        /// Another.
        two: Key,
        /// Its value, or what it makes.
        two_value: f64,
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
    /// Two widths of one caisson.
    #[error("`caisson_width` is {width} m, but the base of the body is {base} m wide")]
    CaissonWidth {
        /// Of the waves, m.
        width: f64,
        /// From O to O', m.
        base: f64,
    },
    /// Water whose mass is to be added, but there is none.
    #[error("`sides` counts sides with water, but there is neither [water] nor [wave]")]
    SidesWithoutWater,
    /// Both are given.
    #[error("[wave] has `deep_water_height` and a height at the wall")]
    DeepAndLocal,
    /// None is given.
    #[error("[wave] has no wave height")]
    NoWaveHeight,
    /// One of the heights at the wall.
    #[error("[wave] lacks `{}`; at the wall, both `H13` and `Hmax` are needed", missing.name())]
    OneWaveHeight {
        /// The key.
        missing: Key,
    },
    /// A ground of which nothing is said.
    #[error("[ground] says nothing of what the base bears")]
    EmptyGround,
    /// Keys of ground that is told in different ways.
    #[error("`{}` does not go with `{}`", key.entry(), with.entry())]
    NotWith {
        /// A key.
        key: Key,
        /// Another that says otherwise.
        with: Key,
    },
    /// A number of the envelope, of ground that is none.
    #[error("`{}` is a number of the envelope, and `law` is not \"envelope\"", key.entry())]
    NotEnvelope {
        /// The key.
        key: Key,
    },
    /// A number of ground with a friction angle, of which the law is an envelope.
    #[error("`{}` does not go with `law = \"envelope\"`", key.entry())]
    OfEnvelope {
        /// The key.
        key: Key,
    },
    /// A criterion of what the ground does not say.
    #[error("the criterion `{}` asks for {of}, and {lacks}", key.name())]
    NeedsGround {
        /// The criterion.
        key: Key,
        /// What it asks for.
        of: &'static str,
        /// What is not there.
        lacks: &'static str,
    },
    /// A load in time where nothing takes it.
    #[error(
        "`{key}` says how a load varies in time, which an elastic base takes, and [ground] has no {lacks}"
    )]
    HistoryOnRigid {
        /// The key.
        key: Id,
        /// What is not there.
        lacks: &'static str,
    },
    /// A permanent load that varies in time.
    #[error("`{key}` says how the load varies in time, and the load is permanent")]
    HistoryOfPermanent {
        /// The key.
        key: Id,
    },
    /// A course in time that is none.
    #[error(
        "the shape of the `history` is {written}; expected \"constant\", \"rect\", \"triangle\", \"decay\", \"church-roof\" or \"points\""
    )]
    HistoryShape {
        /// The value as it stands in the file.
        written: String,
        /// The one it resembles.
        suggestion: Option<&'static str>,
    },
    /// A number that a course in time does not have.
    #[error("a `history` of shape \"{shape}\" has no `{}`", shortened(name))]
    HistoryKey {
        /// The shape.
        shape: &'static str,
        /// The key.
        name: String,
        /// What it has.
        takes: &'static [&'static str],
    },
    /// What a course in time needs.
    #[error("the `history` lacks `{name}`")]
    HistoryLacks {
        /// The key.
        name: &'static str,
        /// A line that has it right.
        example: &'static str,
    },
    /// A number that a course in time cannot have.
    #[error("`{name}` of the `history` is {written}; expected {expected}")]
    HistoryValue {
        /// The key.
        name: &'static str,
        /// The value as it stands in the file.
        written: String,
        /// What it has to be.
        expected: &'static str,
    },
    /// A value that does not go with the others.
    #[error("`{}` is {}; expected {}", key.entry(), exact(.error.value), .error.expected)]
    Impossible {
        /// The key.
        key: Key,
        /// What the library says.
        error: InputError,
    },
    /// Numbers beyond what can be computed, by themselves or together.
    #[error("these numbers are too large or too small to be computed with: {} is {}; expected {}", .0.quantity, exact(.0.value), .0.expected)]
    Mechanics(InputError),
}

/// A value in the unit of plain numbers.
fn with_unit(key: Key, value: f64) -> String {
    key.info().dimension().map_or(exact(value), |dimension| format!("{} {}", exact(value), dimension.si()))
}

impl std::fmt::Display for Key {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        Id::from(*self).fmt(f)
    }
}

const SKELETON: &str = "a case file has a body and one or more loads, for example:\n\n\
    [body]\nwidth = \"15 m\"\nheight = \"12 m\"\ndensity = \"2.1 t/m3\"\nfriction = 0.6\n\n\
    [[load]]\nforce = \"450 kN/m\"\nelevation = \"8 m\"";

impl From<RandomProblem> for Problem {
    fn from(problem: RandomProblem) -> Problem {
        Problem::Random(Box::new(problem))
    }
}

impl Problem {
    /// What to do.
    fn help(&self) -> Option<String> {
        let help = match self {
            Problem::Random(_) => return None,
            Problem::Empty { .. } => SKELETON.to_owned(),
            Problem::NoTables { table } => format!("remove it, or add for example\n{}", table.example()),
            Problem::UnknownKey { table, name } => known(*table, name),
            Problem::Unanswerable { name, .. } if MOTION_CRITERIA.contains(name) => {
                "`standfast simulate` follows the motion of a case with a [motion], or whose loads have histories on a rigid base: \
                 of such a case it is a criterion"
                    .to_owned()
            }
            Problem::Unanswerable { .. } => format!(
                "it takes random inputs; the criteria that can be answered: {}",
                names(Table::Criteria).join(", ")
            ),
            Problem::MissingKey { key } => format!("add for example\n{}", line(*key)),
            Problem::MissingTable { table } => format!("add for example\n{}", table.example()),
            Problem::Unit { key, dimension, error, .. } => {
                let dimension = (*dimension)?;
                let (also, bare) = match key.info().kind {
                    Kind::InGravity => ("g, ", "g"),
                    _ => ("", dimension.si()),
                };
                let units = format!("the units understood here: {also}{}", dimension.understood());
                match error {
                    UnitError::Missing => format!("{units}; a number without quotes is in {bare}"),
                    UnitError::Unknown(unit) if *key == Key::Gravity && unit == "g" => {
                        format!("{units}; this key says what g is, for example {}", line(*key))
                    }
                    UnitError::Unknown(unit) => match other_extent(dimension, unit) {
                        Some(words) => format!("{units}; {words}"),
                        None => units,
                    },
                    _ => units,
                }
            }
            Problem::NoTable { table, .. } => format!("for example\n{}", table.example()),
            Problem::WrongType { key, .. } | Problem::OutOfRange { key, .. } => {
                format!("for example\n{}", line(*key))
            }
            Problem::AboveCrest { .. } => {
                "the elevation is measured from the base, in m if it has no unit".into()
            }
            Problem::Both { one: Key::Mass, .. } => {
                "keep one of them; the other follows from width and height".into()
            }
            Problem::Neither { one: Key::Mass, .. } => {
                "add one of them, for example density = \"2.1 t/m3\"".into()
            }
            Problem::Neither { .. } => "add sides = 1 or 2 for a wall, or the mass of water, for example \"50 t/m\", or \"200 kg\" of a single object".into(),
            Problem::Syntax(message) if message.contains("missing value") || message.contains("quot") => {
                "texts and numbers with a unit stand in quotes, e.g. width = \"15 m\"".into()
            }
            Problem::WaterTwice => "keep [water] to work with the total weight and explicit pressures, or \
                 `buoyant_weight` to work with W'"
                .into(),
            Problem::EmptyGround => "give strength, for a base that crushes; or friction_angle_deg and unit_weight, or law = \"envelope\" \
                 and centric_resistance, for ground that fails; or stiffness"
                .into(),
            Problem::NotWith { key: Key::Strength, with: Key::GroundAngle } => {
                "keep strength for stone, mortar or a pressure that is given; friction_angle_deg for ground that fails".into()
            }
            Problem::NotWith { .. } | Problem::OfEnvelope { .. } => "keep one of them".into(),
            Problem::NotEnvelope { .. } => "add law = \"envelope\", or remove it".into(),
            Problem::NeedsGround { key: Key::GreatestRotation, .. } => {
                "add for example\n[ground]\nstiffness = \"50 MN/m3\"".into()
            }
            Problem::NeedsGround { .. } => format!("add for example\n{}", Table::Ground.example()),
            Problem::HistoryOnRigid { .. } => {
                "add for example\n[ground]\nstiffness = \"50 MN/m3\"\ntangential_stiffness = \"25 MN/m3\"".into()
            }
            Problem::HistoryOfPermanent { .. } => "keep one of them".into(),
            Problem::HistoryShape { suggestion, .. } => {
                let line = "for example { shape = \"triangle\", rise = \"0.05 s\", duration = \"0.1 s\" }; shapes are of straight lines, others \
                            are given by their points";
                suggestion.map_or(line.to_owned(), |word| format!("did you mean \"{word}\"? {line}"))
            }
            Problem::HistoryKey { name, takes, .. } => {
                let known: Vec<_> = ["shape"].iter().chain(takes.iter()).chain(&["peak", "start"]).copied().collect();
                let line = format!("it has {}", known.join(", "));
                closest(name, known.iter().copied()).map_or(line.clone(), |word| format!("did you mean `{word}`? {line}"))
            }
            Problem::HistoryLacks { example, .. } => format!("add for example {example}"),
            Problem::NoWater => "add for example\n[water]\nlevel = \"7.1 m\"".into(),
            Problem::NoLevel => "add level = \"7.1 m\" for both sides, or left and right".into(),
            Problem::NoWaterDensity => "add for example density = \"1030 kg/m3\"".into(),
            Problem::DeepAndLocal | Problem::NoWaveHeight => {
                "give either deep_water_height, or H13 and Hmax at the wall".into()
            }
            Problem::WrongAlong { .. } => {
                "a side has elevations above the base; base and top have distances to the right \
                 of the corner O"
                    .into()
            }
            Problem::TakenName { .. } => "call the load otherwise".into(),
            Problem::BesideFace { .. } => "cut the diagram where the face ends".into(),
            Problem::UnknownLoad { name, names } => {
                let known = format!(
                    "the loads of this case: {}; a [[load]] or [[pressure]] has its `name`",
                    names.join(", ")
                );
                match closest(name, names.iter().map(String::as_str)) {
                    Some(suggestion) => format!("did you mean `{suggestion}`? {known}"),
                    None => known,
                }
            }
            Problem::FollowsFromParts { .. } => {
                "remove it; to vary the width of all parts, give `width_scale`".into()
            }
            Problem::ScaleWithoutParts => "remove it; a body of one piece has its `width`".into(),
            Problem::NoOutline => {
                "give left, width, bottom and height, for a rectangle or, with top_left and top_width, a trapezoid; or the \
                 corners of a polygon, x and y"
                    .into()
            }
            Problem::Parts(SectionError::Gap { .. } | SectionError::Overlap { .. }) => {
                "parts touch each other, to the millimetre; what is empty between them is a part of density 0".into()
            }
            Problem::Parts(SectionError::Loose { .. }) => "parts stand on each other along a length".into(),
            Problem::NotOfCylinder { key: Key::WaterLeft } => {
                "water stands around it: give `level` in place of left and right".into()
            }
            Problem::NotOfCylinder { key: Key::WetSides } => {
                "`sides` are those of a long wall; give the `mass` of the water that moves with it".into()
            }
            Problem::NotOfCylinder { key } if key.info().table == Table::Ground => {
                "what is known of the ground here are formulas of a strip: leave out [ground], or describe a block with its `length`"
                    .into()
            }
            Problem::NotOfCylinder { .. } => {
                "its `width` is its diameter, and it stands on the whole of its circle".into()
            }
            Problem::WavesOnObject => {
                "describe one metre of a long wall; or give the forces on the object as [[load]]s".into()
            }
            Problem::PartsOfCylinder => {
                "leave out the shape, or describe the cylinder by its width, height and mass".into()
            }
            Problem::LevelAndSides | Problem::Both { .. } => "keep one of them".into(),
            Problem::ArmWithoutWeight => "the arm is that of W'; add buoyant_weight, or remove it".into(),
            Problem::Disagree { .. } => "keep one of them, or make them equal".into(),
            Problem::Height { base_depth, crest_height, .. } => {
                format!("with them the height is {} m", plain(base_depth + crest_height))
            }
            Problem::Syntax(_)
            | Problem::Mechanics(_)
            | Problem::KineticFriction { .. }
            | Problem::OneLevel { .. }
            | Problem::Lengths { .. }
            | Problem::Corners { .. }
            | Problem::Part { .. }
            | Problem::Parts(_)
            | Problem::NoExtent { .. }
            | Problem::SameName { .. }
            | Problem::SameCombination { .. }
            | Problem::NoWeight
            | Problem::SidesWithoutWater
            | Problem::OneWaveHeight { .. }
            | Problem::CaissonWidth { .. }
            | Problem::HistoryValue { .. }
            | Problem::Impossible { .. } => return None,
        };
        Some(help)
    }

    /// What a number has to be that is not in a key's range.
    pub(crate) fn out_of_range(key: Key, range: Range, number: f64) -> Problem {
        Problem::OutOfRange { key, written: plain(number), expected: range.words() }
    }
}

/// A line of a file that has a key right.
fn line(key: Key) -> String {
    format!("{} = {}", key.entry(), key.info().example)
}

/// What is wrong with parts together, counted from one as they stand in the file.
fn parts(error: SectionError) -> String {
    let place = |at: Vertex| format!("x = {} m, {} m above the base", digits(at.x), digits(at.y));
    match error {
        SectionError::Overlap { one, two, at, by } => {
            format!("parts {} and {} overlap by {} m, at {}", one + 1, two + 1, digits(by), place(at))
        }
        SectionError::Gap { at, by } => {
            format!("the parts leave a gap of {} m, at {}", digits(by), place(at))
        }
        SectionError::Loose { at } => {
            format!(
                "what lies above {} m does not stand on what is below it, at x = {} m",
                digits(at.y),
                digits(at.x)
            )
        }
        SectionError::BelowBase { depth } => {
            format!("the part reaches {} m below the base, which is at height 0", digits(depth))
        }
        SectionError::NotOnBase { height: 0.0 } => {
            "the body touches its base, at height 0, in a point; expected a length to stand on".to_owned()
        }
        SectionError::NotOnBase { height } => {
            format!("the lowest part begins {} m above the base, which is at height 0", digits(height))
        }
        SectionError::Input(error) if error.quantity == Quantity::CentroidOffset => format!(
            "the centre of mass lies {} m to the {} of mid-width, not between the corners of the base",
            digits(error.value.abs()),
            if error.value < 0.0 { "left" } else { "right" }
        ),
        error => format!("the parts make no body: {error}"),
    }
}

/// What to do about a unit of whole objects in a case per metre run, and the other way round.
fn other_extent(dimension: Dimension, unit: &str) -> Option<&'static str> {
    const PER_METRE: [Dimension; 3] = [Dimension::Mass, Dimension::Force, Dimension::Inertia];
    let fits = |dimension: Dimension| dimension.parse(&format!("1 {unit}")).is_ok();
    let per_metre = PER_METRE.into_iter().find(|of| Extent::Whole.of(*of) == dimension);
    if PER_METRE.contains(&dimension) && fits(Extent::Whole.of(dimension)) {
        Some("all is per metre run; a single object has its `length` in [body]")
    } else if per_metre.is_some_and(fits) {
        Some("[body] has a `length` or is a cylinder, so all is of the whole object")
    } else {
        None
    }
}

/// Criteria of results that are not computed, and what they ask for.
pub(crate) const UNANSWERABLE: [(&str, &str); 4] = [
    ("slide", "how far the body slides"),
    ("max_theta", "how far the body turns"),
    ("overturned", "whether the body overturns in the end"),
    ("p_not_rest", "a probability"),
];

/// The names that a table of a file may have: its keys, and at the top the tables.
pub(crate) fn names(table: Table) -> Vec<&'static str> {
    let mut names: Vec<_> = table.keys().map(Key::entry).collect();
    names.dedup();
    if table == Table::Top {
        names.extend(Table::ALL.into_iter().map(Table::name).filter(|name| !name.is_empty()));
        names.extend([RANDOM, STORM]);
    }
    names
}

fn known(table: Table, name: &str) -> String {
    let names = names(table);
    let known = format!("the keys understood here: {}", names.join(", "));
    match closest(name, names.iter().copied()) {
        Some(suggestion) => format!("did you mean `{suggestion}`? {known}"),
        None => known,
    }
}

/// Where in a case something is wrong.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// The value under a key.
    Key(Id),
    /// A table of its kind, by its place among them.
    Table(Table, usize),
}

impl From<Key> for Place {
    fn from(key: Key) -> Place {
        Place::Key(key.into())
    }
}

impl From<Id> for Place {
    fn from(id: Id) -> Place {
        Place::Key(id)
    }
}

impl From<Table> for Place {
    fn from(table: Table) -> Place {
        Place::Table(table, 0)
    }
}

/// A problem of typed inputs, and where it is.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{problem}")]
pub struct Fault {
    /// What is wrong.
    pub problem: Problem,
    /// Where.
    pub at: Place,
    /// The other place, where two do not agree.
    pub and: Option<Place>,
}

impl Fault {
    pub(crate) fn new(problem: Problem, at: impl Into<Place>) -> Fault {
        Fault { problem, at: at.into(), and: None }
    }

    pub(crate) fn and(self, place: impl Into<Place>) -> Fault {
        Fault { and: Some(place.into()), ..self }
    }
}

/// A problem, the file it is in, and where.
#[derive(Debug, Error)]
#[error("{problem}")]
pub struct CaseError {
    problem: Problem,
    source_code: Box<Excerpt>,
    spans: Vec<Span<usize>>,
}

impl CaseError {
    pub(crate) fn new(name: &str, text: &str, problem: Problem, spans: Vec<Span<usize>>) -> CaseError {
        let spans = spans.into_iter().map(|span| first_line(text, span)).collect();
        let (source_code, spans) = Excerpt::new(name, text, spans);
        CaseError { problem, source_code: Box::new(source_code), spans }
    }

    /// What is wrong.
    pub fn problem(&self) -> &Problem {
        &self.problem
    }
}

/// The part of a span on its first line, so that a table is shown by its header and not as a whole.
fn first_line(text: &str, span: Span<usize>) -> Span<usize> {
    let line = text.get(span.clone()).and_then(|shown| shown.lines().next()).unwrap_or_default();
    span.start..span.start + line.len()
}

impl Diagnostic for CaseError {
    fn source_code(&self) -> Option<&dyn SourceCode> {
        let empty = matches!(self.problem, Problem::Empty { .. });
        (!empty).then_some(&*self.source_code as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        Some(Box::new(self.spans.iter().cloned().map(LabeledSpan::underline)))
    }

    fn help(&self) -> Option<Box<dyn std::fmt::Display + '_>> {
        Some(Box::new(self.problem.help()?))
    }
}

/// What a key takes, as the type that is expected of its value.
pub(crate) fn expected_type(kind: Kind) -> &'static str {
    match kind {
        Kind::Text => "a text in quotes",
        Kind::Measured(..) | Kind::InGravity => "a number, or a text with a number and its unit",
        Kind::Plain(_) => "a number without unit or quotes",
        Kind::OneOfThree => "a list of three numbers",
        Kind::Truth => "true or false",
        Kind::Sides => "1 or 2",
        Kind::Choice { words, .. } => words,
        Kind::List(_) => "a list of numbers, each plain or in quotes with its unit",
        Kind::Factors => "names of loads with their factors, in braces",
        Kind::History => "a shape with its numbers, in braces",
        Kind::ModeList => "a list of symbols of modes in quotes",
    }
}
