//! Loads that act in a situation, and the others that were tried, for reading.

use standfast::{Slip, Stability, Verdict};

use super::{Assessed, Assessment, combination, joints, plan, verdict};
use crate::case::{Acting, Case, Direction, PointForce};
use crate::key::Table;
use crate::layout::{columns, digits, paragraph, row};
use crate::units::Dimension;

/// One line for each situation, the worst first.
pub(super) fn summary(assessment: &Assessment) -> String {
    let case = &assessment.case;
    let alone = case.combinations.is_empty();
    let mut rows = match alone {
        true => vec![
            row!["", "force", "at"],
            row!["load", case.output.symbol(Dimension::Force), case.output.symbol(Dimension::Length)],
        ],
        false => vec![row!["", ""], row!["", "combination"]],
    };
    rows[0].extend(row!["", "SF", "SF", "leaves", "", ""]);
    rows[1].extend(row!["mode", "slide", "turn", "rest at", "into", "unique"]);
    rows.extend(assessment.worst_first().into_iter().map(|assessed| {
        let mut row = match assessed.acting {
            Acting::Combination(index) => row![(index + 1).to_string()],
            _ => Vec::new(),
        };
        row.push(assessment.name(assessed).unwrap_or_default());
        if let Acting::Alone(index) = assessed.acting {
            let PointForce { magnitude, direction, elevation, distance, .. } = &case.forces[index];
            let length = |x: f64| case.output.value(Dimension::Length, x);
            let at = match (direction, distance) {
                (Direction::Turning(_), _) => "couple".to_owned(),
                (Direction::Sideways(_), _) | (_, None) => length(*elevation),
                (_, Some(distance)) => format!("{} from O", length(*distance)),
            };
            let dimension = match direction {
                Direction::Turning(_) => Dimension::Moment,
                _ => Dimension::Force,
            };
            row.extend(row![case.output.value(dimension, *magnitude), at]);
        }
        row.extend(results(assessed));
        row
    }));
    let numbers: &[usize] = if alone { &[1, 2, 4, 5, 6] } else { &[0, 3, 4, 5] };
    columns(&rows, 2, numbers)
}

/// Mode, safety factors, departure and uniqueness, in the cells of a row; on joints the least factors, and the joint that leaves rest first.
fn results(assessed: &Assessed) -> Vec<String> {
    let least = |of: fn(&Stability) -> f64| {
        let factors = assessed.on_joints().map(|on| match on.outcome.full.is_lifted() {
            true => None,
            false => Some(of(&on.outcome.stability)),
        });
        let least = factors.reduce(|least, next| Some(least?.min(next?))).flatten();
        least.map_or_else(|| "none".to_owned(), |factor| assessed.output.factor(factor))
    };
    let first = joints::first_words(assessed);
    row![
        match &assessed.joints {
            Some(joints) => joints::symbols(assessed, joints),
            None => assessed.verdict().map_or("none", Verdict::symbol).to_owned(),
        },
        least(|stability| stability.sliding),
        least(Stability::overturning),
        verdict::departure_word(&assessed.departure()),
        first.unwrap_or_else(|| {
            let on_plan = assessed.outcome.plan.as_ref().map(|answer| plan::symbols(&answer.departure));
            let in_plane = || assessed.departure().verdict().map(|verdict| verdict.symbol().to_owned());
            on_plan.or_else(in_plane).unwrap_or_default()
        }),
        match assessed.is_unique() {
            Some(true) => "yes",
            Some(false) => "no",
            None => "–",
        },
    ]
}

/// The title of a situation: its load or combination, with its number where there are several, and its name; `None` where the
/// case leaves no choice.
pub fn situation_title(assessment: &Assessment, assessed: &Assessed) -> Option<String> {
    let (what, index, name) = match assessed.acting {
        Acting::All => return None,
        Acting::Alone(index) => {
            let force = &assessment.case.forces[index];
            let what = if force.of.0 == Table::Moment { "Moment" } else { "Load" };
            (what, force.of.1, &force.name)
        }
        Acting::Combination(index) => ("Combination", index, &assessment.case.combinations[index].name),
    };
    let number = if assessment.all.len() > 1 { format!(" {}", index + 1) } else { String::new() };
    let name = name.as_ref().map_or(String::new(), |name| format!(": {name}"));
    Some(format!("{what}{number}{name}"))
}

/// The title of a situation, with the force that acts alone, or the factors of the combination.
pub(super) fn heading(assessment: &Assessment, assessed: &Assessed) -> String {
    let case = &assessment.case;
    let details = match assessed.acting {
        Acting::All => return String::new(),
        Acting::Alone(index) => columns(&point_force(case, &case.forces[index]), 2, &[]),
        Acting::Combination(index) => {
            let left_out = case.left_out(index);
            let rest = match left_out.is_empty() {
                true => String::new(),
                false => paragraph(&format!("not acting: {}", left_out.join(", ")), 2),
            };
            let combination = &case.combinations[index];
            let changes = combination::changes(case, index).into_iter();
            let changes: String =
                changes.map(|(key, words)| paragraph(&format!("{key}: {words}"), 2)).collect();
            changes + &paragraph(&format!("factors: {}", combination::factors(combination)), 2) + &rest
        }
    };
    let title = situation_title(assessment, assessed).unwrap_or_default();
    paragraph(&title, 0) + &details + "\n"
}

