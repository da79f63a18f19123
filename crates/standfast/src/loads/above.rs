//! What is above a level joint, as one body, and the part of each load that acts on it.
//!
//! ```text
//!            ┌────────┐ ◄──            what is above the joint is a body of its own: its base is the contact,
//!            │        │ ◄── above      its frame begins at the middle of that
//!     ───────O────────O'───────────── level of the joint
//!     │                     │ ◄── below
//! ```
//!
//! A pressure along a side is cut at the level, and one along the top at the ends of what is above; a force acts above where it is at the level
//! or higher. What presses on the base of the whole is below. Water in the joint is a load of its own.

use super::earth::pore_water_above;
use super::{Action, BodyPoint, Face, Load, LoadKind, LoadSource, PressureAt, PressureDiagram};
use crate::ball::Scalar;
use crate::body::{BaseEdges, Body};
use crate::error::InputError;
use crate::plan::Plan;
use crate::section::{Piece, Section};

/// All that is above a joint, as one body.
#[derive(Debug, Clone, PartialEq)]
pub struct AboveJoint<T = f64> {
    body: Body<T>,
    /// Of the joint, above the base of the whole.
    level: T,
    /// Its mid-width to the right of that of the whole.
    shift: T,
    /// The left and the right end of what is above, to the right of mid-width of the whole.
    reach: [T; 2],
}

impl<T: Scalar> AboveJoint<T> {
    /// What is above a `level` of a uniform block or cylinder; the joint reaches over its `contact`, from and to so far to the right of
    /// mid-width.
    ///
    /// # Errors
    /// If its centre of mass is not above the contact.
    pub fn of_block(whole: &Body<T>, level: T, contact: [T; 2]) -> Result<AboveJoint<T>, InputError> {
        let height = whole.height() - level.clone();
        let mass = whole.mass() * height.clone() / whole.height();
        let [left, right] = contact;
        let body = match whole.plan() {
            Plan::Circle => Body::cylinder(whole.width(), height, mass)?,
            Plan::Rectangle { length } => Body::new(whole.width(), height, mass)?.with_length(length)?,
        };
        let half = whole.width() / T::of(2.0);
        let is_whole = left == T::of(0.0) - half.clone() && right == half;
        let body = if is_whole {
            body
        } else {
            let up = body.centroid_height();
            body.standing(BaseEdges { left: T::of(0.0) - left, right }, T::of(0.0), up)?
        };
        Ok(AboveJoint { body, level, shift: T::of(0.0), reach: [T::of(0.0) - half.clone(), half] })
    }

    /// What is above the joint under a `piece` that reaches up to the crest of `section`, of which `whole` is the body; the joint reaches over its
    /// `contact`, to the right of the origin of the drawing. Its mass, and where that is, are those that are computed in f64.
    ///
    /// # Errors
    /// If its centre of mass is not above the contact.
    pub fn of_section(
        whole: &Body<T>,
        section: &Section,
        piece: &Piece,
        level: T,
        contact: [T; 2],
    ) -> Result<AboveJoint<T>, InputError> {
        let [from, to] = section.ends();
        let middle = T::computed((from + to) / 2.0);
        let length = whole.plan().side(whole.width());
        let two = || T::of(2.0);
        let half = (contact[1].clone() - contact[0].clone()) / two();
        let mid = (contact[0].clone() + contact[1].clone()) / two();
        let mass = T::computed(piece.mass.mass) * length.clone();
        let inertia = T::computed(piece.mass.moment_of_inertia) * length.clone();
        let offset = T::computed(piece.mass.centre.x) - mid.clone();
        let up = T::computed(piece.mass.centre.y) - level.clone();
        let body =
            Body::new(half.clone() * two(), whole.height() - level.clone(), mass)?.with_length(length)?;
        let body = body.standing(BaseEdges { left: half.clone(), right: half }, offset, up)?;
        let body = body.with_moment_of_inertia(inertia)?;
        let reach = section.ends_above(piece.bottom).map(|x| T::computed(x) - middle.clone());
        Ok(AboveJoint { body, level, shift: mid - middle, reach })
    }

