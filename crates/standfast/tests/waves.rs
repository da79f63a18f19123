//! Goda's pressures against published and independently computed results (validation/goda.toml), and against slips that
//! other tools are known to make.

use serde::Deserialize;
use standfast::loads::Pose;
use standfast::wave::{
    BreakingTerms, CaissonSection, Choices, Heights, Sea, WaveWarning, goda, shoaling, wavelength,
};
use standfast::{Bearing, Body, ClassicalActions, Corner, Quantity, Wrench};

/// A case of the file; keys that a case lacks are those of its base.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(default)]
struct Case {
    name: String,
    base: Option<String>,
    deep_water_height: Option<f64>,
    #[serde(rename = "H13")]
    h_13: Option<f64>,
    #[serde(rename = "Hmax")]
    h_max: Option<f64>,
    period: Option<f64>,
    sea_bottom_slope: Option<f64>,
    water_depth: Option<f64>,
    depth_above_berm: Option<f64>,
    base_depth: Option<f64>,
    crest_height: Option<f64>,
    berm_width: Option<f64>,
    caisson_width: Option<f64>,
    angle_deg: Option<f64>,
    water_density: Option<f64>,
    friction: Option<f64>,
    weight_arm_ratio: Option<f64>,
    buoyant_weight: Option<f64>,
    impulsive: Option<bool>,
    published: std::collections::BTreeMap<String, f64>,
    recomputed: std::collections::BTreeMap<String, f64>,
}

#[derive(Deserialize)]
struct File {
    case: Vec<Case>,
}

impl Case {
    fn over(&self, base: &Case) -> Case {
        Case {
            name: self.name.clone(),
            base: None,
            deep_water_height: self.deep_water_height.or(base.deep_water_height),
            h_13: self.h_13.or(base.h_13),
            h_max: self.h_max.or(base.h_max),
            period: self.period.or(base.period),
            sea_bottom_slope: self.sea_bottom_slope.or(base.sea_bottom_slope),
            water_depth: self.water_depth.or(base.water_depth),
            depth_above_berm: self.depth_above_berm.or(base.depth_above_berm),
            base_depth: self.base_depth.or(base.base_depth),
            crest_height: self.crest_height.or(base.crest_height),
            berm_width: self.berm_width.or(base.berm_width),
            caisson_width: self.caisson_width.or(base.caisson_width),
            angle_deg: self.angle_deg.or(base.angle_deg),
            water_density: self.water_density.or(base.water_density),
            friction: self.friction.or(base.friction),
            weight_arm_ratio: self.weight_arm_ratio.or(base.weight_arm_ratio),
            buoyant_weight: self.buoyant_weight.or(base.buoyant_weight),
            impulsive: self.impulsive.or(base.impulsive),
            published: self.published.clone(),
            recomputed: self.recomputed.clone(),
        }
    }

    fn sea(&self) -> Sea {
        Sea {
            water_depth: self.water_depth.unwrap(),
            sea_bottom_slope: self.sea_bottom_slope.unwrap(),
            period: self.period.unwrap(),
            angle_deg: self.angle_deg.unwrap(),
            water_density: self.water_density.unwrap(),
            gravity: 9.81,
        }
    }

    fn section(&self) -> CaissonSection {
        CaissonSection {
            base_depth: self.base_depth.unwrap(),
            depth_above_berm: self.depth_above_berm.unwrap(),
            crest_height: self.crest_height.unwrap(),
            berm_width: self.berm_width.unwrap(),
            caisson_width: self.caisson_width.unwrap(),
        }
    }

    fn choices(&self) -> Choices {
        Choices { impulsive: self.impulsive.unwrap_or(true), ..Choices::default() }
    }
}

fn cases() -> Vec<Case> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../validation/goda.toml");
    let file: File = toml::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    let base = |name: &str| file.case.iter().find(|case| case.name == name).unwrap();
    file.case
        .iter()
        .map(|case| case.base.as_deref().map_or(case.clone(), |name| case.over(base(name))))
        .collect()
}

/// Half a unit in the last digit given, or the file's relative tolerance, whichever is larger.
fn agrees(found: f64, expected: f64, digits: f64, relative: f64) -> bool {
    (found - expected).abs() <= (0.5000001 * digits).max(relative * expected.abs())
}

