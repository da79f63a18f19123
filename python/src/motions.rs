//! Many motions of one case: records as arrays, bodies with other numbers, and what became of each as columns.

use std::num::NonZero;
use std::thread;

use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use standfast::HistoryTimes;
use standfast_cases::CaseFile;
use standfast_cases::motion::{
    End, Factors, Follow, MotionOf, MotionsAsked, MotionsFound, ShakingArray, StrengthAsked, motions_of,
    still_base,
};

use standfast_probability::sample::Estimate;

use crate::errors::{StandfastError, of_motions};
use crate::simulate::{CopiesGiven, MotionCase, copies_options, read_on};
use crate::watch::watched_within;

/// Arguments of a call, as `_motions.py` gives them.
#[derive(FromPyObject)]
pub(crate) struct Arguments<'py> {
    horizontal: Vec<PyReadonlyArray1<'py, f64>>,
    vertical: Option<Vec<PyReadonlyArray1<'py, f64>>>,
    /// The step of time of each record.
    steps: Vec<f64>,
    unit: Option<String>,
    names: Vec<String>,
    bodies: Vec<Vec<f64>>,
    number: usize,
    cross: bool,
    divergence: bool,
    strength: bool,
    copies: CopiesGiven,
    threads: Option<NonZero<usize>>,
    progress: Option<Py<PyAny>>,
}

/// Name, unit and words of a column, and its numbers.
type Numbers<'py> = (&'static str, &'static str, &'static str, Bound<'py, PyArray1<f64>>);
/// Name and words of a column, and its whole numbers or truth values.
type Counts<'py> = (&'static str, &'static str, Bound<'py, PyArray1<i64>>);
type Truths<'py> = (&'static str, &'static str, Bound<'py, PyArray1<bool>>);
/// Numbers, whole numbers, truth values, ends, warnings with their words and how many have them, and whether quantities are in SI units.
type Columns<'py> = (
    Vec<Numbers<'py>>,
    Vec<Counts<'py>>,
    Vec<Truths<'py>>,
    Vec<&'static str>,
    Vec<(&'static str, String, usize)>,
    bool,
);

/// Follows many motions of a case.
#[pyfunction]
pub(crate) fn motions<'py>(
    py: Python<'py>,
    case: MotionCase,
    asked: Arguments<'py>,
) -> PyResult<Columns<'py>> {
    let has_vertical = asked.vertical.is_some();
    let (file, _) = read_on(case, |file| still_base(file, has_vertical))?;
    let is_si = !file.inputs().has(standfast_cases::key::Table::Block);
    match &asked.unit {
        None if is_si => {
            let words = "unit is missing; expected that of the accelerations in base: 'm/s2', 'g', 'cm/s2'";
            return Err(StandfastError::new_err(words));
        }
        Some(unit) if !is_si => {
            return Err(StandfastError::new_err(format!(
                "unit is '{unit}', and the case has a [block], whose accelerations have no unit; leave it out"
            )));
        }
        _ => {}
    }
    let unit = match asked.unit.as_deref() {
        Some("g") => file.inputs().gravity(),
        Some("cm/s2") => 0.01,
        _ => 1.0,
    };
    let copies = copies_options(asked.copies);
    let mut records = Vec::with_capacity(asked.horizontal.len());
    let mut times: Option<(f64, HistoryTimes)> = None;
    for (place, values) in asked.horizontal.iter().enumerate() {
        let (step, horizontal) = (asked.steps[place], values.as_slice()?);
        let known =
            times.as_ref().filter(|(of, times)| *of == step && times.times().len() == horizontal.len());
        let own = match known {
            Some((_, times)) => times.clone(),
            None => HistoryTimes::even(step, horizontal.len())
                .map_err(|error| StandfastError::new_err(format!("record {place}: {error}")))?,
        };
        times = Some((step, own.clone()));
        let vertical = match &asked.vertical {
            Some(vertical) => Some(vertical[place].as_slice()?),
            None => None,
        };
        records.push(ShakingArray { times: own, horizontal, vertical });
    }
    let threads = asked.threads.or_else(|| thread::available_parallelism().ok()).map_or(1, NonZero::get);
    let strength = if asked.strength { StrengthAsked::Always(Factors::Rungs) } else { StrengthAsked::No };
    let follow = Follow { divergence: asked.divergence, strength, ..Follow::default() };
    let (names, bodies, count, is_crossed) = (asked.names, asked.bodies, asked.number, asked.cross);
    let found = watched_within(py, asked.progress.as_ref(), |portion| {
        let asked = MotionsAsked {
            records: &records,
            unit,
            names: &names,
            bodies: &bodies,
            count,
            is_crossed,
            follow,
            copies: &copies,
            threads,
        };
        motions_of(&file, &asked, portion).map_err(|error| of_motions(&error))
    })??;
    Ok(columns(py, &file, &found, &follow, is_si))
}

