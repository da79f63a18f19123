//! Formulas drawn in MathML: in symbols, or with numbers put in.
//!
//! A long line is cut into several `math` elements, each of which may begin a new line, because browsers do not break one.

use maud::{Markup, PreEscaped, html};

use crate::fault::SheetFault;
use crate::formula::Formula;
use crate::measured::NONE;

/// Content of a formula, symbols or numbers, which says how a product is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FormulaContent {
    /// Symbols: the sign between factors is seen only where a digit follows.
    Symbols,
    /// Numbers with their units: it is seen everywhere.
    Numbers,
}

/// A formula in `math` elements, the first of which begins with `lead`, e.g. an equals sign.
pub fn line(formula: &Formula, lead: &str, drawn: FormulaContent) -> String {
    let lead =
        if lead.is_empty() { String::new() } else { format!("<mo form=\"infix\">{}</mo>", escape(lead)) };
    let math = |chunks: Vec<String>| {
        let each = chunks
            .into_iter()
            .map(|chunk| format!("<math displaystyle=\"true\"><mrow>{chunk}</mrow></math>"));
        each.collect::<Vec<_>>().join("<wbr>")
    };
    let Formula::Sum(terms) = formula else {
        let mut chunks = vec![lead];
        term_chunks(formula, drawn, true, &mut chunks);
        return math(chunks);
    };
    // A line ends between terms before it ends within one.
    let terms = terms.iter().enumerate().map(|(i, (subtracted, term))| {
        let sign = if *subtracted { "−" } else { "+" };
        let mut chunks = vec![if i == 0 { lead.clone() } else { operator(sign) }];
        term_chunks(term, drawn, i == 0, &mut chunks);
        match chunks.len() {
            1 => math(chunks),
            _ => format!("<span class=\"term\">{}</span>", math(chunks)),
        }
    });
    terms.collect::<Vec<_>>().join("<wbr>")
}

/// Adds a term to the last chunk. A product of numbers continues in a further chunk with each factor; one of symbols where a
/// factor is more than a symbol.
fn term_chunks(term: &Formula, drawn: FormulaContent, first: bool, chunks: &mut Vec<String>) {
    let Formula::Product(factors) = term else {
        return add(chunks, &draw(term, drawn, first));
    };
    let plain = |factor: &Formula| matches!(factor, Formula::Name(_) | Formula::Number(_));
    for (i, factor) in factors.iter().enumerate() {
        let text = factor_of(factor, drawn);
        if i == 0 {
            add(chunks, &text);
        } else if drawn == FormulaContent::Symbols && plain(factor) && plain(&factors[i - 1]) {
            add(chunks, &(times(&text, drawn) + &text));
        } else {
            chunks.push(times(&text, drawn) + &text);
        }
    }
}

fn add(chunks: &mut [String], text: &str) {
    if let Some(last) = chunks.last_mut() {
        last.push_str(text);
    }
}

const INVISIBLE_TIMES: &str = "<mo>\u{2062}</mo>";

/// The sign between a product's factors, of which `right` is the right one as drawn. In front of a symbol it is not seen; in
/// front of a digit it is, or 14·1.2 would read 141.2.
fn times(right: &str, drawn: FormulaContent) -> String {
    // The first character outside of tags.
    let first = right.split('>').find_map(|part| part.chars().next().filter(|c| *c != '<'));
    match drawn {
        FormulaContent::Symbols if !first.is_some_and(|first| first.is_ascii_digit()) => {
            INVISIBLE_TIMES.to_owned()
        }
        FormulaContent::Symbols | FormulaContent::Numbers => operator("⋅"),
    }
}

/// A sign between two operands.
pub fn operator(sign: &str) -> String {
    format!("<mo form=\"infix\">{sign}</mo>")
}

