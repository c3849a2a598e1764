"""From a graph to its library: runs `eagerx-gen build`, and keeps what it made."""
from __future__ import annotations

import contextlib
import fcntl
import hashlib
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

from .errors import Error
from .library import Library


def eagerx_gen():
    """The program: that of the environment variable EAGERX_GEN, or the one on PATH."""
    program = os.environ.get("EAGERX_GEN") or shutil.which("eagerx-gen")
    if program is None or not os.access(program, os.X_OK):
        raise Error("there is no program eagerx-gen on PATH: install it, or name it in the environment variable EAGERX_GEN")
    return program


def cache():
    """Where libraries are built: EAGERX_GEN_CACHE, or eagerx-gen in the user's folder of caches."""
    own = os.environ.get("EAGERX_GEN_CACHE")
    if own:
        return pathlib.Path(own)
    return pathlib.Path(os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache") / "eagerx-gen"


def run(command, progress):
    """The last line of its output. Progress goes to the standard error as it comes, problems into the exception."""
    with tempfile.TemporaryFile("w+") as output:
        with subprocess.Popen(command, stdout=output, stderr=subprocess.PIPE, text=True, errors="replace") as process:
            said = ""
            for piece in iter(lambda: process.stderr.read(1), ""):
                said += piece
                if progress:
                    sys.stderr.write(piece)
                    sys.stderr.flush()
        if process.returncode != 0:
            raise Error(said.strip() or f"{command[0]} ended with exit code {process.returncode}")
        output.seek(0)
        return output.read().strip().rpartition("\n")[2]


@contextlib.contextmanager
def alone_in(folder):
    """Several processes may want the same library at once."""
    folder.mkdir(parents=True, exist_ok=True)
    with open(folder / "lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield


def build(graph, engine=None, paths=(), progress=True):
    """Path of the library of a graph. Only what has changed since the last time is made: of graph, entities, eagerx-gen."""
    graph = pathlib.Path(graph).resolve()
    if not graph.is_file():
        raise Error(f"there is no file {graph}")
    program = eagerx_gen()
    options = ["--target", "environments", *(["--engine", engine] if engine else [])]
    for path in paths:
        options += ["--path", str(pathlib.Path(path).resolve())]
    version = subprocess.run([program, "--version"], capture_output=True, text=True, check=False).stdout
    key = hashlib.sha256("\0".join([str(graph), version, os.path.realpath(program), *options]).encode()).hexdigest()[:16]
    folder = cache() / f"{graph.parent.name}-{graph.stem}-{key}"
    with alone_in(folder):
        made = pathlib.Path(run([program, "build", str(graph), "-o", str(folder / "source"), *options], progress))
        # A process that has opened a library gets the same one for the same path, whatever is in the file.
        content = hashlib.sha256(made.read_bytes()).hexdigest()[:16]
        library = folder / f"{made.stem}-{content}.so"
        if not library.exists():
            part = library.with_suffix(".part")
            shutil.copyfile(made, part)
            part.rename(library)
            for earlier in folder.glob("*.so"):
                if earlier != library:
                    earlier.unlink()
    return library


def load(graph, engine=None, paths=(), progress=True):
    """The Library of a graph's file, or of one that is built already (`*.so`).

    engine    in place of the graph's
    paths     folders of entities of one's own, as `eagerx-gen --path`
    progress  whether eagerx-gen tells on the standard error how far it is
    """
    if isinstance(graph, Library):
        return graph
    return Library(graph if str(graph).endswith(".so") else build(graph, engine, paths, progress))
