//! A tilted floor: the same as the forces along and across it, typed by hand.

mod common;

use common::{assess, near, number, refused, six};
use standfast_cases::couple::Variable;
use standfast_cases::results::ResultName;
use standfast_cases::{Assessment, Key};

const STELE: &str = "[body]\nwidth = 1\nheight = 3\nmass = 1000\nfriction = 0.5\n";

fn on_floor(body: &str, degrees: f64, loads: &str) -> Assessment {
    assess(&format!("{}{loads}", body.replace("friction", &format!("floor_deg = {degrees}\nfriction"))))
}

/// Spec 10, 4.4: a level force of 0.15 m g at mid-crest, on 6°.
#[test]
fn the_worked_body() {
    let push = format!("[[load]]\nforce = {}\nelevation = 3\n", 0.15 * 9810.0);
    let assessment = on_floor(STELE, 6.0, &push);
    let assessed = assessment.governing();
    let wrench = assessed.outcome.full.wrench;
    six(wrench.x / 9810.0, -0.253_707);
    six(wrench.p / 9810.0, 0.978_843);
    six(number(assessed, ResultName::KEff), 0.259_191);
    six(number(assessed, ResultName::KPrimeEff), 0.587_995);
}

/// Under its weight alone a body slides for tan ε > μ and tips for tan ε > b/h.
#[test]
fn its_weight_alone_moves_it() {
    // A force too small to matter: a case needs a load.
    let none = "[[load]]\nforce = 1e-9\nelevation = 1\n";
    let mode = |friction: &str, degrees: f64| {
        let body = STELE.replace("0.5", friction);
        on_floor(&body, degrees, none).governing().outcome.full.mode().unwrap().symbol()
    };
    let [slides, tips] = [0.3f64.atan(), (1.0f64 / 3.0).atan()].map(f64::to_degrees);
    assert_eq!([mode("0.3", slides - 1e-6), mode("0.3", slides + 1e-6)], ["RE", "SL"]);
    assert_eq!([mode("0.5", tips - 1e-6), mode("0.5", tips + 1e-6)], ["RE", "RO"]);
    // The other way it falls to the other side.
    assert_eq!([mode("0.3", -slides - 1e-6), mode("0.5", -tips - 1e-6)], ["SL+", "RO'"]);
}

/// Typed by hand: the components along and across the floor of forces at the same places, and of an earthquake.
#[test]
fn forces_along_and_across_it_are_the_same() {
    let degrees = 8.0f64;
    let (sin, cos) = degrees.to_radians().sin_cos();
    let weight = 1000.0 * 9.81;
    let loads = "[[load]]\nname = \"push\"\nforce = 900\nelevation = 2.4\ntogether = true\n[[load]]\nname = \"hook\"\nforce = 700\n\
                 direction = \"up\"\nelevation = 3\ndistance = 0.8\ntogether = true\n[earthquake]\nhorizontal = \"0.05 g\"\nhorizontal_fixed = true\n\
                 [[moment]]\nmoment = 150\ntogether = true\n";
    let tilted = on_floor(STELE, degrees, loads);
    // The weight is a horizontal force and a lighter body; the horizontal inertia likewise.
    let (along, across) = (0.05 * weight * cos + weight * sin, 0.05 * weight * sin);
    let force = |right: f64, up: f64, x: f64, y: f64| {
        let one = |size: f64, way: [&str; 2]| {
            format!(
                "[[load]]\nforce = {:?}\ndirection = \"{}\"\nelevation = {y}\ndistance = {x}\npermanent = true\n",
                size.abs(),
                way[usize::from(size < 0.0)]
            )
        };
        one(up, ["up", "down"]) + &one(right, ["right", "left"]).replace(&format!("distance = {x}\n"), "")
    };
    let by_hand = force(-900.0 * cos, 900.0 * sin, 0.5, 2.4)
        + &force(700.0 * sin, 700.0 * cos, 0.8, 3.0)
        + &force(-along, 0.0, 0.5, 1.5).replace("force = 0.0", "force = 1e-12")
        + &force(0.0, across, 0.5, 1.5).replace("force = 0.0", "force = 1e-12")
        + &format!(
            "[[moment]]\nmoment = 150\npermanent = true\n[[load]]\nforce = {:?}\ndirection = \"up\"\nelevation = 1.5\ndistance = 0.5\npermanent = true\n",
            weight * (1.0 - cos)
        );
    let level = assess(&format!("{STELE}{by_hand}"));
    let [one, other] = [&tilted, &level].map(|assessment| assessment.governing().outcome.full.wrench);
    near(one.x, other.x, 1e-9 * weight);
    near(one.p, other.p, 1e-9 * weight);
    near(one.m, other.m, 1e-9 * weight);
    let [one, other] = [&tilted, &level].map(|assessment| assessment.governing().outcome.full.mode());
    assert_eq!(one, other);
}

/// A pressure stays normal to its face.
#[test]
fn pressures_press_on_their_faces() {
    let pressure =
        "[[pressure]]\nface = \"right\"\nelevation = [0, 3]\npressure = [1e3, 1e3]\npermanent = true\n";
    let none = "[[load]]\nforce = 1e-9\nelevation = 1\n";
    let wrench = |degrees: f64, more: &str| {
        on_floor(STELE, degrees, &format!("{more}{none}")).governing().outcome.full.wrench
    };
    let pressed = wrench(7.0, pressure).x - wrench(7.0, "").x;
    near(pressed, -3e3, 1e-6);
}

#[test]
fn what_is_not_worked_out_for_it_is_refused() {
    let body = STELE.replace("friction", "floor_deg = 6\nfriction");
    let load = "[[load]]\nforce = 1e3\nelevation = 1\n";
    for (more, what) in [
        ("[water]\nlevel = 1\ndensity = 1000\n", "still water"),
        ("[[resistance]]\nname = \"tie\"\nlimit = 1e3\ndirection = \"right\"\nelevation = 2\n", "a tie"),
        ("[ground]\nfriction_angle_deg = 35\nunit_weight = 1e4\n", "ground that fails"),
        (
            "[[backfill]]\nname = \"s\"\nface = \"right\"\nfriction_angle_deg = 33\nunit_weight = 18e3\n",
            "soil beside the body",
        ),
        ("[motion]\nt_max = 1\n", "the motion in time"),
    ] {
        let error = refused(&format!("{body}{load}{more}"));
        assert!(error.contains("the floor of [body] rises at 6°") && error.contains(what), "{more}: {error}");
    }
    let error = refused(&format!("{}{load}", body.replace("floor_deg = 6", "floor_deg = 60")));
    assert!(error.contains("expected an angle from -45 to 45 degrees"), "{error}");
    // Level, it is refused nothing.
    assess(&format!(
        "{}{load}[water]\nlevel = 1\ndensity = 1000\n",
        body.replace("floor_deg = 6", "floor_deg = 0")
    ));
}

/// The steepest floor on which a body rests, by design.
#[test]
fn a_floor_can_be_varied() {
    let case = on_floor(STELE, 6.0, "[[load]]\nforce = 1\nelevation = 1\n").case;
    assert!(Variable::all(case.inputs()).any(|id| id.key == Key::FloorDeg));
}
