//! docs/reference/keys.md: every key of a case file, from the table that parser, errors, `design` and the sheet share.

use standfast_cases::capital;
use standfast_cases::case::history_shapes;
use standfast_cases::key::{Key, Kind, Moves, Table};
use standfast_cases::units::{Dimension, Extent};

/// The page of all keys.
pub fn page() -> String {
    let mut page = String::from(
        "# The case file\n\n\
         A case is a TOML file: a body, and what acts on it. Quantities are numbers with a unit, as in\n\
         `\"450 kN/m\"`; a number without one is in SI units. Forces, masses and moments are per metre run. Of an object with a\n\
         `length`, and of a cylinder, they are of the whole, in kN, kg or t. A complete case:\n\n\
         ```toml\n\
         [body]\n\
         width = \"15 m\"\n\
         height = \"12 m\"\n\
         mass = \"378 t/m\"       # per metre run of the wall\n\
         friction = 0.6\n\n\
         [[load]]\n\
         force = \"2700 kN/m\"    # to the left\n\
         elevation = \"11.5 m\"   # above the base\n\
         ```\n\n\
         The folder `examples` has more. This page is written by `cargo xtask gallery` from the table of keys that the\n\
         program itself reads, and a test fails when it is stale. A key is named in `design` by its table and name: `body.width`,\n\
         `load[2].force`.\n",
    );
    // Tables that stand in another one beside it alone are told there.
    for table in Table::ALL.into_iter().filter(|table| !table.is_history() && *table != Table::Base) {
        let header = match table {
            Table::Top => "Above all tables".to_owned(),
            Table::History => "A history".to_owned(),
            _ => format!("`{}`", table.header()),
        };
        let words = match table {
            Table::Top => String::new(),
            _ => format!("{}.\n\n", capital(table.words())),
        };
        page.push_str(&format!("\n## {header}\n\n{words}| key | symbol | what it is | takes | example | if not given |\n|---|---|---|---|---|---|\n"));
        for key in table.keys().filter(|key| !is_further(*key)) {
            page.push_str(&row(key));
        }
        for child in table.children().filter(|child| child.is_history()) {
            let (name, example) = (child.name(), child.example());
            page.push_str(&format!(
                "| `{name}` |  | {} | a [history](#a-history) | `{example}` |  |\n",
                child.words()
            ));
        }
        if table == Table::Motion {
            page.push_str(BASE);
        }
        if table == Table::History {
            page.push_str(&shapes());
        }
    }
    page.push_str(
        "\n## What moves with what\n\n\
         `design` and sensitivities vary one number, and what has to go with it goes with it.\n\n| key | goes with it |\n|---|---|\n",
    );
    for key in Key::ALL.iter().filter(|key| key.info().moves != Moves::Alone) {
        let info = key.info();
        page.push_str(&format!("| `{}.{}` | {} |\n", info.table.name(), key.entry(), moves(info.moves)));
    }
    page.push_str(RANDOM);
    page
}

/// Row of the base's motion, which is a history for each direction.
const BASE: &str = "| `base` |  | how the base moves: a history for `horizontal`, to the right, and one for `vertical`, upwards; of a body \
    accelerations with their unit | [histories](#a-history) | `base = { horizontal = { shape = \"half-sine\", peak = \"4 m/s2\", duration = \"0.5 s\" } }` | it does not move |\n";

/// The tables of random numbers, which are of names and laws and not of keys.
const RANDOM: &str = r#"
## `[random]`

For `standfast probability`; see [theory](../theory/probability.md). Names are the keys above, a load by its name as in `load.push.force`, or a
bias: `bias.P`, `bias.U` (waves; their moments too unless `bias.M_p`, `bias.M_U` are given), `bias.force` (every `[[load]]`), `bias.H0` (the wave height in deep water),
`bias.H` (the wave heights at the wall, found or given) and `bias.R` (what the base bears).

| entry | what it is | example |
|---|---|---|
| a name | its law in braces | `friction = { normal = { mean = 0.6, sd = 0.1 } }` |
| `years` | the years of a life | `years = 50` |
| `events_per_year` | events a year on average, by Poisson's law, for numbers with `every = "event"`: peaks over a threshold | `events_per_year = 4.2` |
| `target_beta` | the index for which design values and partial factors are told, by EN 1990, Annex C | `target_beta = 3.8` |
| `sensitivities` | true: how the probability changes with mean and deviation of each law | `sensitivities = true` |
| `survived` | years through which the body stayed at rest: what that says of the years to come | `survived = 30` |
| `rise_per_year` | by how much the water level rises in each year of a life: each year has that of its middle | `rise_per_year = "5 mm"` |
| `bodies` | bodies alike in a row, of which any may move: caissons of a breakwater | `bodies = 20` |
| `[[random.correlation]]` | of a pair, by `rank` (Spearman), `linear` (of the values) or `normal` (of the normals behind them); of several a matrix | `between = ["bias.P", "bias.U"]`, `rank = 0.6`; `between = ["a", "b", "c"]`, `rank = [[1, 0.6, 0], [0.6, 1, 0.2], [0, 0.2, 1]]` |

