//! Rest on a footprint, and where it ends as loads rise: forms in the load factor that are not below zero while the body rests.
//!
//! A form is linear for an edge, a quadratic for friction and for the rim of a disc, a quartic for a disc under a moment about its centre of
//! pressure. The load factors at which a body rests are an interval, since the wrenches that a base can bear are a convex cone. So the first
//! zero of each form ends it, and signs at λ = 0 and λ = 1 are those of exact arithmetic.

use std::cell::OnceCell;
use std::cmp::Ordering::{self, Equal, Greater, Less};

use super::{BaseWrench, Footprint, Shape, edges};
use crate::approx::{Approx, Signed, sign};
use crate::ball::Ball;
use crate::exact::Real;
use crate::polynomial::{product, quadratic_roots, value};
use crate::stability::{Margins, Stability, beside_one, ratio};

/// What ends rest on a footprint.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum PlanLimit {
    /// Friction holds no more.
    Slides,
    /// The centre of pressure has come to an edge, counted from zero; of a disc to its rim.
    Tips {
        /// From the vertex of its number to the next; zero of a disc.
        edge: usize,
    },
    /// Nothing presses it on its base any more.
    Lifts,
    /// On a disc, friction holds no more against a force and a moment about the centre of pressure together.
    Turns,
}

/// Where a body leaves rest as its variable loads rise from nothing.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanDeparture {
    /// λ; zero if it does not rest to begin with, infinite if it never leaves rest.
    pub load_factor: f64,
    /// True if the permanent loads alone move it.
    pub at_once: bool,
    /// The limits that are reached; several where that happens together, to 12 digits of λ.
    pub limits: Vec<PlanLimit>,
    /// True if the body rests under the full load, λ = 1.
    pub rests: bool,
    /// The forces and moments at the departure; `None` if it never leaves rest.
    pub wrench: Option<BaseWrench>,
    /// What friction and what the base leave under the full load: above, at or below nothing.
    left: [Ordering; 2],
}

/// Overturning about one edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct EdgeTurn {
    /// The moment that holds the body over that of the horizontal forces.
    pub(crate) factor: f64,
    /// The moment that presses it on its base, N·m.
    pub(crate) margin: f64,
}

impl PlanDeparture {
    /// Puts factors and margins on the side on which the signs are.
    pub(crate) fn settle(&self, stability: &mut Stability, margins: &mut Margins) {
        let pairs = [
            (&mut stability.sliding, &mut margins.sliding),
            (&mut stability.overturning_about_heel, &mut margins.overturning_about_heel),
        ];
        for ((factor, margin), sign) in pairs.into_iter().zip(self.left) {
            // Without a push, or beside the base, there is no factor to be 1.
            if sign != Equal || (*factor > 0.0 && factor.is_finite()) {
                *factor = beside_one(*factor, sign);
            }
            *margin = match sign {
                Equal => 0.0,
                Less => margin.min(-f64::MIN_POSITIVE),
                Greater => margin.max(f64::MIN_POSITIVE),
            };
        }
    }
}

/// A moment about the vertical through the centre of pressure, on a base on which what it bears of that hangs on a pressure that nobody knows.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("the loads turn the body about the vertical by {moment} N m; only a disc has one answer to that")]
pub struct Torsion {
    /// T_c under the full load, counter-clockwise from above, N·m.
    pub moment: f64,
}

/// The numbers of a problem of rest.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Problem<T> {
    pub(crate) footprint: Footprint<T>,
    pub(crate) friction: T,
    pub(crate) permanent: BaseWrench<T>,
    pub(crate) variable: BaseWrench<T>,
}

/// Limits whose load factors differ by no more than this share are reached together.
const TIED: f64 = 1e-12;

/// A moment about the centre of pressure that is no more than this share of the moments it is the difference of is none but for rounding.
const NO_TORSION: f64 = 1e-9;

impl Footprint {
    /// Where a body of a friction leaves rest as its variable loads rise; signs are decided for the f64 given, without rounding.
    ///
    /// # Errors
    /// On a polygon, if the loads have a moment about the vertical through their centre of pressure.
    pub fn departure(
        &self,
        friction: f64,
        permanent: &BaseWrench,
        variable: &BaseWrench,
    ) -> Result<PlanDeparture, Torsion> {
        let as_given =
            Problem { footprint: self.clone(), friction, permanent: *permanent, variable: *variable };
        as_given.map(|x| Approx::of(*x)).departure(&|| as_given.map(|x| Ball::of(*x)))
    }

