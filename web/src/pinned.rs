//! A, the case that is pinned beside the one in hand: its answer, and what drawings of the other need of it, made once.

use std::cell::{OnceCell, RefCell};
use std::rc::Rc;

use standfast_cases::assess::UP_TO;
use standfast_cases::assess::pinned::{pinned_body, pinned_diagram, pinned_plane};
use standfast_cases::compare::Compared;
use standfast_cases::motion::screen::pinned_motion;
use standfast_cases::{CaseFile, Summary};
use standfast_figures::{PinnedBody, PinnedDiagram, PinnedMotion, PinnedPlane};

use crate::answered::Answered;
use crate::page::{Page, Version, answer};

/// The case that is pinned.
#[derive(Debug)]
pub struct Pinned {
    /// Its text, and the name of its file.
    pub version: Version,
    /// What it says.
    pub file: CaseFile,
    /// Its answer.
    pub answered: Answered,
    /// The top of its answer.
    pub summary: Option<Summary>,
    /// Its body.
    pub body: Option<PinnedBody>,
    /// Its point of the report's plane, with the plane.
    pub diagram: Option<PinnedDiagram>,
    /// Its plane of the load, and how far it goes.
    plane: RefCell<Option<(f64, Rc<PinnedPlane>)>>,
    motion: OnceCell<Option<PinnedMotion>>,
}

impl Pinned {
    fn of(file: CaseFile, answered: Answered) -> Pinned {
        let rest = answered.rest.as_ref().zip(answered.worst());
        Pinned {
            version: Version { name: file.name().to_owned(), text: file.text().to_owned() },
            summary: answered.summary(),
            body: rest.and_then(|(rest, _)| pinned_body(rest).ok()),
            diagram: rest.and_then(|(rest, worst)| pinned_diagram(rest, worst)),
            plane: RefCell::default(),
            motion: OnceCell::new(),
            file,
            answered,
        }
    }

    /// The boundaries of the plane of its load, as far as one is seen in which its full load lies at a share; `None` where no load rises.
    pub fn plane(&self, share: f64) -> Option<Rc<PinnedPlane>> {
        /// A plane that is made anew goes somewhat farther, so that a drag does not make many.
        const MORE: f64 = 1.5;
        /// The farthest.
        const MOST: f64 = 100.0;
        let wanted = (UP_TO / share).clamp(UP_TO, MOST);
        let mut plane = self.plane.borrow_mut();
        if plane.as_ref().is_none_or(|(up_to, _)| *up_to < wanted) {
            let up_to = if wanted > UP_TO { (MORE * wanted).min(MOST) } else { UP_TO };
            let (rest, worst) = self.answered.rest.as_ref().zip(self.answered.worst())?;
            *plane = Some((up_to, Rc::new(pinned_plane(rest, worst, up_to).ok().flatten()?)));
        }
        plane.as_ref().map(|(_, plane)| Rc::clone(plane))
    }

    /// The histories of its motion; `None` of a case at rest.
    pub fn motion(&self) -> Option<&PinnedMotion> {
        self.motion.get_or_init(|| pinned_motion(self.answered.motions.first()?)).as_ref()
    }

    /// The case beside another.
    pub fn compared(&self) -> Compared<'_> {
        let Answered { rest, motions } = &self.answered;
        Compared { rest: rest.as_ref(), motions, summary: self.summary.as_ref() }
    }
}

impl Page {
    /// Pins the last case that has an answer as A.
    pub fn pin(&mut self) {
        self.pinned = Some(Pinned::of(self.settled().clone(), self.settled_answer().clone()));
    }

    /// Pins a case file as A; false of one that has no answer, which changes nothing.
    pub fn pin_text(&mut self, name: &str, text: &str) -> bool {
        self.pin_version(&Version { name: name.to_owned(), text: text.to_owned() })
    }

    pub(crate) fn pin_version(&mut self, version: &Version) -> bool {
        let answered = answer(version, self.files());
        let found = answered.map(|(file, answered)| Pinned::of(file, answered));
        let is_found = found.is_ok();
        self.pinned = found.ok().or(self.pinned.take());
        is_found
    }

    /// Drops A.
    pub fn drop_pinned(&mut self) {
        self.pinned = None;
    }

    /// The text of A, and the name of its file.
    pub fn pinned_version(&self) -> Option<&Version> {
        self.pinned.as_ref().map(|pinned| &pinned.version)
    }

    /// True if A and the case in hand may change places.
    pub fn can_swap(&self) -> bool {
        let is_other =
            self.pinned_version().is_some_and(|a| (&a.name[..], &a.text[..]) != (self.name(), self.text()));
        is_other && self.fault().is_none()
    }

    /// A and the case in hand change places, as one step.
    pub fn swap(&mut self) {
        let Some(a) = self.pinned_version().filter(|_| self.can_swap()).cloned() else { return };
        self.pin();
        self.swap_to(a);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examples;

    fn texts(page: &Page) -> (&str, &str) {
        (page.pinned_version().map_or("", |a| &a.text), page.text())
    }

    /// A stays through all that is done to B, and its own text with it.
    #[test]
    fn a_stays_until_it_is_dropped() {
        let mut page = Page::default();
        let first = page.text().to_owned();
        page.set("body.height", "13").unwrap();
        page.undo();
        page.pin();
        page.set("body.width", "17.6").unwrap();
        assert_eq!(texts(&page).0, first);
        assert!(page.text().contains("17.6"));
        page.undo();
        page.undo();
        page.redo();
        page.open("x.toml", "[body]\nwidht = 1\n");
        assert!(page.fault().is_some() && !page.can_swap());
        page.swap();
        assert_eq!(texts(&page), (first.as_str(), "[body]\nwidht = 1\n"));
        let other = examples::find("goda-2000").unwrap();
        page.open("goda.toml", other.text);
        assert_eq!(texts(&page), (first.as_str(), other.text));
        page.drop_pinned();
        assert!(page.pinned_version().is_none());
        assert!(!page.pin_text("x.toml", "[body]\nwidht = 1\n") && page.pinned_version().is_none());
        assert!(page.pin_text("x.toml", &first));
        assert!(!page.pin_text("y.toml", "nothing") && texts(&page).0 == first);
    }

    /// Undo and redo go through a swap, and lose neither case.
    #[test]
    fn a_swap_is_one_step() {
        let mut page = Page::default();
        let a = page.text().to_owned();
        page.pin();
        page.swap();
        assert!(!page.can_undo(), "both are the same");
        page.set("body.width", "17.6").unwrap();
        let b = page.text().to_owned();
        page.swap();
        assert_eq!(texts(&page), (b.as_str(), a.as_str()));
        page.set("body.width", "20").unwrap();
        page.undo();
        page.undo();
        assert_eq!(texts(&page), (a.as_str(), b.as_str()));
        page.redo();
        assert_eq!(texts(&page), (b.as_str(), a.as_str()));
        page.undo();
        page.undo();
        assert_eq!(texts(&page), (a.as_str(), a.as_str()));
        page.redo();
        page.redo();
        // Another A is not lost to the undo of a swap before it.
        page.set("body.width", "21").unwrap();
        page.pin();
        let c = page.text().to_owned();
        page.undo();
        page.undo();
        assert_eq!(texts(&page), (c.as_str(), b.as_str()));
    }
}
