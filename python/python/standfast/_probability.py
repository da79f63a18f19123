"""How likely each mode is where some numbers of a case are random, and draws of these numbers."""

from __future__ import annotations

import functools
import operator
import os
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Literal, NamedTuple, TypeAlias

import numpy as np

from . import _standfast
from ._advice import Advice
from ._advice import shown as said
from ._answer import Rendered
from ._arrow import ArrowTable
from ._assess import case_text
from ._figure import Figure, figures_of
from ._modes import SYMBOLS
from ._progress import shown
from ._ranges import Over, over_of
from ._records import Records, check_unit, records_of
from ._run import Told, run
from ._standfast import StandfastError
from ._types import Array, Progress
from ._warnings import mind
from .chances import ProbabilityDocument

_SEED, _PRECISION, _FLOOR, _SAMPLES = _standfast.plain_effort()
#: An acceleration of the base: an array, or arrays under "horizontal", "vertical" and "dt".
Record: TypeAlias = "Array | Mapping[str, Any]"

_ADVICE = Advice("probability")
#: The code of no mode.
_NO_MODE = np.iinfo(np.uint8).max


class Probability(ProbabilityDocument, Rendered):
    """How likely each mode is: :func:`probability`'s answer.

    ``print`` shows the text of ``standfast probability``; the keys of its JSON document, which ``docs/probability.schema.json``
    describes, are attributes. ``modes`` has the probability of each mode with its interval, under its symbol or its :class:`Mode`. Of
    a case with several sets of loads it is the answer to the least safe, and ``others`` has the others. A pickle holds text, document and
    figures: nothing is drawn again where it is loaded.
    """

    _what = "this answer"
    _drawn: Callable[[], list[Figure]]
    #: That of a case that is a dict.
    _title: str | None

    def __init__(
        self, text: str, document: str, figures: list[Figure] | Callable[[], list[Figure]], title: str | None = None
    ) -> None:
        super().__init__(text, document)
        vars(self).update(_drawn=figures if callable(figures) else lambda: figures, _title=title)

    @functools.cached_property
    def figures(self) -> list[Figure]:
        """The figures: draws, probabilities with their intervals, what matters, and, where there is such a thing, how the answer settled, what
        there is along a number, and how far it slides. The item ``"figures"`` names the files of the program's, and is empty here."""
        return self._drawn()

    def _repr_svg_(self) -> str | None:
        """The probabilities, of which every answer to a body has a figure."""
        chosen = [figure for figure in self.figures if figure.title == "Probabilities"] or self.figures
        return chosen[0].svg if chosen else None

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self._text, self._json, self.figures, self._title)

    def __repr__(self) -> str:
        others = f"; {len(self.others)} other set{'s' if len(self.others) > 1 else ''} of loads" if self.others else ""
        return f"<Probability {self._title or os.path.basename(self.case)}: {self._said()}{others}>"

    def _said(self) -> str:
        """What was asked for: how likely the body overturns along peaks, does not rest along a number, or begins in each mode."""
        if self.overturning is not None:
            first, last = self.overturning.points[0], self.overturning.points[-1]
            ends = [f"{end.overturned.probability:.4g} at {end.peak:.4g} m/s²" for end in (first, last)]
            return f"overturns {' to '.join(ends)}"
        if self.fragility is not None:
            first_value, last_value = self.fragility.points[0], self.fragility.points[-1]
            values = [f"{end.not_rest.probability:.4g} at {end.value:.4g}" for end in (first_value, last_value)]
            return f"does not rest {' to '.join(values)} of {self.fragility.name}"
        likely = [(name, chance) for name, chance in self.modes.items() if chance.probability > 0]
        likely.sort(key=lambda one: -one[1].probability)
        shown = ", ".join(f"{name} {chance.probability:.4g}" for name, chance in likely[:4])
        return shown + (f", … {len(likely) - 4} more" if len(likely) > 4 else "")


class _Asked(NamedTuple):
    """What the native module is asked beside the case."""

    method: str | None
    seed: int
    precision: float
    floor: float
    samples: int
    years: float | None
    over: str | None
    follow: bool
    threads: int | None
    progress: Told | None


