//! Axes of a plot: the values along its edges, where they lie on the page, and what is drawn at them.
//!
//! Every figure with values along its edges is drawn through [`Axes`]: a frame, round numbers with smaller ticks between them, the name of
//! the quantity across below, that of the one upwards above. Figures are as wide as a [`COLUMN`] or as a [`PAGE`].

use crate::margins::{self, Tab};
use crate::motion::SpectrumAxis;
use crate::number::significant;
use crate::palette::{BEHIND, INK};
use crate::plot::View;
use crate::scale::Scale;
use crate::scene::{Path, Pen, Rect, Scene};
use crate::text::Text;

/// The type size of an axis's numbers.
pub(crate) const NUMBER: f64 = 12.5;
/// Width of a figure that stands in a column of a journal.
pub(crate) const COLUMN: f64 = 480.0;
/// Width of a figure that takes a page.
pub(crate) const PAGE: f64 = 720.0;
/// Left edge of names, keys and words, and the least white at the right.
pub(crate) const LEFT: f64 = 16.0;
pub(crate) const FRAME: Pen = Pen::solid(INK, 0.9);
const TICK: Pen = Pen::solid(INK, 0.9);
/// Distance of names from a plot: below it, and above it.
const NAME_BELOW: f64 = 36.0;
const NAME_ABOVE: f64 = 12.0;
const SMALL_TICK: Pen = Pen::solid(INK, 0.6);
const GRID: Pen = Pen::solid(BEHIND, 0.35);
/// From this many decades on they are written as powers of ten.
const POWERS: f64 = 3.0;

/// The values along an edge of a plot, from its left or lower end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axis {
    /// At the left or lower end.
    pub from: f64,
    /// At the right or upper end.
    pub to: f64,
    /// True if equal steps are equal factors.
    pub logarithmic: bool,
}

/// A value on an axis, and what is written there; smaller ticks have nothing.
pub(crate) type Tick = (f64, Option<Text>);

impl Axis {
    /// Axis of equal steps between two values.
    pub(crate) const fn linear(from: f64, to: f64) -> Axis {
        Axis { from, to, logarithmic: false }
    }

    /// Position of a value along the axis: 0 at its beginning, 1 at its end.
    pub fn share(&self, value: f64) -> f64 {
        let Axis { from, to, logarithmic } = *self;
        if logarithmic { (value / from).ln() / (to / from).ln() } else { (value - from) / (to - from) }
    }

    /// The value at a share of the axis.
    pub fn value(&self, share: f64) -> f64 {
        let Axis { from, to, logarithmic } = *self;
        if logarithmic { from * (to / from).powf(share) } else { from + share * (to - from) }
    }

    /// The value, or the end of the axis that it lies beyond.
    pub(crate) fn held(&self, value: f64) -> f64 {
        value.max(self.from).min(self.to)
    }

    /// True if a value lies on the axis, but for rounding.
    pub(crate) fn shows(&self, value: f64) -> bool {
        (-1e-9..=1.0 + 1e-9).contains(&self.share(value))
    }

    fn length(&self) -> f64 {
        self.to - self.from
    }

    /// Numbers, round and at equal steps, as many as an axis of this length on the page has room for.
    pub(crate) fn scale(&self, length: f64, upright: bool) -> Scale {
        // A number of five figures takes 30 units across; with less room the axis would read as a line of text.
        let each = if upright { (length / 5.0).clamp(20.0, 38.0) } else { 52.0 };
        Scale::new(self.from, self.to, room(length, each, 12.0))
    }

    /// The decades that the axis meets, and the steps of each that lie on it: decade, step and value.
    pub(crate) fn decades<'a>(&'a self, steps: &'a [f64]) -> impl Iterator<Item = (i32, f64, f64)> + 'a {
        let all = self.first_decade()..=self.last_decade();
        let values =
            all.flat_map(|decade| steps.iter().map(move |step| (decade, *step, step * 10f64.powi(decade))));
        values.filter(|(.., value)| self.shows(*value))
    }

    pub(crate) fn first_decade(&self) -> i32 {
        self.from.log10().floor() as i32
    }

    pub(crate) fn last_decade(&self) -> i32 {
        self.to.log10().ceil() as i32
    }

