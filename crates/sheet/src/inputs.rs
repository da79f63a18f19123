//! The inputs as they are written in the case file, as they are taken, and where they come from.

use maud::{Markup, PreEscaped, html};
use standfast::BaseEdges;
use standfast_cases::case::{COUPLING, T_H, T_M, Weight};
use standfast_cases::key::{Kind, TITLE_BLOCK, Table};
use standfast_cases::{Case, CaseFile, Entry, Id, Key};

use crate::mathml::symbol;
use crate::measured::{ACCELERATION, DEGREE, KILOPASCAL, METRE, Measured, NONE, SheetUnit};
use crate::symbols::of_input;

pub fn tables(case: &Case, file: &CaseFile) -> Markup {
    // Title and note stand at the top of the sheet, and what is in its title block.
    let on_top = |key: Key| matches!(key, Key::Title | Key::Note) || TITLE_BLOCK.contains(&key);
    let shown = |entry: &&Entry| !on_top(entry.id.key);
    let entries: Vec<_> = file.entries().iter().filter(shown).collect();
    let table = |entry: &Entry| (entry.id.table, entry.id.index);
    let defaults = defaults(case, file);
    html! {
        p.note {
            "As written in the case file; numbers without a unit are in SI units. A source is the comment behind the number"
            @if case.note.is_some() { "; the note under the title holds for all others" }
            "."
        }
        table.numbers data-table="inputs" {
            thead { tr { th { "Input" } th { "Symbol" } th { "As written" } th.n { "As taken" } th { "Source" } } }
            @for group in entries.chunk_by(|one, two| table(one) == table(two)) {
                @let name = group.iter().find(|entry| entry.id.key.entry() == "name");
                tbody {
                    tr.group {
                        th colspan=(if name.is_some() { 4 } else { 5 }) scope="rowgroup" {
                            (heading(group[0].id))
                            @if let Some(name) = name { " " (file.written(name).trim_matches('"')) }
                        }
                        @if let Some(name) = name { td.source { (file.comment(name).unwrap_or_default()) } }
                    }
                    @for entry in group.iter().filter(|entry| entry.id.key.entry() != "name") { (row(file, entry)) }
                }
            }
            @if !defaults.is_empty() {
                tbody {
                    tr.group { th colspan="5" scope="rowgroup" { "Not in the file, taken as" } }
                    @for (id, value) in defaults {
                        tr {
                            td { (taken(id.key)) @if id.table == Table::Joint { ", joint " (id.table.number(id.index)) } }
                            td { (sign(file, id)) }
                            td { (value) }
                            td.n {}
                            td { "default of the program" }
                        }
                    }
                }
            }
        }
    }
}

/// Words for the value taken for a key that is not in the file, without a number that would stand beside them again.
fn taken(key: Key) -> &'static str {
    let words = key.info().silent.unwrap_or(key.info().words);
    let number =
        words.split_once(": ").filter(|(_, taken)| taken.starts_with(|first: char| first.is_ascii_digit()));
    number.map_or(words, |(quantity, _)| quantity)
}

fn heading(id: Id) -> String {
    match id.table {
        Table::Top => "General".to_owned(),
        Table::BackfillLayer => {
            let [of, place] = id.table.places(id.index);
            format!("{} {} of [[backfill]] {}", id.table.header(), place + 1, of + 1)
        }
        table if table.repeats() => format!("{} {}", table.header(), table.number(id.index)),
        table => table.header().to_owned(),
    }
}

/// The symbol of a key in its table; the three numbers of a list have three.
fn sign(file: &CaseFile, id: Id) -> Markup {
    let names = match id.key.info().kind {
        Kind::OneOf(..) => keys(id.key).iter().map(|key| key.info().symbol).collect(),
        _ => vec![id.key.info().symbol],
    };
    html! {
        @for (i, name) in names.into_iter().filter(|name| !name.is_empty()).enumerate() {
            @if i > 0 { ", " }
            (PreEscaped(symbol(&of_input(name, file.inputs(), id))))
        }
    }
}

/// The keys of an entry: one, or those of a list.
fn keys(key: Key) -> Vec<Key> {
    let table = key.info().table;
    table.keys().filter(|other| other.entry() == key.entry()).collect()
}

