"""Reads MCAP (https://mcap.dev/spec) as far as a file goes: what a program that was killed has left, too."""
import json
import struct
import zlib

MAGIC = b"\x89MCAP0\r\n"
SCHEMA, CHANNEL, MESSAGE, CHUNK = 3, 4, 5, 6


def records(data):
    """(op, content) of all complete records."""
    at = 0
    while at + 9 <= len(data):
        op, size = struct.unpack_from("<BQ", data, at)
        if at + 9 + size > len(data):
            return
        yield op, data[at + 9 : at + 9 + size]
        at += 9 + size
        if data[at:] == MAGIC:
            return


def text(content, at):
    size = struct.unpack_from("<I", content, at)[0]
    return content[at + 4 : at + 4 + size].decode(), at + 4 + size


class Recording:
    """`messages`: (topic, sequence, time in ns, JSON); `chunks`: how many; `is_complete`: has its end."""

    def __init__(self, data):
        assert data[:8] == MAGIC, "no MCAP file"
        self.is_complete = data[-8:] == MAGIC and len(data) > 16
        self.schemas, self.topics, self.messages, self.chunks = {}, {}, [], 0
        for op, content in records(data[8:]):
            if op == SCHEMA:
                name, at = text(content, 2)
                encoding, at = text(content, at)
                self.schemas[name] = (encoding, text(content, at)[0])
            elif op == CHANNEL:
                self.topics[struct.unpack_from("<H", content)[0]] = text(content, 4)[0]
            elif op == CHUNK:
                self.read_chunk(content)

    def read_chunk(self, content):
        first, last, size, crc = struct.unpack_from("<QQQI", content)
        compression, at = text(content, 28)
        inner = content[at + 8 :]
        assert compression == "" and len(inner) == size and zlib.crc32(inner) == crc, "a damaged chunk"
        self.chunks += 1
        for op, message in records(inner):
            assert op == MESSAGE, op
            channel, sequence, time, published = struct.unpack_from("<HIQQ", message)
            assert first <= time == published <= last
            self.messages.append((self.topics[channel], sequence, time, json.loads(message[22:])))
