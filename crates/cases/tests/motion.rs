//! Cases in time: what a file says becomes the problem it says.

use std::path::Path;

use standfast::Mode;
use standfast_cases::motion::{
    BlockCase, Follow, FollowedMotion, GivenBase, MotionView, Record, RecordUnit, Spectrum, SpectrumKind,
    SpectrumRequest, SpectrumSteps,
};
use standfast_cases::{Acting, CaseError, CaseFile, Document, Portion};
use standfast_motion::End;

fn no_file(file: &str) -> Result<String, String> {
    Err(format!("no file {file}"))
}

fn follow(text: &str) -> Vec<FollowedMotion> {
    FollowedMotion::of_file(&CaseFile::read("case.toml", text, &no_file).unwrap(), &Follow::default())
        .unwrap()
}

/// The situations of a case.
fn motions(text: &str, file: &dyn Fn(&str) -> Result<String, String>) -> Result<Vec<BlockCase>, CaseError> {
    CaseFile::read("case.toml", text, file)?.motions()
}

fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance * expected.abs(), "{found} {expected}");
}

/// Goda's caisson: a triangle of thrust and uplift moves it by S = (¼ + √2/6)(s − 1)³/s² Rτ²/m, s = F_S/R, F_S = P + μU, R = μW', with
/// P and U as `assess` has them, times 1.5, and m with the added mass.
#[test]
fn breaking_wave_slides_a_caisson() {
    let text = include_str!("../../../examples/motion/caisson-breaking-wave.toml");
    let answers = follow(text);
    let [followed] = &answers[..] else { panic!("{}", answers.len()) };
    assert_eq!(followed.case.situation.as_deref(), Some("wave times 1.5"));
    let lines = text.lines().filter(|line| !line.starts_with("history"));
    let still: String = lines.map(|line| format!("{line}\n")).collect();
    let still = CaseFile::parse("case.toml", &still).unwrap().case().unwrap();
    let situation = still.situation(Acting::Combination(0), standfast_cases::case::Trial::AS_GIVEN).unwrap();
    let wrenches = |permanent: bool| {
        situation
            .loads()
            .iter()
            .filter(|load| load.permanent == permanent)
            .map(|load| situation.wrench_of(load))
            .sum()
    };
    let (weight, wave): (standfast::Wrench, standfast::Wrench) = (wrenches(true), wrenches(false));
    let (μ, τ, m) = (0.6, 1.557, (346.05 + 56.4) * 1e3);
    let (thrust, uplift) = (-wave.x, -wave.p);
    assert!(thrust > 1.4e6 && uplift > 0.3e6, "{thrust} {uplift}");
    let r = μ * weight.p;
    let s = (thrust + μ * uplift) / r;
    let root = 2f64.sqrt();
    assert!(s > 1.0 && s < 1.0 + 1.0 / root, "{s}");
    let expected = (0.25 + root / 6.0) * (s - 1.0).powi(3) / (s * s) * r * τ * τ / m;
    close(-followed.outcome.slide, expected, 1e-12);
    close(-followed.outcome.slide, 0.085, 0.01);
    assert_eq!(followed.outcome.end, End::AtRest);
}

/// A body in metres and kilonewtons is the block of its numbers.
#[test]
fn body_and_block_agree() {
    let body = r#"
        [body]
        width = "60 cm"
        height = "2 m"
        density = "2.6 t/m3"
        friction = 0.5
        kinetic_friction = 0.4
        [[load]]
        force = "8 kN/m"
        elevation = "1.6 m"
        history = { shape = "triangle", rise = "0.1 s", duration = "0.5 s", start = "0.2 s" }
        [[load]]
        force = "1 kN/m"
        direction = "down"
        distance = "0.2 m"
        elevation = "2 m"
        permanent = true
        [motion]
        impact = { law = "housner" }
        t_max = "9 s"
        [motion.base]
        horizontal = { shape = "sine", peak = "0.1 g", period = "0.7 s", duration = "2 s" }
    "#;
    // Of mass 0.6 · 2 · 2600 kg/m.
    let block = r#"
        [block]
        b1 = 0.3
        b2 = 0.3
        d = 1.0
        rho2 = 0.36333333333333333
        mu_s = 0.5
        mu_k = 0.4
        gravity = 9.81
        [[block.load]]
        at = [0.0, 0.6]
        direction = [-1.0, 0.0]
        history = { shape = "triangle", peak = 2.5641025641025643, rise = 0.1, duration = 0.5, start = 0.2 }
        [[block.load]]
        at = [-0.1, 1.0]
        direction = [0.0, -1.0]
        history = { shape = "constant", peak = 0.32051282051282054 }
        [motion]
        impact = { law = "housner" }
        t_max = 9
        [motion.base]
        horizontal = { shape = "sine", peak = 0.981, angular_frequency = 8.97597901025655, duration = 2 }
    "#;
    let (one, two) = (follow(body), follow(block));
    let (one, two) = (&one[0].outcome, &two[0].outcome);
    assert!(one.events.len() > 5);
    let story = |outcome: &standfast_motion::MotionOutcome| {
        outcome.events.iter().map(|e| (e.why, e.state)).collect::<Vec<_>>()
    };
    assert_eq!(story(one), story(two));
    close(one.max_theta, two.max_theta, 1e-9);
    assert!((one.slide - two.slide).abs() < 1e-11, "{} {}", one.slide, two.slide);
}

