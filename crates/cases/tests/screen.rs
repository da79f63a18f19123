//! On a screen numbers of the case lie where they are drawn.

use std::path::Path;

use standfast_cases::assess::screen::{load_plane_on_screen, section_on_screen};
use standfast_cases::{Assessment, CaseFile};

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
        let section = section_on_screen(&assessment, (560.0, 400.0)).unwrap();
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
            let picture = section_on_screen(&assessment, size).unwrap().picture;
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
    let section = section_on_screen(&assessment, (560.0, 400.0)).unwrap();
    let [(id, arrow)] = section.forces[..] else { panic!("{:?}", section.forces) };
    assert_eq!(id.to_string(), "load[1].force");
    let level = section.picture.body.y1 - 11.5 * section.picture.scale;
    assert!((arrow.tip.1 - level).abs() < 1e-9 && (arrow.tail.1 - level).abs() < 1e-9);
    assert!(arrow.tail.0 > arrow.tip.0, "it points to the left");
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
