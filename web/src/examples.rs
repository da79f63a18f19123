//! The cases that the page brings along: examples on four shelves, each with what is surprising in it, and new ones.

use serde::Serialize;
use standfast_cases::beginnings::{BEGINNINGS, Beginning};

/// A case that the page brings along.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct BroughtCase {
    /// Its name.
    pub name: &'static str,
    /// One line on it.
    pub words: &'static str,
    /// Its text.
    #[serde(skip)]
    pub text: &'static str,
    #[serde(skip)]
    file: &'static str,
}

impl BroughtCase {
    /// The name of its file.
    pub fn file(&self) -> String {
        format!("{}.toml", self.file)
    }
}

/// Cases of one kind.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Shelf {
    /// Its name.
    pub name: &'static str,
    /// The cases on it.
    pub cases: &'static [BroughtCase],
}

macro_rules! cases {
    ($($file:literal $path:literal $name:literal $words:literal;)*) => {
        &[$(BroughtCase { name: $name, words: $words, text: include_str!($path), file: $file }),*]
    };
}

/// The shelves; the first case opens first.
pub const SHELVES: [Shelf; 4] = [
    Shelf {
        name: "Sea",
        cases: cases! {
            "caisson-in-air" "../../examples/caisson-in-air.toml" "Caisson in air"
                "Both factors are below 1, and it neither slides nor rocks: it does both at once.";
            "goda-2000" "../../examples/goda-2000.toml" "Goda’s caisson"
                "The worked example of the textbook: the wave may grow by an eighth.";
            "eccentric-caisson" "../../examples/eccentric-caisson.toml" "Caisson with its weight off the middle"
                "Eight times safe against sliding, and not accepted: it presses too hard on one edge.";
            "breaking-wave" "../../examples/breaking-wave.toml" "Breaking wave on a wall in water"
                "Water lifts as it pushes: the margin is that of both together.";
            "crown-wall" "../../examples/crown-wall.toml" "Crown wall"
                "A factor of 1.92, and half as much wave again moves it: uplift grows with the wave.";
            "caisson-breaking-wave" "../../examples/motion/caisson-breaking-wave.toml" "Caisson under a blow, in time"
                "The wave is a third too strong, for half a second: the caisson slides 8 cm and stands.";
        },
    },
    Shelf {
        name: "Ground",
        cases: cases! {
            "goda-on-sand" "../../examples/goda-on-sand.toml" "Goda’s caisson on sand"
                "Safe against sliding and overturning: the sand fails first.";
            "caisson-on-stone" "../../examples/caisson-on-stone.toml" "Caisson on stone that crushes"
                "In air this caisson slides and rocks. A crushing edge makes it only rock.";
            "quay" "../../examples/quay.toml" "Quay wall with backfill"
                "Three combinations, four criteria; the least weight governs.";
            "head-difference" "../../examples/head-difference.toml" "Wall with a difference of water levels"
                "Each load acts alone: the debris governs, not the boat.";
            "trough" "../../examples/trough.toml" "Trough of a wave"
                "The sea pulls instead of pushing, and the factors are near ten.";
        },
    },
    Shelf {
        name: "Earthquake",
        cases: cases! {
            "monument" "../../examples/monument.toml" "Statue on its pedestal"
                "To begin to rock is not to overturn: the factor 0.68 is of the first instant alone.";
            "statue-any-direction" "../../examples/directions/statue.toml" "Statue shaken from anywhere"
                "Over a corner it bears 1.41 times what it does across a side.";
            "device-on-three-feet" "../../examples/directions/device-on-three-feet.toml" "Device on three feet"
                "Pushed square to the side between two feet it bears 13 % less than as it is pushed here.";
            "server-rack" "../../examples/server-rack.toml" "Server rack"
                "It rests under the standard’s load, and misses the factor asked by three per cent.";
            "server-rack-earthquake" "../../examples/motion/server-rack-earthquake.toml" "Server rack in an earthquake"
                "It ends standing, and 0.1 % on its inputs changes its motion by a third.";
            "statue-earthquake" "../../examples/motion/statue-earthquake.toml" "Statue in an earthquake"
                "It rocks to three quarters of the angle at which it tips over, and comes back.";
            "marble-drum" "../../examples/marble-drum.toml" "Marble drum"
                "Two per cent from rocking, and all that is asked is met.";
            "block-base-pulse" "../../examples/motion/block-base-pulse.toml" "Block in pure numbers"
                "No metre and no kilogram: it overturns after it has come back once.";
        },
    },
    Shelf {
        name: "Chance",
        cases: cases! {
            "goda-2000-random" "../../examples/goda-2000-random.toml" "Goda’s caisson with random numbers"
                "Factors above 1, and one such event in forty moves it.";
            "statue-random" "../../examples/statue-random.toml" "Statue with random friction"
                "It rests with 15 % to spare, and does not with a probability of 8 %.";
            "goda-2000-storm" "../../examples/goda-2000-storm.toml" "Goda’s caisson in fifty years of storms"
                "It slides 6 cm on average in its life.";
        },
    },
];

