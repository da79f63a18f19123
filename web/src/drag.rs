//! What is dragged: numbers that vary by key, and are written into the text in the end.

use standfast::loads::{LoadId, LoadSource};
use standfast_cases::couple::{Variable, vary};
use standfast_cases::{Assessed, CaseError, CaseFile, Key, case};
use standfast_figures::Picture;
use standfast_inputs::Place;
use standfast_inputs::key::{Id, Table};

use crate::answered::Answered;
use crate::by_hand;
use crate::notches::Notch;
use crate::numbers;
use crate::page::Page;
use crate::plane::Drawn;

/// What is held.
#[derive(Debug)]
pub struct Held {
    /// The case as it varies.
    pub file: CaseFile,
    /// Its answer.
    pub answered: Answered,
    /// The plane as it was drawn when the drag began.
    plane: Option<Picture>,
    /// The force that moves the design point to the side, as it was then.
    force: Option<f64>,
    /// True if the view of the plane follows the case again in the end.
    pub view_was_free: bool,
    /// How finely numbers were dragged, in SI units.
    steps: Vec<(Id, f64)>,
    /// Where the side that is dragged halts.
    pub notches: Vec<Notch>,
    /// Why the last place had no answer.
    pub refused: Option<CaseError>,
    /// True if a side of the body is dragged.
    pub is_sized: bool,
    /// The history of which points were dragged.
    pub by_hand: Option<(Table, usize)>,
}

impl Held {
    /// A case as it stands.
    pub fn of(file: &CaseFile, answered: &Answered, drawn: &Drawn) -> Held {
        let force = answered.worst().and_then(|worst| force_of_point(worst, drawn.is_load()));
        Held {
            file: file.clone(),
            answered: answered.clone(),
            plane: drawn.plane.clone(),
            force: force.and_then(|id| file.inputs().number(id)),
            view_was_free: false,
            steps: Vec::new(),
            notches: Vec::new(),
            refused: None,
            is_sized: false,
            by_hand: None,
        }
    }

    /// The text of a file with the numbers that were varied, to no more decimals than the hand had.
    pub fn written(&self, file: &CaseFile) -> String {
        let mut now = file.clone();
        for (id, step) in &self.steps {
            let Some(si) = self.file.inputs().number(*id) else { continue };
            let round = |value, unit: &str| Some(rounded(value, now.from_si(*id, *step, unit)?));
            let next = now.rewritten(*id, si, round);
            now = next.unwrap_or(now);
        }
        let drawn =
            self.by_hand.and_then(|of| by_hand::written(&now, of, &by_hand::corners(&self.file, of)?));
        drawn.unwrap_or_else(|| now.text().to_owned())
    }

    fn note(&mut self, id: Id, step: f64) {
        match self.steps.iter_mut().find(|(other, _)| *other == id) {
            Some(found) => found.1 = step,
            None => self.steps.push((id, step)),
        }
    }
}

/// A value with no more decimals than its step deserves.
pub(crate) fn rounded(value: f64, step: f64) -> f64 {
    let decimals = (-step.abs().log10()).ceil().clamp(-6.0, 12.0) as i32;
    // Dividing by a whole power keeps the decimal that is meant.
    match decimals {
        0.. => (value * 10f64.powi(decimals)).round() / 10f64.powi(decimals),
        _ => (value / 10f64.powi(-decimals)).round() * 10f64.powi(-decimals),
    }
}

/// The place of a force of the case among its loads.
fn force_id(load: LoadId) -> Option<Id> {
    match case::said_by(load) {
        Place::Table(Table::Load, index) => Some(Id::new(Key::Force, index)),
        _ => None,
    }
}

/// The force that moves the design point to the side: the only force that varies. In the plane of the load it is the only load that does;
/// in the report's plane uplift may stay beside it, but no wave and no earthquake, which would be others.
pub fn force_of_point(assessed: &Assessed, is_load: bool) -> Option<Id> {
    let varied: Vec<_> = assessed.situation.loads().iter().filter(|load| !load.permanent).collect();
    let (forces, others): (Vec<_>, Vec<_>) =
        varied.into_iter().partition(|load| load.source == LoadSource::Force);
    let may_stay = others.iter().all(|load| !is_load && load.source == LoadSource::Uplift);
    match forces[..] {
        [load] if may_stay => {
            let wrench = assessed.situation.wrench_of(load);
            force_id(load.id).filter(|_| wrench.p == 0.0 && wrench.x != 0.0)
        }
        _ => None,
    }
}

