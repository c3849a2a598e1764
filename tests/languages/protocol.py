#!/usr/bin/env python3
"""The bytes of targets/PROTOCOL.md are those of programs:

    protocol.py PAGE FIXED_RANDOM PART...      exit code 1 if a program answers otherwise
    protocol.py --update PAGE                  writes the bytes of the page anew, for the version of the runtime

Each PART is a part of the page's graph: a program, or the folder of a part in Python. What the page says that the hub
says is sent, and what the part says must be the page's, byte by byte. For the bytes with a key, FIXED_RANDOM is loaded
into the part: it samples the page's numbers.
"""
import ctypes
import os
import re
import socket
import subprocess
import sys
import tempfile
import time

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../..")
KEY = "eagerx-gen key 1 " + bytes(range(32)).hex() + "\n"
SOON_S = 60


def lines_of(page, fence):
    """[[(direction, bytes)]] of the blocks ```FENCE of the page."""
    with open(page, encoding="utf-8") as file:
        blocks = re.findall(rf"^```{fence}\n(.*?)^```", file.read(), re.S | re.M)
    return [[(line.partition(":")[0].strip(), bytes.fromhex(line.partition(":")[2])) for line in block.splitlines()]
            for block in blocks]


class Part:
    """A part that listens, and its hub's socket."""

    def __init__(self, command, folder, options, environment):
        self.log = open(os.path.join(folder, "log"), "a+b")  # noqa: SIM115  the part writes to its end, wherever we read
        command = [sys.executable, command] if os.path.isdir(command) else [command]
        self.process = subprocess.Popen([*command, *options], stderr=self.log, env={**os.environ, **environment})
        self.hub = self.connect(self.wait_for(rb"listens on (.*?)(, for .*)?\n"))

    @staticmethod
    def connect(address):
        hub = socket.socket(socket.AF_UNIX if address.startswith("unix:") else socket.AF_INET)
        hub.settimeout(SOON_S)
        hub.connect(address[5:] if address.startswith("unix:") else ("127.0.0.1", int(address.rpartition(":")[2])))
        return hub

    def wait_for(self, pattern):
        end = time.monotonic() + SOON_S
        while time.monotonic() < end:
            self.log.seek(0)
            found = re.search(pattern, self.log.read())
            if found:
                return found[1].decode()
            time.sleep(0.01)
        sys.exit(f"FAIL a part never says {pattern}")

    def receive(self, size):
        """This number of bytes, or fewer before the end."""
        data = b""
        while len(data) < size:
            try:
                more = self.hub.recv(size - len(data))
            except ConnectionResetError:  # it has ended, and has not heard all
                break
            if not more:
                break
            data += more
        return data

    def end(self):
        self.hub.close()
        code = self.process.wait(SOON_S)
        self.log.close()
        return code


