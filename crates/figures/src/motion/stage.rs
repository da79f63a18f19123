//! The motion on a screen: the body where it began, and the groups that a page moves.

use std::fmt::Write;

use standfast::{Mode, Verdict};

use super::{MotionOutline, MotionPose, enlargement, extent, farther, polygon, positions::ground};
use crate::Figure;
use crate::palette::{FAINT, INK, MARK, PUSH};
use crate::scene::{Pen, Scene};

/// White around the body, above it, and below the base, where what it slid and the push of the ground are drawn.
const SIDE: f64 = 14.0;
const TOP: f64 = 14.0;
const BELOW: f64 = 52.0;
/// The longest arrow of the ground's acceleration.
const LONGEST: f64 = 70.0;

/// A body on a screen, with the groups that move: `sf-floor`, which goes with the ground, in it `sf-body`, in that one `sf-mode` for each
/// state; and the lines of classes `sf-arc`, `sf-balance`, `sf-slid`, `sf-push`.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionStage {
    /// The drawing, with the body as it stood.
    pub figure: Figure,
    /// So many times as large moves on the floor are drawn; 1 is true scale.
    pub times: f64,
    outline: MotionOutline,
    /// θ of balance about O, and about O' (below zero).
    balance: [f64; 2],
    scale: f64,
    /// Where the middle of the start lies in the drawing, and the base.
    origin: (f64, f64),
    middle: f64,
}

/// Where the groups of a stage are at a moment, and its lines as paths of SVG.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct StageLines {
    /// From the vertical to the body's turn, about the corner it turns on.
    pub arc: String,
    /// On from there to the angle at which it tips over.
    pub balance: String,
    /// From where the corner stood to where it is.
    pub slid: String,
    /// The acceleration of the ground.
    pub push: String,
}

/// A stage about as large as `size`, with room for all poses and for the shifts of the ground beside them.
pub fn motion_stage(
    title: &str,
    outline: &MotionOutline,
    balance: [f64; 2],
    poses: &[MotionPose],
    shifts: &[f64],
    (width, height): (f64, f64),
) -> MotionStage {
    let times = enlargement(outline, poses).map_or(1.0, |(times, _)| times);
    let drawn: Vec<MotionPose> = poses.iter().map(|pose| farther(outline, times, pose)).collect();
    let standing = outline.standing();
    let shifted = |(pose, shift): (&MotionPose, &f64)| MotionPose { x: pose.x + shift, ..*pose };
    let moved: Vec<MotionPose> = drawn.iter().zip(shifts).map(shifted).collect();
    let start = shifts.iter().map(|shift| MotionPose { x: *shift, ..standing });
    let start: Vec<MotionPose> = start.collect();
    let all = extent(
        outline,
        drawn.iter().filter(|_| shifts.is_empty()).chain(&moved).chain(&start).chain([&standing]),
    );
    let across = all.x1 - all.x0;
    let up = all.y1.max(outline.height);
    let scale = ((width - 2.0 * SIDE) / (1.06 * across)).min((height - TOP - BELOW) / up).max(1e-9);
    let base = height - BELOW;
    let middle = width / 2.0;
    let origin = (middle - scale * (all.x0 + all.x1) / 2.0, base);
    let stage = MotionStage {
        figure: Figure::kept(String::new(), String::new(), Vec::new(), (width, height)),
        times,
        outline: *outline,
        balance,
        scale,
        origin,
        middle,
    };
    let figure = stage.drawn(title, &drawn, !shifts.is_empty());
    MotionStage { figure, ..stage }
}

impl MotionStage {
    fn place(&self, (x, y): (f64, f64)) -> (f64, f64) {
        (self.origin.0 + self.scale * x, self.origin.1 - self.scale * y)
    }

    /// A pose as the group of the body takes it: x and y in the drawing, and degrees clockwise.
    pub fn pose(&self, pose: &MotionPose) -> [f64; 3] {
        let far = farther(&self.outline, self.times, pose);
        let (x, y) = self.place((far.x, far.y));
        [x, y, -far.theta.to_degrees()]
    }

    /// A length in the drawing.
    pub fn length(&self, length: f64) -> f64 {
        self.scale * length
    }

