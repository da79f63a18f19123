"""Every JSON document is what docs/*.schema.json say, and the schemas let nothing else pass."""

from __future__ import annotations

import ast
import copy
import importlib
import importlib.util
import json
import pydoc
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
import standfast
from jsonschema import Draft202012Validator
from referencing import Registry, Resource
from standfast import _schema

ROOT = Path(__file__).parents[2]
SCHEMAS = {path.name: json.loads(path.read_text(encoding="utf-8")) for path in sorted((ROOT / "docs").glob("*.schema.json"))}
REGISTRY: Registry[Any] = Registry().with_resources(
    (name, Resource.from_contents(schema)) for name, schema in SCHEMAS.items()
)
EXAMPLES = sorted((ROOT / "examples").glob("*.toml"))
EVERY_MOTION = sorted((ROOT / "examples/motion").glob("*.toml"))
EVERY_RANDOM = [
    ROOT / "examples" / f"{name}.toml"
    for name in ("goda-2000-random", "statue-random", "probability/plane-random", "probability/column-records")
]
ODD = sorted((ROOT / "crates/cli/tests/cmd/loads-answers.in").glob("*.toml"))

BLOCK = {"width": 1, "height": 2, "mass": 4800, "friction": 0.7}
#: What no file of the repository shows, each with a fact that says so.
CASES: dict[str, tuple[dict[str, Any], tuple[str, Any]]] = {
    "leaves rest at once, by its permanent loads": (
        {"body": BLOCK, "uplift": {"left": 0, "right": "80 kPa"}, "load": [{"force": 1, "elevation": 1}]},
        ("departure_by", "permanent-loads"),
    ),
    "leaves rest at once, by any share of the load": (
        {"body": BLOCK | {"friction": 0}, "load": [{"force": 1, "elevation": 1}]},
        ("departure_by", "any-share"),
    ),
    "never leaves rest": ({"body": BLOCK, "earthquake": {"horizontal": 0, "vertical": "0.1 g", "vertical_fixed": True}}, ("departure", "never")),
    "a force of nothing": ({"body": BLOCK, "load": [{"force": 0, "elevation": 1}]}, ("SF_sliding", "infinite")),
    "weight beside the base": (
        {"body": BLOCK | {"buoyant_weight": 3e4, "weight_arm": 1.5}, "load": [{"force": 1, "elevation": 1}]},
        ("bearing", "outside-base"),
    ),
}
POINTS = [
    (1, 0.4, 0.5, 0.6),
    (1, 1, 2, 5),
    (0.8, 0.3, 0.9, 0.1),
    (1, -0.5, 4, 3),
    (1, -1, 2, 5),
    (1, -2, 2, 5),
    (1, -0.5, 0, 0),
    (1, -1e50, 1e50, 1e50),
    (1e-50, 1, 1e-50, 0),
]
DESIGNS = [
    ("goda-2000", "width", "factor=1.2"),
    ("goda-2000", "friction", "rest"),
    ("head-difference", "water_level", "load-factor=1.1"),
    ("caisson-in-air", "mass", "no-rock"),
    ("block-two-loads", "load[3].force", "factor=0.2", "--greatest"),
    ("block-two-loads", "width", "no-slide"),
    ("quay", "width", "criteria"),
    ("quay", "width", "bearing_max=300kPa"),
    ("quay", "load[1].force", "utilisation=0.98", "--greatest"),
    ("server-rack", "load[1].force", "criteria", "--greatest"),
    ("marble-drum", "width", "rest"),
    ("crown-wall", "friction", "SF_sliding=1.5"),
]
BOUNDARIES = [
    ("goda-2000", "width", "factor=1.2", "--and=friction"),
    ("seismic-block", "height", "factor=1", "--greatest", "--and=earthquake.horizontal"),
    ("server-rack", "mass", "SF_sliding=1.5", "--and=load[1].force"),
]


def errors(document: Any, schema: str) -> list[str]:
    found = Draft202012Validator(SCHEMAS[schema], registry=REGISTRY).iter_errors(document)
    return [f"{error.json_path}: {error.message}" for error in found]


