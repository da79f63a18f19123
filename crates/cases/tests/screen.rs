//! On a screen numbers of the case lie where they are drawn.

use std::path::Path;

use standfast::loads::{Action, Face};
use standfast_cases::assess::screen::{
    Pressures, SectionOnScreen, SectionView, load_plane_on_screen, section_on_screen,
};
use standfast_cases::{Acting, Assessment, CaseFile};
use standfast_figures::SectionPicture;

fn assessment(name: &str) -> (CaseFile, Assessment) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name);
    let file = CaseFile::parse(name, &std::fs::read_to_string(path).unwrap()).unwrap();
    let assessment = Assessment::of_file(&file).unwrap();
    (file, assessment)
}

#[test]
fn a_number_lies_on_its_label() {
    for (name, expected) in [
        (
            "caisson-in-air.toml",
            "body.friction 0.6 , body.height 12 m, body.width 15 m, load[1].force 2700 kN/m",
        ),
        ("head-difference.toml", ""),
        ("goda-2000.toml", "body.friction 0.6 , body.height 10.5 m, body.width 15 m"),
        (
            "goda-on-sand.toml",
            "body.friction 0.6 , body.height 10.5 m, body.width 15 m, ground.friction_angle_deg 35 ",
        ),
        ("caisson-on-stone.toml", ""),
    ] {
        let (file, assessment) = assessment(name);
        let section = section_on_screen(&assessment, SectionView::default(), (560.0, 400.0)).unwrap();
        let labels = section.picture.figure.labels();
        let mut found = Vec::new();
        for (id, rect) in &section.numbers {
            let label = labels.iter().find(|label| label.rect.overlaps(rect)).expect("a label at the place");
            let Some(written) = file.written_number(*id) else { continue };
            let shown = format!("{} {}", written.digits, written.unit);
            assert!(label.text.contains(&written.digits), "{id}: {}, not {shown}", label.text);
            found.push(format!("{id} {shown}"));
        }
        found.sort();
        found.dedup();
        assert!(expected.is_empty() || found.join(", ") == expected, "{name}: {found:?}");
        assert!(found.len() >= 2, "{name}: {found:?}");
        assert!(section.words.iter().all(|words| !words.is_empty()) && !section.words.is_empty());
    }
}

#[test]
fn a_section_is_as_large_as_asked_in_colours_of_the_page() {
    for name in ["caisson-in-air.toml", "goda-on-sand.toml", "quay.toml", "monument.toml", "crown-wall.toml"]
    {
        let (_, assessment) = assessment(name);
        for size in [(358.0, 300.0), (580.0, 400.0), (800.0, 560.0)] {
            let picture = section_on_screen(&assessment, SectionView::default(), size).unwrap().picture;
            let (width, height) = picture.figure.size();
            // No wider than asked, so that no letter is made smaller; what stands under a body may make it higher.
            assert!(width <= size.0, "{name}: {width} of {}", size.0);
            assert!(height <= size.1 + 120.0, "{name}: {height} of {}", size.1);
            assert!(width >= 0.8 * size.0 || height >= 0.8 * size.1, "{name}: {width} × {height}");
            let small = picture.figure.labels().iter().find(|label| label.size < 12.0);
            assert_eq!(small, None, "{name} at {}", size.0);
            assert!(!picture.figure.svg().contains("\"#"), "{name}: a colour of its own");
            let scale = (picture.body.x1 - picture.body.x0) / assessment.case.body.width();
            assert!(
                (scale / picture.scale - 1.0).abs() < 0.01 || assessment.case.section.is_some(),
                "{name}"
            );
        }
    }
}

/// The arrow of a force ends on the face, as long as its handle says, at the level of the force.
#[test]
fn forces_on_faces_are_told_with_their_keys() {
    let (_, assessment) = assessment("caisson-in-air.toml");
    let section = section_on_screen(&assessment, SectionView::default(), (560.0, 400.0)).unwrap();
    let [(id, arrow)] = section.forces[..] else { panic!("{:?}", section.forces) };
    assert_eq!(id.to_string(), "load[1].force");
    let level = section.picture.body.y1 - 11.5 * section.picture.scale;
    assert!((arrow.tip.1 - level).abs() < 1e-9 && (arrow.tail.1 - level).abs() < 1e-9);
    assert!(arrow.tail.0 > arrow.tip.0, "it points to the left");
}

