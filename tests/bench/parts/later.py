#!/usr/bin/env python3
"""A line that takes its time: later.py FROM TO SECONDS

Listens on the unix socket FROM for a hub, connects to a part at TO, and hands on what comes SECONDS later, both ways.
"""
import selectors
import socket
import sys
import time
from collections import deque


def main():
    source, to, seconds = sys.argv[1], sys.argv[2], float(sys.argv[3])
    server = socket.socket(socket.AF_UNIX)
    server.bind(source)
    server.listen(1)
    hub, _ = server.accept()
    part = socket.socket(socket.AF_UNIX)
    part.connect(to)
    ways = {hub: (part, deque()), part: (hub, deque())}
    selector = selectors.DefaultSelector()
    for end in ways:
        selector.register(end, selectors.EVENT_READ)
    while True:
        due = [waiting[0][0] for _, waiting in ways.values() if waiting]
        for key, _ in selector.select(max(0.0, min(due) - time.monotonic()) if due else None):
            data = key.fileobj.recv(65536)
            if not data:
                return
            ways[key.fileobj][1].append((time.monotonic() + seconds, data))
        for out, waiting in ways.values():
            while waiting and waiting[0][0] <= time.monotonic():
                out.sendall(waiting.popleft()[1])


main()
