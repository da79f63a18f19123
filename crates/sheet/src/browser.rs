//! A page printed to PDF by a browser of the Chromium family, which sets mathematics and numbers pages.

use std::env;
use std::ffi::OsString;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::str::FromStr;
use std::time::{Duration, Instant};

use standfast_cases::Explained;
use thiserror::Error;

use crate::Date;

/// The size of a PDF's pages.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
pub enum Paper {
    /// 210 mm × 297 mm.
    #[default]
    A4,
    /// 8.5 in × 11 in.
    Letter,
}

impl FromStr for Paper {
    type Err = PaperError;

    fn from_str(text: &str) -> Result<Paper, PaperError> {
        match text {
            "a4" => Ok(Paper::A4),
            "letter" => Ok(Paper::Letter),
            _ => Err(PaperError),
        }
    }
}

/// A text that names no size of paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error("expected a4 or letter")]
pub struct PaperError;

/// The page with its size set; an HTML file itself leaves that to whoever prints it. What has to fit one page has smaller margins on the
/// lower paper.
fn on_paper(html: &str, paper: Paper, short: bool) -> String {
    let size = match (paper, short) {
        (Paper::A4, _) => "A4",
        (Paper::Letter, false) => "letter",
        (Paper::Letter, true) => "letter;margin-top:10.5mm;margin-bottom:8mm",
    };
    html.replacen("</style>", &format!("@page{{size:{size}}}</style>"), 1)
}

/// The variable that names a browser.
const VARIABLE: &str = "STANDFAST_BROWSER";

/// Programs looked for in the folders of PATH.
const PROGRAMS: [&str; 7] = [
    "chromium",
    "chromium-browser",
    "google-chrome",
    "google-chrome-stable",
    "chrome",
    "microsoft-edge",
    "msedge",
];

/// Programs looked for where their installers put them.
const PLACES: [&str; 4] = [
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    "/Applications/Chromium.app/Contents/MacOS/Chromium",
    r"C:\Program Files\Google\Chrome\Application\chrome.exe",
    r"C:\Program Files (x86)\Microsoft\Edge\Application\msedge.exe",
];

/// Longest time that a browser may take.
const PATIENCE: Duration = Duration::from_secs(120);