/// A formula as the content of an `mrow`. `first` says whether a negative number needs no parentheses.
pub fn draw(formula: &Formula, drawn: FormulaContent, first: bool) -> String {
    match formula {
        Formula::Number(number) => format!("<mn>{number}</mn>"),
        Formula::Name(text) => name(text),
        Formula::Value(quantity) => quantity.mathml(first),
        Formula::Negative(inner) => format!("<mo form=\"prefix\">−</mo>{}", factor_of(inner, drawn)),
        Formula::Sum(terms) => {
            let mut text = String::new();
            for (i, (subtracted, term)) in terms.iter().enumerate() {
                if i > 0 {
                    text += &operator(if *subtracted { "−" } else { "+" });
                }
                text += &draw(term, drawn, i == 0 && first);
            }
            text
        }
        Formula::Product(factors) => {
            let mut text = String::new();
            for (i, factor) in factors.iter().enumerate() {
                let factor = factor_of(factor, drawn);
                if i > 0 {
                    text += &times(&factor, drawn);
                }
                text += &factor;
            }
            text
        }
        Formula::Fraction(above, below) => {
            let [above, below] = [above, below].map(|part| row(&draw(part.bare(), drawn, true)));
            format!("<mfrac>{above}{below}</mfrac>")
        }
        Formula::Ratio(above, below) => {
            format!(
                "{}<mo form=\"infix\" lspace=\"0\" rspace=\"0\">/</mo>{}",
                draw(above, drawn, false),
                factor_of(below, drawn)
            )
        }
        Formula::Power(base, exponent) => power(base, exponent, drawn),
        Formula::Call(function, arguments) => call(function, arguments, drawn),
        Formula::Group(inner) => fenced("(", &draw(inner, drawn, true), ")"),
        Formula::Absolute(inner) => fenced("|", &draw(inner, drawn, true), "|"),
    }
}

fn power(base: &Formula, exponent: &Formula, drawn: FormulaContent) -> String {
    let needs_parentheses = match base {
        Formula::Value(quantity) => quantity.value < 0.0 || quantity.unit != NONE,
        Formula::Call(..) => true,
        _ => false,
    };
    let base = match needs_parentheses {
        true => fenced("(", &draw(base, drawn, true), ")"),
        false => row(&draw(base, drawn, false)),
    };
    format!("<msup>{base}{}</msup>", row(&draw(exponent.bare(), drawn, true)))
}

fn call(function: &str, arguments: &[Formula], drawn: FormulaContent) -> String {
    let arguments: Vec<_> = arguments.iter().map(|argument| row(&draw(argument, drawn, true))).collect();
    match function {
        "sqrt" => format!("<msqrt>{}</msqrt>", arguments.concat()),
        "min" | "max" => {
            let list = arguments.join("<mo separator=\"true\">,</mo>");
            format!("<mi>{function}</mi>{}", fenced("{", &list, "}"))
        }
        _ => format!("<mi>{function}</mi><mo>\u{2061}</mo>{}", fenced("(", &arguments.concat(), ")")),
    }
}

/// A factor of a product or what follows a minus sign.
fn factor_of(formula: &Formula, drawn: FormulaContent) -> String {
    match formula {
        Formula::Sum(_) | Formula::Negative(_) => fenced("(", &draw(formula, drawn, true), ")"),
        _ => draw(formula, drawn, false),
    }
}

fn row(content: &str) -> String {
    format!("<mrow>{content}</mrow>")
}

fn fenced(open: &str, content: &str, close: &str) -> String {
    format!("<mrow><mo form=\"prefix\">{open}</mo>{content}<mo form=\"postfix\">{close}</mo></mrow>")
}

/// A symbol with its subscript, primes and stars. A prime behind a lettered subscript belongs to that letter, as in that of
/// the corner O′.
pub fn name(text: &str) -> String {
    let (base, mut subscript) = text.split_once('_').unwrap_or((text, ""));
    // A derivative in time: x_ddot, θ_dot_0.
    let (derivative, behind) = subscript.split_once('_').unwrap_or((subscript, ""));
    let accent = match derivative {
        "dot" => "˙",
        "ddot" => "¨",
        _ => "",
    };
    if !accent.is_empty() {
        subscript = behind;
    }
    let stem = base.trim_end_matches(['\'', '*']);
    let mut marks = base[stem.len()..].to_owned();
    let mut letters = stem;
    if subscript.is_empty() {
        letters = stem.trim_end_matches(|c: char| c.is_ascii_digit());
        subscript = &stem[letters.len()..];
    }
    let bare = subscript.trim_end_matches(['\'', '*']);
    let mut inner = "";
    if bare.len() < subscript.len() {
        if subscript.ends_with('*') || bare.starts_with(|c: char| c.is_ascii_digit()) {
            marks += &subscript[bare.len()..];
        } else {
            inner = "′";
        }
    }
    let letter = match letters {
        "ẍ" => over("x", "¨"),
        "ÿ" => over("y", "¨"),
        "θ\u{308}" => over("θ", "¨"),
        letters if !accent.is_empty() => over(&escape(letters), accent),
        // Several letters stand upright.
        letters => format!("<mi>{}</mi>", escape(letters)),
    };
    // A prime is drawn raised, so it is no superscript.
    let letter = match marks.matches('\'').count() {
        0 => letter,
        count => row(&format!("{letter}{}", PRIME.repeat(count))),
    };
    let below = match bare {
        // The mean of the highest third of the waves.
        "13" => "<mrow><mn>1</mn><mo>/</mo><mn>3</mn></mrow>".to_owned(),
        digits if digits.starts_with(|c: char| c.is_ascii_digit()) => format!("<mn>{digits}</mn>"),
        letters if inner.is_empty() => format!("<mi>{}</mi>", escape(letters)),
        letters => row(&format!("<mi>{}</mi>{PRIME}", escape(letters))),
    };
    let stars = format!("<mo>{}</mo>", "∗".repeat(marks.matches('*').count()));
    match (bare.is_empty(), marks.contains('*')) {
        (true, false) => letter,
        (false, false) => format!("<msub>{letter}{below}</msub>"),
        (true, true) => format!("<msup>{letter}{stars}</msup>"),
        (false, true) => format!("<msubsup>{letter}{below}{stars}</msubsup>"),
    }
}