/// Of alternatives each is followed, the worst first.
#[test]
fn alternatives_one_by_one() {
    let load = |name: &str, force: f64| {
        format!(
            "[[load]]\nname = \"{name}\"\nforce = {force}\nelevation = 5\n\
             history = {{ shape = \"rect\", duration = 0.3 }}\n"
        )
    };
    let body = "[body]\nwidth = 15\nheight = 12\nmass = 378e3\nfriction = 0.6\n";
    let answers = follow(&format!("{body}{}{}{}", load("a", 2.4e6), load("b", 3e6), load("c", 1e6)));
    let names: Vec<_> = answers.iter().map(|followed| followed.case.situation.clone().unwrap()).collect();
    assert_eq!(names, ["b", "a", "c"]);
    // (F − μmg) F T²/(2 m² μ g)
    let (m, r) = (378e3, 0.6 * 378e3 * 9.81);
    for (followed, force) in answers.iter().zip([3e6, 2.4e6]) {
        close(-followed.outcome.slide, (force - r) * force * 0.09 / (2.0 * m * r), 1e-10);
    }
    assert_eq!(answers[2].outcome.slide, 0.0);
}

/// Faults are said with their places.
#[test]
fn wrong_cases() {
    let body = "[body]\nwidth = 15\nheight = 12\nmass = 378e3\nfriction = 0.6\n";
    let load = "[[load]]\nforce = 3e6\nelevation = 5\n";
    let history = "history = { shape = \"rect\", duration = 0.3 }\n";
    let base = "[motion.base]\nhorizontal = { shape = \"rect\", peak = \"0.2 g\", duration = \"0.3 s\" }\n";
    for (text, words) in [
        (format!("{body}{load}"), "a load that varies has no history"),
        (
            format!("{body}{load}{history}[earthquake]\nhorizontal = \"0.1 g\"\n{base}"),
            "counts the same shaking twice",
        ),
        (
            format!("{body}{load}{}", history.replace("0.3", "0")),
            "`duration` is 0; expected a finite number above zero",
        ),
        (format!("{body}{load}{}", history.replace("rect", "ract")), "`shape` is \"ract\""),
        (format!("{body}{load}{}", history.replace("0.3", "\"0.3 m\"")), "the unit `m` does not fit"),
        (format!("{body}{load}{history}[motion]\nt_mix = 3\n"), "[motion] has no key `t_mix`"),
        (format!("{body}{base}[motion.initial]\ntheta = 3\n"), "theta is 3"),
    ] {
        let error = motions(&text, &no_file).unwrap_err();
        assert!(error.to_string().contains(words), "{error}\n{text}");
    }
    let lift = "[[load]]\nforce = 5e6\ndirection = \"up\"\ndistance = 7.5\npermanent = true\n";
    let cases = motions(&format!("{body}{lift}{base}"), &no_file).unwrap();
    let error = FollowedMotion::of_all(cases, &Follow::default(), Portion::UNSEEN).unwrap_err();
    assert!(error.to_string().contains("floats"), "{error}");
}

/// The examples run to an end.
#[test]
fn examples_are_followed() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/motion");
    let read = |file: &str| std::fs::read_to_string(folder.join(file)).map_err(|error| error.to_string());
    let mut count = 0;
    for entry in std::fs::read_dir(&folder).unwrap().map(Result::unwrap) {
        let (name, text) = (
            entry.file_name().to_string_lossy().into_owned(),
            std::fs::read_to_string(entry.path()).unwrap(),
        );
        let cases = CaseFile::read(&name, &text, &read).unwrap().motions().unwrap();
        for followed in FollowedMotion::of_all(cases, &Follow::default(), Portion::UNSEEN).unwrap() {
            assert!(matches!(followed.outcome.end, End::AtRest | End::Overturned), "{name}");
        }
        count += 1;
    }
    assert!(count >= 4);
}

fn shaken(text: &str, values: &[f64], dt: f64) -> Vec<FollowedMotion> {
    let times = (0..values.len()).map(|i| i as f64 * dt).collect();
    let record = Record { times, values: values.to_vec(), unit: RecordUnit::Unnamed };
    let given = GivenBase { horizontal: Some(record), vertical: None };
    FollowedMotion::of_file(&CaseFile::parse("case.toml", text).unwrap().on_base(&given), &Follow::default())
        .unwrap()
}

/// A record of a force moves no ground, and nothing is said of where that ends.
#[test]
fn a_record_of_a_force_has_no_drift() {
    let text = "[body]\nwidth = 3\nheight = 5\nmass = 36e3\nfriction = 0.6\n[motion]\n[[load]]\nforce = 1\nelevation = 2\n\
        history = { shape = \"file\", file = \"f.csv\" }\n";
    let read = |_: &str| Ok("t_s,force_kN_m\n0,0\n0.1,50\n0.2,0\n".to_owned());
    let file = CaseFile::read("case.toml", text, &read).unwrap();
    for followed in FollowedMotion::of_file(&file, &Follow::default()).unwrap() {
        assert!(
            followed.warnings.iter().all(|warning| warning.name != "record-drift"),
            "{:?}",
            followed.warnings
        );
    }
}

