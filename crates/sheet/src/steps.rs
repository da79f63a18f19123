//! The steps of a calculation: a formula, the same with numbers put in, and the result, which is the library's.

use maud::{Markup, PreEscaped, html};
use standfast::relation::Relation;
use standfast_cases::OutputUnits;

use crate::fault::SheetFault;
use crate::formula::{Formula, FormulaError, Scope};
use crate::mathml::{FormulaContent, line, prose, symbol};
use crate::measured::{Measured, NONE, SheetUnit, sides};
use crate::together::{self, Brief, Column, Item, Row};

/// The calculation as far as it is written, and the quantities that later steps may use.
///
/// Faults leave no gap: the first is kept, and [`finish`](SheetSteps::finish), the only way to what is written, gives it
/// instead.
pub struct SheetSteps {
    output: OutputUnits,
    scope: Scope,
    done: Vec<Part>,
    part: Part,
    /// The reference of the last step: one without words of its own belongs to it.
    reference: String,
    /// Subject of the steps: what the last one with words of its own is about.
    subject: String,
    fault: Option<SheetFault>,
}

/// Number of letters of a formula that has no room beside the words on its subject, on paper.
const WIDE: usize = 50;

/// A part of the calculation under a title; `load` says of which load, counted from 0.
struct Part {
    title: String,
    load: Option<usize>,
    items: Vec<Item>,
}

impl Part {
    fn of(title: &str, load: Option<usize>) -> Part {
        Part { title: title.to_owned(), load, items: Vec::new() }
    }

    fn html(&self) -> Markup {
        html! {
            section.part data-load=[self.load] {
                h3.part { (self.title) }
                @for item in &self.items { (item.full) }
            }
        }
    }
}

/// A step: what is computed, and from what.
pub struct SheetStep<'a> {
    /// In words.
    pub about: &'a str,
    /// Source of the formula: an equation number, or an author.
    pub reference: &'a str,
    /// Name of the result in later formulas.
    pub name: &'a str,
    /// The formula.
    pub formula: &'a str,
    /// The result, from the library.
    pub result: Measured,
    /// Key of the result in the program's JSON; empty if it has none.
    pub key: &'a str,
}

impl SheetSteps {
    /// No steps yet of a case that is written so, in a part of this title.
    pub fn new(title: &str, output: OutputUnits) -> SheetSteps {
        SheetSteps {
            output,
            scope: Scope::new(),
            done: Vec::new(),
            part: Part::of(title, None),
            reference: String::new(),
            subject: String::new(),
            fault: None,
        }
    }

    /// What later formulas may use by now.
    pub fn known(&self) -> Scope {
        self.scope.clone()
    }

    /// Steps in the same units that know as much, to be thrown away.
    pub fn scratch(&self) -> SheetSteps {
        SheetSteps { scope: self.scope.clone(), ..SheetSteps::new("", self.output) }
    }

    /// A quantity that is known already, told again where another situation has another under its name.
    pub fn know_again(&mut self, name: &str) {
        if let Some(known) = self.scope.get(name).copied() {
            let row = self.row(name, "known", html! {}, html! { (PreEscaped(symbol(name))) }, known, "");
            self.part.items.push(Item { full: html! {}, brief: Brief::Known(row, known.value) });
        }
    }

    /// Forgets what has become known since, as another situation has other quantities under the same names.
    pub fn forget_since(&mut self, known: &Scope) {
        self.scope.clone_from(known);
    }

    /// Writes what is of a joint alone, whose symbols are those of what is above it: what becomes known is forgotten again.
    pub fn of_joint(&mut self, joint: usize, write: impl FnOnce(&mut SheetSteps)) {
        let (known, start) = (self.known(), self.part.items.len());
        write(self);
        self.forget_since(&known);
        let own = &mut self.part.items[start..];
        let all: Vec<Markup> =
            own.iter_mut().map(|item| std::mem::replace(&mut item.full, html! {})).collect();
        if let Some(first) = own.first_mut() {
            first.full = html! { div data-joint=(joint) { @for full in &all { (full) } } };
        }
    }

