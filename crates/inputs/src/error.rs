//! Errors of a case, and the way they are shown in the file's own text.

mod cure;
mod fault;
mod help;

use standfast::footprint::FootprintError;
use standfast::number::{exact, reached};
use standfast::section::{CutError, SectionError};
use standfast::{HistoryError, InputError};
use standfast_motion::MotionError;
use thiserror::Error;

use crate::datum::LevelFault;
use crate::digits::{digits, shortened};
use crate::key::{Id, Key, Table};
use crate::random::RandomProblem;
use crate::units::{Dimension, UnitError};

pub use cure::Cure;
pub use fault::{CaseError, Fault, Place};
use help::parts;
pub use help::{expected_type, names};

/// Fault of a case file.
#[derive(Clone, PartialEq, Error)]
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
    #[error("this is not valid TOML: {message}")]
    Syntax {
        /// What the reader of TOML says.
        message: String,
        /// The line on which it says so.
        line: String,
    },
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
        /// The quantity it asks for, in words.
        of: &'static str,
    },
    /// A criterion of a probability that is not found.
    #[error("the criterion `{name}` asks for a probability: {why}")]
    NoChance {
        /// The criterion.
        name: &'static str,
        /// Reason why there is none.
        why: String,
        /// Advice, where it is not that something has to be random.
        help: Option<String>,
    },
    /// A key that has to be there.
    #[error("{} lacks `{}`", table.header(), key.entry())]
    MissingKey {
        /// The table that lacks it.
        table: Table,
        /// The key.
        key: Key,
    },
    /// A table that has to be in another.
    #[error("{} lacks `{}`", table.header(), missing.name())]
    MissingTableIn {
        /// The table.
        table: Table,
        /// The one that it lacks.
        missing: Table,
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
        /// The dimension of its numbers; `None` for a plain number.
        dimension: Option<Dimension>,
        /// The value as it stands in the file.
        written: String,
        /// The error in its unit.
        error: UnitError,
    },
    /// A value that the key cannot have.
    #[error("`{}` is {written}; expected {expected}", key.entry())]
    OutOfRange {
        /// The key.
        key: Key,
        /// The value as it stands in the file, or the number that was tried.
        written: String,
        /// Values it may have, in words.
        expected: &'static str,
    },
    /// A factor on loads that none can have.
    #[error("`{name}` is {value}; expected a number from 0 to 1e50")]
    Bias {
        /// The factor.
        name: &'static str,
        /// The number that was tried.
        value: f64,
    },
    /// A force or soil that does not meet the body.
    #[error("`{}` is above the crest of the body, which is {height} m high", key.name())]
    AboveCrest {
        /// The key.
        key: Key,
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
        /// Number of positions.
        positions: usize,
        /// Number of pressures.
        pressures: usize,
    },
    /// A pressure beside the face.
    #[error("`{}` has {}, which is beside the face; expected {} to {} m", along.name(), exact(*position), exact(*from), exact(*to))]
    BesideFace {
        /// The key of the positions.
        along: Key,
        /// The position, m.
        position: f64,
        /// Start of the face, m.
        from: f64,
        /// End of the face, m.
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
    #[error("a [[load]] or [[pressure]] is called \"{name}\", a name that the case itself uses")]
    TakenName {
        /// The name.
        name: String,
    },
    /// A combination whose changes make no case.
    #[error("in the combination \"{name}\" {problem}")]
    InCombination {
        /// The combination.
        name: String,
        /// Problem of the case that it makes.
        problem: Box<Problem>,
    },
    /// A name under `set`, `scale` or `materials` that is no key of the case.
    #[error("`{}` calls `{name}`, which is no key of this case", by.name())]
    NoKeyCalled {
        /// The name.
        name: String,
        /// The key under which it is called.
        by: Key,
        /// The numbers of the case.
        names: Vec<String>,
    },
    /// A key that is multiplied and is no number.
    #[error("`{name}` is no number, which alone `scale` multiplies")]
    NoNumber {
        /// The key.
        name: String,
    },
    /// A key that is divided and is no strength.
    #[error("`{name}` is no strength, which alone `materials` divides")]
    NoStrength {
        /// The key.
        name: String,
        /// The strengths of the case.
        names: Vec<String>,
    },
    /// A number that is changed twice in one way.
    #[error("`{name}` is named twice")]
    NamedTwice {
        /// Its name.
        name: String,
    },
    /// A resistance that there is not.
    #[error("the case has no resistance called \"{name}\"")]
    UnknownResistance {
        /// The name.
        name: String,
        /// The resistances.
        names: Vec<String>,
    },
    /// The resistance of ground of which nothing is said.
    #[error("`bearing` is divided, but no [ground] of the case says what it bears")]
    NoBearing,
    /// A criterion of the motion, or of a probability, in a combination.
    #[error("`{name}` is asked of all combinations alike")]
    CriterionOfAll {
        /// The criterion.
        name: &'static str,
    },
    /// More pairs of factors than are tried.
    #[error("{count} factors are pairs, of which all of {} ways would be tried; expected 6 pairs at most", 1_u128 << (*count).min(100))]
    TooManyPairs {
        /// The number of pairs.
        count: usize,
    },
    /// A partial factor where numbers are random.
    #[error(
        "`{name}` is divided by a partial factor, which stands for chance, beside numbers that are random"
    )]
    PartialFactor {
        /// What is divided.
        name: String,
    },
    /// A number that a combination changes, and that is random.
    #[error("the combination changes `{name}`, which is random")]
    SetAndRandom {
        /// The number.
        name: String,
    },
    /// Pairs of factors where none is tried.
    #[error("a factor is a pair, of which {of} tries none")]
    Pairs {
        /// Where.
        of: &'static str,
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
    /// A key of the body table that the parts give already.
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
        /// Number of x.
        x: usize,
        /// Number of y.
        y: usize,
    },
    /// An outline that is no part's.
    #[error("part {}: {error}", index + 1)]
    Part {
        /// Its place, from zero.
        index: usize,
        /// The error of the section.
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
        "[wave] does not go with a single object, of a `length` or a cylinder: the formulas are for a long wall"
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
    #[error("[water] lacks `density`, and [wave] has no `water_density`")]
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
        "`{}` and `crest_height` make {base_depth} m + {crest_height} m, but the body is {height} m high", key.name()
    )]
    Height {
        /// The key of the depth.
        key: Key,
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
    /// A steepness in deep water without a height there.
    #[error("[wave] has `steepness`, and no `deep_water_height` that the period could go with")]
    SteepnessOfNothing,
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
    #[error("[ground] does not say what the base bears")]
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
        /// The quantity it asks for, in words.
        of: &'static str,
        /// The missing input, in words.
        lacks: &'static str,
    },
    /// A load in time where nothing takes it.
    #[error(
        "`{}` says how a load varies in time, which an elastic base takes, and [ground] has no {lacks}", table.path(*index)
    )]
    HistoryOnRigid {
        /// The table of the history.
        table: Table,
        /// Its place among them.
        index: usize,
        /// The missing stiffness.
        lacks: &'static str,
    },
    /// A permanent load that varies in time.
    #[error("`{}` says how the load varies in time, and the load is permanent", Table::LoadHistory.path(*index))]
    HistoryOfPermanent {
        /// The place of the load.
        index: usize,
    },
    /// A history with sines on springs.
    #[error("{} is a sine; on an elastic base it has to be of straight lines", table.header())]
    SineOnSprings {
        /// The table of the history.
        table: Table,
    },
    /// A key that does not go with the shape of a history.
    #[error("`{}` does not go with the shape \"{shape}\"", key.name())]
    HistoryKey {
        /// The key.
        key: Key,
        /// The shape.
        shape: &'static str,
        /// Keys that the shape takes.
        takes: Vec<&'static str>,
    },
    /// A history that cannot be.
    #[error("{}: {error}", table.header())]
    History {
        /// Its table.
        table: Table,
        /// The error of the history.
        error: HistoryError,
    },
    /// A level that cannot be read.
    #[error("{}", level(*key, written, fault))]
    Level {
        /// The key.
        key: Key,
        /// The level as it is written.
        written: String,
        /// The reason.
        fault: LevelFault,
    },
    /// A file that a history names and that cannot be read.
    #[error("cannot read {name}: {why}")]
    Unread {
        /// The file.
        name: String,
        /// Reason why it cannot be read.
        why: String,
    },
    /// A file that is not a record, or not one of what it should be.
    #[error("{words}")]
    Record {
        /// The fault of the record, in words.
        words: String,
        /// Advice on the fault.
        help: Option<&'static str>,
    },
    /// Both are given in a table.
    #[error("{} has both `{}` and `{}`", table.header(), one.name(), two.name())]
    BothIn {
        /// The table.
        table: Table,
        /// A key.
        one: Key,
        /// Another that says the same.
        two: Key,
    },
    /// A duration that the waves give, of another shape than theirs.
    #[error("duration = \"{words}\" goes with a triangle only")]
    ByWavesShape {
        /// The word that takes the duration from the waves.
        words: &'static str,
    },
    /// A duration that the waves give, of waves by another formula than Goda's.
    #[error("duration = \"{words}\" goes with Goda's waves only")]
    ByOtherWaves {
        /// The word that takes the duration from the waves.
        words: &'static str,
    },
    /// A key of waves by another formula.
    #[error("`{}` is no key of formula = \"{formula}\"", key.entry())]
    NotOfFormula {
        /// The key.
        key: Key,
        /// The formula.
        formula: &'static str,
        /// Keys that the formula takes.
        takes: Vec<&'static str>,
    },
    /// A crown wall that is wider than the base.
    #[error("`wall_base` is {} m, but the base of the body is {} m wide", reached(*width), reached(*base))]
    WallBeyondBase {
        /// Of the waves, m.
        width: f64,
        /// From O to O', m.
        base: f64,
    },
    /// A duration that the waves give beside a rise.
    #[error("`rise` does not go with duration = \"{words}\", whose peak is in the middle")]
    ByWavesRise {
        /// The word that takes the duration from the waves.
        words: &'static str,
    },
    /// An earthquake at the first instant beside a base that moves.
    #[error("an [earthquake] beside [motion.base] counts the same shaking twice")]
    ShakenTwice,
    /// An earthquake at the first instant, of a body that is followed in time.
    #[error("an [earthquake] is a peak that is held: it has no course in time")]
    HeldShaking,
    /// More tables of a kind than there may be.
    #[error("there are {count} {} tables; expected {} at most", table.header(), table.most())]
    TooManyTables {
        /// Their kind.
        table: Table,
        /// Their number.
        count: usize,
    },
    /// A ground as steep as its friction.
    #[error("`slope_deg` of {name} is {}°; expected less than the angle of friction of its soil, {}°", reached(*slope), reached(*friction))]
    SlopeBeyondFriction {
        /// The soil.
        name: String,
        /// β, degrees.
        slope: f64,
        /// φ, degrees.
        friction: f64,
    },
    /// More friction on the wall than in the soil.
    #[error("`wall_friction_deg` is {}°; expected no more than the angle of friction of the soil, {}°, to either side", reached(*wall), reached(*friction))]
    WallFrictionBeyondFriction {
        /// δ, degrees.
        wall: f64,
        /// φ, degrees.
        friction: f64,
    },
    /// Water in a soil of which only the weight above water is known.
    #[error("water stands in this soil, {} m above the base, and `unit_weight_saturated` is not given", reached(*level))]
    SaturatedWeightMissing {
        /// Level of the water, m.
        level: f64,
    },
    /// A soil that floats.
    #[error("`unit_weight_saturated` is {} kN/m³; expected more than that of water, {} kN/m³", reached(saturated / 1e3), reached(water / 1e3))]
    SoilFloats {
        /// N/m³.
        saturated: f64,
        /// N/m³.
        water: f64,
    },
    /// Layers that end above the base.
    #[error("the layers of {name} are {} m thick; expected {} m at least, for the last to reach the base", reached(*thickness), reached(*height))]
    LayersShort {
        /// The soil.
        name: String,
        /// All of them, m.
        thickness: f64,
        /// From the ground to the base, m.
        height: f64,
    },
    /// Keys of a soil beside its layers.
    #[error("{name} has layers, and `{}` of its own", key.name())]
    SoilBesideLayers {
        /// The soil.
        name: String,
        /// The key.
        key: Key,
    },
    /// A load whose name the program gives to what it makes of another.
    #[error("a load is called {name}, as the program calls what it makes of a [[backfill]]")]
    MadeName {
        /// The name.
        name: String,
    },
    /// An earthquake under which no soil of this friction and slope holds.
    #[error(
        "the soil {name} does not hold under this earthquake: φ − β − ψ is below zero, k_h is {}; expected {} at most, with k_v as it is", 
        reached(*horizontal), reached(*greatest)
    )]
    TooSteepForEarthquake {
        /// The soil.
        name: String,
        /// k_h.
        horizontal: f64,
        /// The greatest k_h.
        greatest: f64,
    },
    /// What a code asks for.
    #[error("{}; expected {expected}", asked(name, found.as_deref()))]
    CodeOption {
        /// Name of the option.
        name: &'static str,
        /// Its value as it is written.
        found: Option<String>,
        /// What it may be.
        expected: &'static str,
    },
    /// What a code does not ask for.
    #[error("the set of this code has no option {name}")]
    NoCodeOption {
        /// The name.
        name: String,
        /// Those that it has.
        names: Vec<String>,
    },
    /// What a combination has and the file of a code has not.
    #[error("the file of a code has no `{name}`")]
    NotOfCodes {
        /// The name.
        name: String,
    },
    /// A name in the file of a code that neither the case nor the program has.
    #[error("`{}` of {file} names {name}, which this case does not have", key.name())]
    NameOfCode {
        /// The file.
        file: Box<str>,
        /// The key under which it stands there.
        key: Key,
        /// The name.
        name: Box<str>,
        /// Names that it may have.
        names: Box<[String]>,
    },
    /// A variable load that a code cannot name.
    #[error("a code names every load, and this one has no name")]
    NamelessLoad,
    /// A tilted floor under something that is not worked out for one.
    #[error("the floor of [body] rises at {}°, and {what} is not worked out for a tilted floor", digits(*slope))]
    TiltedFloor {
        /// Its rise, degrees.
        slope: f64,
        /// What stands beside it.
        what: &'static str,
    },
    /// A base whose opening is not followed.
    #[error("`{}` of [water] follows a base that opens, which is not done for {what}", key.name())]
    OpeningNotFor {
        /// The key.
        key: Key,
        /// The kind of the base.
        what: &'static str,
    },
    /// Drains that do not lie under the base.
    #[error("`distance` of the drains is {} m from O; expected less than the width of the base, {} m", reached(*distance), reached(*base))]
    DrainBesideBase {
        /// From O, m.
        distance: f64,
        /// Width of the base, m.
        base: f64,
    },
    /// Free water that moves with the body on a side that is filled.
    #[error("`sides` counts the {side}, where soil stands: no free water moves with the body there")]
    FilledSide {
        /// The side.
        side: &'static str,
    },
    /// Something that is not answered on a base seen from above.
    #[error("a base seen from above is not for {what}")]
    PlanNotFor {
        /// What it is, in words.
        what: &'static str,
    },
    /// A base seen from above of a body per metre run.
    #[error("a base seen from above needs the `length` of the body")]
    PlanNeedsLength,
    /// Points on which no body stands.
    #[error("{error}")]
    PlanShape {
        /// What is wrong with them.
        error: FootprintError,
    },
    /// A centre of mass that is not over the base.
    #[error("the centre of mass is {}; expected one above the base", beside_base(*beside))]
    CentroidBesideBase {
        /// How far beside, m.
        beside: f64,
    },
    /// Loads that turn the body about the vertical.
    #[error("the loads turn the body about the vertical by {} N m; what a base bears of that is answered on a disc alone", reached(*moment))]
    TorsionNotFor {
        /// Moment about the centre of pressure, counter-clockwise from above, N·m.
        moment: f64,
    },
    /// Joints beside something that has no place for them.
    #[error("[[joint]] is not for {what}")]
    JointsNotFor {
        /// What it is, in words.
        what: &'static str,
    },
    /// More joints than a probability is found of.
    #[error("{joints} tables [[joint]]; a probability is found of {most} of them at most")]
    JointsOfChance {
        /// Number of joints above the base.
        joints: usize,
        /// At most so many.
        most: usize,
    },
    /// A key of the whole body, beside joints.
    #[error("[[joint]] cuts a uniform block, or parts; `{}` says more of the whole", key.name())]
    JointsOfBlock {
        /// The key.
        key: Key,
    },
    /// A joint at the crest, or above it.
    #[error("the joint is {level} m above the base; expected a level below the crest, at {crest} m")]
    JointAboveCrest {
        /// Its level, m.
        level: f64,
        /// Of the crest, m.
        crest: f64,
    },
    /// Two joints at one level.
    #[error("two joints are at one level, {level} m")]
    SameLevel {
        /// The level, m.
        level: f64,
    },
    /// Two joints of one name; joint 1 is called base.
    #[error("two joints are called \"{name}\"")]
    SameJoint {
        /// The name.
        name: String,
    },
    /// A level at which a section cannot be parted.
    #[error(transparent)]
    Cut(CutError),
    /// A joint beside which the centre of mass of what is above it lies.
    #[error("what is above the joint at {level} m has its centre of mass beside it, and falls")]
    BesideJoint {
        /// Its level, m.
        level: f64,
    },
    /// An end of a joint beside what touches there.
    #[error("`{}` of the joint is {value} m; what is below and above it touches from {from} m to {to} m", key.name())]
    BesideContact {
        /// The key.
        key: Key,
        /// Its value, m.
        value: f64,
        /// Left end of what touches, m.
        from: f64,
        /// Right end of it, m.
        to: f64,
    },
    /// A joint without length.
    #[error("the joint reaches from {left} m to {right} m; expected `right` beyond `left`")]
    NoJoint {
        /// Its left end, m.
        left: f64,
        /// Its right end, m.
        right: f64,
    },
    /// A joint below water of which nobody says what is in it.
    #[error(
        "{what} above the joint at {level} m; expected `uplift` = \"open\" or \"tight\", or the pressures in it"
    )]
    JointWater {
        /// Its level, m.
        level: f64,
        /// What does, in words.
        what: &'static str,
    },
    /// An open joint where no water is said.
    #[error("the joint at {level} m is open, and neither [water] nor [wave] says what is outside")]
    NothingOpen {
        /// Its level, m.
        level: f64,
    },
    /// Something that holds, or turns, a body in a problem that has no place for it.
    #[error("{holds} is not for {what}")]
    HoldsNot {
        /// What does, in words.
        holds: String,
        /// The problem.
        what: &'static str,
    },
    /// More forces that hold a body than can be looked at together.
    #[error("{count} resistances hold the body; expected {most} at most")]
    TooManyResistances {
        /// Their number.
        count: usize,
        /// The most.
        most: usize,
    },
    /// Two resistances of one name.
    #[error("two resistances are called {name}")]
    SameResistance {
        /// The name.
        name: String,
    },
    /// A passive soil of which it is not said how much counts.
    #[error("the soil {name} is passive, and lacks `share`: how much of its resistance is counted")]
    ShareMissing {
        /// The soil.
        name: String,
    },
    /// A share of the resistance of a soil that is no resistance.
    #[error("`share` of {name} goes with state = \"passive\" only")]
    ShareOfPush {
        /// The soil.
        name: String,
    },
    /// A key that a passive soil does not take.
    #[error("`{}` of {name} does not go with state = \"passive\", which is for level ground beside an upright wall", key.name())]
    NotOfPassive {
        /// The soil.
        name: String,
        /// The key.
        key: Key,
    },
    /// A ratio beside another law of impacts.
    #[error("`ratio` goes with law = \"ratio\" only")]
    RatioOfOtherLaw,
    /// A restitution with a law without rebound.
    #[error(
        "`e` is given with law = \"inelastic\", which has no rebound; expected law = \"poisson\" or \"energetic\", or e of landings beside \"housner\" and \"ratio\""
    )]
    RestitutionOfNone,
    /// A body that is asked to overturn.
    #[error("`overturned` is true; expected false: that the body does not overturn")]
    AskedToOverturn,
    /// A case whose motion in time cannot be followed.
    #[error("{0}")]
    Motion(MotionError),
    /// A motion on a base that crushes.
    #[error(
        "`strength` of [ground] is {}: once its edge is crushed the body stands on another base, whose motion is not computed",
        Dimension::Pressure.written(*strength)
    )]
    MovingOnCrushing {
        /// The strength, Pa.
        strength: f64,
    },
    /// A table that stands in place of a body, where a body is needed.
    #[error("{}", without_body(*table))]
    NoCase {
        /// Its table.
        table: Table,
    },
    /// A case in time where cases at rest are answered.
    #[error("the case is one in time, and a table of cases is answered at rest")]
    TableInTime,
    /// Another table beside a body in pure numbers.
    #[error("a case of a [block] has no `{path}`")]
    NotOfBlock {
        /// The table or key.
        path: String,
    },
    /// A body in pure numbers that is not uniform, without its inertia.
    #[error("[block] lacks `rho2`")]
    NoInertia,
    /// Water on a dry side.
    #[error("`sides` counts the {side}, and no water stands there")]
    DrySide {
        /// The side.
        side: &'static str,
    },
    /// Water of different depths on both sides, of which one is counted.
    #[error("`sides` is 1, and water stands on both sides: {} m at the right, {} m at the left", reached(*right), reached(*left))]
    WhichSide {
        /// Its depth at the right, m.
        right: f64,
        /// At the left, m.
        left: f64,
    },
    /// A value that does not go with the others.
    #[error("`{}` is {}; expected {}", key.entry(), reached(.error.value), .error.expected)]
    Impossible {
        /// The key.
        key: Key,
        /// The error of the library.
        error: InputError,
    },
    /// Numbers beyond what can be computed, by themselves or together.
    #[error("these numbers are too large or too small to be computed with: {} is {}; expected {}", .0.quantity, exact(.0.value), .0.expected)]
    Mechanics(InputError),
}