/// The size of a force at which all loads together come to k, as a multiple of the one it has; `None` if none does that keeps its
/// direction.
fn share_for_k(assessed: &Assessed, id: Id, k: f64) -> Option<f64> {
    let load = assessed.situation.loads().iter().find(|load| force_id(load.id) == Some(id))?;
    let (force, all) = (assessed.situation.wrench_of(load), assessed.outcome.full.wrench);
    let (x, p) = (all.x - force.x, all.p - force.p);
    let way = all.x.signum();
    let share = (way * k * p - x) / (force.x - way * k * force.p);
    (share.is_finite() && share >= 0.0).then_some(share)
}

impl Page {
    /// Directions in which the design point goes: to the side by a force, and up by friction.
    pub(crate) fn point_goes(&self) -> [bool; 2] {
        let Some(worst) = self.answered().worst() else { return [false, false] };
        let file = self.settled();
        let has = |id: Id| file.written_number(id).is_some();
        [force_of_point(worst, self.drawn.is_load()).is_some_and(has), has(Key::Friction.into())]
    }

    /// Share of the load at which the design point stands in a plane of the load: 1 but for a force that is dragged.
    pub(crate) fn share(&self) -> f64 {
        let held = self.held.as_ref().and_then(|held| {
            let id = force_of_point(held.answered.worst()?, self.drawn.is_load())?;
            Some(held.file.inputs().number(id)? / held.force?)
        });
        held.filter(|share| share.is_finite()).unwrap_or(1.0)
    }

    /// Drags the design point to a place in the plate.
    pub fn drag_point(&mut self, (x, y): (f64, f64)) {
        let [sideways, up] = self.point_goes();
        let is_load = self.drawn.is_load();
        let Some(plane) = self.held.as_ref().and_then(|held| held.plane.clone()) else { return };
        if !(x.is_finite() && y.is_finite()) {
            return;
        }
        let plot = plane.plot;
        let (across, mu) = plane.values(x.clamp(plot.x0, plot.x1), y.clamp(plot.y0, plot.y1));
        let units = |length: f64, axis: standfast_figures::Axis| (axis.to - axis.from) / length;
        let mu_step = units(plot.y1 - plot.y0, plane.up);
        let across_step = units(plot.x1 - plot.x0, plane.across);
        let Some(held) = &mut self.held else { return };
        let mut changes: Vec<(Id, f64)> = Vec::new();
        if up {
            changes.push((Key::Friction.into(), rounded(mu, mu_step)));
            held.note(Key::Friction.into(), mu_step);
        }
        if let Some(worst) = held.answered.worst().filter(|_| sideways)
            && let (Some(id), Some(first)) = (force_of_point(worst, is_load), held.force)
            && let Some(now) = held.file.inputs().number(id)
        {
            let force = match is_load {
                true => Some(across * first),
                false => share_for_k(worst, id, across).map(|share| share * now),
            };
            let step = match is_load {
                true => across_step * first,
                false => worst.outcome.full.wrench.p * across_step,
            };
            if let Some(force) = force {
                // A force of nothing has no direction to come back from.
                let least = 1e-3 * first;
                changes.push((id, rounded(force, step.abs()).max(least)));
                held.note(id, step.abs());
            }
        }
        self.vary(|inputs| changes.into_iter().for_each(|(id, number)| inputs.set(id, number)));
    }

    /// Moves the design point by shares of the plate's width and height, as one step.
    pub fn nudge(&mut self, (right, up): (f64, f64)) {
        let Some(plane) = self.drawn.plane.clone() else { return };
        let [x, y, ..] = self.point()[..] else { return };
        let plot = plane.plot;
        self.grab();
        self.drag_point((x + right * (plot.x1 - plot.x0), y - up * (plot.y1 - plot.y0)));
        self.release();
    }

