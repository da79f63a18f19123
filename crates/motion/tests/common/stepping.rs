//! Moreau's and Jean's time stepping, which knows no events and no states, only impulses at two corners.
#![allow(dead_code)]

use standfast::contact::Block;
use standfast_motion::MotionProblem;

/// The pose after a time, by steps of `h`, and the largest |θ| on the way; `None` once it is over a quarter turn.
pub fn stepped(problem: &MotionProblem, end: f64, h: f64) -> Option<[f64; 3]> {
    let Block { b1, b2, d, rho2, m_x, m_y, mu_k, .. } = problem.block;
    let mass = [m_x, m_y, rho2];
    let (mut q, mut v) = ([0.0, d, 0.0], [0.0; 3]);
    let mut impulses = [[0.0; 2]; 2];
    let mut largest: f64 = 0.0;
    let steps = (end / h).round() as usize;
    for step in 0..steps {
        let t = (step as f64 + 0.5) * h;
        let middle = [0, 1, 2].map(|i| q[i] + 0.5 * h * v[i]);
        let (sin, cos) = f64::sin_cos(middle[2]);
        let mut force = [0.0, -problem.gravity, 0.0];
        for load in &problem.loads {
            let f = load.history.at(t);
            let turned = |[x, y]: [f64; 2]| [x * cos - y * sin, x * sin + y * cos];
            let (r, u) =
                (turned(load.at), if load.follows { turned(load.direction) } else { load.direction });
            force = [force[0] + f * u[0], force[1] + f * u[1], force[2] + f * (r[0] * u[1] - r[1] * u[0])];
        }
        force[0] -= problem.base.horizontal.as_ref().map_or(0.0, |base| base.at(t));
        force[1] -= problem.base.vertical.as_ref().map_or(0.0, |base| base.at(t));
        let mut next = [0, 1, 2].map(|i| v[i] + h * force[i] / mass[i]);
        // Corners that would be in the base at the middle of the step.
        let levers = [-b1, b2].map(|r| [r * cos + d * sin, d * cos - r * sin]);
        let active = levers.map(|[_, depth]| middle[1] - depth <= 0.0);
        for (k, [c, depth]) in levers.into_iter().enumerate() {
            let [along, up] = if active[k] { impulses[k] } else { [0.0, 0.0] };
            impulses[k] = [along, up];
            next[0] += along / m_x;
            next[1] += up / m_y;
            next[2] += (c * up + depth * along) / rho2;
        }
        for _ in 0..200 {
            let mut change: f64 = 0.0;
            for (k, [c, depth]) in levers.into_iter().enumerate().filter(|(k, _)| active[*k]) {
                let [mut along, mut up] = impulses[k];
                let was = [along, up];
                up = (up - (next[1] + c * next[2]) / (1.0 / m_y + c * c / rho2)).max(0.0);
                let moved = up - was[1];
                next[1] += moved / m_y;
                next[2] += c * moved / rho2;
                let slip = next[0] + depth * next[2];
                along = (along - slip / (1.0 / m_x + depth * depth / rho2)).clamp(-mu_k * up, mu_k * up);
                let pulled = along - was[0];
                next[0] += pulled / m_x;
                next[2] += depth * pulled / rho2;
                impulses[k] = [along, up];
                change = change.max(moved.abs()).max(pulled.abs());
            }
            if change < 1e-13 {
                break;
            }
        }
        q = [0, 1, 2].map(|i| q[i] + 0.5 * h * (v[i] + next[i]));
        v = next;
        largest = largest.max(q[2].abs());
        if q[2].abs() > 1.4 {
            return None;
        }
    }
    Some([q[0], q[2], largest])
}
