//! PNG from the SVG, and what may go wrong there and in the PDF.

use resvg::{tiny_skia, usvg};

use crate::Figure;

/// Reason why a figure could not be rendered.
#[derive(Debug, thiserror::Error)]
pub enum RenderError {
    /// The scale is not above zero, or the picture would have more than 20 000 pixels along a side.
    #[error(
        "scale {0} pixels per unit; expected a number above zero that keeps the picture below 20 000 pixels a side"
    )]
    Scale(f32),
    /// The SVG was not understood.
    #[error("the figure's SVG: {0}")]
    Svg(String),
    /// The PNG was not encoded.
    #[error("the figure's PNG: {0}")]
    Png(String),
    /// The PDF was not written.
    #[error("the figure's PDF: {0}")]
    Pdf(String),
}

impl Figure {
    /// The figure as PNG, `scale` pixels for a unit of the SVG (1 gives 96 dots per inch).
    ///
    /// # Errors
    /// If `scale` makes no sense.
    pub fn png(&self, scale: f32) -> Result<Vec<u8>, RenderError> {
        const LARGEST: f64 = 20_000.0;
        let (width, height) = self.size;
        let pixels = |length: f64| (length * f64::from(scale)).ceil();
        // Written so that NaN fails.
        let sensible = scale > 0.0 && pixels(width) <= LARGEST && pixels(height) <= LARGEST;
        if !sensible {
            return Err(RenderError::Scale(scale));
        }
        let tree = self.tree()?;
        let mut canvas = tiny_skia::Pixmap::new(pixels(width) as u32, pixels(height) as u32)
            .ok_or(RenderError::Scale(scale))?;
        resvg::render(&tree, tiny_skia::Transform::from_scale(scale, scale), &mut canvas.as_mut());
        canvas.encode_png().map_err(|error| RenderError::Png(error.to_string()))
    }

    pub(crate) fn tree(&self) -> Result<usvg::Tree, RenderError> {
        usvg::Tree::from_str(&self.svg, &usvg::Options::default())
            .map_err(|error| RenderError::Svg(error.to_string()))
    }
}
