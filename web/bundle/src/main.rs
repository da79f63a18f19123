//! One HTML file of the explorer: `standfast-web-bundle LIBRARY.wasm PAGE-FOLDER OUT.html`.
//!
//! The page is `index.html` with its style sheet, its scripts and the compiled library put inside, so that it opens from
//! a disk or a mail and fetches nothing. The scripts are modules that know each other by name; here they become one script, each in a
//! function of its own, so that the policy of the page can name it by its hash, beside the library's and the style's, and allow no
//! other. The library is packed by LZMA, in two thirds of what gzip takes; what unpacks it is a small library of its own, packed by
//! gzip, which every browser undoes. So are the style, the body and the scripts packed, and a short one that is not lets them in.

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
use lzma_rust2::{LzmaOptions, LzmaWriter};
use sha2::{Digest, Sha256};
use wasm_bindgen_cli_support::Bindgen;

/// Module that starts the page.
const MAIN: &str = "main";

/// Module that the page begins with, which lets the others run.
const OPENING: &str = "open";

/// What hides the page until it is dressed; a browser that cannot unpack the style is told so in the bare page.
const VEIL: &str =
    "if (\"DecompressionStream\" in window) document.documentElement.style.visibility = \"hidden\";";

/// Source of its second thread.
const WORKER: &str = "worker";

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [wasm, page, out] = arguments.as_slice() else {
        return Err("expected: WASM-FOLDER PAGE-FOLDER OUT.html".into());
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
    let library = Library::of(&wasm.join("standfast_web.wasm"))?;
    let unpacker = Library::of(&wasm.join("standfast_web_unpack.wasm"))?;

    let mut modules = BTreeMap::new();
    for entry in fs::read_dir(page)? {
        let name = entry?.file_name().to_string_lossy().into_owned();
        if let Some(module) = name.strip_suffix(".js") {
            modules.insert(module.to_owned(), read(&name)?);
        }
    }
    // Not of the page's script: the source of its second thread, behind the library.
    let worker = modules.remove(WORKER).ok_or_else(|| format!("there is no {WORKER}.js"))?;
    let glue = library.glue;
    let worker = without_comments(&worker)?;
    let opening = script(OPENING, String::new(), &[], &modules)?;
    let script = page_script(&unpacker.glue, &modules)?;
    let style = without_comments(&read("style.css")?)?;
    let veil = VEIL.to_owned();
    for text in [&glue, &worker, &script, &opening] {
        if text.contains("</script") {
            return Err("a script ends the element that it stands in".into());
        }
    }
    let [of_glue, of_script, of_opening, of_veil, of_style] =
        [&glue, &script, &opening, &veil, &style].map(|text| hash(text));
    let policy = format!(
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src {of_glue} {of_script} \
         {of_opening} {of_veil} 'wasm-unsafe-eval'; worker-src blob:; style-src {of_style}; img-src data: blob:; font-src data: blob:; \
         base-uri 'none'; form-action 'none'\">"
    );
    let packed = |id: &str, kind: &str, letters: String| {
        format!("<script type=\"{kind}\" id=\"{id}\">{letters}</script>\n")
    };
    let parts = [
        ("<!-- policy -->", policy),
        ("<!-- veil -->", format!("<script>{veil}</script>")),
        (
            "<!-- library -->",
            packed("unpacker", "application/wasm+gzip", letters(&gzip(&unpacker.wasm)?))
                + &packed("wasm", "application/wasm+lzma", letters(&lzma(&library.wasm)?)),
        ),
        (
            "<!-- script -->",
            packed("style-packed", "text/css+gzip", letters(&gzip(style.as_bytes())?))
                + &packed("glue-packed", "text/javascript+gzip", letters(&gzip(glue.as_bytes())?))
                + &packed("page-packed", "text/javascript+gzip", letters(&gzip(script.as_bytes())?))
                + &format!(
                    "<script type=\"text/plain\" id=\"worker\">{worker}</script>\n<script type=\"module\">{opening}</script>"
                ),
        ),
    ];
    let html = without_indents(&read("index.html")?);
    let cut = |html: &str, place: &str| -> Result<(String, String), String> {
        let (before, after) = html.split_once(place).ok_or_else(|| format!("index.html lacks {place}"))?;
        Ok((before.to_owned(), after.to_owned()))
    };
    let ((before, rest), library) = (cut(&html, "<!-- body -->\n")?, "<!-- library -->");
    let (body, after) = cut(&rest, library)?;
    let body = packed("body-packed", "text/html+gzip", letters(&gzip(body.as_bytes())?));
    let mut html = [&before, &body, library, &after].concat();
    for (place, part) in parts {
        let (before, after) = cut(&html, place)?;
        html = [before, part, after].concat();
    }
    Ok(html)
}

