//! `[block]` cases.

use standfast::contact::Block;
use standfast::{InputError, Quantity, Wrench};
use standfast_motion::{Base, Impact, Initial, Load, MotionError, Problem};
use toml::de::{DeTable, DeValue};

use super::criteria::{MOTION_CRITERIA, MotionCriterion};
use super::error::{MotionCaseError, Wrong};
use super::history::{self, KEYS};
use super::slips::slips;
use super::table::Section;
use super::{GivenBase, MotionWarning, ReadFile};

/// A block with what acts on it in time; that of a body is in SI units, per its mass.
#[derive(Debug, Clone, PartialEq)]
pub struct BlockCase {
    /// Its title.
    pub title: Option<String>,
    /// Which of the alternative loads or combinations acts, where there are several.
    pub situation: Option<String>,
    /// The problem.
    pub problem: Problem,
    /// The crest above the base, for its figures; of a `[block]` twice that of C.
    pub height: f64,
    /// Whether water presses up on the base.
    pub uplift: bool,
    /// Whether it is in SI units.
    pub si: bool,
    /// The loads at their peaks, of a body.
    pub peaks: Vec<LoadPeak>,
    /// What is asked of the motion.
    pub criteria: Vec<MotionCriterion>,
    /// What may be a slip.
    pub warnings: Vec<MotionWarning>,
}

/// A load of a body at its peak, about its centre of mass.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadPeak {
    /// What it is called.
    pub name: String,
    /// Whether it is there all the time.
    pub permanent: bool,
    /// The load, N and N·m, or per metre run; the greatest of its history times what the case has of it.
    pub wrench: Wrench,
}

const TOP: [&str; 5] = ["title", "note", "block", "motion", "criteria"];
const BLOCK: [&str; 11] =
    ["b1", "b2", "d", "rho2", "m_x", "m_y", "mu_s", "mu_k", "mu_impact", "gravity", "load"];
const LOAD: [&str; 4] = ["at", "direction", "follows", "history"];
pub(super) const MOTION: [&str; 4] = ["impact", "t_max", "initial", "base"];

/// Whether a case file has a `[motion]` or a `[block]`, or loads with histories and no `[ground]`, on which they would be those of an
/// elastic base: what moves in time.
pub fn is_in_time(text: &str) -> bool {
    DeTable::parse(text).is_ok_and(|document| {
        let document = document.get_ref();
        let varies =
            |value: &DeValue<'_>| value.as_table().is_some_and(|table| table.contains_key("history"));
        let histories = || {
            let loads = document.get("load").and_then(|loads| loads.get_ref().as_array());
            document.get("wave").is_some_and(|wave| varies(wave.get_ref()))
                || loads.is_some_and(|loads| loads.iter().any(|load| varies(load.get_ref())))
        };
        document.contains_key("block")
            || document.contains_key("motion")
            || (!document.contains_key("ground") && histories())
    })
}

/// Whether a case file has a `[block]`.
pub fn has_block(text: &str) -> bool {
    DeTable::parse(text).is_ok_and(|document| document.get_ref().contains_key("block"))
}

impl BlockCase {
    /// Reads a case; `name` is what errors call it, and `file` reads the records it names.
    ///
    /// # Errors
    /// If the text is not TOML, a key or value is not what such a case has, or the problem is none.
    pub fn parse(name: &str, text: &str, file: &ReadFile<'_>) -> Result<BlockCase, MotionCaseError> {
        BlockCase::parse_on(name, text, file, &GivenBase::default())
    }

    /// As [`parse`](BlockCase::parse), on a base that moves as is given.
    pub(super) fn parse_on(
        name: &str,
        text: &str,
        file: &ReadFile<'_>,
        given: &GivenBase,
    ) -> Result<BlockCase, MotionCaseError> {
        read(text, file, given).map_err(|wrong| wrong.in_file(name, text))
    }
}

fn read(text: &str, file: &ReadFile<'_>, given: &GivenBase) -> Result<BlockCase, Wrong> {
    let document = DeTable::parse(text).map_err(|error| {
        Wrong::new(format!("this is not valid TOML: {}", error.message()), error.span().unwrap_or(0..0))
    })?;
    let top = Section::new("a case of a [block]", document.get_ref(), document.span(), text, &TOP)?;
    let block = top.section("block", "[block]".to_owned(), &BLOCK)?.ok_or_else(|| top.lacks("block"))?;
    let motion = top.section("motion", "[motion]".to_owned(), &MOTION)?;
    let gravity = block.needed("gravity")?;
    let mut problem = Problem::new(body(&block)?, gravity);
    problem.mu_impact = block.number("mu_impact")?;
    let mut warnings = Vec::new();
    let mut steps: Vec<f64> = Vec::new();
    let mut taken = |read: history::Read| {
        warnings.extend(read.warnings);
        steps.extend(read.step);
        read.history
    };
    for load in block.sections("load", "[[block.load]]", &LOAD)? {
        let name = "the history of a [[block.load]]".to_owned();
        let history = load.section("history", name, &KEYS)?.ok_or_else(|| load.lacks("history"))?;
        problem.loads.push(Load {
            at: load.pair("at")?.unwrap_or([0.0, 0.0]),
            direction: load.pair("direction")?.ok_or_else(|| load.lacks("direction"))?,
            follows: load.truth("follows")?.unwrap_or(false),
            history: taken(history::read(&history, file)?),
        });
    }
    if let Some(motion) = &motion {
        settings(motion, &mut problem)?;
    }
    let base = match &motion {
        Some(motion) => motion.section("base", "[motion.base]".to_owned(), &["horizontal", "vertical"])?,
        None => None,
    };
    let mut direction = |key: &str| {
        if let Some(read) = given.read(key).map_err(|error| refused(&block, motion.as_ref(), &error))? {
            return Ok(Some(taken(read)));
        }
        let Some(base) = &base else { return Ok(None) };
        let section = base.section(key, format!("`{key}` of [motion.base]"), &KEYS)?;
        section.map(|section| history::read(&section, file).map(&mut taken)).transpose()
    };
    problem.base = Base { horizontal: direction("horizontal")?, vertical: direction("vertical")? };
    problem.check().map_err(|error| refused(&block, motion.as_ref(), &error))?;
    warnings.extend(slips(&problem, steps.into_iter().reduce(f64::max)));
    let title = top.words("title")?.map(str::to_owned);
    top.words("note")?;
    let asked = top.section("criteria", "[criteria] of a case of a [block]".to_owned(), &MOTION_CRITERIA)?;
    let criteria = asked.as_ref().map_or_else(|| Ok(Vec::new()), MotionCriterion::read)?;
    let height = 2.0 * problem.block.d;
    Ok(BlockCase {
        title,
        situation: None,
        problem,
        height,
        uplift: false,
        si: false,
        peaks: Vec::new(),
        criteria,
        warnings,
    })
}

