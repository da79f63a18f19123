//! The sheet on one page: what a client or a checker reads first. Its numbers are those of the full sheet.

use maud::{DOCTYPE, Markup, html};
use standfast::Verdict;
use standfast_cases::assess::{AnyCheck, figures_of};
use standfast_cases::design::{Sensitivity, SensitivityChange, load_factor, sensitivities};
use standfast_cases::layout::factor;

use standfast_cases::random::{Probability, criterion_words, period_of};
use standfast_cases::{AnswerFigure, Assessed, Assessment, AssessmentView, Bound, Key, Portion};

use crate::document::{LEAST_TYPE, Source, TEXT_WIDTH, drawing, head, least_type, one_line, title_block};
use crate::probability::Chance;
use crate::sensitivity;
use crate::{SheetError, verdict};

/// Height of the page's text in pixels, of which 96 make an inch, less what estimates may miss.
const HEIGHT: usize = 985;
/// Height of a line of text, and of a row of a table of one line.
const LINE: usize = 15;
const ROW: usize = 17;
/// Height of a row of the title block.
const HEAD: usize = 21;
/// Letters in a line across the page, and in one of the cells of a criterion and of its situation.
const LETTERS: usize = 112;
const CRITERION_LETTERS: usize = 54;
const PLACE_LETTERS: usize = 36;
/// Widest section beside which the inputs have room with their values, and with what a change of them does.
const BESIDE: f64 = 0.68 * TEXT_WIDTH;
const BESIDE_CHANGES: f64 = 0.45 * TEXT_WIDTH;
/// Largest number of inputs shown.
const INPUTS: usize = 10;
/// Largest number of situations that stand across the table of criteria.
const ACROSS: usize = 4;
/// Longest note under the title that is shown whole.
const NOTE: usize = 3 * LETTERS;

pub fn render(
    assessment: &Assessment,
    source: &Source<'_>,
    view: &AssessmentView,
    portion: Portion<'_>,
) -> Result<String, SheetError> {
    let case = &assessment.case;
    let section = figures_of(assessment, &[], view.up_to)?.into_iter().find(AnswerFigure::is_section);
    let chance = Chance::of(source.case_file, portion)?;
    let answer = chance.as_ref().and_then(Chance::answer);
    let tops = verdict::tops(assessment, answer);
    let title = case.title.as_deref().map_or_else(|| source.file.to_owned(), one_line);
    let note = case.note.as_deref().map(|note| shortened(&one_line(note)));
    // Where the ground fails before the body moves, neither factor of the body says what decides.
    let by_ground = assessment.least(load_factor).departure().verdict() == Some(Verdict::BearingFailure);
    let changes = if by_ground { LOAD_FACTOR } else { FACTORS };
    let inputs = deciding(sensitivities(source.case_file)?, changes);
    let rows = Asked::all(assessment, answer);
    let situations = assessment.worst_first();
    let places: Vec<String> = situations.iter().filter_map(|one| assessment.name(one)).collect();
    let places: Vec<&str> = places.iter().map(String::as_str).collect();
    let firsts = (0..rows.len()).filter(|&i| is_first(&rows, i)).map(|i| rows[i].height(true)).sum::<usize>();
    let across = (2..=ACROSS).contains(&places.len());
    let needed = match (rows.is_empty(), across) {
        (true, _) => assessment.all.len() + 1,
        (false, true) => (2 * ROW + firsts).div_ceil(ROW),
        (false, false) => {
            (0..rows.len()).map(|i| rows[i].height(is_first(&rows, i))).sum::<usize>().div_ceil(ROW)
        }
    };
    let room = Room::of(section.as_ref(), source, note.as_deref(), &verdict::words(&tops), needed);
    let inputs = &inputs[..inputs.len().min(room.inputs)];
    let (shown, left) = fitting(&rows, room.rows);
    let drawn = |figure: &AnswerFigure| {
        let own = format!("@media print{{#figure-1 svg{{width:{:.0}px}}}}\n", room.width.floor());
        (own, drawing(0, figure))
    };
    let (own, figure) = section.as_ref().map_or_else(Default::default, drawn);
    let document = html! {
        (DOCTYPE)
        html lang="en" {
            (head("calculation sheet in short", &title, source, &own))
            body.short {
                main {
                    (title_block("Calculation sheet in short: initiation of motion of a freestanding body", note.as_deref(), &title, source, false))
                    section.summary {
                        @if let Some(why) = chance.as_ref().and_then(Chance::why_not) { p.note { "No probability is found: " (why) "." } }
                        (verdict::lines(&tops, "on the full sheet"))
                    }
                    div.pair.beside[room.beside] {
                        (figure)
                        @if !inputs.is_empty() { div { h2 { "Inputs that decide" } (table_of_inputs(inputs, if !room.beside || room.width <= BESIDE_CHANGES { changes } else { &[] })) } }
                    }
                    h2 { "Criteria and combinations" }
                    @if rows.is_empty() {
                        (verdict::table(assessment, room.rows))
                        @if assessment.all.len() > room.rows { (left_out(assessment.all.len() - room.rows, assessment.all.len())) }
                        p.note { "The case file has no [criteria]." }
                    } @else if across && needed <= room.rows {
                        (table_across(&rows, &places))
                    } @else {
                        (table_of_criteria(shown))
                        @if left > 0 { (left_out(left, rows.len())) }
                    }
                    section.signatures { (signed(source)) }
                }
            }
        }
    };
    Ok(document.into_string())
}

