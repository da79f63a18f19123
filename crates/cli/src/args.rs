//! The command line.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;
use standfast::{InputError, Point};

use crate::batch::OnError;
use crate::draw::{KMu, Picture, PictureFile};
use standfast_figures::FigureId;

const EXIT_CODES: &str = "\
Exit codes:
  0  done
  1  the input is wrong, or a file cannot be read or written
  2  the command line is wrong

Example:
  standfast assess examples/caisson-in-air.toml";

/// Does a freestanding body on a rough base rest, slide, rock, or slide and rock under a horizontal force?
///
/// The symbols are the report's: γ = height/width; k = F/(m g); k' the height of the force above the centre of mass,
/// in half-heights (-1 at the base, 0 at the centre, 1 at the crest); μ Coulomb friction.
#[derive(Debug, Parser)]
#[command(name = "standfast", version, max_term_width = 100, after_help = EXIT_CODES)]
pub struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// A subcommand.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Assess a body and its loads from a case file
    ///
    /// Prints the mode of response, the inequalities that decide it, safety factors, accelerations and reactions at
    /// onset, and where the mode changes; draws the case in the k–μ plane.
    #[command(after_help = "Example:\n  standfast assess examples/caisson-in-air.toml\n\n\
        Example of a case file (numbers without unit are SI: m, kg/m, kg/m3, N/m):\n\
        \u{20} [body]\n\
        \u{20} width = \"15 m\"\n\
        \u{20} height = \"12 m\"\n\
        \u{20} density = \"2.1 t/m3\"    # or mass = \"378 t/m\"\n\
        \u{20} friction = 0.6\n\n\
        \u{20} [[load]]                # one such table for each load\n\
        \u{20} force = \"450 kN/m\"\n\
        \u{20} elevation = \"8 m\"       # above the base\n\
        \u{20} direction = \"left\"      # or \"right\"; left if not given\n\n\
        Optional: title, note, gravity = \"9.81 m/s2\" at the top; name in a load.")]
    Assess(AssessArgs),

    /// Classify one point of the k–μ plane
    #[command(
        after_help = "Example:\n  standfast classify --gamma 0.8 --k-prime 0.333 --k 0.5 --mu 0.6 --explain"
    )]
    Classify(ClassifyArgs),

    /// Draw the k–μ diagram of a body and an elevation of the force
    #[command(
        after_help = "Example:\n  standfast diagram --gamma 1 --k-prime 0.4 --point 0.5,0.6 -o diagram.svg"
    )]
    Diagram(DiagramArgs),

    /// Draw the report's figures
    #[command(after_help = "Example:\n  standfast figures -o figures 3.3a 4.7b --as pdf")]
    Figures(FiguresArgs),

    /// Classify every row of a table
    ///
    /// The table is a CSV file with a header. Columns gamma, k_prime, k and mu stand in any order; all columns are
    /// carried over as they are, and mode, unique, also, x_ddot, y_ddot, theta_ddot, f_x, f_y and xi are appended.
    /// Accelerations are in g, theta_ddot in g/B, forces in m g and xi in B; `also` lists the other consistent modes
    /// where the answer is not unique.
    #[command(after_help = "Example:\n  standfast batch examples/points.csv -o modes.csv")]
    Batch(BatchArgs),

    /// Print a completion script for a shell
    #[command(
        after_help = "Example:\n  standfast completions bash > ~/.local/share/bash-completion/completions/standfast"
    )]
    Completions {
        /// The shell
        shell: Shell,
    },
}

/// How an answer is printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum Format {
    /// For reading, with four significant digits
    #[default]
    Text,
    /// One JSON document, at full precision
    Json,
}

/// Arguments of `assess`.
#[derive(Debug, Args)]
pub struct AssessArgs {
    /// The case file (TOML)
    #[arg(value_name = "CASE.toml")]
    pub case: PathBuf,
    /// Where to put the diagrams; made if it is not there [default: beside the case file]
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// How to print the answer
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
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

/// Arguments of `figures`.
#[derive(Debug, Args)]
pub struct FiguresArgs {
    /// Where to put the figures; made if it is not there
    #[arg(short, long, value_name = "DIR")]
    pub output: PathBuf,
    /// Figures by the report's numbers, e.g. 3.11 or 4.7a [default: all 26]
    #[arg(value_name = "NUMBER")]
    pub numbers: Vec<FigureId>,
    /// What to write
    #[arg(long = "as", value_enum, default_value = "svg", value_name = "KIND")]
    pub picture: Picture,
    /// Pixels of a png per unit of the svg
    #[arg(long, value_name = "S", default_value = "2", allow_hyphen_values = true, value_parser = scale)]
    pub scale: f32,
}

/// Arguments of `batch`.
#[derive(Debug, Args)]
pub struct BatchArgs {
    /// The table (CSV); - reads standard input
    #[arg(value_name = "POINTS.csv")]
    pub input: PathBuf,
    /// The file to write; - writes to standard output, as far as rows make sense
    #[arg(short, long, value_name = "OUT.csv")]
    pub output: PathBuf,
    /// What to do with a row that makes no sense
    #[arg(long, value_enum, default_value_t, value_name = "ACTION")]
    pub on_error: OnError,
}

/// A number that [`Point::new`] takes in one of its places, the others being one.
fn number(text: &str, point: impl FnOnce(f64) -> Result<Point, InputError>) -> Result<f64, String> {
    let value: f64 = text.trim().parse().map_err(|_| "expected a number".to_owned())?;
    point(value).map(|_| value).map_err(|error| format!("expected {}", error.expected))
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
