#!/usr/bin/env python3
"""Reads PNG files with nothing but zlib: pixels.py size FILE..."""
import struct
import sys
import zlib


def read(path):
    """(width, height, rows of bytes) of a PNG of 8 bits, red, green, blue, without filters."""
    data = open(path, "rb").read()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", path
    at, head, packed = 8, None, b""
    while at < len(data):
        (size,) = struct.unpack(">I", data[at:at + 4])
        kind, body = data[at + 4:at + 8], data[at + 8:at + 8 + size]
        (crc,) = struct.unpack(">I", data[at + 8 + size:at + 12 + size])
        assert crc == zlib.crc32(kind + body), f"{path}: crc of {kind}"
        if kind == b"IHDR":
            head = struct.unpack(">IIBBBBB", body)
        if kind == b"IDAT":
            packed += body
        at += 12 + size
    width, height = head[:2]
    assert head[2:] == (8, 2, 0, 0, 0), path
    raw, row = zlib.decompress(packed), 3 * width + 1
    assert len(raw) == row * height and not any(raw[::row]), path
    return width, height, [raw[y * row + 1:(y + 1) * row] for y in range(height)]


if __name__ == "__main__":
    for name in sys.argv[2:]:
        print("{}x{}".format(*read(name)[:2]))
