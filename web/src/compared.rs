//! A and B side by side: sentences on both, and a table of what differs.

use serde::Serialize;
use standfast_cases::compare::{Compared, Comparison};
use standfast_cases::motion::number_rows;
use standfast_cases::{Difference, Id};

use crate::answered::Answered;
use crate::page::Page;
use crate::pinned::Pinned;
use crate::said::{CheckRow, Ruler, checks_of, mode, rulers_of};

/// A case beside the one that is pinned, as the page says it.
#[derive(Debug, Serialize)]
pub struct ComparedSaid {
    /// Sentences on both; empty while nothing differs, when the answer is that of either.
    answer: String,
    criteria: String,
    near: String,
    /// What the files differ in.
    inputs: Vec<ComparedRow>,
    /// What the answers are.
    answers: Vec<ComparedRow>,
    can_swap: bool,
}

/// A row of the table.
#[derive(Debug, Serialize, PartialEq, Eq)]
pub struct ComparedRow {
    words: String,
    /// The entry of a file, or the criterion.
    name: String,
    cells: [String; 2],
    /// True of a cell that is not met.
    bad: [bool; 2],
}

impl ComparedRow {
    fn plain(words: &str, cells: [String; 2]) -> ComparedRow {
        ComparedRow { words: words.to_owned(), name: String::new(), cells, bad: [false; 2] }
    }
}

impl ComparedSaid {
    /// The case of a page beside the one that is pinned; `None` without one.
    pub fn of(page: &Page, rulers: &[Ruler]) -> Option<ComparedSaid> {
        let pinned = page.pinned.as_ref()?;
        let answered = page.answered();
        let differences = pinned.file.differences(page.file());
        let summary = answered.summary();
        let b =
            Compared { rest: answered.rest.as_ref(), motions: &answered.motions, summary: summary.as_ref() };
        let sentences = match differences.iter().all(Difference::is_label) {
            true => Comparison::default(),
            false => Comparison::of(&pinned.compared(), &b, &differences),
        };
        Some(ComparedSaid {
            answer: sentences.answer,
            criteria: sentences.criteria,
            near: sentences.near,
            inputs: differences.iter().map(input).collect(),
            answers: answers(pinned, answered, &b, rulers),
            can_swap: page.can_swap(),
        })
    }
}

/// A key with its values.
fn input(difference: &Difference) -> ComparedRow {
    let cell = |i: usize| match &difference.written[i] {
        Some(written) => written.replace('-', "−"),
        None => "not given".to_owned(),
    };
    let words = difference.id.as_ref().map_or_else(|| "random number, its law".to_owned(), Id::words);
    ComparedRow { words, name: difference.name.clone(), cells: [cell(0), cell(1)], bad: [false; 2] }
}

/// The answers: what begins, where the body leaves rest, criteria or else factors, and numbers of motions.
fn answers(pinned: &Pinned, b: &Answered, compared: &Compared<'_>, rulers: &[Ruler]) -> Vec<ComparedRow> {
    let a = &pinned.answered;
    let mut rows = vec![ComparedRow::plain("mode", [mode(a), mode(b)])];
    let leaves = [pinned.compared().leaves_rest(), compared.leaves_rest()];
    if leaves.iter().any(Option::is_some) {
        rows.push(ComparedRow::plain(
            "leaves rest at",
            leaves.map(|cell| cell.unwrap_or_else(|| "–".to_owned())),
        ));
    }
    let criteria = [checks_of(a), checks_of(b)];
    if criteria.iter().any(|checks| !checks.is_empty()) {
        rows.extend(checks(&criteria));
    } else {
        rows.extend(factors(&rulers_of(a), rulers));
    }
    let motions = [a, b].map(|answered| answered.motions.first().map(number_rows));
    if let [Some(one), Some(two)] = &motions {
        let differ = one.iter().zip(two).filter(|(one, two)| one[0] == two[0] && one[1] != two[1]);
        rows.extend(differ.map(|(one, two)| ComparedRow::plain(&one[0], [one[1].clone(), two[1].clone()])));
    }
    rows
}

/// The criteria that either has, those of B first.
fn checks([a, b]: &[Vec<CheckRow>; 2]) -> Vec<ComparedRow> {
    let mut names: Vec<(&str, &str)> = Vec::new();
    for check in b.iter().chain(a) {
        if !names.iter().any(|(name, _)| *name == check.name) {
            names.push((check.name, check.words));
        }
    }
    let of = |checks: &[CheckRow], name: &str| {
        let check = checks.iter().find(|check| check.name == name);
        check.map_or_else(|| ("not asked".to_owned(), false), |check| (check.value.clone(), !check.met))
    };
    let row = |(name, words): (&str, &str)| {
        let ((one, one_bad), (two, two_bad)) = (of(a, name), of(b, name));
        ComparedRow {
            words: words.to_owned(),
            name: name.to_owned(),
            cells: [one, two],
            bad: [one_bad, two_bad],
        }
    };
    names.into_iter().map(row).collect()
}

/// The safety factors that either has.
fn factors(a: &[Ruler], b: &[Ruler]) -> Vec<ComparedRow> {
    let others = a.iter().filter(|ruler| b.iter().all(|other| other.name != ruler.name));
    let of = |rulers: &[Ruler], name: &str| {
        let ruler = rulers.iter().find(|ruler| ruler.name == name);
        ruler.map_or_else(|| ("–".to_owned(), false), |ruler| (ruler.value.clone(), !ruler.good))
    };
    let row = |ruler: &Ruler| {
        let ((one, one_bad), (two, two_bad)) = (of(a, ruler.name), of(b, ruler.name));
        ComparedRow {
            words: ruler.words.clone(),
            name: String::new(),
            cells: [one, two],
            bad: [one_bad, two_bad],
        }
    };
    b.iter().chain(others).map(row).collect()
}
