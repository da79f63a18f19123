//! Words, names and colours of figures.

use standfast::Diagram;
use standfast::diagram::Window;
use standfast_figures::{
    DesignPoint, DiagramContent, Figure, FigureId, Rect, axis_numbers, diagram, diagram_with, report_figure,
};

#[test]
fn the_description_puts_modes_and_points_in_words() {
    let points = [DesignPoint { k: 0.3, mu: 0.5, label: "crest <1> & trough".into(), mirrored: false }];
    let figure = diagram(&Diagram::new(3.0, 0.8).expect("a valid body"), &points);
    let svg = figure.svg();
    for words in [
        "stays at rest",
        "slides to the left",
        "rocks about O, the bottom left corner",
        "SRO₊, where the body slides and rocks about O",
        "D (0.417, 0)",
        "crest &lt;1&gt; &amp; trough (0.3, 0.5): RO.",
    ] {
        assert!(svg.contains(words), "{words:?} is not in the description");
    }
    assert_eq!(figure.title(), "Modes of a block, γ = 3, k′ = 0.8");
    assert!(
        figure.caption().starts_with("Force above the centre of mass, cases 2 and 3: k′ > (4 + γ²)/(3γ²).")
    );
}

/// E of this body lies at k = 1.05: outside a frame up to 1, where the caption does not speak of it, and inside one up to 1.2.
#[test]
fn a_caption_lists_the_points_within_the_frame() {
    let body = Diagram::new(3.0, 0.8).expect("a valid body");
    let listed = |k: f64| {
        let content = DiagramContent { window: Some(Window { k, mu: 0.6 }), ..DiagramContent::default() };
        diagram_with(&body.clone().into(), &content).caption().contains("E (1.05, 0)")
    };
    assert!(!listed(1.0) && listed(1.2));
}

#[test]
fn identifiers_read_back_and_errors_list_what_exists() {
    for id in FigureId::ALL {
        assert_eq!(id.to_string().parse(), Ok(id));
    }
    let error = "3.12".parse::<FigureId>().unwrap_err();
    assert!(error.to_string().starts_with("the report has no figure \"3.12\"; it has 2.1, 3.1, 3.2, 3.3a,"));
}

/// A colour on paper.
fn paper(property: &str) -> &'static str {
    standfast_figures::colours().find(|colour| colour.0 == property).expect("a colour").1
}

/// Every colour of a drawing has its counterpart in a dark page, written beside it, and nothing else is coloured.
#[test]
fn every_colour_has_its_counterpart_in_a_dark_page() {
    let colours: Vec<_> = standfast_figures::colours().collect();
    for id in FigureId::ALL {
        let figure = report_figure(id);
        let (_, rest) = figure.svg().split_once("<style>").expect("a style");
        let (style, body) = rest.split_once("</style>").expect("its end");
        assert_eq!(figure.svg_on_paper(), figure.svg().replace(&format!("<style>{style}</style>\n"), ""));
        assert!(style.starts_with("@media (prefers-color-scheme:dark){") && style.ends_with("}}"), "{style}");
        for attribute in ["fill", "stroke"] {
            for piece in body.split(&format!(" {attribute}=\"#")).skip(1) {
                let light = format!("#{}", &piece[..6]);
                let (.., dark) =
                    colours.iter().find(|colour| colour.1 == light).expect("a colour of the palette");
                let rule = format!("[{attribute}=\"{light}\"]{{{attribute}:{dark}}}");
                assert!(style.contains(&rule), "{rule} in {id}");
            }
        }
    }
}

#[test]
fn the_regions_of_a_picture_have_the_colours_of_their_modes() {
    let figure = report_figure("3.10".parse().expect("a figure"));
    for property in ["rest", "slide", "rock", "slide-rock-left"] {
        let filled = format!("fill=\"{}\"/>", paper(property));
        assert_eq!(figure.svg().matches(&filled).count(), 1, "{property}");
    }
}

