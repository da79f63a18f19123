//! What `--help` shows can be pasted: commands run, and case files are read, at any width of a terminal.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use std::str::FromStr;

use clap::CommandFactory;
use standfast_cases::design::Target;
use standfast_cases::key::{Key, MOTION_CRITERIA, Table};
use standfast_cli::args::Cli;

/// The help of every command, of the program itself under no name, as a terminal of a width shows it.
fn helps(width: usize) -> Vec<(String, String)> {
    let mut program = Cli::command().term_width(width);
    program.build();
    let mut helps = vec![(String::new(), program.render_long_help().to_string())];
    let commands = program.get_subcommands_mut().filter(|command| command.get_name() != "help");
    helps.extend(
        commands.map(|command| (command.get_name().to_owned(), command.render_long_help().to_string())),
    );
    helps
}

/// The help of one command on a wide terminal.
fn help(name: &str) -> String {
    helps(100).into_iter().find(|(command, _)| command == name).expect("a command").1
}

/// The commands of a text, those on several lines joined as a shell joins them.
fn commands(help: &str) -> Vec<String> {
    let joined = help.replace("\\\n", " ");
    joined.lines().filter_map(|line| line.strip_prefix("  standfast ").map(str::to_owned)).collect()
}

/// The case files of a text: the indented lines below a line that ends with "(TOML):".
fn case_files(help: &str) -> Vec<String> {
    let blocks = help.split("(TOML):\n").skip(1);
    let is_inside = |line: &&str| line.is_empty() || line.starts_with("  ");
    blocks
        .map(|block| block.lines().take_while(is_inside).map(|line| format!("{}\n", line.trim())).collect())
        .collect()
}

/// Folder with the examples that the program itself writes.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let output = run(folder.path(), &["new".to_owned(), "--examples".to_owned()]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    folder
}

fn run(folder: &Path, arguments: &[String]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_standfast")).args(arguments).current_dir(folder).output().unwrap()
}

/// Words of a command, what is quoted being one, up to a redirection.
fn words(command: &str) -> Vec<String> {
    let parts = command.split('"').enumerate().flat_map(|(place, part)| match place % 2 {
        0 => part.split_whitespace().map(str::to_owned).collect(),
        _ => vec![part.to_owned()],
    });
    parts.take_while(|word| word != ">").collect()
}

#[test]
fn commands_run_as_they_are_pasted() {
    let folder = folder();
    let mut count = 0;
    for (name, help) in helps(80) {
        let commands = commands(&help);
        assert!(!commands.is_empty(), "{name} has no example");
        assert_eq!(commands, self::commands(&self::help(&name)), "{name}: the same at every width");
        // Examples are not written over.
        let empty = tempfile::tempdir().unwrap();
        let folder = if name == "new" { empty.path() } else { folder.path() };
        for command in commands {
            let output = run(folder, &words(&command));
            assert!(output.status.success(), "{command}: {}", String::from_utf8_lossy(&output.stderr));
            count += 1;
        }
    }
    assert!(count > 15, "{count}");
}

#[test]
fn case_files_run_as_they_are_pasted() {
    let folder = folder();
    let case = folder.path().join("case.toml");
    let mut seen = Vec::new();
    for width in [80, 100] {
        for (name, help) in helps(width) {
            for text in case_files(&help) {
                assert!(text.lines().all(|line| line.chars().count() <= 76), "{name}: {text}");
                let beside = match name.as_str() {
                    "probability" => {
                        fs::read_to_string(folder.path().join("examples/goda-2000.toml")).unwrap()
                    }
                    _ => String::new(),
                };
                fs::write(&case, beside + &text).unwrap();
                let output = run(folder.path(), &[name.clone(), "case.toml".into(), "--no-figures".into()]);
                assert!(output.status.success(), "{text}: {}", String::from_utf8_lossy(&output.stderr));
                seen.push(name.clone());
            }
        }
    }
    assert_eq!(seen, ["assess", "simulate", "probability"].repeat(2));
}

/// What is broken by hand is not broken once more by a terminal of 80 columns.
#[test]
fn lists_are_narrower_than_a_terminal() {
    for (name, help) in helps(200) {
        for line in help.lines().skip_while(|line| !line.starts_with("Example")) {
            let is_list = line.starts_with("  ");
            assert!(!is_list || line.chars().count() <= 78, "{name}: {line}");
        }
    }
}

#[test]
fn targets_of_design_are_understood() {
    let help = help("design");
    let (targets, _) = help.split_once("Examples:").expect("examples");
    let (_, targets) = targets.split_once("Targets,").expect("targets");
    let of = |word: &str| word.trim_end_matches([',', ';']).replace('\'', "");
    let targets: Vec<String> = targets.split_whitespace().filter(|word| word.contains('=')).map(of).collect();
    for target in &targets {
        assert!(Target::from_str(target).is_ok(), "{target}");
    }
    for key in Table::Criteria.keys() {
        let target = targets.iter().any(|target| target.split(['=', '(']).next() == Some(key.entry()));
        assert!(target, "{}", key.entry());
    }
}

#[test]
fn the_help_of_assess_knows_the_ground_and_its_criteria() {
    let help = help("assess");
    let of =
        |table: Table| table.keys().filter(|key| !MOTION_CRITERIA.contains(&key.entry())).map(Key::entry);
    let envelope = ["t_h", "t_m", "C"];
    for name in of(Table::Ground).filter(|name| !envelope.contains(name)).chain(of(Table::Criteria)) {
        assert!(help.contains(name), "{name}");
    }
}