/// A record that is given takes the place of the file's: a steady acceleration k₀ over T slides a low block by D k₀ T²/(2 μ) to the
/// other side, D = k₀ − μ.
#[test]
fn a_record_that_is_given_moves_the_base() {
    let text = "[block]\nb1 = 1\nb2 = 1\nd = 0.3\nmu_s = 0.4\ngravity = 1\n";
    let named = "[motion.base]\nhorizontal = { shape = \"file\", file = \"none.csv\" }\n";
    for text in [text.to_owned(), format!("{text}{named}")] {
        let [followed] = &shaken(&text, &[0.6; 5], 0.25)[..] else { panic!() };
        close(followed.outcome.slide, -0.2 * 0.6 / (2.0 * 0.4), 1e-13);
        assert!(followed.warnings.iter().any(|warning| warning.name == "record-drift"));
    }
}

/// In a case with a body it is the same as the points of a file, with the water that moves with the shaken wall.
#[test]
fn a_record_that_is_given_moves_a_body_as_points_do() {
    let body = "[body]\nwidth = 4\nheight = 6\nmass = 50000\nfriction = 0.4\n[added_mass]\nmass = 9000\nelevation = 3\n";
    let values = [0.0, 5.0, -4.0, 6.0, 1.0, 0.0];
    let points = "[motion.base]\nhorizontal = { shape = \"points\", peak = \"1 m/s2\", times = [0, 0.5, 1, 1.5, 2, 2.5], values = [0, 5, -4, 6, 1, 0] }\n";
    let [of_file] = &follow(&format!("{body}{points}"))[..] else { panic!() };
    let [given] = &shaken(body, &values, 0.5)[..] else { panic!() };
    assert!(given.outcome.slide != 0.0);
    assert_eq!(given.outcome, of_file.outcome);
}

/// A history says the same under a header of its own as on one line.
#[test]
fn histories_may_have_headers() {
    let load = |history: &str| {
        let text = "[body]\nwidth = 4\nheight = 1\ndensity = 2400\nfriction = 0.2\n\
                    [[load]]\nforce = 60000\nelevation = 0.5\n";
        follow(&format!("{text}{history}"))
    };
    let on_a_line = load("history = { shape = \"rect\", duration = 0.5 }\n");
    assert!(on_a_line[0].outcome.slide < 0.0);
    for headed in [
        "[load.history]\nshape = \"rect\"\nduration = 0.5\n",
        "[ load . \"history\" ]\nduration = 0.5\nshape = \"rect\"\n",
    ] {
        let more = format!("{headed}[[load]]\nforce = 1e-6\nelevation = 0.5\npermanent = true\n");
        let (one, with_more) = (load(headed), load(&more));
        assert_eq!(one, on_a_line);
        assert!((with_more[0].outcome.slide - one[0].outcome.slide).abs() < 1e-8);
    }
    let wave = include_str!("../../../examples/motion/caisson-breaking-wave.toml");
    let line = wave.lines().find(|line| line.starts_with("history")).unwrap();
    let headed = wave.replace(line, "").replace(
        "[added_mass]",
        "[wave.history]\nshape = \"triangle\"\nrise = \"0.7785 s\"\nduration = \"1.557 s\"\n[added_mass]",
    );
    assert_eq!(follow(&headed), follow(wave));
}

/// The numbers of an attribute of an element that begins with `element`, in order.
fn listed(svg: &str, element: &str, attribute: &str) -> Vec<Vec<f64>> {
    let of = &svg[svg.find(element).unwrap()..];
    let of = &of[..of.find("/>").unwrap()];
    let value = &of[of.find(&format!(" {attribute}=\"")).unwrap() + attribute.len() + 3..];
    let value = &value[..value.find('"').unwrap()];
    value.split(';').map(|part| part.split(' ').map(|number| number.parse().unwrap()).collect()).collect()
}

