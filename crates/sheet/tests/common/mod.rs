//! Cases, the sheet as a tree, and an evaluator of its formulas that shares nothing with the library.
#![allow(dead_code)]

use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::path::Path;
use std::sync::Mutex;

use scraper::node::Node;
use scraper::{ElementRef, Html, Selector};
use standfast_sheet::{Sheet, SheetOptions};

/// Every example, the cases of validation/goda.toml, and a few that reach what these do not: name and text.
pub fn cases() -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut paths: Vec<_> = ["examples", "examples/joints", "examples/directions"]
        .iter()
        .flat_map(|folder| std::fs::read_dir(root.join(folder)).unwrap().map(|entry| entry.unwrap().path()))
        .collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "toml"));
    // Its records lie beside it.
    paths.retain(|path| path.file_name().is_some_and(|name| name != "rack.toml"));
    paths.sort();
    let mut cases: Vec<_> = paths
        .iter()
        .map(|path| {
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            (name, std::fs::read_to_string(path).unwrap())
        })
        .collect();
    assert!(cases.len() > 5);
    let validation = std::fs::read_to_string(root.join("validation/goda.toml")).unwrap();
    let validation: toml::Table = validation.parse().unwrap();
    let published: Vec<_> =
        validation["case"].as_array().unwrap().iter().filter_map(toml::Value::as_table).collect();
    let name = |case: &toml::Table| case["name"].as_str().unwrap().to_owned();
    for case in &published {
        // The keys of its base, and its own.
        let mut whole = toml::Table::new();
        if let Some(base) = case.get("base") {
            whole.extend(published.iter().find(|other| other["name"] == *base).unwrap().iter().map(own));
        }
        whole.extend(case.iter().map(own));
        cases.push((name(case), goda(&whole)));
    }
    cases.extend(more());
    cases
}

fn own((key, value): (&String, &toml::Value)) -> (String, toml::Value) {
    (key.clone(), value.clone())
}

/// A case file of a published case.
fn goda(case: &toml::Table) -> String {
    let number =
        |key: &str| case.get(key).and_then(|value| value.as_float().or(value.as_integer().map(|i| i as f64)));
    let need = |key: &str| number(key).unwrap();
    let mut text = format!(
        "[body]\nwidth = {0}\nheight = {1}\nmass = {2}\nfriction = {3}\n",
        need("caisson_width"),
        need("base_depth") + need("crest_height"),
        2200.0 * need("caisson_width") * (need("base_depth") + need("crest_height")),
        need("friction"),
    );
    let mut wave = "[wave]\n".to_owned();
    if let Some(weight) = number("buoyant_weight") {
        text += &format!("buoyant_weight = {}\n", weight * 1e3);
    }
    if let (Some(ratio), Some(_)) = (number("weight_arm_ratio"), number("buoyant_weight")) {
        text += &format!("weight_arm = {}\n", ratio * need("caisson_width"));
    }
    if let Some(impulsive) = case.get("impulsive") {
        wave += &format!("impulsive = {impulsive}\n");
    }
    if number("buoyant_weight").is_none() {
        text += &format!("[water]\nlevel = {}\n", need("base_depth"));
    }
    text += &wave;
    for key in [
        "deep_water_height",
        "H13",
        "Hmax",
        "period",
        "sea_bottom_slope",
        "water_depth",
        "depth_above_berm",
        "base_depth",
        "crest_height",
        "berm_width",
        "angle_deg",
        "water_density",
    ] {
        if let Some(value) = number(key) {
            text += &format!("{key} = {value:?}\n");
        }
    }
    text
}

