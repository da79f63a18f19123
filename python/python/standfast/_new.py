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
