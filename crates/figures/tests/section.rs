//! A section is tidy and to scale, whatever stands in it.

use standfast::loads::Face;
use standfast_figures::{
    Arrow, BaseReaction, FailureSketch, Figure, Level, Material, Measure, Mound, Outline, Pressed, Rect,
    Section, Side, Stated, section,
};

/// Numbers from 0 to 1, the same in every run.
struct Dice(u64);

impl Dice {
    fn roll(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn up_to(&mut self, count: u32) -> u32 {
        (self.roll() * f64::from(count + 1)) as u32
    }
}

fn block(width: f64, height: f64) -> Outline {
    let half = width / 2.0;
    Outline {
        vertices: vec![(-half, 0.0), (half, 0.0), (half, height), (-half, height)],
        material: Material::Solid,
        label: String::new(),
    }
}

fn bare(parts: &[Outline], width: f64) -> Section<'_> {
    Section {
        title: "any",
        parts,
        joints: Vec::new(),
        base: (-width / 2.0, width / 2.0),
        centroid: (0.0, 1.0),
        levels: Vec::new(),
        pressures: Vec::new(),
        arrows: Vec::new(),
        widths: Vec::new(),
        heights: Vec::new(),
        mound: None,
        is_on_soil: false,
        backfills: Vec::new(),
        wave_crest: None,
        reaction: None,
        friction: None,
        ground: None,
        plan: None,
        notes: Vec::new(),
    }
}

fn pressed(dice: &mut Dice, (width, height): (f64, f64)) -> Pressed {
    let face = [Face::Left, Face::Right, Face::Base, Face::Top][dice.up_to(3) as usize];
    let along = if matches!(face, Face::Left | Face::Right) { height } else { width };
    let count = 2 + dice.up_to(4);
    let mut positions: Vec<_> = (0..count).map(|_| along * dice.roll()).collect();
    positions.sort_by(f64::total_cmp);
    let points = positions.into_iter().map(|position| {
        let pressure = (1e5 * (dice.roll() - 0.3)).round();
        (position, pressure, format!("{} kPa", pressure / 1e3))
    });
    Pressed {
        face,
        points: points.collect(),
        words: "a pressure with a name of some length, 120 kN/m".to_owned(),
    }
}

fn arrow(dice: &mut Dice, (width, height): (f64, f64)) -> Arrow {
    let towards = [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)][dice.up_to(3) as usize];
    Arrow {
        at: (width * (dice.roll() - 0.5), 1.3 * height * dice.roll()),
        towards,
        is_inside: dice.roll() < 0.2,
        size: 1e6 * dice.roll(),
        label: "1234 kN/m".to_owned(),
        words: "force, 1234 kN/m".to_owned(),
    }
}

fn stated(name: &str, value: &str, unit: &str) -> Stated {
    let symbol = name.split_at(name.find('$').unwrap()).1.to_owned();
    Stated { name: name.to_owned(), symbol, value: value.to_owned(), unit: unit.to_owned() }
}

/// A failure to the left, under a width and beyond it.
fn failure(from: f64, to: f64) -> FailureSketch {
    let width = to - from;
    let tip = (from + width / 2.0, -width);
    let surface = vec![(to, 0.0), tip, (from - width, -1.5 * width), (from - 4.0 * width, 0.0)];
    let lines = vec![surface, vec![(from, 0.0), tip]];
    FailureSketch { lines, near: from, out: -1.0, label: "ground fails this way (a sketch)".to_owned() }
}

