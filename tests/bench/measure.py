"""How tests/bench/run builds, runs and measures."""
import math
import os
import re
import resource
import shutil
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

import make_graph as graphs

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
NODES = 1000


@dataclass
class Row:
    """One line of the table. `values`: by compiler, or under "" if there is one only."""
    name: str
    unit: str
    values: dict
    least: float | None = None
    most: float | None = None
    note: str = ""

    def missed(self):
        values = self.values.values()
        return (self.least is not None and min(values) < self.least) or (self.most is not None and max(values) > self.most)

    def aim(self):
        if self.least is not None:
            return f"≥ {self.least:g} {self.unit}".strip()
        return f"< {self.most:g} {self.unit}".strip() if self.most is not None else ""


def number(value, unit):
    digits = 0 if abs(value) >= 100 else (1 if abs(value) >= 10 else 2)
    return f"{value:.{digits}f} {unit}".strip()


def table(rows, compilers):
    """The rows in Markdown."""
    cells = [["", "aim", *compilers, ""]]
    for row in rows:
        values = [number(row.values[c if c in row.values else ""], row.unit) for c in compilers]
        if "" in row.values:
            values = [values[0]] + [""] * (len(compilers) - 1)
        cells.append([row.name, row.aim(), *values, row.note + (" **missed**" if row.missed() else "")])
    widths = [max(len(line[i]) for line in cells) for i in range(len(cells[0]))]
    lines = ["| " + " | ".join(cell.ljust(width) for cell, width in zip(line, widths)) + " |" for line in cells]
    return "\n".join([lines[0], "|" + "|".join("-" * (width + 2) for width in widths) + "|", *lines[1:]])


def machine():
    text = Path("/proc/cpuinfo").read_text()
    model = re.search(r"^model name\s*:\s*(.*)$", text, re.M)
    return f"{model[1] if model else 'unknown processor'}, {os.cpu_count()} cores"


def quietly(*command, cwd=None, good=(0,)):
    """Runs a command; its output is shown only if it fails, with an exit code that is not `good`."""
    try:
        done = subprocess.run([str(c) for c in command], cwd=cwd, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    except OSError as problem:
        sys.exit(f"error: `{command[0]}` does not start: {problem.strerror}")
    if done.returncode not in good:
        sys.stderr.write(done.stdout)
        sys.exit(f"error: `{' '.join(str(c) for c in command)}` failed")
    return done.stdout


def build_generator(build):
    """build/generator is the one that examples/run uses."""
    folder = generator_folder(build)
    if not (folder / "build.ninja").exists():
        quietly("cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DEAGERX_BUILD_TESTS=OFF")
    quietly("ninja", "-C", folder, "eagerx-gen")


def generator_folder(build):
    return build.parent / "generator"


def children_s():
    """User and system time of all commands so far, everything included."""
    spent = resource.getrusage(resource.RUSAGE_CHILDREN)
    return spent.ru_utime + spent.ru_stime


def processor_time_s(*command):
    before = children_s()
    quietly(*command)
    return children_s() - before


def make_graph(nodes, folder, rates_hz=graphs.RATES_HZ):
    graphs.write(nodes, folder, "many_nodes", rates_hz)
    return folder / "graph.yaml"


def slots(rates_hz):
    """Instants of the hyperperiod at which something is due, the environment and the engine included."""
    rates = [Fraction(str(rate)) for rate in [*rates_hz, graphs.ENVIRONMENT_HZ, graphs.ENGINE_HZ]]
    hyperperiod_s = Fraction(1, math.gcd(*(rate.numerator for rate in rates)))
    hyperperiod_s *= math.lcm(*(rate.denominator for rate in rates))
    return len({tick / rate for rate in rates for tick in range(int(hyperperiod_s * rate))})


def generation(build, graph, out, repeats):
    """(seconds, bytes) of generating into an empty folder; the folder is left as if generated once."""
    command = [generator_folder(build) / "eagerx-gen", "generate", graph, "--path", HERE / "models", "--quiet", "-o"]
    times = []
    with tempfile.TemporaryDirectory(dir=build) as scratch:
        for i in range(repeats):
            times.append(processor_time_s(*command, Path(scratch) / str(i)))
    quietly(*command, out)
    size = sum(file.stat().st_size for file in out.rglob("*") if file.is_file())
    return min(times), size


def build_programs(build, compiler):
    """Builds all programs with a compiler, one after the other so that compile times are not disturbed."""
    tree = build / compiler
    log = tree / "compile_times.txt"
    if tree.exists():
        shutil.rmtree(tree)
    tree.mkdir(parents=True)
    quietly("cmake", "-S", HERE, "-B", tree, "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={compiler}",
            f"-DCMAKE_CXX_COMPILER_LAUNCHER={HERE / 'timed'};{log}", f"-Deagerx_gen_DIR={generator_folder(build)}",
            f"-DEAGERX_BENCH_GENERATED={build / 'generated'}")
    quietly("ninja", "-C", tree, "-j1")
    return tree


def compile_time(tree, target, source=""):
    """Seconds of the compiler for a source of a target, or for its main.cpp."""
    for line in (tree / "compile_times.txt").read_text().splitlines():
        user, system, file = line.split(maxsplit=2)
        if f"/{target}.dir/" in f"/{file}" and file.endswith(f"{source or 'main'}.cpp.o"):
            return float(user) + float(system)
    sys.exit(f"error: {target} was not compiled")


def text_kb(tree, target, source):
    (file,) = tree.rglob(f"{target}.dir/**/{source}.cpp.o")
    return int(quietly("size", file).splitlines()[1].split()[0]) / 1024


def pairs(program, *arguments):
    """The `name value` lines that a program prints."""
    lines = quietly(program, *arguments).splitlines()
    return {name: float(value) for name, value in (line.split() for line in lines)}


def instructions(program, function, steps, *arguments):
    """Instructions that a run spends in a function and what it calls, counted by valgrind. The pattern must not match
    lambdas inside of the function: each match turns the counting on and off."""
    with tempfile.NamedTemporaryFile() as file:
        text = quietly("valgrind", "--tool=callgrind", f"--callgrind-out-file={file.name}",
                       f"--toggle-collect=eagerx::bench::{function}(*long)", program, steps, *arguments)
    return int(re.search(r"Collected : (\d+)", text)[1])


def environments(build, graph, work):
    """Folder of sources and library of environments of a graph, made by the eagerx-gen of a build folder."""
    quietly(build / "eagerx-gen", "generate", graph, "--quiet", "--target", "environments", "-o", work / "library")
    quietly("cmake", "-S", work / "library", "-B", work / "build", "-G", "Ninja", "-DCMAKE_CXX_COMPILER=g++", "-DCMAKE_BUILD_TYPE=Release",
            f"-Deagerx_gen_DIR={build}")
    quietly("ninja", "-C", work / "build")
    (library,) = (work / "build").glob("lib*_environments.so")
    return work / "library", library


def trace_hash(program):
    return quietly(program, "--steps", 500, "--quiet", "--hash").split()[-1]
