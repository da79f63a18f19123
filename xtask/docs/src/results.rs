//! docs/reference/results.md: every result with its symbol, unit, formula and the page that derives it.

use standfast_cases::results::{ResultKind, ResultName, SeaResult};
use standfast_cases::units::Dimension;

const CONTACT: &str = "contact";
const REPORT: &str = "report#safety-factors";
const LOADS: &str = "loads";
const RISING: &str = "loads#a-load-that-rises";
const WAVES: &str = "loads#waves-on-a-vertical-caisson";
const FACTORS: &str = "loads#three-overturning-factors";
const DIRECTION: &str = "direction";
const EFFECTIVE: &str = "loads#the-reports-diagram-with-effective-coordinates";
const CRUSHES: &str = "base#a-base-that-crushes";
const FAILS: &str = "base#ground-that-fails";
const ELASTIC: &str = "base#an-elastic-base";

/// Symbol, formula and page of a result; a formula that is none is a decision or a search, which the page tells.
type Told = (&'static str, &'static str, &'static str);

fn told(name: &str) -> Option<Told> {
    const ALL: &[(&str, Told)] = &[
        ("mode", ("", "", CONTACT)),
        ("unique", ("", "", CONTACT)),
        ("also", ("", "", CONTACT)),
        ("lifted", ("", "", CONTACT)),
        ("departure", ("", "", RISING)),
        ("load_factor", ("λ", "", RISING)),
        ("departure_mode", ("", "", RISING)),
        ("departure_by", ("", "", RISING)),
        ("SF_sliding", ("SF_s", "μ (W' - U)/P", REPORT)),
        ("SF_overturning_net", ("SF_o", "min(SF_heel, SF_toe)", FACTORS)),
        ("SF_overturning_heel", ("SF_heel", "(W' t - M_U)/M_p", FACTORS)),
        ("SF_overturning_toe", ("SF_toe", "(W' (B_c - t) - U B_c + M_U)/(-M_p)", FACTORS)),
        ("SF_overturning_gross", ("SF_g", "(W' t + M_s)/(M_s + M_U + M_p)", FACTORS)),
        ("SF_uplift", ("", "V_down/V_up", FACTORS)),
        ("tipping", ("", "T_tip/T_hold", FACTORS)),
        ("margin_sliding", ("", "μ (W' - U) - P", LOADS)),
        ("margin_overturning", ("", "min(margin_heel, margin_toe)", LOADS)),
        ("margin_overturning_heel", ("", "W' t - M_U - M_p", LOADS)),
        ("margin_overturning_toe", ("", "W' (B_c - t) - U B_c + M_U + M_p", LOADS)),
        ("bearing", ("", "", LOADS)),
        ("heel_pressure", ("p_heel", "2 (W' - U)/(3 t_e)   where 3 t_e ≤ B_c", LOADS)),
        ("toe_pressure", ("p_toe", "", LOADS)),
        ("bearing_max", ("p_max", "max(p_heel, p_toe)", LOADS)),
        ("contact_length", ("", "min(3 t_e, B_c)", LOADS)),
        ("contact_share", ("", "", LOADS)),
        ("resultant_arm", ("t_e", "(W' t - M_U - M_p)/(W' - U)", LOADS)),
        ("eccentricity", ("e", "B_c/2 - t_e", LOADS)),
        ("heel", ("", "", LOADS)),
        ("P", ("P", "", LOADS)),
        ("M_p", ("M_p", "", LOADS)),
        ("U", ("U", "", LOADS)),
        ("M_U", ("M_U", "", LOADS)),
        ("buoyant_weight", ("W'", "W - ρ g V_w", LOADS)),
        ("weight_arm", ("t", "", LOADS)),
        ("omega", ("ω", "V/(B_c q_u)", CRUSHES)),
        ("pivot", ("", "", CRUSHES)),
        ("neutral", ("", "", CRUSHES)),
        ("effective_width", ("B'", "B_c - 2 |e|", FAILS)),
        ("effective_pressure", ("", "V/B'", FAILS)),
        ("ground_resistance", ("R", "", FAILS)),
        ("ground_factor", ("", "R/V", FAILS)),
        ("ground_margin", ("", "R - V", FAILS)),
        ("load_factor_ground", ("λ_BF", "", FAILS)),
        ("load_factor_ground_less", ("", "", FAILS)),
        ("load_factor_ground_more", ("", "", FAILS)),
        ("k_BF", ("k_BF", "", FAILS)),
        ("rotation", ("θ", "", ELASTIC)),
        ("k_overturn", ("", "", ELASTIC)),
        ("period_1", ("T_1", "2 π/ω_1", ELASTIC)),
        ("period_2", ("T_2", "2 π/ω_2", ELASTIC)),
        ("D_shear", ("D_s", "", ELASTIC)),
        ("D_moment", ("D_m", "", ELASTIC)),
        ("k_moved", ("", "D_s k", ELASTIC)),
        ("k_prime_moved", ("", "(1 + k') D_m/D_s - 1", ELASTIC)),
        ("first_event", ("", "", ELASTIC)),
        ("first_event_time", ("", "", ELASTIC)),
        ("worst_direction_deg", ("", "", DIRECTION)),
        ("load_factor_worst", ("", "", DIRECTION)),
        ("k_eff", ("k_eff", "P/(W' - U)", EFFECTIVE)),
        ("k_prime_eff", ("k'_eff", "", EFFECTIVE)),
        ("H13", ("H_13", "", WAVES)),
        ("Hmax", ("H_max", "", WAVES)),
        ("deep_water_wavelength", ("L_0", "g T^2/(2 π)", WAVES)),
        ("wavelength", ("L", "L_0 tanh(2 π h/L)", WAVES)),
        ("h_b", ("h_b", "h + 5 H_13 tan(θ)", WAVES)),
        ("angle_deg", ("β", "", WAVES)),
        ("eta_star", ("η*", "0.75 (1 + cos(β)) λ_1 H_max", WAVES)),
        ("h_c_star", ("h_c*", "min(η*, h_c)", WAVES)),
        ("alpha_1", ("α_1", "", WAVES)),
        ("alpha_2", ("α_2", "", WAVES)),
        ("alpha_3", ("α_3", "", WAVES)),
        ("alpha_4", ("α_4", "", WAVES)),
        ("alpha_I", ("α_I", "", WAVES)),
        ("alpha_star", ("α*", "max(α_2, α_I)", WAVES)),
        ("p1", ("p_1", "0.5 (1 + cos(β)) (λ_1 α_1 + λ_2 α* cos(β)^2) ρ g H_max", WAVES)),
        ("p3", ("p_3", "α_3 p_1", WAVES)),
        ("p4", ("p_4", "α_4 p_1", WAVES)),
        ("pu", ("p_u", "0.5 (1 + cos(β)) λ_3 α_1 α_3 ρ g H_max", WAVES)),
    ];
    ALL.iter().find(|(known, _)| *known == name).map(|(_, told)| *told)
}

/// The page of all results.
pub fn page() -> String {
    let mut page = String::from(
        "# Results\n\n\
         A result has one name, which leads to the page that explains it: in the JSON of `assess`, as a column of a table, as a criterion, as a target of `design`, as an attribute in\n\
         Python; what is of all directions stands in `plan` there. Numbers are in SI units; of an object with a `length` forces are of the whole, in N. This page is written by\n\
         `cargo xtask gallery` from the list that the program itself reads.\n\n\
         ## Of a case\n\n| result | what it is | formula | unit |\n|---|---|---|---|\n",
    );
    for result in ResultName::ALL {
        let info = result.info();
        let unit = match info.kind {
            ResultKind::Number(dimension) => unit(dimension),
            ResultKind::Word(words) if words.len() > 6 => "a mode".to_owned(),
            ResultKind::Word(words) => {
                words.iter().map(|word| format!("`{word}`")).collect::<Vec<_>>().join(" ")
            }
            ResultKind::Truth => "true or false".to_owned(),
            ResultKind::Modes => "modes".to_owned(),
            ResultKind::Names => "names".to_owned(),
        };
        page.push_str(&row(info.name, &unit, info.words));
    }
    page.push_str(
        "\n## Of waves by Goda's formulas\n\nOn the way from the sea to what it presses with; they stand beside the others where a case has `[wave]`.\n\n\
         | result | what it is | formula | unit |\n|---|---|---|---|\n",
    );
    for result in SeaResult::ALL {
        let info = result.info();
        page.push_str(&row(info.name, &unit(info.dimension), info.words));
    }
    page.push_str(
        "\n## Of a motion, of probabilities\n\nThe JSON of `simulate`, `spectrum`, `directions` and `probability` is told word by word in its schemas:\n\
         [simulate](../simulate.schema.json), [spectrum](../spectrum.schema.json), [directions](../directions.schema.json), [probability](../probability.schema.json); that of `assess`, `design`\n\
         and `classify` in [answer](../answer.schema.json), [design](../design.schema.json), [boundary](../boundary.schema.json),\n\
         [changes](../changes.schema.json) and [point](../point.schema.json).\n",
    );
    page
}

fn row(name: &str, unit: &str, words: &str) -> String {
    let (symbol, formula, place) =
        told(name).unwrap_or_else(|| panic!("results.rs: nothing is told of {name}"));
    let formula = match (symbol, formula) {
        ("", "") => String::new(),
        ("", formula) | (formula, "") => format!("`= {formula}`"),
        (symbol, formula) => match formula.split_once("   where ") {
            Some((formula, condition)) => format!("`= {symbol} = {formula}` where `= {condition}`"),
            None => format!("`= {symbol} = {formula}`"),
        },
    };
    let (file, anchor) =
        place.split_once('#').map_or((place, String::new()), |(file, anchor)| (file, format!("#{anchor}")));
    format!("| [`{name}`](../theory/{file}.md{anchor}) | {words} | {formula} | {unit} |\n")
}

fn unit(dimension: Option<Dimension>) -> String {
    dimension.map_or_else(|| "1".to_owned(), Dimension::symbol)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every formula that the page has can be drawn, and nothing is told of what is not there.
    #[test]
    fn every_result_is_told() {
        let page = page();
        let names = ResultName::ALL
            .iter()
            .map(|one| one.info().name)
            .chain(SeaResult::ALL.iter().map(|one| one.info().name));
        for name in names {
            assert!(page.contains(&format!("| [`{name}`](../theory/")), "{name}");
        }
        crate::book::made("reference/results.md", &page, &crate::root()).unwrap();
    }
}
