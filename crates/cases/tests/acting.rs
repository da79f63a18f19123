//! Loads that act: pressures along faces, forces at points, combinations, both directions of an earthquake; held against
//! Goda's diagram, sums by hand and mirror images.

use standfast::{Departure, Mode, Verdict, Wrench};
use standfast_cases::results::{ResultName, ResultValue};
use standfast_cases::{
    Acting, Assessed, Assessment, AssessmentView, CaseFile, Document, Interface, check_up_to,
};

fn assess(text: &str) -> Assessment {
    let case = CaseFile::parse("case.toml", text).and_then(|file| file.case());
    Assessment::of(&case.unwrap_or_else(|error| panic!("{error}: {text}"))).unwrap()
}

fn number(assessed: &Assessed, result: ResultName) -> f64 {
    match result.of(assessed) {
        ResultValue::Number(number) => number,
        other => panic!("{} is {other:?}", result.name()),
    }
}

fn close(one: f64, two: f64) -> bool {
    one == two || (one - two).abs() <= 1e-12 * one.abs().max(two.abs()).max(1.0)
}

fn same(one: &Wrench, two: &Wrench) -> bool {
    // In N and N·m of loads of MN: what rounding leaves of sums.
    let near = |one: f64, two: f64| (one - two).abs() < 1e-6;
    near(one.x, two.x) && near(one.p, two.p) && near(one.m, two.m)
}

const CAISSON: &str =
    "[body]\nwidth = 15\nheight = 10.5\nmass = 346050\nfriction = 0.6\nbuoyant_weight = 2318640\n";

/// Goda's pressures typed in as a table are Goda's answer.
#[test]
fn a_table_of_goda_s_pressures_is_goda_s_answer() {
    for (extra, uplift) in [("", true), ("uplift = false\n", false), ("lambda = [1, 0.5, 0.7]\n", true)] {
        let wave = format!(
            "{CAISSON}[wave]\ndeep_water_height = 6.3\nperiod = 11.4\nsea_bottom_slope = 0.01\nwater_depth = 10.1\n\
             depth_above_berm = 5.6\nbase_depth = 7.1\ncrest_height = 3.4\nberm_width = 8\nangle_deg = 15\n\
             water_density = 1030\n{extra}"
        );
        let by_goda = assess(&wave);
        let goda = &by_goda.case.goda().unwrap().goda;
        let (p1, p3, p4, pu, top) = (goda.p1, goda.p3, goda.p4, goda.pu, 7.1 + goda.h_c_star);
        assert_eq!(pu > 0.0, uplift);
        let table = format!(
            "{CAISSON}[[pressure]]\nface = \"right\"\nelevation = [0, 7.1, {top:?}]\npressure = [{p3:?}, {p1:?}, {p4:?}]\n\
             [[pressure]]\nface = \"base\"\ndistance = [0, 15]\npressure = [0, {pu:?}]\n"
        );
        let by_table = assess(&table);
        let (one, two) = (&by_goda.all[0], &by_table.all[0]);
        assert!(same(&one.outcome.full.wrench, &two.outcome.full.wrench));
        assert_eq!(one.outcome.full.mode(), two.outcome.full.mode());
        for result in [
            ResultName::SfSliding,
            ResultName::SfOverturningNet,
            ResultName::LoadFactor,
            ResultName::HeelPressure,
            ResultName::ToePressure,
            ResultName::P,
            ResultName::Mp,
            ResultName::U,
            ResultName::Mu,
            ResultName::Eccentricity,
        ] {
            let (one, two) = (number(one, result), number(two, result));
            assert!((one - two).abs() <= 1e-9 * one.abs(), "{}: {one}, {two}", result.name());
        }
    }
}

/// Still water under and beside a body, and over its crest, as pressures: the weight of the water displaced is lifted, whatever
/// the depth.
#[test]
fn a_body_under_water_is_lifted_by_what_it_displaces() {
    let (unit_weight, width, height) = (1025.0 * 9.81, 15.0, 10.5);
    for above in [0.0, 3.0] {
        let (top, base) = (unit_weight * above, unit_weight * (above + height));
        let text = format!(
            "[body]\nwidth = {width}\nheight = {height}\nmass = 346050\nfriction = 0.6\nbase_left = 7\nbase_right = 7.5\n\
             [[pressure]]\nface = \"left\"\nelevation = [0, 10.5]\npressure = [{base}, {top}]\npermanent = true\n\
             [[pressure]]\nface = \"right\"\nelevation = [0, 10.5]\npressure = [{base}, {top}]\npermanent = true\n\
             [[pressure]]\nface = \"top\"\ndistance = [-0.5, 14.5]\npressure = [{top}, {top}]\npermanent = true\n\
             [[pressure]]\nface = \"base\"\ndistance = [0, 14.5]\npressure = [{base}, {base}]\npermanent = true\n"
        );
        let wrench = assess(&text).all[0].outcome.full.wrench;
        // The base is half a metre narrower than the top.
        let lift = unit_weight * (width * height) - base * 0.5;
        let expected = Wrench { x: 0.0, p: 346050.0 * 9.81 - lift, m: base * 14.5 * 0.25 };
        assert!(same(&wrench, &expected), "{wrench:?} {expected:?}");
    }
}

