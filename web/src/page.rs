//! The state of the page: the text of a case, those before it, and the answer to the last that has one.

use std::collections::BTreeMap;

use standfast_cases::motion::FollowedMotion;
use standfast_cases::{Case, CaseError, CaseFile, Inputs};
use standfast_figures::View;

use crate::answered::Answered;
use crate::drag::Held;
use crate::examples;
use crate::pinned::Pinned;
use crate::plane::Drawn;

/// So many texts are kept to go back to.
const KEPT: usize = 200;

/// A text that stood in the page, with the name of its file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Version {
    /// The name of the file.
    pub name: String,
    /// Its text.
    pub text: String,
}

/// A text that may be gone back or forward to.
#[derive(Debug)]
struct Step {
    version: Version,
    /// True if between it and the text that stands A and B changed places.
    swaps: bool,
}

/// The state of the page.
#[derive(Debug)]
pub struct Page {
    now: Version,
    past: Vec<Step>,
    future: Vec<Step>,
    /// Files that cases name, by their own names.
    files: BTreeMap<String, String>,
    /// The last text that has an answer, and the answer.
    file: CaseFile,
    answered: Answered,
    fault: Option<CaseError>,
    /// How many answers there were, this one too.
    answers: u32,
    /// A, if a case is pinned.
    pub(crate) pinned: Option<Pinned>,
    /// What is dragged.
    pub(crate) held: Option<Held>,
    /// The part of the k–μ plane shown; without one, what shows all.
    pub(crate) view: Option<View>,
    pub(crate) drawn: Drawn,
    /// What there is to say of the last change: what went with it, or why it ended where it did.
    pub(crate) told: String,
}

impl Default for Page {
    fn default() -> Page {
        let first = examples::first();
        let now = Version { name: first.file(), text: first.text.to_owned() };
        let files = BTreeMap::new();
        let (file, answered) = answer(&now, &files).expect("the first example has an answer");
        Page {
            now,
            past: Vec::new(),
            future: Vec::new(),
            files,
            file,
            answered,
            fault: None,
            answers: 1,
            pinned: None,
            held: None,
            view: None,
            drawn: Drawn::default(),
            told: String::new(),
        }
    }
}

/// The case of a text, with the files that it names.
pub(crate) fn read(version: &Version, files: &BTreeMap<String, String>) -> Result<CaseFile, CaseError> {
    let of_name = |path: &str| {
        // From whatever folder: the page has names alone.
        let name = path.rsplit(['/', '\\']).next().unwrap_or(path);
        let own = files.get(name).map(String::as_str);
        own.or_else(|| examples::record(name)).map(str::to_owned).ok_or_else(|| NOT_DROPPED.to_owned())
    };
    CaseFile::read(&version.name, &version.text, &of_name)
}

/// The case of a text with its answer.
pub(crate) fn answer(
    version: &Version,
    files: &BTreeMap<String, String>,
) -> Result<(CaseFile, Answered), CaseError> {
    let file = read(version, files)?;
    let answered = Answered::of(&file)?;
    Ok((file, answered))
}

/// Reason why a file that a case names is not read.
const NOT_DROPPED: &str = "the page does not have it; open or drop it here";

impl Page {
    /// The text as it stands, with its faults.
    pub fn text(&self) -> &str {
        &self.now.text
    }

    /// The name of its file.
    pub fn name(&self) -> &str {
        &self.now.name
    }

    /// Title of the case that is shown, or the name of its file.
    pub fn title(&self) -> &str {
        let rest = self.answered().rest.as_ref();
        rest.and_then(|rest| rest.case.title.as_deref()).unwrap_or_else(|| self.file.name())
    }

    /// The case of the last text that has an answer.
    pub fn file(&self) -> &CaseFile {
        self.held.as_ref().map_or(&self.file, |held| &held.file)
    }

    /// The last text that has an answer, without what is dragged.
    pub fn settled(&self) -> &CaseFile {
        &self.file
    }

    /// The answer that is shown.
    pub fn answered(&self) -> &Answered {
        self.held.as_ref().map_or(&self.answered, |held| &held.answered)
    }

    /// The case of the last text that has an answer, at rest.
    pub(crate) fn settled_case(&self) -> Option<&Case> {
        self.answered.rest.as_ref().map(|rest| &rest.case)
    }

    /// Its answer.
    pub(crate) fn settled_answer(&self) -> &Answered {
        &self.answered
    }

