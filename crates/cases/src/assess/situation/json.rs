//! A case whose loads act together as one JSON document, at full precision.
//!
//! Names and units of wave quantities, actions and safety factors are Goda's as a designer writes them: kN, kN·m, kPa, m,
//! per metre run. Motions are SI. What is infinite or does not exist is `null`.

use serde::Serialize;
use standfast::wave::Goda;
use standfast::{LoadKind, Mode, Modes};

use super::{Assessed, loads};
use crate::answer::{Body, Onset, direction};
use crate::case::{Case, Component, WaveLoad};

/// What the numbers are measured in.
const UNITS: &str = "P, U and buoyant_weight in kN/m; M_p and M_U in kN m/m; p1, p3, p4, pu and heel_pressure in kPa; \
    lengths in m; components in kN/m and kN m/m; body, gravity and motion_si in SI units";

#[derive(Serialize)]
struct Document<'a> {
    title: Option<&'a str>,
    note: Option<&'a str>,
    units: &'static str,
    gravity: f64,
    body: LoadedBody,
    weight_counted_as: &'static str,
    #[serde(flatten)]
    waves: Option<Waves>,
    warnings: Vec<String>,
    /// The situation that leaves rest first.
    #[serde(flatten)]
    governing: Answer,
    /// One entry for each alternative force.
    loads: Vec<LoadAnswer<'a>>,
    diagrams: &'a [String],
}

#[derive(Serialize)]
struct LoadedBody {
    #[serde(flatten)]
    body: Body,
    kinetic_friction: f64,
    added_mass: f64,
    centroid_height: f64,
    heel_distance: f64,
    toe_distance: f64,
    moment_of_inertia: f64,
}

#[derive(Serialize)]
struct Waves {
    #[serde(rename = "H13")]
    h_13: f64,
    #[serde(rename = "Hmax")]
    h_max: f64,
    deep_water_wavelength: f64,
    wavelength: f64,
    h_b: f64,
    angle_deg: f64,
    turn_deg: f64,
    impulsive: bool,
    lambda: [f64; 3],
    eta_star: f64,
    h_c_star: f64,
    alpha_1: f64,
    alpha_2: f64,
    alpha_3: f64,
    alpha_4: f64,
    #[serde(rename = "alpha_I")]
    alpha_impulsive: f64,
    alpha_star: f64,
    p1: f64,
    p3: f64,
    p4: f64,
    pu: f64,
}

#[derive(Serialize)]
struct Answer {
    #[serde(rename = "P")]
    force: f64,
    #[serde(rename = "M_p")]
    force_moment: f64,
    #[serde(rename = "U")]
    uplift: f64,
    #[serde(rename = "M_U")]
    uplift_moment: f64,
    buoyant_weight: f64,
    weight_arm: f64,
    #[serde(rename = "SF_sliding")]
    sliding: Option<f64>,
    #[serde(rename = "SF_overturning")]
    overturning: Option<f64>,
    #[serde(rename = "SF_overturning_about_toe")]
    overturning_about_toe: Option<f64>,
    heel_pressure: Option<f64>,
    heel: &'static str,
    resultant_arm: Option<f64>,
    /// P ≤ 0.
    lifted: bool,
    k_eff: Option<f64>,
    k_prime_eff: Option<f64>,
    mode: Option<&'static str>,
    mode_words: Option<&'static str>,
    unique: bool,
    also: Vec<&'static str>,
    motion_si: Option<Onset>,
    first_mode: Option<&'static str>,
    first_load_factor: Option<f64>,
    path: Vec<PathStage>,
    components: Vec<ComponentAnswer>,
}

#[derive(Serialize)]
struct PathStage {
    from: f64,
    to: f64,
    mode: Option<&'static str>,
    also: Vec<&'static str>,
}

#[derive(Serialize)]
struct ComponentAnswer {
    name: String,
    kind: &'static str,
    permanent: bool,
    /// To the right.
    horizontal: f64,
    /// Downwards.
    vertical: f64,
    /// Counter-clockwise about the centre of mass.
    moment: f64,
}

#[derive(Serialize)]
struct LoadAnswer<'a> {
    name: Option<&'a str>,
    force: f64,
    elevation: f64,
    direction: &'static str,
    #[serde(flatten)]
    answer: Answer,
}

