//! Resistance of ground that fails, at one reaction after the other.

use standfast::ground::bearing::{BearingFactors, Ground, Reaction, inclination_exponent};
use standfast_cases::Key;
use standfast_cases::case::{COUPLING, Limit, T_H, T_M};

use super::Sheet;
use crate::measured::{DEGREE, KILONEWTON, KILOPASCAL, NONE, UNIT_WEIGHT};
use crate::steps::SheetSteps;

/// A reaction at which R is worked out, under the names that its quantities have.
pub(super) struct NamedReaction<'a> {
    pub reaction: Reaction,
    /// Vertical force, inclination without cohesion, effective width, and eccentricity over half the base.
    pub vertical: &'a str,
    pub push: &'a str,
    pub width: &'a str,
    pub share: &'a str,
    /// Suffix of the names of quantities at this reaction; empty under the full load.
    pub of: &'a str,
    /// The key of R.
    pub key: &'a str,
}

impl NamedReaction<'_> {
    /// A name that belongs to this reaction.
    fn name(&self, letter: &str) -> String {
        match (self.of, letter.contains('_')) {
            ("", _) => letter.to_owned(),
            (of, true) => format!("{letter}{of}"),
            (of, false) => format!("{letter}_{of}"),
        }
    }
}

const ENVELOPE: &str = "Butterfield and Gottardi";

/// The shape of a base of a given length: the shorter of its sides over the longer, and the shorter, as they are written.
struct Shape {
    share: (String, f64),
    narrow: String,
}

impl Shape {
    fn of(at: &NamedReaction<'_>, length: f64, width: f64) -> Shape {
        let name = at.width;
        if width <= length {
            Shape { share: (format!("{name}/L_b"), width / length), narrow: name.to_owned() }
        } else {
            Shape { share: (format!("L_b/{name}"), length / width), narrow: "L_b".to_owned() }
        }
    }
}

