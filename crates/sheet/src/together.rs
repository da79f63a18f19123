//! Situations that are not calculated one by one: each formula once, and a column of results for each situation.

use std::collections::{BTreeMap, BTreeSet};

use maud::{Markup, html};

/// Content of an item of a calculation in a table of several situations.
pub enum Brief {
    /// A heading, under which rows stand.
    Heading(String),
    /// A sentence; one that a full calculation has as well is not said again.
    Note(String),
    /// Rows.
    Rows(Vec<Row>),
    /// A quantity that formulas use and no step gives: a row where situations differ in it.
    Known(Row, f64),
    /// The item as it is, below the table.
    Each,
    /// Nothing: rows or another section have it.
    Nothing,
}

/// A row: a quantity with its formula, and its value in one situation.
#[derive(Clone)]
pub struct Row {
    /// The quantity's name in formulas; empty of what has none.
    pub name: String,
    /// What tells the row from others: situations with the same key share it.
    pub key: String,
    /// Subject, in words.
    pub about: Markup,
    /// The quantity with its formula.
    pub head: Markup,
    /// Unit of the values.
    pub unit: Markup,
    /// The value.
    pub cell: Markup,
}

/// An item of a calculation: as it is in full, and in a table.
pub struct Item {
    pub full: Markup,
    pub brief: Brief,
}

/// A situation of the table: its place among all, and its title.
pub struct Column {
    pub index: usize,
    pub title: String,
}

/// A line of the table.
struct Line {
    key: String,
    content: Content,
}

enum Content {
    Cells {
        row: Row,
        cells: Vec<Option<Markup>>,
    },
    /// A sentence, and the columns that it is of.
    Note(Vec<usize>),
}

/// Lines under a heading.
struct Group {
    heading: String,
    lines: Vec<Line>,
}

/// The place of a key among lines of which those before `next` are passed; a new one stands at `next`.
fn place<T>(
    lines: &mut Vec<T>,
    next: &mut usize,
    is_it: impl Fn(&T) -> bool,
    new: impl FnOnce() -> T,
) -> usize {
    let at = lines.iter().position(is_it).unwrap_or_else(|| {
        lines.insert(*next, new());
        *next
    });
    *next = (*next).max(at + 1);
    at
}

/// What full calculations know, by which what is new is told.
struct Before<'a> {
    notes: BTreeSet<&'a str>,
    /// Keys of rows with their values.
    rows: BTreeMap<&'a str, Vec<&'a str>>,
    /// Names of quantities with the bits of their values, one for each calculation.
    known: Vec<(&'a str, u64)>,
    parts: usize,
}

impl<'a> Before<'a> {
    fn of(full: &[&'a [Item]], others: &[&'a [Item]]) -> Before<'a> {
        let parts = full.len() + others.len();
        let mut before = Before { notes: BTreeSet::new(), rows: BTreeMap::new(), known: Vec::new(), parts };
        for item in full.iter().copied().flatten() {
            match &item.brief {
                Brief::Note(text) => drop(before.notes.insert(text)),
                Brief::Rows(rows) => {
                    rows.iter().for_each(|row| before.rows.entry(&row.key).or_default().push(&row.cell.0))
                }
                _ => {}
            }
        }
        for items in full.iter().chain(others) {
            let mut last: Vec<(&str, u64)> = Vec::new();
            for item in *items {
                if let Brief::Known(row, value) = &item.brief {
                    last.retain(|(key, _)| *key != row.key);
                    last.push((&row.key, value.to_bits()));
                }
            }
            before.known.extend(last);
        }
        before
    }

    /// True if a quantity is the same in every calculation.
    fn is_common(&self, key: &str, value: f64) -> bool {
        let same = self.known.iter().filter(|(other, bits)| *other == key && *bits == value.to_bits());
        same.count() == self.parts
    }

    /// True of a line with the same values as every full calculation, none of which is a result of its own.
    fn has(&self, line: &Line, full: usize) -> bool {
        let Content::Cells { row, cells } = &line.content else { return false };
        if row.name.is_empty() {
            return false;
        }
        let is_it = |cell: &Option<Markup>, known: &[&str]| {
            let same = |cell: &Markup| known.iter().all(|known| *known == cell.0);
            cell.as_ref().is_some_and(|cell| same(cell) && !cell.0.contains("data-quantity"))
        };
        let known = self.rows.get(line.key.as_str());
        known.is_some_and(|known| known.len() == full && cells.iter().all(|cell| is_it(cell, known)))
    }
}

