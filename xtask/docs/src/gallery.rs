//! docs/reference/gallery.md and what it shows: the report's figures, those of the worked cases, a calculation sheet.

use std::path::Path;
use std::{fs, io};

use standfast::Point;
use standfast::ground::bearing::{BearingPlane, Ground, GroundLaw};
use standfast::ground::strength::CrushMap;
use standfast_cases::design::{BoundaryRequest, DesignBoundary, DesignRequest, Extreme, Spelling};
use standfast_cases::directions::{Directions, STEP};
use standfast_cases::motion::{Follow, FollowedMotion, MotionView, Spectrum, SpectrumKind, SpectrumRequest};
use standfast_cases::{AnswerFigure, Assessment, AssessmentView, CaseFile, Document, Portion};
use standfast_figures::{
    DiagramContent, Figure, FigureId, FreeBody, KMuPlane, diagram_with, free_body, report_figure,
};
use standfast_sheet::{Sheet, SheetOptions};

use crate::{chances, commands, errors, evidence, keys, results, stacks};

/// A file of the gallery.
pub struct File {
    /// Its path in docs.
    pub path: String,
    content: String,
    /// The figure, if it is one.
    figure: Option<Figure>,
}

impl File {
    /// A figure.
    pub fn drawn(path: impl Into<String>, figure: Figure) -> File {
        File { path: path.into(), content: figure.svg().to_owned(), figure: Some(figure) }
    }

    fn written(path: &str, content: String) -> File {
        File { path: path.to_owned(), content, figure: None }
    }

    /// What a reader who does not see the picture is told.
    fn title(&self) -> &str {
        self.figure.as_ref().map_or(self.path.as_str(), Figure::title)
    }
}

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
        page.push_str(&format!("\n## Fig. {id}\n\n![{}](../{path})\n", figure.title()));
        files.push(File::drawn(path, figure));
    }
    page.push_str(
        "\n## Four outcomes\n\nOne body, twice as high as it is wide, and one force at four strengths and frictions. Solid arrows are forces,\n\
         dashed ones accelerations; the dashed outline is exaggerated.\n",
    );
    for (path, figure) in outcomes() {
        page.push_str(&format!("\n![{}](../{path})\n", figure.title()));
        files.push(File::drawn(path, figure));
    }
    page.push_str(
        "\n## A base that gives way\n\nThe k–μ plane on a base that crushes and on ground that fails, the rigid map dotted behind; see\n\
         [theory](../theory/base.md): `standfast diagram --gamma 2 --k-prime 0.8 --omega 0.2 -o crush.svg`, and `--law ec7 --share 0.3`.\n",
    );
    for (path, figure) in bases() {
        page.push_str(&format!("\n![{}](../{path})\n", figure.title()));
        files.push(File::drawn(path, figure));
    }
    page.push_str(
        "\n## Bodies on bodies\n\nWhich joint of two bodies moves, and how, over load and friction; see [theory](../theory/joints.md).\n",
    );
    for (path, figure) in stacks::figures()? {
        page.push_str(&format!("\n![{}](../{path})\n", figure.title()));
        files.push(File::drawn(path, figure));
    }
    for (name, figures) in cases(root, "examples/joints")? {
        page.push_str(&format!("\n### {name}\n\n[The case file](../../examples/joints/{name}.toml)\n"));
        for file in figures {
            page.push_str(&format!("\n![{}](../{})\n", file.title(), file.path));
            files.push(file);
        }
    }
    page.push_str(
        "\n## Any direction\n\nBodies on a plan: the section with the base seen from above, and rest over all horizontal directions, by\n\
         `standfast directions`; see [how to](../how-to/directions.md) and [theory](../theory/direction.md).\n",
    );
    for (name, figures) in directions(root)? {
        page.push_str(&format!("\n### {name}\n\n[The case file](../../examples/directions/{name}.toml)\n"));
        for file in figures {
            page.push_str(&format!("\n![{}](../{})\n", file.title(), file.path));
            files.push(file);
        }
    }
    for (name, figures) in cases(root, "examples")? {
        page.push_str(&format!("\n## Case {name}\n\n[The case file](../../examples/{name}.toml)\n"));
        for file in figures {
            page.push_str(&format!("\n![{}](../{})\n", file.title(), file.path));
            files.push(file);
        }
    }
    page.push_str(
        "\n## Motion in time\n\nWhat becomes of a body, by `standfast simulate`, in the colours of its states; see [theory](../theory/motion.md). The\n\
         animations move in a browser. Last, spectra of one sine: `standfast spectrum examples/motion/block-base-pulse.toml`, and with\n\
         `--kind overturning`.\n",
    );
    for (name, figures) in motions(root)? {
        page.push_str(&format!("\n### {name}\n\n[The case file](../../examples/motion/{name}.toml)\n"));
        for file in figures {
            page.push_str(&format!("\n![{}](../{})\n", file.title(), file.path));
            files.push(file);
        }
    }
    page.push_str(
        "\n## How likely\n\nWhat `standfast probability` draws of cases whose numbers are random: draws, modes, what matters, and, where they are asked\n\
         for, a life of storms and fragility; see [theory](../theory/probability.md). Fragility is that of\n\
         `standfast probability examples/statue-random.toml --over \"earthquake.horizontal=1.5 m/s2..2.75 m/s2:11\"`.\n",
    );
    for (name, figures) in chances::examples(root)? {
        page.push_str(&format!("\n### {name}\n\n[The case file](../../examples/{name}.toml)\n"));
        for file in figures {
            page.push_str(&format!("\n![{}](../{})\n", file.title(), file.path));
            files.push(file);
        }
    }
    for (path, figure) in chances::of_theory(root)? {
        page.push_str(&format!("\n![{}](../{path})\n", figure.title()));
        files.push(File::drawn(path, figure));
    }
    page.push_str(
        "\n## Design\n\nThe least width of the case goda-2000 for both safety factors to be 1.2, over friction; see [design](../how-to/design.md):\n\
         `standfast design examples/goda-2000.toml --vary width --and friction --target factor=1.2 -o set.svg`.\n\n\
         ![Least width over friction](../gallery/design-goda-2000.svg)\n",
    );
    files.extend(
        boundary(root, "goda-2000")?.map(|figure| File::drawn("gallery/design-goda-2000.svg", figure)),
    );
    page.push_str(
        "\n## Calculation sheet\n\n[The sheet of the case goda-2000](../gallery/sheet-goda-2000.html), to be opened in a browser:\n\
         `standfast sheet examples/goda-2000.toml -o sheet.html`.\n",
    );
    files.push(File::written("gallery/sheet-goda-2000.html", sheet(root, "goda-2000")?));
    files.push(File::written("reference/gallery.md", page));
    files.push(File::written("reference/keys.md", keys::page()));
    files.push(File::written("reference/results.md", results::page()));
    files.push(File::written("trust/evidence.md", evidence::page(evidence::REST)));
    files.push(File::written("reference/errors.md", errors::page(root)?));
    files.push(File::written("reference/commands.md", commands::page()));
    Ok(files)
}

