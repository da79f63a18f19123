//! Errors as people see them.
//!
//! An error says what is wrong ([`Display`](std::fmt::Display)), where ([`Excerpt`]) and what helps. [`report`] and [`coloured`] draw
//! that for those who read text; who draws it otherwise takes the data.

use std::iter;
use std::ops::Range;

use annotate_snippets::renderer::Renderer;
use annotate_snippets::{Annotation, AnnotationKind, Group, Level, Snippet, Title, normalize_untrusted_str};

use crate::explained::{Excerpt, Explained};
use crate::layout::wrapped;

/// The widest line of a text that is shown whole, in columns with the line's number.
const WIDTH: usize = 100;

/// Columns before a line, with a number of six digits.
const MARGIN: usize = 9;

/// Columns that are underlined of a line that is longer, so that the renderer has room to cut it at both sides.
const UNDERLINED: usize = 72;

/// An error as a user sees it: the message on a line, the line of the text with the place underlined, and what to do. Nothing ends the
/// last line.
pub fn report(error: &dyn Explained) -> String {
    drawn(error, |message| Level::ERROR.no_name().primary_title(message), Renderer::plain())
}

/// A [`report`] for a terminal: with `error: ` before it, the message wrapped, and in colours.
pub fn coloured(error: &dyn Explained) -> String {
    let title = |message: String| wrapped(&message, "error: ".len()).join("\n");
    drawn(error, |message| Level::ERROR.primary_title(title(message)), Renderer::styled())
}

fn drawn(mut error: &dyn Explained, title: impl Fn(String) -> Title<'static>, renderer: Renderer) -> String {
    while let Some(cause) = error.passed_on() {
        error = cause;
    }
    let title = title(error.to_string());
    let help = error.help().map(|help| Group::with_title(Level::HELP.secondary_title(said(&help))));
    let renderer = renderer.term_width(WIDTH);
    let drawn = match error.excerpt().map(|excerpt| Lines::of(&excerpt)) {
        Some(lines) => {
            let wrong = title.element(lines.snippet());
            renderer.render(&iter::once(wrong).chain(help).collect::<Vec<_>>())
        }
        // Each by itself: together they would be joined by a line that comes from nothing.
        None => {
            let groups = iter::once(Group::with_title(title)).chain(help);
            groups.map(|group| renderer.render(&[group])).collect::<Vec<_>>().join("\n")
        }
    };
    drawn.lines().map(str::trim_end).collect::<Vec<_>>().join("\n")
}

/// A help in lines of a paragraph, followed by its example.
fn said(help: &str) -> String {
    let (sentence, example) = help.split_once('\n').unwrap_or((help, ""));
    let mut lines = wrapped(sentence, "help: ".len());
    lines.extend(example.lines().map(str::to_owned));
    normalize_untrusted_str(&lines.join("\n"))
}

/// The lines of a text that are shown, from the first to the last with a place.
struct Lines<'a> {
    name: &'a str,
    /// The number of the first, counted from one.
    first: usize,
    /// Each ended by a newline: without one the renderer knows of no line behind the last.
    text: String,
    /// The places in them.
    places: Vec<Range<usize>>,
}

