//! Rest on a footprint: against rational arithmetic, against another criterion, against the plane problem.

mod common;

use common::{Random, tries};
use dashu_ratio::Relaxed as Rational;
use standfast::footprint::{BaseWrench, Footprint, PlanDeparture, PlanLimit, degrees, towards};
use standfast::loads::{Across, Action, BodyPoint, Load, LoadKind, LoadSource};
use standfast::{Ball, Body, Departure, Mode, PlanBase, Scalar, Situation};

fn close(one: f64, other: f64, share: f64) {
    assert!((one - other).abs() <= share * other.abs(), "{one} and {other}");
}

fn square() -> Footprint {
    Footprint::polygon(&[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]).unwrap()
}

fn pushed(footprint: &Footprint, friction: f64, towards: [f64; 2], height: f64) -> PlanDeparture {
    footprint.departure(friction, &BaseWrench::pressing(1.0), &BaseWrench::force(towards, height)).unwrap()
}

/// The numbers that the theory page works out.
#[test]
fn a_square_and_a_disc_by_hand() {
    let across = pushed(&square(), 0.7, towards(180.0), 3.0);
    assert_eq!((across.load_factor, across.limits), (1.0 / 3.0, vec![PlanLimit::Tips { edge: 1 }]));
    let towards_vertex = pushed(&square(), 0.7, towards(135.0), 3.0);
    close(towards_vertex.load_factor, 2f64.sqrt() / 3.0, 1e-15);
    assert_eq!(towards_vertex.limits, [PlanLimit::Tips { edge: 1 }, PlanLimit::Tips { edge: 2 }]);
    // Less friction, and it slides that way instead.
    let slides = pushed(&square(), 0.4, towards(135.0), 3.0);
    assert_eq!(slides.limits, [PlanLimit::Slides]);
    close(slides.load_factor, 0.4, 1e-15);
    close(slides.wrench.unwrap().direction_deg().unwrap(), 135.0, 1e-15);

    let disc = Footprint::circle([0.0, 0.0], 1.0).unwrap();
    let turned =
        |share: f64| BaseWrench { x: 0.3 * share, q_x: 0.3 * share, t: 0.2 * share, ..BaseWrench::zero() };
    // 0.09 + 0.04/0.91 of 0.25.
    let rests = disc.departure(0.5, &BaseWrench::pressing(1.0), &turned(1.0)).unwrap();
    assert!(rests.rests && rests.limits == [PlanLimit::Turns], "{rests:?}");
    let at_its_end = turned(rests.load_factor);
    let used = at_its_end.x.powi(2) + at_its_end.t.powi(2) / (1.0 - at_its_end.q_x.powi(2));
    close(used, 0.25, 1e-12);
    // Without a moment it slides at μ, or tips at the rim.
    let slides =
        disc.departure(0.5, &BaseWrench::pressing(1.0), &BaseWrench::force([0.0, -1.0], 1.5)).unwrap();
    assert_eq!((slides.load_factor, slides.limits), (0.5, vec![PlanLimit::Slides]));
    let tips = disc.departure(0.5, &BaseWrench::pressing(1.0), &BaseWrench::force([0.0, -1.0], 4.0)).unwrap();
    assert_eq!((tips.load_factor, tips.limits), (0.25, vec![PlanLimit::Tips { edge: 0 }]));
}

#[test]
fn angles_go_from_left_over_away_to_right() {
    for (angle, place) in [
        (0.0, [-1.0, 0.0]),
        (90.0, [0.0, 1.0]),
        (180.0, [1.0, 0.0]),
        (270.0, [0.0, -1.0]),
        (-90.0, [0.0, -1.0]),
    ] {
        assert_eq!(towards(angle), place, "{angle}");
        assert_eq!(degrees(place), angle.rem_euclid(360.0));
    }
    for i in 0..720 {
        let angle = f64::from(i) / 2.0;
        close(degrees(towards(angle)), angle, 1e-13);
        let turned = BaseWrench::force(towards(20.0), 2.0).turned(angle);
        let expected = (angle + 20.0).rem_euclid(360.0);
        assert!((turned.direction_deg().unwrap() - expected).abs() < 1e-11, "{angle}");
        close(turned.q_x.hypot(turned.q_z), 2.0, 1e-14);
    }
}

