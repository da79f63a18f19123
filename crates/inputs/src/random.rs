//! Contents of a `[random]` table.
//!
//! ```toml
//! [random]
//! years = 50
//! bodies = 20            # caissons in a row, of which any may move
//! friction = { normal = { mean = 0.6, sd = 0.1 }, each = "body" }
//! wave.deep_water_height = { gumbel = { mean = "4.5 m", sd = "0.9 m" }, lower = "1 m", every = "year" }
//! "load.push.force" = { lognormal = { cov = 0.2 } }      # mean: the case's value
//!
//! [[random.correlation]]
//! between = ["friction", "load.push.force"]
//! rank = 0.3             # Spearman; or linear, or normal; of several names a matrix
//! ```

use std::fmt;
use std::ops::Range as Span;

use standfast_probability::copula::CorrelationMeasure;
use thiserror::Error;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::digits::digits;
use crate::parse::{plain_number, type_of};
use crate::suggest::closest;
pub use laws::{LAWS, years};

mod correlation;
mod laws;

/// The name of the table.
pub const RANDOM: &str = "random";

/// The random numbers of a case, as they are written.
#[derive(Debug, Clone, PartialEq)]
pub struct Random {
    /// The life that is asked for.
    pub lifetime: Lifetime,
    /// The reliability index for which design values are asked.
    pub target_beta: Option<f64>,
    /// True if it is asked what means and deviations of the laws do.
    pub sensitivities: bool,
    /// By how much the water rises in each year of a life.
    pub rise: Option<Parameter>,
    /// The numbers that are random, in the order in which they stand.
    pub named: Vec<RandomEntry>,
    /// Records of shakings, each as likely, in the place of the case's own.
    pub records: Vec<RandomRecord>,
    /// Correlations of two of them together: their places, and the correlation.
    pub correlations: Vec<(usize, usize, CorrelationMeasure)>,
    /// Span of each correlation in the file.
    pub correlation_spans: Vec<Span<usize>>,
    /// Span of the table in the file.
    pub span: Span<usize>,
}

/// Life that is asked for; what is not given is not asked, or as plain as can be.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Lifetime {
    /// Its years.
    pub years: Option<f64>,
    /// Number of events a year on average, by Poisson's law; one each year where it is not given.
    pub events_per_year: Option<f64>,
    /// Years before it through which the body stayed at rest.
    pub survived: Option<f64>,
    /// Number of bodies alike in a row.
    pub bodies: Option<u64>,
}

impl Lifetime {
    /// The same of these years, if they are given.
    pub fn with_years(self, years: Option<f64>) -> Lifetime {
        Lifetime { years: years.or(self.years), ..self }
    }
}

/// A record of a shaking, by its files.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RandomRecord {
    /// To the sides.
    pub horizontal: String,
    /// Up and down at the same time, if it is given.
    pub vertical: Option<String>,
}

impl RandomRecord {
    /// Its files.
    pub fn files(&self) -> impl Iterator<Item = &String> {
        std::iter::once(&self.horizontal).chain(&self.vertical)
    }
}

/// A random number.
#[derive(Debug, Clone, PartialEq)]
pub struct RandomEntry {
    /// Its name: a key of the case file, or a bias.
    pub name: String,
    /// Rate at which it is drawn.
    pub every: Rate,
    /// True if each body of a row draws it for itself.
    pub own: bool,
    /// The number on which its law depends, by its name.
    pub given: Option<Parameter>,
    /// The name of its law.
    pub law: &'static str,
    /// The law's parameters as written.
    pub parameters: Vec<Parameter>,
    /// The law of one of which it is the largest, or those of which it is a mixture.
    pub of: Vec<RandomEntry>,
    /// How likely it is, of a law in a mixture.
    pub share: Option<Parameter>,
    /// The bound below.
    pub lower: Option<Parameter>,
    /// The bound above.
    pub upper: Option<Parameter>,
    /// Span of the number in the file.
    pub span: Span<usize>,
}

impl RandomEntry {
    /// An entry of a name at a place in the text, for a life, whose law is still to be said.
    pub fn without_law(name: String, span: Span<usize>) -> RandomEntry {
        RandomEntry {
            name,
            every: Rate::Life,
            own: false,
            given: None,
            law: "",
            parameters: Vec::new(),
            of: Vec::new(),
            share: None,
            lower: None,
            upper: None,
            span,
        }
    }

