"""Cuts the fonts of this folder out of STIX Two Text and STIX Two Math.

    npm pack @fontsource/stix-two-text && tar xf fontsource-stix-two-text-*.tgz --one-top-level=text
    npm pack @fontsource/stix-two-math && tar xf fontsource-stix-two-math-*.tgz --one-top-level=math
    pip install fonttools brotli
    python subset.py text/package/files math/package/files

The text faces keep Latin; the mathematical face keeps Greek, italics, operators and what stretches them.
"""

import pathlib
import sys

from fontTools import subset

LATIN = [*range(0x20, 0x7F), *range(0xA0, 0x100), *map(ord, "–—‘’“”…−•")]
MATH = [
    *range(0x20, 0x7F),
    *map(ord, " §°±²³´µ·¨×÷½"),
    *range(0x391, 0x3AA),
    *range(0x3B1, 0x3CA),
    *map(ord, "ϑϕϵ"),
    *range(0x1D434, 0x1D468),
    *range(0x1D6E2, 0x1D71C),
    *map(ord, "ℎ−∗≤≥≠≈→←↑↓⟲√∞∑′″‴ẍÿ̈⋅… ‖\u2061\u2062\u2032"),
]
FACES = (
    ("text", "stix-two-text-latin-400-normal.woff2", "regular.woff2", LATIN),
    ("text", "stix-two-text-latin-600-normal.woff2", "semibold.woff2", LATIN),
    ("math", "stix-two-math-latin-400-normal.woff2", "math.woff2", MATH),
)

if __name__ == "__main__":
    folders = dict(zip(("text", "math"), map(pathlib.Path, sys.argv[1:3])))
    for folder, source, target, characters in FACES:
        options = subset.Options(flavor="woff2", hinting=False, desubroutinize=True, notdef_outline=True)
        options.layout_features = ["kern", "mark", "mkmk", "liga", "lnum", "tnum", "ssty", "dtls"]
        options.name_IDs = [0, 1, 2, 13, 14]
        if folder == "math":
            # Of formulas the browser places marks itself, and kerns nothing.
            options.drop_tables += ["GPOS", "GDEF"]
        font = subset.load_font(folders[folder] / source, options)
        subsetter = subset.Subsetter(options)
        subsetter.populate(unicodes=characters)
        subsetter.subset(font)
        subset.save_font(font, target, options)
