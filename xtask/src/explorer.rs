//! The explorer: the library for wasm, the page around it, a server on this machine, and its tests in a browser.

use std::ffi::OsString;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{fs, thread};

use crate::tally::{Tally, cargo, in_ci, timed};
use crate::{built, dist, programs, ran, root, target, targets};

const TARGET: &str = "wasm32-unknown-unknown";

/// Builds `target/explorer/standfast-explorer.html`, and the same file as the site `target/explorer/site`; `bundler` makes
/// one file of many.
fn build(mut bundler: Command) -> Result<PathBuf, String> {
    let toolchain = toolchain()?;
    // Apart from other builds: its compiler may be another one, and the page is handed on, and so names no folder of this machine.
    let wasm = target().join("wasm");
    let flags = dist::without_paths()?;
    let packages = ["--package", "standfast-web", "--package", "standfast-web-unpack", "--lib"];
    let arguments = [&["build", "--quiet", "--profile", "wasm", "--target", TARGET], &packages[..]].concat();
    ran(cargo(&arguments)
        .envs(toolchain)
        .env("CARGO_TARGET_DIR", &wasm)
        .env("CARGO_ENCODED_RUSTFLAGS", flags))?;

    let folder = target().join("explorer");
    let site = folder.join("site");
    fs::create_dir_all(&site).map_err(|error| format!("{}: {error}", site.display()))?;
    let page = folder.join("standfast-explorer.html");
    ran(bundler.arg(wasm.join(TARGET).join("wasm")).arg(root().join("web").join("page")).arg(&page))?;
    fs::copy(&page, site.join("index.html")).map_err(|error| format!("{}: {error}", site.display()))?;
    Ok(page)
}

/// The explorer, built.
pub fn file() -> Result<PathBuf, String> {
    build(cargo(&["run", "--quiet", "--package", "standfast-web-bundle", "--"]))
}

/// What the page holds packed.
pub fn library() -> PathBuf {
    target().join("wasm").join(TARGET).join("wasm/standfast_web.wasm")
}

/// The environment in which cargo compiles for wasm: rustup's, or a toolchain made of Debian's packages.
fn toolchain() -> Result<Vec<(String, OsString)>, String> {
    if targets::added(TARGET).is_ok() {
        return Ok(Vec::new());
    }
    let folder = target().join("wasm-toolchain");
    println!("── rustup has none: a toolchain from Debian's packages, in {}", folder.display());
    let script = root().join("xtask").join("wasm-toolchain.sh");
    ran(Command::new("bash").arg(script).arg(&folder)).map_err(|error| {
        format!("no compiler for {TARGET}: `rustup target add {TARGET}` failed, and so did Debian's packages: {error}")
    })?;
    let listed = Command::new("bash")
        .args(["-c", ". \"$0/env\" && printf '%s\\n' \"$RUSTC\" \"$LD_LIBRARY_PATH\" \"$PATH\""])
        .arg(&folder)
        .output()
        .map_err(|error| error.to_string())?;
    let values = String::from_utf8_lossy(&listed.stdout).into_owned();
    let names = ["RUSTC", "LD_LIBRARY_PATH", "PATH"].into_iter().map(str::to_owned);
    Ok(names.zip(values.lines().map(OsString::from)).collect())
}

/// True if the explorer can be compiled without fetching anything.
fn has_toolchain() -> bool {
    targets::has(TARGET) || target().join("wasm-toolchain").join("env").is_file()
}

/// Builds the explorer and serves it on this machine until interrupted; opens it in the browser if asked.
pub fn serve(open: bool) -> Result<(), String> {
    let page = file()?;
    let (address, server) = server(&page, 8420)?;
    println!("{}\n{address}  (Ctrl+C ends it)", page.display());
    if open {
        opened(&address);
    }
    server.join().map_err(|_| "the server stopped".to_owned())
}

/// Opens an address or a file in the browser.
pub fn opened(address: &str) {
    let opener = match std::env::consts::OS {
        "macos" => "open",
        "windows" => "explorer",
        _ => "xdg-open",
    };
    if let Err(error) = Command::new(opener).arg(address).spawn() {
        println!("{opener}: {error}; open the address above yourself");
    }
}

/// Serves one page on localhost, at `port` or, if that is taken, at any other.
fn server(page: &Path, port: u16) -> Result<(String, thread::JoinHandle<()>), String> {
    let content = fs::read(page).map_err(|error| format!("{}: {error}", page.display()))?;
    let listener = TcpListener::bind(("127.0.0.1", port))
        .or_else(|_| TcpListener::bind(("127.0.0.1", 0)))
        .map_err(|error| format!("no port to serve on: {error}"))?;
    let address = listener.local_addr().map_err(|error| error.to_string())?;
    let server = thread::spawn(move || {
        for stream in listener.incoming().flatten() {
            // A browser that goes away is no concern of the server.
            let _ = answer(stream, &content);
        }
    });
    Ok((format!("http://{address}/"), server))
}

fn answer(mut stream: TcpStream, page: &[u8]) -> std::io::Result<()> {
    let mut request = String::new();
    let mut reader = BufReader::new(stream.try_clone()?.take(64 * 1024));
    reader.read_line(&mut request)?;
    let mut line = String::new();
    while reader.read_line(&mut line)? > 2 {
        line.clear();
    }
    let path = request.split_whitespace().nth(1).unwrap_or("/");
    let (status, content) = match path.split(['?', '#']).next() {
        Some("/" | "/index.html") => ("200 OK", page),
        _ => ("404 Not Found", &b"There is one page here: /"[..]),
    };
    write!(
        stream,
        "HTTP/1.1 {status}\r\nContent-Type: text/html; charset=utf-8\r\nContent-Length: {}\r\n\
         Cache-Control: no-store\r\nConnection: close\r\n\r\n",
        content.len()
    )?;
    stream.write_all(content)
}