const QUAY: &str = "[body]\nwidth = 8\nheight = 10\nmass = 180e3\nfriction = 0.6\ncentroid_offset = 0.4\n\
    [water]\nleft = 6\nright = 7\ndensity = 1025\n\
    [[pressure]]\nname = \"soil\"\nface = \"right\"\nelevation = [0, 9]\npressure = [40e3, 0]\npermanent = true\n\
    [[pressure]]\nname = \"surcharge\"\nface = \"right\"\nelevation = [0, 10]\npressure = [5e3, 5e3]\nscale = 1.2\n\
    [[load]]\nname = \"bollard\"\nforce = 30e3\nelevation = 10\ntogether = true\n\
    [[load]]\nname = \"crane\"\nforce = 100e3\ndirection = \"down\"\ndistance = 1.5\ntogether = true\n\
    [[load]]\nname = \"barrier\"\nforce = 4e3\ndirection = \"up\"\ndistance = 7\npermanent = true\n";

/// The loads of the quay one by one, by hand: x to the right, p downwards, m about C, which lies at (4.4, 5) from O.
fn quay() -> [(&'static str, bool, Wrench); 6] {
    let unit_weight = 1025.0 * 9.81;
    let (left, right) = (unit_weight * 6.0, unit_weight * 7.0);
    let wrench = |x: f64, p: f64, m: f64| Wrench { x, p, m };
    let water = wrench(
        unit_weight * (36.0 - 49.0) / 2.0,
        -(left + right) / 2.0 * 8.0,
        // The sides about C; the base's trapezoid at its centroid.
        -unit_weight * 18.0 * (2.0 - 5.0)
            + unit_weight * 24.5 * (7.0 / 3.0 - 5.0)
            + (left + right) / 2.0 * 8.0 * ((left + 2.0 * right) / (3.0 * (left + right)) * 8.0 - 4.4),
    );
    [
        ("weight", true, wrench(0.0, 180e3 * 9.81, 0.0)),
        ("water", true, water),
        ("soil", true, wrench(-180e3, 0.0, 180e3 * (3.0 - 5.0))),
        ("surcharge", false, wrench(-60e3, 0.0, 0.0)),
        ("bollard", false, wrench(-30e3, 0.0, 30e3 * 5.0)),
        ("crane", false, wrench(0.0, 100e3, 100e3 * (4.4 - 1.5))),
    ]
}

const BARRIER: Wrench = Wrench { x: 0.0, p: -4e3, m: 4e3 * (7.0 - 4.4) };

/// Without combinations all that acts together does; the sums are those by hand.
#[test]
fn loads_act_together() {
    let assessment = assess(QUAY);
    assert_eq!(assessment.all.len(), 1);
    assert_eq!(assessment.all[0].acting, Acting::All);
    let sum = quay().iter().fold(BARRIER, |sum, (_, _, wrench)| sum + *wrench);
    assert!(same(&assessment.all[0].outcome.full.wrench, &sum));
}

/// A combination is the sum of its loads times its factors: permanent ones it does not name act as they are, variable ones not.
#[test]
fn combinations_are_sums_by_hand() {
    let combinations: [&[(&str, f64)]; 5] = [
        &[("surcharge", 1.0), ("bollard", 1.0), ("crane", 1.0)],
        &[("weight", 0.9), ("soil", 1.35), ("surcharge", 1.5)],
        &[("crane", 1.5), ("water", 1.1)],
        &[("barrier", 0.0), ("bollard", 1.5)],
        &[("weight", 1.0)],
    ];
    let mut text = QUAY.to_owned();
    for factors in combinations {
        let factors: Vec<_> = factors.iter().map(|(name, factor)| format!("{name} = {factor:?}")).collect();
        text += &format!("[[combination]]\nfactors = {{ {} }}\n", factors.join(", "));
    }
    let assessment = assess(&text);
    assert_eq!(assessment.all.len(), combinations.len());
    for (assessed, factors) in assessment.all.iter().zip(combinations) {
        let factor = |name: &str, permanent: bool| {
            let named = factors.iter().find(|(named, _)| *named == name);
            named.map_or(if permanent { 1.0 } else { 0.0 }, |(_, factor)| *factor)
        };
        let loads = quay().into_iter().chain([("barrier", true, BARRIER)]);
        let parts: Vec<_> =
            loads.map(|(name, permanent, wrench)| (permanent, wrench * factor(name, permanent))).collect();
        let sum = |which: Option<bool>| {
            let chosen = parts.iter().filter(|(permanent, _)| which.is_none_or(|which| which == *permanent));
            chosen.fold(Wrench::ZERO, |sum, (_, wrench)| sum + *wrench)
        };
        assert!(same(&assessed.outcome.full.wrench, &sum(None)), "{factors:?}");
        // The load factor raises what is variable, factored, on top of what is permanent, factored.
        let twice = assessed.situation.wrench_at(2.0, standfast::loads::Pose::UPRIGHT);
        assert!(same(&twice, &(sum(Some(true)) + sum(Some(false)) * 2.0)), "{factors:?}");
    }
    let worst = assessment.worst_first();
    let factors: Vec<_> = worst.iter().map(|assessed| assessed.departure().load_factor()).collect();
    assert!(factors.is_sorted(), "{factors:?}");
    assert_eq!(assessment.governing().index, worst[0].index);
}

/// Forces that act alone are alternatives; what is permanent or together acts beside each.
#[test]
fn forces_act_alone_or_together() {
    let text = "[body]\nwidth = 8\nheight = 10\nmass = 180e3\nfriction = 0.6\n\
        [[load]]\nforce = 100e3\nelevation = 5\n[[load]]\nforce = 200e3\nelevation = 5\ndirection = \"right\"\n\
        [[load]]\nforce = 10e3\nelevation = 5\ntogether = true\n\
        [[load]]\nforce = 7e3\nelevation = 5\npermanent = true\ndirection = \"right\"\n";
    let assessment = assess(text);
    let x: Vec<_> = assessment.all.iter().map(|assessed| assessed.outcome.full.wrench.x).collect();
    assert_eq!(x, [-100e3 - 10e3 + 7e3, 200e3 - 10e3 + 7e3]);
    assert_eq!(
        assessment.all.iter().map(|assessed| assessed.acting).collect::<Vec<_>>(),
        [Acting::Alone(0), Acting::Alone(1)]
    );
    // The permanent one does not rise.
    let doubled = assessment.all[0].situation.wrench_at(2.0, standfast::loads::Pose::UPRIGHT);
    assert_eq!(doubled.x, -220e3 + 7e3);
}

const STATUE: &str = "[body]\nwidth = 0.9\nheight = 3.2\nmass = 7400\nfriction = 0.6\n";

/// A statue off its middle falls more easily one way: that way is reported, and equals the mirrored statue shaken the other way.
#[test]
fn an_earthquake_is_tried_both_ways() {
    let shaken = |offset: f64, horizontal: f64, vertical: f64, fixed: &str| {
        assess(&format!(
            "{STATUE}centroid_offset = {offset}\n[earthquake]\nhorizontal = \"{horizontal} g\"\nvertical = \"{vertical} g\"\n{fixed}"
        ))
    };
    let fixed = "horizontal_fixed = true\nvertical_fixed = true\n";
    for vertical in [0.0, 0.1, -0.1] {
        let free = shaken(0.03, 0.35, vertical, "");
        let [found] = free.all.as_slice() else { panic!() };
        let tried = if vertical == 0.0 { 2 } else { 4 };
        assert_eq!(found.others.len() + 1, tried);
        // Each by itself, with its signs fixed.
        let mut each = Vec::new();
        for side in [1.0, -1.0] {
            for way in [1.0, -1.0].into_iter().take(tried / 2) {
                let alone = shaken(0.03, 0.35 * side, vertical * way, fixed);
                assert!(alone.all[0].others.is_empty());
                let mirrored = shaken(-0.03, -0.35 * side, vertical * way, fixed);
                assert!(close(
                    alone.all[0].departure().load_factor(),
                    mirrored.all[0].departure().load_factor()
                ));
                let earthquake = alone.all[0].earthquake.unwrap();
                let same = found.tried().find(|tried| tried.earthquake == Some(earthquake)).unwrap();
                let same = &same.outcome;
                assert_eq!(same, &alone.all[0].outcome);
                each.push(alone.all[0].departure().load_factor());
            }
        }
        let least = each.iter().copied().fold(f64::INFINITY, f64::min);
        assert_eq!(found.departure().load_factor(), least);
        // Off the middle to the right, it falls to the right: the base moves left.
        assert!(found.earthquake.unwrap().horizontal() < 0.0);
        let mode = found.departure().verdict().and_then(Verdict::mode);
        assert_eq!(mode.and_then(Mode::corner), Some(standfast::Corner::OPrime));
    }
    // In the middle both directions are the same: the one given is reported.
    for horizontal in [0.35, -0.35] {
        let same = shaken(0.0, horizontal, 0.0, "");
        assert_eq!(same.all[0].earthquake.unwrap().horizontal(), horizontal * 9.81);
        assert_eq!(same.all[0].others.len(), 1);
    }
}

/// Off the middle by a hair the body falls that way at a load factor that is less by as little, b/(h k) with b half the width less the hair:
/// it is reported unless rounding could be the reason.
#[test]
fn the_worse_of_two_shakings_is_told_by_any_difference_beyond_rounding() {
    for (offset, other_side) in [(1e-4, true), (1e-6, true), (1e-8, true), (1e-12, false), (0.0, false)] {
        for side in [1.0, -1.0] {
            let text = format!(
                "{STATUE}centroid_offset = {:?}\n[earthquake]\nhorizontal = \"{:?} g\"\n",
                offset * side,
                0.35 * side
            );
            let found = assess(&text);
            // As given it falls to the side with the longer arm.
            let reported = found.all[0].earthquake.unwrap().horizontal() / (0.35 * 9.81);
            let expected = if other_side { -side } else { side };
            assert!(close(reported, expected), "{offset} {side}: {reported}");
            let least = (0.45 - offset) / (1.6 * 0.35);
            let factor = found.all[0].departure().load_factor();
            assert!((factor / least - 1.0).abs() < 1e-11, "{offset} {side}: {factor} {least}");
        }
    }
}

fn checks(criteria: &str) -> Vec<(&'static str, Option<f64>, bool)> {
    let text = format!("{CAISSON}[[load]]\nforce = 1e6\nelevation = 6\n[criteria]\n{criteria}");
    let assessment = assess(&text);
    let checks: Vec<_> = assessment.checks().iter().map(|check| check.check).collect();
    assert_eq!(assessment.met(), Some(checks.iter().all(|check| check.met)));
    checks.iter().map(|check| (check.criterion.name(), check.utilisation, check.met)).collect()
}

/// Utilisations by hand: a force of 1 MN/m at 6 m against 2318.64 kN/m at 7.5 m, μ = 0.6.
#[test]
fn criteria_use_their_share() {
    let (weight, base) = (2318640.0, 15.0);
    let arm = (weight * 7.5 - 6e6) / weight;
    let pressed = 2.0 * weight / (3.0 * arm);
    assert!(arm < base / 3.0);
    let sliding = 0.6 * weight / 1e6;
    for (line, used) in [
        ("SF_sliding = 1.2\n", 1.2 / sliding),
        ("SF_sliding = 1.5\n", 1.5 / sliding),
        ("SF_overturning_net = 1.2\n", 1.2 / (weight * 7.5 / 6e6)),
        ("bearing_max = \"300 kPa\"\n", pressed / 300e3),
        ("contact_share = 0.667\n", 0.667 / (3.0 * arm / base)),
        ("eccentricity = 2.5\n", (7.5 - arm) / 2.5),
        ("load_factor = 1.1\n", 1.1 / sliding),
    ] {
        let [(_, utilisation, met)] = checks(line)[..] else { panic!() };
        let utilisation = utilisation.unwrap();
        assert!((utilisation - used).abs() < 1e-12 * used, "{line}: {utilisation}, {used}");
        assert_eq!(met, used <= 1.0, "{line}");
    }
    assert_eq!(checks("modes_not = [\"RO\", \"SL\"]\n"), [("modes_not", None, true)]);
    assert_eq!(checks("modes_not = [\"RE\"]\n"), [("modes_not", None, false)]);
    // The governing one first; modes that are not allowed before all.
    // A base that is asked to be pressed throughout, and is, hides nothing that is nearer its bound; asked for a part of it, it is in its place.
    let pressed = |criteria: &str| {
        assess(&format!("{CAISSON}[[load]]\nforce = 3e5\nelevation = 2\n[criteria]\n{criteria}"))
    };
    let first = |criteria: &str| pressed(criteria).checks()[0].check.criterion.name();
    assert_eq!(first("contact_share = 1\nbearing_max = 1e9\n"), "bearing_max");
    assert_eq!(first("contact_share = 0.9\nbearing_max = 1e9\n"), "contact_share");
    let all =
        checks("SF_sliding = 1.2\nSF_overturning_net = 1.2\nbearing_max = 300e3\nmodes_not = [\"RE\"]\n");
    let names: Vec<_> = all.iter().map(|(name, ..)| *name).collect();
    assert_eq!(names, ["modes_not", "bearing_max", "SF_sliding", "SF_overturning_net"]);
}

/// A bound that is exactly reached is met, and the next number is not.
#[test]
fn a_bound_that_is_reached_is_met() {
    let text = |bound: f64| {
        "[body]\nwidth = 4\nheight = 4\nmass = 1e3\nfriction = 0.5\n".to_owned()
            + &format!(
                "[[load]]\nforce = {:?}\nelevation = 1\n[criteria]\nSF_sliding = {bound:?}\n",
                1e3 * 9.81 / 4.0
            )
    };
    let assessment = assess(&text(2.0));
    let ResultValue::Number(factor) = ResultName::SfSliding.of(&assessment.all[0]) else { panic!() };
    assert!(assess(&text(factor)).met() == Some(true));
    assert!(assess(&text(factor.next_up())).met() == Some(false));
}

/// Missing values meet no bound; a body that never leaves rest meets any load factor.
#[test]
fn criteria_of_bodies_that_do_not_rest() {
    let criteria = "[criteria]\nSF_sliding = 0.1\nSF_overturning_net = 0.1\nbearing_max = 1e9\ncontact_share = 0.01\nload_factor = 0.1\n";
    let lifted = format!("{STATUE}[uplift]\nleft = 900e3\nright = 900e3\n{criteria}");
    let lifted = assess(&lifted);
    assert!(
        lifted
            .checks()
            .iter()
            .all(|check| !check.check.met && check.check.utilisation == Some(f64::INFINITY))
    );
    let still = assess(&format!("{STATUE}[uplift]\nleft = 1\nright = 1\ngrows = false\n{criteria}"));
    assert!(matches!(still.all[0].departure(), Departure::Never));
    assert_eq!(still.met(), Some(true));
    // A body that stands on its base by nothing but its weight is pushed by nothing.
    let checks = still.checks();
    let sliding = checks.iter().find(|check| check.check.criterion.name() == "SF_sliding").unwrap();
    assert_eq!((sliding.check.utilisation, sliding.check.met), (Some(0.0), true));
    // Consistent beside the mode reported counts as well.
    let many =
        "[body]\nwidth = 2\nheight = 2\nmass = 1e3\nfriction = 3\n[[load]]\nforce = 40e3\nelevation = 0.5\n";
    let modes = assess(many).all[0].outcome.full.modes;
    assert!(modes.len() > 1);
    for mode in modes.iter() {
        let text = format!("{many}[criteria]\nmodes_not = [\"{mode}\"]\n");
        assert_eq!(assess(&text).met(), Some(false), "{mode}");
    }
    assert_eq!(assess(&format!("{many}[criteria]\nmodes_not = [\"SL+\"]\n")).met(), Some(true));
}

/// Distances are to the right of O, wherever mid-width is.
#[test]
fn a_force_acts_where_it_says() {
    let text = "[body]\nwidth = 8\nheight = 10\nmass = 180e3\nfriction = 0.6\nbase_left = 3\nbase_right = 3.5\n\
        [[load]]\nforce = 10e3\ndirection = \"down\"\ndistance = 0\ntogether = true\n";
    let wrench = assess(text).all[0].outcome.full.wrench;
    // O is 3 m left of C.
    assert!(same(&wrench, &Wrench { x: 0.0, p: 180e3 * 9.81 + 10e3, m: 30e3 }));
}

/// Criteria decide the worst situation: without them the push, which leaves rest first, and with a bearing pressure the weight
/// that is put on an edge.
#[test]
fn criteria_decide_what_is_worst() {
    let loads = format!(
        "{CAISSON}[[load]]\nforce = 1e6\nelevation = 5\n[[load]]\nforce = 2e6\ndirection = \"down\"\ndistance = 1\n"
    );
    let without = assess(&loads);
    assert_eq!(without.worst_first().iter().map(|assessed| assessed.index).collect::<Vec<_>>(), [0, 1]);
    let with = assess(&format!("{loads}[criteria]\nbearing_max = \"300 kPa\"\n"));
    assert_eq!(with.worst_first().iter().map(|assessed| assessed.index).collect::<Vec<_>>(), [1, 0]);
    assert_eq!((with.governing().index, with.checks()[0].assessed.index), (1, 1));
}

fn names(text: &str) -> Vec<&'static str> {
    assess(text).case.warnings().iter().map(standfast_cases::Warning::name).collect()
}

