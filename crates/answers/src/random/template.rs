//! A `[random]` table to begin from: laws of practice for the numbers that a case has, each with its source.
//!
//! None of the sources was read for this program: the values are as the literature on caisson breakwaters and structural
//! reliability is remembered to hand them on, and the table says so line by line. They are a form to fill, no advice.

use std::fmt::Write;

use standfast::wave::Heights;

use crate::case::{Case, Weight};
use crate::digits::digits;
use crate::error::CaseError;
use crate::inputs::Inputs;
use crate::key::{Id, Key, Table};
use standfast_model::CaseFile;

/// Note that every line has.
const NOT_READ: &str = "recalled; not read in the original";

/// A law to begin from, for a number of a case that has none.
#[derive(Debug, Clone, PartialEq)]
pub struct ProposedLaw {
    /// The number's name in `[random]`.
    pub name: String,
    /// The name of the law.
    pub law: &'static str,
    /// Its mean; `None` of the case's own value.
    pub mean: Option<f64>,
    /// Its standard deviation as a share of the mean.
    pub cov: f64,
    /// Where it comes from, in a sentence or two.
    pub says: String,
}

impl ProposedLaw {
    /// The law as a case file has it.
    pub fn written(&self) -> String {
        self.written_as(self.law)
    }

    /// Another law of the same mean and deviation, as a case file has it.
    pub fn written_as(&self, law: &str) -> String {
        let mean = self.mean.map_or(String::new(), |mean| format!("mean = {mean}, "));
        format!("{{ {law} = {{ {mean}cov = {} }} }}", self.cov)
    }
}

/// A `[random]` table for the case of a file, which may be appended to it; a comment in the place of numbers that have no law of
/// practice.
///
/// # Errors
/// If the values of the case do not go together.
pub fn template(file: &CaseFile) -> Result<String, CaseError> {
    let case = file.case()?;
    let mut text = String::from(
        "# Laws of practice to begin from. Every source is recalled: none was read in the original for this table.\n\
         # Replace each by what you know of this body and this site. Means left out are the case's own values.\n",
    );
    if file.random().is_some() {
        text += "# The case has a [random] table already: merge the two, a file has only one.\n";
    }
    text += "[random]\n";
    text += "# years = 50                 # of a life; what is drawn anew each year says every = \"year\"\n";
    // A record that moves the base up and down as well goes with one that moves it to the side.
    if file.inputs().has(Table::BaseHorizontal) && !file.inputs().has(Table::BaseVertical) {
        text += "\n# Records in place of the one of the case, each as likely as the next; over their strength: --over \"pga=0.1 g..1 g:10\".\n\
                 # records = [\"near.csv\", \"far.csv\"]\n";
    }
    for line in proposed(&case, file.inputs()) {
        // A name with blanks or brackets stands in quotes.
        let is_bare = |letter: char| letter.is_ascii_alphanumeric() || "._-".contains(letter);
        let quote = if line.name.chars().all(is_bare) { "" } else { "\"" };
        let _ = write!(text, "\n# {}\n{quote}{}{quote} = {}\n", line.says, line.name, line.written());
    }
    if case.goda().is_some() {
        text += "\n# Forces and uplift of one wave err to the same side; by how much is not known here.\n\
                 # [[random.correlation]]\n# between = [\"bias.P\", \"bias.U\"]\n# rank = 0.5\n";
    }
    Ok(text)
}

