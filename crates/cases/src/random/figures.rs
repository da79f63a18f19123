//! The figures of an answer: draws, probabilities, what matters, how they converged, along a number, and how far it slides.

use standfast::Mode;
use standfast_figures::{
    Chance, ChanceGroup, ChanceLine, ChanceLines, ChanceMark, ChanceRow, ChanceRows, Figure, Importance,
    LineLook, SpectrumAxis, Tornado, chance_lines, chance_rows, chance_tornado, significant,
};
use standfast_probability::lognormal::Lognormal;
use standfast_probability::sample::Estimate;

use super::summary::{FEW, records as on_records};
use super::text::floor;
use super::{Chances, Fit, Fragility, Happening, Method, Overturning, Probability, Sliding};
use crate::document::AnswerFigure;
use crate::layout::{apart, digits};

mod areas;
mod cloud;
pub(super) use cloud::Cloud;

/// The share of the whole that is seen on an axis of equal steps.
const LEAST_SEEN: f64 = 0.005;
/// Upper end of an axis of equal steps on which 1 lies: a line there keeps off the frame.
const TO_ONE: f64 = 1.04;
/// Number of points that a curve is drawn through.
const SMOOTH: usize = 96;

/// The figures of an answer, of the least safe set of loads: those for which there are numbers.
pub(super) fn all(answer: &Probability) -> Vec<AnswerFigure> {
    let worst = answer.situations.first();
    let title = title(answer);
    let cloud = worst.zip(answer.problem.as_deref()).and_then(|(worst, problem)| {
        Cloud::of(problem, answer.request.effort.seed)?.figure(problem, worst, &title)
    });
    let bars = worst.map(|worst| bars(answer, worst, &title));
    let matters = worst.and_then(|worst| matters_drawn(answer, worst, &title));
    let course = worst.and_then(|worst| convergence(worst, &title));
    let along = answer.fragility.as_ref().map(|fragility| along(fragility, floor(answer), &title));
    let over = answer.overturning.as_ref().map(|overturning| overturns(overturning, &title));
    let slides = answer.sliding.as_ref().and_then(|sliding| exceedance(sliding, &title));
    [
        cloud.map(|drawn| AnswerFigure::new("-draws", "Draws", drawn)),
        bars.map(|drawn| AnswerFigure::new("-modes", "Probabilities", drawn)),
        matters.map(|drawn| AnswerFigure::new("-matters", "What matters", drawn)),
        course.map(|drawn| AnswerFigure::new("-convergence", "Convergence", drawn)),
        along.map(|drawn| AnswerFigure::new("-fragility", "Fragility", drawn)),
        over.map(|drawn| AnswerFigure::new("-overturns", "Overturning", drawn)),
        slides.map(|drawn| AnswerFigure::new("-sliding", "Slides", drawn)),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// The title in the file, or else the file's name.
pub(super) fn title(answer: &Probability) -> String {
    answer.title.clone().unwrap_or_else(|| answer.case.clone())
}

/// The modes with their probabilities, those that are likely enough, and that the body does not rest: of an event, and of a life. Each group
/// has its heading, and each row its mode, its words and its probability.
pub(super) fn groups(answer: &Probability, worst: &Chances) -> Vec<(String, Vec<ChanceBar>)> {
    let floor = floor(answer);
    let chosen = |modes: &[(Happening, Estimate)]| -> Vec<(Happening, Estimate)> {
        let mut shown: Vec<_> = modes.iter().copied().filter(|(_, e)| e.value >= floor).collect();
        standfast::order::by_number(&mut shown, |one| -one.1.value);
        shown
    };
    let event = chosen(&worst.modes);
    let in_words = |modes: &[(Happening, Estimate)], not_rest: Estimate| -> Vec<ChanceBar> {
        let bar = |(happening, e): &(Happening, Estimate)| match happening.mode() {
            Some(mode) => (Some(mode), mode.words().to_owned(), chance(*e)),
            None => (None, bar_words(answer, *happening), chance(*e)),
        };
        // One mode alone is all that does not rest.
        let moved: Vec<_> = modes.iter().filter(|(mode, _)| mode.mode() != Some(Mode::Rest)).collect();
        let is_all = matches!(moved[..], [(_, e)] if digits(e.value) == digits(not_rest.value));
        let whole = (None, "does not rest".to_owned(), chance(not_rest));
        modes.iter().map(bar).chain((!is_all).then_some(whole)).collect()
    };
    let mut groups = vec![(
        match &worst.situation {
            Some(situation) => format!("Under {situation}"),
            None => "Under the loads of one event".to_owned(),
        },
        in_words(&event, worst.not_rest),
    )];
    if let Some(life) = &worst.life {
        let moved: Vec<_> =
            life.modes.iter().copied().filter(|(mode, _)| mode.mode() != Some(Mode::Rest)).collect();
        let heading = super::summary::over_life(life);
        groups.push((heading, in_words(&chosen(&moved), life.not_rest)));
    }
    groups
}

/// What a bar is of that is of no mode.
fn bar_words(answer: &Probability, happening: Happening) -> String {
    match happening {
        Happening::First(first) => answer.first_words(first),
        other => other.name(),
    }
}

/// A mode, where it is one, with its words and its probability.
pub(super) type ChanceBar = (Option<Mode>, String, Chance);

fn bars(answer: &Probability, worst: &Chances, title: &str) -> Figure {
    let floor = floor(answer);
    let groups = groups(answer, worst);
    let bars: Vec<Vec<ChanceRow<'_>>> = groups
        .iter()
        .map(|(_, bars)| {
            bars.iter()
                .map(|(mode, words, chance)| ChanceRow { mode: *mode, words, chance: *chance })
                .collect()
        })
        .collect();
    let groups: Vec<ChanceGroup<'_>> =
        groups.iter().zip(&bars).map(|((heading, _), rows)| ChanceGroup { heading, rows }).collect();
    let mut caption = match worst.method {
        Method::Integrate => "Integrated.".to_owned(),
        method => format!("{}; intervals of 95 %.", by(method)),
    };
    let below: Vec<_> = worst.modes.iter().filter(|(_, e)| e.value < floor && e.high > 0.0).collect();
    if !below.is_empty() {
        let names: Vec<String> = below.iter().map(|(happening, _)| rare(*happening)).collect();
        let bound = below.iter().map(|(_, e)| e.high).fold(0.0, f64::max);
        let each = if names.len() > 1 { "each rarer" } else { "rarer" };
        caption += &format!(" Not drawn, {each} than {}: {}.", digits(bound), names.join(", "));
    }
    if let Some(point) = &worst.design_point {
        caption += &format!(
            " The reliability index β is {}. For comparison: first-order reliability, which takes the limit of rest as straight, estimates {}.",
            digits(point.beta),
            digits(point.first_order())
        );
    }
    let of = match (answer.has_joints(), answer.is_on_plan()) {
        (true, _) => "Which joint leaves rest first",
        (_, true) => "How likely rest is, and what ends it",
        _ => "How likely each mode is",
    };
    let title = format!("{of}: {title}");
    chance_rows(&ChanceRows { title: &title, caption: &caption, groups: &groups })
}

/// What did not happen, or hardly, in a list: a mode's symbol, and words where a symbol says little.
fn rare(happening: Happening) -> String {
    match happening {
        Happening::Decided(verdict) if verdict.mode().is_none_or(|mode| mode == Mode::Flight) => {
            format!("{verdict} ({})", verdict.words())
        }
        Happening::NoMode => "no mode at all".to_owned(),
        Happening::NotABody => "numbers of no body".to_owned(),
        decided => decided.name(),
    }
}

fn matters_drawn(answer: &Probability, worst: &Chances, title: &str) -> Option<Figure> {
    let point = worst.design_point.as_ref().filter(|_| worst.known.len() == answer.random.len())?;
    let mut order: Vec<usize> = (0..worst.known.len()).collect();
    standfast::order::by_number(&mut order, |one| -point.alpha[*one].abs());
    // Nothing hangs on a probability that is as good as none.
    if worst.not_rest.value <= floor(answer) {
        return None;
    }
    let names: Vec<String> = order.iter().map(|&i| answer.random[i].words.clone()).collect();
    let numbers: Vec<Importance<'_>> = order
        .iter()
        .zip(&names)
        .map(|(&i, name)| Importance { name, alpha2: point.alpha[i].powi(2), known: worst.known[i].value })
        .collect();
    let kink = if point.at_change {
        " The design point lies where a formula or the mode changes: α² ranks, and no gradient has its direction."
    } else {
        ""
    };
    let caption = format!(
        "Left: α² of the design point, β = {}. Right: from P that the body does not rest, {}, to what it would be if the number were known to have its median.{kink}",
        digits(point.beta),
        digits(worst.not_rest.value)
    );
    let title = format!("Which number matters: {title}");
    let probability = worst.not_rest.value;
    (!numbers.is_empty()).then(|| {
        chance_tornado(&Tornado { title: &title, caption: &caption, probability, numbers: &numbers })
    })
}

/// Way in which a probability was found.
fn by(method: Method) -> &'static str {
    match method {
        Method::Integrate => "Integrated",
        Method::Sobol => "By Sobol points",
        Method::Importance => "By Sobol points about the design points",
        Method::MonteCarlo => "By random draws",
    }
}

fn chance(Estimate { value, low, high }: Estimate) -> Chance {
    Chance { value, low, high }
}

/// An axis by equal factors that holds probabilities, and 1 if `to_one`; equal steps where all are within two decades.
fn of_probabilities(values: impl Iterator<Item = f64>, least: f64) -> SpectrumAxis<'static> {
    let (mut low, mut high) = (1.0f64, 0.0f64);
    for p in values.filter(|p| *p > 0.0) {
        (low, high) = (low.min(p), high.max(p));
    }
    let from = 10f64.powf(low.max(least).log10().floor());
    let to = 10f64.powf(high.max(10.0 * from).log10().ceil()).min(1.0);
    SpectrumAxis { name: "probability", from: from.min(0.1 * to), to, logarithmic: true }
}

