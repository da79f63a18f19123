"""Cases from files and dicts; that the program says the same is in test_schema.py."""

from __future__ import annotations

import copy
import gc
import json
import math
import pickle
import types
import typing
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import standfast
from standfast import Answer, Criterion, Mode, Modes, Situation

ROOT = Path(__file__).parents[2]
EXAMPLES = sorted((ROOT / "examples").glob("*.toml"))
ODD = ROOT / "crates/cli/tests/cmd/loads-answers.in"

CASE: dict[str, Any] = {
    "title": 'A "quoted" title\nin two lines, with γ',
    "body": {"width": "15 m", "height": np.float64(12), "density": "2.1 t/m3", "friction": 0.6},
    "load": [{"name": "wave", "force": "2700 kN/m", "elevation": "11.5 m", "direction": "left"}],
}


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_every_example(path: Path) -> None:
    found = standfast.assess(path)
    document = found.to_dict()
    assert json.loads(json.dumps(document)) == document
    # The shortest example has no title.
    title = document["title"] or "sliding"
    assert title in str(found) and (document["title"] or "a case") in repr(found)
    assert found.figures is found.figures and str(found) is str(found) and found.situations is found.situations
    assert found.figures and all(figure.svg.startswith("<svg") for figure in found.figures)
    assert found._repr_svg_() == found.figures[0].svg
    for other in (pickle.loads(pickle.dumps(found)), copy.copy(found), copy.deepcopy(found)):
        assert other.to_dict() == document and (str(other), other.figures) == (str(found), found.figures)
        assert other.to_json() == found.to_json()


def test_a_dict_is_the_same_case_as_its_file() -> None:
    tomllib = pytest.importorskip("tomllib")
    for path in EXAMPLES:
        with path.open("rb") as file:
            case = tomllib.load(file)
        assert standfast.assess(case).to_dict() == standfast.assess(path).to_dict()


def test_answers_as_attributes() -> None:
    found = standfast.assess(CASE)
    assert found.title == CASE["title"]
    assert found.mode is Mode.SLIDE_ROCK_O_LEFT and found["situations"][0]["mode"] == "SRO-"
    assert found.load.direction == "left" and found.motion.xi == -7.5 and found.body.width == 15
    assert found.report.motion.xi == -1 and found.report.along_mu[0].to is Mode.SLIDE_ROCK_O_LEFT
    assert found.report.along_mu[0].from_ is Mode.SLIDE_LEFT and found.report.trace[-1].mode is found.mode
    with pytest.raises(AttributeError, match="this assessment has no 'colour'; it has schema, title, note, gravity"):
        found.colour  # noqa: B018
    with pytest.raises(AttributeError, match="this answer has no 'colour'; it has load, combination, earthquake"):
        found.situations[0].colour  # noqa: B018

    goda = standfast.assess(ROOT / "examples/goda-2000.toml", up_to=1.5)
    assert (goda.mode, goda.departure, goda.departure_mode) == (Mode.REST, "at", Mode.SLIDE_LEFT)
    assert goda.load_factor == pytest.approx(1.1252, abs=1e-4) and goda["situations"][0]["departure_mode"] == "SL"
    assert [(stage.from_, stage.to) for stage in goda.path] == [(0, goda.load_factor), (goda.load_factor, 1.5)]
    assert goda.wave.lambda_ == goda["wave"]["lambda"] == [1, 1, 1]
    assert goda.wave.impulsive is True and goda.warnings[0].name == "impulsive-breaking"


