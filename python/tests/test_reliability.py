"""Limit states of the user's own, and distributions of scipy as laws: against closed forms and quadrature."""

import math

import numpy as np
import pytest
import standfast
from standfast import CaseError, StandfastError, reliability

stats = pytest.importorskip("scipy.stats")
integrate = pytest.importorskip("scipy.integrate")

STANDARD = {"normal": {"mean": 0, "sd": 1}}


def test_a_parabola_has_all_digits() -> None:
    found = reliability(lambda x, y: 2.5 - (x + y) / math.sqrt(2) + 0.1 * (x - y) ** 2, {"x": STANDARD, "y": stats.norm()})
    exact, _ = integrate.quad(lambda v: stats.norm.pdf(v) * stats.norm.sf(2.5 + 0.2 * v * v), -12, 12, epsabs=0)
    assert found.probability == pytest.approx(exact, rel=1e-9)
    assert found.method == "integrate" and found.precise and not found.given_up
    assert found.beta == pytest.approx(2.5, abs=1e-9)
    assert found.beta_generalized == pytest.approx(stats.norm.isf(exact), abs=1e-8)
    assert str(found).startswith("The limit state is below zero with the probability 0.004207")


def test_six_lognormals_against_plain_draws() -> None:
    def law(mean: float, sd: float) -> dict[str, object]:
        return {"lognormal": {"mean": mean, "sd": sd}}

    def limit(**x: np.ndarray) -> np.ndarray:
        return x["a"] + 2 * x["b"] + 2 * x["c"] + x["d"] - 5 * x["e"] - 5 * x["f"]

    laws = {name: law(120, 12) for name in "abcd"} | {"e": law(50, 15), "f": law(40, 12)}
    found = reliability(limit, laws, precision=0.01)
    random, count = np.random.default_rng(1), 1_000_000

    def drawn(mean: float, sd: float) -> np.ndarray:
        spread = math.sqrt(math.log1p((sd / mean) ** 2))
        return mean * np.exp(-0.5 * spread**2 + spread * random.standard_normal(count))

    share = (limit(**{name: drawn(*law["lognormal"].values()) for name, law in laws.items()}) < 0).mean()
    assert abs(found.probability - share) < 4 * math.sqrt(share / count) + 0.01 * share
    assert found.method == "sobol"
    # The same numbers again, whichever points they are of.
    assert reliability(limit, laws, precision=0.01) == found
    far = reliability(lambda **x: limit(**x) + 200, laws)
    assert far.method == "importance" and far.low <= far.probability <= far.high < 1e-3


def test_correlated_numbers_and_design_points() -> None:
    laws = {"r": stats.norm(10, 1), "s": {"normal": {"mean": 6, "sd": 1.5}}}
    matrix = [{"between": ["r", "s"], "normal": [[1, 0.5], [0.5, 1]]}]
    found = reliability(lambda r, s: r - s, laws, correlation=matrix)
    beta = 4 / math.sqrt(1 + 2.25 - 2 * 0.5 * 1.5)
    assert found.probability == pytest.approx(stats.norm.sf(beta), rel=1e-9)
    point = found.design_points[0]
    assert point.beta == pytest.approx(beta, abs=1e-8)
    assert point.values["r"] == pytest.approx(point.values["s"], abs=1e-6)
    assert sum(found.importance.values()) == pytest.approx(1)
    assert found.importance["s"] == pytest.approx(point.alpha["s"] ** 2)
    # r at its median, of s what is left.
    assert found.probability_if_known["r"] == pytest.approx(stats.norm.sf(4 / (1.5 * math.sqrt(0.75))), rel=1e-6)
    for line in ("r", "s"):
        for method in ("integrate", "sobol", "importance", "monte-carlo"):
            other = reliability(lambda r, s: r - s, laws, correlation=matrix, line=line, method=method)
            assert other.line == line and other.method == method
            assert abs(other.probability - found.probability) <= 2 * (other.high - other.low) + 1e-12


def test_one_sign_everywhere() -> None:
    found = reliability(lambda x: np.ones_like(x), {"x": STANDARD})
    assert (found.probability, found.beta, found.design_points, found.importance) == (0, None, [], {})
    assert "No point was found" in str(found)
    assert reliability(lambda x: 1.0, {"x": STANDARD}).probability == 0


def test_what_is_raised_is_heard() -> None:
    def broken(x: np.ndarray) -> np.ndarray:
        raise ZeroDivisionError("mine")

    with pytest.raises(ZeroDivisionError, match="mine"):
        reliability(broken, {"x": STANDARD})
    with pytest.raises(TypeError, match="unexpected keyword argument 'x'"):
        reliability(lambda y: y, {"x": STANDARD})
    with pytest.raises(TypeError, match="limit_state gave a str; expected an array of as many numbers as it is given"):
        reliability(lambda x: "no", {"x": STANDARD})
    with pytest.raises(TypeError, match="limit_state gave 3 numbers; expected as many as it is given"):
        reliability(lambda x: x[:3], {"x": STANDARD})
    with pytest.raises(TypeError, match="limit_state is 3, an int; expected a function of arrays|limit_state is 3"):
        reliability(3, {"x": STANDARD})  # type: ignore[arg-type]
    with np.errstate(invalid="ignore"):
        with pytest.raises(StandfastError, match="not a number with a probability of 5.000e-1, as at"):
            reliability(lambda x: 1 - np.sqrt(x), {"x": STANDARD})