impl<'a> Lines<'a> {
    fn of(excerpt: &Excerpt<'a>) -> Lines<'a> {
        let text = excerpt.text;
        let mut places: Vec<_> = excerpt.places.iter().map(|place| within_lines(text, place)).collect();
        let from = places.iter().map(|place| place.start).min().unwrap_or(0);
        let to = places.iter().map(|place| place.end).max().unwrap_or(0);
        let from = text[..from].rfind('\n').map_or(0, |newline| newline + 1);
        let to = text[to..].find('\n').map_or(text.len(), |newline| to + newline);
        if text[from..to].lines().any(|line| columns(line) + MARGIN > WIDTH) {
            places = fitting(text, &places);
        }
        for place in &mut places {
            *place = place.start - from..place.end - from;
        }
        let first = 1 + text[..from].matches('\n').count();
        Lines { name: excerpt.name, first, text: text[from..to].to_owned() + "\n", places }
    }

    fn snippet(&self) -> Snippet<'_, Annotation<'_>> {
        let kinds = iter::once(AnnotationKind::Primary).chain(iter::repeat(AnnotationKind::Context));
        let underlined = kinds.zip(&self.places).map(|(kind, place)| kind.span(place.clone()));
        Snippet::source(&self.text).path(self.name).line_start(self.first).annotations(underlined)
    }
}

/// A place that neither begins nor ends in what ends a line, nor inside a character, nor behind the text.
fn within_lines(text: &str, place: &Range<usize>) -> Range<usize> {
    let in_text = |offset: usize| {
        let offset = offset.min(text.len());
        (0..=offset).rev().find(|offset| text.is_char_boundary(*offset)).unwrap_or(0)
    };
    let before_newline = |offset: usize| match text[..offset].strip_suffix('\r') {
        Some(line) if text[offset..].starts_with('\n') => line.len(),
        _ => offset,
    };
    let start = before_newline(in_text(place.start));
    let marked = text[start..in_text(place.end).max(start)].trim_end_matches(['\r', '\n']);
    start..start + marked.len()
}

/// The parts of places that can be shown where lines are too long to be shown whole: on one line each, and not far to the right of
/// the first.
fn fitting(text: &str, places: &[Range<usize>]) -> Vec<Range<usize>> {
    let line_of = |offset: usize| text[..offset].rfind('\n').map_or(0, |newline| newline + 1);
    let column = |offset: usize| columns(&text[line_of(offset)..offset]);
    let from = places.first().map_or(0, |place| column(place.start));
    let shown = from..from + UNDERLINED;
    let part = |place: &Range<usize>| {
        let marked = text[place.clone()].lines().next().unwrap_or_default();
        let ends =
            marked.char_indices().map(|(end, _)| place.start + end).chain([place.start + marked.len()]);
        let end = ends.take_while(|end| column(*end) <= shown.end).last()?;
        shown.contains(&column(place.start)).then_some(place.start..end)
    };
    places.iter().filter_map(part).collect()
}

/// Number of columns that a line takes at most.
fn columns(line: &str) -> usize {
    let width = |sign: char| match sign {
        '\t' => 4,
        sign if sign.is_ascii() => 1,
        _ => 2,
    };
    line.chars().map(width).sum()
}

#[cfg(test)]
#[allow(clippy::single_range_in_vec_init)]
mod tests {
    use std::ops::Range;

    use thiserror::Error;

    use super::{Excerpt, Explained, UNDERLINED, coloured, report};

    #[derive(Debug, Default, Error)]
    #[error("{message}")]
    struct Wrong {
        message: String,
        help: Option<String>,
        text: Option<String>,
        places: Vec<Range<usize>>,
    }

    impl Explained for Wrong {
        fn help(&self) -> Option<String> {
            self.help.clone()
        }

        fn excerpt(&self) -> Option<Excerpt<'_>> {
            let text = self.text.as_deref()?;
            Some(Excerpt { name: "t.toml", text, places: self.places.clone() })
        }
    }

    /// Drawing below the message of an error of these places.
    fn shown<const N: usize>(text: &str, places: [Range<usize>; N]) -> String {
        let message = "wrong".into();
        let drawn =
            report(&Wrong { message, text: Some(text.into()), places: places.into(), ..Wrong::default() });
        drawn.strip_prefix("wrong\n").unwrap().to_owned()
    }

    fn lines<const N: usize>(lines: [&str; N]) -> String {
        lines.join("\n")
    }

    #[test]
    fn a_place_on_a_line() {
        let expected = lines([" --> t.toml:2:1", "  |", "2 | width = 1", "  | ^^^^^"]);
        assert_eq!(shown("[body]\nwidth = 1\nmass = 2\n", [7..12]), expected);
    }