def test_what_is_unlimited_and_what_is_not_there() -> None:
    goda = standfast.assess(ROOT / "examples/goda-2000.toml")
    assert goda.SF_overturning_toe == math.inf and goda.load is None and goda.departure_by is None
    raw = json.loads(goda.to_json())
    assert raw["situations"][0]["SF_overturning_toe"] == "infinite"
    lifted = standfast.assess(ODD / "floating.toml")
    assert lifted.lifted and lifted.SF_sliding is lifted.SF_overturning_net is lifted.heel_pressure is None
    assert (lifted.mode, lifted.departure, lifted.load_factor) == (Mode.FLIGHT, "at-once", None)

    # What a user calls infinite is a word.
    named = {"title": "infinite", "note": "infinite", "load": [CASE["load"][0] | {"name": "infinite"}]}
    found = standfast.assess(CASE | named)
    assert (found.title, found.note, found.load.name) == ("infinite", "infinite", "infinite")
    assert found.components[-1].name == "infinite"


def test_modes_in_attributes() -> None:
    found = standfast.assess(ODD / "not-unique.toml")
    assert not found.unique and found.also == Modes.ROCK_O | Modes.SLIDE_ROCK_O_LEFT
    assert found.path[2].also.modes == (Mode.ROCK_O, Mode.SLIDE_ROCK_O_LEFT)
    assert found["situations"][0]["also"] == ["RO", "SRO-"]
    assert found.path[0].also == Modes(0) and not found.path[0].also
    # No consistent mode.
    document = json.loads(found.to_json())
    document["situations"][0].update(mode=None, motion=None)
    torn = Situation(document["situations"][0])
    assert torn.mode is None and torn.motion is None


def test_alternative_loads() -> None:
    several = standfast.assess(ROOT / "examples/block-two-loads.toml")
    assert [situation.mode for situation in several.situations][:2] == [Mode.ROCK_O, Mode.ROCK_O_PRIME]
    assert several.situations[1].load.name == "push back"
    least = min(range(3), key=lambda place: float(several.situations[place].load_factor))
    assert several["governing"] == least and several.governing is several.situations[least]
    assert "mode" in dir(several.governing) and "mode" not in dir(several) and "governing" in dir(several)
    with pytest.raises(AttributeError, match=r"3 situations; see situations\[0\].mode and so on, or governing.mode"):
        several.mode  # noqa: B018
    with pytest.raises(AttributeError, match="this assessment has no 'colour'"):
        several.colour  # noqa: B018


def test_combinations_and_criteria() -> None:
    loads = [{"name": "push", "force": 100e3, "elevation": 1, "together": True}]
    combinations = [{"name": "as it is", "factors": {"push": 1}}, {"factors": {"push": 1.5, "weight": 0.9}}]
    found = standfast.assess(CASE | {"load": loads, "combination": combinations, "criteria": {"SF_sliding": 1.2}})
    assert [situation.combination.name for situation in found.situations] == ["as it is", None]
    assert found.situations[1].combination["factors"] == {"push": 1.5, "weight": 0.9}
    plain, factored = (situation.SF_sliding for situation in found.situations)
    assert factored == pytest.approx(plain * 0.9 / 1.5, rel=1e-14)
    assert found["governing"] == 1 and found.criteria[0].situation == 1
    assert found.criteria[0].utilisation == pytest.approx(1.2 / factored, rel=1e-14) and found.met is (factored >= 1.2)
    assert repr(found).endswith("; criteria met>" if found.met else "; not met: SF_sliding>")
    assert standfast.assess(CASE).met is None


def test_many_loads_are_shown_by_those_that_govern() -> None:
    case = CASE | {"load": [{"force": 1e6 + 1e5 * i, "elevation": 1 + i} for i in range(10)]}
    found, shown = standfast.assess(case), standfast.assess(case, all=True)
    assert len(found.situations) == 10 and found.to_dict() == shown.to_dict()
    assert len(found.figures) == 9 and len(shown.figures) == 11 and len(str(found)) < len(str(shown))
    assert "the 8 worst are shown one by one; all=True shows all." in " ".join(str(found).split())
    assert "--all" not in str(found) and "all=True" not in str(shown)
    assert repr(found).endswith(": 10 situations>") and found.governing is found.situations[9]


