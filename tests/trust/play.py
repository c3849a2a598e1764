"""Programs of a graph that is cut into a hub, `left` over TCP and `right` over a unix socket, and what is between."""
import os
import random
import re
import resource
import socket
import subprocess
import sys
import tempfile
import threading
import time

RUN = ["--agent", "random", "--steps", "60", "--episodes", "2"]
LOOK_S, LOOKS = 0.01, 6000
HELLO, PROOF, ANSWER = 48, 41, 73


class Process:
    """One that is ended at the latest with the stage."""

    def __init__(self, command):
        self.command, self.log = command, tempfile.TemporaryFile()
        self.process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=self.log, stderr=self.log)

    def until(self, condition, what):
        """Waits for it. A process that sleeps in LOOKS looks, or computes as long, hangs: seconds on the wall say nothing, as
        a machine may be busy with other things, or stand still."""
        idle, begun = 0, self.state()[1]
        while not condition():
            state, used = self.state()
            idle += state not in "RD"
            if idle > LOOKS or used - begun > LOOKS * LOOK_S:
                raise AssertionError(f"never saw {what}: `{' '.join(self.command)}` is in state {state} after {used:.1f} s of "
                                     f"processor time, and has said: {self.said()}")
            time.sleep(LOOK_S)

    def state(self):
        """Its state, as in proc(5), and its processor time in seconds."""
        with open(f"/proc/{self.process.pid}/stat", encoding="ascii", errors="replace") as file:
            fields = file.read().rpartition(")")[2].split()
        return fields[0], (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def said(self):
        log = self.log.fileno()  # whose position is the process's, too: it writes there
        return os.pread(log, os.fstat(log).st_size, 0).decode(errors="replace")

    def wait(self):
        """Exit code; a hang is an error."""
        self.until(lambda: self.process.poll() is not None, "its end")
        return self.process.returncode

    def listens(self):
        """Waits until it does, or has ended."""
        self.until(lambda: "listens on" in self.said() or self.process.poll() is not None, "that it listens")

    def end(self):
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()
        self.log.close()


class Stage:
    """Where programs run, for one check."""

    def __init__(self, folder):
        self.folder, self.started = folder, []
        self.scratch = tempfile.mkdtemp(prefix="eagerx-")
        self.key = os.path.join(folder, "good.key")

    def program(self, name):
        """The command to start it with: a program, or the folder of a part in Python."""
        path = os.path.join(self.folder, "programs", name)
        return [sys.executable, path] if os.path.isdir(path) else [path + ".elf"]

    def start(self, command):
        self.started.append(Process(command))
        return self.started[-1]

    def left(self, *options, program="left", address="127.0.0.1:0"):
        """The part and its port."""
        part = self.start([*self.program(program), "--listen", address, *options])
        part.listens()
        found = re.search(r"listens on .*:(\d+)", part.said())
        if not found:
            raise AssertionError("the part said: " + part.said())
        return part, int(found[1])

    def right(self):
        path = os.path.join(self.scratch, "right%d" % len(self.started))
        right = self.start([*self.program("right"), "--listen", "unix:" + path])
        right.until(lambda: os.path.exists(path), "the other part")
        return "right=unix:" + path

    def hub(self, port, *options, host="127.0.0.1", key=True, run=None, before=()):
        """Starts it; with the key by default."""
        self.trace = os.path.join(self.scratch, "trace%d" % len(self.started))
        keys = ["--key", "left=" + self.key] if key else []
        return self.start([*before, *self.program("hub"), *(RUN if run is None else run), "--link", self.right(), "--link",
                           f"left={host}:{port}", *keys, "--hash", "--trace", self.trace, "--link-timeout", "20", *options])

    def close(self):
        for process in self.started:
            process.end()


def hash_in(text):
    found = re.search(r"^trace hash (.*)$", text, re.M)
    return found[1] if found else ""


def cost_of(commands):
    """Processor time, in seconds, of processes that `commands` starts and waits for."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    commands()
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


class Direction:
    """One direction of a connection: greetings of known sizes, then records."""

    def __init__(self, source, target, greetings, attack):
        self.source, self.target, self.greetings, self.attack = source, target, list(greetings), attack
        self.records, self.said, self.other = [], [], None
        self.thread = threading.Thread(target=self.carry, daemon=True)

    def exactly(self, size):
        data = b""
        while len(data) < size:
            more = self.source.recv(size - len(data))
            if not more:
                raise OSError
            data += more
        return data

    def carry(self):
        try:
            for size in self.greetings:
                self.said.append(self.exactly(size))
                self.target.sendall(self.said[-1])
            while True:
                head = self.exactly(2)
                record = head + self.exactly(int.from_bytes(head, "little") + 17)
                self.records.append(record)
                for data in self.attack(self, record) if self.attack else [record]:
                    if data is None:  # the line is cut
                        raise OSError
                    self.target.sendall(data)
        except OSError:
            for end in (self.source, self.target):
                try:
                    end.shutdown(socket.SHUT_RDWR)
                except OSError:
                    pass


class Between:
    """An attacker on the line between hub and part, without a key."""

    def __init__(self, port, to_part=None, to_hub=None):
        self.server = socket.create_server(("127.0.0.1", 0))
        self.port = self.server.getsockname()[1]
        self.there, self.back = None, None
        self.thread = threading.Thread(target=self.stand, args=(port, to_part, to_hub), daemon=True)
        self.thread.start()

    def stand(self, port, to_part, to_hub):
        hub, _ = self.server.accept()
        part = socket.create_connection(("127.0.0.1", port))
        self.there = Direction(hub, part, (HELLO, PROOF), to_part)
        self.back = Direction(part, hub, (ANSWER,), to_hub)
        self.there.other, self.back.other = self.back, self.there
        self.back.thread.start()
        self.there.thread.start()


def at(number, attack):
    """`attack(way, record)` gives what takes the place of record `number` and, once more, of those after it."""

    def act(way, record):
        return attack(way, record) if len(way.records) >= number else [record]

    return act


def flipped(data, rng):
    changed = bytearray(data)
    changed[rng.randrange(len(changed))] ^= 1 << rng.randrange(8)
    return bytes(changed)


def sampled(rng, size):
    return bytes(rng.randrange(256) for _ in range(size))


def generator(seed):
    return random.Random(seed)
