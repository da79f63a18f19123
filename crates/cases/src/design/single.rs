//! Least single changes, in words: a row for each number of the case.

use serde::Serialize;
use standfast::InputError;

use super::text::sentence;
use super::{DesignError, Found, SingleChange, SingleChanges, Target};
use crate::couple::Variable;
use crate::document::{AnswerFigure, Document};
use crate::json::SCHEMA;
use crate::layout::{columns, paragraph, row, significant};
use crate::summary::{Summary, warned_of_case};
use crate::units::Dimension;
use standfast_model::CaseFile;
use standfast_watch::Portion;

/// The least change of every number of a case that a person can change; JSON as `docs/changes.schema.json` has it.
pub struct ChangeList {
    /// The case and what is asked of it.
    pub of: SingleChanges,
    /// The changes, in the order of the file.
    pub changes: Vec<SingleChange>,
}

/// What the change of a number does, in words.
#[derive(Debug, Clone, Serialize)]
pub struct ChangeRow {
    /// The number, as `--vary` takes it.
    pub vary: String,
    /// Its meaning in a few words.
    pub words: String,
    /// `helps` if the target is met from a value on, `reserve` if it is met and not beyond a value, `free` if it is met whatever the value,
    /// `none` if no value helps.
    pub does: &'static str,
    /// The SI unit of its values; `None` of a plain number.
    pub unit: Option<&'static str>,
    /// Its present value.
    pub present: f64,
    /// The same with its unit, as the file has it.
    pub present_printed: String,
    /// The value from which on, or up to which, the target is met, as it is printed.
    pub value: Option<f64>,
    /// The same with its unit.
    pub printed: Option<String>,
    /// `least` if that is the least of the values that meet the target, `greatest` if it is the greatest.
    pub wanted: Option<&'static str>,
    /// How much that is more than the present value, as a share of it.
    pub share: Option<f64>,
    /// The same in per cent, with its sign.
    pub change: Option<String>,
    /// What fails just beyond it, or why no value helps.
    pub why: Option<String>,
    /// Other numbers that go with it, with their values.
    pub coupled: Vec<(String, String)>,
    /// Sentences on them.
    pub notes: Vec<String>,
}

/// The list as one JSON document.
#[derive(Serialize)]
struct Listed<'a> {
    schema: u32,
    title: Option<&'a str>,
    summary: Option<Summary>,
    target: String,
    caution: Option<&'static str>,
    changes: Vec<ChangeRow>,
}

/// What a list of changes is of, in a sentence.
pub fn changes_heading(of: &SingleChanges) -> String {
    let wanted = of.target.words();
    match of.is_met {
        true => format!("{} How far each number alone may go", sentence(wanted)),
        false => format!("One change with which {wanted}, the rest as it is"),
    }
}

/// What a list of changes does not tell, where motions decide.
pub fn changes_caution(of: &SingleChanges) -> Option<&'static str> {
    const MOTION: &str =
        "Each value is decided by one motion: a little beyond it the body may overturn again.";
    of.follows_motions().then_some(MOTION)
}

/// The meaning of a number in a few words; in more where another number of the list has the same.
pub fn number_words(of: &SingleChanges, variable: &Variable) -> String {
    let short = |variable: &Variable| {
        let words = variable.id().words();
        words.split_once("; ").map_or(words.clone(), |(short, _)| short.to_owned())
    };
    let words = short(variable);
    let is_another = |other: &&Variable| other.id() != variable.id() && short(other) == words;
    match of.variables.iter().find(is_another) {
        Some(_) => variable.key().info().words.to_owned(),
        None => words,
    }
}

impl ChangeRow {
    /// The row of a change.
    pub fn of(of: &SingleChanges, change: &SingleChange) -> ChangeRow {
        let SingleChange { quantity, found } = change;
        let share = change.share();
        let (does, end, is_least, why) = match found {
            Found::Helps(new) => ("helps", Some(&new.end), new.is_least, new.end.beyond.brief()),
            Found::Reserve(ends) => match change.limit() {
                Some(limit) => ("reserve", Some(limit), std::ptr::eq(limit, &ends[0]), limit.beyond.brief()),
                None => ("free", None, false, Some(format!("met from {} to {}", ends[0].text, ends[1].text))),
            },
            Found::Unmet(error) => ("none", None, false, Some(why_none(error))),
        };
        let coupled = match found {
            Found::Helps(new) => {
                new.coupled.iter().map(|(id, text)| (id.to_string(), text.clone())).collect()
            }
            _ => Vec::new(),
        };
        ChangeRow {
            vary: quantity.variable.name().to_owned(),
            words: number_words(of, &quantity.variable),
            does,
            unit: quantity.variable.dimension().map(Dimension::si),
            present: quantity.present,
            present_printed: quantity.shown(quantity.present),
            value: end.map(|end| end.rounded),
            printed: end.map(|end| end.text.clone()),
            wanted: end.map(|_| if is_least { "least" } else { "greatest" }),
            share,
            change: share.map(percent_more),
            why,
            coupled,
            notes: if does == "none" { Vec::new() } else { of.notes(&quantity.variable) },
        }
    }
}

