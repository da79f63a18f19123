//! Pressure of soil: held against trial wedges, Rankine's closed form, sums over thin slices and worked numbers.

use standfast::loads::earth::{
    Backfill, EarthPoint, EarthState, GroundWater, PoreWater, Shaking, Soil, SoilLayer, active, at_rest,
    of_cohesion,
};
use standfast::loads::{Face, Pose};
use standfast::{Body, Wrench};

fn near(found: f64, expected: f64, by: f64) {
    assert!((found - expected).abs() <= by * expected.abs(), "{found}, expected {expected}");
}

/// To six digits.
fn six(found: f64, expected: f64) {
    near(found, expected, 5e-6);
}

fn soil(φ: f64, δ: f64) -> Soil {
    Soil {
        friction_angle_deg: φ,
        wall_friction_deg: δ,
        unit_weight: 18e3,
        unit_weight_saturated: Some(20e3),
        unit_weight_dry: None,
        cohesion: 0.0,
        adhesion: 0.0,
        ocr: 1.0,
    }
}

fn fill(soil: Soil, top: f64) -> Backfill {
    Backfill {
        face: Face::Right,
        top,
        state: EarthState::Active,
        slope_deg: 0.0,
        batter_deg: 0.0,
        surcharge: 0.0,
        layers: vec![SoilLayer { soil, thickness: top }],
        pore_water: PoreWater::Free,
        increment_at: 0.6,
    }
}

fn force(points: &[EarthPoint], of: fn(&EarthPoint) -> f64) -> [f64; 2] {
    let strips = points.windows(2).map(|pair| {
        let [y1, y2] = [pair[0].elevation, pair[1].elevation];
        let [p1, p2] = [of(&pair[0]), of(&pair[1])];
        [(p1 + p2) / 2.0 * (y2 - y1), (y2 - y1) / 6.0 * (p1 * (2.0 * y1 + y2) + p2 * (y1 + 2.0 * y2))]
    });
    strips.fold([0.0; 2], |sum, strip| [sum[0] + strip[0], sum[1] + strip[1]])
}

/// The push of a plane wedge of soil of unit weight and height 1 under a ground at β, on a wall at batter θ, its failure plane at `ρ` from
/// the horizontal; gravity turned by ψ and as large as 1/cos ψ, and `q` on each horizontal metre of the ground. Radians.
fn wedge([φ, δ, β, θ, ψ]: [f64; 5], q: f64, ρ: f64) -> f64 {
    // Corners: foot at 0, head of the wall at (−tan θ, 1) from it, the soil at the right of both.
    let head = [-θ.tan(), 1.0];
    // Where the plane from the foot meets the ground through the head.
    let x = (head[1] - head[0] * β.tan()) / (ρ.tan() - β.tan());
    let meets = [x, x * ρ.tan()];
    let area = (meets[0] * head[1] - meets[1] * head[0]) / 2.0;
    let weight = (area + q * (meets[0] - head[0])) / ψ.cos();
    // Equilibrium of weight, turned towards the wall, reaction on the plane and on the wall.
    weight * (ρ - φ + ψ).sin() / (ρ - φ - θ - δ).cos()
}

/// The greatest push of all wedges, by a fine scan and then thirds.
fn greatest(of: [f64; 5], q: f64) -> f64 {
    let [φ, _, β, θ, _] = of;
    let (mut low, mut high): (f64, f64) = (φ.max(β + 1e-6), std::f64::consts::FRAC_PI_2 + θ.min(0.0) - 1e-6);
    let at = |ρ: f64| wedge(of, q, ρ);
    let steps = 4000;
    let place = (1..steps).max_by(|one, two| {
        let ρ = |i: &i32| low + (high - low) * f64::from(*i) / f64::from(steps);
        at(ρ(one)).total_cmp(&at(ρ(two)))
    });
    let step = (high - low) / f64::from(steps);
    let middle = low + step * f64::from(place.unwrap());
    (low, high) = (middle - step, middle + step);
    for _ in 0..100 {
        let thirds = [low + (high - low) / 3.0, high - (high - low) / 3.0];
        if at(thirds[0]) < at(thirds[1]) { low = thirds[0] } else { high = thirds[1] }
    }
    at((low + high) / 2.0)
}

