//! The book: mdBook builds it from docs; what mdBook does not know of is put into its pages here, as its preprocessor.
//!
//! Formulas become MathML, `explorer:` addresses open the explorer at a case, and links to files outside of docs lead to the copies that
//! lie beside the book, or are words.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::io::{Read, Write as _};
use std::path::{Component, Path, PathBuf};
use std::{fs, io};

use base64::Engine;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use flate2::Compression;
use flate2::write::DeflateEncoder;
use serde_json::Value;
use standfast_cases::beginnings::Beginning;
use standfast_sheet::Displayed;

use crate::pages::{Block, Files, Piece, Toml, blocks, commands, pieces};

/// Folders that lie beside the book as they are.
const BESIDE: [&str; 2] = ["examples", "validation"];

/// Answers mdBook: takes the book as JSON, gives it with its pages made.
///
/// # Errors
/// If what came is no book, or a page is not as it has to be.
pub fn preprocess(mut input: impl Read, mut output: impl io::Write, root: &Path) -> Result<(), String> {
    let mut text = String::new();
    input.read_to_string(&mut text).map_err(|error| format!("the book from mdBook: {error}"))?;
    let mut both: Value =
        serde_json::from_str(&text).map_err(|error| format!("the book from mdBook: {error}"))?;
    let mut book = both.get_mut(1).map(Value::take).ok_or("expected mdBook's context and book")?;
    let mut faults = Vec::new();
    chapters(&mut book["items"], &mut |path, content| match made(path, content, root) {
        Ok(made) => *content = made,
        Err(found) => faults.extend(found),
    });
    if !faults.is_empty() {
        return Err(faults.join("\n"));
    }
    let text = serde_json::to_string(&book).map_err(|error| error.to_string())?;
    output.write_all(text.as_bytes()).map_err(|error| format!("the book to mdBook: {error}"))
}

fn chapters(items: &mut Value, each: &mut impl FnMut(&str, &mut String)) {
    for item in items.as_array_mut().into_iter().flatten() {
        let Some(chapter) = item.get_mut("Chapter") else { continue };
        let path = chapter["source_path"].as_str().unwrap_or_default().to_owned();
        if let Value::String(content) = &mut chapter["content"] {
            each(&path, content);
        }
        chapters(&mut chapter["sub_items"], each);
    }
}

/// A page as mdBook gets it; or everything wrong with it.
///
/// # Errors
/// Each formula that cannot be read, each link that leads nowhere.
pub fn made(path: &str, page: &str, root: &Path) -> Result<String, Vec<String>> {
    let mut made = String::new();
    let mut faults = Vec::new();
    let mut files = Files::default();
    // What the head of a page speaks of is written below.
    let mut ahead = Files::default();
    for Block { language, text, .. } in blocks(page).iter().rev() {
        match *language {
            "console" => begun(text).for_each(|(name, beginning)| ahead.add(name, beginning.text.to_owned())),
            "toml" if matches!(Toml::of(text), Toml::File(_)) => drop(ahead.take(text)),
            _ => {}
        }
    }
    for piece in pieces(page) {
        match piece {
            Piece::Words(words) => {
                let words = inline(words, &mut |fault| faults.push(format!("docs/{path}: {fault}")));
                made += &linked(path, &words, [&files, &ahead], root, &mut faults);
            }
            Piece::Block(Block { language: "formula", line, text }, _) => {
                made += &displayed(text, &mut |fault| faults.push(format!("docs/{path}:{line}: {fault}")));
            }
            Piece::Block(Block { language, line, text }, whole) => {
                if language == "console" {
                    begun(text).for_each(|(name, beginning)| files.add(name, beginning.text.to_owned()));
                }
                if language == "toml" {
                    files.take(text).unwrap_or_else(|fault| {
                        faults.push(format!("docs/{path}:{line}: {fault}"));
                        None
                    });
                }
                made += whole;
            }
        }
    }
    if faults.is_empty() { Ok(made) } else { Err(faults) }
}

/// The files that commands such as `standfast new statue -o my.toml` write.
fn begun(text: &str) -> impl Iterator<Item = (&str, &'static Beginning)> {
    commands(text).into_iter().filter_map(|(command, _)| {
        let words: Vec<&str> = command.split_whitespace().collect();
        match words[..] {
            ["standfast", "new", kind, "-o", name] => Some((name, Beginning::find(kind)?)),
            _ => None,
        }
    })
}