/// Figure of how the answer settled as the points were doubled.
fn convergence(worst: &Chances, title: &str) -> Option<Figure> {
    let course = &worst.course;
    let (last, answer) = course.last().filter(|(_, e)| course.len() > 2 && e.value > 0.0)?;
    let (first, _) = course.first()?;
    // The first intervals may be as wide as the picture of the others is not.
    let ends = |e: &Estimate| [e.low, e.high];
    let shown = &course[course.len() / 3..];
    let low = shown.iter().flat_map(|(_, e)| ends(e)).fold(f64::INFINITY, f64::min);
    let high = shown.iter().flat_map(|(_, e)| ends(e)).fold(0.0, f64::max);
    let room = 0.25 * (high - low).max(1e-9 * answer.value);
    let up = SpectrumAxis {
        name: "probability that it does not rest",
        from: (low - room).max(0.0),
        to: high + room,
        logarithmic: false,
    };
    let across = SpectrumAxis { name: "points", from: *first as f64, to: *last as f64, logarithmic: true };
    let lines = [ChanceLine {
        name: "estimate",
        look: LineLook::Answer,
        points: course.iter().map(|(points, e)| (*points as f64, chance(*e))).collect(),
    }];
    let title = format!("How the probability settles: {title}");
    let ends = [answer.low, answer.value, answer.high];
    let caption = match &apart(&ends)[..] {
        [low, value, high] if answer.low < answer.high => {
            format!("{}: {value} after {last} points, {low} to {high}.", by(worst.method))
        }
        _ => format!("{}: {} after {last} points.", by(worst.method), digits(answer.value)),
    };
    Some(chance_lines(&ChanceLines {
        title: &title,
        caption: &caption,
        across,
        up,
        lines: &lines,
        marks: &[],
    }))
}

