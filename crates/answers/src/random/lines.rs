//! Along which random number the modes are known: in closed form, or scanned.

use standfast_probability::integrate::MOST_DIMENSIONS;
use standfast_probability::problem::RandomVector;

use super::quantity::RandomInput;
use crate::case::Case;

/// Along which number the modes are known, and how.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Line {
    /// Friction: its place.
    Friction(usize),
    /// A number in which the wrench is linear.
    Load(usize),
    /// Any other, scanned.
    Scan(usize),
}

/// Along which numbers the modes are known in closed form.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lines {
    /// Friction; not where that to slip has a law of its own, as the conditions take both in one proportion.
    pub(super) friction: bool,
    /// Numbers in which the wrench is linear; not on a base that gives way.
    pub(super) loads: bool,
    /// Directions: the body is seen from above.
    directions: bool,
}

impl Lines {
    pub(super) fn of(inputs: &[RandomInput], case: Option<&Case>) -> Lines {
        // Where water follows an opening, no wrench is linear in a load.
        let held = case.is_some_and(|case| !case.holding().is_empty());
        let gives_way = case.is_some_and(Case::gives_way);
        let bends = held || gives_way || case.is_some_and(Case::follows_opening);
        let joints = case.is_some_and(|case| !case.joints.is_empty());
        // Of joints that change places each friction would have to be found again; on a base that gives way all joints are asked each time.
        let is_apart = !joints || !bends && !inputs.iter().any(RandomInput::is_joint_elevation);
        let kinetic = inputs.iter().any(RandomInput::is_kinetic_friction);
        let directions = case.is_some_and(|case| case.plan.is_some());
        Lines { friction: !held && !kinetic && is_apart, loads: !bends, directions }
    }

    /// The first along which the modes are known, of those for which this holds. One whose law has many steps is the last to be taken where
    /// others are integrated: over each step a probability jumps.
    pub(super) fn first(
        self,
        inputs: &[RandomInput],
        laws: &RandomVector,
        among: impl Fn(usize) -> bool,
    ) -> Option<Line> {
        /// So many steps are found one by one along another number.
        const FEW: usize = 8;
        let is_smooth = |place: usize| laws.laws()[place].breaks_of_normal().len() <= FEW;
        // What goes with the time is never one: each year has its own. Nor is what another's law depends on.
        let may_be =
            |place: usize| among(place) && inputs[place].rise_of().is_none() && !laws.is_parent(place);
        let find = |of: &dyn Fn(&RandomInput) -> bool, smooth: bool| {
            let suits =
                |place: &usize| may_be(*place) && of(&inputs[*place]) && (!smooth || is_smooth(*place));
            (0..inputs.len()).find(suits)
        };
        // Over directions a body rests, or not, on arcs that are too narrow to be seen from outside.
        let direction = find(&RandomInput::is_direction, false).filter(|_| self.directions).map(Line::Scan);
        let is_friction = |input: &RandomInput| input.friction_of().is_some();
        let friction = |smooth| find(&is_friction, smooth).filter(|_| self.friction).map(Line::Friction);
        // On a base that gives way, or opens, a load is scanned, which is quicker than another number.
        let of_load = if self.loads { Line::Load } else { Line::Scan };
        let load = |smooth| find(&RandomInput::is_linear, smooth).map(of_load);
        let scan = |smooth| find(&|_| true, smooth).map(Line::Scan);
        let is_integrated = inputs.len() <= MOST_DIMENSIONS + 1;
        let smooth = friction(true).or_else(|| load(true)).or_else(|| scan(true).filter(|_| is_integrated));
        direction.or(smooth).or_else(|| friction(false)).or_else(|| load(false)).or_else(|| scan(false))
    }
}