    /// Round numbers, as many as an axis of this length on the page has room for, and smaller ticks between them.
    pub(crate) fn ticks(&self, length: f64, upright: bool) -> Vec<Tick> {
        if !self.logarithmic || self.to < 4.0 * self.from {
            let scale = self.scale(length, upright);
            let numbers = scale.numbers().into_iter().map(|value| (value, Some(scale.text(value))));
            return numbers.chain(scale.between().into_iter().map(|value| (value, None))).collect();
        }
        let most = room(length, if upright { 38.0 } else { 58.0 }, 9.0);
        let decades = (self.to / self.from).log10();
        let steps: &[f64] = if 3.0 * decades < most { &[1.0, 2.0, 5.0] } else { &[1.0] };
        // From the upper end down: a probability of 1 is written.
        let stride = ((decades + 1.0) / most).ceil().max(1.0) as i32;
        let ticks = self.decades(steps).map(|(decade, step, value)| {
            let written = step != 1.0 || (self.last_decade() - decade) % stride == 0;
            let markup = || match (decade, step) {
                (0, 1.0) => "1".to_owned(),
                _ if decades <= POWERS || step != 1.0 => significant(value, 3),
                _ => format!("10^{{{decade}}}").replace('-', "−"),
            };
            (value, written.then(|| Text::new(&format!("${}$", markup()), NUMBER)))
        });
        let ticks: Vec<Tick> = ticks.collect();
        let is_known = |value: f64| ticks.iter().any(|(known, _)| (known / value - 1.0).abs() < 1e-9);
        let between: &[f64] = if decades < 6.5 { &[2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0] } else { &[] };
        let between: Vec<Tick> = self
            .decades(between)
            .filter(|(.., value)| !is_known(*value))
            .map(|(.., value)| (value, None))
            .collect();
        ticks.into_iter().chain(between).collect()
    }
}

/// Count of numbers, each with so much room, along an axis of this length; at most `most`.
pub(crate) fn room(length: f64, each: f64, most: f64) -> f64 {
    // A length that was found as a difference may be short of itself by its rounding.
    (length / each + 1e-9).floor().clamp(2.0, most)
}

/// The width of the widest number, `least` if all are narrower.
pub(crate) fn widest(ticks: &[Tick], least: f64) -> f64 {
    let texts = ticks.iter().filter_map(|(_, text)| text.as_ref());
    texts.fold(least, |most: f64, text| most.max(text.width))
}

/// The ticks that carry a number.
fn written(ticks: &[Tick]) -> impl Iterator<Item = f64> + '_ {
    ticks.iter().filter(|(_, text)| text.is_some()).map(|(value, _)| *value)
}

/// Names at the arrowheads and at the origin, in markup; nothing where empty.
pub(crate) struct Names {
    pub right: &'static str,
    pub up: &'static str,
    pub origin: &'static str,
}

impl Names {
    /// The axes of the k–μ plane, as the report names them.
    pub(crate) const PLANE: Names = Names { right: "$k$", up: "$μ$", origin: "$O$" };
    /// Axes of the k–μ plane with numbers, from the origin.
    pub(crate) const NUMBERED: Names = Names { origin: "$0$", ..Names::PLANE };
    /// Axes of the k–μ plane with numbers, from elsewhere.
    pub(crate) const AWAY_FROM_ORIGIN: Names = Names { origin: "", ..Names::PLANE };
}

/// A plot's rectangle on the page, and the values along its lower and its left edge.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Axes {
    /// Its place on the page.
    pub area: Rect,
    pub across: Axis,
    pub up: Axis,
}

impl Axes {
    /// A part of the plane in a rectangle.
    pub(crate) fn of(area: Rect, view: &View) -> Axes {
        let (across, up) = view.axes();
        Axes { area, across, up }
    }

    /// A plot of two quantities of this height between numbers right of `left` and its right edge.
    pub(crate) fn beside_numbers(
        [across, up]: [Axis; 2],
        (left, right): (f64, f64),
        top: f64,
        height: f64,
    ) -> Axes {
        let x0 = left + 9.0 + widest(&up.ticks(height, true), 20.0);
        Axes { area: Rect { x0, y0: top, x1: right, y1: top + height }, across, up }
    }

