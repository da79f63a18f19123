//! Water under a base that opens, for reading and for programs.

use serde::Serialize;
use standfast::contact::opening::OpeningState;
use standfast::{BaseOpening, OpeningRule};

use super::Assessed;
use crate::layout::{columns, paragraph, percent, row};

/// The base of a situation, where its opening changes the water under it or drains lie there.
pub fn told(assessed: &Assessed) -> Option<BaseOpening> {
    let opening = assessed.situation.base_opening()?;
    (opening.state != OpeningState::Closed || opening.drain.is_some()).then_some(opening)
}

/// The end of the base from which it opens: that of the higher head.
pub fn side(opening: &BaseOpening) -> &'static str {
    if opening.heads[0] > opening.heads[1] { "left" } else { "right" }
}

/// The word for a state.
pub fn state(opening: &BaseOpening) -> &'static str {
    match opening.state {
        OpeningState::Closed => "closed",
        OpeningState::Open { .. } => "open",
        OpeningState::Through => "through",
    }
}

/// Sentence on loads that are too fast for the water.
pub const HELD: &str = "Waves, earthquakes and other fast loads meet the water that the steady loads leave: it has no time to follow them.";

pub(super) fn render(assessed: &Assessed) -> String {
    let Some(opening) = told(assessed) else { return String::new() };
    let base = assessed.situation.body().base_width();
    let corner = if side(&opening) == "left" { "O" } else { "O'" };
    let contact = opening.contact(base);
    let mut rows = Vec::new();
    let output = assessed.output;
    let head = output.pressure(opening.open_pressure());
    match opening.state {
        OpeningState::Closed => rows.push(row!["closed", "no part of the base is pulled"]),
        OpeningState::Open { .. } => {
            let opened = format!(
                "{} from {corner} on, where {head} stand, the higher head",
                output.length(base - contact)
            );
            rows.push(row!["opened", opened]);
            let share = percent(contact / base);
            rows.push(row!["pressed", format!("{} ({share} of the base)", output.length(contact))]);
        }
        OpeningState::Through => {
            rows.push(row!["opened", format!("from end to end: {head} stand under the whole base")])
        }
    }
    let closed = match opening.state {
        OpeningState::Closed => String::new(),
        _ => format!("; {} if nothing opened", output.force(opening.uplift_closed)),
    };
    rows.push(row!["uplift of the water", output.force(opening.uplift) + &closed]);
    if let Some(drain) = opening.drain {
        let works = if opening.drain_works() == Some(true) {
            "works"
        } else {
            "is lost: the base has opened beyond it"
        };
        let place = format!("at {} from O, {works}", output.length(drain.distance));
        rows.push(row!["drain", place]);
    }
    if let Some(factor) = opening.opens_at.filter(|_| assessed.rises()) {
        rows.push(row!["begins to open", format!("at {} of the variable loads", percent(factor))]);
    }
    let mut text = "\nWater under the base\n".to_owned() + &columns(&rows, 2, &[]);
    if opening.state != OpeningState::Closed {
        let how = "Water fills what opens: from there the pressure falls in a straight line to the other head. opening = \"closed\" in [water] \
                   keeps the straight line under the whole base.";
        text += &paragraph(how, 2);
    }
    if opening.is_held {
        text += &paragraph(HELD, 2);
    }
    text
}

/// The base of a situation as a program reads it.
#[derive(Debug, Clone, Serialize)]
pub struct BaseOpeningEntry {
    rule: &'static str,
    side: &'static str,
    state: &'static str,
    contact: f64,
    pressure_open: f64,
    uplift: f64,
    uplift_closed: f64,
    drain: Option<&'static str>,
    load_factor_opens: Option<f64>,
    load_factor_tips: Option<f64>,
}

impl BaseOpeningEntry {
    pub(super) fn of(assessed: &Assessed) -> Option<BaseOpeningEntry> {
        let opening = told(assessed)?;
        Some(BaseOpeningEntry {
            rule: match opening.rule {
                OpeningRule::Steady => "steady",
                OpeningRule::Always => "always",
            },
            side: side(&opening),
            state: state(&opening),
            contact: opening.contact(assessed.situation.body().base_width()),
            pressure_open: opening.open_pressure(),
            uplift: opening.uplift,
            uplift_closed: opening.uplift_closed,
            drain: opening.drain_works().map(|works| if works { "works" } else { "lost" }),
            load_factor_opens: opening.opens_at,
            load_factor_tips: opening.tips_at,
        })
    }
}
