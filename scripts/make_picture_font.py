#!/usr/bin/env python3
"""Writes data/drawing/detail/glyphs.hpp: the letters of `meniscus picture`, out of X11's fixed font 9x15,
which is in the public domain.

Usage: make_picture_font.py /usr/share/fonts/X11/misc/9x15-ISO8859-1.pcf.gz   (Debian's xfonts-base)
"""
import gzip
import struct
import sys
from pathlib import Path

METRICS, BITMAPS, ENCODINGS = 4, 8, 32
FIRST, LAST = 32, 126
HEAD = """// clang-format off
// The letters of pictures, from space to tilde: X11's fixed font 9x15, in the public domain. Written by
// scripts/make_picture_font.py; do not edit.
#pragma once

#include <cstdint>

namespace meniscus {

inline constexpr int glyph_width = 9;
inline constexpr int glyph_height = 15;
inline constexpr char first_glyph = ' ';

/// Rows from above; the leftmost pixel is the highest of nine bits.
inline constexpr std::uint16_t glyphs[][glyph_height] = {
"""


def tables(data):
    """Each table's byte order and offset of its body."""
    for t in range(struct.unpack_from("<I", data, 4)[0]):
        kind, form, _, offset = struct.unpack_from("<4I", data, 8 + 16 * t)
        yield kind, (form, ">" if form & 4 else "<", offset + 4)


def glyph_rows(data, found, glyph):
    """Rows of nine bits of one glyph of a font all of whose glyphs fill their cell."""
    form, order, at = found[BITMAPS]
    count = struct.unpack_from(order + "I", data, at)[0]
    start = at + 4 + struct.unpack_from(order + "I", data, at + 4 + 4 * glyph)[0] + 4 * count + 16
    metrics = found[METRICS][2] + 2 + 5 * glyph
    left, right, _, above, below = (byte - 128 for byte in data[metrics:metrics + 5])
    stride = 1 << (form & 3)
    rows = [0] * 15
    for row in range(above + below):
        width_bytes = (right - left + 7) // 8
        bits = data[start + row * (-(-width_bytes // stride) * stride):][:width_bytes]
        value = int.from_bytes(bits, "big") >> (8 * width_bytes - (right - left))
        rows[12 - above + row] = value << (9 - right)
    return rows


def main(font):
    data = gzip.open(font).read()
    found = dict(tables(data))
    assert found[METRICS][0] & 0x100 and found[BITMAPS][0] & 8, "another kind of PCF"
    _, order, at = found[ENCODINGS]
    first = struct.unpack_from(order + "H", data, at)[0]
    lines = []
    for code in range(FIRST, LAST + 1):
        glyph = struct.unpack_from(order + "H", data, at + 10 + 2 * (code - first))[0]
        rows = ", ".join(f"0x{row:03x}" for row in glyph_rows(data, found, glyph))
        lines.append(f"    {{{rows}}},\n")
    target = Path(__file__).parents[1] / "data/drawing/detail/glyphs.hpp"
    target.parent.mkdir(exist_ok=True)
    target.write_text(HEAD + "".join(lines) + "};\n\n} // namespace meniscus\n")


main(sys.argv[1])
