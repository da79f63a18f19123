//! The joints of a situation: each with all that is above it as one body, and all together.

use standfast::contact::holding::Holding;
use standfast::contact::stack::plane::StackPlane;
use standfast::contact::stack::{JointMotion, StackMotion, StackStage};
use standfast::{
    Departure, InputError, JointAnswer, JointDeparture, Jointed, Mode, Modes, Situation, Verdict,
};

use super::Assessed;
use crate::case::{BASE, Case};

/// A joint: the base, or one above it.
#[derive(Debug, Clone, PartialEq)]
pub struct JointPlace {
    /// Its name; of the base [`BASE`].
    pub name: Option<String>,
    /// Above the base, m.
    pub elevation: f64,
    /// Its left and its right end, to the right of the origin of the section; of O without parts.
    pub ends: [f64; 2],
}

/// The joints of a situation.
#[derive(Debug, Clone, PartialEq)]
pub struct Joints {
    /// The joints from the base, which is the first.
    pub places: Vec<JointPlace>,
    /// Mid-width of the body, to the right of where ends are counted from.
    middle: f64,
    jointed: Jointed,
    /// What is above each joint above the base, from there up: as one body on that joint.
    pub above: Vec<Assessed>,
    /// Where the first of all joints leaves rest, the base, which is the first, among them.
    pub leaves: JointDeparture,
    /// All joints together.
    pub together: Together,
}

/// What all joints do together.
#[derive(Debug, Clone, PartialEq)]
pub enum Together {
    /// It is known.
    Answered(JointAnswer),
    /// It is not, for a reason: a sentence without its stop.
    Not(&'static str),
}

impl Together {
    /// The answer, where there is one.
    pub fn answer(&self) -> Option<&JointAnswer> {
        match self {
            Together::Answered(answer) => Some(answer),
            Together::Not(_) => None,
        }
    }

    /// Reason why there is none.
    pub fn why_not(&self) -> Option<&'static str> {
        match self {
            Together::Answered(_) => None,
            Together::Not(why) => Some(why),
        }
    }
}

const ON_GROUND: &str = "on [ground] all joints together are not answered: the base is that of the whole, the joints above it are rigid";
const ADHERING: &str = "with adhesion under the base all joints together are not answered";
const OPENING: &str = "the base opens under different heads before a joint leaves rest, and all joints together are then not answered; opening = \"closed\" says that it does not";
const DRAINED: &str = "with drains under the base all joints together are not answered";
const TOO_MANY: &str = "of more than six bodies all joints together are not answered";

impl JointPlace {
    /// The joints of a case from the base.
    fn all(case: &Case) -> Vec<JointPlace> {
        let base = match &case.section {
            Some(section) => section.base(),
            None => [0.0, case.body.base_width()],
        };
        let above = case.joints.iter().map(|joint| JointPlace {
            name: joint.name.clone(),
            elevation: joint.level(),
            ends: joint.ends,
        });
        let base = JointPlace { name: Some(BASE.to_owned()), elevation: 0.0, ends: base };
        [base].into_iter().chain(above).collect()
    }
}

/// Mid-width of a body, to the right of the origin of its section; of O without parts.
fn middle(case: &Case) -> f64 {
    match &case.section {
        Some(section) => section.ends().into_iter().sum::<f64>() / 2.0,
        None => case.body.width() / 2.0,
    }
}

impl Joints {
    /// The joints of a situation that is answered as if all were one body; `None` without any.
    pub(super) fn of(
        case: &Case,
        whole: &Assessed,
        answer: &dyn Fn(Situation) -> Result<Assessed, InputError>,
    ) -> Result<Option<Joints>, InputError> {
        let (acting, trial) = (whole.acting, whole.trial);
        let of = case.under(acting);
        let Some(jointed) = case.on_joints(acting, trial)? else { return Ok(None) };
        let above = (0..of.joints.len()).map(|place| {
            let situation = case.above_joint(place, acting, trial)?;
            let is_near = whole.situation.is_as_written() || situation.is_near_boundary();
            answer(match is_near {
                true => case.above_as_written(situation, place, acting, trial),
                false => situation,
            })
        });
        let above = above.collect::<Result<_, _>>()?;
        let written = || case.on_joints_as_written(acting, trial);
        let base = &whole.outcome.departure;
        let opens = |factor: f64| whole.situation.opens_up_to(factor);
        let more_than_friction = of_base(of);
        let is_special = more_than_friction.is_some() || opens(at_least_full(base.load_factor()));
        let leaves = jointed.departure(is_special.then_some(base), &written);
        let why = match () {
            () if more_than_friction.is_some() => more_than_friction,
            () if opens(at_least_full(leaves.load_factor)) => Some(OPENING),
            () if !jointed.is_enumerable() => Some(TOO_MANY),
            () => None,
        };
        let together = match why {
            Some(why) => Together::Not(why),
            None => Together::Answered(jointed.answer(&written)),
        };
        let (places, middle) = (JointPlace::all(of), middle(of));
        Ok(Some(Joints { places, middle, jointed, above, leaves, together }))
    }

    /// The motion under the full load, joints as their ends are counted; `None` where it is not known.
    pub fn motion(&self) -> Option<StackMotion> {
        let motion = self.together.answer()?.full.motion()?;
        let from_origin = |joint: &JointMotion| {
            // Where nothing presses, no reaction has a place.
            let xi = if joint.n == 0.0 { 0.0 } else { joint.xi + self.middle };
            JointMotion { v: joint.v - joint.omega * self.middle, xi, ..*joint }
        };
        Some(StackMotion { joints: motion.joints.iter().map(from_origin).collect(), ..motion.clone() })
    }

