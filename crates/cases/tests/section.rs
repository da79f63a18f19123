//! The section of a case shows the numbers of the case.

use std::path::Path;

use standfast::Verdict;
use standfast_cases::layout::digits;
use standfast_cases::{Assessment, AssessmentView, Case, CaseFile, Document};
use standfast_figures::Figure;

fn case(name: &str, text: &str) -> Case {
    CaseFile::parse(name, text).unwrap().case().unwrap()
}

fn example(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name);
    std::fs::read_to_string(path).unwrap()
}

fn section(case: &Case) -> Figure {
    let figures = Assessment::of(case).unwrap().figures(&AssessmentView::default()).unwrap();
    let mut sections = figures.into_iter().filter(|figure| figure.is_section());
    let section = sections.next().unwrap();
    assert_eq!(section.suffix, "-section");
    section.figure
}

fn texts(figure: &Figure) -> Vec<String> {
    figure.labels().iter().map(|label| label.text.clone()).collect()
}

/// Goda's worked example: pressures as published (validation/goda.toml), levels by hand from the depths of the file.
#[test]
fn goda_s_pressures_and_levels_stand_in_the_section() {
    let figure = section(&case("goda-2000.toml", &example("goda-2000.toml")));
    let texts = texts(&figure);
    let number = |text: &str| text.split(' ').next().unwrap().parse::<f64>().ok();
    let pressures: Vec<f64> =
        texts.iter().filter(|text| text.ends_with(" kPa")).filter_map(|text| number(text)).collect();
    let published = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation/goda.toml");
    let published = std::fs::read_to_string(published).unwrap();
    // The first case of the file is the worked example.
    let expected = |key: &str| {
        let line = published.lines().find_map(|line| line.strip_prefix(&format!("{key} = ")));
        line.unwrap().parse::<f64>().unwrap()
    };
    for key in ["p1", "p3", "p4", "pu"] {
        let found = pressures.iter().any(|shown| (shown / expected(key) - 1.0).abs() < 4e-4);
        assert!(found, "{key} {} in {pressures:?}", expected(key));
    }
    // 7.1 m to the base, 5.6 m to the berm, 10.1 m to the bed.
    for level in ["crest +10.5 m", "base ±0 m", "still water +7.1 m", "berm +1.5 m", "sea bed −3 m"] {
        assert!(texts.iter().any(|text| text == level), "{level} in {texts:?}");
    }
    assert!(texts.iter().any(|text| text == "15 m"));
}

/// Every pressure and force of every example, as the library has it.
#[test]
fn every_load_of_the_case_is_drawn_with_its_value() {
    let mut shown = 0;
    for name in ["quay", "trough", "monument", "head-difference", "eccentric-caisson", "block-two-loads"] {
        let case = case(name, &example(&format!("{name}.toml")));
        let figure = section(&case);
        let texts = texts(&figure);
        let mut has = |wanted: String| {
            assert!(texts.iter().any(|text| text.ends_with(&wanted)), "{name}: {wanted} in {texts:?}");
            shown += 1;
        };
        for pressure in &case.pressures {
            for at in pressure.diagram.points().iter().filter(|at| at.pressure != 0.0) {
                has(format!("{} kPa", digits(at.pressure / 1e3)).replace('-', "−"));
            }
            let name = pressure.name.as_ref().unwrap();
            let size = digits(pressure.diagram.resultant().0.abs() / 1e3);
            assert!(figure.caption().contains(&format!("{name}, {size} kN/m")), "{}", figure.caption());
        }
        for force in &case.forces {
            has(format!("{} kN/m", digits(force.magnitude / 1e3)));
            let place = match force.distance {
                Some(distance) => format!("{} m right of O", digits(distance)),
                None => format!("{} m above the base", digits(force.elevation)),
            };
            assert!(figure.caption().contains(&place), "{place} in {}", figure.caption());
        }
        has(format!("crest +{} m", digits(case.body.height())));
        if let Some(water) = &case.water {
            has(format!("water +{} m", digits(water.left())));
            has(format!("water +{} m", digits(water.right())));
            // The bottom of the base at O.
            let pressure = water.density() * case.gravity * water.left() / 1e3;
            has(format!("{} kPa", digits(pressure)));
        }
    }
    assert!(shown > 25, "{shown}");
}

#[test]
fn what_lies_off_the_middle_is_written_out() {
    let texts = texts(&section(&case("monument.toml", &example("monument.toml"))));
    for expected in ["O–C 0.4 m", "C–O′ 0.5 m", "base 0.9 m", "1.1 m", "C 1.7 m", "3.2 m"] {
        assert!(texts.iter().any(|text| text == expected), "{expected} in {texts:?}");
    }
}