/// Warnings of forces that miss the body and of pressures in the wrong unit, each side of their limits.
#[test]
fn slips_of_forces_and_criteria_are_named() {
    let down = |distance: f64, more: &str| {
        format!("{STATUE}[[load]]\nforce = 1e3\ndirection = \"down\"\ndistance = {distance}\n{more}")
    };
    assert_eq!(names(&down(0.9, "")), [""; 0]);
    assert_eq!(names(&down(0.901, "")), ["load-beside-body"]);
    assert_eq!(names(&down(-0.001, "")), ["load-beside-body"]);
    assert_eq!(names(&down(0.5, "[criteria]\nbearing_max = 20e3\n")), [""; 0]);
    assert_eq!(names(&down(0.5, "[criteria]\nbearing_max = 19.9e3\n")), ["small-bearing"]);
}

/// A variable load that no combination names acts nowhere, which is said.
#[test]
fn loads_in_no_combination_are_named() {
    let text = |factors: &str| {
        format!(
            "{QUAY}[earthquake]\nhorizontal = \"0.01 g\"\n[added_mass]\nsides = \"right\"\n[[combination]]\nfactors = {{ {factors} }}\n"
        )
    };
    let all = "surcharge = 1, bollard = 1, crane = 1, earthquake = 1";
    assert_eq!(names(&text(all)), [""; 0]);
    // The weight, the water, the soil and the barrier are permanent.
    assert_eq!(names(&text("surcharge = 1, crane = 1, bollard = 0")), ["load-in-no-combination"; 2]);
    let both =
        text("surcharge = 1, bollard = 1") + "[[combination]]\nfactors = { crane = 1, earthquake = 0.3 }\n";
    assert_eq!(names(&both), [""; 0]);
}