/// Cases that no example shows.
fn more() -> Vec<(String, String)> {
    let body = "[body]\nwidth = 6\nheight = 7\nmass = 100e3\nfriction = 0.6\n";
    let wave = "[wave]\ndeep_water_height = 6.3\nperiod = 11.4\nsea_bottom_slope = 0.01\nwater_depth = 10.1\nbase_depth = 7.1\n\
                crest_height = 3.4\nangle_deg = 25\nwater_density = 1030\n";
    let caisson = "[body]\nwidth = 15\nheight = 10.5\nmass = 346050\nfriction = 0.6\n[water]\nlevel = 7.1\n";
    let dam = "[body]\nwidth = 5\nheight = 9\ndensity = 2400\nfriction = 0.7\n[water]\nleft = 1\nright = 8\ndensity = 1000\n";
    let ice = "[[load]]\nname = \"ice\"\nforce = 20e3\nelevation = 8\ntogether = true\n";
    let list = [
        ("earthquake in water", format!("{body}[water]\nlevel = 5\ndensity = 1000\n[earthquake]\nhorizontal = \"-0.3 g\"\nvertical = \"0.1 g\"\n[added_mass]\nsides = 2\n")),
        ("one side", format!("{body}[water]\nleft = 2\nright = 5\ndensity = 1000\n[earthquake]\nhorizontal = \"0.2 g\"\n[added_mass]\nsides = \"right\"\n")),
        ("sloping floor", format!("{}[[load]]\nname = \"push\"\nforce = 90e3\nelevation = 5\ntogether = true\n[[load]]\nname = \"hook\"\nforce = 40e3\ndirection = \"up\"\n\
            elevation = 6\ndistance = 1\ntogether = true\n[earthquake]\nhorizontal = \"0.05 g\"\nvertical = \"0.03 g\"\n[[moment]]\nmoment = 50e3\ntogether = true\n",
            body.replace("friction", "floor_deg = 6\nfriction"))),
        ("floor that falls", format!("{}[[combination]]\nname = \"light\"\nfactors = {{ weight = 0.9, \"weight.stone\" = 1.1 }}\n",
            "[body]\nfriction = 0.5\nfloor_deg = -4\n[[part]]\ngroup = \"stone\"\nleft = 0\nwidth = 4\nbottom = 0\nheight = 2\ndensity = 2400\n[[part]]\nleft = 1\n\
            width = 2\nbottom = 2\nheight = 3\ndensity = 2000\n[[load]]\nname = \"push\"\nforce = 9e3\nelevation = 4\npermanent = true\n")),
        ("in feet", format!("[output]\nforce = \"kip/ft\"\npressure = \"psf\"\nlength = \"ft\"\ndigits = 6\n{caisson}{wave}depth_above_berm = 5.6\nberm_width = 8\n\
            [ground]\nstrength = 600e3\n[criteria]\nSF_sliding = 1.2\nbearing_max = 400e3\neccentricity = 2\n")),
        ("in tonnes", format!("[output]\nforce = \"tf/m\"\npressure = \"kgf/cm2\"\nlength = \"cm\"\n{dam}{ice}[[backfill]]\nname = \"sand\"\nface = \"right\"\n\
            top = 4\nfriction_angle_deg = 33\nunit_weight = 18e3\nunit_weight_saturated = 20e3\n")),
        ("added mass given", format!("{body}[earthquake]\nhorizontal = \"0.2 g\"\n[added_mass]\nmass = 20e3\n")),
        ("pressures, scaled", format!("{body}[[pressure]]\nname = \"left\"\nface = \"left\"\nelevation = [0, 2, 2, 7]\npressure = [3e3, 1e3, 9e3, -2e3]\nscale = 1.3\n\
            [[pressure]]\nface = \"top\"\ndistance = [1, 6]\npressure = [4e3, 2e3]\npermanent = true\n\
            [[pressure]]\nface = \"base\"\ndistance = [0, 1, 2, 3, 4, 5, 6]\npressure = [1, 2, 3, 5, 8, 13, 21]\n")),
        ("forces at points", format!("{body}base_left = 2.5\n[[load]]\nname = \"crane `A`\"\nforce = 90e3\ndirection = \"down\"\ndistance = 1\npermanent = true\n\
            [[load]]\nname = \"lift\"\nforce = 20e3\ndirection = \"up\"\ndistance = 4\ntogether = true\n\
            [[load]]\nname = \"push\"\nforce = 70e3\nelevation = 3\ntogether = true\n\
            [[combination]]\nname = \"one `of` two\"\nfactors = {{ lift = 1.5, push = 1.35, weight = 0.9 }}\n[[combination]]\nfactors = {{ push = 1.1 }}\n\
            [criteria]\nSF_sliding = 1.3\nSF_overturning_net = 1.4\nbearing_max = \"200 kPa\"\ncontact_share = 0.5\neccentricity = \"1 m\"\nload_factor = 1.2\n\
            modes_not = [\"RO\", \"SL\"]\n")),
        ("all in a combination", format!("{caisson}{wave}depth_above_berm = 5.6\nberm_width = 8\nuplift = false\n[uplift]\nleft = 1e3\nright = 2e3\n[earthquake]\nhorizontal = \"0.05 g\"\n\
            vertical = \"0.02 g\"\n[added_mass]\nsides = 2\n[[combination]]\nfactors = {{ weight = 0.95, water = 1.05, uplift = 1.2, wave = 0.5, earthquake = 0.7 }}\n\
            [criteria]\nload_factor = 1.2\n")),
        ("other numbers in combinations", format!("{caisson}{wave}depth_above_berm = 5.6\nberm_width = 8\n[ground]\nfriction_angle_deg = 38\nunit_weight = 10e3\n\
            [[load]]\nname = \"crane\"\nforce = 90e3\ndirection = \"down\"\ndistance = 4\n\
            [[combination]]\nname = \"high water\"\nset = {{ water_level = 8, \"wave.angle_deg\" = 10 }}\nfactors = {{ wave = 1, crane = [1, 0] }}\n\
            [[combination]]\nname = \"as it is\"\nfactors = {{ wave = 1 }}\n[criteria]\nSF_sliding = 1.2\n")),
        ("partial factors of waves", format!("{caisson}{wave}depth_above_berm = 5.6\nberm_width = 8\n\
            [[combination]]\nname = \"partial factors\"\nscale = {{ \"wave.deep_water_height\" = 1.1 }}\nmaterials = {{ \"body.friction\" = 1.2 }}\n\
            factors = {{ weight = [1.1, 0.9], \"wave.thrust\" = 0.9, \"wave.uplift\" = [0.77, 1] }}\ncriteria = {{ SF_sliding = 1, bearing_max = 5e5, effective_pressure_max = 5e5 }}\n")),
        ("partial factors of ground", format!("{body}[ground]\nfriction_angle_deg = 38\nunit_weight = 10e3\ncohesion = 2e3\n\
            [[load]]\nname = \"push\"\nforce = 100e3\nelevation = 5\n[[combination]]\nname = \"DA1-2\"\n\
            materials = {{ \"ground.friction_angle_deg\" = 1.1, \"ground.cohesion\" = 1.25 }}\nresist = {{ sliding = 1.1, bearing = 1.2 }}\n\
            factors = {{ push = 1.1 }}\ncriteria = {{ SF_sliding = 1, ground_factor = 1 }}\n\
            [[combination]]\nname = \"as it is\"\nfactors = {{ push = 1 }}\n[criteria]\nground_factor = 1.4\nload_factor = 1.1\n")),
        ("a base that opens and tips", format!("{dam}{ice}")),
        ("a base that opens and slides", format!("{dam}{ice}[[load]]\nname = \"crane\"\nforce = 20e3\ndirection = \"down\"\ndistance = 1.5\ntogether = true\n\
            [criteria]\nSF_uplift = 1.1\ntipping = 1\nload_factor = 1.1\n").replace("friction = 0.7", "friction = 0.48")),
        ("drained, from the left", format!("{dam}{ice}direction = \"right\"\n").replace("left = 1\nright = 8", "left = 8\nright = 1\ndrain = { distance = 2.5, efficiency = 0.5 }")),
        ("drained and pushed", format!("{dam}{ice}").replace("right = 8", "right = 8\ndrain = { distance = 2.5, efficiency = 0.5 }").replace("friction = 0.7", "friction = 0.5")),
        ("a drain that is lost", format!("{dam}{ice}").replace("right = 8", "right = 8\ndrain = { distance = 4.4, efficiency = 0.5 }")),
        ("opened from end to end", format!("{dam}{ice}").replace("20e3", "150e3")),
        ("an object that opens", format!("{dam}{ice}").replace("density = 2400", "density = 2400\nlength = 3")),
        ("an earthquake on a base that opened", format!("{dam}[earthquake]\nhorizontal = \"0.02 g\"\n")),
        ("soil, shaken", format!("{body}[water]\nleft = 3\nright = 4\ndensity = 1010\n[[backfill]]\nname = \"sand `A`\"\nface = \"right\"\n\
            top = 6.5\nfriction_angle_deg = 33\nwall_friction_deg = 20\nunit_weight = 18e3\nunit_weight_saturated = 20e3\ncohesion = 3e3\n\
            adhesion = 1e3\nslope_deg = 5\nbatter_deg = 4\nsurcharge = 9e3\n[earthquake]\nhorizontal = \"0.1 g\"\nvertical = \"0.05 g\"\n")),
        ("soils in layers", format!("{body}[[backfill]]\nname = \"sand\"\nface = \"left\"\nsurcharge = 9e3\nbatter_deg = 3\n[[backfill.layer]]\nthickness = 3\nfriction_angle_deg = 33\n\
            wall_friction_deg = 11\nunit_weight = 18e3\n[[backfill.layer]]\nthickness = 4\nfriction_angle_deg = 30\nunit_weight = 17e3\ncohesion = 9e3\n\
            [[backfill]]\nname = \"rock\"\nface = \"right\"\nstate = \"rest\"\ntop = 5\nfriction_angle_deg = 40\nunit_weight = 19e3\nocr = 2\nslope_deg = 3\n\
            [[combination]]\nname = \"one\"\nfactors = {{ sand = [1.35, 1], \"sand.surcharge\" = 1.5, rock = 1 }}\n\
            materials = {{ \"backfill.sand.friction_angle_deg\" = 1.25, \"backfill.rock.friction_angle_deg\" = 1.25 }}\ncriteria = {{ SF_sliding = 1, tipping = 1 }}\n\
            [[combination]]\nname = \"two\"\nfactors = {{ \"sand.surcharge\" = 1 }}\n[earthquake]\nhorizontal = \"0.1 g\"\n\
            [[combination]]\nname = \"three\"\nfactors = {{ earthquake = 1, \"sand.surcharge\" = 0 }}\n")),
        ("an object beside soil", format!("{body}[[backfill]]\nface = \"right\"\nfriction_angle_deg = 33\nwall_friction_deg = 20\nunit_weight = 18e3\nsurcharge = 5e3\n\
            [earthquake]\nhorizontal = \"0.1 g\"\n").replace("friction = 0.6", "friction = 0.6\nlength = 3")),
        ("groups of parts", "[body]\nfriction = 0.6\n[[part]]\ngroup = \"concrete\"\nleft = 0\nwidth = 15\nbottom = 0\nheight = 2\ndensity = 2400\n\
            [[part]]\ngroup = \"fill\"\nleft = 1\nwidth = 12\nbottom = 2\nheight = 8\ndensity = 1900\n[water]\nleft = 1\nright = 2\ndensity = 1000\n\
            [[load]]\nname = \"push\"\nforce = 900e3\nelevation = 8\n[[combination]]\nfactors = { \"weight.fill\" = 0.9, \"weight.concrete\" = [1.1, 0.95], push = 1.2 }\n\
            criteria = { SF_uplift = 1, tipping = 1 }\n".to_owned()),
        ("crushing with less", format!("{body}[ground]\nstrength = 500e3\n[[load]]\nname = \"push\"\nforce = 100e3\nelevation = 5\n[[combination]]\n\
            factors = {{ push = 1.2 }}\nresist = {{ bearing = 1.4 }}\n[[combination]]\nset = {{ \"body.width\" = 6.5 }}\nfactors = {{ push = 1 }}\n\
            [[combination]]\nfactors = {{ push = 1 }}\n[criteria]\nground_factor = 1.3\n")),
        ("crushing, rests", format!("{body}[ground]\nstrength = 500e3\n[[load]]\nforce = 100e3\nelevation = 5\n[criteria]\nground_factor = 1.3\n\
            effective_pressure_max = \"400 kPa\"\n")),
        ("crushing, rocks to the right", format!("{body}base_left = 2.5\n[ground]\nstrength = 900e3\n[[load]]\nforce = 500e3\nelevation = 6\ndirection = \"right\"\n")),
        ("crushing, slides", format!("{body}[ground]\nstrength = 900e3\n[[load]]\nforce = 700e3\nelevation = 1\n")),
        ("crushing, slide-rocks", format!("{body}[ground]\nstrength = 900e3\n[[load]]\nforce = 900e3\nelevation = 4\n")),
        ("crushed by its weight", format!("{body}[ground]\nstrength = 100e3\n[[load]]\nforce = 100e3\nelevation = 4\n")),
        ("crushing object", format!("{body}length = 2\n[ground]\nstrength = 300e3\nstiffness = 2e7\ntangential_stiffness = 1e7\n[[load]]\nforce = 250e3\nelevation = 5\n\
            history = {{ shape = \"rect\", duration = 0.2 }}\n")),
        ("sand with all", format!("{body}[ground]\nfriction_angle_deg = 32\nunit_weight = 9e3\nsurcharge = 12e3\ncohesion = 4e3\nlaw = \"hansen\"\n\
            [[load]]\nforce = 150e3\nelevation = 5\n")),
        ("clayey sand under an object", format!("{body}length = 3\n[ground]\nfriction_angle_deg = 28\nunit_weight = 9e3\ncohesion = 8e3\n\
            [[load]]\nforce = 450e3\nelevation = 2\n")),
        ("sand with all under an object", format!("{body}length = 6\n[ground]\nfriction_angle_deg = 32\nunit_weight = 9e3\nsurcharge = 12e3\ncohesion = 4e3\nlaw = \"hansen\"\n\
            [[load]]\nforce = 900e3\nelevation = 3\n")),
        ("sand under a long object", format!("{body}length = 30\n[ground]\nfriction_angle_deg = 36\nunit_weight = 9e3\nsurcharge = 12e3\n\
            [[load]]\nforce = 2e6\nelevation = 3\n")),
        ("clay", format!("{body}[ground]\nundrained_strength = 60e3\nsurcharge = 12e3\n[[load]]\nforce = 120e3\nelevation = 5\n")),
        ("clay under an object", format!("{body}length = 3\n[ground]\nundrained_strength = 80e3\n[[load]]\nforce = 300e3\nelevation = 4\n\
            [[combination]]\nfactors = {{ }}\nresist = {{ bearing = 1.4 }}\n")),
        ("clay, slides within", format!("{body}[ground]\nundrained_strength = 30e3\n[[load]]\nforce = 250e3\nelevation = 1\n")),
        ("a period that goes with the height", format!("{caisson}{wave}depth_above_berm = 5.6\nberm_width = 8\n").replace("period = 11.4", "steepness = 0.031")),
        ("sand, slides", format!("{body}[ground]\nfriction_angle_deg = 45\nunit_weight = 2e4\nsurcharge = 90e3\n[[load]]\nforce = 600e3\nelevation = 1\n")),
        ("sand, the resultant outside", format!("{body}[ground]\nfriction_angle_deg = 40\nunit_weight = 1e4\n[[load]]\nforce = 700e3\nelevation = 6\n")),
        ("envelope", format!("{body}[ground]\nlaw = \"envelope\"\ncentric_resistance = \"4 MN/m\"\nC = 0.1\n[[load]]\nforce = 200e3\nelevation = 3\n")),
        ("envelope of an object, against the push", format!("{body}length = 2\ncentroid_offset = 0.8\n[ground]\nlaw = \"envelope\"\ncentric_resistance = \"9 MN\"\n\
            [[load]]\nforce = 90e3\nelevation = 1\n")),
        ("springs that lift", format!("{body}[ground]\nstiffness = 5e7\n[[load]]\nforce = 300e3\nelevation = 5\n[criteria]\nrotation_max = \"5 mrad\"\n")),
        ("springs that yield", format!("{body}[ground]\nstiffness = 5e7\nstrength = 230e3\n[[load]]\nforce = 150e3\nelevation = 5\n")),
        ("springs that lift and yield", format!("{body}[ground]\nstiffness = 5e7\nstrength = 900e3\n[[load]]\nforce = 440e3\nelevation = 5\n")),
        ("springs in time", format!("{body}[ground]\nstiffness = 8e7\ntangential_stiffness = 4e7\n[added_mass]\nmass = 10e3\n[[load]]\nforce = 400e3\nelevation = 4\n\
            history = {{ shape = \"triangle\", rise = 0.1, duration = 0.3 }}\n")),
        ("springs under a church roof, and what stands", format!("{body}length = 2\n[ground]\nstiffness = 8e7\ntangential_stiffness = 4e7\nstrength = 1e6\n\
            [[load]]\nname = \"wave\"\nforce = 500e3\nelevation = 2.5\ntogether = true\nhistory = {{ shape = \"church-roof\", rise = 0.02, impact_duration = 0.09, \
            tail = 0.3, duration = 0.6, start = 0.1 }}\n[[load]]\nname = \"wind\"\nforce = 50e3\nelevation = 6\ntogether = true\npermanent = true\n")),
        ("springs under loads of two courses", format!("{body}[ground]\nstiffness = 8e7\ntangential_stiffness = 4e7\n\
            [[load]]\nname = \"one\"\nforce = 100e3\nelevation = 4\ntogether = true\nhistory = {{ shape = \"decay\", duration = 0.3 }}\n\
            [[load]]\nname = \"other\"\nforce = 100e3\nelevation = 2\ntogether = true\nhistory = {{ shape = \"points\", times = [0, 0.1, 0.2], values = [0, 1, 0.5] }}\n")),
        ("crushing under uplift that grows", format!("{body}base_left = 2.5\n[ground]\nstrength = 300e3\n[uplift]\nleft = 10e3\nright = 40e3\ngrows = true\n\
            [[load]]\nforce = 130e3\nelevation = 5\ntogether = true\n")),
        ("crushing, pushed to the right against a lean", format!("{body}centroid_offset = -0.4\n[ground]\nstrength = 400e3\n[[load]]\nforce = 230e3\nelevation = 5\n\
            direction = \"right\"\n")),
        ("sand under uplift that grows", format!("{body}[ground]\nfriction_angle_deg = 38\nunit_weight = 9e3\n[uplift]\nleft = 5e3\nright = 30e3\ngrows = true\n\
            [[load]]\nforce = 60e3\nelevation = 4\n")),
        ("effective pressure of a rigid base", format!("{body}[[load]]\nforce = 1e5\nelevation = 4\n[criteria]\neffective_pressure_max = \"200 kPa\"\n")),
        ("lifted off sand", format!("{body}[ground]\nfriction_angle_deg = 40\nunit_weight = 1e4\n[[load]]\nforce = 2e6\ndirection = \"up\"\ndistance = 3\n")),
        ("no standing pressure", format!("{caisson}{wave}depth_above_berm = 5.6\nberm_width = 8\nlambda = [0, 1, 0.5]\n")),
        ("in air, in a combination", format!("{body}[[load]]\nname = \"push\"\nforce = 90e3\nelevation = 3\n[[combination]]\nfactors = {{ push = 1.5 }}\n")),
        ("shaken up and down", format!("{body}[earthquake]\nhorizontal = \"0.2 g\"\nvertical = \"0.3 g\"\n[criteria]\nbearing_max = \"250 kPa\"\nSF_sliding = 2.2\n")),
        ("never and at once", format!("{body}[criteria]\nload_factor = 1.5\nSF_sliding = 1.2\n[[load]]\nforce = 0\nelevation = 1\n")),
        ("uplift", format!("{body}[uplift]\nleft = 20e3\nright = 60e3\ngrows = true\n[[load]]\nforce = 100e3\nelevation = 5\ndirection = \"right\"\n")),
        ("drum in water", "[body]\nshape = \"cylinder\"\nwidth = 2.4\nheight = 3\ndensity = 2400\nfriction = 0.6\ncentroid_offset = 0.05\n[water]\nlevel = 1.5\n\
            density = 1000\n[uplift]\nleft = 1e3\nright = 4e3\n[[pressure]]\nface = \"right\"\nelevation = [0, 2]\npressure = [5e3, 1e3]\n\
            [[pressure]]\nface = \"top\"\ndistance = [0.5, 2]\npressure = [5e3, 1e3]\nscale = 1.5\n".to_owned()),
        ("drum on its rim", "[body]\nshape = \"cylinder\"\nwidth = 2\nheight = 3\nmass = \"10 t\"\nfriction = 0.6\n[[load]]\nforce = \"30 kN\"\nelevation = 2.5\n\
            direction = \"right\"\n[criteria]\nbearing_max = \"300 kPa\"\n".to_owned()),
        ("tank of a length", format!("{body}length = 4\n[water]\nleft = 2\nright = 5\ndensity = 1000\n[earthquake]\nhorizontal = \"0.1 g\"\n[added_mass]\nsides = 2\n\
            [uplift]\nleft = 1e3\nright = 2e3\n[[pressure]]\nname = \"fill\"\nface = \"left\"\nelevation = [0, 7]\npressure = [3e3, 0]\nscale = 0.5\n\
            [[combination]]\nfactors = {{ fill = 1.5, earthquake = 0.5, weight = 0.9 }}\n")),
        ("parts in water", "[body]\nfriction = 0.6\nwidth_scale = 1.1\n[water]\nleft = 6\nright = 4\ndensity = 1000\n[[part]]\nname = \"`foot`\"\nleft = 3\nwidth = 9\nbottom = 0\n\
            height = 1.5\ndensity = 2400\n[[part]]\nleft = 5\nwidth = 4\nbottom = 1.5\nheight = 8\ntop_left = 4.5\ntop_width = 3\ndensity = 2300\n\
            density_below_water = 2100\n[[part]]\nname = \"cavity\"\nx = [9, 12, 8.71875]\ny = [1.5, 1.5, 3]\ndensity = 0\n[[load]]\nforce = 90e3\nelevation = 5\n".to_owned()),
        ("a ledge and a nose in water", "[body]\nfriction = 0.6\n[water]\nleft = 8\nright = 5\ndensity = 1000\n[[part]]\nleft = 0\nwidth = 9\nbottom = 0\nheight = 2\n\
            density = 2400\n[[part]]\nx = [1, 9, 9, -1]\ny = [2, 2, 8, 8]\ndensity = 2400\n[[load]]\nforce = 9e3\nelevation = 5\n".to_owned()),
        ("lifted", format!("{body}[uplift]\nleft = 300e3\nright = 300e3\n")),
        ("weight alone", "[body]\nwidth = 6\nheight = 7\nmass = 100e3\nfriction = 0.6\nbuoyant_weight = 500e3\nweight_arm = 1.5\n[uplift]\nleft = 0\nright = 90e3\n".to_owned()),
        ("weight at the toe", "[body]\nwidth = 6\nheight = 7\nmass = 100e3\nfriction = 0.6\nbuoyant_weight = 500e3\nweight_arm = 5.5\n[uplift]\nleft = 0\nright = 90e3\n".to_owned()),
        ("at rest alone", format!("{body}[water]\nlevel = 5\ndensity = 1000\n")),
        ("low force", format!("{body}[[load]]\nforce = 900e3\nelevation = 0.5\n")),
        ("nothing pushes", format!("{body}[[load]]\nforce = 0\nelevation = 0.5\n")),
        ("through the base", format!("{body}[[load]]\nforce = 300e3\nelevation = 0\n")),
        ("not unique", "[body]\nwidth = 2\nheight = 2\nmass = 1e3\nfriction = 3\n[[load]]\nforce = 40e3\nelevation = 0.5\n".to_owned()),
        ("high and slender", "[body]\nwidth = 1\nheight = 5\nmass = 9e3\nfriction = 0.2\n[[load]]\nforce = 90e3\nelevation = 5\n".to_owned()),
        ("turned, wide berm", format!("{caisson}{wave}depth_above_berm = 4\nberm_width = 30\nturn_deg = 15\nlambda = [1, 0.9, 0.8]\n")),
        ("not impulsive", format!("{caisson}{wave}depth_above_berm = 5.6\nberm_width = 8\nimpulsive = false\n")),
        ("deep water", "[body]\nwidth = 15\nheight = 40\nmass = 1300e3\nfriction = 0.6\n[water]\nlevel = 30\n[wave]\ndeep_water_height = 3\nperiod = 6\n\
            sea_bottom_slope = 0.01\nwater_depth = 35\nbase_depth = 30\ncrest_height = 10\nangle_deg = 0\nwater_density = 1030\ndepth_above_berm = 28\n\
            berm_width = 8\n".to_owned()),
        ("stick and slip", "[body]\nwidth = 3\nheight = 3\nmass = 20e3\nfriction = 0.7\nkinetic_friction = 0.4\n[[load]]\nforce = 150e3\nelevation = 1\n".to_owned()),
        ("slide-rock", "[body]\nwidth = 3\nheight = 6\nmass = 20e3\nfriction = 0.5\ncentroid_height = 2.5\n[[load]]\nforce = 190e3\nelevation = 5\n".to_owned()),
    ];
    list.into_iter().map(|(name, text)| (format!("{name}.toml"), text)).collect()
}