@pytest.mark.parametrize(
    ("laws", "options", "error"),
    [
        ({"x": {"normal": {"sd": 1}}}, {}, "the law normal of `x` lacks `mean`"),
        ({}, {}, "names no number that is random"),
        ({"x": 3}, {}, "`x` is a number; expected a law in braces"),
        ({"x": STANDARD}, {"line": "z"}, 'line is "z"; expected one of x'),
        ({"x": STANDARD}, {"method": "form"}, "no method is called `form`"),
        ({"x": STANDARD}, {"precision": 2}, "precision is 2; expected a share"),
        ({"years": STANDARD}, {}, "a number is called 'years', which is a word of"),
        ({"x": STANDARD, "y": STANDARD}, {"correlation": [{"between": ["x", "z"], "rank": 0.1}]}, "has no `z`; expected x, y"),
        ({"x": stats.norm([1, 2])}, {}, "random.x is a distribution with an array of parameters"),
        ({name: STANDARD for name in "xyzw"}, {"method": "integrate"}, "integrate takes 3 random numbers at most, of 4"),
    ],
)
def test_wrong_arguments_are_refused(laws: dict[str, object], options: dict[str, object], error: str) -> None:
    with pytest.raises((CaseError, StandfastError), match=error):
        reliability(lambda **x: sum(x.values()) + 3, laws, **options)  # type: ignore[arg-type]


#: Distributions with a law of their own here, and others, which are tabulated.
NAMED = [
    stats.norm(0.4, 0.05), stats.lognorm(0.3, scale=0.3), stats.gumbel_r(0.3, 0.05), stats.weibull_min(1.4, 0.1, 0.2),
    stats.genextreme(-0.1, 0.3, 0.05), stats.uniform(0.1, 0.6), stats.triang(0.3, 0.1, 0.7), stats.beta(2, 3, loc=0.1, scale=0.8),
    stats.gamma(3, scale=0.1), stats.expon(0.1, 0.1), stats.genpareto(0.1, 0.1, 0.1), stats.truncnorm(-2, 2, 0.4, 0.1),
]  # fmt: skip
TABULATED = [stats.invgauss(0.5, scale=0.4), stats.rice(1.2, scale=0.2), stats.lognorm(0.3, loc=0.05, scale=0.3)]
DISCRETE = [stats.randint(0, 2), stats.binom(3, 0.2), stats.poisson(0.5)]


@pytest.mark.parametrize("law", NAMED + TABULATED + DISCRETE, ids=lambda law: law.dist.name)
def test_distributions_of_scipy_are_laws(law: object) -> None:
    """A body that slides where k is above 0.5: what does not rest is the survival function there."""
    plane = {"point": {"gamma": 0.5, "k_prime": 0, "mu": 0.5}, "random": {"k": law}}
    found = standfast.probability(plane).not_rest.probability
    assert found == pytest.approx(law.sf(0.5), rel=1e-6 if law in TABULATED else 1e-12)  # type: ignore[attr-defined]


def test_distributions_in_a_mixture_and_of_the_newer_kind() -> None:
    parts = [{"probability": 0.9, "normal": {"mean": 0.3, "sd": 0.04}}, {"probability": 0.1, "uniform": {"from": 0.4, "to": 0.8}}]
    plane = {"point": {"gamma": 0.5, "k_prime": 0, "mu": 0.5}, "random": {"k": {"mixture": parts}}}
    expected = 0.9 * stats.norm(0.3, 0.04).sf(0.5) + 0.1 * 0.75
    assert standfast.probability(plane).not_rest.probability == pytest.approx(expected, rel=1e-12)
    if hasattr(stats, "Normal"):
        plane["random"] = {"k": stats.Normal(mu=0.4, sigma=0.04)}
        assert standfast.probability(plane).not_rest.probability == pytest.approx(stats.norm.sf(2.5), rel=1e-9)


def test_a_law_that_is_fitted_and_one_that_is_given() -> None:
    # The function is of the numbers of the table alone; the parameters that a fit leaves uncertain are none of its arguments.
    heights = [4.1, 5.2, 3.8, 4.6, 6.0, 4.4, 3.9, 5.5, 4.9, 4.2]
    laws = {"h": {"fitted": {"law": "gumbel", "values": heights}}, "r": {"normal": {"mean": 9, "sd": 0.5}}}
    found = reliability(lambda h, r: r - h, laws, precision=0.01)
    assert set(found.importance) == {"h", "r", "h.mode", "h.scale"}
    # scipy's likeliest law, and its parameters' covariance by second derivatives, are those of the tests of fits.
    random, count = np.random.default_rng(3), 2_000_000
    z, w = random.standard_normal((2, count))
    mode = 4.336518944839044 + 0.17979813 * z
    scale = 0.5402006084562867 * np.exp(0.25879764 * (0.3119415690501845 * z + math.sqrt(1 - 0.3119415690501845**2) * w))
    r = 9 + 0.5 * random.standard_normal(count)
    exceeded = -np.expm1(-np.exp(-(r - mode) / scale))
    share, error = exceeded.mean(), exceeded.std() / math.sqrt(count)
    assert abs(found.probability - share) < 4 * error + 0.02 * share

    steep = {"lognormal": {"mean": {"factor": 4.0, "power": 0.5}, "cov": 0.1}, "given": "h"}
    laws = {"h": {"normal": {"mean": 4, "sd": 1}, "lower": 0.5}, "t": steep}
    found = reliability(lambda h, t: t - 7, laws)
    spread = math.sqrt(math.log1p(0.01))

    def below(h: float) -> float:
        return stats.norm.cdf((math.log(7 / (4 * math.sqrt(h))) + spread**2 / 2) / spread)

    mass = stats.norm.sf(-3.5)
    exact, _ = integrate.quad(lambda h: stats.norm.pdf(h - 4) * below(h), 0.5, 14, epsabs=0)
    assert found.probability == pytest.approx(exact / mass, rel=1e-6)
    with pytest.raises(StandfastError, match="line is \"h\", on which the law of another number depends; expected one of t"):
        reliability(lambda h, t: t - 7, laws, line="h")
