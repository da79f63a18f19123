//! docs/reference/commands.md: the help of the program and of each of its commands.

use clap::CommandFactory;
use standfast_cli::args::Cli;

/// The page of all commands.
pub fn page() -> String {
    let mut page = String::from(
        "# Commands\n\n\
         What `standfast --help` and `standfast COMMAND --help` print. Every command that takes a case takes it from standard input too, as `-`.\n\
         This page is written by `cargo xtask gallery` from the program's own command line.\n",
    );
    let mut program = Cli::command().term_width(98);
    program.build();
    page.push_str(&section("standfast", &mut program));
    let names: Vec<String> = program
        .get_subcommands()
        .map(|one| one.get_name().to_owned())
        .filter(|name| name != "help")
        .collect();
    for name in names {
        if let Some(command) = program.find_subcommand_mut(&name) {
            page.push_str(&section(&format!("standfast {name}"), command));
        }
    }
    page
}

fn section(name: &str, command: &mut clap::Command) -> String {
    let help = command.render_long_help().to_string();
    let lines: Vec<&str> = help.lines().map(str::trim_end).collect();
    format!("\n## {name}\n\n```text\n{}\n```\n", lines.join("\n").trim_end())
}
