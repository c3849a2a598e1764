"""The C interface of targets/environments/eagerx_environments.h over numpy arrays."""
from __future__ import annotations

import ctypes
import json
from ctypes import c_char_p, c_int, c_uint32, c_uint64, c_void_p

import numpy as np

from .errors import Error

VERSION = 3
"""Of the C interface."""

MOST_PIXELS = 4096
"""Of a side of a picture."""

AUTORESET = {"next_step": 0, "same_step": 1, "disabled": 2}


class _Options(ctypes.Structure):
    _fields_ = [("size", c_uint32), ("environments", c_uint32), ("numbers", c_void_p), ("seed", c_uint64),
                ("longest", c_uint32), ("autoreset", c_uint32), ("threads", c_uint32), ("pictures", c_uint32)]


class _Rows(ctypes.Structure):
    _fields_ = [("size", c_uint32)] + [(name, c_void_p) for name in (
        "observation", "reward", "terminated", "truncated", "success", "terms", "final_observation")]


_FUNCTIONS = {
    "eagerx_version": (c_uint32, []),
    "eagerx_describe": (c_char_p, []),
    "eagerx_error": (c_char_p, []),
    "eagerx_create": (c_void_p, [c_void_p]),
    "eagerx_destroy": (None, [c_void_p]),
    "eagerx_reset": (c_int, [c_void_p] * 4),
    "eagerx_step": (c_int, [c_void_p] * 3),
    "eagerx_set_states": (c_int, [c_void_p] * 3),
    "eagerx_get_states": (c_int, [c_void_p] * 2),
    "eagerx_trace": (c_int, [c_void_p, c_uint32, c_char_p]),
    "eagerx_hash": (c_uint64, [c_void_p, c_uint32]),
    "eagerx_picture": (c_int, [c_void_p, c_uint32, c_uint32, c_uint32, c_void_p]),
    "eagerx_counts": (c_char_p, [c_void_p]),
    "eagerx_stepping": (c_char_p, [c_void_p]),
}


class Field:
    """An action, observation or state: the columns `first` to `first + size - 1` of a row."""

    def __init__(self, told):
        self.name, self.shape, self.first = told["name"], tuple(told["shape"]), told["first"]
        self.size = int(np.prod(self.shape, dtype=int))
        self.dtype = np.dtype(told["dtype"])
        if self.dtype.kind == "f":
            self.dtype = np.dtype(np.float32)  # as rows are
            lowest, highest = -np.inf, np.inf
        elif self.dtype.kind == "b":
            lowest, highest = False, True
        else:
            lowest, highest = np.iinfo(self.dtype).min, np.iinfo(self.dtype).max
        self.low = self._bound(told["low"], lowest)
        self.high = self._bound(told["high"], highest)
        self.columns = slice(self.first, self.first + self.size)

    def _bound(self, told, otherwise):
        # Whole numbers of 64 bits were told as doubles, whose highest is beyond the type's.
        info = None if self.dtype.kind in "fb" else np.iinfo(self.dtype)
        numbers = [otherwise if x is None else x if info is None else min(max(int(x), info.min), info.max) for x in told]
        return np.array(numbers, self.dtype).reshape(self.shape)