#[test]
fn goda_s_worked_example() {
    let case = &cases()[0];
    let deep = Heights::DeepWater(case.deep_water_height.unwrap());
    let from_deep = goda(&case.sea(), &deep, &case.section(), &case.choices()).unwrap();
    assert!(agrees(from_deep.h_13, case.published["H13"], 1e-3, 0.0));
    // Published as 8.050; unrounded it is 8.0495.
    assert!(agrees(from_deep.h_max, case.published["Hmax"], 1e-3, 0.0));
    assert!(agrees(from_deep.force, 940.61e3, 10.0, 0.0));

    let local = Heights::Local { significant: case.published["H13"], maximum: case.published["Hmax"] };
    let result = goda(&case.sea(), &local, &case.section(), &case.choices()).unwrap();
    let check = |name: &str, found: f64| {
        let expected = case.published.get(name).or(case.recomputed.get(name)).unwrap();
        // Coefficients are given to four decimals, which for α₂ is more than 1e-4 of it.
        let digits = if name.starts_with("alpha") { 1e-4 } else { 0.0 };
        assert!(agrees(found, *expected, digits, 1e-4), "{name}: {found}, expected {expected}");
    };
    check("alpha_I", result.alpha_impulsive);
    check("p1", result.p1 / 1e3);
    check("p3", result.p3 / 1e3);
    check("p4", result.p4 / 1e3);
    check("pu", result.pu / 1e3);
    check("wavelength", result.wavelength);
    check("h_b", result.h_b);
    check("alpha_1", result.alpha_1);
    check("alpha_2", result.alpha_2);
    check("alpha_3", result.alpha_3);
    check("eta_star", result.eta_star);
    check("P", result.force / 1e3);
    check("M_p", result.force_moment / 1e3);
    check("U", result.uplift / 1e3);
    check("M_U", result.uplift_moment / 1e3);

    // Concrete of 2400 kg/m³ above water, a mean of 2100 below.
    let buoyant_weight = 15.0 * (3.4 * 2400.0 + 7.1 * (2100.0 - 1030.0)) * 9.81;
    check("buoyant_weight", buoyant_weight / 1e3);
    let actions = ClassicalActions {
        heel: Corner::O,
        buoyant_weight,
        weight_arm: 7.5,
        uplift: result.uplift,
        uplift_moment: result.uplift_moment,
        force: result.force,
        force_moment: result.force_moment,
    };
    let stability = actions.stability(case.friction.unwrap(), &wide(15.0));
    let (sliding, overturning) = (stability.sliding, stability.overturning());
    // Given to four figures.
    assert!(agrees(sliding, case.recomputed["SF_sliding"], 1e-3, 0.0), "{sliding}");
    assert!(agrees(overturning, case.recomputed["SF_overturning_net"], 1e-3, 0.0), "{overturning}");
}

/// The other cases come from a source that solves the wavelength less exactly: 3e-4.
#[test]
fn published_cases_of_a_vertical_wall() {
    for case in &cases()[1..] {
        let heights = Heights::Local { significant: case.h_13.unwrap(), maximum: case.h_max.unwrap() };
        let result = goda(&case.sea(), &heights, &case.section(), &case.choices()).unwrap();
        let width = case.caisson_width.unwrap();
        let actions = ClassicalActions {
            heel: Corner::O,
            buoyant_weight: case.buoyant_weight.unwrap() * 1e3,
            weight_arm: case.weight_arm_ratio.unwrap() * width,
            uplift: result.uplift,
            uplift_moment: result.uplift_moment,
            force: result.force,
            force_moment: result.force_moment,
        };
        let stability = actions.stability(case.friction.unwrap(), &wide(width));
        let Bearing::Pressed { heel, .. } = stability.bearing else { panic!("{}", case.name) };
        for (name, found) in [
            ("P", result.force / 1e3),
            ("U", result.uplift / 1e3),
            ("M_p", result.force_moment / 1e3),
            ("M_U", result.uplift_moment / 1e3),
            ("p1", result.p1 / 1e3),
            ("pu", result.pu / 1e3),
            ("SF_sliding", stability.sliding),
            ("SF_overturning_net", stability.overturning()),
            ("heel_pressure", heel / 1e3),
        ] {
            let expected = case.published[name];
            assert!(
                agrees(found, expected, 0.0, 3e-4),
                "{}: {name} = {found}, expected {expected}",
                case.name
            );
        }
    }
}

fn example() -> (Sea, Heights, CaissonSection) {
    let case = &cases()[0];
    (case.sea(), Heights::DeepWater(case.deep_water_height.unwrap()), case.section())
}

/// The pressure diagram integrated numerically, from η* or the crest down to the base: force and moment. A centroid taken
/// to the crest instead of min(η*, h_c), a known slip, fails here for a crest above η*.
#[test]
fn force_and_moment_are_those_of_the_pressure_diagram() {
    let (sea, heights, section) = example();
    for crest_height in [0.5, 3.4, 11.0, 20.0] {
        let section = CaissonSection { crest_height, ..section };
        let g = goda(&sea, &heights, &section, &Choices::default()).unwrap();
        assert_eq!(g.h_c_star, g.eta_star.min(crest_height));
        let (mut force, mut moment) = (0.0, 0.0);
        let steps = 200_000;
        let height = section.base_depth + crest_height;
        for i in 0..steps {
            let z = height * (f64::from(i) + 0.5) / f64::from(steps);
            let above = z - section.base_depth;
            let pressure = if above > 0.0 {
                (g.p1 * (1.0 - above / g.eta_star)).max(0.0)
            } else {
                g.p3 + (g.p1 - g.p3) * z / section.base_depth
            };
            force += pressure * height / f64::from(steps);
            moment += z * pressure * height / f64::from(steps);
        }
        assert!((force / g.force - 1.0).abs() < 1e-6, "{crest_height}: {force} {}", g.force);
        assert!((moment / g.force_moment - 1.0).abs() < 1e-6, "{crest_height}: {moment} {}", g.force_moment);
    }
}

/// Degrees are degrees: 90° from the normal leaves half of the standing pressure, and a turn is taken off.
#[test]
fn the_angle_is_in_degrees_and_may_be_turned() {
    let (sea, heights, section) = example();
    let at = |angle_deg, turn_deg| {
        let choices = Choices { turn_deg, ..Choices::default() };
        goda(&Sea { angle_deg, ..sea }, &heights, &section, &choices).unwrap()
    };
    let normal = at(0.0, 0.0);
    assert!((at(90.0, 0.0).eta_star / normal.eta_star - 0.5).abs() < 1e-12);
    assert!((at(60.0, 0.0).eta_star / normal.eta_star - 0.75).abs() < 1e-12);
    assert_eq!(at(10.0, 15.0), normal);
    assert_eq!(at(40.0, 15.0), at(25.0, 0.0));
}