/// The reaction lies under the base where equilibrium has it: 8 m × 6 m × 2 t/m³ under a force at half its height, at e = X d/P from the middle, on the
/// side that the force pushes to; the effective width reaches the edge there.
#[test]
fn the_reaction_lies_where_equilibrium_has_it() {
    let drawn = |angle: u32, weight: f64, share: f64, towards: &str| {
        let force = share * 8.0 * 6.0 * 2e3 * 10.0;
        let text = format!(
            "gravity = 10\n[body]\nwidth = 8\nheight = 6\ndensity = 2e3\nfriction = 0.9\n[ground]\nfriction_angle_deg = {angle}\nunit_weight = {weight}\n\
             [[load]]\nforce = {force}\nelevation = 3\ndirection = \"{towards}\"\n"
        );
        let case = case("block.toml", &text);
        let fails = Assessment::of(&case).unwrap().governing().verdict() == Some(Verdict::BearingFailure);
        let figure = section(&case);
        let at = |text: &str| {
            let label = figure.labels().iter().find(|label| label.text == text);
            let rect = label.unwrap_or_else(|| panic!("{text} in {:?}", texts(&figure))).rect;
            (rect.x0 + rect.x1) / 2.0
        };
        // e = 3 m × share; the numbers of both lengths stand in their middle.
        let wide = 8.0 - 6.0 * share;
        let arrows = paths(&figure, &format!("stroke=\"{}\" stroke-width=\"2\"", colour("push")));
        let [arrow] = &arrows[..] else { panic!("{arrows:?}") };
        assert!(arrow[0].0 == arrow[1].0 && arrow[0].1 > arrow[1].1, "{arrow:?} points up");
        assert!(texts(&figure).iter().any(|text| text == "960 kN/m comes,"), "{:?}", texts(&figure));
        (arrow[0].0 - at("8 m"), at(&format!("B′ {} m", digits(wide))) - at("8 m"), fails)
    };
    // Ground that bears the body, and ground that fails under it.
    for (angle, weight) in [(45, 2e4), (20, 1e3)] {
        let (near, width, fails) = drawn(angle, weight, 0.1, "left");
        assert_eq!(fails, angle == 20);
        let (far, _, _) = drawn(angle, weight, 0.2, "left");
        assert!(near < 0.0 && (near - width).abs() < 1.0, "{near} {width}");
        assert!((far / near - 2.0).abs() < 0.05, "{far} {near}");
        let (other, _, _) = drawn(angle, weight, 0.2, "right");
        assert!((other + far).abs() < 1.0, "{other} {far}");
    }
}

/// What comes and what is borne, of a block of 8 m by 6 m and 2 t/m³ on sand under a force at half its height, by the formulas of EN 1997-1 Annex D as
/// the specification has them, worked out here: R = 2B² γ' N_γ (1−ε)² (1−η)³; 960 kN/m comes.
#[test]
fn what_comes_and_what_is_borne_stand_under_the_base() {
    for (angle, weight, share, bears) in [(30.0_f64, 9e3, 0.2, "can be borne"), (24.0, 4e3, 0.3, "is borne")]
    {
        let text = sand(angle, weight, share * 960e3, "left");
        let texts = texts(&section(&case("block.toml", &text)));
        let tan = angle.to_radians().tan();
        let n_q = (std::f64::consts::PI * tan).exp() * (45.0 + angle / 2.0).to_radians().tan().powi(2);
        let n_gamma = 2.0 * (n_q - 1.0) * tan;
        // e = 3 m × share of a half width of 4 m.
        let borne =
            2.0 * 16.0 * weight * n_gamma * (1.0 - 0.75 * share).powi(2) * (1.0 - share).powi(3) / 1e3;
        assert_eq!(borne > 960.0, bears == "can be borne", "{borne}");
        assert!(texts.iter().any(|text| text == "960 kN/m comes,"), "{texts:?}");
        let found = texts.iter().find_map(|text| text.strip_suffix(&format!(" kN/m {bears}")));
        let found: f64 = found.unwrap_or_else(|| panic!("{bears} in {texts:?}")).parse().unwrap();
        assert!((found / borne - 1.0).abs() < 5e-4, "{found} {borne}");
        for number in [format!("angle of friction φ = {angle}°"), "friction μ = 0.9".to_owned()] {
            assert!(texts.contains(&number), "{number} in {texts:?}");
        }
    }
}

