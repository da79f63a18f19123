//! The command line.

use std::num::{NonZeroU32, NonZeroUsize};
use std::path::PathBuf;
use std::str::FromStr;
use std::sync::LazyLock;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, CommandFactory, Parser, Subcommand};
use clap_complete::Shell;
use standfast::ground::bearing::{BearingPlane, Ground, GroundLaw};
use standfast::ground::strength::CrushPoint;
use standfast::{InputError, Point};

use standfast_cases::beginnings::{BEGINNINGS, Beginning};
use standfast_cases::check_up_to;
use standfast_cases::design::{Cost, Target};
use standfast_cases::directions::{STEP, check_step};
use standfast_cases::motion::{CopiesAsked, SpectrumKind, SpectrumSteps, Spread};
use standfast_cases::random::{MethodAsked, ValueRange};
use standfast_figures::FigureId;
use standfast_sheet::{Date, Paper};
use standfast_tables::{Mapping, OnError, TableFormat, TableHead, TableProblem};

use crate::design::BoundaryFile;
use crate::draw::{KMu, PictureFile, PictureFormat};
use crate::features;
use crate::format::Format;
use crate::probability::DrawsFile;
use crate::sheet::SheetFile;
use crate::title_block::TitleBlock;

/// Version, the commit it was built from where that is known, and the parts it has.
static VERSION: LazyLock<String> = LazyLock::new(|| {
    let known = commit().into_iter().chain([features::list()]).collect::<Vec<_>>();
    format!("{} ({})", env!("CARGO_PKG_VERSION"), known.join("; "))
});

/// Name and version of the program.
pub fn program() -> String {
    let commit = commit().map_or(String::new(), |commit| format!(" ({commit})"));
    format!("standfast {}{commit}", env!("CARGO_PKG_VERSION"))
}

/// The commit it was built from.
fn commit() -> Option<String> {
    option_env!("STANDFAST_COMMIT").map(|commit| format!("commit {commit}"))
}