/// A section of anything.
fn random(dice: &mut Dice, parts: &[Outline], (width, height): (f64, f64)) -> Figure {
    let size = (width, height);
    let level = |side, elevation: f64| Level {
        side,
        elevation,
        label: format!("level {elevation:+.2} m"),
        is_water: elevation > 0.0,
    };
    let levels = (0..dice.up_to(6)).map(|i| {
        let side = if i % 2 == 0 { Side::Left } else { Side::Right };
        level(side, height * (1.4 * dice.roll() - 0.4))
    });
    let levels = levels.collect();
    let measure = |from: f64, to: f64| Measure { ends: (from, to), label: format!("{:.3} m", to - from) };
    let given = Section {
        levels,
        pressures: (0..dice.up_to(6)).map(|_| pressed(dice, size)).collect(),
        arrows: (0..dice.up_to(5)).map(|_| arrow(dice, size)).collect(),
        widths: vec![vec![measure(-width / 2.0, 0.0), measure(0.0, width / 2.0)], vec![measure(0.0, width)]],
        heights: vec![vec![measure(0.0, height)], vec![measure(0.0, 0.1 * height), measure(0.2, height)]],
        mound: (dice.roll() < 0.5).then(|| Mound {
            bed: -height * dice.roll(),
            berm: height * (dice.roll() - 0.5),
            berm_width: 3.0 * width * dice.roll(),
        }),
        reaction: (dice.roll() < 0.5).then(|| {
            let (one, other) = (width * (dice.roll() - 0.5), width * (dice.roll() - 0.5));
            BaseReaction {
                at: (one + other) / 2.0,
                size: 1e6 * dice.roll(),
                pressed: (one.min(other), one.max(other)),
                neutral: (dice.roll() < 0.5).then_some(one.max(other)),
                labels: vec!["2319 kN/m comes,".to_owned(), "2100 kN/m is borne".to_owned()],
                width: Some("B′ 8.337 m".to_owned()),
                failure: (dice.roll() < 0.5).then(|| failure(one.min(other), one.max(other))),
            }
        }),
        friction: (dice.roll() < 0.7).then(|| stated("friction $μ$", "0.6", "")),
        ground: (dice.roll() < 0.5).then(|| stated("strength $q_u$", "600", " kPa")),
        plan: None,
        is_on_soil: dice.roll() < 0.5,
        wave_crest: (dice.roll() < 0.3).then(|| 2.0 * height * dice.roll()),
        centroid: (0.3 * width * (dice.roll() - 0.5), height * (0.2 + 0.6 * dice.roll())),
        notes: vec!["A sentence below all.".to_owned()],
        ..bare(parts, width)
    };
    section(&given)
}

fn assert_tidy(figure: &Figure, what: &str) {
    let (width, height) = figure.size();
    let page = Rect { x0: 1.0, y0: 1.0, x1: width - 1.0, y1: height - 1.0 };
    let labels = figure.labels();
    for (i, label) in labels.iter().enumerate() {
        assert!(page.contains(&label.rect), "{what}: {label:?} leaves the page {page:?}");
        for other in &labels[i + 1..] {
            assert!(!label.rect.overlaps(&other.rect), "{what}: {label:?} touches {other:?}");
        }
    }
}

#[test]
fn no_label_lies_on_another_whatever_is_drawn() {
    let mut dice = Dice(11);
    let mut labels = 0;
    for i in 0..2000 {
        let size = (0.2 + 30.0 * dice.roll(), 0.2 + 30.0 * dice.roll());
        let figure = random(&mut dice, &[block(size.0, size.1)], size);
        assert_tidy(&figure, &format!("{i}, {size:?}"));
        labels += figure.labels().len();
    }
    assert!(labels > 30_000, "{labels}");
}

/// Widths and heights that the figure writes are the lengths on the page.
#[test]
fn lengths_are_to_one_scale() {
    let parts = [block(4.0, 8.0)];
    let levels = [0.0, 3.0, 8.0].map(|elevation| Level {
        side: Side::Left,
        elevation,
        label: format!("level {elevation}"),
        is_water: false,
    });
    let arrows = [-1.0, 1.0].map(|x| Arrow {
        at: (x, 8.0),
        towards: (0.0, -1.0),
        is_inside: false,
        size: 1.0,
        label: format!("{x} N"),
        words: String::new(),
    });
    let figure = section(&Section { levels: levels.to_vec(), arrows: arrows.to_vec(), ..bare(&parts, 4.0) });
    let at = |text: &str| {
        let found = figure.labels().iter().find(|label| label.text.ends_with(text));
        found.unwrap_or_else(|| panic!("{text} in {:?}", figure.labels())).rect.centre()
    };
    let per_metre = (at("level 0").1 - at("level 8").1) / 8.0;
    assert!(per_metre > 10.0);
    assert!((at("level 0").1 - at("level 3").1 - 3.0 * per_metre).abs() < 1e-9);
    let across = (at(" 1 N").0 - at("-1 N").0) / 2.0;
    // The labels of the forces may be spread.
    assert!(across >= per_metre - 1e-9);
}

/// The ends of the lines of this look, from left and right.
fn lines(figure: &Figure, look: &str) -> Vec<[(f64, f64); 2]> {
    // What is no straight line from place to place has no two numbers.
    let read = |line: &str| {
        let data = line.split_once("d=\"M").expect("a path").1.split_once('"').expect("its end").0;
        let (from, to) = data.split_once('L')?;
        let place = |text: &str| {
            let (x, y) = text.split_once(' ')?;
            Some((x.parse().ok()?, y.parse().ok()?))
        };
        Some([place(from)?, place(to)?])
    };
    figure.svg().lines().filter(|line| line.contains(look)).filter_map(read).collect()
}