/// k(φ) = min(μ, R(φ)/d), and the worst direction is across the nearest edge.
#[test]
fn the_load_factor_of_a_direction_has_a_closed_form() {
    let mut random = Random(1);
    for _ in 0..300 {
        let points: Vec<[f64; 2]> = (0..3 + (random.uniform(0.0, 1.0) * 5.0) as usize)
            .map(|_| [random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)])
            .collect();
        let Ok(footprint) = Footprint::polygon(&points) else { continue };
        let least = footprint.distances().into_iter().fold(f64::INFINITY, f64::min);
        let (friction, height) = (random.uniform(0.05, 1.0), random.uniform(0.2, 3.0));
        if least < 0.0 {
            assert!(pushed(&footprint, friction, towards(0.0), height).at_once);
            continue;
        }
        let mut worst = f64::INFINITY;
        for i in 0..360 {
            let direction = towards(f64::from(i));
            let expected = friction.min(footprint.reach(direction) / height);
            let found = pushed(&footprint, friction, direction, height).load_factor;
            close(found, expected, 1e-12);
            worst = worst.min(found);
        }
        let across = footprint.normals().into_iter();
        let across = across.map(|normal| pushed(&footprint, friction, normal, height).load_factor);
        let across = across.fold(f64::INFINITY, f64::min);
        close(across, friction.min(least / height), 1e-12);
        assert!(across <= worst * (1.0 + 1e-12) && worst < across * 1.001, "{worst} {across}");
    }
}

fn rational(x: f64) -> Rational {
    Rational::try_from(x).unwrap()
}

/// Rest in rational arithmetic, by another way: c is a mean of three vertices, or on the disc, and |X|² ≤ μ² P².
fn rests_exactly(points: &[[f64; 2]], friction: f64, wrench: &[Rational; 5]) -> bool {
    let zero = rational(0.0);
    let [x, z, p, q_x, q_z] = wrench;
    let grip = rational(friction) * p;
    if *p <= zero {
        return false;
    }
    let points: Vec<[Rational; 2]> = points.iter().map(|point| point.map(rational)).collect();
    let cross = |a: &[Rational; 2], b: &[Rational; 2], c: &[Rational; 2]| {
        (&b[0] - &a[0]) * (&c[1] - &a[1]) - (&b[1] - &a[1]) * (&c[0] - &a[0])
    };
    let at = [q_x / p, q_z / p];
    let mut inside = false;
    for i in 0..points.len() {
        for j in 0..i {
            for k in 0..j {
                let [a, b, c] = [&points[i], &points[j], &points[k]];
                let signs = [cross(a, b, &at), cross(b, c, &at), cross(c, a, &at)];
                let flat = cross(a, b, c) == zero;
                inside |= !flat
                    && (signs.iter().all(|sign| *sign >= zero) || signs.iter().all(|sign| *sign <= zero));
            }
        }
    }
    inside && x * x + z * z <= &grip * &grip
}

