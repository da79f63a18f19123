"""How likely a function of random numbers is below zero: a limit state that is the user's own."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

from . import _standfast
from ._advice import shown as said
from ._assess import case_text
from ._probability import _FLOOR, _PRECISION, _SAMPLES, _SEED, _Asked, _check_shares, _whole
from ._progress import shown
from ._standfast import StandfastError
from ._types import Progress


@dataclass(frozen=True)
class DesignPoint:
    """A nearest point at which a limit state is below zero, in standard normals.

    Attributes:
        beta: its distance from the medians; negative where the limit state is below zero at the medians, of the nearest point at which it is not.
        values: of each number.
        u: of each number its independent standard normal, in the order of the laws.
        alpha: u/beta, by how much each number contributes.
    """

    beta: float
    values: dict[str, float]
    u: dict[str, float]
    alpha: dict[str, float]


@dataclass(frozen=True)
class Reliability:
    """How likely a limit state is below zero: :func:`reliability`'s answer.

    Attributes:
        probability: that it is.
        low, high: the ends of its interval, 95 %, that of the computation.
        beta_generalized: −Φ⁻¹ of the probability.
        beta: that of FORM, the distance of the nearest point, whose Φ(−β) only approximates the probability; ``None`` if the limit state has one sign.
        design_points: the nearest points that were found, the nearest first.
        importance: α² of each number at the nearest point.
        probability_if_known: the probability if a number were known to have its median.
        method: by which it was found.
        given_up: whether an integration was begun, and given up for Sobol' points.
        points: how many there were, or evaluations of an integral, each with all roots along ``line``.
        precise: whether the interval is as narrow as asked.
        line: the number along which roots are found.
    """

    probability: float
    low: float
    high: float
    beta_generalized: float
    beta: float | None
    design_points: list[DesignPoint]
    importance: dict[str, float]
    probability_if_known: dict[str, float]
    method: str
    given_up: bool
    points: int
    precise: bool
    line: str

    def __str__(self) -> str:
        lines = [f"The limit state is below zero with the probability {self.probability:.4g} ({self.low:.4g} … {self.high:.4g})."]
        if self.beta is None:
            lines.append("No point was found at which its sign is another.")
        else:
            lines.append(f"That is a reliability index of {self.beta_generalized:.3f}; by FORM, which only approximates, β = {self.beta:.3f}.")
        if self.importance and self.probability_if_known:
            most = max(self.importance, key=lambda name: self.importance[name])
            known = self.probability_if_known[most]
            lines.append(f"It hangs most on {most}: were that known, the probability would be {known:.4g}.")
        if not self.precise:
            lines.append("It is not as precise as asked: more samples would narrow it.")
        return "\n".join(lines)


def reliability(
    limit_state: Callable[..., Any],
    laws: Mapping[str, Any],
    *,
    correlation: Sequence[Mapping[str, Any]] = (),
    method: Literal["integrate", "sobol", "importance", "monte-carlo"] | None = None,
    line: str | None = None,
    seed: int = _SEED,
    precision: float = _PRECISION,
    floor: float = _FLOOR,
    samples: int = _SAMPLES,
    progress: Progress = None,
) -> Reliability:
    """How likely is a function of random numbers below zero?

    The methods are those of :func:`probability`, for a limit state of your own: a published problem, or another structure. Along one number its roots are
    found, in 192 steps of that number's law, and nothing is drawn of it: rare events take no more points than frequent ones.

    Args:
        limit_state: a function of arrays by the names of ``laws``, all of one length, that gives as many numbers: below zero where what is asked for
            happens. It is called some hundred times or more, with up to some ten thousand values.
        laws: of each number its law, as a case file has it under ``[random]``, ``{"normal": {"mean": 0.6, "sd": 0.1}}``; or a frozen distribution of
            ``scipy.stats``.
        correlation: of pairs, or of several as a matrix, as a case file has it: ``[{"between": ["R", "S"], "rank": 0.3}]``.
        method: ``"integrate"`` (three numbers at most), ``"sobol"``, ``"importance"`` or ``"monte-carlo"``; the one that suits, if it is left out: an
            integral of two numbers, Sobol' points of more, about the nearest points where β is above 2.5.
        line: the number along which roots are found; that which matters most at the nearest point, if it is left out.
        seed, precision, floor, samples, progress: as for :func:`probability`.

    Raises:
        CaseError: for a law or a correlation that is not understood.
        StandfastError: for a limit state that is not a number somewhere, with the values there, and for other arguments.
        TypeError: for a limit state that gives no numbers, or not as many as it is given.
        Exception: what the limit state raises.

    The line below is two standard deviations from the medians, so that the probability is Φ(−2):

    >>> standard = {"normal": {"mean": 0, "sd": 1}}
    >>> found = reliability(lambda x, y: 10 - 3 * x - 4 * y, {"x": standard, "y": standard})
    >>> round(found.probability, 9), round(found.beta, 9)
    (0.022750132, 2.0)
    >>> {name: round(share, 6) for name, share in found.importance.items()}
    {'x': 0.36, 'y': 0.64}
    """
    if not callable(limit_state):
        raise TypeError(f"limit_state is {said(limit_state)}; expected a function of arrays")
    if not isinstance(laws, Mapping):
        raise TypeError(f"laws is {said(laws)}; expected a dict of a law for each number")
    for name in ("years", "records", "correlation"):
        if name in laws:
            raise StandfastError(f"a number is called {name!r}, which is a word of [random]; expected another name")
    if isinstance(correlation, (str, Mapping)) or not isinstance(correlation, Sequence):
        raise TypeError(f"correlation is {said(correlation)}; expected a list of dicts, as [{{'between': ['R', 'S'], 'rank': 0.3}}]")
    for option, text in (("method", method), ("line", line)):
        if text is not None and not isinstance(text, str):
            raise TypeError(f"{option} is {said(text)}; expected a name")
    _check_shares(precision=precision, floor=floor)
    _, text_of_laws = case_text({"random": {**laws, "correlation": list(correlation)} if correlation else dict(laws)})
    with shown(progress, None) as told:
        asked = _Asked(
            method, _whole(seed, "seed", 0), float(precision), float(floor), _whole(samples, "samples", 1), None, None, False, None, told
        )  # fmt: skip
        names, interval, generalized, (by, given_up), (points, precise), place, nearest, known = _standfast.reliability(
            limit_state, ("the laws", text_of_laws), line, asked
        )

    def named(values: Sequence[float]) -> dict[str, float]:
        return dict(zip(names, values))

    design_points = [DesignPoint(beta, named(values), named(u), named(alpha)) for beta, values, u, alpha in nearest]
    first = design_points[0] if design_points else None
    return Reliability(
        *interval,
        beta_generalized=generalized,
        beta=None if first is None else first.beta,
        design_points=design_points,
        importance={} if first is None else {name: alpha * alpha for name, alpha in first.alpha.items()},
        probability_if_known=named(known),
        method=by,
        given_up=given_up,
        points=points,
        precise=precise,
        line=names[place],
    )