pub(in crate::assess) fn render(case: &Case, all: &[Assessed], files: &[String]) -> String {
    let first =
        |one: &&Assessed, two: &&Assessed| one.first_load_factor().total_cmp(&two.first_load_factor());
    let governing = all.iter().min_by(first).expect("a case has a situation");
    let body = &case.body;
    crate::json(&Document {
        title: case.title.as_deref(),
        note: case.note.as_deref(),
        units: UNITS,
        gravity: case.gravity,
        body: LoadedBody {
            body: Body::of(case),
            kinetic_friction: case.kinetic_friction,
            added_mass: case.added_mass.mass,
            centroid_height: body.centroid_height(),
            heel_distance: body.heel_distance(),
            toe_distance: body.toe_distance(),
            moment_of_inertia: body.moment_of_inertia(),
        },
        weight_counted_as: case.weight_words(),
        waves: case.wave.as_ref().map(Waves::of),
        warnings: case.warnings(),
        governing: Answer::of(governing),
        loads: all.iter().filter_map(|assessed| load_answer(case, assessed)).collect(),
        diagrams: files,
    })
}

fn load_answer<'a>(case: &'a Case, assessed: &Assessed) -> Option<LoadAnswer<'a>> {
    let load = &case.loads[assessed.loaded.load?];
    Some(LoadAnswer {
        name: load.name.as_deref(),
        force: load.force.magnitude() / 1e3,
        elevation: load.force.elevation(),
        direction: direction(load.force.direction()),
        answer: Answer::of(assessed),
    })
}

fn symbols(modes: Modes) -> Vec<&'static str> {
    modes.iter().map(Mode::symbol).collect()
}

impl Waves {
    fn of(WaveLoad { choices, goda, .. }: &WaveLoad) -> Waves {
        let Goda { h_13, h_max, deep_water_wavelength, wavelength, h_b, angle_deg, .. } = *goda;
        let Goda { eta_star, h_c_star, alpha_1, alpha_2, alpha_3, alpha_4, .. } = *goda;
        Waves {
            h_13,
            h_max,
            deep_water_wavelength,
            wavelength,
            h_b,
            angle_deg,
            turn_deg: choices.turn_deg,
            impulsive: choices.impulsive,
            lambda: choices.lambda,
            eta_star,
            h_c_star,
            alpha_1,
            alpha_2,
            alpha_3,
            alpha_4,
            alpha_impulsive: goda.alpha_impulsive,
            alpha_star: goda.alpha_star,
            p1: goda.p1 / 1e3,
            p3: goda.p3 / 1e3,
            p4: goda.p4 / 1e3,
            pu: goda.pu / 1e3,
        }
    }
}

impl Answer {
    fn of(assessed: &Assessed) -> Answer {
        let Assessed { full, actions, stability, .. } = assessed;
        let (heel_pressure, heel) = loads::heel_pressure(stability.heel_pressure);
        let departure = assessed.departure();
        // Safety factors of a body that is lifted mean nothing.
        let factor = |factor: f64| (!full.is_lifted()).then_some(factor);
        Answer {
            force: actions.force / 1e3,
            force_moment: actions.force_moment / 1e3,
            uplift: actions.uplift / 1e3,
            uplift_moment: actions.uplift_moment / 1e3,
            buoyant_weight: actions.buoyant_weight / 1e3,
            weight_arm: actions.weight_arm,
            sliding: factor(stability.sliding),
            overturning: factor(stability.overturning),
            overturning_about_toe: factor(stability.overturning_about_toe),
            heel_pressure,
            heel,
            resultant_arm: stability.resultant_arm,
            lifted: full.is_lifted(),
            k_eff: full.effective.map(|reduced| reduced.point.k()),
            k_prime_eff: full.effective.map(|reduced| reduced.point.k_prime()),
            mode: full.mode.map(Mode::symbol),
            mode_words: full.mode.map(Mode::words),
            unique: full.is_unique(),
            also: symbols(full.others()),
            motion_si: full.motion.as_ref().map(Onset::of),
            first_mode: departure.and_then(|stage| stage.mode).map(Mode::symbol),
            first_load_factor: departure.map(|stage| stage.from),
            path: assessed.path.iter().map(PathStage::of).collect(),
            components: assessed.loaded.components.iter().map(ComponentAnswer::of).collect(),
        }
    }
}

impl PathStage {
    fn of(stage: &standfast::contact::path::Stage) -> PathStage {
        let mut others = stage.modes;
        if let Some(mode) = stage.mode {
            others.remove(mode);
        }
        PathStage {
            from: stage.from,
            to: stage.to,
            mode: stage.mode.map(Mode::symbol),
            also: symbols(others),
        }
    }
}

impl ComponentAnswer {
    fn of(component: &Component) -> ComponentAnswer {
        let Component { name, kind, permanent, wrench, .. } = component;
        ComponentAnswer {
            name: name.clone(),
            kind: match kind {
                LoadKind::Weight => "weight",
                LoadKind::Uplift => "uplift",
                LoadKind::Horizontal => "horizontal",
            },
            permanent: *permanent,
            horizontal: wrench.x / 1e3,
            vertical: wrench.p / 1e3,
            moment: wrench.m / 1e3,
        }
    }
}
