//! Histories: the shapes of a case file.

use standfast::number::exact;
use standfast_motion::record::{Baseline, Record, RecordUnit};
use standfast_motion::{History, MotionError, Problematic};

use super::error::Wrong;
use super::table::Section;
use super::{MotionWarning, ReadFile};
use crate::case::Waves;
use crate::units::Extent;

/// A shape, with the keys it has beside `shape` and `start`.
const SHAPES: [(&str, &[&str]); 9] = [
    ("constant", &["peak"]),
    ("rect", &["peak", "duration"]),
    ("triangle", &["peak", "rise", "duration"]),
    ("decay", &["peak", "duration"]),
    ("half-sine", &["peak", "duration"]),
    ("sine", &["peak", "angular_frequency", "period", "phase", "duration"]),
    ("church-roof", &["peak", "rise", "impact_duration", "tail", "duration"]),
    ("points", &["peak", "times", "values"]),
    ("file", &["file", "column", "dt", "factor", "target_peak", "baseline"]),
];

/// Every key of a history.
pub(crate) const KEYS: [&str; 18] = [
    "shape",
    "start",
    "peak",
    "duration",
    "rise",
    "angular_frequency",
    "period",
    "phase",
    "impact_duration",
    "tail",
    "times",
    "values",
    "file",
    "column",
    "dt",
    "factor",
    "target_peak",
    "baseline",
];

/// A history with what it gives reason to warn of.
pub(crate) struct Read {
    pub history: History,
    pub warnings: Vec<MotionWarning>,
    /// The longest step between the points of a file.
    pub step: Option<f64>,
}

/// Reads the history under `section`.
pub(crate) fn read(section: &Section<'_>, file: &ReadFile<'_>) -> Result<Read, Wrong> {
    let shapes = SHAPES.map(|(name, keys)| (name, (name, keys)));
    let (shape, keys) = section.choice("shape", &shapes)?.ok_or_else(|| {
        let names: Vec<String> = SHAPES.iter().map(|(name, _)| format!("\"{name}\"")).collect();
        section.lacks("shape").help(format!("the shapes: {}", names.join(", ")))
    })?;
    let foreign = KEYS[2..].iter().find(|key| section.get(key).is_some() && !keys.contains(key));
    if let Some(key) = foreign {
        let message = format!("`{key}` does not go with the shape \"{shape}\"");
        return Err(
            Wrong::new(message, section.place(key)).help(format!("\"{shape}\" has {}", keys.join(", ")))
        );
    }
    let number = |key: &str| section.needed(key);
    let peak = || section.number("peak").map(|peak| peak.unwrap_or(1.0));
    let start = section.number("start")?.unwrap_or(0.0);
    let mut warnings = Vec::new();
    let history = match shape {
        "file" => return recorded(section, file, start),
        "constant" => History::constant(peak()?),
        "rect" => History::rect(peak()?, number("duration")?),
        "triangle" => History::triangle(peak()?, number("rise")?, number("duration")?),
        "decay" => History::decay(peak()?, number("duration")?),
        "half-sine" => History::half_sine(peak()?, number("duration")?),
        "sine" => {
            let ω = frequency(section)?;
            History::sine(peak()?, ω, section.number("phase")?.unwrap_or(0.0), number("duration")?)
        }
        "church-roof" => History::church_roof(
            peak()?,
            number("rise")?,
            number("impact_duration")?,
            section.number("tail")?.unwrap_or(0.0),
            number("duration")?,
        ),
        _ => {
            let times = section.numbers("times")?.ok_or_else(|| section.lacks("times"))?;
            let values = section.numbers("values")?.ok_or_else(|| section.lacks("values"))?;
            warnings.extend(cut(&values, "the points"));
            let peak = peak()?;
            History::points(&times, &values).map(|history| history.times_factor(peak))
        }
    };
    let history =
        history.and_then(|history| history.starting(start)).map_err(|error| refused(section, &error))?;
    Ok(Read { history, warnings, step: None })
}

