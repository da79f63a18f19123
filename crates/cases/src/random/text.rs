//! The probabilities as text.

use std::fmt::Write;

use standfast_probability::form::FormPoint;
use standfast_probability::law::Moments;
use standfast_probability::sample::{Effort, Estimate};

use super::summary::{FEW, period, summary};
use super::{
    Chances, DesignValues, Exceedance, FirstDeparture, Fit, FollowedWaves, Fragility, Happening,
    JoinedChance, Method, Overturning, PeakChances, Probability, Pulse, Quantile, RandomNumber, Sliding,
};
use crate::key::Key;
use crate::layout::{columns, digits, paragraph, percent, row, significant};
use crate::summary::listed;
use crate::summary::warning_words;

/// The answer as text: its top, what was asked for, and what it rests on.
pub(super) fn text(answer: &Probability) -> String {
    let title = answer.title.as_ref().map_or(String::new(), |title| paragraph(title, 0) + "\n");
    let mut text = title + &summary(answer).text();
    for part in [asked(answer), static_modes(answer), warnings(answer), note(answer)] {
        if !part.is_empty() {
            text += "\n";
            text += &part;
        }
    }
    text
}

/// Curves and slides, which are asked for beside the modes.
fn asked(answer: &Probability) -> String {
    let parts = [
        answer.overturning.as_ref().map(|overturning| overturns(answer, overturning)),
        answer.fragility.as_ref().map(|fragility| along(fragility, floor(answer))),
        answer.sliding.as_ref().map(|sliding| slides(answer, sliding)),
    ];
    parts.into_iter().flatten().collect::<Vec<_>>().join("\n")
}

/// The modes under each set of loads. Beside a curve of motions it is said that they are none of them.
fn static_modes(answer: &Probability) -> String {
    let worst = answer.situations.first().map_or(String::new(), |worst| chances(answer, worst));
    let mut text = match &answer.overturning {
        Some(_) if !worst.is_empty() => {
            paragraph("At the first instant, not in time: all peaks that the case itself has act at once", 0)
                + &worst
        }
        _ => worst,
    };
    for chances in answer.situations.iter().skip(1) {
        let _ = writeln!(text, "\nUnder {}", chances.situation.as_deref().unwrap_or("other loads"));
        text += &event_table(answer, chances);
    }
    if let Some(JoinedChance { count, not_rest, method }) = &answer.joined {
        let within = interval(*not_rest, *method).map_or(String::new(), |interval| format!(", {interval}"));
        let words = format!(
            "Under any of these {count}, all with the same numbers drawn, it does not rest: {}{within}.",
            probability(not_rest.value)
        );
        text += &format!("\n{}", paragraph(&words, 0));
    }
    text + &answer.situations.first().map_or(String::new(), |worst| of_row(answer, worst))
}

fn warnings(answer: &Probability) -> String {
    let words = answer.warnings().into_iter().map(|warning| warning_words(warning.name(), &warning));
    words.map(|words| paragraph(&words, 0)).collect()
}

fn note(answer: &Probability) -> String {
    answer.note.as_ref().map_or(String::new(), |note| paragraph(&format!("Note: {note}."), 0))
}

/// How far the body slides in a life: words, value, interval.
pub(super) fn slide_rows(sliding: &Sliding) -> Vec<Vec<String>> {
    let Sliding { mean, quantiles, exceedance, .. } = sliding;
    let metres = |slide: f64| format!("{} m", digits(slide));
    let within = |e: Estimate, words: &dyn Fn(f64) -> String| within(e, words).unwrap_or_default();
    let mut rows = vec![row!["mean", metres(mean.value), within(*mean, &metres)]];
    rows.push(row!["slides at all", probability(sliding.ever.value), within(sliding.ever, &probability)]);
    for Exceedance { slide, probability: p } in exceedance {
        rows.push(row![format!("more than {slide:.2} m"), probability(p.value), within(*p, &probability)]);
    }
    // A life that does not slide tells nothing by its share.
    for Quantile { share, slide } in quantiles.iter().filter(|quantile| quantile.slide.high > 0.0) {
        let words = format!("not exceeded in {} % of all lives", digits(100.0 * share));
        rows.push(row![words, metres(slide.value), within(*slide, &metres)]);
    }
    rows
}

