//! The JSON documents against the library's own numbers.

use std::path::Path;
use std::process::Command;

use serde_json::{Value, json};
use standfast::ground::strength::CrushPoint;
use standfast::loads::HorizontalForce;
use standfast::{Body, Point, Slip};

fn standfast(arguments: &[&str], directory: &Path) -> Value {
    let output = Command::new(env!("CARGO_BIN_EXE_standfast"))
        .args(arguments)
        .current_dir(directory)
        .output()
        .expect("the program starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(output.stderr.is_empty());
    serde_json::from_slice(&output.stdout).expect("one JSON document")
}

/// `--no-figures` leaves the answer as it is, and the folder too.
#[test]
fn an_answer_can_be_had_without_figures() {
    let folder = tempfile::tempdir().expect("a folder");
    let case = folder.path().join("case.toml");
    std::fs::copy(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/goda-2000.toml"), case)
        .expect("a case");
    let files = || std::fs::read_dir(folder.path()).expect("a folder").count();
    let mut alone = standfast(&["assess", "case.toml", "--no-figures", "--format", "json"], folder.path());
    assert_eq!((&alone["figures"], files()), (&json!([]), 1));
    let drawn = standfast(&["assess", "case.toml", "--format", "json"], folder.path());
    assert_eq!(files() - 1, drawn["figures"].as_array().expect("a list").len());
    alone["figures"] = drawn["figures"].clone();
    assert_eq!(alone, drawn);
}

/// On a base that crushes too, BF included; ω = 0 is the rigid base, to the byte.
#[test]
fn classify_on_a_base_is_the_library() {
    let here = Path::new(".");
    for [gamma, k_prime, k, mu, omega] in [
        [0.8, 0.9167, 0.61, 0.6, 0.08],
        [1.0, 0.4, 0.3, 0.6, 0.5],
        [4.0, -0.55, 6.0, 3.45, 0.2],
        [1.0, -2.0, 2.0, 0.5, 0.3],
        [1.0, 0.4, 0.3, 0.6, 1.0],
    ] {
        let point = CrushPoint::new(gamma, k_prime, k, mu, omega).expect("a point");
        let numbers = [gamma, k_prime, k, mu, omega].map(|number| number.to_string());
        let [g, kp, kk, m, w] = numbers.each_ref().map(String::as_str);
        let rigid = ["classify", "--gamma", g, "--k-prime", kp, "--k", kk, "--mu", m, "--format", "json"];
        let document = standfast(&[&rigid[..], &["--omega", w]].concat(), here);
        assert_eq!(document["mode"], json!(point.verdict().symbol()));
        assert_eq!(document["mode_words"], json!(point.verdict().words()));
        assert_eq!(document["unique"], json!(point.is_unique()));
        let others: Vec<_> = point.others().iter().map(|mode| mode.symbol()).collect();
        assert_eq!(document["also"], json!(others));
        assert_eq!(document["ground"]["omega"], json!(omega));
        let begun = point.motion();
        let neutral = begun.and_then(|begun| begun.neutral.map(|neutral| 1.0 - neutral.abs()));
        match (document["ground"]["neutral"].as_f64(), neutral) {
            (Some(found), Some(expected)) => assert!((found - expected).abs() < 1e-12),
            (found, expected) => assert_eq!(found, expected),
        }
        match begun {
            Some(begun) => {
                assert_eq!(document["motion"]["theta_ddot"], json!(begun.motion.theta_ddot));
                assert_eq!(document["motion"]["xi"], json!(begun.motion.xi));
                let width = document["ground"]["effective_width"].as_f64().expect("a width");
                assert!((width - 2.0 * (1.0 - begun.motion.xi.abs())).abs() < 1e-12);
            }
            None => assert!(document["motion"].is_null() && document["ground"]["pivot"].is_null()),
        }
        assert_eq!(standfast(&rigid, here), standfast(&[&rigid[..], &["--omega", "0"]].concat(), here));
    }
}

#[test]
fn classify_is_the_library() {
    let here = Path::new(".");
    for [gamma, k_prime, k, mu] in [
        [1.0, 0.4, 0.5, 0.6],
        [0.8, 0.3, 0.9, 0.1],
        [1.0, 1.0, 2.0, 5.0],
        [3.0, 0.8, 3.0, 0.1],
        [1.0, -0.5, 5.0, 3.25],
        [1.0, -0.5, 8.5, 3.25],
        [1.0, -2.0, 2.0, 5.0],
    ] {
        let point = Point::new(gamma, k_prime, k, mu).expect("a point");
        let numbers = [gamma, k_prime, k, mu].map(|number| number.to_string());
        let [g, kp, kk, m] = numbers.each_ref().map(String::as_str);
        let arguments = ["classify", "--gamma", g, "--k-prime", kp, "--k", kk, "--mu", m, "--format", "json"];
        let document = standfast(&arguments, here);
        assert_eq!(document["gamma"], json!(gamma));
        assert_eq!(document["k_prime"], json!(k_prime));
        assert_eq!(document["k"], json!(k));
        assert_eq!(document["mu"], json!(mu));
        assert_eq!(document["mode"], json!(point.mode().symbol()));
        assert_eq!(document["mode_words"], json!(point.mode().words()));
        assert_eq!(document["unique"], json!(point.is_unique()));
        let others: Vec<_> = point.others().iter().map(|mode| mode.symbol()).collect();
        assert_eq!(document["also"], json!(others));
        assert_eq!(document["SF_sliding"], json!(point.safety_against_sliding()));
        assert_eq!(document["SF_overturning"], json!(point.safety_against_overturning()));
        let motion = point.motion();
        assert_eq!(document["motion"]["x_ddot"], json!(motion.x_ddot));
        assert_eq!(document["motion"]["y_ddot"], json!(motion.y_ddot));
        assert_eq!(document["motion"]["theta_ddot"], json!(motion.theta_ddot));
        assert_eq!(document["motion"]["f_x"], json!(motion.f_x));
        assert_eq!(document["motion"]["f_y"], json!(motion.f_y));
        assert_eq!(document["motion"]["xi"], json!(motion.xi));
        let leaves_rest = point.margins().leaves_rest().expect("a force that moves the body");
        assert_eq!(document["leaves_rest"]["at"], json!(leaves_rest.at));
        assert_eq!(document["leaves_rest"]["to"], json!(leaves_rest.to.symbol()));
        let trace = document["trace"].as_array().expect("a list");
        assert_eq!(trace.len(), point.explain().steps.len());
        assert_eq!(trace.last().expect("a step")["holds"], json!(true));
    }
}

#[test]
fn assess_is_the_library_in_si_units() {
    let directory = tempfile::tempdir().expect("a directory");
    let case = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/block-two-loads.toml");
    let document = standfast(&["assess", case, "-o", ".", "--format", "json"], directory.path());
    let gravity = 9.81;
    assert_eq!(document["gravity"], json!(gravity));
    assert_eq!(document["body"]["mass"], json!(4800.0));
    assert_eq!(
        document["figures"],
        json!(["./block-two-loads-1.svg", "./block-two-loads-3.svg", "./block-two-loads-section.svg"])
    );
    for file in document["figures"].as_array().expect("a list") {
        let path = directory.path().join(file.as_str().expect("a name"));
        assert!(std::fs::read_to_string(path).expect("a diagram").starts_with("<svg"));
    }

    let body = Body::of_density(1.0, 2.0, 2400.0).expect("a body");
    let weight = body.mass() * gravity;
    let loads = [
        ("push", 20e3, 1.5, Slip::Left),
        ("push back", 20e3, 1.5, Slip::Right),
        ("low blow", 60e3, 0.4, Slip::Right),
    ];
    for ((name, magnitude, elevation, direction), situation) in
        loads.into_iter().zip(document["situations"].as_array().expect("a list"))
    {
        let force = HorizontalForce::new(magnitude, elevation, direction).expect("a force");
        let reduced = force.reduce(&body, 0.7, gravity).expect("a point");
        let motion = reduced.motion();
        assert_eq!(situation["load"]["name"], json!(name));
        assert_eq!(situation["load"]["force"], json!(magnitude));
        assert_eq!(situation["load"]["direction"], json!(if reduced.mirrored { "right" } else { "left" }));
        assert_eq!(situation["k_eff"], json!(reduced.point.k()));
        assert_eq!(situation["k_prime_eff"], json!(reduced.point.k_prime()));
        assert_eq!(situation["mode"], json!(reduced.mode().symbol()));
        assert_eq!(situation["report"]["mode"], json!(reduced.mode().symbol()));
        assert_eq!(situation["report"]["motion"]["theta_ddot"], json!(motion.theta_ddot));
        // B = 0.5 m.
        let si = |key: &str| situation["motion"][key].as_f64().expect("a number");
        let close = |a: f64, b: f64| (a - b).abs() <= 1e-12 * b.abs().max(1.0);
        assert!(close(si("x_ddot"), motion.x_ddot * gravity));
        assert!(close(si("y_ddot"), motion.y_ddot * gravity));
        assert!(close(si("theta_ddot"), motion.theta_ddot * gravity / 0.5));
        assert!(close(si("f_x"), motion.f_x * weight));
        assert!(close(si("f_y"), motion.f_y * weight));
        assert!(close(si("xi"), motion.xi * 0.5));
        // Newton's second law in the units of the input: kg, m, s, N.
        let pull = direction.sign() * magnitude;
        assert!(close(body.mass() * si("x_ddot"), si("f_x") + pull));
        assert!(close(body.mass() * si("y_ddot"), si("f_y") - weight));
        let moment = si("f_x") * 1.0 + si("f_y") * si("xi") - pull * (elevation - 1.0);
        assert!((body.moment_of_inertia() * si("theta_ddot") - moment).abs() < 1e-8 * weight);
    }
}

#[test]
fn friction_to_slip_that_is_friction_to_stick_changes_nothing() {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let directory = tempfile::tempdir().expect("a directory");
    let mut compared = 0;
    let files = std::fs::read_dir(examples).expect("examples").map(|entry| entry.expect("an entry").path());
    for entry in files.filter(|path| path.is_file()) {
        let text = std::fs::read_to_string(&entry).expect("a case");
        // A partial factor of friction divides both, and the answer tells both.
        let by_code = text.contains("\ncode = ");
        if !text.contains("\nfriction = ") || text.contains("kinetic_friction") || by_code {
            continue;
        }
        let friction = text.lines().find(|line| line.starts_with("friction")).expect("friction");
        let doubled = text.replacen(friction, &format!("{friction}\nkinetic_{friction}"), 1);
        let [plain, doubled] = [text, doubled].map(|text| {
            let file = directory.path().join("case.toml");
            std::fs::write(&file, text).expect("a file");
            let file = file.to_str().expect("a name");
            standfast(&["assess", file, "-o", ".", "--format", "json"], directory.path())
        });
        assert_eq!(plain, doubled, "{}", entry.display());
        compared += 1;
    }
    assert!(compared >= 5);
}
