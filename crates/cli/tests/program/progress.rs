//! Long work: the bar on a terminal, and what an interrupt leaves.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

fn example(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name)
}

/// Every kind of work that takes far longer than a test, in a folder where it would write; `{}` is the case.
const LONG: [(&str, &str); 2] = [
    (
        "motion/statue-earthquake.toml",
        "spectrum {} --size 1,9,2000 --slenderness 2,9,2000 --csv points.csv -o figures",
    ),
    (
        "motion/statue-earthquake.toml",
        "simulate {} --strength 10000 --series series.csv --dt 0.01 -o figures",
    ),
];

/// A command that is under way, its words caught.
fn begun(here: &Path, case: &str, words: &str) -> Child {
    let case = example(case);
    let words = words.split(' ').map(|word| if word == "{}" { case.as_os_str() } else { word.as_ref() });
    let mut command = Command::new(env!("CARGO_BIN_EXE_standfast"));
    command.args(words).current_dir(here).stdout(Stdio::piped()).stderr(Stdio::piped());
    command.spawn().expect("the program starts")
}

/// Interrupted, long work ends at once, says so, and leaves no file; without a terminal it had shown no bar.
#[cfg(unix)]
#[test]
fn interrupted_work_leaves_nothing() {
    for (case, words) in LONG {
        let directory = tempfile::tempdir().expect("a directory");
        let child = begun(directory.path(), case, words);
        std::thread::sleep(Duration::from_secs(2));
        let interrupt = Command::new("kill").args(["-INT", &child.id().to_string()]).status().expect("kill");
        assert!(interrupt.success());
        let began = Instant::now();
        let output = child.wait_with_output().expect("an end");
        assert_eq!(output.status.code(), Some(130), "{words}");
        assert!(began.elapsed() < Duration::from_secs(10), "{words}: {:?}", began.elapsed());
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(said.starts_with("interrupted at ") && said.ends_with(" %; nothing was written\n"), "{said}");
        assert!(!said.contains('\u{1b}') && said.lines().count() == 1, "{said}");
        assert_eq!(fs::read_dir(directory.path()).expect("a folder").count(), 0, "{words}");
    }
}

/// A probability is answered as it is by then when it is interrupted, and what it is asked to write is written whole; interrupted again it leaves
/// nothing.
#[cfg(unix)]
#[test]
fn an_interrupted_probability_is_answered() {
    let words = "probability {} --samples 500000000 --precision 0.00001 --draws draws.csv --no-figures";
    for times in [1, 2] {
        let directory = tempfile::tempdir().expect("a directory");
        let child = begun(directory.path(), "goda-2000-random.toml", words);
        std::thread::sleep(Duration::from_secs(2));
        for _ in 0..times {
            let interrupt = Command::new("kill").args(["-INT", &child.id().to_string()]).status();
            assert!(interrupt.expect("kill").success());
            // Two that come at once are one.
            std::thread::sleep(Duration::from_millis(if times == 1 { 0 } else { 5 }));
        }
        let began = Instant::now();
        let output = child.wait_with_output().expect("an end");
        assert!(began.elapsed() < Duration::from_secs(20), "{:?}", began.elapsed());
        let [answer, said] = [&output.stdout, &output.stderr].map(|bytes| String::from_utf8_lossy(bytes));
        assert!(said.starts_with("interrupted at "), "{said}");
        assert!(
            said.contains("the answer follows as precise as it is; interrupt again to end without one"),
            "{said}"
        );
        let written = fs::read_dir(directory.path()).expect("a folder").count();
        match output.status.code() {
            Some(0) => {
                assert!(answer.contains("does not stay at rest in one event is 0.025"), "{answer}");
                assert!(answer.contains("Not as precise as asked"), "{answer}");
                assert_eq!(written, 1);
            }
            // It may have been answered before the second came.
            code => assert!(times == 2 && code == Some(130) && written == 0 && answer.is_empty(), "{said}"),
        }
    }
}

/// On a terminal there is a bar, which goes away before the answer. The program `script` is a terminal.
#[cfg(target_os = "linux")]
#[test]
fn a_terminal_shows_a_bar() {
    let directory = tempfile::tempdir().expect("a directory");
    let command = format!(
        "{} probability {} --no-figures --samples 262144",
        env!("CARGO_BIN_EXE_standfast"),
        example("goda-2000-storm.toml").display()
    );
    let mut terminal = Command::new("script");
    terminal.args(["-qec", &command, "/dev/null"]).current_dir(directory.path()).stdin(Stdio::null());
    let Ok(output) = terminal.output() else {
        eprintln!("skipped: there is no `script` to be a terminal");
        return;
    };
    let said = String::from_utf8_lossy(&output.stdout);
    let bar = said.find("% ").unwrap_or_else(|| panic!("no bar: {said}"));
    assert!(said[bar..].contains(" left"), "{said}");
    // The answer stands behind the bar, on lines of its own.
    let answer = said.rfind("In 50 years").unwrap_or_else(|| panic!("no answer: {said}"));
    assert!(said.rfind('░').is_some_and(|last| last < answer), "{said}");
}
