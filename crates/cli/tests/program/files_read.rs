//! Files that a run has read are not written over, under whatever name.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

const RECORD: &str = "time_s,a_g\n0,0\n0.25,0.5\n0.5,-0.5\n0.75,0\n";
const TABLE: &str = "body.width\n0.5\n0.6\n";

/// A body on a base that moves as the record says.
fn case(record: &str) -> String {
    format!(
        "[body]\nwidth = 0.5\nheight = 2\ndensity = 2500\nfriction = 0.6\n\
         [motion.base]\nhorizontal = {{ shape = \"file\", file = \"{record}\" }}\n"
    )
}

fn random(record: &str) -> String {
    let random = format!("[random]\nrecords = [\"{record}\"]\n");
    case(record) + &random + "friction = { normal = { mean = 0.6, sd = 0.05 }, lower = 0 }\n"
}

fn standfast(here: &Path, arguments: &[&str]) -> Output {
    let mut program = Command::new(env!("CARGO_BIN_EXE_standfast"));
    program.args(arguments).current_dir(here).output().expect("the program starts")
}

/// Every file of the folder, by name.
fn contents(here: &Path) -> Vec<(String, String)> {
    let files = fs::read_dir(here).expect("a folder").map(|entry| entry.expect("a file"));
    let text = |path| fs::read_to_string(path).expect("a file");
    let mut all: Vec<_> =
        files.map(|file| (file.file_name().to_string_lossy().into_owned(), text(file.path()))).collect();
    all.sort();
    all
}

/// A case in `case`, its record in `record` and a table: what the command writes over is refused as `what`.
fn refused(case: (&str, &str), record: &str, command: &str, what: &str) {
    let folder = tempfile::tempdir().expect("a folder");
    let here = folder.path();
    for (name, text) in [case, (record, RECORD), ("t.csv", TABLE)] {
        fs::write(here.join(name), text).expect("a file");
    }
    #[cfg(unix)]
    {
        fs::hard_link(here.join(record), here.join("hard.csv")).expect("a link");
        std::os::unix::fs::symlink(record, here.join("soft.csv")).expect("a link");
    }
    let before = contents(here);
    let output = standfast(here, &command.split(' ').collect::<Vec<_>>());
    let said = String::from_utf8_lossy(&output.stderr).replace("\n       ", " ");
    assert_eq!(output.status.code(), Some(1), "{command}: {said}");
    assert!(said.contains(&format!("cannot write over {what}")), "{command}: {said}");
    let after: Vec<_> = contents(here).into_iter().filter(|file| before.contains(file)).collect();
    assert_eq!(before, after, "{command}");
}

#[test]
fn no_command_writes_over_the_record_it_read() {
    let of = |record: &'static str, command: &str| {
        refused(("c.toml", &case(record)), record, command, &format!("the record {record}"));
    };
    of("c.svg", "assess c.toml");
    of("c-motion.svg", "simulate c.toml");
    of("r.csv", "simulate c.toml --no-figures --series r.csv --dt 0.1");
    of("r.csv", "simulate c.toml --no-figures --copies 2 --csv r.csv");
    of("r.csv", "spectrum c.toml --kind newmark --csv r.csv");
    of("c-newmark.svg", "spectrum c.toml --kind newmark");
    of("r.html", "sheet c.toml -o r.html");
    of("r.csv", "design c.toml --vary width --target factor=0.3 --and friction -o r.csv");
    of("r.svg", "design c.toml --vary width --target factor=0.3 --and friction -o x.csv -o r.svg");
    of("r.csv", "batch t.csv --case c.toml -o r.csv");
    let of = |record: &'static str, command: &str| {
        refused(("c.toml", &random(record)), record, command, &format!("the record {record}"));
    };
    of("r.csv", "probability c.toml --no-figures --draws r.csv --samples 16");
    of("c-modes.svg", "probability c.toml --samples 16");
}

#[cfg(unix)]
#[test]
fn a_link_to_a_record_is_the_record() {
    for (link, folder) in [("hard.csv", ""), ("soft.csv", ""), ("soft.csv", "./"), ("r.csv", "./")] {
        let command = format!("spectrum c.toml --kind newmark --csv {folder}{link}");
        let what =
            format!("the record r.csv, which was read for this answer; {folder}{link} is the same file");
        refused(("c.toml", &case("r.csv")), "r.csv", &command, &what);
    }
}

#[test]
fn no_command_writes_over_the_case_it_read() {
    let of = |name: &str, command: &str| {
        refused((name, &case("r.csv")), "r.csv", command, &format!("the case file {name}"));
    };
    of("c.svg", "assess c.svg");
    of("c.csv", "simulate c.csv --no-figures --series c.csv --dt 0.1");
    of("c.csv", "spectrum c.csv --kind newmark --csv c.csv");
    of("c.html", "sheet c.html -o c.html");
    of("c.csv", "design c.csv --vary width --target factor=0.3 --and friction -o c.csv");
    of("c.toml", "batch t.csv --case c.toml -o c.toml --output-format csv");
    let of = |name: &str, command: &str| {
        let text = random("r.csv");
        refused((name, &text), "r.csv", command, &format!("the case file {name}"));
    };
    of("c.csv", "probability c.csv --no-figures --draws c.csv --samples 16");
    let still = "[body]\nwidth = 0.5\nheight = 2\ndensity = 2500\nfriction = 0.6\n[[load]]\nforce = 1e3\nelevation = 1\n";
    refused(
        ("c.toml", still),
        "r.csv",
        "batch t.csv --case c.toml -o c.toml --output-format csv",
        "the case file c.toml",
    );
    refused(
        ("t.svg", still),
        "r.csv",
        "design t.svg --vary width --target rest --and friction -o t.svg",
        "the case file t.svg",
    );
}

/// Tables may be replaced by their own answer, as promised; those of motions too.
#[test]
fn a_table_may_be_replaced_by_its_answer() {
    let folder = tempfile::tempdir().expect("a folder");
    let here = folder.path();
    fs::write(here.join("c.toml"), case("r.csv")).expect("a file");
    fs::write(here.join("r.csv"), RECORD).expect("a file");
    fs::write(here.join("t.csv"), TABLE).expect("a file");
    let output = standfast(here, &["batch", "t.csv", "--case", "c.toml", "-o", "t.csv"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(fs::read_to_string(here.join("t.csv")).expect("a file").starts_with("body.width,"));
}
