//! The inputs as they are written in the case file, with what they mean in SI units and where they come from.

use maud::{Markup, PreEscaped, html};
use standfast_cases::Case;
use standfast_cases::case::{Input, Number, Weight, inputs};

use crate::fault::Fault;
use crate::mathml::symbol;
use crate::quantity::{ACCELERATION, DEGREE, METRE, NONE, Quantity, number};

/// What a key is, in words and as a symbol of the calculation.
const MEANING: [(&str, &str, &str, &str); 55] = [
    ("", "gravity", "acceleration of gravity", "g"),
    ("[body]", "width", "width of the body", "w"),
    ("[body]", "height", "height of the body", "h_w"),
    ("[body]", "mass", "mass, per metre run", "m"),
    ("[body]", "density", "mean density of the body", "ρ_b"),
    ("[body]", "friction", "Coulomb friction between body and base, to stick", "μ"),
    ("[body]", "kinetic_friction", "Coulomb friction, to slip", "μ_k"),
    ("[body]", "centroid_offset", "centre of mass right of mid-width", "x_C"),
    ("[body]", "centroid_height", "centre of mass above the base", "y_C"),
    ("[body]", "moment_of_inertia", "moment of inertia about the centre of mass", "I"),
    ("[body]", "base_left", "edge of the base left of mid-width", "e_l"),
    ("[body]", "base_right", "edge of the base right of mid-width", "e_r"),
    ("[body]", "buoyant_weight", "weight less buoyancy", "W_g"),
    ("[body]", "weight_arm", "its arm to the left corner O", "t_g"),
    ("[water]", "level", "still water above the base, both sides", "h_l"),
    ("[water]", "left", "still water above the base, left", "h_l"),
    ("[water]", "right", "still water above the base, right", "h_r"),
    ("[water]", "density", "density of the water", "ρ_w"),
    ("[uplift]", "left", "pressure under the left corner O", "p_l"),
    ("[uplift]", "right", "pressure under the right corner O′", "p_r"),
    ("[uplift]", "grows", "whether it rises with the variable loads", ""),
    ("[earthquake]", "horizontal", "acceleration of the base, to the right", "a_h"),
    ("[earthquake]", "vertical", "acceleration of the base, upwards", "a_v"),
    ("[added_mass]", "mass", "mass of water that moves with the body", "M_a"),
    ("[added_mass]", "sides", "sides on which water moves with the body", ""),
    ("[wave]", "deep_water_height", "equivalent deep-water wave height", "H_0'"),
    ("[wave]", "H13", "significant wave height at the wall", "H_13"),
    ("[wave]", "Hmax", "maximum wave height at the wall", "H_max"),
    ("[wave]", "period", "significant wave period", "T"),
    ("[wave]", "sea_bottom_slope", "slope of the sea bed", "tanθ"),
    ("[wave]", "water_depth", "depth at the wall", "h"),
    ("[wave]", "depth_above_berm", "depth above the berm’s armour", "d"),
    ("[wave]", "base_depth", "depth of the caisson’s base", "h'"),
    ("[wave]", "crest_height", "crest above still water", "h_c"),
    ("[wave]", "berm_width", "width of the berm", "B_M"),
    ("[wave]", "caisson_width", "width of the caisson’s base", "B_c"),
    ("[wave]", "angle_deg", "angle of the waves from the wall’s normal", "β"),
    ("[wave]", "turn_deg", "by how much they are turned towards it", "Δβ"),
    ("[wave]", "water_density", "density of the sea", "ρ"),
    ("[wave]", "impulsive", "whether Takahashi’s coefficient is used", ""),
    ("[wave]", "lambda", "factors on standing, breaking and uplift pressure", "λ"),
    ("[[load]]", "name", "name of the load", ""),
    ("[[load]]", "force", "force, per metre run", "F"),
    ("[[load]]", "elevation", "its height above the base", "e"),
    ("[[load]]", "direction", "where it points", ""),
    // What is taken where the file is silent.
    ("default", "gravity", "acceleration of gravity", "g"),
    ("default", "kinetic_friction", "friction to slip: that to stick", "μ_k"),
    ("default", "base_left", "edge of the base left of mid-width: that of the body", "e_l"),
    ("default", "base_right", "edge of the base right of mid-width: that of the body", "e_r"),
    ("default", "centroid_height", "centre of mass above the base: mid-height", "y_C"),
    ("default", "weight_arm", "arm of the buoyant weight: below the centre of mass", "t_g"),
    ("default", "caisson_width", "width of the caisson’s base: that of the body", "B_c"),
    ("default", "turn_deg", "waves turned towards the normal by", "Δβ"),
    ("default", "impulsive", "Takahashi’s coefficient", ""),
    ("default", "lambda", "factors on the pressures", "λ"),
];

