//! How likely each outcome is: asked in a thread of its own, roughly at once and then as the program answers; and the laws of the random
//! numbers, which are written into the text of the case.

use serde::Serialize;
use standfast_cases::CaseFile;
use standfast_cases::random::screen::{ChancesOnScreen, DrawsOnScreen, chances_on_screen, draws_on_screen};
use standfast_cases::random::{
    ChanceProblem, ChanceRequest, Effort, Probability, ProbabilityError, ProposedLaw, RandomEntry, Spread,
    spreads,
};
use standfast_figures::draws_over;
use standfast_inputs::random::{Parameter, Written};
use standfast_inputs::typed::{TypedUnits, typed};
use standfast_inputs::units::split_text;

use crate::asked::Question;
use crate::page::{Page, Version, read};

/// A part of the answer.
#[derive(Debug, Serialize)]
#[serde(rename_all = "snake_case")]
enum Part {
    /// Probabilities; the last are those of the program.
    Chances(Box<ChancesOnScreen>),
    Draws(DrawsOnScreen),
    /// The program's JSON, behind the last probabilities.
    Json(String),
    Fault(String),
}

/// What is still to be told.
#[derive(Debug, Clone, Copy)]
enum Step {
    /// With so many points at most.
    Rough(u64),
    Whole,
    Draws,
    Json,
}

/// How likely each outcome of a case is.
#[derive(Debug)]
pub struct Likely {
    file: CaseFile,
    answer: Option<Probability>,
    /// The next is the last.
    steps: Vec<Step>,
}

impl Likely {
    /// Of a case with random numbers; of any other nothing is told.
    pub fn of(file: CaseFile) -> Likely {
        let mut steps = vec![Step::Json, Step::Whole];
        let random = file.random().map_or(0, |random| random.named.len());
        let has_storm = file.inputs().has(standfast_inputs::key::Table::Storm);
        // A few numbers are integrated, which takes no longer at once.
        if random > INTEGRATED || has_storm {
            steps.extend([Step::Draws, Step::Rough(ROUGH)]);
        } else {
            steps.insert(1, Step::Draws);
        }
        if has_storm {
            // The whole takes minutes.
            steps.insert(2, Step::Rough(FINER));
        }
        if random == 0 {
            steps.clear();
        }
        Likely { file, answer: None, steps }
    }

    fn told(&mut self, step: Step) -> Result<Option<Part>, ProbabilityError> {
        let effort = match step {
            Step::Rough(points) => Effort { points, precision: 0.2, floor: 1e-4, ..Effort::default() },
            Step::Whole => Effort::default(),
            Step::Draws => return Ok(self.answer.as_ref().and_then(draws_on_screen).map(Part::Draws)),
            Step::Json => {
                let json = |answer: &Probability| standfast_cases::Document::json(answer, &(), &[]);
                return Ok(self.answer.as_ref().map(json).map(Part::Json));
            }
        };
        let request = ChanceRequest { effort, ..ChanceRequest::default() };
        let answer = Probability::of(&self.file, request)?;
        let shown = chances_on_screen(&answer);
        self.answer = Some(answer);
        Ok(shown.map(|shown| Part::Chances(Box::new(shown))))
    }
}

/// So many random numbers the program integrates.
const INTEGRATED: usize = 3;
/// Points of a first answer, and of one between it and the whole.
const ROUGH: u64 = 1 << 11;
const FINER: u64 = 1 << 14;

impl Question for Likely {
    fn next_part(&mut self) -> Option<String> {
        let part = loop {
            let step = self.steps.pop()?;
            match self.told(step) {
                Ok(Some(part)) => break part,
                Ok(None) => {}
                Err(error) => {
                    self.steps.clear();
                    break Part::Fault(error.to_string());
                }
            }
        };
        serde_json::to_string(&part).ok()
    }
}

/// A random number, or one that may be, as a row of fields shows it.
#[derive(Debug, Serialize)]
struct SpreadRow {
    /// The key of its field.
    key: String,
    name: String,
    words: String,
    /// The law that holds.
    law: String,
    laws: Vec<String>,
    /// Its deviation, if it has one, with its unit.
    digits: String,
    unit: String,
    units: Vec<&'static str>,
    /// What the law says beside its deviation.
    of: String,
    /// The law to begin from, and where that comes from.
    proposed: String,
    says: String,
}

#[derive(Debug, Serialize)]
struct SpreadsShown {
    rows: Vec<SpreadRow>,
    words: String,
    /// True if a number is certain for which there is a law to begin from.
    can_take: bool,
}

const CERTAIN: &str = "certain";
/// The laws that may be chosen.
const CHOSEN: [&str; 3] = [CERTAIN, "normal", "lognormal"];
/// Behind it in a field's key stands the name of a random number.
const PREFIX: &str = "random.";

