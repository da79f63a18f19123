//! The figures of an answer: draws, probabilities, what matters, how they converged, along a number, and how far it slides.

use standfast::{Diagram, Mode};
use standfast_figures::{
    Chance, ChanceBar, ChanceBars, ChanceCloud, ChanceGroup, ChanceLine, ChanceLines, ChanceMark, CloudPanel,
    DiagramContent, Figure, Importance, LineLook, SpectrumAxis, Tornado, chance_bars, chance_cloud,
    chance_lines, chance_tornado, diagram_with,
};
use standfast_probability::normal;
use standfast_probability::sample::{self, Estimate};
use toml::de::DeTable;

use super::answer::{Chances, Happening, Method, Probability};
use super::asked::Asked;
use super::error::ProbabilityError;
use super::over::{Fit, Fragility};
use super::problem::Problem;
use super::storm::Sliding;
use crate::layout::digits;

/// How many draws a cloud has.
const DRAWS: u64 = 1000;
/// What a heavy tail leaves outside of a picture, at each end.
const TAIL: f64 = 0.005;
/// The share of the whole that is seen on an axis of equal steps.
const LEAST_SEEN: f64 = 0.005;
/// How many points a curve is drawn through.
const SMOOTH: usize = 96;

/// A figure of an answer.
#[derive(Debug, Clone, PartialEq)]
pub struct ProbabilityFigure {
    /// What tells it from the others of the case, to be appended to a file's name.
    pub suffix: &'static str,
    /// What it is.
    pub words: &'static str,
    /// The figure.
    pub figure: Figure,
}

impl Probability {
    /// The figures of the answer to this file, of the least safe set of loads: those for which there are numbers.
    ///
    /// # Errors
    /// As [`of_text`](Probability::of_text), if the text is that of another file.
    pub fn figures(&self, text: &str) -> Result<Vec<ProbabilityFigure>, ProbabilityError> {
        let worst = self.situations.first();
        let title = self.title(text);
        let figure = |suffix, words, figure| ProbabilityFigure { suffix, words, figure };
        let cloud = match worst {
            Some(worst) => self.cloud(text, worst, &title)?,
            None => None,
        };
        let bars = worst.map(|worst| self.bars(worst, &title));
        let matters = worst.and_then(|worst| self.matters_drawn(worst, &title));
        let course = worst.and_then(|worst| convergence(worst, &title));
        let along = self.fragility.as_ref().map(|fragility| along(fragility, self.floor(), &title));
        let slides = self.sliding.as_ref().and_then(|sliding| exceedance(sliding, &title));
        Ok([
            cloud.map(|drawn| figure("-draws", "Draws", drawn)),
            bars.map(|drawn| figure("-modes", "Probabilities", drawn)),
            matters.map(|drawn| figure("-matters", "What matters", drawn)),
            course.map(|drawn| figure("-convergence", "Convergence", drawn)),
            along.map(|drawn| figure("-fragility", "Fragility", drawn)),
            slides.map(|drawn| figure("-sliding", "Slides", drawn)),
        ]
        .into_iter()
        .flatten()
        .collect())
    }

    /// The title in the file, or else the file's name.
    fn title(&self, text: &str) -> String {
        let document = DeTable::parse(text).ok();
        let title =
            document.as_ref().and_then(|document| document.get_ref().get("title")?.get_ref().as_str());
        title.unwrap_or(&self.case).to_owned()
    }

    fn cloud(&self, text: &str, worst: &Chances, title: &str) -> Result<Option<Figure>, ProbabilityError> {
        let asked = Asked::read(&self.case, text, None)?;
        if matches!(asked, Asked::Storm(_)) {
            return Ok(None);
        }
        let problems = asked.problems(None)?;
        let Some(problem) = problems.iter().find(|problem| problem.situation() == worst.situation) else {
            return Ok(None);
        };
        Ok(Draws::of(problem, self.request.effort.seed).and_then(|draws| draws.figure(problem, worst, title)))
    }