/// Signs on both sides of boundaries and on them: numbers with few bits, so that sums and products meet edges and circles of friction without
/// rounding, and their neighbours.
#[test]
fn signs_are_those_of_rational_arithmetic() {
    let mut random = Random(2);
    let few = |random: &mut Random, size: f64| (random.uniform(-size, size) * 8.0).round() / 8.0;
    let (mut resting, mut moving, mut told_apart) = (0, 0, 0);
    let tries = tries(100_000);
    for _ in 0..tries {
        let count = 3 + (random.uniform(0.0, 1.0) * 4.0) as usize;
        let points: Vec<[f64; 2]> =
            (0..count).map(|_| [few(&mut random, 1.5), few(&mut random, 1.5)]).collect();
        let Ok(footprint) = Footprint::polygon(&points) else { continue };
        let height = few(&mut random, 2.0).abs() + 0.125;
        // Pythagorean forces, on the circle of friction for some k.
        let [right, away] = [[3.0, 4.0], [-5.0, 12.0], [1.0, 0.0], [0.0, -1.0], [-8.0, -15.0]]
            [(random.uniform(0.0, 1.0) * 5.0) as usize];
        let size = [5.0, 13.0, 1.0, 1.0, 17.0]
            .into_iter()
            .find(|size: &f64| (size * size - right * right - away * away).abs() < 0.5)
            .unwrap();
        let share = [0.5, 0.25, 0.75][(random.uniform(0.0, 1.0) * 3.0) as usize];
        let mut friction = share;
        let mut k = share / size;
        // To an edge, where it is met before, or a hair beside.
        let edge = footprint.reach([right / size, away / size]) / height / size;
        if edge > 0.0 && random.uniform(0.0, 1.0) < 0.7 {
            (k, friction) = (edge, 2.0);
        }
        match (random.uniform(0.0, 1.0) * 3.0) as u32 {
            0 => k = k.next_up(),
            1 => k = k.next_down(),
            _ => {}
        }
        let (x, z) = (k * right, k * away);
        // Q = d X in f64 would turn the body about c by a rounding; a power of two does not.
        let height = if height > 0.6 { 1.0 } else { 0.5 };
        let (x, z) = if friction == 2.0 { (x * 1.5, z * 1.5) } else { (x, z) };
        let wrench = BaseWrench::force([x, z], height);
        let found = footprint.departure(friction, &BaseWrench::pressing(1.0), &wrench).unwrap();
        let exact = [x, z, 1.0, wrench.q_x, wrench.q_z].map(rational);
        let expected = rests_exactly(&points, friction, &exact);
        assert_eq!(found.rests, expected, "{points:?} {friction} {wrench:?} {found:?}");
        // Some weigh beside their base, and the push alone holds them.
        let alone = [0.0, 0.0, 1.0, 0.0, 0.0].map(rational);
        assert_eq!(found.at_once, !rests_exactly(&points, friction, &alone), "{points:?}");
        assert!(found.at_once || found.rests == (found.load_factor >= 1.0), "{found:?}");
        if expected {
            resting += 1
        } else {
            moving += 1
        }
        told_apart += u32::from((found.load_factor - 1.0).abs() < 1e-12);
    }
    assert!(
        resting > tries / 8 && moving > tries / 8 && told_apart > tries / 8,
        "{resting} {moving} {told_apart}"
    );
}

/// Bodies under loads in the plane of their section: the departure is that of the plane problem.
#[test]
fn in_its_plane_a_rectangle_is_the_plane_problem() {
    let mut random = Random(3);
    let (mut slides, mut tips) = (0, 0);
    for _ in 0..2000 {
        let (width, height) = (random.uniform(0.4, 2.0), random.uniform(0.4, 3.0));
        let (friction, mass) = (random.uniform(0.1, 1.2), random.uniform(500.0, 2000.0));
        let body = Body::new(width, height, mass).unwrap();
        let steady = Action::Force {
            at: BodyPoint { x: random.uniform(-0.5, 0.5) * width, y: height },
            right: random.uniform(-0.1, 0.1) * mass,
            up: random.uniform(-2.0, 2.0) * mass,
        };
        let (force, at) = (random.uniform(-3e4, 3e4), random.uniform(0.0, height));
        let load = |action| Load::variable(LoadSource::Force, LoadKind::Horizontal, action);
        let permanent = Load::permanent(LoadSource::Force, LoadKind::Horizontal, steady.clone());
        let situation = Situation::new(body, friction, 9.81).unwrap().with_weight();
        let situation = situation.with(permanent).with(load(Action::horizontal(force, at)));
        let plane = situation.outcome().unwrap().departure;
        let Action::Force { at: place, right, up } = steady else { unreachable!() };
        let steady = BaseWrench::force_at([right, 0.0], -up, [place.x, place.y, 0.0]);
        let base = [[-width / 2.0, -0.7], [width / 2.0, -0.7], [width / 2.0, 0.7], [-width / 2.0, 0.7]];
        let footprint = Footprint::polygon(&base).unwrap();
        let weight = BaseWrench::pressing(mass * 9.81).plus(steady);
        let found = footprint.departure(friction, &weight, &BaseWrench::force([force, 0.0], at)).unwrap();
        if matches!(plane, Departure::AtOnce { permanent: true, .. }) {
            assert!(found.at_once, "{plane:?} {found:?}");
            continue;
        }
        close(found.load_factor, plane.load_factor(), 1e-11);
        match plane.mode() {
            Some(Mode::SlideLeft | Mode::SlideRight) => {
                slides += 1;
                assert_eq!(found.limits, [PlanLimit::Slides]);
                let direction = found.wrench.unwrap().direction_deg().unwrap();
                assert_eq!(direction, if plane.mode() == Some(Mode::SlideLeft) { 0.0 } else { 180.0 });
            }
            Some(Mode::RockO | Mode::RockOPrime) => {
                tips += 1;
                let edge = if plane.mode() == Some(Mode::RockO) { 3 } else { 1 };
                assert_eq!(found.limits, [PlanLimit::Tips { edge }]);
            }
            other => panic!("{other:?} {found:?}"),
        }
    }
    assert!(slides > 300 && tips > 300, "{slides} {tips}");
}

