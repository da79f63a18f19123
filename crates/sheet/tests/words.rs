//! Words of a sheet on its case, and those that it leaves out.

mod common;

use std::collections::BTreeMap;

use common::{cases, document, html, is_of_joint, select, si};
use scraper::{ElementRef, Html};
use standfast::footprint::PlanLimit;
use standfast::{Departure, Mode};
use standfast_cases::assess::shown;
use standfast_cases::case::Limit;
use standfast_cases::{Assessment, AssessmentView, CaseFile, Document, Key};
use standfast_sheet::{Sheet, SheetOptions};

const RACK: &str = "title = \"Server rack\"\n[body]\nwidth = 0.6\nheight = 2\nmass = 900\nfriction = 0.4\n\
    [earthquake]\nhorizontal = \"0.25 g\"\n[[load]]\nname = \"push\"\nforce = 300\nelevation = 1.5\ntogether = true\n\
    [criteria]\nSF_sliding = 1.2\n";

/// Number of formulas with numbers of a quantity in a situation: at steps, or in its column beside others.
fn with_formula(html: &Html, situation: usize, symbol: &str) -> usize {
    let at_steps = format!("[data-load=\"{situation}\"] .step[data-symbol=\"{symbol}\"] .numbers");
    let rows = select(html, &format!("[data-table=together] tr[data-symbol=\"{symbol}\"]"));
    let of = scraper::Selector::parse(&format!("td[data-load=\"{situation}\"] data")).unwrap();
    let formula = scraper::Selector::parse("td.symbols math").unwrap();
    let in_column =
        rows.iter().filter(|row| row.select(&of).count() == 1 && row.select(&formula).count() > 1);
    select(html, &at_steps).len() + in_column.count()
}

fn text(html: &Html) -> String {
    select(html, "main")[0].text().collect::<Vec<_>>().join(" ")
}

#[test]
fn a_rack_on_a_floor_has_no_word_of_the_sea() {
    let words = text(&document("rack.toml", RACK));
    for word in [
        "mound",
        "armour",
        "scour",
        "pore",
        "overtop",
        "wave",
        "water",
        "sea",
        "Goda",
        "Takahashi",
        "Westergaard",
        "settlement of the mound",
        "soil",
    ] {
        let found = words.match_indices(word).next();
        let around = found.map(|(at, _)| words[..at].chars().rev().take(40).collect::<String>());
        assert!(
            found.is_none(),
            "{word} after {:?}",
            around.map(|text| text.chars().rev().collect::<String>())
        );
    }
    assert!(words.contains("floor or ground"));
    let (_, goda) = cases().into_iter().find(|(name, _)| name == "goda-2000.toml").unwrap();
    let words = text(&document("goda-2000.toml", &goda));
    for word in ["rubble mound", "armour", "overtopping", "pore pressure", "Takahashi"] {
        assert!(words.contains(word), "{word}");
    }
}