/// A block of formulas.
fn displayed(text: &str, fault: &mut impl FnMut(String)) -> String {
    let mut rows = String::from("<div class=\"formulas\">\n");
    for line in text.lines().filter(|line| !line.trim().is_empty()) {
        match Displayed::of(line) {
            Ok(Displayed { formulas, words, number }) => {
                let formulas = formulas.join("<span class=\"apart\"></span>");
                let number = if number.is_empty() { String::new() } else { format!("({number})") };
                let _ = writeln!(
                    rows,
                    "<div><span>{formulas}</span><span class=\"words\">{words}</span><span class=\"number\">{number}</span></div>"
                );
            }
            Err(error) => fault(error.to_string()),
        }
    }
    rows + "</div>\n"
}

/// Words in which formulas between backticks that begin with a sign of equality, `= a/b`, are drawn, without that sign.
fn inline(words: &str, fault: &mut impl FnMut(String)) -> String {
    let mut made = String::new();
    let mut rest = words;
    while let Some((before, behind)) = rest.split_once("`= ") {
        let Some((formula, behind)) = behind.split_once('`') else { break };
        made += before;
        rest = behind;
        match Displayed::of(formula) {
            // A bar would end a cell of a table.
            Ok(line) => made += &line.formulas.concat().replace('|', "&#124;"),
            Err(error) => fault(error.to_string()),
        }
    }
    made + rest
}

/// Words with their links led to where they lead in the book.
fn linked(path: &str, words: &str, files: [&Files; 2], root: &Path, faults: &mut Vec<String>) -> String {
    let folder = Path::new(path).parent().unwrap_or(Path::new(""));
    let up = "../".repeat(folder.components().count());
    let mut made = String::new();
    let mut rest = words;
    while let Some((before, behind)) = rest.split_once("](") {
        let Some((target, behind)) = behind.split_once(')') else { break };
        rest = behind;
        made += before;
        match led(folder, &up, target, files, root) {
            Ok(Led::To(address)) => {
                let _ = write!(made, "]({address})");
            }
            Ok(Led::Outside(file)) => {
                // The words stay, without their bracket.
                if let Some(open) = made.rfind('[') {
                    made.remove(open);
                }
                let _ = write!(made, " (`{file}`)");
            }
            Err(fault) => faults.push(format!("docs/{path}: {fault}")),
        }
    }
    made + rest
}

enum Led {
    To(String),
    Outside(String),
}

fn led(folder: &Path, up: &str, target: &str, files: [&Files; 2], root: &Path) -> Result<Led, String> {
    if let Some(name) = target.strip_prefix("explorer:") {
        let text = match files.iter().find_map(|files| files.text(name)) {
            Some(text) => text.to_owned(),
            None => fs::read_to_string(root.join(name)).map_err(|error| format!("{target}: {error}"))?,
        };
        let stem = Path::new(name).file_name().unwrap_or_default().to_string_lossy().into_owned();
        return Ok(Led::To(format!("{up}standfast-explorer.html#c={}&n={stem}", packed(&text))));
    }
    if target.contains("://") {
        return Ok(Led::To(target.to_owned()));
    }
    let (file, anchor) = target.split_once('#').map_or((target, None), |(file, anchor)| (file, Some(anchor)));
    if file.is_empty() {
        return Ok(Led::To(target.to_owned()));
    }
    let full = normal(&Path::new("docs").join(folder).join(file));
    if !root.join(&full).exists() {
        return Err(format!("the link to {target} leads to {}, which is not there", full.display()));
    }
    let end = anchor.map_or_else(String::new, |anchor| format!("#{anchor}"));
    let inside = full.strip_prefix("docs").ok().map(slashes);
    Ok(match inside {
        // The paper is no page of the book.
        Some(inside) if inside.starts_with("paper/") => Led::Outside(slashes(&full)),
        Some(inside) if inside == "README.md" => Led::To(format!("{up}index.md{end}")),
        Some(inside) => Led::To(format!("{up}{inside}{end}")),
        // mdBook leads to a page where it sees the name of one.
        None if BESIDE.iter().any(|beside| full.starts_with(beside))
            && full.extension().is_none_or(|ending| ending != "md") =>
        {
            Led::To(format!("{up}{}{end}", slashes(&full)))
        }
        None => Led::Outside(slashes(&full)),
    })
}

/// A path without `.` and `..`.
fn normal(path: &Path) -> PathBuf {
    let mut parts = Vec::new();
    for part in path.components() {
        match part {
            Component::ParentDir if !parts.is_empty() => {
                parts.pop();
            }
            Component::CurDir => {}
            other => parts.push(other),
        }
    }
    parts.iter().collect()
}

fn slashes(path: &Path) -> String {
    let parts: Vec<_> =
        path.components().map(|part| part.as_os_str().to_string_lossy().into_owned()).collect();
    parts.join("/")
}

/// A text as the explorer's address has it: deflated, in letters of base64 for addresses.
fn packed(text: &str) -> String {
    let mut encoder = DeflateEncoder::new(Vec::new(), Compression::best());
    let bytes = encoder.write_all(text.as_bytes()).and_then(|()| encoder.finish());
    URL_SAFE_NO_PAD.encode(bytes.unwrap_or_default())
}