    /// Begins the next part. Quantities stay known.
    pub fn part(&mut self, title: &str, load: Option<usize>) {
        let part = std::mem::replace(&mut self.part, Part::of(title, load));
        self.done.push(part);
        self.subject.clear();
    }

    /// Everything that was asked for; the situations in `others` together in a table, which is called `title`.
    ///
    /// # Errors
    /// If any of it could not be drawn.
    pub fn finish(mut self, others: &[Column], title: &str) -> Result<Markup, SheetFault> {
        if let Some(fault) = self.fault {
            return Err(fault);
        }
        self.done.push(self.part);
        let is_other = |part: &Part| part.load.is_some_and(|load| others.iter().any(|one| one.index == load));
        let (apart, one_by_one): (Vec<_>, Vec<_>) = self.done.into_iter().partition(is_other);
        let last = one_by_one.iter().rposition(|part| part.load.is_some());
        let full: Vec<_> = one_by_one.iter().filter(|part| part.load.is_some()).collect();
        let model: Vec<_> = full.iter().map(|part| part.title.as_str()).collect();
        let full: Vec<_> = full.iter().map(|part| part.items.as_slice()).collect();
        let apart: Vec<_> = apart.iter().map(|part| part.items.as_slice()).collect();
        Ok(html! {
            @for (i, part) in one_by_one.iter().enumerate() {
                (part.html())
                @if Some(i) == last && !apart.is_empty() {
                    section.part {
                        h3.part { (title) }
                        (together::table(&full, &apart, others, &model.join("; ")))
                    }
                }
            }
        })
    }

    /// A value of the case, SI, in the unit it is shown in.
    pub fn measured(&self, si: f64, unit: SheetUnit) -> Measured {
        Measured::of(si, unit).in_output(self.output)
    }

    /// A quantity that later formulas may use, and that stands among the inputs under its symbol.
    pub fn know_input(&mut self, name: &str, si: f64, unit: SheetUnit) {
        let known = self.measured(si, unit);
        self.scope.insert(name.to_owned(), known);
    }

    /// A quantity that later formulas may use.
    pub fn know(&mut self, name: &str, si: f64, unit: SheetUnit) {
        let known = self.measured(si, unit);
        self.scope.insert(name.to_owned(), known);
        self.know_again(name);
    }

    /// Quantities that later formulas may use.
    pub fn know_all<const N: usize>(&mut self, all: [(&str, f64, SheetUnit); N]) {
        for (name, si, unit) in all {
            self.know(name, si, unit);
        }
    }

    /// Begins the steps of a subject, before the first of them.
    pub fn subject(&mut self, about: &str) {
        about.clone_into(&mut self.subject);
    }

    /// The row of a quantity under the present subject; `how` tells it from others of the same name.
    fn row(&self, name: &str, how: &str, about: Markup, head: Markup, value: Measured, key: &str) -> Row {
        let met = [": met", ": not met"].iter().find_map(|end| self.subject.strip_suffix(end));
        Row {
            name: name.to_owned(),
            key: [met.unwrap_or(&self.subject), name, how].join("\n"),
            about,
            head,
            unit: value.unit_html(),
            cell: value.number_html(key),
        }
    }

    /// Writes what could be drawn, or keeps why it could not.
    fn write(&mut self, drawn: Result<Item, SheetFault>) {
        match drawn {
            Ok(item) => self.part.items.push(item),
            Err(fault) => {
                self.fault.get_or_insert(fault);
            }
        }
    }

    /// Writes a step.
    pub fn step(&mut self, step: &SheetStep<'_>) {
        if !step.about.is_empty() {
            self.subject(step.about);
        }
        let drawn = self.draw(step);
        self.write(drawn);
        step.reference.clone_into(&mut self.reference);
        self.scope.insert(step.name.to_owned(), step.result.in_output(self.output));
    }

