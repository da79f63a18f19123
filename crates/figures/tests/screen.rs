//! Pictures for a screen: labels apart, colours left to the page, values where the picture says.

use standfast::ground::strength::CrushPoint;
use standfast::initiation::{Chart, ChartCase};
use standfast::{Diagram, Point};
use standfast_figures::{
    DesignPoint, Figure, FigureId, FreeBody, Map, Rect, View, cases_on_screen, free_body, sketch_on_screen,
};

const SLENDERNESS: [f64; 7] = [0.1, 0.4, 0.8, 1.5, 3.0, 5.0, 10.0];
const ELEVATION: [f64; 11] = [-2.5, -1.0, -0.9, -0.6, -0.3, 0.0, 0.2, 0.5, 0.8, 1.0, 1.8];
/// Of a phone, a laptop and a large screen, in units of the drawing.
const SIZES: [(f64, f64); 3] = [(340.0, 330.0), (800.0, 512.0), (900.0, 640.0)];

fn bodies() -> impl Iterator<Item = Diagram> {
    SLENDERNESS
        .into_iter()
        .flat_map(|gamma| ELEVATION.into_iter().map(move |k_prime| Diagram::new(gamma, k_prime).unwrap()))
}

fn assert_tidy(figure: &Figure) {
    let (width, height) = figure.size();
    let page = Rect { x0: 0.0, y0: 0.0, x1: width, y1: height };
    for (i, label) in figure.labels().iter().enumerate() {
        assert!(page.contains(&label.rect), "{:?} leaves {:?}: {:?}", label.text, figure.title(), label.rect);
        for other in &figure.labels()[i + 1..] {
            let apart = !label.rect.overlaps(&other.rect);
            assert!(apart, "{:?} touches {:?} in {:?}", label.text, other.text, figure.title());
        }
    }
}

fn assert_themed(figure: &Figure) {
    assert!(!figure.svg().contains("\"#"), "a fixed colour in {:?}", figure.title());
    assert!(figure.svg().contains("var(--ink,"));
}

#[test]
fn a_map_is_tidy_at_every_size_and_nearness() {
    for diagram in bodies() {
        let whole = View::of(&diagram, 0.0, 0.0);
        let middle = ((whole.k_min + whole.k_max) / 2.0, (whole.mu_min + whole.mu_max) / 2.0);
        for view in [
            whole,
            whole.zoomed(0.37, middle.0, middle.1),
            whole.moved(0.3, 0.2),
            whole.zoomed(5.0, 0.0, 0.0),
        ] {
            for size in SIZES {
                let picture = Map { diagram: &diagram, figure: None, view: &view, size }.on_screen();
                assert_tidy(&picture.figure);
                assert_themed(&picture.figure);
            }
        }
    }
}

#[test]
fn every_figure_of_the_report_is_drawn_for_a_screen() {
    for id in FigureId::ALL {
        let Some((gamma, k_prime)) = id.body() else {
            assert_themed(&sketch_on_screen(id).unwrap());
            continue;
        };
        let (diagram, view) = (Diagram::new(gamma, k_prime).unwrap(), View::of_figure(id).unwrap());
        for size in SIZES {
            let picture = Map { diagram: &diagram, figure: Some(id), view: &view, size }.on_screen();
            assert!(picture.figure.title().starts_with(&format!("Fig. {id} ")));
            assert_tidy(&picture.figure);
        }
        // Another body is not the figure's.
        let other = Diagram::new(gamma * 1.01, k_prime).unwrap();
        let picture = Map { diagram: &other, figure: Some(id), view: &view, size: SIZES[0] }.on_screen();
        assert!(picture.figure.title().starts_with("Modes of a block"));
    }
}

#[test]
fn a_picture_knows_its_values_and_zooms_about_a_place() {
    let diagram = Diagram::new(1.0, 0.4).unwrap();
    let view = View::of(&diagram, 0.0, 0.0);
    let picture =
        |view: &View| Map { diagram: &diagram, figure: None, view, size: (800.0, 500.0) }.on_screen();
    let whole = picture(&view);
    let (x, y) = whole.place(1.2, 0.7);
    let (k, mu) = whole.values(x, y);
    assert!((k - 1.2).abs() < 1e-12 && (mu - 0.7).abs() < 1e-12);
    let near = picture(&view.zoomed(0.5, 1.2, 0.7));
    let (x2, y2) = near.place(1.2, 0.7);
    assert!((x2 - x).abs() < 1e-9 && (y2 - y).abs() < 1e-9);
    // Nothing negative comes into view, and nothing too small to be drawn.
    let far = view.zoomed(4.0, 1.2, 0.7).moved(-3.0, -3.0);
    assert_eq!((far.k_min, far.mu_min), (0.0, 0.0));
    let nearest = (0..200).fold(view, |view, _| view.zoomed(0.5, 1.2, 0.7));
    assert!(nearest.is_drawable());
    assert_tidy(&picture(&nearest).figure);
}

