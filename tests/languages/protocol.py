#!/usr/bin/env python3
"""The bytes of targets/PROTOCOL.md are those of programs:

    protocol.py PART_FOLDER PART_PROGRAM PAGE

PART_FOLDER has part.json, PART_PROGRAM is a part in C++ of the page's graph, started here. What the page shows is sent
and must be answered, byte by byte, by the program and by the part in Python of PART_FOLDER.
"""
import os
import re
import socket
import subprocess
import sys
import tempfile
import time


def lines_of(page):
    """[(direction, bytes)] of the blocks ```bytes of the page."""
    found = []
    with open(page, encoding="utf-8") as file:
        text = file.read()
    for block in re.findall(r"^```bytes\n(.*?)^```", text, re.S | re.M):
        for line in block.splitlines():
            direction, _, rest = line.partition(":")
            found.append((direction.strip(), bytes.fromhex(rest.split("#")[0])))
    return found


def converse(name, command, script):
    """Whether the program answers as the script says."""
    with tempfile.TemporaryDirectory() as folder:
        address = os.path.join(folder, "line")
        with subprocess.Popen([*command, "--listen", f"unix:{address}"], stderr=subprocess.DEVNULL) as part:
            for _ in range(1500):
                if os.path.exists(address):
                    break
                time.sleep(0.02)
            hub = socket.socket(socket.AF_UNIX)
            hub.settimeout(30)
            for _ in range(1500):  # the socket may be there before it listens
                try:
                    hub.connect(address)
                    break
                except OSError:
                    time.sleep(0.02)
            good = True
            for i, (direction, data) in enumerate(script):
                if direction == "hub":
                    hub.sendall(data)
                    continue
                answer = b""
                while len(answer) < len(data):
                    more = hub.recv(len(data) - len(answer))
                    if not more:
                        break
                    answer += more
                if answer != data:
                    print(f"FAIL {name}: line {i + 1} of the page is {data.hex(' ')}, the program says {answer.hex(' ')}")
                    good = False
                    break
            hub.close()
            part.wait(timeout=30)
    if good:
        print(f"ok   {name}: {len(script)} lines of the page, {sum(len(data) for _, data in script)} bytes")
    return good


def main():
    folder, program, page = sys.argv[1:]
    script = lines_of(page)
    if len(script) < 6:
        sys.exit("FAIL the page shows no exchange")
    results = [converse("a part in C++", [program], script), converse("a part in Python", [sys.executable, folder], script)]
    sys.exit(0 if all(results) else 1)


if __name__ == "__main__":
    main()