    /// Its law in words: `lognormal, mean 0.636, cov 0.15`.
    pub fn law_words(&self) -> String {
        let written = |parameter: &Parameter| format!("{} {}", parameter.name, parameter.value);
        let mut parts: Vec<String> = vec![self.law.to_owned()];
        parts.extend(self.parameters.iter().map(written));
        parts.extend(self.of.iter().map(|of| match &of.share {
            Some(share) => format!("{} of ({})", share.value, of.law_words()),
            None => format!("of {}", of.law_words()),
        }));
        parts.extend([&self.lower, &self.upper, &self.given].into_iter().flatten().map(written));
        parts.join(", ")
    }
}

impl Random {
    /// True if a number is drawn anew each year, so that probabilities are those of a year.
    pub fn is_yearly(&self) -> bool {
        self.named.iter().any(|entry| entry.every == Rate::Year)
    }
}

/// Rate at which a number is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Rate {
    /// Once for a life.
    #[default]
    Life,
    /// Each year.
    Year,
    /// In each event, of which there are some a year on average.
    Event,
}

/// A number under a name, as it is written.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameter {
    /// The name.
    pub name: String,
    /// The value.
    pub value: Written,
    /// The place of both.
    pub span: Span<usize>,
}

/// A plain number, a text with a unit, a list of them, or a function.
#[derive(Debug, Clone, PartialEq)]
pub enum Written {
    /// A plain number.
    Number(f64),
    /// A text with a unit.
    Text(String),
    /// Several.
    List(Vec<Written>),
    /// A function of another number, by its parameters.
    Function(Vec<Parameter>),
}

impl fmt::Display for Written {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Written::Number(number) => write!(f, "{number}"),
            Written::Text(text) => f.write_str(text),
            Written::List(list) => {
                let all: Vec<String> = list.iter().map(Written::to_string).collect();
                f.write_str(&all.join("; "))
            }
            Written::Function(of) => {
                let all: Vec<String> = of.iter().map(|p| format!("{} {}", p.name, p.value)).collect();
                write!(f, "({})", all.join(", "))
            }
        }
    }
}

/// Fault of a `[random]` table.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum RandomProblem {
    /// Something of another type.
    #[error("{what} is {found}; expected {expected}")]
    Type {
        /// Item of another type.
        what: String,
        /// The type found.
        found: &'static str,
        /// Type that is expected.
        expected: String,
    },
    /// A name that is none of those allowed.
    #[error("{what} has no `{name}`; expected {}{}", allowed.join(", "), suggested(name, allowed))]
    Name {
        /// Item in which the name stands.
        what: String,
        /// The name.
        name: String,
        /// The names there may be.
        allowed: Vec<String>,
    },
    /// A law that lacks what it needs.
    #[error("the law {law} of `{name}` lacks {needed}")]
    Lacks {
        /// The law.
        law: &'static str,
        /// The random number.
        name: String,
        /// Parameter that it needs.
        needed: &'static str,
    },
    /// More than one law, or none.
    #[error("`{name}` has {found}; expected one law of {}", LAWS.join(", "))]
    Laws {
        /// The random number.
        name: String,
        /// Laws that there are.
        found: String,
    },
    /// A value that cannot be.
    #[error("{what} is {written}; expected {expected}")]
    Value {
        /// Item that has the value.
        what: String,
        /// The value as it is written.
        written: String,
        /// Values that are expected.
        expected: String,
    },
    /// A number of the case that is not a number, or not there.
    #[error("`{name}` is not a number of the case that can be random{}; {known}", suggestion.as_ref().map_or(String::new(), |s| format!(": did you mean `{s}`?")))]
    NoNumber {
        /// The name.
        name: String,
        /// The one it resembles.
        suggestion: Option<String>,
        /// The numbers there are.
        known: String,
    },
    /// Twice the same number.
    #[error("`{name}` is random twice, here and as `{other}`")]
    Twice {
        /// One name.
        name: String,
        /// The other.
        other: String,
    },
    /// A law that reaches values that no body has, too often to be cut.
    #[error(
        "{share} of the law of `{name}` lies where {limit}; at most 0.001 can be cut: say by `lower` or `upper` what is meant"
    )]
    Unphysical {
        /// The random number.
        name: String,
        /// The share of the law.
        share: String,
        /// Limit of its values.
        limit: String,
    },
    /// A correlation that cannot be.
    #[error(
        "the correlation {} of `{first}` and `{second}` cannot be{}; expected more than {} and less than {}",
        digits(*value),
        if *beside_others { " beside the others" } else { "" },
        digits(*from),
        digits(*to)
    )]
    Correlation {
        /// One number.
        first: String,
        /// The other.
        second: String,
        /// The correlation.
        value: f64,
        /// More than this.
        from: f64,
        /// Less than this.
        to: f64,
        /// True if other correlations are the reason.
        beside_others: bool,
    },
    /// Anything else.
    #[error("{0}")]
    Other(String),
    /// Nothing random.
    #[error("[random] names no number that is random")]
    Nothing,
}