/// Case and load turned or mirrored together change no answer.
#[test]
fn no_frame_is_another() {
    let mut random = Random(4);
    for _ in 0..2000 {
        let points: Vec<[f64; 2]> =
            (0..5).map(|_| [random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)]).collect();
        let (centre, radius) =
            ([random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3)], random.uniform(0.4, 1.0));
        let friction = random.uniform(0.1, 1.0);
        let (across, along) = (random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
        let (height, down) = (random.uniform(0.2, 2.0), random.uniform(-0.5, 0.5));
        let angle = random.uniform(0.0, 360.0);
        let (sin, cos) = angle.to_radians().sin_cos();
        let turn = |[x, z]: [f64; 2]| [x * cos + z * sin, z * cos - x * sin];
        let mirror = |[x, z]: [f64; 2]| [-x, z];
        let leaves = |of: &dyn Fn([f64; 2]) -> [f64; 2], is_disc: bool| {
            let points: Vec<[f64; 2]> = points.iter().copied().map(of).collect();
            let footprint = match is_disc {
                true => Footprint::circle(of(centre), radius),
                false => Footprint::polygon(&points),
            };
            let variable = BaseWrench { p: down, ..BaseWrench::force(of([across, along]), height) };
            footprint.unwrap().departure(friction, &BaseWrench::pressing(1.0), &variable).unwrap()
        };
        for is_disc in [false, true] {
            let [one, turned, mirrored] = [&|point| point, &turn as &dyn Fn([f64; 2]) -> [f64; 2], &mirror]
                .map(|of| leaves(of, is_disc));
            assert_eq!([one.at_once; 2], [turned.at_once, mirrored.at_once]);
            if one.load_factor.is_finite() && !one.at_once {
                close(turned.load_factor, one.load_factor, 1e-9);
                close(mirrored.load_factor, one.load_factor, 1e-12);
            }
            let slides = |one: &PlanDeparture| one.limits.contains(&PlanLimit::Slides);
            assert_eq!([slides(&one); 2], [slides(&turned), slides(&mirrored)]);
        }
    }
}

/// A disc bears less than the 240-gon around it, and more than the one in it.
#[test]
fn a_disc_is_between_its_polygons() {
    let mut random = Random(5);
    for _ in 0..500 {
        let (centre, radius) =
            ([random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)], random.uniform(0.8, 2.0));
        let gon = |radius: f64| {
            let corner = |i: u32| {
                let [x, z] = towards(f64::from(i) * 1.5);
                [centre[0] + radius * x, centre[1] + radius * z]
            };
            Footprint::polygon(&(0..240).map(corner).collect::<Vec<_>>()).unwrap()
        };
        let (height, friction) = (random.uniform(0.2, 4.0), random.uniform(0.2, 1.0));
        let variable = BaseWrench {
            p: random.uniform(-0.3, 0.3),
            ..BaseWrench::force(towards(random.uniform(0.0, 360.0)), height)
        };
        let leaves = |footprint: &Footprint| {
            footprint.departure(friction, &BaseWrench::pressing(1.0), &variable).unwrap().load_factor
        };
        let disc = leaves(&Footprint::circle(centre, radius).unwrap());
        let [inside, outside] =
            [radius, radius / (std::f64::consts::PI / 240.0).cos()].map(|r| leaves(&gon(r)));
        assert!(
            inside <= disc * (1.0 + 1e-12) && disc <= outside * (1.0 + 1e-12),
            "{inside} {disc} {outside}"
        );
        assert!(outside <= inside * 1.001, "{inside} {outside}");
    }
}

