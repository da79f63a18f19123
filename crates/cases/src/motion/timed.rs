//! A case in time with its first instant: what `assess`, `design` and the sheet have of it.

use toml::de::DeTable;

use super::body::{BodyCaseError, blanked, body_cases_of, in_time, without_time};
use super::criteria::MotionCriterion;
use super::error::Wrong;
use super::history::{self, KEYS};
use super::{Follow, Followed, GivenBase, ReadFile, follow_all};
use crate::assess::{Assessment, InTime};
use crate::case::Case;
use crate::error::CaseError;
use crate::motion::BlockCase;
use crate::parse::CaseFile;

/// Ends the sentence of what is answered of the first instant.
const FOLLOWED: &str = "; the motion in time is what `standfast simulate` follows";

/// A case of a body in time: as one at the first instant, and as a motion.
pub struct Timed<'a> {
    name: String,
    text: String,
    file: &'a ReadFile<'a>,
    still: CaseFile,
    moving: CaseFile,
    note: String,
    criteria: Vec<MotionCriterion>,
}

impl<'a> Timed<'a> {
    /// The case of a text; `name` is what errors call it, and `file` reads the records it names. `None` where [`still_case`] is.
    ///
    /// # Errors
    /// If the case is none as one at the first instant, or what it says of time makes no sense.
    pub fn of(name: &str, text: &str, file: &'a ReadFile<'a>) -> Result<Option<Timed<'a>>, BodyCaseError> {
        let Some((still, note)) = still_case(name, text, file)? else { return Ok(None) };
        let still = CaseFile::parse(name, &still)?;
        let Ok(document) = DeTable::parse(text) else { return Ok(None) };
        let shown = |wrong: Wrong| BodyCaseError::Motion(wrong.in_file(name, text));
        let in_time = in_time(document.get_ref(), text).map_err(shown)?;
        let criteria = in_time.criteria.as_ref().map_or_else(|| Ok(Vec::new()), MotionCriterion::read);
        let criteria = criteria.map_err(shown)?;
        let moving = CaseFile::parse(name, &without_time(document.get_ref(), text, &in_time))?;
        let (name, text) = (name.to_owned(), text.to_owned());
        Ok(Some(Timed { name, text, file, still, moving, note, criteria }))
    }

    /// The case at the first instant: all loads at their peaks.
    pub fn still(&self) -> &CaseFile {
        &self.still
    }

    /// What of the file is no matter of time: without peaks of the base in place of its motion.
    pub(crate) fn moving(&self) -> &CaseFile {
        &self.moving
    }

    /// A sentence without its stop that says what is answered of the first instant.
    pub fn note(&self) -> &str {
        &self.note
    }

    /// The same without what follows the motion.
    pub fn first_instant(&self) -> &str {
        self.note.strip_suffix(FOLLOWED).unwrap_or(&self.note)
    }

    /// The text of the file.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The lines of the file that say how loads go with time, how the base moves, and what is asked of the motion.
    pub fn lines(&self) -> Vec<&str> {
        let pairs = self.text.lines().zip(self.moving.text().lines());
        let lines = pairs.filter(|(line, without)| line != without).map(|(line, _)| line.trim());
        lines.filter(|line| !line.is_empty()).collect()
    }

    /// What is asked of the motion.
    pub fn criteria(&self) -> &[MotionCriterion] {
        &self.criteria
    }

    /// Follows the motion in every situation, the worst first.
    ///
    /// # Errors
    /// If a load that varies has no history, or the problem is refused.
    pub fn follow(&self, follow: &Follow) -> Result<Vec<(BlockCase, Followed)>, BodyCaseError> {
        self.follow_case(&|| self.moving.case(), follow)
    }

    /// The same of another case than that of the file.
    pub(crate) fn follow_case(
        &self,
        case: &dyn Fn() -> Result<Case, CaseError>,
        follow: &Follow,
    ) -> Result<Vec<(BlockCase, Followed)>, BodyCaseError> {
        let given = GivenBase::default();
        let cases = body_cases_of(&self.name, &self.text, self.file, &given, &|_| case())?;
        Ok(follow_all(cases, follow)?)
    }

    /// The answer of the first instant with what belongs to time: the criteria of the motion, which is followed where there are some, or
    /// where it is asked for.
    ///
    /// # Errors
    /// If the mechanics refuses the case, or the motion cannot be followed.
    pub fn assess(&self, follow: Option<&Follow>) -> Result<Assessment, BodyCaseError> {
        let mut assessment = Assessment::of_file(&self.still)?;
        let motions = match follow {
            Some(follow) => self.follow(follow)?,
            None if self.criteria.is_empty() => Vec::new(),
            None => self.follow(&Follow::default())?,
        };
        assessment.in_time =
            Some(InTime { note: self.note.clone(), criteria: self.criteria.clone(), motions });
        Ok(assessment)
    }
}

/// The case of a body in time as one at the first instant, for `assess`: every load at its own value, which its history reaches where its
/// peak is 1, and the peaks of the base's acceleration as an `[earthquake]`; with a sentence that says so. `None` of a text that
/// says nothing of time, has a `[block]`, or has a `[ground]` and no `[motion]`: there histories are those of loads on an elastic base.
///
/// # Errors
/// If what is said of time makes no sense, or a record cannot be read.
pub fn still_case(
    name: &str,
    text: &str,
    file: &ReadFile<'_>,
) -> Result<Option<(String, String)>, BodyCaseError> {
    let shown = |wrong: Wrong| BodyCaseError::Motion(wrong.in_file(name, text));
    // A text that is no TOML is for `CaseFile` to refuse.
    let Ok(document) = DeTable::parse(text) else { return Ok(None) };
    let top = document.get_ref();
    if top.contains_key("block") || (top.contains_key("ground") && !top.contains_key("motion")) {
        return Ok(None);
    }
    // Nor is one whose tables are none.
    let Ok(in_time) = in_time(top, text) else { return Ok(None) };
    if in_time.taken.is_empty() {
        return Ok(None);
    }
    let mut rest = blanked(text, &[&in_time.taken[..], &in_time.asked].concat());
    let section = match &in_time.motion {
        Some(motion) => {
            motion.section("base", "[motion.base]".to_owned(), &["horizontal", "vertical"]).map_err(shown)?
        }
        None => None,
    };
    let mut peaks = Vec::new();
    for key in ["horizontal", "vertical"] {
        let Some(section) = &section else { continue };
        let history = section.section(key, format!("`{key}` of [motion.base]"), &KEYS).map_err(shown)?;
        let Some(history) = history else { continue };
        let peak = history::read(&history.measured(), file).map_err(shown)?.history.peak();
        peaks.push((key, peak));
    }
    let mut note =
        format!("the loads are taken at their own values, all at once, as if at rest until then{FOLLOWED}");
    if !peaks.is_empty() {
        if top.contains_key("earthquake") {
            let place = in_time.motion.as_ref().map_or(0..0, |motion| motion.place("base"));
            let wrong =
                Wrong::new("an [earthquake] beside [motion.base] counts the same shaking twice", place);
            return Err(shown(wrong.help("leave one of them out")));
        }
        rest += "\n[earthquake]\n";
        for (key, peak) in &peaks {
            rest += &format!("{key} = \"{peak:?} m/s2\"\n");
        }
        note = format!("the peaks of the base's acceleration act at once, as an [earthquake]; {note}");
    }
    Ok(Some((rest, note)))
}
