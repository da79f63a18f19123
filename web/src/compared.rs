//! A and B side by side: sentences on both, and a table of what differs.

use serde::Serialize;
use standfast_cases::compare::{Compared, Comparison};
use standfast_cases::motion::number_rows;
use standfast_cases::{Difference, Id, Summary};

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
    /// The case of a page, with the top and the rulers of its answer, beside the one that is pinned; `None` without one.
    pub fn of(page: &Page, summary: Option<&Summary>, rulers: &[Ruler]) -> Option<ComparedSaid> {
        let pinned = page.pinned.as_ref()?;
        let answered = page.answered();
        let differences = pinned.file.differences(page.file());
        let b = Compared { rest: answered.rest.as_ref(), motions: &answered.motions, summary };
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
        // A number below zero has a true minus sign; words keep their hyphens.
        Some(written) => match written.strip_prefix('-') {
            Some(digits) if digits.starts_with(|c: char| c.is_ascii_digit()) => format!("−{digits}"),
            _ => written.clone(),
        },
        None => "not given".to_owned(),
    };
    let words = difference.id.as_ref().map_or_else(|| "random number, its law".to_owned(), Id::words);
    ComparedRow { words, name: difference.name.clone(), cells: [cell(0), cell(1)], bad: [false; 2] }
}

/// The answers: what begins, where the body leaves rest, criteria or else factors, and numbers of motions.
fn answers(pinned: &Pinned, b: &Answered, compared: &Compared<'_>, rulers: &[Ruler]) -> Vec<ComparedRow> {
    let a = &pinned.answered;
    let begins = if a.is_in_time() && b.is_in_time() { "in the end" } else { "mode" };
    let mut rows = vec![ComparedRow::plain(begins, [mode(a), mode(b)])];
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
            words: ruler.words.split_once(", ").map_or(&ruler.words[..], |(short, _)| short).to_owned(),
            name: String::new(),
            cells: [one, two],
            bad: [one_bad, two_bad],
        }
    };
    b.iter().chain(others).map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::said::json;

    fn said(page: &Page) -> serde_json::Value {
        serde_json::from_str(&json(page)).unwrap()
    }

    fn rows(list: &serde_json::Value) -> Vec<[&str; 3]> {
        let all = list.as_array().unwrap().iter();
        all.map(|row| {
            let cell = |i: usize| row["cells"][i].as_str().unwrap();
            [row["words"].as_str().unwrap(), cell(0), cell(1)]
        })
        .collect()
    }

    /// By hand, as the browser's tests have it: 0.6 · 2.1 · 9.81 · 12 b / 2700, and 2.1 · 9.81 · 12 b²/23 / 2700.
    #[test]
    fn the_table_has_what_differs_and_both_answers() {
        let mut page = Page::default();
        page.pin();
        let same = said(&page);
        assert_eq!((&same["compared"]["answer"], &same["rulers"][0]["before"]), (&"".into(), &().into()));
        page.set("body.width", "17.6").unwrap();
        let said = said(&page);
        assert_eq!(rows(&said["compared"]["inputs"]), [["width of the body", "15 m", "17.6 m"]]);
        assert_eq!(said["compared"]["inputs"][0]["name"], "body.width");
        assert_eq!(
            rows(&said["compared"]["answers"]),
            [
                ["mode", "SRO−", "SL"],
                ["leaves rest at", "2225 kN/m", "2611 kN/m"],
                ["safety factor against sliding", "0.8240", "0.9669"],
                ["net safety factor against overturning", "0.8957", "1.233"],
            ]
        );
        let bad: Vec<_> = (2..4).map(|i| &said["compared"]["answers"][i]["bad"]).collect();
        assert_eq!(bad, [&serde_json::json!([true, true]), &serde_json::json!([true, false])]);
        assert_eq!(
            (&said["rulers"][0]["before"], &said["rulers"][1]["before"]),
            (&"0.8240".into(), &"0.8957".into())
        );
    }

    /// A criterion that one of both has is told in both columns; numbers of motions where they differ.
    #[test]
    fn criteria_and_motions_are_told_side_by_side() {
        let mut page = Page::default();
        page.pin();
        let text = format!("{}\n[criteria]\nSF_sliding = 0.5\n", page.text());
        assert!(page.edit(&text));
        let now = said(&page);
        let answers = rows(&now["compared"]["answers"]);
        assert_eq!(answers[2][1..], ["not asked", "0.8240"]);
        assert_eq!(rows(&now["compared"]["inputs"])[0][1..], ["not given", "0.5"]);
        let rack = crate::examples::find("server-rack-earthquake").unwrap();
        assert!(page.open(&rack.file(), rack.text));
        page.pin();
        page.set("body.friction", "0.2").unwrap();
        let now = said(&page);
        let slide: Vec<_> =
            rows(&now["compared"]["answers"]).into_iter().filter(|row| row[0] == "slide").collect();
        assert!(slide.len() == 1 && slide[0][1] != slide[0][2], "{slide:?}");
        assert!(now["compared"]["answer"].as_str().unwrap().contains(" B, with friction 0.2, "));
    }
}
