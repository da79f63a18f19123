//! The probabilities as text.

use std::fmt::Write;

use standfast::Mode;
use standfast_probability::sample::Estimate;

use super::answer::{Chances, Happening, Method, Probability};
use crate::layout::{columns, digits, paragraph, row};

impl Probability {
    /// The answer as text.
    pub fn text(&self) -> String {
        let mut text = String::new();
        let [worst, others @ ..] = &self.situations[..] else { unreachable!("a case has loads") };
        text += &self.chances(worst);
        for chances in others {
            let _ = writeln!(text, "\nUnder {}", chances.situation.as_deref().unwrap_or("other loads"));
            text += &event_table(chances, self.floor());
        }
        text
    }

    fn floor(&self) -> f64 {
        self.request.effort.floor
    }

    fn chances(&self, chances: &Chances) -> String {
        let numbers = self.random.len();
        let (line, exact) = &self.line;
        let how = match (chances.method, exact) {
            (Method::MonteCarlo, _) => "everything drawn".to_owned(),
            (_, true) => format!("{line} in closed form"),
            (_, false) => format!("{line} scanned"),
        };
        let counted = match chances.method {
            Method::Integrate => "integrated".to_owned(),
            method => {
                format!("{method}, {} points, seed {}", grouped(chances.points), self.request.effort.seed)
            }
        };
        let numbers =
            if numbers == 1 { "1 random number".to_owned() } else { format!("{numbers} random numbers") };
        let mut text = paragraph(&format!("Probability ({how}, {numbers}, {counted})"), 0);
        if let Some(situation) = &chances.situation {
            let least = if self.situations.len() > 1 { ", the least safe" } else { "" };
            let _ = writeln!(text, "  under {situation}{least}");
        }
        text += &event_table(chances, self.floor());
        text += &self.index(chances);
        if !chances.precise {
            let effort = &self.request.effort;
            text += &paragraph(
                &format!(
                    "Not as precise as asked, {} % of every probability above {}: --samples takes more points.",
                    digits(100.0 * effort.precision),
                    digits(effort.floor)
                ),
                2,
            );
        }
        // Less is in the JSON alone.
        for (name, cut) in self.random.iter().filter(|(_, cut)| *cut >= 1e-12) {
            text += &paragraph(
                &format!("{} of the law of {name} is cut away: no body has such values.", digits(*cut)),
                2,
            );
        }
        text += &self.matters(chances);
        if let Some(life) = &chances.life {
            let _ = writeln!(text, "\nAt least once in {} years", digits(life.years));
            // Rest is what a life begins with.
            let moved: Vec<_> =
                life.modes.iter().copied().filter(|(mode, _)| *mode != Happening::Mode(Mode::Rest)).collect();
            text += &modes_table(chances, &moved, life.not_rest, self.floor());
        }
        text
    }

    /// The reliability index beside the probability.
    fn index(&self, chances: &Chances) -> String {
        let Some(point) = &chances.design_point else {
            return paragraph("Nowhere within twelve deviations of the medians does it move.", 2);
        };
        let mut said = format!("β {}", digits(point.beta));
        if point.at_change {
            said += " at a change of formula or of mode";
        }
        let _ = write!(said, "; Φ(−β) = {} is not P", digits(point.first_order()));
        if let Some(beta) = chances.generalized() {
            let _ = write!(said, "; β_g {}", digits(beta));
        }
        paragraph(&format!("{said}."), 2)
    }

    /// Which number matters.
    fn matters(&self, chances: &Chances) -> String {
        let Some(point) = chances.design_point.as_ref().filter(|_| self.random.len() > 1) else {
            return String::new();
        };
        let mut order: Vec<usize> = (0..self.random.len()).collect();
        order.sort_by(|a, b| point.alpha[*b].abs().total_cmp(&point.alpha[*a].abs()));
        let mut rows = vec![row!["Which number matters", "α²", "P if it were known", "at the design point"]];
        for place in order {
            let known = chances.known.get(place).map_or(String::new(), |e| probability(e.value));
            rows.push(row![
                format!("  {}", self.random[place].0),
                format!("{:.2}", point.alpha[place].powi(2)),
                known,
                digits(point.values[place])
            ]);
        }
        format!("\n{}", columns(&rows, 0, &[1, 2, 3]))
    }
}

/// The modes under the loads of one event.
fn event_table(chances: &Chances, floor: f64) -> String {
    let mut text = modes_table(chances, &chances.modes, chances.not_rest, floor);
    let parts = [
        ("more than one consistent mode", chances.not_unique),
        ("nothing that presses the body down", chances.lifted),
    ];
    for (words, e) in parts.into_iter().filter(|(_, e)| e.value >= floor) {
        text += &paragraph(&format!("Of these with {words}: {}.", probability(e.value)), 2);
    }
    text
}

/// Modes with their probabilities; those below the floor together.
fn modes_table(chances: &Chances, modes: &[(Happening, Estimate)], not_rest: Estimate, floor: f64) -> String {
    let mut shown: Vec<_> = modes.iter().filter(|(_, e)| e.value >= floor).collect();
    shown.sort_by(|a, b| b.1.value.total_cmp(&a.1.value));
    let mut rows: Vec<Vec<String>> =
        shown.iter().map(|(happening, e)| line(&words(*happening), *e, chances.method)).collect();
    rows.push(line("does not rest", not_rest, chances.method));
    let mut text = columns(&rows, 2, &[1]);
    let below: Vec<_> = modes.iter().filter(|(_, e)| e.value < floor && e.high > 0.0).collect();
    if !below.is_empty() {
        let names: Vec<String> = below.iter().map(|(happening, _)| happening.name()).collect();
        let bound = below.iter().map(|(_, e)| e.high).fold(0.0, f64::max);
        text += &paragraph(&format!("{}: each below {}.", names.join(", "), probability(bound)), 2);
    }
    text
}

fn line(words: &str, e: Estimate, method: Method) -> Vec<String> {
    let interval = match method {
        Method::Integrate => String::new(),
        _ => format!("{} … {}", probability(e.low), probability(e.high)),
    };
    row![words, probability(e.value), interval]
}

fn words(happening: Happening) -> String {
    match happening {
        Happening::Mode(Mode::Rest) => "stays at rest, RE".to_owned(),
        Happening::Mode(mode) => format!("{}, {mode}", mode.words()),
        other => other.name(),
    }
}

/// A probability; one near 1 by what is missing is clear from the others.
fn probability(p: f64) -> String {
    digits(p)
}

/// A whole number with thin spaces between its thousands.
fn grouped(n: u64) -> String {
    let text = n.to_string();
    let mut grouped = String::new();
    for (place, digit) in text.chars().enumerate() {
        if place > 0 && (text.len() - place).is_multiple_of(3) {
            grouped.push('\u{202f}');
        }
        grouped.push(digit);
    }
    grouped
}
