//! Every number that a case file may have, in everything that answers cases: a change of it changes the answer, or it is refused by its
//! name. What may leave an answer as it is stands in one list, with the reason.

use std::collections::BTreeSet;

use standfast_cases::couple::Variable;
use standfast_cases::design::{Design, DesignRequest, Extreme, Spelling};
use standfast_cases::key::{Kind, Table};
use standfast_cases::motion::{Follow, FollowedMotion, MotionRows, MotionView};
use standfast_cases::random::{ChanceProblem, ChanceRequest, Effort, Happening, Method, Probability};
use standfast_cases::sweep::{Factor, Sweep, heading};
use standfast_cases::{Assessment, AssessmentView, CaseFile, Document, Id, Key, Portion};

const RECORD: &str = "time_s,a_cm_s2\n0,0\n0.1,300\n0.3,-420\n0.5,250\n0.7,0\n";

fn record(_: &str) -> Result<String, String> {
    Ok(RECORD.to_owned())
}

fn file(text: &str) -> CaseFile {
    CaseFile::read("case.toml", text, &record)
        .unwrap_or_else(|error| panic!("{}", standfast_cases::report(&error)))
}

/// Cases that have every number between them.
const CASES: [&str; 33] = [
    "gravity = 9.8\n[body]\nwidth = 4\nheight = 6\nmass = 50e3\nfriction = 0.4\nkinetic_friction = 0.35\nbase_left = 1.9\n\
     base_right = 1.8\ncentroid_offset = 0.1\ncentroid_height = 2.9\nmoment_of_inertia = 2e5\n[uplift]\nleft = 1e3\n\
     right = 2e3\n[[load]]\nforce = 60e3\nelevation = 4\n[[load]]\nname = \"crane\"\nforce = 9e3\ndirection = \"down\"\n\
     elevation = 5\ndistance = 1\npermanent = true\n[[pressure]]\nface = \"right\"\nelevation = [0, 3]\npressure = [8e3, 2e3]\n\
     scale = 1.1\npermanent = true\n",
    "[body]\nfloor_deg = 3\nwidth = 1\nheight = 2\ndensity = 2400\nfriction = 0.4\n[[load]]\nforce = 6e3\nelevation = 1.5\n",
    "[body]\nwidth = 1\nheight = 2\nlength = 0.8\ndensity = 2400\nfriction = 0.4\n[earthquake]\nhorizontal = \"0.3 g\"\nvertical = \"0.1 g\"\n\
     [added_mass]\nmass = 300\nelevation = 0.5\n",
    "[body]\nwidth = 1\nheight = 2\nlength = 0.8\ncentroid_z = 0.02\ndensity = 2400\nfriction = 0.4\n[base]\ncircle = 0.7\n\
     [earthquake]\nhorizontal = \"0.2 g\"\nvertical = \"0.1 g\"\nhorizontal_z = \"0.1 g\"\n[[load]]\nforce = 900\nelevation = 1.5\n\
     direction_deg = 50\nz = 0.1\n",
    "[body]\nwidth = 1\nheight = 2\nlength = 0.8\ndensity = 2400\nfriction = 0.4\n[earthquake]\nhorizontal = \"0.2 g\"\n\
     direction_deg = 20\n",
    "[body]\nwidth = 15\nheight = 10.5\nmass = 346050\nfriction = 0.6\nbuoyant_weight = 2318640\nweight_arm = 7.4\n[wave]\n\
     deep_water_height = 6.3\nperiod = 11.4\nsea_bottom_slope = 0.01\nwater_depth = 10.1\ndepth_above_berm = 5.6\n\
     base_depth = 7.1\ncrest_height = 3.4\nberm_width = 8\nangle_deg = 15\nwater_density = 1030\nlambda = [1, 0.9, 0.95]\n\
     turn_deg = 5\n",
    "[body]\nwidth = 15\nheight = 10.5\nmass = 346050\nfriction = 0.6\n[water]\nlevel = 7.1\ndensity = 1030\n[wave]\ncaisson_width = 15\nH13 = 5.8\n\
     Hmax = 8\nperiod = 11.4\nsea_bottom_slope = 0.01\nwater_depth = 10.1\ndepth_above_berm = 5.6\nbase_depth = 7.1\n\
     crest_height = 3.4\nberm_width = 8\nangle_deg = 15\nwater_density = 1030\n",
    "[body]\nwidth = 4\nheight = 6\nmass = 50e3\nfriction = 0.4\n[water]\nleft = 2\nright = 5\ndensity = 1000\n[ground]\n\
     friction_angle_deg = 36\nunit_weight = 10e3\nsurcharge = 5e3\ncohesion = 2e3\n[[load]]\nforce = 20e3\nelevation = 4\n",
    "[body]\nwidth = 5\nheight = 9\ndensity = 2400\nfriction = 0.7\n[water]\nleft = 1\nright = 8\ndensity = 1000\n\
     drain = { distance = 2.5, efficiency = 0.5 }\n[[load]]\nname = \"ice\"\nforce = 20e3\nelevation = 8\n",
    "[body]\nwidth = 7\nheight = 9\nmass = 130e3\nfriction = 0.6\n[water]\nleft = 5\nright = 6\ndensity = 1010\n\
     [earthquake]\nhorizontal = \"0.1 g\"\nvertical = \"0.05 g\"\n[[backfill]]\nname = \"sand\"\nface = \"right\"\ntop = 8\n\
     friction_angle_deg = 33\nwall_friction_deg = 20\nunit_weight = 18e3\nunit_weight_saturated = 20e3\nunit_weight_dry = 16e3\n\
     cohesion = 2e3\nadhesion = 500\nslope_deg = 5\nbatter_deg = 4\nsurcharge = 9e3\nincrement_at = 0.5\n",
    "[body]\nwidth = 7\nheight = 9\nmass = 130e3\nfriction = 0.6\n[[backfill]]\nface = \"left\"\nstate = \"rest\"\n\
     [[backfill.layer]]\nthickness = 4\nfriction_angle_deg = 33\nunit_weight = 18e3\n[[backfill.layer]]\nthickness = 5\n\
     friction_angle_deg = 30\nunit_weight = 17e3\nocr = 2\n",
    "[body]\nwidth = 16\nheight = 17\nmass = 598e3\nfriction = 0.6\n[water]\nlevel = 11\ndensity = 1030\n[wave]\nformula = \"sainflou\"\n\
     height = 4.5\nphase = \"crest\"\nperiod = 9\nwater_depth = 14\nstill_water = 11\ncrest_height = 6\nwater_density = 1030\n",
    "[body]\nwidth = 8\nheight = 3.5\nmass = 66e3\nfriction = 0.6\n[wave]\nformula = \"pedersen\"\nH13 = 4\nperiod = 8.6\nwater_density = 1025\n\
     armour_slope = 2\narmour_crest = 4\narmour_width = 5\nprotected_height = 2\nfree_height = 1.5\nvolume_share = 0.9\n",
    "[body]\nwidth = 8\nheight = 3.5\nmass = 66e3\nfriction = 0.6\n[wave]\nformula = \"van-gent\"\nH13 = 4\nperiod = 10\nwater_density = 1025\n\
     angle_deg = 10\narmour_slope = 2\narmour_crest = 4\nwall_height = 3.4\nwall_base = 7\nbase_freeboard = 1.5\nroughness = 0.45\n",
    "[body]\nwidth = 6\nheight = 10\nmass = 122e3\nfriction = 0.5\nadhesion = 20e3\n[[load]]\nforce = 590e3\nelevation = 7\ntogether = true\n\
     [[moment]]\nmoment = 90e3\ntogether = true\n[[resistance]]\nlimit = 180e3\ndirection = \"right\"\nelevation = 9\nshare = 0.9\n",
    "[body]\nwidth = 6\nheight = 10\nmass = 122e3\nfriction = 0.5\n[[load]]\nforce = 590e3\nelevation = 7\n[[resistance]]\nlimit = 300e3\n\
     direction = \"down\"\ndistance = 5.5\n[[backfill]]\nname = \"toe\"\nface = \"left\"\ntop = 2\nstate = \"passive\"\nshare = 0.5\n\
     friction_angle_deg = 33\nunit_weight = 19e3\n",
    "[body]\nwidth = 4\nheight = 6\nmass = 50e3\nfriction = 0.4\n[ground]\nundrained_strength = 60e3\nsurcharge = 9e3\n[[load]]\n\
     force = 60e3\nelevation = 4\n",
    "[body]\nwidth = 15\nheight = 10.5\nmass = 346050\nfriction = 0.6\nbuoyant_weight = 2318640\n[wave]\ndeep_water_height = 6.3\nsteepness = 0.03\n\
     sea_bottom_slope = 0.01\nwater_depth = 10.1\ndepth_above_berm = 5.6\nbase_depth = 7.1\ncrest_height = 3.4\nberm_width = 8\n\
     angle_deg = 15\nwater_density = 1030\n",
    "[body]\nwidth = 4\nheight = 6\nmass = 50e3\nfriction = 0.4\n[ground]\nlaw = \"envelope\"\ncentric_resistance = 2e6\nt_h = 0.5\nt_m = 0.4\n\
     C = 0.2\n[[load]]\nforce = 60e3\nelevation = 4\n",
    "[body]\nwidth = 4\nheight = 6\nmass = 50e3\nfriction = 0.7\n[ground]\nstrength = 1e6\nstiffness = 5e7\n\
     tangential_stiffness = 2e7\n[[load]]\nforce = 60e3\nelevation = 4\n\
     history = { shape = \"church-roof\", start = 0.1, rise = 0.05, impact_duration = 0.2, tail = 0.4, duration = 0.5, peak = 1.1 }\n",
    "[body]\nfriction = 0.5\n[[part]]\nleft = 0\nwidth = 4\nbottom = 0\nheight = 3\ndensity = 2400\ndensity_below_water = 2500\n\
     [water]\nlevel = 2\ndensity = 1000\n[[load]]\nforce = 60e3\nelevation = 2\n",
    "[body]\nwidth_scale = 1.1\nfriction = 0.5\n[[part]]\nleft = 0\nwidth = 4\nbottom = 0\nheight = 1\nunit_weight = 24e3\n[[part]]\nleft = 1\n\
     width = 2\nbottom = 1\nheight = 3\ntop_left = 1.2\ntop_width = 1.5\ndensity = 2300\n[[load]]\nforce = 60e3\nelevation = 3\n",
    "[body]\nfriction = 0.5\n[[part]]\nleft = 0\nwidth = 4\nbottom = 0\nheight = 3\ndensity = 2400\n[[part]]\nleft = 1\nwidth = 2.4\n\
     bottom = 3\nheight = 3\ndensity = 2300\n[[joint]]\nelevation = 3\nfriction = 0.6\nkinetic_friction = 0.55\nuplift_left = 4e3\n\
     uplift_right = 6e3\nleft = 1.1\nright = 3.2\n[[load]]\nforce = 110e3\nelevation = 3.3\ntogether = true\n[[moment]]\nmoment = 9e3\n\
     elevation = 4\ntogether = true\n",
    "[body]\nwidth = 2\nheight = 3\nmass = 30e3\nfriction = 0.3\n[[load]]\nforce = 110e3\nelevation = 1.6\n\
     history = { shape = \"sine\", start = 0.1, peak = 1.1, angular_frequency = 3, phase = 0.2, duration = 0.9 }\n\
     [motion]\nt_max = 1.05\nimpact = { law = \"ratio\", ratio = 0.6 }\n\
     initial = { theta = 0.01, omega = 0.02, vx = 0.03, vy = 0.04, gap = 0.02 }\n",
    "[body]\nwidth = 0.6\nheight = 2.4\nmass = 2000\nfriction = 0.3\n[motion.base]\n\
     horizontal = { shape = \"file\", file = \"r.csv\", factor = 1.4, start = 0.1 }\n\
     vertical = { shape = \"half-sine\", peak = \"2 m/s2\", duration = 0.6 }\n",
    "[body]\nwidth = 0.6\nheight = 2.4\nmass = 2000\nfriction = 0.3\n[motion.base]\n\
     horizontal = { shape = \"file\", file = \"r.csv\", target_peak = \"0.6 g\" }\n\
     vertical = { shape = \"sine\", peak = \"2 m/s2\", duration = 0.6, period = 0.7 }\n",
    "[body]\nwidth = 0.6\nheight = 2.4\nmass = 2000\nfriction = 0.3\n[motion.base]\n\
     horizontal = { shape = \"half-sine\", peak = \"5 m/s2\", duration = 0.3 }\n\
     [motion]\nimpact = { law = \"ratio\", ratio = { points = 3 } }\n",
    "[body]\nwidth = 0.6\nheight = 2.4\nmass = 2000\nfriction = 0.3\n[motion.base]\n\
     horizontal = { shape = \"half-sine\", peak = \"5 m/s2\", duration = 0.3 }\n\
     [motion]\nimpact = { law = \"ratio\", ratio = { contact = 0.7 } }\n",
    "[body]\nwidth = 0.6\nheight = 2.4\nmass = 2000\nfriction = 0.3\n[motion.base]\n\
     horizontal = { shape = \"half-sine\", peak = \"5 m/s2\", duration = 0.3 }\n\
     [motion]\nimpact = { law = \"poisson\", e = 0.3 }\n",
    "[body]\nwidth = 0.6\nheight = 2.4\nmass = 2000\nfriction = 0.3\n[motion.base]\n\
     horizontal = { shape = \"half-sine\", peak = \"-5 m/s2\", duration = 0.3 }\n[motion]\nt_max = 0.6\n\
     initial = { time = 0.12, x = 0.05, theta = -0.02, omega = 0.5, vx = -0.3, touching = \"O'\", slip = \"right\", slide = [0.02, 0.3] }\n",
    "[body]\nwidth = 0.6\nheight = 2.4\nmass = 2000\nfriction = 0.3\n[motion.base]\n\
     horizontal = { shape = \"half-sine\", peak = \"5 m/s2\", duration = 0.3 }\n\
     [motion.copies]\nnumber = 3\nspread = 0.02\nseed = 3\n",
    "[block]\nb1 = 1\nb2 = 1.1\nd = 3\nrho2 = 3.4\nm_x = 1.1\nm_y = 1.05\nmu_s = 0.12\nmu_k = 0.11\nmu_impact = 0.03\ngravity = 1\n\
     [[block.load]]\nat = [0.2, 1]\ndirection = [-0.15, 0.1]\nhistory = { shape = \"triangle\", rise = 1, duration = 3, peak = 1.2 }\n\
     [motion.initial]\ntheta = 0.1\n",
    "[block]\nb1 = 1\nb2 = 1\nd = 0.3\nmu_s = 0.4\nmu_k = 0.35\ngravity = 1\n[[block.load]]\ndirection = [-0.7, 0]\n\
     history = { shape = \"triangle\", rise = 1, duration = 3 }\n",
];

