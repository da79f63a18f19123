//! Change of a case's safety by a small change of each of its numbers.
//!
//! The change is that of the case with the number 1 % larger, assessed anew: no derivative, which across a kink (another load
//! governs, another formula holds) would promise what does not come.

use standfast::Departure;

use super::subject::Subject;
use super::{Varied, farthest, least, load_factor, overturning, sliding, steepest};
use crate::assess::{Assessed, Assessment};
use crate::couple::Variable;
use crate::error::CaseError;
use crate::key::{Key, Table};
use standfast_model::CaseFile;
use standfast_watch::{Portion, Stopped};

/// By how much, relatively, a number grows.
const STEP: f64 = 0.01;

/// Change of a result.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum SensitivityChange {
    /// By this much.
    By(f64),
    /// It is without bound, at present or with the number changed.
    Unlimited,
    /// There is no load factor, because the body moves at once, at present or with the number changed.
    AtOnce,
    /// There is no safety factor, because nothing presses the body on its base, or a joint, at present or with the number changed.
    Lifted,
    /// With the number changed, the case makes no sense or cannot be computed.
    NoCase,
}

impl SensitivityChange {
    /// By how much, where that is a number.
    pub fn number(self) -> Option<f64> {
        match self {
            SensitivityChange::By(change) => Some(change),
            _ => None,
        }
    }

    /// Reason why there is no number, in a word or two; empty where there is one.
    pub fn words(self) -> &'static str {
        match self {
            SensitivityChange::By(_) => "",
            SensitivityChange::Unlimited => "unlimited",
            SensitivityChange::AtOnce => "at once",
            SensitivityChange::Lifted => "lifted",
            SensitivityChange::NoCase => "no case",
        }
    }
}

/// Changes of both safety factors and the load factor if a number grows by 1 %.
#[derive(Debug, Clone)]
pub struct Sensitivity {
    /// The number.
    pub variable: Variable,
    /// Its present value, SI.
    pub value: f64,
    /// Of SF_sliding, the least of all situations.
    pub sliding: SensitivityChange,
    /// Of SF_overturning_net, about either corner, the least of all situations.
    pub overturning: SensitivityChange,
    /// Of the load factor at which the body first leaves rest, the least of all situations.
    pub load_factor: SensitivityChange,
    /// Of the displacement at the end and of the largest angle, the largest of all situations, where the motion is followed.
    pub motion: Option<[SensitivityChange; 2]>,
}

/// The sensitivity of the case of a file to every number of it but zeros. What has to go with a number goes with it: the mass
/// with the width, the crest with the height.
///
/// # Errors
/// If the case makes no sense.
pub fn sensitivities(file: &CaseFile) -> Result<Vec<Sensitivity>, CaseError> {
    let subject = Subject::of(file)?;
    let present = Assessment::of(&subject.case).ok();
    let varied = Varied { subject: &subject, follows: false, held: &[] };
    Ok(all(&varied, present.as_ref(), Portion::UNSEEN).expect("nobody stops what nobody watches"))
}

/// The sensitivity to every number but zeros, which have no percent, beside the present answer.
///
/// # Errors
/// If the portion is stopped.
pub(super) fn all(
    varied: &Varied<'_>,
    present: Option<&Assessment>,
    portion: Portion<'_>,
) -> Result<Vec<Sensitivity>, Stopped> {
    // The caisson's width is the body's, and a joint stays where its bodies meet.
    let variables = Variable::all(varied.inputs())
        .chain(Variable::implied(varied.inputs()))
        .filter(|id| !matches!(id.key, Key::CaissonWidth | Key::JointElevation))
        .map(|id| Variable::of(id, varied.inputs()));
    let variables: Vec<Variable> = variables.collect();
    let steps = portion.steps(variables.len());
    let row = |variable| {
        portion.check()?;
        let row = of(varied, present, variable);
        steps.advance();
        Ok(row)
    };
    let rows = variables.into_iter().map(row).collect::<Result<Vec<_>, Stopped>>()?;
    // A part alone seldom changes without leaving a gap or an overlap.
    let is_told = |row: &Sensitivity| {
        row.variable.id().key.info().table != Table::Part || row.sliding != SensitivityChange::NoCase
    };
    Ok(rows.into_iter().flatten().filter(is_told).collect())
}