/// Text that the specification of the figures wants to read in each chart: letters of points and line ends, values on
/// the axes, formulas and names. What finds no room in the chart stands in its caption.
const WANTED: [(&str, &[&str]); 26] = [
    ("2.1", &["C", "O", "O′", "F", "h = k′H", "2B", "2H", "x", "y", "θ", "ξ", "f_x", "f_y"]),
    ("3.1", &["A", "B", "O", "Rest", "μ = k", "k_A", "μ_A"]),
    ("3.2", &["A", "B", "C", "D", "Slide", "μ = k", "μ = 1/γ − kk′", "μ_C", "k_D", "k_A"]),
    ("3.3a", &["A", "B", "C", "D", "a/c", "b/d", "μ_A", "k_A", "k_D", "μ*(k) = (ak + b)/(ck + d)"]),
    ("3.3b", &["A", "B", "C", "D", "a/c", "b/d", "μ_A", "k_A", "k_D", "μ*(k) = (ak + b)/(ck + d)"]),
    ("3.4", &["A", "B", "C", "D", "E", "k_E", "k_A", "k_D", "μ*(k) = (−|a|k + b)/(ck + d)"]),
    ("3.5", &["A", "B", "C", "D", "E", "|a|/c", "k_A", "k_D", "k_E", "μ*(k) = (|a|k − b)/(ck + d)"]),
    ("3.6a", &["A", "B", "C", "D", "a/c"]),
    ("3.6b", &["A", "B", "C", "D", "a/c"]),
    ("3.7", &["A", "B", "C", "D", "E"]),
    ("3.8", &["C", "D", "E", "|a|/c", "μ = −1/γ + kk′"]),
    ("3.9a", &["A", "B", "D", "RE", "SL", "RO", "SRO₋", "μ*(k)", "k"]),
    ("3.9b", &["A", "B", "D", "RE", "SL", "RO", "SRO₋", "μ*(k)", "k"]),
    ("3.10", &["A", "B", "D", "E", "RE", "SL", "RO", "SRO₋"]),
    ("3.11", &["A", "B", "D", "E", "RE", "SL", "RO", "SRO₋", "SRO₊", "|a|/c"]),
    ("4.1", &["C", "O", "O′", "F", "|h| = |k′|H", "2B", "2H", "x", "y", "θ", "ξ", "f_x", "f_y"]),
    ("4.2", &["A", "E", "O", "Rest", "k_A", "μ_A", "μ = k"]),
    ("4.3", &["A", "B", "D", "C", "E", "ξ < 0", "ξ > 0", "μ = 1/γ + k|k′|", "μ = −1/γ + k|k′|", "μ = k|k′|"]),
    ("4.4a", &["A", "B", "B′", "C", "C′", "C″", "D", "E", "BB′C′C", "CC′C″", "μ_B′", "k_B′"]),
    ("4.4b", &["A", "B", "C", "C′", "C″", "D", "E", "BAC′C", "CC′C″"]),
    ("4.5a", &["A", "B", "B′", "C", "C′", "C″", "D", "k_A", "k_B′", "μ_B′", "BB′C′C", "CC′C″"]),
    ("4.5b", &["A", "B", "C", "C′", "C″", "D", "BAC′C", "CC′C″"]),
    ("4.6a", &["A", "B", "B′", "C", "D", "F", "μ**(k)", "μ = −1/γ + k|k′|"]),
    ("4.6b", &["A", "B", "C", "D", "F", "μ**(k)", "μ = −1/γ + k|k′|"]),
    ("4.7a", &["A", "B", "B′", "C", "D", "E", "RE", "SL", "RO", "SRO₋", "SRO′₋"]),
    ("4.7b", &["A", "B", "C", "D", "E", "RE", "SL", "RO", "SRO′₋"]),
];