/// In the inputs and in the steps of one situation a symbol has one number; in a combination that changes numbers that of its own
/// steps. (That of the theorem it stands for is the author's to see.)
#[test]
fn every_symbol_stands_for_one_thing() {
    let mut symbols = 0;
    for (name, text) in cases() {
        let html = document(&name, &text);
        for joint in select(&html, "[data-joint]") {
            let mut known: BTreeMap<&str, f64> = BTreeMap::new();
            for step in joint.select(&".step[data-symbol]".try_into().unwrap()) {
                let (symbol, data) = (step.attr("data-symbol").unwrap(), ".result data".try_into().unwrap());
                let Some(value) = step.select(&data).next().and_then(|data| si(data, "value")) else {
                    continue;
                };
                let before = *known.entry(symbol).or_insert(value);
                let same = before == value || (before - value).abs() <= 1e-12 * before.abs();
                assert!(same, "{name}: {symbol} is {before} and {value}");
                symbols += 1;
            }
        }
        let inputs: Vec<_> = select(&html, "[data-table=inputs] tr[data-symbol]");
        let parts = select(&html, "section.part");
        let is_shared = |part: &ElementRef<'_>| part.attr("data-load").is_none();
        let shared: Vec<_> = parts.iter().copied().filter(is_shared).collect();
        let situations = parts.iter().copied().filter(|part| !is_shared(part)).map(Some);
        for situation in situations.chain([None]) {
            let mut known: BTreeMap<String, f64> = BTreeMap::new();
            let steps = shared.iter().copied().chain(situation);
            let steps = steps
                .flat_map(|part| part.select(&".step[data-symbol]".try_into().unwrap()).collect::<Vec<_>>())
                .filter(|step| !is_of_joint(*step));
            let of_situation = |element: &ElementRef<'_>| {
                let symbol = element.attr("data-symbol").unwrap_or_default();
                situation.is_some_and(|part| find_step(part, symbol))
            };
            let changes = situation.is_some_and(|part| {
                let text: String = part.text().collect();
                text.contains("Numbers of this combination")
            });
            let steps: Vec<_> = steps.collect();
            let given =
                inputs.iter().copied().chain(steps.iter().copied().filter(|step| is_shared_step(*step)));
            let given = given.filter(|element| !(changes && of_situation(element)));
            let own = steps.iter().copied().filter(|step| !is_shared_step(*step));
            for element in given.chain(own) {
                let symbol = element.attr("data-symbol").unwrap().to_owned();
                let data = element.select(&".result data, td.n data".try_into().unwrap()).next();
                let Some(value) = data.and_then(|data| si(data, "value")) else { continue };
                let value = match symbol.as_str() {
                    // An input in degrees whose unit stands in its key.
                    "β_g" | "Δβ" if value > 1.0 => value.to_radians(),
                    _ => value,
                };
                if symbol.is_empty() {
                    continue;
                }
                let before = *known.entry(symbol.clone()).or_insert(value);
                let same = (before - value).abs() <= 1e-12 * before.abs() || before == value;
                assert!(same, "{name}: {symbol} is {before} and {value}");
                symbols += 1;
            }
        }
    }
    assert!(symbols > 2000, "{symbols}");
}

/// True if a part of the calculation has a step of a symbol.
fn find_step(part: ElementRef<'_>, symbol: &str) -> bool {
    let mut steps = part.select(&".step[data-symbol]".try_into().unwrap()).collect::<Vec<_>>().into_iter();
    steps.any(|step| step.attr("data-symbol") == Some(symbol))
}

/// True of a step that stands before all situations.
fn is_shared_step(step: ElementRef<'_>) -> bool {
    let mut above = step.ancestors().filter_map(ElementRef::wrap);
    above.all(|element| element.attr("data-load").is_none())
}

/// Departures from rest have a formula that gives the load factor; slides have friction as a step.
#[test]
fn departure_and_friction_are_steps_with_formulas() {
    let (mut departures, mut slides) = (0, 0);
    for (name, text) in cases() {
        let case = CaseFile::parse(&name, &text).unwrap().case().unwrap();
        let assessment = Assessment::of(&case).unwrap();
        let html = document(&name, &text);
        for assessed in shown(&assessment, &AssessmentView::default()) {
            let of = |symbol: &str| with_formula(&html, assessed.index, symbol);
            let departs = matches!(assessed.departure(), Departure::At { .. });
            // What holds a body beside friction is searched for, not solved for.
            let departs = departs && assessed.outcome.held.is_none();
            // Nor is where a disc begins to turn.
            let plan = assessed.outcome.plan.as_ref();
            let turns = plan.is_some_and(|plan| plan.departure.limits.contains(&PlanLimit::Turns));
            let departs = departs && !turns;
            assert_eq!(of("λ_d"), usize::from(departs), "{name}");
            departures += usize::from(departs);
            let slides_here = matches!(assessed.mode(), Some(Mode::SlideLeft | Mode::SlideRight))
                && assessed.situation.kinetic_friction() > 0.0;
            if slides_here {
                assert_eq!(of("f_x"), 1, "{name}");
                slides += 1;
            }
        }
    }
    assert!(departures > 20 && slides > 3, "{departures} {slides}");
}

