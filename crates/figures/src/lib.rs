//! The k–μ diagram and the report's figures, as SVG, PNG and PDF.
