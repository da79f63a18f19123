//! How long the planes of a case on ground that fails take, beside that of the same case on rigid ground: what the explorer draws in
//! every frame.
//!
//!     cargo bench -p standfast-cases --bench planes

use std::hint::black_box;
use std::time::Instant;

use standfast::ground::bearing::{BearingPlane, Ground, GroundLaw};
use standfast_cases::assess::screen::load_plane_on_screen;
use standfast_cases::{Assessment, CaseFile};
use standfast_figures::{DiagramContent, KMuPlane, diagram_with};

const RIGID: &str = include_str!("../../../examples/goda-2000.toml");
const SAND: &str = include_str!("../../../examples/goda-on-sand.toml");

const STONE: &str = include_str!("../../../examples/caisson-on-stone.toml");

/// Least time of one of several runs, ms.
fn least(what: &str, mut work: impl FnMut()) -> f64 {
    let run = |_| {
        let begin = Instant::now();
        work();
        begin.elapsed().as_secs_f64()
    };
    let least = 1e3 * (0..40).map(run).fold(f64::INFINITY, f64::min);
    println!("{what:56} {least:10.3} ms");
    least
}

fn load_plane(text: &str) -> impl FnMut() {
    let file = CaseFile::parse("case", text).expect("a case");
    let assessment = Assessment::of_file(&file).expect("an answer");
    move || drop(black_box(load_plane_on_screen(assessment.governing(), "", 2.0, (440.0, 300.0))))
}

fn main() {
    let rigid = least("share of the load and friction, rigid ground", load_plane(RIGID));
    let sand = least("share of the load and friction, sand", load_plane(SAND));
    println!("{:56} {:10.1}", "ratio", sand / rigid);
    let file = CaseFile::parse("case", STONE).expect("a case");
    least("answer, a base that crushes", || drop(black_box(Assessment::of_file(&file))));
    least("share of the load and friction, a base that crushes", load_plane(STONE));
    for (law, angle) in [(GroundLaw::Ec7, 35.0), (GroundLaw::Hansen, 40.0)] {
        let ground = Ground::new(law, angle, 10e3).expect("sand");
        let plane = BearingPlane::new(ground, 0.7, 0.4, 7.5, 2e6).expect("a plane");
        least(&format!("k-mu plane, {}", ground.law_name()), || {
            drop(black_box(diagram_with(&KMuPlane::Failing(plane), &DiagramContent::default())));
        });
    }
}
