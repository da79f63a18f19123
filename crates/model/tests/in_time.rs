//! What a file says of time: its lines, its first instant, and a base that is given beside it.

use standfast_model::{CaseFile, GivenBase, Key};
use standfast_motion::record::{Record, RecordUnit};

const BODY: &str = "[body]\nwidth = 2\nheight = 6\nmass = 24e3\nfriction = 0.3\n";

fn file(text: &str) -> CaseFile {
    CaseFile::parse("case.toml", text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn given(values: &[f64]) -> Option<Record> {
    let times = (0..values.len()).map(|i| i as f64 * 0.5).collect();
    Some(Record { times, values: values.to_vec(), unit: RecordUnit::Unnamed })
}

/// Of a file the lines that say how loads go with time, how the base moves and what is asked of the motion, headings of such tables among
/// them, without blanks; nothing of the body, and of other criteria nothing.
#[test]
fn lines_of_time() {
    let text = "title = \"A stone\"   # [motion]\n\n[body]\nwidth = 2\nheight = 6\nmass = 24e3\nfriction = 0.3\n\n\
                [[load]]\nforce = 30e3\nelevation = 4\nhistory = { shape = \"rect\",\n  duration = 0.4 }\n\n\
                [motion]\n\n  t_max = 9   # s\n[motion.impact]\nlaw = \"housner\"\n[criteria]\nSF_sliding = 1.2\nslide = 0.1\noverturned = false\n";
    assert_eq!(
        file(text).lines_in_time(),
        [
            "history = { shape = \"rect\",",
            "duration = 0.4 }",
            "[motion]",
            "t_max = 9   # s",
            "[motion.impact]",
            "law = \"housner\"",
            "slide = 0.1",
            "overturned = false",
        ]
    );
    // The last line need not end.
    let last = format!(
        "{BODY}[motion.base]\nhorizontal = {{ shape = \"half-sine\", peak = \"3 m/s2\", duration = 1 }}"
    );
    let lines = file(&last).lines_in_time().join("|");
    assert_eq!(
        lines,
        "[motion.base]|horizontal = { shape = \"half-sine\", peak = \"3 m/s2\", duration = 1 }"
    );
    assert_eq!(file(BODY).lines_in_time(), Vec::<&str>::new());
}

/// The sentence on the first instant says how the peaks act, and without its end nothing of a motion that is followed.
#[test]
fn the_first_instant_in_words() {
    let base = "[motion.base]\nhorizontal = { shape = \"half-sine\", peak = \"3 m/s2\", duration = 1 }\n";
    let first = file(&format!("{BODY}{base}")).first_instant().unwrap().unwrap();
    assert!(
        first.note.ends_with("the motion in time is what `standfast simulate` follows"),
        "{}",
        first.note
    );
    let instant = first.of_instant();
    assert!(first.note.starts_with(instant) && instant.starts_with("the peaks of the base's acceleration"));
    assert!(instant.ends_with("as if at rest until then"), "{instant}");
    assert_eq!(first.file.inputs().number(Key::Horizontal), Some(3.0));
    assert!(!first.file.is_in_time());
}

/// A base that is given moves a case that says nothing of time, and stands in the place of what another says of that direction alone.
#[test]
fn a_base_beside_the_case() {
    let shaken = [0.0, 2.5, -4.0, 0.0];
    let of = |text: &str, base: GivenBase| {
        let file = file(text).on_base(&base);
        assert!(file.is_in_time(), "{text}");
        let problem = file.motions().unwrap().remove(0).problem;
        [problem.base.horizontal, problem.base.vertical].map(|history| history.map(|history| history.peak()))
    };
    let sideways = || GivenBase { horizontal: given(&shaken), vertical: None };
    let upwards = || GivenBase { horizontal: None, vertical: given(&shaken) };
    let moving = format!(
        "{BODY}[motion.base]\nhorizontal = {{ shape = \"half-sine\", peak = \"3 m/s2\", duration = 1 }}\n\
         vertical = {{ shape = \"half-sine\", peak = \"2 m/s2\", duration = 1 }}\n"
    );
    let limited = format!("{BODY}[motion]\nt_max = 3\n");
    for text in [BODY, &limited] {
        assert_eq!(of(text, sideways()), [Some(4.0), None]);
        assert_eq!(of(text, upwards()), [None, Some(4.0)]);
    }
    assert_eq!(of(&moving, sideways()), [Some(4.0), Some(2.0)]);
    assert_eq!(of(&moving, upwards()), [Some(3.0), Some(4.0)]);
    assert_eq!(of(&moving, GivenBase::default()), [Some(3.0), Some(2.0)]);
}

/// A body's loads at their peaks: each but its own weight, with what the case has of it times the greatest of its history; and when to stop.
#[test]
fn loads_at_their_peaks() {
    let loads = "[[load]]\nname = \"wave\"\nforce = 30e3\nelevation = 4\nhistory = { shape = \"rect\", duration = 0.4, peak = 1.5 }\n\
                 [[load]]\nname = \"anchor\"\nforce = 5e3\nelevation = 3\npermanent = true\n";
    let text = format!("{BODY}{loads}[motion]\nt_max = 0.7\n");
    let case = file(&text).motions().unwrap().remove(0);
    let found: Vec<_> =
        case.peaks.iter().map(|peak| (peak.name.as_str(), peak.permanent, peak.wrench)).collect();
    // About the centre of mass, half way up; forces point to the left.
    let wrench =
        |force: f64, elevation: f64| standfast::Wrench { x: -force, p: 0.0, m: force * (elevation - 3.0) };
    assert_eq!(found, [("wave", false, wrench(45e3, 4.0)), ("anchor", true, wrench(5e3, 3.0))]);
    assert_eq!((case.problem.t_max, case.height, case.si, case.uplift), (Some(0.7), 6.0, true, false));
    assert_eq!(file(&format!("{BODY}{loads}")).motions().unwrap()[0].problem.t_max, None);
}

/// A block in pure numbers: twice as high as its centre of mass, uniform where both corners are as far as the unit, else with a radius of
/// gyration of its own; and beside nothing else.
#[test]
fn a_block_in_pure_numbers() {
    let text = |b1: f64, b2: f64, more: &str| {
        format!(
            "[block]\nb1 = {b1}\nb2 = {b2}\nd = 3\nmu_s = 0.4\ngravity = 1\n{more}[motion.base]\nhorizontal = {{ shape = \"rect\", peak = 1, duration = 1 }}\n"
        )
    };
    let case = file(&text(1.0, 1.0, "")).motions().unwrap().remove(0);
    assert_eq!((case.height, case.si, case.problem.block.rho2), (6.0, false, 10.0 / 3.0));
    for (b1, b2) in [(1.0, 1.2), (1.2, 1.0), (1.2, 1.2)] {
        let refused = file(&text(b1, b2, "")).motions().unwrap_err().to_string();
        assert!(refused.contains("rho2"), "{refused}");
        assert_eq!(file(&text(b1, b2, "rho2 = 4\n")).motions().unwrap()[0].problem.block.rho2, 4.0);
    }
    for beside in ["[water]\nlevel = 1\ndensity = 1000\n", "[criteria]\nSF_sliding = 1.2\n"] {
        let refused = file(&(text(1.0, 1.0, "") + beside)).motions().unwrap_err().to_string();
        assert!(refused.contains("[block]") || refused.contains("`block`"), "{refused}");
    }
}

/// A base is shaken beyond what grounds are from three times gravity on, and less than anybody feels under a hundredth of it.
#[test]
fn strong_and_weak_shaking() {
    let (strong, weak) = (Some("strong-earthquake"), Some("weak-earthquake"));
    for (gravity, peak, warned) in [
        (2.0, 6.0, None),
        (2.0, 6.1, strong),
        (0.5, 1.4, None),
        (0.5, 1.6, strong),
        (2.0, 0.021, None),
        (2.0, 0.019, weak),
        (2.0, 0.0, None),
    ] {
        let text = format!(
            "[block]\nb1 = 1\nb2 = 1\nd = 3\nmu_s = 0.4\ngravity = {gravity}\n[motion.base]\nhorizontal = {{ shape = \"rect\", peak = {peak}, duration = 1 }}\n"
        );
        let case = file(&text).motions().unwrap().remove(0);
        let found =
            case.warnings.iter().map(|warning| warning.name).find(|name| name.ends_with("-earthquake"));
        assert_eq!(found, warned, "{gravity} {peak}");
    }
}

/// Histories on springs are those of the springs, and of a motion where one is followed, which leaves the springs out and says so.
#[test]
fn histories_on_springs() {
    let text = format!(
        "{BODY}[ground]\nstiffness = 5e7\n[[load]]\nforce = 30e3\nelevation = 4\nhistory = {{ shape = \"rect\", duration = 0.4 }}\n"
    );
    let springs = file(&text);
    assert!(!springs.is_in_time() && springs.first_instant().unwrap().is_none());
    let case = springs.motions().unwrap().remove(0);
    assert_eq!(case.problem.loads.len(), 1);
    assert!(case.warnings.iter().any(|warning| warning.name == "ground-left-out"));
}
