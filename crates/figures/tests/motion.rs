//! Motions and spectra: what moves is where its numbers say, at the time that the clock says, and nothing moves for those who want no motion.

use standfast::Mode;
use standfast_figures::{
    ChanceMark, Figure, MotionOutline, MotionPicture, MotionPose, SpectrumAxis, SpectrumLines,
    motion_animation, motion_histories, motion_histories_on_screen, spectrum_lines,
};

const OUTLINE: MotionOutline = MotionOutline { b1: 1.0, b2: 1.0, d: 2.0, height: 4.0 };
const STATES: [(f64, Mode); 3] = [(0.0, Mode::Rest), (12.0, Mode::SlideLeft), (14.0, Mode::Rest)];
/// Half of the largest acceleration to the left, all of it to the right, none.
const GROUND: [(f64, f64); 4] = [(11.0, 0.0), (12.0, -0.2), (13.0, 0.4), (15.0, 0.0)];

/// A slide from 12 to 14 s, shown from 11 to 15.
fn animation() -> Figure {
    let picture = MotionPicture {
        title: "A block",
        caption: "It slides.",
        outline: OUTLINE,
        begin: 11.0,
        end: 15.0,
        time_unit: "s",
        length_unit: "m",
        states: &STATES,
        loads: &[],
        slide: &[],
        theta: &[],
        ground: &GROUND,
        balance: [0.4, -0.4],
    };
    let pose = |t: f64, slide: f64, mode| MotionPose { t, x: slide, y: 2.0, theta: 0.0, slide, mode };
    let poses = [
        pose(11.0, 0.0, Mode::Rest),
        pose(12.0, 0.0, Mode::SlideLeft),
        pose(13.0, -1.0, Mode::SlideLeft),
        pose(14.0, -1.5, Mode::Rest),
        pose(15.0, -1.5, Mode::Rest),
    ];
    motion_animation(&picture, &poses)
}

/// Attribute of an element.
fn attribute<'a>(element: &'a str, name: &str) -> Option<&'a str> {
    let (_, rest) = element.split_once(&format!(" {name}=\""))?;
    rest.split_once('"').map(|(value, _)| value)
}

/// An animation's value at a moment of its run, in seconds, in steps.
fn value_at(element: &str, t: f64) -> String {
    let read = |name: &str| attribute(element, name).expect(name);
    let duration: f64 = read("dur").trim_end_matches('s').parse().expect("seconds");
    let times: Vec<f64> = read("keyTimes").split(';').map(|time| time.parse().expect("a share")).collect();
    let values: Vec<&str> = read("values").split(';').collect();
    assert_eq!(times.len(), values.len(), "{element}");
    assert!(times[0] == 0.0 && times[times.len() - 1] == 1.0 && times.is_sorted(), "{element}");
    values[times.iter().rposition(|time| *time <= t / duration + 1e-6).expect("a time")].to_owned()
}

/// The digits that are seen at a moment of the run, from the left.
fn clock(figure: &Figure, t: f64) -> String {
    let mut seen: Vec<(f64, char)> = Vec::new();
    for group in figure.svg().split("<g class=\"sf-moving\" opacity=\"").skip(1) {
        let (first, rest) = group.split_once('"').expect("an opacity");
        let group = rest.split_once("</g>\n").expect("its end").0;
        let shown = match group.split_once("<animate ") {
            Some((_, animate)) => value_at(&format!(" {animate}"), t),
            None => first.to_owned(),
        };
        let place = group.split_once("translate(").expect("a place").1.split_once(' ').expect("x").0;
        let code = group.split_once("#sf-r").expect("a glyph").1.split_once('"').expect("its end").0;
        let letter = u32::from_str_radix(code, 16).ok().and_then(char::from_u32).expect("a letter");
        if shown == "1" {
            seen.push((place.parse().expect("x"), letter));
        }
    }
    seen.sort_by(|one, other| one.0.total_cmp(&other.0));
    seen.into_iter().map(|(_, letter)| letter).collect()
}

