//! A minimum without gradients.

use crate::form::distance;

/// One round of Nelder and Mead's simplex about a point, at most so large, with the coefficients of Gao and Han for many dimensions
/// (Computational Optimization and Applications 51, 2012).
pub(crate) fn simplex(f: &mut impl FnMut(&[f64]) -> f64, about: &[f64], size: f64) -> (f64, Vec<f64>) {
    let n = about.len();
    let mut corners: Vec<(f64, Vec<f64>)> = vec![(f(about), about.to_vec())];
    for i in 0..n {
        let mut corner = about.to_vec();
        corner[i] += size;
        corners.push((f(&corner), corner));
    }
    if n == 0 {
        return corners.swap_remove(0);
    }
    let m = (n as f64).max(2.0);
    let (expand, contract, shrink) = (1.0 + 2.0 / m, 0.75 - 0.5 / m, 1.0 - 1.0 / m);
    for _ in 0..400 * n {
        corners.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (least, greatest) = (corners[0].0, corners[n].0);
        let wide = corners[1..].iter().map(|corner| distance(&corner.1, &corners[0].1)).fold(0.0, f64::max);
        if greatest - least <= 1e-15 * least || wide < 1e-12 {
            break;
        }
        let centre: Vec<f64> =
            (0..n).map(|i| corners[..n].iter().map(|c| c.1[i]).sum::<f64>() / n as f64).collect();
        let worst = corners[n].1.clone();
        let mut along = |step: f64| {
            let v: Vec<f64> = centre.iter().zip(&worst).map(|(c, w)| c + step * (c - w)).collect();
            (f(&v), v)
        };
        let reflected = along(1.0);
        let taken = if reflected.0 < least {
            let expanded = along(expand);
            Some(if expanded.0 < reflected.0 { expanded } else { reflected })
        } else if reflected.0 < corners[n - 1].0 {
            Some(reflected)
        } else {
            let (contracted, bound) = if reflected.0 < greatest {
                (along(contract), reflected.0)
            } else {
                (along(-contract), greatest)
            };
            (contracted.0 < bound).then_some(contracted)
        };
        if let Some(corner) = taken {
            corners[n] = corner;
            continue;
        }
        let best = corners[0].1.clone();
        for corner in &mut corners[1..] {
            let v: Vec<f64> = best.iter().zip(&corner.1).map(|(b, c)| b + shrink * (c - b)).collect();
            *corner = (f(&v), v);
        }
    }
    corners.into_iter().min_by(|a, b| a.0.total_cmp(&b.0)).expect("a simplex has corners")
}
