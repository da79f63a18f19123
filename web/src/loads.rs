//! The load path: the force and its uplift rise together, beside the weight and still water.
//!
//! With water or uplift k' changes on the way, so no one k–μ diagram holds the path: it is drawn in the plane of load factor
//! and friction, from [`Situation::plane`]. The full load alone is a point of the k–μ diagram in effective coordinates.

use serde::Serialize;
use standfast::LoadKind::{Horizontal, Uplift, Weight};
use standfast::{InputError, Situation, Slip, State as Full, first_departure};
use standfast_figures::{LoadPlane, load_plane_on_screen};

use crate::field::sentence;
use crate::state::{GRAVITY, State};
use crate::text::{mathematics, symbol};
use crate::unit::shown;

/// How far the load rises in the drawing.
const UP_TO: f64 = 2.0;
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
    /// Whether the state's body can stand in them.
    ///
    /// # Errors
    /// What is wrong, as a sentence.
    pub fn check(&self, state: &State) -> Result<(), String> {
        if self.uplift < 0.0 {
            return Err("The uplift pressure is negative; expected zero or more.".to_owned());
        }
        situation(state).map(|_| ()).map_err(|error| sentence(&error.to_string()))
    }
}

fn situation(state: &State) -> Result<Situation, InputError> {
    let (body, force) = state.reduced().with_size(state.width, state.mass, GRAVITY)?;
    let Waters { sea, lee, uplift } = state.waters;
    // The force comes from the right unless it points there.
    let order = |sea: f64, lee: f64| if state.mirrored { (sea, lee) } else { (lee, sea) };
    let (left, right) = order(sea, lee);
    let water = body.still_water(left, right, WATER * GRAVITY)?;
    let (uplift_left, uplift_right) = order(uplift, 0.0);
    let push = force.magnitude() * if force.direction() == Slip::Right { 1.0 } else { -1.0 };
    Ok(Situation::new(body, state.friction, GRAVITY)
        .permanent(Weight, body.weight(GRAVITY))
        .permanent(Weight, water.base)
        .permanent(Horizontal, water.sides)
        .variable(Horizontal, body.horizontal_force(push, force.elevation()))
        .variable(Uplift, body.base_pressure(uplift_left, uplift_right)))
}

/// The effective point, if it can be shown in the diagram.
pub fn take_effective(state: &mut State) -> bool {
    let full = situation(state).and_then(|situation| situation.at(1.0));
    let Some(reduced) = full.ok().and_then(|full| full.effective) else { return false };
    let point = reduced.point;
    state.set_body(point.gamma(), point.k_prime());
    state.force = point.k();
    state.mirrored = reduced.mirrored;
    state.view = None;
    // They are in the coordinates now.
    state.waters = Waters::default();
    true
}

/// What the page says of the load path.
#[derive(Debug, Serialize)]
pub struct LoadPath {
    /// The plane of load factor and friction; empty if there is none.
    pub svg: String,
    /// Sentences, in HTML.
    pub words: Vec<String>,
    /// Whether the full load is another point of the diagram than the one shown.
    pub effective: bool,
}

impl LoadPath {
    /// The load path of a state.
    pub fn of(state: &State, across: f64) -> LoadPath {
        LoadPath::find(state, across).unwrap_or_else(|error| LoadPath {
            svg: String::new(),
            words: vec![sentence(&error.to_string())],
            effective: false,
        })
    }