/// Bearing of the base is told by formulas: the quadratic of one that crushes, R/V = 1 put in where ground fails, both
/// modes of loads in time.
#[test]
fn what_the_base_bears_has_formulas() {
    let mut counts = [0; 4];
    for (name, text) in cases() {
        let case = CaseFile::parse(&name, &text).unwrap().case().unwrap();
        let assessment = Assessment::of(&case).unwrap();
        let html = document(&name, &text);
        for assessed in shown(&assessment, &AssessmentView::default()) {
            let Some(ground) = assessed.ground.as_ref().filter(|ground| ground.reaction.is_some()) else {
                continue;
            };
            let of = |symbol: &str| with_formula(&html, assessed.index, symbol);
            let real = |factor: f64| factor > 0.0 && factor.is_finite();
            let factor = ground.load_factors.is_some_and(|factors| real(factors.given));
            let impact = ground.elastic.as_ref().and_then(|elastic| elastic.impact.as_ref());
            let told = match ground.limit {
                Some(Limit::Strength(_)) => {
                    [("λ_R", factor), ("k_BF", ground.k_bf.is_some_and(f64::is_finite))]
                }
                Some(Limit::Ground(_)) => [("F_RR", factor), ("F_Rk", ground.k_bf.is_some_and(real))],
                None => {
                    let one = !name.starts_with("springs under loads of two courses");
                    let has = |factor: Option<f64>| factor.is_some() && one;
                    [
                        ("D_X", has(impact.and_then(|i| i.d_shear))),
                        ("D_M", has(impact.and_then(|i| i.d_moment))),
                    ]
                }
            };
            for (symbol, is_there) in told {
                assert_eq!(of(symbol), usize::from(is_there), "{name}: {symbol}");
            }
            let kind = [
                factor && ground.omega.is_some(),
                factor && ground.omega.is_none(),
                told[1].1,
                impact.is_some(),
            ];
            counts.iter_mut().zip(kind).for_each(|(count, is)| *count += usize::from(is));
        }
    }
    assert!(counts.iter().all(|count| *count > 2), "{counts:?}");
}

#[test]
fn a_body_at_rest_has_no_motion_of_zeros() {
    let rest =
        "[body]\nwidth = 6\nheight = 7\nmass = 1e5\nfriction = 0.6\n[[load]]\nforce = 1e5\nelevation = 3\n";
    let page = document("rest.toml", rest);
    let rows = select(&page, "[data-table=motion] tbody tr");
    let quantities: Vec<_> = select(&page, "[data-table=motion] data")
        .iter()
        .map(|data| data.attr("data-quantity").unwrap().to_owned())
        .collect();
    assert_eq!(quantities, ["motion.f_x", "motion.f_y", "motion.xi"]);
    assert_eq!(rows.len(), 3);
}