/// Probabilities along a number.
fn along(fragility: &Fragility, floor: f64, title: &str) -> Figure {
    let Fragility { words, points, fit, .. } = fragility;
    let (unit, shown) = (fragility.unit(), |value: f64| fragility.in_unit(value));
    let most = points.iter().map(|point| point.not_rest.value).fold(0.0, f64::max);
    let is_linear = most > 0.2;
    // On an axis of equal steps what is rarer is a line along it.
    let least = if is_linear { LEAST_SEEN * most } else { floor };
    let likely = |place: usize| points.iter().any(|point| point.modes[place].1.value >= least);
    let count = points.first().map_or(0, |point| point.modes.len());
    let modes = (0..count).filter(|place| likely(*place)).filter_map(|place| {
        let mode = points[0].modes[place].0.mode().filter(|mode| *mode != Mode::Rest)?;
        let of_mode = points.iter().map(|point| (shown(point.value), chance(point.modes[place].1))).collect();
        Some((mode, of_mode))
    });
    let modes: Vec<(Mode, Vec<(f64, Chance)>)> = modes.collect();
    let names: Vec<String> = modes.iter().map(|(mode, _)| mode.words().replace('\'', "′")).collect();
    let moved: Vec<(f64, Chance)> =
        points.iter().map(|point| (shown(point.value), chance(point.not_rest))).collect();
    let (first, last) = (shown(points[0].value), shown(points[points.len() - 1].value));
    let (from, to) = (first.min(last), first.max(last));
    let up = if is_linear {
        SpectrumAxis { name: "probability", from: 0.0, to: TO_ONE, logarithmic: false }
    } else {
        of_probabilities(moved.iter().map(|(_, p)| p.value), floor)
    };
    let mut lines = vec![ChanceLine { name: "does not rest", look: LineLook::Answer, points: moved }];
    let mut caption = format!("At {} values.", points.len());
    if let Some(Fit { median, dispersion, misfit }) = fit {
        let median = shown(*median);
        let points = smooth((from, to), (median, *dispersion));
        lines.push(ChanceLine { name: "lognormal", look: LineLook::Fit, points });
        caption += &format!(
            " Dashed: the lognormal curve of median {} and dispersion {}; it misses the probabilities by {} at most.",
            format!("{} {unit}", digits(median)).trim_end(),
            digits(*dispersion),
            digits(*misfit)
        );
    }
    for ((mode, points), name) in modes.into_iter().zip(&names) {
        lines.push(ChanceLine { name, look: LineLook::Mode(mode), points });
    }
    let across_name = quantity(words, &unit);
    let across = SpectrumAxis { name: &across_name, from, to, logarithmic: false };
    let title = format!("Along the {words}: {title}");
    chance_lines(&ChanceLines { title: &title, caption: &caption, across, up, lines: &lines, marks: &[] })
}