/// What [motion] says beside the base.
pub(super) fn settings(motion: &Section<'_>, problem: &mut Problem) -> Result<(), Wrong> {
    problem.t_max = motion.number("t_max")?;
    problem.impact = impact(motion)?;
    problem.initial = initial(motion)?;
    Ok(())
}

fn body(section: &Section<'_>) -> Result<Block, Wrong> {
    let number = |key: &str| section.needed(key);
    let or = |key: &str, other: f64| section.number(key).map(|found| found.unwrap_or(other));
    let (b1, b2, d) = (number("b1")?, number("b2")?, number("d")?);
    let rho2 = match section.number("rho2")? {
        Some(rho2) => rho2,
        None if b1 == 1.0 && b2 == 1.0 => (1.0 + d * d) / 3.0,
        None => {
            return Err(section.lacks("rho2").help(
                "(1 + d²)/3 is taken for b1 = b2 = 1 only, a uniform block; else give I/m about C, rho2",
            ));
        }
    };
    let mu_s = number("mu_s")?;
    Ok(Block { b1, b2, d, rho2, m_x: or("m_x", 1.0)?, m_y: or("m_y", 1.0)?, mu_s, mu_k: or("mu_k", mu_s)? })
}

fn impact(motion: &Section<'_>) -> Result<Impact, Wrong> {
    let Some(impact) = motion.section("impact", "`impact` of [motion]".to_owned(), &["law", "ratio"])? else {
        return Ok(Impact::Inelastic);
    };
    let laws = [("inelastic", 0), ("housner", 1), ("ratio", 2)];
    let law = impact.choice("law", &laws)?.ok_or_else(|| impact.lacks("law"))?;
    let ratio = impact.number("ratio")?;
    match (law, ratio) {
        (2, ratio) => Ok(Impact::Ratio(ratio.ok_or_else(|| impact.lacks("ratio"))?)),
        (_, Some(_)) => Err(Wrong::new("`ratio` goes with law = \"ratio\" only", impact.place("ratio"))),
        (law, None) => Ok(if law == 0 { Impact::Inelastic } else { Impact::Housner }),
    }
}

fn initial(motion: &Section<'_>) -> Result<Initial, Wrong> {
    let keys = ["theta", "omega", "vx", "vy", "gap"];
    let Some(initial) = motion.section("initial", "[motion.initial]".to_owned(), &keys)? else {
        return Ok(Initial::default());
    };
    let or_zero = |key: &str| initial.number(key).map(|found| found.unwrap_or(0.0));
    Ok(Initial {
        theta: or_zero("theta")?,
        omega: or_zero("omega")?,
        vx: initial.number("vx")?,
        vy: initial.number("vy")?,
        gap: or_zero("gap")?,
    })
}

/// What the library refuses, shown at the key it is about.
fn refused(block: &Section<'_>, motion: Option<&Section<'_>>, error: &MotionError) -> Wrong {
    let key = match error {
        MotionError::Input(InputError { quantity, .. }) => {
            let keys = [
                (Quantity::B1, "b1"),
                (Quantity::B2, "b2"),
                (Quantity::D, "d"),
                (Quantity::Rho2, "rho2"),
                (Quantity::InertiaX, "m_x"),
                (Quantity::InertiaY, "m_y"),
                (Quantity::MuS, "mu_s"),
                (Quantity::MuK, "mu_k"),
            ];
            keys.iter().find(|(known, _)| known == quantity).map_or("b1", |(_, key)| key)
        }
        MotionError::Value { name, .. } => name,
        MotionError::Ratio { .. } => "ratio",
        _ => "gravity",
    };
    let inner = motion.and_then(|motion| {
        let within = |table: &str| {
            motion
                .section(table, String::new(), &["law", "ratio", "theta", "omega", "vx", "vy", "gap"])
                .ok()
                .flatten()
        };
        let holds = |section: &Section<'_>| section.get(key).map(|value| value.span());
        holds(motion).or_else(|| ["impact", "initial"].into_iter().find_map(|table| holds(&within(table)?)))
    });
    Wrong::new(error.to_string(), inner.unwrap_or_else(|| block.place(key)))
}
