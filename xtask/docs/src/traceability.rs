//! Every function and test that the pages of validation and docs/trust/errata.md name exists.

use std::fs;
use std::path::Path;

use crate::root;

/// All Rust sources of the repository, one after another.
fn sources(directory: &Path, text: &mut String) {
    for entry in fs::read_dir(directory).unwrap().map(Result::unwrap) {
        let path = entry.path();
        if path.is_dir() && path.file_name().is_some_and(|name| name != "target") {
            sources(&path, text);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            text.push_str(&fs::read_to_string(path).unwrap());
        }
    }
}

/// The names between backticks that look like functions: `like_this` or `Type::like_this`.
fn functions(page: &str) -> Vec<&str> {
    let quoted = page.split('`').skip(1).step_by(2);
    let names = quoted.filter_map(|quoted| quoted.rsplit("::").next());
    names
        .filter(|name| {
            name.contains('_')
                && name.chars().all(|c| c.is_ascii_lowercase() || c == '_' || c.is_ascii_digit())
                || name.chars().all(|c| c.is_ascii_lowercase()) && name.len() > 3
        })
        .collect()
}

#[test]
fn every_function_named_in_the_traceability_table_exists() {
    let mut text = String::new();
    for directory in ["crates", "xtask"] {
        sources(&root().join(directory), &mut text);
    }
    for page in ["docs/trust/traceability.md", "docs/trust/loads.md", "docs/trust/errata.md"] {
        // The last cell of a row names tests only.
        let page = fs::read_to_string(root().join(page)).unwrap();
        let names = functions(&page);
        assert!(names.len() > 5);
        let is_test = |name: &str| {
            let definition = format!("fn {name}(");
            text.match_indices(&definition).any(|(at, _)| text[..at].trim_end().ends_with("#[test]"))
        };
        let held_by =
            page.lines().filter(|line| line.starts_with("| ")).filter_map(|line| line.rsplit(" | ").next());
        for name in held_by.flat_map(functions) {
            assert!(is_test(name), "{name} is no test");
        }
        for name in names.into_iter().filter(|name| !["standfast", "classify"].contains(name)) {
            let defined = [format!("fn {name}("), format!("fn {name}<")];
            assert!(defined.iter().any(|definition| text.contains(definition)), "no function {name}");
        }
    }
}

#[test]
fn every_equation_and_figure_has_a_row() {
    let page = fs::read_to_string(root().join("docs/trust/traceability.md")).unwrap();
    let listed: Vec<&str> = page
        .lines()
        .filter_map(|line| line.strip_prefix("| ")?.split(" | ").next())
        .flat_map(|cell| cell.split(", "))
        .collect();
    let chapters = [(3, 45), (4, 97)];
    for (chapter, last) in chapters {
        for equation in 1..=last {
            assert!(listed.contains(&format!("{chapter}.{equation}").as_str()), "({chapter}.{equation})");
        }
    }
    for figure in standfast_figures::FigureId::ALL {
        assert!(listed.contains(&figure.to_string().as_str()), "Fig. {figure}");
    }
}

/// Text is parsed in one place: a second reader of case files would be a second answer. Python's and xtask's own files are not cases.
#[test]
fn one_file_calls_the_parser_of_case_files() {
    fn calls(directory: &Path, found: &mut Vec<String>) {
        for entry in fs::read_dir(directory).unwrap().map(Result::unwrap) {
            let path = entry.path();
            if path.is_dir() && path.file_name().is_some_and(|name| name != "target" && name != "tests") {
                calls(&path, found);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let text = fs::read_to_string(&path).unwrap();
                let parsers = ["DeTable::parse", "toml::from_str", "toml::Table", "DocumentMut"];
                if parsers.iter().any(|parser| text.contains(parser)) {
                    found.push(path.strip_prefix(root()).unwrap().display().to_string());
                }
            }
        }
    }
    let mut found = Vec::new();
    ["crates", "python", "web"].iter().for_each(|directory| calls(&root().join(directory), &mut found));
    assert_eq!(found, ["crates/inputs/src/parse.rs"]);
}