/// Reason why no value of a number helps, beside its name.
fn why_none(error: &DesignError) -> String {
    match error {
        DesignError::NoInfluence { binding, .. } => format!("no value of it helps: {binding}"),
        DesignError::Unmet { range, best, .. } => format!("not {range}; {best}"),
        DesignError::NoCase { range, at, why, .. } => {
            format!("no value {range} makes a case; at {at}: {why}")
        }
        other => other.to_string(),
    }
}

/// A share as so many per cent more or less.
fn percent_more(share: f64) -> String {
    let percent = 100.0 * share.abs();
    let sign = if share < 0.0 { '-' } else { '+' };
    let number = match percent {
        100.0.. => format!("{percent:.0}"),
        0.1.. => format!("{percent:.1}"),
        _ => significant(percent, 1),
    };
    format!("{sign} {number} %")
}

impl ChangeList {
    /// The list of a case, as a portion of work that somebody may watch.
    ///
    /// # Errors
    /// As [`SingleChanges::of`]; if the work is stopped.
    pub fn of(
        file: &CaseFile,
        target: Option<Target>,
        portion: Portion<'_>,
    ) -> Result<ChangeList, DesignError> {
        let of = SingleChanges::of(file, target)?;
        let count = of.variables.len();
        let change = |(place, variable)| of.change(variable, portion.part(place, count));
        let changes = of.variables.iter().enumerate().map(change).collect::<Result<_, _>>()?;
        portion.reached(1.0);
        Ok(ChangeList { of, changes })
    }

    /// Rows of those that help, or that have a limit, in the order in which they are read, and of the others.
    fn rows(&self) -> [Vec<ChangeRow>; 2] {
        let all = self.changes.iter().map(|change| ChangeRow::of(&self.of, change));
        let (mut told, others): (Vec<_>, Vec<_>) = all.partition(|row| row.value.is_some());
        if self.of.is_met {
            let far = |row: &ChangeRow| row.share.map_or(f64::INFINITY, f64::abs);
            standfast::order::by_number(&mut told, far);
        }
        [told, others]
    }
}

impl Document for ChangeList {
    type View = ();

    fn summary(&self) -> Option<Summary> {
        let met = self.of.is_met;
        let [told, _] = self.rows();
        let least = told.iter().min_by(|one, two| {
            let far = |row: &ChangeRow| row.share.map_or(f64::INFINITY, f64::abs);
            far(one).total_cmp(&far(two))
        });
        let answer = least.map_or("No number alone changes that.".to_owned(), |row| {
            let (name, value, change) =
                (&row.vary, row.printed.as_deref().unwrap_or(""), row.change.as_deref().unwrap_or(""));
            match met {
                true => format!("The nearest limit is {name} = {value}, {change}."),
                false => format!("The least change that meets it is {name} = {value}, {change}."),
            }
        });
        let target = self.of.target;
        let (warnings, warned) = warned_of_case(&self.of.present.case.warnings());
        Some(Summary {
            criteria: Some(match met {
                true => format!("The case meets the target {target}."),
                false => format!("The case does not meet the target {target}."),
            }),
            answer,
            met: Some(met),
            governing: None,
            near: None,
            warnings,
            warned,
        })
    }

    fn text(&self, (): &()) -> String {
        let mut text = crate::assess::title(&self.of.present.case);
        text += &self.summary().map_or(String::new(), |summary| summary.text());
        text += "\n";
        text += &paragraph(&changes_heading(&self.of), 0);
        let [told, others] = self.rows();
        let cells = |row: &ChangeRow| {
            let [value, change] = [&row.printed, &row.change].map(|cell| cell.clone().unwrap_or_default());
            row![&row.vary, &row.present_printed, value, change]
        };
        text += &columns(&told.iter().map(cells).collect::<Vec<_>>(), 2, &[1, 2, 3]);
        text += &changes_caution(&self.of).map_or(String::new(), |caution| paragraph(caution, 2));
        let mut notes: Vec<&String> = Vec::new();
        for note in told.iter().flat_map(|row| &row.notes) {
            if !notes.contains(&note) {
                notes.push(note);
                text += &paragraph(note, 2);
            }
        }
        if !others.is_empty() {
            text += if self.of.is_met { "\nThese have no limit\n" } else { "\nThese do not help\n" };
        }
        for row in others {
            text += &paragraph(&format!("{}: {}.", row.vary, row.why.unwrap_or_default()), 2);
        }
        text
    }

    fn json(&self, (): &(), _: &[String]) -> String {
        let [told, others] = self.rows();
        crate::json::written(&Listed {
            schema: SCHEMA,
            title: self.of.present.case.title.as_deref(),
            summary: self.summary(),
            target: self.of.target.to_string(),
            caution: changes_caution(&self.of),
            changes: told.into_iter().chain(others).collect(),
        })
    }

    /// None: a list has no figure.
    fn figures(&self, (): &()) -> Result<Vec<AnswerFigure>, InputError> {
        Ok(Vec::new())
    }
}