/// A note, or as many of its first sentences as have room.
fn shortened(note: &str) -> String {
    if note.chars().count() <= NOTE {
        return note.to_owned();
    }
    let end = note.char_indices().nth(NOTE).map_or(note.len(), |(at, _)| at);
    let sentence = note[..end].rfind(". ").map_or_else(|| note[..end].rfind(' ').unwrap_or(end), |at| at + 1);
    format!("{} (The note goes on in the case file.)", &note[..sentence])
}

/// A result, and its change.
type Change = (&'static str, fn(&Sensitivity) -> SensitivityChange);

/// Results by which inputs are told apart: where the body moves first, and where the ground fails first.
const FACTORS: &[Change] = &[("SF of sliding", |row| row.sliding), ("of overturning", |row| row.overturning)];
const LOAD_FACTOR: &[Change] = &[("load factor of the ground", |row| row.load_factor)];

/// The inputs of which 1 % more changes a result, the one that changes it most first.
fn deciding(mut rows: Vec<Sensitivity>, changes: &[Change]) -> Vec<Sensitivity> {
    let effect = |row: &Sensitivity| {
        let changes = changes.iter().filter_map(|(_, change)| change(row).number());
        changes.map(f64::abs).fold(0.0, f64::max)
    };
    rows.retain(|row| effect(row) > 0.0);
    standfast::order::by_number(&mut rows, |one| -effect(one));
    rows
}

/// The inputs with their values, and with the changes for which there is room.
fn table_of_inputs(inputs: &[Sensitivity], changes: &[Change]) -> Markup {
    html! {
        table.numbers data-table="deciding" {
            thead {
                tr {
                    th { "Input" }
                    th.n { "Value" }
                    @for (i, (result, _)) in changes.iter().enumerate() {
                        th.n { @if i == 0 { "1 % more: " } (result) }
                    }
                }
            }
            tbody {
                @for row in inputs {
                    tr {
                        td { code { (row.variable.name()) } }
                        td.n { (sensitivity::value(row)) }
                        @for (_, change) in changes { td.n { (sensitivity::signed(change(row))) } }
                    }
                }
            }
        }
    }
}

/// Room for signatures side by side.
fn signed(source: &Source<'_>) -> Markup {
    html! {
        table.block.sign {
            thead { tr { th { "Author, date, signature" } th { "Checker, date, signature" } th { "Approved, date, signature" } } }
            tbody {
                tr {
                    @for key in [Key::Author, Key::Checker] { td { (source.told(key).unwrap_or_default()) } }
                    td {}
                }
            }
        }
        p.note { "Every step, with numbers put in, stands on the full sheet." }
    }
}

/// A criterion in one situation.
struct Asked {
    words: &'static str,
    name: &'static str,
    /// Required, value, utilisation, and whether it is met.
    cells: [String; 4],
    place: String,
    met: bool,
    used: f64,
}

impl Asked {
    /// Every criterion in every situation, what is not met first, then by utilisation.
    fn all(assessment: &Assessment, chance: Option<&Probability>) -> Vec<Asked> {
        let cells = |check: &AnyCheck<'_>| {
            let [required, value, utilisation, met] = check.cells();
            [required, value + &check.on_joint(), utilisation, met]
        };
        let of = |assessed: &Assessed, check: &AnyCheck<'_>| Asked {
            words: check.words(),
            name: check.name(),
            cells: cells(check),
            place: assessment.name(assessed).unwrap_or_default(),
            met: check.is_met(),
            used: match check {
                AnyCheck::Instant(check) => check.check.utilisation,
                AnyCheck::Motion(check, _) => check.utilisation,
            }
            .unwrap_or(if check.is_met() { 0.0 } else { f64::INFINITY }),
        };
        let all = assessment.worst_first().into_iter();
        let mut rows: Vec<Asked> = all
            .flat_map(|assessed| {
                let checks = assessment.checks_in(assessed);
                checks.iter().map(|check| of(assessed, check)).collect::<Vec<_>>()
            })
            .collect();
        rows.extend(chance.into_iter().flat_map(|chance| {
            chance.criteria.iter().map(move |check| {
                let (value, required) = criterion_words(check);
                let sign = if matches!(check.criterion.bound, Bound::AtLeast(_)) { "≥" } else { "≤" };
                let met = if check.is_met() { "met" } else { "not met" };
                Asked {
                    words: check.criterion.of_chance_words(),
                    name: check.criterion.name(),
                    cells: [format!("{sign} {required}"), value, factor(check.utilisation()), met.to_owned()],
                    place: period_of(chance, check),
                    met: check.is_met(),
                    used: check.utilisation(),
                }
            })
        }));
        rows.sort_by(|one, other| one.met.cmp(&other.met).then(other.used.total_cmp(&one.used)));
        rows
    }

    /// Value, utilisation, and whether it is met.
    fn cell(&self) -> Markup {
        let Asked { cells: [_, value, utilisation, met], met: is_met, .. } = self;
        html! { (value) " · " (utilisation) " " span.yes[*is_met].no[!is_met] { (met) } }
    }

    /// Height of its row; its words stand where it is `first`.
    fn height(&self, first: bool) -> usize {
        let lines = |text: usize, letters: usize| text.div_ceil(letters).max(1);
        let name = if first { self.words.chars().count() + self.name.len() + 1 } else { self.name.len() };
        let lines = lines(name, CRITERION_LETTERS).max(lines(self.place.chars().count(), PLACE_LETTERS));
        ROW + (lines - 1) * LINE
    }
}