/// A disc under a moment about its centre of pressure, by the criterion of every centre q of a turn: |T − q × X| ≤ μ P E_q(c), where E_q is the
/// greatest mean distance from q of pressures on the disc whose centre is c, here of pairs of points on its rim.
#[test]
fn a_disc_that_turns_bears_what_every_centre_of_a_turn_allows() {
    let mut random = Random(6);
    let (mut resting, mut moving) = (0, 0);
    for _ in 0..tries(120) {
        let disc = Footprint::circle([0.0, 0.0], 1.0).unwrap();
        let friction = random.uniform(0.2, 0.8);
        let wrench = BaseWrench {
            x: random.uniform(-0.5, 0.5),
            z: random.uniform(-0.5, 0.5),
            p: 1.0,
            q_x: random.uniform(-0.6, 0.6),
            q_z: random.uniform(-0.6, 0.6),
            t: random.uniform(-0.5, 0.5),
        };
        // Of pairs: a chord through c in any direction, its ends weighed so that c is their mean.
        let most = |q: [f64; 2]| {
            let chord = |i: u32| {
                let [u, w] = towards(f64::from(i));
                let along = wrench.q_x * u + wrench.q_z * w;
                let half = (along * along + 1.0 - wrench.q_x.powi(2) - wrench.q_z.powi(2)).sqrt();
                let [ahead, behind] = [half - along, half + along];
                let distance = |step: f64| (wrench.q_x + step * u - q[0]).hypot(wrench.q_z + step * w - q[1]);
                (behind * distance(ahead) + ahead * distance(-behind)) / (ahead + behind)
            };
            (0..90).map(|i| chord(2 * i)).fold(0.0, f64::max)
        };
        let left = |q: [f64; 2]| friction * most(q) - (wrench.t - (q[0] * wrench.z - q[1] * wrench.x)).abs();
        // A convex function but for the absolute value: a compass search from several places.
        let mut least = f64::INFINITY;
        for start in [[0.0, 0.0], [3.0, 0.0], [-3.0, 3.0]] {
            let (mut q, mut value, mut step) = (start, left(start), 2.0);
            // Not without end: beyond, it is a slide, which is asked for below.
            for _ in 0..200 {
                let next = [[step, 0.0], [-step, 0.0], [0.0, step], [0.0, -step]]
                    .map(|[x, z]| [q[0] + x, q[1] + z])
                    .into_iter()
                    .map(|place| (left(place), place))
                    .min_by(|one, two| one.0.total_cmp(&two.0))
                    .unwrap();
                if next.0 < value { (value, q) = next } else { step /= 2.0 }
            }
            least = least.min(value);
        }
        let least = least.min(friction - wrench.horizontal());
        if least.abs() < 1e-3 {
            continue;
        }
        let found = disc.departure(friction, &BaseWrench::zero(), &wrench).unwrap();
        assert_eq!(found.rests, least > 0.0, "{wrench:?} {friction}: {least}");
        if found.rests { resting += 1 } else { moving += 1 }
    }
    assert!(resting > 0 && moving > 0, "{resting} {moving}");
}

#[test]
fn the_hull_counts_and_what_is_no_base_is_refused() {
    let feet = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.3], [1.0, 1.0], [0.5, 0.0], [0.0, 1.0], [0.0, 0.0]];
    let hull = Footprint::polygon(&feet).unwrap();
    assert_eq!(hull.given(), [0, 1, 3, 5]);
    // As given, but turned: from the first, counter-clockwise.
    let turned = Footprint::polygon(&[[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]]).unwrap();
    assert_eq!(turned.given(), [0, 3, 2, 1]);
    // Tenths on a line that f64 does not have on one, and on one that it has.
    for line in [
        &[[0.0, 0.0], [0.1, 0.1], [0.3, 0.3], [0.7, 0.7]][..],
        &[[1.0, 2.0], [1.0, 2.0], [3.0, 4.0]],
        &[[1.0, 1.0]],
    ] {
        assert!(Footprint::polygon(line).is_err(), "{line:?}");
    }
    assert!(Footprint::polygon(&[[0.0, f64::NAN], [1.0, 0.0], [0.0, 1.0]]).is_err());
    assert!(Footprint::circle([0.0, 0.0], 0.0).is_err());
    let off_centre = BaseWrench::force_at([1.0, 0.0], 0.0, [0.0, 1.0, 0.2]);
    let error = square().departure(0.5, &BaseWrench::pressing(10.0), &off_centre).unwrap_err();
    close(error.moment, -0.2, 1e-12);
}

