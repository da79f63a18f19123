"""Design: the least or greatest value of a quantity that meets a target, and the boundary of two quantities."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import Any, Literal, overload

import numpy as np
from numpy.typing import NDArray

from . import _standfast
from ._advice import is_plain
from ._answer import Rendered
from ._assess import case_text
from ._progress import shown
from ._ranges import ends_of
from ._types import Progress
from ._warnings import mind
from .designs import BoundaryDocument, DesignDocument, MinimumDocument


class Design(DesignDocument, Rendered):
    """The least or greatest value that meets a target: :func:`design`'s answer.

    ``print`` shows the text of ``standfast design``; the keys of its JSON document, which ``docs/design.schema.json`` describes,
    are attributes.
    """

    _what = "this design"

    @property
    def value(self) -> float:
        """The value found, in :attr:`unit`: rounded to the safe side, and assessed so."""
        return self.found.value

    def __repr__(self) -> str:
        return f"<Design {self.wanted} {self.vary} for {self.target}: {self.found.printed}>"


class Boundary(BoundaryDocument, Rendered):
    """The boundary of what meets a target with two quantities: :func:`design`'s answer with ``and_``.

    ``print`` shows the text of ``standfast design --and``; the keys of its JSON document, which ``docs/boundary.schema.json``
    describes, are attributes, ``and`` as ``and_``. A notebook shows the picture.
    """

    _what = "this boundary"
    _csv: str
    _svg: str | None

    def __init__(self, text: str, document: str, csv: str, svg: str | None) -> None:
        super().__init__(text, document)
        vars(self).update(_csv=csv, _svg=svg)

    @property
    def csv(self) -> str:
        """The boundary as a table in CSV: a row for each stretch of values that meets the target."""
        return self._csv

    @property
    def svg(self) -> str | None:
        """The boundary as an SVG document; ``None`` where the target is met, or not, throughout what was searched."""
        return self._svg

    @property
    def at(self) -> NDArray[np.float64]:
        """The values of the other quantity, rising, in ``and_.unit``."""
        return np.array([column.value for column in self.columns], dtype=np.float64)

    @property
    def value(self) -> NDArray[np.float64]:
        """The least or greatest value that meets the target at each of :attr:`at`, in ``vary.unit``: rounded to the safe side, and
        assessed so. NaN where no value does; ``columns`` has all stretches of values."""
        greatest = self.wanted == "greatest"
        ends = (column.met[-1].to if greatest else column.met[0].from_ for column in self.columns if column.met)
        rounded = iter([end.value for end in ends])
        return np.array([next(rounded) if column.met else np.nan for column in self.columns], dtype=np.float64)

    def __repr__(self) -> str:
        return f"<Boundary {self.wanted} {self.vary.name} over {self.and_.name} for {self.target}: {len(self.columns)} columns>"

    def _repr_svg_(self) -> str | None:
        return self.svg

    def __reduce__(self) -> tuple[Any, ...]:
        return Boundary, (self._text, self._json, self.csv, self.svg)


class Minimum(MinimumDocument, Rendered):
    """The least cost with which several quantities meet a target: :func:`design`'s answer with ``minimise``.

    ``print`` shows the text of ``standfast design --minimise``; the keys of its JSON document, which ``docs/minimum.schema.json``
    describes, are attributes.
    """

    _what = "this minimum"

    @property
    def value(self) -> dict[str, float]:
        """The values found under their names, in SI units: as they are printed, and assessed so."""
        return {quantity.vary: quantity.value for quantity in self.quantities}

    def __repr__(self) -> str:
        values = ", ".join(f"{quantity.vary} {quantity.printed}" for quantity in self.quantities)
        return f"<Minimum {self.minimise} for {self.target}: {self.cost:.4g} with {values}>"


Case = str | os.PathLike[str] | Mapping[str, object]


@overload
def design(
    case: Case,
    *,
    vary: str,
    target: str | None = None,
    greatest: bool = False,
    lower: float | str | None = None,
    upper: float | str | None = None,
    progress: Progress = None,
) -> Design: ...
@overload
def design(
    case: Case,
    *,
    vary: str | Sequence[str],
    minimise: Literal["volume", "mass"],
    target: str | None = None,
    progress: Progress = None,
) -> Minimum: ...
@overload
def design(
    case: Case,
    *,
    vary: str,
    target: str | None = None,
    greatest: bool = False,
    lower: float | str | None = None,
    upper: float | str | None = None,
    and_: str,
    and_lower: float | str | None = None,
    and_upper: float | str | None = None,
    progress: Progress = None,
) -> Boundary: ...
def design(
    case: Case,
    *,
    vary: str | Sequence[str],
    minimise: Literal["volume", "mass"] | None = None,
    target: str | None = None,
    greatest: bool = False,
    lower: float | str | None = None,
    upper: float | str | None = None,
    and_: str | None = None,
    and_lower: float | str | None = None,
    and_upper: float | str | None = None,
    progress: Progress = None,
) -> Design | Boundary | Minimum:
    """Find the least, or greatest, value of a quantity that meets a target in every situation of a case.

    The value is rounded to the safe side and assessed as it is printed; one more or less in its last digit fails.

    Args:
        case: the path of a case file, or a dict with the same keys, as in :func:`assess`.
        vary: the quantity: ``"width"``, ``"height"``, ``"mass"``, ``"friction"``, ``"water_level"``, ``"crest_height"``, or any
            number of the case by table and key, as ``"wave.period"`` or ``"load[2].force"``; with where to look behind it, in place of
            ``lower`` and ``upper``, as ``"width=10 m..20 m"``.
        minimise: ``"volume"`` or ``"mass"``: the least of it with two or three quantities, each with its range behind it if it is to be looked
            for elsewhere than from half to twice the present value; ``vary`` is then a list, as ``["width=10 m..20 m", "height"]``.
        target: ``"rest"``, ``"factor=1.2"`` (both safety factors), ``"no-rock"``, ``"no-slide"``, ``"criteria"`` of the case,
            ``"utilisation=0.9"`` of them, or one criterion, as ``"bearing_max=300kPa"`` or ``"load_factor=1.2"``. Without one the criteria
            of the case; without any that it rests, in time that it does not overturn.
        greatest: the greatest value that meets the target in place of the least.
        lower, upper: where to look, a number in SI units or a text with a unit, as the case file has the quantity; a fifth and
            five times the present value if not given.
        and_: another quantity, with its range behind it in place of ``and_lower`` and ``and_upper``, as ``"friction=0.5..0.7"``: the
            answer for each of many values of it, as a curve. How many is the curve's own choice.
        and_lower, and_upper: its range; half and twice the present value if not given.
        progress: ``True`` for a bar (with ``standfast[progress]``), or a function of the parts done and all parts, thousandths of the work.
            A target that asks for a chance or a motion, and a curve, may take minutes.

    Ctrl-C ends the call at once.

    Returns:
        A :class:`Design`; with ``and_`` a :class:`Boundary`, with ``minimise`` a :class:`Minimum`.

    Raises:
        NoSolution: where no value meets the target, or it is met without an end on the side that is wanted. The message says what to do.
        CaseError: for a case that is not understood.
        StandfastError: for a quantity or a target that is not understood; the others are `StandfastError` as well, and all of them `ValueError`.
        OSError: if the case file cannot be read.

    >>> goda = design("examples/goda-2000.toml", vary="width", target="factor=1.2")
    >>> goda
    <Design least width for factor=1.2: 15.46 m>
    >>> goda.value, goda.unit, goda.binding
    (15.46, 'm', "at 15.45 m, the factor of the body against sliding is less than 1.2: μ(W' − U)/P ≥ 1.2 fails")
    >>> by_friction = design(
    ...     "examples/goda-2000.toml", vary="width", target="factor=1.2", and_="friction", and_lower=0.5, and_upper=0.7
    ... )
    >>> dict(zip(by_friction.at.tolist(), by_friction.value.tolist()))[0.6]
    15.46
    """
    if minimise is not None:
        others = {"greatest": greatest, "lower": lower, "upper": upper, "and_": and_, "and_lower": and_lower, "and_upper": and_upper}
        return _minimum(case, vary, minimise, target, progress, others)
    for name, text in (("vary", vary), ("target", target), ("and_", and_)):
        if not isinstance(text, str) and not (text is None and name != "vary"):
            raise TypeError(f"{name} is {text!r}; expected a text")
    if not isinstance(greatest, (bool, np.bool_)):
        raise TypeError(f"greatest is {greatest!r}; expected True or False")
    assert isinstance(vary, str)
    file = case_text(case)
    vary, ends = ends_of(vary, "vary", _end(lower, "lower"), _end(upper, "upper"))
    and_ends = _end(and_lower, "and_lower"), _end(and_upper, "and_upper")
    if and_ is not None:
        and_, and_ends = ends_of(and_, "and_", *and_ends)
    elif and_ends != (None, None):
        raise TypeError("and_lower and and_upper are ends of the range of and_, which is not given")
    wanted = target, bool(greatest)
    with shown(progress, None) as told:
        if and_ is None:
            text, document, slips = _standfast.design(file, vary, wanted, ends, told)
            mind(slips)
            return Design(text, document)
        return Boundary(*_standfast.boundary(file, vary, wanted, ends, (and_, and_ends), told))


def _minimum(
    case: Case, vary: str | Sequence[str], minimise: str, target: str | None, progress: Progress, others: Mapping[str, object]
) -> Minimum:
    """The least of ``minimise``; ``others`` are arguments that have no meaning beside it."""
    given = [name for name, value in others.items() if value not in (None, False)]
    if given:
        raise TypeError(f"{' and '.join(given)} beside minimise; expected ranges behind the names in vary, as 'width=10 m..20 m'")
    names = [vary] if isinstance(vary, str) else list(vary)
    for name, text in (("target", target), ("minimise", minimise), *(("vary", one) for one in names)):
        if not isinstance(text, str) and not (text is None and name == "target"):
            raise TypeError(f"{name} is {text!r}; expected a text")
    ranges = [ends_of(name, "vary", None, None) for name in names]
    quantities = [(name, lower or "", upper or "") for name, (lower, upper) in ranges]
    with shown(progress, None) as told:
        text, document, slips = _standfast.minimum(case_text(case), quantities, target, minimise, told)
        mind(slips)
        return Minimum(text, document)


def _end(value: Any, name: str) -> str | None:
    """An end of a range as the case file would have it."""
    if isinstance(value, str) and is_plain(value):
        raise TypeError(f"{name} is {value!r}, a text without a unit; expected a number in SI units, or a text with its unit")
    if value is None or isinstance(value, str):
        return value
    if isinstance(value, (int, float, np.integer, np.floating)) and not isinstance(value, bool):
        return repr(float(value))
    raise TypeError(f"{name} is {value!r}; expected a number in SI units, or a text with a unit")