fn columns<'py>(
    py: Python<'py>,
    file: &CaseFile,
    MotionsFound { motions: found, warnings }: &MotionsFound,
    follow: &Follow,
    is_si: bool,
) -> Columns<'py> {
    let numbers = |of: &dyn Fn(&MotionOf) -> Option<f64>| {
        PyArray1::from_vec(py, found.iter().map(|one| of(one).unwrap_or(f64::NAN)).collect())
    };
    let whole =
        |of: fn(&MotionOf) -> usize| PyArray1::from_vec(py, found.iter().map(|one| of(one) as i64).collect());
    let truths = |of: fn(&MotionOf) -> bool| PyArray1::from_vec(py, found.iter().map(of).collect());
    let mut of_numbers: Vec<Numbers<'py>> = vec![
        ("slide", "m", "displacement along the base at the end", numbers(&|one| Some(one.slide))),
        ("max_slide", "m", "largest displacement to either side", numbers(&|one| Some(one.max_slide))),
        ("max_theta", "rad", "largest angle to either side", numbers(&|one| Some(one.max_theta))),
        (
            "max_theta_of_balance",
            "",
            "the same over the angle of balance",
            numbers(&|one| Some(one.max_theta_of_balance)),
        ),
        ("t_rest", "s", "since when it rests; none of one that does not", numbers(&|one| one.t_rest)),
        (
            "friction_loss",
            "J/kg",
            "energy that friction takes, per mass",
            numbers(&|one| Some(one.friction_loss)),
        ),
        ("impact_loss", "J/kg", "energy that impacts take, per mass", numbers(&|one| Some(one.impact_loss))),
    ];
    if follow.divergence {
        of_numbers.push((
            "divergence",
            "",
            "how much small relative errors grow",
            numbers(&|one| one.divergence),
        ));
    }
    if follow.strength != StrengthAsked::No {
        for (place, name, words) in [
            (0, "onset", "factor on the loads at which it begins to move"),
            (1, "stronger", "nearest factor above 1 at which it overturns, or not, unlike here"),
            (2, "weaker", "nearest factor below 1 at which it does"),
        ] {
            of_numbers.push((name, "", words, numbers(&|one| one.strength[place])));
        }
    }
    if found.iter().any(|one| one.overturned_share.is_some()) {
        let share = |of: fn(Estimate) -> f64| numbers(&move |one| one.overturned_share.map(of));
        of_numbers.push((
            "overturned_share",
            "",
            "share of copies that overturn",
            share(|share| share.value),
        ));
        of_numbers.push((
            "overturned_share_low",
            "",
            "lower end of its interval of 95 %",
            share(|share| share.low),
        ));
        of_numbers.push((
            "overturned_share_high",
            "",
            "upper end of its interval",
            share(|share| share.high),
        ));
    }
    let counts = vec![
        ("record", "place of its record", whole(|one| one.record)),
        ("body", "place of its body", whole(|one| one.body)),
        ("impacts", "how often a corner meets the base", whole(|one| one.impacts)),
    ];
    let mut flags = vec![
        ("overturned", "whether it overturns", truths(|one| one.end == End::Overturned)),
        ("at_rest", "whether it comes to rest for good", truths(|one| one.end == End::AtRest)),
    ];
    if file.motion_criteria().is_ok_and(|criteria| !criteria.is_empty()) {
        flags.push(("met", "whether all criteria are met", truths(|one| one.met == Some(true))));
    }
    let ends = found.iter().map(|one| one.end.word()).collect();
    let warnings =
        warnings.iter().map(|(warning, count)| (warning.name, warning.words.clone(), *count)).collect();
    (of_numbers, counts, flags, ends, warnings, is_si)
}
