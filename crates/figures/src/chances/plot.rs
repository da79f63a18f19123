//! A plot on the page: its axes, with equal steps or equal factors, and what stands along them.

use crate::margins::{self, NUMBER};
use crate::motion::SpectrumAxis;
use crate::number::significant;
use crate::palette::{BEHIND, INK};
use crate::scale::Scale;
use crate::scene::{Path, Pen, Rect, Scene};
use crate::screen::Axis;
use crate::text::Text;

/// From this many decades on they are written as powers of ten.
const POWERS: f64 = 3.0;

/// A quantity along an axis.
#[derive(Debug, Clone, Copy)]
pub(super) struct Edge {
    axis: Axis,
}

/// A place on an axis, and what is written there; smaller ticks have nothing.
pub(super) type Tick = (f64, Option<Text>);

impl Edge {
    pub(super) fn of(axis: &SpectrumAxis<'_>) -> Edge {
        let SpectrumAxis { from, to, logarithmic, .. } = *axis;
        Edge { axis: Axis { from, to, logarithmic } }
    }

    /// Position of a value along the axis, 0 to 1; one beyond is put at its end.
    pub(super) fn share(&self, value: f64) -> f64 {
        if self.axis.logarithmic && value <= 0.0 {
            return 0.0;
        }
        self.axis.share(value).clamp(0.0, 1.0)
    }

    /// True if a value lies on the axis.
    pub(super) fn shows(&self, value: f64) -> bool {
        (!self.axis.logarithmic || value > 0.0) && (-1e-9..=1.0 + 1e-9).contains(&self.axis.share(value))
    }

    /// At most about `most` numbers.
    pub(super) fn ticks(&self, most: f64) -> Vec<Tick> {
        let Axis { from, to, logarithmic } = self.axis;
        if !logarithmic || to < 4.0 * from {
            let scale = Scale::new(from, to, most);
            let numbers = scale.numbers().into_iter();
            return numbers.map(|value| (value, Some(margins::number(&scale, value)))).collect();
        }
        let decades = (to / from).log10();
        let (first, last) = (from.log10().floor() as i32, to.log10().ceil() as i32);
        let steps: &[f64] = if 3.0 * decades < most { &[1.0, 2.0, 5.0] } else { &[1.0] };
        // From the upper end down: a probability of 1 is written.
        let stride = ((decades + 1.0) / most).ceil().max(1.0) as i32;
        let mut ticks = Vec::new();
        for decade in first..=last {
            for (i, step) in steps.iter().enumerate() {
                let value = step * 10f64.powi(decade);
                if !self.shows(value) {
                    continue;
                }
                let written = i > 0 || (last - decade) % stride == 0;
                ticks.push((
                    value,
                    written.then(|| Text::new(&format!("${}$", power(decade, *step, decades)), NUMBER)),
                ));
            }
        }
        ticks
    }
}

/// A step of a decade in markup.
fn power(decade: i32, step: f64, decades: f64) -> String {
    match (decade, step) {
        (0, 1.0) => "1".to_owned(),
        _ if decades <= POWERS || step != 1.0 => significant(step * 10f64.powi(decade), 3),
        _ => format!("10^{{{decade}}}").replace('-', "−"),
    }
}

/// A plot.
pub(super) struct Plot {
    pub(super) area: Rect,
    pub(super) across: Edge,
    pub(super) up: Edge,
}

impl Plot {
    pub(super) fn x(&self, value: f64) -> f64 {
        self.area.x0 + self.across.share(value) * (self.area.x1 - self.area.x0)
    }

    pub(super) fn y(&self, value: f64) -> f64 {
        self.area.y1 - self.up.share(value) * (self.area.y1 - self.area.y0)
    }