/// The sheet of a case; made once for all tests of a program.
pub fn html(name: &str, text: &str) -> String {
    static MADE: Mutex<BTreeMap<(String, String), String>> = Mutex::new(BTreeMap::new());
    let case = (name.to_owned(), text.to_owned());
    if let Some(made) = MADE.lock().unwrap().get(&case) {
        return made.clone();
    }
    let sheet = Sheet::of(name, text, &SheetOptions::default());
    let sheet = sheet.unwrap_or_else(|error| panic!("{name}: {error}")).html().to_owned();
    MADE.lock().unwrap().insert(case, sheet.clone());
    sheet
}

pub fn document(name: &str, text: &str) -> Html {
    Html::parse_document(&html(name, text))
}

pub fn select<'a>(html: &'a Html, selector: &str) -> Vec<ElementRef<'a>> {
    html.select(&Selector::parse(selector).unwrap()).collect()
}

/// A step of the calculation as a reader finds it.
pub struct Step {
    pub name: String,
    /// True if there is a formula in symbols.
    pub symbols: bool,
    /// Result of the numbers, and the size of what they are summed of; SI.
    pub numbers: Option<(f64, f64)>,
    /// Result that the sheet shows, SI.
    pub result: Option<f64>,
}

pub fn steps(html: &Html) -> Vec<Step> {
    let steps = select(html, ".step");
    let one = |step: ElementRef<'_>| {
        let find = |selector: &str| step.select(&Selector::parse(selector).unwrap()).next();
        let numbers = find(".numbers")?;
        let result = find(".right data[data-side]").or_else(|| find(".result data"));
        Some(Step {
            name: numbers.attr("data-step").unwrap_or_default().to_owned(),
            symbols: find(".symbols math").is_some(),
            numbers: evaluate(numbers),
            result: result.and_then(|data| si(data, "value")),
        })
    };
    steps.into_iter().filter_map(one).collect()
}