def converse(command, script, key, fixed_random):
    """Whether the program answers as the script says, and ends well."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "page.key")
        with open(os.open(path, os.O_WRONLY | os.O_CREAT, 0o600), "w", encoding="ascii") as file:
            file.write(KEY)
        options = ["--listen", "127.0.0.1:0", "--key", path] if key else ["--listen", f"unix:{folder}/line"]
        part = Part(command, folder, options, {"LD_PRELOAD": fixed_random, "ASAN_OPTIONS": "verify_asan_link_order=0"} if key else {})
        for number, (direction, data) in enumerate(script):
            if direction == "hub":
                part.hub.sendall(data)
                continue
            answer = part.receive(len(data))
            if answer != data:
                print(f"FAIL {command}: line {number + 1} of the page is {data.hex(' ')}, it says {answer.hex(' ')}")
                part.end()
                return False
        code = part.end()
    print(f"{'FAIL' if code else 'ok  '} {os.path.basename(command)}, {'with' if key else 'without'} a key: {len(script)} lines of "
          f"the page, {sum(len(data) for _, data in script)} bytes, exit code {code}")
    return code == 0


class Sampled:
    """Random numbers of libsodium in this process, for the hub or the part of the page."""

    def __init__(self, sodium):
        self.secret, self.head = 0, 0
        types = [ctypes.CFUNCTYPE(ctypes.c_char_p), ctypes.CFUNCTYPE(ctypes.c_uint32), ctypes.CFUNCTYPE(None),
                 ctypes.CFUNCTYPE(ctypes.c_uint32, ctypes.c_uint32),
                 ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_size_t), ctypes.CFUNCTYPE(ctypes.c_int)]
        self.functions = [types[0](lambda: b"page"), types[1](lambda: 4), types[2](lambda: None), types[3](lambda _: 0),
                          types[4](self.fill), types[5](lambda: 0)]
        self.table = (ctypes.c_void_p * 6)(*(ctypes.cast(each, ctypes.c_void_p) for each in self.functions))
        sodium.randombytes_set_implementation(self.table)

    def fill(self, room, size):
        begin = self.head if size == 24 else self.secret
        ctypes.memmove(room, bytes((begin + i) % 256 for i in range(size)), size)


class Silent:
    """A socket without a listener."""

    def __init__(self, answers):
        self.answers, self.sent = answers, []

    def recv(self, size):
        data, self.answers = self.answers[:size], self.answers[size:]
        return data

    def sendall(self, data):
        self.sent.append(bytes(data))


def sealed_lines(script):
    """The messages of the hub and the part on the page, as tests/trust/sealed.py prints them: three blocks."""
    sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../trust"))
    import sealed  # noqa: PLC0415  it needs libsodium, which a page without a key does not
    sampled = Sampled(sealed.sodium)

    class Page(sealed.Sealed):
        def __init__(self, secret, head, answers, connects):
            sampled.secret, sampled.head = secret, head
            self.silent = Silent(answers)
            try:
                super().__init__(self.silent, bytes(range(32)), connects)
            except sealed.Refused:
                pass  # the other one has not said more yet

        def said(self):
            return b"".join(self.silent.sent)

    hello = Page(0x20, 0x60, b"", True).said()
    answer = Page(0x40, 0x80, hello, False).said()
    hub = Page(0x20, 0x60, answer, True)
    proof = hub.said()[len(hello):]
    part = Page(0x40, 0x80, hello + proof, False)
    greetings = [("hub", hello), ("part", answer), ("hub", proof)]
    before = {"hub": len(hub.silent.sent), "part": len(part.silent.sent)}
    ends = {"hub": hub, "part": part}

    def next_of(who):
        sent = ends[who].silent.sent[before[who]:]
        before[who] += len(sent)
        return (who, b"".join(sent))

    records = []
    for who, data in script[:4]:
        ends[who].send(data)
        records.append(next_of(who))
    hub.end()
    part.end()
    return [greetings, records, [next_of("hub"), next_of("part")]]


def runtime_version():
    """The number that greetings have."""
    with open(os.path.join(ROOT, "runtime/eagerx/version.hpp"), encoding="utf-8") as file:
        major, minor, _ = map(int, re.findall(r"kVersion\w* = (\d+);", file.read()))
    return major * 256 + minor


def plain_lines(script):
    """The lines of the page's session with the greetings, and so the checksums, of this runtime."""
    sys.path.insert(0, os.path.join(ROOT, "targets/python"))
    import eagerx_link as link  # noqa: PLC0415  it needs numpy, which the parts do not
    start, lines = 0, []
    for who, data in script:
        kind, number, payload, _ = link.decode_frame(data.strip(b"\0"))
        if kind in (link.HELLO, link.WELCOME):
            payload = payload[:2] + runtime_version().to_bytes(2, "little") + payload[4:]
            lines.append((who, link.encode_frame(kind, number, payload)))
            start = link.crc32c(payload)
        else:
            lines.append((who, link.encode_frame(kind, number, payload, start)))
    return lines, start


def update(page):
    plain = lines_of(page, "bytes")
    session, start = plain_lines([line for block in plain for line in block])
    with open(page, encoding="utf-8") as file:
        text = file.read()
    text = re.sub(r"(the CRCs of session 7 begin from\s+)0x[0-9a-f]{8}", rf"\g<1>0x{start:08x}", text)
    lines = iter(session)
    text = with_blocks(text, "bytes", [[next(lines) for _ in block] for block in plain], 1024)
    text = with_blocks(text, "sealed", sealed_lines(session), 38)
    with open(page, "w", encoding="utf-8") as file:
        file.write(text)


def with_blocks(text, fence, blocks, width):
    """`text` with these blocks ```FENCE, of lines of at most `width` bytes."""
    def write(_):
        lines = []
        for who, data in next(rest):
            lines += [f"{who + ':':5} {data[i:i + width].hex(' ')}" for i in range(0, len(data), width)]
        return f"```{fence}\n" + "\n".join(lines) + "\n```"

    rest = iter(blocks)
    return re.sub(rf"^```{fence}\n.*?^```", write, text, flags=re.S | re.M)


def main():
    if sys.argv[1] == "--update":
        update(sys.argv[2])
        return 0
    page, fixed_random, *parts = sys.argv[1:]
    plain, with_key = ([line for block in lines_of(page, fence) for line in block] for fence in ("bytes", "sealed"))
    if len(plain) < 6 or len(with_key) < 6 or not parts:
        sys.exit("FAIL the page shows no exchange")
    results = [converse(part, script, key, fixed_random) for part in parts for script, key in ((plain, False), (with_key, True))]
    return 0 if all(results) else 1


if __name__ == "__main__":
    sys.exit(main())