/// A deviation of a law, as a field shows it: its parameter, digits and unit.
fn deviation(entry: &RandomEntry) -> Option<(&Parameter, String, String)> {
    let parameter = entry.parameters.iter().find(|own| own.name == "cov" || own.name == "sd")?;
    let (digits, unit) = match &parameter.value {
        Written::Number(share) if parameter.name == "cov" => (per_cent(*share), "%".to_owned()),
        Written::Number(number) => (number.to_string(), String::new()),
        Written::Text(text) => {
            let (digits, unit) = split_text(text)?;
            (digits.to_owned(), unit.trim().to_owned())
        }
        Written::List(_) | Written::Function(_) => return None,
    };
    Some((parameter, digits, unit))
}

fn per_cent(share: f64) -> String {
    standfast_cases::layout::digits(100.0 * share)
}

impl SpreadRow {
    fn of(spread: Spread) -> SpreadRow {
        let Spread { name, words, own, law, proposed, .. } = spread;
        let (digits, unit) = law
            .as_ref()
            .and_then(deviation)
            .map_or_else(Default::default, |(_, digits, unit)| (digits, unit));
        let now = law.as_ref().map_or(CERTAIN, |law| law.law);
        let mut laws: Vec<String> = CHOSEN.map(str::to_owned).into();
        if !CHOSEN.contains(&now) {
            laws.push(now.to_owned());
        }
        let of = match &law {
            None => own,
            Some(law) => {
                let rest = law.law_words();
                let rest = rest
                    .split(", ")
                    .skip(1)
                    .filter(|part| !part.starts_with("sd ") && !part.starts_with("cov "));
                let rest: Vec<&str> = rest.collect();
                let has_mean = law.parameters.iter().any(|own| own.name == "mean" || own.name == "mode");
                let own = (!has_mean && !own.is_empty() && !digits.is_empty()).then(|| format!("mean {own}"));
                own.iter().map(String::as_str).chain(rest).collect::<Vec<_>>().join(", ")
            }
        };
        let in_words = |ProposedLaw { law, mean, cov, .. }: &ProposedLaw| {
            let mean = mean.map_or(String::new(), |mean| format!(", mean {mean}"));
            format!("{law}{mean} ± {} %", per_cent(*cov))
        };
        SpreadRow {
            key: format!("{PREFIX}{name}"),
            law: now.to_owned(),
            laws,
            units: if digits.is_empty() { Vec::new() } else { vec!["%"] },
            digits,
            unit,
            of,
            proposed: proposed.as_ref().filter(|_| law.is_none()).map_or(String::new(), in_words),
            says: proposed.map_or(String::new(), |proposed| proposed.says),
            name,
            words,
        }
    }
}

impl Page {
    /// The numbers that are random or may be, as JSON.
    pub fn spreads(&self) -> String {
        let file = self.settled();
        let shown = match spreads(file) {
            Ok(all) => {
                let can_take = all.iter().any(|spread| spread.law.is_none());
                let words = match (all.is_empty(), file.random().is_some()) {
                    (true, _) => {
                        "There are no laws to begin from for the numbers of this case: any of them can be random in its text, under [random]."
                    }
                    (_, true) => {
                        "± is one standard deviation, of the mean where it is in per cent. Laws of other numbers go into the text, under [random]."
                    }
                    (_, false) => {
                        "No number of this case is random. These are proposals to begin from; replace each by what you know of this body and this site."
                    }
                };
                SpreadsShown {
                    can_take,
                    words: words.to_owned(),
                    rows: all.into_iter().map(SpreadRow::of).collect(),
                }
            }
            Err(error) => SpreadsShown { can_take: false, words: error.to_string(), rows: Vec::new() },
        };
        serde_json::to_string(&shown).unwrap_or_default()
    }

    /// Gives all numbers that are certain the laws to begin from, as one step.
    ///
    /// # Errors
    /// What is wrong with them.
    pub fn take_proposed(&mut self) -> Result<(), String> {
        let file = self.settled();
        let all = spreads(file).map_err(|error| error.to_string())?;
        let proposed =
            all.into_iter().filter(|spread| spread.law.is_none()).filter_map(|spread| spread.proposed);
        let laws: Vec<(String, String)> = proposed.map(|law| (law.name.clone(), law.written())).collect();
        let laws: Vec<(&str, &str)> = laws.iter().map(|(name, law)| (&name[..], &law[..])).collect();
        let text = file.with_laws(&laws);
        self.take_random(text)
    }

