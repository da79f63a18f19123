//! Sections of parts against numeric integration, the uniform block, and pressures along their outlines.

mod common;

use common::{Random, tries};
use standfast::loads::{
    Action, BodyPoint, Face, Load, LoadKind, LoadSource, Pose, PressureAt, PressureDiagram, StillWater,
};
use standfast::section::{Part, Section, SectionError, SectionMass, Vertex, WaterTable};
use standfast::{Bearing, Body, Departure, Situation, Wrench};

fn polygon(corners: &[(f64, f64)], density: f64, wet: f64) -> Part {
    let outline = corners.iter().map(|&(x, y)| Vertex { x, y }).collect();
    Part::new(outline, density, wet).unwrap()
}

fn rectangle([left, right]: [f64; 2], [bottom, top]: [f64; 2], density: f64) -> Part {
    polygon(&[(left, bottom), (right, bottom), (right, top), (left, top)], density, density)
}

fn weight() -> Load {
    Load::permanent(LoadSource::Weight, LoadKind::Weight, Action::Weight)
}

/// A footing under a wall that leans over it on its left, beside a slope on its right, with fill wet below the water.
fn wall(random: &mut Random) -> Section {
    let x0 = random.uniform(-30.0, 30.0);
    let [toe, wall, top, slope] = [2.0, 6.0, 5.0, 3.0].map(|x| x * random.uniform(0.5, 1.5));
    let [foot, height] = [1.5, 9.0].map(|x| x * random.uniform(0.5, 1.5));
    let lean = random.uniform(-3.5, 1.0);
    let corners = [
        (x0 + toe, foot),
        (x0 + toe + wall, foot),
        (x0 + toe + lean + top, foot + height),
        (x0 + toe + lean, foot + height),
    ];
    let end = x0 + toe + wall + slope;
    Section::new(vec![
        rectangle([x0, end], [0.0, foot], 2400.0),
        polygon(&corners, 2300.0, 2100.0),
        // The other way round.
        polygon(&[corners[1], corners[2], (end, foot)], 1700.0, 2000.0),
    ])
    .unwrap()
}

/// Even-odd: whether a place is in a part.
fn holds(part: &Part, x: f64, y: f64) -> bool {
    let outline = part.outline();
    let n = outline.len();
    let crossed = (0..n).filter(|&i| {
        let (p, q) = (outline[i], outline[(i + 1) % n]);
        (p.y > y) != (q.y > y) && x < p.x + (y - p.y) / (q.y - p.y) * (q.x - p.x)
    });
    crossed.count() % 2 == 1
}

/// Mass, centre and inertia are those of many small squares.
#[test]
fn mass_is_the_sum_of_small_squares() {
    let mut random = Random(11);
    for _ in 0..tries(6) {
        let section = wall(&mut random);
        let water = WaterTable { left: random.uniform(0.0, 5.0), right: random.uniform(0.0, 5.0) };
        for water in [None, Some(water)] {
            let SectionMass { mass, centre, moment_of_inertia } = section.mass(water);
            let ([left, right], top) = (section.ends(), section.height());
            let n = 1500;
            let [dx, dy] = [(right - left) / f64::from(n), top / f64::from(n)];
            // Where the water meets the sides.
            let side = |level: f64, farther: fn(f64, f64) -> f64, from: f64| {
                let cut = section.parts().iter().flat_map(|part| {
                    let outline = part.outline();
                    (0..outline.len()).filter_map(move |i| {
                        let (p, q) = (outline[i], outline[(i + 1) % outline.len()]);
                        let crossed = (p.y > level) != (q.y > level);
                        crossed.then(|| p.x + (level - p.y) / (q.y - p.y) * (q.x - p.x))
                    })
                });
                cut.fold(from, farther)
            };
            let shore = water.map(|water| {
                [side(water.left, f64::min, f64::INFINITY), side(water.right, f64::max, f64::NEG_INFINITY)]
            });
            let (mut m, mut x_sum, mut y_sum, mut squares) = (0.0, 0.0, 0.0, 0.0);
            for i in 0..n * n {
                let x = left + (f64::from(i % n) + 0.5) * dx;
                let y = (f64::from(i / n) + 0.5) * dy;
                let Some(part) = section.parts().iter().find(|part| holds(part, x, y)) else { continue };
                let wet = water.is_some_and(|water| {
                    let [from, to] = shore.unwrap();
                    let share = ((x - from) / (to - from)).clamp(0.0, 1.0);
                    y < water.left + share * (water.right - water.left)
                });
                let density = if wet { part.density_below_water() } else { part.density() };
                let dm = density * dx * dy;
                (m, x_sum, y_sum) = (m + dm, x_sum + dm * x, y_sum + dm * y);
                squares += dm * ((x - centre.x).powi(2) + (y - centre.y).powi(2));
            }
            let near = |one: f64, two: f64, scale: f64| (one - two).abs() < 1e-3 * scale;
            assert!(near(mass, m, m), "{mass} {m}");
            assert!(near(centre.x, x_sum / m, right - left), "{} {}", centre.x, x_sum / m);
            assert!(near(centre.y, y_sum / m, top), "{} {}", centre.y, y_sum / m);
            assert!(near(moment_of_inertia, squares, squares), "{moment_of_inertia} {squares}");
        }
    }
}

