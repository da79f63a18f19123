//! The steps of a calculation: a formula, the same with numbers put in, and the result, which is the library's.

use maud::{Markup, PreEscaped, html};
use standfast::initiation::Relation;

use crate::formula::Formula;
use crate::mathml::{Drawn, Scope, line, prose, symbol};
use crate::quantity::{NONE, Quantity, Unit, number};

/// Steps written so far, and the quantities that later ones may use.
#[derive(Default)]
pub struct Steps {
    scope: Scope,
    html: Vec<Markup>,
    /// The reference of the last step: one without words of its own belongs to it.
    reference: String,
}

/// A step: what is computed, and from what.
pub struct Step<'a> {
    /// In words.
    pub about: &'a str,
    /// Where the formula comes from: an equation number, or an author.
    pub reference: &'a str,
    /// What the result is called in later formulas.
    pub name: &'a str,
    /// The formula.
    pub formula: &'a str,
    /// The result, from the library.
    pub result: Quantity,
    /// What the program's JSON calls the result; empty if it does not.
    pub key: &'a str,
}

impl Steps {
    /// A quantity that later formulas may use.
    pub fn know(&mut self, name: &str, si: f64, unit: Unit) {
        self.scope.insert(name.to_owned(), Quantity::of(si, unit));
    }

    /// Forgets no quantity, but begins a new list of steps; gives the one written so far.
    pub fn cut(&mut self) -> Markup {
        let steps = std::mem::take(&mut self.html);
        html! { @for step in steps { (step) } }
    }

    /// Writes a step.
    pub fn step(&mut self, step: &Step<'_>) {
        let Step { about, reference, name, formula, result, key } = *step;
        let Some(formula) = Formula::parse(formula) else {
            debug_assert!(false, "{formula} is no formula");
            return;
        };
        let shown = if about.is_empty() && reference == self.reference { "" } else { reference };
        reference.clone_into(&mut self.reference);
        let symbols = line(&formula, "=", Drawn::Symbols);
        let numbers = line(&formula, "=", Drawn::Numbers(&self.scope));
        self.html.push(html! {
            div.step {
                (head(about, shown))
                div.lines {
                    span.left { (PreEscaped(symbol(name))) }
                    div.right {
                        span.symbols { (PreEscaped(symbols)) }
                        " "
                        span.numbers data-step=(name) { (PreEscaped(numbers)) }
                    }
                }
                p.result { "= " (result.html(key)) }
            }
        });
        self.scope.insert(name.to_owned(), result);
    }

    /// Writes the commonest kind of step.
    pub fn add(
        &mut self,
        about: &str,
        reference: &str,
        [name, formula]: [&str; 2],
        si: f64,
        unit: Unit,
        key: &str,
    ) {
        self.step(&Step { about, reference, name, formula, result: Quantity::of(si, unit), key });
    }

    /// Writes a result that no formula on a line gives, with words in place of it.
    pub fn told(&mut self, about: &str, name: &str, si: f64, unit: Unit, words: &str, key: &str) {
        let result = Quantity::of(si, unit);
        self.html.push(html! {
            div.step {
                (head(about, ""))
                div.lines {
                    span.left { (PreEscaped(symbol(name))) }
                    span.right { (words) }
                }
                p.result { "= " (result.html(key)) }
            }
        });
        self.scope.insert(name.to_owned(), result);
    }

    /// Writes an inequality: in symbols, with numbers put in, and both sides as they come out.
    pub fn relation(&mut self, relation: &Relation) {
        let Relation { equation, quantity, left, sign, bound, right, holds } = *relation;
        let (Some(from), Some(to)) = (Formula::parse(quantity), Formula::parse(bound)) else {
            debug_assert!(false, "{bound} is no formula");
            return;
        };
        let sign = sign.to_string();
        let one_number = matches!(to, Formula::Number(_));
        self.html.push(html! {
            div.step.relation {
                (head("", equation))
                div.lines {
                    span.left { (PreEscaped(line(&from, "", Drawn::Symbols))) }
                    div.right {
                        span.symbols { (PreEscaped(line(&to, &sign, Drawn::Symbols))) }
                        @if !one_number {
                            " "
                            span.numbers data-step=(bound) { (PreEscaped(line(&to, "=", Drawn::Numbers(&self.scope)))) }
                        }
                    }
                    span.left { data value=(left) data-side="left" { (number(left)) } }
                    div.right { (PreEscaped(line_sign(&sign))) " " data value=(right) data-side="right" { (number(right)) } }
                }
                p.result {
                    @if holds { span.yes { "holds" } } @else { span.no { "fails" } }
                    " by " (Quantity::of(relation.margin().abs(), NONE).html("margin"))
                }
            }
        });
    }

    /// Writes a sentence.
    pub fn note(&mut self, text: &str) {
        self.html.push(html! { p.note { (prose(text)) } });
    }

    /// Writes a heading.
    pub fn heading(&mut self, text: &str) {
        self.html.push(html! { h3 { (text) } });
    }

    /// Writes anything else.
    pub fn push(&mut self, markup: Markup) {
        self.html.push(markup);
    }
}

/// A sign as the lines around it show it.
fn line_sign(sign: &str) -> String {
    format!("<math><mo form=\"infix\">{}</mo></math>", sign.replace('<', "&lt;").replace('>', "&gt;"))
}

/// What a step is about, and where its formula comes from.
fn head(about: &str, reference: &str) -> Markup {
    html! {
        p.about {
            (prose(about))
            @if !reference.is_empty() {
                @if !about.is_empty() { " " }
                span.reference { "(" (reference) ")" }
            }
        }
    }
}
