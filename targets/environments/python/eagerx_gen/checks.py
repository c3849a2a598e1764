"""What is wrong with what somebody gave, as a ValueError that says it."""
from __future__ import annotations

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


def options(given):
    """Of a reset: a dict."""
    if given is None:
        return {}
    if not hasattr(given, "keys"):
        raise ValueError(f"options is {reprlib.repr(given)}, not a dict")
    return given


class Single:
    """Something with memory of the library, which copies would share: there are none, by copy, deepcopy or pickle."""

    def __reduce_ex__(self, protocol):
        raise Error(f"{type(self).__name__} of a library cannot be copied or pickled: make another one, with the same arguments")