/// The body of Fig. 3.11's kind as it rests, slides, rocks, and slides and rocks.
fn outcomes() -> [(&'static str, Figure); 4] {
    let drawn = |k, mu| {
        let point = Point::new(2.0, 0.4, k, mu).expect("a point");
        free_body(&FreeBody { point, mirrored: false, omega: 0.0 }, (480.0, 420.0)).0
    };
    [
        ("gallery/outcome-rest.svg", drawn(0.25, 0.5)),
        ("gallery/outcome-slide.svg", drawn(0.35, 0.2)),
        ("gallery/outcome-rock.svg", drawn(0.6, 0.7)),
        ("gallery/outcome-slide-rock.svg", drawn(0.9, 0.3)),
    ]
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

/// The diagrams of every example in a folder, by its name.
fn cases(root: &Path, folder: &str) -> io::Result<Vec<(String, Vec<File>)>> {
    let mut cases = Vec::new();
    for path in sorted(&root.join(folder), "toml")? {
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let text = fs::read_to_string(&path)?;
        let case = CaseFile::parse(&name, &text).and_then(|file| file.case()).map_err(io::Error::other)?;
        let assessment = Assessment::of(&case).map_err(io::Error::other)?;
        let figures = assessment.figures(&AssessmentView::default()).map_err(io::Error::other)?;
        let files = figures.into_iter().map(|AnswerFigure { suffix, figure, .. }| {
            File::drawn(format!("gallery/case-{name}{suffix}.svg"), figure)
        });
        let files = files.collect();
        cases.push((name, files));
    }
    Ok(cases)
}

/// The figures of cases with a base seen from above: the section, and all directions, with the orbit of a record where there is one.
fn directions(root: &Path) -> io::Result<Vec<(String, Vec<File>)>> {
    let folder = root.join("examples/directions");
    let read = |file: &str| {
        let bytes = fs::read(folder.join(file)).map_err(|cause| cause.to_string())?;
        Ok(String::from_utf8_lossy(&bytes).into_owned())
    };
    let mut all = Vec::new();
    for path in sorted(&folder, "toml")? {
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let text = fs::read_to_string(&path)?;
        let file = CaseFile::read(&name, &text, &read).map_err(io::Error::other)?;
        let found = Directions::of_file(&file, STEP).map_err(io::Error::other)?;
        let of_case = found.assessment.figures(&AssessmentView::default()).map_err(io::Error::other)?;
        let section = of_case.into_iter().filter(AnswerFigure::is_section);
        let directions = found.figures(&()).map_err(io::Error::other)?;
        let files = section.chain(directions).map(|AnswerFigure { suffix, figure, .. }| {
            File::drawn(format!("gallery/any-{name}{suffix}.svg"), figure)
        });
        let files = files.collect();
        all.push((name, files));
    }
    Ok(all)
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
            files.push(File::drawn(format!("gallery/motion-{name}{}.svg", figure.suffix), figure.figure));
        }
        if name == "block-base-pulse" {
            for kind in [SpectrumKind::Rocking, SpectrumKind::Overturning] {
                let spectrum = Spectrum::of(&worst.case, &SpectrumRequest::new(kind), Portion::UNSEEN);
                for figure in spectrum.map_err(io::Error::other)?.figures(&()).map_err(io::Error::other)? {
                    let path = format!("gallery/motion-{name}{}.svg", figure.suffix);
                    files.push(File::drawn(path, figure.figure));
                }
            }
        }
        all.push((name.to_owned(), files));
    }
    Ok(all)
}

