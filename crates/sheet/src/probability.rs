//! Probability of each mode where some numbers are random: laws, method, probabilities, what matters, what is asked.

use maud::{Markup, html};
use standfast_cases::layout::digits;
use standfast_cases::random::{
    ChanceRequest, Chances, DesignValues, Estimate, Happening, Method, Probability, ProbabilityError, Random,
    RandomNumber, Rate, Slopes, after_rest, criterion_words, of_row, over_life, period, period_of,
};
use standfast_cases::{Bound, CaseFile, Portion};

use crate::SheetError;

/// Answer to a case with `[random]`.
pub struct Chance<'a> {
    random: &'a Random,
    /// The probabilities, or why there are none.
    answer: Result<Probability, String>,
}

impl<'a> Chance<'a> {
    /// Answer to a case with `[random]`; `None` of any other.
    pub fn of(file: &'a CaseFile, portion: Portion<'_>) -> Result<Option<Chance<'a>>, SheetError> {
        let Some(random) = file.random() else { return Ok(None) };
        let answer = match Probability::watched(file, ChanceRequest::default(), portion) {
            Ok(answer) => Ok(answer),
            Err(ProbabilityError::Case(error)) => return Err(error.into()),
            Err(ProbabilityError::Stopped(stopped)) => return Err(stopped.into()),
            Err(other) => Err(other.to_string()),
        };
        Ok(Some(Chance { random, answer }))
    }

    /// The probabilities, where there are some.
    pub fn answer(&self) -> Option<&Probability> {
        self.answer.as_ref().ok()
    }

    /// Reason why there are no probabilities.
    pub fn why_not(&self) -> Option<&str> {
        self.answer.as_ref().err().map(String::as_str)
    }

    /// The section of the sheet.
    pub fn section(&self) -> Markup {
        html! {
            (laws(self.random))
            @match &self.answer {
                // The laws stand there, and why nothing follows from them.
                Err(why) => p.warning { "No probability is found: " (why) "." },
                Ok(answer) => {
                    (method(answer))
                    @for (place, chances) in answer.situations.iter().enumerate() { (situation(answer, chances, place)) }
                    (together(answer))
                    (sliding(answer))
                    (left_out(answer))
                }
            }
        }
    }
}

fn laws(random: &Random) -> Markup {
    html! {
        p.note {
            "Random are the numbers under [random] in the case file, and no others. Deviations, bounds and correlations are the \
             author’s; the source of each has to be shown with the inputs."
        }
        table.numbers data-table="laws" {
            thead { tr { th { "Random input" } th { "Law" } th { "Drawn" } } }
            tbody {
                @for named in &random.named {
                    tr {
                        td { code { (named.name) } }
                        td { (named.law_words()) }
                        td {
                            (match named.every { Rate::Life => "once", Rate::Year => "each year", Rate::Event => "in each event" })
                            @if named.own { ", for each body" }
                        }
                    }
                }
            }
        }
        @if let Some(rise) = &random.rise {
            @let each = if random.lifetime.events_per_year.is_some() { "an event has that of its time" } else { "a year has that of its middle" };
            p { "The water level rises by " (rise.value) " (" code { (rise.name) } ") in each year of the life; " (each) "." }
        }
        @if random.correlations.is_empty() && random.named.len() > 1 {
            @let depends = random.named.iter().any(|named| named.given.is_some());
            p { "No correlation is given: " @if depends { "but for laws that depend on another input, " } "the inputs are independent of each other." }
        }
        @for (first, second, measure) in &random.correlations {
            p { "Correlation of " code { (random.named[*first].name) } " and " code { (random.named[*second].name) } ": "
                (digits(measure.value())) " (" (measure.name()) ")." }
        }
    }
}