/// Does a freestanding body on a rough base rest, slide, rock, or slide and rock under a horizontal force?
///
/// The symbols are the report's: γ = height/width; k = F/(m g); k' the height of the force above the centre of mass,
/// in half-heights (-1 at the base, 0 at the centre, 1 at the crest); μ Coulomb friction.
#[derive(Debug, Parser)]
#[command(name = "standfast", version = VERSION.as_str(), max_term_width = 100, after_help = include_str!("help/program.txt"))]
pub struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// A subcommand.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Begin a case: a complete case file to put your own numbers into
    ///
    /// Prints it, or writes it to a file that is not there yet. Or writes all examples of the documentation into a folder.
    #[command(after_help = include_str!("help/new.txt"))]
    New(NewArgs),

    /// Assess a body and its loads from a case file
    ///
    /// Prints forces and moments, safety factors and bearing pressures, and the mode of response under the full load with the
    /// inequalities that decide it. Then follow accelerations and reactions at onset, the share of the variable loads at which the
    /// body leaves rest, and where the mode changes. Draws the section of the case and the k–μ plane, one diagram for every
    /// elevation of a force; with water, waves, uplift or an earthquake also the path of the rising load.
    #[command(after_help = include_str!("help/assess.txt"))]
    Assess(AssessArgs),

    /// Find the least or the greatest value of a quantity of a case that meets a target
    ///
    /// Prints the value, rounded to the safe side and assessed as it is printed; the bound that binds just beyond it; where else in
    /// the range the target is met; and how every number of the case changes the results. Each value tried goes through the whole
    /// case, waves and water included, and what depends on it changes with it: the mass with the width, the crest with the height.
    ///
    /// With --and, a curve: the least or greatest value for each value of another quantity, as a table, and with -o as a picture
    /// or CSV.
    #[command(after_help = include_str!("help/design.txt"))]
    Design(DesignArgs),

    /// Write the calculation sheet of a case, to file and to sign
    ///
    /// The sheet has the inputs with their sources, the assumptions, and every step as formula, numbers put in and result. It has
    /// both safety factors, the mode of response with its margins, figures, sensitivity, what is not covered, and room for
    /// signatures. It is one HTML file that loads nothing, reads on a phone and prints on A4 and Letter with page numbers. Chromium
    /// or Chrome, if there is one, prints a PDF. The sheet bears the hash of every file read and the program's version; the same
    /// case, options and version give the same bytes.
    #[command(after_help = include_str!("help/sheet.txt"))]
    Sheet(SheetArgs),

    /// Follow the motion of a body in time, from event to event to its end
    ///
    /// Prints whether the body comes to rest or overturns, its slide and rotation, each change of state with its time and reason,
    /// and where the energy went. States are rest, slide, rock, slide-rock and flight. Events are found as roots, so there is no step
    /// of time to choose. Draws the histories, the positions and an animation beside the case file; of several situations the worst.
    #[command(after_help = include_str!("help/simulate.txt"))]
    Simulate(SimulateArgs),

    /// Rocking, Newmark and overturning spectra of a shaking
    ///
    /// The shaking, friction, gravity and law of impacts are those of a case with [motion.base]. A rocking spectrum follows uniform
    /// blocks of many sizes and slendernesses. A Newmark spectrum follows a block that can only slide, over its yield acceleration, to
    /// one side as on a slope, and to both. An overturning curve follows the body of the case itself, over the strength of the
    /// shaking; each change is refined, since a stronger shaking may leave standing what a weaker one overturns. Writes a figure and,
    /// if asked, every point as CSV.
    #[command(after_help = include_str!("help/spectrum.txt"))]
    Spectrum(SpectrumArgs),

    /// Turn the loads of a case through all horizontal directions
    ///
    /// The case has a base seen from above: one of its own, or a load or an earthquake of any direction. Prints the load factor at which the
    /// body leaves rest in each direction, what ends rest there, and the worst direction. Of a record with two horizontal
    /// components it says where rest ends first, and how strong the record may be. Draws the area of rest, with the polygon of
    /// tipping, the circle of sliding, the load, and the orbit of the record.
    #[command(after_help = include_str!("help/directions.txt"))]
    Directions(DirectionsArgs),

    /// Find how likely each mode is if some numbers of a case are random
    ///
    /// Prints the probability of every mode under the loads of one event and, where years are given, of at least one such event in a
    /// life. Beside it stand the reliability index, which number matters, and how much knowing it would gain. Friction is not
    /// sampled: for given other numbers each mode is an interval of friction, known in closed form. Where friction is certain, a load
    /// takes its place.
    #[command(after_help = include_str!("help/probability.txt"))]
    Probability(ProbabilityArgs),

    /// Classify one point of the k–μ plane
    #[command(after_help = include_str!("help/classify.txt"))]
    Classify(ClassifyArgs),

    /// Draw the k–μ diagram of a body and an elevation of the force
    #[command(after_help = include_str!("help/diagram.txt"))]
    Diagram(DiagramArgs),

    /// Draw the report's figures
    #[command(after_help = include_str!("help/figures.txt"))]
    Figures(FiguresArgs),

    /// Answer every row of a table: points, or cases
    ///
    /// The extension of each file tells its format, in any combination: CSV with a header (.csv, .txt, and
    /// names without extension), Parquet (.parquet, .pq), Arrow IPC file (.arrow, .ipc, .feather) or stream (.arrows), Excel
    /// workbook (.xlsx). All columns are carried over as they are, and results are appended.
    ///
    /// With --case every row is the case of a file with other numbers. Name a column by a key of the file, as wave.Hmax or
    /// water_level, with the unit in brackets behind it if that is not SI. What depends on it changes with it, and is named at the
    /// end. The results are those of the situation that governs, under the names of `assess --format json`. In CSV and Excel they are in
    /// the units of `[output]`, else those of `assess`, and the heading has the unit: `bearing_max [kPa]`; in Parquet and Arrow they are SI.
    /// The worst row of each criterion is told at the end. A workbook has it on a sheet `summary`, and on a sheet `inputs` the case
    /// file, the columns and the program's version.
    ///
    /// A case with a table `motion` or `block` is followed in time for every row. Name a column by its place in the file, as
    /// block.mu_s or motion.base.horizontal.file. The results are end, slide, max_slide, max_theta,
    /// max_theta_of_balance, overturned, past_balance, impacts, t_rest, t_final, unique, situation and warnings; with
    /// [motion.copies] overturned_share, and its interval as overturned_share_low and overturned_share_high.
    ///
    /// Without --case the rows are points, with the columns gamma, k_prime, k and mu in any order. The results are mode, unique,
    /// also, x_ddot, y_ddot, theta_ddot, f_x, f_y and xi: accelerations in g, theta_ddot in g/B, forces in m g and xi in B;
    /// `also` lists the other consistent modes where the answer is not unique.
    ///
    /// With --problem wrench the columns are b1, b2, d, rho2, m_x, m_y, x, p, m, mu_s and mu_k, non-dimensional by the
    /// mass, g and one length: distances of O, O' and the base from the centre of mass, squared radius of gyration,
    /// inertia, the wrench at the centre of mass (right, down with the weight, counter-clockwise), friction to stick
    /// and to slip. Appended are modes (all consistent ones), mode (the one reported) and its motion in the same
    /// units.
    #[command(after_help = include_str!("help/batch.txt"))]
    Batch(BatchArgs),

    /// Print the manual of the program or of one command, as a page for `man`
    #[command(after_help = include_str!("help/manual.txt"))]
    Manual {
        /// The command; without one, the program
        #[arg(value_parser = command_name)]
        command: Option<String>,
    },

    /// Print a completion script for a shell
    #[command(after_help = include_str!("help/completions.txt"))]
    Completions {
        /// The shell
        shell: Shell,
    },
}