/// A duration that the waves give: Shimosako and Takahashi's of an impulsive thrust, a triangle with its peak in the middle, for
/// τ₀F = max(0.4, 0.5 − H/(8h)) T and k = 1/(α*^0.3 + 1)², α* the larger of α₂ and α_I, of k τ₀F. Both formulas are recalled; the
/// original was not read.
const BY_WAVES: &str = "shimosako-takahashi";

/// The history of a wave; `waves` is what its duration may follow from.
pub(crate) fn read_wave(
    section: &Section<'_>,
    file: &ReadFile<'_>,
    waves: Option<&Waves>,
) -> Result<Read, Wrong> {
    let asked = section.get("duration").and_then(|value| value.get_ref().as_str());
    let (Some(BY_WAVES), Some(waves)) = (asked, waves) else { return read(section, file) };
    if section.words("shape")? != Some("triangle") {
        let message = format!("duration = \"{BY_WAVES}\" is that of a triangle");
        return Err(Wrong::new(message, section.place("shape")).help("shape = \"triangle\""));
    }
    let keys = ["shape", "start", "peak", "duration"];
    if let Some(key) = KEYS.iter().find(|key| section.get(key).is_some() && !keys.contains(key)) {
        let message =
            format!("`{key}` does not go with duration = \"{BY_WAVES}\", whose peak is in the middle");
        return Err(Wrong::new(message, section.place(key)));
    }
    let goda = &waves.goda;
    let period = waves.sea.period * (0.5 - goda.h_max / (8.0 * waves.sea.water_depth)).max(0.4);
    let share = 1.0 / (goda.alpha_2.max(goda.alpha_impulsive).powf(0.3) + 1.0).powi(2);
    let duration = share * period;
    let (start, peak) = (section.number("start")?.unwrap_or(0.0), section.number("peak")?.unwrap_or(1.0));
    let history =
        History::triangle(peak, 0.5 * duration, duration).and_then(|history| history.starting(start));
    let history = history.map_err(|error| refused(section, &error))?;
    let words = format!(
        "the wave's thrust lasts {duration:.4} s by formulas of Shimosako and Takahashi that are recalled: the original was not read"
    );
    Ok(Read { history, warnings: vec![MotionWarning { name: "duration-recalled", words }], step: None })
}

fn longest(times: &[f64]) -> Option<f64> {
    times.windows(2).map(|pair| pair[1] - pair[0]).reduce(f64::max)
}

fn frequency(section: &Section<'_>) -> Result<f64, Wrong> {
    match (section.number("angular_frequency")?, section.number("period")?) {
        (Some(_), Some(_)) => Err(Wrong::new(
            format!("{} has both `angular_frequency` and `period`", section.name),
            section.place("period"),
        )),
        (Some(ω), None) => Ok(ω),
        (None, Some(period)) if period > 0.0 => Ok(std::f64::consts::TAU / period),
        (None, Some(period)) => {
            let message = format!("`period` is {}; expected a number above zero", exact(period));
            Err(Wrong::new(message, section.place("period")))
        }
        (None, None) => Err(section.lacks("angular_frequency").help("or give `period`")),
    }
}

/// What the library refuses, shown at the key it is about.
fn refused(section: &Section<'_>, error: &MotionError) -> Wrong {
    let key = match error {
        MotionError::Value { name, .. } => name,
        MotionError::Point { problem: Problematic::Value, .. } => "values",
        MotionError::Point { .. } | MotionError::Lengths { .. } | MotionError::FewPoints { .. } => "times",
        _ => "shape",
    };
    Wrong::new(format!("{}: {error}", section.name), section.place(key))
}

/// A record that stops short of zero.
fn cut(values: &[f64], what: &str) -> Option<MotionWarning> {
    let peak = values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    let last = values.last().copied().unwrap_or(0.0);
    (last.abs() > 0.01 * peak).then(|| MotionWarning {
        name: "record-ends-abruptly",
        words: format!(
            "the last value of {what} is {:.1} % of the peak, and drops to 0 there",
            100.0 * last.abs() / peak
        ),
    })
}