    /// The body: all that is above, as if it were one.
    pub fn body(&self) -> &Body<T> {
        &self.body
    }

    /// The level of the joint above the base of the whole, m.
    pub fn level(&self) -> T {
        self.level.clone()
    }

    /// Its mid-width to the right of that of the whole, m.
    pub fn shift(&self) -> T {
        self.shift.clone()
    }

    /// True if a height above the base of the whole is the level or above it.
    pub fn reaches(&self, elevation: &T) -> bool {
        elevation.value() >= self.level.value() * (1.0 - 4.0 * f64::EPSILON)
    }

    /// A place of the whole, in the frame of what is above.
    pub fn place(&self, at: &BodyPoint<T>) -> BodyPoint<T> {
        BodyPoint { x: at.x.clone() - self.shift.clone(), y: at.y.clone() - self.level.clone() }
    }

    /// The water outside that stands on steps and slopes of what is above the joint under `piece`, or lifts it where it overhangs: at each side up
    /// to a level above the base of the whole, m, its `unit_weight` in N/m³.
    pub fn water_on_sides(
        &self,
        section: &Section,
        piece: &Piece,
        levels: [f64; 2],
        unit_weight: f64,
    ) -> Vec<Load<T>> {
        let [from, to] = section.ends();
        let middle = (from + to) / 2.0;
        let length = self.body.plan().side(self.body.width()).value();
        let sides = [
            (LoadSource::WaterOnLeft, [levels[0], 0.0], levels[0]),
            (LoadSource::WaterOnRight, [0.0, levels[1]], levels[1]),
        ];
        let mut loads = Vec::new();
        for (source, levels, level) in sides {
            let forces = section.water_on(piece, levels, unit_weight * length);
            // What presses down and what lifts, each where it acts.
            for sign in [-1.0, 1.0] {
                let of_sign = || forces.iter().filter(|force| force.up * sign > 0.0);
                let up: f64 = of_sign().map(|force| force.up).sum();
                // What rounding leaves of an upright side is no water.
                if up.abs() <= 1e-9 * unit_weight * length * level * (to - from) {
                    continue;
                }
                let x = of_sign().map(|force| force.up * force.at.x).sum::<f64>() / up;
                let at = BodyPoint { x: T::computed(x - middle), y: T::computed(level) };
                let action = Action::Force { at: self.place(&at), right: T::of(0.0), up: T::computed(up) };
                loads.push(Load::permanent(source, LoadKind::Weight, action));
            }
        }
        loads
    }

    /// The part of a load on `whole` that acts on what is above; `None` if none does. A couple acts: whether it is above, no place says.
    pub fn load(&self, whole: &Body<T>, load: &Load<T>) -> Option<Load<T>> {
        let action = match &load.action {
            Action::Weight | Action::Inertia { .. } | Action::Resultant(_) => load.action.clone(),
            Action::Force { at, right, up: _ } if load.source == LoadSource::PoreWater => {
                let [share, y] = pore_water_above(at.y.value(), self.level.value())?;
                Action::horizontal(right.clone() * T::computed(share), T::computed(y))
            }
            Action::Force { at, right, up } => {
                if !self.reaches(&at.y) {
                    return None;
                }
                Action::Force { at: self.place(at), right: right.clone(), up: up.clone() }
            }
            Action::Pressure { face: Face::Base, .. } => return None,
            Action::Pressure { face: face @ (Face::Left | Face::Right), diagram } => {
                let diagram = diagram.between(Some(&self.level), None)?;
                Action::Pressure { face: *face, diagram: diagram.moved(&self.level) }
            }
            Action::Pressure { face: Face::Top, diagram } => {
                let o = whole.base_edges().left;
                let [from, to] = self.reach.each_ref().map(|x| x.clone() + o.clone());
                let own = self.shift.clone() - self.body.base_edges().left + o;
                let diagram = diagram.between(Some(&from), Some(&to))?;
                Action::Pressure { face: Face::Top, diagram: diagram.moved(&own) }
            }
            Action::Drag { face, batter, diagram } => {
                let diagram = diagram.between(Some(&self.level), None)?;
                let (force, moment) = diagram.resultant_on(whole, *face);
                if force == T::of(0.0) {
                    return None;
                }
                let y = moment / force.clone();
                let lean = batter.clone() * y.clone();
                let x = match face {
                    Face::Left => lean - whole.base_edges().left,
                    _ => whole.base_edges().right - lean,
                };
                Action::Force { at: self.place(&BodyPoint { x, y }), right: T::of(0.0), up: -force }
            }
        };
        Some(Load { action, ..load.clone() })
    }
}

