//! Consistent modes on a base of strength q, and the one of them that is reported.

use std::cmp::Ordering::{Equal, Greater, Less};

use super::turning::{Rate, Turn};
use super::{CrushProblem, Numbers};
use crate::approx::Approx;
use crate::exact::{Exact, Real};
use crate::ground::roots::{RootSigned, RootSigns};
use crate::mode::{Corner, Mode, Modes, Slip};
use crate::twofold::Twofold;
use crate::verdict::{Decision, Verdict};

pub(super) const SLIPS: [Slip; 2] = [Slip::Left, Slip::Right];
pub(super) const CORNERS: [Corner; 2] = [Corner::O, Corner::OPrime];

/// Every mode tried: in tracked floating point, in twice its digits where that cannot tell, or exactly.
pub(super) fn enumerate(given: &impl CrushProblem) -> Decision {
    let float = given.numbers::<f64>();
    let found = of(&given.numbers::<Approx>(), &float)
        .or_else(|| of(&given.numbers::<Twofold>(), &float))
        .or_else(|| of(&given.numbers::<Exact>(), &float));
    found.expect("exact signs are always known")
}

/// True if the base cannot carry P: P ≥ q (b₁ + b₂).
pub(super) fn is_overloaded<T: RootSigned>(n: &Numbers<T>) -> Option<bool> {
    let [q0, q1] = n.q.clone();
    let reserve = q0 * (n.b[0].clone() + n.b[1].clone()) - q1 * n.p.clone();
    Some(reserve.sign()? != Greater)
}

/// 2q₀ times the moment that is left at an edge if the reaction P has the moment `about` C: not negative if the base bears it there.
fn reserve<T: Real>(n: &Numbers<T>, corner: Corner, about: T) -> T {
    let [q0, q1] = n.q.clone();
    let about = match corner {
        Corner::O => about,
        Corner::OPrime => -about,
    };
    T::of(2.0) * q0 * (about + n.edge(corner) * n.p.clone()) - q1 * n.p.clone() * n.p.clone()
}

/// True if a reaction P with the moment `about` C acts where the base can bear it.
fn is_borne<T: RootSigned>(n: &Numbers<T>, about: &T) -> Option<bool> {
    for corner in CORNERS {
        if reserve(n, corner, about.clone()).sign()? == Less {
            return Some(false);
        }
    }
    Some(true)
}

/// The signs of W at the roots of a turn's equation, and whether the turn begins from a = 0.
fn turn<T: RootSigned>(
    n: &Numbers<T>,
    float: &Numbers<f64>,
    corner: Corner,
    slip: Option<Slip>,
    slipping: Slip,
    mu: &T,
) -> Option<(RootSigns, bool)> {
    let lifted = n.p.sign()? != Greater;
    let turn = Turn::about(n, corner, slip);
    let begins = turn.surplus.sign()? == Greater;
    let rate = Rate::of(float, corner, slip, Turn::about(float, corner, slip).surplus);
    let near = if rate.is_monotone() {
        // One root at most, and none unless the equation is below zero where it begins.
        let equation = Turn::from_pressed(turn.equation.clone(), n, corner, lifted);
        if equation[0].sign()? != Less {
            return Some((RootSigns::NO_ROOT, begins));
        }
        rate.root().map(|a| if lifted { float.p + float.m_y * float.edge(corner) * a } else { a })
    } else {
        None
    };
    let w = turn.slipping(n, corner, slipping, mu);
    let [equation, w] = [turn.equation, w].map(|f| Turn::from_pressed(f, n, corner, lifted));
    // A root where the turn begins is none above it: it is divided out.
    let mut from = 0;
    while from + 1 < equation.len() && equation[from].sign()? == Equal {
        from += 1;
    }
    Some((T::at_roots(&equation[from..], &w, near)?, begins))
}

