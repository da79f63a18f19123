//! Figures of probabilities: labels keep apart and on the page whatever the numbers are, and what is drawn lies where its number says.

use standfast::Mode;
use standfast_figures::{
    Chance, ChanceCloud, ChanceGroup, ChanceLine, ChanceLines, ChanceMark, ChanceRow, ChanceRows, CloudPanel,
    Figure, Importance, LineLook, Rect, SpectrumAxis, Tornado, chance_cloud, chance_lines, chance_rows,
    chance_tornado,
};

fn assert_tidy(figure: &Figure) {
    let (width, height) = figure.size();
    let page = Rect { x0: 1.0, y0: 1.0, x1: width - 1.0, y1: height - 1.0 };
    let labels = figure.labels();
    for (i, label) in labels.iter().enumerate() {
        assert!(page.contains(&label.rect), "{label:?} leaves the page of {:?}", figure.title());
        for other in &labels[i + 1..] {
            let apart = !label.rect.overlaps(&other.rect);
            assert!(apart, "{label:?} touches {other:?} in {:?}", figure.title());
        }
    }
    assert!(!figure.svg().contains("NaN") && !figure.svg().contains("inf"), "{:?}", figure.title());
}

fn certain(value: f64) -> Chance {
    Chance { value, low: value, high: value }
}

fn within(value: f64) -> Chance {
    Chance { value, low: 0.7 * value, high: (1.4 * value).min(1.0) }
}

#[test]
fn rows_are_tidy_for_any_probabilities() {
    let sets: [&[f64]; 6] = [
        &[1.0, 0.0, 0.0],
        &[0.97, 0.02, 3e-9],
        &[0.5, 0.5, 1e-300],
        &[0.3, 0.3, 0.4],
        &[1.0, 1e-12, 2e-5],
        &[],
    ];
    for values in sets {
        for make in [certain, within] {
            let modes = [Mode::Rest, Mode::SlideRockOLeft, Mode::SlideRockOPrimeLeft];
            let rows: Vec<ChanceRow<'_>> = values
                .iter()
                .zip(modes)
                .map(|(p, mode)| ChanceRow { mode: Some(mode), words: mode.words(), chance: make(*p) })
                .chain([ChanceRow {
                    mode: None,
                    words: "never met",
                    chance: Chance { value: 0.0, low: 0.0, high: 3e-4 },
                }])
                .collect();
            let groups = [
                ChanceGroup { heading: "Under the loads of one event", rows: &rows },
                ChanceGroup { heading: "At least once in 50 years", rows: &rows },
            ];
            assert_tidy(&chance_rows(&ChanceRows {
                title: "A body",
                caption: "By counting.",
                groups: &groups,
            }));
        }
    }
}

#[test]
fn what_matters_is_tidy_for_any_names_and_probabilities() {
    for probability in [1.0f64, 0.3, 2e-2, 4e-9, 1e-300, 0.0] {
        for share in [0.0f64, 1e-9, 0.2, 1.0, 4.0] {
            let name = "load.a load with a very long name indeed.force";
            let numbers = [
                Importance { name, alpha2: 0.9999, known: (share * probability).min(1.0) },
                Importance { name: "k", alpha2: 1e-9, known: probability },
            ];
            let chart = Tornado { title: "A body", caption: "Ranked.", probability, numbers: &numbers };
            assert_tidy(&chance_tornado(&chart));
        }
    }
}

fn lines_over(across: SpectrumAxis<'_>, up: SpectrumAxis<'_>, values: &[f64], marks: &[f64]) -> Figure {
    let last = (values.len() - 1) as f64;
    let x = |i: usize| {
        let share = i as f64 / last;
        if across.logarithmic {
            across.from * (across.to / across.from).powf(share)
        } else {
            across.from + share * (across.to - across.from)
        }
    };
    let points: Vec<_> = values.iter().enumerate().map(|(i, p)| (x(i), within(*p))).collect();
    let lines = [
        ChanceLine { name: "does not rest", look: LineLook::Answer, points: points.clone() },
        ChanceLine { name: "lognormal", look: LineLook::Fit, points: points.clone() },
        ChanceLine { name: Mode::SlideRockOLeft.words(), look: LineLook::Mode(Mode::SlideRockOLeft), points },
    ];
    let marks: Vec<_> = marks.iter().map(|at| ChanceMark { at: *at, words: "0.10 m: 0.27" }).collect();
    chance_lines(&ChanceLines {
        title: "A body",
        caption: "Lines.",
        across,
        up,
        lines: &lines,
        marks: &marks,
    })
}

