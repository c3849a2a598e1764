"""Shared by tests of changed cases: the problems of a case, and a folder in which changed ones are checked."""
import json
import os
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]


def options_of(case):
    """The options of a case's first line."""
    first = case.read_bytes().split(b"\n", 1)[0].decode(errors="replace") if case.is_file() else ""
    return first.removeprefix("# options:").split() if first.startswith("# options:") else []


def problems_of(generator, case, options=None):
    """The output of `check` for a case, with these options, or those of its first line."""
    options = options_of(case) if options is None else list(options)
    if "json" in options:
        options = []
    if not any(word.startswith("--diagnostics") for word in options):
        options += ["--diagnostics", "json"]
    made = subprocess.run([generator, "check", case.name, *options], cwd=case.parent,
                          env={**os.environ, "EAGERX_HOME": str(ROOT)}, stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE)
    assert made.stderr.startswith(b"[") or not made.stderr, (case, made.stderr)
    return json.loads(made.stderr or "[]")


def mirror(folder):
    """A folder like the root, where cases can be written and all that lies around them is found by the same paths."""
    for kind in ("diagnostics", "plausibility"):
        place = pathlib.Path(folder)
        for part in ["tests", kind, "cases", None]:
            for entry in (ROOT / place.relative_to(folder)).iterdir():
                if entry.name != part and not (place / entry.name).exists():
                    (place / entry.name).symlink_to(entry)
            if part:
                place = place / part
                if place.is_symlink():
                    place.unlink()
                place.mkdir(exist_ok=True)
    return pathlib.Path(folder)


def own_file(folder, path):
    """The file of this path in a mirror, which can be written: the folders on its way are the mirror's own."""
    place = folder
    for part in path.parts[:-1]:
        place = place / part
        if place.is_symlink():
            original = place.resolve()
            place.unlink()
            place.mkdir()
            for entry in original.iterdir():
                (place / entry.name).symlink_to(entry)
    file = folder / path
    if file.is_symlink():
        file.unlink()
    return file


def all_cases():
    return sorted(ROOT.glob("tests/diagnostics/cases/*.yaml")) + sorted(ROOT.glob("tests/plausibility/cases/*.yaml"))
