//! The conditions of the ten modes, as quantities whose signs decide.
//!
//! Each is linear in the wrench, and linear in the friction too (for a fixed ratio of μ_s to μ_k): in slide-rock,
//! where N and the friction multiply, what is quadratic in μ cancels. So along a load that grows in proportion every
//! boundary is crossed at most once, and in a plane of load and friction every boundary is a hyperbola.

use std::cmp::Ordering::{self, Equal, Greater, Less};

use crate::approx::Signed;
use crate::exact::Real;
use crate::mode::{Corner, Mode, Modes, Slip};

/// b₁, b₂, d, ρ², m_x, m_y, μ_s, μ_k, X, P, M.
pub(crate) type Numbers<T> = [T; 11];

/// The rotation about a corner, α = `moment`/`inertia`.
pub(super) struct Rotation<T> {
    pub(super) moment: T,
    pub(super) inertia: T,
}

impl<T: Real> Rotation<T> {
    /// The rotation of a mode that turns about a corner, slipping or not.
    #[inline]
    pub(super) fn of(numbers: &Numbers<T>, corner: Corner, slip: Option<Slip>) -> Rotation<T> {
        match slip {
            Some(slip) => Rotation::slipping(numbers, corner, slip),
            None => Rotation::rocking(numbers, corner),
        }
    }

    /// α = (Pr − Xd + M)/(ρ² + m_xd² + m_yr²).
    #[inline]
    pub(super) fn rocking(numbers: &Numbers<T>, corner: Corner) -> Rotation<T> {
        let [_, _, d, rho2, m_x, m_y, _, _, x, p, m] = numbers;
        let r = position(numbers, corner);
        Rotation {
            moment: p.clone() * r.clone() - x.clone() * d.clone() + m.clone(),
            inertia: rho2.clone() + m_x.clone() * d.clone() * d.clone() + m_y.clone() * r.clone() * r,
        }
    }

    /// α = (Pc + M)/(ρ² + m_yrc), c = r − sμ_kd.
    #[inline]
    pub(super) fn slipping(numbers: &Numbers<T>, corner: Corner, slip: Slip) -> Rotation<T> {
        let [_, _, d, rho2, _, m_y, _, mu_k, _, p, m] = numbers;
        let r = position(numbers, corner);
        let c = r.clone() - T::of(slip.sign()) * mu_k.clone() * d.clone();
        Rotation { moment: p.clone() * c.clone() + m.clone(), inertia: rho2.clone() + m_y.clone() * r * c }
    }
}

/// r: −b₁ at O, b₂ at O'.
#[inline]
fn position<T: Real>(numbers: &Numbers<T>, corner: Corner) -> T {
    match corner {
        Corner::O => -numbers[0].clone(),
        Corner::OPrime => numbers[1].clone(),
    }
}

/// Numbers of quantities of each kind, in their order.
pub(crate) const REST: usize = 4;
const SLIDES: usize = 4;
const CORNER: usize = 12;
const ROCK: usize = 4;
const SLIDE_ROCK: usize = 4;
pub(crate) const COUNT: usize = REST + SLIDES + 2 * CORNER + 3;

/// The quantities of rest: none of the first two above zero, how much the body is pulled to the left and to the right beyond what friction
/// holds; none of the others below, what holds it down at O and at O'.
#[inline]
pub(crate) fn rest<T: Real>(numbers: &Numbers<T>) -> [T; REST] {
    let [b1, b2, d, _, _, _, mu_s, _, x, p, m] = numbers;
    let grip = mu_s.clone() * p.clone();
    let moment = x.clone() * d.clone() - m.clone();
    [
        -x.clone() - grip.clone(),
        x.clone() - grip,
        moment.clone() + b1.clone() * p.clone(),
        b2.clone() * p.clone() - moment,
    ]
}

/// True if a body rests for certain, and slips nowhere besides: its friction is below Painlevé's bound.
pub(crate) fn rests_alone<T: Signed>(numbers: &Numbers<T>) -> bool {
    let [left, right, at_o, at_o_prime] = rest(numbers).map(|quantity| quantity.sign());
    let turns = || CORNERS.into_iter().flat_map(|corner| SLIPS.map(|slip| (corner, slip)));
    [left, right] == [Some(Less); 2]
        && [at_o, at_o_prime] == [Some(Greater); 2]
        && turns()
            .all(|(corner, slip)| Rotation::slipping(numbers, corner, slip).inertia.sign() == Some(Greater))
}

