//! Labels never touch one another and never leave the page, whatever the body.

use standfast::Diagram;
use standfast_figures::{DesignPoint, Figure, FigureId, Rect, diagram, report_figure};

const SLENDERNESS: [f64; 12] = [0.05, 0.2, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 4.5, 6.0, 10.0, 20.0];
const ELEVATION: [f64; 25] = [
    -3.0, -2.0, -1.7, -1.2, -1.01, -1.0, -0.99, -0.9, -0.75, -0.5, -0.45, -0.3, -0.1, -1e-3, -1e-9, 0.0,
    1e-9, 1e-3, 0.1, 0.3, 0.5, 0.8, 1.0, 1.8, 3.0,
];

/// The sweep, with the thresholds between the cases of each γ.
fn bodies() -> impl Iterator<Item = Diagram> {
    SLENDERNESS.into_iter().flat_map(|slenderness| {
        let square = slenderness * slenderness;
        let thresholds = [
            (1.0 + square) / (3.0 * square),
            (4.0 + square) / (3.0 * square),
            -(1.0 + square) / (4.0 + square),
        ];
        let elevations = ELEVATION.into_iter().chain(thresholds);
        elevations.map(move |k_prime| Diagram::new(slenderness, k_prime).expect("a valid body"))
    })
}

fn assert_tidy(figure: &Figure) {
    let (width, height) = figure.size();
    let page = Rect { x0: 1.0, y0: 1.0, x1: width - 1.0, y1: height - 1.0 };
    let labels = figure.labels();
    for (i, label) in labels.iter().enumerate() {
        assert!(
            page.contains(&label.rect),
            "{:?} leaves the page of {:?}: {:?}",
            label.text,
            figure.title(),
            label.rect
        );
        for other in &labels[i + 1..] {
            assert!(
                !label.rect.overlaps(&other.rect),
                "{:?} {:?} touches {:?} {:?} in {:?}",
                label.text,
                label.rect,
                other.text,
                other.rect,
                figure.title()
            );
        }
    }
}

#[test]
fn the_reports_figures_are_tidy() {
    FigureId::ALL.into_iter().for_each(|id| assert_tidy(&report_figure(id)));
}

#[test]
fn a_diagram_is_tidy_for_any_body() {
    bodies().for_each(|body| assert_tidy(&diagram(&body, &[])));
}

#[test]
fn a_diagram_with_design_points_is_tidy_for_any_body() {
    for body in bodies() {
        let unit = 1.0 / body.chart().gamma();
        let point = |k: f64, mu: f64, label: &str| DesignPoint {
            k: k * unit,
            mu: mu * unit,
            label: label.into(),
            mirrored: false,
        };
        let points = [
            point(0.3, 0.5, "still water"),
            point(0.31, 0.5, "wave crest, 50-year storm & more <of it>"),
            point(0.31, 0.5, ""),
            point(0.9, 0.2, &"W".repeat(300)),
            point(1.2, 0.4, "trough"),
            point(0.0, 0.0, "origin"),
            point(f64::NAN, 0.4, "nowhere"),
        ];
        assert_tidy(&diagram(&body, &points));
    }
}

#[test]
fn far_and_crowded_design_points_are_tidy() {
    let body = Diagram::new(2.0, 0.3).expect("a valid body");
    let far = [(1e6, 1e-3), (1e-6, 1e5), (3.0, 0.0)].map(|(k, mu)| DesignPoint {
        k,
        mu,
        label: format!("{k}"),
        mirrored: false,
    });
    assert_tidy(&diagram(&body, &far));
    let many: Vec<_> = (0..60)
        .map(|i| DesignPoint {
            k: 0.3 + 0.002 * f64::from(i),
            mu: 0.4,
            label: format!("case number {i}"),
            mirrored: false,
        })
        .collect();
    assert_tidy(&diagram(&body, &many));
}

#[test]
fn every_region_that_is_wide_enough_is_named() {
    for (slenderness, k_prime, symbols) in [
        (1.0, 0.4, &["RE", "SL", "RO", "SRO₋"][..]),
        (3.0, 0.8, &["RE", "SL", "RO", "SRO₋", "SRO₊"]),
        (1.0, -0.6, &["RE", "SL", "RO", "SRO′₋"]),
        (4.0, -0.55, &["RE", "SL", "RO", "SRO₋", "SRO′₋"]),
        (1.2, -1.7, &["RE", "SL", "RO′", "SRO′₋"]),
    ] {
        let figure = diagram(&Diagram::new(slenderness, k_prime).expect("a valid body"), &[]);
        for symbol in symbols {
            let named = figure.labels().iter().any(|label| label.text == *symbol);
            assert!(named, "{symbol} is missing in {:?}", figure.title());
        }
    }
}

