//! Sainflou's standing waves and waves on crown walls: published numbers, sums of strips, limits.

use standfast::loads::{Action, Face};
use standfast::wave::{
    Armour, CrownSea, PedersenWall, Sainflou, Sea, StandingWall, VanGentWall, WavePhase, WaveWarning,
    pedersen, sainflou, van_gent,
};
use standfast::{Body, InputError};

const SEA: Sea = Sea {
    water_depth: 14.0,
    sea_bottom_slope: 0.0,
    period: 9.0,
    angle_deg: 0.0,
    water_density: 1030.0,
    gravity: 9.81,
};
const WALL: StandingWall = StandingWall { base_depth: 11.0, crest_height: 6.0, width: 16.0, uplift: true };

/// Equal to six digits.
fn near(found: f64, expected: f64) {
    assert!((found / expected - 1.0).abs() < 5e-6, "{found}, not {expected}");
}

fn wave(phase: WavePhase) -> Sainflou {
    sainflou(&SEA, 4.5, phase, &WALL).unwrap()
}

#[test]
fn crest_and_trough_have_the_numbers_of_the_specification() {
    let crest = wave(WavePhase::Crest);
    near(crest.wavelength, 93.2015);
    near(crest.h0, 0.926197);
    near(crest.p1, 48.0979e3);
    near(crest.p2, 30.7340e3);
    near(crest.pb, 34.4548e3);
    near(crest.force, 584.534e3);
    near(crest.force_moment / crest.force, 7.36698);
    near(crest.uplift, 275.639e3);
    assert_eq!(crest.p4, 0.0);
    let trough = wave(WavePhase::Trough);
    near(trough.p1, -36.1108e3);
    near(trough.pb, -32.2811e3);
    near(trough.force, -318.472e3);
    near(trough.force_moment / trough.force, 4.76205);
    near(trough.uplift, -258.249e3);
    near(trough.uplift_moment, trough.uplift * 16.0 * 2.0 / 3.0);
}

/// Forces and moments are the integrals of the pressures of the formula, strip by strip, cut or not.
#[test]
fn resultants_are_the_sums_of_strips() {
    for (phase, crest_height) in [(WavePhase::Crest, 6.0), (WavePhase::Crest, 2.5), (WavePhase::Trough, 6.0)]
    {
        let wall = StandingWall { crest_height, ..WALL };
        let wave = sainflou(&SEA, 4.5, phase, &wall).unwrap();
        let w = 1030.0 * 9.81;
        let at = |elevation: f64| {
            let depth = 11.0 - elevation;
            match phase {
                WavePhase::Crest if depth < 0.0 => wave.p1 * (1.0 + depth / (4.5 + wave.h0)).max(0.0),
                WavePhase::Crest => wave.p1 + (wave.p2 - wave.p1) * depth / 14.0,
                WavePhase::Trough => {
                    let fall = 4.5 - wave.h0;
                    match depth {
                        depth if depth < 0.0 => 0.0,
                        depth if depth < fall => -w * depth,
                        depth => -w * fall + (wave.p2 + w * fall) * (depth - fall) / (14.0 - fall),
                    }
                }
            }
        };
        let strips = 200_000;
        let step = (11.0 + crest_height) / f64::from(strips);
        let [mut force, mut moment] = [0.0; 2];
        for strip in 0..strips {
            let elevation = (f64::from(strip) + 0.5) * step;
            force += at(elevation) * step;
            moment += at(elevation) * elevation * step;
        }
        near(wave.force, force);
        near(wave.force_moment, moment);
        // And so are those of the loads.
        let body = Body::new(16.0, 11.0 + crest_height, 4e5).unwrap();
        let loads = wave.loads(&body, 11.0);
        let wrench = loads[0].upright(&body, 9.81);
        near(wrench.x, -force);
        near(wrench.m - wrench.x * body.centroid_height(), moment);
        let Action::Pressure { face: Face::Base, .. } = loads[1].action else { panic!() };
        near(-loads[1].upright(&body, 9.81).p, wave.uplift);
    }
}

