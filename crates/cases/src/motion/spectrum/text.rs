//! A spectrum as text, JSON and CSV.

use std::fmt::Write;

use serde::Serialize;
use standfast_motion::spectrum::Rocked;

use standfast_answers::motion::{OVERTURNING_FROM, Spectrum, SpectrumPoints};

use crate::layout::{columns, paragraph, significant};
use crate::motion::json::WarningEntry;

/// At most so many rows of a table are printed.
const SHOWN: usize = 13;

/// Every key is there in every answer, as docs/spectrum.schema.json has them: `null`, or an empty list, where there is no such thing.
#[derive(Serialize)]
struct Document<'a> {
    schema: u32,
    kind: &'static str,
    title: Option<&'a str>,
    gravity: f64,
    peak: f64,
    stretches: Option<&'a [[f64; 2]]>,
    points: Vec<Entry>,
    warnings: Vec<WarningEntry<'a>>,
    figures: &'a [String],
}

#[derive(Serialize)]
#[serde(untagged)]
enum Entry {
    Block {
        size: f64,
        slenderness: f64,
        #[serde(flatten)]
        body: Body,
    },
    Body {
        scale: f64,
        #[serde(flatten)]
        body: Body,
    },
    Slide {
        ratio: f64,
        left: f64,
        right: f64,
        max_slide: f64,
        slide: f64,
    },
}

#[derive(Serialize)]
struct Body {
    max_theta: f64,
    max_theta_of_balance: f64,
    max_slide: f64,
    overturned: bool,
    impacts: usize,
    end: &'static str,
}

impl Body {
    fn of(body: &Rocked) -> Body {
        Body {
            max_theta: body.max_theta,
            max_theta_of_balance: body.of_balance,
            max_slide: body.max_slide,
            overturned: body.overturned,
            impacts: body.impacts,
            end: body.end.word(),
        }
    }

    fn cells(&self) -> String {
        let Body { max_theta, max_theta_of_balance, max_slide, overturned, impacts, end } = self;
        format!("{max_theta},{max_theta_of_balance},{max_slide},{overturned},{impacts},{end}")
    }
}

const BODY: &str = "max_theta,max_theta_of_balance,max_slide,overturned,impacts,end";

fn entries(spectrum: &Spectrum) -> Vec<Entry> {
    match &spectrum.points {
        SpectrumPoints::Rocking { sizes, slendernesses, blocks, .. } => blocks
            .iter()
            .enumerate()
            .map(|(i, body)| Entry::Block {
                size: sizes[i / slendernesses.len()],
                slenderness: slendernesses[i % slendernesses.len()],
                body: Body::of(body),
            })
            .collect(),
        SpectrumPoints::Newmark { ratios, slides } => ratios
            .iter()
            .zip(slides)
            .map(|(ratio, slid)| Entry::Slide {
                ratio: *ratio,
                left: slid.left,
                right: slid.right,
                max_slide: slid.both,
                slide: slid.residual,
            })
            .collect(),
        SpectrumPoints::Overturning { scales, bodies, .. } => scales
            .iter()
            .zip(bodies)
            .map(|(scale, body)| Entry::Body { scale: *scale, body: Body::of(body) })
            .collect(),
    }
}

/// The spectrum as a JSON document, in the units of the case, with the files of its figures if there are any.
pub(super) fn json(spectrum: &Spectrum, figures: &[String]) -> String {
    let warnings = spectrum.warnings.iter().map(WarningEntry::from);
    let stretches = match &spectrum.points {
        SpectrumPoints::Overturning { stretches, .. } => Some(&stretches[..]),
        _ => None,
    };
    crate::json::written(&Document {
        schema: 1,
        kind: spectrum.kind.word(),
        title: spectrum.title.as_deref(),
        gravity: spectrum.gravity,
        peak: spectrum.peak,
        stretches,
        points: entries(spectrum),
        warnings: warnings.collect(),
        figures,
    })
}

