//! The probabilities of one set of loads: of an event, of a first departure, of a life.

use std::borrow::Cow;

use standfast_probability::form::{FormPoint, apart, boundary_points, design_point};
use standfast_probability::integrate::{MOST_DIMENSIONS, Within, integrate_life};
use standfast_probability::life::{Life, lives};
use standfast_probability::method::{Found, Method, by, by_known, estimates, integral_or, within};
use standfast_probability::problem::Outcomes;
use standfast_probability::sample::{Effort, Estimate};
use standfast_probability::slopes::slopes;
use standfast_watch::Portion;

use super::answer::{ChanceRequest, Chances, FirstDeparture, Happening, LifeChances, Stood};
use super::departure::{AT_ONCE, Departures, NEVER};
use super::design_values::DesignValues;
use super::error::ProbabilityError;
use super::joined::{AnyOf, MOVES};
use super::outcome::{LIFTED, NOT_UNIQUE, REST, not_rest};
use super::problem::ChanceProblem;

/// Φ(−β) is not a probability, but none is so many times as likely.
const UNLIKELIER: f64 = 1e-2;

/// The sets asked for: what excludes each other, and then the others.
fn sets(problem: &ChanceProblem) -> Vec<u64> {
    problem
        .exclusive()
        .map(|outcome| 1 << outcome)
        .chain([not_rest(), 1 << NOT_UNIQUE, 1 << LIFTED])
        .collect()
}

/// The modes of an event and that the body does not rest, and nothing else.
pub(super) fn event(
    problem: &ChanceProblem,
    request: &ChanceRequest,
    portion: Portion<'_>,
) -> Result<(Vec<(Happening, Estimate)>, Estimate), ProbabilityError> {
    let (problem, points) = placed(problem);
    let sampled = sampled(&problem, &points, request, portion)?.sampled;
    let count = problem.exclusive().count();
    let modes = problem.exclusive().map(Happening::of).zip(sampled.estimates.iter().copied()).collect();
    Ok((modes, sampled.estimates[count]))
}

/// The nearest points at which the body does not rest (or if it does not at the medians, at which it rests), and the problem along the number that matters there.
fn placed(problem: &ChanceProblem) -> (Cow<'_, ChanceProblem>, Vec<FormPoint>) {
    let points = boundary_points(problem.laws(), problem, not_rest(), 1 << REST);
    let along = points.first().and_then(|point| problem.along_what_matters(&point.alpha));
    (along.map_or(Cow::Borrowed(problem), Cow::Owned), points)
}

/// The method asked for, or the one that suits so many numbers and the nearest points at which the body does not rest.
pub(super) fn method(
    problem: &ChanceProblem,
    request: &ChanceRequest,
    points: &[FormPoint],
) -> Result<Method, ProbabilityError> {
    let numbers = problem.laws().laws().len();
    let beta = points.first().map(|point| point.beta);
    let suited = || Method::suited(numbers, problem.most_integrated(), beta);
    let method = request.method.unwrap_or_else(suited);
    match method.most_numbers() {
        Some(most) if numbers > most => Err(ProbabilityError::TooMany { method, most, numbers }),
        _ => Ok(method),
    }
}

/// The points about which an event is drawn: the nearest at which the body does not rest, and of every mode that may be likelier than
/// the floor, so that none of them is missed and none takes points from the others that need not be precise; each once.
pub(super) fn about(problem: &ChanceProblem, points: &[FormPoint], floor: f64) -> Vec<Vec<f64>> {
    let of_modes = of_each(problem).into_iter().map(|(_, point)| point);
    let likely = of_modes.filter(|point| point.first_order() >= UNLIKELIER * floor);
    apart(points.iter().cloned().chain(likely))
}

/// The nearest point of every happening but rest, in which a body is when nothing happens.
fn of_each(problem: &ChanceProblem) -> Vec<(Happening, FormPoint)> {
    let found = |outcome: usize| {
        let point = design_point(problem.laws(), problem, 1 << outcome)?;
        Some((Happening::of(outcome), point))
    };
    problem.moving().filter_map(found).collect()
}