fn method(answer: &Probability) -> Markup {
    let Some(chances) = answer.situations.first() else { return html! {} };
    let (line, exact) = &answer.line;
    let how = match (chances.method, exact) {
        (Method::MonteCarlo, _) => "Every input is drawn.".to_owned(),
        (_, true) if answer.has_joints() => format!(
            "For given other inputs each joint that leaves rest first does so on intervals of {line} in closed form, so that {line} is integrated \
             exactly."
        ),
        (_, true) => format!(
            "For given other inputs each mode is an interval of {line} between curves in closed form, so that {line} is integrated exactly."
        ),
        (_, false) => format!("For given other inputs the modes are searched along {line}."),
    };
    let seed = answer.request.effort.seed;
    let others = match chances.method {
        Method::Integrate => "The other inputs are integrated piece by piece between the kinks of the formulas; an interval is \
                              the error of the integration."
            .to_owned(),
        _ => format!(
            "The others are drawn ({}, {} points, seed {seed}); an interval has a confidence of 95 %.",
            chances.method, chances.points
        ),
    };
    html! {
        p {
            (how) " " (others)
            @if answer.has_joints() { " What all joints begin with at once is not asked." }
        }
    }
}

/// A probability with its value in the markup.
fn chance(e: Estimate) -> Markup {
    html! { data value=(e.value) { (digits(e.value)) } }
}

fn interval(e: Estimate) -> Markup {
    html! { (digits(e.low)) " … " (digits(e.high)) }
}

fn words(answer: &Probability, happening: Happening) -> String {
    if let Happening::First(first) = happening {
        return answer.first_words(first);
    }
    let name = happening.name();
    happening.words().map_or(name.clone(), |words| format!("{words} ({name})"))
}

/// The modes with their probabilities within a period.
fn modes(
    answer: &Probability,
    modes: &[(Happening, Estimate)],
    not_rest: Estimate,
    (name, period): (&str, &str),
) -> Markup {
    let floor = answer.request.effort.floor;
    let (head, moves) = match answer.has_joints() {
        true => ("As the loads rise", "not every joint stays at rest"),
        false => ("The body", "does not stay at rest"),
    };
    let shown = modes.iter().filter(|(_, e)| e.value >= floor);
    let below: Vec<_> = modes.iter().filter(|(_, e)| e.value < floor && e.high > 0.0).collect();
    let bound = below.iter().map(|(_, e)| e.high).fold(0.0, f64::max);
    let symbols: Vec<String> = below.iter().map(|(happening, _)| happening.name()).collect();
    html! {
        table.numbers data-table=(name) {
            thead { tr { th { (head) } th.n { "Probability " (period) } th.n { "Interval" } } }
            tbody {
                @for (happening, e) in shown {
                    tr { td { (words(answer, *happening)) } td.n { (chance(*e)) } td.n { (interval(*e)) } }
                }
                tr { td { (moves) } td.n { (chance(not_rest)) } td.n { (interval(not_rest)) } }
            }
        }
        @if !below.is_empty() { p { (symbols.join(", ")) ": " @if symbols.len() > 1 { "each " } "below " (digits(bound)) "." } }
    }
}

fn situation(answer: &Probability, chances: &Chances, place: usize) -> Markup {
    let floor = answer.request.effort.floor;
    let several = answer.situations.len() > 1;
    html! {
        @if let Some(name) = &chances.situation {
            h3 { "Under " (name) @if several && place == 0 { ", the least safe" } }
        }
        (modes(answer, &chances.modes, chances.not_rest, ("modes", period(answer))))
        @if !chances.precise {
            p.warning { "Not every probability above " (digits(floor)) " is as precise as " (digits(100.0 * answer.request.effort.precision)) " %." }
        }
        @if place == 0 { (index(chances)) (matters(answer, chances)) }
        @if let Some(life) = &chances.life {
            h3 { (over_life(life)) }
            @let moving: Vec<_> = life.modes.iter().copied().filter(|(h, _)| *h != Happening::REST).collect();
            (modes(answer, &moving, life.not_rest, ("life", &format!("in {} years", digits(life.years)))))
            @if let Some(sentence) = after_rest(life) { p { (sentence) } }
        }
    }
}

