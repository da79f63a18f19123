//! Advice on what is wrong with a case.

use standfast::Quantity;
use standfast::section::{SectionError, Vertex};
use standfast_motion::MotionError;

use super::Problem;
use crate::code_file::OF_CODES;
use crate::datum::LevelFault;
use crate::digits::{digits, plain};
use crate::inputs::GRAVITY;
use crate::key::MOTION_CRITERIA;
use crate::key::{Key, Kind, Range, Table};
use crate::random::RANDOM;
use crate::suggest::{closest, closest_key};
use crate::typed::number_and_rest;
use crate::units::{Dimension, Extent, UnitError};

const SKELETON: &str = "a case file has a body and one or more loads, for example:\n\n\
    [body]\nwidth = \"15 m\"\nheight = \"12 m\"\ndensity = \"2.1 t/m3\"\nfriction = 0.6\n\n\
    [[load]]\nforce = \"450 kN/m\"\nelevation = \"8 m\"";

/// Names that follow each other, each once.
fn each_once(names: &[&'static str]) -> Vec<&'static str> {
    let mut once = names.to_vec();
    once.dedup();
    once
}

impl Problem {
    /// Advice on the problem.
    pub fn help(&self) -> Option<String> {
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
                "the criteria that can be answered: {}",
                names(Table::Criteria).join(", ")
            ),
            Problem::NoChance { help: Some(help), .. } => help.clone(),
            Problem::NoChance { .. } => {
                "say by which law a number is random, for example\n[random]\nfriction = { normal = { mean = 0.6, sd = 0.1 } }".into()
            }
            Problem::MissingKey { key: Key::HistoryShape, .. } => format!("the shapes: {}", shapes()),
            Problem::MissingKey { key: Key::AngularFrequency, .. } => "or give `period`".into(),
            Problem::MissingKey { key, .. } => format!("add for example\n{}", line(*key)),
            Problem::MissingTable { table } => format!("add for example\n{}", table.example()),
            Problem::Unit { key, dimension, written, error } => {
                let dimension = (*dimension)?;
                let is_shaking = key.info().kind.is_of_shaking();
                let also = if is_shaking { "g, " } else { "" };
                let units = format!("the units understood here: {also}{}", dimension.understood());
                match error {
                    UnitError::Missing if is_shaking => {
                        let number = written.trim_matches(['"', '\'']);
                        format!("write \"{number} g\" or \"{number} m/s2\", whichever is meant")
                    }
                    UnitError::Missing => {
                        format!("{units}; a number without quotes is in {}", dimension.si())
                    }
                    UnitError::Unknown(unit) if *key == Key::Gravity && unit == "g" => {
                        format!("{units}; this key says what g is, for example {}", line(*key))
                    }
                    UnitError::Unknown(unit) => {
                        let extent = other_extent(dimension, unit).or_else(|| ambiguous(dimension, unit)).map(str::to_owned);
                        match extent.or_else(|| weight_for_mass(dimension, written)) {
                            Some(words) => format!("{units}; {words}"),
                            None => units,
                        }
                    }
                    _ if *key == Key::WaveHeight => format!("{units}; or \"Hmax\" or \"H13\", the height that [wave] has"),
                    _ => units,
                }
            }
            Problem::NoTable { table, .. } => format!("for example\n{}", table.example()),
            Problem::OutOfRange { key, written, .. } if known_word(*key, written).is_some() => {
                format!("did you mean \"{}\"?", known_word(*key, written)?)
            }
            Problem::WrongType { key, .. } | Problem::OutOfRange { key, .. } => {
                format!("for example\n{}", line(*key))
            }
            Problem::AboveCrest { key: Key::Elevation, .. } => "the elevation is measured from the base, in m if it has no unit; \
                 of a force on something that stands on the body, say on what: lever = \"bollard hook\""
                .into(),
            Problem::AboveCrest { .. } => {
                "the elevation is measured from the base, in m if it has no unit".into()
            }
            Problem::Both { one: Key::Mass, .. } => {
                "keep one of them; the other follows from width and height".into()
            }
            Problem::Neither { one: Key::Mass, .. } => {
                "add one of them, for example density = \"2.1 t/m3\"".into()
            }
            Problem::Neither { one: Key::BasePolygon, .. } => {
                "say where the body stands: polygon, feet or circle; without [base] it stands on its width and length".into()
            }
            Problem::Neither { .. } => "add sides = \"right\" or \"both\" for a wall, or the mass of water, for example \"50 t/m\", or \"200 kg\" of a single object".into(),
            Problem::Syntax { message, line } => syntax(message, line)?,
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
            Problem::HistoryKey { takes, shape, .. } => format!("\"{shape}\" has {}", takes.join(", ")),
            Problem::SineOnSprings { .. } => "give it by its points".into(),
            Problem::Record { help, .. } => (*help)?.into(),
            Problem::ByOtherWaves { .. } => "say how long the thrust lasts, for example duration = \"0.4 s\"".into(),
            Problem::HoldsNot { .. } => "leave one of both out".into(),
            Problem::SameJoint { name } if name == "base" => {
                "joint 1 is called base; give this one another name".into()
            }
            Problem::SameJoint { .. } => "give each a name of its own".into(),
            Problem::PlanNotFor { .. } => {
                "leave one of both out: without [base], `centroid_z`, `z`, `direction_deg` and `horizontal_z` the case lies in the plane of its section"
                    .into()
            }
            Problem::PlanNeedsLength => "`length` of [body] makes it one thing, whose forces are whole: length = \"1.0 m\"".into(),
            Problem::PlanShape { .. } | Problem::CentroidBesideBase { .. } => {
                "x counts from mid-width, of parts from the origin of their section; z from the middle of the length, away from the viewer".into()
            }
            Problem::TorsionNotFor { .. } => {
                "loads that pass through the vertical of the centre of mass do not turn the body: `z` = `centroid_z`, or `distance` to it; and one direction at one \
                 height"
                    .into()
            }
            Problem::JointsNotFor { .. } => {
                "leave one of both out: without [[joint]] the parts are one body".into()
            }
            Problem::JointsOfChance { .. } => "leave out joints that `assess` finds far from their limits".into(),
            Problem::JointsOfBlock { .. } => "draw the section with [[part]]; mass, centre and inertia follow".into(),
            Problem::JointAboveCrest { .. } | Problem::SameLevel { .. } => {
                "`elevation` is measured from the base, which is joint 1, in m if it has no unit".into()
            }
            Problem::Cut(_) => "a joint needs a length on which what is above touches what is below".into(),
            Problem::BesideJoint { .. } => "put `left` and `right` of the joint where it touches, or leave them out".into(),
            Problem::BesideContact { .. } | Problem::NoJoint { .. } => "lengths are to the right of the origin of the section, in m if they have no unit; of O without parts".into(),
            Problem::JointWater { .. } => {
                "\"open\": from the pressure outside at one end to that at the other; \"tight\": none. An open joint leaves rest the \
                 sooner: say \"tight\" only of a joint that keeps water out"
                    .into()
            }
            Problem::NothingOpen { .. } => {
                "add [water] or [wave]; or give the pressures: uplift_left = \"0 kPa\", uplift_right = \"30 kPa\"".into()
            }
            Problem::TooManyResistances { .. } => "add up those that act at one place".into(),
            Problem::SameResistance { .. } => "call each otherwise".into(),
            Problem::ShareMissing { .. } => {
                "a passive soil moves 5 to 10 times as far as an active one before it resists with all; for example share = 0.5".into()
            }
            Problem::ShareOfPush { .. } => "leave it out".into(),
            Problem::NotOfPassive { key: Key::BackfillSurcharge, .. } => {
                "what stands on the ground may be gone: leave it out, or give the soil as a [[resistance]]".into()
            }
            Problem::NotOfPassive { .. } => "give it as a [[resistance]], with a limit of your own".into(),
            Problem::Level { fault: LevelFault::NoDatum(name), .. } => {
                format!("add, above all tables, datum = {{ base = \"-8.20 m\", name = \"{name}\" }}, with the level of the base")
            }
            Problem::Level { fault: LevelFault::Other(datum), .. } => format!("write the level with {datum}, for example \"+4.10 m{datum}\""),
            Problem::Level { fault: LevelFault::NoLevel, .. } => "write its length".into(),
            Problem::Level { fault: LevelFault::NoSea, .. } => {
                "add level to [water], or still_water to [wave], above the base or as a level".into()
            }
            Problem::NotOfFormula { takes, formula, .. } => format!("\"{formula}\" has {}", each_once(takes).join(", ")),
            Problem::ByWavesShape { .. } => "shape = \"triangle\"".into(),
            Problem::HeldShaking => {
                "in place of [earthquake] say how the base moves, by a record or by a pulse as\n[motion.base]\n\
                 horizontal = { shape = \"half-sine\", peak = \"0.3 g\", duration = \"0.5 s\" }"
                    .into()
            }
            Problem::ShakenTwice => "leave one of them out".into(),
            Problem::MovingOnCrushing { .. } => "leave it out, and the body moves on a rigid base".into(),
            Problem::Motion(MotionError::NoHistory { .. }) => {
                "history = { shape = \"triangle\", rise = \"0.2 s\", duration = \"0.4 s\" }, or permanent = true".into()
            }
            Problem::Motion(MotionError::WaterWithoutHeight { .. }) => {
                "add its height above the base, for example elevation = \"4 m\"; or sides in place of mass".into()
            }
            Problem::NoCase { table: Table::Block } => "`standfast simulate` follows it".into(),
            Problem::NoCase { .. } => "`standfast probability` answers it".into(),
            Problem::TableInTime => "`standfast batch` follows the motion of every row; in Python `standfast.motions` does".into(),
            Problem::NoInertia => {
                "(1 + d²)/3 is taken for b1 = b2 = 1 only, a uniform block; else give I/m about C, rho2".into()
            }
            Problem::DrySide { .. } | Problem::WhichSide { .. } => "say sides = \"left\", \"right\" or \"both\"".into(),
            Problem::NoWater => "add for example\n[water]\nlevel = \"7.1 m\"".into(),
            Problem::NoLevel => "add level = \"7.1 m\" for both sides, or left and right".into(),
            Problem::NoWaterDensity => "add for example density = \"1030 kg/m3\"".into(),
            Problem::DeepAndLocal | Problem::NoWaveHeight => {
                "give either deep_water_height, or H13 and Hmax at the wall".into()
            }
            Problem::SteepnessOfNothing => "give `period`, or `deep_water_height` in place of the heights at the wall".into(),
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
            Problem::OneWaveHeight { missing: Key::H13 } => {
                "H13 is Hmax/1.8 where no wave breaks; it has little influence on the pressures".into()
            }
            Problem::OneWaveHeight { .. } => {
                "Hmax is 1.8 times H13 where no wave breaks; give `deep_water_height` in place of both, and both follow".into()
            }
            Problem::Unread { .. } => "it is looked for beside the case file".into(),
            Problem::InCombination { problem, .. } => return problem.help(),
            Problem::NoKeyCalled { name, by, names } => {
                let also = match by {
                    Key::CombinationSet => "a key of one of its tables is called as --vary calls it",
                    _ => "the numbers of the case are called as --vary calls them",
                };
                let known = format!("{also}: {}", names.join(", "));
                match closest_key(name, names.iter().map(String::as_str)) {
                    Some(suggestion) => format!("did you mean `{suggestion}`? {known}"),
                    None => known,
                }
            }
            Problem::NoNumber { .. } => "give it another value under `set`".into(),
            Problem::NoStrength { names, .. } => {
                format!("the strengths of this case: {}; multiply any number under `scale`", names.join(", "))
            }
            Problem::NamedTwice { .. } => "name each number once, by its short name or by its key".into(),
            Problem::UnknownResistance { names, .. } => {
                format!("the resistances: {}; a strength is divided under `materials`", names.join(", "))
            }
            Problem::NoBearing => "give [ground] a strength, a friction angle or an envelope, or take `bearing` out".into(),
            Problem::CriterionOfAll { .. } => "ask it in [criteria]".into(),
            Problem::PartialFactor { .. } | Problem::SetAndRandom { .. } => {
                "give the case of the probability a file of its own, without it".into()
            }
            Problem::Pairs { .. } => "give one factor for each load, in a combination each".into(),
            Problem::TooManyPairs { .. } => {
                "give one factor each to loads of which it is plain whether they help or harm".into()
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
            Problem::SaturatedWeightMissing { .. } => {
                format!("add for example\n{}", line(Key::SaturatedWeight))
            }
            Problem::SoilFloats { .. } => {
                "it is the weight of the soil with the water in it; of an effective unit weight add that of water".into()
            }
            Problem::SoilBesideLayers { .. } => "write it in each [[backfill.layer]]".into(),
            Problem::MadeName { name } => format!("call it otherwise than {name}"),
            Problem::TooSteepForEarthquake { .. } => {
                "no formula holds beyond: a flatter ground or a smaller acceleration; or its pressure as a [[pressure]]".into()
            }
            Problem::CodeOption { name: "ground", .. } => "options = { ground = \"rock\" }".into(),
            Problem::CodeOption { .. } => {
                "options = { p_f = 0.05, water = \"deep\", model_tests = false, sigma = 0.05 }".into()
            }
            Problem::NoCodeOption { names, .. } if names.is_empty() => "leave it out".into(),
            Problem::NoCodeOption { names, .. } => format!("it has {}", names.join(", ")),
            Problem::NotOfCodes { .. } => {
                let names: Vec<_> = OF_CODES.iter().map(|key| key.name()).collect();
                format!("it has {}; all else stands in the combination", names.join(", "))
            }
            Problem::NameOfCode { names, .. } => {
                format!("names there: {}; what one case alone has goes into its combination", names.join(", "))
            }
            Problem::NamelessLoad => "name = \"crane\"".into(),
            Problem::TiltedFloor { .. } => {
                "leave floor_deg out, or enter what acts as a [[load]] or a [[pressure]] on a face".into()
            }
            Problem::OpeningNotFor { .. } => "opening = \"closed\" keeps the straight line of pressure".into(),
            Problem::FilledSide { side } => {
                let other = if *side == "right" { "left" } else { "right" };
                format!("sides = \"{other}\"; the water in the soil follows from `pore_water`")
            }
            Problem::Mechanics(_)
            | Problem::TooManyTables { .. }
            | Problem::SlopeBeyondFriction { .. }
            | Problem::WallFrictionBeyondFriction { .. }
            | Problem::LayersShort { .. }
            | Problem::DrainBesideBase { .. }
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
            | Problem::CaissonWidth { .. }
            | Problem::WallBeyondBase { .. }
            | Problem::History { .. }
            | Problem::BothIn { .. }
            | Problem::ByWavesRise { .. }
            | Problem::RatioOfOtherLaw
            | Problem::RestitutionOfNone
            | Problem::AskedToOverturn
            | Problem::Motion(_)
            | Problem::NotOfBlock { .. }
            | Problem::MissingTableIn { .. }
            | Problem::Impossible { .. }
            | Problem::Bias { .. } => return None,
        };
        Some(help)
    }

    /// Problem of a number that is not in a key's range.
    pub fn out_of_range(key: Key, range: Range, number: f64) -> Problem {
        Problem::OutOfRange { key, written: plain(number), expected: range.words() }
    }
}

/// A line of a file that has a key right.
pub(super) fn line(key: Key) -> String {
    format!("{} = {}", key.entry(), key.info().example)
}

/// Fault of parts together, counted from one as they stand in the file.
pub fn parts(error: SectionError) -> String {
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

/// Advice on a unit of whole objects in a case per metre run, and the other way round.
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

/// What to write in place of a unit that is one thing to the one and another to the other.
fn ambiguous(dimension: Dimension, unit: &str) -> Option<&'static str> {
    use Dimension::{Force, Mass, Moment, Pressure, WholeForce, WholeMass, WholeMoment};
    let is_force = matches!(dimension, Force | WholeForce | Moment | WholeMoment | Pressure);
    if !is_force && !matches!(dimension, Mass | WholeMass) {
        return None;
    }
    Some(match unit {
        "t" | "t/m" | "t/m2" | "t/m²" if is_force => {
            "t is a mass: a force of so many tonnes is in tf, tf/m or tf/m2"
        }
        "kg" | "kg/m" | "kg/m2" | "kg/cm2" if is_force => {
            "kg is a mass: a force of so many is in kgf, kgf/m or kgf/cm2"
        }
        "lb" | "lb/ft" | "lb/ft2" => "lb may be a mass or a force: a force is in lbf, lbf/ft or psf",
        "ton" | "tons" | "ton/m" => "a ton may be 1000 kg, 2000 lb or 2240 lb: write t for 1000 kg",
        _ => return None,
    })
}

/// The names that a table of a file may have: its keys, and at the top the tables.
pub fn names(table: Table) -> Vec<&'static str> {
    let mut names: Vec<_> = table.keys().map(Key::entry).collect();
    names.dedup();
    if table == Table::Top {
        names.extend(Table::Top.children().map(Table::name));
        names.push(RANDOM);
    } else {
        names.extend(table.children().map(Table::name));
    }
    names
}