/// A pressure that is summed is one arrow: as large as its strips together, where their moment is theirs.
#[test]
fn pressures_are_drawn_as_their_sums() {
    const STRIPS: usize = 100_000;
    let summed = SectionView { pressures: Some(Pressures::Summed), ..SectionView::default() };
    for name in ["goda-2000.toml", "goda-lower-berm.toml", "quay.toml", "trough.toml"] {
        let (_, assessment) = assessment(name);
        let case = &assessment.case;
        let situation = case.situation(Acting::All, standfast_cases::case::Trial::AS_GIVEN).unwrap();
        let (mut forces, mut places) = (Vec::new(), Vec::new());
        for load in situation.loads() {
            let Action::Pressure { face, diagram } = &load.action else { continue };
            let (mut force, mut moment) = (0.0, 0.0);
            for pair in diagram.points().windows(2) {
                let step = (pair[1].position - pair[0].position) / STRIPS as f64;
                for i in 0..STRIPS {
                    let along = (i as f64 + 0.5) / STRIPS as f64;
                    let pressure = pair[0].pressure + along * (pair[1].pressure - pair[0].pressure);
                    force += pressure * step;
                    moment +=
                        pressure * step * (pair[0].position + along * (pair[1].position - pair[0].position));
                }
            }
            if force != 0.0 {
                forces.push(force.abs() / 1e3);
                places.push(format!(
                    "{:.3} m {}",
                    moment / force,
                    match face {
                        Face::Left | Face::Right => "above the base",
                        Face::Base | Face::Top => "right of O",
                    }
                ));
            }
        }
        let size = (560.0, 400.0);
        let along = section_on_screen(&assessment, SectionView::default(), size).unwrap();
        let sums = section_on_screen(&assessment, summed, size).unwrap();
        assert_eq!(
            [along.pressures, sums.pressures],
            [Some(Pressures::Along), Some(Pressures::Summed)],
            "{name}"
        );
        assert!(forces.len() > 1, "{name}");
        let beside = sums.picture.arrows.len() - along.picture.arrows.len();
        assert!(beside > 0 && beside <= forces.len(), "{name}: {beside}");
        for (force, place) in forces.iter().zip(&places) {
            let number = |text: &str, before: &str| {
                let (head, _) = text.split_once(before)?;
                head.rsplit(' ').next()?.parse::<f64>().ok()
            };
            let (at, of) = place.split_once(" m ").unwrap();
            let is_it = |words: &&String| {
                let says = |found: Option<f64>, expected: f64| {
                    found.is_some_and(|found| (found - expected).abs() < 1e-3 * expected)
                };
                says(number(words, " kN/m"), *force)
                    && says(number(words, &format!(" m {of}")), at.parse().unwrap())
            };
            assert!(
                sums.words.iter().any(|words| is_it(&words)),
                "{name}: {force} {place}: {:?}",
                sums.words
            );
        }
        let width = |picture: &SectionPicture| picture.body.x1 - picture.body.x0;
        assert!(width(&sums.picture) >= width(&along.picture), "{name}: arrows take no more room");
        // A sum has no ring: it is no number of the case.
        assert_eq!(sums.forces.len(), along.forces.len(), "{name}");
    }
}

/// A narrow drawing sums what leaves the body little room, unless somebody says how; without pressures there is nothing to say.
#[test]
fn a_small_body_has_the_sums_of_its_pressures() {
    let drawn = |name: &str, pressures, width| {
        let (_, assessment) = assessment(name);
        let view = SectionView { pressures, ..SectionView::default() };
        section_on_screen(&assessment, view, (width, 300.0)).unwrap()
    };
    let width = |section: &SectionOnScreen| section.picture.body.x1 - section.picture.body.x0;
    let [along, free] = [Some(Pressures::Along), None].map(|pressures| drawn("quay.toml", pressures, 364.0));
    assert_eq!([along.pressures, free.pressures], [Some(Pressures::Along), Some(Pressures::Summed)]);
    assert!(width(&free) > width(&along), "{} {}", width(&free), width(&along));
    assert_eq!(drawn("goda-2000.toml", None, 560.0).pressures, Some(Pressures::Along));
    for pressures in [None, Some(Pressures::Along), Some(Pressures::Summed)] {
        assert_eq!(drawn("caisson-in-air.toml", pressures, 364.0).pressures, None);
    }
}

#[test]
fn the_full_load_lies_at_one() {
    let (_, assessment) = assessment("goda-2000.toml");
    let assessed = assessment.governing();
    let picture = load_plane_on_screen(assessed, "Goda", 2.0, (400.0, 250.0)).unwrap().unwrap();
    assert!((picture.plot.x1 - picture.plot.x0 - 400.0).abs() < 1e-9);
    assert!((picture.plot.y1 - picture.plot.y0 - 250.0).abs() < 1e-9);
    let (x, y) = picture.place(1.0, 0.6);
    assert!((x - (picture.plot.x0 + 200.0)).abs() < 1e-9);
    let (factor, friction) = picture.values(x, y);
    assert!((factor - 1.0).abs() < 1e-12 && (friction - 0.6).abs() < 1e-12);
}
