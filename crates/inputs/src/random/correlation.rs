//! Correlations of random numbers, as they are written.

use std::ops::Range as Span;

use standfast_probability::copula::CorrelationMeasure;

use super::{Item, Random, RandomProblem, ReadResult, in_order, number, table, wrong};
use crate::digits::digits;

/// Reads `[[random.correlation]]`: of each entry a number for two names, or a matrix for several.
pub(super) fn read(item: &Item<'_>, random: &mut Random) -> ReadResult<()> {
    const EXPECTED: &str = "one table for each pair or matrix, under [[random.correlation]]";
    let list = item.get_ref().as_array().ok_or_else(|| wrong(item, "`correlation`", EXPECTED))?;
    for entry in list.iter() {
        let table = table(entry, "`correlation`", EXPECTED)?;
        let (mut names, mut measure) = (None, None);
        for (key, value) in in_order(table) {
            let of: fn(f64) -> CorrelationMeasure = match key {
                "between" => {
                    names = Some(read_names(value, random)?);
                    continue;
                }
                "rank" => CorrelationMeasure::Rank,
                "linear" => CorrelationMeasure::Linear,
                "normal" => CorrelationMeasure::Normal,
                _ => {
                    let allowed = ["between", "rank", "linear", "normal"].map(str::to_owned).to_vec();
                    let what = "[[random.correlation]]".to_owned();
                    return Err((RandomProblem::Name { what, name: key.to_owned(), allowed }, value.span()));
                }
            };
            if measure.replace((key, of, value)).is_some() {
                let message =
                    "[[random.correlation]] has two measures; expected one of `rank`, `linear` and `normal`";
                return Err((RandomProblem::Other(message.to_owned()), value.span()));
            }
        }
        let (Some(names), Some((key, of, value))) = (&names, measure) else {
            let lacks = if names.is_none() {
                "`between`, two names or more"
            } else {
                "`rank`, `linear` or `normal`, a number"
            };
            let message = format!("[[random.correlation]] lacks {lacks}");
            return Err((RandomProblem::Other(message), entry.span()));
        };
        let mut add = |first: usize, second: usize, value: f64, span: Span<usize>| {
            random.correlations.push((first, second, of(value)));
            random.correlation_spans.push(span);
        };
        if let ([first, second], None) = (&names[..], value.get_ref().as_array()) {
            add(*first, *second, number(value, &format!("`{key}`"))?, entry.span());
            continue;
        }
        for (row, column, rho, span) in read_matrix(value, key, names.len())? {
            add(names[row], names[column], rho, span);
        }
    }
    Ok(())
}

/// An entry of a matrix: row, column, value and place.
type Entry = (usize, usize, f64, Span<usize>);

/// What lies above the diagonal of a matrix of correlations.
fn read_matrix(item: &Item<'_>, key: &str, count: usize) -> ReadResult<Vec<Entry>> {
    let what = format!("`{key}`");
    let wrong_size = || {
        let expected =
            format!("a matrix of {count} rows with {count} numbers each, as many as there are names");
        wrong(item, &what[..], expected)
    };
    let rows = item.get_ref().as_array().filter(|rows| rows.len() == count).ok_or_else(wrong_size)?;
    let mut matrix: Vec<Vec<(f64, Span<usize>)>> = Vec::with_capacity(count);
    for row in rows.iter() {
        let row = row.get_ref().as_array().filter(|row| row.len() == count).ok_or_else(wrong_size)?;
        let numbers = row.iter().map(|item| Ok((number(item, &what)?, item.span())));
        matrix.push(numbers.collect::<ReadResult<_>>()?);
    }
    let mut found = Vec::new();
    for (i, row) in matrix.iter().enumerate() {
        for (j, (rho, span)) in row.iter().enumerate() {
            let (other, _) = matrix[j][i];
            let expected = if i == j && *rho != 1.0 {
                "1, as of every number with itself".to_owned()
            } else if *rho != other {
                format!(
                    "{}, as in row {} and column {}: both sides of the diagonal alike",
                    digits(other),
                    j + 1,
                    i + 1
                )
            } else {
                continue;
            };
            let what = format!("row {} and column {} of `{key}`", i + 1, j + 1);
            return Err((RandomProblem::Value { what, written: digits(*rho), expected }, span.clone()));
        }
        found.extend(row.iter().enumerate().skip(i + 1).map(|(j, (rho, span))| (i, j, *rho, span.clone())));
    }
    Ok(found)
}

/// The places of random numbers by their names, two or more.
fn read_names(item: &Item<'_>, random: &Random) -> ReadResult<Vec<usize>> {
    let wrong = || wrong(item, "`between`", "two names or more in a list");
    let list = item.get_ref().as_array().filter(|list| list.len() >= 2).ok_or_else(wrong)?;
    let place = |value: &Item<'_>| {
        let name = value.get_ref().as_str().ok_or_else(wrong)?;
        random.named.iter().position(|named| named.name == name).ok_or_else(|| {
            let allowed = random.named.iter().map(|named| named.name.clone()).collect();
            let what = "[random]".to_owned();
            (RandomProblem::Name { what, name: name.to_owned(), allowed }, value.span())
        })
    };
    list.iter().map(place).collect()
}