/// Sentences on the slides of the body in storms.
fn slides(answer: &Probability, sliding: &Sliding) -> String {
    let Sliding { years, storm, mean, rotating, .. } = sliding;
    let of_years = if *years == 1.0 { "1 year".to_owned() } else { format!("{} years", digits(*years)) };
    let mut text = paragraph(
        &format!(
            "Sliding in {of_years} ({}; mean integrated, {} lives drawn, seed {})",
            sliding.storm_words(),
            grouped(sliding.lives),
            answer.request.effort.seed
        ),
        0,
    );
    let metres = |slide: f64| format!("{} m", digits(slide));
    let within = |e: Estimate, words: &dyn Fn(f64) -> String| within(e, words).unwrap_or_default();
    text += &columns(&slide_rows(sliding), 2, &[1]);
    if mean.value > 0.0 {
        let words = format!(
            "{} % of the mean comes of the worst 5 % of all lives; {} waves of a life slide the body on average.",
            digits((1000.0 * sliding.of_worst).round() / 10.0),
            digits(sliding.waves.value)
        );
        text += &paragraph(&words, 2);
    }
    if let Some(FollowedWaves { slide, overturned }) = &sliding.followed {
        let words = format!(
            "Waves that begin a rotation, {} of all waves, are followed in time: they add {} ({}) to the mean above, and shares and chances \
             of slides count them; {} of all lives end by overturning ({}), which counts as a slide beyond every limit.",
            below_or(rotating.wave),
            metres(slide.value),
            within(*slide, &metres),
            below_or(*overturned),
            within(*overturned, &probability)
        );
        text += &paragraph(&words, 2);
    } else if rotating.wave.value > 0.0 {
        let words = format!(
            "{} are left out, because the slide of a pulse does not hold for them: {} of all waves; {} of all lives have one.",
            sliding.left_out_words(),
            probability(rotating.wave.value),
            probability(rotating.life.value)
        );
        text += &paragraph(&words, 2);
    }
    if storm.pulse == Pulse::Shimosako || storm.has_formula() {
        text += &paragraph("Thrusts last as by Shimosako and Takahashi's formulas.", 2);
    }
    if !sliding.precise {
        text += &paragraph("The mean is not as precise as it is asked to be; more samples make it so.", 2);
    }
    text
}

/// Overturning over the peak of a shaking.
fn overturns(answer: &Probability, overturning: &Overturning) -> String {
    let Overturning { records, bodies, not_a_body, points, fit, gravity } = overturning;
    let said_of_records = super::summary::records(records.len());
    let of_records = match &records[..] {
        [one] => format!("the record {one}"),
        many => format!("{} records", many.len()),
    };
    let of_records = of_records.replace("the record that of the case", "the shaking of the case");
    let pairs = if records.len() > 1 { ", every pair" } else { "" };
    let words = format!(
        "In time, under {of_records} × {} bodies{pairs}, scaled to each peak (seed {})",
        grouped(*bodies),
        answer.request.effort.seed
    );
    let mut rows = vec![row!["peak (g)", "moves", "rocks", "overturns", ""]];
    for PeakChances { peak, moved, rocked, overturned } in points {
        rows.push(row![
            digits(peak / gravity),
            probability(moved.value),
            probability(rocked.value),
            below_or(*overturned),
            format!("{} … {}", probability(lower_end(overturned.low)), probability(overturned.high))
        ]);
    }
    let mut text = paragraph(&words, 0);
    text += &columns(&rows, 2, &[0, 1, 2, 3]);
    text += &said_of_records.map_or(String::new(), |words| paragraph(&words, 2));
    if *not_a_body > 0 {
        text += &paragraph(&format!("{not_a_body} draws make no possible body; they count as standing."), 2);
    }
    if let Some(Fit { median, dispersion, misfit }) = fit.filter(|_| records.len() >= FEW) {
        let words = format!(
            "A lognormal curve through the probabilities of overturning: median {} g, dispersion {}; it misses them by {} at most.",
            significant(median / gravity, 3),
            significant(dispersion, 2),
            significant(misfit, 2)
        );
        text += &paragraph(&words, 2);
    }
    text
}

