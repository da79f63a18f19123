//! The force, still water and uplift together, and what happens while they rise.
//!
//! The force and its uplift rise together, beside the weight and still water. On the way k' changes, so no one k–μ diagram
//! holds the path: it is drawn in the plane of load factor and friction, from [`Situation::plane`]. The full load alone is a
//! point of the k–μ diagram in effective coordinates.

use serde::Serialize;
use standfast::loads::{Pose, Reduced, StillWater, Uplift};
use standfast::{Departure, InputError, Situation, Slip};
use standfast_figures::{LoadPlane, load_plane_on_screen};

use crate::field::sentence;
use crate::state::{GRAVITY, State};
use crate::text::{mathematics, symbol};
use crate::unit::shown;

/// Load factor up to which the load rises in the drawing, and in the list of changes.
pub const UP_TO: f64 = 2.0;
/// Of sea water, kg/m³.
const WATER: f64 = 1030.0;

/// Still water on both sides, and the wave's pressure under the base.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Waters {
    /// Level on the side that the force comes from, m above the base.
    pub sea: f64,
    /// Level on the other side.
    pub lee: f64,
    /// Pressure under the edge on the side that the force comes from, Pa, falling to none at the other; grows with the
    /// force.
    pub uplift: f64,
}

impl Waters {
    /// True if the force acts in air, without uplift.
    pub fn are_none(&self) -> bool {
        *self == Waters::default()
    }

    /// Checks that the state's body can stand in them, whatever the state's own are.
    ///
    /// # Errors
    /// A sentence on the fault.
    pub fn check(&self, state: &State) -> Result<(), String> {
        if self.uplift < 0.0 {
            return Err("The uplift pressure is negative; expected zero or more.".to_owned());
        }
        situation(&State { waters: *self, ..state.clone() })
            .map(|_| ())
            .map_err(|error| sentence(&error.to_string()))
    }
}

/// The body of a state under all its loads.
///
/// # Errors
/// If a dimension is out of range, or water stands above the crest.
pub fn situation(state: &State) -> Result<Situation, InputError> {
    let (body, force) = state.reduced().with_size(state.width, state.mass, GRAVITY)?;
    let Waters { sea, lee, uplift } = state.waters;
    // The force comes from the right unless it points there.
    let order = |sea: f64, lee: f64| if state.mirrored { (sea, lee) } else { (lee, sea) };
    let (left, right) = order(sea, lee);
    let water = StillWater::new(&body, left, right, WATER)?;
    let (uplift_left, uplift_right) = order(uplift, 0.0);
    let situation = Situation::new(body, state.friction, GRAVITY)?.with_weight();
    let situation =
        if (sea, lee) == (0.0, 0.0) { situation } else { situation.with_all(water.loads(&body, GRAVITY)) };
    let situation = situation.with(force.load());
    Ok(match uplift {
        0.0 => situation,
        _ => situation.with(Uplift::new(uplift_left, uplift_right, true)?.load(&body)),
    })
}

/// The point of all loads in effective coordinates, if they have one.
pub fn effective(state: &State) -> Option<Reduced> {
    situation(state).and_then(|situation| situation.at(1.0)).ok()?.effective
}

/// The force k that brings the effective point to `k_eff`, as far as one of the state's direction can, and what a step of
/// k_eff is in k.
pub fn force_for(state: &State, k_eff: f64, step: f64) -> Option<(f64, f64)> {
    let sign = |right: bool| if right { Slip::Right } else { Slip::Left }.sign();
    let all = effective(state)?;
    // Uplift does not depend on the force, so P stays.
    let others = situation(&State { force: 0.0, ..state.clone() }).ok()?.wrench_at(1.0, Pose::UPRIGHT);
    let weight = state.mass * GRAVITY;
    let push = sign(all.mirrored) * k_eff * others.p - others.x;
    Some(((sign(state.mirrored) * push / weight).max(0.0), step * others.p / weight))
}