def printed(program: list[str], *arguments: str | Path) -> str:
    found = subprocess.run([*program, *arguments], capture_output=True, encoding="utf-8")
    assert found.returncode == 0, found.stderr
    return found.stdout


def classified(program: list[str], point: tuple[float, ...]) -> Any:
    options = (f"--{name}={value}" for name, value in zip(("gamma", "k-prime", "k", "mu"), point))
    return json.loads(printed(program, "classify", *options, "--format=json"))


def designed(program: list[str], name: str, vary: str, target: str, *options: str) -> Any:
    file = ROOT / f"examples/{name}.toml"
    return json.loads(printed(program, "design", file, "--vary", vary, "--target", target, *options, "--format=json"))


def objects(document: Any) -> Iterator[dict[str, Any]]:
    """Every object of a document."""
    if isinstance(document, dict):
        yield document
    for part in document.values() if isinstance(document, dict) else document if isinstance(document, list) else []:
        yield from objects(part)


def mistakes(document: Any) -> Iterator[tuple[str, Any]]:
    """The document with one thing wrong, for every key of it; of objects with the same keys, in the first."""
    first: dict[tuple[str, ...], int] = {}
    for place, part in enumerate(objects(document)):
        first.setdefault(tuple(part), place)
    for keys, place in first.items():
        for key in keys:
            for mistake in ("renamed", "left out", "of no type", "twice"):
                wrong = copy.deepcopy(document)
                part = list(objects(wrong))[place]
                value = part[key]
                if mistake in ("renamed", "twice"):
                    part[f"{key}s"] = value
                if mistake == "of no type":
                    part[key] = {"value": value}
                elif mistake != "twice":
                    del part[key]
                yield f"{key} {mistake}", wrong


@pytest.mark.parametrize("path", [*EXAMPLES, *ODD], ids=lambda path: path.stem)
def test_answers_of_files(path: Path) -> None:
    document = json.loads(standfast.assess(path).to_json())
    assert not errors(document, "answer.schema.json")


@pytest.mark.parametrize("name", CASES)
def test_answers_of_odd_cases(name: str) -> None:
    case, (key, value) = CASES[name]
    document = json.loads(standfast.assess(case).to_json())
    assert document["situations"][0][key] == value
    assert not errors(document, "answer.schema.json")


def test_the_program_says_the_same(program: list[str], tmp_path: Path) -> None:
    for path in [*EXAMPLES, *ODD]:
        found = standfast.assess(path)
        document = printed(program, "assess", path, "-o", tmp_path, "--format", "json")
        assert not errors(json.loads(document), "answer.schema.json")
        assert json.loads(document) | {"figures": []} == json.loads(found.to_json())
        files = [tmp_path / name for name in json.loads(document)["figures"]]
        assert [file.read_text(encoding="utf-8") for file in files] == [figure.svg for figure in found.figures]
        written = printed(program, "assess", path, "-o", tmp_path).removeprefix(str(found)).splitlines()
        assert len(written) == (len(files) + 1 if files else 0), path


@pytest.mark.parametrize("point", POINTS, ids=str)
def test_points(program: list[str], point: tuple[float, ...]) -> None:
    document = classified(program, point)
    assert not errors(document, "point.schema.json")
    assert document["mode"] == standfast.classify(*point, names=True)


@pytest.mark.parametrize("wanted", DESIGNS, ids=" ".join)
def test_designs(program: list[str], wanted: tuple[str, ...]) -> None:
    assert not errors(designed(program, *wanted), "design.schema.json")


@pytest.mark.parametrize("wanted", BOUNDARIES, ids=" ".join)
def test_boundaries(program: list[str], wanted: tuple[str, ...]) -> None:
    assert not errors(designed(program, *wanted), "boundary.schema.json")


def test_motions() -> None:
    for path in EVERY_MOTION:
        assert not errors(json.loads(standfast.simulate(path).to_json()), "simulate.schema.json")