pub(super) fn floor(answer: &Probability) -> f64 {
    answer.request.effort.floor
}

/// In one line, how the probabilities of an event were found.
pub(super) fn how(answer: &Probability, chances: &Chances) -> String {
    let numbers = answer.random.len();
    let (line, exact) = &answer.line;
    let how = match (chances.method, exact) {
        (Method::MonteCarlo, _) => "everything drawn".to_owned(),
        (_, true) => format!("{line} in closed form"),
        (_, false) => format!("{line} scanned"),
    };
    let counted = match chances.method {
        Method::Integrate => "integrated".to_owned(),
        method => {
            format!("{method}, {} points, seed {}", grouped(chances.points), answer.request.effort.seed)
        }
    };
    let numbers =
        if numbers == 1 { "1 random number".to_owned() } else { format!("{numbers} random numbers") };
    format!("{how}, {numbers}, {counted}")
}

fn chances(answer: &Probability, chances: &Chances) -> String {
    let how = how(answer, chances);
    let of = match (answer.has_joints(), answer.is_on_plan()) {
        (true, _) => "that each joint leaves rest first",
        (_, true) => "of rest, and of what ends it,",
        _ => "of each mode",
    };
    let mut text = paragraph(&format!("Probability {of} {} ({how})", period(answer)), 0);
    if let Some(situation) = &chances.situation {
        let least = match answer.situations.len() {
            1 => String::new(),
            2 => " (the worse of two)".to_owned(),
            count => format!(" (the worst of {count})"),
        };
        let _ = writeln!(text, "  under {situation}{least}");
    }
    text += &event_table(answer, chances);
    text += &paragraphs(&notes(answer, chances));
    text += &matters(answer, chances);
    text += &design_values(answer, chances);
    text += &slopes(answer, chances);
    text += &nearest(answer, chances);
    if let Some(life) = &chances.life {
        let _ = writeln!(text, "\n{}", super::summary::over_life(life));
        // Rest is what a life begins with.
        let moved: Vec<_> = life.modes.iter().copied().filter(|(mode, _)| *mode != Happening::REST).collect();
        text += &modes_table(answer, life.method, &moved, life.not_rest);
        text += &paragraphs(super::summary::after_rest(life).as_slice());
        if let Some(sliding) = answer.sliding.as_ref().filter(|_| answer.problem.is_some()) {
            let storm = &sliding.storm;
            let is_plain = storm.parts.iter().all(|part| part.rise == 0.0) && storm.combination.is_none();
            let words = if is_plain {
                "Here each year has a wave of the whole H_max. The slides above are those of waves drawn up to H_max, which slide the body \
                 in no more lives."
            } else {
                "Here each year has a wave of the whole H_max, at the water level of the case. The slides above are those of its storm."
            };
            text += &paragraph(words, 2);
        }
        if !life.precise {
            text += &paragraph(&imprecise(answer), 2);
        }
    }
    text
}

/// Any of the bodies of a row, under the worst set of loads or any of them.
fn of_row(answer: &Probability, worst: &Chances) -> String {
    let Some(sentences) = super::summary::of_row(answer, worst) else { return String::new() };
    let mut text = "\nAny body of the row\n".to_owned() + &paragraphs(&sentences);
    if answer.sliding.is_some() {
        text += &paragraph(
            "Under the whole H_max of each year; the slides of waves above are those of one body.",
            2,
        );
    }
    if answer.row.is_some_and(|row| !row.precise) {
        text += &paragraph(&imprecise(answer), 2);
    }
    text
}

fn paragraphs(sentences: &[String]) -> String {
    sentences.iter().map(|sentence| paragraph(sentence, 2)).collect()
}

/// Note on what is not asked of bodies on joints.
const FIRST_ALONE: &str = "Of joints it is found which leaves rest first as the loads rise, and how; not what all of them begin with.";

/// Note on what is not asked on a base seen from above.
const PLAN_ALONE: &str = "On a base seen from above it is found whether the body rests, and what ends rest as the loads rise; not how it then moves.";

