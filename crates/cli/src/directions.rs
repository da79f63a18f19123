//! `standfast directions`: a case over all horizontal directions.

use standfast_cases::directions::{Directions, csv};

use crate::answer::PrintedAnswer;
use crate::args::DirectionsArgs;
use crate::case_file;
use crate::error::Result;
use crate::figures::Figures;
use crate::files_read::FilesRead;

/// Turns the loads of a case file through all directions, draws its figures, and returns what to print.
///
/// # Errors
/// If a file cannot be read or written, or the case has no directions.
pub fn directions(args: &DirectionsArgs) -> Result<String> {
    let read = FilesRead::default();
    let file = case_file::parse(&args.case, &read)?;
    let directions = Directions::of_file(&file, args.step)?;
    if args.csv.as_ref().is_some_and(|csv| csv.as_os_str() == "-") {
        return Ok(csv(&directions));
    }
    if let Some(csv) = &args.csv {
        read.refuse(csv)?;
    }
    let figures = Figures::asked(args.output.as_deref(), args.no_figures);
    let table = ("Directions", args.csv.as_deref(), csv as fn(&Directions) -> String);
    PrintedAnswer::with_table(&directions, table, args.format, figures, (&args.case, &read))
}