/// The table of the situations in `columns`, whose items are `others`, beside those calculated in full; `model` names these.
pub fn table(full: &[&[Item]], others: &[&[Item]], columns: &[Column], model: &str) -> Markup {
    let before = Before::of(full, others);
    let mut groups: Vec<Group> = Vec::new();
    for (column, items) in others.iter().enumerate() {
        fill(&mut groups, items, column, columns.len(), &before);
    }
    groups.iter_mut().for_each(|group| group.lines.retain(|line| !before.has(line, full.len())));
    groups.retain(|group| !group.lines.is_empty());
    html! {
        p.note {
            "By the formulas of " (model) ", where they stand with numbers put in: each formula once, and a column of values for \
             each situation. What is the same as there has no row."
        }
        table.numbers.together data-table="together" {
            thead {
                tr {
                    th { "Quantity" }
                    @for column in columns { th.n data-load=(column.index) { (column.title) } }
                    th {}
                }
            }
            @for group in &groups {
                tbody {
                    tr.group { th colspan=(columns.len() + 2) scope="rowgroup" { (group.heading) } }
                    @for line in &group.lines { (drawn(line, columns, &before)) }
                }
            }
        }
        @for (items, column) in others.iter().zip(columns) {
            @let each: Vec<&Markup> =
                items.iter().filter(|item| matches!(item.brief, Brief::Each)).map(|item| &item.full).collect();
            @if !each.is_empty() {
                div data-load=(column.index) {
                    p.note { (column.title) ":" }
                    @for markup in each { (markup) }
                }
            }
        }
    }
}

/// Puts the items of one situation into its column.
fn fill(groups: &mut Vec<Group>, items: &[Item], column: usize, columns: usize, before: &Before<'_>) {
    let named: BTreeSet<&str> = items
        .iter()
        .filter_map(|item| match &item.brief {
            Brief::Rows(rows) => Some(rows.iter().map(|row| row.name.as_str())),
            _ => None,
        })
        .flatten()
        .collect();
    let new = |heading: &str| Group { heading: heading.to_owned(), lines: Vec::new() };
    let (mut next_group, mut next_line) = (0, 0);
    let mut at = place(groups, &mut next_group, |group: &Group| group.heading.is_empty(), || new(""));
    for item in items {
        match &item.brief {
            Brief::Heading(heading) => {
                at = place(groups, &mut next_group, |group| group.heading == *heading, || new(heading));
                next_line = 0;
            }
            Brief::Note(text) if !before.notes.contains(text.as_str()) => {
                let lines = &mut groups[at].lines;
                let line = || Line { key: text.clone(), content: Content::Note(Vec::new()) };
                let found = place(lines, &mut next_line, |line| line.key == *text, line);
                if let Content::Note(of) = &mut lines[found].content {
                    of.push(column);
                }
            }
            Brief::Rows(rows) => {
                rows.iter().for_each(|row| put(&mut groups[at].lines, &mut next_line, row, column, columns));
            }
            Brief::Known(row, value)
                if !before.is_common(&row.key, *value) && !named.contains(row.name.as_str()) =>
            {
                put(&mut groups[at].lines, &mut next_line, row, column, columns);
            }
            _ => {}
        }
    }
}

fn put(lines: &mut Vec<Line>, next: &mut usize, row: &Row, column: usize, columns: usize) {
    let new = || {
        let content = Content::Cells { row: row.clone(), cells: vec![None; columns] };
        Line { key: row.key.clone(), content }
    };
    let found = place(lines, next, |line| line.key == row.key, new);
    if let Content::Cells { cells, .. } = &mut lines[found].content {
        cells[column] = Some(row.cell.clone());
    }
}

fn drawn(line: &Line, columns: &[Column], before: &Before<'_>) -> Markup {
    html! {
        @match &line.content {
            Content::Note(of) => {
                tr {
                    td.note colspan=(columns.len() + 2) {
                        @for (i, column) in of.iter().enumerate() { @if i > 0 { "; " } (columns[*column].title) }
                        ": " (crate::mathml::prose(&line.key).unwrap_or_default())
                    }
                }
            }
            Content::Cells { row, cells } => {
                tr data-symbol=[(!row.name.is_empty()).then_some(&row.name)] {
                    td.symbols {
                        // What no calculation above tells is told here.
                        @if !before.rows.contains_key(row.key.as_str()) && !row.about.0.is_empty() { span.about { (row.about) ": " } }
                        (row.head)
                    }
                    @for (cell, column) in cells.iter().zip(columns) {
                        td.n data-load=(column.index) { @match cell { Some(cell) => (cell), None => "–" } }
                    }
                    td.of { (row.unit) }
                }
            }
        }
    }
}