    fn bars(&self, worst: &Chances, title: &str) -> Figure {
        let floor = self.floor();
        let chosen = |modes: &[(Happening, Estimate)]| -> Vec<(Happening, Estimate)> {
            let mut shown: Vec<_> = modes.iter().copied().filter(|(_, e)| e.value >= floor).collect();
            shown.sort_by(|a, b| b.1.value.total_cmp(&a.1.value));
            shown
        };
        let event = chosen(&worst.modes);
        let in_words =
            |modes: &[(Happening, Estimate)], not_rest: Estimate| -> Vec<(Option<Mode>, String, Chance)> {
                let bar = |(happening, e): &(Happening, Estimate)| match happening.mode() {
                    Some(mode) => (Some(mode), mode.words().to_owned(), chance(*e)),
                    None => (None, happening.name(), chance(*e)),
                };
                modes.iter().map(bar).chain([(None, "does not rest".to_owned(), chance(not_rest))]).collect()
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
            let heading = format!("At least once in {} years", digits(life.years));
            groups.push((heading, in_words(&chosen(&moved), life.not_rest)));
        }
        let bars: Vec<Vec<ChanceBar<'_>>> = groups
            .iter()
            .map(|(_, bars)| {
                bars.iter()
                    .map(|(mode, words, chance)| ChanceBar { mode: *mode, words, chance: *chance })
                    .collect()
            })
            .collect();
        let groups: Vec<ChanceGroup<'_>> =
            groups.iter().zip(&bars).map(|((heading, _), bars)| ChanceGroup { heading, bars }).collect();
        let mut caption = match worst.method {
            Method::Integrate => "Integrated.".to_owned(),
            method => format!("By {method}; intervals of 95 %."),
        };
        let below: Vec<_> = worst.modes.iter().filter(|(_, e)| e.value < floor && e.high > 0.0).collect();
        if !below.is_empty() {
            let names: Vec<String> = below
                .iter()
                .map(|(happening, _)| happening.name().replace('\'', "′").replace('-', "−"))
                .collect();
            let bound = below.iter().map(|(_, e)| e.high).fold(0.0, f64::max);
            caption += &format!(" {}: each below {}.", names.join(", "), digits(bound));
        }
        if let Some(point) = &worst.design_point {
            caption +=
                &format!(" β = {}; Φ(−β) = {} is not P.", digits(point.beta), digits(point.first_order()));
        }
        let title = format!("How likely each mode is: {title}");
        chance_bars(&ChanceBars { title: &title, caption: &caption, groups: &groups })
    }