fn suggested(name: &str, allowed: &[String]) -> String {
    closest(name, allowed.iter().map(String::as_str))
        .map_or(String::new(), |near| format!(": did you mean `{near}`?"))
}

/// A problem and where it is.
pub type ReadResult<T> = Result<T, (RandomProblem, Span<usize>)>;

type Item<'a> = Spanned<DeValue<'a>>;

/// What a `[random]` table has beside names with laws.
const OPTIONS: [&str; 8] = [
    "years",
    "survived",
    "target_beta",
    "sensitivities",
    "events_per_year",
    "rise_per_year",
    "bodies",
    "records",
];

/// Reads a `[random]` table.
pub fn read(item: &Item<'_>) -> ReadResult<Random> {
    let table = table(item, "`random`", "a table")?;
    let mut random = Random {
        lifetime: Lifetime::default(),
        target_beta: None,
        sensitivities: false,
        rise: None,
        named: Vec::new(),
        records: Vec::new(),
        correlations: Vec::new(),
        correlation_spans: Vec::new(),
        span: item.span(),
    };
    let mut correlations = None;
    for (name, value) in in_order(table) {
        match name {
            "years" => random.lifetime.years = Some(positive(value, "`years`")?),
            "survived" => random.lifetime.survived = Some(positive(value, "`survived`")?),
            "target_beta" => random.target_beta = Some(positive(value, "`target_beta`")?),
            "sensitivities" => {
                let truth = value.get_ref().as_bool();
                random.sensitivities =
                    truth.ok_or_else(|| wrong(value, "`sensitivities`", "true or false"))?;
            }
            "events_per_year" => {
                random.lifetime.events_per_year = Some(positive(value, "`events_per_year`")?);
            }
            "rise_per_year" => random.rise = Some(laws::parameter(name, value)?),
            "bodies" => random.lifetime.bodies = Some(bodies(value)?),
            "correlation" => correlations = Some(value),
            "records" => random.records = records(value)?,
            _ if value.get_ref().as_table().is_none() && closest(name, OPTIONS).is_some() => {
                let (what, name) = ("[random]".to_owned(), name.to_owned());
                let allowed = OPTIONS.map(str::to_owned).to_vec();
                return Err((RandomProblem::Name { what, name, allowed }, value.span()));
            }
            _ => laws::numbers(name.to_owned(), value, &mut random.named)?,
        }
    }
    if random.named.is_empty() {
        return Err((RandomProblem::Nothing, item.span()));
    }
    rates_go_together(&random)?;
    rows_go_together(&random)?;
    if let Some(list) = correlations {
        correlation::read(list, &mut random)?;
    }
    Ok(random)
}

/// Refuses events without a rate, a rate without events, and years beside events.
fn rates_go_together(random: &Random) -> ReadResult<()> {
    let find = |rate: Rate| random.named.iter().find(|entry| entry.every == rate);
    let refused = |message: String, span: &Span<usize>| Err((RandomProblem::Other(message), span.clone()));
    match (random.lifetime.events_per_year, find(Rate::Event), find(Rate::Year)) {
        (None, Some(entry), _) => {
            let message = format!(
                "`{}` is drawn in each event; expected `events_per_year`, how many there are on average",
                entry.name
            );
            refused(message, &entry.span)
        }
        (Some(_), _, Some(entry)) => {
            let message = format!(
                "`{}` is drawn each year, and `events_per_year` counts events; expected every = \"event\", or \"life\"",
                entry.name
            );
            refused(message, &entry.span)
        }
        _ if random.rise.is_some() && random.lifetime.survived.is_some() => {
            let message =
                "`survived` takes the years before as those to come, and `rise_per_year` makes each another";
            refused(message.to_owned(), &random.span)
        }
        (Some(_), None, None) => {
            let message = "`events_per_year` counts events, and no number has every = \"event\"".to_owned();
            refused(message, &random.span)
        }
        _ => Ok(()),
    }
}

