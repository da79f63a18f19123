//! The document: what stands on the sheet, and in which order.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use maud::{DOCTYPE, Markup, PreEscaped, html};
use standfast_cases::assess::figures_of;
use standfast_cases::key::TITLE_BLOCK;
use standfast_cases::motion::FirstInstant;
use standfast_cases::units::Extent;
use standfast_cases::{AnswerFigure, Assessment, AssessmentView, CaseFile, Key, Portion};
use standfast_figures::Figure;

use crate::calculation::Situations;
use crate::probability::Chance;
use crate::{Date, SheetError, calculation, in_time, inputs, limits, method, sensitivity, verdict};

/// The case file, and the day.
pub struct Source<'a> {
    /// The file's name without folders.
    pub file: &'a str,
    pub case_file: &'a CaseFile,
    /// The case in time, where it is one.
    pub in_time: Option<(&'a CaseFile, &'a FirstInstant)>,
    /// SHA-256 of the text.
    pub hash: String,
    /// The other files that were read, as records, each with its SHA-256.
    pub files: Vec<(String, String)>,
    pub date: Option<Date>,
    /// Entries of the title block that go before the file's.
    pub title_block: &'a [(Key, String)],
}

impl Source<'_> {
    /// True if an entry of the title block is told under any of these keys.
    fn tells(&self, keys: &[Key]) -> bool {
        keys.iter().any(|key| self.told(*key).is_some())
    }

    /// Number of rows of a title block without room for what is not told, less those of other files.
    pub fn head_rows(&self) -> usize {
        3 + TITLE_BLOCK.chunks(2).filter(|pair| self.tells(pair)).count()
    }

    /// Entry of the title block under a key, in a line; the command line's before the file's.
    pub fn told(&self, key: Key) -> Option<String> {
        let first =
            self.title_block.iter().rev().find(|(other, _)| *other == key).map(|(_, text)| text.as_str());
        let text = one_line(first.or_else(|| self.case_file.inputs().text(key))?);
        (!text.is_empty()).then_some(text)
    }
}

pub const VERSION: &str = env!("CARGO_PKG_VERSION");

const STYLE: &str = include_str!("sheet.css");

/// The faces: name, weight, file.
const FACES: [(&str, &str, &[u8]); 3] = [
    ("Sheet Text", "400", include_bytes!("../fonts/regular.woff2")),
    ("Sheet Text", "600", include_bytes!("../fonts/semibold.woff2")),
    ("Sheet Math", "400", include_bytes!("../fonts/math.woff2")),
];

