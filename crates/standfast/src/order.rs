//! Order of things by a number of each.
//!
//! Lists of many kinds are put in order by a number. A sort of numbers with their places is compiled once for all of them, where one that compares
//! the things themselves is compiled for each kind.

/// Puts a list in rising order of a number of each; what has the same number keeps its order.
///
/// ```
/// let mut joints = [("crest", 9.0), ("toe", 0.0), ("berm", 3.5)];
/// standfast::order::by_number(&mut joints, |joint| joint.1);
/// assert_eq!(joints.map(|joint| joint.0), ["toe", "berm", "crest"]);
/// ```
pub fn by_number<T>(list: &mut [T], number: impl Fn(&T) -> f64) {
    let places = rising(list.iter().map(number).collect());
    for to in 0..list.len() {
        // What stood there may have been put farther back already.
        let mut from = places[to];
        while from < to {
            from = places[from];
        }
        list.swap(to, from);
    }
}

/// The places of numbers in rising order.
fn rising(numbers: Vec<f64>) -> Vec<usize> {
    let mut order: Vec<(f64, usize)> =
        numbers.into_iter().enumerate().map(|(place, number)| (number, place)).collect();
    order.sort_by(|one, two| one.0.total_cmp(&two.0));
    order.into_iter().map(|(_, place)| place).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As the sort of the standard library that keeps what is equal in order.
    #[test]
    fn lists_are_in_the_order_of_a_stable_sort() {
        let mut seed = 1u64;
        for length in 0..200 {
            let mut list: Vec<(u64, usize)> = (0..length)
                .map(|place| {
                    seed =
                        seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                    (seed >> 60, place)
                })
                .collect();
            let mut expected = list.clone();
            expected.sort_by_key(|one| one.0);
            by_number(&mut list, |one| one.0 as f64);
            assert_eq!(list, expected);
            expected.sort_by_key(|one| std::cmp::Reverse(one.0));
            by_number(&mut list, |one| -(one.0 as f64));
            assert_eq!(list, expected);
        }
    }
}