/// Arrows of forces of 60, 40 and 20 are as 3 : 2 : 1, heads among them.
#[test]
fn arrows_of_forces_are_to_one_scale() {
    let parts = [block(4.0, 8.0)];
    let arrow = |elevation: f64, size: f64| Arrow {
        at: (2.0, elevation),
        towards: (-1.0, 0.0),
        is_inside: false,
        size,
        label: format!("{size} N"),
        words: String::new(),
    };
    let arrows = vec![arrow(2.0, 60.0), arrow(4.0, 40.0), arrow(6.0, 20.0)];
    let figure = section(&Section { arrows, ..bare(&parts, 4.0) });
    let strong = lines(&figure, "stroke=\"#a3123f\" stroke-width=\"2\"");
    // The line ends inside the head, six units before its tip.
    let lengths: Vec<f64> = strong.iter().map(|[tail, end]| (tail.0 - end.0).abs() + 6.0).collect();
    assert_eq!(lengths.len(), 3);
    assert!(
        (lengths[0] - 3.0 * lengths[2]).abs() < 0.1 && (lengths[1] - 2.0 * lengths[2]).abs() < 0.1,
        "{lengths:?}"
    );
}

/// A force on a stem that stands back from the toe of its footing ends on the stem.
#[test]
fn a_force_ends_on_the_face_that_it_pushes() {
    let at = |left: f64, right: f64, bottom: f64, top: f64| Outline {
        vertices: vec![(left, bottom), (right, bottom), (right, top), (left, top)],
        material: Material::Solid,
        label: String::new(),
    };
    let parts = [at(-3.0, 3.0, 0.0, 1.0), at(-2.0, -1.0, 1.0, 5.0)];
    let arrow = Arrow {
        at: (3.0, 3.0),
        towards: (-1.0, 0.0),
        is_inside: false,
        size: 1.0,
        label: "1 N".to_owned(),
        words: String::new(),
    };
    let widths = vec![vec![Measure { ends: (-3.0, 3.0), label: "6 m".to_owned() }]];
    let figure = section(&Section { arrows: vec![arrow], widths, ..bare(&parts, 6.0) });
    let [tail, end] = lines(&figure, "stroke=\"#a3123f\" stroke-width=\"2\"")[0];
    let tip = end.0 - 6.0;
    let [left, right] = lines(&figure, "stroke-width=\"0.8\"")[0];
    let metre = (right.0 - left.0) / 6.0;
    assert!(tail.0 > tip && (tip - (left.0 + 2.0 * metre)).abs() < 2.0, "{tip} {left:?} {metre}");
}

#[test]
fn parts_are_named_where_there_is_room() {
    let mut wall = block(10.0, 8.0);
    wall.label = "wall".to_owned();
    let mut fill = block(2.0, 0.1);
    (fill.material, fill.label) = (Material::Fill, "sand".to_owned());
    let figure = section(&bare(&[wall, fill], 10.0));
    let texts: Vec<_> = figure.labels().iter().map(|label| label.text.as_str()).collect();
    assert!(texts.contains(&"wall") && !texts.contains(&"sand"), "{texts:?}");
    assert_tidy(&figure, "parts");
}

/// A part too small for its name has it beside the body, joined by a line.
#[test]
fn a_small_part_is_named_beside_the_body() {
    let mut wall = block(10.0, 4.0);
    wall.label = "wall".to_owned();
    let step = Outline {
        vertices: vec![(4.6, 4.0), (5.0, 4.0), (5.0, 4.4), (4.6, 4.4)],
        material: Material::Solid,
        label: "step of the wall".to_owned(),
    };
    let widths = vec![vec![Measure { ends: (-5.0, 5.0), label: "10 m".to_owned() }]];
    let figure = section(&Section { widths, ..bare(&[wall, step], 10.0) });
    let label = figure.labels().iter().find(|label| label.text == "step of the wall").expect("its name");
    // Above the wall, or right of it: its right edge is where the width ends.
    let [_, right] = lines(&figure, "stroke-width=\"0.8\"")[0];
    let width = right.0 - lines(&figure, "stroke-width=\"0.8\"")[0][0].0;
    // The middle of the step is 0.2 m of the 10 from the right.
    let heart = right.0 - 0.02 * width;
    let leaders = lines(&figure, "stroke-width=\"0.7\"");
    assert!(leaders.iter().any(|[_, to]| (to.0 - heart).abs() < 0.02), "{leaders:?} {heart}");
    assert!(
        label.rect.x0 > right.0
            || label.rect.y1 < figure.labels().iter().find(|label| label.text == "wall").unwrap().rect.y0,
        "{label:?}"
    );
    assert_tidy(&figure, "a small part");
}