/// K is the greatest push of all plane wedges, in an earthquake and with a surcharge as well.
#[test]
fn coefficients_are_those_of_the_wedge_that_pushes_most() {
    for φ in [20.0, 30.0, 38.0] {
        for δ in [-5.0, 0.0, 12.0] {
            for β in [0.0, 7.0] {
                for θ in [-10.0, 0.0, 8.0] {
                    for ψ in [0.0, 6.0] {
                        let of = [φ, δ, β, θ, ψ].map(f64::to_radians);
                        let whole = greatest(of, 0.0);
                        near(active(φ, δ, β, θ, ψ) / 2.0, whole, 1e-8);
                        // What a surcharge adds to all wedges alike leaves the plane where it is.
                        let [_, _, β, θ, _] = of;
                        let more = greatest(of, 0.3) - whole;
                        let factor = θ.cos() * β.cos() / (θ - β).cos();
                        near(0.3 * factor * 2.0 * whole, more, 1e-8);
                    }
                }
            }
        }
    }
}

#[test]
fn rankine_is_coulomb_along_the_slope() {
    for (φ, β) in [(25.0f64, 0.0f64), (30.0, 10.0), (40.0, 33.0)] {
        let [cos_φ, cos_β] = [φ, β].map(|angle| angle.to_radians().cos());
        let q = (cos_β * cos_β - cos_φ * cos_φ).sqrt();
        // On the vertical plane the push is along the slope.
        near(active(φ, β, β, 0.0, 0.0), cos_β * (cos_β - q) / (cos_β + q), 1e-12);
    }
    near(at_rest(30.0, 0.0, 1.0), 0.5, 1e-15);
    near(at_rest(30.0, 10.0, 4.0), 0.5 * 2.0 * (1.0 + 10f64.to_radians().sin()), 1e-15);
    // Without adhesion 2√K; a great one does not help beyond 2.56√K.
    near(of_cohesion(0.25, 1e3, 0.0), 1.0, 1e-15);
    near(of_cohesion(0.25, 1e3, 1e4), 1.28, 1e-15);
}

/// Worked numbers.
#[test]
fn worked_numbers() {
    six(active(33.0, 22.0, 0.0, 0.0, 0.0), 0.264459);
    six(active(30.0, 20.0, 10.0, 5.0, 0.0), 0.385729);
    six(active(27.4531, 17.9119, 0.0, 0.0, 0.0), 0.328516);
    let water = Some(GroundWater { level: 9.5, unit_weight: 1025.0 * 9.81 });
    let quay = Backfill { surcharge: 20e3, ..fill(soil(33.0, 22.0), 11.0) };
    let pressure = quay.pressure(water);
    let both = [force(&pressure.soil, |p| p.normal), force(&pressure.surcharge, |p| p.normal)];
    let [push, moment] = [0, 1].map(|i| both[0][i] + both[1][i]);
    six(push, 231.840e3);
    six(moment / push, 4.28547);
    let drag = force(&pressure.soil, |p| p.tangential)[0] + force(&pressure.surcharge, |p| p.tangential)[0];
    six(drag, 93.6696e3);
    let at = |points: &[EarthPoint], i: usize| points[i].normal;
    assert_eq!(pressure.surcharge.len(), 2);
    let whole: Vec<f64> =
        (0..pressure.soil.len()).map(|i| at(&pressure.soil, i) + at(&pressure.surcharge, 0)).collect();
    six(whole[0], 34.6900e3);
    six(whole[1], 11.5245e3);
    six(*whole.last().unwrap(), 4.90405e3);
    // A dry wall in an earthquake.
    let dry = fill(soil(35.0, 17.5), 6.0);
    let shaken = Shaking { horizontal: 0.2, gravity: 1.0 };
    let increment = dry.increment(None, shaken).unwrap();
    six(dry.coefficients()[0].k, 0.246123);
    six(increment.coefficients[0][0].unwrap()[0], 0.379744);
    let still = force(&dry.pressure(None).soil, |p| p.normal)[0];
    six(still, 76.0530e3);
    six(still + increment.force, 117.343e3);
    six(increment.force, 41.2895e3);
    six(increment.points[0].normal, 2.75263e3);
    six(increment.points[1].normal, 11.0105e3);
    assert_eq!(increment.pore_water, None);
    // The quay in an earthquake: pore water free, and moving with the soil.
    let wet = Soil { unit_weight_dry: Some(16.5e3), ..soil(33.0, 22.0) };
    let quay = Backfill { surcharge: 10e3, ..fill(wet, 11.0) };
    let still = quay.pressure(water);
    six(force(&still.soil, |p| p.normal)[0] + force(&still.surcharge, |p| p.normal)[0], 204.868e3);
    let free = quay.increment(water, Shaking { horizontal: 0.12, gravity: 1.0 }).unwrap();
    let k_e = |increment: &standfast::loads::earth::EarthIncrement| {
        increment.coefficients[0].map(|k| k.unwrap()[0])
    };
    six(k_e(&free)[0], 0.343556);
    six(k_e(&free)[1], 0.409761);
    six(free.force, 110.397e3);
    six(free.pore_water.unwrap()[0], 63.5240e3);
    near(free.pore_water.unwrap()[1], 3.8, 1e-15);
    let moist =
        Backfill { layers: vec![SoilLayer { soil: soil(33.0, 22.0), thickness: 11.0 }], ..quay.clone() };
    six(k_e(&moist.increment(water, Shaking { horizontal: 0.12, gravity: 1.0 }).unwrap())[1], 0.426932);
    let with_soil = Backfill { pore_water: PoreWater::WithSoil, ..quay };
    let together = with_soil.increment(water, Shaking { horizontal: 0.12, gravity: 1.0 - 0.06 }).unwrap();
    six(k_e(&together)[0], 0.349406);
    six(k_e(&together)[1], 0.467576);
    six(together.force, 131.984e3);
    assert_eq!(together.pore_water, None);
}

