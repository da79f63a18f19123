"""The calculation sheet of a case, to be filed and signed."""

from __future__ import annotations

import datetime
import os
import shutil
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Literal

from . import _standfast
from ._assess import case_text
from ._progress import shown
from ._standfast import StandfastError
from ._types import Progress


def sheet(
    case: str | os.PathLike[str] | Mapping[str, object],
    path: str | os.PathLike[str] | None = None,
    *,
    short: bool = False,
    date: str | datetime.date | None = None,
    up_to: float = 2.0,
    paper: Literal["a4", "letter"] = "a4",
    project: str | None = None,
    client: str | None = None,
    sheet: str | None = None,
    revision: str | None = None,
    author: str | None = None,
    checker: str | None = None,
    progress: Progress = None,
) -> str:
    """The calculation sheet of a case: what ``standfast sheet`` writes, one HTML file that loads nothing.

    Inputs with their sources, assumptions, every step as formula, numbers put in and result, the verdict with its margins,
    figures, sensitivity, what is not covered, room for signatures. The same case, options and version give the same bytes.

    Args:
        case: the path of a case file, or a dict with the same keys, as in :func:`assess`.
        path: where to write the sheet, whole or not at all, if it is to be written: ``.html``, or ``.pdf`` to have it printed by
            Chromium or Chrome; the variable ``STANDFAST_BROWSER`` names another.
        short: whether to write one page only: the verdict, the section, the inputs that decide, each criterion in each combination,
            signatures.
        date: the day the sheet bears, as ``"2026-11-21"`` or a date; without it the sheet says that it is undated.
        up_to: how far the path of a rising load is followed, in multiples of the load, from 1 to a million.
        paper: the size of a PDF's pages.
        project, client, sheet, revision, author, checker: what goes into the title block before what the case says.
        progress: ``True`` for a bar (with ``standfast[progress]``), or a function of the parts done and all parts, thousandths of the work.

    Returns:
        The HTML document. ``IPython.display.HTML`` shows it in a notebook.

    Ctrl-C ends the call at once, and nothing is written.

    Raises:
        StandfastError: for a case that is not understood, and for a wrong date, paper or extension.
        OSError: if a file cannot be read or written.
        RuntimeError: if there is no browser to print a PDF, or it prints nothing.

    >>> html = sheet("examples/goda-2000.toml", date="2026-11-21", author="N. N.")
    >>> html[:15], "2026-11-21" in html
    ('<!DOCTYPE html>', True)
    >>> "Inputs that decide" in sheet("examples/goda-2000.toml", short=True)
    True
    """
    arguments = locals()
    told = {key: arguments[key] for key in _standfast.title_block()}
    for key, text in told.items():
        if text is not None and not isinstance(text, str):
            raise TypeError(f"{key} is {text!r}; expected a text")
    target = None if path is None else Path(path)
    extension = "" if target is None else target.suffix.lower()
    if target is not None and extension not in (".html", ".pdf"):
        found = f"unknown extension {target.suffix!r}" if extension else "no extension"
        raise StandfastError(f"path is {str(target)!r}, with {found}; the extension has to be .html or .pdf")
    if target is not None and not isinstance(case, Mapping) and target.exists() and os.path.samefile(case, target):
        raise StandfastError(f"the sheet would be written over the case file {os.fspath(case)}; choose another path")
    if target is not None and not target.parent.is_dir():
        raise FileNotFoundError(f"path is {str(target)!r}, and there is no folder {str(target.parent)!r}")
    if isinstance(date, datetime.datetime):
        date = date.date()
    day = date.isoformat() if isinstance(date, datetime.date) else date
    if day is not None and not isinstance(day, str):
        raise TypeError(f"date is {date!r}; expected a text like '2026-11-21' or a date")
    given = [(key, text) for key, text in told.items() if text is not None]
    file = case_text(case)
    with shown(progress, None) as told_of:
        print_as = (paper, extension == ".pdf", bool(short))
        html, pdf = _standfast.sheet(file, day, up_to, given, print_as, told_of)
    if target is not None:
        _write(target, html.encode() if pdf is None else pdf)
    return html


def _write(path: Path, content: bytes) -> None:
    """Writes a file whole or not at all; a link is followed, and what is replaced leaves its permissions."""
    place = Path(os.path.realpath(path))
    if place.exists() and not place.is_file():
        # A device or pipe cannot be replaced; a directory says so.
        place.write_bytes(content)
        return
    with tempfile.TemporaryDirectory(prefix=".standfast-", dir=place.parent) as folder:
        unfinished = Path(folder) / place.name
        unfinished.write_bytes(content)
        if place.exists():
            shutil.copymode(place, unfinished)
        unfinished.replace(place)