    fn draw(&self, step: &SheetStep<'_>) -> Result<Item, SheetFault> {
        let SheetStep { about, reference, name, formula, result, key } = *step;
        let result = result.in_output(self.output);
        let place = format!("the step for `{name}`");
        let shown = if about.is_empty() && reference == self.reference { "" } else { reference };
        let symbols = read(&place, formula)?;
        let numbers = self.numbers(&place, formula, &symbols)?;
        let short = html! {
            (PreEscaped(symbol(name))) " " (PreEscaped(line(&symbols.on_a_line(), "=", FormulaContent::Symbols)))
        };
        let row = self.row(name, formula, prose(about)?, short, result, key);
        let full = html! {
            div.step.wide[numbers.breadth() > WIDE] data-symbol=(name) {
                (head(about, shown)?)
                div.lines {
                    span.left { (PreEscaped(symbol(name))) }
                    div.right {
                        span.symbols { (PreEscaped(line(&symbols, "=", FormulaContent::Symbols))) }
                        " "
                        span.numbers data-step=(name) { (PreEscaped(line(&numbers, "=", FormulaContent::Numbers))) }
                    }
                }
                p.result { "= " (result.html(key)) }
            }
        };
        Ok(Item { full, brief: Brief::Rows(vec![row]) })
    }

    /// The formula, written as `text`, with numbers put in.
    fn numbers(&self, place: &str, text: &str, formula: &Formula) -> Result<Formula, SheetFault> {
        let no_number =
            |name| SheetFault::NoNumber { place: place.to_owned(), formula: text.to_owned(), name };
        formula.with_numbers(&self.scope).map_err(no_number)
    }

    /// Writes the commonest kind of step.
    pub fn add(
        &mut self,
        about: &str,
        reference: &str,
        [name, formula]: [&str; 2],
        si: f64,
        unit: SheetUnit,
        key: &str,
    ) {
        let result = self.measured(si, unit);
        self.step(&SheetStep { about, reference, name, formula, result, key });
    }

    /// Writes a result that no formula on a line gives, with words in place of it.
    pub fn told(&mut self, about: &str, name: &str, si: f64, unit: SheetUnit, words: &str, key: &str) {
        if !about.is_empty() {
            self.subject(about);
        }
        let result = self.measured(si, unit);
        let drawn = head(about, "").and_then(|head| {
            let full = html! {
                div.step data-symbol=(name) {
                    (head)
                    div.lines {
                        span.left { (PreEscaped(symbol(name))) }
                        span.right { (words) }
                    }
                    p.result { "= " (result.html(key)) }
                }
            };
            let short = html! { (PreEscaped(symbol(name))) ": " (words) };
            let row = self.row(name, words, prose(about)?, short, result, key);
            Ok(Item { full, brief: Brief::Rows(vec![row]) })
        });
        self.write(drawn);
        self.scope.insert(name.to_owned(), result);
    }

    /// Writes an inequality: in symbols, with numbers put in, and both sides as they come out.
    pub fn relation(&mut self, relation: &Relation) {
        let drawn = self.draw_relation(relation);
        self.write(drawn);
    }