/// A combination without the earthquake is not shaken, and says so; one with it times a factor keeps the acceleration given.
#[test]
fn only_a_combination_with_the_earthquake_is_shaken() {
    let text = format!(
        "{STATUE}[earthquake]\nhorizontal = \"0.2 g\"\nvertical = \"0.1 g\"\n[[load]]\nname = \"wind\"\nforce = 1e3\nelevation = 2\n\
         [[combination]]\nfactors = {{ wind = 1 }}\n[[combination]]\nfactors = {{ earthquake = 0 }}\n\
         [[combination]]\nfactors = {{ earthquake = 1.5 }}\n"
    );
    let assessment = assess(&text);
    let tried: Vec<_> = assessment.all.iter().map(|it| (it.earthquake.is_some(), it.others.len())).collect();
    assert_eq!(tried, [(false, 0), (false, 0), (true, 3)]);
    let shaken = &assessment.all[2];
    let wrench = shaken.outcome.full.wrench;
    assert!(
        close(wrench.x.abs(), 1.5 * 7400.0 * 0.2 * 9.81) && close(wrench.p, 7400.0 * 9.81 * (1.0 - 0.15)),
        "{wrench:?}"
    );
    let json = assessment.json(&standfast_cases::AssessmentView::default(), &[]);
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert!(json["situations"][0]["earthquake"].is_null());
    assert!(close(json["situations"][2]["earthquake"]["horizontal"].as_f64().unwrap().abs(), 0.2 * 9.81));
}

