#!/usr/bin/env python3
"""Compares the bounds of `eagerx-gen size IMAGE --worst --json` with what QEMU executes.

most_executed.py [--faults SEED] BOUNDS.json MACHINE IMAGE OPTION...: runs the image with counter.c and counts, for each
function that has a bound, the instructions from its first one to its return, those of its callees included. Prints a line
for each function that ran: its name, the bound, the most executed. Exits with 1 if more were executed than a bound allows,
or if no function with a bound ran. With `--faults`, numbers of the program become NaN, huge or other ones meanwhile
(faults.py), and a line says how many.
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import time

import faults

HERE = pathlib.Path(__file__).resolve().parent


def handlers_of(image):
    """First and end of the clock's exception, which comes on top of any bound."""
    text = subprocess.run(["arm-none-eabi-nm", "-S", image], check=True, stdout=subprocess.PIPE, text=True).stdout
    for begin, size in re.findall(r"^(\w+) (\w+) T SysTick_Handler$", text, re.MULTILINE):
        yield int(begin, 16) & ~1, (int(begin, 16) & ~1) + int(size, 16)


def calls_of(image):
    """Each call, and the instruction behind it: where its callee returns to."""
    text = subprocess.run(["arm-none-eabi-objdump", "-d", "--no-show-raw-insn", image], check=True,
                          stdout=subprocess.PIPE, text=True).stdout
    call = None
    for line in text.splitlines():
        found = re.match(r"^\s*([0-9a-f]+):\t(\S+)", line)
        if not found:
            continue
        at = int(found.group(1), 16)
        if call is not None:
            yield call, at
        call = at if re.match(r"^blx?(eq|ne|[cl][cst]|[lg][te]|hi|mi|pl|vs|vc)?(\.w)?$", found.group(2)) else None


def built_counter(folder):
    """The plugin for the installed QEMU; its interface has been 2 since QEMU 9."""
    version = subprocess.run(["qemu-system-arm", "--version"], check=True, stdout=subprocess.PIPE, text=True).stdout
    major = int(re.search(r"version (\d+)", version).group(1))
    plugin = folder / "counter.so"
    subprocess.run(["gcc", "-O2", "-shared", "-fPIC", "-fvisibility=hidden", f"-DPLUGIN_VERSION={2 if major >= 9 else 1}",
                    HERE / "counter.c", "-o", plugin], check=True)
    return plugin


def run(command, image, seed, folder):
    """Runs the image to its end, without faults if `seed` is None. The number of faults."""
    if seed is None:
        subprocess.run(command, check=True, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        return 0
    line = folder / "gdb"
    command = command + ["-S", "-chardev", f"socket,path={line},server=on,wait=off,id=gdb", "-gdb", "chardev:gdb"]
    with subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as qemu:
        while not line.exists() and qemu.poll() is None:
            time.sleep(0.01)
        try:
            return faults.inject(line, image, seed)
        except BaseException:
            qemu.kill()
            raise


def most_of_each(machine, image, options, functions, seed):
    """[entry address] → the most instructions of a call; the number of faults."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        plan = [f"e {at:x} 0" for at in functions]
        plan += [f"c {call:x} {behind:x}" for call, behind in calls_of(image)]
        plan += [f"h {first:x} {end:x}" for first, end in handlers_of(image)]
        (folder / "plan").write_text("\n".join(plan) + "\n")
        count = run(["qemu-system-arm", "-M", machine, "-display", "none", "-monitor", "none", "-serial", "null",
                     "-semihosting-config", "enable=on,target=native", "-icount", "shift=5", "-plugin",
                     f"{built_counter(folder)},plan={folder}/plan,counts={folder}/counts",
                     "-kernel", image, "-append", " ".join(options)], image, seed, folder)
        lines = (folder / "counts").read_text().splitlines()
    return {int(at, 16): int(most) for at, most, _ in (line.split() for line in lines)}, count


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--faults", type=int)
    for name in ("bounds", "machine", "image"):
        parser.add_argument(name)
    parser.add_argument("options", nargs=argparse.REMAINDER)
    given = parser.parse_args()
    with open(given.bounds, encoding="utf-8") as file:
        functions = {f["address"]: f for f in json.load(file)["worst"]["functions"]}
    most, fault_count = most_of_each(given.machine, given.image, given.options, functions, given.faults)
    failed = not most
    for entry, count in sorted(most.items(), key=lambda item: -item[1]):
        bound = functions[entry]["most"]
        failed |= count > bound
        print(f"{functions[entry]['name']:44} {bound:>9} {count:>9} {bound / count:6.2f}"
              f"{'  MORE THAN ITS BOUND' if count > bound else ''}")
    if given.faults is not None:
        print(f"faults: {fault_count}")
    if not most:
        print("no function with a bound ran", file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
