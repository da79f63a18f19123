//! The plane of load factor and friction: tidy for any block, the same bytes every time, and it says what the path does.

use resvg::usvg;
use standfast::contact::{Block, path, plane};
use standfast::loads::LoadKind::{Horizontal, Uplift, Weight};
use standfast::loads::{Action, Load, LoadKind, LoadSource};
use standfast::region::Region;
use standfast::{Body, Diagram, Mode, Situation, Stage, Verdict, Wrench};
use standfast_figures::{DesignPoint, Figure, LoadPlane, Rect, diagram, load_plane};

const G: f64 = 9.81;

/// SplitMix64.
struct Random(u64);

impl Random {
    fn uniform(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        low + (high - low) * ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    fn coin(&mut self) -> bool {
        self.uniform(0.0, 1.0) < 0.5
    }
}

/// A block and its load, solved.
struct Case {
    regions: Vec<Region>,
    stages: Vec<Stage>,
    up_to: f64,
    friction: f64,
    name: String,
}

impl Case {
    fn of(situation: &Situation, up_to: f64, name: &str) -> Case {
        Case {
            regions: situation.plane(up_to).expect("a valid situation"),
            stages: situation.path().expect("a valid situation"),
            up_to,
            friction: situation.static_friction(),
            name: name.into(),
        }
    }

