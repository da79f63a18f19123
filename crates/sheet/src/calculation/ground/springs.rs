//! An elastic base: the moment, the rotation that bears it, and the largest one.

use standfast::ground::elastic::ContactState;
use standfast_cases::assess::Elastic;
use standfast_cases::assess::ground::state;

use super::Sheet;
use crate::measured::{MOMENT, MRAD, NONE, STIFFNESS};
use crate::steps::SheetSteps;

impl Sheet<'_> {
    pub(super) fn elastic(&self, steps: &mut SheetSteps, elastic: &Elastic) {
        const LAW: &str = "springs without tension";
        let long = self.long;
        steps.know("k_n", self.foundation.stiffness.unwrap_or_default(), STIFFNESS);
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
        steps.add("in `(V B_c)÷2`", "", ["m_b", "2 |e_b|/B_c"], share, NONE, "");
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
                    / (self.foundation.stiffness.unwrap_or_default() * self.reaction.half_width().powi(2));
                let words = format!("Its rotation in `(4 V)÷(k_n B_c^2)`: {}", state(pressed));
                steps.add(&words, LAW, ["τ_b", τ], rotation / unit, NONE, "");
                let formula = format!("4 τ_b V/(k_n B_c^2{long})");
                steps.add(about, LAW, ["θ_b", &formula], rotation, MRAD, "rotation");
            }
            None => steps.note("No rotation bears the moment of the full load."),
        }
        let kappa = self.reaction.p() * self.assessed.situation.body().centroid_height()
            / (self.foundation.stiffness.unwrap_or_default() * self.reaction.half_width().powi(3));
        let formula = format!("8 V y_C/(k_n B_c^3{long})");
        steps.add("By how much the weight leans on the rotation", LAW, ["κ", &formula], kappa, NONE, "");
        let most = elastic.largest.moment / p_b;
        let about = format!(
            "The largest moment that is borne, in `(V B_c)÷2`; there {}",
            state(elastic.largest.state)
        );
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
            let about =
                "`|X|÷V` at which it is reached, if force and moment grow as they stand to each other";
            if k.is_finite() {
                steps.add(about, "", ["k_o", "m_max B_c |X|/(2 |e_b| V)"], k, NONE, "k_overturn");
            } else {
                steps.told(about, "k_o", k, NONE, "the resultant stays in the middle", "k_overturn");
            }
        }
        self.in_time(steps, elastic);
    }
}
