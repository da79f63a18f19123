"""How far long work is: a bar, or whoever wants to be told."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext
from typing import Any

from ._run import Told
from ._types import Progress


def shown(progress: Progress, unit: str | None = "rows") -> AbstractContextManager[Told | None]:
    """What the native module is to call with what is done and all there is; ``None`` for nothing.

    Args:
        progress: what the caller of a function has asked for.
        unit: of what is done, in a bar; ``None`` where only its share of the whole says anything.

    Raises:
        ImportError: for a bar without tqdm.
        TypeError: for anything else than what :data:`._types.Progress` says.
    """
    if progress is None or progress is False:
        return _NOBODY
    if progress is True:
        return _shown_by_bar(_bar(unit))
    if callable(progress):
        return nullcontext(progress)
    raise TypeError(f"progress is {progress!r}; expected True for a bar, False, or a function of (done, total)")


_NOBODY: AbstractContextManager[Told | None] = nullcontext()


@contextmanager
def _shown_by_bar(bar: Any) -> Iterator[Told]:
    try:
        yield lambda done, total: _advance(bar, done, total)
    finally:
        bar.close()


#: What a bar shows of work that is told in shares.
_SHARES = "{l_bar}{bar}| [{elapsed}<{remaining}]"


def _bar(unit: str | None) -> Any:
    try:
        from tqdm.auto import tqdm  # type: ignore[import-untyped,import-not-found,unused-ignore]
    except ImportError:
        raise ImportError('progress=True needs tqdm: pip install "standfast[progress]"') from None
    return tqdm(bar_format=_SHARES) if unit is None else tqdm(unit=f" {unit}", unit_scale=True)


def _advance(bar: Any, done: int, total: int | None) -> None:
    if bar.total != total:
        bar.total = total
    bar.update(done - bar.n)
