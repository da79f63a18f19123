//! `standfast spectrum`: many motions under one shaking.

use standfast_cases::motion::{Spectrum, SpectrumError, SpectrumRequest, spectrum_csv};

use crate::answer::PrintedAnswer;
use crate::args::{SpectrumArgs, threads};
use crate::case_file;
use crate::error::Result;
use crate::figures::Figures;
use crate::files_read::FilesRead;
use crate::progress::watched;

/// Finds the spectrum of a case file, draws it, and returns what to print.
///
/// # Errors
/// If a file cannot be read or written, or the case has no such spectrum.
pub fn spectrum(args: &SpectrumArgs) -> Result<String> {
    let read = FilesRead::default();
    let cases = case_file::parse(&args.case, &read)?.motions()?;
    if let Some(csv) = args.csv.as_ref().filter(|csv| csv.as_os_str() != "-") {
        // Before many motions are followed for nothing.
        read.refuse(csv)?;
    }
    let Some(case) = cases.into_iter().next() else { return Err(SpectrumError::NoShaking.into()) };
    let is_table = args.csv.as_ref().is_some_and(|csv| csv.as_os_str() == "-");
    let request = SpectrumRequest {
        size: args.size.map(Into::into),
        slenderness: args.slenderness.map(Into::into),
        ratio: args.ratio.map(Into::into),
        scale: args.scale.map(Into::into),
        // A table alone has no figure.
        edges: !is_table,
        threads: threads(args.threads),
        ..SpectrumRequest::new(args.kind)
    };
    let spectrum = watched(|portion| Spectrum::of(&case, &request, portion))?;
    if is_table {
        return Ok(spectrum_csv(&spectrum));
    }
    let figures = Figures::asked(args.output.as_deref(), false);
    let table = ("Points", args.csv.as_deref(), spectrum_csv as fn(&Spectrum) -> String);
    PrintedAnswer::with_table(&spectrum, table, args.format, figures, (&args.case, &read))
}