fn point_force(case: &Case, force: &PointForce) -> Vec<Vec<String>> {
    if let Direction::Turning(side) = force.direction {
        let way = if side == Slip::Left { "↺ counter-clockwise" } else { "↻ clockwise" };
        return vec![row!["couple M", format!("{} {way}", case.output.moment(force.magnitude))]];
    }
    let (arrow, towards) = match force.direction.word() {
        "left" => ("←", "to the left"),
        "right" => ("→", "to the right"),
        "down" => ("↓", "downwards"),
        _ => ("↑", "upwards"),
    };
    let turned = force.across.as_ref().and_then(|across| across.direction_deg);
    let towards = match turned {
        Some(degrees) => plan::direction_words(degrees.rem_euclid(360.0)),
        None => format!("{arrow} {towards}"),
    };
    let mut rows = vec![row!["force F", format!("{} {towards}", case.output.force(force.magnitude))]];
    match (force.direction, force.distance) {
        (Direction::Sideways(_), _) | (_, None) => {
            let above = force.elevation - case.body.centroid_height();
            let side = if above < 0.0 { "below" } else { "above" };
            let centre = format!("{} {side} the centre of mass", case.output.length(above.abs()));
            rows.push(row![
                "elevation",
                format!("{} above the base, {centre}", case.output.length(force.elevation))
            ]);
        }
        (_, Some(distance)) => {
            rows.push(row!["distance", format!("{} right of O", case.output.length(distance))])
        }
    }
    if let Some(z) = force.across.as_ref().map(|across| across.z).filter(|z| *z != 0.0) {
        rows.push(row!["along the length", format!("{} away from its middle", case.output.length(z))]);
    }
    if let Some(lever) = &force.lever {
        rows.push(row!["on", lever.clone()]);
    }
    rows
}

/// Note on the loads that act beside others.
pub(super) fn notes(case: &Case, assessed: &Assessed) -> String {
    let words = match assessed.acting {
        Acting::Alone(_) if case.forces.iter().filter(|force| force.acts_alone()).count() > 1 => {
            "Of the forces that act alone, each is an alternative to the others; all other loads act beside it.".to_owned()
        }
        Acting::Combination(_) => {
            "Of the loads that the combination does not name, the permanent ones act as they are, the variable ones not \
             at all."
                .to_owned()
        }
        _ => return String::new(),
    };
    paragraph(&words, 2)
}

/// The ways in which a situation was tried, the one reported first: accelerations of the base, factors of pairs.
pub(super) fn tried(case: &Case, assessed: &Assessed) -> String {
    if assessed.others.is_empty() {
        return String::new();
    }
    let pairs = |assessed: &Assessed| combination::pairs(case, assessed.acting, assessed.trial);
    let of_pairs = pairs(assessed);
    let (is_shaken, under) = (assessed.earthquake.is_some(), case.under(assessed.acting));
    let on_plan = assessed.outcome.plan.is_some();
    let mut rows = vec![Vec::new(), Vec::new()];
    for (name, _) in &of_pairs {
        rows[0].push((*name).to_owned());
        rows[1].push("×".to_owned());
    }
    if is_shaken {
        rows[0].extend(row!["right", "up"]);
        rows[1].extend(row!["of g", "of g"]);
        if on_plan {
            rows[0].extend(row!["away"]);
            rows[1].extend(row!["of g"]);
        }
    }
    let before = rows[0].len();
    rows[0].extend(row!["", "SF", "SF", "leaves", "", ""]);
    rows[1].extend(row!["mode", "slide", "turn", "rest at", "into", "unique"]);
    let share = |acceleration: f64| digits(acceleration / under.gravity);
    rows.extend(assessed.tried().map(|assessed| {
        let mut row: Vec<String> = pairs(assessed).iter().map(|(_, factor)| digits(*factor)).collect();
        let earthquake = assessed.earthquake.iter();
        row.extend(earthquake.flat_map(|given| {
            let away = on_plan.then(|| share(given.away()));
            [share(given.horizontal()), share(given.vertical())].into_iter().chain(away)
        }));
        row.extend(results(assessed));
        row
    }));
    let what = match (is_shaken, of_pairs.is_empty()) {
        (true, true) => "Accelerations of the base",
        (true, false) => "Factors and accelerations of the base",
        _ => "Factors",
    };
    let mut text = format!("\n{what} that were tried, the worst first\n");
    let numbers: Vec<usize> = (0..before).chain(before + 1..before + 4).collect();
    text += &columns(&rows, 2, &numbers);
    let factor = match case.earthquake_factor(assessed.acting, assessed.trial) {
        factor if is_shaken && factor != 1.0 => {
            format!("They act times {}, the factor of the combination. ", digits(factor))
        }
        _ => String::new(),
    };
    let fixed = if is_shaken { " horizontal_fixed and vertical_fixed keep the signs given." } else { "" };
    text += &paragraph(&format!("{factor}The rest of this answer is for the first row.{fixed}"), 2);
    if !of_pairs.is_empty() {
        text += &paragraph("A criterion is met where it is met in every row.", 2);
    }
    text
}