/// Parts that make up a uniform rectangle are the report's body, wherever the drawing begins, to the last bit.
#[test]
fn parts_of_a_uniform_block_are_the_block() {
    let parts = |x0: f64| {
        vec![
            rectangle([x0, x0 + 6.0], [0.0, 4.0], 2100.0),
            rectangle([x0 + 6.0, x0 + 15.0], [0.0, 4.0], 2100.0),
            polygon(&[(x0, 4.0), (x0 + 15.0, 4.0), (x0 + 15.0, 12.0)], 2100.0, 2100.0),
            polygon(&[(x0, 4.0), (x0, 12.0), (x0 + 15.0, 12.0)], 2100.0, 2100.0),
        ]
    };
    for x0 in [0.0, -7.5, 1234.0] {
        let section = Section::new(parts(x0)).unwrap();
        let uniform = Body::of_density(15.0, 12.0, 2100.0).unwrap();
        let body = section.body(None, 1.0).unwrap();
        assert_eq!((body.width(), body.height(), body.is_uniform()), (15.0, 12.0, true));
        assert!((body.mass() / uniform.mass() - 1.0).abs() < 1e-12);
        let long = section.body(None, 20.0).unwrap();
        assert!((long.mass() / (20.0 * uniform.mass()) - 1.0).abs() < 1e-12 && long.is_uniform());
    }
}

