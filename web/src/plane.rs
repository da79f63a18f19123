//! Drawings of the case: the section, the body that begins to move, the plates of the right side.

use serde::Serialize;
use standfast::Diagram;
use standfast_cases::assess::UP_TO;
use standfast_cases::assess::pinned::{self, share_of};
use standfast_cases::assess::screen::{
    Pressures, SectionView, load_plane_on_screen_beside, section_as_fitted, section_on_screen,
};
use standfast_cases::directions::on_screen;
use standfast_cases::motion::screen::MotionOnScreen;
use standfast_cases::motion::screen::histories_on_paper;
use standfast_cases::motion::{MotionView, Tried};
use standfast_cases::{AnswerFigure, Assessed, Assessment, AssessmentView, Document};
use standfast_figures::{
    DesignPoint, Figure, FreeBody, Map, Picture, PinnedDiagram, PinnedLoad, Pose, Rect, SectionArrow,
    SectionFit, View, cases_on_screen, free_body,
};
use standfast_inputs::key::{Id, Table};

use crate::page::Page;

/// What was drawn last, and where things lie in it.
#[derive(Debug, Default)]
pub struct Drawn {
    /// The plane of the right plate.
    pub plane: Option<Picture>,
    /// Histories of the motion, if they are the right plate, and the motion of the left one.
    pub histories: Option<Picture>,
    pub motion: Option<MotionOnScreen>,
    /// The motion whose strength is looked for, and what was tried of it so far.
    pub trying: (usize, Vec<Tried>),
    /// Courses of histories, by which they are of.
    pub courses: Vec<((Table, usize), Picture)>,
    /// Name of that plate.
    which: String,
    /// Forces of the section.
    pub forces: Vec<(Id, SectionArrow)>,
    /// Body of the section.
    pub body: Option<Rect>,
    /// Units for a metre of the section.
    pub scale: Option<f64>,
    /// Scale and look of the section.
    pub fit: Option<SectionFit>,
    /// How its pressures are drawn.
    pub pressures: Option<Pressures>,
}

impl Drawn {
    /// True if the plane is that of the load as it grows.
    pub fn is_load(&self) -> bool {
        self.which == LOAD
    }

    /// True if the plane is the report's.
    pub fn is_k_mu(&self) -> bool {
        self.which == K_MU
    }
}

/// Share of the load and friction.
pub const LOAD: &str = "load";
/// Force and friction, the report's plane.
pub const K_MU: &str = "k-mu";
/// Rest over all horizontal directions.
pub const DIRECTIONS: &str = "directions";
/// Histories of the motion.
pub const TIME: &str = "time";

/// A number of the case that the section shows, and the middle of its label.
#[derive(Serialize)]
struct ShownNumber {
    key: String,
    x: f64,
    y: f64,
}

/// A handle: of a force the beginning of its arrow, of the width and the height of the body the end of its line.
#[derive(Serialize)]
struct Handle {
    key: String,
    x: f64,
    y: f64,
    words: &'static str,
}

/// The section as the page takes it.
#[derive(Serialize, Default)]
struct SectionShown {
    svg: String,
    size: (f64, f64),
    /// Left, top, right and bottom of the body.
    body: [f64; 4],
    /// Units for a metre.
    scale: f64,
    numbers: Vec<ShownNumber>,
    forces: Vec<Handle>,
    sides: Vec<Handle>,
    /// The loads by their letters, and sentences on the drawing.
    words: Vec<String>,
    /// True if pressures are drawn as sums; nothing without any.
    summed: Option<bool>,
}

