//! The page: valid HTML that loads nothing, the same bytes each time, and no way out for a hostile title.

mod common;

use std::collections::BTreeSet;

use common::{cases, document, html, select};
use standfast_sheet::{Sheet, SheetOptions};

#[test]
fn the_page_is_valid_and_loads_nothing() {
    for (name, text) in cases() {
        let document = document(&name, &text);
        assert_eq!(document.errors, Vec::<String>::new(), "{name}");
        let mut ids = BTreeSet::new();
        for element in select(&document, "[id]") {
            assert!(
                ids.insert(element.attr("id").unwrap().to_owned()),
                "{name}: twice {:?}",
                element.attr("id")
            );
        }
        for reference in select(&document, "[href]") {
            let target = reference.attr("href").unwrap();
            assert!(target.strip_prefix('#').is_some_and(|id| ids.contains(id)), "{name}: {target}");
        }
        assert!(
            select(&document, "script, link, img, iframe, object, [src], [onload], [style]").is_empty(),
            "{name}"
        );
        let style: String = select(&document, "style")[0].text().collect();
        assert!(style.match_indices("url(").all(|(at, _)| style[at..].starts_with("url(data:")), "{name}");
        assert!(!style.contains("@import"));
    }
}

#[test]
fn a_sheet_is_small_and_the_same_each_time() {
    for (name, text) in cases() {
        let first = html(&name, &text);
        assert_eq!(first, html(&name, &text));
        assert!(first.len() < 600_000, "{name}: {}", first.len());
        // No folder of the file's is on the sheet.
        let elsewhere = Sheet::of(&format!("some/where/{name}"), &text, &SheetOptions::default()).unwrap();
        assert_eq!(first, elsewhere.html());
    }
}

/// The body is shaken with its base, and what it does beside that is what is shown.
#[test]
fn accelerations_of_a_shaken_body_are_said_to_be_relative() {
    let mut shaken = 0;
    for (name, text) in cases() {
        let shakes = text.contains("[earthquake]");
        let words = match text.contains("[[joint]]") {
            true => "its centre, relative to the shaken base",
            // No acceleration of the body is told.
            false if text.contains("direction_deg") => "acts as a force of inertia",
            false => "Accelerations are relative to the base",
        };
        assert_eq!(html(&name, &text).contains(words), shakes, "{name}");
        shaken += usize::from(shakes);
    }
    assert!(shaken > 3, "{shaken}");
}

#[test]
fn the_sheet_says_what_it_is_of() {
    let text = "title = \"Wall\"\n[body]\nwidth = 6\nheight = 7\nmass = 1e5\nfriction = 0.6 # test 12\n[[load]]\nforce = 1e5\nelevation = 3\n";
    let undated = html("wall.toml", text);
    // sha256sum of these bytes
    let hash = "0f411cfd 977ade99 c4992363 7c0da2cd b76fe2e9 eeeab709 208a7633 9e4cec98";
    assert!(undated.contains(hash) && undated.contains("undated") && undated.contains("wall.toml"));
    assert!(undated.contains("test 12"));
    assert!(undated.contains(concat!("standfast ", env!("CARGO_PKG_VERSION"))));
    let options = SheetOptions { date: Some("2026-11-21".parse().unwrap()), ..SheetOptions::default() };
    let dated = Sheet::of("wall.toml", text, &options).unwrap();
    assert!(dated.html().contains("2026-11-21") && !dated.html().contains("undated"));
}

#[test]
fn a_hostile_title_is_only_text() {
    let title = r#"</style><script>alert(1)</script>\"}@page{} & <b> `a +` `"#;
    let text = format!(
        "title = '{title}'\nnote = '{title}'\n[body]\nwidth = 6\nheight = 7\nmass = 1e5\nfriction = 0.6 # {title}\n[[load]]\n\
         name = '{title}'\nforce = 1e5\nelevation = 3\n"
    );
    // Loads that act together have their names at the steps, too.
    let together = format!("{text}[water]\nlevel = 1\ndensity = 1000\n");
    for text in [text, together] {
        let document = document("<b>.toml", &text);
        assert_eq!(document.errors, Vec::<String>::new());
        assert!(select(&document, "script, b").is_empty());
        assert_eq!(select(&document, "style").len(), 1);
        assert_eq!(select(&document, "h1")[0].text().collect::<String>(), title);
    }
}
