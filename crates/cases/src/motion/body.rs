//! `[body]` cases: the body, its friction and its loads as `assess` has them, each variable load with a history, and a base that moves.

use std::ops::Range as Span;

use standfast::contact::Block;
use standfast::loads::{Action, Earthquake, Face, Load as StaticLoad, LoadSource, Pose};
use standfast::{Body, InputError, Wrench};
use standfast_motion::{Base, History, Load, MotionError, Problem};
use toml::de::{DeTable, DeValue};

use super::block::{BlockCase, LoadPeak, MOTION, settings};
use super::criteria::{MOTION_CRITERIA, MotionCriterion};
use super::error::{MotionCaseError, Wrong};
use super::history::{self, KEYS};
use super::slips::slips;
use super::table::Section;
use super::{GivenBase, MotionWarning, ReadFile};
use crate::assess::load_words;
use crate::case::{Acting, Case, Foundation};
use crate::error::CaseError;
use crate::parse::CaseFile;
use crate::units::Dimension;

/// Why the motion of a case was not followed.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum BodyCaseError {
    /// What `assess` would refuse too.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Case(#[from] CaseError),
    /// What is about histories and the motion.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Motion(#[from] MotionCaseError),
    /// The motion cannot be followed.
    #[error(transparent)]
    Refused(#[from] MotionError),
}

/// What a case file says of time.
pub(super) struct InTime<'a> {
    pub(super) motion: Option<Section<'a>>,
    /// Of each [[load]], by its place.
    loads: Vec<Option<Section<'a>>>,
    /// Where each [[load]] stands.
    places: Vec<Span<usize>>,
    wave: Option<Section<'a>>,
    /// Where [wave] stands.
    wave_place: Span<usize>,
    /// What stands in the file for these.
    pub(super) taken: Vec<Span<usize>>,
    /// [criteria], where it asks something of the motion.
    pub(super) criteria: Option<Section<'a>>,
    /// What stands in the file for that.
    pub(super) asked: Vec<Span<usize>>,
}

/// Reads a case with a `[body]`: one problem for each of the loads, or combinations of them, that act alone.
///
/// # Errors
/// If the case is none, or a variable load has no history.
pub fn body_cases(name: &str, text: &str, file: &ReadFile<'_>) -> Result<Vec<BlockCase>, BodyCaseError> {
    body_cases_on(name, text, file, &GivenBase::default())
}

/// As [`body_cases`], on a base that moves as is given.
pub(super) fn body_cases_on(
    name: &str,
    text: &str,
    file: &ReadFile<'_>,
    given: &GivenBase,
) -> Result<Vec<BlockCase>, BodyCaseError> {
    body_cases_of(name, text, file, given, &|rest| CaseFile::parse(name, rest)?.case())
}

/// The same of another case than that of the text, which `case` makes of what the text says beside time.
pub(super) fn body_cases_of(
    name: &str,
    text: &str,
    file: &ReadFile<'_>,
    given: &GivenBase,
    case: &dyn Fn(&str) -> Result<Case, CaseError>,
) -> Result<Vec<BlockCase>, BodyCaseError> {
    let shown = |wrong: Wrong| BodyCaseError::Motion(wrong.in_file(name, text));
    let document = DeTable::parse(text).map_err(|error| {
        shown(Wrong::new(
            format!("this is not valid TOML: {}", error.message()),
            error.span().unwrap_or(0..0),
        ))
    })?;
    let in_time = in_time(document.get_ref(), text).map_err(shown)?;
    let case = case(&without_time(document.get_ref(), text, &in_time))?;
    if let Some(strength) = case.ground.as_ref().and_then(Foundation::strength) {
        let table = document.get_ref().get("ground").and_then(|value| value.get_ref().as_table());
        let place = table.and_then(|table| table.get("strength")).map_or(0..0, |value| value.span());
        let words = format!(
            "`strength` of [ground] is {}: once its edge is crushed the body stands on another base, whose motion is not computed",
            Dimension::Pressure.written(strength)
        );
        return Err(shown(Wrong::new(words, place).help("leave it out, and the body moves on a rigid base")));
    }
    read(&case, &in_time, file, given).map_err(shown)
}

/// What a text says beside time: a case as `assess` has it.
pub(super) fn without_time(top: &DeTable<'_>, text: &str, in_time: &InTime<'_>) -> String {
    let mut rest = blanked(text, &[&in_time.taken[..], &in_time.asked].concat());
    let loads = ["load", "water", "uplift", "earthquake", "wave", "pressure"];
    if !loads.iter().any(|table| top.contains_key(*table)) {
        // A body on a base that moves needs no load, where `assess` would have nothing to assess.
        rest += "\n[uplift]\nleft = 0\nright = 0\n";
    }
    rest
}