/// SI units that make one of this unit.
fn unit(text: &str) -> f64 {
    match text.replace(['\u{a0}', '\u{202f}', ' '], " ").trim() {
        "" | "m" | "s" | "m²" | "m/s²" | "rad/s²" | "kg/m³" | "kg/m" | "N/m" | "Pa" | "kg m²/m" => 1.0,
        "kg" | "N" | "kg m²" | "N m" | "N/m²" | "N/m³" | "rad" | "1/s" | "1/s²" | "1/s⁴" => 1.0,
        "kN/m³" => 1e3,
        "MN/m³" | "kN²/m²" | "kN²" => 1e6,
        "mrad" => 1e-3,
        "t/m" | "kN/m" | "kPa" | "kN m/m" | "t m²/m" => 1e3,
        "t" | "kN" | "kN m" | "t m²" => 1e3,
        "°" => PI / 180.0,
        "ft" => 0.3048,
        "cm" => 0.01,
        "kip/ft" => 4_448.221_615_260_5 / 0.3048,
        "kip ft/ft" => 4_448.221_615_260_5,
        "psf" => 4.448_221_615_260_5 / (0.3048 * 0.3048),
        "tf/m" | "tf m/m" => 9_806.65,
        "kgf/cm²" => 98_066.5,
        // A sum of units, or what follows a number in a sentence.
        other => panic!("`{other}` is no unit"),
    }
}

