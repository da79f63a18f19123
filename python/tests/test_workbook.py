"""A workbook that the program writes, read by the standard library alone: by the parts of Office Open XML, apart from the crates
that write and read it in Rust; and one written in the same way, read by the program."""

import csv
import io
import subprocess
import zipfile
from pathlib import Path
from xml.etree import ElementTree

import pytest
from conftest import ROOT

NAMES = {"s": "http://schemas.openxmlformats.org/spreadsheetml/2006/main"}
CASE = ROOT / "examples" / "goda-2000.toml"


def column(reference: str) -> int:
    """The place of a cell's column, from zero: of `AB7` 27."""
    place = 0
    for letter in filter(str.isalpha, reference):
        place = 26 * place + ord(letter) - ord("A") + 1
    return place - 1


def cells(path: Path) -> list[list[str | float | bool | None]]:
    """The rows of the first sheet."""
    with zipfile.ZipFile(path) as file:
        strings = []
        if "xl/sharedStrings.xml" in file.namelist():
            shared = ElementTree.fromstring(file.read("xl/sharedStrings.xml"))
            strings = ["".join(item.itertext()) for item in shared.findall("s:si", NAMES)]
        sheet = ElementTree.fromstring(file.read("xl/worksheets/sheet1.xml"))
    rows = []
    for row in sheet.findall(".//s:row", NAMES):
        values: dict[int, str | float | bool | None] = {}
        for cell in row.findall("s:c", NAMES):
            text = cell.findtext("s:v", None, NAMES)
            kind = cell.get("t", "n")
            written = cell.find("s:is", NAMES)
            value: str | float | bool | None
            if written is not None:
                value = "".join(written.itertext())
            elif text is None:
                value = None
            elif kind == "s":
                value = strings[int(text)]
            elif kind == "b":
                value = text == "1"
            elif kind == "n":
                value = float(text)
            else:
                value = text
            values[column(cell.get("r", ""))] = value
        rows.append([values.get(place) for place in range(max(values, default=-1) + 1)])
    return rows


def run(program: list[str], *arguments: str | Path) -> bytes:
    command = [*program, "batch", "--case", str(CASE), *map(str, arguments)]
    done = subprocess.run(command, capture_output=True, check=False)
    assert done.returncode == 0, done.stderr.decode()
    return done.stdout


def test_a_workbook_has_what_the_csv_has(program: list[str], tmp_path: Path) -> None:
    states = ROOT / "examples" / "sea-states.csv"
    text = run(program, states, "-o", "-").decode()
    run(program, states, "-o", tmp_path / "out.xlsx")
    expected = list(csv.reader(io.StringIO(text)))
    found = cells(tmp_path / "out.xlsx")
    assert len(found) == len(expected) == 101
    assert found[0] == expected[0]
    for line, (one, other) in enumerate(zip(found[1:], expected[1:], strict=True)):
        one += [None] * (len(other) - len(one))
        for name, cell, field in zip(expected[0], one, other, strict=True):
            if isinstance(cell, bool):
                assert field == str(cell).lower(), (line, name)
            elif isinstance(cell, float):
                assert cell == pytest.approx(float(field), rel=1e-15, abs=0), (line, name)
            else:
                assert (cell or "") == field, (line, name)


def test_a_workbook_of_another_writer_is_read(program: list[str], tmp_path: Path) -> None:
    """Strings in the cells, a number, an empty cell: as some programs write, with no more parts than the format needs."""
    main = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
    office = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
    package = "http://schemas.openxmlformats.org/package/2006"
    spreadsheet = "application/vnd.openxmlformats-officedocument.spreadsheetml"

    def inline(reference: str, text: str) -> str:
        return f'<c r="{reference}" t="inlineStr"><is><t>{text}</t></is></c>'

    parts = {
        "[Content_Types].xml": f'<Types xmlns="{package}/content-types">'
        '<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
        f'<Override PartName="/xl/workbook.xml" ContentType="{spreadsheet}.sheet.main+xml"/>'
        f'<Override PartName="/xl/worksheets/sheet1.xml" ContentType="{spreadsheet}.worksheet+xml"/></Types>',
        "_rels/.rels": f'<Relationships xmlns="{package}/relationships">'
        f'<Relationship Id="r1" Type="{office}/officeDocument" Target="xl/workbook.xml"/></Relationships>',
        "xl/workbook.xml": f'<workbook xmlns="{main}" xmlns:r="{office}">'
        '<sheets><sheet name="Storms" sheetId="1" r:id="r1"/></sheets></workbook>',
        "xl/_rels/workbook.xml.rels": f'<Relationships xmlns="{package}/relationships">'
        f'<Relationship Id="r1" Type="{office}/worksheet" Target="worksheets/sheet1.xml"/></Relationships>',
        "xl/worksheets/sheet1.xml": f'<worksheet xmlns="{main}"><sheetData>'
        f'<row r="1">{inline("A1", "storm")}{inline("B1", "friction")}</row>'
        f'<row r="2">{inline("A2", "first")}<c r="B2"><v>0.6</v></c></row>'
        '<row r="3"><c r="B3"><v>0.5</v></c></row></sheetData></worksheet>',
    }
    with zipfile.ZipFile(tmp_path / "in.xlsx", "w") as file:
        for name, text in parts.items():
            file.writestr(name, '<?xml version="1.0" encoding="UTF-8" standalone="yes"?>' + text)
    read = run(program, tmp_path / "in.xlsx", "-o", "-", "--columns", "SF_sliding")
    (tmp_path / "in.csv").write_text("storm,friction\nfirst,0.6\n,0.5\n")
    assert read == run(program, tmp_path / "in.csv", "-o", "-", "--columns", "SF_sliding")
