//! Every key of a case file, once: its table and name, what it measures and may be, its symbol and its words, an example, what
//! is taken where the file is silent, and what moves with it when it is varied.
//!
//! The parser, errors and their suggestions, `design`, the calculation sheet, the schema and the page of keys come from this
//! table.

use std::cmp::Ordering;
use std::fmt;

use standfast::Quantity;
use standfast::wave::STEEPEST;

use crate::listed;
use crate::units::Dimension;

/// A table of a case file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Table {
    /// The top of the file, above all tables.
    Top,
    /// Zero of the levels.
    Datum,
    /// Units and digits of answers.
    Output,
    /// The body and its friction.
    Body,
    /// A part that the body is made of.
    Part,
    /// The base seen from above.
    Footprint,
    /// A joint that parts the body into two.
    Joint,
    /// The ground: strength and stiffness of the base.
    Ground,
    /// Waves from the right.
    Wave,
    /// Still water.
    Water,
    /// Drains under the base.
    Drain,
    /// Pressures under the base.
    Uplift,
    /// A base that is shaken.
    Earthquake,
    /// Water that moves with the body.
    AddedMass,
    /// Pressures along faces.
    Pressure,
    /// Soil beside the body.
    Backfill,
    /// A layer of it.
    BackfillLayer,
    /// Keys that a soil has, of one layer or of several; no table of a file itself.
    Soil,
    /// Forces.
    Load,
    /// Couples.
    Moment,
    /// Forces with a limit that hold the body.
    Resistance,
    /// Loads that act together, and their factors.
    Combination,
    /// Criteria on the results.
    Criteria,
    /// The motion in time.
    Motion,
    /// Impact of a corner on the base.
    Impact,
    /// What the ratio of an impact follows from.
    ImpactRatio,
    /// State in which the motion begins.
    Initial,
    /// Copies of the motion with numbers a little other.
    Copies,
    /// Motion of the base.
    Base,
    /// Its acceleration to the right over time.
    BaseHorizontal,
    /// Its acceleration upwards over time.
    BaseVertical,
    /// Its acceleration away from the viewer of the section.
    BaseHorizontalZ,
    /// Waves over time.
    WaveHistory,
    /// A force over time.
    LoadHistory,
    /// Storms of a life.
    Storm,
    /// A point of the report's plane.
    Point,
    /// A body in pure numbers.
    Block,
    /// Forces on it.
    BlockLoad,
    /// One of these over time.
    BlockLoadHistory,
    /// Keys that the histories of all tables have; no table of a file itself.
    History,
}

impl Table {
    /// All tables, in the order in which their numbers are listed.
    pub const ALL: [Table; 40] = [
        Table::Top,
        Table::Datum,
        Table::Output,
        Table::Body,
        Table::Part,
        Table::Footprint,
        Table::Joint,
        Table::Ground,
        Table::Wave,
        Table::Water,
        Table::Drain,
        Table::Uplift,
        Table::Earthquake,
        Table::AddedMass,
        Table::Pressure,
        Table::Backfill,
        Table::BackfillLayer,
        Table::Soil,
        Table::Load,
        Table::Moment,
        Table::Resistance,
        Table::Combination,
        Table::Criteria,
        Table::Motion,
        Table::Impact,
        Table::ImpactRatio,
        Table::Initial,
        Table::Copies,
        Table::Base,
        Table::BaseHorizontal,
        Table::BaseVertical,
        Table::BaseHorizontalZ,
        Table::WaveHistory,
        Table::LoadHistory,
        Table::Storm,
        Table::Point,
        Table::Block,
        Table::BlockLoad,
        Table::BlockLoadHistory,
        Table::History,
    ];

    /// The table that it stands in; `None` of the top, and of what no file has.
    pub const fn parent(self) -> Option<Table> {
        match self {
            Table::Top | Table::History | Table::Soil => None,
            Table::BackfillLayer => Some(Table::Backfill),
            Table::Drain => Some(Table::Water),
            Table::Impact | Table::Initial | Table::Copies | Table::Base => Some(Table::Motion),
            Table::ImpactRatio => Some(Table::Impact),
            Table::BaseHorizontal | Table::BaseVertical | Table::BaseHorizontalZ => Some(Table::Base),
            Table::WaveHistory => Some(Table::Wave),
            Table::LoadHistory => Some(Table::Load),
            Table::BlockLoad => Some(Table::Block),
            Table::BlockLoadHistory => Some(Table::BlockLoad),
            _ => Some(Table::Top),
        }
    }

    /// The tables that stand in it.
    pub fn children(self) -> impl Iterator<Item = Table> {
        Table::ALL.into_iter().filter(move |table| table.parent() == Some(self))
    }

    /// True if it is a history: a quantity over time.
    pub const fn is_history(self) -> bool {
        matches!(
            self,
            Table::BaseHorizontal
                | Table::BaseVertical
                | Table::BaseHorizontalZ
                | Table::WaveHistory
                | Table::LoadHistory
                | Table::BlockLoadHistory
        )
    }

    /// True if it belongs to the motion in time alone.
    pub const fn is_of_motion(self) -> bool {
        matches!(
            self,
            Table::Motion
                | Table::Impact
                | Table::ImpactRatio
                | Table::Initial
                | Table::Copies
                | Table::Base
                | Table::BaseHorizontal
                | Table::BaseVertical
                | Table::BaseHorizontalZ
        )
    }

    /// The table under which its keys are listed, or those that are its own.
    const fn listed(self) -> Table {
        if self.is_history() { Table::History } else { self }
    }

    /// True if the keys that soils have are among its keys.
    pub const fn is_of_soil(self) -> bool {
        matches!(self, Table::Backfill | Table::BackfillLayer)
    }

