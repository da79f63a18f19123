//! What would help: the least change of each number of the case, one row a part; and for two numbers the boundary of the values that meet the
//! target.

use serde::Serialize;
use standfast_cases::design::{
    BoundaryRequest, ChangeRow, DesignBoundary, DesignError, DesignRequest, Extreme, Found, SingleChanges,
    Spelling, Target, boundary_on_screen, changes_caution, changes_heading, number_words,
};
use standfast_cases::{CaseFile, Portion};

use crate::asked::Question;

/// Widths in which the boundary is drawn: for a phone, and for a column of a wide page.
const WIDTHS: [f64; 2] = [340.0, 560.0];

/// What would help.
pub struct Help {
    of: Result<SingleChanges, DesignError>,
    next: Next,
    /// What was found of each: name, share.
    found: Vec<(String, f64)>,
}

/// What is told next.
#[derive(Debug, Clone, Copy)]
enum Next {
    Heading,
    Row(usize),
    Choice,
    Nothing,
}

impl std::fmt::Debug for Help {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Help").field("next", &self.next).finish_non_exhaustive()
    }
}

/// A part of what would help.
#[derive(Debug, Default, Serialize)]
struct HelpPart {
    /// Why nothing can be asked.
    fault: Option<String>,
    heading: Option<String>,
    /// What the list does not tell.
    caution: Option<&'static str>,
    met: Option<bool>,
    row: Option<Row>,
    /// Numbers of which two may be chosen, with their words, and the two that help most.
    numbers: Vec<[String; 2]>,
    two: Vec<String>,
    /// True if the boundary of two takes long.
    slow: bool,
}

/// A row as the page shows it.
#[derive(Debug, Serialize)]
struct Row {
    #[serde(flatten)]
    row: ChangeRow,
    /// The text of the case with the change.
    text: Option<String>,
    /// What goes with it, with its new value.
    with: Vec<String>,
}

impl Help {
    /// What would help a case.
    pub fn of(file: &CaseFile) -> Help {
        Help { of: SingleChanges::of(file, None), next: Next::Heading, found: Vec::new() }
    }

    /// The two numbers that help most: the width first, then friction, or what else takes the least change and is no weight, which goes with
    /// the width.
    fn two(&self) -> Vec<String> {
        let mut found = self.found.clone();
        found.sort_by(|one, two| one.1.total_cmp(&two.1));
        let rank = |name: &str| match name {
            "body.width" => 0,
            "body.friction" => 1,
            "body.mass" | "body.density" | "body.height" => 3,
            _ => 2,
        };
        found.sort_by_key(|(name, _)| rank(name));
        found.into_iter().take(2).map(|(name, _)| name).collect()
    }
}

/// A row in the characters of a page.
fn on_page(row: ChangeRow) -> ChangeRow {
    let set = |words: String| words.replace('-', "−");
    let number = |words: Option<String>| words.map(set);
    ChangeRow {
        present_printed: set(row.present_printed.clone()),
        printed: number(row.printed.clone()),
        change: number(row.change.clone()),
        ..row
    }
}

impl Question for Help {
    fn next_part(&mut self) -> Option<String> {
        let part = match (&self.of, self.next) {
            (_, Next::Nothing) => return None,
            (Err(error), _) => {
                self.next = Next::Nothing;
                HelpPart { fault: Some(error.to_string()), ..HelpPart::default() }
            }
            (Ok(of), Next::Heading) => {
                self.next = Next::Row(0);
                HelpPart {
                    heading: Some(changes_heading(of)),
                    caution: changes_caution(of),
                    met: Some(of.is_met),
                    ..HelpPart::default()
                }
            }
            (Ok(of), Next::Row(place)) => {
                self.next = if place + 1 < of.variables.len() { Next::Row(place + 1) } else { Next::Choice };
                // A number without a range has no row.
                let change = of.variables.get(place).map(|variable| of.change(variable, Portion::UNSEEN));
                let Some(Ok(change)) = change else { return self.next_part() };
                let row = on_page(ChangeRow::of(of, &change));
                if let Some(share) = row.share {
                    self.found.push((row.vary.clone(), share.abs()));
                }
                let (text, coupled) = match change.found {
                    Found::Helps(new) => (new.text, new.coupled),
                    _ => (None, Vec::new()),
                };
                let with = coupled.iter().map(|(id, value)| format!("{} {value}", id.words()));
                HelpPart { row: Some(Row { row, text, with: with.collect() }), ..HelpPart::default() }
            }
            (Ok(of), Next::Choice) => {
                self.next = Next::Nothing;
                let words = of
                    .variables
                    .iter()
                    .map(|variable| [variable.name().to_owned(), number_words(of, variable)]);
                HelpPart {
                    numbers: words.collect(),
                    two: self.two(),
                    slow: of.is_slow(),
                    ..HelpPart::default()
                }
            }
        };
        serde_json::to_string(&part).ok()
    }
}