/// The run begins at the first moment shown, and the clock reads tenths, cut off.
#[test]
fn the_clock_reads_the_time_of_the_motion() {
    let figure = animation();
    for (run, read) in [
        (0.0, "110"),
        (0.05, "110"),
        (0.1, "111"),
        (0.95, "119"),
        (1.0, "120"),
        (3.31, "143"),
        (4.0, "150"),
        (5.4, "150"),
    ] {
        assert_eq!(clock(&figure, run), read, "{run} s after the beginning");
    }
}

/// What moves stands in groups that are not shown to readers who want no motion; what they see instead stands still.
#[test]
fn nothing_moves_for_readers_who_want_no_motion() {
    let figure = animation();
    let svg = figure.svg();
    assert!(svg.contains(
        "@media (prefers-reduced-motion:reduce){svg.standfast .sf-moving{display:none}svg.standfast .sf-still{display:inline}}"
    ));
    let mut open: Vec<&str> = Vec::new();
    let (mut moving, mut still) = (0, 0);
    for element in svg.split('<').skip(1) {
        match element {
            _ if element.starts_with("g ") => open.push(attribute(element, "class").unwrap_or("")),
            _ if element.starts_with("/g>") => drop(open.pop()),
            _ if element.starts_with("animate") => {
                assert!(open.contains(&"sf-moving") && !open.contains(&"sf-still"), "{element}");
                moving += 1;
            }
            _ => still += usize::from(open.contains(&"sf-still") && element.starts_with("path")),
        }
    }
    assert!(open.is_empty() && moving > 8 && still > 0, "{open:?} {moving} {still}");
    // They see the clock at the end, and the body where it ends: 1.5 to the left.
    let groups: Vec<&str> = svg.split("<g class=\"sf-still\" display=\"none\"").skip(1).collect();
    let places = |kind: &str| -> Vec<f64> {
        let of = svg.split(kind).skip(1);
        of.filter_map(|rest| rest.split_once("transform=\"translate(")?.1.split(' ').next()?.parse().ok())
            .collect()
    };
    let body = places("<g class=\"sf-still\"")[0];
    assert_eq!(places("<g class=\"sf-moving\"")[0], body);
    let digits = groups.iter().filter(|group| group.contains("#sf-r3")).count();
    assert!(digits >= 3, "{digits}");
}

/// The arrow of the ground is as long as its acceleration over the largest, to its side, at its time; 4 s and a pause of 1.5.
#[test]
fn the_arrow_of_the_ground_is_its_acceleration() {
    let figure = animation();
    let arrow = figure.svg().split("type=\"scale\"").nth(1).expect("an arrow");
    let arrow = arrow.split_once("/>").expect("its end").0;
    for (t, share) in [(0.0, 0.001), (1.0, -0.5), (2.0, 1.0), (4.0, 0.001)] {
        assert_eq!(value_at(arrow, t), format!("{share:.3} 1"), "{t}");
    }
    assert_eq!(attribute(arrow, "dur"), Some("5.500s"));
    assert!(figure.labels().iter().any(|label| label.text.contains("0.4")), "{:?}", figure.labels());
}

/// Runs of finite points are lines; a point alone is a dot; beside a point without bound stands a ring, once for each end.
#[test]
fn ends_before_what_has_no_bound_are_ringed() {
    let over = f64::INFINITY;
    let heights = [0.1, 0.3, over, over, 0.6, over, 0.5, 0.4];
    let points: Vec<(f64, f64)> = heights.iter().enumerate().map(|(i, y)| (i as f64, *y)).collect();
    let axis = |name, to| SpectrumAxis { name, from: 0.0, to, logarithmic: false };
    let figure = spectrum_lines(&SpectrumLines {
        title: "A body",
        caption: "It stands.",
        across: axis("factor", 7.0),
        up: axis("rotation", 1.0),
        lines: &[("where it stands", points)],
        shaded: (&[[1.5, 3.5], [4.5, 5.5]], "it overturns"),
        marks: &[ChanceMark { at: 1.0, words: "this shaking" }],
    });
    let circles: Vec<(f64, f64)> = figure
        .svg()
        .split("<circle cx=\"")
        .skip(1)
        .map(|circle| {
            let mut parts = circle.split('"');
            (parts.next().unwrap().parse().unwrap(), parts.nth(3).unwrap().parse().unwrap())
        })
        .collect();
    let rings: Vec<f64> = circles.iter().filter(|circle| circle.1 == 3.0).map(|circle| circle.0).collect();
    let dots: Vec<f64> = circles.iter().filter(|circle| circle.1 == 1.6).map(|circle| circle.0).collect();
    // At 1, 4 and 6, and one in the key; the point at 4 is alone.
    let [one, four, six, _] = rings[..] else { panic!("{rings:?}") };
    assert!((four - one) - 1.5 * (six - four) < 0.03 && dots == [four], "{rings:?} {dots:?}");
    assert!(figure.labels().iter().any(|label| label.text == "this shaking"));
}

