"""Checks of arguments, which raise a ValueError with the reason."""
from __future__ import annotations

import difflib
import functools
import inspect
import operator
import os
import reprlib

import numpy as np

from .errors import Error


def whole(name, value, least, most):
    """A whole number, of any type that is one."""
    try:
        number = None if isinstance(value, (bool, np.bool_)) else operator.index(value)
    except TypeError:
        number = None
    if number is None:
        raise ValueError(f"{name} is {reprlib.repr(value)}, no whole number")
    if not least <= number <= most:
        raise ValueError(f"{name} is {reprlib.repr(number)}, not {least} to {most}")
    return number


def whole_numbers(name, values, count, dtype):
    """[count] of a type without signs."""
    most = int(np.iinfo(dtype).max)
    if not isinstance(values, np.ndarray):
        try:
            values = list(values)
        except TypeError:
            raise ValueError(f"{name} is {reprlib.repr(values)}, not {count} whole numbers") from None
    shape = values.shape if isinstance(values, np.ndarray) else (len(values),)
    if shape != (count,):
        raise ValueError(f"{name} has shape {shape}, not {(count,)}")
    if isinstance(values, np.ndarray) and values.dtype.kind in "iu" and int(values.min()) >= 0 and int(values.max()) <= most:
        return np.ascontiguousarray(values, dtype)
    return np.array([whole(f"{name}[{i}]", value, 0, most) for i, value in enumerate(values)], dtype)


def numbers(name, values):
    """An array of what can be a float32."""
    array = np.asarray(values)
    if array.dtype.kind not in "fiub":
        raise ValueError(f"{name} is {reprlib.repr(values)}, no numbers")
    return array


def mask(values, count):
    """[count] bool; None: all."""
    if values is None:
        return None
    array = np.asarray(values)
    if array.dtype != np.bool_ or array.shape != (count,):
        raise ValueError(f"the mask is {reprlib.repr(values)} of type {array.dtype} and shape {array.shape}, not {count} bool")
    return np.ascontiguousarray(array)


def path(name, value):
    """As the system takes it."""
    try:
        encoded = os.fsencode(value)
    except TypeError:
        raise ValueError(f"{name} is {reprlib.repr(value)}, no path") from None
    if b"\0" in encoded:
        raise ValueError(f"{name} is {reprlib.repr(value)}, which has a NUL in it")
    return encoded


def stage(name, known):
    """One of the names of stages; None and "" are the graph as it is written."""
    if name is None or name == "":
        return ""
    if not isinstance(name, str) or name not in known:
        raise ValueError(f"there is no stage {reprlib.repr(name)}, but " + (", ".join(known) or "none: the task has no `stages:`"))
    return name


def options(given, known):
    """Of a reset: a dict with keys of `known`."""
    if given is None:
        return {}
    if not hasattr(given, "keys"):
        raise ValueError(f"options is {reprlib.repr(given)}, not a dict")
    for key in given.keys():
        if not (isinstance(key, str) and key in known):
            raise ValueError(f"options: there is no {reprlib.repr(key)}; {_meant(key, known)}it has {', '.join(map(repr, known))}")
    return given


def _meant(name, known):
    near = difflib.get_close_matches(str(name), known, 1) if isinstance(name, str) else ()
    return f"did you mean {near[0]!r}? " if near else ""


def keywords(what, given, kind, others=(), instead=None):
    """A TypeError for a keyword that neither `kind` nor `others` take; `instead`: what to write for some."""
    own = [name for name, parameter in inspect.signature(kind).parameters.items() if parameter.kind is parameter.KEYWORD_ONLY]
    refuse_others(what, given, [*own, *others], instead or {})


def refuse_others(what, given, known, instead):
    for name in given:
        if name not in known:
            hint = instead.get(name) or f"{_meant(name, known)}it has {', '.join(known)}"
            raise TypeError(f"{what}() has no argument {name!r}: {hint}")


OPTIONS = {"states": "give options={'states': {…}}", "stage": "give options={'stage': …}", "option": "did you mean 'options'?"}
"""Replacements for keywords of reset() that belong into its options."""


def arguments(what, **instead):
    """A decorator: a keyword that the function `what` does not take is a TypeError that names what it takes. `instead`: what to
    write for some."""
    def of(function):
        known = [name for name, parameter in inspect.signature(function).parameters.items() if name != "self"]

        @functools.wraps(function)
        def checked(*given, **keywords):
            refuse_others(what, keywords, known, instead)
            return function(*given, **keywords)

        return checked

    return of


class Single:
    """Something with memory of the library, which copies would share: there are none, by copy, deepcopy or pickle."""

    def __reduce_ex__(self, protocol):
        raise Error(f"{type(self).__name__} of a library cannot be copied or pickled: make another one, with the same arguments")
