//! Promises of the manifests: the oldest Rust that will do, crates that can be published, dependencies that are allowed.

use std::process::Stdio;

use serde_json::Value;

use crate::ran;
use crate::tally::{Tally, cargo, in_ci};

/// Checks the oldest Rust and the packages.
pub fn check(tally: &mut Tally) {
    match metadata() {
        Ok(metadata) => {
            tally.outcome("oldest Rust of the dependencies", oldest_rust(&metadata));
            tally.outcome("what a published crate has to say", presentable(&metadata));
            tally.outcome("what a published crate depends on", complete(&metadata));
            package(tally, &metadata);
        }
        Err(error) => tally.fail("manifests", error),
    }
}

/// Licences, sources, duplicates and advisories, by `cargo deny` and deny.toml. The advisories have to be fetched first; where they
/// cannot be, the rest is checked, and it is said that they are not. In CI that fails.
pub fn deny() -> Result<(), String> {
    let there = cargo(&["deny", "--version"]).stdout(Stdio::null()).stderr(Stdio::null()).status();
    if !there.is_ok_and(|status| status.success()) {
        return Err("cargo-deny is missing; `cargo install --locked cargo-deny` installs it".to_owned());
    }
    let check = ["deny", "--all-features", "check", "--hide-inclusion-graph"];
    let known = ran(cargo(&check).args(["licenses", "bans", "sources"]));
    let advisories = if ran(&mut cargo(&["deny", "fetch", "db"])).is_ok() {
        ran(cargo(&check).arg("advisories"))
    } else {
        let said = "advisories NOT CHECKED: their database cannot be fetched";
        println!("{said}");
        if in_ci() { Err(said.to_owned()) } else { Ok(()) }
    };
    known.and(advisories)
}

/// Metadata of cargo on the workspace and all it depends on, on any platform.
fn metadata() -> Result<Value, String> {
    let output = cargo(&["metadata", "--format-version", "1", "--locked"]).output();
    let output = output.map_err(|error| format!("cargo metadata: {error}"))?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    serde_json::from_slice(&output.stdout).map_err(|error| format!("cargo metadata: {error}"))
}

fn packages(metadata: &Value) -> impl Iterator<Item = &Value> {
    metadata["packages"].as_array().into_iter().flatten()
}

/// The packages of this workspace.
fn ours(metadata: &Value) -> impl Iterator<Item = &Value> {
    packages(metadata).filter(|package| package["source"].is_null())
}

/// Those of them that are to be published.
fn published(metadata: &Value) -> impl Iterator<Item = &Value> {
    ours(metadata).filter(|package| package["publish"].is_null())
}

fn name(package: &Value) -> &str {
    package["name"].as_str().unwrap_or_default()
}

/// Major, minor and patch of a Rust version such as `1.90`.
fn version(text: &str) -> Option<[u32; 3]> {
    let mut parts = text.split('.').map(str::parse);
    let mut next = || parts.next().map_or(Some(0), Result::ok);
    Some([next()?, next()?, next()?])
}

/// No dependency asks for a later Rust than the workspace promises to do with.
fn oldest_rust(metadata: &Value) -> Result<(), String> {
    let promised = ours(metadata).filter_map(|package| version(package["rust_version"].as_str()?)).min();
    let promised = promised.ok_or("the workspace has no rust-version")?;
    let later: Vec<String> = packages(metadata)
        .filter_map(|package| {
            let wanted = package["rust_version"].as_str()?;
            let later = version(wanted).is_none_or(|wanted| wanted > promised);
            later.then(|| format!("{} {} wants Rust {wanted}", name(package), package["version"]))
        })
        .collect();
    if later.is_empty() { Ok(()) } else { Err(format!("{}; ours is {promised:?}", later.join(", "))) }
}

/// Every crate that is to be published has what its page in a registry shows.
fn presentable(metadata: &Value) -> Result<(), String> {
    let mut missing = Vec::new();
    for package in published(metadata) {
        for key in ["description", "license", "readme", "keywords", "categories", "rust_version"] {
            let value = &package[key];
            if value.is_null() || value.as_array().is_some_and(Vec::is_empty) {
                missing.push(format!("{} has no {key}", name(package)));
            }
        }
    }
    if published(metadata).next().is_none() {
        missing.push("no crate is to be published".to_owned());
    }
    if missing.is_empty() { Ok(()) } else { Err(missing.join(", ")) }
}

/// No crate that is to be published needs one of ours that is not.
fn complete(metadata: &Value) -> Result<(), String> {
    let kept: Vec<&str> = ours(metadata).filter(|package| !package["publish"].is_null()).map(name).collect();
    let mut missing = Vec::new();
    for package in published(metadata) {
        for dependency in package["dependencies"].as_array().into_iter().flatten().map(name) {
            if kept.contains(&dependency) {
                missing.push(format!("{} needs {dependency}, which is not published", name(package)));
            }
        }
    }
    if missing.is_empty() { Ok(()) } else { Err(missing.join(", ")) }
}

/// The names of the crates that are to be published.
pub fn to_be_published() -> Result<Vec<String>, String> {
    Ok(published(&metadata()?).map(|package| name(package).to_owned()).collect())
}

/// Packs the crates that are to be published, all at once because they depend on each other. What they hold is compiled by
/// the other steps.
fn package(tally: &mut Tally, metadata: &Value) {
    let mut command = cargo(&["package", "--no-verify", "--allow-dirty", "--quiet"]);
    for package in published(metadata) {
        command.args(["--package", name(package)]);
    }
    tally.record("packages", &mut command);
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn workspace(dependency: &str, publish: Value, keywords: &[&str]) -> Value {
        json!({"packages": [
            {"name": "ours", "version": "1.0.0", "source": null, "rust_version": "1.90", "publish": publish,
             "description": "d", "license": "l", "readme": "r", "keywords": keywords, "categories": ["c"]},
            {"name": "theirs", "version": "2.0.0", "source": "registry", "rust_version": dependency, "publish": null},
            {"name": "silent", "version": "3.0.0", "source": "registry", "rust_version": null, "publish": null},
        ]})
    }

    #[test]
    fn a_dependency_that_wants_a_later_rust_is_named() {
        let outcome = |wanted: &str| oldest_rust(&workspace(wanted, Value::Null, &["k"]));
        assert_eq!([outcome("1.90"), outcome("1.9"), outcome("1.89.7")], [Ok(()), Ok(()), Ok(())]);
        for later in ["1.90.1", "1.91", "2.0", "1.100"] {
            assert!(outcome(later).is_err_and(|error| error.contains("theirs")), "{later}");
        }
    }

    #[test]
    fn a_published_crate_without_keywords_is_named() {
        assert_eq!(presentable(&workspace("1.90", Value::Null, &["k"])), Ok(()));
        let error = presentable(&workspace("1.90", Value::Null, &[])).unwrap_err();
        assert_eq!(error, "ours has no keywords");
        assert!(presentable(&workspace("1.90", json!([]), &["k"])).is_err());
    }

    #[test]
    fn a_published_crate_that_needs_one_that_is_not_is_named() {
        let of = |publish: Value| {
            let ours = json!({"name": "ours", "source": null, "publish": null,
                "dependencies": [{"name": "face"}, {"name": "theirs"}]});
            let face = json!({"name": "face", "source": null, "publish": publish, "dependencies": []});
            json!({"packages": [ours, face, {"name": "theirs", "source": "registry", "publish": []}]})
        };
        assert_eq!(complete(&of(Value::Null)), Ok(()));
        assert_eq!(complete(&of(json!([]))).unwrap_err(), "ours needs face, which is not published");
    }
}