/// At every moment that the animation names, the angle is that of the motion, and C as far from where it is at the end as there.
#[test]
fn the_animation_follows_the_motion() {
    let text = include_str!("../../../examples/motion/block-base-pulse.toml");
    let case = motions(text, &no_file).unwrap().remove(0);
    let whole = Follow { series: true, ..Follow::default() };
    let motions = [FollowedMotion::of(case.clone(), &whole).unwrap()];
    let figures = motions.figures(&MotionView::default()).unwrap();
    let followed = &motions[0];
    let suffixes: Vec<&str> = figures.iter().map(|figure| &*figure.suffix).collect();
    assert_eq!(suffixes, ["-motion", "-positions", "-animation"]);
    let svg = figures[2].figure.svg();
    let [translate, rotate] = ["translate", "rotate"]
        .map(|kind| format!("<animateTransform attributeName=\"transform\" type=\"{kind}\""));
    let (times, angles) = (listed(svg, &rotate, "keyTimes"), listed(svg, &rotate, "values"));
    let places = listed(svg, &translate, "values");
    assert!(times.len() > 100 && times.len() == angles.len() && times.len() == places.len());
    assert!(times.is_sorted_by(|one, two| one[0] <= two[0]));
    assert_eq!((times[0][0], times[times.len() - 1][0]), (0.0, 1.0));
    let duration = svg[svg.find("dur=\"").unwrap() + 5..].split('s').next().unwrap().parse::<f64>().unwrap();
    let end = followed.outcome.events.last().unwrap().t;
    assert!((duration - end - 1.5).abs() < 1e-3, "{duration} {end}");
    let at = |t: f64| followed.outcome.at(t).unwrap();
    // The scale of the page, by how far C rises or falls in all.
    let last = at(end);
    let moved =
        |place: &[f64]| (place[0] - places[places.len() - 1][0], places[places.len() - 1][1] - place[1]);
    let scale = moved(&places[0]).1 / (at(0.0).y - last.y);
    assert!(scale > 10.0, "{scale}");
    for ((time, angle), place) in times.iter().zip(&angles).zip(&places).take(times.len() - 1) {
        let now = at(time[0] * duration);
        assert!((angle[0] + now.theta.to_degrees()).abs() < 0.02, "{time:?}: {angle:?} {now:?}");
        let (x, y) = moved(place);
        assert!(
            (x - scale * (now.x - last.x)).abs() < 0.03 && (y - scale * (now.y - last.y)).abs() < 0.03,
            "{now:?}"
        );
    }
    // Without steps there is nothing to draw.
    let followed = [FollowedMotion::of(case, &Follow::default()).unwrap()];
    assert!(followed.figures(&MotionView::default()).unwrap().is_empty());
}

/// A picture that moves begins shortly before the body leaves rest and ends shortly after it rests, and says so; its angles are still those
/// of the motion. Captions have four digits.
#[test]
fn an_animation_leaves_out_the_rest_before_and_after() {
    let text = include_str!("../../../examples/motion/block-base-pulse.toml");
    let late = text.replace("period = 5, duration = 5", "period = 5, duration = 5, start = 81.2345678");
    let case = motions(&late.replace("peak = 0.6", "peak = 0.36"), &no_file).unwrap().remove(0);
    let whole = Follow { series: true, ..Follow::default() };
    let answers = [FollowedMotion::of(case, &whole).unwrap()];
    let figures = answers.figures(&MotionView::default()).unwrap();
    let outcome = &answers[0].outcome;
    let leaves = outcome.events.iter().find(|event| event.state != Mode::Rest).unwrap().t;
    let rests = outcome.t_rest.unwrap();
    assert!(leaves > 81.0 && rests > leaves, "{leaves} {rests}");
    let svg = figures[2].figure.svg();
    let duration: f64 = svg.split("dur=\"").nth(1).unwrap().split('s').next().unwrap().parse().unwrap();
    let room = (0.08 * (rests - leaves)).min(1.0);
    let begin = leaves - room;
    let end = (rests + room).min(outcome.t_final);
    assert!((duration - 1.5 - (end - begin)).abs() < 1e-3, "{duration} {begin} {end}");
    let rotate = "<animateTransform attributeName=\"transform\" type=\"rotate\"";
    // So small a motion is drawn larger, which the caption says.
    let factor = if figures[2].figure.caption().contains("ten times as large") { 10.0 } else { 1.0 };
    let mut turned = 0;
    for (time, angle) in listed(svg, rotate, "keyTimes").iter().zip(&listed(svg, rotate, "values")) {
        let t = (begin + time[0] * duration).min(end);
        let theta = outcome.at(t).unwrap().theta.to_degrees();
        assert!((angle[0] + factor * theta).abs() < 0.02, "{t}: {angle:?} {theta}");
        turned += usize::from(angle[0] != 0.0);
    }
    assert!(turned > 50, "{turned}");
    let caption = figures[2].figure.caption();
    assert!(caption.contains(&format!(" Shown from t = {begin:.1}")), "{caption}");
    for figure in &figures {
        let caption = figure.figure.caption();
        assert!(caption.contains(&format!("At t = {leaves:.2} the body leaves rest")), "{caption}");
        let digits = |word: &&str| word.chars().filter(char::is_ascii_digit).count();
        let word = caption.split_whitespace().max_by_key(digits).unwrap();
        assert!(digits(&word) <= 4, "{word} in {caption}");
    }
}

/// Under a rectangle of acceleration the base leaves the block behind to one side only: on level ground it slides as far as one that can
/// slide to that side alone, whatever its yield acceleration. Under a shaking both ways this is true of the ratios above the lesser peak.
#[test]
fn lines_of_a_newmark_spectrum_that_lie_on_each_other_are_told() {
    let caption = |shape: &str| {
        let text = format!(
            "[block]\nb1 = 1\nb2 = 1\nd = 0.5\nmu_s = 0.4\ngravity = 1\n[motion.base]\nhorizontal = {{ {shape} }}\n"
        );
        let case = motions(&text, &no_file).unwrap().remove(0);
        let steps = "0.2,0.8,7".parse::<SpectrumSteps>().unwrap().into();
        let request = SpectrumRequest { ratio: Some(steps), ..SpectrumRequest::new(SpectrumKind::Newmark) };
        let found = Spectrum::of(&case, &request, Portion::UNSEEN).unwrap();
        found.figures(&()).unwrap().remove(0).figure.caption().to_owned()
    };
    let one = caption("shape = \"rect\", peak = 0.8, duration = 1.5");
    let told = "From 0.2 on a block on level ground slides as far as one that can only slide to the ";
    assert!(one.contains(told), "{one}");
    // To the right, and then longer back with less: below 0.7 the block slides both ways, and farther back.
    let both =
        caption("shape = \"points\", peak = 1, times = [0, 1, 1, 4, 4], values = [1, 1, -0.7, -0.7, 0]");
    assert!(both.contains("on a block on level ground") && !both.contains("From 0.2 on"), "{both}");
}