/// Load factor at which a body leaves rest as its variable loads rise: a sentence, in HTML.
pub fn departure_words(departure: &Departure) -> String {
    let into = departure.mode().map_or(String::new(), |mode| format!(", into {}", symbol(mode)));
    match *departure {
        Departure::AtOnce { permanent: true, .. } => {
            format!("The permanent loads alone move the body{into}; the force is not needed.")
        }
        Departure::AtOnce { permanent: false, .. } => {
            format!("Any share of the load moves the body, however small{into}.")
        }
        Departure::At { factor, .. } => format!(
            "As the load rises, the body leaves rest at {} of it{into}.",
            mathematics(&format!("λ = {}", shown(factor))),
        ),
        Departure::Never => "The body stays at rest whatever the load factor.".to_owned(),
    }
}

/// Figure and sentences on the load path.
#[derive(Debug, Serialize)]
pub struct LoadPath {
    /// The plane of load factor and friction; empty if there is none.
    pub svg: String,
    /// Sentences, in HTML.
    pub words: Vec<String>,
}

impl LoadPath {
    /// The load path of a state, with a plot `across` units wide.
    pub fn of(state: &State, across: f64) -> LoadPath {
        LoadPath::find(state, across).unwrap_or_else(|error| LoadPath {
            svg: String::new(),
            words: vec![sentence(&error.to_string())],
        })
    }

    fn find(state: &State, across: f64) -> Result<LoadPath, InputError> {
        let situation = situation(state)?;
        let (outcome, regions) = (situation.outcome()?, situation.plane(UP_TO)?);
        let plane = LoadPlane {
            regions: &regions,
            base: None,
            up_to: UP_TO,
            friction: state.friction,
            stages: &outcome.path,
            title: "Load factor λ and friction μ",
        };
        let full = &outcome.full;
        let mut words = vec![departure_words(&outcome.departure)];
        words.extend(full.mode().map(|mode| {
            let others: Vec<_> = full.others().iter().map(symbol).collect();
            let also =
                if others.is_empty() { String::new() } else { format!(" (also {})", others.join(", ")) };
            let predicate = mode.words().replace('\'', "′");
            format!("Under the full load, applied at once, it {predicate}: {}{also}.", symbol(mode))
        }));
        Ok(LoadPath { svg: load_plane_on_screen(&plane, across).svg().to_owned(), words })
    }
}

#[cfg(test)]
mod tests {
    use standfast::{Mode, Verdict};

    use super::*;

    fn departs(state: &State) -> Departure {
        situation(state).unwrap().outcome().unwrap().departure
    }

    #[test]
    fn without_water_the_path_is_the_force_and_the_effective_point_the_point() {
        let state = State { force: 0.7, ..State::default() };
        let full = situation(&state).unwrap().at(1.0).unwrap();
        assert_eq!(full.mode(), Some(state.point().mode()));
        let crossing = state.point().margins().leaves_rest().unwrap();
        let Departure::At { factor, verdict } = departs(&state) else { panic!("it leaves rest") };
        assert!((factor / (crossing.at / state.force) - 1.0).abs() < 1e-12);
        assert_eq!(verdict, Some(Verdict::Begins(crossing.to)));
        let reduced = effective(&state).unwrap();
        assert!((reduced.point.k_prime() - state.elevation).abs() < 1e-12);
    }

    #[test]
    fn without_friction_any_force_moves_the_body_and_without_force_nothing_does() {
        let smooth = State { friction: 0.0, force: 1e-9, ..State::default() };
        assert_eq!(
            departs(&smooth),
            Departure::AtOnce { verdict: Some(Verdict::Begins(Mode::SlideLeft)), permanent: false }
        );
        let mirrored = State { mirrored: true, ..smooth.clone() };
        assert_eq!(
            departs(&mirrored),
            Departure::AtOnce { verdict: Some(Verdict::Begins(Mode::SlideRight)), permanent: false }
        );
        for friction in [0.0, 0.6] {
            assert_eq!(departs(&State { force: 0.0, friction, ..State::default() }), Departure::Never);
        }
    }

