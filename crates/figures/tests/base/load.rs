//! The plane of load factor and friction where the base gives way: every vertex solves the equations written out here, bands are
//! those of the decision under each load and friction, and a lone force gives the k–μ plane.

use standfast::ground::bearing::{self, Ground, GroundLaw};
use standfast::ground::load_plane::{GroundLoadPlane, LoadEdge};
use standfast::ground::strength::{self, CrushChart};
use standfast::loads::{Action, AddedMass, Load, LoadKind, LoadSource, Pose};
use standfast::{Body, Corner, Mode, Situation, Stage, Verdict, Wrench};
use standfast_figures::{LoadPlane, load_lines, load_plane};

const UP_TO: f64 = 2.0;

/// Bodies under forces, uplift and weights, with their centre of mass off the middle, added mass and two frictions.
fn situation(which: usize, friction: f64) -> Situation {
    let push = |right: f64, elevation: f64| {
        Load::variable(LoadSource::Force, LoadKind::Horizontal, Action::horizontal(right, elevation))
    };
    let uplift = |body: &Body, left: f64, right: f64| {
        let pressure = Action::base_pressure(body, left, right);
        Load::variable(LoadSource::Uplift, LoadKind::Uplift, pressure)
    };
    let body = Body::new(15.0, 12.0, 378e3).expect("a body");
    let off = body.with_centroid(1.5, 5.0).expect("a body");
    let slender = Body::new(2.0, 8.0, 40e3).expect("a body");
    let of = |body: Body| Situation::new(body, friction, 9.81).expect("a situation").with_weight();
    match which {
        0 => of(body).with(push(-1.5e6, 9.0)).with(uplift(&body, 0.0, 90e3)),
        1 => of(off).with(push(2.5e6, 4.0)).with(uplift(&off, 60e3, 10e3)),
        2 => of(slender).with(push(-120e3, 3.0)).with(push(-60e3, 7.5)),
        3 => {
            let all = of(body).with(push(-2e6, 7.0)).with(uplift(&body, 0.0, 40e3));
            all.with_kinetic_friction(0.8 * friction)
                .expect("friction")
                .with_added_mass(AddedMass::of(1e5).expect("mass"))
        }
        4 => {
            let pull =
                Load::permanent(LoadSource::Force, LoadKind::Horizontal, Action::horizontal(0.4e6, 8.0));
            of(body).with(pull).with(push(-2.2e6, -1.0))
        }
        _ => of(body).with(push(-0.3e6, 6.0)).with(uplift(&body, 300e3, 330e3)),
    }
}

const SITUATIONS: usize = 6;
const STRENGTHS: [f64; 3] = [0.4e6, 3e6, 0.3e9];

fn soils() -> [Ground; 3] {
    let soil = |law, angle| Ground::new(law, angle, 10e3).expect("sand");
    let dug = soil(GroundLaw::Hansen, 38.0).with_surcharge(20e3).expect("a surcharge");
    [soil(GroundLaw::Ec7, 40.0), dug, Ground::envelope(12e6).expect("an envelope")]
}

fn lines(plane: &GroundLoadPlane, situation: &Situation) -> Vec<(LoadEdge, Vec<(f64, f64)>)> {
    let rigid = situation.plane(UP_TO).expect("a plane");
    let friction = situation.static_friction();
    load_lines(&LoadPlane {
        regions: &rigid,
        base: Some(plane),
        uncertain: None,
        up_to: UP_TO,
        friction,
        stages: &[],
        title: "",
    })
}

/// Lengths in m, forces in N: the edge's distance, d, ρ², m_x, P, X and M of a body under a load factor.
struct Numbers {
    b: [f64; 2],
    d: f64,
    mass: f64,
    inertia: f64,
    pulled: f64,
    ratio: f64,
    wrench: Wrench,
}

impl Numbers {
    fn of(situation: &Situation, factor: f64) -> Numbers {
        let body = situation.body();
        Numbers {
            b: [body.heel_distance(), body.toe_distance()],
            d: body.centroid_height(),
            mass: body.mass(),
            inertia: body.moment_of_inertia(),
            pulled: body.mass() + situation.added_mass(),
            ratio: situation.kinetic_friction() / situation.static_friction(),
            wrench: situation.wrench_at(factor, Pose::UPRIGHT),
        }
    }

