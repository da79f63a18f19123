//! Inputs, and the conditions that they have to meet: the vocabulary of [`InputError`](crate::InputError).

use std::fmt;

/// Defines an enum whose variants have words.
macro_rules! worded {
    ($(#[$meta:meta])* $name:ident { $($variant:ident => $words:literal,)* }) => {
        $(#[$meta])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum $name {
            $(#[doc = $words] $variant,)*
        }

        impl $name {
            /// In words, as they stand in a message.
            pub fn words(self) -> &'static str {
                match self {
                    $($name::$variant => $words,)*
                }
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(self.words())
            }
        }
    };
}

worded! {
    /// A quantity that a caller gives.
    Quantity {
        Slenderness => "slenderness γ",
        KPrime => "elevation k'",
        K => "force k",
        Friction => "friction μ",
        KineticFriction => "kinetic friction",
        Gravity => "gravity",
        Width => "width",
        Height => "height",
        Length => "length",
        Mass => "mass",
        Density => "density",
        PartCorner => "corner of a part",
        CentroidOffset => "offset of the centre of mass",
        CentroidHeight => "height of the centre of mass",
        BaseLeft => "left half of the base",
        BaseRight => "right half of the base",
        MomentOfInertia => "moment of inertia",
        AddedMass => "added mass",
        Force => "force",
        ForceElevation => "elevation of the force",
        BuoyantWeight => "buoyant weight",
        WeightArm => "arm of the buoyant weight",
        WaterLevel => "water level",
        WaterDensity => "water density",
        Pressure => "pressure",
        PressurePosition => "position of a pressure",
        Acceleration => "acceleration of the base",
        BaseCorner => "corner of the base",
        BaseCentre => "centre of the base",
        BaseRadius => "radius of the base",
        TorsionalMoment => "moment about the vertical",
        LoadFactor => "load factor",
        WaterDepth => "water depth",
        SeaBottomSlope => "sea bottom slope",
        WavePeriod => "wave period",
        WaveAngle => "wave angle",
        WaveTurn => "turn of the waves",
        DeepWaterHeight => "deep-water wave height",
        SignificantHeight => "significant wave height",
        MaximumHeight => "maximum wave height",
        WaveHeight => "wave height",
        BaseDepth => "depth of the base",
        BermDepth => "depth above the berm",
        CrestHeight => "crest height",
        BermWidth => "berm width",
        CaissonWidth => "caisson width",
        ArmourSlope => "slope of the armour",
        ArmourCrest => "crest of the armour",
        ArmourWidth => "width of the armour's crest",
        WallHeight => "height of the wall",
        BaseFreeboard => "base of the wall above still water",
        VolumeShare => "share of the run-up wedge",
        Roughness => "roughness factor of the armour",
        Lambda1 => "factor lambda1",
        Lambda2 => "factor lambda2",
        Lambda3 => "factor lambda3",
        B1 => "distance b1 of O",
        B2 => "distance b2 of O'",
        D => "depth d of the base",
        Rho2 => "square rho2 of the radius of gyration",
        InertiaX => "inertia m_x",
        InertiaY => "inertia m_y",
        MuS => "static friction mu_s",
        MuK => "kinetic friction mu_k",
        Adhesion => "adhesion",
        Resistance => "resistance",
        WrenchX => "horizontal force x",
        WrenchP => "vertical force p",
        WrenchM => "moment m",
        JointHeight => "height h of the joint",
        JointLeft => "left end l of the joint",
        JointRight => "right end r of the joint",
        Strength => "strength of the base",
        Omega => "share ω of the base",
        GroundFrictionAngle => "angle of friction of the ground",
        UnitWeight => "effective unit weight of the ground",
        Surcharge => "surcharge beside the base",
        Cohesion => "cohesion of the ground",
        UndrainedStrength => "undrained strength of the ground",
        BearingShare => "share u of what the ground bears",
        CentricResistance => "centric resistance of the base",
        EnvelopeSlope => "slope of the envelope",
        EnvelopeCoupling => "coupling of the envelope",
        Stiffness => "stiffness of the ground",
        TangentialStiffness => "tangential stiffness of the ground",
        HalfWidth => "half width of the base",
        Eccentricity => "eccentricity",
        Rotation => "rotation",
        LoadTime => "time of a load",
        LoadShare => "share of a load",
        PeriodsFollowed => "time in which an elastic base is followed, in its shortest periods,",
    }
}

worded! {
    /// Condition that a quantity has to meet.
    Expected {
        Finite => "a number from -1e50 to 1e50",
        NotNegative => "a number from 0 to 1e50",
        Positive => "a number above zero, from 1e-50 to 1e50",
        BetweenCorners => "one that lies between O and O'",
        NotAboveCrest => "no more than the height of the body: its crest has to stand above still water",
        NotAboveStaticFriction => "no more than the friction to stick",
        NotBelowKineticFriction => "no less than the kinetic friction mu_k",
        RightAngleAtMost => "from 0 to 90 degrees from the wall's normal",
        FifteenDegreesAtMost => "from 0 to 15 degrees",
        NotBelowSignificantHeight => "no less than the significant wave height",
        NotBelowSeaBed => "no more than the water depth: the berm lies on the sea bed",
        WavesHeadOn => "0: the formula is for waves head on",
        NotBelowBed => "no more than the water depth: the base stands on the bed or above it",
        BelowTrough => "more than the fall of the water in a trough: the base has to stay under it",
        StandingWave => "less: no wave so steep stands before a wall",
        ShareAtMostOne => "a share from 0 to 1",
        AboveStillWater => "above zero: the crest has to stand above still water",
        BelowOne => "a number from 0 to below 1",
        GroundAngle => "an angle from 20 to 50 degrees",
        CouplingBelowOne => "a number from -1 to 1",
        StraightLines => "a history of straight lines: springs have no closed form here for sines",
        TimesInOrder => "times that do not fall from point to point",
        PeriodsAtMost => "100000 at most: stiffnesses, dimensions and durations are out of proportion",
        RectangularBase => "none for a round base: the formulas are those of a strip",
        BeyondLeftEnd => "one beyond the left end",
        InOrder => "positions that rise from point to point",
        NoneButOnDisc => "none, but on a disc: another base has no one answer to it",
    }
}