/// The method, and the probabilities of all sets.
fn sampled(
    problem: &ChanceProblem,
    points: &[FormPoint],
    request: &ChanceRequest,
    portion: Portion<'_>,
) -> Result<Found, ProbabilityError> {
    portion.check()?;
    let laws = problem.laws();
    let method = method(problem, request, points)?;
    let about =
        if method == Method::Importance { about(problem, points, request.effort.floor) } else { Vec::new() };
    let work = request.effort.within(portion);
    let mut found = by(method, laws, problem, &sets(problem), &about, (work, problem.cost()));
    portion.check()?;
    let sampled = &mut found.sampled;
    if method == Method::Importance {
        // Points that are weighed do not add up to one where nothing is looked for: rest is what is left.
        let of_moved = sampled.estimates[problem.exclusive().count()];
        if let Some(place) = problem.exclusive().position(|outcome| outcome == REST) {
            let Estimate { value, low, high } = of_moved;
            sampled.estimates[place] = Estimate { value: 1.0 - value, low: 1.0 - high, high: 1.0 - low };
        }
    }
    let (modes, others) = sampled.estimates.split_at_mut(problem.exclusive().count());
    for (outcome, of_mode) in problem.exclusive().zip(modes) {
        // No mode but rest is likelier than that it does not rest: the bound of one that was never met.
        if outcome != REST {
            of_mode.high = of_mode.high.min(others[0].high);
        }
    }
    Ok(found)
}

/// The probabilities of one set of loads.
pub(super) fn chances(
    problem: &ChanceProblem,
    request: &ChanceRequest,
    portion: Portion<'_>,
) -> Result<Chances, ProbabilityError> {
    let (problem, points) = placed(problem);
    let problem = &*problem;
    let laws = problem.laws();
    let numbers = laws.laws().len();
    let effort = &request.effort;
    let of_life = if problem.life().is_some() { 2.0 } else { 0.0 };
    let of_slopes = if problem.sensitivities { 4.0 * numbers as f64 } else { 0.0 };
    let [of_modes, each_known, of_departure, of_life, each_slope] =
        portion.parts([2.0, numbers as f64, 2.0, of_life, of_slopes]);
    let Found { method, sampled, given_up } = sampled(problem, &points, request, of_modes)?;
    // Rare events are looked for about the points found, whatever else is known.
    let about: Vec<Vec<f64>> = match method {
        Method::Importance => points.iter().map(|point| point.u.clone()).collect(),
        _ => Vec::new(),
    };
    let known = (0..numbers).map(|number| {
        let portion = each_known.part(number, numbers);
        portion.check()?;
        // What would be gained is worth no more points than what is.
        let (drawn, work) = ((&about[..], sampled.points), (effort.within(portion), problem.cost()));
        let found = by_known(laws, problem, not_rest(), number, drawn, work);
        portion.reached(1.0);
        Ok(found)
    });
    let known: Vec<Estimate> =
        if numbers > 1 { known.collect::<Result<_, ProbabilityError>>()? } else { Vec::new() };
    let slopes_of = |number: usize| {
        let portion = each_slope.part(number, numbers);
        portion.check()?;
        let (of, work) = ((laws, problem, not_rest()), (effort.within(portion), problem.cost()));
        Ok::<_, ProbabilityError>(slopes(of, number, (method, &about, sampled.points), work))
    };
    let slopes = problem.sensitivities.then(|| (0..numbers).map(slopes_of).collect::<Result<Vec<_>, _>>());
    let [modes @ .., not_rest, not_unique, lifted] = &sampled.estimates[..] else {
        unreachable!("as many as sets")
    };
    let (line, exact) = problem.line_name();
    Ok(Chances {
        situation: problem.situation(),
        line: (line.to_owned(), exact),
        method,
        given_up,
        points: sampled.points,
        precise: sampled.precise,
        modes: problem.exclusive().map(Happening::of).zip(modes.iter().copied()).collect(),
        not_rest: *not_rest,
        not_unique: (!problem.is_without_modes()).then_some(*not_unique),
        lifted: *lifted,
        known,
        first_departure: first_departure(problem, method, effort, sampled.points, of_departure)?,
        design_values: problem
            .target_beta
            .and_then(|beta| Some(DesignValues::of(laws, points.first()?, beta))),
        slopes: slopes.transpose()?,
        design_point: points.into_iter().next(),
        design_points: request.form.then(|| of_each(problem)),
        life: life(problem, effort, of_life)?,
        course: sampled.course.iter().map(|(points, e)| (*points, e[problem.exclusive().count()])).collect(),
    })
}