    /// N and the friction of rock, ẍ = −dθ̈: the crushed width is (P + m b a)/(q + m a) for a = |θ̈|, and its reaction acts in the middle.
    fn turning(&self, corner: Corner, q: f64) -> (f64, f64) {
        let (σ, b) = if corner == Corner::O { (1.0, self.b[0]) } else { (-1.0, self.b[1]) };
        let Wrench { x, p, m } = self.wrench;
        let crushed = |a: f64| (p + self.mass * b * a) / (q + self.mass * a);
        let left = |a: f64| {
            let c = crushed(a);
            (self.inertia + self.pulled * self.d * self.d) * a + q * c * (b - c / 2.0)
        };
        let moment = σ * (m - x * self.d);
        let (mut low, mut high) = (0.0, 1e6);
        for _ in 0..300 {
            let a = (low + high) / 2.0;
            if left(a) < moment { low = a } else { high = a }
        }
        (q * crushed(low), x + self.pulled * self.d * σ * low)
    }
}

#[test]
fn every_vertex_on_a_base_that_crushes_solves_its_equation() {
    let mut count = [0; 3];
    for which in 0..SITUATIONS {
        let situation = situation(which, 0.6);
        for q in STRENGTHS {
            let plane = GroundLoadPlane::crushing(&situation, q, UP_TO).expect("a plane");
            for (edge, points) in lines(&plane, &situation) {
                for (factor, mu) in points.into_iter().filter(|(_, mu)| *mu < 5.0) {
                    let n = Numbers::of(&situation, factor);
                    let Wrench { x, p, m } = n.wrench;
                    let size = 378e3 * 9.81;
                    let (place, off) = match edge {
                        LoadEdge::Friction { slips } => {
                            let mu = if slips { mu * n.ratio } else { mu };
                            (0, (x.abs() - mu * p) / size)
                        }
                        LoadEdge::Reaction { slip, corner } => {
                            let about = slip.sign() * mu * n.ratio * p * n.d - m;
                            let (σ, b) = if corner == Corner::O { (1.0, n.b[0]) } else { (-1.0, n.b[1]) };
                            (1, (b * p + σ * about - p * p / (2.0 * q)) / (7.5 * size))
                        }
                        LoadEdge::Turn { corner, slips } => {
                            let mu = if slips { mu * n.ratio } else { mu };
                            let (normal, pull) = n.turning(corner, q);
                            (2, (pull.abs() - mu * normal) / size)
                        }
                        LoadEdge::Bearing { .. } => panic!("ground does not fail here"),
                    };
                    assert!(off.abs() < 1e-12, "{which}, {q}: {edge:?} at {factor}, {mu}: {off}");
                    count[place] += 1;
                }
            }
        }
    }
    assert!(count.iter().all(|count| *count > 100), "{count:?}");
}

#[test]
fn every_vertex_on_ground_that_fails_solves_its_law() {
    let mut count = 0;
    for which in 0..SITUATIONS {
        let situation = situation(which, 0.6);
        for (law, soil) in soils().into_iter().enumerate() {
            let plane = GroundLoadPlane::failing(&situation, soil, UP_TO).expect("a plane");
            for (edge, points) in lines(&plane, &situation) {
                for (factor, mu) in points.into_iter().filter(|(_, mu)| *mu > 0.0 && *mu < 5.0) {
                    let LoadEdge::Bearing { slip, .. } = edge else { continue };
                    let n = Numbers::of(&situation, factor);
                    let Wrench { p, m, .. } = n.wrench;
                    let x = slip.sign() * mu * n.ratio * p;
                    let (half, middle) = ((n.b[0] + n.b[1]) / 2.0, (n.b[1] - n.b[0]) / 2.0);
                    let e = (x * n.d - m) / p - middle;
                    let (η, ε) = (x.abs() / p, e.abs() / half);
                    let n_q = |angle: f64| {
                        let tan = angle.to_radians().tan();
                        (std::f64::consts::PI * tan).exp() * (45.0 + angle / 2.0).to_radians().tan().powi(2)
                    };
                    let wide = 2.0 * half * (1.0 - ε);
                    let borne = match law {
                        0 => {
                            let n_gamma = 2.0 * (n_q(40.0) - 1.0) * 40f64.to_radians().tan();
                            wide * wide / 2.0 * 10e3 * n_gamma * (1.0 - η).powi(3)
                        }
                        1 => {
                            let n_gamma = 1.5 * (n_q(38.0) - 1.0) * 38f64.to_radians().tan();
                            let own = wide / 2.0 * 10e3 * n_gamma * (1.0 - 0.7 * η).powi(5);
                            wide * (own + 20e3 * n_q(38.0) * (1.0 - 0.5 * η).powi(5))
                        }
                        _ => {
                            let (h, t) = (η / 0.52, (e * x).signum() * ε / 0.7);
                            12e6 * (1.0 - (h * h + t * t - 2.0 * 0.22 * h * t).sqrt())
                        }
                    };
                    // Next to P = 0 the eccentricity has no more digits than these.
                    let off = (borne - p) / 12e6;
                    assert!(
                        off.abs() < 1e-12 * (1.0 + 378e3 * 9.81 / p),
                        "{which}, {law}: {edge:?} at {factor}, {mu}: {off}"
                    );
                    count += 1;
                }
            }
        }
    }
    assert!(count > 200, "{count}");
}

