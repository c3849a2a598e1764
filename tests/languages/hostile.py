#!/usr/bin/env python3
"""Strangers and bad lines at parts in other languages: hostile.py PAGE SMALL_ROOM PYTHON_PART PART...

Each PART is a part of the graph of targets/PROTOCOL.md, PAGE, whose lines a part must answer as if nothing had been
before. Nothing hostile is applied, no part crashes, and none hangs. Frames are made with eagerx_link.py of PYTHON_PART;
SMALL_ROOM is small_room.c.
"""
import json
import os
import random
import select
import socket
import sys
import tempfile
import threading
import time

from protocol import KEY, Part, lines_of

PAGE, SMALL_ROOM, PYTHON_PART, *PARTS = sys.argv[1:]
sys.path.insert(0, PYTHON_PART)
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../trust"))
import eagerx_link as link  # noqa: E402
from sealed import Sealed, key_of  # noqa: E402

SCRIPT = [line for block in lines_of(PAGE, "bytes") for line in block]
HELLO, WELCOME = SCRIPT[0][1], SCRIPT[1][1]
with open(os.path.join(PYTHON_PART, "part.json"), encoding="utf-8") as file:
    LAYOUT = json.load(file)
GRAPH, SESSION = int(LAYOUT["hash"], 16), 7
RUNTIME = int(LAYOUT["runtime"].split(".")[0]) * 256 + int(LAYOUT["runtime"].split(".")[1])
CRC_START = link.crc_start_of(GRAPH, RUNTIME, SESSION)
RESET = b"\2" + bytes(17)
MANY = 10_000
failures = 0


def expect(what, condition, found=""):
    global failures
    print(f"ok   {what}" if condition else f"FAIL {what}: {found}", flush=True)
    failures += not condition


class Started(Part):
    """A part, and what it is to answer."""

    def __init__(self, command, has_key=False):
        self.folder = tempfile.TemporaryDirectory()
        self.name = os.path.basename(command)
        self.key = os.path.join(self.folder.name, "a.key")
        with open(os.open(self.key, os.O_WRONLY | os.O_CREAT, 0o600), "w", encoding="ascii") as file:
            file.write(KEY)
        line = ["--listen", "127.0.0.1:0", "--key", self.key] if has_key else ["--listen", f"unix:{self.folder.name}/line"]
        # A sanitizer wants to be the first to be loaded, and need not be.
        small = {"LD_PRELOAD": SMALL_ROOM, "ASAN_OPTIONS": "verify_asan_link_order=0"} if has_key else {}
        super().__init__(command, self.folder.name, line, small)

    def says_the_page(self, script):
        """The difference from the expected output; empty if there is none."""
        for direction, data in script:
            if direction == "hub":
                self.hub.sendall(data)
                continue
            answer = self.receive(len(data))
            if answer != data:
                return f"{answer.hex(' ')} instead of {data.hex(' ')}"
        return ""

    def send(self, data):
        """Whatever it says to that is not heard, and it may have ended."""
        try:
            self.hub.sendall(data)
        except OSError:
            pass

    def is_silent(self):
        return not select.select([self.hub], [], [], 0)[0]

    def ends(self):
        code = self.end()
        self.folder.cleanup()
        return code


def hostile_frame(pick, good):
    """One that no hub of the page sends, and whether a part may answer it."""
    kind = pick.randrange(8)
    if kind == 0:
        return b"\0" + bytes(pick.choices(range(1, 256), k=pick.randrange(80))) + b"\0"
    if kind == 1:  # of another session
        return link.encode_frame(link.REQUEST, 1, RESET, link.crc_start_of(GRAPH, RUNTIME, pick.choice([0, 6, 8, 0xFFFFFFFF])))
    if kind == 2:  # damaged
        bad = bytearray(good)
        bad[pick.randrange(1, len(bad) - 1)] ^= 1 << pick.randrange(8)
        return bytes(bad)
    if kind == 3:  # not its turn
        return link.encode_frame(link.REQUEST, pick.choice([0, 2, 3, 9, 0x80000000, 0xFFFFFFFF]), RESET, CRC_START)
    if kind == 4:  # an unknown kind, or that a hub does not send
        return link.encode_frame(pick.choice([0, 2, 4, 5, 6, 255]), 1, RESET, CRC_START)
    if kind == 5:  # cut off
        return good[:pick.randrange(1, len(good) - 1)] + b"\0"
    if kind == 6:  # a greeting that is none
        return link.encode_frame(link.HELLO, 0, bytes(pick.choices(range(256), k=pick.choice([0, 1, 15, 17, 30]))))
    return b"\0" + b"\5" * pick.choice([60, 3000, 70000]) + b"\0" if pick.random() < 0.05 else bytes(pick.randrange(4))


