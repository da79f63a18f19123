//! Whole motions against time stepping: Moreau's and Jean's scheme, which knows no events and no states, only impulses at two corners.

mod common;

use common::Random;
use common::stepping::stepped;
use standfast_motion::{Impact, Keep, simulate};

/// The time stepping errs by what its steps are, and by more where an impact falls the other way; so the distribution is asked for.
#[test]
fn time_stepping_comes_to_the_same() {
    const END: f64 = 6.0;
    let (mut errors, mut over) = (Vec::new(), [0, 0]);
    for seed in 0..260 {
        let mut problem = common::problem(&mut Random::new(seed));
        problem.impact = Impact::Inelastic;
        problem.block.mu_s = problem.block.mu_k;
        problem.t_max = Some(END);
        let outcome = simulate(&problem, Keep { steps: true }).unwrap();
        let (two, far) = (stepped(&problem, END, 1e-3), outcome.max_theta > 1.39);
        match two {
            None => over[usize::from(!far)] += 1,
            Some(_) if far => over[1] += 1,
            Some([x, θ, largest]) => {
                let at = outcome.at(END.min(outcome.t_final)).unwrap();
                let differ = [at.x - x, at.theta - θ, outcome.max_theta - largest];
                // A body that only rests is no witness.
                if outcome.events.len() > 2 {
                    errors.push((differ.into_iter().fold(0.0, |most: f64, e| most.max(e.abs())), seed));
                }
            }
        }
    }
    errors.sort_by(|one, two| one.0.total_cmp(&two.0));
    let share =
        |limit: f64| errors.iter().filter(|(error, _)| *error < limit).count() as f64 / errors.len() as f64;
    let worst: Vec<_> = errors.iter().rev().take(12).collect();
    assert!(errors.len() >= 170 && over[0] >= 15, "{} {over:?}", errors.len());
    assert!(over[1] == 0, "{over:?}");
    assert!(errors[errors.len() / 2].0 < 2e-4, "median {:?}", errors[errors.len() / 2]);
    assert!(share(1e-2) > 0.98, "{} {worst:?}", share(1e-2));
}