impl<T: Scalar> PressureDiagram<T> {
    /// The pressure at a position, the greater where it jumps; nothing outside.
    pub fn at(&self, position: &T) -> T {
        let x = position.value();
        let near = |pair: &&[PressureAt<T>]| pair[0].position.value() <= x && x <= pair[1].position.value();
        let pairs = self.points().windows(2).filter(near).map(|pair| on_line(&pair[0], &pair[1], position));
        pairs.fold(T::of(0.0), |most, next| if next.value().abs() > most.value().abs() { next } else { most })
    }

    /// The part of the diagram between two positions; `None` if it has no length.
    fn between(&self, from: Option<&T>, to: Option<&T>) -> Option<PressureDiagram<T>> {
        let mut points: Vec<PressureAt<T>> = Vec::new();
        for pair in self.points().windows(2) {
            let (one, two) = (&pair[0], &pair[1]);
            let starts = from.filter(|from| from.value() > one.position.value());
            let ends = to.filter(|to| to.value() < two.position.value());
            let [start, end] =
                [starts.map_or(one.position.value(), T::value), ends.map_or(two.position.value(), T::value)];
            if end < start || (end == start && one.position.value() != two.position.value()) {
                continue;
            }
            let cut = |at: Option<&T>, whole: &PressureAt<T>| match at {
                Some(at) => PressureAt { position: at.clone(), pressure: on_line(one, two, at) },
                None => whole.clone(),
            };
            for point in [cut(starts, one), cut(ends, two)] {
                if points.last() != Some(&point) {
                    points.push(point);
                }
            }
        }
        let has_length = points.len() > 1 && points[0].position != points[points.len() - 1].position;
        has_length.then(|| PressureDiagram::through(points.into_iter().map(|at| (at.position, at.pressure))))
    }

    /// The diagram with positions counted from another place.
    fn moved(&self, origin: &T) -> PressureDiagram<T> {
        let points = self.points().iter();
        PressureDiagram::through(points.map(|at| (at.position.clone() - origin.clone(), at.pressure.clone())))
    }
}

