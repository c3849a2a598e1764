"""Shared by tests of trained policies: trainings, programs that judge them, the emulated board."""
import os
import pathlib
import re
import resource
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
BOARD = "mps2-an386"  # a Cortex-M4F
failures = 0


def expect(good, what):
    global failures
    print("ok  " if good else "FAIL", what, flush=True)
    failures += not good


def call(*words, good=(0,)):
    done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode not in good:
        sys.exit(f"{words}: {done.stdout}")
    return done.stdout


def generator(build):
    """eagerx-gen of a build folder, which takes models and targets from this tree."""
    os.environ["EAGERX_HOME"] = str(ROOT)
    return (pathlib.Path(build) / "eagerx-gen").resolve()


def train(eagerx_gen, graph, *options):
    """Into policy.safetensors; steps, and seconds of processor time."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    said = call(eagerx_gen, "train", graph, "-o", "policy.safetensors", *options, good=(0, 1))
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    ended = re.search(r"after (\S+) steps", said)
    if not ended:  # exit code 1 is also that of a problem in the graph
        sys.exit(f"{graph}: {said}")
    return ended[1].rstrip(","), seconds


def judged(program, seed=1000):
    """Mean and deviation of the return, and how many succeed, of 100 episodes."""
    said = call(program, "--episodes", "100", "--seed", seed, "--summary")
    mean, deviation = re.search(r"(?m)^return: mean (\S+), deviation (\S+?),", said).groups()
    success = re.search(r"(?m)^success: (\d+) of 100", said)
    return float(mean), float(deviation), int(success[1]) if success else 0


def program(name):
    return f"generated/{name}/build/{name}"


def image(name):
    return f"generated/{name}-{BOARD}/build/{name}.elf"


def try_board(eagerx_gen, graph, name, *options):
    """Whether the program of linux-sim, which is built, and that of the board have one trace hash."""
    call(eagerx_gen, "build", graph, "--target", BOARD, "--quiet")
    board = call(ROOT / "targets/run", BOARD, image(name), *options)
    linux = call(program(name), *options, "--hash")
    hashes = [re.search(r"(?m)^trace hash (\S+)", text)[1] for text in (linux, board)]
    expect(hashes[0] == hashes[1], f"{name}: trace hash: Linux {hashes[0]}, {BOARD} {hashes[1]}")