/// At the first instant a shaken body bears the peaks of the shaking, and a wave's load its own value; blanks keep the places of errors.
#[test]
fn at_the_first_instant_the_peaks_act() {
    let body = "[body]\nwidth = 1\nheight = 2\nmass = 5000\nfriction = 0.5\n";
    let base = "[motion.base]\nhorizontal = { shape = \"half-sine\", peak = \"0.3 g\", duration = 1 }\n\
                vertical = { shape = \"triangle\", peak = \"-1.5 m/s2\", rise = 0.2, duration = 0.5 }\n";
    let first = |text: &str| CaseFile::parse("case.toml", text).unwrap().first_instant().unwrap();
    let instant = first(&format!("{body}{base}")).unwrap();
    let note = &instant.note;
    assert!(note.contains("[earthquake]") && note.contains("standfast simulate"), "{note}");
    let case = instant.file.case().unwrap();
    let expected = format!("{body}[earthquake]\nhorizontal = \"2.943 m/s2\"\nvertical = \"1.5 m/s2\"\n");
    let other = CaseFile::parse("case.toml", &expected).unwrap().case().unwrap();
    assert_eq!(case, other);
    let wave = include_str!("../../../examples/motion/caisson-breaking-wave.toml");
    let instant = first(wave).unwrap();
    assert!(!instant.note.contains("[earthquake]"), "{}", instant.note);
    assert!(instant.file.case().unwrap().wave.is_some_and(|wave| wave.history.is_none()));
    // What says nothing of time stays as it is; so does a history on an elastic base.
    assert!(first(body).is_none());
    let elastic = format!(
        "{body}[ground]\nstiffness = 1e7\n[[load]]\nforce = 1\nelevation = 1\nhistory = {{ shape = \"rect\", duration = 1 }}\n"
    );
    assert!(first(&elastic).is_none());
}

/// Shimosako and Takahashi's duration of Goda's caisson by hand: T = 11.4 s, H = 8.05 m, h = 10.1 m, α* = 0.3223 give 1.557 s, and so the
/// slide of the example, which has that number. The answer says whose formulas they are.
#[test]
fn a_duration_by_the_waves() {
    let text = include_str!("../../../examples/motion/caisson-breaking-wave.toml");
    let plain = &follow(text)[0];
    let by_waves =
        text.replace("rise = \"0.7785 s\", duration = \"1.557 s\"", "duration = \"shimosako-takahashi\"");
    assert_ne!(text, by_waves);
    let answers = follow(&by_waves);
    let followed = &answers[0];
    close(followed.outcome.slide, plain.outcome.slide, 1e-3);
    let period: f64 = 11.4 * f64::max(0.4, 0.5 - 8.05 / (8.0 * 10.1));
    let expected = period / (0.3223_f64.powf(0.3) + 1.0).powi(2);
    close(*followed.case.problem.loads.last().unwrap().history.times().last().unwrap(), expected, 2e-4);
    let told = followed.warnings.iter().find(|warning| warning.name == "duration-by-formula").unwrap();
    assert!(told.words.contains("1.557") && told.words.contains("Shimosako"), "{}", told.words);
    // Without impulsive pressures α* is α₂ = (h_b − d)/(3 h_b) (H/d)², of h_b = 10.39 m and d = 5.6 m.
    let alpha_2 = (10.39 - 5.6) / (3.0 * 10.39) * (8.05_f64 / 5.6).powi(2);
    let answers = follow(&by_waves.replace("[wave]\n", "[wave]\nimpulsive = false\n"));
    let loads = &answers[0].case.problem.loads;
    let expected = period / (alpha_2.powf(0.3) + 1.0).powi(2);
    close(*loads.last().unwrap().history.times().last().unwrap(), expected, 2e-4);
    for (wrong, expected) in [
        ("shape = \"triangle\", rise = \"0.1 s\", duration = \"shimosako-takahashi\"", "`rise` does not go"),
        ("shape = \"rect\", duration = \"shimosako-takahashi\"", "goes with a triangle only"),
        ("shape = \"triangle\", rise = \"0.1 s\", duration = \"shimosako\"", "`duration` is"),
    ] {
        let case = text.replace("shape = \"triangle\", rise = \"0.7785 s\", duration = \"1.557 s\"", wrong);
        let error = motions(&case, &no_file).unwrap_err().to_string();
        assert!(error.contains(expected), "{wrong}: {error}");
    }
    // A caisson so heavy and rough that it rocks: the uplift stays, which is said.
    let rocks = text.replace("friction = 0.6", "friction = 3").replace("wave = 1.5", "wave = 2.2");
    let answers = follow(&rocks);
    let followed = &answers[0];
    assert!(followed.outcome.max_theta > 0.0, "{:?}", followed.outcome.events);
    assert!(followed.warnings.iter().any(|warning| warning.name == "uplift-kept"));
}

