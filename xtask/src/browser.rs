//! The browser that prints a sheet, and the program that reads a PDF's text: found, or installed where that is possible.

use std::fmt;
use std::path::PathBuf;
use std::process::Command;

/// Programs that are not there and could not be installed.
pub struct Missing(&'static str);

impl fmt::Display for Missing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} is missing and was not installed (that takes apt-get as root)", self.0)
    }
}

/// Chromium or another browser of its family.
pub fn chromium() -> Result<PathBuf, Missing> {
    let find = || standfast_cli::browser::find().ok();
    find().or_else(|| install("chromium").then(find).flatten()).ok_or(Missing("chromium"))
}

/// The browser, with `pdftotext` beside it.
pub fn for_pdfs() -> Result<PathBuf, Missing> {
    let browser = chromium()?;
    let reads = || Command::new("pdftotext").arg("-v").output().is_ok();
    if reads() || install("poppler-utils") && reads() { Ok(browser) } else { Err(Missing("pdftotext")) }
}

/// Installs a Debian package, if that is allowed here.
fn install(package: &str) -> bool {
    let apt = |arguments: &[&str]| {
        let mut command = Command::new("apt-get");
        command.args(arguments).env("DEBIAN_FRONTEND", "noninteractive");
        command.status().is_ok_and(|status| status.success())
    };
    println!("── installing {package}");
    let options = ["install", "--yes", "--no-install-recommends", package];
    apt(&options) || apt(&["update"]) && apt(&options)
}
