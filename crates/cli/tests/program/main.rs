//! The program as its users meet it. One test program, because each would have to be linked with everything.

mod batch;
mod case_file;
mod completions;
mod json;
mod loads;
mod readme;
mod robust;
mod sheet;
mod transcripts;
