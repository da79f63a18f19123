//! A motion on a screen: poses at even steps, histories of a size, what is said at a moment.

use standfast::{History, Mode};
use standfast_figures::{
    Figure, MotionOutline, MotionPicture, MotionPose, MotionStage, Picture, PinnedMotion, StageLines,
    motion_histories_beside, motion_histories_on_screen_beside, motion_stage, strength_strip,
};
use standfast_motion::ground::displacements;

use super::FollowedMotion;
use super::figures::{Samples, balance, pose};
use crate::layout::significant;

/// So many poses a second, and at least and at most so many in all.
const PER_SECOND: f64 = 60.0;
const LEAST: f64 = 240.0;
const MOST: f64 = 6000.0;

/// The motion of a body on a screen.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionOnScreen {
    /// The body where it began, and the groups that move.
    pub stage: MotionStage,
    /// The last moment; the first is 0.
    pub end: f64,
    /// The time between two poses.
    pub step: f64,
    /// For each pose five numbers: x and y in the drawing, degrees clockwise, the shift of the ground in the drawing, the mode's number.
    pub poses: Vec<f32>,
    /// Moments at which the state changes.
    pub events: Vec<f64>,
    /// Stretches of time in which the body rests.
    pub rests: Vec<[f64; 2]>,
}

/// A moment of a motion.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Moment {
    /// The time with its unit.
    pub clock: String,
    /// What the body does, how far it has turned and slid, and how the ground is accelerated, in words.
    pub words: Vec<String>,
    /// Lines of the drawing.
    pub lines: StageLines,
}

/// A motion on a screen of about such a size, seen from the floor or from the earth; `None` if the motion was not kept.
pub fn motion_on_screen(
    followed: &FollowedMotion,
    from_earth: bool,
    size: (f64, f64),
) -> Option<MotionOnScreen> {
    let (case, outcome) = (&followed.case, &followed.outcome);
    outcome.steps.first()?;
    let samples = Samples::of(followed);
    let end = samples.end;
    let count = (end * PER_SECOND).ceil().clamp(LEAST, MOST);
    let moments: Vec<f64> = (0..=count as usize).map(|i| end * i as f64 / count).collect();
    let all: Vec<MotionPose> = moments.iter().filter_map(|t| pose(outcome, *t)).collect();
    let shakes = case.problem.base.horizontal.as_ref().filter(|_| from_earth);
    let shifts = shakes.map_or_else(Vec::new, |history| displacements(history, &moments));
    let block = &case.problem.block;
    let outline = MotionOutline { b1: block.b1, b2: block.b2, d: block.d, height: case.height };
    let stage = motion_stage(&samples.title, &outline, balance(followed), &all, &shifts, size);
    let mut poses = Vec::with_capacity(5 * all.len());
    for (i, pose) in all.iter().enumerate() {
        let shift = stage.length(shifts.get(i).copied().unwrap_or(0.0));
        let [x, y, turn] = stage.pose(pose);
        poses.extend([x, y, turn, shift, f64::from(pose.mode as u8)].map(|number| number as f32));
    }
    let changes = || samples.states.iter().filter(|(t, _)| *t <= end);
    let until = changes().skip(1).map(|(t, _)| *t).chain([end]);
    let rests = changes().zip(until).filter(|((_, mode), _)| *mode == Mode::Rest);
    let rests = rests.map(|((from, _), to)| [*from, to]).collect();
    let events = changes().map(|(t, _)| *t).filter(|t| *t > 0.0).collect();
    Some(MotionOnScreen { stage, end, step: end / count, poses, events, rests })
}

/// Histories of a motion on a screen; `None` if the motion was not kept.
pub fn histories_on_screen(followed: &FollowedMotion, size: (f64, f64)) -> Option<Picture> {
    histories_on_screen_beside(followed, None, size)
}