    /// Its name in the table that it stands in; empty for the top.
    pub fn name(self) -> &'static str {
        match self {
            Table::Top => "",
            Table::Datum => "datum",
            Table::Output => "output",
            Table::Body => "body",
            Table::Part => "part",
            Table::Joint => "joint",
            Table::Footprint => "base",
            Table::Ground => "ground",
            Table::Wave => "wave",
            Table::Water => "water",
            Table::Drain => "drain",
            Table::Uplift => "uplift",
            Table::Earthquake => "earthquake",
            Table::AddedMass => "added_mass",
            Table::Pressure => "pressure",
            Table::Backfill => "backfill",
            Table::BackfillLayer => "layer",
            Table::Soil => "soil",
            Table::Load => "load",
            Table::Moment => "moment",
            Table::Resistance => "resistance",
            Table::Combination => "combination",
            Table::Criteria => "criteria",
            Table::Motion => "motion",
            Table::Impact => "impact",
            Table::ImpactRatio => "ratio",
            Table::Initial => "initial",
            Table::Copies => "copies",
            Table::Base => "base",
            Table::BaseHorizontal => "horizontal",
            Table::BaseVertical => "vertical",
            Table::BaseHorizontalZ => "horizontal_z",
            Table::WaveHistory | Table::LoadHistory | Table::BlockLoadHistory | Table::History => "history",
            Table::Storm => "storm",
            Table::Point => "point",
            Table::Block => "block",
            Table::BlockLoad => "load",
        }
    }

    /// Its place in a file as keys name it, the `index`-th of those that repeat: `motion.base.horizontal`, `load[2].history`.
    pub fn path(self, index: usize) -> String {
        let [of, _] = self.places(index);
        let place = if self.repeats() { format!("[{}]", self.number(index)) } else { String::new() };
        match self.parent() {
            None => self.name().to_owned(),
            Some(Table::Top) => format!("{}{place}", self.name()),
            Some(parent) => format!("{}.{}{place}", parent.path(of), self.name()),
        }
    }

    /// The place of the table in which an `index`-th table stands, and its own place there.
    pub const fn places(self, index: usize) -> [usize; 2] {
        if matches!(self, Table::BackfillLayer) { [index / LAYERS, index % LAYERS] } else { [index; 2] }
    }

    /// The number by which people call an `index`-th table: its place where it stands, counted from one; of joints from the base, which is joint 1.
    pub const fn number(self, index: usize) -> usize {
        let [_, own] = self.places(index);
        if matches!(self, Table::Joint) { own + 2 } else { own + 1 }
    }

    /// The number of a table at a place in that of another place; the inverse of [`places`](Table::places).
    pub const fn index_in(self, of: usize, place: usize) -> usize {
        if matches!(self, Table::BackfillLayer) { of * LAYERS + place } else { place }
    }

    /// The most tables of its kind in one other; no limit but for layers.
    pub const fn most(self) -> usize {
        if matches!(self, Table::BackfillLayer) { LAYERS } else { usize::MAX }
    }

    /// The name of its loads in a combination; `None` for one whose loads have names of their own, or that has none.
    pub fn in_combination(self) -> Option<&'static str> {
        match self {
            Table::Body => Some("weight"),
            Table::Water | Table::Uplift | Table::Wave | Table::Earthquake => Some(self.name()),
            _ => None,
        }
    }

    /// Its header as it stands in a file; in words for the top.
    pub fn header(self) -> &'static str {
        match self {
            Table::Top => "the case file",
            Table::Datum => "`datum`",
            Table::Output => "[output]",
            Table::Body => "[body]",
            Table::Part => "[[part]]",
            Table::Joint => "[[joint]]",
            Table::Footprint => "[base]",
            Table::Ground => "[ground]",
            Table::Wave => "[wave]",
            Table::Water => "[water]",
            Table::Drain => "`drain` of [water]",
            Table::Uplift => "[uplift]",
            Table::Earthquake => "[earthquake]",
            Table::AddedMass => "[added_mass]",
            Table::Pressure => "[[pressure]]",
            Table::Backfill => "[[backfill]]",
            Table::BackfillLayer => "[[backfill.layer]]",
            Table::Soil => "a soil",
            Table::Load => "[[load]]",
            Table::Moment => "[[moment]]",
            Table::Resistance => "[[resistance]]",
            Table::Combination => "[[combination]]",
            Table::Criteria => "[criteria]",
            Table::Motion => "[motion]",
            Table::Impact => "[motion.impact]",
            Table::ImpactRatio => "`ratio` of [motion.impact]",
            Table::Initial => "[motion.initial]",
            Table::Copies => "[motion.copies]",
            Table::Base => "[motion.base]",
            Table::BaseHorizontal => "`horizontal` of [motion.base]",
            Table::BaseVertical => "`vertical` of [motion.base]",
            Table::BaseHorizontalZ => "`horizontal_z` of [motion.base]",
            Table::WaveHistory => "the history of the [wave]",
            Table::LoadHistory => "the history of a [[load]]",
            Table::Storm => "[storm]",
            Table::Point => "[point]",
            Table::Block => "[block]",
            Table::BlockLoad => "[[block.load]]",
            Table::BlockLoadHistory => "the history of a [[block.load]]",
            Table::History => "a history",
        }
    }

    /// Its purpose, in words.
    pub fn words(self) -> &'static str {
        match self {
            Table::Top => "above all tables",
            Table::Datum => {
                "zero of the levels, with which a height or a depth may be written as a level: \"+4.10 mCD\""
            }
            Table::Output => {
                "units and digits in which answers are written: text, sheet and figures, CSV and Excel; JSON, Parquet and Arrow stay SI"
            }
            Table::Body => "the body and its friction",
            Table::Part => {
                "one such table for each part of the section: a rectangle or trapezoid, or a polygon; parts touch, and a cavity \
                 is a part of density 0; mass, centre of mass and moment of inertia follow"
            }
            Table::Joint => {
                "one such table for each level joint above the base, which is joint 1: what is above stands on what is below with friction of its own"
            }
            Table::Footprint => {
                "where the body bears, seen from above, in place of its width by its length: with it loads may come from any direction"
            }
            Table::Ground => {
                "what the base can bear, without which it is rigid and bears everything: a strength at which it crushes; or ground \
                 that fails, by a friction angle or an envelope; and a stiffness, alone or beside them"
            }
            Table::Wave => "waves, with the sea at the right, by Goda's formulas or another",
            Table::Water => "still water on both sides and under the base",
            Table::Drain => "a line of drains under the base, between the heads of both sides",
            Table::Uplift => "pressures under the base that are not buoyancy",
            Table::Earthquake => "an acceleration of the base",
            Table::AddedMass => "water that moves with the body",
            Table::Pressure => {
                "one such table for each pressure along a face, linear from point to point and nothing outside"
            }
            Table::Backfill => {
                "one such table for each soil beside a side of the body: its pressure follows from its friction; its surcharge is a variable \
                 load of its own"
            }
            Table::BackfillLayer => {
                "one such table for each layer, from the top down, in place of the soil's own keys; the last reaches the base"
            }
            Table::Soil => "what a [[backfill]] of one soil has, or each of its layers",
            Table::Load => {
                "one such table for each force; each acts alone, beside all other loads, unless it is permanent or \
                 `together = true`"
            }
            Table::Moment => "one such table for each couple; it acts with the others as a [[load]] does",
            Table::Resistance => {
                "one such table for each force with a limit that holds the body, as a tie or an anchor: it is there as far as rest needs it"
            }
            Table::Combination => {
                "one such table for each set of loads that act together, times factors; of the loads not named, the permanent \
                 ones act as they are and the variable ones not at all; of a case with combinations these alone are answered"
            }
            Table::Criteria => "what is asked of the results, under their names; none is imposed",
            Table::Motion => {
                "the motion in time: how the base moves, how corners meet it, how the motion begins"
            }
            Table::Impact => "impacts of a corner on the base",
            Table::ImpactRatio => {
                "what the ratio of the rates after and before an impact follows from, one of both"
            }
            Table::Initial => {
                "how the motion begins, or goes on from a moment of another; at rest without it"
            }
            Table::Copies => {
                "copies of the motion whose numbers differ a little, where one motion is no answer"
            }
            Table::Base => "how the base moves: a history for each direction",
            Table::BaseHorizontal => "acceleration of the base to the right",
            Table::BaseVertical => "acceleration of the base upwards",
            Table::BaseHorizontalZ => {
                "acceleration of the base away from the viewer of the section, of a base seen from above"
            }
            Table::WaveHistory => "how thrust and uplift of the waves go with time",
            Table::LoadHistory => "how the load goes with time",
            Table::Storm => {
                "storms of a life, one a year, with [random]: how far their waves slide the body; without [body] a thrust in proportion to the \
                 wave's height"
            }
            Table::Point => "a point of the report's plane in place of a body, with [random]",
            Table::Block => {
                "a body in pure numbers, in place of all tables but [motion] and [criteria]: lengths in any one unit, the mass as 1"
            }
            Table::BlockLoad => {
                "one such table for each force on a [block], in units of its mass times acceleration"
            }
            Table::BlockLoadHistory => "how the force goes with time",
            Table::History => {
                "how a load or the acceleration of the base goes with time: a shape with its numbers, zero before it begins and after its end"
            }
        }
    }

    /// True if a file may have it more than once.
    pub fn repeats(self) -> bool {
        matches!(
            self,
            Table::Part
                | Table::Joint
                | Table::Pressure
                | Table::Backfill
                | Table::BackfillLayer
                | Table::Load
                | Table::Moment
                | Table::Resistance
                | Table::Combination
                | Table::BlockLoad
        )
    }

    /// Its keys, in their order.
    pub fn keys(self) -> impl Iterator<Item = Key> {
        let (listed, is_of_soil) = (self.listed(), self.is_of_soil());
        let is_among = move |of: Table| of == listed || of == Table::Soil && is_of_soil;
        Key::ALL.iter().zip(&TABLES).filter(move |(_, of)| is_among(**of)).map(|(key, _)| *key)
    }

    /// Lines of a file that have the table right.
    pub fn example(self) -> &'static str {
        match self {
            Table::Datum => "datum = { base = \"-8.20 m\", name = \"CD\" }",
            Table::Output => "[output]\nforce = \"MN/m\"\ndigits = 5",
            Table::Body => {
                "[body]\nwidth = \"15 m\"\nheight = \"12 m\"\ndensity = \"2.1 t/m3\"\nfriction = 0.6"
            }
            Table::Part => {
                "[[part]]\nname = \"footing\"\nleft = 0\nwidth = \"15 m\"\nbottom = 0\nheight = \"1.5 m\"\n\
                 density = \"2400 kg/m3\""
            }
            Table::Joint => "[[joint]]\nname = \"crown wall on cap\"\nelevation = \"8 m\"\nfriction = 0.7",
            Table::Footprint => {
                "[base]\nfeet = [[0, \"0.45 m\"], [\"-0.39 m\", \"-0.225 m\"], [\"0.39 m\", \"-0.225 m\"]]"
            }
            Table::Ground => "[ground]\nfriction_angle_deg = 35\nunit_weight = \"10 kN/m3\"",
            Table::Water => "[water]\nlevel = \"7.1 m\"",
            Table::Drain => "drain = { distance = \"2.5 m\", efficiency = 0.5 }",
            Table::Pressure => {
                "[[pressure]]\nname = \"backfill\"\nface = \"right\"\nelevation = [\"0 m\", \"9 m\"]\n\
                 pressure = [\"54 kPa\", \"0 kPa\"]\npermanent = true"
            }
            Table::Backfill | Table::Soil => {
                "[[backfill]]\nname = \"sand\"\nface = \"right\"\nfriction_angle_deg = 33\nunit_weight = \"18 kN/m3\""
            }
            Table::BackfillLayer => {
                "[[backfill.layer]]\nthickness = \"4 m\"\nfriction_angle_deg = 33\nunit_weight = \"18 kN/m3\""
            }
            Table::Moment => "[[moment]]\nname = \"gate\"\nmoment = \"120 kN m/m\"",
            Table::Resistance => {
                "[[resistance]]\nname = \"tie\"\nlimit = \"150 kN/m\"\ndirection = \"right\"\nelevation = \"9 m\""
            }
            Table::Combination => "[[combination]]\nname = \"storm\"\nfactors = { weight = 0.9, wave = 1.3 }",
            Table::Criteria => "[criteria]\nSF_sliding = 1.2\nSF_overturning_net = 1.2",
            Table::Motion
            | Table::Base
            | Table::BaseHorizontal
            | Table::BaseVertical
            | Table::BaseHorizontalZ => {
                "[motion.base]\nhorizontal = { shape = \"half-sine\", peak = \"4 m/s2\", duration = \"0.5 s\" }"
            }
            Table::Impact => "[motion.impact]\nlaw = \"ratio\"\nratio = 0.9",
            Table::ImpactRatio => "ratio = { points = 3 }",
            Table::Initial => "[motion.initial]\ntheta = 0.05",
            Table::Copies => "[motion.copies]\nnumber = 100\nspread = 0.01",
            Table::WaveHistory | Table::LoadHistory | Table::BlockLoadHistory | Table::History => {
                "history = { shape = \"triangle\", rise = \"0.2 s\", duration = \"0.4 s\" }"
            }
            Table::Storm => "[storm]\nwaves = 1000\ntau0 = \"1.5 s\"",
            Table::Point => "[point]\ngamma = 0.8\nk_prime = 0.9167\nk = 0.45\nmu = 0.6",
            Table::Block => "[block]\nb1 = 1\nb2 = 1\nd = 3\nmu_s = 0.6\ngravity = 1",
            Table::BlockLoad => {
                "[[block.load]]\ndirection = [-1, 0]\nhistory = { shape = \"triangle\", rise = 0.2, duration = 0.4 }"
            }
            _ => "[[load]]\nforce = \"450 kN/m\"\nelevation = \"8 m\"",
        }
    }
}

/// The most layers of a backfill.
const LAYERS: usize = 64;

/// Range of the numbers that a key takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Range {
    /// Any finite number.
    Finite,
    /// Zero or more.
    NotNegative,
    /// Above zero.
    Positive,
    /// Above zero, 1 at most.
    Share,
    /// From 0 to 1.
    ZeroToOne,
    /// An angle of friction of ground, degrees.
    GroundAngle,
    /// An angle of friction of soil beside a wall, degrees.
    SoilAngle,
    /// Batter of the back of a wall, degrees.
    Batter,
    /// Height of the increment of an earthquake, as a share of that of the soil.
    Increment,
    /// Overconsolidation ratio.
    FromOne,
    /// So many digits.
    Digits,
    /// Slope of a floor, degrees.
    Floor,
    /// Direction seen from above, degrees.
    Turn,
    /// Steepness of waves in deep water, H₀'/L₀.
    Steepness,
}

impl Range {
    /// True if a number is in the range.
    pub fn contains(self, value: f64) -> bool {
        let in_range = match self {
            Range::Finite => true,
            Range::NotNegative => value >= 0.0,
            Range::Positive => value > 0.0,
            Range::Share => value > 0.0 && value <= 1.0,
            Range::ZeroToOne => (0.0..=1.0).contains(&value),
            Range::GroundAngle
            | Range::SoilAngle
            | Range::Batter
            | Range::Increment
            | Range::Floor
            | Range::Turn => {
                let [low, high] = self.ends();
                (low..=high).contains(&value)
            }
            Range::Steepness => value > 0.0 && value <= self.ends()[1],
            Range::FromOne => value >= 1.0,
            Range::Digits => (3.0..=12.0).contains(&value) && value.fract() == 0.0,
        };
        in_range && value.is_finite()
    }

    /// In words, as what is expected.
    pub fn words(self) -> &'static str {
        match self {
            Range::Finite => "a finite number",
            Range::NotNegative => "a finite number, zero or more",
            Range::Positive => "a finite number above zero",
            Range::Share => "a share, above zero and 1 at most",
            Range::ZeroToOne => "a number from 0 to 1",
            Range::GroundAngle => "an angle from 20 to 50 degrees",
            Range::SoilAngle => "an angle from 15 to 50 degrees",
            Range::Batter => "an angle from -20 to 30 degrees",
            Range::Increment => "a share from 0.3333 to 0.6667",
            Range::FromOne => "a finite number, 1 or more",
            Range::Digits => "a whole number from 3 to 12",
            Range::Floor => "an angle from -45 to 45 degrees",
            Range::Turn => "an angle from -360 to 360 degrees",
            Range::Steepness => "a steepness, above zero and 0.142 at most, where waves break",
        }
    }

    /// The ends of the range; infinite where it has none.
    pub fn ends(self) -> [f64; 2] {
        match self {
            Range::Finite => [f64::NEG_INFINITY, f64::INFINITY],
            Range::NotNegative | Range::Positive => [0.0, f64::INFINITY],
            Range::Share | Range::ZeroToOne => [0.0, 1.0],
            Range::GroundAngle => [20.0, 50.0],
            Range::SoilAngle => [15.0, 50.0],
            Range::Batter => [-20.0, 30.0],
            Range::Increment => [0.3333, 0.6667],
            Range::FromOne => [1.0, f64::INFINITY],
            Range::Digits => [3.0, 12.0],
            Range::Floor => [-45.0, 45.0],
            Range::Turn => [-360.0, 360.0],
            Range::Steepness => [0.0, STEEPEST],
        }
    }
}

