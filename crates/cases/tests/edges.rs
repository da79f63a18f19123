//! A body that is resized takes the pressures along that end at its edges: designs against closed forms, and against case files that are
//! written out by hand.

mod common;

use common::file;
use standfast_cases::couple::{STAYS, Variable, moved, vary};
use standfast_cases::design::{
    Design, DesignRequest, Extreme, Found, SingleChanges, Spelling, sensitivities,
};
use standfast_cases::key::{Id, Key};
use standfast_cases::sweep::{Factor, Sweep};
use standfast_cases::{Assessment, Case, CaseFile, Document, Portion};

/// Of a wall of parts, 32 m wide: a triangle of uplift from 300 kPa at the heel to nothing at O, and water's thrust.
const DAM: &str = "[body]\nfriction = 0.7\n[[part]]\nleft = 0\nwidth = 32\nbottom = 0\nheight = 30\ndensity = 2000\n\
    [[pressure]]\nname = \"uplift\"\nface = \"base\"\ndistance = [0, \"32 m\"] # drawing 7\npressure = [0, \"300 kPa\"]\n\
    [[load]]\nforce = \"8000 kN/m\"\nelevation = 10\n";

/// The same as one block.
const BLOCK: &str = "[body]\nwidth = 32\nheight = 30\ndensity = 2000\nfriction = 0.7\n[[pressure]]\nface = \"base\"\n\
    distance = [0, 32]\npressure = [0, 300e3]\n[[load]]\nforce = 8000e3\nelevation = 10\n";

fn sliding(text: &str) -> f64 {
    Assessment::of(&file(text).case().unwrap()).unwrap().governing().outcome.stability.sliding
}

fn varied(text: &str, changes: &[(&str, f64)]) -> (CaseFile, standfast_cases::Inputs) {
    let file = file(text);
    let variables: Vec<_> =
        changes.iter().map(|(name, _)| Variable::find(name, file.inputs()).unwrap()).collect();
    let changes: Vec<_> =
        variables.iter().zip(changes).map(|(variable, (_, value))| (variable, *value)).collect();
    let inputs = vary(file.inputs(), &file.case().unwrap(), &changes);
    (file, inputs)
}

fn distances(text: &str, changes: &[(&str, f64)]) -> Vec<f64> {
    let (_, inputs) = varied(text, changes);
    inputs.list(Id::new(Key::PressureDistance, 0)).unwrap().to_vec()
}

fn designed(text: &str, vary: &str, target: &str, extreme: Extreme) -> f64 {
    let request = DesignRequest {
        vary: vary.to_owned(),
        target: target.parse().unwrap(),
        extreme,
        from: None,
        to: None,
        spelling: &Spelling::PROGRAM,
    };
    let design = Design::of(&file(text), request, Portion::UNSEEN).unwrap();
    let json: serde_json::Value = serde_json::from_str(&design.json(&(), &[])).unwrap();
    json["found"]["boundary"].as_f64().unwrap()
}

/// μ (ρ g h w − p w/2)/F = 1.3: weight and uplift both grow with the width.
#[test]
fn a_wider_base_has_more_uplift() {
    let net = 2000.0 * 9.81 * 30.0 - 150e3;
    let width = 1.3 * 8000e3 / (0.7 * net);
    let found = designed(BLOCK, "width", "SF_sliding=1.3", Extreme::Least);
    assert!((found / width - 1.0).abs() < 1e-10, "{found}, {width}");
    let found = designed(DAM, "body.width_scale", "SF_sliding=1.3", Extreme::Least);
    assert!((found * 32.0 / width - 1.0).abs() < 1e-10, "{found}, {}", width / 32.0);
    // Typed by hand the same answer, and another one with the pressure left behind.
    let scale = width / 32.0;
    let scaled = DAM.replace("friction = 0.7", &format!("friction = 0.7\nwidth_scale = {scale}"));
    let by_hand = sliding(&scaled.replace("\"32 m\"", &width.to_string()));
    assert!((by_hand - 1.3).abs() < 1e-10, "{by_hand}");
    assert!((sliding(&scaled) - 1.3).abs() > 1e-3);
}

