"""What stands beside the scripts of validation/ is what they print."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

VALIDATION = Path(__file__).resolve().parents[2] / "validation"
BENCHMARK = VALIDATION / "benchmark"


def printed(*command: str | Path) -> str:
    """What a script prints, by a Python without packages."""
    ran = subprocess.run([sys.executable, "-I", "-S", *command], capture_output=True, encoding="utf-8", check=True)
    return ran.stdout


def rows(table: str) -> set[tuple[str, ...]]:
    """The rows of all tables of a text, each as its cells but for the first with that in words."""
    named = re.compile(r"(\w+)-(best|default)-\w+\.csv")
    engines = {name.lower(): name for name in ("Box2D", "Drake", "MuJoCo", "PyBullet", "Rapier")}
    found = set()
    for line in table.splitlines():
        first, *cells = [cell.strip() for cell in line.strip("|").split("|")]
        if match := named.fullmatch(first):
            first = f"{engines[match[1]]}, {match[2]}"
        found.add((first, *cells))
    return found


def test_the_scores_are_those_of_the_pages() -> None:
    answers = sorted((BENCHMARK / "results").glob("*.csv"))
    assert len(answers) == 20
    scored = {row for row in rows(printed(BENCHMARK / "score.py", *answers, "--brief")) if row[0].endswith((", best", ", default"))}
    assert len(scored) == 20
    told = rows((BENCHMARK / "results" / "README.md").read_text(encoding="utf-8"))
    assert scored <= told
    # The short table has of each row the shares alone.
    short = rows((BENCHMARK / "README.md").read_text(encoding="utf-8"))
    for name in {row[0] for row in scored}:
        onset, motions = sorted((row for row in scored if row[0] == name), key=len)
        assert (name, *onset[2:5], *motions[2:4]) in short


def test_every_failed_case_is_told() -> None:
    told = printed(BENCHMARK / "score.py", BENCHMARK / "results" / "rapier-default-onset.csv", "--failed")
    # 79.2 % of 600 and 63.5 % of 200 are right, and of 200 with several modes 30 % are one of them.
    failed = {line.split()[0] for line in told.splitlines() if re.match(r"\s*[uni]\d{3}\b", line)}
    assert [sum(of.startswith(group) for of in failed) for group in "uni"] == [125, 73, 140]


def test_wrong_answers_are_refused_in_words(tmp_path: Path) -> None:
    wrong = tmp_path / "wrong.csv"
    for text, word in [("", "empty"), ("id,mode\nx001,RE\n", "x001"), ("id,mode\nu001,XX\n", "XX"), ("id\nu001\n", "mode")]:
        wrong.write_text(text)
        ran = subprocess.run([sys.executable, BENCHMARK / "score.py", wrong], capture_output=True, encoding="utf-8")
        said = ran.stdout + ran.stderr
        assert ran.returncode == 1 and word in said and "Traceback" not in said, said


def test_the_survey_of_structures(program: list[str], tmp_path: Path) -> None:
    if len(program) > 1:
        pytest.skip("asks a built program 200 times: STANDFAST=target/debug/standfast")
    survey = VALIDATION / "decision" / "structures" / "survey.py"
    situations = tmp_path / "survey.csv"
    assert printed(survey, program[0], situations) == survey.with_suffix(".txt").read_text(encoding="utf-8")
    assert len(situations.read_text(encoding="utf-8").splitlines()) == 1615