/// Vertical loads off the middle: nothing pushes, and no factor against overturning is made of it.
#[test]
fn eccentric_vertical_loads_have_no_factor_but_a_load_factor() {
    let text = |force: f64, criteria: &str| {
        format!(
            "[body]\nwidth = 6\nheight = 4\nmass = 40e3\nfriction = 0.5\n[[load]]\nforce = {force}\ndirection = \"down\"\n\
                 distance = -0.5\n[criteria]\n{criteria}"
        )
    };
    // The weight at 3 m against the load at half a metre outside: at 40 t/m · 3/0.5 it turns.
    let turns = 40e3 * 9.81 * 3.0 / 0.5;
    let before = assess(&text(0.99 * turns, "eccentricity = 10\nload_factor = 1.1\n"));
    let checks: Vec<_> =
        before.checks().iter().map(|check| (check.check.criterion.name(), check.check.met)).collect();
    assert_eq!(checks, [("load_factor", false), ("eccentricity", true)]);
    assert!(
        before
            .text(&standfast_cases::AssessmentView::default())
            .contains("No horizontal force turns the body")
    );
    let after = assess(&text(1.01 * turns, "eccentricity = 10\nSF_overturning_net = 0.1\n"));
    assert!(after.checks().iter().all(|check| !check.check.met), "the resultant misses the base");
}

