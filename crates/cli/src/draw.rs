//! `standfast diagram` and `standfast figures`, and what `standfast design` draws: pictures in files.

use std::fmt;
use std::path::{Path, PathBuf};
use std::str::FromStr;

use clap::ValueEnum;
use standfast::ground::bearing::BearingPlane;
use standfast::ground::strength::CrushMap;
use standfast::{Diagram, InputError};
use standfast_figures::{
    DesignPoint, DiagramContent, Figure, FigureId, KMuPlane, diagram_with, report_figure,
};

use crate::args::DiagramArgs;
use crate::error::{CommandError, Result};
use crate::features::{Feature, LeftOut};
use crate::files_read::FilesRead;
use crate::write::{self, ExtensionError};

/// Format of a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum PictureFormat {
    /// Scalable vector graphics.
    Svg,
    /// Pixels.
    Png,
    /// A page.
    Pdf,
}

impl PictureFormat {
    fn extension(self) -> &'static str {
        match self {
            PictureFormat::Svg => "svg",
            PictureFormat::Png => "png",
            PictureFormat::Pdf => "pdf",
        }
    }

    /// That this build can write it; `asked` is who asks for it.
    fn require(self, asked: &str) -> Result<(), LeftOut> {
        match self {
            PictureFormat::Svg => Ok(()),
            PictureFormat::Png => Feature::Pictures.require(asked, "PNG"),
            PictureFormat::Pdf => Feature::Pictures.require(asked, "PDF"),
        }
    }
}

/// A picture's file, whose extension says how it is written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PictureFile {
    path: PathBuf,
    picture: PictureFormat,
}

impl FromStr for PictureFile {
    type Err = ExtensionError;

    fn from_str(text: &str) -> Result<PictureFile, ExtensionError> {
        let (path, picture) = write::by_extension(text, "svg, png or pdf", PictureFile::kind)?;
        Ok(PictureFile { path, picture })
    }
}

impl PictureFile {
    /// A file that is written as a kind of picture.
    pub fn new(path: PathBuf, picture: PictureFormat) -> PictureFile {
        PictureFile { path, picture }
    }

    /// The kind of picture of an extension in lower case.
    pub fn kind(extension: &str) -> Option<PictureFormat> {
        PictureFormat::from_str(extension, false).ok()
    }

    /// Path of the file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Writes a figure into it, over no file that was `read`, a PNG with `scale` pixels per unit of the figure.
    ///
    /// # Errors
    /// If the picture cannot be made or written.
    pub fn save(&self, figure: &Figure, scale: f32, read: &FilesRead) -> Result<()> {
        save(figure, &self.path, self.picture, scale, read)
    }
}

/// A point K,MU of the command line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KMu {
    /// k.
    pub k: f64,
    /// μ.
    pub mu: f64,
}

fn save(figure: &Figure, path: &Path, picture: PictureFormat, scale: f32, read: &FilesRead) -> Result<()> {
    match picture {
        PictureFormat::Svg => write::write_file(path, figure.svg().as_bytes(), read),
        PictureFormat::Png | PictureFormat::Pdf => {
            write::write_file(path, &rendered(figure, path, picture, scale)?, read)
        }
    }
}

#[cfg(feature = "pictures")]
fn rendered(figure: &Figure, path: &Path, picture: PictureFormat, scale: f32) -> Result<Vec<u8>> {
    let bytes = if picture == PictureFormat::Png { figure.png(scale) } else { figure.pdf() };
    bytes.map_err(|cause| CommandError::Render { path: path.to_owned(), cause })
}

#[cfg(not(feature = "pictures"))]
fn rendered(_: &Figure, path: &Path, picture: PictureFormat, _: f32) -> Result<Vec<u8>> {
    picture.require(&path.display().to_string())?;
    Ok(Vec::new())
}

/// The k–μ plane that the command line asks for.
///
/// # Errors
/// If there can be none.
pub fn plane(args: &DiagramArgs) -> Result<KMuPlane, InputError> {
    let (gamma, k_prime) = (args.gamma, args.k_prime);
    match (args.law, args.share, args.omega) {
        (Some(law), Some(share), _) => {
            BearingPlane::of_share(law.ground(), gamma, k_prime, share).map(KMuPlane::Failing)
        }
        (.., Some(omega)) if omega > 0.0 => CrushMap::new(gamma, k_prime, omega).map(KMuPlane::Crushing),
        _ => Diagram::new(gamma, k_prime).map(KMuPlane::Rigid),
    }
}

/// Draws the k–μ plane with points on it.
///
/// # Errors
/// If the picture cannot be made or written.
pub fn draw_diagram(plane: &KMuPlane, points: &[KMu], file: &PictureFile, scale: f32) -> Result<()> {
    // The caption gives the coordinates.
    let label = |i: usize| if points.len() == 1 { String::new() } else { (i + 1).to_string() };
    let points: Vec<_> = points
        .iter()
        .enumerate()
        .map(|(i, &KMu { k, mu })| DesignPoint { k, mu, label: label(i), mirrored: false })
        .collect();
    let content = DiagramContent { points: &points, ..DiagramContent::default() };
    let figure = diagram_with(plane, &content);
    file.save(&figure, scale, &FilesRead::default())
}

/// Draws figures of the report into a directory, which is made if it is not there, or one into a file, whose extension says how it is
/// written; gives the files written.
///
/// # Errors
/// If several are to go into one file, or a picture cannot be made or written.
pub fn draw_figures(
    output: &Path,
    figures: &[FigureId],
    picture: PictureFormat,
    scale: f32,
) -> Result<Vec<PathBuf>> {
    let extension = output.extension().and_then(|extension| PictureFile::kind(&extension.to_string_lossy()));
    if let Some(picture) = extension.filter(|_| !output.is_dir()) {
        let [id] = figures else { return Err(CommandError::OneFile { path: output.to_owned() }) };
        save(&report_figure(*id), output, picture, scale, &FilesRead::default())?;
        return Ok(vec![output.to_owned()]);
    }
    picture.require(&format!("--as {}", picture.extension()))?;
    write::make_directory(output)?;
    figures
        .iter()
        .map(|&id| {
            let path = output.join(format!("fig-{id}.{}", picture.extension()));
            save(&report_figure(id), &path, picture, scale, &FilesRead::default())?;
            Ok(path)
        })
        .collect()
}

impl fmt::Display for PictureFile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.path.display().fmt(f)
    }
}