/// Water on a body of parts: the sum of pressures along its outline, side by side, is what the loads add up to; under the base
/// the pressure is linear from the one head to the other.
#[test]
fn water_presses_along_the_outline() {
    let mut random = Random(12);
    for i in 0..tries(60) {
        let section = wall(&mut random);
        let top = section.height();
        let [left, right] = if i % 3 == 0 {
            [random.uniform(0.0, top); 2]
        } else {
            [random.uniform(0.0, top), random.uniform(0.0, top)]
        };
        let (density, g) = (1025.0, 9.81);
        let body = section.body(Some(WaterTable { left, right }), 1.0).unwrap();
        let water = StillWater::new(&body, left, right, density).unwrap();
        let [o, o_prime] = section.base();
        let [hull_left, hull_right] = section.ends();
        let middle = (hull_left + hull_right) / 2.0;
        let centre = (middle + body.centroid_offset(), body.centroid_height());

        // The outline seen from the left and from the right, cut into short pieces.
        let n = 100_000;
        let ends = |y: f64| {
            let cut = section.parts().iter().flat_map(|part| {
                let outline = part.outline();
                (0..outline.len()).filter_map(move |i| {
                    let (p, q) = (outline[i], outline[(i + 1) % outline.len()]);
                    ((p.y > y) != (q.y > y)).then(|| p.x + (y - p.y) / (q.y - p.y) * (q.x - p.x))
                })
            });
            cut.fold([f64::INFINITY, f64::NEG_INFINITY], |[l, r], x| [l.min(x), r.max(x)])
        };
        let mut sum = Wrench { x: 0.0, p: 0.0, m: 0.0 };
        let mut push = |x: f64, y: f64, right: f64, up: f64| {
            sum.x += right;
            sum.p -= up;
            sum.m += (x - centre.0) * up - (y - centre.1) * right;
        };
        let dy = top / f64::from(n);
        let mut before = [o, o_prime];
        for i in 0..n {
            let y = (f64::from(i) + 0.5) * dy;
            let now = ends(y);
            for (side, level) in [left, right].into_iter().enumerate() {
                let inwards = if side == 0 { 1.0 } else { -1.0 };
                // The side from the last level to this one: upright pieces, and level ones between them.
                let p = density * g * (level - y).max(0.0);
                push(now[side], y, inwards * p * dy, 0.0);
                let level_piece = now[side] - before[side];
                let at = (now[side] + before[side]) / 2.0;
                let p = density * g * (level - (y - dy / 2.0)).max(0.0);
                push(at, y, 0.0, -inwards * level_piece * p);
            }
            before = now;
        }
        for i in 0..1000 {
            let share = (f64::from(i) + 0.5) / 1000.0;
            let p = density * g * (left + share * (right - left));
            push(o + share * (o_prime - o), 0.0, 0.0, p * (o_prime - o) / 1000.0);
        }

        let loads = water.loads(&body, g).into_iter().chain(section.water_on_sides(&body, &water, g));
        let whole: Wrench = loads.map(|load| load.wrench(&body, g, Pose::UPRIGHT)).sum();
        let weight = density * g * section.area();
        let near = |one: f64, two: f64, scale: f64| (one - two).abs() < 2e-4 * scale;
        assert!(near(whole.x, sum.x, weight), "{whole:?} {sum:?}");
        assert!(near(whole.p, sum.p, weight), "{whole:?} {sum:?}");
        assert!(near(whole.m, sum.m, weight * top), "{whole:?} {sum:?}");
        if left == right {
            // Archimedes.
            let displaced = density * g * section.below(left).area;
            assert!((whole.p + displaced).abs() < 1e-9 * weight, "{whole:?} {displaced}");
        }
    }
}

/// A pressure on an upright wall leaves nothing standing on its sides.
#[test]
fn nothing_stands_on_upright_sides() {
    let section = Section::new(vec![rectangle([3.0, 18.0], [0.0, 12.0], 2100.0)]).unwrap();
    let body = section.body(None, 1.0).unwrap();
    let water = StillWater::new(&body, 7.0, 9.0, 1025.0).unwrap();
    assert_eq!(section.water_on_sides(&body, &water, 9.81), []);
}

/// A footing twice as wide as its wall, in water above it: the water on it weighs on each side, and moves as a body of a given
/// length by that length.
#[test]
fn water_on_a_footing_by_hand() {
    let section = || {
        let parts =
            vec![rectangle([0.0, 8.0], [0.0, 1.0], 2400.0), rectangle([2.0, 6.0], [1.0, 9.0], 2400.0)];
        Section::new(parts).unwrap()
    };
    for length in [1.0, 3.0] {
        let (section, g) = (section(), 10.0);
        let body = section.body(None, length).unwrap();
        assert_eq!(body.mass(), 2400.0 * 40.0 * length);
        let water = StillWater::new(&body, 5.0, 3.0, 1000.0).unwrap();
        let loads = section.water_on_sides(&body, &water, g);
        let sums: Vec<_> = loads.iter().map(|load| load.wrench(&body, g, Pose::UPRIGHT)).collect();
        // 2 m by 4 m at 1 m from O, 3 m left of C; 2 m by 2 m at 3 m right of it.
        assert!(loads.iter().all(|load| load.permanent));
        let sources = [LoadSource::WaterOnLeft, LoadSource::WaterOnRight];
        assert_eq!(loads.iter().map(|load| load.source).collect::<Vec<_>>(), sources);
        let expected = [(80e3 * length, 240e3 * length), (40e3 * length, -120e3 * length)];
        for (sum, (p, m)) in sums.iter().zip(expected) {
            assert!((sum.p - p).abs() < 1e-6 && (sum.m - m).abs() < 1e-6 && sum.x == 0.0, "{sum:?}");
        }
        let whole = Situation::new(body, 0.6, g).unwrap();
        let whole = water.loads(&body, g).into_iter().chain(loads).fold(whole, Situation::with);
        let wrench = whole.outcome().unwrap().full.wrench;
        // Pushed by ρ g (5² − 3²)/2 to the right, lifted by the mean of both heads.
        assert!((wrench.x - 80e3 * length).abs() < 1e-6, "{wrench:?}");
        assert!((wrench.p - (80e3 + 40e3 - 8.0 * 40e3) * length).abs() < 1e-6, "{wrench:?}");
    }
}

