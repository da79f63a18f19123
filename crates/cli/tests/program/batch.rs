//! Files that `standfast batch` leaves behind when something goes wrong, and its use of files.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn batch(directory: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_standfast"))
        .arg("batch")
        .args(arguments)
        .current_dir(directory)
        .output()
        .expect("the program starts")
}

/// The names of the files in a directory, in order.
pub fn files(directory: &Path) -> Vec<String> {
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

#[cfg(feature = "tables")]
#[test]
fn an_error_leaves_no_file_of_any_format() {
    let directory = tempfile::tempdir().expect("a directory");
    let here = directory.path();
    let table = "gamma,k_prime,k,mu\n".to_owned() + &"1,1,2,5\n".repeat(50_000);
    fs::write(here.join("points.csv"), &table).expect("a file");
    fs::write(here.join("wrong.csv"), table + "1,1,2,-5\n").expect("a file");
    for name in ["out.parquet", "out.arrow", "out.arrows"] {
        assert_eq!(batch(here, &["wrong.csv", "-o", name]).status.code(), Some(1), "{name}");
        assert_eq!(files(here), ["points.csv", "wrong.csv"], "{name}");
        assert_eq!(batch(here, &["points.csv", "-o", name]).status.code(), Some(0), "{name}");
        assert_eq!(files(here), [name, "points.csv", "wrong.csv"]);
        fs::remove_file(here.join(name)).expect("removed");
    }
}

#[cfg(all(target_os = "linux", feature = "tables"))]
#[test]
fn a_full_disk_is_reported_in_every_format() {
    let folder = tempfile::tempdir().expect("a folder");
    let table = "gamma,k_prime,k,mu\n".to_owned() + &"1,1,2,5\n".repeat(50_000);
    fs::write(folder.path().join("points.csv"), table).expect("a file");
    assert!(
        batch(folder.path(), &["points.csv", "-o", "points.parquet", "--columns", "xi"]).status.success()
    );
    for format in ["csv", "parquet", "arrow", "arrows"] {
        let arguments =
            ["points.parquet", "-o", "/dev/full", "--output-format", format, "--columns", "mode,f_x"];
        let output = batch(folder.path(), &arguments);
        assert_eq!(output.status.code(), Some(1));
        let words = String::from_utf8_lossy(&output.stderr);
        assert!(words.contains("cannot write /dev/full: No space left on device"), "{format}: {words}");
    }
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

/// A run that does not end, because its table does not, and has begun to write.
#[cfg(unix)]
fn endless(directory: &Path) -> (std::process::Child, std::process::ChildStdin) {
    use std::io::Write;
    use std::process::Stdio;
    use std::time::Duration;

    let mut child = Command::new(env!("CARGO_BIN_EXE_standfast"))
        .args(["batch", "-", "-o", "out.csv"])
        .current_dir(directory)
        .stdin(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut input = child.stdin.take().expect("a pipe");
    input.write_all(b"gamma,k_prime,k,mu\n1,1,2,5\n").expect("a table");
    // An unfinished file may have no name, but is open.
    let open = |id: u32| {
        let files = fs::read_dir(format!("/proc/{id}/fd")).into_iter().flatten().flatten();
        files.filter_map(|file| fs::read_link(file.path()).ok()).any(|file| file.starts_with(directory))
    };
    while files(directory).is_empty() && !open(child.id()) {
        std::thread::sleep(Duration::from_millis(5));
    }
    std::thread::sleep(Duration::from_millis(200));
    (child, input)
}

#[cfg(unix)]
#[test]
fn an_interrupted_run_leaves_nothing_behind() {
    let directory = tempfile::tempdir().expect("a directory");
    let here = directory.path().canonicalize().expect("a directory");
    let (mut child, _input) = endless(&here);
    let interrupt = Command::new("kill").args(["-INT", &child.id().to_string()]).status().expect("kill");
    assert!(interrupt.success());
    assert_eq!(child.wait().expect("an end").code(), Some(130));
    assert!(files(&here).is_empty());
}

/// Runs that are killed leave nothing behind if the system has files without a name.
#[cfg(target_os = "linux")]
#[test]
fn a_killed_run_leaves_nothing_behind() {
    use std::os::unix::fs::OpenOptionsExt;

    let directory = tempfile::tempdir().expect("a directory");
    let here = directory.path().canonicalize().expect("a directory");
    // O_TMPFILE: O_DIRECTORY, whose number differs, with a bit of its own.
    let flag =
        if cfg!(any(target_arch = "aarch64", target_arch = "arm")) { 0o20_040_000 } else { 0o20_200_000 };
    if fs::OpenOptions::new().write(true).custom_flags(flag).open(&here).is_err() {
        eprintln!("skipped: {} has no files without a name", here.display());
        return;
    }
    let (mut child, _input) = endless(&here);
    child.kill().expect("killed");
    child.wait().expect("an end");
    assert_eq!(files(&here), [""; 0]);
}

/// A new file is an ordinary one, and a replaced one keeps its permissions.
#[cfg(unix)]
#[test]
fn permissions_are_those_of_ordinary_files() {
    use std::os::unix::fs::PermissionsExt;

    let directory = tempfile::tempdir().expect("a directory");
    let here = directory.path();
    fs::write(here.join("points.csv"), "gamma,k_prime,k,mu\n1,1,2,5\n").expect("a file");
    let mode = |name: &str| fs::metadata(here.join(name)).expect("a file").permissions().mode() & 0o777;
    assert!(batch(here, &["points.csv", "-o", "out.csv"]).status.success());
    assert_eq!(mode("out.csv"), mode("points.csv"));
    fs::set_permissions(here.join("out.csv"), fs::Permissions::from_mode(0o604)).expect("permissions");
    assert!(batch(here, &["points.csv", "-o", "out.csv"]).status.success());
    assert_eq!(mode("out.csv"), 0o604);
    assert_eq!(files(here), ["out.csv", "points.csv"]);
}
