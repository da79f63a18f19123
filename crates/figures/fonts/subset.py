"""Cuts the two fonts of this folder out of STIX Two Text.

    npm pack @fontsource/stix-two-text && tar xf fontsource-stix-two-text-*.tgz
    pip install fonttools brotli
    python subset.py package/files

Each face is merged from the `latin` and `greek` files, without hinting, kerning and substitutions. The text face has
no signs for "at most" and "at least": they are composed from its own less, greater and minus signs.
"""

import pathlib
import sys

from fontTools.fontBuilder import FontBuilder
from fontTools.pens.recordingPen import DecomposingRecordingPen
from fontTools.pens.transformPen import TransformPen
from fontTools.pens.ttGlyphPen import TTGlyphPen
from fontTools.ttLib import TTFont

LATIN = "".join(map(chr, [*range(0x20, 0x7F), *range(0xA0, 0x180)])) + "–—‘’“”…′″€−"
# Italic are the letters of mathematics, and what may stand between them; another letter is drawn upright.
MATHEMATICS = "".join(map(chr, range(0x20, 0x7F))) + "−"
GREEK = "ΑΒΓΔΕΖΗΘΙΚΛΜΝΞΟΠΡΣΤΥΦΧΨΩαβγδεζηθικλμνξοπρςστυφχψω"
MINUS = 0x2212
COMPOSED = {"≤": "<", "≥": ">"}


def recordings(files, style):
    """Character -> (advance, outline) of every wanted character."""
    glyphs = {}
    latin = MATHEMATICS if style == "italic" else LATIN
    for part, wanted in (("latin", latin), ("greek", GREEK)):
        font = TTFont(files / f"stix-two-text-{part}-400-{style}.woff2")
        outlines, names = font.getGlyphSet(), font.getBestCmap()
        for char in wanted:
            if ord(char) in names and ord(char) not in glyphs:
                pen = DecomposingRecordingPen(outlines)
                outlines[names[ord(char)]].draw(pen)
                glyphs[ord(char)] = (outlines[names[ord(char)]].width, [(0, pen)])
    for char, base in COMPOSED.items():
        width, [(_, sign)] = glyphs[ord(base)]
        glyphs[ord(char)] = (width, [(70, sign), (-235, glyphs[MINUS][1][0][1])])
    return glyphs


def build(files, style, target):
    glyphs = recordings(files, style)
    outlines, metrics, names = {}, {}, {}
    empty = TTGlyphPen(None)
    outlines[".notdef"], metrics[".notdef"] = empty.glyph(), (500, 0)
    for code, (width, parts) in sorted(glyphs.items()):
        pen = TTGlyphPen(None)
        for rise, recording in parts:
            recording.replay(TransformPen(pen, (1, 0, 0, 1, 0, rise)))
        name = f"uni{code:04X}"
        outlines[name], names[code] = pen.glyph(), name
        metrics[name] = (width, 0)
    font = FontBuilder(1000, isTTF=True)
    font.setupGlyphOrder(list(outlines))
    font.setupCharacterMap(names)
    font.setupGlyf(outlines)
    for name, (width, _) in metrics.items():
        metrics[name] = (width, outlines[name].xMin if outlines[name].numberOfContours else 0)
    font.setupHorizontalMetrics(metrics)
    font.setupHorizontalHeader(ascent=762, descent=-238)
    font.setupNameTable({"familyName": "STIX Two Text subset", "styleName": style.capitalize()})
    font.setupOS2()
    font.setupPost(keepGlyphNames=False)
    font.font["head"].created = font.font["head"].modified = 0
    font.font.recalcTimestamp = False
    font.save(target)


if __name__ == "__main__":
    for style, target in (("normal", "regular.ttf"), ("italic", "italic.ttf")):
        build(pathlib.Path(sys.argv[1]), style, target)