#[test]
fn parts_have_to_touch() {
    let block = || rectangle([0.0, 4.0], [0.0, 2.0], 2400.0);
    let of = |part: Part| Section::new(vec![block(), part]);
    assert!(of(rectangle([1.0, 3.0], [2.0, 5.0], 2400.0)).is_ok());
    assert!(of(rectangle([4.0, 5.0], [0.0, 3.0], 0.0)).is_ok());
    // As drawings are given, to the millimetre.
    assert!(of(rectangle([0.1 + 0.2, 3.0], [2.0009, 5.0], 2400.0)).is_ok());
    assert!(of(rectangle([4.0009, 5.0], [0.0, 1.0], 2400.0)).is_ok());
    assert!(of(rectangle([3.9991, 5.0], [0.0, 1.0], 2400.0)).is_ok());
    // On nothing, on a corner, beside a corner.
    for left in [4.0, 4.5, -2.0] {
        let loose = of(rectangle([left, left + 2.0], [2.0, 5.0], 2400.0)).map(|_| ());
        assert_eq!(loose, Err(SectionError::Loose { at: Vertex { x: left + 1.0, y: 2.0 } }));
    }
    assert!(of(rectangle([3.9, 6.0], [2.0, 5.0], 2400.0)).is_ok());
    // How far they overlap, or are apart.
    let by = |part| match of(part) {
        Err(SectionError::Overlap { by, .. } | SectionError::Gap { by, .. }) => by,
        other => panic!("{other:?}"),
    };
    for (part, expected) in [
        (rectangle([3.9, 5.0], [0.0, 1.0], 2400.0), 0.1),
        (rectangle([1.0, 3.0], [0.5, 1.5], 2400.0), 2.0),
        (rectangle([4.1, 5.0], [0.0, 1.0], 2400.0), 0.1),
        (rectangle([1.0, 3.0], [2.25, 5.0], 2400.0), 0.25),
    ] {
        assert!((by(part) - expected).abs() < 1e-12);
    }
    let overlaps = |part| matches!(of(part), Err(SectionError::Overlap { one: 0, two: 1, .. }));
    assert!(overlaps(rectangle([1.0, 3.0], [1.9, 5.0], 2400.0)));
    assert!(overlaps(rectangle([3.9, 5.0], [0.0, 1.0], 2400.0)));
    assert!(overlaps(rectangle([1.0, 3.0], [0.5, 1.5], 2400.0)));
    // Two sides that cross between corners.
    assert!(overlaps(polygon(&[(-1.0, 2.0), (4.0, 2.0), (4.0, 1.9)], 2400.0, 2400.0)));
    let gap = |part| matches!(of(part), Err(SectionError::Gap { .. }));
    assert!(gap(rectangle([1.0, 3.0], [2.1, 5.0], 2400.0)));
    assert!(gap(rectangle([4.1, 5.0], [0.0, 1.0], 2400.0)));
    assert!(gap(polygon(&[(4.0, 0.0), (5.0, 0.0), (5.0, 2.0), (4.5, 2.0)], 2400.0, 2400.0)));
    let alone = |part| Section::new(vec![part]).map(|_| ());
    let below = alone(rectangle([0.0, 4.0], [-0.5, 2.0], 1.0));
    assert_eq!(below, Err(SectionError::BelowBase { depth: 0.5 }));
    let above = alone(rectangle([0.0, 4.0], [0.5, 2.0], 1.0));
    assert_eq!(above, Err(SectionError::NotOnBase { height: 0.5 }));
    let tip = alone(polygon(&[(0.0, 0.0), (1.0, 1.0), (-1.0, 1.0)], 1.0, 1.0));
    assert_eq!(tip, Err(SectionError::NotOnBase { height: 0.0 }));
}

