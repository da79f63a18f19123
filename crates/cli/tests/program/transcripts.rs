//! Transcripts of what a user sees, word for word: those of `cmd`, and in its folders those of what a build may leave out.

use standfast_cli::features::Feature;

#[test]
fn transcripts() {
    let cases = trycmd::TestCases::new();
    cases.case("tests/cmd/*.trycmd").case("tests/cmd/*.toml");
    let of_features =
        [(Feature::Tables, "tables"), (Feature::Workbooks, "workbooks"), (Feature::Pictures, "pictures")];
    for (feature, folder) in of_features {
        let built = if feature.is_built_in() { "built-in" } else { "left-out" };
        cases.case(format!("tests/cmd/{folder}/{built}*.trycmd"));
        cases.case(format!("tests/cmd/{folder}/{built}*.toml"));
    }
}