/// The points as CSV.
pub fn csv(spectrum: &Spectrum) -> String {
    let header = match spectrum.points {
        SpectrumPoints::Rocking { .. } => format!("size,slenderness,{BODY}"),
        SpectrumPoints::Newmark { .. } => "ratio,left,right,max_slide,slide".to_owned(),
        SpectrumPoints::Overturning { .. } => format!("scale,{BODY}"),
    };
    let mut text = header + "\n";
    for entry in entries(spectrum) {
        let _ = match entry {
            Entry::Block { size, slenderness, body } => {
                writeln!(text, "{size},{slenderness},{}", body.cells())
            }
            Entry::Body { scale, body } => writeln!(text, "{scale},{}", body.cells()),
            Entry::Slide { ratio, left, right, max_slide, slide } => {
                writeln!(text, "{ratio},{left},{right},{max_slide},{slide}")
            }
        };
    }
    text
}

/// The spectrum in words and numbers.
pub(super) fn text(spectrum: &Spectrum) -> String {
    let mut text = String::new();
    if let Some(title) = &spectrum.title {
        let _ = writeln!(text, "{title}\n");
    }
    text += &paragraph(&words(spectrum, 5), 0);
    let _ = write!(text, "\n{}", columns(&table(spectrum), 2, &[0, 1, 2, 3, 4]));
    for warning in &spectrum.warnings {
        let _ = writeln!(text, "Note ({}): {}.", warning.name, warning.words);
    }
    text
}

/// The unit of lengths, with a space before it, if they have one.
fn metres(spectrum: &Spectrum) -> &'static str {
    if spectrum.si { " m" } else { "" }
}

/// So many stretches are told one by one.
const TOLD: usize = 5;

/// Sentences on the motions followed and on their outcome, with so many digits of the factors at which one turns into another.
pub(super) fn words(spectrum: &Spectrum, digits: usize) -> String {
    let peak = format!("{} g", significant(spectrum.peak / spectrum.gravity, 3));
    match &spectrum.points {
        SpectrumPoints::Rocking { blocks, .. } => {
            let over = blocks.iter().filter(|block| block.overturned).count();
            let still = blocks.iter().filter(|block| block.max_theta == 0.0).count();
            format!(
                "{} uniform blocks on a base whose peak acceleration is {peak}: {still} do not rock, {over} overturn.",
                blocks.len()
            )
        }
        SpectrumPoints::Newmark { ratios, .. } => format!(
            "A block that can only slide, for {} yield accelerations, as shares of the base's peak, {peak}: to the left or to the \
             right only, as on a slope, and on level ground.",
            ratios.len()
        ),
        SpectrumPoints::Overturning { scales, stretches, .. } => {
            let number = |factor: f64| significant(factor, digits);
            let stretch = |[from, to]: &[f64; 2]| format!("from {} to {}", number(*from), number(*to));
            let found = match &stretches[..] {
                [] => "The body overturns at none of them.".to_owned(),
                all => {
                    let told = if all.len() <= TOLD { all.len() } else { TOLD - 1 };
                    let mut words: Vec<_> = all[..told].iter().map(stretch).collect();
                    if told < all.len() {
                        let (more, last) = (all.len() - told, all[all.len() - 1][1]);
                        words.push(format!("in {more} more stretches up to {}", number(last)));
                    }
                    let last = words.pop().unwrap_or_default();
                    let before = if words.is_empty() { "" } else { " and " };
                    format!("The body overturns {}{before}{last}.", words.join(", "))
                }
            };
            // From a little below where it overturns, or if it does not, anywhere.
            let least = stretches.first().map(|[from, _]| OVERTURNING_FROM * from);
            let is_near = |pair: &&[f64]| least.is_none_or(|least| pair[1] > least);
            let widest = scales.windows(2).filter(is_near).map(|pair| pair[1] / pair[0] - 1.0);
            let widest = widest.fold(0.0, f64::max);
            let missed = least.map_or("Stretches".to_owned(), |least| {
                format!("From {} on, stretches", significant(least, 2))
            });
            let monotone = match &stretches[..] {
                [] => true,
                [one] => scales.last() == Some(&one[1]),
                _ => false,
            };
            let says = if monotone { "" } else { " A stronger shaking may leave it standing." };
            format!(
                "The shaking was followed times {} factors from {} to {}; at 1 its peak is {peak}. {found}{says} {missed} narrower \
                 than {} % may have been missed.",
                scales.len(),
                significant(scales[0], 4),
                significant(scales[scales.len() - 1], 4),
                significant(100.0 * widest, 2)
            )
        }
    }
}

