"""From a graph to its library: runs `eagerx-gen build`, and keeps what it made."""
from __future__ import annotations

import contextlib
import difflib
import fcntl
import hashlib
import json
import os
import pathlib
import reprlib
import shutil
import subprocess
import sys
import tempfile

from . import checks
from .errors import Error
from .library import Library


def eagerx_gen():
    """The program: that of the environment variable EAGERX_GEN, or the one on PATH."""
    program = os.environ.get("EAGERX_GEN") or shutil.which("eagerx-gen")
    if program is None or not (os.path.isfile(program) and os.access(program, os.X_OK)):
        raise Error("there is no program eagerx-gen on PATH: install it, or name it in the environment variable EAGERX_GEN")
    return program


def cache():
    """Where libraries are built: EAGERX_GEN_CACHE, or eagerx-gen in the user's folder of caches."""
    own = os.environ.get("EAGERX_GEN_CACHE")
    if own:
        return pathlib.Path(own).absolute()
    caches = os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache")
    if caches.startswith("~"):
        raise Error("this user has no home folder: name a folder for libraries in the environment variable EAGERX_GEN_CACHE")
    return pathlib.Path(caches).absolute() / "eagerx-gen"


def started(command, **how):
    try:
        return subprocess.Popen(command, **how)
    except OSError as problem:
        raise Error(f"cannot run `{command[0]}`: {problem.strerror}") from problem


def run(command, progress, kept=()):
    """The last line of its output. Progress goes to the standard error as it comes, problems into the exception.

    kept: descriptors that it and what it starts keep open.
    """
    with tempfile.TemporaryFile("w+") as output:
        with started(command, stdout=output, stderr=subprocess.PIPE, text=True, errors="replace", pass_fds=kept) as process:
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
    """Several processes may want the same library at once. Gives the descriptor of the lock, which lasts until it is closed by
    all who have it: a compiler lives on when the process that started it is killed."""
    folder.mkdir(parents=True, exist_ok=True)
    with open(folder / "lock", "a") as lock:
        with contextlib.suppress(OSError):  # some file systems have no locks; there processes at the same time are the user's to avoid
            fcntl.flock(lock, fcntl.LOCK_EX)
        try:
            yield lock.fileno()
        except Exception:
            release(lock)
            raise
        release(lock)  # for all: a process that another thread forked may have it, too


def release(lock):
    with contextlib.suppress(OSError):
        fcntl.flock(lock, fcntl.LOCK_UN)


def made_in(folder, lock, command, progress, ending):
    """Path of the library or program that `command` makes in the folder `source`, under a name of its content."""
    unfinished = folder / "unfinished"
    if unfinished.exists():  # its process was killed, and files may be half written
        shutil.rmtree(folder / "source", ignore_errors=True)
    unfinished.touch()
    try:
        made = pathlib.Path(run(command, progress, (lock,)))
    except Error:
        unfinished.unlink()
        raise
    # A process that has opened a library gets the same one for the same path, whatever is in the file.
    content = hashlib.sha256(made.read_bytes()).hexdigest()[:16]
    library = folder / f"{made.stem}-{content}{ending}"
    if not library.exists():
        part = library.with_suffix(".part")
        with open(part, "wb") as file:
            file.write(made.read_bytes())
            file.flush()
            os.fsync(file.fileno())  # before its name: the machine may stop
        part.chmod(0o755)
        part.rename(library)
        for earlier in folder.glob(f"*{ending}"):
            if earlier != library:
                earlier.unlink()
    unfinished.unlink()
    return library


def options_of(engine, paths, variant=None):
    """Of eagerx-gen."""
    options = ["--engine", engine] if engine else []
    options += ["--variant", variant] if variant else []
    for path in paths:
        options += ["--path", str(pathlib.Path(path).resolve())]
    return options


def is_program(path):
    """Whether it is a program that is built already, or a script that starts one."""
    if path.endswith(".so") or not (os.path.isfile(path) and os.access(path, os.X_OK)):
        return False
    with open(path, "rb") as file:
        return file.read(4).startswith((b"\x7fELF", b"#!"))


def moves_hardware(graph, engine, paths, variant=None):
    """Whether the engine of a graph's file is one of real hardware. False, too, if it cannot be read: its build says why."""
    command = [eagerx_gen(), "info", graph, "--json", *options_of(engine, paths, variant)]
    with started(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, errors="replace") as process:
        said = process.communicate()[0]
    try:
        return bool(json.loads(said)["moves_hardware"])
    except (ValueError, KeyError, TypeError):
        return False


def near_of(path):
    """A suggestion for the name of a missing file, or an empty string."""
    with contextlib.suppress(OSError):
        near = difflib.get_close_matches(path.name, os.listdir(path.parent), 1, 0.8)
        return f"; did you mean {near[0]}?" if near else ""
    return ""


def build(graph, engine=None, paths=(), progress=True, variant=None, *, target="environments", ending=".so", opened=Library):
    """The Library of a graph's file. Only what has changed since the last time is made: of graph, entities, eagerx-gen.

    For another target: what `opened` makes of the path, which ends with `ending`.
    """
    graph = pathlib.Path(graph).resolve()
    if not graph.is_file():
        raise Error(f"there is no file {graph}{near_of(graph)}")
    program = eagerx_gen()
    options = ["--target", target, *options_of(engine, paths, variant)]
    with started([program, "--version"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, errors="replace") as process:
        version = process.communicate()[0]
    key = hashlib.sha256("\0".join([str(graph), version, os.path.realpath(program), *options]).encode(errors="surrogateescape")).hexdigest()[:16]
    folder = cache() / f"{graph.parent.name}-{graph.stem}-{key}"
    try:
        with alone_in(folder) as lock:
            path = made_in(folder, lock, [program, "build", str(graph), "-o", str(folder / "source"), *options], progress,
                           ending)
            return opened(path)  # before another process makes a newer one in its place
    except OSError as problem:
        raise Error(f"cannot write into `{folder}`: {problem.strerror}: name a folder that can be written in the environment "
                    "variable EAGERX_GEN_CACHE") from problem


def checked(graph, engine, paths, variant=None):
    """Path of the graph, and folders, as texts."""
    graph = os.fsdecode(checks.path("the graph", graph))
    for what, name in (("an engine", engine), ("a variant", variant)):
        if name is not None and not (isinstance(name, str) and "\0" not in name):
            raise ValueError(f"{what[2:].strip()} is {reprlib.repr(name)}, no name of {what}")
    if isinstance(paths, (str, bytes, os.PathLike)) or not hasattr(paths, "__iter__"):
        raise ValueError(f"paths is {reprlib.repr(paths)}, no list of folders")
    return graph, [os.fsdecode(checks.path("a folder of `paths`", path)) for path in paths]


@checks.arguments("load", path="paths is a list of folders", variants="variant is the name of one")
def load(graph, engine=None, paths=(), progress=True, variant=None):
    """The Library of a graph's file, or of one that is built already (`*.so`).

    engine    instead of the graph's
    paths     folders of your own entities, as `eagerx-gen --path`
    progress  whether eagerx-gen prints its progress on the standard error
    variant   of the graph's `variants:`
    """
    if isinstance(graph, Library):
        return graph
    graph, paths = checked(graph, engine, paths, variant)
    if not graph.endswith(".so"):
        return build(graph, engine, paths, progress, variant)
    if variant is not None:
        raise ValueError("variant: a library is built already; give the graph's file")
    return Library(graph)