/// The same with those of another motion in dashes behind.
pub fn histories_on_screen_beside(
    followed: &FollowedMotion,
    pinned: Option<&PinnedMotion>,
    size: (f64, f64),
) -> Option<Picture> {
    followed.outcome.steps.first()?;
    let draw = |picture: &MotionPicture<'_>| motion_histories_on_screen_beside(picture, pinned, size);
    Some(Samples::of(followed).with_picture(followed, draw))
}

/// The histories of a motion, to be drawn in dashes behind those of another; `None` if the motion was not kept.
pub fn pinned_motion(followed: &FollowedMotion) -> Option<PinnedMotion> {
    followed.outcome.steps.first()?;
    Some(Samples::of(followed).with_picture(followed, PinnedMotion::of))
}

/// Histories of a motion on paper, with those of another in dashes behind; `None` if the motion was not kept.
pub fn histories_on_paper(followed: &FollowedMotion, pinned: &PinnedMotion) -> Option<Figure> {
    followed.outcome.steps.first()?;
    let draw = |picture: &MotionPicture<'_>| motion_histories_beside(picture, Some(pinned));
    Some(Samples::of(followed).with_picture(followed, draw))
}

/// What is said at a moment of a motion, and the lines of its drawing.
pub fn moment(followed: &FollowedMotion, stage: &MotionStage, t: f64) -> Option<Moment> {
    let (case, outcome) = (&followed.case, &followed.outcome);
    let pose = pose(outcome, t)?;
    let block = &case.problem.block;
    let (metres, seconds) = if case.si { (" m", " s") } else { ("", "") };
    let mut words = vec![pose.mode.words().replace('\'', "′")];
    let limit = balance(followed)[usize::from(pose.theta < 0.0)].to_degrees().abs();
    let degrees = pose.theta.to_degrees().abs();
    if degrees >= 0.005 {
        words.push(format!("turned {}° of {}°", rounded(degrees), significant(limit, 3)));
    }
    if pose.slide.abs() > 1e-6 * (block.b1 + block.b2) {
        let way = if pose.slide < 0.0 { "left" } else { "right" };
        words.push(match case.si && pose.slide.abs() < 1.0 {
            true => format!("slid {} mm to the {way}", rounded(1e3 * pose.slide.abs())),
            false => format!("slid {}{metres} to the {way}", significant(pose.slide.abs(), 3)),
        });
    }
    let mut push = 0.0;
    if let Some(history) = &case.problem.base.horizontal {
        let (now, most) = (history.at(t), history.peak());
        push = if most > 0.0 { now / most } else { 0.0 };
        let gravities = now / case.problem.gravity;
        if gravities.abs() >= 0.005 {
            let way = if now < 0.0 { "left" } else { "right" };
            words.push(format!("the floor accelerates at {:.2} g to the {way}", gravities.abs()));
        }
    }
    let end = Samples::end_of(outcome);
    let decimals = if end < 20.0 { 2 } else { 1 };
    let decimals = if end < 0.5 { 4 } else { decimals };
    Some(Moment { clock: format!("{t:.decimals$}{seconds}"), words, lines: stage.lines(&pose, push) })
}

/// A number that changes as one looks: so many decimals that it does not jump.
fn rounded(value: f64) -> String {
    if value >= 10.0 {
        format!("{value:.0}")
    } else if value >= 1.0 {
        format!("{value:.1}")
    } else {
        format!("{value:.2}")
    }
}

/// True if the base moves sideways, so that the motion is another from the earth.
pub fn is_shaken(followed: &FollowedMotion) -> bool {
    followed.case.problem.base.horizontal.as_ref().is_some_and(|history: &History| history.peak() > 0.0)
}

/// The strip of strengths of a motion, so wide; `None` where its strength is not known.
pub fn strengths_on_screen(followed: &FollowedMotion, width: f64) -> Option<Figure> {
    let strength = followed.strength.as_ref()?;
    let mut tried: Vec<_> = strength.tried.iter().map(|tried| (tried.factor, tried.overturned)).collect();
    tried.push((1.0, followed.outcome.overturned()));
    standfast::order::by_number(&mut tried, |one| one.0);
    Some(strength_strip(&tried, width))
}
