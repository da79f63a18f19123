//! Figures of answers as data, and as PNG and PDF.

use std::borrow::Cow;

use pyo3::prelude::*;
use standfast_cases::Document;
use standfast_figures::{Figure as Drawing, Label, Rect};

use crate::errors::StandfastError;
use crate::invalid;

/// Words, suffix and SVG of a figure, and what else a picture is made of.
pub(crate) type Figure = (String, String, String, Kept);

/// Title, width and height of a figure, and its labels, each with its box and its type size.
pub(crate) type Kept = (String, (f64, f64), Vec<(String, [f64; 5])>);

/// The figures of an answer.
pub(crate) fn figures<D: Document + ?Sized>(answer: &D, view: &D::View) -> PyResult<Vec<Figure>> {
    let figures = answer.figures(view).map_err(|error| invalid(error, &[]))?.into_iter();
    let kept = |drawing: &Drawing| {
        let labels = drawing
            .labels()
            .iter()
            .map(|Label { text, rect, size }| (text.clone(), [rect.x0, rect.y0, rect.x1, rect.y1, *size]));
        (drawing.title().to_owned(), drawing.size(), labels.collect())
    };
    let data = |(words, suffix, drawing): (String, String, Drawing)| {
        let svg = drawing.svg().to_owned();
        (words, suffix, svg, kept(&drawing))
    };
    Ok(figures.map(|figure| data((figure.words, figure.suffix, figure.figure))).collect())
}

/// A figure as PNG, `scale` pixels for a unit of the SVG, or as PDF where there is none.
#[pyfunction]
pub(crate) fn picture(
    py: Python<'_>,
    svg: String,
    kept: Kept,
    scale: Option<f32>,
) -> PyResult<Cow<'static, [u8]>> {
    let (title, size, labels) = kept;
    let label = |(text, [x0, y0, x1, y1, size]): (String, [f64; 5])| Label {
        text,
        rect: Rect { x0, y0, x1, y1 },
        size,
    };
    let drawing = Drawing::kept(svg, title, labels.into_iter().map(label).collect(), size);
    let made = py.detach(|| match scale {
        Some(scale) => drawing.png(scale),
        None => drawing.pdf(),
    });
    made.map(Cow::Owned).map_err(|error| StandfastError::new_err(error.to_string()))
}
