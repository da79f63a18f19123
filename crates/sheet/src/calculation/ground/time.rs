//! A short thrust on springs: periods, and what the base bears when it bears most.

use standfast::Wrench;
use standfast::ground::impact::{ImpactEvent, ImpactResponse};
use standfast::history::{History, HistoryChange};
use standfast_cases::assess::Elastic;

use super::super::loads::{grouped, parts, sum};
use super::Sheet;
use crate::measured::{
    FOURTH, INERTIA, KILONEWTON, MASS, METRE, MOMENT, NONE, PER_SECOND, SECOND, SPRING, SPRING_OF_OBJECT,
    SQUARE, STIFFNESS, TURNING, TURNING_OF_OBJECT,
};
use crate::steps::SheetSteps;

/// Springs, mass and inertia of the whole, or of a metre.
struct Swaying {
    mass: f64,
    inertia: f64,
    height: f64,
    k_x: f64,
    k_θ: f64,
}

impl Sheet<'_> {
    pub(super) fn in_time(&self, steps: &mut SheetSteps, elastic: &Elastic) {
        let Some(periods) = elastic.periods else { return };
        steps.know("k_t", self.foundation.tangential_stiffness.unwrap_or_default(), STIFFNESS);
        steps.note(
            "On its springs the body sways and rocks in two modes. Their frequencies `ω_i` solve `m_s I ω_i^4 − (K_x (I + m_s y_C^2) + K_θ m_s) ω_i^2 + K_x K_θ` = 0.",
        );
        let body = self.assessed.situation.body();
        let mass = body.mass() + self.assessed.situation.added_mass();
        let (width, long) = (2.0 * self.reaction.half_width(), self.whole(1.0));
        let [k_n, k_t] =
            [self.foundation.stiffness, self.foundation.tangential_stiffness].map(Option::unwrap_or_default);
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
        let swaying =
            Swaying { mass, inertia: body.moment_of_inertia(), height: body.centroid_height(), k_x, k_θ };
        self.amplified(steps, impact, &swaying);
        if let Some([k, k_prime]) = elastic.moved {
            let about = "The loads in time take the point of the full load in the k–μ plane to";
            steps.add(about, "", ["k_T", "D_X |X|/V"], k, NONE, "k_moved");
            steps.add("", "", ["k'_T", "D_M V e_b/(D_X X y_C) − 1"], k_prime, NONE, "k_prime_moved");
        }
        if let Some(time) = impact.first_event().and_then(|found| found.time) {
            let name = match impact.first_event().map(|found| found.event) {
                Some(ImpactEvent::Slip) => "First event: the base slips, `|f_x|` = `μ f_y`",
                Some(ImpactEvent::Lift) => "First event: an edge is unloaded",
                _ => "First event: an edge reaches the strength",
            };
            steps.told(name, "t_1", time, SECOND, "its first zero", "first_event_time");
        }
    }

    /// D: formulas where the loads in time have one course; where they have several, what the sum is and why it is not put in.
    fn amplified(&self, steps: &mut SheetSteps, impact: &ImpactResponse, swaying: &Swaying) {
        let timed = self.components.iter().enumerate();
        let timed: Vec<(usize, Wrench, &History)> = timed
            .filter_map(|(i, component)| Some((i, component.wrench, component.load.history.as_ref()?)))
            .collect();
        let one = timed.first().filter(|(_, _, first)| timed.iter().all(|(_, _, other)| other == first));
        let Some((_, _, history)) = one else {
            steps.note(
                "The loads in time have different courses, each with moments, shares and static displacements of its own. What the base bears is \
                 the sum over loads, both modes and all moments of terms as `σ_i g_c (t − t_c − sin(ω_i (t − t_c))/ω_i)` and \
                 `σ_i j_c (1 − cos(ω_i (t − t_c)))`, for the moment with `ν_i` for `σ_i`; D is its largest size over the largest size of the \
                 loads' own sum at any moment. With so many terms the sum is not put in here: give the loads one `history`, or one load of \
                 both, for a sheet on which each step can be worked out.",
            );
            let words = "largest of that sum over time, over the largest of the loads";
            for (about, name, value, key) in [
                (
                    "Largest shear of the base over that of the loads in time",
                    "D_X",
                    impact.d_shear,
                    "D_shear",
                ),
                ("The same of the moment about the middle of the base", "D_M", impact.d_moment, "D_moment"),
            ] {
                if let Some(value) = value {
                    steps.told(about, name, value, NONE, words, key);
                }
            }
            return;
        };
        let total = timed.iter().fold(Wrench::ZERO, |sum, (_, wrench, _)| sum + *wrench);
        let moment = total.m - total.x * swaying.height;
        let named = |which: usize, part: fn(&Wrench) -> f64| {
            sum(timed.iter().map(|(i, wrench, _)| (parts(*i)[which].clone(), part(wrench))))
        };
        let about =
            "Loads in time at their whole size: their push, and their moment about the middle of the base";
        match named(0, |w| w.x) {
            Some(formula) => steps.add(about, "", ["X_T", &formula], total.x, KILONEWTON, ""),
            None => steps.know("X_T", 0.0, KILONEWTON),
        }
        let formula = match named(2, |w| w.m) {
            Some(turn) => format!("{} − X_T y_C", grouped(&turn)),
            None => "−X_T y_C".to_owned(),
        };
        steps.add("", "", ["M_T", &formula], moment, MOMENT, "");
        let peak = history.peak();
        steps.told("Their largest share in time", "f_m", peak, NONE, "as given", "");
        let changes = changes(steps, history);
        self.shares(steps, impact, swaying, (total.x, moment));
        let [shear_at, moment_at] = impact.largest_at;
        let both = [
            ("X", "shear", shear_at, impact.d_shear, "σ", "D_shear"),
            ("M", "moment about the middle of the base", moment_at, impact.d_moment, "ν", "D_moment"),
        ];
        for (of, what, at, factor, share, key) in both {
            let Some(factor) = factor else { continue };
            let when = format!("t_{of}");
            let about = format!("The base bears its largest {what} of them");
            steps.told(&about, &when, at, SECOND, "found by trial among all maxima", "");
            for mode in [1, 2] {
                let formula = course(&changes, mode, &when, at);
                let ω = std::f64::consts::TAU / impact.periods[mode - 1];
                let value = response(&changes, ω, at);
                let about = match mode {
                    1 => "Each mode is then at so much of its static displacement".to_owned(),
                    _ => String::new(),
                };
                steps.add(&about, "", [&format!("q_{mode}{of}"), &formula], value, NONE, "");
            }
            let formula = format!("|{share}_1 q_1{of} + {share}_2 q_2{of}|/(f_m |{of}_T|)");
            let about = format!("Largest {what} of the base over that of the loads in time");
            steps.add(&about, "", [&format!("D_{of}"), &formula], factor, NONE, key);
        }
    }

    /// ω, shape and share of both modes.
    fn shares(&self, steps: &mut SheetSteps, impact: &ImpactResponse, swaying: &Swaying, (x, m): (f64, f64)) {
        let Swaying { mass, inertia, height, k_x, k_θ } = *swaying;
        let name = |letter: &str, mode: usize| format!("{letter}_{mode}");
        for mode in [1, 2] {
            let ω = std::f64::consts::TAU / impact.periods[mode - 1];
            let about = if mode == 1 {
                "Both modes: frequency, sway over rotation, and share in shear and moment"
            } else {
                ""
            };
            steps.add(about, "", [&name("ω", mode), &format!("2 π/T_{mode}")], ω, PER_SECOND, "");
            let apart = mass * ω * ω - k_x;
            // Of both equations of the mode the one in which less cancels.
            let (formula, shape) = if apart.abs() > 0.1 * k_x {
                (format!("m_s y_C ω_{mode}^2/(m_s ω_{mode}^2 − K_x)"), mass * height * ω * ω / apart)
            } else {
                let arm = (inertia + mass * height * height) * ω * ω - k_θ;
                (
                    format!("((I + m_s y_C^2) ω_{mode}^2 − K_θ)/(m_s y_C ω_{mode}^2)"),
                    arm / (mass * height * ω * ω),
                )
            };
            steps.add("", "", [&name("ψ", mode), &formula], shape, METRE, "");
            let norm = k_x * shape * shape + k_θ;
            let work = shape * x + m;
            let over = format!("(ψ_{mode} X_T + M_T)/(K_x ψ_{mode}^2 + K_θ)");
            let formula = format!("K_x ψ_{mode} {over}");
            steps.add("", "", [&name("σ", mode), &formula], k_x * shape * work / norm, KILONEWTON, "");
            let formula = format!("K_θ {over}");
            steps.add("", "", [&name("ν", mode), &formula], k_θ * work / norm, MOMENT, "");
        }
    }
}