/// `design` says what does not go with a body that is resized.
#[test]
fn what_stays_where_it_is_is_said() {
    let notes = |text: &str, name: &str| {
        let file = CaseFile::parse("case.toml", text).unwrap();
        let variable = standfast_cases::couple::Variable::find(name, file.inputs()).unwrap();
        variable.notes(file.inputs(), &file.case().unwrap()).join(" ")
    };
    assert!(notes(QUAY, "width").contains(standfast_cases::couple::STAYS));
    assert!(!notes(QUAY, "friction").contains(standfast_cases::couple::STAYS));
    assert!(
        !notes(&format!("{STATUE}[[load]]\nforce = 1\nelevation = 1\n"), "width")
            .contains(standfast_cases::couple::STAYS)
    );
    // What is asked of the results is not a number of the case.
    let criteria = format!("{QUAY}[criteria]\nSF_sliding = 1.2\n");
    let file = CaseFile::parse("case.toml", &criteria).unwrap();
    assert!(standfast_cases::couple::Variable::find("criteria.SF_sliding", file.inputs()).is_err());
}

/// Every criterion is checked under every acceleration of the base: upwards the base is pressed more, downwards it slides
/// sooner. `design` asks of all of them, too.
#[test]
fn criteria_are_checked_under_every_acceleration() {
    let text = "[body]\nwidth = 10\nheight = 10\nmass = 230e3\nfriction = 0.6\n[earthquake]\nhorizontal = \"0.2 g\"\nvertical = \"0.3 g\"\n\
        [criteria]\nbearing_max = 400e3\nSF_sliding = 2.2\n";
    let assessment = assess(text);
    // By hand: N = m g (1 ± 0.3), t_e = 5 − 0.2 · 5/(1 ± 0.3), the whole base pressed.
    let [up, down] = [1.3, 0.7].map(|share: f64| {
        let (pressing, arm) = (230e3 * 9.81 * share, 5.0 - 1.0 / share);
        (pressing / 10.0 * (4.0 - 0.6 * arm), 0.6 * share / 0.2)
    });
    let checks = assessment.checks();
    let found: Vec<_> =
        checks.iter().map(|check| (check.check.criterion.name(), check.check.utilisation.unwrap())).collect();
    let near = |name: &str, expected: f64| {
        found.iter().any(|(found, used)| *found == name && (used / expected - 1.0).abs() < 1e-12)
    };
    assert!(near("bearing_max", up.0 / 400e3) && near("SF_sliding", 2.2 / down.1), "{found:?}");
    assert!(checks.iter().all(|check| !check.check.met));
    assert_eq!(checks.iter().filter(|check| check.assessed.is_reported).count(), 1);
    // Whatever is asked beside, `design` finds the friction that is enough downwards.
    for criteria in ["", "[criteria]\nbearing_max = 400e3\n"] {
        let text = text.split("[criteria]").next().unwrap().to_owned() + criteria;
        let file = CaseFile::parse("case.toml", &text).unwrap();
        let request = standfast_cases::design::DesignRequest {
            vary: "friction".into(),
            target: "factor=2.4".parse().unwrap(),
            extreme: standfast_cases::design::Extreme::Least,
            from: None,
            to: None,
            spelling: &standfast_cases::design::Spelling::PROGRAM,
        };
        let design = standfast_cases::design::Design::of(&file, request, standfast_cases::Portion::UNSEEN)
            .unwrap()
            .json(&(), &[]);
        let design: serde_json::Value = serde_json::from_str(&design).unwrap();
        let found = design["found"]["boundary"].as_f64().unwrap();
        assert!((found / (2.4 * 0.2 / 0.7) - 1.0).abs() < 1e-6, "{found}");
    }
}

