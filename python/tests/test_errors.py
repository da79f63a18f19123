"""Which exceptions there are: a slip in a case is told from a target that nothing meets, and all are ValueErrors."""

from pathlib import Path

import pytest
import standfast
from standfast import CaseError, NoSolution, StandfastError

GODA = Path(__file__).parents[2] / "examples/goda-2000.toml"
BLOCK = {"body": {"width": 1, "height": 2, "mass": 4800, "friction": 0.7}, "load": [{"force": 20e3, "elevation": 1.5}]}
SLIP = {**BLOCK, "body": {**BLOCK["body"], "friktion": 0.7}}  # type: ignore[dict-item]


def test_all_are_value_errors():
    assert issubclass(StandfastError, ValueError)
    assert issubclass(CaseError, StandfastError) and issubclass(NoSolution, StandfastError)
    assert not issubclass(CaseError, NoSolution) and not issubclass(NoSolution, CaseError)
    assert {CaseError.__module__, NoSolution.__module__, StandfastError.__module__} == {"standfast"}


@pytest.mark.parametrize(
    "call",
    [
        lambda: standfast.assess(SLIP),
        lambda: standfast.assess({"body": {"width": object()}}),
        lambda: standfast.design(SLIP, vary="width", target="factor=1.2"),
        lambda: standfast.assess_table(SLIP, {"friction": [0.5]}),
        lambda: standfast.simulate(SLIP),
        lambda: standfast.sheet(SLIP),
        lambda: standfast.probability({**BLOCK, "random": {"friction": {"normal": {"cov": -1}}}}),
        lambda: standfast.draws(SLIP, 3),
    ],
)
def test_a_slip_in_a_case(call):
    with pytest.raises(CaseError):
        call()


def test_a_design_that_no_value_meets():
    with pytest.raises(NoSolution, match="no width from 1 m to 2 m meets the target"):
        standfast.design(GODA, vary="width", target="factor=1.2", lower=1, upper=2)
    # A name or a target that is not understood is no lack of a solution.
    for wrong in ({"vary": "widht", "target": "factor=1.2"}, {"vary": "width", "target": "faktor=1.2"}):
        with pytest.raises(ValueError) as caught:
            standfast.design(GODA, **wrong)
        assert not isinstance(caught.value, (NoSolution, CaseError))
