//! What all figures have in common: two widths, and labels that can be read on paper.

use standfast::contact::stack::{Joint, Shaking, Stack, StackBody, plane as stack_plane};
use standfast::contact::{Block, path, plane};
use standfast::ground::elastic::ElasticBase;
use standfast::{Diagram, Mode, Wrench};
use standfast_figures::{
    Chance, ChanceCloud, ChanceGroup, ChanceLine, ChanceLines, ChanceMark, ChanceRow, ChanceRows, CloudPanel,
    DesignPoint, FeasibleSet, Figure, Importance, LineLook, LoadPlane, Material, Measure, MotionLoad,
    MotionOutline, MotionPicture, MotionPose, Outline, RotationCurve, Section, SetAxis, SetColumn, SetEnd,
    SetStretch, SpectrumAxis, SpectrumLines, SpectrumMap, StackMap, Tornado, chance_cloud, chance_lines,
    chance_rows, chance_tornado, diagram, feasible_set, load_plane, motion_animation, motion_histories,
    motion_positions, rotation_curve, section, spectrum_lines, spectrum_map, stack_map,
};

/// Widths of a column and of a page, in SVG units.
const WIDTHS: [f64; 2] = [480.0, 720.0];
/// Points on paper for a unit, of a figure that is printed as wide as a sheet's text, 170 mm, and at most 128 mm high.
fn points((width, height): (f64, f64)) -> f64 {
    let point = 25.4 / 72.0;
    (170.0 / width).min(128.0 / height) / point
}

const MODES: [Mode; 4] = [Mode::Rest, Mode::SlideRockOLeft, Mode::SlideRockOPrimeLeft, Mode::RockO];

fn axis(name: &str, from: f64, to: f64) -> SpectrumAxis<'_> {
    SpectrumAxis { name, from, to, logarithmic: false }
}

/// A slender block on a squat one, on a shaken base.
fn two_blocks(k: f64, mu: f64) -> Stack {
    let joint = |h: f64, half: f64| Joint { h, l: -half, r: half, mu_s: mu, mu_k: mu };
    Stack {
        bodies: vec![
            StackBody { y: 0.25, ..StackBody::of(0.5, 0.05) },
            StackBody { y: 0.95, ..StackBody::of(0.3, 0.025) },
        ],
        joints: vec![joint(0.0, 0.5), joint(0.5, 0.15)],
        shaking: Shaking { gravity: 1.0, horizontal: k, ..Shaking::default() },
    }
}

fn planes() -> Vec<Figure> {
    let body = Diagram::new(0.8, 0.9167).expect("a body");
    let storm = DesignPoint { k: 0.61, mu: 0.6, label: "storm".into(), mirrored: false };
    let (permanent, variable) = (Wrench { x: 0.0, p: 1.0, m: 0.0 }, Wrench { x: -1.0, p: -0.3, m: 0.9 });
    let block = Block::uniform(1.0, 0.6);
    let regions = plane::regions(&block, &permanent, &variable, 2.0).expect("a block");
    let stages = path::stages(&block, &permanent, &variable).expect("a block");
    let path = LoadPlane {
        regions: &regions,
        base: None,
        uncertain: None,
        up_to: 2.0,
        friction: 0.6,
        stages: &stages,
        title: "A block",
    };
    let column = |mu: f64| SetColumn {
        at: mu,
        stretches: vec![SetStretch {
            from: SetEnd { value: 6.0 / mu, by: Some("sliding") },
            to: SetEnd { value: 40.0, by: None },
        }],
        none: None,
    };
    let set = feasible_set(&FeasibleSet {
        title: "Block",
        caption: "Shaded: the block rests.",
        across: SetAxis { words: "friction", symbol: "μ", unit: "", present: 0.6 },
        up: SetAxis { words: "width", symbol: "w", unit: "m", present: 9.0 },
        columns: &[0.3, 0.45, 0.6, 0.9, 1.2].map(column),
    });
    let base = ElasticBase::new(7.5, 2.2e6, 50e6).expect("a base");
    let curve = |moment: f64| {
        let curve = RotationCurve { base, height: 5.25, moment, title: "Caisson" };
        rotation_curve(&curve).expect("a height").expect("it stands")
    };
    let map = stack_plane::plane(two_blocks, [1.2, 0.8]).expect("a stack");
    let map = StackMap {
        plane: &map,
        window: [1.2, 0.8],
        across: "Acceleration of the base, $k$",
        up: "Friction, $μ$",
        curves: &[vec![(0.0, 0.0), (0.3, 0.3)]],
        point: Some(DesignPoint { k: 0.4, mu: 0.5, label: "full load".to_owned(), mirrored: false }),
        regions: None,
        words: None,
        title: "Two blocks",
    };
    let flat = [diagram(&body, &[storm]), load_plane(&path), set.expect("a boundary"), stack_map(&map)];
    flat.into_iter().chain([curve(4.8e6), curve(1.2e7)]).collect()
}