    /// A quantity across a rectangle, and rows or nothing upwards.
    pub(crate) fn over(area: Rect, across: Axis) -> Axes {
        Axes { area, across, up: Axis::linear(0.0, 1.0) }
    }

    pub(crate) fn view(&self) -> View {
        View { k_min: self.across.from, k_max: self.across.to, mu_min: self.up.from, mu_max: self.up.to }
    }

    pub(crate) fn x(&self, value: f64) -> f64 {
        self.area.x0 + self.across.share(value) * (self.area.x1 - self.area.x0)
    }

    pub(crate) fn y(&self, value: f64) -> f64 {
        self.area.y1 - self.up.share(value) * (self.area.y1 - self.area.y0)
    }

    pub(crate) fn at(&self, across: f64, up: f64) -> (f64, f64) {
        (self.x(across), self.y(up))
    }

    /// Place of a pair of values; of one beyond, that at the edge.
    pub(crate) fn held(&self, across: f64, up: f64) -> (f64, f64) {
        self.at(self.across.held(across), self.up.held(up))
    }

    pub(crate) fn across_at(&self, x: f64) -> f64 {
        self.across.value((x - self.area.x0) / (self.area.x1 - self.area.x0))
    }

    pub(crate) fn up_at(&self, y: f64) -> f64 {
        self.up.value((self.area.y1 - y) / (self.area.y1 - self.area.y0))
    }

    /// True if a pair of values is within the edges.
    pub(crate) fn shows(&self, across: f64, up: f64) -> bool {
        self.view().shows(across, up)
    }

    /// dy/dx on the page of a slope of values on axes with equal steps.
    pub(crate) fn tilt(&self, slope: f64) -> f64 {
        let Rect { x0, y0, x1, y1 } = self.area;
        -slope * self.across.length() / self.up.length() * (y1 - y0) / (x1 - x0)
    }

    /// A line around.
    pub(crate) fn border(&self, scene: &mut Scene, pen: Pen) {
        scene.stroke(&Path::rectangle(&self.area), pen);
    }

    /// Lines at numbers, faint.
    pub(crate) fn grid(&self, scene: &mut Scene, [across, up]: &[Vec<Tick>; 2]) {
        let Rect { x0, y0, x1, y1 } = self.area;
        for x in written(across).map(|value| self.x(value)) {
            scene.line((x, y0), (x, y1), GRID);
        }
        for y in written(up).map(|value| self.y(value)) {
            scene.line((x0, y), (x1, y), GRID);
        }
    }

    /// Ticks across and upwards, as many as there is room for.
    pub(crate) fn ticks(&self) -> [Vec<Tick>; 2] {
        let Rect { x0, y0, x1, y1 } = self.area;
        [self.across.ticks(x1 - x0, false), self.up.ticks(y1 - y0, true)]
    }

    /// Ticks and numbers below.
    pub(crate) fn below(&self, scene: &mut Scene, ticks: &[Tick]) {
        let bottom = self.area.y1;
        for (value, number) in ticks {
            let x = self.x(*value);
            scene.line((x, bottom), (x, bottom + length(number)), TICK);
            if let Some(number) = number {
                scene.text(number, x - number.width / 2.0, bottom + 17.0, INK);
            }
        }
    }

    /// Ticks and numbers at the left.
    pub(crate) fn beside(&self, scene: &mut Scene, ticks: &[Tick]) {
        let left = self.area.x0;
        for (value, number) in ticks {
            let y = self.y(*value);
            scene.line((left - length(number), y), (left, y), TICK);
            if let Some(number) = number {
                scene.text(number, left - 7.0 - number.width, y + 4.0, INK);
            }
        }
    }

    /// A border with ticks and numbers of both axes.
    pub(crate) fn framed(&self, scene: &mut Scene, [across, up]: &[Vec<Tick>; 2]) {
        self.border(scene, FRAME);
        self.below(scene, across);
        self.beside(scene, up);
    }

