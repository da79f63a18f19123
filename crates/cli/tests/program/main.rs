//! The program as its users meet it. One test program, because each would have to be linked with everything.

mod batch;
mod book;
mod case_file;
mod completions;
mod files_read;
mod help;
mod json;
mod loads;
#[path = "../../../tables/tests/common/mutated.rs"]
mod mutated;
mod progress;
mod readme;
mod robust;
mod sheet;
mod transcripts;
