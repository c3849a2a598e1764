#!/usr/bin/env python3
"""Compares the bounds of `eagerx-gen size IMAGE --worst --json` with what QEMU executes.

most_executed.py BOUNDS.json MACHINE IMAGE OPTION...: runs the image one instruction at a time and counts, for each
function that has a bound, the instructions from its first one to its return, those of its callees included. Prints a
line for each function that ran: its name, the bound, the most executed. Exits with 1 if more were executed than a
bound allows, or if no function with a bound ran.
"""
import json
import re
import subprocess
import sys


def handler_of(image):
    """The addresses of the clock's exception, which comes on top of any bound."""
    text = subprocess.run(["arm-none-eabi-nm", "-S", image], check=True, stdout=subprocess.PIPE, text=True).stdout
    found = re.search(r"^(\w+) (\w+) T SysTick_Handler$", text, re.MULTILINE)
    begin = int(found.group(1), 16) & ~1 if found else 0
    return range(begin, begin + int(found.group(2), 16) if found else 0)


def without_exceptions(addresses, handler):
    """QEMU names the instruction that an exception comes before, and again behind it."""
    last, was_in_handler = None, False
    for at in addresses:
        if at in handler:
            was_in_handler = True
            continue
        if not (was_in_handler and at == last):
            yield at
        last, was_in_handler = at, False


def executed(machine, image, options):
    """The address of each instruction, in the order in which they are executed."""
    command = ["qemu-system-arm", "-M", machine, "-display", "none", "-monitor", "none", "-serial", "null",
               "-semihosting-config", "enable=on,target=native", "-singlestep", "-d", "exec,nochain",
               "-kernel", image, "-append", " ".join(options)]
    pattern = re.compile(rb"^Trace \d+: \S+ \[[0-9a-f]+/([0-9a-f]+)/")
    with subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE) as process:
        for line in process.stderr:
            found = pattern.match(line)
            if found:
                yield int(found.group(1), 16)


def returns_of(image):
    """Behind each call: where its callee returns to."""
    text = subprocess.run(["arm-none-eabi-objdump", "-d", "--no-show-raw-insn", image], check=True,
                          stdout=subprocess.PIPE, text=True).stdout
    call, returns = None, {}
    for line in text.splitlines():
        found = re.match(r"^\s*([0-9a-f]+):\t(\S+)", line)
        if not found:
            continue
        at = int(found.group(1), 16)
        if call is not None:
            returns[call] = at
        call = at if re.match(r"^blx?(eq|ne|[cl][cst]|[lg][te]|hi|mi|pl|vs|vc)?(\.w)?$", found.group(2)) else None
    return returns


def most_of_each(entries, returns, addresses):
    """[entry address] → the most instructions of a call."""
    most, frames, before = {}, [], None
    for count, at in enumerate(addresses):
        while frames and at == frames[-1][2]:
            entry, begun, _ = frames.pop()
            most[entry] = max(most.get(entry, 0), count - begun)
        if at in entries and before in returns and returns[before] != at:
            frames.append((at, count, returns[before]))
        before = at
    return most


def main():
    bounds, machine, image, *options = sys.argv[1:]
    with open(bounds, encoding="utf-8") as file:
        functions = {f["address"]: f for f in json.load(file)["worst"]["functions"]}
    most = most_of_each(functions, returns_of(image),
                        without_exceptions(executed(machine, image, options), handler_of(image)))
    failed = not most
    for entry, count in sorted(most.items(), key=lambda item: -item[1]):
        bound = functions[entry]["most"]
        failed |= count > bound
        print(f"{functions[entry]['name']:44} {bound:>9} {count:>9} {bound / count:6.2f}"
              f"{'  MORE THAN ITS BOUND' if count > bound else ''}")
    if not most:
        print("no function with a bound ran", file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
