//! What is built, looked into: no path of this machine, no symbols, no C library newer than promised.

use std::fs;
use std::path::Path;
use std::process::Command;

use super::toolchain::own_folders;
use super::{System, output};

/// The newest version of the GNU C library that may be asked for.
const GLIBC: (u32, u32) = (2, 17);

/// True if some bytes hold a text.
pub fn has(bytes: &[u8], text: &str) -> bool {
    bytes.windows(text.len()).any(|window| window == text.as_bytes())
}

/// Looks into a program or a library.
///
/// # Errors
/// If something is in it that should not be.
pub fn binary(file: &Path, system: &System) -> Result<(), String> {
    let bytes = fs::read(file).map_err(|error| format!("{}: {error}", file.display()))?;
    if let Some(own) = own_folders()?.iter().find(|own| has(&bytes, own)) {
        return Err(format!("{} names a folder of this machine: {own}", file.display()));
    }
    if !system.triple.contains("linux") {
        return Ok(());
    }
    let sections = output(Command::new("readelf").args(["--wide", "--sections"]).arg(file))?;
    if sections.contains(".symtab") || sections.contains(".debug_info") {
        return Err(format!("{} has symbols", file.display()));
    }
    let versions = output(Command::new("readelf").args(["--wide", "--version-info"]).arg(file))?;
    match newest(&versions) {
        Some(newest) if newest > GLIBC => {
            Err(format!("{} asks for glibc {}.{}", file.display(), newest.0, newest.1))
        }
        _ => Ok(()),
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
    fn a_text_is_found_in_bytes() {
        assert!(has(b"\0/home/me/x\0", "/home/me") && !has(b"/home", "/home/me"));
    }
}