    /// The name of the quantity across, in the middle below; gives the y below it.
    pub(crate) fn name_below(&self, scene: &mut Scene, name: &Text) -> f64 {
        let Rect { x0, x1, y1, .. } = self.area;
        scene.text(name, ((x0 + x1 - name.width) / 2.0).max(LEFT), y1 + NAME_BELOW, INK);
        y1 + NAME_BELOW + name.descent
    }

    /// The name of the quantity upwards, from `left` on, so much farther above than names are.
    pub(crate) fn name_above(&self, scene: &mut Scene, name: &Text, left: f64, higher: f64) {
        scene.text(name, left, self.area.y0 - NAME_ABOVE - higher, INK);
    }

    /// Lines with arrowheads, their names, and the origin.
    pub(crate) fn arrows(&self, scene: &mut Scene, names: &Names) {
        let Rect { x0, y0, x1, y1 } = self.area;
        let pen = Pen::solid(INK, 1.1);
        let (right_tip, up_tip) = ((x1 + 20.0, y1), (x0, y0 - 20.0));
        scene.line((x0, y1), (right_tip.0 - 5.0, y1), pen);
        scene.line((x0, y1), (x0, up_tip.1 + 5.0), pen);
        scene.arrowhead(right_tip, (1.0, 0.0), INK);
        scene.arrowhead(up_tip, (0.0, -1.0), INK);
        let [right, up, origin] = [names.right, names.up, names.origin].map(|letter| Text::new(letter, 15.0));
        scene.text(&right, right_tip.0 + 6.0, y1 + 4.0, INK);
        scene.text(&up, x0 - up.width - 8.0, up_tip.1 + 8.0, INK);
        let rect =
            Rect { x0: x0 - 6.0 - origin.width, x1: x0 - 6.0, y0: y1 + 5.0, y1: y1 + 5.0 + origin.height() };
        scene.text_in(&origin, &rect, INK);
    }

    /// Numbers, round, beside lines with arrowheads, and smaller ticks between them. Returns the y below.
    pub(crate) fn round_numbers(&self, scene: &mut Scene) -> f64 {
        let Rect { x0, y0, x1, y1 } = self.area;
        let [across, up] = [self.across.scale(x1 - x0, false), self.up.scale(y1 - y0, true)];
        for x in across.between().into_iter().map(|value| self.x(value)) {
            scene.line((x, y1), (x, y1 + 2.2), SMALL_TICK);
        }
        for y in up.between().into_iter().map(|value| self.y(value)) {
            scene.line((x0 - 2.2, y), (x0, y), SMALL_TICK);
        }
        // The origin has one zero for both axes; a number at the very top would run into the name of the axis.
        let is_origin = |value: f64| self.view().is_from_origin() && value == 0.0;
        let tabs = |scale: &Scale, place: &dyn Fn(f64) -> f64, highest: f64| -> Vec<Tab> {
            let shown = scale.numbers().into_iter().filter(|value| !is_origin(*value));
            let tabs = shown.map(|value| Tab { at: place(value), text: scale.text(value) });
            tabs.filter(|tab| tab.at > highest).collect()
        };
        let below = || tabs(&across, &|value| self.x(value), f64::NEG_INFINITY);
        margins::beside_mu_axis(scene, self, tabs(&up, &|value| self.y(value), y0 + 6.0));
        margins::under_k_axis(scene, self, below(), below()).0
    }
}

/// The length of a tick.
fn length(number: &Option<Text>) -> f64 {
    if number.is_some() { 4.0 } else { 2.2 }
}

/// A framed plot of two named quantities.
pub(crate) struct Plot {
    pub axes: Axes,
    pub ticks: [Vec<Tick>; 2],
    names: [Text; 2],
    left: f64,
}

/// Name of a quantity as it stands at an axis: with a capital.
pub(crate) fn named(words: &str) -> String {
    let mut letters = words.chars();
    match letters.next() {
        Some(first) if first.is_lowercase() && letters.clone().next().is_some_and(char::is_alphabetic) => {
            first.to_uppercase().chain(letters).collect()
        }
        _ => words.to_owned(),
    }
}