/// Block of 8 m by 6 m and 2 t/m³ on sand, pushed at half its height.
fn sand(angle: f64, weight: f64, force: f64, towards: &str) -> String {
    format!(
        "gravity = 10\n[body]\nwidth = 8\nheight = 6\ndensity = 2e3\nfriction = 0.9\n[ground]\nfriction_angle_deg = {angle}\nunit_weight = {weight}\n\
         [[load]]\nforce = {force}\nelevation = 3\ndirection = \"{towards}\"\n"
    )
}

/// The dashed lines of a failure, the surface first.
fn failure(figure: &Figure) -> Vec<Vec<(f64, f64)>> {
    paths(figure, &format!("stroke=\"{}\" stroke-width=\"1.4\" stroke-dasharray=\"6 4\"", colour("mark")))
}

/// The sketch begins at the inner edge of the effective width, ends on the side of the push, and is mirrored with the load; its wedge has the angles of
/// the inclined load: at the far edge 45° + φ/2 − ρ with 2ρ = δ + arcsin(sin δ/sin φ).
#[test]
fn the_failure_of_the_ground_is_sketched_where_the_load_pushes() {
    let (angle, share) = (24.0_f64, 0.3);
    let drawn = |towards: &str| {
        let figure = section(&case("block.toml", &sand(angle, 4e3, share * 960e3, towards)));
        let middle = figure.labels().iter().find(|label| label.text == "8 m").unwrap().rect.centre().0;
        let walls = paths(&figure, &format!("fill=\"{}\"", colour("concrete")));
        let [wall] = &walls[..] else { panic!("{walls:?}") };
        let across = wall.iter().map(|at| at.0);
        let scale = (across.clone().fold(0.0, f64::max) - across.fold(f64::INFINITY, f64::min)) / 8.0;
        let lines = failure(&figure).into_iter().map(|line| {
            line.into_iter()
                .map(|(x, y)| ((x - middle) / scale, (y - height(wall).1) / scale))
                .collect::<Vec<_>>()
        });
        (lines.collect::<Vec<_>>(), figure)
    };
    let (left, figure) = drawn("left");
    assert!(texts(&figure).iter().any(|text| text == "ground fails this way (a sketch)"));
    assert!(figure.svg().contains("Dashed: a sketch") || texts(&figure).join(" ").contains("sketch"));
    // e = 0.9 m to the left: the effective width is from −4 m to 2.2 m.
    let surface = &left[0];
    assert!((surface[0].0 - 2.2).abs() < 0.03 && surface[0].1.abs() < 0.03, "{surface:?}");
    let delta = share.atan();
    let lean = (delta + (delta.sin() / angle.to_radians().sin()).asin()) / 2.0;
    let flat = (45.0 + angle / 2.0).to_radians() - lean;
    let tip = surface[1];
    assert!((tip.1.atan2(surface[0].0 - tip.0) - flat).abs() < 0.01, "{tip:?} {flat}");
    let end = surface.last().unwrap();
    assert!(end.0 < -4.0, "{end:?}");
    let (right, _) = drawn("right");
    for (one, other) in surface.iter().zip(&right[0]) {
        assert!((one.0 + other.0).abs() < 0.05 && (one.1 - other.1).abs() < 0.05, "{one:?} {other:?}");
    }
}

/// The sketch stands where the ground limits the body, and nowhere else: it fails, or would first as the loads rise, or its factor governs.
#[test]
fn a_sketch_of_failure_is_drawn_where_the_ground_limits() {
    let shows = |text: &str| {
        let figure = section(&case("case.toml", text));
        let words = texts(&figure).into_iter().find(|text| text.ends_with("(a sketch)"));
        assert_eq!(words.is_some(), !failure(&figure).is_empty());
        words
    };
    let fails = Some("ground fails this way (a sketch)".to_owned());
    let would = Some("ground would fail this way (a sketch)".to_owned());
    assert_eq!(shows(&example("goda-on-sand.toml")), fails);
    // With little friction it slides long before; with much the ground is the first to go.
    let weak = sand(30.0, 9e3, 192e3, "left");
    assert_eq!(shows(&weak), would);
    let slippery = weak.replace("friction = 0.9", "friction = 0.25");
    assert_eq!(shows(&slippery), None);
    // It slides first, but its ground is the criterion that is met worst.
    assert_eq!(shows(&format!("{slippery}[criteria]\nground_factor = 9\nSF_sliding = 1\n")), would);
    for name in ["goda-2000.toml", "caisson-on-stone.toml", "quay.toml"] {
        assert_eq!(shows(&example(name)), None, "{name}");
    }
}

