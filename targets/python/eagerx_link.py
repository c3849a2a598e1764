"""Connection of a part to the hub of its graph: frames, checksums and sessions, as specified in targets/PROTOCOL.md.

This module does not depend on a graph. It raises FrameError for an invalid frame.
"""
import struct

import numpy as np

from eagerx_line import say

PROTOCOL = 1
HELLO, WELCOME, REQUEST, ANSWER = 1, 2, 3, 4
FRAME_BYTES = 9  # bytes of a frame besides its payload: kind, number, CRC
GREETING_BYTES = 16
MOST_BEFORE_GREETING = 65536  # bytes that a socket may receive before a greeting
_RUN = 254  # most bytes after one length byte of COBS
_HEADER = struct.Struct("<BI")
_CRC = struct.Struct("<I")
_GREETING = struct.Struct("<BBHQI")


class FrameError(Exception):
    """The bytes are not a frame of this session."""


class SessionOver(Exception):
    """The hub has begun another session."""


class ProtocolError(Exception):
    """The peer is not a hub of this graph, or not a hub."""


def _tables(most):
    """tables[k][b]: effect of byte b on a CRC when k bytes follow it."""
    one = np.arange(256, dtype=np.uint32)
    for _ in range(8):
        one = np.where(one & 1, one >> 1 ^ np.uint32(0x82F63B78), one >> 1)
    tables = np.empty((most, 256), np.uint32)
    tables[0] = one
    for k in range(1, most):
        tables[k] = tables[k - 1] >> 8 ^ one[tables[k - 1] & 0xFF]
    return tables


_TABLES = _tables(1100)


def crc32c(data, start=0):
    """CRC-32C of bytes; `start` is the CRC of the bytes before them. The effects of bytes are independent of each
    other."""
    crc = ~start & 0xFFFFFFFF
    for begin in range(0, len(data), len(_TABLES)):
        part = bytes(data[begin:begin + len(_TABLES)])
        if len(part) < 4:
            for byte in part:
                crc = crc >> 8 ^ int(_TABLES[0][crc & 0xFF ^ byte])
            continue
        mixed = np.frombuffer(part, np.uint8).copy()
        mixed[:4] ^= np.frombuffer(_CRC.pack(crc), np.uint8)
        crc = int(np.bitwise_xor.reduce(_TABLES[np.arange(len(part) - 1, -1, -1), mixed]))
    return ~crc & 0xFFFFFFFF


def cobs_encode(data):
    """Encodes bytes so that they contain no zero. The terminating zero is not included."""
    out = bytearray()
    runs = bytes(data).split(b"\0")
    for i, run in enumerate(runs):
        full = False
        while len(run) >= _RUN:
            out.append(_RUN + 1)
            out += run[:_RUN]
            run = run[_RUN:]
            full = True
        if full and not run and i + 1 == len(runs):
            break
        out.append(len(run) + 1)
        out += run
    return bytes(out)


def cobs_decode(data):
    """Bytes that cobs_encode() encoded."""
    out = bytearray()
    at = 0
    while at < len(data):
        run = data[at]
        if run == 0 or at + run > len(data):
            raise FrameError(f"a run of {run} bytes at byte {at} of {len(data)}")
        out += data[at + 1:at + run]
        at += run
        if run <= _RUN and at < len(data):
            out.append(0)
    return bytes(out)


def encode_frame(kind, number, payload, crc_start=0):
    """Frame as transmitted."""
    body = _HEADER.pack(kind, number) + payload
    return b"\0" + cobs_encode(body + _CRC.pack(crc32c(body, crc_start))) + b"\0"


def decode_frame(encoded):
    """Decodes the bytes between two zeros: (kind, number, payload, whole body). check_crc() checks the CRC."""
    body = cobs_decode(encoded)
    if len(body) < FRAME_BYTES:
        raise FrameError(f"{len(body)} bytes are too short for a frame")
    return (*_HEADER.unpack_from(body), body[_HEADER.size:-_CRC.size], body)


def check_crc(body, crc_start):
    if _CRC.unpack_from(body, len(body) - _CRC.size)[0] != crc32c(body[:-_CRC.size], crc_start):
        raise FrameError("its checksum is another one")


def greeting(graph, runtime, session, status=0):
    """Payload of hello and welcome."""
    return _GREETING.pack(PROTOCOL, status, runtime, graph, session)


def crc_start_of(graph, runtime, session):
    """Initial value of the checksums of requests and answers in a session."""
    return crc32c(greeting(graph, runtime, session))


