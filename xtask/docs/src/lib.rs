//! The book in docs: its blocks, its pages as mdBook gets them, and its parts that the program itself writes.

#![forbid(unsafe_code)]

pub mod book;
pub mod built;
pub mod gallery;
pub mod pages;

mod chances;
mod commands;
mod errors;
mod evidence;
mod keys;
mod results;
mod stacks;
#[cfg(test)]
mod traceability;

use std::path::{Path, PathBuf};

/// The repository.
///
/// # Panics
/// Never: the crate lies in it.
pub fn root() -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2);
    root.expect("the crate lies in the folder xtask of the repository").to_owned()
}

#[cfg(doctest)]
#[doc = include_str!("../../../docs/how-to/rust.md")]
struct RustInOnePage;