/// A record of a file, its numbers as they come.
fn recorded(section: &Section<'_>, file: &ReadFile<'_>, start: f64) -> Result<Read, Wrong> {
    let name = section.words("file")?.ok_or_else(|| section.lacks("file"))?;
    let place = || section.place("file");
    let text = file(name).map_err(|why| Wrong::new(format!("cannot read {name}: {why}"), place()))?;
    let record = Record::parse(name, &text, section.words("column")?, section.number("dt")?);
    let record = record.map_err(|error| Wrong::new(error.to_string(), place()))?;
    let unit = match () {
        () if section.is_of_load() => of_own_force(section, name, &record)
            .map_err(|(message, help)| Wrong::new(message, place()).help(help))?,
        () if !section.is_measured() => 1.0,
        () => {
            let unit = record.known_unit(name, section.words("column")?);
            let unit = unit.map_err(|error| Wrong::new(error.to_string(), place()))?;
            if !unit.is_acceleration() {
                return Err(Wrong::new(
                    format!("{name} is no record of an acceleration, as that of a base has to be"),
                    place(),
                ));
            }
            unit.si()
        }
    };
    let baseline = section.choice("baseline", &[("mean", Baseline::Mean), ("linear", Baseline::Linear)])?;
    let record = match baseline {
        Some(baseline) => record.corrected(baseline),
        None => record,
    };
    let factor = unit
        * match (section.number("factor")?, section.number("target_peak")?) {
            (Some(_), Some(_)) => {
                let message = format!("{} has both `factor` and `target_peak`", section.name);
                return Err(Wrong::new(message, section.place("target_peak")));
            }
            (None, Some(peak)) => peak / (record.peak() * unit),
            (factor, None) => factor.unwrap_or(1.0),
        };
    of_record(name, &record, factor, start).map_err(|error| refused(section, &error))
}

/// What the values of a record of a load are multiplied by: 1 of shares of the load's own force; a force is that force itself.
fn of_own_force(section: &Section<'_>, name: &str, record: &Record) -> Result<f64, (String, &'static str)> {
    const UNITS: &str = "name the column with its unit, as force_kN_m per metre run or force_kN of a whole object, or share if it \
                         multiplies the load's own force";
    match (record.unit, section.force()) {
        (RecordUnit::Share, _) => Ok(1.0),
        (RecordUnit::Unnamed, _) => {
            Err((format!("{name}: the column of values names no unit of a force"), UNITS))
        }
        (unit, _) if unit.is_acceleration() => {
            Err((format!("{name} is a record of an acceleration; expected one of a force"), UNITS))
        }
        (unit, Some((_, extent))) if unit.is_per_metre() != (extent == Extent::PerMetre) => {
            let [found, expected] = match unit.is_per_metre() {
                true => ["per metre run", "of a whole object"],
                false => ["of a whole object", "per metre run"],
            };
            Err((format!("{name} is a record of a force {found}; this case has forces {expected}"), UNITS))
        }
        (unit, Some((force, _))) if force > 0.0 => Ok(unit.si() / force),
        (_, Some(_)) => Err((
            format!("{name} is a record of a force, and the load has a force of 0"),
            "give the load the peak of its record as `force`",
        )),
        (_, None) => Err((
            format!(
                "{name} has a unit of force, and a wave has pressures of its own that the record multiplies"
            ),
            "name the column without a unit, as share",
        )),
    }
}

/// The history of a record, its values times a factor, with what it gives reason to warn of.
pub(crate) fn of_record(name: &str, record: &Record, factor: f64, start: f64) -> Result<Read, MotionError> {
    let [velocity, displacement] = record.drift().map(|drift| drift * factor);
    let mut warnings: Vec<MotionWarning> = cut(&record.values, name).into_iter().collect();
    warnings.push(MotionWarning {
        name: "record-drift",
        words: format!("{name} ends with a velocity of {velocity:.3e} and a displacement of {displacement:.3e} of the ground"),
    });
    let history = record.history(factor)?.starting(start)?;
    Ok(Read { history, warnings, step: longest(&record.times) })
}
