//! How long probabilities of a point of the plane and of a caisson take, from the text of the case to the answer.
//!
//!     cargo bench -p standfast-cases --bench probability

use std::hint::black_box;
use std::time::Instant;

use standfast_cases::random::{Effort, Probability, Request};

const PLANE: &str = "[point]\ngamma = 0.8\nk_prime = 0.9167\n[random]\nmu = { normal = { mean = 0.6, sd = 0.1 }, lower = 0 }\n\
                     k = { normal = { mean = 0.45, sd = 0.12 }, lower = 0 }\n";
const CAISSON: &str = include_str!("../../../examples/goda-2000.toml");
const SEA: &str = "[random]\nfriction = { lognormal = { mean = 0.636, cov = 0.15 } }\n\
                   bias.P = { lognormal = { mean = 0.91, cov = 0.19 } }\n\
                   wave.deep_water_height = { gumbel = { mean = \"4.5 m\", sd = \"0.9 m\" }, lower = \"1 m\" }\n";

fn least(what: &str, times: usize, text: &str) {
    let request = Request { effort: Effort { threads: 1, ..Effort::default() }, ..Request::default() };
    let run = |_| {
        let begin = Instant::now();
        drop(black_box(Probability::of_text("case", text, request)));
        begin.elapsed().as_secs_f64()
    };
    let seconds = (0..times).map(run).fold(f64::INFINITY, f64::min);
    println!("{what:42} {:10.2} ms", 1e3 * seconds);
}

fn main() {
    least("point of the plane, two normals", 400, PLANE);
    if std::env::var("PLANE").is_ok() {
        return;
    }
    least("Goda's caisson, three random numbers", 3, &format!("{CAISSON}\n{SEA}"));
}
