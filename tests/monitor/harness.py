"""Programs that publish, and monitors that watch them."""
import contextlib
import os
import pathlib
import re
import resource
import socket
import subprocess
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
ENVIRONMENT = {**os.environ, "EAGERX_HOME": str(ROOT)}
PATIENCE_S = 15  # for what comes at once on a machine that has time


def free_port():
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as here:
        here.bind(("127.0.0.1", 0))
        return here.getsockname()[1]


def eventually(condition, what):
    give_up = time.monotonic() + PATIENCE_S
    while not (found := condition()):
        assert time.monotonic() < give_up, f"never: {what}"
        time.sleep(0.02)
    return found


@contextlib.contextmanager
def monitor(eagerx_gen, *options):
    """A monitor that prints lines and has opened its source; `said` is set when it has ended."""
    process = subprocess.Popen([eagerx_gen, "monitor", *map(str, options)], stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True, env=ENVIRONMENT)
    try:
        process.head = process.stdout.readline()
        yield process
    finally:
        process.kill()
        process.communicate()


def shown(process, pattern):
    """Reads what a monitor prints, up to a line that has this."""
    give_up = threading.Timer(4 * PATIENCE_S, process.kill)
    give_up.start()
    try:
        while line := process.stdout.readline():
            if re.search(pattern, line):
                return
    finally:
        give_up.cancel()
    raise AssertionError(f"never shown: {pattern}")


def ended(process, code=0):
    """Its output, and its last messages."""
    out, err = process.communicate(timeout=PATIENCE_S)
    assert process.returncode == code, (process.returncode, out, err)
    return out, err


def table(out):
    """{channel: {column: text}} of the last table, and the line above it."""
    heads = "channel value messages rate_hz planned_hz age_s late_s limit left state".split()
    last = out[out.rindex("# graph"):].splitlines()
    rows = {}
    for line in last[1:]:
        cells = line.split("\t")
        assert len(cells) == len(heads), line
        rows[cells[0]] = dict(zip(heads, cells))
    return rows, last[0]


def numbers(cell):
    return [float(each) for each in cell.split(",")]


def most_memory_mb():
    """Of the children that have ended."""
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024


def last_messages(trace):
    """{channel: values} of the trace of a run."""
    found = {}
    for line in trace.read_text().splitlines():
        if line[:1].isdigit():
            _, channel, _, *values = line.split(",")
            found[channel] = [float(v) for v in values]
    return found
