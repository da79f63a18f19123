//! Accelerations of points of the body: closed forms, and differences of the motion itself.

use standfast_answers::motion::{Follow, FollowedMotion, PointAnswer, SeriesAsked};
use standfast_model::CaseFile;

fn followed(text: &str) -> FollowedMotion {
    let file = CaseFile::parse("case.toml", text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let follow = Follow { series: true, ..Follow::default() };
    FollowedMotion::of_file(&file, &follow).unwrap_or_else(|error| panic!("{error}")).remove(0)
}

const BLOCK: &str = "[block]\nb1 = 1\nb2 = 1\nd = 3\nmu_s = 5\ngravity = 1\n";

fn near(found: f64, expected: f64, off: f64, told: &str) {
    assert!((found - expected).abs() <= off, "{told}: {found}, expected {expected}");
}

/// Every row of a series, by the names of its columns.
fn rows(motion: &FollowedMotion, dt: f64) -> Vec<impl Fn(&str) -> f64> {
    let asked = SeriesAsked { dt, events: false };
    let columns = asked.columns(&motion.case);
    let rows: Vec<_> = asked.rows(&motion.case, &motion.outcome).collect();
    rows.into_iter()
        .map(|row| {
            let columns = columns.clone();
            move |name: &str| {
                let column = columns.iter().find(|column| column.name == name).unwrap();
                column.value(&row).unwrap()
            }
        })
        .collect()
}

/// The corner that a body rocks about stays where it is; at the impact its other one stops.
#[test]
fn the_corner_of_rotation_is_at_rest() {
    let text = format!(
        "{BLOCK}[motion]\nimpact = {{ law = \"housner\" }}\n[motion.initial]\ntheta = 0.2\n\
         [motion.points]\nO = [-1, -3]\n\"O'\" = [1, -3]\n"
    );
    let motion = followed(&text);
    let first = motion.outcome.events.iter().position(|event| event.why.word() == "impact").unwrap();
    let t = motion.outcome.events[first].t;
    let mut seen = 0;
    for row in rows(&motion, 0.01).into_iter().take_while(|row| row("t") < t) {
        let (sin, cos) = row("theta").sin_cos();
        for (name, expected) in [("a_x.O", 0.0), ("a_y.O", 0.0), ("f_along.O", sin), ("f_up.O", cos)] {
            near(row(name), expected, 1e-12, name);
        }
        seen += 1;
    }
    assert!(seen > 100);
    let before = motion.outcome.moment(t, true).unwrap();
    let [of_o, of_other] = [0, 1].map(|place: usize| {
        let PointAnswer { jumps, .. } = &motion.points[place];
        jumps.iter().find(|(event, _)| *event == first).unwrap().1
    });
    // O' comes down with 2bω and stops; O goes up with what is left of the rotation.
    let ratio = (2.0 * 9.0 - 1.0) / (2.0 * 10.0);
    near(of_other[1], -2.0 * before.omega, 1e-12, "O'");
    near(of_o[1], -2.0 * ratio * before.omega, 1e-12, "O");
    near(of_o[0], 0.0, 1e-12, "O, to the side");
}

/// Nothing is felt in a fall; at rest gravity and the base's acceleration; of a body that slides friction.
#[test]
fn what_is_felt_in_a_fall_at_rest_and_in_a_slide() {
    let falls = followed(&format!("{BLOCK}[motion.initial]\ngap = 2\n[motion.points]\ntop = [0.3, 3]\n"));
    let landing = falls.outcome.events.iter().find(|event| event.why.word() == "impact").unwrap().t;
    near(landing, 2.0, 1e-12, "landing");
    for row in rows(&falls, 0.1).into_iter().take_while(|row| row("t") < landing) {
        near(row("f_along.top").hypot(row("f_up.top")), 0.0, 1e-14, "fall");
        near(row("a_y.top"), -1.0, 1e-14, "fall");
    }
    near(falls.points[0].jumps[0].1[1], 2.0, 1e-12, "landing");
    near(falls.points[0].extremes[3].least[0], 0.0, 1e-14, "least felt upwards");
    let text = |peak: f64| {
        format!(
            "[block]\nb1 = 1\nb2 = 1\nd = 0.5\nmu_s = 0.3\ngravity = 1\n[motion.base]\n\
             horizontal = {{ shape = \"half-sine\", peak = {peak}, duration = 2.6 }}\n[motion.points]\ntop = [0.3, 0.5]\n"
        )
    };
    let rests = followed(&text(0.2));
    let [a_x, a_y, f_along, f_up] = rests.points[0].extremes;
    near(a_x.largest[0], 0.2, 1e-14, "peak");
    near(a_x.largest[1], 1.3, 1e-6, "its time");
    assert_eq!((a_y.largest[0], a_y.least[0], f_up.largest[0], f_up.least[0]), (0.0, 0.0, 1.0, 1.0));
    assert_eq!(f_along, a_x);
    let slides = followed(&text(0.5));
    near(slides.points[0].extremes[0].largest[0], 0.3, 1e-12, "friction");
}

/// Along a motion with slip, impacts and flight accelerations are those of the point's own path, and the extremes enclose the series.
#[test]
fn accelerations_are_those_of_the_path() {
    let text = "[block]\nb1 = 1\nb2 = 1\nd = 2.5\nmu_s = 0.45\ngravity = 1\n[motion]\nimpact = { law = \"poisson\", e = 0.4 }\n\
        [motion.base]\nhorizontal = { shape = \"sine\", peak = 0.8, angular_frequency = 1.3, duration = 14 }\n\
        vertical = { shape = \"sine\", peak = 0.4, angular_frequency = 2.1, duration = 12 }\n[motion.points]\npanel = [0.4, 1.9]\n";
    let motion = followed(text);
    let [panel] = &motion.points[..] else { panic!("{:?}", motion.points) };
    let (dt, events) = (1e-3, &motion.outcome.events);
    let rows = rows(&motion, dt);
    let mut seen = 0;
    for three in rows.windows(3) {
        let t = three[1]("t");
        for (name, extremes) in PointAnswer::NAMES.into_iter().zip(panel.extremes) {
            let value = three[1](&format!("{name}.panel"));
            assert!((extremes.least[0] - 1e-9..=extremes.largest[0] + 1e-9).contains(&value), "{name} {t}");
        }
        let parts = |at: f64| (at - t).abs() <= 1.5 * dt;
        if events.iter().any(|event| parts(event.t)) || [12.0, 14.0].iter().any(|end| parts(*end)) {
            continue;
        }
        let place = |row: &dyn Fn(&str) -> f64| {
            let (sin, cos) = row("theta").sin_cos();
            [row("x") + 0.4 * cos - 1.9 * sin, row("y") + 0.4 * sin + 1.9 * cos]
        };
        let [before, here, after] = [0, 1, 2].map(|i| place(&three[i]));
        for (axis, (name, base)) in [("a_x.panel", "a_h"), ("a_y.panel", "a_v")].into_iter().enumerate() {
            let second = (after[axis] - 2.0 * here[axis] + before[axis]) / (dt * dt);
            near(three[1](name), second + three[1](base), 1e-4, &format!("{name} at {t}"));
        }
        seen += 1;
    }
    assert!(seen > 5000 && !panel.jumps.is_empty(), "{seen}");
}