/// A text without what stands at some places: a case as `assess` has it. Blanks keep every other place.
pub(super) fn blanked(text: &str, taken: &[Span<usize>]) -> String {
    let mut rest = text.to_owned();
    for span in taken {
        let blank: String = text[span.clone()]
            .chars()
            .map(|c| if c == '\n' { "\n".into() } else { " ".repeat(c.len_utf8()) })
            .collect();
        rest.replace_range(span.clone(), &blank);
    }
    rest
}

/// Finds histories and [motion].
pub(super) fn in_time<'a>(top: &'a DeTable<'a>, text: &'a str) -> Result<InTime<'a>, Wrong> {
    let mut taken = lines_in_time(text);
    let motion = match top.get("motion") {
        None => None,
        Some(value) => {
            let table = value
                .get_ref()
                .as_table()
                .ok_or_else(|| Wrong::new("`motion` is no table; expected [motion]", value.span()))?;
            Some(Section::new("[motion]", table, value.span(), text, &MOTION)?.measured())
        }
    };
    let mut history_of = |table: &'a DeTable<'a>, name: &str| -> Result<Option<Section<'a>>, Wrong> {
        let Some((key, value)) = table.get_key_value("history") else { return Ok(None) };
        let inner = value
            .get_ref()
            .as_table()
            .ok_or_else(|| Wrong::new("`history` is no table; expected { shape = … }", value.span()))?;
        // That under a header of its own is among the lines above.
        let line = text[..key.span().start].rfind('\n').map_or(0, |end| end + 1);
        if !text[line..].trim_start().starts_with('[') {
            taken.push(key.span().start..value.span().end);
        }
        Section::new(format!("the history of {name}"), inner, value.span(), text, &KEYS)
            .map(|s| Some(s.of_load()))
    };
    let (mut loads, mut places) = (Vec::new(), Vec::new());
    if let Some(list) = top.get("load").and_then(|value| value.get_ref().as_array()) {
        for value in list.iter() {
            places.push(value.span());
            loads.push(match value.get_ref() {
                DeValue::Table(table) => history_of(table, "a [[load]]")?,
                _ => None,
            });
        }
    }
    let wave = top.get("wave").map(|value| (value.get_ref().as_table(), value.span()));
    let wave_place = wave.as_ref().map_or(0..0, |(_, span)| span.clone());
    let wave = match wave {
        Some((Some(table), _)) => history_of(table, "the [wave]")?,
        _ => None,
    };
    let (criteria, asked) = asked_in_time(top, text);
    Ok(InTime { motion, loads, places, wave, wave_place, taken, criteria, asked })
}

/// What [criteria] asks of the motion, and where.
fn asked_in_time<'a>(top: &'a DeTable<'a>, text: &'a str) -> (Option<Section<'a>>, Vec<Span<usize>>) {
    let Some(value) = top.get("criteria") else { return (None, Vec::new()) };
    // One that is no table is for `CaseFile` to refuse.
    let Some(table) = value.get_ref().as_table() else { return (None, Vec::new()) };
    let entries = MOTION_CRITERIA.iter().filter_map(|key| table.get_key_value(*key));
    let places = entries.map(|(key, value)| {
        let (mut start, mut end) = (key.span().start, value.span().end);
        let line = text[..start].rfind('\n').map_or(0, |end| end + 1);
        let before = &text[line..start];
        if before.trim_end().ends_with('.') {
            // criteria.slide, above all tables.
            start = line;
        } else if before.contains('{') {
            // In braces a comma goes with it.
            let rest = &text[end..];
            let after = rest.len() - rest.trim_start().len();
            if rest[after..].starts_with(',') {
                end += after + 1;
            } else if text[..start].trim_end().ends_with(',') {
                start = text[..start].trim_end().len() - 1;
            }
        }
        start..end
    });
    let places: Vec<_> = places.collect();
    let section = Section::shared("[criteria]", table, value.span(), text).measured();
    ((!places.is_empty()).then_some(section), places)
}

/// The lines of [motion] and the tables in it, and of histories that have a header of their own.
fn lines_in_time(text: &str) -> Vec<Span<usize>> {
    let (mut spans, mut start, mut inside) = (Vec::new(), 0, false);
    for line in text.split_inclusive('\n') {
        let head = line.trim_start();
        if head.starts_with('[') {
            let name = head.trim_start_matches('[').split(']').next().unwrap_or_default();
            let path: Vec<&str> =
                name.split('.').map(|key| key.trim_matches([' ', '\t', '"', '\''])).collect();
            inside = matches!(path[..], ["motion", ..] | ["load" | "wave", "history"]);
        }
        if inside {
            spans.push(start..start + line.len());
        }
        start += line.len();
    }
    spans
}