/// Water stands at both sides up to its levels; a wave falls from its crest at the wall to the water at the right.
#[test]
fn water_stands_on_both_sides_and_the_wave_falls_to_it() {
    let parts = [block(10.0, 8.0)];
    let level =
        |side: Side, elevation: f64| Level { side, elevation, label: "water".to_owned(), is_water: true };
    let heights = vec![vec![Measure { ends: (0.0, 8.0), label: "8 m".to_owned() }]];
    let given = Section {
        levels: vec![level(Side::Left, 3.0), level(Side::Right, 5.0)],
        wave_crest: Some(9.0),
        heights,
        ..bare(&parts, 10.0)
    };
    let figure = section(&given);
    let (_, water, _) = standfast_figures::colours().find(|colour| colour.0 == "water").expect("a colour");
    let filled: Vec<Vec<(f64, f64)>> = figure
        .svg()
        .lines()
        .filter(|line| line.starts_with("<path") && line.contains(&format!("fill=\"{water}\"")))
        .map(|line| {
            let data = line.split_once("d=\"M").expect("a path").1.split_once('Z').expect("its end").0;
            let place =
                |text: &str| text.split_once(' ').map(|(x, y)| (x.parse().unwrap(), y.parse().unwrap()));
            data.split('L').filter_map(place).collect()
        })
        .collect();
    let [left, right, wave] = &filled[..] else { panic!("{filled:?}") };
    // The height of the body, written out along a line.
    let upright = lines(&figure, "stroke-width=\"0.8\"");
    let [from, to] = upright.iter().find(|[from, to]| from.0 == to.0).expect("a height");
    let (base, metre) = (from.1.max(to.1), (from.1 - to.1).abs() / 8.0);
    let top = |area: &[(f64, f64)]| area.iter().map(|place| place.1).fold(f64::INFINITY, f64::min);
    for (area, height) in [(left, 3.0), (right, 5.0), (wave, 9.0)] {
        assert!((base - top(area) - height * metre).abs() < 0.03, "{area:?} {height}");
    }
    let ends = |area: &[(f64, f64)]| {
        let xs = area.iter().map(|place| place.0);
        (xs.clone().fold(f64::INFINITY, f64::min), xs.fold(f64::NEG_INFINITY, f64::max))
    };
    // One ends at the left wall, the others begin at the right one, ten metres on.
    assert!((ends(right).0 - ends(left).1 - 10.0 * metre).abs() < 0.03);
    assert_eq!(ends(wave), ends(right));
    // The surface falls all the way, to the still water at its end.
    let surface = &wave[..wave.len() - 1];
    assert!(surface.windows(2).all(|pair| pair[0].0 < pair[1].0 && pair[0].1 <= pair[1].1), "{surface:?}");
    assert!((surface[surface.len() - 1].1 - top(right)).abs() < 0.02);
    // Without a crest there is no wave; what is no water is not filled.
    let calm = section(&Section { wave_crest: None, ..given.clone() });
    assert_eq!(calm.svg().matches(&format!("fill=\"{water}\"/>")).count(), 2);
}

/// Items beyond the page are not silently drawn elsewhere, and do not make the page grow.
#[test]
fn what_is_drawn_nearer_is_said_to_be() {
    let parts = [block(10.0, 8.0)];
    let says = |section_of: Section<'_>| {
        let figure = section(&section_of);
        assert!(figure.size().0 < 800.0 && figure.size().1 < 800.0, "{:?}", figure.size());
        figure.labels().iter().any(|label| label.text.contains("nearer than to scale"))
    };
    let mound = |bed: f64, berm_width: f64| {
        says(Section { mound: Some(Mound { bed, berm: 0.5, berm_width }), ..bare(&parts, 10.0) })
    };
    assert!(!mound(-2.0, 4.0) && mound(-40.0, 4.0) && mound(-2.0, 80.0));
    let force = |x: f64, y: f64, towards: (f64, f64)| {
        let words = "force".to_owned();
        let arrow =
            Arrow { at: (x, y), towards, is_inside: false, size: 1.0, label: "1 kN/m".to_owned(), words };
        says(Section { arrows: vec![arrow], ..bare(&parts, 10.0) })
    };
    assert!(!force(0.0, 9.0, (-1.0, 0.0)) && force(0.0, 900.0, (-1.0, 0.0)));
    assert!(!force(-6.0, 8.0, (0.0, -1.0)) && force(-60.0, 8.0, (0.0, -1.0)));
}
