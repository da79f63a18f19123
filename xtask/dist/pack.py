"""Packs a folder so that the same files give the same bytes: sorted names, one date, no owner.

    pack.py FOLDER ARCHIVE      ARCHIVE ends with .tar.xz or .zip; the folder's own name stands before every file
"""

import io
import lzma
import sys
import tarfile
import zipfile
from pathlib import Path

# The first that a zip file can hold.
DATE = (1980, 1, 1, 0, 0, 0)
SECONDS = 315532800


def mode(path: Path) -> int:
    return 0o755 if path.is_dir() or path.stat().st_mode & 0o100 else 0o644


def tar(folder: Path, files: list[Path], archive: Path) -> None:
    packed = io.BytesIO()
    with tarfile.open(fileobj=packed, mode="w", format=tarfile.GNU_FORMAT) as tar:
        for path in files:
            info = tarfile.TarInfo(path.relative_to(folder.parent).as_posix())
            info.mtime, info.mode = SECONDS, mode(path)
            if path.is_dir():
                info.type = tarfile.DIRTYPE
                tar.addfile(info)
            else:
                info.size = path.stat().st_size
                with path.open("rb") as file:
                    tar.addfile(info, file)
    archive.write_bytes(lzma.compress(packed.getvalue(), preset=9))


def zip_(folder: Path, files: list[Path], archive: Path) -> None:
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as packed:
        for path in files:
            if path.is_dir():
                continue
            info = zipfile.ZipInfo(path.relative_to(folder.parent).as_posix(), DATE)
            info.external_attr = (0o100000 | mode(path)) << 16
            info.compress_type = zipfile.ZIP_DEFLATED
            packed.writestr(info, path.read_bytes())


def main() -> None:
    folder, archive = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
    files = [folder, *sorted(folder.rglob("*"))]
    (zip_ if archive.suffix == ".zip" else tar)(folder, files, archive)


main()