/// Sentences on an event: where it would first leave rest, its reliability index, precision, what was cut.
pub(super) fn notes(answer: &Probability, chances: &Chances) -> Vec<String> {
    let mut notes: Vec<String> =
        [departures(answer, chances), index(chances)].into_iter().flatten().collect();
    if answer.has_joints() {
        notes.push(FIRST_ALONE.to_owned());
    }
    if answer.is_on_plan() {
        notes.push(PLAN_ALONE.to_owned());
    }
    if chances.given_up {
        notes.push(format!("An integral would take too long: {} points took its place.", chances.method));
    }
    if !chances.precise {
        notes.push(imprecise(answer));
    }
    if answer.random.iter().any(|number| number.is_rise) {
        let period = if answer.random.iter().any(|number| number.yearly) { "A year" } else { "An event" };
        notes.push(format!("{period} is one of the life, any of them as likely: with a rise of its own."));
    }
    let fits = answer.random.iter().filter_map(|number| Some((&number.name, number.fit_words()?)));
    notes.extend(fits.map(|(name, words)| {
        format!("{name} is {words}. What they leave uncertain is drawn once for all events.")
    }));
    // Less is in the JSON alone.
    let cut = answer.random.iter().filter(|number| number.cut >= 1e-12);
    notes.extend(cut.map(|RandomNumber { name, cut, .. }| {
        format!("{} of the law of {name} is cut away: no body has such values.", digits(*cut))
    }));
    notes
}

fn imprecise(answer: &Probability) -> String {
    let Effort { precision, floor, .. } = answer.request.effort;
    format!(
        "Not as precise as asked, {} % of every probability above {}; more samples make it so.",
        digits(100.0 * precision),
        digits(floor)
    )
}

/// Into which mode it would first leave rest, were the loads to rise until it does.
fn departures(answer: &Probability, chances: &Chances) -> Option<String> {
    let FirstDeparture { modes, never, at_once, .. } = &chances.first_departure;
    let of_all = |p: f64| {
        let [least, most] = [1e-4, 1.0 - 1e-4];
        if (most..1.0).contains(&p) { format!("over {}", percent(most)) } else { percent(p.max(least)) }
    };
    let mut shares: Vec<(String, f64)> =
        modes.iter().map(|(happening, share)| (happening.name(), share.value)).collect();
    shares.retain(|(_, share)| *share >= floor(answer).max(1e-4));
    standfast::order::by_number(&mut shares, |one| -one.1);
    let (joints, on_plan) = (answer.has_joints(), answer.is_on_plan());
    let mut parts = Vec::new();
    if !shares.is_empty() {
        let first = if joints || on_plan { " first" } else { "" };
        let shares: Vec<String> =
            shares.iter().map(|(name, share)| format!("{name}{first} in {}", of_all(*share))).collect();
        let leaves = match (joints, on_plan) {
            (true, _) => "",
            (_, true) => "it ",
            _ => "it would first leave rest into ",
        };
        parts.push(format!("{leaves}{}", listed(&shares)));
    }
    let others = match joints {
        true => ["one joint at least moves at once in", "no joint would ever move in"],
        false => ["it moves at once in", "it would never move in"],
    };
    for (share, what) in [at_once, never].into_iter().zip(others) {
        if share.value >= floor(answer).max(1e-4) {
            parts.push(format!("{what} {}", of_all(share.value)));
        }
    }
    let words = || format!("Were the loads to rise without end, {} of all outcomes.", parts.join("; "));
    (!parts.is_empty()).then(words)
}

/// The reliability index beside the probability.
fn index(chances: &Chances) -> Option<String> {
    let Some(point) = &chances.design_point else {
        let words = || "Nowhere within twelve deviations of the medians does it move.".to_owned();
        return (chances.not_rest.value <= 0.0).then(words);
    };
    let mut said = format!("β = {} by FORM", digits(point.beta));
    if point.at_change {
        said += ", at a change of formula or of mode";
    }
    let _ = write!(said, " (Φ(−β) = {} only approximates P)", digits(point.first_order()));
    if let Some(beta) = chances.generalized() {
        let _ = write!(said, "; −Φ⁻¹(P) = {}", digits(beta));
    }
    Some(format!("{said}."))
}