#[test]
fn outlines_enclose_an_area_and_do_not_cross() {
    let part = |corners: &[(f64, f64)]| {
        Part::new(corners.iter().map(|&(x, y)| Vertex { x, y }).collect(), 1.0, 1.0).map(|_| ())
    };
    assert_eq!(part(&[(0.0, 0.0), (1.0, 0.0)]), Err(SectionError::NoArea));
    assert_eq!(part(&[(0.0, 0.0), (1.0, 1.0), (2.0, 2.0)]), Err(SectionError::NoArea));
    let bow = part(&[(0.0, 0.0), (2.0, 2.0), (2.0, 0.0), (0.0, 1.0)]);
    assert_eq!(bow, Err(SectionError::Crossing { one: 1, two: 3 }));
    let spike = part(&[(0.0, 0.0), (4.0, 0.0), (2.0, 0.0), (2.0, 2.0)]);
    assert_eq!(spike, Err(SectionError::Crossing { one: 1, two: 2 }));
    let touching = part(&[(0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (2.0, 0.0), (0.0, 2.0)]);
    assert_eq!(touching, Err(SectionError::Crossing { one: 1, two: 3 }));
    assert!(part(&[(0.0, 0.0), (2.0, 0.0), (4.0, 0.0), (4.0, 2.0)]).is_ok());
    // Closed by its first corner.
    assert!(part(&[(0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (0.0, 0.0)]).is_ok());
    assert!(matches!(part(&[(0.0, f64::NAN), (2.0, 0.0), (4.0, 0.0)]), Err(SectionError::Input(_))));
    let corners = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)].map(|(x, y)| Vertex { x, y });
    assert!(matches!(Part::new(corners.to_vec(), -1.0, 1.0), Err(SectionError::Input(_))));
}

/// A body of a given length under the loads of the whole length answers as one metre of it under those of a metre.
#[test]
fn a_length_multiplies_all_forces_and_nothing_else() {
    let length = 7.0;
    let outcome = |length: Option<f64>| {
        let times = length.unwrap_or(1.0);
        let body = Body::of_density(8.0, 6.0, 2200.0 * times).unwrap();
        let body = length.map_or(body, |length| body.with_length(length).unwrap());
        let at = |position, pressure| PressureAt { position, pressure };
        let diagram = |one, two| PressureDiagram::new(vec![at(0.0, one), at(5.0, two)]).unwrap();
        let water = StillWater::new(&body, 4.0, 3.0, 1025.0).unwrap();
        let situation = Situation::new(body, 0.5, 9.81).unwrap();
        let loads = water.loads(&body, 9.81).into_iter().chain([
            weight(),
            Load::pressure(Face::Right, diagram(60e3, 0.0)),
            Load::pressure(Face::Base, diagram(10e3, 20e3)),
            Load::pressure(Face::Top, diagram(5e3, 1e3)),
            Load::force(BodyPoint { x: 0.0, y: 4.0 }, -150e3 * times, 0.0),
        ]);
        loads.fold(situation, Situation::with).outcome().unwrap()
    };
    let (metre, whole) = (outcome(None), outcome(Some(length)));
    let near = |one: f64, two: f64| (one - two).abs() <= 1e-12 * two.abs();
    assert_eq!(whole.full.mode(), metre.full.mode());
    assert!(near(whole.stability.sliding, metre.stability.sliding));
    assert!(near(whole.stability.overturning(), metre.stability.overturning()));
    assert!(near(whole.actions.force, length * metre.actions.force));
    let [Departure::At { factor: one, .. }, Departure::At { factor: two, .. }] =
        [&metre.departure, &whole.departure]
    else {
        panic!("{:?} {:?}", metre.departure, whole.departure)
    };
    assert!(near(*one, *two));
    let [Bearing::Pressed { heel: a, toe: b, .. }, Bearing::Pressed { heel: c, toe: d, .. }] =
        [metre.stability.bearing, whole.stability.bearing]
    else {
        panic!()
    };
    assert!(near(a, c) && near(b, d), "{a} {c} {b} {d}");
}

