//! Situations beside each other: each formula once, and a column of values from which a reader works out its result.

mod common;

use common::{Names, cases, document, evaluate_with, letters, select, si};
use scraper::{ElementRef, Html, Selector};

fn find<'a>(element: ElementRef<'a>, selector: &str) -> Vec<ElementRef<'a>> {
    element.select(&Selector::parse(selector).unwrap()).collect()
}

fn written(element: ElementRef<'_>) -> String {
    element.text().collect()
}

/// The symbols of a formula in their order.
fn symbols(element: ElementRef<'_>, found: &mut Vec<String>) {
    for child in element.children().filter_map(ElementRef::wrap) {
        let functions = ["sin", "cos", "tan", "sinh", "cosh", "tanh", "exp", "min", "max", "π"];
        match letters(child).filter(|name| !functions.contains(&name.as_str())) {
            Some(name) => found.push(name),
            None => symbols(child, found),
        }
    }
}

/// What the steps in full tell: results, and the numbers put in for symbols, which stand in the same order.
fn known(html: &Html) -> Names {
    let mut names = Names::new();
    for step in select(html, ".step") {
        let mut read = Vec::new();
        find(step, ".symbols").into_iter().for_each(|formula| symbols(formula, &mut read));
        let numbers = find(step, ".numbers [data-value]");
        if read.len() == numbers.len() {
            for (name, number) in read.into_iter().zip(numbers) {
                let above = number.parent().and_then(ElementRef::wrap).unwrap();
                let negative = find(above, "mo[form=prefix]").iter().any(|sign| written(*sign) == "−")
                    && above.value().name() == "mrow";
                let value = si(number, "data-value").unwrap();
                names.insert(name, if negative { -value } else { value });
            }
        }
        let symbol = find(step, ".left math").first().map(|symbol| written(*symbol));
        let result = find(step, ".result data").first().and_then(|data| si(*data, "value"));
        if let (Some(symbol), Some(result), Some(_)) = (symbol, result, step.attr("data-symbol")) {
            names.insert(symbol, result);
        }
    }
    for row in select(html, "[data-table=inputs] tr[data-symbol]") {
        let symbol = find(row, "td:nth-child(2) math").first().map(|symbol| written(*symbol));
        let value = find(row, "td.n data").first().and_then(|data| si(*data, "value"));
        if let (Some(symbol), Some(value)) = (symbol, value) {
            names.entry(symbol).or_insert(value);
        }
    }
    names
}

/// Every result of a column follows by the row's formula from the column, or from what is the same in the calculation in full.
#[test]
fn every_column_can_be_followed() {
    let (mut evaluated, mut columns) = (0, 0);
    for (name, text) in cases() {
        let html = document(&name, &text);
        let full = known(&html);
        let heads = select(&html, "[data-table=together] thead th[data-load]");
        for head in heads {
            let load = head.attr("data-load").unwrap();
            let rows = select(&html, "[data-table=together] tbody tr[data-symbol]");
            let cell = |row: &ElementRef<'_>| {
                find(*row, &format!("td[data-load=\"{load}\"] data"))
                    .first()
                    .and_then(|data| si(*data, "value"))
            };
            let symbol =
                |row: &ElementRef<'_>| find(*row, "td.symbols > math").first().map(|math| written(*math));
            let mut names = full.clone();
            for row in &rows {
                if let (Some(symbol), Some(value)) = (symbol(row), cell(row)) {
                    names.insert(symbol, value);
                }
            }
            for row in rows {
                let Some(value) = cell(&row) else { continue };
                let math = find(row, "td.symbols math");
                let from = math.iter().position(|math| written(*math).starts_with('='));
                let Some(from) = from else { continue };
                let (result, scale) = evaluate_with(&math[from..], &names).unwrap();
                let error = if result == value { 0.0 } else { (result - value).abs() };
                assert!(
                    error <= 1e-9 * value.abs().max(scale),
                    "{name}, situation {load}: {} is {result}, and {value} is shown",
                    written(find(row, "td.symbols")[0])
                );
                evaluated += 1;
            }
            columns += 1;
        }
    }
    assert!(evaluated > 150 && columns > 4, "{evaluated} {columns}");
}

/// In full stand the situations in which a criterion is met worst, or the worst where there is no criterion.
#[test]
fn what_governs_is_calculated_in_full() {
    let parts = |file: &str| {
        let (name, text) = cases().into_iter().find(|(name, _)| name == file).unwrap();
        let html = document(&name, &text);
        let full: Vec<String> = select(&html, "section.part[data-load]")
            .iter()
            .map(|part| part.attr("data-load").unwrap().to_owned())
            .collect();
        let others: Vec<String> = select(&html, "[data-table=together] thead th[data-load]")
            .iter()
            .map(|part| part.attr("data-load").unwrap().to_owned())
            .collect();
        (full, others)
    };
    // The third combination lowers the weight: it governs all four criteria.
    assert_eq!(parts("quay.toml"), (vec!["2".to_owned()], vec!["1".to_owned(), "0".to_owned()]));
    // No criteria: the low blow moves the block at the least share.
    assert_eq!(parts("block-two-loads.toml").0.len(), 1);
    assert_eq!(parts("goda-2000.toml"), (vec!["0".to_owned()], vec![]));
}

/// The factors of all loads stand in one table, those that no combination names among them: of weight and water of the quay 1 each.
#[test]
fn factors_of_all_loads_stand_in_one_table() {
    let (name, text) = cases().into_iter().find(|(name, _)| name == "quay.toml").unwrap();
    let html = document(&name, &text);
    let rows = select(&html, "[data-table=factors] tbody tr");
    let cells = |row: &ElementRef<'_>| find(*row, "td").into_iter().map(written).collect::<Vec<_>>();
    let rows: Vec<_> = rows.iter().map(cells).collect();
    let expected = [
        ["weight m g", "permanent", "0.95", "1", "1"],
        ["buoyancy", "permanent", "1", "1", "1"],
        ["still water on the sides", "permanent", "1", "1", "1"],
        ["backfill", "permanent", "1.1", "1.1", "1"],
        ["surcharge", "variable", "1.3", "1.3", "1"],
        ["bollard", "variable", "1.3", "1.3", "1"],
        ["crane", "variable", "–", "–", "1"],
    ];
    assert_eq!(rows, expected);
    let changes = document(
        "goda-2000.toml",
        &cases().into_iter().find(|(name, _)| name == "goda-2000.toml").unwrap().1,
    );
    // No column without numbers: a force is told of a lone force in air only.
    assert_eq!(select(&changes, "[data-table=changes] thead th").len(), 3);
}