/// W' has the arm t that is given, not B/2.
#[test]
fn the_weight_s_arm_is_its_own() {
    let actions = ClassicalActions {
        heel: Corner::O,
        buoyant_weight: 100.0,
        weight_arm: 4.0,
        uplift: 20.0,
        uplift_moment: 120.0,
        force: 30.0,
        force_moment: 100.0,
    };
    let stability = actions.stability(0.6, &wide(9.0));
    assert_eq!(stability.overturning(), 2.8);
    assert_eq!(stability.sliding, 0.6 * 80.0 / 30.0);
    assert_eq!(stability.resultant_arm, Some(180.0 / 80.0));
}

/// A body just in balance does not turn: without a force the factor is infinite there, and zero as soon as it is not.
#[test]
fn what_is_in_balance_does_not_turn() {
    let stability = |uplift_moment: f64, force_moment: f64| {
        let actions = ClassicalActions {
            heel: Corner::O,
            buoyant_weight: 10.0,
            weight_arm: 2.0,
            uplift: 5.0,
            uplift_moment,
            force: 0.0,
            force_moment,
        };
        actions.stability(0.6, &wide(4.0))
    };
    let factors = |uplift_moment: f64, force_moment: f64| {
        let stability = stability(uplift_moment, force_moment);
        assert_eq!(stability.sliding, f64::INFINITY);
        (stability.overturning_about_heel, stability.overturning_about_toe)
    };
    let inf = f64::INFINITY;
    // About the heel 10·2 resist M_U; about the toe 5·4 − (20 − M_U) remain.
    assert_eq!(factors(20.0, 0.0), (inf, inf));
    assert_eq!(factors(20.5, 0.0), (0.0, inf));
    assert_eq!(factors(0.0, 0.0), (inf, inf));
    assert_eq!(factors(-0.5, 0.0), (inf, 0.0));
    assert_eq!(factors(20.0, 1.0), (0.0, inf));
    assert_eq!(factors(10.0, 4.0), (2.5, inf));
    assert_eq!(factors(10.0, -4.0), (inf, 2.5));
    assert_eq!(factors(0.0, -1.0), (inf, 0.0));
}

/// A body whose base is so wide, m.
fn wide(width: f64) -> Body {
    Body::new(width, 1.0, 1.0).unwrap()
}

/// The three ranges of the pressure join, and there is none without contact.
#[test]
fn bearing_pressure_has_its_ranges() {
    let at = |resultant_arm: f64| {
        let actions = ClassicalActions {
            heel: Corner::O,
            buoyant_weight: 90.0,
            weight_arm: resultant_arm,
            uplift: 0.0,
            uplift_moment: 0.0,
            force: 0.0,
            force_moment: 0.0,
        };
        actions.stability(0.6, &wide(9.0)).bearing
    };
    for (arm, mirrored) in [(3.0, false), (6.0, true)] {
        for nudge in [-1e-9, 1e-9] {
            let Bearing::Pressed { heel, toe, .. } = at(arm + nudge) else { panic!() };
            let largest = if mirrored { toe } else { heel };
            assert!((largest - 20.0).abs() < 1e-6 && (heel + toe - 20.0).abs() < 1e-6); // 2W/B
        }
    }
    let even = Bearing::Pressed { heel: 10.0, toe: 10.0, contact: 9.0, share: 1.0 };
    assert_eq!(at(4.5), even); // W/B
    assert_eq!([at(0.0), at(-1.0), at(9.0)], [Bearing::OutsideBase; 3]);
}

/// The pressures as loads of a body add up to Goda's force, uplift and moments.
#[test]
fn pressures_on_a_body_are_the_resultants() {
    let (sea, heights, section) = example();
    for crest_height in [0.5, 3.4, 11.0, 20.0] {
        let section = CaissonSection { crest_height, ..section };
        let waves = goda(&sea, &heights, &section, &Choices::default()).unwrap();
        let body = Body::new(section.caisson_width, section.base_depth + crest_height, 1e6).unwrap();
        let Ok([wall, uplift]) = <[_; 2]>::try_from(waves.loads(&body, section.base_depth)) else { panic!() };
        let [wall, uplift] = [wall, uplift].map(|load| load.action.wrench(&body, 9.81, Pose::UPRIGHT));
        let about_o = |Wrench { x, p, m }: Wrench| m - p * body.heel_distance() - x * body.centroid_height();
        for (found, expected) in [
            (-wall.x, waves.force),
            (about_o(wall), waves.force_moment),
            (-uplift.p, waves.uplift),
            (about_o(uplift), waves.uplift_moment),
        ] {
            assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
        }
    }
}