/// A drum of concrete in still water, by hand: its weight, its buoyancy, and the pressure under its edges.
#[test]
fn a_cylinder_by_hand() {
    use std::f64::consts::PI;
    let (diameter, height, density) = (2.0, 3.0, 2400.0);
    let mass = density * PI * height;
    let drum = Body::cylinder(diameter, height, mass).unwrap();
    assert!(!drum.is_uniform());
    let water = StillWater::new(&drum, 1.0, 1.0, 1000.0).unwrap();
    let situation = Situation::new(drum, 0.6, 10.0).unwrap();
    let push = Load::force(BodyPoint { x: 0.0, y: 1.5 }, -10e3, 0.0);
    let situation =
        water.loads(&drum, 10.0).into_iter().chain([weight(), push]).fold(situation, Situation::with);
    let outcome = situation.outcome().unwrap();
    let pressing = 62e3 * PI;
    assert!((outcome.full.wrench.p - pressing).abs() < 1e-6);
    // W/A ± M/S with S = π D³/32 = π/4.
    let Bearing::Pressed { heel, toe, contact, share } = outcome.stability.bearing else { panic!() };
    assert!(
        (heel - (62e3 + 60e3 / PI)).abs() < 1e-6 && (toe - (62e3 - 60e3 / PI)).abs() < 1e-6,
        "{heel} {toe}"
    );
    assert_eq!((contact, share), (2.0, 1.0));
}

/// A ledge and a nose of one size, under water: their forces cancel, their moments do not.
#[test]
fn a_ledge_and_a_nose_do_not_cancel() {
    // Set back by 1 m over 3 m, then overhanging by 1 m over 3 m, and upright on the other side.
    let section = Section::new(vec![
        rectangle([0.0, 9.0], [0.0, 2.0], 2400.0),
        rectangle([1.0, 9.0], [2.0, 5.0], 2400.0),
        rectangle([-1.0, 9.0], [5.0, 8.0], 2400.0),
    ])
    .unwrap();
    let body = section.body(None, 1.0).unwrap();
    let water = StillWater::new(&body, 8.0, 8.0, 1000.0).unwrap();
    let loads = section.water_on_sides(&body, &water, 10.0);
    let wrenches: Vec<_> = loads.iter().map(|load| load.wrench(&body, 10.0, Pose::UPRIGHT)).collect();
    // 3 m² at 0.5 m to either side of O, 30 kN each: a couple of 30 kN m that turns clockwise.
    assert_eq!(loads.len(), 2);
    let sum: Wrench = wrenches.into_iter().sum();
    assert!(sum.p.abs() < 1e-6 && (sum.m + 30e3).abs() < 1e-6, "{sum:?}");
}

#[test]
fn parts_as_flat_as_rounding_are_no_section() {
    let flat = |left: f64| rectangle([left, left + 1.0], [0.0, 1e-3], 1.0);
    assert_eq!(Section::new(vec![flat(0.0), flat(1e7)]).map(|_| ()), Err(SectionError::NoArea));
    assert!(Section::new(Vec::new()).is_err());
}
