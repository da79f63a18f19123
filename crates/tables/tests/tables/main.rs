//! Tables: one program, because all of it needs the same libraries of formats.

#[cfg(feature = "xlsx")]
mod cases;
#[cfg(feature = "columnar")]
mod formats;
mod text;
#[cfg(feature = "xlsx")]
mod workbooks;
