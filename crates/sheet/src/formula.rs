//! Formulas as they are written on a line, `(p1 + p4) h_c* / 2`, read into a tree that is then drawn twice: in symbols and with
//! numbers put in. So a formula and its numbers cannot disagree.
//!
//! | written | means |
//! |---|---|
//! | `a b`, `a/b`, `a b/c d` | product, fraction; from left to right: (a b)/c times d |
//! | `a÷b` | the same, drawn on one line with a slash |
//! | `x^2`, `(a + b)`, `\|x\|` | power, group, absolute value |
//! | `cos(x)`, `min(a, b)`, `sqrt(x)` | functions: sin, cos, tan, sinh, cosh, tanh, exp, min, max, sqrt |
//! | `p_u`, `k'_eff`, `α*`, `λ1` | names with subscripts, primes and stars |

use std::collections::BTreeMap;

use thiserror::Error;

use crate::measured::Measured;

/// Numbers and units of the names in formulas.
pub type Scope = BTreeMap<String, Measured>;

/// A formula.
#[derive(Debug, Clone, PartialEq)]
pub enum Formula {
    /// A number as written.
    Number(String),
    /// A quantity, or π.
    Name(String),
    /// A quantity's number, put in for its name.
    Value(Measured),
    /// Operand of a minus sign.
    Negative(Box<Formula>),
    /// Terms, each with whether it is subtracted.
    Sum(Vec<(bool, Formula)>),
    /// Factors.
    Product(Vec<Formula>),
    /// Numerator and denominator.
    Fraction(Box<Formula>, Box<Formula>),
    /// Numerator and denominator on one line, with a slash.
    Ratio(Box<Formula>, Box<Formula>),
    /// Base and exponent.
    Power(Box<Formula>, Box<Formula>),
    /// A function and its arguments.
    Call(String, Vec<Formula>),
    /// Expression in parentheses.
    Group(Box<Formula>),
    /// An absolute value.
    Absolute(Box<Formula>),
}

/// A text that is not a formula.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("`{text}` is not a formula: expected {expected} at {}", place(.text, *.at))]
pub struct FormulaError {
    /// The text.
    pub text: String,
    /// The byte at which it goes wrong.
    pub at: usize,
    /// Symbols that could stand there.
    pub expected: &'static str,
}

fn place(text: &str, at: usize) -> String {
    match text.get(at..) {
        None | Some("") => "its end".to_owned(),
        Some(rest) => format!("`{rest}`"),
    }
}

const FUNCTIONS: [&str; 10] = ["sin", "cos", "tan", "sinh", "cosh", "tanh", "exp", "min", "max", "sqrt"];

impl Formula {
    /// Reads a formula.
    ///
    /// # Errors
    /// If the text is none.
    pub fn parse(text: &str) -> Result<Formula, FormulaError> {
        let error = |at, expected| FormulaError { text: text.to_owned(), at, expected };
        let tokens = tokens(text).map_err(|(at, expected)| error(at, expected))?;
        let mut reader = Reader { tokens: &tokens, next: 0, bars: 0 };
        let formula = reader.sum().and_then(|formula| match reader.next == tokens.len() {
            true => Ok(formula),
            false => Err("a sign, or nothing more"),
        });
        formula.map_err(|expected| error(tokens.get(reader.next).map_or(text.len(), |(at, _)| *at), expected))
    }

    /// The formula without the parentheses around all of it, where a fraction bar or a root makes them idle.
    pub fn bare(&self) -> &Formula {
        match self {
            Formula::Group(inner) => inner,
            other => other,
        }
    }

    /// Number of letters side by side in the widest part within which a line does not end: a factor of a term.
    pub fn breadth(&self) -> usize {
        let widest = |parts: &mut dyn Iterator<Item = usize>| parts.max().unwrap_or(0);
        match self {
            Formula::Sum(terms) => widest(&mut terms.iter().map(|(_, term)| term.breadth())),
            Formula::Product(factors) => widest(&mut factors.iter().map(Formula::letters)),
            other => other.letters(),
        }
    }