/// Kind of value that a key takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Words.
    Text,
    /// A number with a unit, or without one in SI units.
    Measured(Dimension, Range),
    /// A number without unit.
    Plain(Range),
    /// An acceleration with its unit; g counts the acceleration of gravity of the case.
    InGravity,
    /// One of so many numbers without unit in a list.
    OneOf(usize, Range),
    /// Peak of a history: an acceleration of the base of a body with its unit, else a number without unit.
    Reached,
    /// Numbers without unit in a list.
    Plains,
    /// A file, by its name.
    File,
    /// true or false.
    Truth,
    /// One of these words.
    Choice {
        /// The words.
        of: &'static [&'static str],
        /// The words as they stand in a sentence.
        words: &'static str,
    },
    /// A unit of this dimension, by its name.
    Unit(Dimension),
    /// Numbers with a unit, or without one in SI units, in a list.
    List(Dimension),
    /// Pairs of numbers with a unit, or without one in SI units, in a list.
    Pairs(Dimension),
    /// Names of loads, and the factor of each, or two of them that are tried in turn.
    Factors,
    /// Names of keys, and a value for each.
    Settings,
    /// Names of keys or of resistances, and a number above zero for each.
    Ratios,
    /// Names of numbers, and by how much each scatters; or one number for all.
    Spreads,
    /// Names, and a point [x, y] of each, lengths.
    Places,
    /// Criteria under their names.
    Bounds,
    /// Slides, and the probability of each that may be exceeded: one, or a list of such.
    Exceedances,
    /// Symbols of modes in a list.
    ModeList,
}

/// Quantities that go with a number when it is varied.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Moves {
    /// Nothing.
    Alone,
    /// All dimensions along the base, and the mass, at constant density.
    Width,
    /// The height at constant density, and so the crest above the sea.
    Height,
    /// The length out of the plane, and the mass, at constant density.
    Length,
    /// Everything that weighs.
    Mass,
    /// Friction to stick and to slip.
    Friction,
    /// The density of the water, which may be given twice.
    WaterDensity,
    /// The level of the sea at the right.
    WaterLevel,
    /// The depth of the caisson's base under the sea, its crest staying where it is.
    BaseDepth,
}

/// Everything that is said of a key.
#[derive(Debug, Clone, Copy)]
pub struct KeyInfo {
    /// The table it is in.
    pub table: Table,
    /// Its name there.
    pub name: &'static str,
    /// Kind of value it takes.
    pub kind: Kind,
    /// Its symbol in calculations; empty for what is not a number.
    pub symbol: &'static str,
    /// Its meaning, in words.
    pub words: &'static str,
    /// A value as it may stand in a file.
    pub example: &'static str,
    /// The quantity and, behind a colon, what is taken for it where the file is silent; `None` where the key has to be there,
    /// or nothing is taken.
    pub silent: Option<&'static str>,
    /// Quantities that go with it when it is varied.
    pub moves: Moves,
    /// The library's quantities that this key gives.
    pub gives: &'static [Quantity],
}

impl Kind {
    /// True of an acceleration of the base, which g counts where its numbers have units.
    pub fn is_of_shaking(self) -> bool {
        matches!(self, Kind::InGravity | Kind::Reached)
    }
}

impl KeyInfo {
    const fn silent(self, words: &'static str) -> KeyInfo {
        KeyInfo { silent: Some(words), ..self }
    }

    const fn moves(self, moves: Moves) -> KeyInfo {
        KeyInfo { moves, ..self }
    }

    const fn gives(self, gives: &'static [Quantity]) -> KeyInfo {
        KeyInfo { gives, ..self }
    }

    /// Dimension of its numbers in a case per metre run, see [`Inputs::dimension`](crate::Inputs::dimension) for any; `None` for
    /// plain numbers and for what is not a number.
    pub fn dimension(&self) -> Option<Dimension> {
        match self.kind {
            Kind::Measured(dimension, _) | Kind::List(dimension) | Kind::Pairs(dimension) => Some(dimension),
            Kind::InGravity => Some(Dimension::Acceleration),
            _ => None,
        }
    }

    /// Range of the numbers it takes; `None` for what is not a number.
    pub fn range(&self) -> Option<Range> {
        match self.kind {
            Kind::Measured(_, range) | Kind::Plain(range) => Some(range),
            Kind::InGravity | Kind::Reached => Some(Range::Finite),
            Kind::OneOf(_, range) => Some(range),
            Kind::Text | Kind::Truth | Kind::Choice { .. } | Kind::Unit(_) | Kind::File => None,
            Kind::List(_) | Kind::Pairs(_) | Kind::Plains | Kind::Factors | Kind::ModeList => None,
            Kind::Settings | Kind::Ratios | Kind::Spreads | Kind::Places => None,
            Kind::Bounds | Kind::Exceedances => None,
        }
    }

    /// A line of a file that has the key right.
    pub fn line(&self) -> String {
        format!("{} = {}", self.name, self.example)
    }
}

const fn key(
    table: Table,
    name: &'static str,
    kind: Kind,
    symbol: &'static str,
    words: &'static str,
    example: &'static str,
) -> KeyInfo {
    KeyInfo { table, name, kind, symbol, words, example, silent: None, moves: Moves::Alone, gives: &[] }
}

const fn length(range: Range) -> Kind {
    Kind::Measured(Dimension::Length, range)
}

const FACES: Kind =
    Kind::Choice { of: &["left", "right", "base", "top"], words: "\"left\", \"right\", \"base\" or \"top\"" };
const DIRECTIONS: Kind =
    Kind::Choice { of: &["left", "right", "down", "up"], words: "\"left\", \"right\", \"down\" or \"up\"" };
const SIDE: Kind = Kind::Choice { of: &["left", "right"], words: "\"left\" or \"right\"" };
const EARTH_STATES: Kind =
    Kind::Choice { of: &["active", "rest", "passive"], words: "\"active\", \"rest\" or \"passive\"" };
const HOLDS: Kind = Kind::Choice { of: &["right", "left", "down"], words: "\"right\", \"left\" or \"down\"" };
const ADHESION_ON: Kind =
    Kind::Choice { of: &["pressed", "effective"], words: "\"pressed\" or \"effective\"" };
const JOINT_WATER: Kind = Kind::Choice { of: &["open", "tight"], words: "\"open\" or \"tight\"" };
const PORE_WATER: Kind = Kind::Choice { of: &["free", "with-soil"], words: "\"free\" or \"with-soil\"" };
const OPENINGS: Kind =
    Kind::Choice { of: &["steady", "always", "closed"], words: "\"steady\", \"always\" or \"closed\"" };
const WAVE_FORMULAS: Kind = Kind::Choice {
    of: &["goda", "sainflou", "pedersen", "van-gent"],
    words: "\"goda\", \"sainflou\", \"pedersen\" or \"van-gent\"",
};
const PHASES: Kind = Kind::Choice { of: &["crest", "trough"], words: "\"crest\" or \"trough\"" };
const CODES: Kind = Kind::Choice {
    of: &[
        "EN1997-DA1-1",
        "EN1997-DA1-2",
        "EN1997-DA2",
        "EN1997-DA3",
        "EN1997-EQU",
        "EN1997-UPL",
        "EN1997-HYD",
        "PIANC28-sliding",
        "UFC-3-220-20",
    ],
    words: "the name of a set: \"EN1997-DA1-1\", \"EN1997-DA1-2\", \"EN1997-DA2\", \"EN1997-DA3\", \"EN1997-EQU\", \"EN1997-UPL\", \
            \"EN1997-HYD\", \"PIANC28-sliding\" or \"UFC-3-220-20\"; or a file of your own, \"office.toml\"",
};
const LAWS: Kind =
    Kind::Choice { of: &["ec7", "hansen", "envelope"], words: "\"ec7\", \"hansen\" or \"envelope\"" };
const SHAPES: Kind = Kind::Choice { of: &["block", "cylinder"], words: "\"block\" or \"cylinder\"" };

const SIDES: Kind = Kind::Choice { of: &["left", "right", "both"], words: "\"left\", \"right\" or \"both\"" };
const COURSES: Kind = Kind::Choice {
    of: &SHAPES_IN_TIME,
    words: "\"constant\", \"rect\", \"triangle\", \"decay\", \"half-sine\", \"sine\", \"church-roof\", \"points\" or \"file\"",
};
const BASELINES: Kind = Kind::Choice { of: &["mean", "linear"], words: "\"mean\" or \"linear\"" };
const IMPACTS: Kind = Kind::Choice {
    of: &["inelastic", "housner", "ratio", "poisson", "energetic"],
    words: "\"inelastic\", \"housner\", \"ratio\", \"poisson\" or \"energetic\"",
};

/// The shapes of a history.
const SHAPES_IN_TIME: [&str; 9] =
    ["constant", "rect", "triangle", "decay", "half-sine", "sine", "church-roof", "points", "file"];

const HEIGHTS: Kind = Kind::Choice { of: &["rayleigh"], words: "\"rayleigh\"" };
const PULSES: Kind = Kind::Choice { of: &["triangle", "shimosako"], words: "\"triangle\" or \"shimosako\"" };

const TOUCHING: Kind =
    Kind::Choice { of: &["O", "O'", "both", "none"], words: "\"O\", \"O'\", \"both\" or \"none\"" };
const SLIPPING: Kind =
    Kind::Choice { of: &["left", "right", "none"], words: "\"left\", \"right\" or \"none\"" };

const fn time(range: Range) -> Kind {
    Kind::Measured(Dimension::Time, range)
}

use Kind::{
    Bounds, Exceedances, Factors, File, InGravity, List, Measured, ModeList, OneOf, Pairs, Places, Plain,
    Plains, Ratios, Reached, Settings, Spreads, Text, Truth,
};
use Range::{Batter, Finite, FromOne, Increment, NotNegative, Positive, Share, SoilAngle, Turn, ZeroToOne};
use Table::{
    AddedMass, Backfill, BackfillLayer, Block, BlockLoad, Body, Combination, Copies, Criteria, Datum, Drain,
    Earthquake, Footprint, Ground, History, Impact, ImpactRatio as RatioOfImpact, Initial, Joint, Load,
    Moment, Motion, Output, Part, Point, Pressure, Resistance, Soil, Storm, Top, Uplift, Water, Wave,
};