#[test]
fn warnings_name_their_trigger() {
    let (sea, heights, section) = example();
    let names = |sea: &Sea, heights: &Heights, section: &CaissonSection| -> Vec<String> {
        goda(sea, heights, section, &Choices::default())
            .unwrap()
            .warnings
            .iter()
            .map(ToString::to_string)
            .collect()
    };
    // The worked example has d/h = 0.55 and B_M/L = 0.074: impulsive breaking is possible.
    assert_eq!(
        names(&sea, &heights, &section),
        [
            "impulsive breaking is possible: berm width B_M/L = 0.074, depth above the berm d/h = 0.554, bed slope 0.010, steepness H0'/L0 = 0.0310; the pressures may be exceeded"
        ]
    );
    let low_berm = CaissonSection { depth_above_berm: 6.5, ..section };
    assert!(names(&sea, &heights, &low_berm).is_empty());
    let deep = Sea { water_depth: 60.0, ..sea };
    let deep_section = CaissonSection { depth_above_berm: 50.0, base_depth: 52.0, ..section };
    assert!(matches!(
        goda(&deep, &heights, &deep_section, &Choices::default()).unwrap().warnings[..],
        [WaveWarning::DeepWater { ratio }] if (ratio - 60.0 / 202.9).abs() < 1e-3
    ));
    let high = Heights::Local { significant: 9.0, maximum: 15.0 };
    assert!(
        names(&sea, &high, &low_berm)[0].starts_with("H_max = 15.00 m is above the breaking limit 8.09 m")
    );
    let deep_base = CaissonSection { base_depth: 11.0, ..low_berm };
    assert_eq!(
        names(&sea, &heights, &deep_base),
        [
            "base_depth = 11.00 m is more than the water depth 10.10 m: the base would lie below the sea bed in front of it"
        ]
    );
    let sunk_berm = CaissonSection { depth_above_berm: 8.0, ..section };
    assert_eq!(
        names(&sea, &heights, &sunk_berm),
        ["depth_above_berm = 8.00 m is more than base_depth = 7.10 m: the berm would lie below the base"]
    );
    let tide = Sea { period: 40.0, sea_bottom_slope: 0.0, ..sea };
    let local = Heights::Local { significant: 2.0, maximum: 3.0 };
    assert_eq!(
        names(&tide, &local, &low_berm),
        [
            "period = 40 s is longer than that of wind waves and swell (30 s at most), for which the formulas were found"
        ]
    );
    let steep = Sea { sea_bottom_slope: 0.2, ..sea };
    assert_eq!(
        names(&steep, &local, &low_berm),
        ["bed slope 0.2: the wave heights were computed for beds of 0.1 at most"]
    );
}

#[test]
fn impossible_seas_are_refused() {
    let (sea, heights, section) = example();
    let message = |sea: Sea, heights: Heights, section: CaissonSection, choices: Choices| {
        goda(&sea, &heights, &section, &choices).unwrap_err().to_string()
    };
    let default = Choices::default();
    assert_eq!(
        message(sea, heights, CaissonSection { depth_above_berm: 11.0, ..section }, default),
        "depth above the berm is 11; expected no more than the water depth: the berm lies on the sea bed"
    );
    assert_eq!(
        message(sea, heights, CaissonSection { crest_height: -0.5, ..section }, default),
        "crest height is -0.5; expected above zero: the crest has to stand above still water"
    );
    assert_eq!(
        message(sea, Heights::Local { significant: 5.0, maximum: 4.0 }, section, default),
        "maximum wave height is 4; expected no less than the significant wave height"
    );
    assert_eq!(
        message(Sea { angle_deg: 95.0, ..sea }, heights, section, default),
        "wave angle is 95; expected from 0 to 90 degrees from the wall's normal"
    );
    assert_eq!(
        message(sea, heights, section, Choices { turn_deg: 20.0, ..default }),
        "turn of the waves is 20; expected from 0 to 15 degrees"
    );
}

/// All branches of the impulsive coefficient, and the other branch of α₂, against a calculation apart from this library
/// (the formulas of docs/theory/loads.md in a few lines of Python).
#[test]
fn every_branch_of_the_breaking_coefficients() {
    let (sea, _, section) = example();
    // T, h, d, B_M, H_max, H_1/3, tanθ → α_I, α₂
    for ([period, h, d, berm_width, maximum, significant, slope], alpha_i, alpha_2) in [
        ([10.0, 10.0, 2.0, 8.0, 6.0, 3.5, 0.02], 1.5401346369405384, 2.0 / 3.0), // δ₁₁ > 0, δ₂₂ > 0, H/d > 2
        ([10.0, 10.0, 4.5, 40.0, 6.0, 3.5, 0.02], 0.03151338540615367, 0.33494363929146537), // δ₁₁ > 0, δ₂₂ < 0
        ([8.0, 12.0, 3.0, 40.0, 4.0, 2.4, 0.01], 0.0040364433373071785, 0.44591125779244584),
        ([8.0, 12.0, 7.0, 0.5, 4.0, 2.4, 0.01], 0.02977680288466955, 0.045980108214903115), // δ₁₁ < 0, δ₂₂ < 0
        ([12.0, 8.0, 1.5, 12.0, 5.0, 3.0, 0.01], 1.0939315105661176, 0.6),
    ] {
        let sea = Sea { period, water_depth: h, sea_bottom_slope: slope, ..sea };
        let section = CaissonSection { depth_above_berm: d, berm_width, base_depth: h - 1.0, ..section };
        let heights = Heights::Local { significant, maximum };
        let g = goda(&sea, &heights, &section, &Choices::default()).unwrap();
        assert!((g.alpha_impulsive / alpha_i - 1.0).abs() < 1e-9, "{period} {h} {d}: {}", g.alpha_impulsive);
        assert!((g.alpha_2 / alpha_2 - 1.0).abs() < 1e-9, "{period} {h} {d}: {}", g.alpha_2);
        assert_eq!(g.alpha_star, g.alpha_2.max(g.alpha_impulsive));
    }
}

