//! The program with everything, as an archive and as a package of Debian.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use super::toolchain::Toolchain;
use super::{Runner, System, cleared, copied, examine, lists, made, output, packed, version};
use crate::tally::in_ci;
use crate::{programs, ran, root, target};

/// What a case is tried with on every system: exit code, and the same text as here.
const TRIED: [&str; 4] = ["assess", "examples/caisson-in-air.toml", "--no-figures", "--all"];

/// The program of a system, built and looked into.
fn built(toolchain: &Toolchain, system: &System) -> Result<PathBuf, String> {
    let mut build = toolchain.command("cargo-zigbuild", system)?;
    build.args(["zigbuild", "--quiet", "--locked", "--profile", "dist", "--package", "standfast-cli"]);
    build.args(["--features", "full", "--bin", "standfast", "--target", system.triple]);
    ran(&mut build)?;
    let folder = target().join("dist-build").join(system.triple).join("dist");
    let program = folder.join(format!("standfast{}", system.suffix()));
    examine::binary(toolchain, &program, system)?;
    Ok(program)
}

/// The folder that is packed: program, examples, manual, completions, licences.
fn laid_out(toolchain: &Toolchain, system: &System) -> Result<PathBuf, String> {
    let program = built(toolchain, system)?;
    let folder = target().join("dist-build").join(format!("standfast-{}-{}", version(), system.name));
    cleared(&folder)?;
    copied(&program, &folder.join(format!("standfast{}", system.suffix())))?;
    copied(&root().join("examples"), &folder.join("examples"))?;
    for name in ["LICENSE-MIT", "LICENSE-APACHE", "CITATION.cff"] {
        copied(&root().join(name), &folder.join(name))?;
    }
    // The repository's own begins with a clone, and leads to pages that are not here.
    copied(&root().join("docs/get.md"), &folder.join("README.md"))?;
    lists::materials(toolchain, system, &folder)?;
    // The same for every system, by the program of this one.
    let own = here(toolchain)?;
    let text = |arguments: &[&str]| output(Command::new(&own).args(arguments));
    let manual = folder.join("man");
    made(&manual)?;
    let first = text(&["manual"])?;
    write(&manual.join("standfast.1"), &first)?;
    for command in commands(&first) {
        write(&manual.join(format!("standfast-{command}.1")), &text(&["manual", command])?)?;
    }
    made(&folder.join("completions"))?;
    for (shell, name) in [
        ("bash", "standfast.bash"),
        ("zsh", "_standfast"),
        ("fish", "standfast.fish"),
        ("powershell", "_standfast.ps1"),
    ] {
        write(&folder.join("completions").join(name), &text(&["completions", shell])?)?;
    }
    Ok(folder)
}

/// The commands that the first page of the manual refers to, as in `standfast\-assess(1)`.
fn commands(page: &str) -> impl Iterator<Item = &str> {
    page.lines()
        .filter_map(|line| line.strip_prefix("standfast\\-")?.strip_suffix("(1)"))
        .filter(|name| *name != "help")
}

/// The program of this machine, as it is handed on.
fn here(toolchain: &Toolchain) -> Result<PathBuf, String> {
    let program = target().join("dist-build").join(super::LINUX.triple).join("dist/standfast");
    if program.is_file() { Ok(program) } else { built(toolchain, &super::LINUX) }
}

fn write(path: &Path, text: &str) -> Result<(), String> {
    fs::write(path, text).map_err(|error| format!("{}: {error}", path.display()))
}

/// An archive to unpack and run.
pub fn archive(toolchain: &Toolchain, system: &System, folder: &Path) -> Result<(PathBuf, String), String> {
    let content = laid_out(toolchain, system)?;
    let state = tried(toolchain, system, &content)?;
    let name = content.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let archive = folder.join(format!("{name}.{}", if system.is_windows() { "zip" } else { "tar.xz" }));
    packed(toolchain, &content, &archive)?;
    Ok((archive, state))
}

/// Runs the program of a system where that is possible: its answer is that of the program of this machine.
fn tried(toolchain: &Toolchain, system: &System, content: &Path) -> Result<String, String> {
    let program = content.join(format!("standfast{}", system.suffix()));
    let (mut command, words) = match system.runner {
        Runner::Native => (Command::new(&program), "run here"),
        Runner::Qemu => {
            let mut command = Command::new("qemu-aarch64");
            command.args(["-L", "/usr/aarch64-linux-gnu"]).arg(&program);
            (command, "run under qemu")
        }
        Runner::Wine => (wine(toolchain, &program)?, "run under wine"),
        Runner::None => return Ok("built, not run".to_owned()),
    };
    let runner = command.get_program().to_string_lossy().into_owned();
    if !in_ci() && !runner.contains('/') && programs::found(&runner).is_none() {
        return Ok(format!("built, not run: {runner} is not on this machine"));
    }
    let found = output(command.args(TRIED).current_dir(content))?;
    let expected = output(Command::new(here(toolchain)?).args(TRIED).current_dir(content))?;
    if found.replace("\r\n", "\n") == expected {
        Ok(words.to_owned())
    } else {
        Err(format!("{}: another answer than here:\n{found}", system.name))
    }
}