/// The boundary of two numbers.
#[derive(Debug)]
pub struct TwoNumbers {
    asked: Option<(CaseFile, [String; 2])>,
}

/// The boundary as the page shows it: for a phone, and for a wide page.
#[derive(Debug, Default, Serialize)]
struct BoundaryPart {
    narrow: String,
    wide: String,
    /// What is shown, or why there is no boundary.
    words: String,
}

impl TwoNumbers {
    /// The boundary of two numbers of a case: upwards and to the right.
    pub fn of(file: CaseFile, numbers: [&str; 2]) -> TwoNumbers {
        TwoNumbers { asked: Some((file, numbers.map(str::to_owned))) }
    }
}

fn boundary(file: &CaseFile, [up, across]: [String; 2], target: Target) -> BoundaryPart {
    let design = DesignRequest {
        vary: up,
        target,
        extreme: Extreme::Least,
        from: None,
        to: None,
        spelling: &Spelling::PROGRAM,
    };
    let request = BoundaryRequest { design, and: across, from: None, to: None };
    let boundary = match DesignBoundary::of(file, request, Portion::UNSEEN) {
        Ok(boundary) => boundary,
        Err(error) => return BoundaryPart { words: format!("{error}."), ..BoundaryPart::default() },
    };
    let [narrow, wide] = WIDTHS.map(|width| boundary_on_screen(&boundary, width));
    match (narrow, wide) {
        (Some(narrow), Some(wide)) => BoundaryPart {
            words: wide.caption().to_owned(),
            narrow: narrow.svg().to_owned(),
            wide: wide.svg().to_owned(),
        },
        _ => BoundaryPart {
            words: "In the whole range of both the target is met.".to_owned(),
            ..BoundaryPart::default()
        },
    }
}

impl Question for TwoNumbers {
    fn next_part(&mut self) -> Option<String> {
        let (file, numbers) = self.asked.take()?;
        let part = match SingleChanges::of(&file, None) {
            Ok(of) => boundary(&file, numbers, of.target),
            Err(error) => BoundaryPart { words: error.to_string(), ..BoundaryPart::default() },
        };
        serde_json::to_string(&part).ok()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::Value;

    const SAND: &str = include_str!("../../examples/goda-on-sand.toml");

    fn parts(question: &mut dyn Question) -> Vec<Value> {
        std::iter::from_fn(|| question.next_part()).map(|part| serde_json::from_str(&part).unwrap()).collect()
    }

    fn file(text: &str) -> CaseFile {
        CaseFile::parse("case.toml", text).unwrap()
    }

    #[test]
    fn rows_are_told_one_by_one_and_two_numbers_in_the_end() {
        let parts = parts(&mut Help::of(&file(SAND)));
        let (first, last) = (&parts[0], parts.last().unwrap());
        assert_eq!(first["met"], false);
        let rows: Vec<&Value> = parts.iter().map(|part| &part["row"]).filter(|row| !row.is_null()).collect();
        assert_eq!(rows.len(), parts.len() - 2);
        assert_eq!(rows.len(), last["numbers"].as_array().unwrap().len());
        let width = rows[0];
        assert_eq!(
            [&width["present_printed"], &width["printed"], &width["change"]],
            ["15 m", "15.87 m", "+ 5.8 %"]
        );
        assert_eq!(width["with"][0], "mass 366.121 t/m");
        assert!(width["text"].as_str().unwrap().contains("width = \"15.87 m\"\n"));
        // Friction does not help on ground that fails: its angle of friction does.
        assert_eq!(last["two"], serde_json::json!(["body.width", "ground.friction_angle_deg"]));
        assert_eq!(last["slow"], false);
    }

    #[test]
    fn two_numbers_have_their_boundary_in_two_widths() {
        let text = "[body]\nwidth = 4\nheight = 6\ndensity = 2400\nfriction = 0.3\n[[load]]\nforce = 3e5\nelevation = 3\n";
        let parts = parts(&mut TwoNumbers::of(file(text), ["body.width", "body.friction"]));
        let [part] = &parts[..] else { panic!("{}", parts.len()) };
        for (which, width) in ["narrow", "wide"].into_iter().zip(WIDTHS) {
            let svg = part[which].as_str().unwrap();
            assert!(svg.contains(&format!("width=\"{width}\"")) && svg.contains("var(--feasible,"));
        }
        assert!(part["words"].as_str().unwrap().starts_with("Shaded: the body rests under the full load."));
    }

    #[test]
    fn what_cannot_be_asked_says_why() {
        let block = include_str!("../../examples/motion/block-base-pulse.toml");
        let parts = parts(&mut Help::of(&file(block)));
        assert_eq!(parts.len(), 1);
        assert!(parts[0]["fault"].as_str().unwrap().starts_with("a [block] has no first instant"));
    }
}
