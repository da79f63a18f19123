//! Calculation sheets as files: HTML always, PDF where there is a browser of the Chromium family.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use standfast_sheet::browser;

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

fn sheet(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_standfast"));
    command.arg("sheet").args(arguments).current_dir(ROOT);
    command
}

fn ended(output: &Output) -> String {
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// True if PDFs can be printed and read here; in CI they have to be.
fn prints() -> bool {
    let there = browser::find().is_ok() && Command::new("pdftotext").arg("-v").output().is_ok();
    assert!(
        there || std::env::var_os("CI").is_none_or(|ci| ci != "true"),
        "no browser or no pdftotext in CI"
    );
    if !there {
        eprintln!("skipped: no browser of the Chromium family, or no pdftotext");
    }
    there
}

fn text(pdf: &Path) -> String {
    let output = Command::new("pdftotext").args(["-layout"]).arg(pdf).arg("-").output().unwrap();
    ended(&output)
}

/// Words without the spaces that the layout puts between them.
fn words(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn a_printed_sheet_says_the_verdict_on_both_papers() {
    if !prints() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    for (paper, size) in [("a4", "594.96 x 841.92"), ("letter", "612 x 792")] {
        let pdf = folder.path().join(format!("{paper}.pdf"));
        let path = pdf.to_str().unwrap();
        let arguments =
            ["examples/caisson-in-air.toml", "--date", "2026-11-21", "--paper", paper, "-o", path];
        ended(&sheet(&arguments).output().unwrap());
        let text = words(&text(&pdf));
        for part in [
            "The body slides and rocks about O, the bottom left corner, which moves to the left (SRO-).",
            "holds by 0.01744",
            "2026-11-21",
            "page 1 of ",
            "caisson-in-air.toml",
            "7 Signatures",
        ] {
            assert!(text.contains(part), "{paper}: {part} in {text}");
        }
        let about = Command::new("pdfinfo").arg(&pdf).output().unwrap();
        assert!(ended(&about).contains(size), "{paper}");
    }
}

#[test]
fn the_same_case_and_date_print_the_same_bytes() {
    if !prints() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let bytes = ["one.pdf", "two.pdf"].map(|name| {
        let pdf = folder.path().join(name);
        ended(&sheet(&["examples/monument.toml", "-o", pdf.to_str().unwrap()]).output().unwrap());
        fs::read(pdf).unwrap()
    });
    assert!(bytes[0] == bytes[1]);
    // Nothing is left beside them.
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2);
}

#[test]
fn without_a_browser_nothing_is_written_and_the_error_says_where_one_was_looked_for() {
    let folder = tempfile::tempdir().unwrap();
    let pdf = folder.path().join("sheet.pdf");
    let arguments = ["examples/monument.toml", "-o", pdf.to_str().unwrap()];
    let named = sheet(&arguments).env("STANDFAST_BROWSER", "/no/such/browser").output().unwrap();
    let error = words(&String::from_utf8_lossy(&named.stderr));
    assert!(error.contains("STANDFAST_BROWSER is /no/such/browser, which is not a program"), "{error}");

    #[cfg(target_os = "linux")]
    {
        let none =
            sheet(&arguments).env("PATH", folder.path()).env_remove("STANDFAST_BROWSER").output().unwrap();
        let error = words(&String::from_utf8_lossy(&none.stderr));
        assert!(
            error.contains("none was found") && error.contains("chromium") && error.contains(".html"),
            "{error}"
        );
        assert_eq!(none.status.code(), Some(1));
    }
    // A program that prints nothing.
    #[cfg(unix)]
    {
        let silent = sheet(&arguments).env("STANDFAST_BROWSER", "true").output().unwrap();
        assert!(String::from_utf8_lossy(&silent.stderr).contains("printed nothing"));
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[test]
fn a_sheet_replaces_an_older_one_whole_and_no_case_file() {
    let folder = tempfile::tempdir().unwrap();
    let html = folder.path().join("sheet.html");
    fs::write(&html, "older").unwrap();
    let path = html.to_str().unwrap();
    let said = ended(&sheet(&["examples/monument.toml", "-o", path]).output().unwrap());
    assert_eq!(said, format!("Calculation sheet written to {path}\n"));
    let written = fs::read_to_string(&html).unwrap();
    assert!(written.starts_with("<!DOCTYPE html>") && written.ends_with("</html>"));

    let case = folder.path().join("case.html");
    fs::copy(Path::new(ROOT).join("examples/monument.toml"), &case).unwrap();
    let path = case.to_str().unwrap();
    let output = sheet(&[path, "-o", path]).output().unwrap();
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&output.stderr).contains("over the case file"));
    assert!(fs::read_to_string(&case).unwrap().starts_with("title"));
}

/// The headings of a page of HTML, as words.
fn headings(html: &str) -> Vec<String> {
    let inner = ["h2", "h3", "h4"].into_iter().flat_map(|name| {
        let (open, close) = (format!("<{name}"), format!("</{name}>"));
        let found = html.split(&open).skip(1).map(move |rest| rest.split(&close).next().unwrap().to_owned());
        found.collect::<Vec<_>>()
    });
    // Behind the tag itself and each one within.
    let bare = |inner: &str| -> String {
        inner.split('>').skip(1).map(|part| part.split('<').next().unwrap()).collect()
    };
    inner.map(|inner| words(&bare(&inner))).collect()
}

#[test]
fn no_printed_page_ends_with_a_heading() {
    if !prints() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let mut pages = 0;
    for case in ["goda-2000", "quay", "block-two-loads", "seismic-block"] {
        let example = format!("examples/{case}.toml");
        let [pdf, html] = ["pdf", "html"].map(|kind| folder.path().join(format!("{case}.{kind}")));
        for file in [&pdf, &html] {
            ended(&sheet(&[&example, "-o", file.to_str().unwrap()]).output().unwrap());
        }
        let headings = headings(&fs::read_to_string(&html).unwrap());
        assert!(headings.len() > 15, "{headings:?}");
        for page in text(&pdf).split('\u{c}').filter(|page| !page.trim().is_empty()) {
            let lines: Vec<_> = page.lines().map(words).filter(|line| !line.is_empty()).collect();
            let (footer, above) = (&lines[lines.len() - 1], &lines[lines.len() - 2]);
            assert!(footer.contains("page "), "{case}: {footer}");
            assert!(!headings.contains(above), "{case}, {footer}: {above}");
            pages += 1;
        }
    }
    assert!(pages > 25, "{pages}");
}

fn pages(pdf: &Path) -> usize {
    let about = ended(&Command::new("pdfinfo").arg(pdf).output().unwrap());
    let line = about.lines().find(|line| line.starts_with("Pages:")).unwrap();
    line.split_whitespace().last().unwrap().parse().unwrap()
}

/// Three combinations are what a checker reads, and not three times the same pages.
#[test]
fn three_combinations_take_twelve_pages() {
    if !prints() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let pdf = folder.path().join("quay.pdf");
    ended(&sheet(&["examples/quay.toml", "-o", pdf.to_str().unwrap()]).output().unwrap());
    // Each tells how far its base has opened.
    assert!(pages(&pdf) <= 12, "{}", pages(&pdf));
    // No page has a line or two alone; letters of figures are outlines.
    let text = text(&pdf);
    let pages = text.split('\u{c}').filter(|page| !page.trim().is_empty() && !page.contains("Figure "));
    for page in pages {
        let lines = page.lines().filter(|line| !line.trim().is_empty()).count();
        assert!(lines > 12, "{page}");
    }
}

#[test]
fn the_short_sheet_is_one_page() {
    if !prints() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let pdf = folder.path().join("short.pdf");
    let path = pdf.to_str().unwrap();
    let told =
        ["--project", "Outer pier", "--client", "Port", "--author", "A. Moreau", "--checker", "N. Okafor"];
    for case in [
        "quay",
        "goda-2000",
        "goda-on-sand",
        "caisson-of-parts",
        "statue-random",
        "monument-on-mortar",
        "motion/server-rack-earthquake",
    ] {
        let example = format!("examples/{case}.toml");
        for options in [&[][..], &told, &["--paper", "letter"]] {
            let arguments = [&[example.as_str(), "--short", "-o", path], options].concat();
            ended(&sheet(&arguments).output().unwrap());
            assert_eq!(pages(&pdf), 1, "{case} {options:?}");
            let words = words(&text(&pdf));
            assert!(words.contains("page 1 of 1") && words.contains("signature"), "{case}: {words}");
        }
    }
}

#[test]
fn project_sheet_and_names_run_along_the_pages() {
    if !prints() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let pdf = folder.path().join("sheet.pdf");
    let options = ["--project", "Outer pier", "--client", "Port", "--sheet", "C-104", "--revision", "B"];
    let names = ["--author", "A. Moreau", "--checker", "N. Okafor", "-o", pdf.to_str().unwrap()];
    let arguments = [&["examples/monument.toml"][..], &options, &names].concat();
    ended(&sheet(&arguments).output().unwrap());
    let text = text(&pdf);
    for page in text.split('\u{c}').filter(|page| !page.trim().is_empty()) {
        let page = words(page);
        for part in [
            "Outer pier · Port · Statue on its pedestal",
            "Sheet C-104 · Revision B",
            "Author A. Moreau",
            "N. Okafor",
        ] {
            assert!(page.contains(part), "{part} in {page}");
        }
    }
}
