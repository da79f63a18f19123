//! The way in which ground fails, for a sketch: Prandtl's mechanism, turned by the inclination of the load.
//!
//! ```text
//!   exit      near   far            s: the side to which the load pushes
//!  ───┬───────────┬▲▲▲▲┬───
//!      ╲  45°−φ/2╱ ╲   ╱            wedge under B', fan of a logarithmic spiral, wedge that is pushed out
//!       ╲_______╱___╲╱ apex
//! ```
//!
//! In weightless ground under a load inclined by δ, tan δ = |X|/P, the greatest stress under the base leans by ρ from the upright:
//!
//! ```text
//! 2ρ = δ + arcsin(sin δ / sin φ)           angles of the wedge at its far edge 45° + φ/2 − ρ, at its near edge 45° + φ/2 + ρ
//! r  = r₀ e^(ψ tan φ), ψ from 0 to 90° − ρ     the fan, about the near edge
//! ```
//!
//! Upright, ρ = 0, these are the angles of Prandtl; without friction the fan is part of a circle. The formulas of bearing resistance are
//! fitted to more than this: weight of the ground, surcharge, cohesion. So it is a shape to look at, of which nothing is calculated.
//! Sources: Prandtl 1920; the inclined load as in Sokolovskii's weightless medium [recalled]. A load that leans so much that the wedge would
//! vanish, tan δ → tan φ, is drawn with a wedge of 12°.

use super::Reaction;

/// The least angle of the wedge under the base, degrees.
const FLATTEST: f64 = 12.0;
/// Parts of the fan.
const PARTS: u32 = 24;

/// Outlines of ground that fails, m: to the right of the middle of the base and upwards from it.
#[derive(Debug, Clone, PartialEq)]
pub struct FailureShape {
    /// The edge of the effective width on the side to which the load pushes.
    pub near: (f64, f64),
    /// Its other edge.
    pub far: (f64, f64),
    /// The surface on which the ground slips: from the far edge to the tip of the wedge, along the fan, and up to the exit.
    pub surface: Vec<(f64, f64)>,
    /// Place of the tip of the wedge in `surface`, and of the end of the fan.
    pub corners: [usize; 2],
}

impl FailureShape {
    /// The shape under a reaction, of ground with an angle of friction in degrees, 0 of ground without friction; `None` where the reaction misses
    /// the base. An upright reaction pushes to the side on which it lies.
    pub fn of(reaction: &Reaction, friction_angle_deg: f64) -> Option<FailureShape> {
        let width = reaction.effective_width();
        if width <= 0.0 {
            return None;
        }
        let side = if reaction.x() == 0.0 { reaction.e().signum() } else { reaction.x().signum() };
        let phi = friction_angle_deg.to_radians();
        let steep = std::f64::consts::FRAC_PI_4 + phi / 2.0;
        let flat = (steep - lean(reaction.inclination(), phi)).max(FLATTEST.to_radians());
        let middle = reaction.e();
        let (near, far) = (middle + side * width / 2.0, middle - side * width / 2.0);
        // Angles at the near edge, from the base downwards and round to the other side.
        let (from, to) = (2.0 * steep - flat, std::f64::consts::FRAC_PI_2 + steep);
        let first = width * flat.sin() / phi.cos();
        let radius = |angle: f64| first * ((angle - from) * phi.tan()).exp();
        let fan = (0..=PARTS).map(|i| {
            let angle = from + (to - from) * f64::from(i) / f64::from(PARTS);
            (near - side * radius(angle) * angle.cos(), -radius(angle) * angle.sin())
        });
        let mut surface = vec![(far, 0.0)];
        surface.extend(fan);
        let end = surface.len() - 1;
        surface.push((near - side * 2.0 * radius(to) * to.cos(), 0.0));
        Some(FailureShape { near: (near, 0.0), far: (far, 0.0), surface, corners: [1, end] })
    }

    /// The lines of a sketch: the surface, and the sides of the fan.
    pub fn lines(&self) -> Vec<Vec<(f64, f64)>> {
        let sides = self.corners.map(|corner| vec![self.near, self.surface[corner]]);
        std::iter::once(self.surface.clone()).chain(sides).collect()
    }
}

