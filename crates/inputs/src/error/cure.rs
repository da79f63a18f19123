//! Edits that mend a text, where the help names one.

use std::ops::Range as Span;

use super::help::{known_word, line, meant_key};
use super::{CaseError, Problem};
use crate::explained::Explained;

/// An edit of the text that mends what is wrong.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Cure {
    /// Its words, as on a button.
    pub words: String,
    /// What it replaces in the text, in bytes; empty where it adds.
    pub span: Span<usize>,
    /// What stands there then.
    pub text: String,
}

impl Cure {
    /// The text after it.
    pub fn applied(&self, text: &str) -> String {
        let (before, after) = (text.get(..self.span.start), text.get(self.span.end..));
        [before.unwrap_or(text), &self.text, after.unwrap_or_default()].concat()
    }
}

impl CaseError {
    /// The edit that its [help](Explained::help) names: the key or the word that is likely meant, or the line that is missing.
    ///
    /// ```
    /// use standfast_inputs::CaseText;
    ///
    /// let text = "[body]\nheigth = 2\n";
    /// let cure = CaseText::parse("case.toml", text).unwrap_err().cure().expect("a key that is meant");
    /// assert_eq!(cure.words, "Write height");
    /// assert_eq!(cure.applied(text), "[body]\nheight = 2\n");
    /// ```
    pub fn cure(&self) -> Option<Cure> {
        let excerpt = self.excerpt()?;
        let (text, place) = (excerpt.text, excerpt.places.first()?.clone());
        let replaced = |word: &str| Cure {
            words: format!("Write {}", word.trim_matches('"')),
            span: place.clone(),
            text: word.to_owned(),
        };
        match self.problem() {
            Problem::UnknownKey { table, name } => meant_key(*table, name).map(replaced),
            Problem::OutOfRange { key, written, .. } => {
                known_word(*key, written).map(|word| replaced(&format!("\"{word}\"")))
            }
            // A table in braces has no line of its own behind its header.
            Problem::MissingKey { key, .. } if text.get(place.clone())?.starts_with('[') => {
                let line = line(*key);
                Some(Cure {
                    words: format!("Add {line}"),
                    span: place.end..place.end,
                    text: format!("\n{line}"),
                })
            }
            Problem::MissingTable { table } => Some(Cure {
                words: format!("Add {}", table.header()),
                span: text.len()..text.len(),
                text: format!("\n{}\n", table.example()),
            }),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::{CaseText, Explained};

    fn mended(text: &str) -> (String, String) {
        let error = CaseText::parse("t.toml", text).unwrap_err();
        let cure = error.cure().unwrap_or_else(|| panic!("{error}: {:?}", error.help()));
        (cure.words.clone(), cure.applied(text))
    }

    #[test]
    fn what_is_meant_is_written() {
        let (words, text) = mended("# é\n[body]\nwidht = \"15 m\" # drawing\nheight = 2\n");
        assert_eq!(
            (words.as_str(), text.as_str()),
            ("Write width", "# é\n[body]\nwidth = \"15 m\" # drawing\nheight = 2\n")
        );
        let (words, text) = mended("[ground]\nlaw = \"hansn\"\n");
        assert_eq!((words.as_str(), text.as_str()), ("Write hansen", "[ground]\nlaw = \"hansen\"\n"));
    }

    #[test]
    fn what_has_no_cure_has_none() {
        for text in ["", "[body]\nwidth = \"15 kg\"\n", "[body\n", "[body]\nxyz = 1\n"] {
            assert_eq!(CaseText::parse("t.toml", text).unwrap_err().cure(), None, "{text}");
        }
    }
}
