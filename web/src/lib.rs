//! The explorer: what its page asks of the library.
//!
//! The page's state is the text of a case file. It is parsed, answered and drawn by the crates that the program is made of; nothing here
//! knows mechanics, and no sentence on an answer is made here.
//!
//! ```text
//! text ── CaseFile::read ──► Inputs ──► Answered ──► Said (JSON), drawings
//!   ▲                          ▲  └── while something is dragged, numbers vary by key
//!   └── with_number ◄──────────┴───── a field, the end of a drag
//! ```
//!
//! | question | module |
//! |---|---|
//! | Which case is it, and which were before? | `page` |
//! | What is its answer? | `answered`; as the page shows it: `said`, `text` |
//! | Which case is beside it, and what do they differ in? | `pinned`, `compared` |
//! | Which numbers can be typed or dragged, and where does a drag halt? | `numbers`, `drag`, `notches` |
//! | How do loads go with time? | `histories`; drawn by hand: `by_hand` |
//! | What is drawn? | `plane`; of a motion `time` |
//! | Which cases does the page bring along? | `examples` |
//! | What did links of the first page say? | `old_link` |
//! | Which stories does it tell? | `stories` |
//! | What takes longer than a picture, and is asked in a thread of its own? | `asked`; the sheet: `sheet`; what would help: `help`; how likely it is: `likely` |
//!
//! Everything but this file runs, and is tested, without wasm.

#![forbid(unsafe_code)]

mod answered;
mod asked;
mod by_hand;
mod compared;
mod drag;
mod examples;
mod help;
mod histories;
mod likely;
mod notches;
mod numbers;
mod old_link;
mod page;
mod pinned;
mod plane;
mod said;
mod sheet;
mod stories;
mod text;
mod time;

use standfast_cases::assess::screen::Pressures;
use standfast_figures as figures;
use wasm_bindgen::prelude::wasm_bindgen;

pub use answered::Answered;
pub use page::Page;

/// The explorer behind the page. Methods that draw return SVG; `said` returns JSON.
#[wasm_bindgen]
#[derive(Debug, Default)]
pub struct Explorer {
    page: Page,
    asked: Option<Box<dyn asked::Question>>,
}

