//! What is handed on: programs, packages and wheels for other systems, built, examined and tried on one Linux machine.
//!
//! ```text
//! toolchain: zig, maturin, rustup's targets, paths left out ──► program, wheel ──► examine ──► target/dist
//!                                                                                  lists: sums, licences, bill of materials
//! ```

mod crates;
mod examine;
mod lists;
mod program;
mod toolchain;
mod wheel;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::{book, explorer, ran, root, target};
pub use toolchain::Toolchain;
pub use toolchain::without_paths;

/// Something that is handed on.
#[derive(Debug, Clone, Copy)]
pub struct Artefact {
    /// Its name for `--only`.
    pub name: &'static str,
    of: Kind,
}

#[derive(Debug, Clone, Copy)]
enum Kind {
    Explorer,
    Book,
    Crates,
    Program(System),
    Deb(System),
    Wheel(System),
}

/// A system that something is built for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct System {
    /// Its name in the names of files.
    name: &'static str,
    /// Rust's name.
    triple: &'static str,
    /// zig's name, with the version of the C library or of the system that is asked for.
    zig: &'static str,
    /// What runs its programs here.
    runner: Runner,
    /// Debian's name of the processor.
    debian: &'static str,
    /// What its wheels may be installed on.
    wheel: &'static str,
}

/// How a program of a system is run on this machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Runner {
    Native,
    Qemu,
    Wine,
    None,
}

impl System {
    fn is_windows(&self) -> bool {
        self.triple.contains("windows")
    }

    fn is_mac(&self) -> bool {
        self.triple.contains("apple")
    }

    fn suffix(&self) -> &'static str {
        if self.is_windows() { ".exe" } else { "" }
    }
}

const LINUX: System = System {
    name: "linux-x86_64",
    triple: "x86_64-unknown-linux-gnu",
    zig: "x86_64-linux-gnu.2.17",
    runner: Runner::Native,
    debian: "amd64",
    wheel: "manylinux_2_17",
};
const LINUX_ARM: System = System {
    name: "linux-aarch64",
    triple: "aarch64-unknown-linux-gnu",
    zig: "aarch64-linux-gnu.2.17",
    runner: Runner::Qemu,
    debian: "arm64",
    wheel: "manylinux_2_17",
};
const WINDOWS: System = System {
    name: "windows-x86_64",
    triple: "x86_64-pc-windows-gnu",
    zig: "x86_64-windows-gnu",
    runner: Runner::Wine,
    debian: "",
    wheel: "",
};
const MAC: System = System {
    name: "macos-x86_64",
    triple: "x86_64-apple-darwin",
    zig: "x86_64-macos.11.0-none",
    runner: Runner::None,
    debian: "",
    wheel: "",
};
const MAC_ARM: System =
    System { name: "macos-aarch64", triple: "aarch64-apple-darwin", zig: "aarch64-macos.11.0-none", ..MAC };

const ARTEFACTS: [Artefact; 15] = [
    Artefact { name: "explorer", of: Kind::Explorer },
    Artefact { name: "book", of: Kind::Book },
    Artefact { name: "program-linux-x86_64", of: Kind::Program(LINUX) },
    Artefact { name: "program-linux-aarch64", of: Kind::Program(LINUX_ARM) },
    Artefact { name: "program-windows-x86_64", of: Kind::Program(WINDOWS) },
    Artefact { name: "program-macos-x86_64", of: Kind::Program(MAC) },
    Artefact { name: "program-macos-aarch64", of: Kind::Program(MAC_ARM) },
    Artefact { name: "deb-amd64", of: Kind::Deb(LINUX) },
    Artefact { name: "deb-arm64", of: Kind::Deb(LINUX_ARM) },
    Artefact { name: "wheel-linux-x86_64", of: Kind::Wheel(LINUX) },
    Artefact { name: "wheel-linux-aarch64", of: Kind::Wheel(LINUX_ARM) },
    Artefact { name: "wheel-windows-x86_64", of: Kind::Wheel(WINDOWS) },
    Artefact { name: "wheel-macos-x86_64", of: Kind::Wheel(MAC) },
    Artefact { name: "wheel-macos-aarch64", of: Kind::Wheel(MAC_ARM) },
    Artefact { name: "crates", of: Kind::Crates },
];

