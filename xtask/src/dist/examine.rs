//! What is built, looked into: no path of this machine, no symbols, no C library newer than promised.

use std::fs;
use std::path::Path;
use std::process::Command;

use super::toolchain::{Toolchain, own_folders};
use super::{System, output, script};

/// The newest version of the GNU C library that may be asked for.
const GLIBC: (u32, u32) = (2, 17);

/// The version of macOS from which on everything runs.
const MACOS: &str = "minos 11.0";

/// True if some bytes hold a text.
pub fn has(bytes: &[u8], text: &str) -> bool {
    bytes.windows(text.len()).any(|window| window == text.as_bytes())
}

/// Looks into a program or a library.
///
/// # Errors
/// If something is in it that should not be.
pub fn binary(toolchain: &Toolchain, file: &Path, system: &System) -> Result<(), String> {
    let bytes = paths(file)?;
    let found = if system.is_windows() {
        windows(&bytes)
    } else if system.is_mac() {
        let said = output(script(toolchain, "macho.py").arg(file))?;
        macos(&said, system.triple.starts_with("aarch64"))
    } else {
        linux(file)
    };
    found.map_err(|error| format!("{} {error}", file.display()))
}

/// Looks for folders of this machine in a file; gives what it holds.
///
/// # Errors
/// If it names one.
pub fn paths(file: &Path) -> Result<Vec<u8>, String> {
    let bytes = fs::read(file).map_err(|error| format!("{}: {error}", file.display()))?;
    match own_folders()?.iter().find(|own| has(&bytes, own)) {
        Some(own) => Err(format!("{} names a folder of this machine: {own}", file.display())),
        None => Ok(bytes),
    }
}

/// No symbols, and no C library that is too new.
fn linux(file: &Path) -> Result<(), String> {
    let sections = output(Command::new("readelf").args(["--wide", "--sections"]).arg(file))?;
    if sections.contains(".symtab") || sections.contains(".debug_info") {
        return Err("has symbols".to_owned());
    }
    let versions = output(Command::new("readelf").args(["--wide", "--version-info"]).arg(file))?;
    match newest(&versions) {
        Some(newest) if newest > GLIBC => Err(format!("asks for glibc {}.{}", newest.0, newest.1)),
        _ => Ok(()),
    }
}

/// No symbols in the header that every program of Windows has.
fn windows(bytes: &[u8]) -> Result<(), String> {
    let number = |at: usize| Some(u32::from_le_bytes(bytes.get(at..at + 4)?.try_into().ok()?));
    let symbols = number(0x3c).and_then(|start| number(usize::try_from(start).ok()? + 16));
    match symbols {
        Some(0) => Ok(()),
        Some(count) => Err(format!("has {count} symbols")),
        None => Err("is no program or library of Windows".to_owned()),
    }
}

/// A version of macOS that is old enough, and a signature that fits: macOS on ARM runs nothing without, and stripping breaks it.
fn macos(said: &str, on_arm: bool) -> Result<(), String> {
    let has = |line: &str| said.lines().any(|one| one == line);
    if !has(MACOS) {
        Err(format!("asks for another macOS than {MACOS}:\n{said}"))
    } else if has("signature fits") || !on_arm && has("signature none") {
        Ok(())
    } else {
        Err(format!("is not signed as macOS wants it:\n{said}"))
    }
}

/// The newest version of the C library among those that readelf lists.
fn newest(versions: &str) -> Option<(u32, u32)> {
    let number = |text: &str| text.chars().take_while(char::is_ascii_digit).collect::<String>().parse().ok();
    let version = |after: &str| {
        let (major, minor) = after.split_once('.')?;
        Some((number(major)?, number(minor)?))
    };
    versions.split("GLIBC_").skip(1).filter_map(version).max()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_newest_version_is_found() {
        let listed =
            "0x0010: Name: GLIBC_2.2.5  Flags: none\n0x0020: Name: GLIBC_2.34  Flags\n Name: GLIBC_2.17 ";
        assert_eq!(newest(listed), Some((2, 34)));
        assert_eq!(newest("Name: GCC_3.0"), None);
    }

    #[test]
    fn symbols_are_found_in_the_header_of_windows() {
        let program = |symbols: u32| {
            let mut bytes = vec![0; 0x100];
            bytes[0x3c] = 0x80;
            bytes[0x90..0x94].copy_from_slice(&symbols.to_le_bytes());
            bytes
        };
        assert_eq!(windows(&program(0)), Ok(()));
        assert_eq!(windows(&program(7)).unwrap_err(), "has 7 symbols");
        assert!(windows(b"MZ").is_err());
    }

    #[test]
    fn a_program_of_macos_is_old_enough_and_signed_where_it_has_to_be() {
        let fits = "minos 11.0\nloads /usr/lib/libSystem.B.dylib\nsignature fits";
        assert_eq!((macos(fits, true), macos(fits, false)), (Ok(()), Ok(())));
        let none = "minos 11.0\nsignature none";
        assert!(macos(none, false).is_ok() && macos(none, true).is_err());
        assert!(macos("minos 11.0\nsignature is wrong", false).is_err());
        assert!(macos("minos 13.0\nsignature fits", true).is_err());
    }

    #[test]
    fn a_text_is_found_in_bytes() {
        assert!(has(b"\0/home/me/x\0", "/home/me") && !has(b"/home", "/home/me"));
    }
}