    fn figure(&self) -> Figure {
        load_plane(&LoadPlane {
            regions: &self.regions,
            base: None,
            uncertain: None,
            up_to: self.up_to,
            friction: self.friction,
            stages: &self.stages,
            title: &self.name,
        })
    }
}

/// Uniform and eccentric blocks, forces to either side, uplift that may lift the block, friction from ice to rubber.
fn random_cases(count: usize) -> impl Iterator<Item = Case> {
    let mut random = Random(31);
    (0..count).map(move |i| {
        let slenderness = random.uniform(0.2, 5.0);
        let friction = random.uniform(0.05f64.ln(), 4.0f64.ln()).exp();
        let mut block = Block::uniform(slenderness, friction);
        if random.coin() {
            block.b1 *= random.uniform(0.3, 1.7);
            block.b2 *= random.uniform(0.3, 1.7);
            block.rho2 *= random.uniform(0.5, 1.5);
            block.m_x += random.uniform(0.0, 1.0);
        }
        if random.coin() {
            block.mu_k *= random.uniform(0.5, 1.0);
        }
        let lift = if random.coin() { random.uniform(-1.5, 0.5) } else { 0.0 };
        let x = random.uniform(-1.0, 1.0);
        let m = -x * slenderness * random.uniform(-1.5, 1.5);
        let permanent = if random.coin() {
            Wrench { x: 0.0, p: 1.0, m: 0.0 }
        } else {
            Wrench { x: random.uniform(-0.3, 0.3), p: random.uniform(0.2, 1.0), m: random.uniform(-0.5, 0.5) }
        };
        let variable = Wrench { x, p: lift, m };
        let up_to = [2.0, 5.0, 0.5, 20.0][i % 4];
        Case {
            regions: plane::regions(&block, &permanent, &variable, up_to).expect("a valid block"),
            stages: path::stages(&block, &permanent, &variable).expect("a valid block"),
            up_to,
            friction,
            name: format!("random block {i}: {block:?} {permanent:?} {variable:?}"),
        }
    })
}

fn caisson(friction: f64) -> (Body, Situation) {
    let body = Body::new(15.0, 10.5, 346_050.0).expect("a body");
    let buoyant = Wrench { x: 0.0, p: 2318.6e3, m: 0.0 };
    let weight = Load::permanent(LoadSource::Other, Weight, buoyant);
    (body, Situation::new(body, friction, G).expect("a body on a base").with(weight))
}

fn variable(kind: LoadKind, action: impl Into<Action>) -> Load {
    Load::variable(LoadSource::Other, kind, action)
}

fn standing(body: Body, friction: f64, gravity: f64) -> Situation {
    Situation::new(body, friction, gravity).expect("a body on a base").with_weight()
}

/// Cases worth looking at.
fn gallery() -> Vec<Case> {
    let (body, still) = caisson(0.6);
    let wave = |force: f64, left: f64, right: f64| {
        let push = variable(Horizontal, Action::horizontal(force, 4849.6 / 940.68));
        still.clone().with(push).with(variable(Uplift, Action::base_pressure(&body, left, right)))
    };
    let goda = wave(-940.68e3, 0.0, 65_739.0);
    let lifted = wave(-940.68e3, 30_000.0, 180_000.0);
    let right = wave(940.68e3, 65_739.0, 0.0);
    let monument = Body::new(0.8, 2.4, 4_000.0).expect("a body");
    let shaken = Action::Inertia { right: 0.5 * G, up: -0.2 * G };
    let seismic = standing(monument, 0.7, G).with(variable(Horizontal, shaken));
    let leaning = Body::new(10.0, 8.0, 2e5).expect("a body");
    let leaning = leaning.with_centroid(2.0, 5.0).and_then(|body| body.with_base(4.0, 5.0)).expect("a body");
    let eccentric = standing(leaning, 0.5, G).with(variable(Horizontal, Action::horizontal(-900e3, 6.0)));
    let square = Body::new(2.0, 2.0, 1000.0).expect("a body");
    let undecided =
        standing(square, 3.0, 10.0).with(variable(Horizontal, Action::horizontal(-10_000.0, 0.5)));
    let sticky = goda.clone().with_kinetic_friction(0.4).expect("less than to stick");
    vec![
        Case::of(&goda, 3.0, "Caisson, Goda 2000"),
        Case::of(&lifted, 3.0, "Caisson lifted by its uplift"),
        Case::of(&seismic, 3.0, "Monument, earthquake"),
        Case::of(&eccentric, 4.0, "Eccentric body"),
        Case::of(&right, 3.0, "Caisson, wave to the right"),
        Case::of(&undecided, 6.0, "Into N"),
        Case::of(&sticky, 3.0, "Caisson, slip lower than stick"),
    ]
}

fn assert_tidy(figure: &Figure) {
    usvg::Tree::from_str(figure.svg(), &usvg::Options::default()).expect("well-formed SVG");
    assert!(!figure.svg().contains("NaN") && !figure.svg().contains("inf"));
    let (width, height) = figure.size();
    let page = Rect { x0: 1.0, y0: 1.0, x1: width - 1.0, y1: height - 1.0 };
    for (i, label) in figure.labels().iter().enumerate() {
        assert!(page.contains(&label.rect), "{:?} leaves the page of {:?}", label, figure.title());
        for other in &figure.labels()[i + 1..] {
            let apart = !label.rect.overlaps(&other.rect);
            assert!(apart, "{label:?} touches {other:?} in {:?}", figure.title());
        }
    }
}

/// Every coordinate of every path lies on the page: no pole escapes.
fn assert_on_page(figure: &Figure) {
    let body = figure.svg().split("</defs>").nth(1).expect("a body");
    for path in body.split("<path d=\"").skip(1) {
        let data = path.split('"').next().expect("path data");
        for number in
            data.split(|c: char| c.is_ascii_alphabetic() || c == ' ').filter(|part| !part.is_empty())
        {
            let number: f64 = number.parse().expect("a number");
            assert!((-1.0..=1200.0).contains(&number), "{number} in {:?}", figure.title());
        }
    }
}

#[test]
fn a_load_plane_is_tidy_for_any_block() {
    for (i, case) in gallery().into_iter().chain(random_cases(200)).enumerate() {
        let figure = case.figure();
        assert_tidy(&figure);
        assert_on_page(&figure);
        if i < 20 {
            assert_eq!(figure, case.figure(), "the same bytes every time");
        }
    }
}

#[test]
fn numbers_out_of_the_ordinary_are_drawn_or_left_out() {
    let cases = gallery();
    for friction in [0.0, 1e-9, 1e-3, 40.0, 1e7, f64::NAN, f64::INFINITY, -1.0] {
        for up_to in [1e-6, 0.3, 1.0, 1e7, f64::NAN, 0.0] {
            for Case { regions, stages, .. } in &cases {
                let (title, empty) = ("W".repeat(400), String::new());
                for title in [&title, &empty] {
                    let figure = load_plane(&LoadPlane {
                        regions,
                        base: None,
                        uncertain: None,
                        up_to,
                        friction,
                        stages,
                        title,
                    });
                    assert_tidy(&figure);
                    assert_on_page(&figure);
                }
            }
            assert_tidy(&load_plane(&LoadPlane {
                regions: &[],
                base: None,
                uncertain: None,
                up_to,
                friction,
                stages: &[],
                title: "<&>",
            }));
        }
    }
}

#[test]
fn the_path_has_its_numbers_and_words() {
    let [goda, lifted, ..] = &gallery()[..] else { panic!("too few cases") };
    let figure = lifted.figure();
    assert_eq!(figure.title(), "Caisson lifted by its uplift");
    assert_eq!(
        figure.caption(),
        "Rising load: 0–0.738 RE, 0.738–1.05 SL, 1.05–2.75 SRO₋, 2.75–3 FL. Full load (λ = 1, diamond): SL."
    );
    let has = |figure: &Figure, text: &str| figure.labels().iter().filter(|label| label.text == text).count();
    for text in ["0.738", "1.05", "2.75", "μ = 0.6", "Share of the load, λ", "Friction, μ"] {
        assert_eq!(has(&figure, text), 1, "{text}");
    }
    // A stage is not named where its region is.
    for text in ["RE", "SL", "SRO₋", "FL"] {
        assert_eq!(has(&figure, text), 1, "{text}");
    }
    assert!(figure.svg().contains("FL, where the body leaves the base"));
    assert_eq!(has(&goda.figure(), "1.13"), 1);
}

#[test]
fn stages_with_several_modes_are_dashed_and_name_them() {
    let figure = gallery()[5].figure();
    assert!(figure.caption().contains("4–6 SL (also RO, SRO₋)"), "{}", figure.caption());
    assert!(figure.caption().ends_with("Dashed: several modes are consistent."));
    assert!(figure.svg().contains("stroke-dasharray=\"6 3\""));
    assert!(!gallery()[0].figure().svg().contains("stroke-dasharray"));
}

#[test]
fn load_factors_that_nearly_agree_are_told_apart() {
    let stages = [
        stage(0.0, 0.9996, Mode::Rest),
        stage(0.9996, 0.9998, Mode::SlideLeft),
        stage(0.9998, 2.0, Mode::RockO),
    ];
    let figure = load_plane(&LoadPlane {
        regions: &[],
        base: None,
        uncertain: None,
        up_to: 2.0,
        friction: 0.6,
        stages: &stages,
        title: "",
    });
    assert_tidy(&figure);
    assert_eq!(
        figure.caption(),
        "Rising load: 0–0.9996 RE, 0.9996–0.9998 SL, 0.9998–2 RO. Full load (λ = 1, diamond): RO."
    );
}

/// The diamond of the full load reaches 5.2 units up and down; a tick under it is seen beyond, and its number too.
#[test]
fn a_tick_is_seen_beside_the_diamond() {
    let ticks = |at: f64| -> f64 {
        let stages = [stage(0.0, at, Mode::Rest), stage(at, 2.0, Mode::SlideLeft)];
        let figure = load_plane(&LoadPlane {
            regions: &[],
            base: None,
            uncertain: None,
            up_to: 2.0,
            friction: 0.6,
            stages: &stages,
            title: "",
        });
        assert_tidy(&figure);
        assert!(figure.labels().iter().any(|label| label.text == at.to_string()), "{at} is not at its tick");
        let tick = figure.svg().lines().find(|line| line.contains("stroke=\"#a3123f\" stroke-width=\"1.6\""));
        let path =
            tick.expect("a tick").split_once("d=\"M").expect("a path").1.split_once('"').expect("its end").0;
        let ends: Vec<f64> = path.split(['L', ' ']).map(|number| number.parse().expect("a number")).collect();
        (ends[3] - ends[1]) / 2.0
    };
    assert!(ticks(0.995) > 5.2 + 4.0 && ticks(1.01) > 5.2 + 4.0);
    assert!((ticks(1.3) - 6.5).abs() < 1e-9);
}

/// Mirrored loads give mirrored modes in the tints of the partners the report has.
#[test]
fn a_force_to_the_right_has_the_same_lines() {
    let cases = gallery();
    let [left, right] = [0, 4].map(|i| cases[i].figure());
    assert_eq!(right.caption(), left.caption().replace("SL", "SL₊"));
    for property in ["slide", "slide-rock-left"] {
        let (_, tint, _) =
            standfast_figures::colours().find(|colour| colour.0 == property).expect("a colour");
        let filled = format!("fill=\"{tint}\"/>");
        assert!(right.svg().contains(&filled) && left.svg().contains(&filled));
    }
    // The mirror image is striped, as its tint is its partner's.
    let stripes = |figure: &Figure| figure.svg().matches("stroke-width=\"1.15\"/>").count();
    assert!(stripes(&right) > stripes(&left));
    assert!(right.labels().iter().any(|label| label.text == "SRO′₊"));
}

#[test]
fn the_indeterminate_set_is_hatched_if_a_design_point_lies_in_it() {
    let body = Diagram::new(1.0, -0.5).expect("a valid body");
    let point = |k, mu| [DesignPoint { k, mu, label: "storm".into(), mirrored: false }];
    let (outside, inside) = (diagram(&body, &point(1.0, 3.0)), diagram(&body, &point(5.0, 3.0)));
    assert_tidy(&inside);
    assert!(inside.caption().contains("hatched: one of SL, RO, SRO₋ or one of RO, SRO₋, SRO′₋"));
    assert!(inside.caption().contains("storm (5, 3): SL (also RO, SRO₋)."), "{}", inside.caption());
    assert!(!outside.caption().contains("hatched") && outside.caption().contains("storm (1, 3): RE."));
    assert_eq!(inside, diagram(&body, &point(5.0, 3.0)));
}

fn stage(from: f64, to: f64, mode: Mode) -> Stage {
    Stage { from, to, verdict: Some(Verdict::Begins(mode)), modes: [mode].into_iter().collect() }
}
