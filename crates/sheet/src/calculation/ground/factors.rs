//! R/V under the full load, where it falls to 1 along the load, and along the way of the resultant.

use standfast::Wrench;
use standfast::ground::bearing::Reaction;
use standfast_cases::assess::BaseResponse;

use super::super::path::{self, Term};
use super::soil::NamedReaction;
use super::{LOST, Sheet};
use crate::measured::{KILONEWTON, METRE, MOMENT, NONE};
use crate::steps::SheetSteps;

const ABOUT: &str = "Load factor at which the ground fails";
/// By how much a number put in may miss what it is to give.
const CLOSE: f64 = 1e-9;

const GIVEN: [&str; 3] = ["X_G", "V_G", "M_G"];
const RISING: [&str; 3] = ["X_Q", "V_Q", "M_Q"];

/// A term of a sum: of a wrench its part and its name.
fn term(minus: bool, factor: &'static str, name: &'static str, value: f64) -> Term {
    (minus, factor, name, if minus { -value } else { value })
}

impl Sheet<'_> {
    /// R/V, where it falls to 1 along the load, and along the ray of the resultant.
    pub(super) fn factors(&self, steps: &mut SheetSteps) {
        let against = if self.assessed.situation.effects().is_some() { "V_d" } else { "V" };
        if let Some(factor) = self.ground.factor {
            let formula = format!("R/{against}");
            steps.add("Factor of the ground", "", ["F_R", &formula], factor, NONE, "ground_factor");
        }
        if let Some(margin) = self.ground.margin {
            let about = "What the ground leaves; rest needs 0 or more, beside what friction leaves";
            steps.add(
                about,
                "",
                ["Z_ground", &format!("R − {against}")],
                margin,
                KILONEWTON,
                "ground_margin",
            );
        }
        match (self.foundation.strength(), self.ground.load_factors) {
            (Some(strength), Some(factors)) => self.crushed_at(steps, strength, factors.given),
            (None, Some(_)) => {
                load_factors(
                    steps,
                    self.ground,
                    "the least λ at which R/V = 1, sought along the load; friction holds the body until then",
                );
                self.put_in(steps);
            }
            (_, None) => {}
        }
        self.along_ray(steps);
    }

    /// The permanent loads and the variable ones.
    fn parted(&self) -> [Wrench; 2] {
        [true, false].map(|permanent| {
            let of = self.components.iter().filter(|component| component.load.permanent == permanent);
            of.fold(Wrench::ZERO, |sum, component| sum + component.wrench)
        })
    }

    /// The names of both sums, as far as they are not zero; what is zero is known to be that.
    fn sums(&self, steps: &mut SheetSteps) -> [Wrench; 2] {
        let both = self.parted();
        for (permanent, (names, total)) in [(true, (GIVEN, both[0])), (false, (RISING, both[1]))] {
            let terms = [total.x, total.p, total.m];
            let terms: [Term; 3] = std::array::from_fn(|i| term(false, "", names[i], terms[i]));
            for (name, (_, _, _, value)) in names.iter().zip(&terms) {
                if *value == 0.0 {
                    steps.know(name, 0.0, if name.starts_with('M') { MOMENT } else { KILONEWTON });
                }
            }
            path::sums(steps, self.components, permanent, &terms, &total);
        }
        both
    }

    /// Shows the load factor at which a base that crushes ceases to bear: the least root of a quadratic.
    fn crushed_at(&self, steps: &mut SheetSteps, strength: f64, factor: f64) {
        const KEY: &str = "load_factor_ground";
        let told = |steps: &mut SheetSteps, words: &str| steps.told(ABOUT, "λ_R", factor, NONE, words, KEY);
        if factor == 0.0 {
            return told(steps, "the base does not bear the permanent loads alone");
        }
        if factor.is_infinite() {
            return told(steps, "no multiple of the variable loads takes the resultant off what can bear it");
        }
        let body = self.assessed.situation.body();
        let (half, y) = (body.base_width() / 2.0, body.centroid_height());
        let middle = (body.toe_distance() - body.heel_distance()) / 2.0;
        let [given, rising] = self.parted();
        let about = |w: &Wrench| w.x * y - w.m - middle * w.p;
        let right = about(&given) + factor * about(&rising) >= 0.0;
        let side = |w: &Wrench| if right { about(w) } else { -about(w) };
        let q = self.whole(strength);
        let zero = half * given.p - side(&given) - given.p * given.p / (2.0 * q);
        let one = half * rising.p - side(&rising) - given.p * rising.p / q;
        let two = rising.p * rising.p / (2.0 * q);
        let root = 2.0 * zero / ((one * one + 4.0 * zero * two).sqrt() - one);
        if (root - factor).abs() > CLOSE * factor {
            return told(
                steps,
                "the least λ at which the resultant leaves the part of the base that can bear it, a quadratic in λ",
            );
        }
        self.sums(steps);
        steps.note(&format!(
            "The base bears the resultant up to `B_c/2 V − |V e_b| − V^2/(2 q_u{})` = 0. With `V_G + λ V_Q` for V that is `c_0 + c_1 λ − c_2 λ^2`.",
            self.long
        ));
        let long = self.long;
        let moment = |[x, v, m]: [&str; 3]| match right {
            true => format!("({x} y_C − {m} − (b_2 − b_1)/2 {v})"),
            false => format!("({m} − {x} y_C + (b_2 − b_1)/2 {v})"),
        };
        let formula = format!("B_c V_G/2 − {} − V_G^2/(2 q_u{long})", moment(GIVEN));
        let about =
            "What the permanent loads leave of it, the variable ones take of it, and their square takes";
        steps.add(about, "", ["c_0", &formula], zero, MOMENT, "");
        let formula = format!("B_c V_Q/2 − {} − V_G V_Q/(q_u{long})", moment(RISING));
        steps.add("", "", ["c_1", &formula], one, MOMENT, "");
        steps.add("", "", ["c_2", &format!("V_Q^2/(2 q_u{long})")], two, MOMENT, "");
        let formula = "2 c_0/(sqrt(c_1^2 + 4 c_0 c_2) − c_1)";
        steps.add(&format!("{ABOUT}: its least zero"), "", ["λ_R", formula], factor, NONE, KEY);
    }

    /// The load factor of ground that fails put in: R/V there.
    fn put_in(&self, steps: &mut SheetSteps) {
        let (Some(ground), Some(factors)) = (self.soil(), self.ground.load_factors) else { return };
        let factor = factors.given;
        if factor == 0.0 || !factor.is_finite() {
            return;
        }
        let reaction = Reaction::of(&self.assessed.situation, factor).ok().flatten();
        let Some(reaction) = reaction.filter(|reaction| (ground.factor(reaction) - 1.0).abs() < 1e-6) else {
            return;
        };
        steps.note("It is found by trial. To check it, it is put in:");
        let [given, rising] = self.sums(steps);
        let at = |of: fn(&Wrench) -> f64| of(&given) + factor * of(&rising);
        steps.add("Loads at `λ_R`", "", ["V_R", "V_G + λ_R V_Q"], at(|w| w.p), KILONEWTON, "");
        steps.add("", "", ["X_R", "X_G + λ_R X_Q"], at(|w| w.x), KILONEWTON, "");
        steps.add("", "", ["M_R", "M_G + λ_R M_Q"], at(|w| w.m), MOMENT, "");
        let formula = "(X_R y_C − M_R)/V_R − (b_2 − b_1)/2";
        steps.add(
            "Their resultant, right of the middle of the base",
            "",
            ["e_R", formula],
            reaction.e(),
            METRE,
            "",
        );
        let width = reaction.effective_width();
        steps.add("Its effective width", "Meyerhof", ["B'_R", "B_c − 2 |e_R|"], width, METRE, "");
        self.bears(
            steps,
            &NamedReaction {
                reaction,
                vertical: "V_R",
                push: "|X_R|",
                width: "B'_R",
                share: "2 |e_R|/B_c",
                of: "R",
                key: "",
            },
        );
        steps.add("It is 1", "", ["F_RR", "R_R/V_R"], ground.factor(&reaction), NONE, "");
    }

    /// The inclination at which the ground fails on the way of the resultant.
    fn along_ray(&self, steps: &mut SheetSteps) {
        let Some(k_bf) = self.ground.k_bf else { return };
        let about = "`|X|÷V` at which the ground fails, if force and moment grow as they stand to each other";
        match self.soil() {
            None if k_bf.is_finite() => {
                let formula = "max(0, 1 − ω) B_c |X|/(2 |e_b| V)";
                steps.add(about, "", ["k_BF", formula], k_bf, NONE, "k_BF");
            }
            None => steps.told(about, "k_BF", k_bf, NONE, "the resultant stays in the middle", "k_BF"),
            Some(ground) => {
                let words = "the root of R/V = 1 on the way of the resultant, found by trial";
                steps.told(about, "k_BF", k_bf, NONE, words, "k_BF");
                let at = self.reaction;
                let grown = k_bf / at.inclination();
                let reaction = Reaction::new(at.half_width(), at.p(), grown * at.x(), grown * at.e()).ok();
                let holds = |reaction: &Reaction| (ground.factor(reaction) - 1.0).abs() < 1e-6;
                let Some(reaction) = reaction.filter(|reaction| k_bf > 0.0 && holds(reaction)) else {
                    return;
                };
                let width = reaction.effective_width();
                let formula = "B_c − 2 k_BF |e_b| V/|X|";
                steps.add(
                    "To check it, it is put in: the effective width",
                    "",
                    ["B'_k", formula],
                    width,
                    METRE,
                    "",
                );
                self.bears(
                    steps,
                    &NamedReaction {
                        reaction,
                        vertical: "V",
                        push: "k_BF V",
                        width: "B'_k",
                        share: "2 k_BF |e_b| V/(|X| B_c)",
                        of: "k",
                        key: "",
                    },
                );
                steps.add("It is 1", "", ["F_Rk", "R_k/V"], ground.factor(&reaction), NONE, "");
            }
        }
    }
}

/// Tells the load factor at which R/V falls to 1.
pub(super) fn load_factors(steps: &mut SheetSteps, ground: &BaseResponse, words: &str) {
    let Some(factors) = ground.load_factors else { return };
    steps.told(ABOUT, "λ_R", factors.given, NONE, words, "load_factor_ground");
    for (factor, name, words, key) in [
        (factors.less, "λ_Rm", "the same at φ − 2°", "load_factor_ground_less"),
        (factors.more, "λ_Rp", "the same at φ + 2°", "load_factor_ground_more"),
    ] {
        if let Some(factor) = factor {
            steps.told("", name, factor, NONE, words, key);
        }
    }
}

/// Tells these load factors where nothing presses on the base.
pub(super) fn of_lifted(steps: &mut SheetSteps, ground: &BaseResponse) {
    load_factors(steps, ground, LOST);
}
