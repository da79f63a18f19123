//! The body itself, to scale, at the moment its motion begins: force, reactions, and the corners' accelerations.
//!
//! Solid arrows are forces, dashed ones accelerations; each kind has a scale of its own. A dashed outline shows where
//! the motion takes the body, exaggerated.

use standfast::ground::strength::{CrushPoint, Stretch};
use standfast::{Corner, CornerAcceleration, Mode, Motion, Point, Verdict};

use crate::Figure;
use crate::palette::{FAINT, INK, MARK, PAPER, PUSH, verdict_symbol};
use crate::scene::{Path, Pen, Rect, Scene};
use crate::text::Text;

/// A body and the force on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeBody {
    /// The body and the force, which points left.
    pub point: Point,
    /// True if the force points right, so that all of it is to be drawn in a mirror.
    pub mirrored: bool,
    /// ω of a base that crushes, V/(2B q_u); 0 of a rigid one. Not negative.
    pub omega: f64,
}

/// Pose to which the motion that begins takes the body, exaggerated: it slides by `shift` and turns by `turn` about
/// `pivot`, which slides with it. Accelerations are constant at first, so at a share s of the time it is there by s².
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// Point about which it turns: a corner, on a base that crushes the neutral point; or the middle of the base.
    pub pivot: (f64, f64),
    /// To the right, in units of the drawing.
    pub shift: f64,
    /// Clockwise, in degrees.
    pub turn: f64,
}

const LABEL: f64 = 14.5;
const SIDE: f64 = 84.0;
const TOP: f64 = 34.0;
const BOTTOM: f64 = 78.0;
/// Range in which k' is drawn: a force farther off is drawn at its ends.
const LOWEST: f64 = -1.3;
const HIGHEST: f64 = 1.9;

/// The drawing, `width` by `height`, and the pose its motion leads to. The moving body is the group of class `body`.
pub fn free_body(given: &FreeBody, (width, height): (f64, f64)) -> (Figure, Pose) {
    let sketch = Sketch::new(given, width, height);
    let mut scene = Scene::themed();
    sketch.ground(&mut scene);
    let pose = sketch.pose();
    sketch.ghost(&mut scene, &pose);
    sketch.body(&mut scene);
    sketch.force(&mut scene);
    sketch.bearing(&mut scene);
    sketch.reactions(&mut scene);
    sketch.accelerations(&mut scene);
    sketch.corners(&mut scene);
    let mode = Text::inline(verdict_symbol(sketch.verdict), LABEL).plain;
    let title = format!("The body, to scale, as it {} ({mode})", sketch.verdict.words().replace('\'', "′"));
    let force = format!(
        "The force F points {} at {} of the body's height above its base.",
        if given.mirrored { "right" } else { "left" },
        crate::number::digits((1.0 + given.point.k_prime()) / 2.0),
    );
    let crushed = match (sketch.pressed, sketch.neutral) {
        (Some(pressed), Some(neutral)) => format!(
            " The base is crushed over {} half-widths (blue), up to the neutral point (circle) {} right of the centre.",
            crate::number::digits(pressed.width()),
            crate::number::digits(neutral),
        ),
        (Some(pressed), None) => format!(
            " The base bears it with its strength over {} half-widths (blue).",
            crate::number::digits(pressed.width()),
        ),
        (None, _) => String::new(),
    };
    let description = match sketch.verdict {
        Verdict::BearingFailure => format!("{force} The base cannot carry the body."),
        Verdict::Begins(_) => format!(
            "{force} The reaction has f_x and f_y, which act {} \
             half-widths right of the centre.{crushed} Dashed: accelerations of the corners O, left, and O′, right, and an exaggerated \
             picture of the motion that begins.",
            crate::number::digits(sketch.motion.xi),
        ),
    };
    let (svg, labels) = scene.finish(width, height, &title, &description);
    (Figure { svg, title, caption: String::new(), labels, size: (width, height) }, pose)
}

struct Sketch {
    verdict: Verdict,
    /// Nothing where the base cannot carry the body.
    motion: Motion,
    /// Part of the base that bears with its strength as it crushes, and the neutral point of a body that turns; in B,
    /// right of the centre.
    pressed: Option<Stretch>,
    neutral: Option<f64>,
    k: f64,
    /// −1 if the force points left.
    towards: f64,
    /// Middle of the base.
    centre: f64,
    base: f64,
    /// Half the width and the height.
    half: f64,
    tall: f64,
    force_level: f64,
    /// Units of the drawing for the weight, and for g.
    per_weight: f64,
    per_gravity: f64,
}

