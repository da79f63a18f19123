//! Tables: one program, because all of it needs the same libraries of formats.

#[cfg(feature = "xlsx")]
mod cases;
#[cfg(feature = "columnar")]
mod formats;
mod motions;
#[path = "../common/mutated.rs"]
mod mutated;
mod text;
#[cfg(feature = "xlsx")]
mod workbooks;