    #[test]
    fn two_places() {
        let near = "mass = 2\nwidth = 1\ndensity = 3\n";
        let expected =
            [" --> t.toml:1:1", "  |", "1 | mass = 2", "  | ^^^^", "2 | width = 1", "3 | density = 3"];
        assert_eq!(shown(near, [0..4, 19..26]), lines(expected) + "\n  | -------");
        let far = format!("mass = 2\n{}density = 3\n", "#\n".repeat(9));
        let expected = ["  --> t.toml:11:1", "   |", " 1 | mass = 2", "   | ----", "...", "11 | density = 3"];
        assert_eq!(shown(&far, [27..34, 0..4]), lines(expected) + "\n   | ^^^^^^^");
    }

    #[test]
    fn a_place_over_several_lines() {
        let text = "x = [\n  1,\n  2,\n]\n";
        let expected = [" --> t.toml:1:5", "  |", "1 |   x = [", "  |  _____^", "2 | |   1,", "3 | |   2,"];
        assert_eq!(shown(text, [4..17]), lines(expected) + "\n4 | | ]\n  | |_^");
        // The end of the last line is none of another.
        assert_eq!(shown(text, [4..18]), shown(text, [4..17]));
        assert_eq!(shown(text, [11..16]), lines([" --> t.toml:3:1", "  |", "3 |   2,", "  | ^^^^"]));
    }

    #[test]
    fn tabs_and_wide_characters_are_underlined_where_they_are_seen() {
        let expected = lines([" --> t.toml:1:2", "  |", "1 |     width    = 1", "  |     ^^^^^      -"]);
        assert_eq!(shown("\twidth\t= 1\n", [1..6, 9..10]), expected);
        let expected = lines([" --> t.toml:1:9", "  |", "1 | k = \"中央\", 1", "  |           ^"]);
        assert_eq!(shown("k = \"中央\", 1\n", [12..13]), expected);
        // An accent of its own takes no room, and what would command the terminal is shown by a sign.
        let expected = lines([" --> t.toml:1:3", "  |", "1 | e\u{301}␛ = 1", "  |  ^"]);
        assert_eq!(shown("e\u{301}\u{1b} = 1", [3..4]), expected);
    }

    #[test]
    fn nothing_is_a_place_too() {
        assert_eq!(shown("", [0..0]), lines([" --> t.toml:1:1", "  |", "1 |", "  | ^"]));
        assert_eq!(shown("a = ", [4..4]), lines([" --> t.toml:1:5", "  |", "1 | a =", "  |     ^"]));
    }

    #[test]
    fn the_end_of_a_text() {
        assert_eq!(shown("a = 1\n", [6..6]), lines([" --> t.toml:2:1", "  |", "2 |", "  | ^"]));
        assert_eq!(shown("a = 1\n\n", [7..7]), lines([" --> t.toml:3:1", "  |", "3 |", "  | ^"]));
        // The newline itself belongs to the line that it ends.
        let expected = lines([" --> t.toml:1:6", "  |", "1 | a = 1", "  |      ^"]);
        assert_eq!(shown("a = 1\n", [5..6]), expected);
        assert_eq!(shown("a = 1", [5..5]), expected);
        // Behind the text, or inside a character.
        assert_eq!(shown("a = 1", [50..60]), expected);
        assert_eq!(shown("ü = 1", [1..2]), lines([" --> t.toml:1:1", "  |", "1 | ü = 1", "  | ^"]));
        let expected = [" --> t.toml:1:1", "  |", "1 | a", "  | ^", "2 | b", "3 |", "  | -"];
        assert_eq!(shown("a\nb\n", [0..1, 4..4]), lines(expected));
    }

    #[test]
    fn line_ends_of_windows() {
        let text = "a = 1\r\nb = \r\nc = 3\r\n";
        let expected = lines([" --> t.toml:2:5", "  |", "2 | b =", "  |     ^"]);
        assert_eq!(shown(text, [11..11]), expected);
        assert_eq!(shown(text, [12..13]), expected);
        assert_eq!(shown(text, [11..13]), expected);
        assert_eq!(shown(text, [7..13]), lines([" --> t.toml:2:1", "  |", "2 | b =", "  | ^^^^"]));
        assert_eq!(shown(text, [20..20]), lines([" --> t.toml:4:1", "  |", "4 |", "  | ^"]));
    }

