//! Crates as cargo packs them for a registry: what they hold is compiled, and a registry is asked nothing but what they depend on.

use std::fs;
use std::path::{Path, PathBuf};

use super::version;
use crate::tally::cargo;
use crate::{manifests, ran, target};

/// Packs the crates that are to be published, compiles what was packed, and tries to publish them, each after those that it needs.
pub fn packed(folder: &Path) -> Result<Vec<(PathBuf, String)>, String> {
    let names = manifests::to_be_published()?;
    let of_all: Vec<&str> = names.iter().flat_map(|name| ["--package", name]).collect();
    let place = target().join("dist-build");
    // What lies there and is not committed is said of the commit; it is packed all the same.
    let command = |words: &[&str]| {
        let mut command = cargo(words);
        command.args(["--quiet", "--locked", "--allow-dirty"]).args(&of_all).env("CARGO_TARGET_DIR", &place);
        command
    };
    ran(&mut command(&["package"]))?;
    ran(&mut command(&["publish", "--dry-run", "--no-verify"]))?;
    let mut all = Vec::new();
    for name in &names {
        let file = format!("{name}-{}.crate", version());
        let from = place.join("package").join(&file);
        let to = folder.join(file);
        fs::copy(&from, &to).map_err(|error| format!("{}: {error}", from.display()))?;
        all.push((to, "compiled as packed".to_owned()));
    }
    Ok(all)
}
