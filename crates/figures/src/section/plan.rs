//! The base seen from above, under the section and to its scale where there is room.

use super::LABEL;
use super::paint::{Painter, THIN};
use crate::caption::SMALL;
use crate::palette::{CONCRETE, FAINT, INK, MARK};
use crate::scene::{Path, Pen, Rect};
use crate::text::Text;

/// A place seen from above, m: to the right of mid-width, and away from the viewer of the section from the middle of the length.
pub type PlanPlace = (f64, f64);

/// The base seen from above.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanView {
    /// The body around it: its rectangle, or the points of its circle.
    pub body: Vec<PlanPlace>,
    /// Corners of the base, counter-clockwise; points of its circle.
    pub base: Vec<PlanPlace>,
    /// Feet, where it stands on some; those within the base too.
    pub feet: Vec<PlanPlace>,
    /// The point under the centre of mass.
    pub centroid: PlanPlace,
    /// Numbers of the edges, with their middles and the directions out of the base; none of a circle.
    pub edges: Vec<(PlanPlace, PlanPlace)>,
    /// The edge that decides, from zero; none where nothing tips the body.
    pub governing: Option<usize>,
    /// The place of the edge that is nearest to the centre of mass, and how far it is, as it is written.
    pub nearest: (PlanPlace, String),
    /// The horizontal force on the body: its direction, of length one, and how it is written.
    pub force: Option<(PlanPlace, String)>,
    /// The centre of pressure under the full load.
    pub pressure: Option<PlanPlace>,
}

/// Room above the plan for its name.
const NAME: f64 = 46.0;
/// Most height of a plan on the page, and on a screen as a share of the room of the body.
const TALLEST: f64 = 230.0;
/// Length of the arrow of the force.
const FORCE: f64 = 42.0;