/// Builds the explorer and tries it in a browser, where everything for that is there; see [`Tally::missing`].
pub fn check(tally: &mut Tally) {
    println!("── explorer");
    let chromium = match prerequisites() {
        Ok(chromium) => chromium,
        Err(missing) => return tally.missing("explorer", missing),
    };
    let page = match timed("explorer built", || build(Command::new(built("standfast-web-bundle")))) {
        Ok(page) => page,
        Err(error) => return tally.fail("explorer", error),
    };
    tally.passed += 1;
    if let Err(error) = browser_tests(tally, &page, &chromium) {
        tally.fail("explorer", error);
    }
}

/// The browser; that the compiler and what the tests are written in are there too.
fn prerequisites() -> Result<PathBuf, String> {
    if !in_ci() && !has_toolchain() {
        return Err(format!(
            "there is no compiler for {TARGET}: `rustup target add {TARGET}` adds it, and so does `cargo xtask explorer`"
        ));
    }
    let chromium = programs::chromium().map_err(|missing| missing.to_string())?;
    programs::needed("Node.js with npm", &["nodejs", "npm"], || {
        programs::found("node").and(programs::found("npm"))
    })
    .map_err(|missing| missing.to_string())?;
    ran(Command::new("npm").args(["ci", "--no-audit", "--no-fund", "--silent"]).current_dir(tests()))?;
    Ok(chromium)
}

fn browser_tests(tally: &mut Tally, page: &Path, chromium: &Path) -> Result<(), String> {
    let (address, _) = server(page, 0)?;
    // Its tests alone are left out without it.
    let firefox = programs::firefox();
    if let Err(missing) = &firefox {
        tally.missing("explorer in Firefox", missing.to_string());
    }
    let artefacts = target().join("explorer").join("screenshots");
    let (alone, together) = test_files()?;
    for (name, files, at_once) in
        [("explorer in a browser", together, 2), ("frames of the explorer", alone, 1)]
    {
        let mut node = Command::new("node");
        node.args(["--test", "--test-reporter=spec"])
            .arg(format!("--test-concurrency={at_once}"))
            .args(files)
            .current_dir(tests())
            .env("EXPLORER_HTML", page)
            .env("EXPLORER_SITE", &address)
            .env("EXPLORER_ARTEFACTS", &artefacts)
            .env("STANDFAST", built("standfast"))
            .env("CHROMIUM", chromium)
            .envs(firefox.as_ref().ok().map(|path| ("FIREFOX", path)));
        tally.count(name, &mut node, node_line);
    }
    println!("screenshots: {}", artefacts.display());
    Ok(())
}

fn tests() -> PathBuf {
    root().join("web").join("tests")
}

/// Files with tests: those that measure how long a picture takes, which want the machine for themselves, and all others.
fn test_files() -> Result<(Vec<String>, Vec<String>), String> {
    const MEASURED: [&str; 3] = ["compare.test.mjs", "hands.test.mjs", "time.test.mjs"];
    let found = fs::read_dir(tests()).map_err(|error| format!("{}: {error}", tests().display()))?;
    let mut files: Vec<String> =
        found.filter_map(Result::ok).map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
    files.retain(|name| name.ends_with(".test.mjs"));
    files.sort();
    Ok(files.into_iter().partition(|name| MEASURED.contains(&name.as_str())))
}

/// Passed, failed and skipped in a line of node's summary, such as `ℹ pass 12`; that there was no test is a failure.
fn node_line(line: &str) -> Option<[usize; 3]> {
    let (what, number) = line.trim_start_matches("ℹ ").split_once(' ')?;
    let number = number.trim().parse().ok()?;
    match what {
        "tests" if number == 0 => Some([0, 1, 0]),
        "pass" => Some([number, 0, 0]),
        "fail" | "cancelled" => Some([0, number, 0]),
        "skipped" => Some([0, 0, number]),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_read_from_nodes_summary() {
        assert_eq!(node_line("ℹ pass 12"), Some([12, 0, 0]));
        assert_eq!(node_line("ℹ fail 2"), Some([0, 2, 0]));
        assert_eq!(node_line("ℹ tests 0"), Some([0, 1, 0]));
        assert_eq!(node_line("ℹ tests 14"), None);
        assert_eq!(node_line("ℹ duration_ms 213.5"), None);
    }

    fn ask(address: &str, path: &str) -> String {
        let host = address.trim_start_matches("http://").trim_end_matches('/');
        let mut stream = TcpStream::connect(host).unwrap();
        write!(stream, "GET {path} HTTP/1.1\r\nHost: {host}\r\n\r\n").unwrap();
        let mut answer = String::new();
        stream.read_to_string(&mut answer).unwrap();
        answer
    }

    #[test]
    fn the_server_has_one_page() {
        let folder = tempfile::tempdir().unwrap();
        let page = folder.path().join("page.html");
        fs::write(&page, "<p>page</p>").unwrap();
        let (address, _) = server(&page, 0).unwrap();
        assert!(ask(&address, "/").ends_with("\r\n\r\n<p>page</p>"));
        assert!(ask(&address, "/index.html?x").starts_with("HTTP/1.1 200"));
        assert!(ask(&address, "/../../etc/passwd").starts_with("HTTP/1.1 404"));
    }
}