/// A number with the unit behind it, in SI units; angles in radians.
pub fn si(element: ElementRef<'_>, attribute: &str) -> Option<f64> {
    let value: f64 = element.attr(attribute)?.parse().ok()?;
    // The unit of an input that is a list stands behind its last number.
    let list = within(element, "inputs");
    let mut siblings = element.next_siblings().filter_map(ElementRef::wrap);
    let behind = siblings.find(|next| !(list && next.value().name() == "data"));
    let text = behind.filter(|next| next.value().name() == "mtext" || next.attr("class") == Some("unit"));
    // The unit of a row of several situations stands in its last column.
    let text = text.or_else(|| {
        let row =
            element.ancestors().filter_map(ElementRef::wrap).find(|above| above.value().name() == "tr")?;
        row.select(&Selector::parse("td.of .unit").unwrap()).next()
    });
    let degree = element
        .next_sibling()
        .is_some_and(|next| matches!(next.value(), Node::Text(text) if text.starts_with('°')));
    let row = element.ancestors().filter_map(ElementRef::wrap).find(|above| above.value().name() == "tr");
    let of = Selector::parse("td.of").unwrap();
    let degree = degree
        || row
            .and_then(|row| row.select(&of).next())
            .is_some_and(|of| of.text().collect::<String>().trim() == "°");
    let column = common_column(element).unwrap_or(1.0);
    let scale =
        if degree { PI / 180.0 } else { text.map_or(1.0, |text| unit(&text.text().collect::<String>())) };
    Some(value * scale * column)
}

