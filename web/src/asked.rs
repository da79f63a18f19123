//! What takes longer than a picture: asked of a second explorer, in a thread of its own, and answered part by part.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use standfast_cases::CaseFile;

use crate::page::{Page, Version, read};
use crate::sheet::SheetAsked;

/// A question whose answer is told part by part, the first soon.
pub trait Question: std::fmt::Debug {
    /// The next part, as JSON; nothing once all is told.
    fn next_part(&mut self) -> Option<String>;
}

/// A case with the files that it may name.
#[derive(Debug, Serialize, Deserialize)]
struct HandedOn {
    name: String,
    text: String,
    files: BTreeMap<String, String>,
}

/// The last case of a page that has an answer, as JSON.
pub fn handed_on(page: &Page) -> String {
    let file = page.settled();
    let (name, text) = (file.name().to_owned(), file.text().to_owned());
    serde_json::to_string(&HandedOn { name, text, files: page.files().clone() }).unwrap_or_default()
}

/// Asks a question, by its name, of a case that is handed on.
pub fn ask(what: &str, handed_on: &str) -> Option<Box<dyn Question>> {
    let HandedOn { name, text, files } = serde_json::from_str(handed_on).ok()?;
    let file = read(&Version { name, text }, &files).ok()?;
    question(what, file)
}

/// The question of a name, with what belongs to it behind.
fn question(what: &str, file: CaseFile) -> Option<Box<dyn Question>> {
    let (name, rest) = what.split_once(' ').unwrap_or((what, ""));
    match name {
        "sheet" | "short-sheet" => Some(Box::new(SheetAsked::of(file, name == "short-sheet", rest))),
        _ => None,
    }
}