impl Sketch {
    fn new(given: &FreeBody, width: f64, height: f64) -> Sketch {
        let FreeBody { point, mirrored, omega } = *given;
        let gamma = point.gamma();
        let on_base = CrushPoint::of(point, omega.max(0.0)).unwrap_or_else(|_| CrushPoint::rigid(point));
        let verdict = on_base.verdict();
        let begun = on_base.motion().map(|begun| if mirrored { begun.mirrored() } else { begun });
        let verdict = if mirrored { verdict.mirrored() } else { verdict };
        let motion = begun.map_or(Motion::default(), |begun| begun.motion);
        let crushes = begun.filter(|_| on_base.omega() > 0.0);
        let elevation = point.k_prime().clamp(LOWEST, HIGHEST);
        let heights = gamma * (2.0_f64).max(1.0 + elevation);
        let scale = ((width - 2.0 * SIDE) / 2.0).min((height - TOP - BOTTOM) / heights).max(1e-3);
        let base = height - BOTTOM;
        let largest = point.k().max(motion.f_x.abs()).max(motion.f_y);
        let fastest = motion.slip.abs().max(motion.lift_o).max(motion.lift_o_prime);
        Sketch {
            verdict,
            motion,
            pressed: crushes.map(|begun| begun.pressed),
            neutral: crushes.and_then(|begun| begun.neutral),
            k: point.k(),
            towards: if mirrored { 1.0 } else { -1.0 },
            centre: width / 2.0,
            base,
            half: scale,
            tall: 2.0 * gamma * scale,
            force_level: base - (1.0 + elevation) * gamma * scale,
            per_weight: (48.0 / largest).min(44.0),
            per_gravity: if fastest > 0.0 { 44.0 / fastest } else { 0.0 },
        }
    }

    fn corner(&self, corner: Corner) -> (f64, f64) {
        let side = if corner == Corner::O { -1.0 } else { 1.0 };
        (self.centre + side * self.half, self.base)
    }

    /// The outline's corners, from O on.
    fn outline(&self) -> [(f64, f64); 4] {
        let (left, right, top) = (self.centre - self.half, self.centre + self.half, self.base - self.tall);
        [(left, self.base), (right, self.base), (right, top), (left, top)]
    }

    fn pose(&self) -> Pose {
        /// Largest slide of a corner and rotation of the body; and largest way of its crest to the side.
        const SLIDE: f64 = 26.0;
        const TURN: f64 = 0.16;
        const SWAY: f64 = 40.0;
        let Motion { slip, theta_ddot, .. } = self.motion;
        let limits = [
            SLIDE / (slip.abs() * self.half),
            TURN / theta_ddot.abs(),
            SWAY / (theta_ddot.abs() * self.tall),
        ];
        let time = limits.into_iter().fold(f64::INFINITY, f64::min);
        let time = if time.is_finite() { time } else { 0.0 };
        // θ is counter-clockwise, and lengths are in B.
        let (shift, turn) = (slip * time * self.half, -(theta_ddot * time).to_degrees());
        Pose {
            pivot: match (self.neutral, self.verdict.mode().and_then(Mode::corner)) {
                (Some(neutral), _) => (self.centre + neutral * self.half, self.base),
                (None, Some(corner)) => self.corner(corner),
                (None, None) => (self.centre, self.base),
            },
            shift,
            turn,
        }
    }

    fn ground(&self, scene: &mut Scene) {
        let reach = self.half + 62.0;
        let (from, to) = (self.centre - reach, self.centre + reach);
        let mut hatch = Path::default();
        for i in 1..=(2.0 * reach / 8.0) as u32 {
            let x = from + 8.0 * f64::from(i);
            hatch.move_to(x, self.base);
            hatch.line_to(x - 6.0, self.base + 6.0);
        }
        scene.stroke(&hatch, Pen::solid(FAINT, 0.7));
        scene.line((from, self.base), (to, self.base), Pen::solid(INK, 1.2));
    }

    fn ghost(&self, scene: &mut Scene, pose: &Pose) {
        if pose.shift == 0.0 && pose.turn == 0.0 {
            return;
        }
        let (sin, cos) = pose.turn.to_radians().sin_cos();
        let turned = |(x, y): (f64, f64)| {
            let (dx, dy) = (x - pose.pivot.0, y - pose.pivot.1);
            (pose.pivot.0 + pose.shift + dx * cos - dy * sin, pose.pivot.1 + dx * sin + dy * cos)
        };
        let mut path = Path::through(&self.outline().map(turned));
        path.close();
        scene.stroke(&path, Pen { colour: FAINT, width: 0.9, dashes: "3 2.4" });
    }

    fn body(&self, scene: &mut Scene) {
        let corners = self.outline();
        let middle = (self.centre, self.base - self.tall / 2.0);
        scene.open("class=\"body\"");
        scene.area(&corners, self.verdict);
        let mut path = Path::through(&corners);
        path.close();
        scene.stroke(&path, Pen::solid(INK, 1.5));
        scene.dot(middle, 2.4, INK, None);
        if self.half > 22.0 && self.tall > 44.0 {
            let text = Text::new("$C$", LABEL);
            scene.text(&text, middle.0 + 6.0, middle.1 - 5.0, INK);
        }
        scene.close();
    }

    /// A length that is seen.
    fn length(&self, force: f64) -> f64 {
        (force * self.per_weight).max(13.0)
    }

