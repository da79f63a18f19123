//! Lines of formulas on a page: `θ_ddot = 3 k γ/4 g/B; k > k_A   if the block turns   (3.14)`.

use crate::fault::SheetFault;
use crate::formula::Formula;
use crate::mathml::{FormulaContent, draw};

/// Signs between two sides.
const RELATIONS: [char; 9] = ['=', '<', '>', '≤', '≥', '≠', '≈', '→', '≡'];
/// Blanks before a condition in words and before a number.
const GAP: &str = "   ";

/// A line of a page, drawn.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Displayed {
    /// Its formulas, each as a `math` element.
    pub formulas: Vec<String>,
    /// The condition or the name of the formulas, in words; it may be empty.
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
        let is_number = |part: &&str| part.starts_with('(') && part.ends_with(')');
        let number = rest.pop_if(|part| is_number(&&**part)).unwrap_or_default();
        let formulas = first.split(';').map(|text| relations(text.trim(), line)).collect::<Result<_, _>>()?;
        Ok(Displayed { formulas, words: rest.join(" "), number: number.trim_matches(['(', ')']).to_owned() })
    }
}

fn relations(text: &str, line: &str) -> Result<String, SheetFault> {
    let mut row = String::new();
    let mut rest = text;
    loop {
        let at = rest.find(RELATIONS);
        let side = rest[..at.unwrap_or(rest.len())].trim();
        let formula = Formula::parse(side)
            .map_err(|source| SheetFault::Formula {
                place: format!("the line “{}”", line.trim()), source
            })?;
        row += &draw(&formula, FormulaContent::Symbols, true);
        let Some((sign, behind)) = at.and_then(|at| {
            let sign = rest[at..].chars().next()?;
            Some((sign, &rest[at + sign.len_utf8()..]))
        }) else {
            break;
        };
        let sign = match sign {
            '<' => "&lt;".to_owned(),
            '>' => "&gt;".to_owned(),
            other => other.to_string(),
        };
        row += &format!("<mo form=\"infix\">{sign}</mo>");
        rest = behind;
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