/// The name of a number as a column has it, with its unit where plain numbers need one.
fn column_of(file: &CaseFile, id: Id) -> String {
    let kind = id.key.info().kind;
    let needs = matches!(kind, Kind::InGravity | Kind::Reached) && file.inputs().dimension(id).is_some();
    if needs { format!("{id} [m/s2]") } else { id.to_string() }
}

/// A number one per cent larger; of zero a little more.
fn more(file: &CaseFile, id: Id) -> f64 {
    match file.inputs().number(id).unwrap() {
        0.0 => 0.01,
        present => 1.01 * present,
    }
}

fn variables(file: &CaseFile) -> Vec<Id> {
    Variable::all(file.inputs()).collect()
}

/// An answer with a number one per cent larger, or the words of what refuses it.
fn assessed(file: &CaseFile, id: Id, value: Option<f64>) -> Result<String, String> {
    let inputs = match value {
        Some(value) => {
            let variable = Variable::of(id, file.inputs());
            let case = file.case().map_err(|error| error.to_string())?;
            standfast_cases::couple::vary(file.inputs(), &case, &[(&variable, value)])
        }
        None => file.inputs().clone(),
    };
    let file = file.varied(inputs);
    Assessment::of_file(&file)
        .map(|answer| answer.json(&AssessmentView::default(), &[]))
        .map_err(|error| error.to_string())
}

