//! Everything that the page says, as JSON: the sentences are those of the answer.

use serde::Serialize;
use standfast::contact::stack::StackStage;
use standfast::relation::Relation;
use standfast::{Stage, Verdict};
use standfast_cases::assess::verdict::{full_load, least_factor};
use standfast_cases::assess::{joint_words, joints};
use standfast_cases::case::Limit;
use standfast_cases::design::{overturning, sliding};
use standfast_cases::layout::{digits, factor, percent};
use standfast_cases::motion::{FollowedMotion, MotionCheck, uniqueness};
use standfast_cases::results::ResultName;
use standfast_cases::{Assessed, Assessment, CaseError, Explained, Summary};

use crate::answered::Answered;
use crate::compared::ComparedSaid;
use crate::numbers::{NumberTable, tables};
use crate::page::Page;
use crate::text::{mathematics, symbol, units_of_script};

/// A criterion with its value.
#[derive(Debug, Serialize)]
pub struct CheckRow {
    pub name: &'static str,
    pub words: &'static str,
    required: String,
    pub value: String,
    pub met: bool,
    met_words: String,
    /// The loads under which it is met worst.
    place: Option<String>,
}

/// What the page says.
#[derive(Serialize)]
struct Said<'a> {
    name: &'a str,
    title: Option<&'a str>,
    summary: Option<Summary>,
    /// Whether criteria are met, in a sentence.
    criteria: Option<String>,
    /// The verdict's symbol in plain characters.
    mode: String,
    symbol: String,
    tint: String,
    unique: bool,
    rulers: Vec<Ruler>,
    /// The case beside the one that is pinned.
    compared: Option<ComparedSaid>,
    checks: Vec<CheckRow>,
    warnings: Vec<[String; 2]>,
    sentences: Vec<String>,
    because: Vec<[String; 3]>,
    stages: Vec<[String; 2]>,
    point: Option<[f64; 4]>,
    in_time: bool,
    /// Of a case with random numbers, which is answered with its own beside the probability: what stands before that.
    standing: Option<&'static str>,
    plates: Vec<&'static str>,
    tables: Vec<NumberTable>,
    fault: Option<FaultSaid>,
    can_undo: bool,
    can_redo: bool,
}

/// A number on a line from 0 to 2, on which 1 is where the body moves or a bound is reached.
#[derive(Debug, Serialize)]
pub struct Ruler {
    pub name: &'static str,
    pub words: String,
    /// The value as it is read.
    pub value: String,
    /// That of A, if a case is pinned that has another.
    before: Option<String>,
    /// The bound as it is read; empty of a factor of which nothing is asked.
    required: String,
    /// Share of the line, up to 1.
    at: f64,
    /// Share of the line at which the bound lies.
    bound: Option<f64>,
    pub good: bool,
}

/// What is wrong with the text, and where.
#[derive(Debug, Serialize)]
struct FaultSaid {
    message: String,
    help: String,
    example: String,
    line: usize,
    /// The first place in the text, in units of UTF-16, as scripts count.
    place: [usize; 2],
    cure: Option<String>,
}

/// Everything that the page says, as JSON.
pub fn json(page: &Page) -> String {
    serde_json::to_string(&Said::of(page)).unwrap_or_default()
}

