//! Other laws in the `[random]` table of a case: an entry is put, replaced, or taken away; all else stays as it is.

use std::ops::Range as Span;

use crate::parse::CaseText;
use crate::random::{RANDOM, RandomEntry, Written};

impl CaseText {
    /// The text with laws in braces under names of `[random]`: those that are there are replaced, the others added, with the table where it
    /// is missing. `None` if one that is there, or the table, is not written in braces of its own. It is parsed like any other.
    ///
    /// ```
    /// use standfast_inputs::CaseText;
    ///
    /// let file = CaseText::parse("case.toml", "[body]\nfriction = 0.6  # measured\n")?;
    /// let text = file.with_laws(&[("friction", "{ normal = { sd = 0.08 } }")]);
    /// let random = "\n[random]\nfriction = { normal = { sd = 0.08 } }\n";
    /// assert_eq!(text, Some(format!("[body]\nfriction = 0.6  # measured\n{random}")));
    /// # Ok::<(), standfast_inputs::CaseError>(())
    /// ```
    pub fn with_laws(&self, laws: &[(&str, &str)]) -> Option<String> {
        let text = self.text();
        let mut edits: Vec<(Span<usize>, String)> = Vec::new();
        let mut added = String::new();
        for (name, law) in laws {
            match self.random_entry(name) {
                Some(entry) => edits.push((self.braces(entry)?, (*law).to_owned())),
                None => added += &format!("{} = {law}\n", key(name)),
            }
        }
        if !added.is_empty() {
            let place = self.place_for_laws()?;
            let is_last = place == text.len();
            let ends = text.is_empty() || text[..place].ends_with('\n');
            let before = if ends { "" } else { "\n" };
            let header =
                if is_last && !self.has_own_header() { format!("\n[{RANDOM}]\n") } else { String::new() };
            edits.push((place..place, format!("{before}{header}{added}")));
        }
        Some(edited(text, edits))
    }

    /// The text with another law of the same parameters, mean, sd and cov, under a name of `[random]`; `None` if that does not stand there.
    pub fn with_other_law(&self, name: &str, law: &str) -> Option<String> {
        let entry = self.random_entry(name)?;
        let takes = |parameter: &str| matches!(parameter, "mean" | "sd" | "cov");
        let span = self.braces(entry)?;
        let written = self.text().get(span.clone())?;
        let suits = !entry.parameters.is_empty() && entry.parameters.iter().all(|own| takes(&own.name));
        let at = word(written, entry.law).filter(|_| suits)?;
        let place = span.start + at..span.start + at + entry.law.len();
        Some(edited(self.text(), vec![(place, law.to_owned())]))
    }

    /// The text with another value of a parameter of a law, a number or a text with its unit, under its name or another; `None` if the law has
    /// none of that name.
    pub fn with_parameter(&self, name: &str, [from, to]: [&str; 2], value: &Written) -> Option<String> {
        let own = self.random_entry(name)?.parameters.iter().find(|own| own.name == from)?;
        let value = match value {
            Written::Number(number) => super::toml_number(*number),
            Written::Text(text) => format!("\"{text}\""),
            Written::List(_) | Written::Function(_) => return None,
        };
        // The name stands before the sign before the value.
        let before = self.text()[..own.span.start].trim_end().strip_suffix('=')?.trim_end();
        let start = before.strip_suffix(from)?.len();
        Some(edited(self.text(), vec![(own.span.clone(), value), (start..before.len(), to.to_owned())]))
    }

    /// The text without the law under a name of `[random]`; without the last one the table goes, but not its comments. `None` if it does not
    /// stand there in braces on a line of its own.
    pub fn without_law(&self, name: &str) -> Option<String> {
        let text = self.text();
        let random = self.random()?;
        let span = self.braces(self.random_entry(name)?)?;
        let line = line_of(text, &span);
        if random.named.len() > 1 {
            return Some(edited(text, vec![(line, String::new())]));
        }
        if !self.has_own_header() {
            return None;
        }
        Some(without(text, &random.span))
    }

    fn random_entry(&self, name: &str) -> Option<&RandomEntry> {
        self.random()?.named.iter().find(|entry| entry.name == name)
    }

    /// Span of the braces of an entry.
    fn braces(&self, entry: &RandomEntry) -> Option<Span<usize>> {
        braces(self.text(), &entry.span)
    }