impl Painter<'_> {
    /// The base seen from above, below all else.
    pub(super) fn plan(&mut self) {
        let given = self.given;
        let Some(plan) = &given.plan else { return };
        let all = || plan.body.iter().chain(&plan.base).chain(&plan.feet);
        let far = all().map(|place| place.1).fold(f64::NEG_INFINITY, f64::max);
        let near = all().map(|place| place.1).fold(f64::INFINITY, f64::min);
        let tallest = if self.look.on_screen { 0.8 * self.look.body.1 } else { TALLEST };
        let scale = self.scale.min(tallest / (far - near));
        let top = self.drawn.extent.y1 + NAME;
        let middle = self.place(0.0, 0.0).0;
        let at = |place: PlanPlace| (middle + scale * place.0, top + scale * (far - place.1));
        let ring = |places: &[PlanPlace]| {
            let mut path = Path::through(&places.iter().map(|place| at(*place)).collect::<Vec<_>>());
            path.close();
            path
        };
        let ends = all().map(|place| at(*place));
        let around = ends.fold(Rect { x0: middle, y0: top, x1: middle, y1: top }, |rect, (x, y)| Rect {
            x0: rect.x0.min(x),
            y0: rect.y0.min(y),
            x1: rect.x1.max(x),
            y1: rect.y1.max(y),
        });
        self.hold(&around);
        let scene = &mut self.drawn.scene;
        scene.fill(&ring(&plan.base), CONCRETE);
        scene.stroke(&ring(&plan.body), Pen { colour: FAINT, width: 0.9, dashes: "4 3" });
        scene.stroke(&ring(&plan.base), Pen::solid(INK, 1.5));
        if let Some(edge) = plan.governing.filter(|edge| *edge < plan.edges.len()) {
            let count = plan.base.len();
            scene.line(at(plan.base[edge]), at(plan.base[(edge + 1) % count]), Pen::solid(INK, 4.5));
        }
        for foot in &plan.feet {
            scene.dot(at(*foot), 4.5, INK, None);
        }
        let centre = at(plan.centroid);
        scene.line(centre, at(plan.nearest.0), THIN);
        if let Some(pressure) = plan.pressure {
            scene.dot(at(pressure), 3.0, MARK, None);
        }
        scene.dot(centre, 3.0, INK, None);
        for (number, (middle, out)) in plan.edges.iter().enumerate() {
            let (x, y) = at(*middle);
            let text = Text::new(&format!("${}$", number + 1), LABEL);
            self.label(&text, (x + 11.0 * out.0, y - 11.0 * out.1), INK);
        }
        if let Some((towards, words)) = &plan.force {
            let tip = (centre.0 + FORCE * towards.0, centre.1 - FORCE * towards.1);
            self.drawn.scene.arrow(centre, tip, Pen::solid(MARK, 1.6));
            let text = Text::verbatim(words, LABEL);
            // Beyond its tip, or beside that.
            let ways = [(towards.0, -towards.1), (-towards.1, -towards.0), (towards.1, towards.0)];
            let places = [8.0, 24.0].into_iter().flat_map(|gap| {
                ways.map(|(x, y)| {
                    let off = (x * (text.width / 2.0 + gap), y * (text.height() / 2.0 + gap));
                    (tip.0 + off.0, tip.1 + off.1)
                })
            });
            let places: Vec<_> = places.collect();
            self.free_label(&text, &places, MARK);
        }
        let (x, y) = at(plan.nearest.0);
        let pushed = plan.force.as_ref().map_or((0.0, 0.0), |(towards, _)| (towards.0, -towards.1));
        // Beside the line to the edge, on the side to which the force does not point if there is room.
        let (along, text) = ((x - centre.0, y - centre.1), Text::inline(&plan.nearest.1, LABEL));
        let length = along.0.hypot(along.1).max(1e-9);
        let along = (along.0 / length, along.1 / length);
        let side = if along.0 * pushed.1 - along.1 * pushed.0 > 0.0 { 1.0 } else { -1.0 };
        let places = [(side, 0.5), (-side, 0.5), (side, 0.8), (-side, 0.8), (side, 1.3), (-side, 1.3)];
        let places = places.map(|(side, share)| {
            let aside = (side * along.1, -side * along.0);
            let off = aside.0.abs() * text.width / 2.0 + aside.1.abs() * text.height() / 2.0 + 5.0;
            let way = share * length;
            (centre.0 + way * along.0 + off * aside.0, centre.1 + way * along.1 + off * aside.1)
        });
        self.free_label(&text, &places, INK);
        // Around C, farthest from the force and that line first.
        let letter = Text::new("$C$", LABEL);
        let mut ways: Vec<(f64, f64)> =
            (0..8).map(|eighth| (f64::from(eighth) * std::f64::consts::FRAC_PI_4).sin_cos()).collect();
        let near =
            |way: &(f64, f64)| (way.0 * pushed.0 + way.1 * pushed.1).max(way.0 * along.0 + way.1 * along.1);
        standfast::order::by_number(&mut ways, near);
        let places: Vec<_> =
            ways.iter().map(|way| (centre.0 + 13.0 * way.0, centre.1 + 13.0 * way.1)).collect();
        self.free_label(&letter, &places, INK);
        self.compass(&around);
    }

    /// A label at the first of some places at which it lies on no other, or at the first of all.
    fn free_label(&mut self, text: &Text, places: &[(f64, f64)], colour: &'static str) {
        let is_free = |place: &&(f64, f64)| {
            !self.touches(&Rect::around(place.0, place.1, text.width, text.height()).grown(1.0))
        };
        if let Some(place) = places.iter().find(is_free).or(places.first()).copied() {
            self.label(text, place, colour);
        }
    }

    /// Which way is which: the angles of the four sides, and the name of the view.
    fn compass(&mut self, around: &Rect) {
        const APART: f64 = 22.0;
        let (x, y) = around.centre();
        let sides = [
            ("0°", (around.x0 - APART - 8.0, y)),
            ("180°", (around.x1 + APART + 12.0, y)),
            ("270°", (x, around.y1 + APART)),
        ];
        for (words, place) in sides {
            self.label(&Text::verbatim(words, SMALL), place, FAINT);
        }
        let name = Text::verbatim("seen from above; 90°, away from the viewer", SMALL);
        self.label(&name, (x, around.y0 - APART), FAINT);
    }
}
