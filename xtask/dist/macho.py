"""Says of a program or library of macOS which version it asks for, which libraries it loads, and whether its signature fits.

    macho.py FILE       prints `minos 11.0`, a line `loads NAME` for each library, and `signature fits`, `is wrong` or `none`
"""

import hashlib
import struct
import sys
from pathlib import Path

HEADER_64 = 0xFEEDFACF
LOAD_DYLIBS = (0xC, 0x8000_0018, 0x8000_001F)
CODE_SIGNATURE = 0x1D
VERSION_MIN = 0x24
BUILD_VERSION = 0x32
CODE_DIRECTORY = 0xFADE0C02
SHA_256 = 2


def fits(data: bytes, signature: bytes) -> bool:
    """True if the hashes of the pages are those of the file up to the signature."""
    (count,) = struct.unpack_from(">I", signature, 8)
    offsets = [struct.unpack_from(">II", signature, 12 + 8 * i)[1] for i in range(count)]
    directories = [at for at in offsets if struct.unpack_from(">I", signature, at)[0] == CODE_DIRECTORY]
    for at in directories:
        hashes, _, _, slots, limit = struct.unpack_from(">5I", signature, at + 16)
        size, kind, _, page = struct.unpack_from("4B", signature, at + 36)
        if kind != SHA_256:
            return False
        for slot in range(slots):
            own = data[slot << page : min((slot + 1) << page, limit)]
            found = signature[at + hashes + slot * size :][:size]
            if hashlib.sha256(own).digest()[:size] != found:
                return False
    return bool(directories)


def main() -> None:
    data = Path(sys.argv[1]).read_bytes()
    magic, _, _, _, commands = struct.unpack_from("<5I", data)
    if magic != HEADER_64:
        sys.exit(f"{sys.argv[1]} is no 64-bit program or library of macOS")
    at, signed = 32, "none"
    for _ in range(commands):
        command, size = struct.unpack_from("<2I", data, at)
        if command in (VERSION_MIN, BUILD_VERSION):
            (version,) = struct.unpack_from("<I", data, at + (12 if command == BUILD_VERSION else 8))
            print(f"minos {version >> 16}.{version >> 8 & 255}")
        elif command in LOAD_DYLIBS:
            (name,) = struct.unpack_from("<I", data, at + 8)
            print("loads " + data[at + name : at + size].split(b"\0")[0].decode())
        elif command == CODE_SIGNATURE:
            start, length = struct.unpack_from("<2I", data, at + 8)
            signed = "fits" if fits(data, data[start : start + length]) else "is wrong"
        at += size
    print("signature " + signed)


main()