#[test]
fn what_is_no_standing_wave_is_refused() {
    let error = |sea: Sea, height, phase, wall: StandingWall| -> InputError {
        sainflou(&sea, height, phase, &wall).unwrap_err()
    };
    let (crest, trough) = (WavePhase::Crest, WavePhase::Trough);
    let words = |error: InputError| error.to_string();
    let shallow = StandingWall { base_depth: 3.0, ..WALL };
    assert!(words(error(SEA, 4.5, trough, shallow)).contains("under it"));
    assert!(sainflou(&SEA, 4.5, crest, &shallow).is_ok());
    assert!(words(error(SEA, 4.5, crest, StandingWall { base_depth: 15.0, ..WALL })).contains("the bed"));
    assert!(words(error(Sea { angle_deg: 5.0, ..SEA }, 4.5, crest, WALL)).contains("head on"));
    assert!(words(error(SEA, 40.0, crest, WALL)).contains("steep"));
    let broken = sainflou(&SEA, 11.0, crest, &WALL).unwrap();
    assert!(matches!(broken.warnings[..], [WaveWarning::StandingWaveBreaks { .. }]));
    let steep = sainflou(&Sea { sea_bottom_slope: 0.05, period: 16.0, ..SEA }, 4.5, crest, &WALL).unwrap();
    assert_eq!(steep.warnings.len(), 1);
    assert!(wave(crest).warnings.is_empty());
}

const COAST: CrownSea = CrownSea {
    significant: 4.0,
    period: 8.59106,
    angle_deg: 0.0,
    water_density: 1025.0,
    gravity: 9.81,
    water_depth: None,
};
const ARMOUR: Armour = Armour { slope: 2.0, crest: 4.0 };

#[test]
fn pedersen_has_the_numbers_of_the_specification() {
    let wall = PedersenWall { armour_width: 5.0, protected: 2.0, free: 1.5, volume_share: 1.0, base: 8.0 };
    let wave = pedersen(&COAST, &ARMOUR, &wall).unwrap();
    let terms = wave.pedersen.unwrap();
    near(wave.xi, 2.68369);
    near(wave.run_up, 9.22502);
    near(terms.pm, 52.5389e3);
    near(terms.y_eff, 1.5);
    near(wave.force, 180.088e3);
    near(terms.moment, 346.670e3);
    near(wave.pu, 52.5389e3);
    let names: Vec<_> = wave.warnings().map(|warning| warning.to_string()).collect();
    assert_eq!(
        names,
        ["A_c/B_a = 0.800 is outside 1 to 2.6, the range in which the formula for crown walls was tested"]
    );
    // Waves that do not reach over the armour leave the wall alone.
    let low = pedersen(&CrownSea { significant: 0.5, ..COAST }, &ARMOUR, &wall).unwrap();
    assert_eq!([low.force, low.pu], [0.0; 2]);
    assert!(pedersen(&CrownSea { angle_deg: 10.0, ..COAST }, &ARMOUR, &wall).is_err());
}

#[test]
fn van_gent_has_the_numbers_of_the_toolbox() {
    let wall = VanGentWall { height: 3.5, base: 8.0, freeboard: 1.5, roughness: 0.45 };
    let sea = CrownSea { period: 10.0, ..COAST };
    let wave = van_gent(&sea, &ARMOUR, &wall).unwrap();
    near(wave.run_up, 6.51630);
    near(wave.force, 88.5569e3);
    near(wave.uplift, 43.8574e3);
    assert_eq!(wave.elevation, 1.75);
    // The branches meet.
    let at = |xi: f64| {
        let period = (xi * 2.0).powi(2) * 4.0 * std::f64::consts::TAU / 9.81;
        van_gent(&CrownSea { period: period.sqrt(), ..COAST }, &ARMOUR, &wall).unwrap().run_up
    };
    assert!((at(1.7239) - at(1.7241)).abs() < 1e-3);
    // Oblique waves run up less: half of it along the wall.
    let aside = van_gent(&CrownSea { angle_deg: 90.0, ..sea }, &ARMOUR, &wall).unwrap();
    near(aside.run_up, wave.run_up / 2.0);
    // A base as high as the armour is not lifted.
    let high = van_gent(&sea, &ARMOUR, &VanGentWall { freeboard: 4.0, ..wall }).unwrap();
    assert_eq!(high.uplift, 0.0);
    let body = Body::new(8.0, 3.5, 3e4).unwrap();
    let loads = wave.loads(&body);
    near(loads[0].upright(&body, 9.81).x, -88.5569e3);
    near(-loads[1].upright(&body, 9.81).p, 43.8574e3);
}
