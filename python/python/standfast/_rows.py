"""Problems that are answered row by row: arrays are cut into blocks, so that Ctrl-C is obeyed between two of them."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from time import monotonic
from typing import Any, NoReturn

import numpy as np
from numpy.typing import NDArray

from . import _standfast
from ._frames import Missing
from ._inputs import Operands, read
from ._run import Run
from ._standfast import StandfastError

#: How many rows a thread answers before anything else is looked at: some milliseconds, or some tenths of a second where each needs
#: exact arithmetic.
_BLOCK = 1 << 14

#: For how many threads there are rows in one go at most, so that buffers are some tens of MB.
_THREADS = 32

#: How often, in seconds, progress is told.
_PAUSE = 0.1

Columns = dict[str, NDArray[Any]]

#: Where wrong rows are marked; where there is no such place, the first of them is a fault.
Wrong = NDArray[np.bool_] | None

#: The first wrong row: its place, the value in words, and what is expected.
Fault = tuple[int, str, str] | None

#: Answers a block of operands into columns.
Solve = Callable[[list[NDArray[np.float64]], Columns, Wrong], Fault]


def answer(
    operands: Operands, dtypes: Mapping[str, type[np.generic]], solve: Solve, run: Run, *, together: bool = False
) -> tuple[Columns, Missing]:
    """Columns of these types in the shape of the operands, and which rows have no answer.

    Args:
        together: whether all operands of a row are to be set where one is missing, because they bound each other.
    """
    arrays, missing = operands.arrays(together=together)
    shape = operands.shape
    found: Columns = {name: np.empty(shape, dtype) for name, dtype in dtypes.items()}
    flat = {name: column.reshape(-1) for name, column in found.items()}
    wrong: Wrong = np.zeros(shape, dtype=np.bool_) if run.null_errors else None
    total = int(np.prod(shape, dtype=np.int64))
    if total == 0 and run.progress is not None:
        run.progress(0, 0)
    # Of numpy's types, the flag "contig" is spelled otherwise.
    nditer: Any = np.nditer
    blocks = () if total == 0 else nditer(
        arrays,
        flags=["external_loop", "buffered"],
        op_flags=[["readonly", "contig", "aligned"]] * len(arrays),
        op_dtypes=[np.float64] * len(arrays),
        casting="same_kind",
        order="C",
        buffersize=_BLOCK * min(run.threads or os.cpu_count() or 1, _THREADS),
    )
    done, told = 0, monotonic()
    for block in blocks:
        stop = done + block[0].size
        here = None if wrong is None else wrong.reshape(-1)[done:stop]
        fault = solve(list(block), {name: column[done:stop] for name, column in flat.items()}, here)
        if fault is not None:
            _raise(fault, done, shape)
        done = stop
        if run.progress is not None and (done == total or monotonic() - told > _PAUSE):
            told = monotonic()
            run.progress(done, total)
    if wrong is not None and wrong.any():
        missing = wrong if missing is None else missing | wrong
    return found, missing


def point(function: str, names: Sequence[str], given: Sequence[object]) -> list[float]:
    """Plain numbers, for functions that take nothing else."""
    operands = read(function, names, given)
    arrays, missing = operands.arrays()
    if operands.shape != () or missing is not None:
        many = "" if function == "Diagram" else "; arrays and columns are for limit_states, onset and contact"
        raise TypeError(f"{function} takes one number for each of {', '.join(names)}{many}")
    return [float(array) for array in arrays]


def numbers(columns: Columns, places: Mapping[str, int]) -> list[tuple[int, NDArray[np.float64]]]:
    """The columns of numbers, by their places among those of the native module."""
    return [(places[name], column) for name, column in columns.items() if name in places]


def _raise(fault: tuple[int, str, str], before: int, shape: tuple[int, ...]) -> NoReturn:
    row, given, expected = fault
    if not shape:
        raise StandfastError(f"{given}; expected {expected}")
    index = tuple(map(int, np.unravel_index(before + row, shape)))
    error = StandfastError(f"{given} at index {index[0] if len(index) == 1 else index}; expected {expected}")
    vars(error)["index"] = index
    raise error


_INPUTS, _MOTION = _standfast.contact_names()
CONTACT_INPUTS = tuple(_INPUTS)
MOTION = {name: place for place, name in enumerate(_MOTION)}
