//! Figures on paper, and the sheet of one page.

mod common;

use std::path::{Path, PathBuf};

use common::{html, select};
use scraper::{ElementRef, Html, Selector};
use standfast_cases::{Assessment, CaseFile, Document, Portion};
use standfast_sheet::{Sheet, SheetOptions};

/// Sheets of every example that has one, in full and in short; a life of storms, which takes long, is left to other tests.
fn examples() -> Vec<(String, CaseFile)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let mut paths: Vec<PathBuf> = ["", "joints", "motion", "probability"]
        .iter()
        .flat_map(|folder| std::fs::read_dir(root.join(folder)).unwrap().map(|entry| entry.unwrap().path()))
        .filter(|path| path.extension().is_some_and(|extension| extension == "toml"))
        .filter(|path| !path.ends_with("goda-2000-storm.toml"))
        .collect();
    paths.sort();
    let read = |path: PathBuf| {
        let folder = path.parent().unwrap().to_owned();
        let beside =
            move |name: &str| std::fs::read_to_string(folder.join(name)).map_err(|error| error.to_string());
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let file = CaseFile::read(&name, &std::fs::read_to_string(&path).unwrap(), &beside).unwrap();
        (name, file)
    };
    paths.into_iter().map(read).collect()
}

fn sheet(file: &CaseFile, short: bool) -> Option<String> {
    let options = SheetOptions { short, ..SheetOptions::default() };
    Sheet::of_file(file, &options, Portion::UNSEEN).ok().map(|sheet| sheet.html().to_owned())
}

/// Number behind some text, as far as digits go.
fn behind(text: &str, mark: &str) -> f64 {
    let rest = text.split_once(mark).unwrap_or_else(|| panic!("no {mark}")).1;
    let end = rest.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(rest.len());
    rest[..end].parse().unwrap()
}

/// 6 pt are 8 pixels of 96 to the inch. A page of A4 with the margins of the sheet has 178 mm for the text.
#[test]
fn no_letter_of_a_figure_is_printed_under_six_points() {
    let (mut figures, mut letters) = (0, 0);
    for (name, file) in examples() {
        for page in [sheet(&file, false), sheet(&file, true)].into_iter().flatten() {
            let style = page.split_once("<style>").unwrap().1.split_once("</style>").unwrap().0;
            let margin = style.rsplit_once("margin: 19mm 14mm 16mm 18mm").is_some();
            assert!(margin, "the margins of this test are others");
            for drawn in page.split("<figure").skip(1) {
                let drawn = drawn.split_once("</figure>").unwrap().0;
                let id = drawn.split_once("id=\"").unwrap().1.split_once('"').unwrap().0.to_owned();
                let printed = behind(style, &format!("#{id} svg{{width:"));
                assert!(printed <= (210.0 - 14.0 - 18.0) / 25.4 * 96.0, "{name}, {id}: wider than the page");
                let scale = printed / behind(drawn, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"");
                for run in drawn.split(" scale(").skip(1) {
                    let size = 1000.0 * behind(&format!("({run}"), "(");
                    // Widths are whole pixels.
                    assert!(size * scale >= 7.98, "{name}, {id}: type of {} pt", 0.75 * size * scale);
                    letters += 1;
                }
                figures += 1;
            }
        }
    }
    assert!(figures > 90 && letters > 5000, "{figures} {letters}");
}

/// Numbers of a page: in `data`, and as words of tables.
fn numbers(page: &Html, selector: &str) -> Vec<f64> {
    select(page, selector).into_iter().map(|data| data.attr("value").unwrap().parse().unwrap()).collect()
}

fn words(page: &Html, selector: &str) -> Vec<String> {
    select(page, selector).into_iter().map(|found| found.text().collect::<String>()).collect()
}

/// Numbers that a text shows.
fn shown(text: &str) -> Vec<f64> {
    text.replace('−', "-")
        .split([' ', '\u{a0}', '·', ';', ','])
        .filter_map(|word| word.parse().ok())
        .collect()
}

#[test]
fn every_number_of_the_short_sheet_is_one_of_the_full_sheet() {
    let mut compared = 0;
    for (name, file) in examples() {
        let (Some(long), Some(short)) = (sheet(&file, false), sheet(&file, true)) else { continue };
        let [long, short] = [long, short].map(|page| Html::parse_document(&page));
        // The same lines on top, the same section, the same hashes.
        let lines = ".summary p.verdict, .summary p.near";
        assert_eq!(words(&short, lines), words(&long, lines), "{name}");
        assert_eq!(words(&short, "td.hash"), words(&long, "td.hash"), "{name}");
        let section = |page: &Html| select(page, "figure.section svg")[0].html();
        assert_eq!(section(&short), section(&long), "{name}");
        let known = numbers(&long, "data[value]");
        for number in numbers(&short, "data[value]") {
            assert!(known.contains(&number), "{name}: {number}");
            compared += 1;
        }
        // Values and utilisations of each criterion in each situation are those of the JSON.
        let json = Assessment::of_file(&file).map(|found| found.json(&Default::default(), &[])).unwrap();
        let json: serde_json::Value = serde_json::from_str(&json).unwrap();
        let mut used: Vec<f64> = Vec::new();
        for situation in json["situations"].as_array().unwrap() {
            used.extend(
                situation["criteria"]
                    .as_array()
                    .unwrap()
                    .iter()
                    .filter_map(|one| one["utilisation"].as_f64()),
            );
        }
        let rows: String = words(&short, "[data-table=criteria] tbody tr td.n").join(" ; ");
        let rows = shown(&rows);
        if select(&short, "[data-left]").is_empty() && json["in_time"].is_null() {
            for used in used.into_iter().filter(|used| *used > 0.0) {
                assert!(
                    rows.iter().any(|shown| (shown / used - 1.0).abs() < 5e-4),
                    "{name}: {used} in {rows:?}"
                );
                compared += 1;
            }
        }
    }
    assert!(compared > 250, "{compared}");
}

