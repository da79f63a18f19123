//! From typed inputs to the motion in time: how the base moves, how corners meet it, how the motion begins, what is asked of it.

use standfast::History;
use standfast::Slip;
use standfast_motion::{BaseMotion, Going, Impact, Initial, MotionError};

use super::Reader;
use super::history::{HistoryOf, ReadHistory};
use crate::criteria::MotionCriterion;
use crate::error::{Fault, Place, Problem};
use crate::key::{Id, Key, Table};
use crate::motion::{BodyPoint, CopiesAsked, MotionWarning, Spread};

/// Motion of a case in time, as its file gives it.
#[derive(Debug, Clone, PartialEq)]
pub struct CaseMotion {
    /// Motion of the base, m/s².
    pub base: BaseMotion,
    /// Acceleration of the base away from the viewer of the section, m/s².
    pub away: Option<History>,
    /// Impact of a corner on the base.
    pub impact: Impact,
    /// Restitution.
    pub restitution: f64,
    /// State in which the motion begins.
    pub initial: Initial,
    /// Time at which to stop at the latest, s.
    pub t_max: Option<f64>,
    /// Criteria on the motion.
    pub criteria: Vec<MotionCriterion>,
    /// Points whose accelerations are told.
    pub points: Vec<BodyPoint>,
    /// Copies that are asked for.
    pub copies: Option<CopiesAsked>,
    /// Warnings of possible slips in its histories.
    pub(crate) warnings: Vec<MotionWarning>,
    /// The longest step between the points of a record, s.
    pub(crate) step: Option<f64>,
}

impl CaseMotion {
    /// Puts the warnings of a history beside the others, and passes on the history.
    pub(crate) fn take(&mut self, read: ReadHistory) -> History {
        self.warnings.extend(read.warnings);
        self.step = [self.step, read.step].into_iter().flatten().reduce(f64::max);
        read.history
    }
}