#[test]
fn a_minus_is_never_a_hyphen() {
    let below = diagram(&Diagram::new(4.0, -0.55).expect("a valid body"), &[]);
    let figures = FigureId::ALL.map(report_figure).into_iter().chain([below]);
    for figure in figures {
        for label in figure.labels() {
            // "Slide-rock" is a word; a sign has no letter on its left.
            let signs = label.text.replace("Slide-rock", "");
            assert!(!signs.contains(['-', '\'']), "{:?} in {:?}", label.text, figure.title());
        }
    }
}

#[test]
fn what_a_point_is_called_keeps_off_the_line_of_sliding() {
    for (slenderness, k_prime) in [(0.7, 0.23), (1.17, 0.17), (2.0, 0.5), (1.0, -0.6), (0.7, -3.9)] {
        let body = Diagram::new(slenderness, k_prime).expect("a valid body");
        let k_a = body.chart().k_a();
        for share in [0.3, 0.45, 0.6, 0.8] {
            for aside in [-0.1, -0.04, 0.04, 0.1] {
                let (k, mu) = ((share + aside) * k_a, (share - aside) * k_a);
                let point = DesignPoint { k, mu, label: "full load".into(), mirrored: false };
                let figure = diagram(&body, &[point]);
                let label = figure.labels().iter().find(|label| label.text == "full load");
                let rect = label.unwrap_or_else(|| panic!("no name in {:?}", figure.title())).rect;
                // The line through the origin and A, from their places on the page.
                let dot = |name: &str| {
                    let circle = figure.svg().split("<circle cx=\"").nth(1).expect(name);
                    let (x, rest) = circle.split_once("\" cy=\"").expect(name);
                    (number(x), number(rest.split_once('"').expect(name).0))
                };
                let (a, origin) = (dot("A"), origin(&figure));
                let y = |x: f64| origin.1 + (x - origin.0) / (a.0 - origin.0) * (a.1 - origin.1);
                let crosses = rect.x0 < a.0 && y(rect.x0) > rect.y0 && y(rect.x1.min(a.0)) < rect.y1;
                assert!(!crosses, "{rect:?} lies on μ = k in {:?} with {k}, {mu}", figure.title());
            }
        }
    }
}

#[test]
fn numbers_of_crowded_points_are_told_apart() {
    let body = Diagram::new(2.0, 0.3).expect("a valid body");
    let points: Vec<_> = [0.2, 0.2165]
        .iter()
        .map(|&k| DesignPoint { k, mu: 0.3, label: "W".repeat(60), mirrored: false })
        .collect();
    let figure = diagram(&body, &points);
    let numbers: Vec<_> =
        figure.labels().iter().filter(|label| ["1", "2"].contains(&label.text.as_str())).collect();
    assert_eq!(numbers.len(), 2, "{numbers:?}");
    for (i, one) in numbers.iter().enumerate() {
        for other in &numbers[i + 1..] {
            let apart = (other.rect.x0 - one.rect.x1).max(one.rect.x0 - other.rect.x1);
            let level = one.rect.y0 < other.rect.y1 && other.rect.y0 < one.rect.y1;
            assert!(!level || apart > 4.0, "{one:?} {other:?}");
        }
    }
}

fn number(text: &str) -> f64 {
    text.parse().expect("a number")
}

/// Origin of the axes: the lower left corner of the frame, whose path goes from the upper left one clockwise.
fn origin(figure: &Figure) -> (f64, f64) {
    let is_frame = |line: &&str| line.contains("Z\" fill=\"none\"") && line.contains("stroke-width=\"0.9\"");
    let frame = figure.svg().lines().find(is_frame).expect("a frame");
    let corners = frame.split_once("d=\"M").expect("a path").1.split_once('Z').expect("its end").0;
    let (x, y) =
        corners.split('L').next_back().and_then(|corner| corner.split_once(' ')).expect("two numbers");
    (number(x), number(y))
}

/// `D SRO₋` and `D Slide-rock` would read as one name.
#[test]
fn names_of_regions_read_apart_from_letters() {
    for id in FigureId::ALL {
        let figure = report_figure(id);
        let is_letter = |text: &str| text.trim_end_matches(['′', '″']).chars().count() == 1;
        let is_name =
            |text: &str| ["RE", "SL", "RO", "SRO", "Re", "Sl", "Ro"].iter().any(|s| text.starts_with(s));
        let (letters, names): (Vec<_>, Vec<_>) = figure
            .labels()
            .iter()
            .filter(|label| is_letter(&label.text) || is_name(&label.text))
            .partition(|label| is_letter(&label.text));
        for name in names {
            let side_by_side = letters.iter().find(|letter| {
                let level = letter.rect.y0 < name.rect.y1 && name.rect.y0 < letter.rect.y1;
                level && letter.rect.x0 < name.rect.x1 + 15.0 && name.rect.x0 < letter.rect.x1 + 15.0
            });
            assert_eq!(side_by_side, None, "{:?} in {:?}", name.text, figure.title());
        }
    }
}