/// Likely slips are named of a case in metres as of a block: a record in cm/s² read as m/s², points too far apart for so
/// small a body, an impact without loss.
#[test]
fn slips_are_named_in_both_kinds_of_case() {
    let file = |_: &str| Ok("time_s,a_m_s2\n0,0\n0.1,80\n0.2,-60\n0.3,0\n".to_owned());
    let motion = "[motion]\nimpact = { law = \"ratio\", ratio = 0.9995 }\n\
        [motion.base]\nhorizontal = { shape = \"file\", file = \"record.csv\" }\n";
    let body =
        format!("[body]\nwidth = 0.4\nheight = 1.2\nmass = 100\nlength = 0.4\nfriction = 0.6\n{motion}");
    let block =
        format!("[block]\nb1 = 0.2\nb2 = 0.2\nd = 0.6\nrho2 = 0.13\nmu_s = 0.6\ngravity = 9.81\n{motion}");
    let named = |warnings: &[standfast_cases::motion::MotionWarning]| {
        let find = |name| warnings.iter().find(|w| w.name == name).map(|w| w.words.clone());
        ["strong-earthquake", "coarse-record", "lossless-impact"]
            .map(|name| find(name).unwrap_or_else(|| panic!("{name} is not in {warnings:?}")))
    };
    let body = &motions(&body, &file).unwrap()[0];
    let block = &motions(&block, &file).unwrap()[0];
    let words = named(&body.warnings);
    assert_eq!(words, named(&block.warnings));
    assert!(words[0].contains("reaches 8.155 g"), "{words:?}");
    // 0.1 s over √(0.2 m/9.81 m/s²).
    assert!(words[1].contains("0.100 apart, 0.70 of"), "{words:?}");
    assert!(words[2].contains("0.9995"), "{words:?}");
}

/// What is warned of a case at rest is warned of its motion: a centre of mass above the body, a mass in the wrong unit.
#[test]
fn warnings_of_the_case_are_those_of_its_motion() {
    let shaken =
        "[motion.base]\nhorizontal = { shape = \"half-sine\", peak = \"3 m/s2\", duration = \"0.4 s\" }\n";
    let body =
        "[body]\nwidth = \"0.6 m\"\nlength = \"0.6 m\"\nheight = \"2 m\"\nmass = \"1.9 t\"\nfriction = 0.5\n";
    let names = |text: &str| -> Vec<&'static str> {
        let cases = motions(&format!("{text}{shaken}"), &no_file).unwrap();
        cases[0].warnings.iter().map(|warning| warning.name).collect()
    };
    assert_eq!(names(body), [""; 0]);
    assert_eq!(names(&format!("{body}centroid_height = \"17 m\"\n")), ["centroid-outside-body"]);
    assert_eq!(
        names(&body.replace("1.9 t", "1.9 kg").replace("= 0.5", "= 50")),
        ["mean-density", "high-friction"]
    );
}

/// Values of an acceleration are shares of a peak with its unit; an [earthquake], which is held, is pointed to a base that moves; ground that
/// may fail is not followed, and the answer begins with that.
#[test]
fn what_a_motion_is_of_is_said() {
    let body = "[body]\nwidth = 3\nlength = 1\nheight = 4\nmass = 28000\nfriction = 0.5\n";
    let refused = |text: &str| standfast_cases::report(&motions(text, &no_file).unwrap_err());
    let points =
        "[motion.base]\nhorizontal = { shape = \"points\", times = [0, 0.1, 0.2], values = [0, 0.4, 0] }\n";
    let told = refused(&format!("{body}{points}"));
    assert!(told.contains("`peak`"), "{told}");
    let with_peak = points.replace("times", "peak = \"2 g\", times");
    assert!(follow(&format!("{body}{with_peak}"))[0].outcome.max_slide > 0.0);
    let told = refused(&format!("{body}[earthquake]\nhorizontal = \"0.3 g\"\n"));
    assert!(told.contains("has no course in time") && told.contains("[motion.base]"), "{told}");
    let sand = "[ground]\nfriction_angle_deg = 35\nunit_weight = 10e3\n";
    let words = follow(&format!("{body}{with_peak}{sand}")).summary().unwrap().answer;
    assert!(words.starts_with("On a rigid base, as [ground] is not followed in time: "), "{words}");
}

