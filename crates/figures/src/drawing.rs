//! Content of a chart, for the chart itself and for the words about it.

use standfast::Diagram;
use standfast::diagram::Unresolved;

use crate::DesignPoint;
use crate::pinned::PinnedDiagram;
use crate::plot::View;
use crate::sheet::Sheet;

/// Content of one chart.
pub(crate) struct Drawing<'a> {
    pub diagram: &'a Diagram,
    pub sheet: &'a Sheet,
    pub window: View,
    /// Opens the caption and the title; a space at its end parts it from the caption on the page.
    pub heading: &'a str,
    /// The caption in markup.
    pub caption: &'a str,
    /// Opens the list of coordinates, in markup; may be empty.
    pub preface: &'a str,
    pub points: &'a [DesignPoint],
    /// Points without names, as (k, μ).
    pub cloud: &'a [(f64, f64)],
    /// Parts of the indeterminate set to be hatched lightly over the modes they are resolved to.
    pub hatched: &'a [Unresolved],
    /// Another diagram, in dashes.
    pub pinned: Option<&'a PinnedDiagram>,
    /// True if the axes carry round numbers; if not, the sheet's named values.
    pub numbered: bool,
}