/// A program of Windows under wine, in a folder of its own, with the library beside it that older wine lacks.
fn wine(toolchain: &Toolchain, program: &Path) -> Result<Command, String> {
    let place = target().join("dist-build/wine");
    made(&place)?;
    let library = place.join("bcryptprimitives.dll");
    if !library.is_file() {
        let mut zig = Command::new(toolchain.python());
        zig.args(["-m", "ziglang", "cc", "-target", "x86_64-windows-gnu", "-shared", "-O1", "-s", "-o"]);
        zig.arg(&library).arg(root().join("xtask/dist/wine/bcryptprimitives.c")).arg("-ladvapi32");
        ran(&mut zig)?;
    }
    let mut command = Command::new("wine");
    // No questions about what else wine could fetch.
    command.arg(program).env("WINEDEBUG", "-all").env("WINEDLLOVERRIDES", "mscoree,mshtml=");
    command.env("WINEPREFIX", place.join("prefix")).env("WINEPATH", place);
    Ok(command)
}

/// A package of Debian, with manual, completions and examples where they belong.
pub fn deb(toolchain: &Toolchain, system: &System, folder: &Path) -> Result<(PathBuf, String), String> {
    let content = laid_out(toolchain, system)?;
    let state = tried(toolchain, system, &content)?;
    let tree = target().join("dist-build").join(format!("deb-{}", system.debian));
    cleared(&tree)?;
    let documents = tree.join("usr/share/doc/standfast");
    for (from, to) in [
        ("standfast", "usr/bin/standfast"),
        ("completions/standfast.bash", "usr/share/bash-completion/completions/standfast"),
        ("completions/_standfast", "usr/share/zsh/vendor-completions/_standfast"),
        ("completions/standfast.fish", "usr/share/fish/vendor_completions.d/standfast.fish"),
        ("THIRD-PARTY.txt", "usr/share/doc/standfast/THIRD-PARTY.txt"),
        ("standfast.cdx.json", "usr/share/doc/standfast/standfast.cdx.json"),
    ] {
        let to = tree.join(to);
        made(to.parent().unwrap_or(&tree))?;
        copied(&content.join(from), &to)?;
    }
    copied(&root().join("examples"), &documents.join("examples"))?;
    let licences = ["LICENSE-MIT", "LICENSE-APACHE"].map(|name| fs::read_to_string(root().join(name)));
    let [mit, apache] = licences.map(|text| text.map_err(|error| error.to_string()));
    write(&documents.join("copyright"), &format!("standfast: MIT OR Apache-2.0\n\n{}\n\n{}", mit?, apache?))?;
    let manual = tree.join("usr/share/man/man1");
    made(&manual)?;
    let pages = fs::read_dir(content.join("man")).map_err(|error| error.to_string())?;
    for page in pages.filter_map(Result::ok) {
        let to = manual.join(page.file_name());
        copied(&page.path(), &to)?;
        ran(Command::new("gzip").args(["--no-name", "--best", "--force"]).arg(&to))?;
    }
    made(&tree.join("DEBIAN"))?;
    let control = format!(
        "Package: standfast\nVersion: {}\nArchitecture: {}\nDepends: libc6 (>= 2.17)\nSection: science\nPriority: optional\n\
         Maintainer: standfast contributors <standfast@invalid>\nDescription: what a freestanding body does that is pushed\n \
         A caisson in waves, a statue in an earthquake, a rack: does it rest,\n slide, rock, or slide and rock? How surely, how far, how likely?\n",
        version(),
        system.debian
    );
    write(&tree.join("DEBIAN/control"), &control)?;
    let package = folder.join(format!("standfast_{}_{}.deb", version(), system.debian));
    let mut build = Command::new("dpkg-deb");
    build.args(["--root-owner-group", "-Zxz", "--build"]).arg(&tree).arg(&package);
    ran(build.env("SOURCE_DATE_EPOCH", "315532800").stdout(std::process::Stdio::null()))?;
    Ok((package, state))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commands_are_those_of_the_manual() {
        let page = ".SH SUBCOMMANDS\n.TP\nstandfast\\-assess(1)\nAssess\n.TP\nstandfast\\-help(1)\nPrint\n";
        assert_eq!(commands(page).collect::<Vec<_>>(), ["assess"]);
    }
}
