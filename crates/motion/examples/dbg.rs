//! x
use standfast::contact::Block;
use standfast_motion::*;
fn main() {
    for (γ, μ) in [(3.0_f64, 0.5), (3.0, 0.2), (1.5, 0.3), (2.0, 0.36), (2.0, 0.1)] {
        let mut problem = Problem::new(Block::uniform(γ, 50.0), 1.0);
        problem.mu_impact = Some(μ);
        problem.initial.theta = 0.1;
        problem.t_max = Some(30.0);
        let o = simulate(&problem, Keep { steps: true }).unwrap();
        println!("{γ} {μ} {:?} {} {} slide {} res {} {}", o.end, o.max_theta, o.t_max_theta, o.slide, o.energy_residual(), o.impacts);
        for e in o.events.iter().take(12) { println!("   {:?}", e); }
    }
}