listed! {
    /// A key of a case file.
    Key: KeyInfo;

    Title = key(Top, "title", Text, "", "title of the case", "\"Caisson in air\"");
    Note = key(Top, "note", Text, "", "source of its numbers", "\"numbers from the preliminary design\"");
    Project = key(Top, "project", Text, "", "the project the calculation is for", "\"Harbour extension\"");
    Client = key(Top, "client", Text, "", "who ordered it", "\"Port authority\"");
    SheetNumber = key(Top, "sheet", Text, "", "number of the calculation sheet", "\"C-104\"");
    Revision = key(Top, "revision", Text, "", "revision of the sheet", "\"B\"");
    Author = key(Top, "author", Text, "", "who made the calculation", "\"A. Moreau\"");
    Checker = key(Top, "checker", Text, "", "who checks it", "\"N. Okafor\"");
    Gravity = key(Top, "gravity", Measured(Dimension::Acceleration, Positive), "g", "acceleration of gravity", "\"9.81 m/s2\"")
        .silent("acceleration of gravity: 9.81 m/s²").gives(&[Quantity::Gravity]);

    DatumBase = key(Datum, "base", length(Finite), "z_0", "level of the base", "\"-8.20 m\"");
    DatumName = key(Datum, "name", Text, "", "name of the datum, as it stands behind the unit of a level", "\"CD\"");

    OutputForce = key(Output, "force", Kind::Unit(Dimension::Force), "", "unit of forces; moments go with it", "\"MN/m\"")
        .silent("unit of forces in answers: kN/m, of an object kN");
    OutputPressure = key(Output, "pressure", Kind::Unit(Dimension::Pressure), "", "unit of pressures", "\"kPa\"")
        .silent("unit of pressures in answers: kPa");
    OutputLength = key(Output, "length", Kind::Unit(Dimension::Length), "", "unit of lengths", "\"m\"")
        .silent("unit of lengths in answers: m");
    OutputDigits = key(Output, "digits", Plain(Range::Digits), "", "significant digits of numbers", "5")
        .silent("digits of numbers in answers: 4, on a sheet 5");

    Width = key(Body, "width", length(Positive), "w", "width of the body", "\"15 m\"")
        .moves(Moves::Width).gives(&[Quantity::Width]);
    Height = key(Body, "height", length(Positive), "h_body", "height of the body", "\"12 m\"")
        .moves(Moves::Height).gives(&[Quantity::Height]);
    Length = key(Body, "length", length(Positive), "L_b", "length out of the plane of a single object, whose masses are in kg and forces in N", "\"0.8 m\"")
        .silent("length: all per metre run").moves(Moves::Length).gives(&[Quantity::Length]);
    Shape = key(Body, "shape", SHAPES, "", "shape; of an upright cylinder the width is the diameter, masses are in kg and forces in N", "\"cylinder\"")
        .silent("shape: a block");
    Mass = key(Body, "mass", Measured(Dimension::Mass, Positive), "m", "mass", "\"370 t/m\"")
        .moves(Moves::Mass).gives(&[Quantity::Mass]);
    Density = key(Body, "density", Measured(Dimension::Density, Positive), "ρ_b", "mean density of the body", "\"2.1 t/m3\"")
        .moves(Moves::Mass).gives(&[Quantity::Density, Quantity::Mass]);
    Friction = key(Body, "friction", Plain(NotNegative), "μ", "Coulomb friction between body and base, to stick", "0.6")
        .moves(Moves::Friction).gives(&[Quantity::Friction]);
    KineticFriction = key(Body, "kinetic_friction", Plain(NotNegative), "μ_k", "Coulomb friction, to slip", "0.5")
        .silent("friction to slip: that to stick").gives(&[Quantity::KineticFriction]);
    Adhesion = key(Body, "adhesion", Measured(Dimension::Pressure, NotNegative), "c_a", "adhesion between body and base, to stick", "\"150 kPa\"")
        .silent("adhesion between body and base: none").gives(&[Quantity::Adhesion]);
    AdhesionOn = key(Body, "adhesion_on", ADHESION_ON, "", "part of the base that adheres: what is \"pressed\", min(B, 3 t), or the \"effective\" width, 2 t", "\"effective\"")
        .silent("part of the base that adheres: what is pressed");
    BaseLeft = key(Body, "base_left", length(Positive), "e_l", "edge of the base left of mid-width", "\"7 m\"")
        .silent("edge of the base left of mid-width: that of the body").gives(&[Quantity::BaseLeft]);
    BaseRight = key(Body, "base_right", length(Positive), "e_r", "edge of the base right of mid-width", "\"7 m\"")
        .silent("edge of the base right of mid-width: that of the body").gives(&[Quantity::BaseRight]);
    CentroidOffset = key(Body, "centroid_offset", length(Finite), "x_C", "centre of mass right of mid-width", "\"0.4 m\"")
        .silent("centre of mass right of mid-width: at mid-width").gives(&[Quantity::CentroidOffset]);
    CentroidHeight = key(Body, "centroid_height", length(Positive), "y_C", "centre of mass above the base", "\"5 m\"")
        .silent("centre of mass above the base: mid-height").gives(&[Quantity::CentroidHeight]);
    MomentOfInertia =
        key(Body, "moment_of_inertia", Measured(Dimension::Inertia, Positive), "I", "moment of inertia about the centre of mass", "\"9500 t m2/m\"")
        .silent("moment of inertia: that of a uniform rectangle").gives(&[Quantity::MomentOfInertia]);
    BuoyantWeight = key(Body, "buoyant_weight", Measured(Dimension::Force, Positive), "W_g", "weight less buoyancy", "\"2300 kN/m\"")
        .gives(&[Quantity::BuoyantWeight]);
    WeightArm = key(Body, "weight_arm", length(Positive), "t_g", "its arm to the left corner O", "\"7.5 m\"")
        .silent("arm of the buoyant weight: that of the weight; of parts, that of the weight less buoyancy").gives(&[Quantity::WeightArm]);
    WidthScale = key(Body, "width_scale", Plain(Positive), "f_w", "factor on the lengths of all parts along the base", "1.1")
        .silent("lengths of parts along the base: as given").moves(Moves::Width).gives(&[Quantity::Width]);

    CentroidZ = key(Body, "centroid_z", length(Finite), "z_C", "centre of mass away from the middle of the length, seen from above", "\"0.02 m\"")
        .silent("centre of mass along the length: in its middle");

    FloorDeg = key(Body, "floor_deg", Plain(Range::Floor), "ε_f", "rise of the floor to the right, degrees; loads keep their directions in space", "6")
        .silent("floor: level");

    PartName = key(Part, "name", Text, "", "name of the part", "\"footing\"");
    PartGroup = key(Part, "group", Text, "", "group of parts whose weight combinations multiply by a factor of its own", "\"fill\"");
    PartLeft = key(Part, "left", length(Finite), "x_p", "left end of its bottom, to the right of the origin of the section", "\"1.5 m\"")
        .gives(&[Quantity::PartCorner]);
    PartWidth = key(Part, "width", length(Positive), "w_p", "width of its bottom", "\"12 m\"")
        .gives(&[Quantity::PartCorner]);
    PartBottom = key(Part, "bottom", length(NotNegative), "y_p", "its bottom above the base", "\"1.5 m\"")
        .gives(&[Quantity::PartCorner]);
    PartHeight = key(Part, "height", length(Positive), "h_p", "height from its bottom to its top", "\"9 m\"")
        .gives(&[Quantity::PartCorner]);
    PartTopLeft = key(Part, "top_left", length(Finite), "x_t", "left end of its top, to the right of the origin of the section", "\"2 m\"")
        .silent("left end of the top: above that of the bottom").gives(&[Quantity::PartCorner]);
    PartTopWidth = key(Part, "top_width", length(NotNegative), "w_t", "width of its top; 0 for a triangle", "\"8 m\"")
        .silent("width of the top: that of the bottom").gives(&[Quantity::PartCorner]);
    PartX = key(Part, "x", List(Dimension::Length), "", "corners of a polygon, one after the other, to the right of the origin of the section", "[\"0 m\", \"4 m\", \"4 m\"]")
        .gives(&[Quantity::PartCorner]);
    PartY = key(Part, "y", List(Dimension::Length), "", "the same corners above the base", "[0, 0, \"3 m\"]")
        .gives(&[Quantity::PartCorner]);
    PartDensity = key(Part, "density", Measured(Dimension::Density, NotNegative), "ρ_p", "density; 0 for a cavity", "\"2400 kg/m3\"")
        .gives(&[Quantity::Density]);
    PartUnitWeight = key(Part, "unit_weight", Measured(Dimension::UnitWeight, NotNegative), "γ_p", "unit weight, in place of the density; 0 for a cavity", "\"24 kN/m3\"")
        .gives(&[Quantity::Density]);
    PartDensityBelow = key(Part, "density_below_water", Measured(Dimension::Density, NotNegative), "ρ_pw", "density under still water, its water with it", "\"2100 kg/m3\"")
        .silent("density under still water: the same as above it").gives(&[Quantity::Density]);

    BasePolygon = key(Footprint, "polygon", Pairs(Dimension::Length), "", "corners of the base seen from above, each [x, z]: x to the right of mid-width, of parts of the origin of their section, z away from the middle of the length; the convex hull counts",
        "[[\"-0.3 m\", \"-0.5 m\"], [\"0.3 m\", \"-0.5 m\"], [\"0.3 m\", \"0.5 m\"], [\"-0.3 m\", \"0.5 m\"]]");
    BaseFeet = key(Footprint, "feet", Pairs(Dimension::Length), "", "feet in place of a polygon, each [x, z]; the convex hull counts",
        "[[0, \"0.45 m\"], [\"-0.39 m\", \"-0.225 m\"], [\"0.39 m\", \"-0.225 m\"]]");
    BaseCircle = key(Footprint, "circle", length(Positive), "D_b", "diameter of a disc in place of a polygon, about the middle of width and length", "\"0.9 m\"");

    JointName = key(Joint, "name", Text, "", "name of the joint", "\"crown wall on cap\"");
    JointElevation = key(Joint, "elevation", length(Positive), "h_j", "its height above the base", "\"8 m\"")
        .gives(&[Quantity::JointHeight]);
    JointFriction = key(Joint, "friction", Plain(NotNegative), "μ_j", "Coulomb friction in it, to stick", "0.7")
        .moves(Moves::Friction).gives(&[Quantity::Friction]);
    JointKineticFriction = key(Joint, "kinetic_friction", Plain(NotNegative), "μ_kj", "Coulomb friction in it, to slip", "0.6")
        .silent("friction to slip in a joint: that to stick").gives(&[Quantity::KineticFriction]);
    JointUplift = key(Joint, "uplift", JOINT_WATER, "", "water in it: \"open\", from the pressure outside at one end to that at the other; or \"tight\", none", "\"open\"")
        .silent("water in a joint: none above all water; else it has to be said");
    JointUpliftLeft = key(Joint, "uplift_left", Measured(Dimension::Pressure, NotNegative), "p_lj", "pressure in it at its left end, in place of uplift", "\"0 kPa\"")
        .gives(&[Quantity::Pressure]);
    JointUpliftRight = key(Joint, "uplift_right", Measured(Dimension::Pressure, NotNegative), "p_rj", "pressure in it at its right end", "\"30 kPa\"")
        .gives(&[Quantity::Pressure]);
    JointGrows = key(Joint, "grows", Truth, "", "whether these pressures rise with the variable loads", "true")
        .silent("pressures in a joint, as given: there all the time");
    JointLeft = key(Joint, "left", length(Finite), "l_j", "its left end, to the right of the origin of the section; of O without parts", "\"6.5 m\"")
        .silent("left end of a joint: of the section just below and above it the farther right").gives(&[Quantity::JointLeft]);
    JointRight = key(Joint, "right", length(Finite), "r_j", "its right end", "\"8 m\"")
        .silent("right end of a joint: of the section just below and above it the farther left").gives(&[Quantity::JointRight]);

    Strength = key(Ground, "strength", Measured(Dimension::Pressure, Positive), "q_u", "pressure at which the base crushes: of stone, mortar, or ground taken so", "\"600 kPa\"")
        .silent("strength of the base: no limit").gives(&[Quantity::Strength]);
    GroundAngle = key(Ground, "friction_angle_deg", Plain(Range::GroundAngle), "φ", "angle of friction of the ground, 20° to 50°", "40")
        .gives(&[Quantity::GroundFrictionAngle]);
    UnitWeight = key(Ground, "unit_weight", Measured(Dimension::UnitWeight, Positive), "γ'", "effective unit weight of the ground; under water less that of water", "\"10 kN/m3\"")
        .gives(&[Quantity::UnitWeight]);
    Surcharge = key(Ground, "surcharge", Measured(Dimension::Pressure, NotNegative), "q'", "effective pressure of the ground beside the base, at its level", "\"15 kPa\"")
        .silent("surcharge beside the base: none").gives(&[Quantity::Surcharge]);
    Cohesion = key(Ground, "cohesion", Measured(Dimension::Pressure, NotNegative), "c'", "effective cohesion of the ground", "\"5 kPa\"")
        .silent("cohesion of the ground: none").gives(&[Quantity::Cohesion]);
    UndrainedStrength = key(Ground, "undrained_strength", Measured(Dimension::Pressure, Positive), "c_u", "undrained shear strength of clay, in place of an angle of friction", "\"60 kPa\"")
        .gives(&[Quantity::UndrainedStrength]);
    GroundLaw = key(Ground, "law", LAWS, "", "bearing resistance: EN 1997-1 Annex D, Brinch Hansen as in API RP 2GEO, or Butterfield and Gottardi’s envelope", "\"hansen\"")
        .silent("bearing resistance of ground with a friction angle: EN 1997-1 Annex D");
    CentricResistance = key(Ground, "centric_resistance", Measured(Dimension::Force, Positive), "V_0", "resistance of the whole base to an upright force in its middle, for the envelope", "\"20 MN/m\"")
        .gives(&[Quantity::CentricResistance]);
    EnvelopeHorizontal = key(Ground, "t_h", Plain(Positive), "t_h", "slope of the envelope at no load, horizontal force over vertical", "0.52")
        .silent("slope t_h of the envelope: 0.52").gives(&[Quantity::EnvelopeSlope]);
    EnvelopeMoment = key(Ground, "t_m", Plain(Positive), "t_m", "the same of moment over vertical force times width of the base", "0.35")
        .silent("slope t_m of the envelope: 0.35").gives(&[Quantity::EnvelopeSlope]);
    EnvelopeCoupling = key(Ground, "C", Plain(Finite), "C_e", "coupling of both; positive where an eccentricity towards the push strengthens", "0.22")
        .silent("coupling C of the envelope: 0.22").gives(&[Quantity::EnvelopeCoupling]);
    Stiffness = key(Ground, "stiffness", Measured(Dimension::Stiffness, Positive), "k_n", "stiffness of the base, pressure over settlement", "\"50 MN/m3\"")
        .silent("stiffness of the base: rigid").gives(&[Quantity::Stiffness]);
    TangentialStiffness = key(Ground, "tangential_stiffness", Measured(Dimension::Stiffness, Positive), "k_t", "the same along the base; without it no periods", "\"25 MN/m3\"")
        .gives(&[Quantity::TangentialStiffness]);

    WaveFormula = key(Wave, "formula", WAVE_FORMULAS, "", "what the pressures come from: Goda’s formulas, Sainflou’s standing waves, or Pedersen’s or Van Gent’s for crown walls", "\"sainflou\"")
        .silent("formula of the waves: Goda’s");
    WaterDepth = key(Wave, "water_depth", length(Positive), "h", "depth at the wall", "\"10.1 m\"")
        .gives(&[Quantity::WaterDepth]);
    SeaBottomSlope = key(Wave, "sea_bottom_slope", Plain(NotNegative), "i", "slope of the sea bed, Goda’s tan θ", "0.01")
        .gives(&[Quantity::SeaBottomSlope]);
    Period = key(Wave, "period", Measured(Dimension::Time, Positive), "T", "significant wave period; of pedersen the mean, of van-gent T_m-1,0", "\"11.4 s\"")
        .gives(&[Quantity::WavePeriod]);
    Steepness = key(Wave, "steepness", Plain(Range::Steepness), "s_0", "steepness in deep water, H_0'/L_0, in place of a period: that goes with `deep_water_height`", "0.04");
    AngleDeg = key(Wave, "angle_deg", Plain(NotNegative), "β_g", "angle of the waves from the wall’s normal", "15")
        .gives(&[Quantity::WaveAngle]);
    WaveWaterDensity = key(Wave, "water_density", Measured(Dimension::Density, Positive), "ρ", "density of the sea", "\"1030 kg/m3\"")
        .silent("density of the sea: that of [water]").moves(Moves::WaterDensity).gives(&[Quantity::WaterDensity]);
    DeepWaterHeight =
        key(Wave, "deep_water_height", length(Positive), "H_0'", "equivalent deep-water wave height", "\"6.3 m\"")
        .gives(&[Quantity::DeepWaterHeight]);
    H13 = key(Wave, "H13", length(Positive), "H_13", "significant wave height at the wall", "\"5.8 m\"")
        .gives(&[Quantity::SignificantHeight]);
    Hmax = key(Wave, "Hmax", length(Positive), "H_max", "maximum wave height at the wall", "\"8.05 m\"")
        .gives(&[Quantity::MaximumHeight]);
    WaveHeight = key(Wave, "height", length(Positive), "H_s", "height of Sainflou’s waves, or \"Hmax\" or \"H13\"", "\"4.5 m\"")
        .gives(&[Quantity::WaveHeight]);
    WavePhase = key(Wave, "phase", PHASES, "", "phase of Sainflou’s waves at the wall", "\"trough\"");
    CaissonWidth = key(Wave, "caisson_width", length(Positive), "B_c", "width of the caisson’s base", "\"15 m\"")
        .silent("width of the caisson’s base: that of the body").moves(Moves::Width).gives(&[Quantity::CaissonWidth]);
    BaseDepth = key(Wave, "base_depth", length(Positive), "h'", "depth of the caisson’s base", "\"7.1 m\"")
        .moves(Moves::BaseDepth).gives(&[Quantity::BaseDepth]);
    StillWaterLevel = key(Wave, "still_water", length(Positive), "h'", "the sea’s level above the base, in place of base_depth", "\"7.1 m\"")
        .moves(Moves::WaterLevel).gives(&[Quantity::BaseDepth]);
    DepthAboveBerm = key(Wave, "depth_above_berm", length(Positive), "d_M", "depth above the berm’s armour, Goda’s d", "\"5.6 m\"")
        .gives(&[Quantity::BermDepth]);
    CrestHeight = key(Wave, "crest_height", length(Finite), "h_c", "crest above still water", "\"3.4 m\"")
        .moves(Moves::Height).gives(&[Quantity::CrestHeight]);
    BermWidth = key(Wave, "berm_width", length(NotNegative), "B_M", "width of the berm", "\"8 m\"")
        .gives(&[Quantity::BermWidth]);
    Lambda1 = key(Wave, "lambda[1]", OneOf(3, NotNegative), "λ1", "factor on the standing pressure", "[1, 1, 1]")
        .silent("factors on the pressures: 1, 1, 1").gives(&[Quantity::Lambda1]);
    Lambda2 = key(Wave, "lambda[2]", OneOf(3, NotNegative), "λ2", "factor on the breaking pressure", "[1, 1, 1]")
        .gives(&[Quantity::Lambda2]);
    Lambda3 = key(Wave, "lambda[3]", OneOf(3, NotNegative), "λ3", "factor on the uplift", "[1, 1, 1]")
        .gives(&[Quantity::Lambda3]);
    Impulsive = key(Wave, "impulsive", Truth, "", "whether Takahashi’s coefficient is used", "true")
        .silent("Takahashi’s coefficient: used");
    WaveUplift = key(Wave, "uplift", Truth, "", "whether the waves press under the base", "false")
        .silent("pressure of the waves under the base: Goda’s");
    TurnDeg = key(Wave, "turn_deg", Plain(NotNegative), "Δβ", "by how much they are turned towards it", "15")
        .silent("waves turned towards the normal by: 0°").gives(&[Quantity::WaveTurn]);
    ArmourSlope = key(Wave, "armour_slope", Plain(Positive), "cot_α", "slope of the armour before a crown wall, its cotangent", "2")
        .gives(&[Quantity::ArmourSlope]);
    ArmourCrest = key(Wave, "armour_crest", length(Positive), "A_c", "crest of the armour above still water", "\"4 m\"")
        .gives(&[Quantity::ArmourCrest]);
    ArmourWidth = key(Wave, "armour_width", length(Positive), "B_a", "width of the crest of the armour", "\"5 m\"")
        .gives(&[Quantity::ArmourWidth]);
    ProtectedHeight = key(Wave, "protected_height", length(NotNegative), "h_p", "height of the crown wall behind the armour, Pedersen’s h'", "\"2 m\"")
        .gives(&[Quantity::WallHeight]);
    FreeHeight = key(Wave, "free_height", length(NotNegative), "f_c", "height of the crown wall above the armour", "\"1.5 m\"")
        .gives(&[Quantity::WallHeight]);
    VolumeShare = key(Wave, "volume_share", Plain(Share), "V_a", "share of the wedge of run-up that the armour leaves, min(A_2/A_1, 1)", "1")
        .silent("share of the wedge of run-up: 1").gives(&[Quantity::VolumeShare]);
    WallHeight = key(Wave, "wall_height", length(Positive), "H_w", "height of the crown wall, of Van Gent’s formula", "\"3.5 m\"")
        .silent("height of the crown wall: that of the body").gives(&[Quantity::WallHeight]);
    WallBase = key(Wave, "wall_base", length(Positive), "B_w", "width of its base", "\"8 m\"")
        .silent("width of the crown wall’s base: that of the body").gives(&[Quantity::Width]);
    BaseFreeboard = key(Wave, "base_freeboard", length(NotNegative), "F_b", "its base above still water", "\"1.5 m\"")
        .gives(&[Quantity::BaseFreeboard]);
    Roughness = key(Wave, "roughness", Plain(Share), "γ_f", "roughness factor of the armour", "0.45")
        .silent("roughness factor of the armour: 1").gives(&[Quantity::Roughness]);

    Level = key(Water, "level", length(NotNegative), "h_l", "still water above the base, both sides", "\"7.1 m\"")
        .moves(Moves::WaterLevel).gives(&[Quantity::WaterLevel]);
    WaterLeft = key(Water, "left", length(NotNegative), "h_l", "still water above the base, left", "\"7.1 m\"")
        .gives(&[Quantity::WaterLevel]);
    WaterRight = key(Water, "right", length(NotNegative), "h_r", "still water above the base, right", "\"7.1 m\"")
        .moves(Moves::WaterLevel).gives(&[Quantity::WaterLevel]);
    WaterDensity = key(Water, "density", Measured(Dimension::Density, Positive), "ρ_w", "density of the water", "\"1030 kg/m3\"")
        .silent("density of the water: that of the waves").moves(Moves::WaterDensity).gives(&[Quantity::WaterDensity]);

    OpeningOf = key(Water, "opening", OPENINGS, "", "what water follows into a base that opens: \"steady\" loads, \"always\" all, \"closed\" none", "\"steady\"")
        .silent("water under a base that opens: follows steady loads, where its levels differ");

    DrainDistance = key(Drain, "distance", length(Positive), "x_d", "drains to the right of the corner O", "\"2.5 m\"");
    DrainEfficiency = key(Drain, "efficiency", Plain(ZeroToOne), "E_d", "share that they take of the straight line's pressure above that of the lower head", "0.5");

    UpliftLeft =
        key(Uplift, "left", Measured(Dimension::Pressure, NotNegative), "p_l", "pressure under the left corner O", "\"20 kPa\"")
        .gives(&[Quantity::Pressure]);
    UpliftRight =
        key(Uplift, "right", Measured(Dimension::Pressure, NotNegative), "p_r", "pressure under the right corner O′", "\"60 kPa\"")
        .gives(&[Quantity::Pressure]);
    UpliftGrows = key(Uplift, "grows", Truth, "", "whether it rises with the variable loads", "true")
        .silent("uplift: there all the time");

    Horizontal =
        key(Earthquake, "horizontal", InGravity, "a_h", "horizontal acceleration of the base, to the right", "\"0.2 g\"    # or \"2 m/s2\"")
        .gives(&[Quantity::Acceleration]);
    Vertical = key(Earthquake, "vertical", InGravity, "a_v", "vertical acceleration of the base, upwards", "\"-0.1 g\"    # or \"-1 m/s2\"")
        .silent("acceleration of the base, upwards: none").gives(&[Quantity::Acceleration]);
    HorizontalZ = key(Earthquake, "horizontal_z", InGravity, "a_z", "horizontal acceleration of the base away from the viewer of the section", "\"0.2 g\"    # or \"2 m/s2\"")
        .silent("acceleration of the base away from the viewer: none").gives(&[Quantity::Acceleration]);
    EarthquakeDirection = key(Earthquake, "direction_deg", Plain(Turn), "φ_a", "direction in which `horizontal` pushes the body, seen from above: 0 to the left, 90 away from the viewer, 180 to the right; or \"worst\" of all", "30    # or \"worst\"")
        .silent("direction of the earthquake: in the plane of the section");
    HorizontalFixed =
        key(Earthquake, "horizontal_fixed", Truth, "", "whether the base moves to the side given only", "true")
        .silent("horizontal acceleration: to both sides");
    VerticalFixed = key(Earthquake, "vertical_fixed", Truth, "", "whether the base moves up or down as given only", "true")
        .silent("vertical acceleration: upwards and downwards");

    WaterMass = key(AddedMass, "mass", Measured(Dimension::Mass, NotNegative), "m_a", "mass of water that moves with the body", "\"50 t/m\"")
        .gives(&[Quantity::AddedMass]);
    WaterElevation = key(AddedMass, "elevation", length(NotNegative), "e_a", "its height above the base, at which it presses on a shaken wall", "\"4 m\"")
        .silent("height of the water that moves along: not known").gives(&[Quantity::ForceElevation]);
    WetSides = key(AddedMass, "sides", SIDES, "", "sides on which water moves with the body; 1 and 2 count them where it is plain which is wet", "\"right\"");

    PressureName = key(Pressure, "name", Text, "", "name of the pressure", "\"backfill\"");
    PressedFace = key(Pressure, "face", FACES, "", "the face it presses on, inwards", "\"right\"");
    PressureElevation =
        key(Pressure, "elevation", List(Dimension::Length), "", "heights above the base, rising, on a side; twice the same for a step", "[\"0 m\", \"9 m\"]")
        .gives(&[Quantity::PressurePosition]);
    PressureDistance =
        key(Pressure, "distance", List(Dimension::Length), "", "distances to the right of the corner O, rising, on base and top; twice the same for a step", "[\"0 m\", \"15 m\"]")
        .gives(&[Quantity::PressurePosition]);
    Pressures = key(Pressure, "pressure", List(Dimension::Pressure), "", "pressures there; below zero they pull", "[\"54 kPa\", \"0 kPa\"]")
        .gives(&[Quantity::Pressure]);
    PressureFactor = key(Pressure, "scale", Plain(Finite), "f_p", "factor on the pressures", "1.2")
        .silent("factor on the pressures: 1").gives(&[Quantity::Pressure]);
    PressurePermanent = key(Pressure, "permanent", Truth, "", "whether it is there all the time", "true")
        .silent("pressure: variable");

    PressureFast = key(Pressure, "fast", Truth, "", "whether it is too fast for water to follow it into a base that opens", "true")
        .silent("pressure: steady");

    BackfillName = key(Backfill, "name", Text, "", "name of the soil", "\"sand\"")
        .silent("name of the soil: backfill");
    BackfillFace = key(Backfill, "face", SIDE, "", "the side of the body that it stands against", "\"right\"");
    BackfillTop = key(Backfill, "top", length(Positive), "H_e", "the ground at that side, above the base", "\"9 m\"")
        .silent("the ground at the side: the crest");
    BackfillState = key(Backfill, "state", EARTH_STATES, "", "\"active\" where the body gives way, \"rest\" where it does not, \"passive\" where it resists the body", "\"active\"")
        .silent("state of the soil: active");
    BackfillSlope = key(Backfill, "slope_deg", Plain(Finite), "β_e", "slope of the ground, rising away from the body", "10")
        .silent("slope of the ground: level");
    BackfillBatter = key(Backfill, "batter_deg", Plain(Batter), "θ_e", "batter of the side, above zero where the soil stands on it", "5")
        .silent("batter of the side: upright");
    BackfillSurcharge = key(Backfill, "surcharge", Measured(Dimension::Pressure, NotNegative), "q_e", "load on the ground, per horizontal area; it is variable, with a name of its own, as \"sand.surcharge\"", "\"20 kPa\"")
        .silent("load on the ground: none");
    PoreWaterMoves = key(Backfill, "pore_water", PORE_WATER, "", "how its water moves in an earthquake: free, as in gravel, or with the soil", "\"free\"")
        .silent("water in the soil in an earthquake: moves freely");
    IncrementAt = key(Backfill, "increment_at", Plain(Increment), "η_e", "height of the increment of an earthquake, as a share of that of the soil", "0.5")
        .silent("height of the increment of an earthquake: 0.6 of the soil's");
    BackfillShare = key(Backfill, "share", Plain(Share), "s_e", "how much of its resistance is counted, of a passive soil, which needs 5 to 10 times the movement of an active one", "0.5");
    LayerThickness = key(BackfillLayer, "thickness", length(Positive), "h_e", "its thickness at the body", "\"4 m\"");
    SoilFriction = key(Soil, "friction_angle_deg", Plain(SoilAngle), "φ_e", "angle of friction of the soil, 15° to 50°", "33");
    WallFriction = key(Soil, "wall_friction_deg", Plain(Finite), "δ_e", "angle of friction between soil and body, no more than that of the soil", "22")
        .silent("angle of friction between soil and body: 0");
    SoilWeight = key(Soil, "unit_weight", Measured(Dimension::UnitWeight, Positive), "γ_e", "unit weight of the soil, moist", "\"18 kN/m3\"");
    SaturatedWeight = key(Soil, "unit_weight_saturated", Measured(Dimension::UnitWeight, Positive), "γ_sat", "unit weight of the soil under water, its water with it", "\"20 kN/m3\"")
        .silent("unit weight under water: needed where water stands in the soil");
    DryWeight = key(Soil, "unit_weight_dry", Measured(Dimension::UnitWeight, Positive), "γ_dry", "unit weight of the soil without its water, of an earthquake with free pore water", "\"16.5 kN/m3\"")
        .silent("unit weight without water: the moist one");
    SoilCohesion = key(Soil, "cohesion", Measured(Dimension::Pressure, NotNegative), "c_e", "effective cohesion of the soil", "\"5 kPa\"")
        .silent("cohesion of the soil: none");
    SoilAdhesion = key(Soil, "adhesion", Measured(Dimension::Pressure, NotNegative), "a_e", "adhesion between soil and body", "\"0 kPa\"")
        .silent("adhesion between soil and body: none");
    Overconsolidation = key(Soil, "ocr", Plain(FromOne), "OCR", "overconsolidation ratio, of a soil at rest", "1")
        .silent("overconsolidation ratio: 1");

    LoadName = key(Load, "name", Text, "", "name of the load", "\"breaking wave\"");
    Force = key(Load, "force", Measured(Dimension::Force, NotNegative), "F", "force", "\"450 kN/m\"")
        .gives(&[Quantity::Force, Quantity::K]);
    Towards = key(Load, "direction", DIRECTIONS, "", "where it points", "\"left\"").silent("direction: left");
    Elevation = key(Load, "elevation", length(NotNegative), "e", "its height above the base", "\"8 m\"")
        .silent("height: needed to the left and right; of a vertical force the crest").gives(&[Quantity::ForceElevation, Quantity::KPrime]);
    LoadDistance = key(Load, "distance", length(Finite), "x_F", "its distance to the right of the corner O", "\"3 m\"")
        .silent("distance: needed down and up; of a horizontal force mid-width");
    LoadDirectionDeg = key(Load, "direction_deg", Plain(Turn), "φ_F", "where it points, seen from above, in place of `direction`: 0 to the left, 90 away from the viewer, 180 to the right", "30")
        .silent("direction from above: in the plane of the section");
    LoadZ = key(Load, "z", length(Finite), "z_F", "where it acts along the length, away from its middle", "\"0.5 m\"")
        .silent("place along the length: its middle");
    LoadLever = key(Load, "lever", Text, "", "what it stands on, where that is above the crest or beside the body", "\"bollard hook\"")
        .silent("a force meets the body itself");
    LoadPermanent = key(Load, "permanent", Truth, "", "whether it is there all the time", "true")
        .silent("load: variable");
    LoadFast = key(Load, "fast", Truth, "", "whether it is too fast for water to follow it into a base that opens", "true")
        .silent("load: steady, unless it goes with time");
    Together = key(Load, "together", Truth, "", "whether it acts with all other loads, rather than alone of those that do", "true")
        .silent("load: alone, an alternative to the others");

    MomentName = key(Moment, "name", Text, "", "name of the couple", "\"gate\"");
    Couple = key(Moment, "moment", Measured(Dimension::Moment, NotNegative), "M_k", "moment of the couple", "\"120 kN m/m\"");
    MomentTowards = key(Moment, "direction", SIDE, "", "to which side it turns the body: \"left\" counter-clockwise", "\"left\"").silent("direction: left");
    MomentPermanent = key(Moment, "permanent", Truth, "", "whether it is there all the time", "true")
        .silent("couple: variable");
    MomentFast = key(Moment, "fast", Truth, "", "whether it is too fast for water to follow it into a base that opens", "true")
        .silent("couple: steady");
    MomentTogether = key(Moment, "together", Truth, "", "whether it acts with all other loads, rather than alone of those that do", "true")
        .silent("couple: alone, an alternative to the others");

    MomentElevation = key(Moment, "elevation", length(NotNegative), "e_M", "its height above the base, which says on which body it acts where there are joints", "\"3 m\"");
    ResistanceName = key(Resistance, "name", Text, "", "name of the resistance", "\"tie\"");
    ResistanceLimit = key(Resistance, "limit", Measured(Dimension::Force, NotNegative), "R_h", "the most that it holds", "\"150 kN/m\"")
        .gives(&[Quantity::Resistance]);
    ResistanceTowards = key(Resistance, "direction", HOLDS, "", "where it holds the body to", "\"right\"");
    ResistanceElevation = key(Resistance, "elevation", length(NotNegative), "e_h", "its height above the base", "\"9 m\"")
        .silent("height: needed to the left and right; of one down the base");
    ResistanceDistance = key(Resistance, "distance", length(Finite), "x_h", "its distance to the right of the corner O", "\"0.5 m\"")
        .silent("distance: needed down; of a horizontal one mid-width");
    ResistanceShare = key(Resistance, "share", Plain(Share), "s_h", "how much of it is counted", "0.8")
        .silent("share of the resistance: all of it");

    CombinationName = key(Combination, "name", Text, "", "name of the combination", "\"storm at low water\"");
    CombinationSet = key(Combination, "set", Settings, "",
        "values of keys in this combination, before all else; what moves with them moves", "{ \"water.level\" = \"6.2 m\" }");
    CombinationScale = key(Combination, "scale", Ratios, "",
        "what numbers of the case are multiplied by, under their keys; what moves with them moves", "{ \"wave.H13\" = 1.2, \"wave.Hmax\" = 1.2 }");
    CombinationMaterials = key(Combination, "materials", Ratios, "",
        "what strengths are divided by, under their keys; of an angle its tangent",
        "{ \"body.friction\" = 1.25, \"ground.friction_angle_deg\" = 1.25 }");
    LoadFactors = key(Combination, "factors", Factors, "",
        "factor on each load, under its name, or weight, water, uplift, wave, earthquake; in more detail \"water.left\", \"water.right\", \"water.base\", \
         \"wave.thrust\", \"wave.uplift\"; of two in brackets, as of what may help or harm, both are tried",
        "{ weight = 0.9, wave = 1.3, crane = [1.5, 0] }");
    CombinationResist = key(Combination, "resist", Ratios, "",
        "what resistances are divided by: sliding, bearing, passive, or a [[resistance]] by its name", "{ sliding = 1.1, bearing = 1.4 }");
    CombinationEffects = key(Combination, "effects", Truth, "",
        "whether factors act on the effects of loads, whose resistance and eccentricity are those of the loads as they are", "true")
        .silent("factors: on the loads");
    CombinationCode = key(Combination, "code", CODES, "",
        "set of partial factors, strengths and criteria that fills in what the combination does not write; recommended values, or a file of them", "\"EN1997-DA1-2\"");
    CombinationOptions = key(Combination, "options", Settings, "",
        "what the set of a code asks for", "{ ground = \"rock\" }");
    CombinationCriteria = key(Combination, "criteria", Bounds, "",
        "what is asked of the results in this combination, in place of [criteria]", "{ SF_sliding = 1.0, eccentricity = \"2.5 m\" }");

    LeastSliding = key(Criteria, "SF_sliding", Plain(Positive), "", "at least: safety factor against sliding", "1.2");
    LeastOverturningNet = key(Criteria, "SF_overturning_net", Plain(Positive), "",
        "at least: safety factor against overturning, net: water under the base taken off the weight; the lesser of both corners", "1.2");
    LeastOverturningGross = key(Criteria, "SF_overturning_gross", Plain(Positive), "",
        "at least: safety factor against overturning by gross moments, water under the base turning the body; the lesser of both corners", "1.5");
    LeastUplift = key(Criteria, "SF_uplift", Plain(Positive), "",
        "at least: safety factor against uplift, all that acts down over all that acts up", "1.0");
    GreatestTipping = key(Criteria, "tipping", Plain(Positive), "",
        "at most: moments that tip the body over those that hold it, the larger of both corners", "1.0");
    GreatestBearing = key(Criteria, "bearing_max", Measured(Dimension::Pressure, Positive), "",
        "at most: bearing pressure, the larger of both edges", "\"400 kPa\"");
    LeastContact = key(Criteria, "contact_share", Plain(Share), "", "at least: share of the base that is pressed", "0.667");
    GreatestEccentricity = key(Criteria, "eccentricity", length(Positive), "",
        "at most: distance of the resultant from the middle of the base", "\"2.5 m\"");
    LeastLoadFactor = key(Criteria, "load_factor", Plain(Positive), "",
        "at least: multiple of the variable loads at which the body leaves rest", "1.1");
    LeastGround = key(Criteria, "ground_factor", Plain(Positive), "",
        "at least: resistance of the ground over the force on it, R/V", "1.4");
    GreatestEffective = key(Criteria, "effective_pressure_max", Measured(Dimension::Pressure, Positive), "",
        "at most: pressure on the effective width, V/B'", "\"400 kPa\"");
    GreatestRotation = key(Criteria, "rotation_max", Measured(Dimension::Angle, Positive), "",
        "at most: rotation on an elastic base", "\"2 mrad\"");
    GreatestNotRest = key(Criteria, "p_not_rest", Plain(Share), "",
        "at most: upper end of the interval of the probability that the body does not stay at rest, of a case with [random]", "1e-3");
    GreatestLife = key(Criteria, "p_life", Plain(Share), "",
        "at most: upper end of the interval of the probability that the body ever leaves rest over the years of [random]", "0.1");
    GreatestAny = key(Criteria, "p_any", Plain(Share), "",
        "at most: upper end of the interval of the probability that any of the `bodies` in a row leaves rest, over the years of [random] if it has some", "0.1");
    LeastLifeIndex = key(Criteria, "beta_life", Plain(Finite), "",
        "at least: reliability index of that probability, −Φ⁻¹(P), at the upper end of its interval", "1.5");
    GreatestMeanSlide = key(Criteria, "sliding_mean", length(Positive), "",
        "at most: upper end of the interval of the mean slide over the years of [random], of a case with [storm]", "\"0.3 m\"");
    GreatestSlidingOver = key(Criteria, "p_sliding_over", Exceedances, "",
        "at most: upper end of the interval of the probability that the slides over the years of [random] come to more than a length", "{ slide = \"0.3 m\", at_most = 0.1 }");
    GreatestSlide = key(Criteria, "slide", length(Positive), "",
        "at most: displacement along the base at the end of the motion, to either side", "\"100 mm\"");
    GreatestTheta = key(Criteria, "max_theta", Measured(Dimension::Angle, Positive), "",
        "at most: largest angle of the motion, to either side", "\"20 mrad\"");
    NotOverturned = key(Criteria, "overturned", Truth, "", "false: the body does not overturn in its motion", "false");
    GreatestOverturnedShare = key(Criteria, "overturned_share", Plain(ZeroToOne), "",
        "at most: upper end of the interval of the share of copies that overturn, of a case with [motion.copies]", "0.05");
    ModesNot = key(Criteria, "modes_not", ModeList, "", "modes that are not allowed under the full load", "[\"RO\", \"SRO-\"]");

    TMax = key(Motion, "t_max", time(Positive), "t_max", "when to stop at the latest", "\"60 s\"")
        .silent("end of the motion: at rest, overturned, or long after the loads");
    MotionPoints = key(Motion, "points", Places, "", "points of the body whose accelerations are told, each [x, y] from the centre of mass, fixed in the body: where equipment stands", "{ rack = [0, \"0.9 m\"] }");
    ImpactLaw = key(Impact, "law", IMPACTS, "", "law of impacts: no rebound; no slip either; a measured ratio; a rebound by impulses or by energy", "\"inelastic\"");
    ImpactRatio = key(Impact, "ratio", Plain(ZeroToOne), "r", "measured ratio of the rates of rotation after and before an impact, with law = \"ratio\"; or what it follows from, in braces", "0.9");
    ImpactE = key(Impact, "e", Plain(ZeroToOne), "e", "restitution: with law = \"poisson\" of impulses, \"energetic\" of energy; with \"housner\" and \"ratio\" of landings from flight", "0.3");
    ImpactContact = key(RatioOfImpact, "contact", Plain(ZeroToOne), "κ", "where the resultants of impacts act, as a share of half the base", "0.7");
    ImpactPoints = key(RatioOfImpact, "points", Plain(Positive), "n", "even points at which an uneven base touches in turn, two of them the corners", "3");
    InitialTheta = key(Initial, "theta", Measured(Dimension::Angle, Finite), "θ_0", "angle at the beginning, counter-clockwise", "\"50 mrad\"")
        .silent("angle at the beginning: 0");
    InitialOmega = key(Initial, "omega", Plain(Finite), "ω_0", "rate of rotation at the beginning, rad/s", "0.1")
        .silent("rate of rotation at the beginning: 0");
    InitialVx = key(Initial, "vx", Plain(Finite), "v_x", "velocity of the centre of mass to the right, m/s", "0.2");
    InitialVy = key(Initial, "vy", Plain(Finite), "v_y", "velocity of the centre of mass upwards, m/s", "0.1");
    InitialGap = key(Initial, "gap", length(NotNegative), "y_0", "lower corner above the base", "\"10 mm\"")
        .silent("lower corner above the base: 0");
    InitialTime = key(Initial, "time", time(NotNegative), "t_0", "when the motion begins, of the time of the loads", "\"4.5 s\"")
        .silent("when the motion begins: 0");
    InitialX = key(Initial, "x", length(Finite), "x_0", "place of the centre of mass along the base at the beginning", "\"12 mm\"")
        .silent("place of the centre of mass at the beginning: 0");
    InitialTouching = key(Initial, "touching", TOUCHING, "", "corners that touch the base, and stay there, of a motion that goes on", "\"O\"")
        .silent("corners that touch: those that the pose and the velocity tell");
    InitialSlip = key(Initial, "slip", SLIPPING, "", "where the corners that touch slip", "\"none\"")
        .silent("slip at the beginning: that of the velocity");
    InitialSlideO = key(Initial, "slide[1]", OneOf(2, Finite), "s_O", "displacement of O along the base so far", "[0.012, 0.012]")
        .silent("displacement of O so far: 0");
    InitialSlideOPrime = key(Initial, "slide[2]", OneOf(2, Finite), "s_O'", "displacement of O' so far", "[0.012, 0.012]")
        .silent("displacement of O' so far: 0");
    CopiesNumber = key(Copies, "number", Plain(Positive), "N_c", "so many copies, the case itself not counted", "100");
    CopiesSpread = key(Copies, "spread", Spreads, "", "by how much the numbers of a copy scatter, as a share: one for all, or names with a share for each", "{ friction = 0.1, base = 0.05 }")
        .silent("spread of the numbers of copies: 0.001");
    CopiesSeed = key(Copies, "seed", Plain(NotNegative), "s_c", "seed of the copies", "7")
        .silent("seed of the copies: 1");

    StormWaves = key(Storm, "waves", Plain(Positive), "N_w", "waves in a storm", "1000");
    StormDuration = key(Storm, "duration", time(Positive), "t_s", "duration of a storm, in place of its number of waves", "\"7200 s\"");
    StormPeriod = key(Storm, "period", time(Positive), "T_s", "period of its waves, beside its duration", "\"10 s\"");
    StormHeights = key(Storm, "heights", HEIGHTS, "", "law of the heights of waves", "\"rayleigh\"").silent("heights of waves: Rayleigh’s law");
    StormTau0 = key(Storm, "tau0", time(Positive), "τ_0", "how long a wave pushes, or \"shimosako-takahashi\"", "\"1.5 s\"");
    StormPulse = key(Storm, "pulse", PULSES, "", "how the slide of a wave is found", "\"triangle\"").silent("slide of a wave: triangle");
    StormCut = key(Storm, "cut", Truth, "", "whether heights are cut at H_max of the sea", "false").silent("heights of waves: cut at H_max");
    StormFactors = key(Storm, "height_factors", Plains, "", "the sea of each of as many equal parts of a storm, over that of its peak", "[0.7, 1, 0.8]");
    StormRises = key(Storm, "level_rises", List(Dimension::Length), "", "the water level in each part of a storm, over that of the case", "[\"0 m\", \"0.6 m\", \"0.2 m\"]");
    StormCombination = key(Storm, "combination", Text, "", "name of the combination under which its waves come", "\"waves\"");
    StormHeight = key(Storm, "significant_height", length(Positive), "H_13", "significant height of a storm without a body", "\"4.5 m\"");
    ForcePerHeight = key(Storm, "force_per_height", Measured(Dimension::Pressure, NotNegative), "P_H", "its thrust for each metre of a wave’s height", "\"90 kN/m2\"");
    UpliftPerHeight = key(Storm, "uplift_per_height", Measured(Dimension::Pressure, NotNegative), "U_H", "its uplift for each metre of a wave’s height", "\"45 kN/m2\"")
        .silent("uplift for each metre: none");
    StormWeight = key(Storm, "buoyant_weight", Measured(Dimension::Force, Positive), "W_g", "weight less buoyancy that it slides", "\"2300 kN/m\"");
    StormMass = key(Storm, "mass", Measured(Dimension::Mass, Positive), "m_s", "mass that it slides, with the water that moves along", "\"400 t/m\"");
    StormFriction = key(Storm, "friction", Plain(Positive), "μ", "friction that it slides on", "0.6");

    Gamma = key(Point, "gamma", Plain(Positive), "γ", "slenderness H/B", "0.8");
    KPrime = key(Point, "k_prime", Plain(Finite), "k'", "elevation of the force above the centre of mass, in H", "0.9167");
    K = key(Point, "k", Plain(NotNegative), "k", "force, in m g", "0.45");
    Mu = key(Point, "mu", Plain(NotNegative), "μ", "friction", "0.6");

    B1 = key(Block, "b1", Plain(Finite), "b_1", "centre of mass right of the left corner O", "1").gives(&[Quantity::B1]);
    B2 = key(Block, "b2", Plain(Finite), "b_2", "centre of mass left of the right corner O′", "1").gives(&[Quantity::B2]);
    D = key(Block, "d", Plain(Finite), "d", "centre of mass above the base", "3").gives(&[Quantity::D]);
    Rho2 = key(Block, "rho2", Plain(Finite), "ρ²", "moment of inertia about the centre of mass per mass", "3.33").gives(&[Quantity::Rho2]);
    Mx = key(Block, "m_x", Plain(Finite), "m_x", "mass against motion along the base, water with it, per mass", "1.2")
        .silent("mass against motion along the base: that of the body").gives(&[Quantity::InertiaX]);
    My = key(Block, "m_y", Plain(Finite), "m_y", "mass against motion upwards, water with it, per mass", "1.2")
        .silent("mass against motion upwards: that of the body").gives(&[Quantity::InertiaY]);
    MuS = key(Block, "mu_s", Plain(NotNegative), "μ_s", "Coulomb friction to stick", "0.6").gives(&[Quantity::MuS]);
    MuK = key(Block, "mu_k", Plain(NotNegative), "μ_k", "Coulomb friction to slip", "0.5")
        .silent("friction to slip: that to stick").gives(&[Quantity::MuK]);
    MuImpact = key(Block, "mu_impact", Plain(NotNegative), "μ_i", "Coulomb friction at impacts", "0.4")
        .silent("friction at impacts: that to slip");
    BlockGravity = key(Block, "gravity", Plain(Positive), "g", "acceleration of gravity", "1").gives(&[Quantity::Gravity]);
    AtX = key(BlockLoad, "at[1]", OneOf(2, Finite), "x_F", "where the force acts, right of the centre of mass", "[0, 1]")
        .silent("where the force acts: at the centre of mass");
    AtY = key(BlockLoad, "at[2]", OneOf(2, Finite), "y_F", "where it acts, above the centre of mass", "[0, 1]");
    DirectionX = key(BlockLoad, "direction[1]", OneOf(2, Finite), "u_x", "its direction and size to the right", "[-1, 0]");
    DirectionY = key(BlockLoad, "direction[2]", OneOf(2, Finite), "u_y", "its direction and size upwards", "[-1, 0]");
    Follows = key(BlockLoad, "follows", Truth, "", "whether its direction turns with the body", "true")
        .silent("direction of the force: fixed in space");

    HistoryShape = key(History, "shape", COURSES, "", "its course", "\"triangle\"");
    HistoryStart = key(History, "start", time(Finite), "t_0", "when it begins", "\"1 s\"")
        .silent("beginning of the history: 0").gives(&[Quantity::LoadTime]);
    HistoryPeak = key(History, "peak", Reached, "a_p", "what it reaches: an acceleration of the base, or a factor on the load", "1.2")
        .silent("peak of the history: 1");
    HistoryDuration = key(History, "duration", time(Positive), "t_d", "how long it lasts", "\"0.4 s\"");
    HistoryRise = key(History, "rise", time(NotNegative), "t_r", "how long it rises", "\"0.2 s\"");
    AngularFrequency = key(History, "angular_frequency", Plain(Positive), "ω_F", "angular frequency of a sine, rad/s", "6.28");
    HistoryPeriod = key(History, "period", time(Positive), "T_F", "period of a sine, in place of its angular frequency", "\"1 s\"");
    Phase = key(History, "phase", Measured(Dimension::Angle, Finite), "φ_F", "phase of a sine at its beginning", "\"0.5 rad\"")
        .silent("phase of the sine: 0");
    ImpactDuration = key(History, "impact_duration", time(Positive), "t_i", "how long the triangle of a church roof would last", "\"0.2 s\"");
    Tail = key(History, "tail", Reached, "a_t", "what a church roof falls back to, from zero to its peak", "0.4")
        .silent("tail of the church roof: 0");
    Times = key(History, "times", List(Dimension::Time), "", "moments of points, rising; twice the same for a step", "[0, 0.05, 0.1]");
    Values = key(History, "values", Plains, "", "values there, as shares of the peak", "[0, 1, 0]");
    RecordFile = key(History, "file", File, "", "file of the record", "\"record.AT2\"");
    RecordColumn = key(History, "column", Text, "", "column of the record, in a CSV file with several", "\"a_x\"");
    RecordStep = key(History, "dt", time(Positive), "Δt", "time from value to value, where the file has no times", "\"0.01 s\"");
    RecordFactor = key(History, "factor", Plain(Finite), "f_r", "factor on the values of the record", "1.2")
        .silent("factor on the record: 1");
    TargetPeak = key(History, "target_peak", Reached, "a_T", "peak to which the record is scaled", "\"0.4 g\"");
    Baseline = key(History, "baseline", BASELINES, "", "what is taken off the record: its mean, or the line of least squares", "\"linear\"");
}

