//! The least cost of several quantities, against closed forms and against all points of a grid.

mod common;

use common::{assess, file, near};
use standfast_cases::design::{Cost, DesignError, Minimum, MinimumRequest, Spelling, Target};
use standfast_cases::{Assessment, CaseFile, Document, Explained, Portion};

fn found(file: &CaseFile, vary: &[&str], cost: Cost, ends: &[(&str, &str)]) -> Result<Minimum, DesignError> {
    let request = MinimumRequest {
        vary: vary.iter().map(|name| (*name).to_owned()).collect(),
        target: Target::Utilisation(1.0),
        cost,
        from: ends.iter().map(|(from, _)| (*from).to_owned()).collect(),
        to: ends.iter().map(|(_, to)| (*to).to_owned()).collect(),
        spelling: &Spelling::PROGRAM,
    };
    Minimum::of(file, request, Portion::UNSEEN)
}

fn meets(assessment: &Assessment) -> bool {
    assessment.met() == Some(true)
}

/// Sliding alone asks for a weight: the least area is s F/(μ ρ g), whatever the shape; the narrower the higher.
#[test]
fn sliding_alone_asks_for_a_weight() {
    let text = "[body]\nwidth = 12\nheight = 9\ndensity = 2300\nfriction = 0.55\n[[load]]\nforce = 600e3\nelevation = 4\n[criteria]\nSF_sliding = 1.3\n";
    let minimum = found(&file(text), &["width", "height"], Cost::Volume, &[]).unwrap();
    let least = 1.3 * 600e3 / (0.55 * 2300.0 * 9.81);
    // Four digits of each.
    near(minimum.found.cost, least, 2e-3 * least);
    assert!(minimum.found.cost >= least * (1.0 - 1e-12));
    let mass = found(&file(text), &["width", "height"], Cost::Mass, &[]).unwrap();
    near(mass.found.cost, 2300.0 * least, 2e-3 * 2300.0 * least);
}

/// A wall whose base, pressure and factors all bind somewhere.
fn wall(width: f64, height: f64) -> String {
    format!(
        "[body]\nwidth = {width}\nheight = {height}\ndensity = 2300\nfriction = 0.6\n[water]\nlevel = 7\ndensity = 1025\n[[load]]\n\
         force = 330e3\nelevation = 8.5\n[criteria]\nSF_sliding = 1.2\nSF_overturning_net = 1.5\nbearing_max = 330e3\ncontact_share = 0.8\n"
    )
}

#[test]
fn no_point_of_a_grid_costs_less() {
    let ends = [("6 m", "20 m"), ("9 m", "15 m")];
    let minimum = found(&file(&wall(14.0, 11.0)), &["width", "height"], Cost::Volume, &ends).unwrap();
    let [width, height] = [minimum.found.end.rounded, minimum.found.held[0]];
    near(minimum.found.cost, width * height, 1e-9);
    // Read again as it is printed.
    assert!(meets(&assess(&wall(width, height))));
    let mut least = f64::INFINITY;
    for i in 0..=140 {
        for j in 0..=60 {
            let (width, height) = (6.0 + 0.1 * f64::from(i), 9.0 + 0.1 * f64::from(j));
            if width * height < least && meets(&assess(&wall(width, height))) {
                least = width * height;
            }
        }
    }
    assert!(minimum.found.cost <= least * (1.0 + 1e-9), "{} {width} {height}, {least}", minimum.found.cost);
    assert!(minimum.found.cost > 0.98 * least, "{} {least}", minimum.found.cost);
    // None of the neighbours costs less, and just beyond it fails.
    assert!(!minimum.neighbours.is_empty());
    for neighbour in &minimum.neighbours {
        assert!(neighbour.first.as_ref().is_none_or(|(_, cost)| *cost >= minimum.found.cost));
    }
    let text = minimum.text(&());
    assert!(text.contains("Just beyond, with width at ") && text.contains("Neighbours"), "{text}");
}

/// A trapezoid of three dimensions.
fn trapezoid([width, top, height]: [f64; 3]) -> String {
    format!(
        "[body]\nfriction = 0.65\n[[part]]\nname = \"wall\"\nleft = 0\nwidth = {width}\nbottom = 0\nheight = {height}\ntop_left = 0\n\
         top_width = {top}\ndensity = 2400\n[[pressure]]\nname = \"water\"\nface = \"left\"\nelevation = [0, 6]\npressure = [60e3, 0]\n\
         permanent = true\n[[load]]\nname = \"ice\"\nforce = 20e3\ndirection = \"right\"\nelevation = 5.8\n[criteria]\nSF_sliding = 1.3\n\
         SF_overturning_net = 1.5\ncontact_share = 1\n"
    )
}