    #[test]
    fn a_departure_is_found_however_far_away() {
        // Low down, the body slides: λ = μ/k.
        for force in [1e-3, 1e-12, 1e-40] {
            let state = State { force, elevation: -0.5, ..State::default() };
            let Departure::At { factor, verdict } = departs(&state) else {
                panic!("k = {force}: it leaves rest")
            };
            assert!((factor * force / state.friction - 1.0).abs() < 1e-12, "k = {force}");
            assert_eq!(verdict, Some(Verdict::Begins(Mode::SlideLeft)));
        }
    }

    #[test]
    fn water_on_one_side_moves_a_smooth_body_without_the_force() {
        let mut state = State { friction: 0.0, ..State::default() };
        state.waters.lee = 3.0;
        // It presses from the left.
        assert_eq!(
            departs(&state),
            Departure::AtOnce { verdict: Some(Verdict::Begins(Mode::SlideRight)), permanent: true }
        );
    }

    #[test]
    fn uplift_alone_turns_the_body_in_the_end() {
        // p B_c²/3 about O against W B: λ = 3 W/(2 p B_c) = 3.
        let mut state = State { force: 0.0, ..State::default() };
        state.waters.uplift = state.mass * GRAVITY / (2.0 * state.width);
        let Departure::At { factor, .. } = departs(&state) else { panic!("it leaves rest") };
        assert!((factor / 3.0 - 1.0).abs() < 1e-12, "{factor}");
    }

    #[test]
    fn buoyancy_of_equal_levels_lowers_the_weight_and_no_more() {
        // 5 m of sea water under 15 m of base: 1030 · 5 · 15 kg/m of 378 t/m.
        let mut state = State::default();
        (state.waters.sea, state.waters.lee) = (5.0, 5.0);
        for mirrored in [false, true] {
            let state = State { mirrored, ..state.clone() };
            let reduced = effective(&state).unwrap();
            let expected = state.force / (1.0 - 1030.0 * 5.0 * 15.0 / 378e3);
            assert!((reduced.point.k() / expected - 1.0).abs() < 1e-12);
            assert!((reduced.point.k_prime() - 0.9).abs() < 1e-12);
            assert_eq!(reduced.mirrored, mirrored);
        }
    }

    #[test]
    fn uplift_acts_under_the_seaward_edge_whichever_side_that_is() {
        let modes = [false, true].map(|mirrored| {
            let mut state = State { mirrored, force: 0.4, ..State::default() };
            state.waters.uplift = 60e3;
            let full = situation(&state).unwrap().at(1.0).unwrap();
            let reduced = full.effective.unwrap();
            (reduced.point, full.mode().map(|mode| if mirrored { mode.mirrored() } else { mode }))
        });
        let ((one, one_mode), (two, two_mode)) = (modes[0], modes[1]);
        assert_eq!(one_mode, two_mode);
        assert!((one.k_prime() - two.k_prime()).abs() < 1e-12 && one.k_prime() > 0.9);
    }

    #[test]
    fn the_effective_point_goes_where_the_hand_puts_it() {
        for mirrored in [false, true] {
            let mut state = State { mirrored, ..State::default() };
            state.waters = Waters { sea: 8.0, lee: 3.0, uplift: 60e3 };
            state.place((1.1, 0.7), (1e-9, 1e-9));
            let reduced = effective(&state).unwrap();
            assert!((reduced.point.k() - 1.1).abs() < 1e-8, "{}", reduced.point.k());
            assert_eq!(state.friction, 0.7);
            // Water from the other side pushes harder than this: the force goes no further than to nothing.
            state.waters = Waters { sea: 0.0, lee: 8.0, uplift: 0.0 };
            state.force = 0.01;
            state.place((5.0, 0.7), (1e-9, 1e-9));
            assert_eq!(state.force, 0.0);
        }
    }
}
