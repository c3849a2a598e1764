#!/usr/bin/env python3
"""The line of a part in Python: known answers, and hostile bytes: link_test.py PART_FOLDER"""
import contextlib
import io
import os
import random
import socket
import sys
import threading

FOLDER = sys.argv[1]
sys.path.insert(0, FOLDER)

import eagerx_line as line  # noqa: E402
import eagerx_link as link  # noqa: E402
import eagerx_part  # noqa: E402
import nodes  # noqa: E402

LAYOUT = eagerx_part.read_layout(FOLDER)
GRAPH = int(LAYOUT["hash"], 16)
MAJOR, MINOR = (int(text) for text in LAYOUT["runtime"].split("."))
RUNTIME = MAJOR * 256 + MINOR
failures = 0


def expect(what, condition, found=""):
    global failures
    print(f"ok   {what}" if condition else f"FAIL {what}: {found}")
    failures += not condition


class Served:
    """A part on one end of a pair of sockets; what ended it is in `end`."""

    def __init__(self):
        self.hub, part = socket.socketpair()
        self.hub.settimeout(30)
        self.end = None
        self._part = part
        self._thread = threading.Thread(target=self._serve, daemon=True)
        self._thread.start()

    def _serve(self):
        try:
            with contextlib.redirect_stderr(io.StringIO()):
                eagerx_part.serve(line.Port(self._part.fileno(), False, self._part), LAYOUT, nodes.NODES)
        except Exception as error:  # noqa: BLE001  what ended it is what is asked
            self.end = error
        self._part.close()

    def send(self, data):
        with contextlib.suppress(OSError):  # it may have ended
            self.hub.sendall(data)

    def frame(self):
        """The next frame of the part; nothing if it has ended."""
        data = b""
        while True:
            byte = self.hub.recv(1)
            if not byte:
                return None
            if byte == b"\0":
                if data:
                    return link.decode_frame(data)
                continue
            data += byte

    def greet(self, session=7, graph=GRAPH):
        self.send(link.encode_frame(link.HELLO, 0, link.greeting(graph, RUNTIME, session)))
        return self.frame()

    def request(self, number, payload, session=7):
        self.send(link.encode_frame(link.REQUEST, number, payload, link.crc_start_of(GRAPH, RUNTIME, session)))

    def over(self):
        self.hub.shutdown(socket.SHUT_WR)
        self._thread.join(30)
        return self.end


def known_answers():
    expect("CRC-32C of RFC 3720", link.crc32c(b"123456789") == 0xE3069283 and link.crc32c(bytes(32)) == 0x8A9136AA)
    pick = random.Random(1)
    for _ in range(2000):
        size = pick.choice([0, 1, 2, 9, 253, 254, 255, 256, 507, 508, 509, 1033, 3000])
        data = bytes(pick.choices(range(256), k=size)) if pick.random() < 0.5 else bytes(pick.choices([0, 1], k=size))
        if pick.random() < 0.3:
            data = data.replace(b"\0", b"\1")
        encoded = link.cobs_encode(data)
        if 0 in encoded or link.cobs_decode(encoded) != data or len(encoded) > size + size // 254 + 1:
            expect("COBS gives back what it was given", False, data.hex())
            return
        cut = pick.randrange(size + 1)
        if link.crc32c(data[cut:], link.crc32c(data[:cut])) != link.crc32c(data):
            expect("a CRC continues from another one", False, data.hex())
            return
    expect("COBS gives back what it was given, and a CRC continues: 2000 texts", True)


