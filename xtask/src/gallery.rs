//! docs/gallery.md and the figures it shows.

use std::io;
use std::path::Path;

use standfast_figures::{FigureId, report_figure};

/// Every file of the gallery, by its path in docs.
fn files() -> Vec<(String, String)> {
    let mut page = String::from(
        "# Gallery\n\n\
         The report's 26 figures, drawn to true scale from the library's curves and regions for the body that each\n\
         caption names. `standfast figures -o DIR` draws them as SVG, PNG or PDF; this page is written by\n\
         `cargo xtask gallery`, and a test fails when a figure in it is stale.\n",
    );
    let mut files = Vec::new();
    for id in FigureId::ALL {
        let figure = report_figure(id);
        let path = format!("gallery/fig-{id}.svg");
        page.push_str(&format!("\n## Fig. {id}\n\n![{}]({path})\n", figure.title()));
        files.push((path, figure.svg().to_owned()));
    }
    files.push(("gallery.md".to_owned(), page));
    files
}

/// Writes all files; returns their number.
pub fn write(root: &Path) -> io::Result<usize> {
    let docs = root.join("docs");
    std::fs::create_dir_all(docs.join("gallery"))?;
    let files = files();
    for (path, content) in &files {
        std::fs::write(docs.join(path), content)?;
    }
    Ok(files.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_figure_in_the_gallery_is_current() {
        for (path, content) in files() {
            let kept = std::fs::read_to_string(crate::root().join("docs").join(&path)).unwrap_or_default();
            assert!(
                kept == content,
                "docs/{path} is stale; run `cargo xtask gallery` and look at what changed"
            );
        }
    }
}
