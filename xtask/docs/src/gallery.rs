//! docs/gallery.md and what it shows: the report's figures, those of the worked cases, a calculation sheet.

use std::path::Path;
use std::{fs, io};

use standfast::ground::bearing::{BearingPlane, Ground, GroundLaw};
use standfast::ground::strength::CrushMap;
use standfast_cases::design::{BoundaryRequest, DesignBoundary, DesignRequest, Extreme, Spelling};
use standfast_cases::motion::{Follow, FollowedMotion, MotionView, Spectrum, SpectrumKind, SpectrumRequest};
use standfast_cases::{AnswerFigure, Assessment, AssessmentView, CaseFile, Document, Portion};
use standfast_figures::{DiagramContent, Figure, FigureId, KMuPlane, diagram_with, report_figure};
use standfast_sheet::{Sheet, SheetOptions};

use crate::{chances, keys};

/// A file of the gallery: its path in docs, and its content.
type File = (String, String);

/// Every file of the gallery.
fn files(root: &Path) -> io::Result<Vec<File>> {
    let mut page = String::from(
        "# Gallery\n\n\
         The report's 26 figures, drawn to true scale from the library's curves and regions for the body that each\n\
         caption names, and the diagrams of the worked cases in `examples`. `standfast figures -o DIR` draws the figures\n\
         as SVG, and with the feature `pictures` as PNG or PDF, `standfast assess CASE.toml` those of a case. This page is written by `cargo xtask gallery`,\n\
         and a test fails when a figure in it is stale.\n",
    );
    let mut files = Vec::new();
    for id in FigureId::ALL {
        let figure = report_figure(id);
        let path = format!("gallery/fig-{id}.svg");
        page.push_str(&format!("\n## Fig. {id}\n\n![{}]({path})\n", figure.title()));
        files.push((path, figure.svg().to_owned()));
    }
    page.push_str(
        "\n## A base that gives way\n\nThe k–μ plane on a base that crushes and on ground that fails, the rigid map in grey behind; see\n\
         [theory](theory/5-base.md): `standfast diagram --gamma 2 --k-prime 0.8 --omega 0.2 -o crush.svg`, and `--law ec7 --share 0.3`.\n",
    );
    for (path, figure) in bases() {
        page.push_str(&format!("\n![{}]({path})\n", figure.title()));
        files.push((path.to_owned(), figure.svg().to_owned()));
    }
    for (name, figures) in cases(root)? {
        page.push_str(&format!("\n## Case {name}\n\n[The case file](../examples/{name}.toml)\n"));
        for (path, svg) in figures {
            page.push_str(&format!("\n![{path}]({path})\n"));
            files.push((path, svg));
        }
    }
    page.push_str(
        "\n## Motion in time\n\nWhat becomes of a body, by `standfast simulate`, in the colours of its states; see [theory](theory/6-motion.md). The\n\
         animations move in a browser. Last, spectra of one sine: `standfast spectrum examples/motion/block-base-pulse.toml`, and with\n\
         `--kind overturning`.\n",
    );
    for (name, figures) in motions(root)? {
        page.push_str(&format!("\n### {name}\n\n[The case file](../examples/motion/{name}.toml)\n"));
        for (path, svg) in figures {
            page.push_str(&format!("\n![{path}]({path})\n"));
            files.push((path, svg));
        }
    }
    page.push_str(
        "\n## How likely\n\nWhat `standfast probability` draws of cases whose numbers are random: draws, modes, what matters, and, where they are asked\n\
         for, a life of storms and fragility; see [theory](theory/7-probability.md). Fragility is that of\n\
         `standfast probability examples/statue-random.toml --over \"earthquake.horizontal=1.5 m/s2..2.75 m/s2:11\"`.\n",
    );
    for (name, figures) in chances::examples(root)? {
        page.push_str(&format!("\n### {name}\n\n[The case file](../examples/{name}.toml)\n"));
        for (path, svg) in figures {
            page.push_str(&format!("\n![{path}]({path})\n"));
            files.push((path, svg));
        }
    }
    for (path, figure) in chances::of_theory(root)? {
        page.push_str(&format!("\n![{}]({path})\n", figure.title()));
        files.push((path.to_owned(), figure.svg().to_owned()));
    }
    page.push_str(
        "\n## Design\n\nThe least width of the case goda-2000 for both safety factors to be 1.2, over friction; see [design](design.md):\n\
         `standfast design examples/goda-2000.toml --vary width --and friction --target factor=1.2 -o set.svg`.\n\n\
         ![Least width over friction](gallery/design-goda-2000.svg)\n",
    );
    files.push(("gallery/design-goda-2000.svg".to_owned(), boundary(root, "goda-2000")?));
    page.push_str(
        "\n## Calculation sheet\n\n[The sheet of the case goda-2000](gallery/sheet-goda-2000.html), to be opened in a browser:\n\
         `standfast sheet examples/goda-2000.toml -o sheet.html`.\n",
    );
    files.push(("gallery/sheet-goda-2000.html".to_owned(), sheet(root, "goda-2000")?));
    files.push(("gallery.md".to_owned(), page));
    files.push(("case-file.md".to_owned(), keys::page()));
    Ok(files)
}