    fn find(state: &State, across: f64) -> Result<LoadPath, InputError> {
        let situation = situation(state)?;
        let (full, stages) = (situation.at(1.0)?, situation.path(UP_TO)?);
        let regions = situation.plane(UP_TO)?;
        let plane = LoadPlane {
            regions: &regions,
            up_to: UP_TO,
            friction: state.friction,
            stages: &stages,
            title: "Load factor λ and friction μ",
        };
        let departure = match first_departure(&stages) {
            Some(stage) if stage.from == 0.0 => "The permanent loads alone move the body.".to_owned(),
            Some(stage) => format!(
                "The body first leaves rest at {} of the load{}.",
                mathematics(&format!("λ = {}", shown(stage.from))),
                stage.mode.map_or(String::new(), |mode| format!(", into {}", symbol(mode)))
            ),
            None => "The body stays at rest up to twice the load.".to_owned(),
        };
        let mut words = vec![departure];
        words.extend(at_full_load(&full));
        let effective = full.effective.is_some_and(|reduced| {
            let (one, two) = (reduced.point, state.point());
            let near = |a: f64, b: f64| (a - b).abs() <= 1e-9 * a.abs().max(b.abs());
            !near(one.k(), two.k()) || !near(one.k_prime(), two.k_prime())
        });
        Ok(LoadPath { svg: load_plane_on_screen(&plane, across).svg().to_owned(), words, effective })
    }
}

fn at_full_load(full: &Full) -> Vec<String> {
    let mut words = Vec::new();
    if full.is_lifted() {
        words.push("Under the full load nothing presses the body on its base any more.".to_owned());
    }
    if let Some(mode) = full.mode {
        let others: Vec<_> = full.others().iter().map(symbol).collect();
        let also = if others.is_empty() { String::new() } else { format!(" (also {})", others.join(", ")) };
        words.push(format!(
            "Under the full load, applied at once, it {}: {}{also}.",
            mode.words().replace('\'', "′"),
            symbol(mode)
        ));
    }
    if let Some(reduced) = full.effective {
        words.push(format!(
            "Effective coordinates: <i>k</i><sub>eff</sub> = {}, <i>k</i>′<sub>eff</sub> = {}.",
            shown(reduced.point.k()),
            shown(reduced.point.k_prime())
        ));
    }
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_water_the_path_is_the_force_and_the_effective_point_the_point() {
        let mut state = State { force: 0.7, ..State::default() };
        let full = situation(&state).unwrap().at(1.0).unwrap();
        assert_eq!(full.mode, Some(state.point().mode()));
        assert!(!LoadPath::of(&state, 300.0).effective);
        let departs = state.point().margins().leaves_rest().unwrap().at / state.force;
        let stages = situation(&state).unwrap().path(UP_TO).unwrap();
        assert!((first_departure(&stages).unwrap().from / departs - 1.0).abs() < 1e-12);
        let before = state.point();
        assert!(take_effective(&mut state));
        assert!((state.elevation - before.k_prime()).abs() < 1e-12);
    }

    #[test]
    fn buoyancy_of_equal_levels_lowers_the_weight_and_no_more() {
        // 5 m of sea water under 15 m of base: 1030 · 5 · 15 kg/m of 378 t/m.
        let mut state = State::default();
        (state.waters.sea, state.waters.lee) = (5.0, 5.0);
        let (k, mirrored) = (state.force, !state.mirrored);
        for mirrored in [mirrored, !mirrored] {
            let mut state = State { mirrored, ..state.clone() };
            assert!(LoadPath::of(&state, 300.0).effective);
            assert!(take_effective(&mut state));
            let expected = k / (1.0 - 1030.0 * 5.0 * 15.0 / 378e3);
            assert!((state.force / expected - 1.0).abs() < 1e-12);
            assert!((state.elevation - 0.9).abs() < 1e-12);
            assert_eq!(state.mirrored, mirrored);
        }
    }

    #[test]
    fn uplift_acts_under_the_seaward_edge_whichever_side_that_is() {
        let modes = [false, true].map(|mirrored| {
            let mut state = State { mirrored, force: 0.4, ..State::default() };
            state.waters.uplift = 60e3;
            let full = situation(&state).unwrap().at(1.0).unwrap();
            let reduced = full.effective.unwrap();
            (reduced.point, full.mode.map(|mode| if mirrored { mode.mirrored() } else { mode }))
        });
        let ((one, one_mode), (two, two_mode)) = (modes[0], modes[1]);
        assert_eq!(one_mode, two_mode);
        assert!((one.k_prime() - two.k_prime()).abs() < 1e-12 && one.k_prime() > 0.9);
    }
}