/// Numbers that an answer at rest does not depend on: those of the motion but for the peaks of the base, and where on its line a
/// vertical or horizontal force acts.
fn leaves_rest(file: &CaseFile, id: Id) -> bool {
    let vertical = matches!(file.inputs().choice(Id::new(Key::Towards, id.index)), Some("up" | "down"));
    let along = if vertical { Key::Elevation } else { Key::LoadDistance };
    // The last layer reaches the base, however thick it is.
    let last = file.inputs().indices(Table::BackfillLayer).last() == Some(&id.index);
    // A couple is the same wherever it acts on its body.
    id.key == along
        || id.key == Key::MomentElevation
        || id.key == Key::LayerThickness && last
        || file.is_in_time() && is_of_time_alone(id)
}

/// Numbers of the motion that its first instant does not depend on.
fn is_of_time_alone(id: Id) -> bool {
    let peaks = [Key::HistoryPeak, Key::RecordFactor, Key::TargetPeak];
    let of_base = matches!(id.table.name(), "horizontal" | "vertical");
    (id.table.is_of_motion() || id.table.is_history()) && !(of_base && peaks.contains(&id.key))
}

/// What a number one per cent larger in a combination changes is what the file with that number answers; what refuses the one refuses the
/// other.
#[test]
fn every_number_may_be_another_in_a_combination() {
    let situation = |file: &CaseFile| {
        let case = file.case().map_err(|error| error.to_string())?;
        let answer = Assessment::of(&case).map_err(|error| error.to_string())?;
        let json = answer.json(&AssessmentView::default(), &[]);
        let mut json: serde_json::Value = serde_json::from_str(&json).map_err(|error| error.to_string())?;
        let situation = json["situations"][0].as_object_mut().expect("a situation");
        situation.remove("combination");
        Ok::<_, String>(serde_json::to_string(situation).expect("JSON"))
    };
    let mut compared = 0;
    for text in CASES.iter().filter(|text| !text.starts_with("[block]")) {
        let plain = file(&format!("{text}[[combination]]\nfactors = {{}}\n"));
        if plain.is_in_time() {
            continue;
        }
        for id in variables(&plain).into_iter().filter(|id| plain.inputs().number(*id) != Some(0.0)) {
            let scaled = format!("{text}[[combination]]\nscale = {{ \"{id}\" = 1.01 }}\nfactors = {{}}\n");
            let case = plain.case().unwrap();
            let variable = Variable::of(id, plain.inputs());
            // As it is written in decimals.
            let value = format!("{:.14e}", more(&plain, id)).parse().unwrap();
            let varied = standfast_cases::couple::vary(plain.inputs(), &case, &[(&variable, value)]);
            match (situation(&file(&scaled)), situation(&plain.varied(varied))) {
                (Ok(one), Ok(two)) => assert_eq!(one, two, "{id} in\n{text}"),
                (Err(one), Err(two)) => assert!(one.contains(&two), "{id} in\n{text}: {one}; {two}"),
                (one, two) => panic!("{id} in\n{text}: {one:?}; {two:?}"),
            }
            compared += 1;
        }
    }
    assert!(compared > 80, "{compared}");
}

