//! The program `standfast`, as a library so that it can be tested and fuzzed.
//!
//! | question | start at |
//! |---|---|
//! | What does the command line look like? | [`args`] |
//! | What is in a case file, and how do units become SI? | [`case`], [`units`] |
//! | What is printed for one point? | [`describe`] as text, [`answer`] as JSON |
//! | What to change for a case to be safe? | [`design`] |
//! | How are tables processed? | [`batch`] |
//!
//! All mechanics is `standfast`'s; all drawing is `standfast-figures`'.

#![forbid(unsafe_code)]

pub mod answer;
pub mod args;
pub mod assess;
pub mod batch;
pub mod case;
pub mod classify;
pub mod describe;
pub mod design;
pub mod draw;
pub mod layout;
pub mod suggest;
pub mod units;
pub mod write;

use std::io::{self, Write};
use std::num::NonZeroUsize;

use clap::CommandFactory;
use miette::{Diagnostic, IntoDiagnostic, Result, WrapErr};
use serde::Serialize;
use standfast::{Diagram, Point};

use args::{Cli, Command};
use standfast_figures::FigureId;

/// Does what the command line says.
///
/// # Errors
/// If the input is wrong, or a file cannot be read or written.
pub fn run(cli: Cli) -> Result<()> {
    match cli.command {
        Command::Assess(args) => {
            let answered = assess::assess(&args.case, args.output.as_deref(), args.up_to, args.format)?;
            print(&answered.answer)?;
            Ok(answered.undrawn.map_or(Ok(()), Err)?)
        }
        Command::Design(args) => {
            let args::DesignArgs { case, vary, target, from, to, format } = args;
            print(&design::design(&case, &design::Request { vary, target, from, to }, format)?)
        }
        Command::Classify(args) => {
            let point = Point::new(args.gamma, args.k_prime, args.k, args.mu).into_diagnostic()?;
            print(&classify::classify(point, args.explain, args.format))
        }
        Command::Diagram(args) => {
            let plane = Diagram::new(args.gamma, args.k_prime).into_diagnostic()?;
            draw::draw_diagram(&plane, &args.points, &args.output, args.scale)?;
            print(&format!("Diagram written to {}\n", args.output))
        }
        Command::Figures(args) => {
            let figures = if args.numbers.is_empty() { &FigureId::ALL[..] } else { &args.numbers };
            let files = draw::draw_figures(&args.output, figures, args.picture, args.scale)?;
            print(&files.iter().map(|file| format!("{}\n", file.display())).collect::<String>())
        }
        Command::Batch(args) => batch_command(&args),
        Command::Completions { shell } => {
            let mut script = Vec::new();
            clap_complete::generate(shell, &mut Cli::command(), "standfast", &mut script);
            print(&String::from_utf8_lossy(&script))
        }
    }
}

fn batch_command(args: &args::BatchArgs) -> Result<()> {
    let name = if args.input.as_os_str() == "-" {
        "standard input".to_owned()
    } else {
        args.input.display().to_string()
    };
    let all = || std::thread::available_parallelism().map_or(1, NonZeroUsize::get);
    let options = batch::Options {
        from: args.input_format,
        to: args.output_format,
        problem: args.problem,
        map: args.map.clone(),
        columns: args.columns.clone(),
        on_error: args.on_error,
        threads: args.threads.map_or_else(all, NonZeroUsize::get),
        ..batch::Options::new(&name)
    };
    let summary = batch::process(&args.input, &args.output, &options)?;
    if let Some(first) = summary.first {
        eprintln!("warning: {} of {} rows without a result; the first: {first}", summary.bad, summary.rows);
    }
    Ok(())
}

/// A JSON document, ended by a newline.
fn json(document: &impl Serialize) -> String {
    // Plain structs with string keys always serialise.
    serde_json::to_string_pretty(document).map_or_else(|error| error.to_string(), |json| json + "\n")
}

/// Prints, without complaint if nobody reads.
fn print(text: &str) -> Result<()> {
    match io::stdout().write_all(text.as_bytes()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(error).into_diagnostic().wrap_err("cannot write to standard output")
        }
        _ => Ok(()),
    }
}

/// An error as a user sees it on standard error.
pub fn report(error: &(dyn Diagnostic + 'static)) -> String {
    let theme = miette::GraphicalTheme::unicode_nocolor();
    let handler = miette::GraphicalReportHandler::new_themed(theme).with_width(90).with_links(false);
    let mut text = String::new();
    match handler.render_report(&mut text, error) {
        Ok(()) => text,
        Err(_) => format!("{error}\n"),
    }
}