/// The boundary of width and friction of an example.
fn boundary(root: &Path, example: &str) -> io::Result<Option<Figure>> {
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
    Ok(boundary.figures(&()).map_err(io::Error::other)?.pop().map(|drawn| drawn.figure))
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
    for File { path, content, .. } in &files {
        fs::write(docs.join(path), content)?;
    }
    Ok(files.len())
}

#[cfg(test)]
mod tests {
    use std::sync::LazyLock;

    use super::*;

    static FILES: LazyLock<Vec<File>> = LazyLock::new(|| files(&crate::root()).unwrap());

    /// The figures with their paths.
    fn figures() -> impl Iterator<Item = (&'static str, &'static Figure)> {
        FILES.iter().filter_map(|file| Some((file.path.as_str(), file.figure.as_ref()?)))
    }

    /// True for a figure of the report, whose title and captions are the report's.
    fn is_the_reports(path: &str) -> bool {
        path.starts_with("gallery/fig-")
    }

    #[test]
    fn every_figure_in_the_gallery_is_current() {
        let docs = crate::root().join("docs");
        for File { path, content, .. } in FILES.iter() {
            let kept = fs::read_to_string(docs.join(path)).unwrap_or_default();
            assert!(
                kept == *content,
                "docs/{path} is stale; run `cargo xtask gallery` and look at what changed"
            );
        }
        for path in fs::read_dir(docs.join("gallery")).unwrap().map(|entry| entry.unwrap().file_name()) {
            let path = format!("gallery/{}", path.to_string_lossy());
            assert!(FILES.iter().any(|file| file.path == path), "docs/{path} is written no more; remove it");
        }
    }

    /// A column or a page; those of the report are as wide as what stands at their edges asks for.
    #[test]
    fn figures_have_one_of_two_widths() {
        for (path, figure) in figures().filter(|(path, _)| !is_the_reports(path)) {
            // A section with loads of many kinds on a side is a little wider, so that none lies on another.
            let is_section = path.ends_with("-section.svg") && (720.0..=840.0).contains(&figure.size().0);
            let is_usual = [480.0, 720.0].contains(&figure.size().0);
            assert!(is_usual || is_section, "{path}: {:?}", figure.size());
        }
    }

    #[test]
    fn no_label_lies_on_another() {
        for (path, figure) in figures() {
            let labels = figure.labels();
            for (i, label) in labels.iter().enumerate() {
                let other = labels[i + 1..].iter().find(|other| label.rect.overlaps(&other.rect));
                assert_eq!(other, None, "{path}: {label:?}");
            }
        }
    }

    /// Powers of ten and symbols of modes are set; quantities have words, and no keys.
    #[test]
    fn no_text_is_a_machine_s() {
        let is_power = |word: &str| {
            word.split_once('e')
                .is_some_and(|(one, other)| one.parse::<f64>().is_ok() && other.parse::<i32>().is_ok())
        };
        let is_key = |word: &str| {
            let is_name =
                |part: &str| part.len() > 1 && part.chars().all(|c| c.is_ascii_lowercase() || c == '_');
            word.split_once('.').is_some_and(|(table, key)| is_name(table) && is_name(key))
                || word.starts_with("bias.")
        };
        let is_code = |word: &str| {
            word.contains("SRO'")
                || word.contains("SRO-")
                || word.contains("RO'")
                || word.contains("SRO′+")
                || word.contains("SRO−")
        };
        for (path, figure) in figures() {
            for word in figure.labels().iter().flat_map(|label| label.text.split_whitespace()) {
                let word = word.trim_matches(|letter: char| "()[],.;:".contains(letter));
                assert!(!is_power(word) && !is_key(word) && !is_code(word), "{path}: {word:?}");
            }
        }
    }

    /// A title names the figure; conditions stand in the caption.
    #[test]
    fn no_title_is_a_condition() {
        for (path, figure) in figures().filter(|(path, _)| !is_the_reports(path)) {
            assert!(!figure.title().contains(['<', '>', '≤', '≥']), "{path}: {:?}", figure.title());
        }
    }

    /// A caption gives the coordinates of a point only if its letter stands in the figure.
    #[test]
    fn captions_list_what_is_drawn() {
        let mut listed = 0;
        for (path, figure) in figures() {
            let letters = ["A", "B′", "C", "C′", "D", "E", "F", "k_BF"];
            for letter in letters {
                if figure.caption().split([',', '.', ' ']).any(|word| word == letter)
                    && figure.caption().contains(&format!("{letter} ("))
                {
                    listed += 1;
                    let is_drawn = figure.labels().iter().any(|label| label.text == letter);
                    assert!(is_drawn, "{path}: {letter} in {:?}", figure.caption());
                }
            }
        }
        assert!(listed > 80, "{listed}");
    }
}