    /// The lines at a pose, and the ground's acceleration as a share of its largest; of what is too small to be seen none.
    pub fn lines(&self, pose: &MotionPose, push: f64) -> StageLines {
        const SEEN: f64 = 3.0;
        let far = farther(&self.outline, self.times, pose);
        let MotionOutline { b1, b2, height, .. } = self.outline;
        let [o, toe, ..] = self.outline.corners(&far).map(|at| self.place(at));
        let (foot, stood, limit) =
            if far.theta >= 0.0 { (o, -b1, self.balance[0]) } else { (toe, b2, self.balance[1]) };
        let radius = 0.82 * self.scale * height;
        let at = |angle: f64| (foot.0 - radius * angle.sin(), foot.1 - radius * angle.cos());
        let arc = |from: f64, to: f64| {
            let ((x, y), (x1, y1)) = (at(from), at(to));
            let sweep = u8::from(to < from);
            format!("M{x:.1} {y:.1}A{radius:.1} {radius:.1} 0 0 {sweep} {x1:.1} {y1:.1}")
        };
        let mut lines = StageLines::default();
        if radius * far.theta.abs() > SEEN && pose.mode != Mode::Flight {
            let (x, y) = at(0.0);
            let _ = write!(lines.arc, "M{:.1} {:.1}L{x:.1} {y:.1}{}", foot.0, foot.1, arc(0.0, far.theta));
            if far.theta.abs() < limit.abs() && self.times == 1.0 {
                lines.balance = arc(far.theta, limit);
            }
        }
        let (from, level) = (self.place((stood, 0.0)).0, self.origin.1 + 15.0);
        if (foot.0 - from).abs() > SEEN && pose.mode != Mode::Flight {
            let to = foot.0;
            let _ = write!(
                lines.slid,
                "M{from:.1} {0:.1}v10M{to:.1} {0:.1}v10M{from:.1} {level:.1}H{to:.1}",
                level - 5.0
            );
        }
        let reach = LONGEST * push;
        if reach.abs() > 1.0 {
            let (tip, back, y) = (self.middle + reach, -5.0 * reach.signum(), self.origin.1 + 34.0);
            let _ =
                write!(lines.push, "M{:.1} {y:.1}H{tip:.1}m{back} -4L{tip:.1} {y:.1}l{back} 4", self.middle);
        }
        lines
    }