    /// Number of letters side by side.
    fn letters(&self) -> usize {
        let all = |parts: &mut dyn Iterator<Item = usize>| parts.map(|letters| letters + 2).sum::<usize>();
        match self {
            Formula::Number(text) | Formula::Name(text) => text.chars().count(),
            Formula::Value(value) => value.letters(),
            Formula::Negative(inner) | Formula::Group(inner) | Formula::Absolute(inner) => {
                inner.letters() + 2
            }
            Formula::Sum(terms) => all(&mut terms.iter().map(|(_, term)| term.letters())),
            Formula::Product(factors) => all(&mut factors.iter().map(Formula::letters)),
            Formula::Fraction(above, below) => above.letters().max(below.letters()),
            Formula::Ratio(one, other) => one.letters() + other.letters() + 1,
            Formula::Power(base, exponent) => base.letters() + exponent.letters() + 2,
            Formula::Call(function, arguments) => {
                function.chars().count() + all(&mut arguments.iter().map(Formula::letters))
            }
        }
    }

    /// The formula on one line: fractions with a slash, and parentheses where a bar needed none.
    pub fn on_a_line(&self) -> Formula {
        let all = |parts: &[Formula]| parts.iter().map(Formula::on_a_line).collect::<Vec<_>>();
        let one = |part: &Formula| Box::new(part.on_a_line());
        let grouped = |part: &Formula| match part.bare().on_a_line() {
            part @ (Formula::Sum(_) | Formula::Product(_) | Formula::Ratio(..) | Formula::Negative(_)) => {
                Formula::Group(Box::new(part))
            }
            part => part,
        };
        match self {
            Formula::Fraction(above, below) | Formula::Ratio(above, below) => {
                let above = match above.bare().on_a_line() {
                    sum @ (Formula::Sum(_) | Formula::Ratio(..)) => Formula::Group(Box::new(sum)),
                    above => above,
                };
                Formula::Ratio(Box::new(above), Box::new(grouped(below)))
            }
            Formula::Product(factors) => {
                // A factor behind a slash would seem to stand below it.
                let last = factors.len() - 1;
                let factors = factors.iter().enumerate().map(|(i, factor)| match factor.on_a_line() {
                    ratio @ Formula::Ratio(..) if i < last => Formula::Group(Box::new(ratio)),
                    factor => factor,
                });
                Formula::Product(factors.collect())
            }
            Formula::Number(_) | Formula::Name(_) | Formula::Value(_) => self.clone(),
            Formula::Negative(inner) => Formula::Negative(one(inner)),
            Formula::Sum(terms) => {
                Formula::Sum(terms.iter().map(|(minus, term)| (*minus, term.on_a_line())).collect())
            }
            Formula::Power(base, exponent) => Formula::Power(one(base), one(exponent)),
            Formula::Call(function, arguments) => Formula::Call(function.clone(), all(arguments)),
            Formula::Group(inner) => Formula::Group(one(inner)),
            Formula::Absolute(inner) => Formula::Absolute(one(inner)),
        }
    }

    /// The formula with numbers in place of all names but π.
    ///
    /// # Errors
    /// The first name that stands for no number.
    pub fn with_numbers(&self, scope: &Scope) -> Result<Formula, String> {
        let one = |part: &Formula| part.with_numbers(scope).map(Box::new);
        let all =
            |parts: &[Formula]| parts.iter().map(|part| part.with_numbers(scope)).collect::<Result<_, _>>();
        Ok(match self {
            Formula::Name(name) if name == "π" => self.clone(),
            Formula::Name(name) => Formula::Value(*scope.get(name).ok_or_else(|| name.clone())?),
            Formula::Number(_) | Formula::Value(_) => self.clone(),
            Formula::Negative(inner) => Formula::Negative(one(inner)?),
            Formula::Sum(terms) => {
                let terms =
                    terms.iter().map(|(subtracted, term)| Ok((*subtracted, term.with_numbers(scope)?)));
                Formula::Sum(terms.collect::<Result<_, String>>()?)
            }
            Formula::Product(factors) => Formula::Product(all(factors)?),
            Formula::Fraction(above, below) => Formula::Fraction(one(above)?, one(below)?),
            Formula::Ratio(above, below) => Formula::Ratio(one(above)?, one(below)?),
            Formula::Power(base, exponent) => Formula::Power(one(base)?, one(exponent)?),
            Formula::Call(function, arguments) => Formula::Call(function.clone(), all(arguments)?),
            Formula::Group(inner) => Formula::Group(one(inner)?),
            Formula::Absolute(inner) => Formula::Absolute(one(inner)?),
        })
    }
}