/// A library compiled to wasm, and the script that speaks with it.
struct Library {
    glue: String,
    wasm: Vec<u8>,
}

impl Library {
    fn of(path: &Path) -> Result<Library, Box<dyn Error>> {
        let mut output = Bindgen::new()
            .input_path(path)
            .no_modules(true)?
            .typescript(false)
            .remove_name_section(true)
            .remove_producers_section(true)
            .generate_output()?;
        Ok(Library { glue: without_comments(output.js())?, wasm: output.wasm_mut().emit_wasm() })
    }
}

/// The page without the indents of its lines, which no element of it shows.
fn without_indents(html: &str) -> String {
    html.lines().map(|line| format!("{}\n", line.trim_start())).collect()
}

/// A script or a style that nobody reads, without what is for readers: comments that stand on lines of their own, and indents.
fn without_comments(script: &str) -> Result<String, String> {
    let (mut in_comment, mut in_text) = (false, false);
    let mut kept = Vec::new();
    for line in script.lines() {
        let was_in_text = in_text;
        let is_comment = !in_text && (in_comment || line.trim_start().starts_with("//"));
        if !is_comment && line.matches('`').count() % 2 == 1 {
            in_text = !in_text;
        }
        // A text over several lines has its indents.
        if was_in_text {
            kept.push(line);
            continue;
        }
        let line = if in_text { line.trim_start() } else { line.trim() };
        let begins = line.starts_with("/*");
        if begins && line.contains("*/") && !line.ends_with("*/") {
            return Err(format!("a comment stands before what is not one: {line}"));
        }
        if begins || in_comment {
            in_comment = !line.ends_with("*/");
        } else if !line.is_empty() && !line.starts_with("//") {
            kept.push(line);
        }
    }
    if in_text || in_comment {
        Err("a text or a comment does not end".to_owned())
    } else {
        Ok(kept.join("\n"))
    }
}

/// A source of the page as its policy names it.
fn hash(source: &str) -> String {
    format!("'sha256-{}'", STANDARD.encode(Sha256::digest(source.as_bytes())))
}

/// The script of the page, to which the library and its unpacker are modules too.
fn page_script(unpacker: &str, modules: &BTreeMap<String, String>) -> Result<String, String> {
    let brought = format!(
        "const module_library = {{ start: wasm_bindgen, Explorer: wasm_bindgen.Explorer }};\n\
         const module_unpacker = (() => {{\n{unpacker}\nreturn {{ startUnpacker: wasm_bindgen, unpack: wasm_bindgen.unpack }};\n}})();\n"
    );
    script(MAIN, brought, &["library", "unpacker"], modules)
}

/// A module behind those that it takes something from, in one script. It begins with modules that are brought, by their names.
fn script(
    first: &str,
    brought: String,
    names: &[&str],
    modules: &BTreeMap<String, String>,
) -> Result<String, String> {
    let mut script = brought;
    let mut done: Vec<String> = names.iter().map(|name| (*name).to_owned()).collect();
    // The first may wait at its top, which no function that is called at once could.
    let (body, _) = behind_its_needs(first, modules, &mut done, &mut script)?;
    Ok(script + &body)
}

