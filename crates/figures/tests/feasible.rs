//! Pictures of two quantities: what is asked of every figure, for sets of one stretch, of several, with gaps and steps.

use standfast_figures::{
    FeasibleSet, Figure, Rect, SetAxis, SetColumn, SetEnd, SetStretch, feasible_set, feasible_set_on_screen,
};

type Ends = ((f64, Option<&'static str>), (f64, Option<&'static str>));

fn column(at: f64, stretches: &[Ends], none: Option<&'static str>) -> SetColumn {
    let end = |(value, by): (f64, Option<&'static str>)| SetEnd { value, by };
    let stretches =
        stretches.iter().map(|(from, to)| SetStretch { from: end(*from), to: end(*to) }).collect();
    SetColumn { at, stretches, none }
}

fn draw(columns: &[SetColumn], present: (f64, f64)) -> Option<Figure> {
    let across = SetAxis { words: "friction", symbol: "μ", unit: "", present: present.0 };
    let up = SetAxis { words: "height", symbol: "H_0'", unit: "kN/m", present: present.1 };
    feasible_set(&FeasibleSet { title: "A block", caption: "Shaded: it rests.", across, up, columns })
}

/// Nothing leaves the page, no label lies on another, and a drawing is the same every time.
fn assert_tidy(columns: &[SetColumn], present: (f64, f64)) -> Figure {
    let figure = draw(columns, present).expect("a boundary");
    assert_eq!(Some(&figure), draw(columns, present).as_ref());
    assert!(!figure.svg().contains("NaN") && !figure.svg().contains("inf"), "{}", figure.svg());
    let (width, height) = figure.size();
    let page = Rect { x0: 1.0, y0: 1.0, x1: width - 1.0, y1: height - 1.0 };
    for (i, label) in figure.labels().iter().enumerate() {
        assert!(page.contains(&label.rect), "{label:?} leaves the page");
        for other in &figure.labels()[..i] {
            assert!(!label.rect.overlaps(&other.rect), "{:?} lies on {:?}", label.text, other.text);
        }
    }
    figure
}

fn texts(figure: &Figure) -> Vec<&str> {
    figure.labels().iter().map(|label| label.text.as_str()).collect()
}

/// Lines of the boundary on the page: the numbers of the strokes of their width.
fn strokes(figure: &Figure) -> Vec<Vec<f64>> {
    let lines = figure.svg().lines().filter(|line| line.contains("stroke-width=\"1.5\""));
    let numbers = |line: &str| {
        let path = line.split('"').nth(1).unwrap_or_default();
        path.split(|c: char| !matches!(c, '0'..='9' | '.' | '-'))
            .filter_map(|word| word.parse().ok())
            .collect()
    };
    lines.map(numbers).collect()
}

#[test]
fn a_boundary_is_drawn_where_it_is_and_named_by_what_binds() {
    let by = |mu: f64| if mu < 0.7 { "sliding" } else { "overturning" };
    let columns: Vec<_> = (3..=12)
        .map(|i| f64::from(i) / 10.0)
        .map(|mu| column(mu, &[((f64::max(6.0 / mu, 6.0 / 0.7), Some(by(mu))), (60.0, None))], None))
        .collect();
    let figure = assert_tidy(&columns, (0.6, 9.0));
    for word in ["sliding", "overturning", "present", "target met", "Friction, μ", "Height, H_0′ (kN/m)"] {
        assert_eq!(
            texts(&figure).iter().filter(|text| **text == word).count(),
            1,
            "{word}: {:?}",
            texts(&figure)
        );
    }
    assert_eq!(figure.caption(), "Shaded: it rests. Along the boundary: overturning, sliding.");
    // The first stroke begins at the left edge, where 6/0.3 = 20 is the highest end shown: 12 % of the values shown below the top.
    let [first, second] = &strokes(&figure)[..] else { panic!("{:?}", strokes(&figure)) };
    let area = (first[0], second[second.len() - 2]);
    assert!((area.1 - 454.0).abs() < 0.02 && area.0 > 40.0 && area.0 < 60.0, "{area:?}");
    let (least, greatest) = (6.0 / 0.7, 20.0);
    let (low, high) = (least - 0.12 * (greatest - least), greatest + 0.12 * (greatest - least));
    let y = |value: f64| 30.0 + (high - value) / (high - low) * 300.0;
    assert!((first[1] - y(20.0)).abs() < 0.02, "{first:?}");
    assert!((second[second.len() - 1] - y(least)).abs() < 0.02, "{second:?}");
}

#[test]
fn several_stretches_steps_and_gaps_are_tidy() {
    let two = |at: f64| {
        let (low, high) = (100.0 + 50.0 * at, 700.0 - 30.0 * at);
        column(
            at,
            &[
                ((low, Some("eccentricity")), (low + 80.0, Some("rest"))),
                ((high - 90.0, Some("rest")), (high, None)),
            ],
            None,
        )
    };
    let one = |at: f64| column(at, &[((120.0, Some("bearing")), (650.0, Some("uplift")))], None);
    let none = |at: f64| column(at, &[], Some("sliding"));
    let columns = [two(0.1), two(0.2), two(0.3), one(0.31), one(0.5), none(0.501), none(0.8)];
    let figure = assert_tidy(&columns, (0.4, 300.0));
    assert!(
        figure.caption().contains("Along the boundary: bearing, eccentricity, rest, sliding, uplift."),
        "{}",
        figure.caption()
    );
    // A step where nothing meets the target any more: an upright from 120 to 650, named by what binds beyond.
    assert!(texts(&figure).contains(&"sliding"));
    // Numbers below zero, and a present value far off.
    let below: Vec<_> = [-4.0, -2.0, 0.0, 3.0]
        .map(|at| column(at, &[((-9.0, None), (2e-3 * at, Some("sliding")))], None))
        .into();
    assert_tidy(&below, (1.0, 0.02));
    assert_tidy(&below, (1.0, 1e6));
}

#[test]
fn without_a_boundary_there_is_no_picture() {
    assert_eq!(
        draw(
            &[column(0.1, &[((1.0, None), (5.0, None))], None), column(0.2, &[], Some("sliding"))],
            (0.1, 2.0)
        ),
        None
    );
    assert_eq!(draw(&[], (0.1, 2.0)), None);
}

/// On a screen it is as wide as is asked, a telephone's width too, and its words stand beside it.
#[test]
fn on_a_screen_it_is_laid_out_at_its_width() {
    let stretch = |mu: f64| [((6.0 / mu, Some("sliding")), (40.0, None))];
    let columns = [0.3, 0.45, 0.6, 0.9, 1.2].map(|mu| column(mu, &stretch(mu), None));
    let across = SetAxis { words: "friction", symbol: "μ", unit: "", present: 0.6 };
    let up = SetAxis { words: "width", symbol: "w", unit: "m", present: 9.0 };
    let set = FeasibleSet { title: "A block", caption: "Shaded: it rests.", across, up, columns: &columns };
    for width in [300.0, 340.0, 560.0] {
        let figure = feasible_set_on_screen(&set, width).expect("a boundary");
        assert!((figure.size().0 - width).abs() < 1.0, "{:?}", figure.size());
        assert_eq!(figure.caption(), "Shaded: it rests. Along the boundary: sliding.");
        assert!(figure.svg().contains("var(--feasible,") && !figure.svg().contains("<style>"));
        let (wide, high) = figure.size();
        let page = Rect { x0: 0.0, y0: 0.0, x1: wide, y1: high };
        assert!(figure.labels().iter().all(|label| page.contains(&label.rect) && label.text != "A block"));
        assert!(texts(&figure).contains(&"target met") && texts(&figure).contains(&"present"));
    }
}
