//! Text that the feature `serde` writes, and reads back.
#![cfg(feature = "serde")]

use serde::{Deserialize, Serialize};
use standfast::contact::path::stages;
use standfast::contact::{Block, solve};
use standfast::loads::{LoadKind, LoadSource};
use standfast::{Body, ClassicalActions, Corner, Mode, Modes, Motion, Slip, Wrench};

#[derive(Debug, PartialEq, Serialize, Deserialize)]
struct All {
    mode: Mode,
    modes: Modes,
    corner: Corner,
    slip: Slip,
    wrench: Wrench,
    motion: Motion,
}

/// Every type that is read comes back as it was, to the last bit, in every mode.
#[test]
fn what_is_written_is_read_back() {
    let answer = solve(&Block::uniform(1.0, 3.0), &Wrench { x: -4.0, p: 1.0, m: -2.0 / 3.0 }).unwrap();
    let motion = answer.motion(answer.mode().unwrap()).unwrap();
    for mode in Mode::ALL {
        for (corner, slip) in [(Corner::O, Slip::Left), (Corner::OPrime, Slip::Right)] {
            let modes = Mode::ALL.into_iter().filter(|other| other.code() <= mode.code()).collect();
            let all =
                All { mode, modes, corner, slip, wrench: Wrench { x: 0.1, p: -1e-300, m: 1e50 }, motion };
            let text = toml::to_string(&all).unwrap();
            assert_eq!(toml::from_str::<All>(&text).unwrap(), all, "{text}");
        }
    }
    let none: Modes =
        toml::from_str::<toml::Value>("modes = []").unwrap()["modes"].clone().try_into().unwrap();
    assert_eq!(none, Modes::NONE);
}

/// Modes are their symbols, words are in kebab-case, and what is not a mode is refused with the list of those that are.
#[test]
fn words_are_those_of_the_report() {
    let written = |value: &dyn Fn() -> Result<toml::Value, toml::ser::Error>| value().unwrap().to_string();
    assert_eq!(written(&|| toml::Value::try_from(Mode::SlideRockOPrimeLeft)), "\"SRO'-\"");
    let modes: Modes = [Mode::RockO, Mode::SlideLeft].into_iter().collect();
    assert_eq!(written(&|| toml::Value::try_from(modes)), "[\"SL\", \"RO\"]");
    assert_eq!(written(&|| toml::Value::try_from(Corner::OPrime)), "\"o-prime\"");
    assert_eq!(written(&|| toml::Value::try_from(Slip::Left)), "\"left\"");
    assert_eq!(written(&|| toml::Value::try_from(LoadKind::Horizontal)), "\"horizontal\"");
    assert_eq!(written(&|| toml::Value::try_from(LoadSource::HorizontalInertia)), "\"horizontal-inertia\"");
    let error = toml::Value::from("slides").try_into::<Mode>().unwrap_err().to_string();
    assert!(error.contains("\"slides\" is not a mode; expected one of RE, SL"), "{error}");
    for (mode, text) in Mode::ALL.map(|mode| (mode, toml::Value::from(mode.symbol()))) {
        assert_eq!(text.try_into::<Mode>().unwrap(), mode);
    }
}

/// Stages and classical actions are written by the names of their fields.
#[test]
fn results_carry_their_names() {
    let force = Wrench { x: -1.0, p: 0.0, m: 0.4 };
    let weight = Wrench { x: 0.0, p: 1.0, m: 0.0 };
    let path = stages(&Block::uniform(1.0, 0.6), &weight, &force).unwrap();
    let first = toml::Value::try_from(path[0]).unwrap();
    assert_eq!(first["from"].as_float(), Some(0.0));
    assert_eq!(first["to"].as_float(), Some(0.6));
    assert_eq!((first["mode"].as_str(), first["modes"][0].as_str()), (Some("RE"), Some("RE")));
    let body = Body::new(4.0, 6.0, 1000.0).unwrap();
    let sideways = Wrench { x: -2000.0, p: 0.0, m: 2000.0 };
    let actions = ClassicalActions::of(&body, &Wrench { p: 1e4, ..weight }, &Wrench::ZERO, &sideways);
    let actions = toml::Value::try_from(actions).unwrap();
    let table = actions.as_table().unwrap();
    assert_eq!(
        table.keys().collect::<std::collections::BTreeSet<_>>(),
        ["buoyant_weight", "force", "force_moment", "heel", "uplift", "uplift_moment", "weight_arm"]
            .map(String::from)
            .iter()
            .collect()
    );
    assert_eq!((table["heel"].as_str(), table["force_moment"].as_float()), (Some("o"), Some(8000.0)));
}