/// Figure of the bodies that move, rock and overturn, over the peak of a shaking.
fn overturns(overturning: &Overturning, title: &str) -> Figure {
    let Overturning { records, bodies, points, fit, gravity, .. } = overturning;
    let certain = |p: f64| Chance { value: p, low: p, high: p };
    let along = |of: &dyn Fn(usize) -> Chance| -> Vec<(f64, Chance)> {
        points.iter().enumerate().map(|(i, at)| (at.peak / gravity, of(i))).collect()
    };
    let is_few = records.len() < FEW;
    let mut lines = vec![ChanceLine {
        name: "overturns",
        look: if is_few { LineLook::Points(None) } else { LineLook::Answer },
        points: along(&|i| chance(points[i].overturned)),
    }];
    let (from, to) = (points[0].peak / gravity, points[points.len() - 1].peak / gravity);
    let each = match &records[..] {
        [_] => format!(
            "{bodies} bodies under one shaking, scaled to each of {} peaks. It tells nothing of another one.",
            points.len()
        ),
        few if is_few => format!(
            "{bodies} bodies, each under every one of {} records, scaled to each of {} peaks. {}",
            few.len(),
            points.len(),
            on_records(few.len()).unwrap_or_default()
        ),
        many => format!(
            "{bodies} bodies, each under every one of {} records, scaled to each of {} peaks; the interval is that of a further record and body.",
            many.len(),
            points.len()
        ),
    };
    let mut caption = each;
    if let Some(Fit { median, dispersion, misfit }) = fit.as_ref().filter(|_| !is_few) {
        lines.push(ChanceLine {
            name: "lognormal",
            look: LineLook::Fit,
            points: smooth((from, to), (median / gravity, *dispersion)),
        });
        caption += &format!(
            " Dashed: the lognormal curve of median {} g and dispersion {}; it misses the points by {} at most.",
            digits(*median / gravity),
            digits(*dispersion),
            digits(rounded(*misfit))
        );
    }
    lines.push(ChanceLine {
        name: "rocks",
        look: if is_few { LineLook::Points(Some(Mode::RockO)) } else { LineLook::Mode(Mode::RockO) },
        points: along(&|i| certain(points[i].rocked.value)),
    });
    lines.push(ChanceLine {
        name: "slips or rocks",
        look: if is_few { LineLook::Points(Some(Mode::SlideLeft)) } else { LineLook::Other },
        points: along(&|i| certain(points[i].moved.value)),
    });
    let axis = |name, from, to| SpectrumAxis { name, from, to, logarithmic: false };
    chance_lines(&ChanceLines {
        title: &format!("Overturning: {title}"),
        caption: &caption,
        across: axis("peak of the shaking ($g$)", from, to),
        up: axis("probability", 0.0, TO_ONE),
        lines: &lines,
        marks: &[],
    })
}

