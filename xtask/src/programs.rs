//! Programs that tests need: a browser, and one that reads a PDF's text. Found, or in CI installed.

use std::fmt;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use crate::tally::in_ci;

/// Programs that are not there, and how to get them.
pub struct Missing {
    what: &'static str,
    packages: &'static [&'static str],
}

impl fmt::Display for Missing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Missing { what, packages } = self;
        write!(f, "{what} is missing; on Debian, `apt-get install {}` installs it", packages.join(" "))?;
        if in_ci() { f.write_str(", which was tried here") } else { Ok(()) }
    }
}

/// Result of `find`; in CI after Debian's packages have been installed, if it is not there before.
pub fn needed<T>(
    what: &'static str,
    packages: &'static [&'static str],
    find: impl Fn() -> Option<T>,
) -> Result<T, Missing> {
    let installed = || if in_ci() && install(packages) { find() } else { None };
    find().or_else(installed).ok_or(Missing { what, packages })
}

/// Chromium or another browser of its family.
pub fn chromium() -> Result<PathBuf, Missing> {
    needed("Chromium", &["chromium"], || {
        ["chromium", "chromium-browser", "google-chrome"].into_iter().find_map(found)
    })
}

/// Firefox.
pub fn firefox() -> Result<PathBuf, Missing> {
    needed("Firefox", &["firefox-esr"], || ["firefox-esr", "firefox"].into_iter().find_map(found))
}

/// The browser, with `pdftotext` beside it.
pub fn for_pdfs() -> Result<PathBuf, Missing> {
    let browser = chromium()?;
    let reads = || Command::new("pdftotext").arg("-v").output().ok();
    needed("pdftotext", &["poppler-utils"], reads).map(|_| browser)
}

/// The path of a program.
pub fn found(program: &str) -> Option<PathBuf> {
    let folders = std::env::var_os("PATH")?;
    std::env::split_paths(&folders).map(|folder| folder.join(program)).find(|path| path.is_file())
}

/// Installs Debian packages, as CI may.
fn install(packages: &[&str]) -> bool {
    let apt = |arguments: &[&str]| {
        let mut command = Command::new("apt-get");
        command.args(arguments).env("DEBIAN_FRONTEND", "noninteractive").stdout(Stdio::null());
        command.status().is_ok_and(|status| status.success())
    };
    println!("── apt-get install {}", packages.join(" "));
    let options = [&["install", "--yes", "-qq", "--no-install-recommends"], packages].concat();
    apt(&options) || apt(&["update", "-qq"]) && apt(&options)
}