/// Sentence on the answer to a table that stands in place of a body.
fn without_body(table: Table) -> &'static str {
    match table {
        Table::Block => "a [block] has no first instant to assess: its motion is followed in time",
        Table::Point => "a [point] has no body and no loads: it is answered with its random numbers",
        _ => "the case has a [storm] and no [body]: it is answered with its random numbers",
    }
}

/// Place of a centre of mass that is not above the base, by how far it is beside it, m.
fn beside_base(beside: f64) -> String {
    /// Nearer than this it is on the edge, whatever rounding leaves.
    const ON: f64 = 1e-9;
    if beside > ON {
        format!("{} m beside the base", reached(beside))
    } else {
        "on the edge of the base".to_owned()
    }
}

/// Reason why a level cannot be read.
fn level(key: Key, written: &str, fault: &LevelFault) -> String {
    let name = key.name();
    match fault {
        LevelFault::NoDatum(_) => format!("`{name}` is {written}, a level, and the file has no datum"),
        LevelFault::Other(datum) => format!("`{name}` is {written}; the datum of the file is {datum}"),
        LevelFault::NoLevel => format!("`{name}` is {written}, a level, and it is a length of the body"),
        LevelFault::NoSea => {
            format!(
                "`{name}` is {written}, a level, and the file does not say how high the sea stands above the base"
            )
        }
    }
}

/// An option that is wrong, or not given.
fn asked(name: &str, found: Option<&str>) -> String {
    match found {
        Some(found) => format!("`{name}` of the options is {found}"),
        None => format!("the set of this code asks for `{name}` in the options"),
    }
}

/// A value in the unit of plain numbers.
fn with_unit(key: Key, value: f64) -> String {
    key.info()
        .dimension()
        .map_or(reached(value), |dimension| format!("{} {}", reached(value), dimension.si()))
}

/// The sentence, as it is shown: what a test or a fault in the program prints is read by people.
impl std::fmt::Debug for Problem {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        std::fmt::Display::fmt(self, f)
    }
}

impl std::fmt::Display for Key {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        Id::from(*self).fmt(f)
    }
}

impl From<RandomProblem> for Problem {
    fn from(problem: RandomProblem) -> Problem {
        Problem::Random(Box::new(problem))
    }
}