    fn drawn(&self, title: &str, poses: &[MotionPose], moves: bool) -> Figure {
        let (width, height) = self.figure.size();
        let mut scene = Scene::themed();
        let (x, y) = self.place((0.0, 0.0));
        if moves {
            // What stays where it is while the ground moves.
            scene
                .stroke(&crate::scene::Path::through(&[(x, y + 6.0), (x, y + 26.0)]), Pen::solid(FAINT, 1.0));
        }
        scene.open("class=\"sf-floor\"");
        let beyond = if moves { width } else { 0.0 };
        ground(&mut scene, (-beyond, width + beyond), y);
        let standing = self.outline.standing();
        let start = self.outline.corners(&standing).map(|at| self.place(at));
        scene.stroke(&polygon(&start), Pen { colour: FAINT, width: 0.9, dashes: "3.6 2.8" });
        let [x, y, _] = self.pose(&standing);
        scene.open(&format!("class=\"sf-body\" transform=\"translate({x:.2} {y:.2})\""));
        let centred = MotionPose { y: 0.0, ..standing };
        let corners = self.outline.corners(&centred).map(|(x, y)| (self.scale * x, -self.scale * y));
        for mode in Mode::ALL {
            if mode != Mode::Rest && poses.iter().all(|pose| pose.mode != mode) {
                continue;
            }
            let hidden = if mode == Mode::Rest { "" } else { " display=\"none\"" };
            scene.open(&format!("class=\"sf-mode\" data-mode=\"{}\"{hidden}", mode as u8));
            scene.area(&corners, Verdict::Begins(mode));
            scene.close();
        }
        scene.stroke(&polygon(&corners), Pen::solid(INK, 1.4));
        scene.dot((0.0, 0.0), 2.8, INK, None);
        scene.close();
        for (class, colour, more) in
            [("sf-balance", MARK, " stroke-dasharray=\"2 3\""), ("sf-arc", MARK, ""), ("sf-slid", INK, "")]
        {
            let stroke = scene.paint(colour).into_owned();
            scene.put(&format!("<path class=\"{class}\" d=\"\" fill=\"none\" stroke=\"{stroke}\" stroke-width=\"1.3\"{more}/>\n"));
        }
        let stroke = scene.paint(PUSH).into_owned();
        scene.put(&format!(
            "<path class=\"sf-push\" d=\"\" fill=\"none\" stroke=\"{stroke}\" stroke-width=\"2\"/>\n"
        ));
        scene.close();
        let description = "The body at one moment of its motion, over where it stood, dashed.";
        let title = format!("{title}: the body in motion");
        let (svg, labels) = scene.finish(width, height, &title, description);
        Figure { svg, title, caption: String::new(), labels, size: (width, height) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const OUTLINE: MotionOutline = MotionOutline { b1: 1.0, b2: 1.0, d: 3.0, height: 6.0 };

    fn stage(poses: &[MotionPose], shifts: &[f64]) -> MotionStage {
        motion_stage("A block", &OUTLINE, [0.32, -0.32], poses, shifts, (500.0, 400.0))
    }

    /// The body turned about a corner keeps that corner where it stood, on the base.
    #[test]
    fn a_rocking_body_stays_on_its_corner() {
        // About O: x = −1 + cosθ − 3 sinθ, y = 3 cosθ + sinθ.
        let (sin, cos) = 0.3_f64.sin_cos();
        let rocks = MotionPose {
            t: 1.0,
            x: -1.0 + cos - 3.0 * sin,
            y: 3.0 * cos + sin,
            theta: 0.3,
            slide: 0.0,
            mode: Mode::RockO,
        };
        let stage = stage(&[rocks], &[]);
        assert_eq!(stage.times, 1.0);
        let [x, y, degrees] = stage.pose(&rocks);
        let (s, c) = degrees.to_radians().sin_cos();
        let unit = stage.length(1.0);
        // The corner at (−1, 3) below the centre, in the group that is turned clockwise by so many degrees.
        let corner = (x + unit * (-c - 3.0 * s), y + unit * (-s + 3.0 * c));
        let stood = stage.place((-1.0, 0.0));
        assert!(
            (corner.0 - stood.0).abs() < 1e-9 && (corner.1 - stood.1).abs() < 1e-9,
            "{corner:?} {stood:?}"
        );
        let lines = stage.lines(&rocks, -1.0);
        assert!(lines.arc.starts_with(&format!("M{:.1} {:.1}L", stood.0, stood.1)), "{lines:?}");
        assert!(lines.slid.is_empty() && !lines.balance.is_empty());
        // To the left, as long as an arrow can be.
        assert!(lines.push.contains(&format!("H{:.1}", stage.middle - LONGEST)), "{lines:?}");
    }

    /// All that moves stays in the drawing, from the floor and with the ground; small moves are drawn larger.
    #[test]
    fn a_stage_has_room_for_all_poses() {
        let slid = MotionPose { slide: -4.0, x: -4.0, mode: Mode::SlideLeft, ..OUTLINE.standing() };
        for (shifts, far) in [(&[][..], 4.0), (&[-9.0][..], 13.0)] {
            let stage = stage(&[slid], shifts);
            let x = stage.pose(&slid)[0] - stage.length(far - 4.0);
            assert!(x - stage.length(1.0) >= SIDE - 1e-9, "{x}");
            let started = stage.pose(&OUTLINE.standing())[0];
            assert!((started - stage.pose(&slid)[0] - stage.length(4.0)).abs() < 1e-9);
            assert!(started + stage.length(1.0) <= 500.0);
        }
        let little = MotionPose { slide: -0.01, x: -0.01, mode: Mode::SlideLeft, ..OUTLINE.standing() };
        let enlarged = stage(&[little], &[]);
        assert_eq!(enlarged.times, 10.0);
        let moved = enlarged.pose(&OUTLINE.standing())[0] - enlarged.pose(&little)[0];
        assert!((moved - enlarged.length(0.1)).abs() < 1e-9);
    }
}