#[test]
fn every_number_changes_what_assess_says() {
    let (mut met, mut wrong) = (BTreeSet::new(), Vec::new());
    for text in CASES.iter().filter(|text| !text.starts_with("[block]")) {
        let file = file(text);
        let plain = assessed(&file, Key::Width.into(), None).unwrap();
        for id in variables(&file) {
            met.insert((id.table, id.key));
            let changed = assessed(&file, id, Some(more(&file, id)));
            // A number that has to be whole, and is not, is refused.
            let same = match &changed {
                Ok(changed) => *changed == plain,
                Err(_) => [Key::ImpactPoints, Key::CopiesNumber, Key::CopiesSeed].contains(&id.key),
            };
            if same != leaves_rest(&file, id) {
                wrong.push(format!("{id} in\n{text}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    // The cases have every number between them that a body's case may have.
    let of_bodies = |key: &&Key| {
        let info = key.info();
        let apart = ["datum", "output", "storm", "point", "block", "history", "criteria"]
            .contains(&info.table.name());
        info.range().is_some() && !apart && !info.table.header().contains("block")
    };
    let missing: Vec<String> = Key::ALL
        .iter()
        .filter(of_bodies)
        .filter(|key| !met.iter().any(|(_, known)| known == *key))
        .map(ToString::to_string)
        .collect();
    assert_eq!(missing, Vec::<String>::new());
}

#[test]
fn every_number_is_a_column_of_a_table() {
    let mut wrong = Vec::new();
    for text in CASES {
        let file = file(text);
        for id in variables(&file) {
            let value = more(&file, id).to_string();
            let name = column_of(&file, id);
            if file.is_in_time() {
                let answers = [Some(&name), None].map(|column| {
                    let columns: Vec<String> = column.into_iter().cloned().collect();
                    let rows = MotionRows::of(&file, &columns).unwrap();
                    rows.answer(&[&value], &record)
                });
                if answers[0].is_ok() && answers[0] == answers[1] && !leaves_the_motion(&file, id) {
                    wrong.push(format!("{id} in\n{text}"));
                }
                continue;
            }
            let (bare, unit) = heading(&name);
            let factor = Factor::find(bare, unit, file.inputs()).unwrap();
            let counted = if factor.counts_gravity() { file.inputs().gravity() } else { 1.0 };
            let sweep = Sweep::of(&file, vec![factor]).unwrap();
            let mut scratch = sweep.scratch();
            let present = file.inputs().number(id).unwrap() / counted;
            let answers = [present, more(&file, id) / counted].map(|value| {
                let answer = sweep.answer(&mut scratch, &[value]).map_err(|fault| fault.to_string());
                answer.map(|answer| answer.assessment().json(&AssessmentView::default(), &[]))
            });
            if (answers[0] == answers[1]) != leaves_rest(&file, id) {
                wrong.push(format!("{id} in\n{text}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Numbers that leave a motion as it is: the mass of a body that nothing moves but its base, friction to stick of one that slips
/// from the beginning, where on the base it begins, beside what it has slid so far, and the height of a block that slides alone.
fn leaves_the_motion(file: &CaseFile, id: Id) -> bool {
    let slips = file.inputs().number(Key::InitialTheta).is_some() && id.key == Key::MuS;
    let low = file.inputs().number(Key::D).is_some_and(|d| d < 0.5) && id.key == Key::D;
    let weighs = id.key == Key::Mass && file.inputs().count(standfast_cases::key::Table::Load) == 0;
    slips || low || weighs || id.key == Key::InitialX
}

#[test]
fn every_number_changes_what_simulate_says() {
    let mut wrong = Vec::new();
    for text in CASES {
        let file = file(text);
        if !file.is_in_time() {
            continue;
        }
        let follow = |file: &CaseFile| {
            let answers =
                FollowedMotion::of_file(file, &Follow::default()).map_err(|error| error.to_string())?;
            Ok::<_, String>(answers.json(&MotionView::default(), &[]))
        };
        let plain = follow(&file).unwrap();
        for id in variables(&file) {
            let mut inputs = file.inputs().clone();
            inputs.set(id, more(&file, id));
            let changed = follow(&file.varied(inputs));
            if changed.as_ref().is_ok_and(|changed| *changed == plain) && !leaves_the_motion(&file, id) {
                wrong.push(format!("{id} in\n{text}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_number_can_be_designed_or_is_refused_by_name() {
    let mut wrong = Vec::new();
    for text in CASES.iter().filter(|text| !text.starts_with("[block]")) {
        let file = file(text);
        for id in variables(&file) {
            let present = file.inputs().number(id).unwrap();
            let [from, to] = if present == 0.0 { [0.0, 0.1] } else { [0.9 * present, 1.1 * present] };
            let unit = if column_of(&file, id).ends_with("m/s2]") { " m/s2" } else { "" };
            let with_unit = |value: f64| format!("{value}{unit}");
            let request = DesignRequest {
                vary: id.to_string(),
                target: "factor=0.001".parse().unwrap(),
                extreme: Extreme::Least,
                from: Some(with_unit(from.min(to))),
                to: Some(with_unit(from.max(to))),
                spelling: &Spelling::PROGRAM,
            };
            if let Err(error) = Design::of(&file, request, Portion::UNSEEN) {
                let words = error.to_string();
                if !words.contains(&id.to_string()) {
                    wrong.push(format!("{id}: {words}"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Every number is drawn, and the last of each case that can be is answered for as well.
#[test]
fn every_number_can_be_random_or_is_refused_by_name() {
    let mut wrong = Vec::new();
    // Nothing is random beside joints.
    for text in CASES.iter().filter(|text| !text.starts_with("[block]") && !text.contains("[[joint]]")) {
        let mut last = None;
        for id in variables(&file(text)) {
            let law = format!("[random]\n\"{id}\" = {{ normal = {{ cov = 0.01 }} }}\n");
            let parsed = CaseFile::read("case.toml", &format!("{text}{law}"), &record);
            let found = parsed.map_err(|error| error.to_string()).and_then(|file| {
                let problems = ChanceProblem::of_file(&file).map_err(|error| error.to_string())?;
                Ok((file, problems))
            });
            match found {
                Ok((file, problems)) => {
                    let drawn = problems[0].drawn(&[file.inputs().number(id).unwrap()]);
                    assert_ne!(drawn.happens, Happening::NotABody, "{id} in\n{text}");
                    if !id.table.is_of_motion() {
                        last = Some(file);
                        continue;
                    }
                    // Of the motion, which is not followed here.
                    let refused = Probability::of(&file, ChanceRequest::default()).unwrap_err().to_string();
                    assert!(refused.contains(&format!("`{id}`")), "{refused}");
                }
                Err(words) if words.contains(&format!("`{id}`")) => {}
                Err(words) => wrong.push(format!("{id}: {words}\n{text}")),
            }
        }
        let effort = Effort { points: 64, ..Effort::default() };
        let asked = ChanceRequest { method: Some(Method::MonteCarlo), effort, ..ChanceRequest::default() };
        let answer = Probability::of(&last.expect("a number that can be random"), asked).unwrap();
        assert_eq!(answer.random.len(), 1);
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