/// Keys that say of whom and for whom a calculation sheet is, in the order of its title block: a case file may have each as a key,
/// `standfast sheet` as an option, which goes before the file.
pub const TITLE_BLOCK: [Key; 6] =
    [Key::Project, Key::Client, Key::SheetNumber, Key::Revision, Key::Author, Key::Checker];

impl Key {
    /// Its name in its table; `lambda[2]` for the second of a list.
    pub fn name(self) -> &'static str {
        self.info().name
    }

    /// The name that stands in a file: that of the list for one of its numbers.
    pub fn entry(self) -> &'static str {
        let name = self.info().name;
        name.split_once('[').map_or(name, |(list, _)| list)
    }

    /// True of an angle of friction, of which a partial factor divides the tangent.
    pub fn is_friction_angle(self) -> bool {
        matches!(self, Key::GroundAngle | Key::SoilFriction | Key::WallFriction)
    }

    /// True if it asks something of the motion in time.
    pub fn is_of_motion(self) -> bool {
        matches!(
            self,
            Key::GreatestSlide | Key::GreatestTheta | Key::NotOverturned | Key::GreatestOverturnedShare
        )
    }

    /// The key under which a file has `name` in `table`; the first number of a list.
    pub fn find(table: Table, name: &str) -> Option<Key> {
        table.keys().find(|key| key.entry() == name)
    }
}

