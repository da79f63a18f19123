"""What others' crates a program is made of: their licence texts in one file, and a bill of materials (CycloneDX 1.5).

    third_party.py NAME VERSION TREE TEXTS BILL      with the output of `cargo metadata` on standard input

TREE has the crates of the program, one `name version` a line, as `cargo tree` prints them. A crate without a text of its own must be
known here with the reason.
"""

import json
import sys
from pathlib import Path

# Crates whose packages carry no licence text. Each is under a licence whose text stands in this file through another crate.
WITHOUT_TEXT = json.loads((Path(__file__).parent / "without-licence-text.json").read_text())

# What a package calls the text of its licence.
NAMES = ("LICENSE", "LICENCE", "COPYING", "UNLICENSE", "NOTICE", "COPYRIGHT")


def texts(folder: Path) -> list[Path]:
    return sorted(path for path in folder.iterdir() if path.is_file() and path.name.upper().startswith(NAMES))


def main() -> None:
    name, version, tree, into, bill = sys.argv[1:]
    wanted = {tuple(line.split()) for line in Path(tree).read_text().splitlines() if line.strip()}
    packages = json.load(sys.stdin)["packages"]
    found = [p for p in packages if (p["name"], p["version"]) in wanted and p["source"]]
    found.sort(key=lambda p: (p["name"], p["version"]))

    missing, parts = [], []
    for package in found:
        head = f"{package['name']} {package['version']}   {package['license'] or 'see below'}"
        own = texts(Path(package["manifest_path"]).parent)
        if not own and package["name"] not in WITHOUT_TEXT:
            missing.append(head)
        body = "\n\n".join(path.read_text(errors="replace").strip() for path in own)
        parts.append(f"{head}\n{'=' * len(head)}\n\n{body or WITHOUT_TEXT.get(package['name'], '')}\n")
    if missing:
        sys.exit("no licence text in: " + "; ".join(missing))
    intro = f"{name} {version} contains the work of others, under these licences. Its own is MIT OR Apache-2.0.\n\n\n"
    Path(into).write_text(intro + "\n\n".join(parts))

    components = [
        {
            "type": "library",
            "bom-ref": f"pkg:cargo/{p['name']}@{p['version']}",
            "name": p["name"],
            "version": p["version"],
            "purl": f"pkg:cargo/{p['name']}@{p['version']}",
            **({"licenses": [{"expression": p["license"].replace("/", " OR ")}]} if p["license"] else {}),
        }
        for p in found
    ]
    document = {
        "bomFormat": "CycloneDX",
        "specVersion": "1.5",
        "version": 1,
        "metadata": {"component": {"type": "application", "name": name, "version": version}},
        "components": components,
    }
    Path(bill).write_text(json.dumps(document, indent=1) + "\n")


main()