    /// True if `[random]` has a header of its own.
    fn has_own_header(&self) -> bool {
        let header = self.random().and_then(|random| self.text().get(random.span.clone()));
        header.is_some_and(|header| {
            let inner = header.trim().strip_prefix('[').and_then(|rest| rest.strip_suffix(']'));
            inner.is_some_and(|inner| inner.trim() == RANDOM)
        })
    }

    /// Place at which entries of `[random]` are added: behind the last on a line of its own, or the end of the text.
    fn place_for_laws(&self) -> Option<usize> {
        let text = self.text();
        let Some(random) = self.random() else { return Some(text.len()) };
        if !self.has_own_header() {
            // Tables under headers of their own leave room for one of all.
            let is_header =
                text[random.span.start..].starts_with('[') || text[..random.span.start].ends_with('[');
            return is_header.then_some(text.len());
        }
        let header = line_of(text, &random.span).end;
        let end = next_header(text, header);
        let own = random.named.iter().filter_map(|entry| self.braces(entry));
        let last =
            own.filter(|span| (header..end).contains(&span.start)).map(|span| line_of(text, &span).end);
        Some(last.max().unwrap_or(header))
    }
}

/// A name as a key of TOML.
fn key(name: &str) -> String {
    let is_bare = |letter: char| letter.is_ascii_alphanumeric() || matches!(letter, '_' | '-' | '.');
    if name.chars().all(is_bare) { name.to_owned() } else { format!("\"{}\"", name.replace('"', "\\\"")) }
}

/// A text without a table, by the span of its header; its comments stay.
pub(super) fn without(text: &str, header: &Span<usize>) -> String {
    let Span { start, end: body } = line_of(text, header);
    let end = next_header(text, body);
    let comments = text[body..end].split_inclusive('\n').filter(|line| line.trim_start().starts_with('#'));
    // At the end of the text the empty line above goes with the table.
    let start = if text[..start].ends_with("\n\n") && end == text.len() { start - 1 } else { start };
    edited(text, vec![(start..end, comments.collect())])
}

/// A span, if there are braces at its ends.
pub(super) fn braces(text: &str, span: &Span<usize>) -> Option<Span<usize>> {
    let written = text.get(span.clone())?;
    (written.starts_with('{') && written.ends_with('}')).then(|| span.clone())
}

/// The whole lines of a span, with the end of the last.
pub(crate) fn line_of(text: &str, span: &Span<usize>) -> Span<usize> {
    let start = text[..span.start].rfind('\n').map_or(0, |at| at + 1);
    let end = text[span.end..].find('\n').map_or(text.len(), |at| span.end + at + 1);
    start..end
}

/// Beginning of the next line with a header.
pub(super) fn next_header(text: &str, from: usize) -> usize {
    let mut at = from;
    for line in text[from..].split_inclusive('\n') {
        if line.starts_with('[') {
            return at;
        }
        at += line.len();
    }
    text.len()
}

/// Place of a key in braces.
fn word(text: &str, key: &str) -> Option<usize> {
    let is_key = |(at, _): &(usize, &str)| {
        let before = text[..*at].chars().next_back();
        let after = text[at + key.len()..].trim_start();
        before.is_some_and(|letter| matches!(letter, '{' | ',' | ' ' | '\t')) && after.starts_with('=')
    };
    text.match_indices(key).find(is_key).map(|(at, _)| at)
}