/// Rows without room are counted, and it is said where they stand; no row is left out where there is room.
#[test]
fn rows_without_room_are_counted() {
    let loads = |count: usize| -> String {
        let one = |i| {
            format!(
                "[[combination]]\nname = \"number {i}\"\nfactors = {{ push = {} }}\n",
                1.0 + 0.01 * f64::from(i)
            )
        };
        (1..=count as i32).map(one).collect()
    };
    let case = |count| {
        format!(
            "[body]\nwidth = 6\nheight = 7\nmass = 100e3\nfriction = 0.6\n[[load]]\nname = \"push\"\nforce = 90e3\nelevation = 3\n{}[criteria]\n\
             SF_sliding = 1.2\nSF_overturning_net = 1.5\n",
            loads(count)
        )
    };
    for (count, all) in [(2, 4), (4, 8), (7, 14), (40, 80)] {
        let file = CaseFile::parse("case.toml", &case(count)).unwrap();
        let page = Html::parse_document(&sheet(&file, true).unwrap());
        let left = select(&page, "[data-left]")
            .first()
            .map_or(0, |left| left.attr("data-left").unwrap().parse().unwrap());
        let across = select(&page, "table.across").len();
        let cells = words(&page, "[data-table=criteria] span.yes, [data-table=criteria] span.no").len();
        assert_eq!(cells + left, all, "{count}");
        assert_eq!(across, usize::from(count <= 4));
        assert_eq!(left > 0, count == 40, "{count}: {left}");
        let said = words(&page, "[data-left]").concat();
        assert!(
            left == 0
                || said.contains(&format!("{left} of {all} rows"))
                    && said.contains("section 3 of the full sheet"),
            "{said}"
        );
        // What is used most stands first.
        let first: Vec<ElementRef<'_>> = select(&page, "[data-table=criteria] tbody tr");
        let used = first[0]
            .select(&Selector::parse("td.n").unwrap())
            .map(|cell| cell.text().collect::<String>())
            .collect::<Vec<_>>();
        assert!(!used.is_empty());
    }
}

/// What a record leaves the ground with has its units.
#[test]
fn a_drift_has_units() {
    let (_, file) = examples().into_iter().find(|(name, _)| name == "server-rack-earthquake.toml").unwrap();
    let page = sheet(&file, false).unwrap();
    let told: Vec<&str> = page.split("ends with a velocity of ").skip(1).collect();
    assert_eq!(told.len(), 2);
    for told in told {
        let told = told.split_once(" of the ground").unwrap().0;
        let (velocity, displacement) = told.split_once(" m/s and a displacement of ").unwrap();
        assert!(velocity.parse::<f64>().is_ok(), "{told}");
        assert!(displacement.strip_suffix(" m").unwrap().parse::<f64>().is_ok(), "{told}");
    }
}

/// A body and its section stand on a sheet; a block in numbers of its own, and a point of the plane, have none.
#[test]
fn what_has_no_body_has_no_short_sheet() {
    let block = "[block]\nwidth = 1\n";
    assert!(CaseFile::parse("case.toml", block).and_then(|file| file.case().map(|_| ())).is_err());
    for (name, file) in examples() {
        let named = [
            "block-base-pulse.toml",
            "block-under-a-record.toml",
            "marble-column-earthquake.toml",
            "plane-random.toml",
        ];
        let (long, short) = (sheet(&file, false), sheet(&file, true));
        assert_eq!(long.is_some(), !named.contains(&name.as_str()), "{name}");
        assert_eq!(long.is_some(), short.is_some(), "{name}");
        if short.is_none() {
            let options = SheetOptions { short: true, ..SheetOptions::default() };
            let error = Sheet::of_file(&file, &options, Portion::UNSEEN).unwrap_err().to_string();
            assert!(error.contains("[block]") || error.contains("[point]"), "{error}");
        }
    }
}

/// A long note and words on the title block fit, too: the note ends at a sentence, and says so.
#[test]
fn a_long_note_is_cut_at_a_sentence() {
    let note = "This sentence is told. ".repeat(40);
    let text = format!(
        "note = '{note}'\n[body]\nwidth = 6\nheight = 7\nmass = 1e5\nfriction = 0.6\n[[load]]\nforce = 1e5\nelevation = 3\n"
    );
    let file = CaseFile::parse("case.toml", &text).unwrap();
    let page = Html::parse_document(&sheet(&file, true).unwrap());
    let said = words(&page, "header .source").concat();
    assert!(said.ends_with("told. (The note goes on in the case file.)") && said.len() < 400, "{said}");
    assert!(html("case.toml", &text).contains(note.trim()));
}

/// Where the ground fails before the body moves, inputs are ranked by the load factor of the ground, of which friction has no part.
#[test]
fn on_ground_inputs_are_ranked_by_the_ground() {
    let text = "[body]\nwidth = 6\nheight = 4\nmass = 5e4\nfriction = 0.9\n[ground]\nfriction_angle_deg = 30\nunit_weight = 10e3\n\
                [[load]]\nforce = 60e3\nelevation = 2\n";
    let file = CaseFile::parse("case.toml", text).unwrap();
    let page = Html::parse_document(&sheet(&file, true).unwrap());
    let inputs = words(&page, "table[data-table='deciding'] td code").concat();
    assert!(inputs.starts_with("ground.friction_angle_deg") && !inputs.contains("body.friction"), "{inputs}");
}