#[test]
fn the_title_block_has_the_files_words_and_the_command_lines_before_them() {
    let head = "project = \"Harbour\"\nclient = 'Port & <Co>'\nsheet = \"C-104\"\nrevision = \"A\"\nauthor = \"A. Moreau\"\nchecker = \"N. Okafor\"\n";
    let case = format!("{head}{}", &RACK[RACK.find("[body]").unwrap()..]);
    let cells = |page: &Html| {
        let cells = select(page, "header.title .block td").into_iter();
        cells.map(|cell| cell.text().collect::<String>()).take(6).collect::<Vec<_>>()
    };
    let page = document("rack.toml", &case);
    assert_eq!(cells(&page), ["Harbour", "Port & <Co>", "C-104", "A", "A. Moreau", "N. Okafor"]);
    let style = html("rack.toml", &case);
    for running in [
        "Harbour · Port \\26  \\3c Co\\3e ",
        "Sheet C-104 · Revision A",
        "Author A. Moreau · Checker N. Okafor",
    ] {
        assert!(style.contains(running), "{running}");
    }
    // No row of inputs has them again.
    assert!(!select(&page, "[data-table=inputs] code").iter().any(|code| code.inner_html() == "client"));
    let title_block = vec![(Key::Revision, "B".to_owned()), (Key::Checker, " ".to_owned())];
    let options = SheetOptions { title_block, ..SheetOptions::default() };
    let sheet = Sheet::of("rack.toml", &case, &options).unwrap();
    let page = Html::parse_document(sheet.html());
    assert_eq!(cells(&page), ["Harbour", "Port & <Co>", "C-104", "B", "A. Moreau", ""]);
}

#[test]
fn every_sheet_has_its_section_and_its_sources() {
    for (name, text) in cases() {
        let page = document(&name, &text);
        assert_eq!(select(&page, "figure.section svg").len(), 1, "{name}");
        let sources: String = select(&page, ".references li").iter().flat_map(|item| item.text()).collect();
        assert!(sources.contains("Shenton") && sources.contains("690–693"), "{name}");
        let by_goda = text.contains("[wave]") && !text.contains("\nformula = ");
        assert_eq!(sources.contains("World Scientific"), by_goda, "{name}");
        // Which of them were read, the book says.
        assert!(!sources.contains("not read") && !sources.contains("recalled"), "{name}");
        let case = CaseFile::parse(&name, &text).unwrap().case().unwrap();
        let figures = Assessment::of(&case).unwrap().figures(&AssessmentView::default()).unwrap();
        assert_eq!(figures.iter().filter(|figure| figure.is_section()).count(), 1);
    }
}

/// On a boundary a sheet says what `assess` does: of decimals, that it is exactly there, and no margin of rounding; of numbers that are
/// known to some digits, that the answer is not told by them.
#[test]
fn a_body_on_a_boundary_is_said_to_be_there() {
    let exact = "[body]\nwidth = 3\nheight = 5\ndensity = 2400\nfriction = 50\n[[load]]\nforce = 264870\nelevation = 2\n";
    let words = text(&document("exact.toml", exact));
    assert!(words.contains("exactly on the boundary"), "{words}");
    assert!(!words.contains("The answer is unique."), "{words}");
    let words = words.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words.contains("holds by 0 ") && !words.contains("10 −1"), "{words}");
    let mass = 2400.0 * std::f64::consts::PI * 2.25 * 5.0;
    let drum = format!(
        "[body]\nshape = \"cylinder\"\nwidth = 3\nheight = 5\ndensity = 2400\nfriction = 0.5\n[[load]]\nforce = {}\nelevation = 0.1\n",
        0.5 * mass * 9.81
    );
    let words = text(&document("drum.toml", &drum));
    assert!(words.contains("To the digits given") && !words.contains("The answer is unique"), "{words}");
}

/// The assumptions do not say that friction has no factor where a combination divides it.
#[test]
fn assumptions_hold_where_a_combination_divides_the_friction() {
    const NO_FACTOR: &str = "its inertia and the friction carry no factor";
    let case = |line: &str| {
        let case = format!(
            "[body]\nwidth = 12\nheight = 10\nmass = 270000\nfriction = 0.6\n\
             [[load]]\nname = \"push\"\nforce = 5e5\nelevation = 6\n\
             [[combination]]\nfactors = {{ push = 1.5 }}\n{line}"
        );
        text(&document("divided.toml", &case))
    };
    assert!(case("").contains(NO_FACTOR));
    let divided = case("materials = { friction = 1.25 }\n");
    assert!(!divided.contains(NO_FACTOR));
    assert!(divided.contains("What a combination changes besides stands at its head."));
}
