//! docs/reference/errors.md: what errors say and mean, from the attributes of the types that carry them.

use std::path::Path;
use std::{fs, io};

/// Where errors stand that a user meets, and of what they are.
const SOURCES: [(&str, &str); 15] = [
    ("Case files", "crates/inputs/src/error.rs"),
    ("Quantities and units", "crates/inputs/src/units.rs"),
    ("Records", "crates/motion/src/record.rs"),
    ("Sections of parts", "crates/standfast/src/section.rs"),
    ("Bases seen from above", "crates/standfast/src/footprint.rs"),
    ("Directions", "crates/answers/src/directions.rs"),
    ("Motions", "crates/motion/src/error.rs"),
    ("Random numbers", "crates/inputs/src/random.rs"),
    ("Probabilities", "crates/answers/src/random/error.rs"),
    ("Lives of storms", "crates/answers/src/random/storm/answer.rs"),
    ("Design", "crates/answers/src/design/error.rs"),
    ("Targets of a design", "crates/answers/src/design/target.rs"),
    ("Spectra", "crates/answers/src/motion/spectrum.rs"),
    ("Tables", "crates/tables/src/error.rs"),
    ("The program", "crates/cli/src/error.rs"),
];

/// The page of all errors.
///
/// # Errors
/// If a source is not there.
pub fn page(root: &Path) -> io::Result<String> {
    let mut page = String::from(
        "# Errors\n\n\
         What an error says, with braces where the wrong value and its place stand, and what it is about. An error names the file, the line and the\n\
         key, shows the value and says what is expected; most end with a line of help. In the program each ends with exit code 1, a wrong command line\n\
         with 2. This page is written by `cargo xtask gallery` from the errors themselves.\n",
    );
    for (title, path) in SOURCES {
        let text = fs::read_to_string(root.join(path))
            .map_err(|error| io::Error::new(error.kind(), format!("{path}: {error}")))?;
        let rows = rows(&text);
        if rows.is_empty() {
            return Err(io::Error::other(format!("{path} has no errors")));
        }
        page.push_str(&format!("\n## {title}\n\n| what it says | what it is about |\n|---|---|\n"));
        for (says, about) in rows {
            page.push_str(&format!("| {} | {} |\n", cell(&says), cell(&about)));
        }
    }
    Ok(page)
}

/// The messages of a source, each with the doc line above it.
fn rows(text: &str) -> Vec<(String, String)> {
    let mut rows = Vec::new();
    let mut about = String::new();
    let mut rest = text;
    while let Some((line, next)) = rest.split_once('\n') {
        let bare = line.trim();
        if let Some(words) = bare.strip_prefix("/// ") {
            if about.is_empty() {
                words.clone_into(&mut about);
            }
        } else if bare.starts_with("#[error(") {
            let attribute = rest.split_once(")]").map_or(rest, |(attribute, _)| attribute);
            if let Some(message) = literal(attribute) {
                rows.push((message, about.trim_end_matches('.').to_owned()));
            }
            about.clear();
        } else if !bare.starts_with("#[") && !bare.is_empty() {
            about.clear();
        }
        rest = next;
    }
    rows
}

/// The first literal of text in an attribute, with the names of values in its braces.
fn literal(attribute: &str) -> Option<String> {
    let (_, text) = attribute.split_once('"')?;
    let mut message = String::new();
    let mut letters = text.chars();
    while let Some(letter) = letters.next() {
        match letter {
            '"' => break,
            '\\' => match letters.next()? {
                '\n' => {
                    // A line goes on without the blanks at its beginning.
                    let behind = letters.as_str().trim_start();
                    letters = behind.chars();
                }
                other => message.push(other),
            },
            other => message.push(other),
        }
    }
    Some(message)
}

/// A text in a cell of a table: braces hold what stands in their place.
fn cell(text: &str) -> String {
    let text = text.replace("{{", "\u{1}").replace("}}", "\u{2}").replace("{}", "…").replace("{0}", "…");
    let text = text.replace('|', "\\|").replace('<', "&lt;").replace('\u{1}', "{").replace('\u{2}', "}");
    text.replace(":?}", "}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_are_read_with_what_they_are_about() {
        let text = "/// Errors.\npub enum Problem {\n    /// There is nothing.\n    #[error(\"{name} is \\\n        empty\")]\n    Empty,\n    /// Not this.\n    /// More of it.\n    #[non]\n    #[error(transparent)]\n    Other,\n    /// Both.\n    #[error(\"{a:?} and `{}`\", b)]\n    Both,\n}\n";
        let found = rows(text);
        assert_eq!(
            found,
            [
                ("{name} is empty".to_owned(), "There is nothing".to_owned()),
                ("{a:?} and `{}`".to_owned(), "Both".to_owned())
            ]
        );
        assert_eq!(cell("{a:?} and `{}` | {{x}}"), "{a} and `…` \\| {x}");
    }
}