def hostile_frames():
    """10,000 frames that no hub sends: nothing of them is applied, and the session continues."""
    served = Served()
    served.greet()
    pick = random.Random(2)
    good = link.encode_frame(link.REQUEST, 1, b"\2" + bytes(17), link.crc_start_of(GRAPH, RUNTIME, 7))
    for _ in range(10_000):
        kind = pick.randrange(5)
        if kind == 0:
            served.send(b"\0" + bytes(pick.choices(range(1, 256), k=pick.randrange(60))) + b"\0")
        elif kind == 1:  # of another session
            served.send(link.encode_frame(link.REQUEST, 1, b"\2" + bytes(17), link.crc_start_of(GRAPH, RUNTIME, 8)))
        elif kind == 2:  # damaged
            bad = bytearray(good)
            bad[pick.randrange(1, len(bad) - 1)] ^= 1 << pick.randrange(8)
            served.send(bytes(bad))
        elif kind == 3:  # not its turn
            served.request(pick.choice([0, 3, 9, 0xFFFFFFFF]), b"\2" + bytes(17))
        else:
            served.send(b"\0" + b"\x05" * pick.choice([3000, 70000]) + b"\0" if pick.random() < 0.01 else b"\0\0")
    served.request(1, b"\3")  # finish: nothing else was heard
    kind, number, _, _ = served.frame()
    expect("10,000 hostile frames, and the first request is still number 1", (kind, number) == (link.ANSWER, 1), (kind, number))
    end = served.over()
    expect("and the line ends as any", isinstance(end, line.LinkClosed), repr(end))


def refused():
    served = Served()
    served.send(b"GET / HTTP/1.1\r\n" * 5000)
    end = served.over()
    expect("a peer that is not a hub", isinstance(end, link.ProtocolError) and "no greeting" in str(end), repr(end))
    served = Served()
    welcome = served.greet(graph=GRAPH ^ 1)
    answered = int.from_bytes(welcome[2][4:12], "little")
    expect("a hub of another graph receives which one this is", answered == GRAPH, hex(answered))
    served.request(1, b"\2" + bytes(17))
    end = served.over()
    expect("and nothing that it sends is applied", isinstance(end, line.LinkClosed), repr(end))
    served = Served()
    served.greet()
    served.request(1, b"\x63")
    end = served.over()
    expect("an unknown command", isinstance(end, link.ProtocolError) and "99" in str(end), repr(end))
    served = Served()
    served.greet()
    served.request(1, b"\1\0")
    end = served.over()
    expect("a step before a reset", isinstance(end, link.ProtocolError), repr(end))
    for bad in (b"", b"\x05", b"\x00", bytes(range(1, 9))):
        try:
            link.decode_frame(bad)
            expect(f"{bad!r} is not a frame", False)
        except link.FrameError as error:
            expect(f"{bad!r} is not a frame: {error}", True)


def messages():
    """Messages in both directions have the right type, or are rejected."""
    layout = {"name": "a/b", "bytes": 3, "keep": 2, "shape": [3], "dtype": "bool"}
    flags = eagerx_part.Message(layout)
    flags.receive(4, b"\0\5\1")
    expect("a bool of the line is 0 or 1", flags.window(5, 1).tobytes() == b"\0\1\1", flags.ring)
    small = eagerx_part.Message({**layout, "dtype": "uint8"})
    expect("whole numbers that fit are taken", small.set(0, [1, 2, 255], "x") == b"\1\2\xff")
    for value in ([1, 2, 256], [1.0, 2.0, 3.0], [1, 2], "abc", None):
        try:
            small.set(0, value, "x")
            expect(f"{value!r} is not a uint8 [3]", False)
        except eagerx_part.PartError as error:
            expect(f"{value!r} is not a uint8 [3]: {error}", True)


def on_the_line():
    """A part's greeting twice, and its answer twice: nothing is done twice."""
    served = Served()
    served.greet()
    served.greet()
    served.request(1, b"\3")
    first = served.frame()
    served.request(1, b"\3")
    expect("a duplicate gets the same answer", first == served.frame())
    end = served.over()
    expect("and is not carried out", isinstance(end, line.LinkClosed), repr(end))


def addresses():
    for address in ("0.0.0.0:0", "nonsense", ":x"):
        try:
            line.listen(address)
            expect(f"{address} is refused", False)
        except OSError as error:
            expect(f"{address} is refused: {error.strerror}", True)
    os.makedirs(os.path.join(FOLDER, "taken"), exist_ok=True)
    try:
        line.listen("unix:" + os.path.join(FOLDER, "taken"))
        expect("what is not a socket stays", False)
    except OSError as error:
        expect(f"what is not a socket stays: {error.strerror}", os.path.isdir(os.path.join(FOLDER, "taken")))


known_answers()
hostile_frames()
refused()
messages()
on_the_line()
addresses()
sys.exit(1 if failures else 0)
