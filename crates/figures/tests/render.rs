//! What a figure is beside its drawing: well-formed SVG, PNG, PDF, and the same bytes every time.

use resvg::usvg;
use standfast_figures::{FigureId, RenderError, report_figure};

#[test]
fn every_figure_is_well_formed_and_says_what_it_shows() {
    for id in FigureId::ALL {
        let figure = report_figure(id);
        usvg::Tree::from_str(figure.svg(), &usvg::Options::default()).expect("well-formed SVG");
        assert!(figure.title().starts_with(&format!("Fig. {id} ")), "{}", figure.title());
        assert!(figure.svg().contains("role=\"img\"") && figure.svg().contains("<desc>"));
        assert!(
            !figure.svg().contains("<text") && !figure.svg().contains("NaN") && !figure.svg().contains("inf")
        );
        assert_eq!(figure, report_figure(id), "the same bytes every time");
    }
}

#[test]
fn png_and_pdf_are_made_from_the_svg() {
    let figure = report_figure("3.11".parse().expect("a figure"));
    let png = figure.png(0.5).expect("a PNG");
    assert!(png.starts_with(b"\x89PNG"));
    let (width, _) = figure.size();
    assert_eq!(u32::from_be_bytes(png[16..20].try_into().expect("four bytes")), (width / 2.0).ceil() as u32);
    assert!(figure.pdf().expect("a PDF").starts_with(b"%PDF"));
}

#[test]
fn a_scale_that_makes_no_sense_is_refused() {
    let figure = report_figure(FigureId::ALL[0]);
    for scale in [0.0, -1.0, f32::NAN, f32::INFINITY, 1e5] {
        assert!(matches!(figure.png(scale), Err(RenderError::Scale(_))), "{scale}");
    }
}