/// Refuses numbers of each body without a number of bodies, and bodies that have all in common.
fn rows_go_together(random: &Random) -> ReadResult<()> {
    let own = random.named.iter().find(|entry| entry.own);
    let (message, span) = match (random.lifetime.bodies, own) {
        (None, Some(entry)) => {
            let name = &entry.name;
            let message =
                format!("`{name}` is drawn for each body; expected `bodies`, how many stand in the row");
            (message, &entry.span)
        }
        (Some(_), None) => {
            let message =
                "`bodies` counts bodies in a row, and no number has each = \"body\": all would move as one";
            (message.to_owned(), &random.span)
        }
        _ => return Ok(()),
    };
    Err((RandomProblem::Other(message), span.clone()))
}

/// Number of bodies in a row.
fn bodies(item: &Item<'_>) -> ReadResult<u64> {
    /// More would take minutes, and no row is longer.
    const MOST: f64 = 1000.0;
    let number = number(item, "`bodies`")?;
    if (2.0..=MOST).contains(&number) && number.fract() == 0.0 {
        return Ok(number as u64);
    }
    let (what, expected) = ("`bodies`".to_owned(), format!("a whole number from 2 to {MOST}"));
    Err((RandomProblem::Value { what, written: number.to_string(), expected }, item.span()))
}

/// The records of a list: of each the file, or one for the sides and one for up and down.
fn records(item: &Item<'_>) -> ReadResult<Vec<RandomRecord>> {
    const EXPECTED: &str = "a file in quotes, or { horizontal = \"a.smc\", vertical = \"b.smc\" }";
    let list = item.get_ref().as_array().filter(|list| !list.is_empty());
    let list = list.ok_or_else(|| wrong(item, "`records`", "a list of files in quotes, one or more"))?;
    let record = |item: &Item<'_>| {
        let of_record = |what: &Item<'_>| wrong(what, "a record of `records`", EXPECTED);
        let name =
            |file: &Item<'_>| file.get_ref().as_str().map(str::to_owned).ok_or_else(|| of_record(file));
        let Some(table) = item.get_ref().as_table() else {
            return Ok(RandomRecord { horizontal: name(item)?, vertical: None });
        };
        let (mut horizontal, mut vertical) = (None, None);
        for (key, value) in in_order(table) {
            match key {
                "horizontal" => horizontal = Some(name(value)?),
                "vertical" => vertical = Some(name(value)?),
                other => {
                    return Err(wrong(value, format!("`{other}` of a record"), "`horizontal` or `vertical`"));
                }
            }
        }
        let lacking = || wrong(item, "a record of `records`", "one with `horizontal`");
        Ok(RandomRecord { horizontal: horizontal.ok_or_else(lacking)?, vertical })
    };
    list.iter().map(record).collect()
}

/// The entries of a table in the order in which they stand.
pub fn in_order<'a>(table: &'a DeTable<'a>) -> Vec<(&'a str, &'a Item<'a>)> {
    let mut entries: Vec<_> = table.iter().collect();
    entries.sort_by_key(|(name, _)| name.span().start);
    entries.into_iter().map(|(name, value)| (name.get_ref().as_ref(), value)).collect()
}

fn wrong(
    item: &Item<'_>,
    what: impl Into<String>,
    expected: impl Into<String>,
) -> (RandomProblem, Span<usize>) {
    let found = type_of(item.get_ref());
    (RandomProblem::Type { what: what.into(), found, expected: expected.into() }, item.span())
}

fn table<'a>(item: &'a Item<'a>, what: &str, expected: &str) -> ReadResult<&'a DeTable<'a>> {
    item.get_ref().as_table().ok_or_else(|| wrong(item, what, expected))
}

fn written(item: &Item<'_>) -> Option<Written> {
    match item.get_ref() {
        DeValue::String(text) => Some(Written::Text(text.to_string())),
        value => plain_number(value).map(Written::Number),
    }
}

fn number(item: &Item<'_>, what: &str) -> ReadResult<f64> {
    match written(item) {
        Some(Written::Number(number)) if number.is_finite() => Ok(number),
        Some(Written::Number(number)) => {
            let (what, written) = (what.to_owned(), number.to_string());
            Err((RandomProblem::Value { what, written, expected: "a finite number".into() }, item.span()))
        }
        _ => Err(wrong(item, what, "a number without unit or quotes")),
    }
}

fn positive(item: &Item<'_>, what: &str) -> ReadResult<f64> {
    let number = number(item, what)?;
    if number > 0.0 {
        return Ok(number);
    }
    let (what, written) = (what.to_owned(), number.to_string());
    Err((RandomProblem::Value { what, written, expected: "a number above zero".into() }, item.span()))
}