class Library:
    """The library of a graph, as eagerx-gen's target `environments` makes it."""

    def __init__(self, path):
        self.path = str(path)
        try:
            self.c = ctypes.CDLL(self.path)
            version = self.c.eagerx_version()  # first: others have other functions
            if version != VERSION:
                raise Error(f"`{self.path}` has version {version} of the interface, and this package version {VERSION}: "
                            "make it again with the eagerx-gen that this package is from")
            functions = {name: getattr(self.c, name) for name in _FUNCTIONS}
        except (OSError, AttributeError) as problem:
            raise Error(f"`{self.path}` is no library of environments: {problem}") from problem
        for name, (result, arguments) in _FUNCTIONS.items():
            functions[name].restype, functions[name].argtypes = result, arguments
        self.description = json.loads(self.c.eagerx_describe())
        self.observations = [Field(told) for told in self.description["observations"]]
        self.actions = [Field(told) for told in self.description["actions"]]
        self.states = [Field(told) for told in self.description["states"]]
        self.terms = self.description["task"]["terms"] if self.description["task"] else []

    @property
    def has_task(self):
        return self.description["task"] is not None

    @property
    def metadata(self):
        """Of Gymnasium: how environments of this graph can be seen."""
        render = self.description["render"]
        return {"render_modes": ["rgb_array"], "render_fps": render["rate_hz"]} if render else {"render_modes": []}

    def check_render_mode(self, render_mode):
        if render_mode not in (None, *self.metadata["render_modes"]):
            known = "None or 'rgb_array'" if self.description["render"] else (
                "None, because its graph has no `render:`; add `render: {source: OBJECT.scene}` to it for 'rgb_array'")
            raise ValueError(f"render_mode is {render_mode!r}; for {self.description['graph']} it is {known}")

    def __repr__(self):
        return f"<eagerx_gen.Library {self.description['graph']} on {self.description['engine']}>"


def numbers_of(fields):
    return sum(field.size for field in fields)


