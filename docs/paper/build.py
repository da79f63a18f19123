"""Builds the paper: paper.md by pandoc, as the journals of open research software do, and its PDF by a browser of the Chromium family.

    pip install pypandoc_binary
    python build.py [-o paper.pdf]        # or .html, for which no browser is needed

A citation without an entry, or anything else of which pandoc warns, is an error.
"""

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome", "microsoft-edge", "msedge")


def figure(folder: Path) -> None:
    """The two planes of the gallery side by side, without the captions below them, as one file."""
    width, height = 552, 404
    both = []
    for place, name in enumerate(("3.11", "4.7a")):
        drawing = (HERE.parent / "gallery" / f"fig-{name}.svg").read_text(encoding="utf-8")
        _, inside = drawing.split(">", 1)
        both.append(f'<svg x="{place * width}" width="{width}" height="{height}" viewBox="0 0 {width} {height}" font-family="serif">{inside}')
    drawn = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {2 * width} {height}">{"".join(both)}</svg>\n'
    (folder / "plane.svg").write_text(drawn, encoding="utf-8")


def pandoc() -> str:
    found = shutil.which("pandoc")
    if found:
        return found
    try:
        import pypandoc
    except ImportError:
        raise SystemExit("pandoc was not found: pip install pypandoc_binary") from None
    return str(pypandoc.get_pandoc_path())


def page() -> str:
    """The paper as one HTML page."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        figure(folder)
        command = [pandoc(), HERE / "paper.md", "--from", "markdown", "--to", "html5", "--citeproc", "--mathml", "--embed-resources", "--fail-if-warnings"]
        command += ["--standalone", "--template", HERE / "template.html", f"--resource-path={folder}:{HERE}", "--bibliography", HERE / "paper.bib"]
        command += ["--lua-filter", HERE / "figures.lua", "--no-highlight"]
        ran = subprocess.run(command, capture_output=True, encoding="utf-8")
        if ran.returncode != 0:
            raise SystemExit(ran.stderr)
        return ran.stdout


def printed(html: str, to: Path) -> None:
    """The page as PDF."""
    browser = os.environ.get("STANDFAST_BROWSER") or next(filter(None, map(shutil.which, BROWSERS)), None)
    if browser is None:
        raise SystemExit("no browser of the Chromium family was found; STANDFAST_BROWSER names one, and -o paper.html needs none")
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "paper.html"
        file.write_text(html, encoding="utf-8")
        command = [browser, "--headless", "--disable-gpu", "--no-pdf-header-footer", f"--user-data-dir={folder}/profile"]
        command += ["--no-sandbox"] if hasattr(os, "geteuid") and os.geteuid() == 0 else []
        subprocess.run([*command, f"--print-to-pdf={to.resolve()}", str(file)], check=True, capture_output=True, timeout=120)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-o", "--output", type=Path, default=Path("paper.pdf"), help="a .pdf or .html (paper.pdf)")
    to = parser.parse_args().output
    if to.suffix not in (".pdf", ".html"):
        sys.exit(f"--output is {to}; expected a .pdf or .html")
    if not to.resolve().parent.is_dir():
        sys.exit(f"--output is {to}, and there is no folder {to.parent}")
    html = page()
    if to.suffix == ".html":
        to.write_text(html, encoding="utf-8")
    else:
        printed(html, to)


if __name__ == "__main__":
    main()
