//! The convex hull of points.

use std::cmp::Ordering;

use crate::ball::{Ball, Scalar};

/// The places of the points that are vertices of their convex hull, counter-clockwise from the first of them as given; `None` if all lie on a
/// line.
pub(super) fn places<T: Scalar>(points: &[[T; 2]]) -> Option<Vec<usize>> {
    // −0 is 0 here.
    let at = |place: usize| points[place].each_ref().map(|x| x.value() + 0.0);
    let mut sorted: Vec<usize> = (0..points.len()).collect();
    sorted.sort_by(|one, two| {
        let ([x1, z1], [x2, z2]) = (at(*one), at(*two));
        x1.total_cmp(&x2).then(z1.total_cmp(&z2)).then(one.cmp(two))
    });
    let lower = chain(points, sorted.iter().copied());
    let upper = chain(points, sorted.iter().rev().copied());
    // The last of each is the first of the other.
    let mut hull: Vec<usize> = lower[..lower.len().saturating_sub(1)].to_vec();
    hull.extend(&upper[..upper.len().saturating_sub(1)]);
    if hull.len() < 3 {
        return None;
    }
    let first = (0..hull.len()).min_by_key(|place| hull[*place])?;
    hull.rotate_left(first);
    Some(hull)
}

/// The points of one side of the hull, from one end to the other.
fn chain<T: Scalar>(points: &[[T; 2]], sorted: impl Iterator<Item = usize>) -> Vec<usize> {
    let mut chain: Vec<usize> = Vec::new();
    for place in sorted {
        while let [.., before, last] = chain[..] {
            if turn([before, last, place].map(|place| &points[place])) == Ordering::Greater {
                break;
            }
            chain.pop();
        }
        chain.push(place);
    }
    chain
}

/// Which way three points turn, counter-clockwise being greater, decided without rounding.
fn turn<T: Scalar>(points: [&[T; 2]; 3]) -> Ordering {
    let [[x1, z1], [x2, z2], [x3, z3]] = points.map(|point| point.each_ref().map(T::value));
    let [one, two] = [(x2 - x1) * (z3 - z1), (z2 - z1) * (x3 - x1)];
    if (one - two).abs() > 1e-12 * (one.abs() + two.abs()) + f64::MIN_POSITIVE {
        return one.total_cmp(&two);
    }
    let [[x1, z1], [x2, z2], [x3, z3]] = points.map(|point| point.each_ref().map(T::ball));
    let apart = |one: &Ball, two: &Ball| one.clone() - two.clone();
    let cross = apart(&x2, &x1) * apart(&z3, &z1) - apart(&z2, &z1) * apart(&x3, &x1);
    cross.sign().unwrap_or(Ordering::Equal)
}