/// Verdict of the bands at a point, and the point's distance from a boundary or an end.
fn said(plane: &GroundLoadPlane, factor: f64, mu: f64) -> Option<(Option<Verdict>, f64)> {
    let band = plane.bands().iter().find(|band| band.from <= factor && factor < band.to)?;
    let ends = (factor - band.from).min(band.to - factor);
    band.cells.iter().find_map(|cell| {
        let [lower, upper] =
            [cell.lower, cell.upper].map(|edge| Some(plane.at(edge?, factor).expect("μ of a boundary")));
        let (below, above) = (mu - lower.unwrap_or(0.0), upper.unwrap_or(f64::INFINITY) - mu);
        (below >= 0.0 && above >= 0.0).then(|| (cell.verdict, below.min(above).min(ends)))
    })
}

/// Each point of the plane is decided anew: as the full load of a situation with that friction and the loads times λ.
#[test]
fn bands_are_those_of_the_decision() {
    let mut seen: Vec<Verdict> = Vec::new();
    for which in 0..SITUATIONS {
        let loaded = |friction: f64, factor: f64| {
            let given = situation(which, friction);
            let loads = given.loads().iter().filter(|load| load.source != LoadSource::Weight);
            let bare = Situation::new(*given.body(), friction, 9.81).expect("a situation");
            let bare = bare.with_kinetic_friction(given.kinetic_friction()).expect("friction");
            let bare = bare.with_added_mass(*given.moved_water()).with_weight();
            let times = |load: &Load| if load.permanent { load.clone() } else { load.clone().times(factor) };
            bare.with_all(loads.map(times).collect::<Vec<_>>())
        };
        let mut check =
            |plane: &GroundLoadPlane, of: &str, decided: &dyn Fn(&Situation) -> Option<Verdict>| {
                for i in 0..16 {
                    for j in 0..12 {
                        let (factor, mu) =
                            (UP_TO * (f64::from(i) + 0.41) / 16.0, 1.8 * (f64::from(j) + 0.37) / 12.0);
                        let (found, near) = said(plane, factor, mu).expect("bands fill the plane");
                        if near < 1e-9 {
                            continue;
                        }
                        let expected = decided(&loaded(mu, factor));
                        assert_eq!(found, expected, "{which}, {of}: λ = {factor}, μ = {mu}");
                        seen.extend(expected.filter(|verdict| !seen.contains(verdict)));
                    }
                }
            };
        let given = situation(which, 0.6);
        for q in STRENGTHS {
            let plane = GroundLoadPlane::crushing(&given, q, UP_TO).expect("a plane");
            check(&plane, &format!("q = {q}"), &|at| {
                strength::outcome(at, q).expect("an outcome").outcome.full.verdict
            });
        }
        for soil in soils() {
            let plane = GroundLoadPlane::failing(&given, soil, UP_TO).expect("a plane");
            check(&plane, soil.law_name(), &|at| {
                bearing::outcome(at, soil).expect("an outcome").outcome.full.verdict
            });
        }
    }
    // Nearly all there is.
    for mode in
        [Mode::Rest, Mode::SlideLeft, Mode::SlideRight, Mode::RockO, Mode::SlideRockOLeft, Mode::Flight]
    {
        assert!(seen.contains(&Verdict::Begins(mode)), "{mode}: {seen:?}");
    }
    assert!(seen.contains(&Verdict::BearingFailure));
}