/// Wave heights where shoaling, breaking or the largest factor governs, from the same calculation apart.
#[test]
fn wave_heights_from_deep_water() {
    let (sea, _, section) = example();
    for ([period, h, deep, slope], significant, maximum) in [
        ([6.0, 20.0, 3.0, 0.01], 2.8968750627606874, 5.214375112969238), // h/L₀ ≥ 0.2: shoaling alone
        ([12.0, 3.0, 4.0, 0.02], 2.2446073207566815, 3.209355816515558), // breaking
        ([12.0, 8.0, 2.0, 0.05], 2.1762370013289805, 3.917226602392165), // shoaling
        ([14.0, 10.0, 6.0, 0.05], 6.63821742594622, 10.620973331665517),
    ] {
        let sea = Sea { period, water_depth: h, sea_bottom_slope: slope, ..sea };
        let section = CaissonSection { depth_above_berm: 0.6 * h, base_depth: 0.8 * h, ..section };
        let g = goda(&sea, &Heights::DeepWater(deep), &section, &Choices::default()).unwrap();
        assert!((g.h_13 / significant - 1.0).abs() < 1e-9, "{period}: {}", g.h_13);
        assert!((g.h_max / maximum - 1.0).abs() < 1e-9, "{period}: {}", g.h_max);
    }
}

/// λ₁ and λ₂ scale the standing and the breaking part of p₁, λ₃ the uplift.
#[test]
fn the_factors_scale_their_parts() {
    let (sea, heights, section) = example();
    let with = |lambda| goda(&sea, &heights, &section, &Choices { lambda, ..Choices::default() }).unwrap();
    let plain = with([1.0; 3]);
    let standing = with([1.0, 0.0, 1.0]);
    assert!((with([1.0, 2.0, 1.0]).p1 - (2.0 * plain.p1 - standing.p1)).abs() < 1e-9 * plain.p1);
    assert!((with([0.5, 0.0, 1.0]).p1 - 0.5 * standing.p1).abs() < 1e-9 * plain.p1);
    assert!((with([1.0, 1.0, 0.25]).uplift - 0.25 * plain.uplift).abs() < 1e-9 * plain.uplift);
    assert!((with([0.5, 1.0, 1.0]).eta_star - 0.5 * plain.eta_star).abs() < 1e-12);
    // Without a standing pressure the breaking one is left, up to still water; without any there is nothing.
    let breaking = with([0.0, 1.0, 1.0]);
    assert!((breaking.p1 - (plain.p1 - standing.p1)).abs() < 1e-9 * plain.p1);
    assert_eq!((breaking.eta_star, breaking.h_c_star, breaking.p4), (0.0, 0.0, 0.0));
    let none = with([0.0; 3]);
    assert_eq!((none.force, none.force_moment, none.uplift), (0.0, 0.0, 0.0));
}

/// A sealed base is pressed by no wave; all else stays.
#[test]
fn a_base_may_be_without_uplift() {
    let (sea, heights, section) = example();
    let with = |uplift| goda(&sea, &heights, &section, &Choices { uplift, ..Choices::default() }).unwrap();
    let (open, sealed) = (with(true), with(false));
    assert!(open.uplift > 0.0 && sealed.pu == 0.0 && sealed.uplift == 0.0 && sealed.uplift_moment == 0.0);
    assert_eq!((sealed.force, sealed.force_moment), (open.force, open.force_moment));
}

/// A base so deep that α₃ < 0 is neither sucked down nor pulled seaward.
#[test]
fn a_base_beyond_the_formula_has_no_suction() {
    let (sea, _, section) = example();
    let sea = Sea { period: 4.0, water_depth: 10.0, ..sea };
    let section = CaissonSection { base_depth: 20.0, ..section };
    let local = Heights::Local { significant: 2.0, maximum: 3.6 };
    let g = goda(&sea, &local, &section, &Choices::default()).unwrap();
    assert!(g.alpha_3 < 0.0);
    assert_eq!((g.p3, g.pu, g.uplift), (0.0, 0.0, 0.0));
    assert!(g.warnings.iter().any(|warning| matches!(warning, WaveWarning::NoPressureAtBase { .. })));
}

/// Numbers that the criteria of impulsive breaking are about.
#[derive(Clone, Copy)]
struct Front {
    berm_width_ratio: f64,
    berm_depth_ratio: f64,
    bed_slope: f64,
    steepness: f64,
    angle_deg: f64,
    turn_deg: f64,
    /// h_c/H_1/3.
    crest_ratio: f64,
}

impl Front {
    /// Numbers of the warning that a sea and a section with these numbers get; `None` without one.
    fn warned(self) -> Option<[f64; 4]> {
        let (period, water_depth, gravity) = (12.0, 10.0, 9.81);
        let sea = Sea {
            water_depth,
            sea_bottom_slope: self.bed_slope,
            period,
            angle_deg: self.angle_deg,
            water_density: 1030.0,
            gravity,
        };
        // H₀'/L₀ with L₀ = gT²/2π; the height at the wall is what shoals to it.
        let deep = self.steepness * gravity * period * period / std::f64::consts::TAU;
        let significant = deep * shoaling(period, water_depth, gravity);
        let section = CaissonSection {
            base_depth: 7.0,
            depth_above_berm: self.berm_depth_ratio * water_depth,
            crest_height: self.crest_ratio * significant,
            berm_width: self.berm_width_ratio * wavelength(period, water_depth, gravity),
            caisson_width: 15.0,
        };
        let heights = Heights::Local { significant, maximum: 1.8 * significant };
        let choices = Choices { turn_deg: self.turn_deg, ..Choices::default() };
        let warnings = goda(&sea, &heights, &section, &choices).unwrap().warnings;
        warnings.into_iter().find_map(|warning| match warning {
            WaveWarning::ImpulsiveBreaking { berm_width_ratio, berm_depth_ratio, bed_slope, steepness } => {
                Some([berm_width_ratio, berm_depth_ratio, bed_slope, steepness])
            }
            _ => None,
        })
    }
}