    /// Drags the beginning of the arrow of a force to a place in the section: along it the force, across it its level, each from a few pixels on.
    pub fn drag_force(&mut self, key: &str, (x, y): (f64, f64)) {
        let Some((id, arrow)) = self.drawn.forces.iter().find(|(id, _)| id.to_string() == key).copied()
        else {
            return;
        };
        let (Some(body), Some(scale)) = (self.drawn.body, self.drawn.scale) else { return };
        let first = self.settled().inputs().number(id);
        let elevation = Id { key: Key::Elevation, ..id };
        let has_level = self.settled().written_number(elevation).is_some();
        let height = self.settled().inputs().number(Key::Height);
        const NEAR: f64 = 4.0;
        let Some(held) = &mut self.held else { return };
        let (Some(first), true) = (first, x.is_finite() && y.is_finite()) else { return };
        let mut changes = Vec::new();
        let length = arrow.tail.0 - arrow.tip.0;
        // A hand that goes along an arrow does not mean its level, nor the other way.
        let [along, across] = [(x - arrow.tail.0).abs() >= NEAR, (y - arrow.tail.1).abs() >= NEAR];
        if length != 0.0 && (along || !across) {
            let step = (first / length).abs();
            // At least what a pixel is worth: a force of nothing has no direction to come back from.
            let share = ((x - arrow.tip.0) / length).clamp(1.0 / length.abs().max(1.0), 20.0);
            changes.push((id, rounded(share * first, step)));
            held.note(id, step);
        }
        if has_level && across {
            let (level, top) = ((body.y1 - y) / scale, height.unwrap_or((body.y1 - body.y0) / scale));
            changes.push((elevation, rounded(level.clamp(0.0, top), 1.0 / scale).min(top)));
            held.note(elevation, 1.0 / scale);
        }
        self.vary(|inputs| changes.into_iter().for_each(|(id, number)| inputs.set(id, number)));
    }
}

/// Numbers that say how heavy a body is.
const WEIGHTS: [Key; 3] = [Key::Mass, Key::BuoyantWeight, Key::MomentOfInertia];

impl Page {
    /// Drags the end of the width or the height of the body to a place in the section. Its density stays, or if asked its mass.
    pub fn drag_side(&mut self, key: &str, (x, y): (f64, f64), keeps_mass: bool) {
        let (Some(body), Some(scale)) = (self.drawn.body, self.drawn.scale) else { return };
        let Some(id) = numbers::find(self.settled(), key) else { return };
        let length = match id.key {
            Key::Width => (x - body.x0) / scale,
            Key::Height => (body.y1 - y) / scale,
            _ => return,
        };
        let Some(first) = self.settled().inputs().number(id).filter(|_| length.is_finite()) else { return };
        /// A hand this near to a notch means it, units.
        const NEAR: f64 = 4.0;
        let step = 1.0 / scale;
        let is_near = |notch: &&Notch| (notch.length - length).abs() * scale < NEAR && !keeps_mass;
        let notch = self.held.as_ref().and_then(|held| held.notches.iter().find(is_near));
        // A notch has its own digits.
        let (length, step) = match notch {
            Some(notch) => (notch.length, 1e-6 * notch.length),
            None => (rounded(length.clamp(0.1 * first, 3.0 * first), step), step),
        };
        self.size(id, length, step, keeps_mass);
    }

    /// Makes a side of the body some per cent longer, as one step.
    pub fn step_side(&mut self, key: &str, percent: f64, keeps_mass: bool) {
        let Some(id) = numbers::find(self.settled(), key) else { return };
        let Some(first) = self.settled().inputs().number(id) else { return };
        self.grab();
        let step = 0.001 * first;
        self.size(id, rounded(first * (1.0 + percent / 100.0), step), step, keeps_mass);
        self.release();
    }