impl Reader<'_> {
    /// The motion in time; `of` is what the accelerations of the base are of.
    pub(crate) fn motion(&self, of: HistoryOf<'_>) -> Result<CaseMotion, Fault> {
        let mut motion = CaseMotion {
            base: BaseMotion::default(),
            away: None,
            impact: self.impact()?,
            restitution: self.number(Key::ImpactE).unwrap_or(0.0),
            initial: self.initial(),
            t_max: self.number(Key::TMax),
            criteria: MotionCriterion::all(self.inputs)?,
            points: self.points(),
            copies: self.copies()?,
            warnings: Vec::new(),
            step: None,
        };
        let horizontal = self.history(Table::BaseHorizontal, 0, of)?;
        motion.base.horizontal = horizontal.map(|read| motion.take(read));
        let vertical = self.history(Table::BaseVertical, 0, of)?;
        motion.base.vertical = vertical.map(|read| motion.take(read));
        let away = self.history(Table::BaseHorizontalZ, 0, of)?;
        motion.away = away.map(|read| motion.take(read));
        if (motion.base != BaseMotion::default() || motion.away.is_some())
            && self.inputs.has(Table::Earthquake)
        {
            return Err(Fault::new(Problem::ShakenTwice, Table::Base).and(Table::Earthquake));
        }
        Ok(motion)
    }

    fn impact(&self) -> Result<Impact, Fault> {
        if !self.inputs.has(Table::Impact) {
            return Ok(Impact::default());
        }
        let law = self.inputs.choice(Key::ImpactLaw);
        let law = law.ok_or_else(|| self.missing(Key::ImpactLaw, 0))?;
        let e = self.number(Key::ImpactE);
        match (law, e) {
            ("inelastic", Some(_)) => return Err(Fault::new(Problem::RestitutionOfNone, Key::ImpactE)),
            ("poisson" | "energetic", None) => return Err(self.missing(Key::ImpactE, 0)),
            _ => {}
        }
        if law != "ratio" {
            let ratio = [Key::ImpactRatio, Key::ImpactContact, Key::ImpactPoints];
            if let Some(key) = ratio.into_iter().find(|key| self.number(*key).is_some()) {
                return Err(Fault::new(Problem::RatioOfOtherLaw, key));
            }
        }
        Ok(match law {
            "ratio" => self.ratio()?,
            "housner" => Impact::Housner,
            "poisson" => Impact::Poisson,
            "energetic" => Impact::Energetic,
            _ => Impact::Inelastic,
        })
    }

    /// A ratio, or what it follows from.
    fn ratio(&self) -> Result<Impact, Fault> {
        /// More points are a curve.
        const MOST: f64 = 1000.0;
        if let Some(ratio) = self.number(Key::ImpactRatio) {
            return Ok(Impact::Ratio(ratio));
        }
        let wrong = |key: Key, value: f64, expected: &'static str| {
            let problem = Problem::Motion(MotionError::Value { name: key.name(), value, expected });
            Err(Fault::new(problem, key))
        };
        match [Key::ImpactContact, Key::ImpactPoints].map(|key| self.number(key)) {
            [None, None] if self.inputs.has(Table::ImpactRatio) => Err(self.missing(Key::ImpactPoints, 0)),
            [None, None] => Err(self.missing(Key::ImpactRatio, 0)),
            [Some(share), None] => Ok(Impact::Contact(share)),
            [None, Some(count)] if !(2.0..=MOST).contains(&count) || count.fract() != 0.0 => {
                wrong(Key::ImpactPoints, count, "a whole number from 2 to 1000")
            }
            [None, Some(count)] => Ok(Impact::Points(count as u32)),
            [Some(share), Some(_)] => wrong(Key::ImpactContact, share, "one of `contact` and `points`"),
        }
    }

    fn initial(&self) -> Initial {
        let or_zero = |key| self.number(key).unwrap_or(0.0);
        let touching = self.inputs.choice(Key::InitialTouching).map(|word| match word {
            "both" => [true, true],
            "none" => [false, false],
            one => [one == "O", one != "O"],
        });
        let going = self.inputs.choice(Key::InitialSlip).map(|word| match word {
            "left" => Going::Slips(Slip::Left),
            "right" => Going::Slips(Slip::Right),
            _ => Going::Sticks,
        });
        let slide = [Key::InitialSlideO, Key::InitialSlideOPrime].map(|key| self.number(key));
        Initial {
            time: or_zero(Key::InitialTime),
            x: or_zero(Key::InitialX),
            touching,
            going,
            slide: slide[0].zip(slide[1]).map(<[f64; 2]>::from),
            theta: or_zero(Key::InitialTheta),
            omega: or_zero(Key::InitialOmega),
            vx: self.number(Key::InitialVx),
            vy: self.number(Key::InitialVy),
            gap: or_zero(Key::InitialGap),
        }
    }

    fn points(&self) -> Vec<BodyPoint> {
        let places = self.inputs.places(Key::MotionPoints).unwrap_or_default();
        places.iter().map(|(name, at)| BodyPoint { name: name.clone(), at: *at }).collect()
    }

    fn copies(&self) -> Result<Option<CopiesAsked>, Fault> {
        /// Greater whole numbers are not all numbers of a case file.
        const LARGEST: f64 = 9_007_199_254_740_992.0;
        if !self.inputs.has(Table::Copies) {
            return Ok(None);
        }
        let whole = |key: Key, most: f64, expected: &'static str| {
            let number = self.number(key);
            match number.filter(|number| number.fract() != 0.0 || *number > most) {
                Some(value) => {
                    let error = MotionError::Value { name: key.name(), value, expected };
                    Err(Fault::new(Problem::Motion(error), key))
                }
                None => Ok(number),
            }
        };
        let number = whole(Key::CopiesNumber, CopiesAsked::MOST as f64, "a whole number from 1 to 1000000")?;
        let number = number.ok_or_else(|| self.missing(Key::CopiesNumber, 0))?;
        let seed = whole(Key::CopiesSeed, LARGEST, "a whole number, zero or more, of up to 15 digits")?;
        let spread = match (self.number(Key::CopiesSpread), self.inputs.ratios(Key::CopiesSpread)) {
            (Some(spread), _) => Spread::Even(spread),
            (None, Some(named)) => Spread::Named(named.to_vec()),
            (None, None) => CopiesAsked::SPREAD,
        };
        let seed = seed.map_or(CopiesAsked::SEED, |seed| seed as u64);
        Ok(Some(CopiesAsked { number: number as usize, spread, seed }))
    }

    /// Refusal by the motion, shown at the key it is about.
    pub(crate) fn motion_refused(&self, error: MotionError) -> Fault {
        let named = |name: &str| {
            let tables = [Table::Motion, Table::Impact, Table::ImpactRatio, Table::Initial, Table::Block];
            let keys = tables.into_iter().flat_map(Table::keys).filter(|key| key.name() == name);
            keys.map(Id::from).find(|id| self.inputs.get(*id).is_some())
        };
        let at = match &error {
            MotionError::Input(error) => return self.blame(Table::Block, *error),
            MotionError::Value { name, .. } => named(name).map(Place::from),
            MotionError::Ratio { .. } => named("ratio").or_else(|| named("points")).map(Place::from),
            MotionError::Acceleration { name, .. } => {
                let tables = [Table::BaseHorizontal, Table::BaseVertical].into_iter();
                tables.filter(|table| table.name() == *name).map(Place::from).next()
            }
            MotionError::WaterWithoutHeight { .. } => Some(Key::WaterMass.into()),
            MotionError::Apart { .. } => Some(Key::InitialTouching.into()),
            MotionError::NoSpread { .. } => Some(Key::CopiesSpread.into()),
            MotionError::NoCopies => Some(Key::GreatestOverturnedShare.into()),
            MotionError::SlipOfNone => Some(Key::InitialSlip.into()),
            _ => None,
        };
        let whole = [Table::Motion, Table::Block].into_iter().find(|table| self.inputs.has(*table));
        Fault::new(Problem::Motion(error), at.unwrap_or_else(|| whole.unwrap_or(Table::Top).into()))
    }
}
