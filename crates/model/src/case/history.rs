//! From typed inputs to a history: how a load, or the acceleration of the base, goes with time.

use standfast::history::{History, HistoryError, PointFault};
use standfast::number::significant;
use standfast_motion::record::{Baseline, Record, RecordUnit};

use super::{Reader, Waves};
use crate::error::{Fault, Problem};
use crate::inputs::{GRAVITY, Inputs, Value};
use crate::key::{Id, Key, Table};
use crate::motion::MotionWarning;
use crate::parse::BY_WAVES;
use crate::units::Extent;

/// A shape, with the keys that it has beside `shape` and `start`; those behind the bar need not be there.
type Shape = (&'static str, &'static [Key], &'static [Key]);

const SHAPES: [Shape; 9] = [
    ("constant", &[], &[Key::HistoryPeak]),
    ("rect", &[Key::HistoryDuration], &[Key::HistoryPeak]),
    ("triangle", &[Key::HistoryRise, Key::HistoryDuration], &[Key::HistoryPeak]),
    ("decay", &[Key::HistoryDuration], &[Key::HistoryPeak]),
    ("half-sine", &[Key::HistoryDuration], &[Key::HistoryPeak]),
    (
        "sine",
        &[Key::HistoryDuration],
        &[Key::HistoryPeak, Key::AngularFrequency, Key::HistoryPeriod, Key::Phase],
    ),
    (
        "church-roof",
        &[Key::HistoryRise, Key::ImpactDuration, Key::HistoryDuration],
        &[Key::HistoryPeak, Key::Tail],
    ),
    ("points", &[Key::Times, Key::Values], &[Key::HistoryPeak]),
    (
        "file",
        &[Key::RecordFile],
        &[Key::RecordColumn, Key::RecordStep, Key::RecordFactor, Key::TargetPeak, Key::Baseline],
    ),
];

/// The shapes of a history: the name of each, the keys that it needs, and those that it may have beside `start`.
pub fn history_shapes() -> impl Iterator<Item = (&'static str, &'static [Key], &'static [Key])> {
    SHAPES.into_iter()
}

/// Course of a history of the inputs as a factor, before it is shifted to its start; `None` of a record, of one that lasts as its waves say,
/// and of a faulty one.
pub fn course(inputs: &Inputs, table: Table, index: usize) -> Option<History> {
    let field = Field { given: &Reader { inputs }, table, index, of: HistoryOf::Pure };
    let shape = inputs.choice(field.id(Key::HistoryShape)).filter(|shape| *shape != "file")?;
    field.course(shape).ok()?.ok()
}

/// Quantity that varies in a history.
#[derive(Clone, Copy)]
pub(crate) enum HistoryOf<'a> {
    /// The acceleration of the base under a body.
    Base,
    /// A force, N, in a case of this extent.
    Force(f64, Extent),
    /// Waves.
    Waves(&'a Waves),
    /// Anything of a body in pure numbers.
    Pure,
}

/// A history with what it gives reason to warn of.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ReadHistory {
    pub(crate) history: History,
    pub(crate) warnings: Vec<MotionWarning>,
    /// The longest step between the points of a file.
    pub(crate) step: Option<f64>,
}

/// A history of the inputs, in one of the tables that have histories.
struct Field<'a> {
    given: &'a Reader<'a>,
    table: Table,
    index: usize,
    of: HistoryOf<'a>,
}

impl Reader<'_> {
    /// The history in the `index`-th of a kind of tables, where there is one.
    pub(crate) fn history(
        &self,
        table: Table,
        index: usize,
        of: HistoryOf<'_>,
    ) -> Result<Option<ReadHistory>, Fault> {
        if !self.inputs.has_at(table, index) {
            return Ok(None);
        }
        Field { given: self, table, index, of }.read().map(Some)
    }
}