class PartLink:
    """Side of a part, which only answers requests: it sends an answer when it needs more data than it has, and repeats
    the answer to a duplicate request."""

    def __init__(self, port, graph, runtime, most_to_part, most_to_hub, depth=1):
        self.port, self.graph, self.runtime = port, graph, runtime
        self.most_to_hub = most_to_hub
        self.depth = depth  # requests that the hub sends without waiting, and answers that the part keeps
        payload = max(most_to_part, GREETING_BYTES) + FRAME_BYTES
        self.most_encoded = payload + payload // _RUN + 1
        self.damaged = 0  # dropped frames
        self._incoming = bytearray()
        self._skipping = False  # until the end of a frame that is too long
        self._before_greeting = 0
        self._session = None  # session number
        self._number = 0  # of the current request; 0: none yet
        self._crc_start = 0
        self._request, self._read = b"", 0
        self._answer = bytearray()
        self._kept = {}  # most recent answers, by number
        self._greeted = False

    def wait_for_hub(self):
        """Waits until a session begins."""
        while not self._greeted:
            try:
                self._wait_for_request()
            except SessionOver:
                pass
        self._greeted = False

    def read(self, size):
        """Reads this number of bytes of the hub's messages."""
        parts = []
        while size > 0:
            if self._read == len(self._request):
                self._next_request()
                continue
            part = self._request[self._read:self._read + size]
            self._read += len(part)
            size -= len(part)
            parts.append(part)
        return parts[0] if len(parts) == 1 else b"".join(parts)

    def write(self, data):
        """Adds bytes for the hub. They are sent when the next request is needed, or a frame is full."""
        at = 0
        while at < len(data):
            room = self.most_to_hub - len(self._answer)
            self._answer += data[at:at + room]
            at += room
            if at < len(data):
                self._next_request()

    def _next_request(self):
        if self._read != len(self._request):
            raise ProtocolError("the hub sent what is not due")
        if self._number > 0:
            frame = encode_frame(ANSWER, self._number, bytes(self._answer), self._crc_start)
            self._kept[self._number] = frame
            while len(self._kept) > self.depth:
                del self._kept[next(iter(self._kept))]
            self.port.write(frame)
        self._answer.clear()
        self._wait_for_request()

    def _frames(self):
        """Next bytes between two zeros that may be a frame."""
        while True:
            end = self._incoming.find(0)
            if end >= 0:
                encoded = bytes(self._incoming[:end])
                del self._incoming[:end + 1]
                too_long = self._skipping or len(encoded) > self.most_encoded
                self._skipping = False
                if too_long:
                    self.damaged += 1
                elif encoded:
                    return encoded
                continue
            if len(self._incoming) > self.most_encoded:
                self._incoming.clear()
                self._skipping = True
            data = self.port.read()
            if self._session is None and not self.port.knows_peer:
                self._before_greeting += len(data)
                if self._before_greeting > MOST_BEFORE_GREETING:
                    raise ProtocolError(f"{self._before_greeting} bytes came, and no greeting of a hub is among them")
            self._incoming += data

    def _wait_for_request(self):
        while True:
            try:
                kind, number, payload, body = decode_frame(self._frames())
                if kind == HELLO:
                    check_crc(body, 0)
                    self._greet(payload)
                    continue
                if kind != REQUEST or self._session is None:
                    raise FrameError(f"a frame of kind {kind}")
                check_crc(body, self._crc_start)
            except FrameError:
                self.damaged += 1
                continue
            if number == (1 if self._number == 0xFFFFFFFF else self._number + 1):
                self._number, self._request, self._read = number, payload, 0
                return
            if number in self._kept:
                self.port.write(self._kept[number])

    def _greet(self, payload):
        """Answers a greeting. Raises SessionOver if a new session begins."""
        if len(payload) != GREETING_BYTES:
            raise FrameError(f"a greeting of {len(payload)} bytes")
        protocol, _, runtime, graph, session = _GREETING.unpack(payload)
        same = session == self._session
        if same and self._number > 0:
            return  # a late duplicate
        self.port.write(encode_frame(WELCOME, 0, greeting(self.graph, self.runtime, session)))
        if same:
            return
        self._number, self._request, self._read = 0, b"", 0
        self._answer.clear()
        self._kept.clear()
        self._session = None
        self._before_greeting = 0
        if (protocol, runtime, graph) != (PROTOCOL, self.runtime, self.graph):
            say(f"note: a hub of another graph or version was refused: {graph:#018x}, this part {self.graph:#018x}")
            return
        self._session = session
        self._crc_start = crc_start_of(self.graph, self.runtime, session)
        self._greeted = True
        raise SessionOver
