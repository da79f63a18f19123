//! Tables against scalar calls of the library, and what is left behind when something goes wrong.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use standfast::Point;
use standfast::contact::{Block, Wrench, solve};
use standfast_cli::batch::{BatchError, OnError, Options, Place, Problem, run};

/// Numbers from 0 to 1, the same in every run.
fn random() -> impl FnMut() -> f64 {
    let mut state: u64 = 2026;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    }
}

#[test]
fn every_row_is_a_scalar_call() {
    let mut random = random();
    let mut points = Vec::new();
    let mut table = String::from("name,mu,k_prime,\"a, b\",gamma,k\n");
    for i in 0..2000 {
        let gamma = 10_f64.powf(2.0 * random() - 1.0);
        let k_prime = 3.0 * random() - 1.8;
        let k = 6.0 * random();
        let mu = 4.0 * random();
        table += &format!("\"row {i}, \"\"so\"\"\",{mu},{k_prime},,{gamma},{k}\n");
        points.push(Point::new(gamma, k_prime, k, mu).expect("a point"));
    }
    let mut answer = Vec::new();
    let summary = run(table.as_bytes(), &mut answer, &Options::new("table")).expect("a table");
    assert_eq!((summary.rows, summary.bad), (2000, 0));

    let mut reader = csv::Reader::from_reader(&answer[..]);
    let header = reader.headers().expect("a header").clone();
    assert_eq!(
        header.iter().collect::<Vec<_>>().join("|"),
        "name|mu|k_prime|a, b|gamma|k|mode|unique|also|x_ddot|y_ddot|theta_ddot|f_x|f_y|xi"
    );
    let mut seen = std::collections::BTreeSet::new();
    let mut rows = 0;
    for (i, (record, point)) in reader.records().zip(&points).enumerate() {
        let record = record.expect("a row");
        assert_eq!(&record[0], format!("row {i}, \"so\""));
        assert_eq!(record[4].parse(), Ok(point.gamma()));
        assert_eq!(&record[6], point.mode().symbol());
        assert_eq!(&record[7], point.is_unique().to_string());
        assert_eq!(&record[8], point.others().to_string());
        let motion = point.motion();
        let expected = [motion.x_ddot, motion.y_ddot, motion.theta_ddot, motion.f_x, motion.f_y, motion.xi];
        let found: Vec<f64> = record.iter().skip(9).map(|field| field.parse().expect("a number")).collect();
        assert_eq!(found, expected);
        seen.insert(point.mode().symbol());
        rows += 1;
    }
    assert_eq!(rows, 2000);
    assert_eq!(seen.into_iter().collect::<Vec<_>>().join(" "), "RE RO RO' SL SRO'- SRO+ SRO-");
}

#[test]
fn every_wrench_is_a_scalar_call() {
    let mut random = random();
    let mut table = String::from("m,p,x,id,mu_k,mu_s,m_y,m_x,rho2,d,b2,b1\n");
    let mut answers = Vec::new();
    for i in 0..2000 {
        let mut between = |low: f64, high: f64| low + (high - low) * random();
        let [b1, b2, d] = [(); 3].map(|()| between(0.3, 2.0));
        let (rho2, m_x, m_y) = (between(0.2, 2.0), between(1.0, 2.0), between(1.0, 1.5));
        let mu_s = between(0.0, 3.0);
        let mu_k = if i % 2 == 0 { mu_s } else { mu_s * between(0.5, 1.0) };
        let wrench = Wrench { x: between(-3.0, 3.0), p: between(-0.3, 1.5), m: between(-3.0, 3.0) };
        let Wrench { x, p, m } = wrench;
        table += &format!("{m},{p},{x},row {i},{mu_k},{mu_s},{m_y},{m_x},{rho2},{d},{b2},{b1}\n");
        answers.push(solve(&Block { b1, b2, d, rho2, m_x, m_y, mu_s, mu_k }, &wrench).expect("an answer"));
    }
    let options = Options { problem: Problem::Wrench, ..Options::new("table") };
    let mut output = Vec::new();
    let summary = run(table.as_bytes(), &mut output, &options).expect("a table");
    assert_eq!((summary.rows, summary.bad), (2000, 0));

    let mut reader = csv::Reader::from_reader(&output[..]);
    let header = reader.headers().expect("a header").iter().skip(12).collect::<Vec<_>>().join(",");
    assert_eq!(header, "modes,mode,x_ddot,y_ddot,theta_ddot,f_x,f_y,xi");
    let mut seen = std::collections::BTreeSet::new();
    for (record, answer) in reader.records().zip(&answers) {
        let record = record.expect("a row");
        assert_eq!(&record[12], answer.modes.to_string());
        let mode = answer.mode().expect("a mode");
        assert_eq!(&record[13], mode.symbol());
        let motion = answer.motion(mode).expect("a motion");
        let expected = [motion.x_ddot, motion.y_ddot, motion.theta_ddot, motion.f_x, motion.f_y, motion.xi];
        let found: Vec<f64> = record.iter().skip(14).map(|field| field.parse().expect("a number")).collect();
        assert_eq!(found, expected);
        seen.insert(mode.symbol());
    }
    assert_eq!(seen.len(), 10, "{seen:?}");
}

