//! Answers of a sweep against those of case files that are written out with the same values.

use standfast_cases::couple::{Variable, vary};
use standfast_cases::key::{Id, Kind, Table};
use standfast_cases::results::{ResultName, ResultValue};
use standfast_cases::sweep::{Factor, NoFactor, Sweep, SweepResult};
use standfast_cases::units::UnitError;
use standfast_cases::{Assessment, CaseFile, Inputs, Value};

const EXAMPLES: [(&str, &str); 7] = [
    ("block-two-loads", include_str!("../../../examples/block-two-loads.toml")),
    ("eccentric-caisson", include_str!("../../../examples/eccentric-caisson.toml")),
    ("goda-2000", include_str!("../../../examples/goda-2000.toml")),
    ("head-difference", include_str!("../../../examples/head-difference.toml")),
    ("quay", include_str!("../../../examples/quay.toml")),
    ("seismic-block", include_str!("../../../examples/seismic-block.toml")),
    ("trough", include_str!("../../../examples/trough.toml")),
];

/// Numbers from 0 to 1, the same in every run.
fn random() -> impl FnMut() -> f64 {
    let mut state: u64 = 2026;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// The text of a file with the numbers of `inputs` in the place of its own.
fn written(file: &CaseFile, inputs: &Inputs) -> String {
    let mut text = file.text().to_owned();
    for entry in file.entries().iter().rev() {
        let value = match (file.inputs().get(entry.id), inputs.get(entry.id)) {
            (one, two) if one == two => continue,
            (_, Some(Value::Number(number))) if entry.id.key.info().kind == Kind::InGravity => {
                format!("\"{number:?} m/s2\"")
            }
            (_, Some(Value::Number(number))) => format!("{number:?}"),
            (_, Some(Value::InGravity(share))) => format!("\"{share:?} g\""),
            (_, Some(Value::Numbers(numbers))) => format!("{numbers:?}"),
            (_, other) => panic!("{:?} became {other:?}", entry.id),
        };
        text.replace_range(entry.span.clone(), &value);
    }
    text
}

fn numbers(file: &CaseFile) -> Vec<Id> {
    let list = |id: &Id| id.key.name().contains('[');
    Variable::all(file.inputs()).filter(|id| !list(id)).collect()
}

/// Every set of numbers of a case, changed by up to a tenth: the whole answer, or the same words of what is wrong.
#[test]
fn every_answer_is_that_of_the_file_written_out() {
    let mut random = random();
    let (mut answered, mut refused) = (0, 0);
    for (name, text) in EXAMPLES {
        let file = CaseFile::parse(name, text).unwrap();
        let case = file.case().unwrap();
        let all = numbers(&file);
        for _ in 0..30 {
            let share = random();
            let ids: Vec<Id> = all.iter().copied().filter(|_| random() < 0.3 * share).collect();
            let factors: Vec<Factor> =
                ids.iter().map(|id| Factor::find(&id.to_string(), None, file.inputs()).unwrap()).collect();
            let sweep = Sweep::of(&file, factors.clone()).unwrap();
            let mut scratch = sweep.scratch();
            for _ in 0..10 {
                let value = |id: &Id| match file.inputs().get(*id) {
                    Some(Value::Number(number) | Value::InGravity(number)) => *number,
                    _ => 0.0,
                };
                let values: Vec<f64> = ids.iter().map(|id| value(id) * (0.9 + 0.2 * random())).collect();
                let si = |(factor, value): (&Factor, &f64)| match factor.counts_gravity() {
                    true => *value * file.inputs().gravity(),
                    false => *value,
                };
                let in_si: Vec<f64> = factors.iter().zip(&values).map(si).collect();
                let changes: Vec<_> = factors.iter().filter_map(Factor::variable).zip(in_si).collect();
                let mut inputs = vary(file.inputs(), &case, &changes);
                // A share of g is written as one: it goes with gravity.
                for (id, value) in
                    ids.iter().zip(&values).filter(|(id, _)| id.key.info().kind == Kind::InGravity)
                {
                    inputs.set(*id, *value * inputs.gravity());
                }
                let other = CaseFile::parse(name, &written(&file, &inputs)).and_then(|file| {
                    let assessed = Assessment::of(&file.case()?);
                    assessed.map_err(|error| file.refused(error))
                });
                match (sweep.answer(&mut scratch, &values), other) {
                    (Ok(answer), Ok(other)) => {
                        answered += 1;
                        assert_eq!(answer.assessment().all, other.all, "{name} {values:?}");
                        for result in ResultName::ALL {
                            let expected = result.of(other.governing());
                            assert_eq!(answer.get(SweepResult::Of(*result)), expected);
                        }
                        let met = other.met().map_or(ResultValue::Nothing, ResultValue::Truth);
                        assert_eq!(answer.get(SweepResult::Met), met);
                        let worst = other.checks().into_iter().next();
                        let used = worst.as_ref().and_then(|check| check.check.utilisation);
                        let used = used.map_or(ResultValue::Nothing, ResultValue::Number);
                        assert_eq!(answer.get(SweepResult::Utilisation), used);
                    }
                    (Err(_), Err(_)) => refused += 1,
                    (one, two) => panic!("{name} {ids:?} {values:?}: {one:?} but {two:?}"),
                }
            }
        }
    }
    assert!(answered > 1000 && refused > 20, "{answered} answered, {refused} refused");
}

/// Earlier rows leave no trace in an answer.
#[test]
fn the_order_of_answers_does_not_matter() {
    let file = CaseFile::parse("goda", EXAMPLES[2].1).unwrap();
    let names = ["width", "water_level", "friction"];
    let factors = names.map(|name| Factor::find(name, None, file.inputs()).unwrap());
    let sweep = Sweep::of(&file, factors.into()).unwrap();
    let mut scratch = sweep.scratch();
    let rows = [[15.0, 7.1, 0.6], [20.0, 8.0, 0.4], [-1.0, 7.1, 0.6], [14.0, 6.5, 0.7], [15.0, 7.1, 0.6]];
    let one_by_one = rows.map(|row| sweep.answer(&mut sweep.scratch(), &row));
    let in_a_row = rows.map(|row| sweep.answer(&mut scratch, &row));
    assert_eq!(one_by_one, in_a_row);
    assert!(one_by_one[2].is_err());
    // The water goes with the level, the mass with the width.
    assert_eq!(sweep.notes().len(), 1);
    assert!(sweep.notes()[0].contains("body.mass") && sweep.notes()[0].contains("wave.crest_height"));
}

#[test]
fn names_and_units_are_those_of_case_files() {
    let file = CaseFile::parse("goda", EXAMPLES[2].1).unwrap();
    let find = |name: &str, unit| Factor::find(name, unit, file.inputs());
    let height = find("wave.deep_water_height", Some("cm")).unwrap();
    assert_eq!(
        (height.value(630.0), height.parse("6300 mm"), height.parse("630")),
        (Ok(6.3), Ok(6.3), Ok(6.3))
    );
    assert!(height.parse("6.3 t").is_err());
    // The file leaves these to what is taken for them.
    for name in ["gravity", "wave.turn_deg", "body.kinetic_friction", "criteria.SF_sliding"] {
        let found = find(name, None);
        let is_taken = name == "body.kinetic_friction" || found.is_ok();
        assert!(is_taken, "{name}: {found:?}");
    }
    assert!(matches!(find("wave.Hmax", None), Err(NoFactor::Absent { .. })));
    assert!(matches!(find("wave.period", Some("m")), Err(NoFactor::Unit { .. })));
    let Err(NoFactor::Unknown(unknown)) = find("wave.perid", None) else { panic!() };
    assert_eq!(unknown.suggestion.as_deref(), Some("wave.period"));

    let file = CaseFile::parse("seismic", EXAMPLES[5].1).unwrap();
    let shaking = Factor::find("earthquake.horizontal", None, file.inputs()).unwrap();
    assert!(shaking.counts_gravity());
    assert_eq!((shaking.parse("0.2"), shaking.parse("0.2 g")), (Err(UnitError::Missing), Ok(0.2)));
    // Divided by the case's gravity, as in a case file.
    let by_gravity = shaking.parse("2 m/s2").unwrap() * file.inputs().gravity();
    assert!((by_gravity - 2.0).abs() < 1e-15, "{by_gravity}");
    let shaking = Factor::find("earthquake.horizontal", Some("m/s2"), file.inputs()).unwrap();
    assert_eq!((shaking.counts_gravity(), shaking.value(2.0)), (false, Ok(2.0)));
}

/// A bound that varies is a criterion of every row, also where the file has none.
#[test]
fn bounds_may_vary() {
    let file = CaseFile::parse("goda", EXAMPLES[2].1).unwrap();
    let bound = Factor::find("criteria.SF_sliding", None, file.inputs()).unwrap();
    assert_eq!(bound.id().unwrap().key.info().table, Table::Criteria);
    let sweep = Sweep::of(&file, vec![bound]).unwrap();
    assert!(sweep.results().contains(&SweepResult::Met));
    let mut scratch = sweep.scratch();
    let mut met = |bound: f64| sweep.answer(&mut scratch, &[bound]).unwrap().get(SweepResult::Met);
    assert_eq!((met(1.1), met(1.2)), (ResultValue::Truth(true), ResultValue::Truth(false)));
}
