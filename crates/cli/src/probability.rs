//! `standfast probability`: how likely each mode is if some numbers of a case are random.

use std::fmt::Write;
use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::str::FromStr;

use standfast_cases::random::{ChanceCriterion, ChanceRequest, Effort, Probability, WeighedDraws, template};
use standfast_tables::{PlainColumn, PlainValues, TableFormat, write_columns};

use crate::answer::PrintedAnswer;
use crate::args::{ProbabilityArgs, RotationsArg};
use crate::case_file;
use crate::error::{CommandError, Result};
use crate::figures::Figures;
use crate::files_read::FilesRead;
use crate::format::{Format, Shown};
use crate::progress::refined;
use crate::write::{self, ExtensionError, Pending};

/// A file of draws, whose extension says how it is written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DrawsFile {
    path: PathBuf,
    format: TableFormat,
}

impl FromStr for DrawsFile {
    type Err = ExtensionError;

    fn from_str(text: &str) -> Result<DrawsFile, ExtensionError> {
        let (path, format) =
            write::by_extension(text, "csv, parquet, arrow, arrows or xlsx", |extension| match extension {
                "csv" | "txt" => Some(TableFormat::Csv),
                "parquet" | "pq" => Some(TableFormat::Parquet),
                "arrow" | "ipc" | "feather" => Some(TableFormat::Arrow),
                "arrows" => Some(TableFormat::Arrows),
                "xlsx" => Some(TableFormat::Xlsx),
                _ => None,
            })?;
        Ok(DrawsFile { path, format })
    }
}

/// Answers a case with random numbers, and writes its figures into a directory or else beside it.
///
/// # Errors
/// If the case file cannot be read or makes no sense, or the draws cannot be written.
pub fn probability(args: &ProbabilityArgs) -> Result<PrintedAnswer> {
    let read = FilesRead::default();
    let case = case_file::parse(&args.case, &read)?;
    if args.template {
        return Ok(PrintedAnswer::plain(template(&case)?));
    }
    let plain = Effort::default();
    let effort = Effort {
        seed: args.seed,
        precision: args.precision,
        floor: args.floor,
        points: args.samples,
        threads: args.threads.map_or(plain.threads, NonZeroUsize::get),
    };
    if let Some(file) = &args.draws {
        read.refuse(&file.path)?;
    }
    let follow = args.rotations == RotationsArg::Simulate;
    let plainly = ChanceRequest { effort, years: args.years, follow, ..ChanceRequest::default() };
    let request = args.method.map_or(plainly, |method| plainly.with(method));
    let over = args.over.as_ref();
    let answer = &refined(|portion| Probability::under(&case, request, over, &[], portion))?;
    if args.check && answer.criteria.is_empty() {
        return Err(CommandError::NothingToCheck {
            path: args.case.clone(),
            of: " of the probability",
            example: "p_not_rest = 0.1",
        });
    }
    if let Some(file) = &args.draws {
        write_draws(WeighedDraws::of(&case, answer)?, file, &read)?;
    }
    let figures =
        Figures::asked(args.output.as_deref(), args.no_figures || (args.brief && args.output.is_none()));
    let shown = Shown::of(args.brief, args.format);
    let mut printed = PrintedAnswer::of(answer, &(), shown, figures, (&args.case, &read));
    if let (Format::Text, Some(file)) = (args.format, &args.draws) {
        let _ = write!(printed.answer, "\nDraws written to {}\n", file.path.display());
    }
    let met = (!answer.criteria.is_empty()).then(|| answer.criteria.iter().all(ChanceCriterion::is_met));
    Ok(PrintedAnswer { met, ..printed })
}

/// A row for each draw: the numbers, the weight and the mode, and of several sets of loads which.
fn write_draws(draws: WeighedDraws, file: &DrawsFile, read: &FilesRead) -> Result<()> {
    let WeighedDraws { inputs, values, of, weights, happens, situations } = draws;
    let number = |((name, unit), values): ((String, Option<&'static str>), Vec<f64>)| PlainColumn {
        name,
        unit,
        values: PlainValues::Numbers(values),
    };
    let mut columns: Vec<PlainColumn> = inputs.into_iter().zip(values).map(number).collect();
    columns.push(number((("weight".to_owned(), None), weights)));
    let mut words: Vec<String> = Vec::new();
    let modes = happens.iter().map(|happens| {
        let name = happens.name();
        words.iter().position(|word| *word == name).unwrap_or_else(|| {
            words.push(name);
            words.len() - 1
        })
    });
    let modes: Vec<usize> = modes.collect();
    let word = |name: &str, values| PlainColumn { name: name.to_owned(), unit: None, values };
    columns.push(word("mode", PlainValues::Words(words, modes)));
    if situations.len() > 1 {
        let names = situations.into_iter().map(Option::unwrap_or_default).collect();
        columns.push(word("situation", PlainValues::Words(names, of)));
    }
    let pending = Pending::create(&file.path, read)?;
    let mut bytes = Vec::new();
    write_columns(&columns, file.format, &mut bytes)?;
    pending.write_all_and_finish(&bytes)
}
