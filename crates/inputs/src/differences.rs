//! Differences between two case files: which keys have another value, or stand in one of them only.
//!
//! Values are compared, and not how they are written: `15 m` and `1500 cm` are the same.

use std::collections::BTreeSet;

use crate::digits::{shortened, significant};
use crate::inputs::Value;
use crate::key::{Id, Key};
use crate::parse::CaseText;
use crate::random::Random;

/// A difference between two case files.
#[derive(Debug, Clone, PartialEq)]
pub struct Difference {
    /// The key; `None` of a random number's law.
    pub id: Option<Id>,
    /// Name of the entry in a file: `body.width`, `random.body.friction`.
    pub name: String,
    /// Its values as they are written; `None` in a file that does not have it.
    pub written: [Option<String>; 2],
}

impl Difference {
    /// Its key, if both files have a number under it.
    pub fn number(&self) -> Option<Key> {
        let is_number = |written: &Option<String>| {
            written
                .as_ref()
                .is_some_and(|written| written.starts_with(|c: char| c.is_ascii_digit() || c == '-'))
        };
        self.id.map(|id| id.key).filter(|_| self.written.iter().all(is_number))
    }

    /// True of words that the answer does not hang on: a title, a note, whose calculation it is.
    pub fn is_label(&self) -> bool {
        use Key::{
            Author, Checker, Client, CombinationName, LoadName, Note, PartName, Project, Revision,
            SheetNumber, Title,
        };
        let labels = [
            Title,
            Note,
            Project,
            Client,
            SheetNumber,
            Revision,
            Author,
            Checker,
            PartName,
            LoadName,
            CombinationName,
        ];
        self.id.is_some_and(|id| labels.contains(&id.key))
    }
}

impl CaseText {
    /// The value under a key as it is written, without quotes; of a number that was varied, its value in the unit that stands there.
    pub fn shown(&self, id: Id) -> Option<String> {
        if let Some((digits, unit)) = self.shown_number(id) {
            return Some(if unit.is_empty() { digits } else { format!("{digits} {unit}") });
        }
        self.inputs().get(id)?;
        let entry = self.entries().iter().find(|entry| entry.id == id)?;
        let written = self.written(entry).split_whitespace().collect::<Vec<_>>().join(" ");
        Some(shortened(written.trim_matches(['"', '\''])))
    }

    /// The digits and the unit of a number: as they are written, or where it was varied those of its value.
    pub fn shown_number(&self, id: Id) -> Option<(String, String)> {
        /// So many digits has a number that is dragged.
        const DIGITS: usize = 7;
        let written = self.written_number(id)?;
        let value = self.from_si(id, self.inputs().number(id)?, &written.unit);
        let is_as_written = |value: &f64| {
            written.digits.parse::<f64>().is_ok_and(|digits| (digits - value).abs() <= 1e-12 * digits.abs())
        };
        let digits = match value.filter(|value| !is_as_written(value)) {
            Some(value) => significant(value, DIGITS),
            None => written.digits,
        };
        Some((digits, written.unit))
    }

    /// The keys that another file gives another value, or that one of both does not have, in the order of the table of keys; then the laws of
    /// random numbers.
    ///
    /// ```
    /// use standfast_inputs::CaseText;
    ///
    /// let one = CaseText::parse("one.toml", "[body]\nwidth = \"15 m\"\nheight = \"12 m\"\n")?;
    /// let two = CaseText::parse("two.toml", "[body]\nwidth = \"17.6 m\"\nheight = \"1200 cm\"\n")?;
    /// let found = one.differences(&two);
    /// assert_eq!((found.len(), found[0].name.as_str()), (1, "body.width"));
    /// assert_eq!(found[0].written, [Some("15 m".to_owned()), Some("17.6 m".to_owned())]);
    /// # Ok::<(), standfast_inputs::CaseError>(())
    /// ```
    pub fn differences(&self, other: &CaseText) -> Vec<Difference> {
        let both = [self, other];
        let ids: BTreeSet<Id> =
            both.iter().flat_map(|file| file.inputs().values().map(|(id, _)| id)).collect();
        let differs = |id: &Id| {
            let [one, two] = both.map(|file| file.inputs().get(*id).zip(Some(file)));
            match (one, two) {
                (Some((one, a)), Some((two, b))) => !is_same(*id, (one, a), (two, b)),
                _ => true,
            }
        };
        let of_keys = ids.into_iter().filter(differs).map(|id| Difference {
            id: Some(id),
            name: id.to_string(),
            written: both.map(|file| file.shown(id)),
        });
        // What neither text writes follows from others that do.
        let of_keys = of_keys.filter(|difference| difference.written[0] != difference.written[1]);
        of_keys.chain(laws(both.map(CaseText::random))).collect()
    }
}

/// True of values that are the same but for how they are written.
fn is_same(id: Id, (one, a): (&Value, &CaseText), (two, b): (&Value, &CaseText)) -> bool {
    let near = |one: f64, two: f64| (one - two).abs() <= 1e-12 * one.abs().max(two.abs());
    match (a.inputs().number(id), b.inputs().number(id), one, two) {
        (Some(one), Some(two), ..) => near(one, two),
        (_, _, Value::Numbers(one), Value::Numbers(two)) => {
            one.len() == two.len() && one.iter().zip(two).all(|(one, two)| near(*one, *two))
        }
        _ => one == two,
    }
}

