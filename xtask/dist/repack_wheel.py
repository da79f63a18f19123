"""Packs a wheel anew so that the same sources give the same bytes: its bill of materials names no folder of the machine.

repack_wheel.py WHEEL ROOT      ROOT is the folder of the sources, whose name is left out
"""

import base64
import hashlib
import sys
import zipfile
from pathlib import Path

# The first that a zip file can hold.
DATE = (1980, 1, 1, 0, 0, 0)


def main() -> None:
    wheel, root = Path(sys.argv[1]), str(Path(sys.argv[2]).resolve())
    with zipfile.ZipFile(wheel) as packed:
        infos = packed.infolist()
        files = {info.filename: packed.read(info) for info in infos}
    modes = {info.filename: info.external_attr for info in infos}
    for name in files:
        if "/sboms/" in name:
            files[name] = files[name].replace(f"file://{root}/".encode(), b"file:///")
    record = next(name for name in files if name.endswith(".dist-info/RECORD"))

    def line(name: str) -> str:
        digest = base64.urlsafe_b64encode(hashlib.sha256(files[name]).digest()).rstrip(b"=").decode()
        return f"{name},sha256={digest},{len(files[name])}\n"

    files[record] = ("".join(line(name) for name in files if name != record) + f"{record},,\n").encode()
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as packed:
        for name, content in files.items():
            info = zipfile.ZipInfo(name, DATE)
            info.external_attr = modes[name]
            info.compress_type = zipfile.ZIP_DEFLATED
            packed.writestr(info, content)


main()
