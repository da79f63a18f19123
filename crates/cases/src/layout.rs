//! Numbers, paragraphs and columns of the text output.

use comfy_table::{CellAlignment, Table, presets};

pub use standfast_inputs::digits::{apart, digits, factor, percent, plain, shortened, significant};

/// Widest line of a paragraph, in characters.
const WIDTH: usize = 88;

/// Words in lines of at most 88 characters, every line after `indent` spaces and ended by a newline.
pub fn paragraph(text: &str, indent: usize) -> String {
    wrapped(text, indent).iter().map(|line| format!("{:indent$}{line}\n", "")).collect()
}

/// Words in lines that have at most 88 characters after `indent` others; a longer word has a line of its own.
pub(crate) fn wrapped(text: &str, indent: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    // A number stays on one line with its percent sign, and an acceleration in brackets with its unit.
    let text = text.replace(" %", "\u{a0}%").replace(" g)", "\u{a0}g)");
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
    use super::{columns, paragraph};

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
