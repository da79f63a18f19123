//! The calculation sheet, as the program writes it.

use serde::Serialize;
use standfast_cases::{CaseFile, Portion};
use standfast_sheet::{Date, Sheet, SheetOptions};

use crate::asked::Question;

/// The sheet as the page saves it, or why there is none.
#[derive(Debug, Serialize)]
#[serde(rename_all = "snake_case")]
enum Made {
    Html(String),
    Fault(String),
}

/// The question for a sheet, which has one part.
#[derive(Debug)]
pub struct SheetAsked {
    file: CaseFile,
    options: SheetOptions,
    told: bool,
}

impl SheetAsked {
    /// The sheet of a case, of one page or in full, that bears the day on which it is asked.
    pub fn of(file: CaseFile, short: bool, day: &str) -> SheetAsked {
        let date: Option<Date> = day.parse().ok();
        SheetAsked { file, options: SheetOptions { date, short, ..SheetOptions::default() }, told: false }
    }
}

impl Question for SheetAsked {
    fn next_part(&mut self) -> Option<String> {
        if std::mem::replace(&mut self.told, true) {
            return None;
        }
        let made = match Sheet::of_file(&self.file, &self.options, Portion::UNSEEN) {
            Ok(sheet) => Made::Html(sheet.html().to_owned()),
            Err(error) => Made::Fault(error.to_string()),
        };
        serde_json::to_string(&made).ok()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::asked;
    use crate::examples;
    use crate::page::Page;

    /// By the one way from a page to its second thread and back.
    #[test]
    fn a_sheet_is_that_of_the_text_and_bears_the_day() {
        let mut page = Page::default();
        let example = examples::find("goda-on-sand").unwrap();
        assert!(page.open(&example.file(), example.text));
        for (what, short) in [("sheet 2026-11-25", false), ("short-sheet 2026-11-25", true)] {
            let mut asked = asked::ask(what, &asked::handed_on(&page)).unwrap();
            let part: serde_json::Value = serde_json::from_str(&asked.next_part().unwrap()).unwrap();
            let options = SheetOptions { date: "2026-11-25".parse().ok(), short, ..SheetOptions::default() };
            let sheet = Sheet::of(&example.file(), example.text, &options).unwrap();
            assert_eq!(part["html"], sheet.html());
            assert_eq!(asked.next_part(), None);
        }
    }
}