/// The text says how to see the situations that it leaves out, as its reader says it.
#[test]
fn options_are_spelt_as_by_the_face() {
    let loads: String =
        (1..=9).map(|i| format!("[[load]]\nforce = {}\nelevation = 5\n", 1e5 * f64::from(i))).collect();
    let many = assess(&format!("{CAISSON}{loads}"));
    for (interface, said) in
        [(Interface::Program, "; --all shows all."), (Interface::Python, "; all=True shows all.")]
    {
        let view = AssessmentView { interface, ..AssessmentView::default() };
        let words = many.text(&view).split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(words.contains(&format!("the 8 worst are shown one by one{said}")), "{words}");
        assert!(!many.text(&AssessmentView { all: true, ..view }).contains("shows all"));
    }
}

#[test]
fn a_load_is_followed_from_the_full_load_to_a_million_times() {
    assert_eq!([1.0, 2.0, 1e6].map(check_up_to), [Ok(1.0), Ok(2.0), Ok(1e6)]);
    for wrong in [0.5, 0.0, -1.0, 1_000_001.0, f64::INFINITY, f64::NAN] {
        let error = check_up_to(wrong).unwrap_err();
        assert_eq!(error.to_string(), "expected a load factor from 1 to 1000000, as 2");
    }
}

/// A share of one force, or of a shaking to the sides, stands beside what it amounts to; by hand.
#[test]
fn a_share_is_told_with_what_it_amounts_to() {
    let body = "[body]\nwidth = 1\nheight = 2\nmass = 1000\nfriction = 0.9\n";
    let near = |loads: &str| assess(&format!("{body}{loads}")).summary().unwrap().near.unwrap();
    // m g b/e = 9810 · 0.5/1.25 N.
    let push = "[[load]]\nforce = \"2 kN/m\"\nelevation = \"1.25 m\"\n";
    assert!(near(push).starts_with("At 196.2 % of the force (3.924 kN/m) it rocks"), "{}", near(push));
    // b/d = 0.5; water that moves along counts with the body.
    let shaken = "[earthquake]\nhorizontal = \"0.2 g\"\n";
    assert!(near(shaken).starts_with("At 250 % of the earthquake (0.5 g) it rocks"), "{}", near(shaken));
    let in_water = near("[earthquake]\nhorizontal = \"0.2 g\"\n[added_mass]\nmass = 250\nelevation = 1\n");
    assert!(in_water.contains("of the earthquake (0.4 g) it rocks"), "{in_water}");
    // Of two quantities neither is the amount.
    for two in [format!("{shaken}vertical = \"0.1 g\"\n"), format!("{push}together = true\n{shaken}")] {
        assert!(!near(&two).contains(" g)") && !near(&two).contains("kN/m)"), "{}", near(&two));
    }
}