fn table(spectrum: &Spectrum) -> Vec<Vec<String>> {
    let number = |value: f64| significant(value, 5);
    let m = metres(spectrum);
    // So many of them, the first and the last among them.
    let chosen = |count: usize| -> Vec<usize> {
        let shown = SHOWN.min(count);
        (0..shown).map(|i| if shown < 2 { 0 } else { i * (count - 1) / (shown - 1) }).collect()
    };
    match &spectrum.points {
        SpectrumPoints::Rocking { sizes, slendernesses, blocks, .. } => {
            let head = ["height over width", "do not rock", "overturn", "the largest that does"];
            let mut rows = vec![head.map(str::to_owned).to_vec()];
            for j in chosen(slendernesses.len()) {
                let of = |i: usize| &blocks[i * slendernesses.len() + j];
                let count =
                    |test: &dyn Fn(&Rocked) -> bool| (0..sizes.len()).filter(|i| test(of(*i))).count();
                let largest = (0..sizes.len()).rev().find(|i| of(*i).overturned);
                rows.push(vec![
                    number(slendernesses[j]),
                    count(&|block| block.max_theta == 0.0).to_string(),
                    count(&|block| block.overturned).to_string(),
                    largest.map_or_else(|| "none".to_owned(), |i| format!("R = {}{m}", number(sizes[i]))),
                ]);
            }
            rows
        }
        SpectrumPoints::Newmark { ratios, slides } => {
            let head = ["yield over peak", "to the left", "to the right", "on level ground", "at the end"];
            let mut rows = vec![head.map(str::to_owned).to_vec()];
            for i in chosen(ratios.len()) {
                let slid = &slides[i];
                let slides = [slid.left, slid.right, slid.both, slid.residual];
                let mut row = vec![number(ratios[i])];
                row.extend(slides.map(|slide| number(slide) + m));
                rows.push(row);
            }
            rows
        }
        SpectrumPoints::Overturning { scales, bodies, .. } => {
            let head = ["scale", "largest |θ| of balance", "largest slide", "impacts", ""];
            let mut rows = vec![head.map(str::to_owned).to_vec()];
            // A slide of rounding errors is none.
            let nothing = 1e-12 * bodies.iter().map(|body| body.max_slide).fold(0.0, f64::max);
            let (first, last) = (scales[0], scales[scales.len() - 1]);
            let share = |i: usize| i as f64 / (SHOWN - 1) as f64;
            let mut even: Vec<usize> = (0..SHOWN)
                .map(|i| scales.partition_point(|scale| *scale < first + (last - first) * share(i) - 1e-9))
                .map(|i| i.min(scales.len() - 1))
                .collect();
            even.dedup();
            for i in even {
                let body = &bodies[i];
                let slide = if body.max_slide > nothing { body.max_slide } else { 0.0 };
                rows.push(vec![
                    number(scales[i]),
                    if body.overturned { "∞".to_owned() } else { number(body.of_balance) },
                    number(slide) + m,
                    body.impacts.to_string(),
                    if body.overturned { "overturns".to_owned() } else { String::new() },
                ]);
            }
            rows
        }
    }
}