/// The lines of a module and the names that it exports, when those that it takes something from stand in the script.
fn behind_its_needs(
    name: &str,
    modules: &BTreeMap<String, String>,
    done: &mut Vec<String>,
    script: &mut String,
) -> Result<(String, Vec<String>), String> {
    let source = modules.get(name).ok_or_else(|| format!("there is no {name}.js"))?;
    let (mut body, mut exports) = (String::new(), Vec::new());
    for line in without_comments(source)?.lines() {
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
    Ok((body, exports))
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
    let (body, exports) = behind_its_needs(name, modules, done, script)?;
    *script += &format!(
        "const module_{} = (() => {{\n{body}return {{ {} }};\n}})();\n",
        identifier(name),
        exports.join(", ")
    );
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

/// Letters that stand for digits: all of one byte, but for those that a page does not keep (NUL, and the return of a carriage), the
/// one that ends an element, and the one that ended files once.
fn alphabet() -> Vec<u8> {
    (1..=127).filter(|letter| !b"\r<\x1a".contains(letter)).collect()
}

/// Pairs of letters that stand for thirteen bits: with them for these and fourteen for the others, every pair stands for some.
const SHORT: u32 = (1 << 14) - 124 * 124;

/// Bytes in letters: each thirteen bits below `SHORT`, and each fourteen of others, are two digits of base 124, and what is left of six
/// bits or fewer is one. Base64 takes a sixth more. `letters.js` undoes it.
fn letters(bytes: &[u8]) -> String {
    let alphabet = alphabet();
    let mut letters = String::with_capacity(bytes.len() * 8 / 6);
    let (mut held, mut count) = (0_u32, 0_u32);
    let mut more = bytes.iter();
    loop {
        while count < 14
            && let Some(byte) = more.next()
        {
            held = held << 8 | u32::from(*byte);
            count += 8;
        }
        if count <= 6 {
            letters.extend((count > 0).then(|| char::from(alphabet[(held << (6 - count)) as usize])));
            return letters;
        }
        // With zeros behind the last bits, fewer than make a byte.
        let next = if count < 14 { held << (14 - count) } else { held >> (count - 14) };
        let (digits, taken) = if next >> 1 < SHORT { (next >> 1, 13) } else { (next - SHORT, 14) };
        letters.extend([digits / 124, digits % 124].map(|digit| char::from(alphabet[digit as usize])));
        count = count.saturating_sub(taken);
        held &= (1 << count) - 1;
    }
}

fn gzip(bytes: &[u8]) -> io::Result<Vec<u8>> {
    let mut packer = GzEncoder::new(Vec::new(), Compression::best());
    packer.write_all(bytes)?;
    packer.finish()
}

fn lzma(bytes: &[u8]) -> io::Result<Vec<u8>> {
    let options = LzmaOptions { dict_size: 1 << 23, lc: 4, pb: 0, ..LzmaOptions::with_preset(9) };
    let mut packer = LzmaWriter::new_use_header(Vec::new(), &options, Some(bytes.len() as u64))?;
    packer.write_all(bytes)?;
    packer.finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_a_script_what_runs_is_left() {
        let script = "  /**\n   * Doc.\n   */\n  function a() {\n    // A word.\n\n    return `b`; // c\n  }\n/* d */\na();\n";
        assert_eq!(without_comments(script).unwrap(), "function a() {\nreturn `b`; // c\n}\na();");
        // A text over several lines stays as it is, whatever it looks like.
        let text = "  a(`b\n  // c\n`);\n  d();";
        assert_eq!(without_comments(text).unwrap(), "a(`b\n  // c\n`);\nd();");
        assert!(without_comments("/* a */ b").is_err() && without_comments("a(`b").is_err());
    }

    /// By another way: the bits are written out, and read again.
    #[test]
    fn letters_are_the_bytes() {
        let alphabet = alphabet();
        assert_eq!(alphabet.len(), 124);
        let digit = |letter: u8| alphabet.iter().position(|known| *known == letter).unwrap();
        for count in 0..500u32 {
            let bytes: Vec<u8> =
                (0..count).map(|i| (i * 97 + count * 31) as u8 & (0xff >> (count % 8))).collect();
            let letters = letters(&bytes);
            let bits: String = letters
                .as_bytes()
                .chunks(2)
                .map(|group| match group {
                    [one] => format!("{:06b}", digit(*one)),
                    [one, two] => match 124 * digit(*one) + digit(*two) {
                        short @ ..1008 => format!("{short:013b}"),
                        long => format!("{:014b}", long + 1008),
                    },
                    _ => unreachable!("chunks of two"),
                })
                .collect();
            let (whole, rest) = bits.split_at(8 * bytes.len());
            let back: Vec<u8> =
                (0..bytes.len()).map(|i| u8::from_str_radix(&whole[8 * i..8 * i + 8], 2).unwrap()).collect();
            assert_eq!(back, bytes);
            assert!(rest.len() < 8, "no byte too many");
        }
    }

    #[test]
    fn modules_become_one_script_in_the_order_of_their_needs() {
        let sources = [
            ("main", "import { a, b } from \"one\";\nimport { start } from \"library\";\na(b);"),
            ("one", "import { c } from \"two\";\nexport const b = c;\nexport async function a() {\n}"),
            ("two", "export function c(x) {\n}"),
        ];
        let modules = sources.map(|(name, source)| (name.to_owned(), source.to_owned())).into();
        let script = page_script("let wasm_bindgen;", &modules).unwrap();
        let at = |part: &str| script.find(part).unwrap_or_else(|| panic!("{part} in {script}"));
        assert!(at("const module_two") < at("const module_one") && at("const module_one") < at("a(b);"));
        assert!(
            script.contains(
                "const { c } = module_two;\nconst b = c;\nasync function a() {\n}\nreturn { b, a };"
            )
        );
        assert!(
            page_script("", &[("main".to_owned(), "import { x } from \"none\";".to_owned())].into()).is_err()
        );
    }
}