/// The places of the numbers, that which matters most first.
pub(super) fn by_importance(point: &FormPoint) -> Vec<usize> {
    let mut order: Vec<usize> = (0..point.alpha.len()).collect();
    standfast::order::by_number(&mut order, |one| -point.alpha[*one].abs());
    order
}

/// Table of the numbers, by how much each matters.
fn matters(answer: &Probability, chances: &Chances) -> String {
    let Some(point) = chances.design_point.as_ref().filter(|_| answer.random.len() > 1) else {
        return String::new();
    };
    let mut rows = vec![row!["Which number matters", "α²", "P if it were known", "at the design point"]];
    for place in by_importance(point) {
        let known = chances.known.get(place).map_or(String::new(), |e| below_or(*e));
        rows.push(row![
            format!("  {}", answer.random[place].name),
            format!("{:.2}", point.alpha[place].powi(2)),
            known,
            answer.random[place].written(point.values[place])
        ]);
    }
    format!("\n{}", columns(&rows, 0, &[1, 2, 3]))
}

/// Table of the design values at a target index, if they are asked for.
fn design_values(answer: &Probability, chances: &Chances) -> String {
    let Some(DesignValues { beta, numbers }) = &chances.design_values else { return String::new() };
    let heading = format!("Design values at β = {}", digits(*beta));
    let mut rows = vec![row![heading, "α", "design value", "characteristic", "", "partial factor"]];
    for (number, design) in answer.random.iter().zip(numbers) {
        rows.push(row![
            format!("  {}", number.name),
            format!("{:.2}", design.alpha),
            number.written(design.value),
            number.written(design.characteristic),
            format!("{} %", digits(100.0 * design.fractile)),
            design.factor.map_or(String::new(), |factor| format!("{factor:.2}"))
        ]);
    }
    format!("\n{}", columns(&rows, 0, &[1, 2, 3, 4, 5]))
        + &paragraph(
            "EN 1990, Annex C: F⁻¹(Φ(αβ)), α at the nearest point at which the body does not rest.",
            2,
        )
}

/// Table of what means and deviations of the laws do, if that is asked for.
fn slopes(answer: &Probability, chances: &Chances) -> String {
    let Some(all) = &chances.slopes else { return String::new() };
    let mut rows = vec![row!["What the laws do", "mean", "deviation", "∂P/∂mean", "∂P/∂deviation"]];
    let known =
        || answer.random.iter().zip(all).filter_map(|(number, slopes)| Some((number, slopes.as_ref()?)));
    for (number, slopes) in known() {
        let slope = |slope: Option<f64>| slope.map_or("none".to_owned(), |slope| number.per_unit(slope));
        rows.push(row![
            format!("  {}", number.name),
            number.written(slopes.moments.mean),
            number.written(slopes.moments.sd),
            slope(slopes.by_mean),
            slope(slopes.by_sd)
        ]);
    }
    let p = chances.not_rest.value;
    // Change of P for one per cent more, as a share of P.
    let changes = known().flat_map(|(number, slopes)| {
        let of = |slope: Option<f64>, value: f64, what| Some((slope? * value.abs() / p, what, &number.name));
        let Moments { mean, sd } = slopes.moments;
        [of(slopes.by_mean, mean, "mean"), of(slopes.by_sd, sd, "deviation")].into_iter().flatten()
    });
    let most =
        changes.filter(|(change, ..)| change.is_finite()).max_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
    let most = most.map_or(String::new(), |(change, what, name)| {
        // What has no slope may matter more.
        let has_all = known().count() == all.len()
            && known().all(|(_, slopes)| slopes.by_mean.is_some() && slopes.by_sd.is_some());
        let the = if has_all { "The" } else { "Of what has a slope, the" };
        format!(
            " {the} {what} of {name} does most: 1 % more of it changes P by {} %.",
            significant(change, 2)
        )
    });
    format!("\n{}", columns(&rows, 0, &[1, 2, 3, 4]))
        + &paragraph(
            &format!(
                "P is that the body does not rest {}; the mean changes with the deviation kept, and the other way round.{most}",
                period(answer)
            ),
            2,
        )
}