/// A change of a load in time, with the number in its names.
struct Numbered {
    change: HistoryChange,
    number: usize,
}

/// The moments at which a load changes, and by how much.
fn changes(steps: &mut SheetSteps, history: &History) -> Vec<Numbered> {
    let real =
        history.changes().into_iter().flatten().filter(|change| change.step != 0.0 || change.slope != 0.0);
    let numbered: Vec<_> = real.enumerate().map(|(i, change)| Numbered { change, number: i + 1 }).collect();
    for Numbered { change, number } in &numbered {
        let about = if *number == 1 {
            "Moments at which their share changes: its slope by g, and at once by j"
        } else {
            ""
        };
        steps.told(about, &format!("t_c{number}"), change.at, SECOND, "as given", "");
        for (letter, value, unit) in [("g_c", change.slope, PER_SECOND), ("j_c", change.step, NONE)] {
            if value != 0.0 {
                steps.told("", &format!("{letter}{number}"), value, unit, "as given", "");
            }
        }
    }
    numbered
}

/// A mode's response at a moment, in its static displacement, as a formula.
fn course(changes: &[Numbered], mode: usize, when: &str, at: f64) -> String {
    let mut terms = Vec::new();
    for Numbered { change, number } in changes.iter().filter(|numbered| numbered.change.at < at) {
        let past = format!("({when} − t_c{number})");
        if change.slope != 0.0 {
            terms.push(format!("g_c{number} ({past} − sin(ω_{mode} {past})/ω_{mode})"));
        }
        if change.step != 0.0 {
            terms.push(format!("j_c{number} (1 − cos(ω_{mode} {past}))"));
        }
    }
    terms.join(" + ")
}

fn response(changes: &[Numbered], ω: f64, at: f64) -> f64 {
    let before = changes.iter().map(|numbered| numbered.change).filter(|change| change.at < at);
    let one = |HistoryChange { at: from, step, slope }: HistoryChange| {
        let past = at - from;
        slope * (past - (ω * past).sin() / ω) + step * (1.0 - (ω * past).cos())
    };
    before.map(one).sum()
}