/// Nothing that acts, nothing that presses, and what lifts.
#[test]
fn a_base_without_a_load_rests_and_one_that_is_lifted_lifts() {
    let weight = BaseWrench::pressing(2.0);
    let never = square().departure(0.5, &weight, &BaseWrench::zero()).unwrap();
    assert_eq!((never.load_factor, never.rests, never.wrench), (f64::INFINITY, true, None));
    let lifted = square().departure(0.5, &weight, &BaseWrench::pressing(-1.0)).unwrap();
    assert_eq!((lifted.load_factor, lifted.limits), (2.0, vec![PlanLimit::Lifts]));
    let disc = Footprint::circle([0.0, 0.0], 1.0).unwrap();
    assert_eq!(disc.departure(0.5, &weight, &BaseWrench::pressing(-1.0)).unwrap().limits, [PlanLimit::Lifts]);
    let smooth = square().departure(0.0, &weight, &BaseWrench::force([1.0, 0.0], 0.5)).unwrap();
    assert_eq!((smooth.load_factor, smooth.at_once, smooth.limits), (0.0, false, vec![PlanLimit::Slides]));
    // Pressed as much as pushed, it never slides.
    let pressed = BaseWrench { p: 2.0, ..BaseWrench::force([1.0, 0.0], 0.5) };
    assert_eq!(square().departure(0.5, &weight, &pressed).unwrap().load_factor, f64::INFINITY);
}

/// A body under loads in its section and out of it, and on a plan that lies beside its middle: the sums are those by hand.
#[test]
fn a_situation_carries_its_loads_over_to_its_plan() {
    // 1 m by 2 m by 1.4 m, C 0.9 m above the base, 0.1 m to the right and 0.2 m away.
    let body = Body::new(1.0, 2.0, 700.0).unwrap().with_length(1.4).unwrap().with_centroid(0.1, 0.9).unwrap();
    let weight = 700.0 * 10.0;
    let corners = [[-0.6, -0.9], [0.4, -0.9], [0.4, 0.5], [-0.6, 0.5]];
    let plan = PlanBase { footprint: Footprint::polygon(&corners).unwrap(), centroid_z: 0.2 };
    let bare = || Situation::new(body, 0.3, 10.0).unwrap().with_weight().with_plan(plan.clone());
    let quake = |right: f64, away: f64| {
        let inertia = Action::Inertia { right, up: 0.0 };
        let load = Load::variable(LoadSource::HorizontalInertia, LoadKind::Horizontal, inertia);
        load.across(Across { away, z: None })
    };
    let answer = |load: Load| bare().with(load).outcome().unwrap().plan.unwrap();
    // Shaken away and to the left: pushed towards the viewer and to the right.
    let both = answer(quake(-1.5, 2.0));
    assert_eq!((both.full.x, both.full.z, both.full.p), (1050.0, -1400.0, weight));
    close(both.full.q_x, 0.9 * 1050.0, 1e-12);
    close(both.full.q_z, -0.9 * 1400.0, 1e-12);
    assert_eq!(both.full.t, 0.0);
    assert_eq!(both.departure.limits, [PlanLimit::Slides]);
    close(both.departure.load_factor, 0.3 * weight / 1750.0, 1e-12);
    close(both.departure.wrench.unwrap().direction_deg().unwrap(), 180.0 + 53.13010235415598, 1e-12);
    // A push at the top that meets the vertical through C, and one at a corner of the body, which turns it.
    let push = |x: f64, y: f64, z: f64, right: f64, away: f64| {
        let at = BodyPoint { x, y };
        let load = Load { kind: LoadKind::Horizontal, ..Load::force(at, right, 0.0) };
        load.across(Across { away, z: Some(z) })
    };
    let pushed = answer(push(0.1, 1.8, 0.2, 0.0, 500.0));
    assert_eq!((pushed.full.q_z, pushed.full.t, pushed.edge), (900.0, 0.0, Some(2)));
    let outcome = bare().with(push(0.1, 1.8, 0.2, 0.0, 500.0)).outcome().unwrap();
    close(outcome.stability.overturning(), 0.5 * weight / 900.0, 1e-12);
    // What begins in space is not told as if it began in the plane.
    let pushed = bare().with(push(0.1, 1.8, 0.2, 5e4, 0.0));
    assert_eq!(
        (pushed.at(1.0).unwrap().verdict, pushed.path().unwrap(), pushed.plane(2.0).unwrap()),
        (None, vec![], vec![])
    );
    close(outcome.stability.sliding, 0.3 * weight / 500.0, 1e-12);
    close(outcome.margins.overturning_about_heel, 0.5 * weight - 900.0, 1e-12);
    let corner = bare().with(push(-0.5, 1.8, 0.7, 100.0, 50.0));
    // (x_F − x_C) F_z − (z_F − z_C) F_x.
    close(corner.torsion().unwrap().moment, -0.6 * 50.0 - 0.5 * 100.0, 1e-9);
    assert!(corner.outcome().is_err());
    // On a disc it has an answer, and its factor against sliding is 1 where it rests no more.
    let disc = PlanBase { footprint: Footprint::circle([-0.1, -0.2], 0.5).unwrap(), centroid_z: 0.2 };
    let turned = |factor: f64| {
        let load = push(-0.5, 0.4, 0.7, 1000.0 * factor, 500.0 * factor);
        Situation::new(body, 0.3, 10.0)
            .unwrap()
            .with_weight()
            .with(load)
            .with_plan(disc.clone())
            .outcome()
            .unwrap()
    };
    let limit = turned(1.0).departure.load_factor();
    assert!(limit > 0.5, "{limit}");
    close(turned(limit).stability.sliding, 1.0, 1e-9);
    // A vertical load beside C moves the centre of pressure, and a factor multiplies all of a load.
    let down =
        Load::force(BodyPoint { x: 0.3, y: 2.0 }, 0.0, -300.0).across(Across { away: 0.0, z: Some(-0.5) });
    let beside = answer(down.times(2.0));
    close(beside.full.q_x, 600.0 * 0.2, 1e-12);
    close(beside.full.q_z, -600.0 * 0.7, 1e-12);
}

