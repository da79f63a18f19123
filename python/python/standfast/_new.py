"""Cases to begin from."""

from __future__ import annotations

import os
from pathlib import Path

from . import _standfast
from ._standfast import StandfastError


def new(kind: str, path: str | os.PathLike[str] | None = None) -> str:
    """A complete case file with comments to begin from: what ``standfast new`` writes.

    Args:
        kind: ``"block"``, ``"caisson"``, ``"wall"``, ``"statue"``, ``"rack"``, ``"motion"`` or ``"random"``.
        path: where to write it, if it is to be written; a file that is there stays as it is.

    Returns:
        The text of the case file.

    Raises:
        StandfastError: for another kind.
        FileExistsError: if there is a file already.

    >>> text = new("statue")
    >>> text.splitlines()[0]
    '# A statue in an earthquake, to begin from. Put your own numbers in place of these, which are made up.'
    >>> "[earthquake]" in text
    True
    """
    texts = {name: text for name, _, text in _standfast.beginnings()}
    if kind not in texts:
        raise StandfastError(f"kind is {kind!r}; expected {', '.join(texts)}")
    if path is not None:
        with Path(path).open("x", encoding="utf-8", newline="\n") as file:
            file.write(texts[kind])
    return texts[kind]


def examples(folder: str | os.PathLike[str] = "examples") -> list[Path]:
    """Writes the examples of README and book, with the records that they name: what ``standfast new --examples`` writes.

    Args:
        folder: where to write them; it is made, and a file that is there stays as it is.

    Returns:
        The files written.

    Raises:
        FileExistsError: if one of the files is there already; then none is written.
    """
    files = {Path(folder) / name: content for name, content in _standfast.examples()}
    for path in files:
        if path.exists():
            raise FileExistsError(f"{path} is there already; choose another folder")
    for path, content in files.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    return list(files)