fn chances() -> Vec<Figure> {
    let chance = |value: f64| Chance { value, low: 0.8 * value, high: (1.3 * value).min(1.0) };
    let (title, caption) = ("A body", "By counting.");
    let rows = MODES.map(|mode| ChanceRow { mode: Some(mode), words: mode.words(), chance: chance(0.02) });
    let groups = [ChanceGroup { heading: "At least once in 50 years", rows: &rows }];
    let numbers = [Importance { name: "Coulomb friction between body and base", alpha2: 0.7, known: 0.003 }];
    let looks =
        [LineLook::Answer, LineLook::Fit, LineLook::Mode(Mode::SlideRockOLeft), LineLook::Points(None)];
    let lines = looks.map(|look| ChanceLine {
        name: "slides and rocks about O, the bottom left corner",
        look,
        points: (0..=10).map(|i| (f64::from(i), chance(0.05 * f64::from(i)))).collect(),
    });
    let cloud = |count: usize| {
        let panel = CloudPanel {
            across: axis("force over weight, $k$", 0.0, 1.0),
            up: axis("friction, $μ$", 0.0, 1.0),
            areas: vec![(Mode::SlideLeft, vec![(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)])],
            points: vec![(0.2, 0.3), (0.7, 0.8)],
        };
        let panels = vec![panel; count];
        chance_cloud(&ChanceCloud { title, caption, panels: &panels, modes: &[Some(Mode::SlideLeft), None] })
    };
    vec![
        chance_rows(&ChanceRows { title, caption, groups: &groups }),
        chance_tornado(&Tornado { title, caption, probability: 0.02, numbers: &numbers }),
        chance_lines(&ChanceLines {
            title,
            caption,
            across: axis("peak of the shaking ($g$)", 0.0, 10.0),
            up: axis("probability", 0.0, 1.04),
            lines: &lines,
            marks: &[ChanceMark { at: 3.0, words: "mean 3 m" }],
        }),
        cloud(1),
        cloud(2),
    ]
}