/// A text with other words at some spans.
pub(super) fn edited(text: &str, mut edits: Vec<(Span<usize>, String)>) -> String {
    edits.sort_by_key(|(span, _)| std::cmp::Reverse(span.start));
    let mut text = text.to_owned();
    for (span, words) in edits {
        text.replace_range(span, &words);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    const BODY: &str = "[body]\nwidth = 1\nheight = 2\nmass = 5e3\nfriction = 0.6 # measured";
    const RANDOM_TABLE: &str = "\n\n# Laws of practice.\n[random]\nyears = 50 # a life\nfriction = { lognormal = { cov = 0.15 }, lower = 0.2 } # dry\n\
                                # the sea\nwave.height = { gumbel = { mean = \"4.5 m\", sd = \"0.9 m\" } }\n\n[criteria]\np_not_rest = 0.1\n";

    fn file(text: &str) -> CaseText {
        CaseText::parse("t.toml", text).unwrap()
    }

    fn random() -> CaseText {
        // The names of [random] are looked up where the case is known.
        file(&format!("{BODY}{RANDOM_TABLE}"))
    }

    fn laws(text: &str) -> Vec<String> {
        let words = |entry: &RandomEntry| format!("{}: {}", entry.name, entry.law_words());
        file(text).random().map_or_else(Vec::new, |random| random.named.iter().map(words).collect())
    }

    #[test]
    fn a_table_is_added_and_taken_away_again() {
        for end in ["", "\n"] {
            let before = format!("{BODY}{end}");
            let text = file(&before)
                .with_laws(&[
                    ("friction", "{ normal = { sd = 0.1 } }"),
                    ("load[1].force", "{ normal = { cov = 0.1 } }"),
                ])
                .unwrap();
            assert!(text.starts_with(&before), "{text}");
            assert_eq!(laws(&text), ["friction: normal, sd 0.1", "load[1].force: normal, cov 0.1"]);
            let one = file(&text).without_law("load[1].force").unwrap();
            assert_eq!(laws(&one), ["friction: normal, sd 0.1"]);
            assert_eq!(file(&one).without_law("friction").unwrap(), format!("{BODY}\n"));
        }
    }

    #[test]
    fn a_law_is_replaced_with_its_comment_kept() {
        let file = random();
        let number = file.with_parameter("friction", ["cov", "cov"], &Written::Number(0.2)).unwrap();
        assert_eq!(number, file.text().replace("cov = 0.15", "cov = 0.2"));
        let sea = file.with_parameter("wave.height", ["sd", "sd"], &Written::Text("0.8 m".into())).unwrap();
        assert_eq!(sea, file.text().replace("\"0.9 m\"", "\"0.8 m\""));
        let share = file.with_parameter("wave.height", ["sd", "cov"], &Written::Number(0.2)).unwrap();
        assert_eq!(share, file.text().replace("sd = \"0.9 m\"", "cov = 0.2"));
        assert_eq!(file.with_parameter("friction", ["sd", "sd"], &Written::Number(0.2)), None);
        let other = file.with_other_law("friction", "normal").unwrap();
        assert_eq!(other, file.text().replace("{ lognormal =", "{ normal ="));
        let whole = file.with_laws(&[("wave.height", "{ normal = { cov = 0.2 } }")]).unwrap();
        assert!(
            whole.contains("# the sea\nwave.height = { normal = { cov = 0.2 } }\n\n[criteria]"),
            "{whole}"
        );
    }

    /// What is added stands behind the last law of the table, and what is taken away leaves its neighbours.
    #[test]
    fn laws_are_added_to_the_table_that_there_is() {
        let file = random();
        let text = file.with_laws(&[("bias.P", "{ lognormal = { mean = 0.9, cov = 0.2 } }")]).unwrap();
        assert!(
            text.contains(
                "sd = \"0.9 m\" } }\nbias.P = { lognormal = { mean = 0.9, cov = 0.2 } }\n\n[criteria]"
            ),
            "{text}"
        );
        assert_eq!(laws(&text).len(), 3);
        let less = file.without_law("friction").unwrap();
        assert!(less.contains("years = 50 # a life\n# the sea\nwave.height"), "{less}");
        let none = super::CaseText::parse("t.toml", &less).unwrap().without_law("wave.height").unwrap();
        assert!(none.ends_with("# Laws of practice.\n# the sea\n[criteria]\np_not_rest = 0.1\n"), "{none}");
    }

    /// A table that is written in another way is left to its author.
    #[test]
    fn what_is_not_in_braces_is_left_alone() {
        let file = file(&format!("{BODY}\n[random.friction]\nnormal = {{ cov = 0.1 }}\n"));
        assert_eq!(file.without_law("friction"), None);
        assert_eq!(file.with_other_law("friction", "lognormal"), None);
        let number = file.with_parameter("friction", ["cov", "cov"], &Written::Number(0.2)).unwrap();
        assert_eq!(number, file.text().replace("0.1", "0.2"));
        let more = file.with_laws(&[("mass", "{ normal = { cov = 0.03 } }")]).unwrap();
        assert_eq!(laws(&more).len(), 2, "{more}");
    }
}
