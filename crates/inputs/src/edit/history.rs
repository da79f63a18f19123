//! Histories in the text of a case: one is put in the place of that which is there, or added to its table.

use super::random::{braces, edited, line_of, next_header};
use crate::key::Table;
use crate::parse::CaseText;

impl CaseText {
    /// The text with a history in braces, of the `index`-th table of its kind: in place of the one that is there, or added to the table that it
    /// stands in, `[motion.base]` too where it is missing. `None` if what is there is written in another way.
    ///
    /// ```
    /// use standfast_inputs::CaseText;
    /// use standfast_inputs::key::Table;
    ///
    /// let file = CaseText::parse("case.toml", "[body]\nwidth = 1  # drawing 12\n")?;
    /// let text = file.with_history(Table::BaseHorizontal, 0, "{ shape = \"file\", file = \"a.smc\" }");
    /// let base = "\n[motion.base]\nhorizontal = { shape = \"file\", file = \"a.smc\" }\n";
    /// assert_eq!(text, Some(format!("[body]\nwidth = 1  # drawing 12\n{base}")));
    /// # Ok::<(), standfast_inputs::CaseError>(())
    /// ```
    pub fn with_history(&self, table: Table, index: usize, written: &str) -> Option<String> {
        let text = self.text();
        if let Some(span) = self.header(table, index) {
            return Some(edited(text, vec![(braces(text, &span)?, written.to_owned())]));
        }
        let parent = table.parent().filter(|_| table.is_history())?;
        let line = format!("{} = {written}\n", table.name());
        let place = match self.header(parent, index) {
            Some(header) => {
                text.get(header.clone())?.starts_with('[').then_some(())?;
                let header = line_of(text, &header).end;
                let end = next_header(text, header);
                let own =
                    self.entries().iter().filter(|entry| (entry.id.table, entry.id.index) == (parent, index));
                let inner = parent.children().filter_map(|child| self.header(child, index));
                let all = own.map(|entry| entry.span.clone()).chain(inner);
                let last = all.filter(|span| (header..end).contains(&span.start));
                let last = last.map(|span| line_of(text, &span).end);
                last.max().unwrap_or(header)
            }
            None if parent == Table::Base => {
                let end = if text.ends_with('\n') || text.is_empty() { "" } else { "\n" };
                return Some(format!("{text}{end}\n[{}]\n{line}", parent.path(0)));
            }
            None => return None,
        };
        let end = if text[..place].ends_with('\n') { "" } else { "\n" };
        Some(edited(text, vec![(place..place, format!("{end}{line}"))]))
    }

    /// The text without a table under a header of its own; its comments stay. `None` if it is not there so.
    pub fn without_table(&self, table: Table) -> Option<String> {
        let text = self.text();
        let header = self.header(table, 0)?;
        text.get(header.clone())?.starts_with('[').then(|| super::random::without(text, &header))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "[body]\nwidth = 1\nheight = 2\nmass = 5e3\nfriction = 0.6 # measured\n\n[[load]]\nforce = 7\nelevation = 1 # m\n\n\
                        [[load]]\nforce = 8\nelevation = 2\nhistory = { shape = \"rect\", duration = 1 } # a blow\n\n[earthquake]\n# of 1985\nhorizontal = \"0.2 g\"\n";

    fn file() -> CaseText {
        CaseText::parse("t.toml", TEXT).unwrap()
    }

    #[test]
    fn a_history_is_put_where_it_belongs() {
        let written = "{ shape = \"decay\", duration = 2 }";
        let first = file().with_history(Table::LoadHistory, 0, written).unwrap();
        assert_eq!(
            first,
            TEXT.replace("elevation = 1 # m\n", &format!("elevation = 1 # m\nhistory = {written}\n"))
        );
        let second = file().with_history(Table::LoadHistory, 1, written).unwrap();
        assert_eq!(second, TEXT.replace("{ shape = \"rect\", duration = 1 }", written));
        let base = file().with_history(Table::BaseHorizontal, 0, written).unwrap();
        assert_eq!(base, format!("{TEXT}\n[motion.base]\nhorizontal = {written}\n"));
        for text in [first, second, base.clone()] {
            assert!(CaseText::parse("t.toml", &text).is_ok(), "{text}");
        }
        let both =
            CaseText::parse("t.toml", &base).unwrap().with_history(Table::BaseVertical, 0, written).unwrap();
        assert!(both.ends_with(&format!("horizontal = {written}\nvertical = {written}\n")), "{both}");
        assert_eq!(file().with_history(Table::WaveHistory, 0, written), None);
    }

    #[test]
    fn a_table_goes_and_its_comments_stay() {
        let without = file().without_table(Table::Earthquake).unwrap();
        assert_eq!(without, TEXT.replace("\n[earthquake]\n", "").replace("horizontal = \"0.2 g\"\n", ""));
        assert_eq!(file().without_table(Table::Wave), None);
    }
}