/// Size of the unit of a number of the table of motions, which stands in the next column.
fn common_column(element: ElementRef<'_>) -> Option<f64> {
    let row = element.ancestors().filter_map(ElementRef::wrap).find(|above| above.value().name() == "tr")?;
    let is_in_table = element.attr("data-quantity")?.starts_with("motion.") && within(element, "motion");
    let last = row.select(&Selector::parse("td:last-child").unwrap()).last()?.text().collect::<String>();
    (is_in_table && !last.is_empty()).then(|| unit(&last))
}

/// The sizes of the units in the head of the table of loads.
pub fn units_of_loads(html: &Html, scope: &str) -> Vec<f64> {
    let heads = select(html, &format!("{scope} [data-table=components] thead th.n"));
    heads.iter().map(|head| unit(&head.text().last().unwrap_or_default().replace('\u{202f}', " "))).collect()
}

pub fn within(element: ElementRef<'_>, class: &str) -> bool {
    element.ancestors().filter_map(ElementRef::wrap).any(|above| above.attr("data-table") == Some(class))
}

/// The number that a person reads.
pub fn shown(element: ElementRef<'_>) -> f64 {
    let mut text = String::new();
    for node in element.descendants() {
        if let Node::Text(part) = node.value() {
            let raised = node.parent().is_some_and(|above| {
                ElementRef::wrap(above).is_some_and(|above| {
                    above.value().name() == "sup"
                        || above.value().name() == "mn"
                            && above.prev_sibling().is_some()
                            && above
                                .parent()
                                .and_then(ElementRef::wrap)
                                .is_some_and(|up| up.value().name() == "msup")
                })
            });
            if raised {
                text.push('^');
            }
            text += part;
        }
    }
    let text = text.replace('−', "-").replace('⋅', "·").replace("·10^", "e");
    if text == "unlimited" {
        f64::INFINITY
    } else {
        text.parse().unwrap_or_else(|_| panic!("`{text}` is not a number"))
    }
}