class Environments:
    """`count` environments and their rows, which every step writes over.

    action             [count, numbers of an action] float32, read by step()
    observation        [count, numbers of an observation] float32
    final_observation  the same: rows whose episode ended, with autoreset "same_step"
    reward             [count] float32
    terminated, truncated, success    [count] bool
    terms              [count, terms of the reward] float32, weighted

    seed, longest, threads: as in eagerx_environments.h. numbers: [count] of each in its seed, or None: 0, 1, 2, ...
    pictures: whether picture() will be called; environments then run one by one.
    """

    def __init__(self, library, count, *, seed=0, numbers=None, longest=0, autoreset="next_step", threads=0, pictures=False):
        self._handle = None
        if autoreset not in AUTORESET:
            raise ValueError(f"autoreset is {autoreset!r}; it is one of {', '.join(AUTORESET)}")
        for name, value, least in (("count", count, 1), ("longest", longest, 0), ("threads", threads, 0)):
            if not least <= value < 2**32:
                raise ValueError(f"{name} is {value}")
        self.library, self.count, self.autoreset = library, int(count), autoreset
        if numbers is not None:
            numbers = np.ascontiguousarray(numbers, np.uint32)
            if numbers.shape != (count,):
                raise ValueError(f"numbers has shape {numbers.shape}, not {(count,)}")
        options = _Options(ctypes.sizeof(_Options), count, None if numbers is None else numbers.ctypes.data, seed % 2**64,
                           longest, AUTORESET[autoreset], threads, int(bool(pictures)))
        # First, because it says which counts there cannot be.
        self._handle = library.c.eagerx_create(ctypes.byref(options))
        if not self._handle:
            self._fail()
        rows = {
            "observation": np.zeros((count, numbers_of(library.observations)), np.float32),
            "reward": np.zeros(count, np.float32),
            "terminated": np.zeros(count, np.bool_),
            "truncated": np.zeros(count, np.bool_),
            "success": np.zeros(count, np.bool_),
            "terms": np.zeros((count, len(library.terms)), np.float32),
            "final_observation": np.zeros((count, numbers_of(library.observations)), np.float32),
        }
        vars(self).update(rows)
        self.action = np.zeros((count, numbers_of(library.actions)), np.float32)
        # Addresses are taken once, so that a step is one call.
        self._rows = _Rows(ctypes.sizeof(_Rows), *(row.ctypes.data for row in rows.values()))
        self._step = library.c.eagerx_step
        self._arguments = (self._handle, self.action.ctypes.data, ctypes.addressof(self._rows))

    def _fail(self):
        raise Error(self.library.c.eagerx_error().decode())

    def _open(self):
        if self._handle is None:
            raise Error("these environments are closed")
        return self._handle

    def _mask(self, mask):
        if mask is None:
            return None
        mask = np.ascontiguousarray(mask, np.uint8)
        if mask.shape != (self.count,):
            raise ValueError(f"the mask has shape {mask.shape}, not {(self.count,)}")
        return mask

    def reset(self, mask=None, seeds=None):
        """Begins episodes, where `mask` is true. seeds: [count], from whose episode 0 they begin; None: the next episode."""
        mask = self._mask(mask)
        if seeds is not None:
            seeds = np.ascontiguousarray(seeds, np.uint64)
            if seeds.shape != (self.count,):
                raise ValueError(f"seeds has shape {seeds.shape}, not {(self.count,)}")
        if self.library.c.eagerx_reset(self._open(), None if mask is None else mask.ctypes.data,
                                       None if seeds is None else seeds.ctypes.data, self.observation.ctypes.data) != 0:
            self._fail()

    def step(self):
        """One step with `action`. Error if a reward is not finite: which term, where and when.

        That step is made and its rows are there: who wants to go on catches it. counts() has how often.
        """
        if self._handle is None or self._step(*self._arguments) != 0:
            self._open()
            self._fail()

    def set_states(self, states, mask=None):
        """The states of the next episode: {name: value or [count, ...]}; what is not named is drawn."""
        known = {field.name: field for field in self.library.states}
        row = np.full((self.count, numbers_of(self.library.states)), np.nan, np.float32)
        for name, value in states.items():
            if name not in known:
                raise ValueError(f"there is no state {name!r}, but {', '.join(known) or 'none'}")
            field = known[name]
            try:
                row[:, field.columns] = np.broadcast_to(np.asarray(value, np.float32), (self.count, *field.shape)).reshape(self.count, -1)
            except ValueError:
                raise ValueError(f"{name!r} has shape {np.shape(value)}, not {field.shape} or {(self.count, *field.shape)}") from None
        mask = self._mask(mask)
        if self.library.c.eagerx_set_states(self._open(), None if mask is None else mask.ctypes.data, row.ctypes.data) != 0:
            self._fail()

    def states(self):
        """{name: [count, ...]} that the episodes began with; NaN where nothing was set or drawn."""
        row = np.zeros((self.count, numbers_of(self.library.states)), np.float32)
        if self.library.c.eagerx_get_states(self._open(), row.ctypes.data) != 0:
            self._fail()
        return {field.name: row[:, field.columns].reshape(self.count, *field.shape) for field in self.library.states}

    def trace(self, environment, path):
        """From its next reset on, messages of an environment go to a file for `eagerx-gen replay`; None ends it."""
        if not 0 <= environment < self.count:
            raise ValueError(f"there is no environment {environment}, but 0 to {self.count - 1}")
        if self.library.c.eagerx_trace(self._open(), environment, None if path is None else str(path).encode()) != 0:
            self._fail()

    def hash(self, environment):
        """Of all messages of an environment since its trace began; 0 without one."""
        return self.library.c.eagerx_hash(self._open(), environment)

    def picture(self, environment, size=(480, 480)):
        """uint8 [height, width, 3] of size (width, height): what the graph's `render:` showed last; white before that."""
        if not 0 <= environment < self.count:
            raise ValueError(f"there is no environment {environment}, but 0 to {self.count - 1}")
        width, height = (int(side) for side in size)
        if not (0 < width <= MOST_PIXELS and 0 < height <= MOST_PIXELS):
            raise ValueError(f"size is {size}: width and height are 1 to {MOST_PIXELS} pixels")
        pixels = np.empty((height, width, 3), np.uint8)
        if self.library.c.eagerx_picture(self._open(), environment, width, height, pixels.ctypes.data) != 0:
            self._fail()
        return pixels

    def stepping(self):
        """How they are stepped, and what made that slower: "in packs of 64 (avx512)", "one by one: …"."""
        text = self.library.c.eagerx_stepping(self._open())
        if text is None:
            self._fail()
        return text.decode()

    def counts(self):
        """What guards and nodes have counted: {"safe: action not finite: voltage": 3}; and {"not finite: task.angle": 12} steps."""
        text = self.library.c.eagerx_counts(self._open())
        if text is None:
            self._fail()
        return json.loads(text)

    def close(self):
        if self._handle:
            self.library.c.eagerx_destroy(self._handle)
        self._handle = None

    def __del__(self):
        self.close()
