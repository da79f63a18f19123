//! A boundary as a picture.

use standfast_figures::{
    FeasibleSet, Figure, SetAxis, SetColumn, SetEnd, SetStretch, feasible_set, feasible_set_on_screen,
};

use super::DesignBoundary;
use super::render::at_present;
use crate::design::{End, Quantity};
use crate::units::Dimension;

pub(super) fn draw(boundary: &DesignBoundary) -> Option<Figure> {
    with_set(boundary, feasible_set)
}

/// The picture so wide for a screen; none where the target is met, or not, throughout.
pub fn boundary_on_screen(boundary: &DesignBoundary, width: f64) -> Option<Figure> {
    with_set(boundary, |set| feasible_set_on_screen(set, width))
}

fn with_set(
    boundary: &DesignBoundary,
    draw: impl FnOnce(&FeasibleSet<'_>) -> Option<Figure>,
) -> Option<Figure> {
    let DesignBoundary { request, up, across, present, .. } = boundary;
    let (upwards, rightwards) = (Axis::of(up), Axis::of(across));
    let end = |end: &End| SetEnd { value: end.value / upwards.scale, by: end.beyond.by() };
    let columns = boundary.columns.iter().map(|column| {
        let stretches = column.stretches.iter();
        SetColumn {
            at: column.at / rightwards.scale,
            none: column.none,
            stretches: stretches
                .map(|stretch| SetStretch { from: end(&stretch.least), to: end(&stretch.greatest) })
                .collect(),
        }
    });
    let caption = format!(
        "Shaded: {}. Diamond: {}. Of {}, all {} was searched.",
        request.target.words(),
        at_present(boundary),
        up.variable.name(),
        up.range_words(),
    );
    draw(&FeasibleSet {
        title: present.case.title.as_deref().unwrap_or("Values that meet a target"),
        caption: &caption,
        across: rightwards.drawn(),
        up: upwards.drawn(),
        columns: &columns.collect::<Vec<_>>(),
    })
}

/// A quantity with the unit in which people read it.
struct Axis<'a> {
    quantity: &'a Quantity,
    unit: &'static str,
    /// Number of SI units that make one.
    scale: f64,
    /// Its meaning in a few words.
    words: String,
}

impl Axis<'_> {
    fn of(quantity: &Quantity) -> Axis<'_> {
        let (unit, scale) = quantity.variable.dimension().map_or(("", 1.0), Dimension::on_paper);
        let words = quantity.variable.id().words();
        Axis { quantity, unit, scale, words }
    }

    fn drawn(&self) -> SetAxis<'_> {
        let info = self.quantity.variable.key().info();
        let present = self.quantity.present / self.scale;
        SetAxis { words: &self.words, symbol: info.symbol, unit: self.unit, present }
    }
}