/// Table of the points at which each mode is nearest to the medians, if that is asked for.
fn nearest(answer: &Probability, chances: &Chances) -> String {
    let Some(points) = &chances.design_points else { return String::new() };
    let names = answer.random.iter().map(|number| number.name.clone());
    let head = ["Nearest point (FORM)", "β", "Φ(−β)", "P"].map(str::to_owned);
    let mut rows: Vec<Vec<String>> = vec![head.into_iter().chain(names).collect()];
    for (happening, point) in points {
        let of_mode = chances.modes.iter().find(|(mode, _)| mode == happening);
        let mark = if point.at_change { "*" } else { "" };
        let figures = [
            format!("  {}{mark}", happening.name()),
            digits(point.beta),
            digits(point.first_order()),
            of_mode.map_or_else(String::new, |(_, e)| below_or(*e)),
        ];
        let values = answer.random.iter().zip(&point.values).map(|(number, value)| number.written(*value));
        rows.push(figures.into_iter().chain(values).collect());
    }
    let right: Vec<usize> = (1..rows[0].len()).collect();
    let mut text = format!("\n{}", columns(&rows, 0, &right));
    if points.iter().any(|(_, point)| point.at_change) {
        text += &paragraph("* at a change of formula or of mode.", 2);
    }
    text + &paragraph("FORM ranks; Φ(−β) is the probability of a half space, not of the mode.", 2)
}

/// The modes under the loads of one event.
fn event_table(answer: &Probability, chances: &Chances) -> String {
    let mut text = modes_table(answer, chances.method, &chances.modes, chances.not_rest);
    let pressed = if answer.has_joints() { "a joint" } else { "the body down" };
    let parts = [
        ("more than one consistent mode".to_owned(), chances.not_unique),
        (format!("nothing that presses {pressed}"), Some(chances.lifted)),
    ];
    let parts = parts.into_iter().filter_map(|(words, e)| Some((words, e?)));
    for (words, e) in parts.filter(|(_, e)| e.value >= floor(answer)) {
        text += &paragraph(&format!("Of these with {words}: {}.", probability(e.value)), 2);
    }
    text
}

/// Modes with their probabilities; those below the floor together.
fn modes_table(
    answer: &Probability,
    method: Method,
    modes: &[(Happening, Estimate)],
    not_rest: Estimate,
) -> String {
    let floor = floor(answer);
    let mut shown: Vec<_> = modes.iter().filter(|(_, e)| e.value >= floor).collect();
    standfast::order::by_number(&mut shown, |one| -one.1.value);
    let mut rows: Vec<Vec<String>> =
        shown.iter().map(|(happening, e)| line(&words(answer, *happening), *e, method)).collect();
    rows.push(line("does not rest", not_rest, method));
    let mut text = columns(&rows, 2, &[1]);
    let below: Vec<_> = modes.iter().filter(|(_, e)| e.value < floor && e.high > 0.0).collect();
    if !below.is_empty() {
        let names: Vec<String> = below.iter().map(|(happening, _)| happening.name()).collect();
        let bound = below.iter().map(|(_, e)| e.high).fold(0.0, f64::max);
        let each = if names.len() > 1 { "each " } else { "" };
        let (names, bound) = (names.join(", "), probability(bound));
        let words = match below.iter().all(|(_, e)| e.value == 0.0) {
            true => format!("Never met, so a bound is all that is known: {names} ({each}below {bound})."),
            false => format!("{names}: {each}below {bound}."),
        };
        text += &paragraph(&words, 2);
    }
    text
}

/// The interval, where it is more than its value.
pub(super) fn within(e: Estimate, words: &dyn Fn(f64) -> String) -> Option<String> {
    let (low, high) = (words(lower_end(e.low)), words(e.high));
    (low != high).then(|| format!("{low} … {high}"))
}

/// The lower end of an interval, for reading: so near to nothing no count tells a number.
fn lower_end(low: f64) -> f64 {
    if low > 0.0 && low < 1e-15 { 0.0 } else { low }
}