impl Field<'_> {
    fn id(&self, key: Key) -> Id {
        Id::of(self.table, self.index, key)
    }

    fn number(&self, key: Key) -> Option<f64> {
        self.given.inputs.number(self.id(key))
    }

    fn has(&self, key: Key) -> bool {
        self.given.inputs.get(self.id(key)).is_some()
    }

    fn needed(&self, key: Key) -> Result<f64, Fault> {
        self.number(key).ok_or_else(|| self.lacks(key))
    }

    fn lacks(&self, key: Key) -> Fault {
        self.given.missing_in(self.id(key))
    }

    fn read(&self) -> Result<ReadHistory, Fault> {
        let shape = self.given.inputs.choice(self.id(Key::HistoryShape));
        let shape = shape.ok_or_else(|| self.lacks(Key::HistoryShape))?;
        self.only_of(shape)?;
        if self.is_by_waves() {
            return self.by_waves(shape);
        }
        let start = self.number(Key::HistoryStart).unwrap_or(0.0);
        if shape == "file" {
            return self.recorded(start);
        }
        let history = self.course(shape)?;
        let history =
            history.and_then(|history| history.starting(start)).map_err(|error| self.refused(error))?;
        let values = self.given.inputs.list(self.id(Key::Values)).unwrap_or_default();
        let warnings = cut(values, "the points").into_iter().collect();
        Ok(ReadHistory { history, warnings, step: None })
    }

    /// Refuses keys of other shapes.
    fn only_of(&self, shape: &'static str) -> Result<(), Fault> {
        let Some((_, needed, open)) = SHAPES.iter().find(|(name, ..)| *name == shape) else { return Ok(()) };
        let known = |key: Key| {
            matches!(key, Key::HistoryShape | Key::HistoryStart)
                || needed.contains(&key)
                || open.contains(&key)
        };
        match self.table.keys().find(|key| self.has(*key) && !known(*key)) {
            Some(key) => {
                let takes = open.iter().chain(*needed).map(|key| key.name()).collect();
                Err(Fault::new(Problem::HistoryKey { key, shape, takes }, self.id(key)))
            }
            None => Ok(()),
        }
    }

    fn course(&self, shape: &str) -> Result<Result<History, HistoryError>, Fault> {
        // Values of an acceleration without the peak that they are shares of would be in m/s² and not say so.
        if matches!(self.of, HistoryOf::Base) && !self.has(Key::HistoryPeak) {
            return Err(self.lacks(Key::HistoryPeak));
        }
        let peak = self.number(Key::HistoryPeak).unwrap_or(1.0);
        let duration = || self.needed(Key::HistoryDuration);
        Ok(match shape {
            "constant" => History::constant(peak),
            "rect" => History::rect(peak, duration()?),
            "triangle" => History::triangle(peak, self.needed(Key::HistoryRise)?, duration()?),
            "decay" => History::decay(peak, duration()?),
            "half-sine" => History::half_sine(peak, duration()?),
            "sine" => {
                let phase = self.number(Key::Phase).unwrap_or(0.0);
                History::sine(peak, self.frequency()?, phase, duration()?)
            }
            "church-roof" => History::church_roof(
                peak,
                self.needed(Key::HistoryRise)?,
                self.needed(Key::ImpactDuration)?,
                self.number(Key::Tail).unwrap_or(0.0),
                duration()?,
            ),
            _ => {
                let list = |key| self.given.inputs.list(self.id(key)).ok_or_else(|| self.lacks(key));
                let (times, values) = (list(Key::Times)?, list(Key::Values)?);
                if times.len() != values.len() {
                    let error = HistoryError::Lengths { times: times.len(), values: values.len() };
                    return Err(self.refused(error));
                }
                let points: Vec<_> = times.iter().zip(values).map(|(t, value)| [*t, *value]).collect();
                History::stepped(&points).map(|history| history.times_factor(peak))
            }
        })
    }

    fn frequency(&self) -> Result<f64, Fault> {
        match (self.number(Key::AngularFrequency), self.number(Key::HistoryPeriod)) {
            (Some(_), Some(_)) => {
                let problem = Problem::BothIn {
                    table: self.table,
                    one: Key::AngularFrequency,
                    two: Key::HistoryPeriod,
                };
                Err(Fault::new(problem, self.id(Key::HistoryPeriod)))
            }
            (Some(ω), None) => Ok(ω),
            (None, Some(period)) => Ok(std::f64::consts::TAU / period),
            (None, None) => Err(self.lacks(Key::AngularFrequency)),
        }
    }

    fn is_by_waves(&self) -> bool {
        matches!(self.given.inputs.get(self.id(Key::HistoryDuration)), Some(Value::Choice(_)))
    }

    /// The history of an impulsive thrust whose duration the waves give: Shimosako and Takahashi's, a triangle with its peak in the
    /// middle, for τ₀F = max(0.4, 0.5 − H/(8h)) T and k = 1/(α*^0.3 + 1)², of k τ₀F.
    fn by_waves(&self, shape: &'static str) -> Result<ReadHistory, Fault> {
        let HistoryOf::Waves(of) = self.of else { return Err(self.lacks(Key::HistoryDuration)) };
        let words = BY_WAVES;
        let Some(waves) = of.goda() else {
            return Err(Fault::new(Problem::ByOtherWaves { words }, self.id(Key::HistoryDuration)));
        };
        if shape != "triangle" {
            return Err(Fault::new(Problem::ByWavesShape { words }, self.id(Key::HistoryShape)));
        }
        if self.has(Key::HistoryRise) {
            return Err(Fault::new(Problem::ByWavesRise { words }, self.id(Key::HistoryRise)));
        }
        let goda = &waves.goda;
        let period = waves.sea.period * (0.5 - goda.h_max / (8.0 * waves.sea.water_depth)).max(0.4);
        let share = 1.0 / (goda.alpha_star.powf(0.3) + 1.0).powi(2);
        let duration = share * period;
        let start = self.number(Key::HistoryStart).unwrap_or(0.0);
        let peak = self.number(Key::HistoryPeak).unwrap_or(1.0);
        let history = History::triangle(peak, 0.5 * duration, duration);
        let history =
            history.and_then(|history| history.starting(start)).map_err(|error| self.refused(error))?;
        let words = format!(
            "the wave's thrust lasts {duration:.4} s by the formulas of Shimosako and Takahashi; it is usually measured in a model"
        );
        Ok(ReadHistory {
            history,
            warnings: vec![MotionWarning { name: "duration-by-formula", words }],
            step: None,
        })
    }

    /// A record of a file.
    fn recorded(&self, start: f64) -> Result<ReadHistory, Fault> {
        let id = self.id(Key::RecordFile);
        let inputs = self.given.inputs;
        let file = match (inputs.record(id), inputs.text(id)) {
            (Some(file), _) => file,
            (None, Some(name)) => {
                let why = "it is not read yet".to_owned();
                return Err(Fault::new(Problem::Unread { name: name.to_owned(), why }, id));
            }
            (None, None) => return Err(self.lacks(Key::RecordFile)),
        };
        let column = inputs.text(self.id(Key::RecordColumn));
        let wrong = |words: String| Fault::new(Problem::Record { words, help: None }, id);
        let record =
            file.record(column, self.number(Key::RecordStep)).map_err(|error| wrong(error.to_string()))?;
        // One that is given as an array, and not in a file, may be in the units of the case.
        let is_in_its_units = file.text().is_none()
            && (record.unit == RecordUnit::Unnamed || matches!(self.of, HistoryOf::Pure));
        let unit = if is_in_its_units { 1.0 } else { self.unit_of(file.name(), &record, column)? };
        let record = match inputs.choice(self.id(Key::Baseline)) {
            Some("mean") => record.corrected(Baseline::Mean),
            Some(_) => record.corrected(Baseline::Linear),
            None => record,
        };
        let factor = match (self.number(Key::RecordFactor), self.number(Key::TargetPeak)) {
            (Some(_), Some(_)) => {
                let problem =
                    Problem::BothIn { table: self.table, one: Key::RecordFactor, two: Key::TargetPeak };
                return Err(Fault::new(problem, self.id(Key::TargetPeak)));
            }
            (None, Some(0.0)) => {
                let (key, expected) = (Key::TargetPeak, "another number than zero");
                let problem = Problem::OutOfRange { key, written: "0".to_owned(), expected };
                return Err(Fault::new(problem, self.id(key)));
            }
            (None, Some(_)) if record.peak() == 0.0 => {
                let words = format!("{} is zero throughout: nothing scales it to a peak", file.name());
                return Err(Fault::new(Problem::Record { words, help: None }, self.id(Key::TargetPeak)));
            }
            (None, Some(peak)) => peak / (record.peak() * unit),
            (factor, None) => factor.unwrap_or(1.0),
        };
        self.of_record(file.name(), &record, unit * factor, start)
    }

    /// The history of a record, its values times a factor, with what it gives reason to warn of.
    fn of_record(&self, name: &str, record: &Record, factor: f64, start: f64) -> Result<ReadHistory, Fault> {
        let [velocity, displacement] = record.drift().map(|drift| significant(drift * factor, 3));
        let [speed, metres] = match self.of {
            HistoryOf::Base => [" m/s", " m"],
            _ => ["", ""],
        };
        let mut warnings: Vec<MotionWarning> = cut(&record.values, name).into_iter().collect();
        // Of a force the ground does not move.
        if matches!(self.of, HistoryOf::Base | HistoryOf::Pure) {
            let words = format!(
                "{name} ends with a velocity of {velocity}{speed} and a displacement of {displacement}{metres} of the ground"
            );
            warnings.push(MotionWarning { name: "record-drift", words });
        }
        let history = record.history(factor).and_then(|history| history.starting(start));
        let history = history.map_err(|error| self.refused(error))?;
        let longest = record.times.windows(2).map(|pair| pair[1] - pair[0]).reduce(f64::max);
        Ok(ReadHistory { history, warnings, step: longest })
    }

    /// Factor on the values of a record: 1 of pure numbers, and of shares of the load's own force.
    fn unit_of(&self, name: &str, record: &Record, column: Option<&str>) -> Result<f64, Fault> {
        let wrong = |words: String, help: Option<&'static str>| {
            Fault::new(Problem::Record { words, help }, self.id(Key::RecordFile))
        };
        match self.of {
            HistoryOf::Pure if record.unit == RecordUnit::Gravity && !self.is_scaled() => Err(wrong(
                format!("{name} is in units of g, and a [block] has accelerations as they come"),
                Some(
                    "factor says what g is in the numbers of the block, for example factor = 1 where its gravity is 1",
                ),
            )),
            HistoryOf::Pure => Ok(1.0),
            HistoryOf::Base => {
                let unit = record.known_unit(name, column).map_err(|error| wrong(error.to_string(), None))?;
                if !unit.is_acceleration() {
                    let words =
                        format!("{name} is not a record of an acceleration, as that of a base has to be");
                    return Err(wrong(words, None));
                }
                Ok(unit.si(self.given.inputs.gravity()))
            }
            HistoryOf::Force(force, extent) => of_own_force(Some((force, extent)), name, record)
                .map_err(|(words, help)| wrong(words, Some(help))),
            HistoryOf::Waves(_) => {
                of_own_force(None, name, record).map_err(|(words, help)| wrong(words, Some(help)))
            }
        }
    }

    /// True if the factor or the peak of a record is given.
    fn is_scaled(&self) -> bool {
        self.has(Key::RecordFactor) || self.has(Key::TargetPeak)
    }

    /// Refusal by the library, shown at the key it is about.
    fn refused(&self, error: HistoryError) -> Fault {
        let key = match error {
            HistoryError::Value { name, .. } => self.table.keys().find(|key| key.name() == name),
            HistoryError::Point { fault: PointFault::Value, .. } => Some(Key::Values),
            HistoryError::Lengths { .. } => Some(Key::Values),
            _ => Some(Key::Times),
        };
        let id = self.id(key.unwrap_or(Key::HistoryShape));
        Fault::new(Problem::History { table: self.table, error }, id)
    }
}

/// Values that stop short of zero.
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

/// Factor on the values of a record of a load: 1 of shares of the load's own force; of a force, its unit over that force.
fn of_own_force(
    own: Option<(f64, Extent)>,
    name: &str,
    record: &Record,
) -> Result<f64, (String, &'static str)> {
    const UNITS: &str = "name the column with its unit, as force_kN_m per metre run or force_kN of a whole object, or share if it \
                         multiplies the load's own force";
    match (record.unit, own) {
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
        (unit, Some((force, _))) if force > 0.0 => Ok(unit.si(GRAVITY) / force),
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