/// Builds all, or those that are named, into `target/dist`, and lists what is there.
pub fn run(names: &[&str]) -> Result<(), String> {
    let known = |name: &str| ARTEFACTS.iter().any(|one| one.name == name);
    if let Some(unknown) = names.iter().find(|name| !known(name)) {
        let all: Vec<&str> = ARTEFACTS.iter().map(|one| one.name).collect();
        return Err(format!("cargo xtask dist --only {unknown}: there are {}", all.join(", ")));
    }
    let folder = target().join("dist");
    made(&folder)?;
    let toolchain = Toolchain::found()?;
    let wanted = ARTEFACTS.iter().filter(|one| names.is_empty() || names.contains(&one.name));
    for one in wanted {
        println!("── {}", one.name);
        for (file, state) in one.built(&toolchain, &folder)? {
            println!("   {}: {state}", file.display());
            lists::note(&folder, &file, &state)?;
        }
    }
    lists::sums(&folder)
}

/// Runs the first lines of people who have what was built, each in an empty home without our tools.
pub fn try_first_lines() -> Result<(), String> {
    let scripts = root().join("xtask/dist/first-lines");
    let run = scripts.join("run.sh");
    let found = fs::read_dir(&scripts).map_err(|error| format!("{}: {error}", scripts.display()))?;
    let mut all: Vec<PathBuf> = found.filter_map(Result::ok).map(|entry| entry.path()).collect();
    all.retain(|path| *path != run);
    all.sort();
    for script in all {
        println!("── {}", script.file_stem().unwrap_or_default().to_string_lossy());
        ran(Command::new("sh").arg(&run).arg(target().join("dist")).arg(&script))?;
    }
    Ok(())
}

impl Artefact {
    /// Builds it, examines and tries it; gives its files, each with what was seen of it.
    fn built(&self, toolchain: &Toolchain, folder: &Path) -> Result<Vec<(PathBuf, String)>, String> {
        let one = match self.of {
            Kind::Crates => return crates::packed(folder),
            Kind::Explorer => {
                let page = explorer::file()?;
                examine::paths(&explorer::library())?;
                let file = folder.join(format!("standfast-explorer-{}.html", version()));
                fs::copy(&page, &file).map_err(|error| format!("{}: {error}", page.display()))?;
                Ok((file, "opened in browsers by the tests of the repository".to_owned()))
            }
            Kind::Book => return book::packed(toolchain, folder),
            Kind::Program(system) => program::archive(toolchain, &system, folder),
            Kind::Deb(system) => program::deb(toolchain, &system, folder),
            Kind::Wheel(system) => wheel::wheel(toolchain, &system, folder),
        };
        Ok(vec![one?])
    }
}

/// The version of everything.
pub fn version() -> &'static str {
    env!("CARGO_PKG_VERSION")
}

/// A folder that is there.
fn made(folder: &Path) -> Result<(), String> {
    fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))
}

/// A folder that is empty.
pub fn cleared(folder: &Path) -> Result<(), String> {
    if folder.exists() {
        fs::remove_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    }
    made(folder)
}

/// Copies a file, or a folder with what git knows of it.
pub fn copied(from: &Path, to: &Path) -> Result<(), String> {
    let failed = |error: std::io::Error| format!("{}: {error}", from.display());
    if from.is_file() {
        return fs::copy(from, to).map(drop).map_err(failed);
    }
    made(to)?;
    let listed = output(Command::new("git").arg("ls-files").current_dir(from))?;
    for path in listed.lines() {
        let target = to.join(path);
        made(target.parent().unwrap_or(to))?;
        fs::copy(from.join(path), &target).map_err(failed)?;
    }
    Ok(())
}

/// What a command prints.
fn output(command: &mut Command) -> Result<String, String> {
    let output = command.output().map_err(|error| format!("{command:?}: {error}"))?;
    if !output.status.success() {
        return Err(format!("{command:?}: {}\n{}", output.status, String::from_utf8_lossy(&output.stderr)));
    }
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}

/// Runs one of the scripts beside this program.
fn script(toolchain: &Toolchain, name: &str) -> Command {
    let mut command = Command::new(toolchain.python());
    command.arg(root().join("xtask/dist").join(name));
    command
}

/// Packs a folder into an archive.
pub fn packed(toolchain: &Toolchain, folder: &Path, archive: &Path) -> Result<(), String> {
    ran(script(toolchain, "pack.py").arg(folder).arg(archive))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_unknown_name_is_refused_with_those_that_there_are() {
        let error = run(&["program-amiga"]).unwrap_err();
        assert!(error.contains("program-amiga: there are explorer, book, program-linux-x86_64"), "{error}");
    }

    /// What is handed on has no symbols, and is optimised.
    #[test]
    fn the_profile_strips() {
        let manifest = fs::read_to_string(root().join("Cargo.toml")).expect("the manifest");
        let (_, profile) = manifest.split_once("[profile.dist]\n").expect("the profile");
        let (profile, _) = profile.split_once("\n\n").expect("its end");
        assert!(profile.contains("strip = \"symbols\"") && profile.contains("opt-level = 3"), "{profile}");
    }
}