fn motions() -> Vec<Figure> {
    let states: Vec<(f64, Mode)> =
        (0..40).map(|i| (0.5 * f64::from(i), MODES[i as usize % MODES.len()])).collect();
    let history: Vec<(f64, f64)> =
        (0..=200).map(|i| (0.1 * f64::from(i), (0.7 * f64::from(i)).sin())).collect();
    let picture = MotionPicture {
        title: "A block",
        caption: "It slides and rocks.",
        outline: MotionOutline { b1: 1.0, b2: 1.0, d: 2.0, height: 4.0 },
        begin: 0.0,
        end: 20.0,
        time_unit: "s",
        length_unit: "m",
        states: &states,
        loads: &[
            MotionLoad { name: "load", points: &history },
            MotionLoad { name: "load upwards", points: &history },
        ],
        slide: &history,
        theta: &history,
        ground: &history,
        balance: [0.46, -0.46],
    };
    let pose = |i: u32| MotionPose {
        t: 2.0 * f64::from(i),
        x: 0.1 * f64::from(i),
        y: 2.0,
        theta: 0.0,
        slide: 0.1 * f64::from(i),
        mode: MODES[i as usize % MODES.len()],
    };
    let poses: Vec<MotionPose> = (0..8).map(pose).collect();
    let lines = SpectrumLines {
        title: "A shaking",
        caption: "It overturns.",
        across: axis("factor on the shaking", 0.05, 5.0),
        up: axis("largest $|θ|$", 0.0, 1.0),
        lines: &[("where it stands", vec![(0.1, 0.1), (1.0, 0.5), (1.1, f64::INFINITY)])],
        shaded: (&[[1.05, 5.0]], "it overturns"),
        marks: &[ChanceMark { at: 1.0, words: "this shaking" }],
    };
    let map = SpectrumMap {
        title: "A shaking",
        caption: "Blocks.",
        across: SpectrumAxis { name: "half diagonal $R$ (m)", from: 1.0, to: 10.0, logarithmic: true },
        up: axis("height over width", 2.0, 8.0),
        above: &[vec![vec![(1.0, 2.0), (5.0, 2.0), (5.0, 8.0), (1.0, 8.0)]]],
        occurs: [true; 7],
        classes: ["does not rock", "a", "b", "c", "d", "beyond $α$, and comes back", "overturns"],
    };
    vec![
        motion_histories(&picture),
        motion_positions(&picture, &poses),
        motion_animation(&picture, &poses),
        spectrum_lines(&lines),
        spectrum_map(&map),
    ]
}

fn sections() -> Vec<Figure> {
    let drawn = |half: f64, height: f64| {
        let part = Outline {
            vertices: vec![(-half, 0.0), (half, 0.0), (half, height), (-half, height)],
            material: Material::Solid,
            label: "base slab".into(),
        };
        section(&Section {
            title: "Block",
            parts: &[part],
            joints: Vec::new(),
            base: (-half, half),
            centroid: (0.0, height / 2.0),
            levels: Vec::new(),
            pressures: Vec::new(),
            arrows: Vec::new(),
            widths: vec![vec![Measure { ends: (-half, half), label: "width 1 m".into() }]],
            heights: vec![vec![Measure { ends: (0.0, height), label: "height 2 m".into() }]],
            mound: None,
            is_on_soil: false,
            backfills: Vec::new(),
            wave_crest: None,
            reaction: None,
            friction: None,
            ground: None,
            plan: None,
            notes: vec!["A note on all this, in a sentence that goes on for a while.".to_owned()],
        })
    };
    vec![drawn(0.5, 2.0), drawn(4.0, 1.0), drawn(0.1, 3.0)]
}

#[test]
fn figures_have_one_of_two_widths_and_labels_of_six_points() {
    for figure in planes().into_iter().chain(chances()).chain(motions()).chain(sections()) {
        let size = figure.size();
        assert!(WIDTHS.contains(&size.0), "{size:?}: {:?}", figure.title());
        for label in figure.labels() {
            let on_paper = label.size * points(size);
            assert!(
                on_paper >= 6.0,
                "{:?} is {on_paper:.2} pt in {:?}, {size:?}",
                label.text,
                figure.title()
            );
        }
    }
}

/// Names of axes begin with a capital and are words: k and μ are told, not only named.
#[test]
fn the_axes_of_a_plane_are_named_in_words() {
    let texts =
        |figure: &Figure| -> Vec<String> { figure.labels().iter().map(|label| label.text.clone()).collect() };
    let planes = planes();
    for (figure, names) in planes.iter().zip([
        ["Force over weight, k", "Friction, μ"],
        ["Share of the load, λ", "Friction, μ"],
        ["Friction, μ", "Width, w (m)"],
        ["Acceleration of the base, k", "Friction, μ"],
        ["Rotation, θ (mrad)", "Moment over weight and half-width, M/(VB)"],
    ]) {
        for name in names {
            assert!(texts(figure).iter().any(|text| text == name), "{name:?}: {:?}", texts(figure));
        }
    }
}
