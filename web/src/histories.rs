//! How loads and the base go with time: shapes to choose, and records that were dropped, written into the text of the case.

use serde::Serialize;
use standfast_cases::CaseFile;
use standfast_cases::case::{course, history_shapes};
use standfast_cases::layout::significant;
use standfast_inputs::Key;
use standfast_inputs::key::{Id, Table};

use crate::page::Page;

/// What may go with time, as a row shows it.
#[derive(Debug, Serialize)]
struct HistoryRow {
    key: String,
    words: String,
    /// The shape that it has; empty of what does not go with time.
    shape: String,
    shapes: Vec<&'static str>,
}

/// Keys that a shape need not have, and is begun with.
const BEGUN_WITH: [Key; 2] = [Key::HistoryPeriod, Key::Tail];

/// The shapes that may be chosen, each with the keys that it is written with: all but records.
fn shapes() -> impl Iterator<Item = (&'static str, impl Iterator<Item = Key>)> {
    let all = history_shapes().filter(|(name, ..)| *name != "file");
    all.map(|(name, needed, open)| {
        let open = open.iter().filter(|key| BEGUN_WITH.contains(key));
        (name, needed.iter().chain(open).copied())
    })
}

/// What a shaking reaches that is not said.
const PEAK: &str = "\"0.3 g\"";

/// The histories that a case has or may have.
pub(crate) fn all(file: &CaseFile) -> Vec<(Table, usize)> {
    let inputs = file.inputs();
    let of = |parent: Table, table: Table| (0..inputs.count(parent)).map(move |index| (table, index));
    let loads = of(Table::Load, Table::LoadHistory).chain(of(Table::BlockLoad, Table::BlockLoadHistory));
    let all = loads.chain(of(Table::Wave, Table::WaveHistory));
    let has_base = inputs.has(Table::Body) || inputs.has(Table::Block);
    all.chain(has_base.then_some((Table::BaseHorizontal, 0))).collect()
}

/// An entry of a history as it is written.
pub(crate) fn written(file: &CaseFile, of: (Table, usize), key: Key) -> Option<&str> {
    let is_it = |id: Id| (id.table, id.index) == of && id.key == key;
    file.entries().iter().find(|entry| is_it(entry.id)).map(|entry| file.written(entry))
}

/// Points of a history as shares of its peak, before it is shifted to its start; `None` of one that has none to draw.
pub(crate) fn points(file: &CaseFile, (table, index): (Table, usize)) -> Option<Vec<[f64; 2]>> {
    /// Points of a shape that is curved, and moments at which one that has no end is seen.
    const CURVED: usize = 16;
    let course = course(file.inputs(), table, index)?;
    let peak = file.inputs().number(Id::of(table, index, Key::HistoryPeak)).unwrap_or(1.0);
    let end = Some(course.end()).filter(|end| end.is_finite());
    let points = match course.corners() {
        Some(corners) => corners,
        None => {
            let end = end?;
            (0..=CURVED).map(|i| end * i as f64 / CURVED as f64).map(|t| [t, course.before(t)]).collect()
        }
    };
    let to_hand = |share: f64| significant(share, 4).parse().unwrap_or(share);
    let points = points.into_iter().map(|[t, value]| [to_hand(t), to_hand(value / peak)]);
    let points: Vec<_> = points.collect();
    points.iter().flatten().all(|number| number.is_finite()).then_some(points).filter(|_| end.is_some())
}

/// Times and values of points as lists of a case file.
pub(crate) fn lists(points: &[[f64; 2]]) -> [String; 2] {
    [0, 1].map(|which| {
        let numbers: Vec<String> = points.iter().map(|point| plain(point[which])).collect();
        format!("[{}]", numbers.join(", "))
    })
}

/// A number as it is written.
fn plain(number: f64) -> String {
    // No sum of roundings, and no zero below zero.
    significant(number + 0.0, 7)
}

impl Page {
    /// What goes with time, or may, as JSON.
    pub fn courses(&self) -> String {
        let file = self.settled();
        let row = |(table, index): (Table, usize)| {
            let name =
                file.inputs().text(Id::new(Key::LoadName, index)).filter(|_| table == Table::LoadHistory);
            let shape = written(file, (table, index), Key::HistoryShape).unwrap_or_default();
            let shape = shape.trim_matches(['"', '\'']).to_owned();
            // A record is not begun with, and stays where it is.
            let shapes = history_shapes().map(|(name, ..)| name);
            let shapes = shapes.filter(|name| *name == shape || self::shapes().any(|(own, _)| own == *name));
            let place = if table.parent().is_some_and(Table::repeats) {
                format!(" {}", index + 1)
            } else {
                String::new()
            };
            let words = match (table, name) {
                (_, Some(name)) => name.to_owned(),
                (Table::BaseHorizontal, _) => "shaking of the base".to_owned(),
                (Table::WaveHistory, _) => "wave".to_owned(),
                _ => format!("load{place}"),
            };
            HistoryRow { key: table.path(index), words, shapes: shapes.collect(), shape }
        };
        let rows: Vec<HistoryRow> = all(file).into_iter().map(row).collect();
        serde_json::to_string(&rows).unwrap_or_default()
    }