def test_probabilities(tmp_path: Path) -> None:
    for path in EVERY_RANDOM:
        assert not errors(json.loads(standfast.probability(path).to_json()), "probability.schema.json")
    # A life, and several sets of loads.
    random: dict[str, Any] = {"friction": {"normal": {"mean": 0.6, "sd": 0.1}}, "load[1].force": {"normal": {"cov": 0.2}, "every": "year"}}
    loads = [{"force": "20 kN/m", "elevation": 1, "name": name} for name in ("one", "two")]
    answer = standfast.probability({"body": BLOCK, "load": loads, "random": {**random, "years": 50}}, precision=0.2)
    document = json.loads(answer.to_json())
    assert document["life"] and document["others"] and document["joined"] and not errors(document, "probability.schema.json")
    more = {**random, "years": 50, "survived": 20, "target_beta": 3.8}
    stood = json.loads(standfast.probability({"body": BLOCK, "load": loads[:1], "random": more}).to_json())
    assert stood["life"]["stood"] and stood["design_values"] and not errors(stood, "probability.schema.json")
    asked = standfast.probability({"body": BLOCK, "load": loads[:1], "random": random, "criteria": {"p_not_rest": 0.01}})
    assert asked.criterion is not None and not errors(json.loads(asked.to_json()), "probability.schema.json")
    shaken = (ROOT / "examples/motion/statue-earthquake.toml").read_text() + "[random]\nfriction = { normal = { sd = 0.05 } }\n"
    path = tmp_path / "statue.toml"
    path.write_text(shaken.replace("../records", str(ROOT / "examples/records")))
    over = standfast.probability(path, over="pga=0.4 g..0.8 g:2", samples=8)
    assert over.overturning is not None and over.overturning.bodies == 16
    assert not errors(json.loads(over.to_json()), "probability.schema.json")


def test_a_document_with_one_mistake_fails(program: list[str]) -> None:
    # A point of the diagram, alternative loads, still water.
    cases = [ROOT / "examples/goda-2000.toml", ROOT / "examples/block-two-loads.toml", ODD[-1]]
    documents = [
        *((json.loads(standfast.assess(case).to_json()), "answer.schema.json") for case in cases),
        (classified(program, POINTS[1]), "point.schema.json"),
        (designed(program, *DESIGNS[0]), "design.schema.json"),
        (designed(program, *BOUNDARIES[0]), "boundary.schema.json"),
        (json.loads(standfast.simulate(EVERY_MOTION[0]).to_json()), "simulate.schema.json"),
        (json.loads(standfast.spectrum(EVERY_MOTION[0], "overturning", scale="0.5..2:4").to_json()), "spectrum.schema.json"),
        # The keys of a design point are names of the user's.
        ({**json.loads(standfast.probability(EVERY_RANDOM[0]).to_json()), "design_point": {}}, "probability.schema.json"),
    ]
    assert documents[0][0]["situations"][0]["report"] and documents[1][0]["situations"][0]["load"] and documents[2][0]["water"]
    for document, schema in documents:
        validator = Draft202012Validator(SCHEMAS[schema], registry=REGISTRY)
        passed = {what for what, wrong in mistakes(document) if validator.is_valid(wrong)}
        assert not passed


@pytest.mark.parametrize(
    "change",
    [
        {"schema": 2},
        {"situations": []},
        {"departure": "never"},
        {"departure": "never", "load_factor": None},
        {"departure": "at-once"},
        {"load_factor": None},
        {"load_factor": "infinite"},
        {"departure_by": "any-share"},
        {"mode": "SR"},
        {"mode": None},
        {"also": ["SL", "SL"]},
        {"lifted": True},
        {"SF_sliding": None},
        {"SF_sliding": "unlimited"},
        {"bearing": "lifted"},
        {"heel_pressure": None},
        {"k_eff": None},
        {"report": None},
        {"no_report": "no-point"},
        {"motion": None},
    ],
    ids=str,
)
def test_what_does_not_go_together_fails(change: dict[str, Any]) -> None:
    document = json.loads(standfast.assess(ROOT / "examples/goda-2000.toml").to_json())
    part = document if change.keys() <= document.keys() else document["situations"][0]
    assert change.keys() <= part.keys() and all(part[key] != value for key, value in change.items())
    part.update(change)
    assert errors(document, "answer.schema.json")