    /// Where a body that never slides leaves rest as its variable loads rise: it tips, or is lifted.
    ///
    /// # Errors
    /// As [`departure`](Footprint::departure).
    pub fn departure_held(
        &self,
        permanent: &BaseWrench,
        variable: &BaseWrench,
    ) -> Result<PlanDeparture, Torsion> {
        /// A friction on which nothing slides.
        const HELD: f64 = 1e30;
        self.departure(HELD, permanent, variable)
    }
}

impl<T> Problem<T> {
    pub(crate) fn map<U>(&self, of: impl Fn(&T) -> U) -> Problem<U> {
        Problem {
            footprint: self.footprint.map(&of),
            friction: of(&self.friction),
            permanent: self.permanent.map(&of),
            variable: self.variable.map(&of),
        }
    }
}

impl Problem<Approx> {
    /// The departure by tracked rounding; `exact` has the numbers that decide where that cannot.
    pub(crate) fn departure(&self, exact: &dyn Fn() -> Problem<Ball>) -> Result<PlanDeparture, Torsion> {
        let turns = match (self.torsion(), &self.footprint.0) {
            (Some(torsion), Shape::Polygon(..)) => return Err(torsion),
            (torsion, _) => torsion.is_some(),
        };
        let approx = forms(self, turns);
        let made = OnceCell::new();
        let exact = || made.get_or_init(|| forms(&exact(), turns));
        let term = |form: usize, power: usize| {
            approx[form].terms[power].sign().unwrap_or_else(|| sign(&exact()[form].terms[power]))
        };
        let full: Vec<Ordering> = (0..approx.len())
            .map(|form| approx[form].at_one().sign().unwrap_or_else(|| sign(&exact()[form].at_one())))
            .collect();
        let rests = !full.contains(&Less);
        let least = |is_it: fn(PlanLimit) -> bool| {
            let signs = approx.iter().zip(&full).filter(|(form, _)| is_it(form.limit)).map(|(_, sign)| *sign);
            signs.min().unwrap_or(Greater)
        };
        let left = [
            least(|limit| matches!(limit, PlanLimit::Slides | PlanLimit::Turns)),
            least(|limit| matches!(limit, PlanLimit::Tips { .. })),
        ];
        let starts: Vec<Ordering> = (0..approx.len()).map(|form| term(form, 0)).collect();
        if starts.contains(&Less) {
            let broken = (0..approx.len()).filter(|form| starts[*form] == Less);
            let limits = told(broken.map(|form| approx[form].limit).collect());
            let wrench = Some(self.permanent.map(|part| part.value()));
            return Ok(PlanDeparture { load_factor: 0.0, at_once: true, limits, rests, wrench, left });
        }
        let mut exits: Vec<Option<f64>> = (0..approx.len())
            .map(|form| {
                let terms: Vec<f64> = approx[form].terms.iter().map(|term| term.value()).collect();
                // From the first power that says which way it goes.
                let first = (0..terms.len()).find(|power| term(form, *power) != Equal)?;
                if term(form, first) == Less { Some(0.0) } else { first_zero(&terms[first..]) }
            })
            .collect();
        if turns {
            let nearest = exits.iter().flatten().copied().fold(f64::INFINITY, f64::min);
            let place = approx.len() - 1;
            exits[place] =
                exits[place].filter(|exit| *exit == 0.0).or_else(|| self.turning_exit(&approx, nearest));
        }
        let load_factor = exits.iter().flatten().copied().fold(f64::INFINITY, f64::min);
        let near = |exit: f64| exit <= load_factor * (1.0 + TIED);
        // A zero that rounding hides is one of the forms that fail under the full load.
        let reached = (0..approx.len()).filter(|form| match load_factor {
            f64::INFINITY => full[*form] == Less,
            _ => exits[*form].is_some_and(near),
        });
        let limits = told(reached.map(|form| approx[form].limit).collect());
        // On the side of 1 on which the signs are.
        let load_factor = match rests {
            true if full.contains(&Equal) && (load_factor - 1.0).abs() <= 1e-9 => 1.0,
            true => beside_one(load_factor, Greater),
            false => beside_one(load_factor, Less),
        };
        let wrench = (load_factor < f64::INFINITY).then(|| self.at(load_factor));
        Ok(PlanDeparture { load_factor, at_once: false, limits, rests, wrench, left })
    }

    /// True if a form under the permanent or under the full load is within rounding of its zero.
    pub(crate) fn is_near(&self) -> bool {
        let turns = self.torsion().is_some();
        forms(self, turns).iter().any(|form| form.terms[0].sign().is_none() || form.at_one().sign().is_none())
    }

    fn at(&self, factor: f64) -> BaseWrench {
        let [permanent, variable] = [&self.permanent, &self.variable].map(|wrench| wrench.map(|x| x.value()));
        permanent.plus(variable.times(factor))
    }

