"""Motions in time: what becomes of a body under waves and earthquakes."""

from __future__ import annotations

import base64
import functools
import html
import json
import os
import warnings
from collections.abc import Mapping
from typing import Any, Literal, NamedTuple

import numpy as np

from . import _standfast
from ._answer import Lazy, with_infinity
from ._arrow import ArrowTable
from ._assess import case_text
from ._figure import Figure, figures_of
from ._modes import SYMBOLS
from ._progress import shown
from ._records import Records, check_unit, positive, records_of
from ._run import Told
from ._standfast import StandfastError
from ._types import Array, Progress
from ._warnings import mind
from .simulations import MotionDocument


class _Given(NamedTuple):
    """What a motion is asked of."""

    name: str
    text: str
    #: Where the files lie that the case names, and those that have been read.
    folder: str
    files: dict[str, str]
    base: Records
    unit: str | None
    strength: bool | None
    all: bool
    copies: tuple[int | None, float | list[tuple[str, float]] | None, int | None]


class Simulation(Lazy, MotionDocument):
    """What becomes of a body in time: :func:`simulate`'s answer.

    ``print`` shows the text of ``standfast simulate``; the keys of its JSON document, which ``docs/simulate.schema.json``
    describes, are attributes. Of a case whose loads are alternatives it is the answer to the worst, and ``others`` has the others.
    Units are SI, those of a ``[block]`` its own. :meth:`series` is the motion itself.

    A pickle holds the case and the records that it names, and is answered anew where it is loaded.
    """

    _what = "this simulation"
    _given: _Given
    _answer: _standfast.MotionAnswer

    def __init__(self, *given: Any, told: Told | None = None) -> None:
        asked = _Given(*given)
        case = asked.name, asked.text, asked.folder, asked.files
        found = _standfast.simulate(case, asked.base, (asked.strength, asked.all), asked.copies, told)
        check_unit(asked.base, asked.unit, found.is_si())
        vars(self).update(_given=asked._replace(files=found.files()), _answer=found)

    @functools.cached_property
    def _document(self) -> dict[str, Any]:  # type: ignore[override]
        document: dict[str, Any] = json.loads(self._answer.json(), object_hook=with_infinity)
        return document

    @functools.cached_property
    def figures(self) -> list[Figure]:
        """The figures: histories, positions, and the motion in real time, which a browser shows moving. The item ``"figures"`` names the
        files of the program's, and is empty here."""
        return figures_of(self._answer)

    def _repr_svg_(self) -> str | None:
        return self.figures[0].svg if self.figures else None

    def _repr_html_(self) -> str:
        """Histories, and the motion itself in real time. It is a picture of its own in the page: its names clash with none, and it plays
        where scripts are not trusted."""
        shown = [figure for figure in self.figures if figure.title in ("Histories", "Animation")]
        pictures = ((base64.b64encode(figure.svg.encode()).decode("ascii"), html.escape(figure.title)) for figure in shown)
        images = "".join(
            f'<img src="data:image/svg+xml;base64,{picture}" alt="{title}" style="max-width: 48%; vertical-align: top"/>' for picture, title in pictures
        )
        return f"<div><p>{html.escape(repr(self)[1:-1])}</p>{images}</div>"

    def series(self, dt: float, *, events: bool = False, situation: int = 0) -> ArrowTable:
        """The motion at even steps of time, from its beginning to its end.

        Args:
            dt: the step, in seconds, or in the units of a ``[block]``.
            events: if true, there are two rows more at each event, just before and just after it, and a column ``side`` of −1 and 1 that
                tells them.
            situation: 0 for this answer, 1 for the first of ``others``, and so on.

        Returns:
            A table with the columns ``t``, ``slide``, ``x`` and ``y`` (of the centre of mass), ``theta``, ``omega`` and ``state``, words of
            :class:`Mode`; velocities and accelerations ``vx``, ``vy``, ``ax``, ``ay``, ``alpha``; reactions ``N_O``, ``T_O``, ``N_O'``, ``T_O'``
            at the corners (none of friction that both share) and ``T`` of both; ``slide_O``, ``slide_O'``, ``gap_O``, ``gap_O'``; the loads ``X``, ``P``, ``M``
            about the centre of mass, the base's ``a_h`` and ``a_v``; and energies per mass, ``K``, ``potential``, ``work``,
            ``friction_loss`` and ``impact_loss`` so far. Of each point of ``[motion.points]`` there are ``a_x.NAME``, ``a_y.NAME``, absolute
            accelerations, and ``f_along.NAME``, ``f_up.NAME``, what an instrument there feels. ``series.theta.to_numpy()`` and ``numpy.asarray(series.theta)`` are arrays, ``polars.DataFrame(series)``,
            ``pyarrow.table(series)`` and ``pandas.DataFrame(series.to_dict())`` tables; ``series.theta.metadata`` has unit and words.

        Raises:
            StandfastError: for a step that is not above zero, or so short that there would be 10⁹ rows.
            IndexError: if there is no such situation.
        """
        step = positive(dt, "dt")
        if not isinstance(events, bool):
            raise TypeError(f"events is {events!r}; expected True or False")
        if not 0 <= situation <= len(self.others):
            raise IndexError(f"situation is {situation}; expected 0 to {len(self.others)}")
        columns, place, states = self._answer.series(situation, step, events)
        units = self._answer.is_si()
        made = []
        for name, unit, words, values in columns:
            metadata = {"description": words} | ({"unit": unit} if units else {})
            missing = np.isnan(values)
            made.append(_standfast.make_array(name, values, missing if missing.any() else None, None, metadata))
        made.insert(place, _standfast.make_array("state", states, None, SYMBOLS.tolist(), {"description": "state of motion"}))
        return ArrowTable(_standfast.make_table(made))

    def __repr__(self) -> str:
        ends = {
            "rest": "comes to rest", "overturned": "overturns", "time": "still moves at the end", "no-continuation": "stopped: no state goes on",
            "too-many-events": "stopped: too many events",
        }  # fmt: skip
        end = "stays at rest" if self.end == "rest" and len(self.events) <= 2 and self.max_slide == self.max_theta == 0 else ends[self.end]
        metres = " m" if self._answer.is_si() else ""
        slips = dict.fromkeys(warning.name for warning in self.warnings)
        minded = f"; warnings: {', '.join(slips)}" if slips else ""
        others = f"; {len(self.others)} other situations" if len(self.others) > 1 else "; 1 other situation" if self.others else ""
        of = self.title or "of a case"
        return f"<Simulation {of}: {end}; slide {self.slide:.4g}{metres}, max |θ| {self.max_theta:.4g} rad{others}{minded}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return Simulation, tuple(self._given)