/// The shapes of histories.
fn shapes() -> &'static str {
    expected_type(Key::HistoryShape.info().kind)
}

/// What to write in place of a line that is no TOML.
fn syntax(message: &str, line: &str) -> Option<String> {
    let line = without_comment(line).trim();
    let quoted = |text: &str| format!("texts and numbers with a unit stand in quotes, e.g. {text}");
    if message.contains("duplicate key") {
        let words = "a key stands once in its table, and a table once in a file: keep one of the lines, or put those of both tables \
            under one header";
        return Some(words.to_owned());
    }
    if line.contains(['“', '”', '„', '‘', '’', '«', '»']) {
        return Some("quotes are straight: \"15 m\"".to_owned());
    }
    if line.starts_with('[') {
        let words = "the name of a table stands in brackets, with a point between its parts: [body], [[load]], [motion.base]";
        return Some(words.to_owned());
    }
    if line.matches('"').count() % 2 == 1 {
        return Some("a quote is missing, at the beginning or at the end of the text".to_owned());
    }
    let (key, value) = line.split_once('=').map(|(key, value)| (key.trim(), value.trim()))?;
    let is_number = value.starts_with(|letter: char| letter.is_ascii_digit() || "+-−.,".contains(letter));
    Some(match number_and_rest(value) {
        Ok((number, "")) => {
            format!("decimals take a point, with a digit on each side: {key} = {}", plain(number))
        }
        Ok((number, unit)) => quoted(&format!("{key} = \"{} {unit}\"", plain(number))),
        Err(_) if is_number => "a point stands before decimals, nothing between thousands".to_owned(),
        Err(_) if message.contains("missing value") || message.contains("quot") => quoted("width = \"15 m\""),
        Err(_) => return None,
    })
}

