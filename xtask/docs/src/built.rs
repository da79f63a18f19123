//! The book as mdBook has built it: its addresses, and the book as one file.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

/// Every address in the pages of a folder that leads to no file or to no element of it. Those of the explorer are left out: it is built by
/// other means.
///
/// # Errors
/// Each of them, and what cannot be read.
pub fn addresses(folder: &Path) -> Result<usize, String> {
    let mut pages = BTreeMap::new();
    read(folder, &mut pages)?;
    let ids: BTreeMap<&PathBuf, BTreeSet<&str>> =
        pages.iter().map(|(path, page)| (path, values(page, "id").collect())).collect();
    let mut faults = Vec::new();
    let mut count = 0;
    for (path, page) in
        pages.iter().filter(|(path, _)| !path.ends_with("print.html") && !path.ends_with("toc.html"))
    {
        let here = path.parent().unwrap_or(folder);
        for address in values(page, "href").chain(values(page, "src")) {
            let outside =
                address.contains("://") || address.starts_with("data:") || address.starts_with("mailto:");
            if outside || address.contains("standfast-explorer.html") || address.is_empty() {
                continue;
            }
            count += 1;
            let (file, anchor) = address.split_once('#').unwrap_or((address, ""));
            let target = if file.is_empty() { path.clone() } else { here.join(file) };
            let Ok(target) = target.canonicalize() else {
                faults.push(format!("{}: {address}: there is no such file", path.display()));
                continue;
            };
            let anchor = anchor.replace("%27", "'");
            if !anchor.is_empty() && ids.get(&target).is_some_and(|ids| !ids.contains(anchor.as_str())) {
                faults.push(format!("{}: {address}: there is no such place", path.display()));
            }
        }
    }
    faults.sort();
    faults.dedup();
    if faults.is_empty() { Ok(count) } else { Err(faults.join("\n")) }
}

fn read(folder: &Path, pages: &mut BTreeMap<PathBuf, String>) -> Result<(), String> {
    let failed = |error: std::io::Error| format!("{}: {error}", folder.display());
    for entry in fs::read_dir(folder).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        // Sheets and the explorer are documents of their own.
        let own = ["gallery", "examples", "validation"].iter().any(|name| path.ends_with(name));
        if path.is_dir() && !own {
            read(&path, pages)?;
        } else if path.extension().is_some_and(|ending| ending == "html")
            && !path.ends_with("standfast-explorer.html")
        {
            let page = fs::read_to_string(&path).map_err(failed)?;
            pages.insert(path.canonicalize().map_err(failed)?, page);
        }
    }
    Ok(())
}

/// The values of an attribute in a page.
fn values<'a>(page: &'a str, attribute: &str) -> impl Iterator<Item = &'a str> {
    let begin = format!(" {attribute}=\"");
    page.match_indices(&begin)
        .map(|(at, found)| at + found.len())
        .collect::<Vec<_>>()
        .into_iter()
        .filter_map(|at| page[at..].split('"').next())
}

/// The book as one file: mdBook's page for printing with its styles and pictures in it, without scripts and without the gallery.
///
/// # Errors
/// If a file of the book cannot be read.
pub fn one_file(folder: &Path) -> Result<String, String> {
    let text = |path: &Path| fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()));
    let page = text(&folder.join("print.html"))?;
    let (_, main) = page.split_once("<main>").ok_or("print.html: there is no <main>")?;
    let (main, _) = main.split_once("</main>").ok_or("print.html: <main> does not end")?;
    let main = without_gallery(main);
    let font = fs::read(folder.join(FONT)).map_err(|error| format!("{FONT}: {error}"))?;
    let mut made = HEAD.replace(FONT, &format!("data:font/woff2;base64,{}", STANDARD.encode(font)));
    let mut rest = main.as_str();
    while let Some((before, behind)) = rest.split_once("<img ") {
        let (tag, after) = behind.split_once('>').ok_or("print.html: a picture does not end")?;
        let source = values(&format!(" {tag}"), "src").next().unwrap_or_default().to_owned();
        let file = folder.join(source.trim_start_matches("../"));
        let bytes = fs::read(&file).map_err(|error| format!("{}: {error}", file.display()))?;
        let kind = if source.ends_with(".svg") { "svg+xml" } else { "png" };
        made += before;
        made += &format!(
            "<img {}>",
            tag.replace(&source, &format!("data:image/{kind};base64,{}", STANDARD.encode(bytes)))
        );
        rest = after;
    }
    Ok(made + rest + "</main></body></html>\n")
}

/// The font of formulas, beside the pages.
const FONT: &str = "standfast-math.woff2";

const HEAD: &str = concat!(
    "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>standfast</title>",
    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"><style>\n",
    include_str!("one-file.css"),
    include_str!("../../../docs/book.css"),
    "</style></head><body class=\"content\"><main>\n"
);

/// Without the chapter of pictures, which is larger than all others together.
fn without_gallery(main: &str) -> String {
    let Some(start) = main.find("<h1 id=\"gallery\"") else { return main.to_owned() };
    let end = main[start + 4..].find("<h1 ").map_or(main.len(), |at| start + 4 + at);
    format!("{}{}", &main[..start], &main[end..])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_address_that_leads_nowhere_is_found() {
        let folder = tempfile::tempdir().unwrap();
        let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
        write("b.html", "<h1 id=\"one\">1</h1>");
        write(
            "a.html",
            "<a href=\"b.html#one\">b</a><a href=\"#two\">c</a><p id=\"two\"><a href=\"https://example.org\">d</a>",
        );
        assert_eq!(addresses(folder.path()), Ok(2));
        write("c.html", "<a href=\"gone.html\">b</a><img src=\"b.html#three\">");
        let faults = addresses(folder.path()).unwrap_err();
        assert!(
            faults.contains("gone.html: there is no such file")
                && faults.contains("b.html#three: there is no such place"),
            "{faults}"
        );
    }

    #[test]
    fn one_file_has_its_pictures_and_no_gallery() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("a.svg"), "<svg/>").unwrap();
        fs::write(folder.path().join(FONT), "font").unwrap();
        let page = "<html><script>x</script><main><h1 id=\"one\">1</h1><p><img src=\"a.svg\" alt=\"A\"></p><h1 id=\"gallery\">G</h1><img src=\"no.svg\"><h1 id=\"two\">2</h1></main>";
        fs::write(folder.path().join("print.html"), page).unwrap();
        let made = one_file(folder.path()).unwrap();
        assert!(
            made.contains("src=\"data:image/svg+xml;base64,PHN2Zy8+\" alt=\"A\"")
                && made.contains("<h1 id=\"two\">"),
            "{made}"
        );
        assert!(!made.contains("<script") && !made.contains("no.svg"), "{made}");
    }
}
