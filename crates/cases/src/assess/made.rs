//! Loads that the program makes of what a case says, one by one, with the formulas that they come from.

mod waves;

use serde::Serialize;
use standfast::loads::LoadSource;
use standfast::loads::earth::{EarthPoint, EarthState};

use super::Assessed;
use super::soil::{self, resultant, side};
use crate::case::{Case, Made, SoilFill};
use crate::key::Table;

/// A load that the program makes.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MadeLoad {
    /// Its name, by which combinations have it.
    pub name: String,
    /// The table that it is made of.
    pub from: String,
    /// Name of the formula.
    pub formula: &'static str,
    /// Source of the formula.
    pub source: &'static str,
    /// True if that was read, rather than recalled.
    pub source_read: bool,
    /// Of each layer.
    pub coefficients: Vec<MadeCoefficients>,
    /// Pressures along faces, from the base up.
    pub diagrams: Vec<MadeDiagram>,
    /// What pushes, towards the body, N per metre run, or of the whole.
    pub force_h: f64,
    /// What acts downwards.
    pub force_v: f64,
    /// Height above the base at which it pushes, m.
    pub elevation: f64,
    /// Ranges of the formula.
    pub ranges: Vec<MadeRange>,
}

/// Coefficients of a layer; null of one that the load does not have.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct MadeCoefficients {
    /// Of the soil at rest of the ground.
    #[serde(rename = "K")]
    pub k: Option<f64>,
    /// In an earthquake, above the water; below it of a layer that is all wet.
    #[serde(rename = "K_E")]
    pub k_e: Option<f64>,
    /// The angle by which gravity is turned for it, degrees.
    pub psi_deg: Option<f64>,
    /// The same below the water, of a layer that has both.
    #[serde(rename = "K_E_wet", skip_serializing_if = "Option::is_none")]
    pub k_e_wet: Option<f64>,
    /// The angle below the water.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub psi_wet_deg: Option<f64>,
}

/// A pressure along a face.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MadeDiagram {
    /// The face.
    pub face: &'static str,
    /// Heights above the base, m; empty of the base.
    pub elevation: Vec<f64>,
    /// Against the upright, Pa.
    pub pressure: Vec<f64>,
    /// Distances to the right of O, m, along the base in place of heights.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub distance: Vec<f64>,
    /// Down the face, per metre of height, Pa.
    pub tangential: Vec<f64>,
}

/// A number of a formula beside the range in which it was tested.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MadeRange {
    /// Its name.
    pub name: &'static str,
    /// Its value.
    pub value: f64,
    /// The lower end.
    pub low: f64,
    /// The upper end.
    pub high: f64,
    /// True if it lies between.
    pub inside: bool,
}

/// Source of what is taken from one manual.
const UFC: &str = "UFC 3-220-20 (2025), chapter 4";

/// The loads that are made of a case and act in a situation.
pub fn made_loads(case: &Case, assessed: &Assessed) -> Vec<MadeLoad> {
    let acts = |name: &str| assessed.situation.loads().iter().any(|load| load.name.as_deref() == Some(name));
    let mut made = Vec::new();
    for (index, fill) in case.soils.iter().enumerate() {
        let all = of_soil(case, assessed, index, fill);
        made.extend(all.into_iter().filter(|load| acts(&load.name)));
    }
    let case = case.under(assessed.acting);
    if let Some(wave) = &case.wave {
        let acts = |source| assessed.situation.loads().iter().any(|load| load.source == source);
        let of_waves =
            [LoadSource::WavePressure, LoadSource::WaveUplift].into_iter().zip(waves::made(case, wave));
        made.extend(of_waves.filter(|(source, _)| acts(*source)).map(|(_, load)| load));
    }
    made
}

fn of_soil(case: &Case, assessed: &Assessed, index: usize, fill: &SoilFill) -> Vec<MadeLoad> {
    let SoilFill { soil, pressure, .. } = fill;
    let along = soil::along(case);
    let load = |name: &str, formula, points: &[EarthPoint], coefficients: Vec<MadeCoefficients>| {
        let [push, elevation, drag] = resultant(points);
        let of = |of: fn(&EarthPoint) -> f64| points.iter().map(of).collect();
        MadeLoad {
            name: name.to_owned(),
            from: Table::Backfill.path(index),
            formula,
            source: UFC,
            source_read: true,
            coefficients,
            diagrams: vec![MadeDiagram {
                face: side(soil.face),
                elevation: of(|point| point.elevation),
                distance: Vec::new(),
                pressure: of(|point| point.normal),
                tangential: of(|point| point.tangential),
            }],
            force_h: push * along,
            force_v: drag * along,
            elevation,
            ranges: Vec::new(),
        }
    };
    let still = || {
        let of = |k: f64| MadeCoefficients { k: Some(k), ..MadeCoefficients::default() };
        pressure.coefficients.iter().map(|coefficients| of(coefficients.k)).collect::<Vec<_>>()
    };
    let formula = match soil.state {
        EarthState::Active => "coulomb",
        EarthState::AtRest => "jaky",
        // What resists is no load.
        EarthState::Passive => return Vec::new(),
    };
    let mut loads = vec![load(&fill.name, formula, &pressure.soil, still())];
    if !pressure.surcharge.is_empty() {
        loads.push(load(fill.made(Made::Surcharge), formula, &pressure.surcharge, still()));
    }
    let shaken = assessed.earthquake.as_ref().and_then(|earthquake| fill.increment(earthquake, case.gravity));
    if let Some(increment) = shaken {
        let of = |(coefficients, [dry, wet]): (MadeCoefficients, &[Option<[f64; 2]>; 2])| {
            let first = dry.or(*wet);
            let second = wet.filter(|_| dry.is_some());
            MadeCoefficients {
                k_e: first.map(|[k, _]| k),
                psi_deg: first.map(|[_, ψ]| ψ),
                k_e_wet: second.map(|[k, _]| k),
                psi_wet_deg: second.map(|[_, ψ]| ψ),
                ..coefficients
            }
        };
        let coefficients = still().into_iter().zip(&increment.coefficients).map(of).collect();
        let formula = if soil.state == EarthState::AtRest { "wood" } else { "mononobe-okabe" };
        loads.push(load(fill.made(Made::Earthquake), formula, &increment.points, coefficients));
        if let Some([force, elevation]) = increment.pore_water {
            let mut pore = load(&fill.pore_water(), "westergaard", &[], Vec::new());
            pore.diagrams.clear();
            (pore.force_h, pore.elevation) = (force * along, elevation);
            loads.push(pore);
        }
    }
    loads
}