/// Number of threads: those asked for, or one for each core.
pub(crate) fn threads(asked: Option<NonZeroUsize>) -> usize {
    asked.or_else(|| std::thread::available_parallelism().ok()).map_or(1, NonZeroUsize::get)
}

/// Arguments of `new`.
#[derive(Debug, Args)]
pub struct NewArgs {
    /// Kind of case, one of those below
    #[arg(value_parser = beginnings(), required_unless_present = "examples", conflicts_with = "examples")]
    pub kind: Option<&'static Beginning>,
    /// Write it to a file that is not there yet, in place of standard output
    #[arg(short, long, value_name = "FILE", conflicts_with = "examples")]
    pub output: Option<PathBuf>,
    /// Write all examples into a folder, ./examples if none is named; no file that is there is touched
    #[arg(long, value_name = "DIR", num_args = 0..=1, default_missing_value = "examples")]
    pub examples: Option<PathBuf>,
}

/// Arguments of `assess`.
#[derive(Debug, Args)]
pub struct AssessArgs {
    /// The case file (TOML); - reads standard input
    #[arg(value_name = "CASE.toml")]
    pub case: PathBuf,
    /// Where to put the diagrams; made if it is not there [default: beside the case file, or here if it is read from
    /// standard input, then as case.svg]
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Draw nothing: the answer alone, in a fraction of the time
    #[arg(long, conflicts_with = "output")]
    pub no_figures: bool,
    /// How far to follow the rising load, as a multiple of the full load
    #[arg(long, value_name = "FACTOR", default_value = "2", allow_hyphen_values = true, value_parser = factor)]
    pub up_to: f64,
    /// Show and draw every situation; without it, of more than 8 only the worst
    #[arg(long)]
    pub all: bool,
    /// End with exit code 3 if a criterion of the case is not met
    #[arg(long)]
    pub check: bool,
    /// Print the top of the answer alone: criteria, what happens, how near another answer is; draw figures only with --output
    #[arg(long, conflicts_with = "format")]
    pub brief: bool,
    /// How to print the answer
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// Treatment of waves that begin a rotation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, clap::ValueEnum)]
pub enum RotationsArg {
    /// Count them apart; they do not add to the slide
    #[default]
    Count,
    /// Follow each that is drawn in time: slides, rocking, impacts without rebound, overturning
    Simulate,
}

/// Arguments of `probability`.
#[derive(Debug, Args)]
pub struct ProbabilityArgs {
    /// The case file (TOML) with a table `random`; - reads standard input
    #[arg(value_name = "CASE.toml")]
    pub case: PathBuf,
    /// Where to put the figures; made if it is not there [default: beside the case file, or here if it is read from
    /// standard input, then as case-modes.svg and so on]
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Draw nothing: the answer alone
    #[arg(long, conflicts_with = "output")]
    pub no_figures: bool,
    /// Method: integrate (three random numbers at most), sobol, importance or monte-carlo; form also finds the nearest point
    /// of every mode [default: the best for so many numbers]
    #[arg(long)]
    pub method: Option<MethodAsked>,
    /// The seed of all random numbers
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Half-width of the 95 % interval asked for, relative to the probability
    #[arg(long, default_value = "0.05", value_parser = part, allow_negative_numbers = true)]
    pub precision: f64,
    /// Probability up to which no precision is asked for
    #[arg(long, default_value = "1e-6", value_parser = part, allow_negative_numbers = true)]
    pub floor: f64,
    /// Greatest number of points, of which 32 are always taken (16384 by monte-carlo); a motion followed in time counts as
    /// 1024
    #[arg(long, default_value_t = 1 << 22, value_parser = clap::value_parser!(u64).range(1..), allow_negative_numbers = true)]
    pub samples: u64,
    /// Years of a life, in place of those of the file
    #[arg(long, value_parser = time_step, allow_negative_numbers = true)]
    pub years: Option<f64>,
    /// Repeat for COUNT values of a number of the case, FROM and TO as in the case file; with [motion.base], pga gives overturning
    /// in time, the shaking scaled to each peak
    #[arg(long, value_name = "NAME=FROM..TO:COUNT")]
    pub over: Option<ValueRange>,
    /// Write draws of the random numbers, each with its weight and mode: .csv, .parquet, .arrow or .xlsx. Of monte-carlo they are
    /// those counted, of other methods up to 65 536 independent ones
    #[arg(long, value_name = "FILE")]
    pub draws: Option<DrawsFile>,
    /// Treatment of waves that begin a rotation
    #[arg(long, value_enum, default_value_t)]
    pub rotations: RotationsArg,
    /// Print a table of random numbers for the case, with laws of practice and their sources, and stop
    #[arg(long, conflicts_with_all = ["over", "draws", "method"])]
    pub template: bool,
    /// Number of threads; the answer does not depend on it [default: one for each core]
    #[arg(long)]
    pub threads: Option<NonZeroUsize>,
    /// End with exit code 3 if a criterion of chance of the case is not met: p_not_rest, p_life, p_any, beta_life, sliding_mean, p_sliding_over
    #[arg(long)]
    pub check: bool,
    /// Print the top of the answer alone: criterion, probability, what it hangs on; figures only where --output says so
    #[arg(long, conflicts_with = "format")]
    pub brief: bool,
    /// How to print the answer
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// Arguments of `simulate`.
#[derive(Debug, Args)]
pub struct SimulateArgs {
    /// The case file, with a block or a body.
    #[arg(
        value_name = "CASE.toml",
        help = "The case file (TOML) with a [block] or a [body]; - reads standard input"
    )]
    pub case: PathBuf,
    /// Where to put the figures; made if it is not there [default: beside the case file, or here if it is read from
    /// standard input, then as case-motion.svg and so on]
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Draw nothing: the answer alone
    #[arg(long, conflicts_with = "output")]
    pub no_figures: bool,
    /// Write the motion at even steps of time to a file, CSV, Parquet, Arrow or Excel by its extension; - writes CSV to standard output
    /// in place of the answer
    #[arg(long, value_name = "OUT", requires = "dt")]
    pub series: Option<PathBuf>,
    /// The step of time of --series
    #[arg(long, value_name = "DT", requires = "series", value_parser = time_step)]
    pub dt: Option<f64>,
    /// Give --series two rows more at each event, just before and just after it, and a column `side` of -1 and 1
    #[arg(long, requires = "series")]
    pub events: bool,
    /// Find how much stronger or weaker the loads have to be for another verdict, however long that takes: 46 motions, or N between
    /// 0.8 and 1.2 times the loads [default: done unless a record has 20,000 points or more]
    #[arg(long, value_name = "N", conflicts_with = "no_strength", value_parser = motions)]
    pub strength: Option<Option<u16>>,
    /// Do not look for another verdict under stronger or weaker loads
    #[arg(long)]
    pub no_strength: bool,
    /// Follow so many copies whose numbers differ a little, and say what becomes of them
    #[arg(long, value_name = "N", value_parser = copies)]
    pub copies: Option<usize>,
    /// By how much the numbers of copies scatter, as a share of each: 0.1% or 0.001; or of some, friction=5%,base=2%: the others stay
    /// [default: 0.1%]
    #[arg(long, value_name = "SHARE", value_parser = spread)]
    pub spread: Option<Spread>,
    /// The seed of the copies [default: 1]
    #[arg(long)]
    pub seed: Option<u64>,
    /// Number of threads for the copies; the answer does not depend on it [default: one for each core]
    #[arg(long)]
    pub threads: Option<NonZeroUsize>,
    /// Write the factors and the outcome of every copy to a file, CSV, Parquet, Arrow or Excel by its extension; - writes CSV to standard
    /// output in place of the answer
    #[arg(long, value_name = "OUT")]
    pub csv: Option<PathBuf>,
    /// Tell the accelerations of a point of the body, where equipment stands: x and y from the centre of mass, with a name before
    /// them if it is to have one, rack=0,0.9; may be given several times
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true)]
    pub at: Vec<String>,
    /// Go on from a row of a series that was written by --series, in place of [motion.initial]
    #[arg(long, value_name = "SERIES", requires = "row")]
    pub from: Option<PathBuf>,
    /// The row of --from, counted from 1 below the header
    #[arg(long, value_name = "N", requires = "from")]
    pub row: Option<NonZeroUsize>,
    /// Changes nothing: how far the motion parts from that of almost the same body is always said
    #[arg(long, hide = true)]
    pub sensitivity: bool,
    /// Show every event
    #[arg(long)]
    pub all: bool,
    /// End with exit code 3 if a criterion of the motion is not met
    #[arg(long)]
    pub check: bool,
    /// Print the top of the answer alone: criteria, what happens, how near another answer is; draw figures only with --output
    #[arg(long, conflicts_with = "format")]
    pub brief: bool,
    /// How to print the answer; json is always complete
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// Arguments of `spectrum`.
#[derive(Debug, Args)]
pub struct SpectrumArgs {
    /// The case file, with a base that moves.
    #[arg(
        value_name = "CASE.toml",
        help = "The case file (TOML) with [motion.base]; - reads standard input"
    )]
    pub case: PathBuf,
    /// Kind of spectrum: rocking, newmark or overturning
    #[arg(long, default_value = "rocking", value_name = "KIND", value_parser = SpectrumKind::from_str)]
    pub kind: SpectrumKind,
    /// Half diagonals of the blocks, at equal ratios [default: from a quarter to eight times that of the case, 41 of them]
    #[arg(long, value_name = "FROM,TO[,COUNT]")]
    pub size: Option<SpectrumSteps>,
    /// Heights of the blocks over their widths, at equal steps [default: 2,8,31]
    #[arg(long, value_name = "FROM,TO[,COUNT]")]
    pub slenderness: Option<SpectrumSteps>,
    /// Yield accelerations over the peak of the shaking, at equal steps [default: 0.02,0.98,49]
    #[arg(long, value_name = "FROM,TO[,COUNT]")]
    pub ratio: Option<SpectrumSteps>,
    /// Factors on the shaking, at equal steps [default: 0.05,5,199, and within 0.5 % of each other
    /// from 0.8 of the least that overturns it on]
    #[arg(long, value_name = "FROM,TO[,COUNT]")]
    pub scale: Option<SpectrumSteps>,
    /// Write every point to a CSV file; - writes to standard output in place of the answer
    #[arg(long, value_name = "OUT.csv")]
    pub csv: Option<PathBuf>,
    /// Where to put the figure; made if it is not there [default: beside the case file, or here if it is read from
    /// standard input]
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Number of threads; the answer does not depend on it [default: one for each core]
    #[arg(long)]
    pub threads: Option<NonZeroUsize>,
    /// How to print the answer
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// Arguments of `directions`.
#[derive(Debug, Args)]
pub struct DirectionsArgs {
    /// The case file, with a base seen from above.
    #[arg(
        value_name = "CASE.toml",
        help = "The case file (TOML), with a base seen from above; - reads standard input"
    )]
    pub case: PathBuf,
    /// Step between the directions, in degrees; it divides 360
    #[arg(long, value_name = "DEGREES", default_value_t = STEP, value_parser = step)]
    pub step: f64,
    /// Write every direction to a CSV file; - writes to standard output in place of the answer
    #[arg(long, value_name = "OUT.csv")]
    pub csv: Option<PathBuf>,
    /// Where to put the figures; made if it is not there [default: beside the case file, or here if it is read from
    /// standard input]
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Draw nothing: the answer alone
    #[arg(long, conflicts_with = "output")]
    pub no_figures: bool,
    /// How to print the answer
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