fn line(words: &str, e: Estimate, method: Method) -> Vec<String> {
    row![words, probability(e.value), interval(e, method).unwrap_or_default()]
}

/// The interval of a probability that was counted, not integrated.
fn interval(e: Estimate, method: Method) -> Option<String> {
    if method == Method::Integrate { None } else { within(e, &probability) }
}

/// An outcome in words, a mode with its symbol, a joint with its name.
pub(super) fn words(answer: &Probability, happening: Happening) -> String {
    if let Happening::First(first) = happening {
        return answer.first_words(first);
    }
    let name = happening.name();
    if let Happening::OnPlan { .. } = happening {
        return happening.words().unwrap_or_default().to_owned();
    }
    happening.words().map_or(name.clone(), |words| format!("{words}, {name}"))
}

/// A probability; one that only rounds to 1 is no 1.
pub(super) fn probability(p: f64) -> String {
    let text = digits(p);
    if text == "1" && p < 1.0 { "above 0.9999".to_owned() } else { text }
}

/// A probability, or the bound of one that was never met.
pub(super) fn below_or(e: Estimate) -> String {
    if e.value == 0.0 && e.high > 0.0 { format!("below {}", digits(e.high)) } else { probability(e.value) }
}

/// A whole number with thin spaces between its thousands.
fn grouped(n: u64) -> String {
    let text = n.to_string();
    let mut grouped = String::new();
    for (place, digit) in text.chars().enumerate() {
        if place > 0 && (text.len() - place).is_multiple_of(3) {
            grouped.push('\u{202f}');
        }
        grouped.push(digit);
    }
    grouped
}

/// Probabilities along a number: a column for each mode that is likely enough anywhere.
fn along(fragility: &Fragility, floor: f64) -> String {
    let (Fragility { name, points, fit, .. }, unit) = (fragility, fragility.unit());
    let shown = |value: f64| digits(fragility.in_unit(value));
    let likely = |place: usize| points.iter().any(|point| point.modes[place].1.value >= floor);
    let places: Vec<usize> =
        (0..points.first().map_or(0, |point| point.modes.len())).filter(|i| likely(*i)).collect();
    let head = if unit.is_empty() { name.clone() } else { format!("{name} ({unit})") };
    let names = places.iter().map(|place| points[0].modes[*place].0.name());
    let asked = points.first().map_or(&[][..], |point| &point.criteria);
    let asked = asked.iter().map(|check| check.criterion.full_name());
    let names = names.chain(["not RE".to_owned()]).chain(asked);
    let mut rows = vec![[head].into_iter().chain(names).collect::<Vec<_>>()];
    for point in points {
        let modes = places.iter().map(|place| probability(point.modes[*place].1.value));
        rows.push(
            [shown(point.value)]
                .into_iter()
                .chain(modes)
                .chain([probability(point.not_rest.value)])
                .chain(point.criteria.iter().map(|check| {
                    let Estimate { value, .. } = check.estimate;
                    match check.criterion.key {
                        Key::LeastLifeIndex if value.is_infinite() => "infinite".to_owned(),
                        Key::LeastLifeIndex | Key::GreatestMeanSlide => {
                            check.criterion.with_unit(&probability(value))
                        }
                        _ => below_or(check.estimate),
                    }
                }))
                .collect(),
        );
    }
    let right: Vec<usize> = (0..rows[0].len()).collect();
    let mut text = columns(&rows, 0, &right);
    text += &match fit {
        Some(Fit { median, dispersion, misfit }) => paragraph(
            &format!(
                "A lognormal curve through what does not rest: median {}, dispersion {}; it misses by {} at most.",
                format!("{} {unit}", shown(*median)).trim_end(),
                digits(*dispersion),
                digits(*misfit)
            ),
            2,
        ),
        None => String::new(),
    };
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_interval_begins_at_a_number_that_a_count_can_tell() {
        let interval = |low| within(Estimate { value: 0.1, low, high: 0.5 }, &probability);
        assert_eq!(interval(6.58e-103), Some("0 … 0.5".to_owned()));
        assert_eq!(interval(2e-9), Some("2e-9 … 0.5".to_owned()));
    }
}