    fn draw_relation(&self, relation: &Relation) -> Result<Item, SheetFault> {
        let Relation { equation, quantity, left, sign, bound, right, holds } = *relation;
        let place = format!("the inequality ({equation})");
        let (from, to) = (read(&place, quantity)?, read(&place, bound)?);
        let numbers = self.numbers(&place, bound, &to)?;
        let sign = sign.to_string();
        let one_number = matches!(to, Formula::Number(_));
        let [shown_left, shown_right] = sides(left, right);
        let margin = Measured::of(relation.margin().abs(), NONE);
        let row = Row {
            name: String::new(),
            key: [&self.subject, equation, quantity, &sign, bound].join("\n"),
            about: html! { "(" (equation) ")" },
            head: html! {
                (PreEscaped(line(&from, "", FormulaContent::Symbols))) " "
                (PreEscaped(line(&to.on_a_line(), &sign, FormulaContent::Symbols)))
            },
            unit: html! {},
            cell: html! {
                data value=(left) data-side="left" { (shown_left) } " " (PreEscaped(line_sign(&sign))) " "
                data value=(right) data-side="right" { (shown_right) } br;
                @if holds { span.yes { "holds" } } @else { span.no { "fails" } } " by " (margin.html("margin"))
            },
        };
        let full = html! {
            div.step.relation {
                (head("", equation)?)
                div.lines {
                    span.left { (PreEscaped(line(&from, "", FormulaContent::Symbols))) }
                    div.right {
                        span.symbols { (PreEscaped(line(&to, &sign, FormulaContent::Symbols))) }
                        @if !one_number {
                            " "
                            span.numbers data-step=(bound) { (PreEscaped(line(&numbers, "=", FormulaContent::Numbers))) }
                        }
                    }
                    span.left { data value=(left) data-side="left" { (shown_left) } }
                    div.right { (PreEscaped(line_sign(&sign))) " " data value=(right) data-side="right" { (shown_right) } }
                }
                p.result {
                    @if holds { span.yes { "holds" } } @else { span.no { "fails" } }
                    " by " (margin.html("margin"))
                }
            }
        };
        Ok(Item { full, brief: Brief::Rows(vec![row]) })
    }

    /// Writes a sentence.
    pub fn note(&mut self, text: &str) {
        let brief = Brief::Note(text.to_owned());
        self.write(prose(text).map(|text| Item { full: html! { p.note { (text) } }, brief }));
    }

    /// Writes a heading.
    pub fn heading(&mut self, text: &str) {
        self.subject.clear();
        self.push(html! { h3 { (text) } }, Brief::Heading(text.to_owned()));
    }

    /// Writes anything else, and what it is where several situations stand in a table.
    pub fn push(&mut self, full: Markup, brief: Brief) {
        self.part.items.push(Item { full, brief });
    }

    /// Writes a table of quantities, which are rows where several situations stand together.
    pub fn quantities(&mut self, drawn: Result<(Markup, Vec<Row>), SheetFault>) {
        self.write(drawn.map(|(full, rows)| Item { full, brief: Brief::Rows(rows) }));
    }

    /// Writes a question with its answer; the inequalities that follow belong to it.
    pub fn question(&mut self, words: &str, holds: bool) {
        let cell = html! { @if holds { span.yes { "Yes" } } @else { span.no { "No" } } };
        self.subject(words);
        let row = Row {
            name: String::new(),
            key: words.to_owned(),
            about: html! {},
            head: html! { (words) },
            unit: html! {},
            cell: cell.clone(),
        };
        self.push(html! { h4 { (words) " " (cell) } }, Brief::Rows(vec![row]));
    }
}

/// The formula that `place` shows.
fn read(place: &str, formula: &str) -> Result<Formula, SheetFault> {
    let fault = |source: FormulaError| SheetFault::Formula { place: place.to_owned(), source };
    Formula::parse(formula).map_err(fault)
}

/// A sign as the lines around it show it.
fn line_sign(sign: &str) -> String {
    format!("<math><mo form=\"infix\">{}</mo></math>", sign.replace('<', "&lt;").replace('>', "&gt;"))
}

/// Heading of a step: its subject, and the source of its formula.
fn head(about: &str, reference: &str) -> Result<Markup, SheetFault> {
    let words = prose(about)?;
    Ok(html! {
        p.about {
            (words)
            @if !reference.is_empty() {
                @if !about.is_empty() { " " }
                span.reference { "(" (reference) ")" }
            }
        }
    })
}

#[cfg(test)]
mod tests {
    use standfast::relation::Sign;

