//! Linear functions of a few numbers that may not be below zero, and the corners of what meets them.

/// A linear function of several numbers that may not be below zero.
pub(super) struct Constraint {
    pub(super) constant: f64,
    pub(super) factors: Vec<f64>,
    /// Size of its terms.
    pub(super) size: f64,
}

impl Constraint {
    fn holds(&self, at: &[f64]) -> bool {
        let terms = self.factors.iter().zip(at).map(|(factor, number)| factor * number);
        let (sum, size) = terms
            .fold((self.constant, self.size + self.constant.abs()), |(sum, size), term| {
                (sum + term, size + term.abs())
            });
        sum >= -1e-12 * size
    }
}

/// The numbers from zero to their limits that meet constraints, with the least sum of their shares of these.
pub(super) fn least(mut constraints: Vec<Constraint>, limits: &[f64]) -> Option<Vec<f64>> {
    constraints.extend(boxed(limits));
    let mut best: Option<(f64, Vec<f64>)> = None;
    for active in choices(constraints.len(), limits.len()) {
        let rows: Vec<&Constraint> = active.iter().map(|place| &constraints[*place]).collect();
        let Some(found) = meeting(&rows) else { continue };
        if constraints.iter().all(|constraint| constraint.holds(&found)) {
            let shares =
                found.iter().zip(limits).map(|(number, limit)| number / limit.max(f64::MIN_POSITIVE));
            let share: f64 = shares.sum();
            if best.as_ref().is_none_or(|(least, _)| share < *least) {
                best = Some((share, found));
            }
        }
    }
    best.map(|(_, found)| found)
}

/// Each of several numbers from zero to its limit.
pub(super) fn boxed(limits: &[f64]) -> Vec<Constraint> {
    let one = |place: usize, sign: f64| {
        (0..limits.len()).map(|other| if other == place { sign } else { 0.0 }).collect::<Vec<_>>()
    };
    let both = |(place, limit): (usize, &f64)| {
        let zero = Constraint { constant: 0.0, factors: one(place, 1.0), size: *limit };
        [zero, Constraint { constant: *limit, factors: one(place, -1.0), size: 0.0 }]
    };
    limits.iter().enumerate().flat_map(both).collect()
}

/// All choices of so many places of a number.
pub(super) fn choices(of: usize, count: usize) -> Vec<Vec<usize>> {
    if count == 0 {
        return vec![Vec::new()];
    }
    let shorter = choices(of, count - 1).into_iter();
    let longer = shorter.flat_map(|choice| {
        let first = choice.last().map_or(0, |last| last + 1);
        (first..of).map(move |next| [choice.as_slice(), &[next]].concat()).collect::<Vec<_>>()
    });
    longer.collect()
}

/// The numbers at which as many linear functions are zero; `None` where they do not meet in one place.
pub(super) fn meeting(rows: &[&Constraint]) -> Option<Vec<f64>> {
    let count = rows.len();
    let mut table: Vec<Vec<f64>> =
        rows.iter().map(|row| row.factors.iter().copied().chain([-row.constant]).collect()).collect();
    let size =
        table.iter().flat_map(|row| &row[..count]).fold(0.0, |size: f64, factor| size.max(factor.abs()));
    for place in 0..count {
        let pivot = (place..count)
            .max_by(|one, two| table[*one][place].abs().total_cmp(&table[*two][place].abs()))?;
        if table[pivot][place].abs() <= 1e-13 * size {
            return None;
        }
        table.swap(place, pivot);
        for other in 0..count {
            if other != place {
                let by = table[other][place] / table[place][place];
                let row = table[place].clone();
                table[other].iter_mut().zip(row).for_each(|(number, taken)| *number -= by * taken);
            }
        }
    }
    let found: Vec<f64> = (0..count).map(|place| table[place][count] / table[place][place]).collect();
    found.iter().all(|number| number.is_finite()).then_some(found)
}