fn row(file: &CaseFile, entry: &Entry) -> Markup {
    let Id { table, index, key } = entry.id;
    let keys = keys(key);
    let words: Vec<_> = keys.iter().map(|key| key.info().words).collect();
    let numbers = keys.iter().filter_map(|&key| file.inputs().number(Id::of(table, index, key)));
    let list = file.inputs().list(entry.id).unwrap_or_default();
    let shown = key.info().range().is_some() || !list.is_empty();
    let numbers: Vec<f64> = numbers.chain(list.iter().copied()).filter(|_| shown).collect();
    let count = numbers.len();
    let written = file.written(entry);
    let written = match key.info().kind {
        Kind::List(_) | Kind::Pairs(_) | Kind::ModeList | Kind::Plains => written.replace('"', ""),
        _ => written.trim_matches('"').to_owned(),
    };
    let symbol = of_input(key.info().symbol, file.inputs(), entry.id);
    let output = file.inputs().output();
    let unit = file.inputs().dimension(key).map_or(NONE, SheetUnit::of);
    let measured = |value: f64| Measured::of(value, unit).in_output(output);
    html! {
        tr data-symbol=[(count == 1).then_some(symbol)] {
            td { (words.join(", ")) " " code { (key.entry()) } }
            td { (sign(file, entry.id)) }
            td.written colspan=[(count == 0).then_some(2)] { (written) }
            @if count > 0 {
                td.n {
                    @for (i, &value) in numbers.iter().enumerate() {
                        @if i > 0 { ", " }
                        (measured(value).number_html(""))
                        @if key.entry().ends_with("_deg") { "°" }
                        @if i + 1 == count { (measured(value).unit_html()) }
                    }
                }
            }
            td.source { (file.comment(entry).unwrap_or_default()) }
        }
    }
}

/// Values taken where the file is silent: as a word, or in numbers and their unit.
fn defaults(case: &Case, file: &CaseFile) -> Vec<(Id, Markup)> {
    let output = case.output;
    let BaseEdges { left, right } = case.body.base_edges();
    let mut taken = vec![
        (Key::Gravity, Measured::of(case.gravity, ACCELERATION).in_output(output).html("")),
        (Key::KineticFriction, Measured::of(case.kinetic_friction, NONE).in_output(output).html("")),
    ];
    if !case.body.is_uniform() && case.section.is_none() {
        taken.extend([
            (Key::BaseLeft, Measured::of(left, METRE).in_output(output).html("")),
            (Key::BaseRight, Measured::of(right, METRE).in_output(output).html("")),
            (
                Key::CentroidHeight,
                Measured::of(case.body.centroid_height(), METRE).in_output(output).html(""),
            ),
        ]);
    }
    if let Weight::Buoyant { arm, .. } = case.weight {
        taken.push((Key::WeightArm, Measured::of(arm, METRE).in_output(output).html("")));
    }
    if let Some(wave) = case.goda() {
        let factors = wave.choices.lambda.map(|factor| Measured::of(factor, NONE).in_output(output).html(""));
        taken.extend([
            (Key::CaissonWidth, Measured::of(wave.section.caisson_width, METRE).in_output(output).html("")),
            (Key::TurnDeg, Measured::of(wave.choices.turn_deg, DEGREE).in_output(output).html("")),
            (Key::WaveUplift, html! { @if wave.choices.uplift { "yes" } @else { "no" } }),
            (Key::Impulsive, html! { @if wave.choices.impulsive { "used" } @else { "not used" } }),
            (Key::Lambda1, html! { (factors[0]) ", " (factors[1]) ", " (factors[2]) }),
        ]);
    }
    if case.ground.is_some_and(|ground| ground.soil().is_some()) {
        let has = |key: Key| file.inputs().get(key).is_some();
        if has(Key::GroundAngle) {
            taken.push((Key::GroundLaw, html! { "ec7" }));
            taken.extend(
                [Key::Surcharge, Key::Cohesion]
                    .map(|key| (key, Measured::of(0.0, KILOPASCAL).in_output(output).html(""))),
            );
        } else if has(Key::UndrainedStrength) {
            taken.push((Key::Surcharge, Measured::of(0.0, KILOPASCAL).in_output(output).html("")));
        } else {
            let envelope = [
                (Key::EnvelopeHorizontal, T_H),
                (Key::EnvelopeMoment, T_M),
                (Key::EnvelopeCoupling, COUPLING),
            ];
            taken.extend(
                envelope.map(|(key, number)| (key, Measured::of(number, NONE).in_output(output).html(""))),
            );
        }
    }
    if case.earthquake.is_some() {
        taken.push((Key::HorizontalFixed, html! { "not fixed" }));
        if case.earthquake.is_some_and(|earthquake| earthquake.vertical() != 0.0) {
            taken.push((Key::VerticalFixed, html! { "not fixed" }));
        }
    }
    let mut taken: Vec<(Id, Markup)> = taken.into_iter().map(|(key, value)| (key.into(), value)).collect();
    taken.extend(case.joints.iter().map(|joint| {
        let id = Id::new(Key::JointKineticFriction, joint.index);
        (id, Measured::of(joint.kinetic_friction, NONE).in_output(output).html(""))
    }));
    taken.retain(|(id, _)| file.inputs().get(*id).is_none());
    taken
}