impl Plot {
    /// Quantities across and upwards, with the numbers of the latter between `left` and the plot, which ends at `right`.
    pub(crate) fn new(
        quantities: [&SpectrumAxis<'_>; 2],
        (left, right): (f64, f64),
        top: f64,
        height: f64,
    ) -> Plot {
        let axes = Axes::beside_numbers(quantities.map(SpectrumAxis::axis), (left, right), top, height);
        let names = quantities.map(|axis| Text::inline(&named(axis.name), NUMBER));
        Plot { axes, ticks: axes.ticks(), names, left }
    }

    /// Draws the frame with its numbers and names, the upper one so much higher; gives the y below.
    pub(crate) fn draw(&self, scene: &mut Scene, higher: f64) -> f64 {
        self.axes.framed(scene, &self.ticks);
        self.axes.name_above(scene, &self.names[1], self.left, higher);
        self.axes.name_below(scene, &self.names[0])
    }

    /// Its names as plain characters.
    pub(crate) fn names(&self) -> [&str; 2] {
        [&self.names[0].plain, &self.names[1].plain]
    }

    /// Description for readers who do not see it.
    pub(crate) fn description(&self) -> String {
        let [across, up] = self.names();
        format!("Chart of {up}, upwards, over {across}, to the right.")
    }
}

/// Numbers along an axis that is drawn by another tool.
#[derive(Debug, Clone, PartialEq)]
pub struct AxisNumbers {
    /// Round numbers, rising, each with its text as markup.
    pub numbers: Vec<(f64, String)>,
    /// The places of smaller ticks between them.
    pub between: Vec<f64>,
}

/// The round numbers between `from` and the greater `to` along an axis that is `length` times as long as its type is
/// large: those that figures of this crate have there. An upright axis has room for more of them than one across.
///
/// ```
/// let axis = standfast_figures::axis_numbers(0.0, 1.43, 36.0, false);
/// assert_eq!(axis.numbers[1], (0.2, "$0.2$".to_owned()));
/// assert_eq!(axis.between[0], 0.05);
/// ```
pub fn axis_numbers(from: f64, to: f64, length: f64, upright: bool) -> AxisNumbers {
    let scale = Axis::linear(from, to).scale(length * NUMBER, upright);
    let numbers = scale.numbers().into_iter().map(|number| (number, scale.markup(number)));
    AxisNumbers { numbers: numbers.collect(), between: scale.between() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(from: f64, to: f64, logarithmic: bool, length: f64) -> Vec<String> {
        let ticks = Axis { from, to, logarithmic }.ticks(length, true);
        ticks.into_iter().filter_map(|(_, text)| text).map(|text| text.plain).collect()
    }

    /// Equal steps have round numbers; equal factors have powers of ten, the upper end among them.
    #[test]
    fn axes_have_round_numbers() {
        assert_eq!(texts(0.0, 1.0, false, 200.0), ["0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(texts(0.01, 1.0, true, 310.0), ["0.01", "0.02", "0.05", "0.1", "0.2", "0.5", "1"]);
        let far = texts(1e-12, 1.0, true, 270.0);
        assert_eq!(far.len(), 7, "{far:?}");
        assert_eq!((far[0].as_str(), far[6].as_str()), ("10^−12", "1"));
    }

    /// Values beyond an axis are at its end, and no logarithm of zero is taken.
    #[test]
    fn values_beyond_an_axis_are_at_its_end() {
        let axis = Axis { from: 1e-3, to: 1.0, logarithmic: true };
        assert_eq!([0.0, 1e-9, 2.0].map(|value| axis.share(axis.held(value))), [0.0, 0.0, 1.0]);
        assert!(!axis.shows(0.0) && axis.shows(1.0) && !axis.shows(1.1));
    }

    #[test]
    fn the_page_and_the_plane_map_onto_each_other() {
        let area = Rect { x0: 50.0, y0: 20.0, x1: 450.0, y1: 340.0 };
        let axes = Axes::of(area, &View::from_origin(4.0, 2.0));
        assert_eq!(axes.at(0.0, 0.0), (50.0, 340.0));
        assert_eq!(axes.at(4.0, 2.0), (450.0, 20.0));
        assert!((axes.across_at(axes.x(1.7)) - 1.7).abs() < 1e-12);
        assert!((axes.up_at(axes.y(0.3)) - 0.3).abs() < 1e-12);
    }
}