/// The pressure between two points.
fn on_line<T: Scalar>(one: &PressureAt<T>, two: &PressureAt<T>, at: &T) -> T {
    let length = two.position.clone() - one.position.clone();
    if length == T::of(0.0) {
        return two.pressure.clone();
    }
    let share = (at.clone() - one.position.clone()) / length;
    one.pressure.clone() + (two.pressure.clone() - one.pressure.clone()) * share
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::section::{Part, Vertex};
    use crate::wrench::Wrench;

    fn part(corners: &[(f64, f64)], density: f64) -> Part {
        Part::new(corners.iter().map(|(x, y)| Vertex { x: *x, y: *y }).collect(), density, density).unwrap()
    }

    /// A wide footing and a stem to the left of its middle; the drawing begins 3 m left of it.
    fn section() -> Section {
        Section::new(vec![
            part(&[(3.0, 0.0), (11.0, 0.0), (11.0, 2.0), (3.0, 2.0)], 2400.0),
            part(&[(4.0, 2.0), (8.0, 2.0), (7.0, 9.0), (4.5, 9.0)], 2300.0),
        ])
        .unwrap()
    }

    /// Sums to the right, upwards and counter-clockwise about the origin of the drawing, of a wrench at a centre of mass there.
    fn about_origin(wrench: Wrench, [x, y]: [f64; 2]) -> [f64; 3] {
        [wrench.x, 0.0 - wrench.p, wrench.m - x * wrench.p - y * wrench.x]
    }

    fn near(one: [f64; 3], two: [f64; 3], tolerance: f64) -> bool {
        one.iter().zip(two).all(|(a, b)| (a - b).abs() <= tolerance * (1.0 + b.abs()))
    }

    /// What acts above a joint of each kind of load is the sum of the small forces that it is made of above there.
    #[test]
    fn the_part_above_is_the_sum_of_what_is_above() {
        let section = section();
        let whole = section.body(None, 1.5).unwrap();
        let middle = 7.0;
        let points = [(0.5, 3e3), (3.0, -1e3), (3.0, 5e3), (7.5, 2e3)];
        let pressure = |s: f64| {
            let pair = points.windows(2).find(|pair| pair[0].0 < s && s < pair[1].0);
            pair.map_or(0.0, |pair| {
                let ((s1, p1), (s2, p2)) = (pair[0], pair[1]);
                p1 + (p2 - p1) * (s - s1) / (s2 - s1)
            })
        };
        let diagram = PressureDiagram::through(points);
        for level in [2.0, 2.5, 3.0, 5.0] {
            let piece = section.above(level, None).unwrap();
            let above = AboveJoint::of_section(&whole, &section, &piece, level, piece.contact).unwrap();
            let body = above.body();
            let centre = [middle + above.shift() + body.centroid_offset(), level + body.centroid_height()];
            assert!((body.mass() - 1.5 * piece.mass.mass).abs() < 1e-9);
            assert!((centre[0] - piece.mass.centre.x).abs() < 1e-12);
            let reach = section.ends_above(level);
            for face in [Face::Left, Face::Right, Face::Top, Face::Base] {
                for batter in [None, Some(0.2)] {
                    let on_side = matches!(face, Face::Left | Face::Right);
                    if batter.is_some() && !on_side {
                        continue;
                    }
                    let mut sum = [0.0; 3];
                    let strips = 20_000;
                    for i in 0..strips {
                        let ds = 8.0 / f64::from(strips);
                        let s = (f64::from(i) + 0.5) * ds;
                        let force = 1.5 * pressure(s) * ds;
                        let lean = batter.unwrap_or(0.0) * s;
                        let (at, size) = match (face, batter) {
                            (Face::Left, None) => ([3.0, s], [force, 0.0]),
                            (Face::Right, None) => ([11.0, s], [-force, 0.0]),
                            (Face::Left, Some(_)) => ([3.0 + lean, s], [0.0, -force]),
                            (Face::Right, Some(_)) => ([11.0 - lean, s], [0.0, -force]),
                            _ => ([3.0 + s, 9.0], [0.0, -force]),
                        };
                        let acts = match face {
                            Face::Base => false,
                            Face::Top => reach[0] < at[0] && at[0] < reach[1],
                            _ => at[1] > level,
                        };
                        if acts {
                            sum[0] += size[0];
                            sum[1] += size[1];
                            sum[2] += at[0] * size[1] - at[1] * size[0];
                        }
                    }
                    let action = match batter {
                        Some(batter) => Action::Drag { face, batter, diagram: diagram.clone() },
                        None => Action::Pressure { face, diagram: diagram.clone() },
                    };
                    let load = Load::variable(LoadSource::Pressure, LoadKind::Horizontal, action);
                    let found = above
                        .load(&whole, &load)
                        .map_or([0.0; 3], |load| about_origin(load.upright(body, 9.81), centre));
                    assert!(near(found, sum, 2e-3), "{level} {face:?} {batter:?}: {found:?} {sum:?}");
                }
            }
        }
    }

    /// A force acts above a joint from its level on; weight and inertia are those of what is above.
    #[test]
    fn forces_act_where_they_are() {
        let whole = Body::new(2.0, 10.0, 1e4).unwrap();
        let above = AboveJoint::of_block(&whole, 0.1 + 0.2, [-1.0, 1.0]).unwrap();
        let push = |y: f64| Load::force(BodyPoint { x: 0.5, y }, -3.0, 1.0);
        assert!(above.load(&whole, &push(0.29)).is_none());
        let acting = above.load(&whole, &push(0.3)).unwrap();
        let Action::Force { at, right, up } = acting.action else { panic!() };
        assert!(at.y.abs() < 1e-15 && (at.x, right, up) == (0.5, -3.0, 1.0));
        let weight = Load::permanent(LoadSource::Weight, LoadKind::Weight, Action::Weight);
        let weight = above.load(&whole, &weight).unwrap().upright(above.body(), 10.0);
        assert!((weight.p - 9.7e4).abs() < 1e-8, "{}", weight.p);
        let narrow = AboveJoint::of_block(&whole, 5.0, [0.25, 1.0]);
        assert_eq!(narrow.unwrap_err().quantity, crate::quantity::Quantity::CentroidOffset);
    }

    /// Free pore water: the parabola of its pressure, added up above a level.
    #[test]
    fn pore_water_above_a_level_is_its_pressure_there() {
        let (height, level) = (5.0, 1.7);
        let [share, at] = pore_water_above(0.4 * height, level).unwrap();
        let pressure = |y: f64| (height - y).sqrt();
        let sum = |from: f64, of: &dyn Fn(f64) -> f64| -> f64 {
            let strips = 100_000;
            let dy = (height - from) / f64::from(strips);
            (0..strips).map(|i| of(from + (f64::from(i) + 0.5) * dy) * dy).sum()
        };
        let force = sum(level, &pressure);
        assert!((force / sum(0.0, &pressure) - share).abs() < 1e-6);
        assert!((sum(level, &|y| pressure(y) * (y - level)) / force - at).abs() < 1e-6);
        assert_eq!(pore_water_above(2.0, 5.0), None);
    }

    /// Water on the sides above a joint: on a ledge down, under an overhang up.
    #[test]
    fn water_stands_on_ledges_and_lifts_overhangs() {
        let section = Section::new(vec![
            part(&[(0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (0.0, 2.0)], 2400.0),
            part(&[(1.0, 2.0), (5.0, 2.0), (5.0, 4.0), (1.0, 4.0)], 2400.0),
            part(&[(2.0, 4.0), (5.0, 4.0), (5.0, 6.0), (2.0, 6.0)], 2400.0),
        ])
        .unwrap();
        let whole = section.body(None, 1.0).unwrap();
        let piece = section.above(2.0, None).unwrap();
        assert_eq!(piece.contact, [1.0, 4.0]);
        let above = AboveJoint::of_section(&whole, &section, &piece, 2.0, piece.contact).unwrap();
        let loads = above.water_on_sides(&section, &piece, [5.0, 5.0], 10.0);
        let [left, right] = &loads[..] else { panic!("{loads:?}") };
        // 1 m deep on the ledge from 1 to 2 at 4 m; 3 m under the overhang from 4 to 5 at 2 m; the joint's middle is at 2.5.
        let of = |load: &Load| match load.action {
            Action::Force { at, up, .. } => [at.x, up],
            _ => panic!(),
        };
        assert_eq!((left.source, of(left)), (LoadSource::WaterOnLeft, [-1.0, -10.0]));
        assert_eq!((right.source, of(right)), (LoadSource::WaterOnRight, [2.0, 30.0]));
    }

    #[test]
    fn a_diagram_has_a_pressure_everywhere() {
        let diagram = PressureDiagram::through([(0.0, 4.0), (2.0, 0.0), (2.0, -6.0), (3.0, -6.0)]);
        for (at, expected) in
            [(0.0, 4.0), (1.0, 2.0), (2.0, -6.0), (2.5, -6.0), (3.0, -6.0), (3.1, 0.0), (-1.0, 0.0)]
        {
            assert_eq!(diagram.at(&at), expected, "{at}");
        }
    }

    #[test]
    fn the_top_of_a_section_is_found() {
        let section = section();
        for (x, top) in [
            (3.5, Some(2.0)),
            (5.0, Some(9.0)),
            (7.5, Some(5.5)),
            (9.0, Some(2.0)),
            (2.0, None),
            (12.0, None),
        ] {
            match (section.top_at(x), top) {
                (Some(found), Some(top)) => assert!((found - top).abs() < 1e-2, "{x}: {found}"),
                (found, top) => assert_eq!(found, top, "{x}"),
            }
        }
    }
}
