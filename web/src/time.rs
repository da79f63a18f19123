//! The motion of a case in time: the stage on which the body moves, its poses, and what is said at a moment.

use serde::Serialize;
use standfast_cases::motion::screen::{
    MotionOnScreen, histories_on_screen_beside, is_shaken, moment, motion_on_screen, strengths_on_screen,
};
use standfast_cases::motion::{Factors, Strength, Tried};
use standfast_figures::Picture;

use crate::page::Page;
use crate::pinned::Pinned;

/// What moves, as the page takes it; the poses are apart.
#[derive(Serialize)]
struct StageShown<'a> {
    svg: &'a str,
    size: (f64, f64),
    /// So many times as large moves are drawn, in words; empty at true scale.
    times: String,
    end: f64,
    step: f64,
    events: &'a [f64],
    rests: &'a [[f64; 2]],
    /// True if it can be seen from the earth too.
    shaken: bool,
}

/// A moment, as the page takes it.
#[derive(Serialize)]
struct MomentShown {
    clock: String,
    words: Vec<String>,
    arc: String,
    balance: String,
    slid: String,
    push: String,
}

impl Page {
    /// The stage of the motion, of about a size, as JSON; empty of a case at rest.
    pub fn stage(&mut self, from_earth: bool, size: (f64, f64)) -> String {
        let worst = self.answered().motions.first();
        let shaken = worst.is_some_and(is_shaken);
        let motion = worst.and_then(|worst| motion_on_screen(worst, from_earth && shaken, size));
        let json = motion.as_ref().map(|MotionOnScreen { stage, end, step, events, rests, .. }| {
            let times = stage.times;
            serde_json::to_string(&StageShown {
                svg: stage.figure.svg(),
                size: stage.figure.size(),
                times: if times == 1.0 { String::new() } else { format!("moves drawn {times} × as large") },
                end: *end,
                step: *step,
                events,
                rests,
                shaken,
            })
        });
        self.drawn.motion = motion;
        json.and_then(Result::ok).unwrap_or_default()
    }

    /// The poses of the stage last drawn, five numbers each.
    pub fn poses(&self) -> Vec<f32> {
        self.drawn.motion.as_ref().map_or_else(Vec::new, |motion| motion.poses.clone())
    }

    /// What is said at a moment of the stage last drawn, and its lines, as JSON.
    pub fn moment(&self, t: f64) -> String {
        let worst = self.answered().motions.first().zip(self.drawn.motion.as_ref());
        let moment = worst.and_then(|(worst, motion)| moment(worst, &motion.stage, t));
        let shown = moment.map(|moment| MomentShown {
            clock: moment.clock,
            words: moment.words,
            arc: moment.lines.arc,
            balance: moment.lines.balance,
            slid: moment.lines.slid,
            push: moment.lines.push,
        });
        shown.and_then(|shown| serde_json::to_string(&shown).ok()).unwrap_or_default()
    }

    /// Tries a motion under one more factor on its loads, the worst first; true while there is more to try. Then the answer has its strengths.
    pub fn try_strength(&mut self) -> bool {
        if self.held.is_some() {
            return false;
        }
        let (place, mut tried) = std::mem::take(&mut self.drawn.trying);
        let Some(motion) = self.settled_motion(place) else {
            self.drawn.trying = (place, tried);
            return false;
        };
        let is_asked = motion.strength.is_none() && Strength::is_asked_of(&motion.case, &motion.outcome);
        let next = Factors::Rungs.values().get(tried.len()).copied().filter(|_| is_asked);
        // A motion that is refused under a factor has no strength.
        let one = next.map(|factor| Tried::under(&motion.case.problem, factor));
        self.drawn.trying = match one {
            Some(Ok(one)) => {
                tried.push(one);
                (place, tried)
            }
            Some(Err(_)) => (place + 1, Vec::new()),
            None => {
                if is_asked {
                    motion.strength = Strength::of_tried(&motion.case, &motion.outcome, tried).ok();
                }
                (place + 1, Vec::new())
            }
        };
        true
    }

    /// The strip of strengths, so wide; empty while they are not known.
    pub fn strengths(&self, width: f64) -> String {
        let worst = self.answered().motions.first();
        let strip = worst.and_then(|worst| strengths_on_screen(worst, width));
        strip.map_or(String::new(), |strip| strip.svg().to_owned())
    }

    /// The histories, of about a size.
    pub(crate) fn histories(&self, size: (f64, f64)) -> Option<Picture> {
        let pinned = self.pinned.as_ref().and_then(Pinned::motion);
        histories_on_screen_beside(self.answered().motions.first()?, pinned, size)
    }

    /// Left, top, right and bottom of the histories last drawn; empty if another plate is.
    pub fn histories_plot(&self) -> Vec<f64> {
        let plot = self.drawn.histories.as_ref().map(|picture| picture.plot);
        plot.map_or_else(Vec::new, |plot| vec![plot.x0, plot.y0, plot.x1, plot.y1])
    }
}

#[cfg(test)]
mod tests {
    use standfast_cases::Document;
    use standfast_cases::motion::{Follow, FollowedMotion, MotionView, StrengthAsked};

    use super::*;
    use crate::examples;

