//! What takes longer than a picture: asked of a second explorer, in a thread of its own, and answered part by part.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use standfast_cases::CaseFile;

use crate::help::{Help, TwoNumbers};
use crate::likely::Likely;
use crate::notches::NotchesAsked;
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

/// The questions there are: a name, and behind it what is asked more closely.
fn question(what: &str, file: CaseFile) -> Option<Box<dyn Question>> {
    let mut words = what.split(' ');
    match (words.next()?, words.next(), words.next()) {
        ("help", None, None) => Some(Box::new(Help::of(&file))),
        ("likely", None, None) => Some(Box::new(Likely::of(file))),
        ("two", Some(up), Some(across)) => Some(Box::new(TwoNumbers::of(file, [up, across]))),
        ("notches", Some(key), None) => Some(Box::new(NotchesAsked::of(file, key))),
        (name @ ("sheet" | "short-sheet"), Some(day), None) => {
            Some(Box::new(SheetAsked::of(file, name == "short-sheet", day)))
        }
        _ => None,
    }
}