    fn matters_drawn(&self, worst: &Chances, title: &str) -> Option<Figure> {
        let point = worst.design_point.as_ref().filter(|_| worst.known.len() == self.random.len())?;
        let mut order: Vec<usize> = (0..worst.known.len()).collect();
        order.sort_by(|a, b| point.alpha[*b].abs().total_cmp(&point.alpha[*a].abs()));
        let numbers: Vec<Importance<'_>> = order
            .iter()
            .map(|&i| Importance {
                name: &self.random[i].0,
                alpha2: point.alpha[i].powi(2),
                known: worst.known[i].value,
            })
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

/// How the answer settled as the points were doubled.
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
        name: "estimate, with its interval of 95 %",
        look: LineLook::Answer,
        points: course.iter().map(|(points, e)| (*points as f64, chance(*e))).collect(),
    }];
    let title = format!("How the probability settles: {title}");
    let caption = format!(
        "By {}: {} after {last} points, {} to {}.",
        worst.method,
        digits(answer.value),
        digits(answer.low),
        digits(answer.high)
    );
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
    let Fragility { name, unit, points, fit } = fragility;
    let most = points.iter().map(|point| point.not_rest.value).fold(0.0, f64::max);
    let is_linear = most > 0.2;
    // On an axis of equal steps what is rarer is a line along it.
    let least = if is_linear { LEAST_SEEN * most } else { floor };
    let likely = |place: usize| points.iter().any(|point| point.modes[place].1.value >= least);
    let count = points.first().map_or(0, |point| point.modes.len());
    let modes = (0..count).filter(|place| likely(*place)).filter_map(|place| {
        let mode = points[0].modes[place].0.mode().filter(|mode| *mode != Mode::Rest)?;
        let of_mode = points.iter().map(|point| (point.value, chance(point.modes[place].1))).collect();
        Some((mode, of_mode))
    });
    let modes: Vec<(Mode, Vec<(f64, Chance)>)> = modes.collect();
    let names: Vec<String> = modes.iter().map(|(mode, _)| mode.words().replace('\'', "′")).collect();
    let moved: Vec<(f64, Chance)> =
        points.iter().map(|point| (point.value, chance(point.not_rest))).collect();
    let (first, last) = (points[0].value, points[points.len() - 1].value);
    let (from, to) = (first.min(last), first.max(last));
    let up = if is_linear {
        SpectrumAxis { name: "probability", from: 0.0, to: 1.0, logarithmic: false }
    } else {
        of_probabilities(moved.iter().map(|(_, p)| p.value), floor)
    };
    let mut lines = vec![ChanceLine { name: "does not rest", look: LineLook::Answer, points: moved }];
    let mut caption = format!("At {} values.", points.len());
    let told;
    if let Some(Fit { median, dispersion, misfit }) = fit {
        let unit = unit.map_or_else(String::new, |unit| format!(" {unit}"));
        told = format!("lognormal, misses by {}", digits(*misfit));
        let value = |i: usize| from + (to - from) * i as f64 / SMOOTH as f64;
        let fitted = (0..=SMOOTH).map(value).filter(|x| *x > 0.0).map(|x| {
            let p = normal::below((x / median).ln() / dispersion);
            (x, Chance { value: p, low: p, high: p })
        });
        lines.push(ChanceLine { name: &told, look: LineLook::Fit, points: fitted.collect() });
        caption += &format!(
            " Dashed: the lognormal curve of median {}{unit} and dispersion {}; it misses the probabilities by {} at most.",
            digits(*median),
            digits(*dispersion),
            digits(*misfit)
        );
    }
    for ((mode, points), name) in modes.into_iter().zip(&names) {
        lines.push(ChanceLine { name, look: LineLook::Mode(mode), points });
    }
    let across_name = match unit {
        Some(unit) => format!("{} ({})", escaped(name), unit.replace("m/s2", "m/s$^2$")),
        None => escaped(name),
    };
    let across = SpectrumAxis { name: &across_name, from, to, logarithmic: false };
    let title = format!("Along {name}: {title}");
    chance_lines(&ChanceLines { title: &title, caption: &caption, across, up, lines: &lines, marks: &[] })
}

/// A name in which a dollar would begin mathematics.
fn escaped(name: &str) -> String {
    name.replace('$', "")
}