/// By how much the greatest stress leans under a load of some inclination |X|/P, rad; without friction, whose share is not known, not at all.
fn lean(inclination: f64, phi: f64) -> f64 {
    if phi <= 0.0 {
        return 0.0;
    }
    let delta = inclination.atan().min(phi);
    (delta + (delta.sin() / phi.sin()).min(1.0).asin()) / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shape(x: f64, e: f64, phi: f64) -> FailureShape {
        FailureShape::of(&Reaction::new(5.0, 1e6, x * 1e6, e).unwrap(), phi).unwrap()
    }

    /// By hand: an upright load on a strip of 10 m. At 30° the wedge is a triangle of equal sides, the spiral grows e^(π/2 tan 30°) = 2.47660 times
    /// and the exit lies 2 cos 30° times that away; without friction the wedge has 45° and a quarter of a circle.
    #[test]
    fn upright_it_is_prandtl_s() {
        for (phi, depth, exit) in [(30.0, 8.660_254, 42.896_0), (0.0, 5.0, 10.0)] {
            let found = shape(0.0, 0.0, phi);
            let [tip, end] = found.corners.map(|corner| found.surface[corner]);
            assert!(tip.0.abs() < 1e-9 && (tip.1 + depth).abs() < 1e-5, "{tip:?}");
            let out = found.surface.last().unwrap();
            assert!(((out.0 - found.near.0).abs() - exit).abs() < 2e-3 && out.1 == 0.0, "{out:?}");
            // The end of the fan lies half way to the exit.
            assert!((end.0 - (found.near.0 + out.0) / 2.0).abs() < 1e-9);
        }
    }

    /// Along the fan the ground slips at φ to the normal of the radius, and on both sides of the wedge at 45° + φ/2 to the greatest stress, which
    /// leans as Mohr's circle has it: with σ = P/B' and τ = X/B' on the base, the circle that touches τ = σ tan φ has its greater pole there.
    #[test]
    fn under_an_inclined_load_the_stresses_of_mohr_s_circle_lie_between() {
        for (phi, slope) in [(35.0, 0.5155), (25.0, 0.2), (42.0, 0.7)] {
            let found = shape(-slope, -1.0, phi);
            let [tip, end] = found.corners;
            let angle = phi * std::f64::consts::PI / 180.0;
            // The passive state of σ = 1, τ = slope: the lesser circle, its centre from (σ − c)² + τ² = c² sin² φ.
            let (sin, cos) = angle.sin_cos();
            let centre = (1.0 - (1.0 - (1.0 + slope * slope) * cos * cos).sqrt()) / (cos * cos);
            assert!(((1.0 - centre).powi(2) + slope * slope - (centre * sin).powi(2)).abs() < 1e-12);
            let lean = 0.5 * slope.atan2(1.0 - centre);
            let (far, apex) = (found.far, found.surface[tip]);
            let flat = (-apex.1).atan2(far.0 - apex.0);
            assert!(
                (flat - (std::f64::consts::FRAC_PI_4 + angle / 2.0 - lean)).abs() < 1e-9,
                "{flat} {lean}"
            );
            for pair in found.surface[tip..=end].windows(3) {
                let middle = pair[1];
                let along = (pair[2].0 - pair[0].0, pair[2].1 - pair[0].1);
                let radius = (middle.0 - found.near.0, middle.1 - found.near.1);
                let dot = along.0 * radius.0 + along.1 * radius.1;
                let cross = along.0 * radius.1 - along.1 * radius.0;
                assert!((dot.atan2(cross.abs()) - angle).abs() < 2e-3, "{phi}: {}", dot.atan2(cross.abs()));
            }
        }
    }

    /// It begins at the edges of the effective width and leaves the ground on the side of the push; the other way round it is its mirror image.
    #[test]
    fn it_lies_between_the_edges_and_goes_where_the_load_pushes() {
        let left = shape(-0.5, -1.5, 35.0);
        // B' = 10 m − 2 · 1.5 m, about −1.5 m.
        assert_eq!((left.far, left.near, left.surface[0]), ((2.0, 0.0), (-5.0, 0.0), (2.0, 0.0)));
        assert!(left.surface.last().unwrap().0 < -5.0);
        assert!(left.surface.iter().all(|at| at.1 <= 0.0));
        let right = shape(0.5, 1.5, 35.0);
        for (one, other) in left.surface.iter().zip(&right.surface) {
            assert!((one.0 + other.0).abs() < 1e-12 && (one.1 - other.1).abs() < 1e-12);
        }
        // Pushed to the left though the reaction lies to the right of the middle.
        assert!(shape(-0.5, 1.5, 35.0).surface.last().unwrap().0 < -2.0);
        // A load as steep as the ground can take still has a wedge, and one that misses the base has none.
        let steep = shape(-0.9, 0.0, 35.0);
        assert!(steep.surface[1].1 < -0.5);
        assert_eq!(FailureShape::of(&Reaction::new(5.0, 1e6, 0.0, 6.0).unwrap(), 35.0), None);
    }
}
