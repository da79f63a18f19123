//! The command line.

use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::str::FromStr;

use clap::{Args, Parser, Subcommand};
use clap_complete::Shell;
use standfast::ground::bearing::{BearingPlane, Ground, GroundLaw};
use standfast::ground::strength::CrushPoint;
use standfast::{InputError, Point};

use standfast_cases::check_up_to;
use standfast_cases::design::Target;
use standfast_cases::motion::{SpectrumKind, SpectrumSteps};
use standfast_cases::random::{MethodAsked, ValueRange};
use standfast_figures::FigureId;
use standfast_sheet::{Date, Paper};
use standfast_tables::{Mapping, OnError, TableFormat, TableProblem};

use crate::design::BoundaryFile;
use crate::draw::{KMu, PictureFile, PictureFormat};
use crate::format::Format;
use crate::probability::DrawsFile;
use crate::sheet::SheetFile;
use crate::title_block::TitleBlock;

const EXIT_CODES: &str = "\
Exit codes:
  0  done
  1  the input is wrong, or a file cannot be read or written
  2  the command line is wrong
  3  with --check: a criterion of the case is not met

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
    /// Prints pressures, forces and moments, safety factors and bearing pressures, the mode of response under the full
    /// load with the inequalities that decide it, accelerations and reactions at onset, where the body first leaves rest as
    /// the variable loads rise, and where the mode changes. Draws the case in the k–μ plane, one diagram for every elevation
    /// of a force, and with water, waves, uplift or an earthquake the path of the rising load as well.
    #[command(after_help = "Example:\n  standfast assess examples/caisson-in-air.toml\n\n\
        Example of a case file (numbers without unit are SI: m, kg/m, kg/m3, N/m; objects kg, N):\n\
        \u{20} [body]\n\
        \u{20} width = \"15 m\"\n\
        \u{20} height = \"12 m\"\n\
        \u{20} density = \"2.1 t/m3\"    # or mass = \"378 t/m\"\n\
        \u{20} friction = 0.6\n\n\
        \u{20} [[load]]                # one such table for each load\n\
        \u{20} force = \"450 kN/m\"\n\
        \u{20} elevation = \"8 m\"       # above the base\n\
        \u{20} direction = \"left\"      # or \"right\"; left if not given\n\n\
        Optional: title, note, gravity = \"9.81 m/s2\" at the top. In a load: name; direction down or up with\n\
        its distance right of O; permanent = true; together = true. A load that is neither acts alone, as an\n\
        alternative to the others, beside all loads below.\n\n\
        More loads, which act together (quantities with units as above):\n\
        \u{20} [water]       level, or left and right, above the base; density\n\
        \u{20} [uplift]      left, right: pressures at the corners; grows = true to rise with the variable loads\n\
        \u{20} [earthquake]  horizontal, vertical: 0.2, \"0.2 g\" or \"2 m/s2\"; to both sides and both ways unless\n\
        \u{20}               horizontal_fixed = true, vertical_fixed = true\n\
        \u{20} [wave]        Goda's pressures, sea at the right: deep_water_height, or H13 and Hmax; period,\n\
        \u{20}               sea_bottom_slope, water_depth, depth_above_berm, base_depth, crest_height,\n\
        \u{20}               berm_width, angle_deg, water_density; optional caisson_width, turn_deg,\n\
        \u{20}               impulsive = true, lambda = [1, 1, 1], uplift = false\n\
        \u{20} [[pressure]]  face = \"left\", \"right\", \"base\" or \"top\"; elevation = [\"0 m\", \"9 m\"] on a\n\
        \u{20}               side, distance right of O on base and top; pressure = [\"54 kPa\", 0]; name;\n\
        \u{20}               permanent = true; scale\n\
        \u{20} [added_mass]  sides = \"right\", \"left\" or \"both\", or mass\n\
        \u{20} [[part]]      in place of width, height and mass: left, width, bottom, height, top_left,\n\
        \u{20}               top_width, or corners x and y; density, density_below_water; name\n\
        \u{20} [body]        length, for a single object with masses in kg and forces in kN;\n\
        \u{20}               shape = \"cylinder\"; kinetic_friction, centroid_offset, centroid_height,\n\
        \u{20}               moment_of_inertia, base_left, base_right; buoyant_weight and weight_arm\n\
        \u{20}               in place of [water]\n\n\
        Which loads act, and what is asked of the results:\n\
        \u{20} [[combination]]  name; factors = { weight = 0.9, wave = 1.3, crane = 1.5 }, by the names of\n\
        \u{20}               loads, or weight, water, uplift, wave, earthquake; of the loads not named the\n\
        \u{20}               permanent ones act as they are, the variable ones not at all\n\
        \u{20} [criteria]    SF_sliding, SF_overturning, contact_share, load_factor: at least; bearing_max,\n\
        \u{20}               eccentricity, p_not_rest: at most; modes_not = [\"RO\", \"SRO-\"]\n\n\
        --format json prints one document, schema 1, in SI units: docs/answer.schema.json.")]
    Assess(AssessArgs),

    /// Find the least or the greatest value of a quantity of a case that meets a target
    ///
    /// Prints the value, rounded to the safe side and assessed as it is printed, what binds just beyond it, where else in the
    /// range the target is met, and what every number of the case does to both safety factors and to the load factor at which the
    /// body first leaves rest. Each value tried goes through the whole case, waves and water included; what has to go with it
    /// does: the mass with the width, the crest with the height.
    ///
    /// With --and, the same for many values of another quantity: the boundary of what meets the target, as a table, and with -o
    /// as a picture or CSV.
    #[command(
        after_help = "Targets, in every situation of the case and under every acceleration of the base:\n\
        \u{20} rest                  the body rests under the full load\n\
        \u{20} factor=1.2            both safety factors are 1.2 at least\n\
        \u{20} no-rock               the body turns about no corner, at once or while the load rises\n\
        \u{20} no-slide              the body slips at no corner, at once or while the load rises\n\
        \u{20} SF_sliding=1.2, SF_overturning=1.2, load_factor=1.2, bearing_max=300kPa, contact_share=0.5,\n\
        \u{20} eccentricity=2m, p_not_rest=1e-3 (with [random]: the upper end of its interval), modes_not='[\"RO\"]'\n\
        \u{20}                       a criterion, as [criteria] has it\n\
        \u{20} criteria              all [criteria] of the case are met\n\
        \u{20} utilisation=0.9       of each of them 0.9 at most is used\n\n\
        Examples:\n\
        \u{20} standfast design examples/goda-2000.toml --vary width --target factor=1.2\n\
        \u{20} standfast design examples/goda-2000.toml --vary wave.Hmax --greatest --target rest\n\
        \u{20} standfast design examples/goda-2000.toml --vary width --and friction --target factor=1.2 -o set.svg"
    )]
    Design(DesignArgs),

    /// Write the calculation sheet of a case: what an engineer files and a checker signs
    ///
    /// Inputs with their sources, assumptions, every step as formula, numbers put in and result, both safety factors, the mode
    /// of response with the margins of its inequalities, figures, sensitivity, what is not covered, room for signatures: one
    /// HTML file that loads nothing, reads on a phone and prints on A4 and Letter with page numbers. A PDF is printed by
    /// Chromium or Chrome, if there is one. The case file's hash and the program's version stand on the sheet; the same case,
    /// options and version give the same bytes.
    #[command(after_help = "Environment:\n\
        \u{20} STANDFAST_BROWSER   the browser that prints a PDF, if not the first Chromium or Chrome found\n\n\
        Example:\n  standfast sheet examples/goda-2000.toml --date 2026-11-21 -o goda-2000.html")]
    Sheet(SheetArgs),

    /// Follow the motion of a body in time, from event to event to its end
    ///
    /// Prints what becomes of the body, its slide and rotation, each change of state with its time and reason, and where the energy
    /// went: rest, slide, rock, slide-rock, impacts, flight, overturning. Events are found as roots, and no step of time is to be
    /// chosen. Draws the histories, the positions and an animation beside the case file; with several situations those of the worst.
    #[command(
        after_help = "Example of a case (lengths in any one unit, the mass as 1, accelerations as they come):\n\
        \u{20} [block]\n\
        \u{20} b1 = 1                     # O left of the centre of mass C; b2: O' right of it; d: the base below it\n\
        \u{20} b2 = 1\n\
        \u{20} d = 3                      # rho2 = I/m left out: (1 + d^2)/3, a uniform block with b1 = b2 = 1\n\
        \u{20} mu_s = 0.4                 # mu_k and mu_impact left out: the same; m_x, m_y left out: 1\n\
        \u{20} gravity = 1\n\n\
        \u{20} [[block.load]]             # as many as there are\n\
        \u{20} at = [0, 1]                # from C, fixed in the body\n\
        \u{20} direction = [-1, 0]        # fixed in space; with follows = true it turns with the body\n\
        \u{20} history = { shape = \"triangle\", peak = 0.9, rise = 0.5, duration = 2 }\n\n\
        \u{20} [motion]\n\
        \u{20} impact = { law = \"inelastic\" }   # or \"housner\", or { law = \"ratio\", ratio = 0.9 }\n\
        \u{20} t_max = 100                # 200 (R/g)^0.5 after the loads, if left out\n\
        \u{20} [motion.initial]           # theta, omega, vx, vy, gap\n\
        \u{20} [motion.base]\n\
        \u{20} horizontal = { shape = \"file\", file = \"record.AT2\", factor = 1 }   # and vertical\n\n\
        Shapes, each with start: constant (peak), rect (peak, duration), triangle (peak, rise, duration; of a\n\
        [wave] also duration = \"shimosako-takahashi\"), decay,\n\
        half-sine (peak, duration), sine (peak, angular_frequency or period, phase, duration), church-roof (peak,\n\
        rise, impact_duration, tail, duration), points (times, values, peak), file (file, column of a CSV, dt where\n\
        it has no times, factor or target_peak, baseline = \"mean\" or \"linear\").\n\n\
        In place of [block], a case as `assess` has it: [body], [[load]], [wave] and so on, with [motion]; each load\n\
        that varies, and [wave], has a history, whose peak is a factor (1 if left out); quantities take units.\n\
        Loads that act alone, and combinations, are followed one by one, the worst first.\n\n\
        Example:\n  standfast simulate examples/motion/caisson-breaking-wave.toml --series motion.csv --dt 0.01"
    )]
    Simulate(SimulateArgs),

    /// Rocking, Newmark and overturning spectra of a shaking
    ///
    /// Many motions, over size and slenderness, over the yield acceleration, or over the strength of the shaking. The shaking, friction, gravity and law of impacts are those of a case with [motion.base]. A rocking spectrum is of uniform
    /// blocks that have these in common; a Newmark spectrum of a block that can only slide, to one side as on a slope, and to both; an
    /// overturning curve of the body of the case itself. That one is scanned, and each turn refined, for a stronger shaking may leave
    /// standing what a weaker one overturns. Writes a figure and, if asked, every point as CSV.
    #[command(after_help = "Examples:\n\
        \u{20} standfast spectrum examples/motion/statue-earthquake.toml --size 0.3,5,60 --slenderness 2,8,40\n\
        \u{20} standfast spectrum examples/motion/statue-earthquake.toml --kind newmark --csv slides.csv\n\
        \u{20} standfast spectrum examples/motion/statue-earthquake.toml --kind overturning --scale 0.2,6,300")]
    Spectrum(SpectrumArgs),

    /// How likely each mode is if some numbers of a case are random
    ///
    /// Prints the probability of every mode under the loads of one event and, where years are given, of meeting it at least once in
    /// a life; the reliability index beside it; and which number matters, and what knowing it would gain. For given other numbers
    /// each mode is an interval of the friction between curves known in closed form, so that friction is not sampled; where it is
    /// certain, a load takes its place.
    #[command(
        after_help = "The [random] table of a case (means left out are the case's own values; 1 of a bias):\n\
        \u{20} [random]\n\
        \u{20} years = 50                  # optional: over a life as well\n\
        \u{20} friction               = { normal = { mean = 0.6, sd = 0.1 } }\n\
        \u{20} wave.deep_water_height = { gumbel = { mean = \"4.5 m\", sd = \"0.9 m\" }, lower = \"1 m\", every = \"year\" }\n\
        \u{20} mass                   = { normal = { cov = 0.02 } }\n\
        \u{20} bias.P                 = { lognormal = { mean = 0.91, cov = 0.19 } }\n\
        \u{20} \"load.push.force\"      = { uniform = { from = \"300 kN/m\", to = \"500 kN/m\" } }\n\n\
        \u{20} [[random.correlation]]\n\
        \u{20} between = [\"friction\", \"bias.P\"]\n\
        \u{20} rank = 0.3                  # Spearman; or linear, of the values; or normal, of the normals behind\n\n\
        Names are keys of the case file, with what goes with them when they vary; a load is named by its name. bias.P,\n\
        bias.U: what the wave's thrust and uplift are multiplied by, their moments too unless bias.M_p, bias.M_U are\n\
        given; bias.force: every [[load]].\n\
        Laws: normal, lognormal (mean, sd or cov); gumbel of maxima (mean, sd; mode, scale; or \"10 years\" and\n\
        \"100 years\" with their values); weibull (scale, shape, location); gev (location, scale, shape); uniform (from,\n\
        to); triangular (from, mode, to); max_of (count and a law). lower and upper truncate. every = \"life\" is drawn\n\
        once, \"year\" each year.\n\
        In place of a case: [point] with gamma, k_prime, k and mu, of which any may be random.\n\n\
        How far the waves of a life slide a caisson, a storm each year:\n\
        \u{20} [storm]\n\
        \u{20} waves = 1000                # or duration and period; heights by Rayleigh's law, cut at H_max unless cut = false\n\
        \u{20} tau0 = \"1.5 s\"              # how long a wave pushes; or \"shimosako-takahashi\"\n\
        \u{20} pulse = \"triangle\"          # exact; or \"shimosako\", the published formula\n\
        Without a [body] a [storm] has force_per_height, uplift_per_height, significant_height, buoyant_weight, mass and\n\
        friction, of which any may be random.\n\n\
        Of a body on a base that moves, [motion.base], overturning over the peak of the shaking, --over \"pga=0.2 g..1 g:9\":\n\
        \u{20} records = [\"a.smc\", \"b.smc\"]   # under [random]: one for each body in turn, in the place of the case's own\n\n\
        Examples:\n\
        \u{20} standfast probability examples/goda-2000-random.toml\n\
        \u{20} standfast probability examples/goda-2000-random.toml --over \"width=12 m..20 m:9\""
    )]
    Probability(ProbabilityArgs),

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

    /// Answer every row of a table: points, or cases
    ///
    /// The extensions tell the formats of input and output, in any combination: CSV with a header (.csv, .txt, and
    /// names without extension), Parquet (.parquet, .pq), Arrow IPC file (.arrow, .ipc, .feather) or stream (.arrows), Excel
    /// workbook (.xlsx). All columns are carried over as they are, and results are appended.
    ///
    /// With --case every row is the case of a file with other numbers: a column varies the number whose key it is called by,
    /// as in wave.Hmax or water_level, with the unit of its numbers in brackets behind it if that is not SI; what goes with
    /// it is said at the end. The results are those of the situation that governs, under the names and in the SI units of
    /// `assess --format json`.
    ///
    /// A case with a table `motion` or `block` is followed in time for every row: a column is called by the place of what it varies in the file,
    /// as in block.mu_s or motion.base.horizontal.file, and the results are end, slide, max_slide, max_theta,
    /// max_theta_of_balance, overturned, past_balance, impacts, t_rest, t_final, unique, situation and warnings. Such tables are CSV.
    ///
    /// Else the rows are points, with the columns gamma, k_prime, k and mu in any order. The results are mode, unique,
    /// also, x_ddot, y_ddot, theta_ddot, f_x, f_y and xi: accelerations in g, theta_ddot in g/B, forces in m g and xi in B;
    /// `also` lists the other consistent modes where the answer is not unique.
    ///
    /// With --problem wrench the columns are b1, b2, d, rho2, m_x, m_y, x, p, m, mu_s and mu_k, non-dimensional by the
    /// mass, g and one length: distances of O, O' and the base from the centre of mass, squared radius of gyration,
    /// inertia, the wrench at the centre of mass (right, down with the weight, counter-clockwise), friction to stick
    /// and to slip. Appended are modes (all consistent ones), mode (the one reported) and its motion in the same
    /// units.
    #[command(after_help = "Examples:\n\
        \u{20} standfast batch examples/points.csv -o modes.csv\n\
        \u{20} standfast batch points.parquet -o modes.parquet --map mu=friction --columns mode,unique\n\
        \u{20} standfast batch examples/sea-states.csv --case examples/goda-2000.toml -o answers.csv")]
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

