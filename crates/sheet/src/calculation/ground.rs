//! What the base bears: its effective width, resistance and stiffness, step by step.

use standfast::ground::bearing::Reaction;
use standfast::ground::elastic::ContactState;
use standfast::relation::Relation;
use standfast_cases::assess::OnGround;
use standfast_cases::assess::ground::{Elastic, left_out, state};
use standfast_cases::case::{COUPLING, Foundation, Limit, T_H, T_M};
use standfast_cases::units::Extent;
use standfast_cases::{Assessed, Case, Inputs, Key};

use crate::measured::{
    DEGREE, FOURTH, INERTIA, KILONEWTON, KILOPASCAL, MASS, METRE, MOMENT, MRAD, NONE, SECOND, SPRING,
    SPRING_OF_OBJECT, SQUARE, STIFFNESS, TURNING, TURNING_OF_OBJECT, UNIT_WEIGHT,
};
use crate::steps::Steps;

pub(super) fn steps(steps: &mut Steps, case: &Case, inputs: &Inputs, assessed: &Assessed) {
    let (Some(foundation), Some(ground)) = (&case.ground, &assessed.ground) else {
        // A criterion of any base.
        let asked = case.criteria.iter().any(|criterion| criterion.key == Key::GreatestEffective);
        let reaction = Reaction::of(&assessed.situation, 1.0).ok().flatten();
        if let Some(reaction) = reaction.filter(|_| asked) {
            steps.heading("Pressure on the effective width");
            width(steps, &reaction, case.extent, ["", ""]);
        }
        return;
    };
    steps.heading("Ground");
    for note in left_out(case) {
        steps.note(note);
    }
    let Some(reaction) = &ground.reaction else {
        steps.note("Nothing presses on the base: there is no resistance and no factor.");
        return load_factors(steps, foundation, ground);
    };
    let whole = case.extent == Extent::Whole;
    let sheet = Sheet { assessed, ground, reaction, long: if whole { " L_b" } else { "" } };
    width(steps, reaction, case.extent, ["effective_width", "effective_pressure"]);
    match foundation.limit {
        Some(Limit::Strength(strength)) => sheet.crushing(steps, strength),
        Some(Limit::Ground(_)) if inputs.number(Key::GroundAngle).is_some() => sheet.soil(steps, inputs),
        Some(Limit::Ground(_)) => sheet.envelope(steps, inputs),
        None => {}
    }
    sheet.factors(steps, foundation);
    if let Some(elastic) = &ground.elastic {
        sheet.elastic(steps, foundation, elastic);
    }
}

/// The conditions of what begins.
pub(super) fn decision(steps: &mut Steps, assessed: &Assessed) {
    steps.heading("Mode of response: the conditions of this base");
    steps.note(
        "The report’s inequalities are those of a rigid base, and do not decide here. The mode that begins satisfies the equations of motion below, \
         Coulomb’s law, and what the base bears.",
    );
    for relation in assessed.because() {
        // P is the horizontal force on this sheet.
        let quantity = match relation.quantity {
            "R/P" => "R/V",
            "R_s/P" => "R_s/V",
            "|X|/P" => "|X|/V",
            other => other,
        };
        if let Some(motion) = assessed.motion() {
            steps.know("f_y", motion.f_y, KILONEWTON);
        }
        steps.relation(&Relation { quantity, ..relation });
    }
}

struct Sheet<'a> {
    assessed: &'a Assessed,
    ground: &'a OnGround,
    reaction: &'a Reaction,
    /// The length, where forces are of the whole object.
    long: &'static str,
}

