//! Blocks of a page of the book: what a reader types, the files that he writes by it, and what is only shown.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::{fs, io};

/// A fenced block of a page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Block<'a> {
    /// The line at which its fence begins, from 1.
    pub line: usize,
    /// The word behind its fence.
    pub language: &'a str,
    /// What stands between its fences.
    pub text: &'a str,
}

/// A piece of a page: lines that are read, or a block.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Piece<'a> {
    /// Lines outside of blocks.
    Words(&'a str),
    /// A block, with its fences.
    Block(Block<'a>, &'a str),
}

/// The page in pieces, which together are the page.
pub fn pieces(page: &str) -> Vec<Piece<'_>> {
    let mut pieces = Vec::new();
    // Where the piece that is being read begins, and of a block its fence, where its text begins, its line and its language.
    let mut start = 0;
    let mut open: Option<(&str, usize, usize, &str)> = None;
    let mut at = 0;
    for (i, line) in page.split_inclusive('\n').enumerate() {
        let bare = line.trim();
        let ticks = &bare[..bare.len() - bare.trim_start_matches('`').len()];
        let end = at + line.len();
        match open {
            None if ticks.len() >= 3 => {
                if start < at {
                    pieces.push(Piece::Words(&page[start..at]));
                }
                start = at;
                let language = bare[ticks.len()..].split([',', ' ']).next().unwrap_or_default();
                open = Some((ticks, end, i + 1, language));
            }
            Some((fence, text, line, language)) if bare == fence => {
                let block = Block { line, language, text: &page[text..at] };
                pieces.push(Piece::Block(block, &page[start..end]));
                start = end;
                open = None;
            }
            _ => {}
        }
        at = end;
    }
    if start < page.len() {
        pieces.push(Piece::Words(&page[start..]));
    }
    pieces
}

/// The blocks of a page.
pub fn blocks(page: &str) -> Vec<Block<'_>> {
    let blocks = pieces(page).into_iter().filter_map(|piece| match piece {
        Piece::Words(_) => None,
        Piece::Block(block, _) => Some(block),
    });
    blocks.collect()
}

/// What a block of TOML is to its reader.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Toml<'a> {
    /// A file as it stands: its first line is a comment that names it.
    File(&'a str),
    /// What changes in a file: its first line is `# my.toml: changed`.
    Change(&'a str, &'a str),
    /// A part of a file.
    Part,
}

impl<'a> Toml<'a> {
    /// Reads the first line of a block.
    pub fn of(text: &'a str) -> Toml<'a> {
        let (first, rest) = text.split_once('\n').unwrap_or((text, ""));
        let Some(comment) = first.strip_prefix("# ") else { return Toml::Part };
        match comment.split_once(": ") {
            Some((name, "changed")) if is_file(name) => Toml::Change(name, rest),
            None if is_file(comment) => Toml::File(comment),
            _ => Toml::Part,
        }
    }
}

fn is_file(name: &str) -> bool {
    name.ends_with(".toml") && !name.contains(char::is_whitespace)
}

/// The files of a reader who has typed the blocks of TOML of a page.
#[derive(Debug, Clone, Default)]
pub struct Files(BTreeMap<String, String>);

impl Files {
    /// Takes a block; gives the file that it writes or changes.
    ///
    /// # Errors
    /// If a file is changed that no block wrote.
    pub fn take<'a>(&mut self, text: &'a str) -> Result<Option<&'a str>, String> {
        match Toml::of(text) {
            Toml::Part => Ok(None),
            Toml::File(name) => {
                self.0.insert(name.to_owned(), text.to_owned());
                Ok(Some(name))
            }
            Toml::Change(name, changes) => {
                let file = self.0.get_mut(name).ok_or_else(|| format!("no block before wrote {name}"))?;
                *file = changed(file, changes);
                Ok(Some(name))
            }
        }
    }

    /// Adds a file that a command wrote.
    pub fn add(&mut self, name: &str, text: String) {
        self.0.insert(name.to_owned(), text);
    }

    /// The text of a file.
    pub fn text(&self, name: &str) -> Option<&str> {
        self.0.get(name).map(String::as_str)
    }
}

/// A file in which each line of `changes` has taken the place of the line of the same key in the same table; what is new stands at
/// the end of its table, a table that is new at the end of the file.
fn changed(file: &str, changes: &str) -> String {
    let header =
        |line: &str| line.starts_with('[').then(|| line.split('#').next().unwrap_or(line).trim().to_owned());
    let key = |line: &str| line.split_once('=').map(|(key, _)| key.trim().to_owned());
    let mut lines: Vec<String> = file.lines().map(str::to_owned).collect();
    // The lines of the table that is being changed.
    let mut table = 0..lines.iter().position(|line| header(line).is_some()).unwrap_or(lines.len());
    for line in changes.lines().filter(|line| !line.trim().is_empty()) {
        if let Some(name) = header(line) {
            let start =
                lines.iter().position(|one| header(one).as_ref() == Some(&name)).unwrap_or_else(|| {
                    lines.extend([String::new(), line.to_owned()]);
                    lines.len() - 1
                });
            let rest = &lines[start + 1..];
            let length = rest.iter().position(|one| header(one).is_some()).unwrap_or(rest.len());
            table = start + 1..start + 1 + length;
            continue;
        }
        let place =
            key(line).and_then(|key_of| table.clone().find(|i| key(&lines[*i]) == Some(key_of.clone())));
        match place {
            Some(i) => lines[i] = line.to_owned(),
            None => {
                let last =
                    table.clone().rev().find(|i| !lines[*i].trim().is_empty()).map_or(table.start, |i| i + 1);
                lines.insert(last, line.to_owned());
                table.end += 1;
            }
        }
    }
    lines.join("\n") + "\n"
}

