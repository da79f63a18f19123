//! Compilers and linkers for other systems: zig and maturin of the Python package index, in an environment of their own, and the
//! standard libraries that rustup has.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use super::{System, made, output};
use crate::pythons::Python;
use crate::{ran, root, target, targets};

/// What builds.
pub struct Toolchain {
    /// Environment with zig and maturin.
    environment: PathBuf,
    /// The commit that is built, with a word if what lies there is another.
    commit: String,
}

impl Toolchain {
    /// Makes the environment, if it is not there.
    pub fn found() -> Result<Toolchain, String> {
        let environment = target().join("dist-tools");
        let pins = root().join("xtask/dist/requirements.txt");
        let stamp = environment.join("installed.txt");
        let wanted = fs::read(&pins).map_err(|error| format!("{}: {error}", pins.display()))?;
        if fs::read(&stamp).ok().as_ref() != Some(&wanted) {
            let python =
                Python::of_path().ok_or("no Python 3.10 or later with pip and venv; PYTHON names one")?;
            ran(Command::new(&python.program).args(["-m", "venv", "--clear"]).arg(&environment))?;
            let pip = ["-m", "pip", "--quiet", "--disable-pip-version-check", "install", "--requirement"];
            ran(Command::new(environment.join("bin/python")).args(pip).arg(&pins))?;
            fs::write(&stamp, wanted).map_err(|error| format!("{}: {error}", stamp.display()))?;
        }
        let git = |arguments: &[&str]| output(Command::new("git").args(arguments).current_dir(root()));
        let changed = !git(&["status", "--porcelain", "--untracked-files=no"])?.is_empty();
        let commit = git(&["rev-parse", "--short=12", "HEAD"])?.trim().to_owned();
        let commit = if changed { format!("{commit}, changed") } else { commit };
        Ok(Toolchain { environment, commit })
    }

    pub fn python(&self) -> PathBuf {
        self.environment.join("bin/python")
    }

    /// A program of the environment, which finds zig, builds for a system and leaves no path of this machine in what it builds.
    pub fn command(&self, program: &str, system: &System) -> Result<Command, String> {
        targets::added(system.triple)?;
        let programs = self.environment.join("bin");
        let mut command = Command::new(programs.join(program));
        let linker = self.linker(system)?;
        let own = linker.parent().map(Path::to_owned);
        let path = env::var_os("PATH").unwrap_or_default();
        let path = env::join_paths(own.into_iter().chain([programs]).chain(env::split_paths(&path)));
        let prefixes = prefixes()?;
        let of_c: Vec<String> =
            prefixes.iter().map(|(from, to)| format!("-ffile-prefix-map={}={to}", from.display())).collect();
        let name = system.triple.replace('-', "_");
        command
            .current_dir(root())
            .env(format!("CARGO_TARGET_{}_LINKER", name.to_uppercase()), &linker)
            .env(format!("CC_{name}"), &linker)
            .env("PATH", path.map_err(|error| error.to_string())?)
            .env("CARGO_TARGET_DIR", target().join("dist-build"))
            .env("CARGO_ENCODED_RUSTFLAGS", without_paths()?)
            .env("CFLAGS", of_c.join(" "))
            .env("SOURCE_DATE_EPOCH", "315532800")
            .env("MACOSX_DEPLOYMENT_TARGET", "11.0")
            .env("STANDFAST_COMMIT", &self.commit);
        if system.is_mac() {
            // In place of Apple's: the names that chrono and ctrlc ask of its libraries, and no more. zig knows the C library itself.
            command.env("SDKROOT", root().join("xtask/dist/macos-sdk"));
        }
        Ok(command)
    }

    /// A script that compiles and links for a system by zig. cargo-zigbuild and maturin would each write their own, and cargo compiles
    /// everything again for another linker: with this one a wheel takes what a program has compiled.
    fn linker(&self, system: &System) -> Result<PathBuf, String> {
        let folder = target().join("dist-build/zig");
        made(&folder)?;
        let python = self.python();
        let linker = folder.join(format!("{}.sh", system.name));
        script(
            &linker,
            &format!(
                "export CARGO_ZIGBUILD_ZIG_COMMAND='{}' CARGO_ZIGBUILD_ZIG_COMMAND_ARGS='-m ziglang'\n\
                 exec '{}' zig cc -- -g -fno-sanitize=all -target {} \"$@\"\n",
                python.display(),
                self.environment.join("bin/cargo-zigbuild").display(),
                system.zig
            ),
        )?;
        // What rustc calls for libraries of Windows that are not here.
        let libraries = format!("exec '{}' -m ziglang dlltool \"$@\"\n", python.display());
        script(&folder.join("x86_64-w64-mingw32-dlltool"), &libraries)?;
        Ok(linker)
    }
}

/// Writes a script that may be run.
fn script(path: &Path, text: &str) -> Result<(), String> {
    fs::write(path, format!("#!/bin/sh\n{text}")).map_err(|error| format!("{}: {error}", path.display()))?;
    ran(Command::new("chmod").arg("+x").arg(path))
}

/// Folders of this machine, and what stands for them in what is built.
fn prefixes() -> Result<Vec<(PathBuf, &'static str)>, String> {
    let home = |name: &str, folder: &str| {
        env::var_os(name).map(PathBuf::from).or_else(|| Some(Path::new(&env::var_os("HOME")?).join(folder)))
    };
    let sysroot = output(Command::new("rustc").args(["--print", "sysroot"]).current_dir(root()))?;
    let mut prefixes = vec![(root(), "/standfast"), (PathBuf::from(sysroot.trim()), "/rust")];
    prefixes.extend(home("CARGO_HOME", ".cargo").map(|folder| (folder, "/cargo")));
    Ok(prefixes)
}

/// Flags with which rustc writes no path of this machine.
fn remapped() -> Result<Vec<String>, String> {
    let flag = |(from, to): (PathBuf, &str)| format!("--remap-path-prefix={}={to}", from.display());
    Ok(prefixes()?.into_iter().map(flag).collect())
}

/// These flags as cargo takes them.
pub fn without_paths() -> Result<String, String> {
    Ok(remapped()?.join("\u{1f}"))
}

/// Folders of this machine that must not stand in what is built, each with its last slash.
pub fn own_folders() -> Result<Vec<String>, String> {
    let home = env::var_os("HOME").map(PathBuf::from);
    let folders = prefixes()?.into_iter().map(|(path, _)| path).chain(home);
    Ok(folders.map(|path| format!("{}/", path.display())).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A program compiled as those that are handed on has no path of this machine; without the flags it would.
    #[test]
    fn no_path_of_this_machine_is_built_in() {
        let folder = tempfile::tempdir_in(target()).expect("a folder");
        let source = folder.path().join("main.rs");
        fs::write(&source, "fn main() { println!(\"{}\", std::panic::Location::caller()); }\n")
            .expect("it is written");
        let paths = |flags: Vec<String>| {
            let program = folder.path().join("main");
            ran(Command::new("rustc")
                .args(flags)
                .arg(&source)
                .args(["-C", "strip=symbols", "-o"])
                .arg(&program))
            .expect("it compiles");
            let bytes = fs::read(&program).expect("it is there");
            own_folders()
                .expect("folders")
                .into_iter()
                .filter(|own| super::super::examine::has(&bytes, own))
                .count()
        };
        assert_eq!(paths(remapped().expect("flags")), 0);
        assert_ne!(paths(Vec::new()), 0);
    }
}