impl Sheet<'_> {
    /// A number of the library per metre run, of the whole where forces are.
    fn whole(&self, per_metre: f64) -> f64 {
        let body = self.assessed.situation.body();
        per_metre * body.plan().side(body.width())
    }

    fn crushing(&self, steps: &mut Steps, strength: f64) {
        steps.know("q_u", strength, KILOPASCAL);
        let long = self.long;
        let omega = self.ground.omega.unwrap_or_default();
        let formula = format!("V/(B_c q_u{long})");
        steps.add(
            "Share of the base that the vertical load crushes",
            "",
            ["ω", &formula],
            omega,
            NONE,
            "omega",
        );
        let motion = self.assessed.motion().filter(|_| self.ground.neutral().is_some());
        if let (Some(neutral), Some(motion)) = (self.ground.neutral(), motion) {
            steps.know("f_y", motion.f_y, KILONEWTON);
            let about = "Neutral point, inside the edge that goes down: the width that is crushed, of the reaction at onset below";
            let formula = format!("f_y/(q_u{long})");
            steps.add(about, "", ["c_n", &formula], neutral, METRE, "neutral");
            let about = "Place of the reaction, inside that edge";
            steps.add(about, "", ["c_p", "c_n/2"], neutral / 2.0, METRE, "pivot");
        } else if let Some(pivot) = self.ground.pivot() {
            let about = "Place of the reaction inside its edge, of a body about to turn";
            let formula = format!("V/(2 q_u{long})");
            steps.add(about, "", ["c_p", &formula], pivot, METRE, "pivot");
        }
        let resistance = self.ground.resistance.unwrap_or_default();
        let formula = format!("B' q_u{long}");
        let about = "What the base bears at this eccentricity";
        steps.add(about, "", ["R", &formula], resistance, KILONEWTON, "ground_resistance");
    }

    /// N_q, N_γ, inclination factors and R.
    fn soil(&self, steps: &mut Steps, inputs: &Inputs) {
        let angle = inputs.number(Key::GroundAngle).unwrap_or_default();
        let given = |key: Key| inputs.number(key).unwrap_or_default();
        let (surcharge, cohesion) = (given(Key::Surcharge), given(Key::Cohesion));
        let hansen = inputs.choice(Key::GroundLaw) == Some("hansen");
        let law = if hansen { "Brinch Hansen, API RP 2GEO" } else { "EN 1997-1, Annex D" };
        steps.know("φ", angle, DEGREE);
        steps.know("γ'", given(Key::UnitWeight), UNIT_WEIGHT);
        steps.know("q'", surcharge, KILOPASCAL);
        steps.know("c'", cohesion, KILOPASCAL);
        let Some(factors) = self.soil_factors() else { return };
        let formula = ["N_q", "exp(π tan(φ)) (tan(φ) + 1/cos(φ))^2"];
        steps.add("Bearing factors", law, formula, factors.n_q, NONE, "");
        let slope = if hansen { "1.5 (N_q − 1) tan(φ)" } else { "2 (N_q − 1) tan(φ)" };
        steps.add("", law, ["N_γ", slope], factors.n_gamma, NONE, "");
        let tan = angle.to_radians().tan();
        let resistance = self.ground.resistance.unwrap_or_default();
        let key = "ground_resistance";
        let about = "What the ground bears at this eccentricity and inclination; depth, shape and slope have no factors";
        if self.reaction.effective_width() == 0.0 {
            return steps.told(about, "R", resistance, KILONEWTON, "the resultant misses the base", key);
        }
        let adhesion = self.whole(self.reaction.effective_width() * cohesion / tan);
        let (x, p) = (self.whole(self.reaction.x()).abs(), self.whole(self.reaction.p()));
        let inclination = x / (p + adhesion);
        let formula = match cohesion {
            0.0 => "|X|/V".to_owned(),
            _ => format!("|X|/(V + B'{} c'/tan(φ))", self.long),
        };
        steps.add("Inclination of the resultant", law, ["η", &formula], inclination, NONE, "");
        let share = |share: f64, n: i32| (1.0 - share * inclination).max(0.0).powi(n);
        let [of_q, of_gamma] = match hansen {
            true => [("max(0, 1 − 0.5 η)^5", share(0.5, 5)), ("max(0, 1 − 0.7 η)^5", share(0.7, 5))],
            false => [("max(0, 1 − η)^2", share(1.0, 2)), ("max(0, 1 − η)^3", share(1.0, 3))],
        };
        let mut terms = Vec::new();
        if cohesion > 0.0 || surcharge > 0.0 {
            steps.add("Inclination factors", law, ["i_q", of_q.0], of_q.1, NONE, "");
        }
        if cohesion > 0.0 {
            steps.add("", law, ["N_c", "(N_q − 1)/tan(φ)"], factors.n_c, NONE, "");
            let i_c = (of_q.1 - (1.0 - of_q.1) / (factors.n_c * tan)).max(0.0);
            steps.add("", law, ["i_c", "max(0, i_q − (1 − i_q)/(N_c tan(φ)))"], i_c, NONE, "");
            terms.push("c' N_c i_c");
        }
        if surcharge > 0.0 {
            terms.push("q' N_q i_q");
        }
        terms.push("γ' B'/2 N_γ i_γ");
        steps.add("Inclination factor", law, ["i_γ", of_gamma.0], of_gamma.1, NONE, "");
        let formula = format!("B'{} ({})", self.long, terms.join(" + "));
        steps.add(about, law, ["R", &formula], resistance, KILONEWTON, key);
    }

    fn soil_factors(&self) -> Option<standfast::ground::bearing::BearingFactors> {
        match self.ground.limit {
            Some(Limit::Ground(ground)) => ground.factors(),
            _ => None,
        }
    }

    fn envelope(&self, steps: &mut Steps, inputs: &Inputs) {
        let or = |key, otherwise| inputs.number(key).unwrap_or(otherwise);
        let (t_h, t_m, c_e) = (
            or(Key::EnvelopeHorizontal, T_H),
            or(Key::EnvelopeMoment, T_M),
            or(Key::EnvelopeCoupling, COUPLING),
        );
        let centric = inputs.number(Key::CentricResistance).unwrap_or_default();
        steps.know("V_0", centric, KILONEWTON);
        for (name, value) in [("t_h", t_h), ("t_m", t_m), ("C_e", c_e)] {
            steps.know(name, value, NONE);
        }
        let reaction = self.reaction;
        let (η, side) = (reaction.inclination(), (reaction.x() * reaction.e()).signum());
        let ε = if reaction.e() == 0.0 || reaction.x() == 0.0 {
            reaction.eccentricity_share()
        } else {
            side * reaction.eccentricity_share()
        };
        const LAW: &str = "Butterfield and Gottardi";
        steps.add("Inclination of the resultant", LAW, ["η", "|X|/V"], η, NONE, "");
        let formula = if ε < 0.0 { "−2 |e_b|/B_c" } else { "2 |e_b|/B_c" };
        let about = "Its eccentricity in half widths, positive towards the side that X pushes to";
        steps.add(about, LAW, ["ε_b", formula], ε, NONE, "");
        let squared = (η / t_h).powi(2) + (ε / (2.0 * t_m)).powi(2) - c_e * η * ε / (t_h * t_m);
        let radius = squared.max(0.0).sqrt();
        let formula = "sqrt(max(0, (η/t_h)^2 + (ε_b/(2 t_m))^2 − C_e η ε_b/(t_h t_m)))";
        steps.add("Radius on the envelope", LAW, ["r_b", formula], radius, NONE, "");
        let resistance = self.ground.resistance.unwrap_or_default();
        let about = "What the ground bears there";
        if reaction.effective_width() == 0.0 {
            let words = "the resultant misses the base";
            return steps.told(about, "R", resistance, KILONEWTON, words, "ground_resistance");
        }
        steps.add(about, LAW, ["R", "V_0 max(0, 1 − r_b)"], resistance, KILONEWTON, "ground_resistance");
    }

    /// R/V, where it falls to 1 along the load, and along the ray of the resultant.
    fn factors(&self, steps: &mut Steps, foundation: &Foundation) {
        if let Some(factor) = self.ground.factor {
            steps.add("Factor of the ground", "", ["F_R", "R/V"], factor, NONE, "ground_factor");
        }
        load_factors(steps, foundation, self.ground);
        let Some(k_bf) = self.ground.k_bf else { return };
        let about = "|X|/V at which the ground fails, if force and moment grow as they stand to each other";
        match foundation.strength() {
            Some(_) if k_bf.is_finite() => {
                let formula = "max(0, 1 − ω) B_c |X|/(2 |e_b| V)";
                steps.add(about, "", ["k_BF", formula], k_bf, NONE, "k_BF");
            }
            Some(_) => steps.told(about, "k_BF", k_bf, NONE, "the resultant stays in the middle", "k_BF"),
            None => steps.told(
                about,
                "k_BF",
                k_bf,
                NONE,
                "the root of R/V = 1 on the way of the resultant",
                "k_BF",
            ),
        }
    }

    fn elastic(&self, steps: &mut Steps, foundation: &Foundation, elastic: &Elastic) {
        const LAW: &str = "springs without tension";
        let long = self.long;
        steps.know("k_n", foundation.stiffness.unwrap_or_default(), STIFFNESS);
        steps.heading("Elastic base");
        let p_b = self.reaction.p() * self.reaction.half_width();
        let share = elastic.moment.abs() / p_b;
        steps.add(
            "Moment of all loads about the middle of the base",
            "",
            ["M_b", "V |e_b|"],
            self.whole(elastic.moment.abs()),
            MOMENT,
            "",
        );
        steps.add("in V B_c/2", "", ["m_b", "2 |e_b|/B_c"], share, NONE, "");
        let about = "Rotation under the full load, raised slowly";
        match elastic.rotation {
            Some(rotation) => {
                let pressed = elastic.base.state(rotation).unwrap_or(ContactState::Full);
                let τ = match pressed {
                    ContactState::Full => "1.5 m_b",
                    ContactState::Uplift => "2/(9 (1 − m_b)^2)",
                    ContactState::Yield => "2 (1 − ω)/ω/(9 (1 − m_b ω/(1 − ω))^2)",
                    ContactState::UpliftAndYield => "1/sqrt(192 ω^3 (1 − ω − m_b))",
                };
                let unit = self.reaction.p()
                    / (foundation.stiffness.unwrap_or_default() * self.reaction.half_width().powi(2));
                let words = format!("Its rotation in 4V/(k_n B_c²): {}", state(pressed));
                steps.add(&words, LAW, ["τ_b", τ], rotation / unit, NONE, "");
                let formula = format!("4 τ_b V/(k_n B_c^2{long})");
                steps.add(about, LAW, ["θ_b", &formula], rotation, MRAD, "rotation");
            }
            None => steps.note("No rotation bears the moment of the full load."),
        }
        let kappa = self.reaction.p() * self.assessed.situation.body().centroid_height()
            / (foundation.stiffness.unwrap_or_default() * self.reaction.half_width().powi(3));
        let formula = format!("8 V y_C/(k_n B_c^3{long})");
        steps.add("By how much the weight leans on the rotation", LAW, ["κ", &formula], kappa, NONE, "");
        let most = elastic.largest.moment / p_b;
        let about =
            format!("The largest moment that is borne, in V B_c/2; there {}", state(elastic.largest.state));
        let formula = match elastic.largest.state {
            _ if most == 0.0 => None,
            ContactState::Full => None,
            ContactState::Uplift => Some("1 − (3 κ/2)^(1/3)"),
            ContactState::Yield => Some("(1 − ω)/ω (1 − (3 κ/2)^(1/3))"),
            ContactState::UpliftAndYield => Some("1 − ω − (9 κ^2/256)^(1/3)/ω"),
        };
        match formula {
            Some(formula) => steps.add(&about, LAW, ["m_max", formula], most, NONE, ""),
            None => steps.told(&about, "m_max", most, NONE, "the body does not stand on springs so soft", ""),
        }
        if let Some(k) = elastic.k_overturn {
            let about = "|X|/V at which it is reached, if force and moment grow as they stand to each other";
            if k.is_finite() {
                steps.add(about, "", ["k_o", "m_max B_c |X|/(2 |e_b| V)"], k, NONE, "k_overturn");
            } else {
                steps.told(about, "k_o", k, NONE, "the resultant stays in the middle", "k_overturn");
            }
        }
        self.in_time(steps, foundation, elastic);
    }

    fn in_time(&self, steps: &mut Steps, foundation: &Foundation, elastic: &Elastic) {
        let Some(periods) = elastic.periods else { return };
        steps.know("k_t", foundation.tangential_stiffness.unwrap_or_default(), STIFFNESS);
        steps.note(
            "On its springs the body sways and rocks in two modes. Their frequencies `ω_i` solve `m_s I ω_i^4 − (K_x (I + m_s y_C^2) + K_θ m_s) ω_i^2 + K_x K_θ` = 0.",
        );
        let body = self.assessed.situation.body();
        let mass = body.mass() + self.assessed.situation.added_mass();
        let (width, long) = (2.0 * self.reaction.half_width(), self.whole(1.0));
        let [k_n, k_t] =
            [foundation.stiffness, foundation.tangential_stiffness].map(Option::unwrap_or_default);
        let (k_x, k_θ) = (width * k_t * long, k_n * width.powi(3) / 12.0 * long);
        steps.know("I", body.moment_of_inertia(), INERTIA);
        let times = self.long;
        let springs =
            if times.is_empty() { [SPRING, TURNING] } else { [SPRING_OF_OBJECT, TURNING_OF_OBJECT] };
        let added = if self.assessed.situation.added_mass() > 0.0 { "m + m_a" } else { "m" };
        steps.add("Mass that sways", "", ["m_s", added], mass, MASS, "");
        steps.add("Springs of sway", "", ["K_x", &format!("B_c k_t{times}")], k_x, springs[0], "");
        steps.add("and of rocking", "", ["K_θ", &format!("k_n B_c^3/12{times}")], k_θ, springs[1], "");
        let half = (k_x * (body.moment_of_inertia() + mass * body.centroid_height().powi(2)) + k_θ * mass)
            / (2.0 * mass * body.moment_of_inertia());
        let product = k_x * k_θ / (mass * body.moment_of_inertia());
        let formula = "(K_x (I + m_s y_C^2) + K_θ m_s)/(2 m_s I)";
        steps.add("Mean of the squares of both frequencies", "", ["Ω_m", formula], half, SQUARE, "");
        steps.add("Their product", "", ["Ω_p", "K_x K_θ/(m_s I)"], product, FOURTH, "");
        let about = "Natural periods of sway and rocking";
        let formula = "2 π/sqrt(Ω_p/(Ω_m + sqrt(Ω_m^2 − Ω_p)))";
        steps.add(about, "", ["T_1", formula], periods[0], SECOND, "period_1");
        steps.add("", "", ["T_2", "2 π/sqrt(Ω_m + sqrt(Ω_m^2 − Ω_p))"], periods[1], SECOND, "period_2");
        let Some(impact) = &elastic.impact else { return };
        let words = "the exact response of both modes to loads that are linear from moment to moment";
        if let Some(shear) = impact.d_shear {
            let about = "Largest shear of the base over that of the loads in time";
            steps.told(about, "D_X", shear, NONE, words, "D_shear");
        }
        if let Some(moment) = impact.d_moment {
            steps.told(
                "The same of the moment about the middle of the base",
                "D_M",
                moment,
                NONE,
                words,
                "D_moment",
            );
        }
        if let Some(time) = impact.first_event().and_then(|found| found.time) {
            let name = match impact.first_event().map(|found| found.event) {
                Some(standfast::ground::impact::ImpactEvent::Slip) => {
                    "First event: the base slips, `|f_x|` = `μ f_y`"
                }
                Some(standfast::ground::impact::ImpactEvent::Lift) => "First event: an edge is unloaded",
                _ => "First event: an edge reaches the strength",
            };
            steps.told(name, "t_1", time, SECOND, "its first zero", "first_event_time");
        }
    }
}

