//! The sheet of a case in time: what the program answers stands there.

use scraper::{Html, Selector};
use standfast_cases::layout::{digits, significant};
use standfast_cases::motion::{Factors, Follow, FollowedMotion, StrengthAsked};
use standfast_cases::{Assessment, CaseFile, Document, Portion};
use standfast_sheet::{Sheet, SheetOptions};

const CAISSON: &str = include_str!("../../../examples/motion/caisson-breaking-wave.toml");

/// What a sheet asks of a motion.
fn follow() -> Follow {
    Follow {
        series: true,
        divergence: true,
        strength: StrengthAsked::IfShort(Factors::Rungs),
        ..Follow::default()
    }
}

/// The cells of a table of the sheet, row by row.
fn table(page: &Html, name: &str) -> Vec<Vec<String>> {
    let rows = Selector::parse(&format!("table[data-table={name}] tbody tr")).unwrap();
    let cells = Selector::parse("td").unwrap();
    let cell = |cell: scraper::ElementRef<'_>| cell.text().collect::<String>().trim().to_owned();
    page.select(&rows).map(|row| row.select(&cells).map(cell).collect()).collect()
}

fn number(text: &str) -> f64 {
    text.split(' ').next().unwrap().replace('−', "-").parse().unwrap_or_else(|_| panic!("{text}"))
}

#[test]
fn the_sheet_has_what_becomes_of_the_body() {
    let text = format!("{CAISSON}\n[criteria]\nslide = \"8 cm\"\noverturned = false\n");
    let file = CaseFile::parse("case.toml", &text).unwrap();
    let html = Sheet::of_file(&file, &SheetOptions::default(), Portion::UNSEEN).unwrap().html().to_owned();
    assert_eq!(Sheet::of_file(&file, &SheetOptions::default(), Portion::UNSEEN).unwrap().html(), html);
    let page = Html::parse_document(&html);
    let answers = FollowedMotion::of_file(&file, &Follow::default()).unwrap();
    let outcome = &answers[0].outcome;
    let near = |found: f64, expected: f64| {
        // As it is printed, to four digits.
        assert_eq!(found, digits(expected).parse::<f64>().unwrap());
    };
    let results = table(&page, "in-time-results");
    for (row, expected) in results.iter().zip([
        outcome.slide.abs(),
        outcome.max_slide,
        outcome.max_theta,
        outcome.theta,
        outcome.impacts as f64,
    ]) {
        near(number(&row[1]), expected);
    }
    assert_eq!(results.len(), 5);
    let energy = table(&page, "in-time-energy");
    let terms =
        [outcome.work, outcome.friction_loss, outcome.impact_loss, outcome.kinetic, outcome.potential];
    energy.iter().zip(terms).for_each(|(row, expected)| near(number(&row[1]), expected));
    let events = table(&page, "in-time-events");
    assert_eq!(events.len(), outcome.events.len());
    for (row, event) in events.iter().zip(&outcome.events) {
        assert_eq!(row[0].strip_prefix("t = ").unwrap(), format!("{} s", significant(event.t, 4)));
        assert_eq!((row[1].as_str(), row[2].as_str()), (event.why.words(), event.state.symbol()));
    }
    // Thrust and uplift as published, 940.68 and 493.04 kN/m (validation/goda.toml), times 1.5; buoyancy, the weight m g = 3394.75 kN/m less the buoyant one, 2318.64 kN/m.
    let peaks = table(&page, "in-time-peaks");
    let down: Vec<f64> = peaks.iter().map(|row| number(&row[2])).collect();
    let left: Vec<f64> = peaks.iter().map(|row| number(&row[1])).collect();
    assert_eq!((down[0], left[0]), (-1076.0, 0.0));
    assert!(
        (left[1] / 1.5 - 940.68).abs() < 0.5 && (-down[2] / 1.5 - 493.04).abs() < 0.5,
        "{left:?} {down:?}"
    );
    // The file's own bytes are hashed, and its lines in time stand there.
    let written = page.select(&Selector::parse("pre[data-table=in-time]").unwrap()).next().unwrap();
    let written = written.text().collect::<String>();
    assert!(
        written.contains("history = { shape = \"triangle\"") && written.contains("slide = \"8 cm\""),
        "{written}"
    );
    let plain = Sheet::of("case.toml", &text.replace("\nhistory", "\n#history"), &SheetOptions::default());
    assert!(plain.is_err(), "a criterion of the motion without any");
    let criteria = table(&page, "criteria");
    assert_eq!(criteria.len(), 2);
    assert!(
        criteria[0][0].contains("slide") && criteria[0][4] == "not met" && criteria[1][4] == "met",
        "{criteria:?}"
    );
    let headings: Vec<String> =
        page.select(&Selector::parse("h2").unwrap()).map(|h| h.text().collect::<String>()).collect();
    let numbered: Vec<&str> =
        headings.iter().filter_map(|h| h.split_once(' ')).map(|(n, _)| n).filter(|n| n.len() == 1).collect();
    assert_eq!(numbered, ["1", "2", "3", "4", "5", "6", "7", "8", "9"]);
    // Page 1 has the lines of `standfast simulate`, and behind them those of the first instant.
    let lines: Vec<String> = page
        .select(&Selector::parse(".summary p.verdict, .summary p.near").unwrap())
        .map(|line| line.text().collect::<String>())
        .collect();
    let assessment = Assessment::following(&file, Some(&follow()), Portion::UNSEEN).unwrap();
    let motion = assessment.in_time.as_ref().unwrap().motions.summary().unwrap();
    let tops = [motion, assessment.summary().unwrap()];
    let expected: Vec<String> =
        tops.into_iter().flat_map(|top| [top.criteria, Some(top.answer), top.near]).flatten().collect();
    assert_eq!(lines, expected);
    assert!(headings.contains(&"5 Motion in time".to_owned()));
    let captions: Vec<String> = page
        .select(&Selector::parse("figcaption").unwrap())
        .map(|caption| caption.text().collect::<String>())
        .collect();
    for (i, caption) in captions.iter().enumerate() {
        assert!(caption.starts_with(&format!("Figure {}. ", i + 1)), "{captions:?}");
    }
    assert!(
        captions.iter().any(|c| c.contains("Histories")) && !captions.iter().any(|c| c.contains("Animation"))
    );
}

/// A body on a base that moves has its peak there, and needs no load.
#[test]
fn a_shaken_body_has_a_sheet() {
    let text = "[body]\nwidth = 0.6\nheight = 2.4\ndensity = 2600\nfriction = 0.5\n[motion.base]\n\
        horizontal = { shape = \"half-sine\", peak = \"0.3 g\", duration = \"0.5 s\" }\n";
    let html = Sheet::of("case.toml", text, &SheetOptions::default()).unwrap().html().to_owned();
    // 0.3 · 9.81 m/s².
    assert!(html.contains("reaches 2.943 m/s², 0.3 of gravity"), "the peak of the base");
    assert!(
        !Html::parse_document(&html)
            .select(&Selector::parse("pre").unwrap())
            .next()
            .unwrap()
            .text()
            .collect::<String>()
            .is_empty()
    );
}