def probability(
    case: str | os.PathLike[str] | Mapping[str, object],
    *,
    method: Literal["integrate", "sobol", "importance", "monte-carlo", "form"] | None = None,
    seed: int = _SEED,
    precision: float = _PRECISION,
    floor: float = _FLOOR,
    samples: int = _SAMPLES,
    years: float | None = None,
    over: Over | None = None,
    records: Sequence[Record] | None = None,
    dt: float | Array | None = None,
    unit: Literal["m/s2", "g", "cm/s2"] | None = None,
    rotations: Literal["count", "simulate"] = "count",
    threads: int | None = None,
    progress: Progress = None,
) -> Probability:
    """How likely is each mode, where some numbers of a case are random?

    Friction is integrated in closed form: for given other numbers each mode is an interval of it. Hardly anything is drawn.

    Args:
        case: the path of a case file with a table ``[random]``, or a dict with the same keys; or a ``[point]`` of the report's plane.
        method: ``"integrate"`` (to all digits, three random numbers at most), ``"sobol"``, ``"importance"`` or ``"monte-carlo"``; the best
            that takes as many numbers, if it is left out. ``"form"`` adds ``design_points``, the nearest point of every mode, to that.
        seed: of all random numbers. The same gives the same answer, for any number of threads.
        precision: how wide half of a 95 % interval may be, relative to its probability.
        floor: probabilities below it need not be precise.
        samples: the most points that are drawn, but for 32 at least, or 16384 by ``"monte-carlo"``; a motion that is followed counts as 1024 of them.
        years: of a life, before those of the case.
        over: the same along a number of the case, with what goes with it: ``"width=12 m..20 m:9"``, its name, the first and the last
            value as a case file has them, and how many; or ``{"width": [12, 14, 18]}``, a dict of its name with values, rising: numbers in
            SI units, a list, a tuple, an array, a Series, a DataArray of one dimension, or texts with units. The answer is ``fragility``, with a lognormal curve. ``"pga=0.2 g..1 g:9"`` of a
            case whose base moves follows bodies in time: ``overturning``.
        records: of ``over="pga=…"``, accelerations of the base in place of those of the case, each as likely, and scaled to each peak to the
            sides: arrays, or dicts of arrays under ``"horizontal"`` and ``"vertical"``, with ``"dt"`` where that is their own. The vertical
            one is scaled by the same factor.
        dt, unit: of the records, as for :func:`simulate`.
        rotations: what becomes of waves of a storm that begin a rotation: ``"count"`` them apart, or ``"simulate"`` each in time.
        threads: how many threads to use; ``None`` for as many as there are processors.
        progress: ``True`` for a bar (with ``standfast[progress]``), or a function of the parts done and all parts, thousandths of the work.
            Storms and records take some ten seconds.

    Ctrl-C ends the call at once.

    Raises:
        CaseError: for a case, law or correlation that is not understood; the message shows where, and what is expected.
        StandfastError: for a case without random numbers, and for other arguments.
        OSError: if the case file cannot be read.

    >>> plane = {
    ...     "point": {"gamma": 0.8, "k_prime": 0.9167},
    ...     "random": {
    ...         "k": {"gumbel": {"mean": 0.3, "sd": 0.08}},
    ...         "mu": {"lognormal": {"mean": 0.6, "cov": 0.15}},
    ...     },
    ... }
    >>> found = probability(plane)
    >>> found.method, round(sum(chance.probability for chance in found.modes.values()), 12)
    ('integrate', 1.0)
    >>> round(found.modes["RE"].probability + found.not_rest.probability, 12)
    1.0
    """
    if method is not None and not isinstance(method, str):
        raise TypeError(f"method is {method!r}; expected the name of a method")
    _check_shares(precision=precision, floor=floor)
    if years is not None and (not _is_number(years) or not 0 < years < float("inf")):
        raise StandfastError(f"years is {years!r}; expected a number above zero")
    along = None if over is None else over_of(over, "width=12 m..20 m:9", _ADVICE)
    if rotations not in ("count", "simulate"):
        raise StandfastError(f"rotations is {rotations!r}; expected 'count' or 'simulate'")
    how = run(threads)
    file, bases = case_text(case), _given(records, dt, unit, along)
    with shown(progress, None) as told:
        asked = _Asked(
            method, _whole(seed, "seed", 0), float(precision), float(floor), _whole(samples, "samples", 1),
            None if years is None else float(years), along, rotations == "simulate", how.threads, told,
        )  # fmt: skip
        found = _standfast.probability(file, asked, bases)
    mind(found.warnings())
    title = case.get("title") if isinstance(case, Mapping) else None
    drawn = functools.partial(figures_of, found)
    return Probability(found.text(), found.json(), drawn, None if title is None else str(title))


def _check_shares(**shares: float) -> None:
    """Refuses what is no share."""
    for name, share in shares.items():
        if not _is_number(share) or not 0 < share < 1:
            raise StandfastError(f"{name} is {share!r}; expected a share, above zero and below 1")