impl Page {
    /// The section, about as large as `size`, with pressures drawn as a person has chosen, if one has, as JSON; without a drawing of a body
    /// in pure numbers.
    pub fn section(&mut self, size: (f64, f64), chosen: Option<Pressures>) -> String {
        let fit = self.drawn.fit.filter(|_| self.held.as_ref().is_some_and(|held| held.is_sized));
        let pinned = self.pinned.as_ref().and_then(|pinned| pinned.body.as_ref());
        // What is held stays as it was drawn.
        let as_drawn = self.drawn.pressures.filter(|_| self.held.is_some());
        let view = SectionView { pinned, pressures: chosen.or(as_drawn) };
        let draw = |rest: &Assessment| match fit {
            // A side that is held stays under the hand.
            Some(fit) => section_as_fitted(rest, view, fit).ok(),
            None => section_on_screen(rest, view, size).ok(),
        };
        let drawn = self.answered().rest.as_ref().and_then(draw);
        let Some(section) = drawn else {
            return serde_json::to_string(&self.positions()).unwrap_or_default();
        };
        let file = self.settled();
        let has = |id: &Id| file.written_number(*id).is_some();
        let numbers = section.numbers.iter().filter(|(id, _)| has(id)).map(|(id, rect)| {
            let (x, y) = rect.centre();
            ShownNumber { key: id.to_string(), x, y }
        });
        let forces = section.forces.iter().filter(|(id, arrow)| has(id) && arrow.tail.0 != arrow.tip.0).map(
            |(id, arrow)| Handle {
                key: id.to_string(),
                x: arrow.tail.0,
                y: arrow.tail.1,
                words: id.key.info().words,
            },
        );
        let Rect { x0, y0, x1, y1 } = section.picture.body;
        let sides = section.sides.iter().filter(|(id, _)| has(id)).map(|(id, (x, y))| Handle {
            key: id.to_string(),
            x: *x,
            y: *y,
            words: id.key.info().words,
        });
        let shown = SectionShown {
            svg: section.picture.figure.svg().to_owned(),
            size: section.picture.figure.size(),
            body: [x0, y0, x1, y1],
            scale: section.picture.scale,
            numbers: numbers.collect(),
            forces: forces.collect(),
            sides: sides.collect(),
            words: section.words,
            summed: section.pressures.map(|pressures| pressures == Pressures::Summed),
        };
        // An arrow that is held is measured by where it was.
        if self.held.is_none() {
            self.drawn.forces = section.forces;
            self.drawn.body = Some(section.picture.body);
            self.drawn.scale = Some(section.picture.scale);
            self.drawn.fit = Some(section.picture.fit);
            self.drawn.pressures = section.pressures;
        }
        serde_json::to_string(&shown).unwrap_or_default()
    }

    /// Where there is no section, the positions of the motion.
    fn positions(&self) -> SectionShown {
        let figures = self.answered().motions[..].figures(&MotionView::default()).unwrap_or_default();
        let positions = figures.into_iter().find(|figure| figure.suffix.ends_with("-positions"));
        positions.map_or_else(SectionShown::default, |positions| SectionShown {
            svg: positions.figure.svg_on_screen(),
            size: positions.figure.size(),
            ..SectionShown::default()
        })
    }

    /// The body under all loads, where they are one horizontal force.
    pub fn body(&self, size: (f64, f64)) -> Option<(Figure, Pose)> {
        let reduced = self.answered().point()?;
        let body = FreeBody { point: reduced.point, mirrored: reduced.mirrored, omega: 0.0 };
        Some(free_body(&body, size))
    }

