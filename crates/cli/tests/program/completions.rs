//! Completion scripts: one a shell, and no name in them that one could not quote.

use std::process::Command;

use clap::CommandFactory;
use standfast_cli::args::Cli;

fn script(shell: &str) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_standfast")).args(["completions", shell]).output().unwrap();
    assert!(output.status.success());
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn every_shell_has_a_script_that_knows_the_subcommands() {
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = script(shell);
        for subcommand in ["assess", "classify", "diagram", "figures", "batch"] {
            assert!(script.contains(subcommand), "{shell}: {subcommand}");
        }
    }
}

/// The zsh script puts value names between single quotes as they are.
#[test]
fn no_value_name_has_a_quote() {
    for subcommand in Cli::command().get_subcommands() {
        for argument in subcommand.get_arguments() {
            for name in argument.get_value_names().unwrap_or_default() {
                assert!(!name.contains(['\'', '"']), "{name}");
            }
        }
    }
}