/// Two loads that are equal but for their histories, one in each combination: each has its own, whichever stands first. The slide of a
/// triangle by hand: from where its force passes μmg to where the body stops again.
#[test]
fn equal_loads_keep_their_own_histories() {
    let load = |name: &str, more: &str| {
        format!("[[load]]\nname = \"{name}\"\nforce = 25000\nelevation = 1.2\n{more}\n")
    };
    let pulse = |rise: f64, duration: f64| {
        format!("history = {{ shape = \"triangle\", rise = {rise}, duration = {duration} }}")
    };
    let (short, long) = (load("short", &pulse(0.01, 0.02)), load("long", &pulse(0.5, 1.0)));
    let always = load("always", "permanent = true");
    let body = "[body]\nwidth = 2\nheight = 3\nmass = 5000\nfriction = 0.3\n";
    let only =
        |name: &str| format!("[[combination]]\nname = \"{name}\"\nfactors = {{ {name} = 1, always = 0 }}\n");
    // F = F₀ t/r up to r and falls as fast; R = μmg; s = F₀/R; while it slides m S'' = F − R.
    let slide = |duration: f64| {
        let (m, r, f) = (5000.0, 0.3 * 5000.0 * 9.81, 25_000.0);
        let s: f64 = f / r;
        let root = 2f64.sqrt();
        let reduced = if s <= 1.0 + 1.0 / root {
            (0.25 + root / 6.0) * (s - 1.0).powi(3) / (s * s)
        } else {
            (s - 1.0).powi(2) / 8.0 - 1.0 / (96.0 * s * s)
        };
        reduced * r * duration * duration / m
    };
    for loads in [[&always, &short, &long], [&long, &short, &always], [&short, &always, &long]] {
        let text = format!("{body}{}{}{}{}{}", loads[0], loads[1], loads[2], only("long"), only("short"));
        let answers = follow(&text);
        let of = |name: &str| {
            let found = answers.iter().find(|followed| followed.case.situation.as_deref() == Some(name));
            -found.unwrap().outcome.slide
        };
        close(of("long"), slide(1.0), 1e-9);
        close(of("short"), slide(0.02), 1e-9);
        close(of("long"), 0.1691, 1e-3);
    }
}

/// Whatever TOML allows says the same: dotted keys, braces, headers, and a note that looks like a header.
#[test]
fn every_spelling_of_toml_says_the_same() {
    let body = "[body]\nwidth = 2\nheight = 3\nmass = 5000\nfriction = 0.3\n";
    let pulse = "shape = \"triangle\", rise = 0.5, duration = 1, peak = 1.1";
    let load = format!("[[load]]\nforce = 25000\nelevation = 1.2\nhistory = {{ {pulse} }}\n");
    let plain = follow(&format!("{body}{load}[motion]\nt_max = 3\n"));
    let dotted =
        "history.shape = \"triangle\"\nhistory.rise = 0.5\nhistory.duration = 1\nhistory.peak = 1.1\n";
    let spellings = [
        format!("motion.t_max = 3\n{body}{load}"),
        format!("motion = {{ t_max = 3 }}\n{body}{load}"),
        format!("{body}[[load]]\nforce = 25000\nelevation = 1.2\n{dotted}[motion]\nt_max = 3\n"),
        format!(
            "note = \"\"\"\na line\n[motion]\nanother\n[[load.history]]\n\"\"\"\n{body}{load}[motion]\nt_max = 3\n"
        ),
    ];
    for text in spellings {
        assert_eq!(follow(&text)[0], plain[0], "{text}");
    }
    // A case that says nothing of time may have such a note as well.
    let still = format!("note = \"\"\"\n[motion]\n\"\"\"\n{body}[[load]]\nforce = 1\nelevation = 1\n");
    assert!(CaseFile::parse("case.toml", &still).unwrap().case().is_ok());
}

/// A pressure acts on its own wall and turns with it; a force at the same place keeps its direction. While the body has not turned both
/// are one, and the wrench of the situation is that of the problem in time at any pose.
#[test]
fn a_pressure_is_that_of_its_own_wall() {
    let body = "[body]\nwidth = 2\nheight = 3\nmass = 5000\nfriction = 0.9\n";
    let pressure = |face: &str| {
        format!(
            "[[pressure]]\nface = \"{face}\"\nelevation = [0, 3]\npressure = [6000, 2000]\npermanent = true\n\
             [motion.base]\nhorizontal = {{ shape = \"half-sine\", peak = \"5 m/s2\", duration = 0.5 }}\n"
        )
    };
    // (6 + 2)/2 · 3 = 12 kN, at (6 · 3²/6 + 2 · 3²/3)/12 = 1.25 m above the base.
    for (face, side, towards) in [("left", -1.0, 1.0), ("right", 1.0, -1.0)] {
        let case = &motions(&format!("{body}{}", pressure(face)), &no_file).unwrap()[0];
        let [load] = &case.problem.loads[..] else { panic!("{:?}", case.problem.loads) };
        close(load.direction[0], towards * 12_000.0 / 5000.0, 1e-12);
        assert_eq!((load.direction[1], load.follows), (0.0, true));
        assert_eq!(load.at[0], side);
        close(load.at[1], 1.25 - 1.5, 1e-12);
    }
}