@pytest.mark.parametrize("path", [*EXAMPLES, *sorted(ODD.glob("*.toml"))], ids=lambda path: path.stem)
def test_every_key_is_an_attribute(path: Path) -> None:
    found = standfast.assess(path)
    answers: list[Answer] = [found]
    seen = 0
    for answer in answers:
        assert len({*dir(answer)}) == len(dir(answer))
        for key, item in answer.items():
            name = {"from": "from_", "lambda": "lambda_"}.get(key, key)
            value = getattr(answer, name)
            assert name in dir(answer)
            assert (name == key) or (key not in dir(answer) and not hasattr(answer, key))
            seen += 1
            if isinstance(value, Answer) and key != "governing":
                assert value.to_dict() == item
                answers.append(value)
            elif isinstance(value, list) and item and isinstance(item[0], dict):
                assert [part.to_dict() for part in value] == item
                answers.extend(value)
            elif isinstance(value, Mode):
                assert value.symbol == item
            elif isinstance(value, Modes):
                assert [mode.symbol for mode in value.modes] == item
            elif key not in ("governing", "figures"):
                assert value == item
    assert seen > 100
    if len(found.situations) == 1:
        public = {name for name in dir(found.governing) if not name.startswith("_")}
        assert public <= {*dir(found)} and found.mode is found.governing.mode


def test_wrong_cases_show_where() -> None:
    def error(change: Any) -> str:
        case = copy.deepcopy(CASE)
        change(case)
        with pytest.raises(ValueError) as raised:
            standfast.assess(case)
        return str(raised.value)

    shown = error(lambda case: case["body"].update(friction=-0.6))
    assert "friction" in shown and "-0.6" in shown and "expected" in shown
    assert "friktion" in error(lambda case: case["body"].update(friktion=0.6))
    assert "`force`" in error(lambda case: case["load"][0].pop("force"))
    shown = error(lambda case: case["body"].update(width=object()))
    assert shown.startswith("body.width is <object") and "expected a number, a text with a unit" in shown
    assert "load.force is None" in error(lambda case: case["load"][0].update(force=None))
    assert "nan" in error(lambda case: case["body"].update(width=float("nan"))).lower()
    assert error(lambda case: case.clear())
    with pytest.raises(OSError, match="nowhere"):
        standfast.assess("nowhere.toml")
    for up_to in (-1, 0.5, 2e6, float("nan")):
        with pytest.raises(ValueError, match=f"up_to is {up_to}; expected a load factor from 1 to 1000000, as 2"):
            standfast.assess(CASE, up_to=up_to)
    for wrong in ("2", None, True):
        with pytest.raises(TypeError, match=f"up_to is {wrong!r}; expected a load factor from 1 to 1000000, as 2"):
            standfast.assess(CASE, up_to=wrong)  # type: ignore[arg-type]


def test_a_file_that_is_not_text(tmp_path: Path) -> None:
    path = tmp_path / "case.toml"
    path.write_bytes(b"title = 'x'\nnote = '\xff'\n")
    with pytest.raises(ValueError, match="is not UTF-8 text: line 2"):
        standfast.assess(path)


def test_nothing_is_made_before_it_is_asked_for() -> None:
    """A handle alone: a thousand of the caisson with its waves hold little, where text, document and figures hold 160 kB each."""
    psutil = pytest.importorskip("psutil")
    process = psutil.Process()
    path = ROOT / "examples/goda-2000.toml"
    kept = [standfast.assess(path) for _ in range(200)]
    gc.collect()
    before = process.memory_info().rss
    kept += [standfast.assess(path) for _ in range(2000)]
    gc.collect()
    assert (process.memory_info().rss - before) / 2000 < 40_000
    assert all(not {"_text", "_document", "figures", "situations"} & vars(found).keys() for found in kept)
    assert len(pickle.dumps(kept[0])) < 6000
    loaded = pickle.loads(pickle.dumps(kept[0]))
    assert loaded.governing.SF_sliding == kept[0].governing.SF_sliding and loaded == kept[0]


