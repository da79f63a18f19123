//! Moment and rotation of an elastic base: the curve in closed form, its joints, and the most it stands while the weight leans with it.
//!
//! Two plots where one would hide the beginning: the contact changes first at a rotation that may be a hundredth of that of the
//! largest moment.

use standfast::InputError;
use standfast::ground::elastic::{ContactState, ElasticBase, LargestMoment};

use crate::axes::{Axes, Axis, COLUMN, FRAME, LEFT, NUMBER, PAGE};
use crate::below::{Words, verbatim};
use crate::canvas::{Canvas, FORMULA};
use crate::caption::{SIZE, SMALL};
use crate::margins;
use crate::number::digits;
use crate::palette::{BEHIND, INK, MARK};
use crate::scene::Pen;
use crate::text::Text;
use crate::{DesignPoint, Figure};

const CURVE: Pen = Pen::solid(INK, 1.7);
const LEFT_FOR_LOAD: Pen = Pen { colour: INK, width: 1.1, dashes: "5 3.4" };
const LIMIT: Pen = Pen::solid(BEHIND, 1.1);
const FULL_LOAD: Pen = Pen { colour: MARK, width: 0.8, dashes: "2.5 2.2" };
const HEIGHT: f64 = 260.0;
const TOP: f64 = 50.0;
/// Room right of a plot for names at the ends of lines.
const ROOM: f64 = 26.0;
const NAMES: [&str; 2] = ["Rotation, $θ$ (mrad)", "Moment over weight and half-width, $M/(VB)$"];
/// The beginning has a plot of its own if it takes less than this share of the whole.
const HIDDEN: f64 = 0.22;

/// An elastic base under a load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RotationCurve<'a> {
    /// The base and the weight on it.
    pub base: ElasticBase,
    /// Height of the weight above the base, m.
    pub height: f64,
    /// The moment of the full load about the middle of the base, N·m per metre run; its sign is not drawn.
    pub moment: f64,
    /// Title, in a line; not markup.
    pub title: &'a str,
}

/// Moment over rotation of an elastic base: the full load (diamond), the joints of the curve (dots), and dashed what is left for a load that
/// is raised slowly while the weight leans with the body, with its largest value. `None` of a base that cannot carry the weight.
///
/// ```
/// use standfast::ground::elastic::ElasticBase;
/// use standfast_figures::{RotationCurve, rotation_curve};
///
/// let base = ElasticBase::new(7.5, 2.2e6, 50e6)?;
/// let curve = RotationCurve { base, height: 5.25, moment: 4.8e6, title: "Caisson" };
/// let figure = rotation_curve(&curve)?.unwrap();
/// assert!(figure.caption().contains("full contact up to 0.391"));
/// # Ok::<(), standfast::InputError>(())
/// ```
///
/// # Errors
/// If `height` is not above zero.
pub fn rotation_curve(given: &RotationCurve<'_>) -> Result<Option<Figure>, InputError> {
    if given.base.omega() >= 1.0 {
        return Ok(None);
    }
    let draft = Draft {
        given,
        largest: given.base.largest_moment(given.height)?,
        design: given.base.rotation(given.moment.abs()),
        joints: given.base.joints(),
    };
    draft.figure().map(Some)
}

struct Draft<'a> {
    given: &'a RotationCurve<'a>,
    largest: LargestMoment,
    /// The rotation under the full load, rad; `None` where none bears it.
    design: Option<f64>,
    joints: Vec<f64>,
}

/// A plot: how far it goes, rad, and what it is called.
struct Panel {
    to: f64,
    heading: &'static str,
}