#[test]
fn every_figure_says_what_its_specification_asks() {
    let mut missing = Vec::new();
    for (number, wanted) in WANTED {
        let figure = report_figure(number.parse().expect("a figure"));
        let labels: Vec<&str> = figure.labels().iter().map(|label| label.text.as_str()).collect();
        for &words in wanted {
            // Letters and names stand alone; symbols and formulas may be part of an equation or of the caption.
            let alone = words.chars().all(|c| c.is_ascii_alphabetic() || "′″₋₊".contains(c));
            let found = if alone {
                labels.contains(&words)
            } else {
                labels.iter().any(|label| label.contains(words)) || figure.caption().contains(words)
            };
            if !found {
                missing.push(format!("Fig. {number} lacks {words:?}: {labels:?} {}", figure.caption()));
            }
        }
    }
    assert!(missing.is_empty(), "{}", missing.join("\n"));
}

/// The numbers along an axis, as (value, place on the page), from the labels that stand in a row or a column.
fn numbers(figure: &Figure, across: bool) -> Vec<(f64, f64)> {
    let (_, height) = figure.size();
    let numbers = figure.labels().iter().filter_map(|label| Some((label.text.parse().ok()?, label.rect)));
    let all: Vec<(f64, Rect)> = numbers.filter(|(value, _)| *value > 0.0).collect();
    // Those of the k axis stand lower than all others that are not in the caption.
    let lowest = all.iter().map(|(_, rect)| rect.y1).filter(|y| *y < height).fold(0.0, f64::max);
    let place = |(value, rect): &(f64, Rect)| {
        let (x, y) = rect.centre();
        (*value, if across { x } else { y })
    };
    all.iter().filter(|(_, rect)| (rect.y1 > lowest - 1.0) == across).map(place).collect()
}

/// The value at a place, by the two numbers farthest apart.
fn read_off(numbers: &[(f64, f64)], place: f64) -> f64 {
    let ((first, from), (last, to)) = (numbers[0], numbers[numbers.len() - 1]);
    first + (place - from) / (to - from) * (last - first)
}

#[test]
fn a_point_can_be_read_off_the_numbers_of_the_axes() {
    for (gamma, k_prime, k, mu) in
        [(0.8, 0.9167, 0.728, 0.6), (3.0, 0.8, 0.3, 0.1), (1.0, -0.6, 1.9, 1.2), (1.2, -1.7, 0.03, 2.0)]
    {
        let body = Diagram::new(gamma, k_prime).expect("a valid body");
        let figure = diagram(&body, &[DesignPoint { k, mu, label: "storm".into(), mirrored: false }]);
        let (ks, mus) = (numbers(&figure, true), numbers(&figure, false));
        assert!(ks.len() >= 3 && mus.len() >= 3, "{ks:?} {mus:?} in {:?}", figure.title());
        // The diamond's path begins at its upper tip.
        let diamond = figure.svg().split_once("\" fill=\"#a3123f\"/>").expect("a diamond").0;
        let tip = diamond.rsplit_once("d=\"M").expect("a path").1.split_once('L').expect("a line").0;
        let (x, y) = tip.split_once(' ').expect("two numbers");
        let (x, y): (f64, f64) = (x.parse().expect("x"), y.parse().expect("y"));
        let read = (read_off(&ks, x), read_off(&mus, y + 5.2));
        // A pixel of some 400 by 310; numbers are set by the middle of their ink.
        let (wide, high) =
            (1.5 * ks[ks.len() - 1].0 / 300.0, 1.5 * mus[0].0.max(mus[mus.len() - 1].0) / 200.0);
        assert!((read.0 - k).abs() < wide, "k = {k} is read as {} in {:?}", read.0, figure.title());
        assert!((read.1 - mu).abs() < high, "μ = {mu} is read as {} in {:?}", read.1, figure.title());
    }
}

#[test]
fn the_report_s_axes_have_no_numbers() {
    for id in FigureId::ALL {
        let figure = report_figure(id);
        assert_eq!(numbers(&figure, true).len() + numbers(&figure, false).len(), 0, "{id}");
    }
}