/// Impulsive breaking: β < 20°, h_c/H_1/3 > 0.3, and either B_M/L < 0.02, tanθ > 1/50, H₀'/L₀ < 0.03, or
/// 0.02 < B_M/L < 0.3 and d/h < 0.6. Each limit is met from either side, one at a time, a thousandth off.
#[test]
fn every_limit_of_impulsive_breaking_is_where_it_is() {
    let berm = Front {
        berm_width_ratio: 0.1,
        berm_depth_ratio: 0.5,
        bed_slope: 0.01,
        steepness: 0.04,
        angle_deg: 10.0,
        turn_deg: 0.0,
        crest_ratio: 1.0,
    };
    let bed =
        Front { berm_width_ratio: 0.01, berm_depth_ratio: 0.65, bed_slope: 0.05, steepness: 0.02, ..berm };
    let (below, above) = (0.999, 1.001);
    for (front, warns) in [
        (berm, true),
        (Front { berm_width_ratio: 0.02 * below, ..berm }, false),
        (Front { berm_width_ratio: 0.02, ..berm }, false),
        (Front { berm_width_ratio: 0.02 * above, ..berm }, true),
        (Front { berm_width_ratio: 0.3 * below, ..berm }, true),
        (Front { berm_width_ratio: 0.3, ..berm }, false),
        (Front { berm_width_ratio: 0.3 * above, ..berm }, false),
        (Front { berm_depth_ratio: 0.6 * below, ..berm }, true),
        (Front { berm_depth_ratio: 0.6, ..berm }, false),
        (bed, true),
        (Front { berm_width_ratio: 0.02 * below, ..bed }, true),
        (Front { berm_width_ratio: 0.02, ..bed }, false),
        (Front { berm_width_ratio: 0.02 * above, ..bed }, false),
        (Front { bed_slope: 0.02, ..bed }, false),
        (Front { bed_slope: 0.02 * above, ..bed }, true),
        (Front { steepness: 0.03 * below, ..bed }, true),
        (Front { steepness: 0.03, ..bed }, false),
        (Front { steepness: 0.03 * above, ..bed }, false),
    ] {
        let found = front.warned();
        let Front { berm_width_ratio, berm_depth_ratio, bed_slope, steepness, .. } = front;
        let numbers = [berm_width_ratio, berm_depth_ratio, bed_slope, steepness];
        assert_eq!(found.is_some(), warns, "{numbers:?}");
        for (found, expected) in found.into_iter().flatten().zip(numbers) {
            assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
        }
    }
    // T = 1 s and g = 50·2π m/s² make L₀ = 50 m, so that 1.5 m is as steep as 0.03 and no less.
    let gravity = 50.0 * std::f64::consts::TAU;
    let (sea, _, section) = example();
    let sea = Sea { water_depth: 9.0, sea_bottom_slope: 0.05, period: 1.0, gravity, angle_deg: 10.0, ..sea };
    let section = CaissonSection { berm_width: 0.0, depth_above_berm: 6.5, crest_height: 5.0, ..section };
    for (height, warns) in [(1.5 * below, true), (1.5, false), (1.5 * above, false)] {
        let g = goda(&sea, &Heights::DeepWater(height), &section, &Choices::default()).unwrap();
        let impulsive = |warning: &WaveWarning| matches!(warning, WaveWarning::ImpulsiveBreaking { .. });
        assert_eq!(g.warnings.iter().any(impulsive), warns, "{height}");
    }
    for front in [berm, bed] {
        for (angle_deg, turn_deg, warns) in [
            (0.0, 0.0, true),
            (20.0 * below, 0.0, true),
            (20.0, 0.0, false),
            (20.0 * above, 0.0, false),
            (34.9, 15.0, true), // turned to the normal first
            (35.0, 15.0, false),
        ] {
            assert_eq!(Front { angle_deg, turn_deg, ..front }.warned().is_some(), warns, "{angle_deg}°");
        }
        for (crest_ratio, warns) in [(0.3 * below, false), (0.3, false), (0.3 * above, true)] {
            assert_eq!(Front { crest_ratio, ..front }.warned().is_some(), warns, "{crest_ratio}");
        }
    }
}

