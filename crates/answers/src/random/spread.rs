//! The numbers of a case that can be random, each with its law or with one to begin from.

use super::quantity::{Quantity, RandomInput};
use super::resolve::{Names, Resolve, same};
use super::template::{ProposedLaw, proposed};
use crate::case::Case;
use crate::digits::digits;
use crate::error::CaseError;
use crate::units::Dimension;
use standfast_inputs::random::{RandomEntry, Rate};
use standfast_model::CaseFile;

/// A number that is random, or may be made so.
#[derive(Debug, Clone, PartialEq)]
pub struct Spread {
    /// Its name in `[random]`.
    pub name: String,
    /// Its meaning in a few words.
    pub words: String,
    /// The case's own value on paper, which is the mean where a law has none; empty of a factor on loads.
    pub own: String,
    /// The dimension of its values, where they have one.
    pub dimension: Option<Dimension>,
    /// Its law; none of a number that is certain.
    pub law: Option<RandomEntry>,
    /// A law to begin from.
    pub proposed: Option<ProposedLaw>,
}

/// The numbers of a case for which there is a law of practice, certain or not, and behind them all others that are random.
///
/// # Errors
/// If the values of the case do not go together; of a block in pure numbers.
pub fn spreads(file: &CaseFile) -> Result<Vec<Spread>, CaseError> {
    let first = file.first_instant()?.map(|first| first.file);
    let file = first.as_ref().unwrap_or(file);
    let case = file.case()?;
    let of = |name: &str| input(file, &case, name);
    let mut named: Vec<(Option<RandomInput>, RandomEntry)> = Vec::new();
    for entry in file.random().map_or(&[][..], |random| &random.named) {
        named.push((of(&entry.name), entry.clone()));
    }
    let mut spreads = Vec::new();
    for proposed in proposed(&case, file.inputs()) {
        let Some(input) = of(&proposed.name) else { continue };
        let is_same = |(own, _): &(Option<RandomInput>, _)| {
            own.as_ref().is_some_and(|own| same(&own.quantity, &input.quantity))
        };
        let law = named.iter().position(is_same).map(|place| named.remove(place).1);
        let name = law.as_ref().map_or(proposed.name.clone(), |law| law.name.clone());
        let (words, own, dimension) = (input.words(), own(&input, file, &case), input.dimension());
        spreads.push(Spread { name, words, own, dimension, law, proposed: Some(proposed) });
    }
    let others = named.into_iter().map(|(input, law)| Spread {
        name: law.name.clone(),
        words: input.as_ref().map_or_else(|| law.name.clone(), RandomInput::words),
        dimension: input.as_ref().and_then(RandomInput::dimension),
        own: input.map_or(String::new(), |input| own(&input, file, &case)),
        law: Some(law),
        proposed: None,
    });
    spreads.extend(others);
    Ok(spreads)
}

/// The number under a name of `[random]`.
fn input(file: &CaseFile, case: &Case, name: &str) -> Option<RandomInput> {
    let entry = RandomEntry::without_law(name.to_owned(), 0..0);
    let quantity = Resolve(Names::Case(file, case, None)).quantity(&entry).ok()?;
    Some(RandomInput { name: entry.name, quantity, every: Rate::Life, own: false, cut: 0.0, fit: None })
}

fn own(input: &RandomInput, file: &CaseFile, case: &Case) -> String {
    let Quantity::Key(variable) = &input.quantity else { return String::new() };
    let value = variable.value(file.inputs(), case);
    variable.dimension().map_or_else(|| digits(value), |dimension| dimension.written(value))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(text: &str) -> Vec<String> {
        let file = CaseFile::parse("t.toml", text).unwrap();
        let told = |spread: &Spread| {
            let law = spread.law.as_ref().map_or("certain".to_owned(), RandomEntry::law_words);
            let proposed = spread.proposed.as_ref().map_or("none".to_owned(), ProposedLaw::written);
            format!("{} ({}): {law}; {proposed}", spread.name, spread.own)
        };
        spreads(&file).unwrap().iter().map(told).collect()
    }

    const BODY: &str = "[body]\nwidth = \"15 m\"\nheight = \"12 m\"\nmass = \"378 t/m\"\nfriction = 0.6\n\
                        [[load]]\nname = \"blow\"\nforce = \"1900 kN/m\"\nelevation = \"11.5 m\"\n";

    #[test]
    fn numbers_of_a_case_have_laws_to_begin_from() {
        assert_eq!(
            told(BODY),
            [
                "friction (0.6): certain; { lognormal = { cov = 0.2 } }",
                "mass (378 t/m): certain; { normal = { cov = 0.03 } }",
                "bias.force (): certain; { lognormal = { mean = 1, cov = 0.2 } }",
            ]
        );
    }

    /// Under whatever name a number is random, it is one.
    #[test]
    fn laws_that_are_there_stand_beside_those_to_begin_from() {
        let random = "[random]\nbody.friction = { normal = { sd = 0.08 } }\n\"load.blow.force\" = { normal = { cov = 0.15 } }\n";
        let told = told(&format!("{BODY}{random}"));
        assert_eq!(told[0], "body.friction (0.6): normal, sd 0.08; { lognormal = { cov = 0.2 } }");
        assert!(told[3].starts_with("load.blow.force (1"), "{told:?}");
        assert_eq!(told.len(), 4);
    }
}
