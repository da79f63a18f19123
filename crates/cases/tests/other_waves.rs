//! Waves by Sainflou's formula and on crown walls, from the text of a case to its answer.

mod common;

use common::{assess, file, refused, six};

/// The caisson of the specification before standing waves, with lines in place of those for the height.
fn standing(height: &str, phase: &str) -> String {
    format!(
        "[body]\nwidth = 16\nheight = 17\ndensity = 2200\nfriction = 0.6\n[water]\nlevel = 11\n[wave]\nformula = \"sainflou\"\n{height}\n\
         phase = \"{phase}\"\nperiod = 9\nwater_depth = 14\nstill_water = 11\ncrest_height = 6\nwater_density = 1030\n"
    )
}

fn thrust_and_uplift(text: &str) -> [f64; 2] {
    let assessment = assess(text);
    let actions = assessment.governing().outcome.actions;
    [actions.force, actions.uplift]
}

#[test]
fn crest_and_trough_load_the_body() {
    let crest = thrust_and_uplift(&standing("height = 4.5", "crest"));
    six(crest[0], 584534.0);
    six(crest[1], 275639.0);
    let trough = thrust_and_uplift(&standing("height = 4.5", "trough"));
    // To the right: about the toe.
    six(trough[0], 318472.0);
    six(trough[1], -258249.0);
    let sealed = standing("height = 4.5\nuplift = false", "crest");
    assert_eq!(thrust_and_uplift(&sealed)[1], 0.0);
}

/// Which height counts is the user's choice: a length, one of those at the wall, or one found from deep water.
#[test]
fn the_height_is_a_length_or_one_of_the_sea() {
    let typed = thrust_and_uplift(&standing("height = 4.5", "crest"));
    for height in [
        "height = \"H13\"\nH13 = 4.5",
        "height = \"Hmax\"\nHmax = 4.5",
        "height = \"Hmax\"\nH13 = 2.5\nHmax = 4.5",
    ] {
        assert_eq!(thrust_and_uplift(&standing(height, "crest")), typed, "{height}");
    }
    let deep = "deep_water_height = 4\nsea_bottom_slope = 0.01";
    let [significant, maximum] = ["H13", "Hmax"]
        .map(|which| thrust_and_uplift(&standing(&format!("height = \"{which}\"\n{deep}"), "crest"))[0]);
    assert!(significant < maximum);
    let lacks = refused(&standing("height = \"Hmax\"\ndeep_water_height = 4", "crest"));
    assert!(lacks.contains("[wave] lacks `sea_bottom_slope`"), "{lacks}");
    let both = refused(&standing("height = 4.5\nHmax = 4.5", "crest"));
    assert!(both.contains("[wave] has both `height` and `Hmax`"), "{both}");
}

#[test]
fn keys_of_other_formulas_are_refused_by_name() {
    for (line, key) in [
        ("berm_width = 8", "berm_width"),
        ("lambda = [1, 1, 1]", "lambda"),
        ("armour_crest = 4", "armour_crest"),
    ] {
        let error = refused(&standing(&format!("height = 4.5\n{line}"), "crest"));
        assert!(error.contains(&format!("`{key}` is no key of formula = \"sainflou\"")), "{error}");
    }
    let goda = standing("", "crest").replace("formula = \"sainflou\"\n", "");
    assert!(refused(&goda).contains("`phase` is no key of formula = \"goda\""));
    let both = standing("height = 4.5\nbase_depth = 11", "crest");
    assert!(refused(&both).contains("[wave] has both `still_water` and `base_depth`"));
    let aside = standing("height = 4.5\nangle_deg = 5", "crest");
    assert!(refused(&aside).contains("waves head on"));
    let dry = standing("height = 4.5", "trough")
        .replace("still_water = 11", "still_water = 2")
        .replace("level = 11", "level = 2");
    let dry = dry.replace("crest_height = 6", "crest_height = 15");
    assert!(
        refused(&dry).contains("`still_water` is 2; expected more than the fall of the water in a trough")
    );
}

/// One file has the crest by Goda and the trough by Sainflou at low water: keys that the other formula has no use for go.
#[test]
fn a_combination_takes_another_formula() {
    let goda = "[body]\nwidth = 15\nheight = 10.5\nmass = 346050\nfriction = 0.6\n[water]\nlevel = 7.1\n[wave]\nH13 = 5.8\nHmax = 8.05\n\
                period = 11.4\nsea_bottom_slope = 0.01\nwater_depth = 10.1\ndepth_above_berm = 5.6\nbase_depth = 7.1\ncrest_height = 3.4\n\
                berm_width = 8\nangle_deg = 0\nwater_density = 1030\n";
    let both = format!(
        "{goda}[[combination]]\nname = \"crest\"\nfactors = {{ wave = 1 }}\n[[combination]]\nname = \"trough\"\n\
         set = {{ \"wave.formula\" = \"sainflou\", \"wave.phase\" = \"trough\", \"wave.height\" = \"H13\", \"water.level\" = 6.5 }}\n\
         factors = {{ wave = 1 }}\n"
    );
    let assessment = assess(&both);
    let alone = assess(
        "[body]\nwidth = 15\nheight = 10.5\nmass = 346050\nfriction = 0.6\n[water]\nlevel = 6.5\n[wave]\nformula = \"sainflou\"\nH13 = 5.8\n\
         height = \"H13\"\nphase = \"trough\"\nperiod = 11.4\nwater_depth = 9.5\nbase_depth = 6.5\ncrest_height = 4\nwater_density = 1030\n",
    );
    let [crest, trough] = [0, 1].map(|index| assessment.all[index].outcome.actions);
    assert!(crest.force > 9e5);
    six(trough.force, alone.all[0].outcome.actions.force);
    six(trough.uplift, alone.all[0].outcome.actions.uplift);
}