impl<'a> Said<'a> {
    fn of(page: &'a Page) -> Said<'a> {
        let answered = page.answered();
        let summary = answered.summary();
        let rest = answered.rest.as_ref();
        let worst = answered.worst();
        let chip = Chip::of(answered);
        let mut rulers = rulers_of(answered);
        let compared = ComparedSaid::of(page, summary.as_ref(), &rulers);
        if let Some(pinned) = &page.pinned {
            let before = rulers_of(&pinned.answered);
            for ruler in &mut rulers {
                let same = before.iter().find(|other| other.name == ruler.name);
                ruler.before = same.map(|other| other.value.clone()).filter(|value| *value != ruler.value);
            }
        }
        let title = match rest {
            Some(rest) => rest.case.title.as_deref(),
            None => answered.motions.first().and_then(|worst| worst.case.title.as_deref()),
        };
        Said {
            name: page.name(),
            title,
            criteria: summary.as_ref().and_then(|summary| summary.criteria.clone()),
            summary,
            mode: chip.mode,
            symbol: chip.symbol,
            tint: chip.tint,
            unique: chip.unique,
            rulers,
            compared,
            checks: checks_of(answered),
            warnings: warnings(page),
            sentences: worst
                .map_or_else(|| answered.motions.iter().take(1).map(uniqueness).collect(), full_load),
            because: worst.map_or_else(Vec::new, |worst| worst.because().iter().map(row).collect()),
            stages: worst
                .zip(answered.rest.as_ref())
                .map_or_else(Vec::new, |(worst, rest)| stages(rest, worst)),
            point: answered.point().map(|reduced| {
                let point = &reduced.point;
                [point.gamma(), point.k_prime(), point.k(), point.mu()]
            }),
            in_time: answered.is_in_time(),
            standing: page.file().random().map(|_| "With the numbers as they stand:"),
            plates: page.plates(),
            tables: tables(page.file()),
            fault: page.fault().map(|error| FaultSaid::of(error, page.text())),
            can_undo: page.can_undo(),
            can_redo: page.can_redo(),
        }
    }
}

/// The verdict in a word or a symbol, with its colour.
struct Chip {
    /// In plain characters.
    mode: String,
    symbol: String,
    tint: String,
    unique: bool,
}

impl Chip {
    /// The mode that begins; of a motion, how it ends.
    fn of(answered: &Answered) -> Chip {
        if let Some(outcome) = answered.motions.first().map(|worst| &worst.outcome) {
            let mode = outcome.end.word();
            let tint = match mode {
                "overturned" => "var(--overturns)",
                _ => "var(--rest)",
            };
            let symbol = mode.replace('-', " ");
            return Chip { mode: mode.to_owned(), symbol, tint: tint.to_owned(), unique: outcome.unique };
        }
        if let Some((worst, joints)) =
            answered.worst().and_then(|worst| Some((worst, worst.joints.as_ref()?)))
        {
            let lead = joints::leading(worst, joints);
            let symbol = match joints.modes() {
                Some(modes) if !modes.is_empty() => {
                    modes.iter().map(|mode| symbol(*mode)).collect::<Vec<_>>().join(" / ")
                }
                _ => joints::symbols(worst, joints),
            };
            return Chip {
                mode: joints::symbols(worst, joints),
                symbol,
                tint: lead.map_or("none".to_owned(), standfast_figures::tint_on_screen),
                unique: worst.is_unique() != Some(false),
            };
        }
        let verdict = answered.verdict();
        Chip {
            mode: verdict.map_or(String::new(), |verdict| verdict.symbol().to_owned()),
            symbol: verdict.map_or("—".to_owned(), verdict_symbol),
            tint: verdict.map_or("none".to_owned(), tint),
            unique: answered.worst().is_none_or(|worst| worst.outcome.full.is_unique()),
        }
    }
}

fn verdict_symbol(verdict: Verdict) -> String {
    verdict.mode().map_or_else(|| verdict.symbol().to_owned(), symbol)
}

/// The colour of a verdict, as CSS.
fn tint(verdict: Verdict) -> String {
    verdict.mode().map_or("var(--bearing-failure)".to_owned(), standfast_figures::tint_on_screen)
}

/// The names of the warnings with their messages.
fn warnings(page: &Page) -> Vec<[String; 2]> {
    let answered = page.answered();
    let of_case = answered.rest.iter().flat_map(|rest| rest.case.warnings());
    let of_case = of_case.map(|warning| [warning.name().to_owned(), warning.to_string()]);
    let of_motion = answered.motions.first().into_iter().flat_map(|worst| &worst.warnings);
    let of_motion = of_motion.map(|warning| [warning.name.to_owned(), warning.words.clone()]);
    let mut all: Vec<[String; 2]> = Vec::new();
    for warning in of_case.chain(of_motion) {
        if !all.iter().any(|[name, _]| *name == warning[0]) {
            all.push(warning);
        }
    }
    all
}

fn row(relation: &Relation) -> [String; 3] {
    let sign = relation.sign.to_string();
    let values = format!("{} {sign} {}", digits(relation.left), digits(relation.right)).replace('-', "−");
    [relation.equation.to_owned(), mathematics(&relation.statement()), mathematics(&values)]
}

/// The stages of the rising load: up to which share, and what the body does.
fn stages(rest: &Assessment, assessed: &Assessed) -> Vec<[String; 2]> {
    if let Some(joints) = &assessed.joints {
        let path = joints.path(&rest.case, assessed, standfast_cases::assess::UP_TO).into_iter();
        let said = |stage: StackStage| {
            let share = format!("{} – {}", percent(stage.from), percent(stage.to));
            [share, joint_words::slashed(&stage.modes)]
        };
        return path.map(said).collect();
    }
    let said = |stage: &Stage| {
        let words = stage.verdict.map_or("no consistent mode", Verdict::words);
        [format!("{} – {}", percent(stage.from), percent(stage.to)), words.to_owned()]
    };
    assessed.path_up_to(standfast_cases::assess::UP_TO).iter().map(said).collect()
}

/// The criteria on a line each, or else the safety factors.
pub fn rulers_of(answered: &Answered) -> Vec<Ruler> {
    // What is not asked of a motion is told by its sentences, and not by factors of its first instant.
    answered.rest.as_ref().map_or_else(Vec::new, |rest| rulers(rest, !answered.is_in_time()))
}

/// The criteria, the governing one first.
pub fn checks_of(answered: &Answered) -> Vec<CheckRow> {
    answered.rest.as_ref().map_or_else(|| motion_checks(answered), checks)
}

/// The symbol of what begins, or in a word how a motion ends.
pub fn mode(answered: &Answered) -> String {
    Chip::of(answered).mode.replace('-', "−").replace('\'', "′")
}

fn checks(rest: &Assessment) -> Vec<CheckRow> {
    let row = |check: &standfast_cases::assess::AnyCheck<'_>| {
        let [required, value, _, met_words] = check.cells();
        let place = rest.name(check.assessed(rest)).filter(|_| rest.all.len() > 1);
        let joint = Some(check.on_joint().trim().to_owned()).filter(|joint| !joint.is_empty());
        let place = match (joint, place) {
            (Some(joint), Some(place)) => Some(format!("{joint}, {place}")),
            (joint, place) => joint.or(place),
        };
        CheckRow {
            name: check.name(),
            words: check.words(),
            required,
            value,
            met: check.is_met(),
            met_words,
            place,
        }
    };
    rest.all_checks().iter().map(row).collect()
}