/// Number of points that may be taken for departures at least, however few the modes need.
const OF_DEPARTURES: u64 = 1 << 17;
/// Number of plain draws that tell the shares of departures to a hundredth.
const OF_SHARES: u64 = 1 << 14;

fn first_departure(
    problem: &ChanceProblem,
    method: Method,
    effort: &Effort,
    points: u64,
    portion: Portion<'_>,
) -> Result<FirstDeparture, ProbabilityError> {
    portion.check()?;
    let (laws, departures) = (problem.laws(), Departures(problem));
    let codes: Vec<usize> = departures.exclusive().collect();
    let sets: Vec<u64> = codes.iter().map(|outcome| 1 << outcome).collect();
    // A mode that is next to never the first is not worth more points than all that is asked of the full load; and where everything is
    // drawn, no more than tell a share.
    let most = if method == Method::MonteCarlo { OF_SHARES } else { points.max(OF_DEPARTURES) };
    let effort = Effort { points: most.min(effort.points), ..*effort };
    let method = match method {
        // The end of rest on a base that gives way has many kinks, and the departures of more numbers would take minutes.
        Method::Integrate if problem.gives_way() && laws.laws().len() > MOST_DIMENSIONS => Method::Sobol,
        // Which mode is first is seldom a rare event, and lies about no one point.
        Method::Importance => Method::Sobol,
        method => method,
    };
    let work = (effort.within(portion), problem.cost());
    let found = by(method, laws, &departures, &sets, &[], work).sampled;
    portion.check()?;
    portion.reached(1.0);
    let precise = found.precise;
    let of = |outcome: usize| {
        let place = codes.iter().position(|code| *code == outcome);
        found.estimates[place.expect("one of the outcomes")]
    };
    let modes = codes.iter().filter(|code| ![NEVER, AT_ONCE].contains(code));
    let modes = modes.map(|code| (Happening::of(*code), of(*code))).collect();
    Ok(FirstDeparture { modes, never: of(NEVER), at_once: of(AT_ONCE), precise })
}

/// That the body ever leaves rest over a life, after those through which it stayed at rest if there are any, under any of these problems, which have the same random numbers.
pub(super) fn life_of(
    problems: &[&ChanceProblem],
    effort: &Effort,
    portion: Portion<'_>,
) -> Result<Estimate, ProbabilityError> {
    let [first, others @ ..] = problems else { return Err(ProbabilityError::NoLife) };
    let years = first.life().ok_or(ProbabilityError::NoLife)?;
    if others.is_empty() {
        return Ok(life(first, effort, portion)?.ok_or(ProbabilityError::NoLife)?.ahead());
    }
    let yearly: Option<Vec<ChanceProblem>> = problems.iter().map(|problem| problem.along_yearly()).collect();
    let yearly = yearly.ok_or(ProbabilityError::NothingYearly { years: years.years })?;
    let any = AnyOf(yearly.iter().collect());
    let sets = [1 << MOVES];
    let over = |life: &Life, portion: Portion<'_>| {
        let found = over_years(&yearly[0], &any, &any, &sets, life, (effort, portion))?.sampled;
        portion.check()?;
        Ok(found.estimates[0])
    };
    match first.lifetime().survived {
        None => over(&years, portion),
        Some(survived) => after(survived, &years, portion, over),
    }
}