#[wasm_bindgen]
impl Explorer {
    /// An explorer with the case that opens first.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Explorer {
        Explorer::default()
    }

    /// Everything that the page says, as JSON.
    pub fn said(&self) -> String {
        said::json(&self.page)
    }

    /// The text of the case as it stands.
    pub fn text(&self) -> String {
        self.page.text().to_owned()
    }

    /// The name of its file.
    pub fn name(&self) -> String {
        self.page.name().to_owned()
    }

    /// Takes a case file; says whether it has an answer. One that has none is shown as text, with its fault.
    pub fn open(&mut self, name: &str, text: &str) -> bool {
        self.page.open(name, text)
    }

    /// Takes a file that cases name, as a record.
    pub fn add_file(&mut self, name: &str, text: &str) {
        self.page.add_file(name, text);
    }

    /// Takes an example or a new case by its name.
    pub fn open_example(&mut self, name: &str) -> bool {
        examples::find(name).is_some_and(|example| self.page.open(&example.file(), example.text))
    }

    /// Takes a link of the first page, if it is one.
    pub fn open_old_link(&mut self, fragment: &str) -> bool {
        old_link::case(fragment).is_some_and(|text| self.page.open("link.toml", &text))
    }

    /// Takes another text of the same file; says whether it has an answer.
    pub fn edit(&mut self, text: &str) -> bool {
        self.page.edit(text)
    }

    /// Mends the text as its fault suggests.
    pub fn cure(&mut self) {
        self.page.cure();
    }

    /// Goes back to the text before.
    pub fn undo(&mut self) {
        self.page.undo();
    }

    /// Takes back what was undone.
    pub fn redo(&mut self) {
        self.page.redo();
    }

    /// Pins the case as A.
    pub fn pin(&mut self) {
        self.page.pin();
    }

    /// Pins a case file as A; says whether it has an answer.
    pub fn pin_text(&mut self, name: &str, text: &str) -> bool {
        self.page.pin_text(name, text)
    }

    /// Drops A.
    pub fn drop_pinned(&mut self) {
        self.page.drop_pinned();
    }

    /// A and the case change places, as one step.
    pub fn swap(&mut self) {
        self.page.swap();
    }

    /// The name of the file of A, and its text; empty without one.
    pub fn pinned(&self) -> Vec<String> {
        self.page.pinned_version().map_or_else(Vec::new, |a| vec![a.name.clone(), a.text.clone()])
    }

    /// Takes what was typed for a number. Returns what is wrong with it, if anything is.
    pub fn set(&mut self, key: &str, typed: &str) -> Option<String> {
        self.page.set(key, typed).err()
    }

    /// What there is to say of the last change, once, in a sentence; empty if nothing.
    pub fn told(&mut self) -> String {
        std::mem::take(&mut self.page.told)
    }

    /// Takes a number some per cent greater or less.
    pub fn step(&mut self, key: &str, percent: f64) {
        if let Err(why) = self.page.step(key, percent) {
            self.page.told = page::no_farther(why);
        }
    }

    /// The numbers that are random or may be, as JSON.
    pub fn spreads(&self) -> String {
        self.page.spreads()
    }

    /// Gives a random number another law. Returns what is wrong with that, if anything is.
    pub fn set_law(&mut self, name: &str, law: &str) -> Option<String> {
        self.page.set_law(name, law).err()
    }

    /// Gives all numbers that are certain the laws to begin from.
    pub fn take_proposed(&mut self) -> Option<String> {
        self.page.take_proposed().err()
    }

    /// Draws, force and friction by turns, over the plane last drawn, as SVG.
    pub fn draws_over(&self, draws: &[f64]) -> String {
        self.page.draws_over(draws)
    }

    /// What goes with time, or may, as JSON.
    pub fn courses(&self) -> String {
        self.page.courses()
    }

    /// Gives what goes with time another shape. Returns what is wrong with that, if anything is.
    pub fn set_history(&mut self, key: &str, shape: &str) -> Option<String> {
        self.page.set_history(key, shape).err()
    }

    /// The course of a history, of a size, as JSON; empty where there is none to draw.
    pub fn course(&mut self, key: &str, width: f64, height: f64) -> String {
        self.page.course(key, drawable(width, height))
    }

    /// Drags a point of a history drawn by hand to a place in its drawing.
    pub fn drag_corner(&mut self, key: &str, corner: usize, x: f64, y: f64) {
        self.page.drag_corner(key, corner, (x, y));
    }

    /// Moves a point of a history by shares of its drawing, as one step.
    pub fn nudge_corner(&mut self, key: &str, corner: usize, right: f64, up: f64) {
        self.page.nudge_corner(key, corner, (right, up));
    }

    /// Adds a point to a history drawn by hand, as one step.
    pub fn add_corner(&mut self, key: &str, x: f64, y: f64) {
        self.page.add_corner(key, (x, y));
    }

    /// Takes a point of a history away, as one step.
    pub fn remove_corner(&mut self, key: &str, corner: usize) {
        self.page.remove_corner(key, corner);
    }

    /// True if the body may be shaken with a file that was dropped.
    pub fn can_shake_with(&self, name: &str) -> bool {
        self.page.can_shake_with(name)
    }

    /// Shakes the body with a file that was dropped. Returns what is wrong with that, if anything is.
    pub fn shake_with(&mut self, name: &str) -> Option<String> {
        self.page.shake_with(name).err()
    }

    /// Makes the text as it stands the first: there is none to go back to.
    pub fn forget(&mut self) {
        self.page.forget();
    }

    /// The answer as the program's JSON: `assess`, or `simulate` of a case in time.
    pub fn json(&self) -> String {
        self.page.answered().json()
    }

    /// The answer as the program's text.
    pub fn report(&self) -> String {
        self.page.answered().text()
    }

    /// The section, about `width` by `height` units, with its handles, as JSON; its pressures summed or not, if a person has chosen.
    pub fn section(&mut self, width: f64, height: f64, summed: Option<bool>) -> String {
        let of = |summed: bool| if summed { Pressures::Summed } else { Pressures::Along };
        self.page.section(drawable(width, height), summed.map(of))
    }

    /// The body with its forces and accelerations; empty where the loads are not one horizontal force.
    pub fn free_body(&self, width: f64, height: f64) -> String {
        self.page.body(drawable(width, height)).map_or(String::new(), |(figure, _)| figure.svg().to_owned())
    }

    /// Pose to which its motion leads, exaggerated: pivot x, y, shift and turn in degrees; empty without a drawing.
    pub fn pose(&self, width: f64, height: f64) -> Vec<f64> {
        self.page
            .body(drawable(width, height))
            .map_or(Vec::new(), |(_, pose)| vec![pose.pivot.0, pose.pivot.1, pose.shift, pose.turn])
    }

    /// A plate of the right side, `width` by `height` units: `load`, `k-mu`, `directions` or `time`.
    pub fn plate(&mut self, which: &str, width: f64, height: f64) -> String {
        self.page.plate(which, drawable(width, height))
    }

    /// Place of the design point in the plate last drawn, as [x, y, 1 if in the plot, 1 if it goes to the side, 1 if up]; empty without one.
    pub fn point(&self) -> Vec<f64> {
        self.page.point()
    }

    /// How far down the plate last drawn is seen: of a plane of the load the words below it are left to readers who do not see; 0 of all.
    pub fn plate_bottom(&self) -> f64 {
        self.page.plate_bottom()
    }

    /// The stage of a motion, about `width` by `height` units, from the floor or from the earth, as JSON; empty of a case at rest.
    pub fn stage(&mut self, from_earth: bool, width: f64, height: f64) -> String {
        self.page.stage(from_earth, drawable(width, height))
    }

    /// Poses on the stage last drawn at even steps: x, y, degrees clockwise, shift of the ground, number of the mode.
    pub fn poses(&self) -> Vec<f32> {
        self.page.poses()
    }

    /// A moment on the stage last drawn: what is said, and lines of the drawing, as JSON.
    pub fn moment(&self, t: f64) -> String {
        self.page.moment(t)
    }

    /// Tries the motion under one more factor on its loads; true while there is more to try.
    pub fn try_strength(&mut self) -> bool {
        self.page.try_strength()
    }

    /// The strip of strengths, so wide; empty while they are not known.
    pub fn strengths(&self, width: f64) -> String {
        self.page.strengths(drawable(width, 0.0).0)
    }

    /// Left, top, right and bottom of the plot of the histories last drawn; empty of other plates.
    pub fn histories_plot(&self) -> Vec<f64> {
        self.page.histories_plot()
    }

    /// How many answers there were, this one too: a question that was asked of one is not answered for another.
    pub fn answers(&self) -> u32 {
        self.page.answers()
    }

    /// The last case that has an answer, with the files that it may name, for another explorer.
    pub fn handed_on(&self) -> String {
        asked::handed_on(&self.page)
    }

    /// Takes what another explorer hands on, and asks something of it: [`next_part`](Explorer::next_part) tells the answer.
    pub fn ask(&mut self, what: &str, handed_on: &str) {
        self.asked = asked::ask(what, handed_on);
    }

    /// The next part of the answer to what was asked, as JSON; nothing once all is told.
    pub fn next_part(&mut self) -> Option<String> {
        self.asked.as_mut()?.next_part()
    }

    /// Begins to drag.
    pub fn grab(&mut self) {
        self.page.grab();
    }

    /// Drags the design point to a place in the plate.
    pub fn drag_point(&mut self, x: f64, y: f64) {
        self.page.drag_point((x, y));
    }

    /// Drags the beginning of the arrow of a force, by its key, to a place in the section.
    pub fn drag_force(&mut self, key: &str, x: f64, y: f64) {
        self.page.drag_force(key, (x, y));
    }

    /// Drags a side of the body, by its key, to a place in the section; its density stays, or if asked its mass.
    pub fn drag_side(&mut self, key: &str, x: f64, y: f64, keeps_mass: bool) {
        self.page.drag_side(key, (x, y), keeps_mass);
    }

    /// Takes the lengths of the side that is held at which the answer changes, as JSON.
    pub fn set_notches(&mut self, json: &str) {
        self.page.set_notches(json);
    }

    /// Makes a side of the body some per cent longer, as one step.
    pub fn step_side(&mut self, key: &str, percent: f64, keeps_mass: bool) {
        self.page.step_side(key, percent, keeps_mass);
    }

    /// Beginning and end of a number's value in the text, by its key; empty where it does not stand there.
    pub fn place_of(&self, key: &str) -> Vec<u32> {
        self.page.place_of(key)
    }

    /// Moves the design point by shares of the plate's width and height, as one step.
    pub fn nudge(&mut self, right: f64, up: f64) {
        self.page.nudge((right, up));
    }

    /// Ends a drag: what was varied is written into the text.
    pub fn release(&mut self) {
        self.page.release();
    }

    /// Ends a drag, and leaves all as it was.
    pub fn let_go(&mut self) {
        self.page.let_go();
    }

    /// Zooms the plane about a place in it, or about the middle of the plot without one.
    pub fn zoom(&mut self, factor: f64, x: Option<f64>, y: Option<f64>) {
        self.page.zoom(factor, x.zip(y));
    }

    /// Moves the view by units of the plane, to the right and downwards.
    pub fn pan(&mut self, right: f64, down: f64) {
        self.page.pan((right, down));
    }

    /// Shows all of the plane again.
    pub fn reset_view(&mut self) {
        self.page.reset_view();
    }

    /// The plane in fixed colours with the design point, for a file.
    pub fn plane_on_paper(&self, which: &str, width: f64, height: f64) -> String {
        self.page.plane_on_paper(which, drawable(width, height))
    }

    /// The section in fixed colours, for a file.
    pub fn section_on_paper(&self) -> String {
        self.page.section_on_paper()
    }

    /// A drawing of the body for a handout: `to-scale`, what `begins`, or how it `moves`.
    pub fn body_on_paper(&self, which: &str) -> String {
        self.page.body_on_paper(which)
    }

    /// The curves and named points of the k–μ plane as CSV.
    pub fn curves_csv(&self) -> String {
        let Some(point) = self.page.answered().point() else { return String::new() };
        let csv = |map: &figures::Map<'_>| text::curves_csv(map, self.page.title(), &point);
        self.page.with_map((600.0, 450.0), csv).unwrap_or_default()
    }

    /// The γ–k' map of cases, with the place of the body as its last two numbers, as JSON.
    pub fn cases(&self, width: f64, height: f64) -> String {
        self.page.cases(drawable(width, height))
    }

    /// A figure of the report, by its number; empty if there is none of that number.
    pub fn report_figure(number: &str) -> String {
        let id = number.parse().ok();
        id.map_or(String::new(), |id| figures::report_figure(id).svg_on_screen())
    }

    /// Numbers and captions of the report's figures, as JSON.
    pub fn figure_list() -> String {
        let list: Vec<_> = figures::FigureId::ALL.map(|id| (id.number(), id.caption())).into();
        serde_json::to_string(&list).unwrap_or_default()
    }

    /// The shelves of examples, and the new cases, as JSON.
    pub fn examples() -> String {
        examples::json()
    }

    /// The stories, each in steps, as JSON.
    pub fn stories() -> String {
        stories::json()
    }

    /// The type that the figures are set in, as a TrueType font.
    pub fn font(italic: bool) -> Vec<u8> {
        if italic { figures::ITALIC_FONT } else { figures::UPRIGHT_FONT }.to_vec()
    }
}

