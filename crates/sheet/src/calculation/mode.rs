//! The mode of response in the report's plane: coordinates, inequalities, changes of mode.

use maud::{Markup, PreEscaped, html};
use standfast::Mode;
use standfast::initiation::Crossing;
use standfast::loads::{LoadSource, Reduced};
use standfast_cases::assess::{checks, verdict};
use standfast_cases::describe;
use standfast_cases::layout::apart;
use standfast_cases::{Assessed, Case};

use super::loads::{force_symbols, shows_factor};
use crate::mathml::symbol;
use crate::measured::{KILONEWTON, NONE};
use crate::steps::SheetSteps;
use crate::together::{Brief, Row};

/// k and k' of a lone force in air.
pub(super) fn in_air(steps: &mut SheetSteps, case: &Case, assessed: &Assessed, reduced: &Reduced) {
    let point = &reduced.point;
    let loads = assessed.situation.loads().iter().enumerate();
    let Some((i, load)) = loads.into_iter().find(|(_, load)| load.source == LoadSource::Force) else {
        return;
    };
    let [force, elevation, _] = force_symbols(case, load);
    let factor = if shows_factor(case, load.factor) { format!("γ_F{} ", i + 1) } else { String::new() };
    steps.heading("Reduction to the report's plane");
    let formula = format!("{factor}{force}/(m g)");
    steps.add("Force, in weights of the body", "", ["k", &formula], point.k(), NONE, "k_eff");
    let about = "Height of the force above the centre of mass, in half-heights";
    let formula = format!("({elevation} − H)/H");
    steps.add(about, "", ["k'", &formula], point.k_prime(), NONE, "k_prime_eff");
    if reduced.mirrored {
        steps.note(describe::MIRRORED);
    }
}

/// k_eff and k'_eff of loads that act together.
pub(super) fn effective(steps: &mut SheetSteps, reduced: &Reduced) {
    let point = &reduced.point;
    steps.heading("The report's plane, in effective coordinates");
    steps.add("Horizontal by vertical load", "theory of loads", ["k_eff", "|X|/V"], point.k(), NONE, "k_eff");
    let about = "Height of the resultant above the centre of mass, in half-heights";
    let formula = ["k'_eff", "−M/(X H)"];
    steps.add(about, "theory of loads", formula, point.k_prime(), NONE, "k_prime_eff");
    steps.know("k", point.k(), NONE);
    steps.know("k'", point.k_prime(), NONE);
    if reduced.mirrored {
        steps.note(describe::MIRRORED);
    }
    steps.note("From here on `k` and `k'` are the effective ones.");
    let about = "Safety against overturning in these coordinates";
    let factor = point.safety_against_overturning();
    if factor.is_finite() {
        steps.add(about, "", ["SF_eff", "1/(k γ |1 + k'|)"], factor, NONE, "");
        steps.note(checks::two_factors(reduced));
    }
}

/// The inequalities in the order they are tried.
pub(super) fn decision(steps: &mut SheetSteps, assessed: &Assessed, reduced: &Reduced) {
    let point = &reduced.point;
    let chart = point.chart();
    let trace = point.explain();
    steps.heading("Mode of response: the report's inequalities");
    steps.note(&format!(
        "{}. Modes are tried in the report's order; one holds if all of its inequalities do. The decision is exact for the \
         numbers given, without tolerance.",
        standfast_cases::capital(chart.case().words()).replace('\'', "′")
    ));
    let bounds = || trace.steps.iter().flat_map(|step| &step.relations).map(|relation| relation.bound);
    if bounds().any(|bound| bound.contains("a k")) {
        let [a, b, c, d] = chart.coefficients();
        // Chapter III of the report has them for forces above the centre of mass, chapter IV for those below.
        let above = point.k_prime() >= 0.0;
        let numbers = if above { ["3.18", "3.19", "3.20", "3.21"] } else { ["4.42", "4.43", "4.44", "4.45"] };
        steps.add("Coefficients", numbers[0], ["a", "4 + γ^2 − 3 γ^2 k'"], a, NONE, "");
        steps.add("", numbers[1], ["b", "3 γ"], b, NONE, "");
        steps.add("", numbers[2], ["c", "3 γ (1 + k')"], c, NONE, "");
        steps.add("", numbers[3], ["d", "1 + 4 γ^2"], d, NONE, "");
    }
    for step in &trace.steps {
        let mode = reduced.orient(step.mode);
        let mirrored = match mode == step.mode {
            true => String::new(),
            false => format!(", the mirror image of {}", step.mode),
        };
        steps.question(
            &format!("Does it hold that the body {} ({mode}{mirrored})?", mode.words()),
            step.holds,
        );
        for relation in &step.relations {
            steps.relation(&assessed.situation.settled(*relation));
        }
    }
    steps.note(&match assessed.outcome.full.boundary {
        Some(_) => verdict::uniqueness(assessed),
        None => describe::uniqueness(reduced),
    });
}

/// Shows the changes of mode over the friction and, of a lone force in air, over the force; `weight` is then m g.
pub(super) fn changes(steps: &mut SheetSteps, reduced: &Reduced, weight: Option<f64>) {
    let margins = reduced.point.margins();
    steps.heading("Changes of mode");
    // Of a lone force in air the force at k is told as well.
    let force = |k: f64| weight.map(|weight| steps.measured(k * weight, KILONEWTON).html(""));
    let along_k = if weight.is_some() { &margins.along_k[..] } else { &[] };
    let varied = [("force", "k", along_k), ("friction", "μ", &margins.along_mu)];
    let full = html! {
        table.numbers data-table="changes" {
            thead {
                tr {
                    th { "Varied" }
                    th.n { "Value" }
                    @if weight.is_some() { th.n { (PreEscaped(symbol("F"))) } }
                    th { "Change of mode" }
                }
            }
            tbody {
                @for (what, name, crossings) in &varied {
                    @for (text, crossing) in shown(crossings) {
                        tr {
                            td { (what) ", " (PreEscaped(symbol(name))) }
                            td.n { data value=(crossing.at) { (text) } }
                            @if weight.is_some() {
                                td.n { @if *name == "k" { @if let Some(force) = force(crossing.at) { (force) } } @else { "–" } }
                            }
                            td { (arrow(reduced, crossing)) }
                        }
                    }
                }
            }
        }
    };
    let rows =
        varied.iter().filter(|(_, _, crossings)| !crossings.is_empty()).map(|(what, name, crossings)| Row {
            name: String::new(),
            key: format!("changes along {name}"),
            about: html! {},
            head: html! { "Changes along the " (what) ", " (PreEscaped(symbol(name))) },
            unit: html! {},
            cell: html! {
                @for (text, crossing) in shown(crossings) {
                    div { data value=(crossing.at) { (text) } ": " (arrow(reduced, crossing)) }
                }
            },
        });
    let rows = Brief::Rows(rows.collect());
    steps.push(full, rows);
    if margins.along_mu.last().is_some_and(|crossing| crossing.to != Mode::Rest) {
        steps.note("Whatever the friction, the body does not stay at rest under this load.");
    }
}

/// Crossings with their values in as many digits as tell them apart.
fn shown(crossings: &[Crossing]) -> impl Iterator<Item = (String, &Crossing)> {
    let values: Vec<_> = crossings.iter().map(|crossing| crossing.at).collect();
    apart(&values).into_iter().zip(crossings)
}

fn arrow(reduced: &Reduced, crossing: &Crossing) -> Markup {
    html! { (reduced.orient(crossing.from)) " → " (reduced.orient(crossing.to)) }
}