/// The reliability index beside the probability, and what it is not.
fn index(chances: &Chances) -> Markup {
    let Some(point) = &chances.design_point else { return html! {} };
    html! {
        p {
            "Reliability index: β = " data value=(point.beta) { (digits(point.beta)) } ", the distance of the nearest point at which \
             the body does not rest, in standard normals"
            @if point.at_change { "; that point lies at a change of formula or of mode" }
            ". Φ(−β) = " (digits(point.first_order())) " only approximates the probability above"
            @if let Some(generalized) = chances.generalized() { ", for which −Φ⁻¹(P) = " (digits(generalized)) }
            "."
        }
    }
}

fn matters(answer: &Probability, chances: &Chances) -> Markup {
    let Some(point) = chances.design_point.as_ref().filter(|_| answer.random.len() > 1) else {
        return html! {};
    };
    let known = |place: usize| match chances.known.get(place) {
        Some(e) if e.value == 0.0 && e.high > 0.0 => html! { "below " (digits(e.high)) },
        Some(e) => chance(*e),
        None => html! {},
    };
    let mut order: Vec<usize> = (0..answer.random.len()).collect();
    standfast::order::by_number(&mut order, |one| -point.alpha[*one].abs());
    html! {
        h3 { "Which input matters" }
        table.numbers data-table="importance" {
            thead { tr { th { "Input" } th.n { "α²" } th.n { "P " (period(answer)) " if it were known" } th.n { "At the design point" } } }
            tbody {
                @for place in order {
                    tr {
                        td { code { (answer.random[place].name) } }
                        td.n { (format!("{:.2}", point.alpha[place].powi(2))) }
                        td.n { (known(place)) }
                        td.n { (answer.random[place].written(point.values[place])) }
                    }
                }
            }
        }
        p.note { "Known means held at its median." }
        @if let Some(asked) = &chances.design_values { (design_values(answer, asked)) }
        @if let Some(asked) = &chances.slopes { (slopes(answer, asked)) }
    }
}

/// Design values at a target index.
fn design_values(answer: &Probability, asked: &DesignValues) -> Markup {
    html! {
        h3 { "Design values at β = " (digits(asked.beta)) }
        table.numbers data-table="design-values" {
            thead {
                tr { th { "Input" } th.n { "α" } th.n { "Design value" } th.n { "Characteristic" } th.n { "Fractile" } th.n { "Partial factor" } }
            }
            tbody {
                @for (number, design) in answer.random.iter().zip(&asked.numbers) {
                    tr {
                        td { code { (number.name) } }
                        td.n { (format!("{:.2}", design.alpha)) }
                        td.n { (number.written(design.value)) }
                        td.n { (number.written(design.characteristic)) }
                        td.n { (digits(100.0 * design.fractile)) " %" }
                        td.n { (design.factor.map_or(String::new(), |factor| format!("{factor:.2}"))) }
                    }
                }
            }
        }
        p.note {
            "EN 1990, Annex C: F⁻¹(Φ(αβ)), α at the nearest point at which the body does not rest. The factor is the design value over the \
             characteristic of what is unfavourable where it is high, and the characteristic over it of what is so where it is low."
        }
    }
}

/// What means and deviations of the laws do.
fn slopes(answer: &Probability, asked: &[Option<Slopes>]) -> Markup {
    let slope = |number: &RandomNumber, slope: Option<f64>| {
        slope.map_or("none".to_owned(), |slope| number.per_unit(slope))
    };
    html! {
        h3 { "What means and deviations do" }
        table.numbers data-table="slopes" {
            thead { tr { th { "Input" } th.n { "Mean" } th.n { "Deviation" } th.n { "∂P/∂mean" } th.n { "∂P/∂deviation" } } }
            tbody {
                @for (number, asked) in answer.random.iter().zip(asked) {
                    @if let Some(Slopes { moments, by_mean, by_sd }) = asked {
                        tr {
                            td { code { (number.name) } }
                            td.n { (number.written(moments.mean)) }
                            td.n { (number.written(moments.sd)) }
                            td.n { (slope(number, *by_mean)) }
                            td.n { (slope(number, *by_sd)) }
                        }
                    }
                }
            }
        }
        p.note {
            "P is that the body does not rest " (period(answer)) "; the mean changes with the deviation kept, and the other way round. Both are those \
             before a law is cut."
        }
    }
}