/// A size that can be drawn in, near to what the page has: a window may be a pixel wide for a moment.
fn drawable(width: f64, height: f64) -> (f64, f64) {
    // Of NaN, the least.
    (width.max(LEAST.0).min(1e4), height.max(LEAST.1).min(1e4))
}

/// The least width and height of a drawing, px.
const LEAST: (f64, f64) = (200.0, 140.0);

#[cfg(test)]
mod tests {
    use super::{Explorer, examples};

    /// Every drawing of every case, in windows that are no windows.
    #[test]
    fn no_size_is_too_small_or_too_large_to_draw_in() {
        for shelf in &examples::SHELVES {
            for case in shelf.cases {
                let mut explorer = Explorer::new();
                assert!(explorer.open_example(case.name), "{}", case.name);
                for size in [-30.0, 1.0, 90.0, f64::NAN, f64::INFINITY] {
                    for (width, height) in [(size, size), (size, 400.0), (600.0, size)] {
                        println!("{}: {width} by {height}", case.name);
                        explorer.section(width, height, None);
                        explorer.free_body(width, height);
                        explorer.pose(width, height);
                        for plate in ["load", "k-mu", "directions", "time"] {
                            explorer.plate(plate, width, height);
                            explorer.plane_on_paper(plate, width, height);
                        }
                        explorer.stage(false, width, height);
                        explorer.strengths(width);
                        explorer.cases(width, height);
                        explorer.course("load[1].force", width, height);
                    }
                }
            }
        }
    }

    /// The page has the colours of the figures in both themes.
    #[test]
    fn the_page_has_the_colours_of_the_figures() {
        let style = include_str!("../page/style.css");
        let (light, dark) = style.split_once(":root[data-theme=\"dark\"]").expect("two themes");
        // Those of its own page, behind the drawings.
        for (property, on_paper, in_dark) in super::figures::colours().filter(|colour| colour.0 != "paper") {
            assert!(light.contains(&format!("--{property}: {on_paper};")), "{property}: {on_paper}");
            assert!(dark.contains(&format!("--{property}: {in_dark};")), "{property}: {in_dark}");
        }
        for mode in standfast::Mode::ALL {
            let tint = super::figures::tint_on_screen(mode);
            let property = tint.trim_start_matches("var(").split(',').next().expect("a property");
            assert!(light.contains(property) && dark.contains(property), "{property}");
        }
    }
}