fn read(
    case: &Case,
    in_time: &InTime<'_>,
    file: &ReadFile<'_>,
    given: &GivenBase,
) -> Result<Vec<BlockCase>, Wrong> {
    let mut warnings: Vec<MotionWarning> = Vec::new();
    let mut steps: Vec<f64> = Vec::new();
    let mut taken = |read: history::Read| {
        warnings.extend(read.warnings);
        steps.extend(read.step);
        read.history
    };
    let wave = in_time
        .wave
        .as_ref()
        .map(|section| history::read_wave(section, file, case.wave.as_ref()).map(&mut taken))
        .transpose()?;
    let mut loads = Vec::new();
    for (section, force) in in_time.loads.iter().zip(&case.forces) {
        let read = section.as_ref().map(|section| {
            history::read(&section.of_force(force.magnitude, case.extent), file).map(&mut taken)
        });
        loads.push(read.transpose()?);
    }
    let section = match &in_time.motion {
        Some(motion) => motion.section("base", "[motion.base]".to_owned(), &["horizontal", "vertical"])?,
        None => None,
    };
    let mut direction = |key: &str| {
        if let Some(read) = given.read(key).map_err(|error| refused(in_time, &error))? {
            return Ok(Some(taken(read)));
        }
        let Some(section) = &section else { return Ok(None) };
        let history = section.section(key, format!("`{key}` of [motion.base]"), &KEYS)?;
        history.map(|history| history::read(&history.measured(), file).map(&mut taken)).transpose()
    };
    let base = Base { horizontal: direction("horizontal")?, vertical: direction("vertical")? };
    if base != Base::default() && case.earthquake.is_some() {
        let place = in_time.motion.as_ref().map_or(0..0, |motion| motion.place("base"));
        return Err(Wrong::new("an [earthquake] beside [motion.base] counts the same shaking twice", place)
            .help("leave one of them out"));
    }
    if case.ground.is_some() {
        let words =
            "the motion is that on a rigid base: what [ground] bears, and how it gives way, is left out"
                .to_owned();
        warnings.push(MotionWarning { name: "ground-left-out", words });
    }
    let criteria = in_time.criteria.as_ref().map_or_else(|| Ok(Vec::new()), MotionCriterion::read)?;
    let step = steps.into_iter().reduce(f64::max);
    let mut cases = Vec::new();
    for acts in &case.acting() {
        let situation = case.situation(*acts, None).map_err(|error| refused(in_time, &error.into()))?;
        let uplift = situation.loads().iter().any(|load| {
            matches!(load.source, LoadSource::WaveUplift | LoadSource::Uplift)
                && load.wrench(situation.body(), case.gravity, Pose::UPRIGHT) != Wrench::ZERO
        });
        let mut problem = standing(&situation, case.gravity).map_err(|error| refused(in_time, &error))?;
        let mut peaks = Vec::new();
        let mass = situation.body().mass();
        // Forces come in the order of the case's, and of those that act alone one only.
        let mut forces = (0..case.forces.len()).filter(|i| match acts {
            Acting::Alone(alone) => i == alone || !case.forces[*i].acts_alone(),
            Acting::All => true,
            Acting::Combination(_) => true,
        });
        for load in situation.loads() {
            if is_own_weight(load) {
                continue;
            }
            let of_force =
                if load.source == LoadSource::Force { next_force(&mut forces, case, load) } else { None };
            if load.wrench(situation.body(), case.gravity, Pose::UPRIGHT) == Wrench::ZERO {
                continue;
            }
            let history = if load.permanent {
                History::constant(1.0).map_err(|error| refused(in_time, &error))?
            } else {
                let (found, place) = match (load.source, of_force) {
                    (LoadSource::WavePressure | LoadSource::WaveUplift, _) => {
                        (wave.clone(), in_time.wave_place.clone())
                    }
                    (_, Some(i)) => (loads[i].clone(), in_time.places[i].clone()),
                    _ => (None, 0..0),
                };
                found.ok_or_else(|| {
                    Wrong::new("a load that varies has no history: nothing says how it goes with time", place)
                        .help("history = { shape = \"triangle\", rise = \"0.2 s\", duration = \"0.4 s\" }, or permanent = true")
                })?
            };
            let wrench = situation.wrench_of(load) * history.peak();
            peaks.push(LoadPeak { name: load_words(load), permanent: load.permanent, wrench });
            problem.loads.extend(acting_as(load, situation.body(), case.gravity, mass, &history));
        }
        problem.base = base.clone();
        if let Some(shaken) = &base.horizontal {
            // Water against the shaken wall, as `assess` has it.
            let unit = Earthquake::new(1.0, 0.0).map_err(|error| refused(in_time, &error.into()))?;
            for load in
                unit.loads(&case.added_mass).iter().filter(|load| load.source == LoadSource::ShakenWater)
            {
                problem.loads.extend(acting_as(load, situation.body(), case.gravity, mass, shaken));
            }
        }
        if let Some(motion) = &in_time.motion {
            settings(motion, &mut problem)?;
        }
        problem.check().map_err(|error| refused(in_time, &error))?;
        let slips = slips(&problem, step);
        let situation = case.acting_name(*acts);
        let title = case.title.clone();
        let height = case.body.height();
        cases.push(BlockCase {
            title,
            situation,
            problem,
            height,
            uplift,
            si: true,
            peaks,
            criteria: criteria.clone(),
            warnings: warnings.iter().cloned().chain(slips).collect(),
        });
    }
    Ok(cases)
}