/// That rest ends in a life that follows years of rest, P(T + t) − P(T) over 1 − P(T); the interval is as wide as both together allow.
pub(super) fn after(
    survived: f64,
    life: &Life,
    portion: Portion<'_>,
    over: impl Fn(&Life, Portion<'_>) -> Result<Estimate, ProbabilityError>,
) -> Result<Estimate, ProbabilityError> {
    let [first, second] = portion.parts([1.0, 1.0]);
    let before = over(&Life { years: survived, ..life.clone() }, first)?;
    let whole = over(&Life { years: survived + life.years, ..life.clone() }, second)?;
    let given = |whole: f64, before: f64| ((whole - before) / (1.0 - before)).clamp(0.0, 1.0);
    Ok(Estimate {
        value: given(whole.value, before.value),
        low: given(whole.low, before.high),
        high: given(whole.high, before.low),
    })
}

/// Outcomes over years: integrated along a yearly number where they are few, or drawn.
pub(super) fn over_years<O: Outcomes, D: Outcomes>(
    yearly: &ChanceProblem,
    along: &O,
    drawn: &D,
    sets: &[u64],
    life: &Life,
    (effort, portion): (&Effort, Portion<'_>),
) -> Result<Found, ProbabilityError> {
    let laws = yearly.laws();
    let is_whole = life.years.fract() == 0.0 || life.events.is_some();
    // A scan for each pair of the others would take minutes.
    if laws.laws().len() <= MOST_DIMENSIONS + usize::from(!yearly.is_scanned()) {
        if !is_whole {
            // Of part of a year there are no draws that could take the place of the integral.
            let integrated = integrate_life(laws, along, sets, life, Within::ALL_DIGITS);
            let of_part = |_| ProbabilityError::PartOfYear { years: life.years };
            let sampled = integrated.map(|found| estimates(&found)).map_err(of_part)?;
            return Ok(Found { method: Method::Integrate, sampled, given_up: false });
        }
        let within = within(effort, yearly.cost(), portion);
        let integrated = integrate_life(laws, along, sets, life, within);
        return Ok(integral_or(integrated, effort, || {
            lives(laws, drawn, sets, life, effort.within(portion))
        }));
    }
    if !is_whole {
        return Err(ProbabilityError::PartOfYear { years: life.years });
    }
    let sampled = lives(laws, drawn, sets, life, effort.within(portion));
    Ok(Found { method: Method::Sobol, sampled, given_up: false })
}

fn life(
    problem: &ChanceProblem,
    effort: &Effort,
    portion: Portion<'_>,
) -> Result<Option<LifeChances>, ProbabilityError> {
    let Some(life) = problem.life() else {
        return match problem.lifetime().survived {
            Some(_) => Err(ProbabilityError::NoLife),
            None => Ok(None),
        };
    };
    let sets: Vec<u64> = problem.exclusive().map(|outcome| 1 << outcome).chain([not_rest()]).collect();
    let survived = problem.lifetime().survived;
    let of_stood = if survived.is_some() { 2.0 } else { 0.0 };
    let [portion, of_stood] = portion.parts([1.0, of_stood]);
    let yearly = problem.along_yearly().ok_or(ProbabilityError::NothingYearly { years: life.years })?;
    let Found { method, sampled: found, .. } =
        over_years(&yearly, &yearly, problem, &sets, &life, (effort, portion))?;
    portion.check()?;
    portion.reached(1.0);
    let [modes @ .., not_rest] = &found.estimates[..] else { unreachable!("as many as sets") };
    let modes = problem.exclusive().map(Happening::of).zip(modes.iter().copied()).collect();
    let stood = survived.map(|years| {
        let sets = [self::not_rest()];
        let over = |life: &Life, portion: Portion<'_>| {
            let found = over_years(&yearly, &yearly, problem, &sets, life, (effort, portion))?.sampled;
            portion.check()?;
            Ok(found.estimates[0])
        };
        Ok::<_, ProbabilityError>(Stood { years, not_rest: after(years, &life, of_stood, over)? })
    });
    let (years, events, precise) = (life.years, life.events, found.precise);
    let stood = stood.transpose()?;
    Ok(Some(LifeChances { years, events, not_rest: *not_rest, stood, modes, method, precise }))
}