/// A motion of many states over 8 s, all of which occur.
fn many_states() -> Vec<(f64, Mode)> {
    Mode::ALL.into_iter().enumerate().map(|(i, mode)| (0.7 * i as f64, mode)).collect()
}

fn of_many<'a>(
    states: &'a [(f64, Mode)],
    slide: &'a [(f64, f64)],
    theta: &'a [(f64, f64)],
) -> MotionPicture<'a> {
    MotionPicture {
        title: "A block",
        caption: "It moves.",
        outline: OUTLINE,
        begin: 1.0,
        end: 9.0,
        time_unit: "s",
        length_unit: "m",
        states,
        loads: &[],
        slide,
        theta,
        ground: &[],
        balance: [0.4, -0.4],
    }
}

/// A tick stands below the strip at each change of the state within what is shown: at (t − 1)/8 of the way.
#[test]
fn a_tick_marks_each_change_of_the_state() {
    let (states, slide, theta) = (many_states(), [(1.0, 0.0), (9.0, 0.5)], [(1.0, 0.0), (9.0, 0.3)]);
    let picture = of_many(&states, &slide, &theta);
    let shown = motion_histories_on_screen(&picture, (600.0, 380.0));
    let (left, width) = (shown.plot.x0, shown.plot.x1 - shown.plot.x0);
    let expected: Vec<f64> =
        states.iter().map(|(t, _)| (t - 1.0) / 8.0).filter(|share| *share > 0.0 && *share <= 1.0).collect();
    assert!(expected.len() > 5);
    let ticks = |svg: &str| -> Vec<Vec<(f64, f64)>> {
        let paths = svg.split("d=\"M").skip(1).filter_map(|rest| rest.split_once('"')).map(|(data, _)| data);
        let number =
            |text: &str| text.split_once(' ').and_then(|(x, y)| Some((x.parse().ok()?, y.parse().ok()?)));
        let lines = paths.map(|data| data.split(['M', 'L']).filter_map(number).collect::<Vec<(f64, f64)>>());
        // Pairs of points one above the other, all as long.
        lines
            .filter(|line| {
                line.len() == 2 * expected.len()
                    && line
                        .chunks(2)
                        .all(|pair| pair[0].0 == pair[1].0 && (pair[1].1 - pair[0].1 - 5.0).abs() < 0.02)
            })
            .collect()
    };
    let found = ticks(shown.figure.svg());
    let [found] = &found[..] else { panic!("{found:?}") };
    for (pair, share) in found.chunks(2).zip(&expected) {
        assert!((pair[0].0 - (left + share * width)).abs() < 0.02, "{pair:?} {share}");
    }
    assert_eq!(ticks(motion_histories(&picture).svg()).len(), 1);
}

/// However narrow, no label of histories on a screen is smaller than twelve units, which are pixels there; and they are as wide as asked.
#[test]
fn histories_can_be_read_on_a_phone() {
    let (states, slide, theta) = (many_states(), [(1.0, 0.0), (9.0, 0.5)], [(1.0, 0.0), (9.0, 0.3)]);
    let picture = of_many(&states, &slide, &theta);
    for size in [(296.0, 230.0), (366.0, 234.0), (598.0, 300.0), (900.0, 560.0)] {
        let figure = motion_histories_on_screen(&picture, size).figure;
        assert_eq!(figure.size().0, size.0);
        let small = figure.labels().iter().find(|label| label.size < 12.0);
        assert_eq!(small, None, "{size:?}");
        let beyond = figure.labels().iter().find(|label| label.rect.x1 > size.0 || label.rect.x0 < 0.0);
        assert_eq!(beyond, None, "{size:?}");
        assert!(figure.labels().iter().any(|label| label.text == "balance"));
    }
}
