//! Numbers, paragraphs and columns of the text output.

use comfy_table::{CellAlignment, Table, presets};
use standfast::number;

/// Widest line of a paragraph, in characters.
const WIDTH: usize = 88;

/// Four significant digits, without trailing zeros.
pub fn digits(x: f64) -> String {
    significant(x, 4)
}

/// Different numbers in as few significant digits, four at least, as tell them apart.
pub fn apart(numbers: &[f64]) -> Vec<String> {
    let mut texts = Vec::new();
    for count in 4..=17 {
        texts = numbers.iter().map(|x| significant(*x, count)).collect();
        if texts.windows(2).all(|pair| pair[0] != pair[1]) {
            break;
        }
    }
    texts
}

/// A number in `count` significant digits, without trailing zeros; "unlimited" for infinity.
pub fn significant(x: f64, count: usize) -> String {
    if x == f64::INFINITY { "unlimited".to_owned() } else { number::significant(x, count).to_string() }
}

/// A number to all its digits, but for what binary fractions add behind the fifteenth.
pub fn plain(x: f64) -> String {
    significant(x, 15)
}

/// Words from a file, shortened where they would fill the screen.
pub fn shortened(written: &str) -> String {
    const MOST: usize = 120;
    match written.char_indices().nth(MOST) {
        Some((end, _)) => format!("{}…", &written[..end]),
        None => written.to_owned(),
    }
}

/// Words in lines of at most 88 characters, every line after `indent` spaces and ended by a newline.
pub fn paragraph(text: &str, indent: usize) -> String {
    wrapped(text, indent).iter().map(|line| format!("{:indent$}{line}\n", "")).collect()
}

/// Words in lines that have at most 88 characters after `indent` others; a longer word has a line of its own.
pub(crate) fn wrapped(text: &str, indent: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    // A number and its percent sign stay on one line.
    let text = text.replace(" %", "\u{a0}%");
    for word in text.split([' ', '\n']).filter(|word| !word.is_empty()) {
        let word = word.replace('\u{a0}', " ");
        match lines.last_mut() {
            Some(line) if line.chars().count() + 1 + word.chars().count() <= WIDTH - indent => {
                line.push(' ');
                line.push_str(&word);
            }
            _ => lines.push(word),
        }
    }
    lines
}

/// Rows in aligned columns, two spaces apart, every line after `indent` spaces and ended by a newline.
/// The columns named in `right` are aligned to the right.
pub fn columns(rows: &[Vec<String>], indent: usize, right: &[usize]) -> String {
    let mut table = Table::new();
    table.load_style(presets::NOTHING);
    rows.iter().for_each(|row| {
        table.add_row(row);
    });
    for (index, column) in table.column_iter_mut().enumerate() {
        column.set_padding((0, 2));
        if right.contains(&index) {
            column.set_cell_alignment(CellAlignment::Right);
        }
    }
    table.lines().map(|line| format!("{:indent$}{}\n", "", line.trim_end())).collect()
}

/// A row of [`columns`].
macro_rules! row {
    ($($cell:expr),* $(,)?) => { vec![$(String::from($cell)),*] };
}
pub(crate) use row;

#[cfg(test)]
mod tests {
    use super::{columns, digits, paragraph};

    #[test]
    fn numbers_in_text() {
        assert_eq!([digits(1.0 / 3.0), digits(-0.0), digits(f64::INFINITY)], ["0.3333", "0", "unlimited"]);
    }

    #[test]
    fn combining_marks_take_no_room() {
        let rows = [row!["θ̈", "1"], row!["ξξ", "20"]];
        assert_eq!(columns(&rows, 2, &[1]), "  θ̈    1\n  ξξ  20\n");
    }

    #[test]
    fn paragraphs_are_wrapped() {
        let text = "word ".repeat(40);
        assert!(paragraph(&text, 2).lines().all(|line| line.len() <= 88 && line.starts_with("  word")));
        assert_eq!(paragraph("", 2), "");
    }
}
