"""Which exceptions there are: a slip in a case is told from a target that nothing meets, and all are ValueErrors."""

import ast
import subprocess
from pathlib import Path

import pandas as pd
import pytest
import standfast
from standfast import CaseError, NoSolution, StandfastError

EXAMPLES = Path(__file__).parents[2] / "examples"
GODA, RANDOM = EXAMPLES / "goda-2000.toml", EXAMPLES / "goda-2000-random.toml"
SHAKEN = {"block": {"b1": 1, "b2": 1, "d": 3, "mu_s": 50, "gravity": 1}}
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
    several = {"vary": ["width=1 m..2 m", "height"], "minimise": "volume"}
    with pytest.raises(NoSolution, match="whatever height is from 5.25 m to 21 m, the target is not met") as caught:
        standfast.design(GODA, target="factor=1.2", **several)
    assert "the upper end in vary, of each quantity, widen the" in str(caught.value)
    # A name or a target that is not understood is no lack of a solution.
    for wrong in ({"vary": "widht", "target": "factor=1.2"}, {"vary": "width", "target": "faktor=1.2"}):
        with pytest.raises(ValueError) as caught:
            standfast.design(GODA, **wrong)
        assert not isinstance(caught.value, (NoSolution, CaseError))


#: Slips that were errors of Python alone: of sweeps, targets, ranges, records, points and diagrams.
REFUSED = {
    "a row of a sweep": lambda: standfast.assess_table(BLOCK, {"friction": [0.5, -0.5]}),
    "a key of a sweep": lambda: standfast.assess_table(BLOCK, {"frction": [0.5]}),
    "a result": lambda: standfast.assess_table(BLOCK, {"friction": [0.5]}, columns=["mood"]),
    "no result": lambda: standfast.assess_table(BLOCK, {"friction": [0.5]}, columns=[]),
    "a row of a table": lambda: standfast.assess_table(BLOCK, pd.DataFrame({"friction": [0.5, -0.5]}, index=["a", "b"])),
    "a target": lambda: standfast.design(GODA, vary="width", target="factr"),
    "a quantity": lambda: standfast.design(GODA, vary="widht", target="rest"),
    "a range": lambda: standfast.probability(RANDOM, over="width"),
    "a method": lambda: standfast.probability(RANDOM, method="guess"),  # type: ignore[arg-type]
    "a floor": lambda: standfast.probability(RANDOM, floor=2),
    "a scale": lambda: standfast.spectrum(SHAKEN, "overturning", scale="2..1", base=[0.5, 0.5], dt=1),
    "a record": lambda: standfast.simulate(SHAKEN, base=[0.5], dt=1),
    "a step": lambda: standfast.simulate(SHAKEN, base=[0.5, 0.5], dt=1).series(1e-12),
    "a point": lambda: standfast.classify(1, 0.4, 0.5, -0.5),
    "a point of many": lambda: standfast.classify(1, 0.4, [0.5], [-0.5]),
    "a point of a frame": lambda: standfast.classify(pd.DataFrame({"gamma": [1], "k_prime": [0.4], "k": [0.5], "mu": [-1.0]}, index=["a"])),
    "shapes": lambda: standfast.classify(1, 0.4, [0.5, 0.6], [0.5, 0.6, 0.7]),
    "a limit state": lambda: standfast.limit_states(1, 0.4, [0.5], [-0.5]),
    "a contact": lambda: standfast.contact(1, 1, 1, -1, 1, 1, 0, 1, 0, 0.5, 0.5),
    "a mode": lambda: standfast.Mode("slides"),
    "a diagram": lambda: standfast.Diagram(-1, 0.4),
    "a window": lambda: standfast.Diagram(1, 0.4, window=(-1, 1)),
    "a law": lambda: standfast.Diagram(1, 0.4, law="soft", share=0.3),  # type: ignore[call-overload]
    "how far": lambda: standfast.assess(BLOCK, up_to=0),
    "threads": lambda: standfast.classify(1, 0.4, [0.5], [0.5], threads=0),
    "a date": lambda: standfast.sheet(GODA, date="soon"),
    "a file": lambda: standfast.assess(GODA).figures[0].save("figure.bmp"),
    "codes": lambda: standfast.ModeArray([77]),
}  # fmt: skip


@pytest.mark.parametrize("name", REFUSED)
def test_all_that_is_wrong_with_a_value_is_of_one_family(name: str) -> None:
    with pytest.raises(StandfastError) as caught:
        REFUSED[name]()
    assert isinstance(caught.value, ValueError) and not isinstance(caught.value, (CaseError, NoSolution))


def test_no_source_raises_an_error_of_value_that_is_not_of_the_family() -> None:
    """Neither in Python nor in the native module, wherever it is raised."""
    package = Path(standfast.__file__).parent
    for path in package.glob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
                assert node.func.id != "ValueError", f"{path.name}:{node.lineno}"
            if isinstance(node, ast.Raise):
                assert not (isinstance(node.exc, ast.Name) and node.exc.id == "ValueError"), f"{path.name}:{node.lineno}"
    sources = Path(__file__).parents[1] / "src"
    for path in sources.glob("*.rs"):
        if path.name != "errors.rs":
            assert "PyValueError" not in path.read_text(encoding="utf-8"), path.name


def test_a_key_of_a_case_is_looked_for_in_its_table() -> None:
    with pytest.raises(StandfastError, match=r"did you mean `wave.deep_water_height`\?"):
        standfast.assess_table(GODA, {"wave.heigth": [6.3]})
    with pytest.raises(StandfastError, match=r"did you mean `wave.deep_water_height`\?"):
        standfast.design(GODA, vary="wave.heigth", target="rest")


#: Names that no law has, and laws with a wrong parameter.
LAWS = [
    {"beta": {"mean": 0.6, "sd": 0.4, "from": 0.3, "to": 0.9}},
    {"beat": {"mean": 0.6}},
    {"normal": {"mean": 0.6, "sdd": 0.1}},
    {"uniform": {"from": 0.7, "to": 0.4}},
]


@pytest.mark.parametrize("law", LAWS, ids=lambda law: next(iter(law)))
def test_a_law_of_a_dict_is_read_as_that_of_a_file(law: dict[str, dict[str, float]], program: list[str], tmp_path: Path) -> None:
    """The same names and the same errors, as one reader reads both."""
    (name, parameters), = law.items()
    inner = ", ".join(f"{key} = {value}" for key, value in parameters.items())
    body = "[body]\nwidth = 1\nheight = 2\nmass = 4800\nfriction = 0.7\n[[load]]\nforce = 20000.0\nelevation = 1.5\n"
    path = tmp_path / "case.toml"
    path.write_text(f"{body}[random]\nfriction = {{ {name} = {{ {inner} }} }}\n", encoding="utf-8")
    said = subprocess.run([*program, "probability", "--no-figures", path], capture_output=True, encoding="utf-8", check=False).stderr
    with pytest.raises(CaseError) as of_file:
        standfast.probability(path)
    with pytest.raises(CaseError) as of_dict:
        standfast.probability({**BLOCK, "random": {"friction": law}})
    first = [" ".join(text.split("-->")[0].split()) for text in (str(of_file.value), str(of_dict.value))]
    assert first[0] == first[1] and first[0] in " ".join(said.split()), (first, said)