/// The pages that the table of contents names, in its order, from docs.
///
/// # Errors
/// If the table cannot be read.
pub fn contents(root: &Path) -> io::Result<Vec<String>> {
    let table = fs::read_to_string(root.join("docs/SUMMARY.md"))?;
    let targets = table
        .split("](")
        .skip(1)
        .filter_map(|part| part.split_once(')'))
        .map(|(target, _)| target.to_owned());
    Ok(targets.filter(|target| !target.is_empty()).collect())
}

/// The anchors of a page: its headings as mdBook makes them.
pub fn anchors(page: &str) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for piece in pieces(page) {
        let Piece::Words(words) = piece else { continue };
        for line in words.lines().filter(|line| line.starts_with('#')) {
            let heading = line.trim_start_matches('#').trim();
            let plain: String = heading.chars().filter(|letter| !"`*".contains(*letter)).collect();
            let slug: String = plain
                .to_lowercase()
                .chars()
                .filter_map(|letter| match letter {
                    ' ' => Some('-'),
                    '-' | '_' => Some(letter),
                    letter if letter.is_alphanumeric() => Some(letter),
                    _ => None,
                })
                .collect();
            let count = (0..).map(|i| if i == 0 { slug.clone() } else { format!("{slug}-{i}") });
            let free = count.into_iter().find(|one| !found.contains(one)).unwrap_or(slug);
            found.insert(free);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pages::all;

    fn page(path: &str) -> String {
        fs::read_to_string(crate::root().join("docs").join(path)).unwrap()
    }

    #[test]
    fn every_page_is_in_the_table_of_contents() {
        let root = crate::root();
        let contents: BTreeSet<_> = contents(&root).unwrap().into_iter().collect();
        let docs = root.join("docs");
        let kept: BTreeSet<_> = all(&docs)
            .unwrap()
            .iter()
            .map(|path| slashes(path.strip_prefix(&docs).unwrap()))
            .filter(|path| path != "SUMMARY.md")
            .collect();
        assert_eq!(contents, kept);
    }

    #[test]
    fn every_page_can_be_made_and_every_link_leads_somewhere() {
        let root = crate::root();
        let mut faults = Vec::new();
        let mut links = 0;
        for path in contents(&root).unwrap() {
            let text = page(&path);
            faults.extend(made(&path, &text, &root).err().into_iter().flatten());
            // Anchors, in this page and in others.
            let folder = Path::new(&path).parent().unwrap();
            let words: String = pieces(&text)
                .iter()
                .filter_map(|piece| if let Piece::Words(words) = piece { Some(*words) } else { None })
                .collect();
            for target in words.split("](").skip(1).filter_map(|part| Some(part.split_once(')')?.0)) {
                links += 1;
                let Some((file, anchor)) = target.split_once('#').filter(|_| !target.contains(':')) else {
                    continue;
                };
                let other = if file.is_empty() { path.clone() } else { slashes(&normal(&folder.join(file))) };
                if other.ends_with(".md")
                    && !other.starts_with("..")
                    && root.join("docs").join(&other).exists()
                    && !anchors(&page(&other)).contains(anchor)
                {
                    faults.push(format!("docs/{path}: {target}: no such heading"));
                }
            }
        }
        assert!(faults.is_empty(), "{}", faults.join("\n"));
        assert!(links > 150, "{links}");
    }

    #[test]
    fn what_mdbook_gives_comes_back_with_its_pages_made() {
        let book = r#"[{}, {"items": [{"PartTitle": "One"}, {"Chapter": {"name": "A", "content": "see [it](../README.md) and [that](../../DESIGN.md#x) and [these](../../examples/block.toml)\n```formula\na = b/c   (1.2)\n```\n[open](explorer:examples/block.toml)\n", "source_path": "theory/a.md", "sub_items": []}}]}]"#;
        let mut output = Vec::new();
        preprocess(book.as_bytes(), &mut output, &crate::root()).unwrap();
        let made: Value = serde_json::from_slice(&output).unwrap();
        let content = made["items"][1]["Chapter"]["content"].as_str().unwrap();
        for part in [
            "[it](../index.md)",
            "that (`DESIGN.md`)",
            "[these](../examples/block.toml)",
            "<mfrac>",
            "(1.2)",
            "[open](../standfast-explorer.html#c=",
        ] {
            assert!(content.contains(part), "{part}: {content}");
        }
        let wrong = book.replace("a = b/c", "a = ").replace("../README.md", "gone.md");
        let error = preprocess(wrong.as_bytes(), Vec::new(), &crate::root()).unwrap_err();
        assert!(error.contains("docs/theory/a.md:2: ") && error.contains("gone.md"), "{error}");
    }
}