/// As many rows as have room, and how many are left out.
fn fitting(rows: &[Asked], room: usize) -> (&[Asked], usize) {
    let mut height = 0;
    let count = rows.iter().enumerate().take_while(|(i, row)| {
        height += row.height(is_first(rows, *i));
        height <= room * ROW
    });
    let count = count.count();
    (&rows[..count], rows.len() - count)
}

/// True if no row above is of the same criterion.
fn is_first(rows: &[Asked], at: usize) -> bool {
    rows[..at].iter().all(|row| row.name != rows[at].name)
}

fn table_of_criteria(rows: &[Asked]) -> Markup {
    let placed = rows.iter().any(|row| !row.place.is_empty());
    html! {
        table.numbers data-table="criteria" {
            thead {
                tr {
                    th { "Criterion" } th { "Required" } th.n { "Value" } th.n { "Utilisation" } th {}
                    @if placed { th { "In" } }
                }
            }
            tbody {
                @for (i, row) in rows.iter().enumerate() {
                    @let Asked { words, name, cells: [required, value, utilisation, met], place, met: is_met, .. } = row;
                    tr {
                        td.name { @if is_first(rows, i) { (words) " " } code { (name) } }
                        td data-label="Required" { (required) }
                        td.n data-label="Value" { (value) }
                        td.n data-label="Utilisation" { (utilisation) }
                        td { span.yes[*is_met].no[!is_met] { (met) } }
                        @if placed { td data-label="In" { (place) } }
                    }
                }
            }
        }
    }
}