/// Laws of practice for the numbers that a case has.
pub(super) fn proposed(case: &Case, inputs: &Inputs) -> Vec<ProposedLaw> {
    let line = |name: &str, law: &'static str, (mean, cov): (Option<f64>, f64), says: String| ProposedLaw {
        name: name.to_owned(),
        law,
        mean,
        cov,
        says,
    };
    let mut lines = Vec::new();
    if case.wave.is_some() {
        lines.push(line(
            "friction",
            "lognormal",
            (Some(0.636), 0.15),
            format!("Concrete on rubble: Takayama and Ikeda (1992), tests of sliding caissons; {NOT_READ}"),
        ));
    } else {
        let (cov, says) = match case.water.is_some() {
            true => {
                let says = format!(
                    "The scatter of concrete on rubble, Takayama and Ikeda (1992), about the case's {}; {NOT_READ}",
                    digits(case.friction)
                );
                (0.15, says)
            }
            false => {
                let says = format!(
                    "Friction: an assumption and no law of practice, about the case's {}. Measure it: pull the body, or a piece of the \
                     same stone, over the same floor.",
                    digits(case.friction)
                );
                (0.2, says)
            }
        };
        lines.push(line("friction", "lognormal", (None, cov), says));
    }
    for (place, joint) in case.joints.iter().enumerate() {
        let of = joint.name.clone().map_or_else(|| format!("[{}]", place + 2), |name| format!(".{name}"));
        let says = format!(
            "Friction in {}: an assumption and no law of practice, about the case's {}",
            joint.called(place),
            digits(joint.friction)
        );
        lines.push(line(&format!("joint{of}.friction"), "lognormal", (None, 0.15), says));
    }
    // How heavy a body is changes nothing of what its own inertia does to it.
    let shaken = inputs.has(Table::BaseHorizontal) || case.earthquake.is_some() && case.forces.is_empty();
    let dry = case.wave.is_none() && case.water.is_none() && case.pressures.is_empty();
    if inputs.get(Key::CentroidHeight).is_some() {
        lines.push(line(
            "body.centroid_height",
            "normal",
            (None, 0.05),
            "How well the height of the centre of mass is known: an assumption and no law of practice"
                .to_owned(),
        ));
    }
    if inputs.has(Table::Part) || shaken && dry {
        // Each part has a density of its own.
    } else if case.weight == Weight::Total {
        lines.push(line(
            "mass",
            "normal", (None, 0.03),
            format!(
                "Concrete: JCSS Probabilistic Model Code, part 2.1, gives 0.04 of its density, less for a whole body; {NOT_READ}"
            ),
        ));
    } else {
        lines.push(line(
            "body.buoyant_weight",
            "normal", (None, 0.03),
            format!(
                "Concrete: JCSS Probabilistic Model Code, part 2.1, gives 0.04 of its density, less for a whole body; {NOT_READ}"
            ),
        ));
    }
    if case.goda().is_some() {
        for (name, moments, of) in
            [("bias.P", (Some(0.91), 0.19), "horizontal force"), ("bias.U", (Some(0.77), 0.25), "uplift")]
        {
            lines.push(line(
                name,
                "lognormal",
                moments,
                format!(
                    "Measured over Goda's {of}: van der Meer, d'Angremond and Juhl (ICCE 1994) for vertical walls; {NOT_READ}"
                ),
            ));
        }
    }
    if case.goda().is_some_and(|waves| matches!(waves.heights, Heights::DeepWater(_))) {
        for (name, mean, says) in [
            ("bias.H0", 1.0, "How well the waves in deep water are known"),
            ("bias.H", 0.87, "Heights at the wall over those that the formulas for transformation give"),
        ] {
            let says = format!("{says}: Goda and Takagi (2000); {NOT_READ}");
            lines.push(line(name, "normal", (Some(mean), 0.10), says));
        }
    }
    if case.wave.is_some() {
        // Of the heights that are given that which makes the force.
        let heights = [Key::DeepWaterHeight, Key::Hmax, Key::WaveHeight];
        let height = heights.into_iter().find(|key| inputs.number(*key).is_some());
        let height = height.map_or("H13", Key::name);
        lines.push(line(
            &format!("wave.{height}"),
            "gumbel", (None, 0.2),
            "The sea: an assumption and no law of practice. Fit the yearly largest waves of the site, with every = \"year\", or give \
             two return values: { gumbel = { \"10 years\" = \"5.4 m\", \"100 years\" = \"6.9 m\" } }"
                .to_owned(),
        ));
    }
    let says =
        || format!("Load effects: JCSS Probabilistic Model Code, part 3.9, is of this order; {NOT_READ}");
    let variable: Vec<usize> =
        (0..case.forces.len()).filter(|index| !case.forces[*index].permanent).collect();
    match case.follows_opening() {
        // Water under the base follows each as it is.
        true => lines.extend(variable.into_iter().map(|index| {
            let force = Id::new(Key::Force, index);
            line(&force.to_string(), "lognormal", (None, 0.2), says())
        })),
        false if variable.is_empty() => {}
        false => lines.push(line("bias.force", "lognormal", (Some(1.0), 0.2), says())),
    }
    lines
}