/// The criteria of a motion that has no first instant.
fn motion_checks(answered: &Answered) -> Vec<CheckRow> {
    let row = |followed: &FollowedMotion, check: &MotionCheck| CheckRow {
        name: check.criterion.name(),
        words: check.criterion.words(),
        required: check.criterion.required(check.si),
        value: check.value_words(),
        met: check.met,
        met_words: check.met_words().to_owned(),
        place: followed.case.situation.clone(),
    };
    let worst = answered.motions.first().into_iter();
    worst
        .flat_map(|followed| followed.checks().iter().map(|check| row(followed, check)).collect::<Vec<_>>())
        .collect()
}

/// The criteria on a line each, or where nothing is asked the safety factors.
fn rulers(rest: &Assessment, with_factors: bool) -> Vec<Ruler> {
    let checks = rest.all_checks();
    if checks.is_empty() {
        return if with_factors { factors(rest.governing()) } else { Vec::new() };
    }
    let of = |check: &standfast_cases::assess::AnyCheck<'_>| {
        let [required, value, ..] = check.cells();
        let ratio = check.utilisation()?;
        // A bound from below lies at 1 over what is used of it.
        let is_least = required.starts_with('≥');
        let ratio = if is_least { 1.0 / ratio } else { ratio };
        Some(Ruler {
            name: check.in_short(),
            words: check.words().to_owned(),
            value,
            before: None,
            required,
            at: (ratio / 2.0).clamp(0.0, 1.0),
            bound: Some(0.5),
            good: check.is_met(),
        })
    };
    let asked: Vec<Ruler> = checks.iter().filter_map(of).collect();
    if !with_factors || !can_fail(rest.governing()) {
        return asked;
    }
    // Of ground that can fail the ways to fail come first: of ground, sliding and overturning what is asked, or else the factor.
    let ways = factors(rest.governing());
    let (first, others): (Vec<_>, Vec<_>) =
        asked.into_iter().partition(|ruler| ways.iter().any(|way| way.name == ruler.name));
    let unasked: Vec<Ruler> =
        ways.into_iter().filter(|way| first.iter().all(|ruler| ruler.name != way.name)).collect();
    [first, unasked, others].into_iter().flatten().collect()
}

/// True of ground that can fail, beside whose factor those of a rigid base tell what comes next.
fn can_fail(assessed: &Assessed) -> bool {
    let limit = assessed.ground.as_ref().and_then(|ground| ground.limit);
    matches!(limit, Some(Limit::Ground(_)))
}

/// The safety factors of a situation, the least first.
fn factors(assessed: &Assessed) -> Vec<Ruler> {
    let ground = assessed.ground.as_ref().and_then(|ground| ground.factor);
    let all = [
        (ground, ResultName::GroundFactor),
        (Some(sliding(assessed)), ResultName::SfSliding),
        (Some(overturning(assessed)), ResultName::SfOverturningNet),
    ];
    let tell = can_fail(assessed) || least_factor(assessed).is_some();
    if assessed.outcome.full.is_lifted() || !tell {
        return Vec::new();
    }
    let mut factors: Vec<(f64, ResultName)> =
        all.into_iter().filter_map(|(value, name)| Some((value?, name))).collect();
    factors.sort_by(|one, other| one.0.total_cmp(&other.0));
    let ruler = |(value, name): (f64, ResultName)| Ruler {
        name: name.in_short(),
        words: name.info().words.to_owned(),
        value: factor(value),
        before: None,
        required: String::new(),
        at: (value / 2.0).clamp(0.0, 1.0),
        bound: None,
        good: value >= 1.0,
    };
    factors.into_iter().map(ruler).collect()
}

