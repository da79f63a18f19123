//! The section of probabilities: that its numbers are those of the answer, and that there is none where nothing is random.

mod common;

use standfast_cases::CaseFile;
use standfast_cases::random::{ChanceRequest, Probability};
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
        select("h2").contains(&"7 Probability".to_owned())
            && select("h2").contains(&"9 Signatures".to_owned())
    );
    let selector = scraper::Selector::parse("data").unwrap();
    let shown: Vec<f64> =
        page.select(&selector).filter_map(|data| data.attr("value")?.parse().ok()).collect();
    let worst = &answer.situations[0];
    let mut expected = vec![worst.not_rest.value, worst.design_point.as_ref().unwrap().beta];
    expected.extend(worst.known.iter().map(|known| known.value));
    expected.extend(answer.situations.iter().map(|chances| chances.not_rest.value));
    expected.push(answer.joined.unwrap().not_rest.value);
    expected.push(answer.criterion.unwrap().counted());
    for number in expected {
        assert!(shown.contains(&number), "{number} is not on the sheet");
    }
    let laws = select("table[data-table=laws] td").join("|");
    assert!(laws.contains("friction|normal, cov 0.1|once|bias.force|lognormal, cov 0.15|once"), "{laws}");
    let words = select("section").join(" ");
    assert!(words.contains("ranks, Spearman's") && words.contains("only approximates the probability above"));
}

#[test]
fn nothing_random_has_no_section() {
    let page = html(BLOCK);
    assert!(!page.contains("Probability</h2>") && page.contains("8 Signatures"));
}