/// The other warnings, on either side of their limits.
#[test]
fn every_other_warning_has_its_limit() {
    let (sea, _, section) = example();
    // A berm so low that no impulsive breaking is warned of.
    let section = CaissonSection { depth_above_berm: 6.5, ..section };
    let low = Heights::Local { significant: 1.0, maximum: 1.8 };
    let deep = Heights::DeepWater(1.0);
    let warnings = |sea: Sea, heights: Heights, section: CaissonSection| {
        goda(&sea, &heights, &section, &Choices::default()).unwrap().warnings
    };
    assert!(warnings(sea, low, section).is_empty());
    // h/L₀ = 0.2: T² = 2πh/(0.2 g). For waves given at the wall it does not matter.
    let at_ratio = |ratio: f64| Sea {
        period: (std::f64::consts::TAU * sea.water_depth / (ratio * sea.gravity)).sqrt(),
        ..sea
    };
    assert!(warnings(at_ratio(0.1999), deep, section).is_empty());
    assert!(matches!(
        warnings(at_ratio(0.2001), deep, section)[..],
        [WaveWarning::DeepWater { ratio }] if (ratio - 0.2001).abs() < 1e-12
    ));
    assert!(warnings(at_ratio(0.2001), low, section).is_empty());
    // At 0.2 itself waves do not break any more: T = 1 s and g = 50·2π m/s² make L₀ = 50 m, five times the depth.
    let limit = Sea { water_depth: 10.0, period: 1.0, gravity: 50.0 * std::f64::consts::TAU, ..sea };
    let at_limit = goda(&limit, &deep, &section, &Choices::default()).unwrap();
    assert!(!at_limit.heights.unwrap().may_break);
    assert!(at_limit.warnings.contains(&WaveWarning::DeepWater { ratio: 0.2 }));
    // Miche's limit, 0.142 L tanh(2πh/L).
    let length = wavelength(sea.period, sea.water_depth, sea.gravity);
    let limit = 0.142 * length * (std::f64::consts::TAU * sea.water_depth / length).tanh();
    let at_height = |maximum| warnings(sea, Heights::Local { significant: 1.0, maximum }, section);
    assert!(at_height(limit * 0.999).is_empty() && at_height(limit).is_empty());
    assert_eq!(at_height(limit * 1.001), [WaveWarning::HigherThanBreaking { height: limit * 1.001, limit }]);
    // α₃ = 0 at h' = h/(1 − 1/cosh(2πh/L)), below the bed.
    let h = sea.water_depth;
    let deepest = h / (1.0 - 1.0 / (std::f64::consts::TAU * h / length).cosh());
    for (base_depth, warns) in [(deepest * 0.999, false), (deepest * 1.001, true)] {
        let warnings = warnings(sea, low, CaissonSection { base_depth, ..section });
        let no_pressure = |warning: &WaveWarning| matches!(warning, WaveWarning::NoPressureAtBase { .. });
        assert_eq!(warnings.iter().any(no_pressure), warns, "{base_depth}");
    }
    // The bed and the berm: level is not below.
    assert!(warnings(sea, low, CaissonSection { base_depth: h, ..section }).is_empty());
    assert_eq!(
        warnings(sea, low, CaissonSection { base_depth: h * 1.001, ..section }),
        [WaveWarning::BaseBelowBed { base_depth: h * 1.001, water_depth: h }]
    );
    let level = CaissonSection { depth_above_berm: section.base_depth, ..section };
    assert!(warnings(sea, low, level).is_empty());
    let depth_above_berm = section.base_depth * 1.001;
    assert_eq!(
        warnings(sea, low, CaissonSection { depth_above_berm, ..section }),
        [WaveWarning::BermBelowBase { depth_above_berm, base_depth: section.base_depth }]
    );
    let at_period = |period| warnings(Sea { period, ..sea }, low, section);
    assert!(at_period(30.0).is_empty());
    assert_eq!(at_period(30.03), [WaveWarning::LongPeriod { period: 30.03 }]);
    let at_slope = |sea_bottom_slope| warnings(Sea { sea_bottom_slope, ..sea }, low, section);
    assert!(at_slope(0.1).is_empty());
    assert_eq!(at_slope(0.1001), [WaveWarning::SteepBed { bed_slope: 0.1001 }]);
}

/// A warning's name for programs is that of its variant.
#[test]
fn a_warning_has_its_name() {
    for warning in [
        WaveWarning::ImpulsiveBreaking {
            berm_width_ratio: 0.1,
            berm_depth_ratio: 0.5,
            bed_slope: 0.01,
            steepness: 0.02,
        },
        WaveWarning::DeepWater { ratio: 0.3 },
        WaveWarning::HigherThanBreaking { height: 9.0, limit: 8.0 },
        WaveWarning::NoPressureAtBase { alpha_3: -0.1 },
        WaveWarning::BaseBelowBed { base_depth: 9.0, water_depth: 8.0 },
        WaveWarning::BermBelowBase { depth_above_berm: 9.0, base_depth: 8.0 },
        WaveWarning::LongPeriod { period: 40.0 },
        WaveWarning::SteepBed { bed_slope: 0.2 },
    ] {
        let variant = format!("{warning:?}");
        let variant = variant.split(' ').next().unwrap();
        let camel: String =
            warning.name().split('-').map(|word| word[..1].to_uppercase() + &word[1..]).collect();
        assert_eq!(camel, variant);
    }
}

/// The steep bed's branch of the impulsive warning, for heights given either way.
#[test]
fn a_steep_bed_without_a_berm_warns() {
    let (sea, _, section) = example();
    let sea = Sea { period: 12.0, water_depth: 10.0, sea_bottom_slope: 0.05, angle_deg: 0.0, ..sea };
    let section = CaissonSection { berm_width: 0.0, depth_above_berm: 6.5, ..section };
    for heights in [Heights::DeepWater(3.0), Heights::Local { significant: 2.0, maximum: 3.6 }] {
        let g = goda(&sea, &heights, &section, &Choices::default()).unwrap();
        let WaveWarning::ImpulsiveBreaking { bed_slope, steepness, .. } = g.warnings[0] else { panic!() };
        assert!(bed_slope == 0.05 && steepness < 0.03);
    }
}