/// The diagram is the sum over thin slices; one layer is two of the same soil; a shaking of nothing adds nothing.
#[test]
fn diagrams_agree_with_slices() {
    let mut random = 12_345u64;
    let mut next = |low: f64, high: f64| {
        random = random.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        low + (high - low) * ((random >> 11) as f64 / (1u64 << 53) as f64)
    };
    for _ in 0..300 {
        let top = next(3.0, 15.0);
        let mut layers = Vec::new();
        let mut left = top;
        for _ in 0..3 {
            let φ = next(20.0, 45.0);
            let soil = Soil {
                cohesion: if next(0.0, 1.0) < 0.5 { next(0.0, 20e3) } else { 0.0 },
                adhesion: next(0.0, 10e3),
                unit_weight: next(15e3, 20e3),
                unit_weight_saturated: Some(next(18e3, 22e3)),
                ..soil(φ, next(-0.5, 0.9) * φ)
            };
            let thickness = next(0.2, 0.6) * left;
            layers.push(SoilLayer { soil, thickness });
            left -= thickness;
        }
        layers.last_mut().unwrap().thickness = top;
        let fill = Backfill {
            slope_deg: next(0.0, 15.0),
            batter_deg: next(-15.0, 25.0),
            surcharge: next(0.0, 30e3),
            layers,
            ..fill(soil(30.0, 0.0), top)
        };
        let water = GroundWater { level: next(-2.0, 18.0), unit_weight: 10e3 };
        let pressure = fill.pressure(Some(water));
        // By slices from the top.
        let slices = 20_000;
        let dz = top / f64::from(slices);
        let (mut stress, mut sums) = (0.0, [0.0; 4]);
        let [β, θ] = [fill.slope_deg, fill.batter_deg].map(f64::to_radians);
        let q = fill.surcharge * θ.cos() * β.cos() / (θ - β).cos();
        for i in 0..slices {
            let y = top - (f64::from(i) + 0.5) * dz;
            let mut bottom = top;
            let layer = fill.layers.iter().find(|layer| {
                bottom -= layer.thickness;
                y > bottom
            });
            let Soil { friction_angle_deg: φ, wall_friction_deg: δ, cohesion: c, adhesion: a, .. } =
                layer.unwrap().soil;
            let of = layer.unwrap().soil;
            let wet = y < water.level;
            let weight = if wet { of.unit_weight_saturated.unwrap() - 10e3 } else { of.unit_weight };
            stress += weight * dz / 2.0;
            let k = active(φ, δ, fill.slope_deg, fill.batter_deg, 0.0);
            let held = c * of_cohesion(k, c, a);
            let (alone, both) = ((k * stress - held).max(0.0), (k * (stress + q) - held).max(0.0));
            let angle = θ + δ.to_radians();
            for (sum, add) in sums.iter_mut().zip([
                alone * angle.cos(),
                alone * angle.sin(),
                (both - alone) * angle.cos(),
                (both - alone) * angle.sin(),
            ]) {
                *sum += add * dz;
            }
            stress += weight * dz / 2.0;
        }
        let found = [
            force(&pressure.soil, |p| p.normal)[0],
            force(&pressure.soil, |p| p.tangential)[0],
            force(&pressure.surcharge, |p| p.normal)[0],
            force(&pressure.surcharge, |p| p.tangential)[0],
        ];
        for (found, expected) in found.into_iter().zip(sums) {
            assert!((found - expected).abs() < 2e-4 * sums[0].max(sums[2]), "{found} {expected} {fill:?}");
        }
        let mut doubled = fill.clone();
        let first = doubled.layers[0];
        let half = SoilLayer { thickness: first.thickness / 2.0, ..first };
        doubled.layers.splice(0..1, [half, half]);
        let same = doubled.pressure(Some(water));
        near(force(&same.soil, |p| p.normal)[1], force(&pressure.soil, |p| p.normal)[1], 1e-12);
    }
    let dry = fill(soil(33.0, 10.0), 7.0);
    let still = dry.increment(None, Shaking { horizontal: 0.0, gravity: 1.0 }).unwrap();
    assert!(still.force.abs() < 1e-9 && still.drag.abs() < 1e-9);
    // Beyond the greatest shaking no wedge holds; up to it there is one.
    let steep = Backfill { slope_deg: 20.0, ..dry };
    let error = steep.increment(None, Shaking { horizontal: 0.3, gravity: 1.0 }).unwrap_err();
    near(error.greatest, 13f64.to_radians().tan(), 1e-12);
    let held = |k| steep.increment(None, Shaking { horizontal: k, gravity: 1.0 }).is_ok();
    assert!(held(error.greatest) && !held(error.greatest * 1.001));
}