/// The sections of all examples, by name.
fn sections() -> Vec<(String, Figure)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let cases = files.filter(|path| path.extension().is_some_and(|extension| extension == "toml"));
    let drawn = cases.map(|path| {
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let figure = section(&case(&name, &example(&name)));
        (name, figure)
    });
    drawn.collect()
}

/// A colour of the palette by its name.
fn colour(name: &str) -> &'static str {
    standfast_figures::colours().find(|colour| colour.0 == name).unwrap().1
}

/// The corners of the paths that look like this.
fn paths(figure: &Figure, look: &str) -> Vec<Vec<(f64, f64)>> {
    let of = |line: &str| {
        let data = line.split_once("d=\"M")?.1.split_once('"')?.0.trim_end_matches('Z');
        let place = |text: &str| {
            let (x, y) = text.split_once(' ')?;
            Some((x.parse().ok()?, y.parse().ok()?))
        };
        data.split('L').map(place).collect::<Option<Vec<(f64, f64)>>>()
    };
    figure.svg().lines().filter(|line| line.contains(look)).filter_map(of).collect()
}

/// The y of the ends of a polygon.
fn height(corners: &[(f64, f64)]) -> (f64, f64) {
    let ys = corners.iter().map(|corner| corner.1);
    (ys.clone().fold(f64::INFINITY, f64::min), ys.fold(f64::NEG_INFINITY, f64::max))
}

#[test]
fn every_section_is_as_wide_as_a_column_or_a_page_and_its_labels_stand_apart() {
    for (name, figure) in sections() {
        // Ground beside the body needs room for the labels of its layers.
        let width = figure.size().0;
        let is_of_soil = name == "quay-by-code.toml" && (720.0..840.0).contains(&width);
        assert!([480.0, 720.0].contains(&width) || is_of_soil, "{name}: {:?}", figure.size());
        let labels = figure.labels();
        for (i, label) in labels.iter().enumerate() {
            let other = labels[i + 1..].iter().find(|other| label.rect.overlaps(&other.rect));
            assert_eq!(other, None, "{name}: {label:?}");
        }
    }
}

/// Neither the surface of a wave, of fill or of water nor its pressures run through a label.
#[test]
fn no_surface_strikes_through_a_label() {
    let push = colour("push");
    let (mut waves, mut surfaces) = (0, 0);
    for (name, figure) in sections() {
        let look =
            |width: &str, paint: &str| format!("fill=\"none\" stroke=\"{paint}\" stroke-width=\"{width}\"");
        let mut lines = paths(&figure, &look("1", push));
        lines.extend(paths(&figure, &look("1.2", colour("ink"))));
        surfaces += lines.len();
        let curves = paths(&figure, &look("1.2", push)).into_iter().filter(|line| line.len() > 20);
        let curves: Vec<_> = curves.collect();
        waves += curves.len();
        for pair in lines.iter().chain(&curves).flat_map(|line| line.windows(2)) {
            for share in (0..=40).map(|i| f64::from(i) / 40.0) {
                let at = [
                    pair[0].0 + share * (pair[1].0 - pair[0].0),
                    pair[0].1 + share * (pair[1].1 - pair[0].1),
                ];
                let struck = figure.labels().iter().find(|label| {
                    let rect = label.rect;
                    rect.x0 < at[0] && at[0] < rect.x1 && rect.y0 < at[1] && at[1] < rect.y1
                });
                assert_eq!(struck, None, "{name}");
            }
        }
    }
    assert!(waves >= 7 && surfaces > 30, "{waves} {surfaces}");
}

/// What stands behind a quay is fill up to the quay's top, and the wall itself is none.
#[test]
fn backfill_looks_like_soil() {
    let figure = section(&case("quay.toml", &example("quay.toml")));
    let fills = paths(&figure, &format!("fill=\"{}\"", colour("fill")));
    let [fill] = &fills[..] else { panic!("{fills:?}") };
    let walls = paths(&figure, &format!("fill=\"{}\"", colour("concrete")));
    let [wall] = &walls[..] else { panic!("{walls:?}") };
    assert_eq!(height(fill), height(wall));
    let right = wall.iter().map(|corner| corner.0).fold(0.0, f64::max);
    assert!(fill.iter().all(|corner| corner.0 >= right), "{fill:?} {right}");
    // Water alone, and pressures that do not last, are no soil.
    for name in ["head-difference.toml", "trough.toml", "goda-2000.toml"] {
        let figure = section(&case(name, &example(name)));
        assert_eq!(figure.svg().matches(&format!("fill=\"{}\"", colour("fill"))).count(), 0, "{name}");
    }
}