pub fn render(
    assessment: &Assessment,
    source: &Source<'_>,
    view: &AssessmentView,
    portion: Portion<'_>,
) -> Result<String, SheetError> {
    let case = &assessment.case;
    let situations = Situations::of(assessment, view);
    let (section, figures): (Vec<_>, Vec<_>) =
        figures_of(assessment, &situations.full, view.up_to)?.into_iter().partition(AnswerFigure::is_section);
    let sensitivities = sensitivity::table(source.case_file)?;
    let chance = Chance::of(source.case_file, portion)?;
    let tops = verdict::tops(assessment, chance.as_ref().and_then(Chance::answer));
    let title = case.title.as_deref().map_or_else(|| source.file.to_owned(), one_line);
    let note = case.note.as_deref().map(one_line);
    let calculation = calculation::steps(assessment, &situations, source.case_file.inputs(), view)?;
    let inputs = inputs::tables(case, source.case_file);
    let of = match case.extent {
        Extent::PerMetre => "per metre run",
        Extent::Whole => "those of the whole object",
    };
    // In words as far as sentences have them.
    let digits = match case.output.digits() {
        None | Some(5) => "five".to_owned(),
        Some(count) => count.to_string(),
    };
    let in_time = assessment.in_time.as_ref().filter(|in_time| !in_time.motions.is_empty());
    let in_time = in_time.map(|in_time| in_time::figures(in_time).map(|figures| (in_time, figures)));
    let in_time = in_time.transpose()?;
    // Sections after the motion move on by one, if there is a motion.
    let later = |number: usize| number + usize::from(in_time.is_some());
    let last = later(6) + usize::from(chance.is_some());
    let warned = match in_time.is_some() {
        true => format!("in sections 5 and {last}"),
        false => format!("in section {last}"),
    };
    let moving: &[AnswerFigure] = in_time.as_ref().map_or(&[], |(_, figures)| figures);
    let drawn: Vec<&AnswerFigure> = section.iter().chain(moving).chain(&figures).collect();
    let document = html! {
        (DOCTYPE)
        html lang="en" {
            (head("calculation sheet", &title, source, &printed_widths(&drawn)))
            body {
                main {
                    (title_block("Calculation sheet: initiation of motion of a freestanding body", note.as_deref(), &title, source, true))
                    (verdict::summary(assessment, &tops, chance.as_ref(), &warned))
                    section {
                        h2 { "1 Inputs" }
                        (inputs)
                        @for (i, figure) in section.iter().enumerate() { (drawing(i, figure)) }
                        @if let Some((file, first)) = source.in_time { (in_time::inputs(file, first, case.plan.is_some())) }
                    }
                    section { h2 { "2 Assumptions and method" } (method::words(assessment)) }
                    section {
                        h2 { "3 Calculation" }
                        p.note {
                            "Each step: the formula, the same with numbers put in, the result. Numbers are carried at full \
                             precision and shown to " (digits) " significant digits; forces, masses and moments are "
                            (of) ". Numbers in parentheses are the report’s equations."
                        }
                        (calculation)
                    }
                    section { h2 { "4 Verdict" } (verdict::full(assessment, &situations)) }
                    @if let Some((in_time, figures)) = &in_time {
                        section {
                            h2 { "5 Motion in time" }
                            (in_time::motions(in_time, case))
                            @for (i, figure) in figures.iter().enumerate() { (drawing(section.len() + i, figure)) }
                        }
                    }
                    section { h2 { (later(5)) " Sensitivity" } (sensitivities) }
                    @if let Some(chance) = &chance {
                        section { h2 { (later(6)) " Probability" } (chance.section()) }
                    }
                    // On paper the last words stand with the signatures.
                    div.closing {
                        section {
                            h2 { (last) " What is not covered" }
                            (limits::words(case, in_time.is_some()))
                            @if in_time.is_some() { (in_time::limits()) }
                        }
                        section.signatures { h2 { (last + 1) " Signatures" } (signatures(source)) }
                    }
                    section {
                        h2 { (last + 2) " Figures" }
                        @for (i, figure) in figures.iter().enumerate() { (drawing(section.len() + moving.len() + i, figure)) }
                    }
                }
            }
        }
    };
    Ok(document.into_string())
}

pub fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn day(source: &Source<'_>) -> String {
    source.date.map_or("undated".to_owned(), |date| date.to_string())
}

/// The head of a sheet, of some kind, with the note under its title; with room for what is not told, or without.
pub fn title_block(kind: &str, note: Option<&str>, title: &str, source: &Source<'_>, room: bool) -> Markup {
    html! {
        header.title {
            p.kind { (kind) }
            h1 { (title) }
            @if let Some(note) = note { p.source { (note) } }
            table.block {
                tbody {
                    @for pair in TITLE_BLOCK.chunks(2).filter(|pair| room || source.tells(pair)) {
                        tr {
                            @for key in pair { th scope="row" { (heading(*key)) } td { (source.told(*key).unwrap_or_default()) } }
                        }
                    }
                    tr { th scope="row" { "Case file" } td { (source.file) } th scope="row" { "Date" } td { (day(source)) } }
                    tr { th scope="row" { "SHA-256" } td.hash colspan="3" { (spaced(&source.hash)) } }
                    @for (name, hash) in &source.files {
                        @let name = name.rsplit(['/', '\\']).next().unwrap_or(name);
                        tr { th scope="row" { "SHA-256 of " (name) } td.hash colspan="3" { (spaced(hash)) } }
                    }
                    tr { th scope="row" { "Program" } td colspan="3" { "standfast " (VERSION) } }
                }
            }
        }
    }
}

/// In groups of eight, so that it may be compared by eye.
fn spaced(hash: &str) -> String {
    hash.as_bytes().chunks(8).map(String::from_utf8_lossy).collect::<Vec<_>>().join(" ")
}

/// Heading of a field of the title block: its key, with a capital.
fn heading(key: Key) -> String {
    standfast_cases::capital(key.name())
}

/// Room for signatures, and what the checker confirms.
fn signatures(source: &Source<'_>) -> Markup {
    html! {
        table.block.sign {
            thead { tr { th {} th { "Name" } th { "Date" } th { "Signature" } } }
            tbody {
                @for key in [Key::Author, Key::Checker] {
                    tr { th scope="row" { (heading(key)) } td { (source.told(key).unwrap_or_default()) } td {} td {} }
                }
                tr { th scope="row" { "Approved" } td {} td {} td {} }
            }
        }
        p.note {
            "The checker confirms the inputs against their sources, the assumptions against the structure, and the calculation \
             by following its steps."
        }
    }
}