/// Where R/V falls to 1 along the load.
fn load_factors(steps: &mut Steps, foundation: &Foundation, ground: &OnGround) {
    if let Some(factors) = ground.load_factors {
        let words = match foundation.strength() {
            Some(_) => {
                "the least λ at which the resultant leaves the part of the base that can bear it, a quadratic in λ"
            }
            None => "the least λ at which R/V = 1, sought along the load; friction holds the body until then",
        };
        let about = "Load factor at which the ground fails";
        steps.told(about, "λ_R", factors.given, NONE, words, "load_factor_ground");
        for (factor, name, words, key) in [
            (factors.less, "λ_R−", "the same at φ − 2°", "load_factor_ground_less"),
            (factors.more, "λ_R+", "the same at φ + 2°", "load_factor_ground_more"),
        ] {
            if let Some(factor) = factor {
                let name = if name.ends_with('+') { "λ_Rp" } else { "λ_Rm" };
                steps.told("", name, factor, NONE, words, key);
            }
        }
    }
}

/// The effective width and the pressure on it, under the names of the JSON.
fn width(steps: &mut Steps, reaction: &Reaction, extent: Extent, keys: [&str; 2]) {
    let about = "Resultant of all loads, right of the middle of the base";
    steps.add(about, "", ["e_b", "(X y_C − M)/V − (b_2 − b_1)/2"], reaction.e(), METRE, "");
    let (width, pressure) = (reaction.effective_width(), reaction.effective_pressure());
    let about = "Effective width, which has the resultant in its middle";
    if width > 0.0 {
        steps.add(about, "Meyerhof", ["B'", "B_c − 2 |e_b|"], width, METRE, keys[0]);
        let formula = if extent == Extent::Whole { "V/(B' L_b)" } else { "V/B'" };
        steps.add("Pressure on it", "", ["p_b", formula], pressure, KILOPASCAL, keys[1]);
    } else {
        let words = "the resultant misses the base";
        steps.told(about, "B'", width, METRE, words, keys[0]);
        steps.told("Pressure on it", "p_b", pressure, KILOPASCAL, words, keys[1]);
    }
}
