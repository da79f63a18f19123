//! The document: what stands on the sheet, and in which order.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use maud::{DOCTYPE, Markup, PreEscaped, html};
use standfast_cases::key::TITLE_BLOCK;
use standfast_cases::motion::FirstInstant;
use standfast_cases::units::Extent;
use standfast_cases::{AnswerFigure, Assessment, AssessmentView, Case, CaseFile, Document, Key, Portion};
use standfast_figures::Figure;

use crate::{
    Date, SheetError, calculation, in_time, inputs, limits, method, probability, sensitivity, verdict,
};

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
    /// Entry of the title block under a key, in a line; the command line's before the file's.
    fn told(&self, key: Key) -> Option<String> {
        let first =
            self.title_block.iter().rev().find(|(other, _)| *other == key).map(|(_, text)| text.as_str());
        let text = one_line(first.or_else(|| self.case_file.inputs().text(key))?);
        (!text.is_empty()).then_some(text)
    }
}

const VERSION: &str = env!("CARGO_PKG_VERSION");

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
    let (section, figures): (Vec<_>, Vec<_>) =
        assessment.figures(view)?.into_iter().partition(|figure| figure.is_section());
    let sensitivities = sensitivity::table(source.case_file)?;
    let probability = probability::section(source.case_file, portion)?;
    let title = case.title.as_deref().map_or_else(|| source.file.to_owned(), one_line);
    let calculation = calculation::steps(assessment, source.case_file.inputs(), view)?;
    let inputs = inputs::tables(case, source.case_file);
    let of = match case.extent {
        Extent::PerMetre => "per metre run",
        Extent::Whole => "those of the whole object",
    };
    let in_time = assessment.in_time.as_ref().filter(|in_time| !in_time.motions.is_empty());
    let in_time = in_time.map(|in_time| in_time::figures(in_time).map(|figures| (in_time, figures)));
    let in_time = in_time.transpose()?;
    // Sections after the motion move on by one, if there is a motion.
    let later = |number: usize| number + usize::from(in_time.is_some());
    let last = later(7) + usize::from(probability.is_some());
    let moving = in_time.as_ref().map_or(0, |(_, figures)| figures.len());
    let document = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="generator" content={ "standfast " (VERSION) };
                title { (title) " – calculation sheet" }
                style { (PreEscaped(style(&title, source))) }
            }
            body {
                main {
                    (title_block(case, &title, source))
                    (verdict::summary(assessment))
                    section {
                        h2 { "1 Inputs" }
                        @for (i, figure) in section.iter().enumerate() { (of_case(i, figure)) }
                        (inputs)
                        @if let Some((file, first)) = source.in_time { (in_time::inputs(file, first)) }
                    }
                    section { h2 { "2 Assumptions and method" } (method::words(assessment)) }
                    section {
                        h2 { "3 Calculation" }
                        p.note {
                            "Each step: the formula, the same with numbers put in, the result. Numbers are carried at full \
                             precision and shown to five significant digits; forces, masses and moments are "
                            (of) ". Numbers in parentheses are the report’s equations."
                        }
                        (calculation)
                    }
                    section { h2 { "4 Verdict" } (verdict::full(assessment, view)) }
                    @if let Some((in_time, figures)) = &in_time {
                        section {
                            h2 { "5 Motion in time" }
                            (in_time::motions(in_time, case))
                            @for (i, figure) in figures.iter().enumerate() {
                                (drawing(section.len() + i, false, &figure.figure, &figure.words))
                            }
                        }
                    }
                    section {
                        h2 { (later(5)) " Figures" }
                        @for (i, figure) in figures.iter().enumerate() { (of_case(section.len() + moving + i, figure)) }
                    }
                    section { h2 { (later(6)) " Sensitivity" } (sensitivities) }
                    @if let Some(probability) = &probability {
                        section { h2 { (later(7)) " Probability" } (probability) }
                    }
                    section {
                        h2 { (last) " What is not covered" }
                        (limits::words(case, in_time.is_some()))
                        @if in_time.is_some() { (in_time::limits()) }
                    }
                    section.signatures { h2 { (last + 1) " Signatures" } (signatures(source)) }
                }
            }
        }
    };
    Ok(document.into_string())
}

fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn day(source: &Source<'_>) -> String {
    source.date.map_or("undated".to_owned(), |date| date.to_string())
}

fn title_block(case: &Case, title: &str, source: &Source<'_>) -> Markup {
    html! {
        header.title {
            p.kind { "Calculation sheet: initiation of motion of a freestanding body" }
            h1 { (title) }
            @if let Some(note) = &case.note { p.source { (one_line(note)) } }
            table.block {
                tbody {
                    @for pair in TITLE_BLOCK.chunks(2) {
                        tr.sign[pair.contains(&Key::Author)] {
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
    calculation::capital(key.name())
}

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

/// A figure of the case.
fn of_case(index: usize, figure: &AnswerFigure) -> Markup {
    drawing(index, figure.is_section(), &figure.figure, &figure.words)
}

/// A figure, its glyphs renamed so that those of several do not clash.
fn drawing(index: usize, is_section: bool, figure: &Figure, words: &str) -> Markup {
    let own = format!("f{}-", index + 1);
    let svg = figure.svg_on_paper().replace("\"sf-", &format!("\"{own}")).replace("#sf-", &format!("#{own}"));
    html! {
        figure.section[is_section] {
            (PreEscaped(svg))
            figcaption { "Figure " (index + 1) ". " (words) "." }
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