#[test]
fn lines_are_tidy_on_any_axis() {
    let axis = |from, to, logarithmic| SpectrumAxis { name: "slide (m)", from, to, logarithmic };
    let values = [0.0, 1e-9, 3e-4, 0.2, 1.0];
    for across in
        [axis(0.0, 1.0, false), axis(1e-4, 1e3, true), axis(8192.0, 4e6, true), axis(-3.0, 1e6, false)]
    {
        for up in [
            axis(0.0, 1.0, false),
            axis(1e-12, 1.0, true),
            axis(1e-3, 1e-2, true),
            axis(0.0249, 0.0252, false),
        ] {
            let from = across.from.max(0.0);
            let marks = [from + 0.1, from + 0.1001, from + 0.3, 1e9];
            assert_tidy(&lines_over(across, up, &values, &marks));
        }
    }
}

#[test]
fn clouds_are_tidy() {
    let axis = |name| SpectrumAxis { name, from: 0.0, to: 1.0, logarithmic: false };
    let points: Vec<(f64, f64)> =
        (0..200).map(|i| (f64::from(i % 17) / 17.0, f64::from(i % 23) / 20.0)).collect();
    let modes: Vec<Option<Mode>> =
        (0..200).map(|i| Mode::ALL.get(i % 12).copied().filter(|_| i % 12 < Mode::ALL.len())).collect();
    for count in 1..=2 {
        let panels: Vec<CloudPanel<'_>> = [("force $k$", "friction $μ$"), ("force $k$", "elevation $k′$")]
            .into_iter()
            .take(count)
            .map(|(across, up)| CloudPanel {
                across: axis(across),
                up: axis(up),
                areas: vec![(Mode::SlideLeft, vec![(0.0, 0.0), (0.5, 0.0), (0.5, 0.9)])],
                points: points.clone(),
            })
            .collect();
        let chart = ChanceCloud { title: "Draws", caption: "200 draws.", panels: &panels, modes: &modes };
        assert_tidy(&chance_cloud(&chart));
    }
}

/// The corners of every closed rectangle with this colour, in the order in which they are drawn.
fn rectangles(figure: &Figure, colour: &str) -> Vec<[f64; 4]> {
    let is = |line: &&str| line.contains(&format!("fill=\"{colour}\"")) && line.contains("Z\"");
    let read = |line: &str| {
        let data = line.split_once("d=\"M").unwrap().1.split_once('Z').unwrap().0;
        let numbers: Vec<f64> =
            data.split(['L', ' ']).map(|number| number.parse().expect("a number")).collect();
        [numbers[0], numbers[1], numbers[4], numbers[5]]
    };
    figure.svg().lines().filter(is).map(read).collect()
}

/// On an axis of equal factors a probability a hundred times as small is two decades to the left: 10⁻² lies half as far as 1 where
/// the axis begins at 10⁻⁴.
#[test]
fn a_point_lies_where_its_probability_is() {
    let row = |mode: Mode, p| ChanceRow { mode: Some(mode), words: mode.words(), chance: certain(p) };
    let rows = [row(Mode::Rest, 1.0), row(Mode::SlideLeft, 1e-2), row(Mode::RockO, 2.1e-4)];
    let groups = [ChanceGroup { heading: "One event", rows: &rows }];
    let figure = chance_rows(&ChanceRows { title: "", caption: "", groups: &groups });
    let place = |property: &str| {
        let (_, colour, _) =
            standfast_figures::colours().find(|colour| colour.0 == property).expect("a colour");
        let [x0, _, x1, _] = rectangles(&figure, colour)[0];
        (x0 + x1) / 2.0
    };
    let [one, hundredth, rare] = ["rest", "slide", "rock"].map(place);
    let decade = (one - hundredth) / 2.0;
    assert!(decade > 100.0, "{decade}");
    assert!((one - rare - decade * -(2.1e-4f64.log10())).abs() < 0.02, "{one} {hundredth} {rare}");
}

/// What a caption or a title says in the characters of a keyboard is set as it is in a plot.
#[test]
fn powers_and_symbols_of_modes_are_set() {
    let figure = chance_rows(&ChanceRows {
        title: "Of SRO'+ and SL",
        caption: "Not drawn, each rarer than 4.216e-14: RO, SRO-, SRO'+, FL. A key_e4 and (2.5e+3) stay words.",
        groups: &[],
    });
    assert_eq!(figure.title(), "Of SRO′₊ and SL");
    assert_eq!(
        figure.caption(),
        "Not drawn, each rarer than 4.216 × 10^−14: RO, SRO₋, SRO′₊, FL. A key_e4 and (2.5 × 10^3) stay words."
    );
    assert_tidy(&figure);
}