#[derive(Debug, Clone, PartialEq)]
enum Token {
    Number(String),
    Name(String),
    Sign(char),
}

/// The tokens with the byte at which each begins; or the byte at which none does, and what could.
fn tokens(text: &str) -> Result<Vec<(usize, Token)>, (usize, &'static str)> {
    let mut tokens = Vec::new();
    let mut rest = text.trim_start();
    while let Some(first) = rest.chars().next() {
        let at = text.len() - rest.len();
        let taken = |belongs: &dyn Fn(char) -> bool| rest.find(|c| !belongs(c)).unwrap_or(rest.len());
        let (length, token) = if first.is_ascii_digit() {
            let length = taken(&|c| c.is_ascii_digit() || c == '.');
            let number = &rest[..length];
            if number.ends_with('.') || number.matches('.').count() > 1 {
                return Err((at, "a number with digits around one point at most"));
            }
            (length, Token::Number(number.to_owned()))
        } else if first.is_alphabetic() {
            let length = taken(&|c| c.is_alphanumeric() || matches!(c, '_' | '\'' | '′' | '*' | '\u{308}'));
            (length, Token::Name(rest[..length].replace('′', "'")))
        } else if matches!(first, '+' | '-' | '−' | '/' | '÷' | '^' | '(' | ')' | '|' | ',') {
            (first.len_utf8(), Token::Sign(if first == '−' { '-' } else { first }))
        } else {
            return Err((at, "a number, a name or a sign"));
        };
        tokens.push((at, token));
        rest = rest[length..].trim_start();
    }
    Ok(tokens)
}

/// A part of a formula, or what was expected of the next token.
type Read = Result<Formula, &'static str>;

struct Reader<'a> {
    tokens: &'a [(usize, Token)],
    next: usize,
    /// Number of absolute values that are open.
    bars: usize,
}

impl Reader<'_> {
    fn token(&self) -> Option<&Token> {
        self.tokens.get(self.next).map(|(_, token)| token)
    }

    fn is(&self, sign: char) -> bool {
        self.token() == Some(&Token::Sign(sign))
    }

    fn take(&mut self, sign: char) -> bool {
        let found = self.is(sign);
        self.next += usize::from(found);
        found
    }

    /// Takes a sign that has to stand here.
    fn need(&mut self, sign: char, expected: &'static str) -> Result<(), &'static str> {
        if self.take(sign) { Ok(()) } else { Err(expected) }
    }

    fn sum(&mut self) -> Read {
        let first =
            if self.take('-') { Formula::Negative(Box::new(self.product()?)) } else { self.product()? };
        let mut terms = vec![(false, first)];
        loop {
            let subtracted = self.is('-');
            if !self.take('+') && !self.take('-') {
                break;
            }
            terms.push((subtracted, self.product()?));
        }
        Ok(if terms.len() == 1 { terms.remove(0).1 } else { Formula::Sum(terms) })
    }

    fn product(&mut self) -> Read {
        let mut factors = vec![self.power()?];
        loop {
            if self.take('/') {
                let divisor = self.power()?;
                let dividend = product_of(factors);
                factors = vec![Formula::Fraction(Box::new(dividend), Box::new(divisor))];
            } else if self.take('÷') {
                let divisor = self.power()?;
                let dividend = product_of(factors);
                factors = vec![Formula::Ratio(Box::new(dividend), Box::new(divisor))];
            } else if self.begins() {
                factors.push(self.power()?);
            } else {
                return Ok(product_of(factors));
            }
        }
    }

    /// True if a factor begins here.
    fn begins(&self) -> bool {
        match self.token() {
            Some(Token::Number(_) | Token::Name(_) | Token::Sign('(')) => true,
            Some(Token::Sign('|')) => self.bars == 0,
            _ => false,
        }
    }

    fn power(&mut self) -> Read {
        let base = self.factor()?;
        if !self.take('^') {
            return Ok(base);
        }
        Ok(Formula::Power(Box::new(base), Box::new(self.factor()?)))
    }

    fn factor(&mut self) -> Read {
        const FACTOR: &str = "a number, a name, `(` or `|`";
        let token = self.token().ok_or(FACTOR)?.clone();
        if matches!(token, Token::Sign(sign) if !matches!(sign, '(' | '|')) {
            return Err(FACTOR);
        }
        self.next += 1;
        match token {
            Token::Number(number) => Ok(Formula::Number(number)),
            Token::Name(name) if FUNCTIONS.contains(&name.as_str()) => self.call(name),
            Token::Name(name) => Ok(Formula::Name(name)),
            Token::Sign('|') => {
                self.bars += 1;
                let inner = self.sum()?;
                self.bars -= 1;
                self.need('|', "`|`")?;
                Ok(Formula::Absolute(Box::new(inner)))
            }
            Token::Sign(_) => {
                let bars = std::mem::take(&mut self.bars);
                let inner = self.sum()?;
                self.bars = bars;
                self.need(')', "`)`")?;
                Ok(Formula::Group(Box::new(inner)))
            }
        }
    }

    /// Reads the arguments that follow the name of a function.
    fn call(&mut self, name: String) -> Read {
        self.need('(', "`(` behind the name of a function")?;
        let mut arguments = vec![self.sum()?];
        while self.take(',') {
            arguments.push(self.sum()?);
        }
        self.need(')', "`,` or `)`")?;
        Ok(Formula::Call(name, arguments))
    }
}