def plain(kind: Any) -> set[Any]:
    """The classes that a type is made of."""
    if typing.get_origin(kind) in (typing.Union, types.UnionType, list, dict):
        return {part for argument in typing.get_args(kind) for part in plain(argument)}
    return {type(word) for word in typing.get_args(kind)} if typing.get_origin(kind) is typing.Literal else {kind}


def hint_of(attribute: property) -> Any:
    """The type of an attribute."""
    names = {"Literal": typing.Literal, "Mode": standfast.Mode, "Modes": standfast.Modes, **vars(standfast.answers)}
    return typing.get_type_hints(attribute.fget, names)["return"]


def test_every_attribute_has_a_type_and_words() -> None:
    found = standfast.assess(ROOT / "examples/eccentric-caisson.toml")
    for kind in [getattr(standfast.answers, name) for name in standfast.answers.__all__]:
        for name, attribute in vars(kind).items():
            if isinstance(attribute, property):
                assert attribute.__doc__ and attribute.__doc__.endswith("."), (kind, name)
                types = plain(hint_of(attribute))
                assert types and Any not in types and object not in types, (kind, name)
    # As they say, over all examples.
    for path in EXAMPLES + sorted(ODD.glob("*.toml")):
        answers: list[Any] = [found := standfast.assess(path), *found.situations]
        for answer in answers:
            for name in {*dir(type(answer))} - {"figures", "situations", "governing"}:
                attribute = getattr(type(answer), name)
                if name.startswith("_") or not isinstance(attribute, property) or name not in dir(answer):
                    continue
                value = getattr(answer, name)
                hint = hint_of(attribute)
                allowed = tuple(float if part is float else part for part in plain(hint))
                assert isinstance(value, (*allowed, *((int,) if float in allowed else ()), *((list,) if "list" in str(hint) else ()), *((dict,) if "dict" in str(hint) else ()))), (path, name, value)
                answers += [value] if isinstance(value, Answer) else [part for part in value if isinstance(part, Answer)] if isinstance(value, list) else []
    assert "Safety factor against sliding" in (Situation.SF_sliding.__doc__ or "")
    assert isinstance(found.situations[0], Situation)
    assert isinstance(standfast.assess(ROOT / "examples/quay.toml").criteria[0], Criterion)


def test_keys_do_not_depend_on_the_kind_of_case() -> None:
    keys: dict[str, set[tuple[str, ...]]] = {}
    parts = json.loads((ROOT / "docs/answer.schema.json").read_text(encoding="utf-8"))
    # What the schema says may be absent; waves are told once, and by a combination only where it has others.
    absent = {
        key
        for part in (parts, *parts["$defs"].values())
        for key, value in part.get("properties", {}).items()
        if "absent" in value.get("description", "")
    }

    def look(name: str, part: Any) -> None:
        # N/m, never kN/m; what a user wrote, warnings and sentences are for reading.
        assert not isinstance(part, str) or "kN" not in part or name in ("title", "note", "message", "near"), (name, part)
        if isinstance(part, dict) and name != "factors":
            own = {"wave"} if name != "combination" else set()
            if name not in absent - {"wave"}:
                keys.setdefault(name, set()).add(tuple(key for key in part if key not in absent - own))
            for key, value in part.items():
                look(key, value)
        elif isinstance(part, list):
            for value in part:
                look(name, value)

    for path in EXAMPLES + sorted(ODD.glob("*.toml")):
        look("document", standfast.assess(path).to_dict())
    assert {"situations", "wave", "report", "earthquake", "combination", "criteria"} < keys.keys()
    # A motion is that of a situation, in SI units, or of its point; both have the same keys.
    assert {name: len(found) for name, found in keys.items()} == dict.fromkeys(keys, 1)
