//! Formulas as they are written on a line, `(p1 + p4) h_c* / 2`, read into a tree that is then drawn twice: in symbols and with
//! numbers put in. So a formula and its numbers cannot disagree.
//!
//! | written | means |
//! |---|---|
//! | `a b`, `a/b`, `a b/c d` | product, fraction; from left to right: (a b)/c times d |
//! | `a÷b` | the same, drawn on one line with a slash |
//! | `x^2`, `(a + b)`, `\|x\|` | power, group, absolute value |
//! | `cos(x)`, `min(a, b)`, `sqrt(x)` | functions: cos, sinh, cosh, tanh, exp, min, max, sqrt |
//! | `p_u`, `k'_eff`, `α*`, `λ1` | names with subscripts, primes and stars |

/// A formula.
#[derive(Debug, Clone, PartialEq)]
pub enum Formula {
    /// A number as written.
    Number(String),
    /// A quantity, or π.
    Name(String),
    /// What follows a minus sign.
    Negative(Box<Formula>),
    /// Terms, each with whether it is subtracted.
    Sum(Vec<(bool, Formula)>),
    /// Factors.
    Product(Vec<Formula>),
    /// Numerator and denominator.
    Fraction(Box<Formula>, Box<Formula>),
    /// The same on one line, with a slash.
    Ratio(Box<Formula>, Box<Formula>),
    /// Base and exponent.
    Power(Box<Formula>, Box<Formula>),
    /// A function and its arguments.
    Call(String, Vec<Formula>),
    /// What stands in parentheses.
    Group(Box<Formula>),
    /// An absolute value.
    Absolute(Box<Formula>),
}

const FUNCTIONS: [&str; 8] = ["cos", "sinh", "cosh", "tanh", "exp", "min", "max", "sqrt"];

impl Formula {
    /// Reads a formula; `None` if it is not one.
    pub fn parse(text: &str) -> Option<Formula> {
        let tokens = tokens(text)?;
        let mut reader = Reader { tokens: &tokens, next: 0, bars: 0 };
        let formula = reader.sum()?;
        (reader.next == tokens.len()).then_some(formula)
    }

    /// The formula without the parentheses around all of it, where a fraction bar or a root makes them idle.
    pub fn bare(&self) -> &Formula {
        match self {
            Formula::Group(inner) => inner,
            other => other,
        }
    }
}

#[derive(Debug, Clone, PartialEq)]
enum Token {
    Number(String),
    Name(String),
    Sign(char),
}

fn tokens(text: &str) -> Option<Vec<Token>> {
    let mut tokens = Vec::new();
    let mut rest = text.trim_start();
    while let Some(first) = rest.chars().next() {
        let taken = |belongs: &dyn Fn(char) -> bool| rest.find(|c| !belongs(c)).unwrap_or(rest.len());
        let length = if first.is_ascii_digit() {
            let length = taken(&|c| c.is_ascii_digit() || c == '.');
            tokens.push(Token::Number(rest[..length].to_owned()));
            length
        } else if first.is_alphabetic() {
            let length = taken(&|c| c.is_alphanumeric() || matches!(c, '_' | '\'' | '*' | '\u{308}'));
            tokens.push(Token::Name(rest[..length].to_owned()));
            length
        } else if matches!(first, '+' | '-' | '−' | '/' | '÷' | '^' | '(' | ')' | '|' | ',') {
            tokens.push(Token::Sign(if first == '−' { '-' } else { first }));
            first.len_utf8()
        } else {
            return None;
        };
        rest = rest[length..].trim_start();
    }
    Some(tokens)
}

struct Reader<'a> {
    tokens: &'a [Token],
    next: usize,
    /// How many absolute values are open.
    bars: usize,
}

impl Reader<'_> {
    fn is(&self, sign: char) -> bool {
        self.tokens.get(self.next) == Some(&Token::Sign(sign))
    }

    fn take(&mut self, sign: char) -> bool {
        let found = self.is(sign);
        self.next += usize::from(found);
        found
    }

    fn sum(&mut self) -> Option<Formula> {
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
        Some(if terms.len() == 1 { terms.remove(0).1 } else { Formula::Sum(terms) })
    }

    fn product(&mut self) -> Option<Formula> {
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
                return Some(product_of(factors));
            }
        }
    }

    /// Whether a factor begins here.
    fn begins(&self) -> bool {
        match self.tokens.get(self.next) {
            Some(Token::Number(_) | Token::Name(_) | Token::Sign('(')) => true,
            Some(Token::Sign('|')) => self.bars == 0,
            _ => false,
        }
    }

    fn power(&mut self) -> Option<Formula> {
        let base = self.factor()?;
        if !self.take('^') {
            return Some(base);
        }
        Some(Formula::Power(Box::new(base), Box::new(self.factor()?)))
    }

    fn factor(&mut self) -> Option<Formula> {
        let token = self.tokens.get(self.next)?.clone();
        self.next += 1;
        match token {
            Token::Number(number) => Some(Formula::Number(number)),
            Token::Name(name) if FUNCTIONS.contains(&name.as_str()) => {
                self.take('(').then_some(())?;
                let mut arguments = vec![self.sum()?];
                while self.take(',') {
                    arguments.push(self.sum()?);
                }
                self.take(')').then_some(Formula::Call(name, arguments))
            }
            Token::Name(name) => Some(Formula::Name(name)),
            Token::Sign('(') => {
                let bars = std::mem::take(&mut self.bars);
                let inner = self.sum()?;
                self.bars = bars;
                self.take(')').then_some(Formula::Group(Box::new(inner)))
            }
            Token::Sign('|') => {
                self.bars += 1;
                let inner = self.sum()?;
                self.bars -= 1;
                self.take('|').then_some(Formula::Absolute(Box::new(inner)))
            }
            Token::Sign(_) => None,
        }
    }
}

fn product_of(mut factors: Vec<Formula>) -> Formula {
    if factors.len() == 1 { factors.remove(0) } else { Formula::Product(factors) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn name(text: &str) -> Formula {
        Formula::Name(text.to_owned())
    }

    #[test]
    fn products_bind_from_left_to_right() {
        let number = |text: &str| Formula::Number(text.to_owned());
        let half = Formula::Fraction(Box::new(number("1")), Box::new(number("2")));
        assert_eq!(Formula::parse("1/2 a b"), Some(Formula::Product(vec![half, name("a"), name("b")])));
        let product = Formula::Product(vec![name("a"), name("b")]);
        let expected = Formula::Fraction(Box::new(product), Box::new(name("c")));
        assert_eq!(Formula::parse("a b/c"), Some(expected));
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
            assert!(Formula::parse(bound).is_some(), "{bound}");
        }
        assert_eq!(Formula::parse("|f_x|"), Some(Formula::Absolute(Box::new(name("f_x")))));
    }

    #[test]
    fn what_is_no_formula_is_refused() {
        for text in ["", "a +", "(a", "|a", "a)", "cos β", "a = b", "min(a,"] {
            assert_eq!(Formula::parse(text), None, "{text}");
        }
    }
}