/// True if a number is another one rounded to four digits or more, or to five places.
pub fn close(shown: f64, meant: f64) -> bool {
    shown == meant || (shown - meant).abs() <= 5.001e-4 * meant.abs() || (shown - meant).abs() <= 5.001e-6
}

/// A token of a formula: a value with the size of what it is made of, several values, a function, or an operator.
#[derive(Debug, Clone)]
enum Token {
    Value(f64, f64),
    List(Vec<(f64, f64)>),
    Function(String),
    Operator(char),
}

/// Result of the numbers of a step, and their size. `None` if there are none.
pub fn evaluate(numbers: ElementRef<'_>) -> Option<(f64, f64)> {
    let math: Vec<_> = numbers.select(&Selector::parse("math").unwrap()).collect();
    evaluate_with(&math, &Names::new())
}

/// Values of symbols, by their letters as they are read.
pub type Names = BTreeMap<String, f64>;

thread_local! {
    /// Values of the symbols in the formula that is read.
    static KNOWN: std::cell::RefCell<Names> = const { std::cell::RefCell::new(Names::new()) };
}

/// The letters of a symbol; `None` of an element that is no symbol.
pub fn letters(element: ElementRef<'_>) -> Option<String> {
    let text: String = element.text().collect();
    let is_symbol = match element.value().name() {
        "mi" | "msub" | "msubsup" | "mover" => true,
        "msup" => text.ends_with('∗'),
        "mrow" => text.ends_with('′') && !text.contains(['(', '+', '−', '|', '⋅', '\u{2062}']),
        _ => false,
    };
    is_symbol.then_some(text)
}