/// Differences between the laws of random numbers, by their names.
fn laws(both: [Option<&Random>; 2]) -> Vec<Difference> {
    let named = |random: Option<&Random>| random.map_or_else(Vec::new, |random| random.named.clone());
    let [one, two] = both.map(named);
    let mut names: Vec<&String> = Vec::new();
    for entry in one.iter().chain(&two) {
        if !names.contains(&&entry.name) {
            names.push(&entry.name);
        }
    }
    let law = |of: &[crate::random::RandomEntry], name: &String| {
        of.iter().find(|entry| entry.name == *name).map(crate::random::RandomEntry::law_words)
    };
    let all = names.into_iter().map(|name| Difference {
        id: None,
        name: format!("random.{name}"),
        written: [law(&one, name), law(&two, name)],
    });
    all.filter(|difference| difference.written[0] != difference.written[1]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::key::Table;

    const ONE: &str = "title = \"Wall\"\n[body]\nwidth = \"15 m\"\nheight = 12\nmass = '378 t/m'\nfriction = 0.6\n\
                       [wave]\nlambda = [1, 0.5, 1]\n[earthquake]\nhorizontal = \"0.25 g\"\n[[load]]\nforce = \"2700 kN/m\"\nelevation = 8\n";

    fn file(text: &str) -> CaseText {
        CaseText::parse("t.toml", text).unwrap()
    }

    fn told(one: &str, two: &str) -> Vec<(String, Option<String>, Option<String>)> {
        let found = file(one).differences(&file(two));
        found.into_iter().map(|Difference { name, written: [a, b], .. }| (name, a, b)).collect()
    }

    fn some(text: &str) -> Option<String> {
        Some(text.to_owned())
    }

    #[test]
    fn the_same_in_another_unit_is_no_difference() {
        let other = ONE
            .replace("\"15 m\"", "\"1500 cm\" # drawing 12")
            .replace("= 12", "= \"0.012 km\"")
            .replace("0.012 km", "12000 mm")
            .replace("'378 t/m'", "\"378000 kg/m\"")
            .replace("\"2700 kN/m\"", "\"2.7 MN/m\"")
            .replace("[1, 0.5, 1]", "[1.0, 0.50, 1.0]");
        assert_ne!(ONE, other);
        assert_eq!(told(ONE, &other), []);
    }

    /// Each in the unit of its own file, and in the order of the table of keys.
    #[test]
    fn a_changed_key_is_told_as_it_is_written() {
        let other = ONE
            .replace("\"15 m\"", "\"1760 cm\"")
            .replace("0.25 g", "0.3 g")
            .replace("[1, 0.5, 1]", "[1, 0.75, 1]")
            .replace("Wall", "Quay");
        let row = |name: &str, a: &str, b: &str| (name.to_owned(), some(a), some(b));
        assert_eq!(
            told(ONE, &other),
            [
                row("title", "Wall", "Quay"),
                row("body.width", "15 m", "1760 cm"),
                row("wave.lambda[2]", "0.5", "0.75"),
                row("earthquake.horizontal", "0.25 g", "0.3 g"),
            ]
        );
        let found = file(ONE).differences(&file(&other));
        assert_eq!(found[0].number(), None);
        assert_eq!(found.iter().map(Difference::is_label).collect::<Vec<_>>(), [true, false, false, false]);
        assert_eq!(found[1].number(), Some(Key::Width));
    }

    /// A second load, and a law, stand in one of them.
    #[test]
    fn what_stands_in_one_alone_is_told_as_such() {
        let other = format!(
            "{}[[load]]\nname = \"crane\"\nforce = 7\nelevation = 1\n[random]\n\"body.friction\" = {{ normal = {{ mean = 0.6, sd = 0.06 }} }}\n",
            ONE.replace("friction = 0.6\n", "")
        );
        let found = told(ONE, &other);
        let row = |name: &str, a: Option<String>, b: Option<String>| (name.to_owned(), a, b);
        assert_eq!(found[0], row("body.friction", some("0.6"), None));
        assert!(found.contains(&row("load[2].force", None, some("7 N/m"))), "{found:?}");
        assert!(found.contains(&row("load[2].name", None, some("crane"))), "{found:?}");
        assert_eq!(found.last(), Some(&row("random.body.friction", None, some("normal, mean 0.6, sd 0.06"))));
    }

    /// A number that is dragged is told in the unit that stands there.
    #[test]
    fn a_varied_number_is_told_in_its_unit() {
        let one = file(&ONE.replace("15 m", "1500 cm"));
        let mut inputs = one.inputs().clone();
        inputs.set(Key::Width, 17.6);
        let found = one.differences(&one.varied(inputs));
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].written, [some("1500 cm"), some("1760 cm")]);
        assert_eq!(found[0].id.map(|id| id.table), Some(Table::Body));
    }
}
