//! One HTML file of the explorer: `standfast-web-bundle LIBRARY.wasm PAGE-FOLDER OUT.html`.
//!
//! The page is `index.html` with its style sheet, its scripts and the compiled library put inside, so that it opens from
//! a disk or a mail and fetches nothing. Scripts are modules that know each other by name: an import map gives each
//! name its source as a `data:` address, which modules need where there is no server. The library is packed by gzip, which
//! every browser undoes; it more than halves the file.

#![forbid(unsafe_code)]

use std::error::Error;
use std::fs;
use std::io::{self, Write};
use std::path::Path;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::GzEncoder;
use wasm_bindgen_cli_support::Bindgen;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [wasm, page, out] = arguments.as_slice() else {
        return Err("expected: LIBRARY.wasm PAGE-FOLDER OUT.html".into());
    };
    let html = bundle(Path::new(wasm), Path::new(page))?;
    fs::write(out, &html).map_err(|error| format!("{out}: {error}"))?;
    println!("{out}: {} kB", html.len().div_ceil(1000));
    Ok(())
}

fn bundle(wasm: &Path, page: &Path) -> Result<String, Box<dyn Error>> {
    let read = |name: &str| {
        let path = page.join(name);
        fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))
    };
    let mut output = Bindgen::new()
        .input_path(wasm)
        .web(true)?
        .typescript(false)
        .remove_name_section(true)
        .remove_producers_section(true)
        .generate_output()?;
    let glue = output.js().to_owned();
    let library = output.wasm_mut().emit_wasm();

    let mut modules = vec![("library".to_owned(), glue)];
    let mut names: Vec<_> = fs::read_dir(page)?.collect::<Result<Vec<_>, _>>()?;
    names.sort_by_key(fs::DirEntry::file_name);
    for name in names.iter().map(|entry| entry.file_name().to_string_lossy().into_owned()) {
        if let Some(module) = name.strip_suffix(".js") {
            modules.push((module.to_owned(), read(&name)?));
        }
    }
    let imports: Vec<_> = modules
        .iter()
        .map(|(name, source)| {
            format!("\"{name}\":\"data:text/javascript;base64,{}\"", STANDARD.encode(source))
        })
        .collect();
    let parts = [
        ("<!-- style -->", format!("<style>\n{}</style>", read("style.css")?)),
        (
            "<!-- modules -->",
            format!("<script type=\"importmap\">{{\"imports\":{{{}}}}}</script>", imports.join(",")),
        ),
        (
            "<!-- library -->",
            format!(
                "<script type=\"application/wasm+gzip\" id=\"wasm\">{}</script>",
                STANDARD.encode(packed(&library)?)
            ),
        ),
    ];
    let mut html = read("index.html")?;
    for (place, part) in parts {
        let (before, after) = html.split_once(place).ok_or_else(|| format!("index.html lacks {place}"))?;
        html = [before, &part, after].concat();
    }
    Ok(html)
}

fn packed(bytes: &[u8]) -> io::Result<Vec<u8>> {
    let mut packer = GzEncoder::new(Vec::new(), Compression::best());
    packer.write_all(bytes)?;
    packer.finish()
}