/// A key in one of the tables of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Id {
    /// The table.
    pub table: Table,
    /// The place of the table among those of its name, from zero; of one in a table that repeats, the place of that.
    pub index: usize,
    /// The key.
    pub key: Key,
}

impl Id {
    /// The key in the `index`-th of the tables that it is listed under.
    pub fn new(key: Key, index: usize) -> Id {
        Id { table: TABLES[key as usize], index, key }
    }

    /// The key in the `index`-th of a kind of tables, as those with histories.
    pub fn of(table: Table, index: usize, key: Key) -> Id {
        Id { table, index, key }
    }

    /// Its meaning in a few words, for people, as axes and lists of quantities have it; of a table that a file may have several times,
    /// with the place of that.
    pub fn words(&self) -> String {
        let words = self.key.info().words;
        let short = words.split_once(", ").map_or(words, |(short, _)| short);
        let [of, _] = self.table.places(self.index);
        let number = self.table.number(self.index);
        match self.table {
            Table::BackfillLayer => format!("{short}, layer {number} of backfill {}", of + 1),
            table if table.repeats() => format!("{short}, {} {number}", table.name()),
            _ => short.to_owned(),
        }
    }
}

impl Ord for Id {
    /// Table by table, as they are read, so that further values stand behind all others.
    fn cmp(&self, other: &Id) -> Ordering {
        (self.table, self.index, self.key).cmp(&(other.table, other.index, other.key))
    }
}