impl Sheet<'_> {
    pub(super) fn soil(&self) -> Option<Ground> {
        match self.ground.limit {
            Some(Limit::Ground(ground)) => Some(ground),
            _ => None,
        }
    }

    fn is_hansen(&self) -> bool {
        self.inputs.choice(Key::GroundLaw) == Some("hansen")
    }

    fn law(&self) -> &'static str {
        if self.is_hansen() { "Brinch Hansen, API RP 2GEO" } else { "EN 1997-1, Annex D" }
    }

    fn given(&self, key: Key) -> f64 {
        self.inputs.number(key).unwrap_or_default()
    }

    /// Shows the quantities that are equal for all reactions.
    pub(super) fn of_ground(&self, steps: &mut SheetSteps) {
        if let Some(ground) = self.soil().filter(|ground| ground.divisor() != 1.0) {
            let about = "Divisor of what the ground bears";
            steps.told(about, "γ_R", ground.divisor(), NONE, "resist: bearing", "");
        }
        if let Some(strength) = self.soil().and_then(|ground| ground.undrained_strength()) {
            steps.know("c_u", strength, KILOPASCAL);
            steps.know("q'", self.given(Key::Surcharge), KILOPASCAL);
            return;
        }
        match self.soil().and_then(|ground| ground.factors()) {
            Some(factors) => self.bearing_factors(steps, factors),
            None => {
                let or = |key, otherwise| self.inputs.number(key).unwrap_or(otherwise);
                steps.know("V_0", self.given(Key::CentricResistance), KILONEWTON);
                steps.know("t_h", or(Key::EnvelopeHorizontal, T_H), NONE);
                steps.know("t_m", or(Key::EnvelopeMoment, T_M), NONE);
                steps.know("C_e", or(Key::EnvelopeCoupling, COUPLING), NONE);
            }
        }
    }

    fn bearing_factors(&self, steps: &mut SheetSteps, factors: BearingFactors) {
        let law = self.law();
        steps.know("φ", self.given(Key::GroundAngle), DEGREE);
        steps.know("γ'", self.given(Key::UnitWeight), UNIT_WEIGHT);
        steps.know("q'", self.given(Key::Surcharge), KILOPASCAL);
        steps.know("c'", self.given(Key::Cohesion), KILOPASCAL);
        let formula = ["N_q", "exp(π tan(φ)) (tan(φ) + 1/cos(φ))^2"];
        steps.add("Bearing factors", law, formula, factors.n_q, NONE, "");
        let slope = if self.is_hansen() { "1.5 (N_q − 1) tan(φ)" } else { "2 (N_q − 1) tan(φ)" };
        steps.add("", law, ["N_γ", slope], factors.n_gamma, NONE, "");
        if self.given(Key::Cohesion) > 0.0 {
            steps.add("", law, ["N_c", "(N_q − 1)/tan(φ)"], factors.n_c, NONE, "");
        }
    }

    /// R at a reaction.
    pub(super) fn bears(&self, steps: &mut SheetSteps, at: &NamedReaction<'_>) {
        let Some(ground) = self.soil() else { return };
        let resistance = self.whole(ground.resistance(&at.reaction));
        let name = at.name("R");
        if at.reaction.effective_width() == 0.0 {
            let about = "What the ground bears at this eccentricity and inclination";
            return steps.told(about, &name, resistance, KILONEWTON, "the resultant misses the base", at.key);
        }
        if let Some(strength) = ground.undrained_strength() {
            return self.undrained(steps, at, (&ground, strength), resistance);
        }
        match ground.factors() {
            Some(factors) => self.by_factors(steps, at, factors, resistance),
            None => self.by_envelope(steps, at, resistance),
        }
    }

    fn by_factors(
        &self,
        steps: &mut SheetSteps,
        at: &NamedReaction<'_>,
        factors: BearingFactors,
        resistance: f64,
    ) {
        let law = self.law();
        let (surcharge, cohesion) = (self.given(Key::Surcharge), self.given(Key::Cohesion));
        let tan = self.given(Key::GroundAngle).to_radians().tan();
        let NamedReaction { reaction, vertical, push, width, .. } = at;
        let inclination = reaction.x().abs() / (reaction.p() + reaction.effective_width() * cohesion / tan);
        let formula = match cohesion {
            0.0 => format!("{push}/{vertical}"),
            _ => format!("{push}/({vertical} + {width}{} c'/tan(φ))", self.long),
        };
        let [η, i_q, i_c, i_gamma] = ["η", "i_q", "i_c", "i_γ"].map(|letter| at.name(letter));
        steps.add("Inclination of the resultant", law, [&η, &formula], inclination, NONE, "");
        let length = self.soil().and_then(|ground| ground.length());
        let share = |share: f64, n: f64| (1.0 - share * inclination).max(0.0).powf(n);
        let power = |factor: &str, n: &str| format!("max(0, 1 − {factor}{η})^{n}");
        let [of_q, of_gamma] = match (self.is_hansen(), length) {
            (true, _) => [(power("0.5 ", "5"), share(0.5, 5.0)), (power("0.7 ", "5"), share(0.7, 5.0))],
            (false, None) => [(power("", "2"), share(1.0, 2.0)), (power("", "3"), share(1.0, 3.0))],
            (false, Some(length)) => {
                let (m, name) = (inclination_exponent(reaction.effective_width() / length), at.name("m_B"));
                let formula = format!("(2 + {width}/L_b)/(1 + {width}/L_b)");
                steps.add(
                    "Exponent of the inclination, of a base that is not long",
                    law,
                    [&name, &formula],
                    m,
                    NONE,
                    "",
                );
                [
                    (power("", &name), share(1.0, m)),
                    (power("", &format!("({name} + 1)")), share(1.0, m + 1.0)),
                ]
            }
        };
        let shape = length.map(|length| Shape::of(at, length, reaction.effective_width()));
        let mut terms = Vec::new();
        if cohesion > 0.0 || surcharge > 0.0 {
            steps.add("Inclination factors", law, [&i_q, &of_q.0], of_q.1, NONE, "");
        }
        if cohesion > 0.0 {
            let value = (of_q.1 - (1.0 - of_q.1) / (factors.n_c * tan)).max(0.0);
            let formula = format!("max(0, {i_q} − (1 − {i_q})/(N_c tan(φ)))");
            steps.add("", law, [&i_c, &formula], value, NONE, "");
            terms.push(format!("c' N_c {i_c}"));
        }
        if surcharge > 0.0 {
            terms.push(format!("q' N_q {i_q}"));
        }
        steps.add("Inclination factor", law, [&i_gamma, &of_gamma.0], of_gamma.1, NONE, "");
        let mut narrow = width.to_string();
        let mut of_weight = i_gamma.clone();
        if let Some(shape) = &shape {
            let sin = self.given(Key::GroundAngle).to_radians().sin();
            let [s_c, s_q, s_gamma] = ["s_c", "s_q", "s_γ"].map(|letter| at.name(letter));
            let r = &shape.share.0;
            let (by_q, by_gamma) = if self.is_hansen() {
                let by_q = (format!("1 + {i_q} {r} sin(φ)"), 1.0 + of_q.1 * shape.share.1 * sin);
                (by_q, (format!("1 − 0.4 {i_gamma} {r}"), 1.0 - 0.4 * of_gamma.1 * shape.share.1))
            } else {
                let by_q = (format!("1 + {r} sin(φ)"), 1.0 + shape.share.1 * sin);
                (by_q, (format!("1 − 0.3 {r}"), 1.0 - 0.3 * shape.share.1))
            };
            let has_cohesion = cohesion > 0.0 && !self.is_hansen();
            if surcharge > 0.0 || has_cohesion {
                steps.add("Shape factors", law, [&s_q, &by_q.0], by_q.1, NONE, "");
            }
            if has_cohesion {
                let value = (by_q.1 * factors.n_q - 1.0) / (factors.n_q - 1.0);
                steps.add("", law, [&s_c, &format!("({s_q} N_q − 1)/(N_q − 1)")], value, NONE, "");
                terms[0] = format!("c' N_c {s_c} {i_c}");
            }
            if surcharge > 0.0 {
                let last = terms.len() - 1;
                terms[last] = format!("q' N_q {s_q} {i_q}");
            }
            steps.add("Shape factor", law, [&s_gamma, &by_gamma.0], by_gamma.1, NONE, "");
            of_weight = format!("{s_gamma} {i_gamma}");
            narrow.clone_from(&shape.narrow);
        }
        terms.push(format!("γ' {narrow}/2 N_γ {of_weight}"));
        let formula = format!("{width}{} ({}){}", self.long, terms.join(" + "), self.divided());
        let about = match (at.of, &shape) {
            ("", None) => {
                "What the ground bears at this eccentricity and inclination; depth, shape and slope have no factors"
            }
            ("", Some(_)) => {
                "What the ground bears at this eccentricity and inclination; depth and slope have no factors"
            }
            _ => "What the ground bears there",
        };
        steps.add(about, law, [&at.name("R"), &formula], resistance, KILONEWTON, at.key);
    }

    fn undrained(
        &self,
        steps: &mut SheetSteps,
        at: &NamedReaction<'_>,
        (ground, strength): (&Ground, f64),
        resistance: f64,
    ) {
        let law = self.law();
        let NamedReaction { reaction, push, width, .. } = at;
        let (effective, name) = (reaction.effective_width(), at.name("R"));
        let share = reaction.x().abs() / (effective * strength);
        let used = at.name("η_c");
        let formula = format!("{push}/({width}{} c_u)", self.long);
        let about = "Share of the shear strength under B' that the force takes";
        steps.add(about, law, [&used, &formula], share, NONE, "");
        if share > 1.0 {
            let why = "the force exceeds the shear strength under it: the body slides within the clay";
            let about = "What the ground bears at this eccentricity and inclination";
            return steps.told(about, &name, resistance, KILONEWTON, why, at.key);
        }
        let [i_c, s_c] = ["i_c", "s_c"].map(|letter| at.name(letter));
        let value = 0.5 * (1.0 + (1.0 - share).sqrt());
        let formula = format!("1/2 (1 + sqrt(1 − {used}))");
        steps.add("Inclination factor", law, [&i_c, &formula], value, NONE, "");
        let mut of_strength = format!("(π + 2) c_u {i_c}");
        if let Some(length) = ground.length() {
            let shape = Shape::of(at, length, effective);
            let formula = format!("1 + 0.2 {}", shape.share.0);
            steps.add("Shape factor", law, [&s_c, &formula], 1.0 + 0.2 * shape.share.1, NONE, "");
            of_strength = format!("(π + 2) c_u {s_c} {i_c}");
        }
        let besides = if self.given(Key::Surcharge) > 0.0 { " + q'" } else { "" };
        let formula = format!("{width}{} ({of_strength}{besides}){}", self.long, self.divided());
        let about = match at.of {
            "" => {
                "What clay that does not drain bears at this eccentricity and inclination; depth and slope have no factors"
            }
            _ => "What the ground bears there",
        };
        steps.add(about, law, [&name, &formula], resistance, KILONEWTON, at.key);
    }

    /// The divisor of what the ground bears, behind its formula; none where a combination does not divide it.
    fn divided(&self) -> &'static str {
        if self.soil().map_or(1.0, |ground| ground.divisor()) == 1.0 { "" } else { "/γ_R" }
    }

    fn by_envelope(&self, steps: &mut SheetSteps, at: &NamedReaction<'_>, resistance: f64) {
        let or = |key, otherwise| self.inputs.number(key).unwrap_or(otherwise);
        let (t_h, t_m, coupling) = (
            or(Key::EnvelopeHorizontal, T_H),
            or(Key::EnvelopeMoment, T_M),
            or(Key::EnvelopeCoupling, COUPLING),
        );
        let NamedReaction { reaction, vertical, push, share, .. } = at;
        let (η, against) = (reaction.inclination(), reaction.x() * reaction.e() < 0.0);
        let ε = if against { -reaction.eccentricity_share() } else { reaction.eccentricity_share() };
        let names = ["η", "ε_b", "r_b"].map(|letter| at.name(letter));
        let [inclination, eccentricity, radius] = names.each_ref().map(String::as_str);
        let formula = format!("{push}/{vertical}");
        steps.add("Inclination of the resultant", ENVELOPE, [inclination, &formula], η, NONE, "");
        let formula = if against { format!("−{share}") } else { (*share).to_owned() };
        let about = "Its eccentricity in half widths, positive towards the side that X pushes to";
        steps.add(about, ENVELOPE, [eccentricity, &formula], ε, NONE, "");
        let squared = (η / t_h).powi(2) + (ε / (2.0 * t_m)).powi(2) - coupling * η * ε / (t_h * t_m);
        let formula = format!(
            "sqrt(max(0, ({inclination}/t_h)^2 + ({eccentricity}/(2 t_m))^2 − C_e {inclination} {eccentricity}/(t_h t_m)))"
        );
        let about = "Radius on the envelope";
        steps.add(about, ENVELOPE, [radius, &formula], squared.max(0.0).sqrt(), NONE, "");
        let formula = format!("V_0 max(0, 1 − {radius}){}", self.divided());
        let about = "What the ground bears there";
        steps.add(about, ENVELOPE, [&at.name("R"), &formula], resistance, KILONEWTON, at.key);
    }
}