    /// A motion of the last text that has an answer, by its place from the worst on.
    pub(crate) fn settled_motion(&mut self, place: usize) -> Option<&mut FollowedMotion> {
        self.answered.motions.get_mut(place)
    }

    /// How many answers there were, this one too.
    pub fn answers(&self) -> u32 {
        self.answers
    }

    /// The files that were taken for cases that name them, by their names.
    pub fn files(&self) -> &BTreeMap<String, String> {
        &self.files
    }

    /// Fault of the text, if it has one.
    pub fn fault(&self) -> Option<&CaseError> {
        self.fault.as_ref()
    }

    /// True if there is a text to go back to.
    pub fn can_undo(&self) -> bool {
        !self.past.is_empty()
    }

    /// True if something undone can be taken back.
    pub fn can_redo(&self) -> bool {
        !self.future.is_empty()
    }

    /// Takes a case file; true if it has an answer.
    pub fn open(&mut self, name: &str, text: &str) -> bool {
        self.view = None;
        self.step_to(Version { name: name.to_owned(), text: text.to_owned() })
    }

    /// Takes a file that cases name. A case that waits for it is read again, and so is the one that is pinned.
    pub fn add_file(&mut self, name: &str, text: &str) {
        self.files.insert(name.to_owned(), text.to_owned());
        if let Some(version) = self.pinned_version().cloned() {
            self.pin_version(&version);
        }
        self.settle();
    }

    /// Takes another text of the same file; true if it has an answer.
    pub fn edit(&mut self, text: &str) -> bool {
        let name = self.now.name.clone();
        self.step_to(Version { name, text: text.to_owned() })
    }

    /// Mends the text as its fault suggests.
    pub fn cure(&mut self) {
        if let Some(cure) = self.fault.as_ref().and_then(CaseError::cure) {
            let text = cure.applied(&self.now.text);
            self.edit(&text);
        }
    }

    /// Goes back to the text before.
    pub fn undo(&mut self) {
        if let Some(Step { version, swaps }) = self.past.pop() {
            let version = self.leave_for(version, swaps);
            self.future.push(Step { version, swaps });
            self.settle();
        }
    }

    /// Takes back what was undone.
    pub fn redo(&mut self) {
        if let Some(Step { version, swaps }) = self.future.pop() {
            let version = self.leave_for(version, swaps);
            self.past.push(Step { version, swaps });
            self.settle();
        }
    }

    /// Takes the text of another step, and gives the one that stood; where A and B change places between both, that is pinned, unless another
    /// case was in the meantime.
    fn leave_for(&mut self, version: Version, swaps: bool) -> Version {
        let left = std::mem::replace(&mut self.now, version);
        if swaps && self.pinned_version() == Some(&self.now) {
            self.pin_version(&left);
        }
        left
    }

    /// Makes the text as it stands the first.
    pub fn forget(&mut self) {
        self.past.clear();
        self.future.clear();
    }

    /// Takes the text of A, after B was pinned in its place.
    pub(crate) fn swap_to(&mut self, a: Version) {
        self.take_step(a, true);
    }

    fn step_to(&mut self, next: Version) -> bool {
        self.take_step(next, false)
    }

    fn take_step(&mut self, next: Version, swaps: bool) -> bool {
        if next != self.now {
            let version = std::mem::replace(&mut self.now, next);
            self.past.push(Step { version, swaps });
            self.future.clear();
            if self.past.len() > KEPT {
                self.past.remove(0);
            }
        }
        self.settle()
    }

    /// Reads the text that stands; true if it has an answer.
    fn settle(&mut self) -> bool {
        self.held = None;
        self.drawn.trying = (0, Vec::new());
        match answer(&self.now, &self.files) {
            Ok((file, answered)) => {
                (self.file, self.answered, self.fault) = (file, answered, None);
                self.answers += 1;
                true
            }
            Err(error) => {
                self.fault = Some(error);
                false
            }
        }
    }

    /// Takes a text made of the last that has an answer, if it has one itself.
    ///
    /// # Errors
    /// What is wrong with it.
    pub(crate) fn take(&mut self, text: String) -> Result<(), String> {
        let name = self.file.name().to_owned();
        let next = Version { name, text };
        answer(&next, &self.files).map_err(|error| error.to_string())?;
        self.step_to(next);
        Ok(())
    }