/// Water whose mass alone is given pushes a shaken body nobody knows where: its height is asked for, and with it a low body slides by
/// D k₀ T²/(2 R), D = (m + m_a) k₀ − R over (m + m_a), R = μ m g.
#[test]
fn shaken_water_is_never_left_out() {
    let text = |water: &str| {
        format!(
            "[body]\nwidth = 40\nheight = 1\nmass = 50000\nfriction = 0.4\n[added_mass]\nmass = 30000\n{water}[motion.base]\n\
             horizontal = {{ shape = \"rect\", peak = \"6 m/s2\", duration = 0.2 }}\n"
        )
    };
    let error = motions(&text(""), &no_file).unwrap_err().to_string();
    assert!(error.contains("30000 kg of water"), "{error}");
    let (k, t) = (6.0, 0.2);
    let r = 0.4 * 50e3 * 9.81 / 80e3;
    close(-follow(&text("elevation = 0.4\n"))[0].outcome.slide, (k - r) * k * t * t / (2.0 * r), 1e-9);
}

/// An [earthquake] beside a base that moves is refused, and so is it in every face that answers such a case.
#[test]
fn shaken_once_only() {
    let text = "[body]\nwidth = 1\nheight = 2\nmass = 5000\nfriction = 0.5\n[earthquake]\nhorizontal = \"0.1 g\"\n[motion.base]\n\
        horizontal = { shape = \"half-sine\", peak = \"0.3 g\", duration = 1 }\n";
    let file = CaseFile::parse("case.toml", text).unwrap();
    for error in [file.motions().map(|_| ()), file.case().map(|_| ()), file.first_instant().map(|_| ())] {
        assert!(error.unwrap_err().to_string().contains("counts the same shaking twice"));
    }
}

/// A record in g moves a block in pure numbers only with what g is in them; a record of zeros is scaled to nothing, and nothing to zero.
#[test]
fn records_that_say_too_little_are_refused() {
    let at2 = "PEER\nname\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 4, DT= .5 SEC\n 0.0 0.4 -0.3 0.0\n";
    let with = |base: &str, record: &str| {
        let block = "[block]\nb1 = 1\nb2 = 1\nd = 3\nmu_s = 0.8\ngravity = 9.81\n[motion.base]\n";
        let base = format!("{block}horizontal = {{ shape = \"file\", file = \"r\", {base} }}\n");
        motions(&base, &|_| Ok(record.to_owned())).map_err(|error| standfast_cases::report(&error))
    };
    let said = with("start = 0", at2).unwrap_err();
    assert!(said.contains("in units of g") && said.contains("factor"), "{said}");
    let moved = with("factor = 9.81", at2).unwrap();
    close(moved[0].problem.base.horizontal.as_ref().unwrap().peak(), 0.4 * 9.81, 1e-12);
    let said = with("target_peak = 0", at2).unwrap_err();
    assert!(said.contains("`target_peak` is 0; expected another number than zero"), "{said}");
    let said = with("target_peak = 1", "t,a\n0,0\n1,0\n2,0\n").unwrap_err();
    assert!(said.contains("zero throughout"), "{said}");
}

/// The warning that an impulse acts beside the base stands where it does: a block that sticks keeps r = (ρ² + d² − b²)/(ρ² + d² + b²) of its
/// rate if the impulse acts at the corner itself, which of 1 by 3 is 0.85; for less it acts farther out.
#[test]
fn an_impulse_beside_the_base_is_warned_of() {
    for (ratio, beside) in [(0.8, true), (0.8499, true), (0.8501, false), (0.9, false)] {
        let text = format!(
            "[block]\nb1 = 1\nb2 = 1\nd = 3\nmu_s = 20\ngravity = 1\n[motion]\nimpact = {{ law = \"ratio\", ratio = {ratio} }}\n\
             initial = {{ theta = 0.02 }}\nt_max = 2\n"
        );
        let answers = follow(&text);
        assert!(answers[0].outcome.impacts > 0);
        let warned = answers[0].warnings.iter().any(|warning| warning.name == "impulse-beside-base");
        assert_eq!(warned, beside, "{ratio}");
    }
}

/// A motion that the time cuts off before its loads end is not at rest, whatever the body does then; the words say how far they go on.
#[test]
fn a_motion_that_is_cut_off_is_not_at_rest() {
    let text = |t_max: &str| {
        format!(
            "[block]\nb1 = 1\nb2 = 1\nd = 0.5\nmu_s = 0.3\ngravity = 1\n[motion]\nt_max = {t_max}\n\
             [motion.base]\nhorizontal = {{ shape = \"half-sine\", peak = 0.6, start = 5, duration = 1 }}\n"
        )
    };
    let follow = |t_max: &str| {
        let file = CaseFile::parse("case.toml", &text(t_max)).unwrap();
        let answers = FollowedMotion::of_file(&file, &Follow::default()).unwrap();
        let words = answers.summary().unwrap().answer;
        (answers.into_iter().next().unwrap().outcome, words)
    };
    let (before, words) = follow("2");
    assert!(!before.at_rest() && before.t_rest.is_none() && before.loads_end == 6.0);
    assert_eq!(words, "The body stays at rest until t = 2; the loads go on to t = 6.");
    let (amid, words) = follow("5.5");
    assert!(
        !amid.at_rest()
            && words.contains("still moves at t = 5.5, when the time is up; the loads go on to t = 6."),
        "{words}"
    );
    let (whole, words) = follow("50");
    assert!(whole.at_rest() && whole.t_rest.is_some_and(|t| t > 5.0) && !words.contains("go on"), "{words}");
}