/// A hook above the crest: M_O = F e, so that SF_overturning is W b/(F e) whatever carries the force; said once, with how far off it is.
#[test]
fn a_lever_stands_on_the_body() {
    let text = |more: &str| {
        format!(
            "[body]\nwidth = 4\nheight = 6\nmass = 50e3\nfriction = 0.6\n[[load]]\nforce = 60e3\nelevation = 7.2\n{more}"
        )
    };
    let refused = CaseFile::parse("case.toml", &text("")).unwrap().case().unwrap_err();
    assert!(standfast_cases::report(&refused).contains("lever = \"bollard hook\""));
    let of = |text: &str| {
        let answer = Assessment::owning(CaseFile::parse("case.toml", text).unwrap().case().unwrap()).unwrap();
        let warnings: Vec<String> = answer.case.warnings().iter().map(ToString::to_string).collect();
        (answer.governing().outcome.stability.overturning(), warnings)
    };
    let (factor, warnings) = of(&text("lever = \"hook\"\n"));
    assert!((factor - 50e3 * 9.81 * 2.0 / (60e3 * 7.2)).abs() < 1e-12, "{factor}");
    let said = "load[1].lever = \"hook\": the force acts 1.2 m above the crest, on what stands on the body; that has to carry it down to the body";
    assert_eq!(warnings, [said]);
    // Beside the body it replaces the warning that the force misses it.
    let beside =
        text("lever = \"hook\"\n").replace("elevation = 7.2", "direction = \"down\"\ndistance = 4.5");
    let (_, warnings) = of(&beside);
    assert!(warnings.len() == 1 && warnings[0].contains("0.5 m beside the body"), "{warnings:?}");
    // On the body it is a name and nothing else.
    let on = text("lever = \"hook\"\n").replace("7.2", "6");
    assert_eq!(of(&on), of(&on.replace("lever = \"hook\"\n", "")));
}