    /// Mid-width of the body, to the right of where ends are counted from.
    pub fn middle(&self) -> f64 {
        self.middle
    }

    /// The departure from rest of all.
    pub fn departure(&self) -> Departure {
        let JointDeparture { load_factor, at_once, .. } = self.leaves;
        match load_factor {
            _ if at_once => Departure::AtOnce { verdict: None, permanent: true },
            0.0 => Departure::AtOnce { verdict: None, permanent: false },
            f64::INFINITY => Departure::Never,
            factor => Departure::At { factor, verdict: None },
        }
    }

    /// The combination reported under the full load, a mode for each joint from the base; `None` where that is not known.
    pub fn modes(&self) -> Option<&[Mode]> {
        self.together.answer().map(|answer| answer.full.modes())
    }

    /// The other combinations that are as consistent.
    pub fn also(&self) -> impl Iterator<Item = &[Mode]> {
        self.together.answer().into_iter().flat_map(|answer| answer.full.others())
    }

    /// The stages of the variable loads that rise up to a factor, where all joints are answered together, up to where the base opens; `whole` is
    /// the situation of `case` whose joints they are.
    pub fn path(&self, case: &Case, whole: &Assessed, up_to: f64) -> Vec<StackStage> {
        if self.together.answer().is_none() {
            return Vec::new();
        }
        let opens = whole.situation.base_opening().and_then(|opening| opening.opens_at);
        let written = || case.on_joints_as_written(whole.acting, whole.trial);
        self.jointed.path(opens.map_or(up_to, |opens| opens.min(up_to)), &written)
    }

    /// Where which joint leaves rest first, over the load factor and the friction of the base; `None` where more than friction holds that.
    pub fn departures(&self, window: [f64; 2]) -> Option<StackPlane> {
        let of_base = self.leaves.limits.iter().any(|(_, limit)| limit.is_none());
        let is_plain = self.together.why_not().is_none_or(|why| why == TOO_MANY) && !of_base;
        is_plain.then(|| self.jointed.departures(window)).flatten()
    }

    /// What all joints do at once over the load factor and the friction of the base; `None` where that is not answered, and of more than two bodies.
    pub fn all_at_once(&self, window: [f64; 2]) -> Option<StackPlane> {
        self.together.answer()?;
        self.jointed.all_at_once(window)
    }

    /// True if only one combination is consistent under the full load; `None` where that is not known.
    pub fn is_unique(&self) -> Option<bool> {
        self.together.answer().map(|answer| answer.full.is_unique())
    }

    /// The modes in which the joints leave rest, a mode for each; none where that is not known.
    pub fn departing(&self) -> &[Mode] {
        self.together.answer().map_or(&[], |answer| answer.departing.modes())
    }

    /// All modes that some joint may take up under the full load; `None` where that is not known.
    pub(crate) fn possible(&self, whole: &Assessed) -> Option<Modes> {
        match &self.together {
            Together::Answered(answer) => {
                let all = answer.full.combinations().iter();
                Some(all.flat_map(|one| one.modes.iter().copied()).collect())
            }
            Together::Not(_) => self.rests(whole).then(|| [Mode::Rest].into_iter().collect()),
        }
    }

    /// True if no joint moves under the full load: each rests under all that is above it.
    pub(super) fn rests(&self, whole: &Assessed) -> bool {
        match self.modes() {
            Some(modes) => !modes.is_empty() && modes.iter().all(|mode| *mode == Mode::Rest),
            None => {
                let rests = |one: &Assessed| one.outcome.full.verdict == Some(Verdict::REST);
                rests(whole) && self.above.iter().all(rests)
            }
        }
    }
}

/// What has more to do with the base of a case than friction, as a reason why what all joints do together is not answered.
fn of_base(of: &Case) -> Option<&'static str> {
    match () {
        () if of.ground.is_some() => Some(ON_GROUND),
        () if of.holding() != Holding::new(None) => Some(ADHERING),
        () if of.drain.is_some() => Some(DRAINED),
        () => None,
    }
}

/// A load factor where something ends, or that of the full load, if that is more; of what never ends the full load.
fn at_least_full(factor: f64) -> f64 {
    if factor == f64::INFINITY { 1.0 } else { factor.max(1.0) }
}

impl Assessed {
    /// True if the answer under the full load is unique; `None` where all joints together are not answered.
    pub fn is_unique(&self) -> Option<bool> {
        match &self.joints {
            Some(joints) => joints.is_unique(),
            None => Some(self.outcome.full.is_unique()),
        }
    }

    /// True if nothing presses the body on its base, or on one of its joints, under the full load.
    pub fn is_lifted(&self) -> bool {
        self.on_joints().any(|on| on.outcome.full.is_lifted())
    }

    /// SF_sliding, the least of its joints.
    pub fn least_sliding(&self) -> f64 {
        self.on_joints().map(|on| on.outcome.stability.sliding).fold(f64::INFINITY, f64::min)
    }

    /// SF_overturning_net about either corner, the least of its joints.
    pub fn least_overturning(&self) -> f64 {
        self.on_joints().map(|on| on.outcome.stability.overturning()).fold(f64::INFINITY, f64::min)
    }

    /// What is on each joint from the base, which is the first: the whole, and where there are joints above, all that is above each.
    pub fn on_joints(&self) -> impl Iterator<Item = &Assessed> {
        std::iter::once(self).chain(self.joints.iter().flat_map(|joints| &joints.above))
    }
}