    /// Begins to vary numbers.
    pub fn grab(&mut self) {
        self.held = Some(Held::of(&self.file, &self.answered, &self.drawn));
        self.hold_view();
    }

    /// Varies numbers of what is held; what has no answer leaves all as it was.
    pub(crate) fn vary(&mut self, change: impl FnOnce(&mut Inputs)) {
        let Some(held) = &mut self.held else { return };
        let mut inputs = held.file.inputs().clone();
        change(&mut inputs);
        let file = held.file.varied(inputs);
        held.refused = match Answered::varied(&file) {
            Ok(answered) => {
                (held.file, held.answered) = (file, answered);
                None
            }
            Err(error) => Some(error),
        };
    }

    /// Ends a drag: what was varied is written into the text.
    pub fn release(&mut self) {
        let Some(held) = self.held.take() else { return };
        if held.view_was_free {
            self.view = None;
        }
        if let Some(error) = &held.refused {
            self.told = no_farther(error);
        }
        let text = held.written(&self.file);
        if text != self.file.text() {
            // Numbers that had an answer while they varied have it when they are read.
            let _ = self.take(text);
        }
    }

    /// Ends a drag, and leaves all as it was.
    pub fn let_go(&mut self) {
        if self.held.take().is_some_and(|held| held.view_was_free) {
            self.view = None;
        }
    }
}

/// Says why a number was not taken that a hand or a key moved.
pub(crate) fn no_farther(why: impl std::fmt::Display) -> String {
    format!("No farther: {why}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_are_undone_and_taken_back() {
        let mut page = Page::default();
        let first = page.text().to_owned();
        assert!(!page.can_undo());
        page.set("body.width", "20 m").unwrap();
        let wide = page.text().to_owned();
        page.set("load[1].force", "1 000").unwrap();
        assert_eq!(page.text(), wide.replace("2700 kN/m", "1000 kN/m"));
        page.undo();
        assert_eq!(page.text(), wide);
        page.undo();
        assert_eq!((page.text(), page.can_undo(), page.can_redo()), (first.as_str(), false, true));
        page.redo();
        assert_eq!(page.text(), wide);
        page.set("body.height", "13").unwrap();
        assert!(!page.can_redo(), "another way was taken");
        for i in 0..300 {
            page.set("body.height", &format!("{}", 13.5 + f64::from(i) / 100.0)).unwrap();
        }
        assert_eq!(page.past.len(), KEPT);
    }

    #[test]
    fn a_faulty_text_stays_and_the_answer_before_it_too() {
        let mut page = Page::default();
        let before = page.answered().json();
        assert!(!page.open("x.toml", "[body]\nwidht = 1\n"));
        assert_eq!((page.name(), page.text()), ("x.toml", "[body]\nwidht = 1\n"));
        assert_eq!(page.fault().unwrap().to_string(), "[body] has no key `widht`");
        assert_eq!(page.answered().json(), before);
        page.cure();
        assert_eq!(page.text(), "[body]\nwidth = 1\n");
        assert!(page.fault().is_some(), "it lacks all else");
        page.undo();
        page.undo();
        assert!(page.fault().is_none());
    }

    /// A key that is missing is added where it belongs.
    #[test]
    fn a_missing_key_is_added_by_its_cure() {
        let mut page = Page::default();
        let text = page.text().replace("friction = 0.6\n", "");
        assert!(!page.edit(&text));
        page.cure();
        assert_eq!(page.fault().map(ToString::to_string), None);
        assert!(page.text().contains("[body]\nfriction = 0.6\n"), "{}", page.text());
    }

    #[test]
    fn a_record_is_found_by_its_name_once_it_is_dropped() {
        let mut page = Page::default();
        let text = "[block]\nb1 = 1\nb2 = 1\nd = 3\nmu_s = 0.6\ngravity = 1\n[motion.base]\n\
                    horizontal = { shape = \"file\", file = \"any/where/shake.csv\" }\n";
        assert!(!page.open("block.toml", text));
        assert_eq!(
            page.fault().unwrap().to_string(),
            "cannot read any/where/shake.csv: the page does not have it; open or drop it here"
        );
        page.add_file("shake.csv", "t,a\n0,0\n1,0.5\n2,0\n");
        assert_eq!(page.fault().map(ToString::to_string), None);
        assert!(page.answered().is_in_time());
    }
}