/// New cases, to be made one's own.
fn new() -> impl Iterator<Item = BroughtCase> {
    let brought =
        |one: &Beginning| BroughtCase { name: one.title, words: one.words, text: one.text, file: one.name };
    BEGINNINGS.iter().map(brought)
}

/// Every case: those on the shelves, then the new ones.
fn all() -> impl Iterator<Item = BroughtCase> {
    SHELVES.iter().flat_map(|shelf| shelf.cases).copied().chain(new())
}

/// Records that examples name.
const RECORDS: [(&str, &str); 2] = [
    ("np01002p_4225b_a.smc", include_str!("../../examples/records/np01002p_4225b_a.smc")),
    ("np01002p_4225c_a.smc", include_str!("../../examples/records/np01002p_4225c_a.smc")),
];

/// The case that opens first.
pub fn first() -> &'static BroughtCase {
    &SHELVES[0].cases[0]
}

/// A case by its name, or that of its file.
pub fn find(name: &str) -> Option<BroughtCase> {
    all().find(|case| case.name == name || case.file == name)
}

/// A record by the name of its file.
pub fn record(name: &str) -> Option<&'static str> {
    RECORDS.iter().find(|(record, _)| *record == name).map(|(_, text)| *text)
}

/// The shelves and the new cases, as JSON.
pub fn json() -> String {
    serde_json::to_string(&(SHELVES, new().collect::<Vec<_>>())).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::page::Page;

    fn opened(case: &BroughtCase) -> Page {
        let mut page = Page::default();
        assert!(page.open(&case.file(), case.text), "{}: {:?}", case.name, page.fault());
        page
    }

    fn answer(name: &str) -> (String, f64) {
        let page = opened(&find(name).unwrap());
        let summary = page.answered().summary().unwrap();
        let worst = page
            .answered()
            .rest
            .as_ref()
            .map(|rest| rest.least(|one| one.outcome.stability.sliding).outcome.stability.sliding);
        (summary.text().split_whitespace().collect::<Vec<_>>().join(" "), worst.unwrap_or(f64::NAN))
    }

    #[test]
    fn every_case_has_an_answer() {
        for case in all() {
            let page = opened(&case);
            assert!(page.answered().summary().is_some(), "{}", case.name);
            assert!(!case.words.is_empty());
        }
    }

    /// The numbers in the lines on the examples are those of their answers.
    #[test]
    fn lines_on_examples_hold() {
        for (name, words) in [
            ("caisson-in-air", "slides and rocks about O"),
            ("goda-2000", "At 112.5 % of the wave"),
            ("eccentric-caisson", "Not met: bearing_max"),
            ("crown-wall", "At 152 % of the uplift and the breaking wave"),
            ("caisson-breaking-wave", "It has slid 0.08467 m to the left."),
            ("goda-on-sand", "stands on ground that fails"),
            ("caisson-on-stone", "rocks about O, the bottom left corner (RO)."),
            ("quay", "All 4 criteria are met"),
            ("quay", "under each of the 3 combinations"),
            ("quay", "weight lowered"),
            ("head-difference", "Under «debris»"),
            ("monument", "0.6789"),
            ("server-rack", "SF_overturning_net is 1.452, ≥ 1.5 is asked (utilisation 1.033)"),
            ("server-rack-earthquake", "about 35 % of the angle of balance"),
            ("statue-earthquake", "73.4 % of the angle at which it tips over"),
            ("marble-drum", "At 102 % of the earthquake"),
            ("block-base-pulse", "It overturns at t = 10.05"),
            ("statue-random", "The least safety factor is 1.154"),
        ] {
            assert!(answer(name).0.contains(words), "{name}: {}", answer(name).0);
        }
        assert!(
            (8.0..8.2).contains(&answer("eccentric-caisson").1) && (9.0..11.0).contains(&answer("trough").1)
        );
    }

    #[test]
    fn a_case_is_found_by_its_name() {
        assert_eq!(find("Goda’s caisson").map(|case| case.file()).as_deref(), Some("goda-2000.toml"));
        assert!(find("block").is_some() && find("../goda-2000").is_none());
        assert!(record("np01002p_4225c_a.smc").is_some() && record("x").is_none());
    }
}