/// Every number of a sea, its heights, a section and the choices is checked, and named where it makes no sense.
#[test]
fn every_number_is_checked() {
    let (sea, heights, section) = example();
    let default = Choices::default();
    let refused = |sea: Sea, heights: Heights, section: CaissonSection, choices: Choices| {
        goda(&sea, &heights, &section, &choices).unwrap_err().quantity
    };
    let nan = f64::NAN;
    for (sea, quantity) in [
        (Sea { water_depth: 0.0, ..sea }, Quantity::WaterDepth),
        (Sea { sea_bottom_slope: -0.01, ..sea }, Quantity::SeaBottomSlope),
        (Sea { period: 0.0, ..sea }, Quantity::WavePeriod),
        (Sea { angle_deg: -1.0, ..sea }, Quantity::WaveAngle),
        (Sea { angle_deg: 90.1, ..sea }, Quantity::WaveAngle),
        (Sea { water_density: nan, ..sea }, Quantity::WaterDensity),
        (Sea { gravity: 0.0, ..sea }, Quantity::Gravity),
    ] {
        assert_eq!(refused(sea, heights, section, default), quantity);
    }
    let local = |significant, maximum| Heights::Local { significant, maximum };
    for (heights, quantity) in [
        (Heights::DeepWater(0.0), Quantity::DeepWaterHeight),
        (local(0.0, 1.0), Quantity::SignificantHeight),
        (local(1.0, nan), Quantity::MaximumHeight),
        (local(1.0, 0.99), Quantity::MaximumHeight),
    ] {
        assert_eq!(refused(sea, heights, section, default), quantity);
    }
    for (section, quantity) in [
        (CaissonSection { base_depth: 0.0, ..section }, Quantity::BaseDepth),
        (CaissonSection { depth_above_berm: 0.0, ..section }, Quantity::BermDepth),
        (CaissonSection { depth_above_berm: sea.water_depth * 1.001, ..section }, Quantity::BermDepth),
        (CaissonSection { crest_height: 0.0, ..section }, Quantity::CrestHeight),
        (CaissonSection { crest_height: nan, ..section }, Quantity::CrestHeight),
        (CaissonSection { berm_width: -0.1, ..section }, Quantity::BermWidth),
        (CaissonSection { caisson_width: 0.0, ..section }, Quantity::CaissonWidth),
    ] {
        assert_eq!(refused(sea, heights, section, default), quantity);
    }
    for (lambda, quantity) in [
        ([-1.0, 1.0, 1.0], Quantity::Lambda1),
        ([1.0, -1.0, 1.0], Quantity::Lambda2),
        ([1.0, 1.0, nan], Quantity::Lambda3),
    ] {
        assert_eq!(refused(sea, heights, section, Choices { lambda, ..default }), quantity);
    }
    for turn_deg in [-0.1, 15.1] {
        assert_eq!(refused(sea, heights, section, Choices { turn_deg, ..default }), Quantity::WaveTurn);
    }
    // At the ends of the ranges all is well.
    let level = CaissonSection { depth_above_berm: sea.water_depth, berm_width: 0.0, ..section };
    let flat = Sea { sea_bottom_slope: 0.0, angle_deg: 90.0, ..sea };
    let choices = Choices { lambda: [1.0, 0.0, 0.0], turn_deg: 15.0, ..default };
    assert!(goda(&flat, &local(2.0, 2.0), &level, &choices).is_ok());
}

/// The terms that a design height was computed from give it again: min{β₀H₀' + β₁h, β_max H₀', K_s H₀'}, or by shoaling alone
/// where the water is not shallow.
#[test]
fn a_design_height_follows_from_its_terms() {
    let (sea, _, section) = example();
    for (period, deep) in [(12.0, 2.0), (12.0, 6.0), (12.0, 12.0), (5.0, 2.0), (5.6, 2.0), (5.7, 2.0)] {
        let sea = Sea { period, ..sea };
        let goda = goda(&sea, &Heights::DeepWater(deep), &section, &Choices::default()).unwrap();
        let heights = goda.heights.unwrap();
        let h = sea.water_depth;
        assert_eq!(heights.may_break, h / goda.deep_water_wavelength < 0.2, "{period}");
        assert_eq!(heights.shoaling, shoaling(period, h, sea.gravity));
        assert!(
            (heights.breaking_depth - (h + 5.0 * heights.significant * sea.sea_bottom_slope)).abs() < 1e-12
        );
        let limited = |terms: BreakingTerms, depth: f64, shoaled: f64| {
            let breaking = (terms.beta_0 * deep + terms.beta_1 * depth).min(terms.beta_max * deep);
            if heights.may_break { breaking.min(shoaled) } else { shoaled }
        };
        let shoaled = heights.shoaling * deep;
        let significant = limited(heights.significant_terms, h, shoaled);
        let maximum = limited(heights.maximum_terms, heights.breaking_depth, 1.8 * shoaled);
        assert!((heights.significant - significant).abs() < 1e-12, "{period} {deep}");
        assert!((heights.maximum - maximum).abs() < 1e-12, "{period} {deep}");
        assert_eq!(
            (goda.h_13, goda.h_max, goda.h_b),
            (heights.significant, heights.maximum, heights.breaking_depth)
        );
    }
}