/// PIANC multiplies the heights at the wall as they are found: the depth does not limit them again.
#[test]
fn pianc_multiplies_the_heights_as_they_are_found() {
    let goda = |heights: &str, more: &str| {
        format!(
            "[body]\nwidth = 15\nheight = 10.5\nmass = 346050\nfriction = 0.6\n[water]\nlevel = 7.1\n[wave]\n{heights}\n\
             period = 11.4\nsea_bottom_slope = 0.01\nwater_depth = 10.1\ndepth_above_berm = 5.6\nbase_depth = 7.1\ncrest_height = 3.4\n\
             berm_width = 8\nangle_deg = 0\nwater_density = 1030\n{more}"
        )
    };
    let code = "[[combination]]\nname = \"c\"\ncode = \"PIANC28-sliding\"\noptions = { p_f = 0.1, water = \"deep\", model_tests = false, sigma = 0.05 }\n";
    let deep = "deep_water_height = 6.3";
    let found = assess(&goda(deep, "")).case.goda().map(|waves| [waves.goda.h_13, waves.goda.h_max]).unwrap();
    let checked = assess(&goda(deep, code));
    let under = checked.case.under(checked.governing().acting).goda().unwrap().goda.clone();
    six(under.h_13, 1.3 * found[0]);
    six(under.h_max, 1.3 * found[1]);
    // And so does who writes it out.
    let by_hand = "[[combination]]\nname = \"c\"\nscale = { \"wave.H13\" = 1.3, \"wave.Hmax\" = 1.3 }\nmaterials = { \"body.friction\" = 1.2 }\n\
                   factors = { \"wave.thrust\" = 0.9, \"wave.uplift\" = 0.77 }\n";
    let by_hand = assess(&goda(deep, by_hand));
    six(by_hand.governing().outcome.actions.force, checked.governing().outcome.actions.force);
    six(by_hand.governing().outcome.stability.sliding, checked.governing().outcome.stability.sliding);
}

/// A crown wall of the specification, in concrete.
fn crown(formula: &str, lines: &str) -> String {
    format!(
        "[body]\nwidth = 8\nheight = 3.5\ndensity = 2350\nfriction = 0.6\n[wave]\nformula = \"{formula}\"\nH13 = 4\narmour_slope = 2\n\
         armour_crest = 4\nwater_density = 1025\n{lines}"
    )
}

const PEDERSEN: &str = "period = 8.59106\narmour_width = 5\nprotected_height = 2\nfree_height = 1.5\n";
const VAN_GENT: &str = "period = 10\nroughness = 0.45\nbase_freeboard = 1.5\n";

#[test]
fn crown_walls_are_loaded_without_water_beside_them() {
    let assessment = assess(&crown("pedersen", PEDERSEN));
    let actions = assessment.governing().outcome.actions;
    six(actions.force, 180088.0);
    six(actions.force_moment, 346670.0);
    six(actions.uplift, 0.5 * 52538.9 * 8.0);
    let names: Vec<&str> = assessment.case.warnings().iter().map(|warning| warning.name()).collect();
    assert_eq!(names, ["crown-wall-range"]);
    let assessment = assess(&crown("van-gent", VAN_GENT));
    let actions = assessment.governing().outcome.actions;
    six(actions.force, 88556.9);
    six(actions.uplift, 43857.4);
    six(actions.force_moment, actions.force * 1.75);
    six(actions.uplift_moment, actions.uplift * 8.0 * 2.0 / 3.0);
}

#[test]
fn a_crown_wall_says_what_is_unusual() {
    let low = PEDERSEN.replace("free_height = 1.5", "free_height = 1");
    let warnings: Vec<&str> =
        assess(&crown("pedersen", &low)).case.warnings().iter().map(|warning| warning.name()).collect();
    assert!(warnings.contains(&"crown-wall-height"), "{warnings:?}");
    let wide = refused(&crown("van-gent", &format!("{VAN_GENT}wall_base = 9\n")));
    assert!(wide.contains("`wall_base` is 9 m, but the base of the body is 8 m wide"), "{wide}");
    // A narrower one is lifted from its seaward edge.
    let narrow = assess(&crown("van-gent", &format!("{VAN_GENT}wall_base = 4\n")));
    let actions = narrow.governing().outcome.actions;
    six(actions.uplift, 43857.4 / 2.0);
    six(actions.uplift_moment, actions.uplift * (8.0 - 4.0 / 3.0));
    let aside = refused(&crown("pedersen", &format!("{PEDERSEN}angle_deg = 20\n")));
    assert!(aside.contains("waves head on"), "{aside}");
    assert!(file(&crown("van-gent", &format!("{VAN_GENT}angle_deg = 20\n"))).case().is_ok());
}
