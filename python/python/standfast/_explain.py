"""One point explained: every step of the decision, the motion, and where the mode changes."""

from __future__ import annotations

from . import _standfast
from ._answer import Rendered, part
from ._rows import point
from ._run import is_right
from ._types import Number, Side
from .answers import Motion, Point


class Explanation(Point, Rendered):
    """Why a mode begins: :func:`explain`'s answer.

    ``print`` shows the text of ``standfast classify --explain``; the keys of its JSON document, which
    ``docs/point.schema.json`` describes, are attributes. ``trace`` has the modes in the order in which they are tried, each with
    its inequalities; the last one begins.
    """

    _what = "this explanation"

    @property
    def schema(self) -> int:
        """The version of the document."""
        version: int = self["schema"]
        return version

    @property
    def SF_sliding(self) -> float:
        """Safety factor against sliding, μ/k; ``inf`` at k = 0."""
        factor: float = self["SF_sliding"]
        return factor

    @property
    def SF_overturning(self) -> float:
        """Safety factor against overturning, 1/(k γ |1+k'|); ``inf`` where the force has no moment about the corner."""
        factor: float = self["SF_overturning"]
        return factor

    @property
    def case(self) -> str | None:  # type: ignore[override]
        """The report's case, by the elevation of the force; ``None`` on a base that crushes."""
        case: str | None = self["case"]
        return case

    @property
    def motion(self) -> Motion | None:  # type: ignore[override]
        """The motion in that mode, in g, g/B, m g and B; ``None`` where the ground fails."""
        return None if self["motion"] is None else part(Motion, self["motion"])

    @property
    def ground(self) -> dict[str, float | None] | None:
        """Where a base that crushes bears, in B: ``omega``; ``pivot``, how far inside its edge the reaction of a body acts that turns, or is
        about to; ``neutral``, the distance of the neutral point from the edge about which the body turns; ``effective_width``. ``None``
        on a rigid base."""
        base: dict[str, float | None] | None = self["ground"] if "ground" in self else None
        return None if base is None else dict(base)

    def __repr__(self) -> str:
        steps = self.trace
        deciding = ", ".join(f"({relation.equation}) {relation.statement}" for relation in steps[-1].relations) if steps else "ω ≥ 1"
        return f"<Explanation {self.mode.symbol}: {deciding}>"


def explain(
    gamma: Number, k_prime: Number, k: Number, mu: Number, *, omega: Number = 0, to: Side = "left"
) -> Explanation:
    """Why does this mode begin, with what motion, and at which force and friction would it be another?

    Args:
        gamma, k_prime, k, mu: as in :func:`classify`, four numbers.
        omega: share of a base that crushes, as in :func:`classify`; ``ground`` says where it bears, and ``motion`` is ``None`` where
            it fails.
        to: where the force points. For one to the right, the inequalities are those of the same force to the left; modes and
            motions are mirrored.

    Raises:
        StandfastError: for a value that no body, force or friction can have.
        TypeError: for what is not a plain number.

    >>> why = explain(0.8, 0.9167, 0.7281, 0.6)
    >>> why
    <Explanation SRO-: (3.35) μ > 1/γ − k k', (3.40) μ < (a k + b)/(c k + d)>
    >>> [(step.mode.symbol, step.holds) for step in why.trace]
    [('RE', False), ('SL', False), ('RO', False), ('SRO-', True)]
    >>> first = why.trace[0].relations[0]
    >>> first.equation, first.statement, first.holds, round(first.margin, 4)
    ('3.4', 'μ ≥ k', False, -0.1281)
    >>> [(round(change.at, 4), change.to.symbol) for change in why.along_mu]
    [(0.5826, 'SRO-'), (0.6508, 'RO')]
    >>> str(why).splitlines()[0]
    'The body slides and rocks about O, the bottom left corner, which moves to the left'
    """
    names = ("gamma", "k_prime", "k", "mu", "omega")
    g, height, force, friction, share = point("explain", names, (gamma, k_prime, k, mu, omega))
    return Explanation(*_standfast.explain(g, height, force, friction, share, is_right(to)))
