"""Random faults while QEMU runs an image: numbers of the program become NaN, infinite, huge, denormal, or others.

Every few milliseconds QEMU is stopped, wherever it is, and a word of the program's object that looks like a float, or like
the high word of a double, is replaced. Integers, addresses and flags do not look like one: a bound holds for all values of
numbers, but not for a program whose schedule or code was overwritten.
"""
import random
import select
import socket
import struct
import subprocess

FLOATS = (float("nan"), float("inf"), -float("inf"), 1e30, -1e30, 1e-40, 0.0, -0.0)
LONGEST_S = 0.01  # between two faults
LOOKS = 4  # for a word to replace
CHUNK = 512  # bytes of each


class Stub:
    """A client of QEMU's gdbstub: https://sourceware.org/gdb/current/onlinedocs/gdb.html/Remote-Protocol.html"""

    def __init__(self, path):
        self.line = socket.socket(socket.AF_UNIX)
        self.line.connect(str(path))
        self.read = self.line.makefile("rb")

    def send(self, text):
        self.line.sendall(f"${text}#{sum(text.encode()) & 0xff:02x}".encode())

    def answer(self):
        """Empty: the line has ended."""
        while (byte := self.read.read(1)) not in (b"$", b""):
            pass
        answer = b""
        while (byte := self.read.read(1)) not in (b"#", b""):
            answer += byte
        self.read.read(2)
        if byte and not answer.startswith(b"W"):  # that is its last word
            self.line.sendall(b"+")
        return answer.decode()

    def ask(self, text):
        self.send(text)
        return self.answer()

    def go_on(self, seconds):
        """Runs for this time; whether the program has not ended."""
        self.send("c")
        self.read.read(1)  # its +
        if not select.select([self.line], [], [], seconds)[0]:
            self.line.sendall(b"\x03")
        return self.answer().startswith("T")

    def memory(self, at, size):
        return bytes.fromhex(self.ask(f"m{at:x},{size:x}"))

    def write(self, at, data):
        assert self.ask(f"M{at:x},{len(data):x}:{data.hex()}") == "OK"


def object_of(image):
    """Address and size of the program's object, which main() has."""
    text = subprocess.run(["arm-none-eabi-nm", "-S", "-C", image], check=True, stdout=subprocess.PIPE, text=True).stdout
    for line in text.splitlines():
        if line.endswith("::program"):
            at, size = line.split()[:2]
            return int(at, 16), int(size, 16)
    return None


def looks_like_float(word):
    return 1e-6 < abs(struct.unpack("<f", word)[0]) < 1e9


def random_word(draw):
    if draw.random() < 0.5:
        return struct.pack("<f", draw.choice(FLOATS))
    return struct.pack("<f", draw.uniform(-1, 1) * 10 ** draw.uniform(-3, 6))


def disturb(stub, begin, size, draw):
    """One word, if there is one where it looks."""
    for _ in range(LOOKS):
        at = begin + draw.randrange(0, max(size - CHUNK, 0) + 4, 4)
        data = stub.memory(at, min(CHUNK, begin + size - at) // 4 * 4)
        found = [i for i in range(0, len(data), 4) if looks_like_float(data[i:i + 4])]
        if found:
            stub.write(at + draw.choice(found), random_word(draw))
            return 1
    return 0


def inject(path, image, seed):
    """Runs the image, which waits for the stub at `path`, to its end. The number of faults."""
    begin, size = object_of(image)
    draw = random.Random(seed)
    stub = Stub(path)
    count = 0
    while stub.go_on(draw.uniform(0, LONGEST_S)):
        count += disturb(stub, begin, size, draw)
    return count