    use super::*;
    use crate::measured::METRE;

    /// Steps of which one, in the middle, is `wrong`.
    fn with(wrong: impl Fn(&mut SheetSteps)) -> Result<String, SheetFault> {
        let mut steps = SheetSteps::new("Part", standfast_cases::units::Extent::PerMetre.into());
        steps.know("a", 3.0, METRE);
        steps.add("Half of `a`", "", ["b", "a/2"], 1.5, METRE, "");
        wrong(&mut steps);
        steps.part("Next part", Some(0));
        steps.add("", "", ["c", "a + b"], 4.5, METRE, "");
        steps.finish(&[], "").map(Markup::into_string)
    }

    fn relation(quantity: &'static str, bound: &'static str) -> Relation {
        let sign = Sign::LessOrEqual;
        Relation { equation: "3.4", quantity, left: 1.0, sign, bound, right: 3.0, holds: true }
    }

    #[test]
    fn every_step_asked_for_is_drawn() {
        let drawn = with(|steps| {
            steps.told("Told", "d", 2.0, METRE, "as given", "");
            steps.relation(&relation("μ", "a b"));
            steps.note("Where `d` is.");
        });
        let drawn = drawn.unwrap();
        let count = |what: &str| drawn.matches(what).count();
        assert_eq!((count("<div class=\"step"), count("<p class=\"note\">"), count("<h3")), (4, 1, 2));
    }

    #[test]
    fn a_step_that_cannot_be_read_leaves_no_sheet() {
        type Write = fn(&mut SheetSteps);
        let unreadable: [(Write, &str); 6] = [
            (
                |steps| steps.add("", "", ["d", "2 (a"], 1.0, METRE, ""),
                "the step for `d`: `2 (a` is not a formula: expected `)` at its end",
            ),
            (
                |steps| steps.relation(&relation("μ <", "a")),
                "the inequality (3.4): `μ <` is not a formula: expected a number, a name or a sign at `<`",
            ),
            (
                |steps| steps.relation(&relation("μ", "")),
                "the inequality (3.4): `` is not a formula: expected a number, a name, `(` or `|` at its end",
            ),
            (
                |steps| steps.note("For `a = b`."),
                "the sentence “For `a = b`.”: `a = b` is not a formula: expected a number, a name or a sign at `= b`",
            ),
            (
                |steps| steps.told("Of `a", "d", 1.0, METRE, "", ""),
                "the sentence “Of `a”: expected backticks in pairs around formulas, found one without its partner",
            ),
            (
                |steps| steps.add("Of `a +`", "", ["d", "a"], 3.0, METRE, ""),
                "the sentence “Of `a +`”: `a +` is not a formula: expected a number, a name, `(` or `|` at its end",
            ),
        ];
        for (write, expected) in unreadable {
            assert_eq!(with(write).map_err(|fault| fault.to_string()), Err(expected.to_owned()));
        }
    }

    #[test]
    fn a_name_without_a_number_leaves_no_sheet() {
        let no_number = |place: &str, formula: &str| {
            let [place, formula, name] = [place, formula, "μ"].map(str::to_owned);
            Err(SheetFault::NoNumber { place, formula, name })
        };
        let step = with(|steps| steps.add("", "", ["d", "a μ^2"], 3.0, METRE, ""));
        assert_eq!(step, no_number("the step for `d`", "a μ^2"));
        assert_eq!(
            with(|steps| steps.relation(&relation("k", "a/μ"))),
            no_number("the inequality (3.4)", "a/μ")
        );
    }

    #[test]
    fn the_first_fault_is_the_one_that_is_told() {
        let fault = with(|steps| {
            steps.add("", "", ["d", "a +"], 3.0, METRE, "");
            steps.add("", "", ["e", "f"], 3.0, METRE, "");
        });
        assert!(matches!(fault, Err(SheetFault::Formula { place, .. }) if place == "the step for `d`"));
    }
}