/// A line without its comment; one in quotes is none.
fn without_comment(line: &str) -> &str {
    let begins = |at: &usize| line[..*at].matches('"').count().is_multiple_of(2);
    let at = line.match_indices('#').map(|(at, _)| at).find(begins);
    &line[..at.unwrap_or(line.len())]
}

/// The density whose unit weight was written: 25 kN/m3 is 2.548 t/m3.
fn weight_for_mass(dimension: Dimension, written: &str) -> Option<String> {
    let weight = Dimension::UnitWeight.parse(written.trim_matches(['"', '\''])).ok()?;
    let density = digits(weight / GRAVITY / 1e3);
    (dimension == Dimension::Density)
        .then(|| format!("a unit weight over gravity is a density, \"{density} t/m3\""))
}

/// The word of a key that a written one resembles.
pub(super) fn known_word(key: Key, written: &str) -> Option<&'static str> {
    let Kind::Choice { of, .. } = key.info().kind else { return None };
    closest(written.trim_matches('"'), of.iter().copied())
}

fn known(table: Table, name: &str) -> String {
    let names = names(table);
    let known = format!("the keys understood here: {}", names.join(", "));
    /// A key of more tables than these tells nothing by them.
    const FEW: usize = 3;
    // One that stands in another table as it is written is no slip of a letter; a table's name at the top may be.
    let others = Table::ALL
        .into_iter()
        .filter(|other| ![table, Table::Soil].contains(other) && names_keys(*other, name));
    let others: Vec<&str> = others.map(|other| other.header()).collect();
    let belongs = match others.as_slice() {
        [] => None,
        [one] => Some(format!("`{name}` belongs in {one}")),
        [first @ .., last] => Some(format!("`{name}` belongs in {} or {last}", first.join(", "))),
    };
    let belongs = belongs.filter(|_| others.len() <= FEW);
    let meant = meant_key(table, name).map(|suggestion| format!("did you mean `{suggestion}`?"));
    match if table == Table::Top { (meant, belongs) } else { (belongs, meant) } {
        (Some(words), _) | (None, Some(words)) if words.ends_with('?') => format!("{words} {known}"),
        (Some(words), _) | (None, Some(words)) => format!("{words}; {known}"),
        (None, None) => known,
    }
}