const PRIME: &str = "<mo lspace=\"0\" rspace=\"0\">′</mo>";

fn over(letter: &str, accent: &str) -> String {
    format!("<mover accent=\"true\"><mi>{letter}</mi><mo stretchy=\"false\">{accent}</mo></mover>")
}

/// A symbol on its own, in a line of text.
pub fn symbol(text: &str) -> String {
    format!("<math>{}</math>", name(text))
}

/// A sentence in which formulas stand between backticks.
pub fn prose(text: &str) -> Result<Markup, SheetFault> {
    let mut parts = text.split('`');
    let mut sentence = html! { (parts.next().unwrap_or_default()) }.into_string();
    while let Some(inner) = parts.next() {
        let Some(behind) = parts.next() else { return Err(SheetFault::Unpaired { text: text.to_owned() }) };
        let formula = Formula::parse(inner)
            .map_err(|source| SheetFault::Formula { place: format!("the sentence “{text}”"), source })?;
        sentence += &format!("<math><mrow>{}</mrow></math>", draw(&formula, FormulaContent::Symbols, true));
        sentence += &html! { (behind) }.into_string();
    }
    Ok(PreEscaped(sentence))
}

/// A text as the content of an element.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The formula in symbols without tags, an invisible sign as `~`.
    fn read(formula: &Formula) -> [String; 2] {
        let bare = |drawn: &str| {
            let text: String =
                drawn.split('<').filter_map(|part| part.split_once('>')).map(|(_, text)| text).collect();
            text.replace('\u{2062}', "~")
        };
        [
            bare(&draw(formula, FormulaContent::Symbols, true)),
            bare(&line(formula, "", FormulaContent::Symbols)),
        ]
    }

    #[test]
    fn the_sign_in_front_of_a_digit_is_seen() {
        for (formula, expected) in [
            ("14 1.2/π^3 ρ", "14⋅1.2π3~ρ"),
            ("7 π 1.2", "7~π⋅1.2"),
            ("a 2^3 b", "a⋅23~b"),
            ("a1 2÷3", "a1⋅2/3"),
            ("2 (a + 1)", "2~(a+1)"),
            ("1/2 (2 + a)", "12~(2+a)"),
            ("2/3 U_w B_c", "23~Uw~Bc"),
            ("0.6 cos(2 a) |2|", "0.6~cos\u{2061}(2~a)~|2|"),
        ] {
            let formula = Formula::parse(formula).unwrap();
            assert_eq!(read(&formula), [expected, expected]);
        }
        // A fraction is never the right factor of a formula that is read, but it could be built.
        let half = Formula::parse("(2 a)/b").unwrap();
        let product = Formula::Product(vec![Formula::Name("c".to_owned()), half]);
        assert_eq!(read(&product), ["c⋅2~ab", "c⋅2~ab"]);
    }

    #[test]
    fn sentences_keep_their_words_around_formulas() {
        let drawn = prose("for `a` < \"b\" & `c`").unwrap().into_string();
        let [a, c] = ["a", "c"].map(|name| format!("<math><mrow><mi>{name}</mi></mrow></math>"));
        assert_eq!(drawn, format!("for {a} &lt; &quot;b&quot; &amp; {c}"));
    }
}
