//! The book: mdBook, at one version, makes pages of docs; beside them lie the examples, the explorer and the book as one file.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::tally::{Tally, cargo, in_ci};
use crate::{built, dist, explorer, ran, root, target};

/// The version of mdBook. Another may make other pages.
const MDBOOK: &str = "0.5.4";

/// Builds `target/book`, and `target/standfast-book.html` of it; opens it if asked.
pub fn build(open: bool) -> Result<PathBuf, String> {
    ran(&mut cargo(&["build", "--quiet", "--package", "xtask-docs"]))?;
    let folder = pages()?;
    match explorer::file() {
        Ok(page) => {
            let to = folder.join("standfast-explorer.html");
            fs::copy(&page, &to).map_err(|error| format!("{}: {error}", to.display()))?;
        }
        Err(missing) => println!("── without the explorer, to which pages lead: {missing}"),
    }
    println!("{}\n{}", folder.join("index.html").display(), one_file(&folder)?.display());
    if open {
        explorer::opened(&folder.join("index.html").to_string_lossy());
    }
    Ok(folder)
}

/// The pages alone.
fn pages() -> Result<PathBuf, String> {
    let folder = target().join("book");
    dist::cleared(&folder)?;
    let preprocessor = format!("{} preprocess", built("xtask-docs").display());
    let mut mdbook = Command::new(mdbook()?);
    mdbook.args(["build", "--dest-dir"]).arg(&folder).arg(root().join("docs"));
    let output = mdbook
        .env("MDBOOK_PREPROCESSOR__STANDFAST__COMMAND", preprocessor)
        .env("MDBOOK_LOG", "warn")
        .output();
    let output = output.map_err(|error| format!("mdBook: {error}"))?;
    let said =
        [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).trim().to_owned()).concat();
    // It goes on where a page is wrong, and says so.
    if !output.status.success() || !said.is_empty() {
        return Err(format!("mdBook: {}\n{said}", output.status));
    }
    let font = folder.join("standfast-math.woff2");
    fs::copy(root().join("crates/sheet/fonts/math.woff2"), &font)
        .map_err(|error| format!("{}: {error}", font.display()))?;
    for beside in ["examples", "validation"] {
        dist::copied(&root().join(beside), &folder.join(beside))?;
    }
    Ok(folder)
}

/// mdBook, installed into target/tools if it is not there: cargo, and no network afterwards.
fn mdbook() -> Result<PathBuf, String> {
    let tools = target().join("tools");
    let program = tools.join("bin").join(format!("mdbook{}", std::env::consts::EXE_SUFFIX));
    let version = Command::new(&program).arg("--version").output();
    let is_there = version
        .is_ok_and(|output| String::from_utf8_lossy(&output.stdout).trim() == format!("mdbook v{MDBOOK}"));
    if !is_there {
        println!("── mdBook {MDBOOK}, once, into {}: two or three minutes", tools.display());
        let features = ["--no-default-features", "--features", "search"];
        ran(cargo(&["install", "--quiet", "--locked", "--force", "mdbook", "--version", MDBOOK])
            .args(features)
            .arg("--root")
            .arg(&tools)
            .env("CARGO_TARGET_DIR", target().join("tools/build")))?;
    }
    Ok(program)
}

/// The book as one file, for a mail: its page for printing with pictures and styles in it.
fn one_file(folder: &Path) -> Result<PathBuf, String> {
    let file = target().join("standfast-book.html");
    ran(Command::new(built("xtask-docs")).arg("one-file").arg(folder).arg(&file))?;
    Ok(file)
}

/// The book as it is handed on: an archive of its folder, and the one file.
pub fn packed(toolchain: &dist::Toolchain, folder: &Path) -> Result<Vec<(PathBuf, String)>, String> {
    let pages = build(false)?;
    let state = "every address in it leads somewhere".to_owned();
    ran(Command::new(built("xtask-docs")).arg("addresses").arg(&pages))?;
    let archive = folder.join(format!("standfast-book-{}.zip", dist::version()));
    dist::packed(toolchain, &pages, &archive)?;
    let file = folder.join(format!("standfast-book-{}.html", dist::version()));
    fs::copy(target().join("standfast-book.html"), &file)
        .map_err(|error| format!("{}: {error}", file.display()))?;
    Ok(vec![(archive, state.clone()), (file, state)])
}

/// Builds the book and sees that every address in it leads somewhere.
pub fn check(tally: &mut Tally) {
    println!("── book");
    // On a user's machine mdBook is not installed by a test; in CI it is, as other tools are.
    if !in_ci() && !target().join("tools/bin").exists() {
        return tally.missing("book", "mdBook is not there; `cargo xtask book` installs it");
    }
    match pages().and_then(|folder| one_file(&folder).map(|_| folder)) {
        Ok(folder) => {
            tally.record(
                "addresses of the book",
                Command::new(built("xtask-docs")).arg("addresses").arg(folder),
            );
        }
        Err(error) => tally.fail("book", error),
    }
}
