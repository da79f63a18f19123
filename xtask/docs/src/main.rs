//! Writes the parts of docs that come from the program itself, and answers mdBook. A crate of its own, so that `cargo xtask` itself is
//! compiled in a moment.

#![forbid(unsafe_code)]

use std::process::ExitCode;

use xtask_docs::{book, built, gallery, root};

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let ended = match arguments[..] {
        [] => gallery::write(&root())
            .map(|count| println!("{count} files written"))
            .map_err(|error| error.to_string()),
        // mdBook asks first whether its renderer is known: MathML is HTML.
        ["preprocess", "supports", renderer] => return ExitCode::from(u8::from(renderer != "html")),
        ["preprocess"] => book::preprocess(std::io::stdin().lock(), std::io::stdout().lock(), &root()),
        ["addresses", folder] => {
            built::addresses(folder.as_ref()).map(|count| println!("{count} addresses lead somewhere"))
        }
        ["one-file", folder, file] => built::one_file(folder.as_ref())
            .and_then(|page| std::fs::write(file, page).map_err(|error| format!("{file}: {error}"))),
        _ => Err("expected nothing, preprocess, addresses FOLDER, or one-file FOLDER FILE".to_owned()),
    };
    match ended {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}