/// Planes where the base gives way.
fn bases() -> [(&'static str, Figure); 3] {
    let content = DiagramContent::default();
    let crush = |gamma, k_prime, omega| {
        let map = CrushMap::new(gamma, k_prime, omega).expect("a base");
        diagram_with(&KMuPlane::Crushing(map), &content)
    };
    let sand = Ground::new(GroundLaw::Ec7, 35.0, 10e3).expect("sand");
    let plane = BearingPlane::of_share(sand, 0.7, 0.4, 0.3).expect("a plane");
    [
        ("gallery/base-crush.svg", crush(2.0, 0.8, 0.2)),
        ("gallery/base-crush-below.svg", crush(4.0, -0.55, 0.2)),
        ("gallery/base-soil.svg", diagram_with(&KMuPlane::Failing(plane), &content)),
    ]
}

/// The diagrams of every example, by its name.
fn cases(root: &Path) -> io::Result<Vec<(String, Vec<File>)>> {
    let mut cases = Vec::new();
    for path in sorted(&root.join("examples"), "toml")? {
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let text = fs::read_to_string(&path)?;
        let case = CaseFile::parse(&name, &text).and_then(|file| file.case()).map_err(io::Error::other)?;
        let assessment = Assessment::of(&case).map_err(io::Error::other)?;
        let figures = assessment.figures(&AssessmentView::default()).map_err(io::Error::other)?;
        let files = figures.into_iter().map(|AnswerFigure { suffix, figure, .. }| {
            (format!("gallery/case-{name}{suffix}.svg"), figure.svg().to_owned())
        });
        let files = files.collect();
        cases.push((name, files));
    }
    Ok(cases)
}

/// The figures of some motions, and spectra of one of them, by the names of their cases.
fn motions(root: &Path) -> io::Result<Vec<(String, Vec<File>)>> {
    let folder = root.join("examples/motion");
    let read = |file: &str| fs::read_to_string(folder.join(file)).map_err(|cause| cause.to_string());
    let mut all = Vec::new();
    for name in ["caisson-breaking-wave", "caisson-church-roof", "statue-earthquake", "block-base-pulse"] {
        let text = fs::read_to_string(folder.join(format!("{name}.toml")))?;
        let file = CaseFile::read(name, &text, &read).map_err(io::Error::other)?;
        let follow = Follow { series: true, ..Follow::default() };
        let answers = FollowedMotion::of_file(&file, &follow).map_err(io::Error::other)?;
        let Some(worst) = answers.first() else { continue };
        let mut files: Vec<File> = Vec::new();
        for figure in answers.figures(&MotionView::default()).map_err(io::Error::other)? {
            files.push((
                format!("gallery/motion-{name}{}.svg", figure.suffix),
                figure.figure.svg().to_owned(),
            ));
        }
        if name == "block-base-pulse" {
            for kind in [SpectrumKind::Rocking, SpectrumKind::Overturning] {
                let spectrum = Spectrum::of(&worst.case, &SpectrumRequest::new(kind), Portion::UNSEEN);
                for figure in spectrum.map_err(io::Error::other)?.figures(&()).map_err(io::Error::other)? {
                    let path = format!("gallery/motion-{name}{}.svg", figure.suffix);
                    files.push((path, figure.figure.svg().to_owned()));
                }
            }
        }
        all.push((name.to_owned(), files));
    }
    Ok(all)
}

/// The boundary of width and friction of an example.
fn boundary(root: &Path, example: &str) -> io::Result<String> {
    let text = fs::read_to_string(root.join("examples").join(format!("{example}.toml")))?;
    let file = CaseFile::parse(example, &text).map_err(io::Error::other)?;
    let target = "factor=1.2".parse().map_err(io::Error::other)?;
    let design = DesignRequest {
        vary: "width".to_owned(),
        target,
        extreme: Extreme::Least,
        from: None,
        to: None,
        spelling: &Spelling::PROGRAM,
    };
    let request = BoundaryRequest { design, and: "friction".to_owned(), from: None, to: None };
    let boundary = DesignBoundary::of(&file, request, Portion::UNSEEN).map_err(io::Error::other)?;
    let figure = boundary.figures(&()).map_err(io::Error::other)?.pop();
    Ok(figure.map(|drawn| drawn.figure.svg().to_owned()).unwrap_or_default())
}

/// The calculation sheet of an example.
fn sheet(root: &Path, example: &str) -> io::Result<String> {
    let file = format!("{example}.toml");
    let text = fs::read_to_string(root.join("examples").join(&file))?;
    let sheet = Sheet::of(&file, &text, &SheetOptions::default()).map_err(io::Error::other)?;
    Ok(sheet.html().to_owned())
}

/// The files of a folder with an extension, by name.
fn sorted(folder: &Path, extension: &str) -> io::Result<Vec<std::path::PathBuf>> {
    let entries = fs::read_dir(folder)?.map(|entry| entry.map(|entry| entry.path()));
    let mut paths = entries.collect::<io::Result<Vec<_>>>()?;
    paths.retain(|path| path.extension().is_some_and(|found| found == extension));
    paths.sort();
    Ok(paths)
}

/// Writes all files; returns their number.
pub fn write(root: &Path) -> io::Result<usize> {
    let docs = root.join("docs");
    fs::create_dir_all(docs.join("gallery"))?;
    let files = files(root)?;
    for (path, content) in &files {
        fs::write(docs.join(path), content)?;
    }
    Ok(files.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_figure_in_the_gallery_is_current() {
        let root = crate::root();
        for (path, content) in files(&root).unwrap() {
            let kept = fs::read_to_string(root.join("docs").join(&path)).unwrap_or_default();
            assert!(
                kept == content,
                "docs/{path} is stale; run `cargo xtask gallery` and look at what changed"
            );
        }
    }
}