/// A figure, its glyphs renamed so that those of several do not clash.
pub fn drawing(index: usize, figure: &AnswerFigure) -> Markup {
    let own = format!("f{}-", index + 1);
    let svg = figure.figure.svg_on_paper();
    let svg = svg.replace("\"sf-", &format!("\"{own}")).replace("#sf-", &format!("#{own}"));
    html! {
        figure.section[figure.is_section()] id={ "figure-" (index + 1) } {
            (PreEscaped(svg))
            figcaption { "Figure " (index + 1) ". " (figure.words) "." }
        }
    }
}

/// Width of the text on A4, and the least size of type in a figure: 6 pt. In pixels, of which 96 make an inch.
pub const TEXT_WIDTH: f64 = 178.0 / 25.4 * 96.0;
pub const LEAST_TYPE: f64 = 8.0;
/// Scale at which a figure is printed whose type stays legible.
const PRINTED: f64 = 0.67;

/// Rules for the widths at which figures are printed.
fn printed_widths(figures: &[&AnswerFigure]) -> String {
    let rule = |(i, figure): (usize, &&AnswerFigure)| {
        format!("#figure-{} svg{{width:{:.0}px}}", i + 1, printed_width(&figure.figure).floor())
    };
    format!("@media print{{{}}}\n", figures.iter().enumerate().map(rule).collect::<String>())
}

/// Width at which a figure is printed: smaller than on the screen, as far as its smallest letters allow.
fn printed_width(figure: &Figure) -> f64 {
    let (width, _) = figure.size();
    let scale = PRINTED.max(LEAST_TYPE / least_type(figure.svg())).min(1.0);
    (scale * width).min(TEXT_WIDTH)
}

/// Size of the smallest letters of a figure, which are outlines in thousandths of it.
pub fn least_type(svg: &str) -> f64 {
    let scales = svg.split(") scale(").skip(1).filter_map(|rest| rest.split(' ').next()?.parse::<f64>().ok());
    scales.fold(f64::INFINITY, |least, scale| least.min(1000.0 * scale))
}

/// The head of a sheet of this kind, with the widths of its figures on paper.
pub fn head(kind: &str, title: &str, source: &Source<'_>, widths: &str) -> Markup {
    html! {
        head {
            meta charset="utf-8";
            meta name="viewport" content="width=device-width, initial-scale=1";
            meta name="generator" content={ "standfast " (VERSION) };
            title { (title) " – " (kind) }
            style { (PreEscaped(style(title, source) + widths)) }
        }
    }
}

/// The style with the faces, and what runs along the pages.
fn style(title: &str, source: &Source<'_>) -> String {
    let mut style = String::new();
    for (family, weight, bytes) in FACES {
        style += &format!(
            "@font-face{{font-family:\"{family}\";font-weight:{weight};src:url(data:font/woff2;base64,{}) format(\"woff2\")}}\n",
            STANDARD.encode(bytes)
        );
    }
    let told = |keys: &[Key], named: bool| {
        let told = keys.iter().filter_map(|key| Some((*key, source.told(*key)?)));
        let texts = told.map(|(key, text)| if named { format!("{} {text}", heading(key)) } else { text });
        texts.collect::<Vec<_>>()
    };
    let top = [told(&[Key::Project, Key::Client], false), vec![title.to_owned()]].concat();
    let file = format!("{} · SHA-256 {}…", source.file, &source.hash[..16]);
    let numbers = [told(&[Key::SheetNumber, Key::Revision], true), vec![day(source)]].concat();
    style += &format!(
        "@page{{@top-left{{content:{}}}@top-right{{content:{}}}@bottom-left{{content:{}}}@bottom-center{{content:{}}}}}\n",
        quoted(&top.join(" · ")),
        quoted(&numbers.join(" · ")),
        quoted(&file),
        quoted(&told(&[Key::Author, Key::Checker], true).join(" · ")),
    );
    style + STYLE
}

/// A text as a CSS string that cannot leave it, nor the style element.
fn quoted(text: &str) -> String {
    let escaped = text.chars().map(|c| match c {
        '"' | '\\' | '<' | '>' | '&' => format!("\\{:x} ", u32::from(c)),
        c if c.is_control() => " ".to_owned(),
        c => c.to_string(),
    });
    format!("\"{}\"", escaped.collect::<String>())
}