#[test]
fn lines_are_counted_through_blank_lines_quoted_fields_and_both_line_ends() {
    for end in ["\n", "\r\n"] {
        for mark in ["", "\u{feff}"] {
            let lines =
                ["k,mu,gamma,k_prime,n", "1,1,1,1,\"a", "b\"", "", "", "1,1,1,1,x", "1,-1,1,1,x", "", "1,1"];
            for (last, expected) in [(7, 7), (9, 7)] {
                for tail in ["", end] {
                    let table = mark.to_owned() + &lines[..last].join(end) + tail;
                    match run(table.as_bytes(), Vec::new(), &Options::new("t")) {
                        Err(BatchError::Row { place, .. }) => {
                            assert_eq!(place, Place::Line(expected), "{table:?}")
                        }
                        other => panic!("{other:?}"),
                    }
                }
            }
        }
    }
}

#[test]
fn bad_rows_may_stay_empty() {
    let table = "gamma,k_prime,k,mu,id\n0,1,1,1,a\n1,1,2,5,b\n1,1\n";
    let options = Options { on_error: OnError::Null, ..Options::new("points.csv") };
    let mut answer = Vec::new();
    let summary = run(table.as_bytes(), &mut answer, &options).expect("a table");
    assert_eq!((summary.rows, summary.bad), (3, 2));
    let first = summary.first.expect("a bad row").to_string();
    assert_eq!(
        first,
        "points.csv, line 2, column gamma: \"0\"; expected a number above zero, from 1e-50 to 1e50"
    );
    let lines: Vec<_> = std::str::from_utf8(&answer).expect("text").lines().collect();
    assert_eq!(lines[1], "0,1,1,1,a,,,,,,,,,");
    assert_eq!(lines[2], "1,1,2,5,b,RO,true,,-1.125,1.125,1.125,0.875,2.125,-1.0");
    assert_eq!(lines[3], "1,1,,,,,,,,,,,,");
}

fn batch(directory: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_standfast"))
        .arg("batch")
        .args(arguments)
        .current_dir(directory)
        .output()
        .expect("the program starts")
}

fn files(directory: &Path) -> Vec<String> {
    let mut names: Vec<_> = fs::read_dir(directory)
        .expect("a directory")
        .map(|entry| entry.expect("a file").file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

#[test]
fn on_error_the_output_is_untouched_and_nothing_is_left_behind() {
    let directory = tempfile::tempdir().expect("a directory");
    let here = directory.path();
    // Long enough that part of it has been written when the bad row comes.
    let table = "gamma,k_prime,k,mu\n".to_owned() + &"1,1,2,5\n".repeat(50_000) + "1,1,2,-5\n";
    fs::write(here.join("points.csv"), table).expect("a file");

    let output = batch(here, &["points.csv", "-o", "out.csv"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&output.stderr).contains("points.csv, line 50002, column mu: \"-5\""));
    assert_eq!(files(here), ["points.csv"]);

    fs::write(here.join("out.csv"), "what was there").expect("a file");
    assert_eq!(batch(here, &["points.csv", "-o", "out.csv"]).status.code(), Some(1));
    assert_eq!(fs::read_to_string(here.join("out.csv")).expect("a file"), "what was there");
    assert_eq!(files(here), ["out.csv", "points.csv"]);

    let output = batch(here, &["points.csv", "-o", "out.csv", "--on-error", "null"]);
    assert_eq!(output.status.code(), Some(0));
    assert!(String::from_utf8_lossy(&output.stderr).starts_with("warning: 1 of 50001 rows without a result"));
    assert_eq!(fs::read_to_string(here.join("out.csv")).expect("a file").lines().count(), 50_002);
    assert_eq!(files(here), ["out.csv", "points.csv"]);
}

#[test]
fn the_table_may_be_replaced_by_its_answer() {
    let directory = tempfile::tempdir().expect("a directory");
    let here = directory.path();
    fs::write(here.join("points.csv"), "gamma,k_prime,k,mu\n1,1,2,5\n").expect("a file");
    assert!(batch(here, &["points.csv", "-o", "points.csv"]).status.success());
    let text = fs::read_to_string(here.join("points.csv")).expect("a file");
    assert!(text.ends_with("1,1,2,5,RO,true,,-1.125,1.125,1.125,0.875,2.125,-1.0\n"));
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_reported() {
    let directory = tempfile::tempdir().expect("a directory");
    let here = directory.path();
    fs::write(here.join("points.csv"), "gamma,k_prime,k,mu\n1,1,2,5\n").expect("a file");
    let output = batch(here, &["points.csv", "-o", "/dev/full"]);
    assert_eq!(output.status.code(), Some(1));
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(message.contains("cannot write /dev/full: No space left on device"), "{message}");
}

#[cfg(unix)]
#[test]
fn an_interrupted_run_leaves_nothing_behind() {
    use std::io::Write;
    use std::process::Stdio;
    use std::time::Duration;

    let directory = tempfile::tempdir().expect("a directory");
    let here = directory.path();
    let mut child = Command::new(env!("CARGO_BIN_EXE_standfast"))
        .args(["batch", "-", "-o", "out.csv"])
        .current_dir(here)
        .stdin(Stdio::piped())
        .spawn()
        .expect("the program starts");
    // The table never ends, so the run is under way as soon as there is a temporary file.
    let mut input = child.stdin.take().expect("a pipe");
    input.write_all(b"gamma,k_prime,k,mu\n1,1,2,5\n").expect("a table");
    while files(here).is_empty() {
        std::thread::sleep(Duration::from_millis(5));
    }
    std::thread::sleep(Duration::from_millis(200));
    let interrupt = Command::new("kill").args(["-INT", &child.id().to_string()]).status().expect("kill");
    assert!(interrupt.success());
    assert_eq!(child.wait().expect("an end").code(), Some(130));
    assert!(files(here).is_empty());
}