def simulate(
    case: str | os.PathLike[str] | Mapping[str, object],
    *,
    base: Array | Mapping[Literal["horizontal", "vertical"], Array] | None = None,
    dt: float | Array | None = None,
    unit: Literal["m/s2", "g", "cm/s2"] | None = None,
    strength: bool | None = None,
    all: bool = False,
    copies: int | None = None,
    spread: float | Mapping[str, float] | None = None,
    seed: int | None = None,
    sensitivity: bool = False,
    progress: Progress = None,
) -> Simulation:
    """Follows the motion of a body in time: from rest through sliding, rocking, impacts and flight to its end.

    Args:
        case: the path of a case file, or a dict with the same keys: a case as for :func:`assess` whose variable loads have a
            ``history``, or whose base moves (``[motion.base]``); or a ``[block]``. Records that a file names lie beside it, those of a dict
            in the working directory.
        base: accelerations of the base in place of those of the case: an array, to the right, or a dict of arrays under
            ``"horizontal"`` and ``"vertical"``, upwards, at the same times. Lines join the values; before and after them there is none.
        dt: the step of time between the values of ``base``, in seconds, or their times. Left out, a Series of pandas has them in its index
            and a DataArray of xarray along its dimension, as seconds, time deltas or dates; where it has them, ``dt`` may not say others.
        unit: that of the values in ``base``; of a ``[block]``, which has none, it is left out. An attribute ``units`` of a DataArray
            has to be the same.
        strength: whether to follow it under stronger and weaker loads, some fifty motions, for ``strength``: which change its verdict;
            left to itself where no record is as long as 20,000 points. False where many motions are followed one by one.
        all: whether the text lists every event, of more than 24 too.
        copies: so many copies are followed whose numbers differ a little, for ``copies``: which share of them overturns, quantiles, and
            when they part from the case; left out, as many as ``[motion.copies]`` says.
        spread: by how much the numbers of copies scatter, as a share of each, 0 to 1: 0.001 where nothing says so; or names with such
            shares, ``{"friction": 0.1}``, and all other numbers stay.
        seed: the seed of the copies; the first forty of four hundred are the forty. 1 where nothing says so.
        sensitivity: changes nothing: ``divergence``, of which ``sensitivity`` has the value, is always there.
        progress: ``True`` for a bar (with ``standfast[progress]``), or a function of the parts done and all parts, thousandths of the work.

    Ctrl-C ends the call at once.

    Raises:
        StandfastError: for a case that is not understood, a record that is none, and values that no motion has; the message shows where,
            and what is expected.
        TypeError: for what is not an array of numbers.
        OSError: if the case file cannot be read.

    Warns:
        StandfastWarning: for each of the answer's ``warnings``, once from one line.

    >>> caisson = simulate("examples/motion/caisson-breaking-wave.toml")
    >>> round(caisson.slide, 4), caisson.overturned, [event.state.symbol for event in caisson.events]
    (-0.0847, False, ['RE', 'SL', 'RE', 'RE'])
    >>> thrown = {"block": {"b1": 1, "b2": 1, "d": 0.2, "mu_s": 0.3, "gravity": 1}, "motion": {"initial": {"vx": 0.4}}}
    >>> copies = simulate(thrown, copies=40).copies
    >>> copies.overturned, round(copies.share.high, 3), [round(one.value, 3) for one in copies.slide]
    (0, 0.088, [0.266, 0.267, 0.267, 0.267, 0.267])
    >>> block = {"block": {"b1": 1, "b2": 1, "d": 3, "mu_s": 0.4, "gravity": 1}}
    >>> pulse = simulate(block, base=[0.6, 0.6], dt=1)
    >>> pulse.events[0].state.symbol, pulse.end
    ('RO', 'rest')
    >>> pulse.series(0.5).theta.to_numpy()[:2].round(4)
    array([0.    , 0.0075])
    """
    if not isinstance(all, (bool, np.bool_)):
        raise TypeError(f"all is {all!r}; expected True or False")
    if not (strength is None or isinstance(strength, (bool, np.bool_))):
        raise TypeError(f"strength is {strength!r}; expected True, False or None")
    if sensitivity:
        warnings.warn("sensitivity changes nothing; the divergence of a motion is always there", DeprecationWarning, stacklevel=2)
    records = records_of(base, dt, unit)
    copied = copies_of(copies, spread, seed)
    given: tuple[Any, ...] = *case_text(case), folder_of(case), {}, records, unit, None if strength is None else bool(strength), bool(all), copied
    with shown(progress, None) as told:
        found = Simulation(*given, told=told)
    mind(found._answer.warnings())
    return found