fn of(varied: &Varied<'_>, present: Option<&Assessment>, variable: Variable) -> Option<Sensitivity> {
    let value = variable.value(varied.inputs(), varied.case());
    if value == 0.0 {
        return None;
    }
    let then = varied.answer(&variable, value * (1.0 + STEP)).ok();
    let both = present.zip(then.as_ref());
    let change = |of: fn(&Assessed) -> f64| match both.map(|(now, then)| least(then, of) - least(now, of)) {
        None => SensitivityChange::NoCase,
        // Infinity less a number, or less itself.
        Some(change) if !change.is_finite() => SensitivityChange::Unlimited,
        Some(change) => SensitivityChange::By(change),
    };
    let at_once =
        |answer: &Assessment| matches!(answer.least(load_factor).departure(), Departure::AtOnce { .. });
    let load_factor = match both {
        Some((now, then)) if at_once(now) || at_once(then) => SensitivityChange::AtOnce,
        _ => change(load_factor),
    };
    let of_factor = |of: fn(&Assessed) -> f64| match both {
        Some((now, then)) if [now, then].into_iter().any(|answer| answer.least(of).is_lifted()) => {
            SensitivityChange::Lifted
        }
        _ => change(of),
    };
    let (sliding, overturning) = (of_factor(sliding), of_factor(overturning));
    let motion = varied.follows.then(|| {
        [farthest, steepest].map(|of: fn(&Assessment) -> Option<f64>| match both {
            // A body that overturns slides and turns without bound.
            Some((now, then)) => of(then)
                .zip(of(now))
                .map_or(SensitivityChange::Unlimited, |(then, now)| SensitivityChange::By(then - now)),
            None => SensitivityChange::NoCase,
        })
    });
    Some(Sensitivity { variable, value, sliding, overturning, load_factor, motion })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of_case(text: &str, name: &str) -> [SensitivityChange; 3] {
        let file = CaseFile::parse("t.toml", text).unwrap();
        let all = sensitivities(&file).unwrap();
        let row = all.iter().find(|row| row.variable.name() == name).unwrap_or_else(|| panic!("{name}"));
        [row.sliding, row.overturning, row.load_factor]
    }

    fn by(change: SensitivityChange, expected: f64) {
        let SensitivityChange::By(found) = change else { panic!("{change:?}") };
        assert!((found - expected).abs() < 1e-12, "{found}, expected {expected}");
    }

    /// Sliding of a block in air: μ m g/F, of the larger of two forces. The first is less by half a percent, so that 1 % more
    /// of it does half of what a percent does; the second falls behind with 1 % less, but not with more.
    #[test]
    fn across_a_kink_the_change_is_the_true_one() {
        let text = "[body]\nwidth = 9\nheight = 3\nmass = 5e4\nfriction = 0.5\n\
            [[load]]\nforce = 100e3\nelevation = 0.5\n[[load]]\nforce = 100.5e3\nelevation = 0.5\n";
        let factor = |force: f64| 0.5 * 5e4 * 9.81 / force;
        let [sliding, _, load_factor] = of_case(text, "load[1].force");
        by(sliding, factor(101e3) - factor(100.5e3));
        by(load_factor, factor(101e3) - factor(100.5e3));
        by(of_case(text, "load[2].force")[0], factor(1.01 * 100.5e3) - factor(100.5e3));
        by(of_case(text, "body.friction")[0], 0.01 * factor(100.5e3));
    }

    /// Each word where it is true, and only there.
    #[test]
    fn where_there_is_no_number_the_reason_is_said() {
        let body = "[body]\nwidth = 9\nheight = 3\nmass = 5e4\nfriction = 0.5\n";
        let calm = format!("{body}[water]\nlevel = 2\ndensity = 1000\n");
        assert_eq!(of_case(&calm, "water.density"), [SensitivityChange::Unlimited; 3]);
        assert_eq!(
            of_case(
                &format!("{body}kinetic_friction = 0.5\n[[load]]\nforce = 1e5\nelevation = 0.5\n"),
                "body.kinetic_friction"
            ),
            [SensitivityChange::NoCase; 3]
        );
        let crest = format!("{body}[[load]]\nforce = 1e5\nelevation = 3\n");
        assert_eq!(of_case(&crest, "load[1].elevation"), [SensitivityChange::NoCase; 3]);
        // The water alone pushes the body away.
        let pushed = "[body]\nwidth = 2\nheight = 9\nmass = 3e4\nfriction = 0.5\n[water]\nleft = 0\nright = 8\ndensity = 1000\n\
            [[load]]\nforce = 1e5\nelevation = 3\n";
        let [sliding, overturning, load_factor] = of_case(pushed, "load[1].force");
        assert!(sliding.number().is_some() && overturning.number().is_some());
        assert_eq!(load_factor, SensitivityChange::AtOnce);
    }

    /// Given for still water and for waves, the density is one number.
    #[test]
    fn a_density_given_twice_varies_as_one() {
        let wave = "[wave]\nH13 = 3\nHmax = 5.4\nperiod = 10\nsea_bottom_slope = 0.01\nwater_depth = 9\n\
            depth_above_berm = 5.5\nbase_depth = 6\ncrest_height = 4\nberm_width = 5\nangle_deg = 0\nwater_density = 1030\n";
        let body = "[body]\nwidth = 10\nheight = 10\nmass = 230e3\nfriction = 0.6\n[water]\nlevel = 6\n";
        let once = of_case(&format!("{body}{wave}"), "wave.water_density");
        let twice = format!("{body}density = 1030\n{wave}");
        for name in ["wave.water_density", "water.density"] {
            for (one, two) in of_case(&twice, name).into_iter().zip(once) {
                by(one, two.number().unwrap());
            }
        }
        // More water under the base, and more in the waves.
        assert!(once[0].number().unwrap() < 0.0);
    }
}
