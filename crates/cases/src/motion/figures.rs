//! The figures of a motion.

use standfast::{History, Mode};
use standfast_figures::{
    MotionLoad, MotionOutline, MotionPicture, MotionPose, motion_animation, motion_histories,
    motion_positions,
};
use standfast_motion::{MotionOutcome, Position, Why};

use super::FollowedMotion;
use super::text::caption;
use crate::document::AnswerFigure;
use crate::layout::significant;

/// As many samples of slide and rotation as the page has places for, and some more.
const SAMPLES: usize = 2400;
/// At most so many positions side by side.
const POSITIONS: usize = 8;
/// At most so many pictures a second, and so many in all.
const PER_SECOND: f64 = 40.0;
const PICTURES: f64 = 800.0;
/// What a picture that moves shows of the rest before and after, as a share of the motion; it shows all if it would leave out little.
const ROOM: f64 = 0.08;
const LITTLE: f64 = 0.15;

/// Histories, positions and the motion as a picture that moves, if the whole motion was kept .
pub(super) fn all(followed: &FollowedMotion) -> Vec<AnswerFigure> {
    let (case, outcome) = (&followed.case, &followed.outcome);
    if outcome.steps.is_empty() {
        return Vec::new();
    }
    let samples = Samples::of(followed);
    samples.with_picture(followed, |picture| figures(&samples, outcome, case.si, picture))
}

fn figures(
    samples: &Samples,
    outcome: &MotionOutcome,
    si: bool,
    picture: &MotionPicture<'_>,
) -> Vec<AnswerFigure> {
    let (begin, end) = samples.moves();
    let from = significant(begin, 3);
    let to = format!("{}{}", significant(end, 3), if si { " s" } else { "" });
    let told = match (begin > samples.begin, end < samples.end) {
        (false, false) => samples.caption.clone(),
        (true, false) => format!("{} Shown from t = {from} on: before, the body rests.", samples.caption),
        (false, true) => format!("{} Shown up to t = {to}: after that the body rests.", samples.caption),
        (true, true) => {
            format!("{} Shown from t = {from} to {to}: before and after, the body rests.", samples.caption)
        }
    };
    let within = |points: &[(f64, f64)]| -> Vec<(f64, f64)> {
        points.iter().copied().filter(|(t, _)| (begin..=end).contains(t)).collect()
    };
    let ground = within(&samples.ground);
    let moving = MotionPicture { caption: &told, begin, end, ground: &ground, ..picture.clone() };
    let frames = samples.frames(outcome, (begin, end));
    vec![
        AnswerFigure::new("-motion", "Histories", motion_histories(picture)),
        AnswerFigure::new("-positions", "Positions", motion_positions(picture, &samples.moments(outcome))),
        AnswerFigure::new("-animation", "Animation", motion_animation(&moving, &frames)),
    ]
}

/// The numbers of the figures.
pub(super) struct Samples {
    pub title: String,
    caption: String,
    /// When the motion begins.
    begin: f64,
    pub end: f64,
    pub states: Vec<(f64, Mode)>,
    loads: Vec<(&'static str, Vec<(f64, f64)>)>,
    slide: Vec<(f64, f64)>,
    theta: Vec<(f64, f64)>,
    ground: Vec<(f64, f64)>,
}

impl Samples {
    pub(super) fn of(followed: &FollowedMotion) -> Samples {
        let (case, outcome) = (&followed.case, &followed.outcome);
        let (begin, end) = (case.problem.initial.time, Samples::end_of(outcome));
        let mut states: Vec<(f64, Mode)> = Vec::new();
        for event in &outcome.events {
            if states.last().is_none_or(|(_, mode)| *mode != event.state) {
                states.push((event.t, event.state));
            }
        }
        let gravity = case.problem.gravity;
        let mut acting = case.problem.acting(end, SAMPLES);
        acting.retain(|acting| acting.t >= begin);
        let mut loads = vec![(
            "load to the right over the weight",
            acting.iter().map(|a| (a.t, a.x / gravity)).collect::<Vec<_>>(),
        )];
        if acting.iter().any(|a| a.up != 0.0) {
            loads.push(("load upwards", acting.iter().map(|a| (a.t, a.up / gravity)).collect()));
        }
        let mut moments: Vec<f64> =
            (0..=SAMPLES).map(|i| begin + (end - begin) * i as f64 / SAMPLES as f64).collect();
        moments.extend(outcome.events.iter().map(|event| event.t).filter(|t| *t <= end));
        moments.extend([outcome.t_max_theta, outcome.t_max_slide]);
        moments.sort_by(f64::total_cmp);
        moments.dedup();
        let positions: Vec<Position> = moments.into_iter().filter_map(|t| outcome.at(t)).collect();
        let title = [&case.title, &case.situation].into_iter().flatten().cloned().collect::<Vec<_>>();
        let title = if title.is_empty() { "A block in motion".to_owned() } else { title.join(", ") };
        Samples {
            title,
            caption: caption(followed),
            begin,
            end,
            states,
            loads,
            slide: positions.iter().map(|at| (at.t, at.slide)).collect(),
            theta: positions.iter().map(|at| (at.t, at.theta)).collect(),
            ground: case
                .problem
                .base
                .horizontal
                .iter()
                .flat_map(|history| ground(history, (begin, end), gravity))
                .collect(),
        }
    }