impl FaultSaid {
    fn of(error: &CaseError, text: &str) -> FaultSaid {
        let help = error.help().unwrap_or_default();
        let (sentence, example) = help.split_once('\n').unwrap_or((&help, ""));
        let place = error.excerpt().and_then(|excerpt| excerpt.places.first().cloned()).unwrap_or(0..0);
        FaultSaid {
            message: error.to_string(),
            help: sentence.to_owned(),
            example: example.to_owned(),
            line: 1 + text.get(..place.start).map_or(0, |before| before.matches('\n').count()),
            place: units_of_script(text, &place),
            cure: error.cure().map(|cure| cure.words),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(page: &Page) -> serde_json::Value {
        serde_json::from_str(&json(page)).unwrap()
    }

    #[test]
    fn the_page_says_the_sentences_of_the_answer() {
        let mut page = Page::default();
        assert!(page.open("goda.toml", include_str!("../../examples/goda-on-sand.toml")));
        let said = said(&page);
        let answer: serde_json::Value = serde_json::from_str(&page.answered().json()).unwrap();
        assert_eq!(said["summary"], answer["summary"]);
        assert_eq!(said["summary"]["answer"], "The body stands on ground that fails (BF).");
        assert_eq!((&said["mode"], &said["unique"]), (&"BF".into(), &true.into()));
        let [first, ..] = &said["rulers"].as_array().unwrap()[..] else { panic!("no ruler") };
        assert_eq!(
            (&first["name"], &first["value"], &first["good"]),
            (&"ground".into(), &"0.9809".into(), &false.into())
        );
        // 0.9809 of 1.4, on a line to twice the bound.
        assert!((first["at"].as_f64().unwrap() - 0.9809 / 1.4 / 2.0).abs() < 1e-4);
        assert_eq!(said["warnings"][0][0], "impulsive-breaking");
        // Ground, sliding and overturning, the governing first: before other criteria, and whether asked or not.
        let names: Vec<&str> =
            said["rulers"].as_array().unwrap().iter().filter_map(|ruler| ruler["name"].as_str()).collect();
        let ways = ["ground", "sliding", "overturning"];
        assert_eq!(names, [&ways[..], &["effective pressure"]].concat());
    }

    #[test]
    fn factors_are_shown_where_nothing_is_asked() {
        let said = said(&Page::default());
        let shown: Vec<_> = said["rulers"]
            .as_array()
            .unwrap()
            .iter()
            .map(|ruler| {
                format!(
                    "{} {} {}",
                    ruler["name"].as_str().unwrap(),
                    ruler["value"].as_str().unwrap(),
                    ruler["good"]
                )
            })
            .collect();
        assert_eq!(shown, ["sliding 0.8240 false", "overturning 0.8957 false"]);
        assert_eq!(said["stages"][0][0], "0 % – 82.4 %");
        assert_eq!(said["because"].as_array().unwrap().len(), 2);
    }

    /// How a motion ends is on top, and not what began it.
    #[test]
    fn a_motion_is_told_by_its_end() {
        let mut page = Page::default();
        for (name, mode) in [("server-rack-earthquake", "rest"), ("block-base-pulse", "overturned")] {
            let example = crate::examples::find(name).unwrap();
            assert!(page.open(&example.file(), example.text));
            let said = said(&page);
            assert_eq!((&said["mode"], said["rulers"].as_array().unwrap().len()), (&mode.into(), 0));
        }
    }

    /// The place of a fault counts as scripts do, behind letters of any width.
    #[test]
    fn a_fault_is_told_with_its_place_and_cure() {
        let mut page = Page::default();
        let text = "title = \"é𝄞\"\n[body]\nheigth = 2\n";
        page.open("x.toml", text);
        let said = said(&page);
        let fault = &said["fault"];
        assert_eq!((&fault["line"], &fault["cure"]), (&3.into(), &"Write height".into()));
        let utf16: Vec<u16> = text.encode_utf16().collect();
        let place = |i: usize| fault["place"][i].as_u64().unwrap() as usize;
        assert_eq!(String::from_utf16(&utf16[place(0)..place(1)]).unwrap(), "heigth");
        assert!(fault["help"].as_str().unwrap().starts_with("did you mean `height`?"));
    }
}