pub fn tables(case: &Case, text: &str) -> Result<Markup, Fault> {
    let inputs = inputs(case, text);
    let defaults = defaults(case, &inputs);
    Ok(html! {
        p.note {
            "As written in the case file; numbers without a unit are in SI units. A source is the comment behind the number"
            @if case.note.is_some() { "; the note under the title holds for all others" }
            "."
        }
        table.numbers data-table="inputs" {
            thead { tr { th { "Input" } th { "Symbol" } th { "As written" } th.n { "In SI units" } th { "Source" } } }
            @for group in groups(&inputs) {
                tbody {
                    tr.group { th colspan="5" scope="rowgroup" { (heading(&group[0])) } }
                    @for input in group { (row(input)?) }
                }
            }
            @if !defaults.is_empty() {
                tbody {
                    tr.group { th colspan="5" scope="rowgroup" { "Not in the file, taken as" } }
                    @for (key, value) in defaults {
                        @let (words, name) = meaning("default", key)?;
                        tr { td { (words) } td { (sign(name)) } td { (value) } td.n {} td { "default of the program" } }
                    }
                }
            }
        }
    })
}

/// Entries of one table after another.
fn groups(inputs: &[Input]) -> Vec<&[Input]> {
    inputs.chunk_by(|one, two| (&one.table, one.index) == (&two.table, two.index)).collect()
}

fn heading(first: &Input) -> String {
    match first.table.as_str() {
        "" => "General".to_owned(),
        "[[load]]" => format!("[[load]] {}", first.index + 1),
        table => table.to_owned(),
    }
}

fn meaning(table: &str, key: &str) -> Result<(&'static str, &'static str), Fault> {
    let found = MEANING.iter().find(|(of, name, ..)| (*of, *name) == (table, key));
    let fault = || Fault::NoMeaning { table: table.to_owned(), key: key.to_owned() };
    found.map(|(_, _, words, symbol)| (*words, *symbol)).ok_or_else(fault)
}

fn sign(name: &str) -> Markup {
    html! { @if !name.is_empty() { (PreEscaped(symbol(name))) } }
}

fn row(input: &Input) -> Result<Markup, Fault> {
    let (words, name) = meaning(&input.table, &input.key)?;
    let written = input.written.trim_matches('"');
    Ok(html! {
        tr {
            td { (words) " " code { (input.key) } }
            td { (sign(name)) }
            td.written { (written) }
            td.n {
                @for (i, Number { value, quantity, .. }) in input.numbers.iter().enumerate() {
                    @if i > 0 { ", " }
                    data value=(value) { (number(*value)) }
                    @if input.key.ends_with("_deg") { "°" }
                    @if let Some(quantity) = quantity {
                        "\u{a0}" span.unit { (quantity.si().replace("m2", "m²").replace("m3", "m³").replace("s2", "s²")) }
                    }
                }
            }
            td.source { (input.comment.as_deref().unwrap_or_default()) }
        }
    })
}

/// What is taken where the file is silent: as a word, or in numbers and their unit.
fn defaults(case: &Case, inputs: &[Input]) -> Vec<(&'static str, Markup)> {
    let silent =
        |table: &str, key: &str| !inputs.iter().any(|input| input.table == table && input.key == key);
    let mut defaults = Vec::new();
    if silent("", "gravity") {
        defaults.push(("gravity", Quantity::of(case.gravity, ACCELERATION).html("")));
    }
    if silent("[body]", "kinetic_friction") && !case.is_plain() {
        defaults.push(("kinetic_friction", Quantity::of(case.kinetic_friction, NONE).html("")));
    }
    let (left, right) = case.body.base_edges();
    for (key, value) in [("base_left", left), ("base_right", right)] {
        if silent("[body]", key) && !case.body.is_uniform() {
            defaults.push((key, Quantity::of(value, METRE).html("")));
        }
    }
    if silent("[body]", "centroid_height") && !case.body.is_uniform() {
        defaults.push(("centroid_height", Quantity::of(case.body.centroid_height(), METRE).html("")));
    }
    if let Weight::Buoyant { arm, .. } = case.weight
        && silent("[body]", "weight_arm")
    {
        defaults.push(("weight_arm", Quantity::of(arm, METRE).html("")));
    }
    if let Some(wave) = &case.wave {
        if silent("[wave]", "caisson_width") {
            defaults.push(("caisson_width", Quantity::of(wave.section.caisson_width, METRE).html("")));
        }
        if silent("[wave]", "turn_deg") {
            defaults.push(("turn_deg", Quantity::of(wave.choices.turn_deg, DEGREE).html("")));
        }
        if silent("[wave]", "impulsive") {
            defaults
                .push(("impulsive", html! { @if wave.choices.impulsive { "used" } @else { "not used" } }));
        }
        if silent("[wave]", "lambda") {
            let factors = wave.choices.lambda.map(|factor| Quantity::of(factor, NONE).html(""));
            defaults.push(("lambda", html! { (factors[0]) ", " (factors[1]) ", " (factors[2]) }));
        }
    }
    defaults
}

#[cfg(test)]
mod tests {
    use super::{Fault, Input, row};

    #[test]
    fn an_input_without_words_leaves_no_sheet() {
        let [table, key, written] = ["[body]", "colour", "3"].map(str::to_owned);
        let input = Input { table, index: 0, key, written, numbers: Vec::new(), comment: None };
        let [table, key] = ["[body]", "colour"].map(str::to_owned);
        assert_eq!(row(&input).map(|row| row.into_string()), Err(Fault::NoMeaning { table, key }));
    }
}