fn step(text: &str) -> Result<f64, String> {
    let step = text.parse().map_err(|_| "expected a number of degrees".to_owned())?;
    check_step(step).map_err(|error| error.to_string())
}

/// Arguments of `design`.
#[derive(Debug, Args)]
pub struct DesignArgs {
    /// The case file (TOML); - reads standard input
    #[arg(value_name = "CASE.toml")]
    pub case: PathBuf,
    /// Quantity to vary: width, height, mass, friction, water_level, crest_height, or any number of the case as in wave.period; without
    /// one, the least change of each number that a person can change
    #[arg(long, value_name = "QUANTITY")]
    pub vary: Vec<String>,
    /// The target, one of those below [default: the criteria of the case; without any that it rests, in time that it does not overturn]
    #[arg(long, value_name = "TARGET")]
    pub target: Option<Target>,
    /// The least value that meets the target (default)
    #[arg(long, conflicts_with = "greatest", requires = "vary")]
    pub least: bool,
    /// The greatest value that meets the target
    #[arg(long, requires = "vary")]
    pub greatest: bool,
    /// The least volume or mass that meets the target with two or three quantities, each by its own --vary, as volume is
    #[arg(long, visible_alias = "minimize", value_name = "COST", requires = "vary", conflicts_with_all = ["least", "greatest", "and"], value_parser = cost)]
    pub minimise: Option<Cost>,
    /// Lower end of the range, as in the case file, e.g. "8 m" or 8; with --minimise once for each quantity [default: a fifth of the present
    /// value, with --minimise half]
    #[arg(long, value_name = "A", allow_hyphen_values = true, requires = "vary")]
    pub from: Vec<String>,
    /// Upper end of the range [default: five times the present value, with --minimise twice]
    #[arg(long, value_name = "B", allow_hyphen_values = true, requires = "vary")]
    pub to: Vec<String>,
    /// Another quantity: the answer for each of many values of it
    #[arg(long, value_name = "QUANTITY", requires = "vary")]
    pub and: Option<String>,
    /// Lower end of the other quantity [default: half the present value]
    #[arg(long, value_name = "A", allow_hyphen_values = true, requires = "and")]
    pub and_from: Option<String>,
    /// Upper end of the other quantity [default: twice the present value]
    #[arg(long, value_name = "B", allow_hyphen_values = true, requires = "and")]
    pub and_to: Option<String>,
    /// With --and: a file to write; its extension is svg, png, pdf or csv. May be given again
    #[arg(short, long, value_name = "FILE", requires = "and", conflicts_with = "minimise")]
    pub output: Vec<BoundaryFile>,
    /// Pixels of a png per unit of the svg
    #[arg(long, value_name = "S", default_value = "2", allow_hyphen_values = true, value_parser = scale)]
    pub scale: f32,
    /// Print the top of the answer alone: the value found, and what fails just beyond it
    #[arg(long, conflicts_with_all = ["format", "and"])]
    pub brief: bool,
    /// How to print the answer
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// Arguments of `sheet`.
#[derive(Debug, Args)]
pub struct SheetArgs {
    /// The case file (TOML); - reads standard input
    #[arg(value_name = "CASE.toml")]
    pub case: PathBuf,
    /// The file to write; its extension is html or pdf
    #[arg(short, long, value_name = "FILE")]
    pub output: SheetFile,
    /// One page: the verdict, the section, the inputs that decide, each criterion in each combination, signatures
    #[arg(long)]
    pub short: bool,
    /// Date on the sheet [default: none; the sheet says that it is undated]
    #[arg(long, value_name = "YYYY-MM-DD")]
    pub date: Option<Date>,
    /// How far to follow the rising load, as a multiple of the full load
    #[arg(long, value_name = "FACTOR", default_value = "2", allow_hyphen_values = true, value_parser = factor)]
    pub up_to: f64,
    /// The size of a PDF's pages
    #[arg(long, value_enum, default_value_t)]
    pub paper: Paper,
    /// Entries of the title block, in place of those of the case file
    #[command(flatten)]
    pub title_block: TitleBlock,
}

/// Arguments of `classify`.
#[derive(Debug, Args)]
pub struct ClassifyArgs {
    /// Slenderness γ, height over width
    #[arg(long, value_name = "G", allow_hyphen_values = true, value_parser = gamma)]
    pub gamma: f64,
    /// Elevation k' of the force above the centre of mass, in half-heights; negative below
    #[arg(long, value_name = "KP", allow_hyphen_values = true, value_parser = k_prime)]
    pub k_prime: f64,
    /// Force k, in weights of the body
    #[arg(long, value_name = "K", allow_hyphen_values = true, value_parser = force)]
    pub k: f64,
    /// Friction μ
    #[arg(long, value_name = "MU", allow_hyphen_values = true, value_parser = friction)]
    pub mu: f64,
    /// Share ω = V/(2B q_u) of a base that crushes, taken by the weight alone; from 1 on the ground fails (BF) [default: 0, a
    /// rigid base]
    #[arg(long, value_name = "W", allow_hyphen_values = true, value_parser = omega)]
    pub omega: Option<f64>,
    /// Show every step of the decision, the motion, and where the mode changes
    #[arg(long)]
    pub explain: bool,
    /// How to print the answer; json is always complete
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// Arguments of `diagram`.
#[derive(Debug, Args)]
pub struct DiagramArgs {
    /// Slenderness γ, height over width
    #[arg(long, value_name = "G", allow_hyphen_values = true, value_parser = gamma)]
    pub gamma: f64,
    /// Elevation k' of the force above the centre of mass, in half-heights; negative below
    #[arg(long, value_name = "KP", allow_hyphen_values = true, value_parser = k_prime)]
    pub k_prime: f64,
    /// Share ω = V/(2B q_u) of a base that crushes, below 1; the map of a rigid base is drawn behind, dotted
    #[arg(long, value_name = "W", allow_hyphen_values = true, value_parser = omega, conflicts_with = "law")]
    pub omega: Option<f64>,
    /// The plane of ground that fails, by this law of its bearing resistance
    #[arg(long, value_enum, value_name = "LAW", requires = "share")]
    pub law: Option<BearingLaw>,
    /// Share u = V/V0 of the vertical resistance of the ground, centric and upright, that the weight takes
    #[arg(long, value_name = "U", allow_hyphen_values = true, value_parser = share, requires = "law")]
    pub share: Option<f64>,
    /// A point to mark; may be given again
    #[arg(long = "point", value_name = "K,MU", allow_hyphen_values = true, value_parser = point)]
    pub points: Vec<KMu>,
    /// The file to write; its extension is svg, png or pdf
    #[arg(short, long, value_name = "FILE")]
    pub output: PictureFile,
    /// Pixels of a png per unit of the svg
    #[arg(long, value_name = "S", default_value = "2", allow_hyphen_values = true, value_parser = scale)]
    pub scale: f32,
}

/// A law of bearing resistance; of ground without surcharge and cohesion, so that u says all of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum BearingLaw {
    /// EN 1997-1 Annex D
    Ec7,
    /// API RP 2GEO, after Brinch Hansen
    Hansen,
    /// Butterfield & Gottardi's envelope
    Envelope,
}

impl BearingLaw {
    /// Some ground of this law; its size is set by u.
    pub fn ground(self) -> Ground {
        let ground = match self {
            BearingLaw::Ec7 => Ground::new(GroundLaw::Ec7, 35.0, 1.0),
            BearingLaw::Hansen => Ground::new(GroundLaw::Hansen, 35.0, 1.0),
            BearingLaw::Envelope => Ground::envelope(1.0),
        };
        ground.expect("these are numbers of a ground")
    }
}

/// Arguments of `figures`.
#[derive(Debug, Args)]
pub struct FiguresArgs {
    /// Folder for the figures, made if it is not there; or for one figure a file: svg, png or pdf
    #[arg(short, long, value_name = "OUT")]
    pub output: PathBuf,
    /// Figures by the report's numbers, e.g. 3.11 or 4.7a [default: all 26]
    #[arg(value_name = "NUMBER")]
    pub numbers: Vec<FigureId>,
    /// What to write
    #[arg(long = "as", value_enum, default_value = "svg", value_name = "KIND")]
    pub picture: PictureFormat,
    /// Pixels of a png per unit of the svg
    #[arg(long, value_name = "S", default_value = "2", allow_hyphen_values = true, value_parser = scale)]
    pub scale: f32,
}

/// Arguments of `batch`.
#[derive(Debug, Args)]
pub struct BatchArgs {
    /// The table; - reads standard input
    #[arg(value_name = "TABLE")]
    pub input: PathBuf,
    /// The file to write; - writes to standard output, as far as rows make sense
    #[arg(short, long, value_name = "OUT")]
    pub output: PathBuf,
    /// The case file (TOML) whose numbers the columns vary
    #[arg(long, value_name = "CASE.toml", conflicts_with = "problem")]
    pub case: Option<PathBuf>,
    /// Problem of the rows
    #[arg(long, value_enum, default_value_t)]
    pub problem: TableProblem,
    /// Column of the table that is read as one of ours, e.g. mu=friction or wave.Hmax=H; may be given again
    #[arg(long, value_name = "OURS=THEIRS")]
    pub map: Vec<Mapping>,
    /// Results to write, in this order, e.g. mode,unique,x_ddot or SF_sliding,load_factor, or all [default: those that
    /// matter: what happens, how near another answer is, what criteria ask for; of points all]
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    pub columns: Vec<String>,
    /// Treatment of a row that makes no sense
    #[arg(long, value_enum, default_value_t, value_name = "ACTION")]
    pub on_error: OnError,
    /// Number of threads; the answer does not depend on it [default: one for each core]
    #[arg(long, value_name = "N")]
    pub threads: Option<NonZeroUsize>,
    /// The format of the table, whatever its name
    #[arg(long, value_enum, value_name = "FORMAT")]
    pub input_format: Option<TableFormat>,
    /// The format of the file to write, whatever its name
    #[arg(long, value_enum, value_name = "FORMAT")]
    pub output_format: Option<TableFormat>,
    /// The sheet of a workbook that is read [default: the first]
    #[arg(long, value_name = "NAME")]
    pub sheet_name: Option<String>,
    /// The row with the names of the columns, of CSV or a sheet; what stands above is left out [default: the first that is not empty]
    #[arg(long, value_name = "N")]
    pub header_row: Option<NonZeroU32>,
    /// The row below the names has the units of the columns
    #[arg(long)]
    pub units_row: bool,
}

impl BatchArgs {
    /// The rows at the head of the table.
    pub fn head(&self) -> TableHead {
        TableHead { row: self.header_row, has_units: self.units_row }
    }
}

/// A number that [`Point::new`] takes in one of its places, the others being one.
fn number(text: &str, point: impl FnOnce(f64) -> Result<Point, InputError>) -> Result<f64, String> {
    let value: f64 = text.trim().parse().map_err(|_| "expected a number".to_owned())?;
    point(value).map(|_| value).map_err(|error| format!("expected {}", error.expected))
}

fn cost(text: &str) -> Result<Cost, String> {
    Cost::find(text.trim()).ok_or_else(|| "expected volume or mass".to_owned())
}

fn gamma(text: &str) -> Result<f64, String> {
    number(text, |x| Point::new(x, 0.0, 1.0, 1.0))
}

fn k_prime(text: &str) -> Result<f64, String> {
    number(text, |x| Point::new(1.0, x, 1.0, 1.0))
}

fn force(text: &str) -> Result<f64, String> {
    number(text, |x| Point::new(1.0, 0.0, x, 1.0))
}

fn friction(text: &str) -> Result<f64, String> {
    number(text, |x| Point::new(1.0, 0.0, 1.0, x))
}

/// ω of a base that crushes.
fn omega(text: &str) -> Result<f64, String> {
    let value: f64 = text.trim().parse().map_err(|_| "expected a number".to_owned())?;
    let point = CrushPoint::new(1.0, 0.0, 1.0, 1.0, value);
    point.map(|_| value).map_err(|error| format!("expected {}", error.expected))
}

/// u of ground that fails.
fn share(text: &str) -> Result<f64, String> {
    let value: f64 = text.trim().parse().map_err(|_| "expected a number".to_owned())?;
    let plane = BearingPlane::of_share(BearingLaw::Ec7.ground(), 1.0, 0.0, value);
    plane.map(|_| value).map_err(|error| format!("expected {}", error.expected))
}

fn point(text: &str) -> Result<KMu, String> {
    let (k, mu) = text.split_once(',').ok_or("expected two numbers with a comma between, e.g. 0.5,0.6")?;
    let k = force(k).map_err(|error| format!("k: {error}"))?;
    let mu = friction(mu).map_err(|error| format!("μ: {error}"))?;
    Ok(KMu { k, mu })
}

fn scale(text: &str) -> Result<f32, String> {
    // Larger pictures would not fit into memory.
    let range = 0.1..=20.0;
    let value = text.parse().ok().filter(|value| range.contains(value));
    value.ok_or_else(|| format!("expected a number from {} to {}", range.start(), range.end()))
}

fn part(text: &str) -> Result<f64, String> {
    let share = text.trim().parse().ok().filter(|share: &f64| *share > 0.0 && *share < 1.0);
    share.ok_or_else(|| "expected a share, above zero and below 1".to_owned())
}

/// How many motions --strength tries.
fn motions(value: &str) -> Result<u16, String> {
    let count = value.parse().ok().filter(|count| (1..=10_000).contains(count));
    count.ok_or_else(|| {
        "expected how many motions to try, from 1 to 10000; without a number the option goes behind the case file".to_owned()
    })
}

fn copies(value: &str) -> Result<usize, String> {
    let count = value.parse().ok().filter(|count| (1..=CopiesAsked::MOST).contains(count));
    count.ok_or_else(|| format!("expected a whole number of copies, from 1 to {}", CopiesAsked::MOST))
}

fn spread(value: &str) -> Result<Spread, String> {
    let share = |text: &str| {
        let text = text.trim();
        let (digits, unit) = text.strip_suffix('%').map_or((text, 1.0), |digits| (digits, 0.01));
        let share = digits.trim().parse::<f64>().ok().map(|number| number * unit);
        let share = share.filter(|share| (0.0..=1.0).contains(share));
        share.ok_or_else(|| {
            "expected a share from 0 to 1, as 0.1% or 0.001, or names with shares, friction=5%,base=2%"
                .to_owned()
        })
    };
    if !value.contains('=') {
        return share(value).map(Spread::Even);
    }
    let mut named: Vec<(String, f64)> = Vec::new();
    for one in value.split(',') {
        let (name, text) = one.split_once('=').ok_or("expected names with shares, friction=5%,base=2%")?;
        let name = name.trim().to_owned();
        if named.iter().any(|(before, _)| *before == name) {
            return Err(format!("{name} stands twice"));
        }
        named.push((name, share(text)?));
    }
    Ok(Spread::Named(named))
}

/// The name of a command.
fn command_name(text: &str) -> Result<String, String> {
    let names: Vec<String> = Cli::command().get_subcommands().map(|one| one.get_name().to_owned()).collect();
    let found = names.contains(&text.to_owned());
    if found { Ok(text.to_owned()) } else { Err(format!("expected one of {}", names.join(", "))) }
}

/// The program, or one of its commands under its whole name, as clap describes it.
pub(crate) fn described(command: Option<&str>) -> clap::Command {
    let program = Cli::command();
    let found = command.and_then(|name| Some((name, program.find_subcommand(name)?.clone())));
    match found {
        Some((name, found)) => {
            let whole = format!("standfast-{name}");
            found.display_name(whole).bin_name(format!("standfast {name}")).version(VERSION.as_str())
        }
        None => program,
    }
}

/// The kinds of cases to begin from.
fn beginnings() -> impl TypedValueParser<Value = &'static Beginning> {
    let named = |name: String| Beginning::find(&name).expect("it is one of the names");
    PossibleValuesParser::new(BEGINNINGS.map(|beginning| beginning.name)).map(named)
}

fn time_step(text: &str) -> Result<f64, String> {
    let step = text.trim().parse().ok().filter(|step: &f64| *step > 0.0 && step.is_finite());
    step.ok_or_else(|| "expected a number above zero".to_owned())
}

fn factor(text: &str) -> Result<f64, String> {
    let factor = text.trim().parse().unwrap_or(f64::NAN);
    check_up_to(factor).map_err(|error| error.to_string())
}
