//! Bodies and forces in SI units, reduced to the report's numbers and mirrored.

use standfast::loads::HorizontalForce;
use standfast::{Body, Mode, Slip};

/// A caisson of 15 m by 12 m and 2100 kg/m³ weighs 378 t/m; 1000 kN/m at 9 m above its base.
fn caisson() -> Body {
    Body::of_density(15.0, 12.0, 2100.0).unwrap()
}

#[test]
fn a_body_has_the_geometry_and_inertia_of_a_rectangle() {
    let body = caisson();
    assert_eq!(body.mass(), 378_000.0);
    assert_eq!(body.slenderness(), 0.8);
    // m(B² + H²)/3 with B = 7.5, H = 6
    assert_eq!(body.moment_of_inertia(), 378_000.0 * (56.25 + 36.0) / 3.0);
}

#[test]
fn a_force_reduces_to_k_and_k_prime() {
    let force = HorizontalForce::new(1e6, 9.0, Slip::Left).unwrap();
    let reduced = force.reduce(&caisson(), 0.6, 10.0).unwrap();
    assert_eq!(reduced.point.k(), 1e6 / 3.78e6);
    assert_eq!(reduced.point.k_prime(), 0.5); // 3 m above the centre, of 6
    assert_eq!(reduced.point.mu(), 0.6);
    assert!(!reduced.mirrored);
    let base = HorizontalForce::new(1e6, 0.0, Slip::Left).unwrap().reduce(&caisson(), 0.6, 10.0).unwrap();
    assert_eq!(base.point.k_prime(), -1.0);
}

#[test]
fn a_force_to_the_right_is_the_mirror_image() {
    let body = Body::new(1.0, 3.0, 1000.0).unwrap();
    let modes = [(0.5, 0.05), (4.0, 0.4), (4.0, 0.05), (20.0, 0.02), (0.2, 0.9), (0.2, 0.1)];
    for (factor, friction) in modes {
        for elevation in [0.2, 1.0, 2.8] {
            let force = |direction| HorizontalForce::new(factor * 1e4, elevation, direction).unwrap();
            let left = force(Slip::Left).reduce(&body, friction, 10.0).unwrap();
            let right = force(Slip::Right).reduce(&body, friction, 10.0).unwrap();
            assert!(right.mirrored && left.point == right.point);
            assert_eq!(right.mode(), left.mode().mirrored());
            assert_eq!(right.others(), left.others().mirrored());
            let (here, there) = (left.motion(), right.motion());
            assert_eq!(here.x_ddot, -there.x_ddot);
            assert_eq!(here.theta_ddot, -there.theta_ddot);
            assert_eq!((here.f_x, here.f_y, here.xi), (-there.f_x, there.f_y, -there.xi));
            assert_eq!((here.lift_o, here.lift_o_prime), (there.lift_o_prime, there.lift_o));
        }
    }
}

#[test]
fn a_mirror_image_of_a_mirror_image_is_the_mode_itself() {
    for mode in Mode::ALL {
        assert_eq!(mode.mirrored().mirrored(), mode);
        assert_eq!(Mode::from_code(mode.code()), Some(mode));
    }
    assert_eq!(Mode::from_code(10), None);
}

#[test]
fn impossible_bodies_and_forces_are_refused() {
    let message = |result: Result<Body, standfast::InputError>| result.unwrap_err().to_string();
    assert_eq!(
        message(Body::new(0.0, 12.0, 1.0)),
        "width is 0; expected a number above zero, from 1e-50 to 1e50"
    );
    assert_eq!(
        message(Body::of_density(15.0, 12.0, f64::NAN)),
        "density is NaN; expected a number above zero, from 1e-50 to 1e50"
    );
    let error = HorizontalForce::new(-1.0, 9.0, Slip::Left).unwrap_err();
    assert_eq!(error.to_string(), "force is -1; expected a number from 0 to 1e50");
    let force = HorizontalForce::new(1.0, 9.0, Slip::Left).unwrap();
    assert!(force.reduce(&caisson(), -0.1, 9.81).is_err());
    assert!(force.reduce(&caisson(), 0.6, 0.0).is_err());
}

#[test]
fn a_point_with_a_size_is_the_body_and_force_it_came_from() {
    for (magnitude, elevation, direction) in
        [(1e6, 9.0, Slip::Left), (2.7e6, 0.0, Slip::Right), (0.0, 6.0, Slip::Left), (4e5, -3.0, Slip::Right)]
    {
        let force = HorizontalForce::new(magnitude, elevation, direction).unwrap();
        let reduced = force.reduce(&caisson(), 0.6, 9.81).unwrap();
        let (body, back) = reduced.with_size(15.0, 378_000.0, 9.81).unwrap();
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-12 * b.abs().max(1.0);
        assert!(near(body.height(), 12.0) && body.width() == 15.0 && body.mass() == 378_000.0);
        assert!(near(back.magnitude(), magnitude) && near(back.elevation(), elevation));
        assert_eq!(back.direction(), direction);
    }
    let reduced = HorizontalForce::new(1e6, 9.0, Slip::Left).unwrap().reduce(&caisson(), 0.6, 9.81).unwrap();
    assert!(reduced.with_size(0.0, 1.0, 9.81).is_err() && reduced.with_size(1.0, 1.0, f64::NAN).is_err());
}

/// A body keeps all it is told; its centre of mass lies strictly between its corners.
#[test]
fn a_body_keeps_what_it_is_told() {
    let body = Body::new(10.0, 8.0, 1e5).unwrap();
    assert!(body.is_uniform());
    assert_eq!((body.width(), body.height(), body.mass()), (10.0, 8.0, 1e5));
    assert_eq!((body.centroid_offset(), body.centroid_height(), body.base_width()), (0.0, 4.0, 10.0));
    let turned = body.with_moment_of_inertia(7e5).unwrap();
    assert_eq!((turned.moment_of_inertia(), turned.is_uniform()), (7e5, false));
    let odd = body.with_base(4.0, 5.0).unwrap().with_centroid(0.5, 3.0).unwrap();
    assert_eq!((odd.base_edges().left, odd.base_edges().right), (4.0, 5.0));
    assert_eq!((odd.centroid_offset(), odd.centroid_height()), (0.5, 3.0));
    assert!(!odd.is_uniform() && !body.with_centroid(0.0, 3.9).unwrap().is_uniform());
    for (offset, fits) in [(-5.0, false), (-4.999, true), (4.999, true), (5.0, false)] {
        assert_eq!(body.with_centroid(offset, 4.0).is_ok(), fits, "{offset}");
    }
    for (left, right, fits) in
        [(0.0, 5.0, false), (0.001, 0.001, true), (5.0, 0.0, false), (-1.0, 5.0, false)]
    {
        assert_eq!(body.with_base(left, right).is_ok(), fits, "{left} {right}");
    }
    assert!(body.with_centroid(0.0, 0.0).is_err() && body.with_centroid(f64::NAN, 4.0).is_err());
    assert!(body.with_base(f64::NAN, 5.0).is_err() && body.with_moment_of_inertia(-1.0).is_err());
}