/// Under a lone force λ is k: the curve of rock and slide-rock is the k–μ plane's, from another formula.
#[test]
fn under_a_lone_force_it_is_the_k_mu_plane() {
    let (b, height, mass): (f64, f64, f64) = (7.5, 12.0, 378e3);
    for (elevation, omega) in [(11.5, 0.08), (11.5, 0.5), (9.0, 0.2)] {
        let weight = mass * 9.81;
        let push =
            Load::variable(LoadSource::Force, LoadKind::Horizontal, Action::horizontal(-weight, elevation));
        let body = Body::new(2.0 * b, height, mass).expect("a body");
        let situation = Situation::new(body, 0.6, 9.81).expect("a situation").with_weight().with(push);
        let plane = GroundLoadPlane::crushing(&situation, weight / (2.0 * b * omega), 3.0).expect("a plane");
        let k_prime = 2.0 * elevation / height - 1.0;
        let chart = CrushChart::new(height / (2.0 * b), k_prime, omega).expect("a chart");
        let edge = LoadEdge::Turn { corner: Corner::O, slips: false };
        let (mut count, mut first) = (0, f64::INFINITY);
        for (found, points) in lines(&plane, &situation) {
            for (k, mu) in points.into_iter().filter(|point| found == edge && point.0 > chart.k_a()) {
                let expected = chart.mu_star(k).expect("right of A");
                assert!((mu - expected).abs() < 1e-12 * (1.0 + k), "{k}: {mu} {expected}");
                (count, first) = (count + 1, first.min(k));
            }
        }
        assert!(
            count > 3 && plane.bands().iter().any(|band| (band.from - chart.k_a()).abs() < 1e-14),
            "{count}"
        );
    }
}

/// As strength grows without end bands and boundaries become those of rigid ground.
#[test]
fn a_strong_base_is_rigid() {
    for which in 0..SITUATIONS {
        let situation = situation(which, 0.6);
        let plane = GroundLoadPlane::crushing(&situation, 1e18, UP_TO).expect("a plane");
        let rigid = situation.plane(UP_TO).expect("regions");
        for i in 0..60 {
            for j in 0..40 {
                let (factor, mu) = (UP_TO * (f64::from(i) + 0.41) / 60.0, 2.0 * (f64::from(j) + 0.37) / 40.0);
                let mode = rigid.iter().find(|region| region.contains(factor, mu)).map(|region| region.mode);
                let (found, near) = said(&plane, factor, mu).expect("bands fill the plane");
                assert!(
                    found.and_then(Verdict::mode) == mode || near < 1e-6,
                    "{which}: {factor}, {mu}: {found:?} {mode:?}"
                );
            }
        }
    }
}

#[test]
fn the_drawing_is_tidy_and_says_what_it_shows() {
    for which in 0..SITUATIONS {
        let situation = situation(which, 0.6);
        let rigid = situation.plane(UP_TO).expect("a plane");
        let draw = |plane: &GroundLoadPlane, stages: &[Stage], uncertain: Option<[f64; 2]>| {
            let figure = load_plane(&LoadPlane {
                regions: &rigid,
                base: Some(plane),
                uncertain,
                up_to: UP_TO,
                friction: 0.6,
                stages,
                title: "Body",
            });
            super::assert_tidy(&figure);
            // The band from φ − 2° on is in sight where it begins before the end.
            let band = uncertain.is_some_and(|[less, _]| less < UP_TO);
            let said = figure.caption();
            assert!(said.contains("Dotted: on rigid ground."), "{said}");
            assert_eq!(said.contains(" Hatched: where the ground fails at φ"), band, "{which}: {said}");
            figure
        };
        for q in STRENGTHS {
            let stages = strength::outcome(&situation, q).expect("an outcome").outcome.path;
            draw(&GroundLoadPlane::crushing(&situation, q, UP_TO).expect("a plane"), &stages, None);
        }
        for soil in soils() {
            let found = bearing::outcome(&situation, soil).expect("an outcome");
            let (stages, factors) = (found.outcome.path, found.load_factors);
            let plane = GroundLoadPlane::failing(&situation, soil, UP_TO).expect("a plane");
            let figure =
                draw(&plane, &stages, factors.less.zip(factors.more).map(|(less, more)| [less, more]));
            assert!(figure.svg().contains("stands on ground that fails"), "{which}");
        }
    }
}