    /// Gives a number a law by its name: with the deviation that it has, or else with that which is proposed; `certain` takes it away.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn set_law(&mut self, name: &str, law: &str) -> Result<(), String> {
        let file = self.settled();
        let all = spreads(file).map_err(|error| error.to_string())?;
        let spread = all.into_iter().find(|spread| spread.name == name);
        let Some(spread) = spread.filter(|_| CHOSEN.contains(&law)) else {
            return Err(format!("The case has no number {name}."));
        };
        let proposed = spread.proposed.as_ref();
        let text = match (law, proposed) {
            (CERTAIN, _) => file.without_law(name),
            (law, Some(proposed)) if spread.law.is_none() => {
                file.with_laws(&[(name, &proposed.written_as(law))])
            }
            (law, _) => file.with_other_law(name, law),
        };
        self.take_random(text)
    }

    /// Takes what was typed for the deviation of a random number: in per cent of the mean, or else as it stands there.
    ///
    /// # Errors
    /// A sentence on what is wrong with it.
    pub fn set_deviation(&mut self, name: &str, text: &str) -> Result<(), String> {
        let file = self.settled();
        let all = spreads(file).map_err(|error| error.to_string())?;
        let spread = all.iter().find(|spread| spread.name == name);
        let own = spread.and_then(|spread| Some((spread.dimension, deviation(spread.law.as_ref()?)?)));
        let (dimension, (parameter, _, unit)) =
            own.ok_or_else(|| format!("{name} has no deviation that can be typed."))?;
        let text = text.trim();
        let (number, is_share) = text.strip_suffix('%').map_or((text, false), |number| (number, true));
        let units = TypedUnits { dimension: dimension.filter(|_| !is_share), gravity: false };
        let read = typed(number, units)?;
        let is_share = is_share || read.unit.is_none() && unit == "%";
        let value = match (is_share, read.unit.unwrap_or(&unit)) {
            (true, _) => Written::Number(rounded(read.number / 100.0)),
            (false, "") => Written::Number(read.number),
            (false, unit) => Written::Text(format!("{} {unit}", read.number)),
        };
        let names = [&parameter.name[..], if is_share { "cov" } else { "sd" }];
        let next = file.with_parameter(name, names, &value);
        self.take_random(next)
    }

    /// Takes a text in which a law is another, if the case has an answer and its random numbers make sense.
    fn take_random(&mut self, text: Option<String>) -> Result<(), String> {
        let text = text
            .ok_or("That law is not written so that another could take its place: change it in the text.")?;
        let name = self.settled().name().to_owned();
        let file =
            read(&Version { name, text: text.clone() }, self.files()).map_err(|error| error.to_string())?;
        if file.random().is_some() {
            ChanceProblem::of_file(&file).map_err(|error| error.to_string())?;
        }
        self.take(text)
    }

    /// The name of a random number in the key of its field.
    pub(crate) fn random_name(key: &str) -> Option<&str> {
        key.strip_prefix(PREFIX)
    }

    /// The deviation of a random number some per cent greater or less.
    pub(crate) fn step_deviation(&mut self, name: &str, percent: f64) -> Result<(), String> {
        let random = self.settled().random();
        let entry = random.and_then(|random| random.named.iter().find(|entry| entry.name == name));
        let Some((_, digits, unit)) = entry.and_then(deviation) else { return Ok(()) };
        let Ok(number) = digits.parse::<f64>() else { return Ok(()) };
        let next = standfast_cases::layout::significant(number * (1.0 + percent / 100.0), 4);
        self.set_deviation(name, &format!("{next} {unit}"))
    }

    /// Draws over the plane last drawn, if it is the report's; empty of another.
    pub fn draws_over(&self, draws: &[f64]) -> String {
        let draws: Vec<(f64, f64)> = draws.chunks_exact(2).map(|pair| (pair[0], pair[1])).collect();
        let plane = self.drawn.plane.as_ref().filter(|_| self.drawn.is_k_mu() && self.held.is_none());
        plane.map_or(String::new(), |plane| draws_over(plane, &draws))
    }
}

