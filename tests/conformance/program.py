"""From a graph to a program that can be driven: the generator, the compiler, the driver."""
import collections
import concurrent.futures
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import threading
from fractions import Fraction

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
MOST_TOGETHER = 40  # graphs of a program: 0.7 GB for the compiler
FLAGS = ["-std=c++20", "-O0", "-Wall", "-Wextra", "-Werror", "-ffp-contract=off", f"-I{ROOT / 'runtime'}", f"-I{ROOT}", f"-I{HERE}"]


class Failure(Exception):
    """Something could not be made or run."""


class Refused(Exception):
    """The generator has errors: `codes`, and `text` as the user sees them."""

    def __init__(self, codes, text):
        super().__init__(text)
        self.codes, self.text = codes, text


Code = collections.namedtuple("Code", "folder name key size")


def call(command, text=None):
    command = [str(part) for part in command]
    result = subprocess.run(command, input=text, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if result.returncode:
        raise Failure(f"{' '.join(command)}\nexit code {result.returncode}\n{short_end(result.stdout)}")
    return result.stdout


def short_end(text, most=4000):
    return text if len(text) <= most else "… " + text[-most:]


def built_generator(jobs):
    """Builds eagerx-gen in build-release/, as CMake's preset says."""
    folder = ROOT / "build-release"
    cache = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
    if not (folder / "CMakeCache.txt").exists():
        call(["cmake", "-S", ROOT, "--preset", "release", "-DEAGERX_BUILD_TESTS=OFF", *cache])
    call(["cmake", "--build", folder, "--target", "eagerx-gen", "-j", jobs])
    return folder / "eagerx-gen"


def entity_words(folder):
    """Ids of the entities below a folder, ours and EAGERx's."""
    text = "".join(path.read_text() for path in pathlib.Path(folder).rglob("manifest.yaml"))
    return set(re.findall(r"^id: (\w+)", text, re.MULTILINE)) | set(re.findall(r"[\w.]+/\w+", "".join(re.findall(r"^eagerx: (.*)", text, re.MULTILINE))))


class Builder:
    """Makes programs below `work`; graphs whose code is the same share one."""

    def __init__(self, generator, work, library=(), compiler=None):
        self.generator, self.work = pathlib.Path(generator), pathlib.Path(work)
        self.library = [HERE / "models", *library]
        # More entities, for those who have none of their own for them.
        taken = {word for folder in library for word in entity_words(folder)}
        if not taken & entity_words(HERE / "more_models"):
            self.library.append(HERE / "more_models")
        self.compiler = compiler or os.environ.get("CXX", "c++")
        self.lock = threading.Lock()
        self.shared_lock = threading.Lock()
        self.shared_made = False
        self.programs = {}  # key of the code → lock, program
        self.lost = {}  # folder of generated code → inputs whose processors EAGERx loses
        self.count = 0

    def shared(self):
        """Shared by all programs: the driver, and its headers and the runtime's, compiled once."""
        with self.shared_lock:
            if not self.shared_made:
                header = self.work / "common.hpp"
                includes = sorted((ROOT / "runtime/eagerx").glob("*.hpp"))
                lines = ["driver.hpp", "array", "bit", "cstdint", "limits", "optional"]
                lines += [f"eagerx/{path.name}" for path in includes if path.name not in ("eigen.hpp", "policy.hpp")]
                header.write_text("".join(f"#include <{line}>\n" for line in lines))
                call([self.compiler, *FLAGS, "-x", "c++-header", header, "-o", f"{header}.gch"])
                call([self.compiler, *FLAGS, "-c", HERE / "driver.cpp", "-o", self.work / "driver.o"])
                self.shared_made = True

    def options(self, graph, recording):
        """Settings that a file of Graph.save lacks: the engine and the rates."""
        if recording is None or not re.search(r"^engine_id: null$", graph.read_text(), re.MULTILINE):
            return []
        # A rate of 100/3 Hz is recorded as a double.
        rates = [Fraction(rate).limit_denominator(10**6) for rate in (recording.rate, recording.content["engine"]["rate"])]
        options = ["--rate", rates[0], "--engine-rate", rates[1]]
        engine = recording.nodes.get("engine")
        return options + (["--engine", self.engines()[engine["entity_id"]]] if engine and engine["entity_id"] in self.engines() else [])

    def engines(self):
        """Our names of EAGERx's engines."""
        found = {}
        for folder in [ROOT / "models", *self.library]:
            for manifest in folder.glob("engines/*/manifest.yaml"):
                text = manifest.read_text()
                ids = re.search(r"^eagerx: (.*)", text, re.MULTILINE)
                for theirs in re.findall(r"[\w.]+/\w+", ids[1] if ids else ""):
                    found[theirs] = re.search(r"^id: (\w+)", text, re.MULTILINE)[1]
        return found

    def generate(self, graph, recording=None):
        """The folder with the code of a graph file."""
        with self.lock:
            self.count += 1
            out = self.work / "generated" / str(self.count)
        command = [self.generator, "generate", graph, "-o", out, "--real", "double", *self.options(graph, recording)]
        for folder in self.library:
            command += ["--path", folder]
        command = [str(part) for part in command]
        result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        if result.returncode == 0 and not any(out.glob("*/graph.hpp")):
            # It has parts: this target has the whole graph of it, with the same messages.
            shutil.rmtree(out)
            result = subprocess.run([*command, "--target", "environments"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        if result.returncode == 1:
            raise Refused(re.findall(r"error\[(E\d+)\]", result.stderr), result.stderr)
        if result.returncode:
            raise Failure(f"{' '.join(command)}\nexit code {result.returncode}\n{result.stderr}")
        self.lost[out] = [(node, port) for node, port in re.findall(r"EAGERx loses the processor of `(.+?)\.(\w+)`", result.stderr)]
        return out

    def code_of(self, folder):
        """Generated code. `key`: the same for code that differs in the graph's name alone."""
        header = next(folder.glob("*/graph.hpp"))
        name = header.parent.name
        code = "".join(path.read_text() for path in sorted(header.parent.glob("*.hpp")))
        code = re.sub(rf"\b{name}\b", "graph", re.sub(r"//.*", "", code))
        return Code(folder, name, hashlib.sha256(code.encode()).hexdigest()[:16], len(code))

    def program_of(self, folder):
        """The command that runs generated code, compiled if it is not yet."""
        code = self.code_of(folder)
        with self.lock:
            entry = self.programs.setdefault(code.key, [threading.Lock(), None])
        with entry[0]:
            if entry[1] is None:
                entry[1] = self.build([code])
        return [entry[1], code.key]

    def make(self, folders, jobs=2):
        """Compiles generated code of many graphs, which takes a third of the time of each by itself: what they have in
        common is compiled once a program. At least `jobs` programs, and none with two graphs of one name."""
        codes = {code.key: code for code in map(self.code_of, folders) if code.key not in self.programs}
        batches = [{} for _ in range(jobs)]  # name: code
        for code in sorted(codes.values(), key=lambda code: -code.size):
            fits = [batch for batch in batches if code.name not in batch and len(batch) < MOST_TOGETHER]
            if not fits:
                batches.append({})
            least = min(fits or batches[-1:], key=lambda batch: sum(other.size for other in batch.values()))
            least[code.name] = code
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            list(pool.map(self.build_together, [list(batch.values()) for batch in batches if batch]))

    def build_together(self, codes):
        try:
            program = self.build(codes)
        except Failure:
            if not any(self.fails_alone(code) for code in codes):
                raise  # they do not fit together
            return  # those are reported when they are requested
        for code in codes:
            self.programs[code.key] = [threading.Lock(), program]

    def fails_alone(self, code):
        try:
            self.program_of(code.folder)
        except Failure:
            return True
        return False

    def build(self, codes):
        """One program of graphs, whose first word is the key of the one that it runs."""
        self.shared()
        source = self.work / f"{codes[0].key}.cpp"
        program = source.with_suffix("")
        lines = [f'#include "{code.name}/graph.hpp"' for code in codes]
        lines += ["#include <string_view>", "int main(int, char** words) {", "  const std::string_view key = words[1];"]
        lines += [f'  if (key == "{code.key}") return eagerx::conformance::run<graphs::{code.name}::Graph>();' for code in codes]
        source.write_text("\n".join([*lines, "  return 2;", "}"]) + "\n")
        folders = [f"-I{code.folder}" for code in codes]
        call([self.compiler, *FLAGS, "-include", self.work / "common.hpp", *folders, source, self.work / "driver.o", "-o", program])
        return program
