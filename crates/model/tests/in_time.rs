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
    let last =
        format!("{BODY}[motion.base]\nhorizontal = {{ shape = \"half-sine\", peak = 3, duration = 1 }}");
    let lines = file(&last).lines_in_time().join("|");
    assert_eq!(lines, "[motion.base]|horizontal = { shape = \"half-sine\", peak = 3, duration = 1 }");
    assert_eq!(file(BODY).lines_in_time(), Vec::<&str>::new());
}

/// The sentence on the first instant says how the peaks act, and without its end nothing of a motion that is followed.
#[test]
fn the_first_instant_in_words() {
    let base = "[motion.base]\nhorizontal = { shape = \"half-sine\", peak = 3, duration = 1 }\n";
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
        "{BODY}[motion.base]\nhorizontal = {{ shape = \"half-sine\", peak = 3, duration = 1 }}\n\
         vertical = {{ shape = \"half-sine\", peak = 2, duration = 1 }}\n"
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