/// Number of threads: those asked for, or one for each core.
pub(crate) fn threads(asked: Option<NonZeroUsize>) -> usize {
    asked.or_else(|| std::thread::available_parallelism().ok()).map_or(1, NonZeroUsize::get)
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
    /// Show and draw every situation one by one; of more than 8, only the worst are
    #[arg(long)]
    pub all: bool,
    /// End with exit code 3 if a criterion of the case is not met
    #[arg(long)]
    pub check: bool,
    /// Print the top of the answer alone: criteria, what happens, how near another answer is; figures only where --output says so
    #[arg(long, conflicts_with = "format")]
    pub brief: bool,
    /// How to print the answer
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// Treatment of waves that begin a rotation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, clap::ValueEnum)]
pub enum RotationsArg {
    /// They are counted apart, and slide the body nowhere
    #[default]
    Count,
    /// Each that is drawn is followed in time: slides, rocking, impacts without rebound, overturning
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
    /// How: integrate (three random numbers at most), sobol, importance or monte-carlo [default: the best that takes as
    /// many]; form adds the nearest point of every mode to that
    #[arg(long)]
    pub method: Option<MethodAsked>,
    /// The seed of all random numbers
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// How wide half of a 95 % interval may be, relative to its probability
    #[arg(long, default_value = "0.05", value_parser = part, allow_negative_numbers = true)]
    pub precision: f64,
    /// Probabilities up to this need not be precise
    #[arg(long, default_value = "1e-6", value_parser = part, allow_negative_numbers = true)]
    pub floor: f64,
    /// The most points that are taken, but for 32 at least, or 16384 by monte-carlo; a motion followed in time counts as
    /// 1024
    #[arg(long, default_value_t = 1 << 22, value_parser = clap::value_parser!(u64).range(1..), allow_negative_numbers = true)]
    pub samples: u64,
    /// The years of a life, before those of the file
    #[arg(long, value_parser = time_step, allow_negative_numbers = true)]
    pub years: Option<f64>,
    /// The same along a number of the case, with what goes with it: FROM and TO as in the case file, COUNT values; pga of a case with
    /// [motion.base]: overturning in time, the shaking scaled to each peak
    #[arg(long, value_name = "NAME=FROM..TO:COUNT")]
    pub over: Option<ValueRange>,
    /// Write draws of the random numbers, each with its weight and mode: .csv, .parquet, .arrow or .xlsx; those counted by monte-carlo,
    /// beside other methods 65 536 independent ones at most
    #[arg(long, value_name = "FILE")]
    pub draws: Option<DrawsFile>,
    /// What becomes of waves that begin a rotation: counted apart, or followed by the motion in time
    #[arg(long, value_enum, default_value_t)]
    pub rotations: RotationsArg,
    /// Print a table of random numbers for the case, with laws of practice and their sources, and answer nothing
    #[arg(long, conflicts_with_all = ["over", "draws", "method"])]
    pub template: bool,
    /// How many threads work; the answer does not depend on it [default: as many as the machine has cores]
    #[arg(long)]
    pub threads: Option<NonZeroUsize>,
    /// End with exit code 3 if p_not_rest of [criteria] is not met
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
    /// Find how much stronger or weaker the loads have to be for another verdict, whatever it takes: 46 motions, or N between 0.8 and
    /// 1.2 times the loads; without it where no record is as long as 20,000 points
    #[arg(long, value_name = "N", conflicts_with = "no_strength", value_parser = motions)]
    pub strength: Option<Option<u16>>,
    /// Leave that out
    #[arg(long)]
    pub no_strength: bool,
    /// Changes nothing: how far the motion parts from that of almost the same body is always said
    #[arg(long, hide = true)]
    pub sensitivity: bool,
    /// Show every event
    #[arg(long)]
    pub all: bool,
    /// End with exit code 3 if a criterion of the motion is not met
    #[arg(long)]
    pub check: bool,
    /// Print the top of the answer alone: criteria, what happens, how near another answer is; figures only where --output says so
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
    /// Which spectrum: rocking, newmark or overturning
    #[arg(long, default_value = "rocking", value_name = "KIND", value_parser = SpectrumKind::from_str)]
    pub kind: SpectrumKind,
    /// Half diagonals of the blocks, at equal factors [default: a quarter of the case's to its eightfold, 41 of them]
    #[arg(long, value_name = "FROM,TO[,COUNT]")]
    pub size: Option<SpectrumSteps>,
    /// Heights of the blocks over their widths, at equal steps [default: 2,8,31]
    #[arg(long, value_name = "FROM,TO[,COUNT]")]
    pub slenderness: Option<SpectrumSteps>,
    /// Yield accelerations over the peak of the shaking, at equal steps [default: 0.02,0.98,49]
    #[arg(long, value_name = "FROM,TO[,COUNT]")]
    pub ratio: Option<SpectrumSteps>,
    /// Factors on the shaking, at equal steps [default: 0.05,5,199]
    #[arg(long, value_name = "FROM,TO[,COUNT]")]
    pub scale: Option<SpectrumSteps>,
    /// Write every point to a CSV file; - writes to standard output in place of the answer
    #[arg(long, value_name = "OUT.csv")]
    pub csv: Option<PathBuf>,
    /// Where to put the figure; made if it is not there [default: beside the case file, or here if it is read from
    /// standard input]
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// How many threads work; the answer does not depend on it [default: as many as the machine has cores]
    #[arg(long)]
    pub threads: Option<NonZeroUsize>,
    /// How to print the answer
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
}

/// Arguments of `design`.
#[derive(Debug, Args)]
pub struct DesignArgs {
    /// The case file (TOML); - reads standard input
    #[arg(value_name = "CASE.toml")]
    pub case: PathBuf,
    /// What to vary: width, height, mass, friction, water_level, crest_height, or any number of the case as in wave.period
    #[arg(long, value_name = "QUANTITY")]
    pub vary: String,
    /// What to reach
    #[arg(long, value_name = "TARGET")]
    pub target: Target,
    /// The least value that meets the target; so it is if nothing is said
    #[arg(long, conflicts_with = "greatest")]
    pub least: bool,
    /// The greatest value that meets the target
    #[arg(long)]
    pub greatest: bool,
    /// Where to begin, as the case file has the quantity, e.g. "8 m" or 8 [default: a fifth of the present value]
    #[arg(long, value_name = "A", allow_hyphen_values = true)]
    pub from: Option<String>,
    /// Where to end [default: five times the present value]
    #[arg(long, value_name = "B", allow_hyphen_values = true)]
    pub to: Option<String>,
    /// Another quantity: the answer for each of many values of it
    #[arg(long, value_name = "QUANTITY")]
    pub and: Option<String>,
    /// Where the other quantity begins [default: half the present value]
    #[arg(long, value_name = "A", allow_hyphen_values = true, requires = "and")]
    pub and_from: Option<String>,
    /// Where it ends [default: twice the present value]
    #[arg(long, value_name = "B", allow_hyphen_values = true, requires = "and")]
    pub and_to: Option<String>,
    /// With --and: a file to write; its extension is svg, png, pdf or csv. May be given again
    #[arg(short, long, value_name = "FILE", requires = "and")]
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
    /// The day the sheet bears [default: none; the sheet says that it is undated]
    #[arg(long, value_name = "YYYY-MM-DD")]
    pub date: Option<Date>,
    /// How far to follow the rising load, as a multiple of the full load
    #[arg(long, value_name = "FACTOR", default_value = "2", allow_hyphen_values = true, value_parser = factor)]
    pub up_to: f64,
    /// The size of a PDF's pages
    #[arg(long, value_enum, default_value_t)]
    pub paper: Paper,
    /// What goes into the title block before what the case file says
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
    /// Share ω = P/(2B q_u) of a base that crushes: what the weight alone needs of it; from 1 on the ground fails (BF) [default: 0, a rigid base]
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
    /// Share ω = P/(2B q_u) of a base that crushes, below 1; the map of a rigid base is drawn in grey behind
    #[arg(long, value_name = "W", allow_hyphen_values = true, value_parser = omega, conflicts_with = "law")]
    pub omega: Option<f64>,
    /// The plane of ground that fails, by this law of its bearing resistance
    #[arg(long, value_enum, value_name = "LAW", requires = "share")]
    pub law: Option<BearingLaw>,
    /// Share u = P/V0 of the vertical resistance of the ground, centric and upright, that the weight takes
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
    /// Where to put the figures; made if it is not there
    #[arg(short, long, value_name = "DIR")]
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
    /// Which problem the rows are
    #[arg(long, value_enum, default_value_t)]
    pub problem: TableProblem,
    /// The name one of our columns has in the table, e.g. mu=friction or wave.Hmax=H; may be given again
    #[arg(long, value_name = "OURS=THEIRS")]
    pub map: Vec<Mapping>,
    /// What to compute, in this order, e.g. mode,unique,x_ddot or SF_sliding,load_factor [default: all results]
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    pub columns: Vec<String>,
    /// What to do with a row that makes no sense
    #[arg(long, value_enum, default_value_t, value_name = "ACTION")]
    pub on_error: OnError,
    /// How many threads work; the result is the same for any number [default: one for each core]
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

fn time_step(text: &str) -> Result<f64, String> {
    let step = text.trim().parse().ok().filter(|step: &f64| *step > 0.0 && step.is_finite());
    step.ok_or_else(|| "expected a number above zero".to_owned())
}

fn factor(text: &str) -> Result<f64, String> {
    let factor = text.trim().parse().unwrap_or(f64::NAN);
    check_up_to(factor).map_err(|error| error.to_string())
}