/// The force of the case that a load is: the next whose wrench it has.
fn next_force(forces: &mut impl Iterator<Item = usize>, case: &Case, load: &StaticLoad) -> Option<usize> {
    forces.find(|i| case.forces[*i].load(&case.body).action == load.action)
}

fn refused(in_time: &InTime<'_>, error: &MotionError) -> Wrong {
    let place = in_time.motion.as_ref().map_or(0..0, |motion| {
        let key = match error {
            MotionError::Value { name, .. } => name,
            MotionError::Ratio { .. } => "impact",
            _ => "",
        };
        motion.place(key)
    });
    Wrong::new(error.to_string(), place)
}

/// Whether a load is the weight that a problem has of itself.
pub(crate) fn is_own_weight(load: &StaticLoad) -> bool {
    load.source == LoadSource::Weight && load.factor == 1.0
}

/// The body of a situation under its weight, where that is among the loads, and under nothing else.
pub(crate) fn standing(situation: &standfast::Situation, gravity: f64) -> Result<Problem, MotionError> {
    let mut problem = Problem::new(block(situation.body(), situation), gravity);
    if !situation.loads().iter().any(is_own_weight) {
        // The weight comes as a load of its own: take off the one that the problem has.
        let history = History::constant(1.0)?;
        problem.loads.push(Load { at: [0.0, 0.0], direction: [0.0, gravity], follows: false, history });
    }
    Ok(problem)
}

/// The block of a body, in metres and per its mass.
pub(crate) fn block(body: &Body, situation: &standfast::Situation) -> Block {
    Block {
        b1: body.heel_distance(),
        b2: body.toe_distance(),
        d: body.centroid_height(),
        rho2: body.moment_of_inertia() / body.mass(),
        m_x: 1.0 + situation.added_mass() / body.mass(),
        m_y: 1.0,
        mu_s: situation.static_friction(),
        mu_k: situation.kinetic_friction(),
    }
}

/// A load of the case per mass: its resultant at a point of the body, its direction fixed in space, and a couple where it has no resultant.
pub(crate) fn acting_as(
    load: &StaticLoad,
    body: &Body,
    gravity: f64,
    mass: f64,
    history: &History,
) -> Vec<Load> {
    let Wrench { x, p, m } = load.wrench(body, gravity, Pose::UPRIGHT);
    let (x, up, m) = (x / mass, -p / mass, m / mass);
    let force = |at: [f64; 2], direction: [f64; 2], follows: bool| Load {
        at,
        direction,
        follows,
        history: history.clone(),
    };
    let at = |x: f64, y: f64| [x, y];
    // Where it acts, from C.
    let place = match &load.action {
        Action::Force { at: place, .. } => {
            Some(at(place.x - body.centroid_offset(), place.y - body.centroid_height()))
        }
        Action::Pressure { face: face @ (Face::Left | Face::Right), .. } if x != 0.0 => {
            let side = if *face == Face::Left { -1.0 } else { 1.0 };
            Some(at(side * body.width() / 2.0 - body.centroid_offset(), -m / x))
        }
        Action::Pressure { face, .. } if up != 0.0 => {
            let y = if *face == Face::Base {
                -body.centroid_height()
            } else {
                body.height() - body.centroid_height()
            };
            Some(at(m / up, y))
        }
        Action::Weight | Action::Inertia { .. } => Some([0.0, 0.0]),
        _ => None,
    };
    match place {
        Some(place) => vec![force(place, [x, up], false)],
        None => vec![
            force([0.0, 0.0], [x, up], false),
            // A couple, whose moment the body's turning does not change.
            force([1.0, 0.0], [0.0, m], true),
            force([0.0, 0.0], [0.0, -m], true),
        ],
    }
}

impl From<InputError> for Wrong {
    fn from(error: InputError) -> Wrong {
        Wrong { message: error.to_string(), help: None, span: None }
    }
}
