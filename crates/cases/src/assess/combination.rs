//! What a combination says, in words: the factors of its loads, and what is another in it than in the case.

use standfast_inputs::inputs::LoadFactor;
use standfast_model::case::{ChangeBy, Code, Combination, InputChange, Trial};

use super::Assessed;
use crate::case::{Acting, Case};
use crate::couple::Variable;
use crate::key::Key;
use crate::layout::digits;

/// The factors of a combination, as they are given.
pub fn factors(combination: &Combination) -> String {
    let factors = combination.factors.iter().map(|(name, factor)| {
        let factor = match factor {
            LoadFactor::One(factor) => digits(*factor),
            LoadFactor::Pair([one, two]) => format!("{} or {}", digits(*one), digits(*two)),
        };
        format!("{name} × {factor}")
    });
    let factors = factors.collect::<Vec<_>>().join("; ");
    if factors.is_empty() { "none".to_owned() } else { factors }
}

/// What else a combination of a case, by its place, says: its key, and what stands there in words.
pub fn changes(case: &Case, index: usize) -> Vec<(&'static str, String)> {
    let combination = &case.combinations[index];
    let under = case.under(Acting::Combination(index));
    let inputs = under.inputs();
    // Of a number that is changed more than once, no step is the last.
    let becomes = |change: &InputChange| {
        let same = combination.changes.iter().filter(|other| other.id == change.id);
        let found = Variable::find(&change.name, inputs).ok().filter(|_| same.count() == 1);
        found.map_or_else(String::new, |variable| {
            let number = variable.value(inputs, under);
            match variable.dimension() {
                Some(dimension) => format!(" = {}", under.output.written(dimension, number)),
                None if change.id.key.name().ends_with("_deg") => format!(" = {}°", digits(number)),
                None => format!(" = {}", digits(number)),
            }
        })
    };
    let mut told: Vec<(&'static str, Vec<String>)> = Vec::new();
    let mut tell = |key: &'static str, words: String| match told.last_mut() {
        Some((last, all)) if *last == key => all.push(words),
        _ => told.push((key, vec![words])),
    };
    match &combination.code {
        Some(Code::Set(name)) => tell("code", format!("{name}, recommended values")),
        Some(Code::File(name)) => tell("code", name.clone()),
        None => {}
    }
    if combination.effects {
        tell("effects", "factors act on the effects of the loads, not on these".to_owned());
    }
    for change in &combination.changes {
        let name = &change.name;
        let words = match &change.by {
            ChangeBy::Set(text) => format!("{name} = {}", text.trim_matches(['"', '\''])),
            ChangeBy::Scale(by) => format!("{name} × {}{}", digits(*by), becomes(change)),
            ChangeBy::Material(by) if change.id.key.is_friction_angle() => {
                format!("tan {name} / {}{}", digits(*by), becomes(change))
            }
            ChangeBy::Material(by) => format!("{name} / {}{}", digits(*by), becomes(change)),
            // Friction and adhesion are divided by one number.
            ChangeBy::Resistance(_) if change.id.key != Key::Friction => continue,
            ChangeBy::Resistance(by) => format!("{name} / {}", digits(*by)),
        };
        tell(change.by.key().name(), words);
    }
    combination.holds.iter().for_each(|(name, by)| tell("resist", format!("{name} / {}", digits(*by))));
    if combination.bearing != 1.0 {
        tell("resist", format!("bearing / {}", digits(combination.bearing)));
    }
    if let Some(criteria) = &combination.criteria {
        criteria
            .iter()
            .for_each(|criterion| tell("criteria", format!("{} {}", criterion.name(), criterion.required())));
    }
    told.into_iter().map(|(key, words)| (key, words.join(", "))).collect()
}

/// The names of the pairs of factors of a situation, and which of each is taken in a trial.
pub fn pairs(case: &Case, acting: Acting, trial: Trial) -> Vec<(&str, f64)> {
    let Acting::Combination(index) = acting else { return Vec::new() };
    let combination = &case.combinations[index];
    let pairs = combination.factors.iter().filter(|(_, factor)| matches!(factor, LoadFactor::Pair(_)));
    pairs.filter_map(|(name, _)| Some((name.as_str(), combination.factor(name, trial)?))).collect()
}

/// The pairs of a situation in the way in which it is tried, in words: `weight × 0.9, sand × 1.35`.
pub fn pair_words(case: &Case, assessed: &Assessed) -> Option<String> {
    let pairs = pairs(case, assessed.acting, assessed.trial);
    let words: Vec<_> = pairs.iter().map(|(name, factor)| format!("{name} × {}", digits(*factor))).collect();
    (!words.is_empty()).then(|| words.join(", "))
}
