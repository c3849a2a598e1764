"""Rows of tests/bench/peers: what is measured of ours and of a peer. A line is (what, ours, theirs, ours over theirs)."""
import os
import re
import statistics
from dataclasses import dataclass
from typing import Callable

import measure
from programs import BOARD, CLASSICS

RUNS = 5
LONG_CHAIN = 200  # nodes; the short one has half as many
NETWORKS = ("relu_64_64", "tanh_64_64", "relu_256_256", "int8_64_64", "int8_256_256")


def instructions(program, count):
    """Instructions of one of `count` items that a program does, besides its start."""
    once, twice = (int(re.search(r"Collected : (\d+)", measure.quietly(
        "valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", *program, n))[1]) for n in (count, 2 * count))
    return (twice - once) / count


def times_ns(programs, count):
    """Processor time of one of `count` items, besides the start: the median of each program, which run in turn."""
    times = [[] for _ in programs]
    for _ in range(RUNS):
        for program, of_program in zip(programs, times):
            whole, start = (measure.processor_time_s(*program, n) for n in (count, 0))
            of_program.append(1e9 * (whole - start) / count)
    return [statistics.median(of_program) for of_program in times]


def line(what, form, ours, theirs):
    return what, format(ours, form), format(theirs, form), ours / theirs


def stepped(what, ours, theirs, counted, timed, native=None, items=1):
    """Instructions and time of a step of two programs, whose last argument is the number of steps; `native`: another
    `theirs` for the time; `items`: environments of a step."""
    yield line(f"{what}: instructions a step", ",.0f", *(instructions(program, counted) / items for program in (ours, theirs)))
    yield line(f"{what}: ns a step", ".1f", *(time / items for time in times_ns((ours, native or theirs), timed)))


def one_cart_pole(own, peer):
    theirs = peer.program("one_cart_pole")
    ours = own.over_library("one_cart_pole", "graph.yaml", "one.cpp", "-DDRIVE=upright")
    return stepped(ROWS["one"].title, (ours,), (theirs,), 20_000, 5_000_000)


def one_pendulum(own, peer):
    theirs = peer.program("one_pendulum")
    ours = own.over_library("one_pendulum", "pendulum.yaml", "one.cpp", "-DDRIVE=brake")
    return stepped(ROWS["pendulum"].title, (ours,), (theirs,), 20_000, 5_000_000)


def cart_poles(own, _):
    """valgrind does not know AVX-512: the instructions are those of AVX2, the time that of this machine."""
    os.environ["EAGERX_SIMD"] = "avx2"
    vectorize = ("-O3", "-ffast-math", "-ffp-contract=fast", "-mfma")
    avx2, native = (own.over_library(f"cart_poles{flag}", "graph.yaml", "cart_poles.cpp", *vectorize, flag) for flag in ("-mavx2", "-march=native"))
    lines = stepped(ROWS["vector"].title, (avx2, "library"), (avx2, "loop"), 200, 20_000, (native, "loop"), 4096)
    yield next(lines)
    del os.environ["EAGERX_SIMD"]
    yield next(lines)


def trained(program, seed):
    """Steps that a training needed, and its processor time [s]."""
    before = measure.children_s()
    said = measure.quietly(*program, seed)
    ended = re.search(r"(?m)after ([\d,]+) steps|^(\d+)$", said)
    if not ended:
        raise SystemExit(f"error: `{' '.join(map(str, program))} {seed}` does not say after how many steps it reached the return:\n{said}")
    return int((ended[1] or ended[2]).replace(",", "")), measure.children_s() - before


def trainings(own, peer):
    os.environ["OPENBLAS_NUM_THREADS"] = "1"
    theirs = (peer.program("sac"),)
    ours = (own.eagerx_gen, "train", CLASSICS / "pendulum.yaml", "--build", own.work / "sac", "-o", own.work / "policy.safetensors",
            "--algorithm", "sac", "--threads", 1, "--until-return", -160)
    measure.quietly(*ours[:7], "--steps", 8192, good=(0, 1))  # builds the library
    programs = {"defaults": (*ours, "--seed"), "--preset swing_up": (*ours, "--preset", "swing_up", "--seed"), "": theirs}
    figures = {name: [] for name in programs}
    for seed in range(1, RUNS + 1):
        for name, program in programs.items():
            figures[name].append(trained(program, seed))
    medians = {name: [statistics.median(column) for column in zip(*rows)] for name, rows in figures.items()}
    for name in list(programs)[:-1]:
        yield line(f"{ROWS['sac'].title}, {name}: steps", ",.0f", medians[name][0], medians[""][0])
        yield line(f"{ROWS['sac'].title}, {name}: s", ".2f", medians[name][1], medians[""][1])


def policies(own, peer):
    """Instructions in QEMU; the peer's images print theirs."""
    theirs = {}
    for network in NETWORKS:
        if network == NETWORKS[0] or (peer.folder / f"{network}.elf").is_file():
            image = peer.program(f"{network}.elf", executable=False)
            said = measure.quietly("timeout", 300, *BOARD, image).split()
            if len(said) != 1 or not said[0].isdigit():
                raise SystemExit(f"error: `{image}` must print its instructions, and nothing else: {' '.join(said)}")
            theirs[network] = int(said[0])
    ours = own.policies()
    for network, count in theirs.items():
        yield line(f"{ROWS['policy'].title}, {network}", ",.0f", ours[network], count)


def hops(own, peer):
    """Of two chains of nodes: the additional instructions of the longer one, by its additional nodes."""
    theirs = instructions((peer.program("hop"),), 20_000)
    short, long = (instructions((own.chain(nodes),), 1000) for nodes in (LONG_CHAIN // 2, LONG_CHAIN))
    yield line(f"{ROWS['hop'].title}: instructions", ",.0f", (long - short) / (LONG_CHAIN // 2), theirs)


@dataclass
class Row:
    title: str
    peers: tuple  # of which it needs programs; none: the other side is in this tree
    measured: Callable  # of Own and a peer: lines


ROWS = {
    "one": Row("one CartPole, C interface", ("pufferlib",), one_cart_pole),
    "pendulum": Row("one Pendulum-v1, C interface", ("rltools",), one_pendulum),
    "vector": Row("one of 4,096 CartPoles; a loop over arrays", (), cart_poles),
    "sac": Row("SAC, Pendulum-v1 to -160", ("rltools",), trainings),
    "policy": Row("policy on a Cortex-M4F, instructions", ("onnx2c", "cmsis-nn"), policies),
    "hop": Row("a message from a node to the next, with its callback", ("reactor-uc",), hops),
}