/// Sand is drawn where the ground can fail, under the mound as in it, and not under the same caisson on rock.
#[test]
fn sand_is_drawn_where_the_ground_is_sand() {
    let grains =
        |name: &str| section(&case(name, &example(name))).svg().matches("stroke-dasharray=\"0 5.5\"").count();
    assert_eq!((grains("goda-on-sand.toml"), grains("goda-2000.toml")), (2, 0));
}

/// 7.1 of 10.5 m are under water, where the caisson has another density, and looks and is named otherwise.
#[test]
fn a_part_that_takes_up_water_is_told_apart_at_the_water() {
    let figure = section(&case("caisson-of-parts.toml", &example("caisson-of-parts.toml")));
    let part = |name: &str| {
        let found = paths(&figure, &format!("fill=\"{}\"", colour(name)));
        assert_eq!(found.len(), 1, "{name}: {found:?}");
        height(&found[0])
    };
    let (dry, wet) = (part("concrete"), part("fill"));
    assert!((dry.1 - wet.0).abs() < 0.02);
    assert!(((wet.1 - wet.0) / (wet.1 - dry.0) - 7.1 / 10.5).abs() < 1e-3, "{dry:?} {wet:?}");
    for (label, (top, bottom)) in [("2400 kg/m³", dry), ("2100 kg/m³", wet)] {
        let found = figure.labels().iter().find(|found| found.text == label);
        let rect = found.unwrap_or_else(|| panic!("{label} in {:?}", texts(&figure))).rect;
        assert!(top < rect.y0 && rect.y1 < bottom, "{rect:?}");
    }
}

/// The greatest suction of the trough acts 4.2 m above the base: from there a line leads to its number.
#[test]
fn a_number_away_from_its_pressure_has_a_line_to_it() {
    let figure = section(&case("trough.toml", &example("trough.toml")));
    let at = |text: &str| figure.labels().iter().find(|label| label.text == text).unwrap().rect;
    let number = at("−29.3 kPa");
    let (base, crest) = (at("base ±0 m").centre().1, at("crest +10.5 m").centre().1);
    let level = base + 4.2 / 10.5 * (crest - base);
    let leaders = paths(&figure, "stroke-width=\"0.7\"");
    let leads = |line: &Vec<(f64, f64)>| {
        (line[0].1 - level).abs() < 0.5 && line[0].0 < line[1].0 && (line[1].0 - number.x0).abs() < 4.0
    };
    assert!(leaders.iter().any(leads), "{level} {number:?} {leaders:?}");
}

/// The debris hits the wall at the surface of the water, which is drawn beyond its arrow and not through it.
#[test]
fn a_force_at_the_water_stands_free_of_its_surface() {
    let figure = section(&case("head-difference.toml", &example("head-difference.toml")));
    let debris = figure.labels().iter().find(|label| label.text.ends_with("180 kN/m")).unwrap().rect;
    let surfaces = paths(&figure, &format!("stroke=\"{}\" stroke-width=\"1\"", colour("push")));
    let level = |line: &&Vec<(f64, f64)>| (line[0].1 - debris.centre().1).abs() < 1.0;
    let surfaces: Vec<_> = surfaces.iter().filter(level).collect();
    assert!(!surfaces.is_empty());
    assert!(surfaces.iter().all(|line| line.iter().all(|end| end.0 > debris.x1)), "{surfaces:?} {debris:?}");
}

/// A soil is called as one likes, dots and all, and what it makes is told from it.
#[test]
fn a_soil_with_a_dot_in_its_name_is_drawn_as_itself() {
    let text = "[body]\nwidth = 5\nheight = 8\ndensity = 2300\nfriction = 0.6\n[earthquake]\nhorizontal = \"0.1 g\"\n[[backfill]]\n\
        name = \"Sand 1.5\"\nface = \"right\"\nfriction_angle_deg = 33\nwall_friction_deg = 10\nunit_weight = \"18 kN/m3\"\n\
        surcharge = \"20 kPa\"\n";
    let figure = section(&case("case.toml", text));
    let drawn = figure.svg();
    for words in ["Sand 1.5, 1", "Sand 1.5, drag", "surcharge on Sand 1.5", "Sand 1.5 in the earthquake"] {
        assert!(drawn.contains(words), "{words}: {drawn}");
    }
    assert!(!drawn.contains("Sand 1 in"));
}
