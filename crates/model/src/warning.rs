//! Warnings of values in a case that are possible, but so unusual that they may be slips: a name, the value that triggered it,
//! the usual one, and the key it came from. The tests and their limits stand in `search`.

mod search;

use std::fmt;

use standfast::loads::Face;
use standfast::wave::STEEPEST;
use standfast::{Slip, wave};

use crate::digits::{apart, digits, percent};
use crate::key::{Id, Key, Table};
use crate::units::Extent;
pub(crate) use search::SHAKING;
use search::{
    BEARING, BUOYANT, DENSITY, FRICTION, GRAVITY, GYRATION, HEIGHTS, OBJECT, OBLIQUE, SLENDER, STIFFNESS,
    STRENGTH, SUBMERGED, UNDRAINED, UNIT_WEIGHT, WATER,
};

/// A warning about a case.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Warning {
    /// The base reaches beyond the body.
    BaseBeyondBody {
        /// On which side.
        side: Slip,
        /// Reach of the base from mid-width, m.
        edge: f64,
        /// Reach of the base beyond the body, m.
        beyond: f64,
    },
    /// The base seen from above is much larger than the body.
    PlanBeyondBody {
        /// Its extent, m, across or along the section.
        base: f64,
        /// That of the body, m.
        body: f64,
    },
    /// Seas are drawn that are steeper than waves can be.
    SteepSeas {
        /// The share of all that are drawn.
        share: f64,
    },
    /// Waves that slides leave out are met in many lives.
    WavesLeftOut {
        /// The share of all lives that have one.
        share: f64,
        /// True if the base may crush, or the ground fail, under them.
        gives_way: bool,
    },
    /// The buoyant weight acts beside the base.
    WeightBesideBase {
        /// Its arm, m.
        arm: f64,
        /// The width of the base, m.
        base: f64,
    },
    /// The body is lighter or heavier than what is built.
    MeanDensity {
        /// Mass over volume, kg/m³.
        density: f64,
        /// Extent of the mass: a metre run or the whole body.
        extent: Extent,
        /// True if its volume is that of parts.
        of_parts: bool,
    },
    /// A part is lighter or heavier than what is built.
    PartDensity {
        /// Above still water or below it.
        id: Id,
        /// kg/m³.
        density: f64,
        /// Extent of the body: a metre run or the whole of it.
        extent: Extent,
    },
    /// The water is lighter or heavier than water is.
    WaterDensity {
        /// Key that gives it.
        key: Key,
        /// kg/m³.
        density: f64,
    },
    /// More friction than bases have.
    HighFriction {
        /// The key that gives it: that of the base, or of a joint.
        id: Id,
        /// μ to stick.
        friction: f64,
    },
    /// Another planet, or another unit.
    UnusualGravity {
        /// m/s².
        gravity: f64,
    },
    /// The centre of mass lies outside the body.
    CentroidOutsideBody {
        /// Its height above the base, m.
        height: f64,
        /// That of the body, m.
        crest: f64,
    },
    /// A moment of inertia that no body of these dimensions has.
    MomentOfInertia {
        /// kg m² per metre run or of the whole.
        inertia: f64,
        /// Extent of the body: a metre run or the whole of it.
        extent: Extent,
        /// Radius of gyration as a share of the diagonal.
        share: f64,
    },
    /// Higher over wide, or wider over high, than bodies are.
    Slenderness {
        /// γ = H/B.
        slenderness: f64,
    },
    /// Waves from farther aside than the formulas were made for.
    WaveAngle {
        /// Degrees from the normal of the wall.
        degrees: f64,
    },
    /// Ground under water with the unit weight of ground above it.
    GroundUnderWater {
        /// N/m³.
        unit_weight: f64,
    },
    /// Pressures too small to be what is meant.
    SmallPressure {
        /// The key that gives it.
        id: Id,
        /// The largest, Pa.
        pressure: f64,
    },
    /// A force too small to be what is meant.
    SmallForce {
        /// The kind of its table, and the place among them.
        table: Table,
        /// Place of the table.
        index: usize,
        /// N, or N m of a couple.
        force: f64,
        /// The force as a share of the weight, a couple as one of the weight times the width.
        share: f64,
    },
    /// A permanent pressure on an upright face that is less at its foot than at its top.
    PressureFallsWithDepth {
        /// Place of the table.
        index: usize,
        /// At its foot, Pa.
        foot: f64,
        /// At its top, Pa.
        top: f64,
    },
    /// A permanent pressure pushes the body against the higher water.
    PressureAgainstWater {
        /// Place of the table.
        index: usize,
        /// Face that it presses on.
        face: Face,
        /// Level of the water there, m.
        low: f64,
        /// Level on the other side, m.
        high: f64,
    },
    /// More uplift on the side away from the push.
    UpliftAwayFromPush {
        /// At O, Pa.
        left: f64,
        /// At O', Pa.
        right: f64,
    },
    /// Uplift that is not said to rise with a push that does.
    UpliftStays {
        /// The kind of the push's table.
        table: Table,
        /// Its place among those.
        index: usize,
    },
    /// A warning of the numbers of a combination, which those of the case do not bring.
    InCombination {
        /// The combination.
        name: String,
        /// The warning.
        warning: Box<Warning>,
    },
    /// A variable load acts in no combination.
    LoadInNoCombination {
        /// Its table.
        table: Table,
        /// Its place among those of that name.
        index: usize,
    },
    /// A variable load holds the body, and the case nowhere leaves it out.
    FavourableLoad {
        /// The table that gives it.
        table: Table,
        /// Its place among such tables.
        index: usize,
        /// The least safety factor of the case.
        with: f64,
        /// The least one without the load.
        without: f64,
    },
    /// A vertical force acts beside the body.
    LoadBesideBody {
        /// The key of its distance.
        id: Id,
        /// Its distance to the right of O, m.
        distance: f64,
        /// Distance from the body, m.
        beside: f64,
    },
    /// A force acts on what stands on the body, above or beside it.
    LoadOffTheBody {
        /// The key that says on what.
        id: Id,
        /// What it stands on.
        lever: String,
        /// Distance above the crest, m; not above zero below it.
        above: f64,
        /// Distance beside the body, m; not above zero where it meets it.
        beside: f64,
    },
    /// An allowable bearing pressure that nothing stands on.
    SmallBearing {
        /// Pa.
        pressure: f64,
    },
    /// Ground that is softer, weaker, lighter or heavier than ground is.
    UnusualGround {
        /// Key of the property.
        id: Id,
        /// In SI units.
        value: f64,
    },
    /// The base is shaken with more than the ground ever is.
    StrongEarthquake {
        /// Along the base, or vertically.
        key: Key,
        /// m/s².
        acceleration: f64,
        /// The acceleration in multiples of that of gravity.
        share: f64,
    },
    /// The base is shaken so little that nobody feels it.
    WeakEarthquake {
        /// Along the base, or vertically.
        key: Key,
        /// m/s².
        acceleration: f64,
        /// The acceleration in multiples of that of gravity.
        share: f64,
    },
    /// The largest wave does not go with the significant one.
    WaveHeightRatio {
        /// Hmax, m.
        maximum: f64,
        /// H13, m.
        significant: f64,
    },
    /// The weight less buoyancy is more than the weight.
    BuoyantAboveWeight {
        /// W', N.
        buoyant: f64,
        /// m g, N.
        weight: f64,
        /// Extent of both: a metre run or the whole body.
        extent: Extent,
    },
    /// The weight less buoyancy is not the weight less the water that the section displaces.
    BuoyantBesideDisplacement {
        /// W', N.
        buoyant: f64,
        /// m g, N.
        weight: f64,
        /// ρ g × area of the base × depth of the base, N.
        displaced: f64,
        /// Extent of the forces: a metre run or the whole body.
        extent: Extent,
    },
    /// The weight less buoyancy is not that of the parts.
    BuoyantBesideParts {
        /// W', as given, N.
        buoyant: f64,
        /// The weight of the parts less the water they displace, N per metre run.
        of_parts: f64,
    },
    /// A wall is shaken in water that presses on it as if it were still.
    EarthquakeWithoutAddedMass {
        /// Along the base, m/s².
        acceleration: f64,
    },
    /// Waves bring their own uplift.
    UpliftBesideWave {
        /// Of the table, at O and O', Pa.
        given: [f64; 2],
        /// Of the waves, at the seaward toe, Pa.
        of_waves: f64,
    },
    /// More friction between soil and body than walls have.
    WallFrictionHigh {
        /// The key that gives it.
        id: Id,
        /// δ, degrees.
        wall: f64,
        /// φ, degrees.
        friction: f64,
    },
    /// A soil that is heavier or lighter under water than soils are.
    SaturatedWeightUnusual {
        /// The key that gives it.
        id: Id,
        /// γ_sat, N/m³.
        saturated: f64,
        /// γ above the water, N/m³.
        moist: f64,
        /// What of γ_sat water bears, N/m³.
        water: f64,
    },
    /// A surcharge too small to be what is meant.
    SurchargeSmall {
        /// The key that gives it.
        id: Id,
        /// Pa.
        pressure: f64,
    },
    /// A permanent pressure on the face that soil stands against.
    BackfillBesidePressure {
        /// The soil.
        name: String,
        /// Place of the table of the pressure.
        index: usize,
    },
    /// Soil on the side of the sea.
    BackfillOnTheSeaSide {
        /// The soil.
        name: String,
    },
    /// An earthquake more than doubles the pressure of a soil.
    StrongIncrement {
        /// The soil.
        name: String,
        /// K at rest of the ground.
        k: f64,
        /// K_E in the earthquake.
        k_e: f64,
    },
    /// A criterion of a code that the case cannot answer.
    CodeCriterionMissing {
        /// The combination.
        combination: String,
        /// The code.
        code: String,
        /// The criterion.
        criterion: &'static str,
    },
    /// The base opens, and water fills what opens.
    BaseOpens {
        /// The loads under which it does, where there are several.
        situation: Option<String>,
        /// The length that stays pressed, m.
        contact: f64,
        /// The width of the base, m.
        base: f64,
        /// The pressure that stands in what has opened, Pa.
        pressure: f64,
    },
    /// A closed base that any opening would lift.
    OpeningWouldRunThrough {
        /// The loads, where there are several.
        situation: Option<String>,
    },
    /// Fast loads meet a diagram that is held.
    OpeningHeld {
        /// The loads, where there are several.
        situation: Option<String>,
    },
    /// A base has opened beyond its drains.
    DrainLost {
        /// The loads, where there are several.
        situation: Option<String>,
    },
    /// Pressures under the base that are given beside water that follows an opening.
    GivenUpliftDoesNotFollow {
        /// The table that gives them.
        table: Table,
    },
    /// A combination leaves out a load that the program makes.
    LoadNotActing {
        /// The load.
        name: String,
        /// The combination.
        combination: String,
    },
    /// Adhesion holds more than half of what holds a body against sliding.
    AdhesionCarries {
        /// The situation, where there are several.
        situation: Option<String>,
        /// c_a A', N.
        adhesion: f64,
        /// All that holds, N.
        resistance: f64,
        /// Extent of both: a metre run or the whole body.
        extent: Extent,
    },
    /// A joint that is not pressed throughout, with different pressures of water at its ends.
    JointWouldOpen {
        /// The situation, where there are several.
        situation: Option<String>,
        /// The joint, by its number from the base and its name.
        joint: String,
        /// Share of it that is pressed; 0 where the resultant misses it.
        share: f64,
    },
    /// A passive soil beside a low factor.
    PassiveWithLowFactor {
        /// The situation, where there are several.
        situation: Option<String>,
        /// The soil.
        name: String,
        /// SF_sliding with it.
        factor: f64,
    },
    /// A formula that nobody here has read in its source.
    FormulaRecalled {
        /// What it gives.
        what: &'static str,
        /// Where it is said to stand.
        source: &'static str,
    },
    /// A crown wall that is not as high as the body.
    CrownWallHeight {
        /// Its height, m.
        wall: f64,
        /// That of the body, m.
        body: f64,
    },
    /// The waves leave the range of the formulas.
    Wave(wave::WaveWarning),
}