    fn page(name: &str) -> Page {
        let mut page = Page::default();
        let example = examples::find(name).unwrap();
        assert!(page.open(&example.file(), example.text));
        page
    }

    fn json(text: &str) -> serde_json::Value {
        serde_json::from_str(text).unwrap()
    }

    /// A case at rest has no stage, and each in time has one pose for each step.
    #[test]
    fn cases_in_time_have_poses_at_even_steps() {
        for name in
            ["server-rack-earthquake", "block-base-pulse", "caisson-breaking-wave", "statue-earthquake"]
        {
            let mut page = page(name);
            let stage = json(&page.stage(false, (600.0, 400.0)));
            let [end, step] = ["end", "step"].map(|key| stage[key].as_f64().unwrap());
            let poses = page.poses();
            assert_eq!(poses.len() % 5, 0);
            assert!(((poses.len() / 5 - 1) as f64 * step - end).abs() < 1e-9 * end, "{name}");
            assert!(poses.iter().all(|number| number.is_finite()));
            // At the beginning it stands; each pose has the mode of the program's series.
            assert_eq!(&poses[2..5], [0.0, 0.0, 0.0], "{name}");
            let outcome = &page.answered().motions[0].outcome;
            for (i, pose) in poses.chunks(5).enumerate().step_by(37) {
                let at = outcome.at(i as f64 * step).unwrap();
                assert_eq!(pose[4], f32::from(at.state as u8), "{name}");
            }
        }
        let mut page = page("goda-2000");
        assert_eq!(
            (page.stage(false, (600.0, 400.0)), page.poses().len(), page.moment(0.0)),
            (String::new(), 0, String::new())
        );
    }

    /// What is said at the largest turn is what the answer says of it; nothing moves before the shaking does.
    #[test]
    fn a_moment_says_what_the_answer_says() {
        let mut page = page("server-rack-earthquake");
        page.stage(false, (600.0, 400.0));
        let t = page.answered().motions[0].outcome.t_max_theta;
        let most = json(&page.moment(t));
        let words: Vec<_> =
            most["words"].as_array().unwrap().iter().map(|word| word.as_str().unwrap()).collect();
        let answer = page.answered().summary().unwrap().answer;
        let turned = words.iter().find(|word| word.starts_with("turned")).unwrap();
        let number = |text: &str, after: &str| -> f64 {
            text.split(after).nth(1).and_then(|rest| rest.split('°').next()).unwrap().parse().unwrap()
        };
        assert!(
            (number(turned, "turned ") - number(&answer, "it turned by ")).abs() <= 0.05,
            "{answer} {words:?}"
        );
        assert!(!most["arc"].as_str().unwrap().is_empty());
        let first = json(&page.moment(0.0));
        assert_eq!(
            (&first["clock"], &first["arc"], &first["slid"]),
            (&"0.0 s".into(), &"".into(), &"".into())
        );
    }

    /// Tried one by one, the strength is that of the program, which tries all at once; another text begins anew.
    #[test]
    fn strength_one_by_one_is_that_of_all_at_once() {
        let mut page = page("block-base-pulse");
        assert_eq!(page.strengths(500.0), "");
        let steps = std::iter::from_fn(|| page.try_strength().then_some(())).count();
        assert_eq!(steps, Factors::Rungs.values().len() + 1);
        let follow = Follow {
            divergence: true,
            strength: StrengthAsked::Always(Factors::Rungs),
            series: true,
            threads: 1,
        };
        let at_once = FollowedMotion::of_file(page.file(), &follow).unwrap();
        assert!(at_once[0].strength.is_some());
        assert_eq!(page.answered().motions[0].strength, at_once[0].strength);
        assert_eq!(page.answered().summary(), at_once[..].summary());
        assert!(page.strengths(500.0).contains("overturn"));
        page.try_strength();
        let text = page.text().replacen('\n', "\n\n", 1);
        assert!(page.edit(&text));
        assert_eq!(page.strengths(500.0), "");
        assert!(page.try_strength());
    }

    /// Of several situations each has its strength in the end: the JSON is the program's.
    #[test]
    fn every_situation_has_its_strength() {
        let mut page = Page::default();
        let text = examples::find("caisson-breaking-wave").unwrap().text;
        let text = format!("{text}\n[[combination]]\nname = \"twice\"\nfactors = {{ wave = 2 }}\n");
        assert!(page.open("two.toml", &text));
        assert_eq!(page.answered().motions.len(), 2);
        while page.try_strength() {}
        let follow = Follow {
            divergence: true,
            strength: StrengthAsked::Always(Factors::Rungs),
            series: true,
            threads: 1,
        };
        let at_once = FollowedMotion::of_file(page.file(), &follow).unwrap();
        assert_eq!(page.answered().json(), at_once[..].json(&MotionView::default(), &[]));
    }

    /// From the earth the ground moves, from the floor it does not.
    #[test]
    fn the_ground_moves_from_the_earth_alone() {
        let mut page = page("server-rack-earthquake");
        for from_earth in [false, true] {
            page.stage(from_earth, (600.0, 400.0));
            assert_eq!(page.poses().chunks(5).any(|pose| pose[3] != 0.0), from_earth);
        }
    }
}
