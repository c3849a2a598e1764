#!/usr/bin/env python3
"""A cable in a network namespace of its own: what goes to 127.5.0.2 comes back from there to 127.5.0.1, later, or not.

    unshare -rn tests/parts/cable.py [--latency S] [--loss P] [--seed N] COMMAND...

Makes the device `cable` and runs COMMAND next to it, which may take it down (`ip link set cable down`). Each IP packet
is late by S seconds; of a hundred, P are lost, so that TCP sends them again. Addresses of this machine, so that no key
is needed. Ends with COMMAND's exit code; 77 without a device, as where namespaces are not allowed.
"""
import argparse
import fcntl
import heapq
import os
import random
import select
import struct
import subprocess
import sys
import time

TUNSETIFF, IFF_TUN, IFF_NO_PI = 0x400454CA, 1, 0x1000
NO_DEVICE = 77


def make_device():
    try:
        device = os.open("/dev/net/tun", os.O_RDWR | os.O_NONBLOCK)
        fcntl.ioctl(device, TUNSETIFF, struct.pack("16sH", b"cable", IFF_TUN | IFF_NO_PI))
        with open("/proc/sys/net/ipv4/conf/cable/route_localnet", "w", encoding="ascii") as file:
            file.write("1")
        subprocess.run(["ip", "addr", "add", "127.5.0.1/24", "dev", "cable"], check=True)
        subprocess.run(["ip", "link", "set", "cable", "up"], check=True)
    except (OSError, subprocess.CalledProcessError) as problem:
        print(f"no cable: {problem}", file=sys.stderr)
        sys.exit(NO_DEVICE)
    return device


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--latency", type=float, default=0.0)
    parser.add_argument("--loss", type=float, default=0.0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("command", nargs=argparse.REMAINDER)
    options = parser.parse_args()
    device = make_device()
    chance = random.Random(options.seed)
    program = subprocess.Popen(options.command)
    late, number, lost = [], 0, 0
    while program.poll() is None:
        now = time.monotonic()
        wait = max(0.0, late[0][0] - now) if late else 0.05
        if select.select([device], [], [], min(wait, 0.05))[0]:
            try:
                packet = os.read(device, 65536)
            except OSError:  # it is down
                packet = b""
            if len(packet) >= 20 and packet[0] >> 4 == 4:
                number += 1
                if chance.random() * 100 < options.loss:
                    lost += 1
                else:
                    # Both addresses change places, which no checksum notices.
                    packet = packet[:12] + packet[16:20] + packet[12:16] + packet[20:]
                    heapq.heappush(late, (time.monotonic() + options.latency, number, packet))
        while late and late[0][0] <= time.monotonic():
            try:
                os.write(device, heapq.heappop(late)[2])
            except OSError:
                pass
    print(f"cable: {number} packets, {lost} lost", file=sys.stderr)
    sys.exit(program.returncode)


main()