/// The diagram of γ = 2, k' = 0.3 up to k = 1, μ = 0.8.
fn windowed(points: &[DesignPoint], cloud: &[(f64, f64)]) -> Figure {
    let body = Diagram::new(2.0, 0.3).expect("a valid body");
    diagram_with(&body.into(), &DiagramContent { window: Some(Window { k: 1.0, mu: 0.8 }), points, cloud })
}

#[test]
fn a_window_that_is_asked_for_is_shown_and_points_outside_are_pointed_at() {
    let point = |k: f64, mu: f64, label: &str| DesignPoint { k, mu, label: label.into(), mirrored: false };
    let points =
        [point(1.4, 0.3, "right"), point(0.5, 2.0, "up"), point(3.0, 4.0, "both"), point(0.4, 0.5, "in")];
    let figure = windowed(&points, &[]);
    let last = |across| numbers(&figure, across).iter().fold(0.0_f64, |most, (number, _)| most.max(*number));
    assert_eq!((last(true), last(false)), (1.0, 0.8));
    for words in ["right (1.4, 0.3), outside the window: SRO₋.", "in (0.4, 0.5): RO."] {
        assert!(figure.caption().contains(words), "{words:?} is not in {:?}", figure.caption());
    }
    let named: Vec<&str> = figure.labels().iter().map(|label| label.text.as_str()).collect();
    for label in ["right", "up", "both", "in"] {
        assert!(named.contains(&label), "{label:?} stands not in the plot: {named:?}");
    }
    // An arrow or a diamond each, in the colour of points.
    assert_eq!(figure.svg().matches("fill=\"#a3123f\"/>").count(), 4);
}

#[test]
fn a_cloud_of_points_is_counted_and_widens_a_window_that_is_not_asked_for() {
    let cloud = [(0.2, 0.1), (1.2, 0.1), (0.3, 0.9), (f64::NAN, 0.1)];
    assert!(windowed(&[], &cloud).caption().ends_with("Dots: 3 points, 2 of them outside the window."));
    let body = Diagram::new(2.0, 0.3).expect("a valid body");
    let content = DiagramContent { cloud: &cloud, ..DiagramContent::default() };
    let window = content.window_of(&body);
    assert!(diagram_with(&body.into(), &content).caption().ends_with("Dots: 3 points."));
    assert!(cloud[..3].iter().all(|&(k, mu)| k < window.k && mu < window.mu), "{window:?}");
}

#[test]
fn numbers_for_another_tool_are_those_of_the_figures() {
    let figure = windowed(&[], &[]);
    for (across, to, length) in [(true, 1.0, 400.0), (false, 0.8, 310.0)] {
        let theirs: Vec<f64> =
            axis_numbers(0.0, to, length / 12.5, !across).numbers.iter().map(|it| it.0).collect();
        for (number, _) in numbers(&figure, across) {
            assert!(
                theirs.iter().any(|one| (one - number).abs() < 1e-12),
                "{number} is not among {theirs:?}"
            );
        }
    }
}

/// A plane shows its design point and the corner A, and not the rest of the plane: within three times the point, or the corner with
/// its room.
#[test]
fn a_plane_is_framed_around_its_point() {
    use standfast::Diagram;
    use standfast_figures::DiagramContent;
    for (gamma, k_prime) in [(0.7, 0.23), (1.0, 0.4), (3.0, 0.8), (1.0, -0.6), (4.0, -0.55)] {
        let body = Diagram::new(gamma, k_prime).expect("a body");
        let k_a = body.chart().k_a();
        for share in [0.2, 0.9, 1.4, 5.0] {
            let (k, mu) = (share * k_a, 0.6);
            let window = DiagramContent { cloud: &[(k, mu)], ..DiagramContent::default() }.window_of(&body);
            assert!(window.k > k.max(k_a) && window.mu > mu.max(k_a), "{window:?} for {k} at γ = {gamma}");
            assert!(window.k <= (3.0 * k).max(1.35 * k_a) * (1.0 + 1e-12), "{window:?} for {k}");
            assert!(window.mu <= (3.0 * mu).max(1.35 * k_a) * (1.0 + 1e-12), "{window:?} for {k}");
        }
    }
}