    fn force(&self, scene: &mut Scene) {
        let side = self.centre - self.towards * self.half;
        let top = self.base - self.tall;
        if self.force_level < top - 1.0 {
            scene.line(
                (side, top),
                (side, self.force_level),
                Pen { colour: MARK, width: 0.8, dashes: "2.5 2.2" },
            );
        }
        if self.k == 0.0 {
            return;
        }
        let tip = (side - self.towards * 1.5, self.force_level);
        let tail = (tip.0 - self.towards * self.length(self.k), tip.1);
        scene.arrow(tail, tip, Pen::solid(MARK, 2.0));
        label(scene, "$F$", (tail.0 - self.towards * 11.0, tip.1), MARK);
    }

    /// Draws the part of a crushing base that bears, and the neutral point.
    fn bearing(&self, scene: &mut Scene) {
        const BAND: f64 = 6.0;
        if let Some(Stretch { from, to }) = self.pressed {
            let [from, to] = [from, to].map(|x| self.centre + x * self.half);
            let corners =
                [(from, self.base), (to, self.base), (to, self.base + BAND), (from, self.base + BAND)];
            let mut band = Path::through(&corners);
            band.close();
            scene.stroke(&band, Pen::solid(PUSH, 1.4));
        }
        if let Some(neutral) = self.neutral {
            let at = (self.centre + neutral * self.half, self.base);
            scene.dot(at, 3.2, PAPER, Some(Pen::solid(PUSH, 1.4)));
        }
    }

    fn reactions(&self, scene: &mut Scene) {
        if self.verdict == Verdict::BearingFailure {
            return;
        }
        let Motion { f_x, f_y, xi, .. } = self.motion;
        let x = self.centre + xi * self.half;
        let strong = Pen::solid(PUSH, 2.0);
        let bottom = self.base + 3.0 + self.length(f_y).max(30.0);
        scene.arrow((x, bottom), (x, self.base + 3.0), strong);
        label(scene, "$f_y$", (x, bottom + 11.0), PUSH);
        if f_x != 0.0 {
            let (level, way) = (self.base + 34.0, f_x.signum());
            let (from, tip) = (x + way * 11.0, x + way * (11.0 + self.length(f_x.abs())));
            scene.arrow((from, level), (tip, level), strong);
            label(scene, "$f_x$", (tip + way * 11.0, level), PUSH);
        }
    }

    fn accelerations(&self, scene: &mut Scene) {
        let pen = Pen { colour: INK, width: 1.5, dashes: "4.5 2.6" };
        for (corner, name, out) in [(Corner::O, "O", -1.0), (Corner::OPrime, "{O′}", 1.0)] {
            let CornerAcceleration { along: across, up } = self.motion.at(corner);
            let size = across.hypot(up);
            if size * self.per_gravity < 1.0 {
                continue;
            }
            let length = (size * self.per_gravity).max(16.0);
            let (dx, dy) = (across / size * length, -up / size * length);
            // Along the base it is drawn a little above it, to be seen.
            let (x, y) = self.corner(corner);
            let from = if up == 0.0 { (x, y - 7.0) } else { (x, y) };
            let tip = (from.0 + dx, from.1 + dy);
            scene.arrow(from, tip, pen);
            let markup = match (across == 0.0, up == 0.0) {
                (true, _) => format!(r"$\ddot{{y}}_{name}$"),
                (_, true) => format!(r"$\ddot{{x}}_{name}$"),
                _ => format!(r"$\ddot{{x}}_{name}, \ddot{{y}}_{name}$"),
            };
            let text = Text::new(&markup, 13.5);
            let at = if up == 0.0 {
                // Above the arrow, outside the body.
                let x = if dx * out > 0.0 { tip.0 } else { x + out * (text.width / 2.0 + 8.0) };
                // The force may act there.
                let level = from.1 - 14.0;
                let taken = out * self.towards < 0.0 && (level - self.force_level).abs() < 14.0;
                (x, if taken { self.force_level - 14.0 } else { level })
            } else if dx * out > 0.0 && dy.abs() < dx.abs() {
                // Above an arrow that runs outwards.
                ((x + tip.0) / 2.0 + out * 6.0, tip.1 - 13.0)
            } else {
                let outermost = if out > 0.0 { x.max(tip.0) } else { x.min(tip.0) };
                (outermost + out * (text.width / 2.0 + 7.0), (tip.1 + 6.0).min(y - 13.0))
            };
            scene.text_in(&text, &Rect::around(at.0, at.1, text.width, text.height()), INK);
        }
    }

    fn corners(&self, scene: &mut Scene) {
        for (corner, name, out) in [(Corner::O, "$O$", -1.0), (Corner::OPrime, "$O′$", 1.0)] {
            let (x, y) = self.corner(corner);
            scene.dot((x, y), 2.2, INK, None);
            // A force below the base takes the place beside its corner.
            let taken = self.k > 0.0 && self.force_level > self.base && out * self.towards < 0.0;
            label(scene, name, (x + if taken { -13.0 } else { 13.0 } * out, y + 16.0), INK);
        }
    }
}

fn label(scene: &mut Scene, markup: &str, (x, y): (f64, f64), colour: &'static str) {
    let text = Text::new(markup, LABEL);
    scene.text_in(&text, &Rect::around(x, y, text.width, text.height()), colour);
}