/// The decimal that is meant by one that was divided.
fn rounded(share: f64) -> f64 {
    format!("{share:.12}").parse().unwrap_or(share)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examples;

    fn page(name: &str) -> Page {
        let mut page = Page::default();
        let example = examples::find(name).unwrap();
        assert!(page.open(&example.file(), example.text));
        page
    }

    fn parts(page: &Page) -> Vec<serde_json::Value> {
        let mut likely = Likely::of(page.settled().clone());
        std::iter::from_fn(|| likely.next_part()).map(|part| serde_json::from_str(&part).unwrap()).collect()
    }

    fn rows(page: &Page) -> Vec<serde_json::Value> {
        let shown: serde_json::Value = serde_json::from_str(&page.spreads()).unwrap();
        shown["rows"].as_array().unwrap().clone()
    }

    /// The last part is the program's answer; the first is near it, with an interval that is wider.
    #[test]
    fn the_answer_is_told_roughly_and_then_as_the_program_has_it() {
        let page = page("goda-2000-random");
        let parts = parts(&page);
        let names: Vec<&String> = parts.iter().flat_map(|part| part.as_object().unwrap().keys()).collect();
        assert_eq!(names, ["chances", "draws", "chances", "json"]);
        let of_program = Probability::of(page.settled(), ChanceRequest::default()).unwrap();
        let json = standfast_cases::Document::json(&of_program, &(), &[]);
        assert_eq!(parts[3]["json"], json.as_str());
        let summary = standfast_cases::Document::summary(&of_program).unwrap();
        let [rough, whole] = [&parts[0]["chances"], &parts[2]["chances"]];
        assert_eq!(whole["summary"]["answer"], summary.answer.as_str());
        assert_eq!(whole["percent"], "2.5 %");
        let moved = |shown: &serde_json::Value| {
            shown["groups"][0][1].as_array().unwrap()[1]["share"].as_f64().unwrap()
        };
        assert!((moved(rough) / moved(whole) - 1.0).abs() < 0.2);
        assert_eq!(whole["known"].as_array().unwrap().len(), 4);
        // Goda's wave moves the elevation of all loads: the draws have no place in one plane.
        assert!(parts[1]["draws"]["in_plane"].as_array().unwrap().is_empty());
        assert_eq!(parts[1]["draws"]["figures"][0][0], "Draws");
        assert!(super::tests::parts(&Page::default()).is_empty(), "nothing is random");
    }

    /// A case becomes random by one step, and is as it was by one more.
    #[test]
    fn proposals_are_written_and_undone_in_one_step() {
        let mut page = Page::default();
        let before = page.text().to_owned();
        let answer = page.answered().json();
        assert!(
            rows(&page)
                .iter()
                .all(|row| row["law"] == "certain" && !row["proposed"].as_str().unwrap().is_empty())
        );
        page.take_proposed().unwrap();
        assert!(
            page.text().starts_with(&before)
                && page.text().contains("\n[random]\nfriction = { lognormal = { cov = 0.2 } }\n")
        );
        assert_eq!(page.answered().json(), answer);
        let drawn = parts(&page);
        page.plate(crate::plane::K_MU, (560.0, 380.0));
        let draws = drawn.iter().find_map(|part| part.get("draws")).unwrap()["in_plane"].as_array().unwrap();
        let flat: Vec<f64> =
            draws.iter().flat_map(|pair| [pair[0].as_f64().unwrap(), pair[1].as_f64().unwrap()]).collect();
        assert!(flat.len() == 2000 && page.draws_over(&flat).contains("sf-draws"));
        page.undo();
        assert_eq!(page.text(), before);
        assert!(parts(&page).is_empty());
    }

    #[test]
    fn laws_and_deviations_are_taken_as_people_type_them() {
        let mut page = Page::default();
        page.set_law("friction", "normal").unwrap();
        for (typed, line) in [
            ("15", "friction = { normal = { cov = 0.15 } }"),
            ("12,5 %", "friction = { normal = { cov = 0.125 } }"),
            ("7", "friction = { normal = { cov = 0.07 } }"),
        ] {
            page.set("random.friction", typed).unwrap();
            assert!(page.text().lines().any(|found| found == line), "{typed}: {}", page.text());
        }
        page.step("random.friction", 10.0).unwrap();
        assert!(page.text().contains("cov = 0.077"));
        page.set_law("friction", "lognormal").unwrap();
        assert!(page.text().contains("friction = { lognormal = { cov = 0.077 } }"));
        page.set_law("friction", "certain").unwrap();
        assert!(!page.text().contains("[random]"));
        let mut goda = self::page("goda-2000-random");
        goda.set("random.wave.deep_water_height", "0,8").unwrap();
        assert!(goda.text().contains("sd = \"0.8 m\" }, lower = \"1 m\" }"));
        goda.set("random.wave.deep_water_height", "120 cm").unwrap();
        assert!(goda.text().contains("sd = \"120 cm\" }"));
        goda.set("random.wave.deep_water_height", "20 %").unwrap();
        assert!(goda.text().contains("mean = \"4.5 m\", cov = 0.2 }"));
    }

    #[test]
    fn what_is_not_taken_says_why_and_leaves_all_as_it_was() {
        let mut page = Page::default();
        page.set_law("friction", "normal").unwrap();
        let before = page.text().to_owned();
        for (typed, message) in [
            ("", "A number is missing."),
            ("2,700", "“2,700” could be 2.7 or 2700: type 2.7 or 2700."),
            ("5 m", "“m” is no part of a number, and this one has no unit."),
            ("80", "0.1056 of the law of `friction` lies where it is"),
            ("-5", "`sd` of the law normal of `friction` is"),
        ] {
            let error = page.set("random.friction", typed).unwrap_err();
            assert!(error.starts_with(message), "{typed}: {error}");
            assert_eq!(page.text(), before);
        }
        assert!(page.set_law("frction", "normal").is_err());
    }
}
