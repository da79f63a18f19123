//! Levels of a chart in a case: the same answer as heights and depths, wherever a level stands.

mod common;

use common::{assess, file, number, refused, six};
use standfast_cases::couple::Variable;
use standfast_cases::results::ResultName;
use standfast_cases::{AssessmentView, Document, Key};

/// A caisson whose base lies at −8.20 mCD, the sea at +4.10.
fn caisson(datum: bool) -> String {
    let level = |level: &str, length: &str| if datum { format!("\"{level}\"") } else { length.to_owned() };
    format!(
        "{}[body]\nwidth = 16\nheight = {}\ndensity = 2200\nfriction = 0.6\n[water]\nlevel = {}\n[wave]\nH13 = 4\nHmax = 7\nperiod = 9\n\
         sea_bottom_slope = 0.01\nwater_depth = {}\nbase_depth = {}\ndepth_above_berm = {}\ncrest_height = {}\nberm_width = 8\nangle_deg = 0\n\
         water_density = 1030\n[[pressure]]\nname = \"fill\"\nface = \"left\"\nelevation = [0, {}]\npressure = [20e3, 0]\npermanent = true\n\
         [[load]]\nname = \"mooring\"\nforce = 50e3\nelevation = {}\ntogether = true\n",
        if datum { "datum = { base = \"-8.20 m\", name = \"CD\" }\n" } else { "" },
        level("+7.60 mCD", "15.8"),
        level("+4.10 mCD", "12.3"),
        level("-11 m CD", "15.1"),
        level("-8.2 mCD", "12.3"),
        level("-6.7 mCD", "10.8"),
        level("+7.6 mCD", "3.5"),
        level("-3.2 mCD", "5"),
        level("+6.80 mCD", "15"),
    )
}

#[test]
fn levels_are_heights_and_depths() {
    let [levels, lengths] = [true, false].map(|datum| assess(&caisson(datum)));
    let all = |assessment: &standfast_cases::Assessment| {
        let one = assessment.governing();
        [ResultName::SfSliding, ResultName::SfOverturningNet, ResultName::LoadFactor, ResultName::P]
            .map(|name| number(one, name))
    };
    assert_eq!(all(&levels), all(&lengths));
    let text = levels.text(&AssessmentView::default());
    assert!(text.contains("base −8.2 mCD, crest +7.6 mCD, still water +4.1 mCD"), "{text}");
}

/// A combination sets a level of the sea, and the design finds one; both move what is written as levels of the bed and the crest.
#[test]
fn what_moves_with_a_level_moves() {
    let set = |to: &str, datum: bool| {
        let text = format!(
            "{}[[combination]]\nname = \"low\"\nset = {{ \"water.level\" = {to} }}\nfactors = {{ wave = 1 }}\n",
            caisson(datum)
        );
        number(assess(&text).governing(), ResultName::P)
    };
    assert_eq!(set("\"+0.50 mCD\"", true), set("8.7", false));
    let file = file(&caisson(true));
    let variable = Variable::find("water_level", file.inputs()).unwrap();
    six(variable.read("+0.50 mCD", file.inputs()).unwrap(), 8.7);
    // Written back as it stands: the level of the sea changes, those of bed and crest stay.
    let id = Key::Level.into();
    assert_eq!(file.written_number(id).unwrap().unit, "mCD");
    let other = file.rewritten(id, 8.7, |number, _| Some(number)).unwrap();
    assert!(
        other.text().contains("level = \"0.5 mCD\"") && other.text().contains("water_depth = \"-11 m CD\""),
        "{}",
        other.text()
    );
    six(other.inputs().number(Key::WaterDepth).unwrap(), 11.5);
    six(other.inputs().number(Key::CrestHeight).unwrap(), 7.1);
}

#[test]
fn what_is_no_level_here_is_told() {
    let text = caisson(true);
    for (from, to, words) in [
        (
            "+4.10 mCD",
            "+4.10 mNN",
            "`level` is \"+4.10 mNN\"; the datum of the file is CD; write the level with CD",
        ),
        (
            "width = 16",
            "width = \"+16 mCD\"",
            "`width` is \"+16 mCD\", a level, and it is a length of the body",
        ),
        (
            "datum = { base = \"-8.20 m\", name = \"CD\" }\n",
            "",
            "the file has no datum; add, above all tables, datum = { base = \"-8.20 m\", name = \"CD\" }",
        ),
        ("name = \"CD\"", "name = \"c d\"", "`name` is c d"),
        (", name = \"CD\"", "", "`datum` lacks `name`"),
    ] {
        let error = refused(&text.replacen(from, to, 1));
        assert!(error.contains(words), "{error}\n{words}");
    }
    let dry = "datum = { base = 0, name = \"CD\" }\n[body]\nwidth = 8\nheight = 3.5\nmass = 66e3\nfriction = 0.6\n[wave]\nformula = \"pedersen\"\nH13 = 4\n\
               period = 8\nwater_density = 1025\narmour_slope = 2\narmour_crest = \"+4 mCD\"\narmour_width = 5\nprotected_height = 2\nfree_height = 1.5\n";
    assert!(refused(dry).contains("does not say how high the sea stands"));
}