fn names_keys(table: Table, name: &str) -> bool {
    table.keys().any(|key| key.entry() == name)
}

/// The name of a table that a written one resembles.
pub(super) fn meant_key(table: Table, name: &str) -> Option<&'static str> {
    closest(name, names(table))
}

/// Type of value that a key takes, in words.
pub fn expected_type(kind: Kind) -> &'static str {
    match kind {
        Kind::Text | Kind::File => "a text in quotes",
        Kind::Measured(..) => "a number, or a text with a number and its unit",
        Kind::InGravity | Kind::Reached => "a text with a number and its unit, as \"0.2 g\"",
        Kind::Plain(_) => "a number without unit or quotes",
        Kind::OneOf(2, _) => "a list of two numbers",
        Kind::OneOf(..) => "a list of three numbers",
        Kind::Truth => "true or false",
        Kind::Choice { words, .. } => words,
        Kind::Unit(_) => "the name of a unit, in quotes",
        Kind::List(_) => "a list of numbers, each plain or in quotes with its unit",
        Kind::Pairs(_) => "a list of pairs [x, z], each number plain or in quotes with its unit",
        Kind::Factors => "names of loads with their factors, in braces",
        Kind::Settings => "names of keys with their values, in braces",
        Kind::Ratios => "names with their numbers, in braces",
        Kind::Spreads => "a share, or names with their shares, in braces",
        Kind::Places => "names with a point [x, y] of each, in braces",
        Kind::Bounds => "criteria with their bounds, in braces",
        Kind::Exceedances => "{ slide = \"0.3 m\", at_most = 0.1 }, or a list of such",
        Kind::Plains => "a list of numbers",
        Kind::ModeList => "a list of symbols of modes in quotes",
    }
}
