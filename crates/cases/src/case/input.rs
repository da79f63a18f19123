//! The entries of a case file as they are written, for a sheet that has to show them.

use toml::de::{DeTable, DeValue};

use super::{Case, Number, Span};

/// An entry of a case file.
#[derive(Debug, Clone, PartialEq)]
pub struct Input {
    /// The table with its brackets, e.g. `[body]`; empty for what stands above all tables.
    pub table: String,
    /// Its place among tables of that name.
    pub index: usize,
    /// The key.
    pub key: String,
    /// The value as it is written, quotes and all.
    pub written: String,
    /// The comment behind it on its line.
    pub comment: Option<String>,
    /// The numbers it means: one, or those of a list; none for words.
    pub numbers: Vec<Number>,
}

/// All entries of the case file `text`, from which `case` was read, in their order. Title and note are no entries.
pub fn inputs(case: &Case, text: &str) -> Vec<Input> {
    let mut found = Vec::new();
    if let Ok(document) = DeTable::parse(text) {
        read(case, text, document.get_ref(), ("", 0), &mut found);
    }
    found.sort_by_key(|(start, _)| *start);
    found.into_iter().map(|(_, input)| input).collect()
}

fn read(
    case: &Case,
    text: &str,
    table: &DeTable<'_>,
    (name, index): (&str, usize),
    found: &mut Vec<(usize, Input)>,
) {
    for (key, value) in table.iter() {
        let key = key.get_ref().as_ref();
        match value.get_ref() {
            DeValue::Table(inner) => read(case, text, inner, (&format!("[{key}]"), 0), found),
            DeValue::Array(list) if list.iter().all(|item| item.get_ref().is_table()) => {
                for (index, item) in list.iter().enumerate() {
                    if let DeValue::Table(inner) = item.get_ref() {
                        read(case, text, inner, (&format!("[[{key}]]"), index), found);
                    }
                }
            }
            _ if name.is_empty() && matches!(key, "title" | "note") => {}
            _ => {
                let span = value.span();
                let list = format!("{key}[");
                let numbers = case.numbers.iter().copied().filter(|Number { id, .. }| {
                    let table = if id.table.starts_with('[') { id.table } else { "" };
                    (table, id.index) == (name, index) && (id.key == key || id.key.starts_with(&list))
                });
                let input = Input {
                    table: name.to_owned(),
                    index,
                    key: key.to_owned(),
                    written: text.get(span.clone()).unwrap_or_default().to_owned(),
                    comment: comment(text, &span),
                    numbers: numbers.collect(),
                };
                found.push((span.start, input));
            }
        }
    }
}

/// The comment behind a value on the line where it ends.
fn comment(text: &str, value: &Span) -> Option<String> {
    let rest = text.get(value.end..)?.lines().next()?;
    let comment = rest.trim_start().strip_prefix('#')?.trim();
    (!comment.is_empty()).then(|| comment.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_are_as_written_with_their_comments() {
        let text = "gravity = \"9.81 m/s2\"\ntitle = \"t # no comment\"\n[body]\nwidth = \"150 cm\" # drawing 12\nheight = 2\n\
                    mass = 5e3#\nfriction = 0.6\n[[load]]\nforce = 7\nelevation = 1\n[[load]]\nname = \"n # 2\"   # push\n\
                    force = \"1 kN/m\"\nelevation = 1\n";
        let case = Case::parse("t.toml", text).unwrap();
        let inputs = inputs(&case, text);
        let lines: Vec<_> = inputs
            .iter()
            .map(|input| {
                let numbers: Vec<_> = input.numbers.iter().map(|number| number.value).collect();
                let Input { table, index, key, written, comment, .. } = input;
                format!("{table}{index} {key} {written} {comment:?} {numbers:?}")
            })
            .collect();
        assert_eq!(
            lines,
            [
                "0 gravity \"9.81 m/s2\" None [9.81]",
                "[body]0 width \"150 cm\" Some(\"drawing 12\") [1.5]",
                "[body]0 height 2 None [2.0]",
                "[body]0 mass 5e3 None [5000.0]",
                "[body]0 friction 0.6 None [0.6]",
                "[[load]]0 force 7 None [7.0]",
                "[[load]]0 elevation 1 None [1.0]",
                "[[load]]1 name \"n # 2\" Some(\"push\") []",
                "[[load]]1 force \"1 kN/m\" None [1000.0]",
                "[[load]]1 elevation 1 None [1.0]",
            ]
        );
    }
}