/// Result of a formula in which symbols stand for these values, and its size; `None` if it begins with no sign.
pub fn evaluate_with(math: &[ElementRef<'_>], names: &Names) -> Option<(f64, f64)> {
    KNOWN.with_borrow_mut(|known| known.clone_from(names));
    let mut tokens = Vec::new();
    for math in math {
        for row in math.children().filter_map(ElementRef::wrap) {
            tokens.extend(tokens_of(row));
        }
    }
    match tokens.first() {
        Some(Token::Operator('=' | '≤' | '≥' | '<' | '>')) => {
            Some(Reader { tokens: &tokens[1..] }.whole())
        }
        _ => None,
    }
}

fn tokens_of(row: ElementRef<'_>) -> Vec<Token> {
    let mut tokens = Vec::new();
    for element in row.children().filter_map(ElementRef::wrap) {
        let text: String = element.text().collect();
        let children: Vec<_> = element.children().filter_map(ElementRef::wrap).collect();
        let inner = |i: usize| Reader { tokens: &token_of(children[i]) }.whole();
        let known = letters(element).and_then(|name| KNOWN.with_borrow(|known| known.get(&name).copied()));
        let token = match element.value().name() {
            _ if known.is_some() => Token::Value(known.unwrap(), known.unwrap().abs()),
            _ if element.attr("data-value").is_some() => {
                let value = si(element, "data-value").unwrap();
                Token::Value(value, value.abs())
            }
            "mn" => {
                let value: f64 = text.parse().unwrap();
                Token::Value(value, value)
            }
            "mtext" => continue,
            "mi" if text == "π" => Token::Value(PI, PI),
            "mi" => Token::Function(text),
            "mo" => match text.chars().next().unwrap() {
                '\u{2061}' => continue,
                '\u{2062}' => Token::Operator('⋅'),
                sign => Token::Operator(sign),
            },
            "mfrac" => {
                let ((above, size), (below, _)) = (inner(0), inner(1));
                Token::Value(above / below, size / below.abs())
            }
            "msup" => {
                let ((base, _), (exponent, _)) = (inner(0), inner(1));
                let power = base.powf(exponent);
                Token::Value(power, power.abs())
            }
            "msqrt" => {
                let (value, _) = Reader { tokens: &tokens_of(element) }.whole();
                Token::Value(value.sqrt(), value.sqrt())
            }
            "mrow" => token_of(element).remove(0),
            other => panic!("{other} in numbers"),
        };
        tokens.push(token);
    }
    tokens
}

/// A row as one token, any other element as it is.
fn token_of(element: ElementRef<'_>) -> Vec<Token> {
    let known = letters(element).and_then(|name| KNOWN.with_borrow(|known| known.get(&name).copied()));
    if let Some(value) = known {
        return vec![Token::Value(value, value.abs())];
    }
    if element.attr("data-value").is_some() || element.value().name() != "mrow" {
        let value: f64 = match element.attr("data-value") {
            Some(value) => value.parse().unwrap(),
            None => match element.value().name() {
                "mn" => element.text().collect::<String>().parse().unwrap(),
                other => panic!("{other} alone"),
            },
        };
        return vec![Token::Value(value, value.abs())];
    }
    let tokens = tokens_of(element);
    if let Some(Token::Operator('{')) = tokens.first() {
        let inner = &tokens[1..tokens.len() - 1];
        let parts = inner.split(|token| matches!(token, Token::Operator(',')));
        return vec![Token::List(parts.map(|tokens| Reader { tokens }.whole()).collect())];
    }
    let (value, size) = Reader { tokens: &tokens }.whole();
    vec![Token::Value(value, size)]
}

struct Reader<'a> {
    tokens: &'a [Token],
}

impl Reader<'_> {
    fn whole(mut self) -> (f64, f64) {
        let value = self.sum();
        assert!(self.tokens.is_empty(), "left over: {:?}", self.tokens);
        value
    }

    fn take(&mut self, sign: char) -> bool {
        let found = matches!(self.tokens.first(), Some(Token::Operator(first)) if *first == sign);
        if found {
            self.tokens = &self.tokens[1..];
        }
        found
    }

    fn sum(&mut self) -> (f64, f64) {
        let negative = self.take('−');
        let (value, mut size) = self.product();
        let mut total = if negative { -value } else { value };
        loop {
            let sign = if self.take('+') {
                1.0
            } else if self.take('−') {
                -1.0
            } else {
                return (total, size);
            };
            let (value, term) = self.product();
            total += sign * value;
            size += term;
        }
    }

    fn product(&mut self) -> (f64, f64) {
        let (mut value, mut size) = self.factor();
        loop {
            if self.take('⋅') {
                let (factor, term) = self.factor();
                value *= factor;
                size *= term;
            } else if self.take('/') {
                let (divisor, _) = self.factor();
                value /= divisor;
                size /= divisor.abs();
            } else {
                return (value, size);
            }
        }
    }

    fn factor(&mut self) -> (f64, f64) {
        let token = self.tokens[0].clone();
        self.tokens = &self.tokens[1..];
        match token {
            Token::Value(value, size) => (value, size),
            Token::Operator('(') => {
                let value = self.sum();
                assert!(self.take(')'));
                value
            }
            Token::Operator('|') => {
                let (value, size) = self.sum();
                assert!(self.take('|'));
                (value.abs(), size)
            }
            Token::Function(name) => {
                let argument = self.tokens[0].clone();
                self.tokens = &self.tokens[1..];
                let (value, size) = match (name.as_str(), argument) {
                    ("min", Token::List(list)) => {
                        list.into_iter().min_by(|a, b| a.0.total_cmp(&b.0)).unwrap()
                    }
                    ("max", Token::List(list)) => {
                        list.into_iter().max_by(|a, b| a.0.total_cmp(&b.0)).unwrap()
                    }
                    (_, Token::Value(x, _)) => {
                        let value = match name.as_str() {
                            "sin" => x.sin(),
                            "cos" => x.cos(),
                            "tan" => x.tan(),
                            "sinh" => x.sinh(),
                            "cosh" => x.cosh(),
                            "tanh" => x.tanh(),
                            "exp" => x.exp(),
                            other => panic!("{other} is no function"),
                        };
                        (value, value.abs())
                    }
                    other => panic!("{other:?}"),
                };
                (value, size)
            }
            other => panic!("{other:?} is no factor"),
        }
    }
}

/// True of what stands in the block of a joint, whose symbols and numbers are of what is above that.
pub fn is_of_joint(element: ElementRef<'_>) -> bool {
    element.ancestors().filter_map(ElementRef::wrap).any(|above| above.attr("data-joint").is_some())
}
