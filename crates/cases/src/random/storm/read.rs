//! Reads a `[storm]` table.

use standfast::number::exact;
use toml::de::DeTable;

use super::{Pulse, Storm, Tau0};
use crate::random::read::{At, Item, RandomProblem, Written, in_order, positive, table, written, wrong};
use crate::units::Dimension;

/// The name of the table.
pub(crate) const STORM: &str = "storm";

/// The keys of every storm.
pub(super) const KEYS: [&str; 6] = ["waves", "duration", "period", "heights", "tau0", "pulse"];

/// Reads the storm of a case.
pub(crate) fn read(item: &Item<'_>) -> At<Storm> {
    let table = table(item, "`storm`", "a table")?;
    let allowed: Vec<&str> = KEYS.into_iter().chain(["cut"]).collect();
    only(table, &allowed)?;
    let mut storm = of_all(item, table)?;
    storm.is_cut = match table.get("cut") {
        None => true,
        Some(value) => value.get_ref().as_bool().ok_or_else(|| {
            wrong(value, "`cut` of [storm]", "true, for heights cut at H_max of the sea, or false")
        })?,
    };
    Ok(storm)
}

/// No key but these.
pub(super) fn only(table: &DeTable<'_>, allowed: &[&str]) -> At<()> {
    match in_order(table).into_iter().find(|(key, _)| !allowed.contains(key)) {
        None => Ok(()),
        Some((key, value)) => {
            let allowed = allowed.iter().map(|name| (*name).to_owned()).collect();
            Err((
                RandomProblem::Name { what: "[storm]".to_owned(), name: key.to_owned(), allowed },
                value.span(),
            ))
        }
    }
}

/// What every storm says.
pub(super) fn of_all(item: &Item<'_>, table: &DeTable<'_>) -> At<Storm> {
    let lacks = |what: &str| (RandomProblem::Other(format!("[storm] lacks {what}")), item.span());
    let waves = match (table.get("waves"), table.get("duration"), table.get("period")) {
        (Some(waves), None, None) => (positive(waves, "`waves`")?, waves.span()),
        (None, Some(duration), Some(period)) => {
            let [duration, period] = [(duration, "duration"), (period, "period")]
                .map(|(value, name)| measured(value, name, Some(Dimension::Time)));
            ((duration? / period?).round(), item.span())
        }
        _ => return Err(lacks("either `waves`, their number in a storm, or `duration` and `period`")),
    };
    let (count, span) = waves;
    if count < 1.0 || count.fract() != 0.0 || count > 1e9 {
        let expected = "a whole number of waves".to_owned();
        return Err((
            RandomProblem::Value { what: "`waves`".to_owned(), written: exact(count), expected },
            span,
        ));
    }
    if let Some(heights) = table.get("heights") {
        word(heights, "heights", &["rayleigh"])?;
    }
    let tau0 = match table.get("tau0") {
        Some(value) if value.get_ref().as_str() == Some("shimosako-takahashi") => Tau0::Formula,
        Some(value) => Tau0::Given(measured(value, "tau0", Some(Dimension::Time))?),
        None => return Err(lacks("`tau0`, the duration of a wave's pulse, or \"shimosako-takahashi\"")),
    };
    let names = Pulse::ALL.map(Pulse::name);
    let pulse = match table.get("pulse") {
        None => Pulse::default(),
        Some(value) => Pulse::ALL[word(value, "pulse", &names)?],
    };
    Ok(Storm { waves: count as u64, tau0, pulse, is_cut: false })
}

/// The place of one of these words.
fn word(item: &Item<'_>, name: &str, words: &[&str]) -> At<usize> {
    let expected = words.iter().map(|word| format!("\"{word}\"")).collect::<Vec<_>>().join(" or ");
    let Some(text) = item.get_ref().as_str() else {
        return Err(wrong(item, format!("`{name}` of [storm]"), expected));
    };
    words.iter().position(|word| *word == text).ok_or_else(|| {
        let what = format!("`{name}` of [storm]");
        (RandomProblem::Value { what, written: format!("\"{text}\""), expected }, item.span())
    })
}

/// A number above zero in SI units, plain or with its unit.
pub(super) fn measured(item: &Item<'_>, name: &str, dimension: Option<Dimension>) -> At<f64> {
    let expected = match dimension {
        Some(dimension) => {
            format!("a number above zero, or {} in {}", dimension.words(), dimension.understood())
        }
        None => "a number above zero, without unit or quotes".to_owned(),
    };
    let what = format!("`{name}` of [storm]");
    let refused = |written: String| {
        (RandomProblem::Value { what: what.clone(), written, expected: expected.clone() }, item.span())
    };
    let value = match (written(item), dimension) {
        (Some(Written::Number(number)), _) => number,
        (Some(Written::Text(text)), Some(dimension)) => {
            dimension.parse(&text).map_err(|_| refused(format!("\"{text}\"")))?
        }
        (Some(Written::Text(text)), None) => return Err(refused(format!("\"{text}\""))),
        (None, _) => return Err(wrong(item, what.clone(), expected.clone())),
    };
    if value > 0.0 && value.is_finite() { Ok(value) } else { Err(refused(exact(value))) }
}
