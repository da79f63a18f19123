//! Programs that tests need: a browser, and one that reads a PDF's text. Found, or installed where that is possible.

use std::fmt;
use std::path::PathBuf;
use std::process::{Command, Stdio};

/// Programs that are not there and could not be installed.
pub struct Missing(&'static str);

impl fmt::Display for Missing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} is missing and was not installed (that takes apt-get as root)", self.0)
    }
}

/// Chromium or another browser of its family.
pub fn chromium() -> Result<PathBuf, Missing> {
    let find = || ["chromium", "chromium-browser", "google-chrome"].into_iter().find_map(found);
    find().or_else(|| install(&["chromium"]).then(find).flatten()).ok_or(Missing("chromium"))
}

/// The browser, with `pdftotext` beside it.
pub fn for_pdfs() -> Result<PathBuf, Missing> {
    let browser = chromium()?;
    let reads = || Command::new("pdftotext").arg("-v").output().is_ok();
    if reads() || install(&["poppler-utils"]) && reads() { Ok(browser) } else { Err(Missing("pdftotext")) }
}

/// The path of a program.
pub fn found(program: &str) -> Option<PathBuf> {
    let folders = std::env::var_os("PATH")?;
    std::env::split_paths(&folders).map(|folder| folder.join(program)).find(|path| path.is_file())
}

/// Installs Debian packages, if that is allowed here.
pub fn install(packages: &[&str]) -> bool {
    let apt = |arguments: &[&str]| {
        let mut command = Command::new("apt-get");
        command.args(arguments).env("DEBIAN_FRONTEND", "noninteractive").stdout(Stdio::null());
        command.status().is_ok_and(|status| status.success())
    };
    println!("── apt-get install {}", packages.join(" "));
    let options = [&["install", "--yes", "-qq", "--no-install-recommends"], packages].concat();
    apt(&options) || apt(&["update", "-qq"]) && apt(&options)
}