    #[test]
    fn a_long_line_is_cut_around_the_place() {
        let text = format!("a = 1\nb = \"{}wrong{}\"\nc = 3\n", "ä".repeat(1000), "ö".repeat(1000));
        let start = text.find("wrong").unwrap();
        let drawn = shown(&text, [start..start + 5]);
        let drawn: Vec<&str> = drawn.lines().collect();
        // The place is that in the file.
        assert_eq!(drawn[0], " --> t.toml:2:1006");
        assert!(drawn[2].starts_with("2 | ...ää") && drawn[2].ends_with("öö..."), "{drawn:?}");
        assert!(drawn[2].chars().count() <= 100, "{drawn:?}");
        let marked = drawn[2].chars().zip(drawn[3].chars()).filter(|(_, mark)| *mark == '^');
        assert_eq!(marked.map(|(sign, _)| sign).collect::<String>(), "wrong");
        // Underlined as far as it is shown.
        let drawn = shown(&text, [start..text.len()]);
        assert!(drawn.lines().all(|line| line.chars().count() <= 100), "{drawn}");
        // Of another place that which can be shown beside the first.
        let text = text.replace("c = 3", &format!("long = [{}]", "3, ".repeat(100)));
        let drawn = shown(&text, [6..7, start..start + 5, text.len() - 310..text.len() - 2]);
        let expected = [" --> t.toml:2:1", "  |", "2 | b = \"ääää", "  | ^"];
        let all: Vec<&str> = drawn.lines().collect();
        assert!(expected.iter().zip(&all).all(|(expected, line)| line.starts_with(expected)), "{drawn}");
        assert_eq!(all[5], format!("  | {}", "-".repeat(UNDERLINED)));
        assert!(all.len() == 6 && all.iter().all(|line| line.chars().count() <= 100), "{drawn}");
    }

    /// Words are wrapped, and an example is left as it is to be copied.
    #[test]
    fn message_and_help() {
        let example = "[body]\n\nwidth = 15  # m";
        let mut error = Wrong {
            message: "ten words ".repeat(10).trim().into(),
            help: Some(format!("{}\n{example}", "and help ".repeat(11).trim())),
            ..Wrong::default()
        };
        let message = lines([&"ten words ".repeat(8)[..79], "ten words ten words"]);
        let help = lines([
            "help: and help and help and help and help and help and help and help and help and help",
            "      and help and help",
            "      [body]",
            "",
            "      width = 15  # m",
        ]);
        assert_eq!(report(&error), format!("{}\n{help}", error.message));
        error.text = Some("width = 15".into());
        error.places = Vec::from([0..5]);
        let place = lines([" --> t.toml:1:1", "  |", "1 | width = 15", "  | ^^^^^", "  |"]);
        assert_eq!(report(&error), format!("{}\n{place}\n{help}", error.message));
        // The program's has what it is before it, its message wrapped, and colours.
        let plain: String = coloured(&error)
            .split('\u{1b}')
            .map(|part| part.split_once('m').map_or(part, |(_, text)| text))
            .collect();
        assert_eq!(plain, format!("error: {}\n{place}\n{help}", message.replace('\n', "\n       ")));
    }

    #[test]
    fn whatever_the_text_and_the_places() {
        const SIGNS: [char; 12] =
            ['a', 'b', ' ', '\t', '\r', '\n', '\n', 'ä', '中', '\u{301}', '\u{200d}', '\u{1b}'];
        let mut state = 1_u64;
        let mut below = |bound: usize| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as usize % bound
        };
        for _ in 0..2000 {
            let length = below(12) * below(30);
            let text: String = (0..length).map(|_| SIGNS[below(SIGNS.len())]).collect();
            let mut place = || {
                let [one, two] = [below(text.len() + 3), below(text.len() + 3)];
                one.min(two)..one.max(two)
            };
            let drawn = shown(&text, [place(), place()]);
            assert!(drawn.starts_with(" --> t.toml:") || drawn.starts_with("  --> t.toml:"), "{drawn}");
        }
    }
}
