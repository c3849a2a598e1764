#!/usr/bin/env python3
"""A bad line between the two programs of a split graph.

    line.py FROM TO [--drop P] [--duplicate P] [--corrupt P] [--delay P] [--reorder P] [--noise P]
            [--seed N] [--hang-up-after N] [--silent-after N] [--note FILE]

FROM: unix:PATH to listen on for the host's program, or pty:PATH for a pseudo terminal with a link at PATH.
TO: unix:PATH to connect to, or pty:PATH as well. P are percent of frames, which the zeros between them
separate. What a frame suffers depends on the seed and its number alone. FILE gets the time, in ns since 1970, at which the
line is cut or falls silent.
"""
import argparse
import heapq
import os
import pty
import random
import selectors
import socket
import sys
import time
import tty


class Direction:
    """Frames one way."""

    def __init__(self, options, seed, send):
        self.options, self.send = options, send
        self.random = random.Random(seed)
        self.rest = b""
        self.frames = 0
        self.held = None  # a frame that the next one overtakes
        self.late = []    # (time, number, frame)

    def hit(self, percent):
        return self.random.random() * 100 < percent

    def take(self, data):
        self.rest += data
        while b"\0" in self.rest:
            frame, self.rest = self.rest.split(b"\0", 1)
            if frame:
                self.frames += 1
                self.suffer(frame)

    def suffer(self, frame):
        o = self.options
        if o.silent_after and self.frames > o.silent_after:
            note(o)
            return
        if self.hit(o.drop):
            return
        if self.hit(o.corrupt):
            bits = bytearray(frame)
            for _ in range(self.random.choice([1, 2, 3, 8, 40])):
                bits[self.random.randrange(len(bits))] ^= 1 << self.random.randrange(8)
            if self.hit(30):
                del bits[self.random.randrange(len(bits))]
            frame = bytes(bits)
        if self.hit(o.noise):
            self.out(bytes(self.random.randrange(256) for _ in range(self.random.randrange(1, 60))))
        copies = 2 if self.hit(o.duplicate) else 1
        for _ in range(copies):
            if self.hit(o.delay):
                heapq.heappush(self.late, (time.monotonic() + self.random.uniform(0.001, 0.05), self.frames, frame))
            elif self.hit(o.reorder) and self.held is None:
                self.held = frame
            else:
                self.out(b"\0" + frame + b"\0")
                if self.held is not None:
                    held, self.held = self.held, None
                    self.out(b"\0" + held + b"\0")

    def out(self, data):
        self.send(data)

    def tick(self):
        while self.late and self.late[0][0] <= time.monotonic():
            self.out(b"\0" + heapq.heappop(self.late)[2] + b"\0")


def note(options):
    """The first fault's time."""
    if options.note:
        with open(options.note, "w", encoding="ascii") as file:
            file.write(str(time.time_ns()))
        options.note = None


def open_pty(path):
    """A pseudo terminal with a link at `path`."""
    master, slave = pty.openpty()
    tty.setraw(master)
    tty.setraw(slave)
    os.symlink(os.ttyname(slave), path)
    # `slave` stays open, so that the line is there before and after the program.
    return master, lambda: os.read(master, 4096), lambda data: os.write(master, data)


def listen(address):
    kind, path = address.split(":", 1)
    if kind == "pty":
        return open_pty(path)
    server = socket.socket(socket.AF_UNIX)
    server.bind(path)
    server.listen(1)
    connection, _ = server.accept()
    return connection, lambda: connection.recv(4096), connection.sendall


def connect(address):
    kind, path = address.split(":", 1)
    if kind == "pty":
        return open_pty(path)
    for _ in range(1000):
        try:
            connection = socket.socket(socket.AF_UNIX)
            connection.connect(path)
            return connection, lambda: connection.recv(4096), connection.sendall
        except OSError:
            time.sleep(0.05)
    sys.exit("cannot connect to " + path)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("source")
    parser.add_argument("to")
    for fault in ("drop", "duplicate", "corrupt", "delay", "reorder", "noise"):
        parser.add_argument("--" + fault, type=float, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--hang-up-after", type=int, default=0)
    parser.add_argument("--silent-after", type=int, default=0)
    parser.add_argument("--note")
    options = parser.parse_args()

    board, read_board, write_board = connect(options.to)
    host, read, write = listen(options.source)
    there = Direction(options, options.seed, write_board)
    back = Direction(options, options.seed + 1000, write)
    selector = selectors.DefaultSelector()
    selector.register(host, selectors.EVENT_READ, (read, there))
    selector.register(board, selectors.EVENT_READ, (read_board, back))
    while True:
        for key, _ in selector.select(0.002 if there.late or back.late else 1):
            receive, direction = key.data
            try:
                data = receive()
                if not data:
                    return
                direction.take(data)
            except OSError:
                return
        there.tick()
        back.tick()
        if options.hang_up_after and there.frames >= options.hang_up_after:
            note(options)
            return


main()
