//! Wheels of the Python package, each for one system and every Python from 3.10 on.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use super::toolchain::Toolchain;
use super::{Runner, System, cleared, examine, made};
use crate::{ran, root, target};

/// Builds a wheel, looks into it, and tries it where it can be installed.
pub fn wheel(toolchain: &Toolchain, system: &System, folder: &Path) -> Result<(PathBuf, String), String> {
    // Schemas and stubs, which every wheel has.
    ran(Command::new(toolchain.python()).arg(root().join("python/build_backend.py")))?;
    let place = target().join("dist-build").join(format!("wheel-{}", system.name));
    cleared(&place)?;
    let mut build = toolchain.command("maturin", system)?;
    build.args(["build", "--quiet", "--locked", "--profile", "dist-wheel", "--target", system.triple]);
    build.args(["--manifest-path", "python/Cargo.toml", "--out"]).arg(&place);
    if !system.wheel.is_empty() {
        build.args(["--compatibility", system.wheel]);
    }
    if system.is_windows() {
        // With its own option for zig maturin has the linker export a name with a dot, which no module has.
        let exported = root().join("xtask/dist/windows/module.def");
        build.arg("--").arg("-C").arg(format!("link-arg={}", exported.display()));
    } else {
        build.arg("--zig");
    }
    ran(&mut build)?;
    let built = fs::read_dir(&place).map_err(|error| error.to_string())?;
    let built =
        built.filter_map(Result::ok).map(|entry| entry.path()).find(|path| path.extension().is_some());
    let built = built.ok_or("maturin wrote no wheel")?;
    let repack = root().join("xtask/dist/repack_wheel.py");
    ran(Command::new(toolchain.python()).arg(repack).arg(&built).arg(root()))?;
    let unpacked = place.join("unpacked");
    made(&unpacked)?;
    ran(Command::new(toolchain.python()).args(["-m", "zipfile", "-e"]).arg(&built).arg(&unpacked))?;
    let module = fs::read_dir(unpacked.join("standfast")).map_err(|error| error.to_string())?;
    let is_native =
        |path: &PathBuf| path.extension().is_some_and(|extension| extension == "so" || extension == "pyd");
    let module = module.filter_map(Result::ok).map(|entry| entry.path()).find(is_native);
    let module = module.ok_or("the wheel has no module")?;
    examine::binary(toolchain, &module, system)?;
    // That of every Python on Windows; a module built for one asks for a library with its number.
    if system.is_windows() && !examine::has(&examine::paths(&module)?, "python3.dll") {
        return Err(format!("{} does not ask for python3.dll", module.display()));
    }
    let file = folder.join(built.file_name().unwrap_or_default());
    fs::copy(&built, &file).map_err(|error| error.to_string())?;
    let state = match system.runner {
        Runner::Native => tried(toolchain, &file, &place)?,
        _ => "built, not run",
    };
    Ok((file, state.to_owned()))
}

/// Installs a wheel in an environment of its own and asks it a question.
fn tried(toolchain: &Toolchain, wheel: &Path, place: &Path) -> Result<&'static str, String> {
    let environment = place.join("environment");
    ran(Command::new(toolchain.python()).args(["-m", "venv"]).arg(&environment))?;
    let python = environment.join("bin/python");
    let pip = ["-m", "pip", "--quiet", "--disable-pip-version-check", "install"];
    ran(Command::new(&python).args(pip).arg(wheel))?;
    let question =
        "import standfast; assert standfast.classify(gamma=0.8, k_prime=0.9167, k=0.7281, mu=0.6) == 'SRO-'";
    ran(Command::new(&python).args(["-c", question]).current_dir(place))?;
    Ok("installed and asked here")
}