/// Criteria downwards and situations across: of a few situations.
fn table_across(rows: &[Asked], places: &[&str]) -> Markup {
    html! {
        table.numbers.across data-table="criteria" {
            thead {
                tr { th { "Criterion" } th { "Required" } @for place in places { th.n { (place) ": value, utilisation" } } }
            }
            tbody {
                @for (i, first) in rows.iter().enumerate().filter(|(i, _)| is_first(rows, *i)) {
                    tr {
                        td.name { (first.words) " " code { (first.name) } }
                        td data-label="Required" { (first.cells[0]) }
                        @if places.contains(&first.place.as_str()) {
                            @for place in places {
                                @let here = rows[i..].iter().find(|row| row.name == first.name && row.place == *place);
                                td.n data-label=(place) { @if let Some(row) = here { (row.cell()) } }
                            }
                        } @else {
                            td.n colspan=(places.len()) data-label=(first.place) { (first.place) " " (first.cell()) }
                        }
                    }
                }
            }
        }
    }
}

fn left_out(left: usize, all: usize) -> Markup {
    html! {
        p.note data-left=(left) {
            "Left out: " (left) " of " (all) " rows, those of which least is used. They stand in section 3 of the full sheet, which "
            code { "standfast sheet" } " writes without " code { "--short" } "."
        }
    }
}

/// Room of the parts that may be cut.
struct Room {
    /// Printed width of the section.
    width: f64,
    /// True if the inputs stand beside the section.
    beside: bool,
    inputs: usize,
    /// Rows of one line of the table of criteria.
    rows: usize,
}

impl Room {
    /// Room where `needed` rows of criteria are to be shown, if there is as much.
    fn of(
        section: Option<&AnswerFigure>,
        source: &Source<'_>,
        note: Option<&str>,
        words: &[String],
        needed: usize,
    ) -> Room {
        let (width, height) = section.map_or((0.0, 0.0), |figure| {
            let (width, height) = figure.figure.size();
            let scale = (LEAST_TYPE / least_type(figure.figure.svg())).min(1.0).min(TEXT_WIDTH / width);
            (scale * width, scale * height)
        });
        let lines = |text: &str| text.chars().count().div_ceil(LETTERS - 12).max(1);
        let head =
            3 * LINE + note.map_or(0, lines) * LINE + (source.head_rows() + 2 * source.files.len()) * HEAD;
        let summary: usize = words.iter().map(|words| lines(words) * (LINE + 2) + 4).sum();
        // Headings of two tables, their heads, and signatures.
        let fixed = head + summary + 2 * (LINE + 9) + 2 * ROW + 72;
        let figure = height.ceil() as usize + LINE;
        let free = HEIGHT.saturating_sub(fixed + figure) / ROW;
        let beside = width > 0.0 && width <= BESIDE;
        if beside {
            let inputs = (figure / ROW).saturating_sub(3).min(INPUTS);
            return Room { width, beside, inputs, rows: free.max(2) };
        }
        match free.saturating_sub(needed).min(INPUTS) {
            // Criteria go before inputs, whose heading and head have room then.
            0 | 1 => Room { width, beside, inputs: 0, rows: (free + (LINE + 9 + ROW) / ROW).max(2) },
            inputs => Room { width, beside, inputs, rows: free - inputs },
        }
    }
}