    /// The moment about the centre of pressure, where it is more than rounding for some load factor.
    fn torsion(&self) -> Option<Torsion> {
        let terms = torsion(self);
        let reach = self.footprint.map(|x| x.value()).size();
        let size = |wrench: &BaseWrench<Approx>| {
            let parts = [&wrench.x, &wrench.z, &wrench.p, &wrench.q_x, &wrench.q_z];
            let [x, z, p, q_x, q_z] = parts.map(|part| part.value().abs());
            [p * reach + q_x + q_z, x + z]
        };
        let [[p0, x0], [p1, x1]] = [size(&self.permanent), size(&self.variable)];
        let sizes = [p0 * x0, p0 * x1 + p1 * x0, p1 * x1];
        let is_one =
            terms.iter().zip(sizes).any(|(term, size)| term.value().abs() > NO_TORSION * size + term.error());
        is_one.then(|| Torsion { moment: self.at(1.0).torsion() })
    }

    /// Where a disc begins to slide and turn at once, before it would slide or tip without a moment; that is an end of the search.
    fn turning_exit(&self, forms: &[Form<Approx>], end: f64) -> Option<f64> {
        let numbers = |terms: &[Approx]| terms.iter().map(|term| term.value()).collect::<Vec<f64>>();
        let of =
            |limit: PlanLimit| forms.iter().find(|form| form.limit == limit).map(|form| numbers(&form.terms));
        let (grip, rim) = (of(PlanLimit::Slides)?, of(PlanLimit::Tips { edge: 0 })?);
        let turning = numbers(&torsion(self));
        // In factors, whose product loses digits near its zero when it is multiplied out.
        let at = |factor: f64| {
            let [grip, rim, turning] = [&grip, &rim, &turning].map(|terms| value(terms, &factor));
            grip * rim - turning * turning
        };
        let mut outside = match end {
            f64::INFINITY => {
                (0..200).map(|power| f64::from(power - 60).exp2()).find(|factor| at(*factor) < 0.0)?
            }
            end => end,
        };
        let mut inside = 0.0;
        loop {
            let middle = inside + (outside - inside) / 2.0;
            if middle <= inside || middle >= outside {
                return Some(outside);
            }
            if at(middle) < 0.0 { outside = middle } else { inside = middle }
        }
    }
}

impl Footprint {
    /// Overturning about each edge by horizontal forces against what vertical ones hold; of a disc about the rim to which they push.
    pub(crate) fn overturning(&self, push: &BaseWrench, vertical: &BaseWrench) -> Vec<EdgeTurn> {
        let p = push.p + vertical.p;
        if let Shape::Circle { centre: [c_x, c_z], radius } = &self.0 {
            let held = [vertical.q_x - p * c_x, vertical.q_z - p * c_z];
            let margin = radius * p - (held[0] + push.q_x).hypot(held[1] + push.q_z);
            // So many times the push bring c to the rim.
            let along = held[0] * push.q_x + held[1] * push.q_z;
            let bend = push.q_x * push.q_x + push.q_z * push.q_z;
            let inside = radius * radius * p * p - held[0] * held[0] - held[1] * held[1];
            let factor = match () {
                () if inside < 0.0 || p < 0.0 => 0.0,
                () if bend == 0.0 => f64::INFINITY,
                () => ((along * along + bend * inside).sqrt() - along) / bend,
            };
            return vec![EdgeTurn { factor, margin }];
        }
        let edges = self.normals().into_iter().zip(self.distances());
        let turn = |([n_x, n_z], distance): ([f64; 2], f64)| {
            let holding = distance * p - vertical.q_x * n_x - vertical.q_z * n_z;
            let turning = push.q_x * n_x + push.q_z * n_z;
            EdgeTurn { factor: ratio(holding, turning), margin: holding - turning }
        };
        edges.map(turn).collect()
    }

    /// The horizontal force that friction has to hold, N: |X|, and on a disc √(|X|² + T_c²/(R² − |c|²)).
    pub fn on_friction(&self, full: &BaseWrench) -> f64 {
        let (Shape::Circle { centre, radius }, Some([x, z])) = (&self.0, full.centre_of_pressure()) else {
            return full.horizontal();
        };
        let moment = full.torsion();
        let [beside_x, beside_z] = [x - centre[0], z - centre[1]];
        let arm = radius * radius - beside_x * beside_x - beside_z * beside_z;
        let reach = NO_TORSION * self.size() * full.horizontal();
        if moment.abs() <= reach {
            return full.horizontal();
        }
        if arm > 0.0 { full.horizontal().hypot(moment / arm.sqrt()) } else { f64::INFINITY }
    }