/// The verdict in an arithmetic; `None` if a sign is unknown.
fn of<T: RootSigned>(n: &Numbers<T>, float: &Numbers<f64>) -> Option<Decision> {
    if is_overloaded(n)? {
        return Some(Decision { modes: Modes::NONE, verdict: Some(Verdict::BearingFailure) });
    }
    let signed = |slip: Slip, value: &T| match slip {
        Slip::Left => -value.clone(),
        Slip::Right => value.clone(),
    };
    let pressed = n.p.sign()?;
    // The groups in which modes are reported, first to last.
    let [mut rest, mut slides, mut regular, mut rocks, mut others, mut flight] = [Modes::NONE; 6];
    // A body that crushes its edge may press less than before: it tips, cannot stick while it tips, and would not slip if it did not
    // tip. Then it slips, with μ_k, though μ_s would hold it upright.
    let mut last_resort = Modes::NONE;

    let grip = n.mu_s.clone() * n.p.clone();
    let mut is_pulled = [false; 2];
    for (slip, is_pulled) in SLIPS.into_iter().zip(&mut is_pulled) {
        *is_pulled = (signed(slip, &n.x) - grip.clone()).sign()? == Greater;
    }
    if pressed != Less {
        let at_rest = n.x.clone() * n.d.clone() - n.m.clone();
        if is_pulled == [false; 2] && is_borne(n, &at_rest)? {
            rest.insert(Mode::Rest);
        }
        let drag = n.mu_k.clone() * n.p.clone();
        for (slip, is_pulled) in SLIPS.into_iter().zip(is_pulled) {
            let can_slip = is_pulled || (signed(slip, &n.x) - drag.clone()).sign()? == Greater;
            if can_slip && is_borne(n, &(signed(slip, &(n.d.clone() * drag.clone())) - n.m.clone()))? {
                let group = if is_pulled { &mut slides } else { &mut last_resort };
                group.insert(Mode::slide(slip));
            }
        }
    }
    for corner in CORNERS {
        let mut sticks = true;
        for slip in SLIPS {
            // Friction to stick holds where it is not overcome at any root; there is one root at most.
            let (signs, _) = turn(n, float, corner, None, slip, &n.mu_s)?;
            sticks &= signs.zero + signs.negative > 0;
        }
        if sticks {
            rocks.insert(Mode::rock(corner));
        }
        for slip in SLIPS {
            let (signs, begins) = turn(n, float, corner, Some(slip), slip, &n.mu_k)?;
            if signs.positive > 0 {
                let group = if begins && !sticks { &mut regular } else { &mut others };
                group.insert(Mode::slide_rock(corner, slip));
            }
        }
    }
    if (n.mu_s.clone() - n.mu_k.clone()).sign()? == Greater {
        let sticks = |corner| !rest.is_empty() || rocks.contains(Mode::rock(corner));
        for corner in CORNERS.into_iter().filter(|corner| sticks(*corner)) {
            for slip in SLIPS {
                slides.remove(Mode::slide(slip));
                regular.remove(Mode::slide_rock(corner, slip));
                others.remove(Mode::slide_rock(corner, slip));
            }
        }
    }
    // Nothing presses: ÿ − b₁α ≥ 0, ÿ + b₂α ≥ 0, times m_y ρ². A body that touches without pressing is one that touches.
    if pressed != Greater && rest.is_empty() && slides.is_empty() {
        let fall = n.p.clone() * n.rho2.clone();
        let spin = n.m_y.clone() * n.m.clone();
        let at_o = (-fall.clone() - n.b[0].clone() * spin.clone()).sign()?;
        let at_o_prime = (n.b[1].clone() * spin - fall).sign()?;
        if at_o != Less && at_o_prime != Less {
            flight.insert(Mode::Flight);
        }
    }
    if [rest, slides, regular, rocks, others, flight].iter().all(|group| group.is_empty()) {
        slides = last_resort;
    }
    let groups = [rest, slides, regular, rocks, others, flight];
    let modes: Modes = groups.iter().flat_map(|group| group.iter()).collect();
    let verdict = groups.iter().find_map(|group| group.iter().next()).map(Verdict::Begins);
    Some(Decision { modes, verdict })
}