/// The table of each key, at hand where inputs are looked up by the million.
const TABLES: [Table; Key::ALL.len()] = {
    let mut tables = [Table::Top; Key::ALL.len()];
    let mut place = 0;
    while place < tables.len() {
        tables[place] = Key::ALL[place].info().table;
        place += 1;
    }
    tables
};

impl PartialOrd for Id {
    fn partial_cmp(&self, other: &Id) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl From<Key> for Id {
    /// The key in the first, or only, table.
    fn from(key: Key) -> Id {
        Id::new(key, 0)
    }
}

/// The name of a key without the places of its tables: `load.force` of `load[2].force`.
pub fn without_places(name: &str) -> String {
    name.split('[').map(|part| part.split_once(']').map_or(part, |(_, rest)| rest)).collect()
}

impl fmt::Display for Id {
    /// Table and key: `gravity`, `wave.period`, `load[2].force`, `motion.base.horizontal.peak`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.table {
            Top => f.write_str(self.key.name()),
            table => write!(f, "{}.{}", table.path(self.index), self.key.name()),
        }
    }
}

/// The keys of these criteria, which are those of the results that they ask for.
pub const MOTION_CRITERIA: [&str; 4] = ["slide", "max_theta", "overturned", "overturned_share"];

#[cfg(test)]
mod tests {
    use super::*;

