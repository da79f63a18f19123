//! What a figure is beside its drawing: well-formed SVG with words, PNG, PDF, and the same bytes every time.

use resvg::usvg;
use standfast::Diagram;
use standfast_figures::{DesignPoint, FigureId, RenderError, diagram, report_figure};

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
fn the_description_puts_modes_and_points_in_words() {
    let points = [DesignPoint { k: 0.3, mu: 0.5, label: "crest <1> & trough".into() }];
    let figure = diagram(&Diagram::new(3.0, 0.8).expect("a valid body"), &points);
    let svg = figure.svg();
    for words in [
        "stays at rest",
        "slides to the left",
        "rocks about O, the bottom left corner",
        "SRO₊, where the body slides and rocks about O",
        "E (1.05, 0)",
        "crest &lt;1&gt; &amp; trough (0.3, 0.5): RO.",
    ] {
        assert!(svg.contains(words), "{words:?} is not in the description");
    }
    assert!(figure.title().contains("γ = 3, k′ = 0.8"));
}

#[test]
fn identifiers_read_back_and_errors_list_what_exists() {
    for id in FigureId::ALL {
        assert_eq!(id.to_string().parse(), Ok(id));
    }
    let error = "3.12".parse::<FigureId>().unwrap_err();
    assert!(error.to_string().starts_with("the report has no figure \"3.12\"; it has 2.1, 3.1, 3.2, 3.3a,"));
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

#[test]
fn the_regions_of_a_picture_have_the_colours_of_their_modes() {
    let figure = report_figure("3.10".parse().expect("a figure"));
    for tint in ["#f1f4f7", "#f7de8b", "#aad2f0", "#f0ab6b"] {
        assert_eq!(figure.svg().matches(tint).count(), 1, "{tint}");
    }
}
