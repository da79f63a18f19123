//! The report's 26 figures.

mod above;
mod below;
mod sketch;

use std::fmt;
use std::str::FromStr;

use standfast::Diagram;
use standfast::diagram::Window;

use crate::Figure;
use crate::drawing::Drawing;
use crate::number;
use crate::plot::View;
use crate::scene::Scene;
use crate::sheet::Sheet;

/// The number of a figure of the report.
///
/// ```
/// use standfast_figures::FigureId;
///
/// let id: FigureId = "3.3a".parse()?;
/// assert_eq!(id.to_string(), "3.3a");
/// assert_eq!(FigureId::ALL.len(), 26);
/// # Ok::<(), standfast_figures::UnknownFigure>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct FigureId(u8);

/// There is no figure of this number.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("the report has no figure {text:?}; it has {}", FigureId::list())]
pub struct UnknownFigure {
    /// Name that was asked for.
    pub text: String,
}

/// A body and its window.
#[derive(Debug, Clone, Copy)]
struct Sample {
    slenderness: f64,
    elevation: f64,
}

/// Content of a figure of the report.
enum Content {
    /// A sketch of the block; whether the force is above the centre.
    Sketch {
        above: bool,
    },
    Chart {
        sheet: Sheet,
        sample: Sample,
        k: f64,
        mu: f64,
    },
}

/// One row of the table of figures.
struct Entry {
    number: &'static str,
    /// In markup.
    caption: &'static str,
    content: Content,
}

/// Short for the tables.
const fn entry(
    number: &'static str,
    caption: &'static str,
    sheet: Sheet,
    sample: Sample,
    (k, mu): (f64, f64),
) -> Entry {
    Entry { number, caption, content: Content::Chart { sheet, sample, k, mu } }
}

impl FigureId {
    /// All figures, in the report's order.
    pub const ALL: [FigureId; 26] = {
        let mut all = [FigureId(0); 26];
        let mut i = 0;
        while i < all.len() {
            all[i] = FigureId(i as u8);
            i += 1;
        }
        all
    };

    /// The body the figure is drawn for, (γ, k'); `None` for a sketch.
    pub fn body(self) -> Option<(f64, f64)> {
        chart(self).map(|(_, body, _)| body)
    }

    /// The figure's caption in plain characters.
    pub fn caption(self) -> String {
        crate::text::Text::inline(self.entry().caption, 13.0).plain
    }

    /// The figure's number as the report prints it, e.g. `3.3a`.
    pub fn number(self) -> &'static str {
        self.entry().number
    }

    fn entry(self) -> &'static Entry {
        let i = usize::from(self.0);
        let above = above::FIGURES.len();
        if i < above { &above::FIGURES[i] } else { &below::FIGURES[i - above] }
    }

    fn list() -> String {
        FigureId::ALL.map(FigureId::number).join(", ")
    }
}

impl fmt::Display for FigureId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.number())
    }
}

impl FromStr for FigureId {
    type Err = UnknownFigure;

    /// Reads a number such as `3.3a`.
    fn from_str(text: &str) -> Result<FigureId, UnknownFigure> {
        let found = FigureId::ALL.into_iter().find(|id| id.number() == text.trim());
        found.ok_or_else(|| UnknownFigure { text: text.into() })
    }
}

/// A figure of the report, its curves drawn to true scale for a body that shows every feature.
pub fn report_figure(id: FigureId) -> Figure {
    let entry = id.entry();
    let heading = format!("Fig. {} ", entry.number);
    match &entry.content {
        Content::Sketch { above } => sketch::figure(&heading, entry.caption, *above, Scene::default()),
        Content::Chart { sheet, sample, k, mu } => {
            let diagram =
                Diagram::new(sample.slenderness, sample.elevation).expect("the table's bodies are valid");
            Drawing {
                diagram: &diagram,
                sheet,
                window: View::from_origin(*k, *mu),
                heading: &heading,
                caption: entry.caption,
                preface: &format!("{}:", number::body(diagram.chart())),
                points: &[],
                cloud: &[],
                pinned: None,
                hatched: &[],
                numbered: false,
            }
            .figure()
        }
    }
}

/// A sketch of the report for a screen; `None` for a chart.
pub fn sketch_on_screen(id: FigureId) -> Option<Figure> {
    let entry = id.entry();
    match entry.content {
        Content::Sketch { above } => {
            Some(sketch::figure(&format!("Fig. {} ", entry.number), entry.caption, above, Scene::themed()))
        }
        Content::Chart { .. } => None,
    }
}

/// The sheet of a chart, its body (γ, k') and its window; `None` for a sketch.
pub(crate) fn chart(id: FigureId) -> Option<(&'static Sheet, (f64, f64), Window)> {
    match &id.entry().content {
        Content::Sketch { .. } => None,
        Content::Chart { sheet, sample, k, mu } => {
            Some((sheet, (sample.slenderness, sample.elevation), Window { k: *k, mu: *mu }))
        }
    }
}

/// The caption in markup.
pub(crate) fn caption(id: FigureId) -> &'static str {
    id.entry().caption
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tables_hold_all_figures() {
        assert_eq!(above::FIGURES.len() + below::FIGURES.len(), FigureId::ALL.len());
    }
}