def _given(records: Any, dt: Any, unit: str | None, over: str | None) -> list[Records]:
    """Records as the native module takes them."""
    if records is None:
        if dt is not None or unit is not None:
            raise TypeError(f"{'dt' if dt is not None else 'unit'} is that of records, which are not given")
        return []
    if over is None or over.partition("=")[0].strip() != "pga":
        raise TypeError("records are scaled to peaks; expected over='pga=0.2 g..1 g:9' beside them")
    if isinstance(records, Sequence) and not isinstance(records, str) and len(records) == 0:
        raise StandfastError("records is empty; expected one record or more, each an array or a dict of arrays")
    if isinstance(records, Mapping) or not isinstance(records, Sequence) or np.ndim(records[0]) == 0 and not isinstance(records[0], Mapping):
        raise TypeError(f"records is {said(records)}; expected a list of records, each an array or a dict of arrays")
    given = []
    for place, record in enumerate(records):
        step = dt
        if isinstance(record, Mapping) and "dt" in record:
            step, record = record["dt"], {name: values for name, values in record.items() if name != "dt"}
        given.append(records_of(record, step, unit, f"records[{place}]"))
        check_unit(given[-1], unit, True)
        if given[-1][0] is None:
            raise StandfastError(f"records[{place}] has nothing 'horizontal', whose peak is asked for")
    return given


def draws(
    case: str | os.PathLike[str] | Mapping[str, object], n: int, seed: int = _SEED, *, situation: str | None = None
) -> ArrowTable:
    """Draws of the random numbers of a case, with the mode under each.

    They are those of ``probability(case, method="monte-carlo", seed=seed)``; more of them begin with the same ones.

    Args:
        case: as for :func:`probability`.
        n: how many.
        seed: of all random numbers.
        situation: which loads act, as ``situation`` of :func:`probability`'s answers says it, where the case has several sets of them.

    Returns:
        A table with a column for each random number under its name in the case, in SI units, which ``metadata`` has; ``k_eff`` and
        ``k_prime_eff``, the point of the report's plane, null where the body is not the report's (eccentric, with added mass or two
        frictions) or nothing presses it on its base; and ``mode``, "BF" where the ground fails, null where no mode satisfies every law, or the numbers drawn do not go
        together; of bodies on joints "RE", or which leaves rest first, as "joint 2 slides". :class:`ArrowTable` says how it becomes one of pandas, polars or pyarrow.

    Raises:
        StandfastError: as :func:`probability`; and where the case has several sets of loads and none of them is named.

    >>> plane = {"point": {"gamma": 0.8, "k_prime": 0.9, "k": 0.5}, "random": {"mu": {"uniform": {"from": 0.4, "to": 0.6}}}}
    >>> found = draws(plane, 1000)
    >>> found.column_names
    ['mu', 'k_eff', 'k_prime_eff', 'mode']
    >>> bool(((found.mu.to_numpy() < 0.5) == (found.mode != "RE")).all())
    True
    """
    if situation is not None and not isinstance(situation, str):
        raise TypeError(f"situation is {situation!r}; expected the words of a situation")
    file = case_text(case)
    inputs, effective, modes, of_joints = _standfast.draws(file, situation, _whole(n, "n", 1), _whole(seed, "seed", 0))
    columns = [
        _standfast.make_array(name, values, None, None, {} if unit is None else {"unit": unit}) for name, unit, values in inputs
    ]
    said = ("|X|/V, the horizontal force over what presses the body on its base", "−M/(X H), the elevation of that force above the centre of mass in H")
    for name, values, words in zip(("k_eff", "k_prime_eff"), effective, said):
        missing = np.isnan(values)
        columns.append(_standfast.make_array(name, values, missing if missing.any() else None, None, {"description": words}))
    missing = modes == _NO_MODE
    names: list[str] = SYMBOLS.tolist() if of_joints is None else of_joints
    meaning = "the mode that begins" if of_joints is None else "RE where every joint rests, else which leaves rest first and how"
    columns.append(_standfast.make_array("mode", modes, missing if missing.any() else None, names, {"description": meaning}))
    return ArrowTable(_standfast.make_table(columns))


def _is_number(value: object) -> bool:
    return isinstance(value, (int, float, np.integer, np.floating)) and not isinstance(value, bool)


def _whole(value: Any, name: str, least: int) -> int:
    try:
        number = operator.index(value)
    except TypeError:
        number = least - 1
    if isinstance(value, (bool, np.bool_)) or not least <= number < 1 << 64:
        raise StandfastError(f"{name} is {value!r}; expected a whole number from {least}")
    return number
