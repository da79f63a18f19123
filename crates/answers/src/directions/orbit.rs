//! The way of a record through the directions.

use standfast::footprint::{BaseWrench, Footprint, PlanDeparture};
use standfast::history::{History, Piece};

use super::DirectionsError;
use crate::case::{Case, Trial};
use standfast_model::CaseFile;

/// Turn of a sine between two points of its orbit, rad: the chord is 1e-5 of the amplitude beside the arc.
const ARC: f64 = 0.01;

/// The way of a shaken body through the directions.
#[derive(Debug, Clone, PartialEq)]
pub struct Orbit {
    /// Time, s, and the horizontal force over what presses the body on its base: to the right, and away.
    pub points: Vec<[f64; 3]>,
    /// Where it first leaves rest; `None` if it never does.
    pub exit: Option<OrbitExit>,
    /// The part of the record at which rest ends: above 1 where the body rests throughout.
    pub scale: f64,
    /// Where the record of that strength leaves rest; `None` where none does.
    pub strongest: Option<OrbitExit>,
}

/// An end of rest along an orbit.
#[derive(Debug, Clone, PartialEq)]
pub struct OrbitExit {
    /// When, s.
    pub time: f64,
    /// What ends it, under which force.
    pub departure: PlanDeparture,
}

impl Orbit {
    /// The orbits of the situations of a case whose base follows records; none of another.
    pub(super) fn of_file(file: &CaseFile) -> Result<Vec<Orbit>, DirectionsError> {
        if !file.is_in_time() {
            return Ok(Vec::new());
        }
        let case = file.case()?;
        case.acting()
            .into_iter()
            .map(|acting| {
                let of = case.under(acting);
                let situation =
                    case.situation(acting, Trial::AS_GIVEN).map_err(|error| file.refused(error))?;
                let [permanent, variable] = situation.base_wrenches().ok_or(DirectionsError::InPlane)?;
                let footprint = &of.plan.as_ref().ok_or(DirectionsError::InPlane)?.base.footprint;
                let shaken = Shaken::of(of, permanent.plus(variable));
                shaken.orbit(footprint, situation.static_friction())
            })
            .collect()
    }
}

/// A body on a base that is shaken.
struct Shaken {
    /// Of everything else.
    steady: BaseWrench,
    mass: f64,
    height: f64,
    /// Accelerations of the base: to the right, upwards, away.
    base: [Option<History>; 3],
}

impl Shaken {
    fn of(case: &Case, steady: BaseWrench) -> Shaken {
        let motion = case.motion.as_ref();
        let base = motion.map(|motion| [&motion.base.horizontal, &motion.base.vertical, &motion.away]);
        let base = base.map_or([None, None, None], |base| base.map(Clone::clone));
        Shaken { steady, mass: case.body.mass(), height: case.body.centroid_height(), base }
    }

    /// The inertia of accelerations of the base.
    fn inertia(&self, [right, up, away]: [f64; 3]) -> BaseWrench {
        let horizontal = [-self.mass * right, -self.mass * away];
        BaseWrench::force_at(horizontal, self.mass * up, [0.0, self.height, 0.0])
    }

    /// Times at which a piece begins or ends, and points on sines; each with the inertia just before and at it.
    fn states(&self) -> Vec<(f64, BaseWrench)> {
        let histories = || self.base.iter().flatten();
        let mut times: Vec<f64> = Vec::new();
        for history in histories() {
            let ends = history.times();
            times.extend(ends.iter().filter(|time| time.is_finite()));
            for (piece, pair) in history.pieces().iter().zip(ends.windows(2)) {
                let Piece::Sine { angular_frequency, .. } = piece else { continue };
                let [start, end] = [pair[0], pair[1]];
                let count = ((end - start) * angular_frequency.abs() / ARC).ceil().clamp(1.0, 1e6);
                let between = (1..).map(f64::from).take_while(|place| *place < count);
                times.extend(between.map(|place| start + (end - start) * place / count));
            }
        }
        times.sort_by(f64::total_cmp);
        times.dedup();
        let mut states = Vec::with_capacity(times.len());
        for time in times {
            let at = |value: fn(&History, f64) -> f64| {
                let value =
                    |history: &Option<History>| history.as_ref().map_or(0.0, |history| value(history, time));
                self.inertia([value(&self.base[0]), value(&self.base[1]), value(&self.base[2])])
            };
            if histories().any(|history| history.jumps_at(time)) {
                states.push((time, at(History::before)));
            }
            states.push((time, at(History::at)));
        }
        states
    }

    fn orbit(&self, footprint: &Footprint, friction: f64) -> Result<Orbit, DirectionsError> {
        let states = self.states();
        let departure = |from: &BaseWrench, by: &BaseWrench| {
            let degrees = by.direction_deg().unwrap_or(0.0);
            footprint.departure(friction, from, by).map_err(|_| DirectionsError::Torsion { degrees })
        };
        let points = states.iter().map(|(time, inertia)| {
            let BaseWrench { x, z, p, .. } = self.steady.plus(*inertia);
            [*time, x / p, z / p]
        });
        let mut orbit = Orbit { points: points.collect(), exit: None, scale: f64::INFINITY, strongest: None };
        let mut before: Option<(f64, BaseWrench)> = None;
        for (time, inertia) in states {
            let found = departure(&self.steady, &inertia)?;
            if orbit.exit.is_none() && !found.rests {
                // From the state before, of which the way to this is a straight line.
                let (start, from) = before.unwrap_or((time, BaseWrench::zero()));
                let by = inertia.plus(from.times(-1.0));
                let on_way = departure(&self.steady.plus(from), &by)?;
                let time = start + (time - start) * on_way.load_factor.min(1.0);
                orbit.exit = Some(OrbitExit { time, departure: on_way });
            }
            if found.load_factor < orbit.scale {
                orbit.scale = found.load_factor;
                orbit.strongest = Some(OrbitExit { time, departure: found });
            }
            before = Some((time, inertia));
        }
        Ok(orbit)
    }
}
