//! The text of a case file as errors show it: a line that would fill the screen is cut around what is underlined.

use std::collections::BTreeMap;
use std::ops::Range as Span;

use miette::{MietteError, MietteSpanContents, NamedSource, SourceCode, SourceSpan, SpanContents};

/// The longest line that is shown whole, in characters.
const LINE: usize = 200;

/// How much of a longer line is shown, in characters.
const SHOWN: usize = 120;

/// How much of that stands before what is underlined.
const BEFORE: usize = 40;

/// A text with its long lines cut.
#[derive(Debug)]
pub(crate) struct Excerpt {
    source: NamedSource<String>,
    /// By how many bytes a line, counted from zero, was shortened in front of what is shown.
    removed: BTreeMap<usize, usize>,
}

impl Excerpt {
    /// The text of a file with the places that are underlined, and these in it.
    pub(crate) fn new(name: &str, text: &str, mut spans: Vec<Span<usize>>) -> (Excerpt, Vec<Span<usize>>) {
        let mut shown = String::new();
        let mut removed = BTreeMap::new();
        let mut start = 0;
        let underlined = spans.clone();
        for (number, line) in text.split_inclusive('\n').enumerate() {
            let body = line.trim_end_matches(['\r', '\n']);
            let here = |span: &Span<usize>| start <= span.start && span.start < start + line.len();
            let first = underlined.iter().filter(|span| here(span)).map(|span| span.start - start).min();
            let window = window(body, first);
            let begin = shown.len();
            let head = if window.start > 0 { "…" } else { "" };
            shown += head;
            shown += &body[window.clone()];
            shown += if window.end < body.len() { "…" } else { "" };
            let end = shown.len();
            let place =
                |offset: usize| (begin + head.len() + (offset - start).saturating_sub(window.start)).min(end);
            for (span, underlined) in spans.iter_mut().zip(&underlined).filter(|(_, span)| here(span)) {
                *span = place(underlined.start)..place(underlined.end);
            }
            shown += &line[body.len()..];
            if window.start > 0 {
                removed.insert(number, window.start - head.len());
            }
            start += line.len();
        }
        // What stands behind the last line.
        for (span, _) in spans.iter_mut().zip(&underlined).filter(|(_, span)| span.start >= start) {
            *span = shown.len()..shown.len();
        }
        (Excerpt { source: NamedSource::new(name, shown), removed }, spans)
    }
}

/// The part of a line that is shown, around the first place that is underlined.
fn window(line: &str, first: Option<usize>) -> Span<usize> {
    if line.chars().nth(LINE).is_none() {
        return 0..line.len();
    }
    let before = line.get(..first.unwrap_or(0)).unwrap_or_default();
    let start = before.char_indices().rev().nth(BEFORE - 1).map_or(0, |(place, _)| place);
    let end = line[start..].char_indices().nth(SHOWN).map_or(line.len(), |(place, _)| start + place);
    start..end
}

impl SourceCode for Excerpt {
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        before: usize,
        after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let found = self.source.read_span(span, before, after)?;
        // Without context the place itself is asked for, which is said as it is in the file.
        let removed = if before == 0 { self.removed.get(&found.line()).copied() } else { None };
        Ok(Box::new(MietteSpanContents::new_named(
            self.source.name().to_owned(),
            found.data(),
            *found.span(),
            found.line(),
            found.column() + removed.unwrap_or(0),
            found.line_count(),
        )))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(text: &str, spans: &[Span<usize>]) -> (String, Vec<String>) {
        let (excerpt, places) = Excerpt::new("t.toml", text, spans.to_vec());
        let text = excerpt.source.inner().clone();
        let marked = places.iter().map(|span| text[span.clone()].to_owned()).collect();
        (text, marked)
    }

    #[test]
    fn ordinary_lines_stay_as_they_are() {
        let text = "[body]\r\nwidth = 1\n\nlast";
        assert_eq!(shown(text, &[8..13, 23..23]), (text.to_owned(), vec!["width".to_owned(), String::new()]));
        let line = "x".repeat(LINE);
        assert_eq!(shown(&line, std::slice::from_ref(&(LINE..LINE))).0, line);
    }

    #[test]
    fn a_long_line_is_cut_around_what_is_underlined() {
        let text = format!("a = 1\nü{}wrong{}\nb = 2\n", "ä".repeat(1000), "ö".repeat(1000));
        let start = text.find("wrong").unwrap();
        let place = start..start + 5;
        let (line, marked) = shown(&text, std::slice::from_ref(&place));
        assert_eq!(marked, ["wrong"]);
        let expected =
            format!("a = 1\n…{}wrong{}…\nb = 2\n", "ä".repeat(BEFORE), "ö".repeat(SHOWN - BEFORE - 5));
        assert_eq!(line, expected);
        // The place is that in the file, and the line is not longer than said.
        let (excerpt, places) = Excerpt::new("t.toml", &text, vec![place]);
        let span = SourceSpan::from(places[0].clone());
        let found = excerpt.read_span(&span, 0, 0).unwrap();
        assert_eq!((found.line(), found.column()), (1, start - 6));
        // Underlined as far as it is shown.
        let rest = start..text.len() - 8;
        let (_, marked) = shown(&text, std::slice::from_ref(&rest));
        assert!(marked[0].starts_with("wrong") && marked[0].ends_with('…'), "{marked:?}");
    }
}
