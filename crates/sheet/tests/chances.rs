//! The section of probabilities: that its numbers are those of the answer, and that there is none where nothing is random.

mod common;

use standfast_cases::random::{ChanceRequest, Probability};
use standfast_cases::{CaseFile, Document};
use standfast_sheet::{Sheet, SheetOptions};

const BLOCK: &str = "[body]\nwidth = 12\nheight = 3\nmass = 60e3\nfriction = 0.5\n[[load]]\nname = \"push\"\nforce = 230e3\n\
    elevation = 0.5\n[[load]]\nname = \"other\"\nforce = 210e3\nelevation = 0.5\n";
const RANDOM: &str = "[random]\nfriction = { normal = { cov = 0.1 } }\nbias.force = { lognormal = { cov = 0.15 } }\n\
    [[random.correlation]]\nbetween = [\"friction\", \"bias.force\"]\nrank = 0.2\n";

fn html(text: &str) -> String {
    Sheet::of("case.toml", text, &SheetOptions::default()).unwrap().html().to_owned()
}

#[test]
fn the_section_has_the_numbers_of_the_answer() {
    let text = format!("{BLOCK}[criteria]\np_not_rest = 0.01\n{RANDOM}");
    let page = scraper::Html::parse_document(&html(&text));
    let answer =
        Probability::of(&CaseFile::parse("case.toml", &text).unwrap(), ChanceRequest::default()).unwrap();
    let select = |css: &str| {
        let selector = scraper::Selector::parse(css).unwrap();
        page.select(&selector).map(|found| found.text().collect::<String>()).collect::<Vec<_>>()
    };
    assert!(
        select("h2").contains(&"6 Probability".to_owned())
            && select("h2").contains(&"8 Signatures".to_owned())
    );
    let selector = scraper::Selector::parse("data").unwrap();
    let shown: Vec<f64> =
        page.select(&selector).filter_map(|data| data.attr("value")?.parse().ok()).collect();
    let worst = &answer.situations[0];
    let mut expected = vec![worst.not_rest.value, worst.design_point.as_ref().unwrap().beta];
    expected.extend(worst.known.iter().map(|known| known.value));
    expected.extend(answer.situations.iter().map(|chances| chances.not_rest.value));
    expected.push(answer.joined.unwrap().not_rest.value);
    expected.push(answer.criteria[0].counted);
    for number in expected {
        assert!(shown.contains(&number), "{number} is not on the sheet");
    }
    let laws = select("table[data-table=laws] td").join("|");
    assert!(laws.contains("friction|normal, cov 0.1|once|bias.force|lognormal, cov 0.15|once"), "{laws}");
    let words = select("section").join(" ");
    assert!(words.contains("ranks, Spearman's") && words.contains("only approximates the probability above"));
}

/// What is asked besides stands there too: any of a row, the rise of the water, means and deviations in the units of the page.
#[test]
fn what_is_asked_besides_is_on_the_sheet() {
    let text = "[body]\nwidth = 6\nheight = 5\nmass = 60e3\nfriction = 0.5\n[water]\nlevel = 2\ndensity = 1000\n\
                [[load]]\nname = \"push\"\nforce = 150e3\nelevation = 1\n[random]\nyears = 40\nrise_per_year = \"20 mm\"\n\
                bodies = 4\nsensitivities = true\nfriction = { normal = { mean = 0.5, sd = 0.05 }, each = \"body\" }\n\
                \"load.push.force\" = { normal = { mean = 150e3, sd = 15e3 }, every = \"year\" }\n";
    let answer =
        Probability::of(&CaseFile::parse("case.toml", text).unwrap(), ChanceRequest::default()).unwrap();
    let page = scraper::Html::parse_document(&html(text));
    let cells = |css: &str| {
        let selector = scraper::Selector::parse(css).unwrap();
        page.select(&selector).map(|found| found.text().collect::<String>()).collect::<Vec<_>>().join("|")
    };
    assert!(cells("table[data-table=laws] td").contains("once, for each body"), "{}", cells("td"));
    let words = cells("section p");
    assert!(words.contains("The water level rises by 20 mm (rise_per_year) in each year"), "{words}");
    assert!(words.contains("At least one of 4 bodies in a row, each with its own friction"), "{words}");
    let slopes = answer.situations[0].slopes.as_ref().unwrap();
    let by_force = slopes[1].unwrap().by_mean.unwrap();
    let found = cells("table[data-table=slopes] td");
    let expected = format!(
        "load.push.force|150 kN/m|15 kN/m|{} per kN/m",
        standfast_cases::layout::digits(1e3 * by_force)
    );
    assert!(found.contains(&expected), "{found}, {expected}");
}

/// Page 1 says what was asked for with its period, in the words of the top of `standfast probability`; the section has the period at
/// every table.
#[test]
fn page_one_leads_with_the_probability_and_its_period() {
    let life = format!("{BLOCK}[criteria]\np_not_rest = 0.01\n{RANDOM}")
        .replace("[random]\n", "[random]\nyears = 50\n");
    let life =
        life.replace("{ lognormal = { cov = 0.15 } }", "{ lognormal = { cov = 0.15 }, every = \"year\" }");
    let event = format!("{BLOCK}{RANDOM}");
    for (text, period, asked) in [
        (&event, "in one event", "does not stay at rest in one event is "),
        (&life, "in one year", "At least once in 50 years: "),
    ] {
        let file = CaseFile::parse("case.toml", text).unwrap();
        let top = Probability::of(&file, ChanceRequest::default()).unwrap().summary().unwrap();
        assert!(top.answer.contains(period) && top.answer.contains(asked), "{}", top.answer);
        let page = scraper::Html::parse_document(&html(text));
        let text_of = |css: &str| {
            let selector = scraper::Selector::parse(css).unwrap();
            page.select(&selector).map(|found| found.text().collect::<String>()).collect::<Vec<_>>()
        };
        let lines = text_of(".summary p.verdict, .summary p.near");
        let expected: Vec<String> =
            [top.criteria, Some(top.answer), top.near].into_iter().flatten().collect();
        assert_eq!(lines[..expected.len()], expected);
        // Behind it the case with its numbers as they are, in the words of `standfast assess`.
        let top = standfast_cases::Assessment::of_file(&file).unwrap().summary().unwrap();
        let given: Vec<String> = [top.criteria, Some(top.answer), top.near].into_iter().flatten().collect();
        assert_eq!(lines[expected.len()..], given);
        let heads = text_of("[data-table=modes] th, [data-table=importance] th").join("|");
        assert!(
            heads.contains(&format!("Probability {period}")) && heads.contains(&format!("P {period} if")),
            "{heads}"
        );
        let lives = text_of("[data-table=life] th").join("|");
        assert_eq!(lives.contains("Probability in 50 years"), text.contains("years = 50"), "{lives}");
        assert!(text_of("p").iter().any(|p| p.contains(&format!("does not stay at rest {period}: "))));
    }
}

#[test]
fn nothing_random_has_no_section() {
    let page = html(BLOCK);
    assert!(!page.contains("Probability</h2>") && page.contains("7 Signatures"));
}