/// The same fill at the other side is the mirror image, and its drag is that of many small forces at any pose.
#[test]
fn loads_are_those_of_many_small_forces() {
    let body =
        Body::new(7.0, 9.0, 1e5).unwrap().with_base(3.0, 3.5).unwrap().with_centroid(0.4, 4.0).unwrap();
    let mirrored =
        Body::new(7.0, 9.0, 1e5).unwrap().with_base(3.5, 3.0).unwrap().with_centroid(-0.4, 4.0).unwrap();
    let right = Backfill { batter_deg: 8.0, surcharge: 5e3, ..fill(soil(33.0, 20.0), 8.0) };
    let left = Backfill { face: Face::Left, ..right.clone() };
    let pressure = right.pressure(Some(GroundWater { level: 4.0, unit_weight: 1e4 }));
    let sum = |fill: &Backfill, body: &Body, theta: f64| -> Wrench {
        fill.loads(&pressure.soil).iter().map(|load| load.wrench(body, 9.81, Pose { theta })).sum()
    };
    let [one, two] = [sum(&right, &body, 0.0), sum(&left, &mirrored, 0.0)];
    near(two.x, -one.x, 1e-14);
    near(two.p, one.p, 1e-14);
    near(two.m, -one.m, 1e-13);
    for theta in [0.0f64, 0.2, -0.4] {
        let slices = 40_000;
        let dy = 8.0 / f64::from(slices);
        let turned = |[x, y]: [f64; 2]| {
            let (sin, cos) = theta.sin_cos();
            [x * cos - y * sin, x * sin + y * cos]
        };
        let mut sums = [0.0; 3];
        for i in 0..slices {
            let y = (f64::from(i) + 0.5) * dy;
            let place = pressure.soil.windows(2).find(|pair| pair[0].elevation <= y && y < pair[1].elevation);
            let [low, high] = place.map(|pair| [pair[0], pair[1]]).unwrap();
            let share = (y - low.elevation) / (high.elevation - low.elevation);
            let [n, t] = [
                low.normal + share * (high.normal - low.normal),
                low.tangential + share * (high.tangential - low.tangential),
            ];
            // The push on the upright side, the drag along the batter from the edge of the base.
            for ([x, y], size) in [
                ([3.5 - 0.4, y - 4.0], [-n * dy, 0.0]),
                ([3.5 - y * 8f64.to_radians().tan() - 0.4, y - 4.0], [0.0, -t * dy]),
            ] {
                let ([x, y], [fx, fy]) = (turned([x, y]), turned(size));
                sums = [sums[0] + fx, sums[1] - fy, sums[2] + x * fy - y * fx];
            }
        }
        let found = sum(&right, &body, theta);
        for (found, expected) in [found.x, found.p, found.m].into_iter().zip(sums) {
            assert!((found - expected).abs() < 1e-6 * sums[0].abs().max(sums[2].abs()), "{found} {expected}");
        }
    }
}