impl Draft<'_> {
    /// M/(VB) of a moment.
    fn share(&self, moment: f64) -> f64 {
        moment.abs() / (self.given.base.p() * self.given.base.half_width())
    }

    fn stands(&self) -> bool {
        self.largest.moment > 0.0
    }

    /// The end of full contact, rad.
    fn first_joint(&self) -> f64 {
        self.joints.first().copied().unwrap_or(self.given.base.unit_rotation())
    }

    fn panels(&self) -> Vec<Panel> {
        let design = self.design.unwrap_or_default();
        let first = 3.0 * self.first_joint();
        let whole = (1.35 * self.largest.rotation).max(first).max(1.25 * design);
        // The full load belongs to the beginning if it is there at all.
        let begin = if 1.25 * design < HIDDEN * whole { first.max(1.25 * design) } else { first };
        if begin < HIDDEN * whole {
            let one = Panel { to: begin, heading: "The beginning" };
            vec![one, Panel { to: whole, heading: "As far as it stands" }]
        } else {
            vec![Panel { to: whole, heading: "" }]
        }
    }

    fn figure(&self) -> Result<Figure, InputError> {
        let mut canvas: Option<Canvas> = None;
        let mut bottom = 0.0_f64;
        let panels = self.panels();
        let width = if panels.len() > 1 { PAGE } else { COLUMN };
        let each = width / panels.len() as f64;
        for (i, panel) in panels.iter().enumerate() {
            let left = each * i as f64;
            let (across, up) = (Axis::linear(0.0, 1e3 * panel.to), Axis::linear(0.0, 1.13));
            let axes = Axes::beside_numbers([across, up], (left + LEFT, left + each - ROOM), TOP, HEIGHT);
            let mut own = Canvas::new(axes);
            // One page for all.
            if let Some(before) = canvas.take() {
                own.scene = before.scene;
            }
            bottom = bottom.max(self.panel(&mut own, panel, left + LEFT)?);
            canvas = Some(own);
        }
        let canvas = canvas.expect("there is a plot");
        let edges = (LEFT, width - LEFT);
        let title = match self.given.title {
            "" => "Moment and rotation of the elastic base".to_owned(),
            title => format!("Moment and rotation of the elastic base: {title}"),
        };
        let words = Words {
            title: title.clone(),
            ..Words::new(verbatim(&title, SIZE), margins::words(&self.caption()?, SMALL))
        };
        let description = format!(
            "Chart of the moment about the middle of the base in V B, upwards, over the rotation in mrad, to the right. {}",
            words.caption
        );
        Ok(words.figure(canvas.scene, edges, bottom + 16.0, 16.0, &description))
    }

    /// One plot; gives the y below it.
    fn panel(&self, canvas: &mut Canvas, panel: &Panel, left: f64) -> Result<f64, InputError> {
        let axes = canvas.board.axes;
        let base = &self.given.base;
        for limit in self.limits() {
            let ends = [(0.0, limit), (axes.across.to, limit)];
            canvas.line(&ends, LIMIT);
        }
        let points: Vec<_> =
            base.curve(panel.to)?.iter().map(|[turn, m]| (1e3 * turn, self.share(*m))).collect();
        canvas.line(&points, CURVE);
        let lean = base.p() * self.given.height / 1e3 / (base.p() * base.half_width());
        if self.stands() {
            let rest = points.iter().map(|(turn, m)| (*turn, m - lean * turn));
            // Below zero it stands no more.
            let rest: Vec<_> = rest.take_while(|(_, m)| *m >= 0.0).collect();
            canvas.line(&rest, LEFT_FOR_LOAD);
        }
        axes.border(&mut canvas.scene, FRAME);
        let heading = Text::new(panel.heading, SIZE);
        canvas.scene.text(&heading, left, axes.area.y0 - 31.0, INK);
        self.marks(canvas, panel)?;
        axes.framed(&mut canvas.scene, &axes.ticks());
        let [across, up] = NAMES.map(|words| Text::inline(words, NUMBER));
        axes.name_above(&mut canvas.scene, &up, left, 0.0);
        Ok(axes.name_below(&mut canvas.scene, &across))
    }

    /// Moments that a base bears that does not give, and one of its strength alone, as multiples of V B.
    fn limits(&self) -> Vec<f64> {
        let omega = self.given.base.omega();
        if omega > 0.0 { vec![1.0, 1.0 - omega] } else { vec![1.0] }
    }

    fn marks(&self, canvas: &mut Canvas, panel: &Panel) -> Result<(), InputError> {
        let axes = canvas.board.axes;
        let base = &self.given.base;
        for turn in self.joints.iter().filter(|turn| **turn <= panel.to) {
            let at = axes.at(1e3 * turn, self.share(base.moment(*turn)?));
            canvas.dot(at, 2.6, 6.5);
        }
        if self.stands() && self.largest.rotation <= panel.to {
            let (turn, m) = (1e3 * self.largest.rotation, self.share(self.largest.moment));
            let at = axes.at(turn, m);
            canvas.dot(at, 3.2, 7.5);
            canvas.letter(&Text::new("largest", FORMULA), at);
        }
        // The moment of the full load, from its axis to where the base bears it.
        let share = self.share(self.given.moment);
        let to = self.design.map_or(axes.across.to, |turn| (1e3 * turn).min(axes.across.to));
        if share < axes.up.to {
            canvas.line(&[(0.0, share), (to, share)], FULL_LOAD);
        }
        let beyond = 2.0 * axes.across.to;
        let turn = self.design.map_or(beyond, |turn| 1e3 * turn);
        let point = DesignPoint { k: turn, mu: share, label: "full load".into(), mirrored: false };
        canvas.design_points(&[point]);
        self.names(canvas, panel)
    }

    /// Places the names of the pieces and the lines.
    fn names(&self, canvas: &mut Canvas, panel: &Panel) -> Result<(), InputError> {
        let base = &self.given.base;
        let axes = canvas.board.axes;
        let mut ends = vec![0.0];
        ends.extend(self.joints.iter().copied().filter(|turn| *turn < panel.to));
        ends.push(panel.to);
        for pair in ends.windows(2) {
            let (from, to) = (pair[0], pair[1]);
            let place = |share: f64| {
                let turn = from + share * (to - from);
                base.moment(turn).map(|m| axes.at(1e3 * turn, self.share(m)))
            };
            let places = [0.5, 0.65, 0.35, 0.8, 0.2].map(place);
            let places = places.into_iter().collect::<Result<Vec<_>, _>>()?;
            let length = (axes.x(1e3 * to) - axes.x(1e3 * from)).abs();
            if length > 12.0 {
                let text = Text::new(words(base.state((from + to) / 2.0)?), FORMULA);
                canvas.joined(places, &text);
            }
        }
        for (limit, name) in self.limits().into_iter().zip(["rigid", "strength alone"]) {
            let at = [0.75, 0.5, 0.25, 0.9].map(|share| axes.at(share * axes.across.to, limit));
            canvas.joined(at, &Text::new(name, FORMULA));
        }
        Ok(())
    }

    /// In markup.
    fn caption(&self) -> Result<String, InputError> {
        let base = &self.given.base;
        let mrad = |turn: f64| format!("${}$ mrad", digits(1e3 * turn));
        let mut parts = vec![format!("$τ = θ k_n B^2/V$ is 1 at {}", mrad(base.unit_rotation()))];
        let mut pieces = Vec::new();
        let mut from = 0.0;
        for turn in self.joints.iter().copied().chain([f64::INFINITY]) {
            let middle = if turn.is_finite() { (from + turn) / 2.0 } else { 2.0 * from };
            let state = base.state(middle)?;
            let formula = formula(state);
            let end = if turn.is_finite() { format!(" up to {}", mrad(turn)) } else { String::new() };
            pieces.push(format!("{}{end}, {formula}", words(state)));
            from = turn;
        }
        parts.push(format!("$M/(VB)$: {}", pieces.join("; ")));
        let full = digits(self.share(self.given.moment));
        parts.push(match self.design {
            Some(turn) => {
                let most = self.largest.moment;
                let falls = if most > 0.0 && self.given.moment.abs() > most {
                    ", more than is left for a load that is raised slowly: it overturns"
                } else {
                    ""
                };
                format!("Full load (diamond): ${full}$ at {}{falls}", mrad(turn))
            }
            None => format!("Full load (at the edge): ${full}$, which no rotation bears"),
        });
        let kappa = base.p() * self.given.height / (base.p() * base.half_width()) * base.unit_rotation();
        let kappa = format!("$κ = V d/(k_n B^3) = {}$", digits(kappa));
        parts.push(if self.stands() {
            let (m, turn) = (digits(self.share(self.largest.moment)), mrad(self.largest.rotation));
            format!("Dashed: what is left for a load that is raised slowly while the weight leans with the body, $κτ$ less, {kappa}; the largest is ${m}$ at {turn}")
        } else {
            format!("{kappa}, $2/3$ or more: the body does not stand on springs so soft")
        });
        parts.push(match base.omega() {
            0.0 => "Grey: a rigid base".to_owned(),
            omega => format!(
                "Grey: a rigid base, 1, and one of its strength alone, $1 − ω = {}$",
                digits(1.0 - omega)
            ),
        });
        Ok(parts.join(". ") + ".")
    }
}

fn words(state: ContactState) -> &'static str {
    match state {
        ContactState::Full => "full contact",
        ContactState::Uplift => "uplift",
        ContactState::Yield => "yield, full contact",
        ContactState::UpliftAndYield => "uplift and yield",
    }
}

/// M/(VB), in markup.
fn formula(state: ContactState) -> &'static str {
    match state {
        ContactState::Full => "$2τ/3$",
        ContactState::Uplift => "$1 − (2/(9τ))^{½}$",
        ContactState::Yield => "$A (1 − (2A/(9τ))^{½})$ with $A = (1 − ω)/ω$",
        ContactState::UpliftAndYield => "$1 − ω − 1/(192 ω^3 τ^2)$",
    }
}