    /// Names are unique in their table and found again; an example of a number can be read; the table is in order.
    #[test]
    fn the_table_of_keys_is_sound() {
        let mut before = None;
        for &key in Key::ALL {
            let info = key.info();
            assert!(before <= Some(info.table), "{} stands among another table's keys", info.name);
            before = Some(info.table);
            let twins = info.table.keys().filter(|other| other.name() == info.name);
            assert_eq!(twins.count(), 1, "{}", info.name);
            assert!(!info.words.is_empty() && !info.example.is_empty());
            // What is asked of results is not a number of a calculation.
            let calculated = info.range().is_some() && !matches!(info.table, Table::Criteria | Table::Output);
            assert_eq!(calculated, !info.symbol.is_empty(), "{}", info.name);
            if let Kind::Measured(dimension, range) = info.kind {
                let value = dimension.parse(info.example.trim_matches('"')).unwrap();
                assert!(range.contains(value), "{}", info.name);
            }
        }
        assert_eq!(Key::find(Table::Wave, "lambda"), Some(Key::Lambda1));
        assert_eq!(Key::find(Table::Wave, "lambda[1]"), None);
        assert_eq!(Key::find(Table::Body, "period"), None);
        assert_eq!(Id::new(Key::Force, 1).to_string(), "load[2].force");
        assert_eq!(Id::from(Key::Period).to_string(), "wave.period");
        assert_eq!(Id::from(Key::Gravity).to_string(), "gravity");
    }
}