/// How likely it is that a life slides farther.
fn exceedance(sliding: &Sliding, title: &str) -> Option<Figure> {
    // Beyond, lives are too few to tell anything.
    let likely: Vec<_> = sliding.course.iter().filter(|e| e.probability.low > 0.0).collect();
    let (first, last) = (likely.first()?, likely.last()?);
    let marked: Vec<(f64, String)> = sliding
        .exceedance
        .iter()
        .map(|e| (e.slide, format!("{:.2} m: {}", e.slide, digits(e.probability.value))))
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
        name: "of lives, with the interval of 95 %",
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

/// Draws of the random numbers, and where they lie.
struct Draws {
    values: Vec<Vec<f64>>,
    modes: Vec<Option<Mode>>,
    /// γ, k, k', μ in effective coordinates, of each draw that has them.
    points: Vec<Option<[f64; 4]>>,
}

impl Draws {
    /// None of a problem of one random number, which has no cloud.
    fn of(problem: &Problem, seed: u64) -> Option<Draws> {
        if problem.random().len() < 2 {
            return None;
        }
        let mut draws = Draws { values: Vec::new(), modes: Vec::new(), points: Vec::new() };
        sample::draws(problem.laws(), seed, DRAWS, |values| {
            draws.values.push(values.to_vec());
            draws.modes.push(problem.drawn(values).happens.mode());
            draws.points.push(problem.place(values));
        });
        Some(draws)
    }

    fn figure(&self, problem: &Problem, worst: &Chances, title: &str) -> Option<Figure> {
        let title = format!("Draws: {title}");
        let placed: Vec<[f64; 4]> = self.points.iter().copied().flatten().collect();
        let few = placed.len() * 100 < self.points.len() * 99;
        if few {
            return self.of_numbers(problem, worst, &title);
        }
        let same = |i: usize| placed.iter().all(|p| (p[i] - placed[0][i]).abs() <= 1e-9 * placed[0][i].abs());
        if let (true, true, Ok(diagram)) = (same(0), same(2), Diagram::new(placed[0][0], placed[0][2])) {
            let cloud: Vec<(f64, f64)> = placed.iter().map(|p| (p[1], p[3])).collect();
            return Some(diagram_with(
                &diagram,
                &DiagramContent { cloud: &cloud, ..DiagramContent::default() },
            ));
        }
        // A draw that is none has no place; what is left keeps its mode.
        let modes: Vec<Option<Mode>> =
            self.points.iter().zip(&self.modes).filter(|(p, _)| p.is_some()).map(|(_, mode)| *mode).collect();
        let of = |i: usize| placed.iter().map(|p| p[i]).collect::<Vec<f64>>();
        let names = ["", "force $k$", "elevation $k′$", "friction $μ$"];
        let panels: Vec<CloudPanel<'_>> = [3, 2]
            .into_iter()
            .filter(|i| !same(*i))
            .map(|i| panel((names[1], &of(1)), (names[i], &of(i))))
            .collect();
        let caption = format!(
            "{} draws in the effective coordinates of the report's plane, in the colours of their modes{}.",
            placed.len(),
            outside(&panels)
        );
        Some(chance_cloud(&ChanceCloud { title: &title, caption: &caption, panels: &panels, modes: &modes }))
    }

    /// The two numbers that matter most, of a body that the report's plane is not of.
    fn of_numbers(&self, problem: &Problem, worst: &Chances, title: &str) -> Option<Figure> {
        let mut order: Vec<usize> = (0..problem.random().len()).collect();
        if let Some(point) = &worst.design_point {
            order.sort_by(|a, b| point.alpha[*b].abs().total_cmp(&point.alpha[*a].abs()));
        }
        let [across, up, ..] = order[..] else { return None };
        let name = |i: usize| {
            let input = &problem.random()[i];
            let unit = input.unit().map_or_else(String::new, |unit| format!(" ({unit})"));
            format!("{}{unit}", escaped(&input.name))
        };
        let of = |i: usize| self.values.iter().map(|values| values[i]).collect::<Vec<f64>>();
        let names = [name(across), name(up)];
        let panels = [panel((&names[0], &of(across)), (&names[1], &of(up)))];
        let caption = format!(
            "{} draws of the two numbers that matter most, in the colours of their modes{}.",
            self.values.len(),
            outside(&panels)
        );
        Some(chance_cloud(&ChanceCloud { title, caption: &caption, panels: &panels, modes: &self.modes }))
    }
}

/// How many places lie outside of a view, in words.
fn outside(panels: &[CloudPanel<'_>]) -> String {
    let beyond = |axis: &SpectrumAxis<'_>, x: f64| x < axis.from || x > axis.to;
    let out = |panel: &CloudPanel<'_>| {
        panel.points.iter().filter(|(x, y)| beyond(&panel.across, *x) || beyond(&panel.up, *y)).count()
    };
    match panels.iter().map(out).max() {
        Some(count) if count > 0 => format!("; up to {count} of them lie outside"),
        _ => String::new(),
    }
}

fn panel<'a>((across, xs): (&'a str, &[f64]), (up, ys): (&'a str, &[f64])) -> CloudPanel<'a> {
    let axis = |name: &'a str, values: &[f64]| {
        let mut sorted = values.to_vec();
        sorted.sort_by(f64::total_cmp);
        let at = |share: f64| sorted[((share * sorted.len() as f64) as usize).min(sorted.len() - 1)];
        let (low, high) = (at(TAIL), at(1.0 - TAIL));
        let room = 0.12 * (high - low).max(1e-9 * high.abs()).max(f64::MIN_POSITIVE);
        // What cannot be negative does not get an axis that is.
        let from = if low >= 0.0 { (low - room).max(0.0) } else { low - room };
        SpectrumAxis { name, from, to: high + room, logarithmic: false }
    };
    let points = xs.iter().copied().zip(ys.iter().copied()).collect();
    CloudPanel { across: axis(across, xs), up: axis(up, ys), points }
}

impl Problem {
    /// γ, k, k' and μ of a draw, where the report's plane is of the body.
    fn place(&self, values: &[f64]) -> Option<[f64; 4]> {
        let mechanics = self.mechanics(values)?;
        let [k, k_prime] = mechanics.effective()?;
        Some([mechanics.block.d, k, k_prime, mechanics.block.mu_s])
    }
}
