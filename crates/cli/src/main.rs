//! The program `standfast`.

#![forbid(unsafe_code)]

use std::process::ExitCode;

use clap::Parser;

fn main() -> ExitCode {
    standfast_tables::silence_caught_panics();
    match standfast_cli::run(standfast_cli::args::Cli::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            standfast_cli::complain(&standfast_cases::report(error.as_ref()));
            ExitCode::FAILURE
        }
    }
}
