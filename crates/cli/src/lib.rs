//! The program `standfast`, as a library so that it can be tested and fuzzed.
//!
//! | question | start at |
//! |---|---|
//! | What does the command line look like? | [`args`] |
//! | What does a case begin from? | [`mod@begin`] |
//! | From which file to which is a table answered? | [`batch`] |
//! | What becomes of a case file and its diagrams? | [`assess`], [`mod@design`] |
//! | Which direction of the loads is worst? | [`mod@directions`] |
//! | How is a calculation sheet written? | [`sheet`] |
//! | What becomes of a block in time? | [`simulate`], [`mod@spectrum`] |
//! | Which files may no answer be written over? | [`files_read`] |
//! | What may a build leave out? | [`features`] |
//!
//! All mechanics is `standfast`'s; case files and answers are `standfast-cases`'; all drawing is `standfast-figures`';
//! calculation sheets are `standfast-sheet`'s, tables `standfast-tables`'. What is left is arguments and files.

#![forbid(unsafe_code)]

pub mod answer;
pub mod args;
pub mod assess;
pub mod batch;
pub mod begin;
pub mod case_file;
pub mod design;
pub mod directions;
pub mod draw;
pub mod error;
pub mod features;
pub mod figures;
pub mod files_read;
pub mod format;
pub mod probability;
mod progress;
pub mod sheet;
pub mod simulate;
pub mod spectrum;
pub mod title_block;
pub mod write;

use std::io::{self, Write};

use clap::CommandFactory;
use standfast::Point;
use standfast::loads::Reduced;
use standfast_cases::point::PlacedPoint;
use standfast_cases::{AssessmentView, Explained, coloured, point};
use standfast_figures::FigureId;
use standfast_sheet::SheetOptions;
use standfast_tables::TableOptions;

use answer::PrintedAnswer;
use args::{Cli, Command};
use error::{CommandError, Result};
use figures::Figures;
use files_read::FilesRead;
use format::{Format, Shown};

/// End of a command that did what it was asked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ended {
    /// It is done.
    Done,
    /// It is done, and a criterion that was to be checked is not met.
    NotMet,
}

/// Does what the command line says.
///
/// # Errors
/// If the input is wrong, or a file cannot be read or written.
pub fn run(cli: Cli) -> Result<Ended> {
    let done = match cli.command {
        Command::Assess(args) => return assess_command(&args),
        Command::Design(args) => print(&design::design(&args)?),
        Command::Sheet(args) => {
            let options = SheetOptions {
                title_block: args.title_block.0,
                date: args.date,
                up_to: args.up_to,
                short: args.short,
            };
            sheet::sheet(&args.case, &args.output, &options, args.paper)?;
            print(&format!("Calculation sheet written to {}\n", args.output))
        }
        Command::Probability(args) => {
            return ended(probability::probability(&args)?, args.check);
        }
        Command::Simulate(args) => {
            return ended(simulate::simulate(&args)?, args.check);
        }
        Command::Directions(args) => print(&directions::directions(&args)?),
        Command::Spectrum(args) => print(&spectrum::spectrum(&args)?),
        Command::Classify(args) => {
            let point = Point::new(args.gamma, args.k_prime, args.k, args.mu)?;
            let reduced = Reduced { point, mirrored: false };
            let point = PlacedPoint::new(reduced, args.omega.unwrap_or_default())?;
            print(&match args.format {
                Format::Text => point::text(&point, args.explain),
                Format::Json => point::json(&point),
            })
        }
        Command::Diagram(args) => {
            let plane = draw::plane(&args)?;
            draw::draw_diagram(&plane, &args.points, &args.output, args.scale)?;
            print(&format!("Diagram written to {}\n", args.output))
        }
        Command::Figures(args) => {
            let figures = if args.numbers.is_empty() { &FigureId::ALL[..] } else { &args.numbers };
            let files = draw::draw_figures(&args.output, figures, args.picture, args.scale)?;
            print(&files.iter().map(|file| format!("{}\n", file.display())).collect::<String>())
        }
        Command::New(args) => print(&begin::begin(&args)?),
        Command::Batch(args) => batch_command(&args),
        Command::Manual { command } => {
            let mut page = Vec::new();
            let _ = clap_mangen::Man::new(args::described(command.as_deref())).render(&mut page);
            print(&String::from_utf8_lossy(&page))
        }
        Command::Completions { shell } => {
            let mut script = Vec::new();
            clap_complete::generate(shell, &mut Cli::command(), "standfast", &mut script);
            print(&String::from_utf8_lossy(&script))
        }
    };
    done.map(|()| Ended::Done)
}

fn assess_command(args: &args::AssessArgs) -> Result<Ended> {
    let view = AssessmentView { up_to: args.up_to, all: args.all, ..AssessmentView::default() };
    let figures =
        Figures::asked(args.output.as_deref(), args.no_figures || (args.brief && args.output.is_none()));
    ended(
        assess::assess(&args.case, figures, &view, Shown::of(args.brief, args.format), args.check)?,
        args.check,
    )
}

/// Prints an answer, which may have figures that could not be written and criteria that are not met.
fn ended(PrintedAnswer { answer, undrawn, met }: PrintedAnswer, check: bool) -> Result<Ended> {
    print(&answer)?;
    match undrawn {
        Some(error) => Err(error),
        None if check && met == Some(false) => Ok(Ended::NotMet),
        None => Ok(Ended::Done),
    }
}

fn batch_command(args: &args::BatchArgs) -> Result<()> {
    let name = if args.input.as_os_str() == "-" {
        "standard input".to_owned()
    } else {
        args.input.display().to_string()
    };
    let read = FilesRead::default();
    if let Some(path) = args.case.as_ref().filter(|path| path.as_os_str() != "-") {
        let file = case_file::parse_alone(path, &read)?;
        if file.is_in_time() {
            return print(&batch::motion::motions(args, path, file, &read)?);
        }
    }
    let plain = TableOptions::new(&name);
    let (case, columns) = match &args.case {
        Some(case) => (Some(batch::case(case, &args.columns, &read)?.into()), Vec::new()),
        None => (None, batch::columns(args.problem, &args.columns)?),
    };
    let options = TableOptions {
        from: batch::format(&args.input, args.input_format, "--input-format")?,
        to: batch::format(&args.output, args.output_format, "--output-format")?,
        sheet: args.sheet_name.clone(),
        head: args.head(),
        problem: args.problem,
        case,
        map: args.map.clone(),
        columns,
        on_error: args.on_error,
        threads: args::threads(args.threads),
        program: Some(args::program()),
        ..plain
    };
    let summary = batch::process(&args.input, &args.output, &options, &read)?;
    complain(&batch::said(&summary));
    Ok(())
}

/// Says why a command did not end as asked, in colours where standard error is a terminal that is to have them.
pub fn complain_of(error: &dyn Explained) {
    let _ = writeln!(anstream::stderr(), "{}", coloured(error));
}

/// Writes to standard error; where nobody reads that, there is nobody to tell.
pub fn complain(text: &str) {
    let _ = io::stderr().write_all(text.as_bytes());
}

/// Prints, without complaint if nobody reads.
fn print(text: &str) -> Result<()> {
    match io::stdout().write_all(text.as_bytes()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(CommandError::Printed(error)),
        _ => Ok(()),
    }
}

/// The examples of the README are tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