impl Warning {
    /// Its name, to be told apart by programs.
    pub fn name(&self) -> &'static str {
        match self {
            Warning::BaseBeyondBody { .. } => "base-beyond-body",
            Warning::PlanBeyondBody { .. } => "plan-beyond-body",
            Warning::SteepSeas { .. } => "steep-seas",
            Warning::WavesLeftOut { .. } => "waves-left-out",
            Warning::WeightBesideBase { .. } => "weight-beside-base",
            Warning::MeanDensity { .. } => "mean-density",
            Warning::PartDensity { .. } => "part-density",
            Warning::WaterDensity { .. } => "water-density",
            Warning::HighFriction { .. } => "high-friction",
            Warning::UnusualGravity { .. } => "unusual-gravity",
            Warning::CentroidOutsideBody { .. } => "centroid-outside-body",
            Warning::MomentOfInertia { .. } => "moment-of-inertia",
            Warning::Slenderness { .. } => "slenderness",
            Warning::WaveAngle { .. } => "wave-angle",
            Warning::GroundUnderWater { .. } => "ground-under-water",
            Warning::SmallPressure { .. } => "small-pressure",
            Warning::SmallForce { .. } => "small-force",
            Warning::PressureFallsWithDepth { .. } => "pressure-falls-with-depth",
            Warning::PressureAgainstWater { .. } => "pressure-against-water",
            Warning::UpliftAwayFromPush { .. } => "uplift-away-from-push",
            Warning::UpliftStays { .. } => "uplift-stays",
            Warning::InCombination { warning, .. } => warning.name(),
            Warning::LoadInNoCombination { .. } => "load-in-no-combination",
            Warning::FavourableLoad { .. } => "favourable-load",
            Warning::LoadBesideBody { .. } => "load-beside-body",
            Warning::LoadOffTheBody { .. } => "load-off-the-body",
            Warning::SmallBearing { .. } => "small-bearing",
            Warning::UnusualGround { .. } => "unusual-ground",
            Warning::StrongEarthquake { .. } => "strong-earthquake",
            Warning::WeakEarthquake { .. } => "weak-earthquake",
            Warning::WaveHeightRatio { .. } => "wave-height-ratio",
            Warning::BuoyantAboveWeight { .. } => "buoyant-above-weight",
            Warning::BuoyantBesideDisplacement { .. } => "buoyant-beside-displacement",
            Warning::BuoyantBesideParts { .. } => "buoyant-beside-parts",
            Warning::EarthquakeWithoutAddedMass { .. } => "earthquake-without-added-mass",
            Warning::UpliftBesideWave { .. } => "uplift-beside-wave",
            Warning::WallFrictionHigh { .. } => "wall-friction-high",
            Warning::SaturatedWeightUnusual { .. } => "saturated-weight-unusual",
            Warning::SurchargeSmall { .. } => "surcharge-small",
            Warning::BackfillBesidePressure { .. } => "backfill-beside-pressure",
            Warning::BackfillOnTheSeaSide { .. } => "backfill-on-the-sea-side",
            Warning::StrongIncrement { .. } => "strong-increment",
            Warning::LoadNotActing { .. } => "load-not-acting",
            Warning::CodeCriterionMissing { .. } => "code-criterion-missing",
            Warning::BaseOpens { .. } => "base-opens",
            Warning::OpeningWouldRunThrough { .. } => "opening-would-run-through",
            Warning::OpeningHeld { .. } => "opening-held",
            Warning::DrainLost { .. } => "drain-lost",
            Warning::GivenUpliftDoesNotFollow { .. } => "given-uplift-does-not-follow",
            Warning::AdhesionCarries { .. } => "adhesion-carries",
            Warning::JointWouldOpen { .. } => "joint-would-open",
            Warning::PassiveWithLowFactor { .. } => "passive-with-low-factor",
            Warning::FormulaRecalled { .. } => "formula-recalled",
            Warning::CrownWallHeight { .. } => "crown-wall-height",
            Warning::Wave(warning) => warning.name(),
        }
    }

    /// True if another warning is the same one again, of a combination's numbers.
    pub(crate) fn is_same_as(&self, other: &Warning) -> bool {
        match (self, other) {
            // The heights may be others; what is told is how they go together.
            (
                Warning::WaveHeightRatio { significant, maximum },
                Warning::WaveHeightRatio { significant: other, maximum: highest },
            ) => (maximum / significant - highest / other).abs() <= 1e-9 * (maximum / significant).abs(),
            _ => self.name() == other.name(),
        }
    }

    /// True of what is told of all combinations together.
    pub(crate) fn is_about_combinations(&self) -> bool {
        matches!(
            self,
            Warning::LoadInNoCombination { .. }
                | Warning::LoadNotActing { .. }
                | Warning::CodeCriterionMissing { .. }
                | Warning::BaseOpens { .. }
                | Warning::OpeningWouldRunThrough { .. }
                | Warning::OpeningHeld { .. }
                | Warning::DrainLost { .. }
                | Warning::GivenUpliftDoesNotFollow { .. }
                | Warning::AdhesionCarries { .. }
                | Warning::PassiveWithLowFactor { .. }
                | Warning::JointWouldOpen { .. }
                | Warning::FavourableLoad { .. }
                | Warning::UpliftAwayFromPush { .. }
        )
    }

    /// True if it is about waves.
    pub fn is_about_waves(&self) -> bool {
        match self {
            Warning::Wave(_) | Warning::WaveHeightRatio { .. } | Warning::CrownWallHeight { .. } => true,
            Warning::WaterDensity { key, .. } => key.info().table == Table::Wave,
            _ => false,
        }
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // A value is told apart from the limit that it is beyond.
        let beyond = |value: f64, limit: f64| apart(&[value, limit]).swap_remove(0);
        let under = |situation: &Option<String>| {
            situation.as_ref().map_or(String::new(), |name| format!("under «{name}» "))
        };
        let kilopascals = |pressure: f64| format!("{} kPa", digits(pressure / 1e3));
        match self {
            Warning::BaseBeyondBody { side, edge, beyond } => {
                let (key, side) = match side {
                    Slip::Left => ("base_left", "left"),
                    Slip::Right => ("base_right", "right"),
                };
                let (edge, beyond) = (digits(*edge), digits(*beyond));
                write!(f, "{key} = {edge} m: the base reaches {beyond} m beyond the body's {side} side")
            }
            Warning::PlanBeyondBody { base, body } => write!(
                f,
                "the base is {} m across, the body {} m: lengths without a unit are in m",
                digits(*base),
                digits(*body)
            ),
            Warning::SteepSeas { share } => write!(
                f,
                "{} of the seas drawn are steeper than waves in deep water can be, H0'/L0 above {STEEPEST}; their height is cut to \
                 that: look at the laws of height and period, and how they are correlated",
                digits(*share)
            ),
            Warning::WavesLeftOut { share, gives_way } => write!(
                f,
                "{} of all lives have waves {}, which the slides leave out: their mean and chances are those of sliding alone",
                digits(*share),
                if *gives_way {
                    "that begin a rotation, or under which the base gives way"
                } else {
                    "that begin a rotation"
                }
            ),
            Warning::WeightBesideBase { arm, base } => write!(
                f,
                "weight_arm = {} m is more than the base is wide, {} m: the body does not stand under its own weight",
                digits(*arm),
                digits(*base)
            ),
            Warning::MeanDensity { density, extent, of_parts: true } => {
                let usual = if *extent == Extent::PerMetre { DENSITY } else { OBJECT };
                write!(
                    f,
                    "the mean density of the parts is {} kg/m³; usual: {usual} kg/m³. Check their densities, outlines and units",
                    beyond(*density, usual.limit(*density))
                )
            }
            Warning::MeanDensity { density, extent: Extent::PerMetre, .. } => write!(
                f,
                "the mean density, mass/(width × height), is {} kg/m³; usual: {DENSITY} kg/m³. Check \
                 mass or density, width and height, and their units",
                beyond(*density, DENSITY.limit(*density))
            ),
            Warning::MeanDensity { density, extent: Extent::Whole, .. } => write!(
                f,
                "the mean density, mass/volume, is {} kg/m³; usual: {OBJECT} kg/m³. Check mass or density, the \
                 dimensions, and their units",
                beyond(*density, OBJECT.limit(*density))
            ),
            Warning::PartDensity { id, density, extent } => {
                let usual = if *extent == Extent::PerMetre { DENSITY } else { OBJECT };
                write!(f, "{id} = {} kg/m³; usual: {usual} kg/m³", beyond(*density, usual.limit(*density)))
            }
            Warning::WaterDensity { key, density } => {
                write!(
                    f,
                    "{key} = {} kg/m³; water has {WATER} kg/m³",
                    beyond(*density, WATER.limit(*density))
                )
            }
            Warning::HighFriction { id, friction } => {
                let key = if id.table == Table::Body { "friction".to_owned() } else { id.to_string() };
                write!(
                    f,
                    "{key} = {}; between a body and its base it is {FRICTION} at most, as a rule",
                    beyond(*friction, FRICTION)
                )
            }
            Warning::UnusualGravity { gravity } => {
                write!(
                    f,
                    "gravity = {} m/s²; on the ground it is {GRAVITY} m/s²",
                    beyond(*gravity, GRAVITY.limit(*gravity))
                )
            }
            Warning::CentroidOutsideBody { height, crest } => write!(
                f,
                "centroid_height = {} m: the centre of mass lies above the body, which is {} m high",
                beyond(*height, *crest),
                digits(*crest)
            ),
            Warning::MomentOfInertia { inertia, extent, share } => write!(
                f,
                "moment_of_inertia = {}: the radius of gyration is {} of the diagonal; {GYRATION} is usual, 0.289 of a uniform rectangle",
                extent.inertia(*inertia),
                beyond(*share, GYRATION.limit(*share))
            ),
            Warning::Slenderness { slenderness } => write!(
                f,
                "height/width = {}; usual: {SLENDER}. Check both, and their units",
                beyond(*slenderness, SLENDER.limit(*slenderness))
            ),
            Warning::WaveAngle { degrees } => write!(
                f,
                "angle_deg = {}; it is counted from the normal of the wall, and the formulas were made for {OBLIQUE} at most",
                beyond(*degrees, OBLIQUE)
            ),
            Warning::GroundUnderWater { unit_weight } => write!(
                f,
                "unit_weight = {} kN/m³ of ground under water, where it is {SUBMERGED} kN/m³ at most: that of the water is to be taken off",
                beyond(unit_weight / 1e3, SUBMERGED)
            ),
            Warning::SmallPressure { id, pressure } => write!(
                f,
                "{id} reaches {} Pa only; a number without unit is in Pa, not in kPa",
                digits(*pressure)
            ),
            Warning::SmallForce { table, index, force, share } => {
                let (unit, of, not) = match table {
                    Table::Moment => ("N m", "the weight times the width", "kN m"),
                    _ => ("N", "the weight", "kN"),
                };
                write!(
                    f,
                    "{} {} is {} {unit}, {} of {of}; a number without unit is in {unit}, not in {not}",
                    table.header(),
                    index + 1,
                    digits(*force),
                    digits(*share)
                )
            }
            Warning::PressureFallsWithDepth { index, foot, top } => write!(
                f,
                "[[pressure]] {} is permanent and falls with depth, from {} to {}: pressures of soil and water rise",
                index + 1,
                kilopascals(*top),
                kilopascals(*foot)
            ),
            Warning::PressureAgainstWater { index, face, low, high } => {
                let [low, high] = apart(&[*low, *high]).try_into().unwrap_or_default();
                write!(
                    f,
                    "[[pressure]] {} is permanent and pushes on the {} face, where the water stands at {low} m, against the water at {high} m \
                     on the other side: see its face",
                    index + 1,
                    if *face == Face::Left { "left" } else { "right" }
                )
            }
            Warning::UpliftAwayFromPush { left, right } => {
                let (less, more, side) =
                    if left > right { (right, left, "left") } else { (left, right, "right") };
                write!(
                    f,
                    "the uplift is {} at the {side} end of the base and {} at the other, from which the loads push: a wave presses \
                     more where it comes from",
                    kilopascals(*more),
                    kilopascals(*less)
                )
            }
            Warning::UpliftStays { table, index } => write!(
                f,
                "the uplift stays as it is while {} {} is variable: write grows = true in [uplift] where that load, as a wave, brings it, or \
                 grows = false where it does not",
                table.header(),
                index + 1
            ),
            Warning::InCombination { name, warning } => write!(f, "in the combination \"{name}\" {warning}"),
            Warning::WallFrictionHigh { id, wall, friction } => write!(
                f,
                "{id} = {}° is more than two thirds of the friction of the soil, {}°",
                digits(*wall),
                digits(*friction)
            ),
            Warning::SaturatedWeightUnusual { id, saturated, moist, water } => {
                let [saturated, moist, lifted] =
                    [*saturated, *moist, saturated - water].map(|weight| digits(weight / 1e3));
                write!(
                    f,
                    "{id} = {saturated} kN/m³ is {lifted} kN/m³ less that of water, and the soil is {moist} kN/m³ above it; {BUOYANT} kN/m³ is usual, and \
                     no less than above water"
                )
            }
            Warning::SurchargeSmall { id, pressure } => {
                write!(f, "{id} = {} Pa; a number without unit is in Pa, not in kPa", digits(*pressure))
            }
            Warning::BackfillBesidePressure { name, index } => write!(
                f,
                "[[pressure]] {} is permanent and acts on the face of the soil {name}: what is one pressure is counted twice",
                index + 1
            ),
            Warning::BackfillOnTheSeaSide { name } => {
                write!(f, "the soil {name} stands at the right, where the waves come from: see its face")
            }
            Warning::StrongIncrement { name, k, k_e } => write!(
                f,
                "the earthquake raises the coefficient of the soil {name} from {} to {}, more than twice: near the limit of the formula a \
                 little more shaking does much",
                digits(*k),
                digits(*k_e)
            ),
            Warning::CodeCriterionMissing { combination, code, criterion } => write!(
                f,
                "the combination \"{combination}\": {code} asks for {criterion}, which this case cannot answer{}",
                match *criterion {
                    "ground_factor" => ": it has no [ground] that bears so much",
                    _ => ": the weight is given less buoyancy",
                }
            ),
            Warning::BaseOpens { situation, contact, base, pressure } => match contact {
                0.0 => write!(
                    f,
                    "{}the base opens from end to end: {} stand under all of it",
                    under(situation),
                    kilopascals(*pressure)
                ),
                contact => write!(
                    f,
                    "{}the base opens over {} m of {} m, and {} stand there, the higher head; opening = \"closed\" keeps the straight line",
                    under(situation),
                    digits(base - contact),
                    digits(*base),
                    kilopascals(*pressure)
                ),
            },
            Warning::OpeningWouldRunThrough { situation } => write!(
                f,
                "{}the base is closed, but water that once gets under it lifts the body",
                under(situation)
            ),
            Warning::OpeningHeld { situation } => write!(
                f,
                "{}the base has opened under the steady loads, and the fast ones meet the water that stands there then; opening = \"always\" lets \
                 it follow all",
                under(situation)
            ),
            Warning::DrainLost { situation } => {
                write!(f, "{}the base has opened beyond its drains, which no longer work", under(situation))
            }
            Warning::GivenUpliftDoesNotFollow { table } => write!(
                f,
                "{} gives a pressure under a base that opens: it stays as it is given, and does not follow",
                table.header()
            ),
            Warning::LoadNotActing { name, combination } => write!(
                f,
                "the combination \"{combination}\" does not name {name}, which is variable and so does not act in it; a factor of 0 says that it is \
                 left out on purpose"
            ),
            Warning::LoadInNoCombination { table, index } => {
                let number =
                    if table.repeats() { format!(" {}", table.number(*index)) } else { String::new() };
                write!(
                    f,
                    "{}{number} acts in no combination, and so nowhere: a combination names it among its factors",
                    table.header()
                )
            }
            Warning::FavourableLoad { table, index, with, without } => {
                let [with, without] = apart(&[*with, *without]).try_into().unwrap_or_default();
                write!(
                    f,
                    "{} {} holds the body, and need not be there: without it the least safety factor is {without}, not {with}. A \
                     combination that leaves it out tells",
                    table.header(),
                    index + 1
                )
            }
            Warning::LoadBesideBody { id, distance, beside } => write!(
                f,
                "{id} = {} m: the force acts {} m beside the body",
                digits(*distance),
                digits(*beside)
            ),
            Warning::LoadOffTheBody { id, lever, above, beside } => {
                let places = [(above, "above the crest"), (beside, "beside the body")];
                let places = places.into_iter().filter(|(by, _)| **by > 0.0);
                let places: Vec<_> = places.map(|(by, words)| format!("{} m {words}", digits(*by))).collect();
                write!(
                    f,
                    "{id} = \"{lever}\": the force acts {}, on what stands on the body; that has to carry it down to the body",
                    places.join(" and ")
                )
            }
            Warning::SmallBearing { pressure } => write!(
                f,
                "criteria.bearing_max = {} kPa; {BEARING} kPa at least is usual, and a number without unit is in Pa",
                digits(*pressure / 1e3)
            ),
            Warning::UnusualGround { id, value } => {
                let (usual, unit, scale, plain) = match id.key {
                    Key::Strength => (STRENGTH, "kPa", 1e3, "Pa"),
                    Key::UndrainedStrength => (UNDRAINED, "kPa", 1e3, "Pa"),
                    Key::UnitWeight | Key::SoilWeight | Key::SaturatedWeight | Key::DryWeight => {
                        (UNIT_WEIGHT, "kN/m³", 1e3, "N/m³")
                    }
                    _ => (STIFFNESS, "MN/m³", 1e6, "N/m³"),
                };
                let value = beyond(*value / scale, usual.limit(*value / scale));
                write!(
                    f,
                    "{id} = {value} {unit}; {usual} {unit} is usual, and a number without unit is in {plain}"
                )
            }
            Warning::StrongEarthquake { key, acceleration, share }
            | Warning::WeakEarthquake { key, acceleration, share } => write!(
                f,
                "{key} = {} m/s² is {} g; usual peaks: {SHAKING} g. Check its unit",
                digits(*acceleration),
                beyond(*share, SHAKING.limit(share.abs()).copysign(*share))
            ),
            Warning::WaveHeightRatio { maximum, significant } => write!(
                f,
                "Hmax = {} m is {} times H13 = {} m; {HEIGHTS} times is usual, 1.8 where no wave breaks",
                digits(*maximum),
                beyond(maximum / significant, HEIGHTS.limit(maximum / significant)),
                digits(*significant)
            ),
            Warning::BuoyantAboveWeight { buoyant, weight, extent } => write!(
                f,
                "buoyant_weight = {} is more than the weight m g = {}, from which buoyancy only takes",
                extent.kilonewtons(*buoyant),
                extent.kilonewtons(*weight)
            ),
            Warning::BuoyantBesideDisplacement { buoyant, weight, displaced, extent } => write!(
                f,
                "buoyant_weight = {}, but the weight m g = {} less the water displaced, ρ g × width of the base × \
                 base_depth = {}, is {}",
                extent.kilonewtons(*buoyant),
                extent.kilonewtons(*weight),
                extent.kilonewtons(*displaced),
                extent.kilonewtons(weight - displaced)
            ),
            Warning::BuoyantBesideParts { buoyant, of_parts } => {
                // Waves, which tell how deep they stand, are those of a long wall.
                let [given, parts] = [buoyant, of_parts].map(|force| Extent::PerMetre.kilonewtons(*force));
                let off = 100.0 * (of_parts / buoyant - 1.0);
                write!(
                    f,
                    "buoyant_weight = {given}, but the parts less the water they displace weigh {parts}, {} % {}; \
                     buoyant_weight is what counts",
                    digits(off.abs()),
                    if off < 0.0 { "less" } else { "more" }
                )
            }
            Warning::EarthquakeWithoutAddedMass { acceleration } => write!(
                f,
                "earthquake.horizontal = {} m/s² shakes a wall in water, and there is no [added_mass]: the water's share \
                 in the inertia and its pressure on the shaken wall are left out; sides = \"right\" or \"both\" counts them for a wall, mass for \
                 anything else",
                digits(*acceleration)
            ),
            Warning::UpliftBesideWave { given: [left, right], of_waves } => write!(
                f,
                "[uplift], {} at the left and {} at the right, acts beside the waves' own uplift, pu = {}: what is \
                 one pressure is counted twice",
                kilopascals(*left),
                kilopascals(*right),
                kilopascals(*of_waves)
            ),
            Warning::AdhesionCarries { situation, adhesion, resistance, extent } => write!(
                f,
                "{}adhesion holds {} of {} against sliding: without it the body has less than half of that",
                under(situation),
                extent.kilonewtons(*adhesion),
                extent.kilonewtons(*resistance)
            ),
            Warning::JointWouldOpen { situation, joint, share } => write!(
                f,
                "{}{joint} is pressed over {} of its length, and water stands in it at different pressures: it would open and let in the higher \
                 one, which is not followed; the diagram in it stays straight",
                under(situation),
                percent(*share)
            ),
            Warning::PassiveWithLowFactor { situation, name, factor } => write!(
                f,
                "{}the factor against sliding is {} with the passive soil {name}; 2 at least is usual where it counts, 1.5 without",
                under(situation),
                digits(*factor)
            ),
            Warning::FormulaRecalled { what, source } => {
                write!(f, "{what} is by a formula that is recalled, not read: {source}")
            }
            Warning::CrownWallHeight { wall, body } => write!(
                f,
                "the waves meet a crown wall of {} m, and the body is {} m high",
                digits(*wall),
                digits(*body)
            ),
            Warning::Wave(warning) => warning.fmt(f),
        }
    }
}