/// Reason why a page was not printed.
#[derive(Debug, Error)]
pub enum PrintError {
    /// There is no browser.
    #[error("a PDF is printed by Chromium or Chrome, and none was found")]
    NoBrowser,
    /// The browser that was named is none.
    #[error("{VARIABLE} is {}, which is not a program", path.display())]
    NoProgram {
        /// Path that the variable names.
        path: PathBuf,
    },
    /// The browser cannot be started.
    #[error("cannot start {}: {cause}", program.display())]
    Start {
        /// The browser.
        program: PathBuf,
        /// Error of the system.
        cause: io::Error,
    },
    /// The browser printed nothing.
    #[error("{} printed nothing{said}", program.display())]
    Nothing {
        /// The browser.
        program: PathBuf,
        /// The end of what it said.
        said: String,
    },
    /// The browser did not end.
    #[error("{} has not printed within {} s", program.display(), PATIENCE.as_secs())]
    Slow {
        /// The browser.
        program: PathBuf,
    },
    /// There is no room for temporary files.
    #[error("cannot write a temporary file: {0}")]
    Temporary(#[from] io::Error),
}

impl Explained for PrintError {
    fn help(&self) -> Option<String> {
        let help = match self {
            PrintError::NoBrowser => format!(
                "looked in PATH for {}, and at {}; {VARIABLE} names another program. Without one, write the sheet as .html and print it \
                 from any browser",
                PROGRAMS.join(", "),
                PLACES.join(", ")
            ),
            PrintError::NoProgram { .. } => "set it to the path of Chromium or Chrome, or unset it".into(),
            PrintError::Nothing { .. } | PrintError::Slow { .. } => {
                "write the sheet as .html and print it from any browser".into()
            }
            _ => return None,
        };
        Some(help)
    }
}

/// The browser to print with.
///
/// # Errors
/// If there is none.
pub fn find() -> Result<PathBuf, PrintError> {
    if let Some(named) = env::var_os(VARIABLE).filter(|named| !named.is_empty()) {
        let path = PathBuf::from(named);
        let found = path.is_file().then(|| path.clone()).or_else(|| in_path(path.as_os_str().to_owned()));
        return found.ok_or(PrintError::NoProgram { path });
    }
    let in_folders = PROGRAMS.iter().find_map(|program| in_path(OsString::from(program)));
    let installed = || PLACES.iter().map(PathBuf::from).find(|place| place.is_file());
    in_folders.or_else(installed).ok_or(PrintError::NoBrowser)
}

fn in_path(program: OsString) -> Option<PathBuf> {
    let folders = env::var_os("PATH")?;
    let mut file = program;
    file.push(env::consts::EXE_SUFFIX);
    env::split_paths(&folders).map(|folder| folder.join(&file)).find(|path| path.is_file())
}

/// The PDF of a page. The same page and date give the same bytes from the same browser.
pub(crate) fn print(
    html: &str,
    paper: Paper,
    short: bool,
    date: Option<Date>,
) -> Result<Vec<u8>, PrintError> {
    let program = find()?;
    let folder = tempfile::Builder::new().prefix("standfast-").tempdir()?;
    let (page, pdf) = (folder.path().join("sheet.html"), folder.path().join("sheet.pdf"));
    fs::write(&page, on_paper(html, paper, short))?;
    let said = run(&program, folder.path(), &page, &pdf)?;
    let mut bytes = match fs::read(&pdf) {
        Ok(bytes) if bytes.starts_with(b"%PDF") => bytes,
        _ => return Err(PrintError::Nothing { program, said }),
    };
    set_dates(&mut bytes, date);
    Ok(bytes)
}

/// Runs the browser; gives the end of what it said.
fn run(program: &Path, folder: &Path, page: &Path, pdf: &Path) -> Result<String, PrintError> {
    let mut command = Command::new(program);
    command
        .args(["--headless", "--disable-gpu", "--no-first-run", "--no-default-browser-check"])
        .args(["--disable-background-networking", "--disable-component-update", "--disable-sync"])
        // Tags carry numbers that differ from one printing to the next; the HTML is the sheet for screen readers.
        .args(["--disable-extensions", "--no-pdf-header-footer", "--disable-pdf-tagging"]);
    if is_root() {
        // Chromium refuses its sandbox to root; the page is our own, without scripts.
        command.arg("--no-sandbox");
    }
    let with_path = |option: &str, path: &Path| {
        let mut argument = OsString::from(option);
        argument.push(path);
        argument
    };
    command
        .arg(with_path("--user-data-dir=", &folder.join("profile")))
        .arg(with_path("--print-to-pdf=", pdf))
        .arg(page);
    let log = folder.join("log");
    let errors = fs::File::create(&log)?;
    let mut child = command
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(errors)
        .spawn()
        .map_err(|cause| PrintError::Start { program: program.to_owned(), cause })?;
    let started = Instant::now();
    while child.try_wait()?.is_none() {
        if started.elapsed() > PATIENCE {
            child.kill()?;
            child.wait()?;
            return Err(PrintError::Slow { program: program.to_owned() });
        }
        std::thread::sleep(Duration::from_millis(20));
    }
    let log = fs::read(&log).unwrap_or_default();
    let last = String::from_utf8_lossy(&log).lines().last().map(|line| format!(": {line}"));
    Ok(last.unwrap_or_default())
}

fn is_root() -> bool {
    #[cfg(unix)]
    return fs::metadata("/proc/self").is_ok_and(|own| std::os::unix::fs::MetadataExt::uid(&own) == 0);
    #[cfg(not(unix))]
    false
}

/// Puts the sheet's date in place of the time of printing, or the beginning of the calendar of PDF without one.
fn set_dates(pdf: &mut [u8], date: Option<Date>) {
    let day = date.map_or("20000101".to_owned(), |date| date.to_string().replace('-', ""));
    let time = format!("{day}000000");
    for key in [&b"/CreationDate (D:"[..], b"/ModDate (D:"] {
        let mut from = 0;
        while let Some(found) = pdf[from..].windows(key.len()).position(|window| window == key) {
            from += found + key.len();
            if let Some(digits) = pdf.get_mut(from..from + time.len())
                && digits.iter().all(u8::is_ascii_digit)
            {
                digits.copy_from_slice(time.as_bytes());
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::set_dates;

    #[test]
    fn dates_are_replaced_in_place() {
        let mut pdf =
            b"<</CreationDate (D:20261121063000+00'00')\n/ModDate (D:20261121063000+00'00')>>".to_vec();
        set_dates(&mut pdf, "2026-11-20".parse().ok());
        let expected = "<</CreationDate (D:20261120000000+00'00')\n/ModDate (D:20261120000000+00'00')>>";
        assert_eq!(String::from_utf8(pdf.clone()).unwrap(), expected);
        set_dates(&mut pdf, None);
        assert!(String::from_utf8(pdf).unwrap().contains("/ModDate (D:20000101000000"));
    }
}