    /// A length, m, that nothing of it is farther away than from the point under the centre of mass.
    pub fn size(&self) -> f64 {
        match &self.0 {
            Shape::Polygon(vertices, _) => vertices.iter().map(|[x, z]| x.hypot(*z)).fold(0.0, f64::max),
            Shape::Circle { centre: [x, z], radius } => x.hypot(*z) + radius,
        }
    }
}

/// A form in the load factor that is not below zero while the body rests.
struct Form<T> {
    limit: PlanLimit,
    /// Of ascending powers.
    terms: Vec<T>,
}

impl<T: Real> Form<T> {
    fn at_one(&self) -> T {
        self.terms.iter().cloned().fold(T::of(0.0), |sum, term| sum + term)
    }
}

/// The forms of a problem; the last is that of a moment, on a disc that one `turns`.
fn forms<T: Real>(problem: &Problem<T>, turns: bool) -> Vec<Form<T>> {
    let part = |of: fn(&BaseWrench<T>) -> &T| {
        [&problem.permanent, &problem.variable].map(|wrench| of(wrench).clone())
    };
    let [x, z, p, q_x, q_z] =
        [part(|w| &w.x), part(|w| &w.z), part(|w| &w.p), part(|w| &w.q_x), part(|w| &w.q_z)];
    let grip = p.clone().map(|p| problem.friction.clone() * p);
    let friction = less(&less(&product(&grip, &grip), &product(&x, &x)), &product(&z, &z));
    let mut forms = vec![
        Form { limit: PlanLimit::Lifts, terms: p.to_vec() },
        Form { limit: PlanLimit::Slides, terms: friction.clone() },
    ];
    match &problem.footprint.0 {
        Shape::Polygon(vertices, _) => {
            for (edge, [from, to]) in edges(vertices).enumerate() {
                let [e_x, e_z] = [0, 1].map(|along| to[along].clone() - from[along].clone());
                let term = |power: usize| {
                    let about =
                        |q: &[T; 2], along: usize| q[power].clone() - p[power].clone() * from[along].clone();
                    e_x.clone() * about(&q_z, 1) - e_z.clone() * about(&q_x, 0)
                };
                forms.push(Form { limit: PlanLimit::Tips { edge }, terms: vec![term(0), term(1)] });
            }
        }
        Shape::Circle { centre, radius } => {
            let about = |q: &[T; 2], along: usize| {
                [0, 1].map(|power| q[power].clone() - p[power].clone() * centre[along].clone())
            };
            let [about_x, about_z] = [about(&q_x, 0), about(&q_z, 1)];
            let rim = p.clone().map(|p| radius.clone() * p);
            let rim =
                less(&less(&product(&rim, &rim), &product(&about_x, &about_x)), &product(&about_z, &about_z));
            forms.push(Form { limit: PlanLimit::Tips { edge: 0 }, terms: rim.clone() });
            if turns {
                let turning = torsion(problem);
                let terms = less(&product(&friction, &rim), &product(&turning, &turning));
                forms.push(Form { limit: PlanLimit::Turns, terms });
            }
        }
    }
    forms
}

/// T P − Q × X: the moment about the centre of pressure times P.
fn torsion<T: Real>(problem: &Problem<T>) -> Vec<T> {
    let part = |of: fn(&BaseWrench<T>) -> &T| {
        [&problem.permanent, &problem.variable].map(|wrench| of(wrench).clone())
    };
    let about_c = product(&part(|w| &w.t), &part(|w| &w.p));
    let of_force =
        less(&product(&part(|w| &w.q_x), &part(|w| &w.z)), &product(&part(|w| &w.q_z), &part(|w| &w.x)));
    less(&about_c, &of_force)
}

/// One form less another of the same powers.
fn less<T: Real>(one: &[T], two: &[T]) -> Vec<T> {
    one.iter().zip(two).map(|(one, two)| one.clone() - two.clone()).collect()
}

/// The first zero above zero of a form that is above zero at zero: a line, or a quadratic; of higher powers none is looked for.
fn first_zero(terms: &[f64]) -> Option<f64> {
    let positive = |zero: f64| (zero > 0.0 && zero.is_finite()).then_some(zero);
    match *terms {
        [start, slope] if slope < 0.0 => positive(-start / slope),
        [start, slope, bend] => {
            quadratic_roots([start, slope, bend]).into_iter().filter_map(positive).reduce(f64::min)
        }
        _ => None,
    }
}

/// The limits that are told of those reached: a body that lifts does nothing else first, and a moment has no share in what happens without it.
fn told(reached: Vec<PlanLimit>) -> Vec<PlanLimit> {
    if reached.contains(&PlanLimit::Lifts) {
        return vec![PlanLimit::Lifts];
    }
    let is_alone = reached.iter().all(|limit| *limit == PlanLimit::Turns);
    reached.into_iter().filter(|limit| is_alone || *limit != PlanLimit::Turns).collect()
}
