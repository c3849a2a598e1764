"""Programs that tests/bench/peers runs: those of this tree, which it builds, and those of a peer, which it finds."""
import functools
import os
import re
import subprocess
import sys
from pathlib import Path

import measure

HERE = Path(__file__).resolve().parent
CLASSICS = measure.ROOT / "examples/gymnasium_classics"
BOARD = ("qemu-system-arm", "-M", "mps2-an386", "-display", "none", "-monitor", "none", "-serial", "null", "-icount", "shift=0",
         "-semihosting-config", "enable=on,target=native", "-kernel")
FLAGS = ("-std=c++20", "-O2", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math", "-Wall", "-Wextra")


def commit_of_this_tree():
    said = subprocess.run(["git", "-C", measure.ROOT, "describe", "--always", "--abbrev=10", "--dirty"], text=True, capture_output=True)
    return said.stdout.strip() or "unknown"


class Peer:
    """Programs of another project in a folder."""

    @staticmethod
    def problem(folder):
        """Why this folder is none of a peer, or None."""
        if not Path(folder).is_dir():
            return f"no folder `{folder}`"
        commit = Path(folder) / "COMMIT"
        if not commit.is_file():
            return f"no file `{commit}`, which names the peer's commit"
        if not re.fullmatch(r"[0-9a-f]{7,40}", commit.read_text().strip()):
            return f"`{commit}` must be the commit in hexadecimal, and nothing else"
        return None

    def __init__(self, name, folder):
        self.name, self.folder = name, Path(folder).resolve()
        self.commit = (self.folder / "COMMIT").read_text().strip()

    def program(self, name, executable=True):
        path = self.folder / name
        if not path.is_file() or (executable and not os.access(path, os.X_OK)):
            sys.exit(f"error: {self.name} has no program `{path}`; tests/bench/README.md#peers says what it does")
        return path


class Own:
    """Programs of this tree, built below a work folder when they are first asked for."""

    def __init__(self, build, work):
        self.build, self.work = build, work
        self.eagerx_gen = build / "eagerx-gen"
        os.environ["EAGERX_HOME"] = str(measure.ROOT)
        work.mkdir(parents=True, exist_ok=True)

    def library(self, graph):
        """The library of environments of a graph of examples/gymnasium_classics: its folder of sources, and itself."""
        return measure.environments(self.build, CLASSICS / graph, self.work / Path(graph).stem)

    def over_library(self, name, graph, source, *flags):
        """A program over the library of a graph."""
        sources, library = self.library(graph)
        program = self.work / name
        measure.quietly("g++", *FLAGS, *flags, f"-I{sources}", f"-I{measure.ROOT}/runtime", f"-I{measure.ROOT}", "-c", HERE / source, "-o", f"{program}.o")
        # Without the flags: with -ffast-math a program starts in another mode of the floating-point unit, the library's too.
        measure.quietly("g++", f"{program}.o", library, f"-Wl,-rpath,{library.parent}", "-o", program)
        return program

    @functools.cache
    def policies(self):
        """Instructions of one answer of each network of tests/bench/policy, in QEMU; `int8_`: weights of eight bits and relu."""
        said = measure.quietly(measure.HERE / "policy/board", "M4F")
        lines = said.split("Eigen", maxsplit=1)[0].splitlines()
        lines = [words for words in map(str.split, lines) if len(words) == 6]
        counts = {name: int(exact) for name, exact, *_ in lines}
        return counts | {name.replace("relu", "int8"): int(int8) for name, _, _, _, int8, _ in lines if name.startswith("relu")}

    def chain(self, nodes):
        """The program of a chain of nodes at one rate, each of which hashes what it gets from the one before."""
        folder = self.work / f"chain{nodes}"
        folder.mkdir(exist_ok=True)
        (folder / "graph.yaml").write_text(chain(nodes))
        measure.quietly(self.eagerx_gen, "generate", folder / "graph.yaml", "--path", measure.HERE / "models", "--quiet", "-o", folder / "generated")
        program = folder / "program"
        measure.quietly("g++", *FLAGS, f"-I{folder}/generated", f"-I{measure.ROOT}/runtime", f"-I{measure.ROOT}", f"-I{measure.HERE}/models",
                        HERE / "hop.cpp", "-o", program)
        return program


def chain(nodes):
    """Text of a graph."""
    lines = ["name: chain", "rate: 20", "engine: {type: OdeEngine, rate: 20}",
             "actions: {drive: {space: {dtype: uint32, shape: [], low: 0, high: 4294967295}}}", "observations: [seen]", "agent: random", "nodes:"]
    lines += [f"  node_{i}: {{type: Mix, rate: 20, inputs: [a]}}" for i in range(nodes)]
    lines += ["connections:", "  - {from: actions.drive, to: node_0.a}"]
    lines += [f"  - {{from: node_{i}.mixed, to: node_{i + 1}.a}}" for i in range(nodes - 1)]
    lines += [f"  - {{from: node_{nodes - 1}.mixed, to: observations.seen, skip: true}}"]
    return "\n".join(lines) + "\n"
