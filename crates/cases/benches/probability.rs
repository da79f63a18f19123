//! How long probabilities of a point of the plane and of a caisson take, from the text of the case to the answer.
//!
//!     cargo bench -p standfast-cases --bench probability

use std::hint::black_box;
use std::time::Instant;

use standfast::Mode;
use standfast_cases::CaseFile;
use standfast_cases::random::{ChanceProblem, ChanceRequest, Effort, Probability};
use standfast_probability::integrate::{Within, integrate};

const PLANE: &str = "[point]\ngamma = 0.8\nk_prime = 0.9167\n[random]\nmu = { normal = { mean = 0.6, sd = 0.1 }, lower = 0 }\n\
                     k = { normal = { mean = 0.45, sd = 0.12 }, lower = 0 }\n";
const CAISSON: &str = include_str!("../../../examples/goda-2000.toml");
const SEA: &str = "[random]\nfriction = { lognormal = { mean = 0.636, cov = 0.15 } }\n\
                   bias.P = { lognormal = { mean = 0.91, cov = 0.19 } }\n\
                   wave.deep_water_height = { gumbel = { mean = \"4.5 m\", sd = \"0.9 m\" }, lower = \"1 m\" }\n";

fn least(what: &str, times: usize, mut work: impl FnMut()) {
    let run = |_| {
        let begin = Instant::now();
        work();
        begin.elapsed().as_secs_f64()
    };
    let seconds = (0..times).map(run).fold(f64::INFINITY, f64::min);
    println!("{what:56} {:10.3} ms", 1e3 * seconds);
}

fn all(text: &str) {
    let request =
        ChanceRequest { effort: Effort { threads: 1, ..Effort::default() }, ..ChanceRequest::default() };
    let file = CaseFile::parse("case", text).expect("a case");
    drop(black_box(Probability::of(&file, request)));
}

fn main() {
    let problem =
        ChanceProblem::of_file(&CaseFile::parse("case", PLANE).expect("a point")).expect("a point").remove(0);
    let modes: Vec<u64> = Mode::ALL.into_iter().map(|mode| 1 << mode.code()).collect();
    let slide_rock = [1 << Mode::SlideRockOLeft.code()];
    let of = |sets: &[u64]| drop(black_box(integrate(problem.laws(), &problem, sets, Within::ALL_DIGITS)));
    least("point of the plane, two normals: SRO- alone", 200, || of(&slide_rock));
    least("point of the plane: all modes", 200, || of(&modes));
    least("point of the plane: the whole answer, of its text", 200, || all(PLANE));
    let caisson = format!("{CAISSON}\n{SEA}");
    least("Goda's caisson, three random numbers: the whole answer", 3, || all(&caisson));
}