/// The quantities, in the order that [`Choice::of`] reads them.
pub(crate) fn conditions<T: Real>(numbers: &Numbers<T>) -> [T; COUNT] {
    let [b1, b2, d, rho2, m_x, m_y, mu_s, mu_k, x, p, m] = numbers;
    let mul = |a: &T, b: &T| a.clone() * b.clone();
    let sub = |a: &T, b: &T| a.clone() - b.clone();
    let signed = |slip: Slip, value: &T| match slip {
        Slip::Left => -value.clone(),
        Slip::Right => value.clone(),
    };
    // −b₁P ≤ Nξ ≤ b₂P: the reaction acts on the base.
    let on_base = |moment: T| [moment.clone() + mul(b1, p), mul(b2, p) - moment];

    let mut all = QuantityList { all: std::array::from_fn(|_| T::of(0.0)), count: 0 };
    all.extend(rest(numbers));
    // slide to the left, to the right: on the base
    for slip in SLIPS {
        all.extend(on_base(sub(&signed(slip, &mul(&mul(mu_k, d), p)), m)));
    }
    for corner in CORNERS {
        let r = position(numbers, corner);
        // rock, times J: moment, normal reaction, friction's reserve to the left and to the right
        let Rotation { moment, inertia } = Rotation::rocking(numbers, corner);
        let normal = sub(&mul(p, &inertia), &mul(m_y, &mul(&r, &moment)));
        let tangential = mul(x, &inertia) + mul(m_x, &mul(d, &moment));
        let cone = mul(mu_s, &normal);
        all.extend([moment, normal, sub(&cone, &tangential), cone + tangential]);
        // slide-rock to the left, to the right, times J: J, moment, normal reaction, s(ẍ + dα)
        for slip in SLIPS {
            let Rotation { moment, inertia } = Rotation::slipping(numbers, corner, slip);
            let normal = sub(&mul(p, &inertia), &mul(m_y, &mul(&r, &moment)));
            let pull = sub(&mul(x, &inertia), &signed(slip, &mul(mu_k, &normal)));
            let base = signed(slip, &(pull + mul(m_x, &mul(d, &moment))));
            all.extend([inertia, moment, normal, base]);
        }
    }
    // flight, times m_y ρ²: ÿ − b₁α, ÿ + b₂α
    let fall = mul(p, rho2);
    let spin = mul(m_y, m);
    all.extend([-fall.clone() - mul(b1, &spin), mul(b2, &spin) - fall]);
    // whether stick is stronger than slip
    all.extend([sub(mu_s, mu_k)]);
    debug_assert_eq!(all.count, COUNT);
    all.all
}

/// The quantities so far: in place, because this is where the time of a load path goes.
struct QuantityList<T> {
    all: [T; COUNT],
    count: usize,
}

impl<T> QuantityList<T> {
    #[inline]
    fn extend<const N: usize>(&mut self, more: [T; N]) {
        for value in more {
            self.all[self.count] = value;
            self.count += 1;
        }
    }
}

/// The consistent modes and the one reported.
pub(crate) struct Choice {
    pub(crate) modes: Modes,
    pub(crate) mode: Option<Mode>,
}

impl Choice {
    /// Reads the signs of the [`conditions`]; `None` if one is unknown.
    pub(super) fn of<T: Signed>(conditions: [T; COUNT]) -> Option<Choice> {
        let mut signs = [Equal; COUNT];
        for (sign, condition) in signs.iter_mut().zip(conditions) {
            *sign = condition.sign()?;
        }
        Some(Choice::of_signs(&signs))
    }

    /// Reads the signs in their order.
    pub(crate) fn of_signs(signs: &[Ordering; COUNT]) -> Choice {
        let (rest_signs, signs) = signs.split_at(REST);
        let (slide_signs, signs) = signs.split_at(SLIDES);
        let (corner_signs, signs) = signs.split_at(2 * CORNER);
        let (flight_signs, friction_signs) = signs.split_at(2);
        let none_negative = |signs: &[Ordering]| signs.iter().all(|sign| *sign != Less);

        // Whether a mode that touches the base does so without reaction: its motion is flight's.
        let mut unpressed = flight_signs == [Equal, Equal];
        // The groups in which modes are reported, first to last.
        let [mut rest, mut slides, mut regular, mut rocks, mut painlevé, mut flight] = [Modes::NONE; 6];
        let (pulled, on_base) = rest_signs.split_at(2);
        if pulled.iter().all(|sign| *sign != Greater) && none_negative(on_base) {
            rest.insert(Mode::Rest);
        }
        for ((slip, pulled), on_base) in SLIPS.into_iter().zip(pulled).zip(slide_signs.chunks(2)) {
            if *pulled == Greater && none_negative(on_base) {
                slides.insert(Mode::slide(slip));
            }
        }
        for (corner, signs) in CORNERS.into_iter().zip(corner_signs.chunks(CORNER)) {
            // σα > 0 lifts the other corner.
            let lifting = if corner == Corner::O { Greater } else { Less };
            let (rock, slide_rocks) = signs.split_at(ROCK);
            if rock[0] == lifting && none_negative(&rock[1..]) {
                rocks.insert(Mode::rock(corner));
                unpressed |= rock[1] == Equal;
            }
            for (slip, signs) in SLIPS.into_iter().zip(slide_rocks.chunks(SLIDE_ROCK)) {
                let orientation = signs[0];
                let same = |sign: Ordering| if orientation == Less { sign.reverse() } else { sign };
                let [turns, presses, slips] = [signs[1], signs[2], signs[3]].map(same);
                if orientation != Equal && turns == lifting && presses != Less && slips == Greater {
                    let group = if orientation == Greater { &mut regular } else { &mut painlevé };
                    group.insert(Mode::slide_rock(corner, slip));
                    unpressed |= presses == Equal;
                }
            }
        }
        if friction_signs == [Greater] {
            let sticks = |corner| !rest.is_empty() || rocks.contains(Mode::rock(corner));
            for corner in CORNERS.into_iter().filter(|corner| sticks(*corner)) {
                for slip in SLIPS {
                    slides.remove(Mode::slide(slip));
                    regular.remove(Mode::slide_rock(corner, slip));
                    painlevé.remove(Mode::slide_rock(corner, slip));
                }
            }
        }
        if none_negative(flight_signs) && !unpressed {
            flight.insert(Mode::Flight);
        }

        let groups = [rest, slides, regular, rocks, painlevé, flight];
        let modes: Modes = groups.iter().flat_map(|group| group.iter()).collect();
        let mode = groups.iter().find_map(|group| group.iter().next());
        Choice { modes, mode }
    }
}

const SLIPS: [Slip; 2] = [Slip::Left, Slip::Right];
const CORNERS: [Corner; 2] = [Corner::O, Corner::OPrime];