/// A lognormal curve from one value to another.
fn smooth((from, to): (f64, f64), (median, dispersion): (f64, f64)) -> Vec<(f64, Chance)> {
    let curve = Lognormal { median, dispersion };
    let value = |i: usize| from + (to - from) * i as f64 / SMOOTH as f64;
    let values = (0..=SMOOTH).map(value).filter(|x| *x > 0.0);
    values.map(|x| (x, curve.at(x))).map(|(x, p)| (x, Chance { value: p, low: p, high: p })).collect()
}

/// A quantity as an axis has it: its words, and its unit.
fn quantity(words: &str, unit: &str) -> String {
    let words = escaped(words);
    if unit.is_empty() { words } else { format!("{words} ({unit})") }
}

/// A name in which a dollar would begin mathematics.
fn escaped(name: &str) -> String {
    name.replace('$', "")
}

/// Figure of the chance that a life slides farther.
pub(super) fn exceedance(sliding: &Sliding, title: &str) -> Option<Figure> {
    // Beyond, lives are too few to tell anything.
    let likely: Vec<_> = sliding.course.iter().filter(|e| e.probability.low > 0.0).collect();
    let (first, last) = (likely.first()?, likely.last()?);
    let marked: Vec<(f64, String)> = sliding
        .exceedance
        .iter()
        .map(|e| (e.slide, format!("{:.2} m: ${}$", e.slide, significant(e.probability.value, 4))))
        .chain([(sliding.mean.value, format!("mean {} m", digits(sliding.mean.value)))])
        .collect();
    let marks: Vec<ChanceMark<'_>> = marked.iter().map(|(at, words)| ChanceMark { at: *at, words }).collect();
    let across = SpectrumAxis {
        name: "slide of a life (m)",
        from: first.slide,
        to: 10f64.powf(last.slide.log10().ceil()),
        logarithmic: true,
    };
    let up = SpectrumAxis {
        name: "probability that a life slides farther",
        ..of_probabilities(likely.iter().map(|e| e.probability.value), 0.0)
    };
    let lines = [ChanceLine {
        name: "of lives",
        look: LineLook::Answer,
        points: likely.iter().map(|e| (e.slide, chance(e.probability))).collect(),
    }];
    let caption = format!(
        "{} lives of {} years, a storm of {} waves each year. The mean, {} m, is integrated; {} % of it comes of the worst twentieth of all lives. {} of all lives do not slide at all.",
        sliding.lives,
        digits(sliding.years),
        sliding.storm.waves,
        digits(sliding.mean.value),
        digits((1000.0 * sliding.of_worst).round() / 10.0),
        digits(1.0 - sliding.ever.value)
    );
    let title = format!("How far it slides: {title}");
    Some(chance_lines(&ChanceLines {
        title: &title,
        caption: &caption,
        across,
        up,
        lines: &lines,
        marks: &marks,
    }))
}

/// Three digits, as many as a place in a figure has.
fn rounded(x: f64) -> f64 {
    format!("{x:.2e}").parse().unwrap_or(x)
}