    /// The plates of the right side that the case has, that in which it says most first.
    pub fn plates(&self) -> Vec<&'static str> {
        let answered = self.answered();
        let in_air = answered.worst().is_some_and(|worst| worst.situation.in_air().is_some());
        let rises = answered.worst().is_some_and(standfast_cases::Assessed::rises);
        let mut plates = Vec::new();
        if answered.worst().is_some_and(|worst| worst.outcome.plan.is_some()) {
            plates.push(DIRECTIONS);
            return plates;
        }
        if answered.is_in_time() {
            plates.push(TIME);
        }
        let (first, second) = if in_air { (K_MU, LOAD) } else { (LOAD, K_MU) };
        for plate in [first, second] {
            let has = if plate == LOAD { rises } else { answered.point().is_some() };
            if has {
                plates.push(plate);
            }
        }
        plates
    }

    /// A plate of the right side; empty of a case that does not have it.
    pub fn plate(&mut self, which: &str, size: (f64, f64)) -> String {
        self.drawn.which = which.to_owned();
        let (svg, plane) = match which {
            LOAD => self.load_plane(size),
            K_MU => self.with_map(size, |map| map.on_screen_beside(self.pinned_diagram())),
            _ => None,
        }
        .map_or((String::new(), None), |picture| (picture.figure.svg().to_owned(), Some(picture)));
        let svg = if which == DIRECTIONS { self.directions(size) } else { svg };
        self.drawn.plane = plane;
        self.drawn.histories = if which == TIME { self.histories(size) } else { None };
        self.drawn.histories.as_ref().map_or(svg, |picture| picture.figure.svg().to_owned())
    }

    /// Rest over all horizontal directions; empty of a case in the plane of its section.
    fn directions(&self, size: (f64, f64)) -> String {
        let answered = self.answered();
        let both = answered.rest.as_ref().zip(answered.worst());
        let drawn = both.and_then(|(rest, worst)| on_screen(rest, worst, size));
        drawn.map_or(String::new(), |figure| figure.svg().to_owned())
    }

    fn load_plane(&self, (width, height): (f64, f64)) -> Option<Picture> {
        /// What the numbers and names of the axes take, and the friction beside the plot.
        const AROUND: (f64, f64) = (118.0, 80.0);
        let answered = self.answered();
        let (rest, worst) = answered.rest.as_ref().zip(answered.worst())?;
        let name = rest.name(worst).filter(|_| rest.all.len() > 1);
        let title: Vec<String> = rest.case.title.iter().cloned().chain(name).collect();
        let plot = ((width - AROUND.0).max(120.0), (height - AROUND.1).max(120.0));
        let title = title.join(", ");
        self.with_pinned_load(worst, |pinned| {
            load_plane_on_screen_beside(worst, &title, pinned, UP_TO, plot).ok().flatten()
        })
    }

    /// Does something with the plane of the load of A, if a case is pinned that has one.
    fn with_pinned_load<T>(&self, worst: &Assessed, draw: impl FnOnce(Option<PinnedLoad<'_>>) -> T) -> T {
        let found = self.pinned.as_ref().and_then(|pinned| {
            let share = share_of(pinned.answered.worst()?, worst);
            Some((pinned.plane(share)?, share))
        });
        draw(found.as_ref().map(|(plane, share)| PinnedLoad { plane, share: *share }))
    }

    /// The report's plane of A, if a case is pinned that has one.
    fn pinned_diagram(&self) -> Option<&PinnedDiagram> {
        self.pinned.as_ref()?.diagram.as_ref()
    }

    /// The k–μ plane of the case, and the part of it that is seen.
    fn shown(&self) -> Option<(Diagram, View)> {
        let reduced = self.answered().point()?;
        let diagram = Diagram::of(reduced.point.chart());
        let view = self.view.filter(View::is_drawable).unwrap_or_else(|| {
            let view = View::of(&diagram, reduced.point.k(), reduced.point.mu());
            let view = self.pinned_diagram().map_or(view, |pinned| pinned.with_room(view));
            if view.is_drawable() { view } else { View { k_min: 0.0, k_max: 1.0, mu_min: 0.0, mu_max: 1.0 } }
        });
        Some((diagram, view))
    }

    /// Does something with the map of the k–μ plane; `None` where the loads have no point in it.
    pub fn with_map<T>(&self, size: (f64, f64), draw: impl FnOnce(&Map<'_>) -> T) -> Option<T> {
        let (diagram, view) = self.shown()?;
        Some(draw(&Map { diagram: &diagram, figure: None, view: &view, size }))
    }

    /// Place of the design point in the plane last drawn, whether it lies in the plot, and whether it goes to the side and up.
    pub fn point(&self) -> Vec<f64> {
        let number = |truth: bool| f64::from(u8::from(truth));
        let values = match &self.drawn.which[..] {
            LOAD => {
                let friction = self.answered().worst().map(|worst| worst.situation.static_friction());
                friction.map(|mu| (self.share(), mu))
            }
            K_MU => self.answered().point().map(|reduced| (reduced.point.k(), reduced.point.mu())),
            _ => None,
        };
        let plane = self.drawn.plane.as_ref();
        let Some((plane, (across, up))) = plane.zip(values) else { return Vec::new() };
        let place = plane.place(across, up);
        let (x, y) =
            (place.0.clamp(plane.plot.x0, plane.plot.x1), place.1.clamp(plane.plot.y0, plane.plot.y1));
        let [sideways, upwards] = self.point_goes();
        vec![x, y, number(place == (x, y)), number(sideways), number(upwards)]
    }

    /// How far down the plate last drawn is seen; 0 of all.
    pub fn plate_bottom(&self) -> f64 {
        /// Room for the numbers and the name of the axis.
        const AXIS: f64 = 50.0;
        let plane = self.drawn.plane.as_ref().filter(|_| self.drawn.is_load());
        plane.map_or(0.0, |plane| plane.plot.y1 + AXIS)
    }

    /// Keeps the view of the plane as it is while something is dragged.
    pub(crate) fn hold_view(&mut self) {
        if self.view.is_none() && self.drawn.which == K_MU {
            self.view = self.shown().map(|(_, view)| view);
            if let Some(held) = &mut self.held {
                held.view_was_free = true;
            }
        }
    }

    /// Zooms about a place in the plane, or about the middle of the plot.
    pub fn zoom(&mut self, factor: f64, at: Option<(f64, f64)>) {
        let Some(((_, view), plane)) = self.shown().zip(self.drawn.plane.as_ref()) else { return };
        let plot = plane.plot;
        let (x, y) = at.unwrap_or(((plot.x0 + plot.x1) / 2.0, (plot.y0 + plot.y1) / 2.0));
        let (k, mu) = plane.values(x, y);
        self.view = Some(view.zoomed(factor, k, mu));
    }

    /// Moves the view by units of the plane, to the right and downwards.
    pub fn pan(&mut self, (right, down): (f64, f64)) {
        let Some(((_, view), plane)) = self.shown().zip(self.drawn.plane.as_ref()) else { return };
        let (width, height) = (plane.plot.x1 - plane.plot.x0, plane.plot.y1 - plane.plot.y0);
        self.view = Some(view.moved(-right / width, down / height));
    }

    /// Shows all of the plane again.
    pub fn reset_view(&mut self) {
        self.view = None;
    }

    /// A plate of the right side in fixed colours, for a file.
    pub fn plane_on_paper(&self, which: &str, size: (f64, f64)) -> String {
        if let Some(figure) = self.pinned_on_paper(which) {
            return figure.svg_on_paper();
        }
        let answered = self.answered();
        let of_rest = |is_it: fn(&AnswerFigure) -> bool| {
            let figures = answered.rest.as_ref()?.figures(&AssessmentView::default()).ok()?;
            figures.into_iter().find(is_it).map(|figure| figure.figure)
        };
        let figure = match which {
            LOAD => of_rest(|figure| figure.suffix.ends_with("-path")),
            DIRECTIONS => of_rest(|figure| figure.suffix.ends_with("-directions")),
            // As the program draws it, with the point in its words; a part of it as it is seen.
            K_MU if self.view.is_none() => of_rest(|figure| figure.words.contains("iagram")),
            K_MU => answered.point().and_then(|reduced| {
                let (k, mu, mirrored) = (reduced.point.k(), reduced.point.mu(), reduced.mirrored);
                let point = DesignPoint { k, mu, label: self.title().to_owned(), mirrored };
                self.with_map(size, |map| map.on_paper_beside(&point, self.pinned_diagram()))
            }),
            _ => {
                let figures = answered.motions[..].figures(&MotionView::default()).ok();
                figures.and_then(|figures| figures.into_iter().next()).map(|figure| figure.figure)
            }
        };
        figure.map_or(String::new(), |figure| figure.svg_on_paper())
    }

    /// A plate in fixed colours with A in dashes; `None` where nothing of A is drawn in it, or a part of the report's plane is seen.
    fn pinned_on_paper(&self, which: &str) -> Option<Figure> {
        let (answered, a) = (self.answered(), self.pinned.as_ref()?);
        let rest = || answered.rest.as_ref().zip(answered.worst());
        match which {
            LOAD => {
                let (rest, worst) = rest()?;
                self.with_pinned_load(worst, |load| {
                    pinned::load_plane_on_paper(rest, worst, UP_TO, load?).ok().flatten()
                })
            }
            K_MU if self.view.is_none() => {
                let (rest, worst) = rest()?;
                pinned::diagram_on_paper(rest, worst, a.diagram.as_ref()?)
            }
            K_MU => None,
            _ => histories_on_paper(answered.motions.first()?, a.motion()?),
        }
    }

    /// The section in fixed colours, for a file.
    pub fn section_on_paper(&self) -> String {
        let body = self.pinned.as_ref().and_then(|pinned| pinned.body.as_ref());
        let rest = self.answered().rest.as_ref();
        if let Some(figure) =
            rest.zip(body).and_then(|(rest, body)| pinned::section_on_paper(rest, body).ok())
        {
            return figure.svg_on_paper();
        }
        let figures =
            self.answered().rest.as_ref().and_then(|rest| rest.figures(&AssessmentView::default()).ok());
        let section = figures.and_then(|figures| figures.into_iter().find(AnswerFigure::is_section));
        section.map_or(String::new(), |section| section.figure.svg_on_paper())
    }

    /// A drawing of the body for a handout.
    pub fn body_on_paper(&self, which: &str) -> String {
        /// Units across and down that a drawing of what begins has on half a page.
        const SIZE: (f64, f64) = (560.0, 380.0);
        match which {
            "begins" => self.body(SIZE).map_or(String::new(), |(figure, _)| figure.svg().to_owned()),
            "moves" => self.positions().svg,
            _ => self.section_on_paper(),
        }
    }

    /// The map of the report's cases with the place of the body, as JSON; an empty drawing where the loads have no point.
    pub fn cases(&self, size: (f64, f64)) -> String {
        let drawn = self.answered().point().map(|reduced| {
            let picture = cases_on_screen(&reduced.point.chart(), size);
            let (x, y) = picture.place(reduced.point.gamma(), reduced.point.k_prime());
            let plot = picture.plot;
            let place = [x.clamp(plot.x0, plot.x1), y.clamp(plot.y0, plot.y1)];
            (picture.figure.svg().to_owned(), place)
        });
        serde_json::to_string(&drawn).unwrap_or_default()
    }
}

/// Range of an axis, for tests of the view.
#[cfg(test)]
fn range(axis: standfast_figures::Axis) -> (f64, f64) {
    (axis.from, axis.to)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_plate_in_which_a_case_says_most_comes_first() {
        let mut page = Page::default();
        assert_eq!(page.plates(), [K_MU, LOAD]);
        for (text, plates) in [
            (include_str!("../../examples/goda-2000.toml"), &[LOAD, K_MU][..]),
            (include_str!("../../examples/goda-on-sand.toml"), &[LOAD]),
            (include_str!("../../examples/motion/caisson-breaking-wave.toml"), &[TIME, LOAD]),
            (include_str!("../../examples/motion/block-base-pulse.toml"), &[TIME]),
        ] {
            assert!(page.open("case.toml", text));
            assert_eq!(page.plates(), plates);
            for which in plates {
                assert!(page.plate(which, (560.0, 380.0)).starts_with("<svg"), "{which}");
                assert!(page.plane_on_paper(which, (560.0, 380.0)).starts_with("<svg"), "{which}");
                assert_eq!(page.point().is_empty(), *which == TIME, "{which}");
            }
        }
        assert_eq!(page.plate(K_MU, (560.0, 380.0)), "");
    }

    #[test]
    fn the_view_zooms_about_a_place_and_shows_all_again() {
        let mut page = Page::default();
        page.plate(K_MU, (560.0, 380.0));
        let whole = page.drawn.plane.clone().unwrap();
        let (x, y) = whole.place(0.5, 0.4);
        page.zoom(0.5, Some((x, y)));
        page.plate(K_MU, (560.0, 380.0));
        let near = page.drawn.plane.clone().unwrap();
        assert!((near.place(0.5, 0.4).0 - x).abs() < 1e-6 && (near.place(0.5, 0.4).1 - y).abs() < 1e-6);
        let width = |(from, to): (f64, f64)| to - from;
        assert!((width(range(near.across)) / width(range(whole.across)) - 0.5).abs() < 1e-9);
        page.pan((-40.0, 30.0));
        page.plate(K_MU, (560.0, 380.0));
        assert_ne!(range(page.drawn.plane.clone().unwrap().across), range(near.across));
        page.reset_view();
        page.plate(K_MU, (560.0, 380.0));
        assert_eq!(range(page.drawn.plane.clone().unwrap().across), range(whole.across));
    }
}
