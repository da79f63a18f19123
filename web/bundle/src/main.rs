//! One HTML file of the explorer: `standfast-web-bundle LIBRARY.wasm PAGE-FOLDER OUT.html`.
//!
//! The page is `index.html` with its style sheet, its scripts and the compiled library put inside, so that it opens from
//! a disk or a mail and fetches nothing. The scripts are modules that know each other by name; here they become one script, each in a
//! function of its own, so that the policy of the page can name that script by its hash and allow no other. The library is packed by
//! gzip, which every browser undoes; it more than halves the file.

#![forbid(unsafe_code)]

use std::collections::BTreeMap;
use std::error::Error;
use std::fs;
use std::io::{self, Write};
use std::path::Path;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::GzEncoder;
use sha2::{Digest, Sha256};
use wasm_bindgen_cli_support::Bindgen;

/// Module that starts the page.
const MAIN: &str = "main";

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
        .no_modules(true)?
        .typescript(false)
        .remove_name_section(true)
        .remove_producers_section(true)
        .generate_output()?;
    let glue = output.js().to_owned();
    let library = packed(&output.wasm_mut().emit_wasm())?;

    let mut modules = BTreeMap::new();
    for entry in fs::read_dir(page)? {
        let name = entry?.file_name().to_string_lossy().into_owned();
        if let Some(module) = name.strip_suffix(".js") {
            modules.insert(module.to_owned(), read(&name)?);
        }
    }
    let script = script(&glue, &modules)?;
    let hash = STANDARD.encode(Sha256::digest(script.as_bytes()));
    let policy = format!(
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'sha256-{hash}' 'wasm-unsafe-eval'; \
         style-src 'unsafe-inline'; img-src data: blob:; font-src data: blob:; base-uri 'none'; form-action 'none'\">"
    );
    let parts = [
        ("<!-- policy -->", policy),
        ("<!-- style -->", format!("<style>\n{}</style>", read("style.css")?)),
        (
            "<!-- library -->",
            format!(
                "<script type=\"application/wasm+gzip\" id=\"wasm\" data-length=\"{}\">{}</script>",
                library.len(),
                lettered(&library)
            ),
        ),
        ("<!-- script -->", format!("<script type=\"module\">{script}</script>")),
    ];
    let mut html = read("index.html")?;
    for (place, part) in parts {
        let (before, after) = html.split_once(place).ok_or_else(|| format!("index.html lacks {place}"))?;
        html = [before, &part, after].concat();
    }
    Ok(html)
}

/// The modules as one script: the library first, then each behind those that it takes something from.
fn script(glue: &str, modules: &BTreeMap<String, String>) -> Result<String, String> {
    let mut script = format!(
        "const module_library = (() => {{\n{glue}\nreturn {{ start: wasm_bindgen, Explorer: wasm_bindgen.Explorer }};\n}})();\n"
    );
    let mut done = vec!["library".to_owned()];
    add(MAIN, modules, &mut done, &mut script)?;
    if script.contains("</script") {
        return Err("a script ends the element that it stands in".to_owned());
    }
    Ok(script)
}

fn add(
    name: &str,
    modules: &BTreeMap<String, String>,
    done: &mut Vec<String>,
    script: &mut String,
) -> Result<(), String> {
    if done.iter().any(|other| other == name) {
        return Ok(());
    }
    done.push(name.to_owned());
    let source = modules.get(name).ok_or_else(|| format!("there is no {name}.js"))?;
    let (mut body, mut exports) = (String::new(), Vec::new());
    for line in source.lines() {
        if let Some((names, from)) = imported(line) {
            add(from, modules, done, script)?;
            body += &format!("const {{ {names} }} = module_{};\n", identifier(from));
        } else if let Some(declared) = line.strip_prefix("export ") {
            let words = declared.split(|letter: char| !(letter.is_alphanumeric() || letter == '_'));
            let name = words
                .filter(|word| !["async", "function", "const", ""].contains(word))
                .map(str::to_owned)
                .next();
            exports.push(name.ok_or_else(|| format!("an export without a name: {line}"))?);
            body += &format!("{declared}\n");
        } else {
            body += &format!("{line}\n");
        }
    }
    // The page waits for the library at the top of its first module.
    *script += &match name == MAIN {
        true => body,
        false => {
            format!(
                "const module_{} = (() => {{\n{body}return {{ {} }};\n}})();\n",
                identifier(name),
                exports.join(", ")
            )
        }
    };
    Ok(())
}

/// The names that a line takes from a module, and that module.
fn imported(line: &str) -> Option<(&str, &str)> {
    let (names, from) = line.strip_prefix("import { ")?.split_once(" } from \"")?;
    Some((names, from.strip_suffix("\";")?))
}

fn identifier(name: &str) -> String {
    name.replace('-', "_")
}

fn packed(bytes: &[u8]) -> io::Result<Vec<u8>> {
    let mut packer = GzEncoder::new(Vec::new(), Compression::best());
    packer.write_all(bytes)?;
    packer.finish()
}

/// Bytes as letters, five for four bytes, a fourteenth less than base64 takes: digits to the base of 85, the greatest first, which are the
/// letters from `(` on, with `~` in the place of `<`. Zeros fill the last four.
fn lettered(bytes: &[u8]) -> String {
    let letter = |digit: u32| match b'(' + digit as u8 {
        b'<' => '~',
        letter => char::from(letter),
    };
    let mut letters = String::with_capacity(bytes.len() / 4 * 5 + 5);
    for four in bytes.chunks(4) {
        let byte = |i: usize| four.get(i).copied().unwrap_or(0);
        let number = u32::from_be_bytes([byte(0), byte(1), byte(2), byte(3)]);
        letters.extend((0..5).rev().map(|power| letter(number / 85_u32.pow(power) % 85)));
    }
    letters
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 4 294 967 295 is 82 · 85⁴ + 23 · 85³ + 54 · 85² + 12 · 85; and 20 is that of `<`.
    #[test]
    fn four_bytes_are_five_letters() {
        assert_eq!(lettered(&[255; 4]), "z?^4(");
        assert_eq!(lettered(&[0, 0, 0, 20, 0]), "((((~(((((");
    }

    #[test]
    fn modules_become_one_script_in_the_order_of_their_needs() {
        let sources = [
            ("main", "import { a, b } from \"one\";\nimport { start } from \"library\";\na(b);"),
            ("one", "import { c } from \"two\";\nexport const b = c;\nexport async function a() {\n}"),
            ("two", "export function c(x) {\n}"),
        ];
        let modules = sources.map(|(name, source)| (name.to_owned(), source.to_owned())).into();
        let script = script("let wasm_bindgen;", &modules).unwrap();
        let at = |part: &str| script.find(part).unwrap_or_else(|| panic!("{part} in {script}"));
        assert!(at("const module_two") < at("const module_one") && at("const module_one") < at("a(b);"));
        assert!(
            script.contains(
                "const { c } = module_two;\nconst b = c;\nasync function a() {\n}\nreturn { b, a };"
            )
        );
        assert!(
            super::script("", &[("main".to_owned(), "import { x } from \"none\";".to_owned())].into())
                .is_err()
        );
        assert!(super::script("\"</script>\"", &modules).is_err());
    }
}
