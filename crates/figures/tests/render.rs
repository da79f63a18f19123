//! Files of figures: well-formed SVG, PNG, PDF, and the same bytes every time.

use std::process::Command;

use resvg::{tiny_skia, usvg};
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

/// The text of a PDF as poppler reads it, lines in their places; `None` where poppler is not there, except in CI.
fn text(pdf: &[u8], name: &str) -> Option<String> {
    let path = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&path, pdf).expect("a file");
    let output = Command::new("pdftotext").arg("-layout").arg(path).arg("-").output();
    let needed = std::env::var_os("CI").is_some_and(|ci| ci == "true");
    assert!(output.is_ok() || !needed, "no pdftotext in CI");
    Some(String::from_utf8(output.ok()?.stdout).expect("UTF-8"))
}

#[test]
fn the_text_of_a_pdf_can_be_searched_and_copied() {
    let body = Diagram::new(3.0, 0.8).expect("a valid body");
    let point = DesignPoint { k: 1.2, mu: 0.01, label: "Sturmflut 波".into(), mirrored: false };
    let figure = diagram(&body, &[point]);
    let pdf = figure.pdf().expect("a PDF");
    assert_eq!(pdf, figure.pdf().expect("a PDF"), "the same bytes every time");
    let Some(text) = text(&pdf, "searchable.pdf") else { return };
    for words in ["μ", "k", "RE", "SRO-", "SRO+", "0.2", "Sturmflut 波", "k' = 0.8", "(1.2, 0.01): SRO+."] {
        assert!(text.contains(words), "{words:?} is not in {text}");
    }
    // Every label of the figure, its signs those of a keyboard, wherever the lines break.
    let spaceless = |text: &str| text.split_whitespace().collect::<String>();
    for label in figure.labels() {
        let typed = label.text.replace(['−', '₋'], "-").replace('₊', "+").replace('′', "'");
        assert!(spaceless(&text).contains(&spaceless(&typed)), "{typed:?} is not in {text}");
    }
}

#[test]
fn the_text_of_a_pdf_lies_where_the_letters_are_drawn_and_is_not_seen() {
    let figure = report_figure("3.11".parse().expect("a figure"));
    let pdf = figure.pdf().expect("a PDF");
    let content = String::from_utf8_lossy(&pdf);
    assert_eq!(content.matches("3 Tr").count(), 1, "invisible from the first to the last label");
    let (_, height) = figure.size();
    for label in figure.labels() {
        let x = 0.75 * label.rect.x0;
        let middle = 0.75 * (height - label.rect.centre().1);
        let placed = content.lines().filter_map(|line| line.strip_suffix(" Tm")).any(|matrix| {
            let numbers: Vec<f64> = matrix.split(' ').filter_map(|number| number.parse().ok()).collect();
            (numbers[4] - x).abs() < 0.01 && (0.0..4.0).contains(&(middle - numbers[5]))
        });
        assert!(placed, "{label:?}");
    }
}

/// At true scale the lens A–B′ of Fig. 4.5a is some three pixels high; the lines that bound it must leave some of it.
#[test]
fn the_lens_is_seen_at_true_scale() {
    let (_, lens, _) =
        standfast_figures::colours().find(|colour| colour.0 == "slide-rock-left").expect("a colour");
    let figure = report_figure("4.5a".parse().expect("a figure"));
    let png = tiny_skia::Pixmap::decode_png(&figure.png(2.0).expect("a PNG")).expect("a picture");
    let place = |name: &str| {
        let label = figure.labels().iter().rfind(|label| label.text == name).expect(name);
        (2.0 * label.rect.x1, 2.0 * label.rect.y1)
    };
    // From the letter A to the letter B′, which stand above the ends of the lens.
    let (a, b) = (place("A"), place("B′"));
    let seen = (a.0 as u32..b.0 as u32).flat_map(|x| (b.1 as u32..a.1 as u32).map(move |y| (x, y)));
    let seen = seen.filter_map(|(x, y)| png.pixel(x, y)).filter(|pixel| {
        let pixel = pixel.demultiply();
        format!("#{:02x}{:02x}{:02x}", pixel.red(), pixel.green(), pixel.blue()) == lens
    });
    let count = seen.count();
    assert!(count > 150, "{count} pixels of the lens");
}

/// Renderers that know no dark pages draw the light colours: the style is no part of what they draw.
#[test]
fn pixels_have_the_colours_of_paper() {
    let figure = report_figure("3.9a".parse().expect("a figure"));
    let png = figure.png(1.0).expect("a picture");
    let pixels = resvg::tiny_skia::Pixmap::decode_png(&png).expect("pixels");
    let white = pixels.pixel(0, 0).expect("a corner");
    assert_eq!((white.red(), white.green(), white.blue()), (255, 255, 255));
}