def copies_of(
    copies: int | None, spread: float | Mapping[str, float] | None, seed: int | None
) -> tuple[int | None, float | list[tuple[str, float]] | None, int | None]:
    """What is asked of copies: number, spread and seed."""

    def whole(value: object) -> bool:
        return isinstance(value, (int, np.integer)) and not isinstance(value, bool)

    def share(value: object) -> float:
        number = float(value) if isinstance(value, (int, float, np.integer, np.floating)) and not isinstance(value, bool) else np.nan
        if not 0 <= number <= 1:
            raise StandfastError(f"spread is {spread!r}; expected a share from 0 to 1, or names with such shares")
        return number

    if not (copies is None or whole(copies) and 1 <= copies <= 1_000_000):
        raise StandfastError(f"copies is {copies!r}; expected a whole number from 1 to 1000000")
    shares: float | list[tuple[str, float]] | None
    if isinstance(spread, Mapping) and not spread:
        raise StandfastError("spread is empty; expected one name with a share at least")
    if isinstance(spread, Mapping):
        shares = [(str(name), share(value)) for name, value in spread.items()]
    else:
        shares = None if spread is None else share(spread)
    if not (seed is None or whole(seed) and 0 <= seed < 1 << 64):
        raise StandfastError(f"seed is {seed!r}; expected a whole number, not below 0")
    return None if copies is None else int(copies), shares, None if seed is None else int(seed)


def folder_of(case: str | os.PathLike[str] | Mapping[str, object]) -> str:
    """Where the files lie that a case names."""
    return "" if isinstance(case, Mapping) else os.path.dirname(os.fspath(case))