    /// Faint lines at the numbers.
    pub(super) fn grid(&self, scene: &mut Scene) {
        let Rect { x0, y0, x1, y1 } = self.area;
        let pen = Pen { colour: BEHIND, width: 0.35, dashes: "" };
        across_ticks(&self.across, x1 - x0).iter().filter(|(_, text)| text.is_some()).for_each(
            |(value, _)| {
                scene.line((self.x(*value), y0), (self.x(*value), y1), pen);
            },
        );
        up_ticks(&self.up, y1 - y0).iter().filter(|(_, text)| text.is_some()).for_each(|(value, _)| {
            scene.line((x0, self.y(*value)), (x1, self.y(*value)), pen);
        });
    }

    /// The frame and the numbers; returns the y below the numbers.
    pub(super) fn draw(&self, scene: &mut Scene) -> f64 {
        let Rect { x0, x1, y0, y1 } = self.area;
        scene.stroke(&Path::rectangle(&self.area), Pen::solid(INK, 0.9));
        below(scene, &self.across, (x0, x1), y1);
        for (value, number) in up_ticks(&self.up, y1 - y0) {
            let (y, length) = (self.y(value), if number.is_some() { 4.0 } else { 2.2 });
            scene.line((x0 - length, y), (x0, y), Pen::solid(INK, 0.8));
            if let Some(number) = number {
                scene.text(&number, x0 - 7.0 - number.width, y + 4.0, INK);
            }
        }
        y1 + 22.0
    }
}

/// Ticks and numbers below a line at `y` that an axis has between two places.
pub(super) fn below(scene: &mut Scene, edge: &Edge, (x0, x1): (f64, f64), y: f64) {
    for (value, number) in across_ticks(edge, x1 - x0) {
        let x = x0 + edge.share(value) * (x1 - x0);
        scene.line((x, y), (x, y + if number.is_some() { 4.0 } else { 2.2 }), Pen::solid(INK, 0.8));
        if let Some(number) = number {
            scene.text(&number, x - number.width / 2.0, y + 18.0, INK);
        }
    }
}

pub(super) fn across_ticks(edge: &Edge, length: f64) -> Vec<Tick> {
    edge.ticks((length / 58.0).floor().clamp(2.0, 9.0))
}

pub(super) fn up_ticks(edge: &Edge, length: f64) -> Vec<Tick> {
    edge.ticks((length / 38.0).floor().clamp(2.0, 8.0))
}

/// The width of the numbers of an upright axis.
pub(super) fn up_width(edge: &Edge, length: f64) -> f64 {
    let texts = up_ticks(edge, length).into_iter().filter_map(|(_, text)| text);
    texts.fold(20.0, |most: f64, text| most.max(text.width))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(from: f64, to: f64, logarithmic: bool, most: f64) -> Vec<String> {
        let axis = SpectrumAxis { name: "", from, to, logarithmic };
        let ticks = Edge::of(&axis).ticks(most);
        ticks.into_iter().filter_map(|(_, text)| text).map(|text| text.plain).collect()
    }

    /// Equal steps have round numbers; equal factors have powers of ten, the upper end among them.
    #[test]
    fn axes_have_round_numbers() {
        assert_eq!(written(0.0, 1.0, false, 5.0), ["0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(written(0.01, 1.0, true, 8.0), ["0.01", "0.02", "0.05", "0.1", "0.2", "0.5", "1"]);
        let far = written(1e-12, 1.0, true, 7.0);
        assert_eq!(far.len(), 7, "{far:?}");
        assert_eq!((far[0].as_str(), far[6].as_str()), ("10^−12", "1"));
    }

    /// Values beyond an axis are at its end, and no logarithm of zero is taken.
    #[test]
    fn values_beyond_an_axis_are_at_its_end() {
        let axis = SpectrumAxis { name: "", from: 1e-3, to: 1.0, logarithmic: true };
        let edge = Edge::of(&axis);
        assert_eq!([0.0, 1e-9, 2.0].map(|value| edge.share(value)), [0.0, 0.0, 1.0]);
        assert!(!edge.shows(0.0) && edge.shows(1.0) && !edge.shows(1.1));
    }
}