def test_what_no_case_of_ours_has_is_allowed_for() -> None:
    document = json.loads(standfast.assess(ROOT / "examples/goda-2000.toml").to_json())
    nothing = {"mode": None, "mode_words": None, "motion": None, "report": None, "k_eff": None, "k_prime_eff": None}
    document["situations"][0].update(nothing, because=[], no_report="no-point")
    assert not errors(document, "answer.schema.json")


def test_schemas_are_closed_and_say_what_everything_is() -> None:
    for name, schema in SCHEMAS.items():
        Draft202012Validator.check_schema(schema)
        for part in objects(schema):
            # One whose keys are words of the user's is open, to one kind of values.
            if part.get("type") == "object" and not isinstance(part.get("additionalProperties"), dict):
                absent = [key for key, value in part["properties"].items() if "absent" in value.get("description", "")]
                assert part["required"] == [key for key in part["properties"] if key not in absent], name
                closed = {"additionalProperties", "unevaluatedProperties"} & part.keys()
                # A point is closed where it is referred to, because a document of its own has `schema` beside it.
                points = (SCHEMAS["answer.schema.json"]["$defs"]["point"], SCHEMAS["point.schema.json"]["$defs"]["crushing"])
                assert closed or any(part is point for point in points), name
                for key, value in part["properties"].items():
                    assert value.get("description") or "$ref" in value, (name, key)


def stub(module: str) -> str:
    """The stub of a module of classes, as the build writes it."""
    place = importlib.util.spec_from_file_location("build_backend", ROOT / "python/build_backend.py")
    assert place and place.loader
    backend = importlib.util.module_from_spec(place)
    # What it builds with is not wanted here.
    with pytest.MonkeyPatch.context() as patch:
        patch.setitem(sys.modules, "maturin", SimpleNamespace(build_wheel=None, build_sdist=None, build_editable=None))
        place.loader.exec_module(backend)
    written: str = backend.stub(module)
    return written


def test_the_package_has_the_schemas_and_the_stubs_that_they_give() -> None:
    package = Path(standfast.__file__).parent
    for name in SCHEMAS:
        assert (package / name).read_bytes() == (ROOT / "docs" / name).read_bytes()
    for module in _schema.MODULES:
        assert (package / f"{module}.pyi").read_text(encoding="utf-8") == stub(module)


def test_the_classes_have_the_keys_and_words_of_the_schemas() -> None:
    for module in _schema.MODULES:
        names = importlib.import_module(f"standfast.{module}").__all__
        tree = ast.parse(stub(module))
        stubs = {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}
        assert names == sorted(stubs.keys() - {"OnlySituation"})
        for name, node in stubs.items():
            kind = getattr(importlib.import_module(f"standfast.{module}"), name)
            assert (kind.__module__, kind.__qualname__, kind.__name__) == (f"standfast.{module}", name, name)
            keys = {one.name: one for one in node.body if isinstance(one, ast.FunctionDef) and one.decorator_list}
            assert keys.keys() == {key for key, one in vars(kind).items() if isinstance(one, property)}
            for key, one in keys.items():
                assert one.returns is not None and "Any" not in ast.unparse(one.returns)
                assert " ".join((ast.get_docstring(one) or "").split()) == getattr(kind, key).__doc__
    for name, definition in SCHEMAS["answer.schema.json"]["$defs"].items():
        if "properties" in definition:
            kind = getattr(standfast.answers, "CaseWarning" if name == "warning" else name.title().replace("-", ""))
            assert {_schema.attribute(key) for key in definition["properties"]} <= vars(kind).keys()
    assert standfast.answers.Body.mass.__doc__ == "kg/m."
    assert "Safety factor against sliding" in pydoc.plain(pydoc.render_doc(standfast.Situation))
