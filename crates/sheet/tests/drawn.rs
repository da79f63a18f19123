//! The formulas as a reader sees them: no sign is left out where two numbers would run together.

mod common;

use std::collections::BTreeSet;

use common::{cases, document, select};
use scraper::{ElementRef, Html};

const INVISIBLE_TIMES: &str = "\u{2062}";

/// Reading order of a line of formulas: the elements' names and texts.
type Line = Vec<(String, String)>;

/// Every line of formulas of a sheet. A long one consists of several `math` elements.
fn lines(html: &Html) -> Vec<Line> {
    let mut seen = BTreeSet::new();
    let parents =
        select(html, "math").into_iter().filter_map(|math| math.parent().and_then(ElementRef::wrap));
    parents.filter(|parent| seen.insert(parent.id())).map(line).collect()
}

fn line(parent: ElementRef<'_>) -> Line {
    let elements = parent.descendants().filter_map(ElementRef::wrap);
    let read = elements.filter(|element| matches!(element.value().name(), "mn" | "mi" | "mo" | "mtext"));
    read.map(|element| (element.value().name().to_owned(), element.text().collect())).collect()
}

#[test]
fn no_number_follows_an_invisible_sign() {
    let mut invisible = 0;
    for (name, text) in cases() {
        let html = document(&name, &text);
        for line in lines(&html) {
            for (i, (_, text)) in line.iter().enumerate().filter(|(_, (_, text))| text == INVISIBLE_TIMES) {
                let next = line.get(i + 1).unwrap_or_else(|| panic!("{name}: {text:?} ends {line:?}"));
                assert_ne!(next.0, "mn", "{name}: {line:?}");
                invisible += 1;
            }
        }
        // Nor does one follow another with nothing between, other than as what stands above or below it.
        for number in select(&html, "mn + mn") {
            let above =
                number.parent().and_then(ElementRef::wrap).map(|above| above.value().name().to_owned());
            assert!(matches!(above.as_deref(), Some("mfrac" | "msup")), "{name}: {}", number.html());
        }
    }
    assert!(invisible > 900, "{invisible}");
}

#[test]
fn the_added_mass_of_water_shows_its_factors() {
    let (name, text) = cases().into_iter().find(|(name, _)| name == "earthquake in water.toml").unwrap();
    let html = document(&name, &text);
    let drawn: Vec<String> = lines(&html)
        .into_iter()
        .map(|line| line.into_iter().map(|(_, text)| text).filter(|text| text != INVISIBLE_TIMES).collect())
        .collect();
    for expected in ["14⋅1.2020569031595942", "16⋅0.9889445517411053", "7π⋅1.2020569031595942"] {
        assert!(drawn.iter().any(|line| line.contains(expected)), "{expected} in {drawn:#?}");
    }
}