    /// Varies a side of the body from what stands in the text, with what goes with it.
    fn size(&mut self, id: Id, length: f64, step: f64, keeps_mass: bool) {
        let inputs = self.settled().inputs().clone();
        let Some((case, first)) = self.settled_case().zip(inputs.number(id)) else { return };
        let variable = Variable::of(id, &inputs);
        let mut varied = vary(&inputs, case, &[(&variable, length)]);
        if keeps_mass {
            for (key, number) in WEIGHTS.iter().filter_map(|key| Some((*key, inputs.number(*key)?))) {
                varied.set(key, number);
            }
            if let Some(density) = inputs.number(Key::Density) {
                varied.set(Key::Density, density * first / length);
            }
        }
        let Some(held) = &mut self.held else { return };
        held.is_sized = true;
        held.note(id, step);
        for other in inputs.numbers().map(|(other, _)| other).filter(|other| *other != id) {
            let (Some(was), Some(now)) = (inputs.number(other), varied.number(other)) else { continue };
            // Of what goes with it, as many figures as it has itself, or as steps of the same length.
            if was != now {
                let is_length = inputs.dimension(other) == inputs.dimension(id);
                held.note(other, if is_length { step } else { was.abs() * step / first });
            }
        }
        self.vary(|inputs| *inputs = varied);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where a hand goes farther than there are answers, the page says why it ended before; and says nothing once it is back.
    #[test]
    fn what_ends_a_drag_is_said() {
        let mut page = page("density = \"2.1 t/m3\"");
        page.section((560.0, 400.0), None);
        let (body, scale) = (page.drawn.body.unwrap(), page.drawn.scale.unwrap());
        let place = |metres: f64| (body.x0, body.y1 - metres * scale);
        page.grab();
        page.drag_side("body.height", place(11.8), false);
        // The force acts 11.5 m above the base.
        page.drag_side("body.height", place(9.0), false);
        page.release();
        assert_eq!(page.told, "No farther: `elevation` is above the crest of the body, which is 9 m high");
        assert!(page.text().contains("height = \"11.8 m\""), "{}", page.text());
        page.told.clear();
        page.grab();
        page.drag_side("body.height", place(9.0), false);
        page.drag_side("body.height", place(12.0), false);
        page.release();
        assert_eq!(page.told, "");
    }

    /// A page with a body of 15 m by 12 m, heavy by its mass or by its density.
    fn page(weight: &str) -> Page {
        let mut page = Page::default();
        let text = page.text().replace("density = \"2.1 t/m3\"", weight);
        assert!(page.edit(&text) && text.contains(weight));
        page.section((560.0, 400.0), None);
        page
    }

    /// The width that is dragged takes the mass with it, at its density, or leaves it where it is; only those lines differ.
    #[test]
    fn a_side_is_dragged_with_what_goes_with_it() {
        for (weight, keeps_mass, lines) in [
            ("density = \"2.1 t/m3\"", false, 1),
            ("density = \"2.1 t/m3\"", true, 2),
            ("mass = \"378 t/m\"", false, 2),
            ("mass = \"378 t/m\"", true, 1),
        ] {
            let mut page = page(weight);
            let before = page.text().to_owned();
            let (body, scale) = (page.drawn.body.unwrap(), page.drawn.scale.unwrap());
            page.grab();
            page.drag_side("body.width", (body.x0 + 18.0 * scale, 0.0), keeps_mass);
            page.section((560.0, 400.0), None);
            assert_eq!(page.text(), before, "nothing is written while it is held");
            page.release();
            let changed = lines_that_differ(&before, page.text());
            assert_eq!(changed.len(), lines, "{weight}: {changed:?}");
            let width = page.settled().inputs().number(Key::Width).unwrap();
            assert!((width - 18.0).abs() < 0.06, "{width}");
            let mass = 378e3 * if keeps_mass { 1.0 } else { width / 15.0 };
            let got = page.settled_case().unwrap().body.mass();
            assert!((got / mass - 1.0).abs() < 2e-3, "{weight}: {got}, not {mass}");
            page.undo();
            assert_eq!(page.text(), before);
        }
    }

    #[test]
    fn a_height_is_dragged_and_stepped() {
        let mut page = page("mass = \"378 t/m\"");
        let (body, scale) = (page.drawn.body.unwrap(), page.drawn.scale.unwrap());
        page.grab();
        page.drag_side("body.height", (0.0, body.y1 - 13.0 * scale), false);
        page.drag_side("body.height", (0.0, f64::NAN), false);
        page.drag_side("body.friction", (1.0, 1.0), false);
        page.release();
        let height = page.settled().inputs().number(Key::Height).unwrap();
        assert!((height - 13.0).abs() < 0.06, "{height}");
        let mass = page.settled_case().unwrap().body.mass();
        assert!((mass / (378e3 * height / 12.0) - 1.0).abs() < 2e-3, "{mass}");
        page.undo();
        page.step_side("body.width", -1.0, false);
        assert_eq!(page.settled().inputs().number(Key::Width), Some(14.85));
    }

    /// Goda's crest rises with the height, and its caisson is as wide as the body.
    #[test]
    fn the_sea_goes_with_the_body() {
        let mut page = Page::default();
        assert!(page.open("goda.toml", include_str!("../../examples/goda-2000.toml")));
        page.section((560.0, 400.0), None);
        let (body, scale) = (page.drawn.body.unwrap(), page.drawn.scale.unwrap());
        page.grab();
        page.drag_side("body.width", (body.x0 + 16.5 * scale, 0.0), false);
        page.release();
        let inputs = page.settled().inputs();
        let [width, wave] = [Key::Width, Key::CaissonWidth].map(|key| inputs.number(key).unwrap());
        assert!((width - 16.5).abs() < 0.06 && width == wave, "{width} {wave}");
        page.undo();
        page.section((560.0, 400.0), None);
        let body = page.drawn.body.unwrap();
        page.grab();
        page.drag_side("body.height", (0.0, body.y1 - 11.0 * scale), false);
        page.release();
        let inputs = page.settled().inputs();
        let rise = inputs.number(Key::Height).unwrap() - 10.5;
        assert!(
            rise > 0.4 && (inputs.number(Key::CrestHeight).unwrap() - 3.4 - rise).abs() < 1e-9,
            "{}",
            page.text()
        );
    }

    fn lines_that_differ(one: &str, other: &str) -> Vec<String> {
        one.lines()
            .zip(other.lines())
            .filter(|(one, other)| one != other)
            .map(|(_, line)| line.to_owned())
            .collect()
    }

    #[test]
    fn the_design_point_comes_where_it_is_dragged() {
        for which in ["load", "k-mu"] {
            let mut page = Page::default();
            let before = page.text().to_owned();
            page.plate(which, (500.0, 400.0));
            let plane = page.drawn.plane.clone().unwrap();
            let [x, y, inside, sideways, up] = page.point()[..] else { panic!("{:?}", page.point()) };
            assert_eq!([inside, sideways, up], [1.0; 3], "{which}");
            page.grab();
            page.drag_point((x - 60.0, y - 30.0));
            let [at_x, at_y, ..] = page.point()[..] else { panic!("no point") };
            assert!(
                (at_x - (x - 60.0)).abs() < 1.0 && (at_y - (y - 30.0)).abs() < 1.0,
                "{which}: {at_x} {at_y}"
            );
            assert_eq!(page.text(), before, "nothing is written while it is held");
            let wanted = plane.values(x - 60.0, y - 30.0);
            page.release();
            let changed = lines_that_differ(&before, page.text());
            assert_eq!(changed.len(), 2, "{changed:?}");
            assert!(
                changed[0].starts_with("friction = ") && changed[1].starts_with("force = \""),
                "{changed:?}"
            );
            let inputs = page.settled().inputs();
            let friction = inputs.number(Key::Friction).unwrap();
            assert!((friction - wanted.1).abs() < 0.01);
            let share = inputs.number(Key::Force).unwrap() / 2.7e6;
            let k = inputs.number(Key::Force).unwrap() / (378e3 * 9.81);
            let got = if which == "load" { share } else { k };
            assert!((got - wanted.0).abs() < 0.01, "{which}: {got}, not {}", wanted.0);
            page.undo();
            assert_eq!(page.text(), before);
        }
    }

    /// Water and uplift stay while the force varies, and the point stays under the hand.
    #[test]
    fn the_force_is_found_beside_water_and_uplift() {
        let mut page = Page::default();
        let fragment = "g=0.8&kp=0.9&k=0.5&mu=0.6&sea=8&lee=8&up=60000";
        assert!(page.open("link.toml", &crate::old_link::case(fragment).unwrap()));
        page.plate("k-mu", (500.0, 400.0));
        let plane = page.drawn.plane.clone().unwrap();
        let [x, y, _, sideways, _] = page.point()[..] else { panic!("no point") };
        assert_eq!(sideways, 1.0);
        page.grab();
        page.drag_point((x - 90.0, y - 50.0));
        let reduced = page.answered().point().unwrap();
        let (k, mu) = plane.values(x - 90.0, y - 50.0);
        assert!((reduced.point.k() - k).abs() < 0.005 && (reduced.point.mu() - mu).abs() < 0.005);
        page.plate("load", (500.0, 400.0));
        assert_eq!(page.point()[3], 0.0, "a share of both loads is no force");
    }

    /// Under a wave only friction is dragged: another share of the load would be another sea.
    #[test]
    fn a_wave_is_not_dragged() {
        let mut page = Page::default();
        assert!(page.open("goda.toml", include_str!("../../examples/goda-2000.toml")));
        let before = page.text().to_owned();
        page.plate("load", (500.0, 400.0));
        let [x, y, _, sideways, up] = page.point()[..] else { panic!("no point") };
        assert_eq!([sideways, up], [0.0, 1.0]);
        page.grab();
        page.drag_point((x + 80.0, y + 40.0));
        page.release();
        let changed = lines_that_differ(&before, page.text());
        assert!(changed.len() == 1 && changed[0].starts_with("friction = 0."), "{changed:?}");
    }

    #[test]
    fn an_arrow_is_dragged_along_and_across() {
        let mut page = Page::default();
        let before = page.text().to_owned();
        page.section((560.0, 400.0), None);
        let (id, arrow) = page.drawn.forces[0];
        let key = id.to_string();
        page.grab();
        let scale = page.drawn.scale.unwrap();
        let half = (arrow.tip.0 + arrow.tail.0) / 2.0;
        page.drag_force(&key, (half, arrow.tail.1 + 2.0 * scale));
        page.release();
        let changed = lines_that_differ(&before, page.text());
        assert_eq!(changed.len(), 2, "{changed:?}");
        let inputs = page.settled().inputs();
        assert!((inputs.number(Key::Force).unwrap() / 1.35e6 - 1.0).abs() < 0.02);
        assert!((inputs.number(Key::Elevation).unwrap() - 9.5).abs() < 0.06);
        // Pulled to its tip, and beyond, it is small and still there.
        page.section((560.0, 400.0), None);
        page.grab();
        page.drag_force(&key, (arrow.tip.0 + 40.0, arrow.tail.1 + 2.0 * scale));
        page.drag_force(&key, (arrow.tip.0 - 40.0, arrow.tail.1 + 2.0 * scale));
        page.release();
        let force = page.settled().inputs().number(Key::Force).unwrap();
        assert!(force > 0.0 && force < 2e5, "{force}");
        page.undo();
        page.section((560.0, 400.0), None);
        page.grab();
        page.drag_force(&key, (f64::NAN, 0.0));
        page.drag_force(&key, (0.0, -1e9));
        page.let_go();
        assert_eq!(lines_that_differ(&before, page.text()), changed);
    }

    #[test]
    fn nonsense_moves_nothing() {
        let mut page = Page::default();
        let before = page.text().to_owned();
        page.plate("k-mu", (500.0, 400.0));
        page.grab();
        for place in [(f64::NAN, 0.0), (0.0, f64::INFINITY)] {
            page.drag_point(place);
        }
        page.release();
        assert_eq!(page.text(), before);
        page.drag_point((1.0, 1.0));
        assert_eq!(page.text(), before, "nothing is held");
    }

    #[test]
    fn numbers_have_the_decimals_of_the_hand() {
        let cases = [
            (1234.567, 2.0, 1235.0),
            (0.123_456, 0.003, 0.123),
            (12_345.6, 130.0, 12_300.0),
            (0.3, 0.01, 0.3),
        ];
        for (value, step, expected) in cases {
            assert!(
                (rounded(value, step) - expected).abs() < 1e-9,
                "{value} {step}: {}",
                rounded(value, step)
            );
        }
    }
}
