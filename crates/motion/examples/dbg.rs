//! x
#[path = "../tests/common/mod.rs"]
mod common;
use standfast_motion::*;
fn main() {
    let args: Vec<u64> = std::env::args().skip(1).map(|a| a.parse().unwrap()).collect();
    if args.len() == 1 {
        let problem = common::problem(&mut common::Random::new(args[0]));
        println!("{problem:?}");
        let o = simulate(&problem, Keep { steps: true }).unwrap();
        println!("{:?} theta {} {} slide {} res {:e} n {}", o.end, o.max_theta, o.t_max_theta, o.slide, o.energy_residual(), o.impacts);
        for e in o.events.iter().take(60) { println!("   {:?}", e); }
        return;
    }
    let mut ends = [0; 5];
    let mut nonunique = 0;
    let start = std::time::Instant::now();
    for seed in args[0]..args[1] {
        let problem = common::problem(&mut common::Random::new(seed));
        let o = simulate(&problem, Keep { steps: false }).unwrap();
        ends[o.end as usize] += 1;
        nonunique += usize::from(!o.unique);
        let largest = [o.work, o.friction_loss, o.impact_loss, o.potential, o.kinetic].into_iter().fold(1e-6, |m: f64, t| m.max(t.abs()));
        if o.energy_residual().abs() > 1e-11 * largest || (matches!(o.end, End::NoContinuation | End::TooManyEvents) && !matches!(problem.impact, Impact::Ratio(_))) || o.impacts > 500 {
            println!("{seed} {:?} res {:e} impacts {} events {} t {}", o.end, o.energy_residual() / largest, o.impacts, o.events.len(), o.t_final);
        }
    }
    println!("{ends:?} nonunique {nonunique} {:?}", start.elapsed());
}
