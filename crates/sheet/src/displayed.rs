//! Lines of formulas on a page: `θ_ddot = 3 k γ/4 g/B; k > k_A   if the block turns   (3.14)`.

use crate::fault::SheetFault;
use crate::formula::Formula;
use crate::mathml::{FormulaContent, draw, escape, operator};

/// Signs between two sides.
const RELATIONS: [char; 9] = ['=', '<', '>', '≤', '≥', '≠', '≈', '→', '≡'];
/// Blanks before a condition in words and before a number.
const GAP: &str = "   ";

/// A line of a page, drawn.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Displayed {
    /// Its formulas, each as a `math` element.
    pub formulas: Vec<String>,
    /// The condition or the name of the formulas, in words, as HTML; it may be empty.
    pub words: String,
    /// Number of the equation, without parentheses; it may be empty.
    pub number: String,
}

impl Displayed {
    /// Draws a line: formulas with `;` between them, then words behind three blanks, then a number in parentheses behind three more.
    ///
    /// # Errors
    /// If a side of a relation cannot be read.
    pub fn of(line: &str) -> Result<Displayed, SheetFault> {
        let mut parts = line.split(GAP).map(str::trim).filter(|part| !part.is_empty());
        let first = parts.next().unwrap_or_default();
        let mut rest: Vec<&str> = parts.collect();
        let number = rest.pop_if(|part| part.starts_with('(') && part.ends_with(')')).unwrap_or_default();
        let formulas = first.split(';').map(|text| relations(text.trim(), line)).collect::<Result<_, _>>()?;
        Ok(Displayed {
            formulas,
            words: escape(&rest.join(" ")),
            number: number.trim_matches(['(', ')']).to_owned(),
        })
    }
}

fn relations(text: &str, line: &str) -> Result<String, SheetFault> {
    let mut row = String::new();
    let mut signs = text.matches(RELATIONS);
    for side in text.split(RELATIONS) {
        let place = || format!("the line “{}”", line.trim());
        let formula =
            Formula::parse(side.trim()).map_err(|source| SheetFault::Formula { place: place(), source })?;
        row += &draw(&formula, FormulaContent::Symbols, true);
        row += &signs.next().map_or(String::new(), |sign| operator(&escape(sign)));
    }
    Ok(format!("<math displaystyle=\"true\"><mrow>{row}</mrow></math>"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_has_formulas_words_and_a_number() {
        let line = Displayed::of("θ_ddot = 3 k/4 g; a < b   if it turns   (3.14, 4.36)").unwrap();
        assert_eq!(line.formulas.len(), 2);
        assert!(line.formulas[0].contains("<mover accent=\"true\"><mi>θ</mi>"), "{}", line.formulas[0]);
        assert!(line.formulas[1].contains("&lt;"));
        assert_eq!((line.words.as_str(), line.number.as_str()), ("if it turns", "3.14, 4.36"));
        let bare = Displayed::of("k_A = 1/(γ (1 + k'))").unwrap();
        assert_eq!((bare.formulas.len(), bare.words.as_str(), bare.number.as_str()), (1, "", ""));
        for wrong in ["a = ", "= b", "a = b c)", "a ~ b"] {
            assert!(Displayed::of(wrong).is_err(), "{wrong}");
        }
    }
}