/// Commands of a block of a terminal, each with what it prints.
pub fn commands(text: &str) -> Vec<(&str, &str)> {
    let parts = text.split("\n$ ").enumerate();
    let parts = parts.map(|(i, part)| if i == 0 { part.strip_prefix("$ ").unwrap_or(part) } else { part });
    parts.map(|part| part.split_once('\n').unwrap_or((part, ""))).collect()
}

/// True if `expected` is what is printed, in which a line of `…` alone stands for any lines.
pub fn stands_in(output: &str, expected: &str) -> bool {
    let expected = expected.trim_end();
    let parts: Vec<&str> = expected.split("…\n").collect();
    let mut rest = output;
    for (i, part) in parts.iter().enumerate() {
        let part = part.strip_suffix('…').unwrap_or(part).trim_end_matches('\n');
        if part.is_empty() {
            continue;
        }
        let starts = |at: usize| (at == 0 && i == 0) || rest[..at].ends_with('\n') || (at == 0 && i > 0);
        let Some(at) = rest.match_indices(part).map(|(at, _)| at).find(|at| starts(*at)) else {
            return false;
        };
        if i == 0 && at > 0 {
            return false;
        }
        rest = &rest[at + part.len()..];
        // A line is shown whole.
        match rest.strip_prefix('\n') {
            Some(next) => rest = next,
            None if rest.is_empty() => {}
            None => return false,
        }
    }
    expected.ends_with('…') || expected.is_empty() || rest.trim().is_empty()
}

/// Every page of the book below a folder, in order.
///
/// # Errors
/// If the folder cannot be read.
pub fn all(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        // The paper is built apart.
        if path.is_dir() && !path.ends_with("docs/paper") {
            found.extend(all(&path)?);
        } else if path.extension().is_some_and(|ending| ending == "md") {
            found.push(path);
        }
    }
    found.sort();
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_is_its_pieces() {
        let page = "words\n```toml\n# a.toml\nx = 1\n```\nmore\n````text\n```\n````\nend";
        let pieces = pieces(page);
        let whole: String = pieces
            .iter()
            .map(|piece| match piece {
                Piece::Words(text) | Piece::Block(_, text) => *text,
            })
            .collect();
        assert_eq!(whole, page);
        let found = blocks(page);
        assert_eq!(found.len(), 2);
        assert_eq!(found[0], Block { line: 2, language: "toml", text: "# a.toml\nx = 1\n" });
        assert_eq!(found[1].text, "```\n");
    }

    #[test]
    fn a_change_takes_the_place_of_its_line() {
        let mut files = Files::default();
        files.take("# a.toml\ntitle = \"x\"\n[body]\nwidth = 1\nfriction = 0.6  # rough\n\n[[load]]\nforce = 2\n").unwrap();
        files
            .take("# a.toml: changed\n[body]\nfriction = 0.4\nheight = 3\n[ground]\nstrength = 4\n")
            .unwrap();
        assert_eq!(
            files.text("a.toml").unwrap(),
            "# a.toml\ntitle = \"x\"\n[body]\nwidth = 1\nfriction = 0.4\nheight = 3\n\n[[load]]\nforce = 2\n\n[ground]\nstrength = 4\n"
        );
        assert_eq!(files.take("[body]\nwidth = 2\n"), Ok(None));
        assert!(files.take("# b.toml: changed\nx = 1\n").is_err());
    }

    #[test]
    fn lines_are_shown_whole_and_in_order() {
        let output = "one\ntwo\nthree\nfour\n";
        for shown in [
            "one\ntwo\nthree\nfour\n",
            "one\n…\n",
            "…\nthree\nfour\n",
            "one\n…\nfour\n",
            "one\n…\nthree\n…\n",
            "",
        ] {
            assert!(stands_in(output, shown), "{shown:?}");
        }
        for shown in ["one\n", "two\n…\n", "one\n…\nthr\n…\n", "…\nthree\n…\ntwo\n…\n", "one\ntwo\n"]
        {
            assert!(!stands_in(output, shown), "{shown:?}");
        }
    }

    #[test]
    fn commands_have_what_they_print() {
        assert_eq!(commands("$ a b\nout\n$ c\n"), [("a b", "out"), ("c", "")]);
    }
}