/// Several sets of loads joined, and what is asked.
fn together(answer: &Probability) -> Markup {
    html! {
        @if let Some(joined) = answer.joined {
            p {
                "Under any of these " (joined.count) ", all with the same numbers drawn, the body does not stay at rest " (period(answer)) ": "
                (chance(joined.not_rest)) " (" (interval(joined.not_rest)) ")."
            }
        }
        @for sentence in answer.situations.first().and_then(|worst| of_row(answer, worst)).unwrap_or_default() {
            p { (sentence) }
        }
        @for check in &answer.criteria {
            @let (value, bound) = criterion_words(check);
            @let least = matches!(check.criterion.bound, Bound::AtLeast(_));
            p {
                "Criterion " code { (check.criterion.full_name()) } " " (period_of(answer, check)) " " (if least { "≥" } else { "≤" }) " " (bound)
                ": the " (if least { "lower" } else { "upper" }) " end of the interval is "
                data value=(check.counted) { (value) } "; "
                span.yes[check.is_met()].no[!check.is_met()] { (if check.is_met() { "met" } else { "not met" }) } "."
            }
        }
    }
}

fn sliding(answer: &Probability) -> Markup {
    let Some(sliding) = &answer.sliding else { return html! {} };
    let row = |name: String, e: Estimate, unit: &str| {
        html! {
            tr { td { (name) } td.n { (chance(e)) (unit) } td.n { (interval(e)) (unit) } }
        }
    };
    html! {
        h3 { "Slides over " (digits(sliding.years)) " years of storms" }
        table.numbers data-table="sliding" {
            thead { tr { th { "Slide in " (digits(sliding.years)) " years" } th.n { "Value" } th.n { "Interval" } } }
            tbody {
                (row("mean".to_owned(), sliding.mean, " m"))
                (row("chance of any slide".to_owned(), sliding.ever, ""))
                @for exceeded in &sliding.exceedance {
                    (row(format!("chance of more than {:.2} m", exceeded.slide), exceeded.probability, ""))
                }
                @for quantile in &sliding.quantiles {
                    (row(format!("{} % of all lives stay below", digits(100.0 * quantile.share)), quantile.slide, " m"))
                }
            }
        }
        @if sliding.storm.parts.len() > 1 || sliding.storm.combination.is_some() {
            p { "Each year has " (sliding.storm_words()) "." }
        }
        p {
            (digits(100.0 * sliding.of_worst)) " % of the mean comes of the worst 5 % of all lives. " (sliding.left_out_words()) " are left \
             out of the slides: " (digits(sliding.rotating.wave.value)) " of all waves."
        }
    }
}

fn left_out(answer: &Probability) -> Markup {
    let cut: Vec<_> = answer.random.iter().filter(|number| number.cut >= 1e-12).collect();
    html! {
        h3 { "What these probabilities leave out" }
        ul {
            li { "every number that is not random above is taken as given;" }
            li {
                "the error of the laws themselves and of their parameters, which a small probability feels most"
                @if answer.random.iter().any(|number| number.fit.is_some()) { "; but for the parameters that are fitted below" }
                ";"
            }
            li { "errors of the models, unless a bias stands among the inputs; gross errors of design, execution and use;" }
            li { "what no mode of this calculation has, see the next section." }
        }
        @for (number, words) in answer.random.iter().filter_map(|number| Some((number, number.fit_words()?))) {
            p { code { (number.name) } " is " (words) ". What they leave uncertain is drawn once for all events." }
        }
        @for number in cut {
            p { (digits(number.cut)) " of the law of " code { (number.name) } " is cut away: no body has such values." }
        }
    }
}