#[test]
fn three_dimensions_of_a_wall() {
    let ends = [("2 m", "8 m"), ("0.8 m", "4 m"), ("6 m", "9 m")];
    let names = ["part[1].width", "part[1].top_width", "part[1].height"];
    let minimum = found(&file(&trapezoid([5.0, 2.0, 7.0])), &names, Cost::Volume, &ends).unwrap();
    let [top, height] = [minimum.found.held[0], minimum.found.held[1]];
    let width = minimum.found.end.rounded;
    near(minimum.found.cost, (width + top) / 2.0 * height, 1e-9);
    assert!(meets(&assess(&trapezoid([width, top, height]))));
    let mut least = f64::INFINITY;
    let step = |[from, to]: [f64; 2], place: u32, count: u32| {
        from + (to - from) * f64::from(place) / f64::from(count)
    };
    for i in 0..=40 {
        for j in 0..=16 {
            for k in 0..=6 {
                let at = [step([2.0, 8.0], i, 40), step([0.8, 4.0], j, 16), step([6.0, 9.0], k, 6)];
                let cost = (at[0] + at[1]) / 2.0 * at[2];
                if cost < least && meets(&assess(&trapezoid(at))) {
                    least = cost;
                }
            }
        }
    }
    assert!(minimum.found.cost <= least * (1.0 + 1e-9), "{}, {least}", minimum.found.cost);
    assert!(minimum.found.cost > 0.95 * least, "{}, {least}", minimum.found.cost);
}

/// A cavity is no volume; a cylinder is π/4 of its square.
#[test]
fn volumes_are_those_of_what_is_there() {
    let hollow = format!(
        "{}[[part]]\nname = \"hole\"\nleft = 1\nwidth = 2\nbottom = 7\nheight = 1\ndensity = 0\n",
        trapezoid([5.0, 5.0, 7.0]).split("[[pressure]]").next().unwrap()
    );
    let hollow = format!("{hollow}[[load]]\nforce = 1e3\nelevation = 1\n");
    near(Cost::Volume.of(&assess(&hollow).case), 35.0, 1e-12);
    let drum = "[body]\nshape = \"cylinder\"\nwidth = 2\nheight = 3\ndensity = 2600\nfriction = 0.5\n[[load]]\nforce = 1e3\nelevation = 1\n";
    near(Cost::Volume.of(&assess(drum).case), std::f64::consts::PI * 3.0, 1e-12);
    near(Cost::Mass.of(&assess(drum).case), 2600.0 * std::f64::consts::PI * 3.0, 1e-8);
}

#[test]
fn what_has_no_least_cost_is_told() {
    let of = |vary: &[&str]| {
        found(&file(&wall(14.0, 11.0)), vary, Cost::Volume, &[]).map(|_| ()).unwrap_err().to_string()
    };
    for (vary, words) in [
        (&["friction"][..], "the volume does not change with friction"),
        (&["width", "width"], "width"),
        (&[], "0 quantities to vary; expected from one to 3"),
        (&["width", "height", "friction", "mass"], "4 quantities"),
        (&["width", "hight"], "the case has no `hight` to vary"),
    ] {
        let error = of(vary);
        assert!(error.contains(words), "{vary:?}: {error}");
    }
    // Nowhere in the ranges.
    let ends = [("2 m", "3 m"), ("9 m", "10 m"), ("0.3", "0.6")];
    for (vary, words) in [
        (&["width", "height"][..], "whatever height is from 9 m to 10 m, the target is not met; at 9.5 m: "),
        (
            &["width", "height", "friction"],
            "whatever height is from 9 m to 10 m and friction is from 0.3 to 0.6, the target is not met; at 9.5 m and 0.45: ",
        ),
    ] {
        let error =
            found(&file(&wall(14.0, 11.0)), vary, Cost::Volume, &ends[..vary.len()]).map(|_| ()).unwrap_err();
        assert!(error.to_string().starts_with(words), "{error}");
        let help = error.help().unwrap();
        assert_eq!(help, "--from and --to, of each quantity, widen the ranges");
    }
}

/// Below 3 m the load acts above the crest, and there is no case: the least height is where cases begin, whichever quantity comes first.
#[test]
fn where_cases_begin_is_an_end() {
    let text = "[body]\nwidth = 4\nheight = 6\ndensity = 2400\nfriction = 0.5\n[[load]]\nforce = 120e3\nelevation = 3\n[criteria]\n\
                SF_sliding = 0.5\nSF_overturning_net = 1.2\nbearing_max = 300e3\n";
    let of = |vary: &[&str], ends: &[(&str, &str)]| {
        let minimum = found(&file(text), vary, Cost::Volume, ends).unwrap();
        let answer = &minimum.answer().case.body;
        (minimum.found.cost, answer.height(), answer.width())
    };
    let one = of(&["height", "width"], &[("1.37", "12"), ("1", "8")]);
    let two = of(&["width", "height"], &[("1", "8"), ("1.37", "12")]);
    assert_eq!((one.1, two.1), (3.0, 3.0), "{one:?} {two:?}");
    near(one.0, two.0, 1e-9);
    near(of(&["height"], &[]).0, 4.0 * 3.0, 1e-9);
    // The width that just meets the pressure: a moment M = F e about the middle of a base w under the weight N = ρ g w h, with
    // p = 2N/(3(w/2 − M/N)).
    let width = |w: f64| {
        let weight = 2400.0 * 9.81 * w * 3.0;
        2.0 * weight / (3.0 * (w / 2.0 - 120e3 * 3.0 / weight))
    };
    assert!(width(one.2) <= 300e3 && width(one.2 - 0.001) > 300e3, "{}", width(one.2));
}