/// Where f64 rounds a body off its boundary, the numbers as they are written put it there.
#[test]
fn written_numbers_decide_on_a_plan() {
    fn situation<T: Scalar>(shaken: f64) -> Situation<T> {
        let of = |x: f64| T::written(x);
        let body = Body::new(of(0.6), of(2.0), of(700.0)).unwrap().with_length(of(0.8)).unwrap();
        let corner = |x: f64, z: f64| [of(x), of(z)];
        let corners = [corner(-0.3, -0.4), corner(0.3, -0.4), corner(0.3, 0.4), corner(-0.3, 0.4)];
        let footprint = Footprint::polygon(&corners).unwrap();
        let inertia = Action::Inertia { right: of(0.0), up: of(0.0) };
        let load = Load::variable(LoadSource::HorizontalInertia, LoadKind::Horizontal, inertia);
        let load = load.across(Across { away: of(shaken), z: None });
        let situation = Situation::new(body, of(0.7), of(9.81)).unwrap().with_weight().with(load);
        situation.with_plan(PlanBase { footprint, centroid_z: of(0.0) })
    }
    // d = 1 and h = 0.4: it tips at 0.4 g, which is 3.924 m/s².
    for (shaken, rests) in
        [(3.924, true), (-3.924, true), (3.924000000000001, false), (3.9239999999999995, true)]
    {
        let rounded = situation::<f64>(shaken);
        assert!(rounded.is_near_boundary());
        let outcome = rounded.as_written(&situation::<Ball>(shaken)).outcome().unwrap();
        let plan = outcome.plan.unwrap();
        assert_eq!(plan.departure.rests, rests, "{shaken}");
        assert_eq!(outcome.stability.overturning() >= 1.0, rests, "{shaken}");
        let is_one = shaken.abs() == 3.924;
        assert_eq!(plan.departure.load_factor == 1.0, is_one, "{shaken}: {}", plan.departure.load_factor);
    }
    assert!(!situation::<f64>(1.0).is_near_boundary());
}