def frames(command):
    part = Started(command)
    found = part.says_the_page(SCRIPT[:2])
    pick = random.Random(5)
    good = link.encode_frame(link.REQUEST, 1, RESET, CRC_START)
    for _ in range(MANY):
        part.send(hostile_frame(pick, good))
    silent = part.is_silent()
    found = found or part.says_the_page(SCRIPT[2:-1])
    code = part.ends()
    expect(f"{part.name}: {MANY} hostile frames, then the page as if they had not been", not found and silent and code == 0,
           (found, silent, code))


def graphs(command):
    """Hubs of other graphs and versions receive which one this is, and nothing more."""
    part = Started(command)
    pick = random.Random(6)
    good = True
    for _ in range(200):
        graph, runtime = pick.choice([(GRAPH ^ 1 << pick.randrange(64), RUNTIME), (GRAPH, RUNTIME + 256), (0, 0)])
        session = pick.randrange(1 << 32)
        part.send(link.encode_frame(link.HELLO, 0, link.greeting(graph, runtime, session)))
        wanted = link.encode_frame(link.WELCOME, 0, link.greeting(GRAPH, RUNTIME, session))
        good = good and part.receive(len(wanted)) == wanted
        part.send(link.encode_frame(link.REQUEST, 1, RESET, link.crc_start_of(graph, runtime, session)))
    found = part.says_the_page(SCRIPT[:-1])  # whose last line counts what was dropped
    code = part.ends()
    expect(f"{part.name}: hubs of 200 other graphs, then its own", good and not found and code == 0, (good, found, code))


def no_greeting(command):
    part = Started(command)
    part.send(b"GET / HTTP/1.1\r\n" * 5000)
    closed = part.receive(1) == b""
    code = part.ends()
    expect(f"{part.name}: a peer that is not a hub is not served for ever", closed and code == 1, (closed, code))


def slow(command):
    """A greeting byte by byte; and who says nothing makes room for who does."""
    part = Started(command)
    for byte in HELLO + SCRIPT[2][1]:
        part.send(bytes([byte]))
        time.sleep(0.005)
    found = part.receive(len(WELCOME)) == WELCOME and part.receive(len(SCRIPT[3][1])) == SCRIPT[3][1]
    found = found and not part.says_the_page(SCRIPT[4:])
    code = part.ends()
    expect(f"{part.name}: a hub that sends a byte at a time", found and code == 0, (found, code))
    silent = Started(command)
    first = silent.hub
    silent.wait_for(rb"(note: a peer said nothing)")
    silent.hub = Part.connect(f"unix:{silent.folder.name}/line")
    found = silent.says_the_page(SCRIPT)
    code = silent.ends()
    first.close()
    expect(f"{silent.name}: a peer that says nothing is dropped, and the hub behind it served", not found and code == 0, (found, code))


def wrong_commands(command):
    for what, payload in (("an unknown command", b"\x63"), ("a step before a reset", b"\1\0"),
                          ("a safe step of a graph that has none", RESET + b"\4\0")):
        part = Started(command)
        part.says_the_page(SCRIPT[:2])
        part.send(link.encode_frame(link.REQUEST, 1, payload, CRC_START))
        closed = part.receive(200)[-1:] in (b"", b"\0")  # an answer, or nothing, and the end
        code = part.ends()
        expect(f"{part.name}: {what} ends it", closed and code == 1, (closed, code))


def cut_off(command, every):
    """The line ends anywhere: in a greeting, a frame, a record."""
    said = b"".join(data for direction, data in SCRIPT if direction == "hub")
    codes = set()
    for size in range(0, len(said), every):
        part = Started(command)
        part.send(said[:size])
        codes.add(part.ends() if size else (part.send(HELLO[:1]), part.ends())[1])
    expect(f"{os.path.basename(command)}: cut off after each of {(len(said) - 1) // every + 1} sizes", codes == {0}, codes)


def reads_late(command):
    """A hub that asks for an answer again and again, and reads none for a while: what a part has no time for is dropped,
    and never a piece of a sealed record."""
    part = Started(command, has_key=True)
    part.hub.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
    line = Sealed(part.hub, key_of(part.key), connects=True)
    line.send(HELLO)
    greeted = line.receive() == WELCOME
    request, answer = SCRIPT[2][1], SCRIPT[3][1]
    asked = 5000

    def ask():
        line.send(request * asked)
        line.send(SCRIPT[4][1])

    asking = threading.Thread(target=ask)
    asking.start()
    time.sleep(3)
    heard = 0
    while (said := line.receive()) == answer:
        heard += 1
    asking.join()
    line.end()
    code = part.ends()
    expect(f"{part.name}: a hub with a key that does not read for 3 s, {heard} of {asked} answers and then the next one",
           greeted and 0 < heard < asked and said == SCRIPT[5][1] and code == 0, (greeted, heard, said.hex(" "), code))


for each in PARTS:
    reads_late(each)
    frames(each)
    graphs(each)
    no_greeting(each)
    slow(each)
    wrong_commands(each)
    cut_off(each, 7 if os.path.isdir(each) else 1)
sys.exit(1 if failures else 0)