#[test]
fn a_map_on_paper_has_fixed_colours_and_the_design_point() {
    let diagram = Diagram::new(3.0, 0.8).unwrap();
    let view = View::of(&diagram, 0.0, 0.0);
    let point = DesignPoint { k: 0.5, mu: 0.1, label: "storm".into(), mirrored: false };
    let figure = Map { diagram: &diagram, figure: None, view: &view, size: (800.0, 500.0) }.on_paper(&point);
    assert!(!figure.svg().contains("var("));
    assert!(figure.labels().iter().any(|label| label.text == "storm"));
    assert_tidy(&figure);
}

#[test]
fn the_cases_lie_where_the_chart_has_them() {
    let picture = cases_on_screen(&Chart::new(3.0, 0.8).unwrap(), (360.0, 280.0));
    assert_tidy(&picture.figure);
    assert_themed(&picture.figure);
    let (x, y) = picture.place(3.0, 0.8);
    let (gamma, k_prime) = picture.values(x, y);
    assert!((gamma - 3.0).abs() < 1e-12 && (k_prime - 0.8).abs() < 1e-12);
    let names: Vec<&str> = picture.figure.labels().iter().map(|label| label.text.as_str()).collect();
    for case in [
        ChartCase::OneA,
        ChartCase::OneB,
        ChartCase::TwoThree,
        ChartCase::DeltaPositive,
        ChartCase::DeltaNotPositive,
    ] {
        assert!(names.contains(&case.name()), "{names:?} lack {}", case.name());
    }
}

#[test]
fn a_body_moves_the_way_its_accelerations_point() {
    for (gamma, k_prime, k, mu) in [
        (1.0, 0.4, 0.8, 0.4),
        (3.0, 0.8, 0.6, 0.4),
        (0.8, 0.9, 0.8, 0.6),
        (3.0, 0.8, 1.7, 0.05),
        (1.0, -0.6, 5.0, 0.5),
        (0.8, 0.9, 0.3, 0.6),
        (0.1, 0.4, 8.0, 5.0),
        (10.0, 1.0, 0.2, 0.05),
        (1.0, -1.7, 2.0, 0.5),
        (1.0, 3.0, 0.0, 0.5),
    ] {
        for mirrored in [false, true] {
            let point = Point::new(gamma, k_prime, k, mu).unwrap();
            let (figure, pose) = free_body(&FreeBody { point, mirrored, omega: 0.0 }, (400.0, 270.0));
            let motion = if mirrored { point.motion().mirrored() } else { point.motion() };
            let sign = |number: f64| if number == 0.0 { 0.0 } else { number.signum() };
            assert_eq!(sign(pose.shift), sign(motion.slip));
            // θ is counter-clockwise, the page's angles clockwise.
            assert_eq!(sign(pose.turn), -sign(motion.theta_ddot));
            assert!(pose.shift.abs() <= 26.0 + 1e-9 && pose.turn.abs() < 10.0);
            assert_themed(&figure);
            let (width, height) = figure.size();
            let page = Rect { x0: 0.0, y0: 0.0, x1: width, y1: height };
            for (i, label) in figure.labels().iter().enumerate() {
                assert!(page.contains(&label.rect), "{:?} at γ = {gamma}, k' = {k_prime}", label.text);
                for other in &figure.labels()[i + 1..] {
                    let apart = !label.rect.overlaps(&other.rect);
                    assert!(apart, "{} touches {} at γ = {gamma}, k' = {k_prime}", label.text, other.text);
                }
            }
        }
    }
}

/// On a base that crushes the drawing is of its motion: it turns about the neutral point, and says so; one that cannot carry the body has no
/// motion; ω → 0 is the rigid base.
#[test]
fn a_body_on_a_base_that_crushes_turns_about_its_neutral_point() {
    let point = Point::new(0.8, 0.9167, 0.61, 0.6).unwrap();
    let size = (400.0, 270.0);
    let drawn = |omega: f64, mirrored: bool| free_body(&FreeBody { point, mirrored, omega }, size);
    let (rigid, _) = drawn(0.0, false);
    assert!(rigid.title().contains("(SL)"), "{}", rigid.title());
    // RO, as the diagram of the same numbers has it; the neutral point is 2ωN from the edge O.
    let begun = CrushPoint::of(point, 0.08).unwrap().motion().unwrap();
    for mirrored in [false, true] {
        let (figure, pose) = drawn(0.08, mirrored);
        assert!(figure.title().contains(if mirrored { "(RO′)" } else { "(RO)" }), "{}", figure.title());
        let half = (size.0 - 2.0 * 84.0) / 2.0;
        let half = half.min((size.1 - 34.0 - 78.0) / (0.8 * 2.0));
        let inside = 2.0 * 0.08 * begun.motion.f_y;
        let neutral = size.0 / 2.0 + if mirrored { 1.0 } else { -1.0 } * (1.0 - inside) * half;
        assert!((pose.pivot.0 - neutral).abs() < 1e-9, "{} {neutral}", pose.pivot.0);
        assert_eq!(pose.shift, 0.0);
        assert_themed(&figure);
    }
    let (crushed, pose) = drawn(1.0, false);
    assert!(crushed.title().contains("BF") && (pose.shift, pose.turn) == (0.0, 0.0), "{}", crushed.title());
}