    /// The last moment that is shown.
    pub(super) fn end_of(outcome: &MotionOutcome) -> f64 {
        let [first, last] =
            [outcome.events.first(), outcome.events.last()].map(|event| event.map_or(0.0, |event| event.t));
        let end = if outcome.overturned() { last } else { outcome.t_final };
        if end > first && end.is_finite() { end } else { first + 1.0 }
    }

    /// Does something with the picture of the whole motion.
    pub(super) fn with_picture<T>(
        &self,
        followed: &FollowedMotion,
        draw: impl FnOnce(&MotionPicture<'_>) -> T,
    ) -> T {
        let case = &followed.case;
        let loads: Vec<_> = self.loads.iter().map(|(name, points)| MotionLoad { name, points }).collect();
        let block = &case.problem.block;
        let [time_unit, length_unit] = if case.si { ["s", "m"] } else { ["", ""] };
        draw(&MotionPicture {
            title: &self.title,
            caption: &self.caption,
            outline: MotionOutline { b1: block.b1, b2: block.b2, d: block.d, height: case.height },
            begin: self.begin,
            end: self.end,
            time_unit,
            length_unit,
            states: &self.states,
            loads: &loads,
            slide: &self.slide,
            theta: &self.theta,
            ground: &self.ground,
            balance: balance(followed),
        })
    }

    /// Positions of the body as it leaves rest, at its largest slide and rotation, at the end, and between them.
    fn moments(&self, outcome: &MotionOutcome) -> Vec<MotionPose> {
        let leaves = self.states.iter().find(|(_, mode)| *mode != Mode::Rest).map_or(self.begin, |(t, _)| *t);
        let rests = self.states.last().map_or(self.end, |(t, _)| *t);
        let rests = if outcome.at_rest() { rests } else { self.end };
        let apart = 0.03 * (rests - leaves);
        let mut chosen = vec![leaves, rests];
        let mut choose = |t: f64, apart: f64| {
            if chosen.len() < POSITIONS && chosen.iter().all(|other| (t - other).abs() >= apart) {
                chosen.push(t);
            }
        };
        if apart > 0.0 {
            choose(outcome.t_max_theta, apart);
            choose(outcome.t_max_slide, apart);
            let between = (1..POSITIONS).map(|i| i as f64 / POSITIONS as f64);
            between.for_each(|share| choose(leaves + share * (rests - leaves), 3.0 * apart));
        }
        chosen.sort_by(f64::total_cmp);
        chosen.dedup();
        chosen.into_iter().filter_map(|t| pose(outcome, t)).collect()
    }

    /// From shortly before the body leaves rest to shortly after it comes to rest; the whole time if little is left out.
    fn moves(&self) -> (f64, f64) {
        let whole = (self.begin, self.end);
        let is_rest = |state: &&(f64, Mode)| state.1 == Mode::Rest;
        let Some((leaves, _)) = self.states.iter().find(|state| !is_rest(state)) else { return whole };
        let rests = self.states.last().filter(is_rest).map_or(self.end, |(t, _)| t.min(self.end));
        let room = (ROOM * (rests - leaves)).min(1.0);
        let (from, to) = ((leaves - room).max(self.begin), (rests + room).min(self.end));
        if to - from < (1.0 - LITTLE) * (self.end - self.begin) { (from, to) } else { whole }
    }

    /// Positions of the body within a time, so many that an eye sees it move; of a rest only the first and the last.
    fn frames(&self, outcome: &MotionOutcome, (begin, end): (f64, f64)) -> Vec<MotionPose> {
        let step = (1.0 / PER_SECOND).max((end - begin) / PICTURES);
        let count = ((end - begin) / step).ceil();
        let mut moments: Vec<f64> =
            (0..=count as usize).map(|i| begin + (end - begin) * i as f64 / count).collect();
        // Where a corner meets the base the way is no straight one.
        let mut last = f64::NEG_INFINITY;
        for event in
            outcome.events.iter().filter(|event| event.why == Why::Impact && (begin..=end).contains(&event.t))
        {
            if event.t - last > 0.4 * step {
                moments.push(event.t);
                last = event.t;
            }
        }
        moments.sort_by(f64::total_cmp);
        let poses: Vec<MotionPose> = moments.into_iter().filter_map(|t| pose(outcome, t)).collect();
        let place = |pose: &MotionPose| (pose.x, pose.y, pose.theta);
        let still = |i: usize| {
            i > 0
                && i + 1 < poses.len()
                && place(&poses[i - 1]) == place(&poses[i])
                && place(&poses[i]) == place(&poses[i + 1])
        };
        (0..poses.len()).filter(|i| !still(*i)).map(|i| poses[i]).collect()
    }
}

/// Acceleration of the base in gravities, so often that an eye sees it change.
fn ground(history: &History, (begin, end): (f64, f64), gravity: f64) -> Vec<(f64, f64)> {
    let count = ((end - begin) * PER_SECOND / 2.0).ceil().clamp(1.0, PICTURES) as usize;
    let moments = (0..=count).map(|i| begin + (end - begin) * i as f64 / count as f64);
    moments.map(|t| (t, history.at(t) / gravity)).collect()
}

/// θ of balance about O, and about O' (below zero).
pub(super) fn balance(followed: &FollowedMotion) -> [f64; 2] {
    let block = &followed.case.problem.block;
    [(block.b1 / block.d).atan(), -(block.b2 / block.d).atan()]
}

pub(super) fn pose(outcome: &MotionOutcome, t: f64) -> Option<MotionPose> {
    let Position { x, y, theta, slide, state, .. } = outcome.at(t)?;
    Some(MotionPose { t, x, y, theta, slide, mode: state })
}