| law | parameters; mean and deviation are those before it is cut |
|---|---|
| `normal`, `lognormal` | `mean` (the case's value if not given), and `sd` or `cov`; of `lognormal` also `log_mean` and `log_sd`, those of the logarithm in SI units |
| `gumbel` | of maxima: `mean` and `sd` or `cov`; `mode` and `scale`; or two return values as `"10 years" = "5.4 m"` |
| `weibull` | `scale`, `shape`, `location` (0 if not given) |
| `gev` | `location`, `scale`, `shape` (above zero: heavy) |
| `uniform` | `from`, `to` |
| `triangular` | `from`, `mode`, `to` |
| `beta` | between `from` and `to`: `mean` and `sd` or `cov`; or `alpha` and `beta` |
| `gamma` | `mean` and `sd` or `cov`; or `shape` and `scale`; from `location` (0 if not given) on |
| `exponential` | `mean`, or `scale` above `location` (0 if not given) |
| `gpd` | the generalised Pareto law, of what exceeds a threshold: `location`, `scale`, `shape` (above zero: heavy) |
| `discrete` | `values`, and the `probabilities` of each |
| `sample` | a list of values, each as likely: `sample = ["4.1 m", "3.7 m", "5.2 m"]` |
| `quantiles` | `values` with the `probabilities` below them, as `values = ["4 m", "5.5 m", "6.6 m"]`, `probabilities = [0.5, 0.9, 0.99]`; between them a curve that rises, beyond them straight on normal paper. `normals` in place of probabilities |
| `mixture` | a list of laws, each with its `probability`, and `lower` and `upper` of its own: `mixture = [{ probability = 0.9, gumbel = { … } }, { probability = 0.1, gpd = { … } }]` |
| `fitted` | `law` (of `normal`, `lognormal`, `gumbel`, `weibull`, `gev`, `exponential`, `gpd`) and the `values` that it is fitted to, five different ones or more; `location`, where `exponential` and `gpd` begin, and `weibull`, there 0 if not given. Not in `mixture` and `max_of`. Its parameters are random numbers of their own, drawn once: `wave.deep_water_height.mode` |
| `max_of` | `count`, and the law of which it is the largest, with its own `lower` and `upper` |
| beside any | `given = "wave.deep_water_height"`: the law depends on another random number, and some of its parameters are functions of it: `mean = { at = ["3 m", "6 m"], is = ["8 s", "11 s"] }`, straight between points and level beyond, `{ constant = 0, factor = 4.5, power = 0.5 }` or `{ constant = 0, factor = 4.5, rate = 0.1 }`, c + f xᵖ and c + f eʳˣ in SI units. Of `normal`, `lognormal`, `gumbel`, `weibull` (without `location`), `gev` and `uniform`, with all parameters written. Drawn as often as that number, or oftener; without correlations |
| beside any | `lower`, `upper` cut the law; `every = "year"` draws it anew each year, `"event"` in each event, `"life"` (if not given) once; `each = "body"` for each body of a row, `"row"` (if not given) for all of them |

`records = ["a.smc", "b.smc"]` are shakings for `--over pga=…` of a body with `[motion.base]`: every body that is drawn is followed under each of them, in the place of the case's own. With its vertical partner a record is `{ horizontal = "a.smc", vertical = "b.smc" }`: one factor scales both. There the numbers of `[motion.impact]` and `[motion.initial]` may be random too; those of `[motion.base]` are scaled to the peak.

In place of a body, `[point]` with `gamma`, `k_prime`, `k` and `mu` is a point of the report's plane; `[random]` names these four.

A `[storm]` without a body has its own numbers; `[random]` names these and `bias.P`, `bias.U`.
"#;

/// True if the key is the second or third number of a list, whose first one stands for it.
fn is_further(key: Key) -> bool {
    key.name() != key.entry() && Key::find(key.info().table, key.entry()) != Some(key)
}

fn row(key: Key) -> String {
    let info = key.info();
    let symbol = if info.symbol.is_empty() { String::new() } else { format!("`{}`", info.symbol) };
    let words = match key {
        Key::Lambda1 => "factors on the standing, the breaking pressure and the uplift",
        Key::AtX => "where the force acts, from the centre of mass",
        Key::DirectionX => "its direction and size",
        Key::InitialSlideO => "displacement of O and of O' along the base so far",
        _ => info.words,
    };
    let silent = info.silent.and_then(|silent| silent.split_once(": ")).map_or("", |(_, taken)| taken);
    let kind = match key {
        Key::InitialSlideO => "two numbers, of O and of O'".to_owned(),
        _ => takes(info.kind),
    };
    let (name, example) = (key.entry(), info.example);
    format!("| `{name}` | {symbol} | {words} | {kind} | `{name} = {example}` | {silent} |\n")
}

fn takes(kind: Kind) -> String {
    match kind {
        Kind::Text => "a text".to_owned(),
        Kind::Measured(dimension, range) => {
            format!("{} in {}; {}", dimension.words(), dimension.understood(), range.words())
        }
        Kind::Plain(range) => range.words().to_owned(),
        Kind::InGravity => format!(
            "a number with its unit: g, or an acceleration in {}",
            Dimension::Acceleration.understood()
        ),
        Kind::OneOf(2, _) => "two numbers, to the right and upwards".to_owned(),
        Kind::OneOf(..) => "three finite numbers, zero or more".to_owned(),
        Kind::Reached => format!(
            "a number without unit of a load; of the base an acceleration in g, {}",
            Dimension::Acceleration.understood()
        ),
        Kind::Plains => "a list of numbers without unit".to_owned(),
        Kind::File => "the name of a file beside the case".to_owned(),
        Kind::Truth => "`true` or `false`".to_owned(),
        Kind::Choice { words, .. } => words.to_owned(),
        Kind::Unit(dimension) => {
            let units = |dimension: Dimension| dimension.understood();
            match Extent::Whole.of(dimension) {
                whole if whole == dimension => units(dimension),
                whole => format!("{}; of an object {}", units(dimension), units(whole)),
            }
        }
        Kind::List(dimension) => format!("a list, each {} in {}", dimension.words(), dimension.understood()),
        Kind::Pairs(dimension) => {
            format!("a list of pairs, each number {} in {}", dimension.words(), dimension.understood())
        }
        Kind::Factors => "names and factors, zero or more, or two factors in a list".to_owned(),
        Kind::Settings => "names of keys, in quotes, and their values".to_owned(),
        Kind::Ratios => "names and numbers above zero".to_owned(),
        Kind::Spreads => "a share, from 0 to 1; or names and such shares".to_owned(),
        Kind::Places => "names and points, each a list of two lengths".to_owned(),
        Kind::Exceedances => {
            "a length and a share, above zero and 1 at most, in braces; or a list of such".to_owned()
        }
        Kind::Bounds => "criteria and their bounds, as in `[criteria]`".to_owned(),
        Kind::ModeList => "a list of symbols of modes".to_owned(),
    }
}

/// The shapes of a history, and what each takes.
fn shapes() -> String {
    let mut table = String::from("\n| shape | needs | may have, beside `start` |\n|---|---|---|\n");
    for (name, needs, open) in history_shapes() {
        let listed = |keys: &[Key]| {
            let names: Vec<_> = keys.iter().map(|key| format!("`{}`", key.name())).collect();
            names.join(", ")
        };
        table += &format!("| `{name}` | {} | {} |\n", listed(needs), listed(open));
    }
    table
}

fn moves(moves: Moves) -> &'static str {
    match moves {
        Moves::Alone => "nothing",
        Moves::Width => {
            "all dimensions along the base, and the mass, at constant density; of a cylinder in both directions"
        }
        Moves::Length => "the mass, at constant density",
        Moves::Height => "the mass at constant density, and so the crest above the sea",
        Moves::Mass => "everything that weighs",
        Moves::Friction => "friction to stick and to slip",
        Moves::WaterDensity => "the other of both, where it is given for still water and for waves",
        Moves::WaterLevel => "the level of the sea at the right, and the depths with it",
        Moves::BaseDepth => "the depth of the caisson's base, its crest staying where it is",
    }
}

#[cfg(test)]
mod tests {
    use standfast_cases::results::{ResultInfo, ResultKind, ResultName};

    /// The schema says of each result what the one list of results says.
    #[test]
    fn the_schema_has_the_words_of_the_list() {
        let schema = std::fs::read_to_string(crate::root().join("docs/answer.schema.json")).unwrap();
        let schema: serde_json::Value = serde_json::from_str(&schema).unwrap();
        for result in ResultName::ALL {
            let ResultInfo { name, kind, words, .. } = *result.info();
            let unit = match kind {
                ResultKind::Number(Some(dimension)) => format!(", {}", dimension.symbol()),
                _ => String::new(),
            };
            let said = match result.in_ground() {
                // Both periods are one list.
                Some("periods") => continue,
                None if result.is_of_plan() => &schema["$defs"]["plan"]["properties"][name]["description"],
                Some(name) => &schema["$defs"]["ground"]["properties"][name]["description"],
                None => &schema["$defs"]["situation"]["properties"][name]["description"],
            };
            assert_eq!(*said, serde_json::json!(format!("{words}{unit}")), "{name}");
        }
    }
}