    /// Gives what goes with time a shape by its name, with the numbers that it has, or else with those of the table of keys.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn set_history(&mut self, key: &str, shape: &str) -> Result<(), String> {
        let file = self.settled();
        let of = all(file).into_iter().find(|(table, index)| table.path(*index) == key);
        let chosen = shapes().find(|(name, _)| *name == shape);
        let ((table, index), (_, keys)) = of.zip(chosen).ok_or_else(|| format!("The case has no {key}."))?;
        let is_pure = file.inputs().has(Table::Block);
        let has = |key: Key| written(file, (table, index), key);
        let example = |key: Key| {
            let example = key.info().example;
            // A block in pure numbers has no units.
            if is_pure { example.trim_matches('"').split(' ').next().unwrap_or(example) } else { example }
        };
        // Points begin as the shape before them went.
        let drawn = points(file, (table, index)).filter(|_| shape == "points");
        let drawn = drawn.map(|points| lists(&points));
        let mut parts = vec![format!("shape = \"{shape}\"")];
        let mut put = |key: Key, value: &str| parts.push(format!("{} = {value}", key.name()));
        if let Some(start) = has(Key::HistoryStart) {
            put(Key::HistoryStart, start);
        }
        for key in keys {
            let plain = example(key);
            let from_before = match (key, &drawn) {
                (Key::Times, Some([times, _])) => Some(times.as_str()),
                (Key::Values, Some([_, values])) => Some(values.as_str()),
                _ => None,
            };
            if let Some(list) = from_before {
                put(key, list);
                continue;
            }
            // One whole wave, where its period is not said.
            if key == Key::HistoryPeriod && has(key).is_none() {
                put(key, has(Key::HistoryDuration).unwrap_or(example(Key::HistoryDuration)));
                continue;
            }
            // A tail of the base would be an acceleration.
            if key != Key::Tail || table != Table::BaseHorizontal || has(key).is_some() {
                put(key, has(key).unwrap_or(plain));
            }
        }
        let is_base = table == Table::BaseHorizontal;
        // As strong as the earthquake whose place it takes.
        let held = file.entries().iter().find(|entry| entry.id.key == Key::Horizontal);
        let held = held.filter(|_| is_base).map(|entry| file.written(entry));
        let peak = held.or(is_base.then_some(if is_pure { "0.3" } else { PEAK }));
        if let Some(peak) = has(Key::HistoryPeak).or(peak) {
            put(Key::HistoryPeak, peak);
        }
        let written = format!("{{ {} }}", parts.join(", "));
        if is_base {
            return self.shake(&written);
        }
        self.take_history(file.with_history(table, index, &written))
    }

    /// True if the case may be shaken with a file that was dropped: a body or a block, whose text does not name it.
    pub fn can_shake_with(&self, name: &str) -> bool {
        let names_it = self.settled().files().any(|(own, _)| own.rsplit(['/', '\\']).next() == Some(name));
        let may = all(self.settled()).contains(&(Table::BaseHorizontal, 0));
        may && !names_it && !name.contains(['"', '\\']) && self.files().contains_key(name)
    }

    /// Shakes the base with a file that was dropped, in place of an earthquake that the case has.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn shake_with(&mut self, name: &str) -> Result<(), String> {
        let file = self.settled();
        let held = file.inputs().number(Key::Horizontal).filter(|peak| *peak != 0.0);
        match held.and(file.shown(Key::Horizontal.into())) {
            // As strong as the earthquake was.
            Some(peak) => {
                let peak = peak.trim_start_matches('-');
                self.shake(&format!("{{ shape = \"file\", file = \"{name}\", target_peak = \"{peak}\" }}"))?;
                self.told += &format!(" The record is scaled to its {peak}.");
                Ok(())
            }
            // With its factor, which is a field: how strong it is.
            None => self.shake(&format!("{{ shape = \"file\", file = \"{name}\", factor = 1 }}")),
        }
    }

    /// Shakes the base as it is written, in place of an earthquake, with which the same shaking would count twice.
    fn shake(&mut self, written: &str) -> Result<(), String> {
        let file = self.settled();
        let loses = file.inputs().number(Key::Vertical).is_some_and(|vertical| vertical != 0.0);
        let still = match file.inputs().has(Table::Earthquake) {
            true => file
                .without_table(Table::Earthquake)
                .and_then(|text| standfast_cases::CaseText::parse(file.name(), &text).ok()),
            false => None,
        };
        let text = match &still {
            Some(still) => still.with_history(Table::BaseHorizontal, 0, written),
            None => file.with_history(Table::BaseHorizontal, 0, written),
        };
        let replaces = still.is_some();
        self.take_history(text)?;
        if replaces {
            let vertical = if loses { " Its vertical part is gone." } else { "" };
            self.told = format!("It takes the place of [earthquake].{vertical}");
        }
        Ok(())
    }

    fn take_history(&mut self, text: Option<String>) -> Result<(), String> {
        self.take(text.ok_or("That history is not written in braces: change it in the text.")?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examples;

    fn page(name: &str) -> Page {
        let mut page = Page::default();
        let example = examples::find(name).unwrap();
        assert!(page.open(&example.file(), example.text));
        page
    }

    /// Every shape of every load and of the base is one that the case has an answer with, in one step.
    #[test]
    fn shapes_are_written_with_numbers_to_begin_from() {
        for name in ["caisson-in-air", "goda-2000", "block-base-pulse", "block"] {
            let mut page = page(name);
            let keys: Vec<serde_json::Value> = serde_json::from_str(&page.courses()).unwrap();
            assert!(!keys.is_empty(), "{name}");
            for key in keys.iter().map(|row| row["key"].as_str().unwrap()) {
                for (shape, _) in shapes() {
                    let before = page.text().to_owned();
                    // A base shakes where all that varies goes with time.
                    if let Err(words) = page.set_history(key, shape) {
                        assert!(
                            key.ends_with("horizontal") && words.contains("history"),
                            "{key}, {shape}: {words}"
                        );
                        assert_eq!(page.text(), before);
                        continue;
                    }
                    assert!(page.answered().is_in_time(), "{name}: {key}, {shape}");
                    page.undo();
                    assert_eq!(page.text(), before);
                }
            }
        }
    }

    /// Another shape keeps the numbers that it shares with the last.
    #[test]
    fn numbers_of_the_shape_before_are_kept() {
        let mut page = page("caisson-breaking-wave");
        page.set_history("wave.history", "half-sine").unwrap();
        assert!(page.text().contains("history = { shape = \"half-sine\", duration = \"1.557 s\" }"));
        assert!(page.set_history("wave.history", "file").is_err());
    }

    /// A shape takes the place of an earthquake, as strong as that was.
    #[test]
    fn a_shape_shakes_the_body_in_place_of_its_earthquake() {
        let mut page = Page::default();
        let statue = standfast_cases::beginnings::BEGINNINGS.iter().find(|one| one.name == "statue").unwrap();
        assert!(page.open("statue.toml", statue.text));
        for shape in ["half-sine", "rect", "sine"] {
            page.set_history("motion.base.horizontal", shape).unwrap();
            assert!(
                page.answered().is_in_time() && !page.text().contains("\n[earthquake]"),
                "{}",
                page.text()
            );
            let line = page.text().lines().find(|line| line.starts_with("horizontal = {")).unwrap();
            assert!(line.contains(shape) && line.ends_with("peak = \"0.2 g\" }"), "{line}");
            assert_eq!(page.told, "It takes the place of [earthquake].");
            page.undo();
        }
        // A vertical part has no place in one course.
        let text = statue.text.replace("# vertical", "vertical");
        assert!(page.open("statue.toml", &text));
        page.set_history("motion.base.horizontal", "sine").unwrap();
        assert_eq!(page.told, "It takes the place of [earthquake]. Its vertical part is gone.");
    }

    #[test]
    fn a_dropped_record_shakes_the_body_in_place_of_its_earthquake() {
        let mut page = page("rack");
        assert!(!page.can_shake_with("shake.csv"));
        page.add_file("shake.csv", "t,a_m_s2\n0,0\n1,4\n2,0\n");
        assert!(page.can_shake_with("shake.csv"));
        page.shake_with("shake.csv").unwrap();
        assert!(page.answered().is_in_time() && !page.text().contains("[earthquake]"));
        assert!(page.text().ends_with(
            "\n[motion.base]\nhorizontal = { shape = \"file\", file = \"shake.csv\", target_peak = \"0.25 g\" }\n"
        ));
        // As strong as the earthquake was, whose peak the record itself does not have.
        assert_eq!(page.told, "It takes the place of [earthquake]. The record is scaled to its 0.25 g.");
        assert!(!page.can_shake_with("shake.csv"));
        page.undo();
        assert!(page.text().contains("[earthquake]"));
        page.add_file("words.csv", "no record");
        let before = page.text().to_owned();
        assert!(page.shake_with("words.csv").is_err());
        assert_eq!(page.text(), before);
    }
}
