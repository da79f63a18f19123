//! The program `standfast`.

#![forbid(unsafe_code)]

use std::process::ExitCode;

use clap::Parser;
use standfast_cli::Ended;

fn main() -> ExitCode {
    standfast_tables::silence_caught_panics();
    match standfast_cli::run(standfast_cli::args::Cli::parse()) {
        Ok(Ended::Done) => ExitCode::SUCCESS,
        Ok(Ended::NotMet) => ExitCode::from(3),
        Err(error) => {
            standfast_cli::complain_of(&error);
            ExitCode::FAILURE
        }
    }
}