#[test]
fn only_what_ends_at_an_edge_stretches() {
    assert_eq!(distances(BLOCK, &[("width", 40.0)]), [0.0, 40.0]);
    assert_eq!(distances(BLOCK, &[("width", 24.0)]), [0.0, 24.0]);
    assert_eq!(distances(DAM, &[("part[1].width", 40.0)]), [0.0, 40.0]);
    // What does not change the width leaves it.
    assert_eq!(distances(BLOCK, &[("height", 20.0), ("friction", 0.5)]), [0.0, 32.0]);
    // A kink between goes in proportion, a step stays one.
    let kinked = BLOCK.replace("[0, 32]", "[0, 24, 24, 32]").replace("[0, 300e3]", "[0, 1e5, 2e5, 3e5]");
    assert_eq!(distances(&kinked, &[("width", 40.0)]), [0.0, 30.0, 30.0, 40.0]);
    // That at O begins where distances do; that within the base is of something else.
    for inner in ["[0, 31]", "[4, 20]"] {
        let inner = BLOCK.replace("[0, 32]", inner);
        assert_eq!(distances(&inner, &[("width", 40.0)]), distances(&inner, &[]));
        assert!(moved_lists(&inner, "width").is_empty());
    }
    // A base that reaches farther to one side.
    let shoe = BLOCK.replace("friction", "base_left = 10\nbase_right = 12\nfriction");
    let shoe = shoe.replace("[0, 32]", "[0, 22]");
    assert_eq!(distances(&shoe, &[("body.base_right", 14.0)]), [0.0, 24.0]);
    assert_eq!(distances(&shoe, &[("body.base_left", 12.0)]), [0.0, 24.0]);
    assert_eq!(distances(&shoe, &[("width", 40.0)]), [0.0, 27.5]);
    // On top the edges are those of the body, and O is that of the base.
    let top = shoe.replace("\"base\"", "\"top\"").replace("[0, 22]", "[-6, 26]");
    assert_eq!(distances(&top, &[("body.base_left", 12.0)]), [-4.0, 28.0]);
    assert_eq!(distances(&top, &[("width", 40.0)]), [-7.5, 32.5]);
    // On a side it stays.
    let side = BLOCK.replace("\"base\"", "\"left\"").replace("distance = [0, 32]", "elevation = [0, 30]");
    let (before, after) = varied(&side, &[("width", 40.0)]);
    let id = Id::new(Key::PressureElevation, 0);
    assert_eq!(before.inputs().list(id), after.list(id));
}

fn moved_lists(text: &str, name: &str) -> Vec<String> {
    let file = file(text);
    let variable = Variable::find(name, file.inputs()).unwrap();
    let all = moved(file.inputs(), &file.case().unwrap(), &[&variable]);
    all.into_iter().map(|id| id.to_string()).filter(|id| id.contains("pressure")).collect()
}

/// Rows of a table do not know of each other.
#[test]
fn a_row_leaves_nothing_to_the_next() {
    let file = file(BLOCK);
    let factors = vec![Factor::find("width", None, file.inputs()).unwrap()];
    let sweep = Sweep::of(&file, factors).unwrap();
    let mut scratch = sweep.scratch();
    let mut of = |width: f64| {
        let answer = sweep.answer(&mut scratch, &[width]).unwrap();
        answer.assessment().governing().outcome.stability.sliding
    };
    let there = [of(40.0), of(24.0), of(32.0)];
    assert_eq!(there[2], sliding(BLOCK));
    assert_eq!([of(24.0), of(40.0)], [there[1], there[0]]);
    assert!(sweep.notes().iter().any(|note| note.contains("pressure[1].distance")), "{:?}", sweep.notes());
    assert!(sweep.notes().iter().any(|note| note == STAYS));
}

/// The change that is offered is written whole, with its unit, and its comment says what stood there.
#[test]
fn the_text_of_a_change_has_the_pressure() {
    let text = DAM.replace("friction = 0.7", "friction = 0.7\nwidth_scale = 1");
    let text = format!("{text}[criteria]\nSF_sliding = 1.3\n");
    let of = SingleChanges::of(&file(&text), None).unwrap();
    let variable = of.variables.iter().find(|variable| variable.name() == "body.width_scale").unwrap();
    let Found::Helps(new) = of.change(variable, Portion::UNSEEN).unwrap().found else { panic!("no help") };
    let written = new.text.unwrap();
    let scale = file(&written).inputs().number(Key::WidthScale).unwrap();
    let expected = format!("distance = [0, \"{} m\"] # was [0, \"32 m\"]: drawing 7\n", 32.0 * scale);
    assert!(written.contains(&expected), "{written}\n{expected}");
    assert_eq!(new.coupled, [(Id::new(Key::PressureDistance, 0), format!("[0, {} m]", 32.0 * scale))]);
    assert!((1.3..1.301).contains(&sliding(&written)), "{}", sliding(&written));
}

/// The factors that are 1 where nothing is said vary as if that stood there, and have their sensitivities.
#[test]
fn a_factor_of_one_need_not_be_written() {
    let said = DAM.replace("friction = 0.7", "friction = 0.7\nwidth_scale = 1");
    let said = said.replace("[[pressure]]", "[[pressure]]\nscale = 1");
    for (name, extreme) in
        [("body.width_scale", Extreme::Least), ("pressure.uplift.scale", Extreme::Greatest)]
    {
        let (one, two) = (
            designed(DAM, name, "SF_sliding=1.3", extreme),
            designed(&said, name, "SF_sliding=1.3", extreme),
        );
        assert_eq!(one, two, "{name}");
    }
    let rows = |text: &str| {
        let rows = sensitivities(&file(text)).unwrap().into_iter();
        let mut rows: Vec<_> = rows.map(|row| (row.variable.id(), row.value, row.sliding)).collect();
        rows.sort_by_key(|(id, ..)| *id);
        rows
    };
    assert_eq!(rows(DAM), rows(&said));
    assert!(rows(DAM).iter().any(|(id, value, _)| *id == Key::WidthScale.into() && *value == 1.0));
    // Without parts there is no such factor.
    assert!(Variable::find("body.width_scale", file(BLOCK).inputs()).is_err());
    // A body that cannot be is refused as such, whatever its pressures.
    let (_, inputs) = varied(DAM, &[("part[1].width", -1.0)]);
    assert!(Case::of(&inputs).is_err());
}