fn product_of(mut factors: Vec<Formula>) -> Formula {
    if factors.len() == 1 { factors.remove(0) } else { Formula::Product(factors) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measured::METRE;

    fn name(text: &str) -> Formula {
        Formula::Name(text.to_owned())
    }

    #[test]
    fn products_bind_from_left_to_right() {
        let number = |text: &str| Formula::Number(text.to_owned());
        let half = Formula::Fraction(Box::new(number("1")), Box::new(number("2")));
        assert_eq!(Formula::parse("1/2 a b"), Ok(Formula::Product(vec![half, name("a"), name("b")])));
        let product = Formula::Product(vec![name("a"), name("b")]);
        let expected = Formula::Fraction(Box::new(product), Box::new(name("c")));
        assert_eq!(Formula::parse("a b/c"), Ok(expected));
    }

    #[test]
    fn the_bounds_of_the_library_are_formulas() {
        let bounds = [
            "k",
            "1/(γ|1+k'|)",
            "1/γ − k k'",
            "−1/γ − k k'",
            "(a k + b)/(c k + d)",
            "(a k − b)/(d − c k)",
            "|a k + b|/(c k + d)",
            "−1/γ + k k'",
            "−(a k + b)/(c k + d)",
            "0",
            "μ_s f_y",
            "−b_1",
        ];
        for bound in bounds {
            assert!(Formula::parse(bound).is_ok(), "{bound}");
        }
        assert_eq!(Formula::parse("|f_x|"), Ok(Formula::Absolute(Box::new(name("f_x")))));
    }

    /// Each with the byte at which it goes wrong.
    #[test]
    fn what_is_no_formula_is_refused_where_it_goes_wrong() {
        for (text, at) in [
            ("", 0),
            ("a +", 3),
            ("(a", 2),
            ("|a", 2),
            ("a)", 1),
            ("cos β", 4),
            ("a = b", 2),
            ("min(a,", 6),
            ("a ^ / b", 4),
            ("γ 1.2.3", 3),
            ("2.", 0),
        ] {
            assert_eq!(Formula::parse(text).map_err(|error| error.at), Err(at), "{text}");
        }
    }

    #[test]
    fn an_error_shows_the_text_and_what_could_stand_there() {
        let error = |text: &str| Formula::parse(text).unwrap_err().to_string();
        assert_eq!(
            error("cos β"),
            "`cos β` is not a formula: expected `(` behind the name of a function at `β`"
        );
        assert_eq!(error("(a"), "`(a` is not a formula: expected `)` at its end");
    }

    #[test]
    fn numbers_stand_for_every_name_but_pi() {
        let two = Measured::of(2.0, METRE);
        let scope = Scope::from([("a".to_owned(), two)]);
        let formula = Formula::parse("π a^2/cos(|a| − (a + 1÷a))").unwrap();
        let drawn = format!("{:?}", formula.with_numbers(&scope).unwrap());
        assert_eq!((drawn.matches("Value(").count(), drawn.matches("Name(").count()), (4, 1));
        for missing in ["b", "−b", "a + b", "a b", "a/b", "a÷b", "a^b", "min(a, b)", "(b)", "|b|"] {
            let formula = Formula::parse(missing).unwrap();
            assert_eq!(formula.with_numbers(&scope), Err("b".to_owned()), "{missing}");
        }
    }
}
